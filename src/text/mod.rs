//! Source text: bytes decoded once, places in them, and the way back to the bytes.
//!
//! Every later stage works on UTF-8 text and [`Span`]s of it. Lines, columns and offsets in the file's own bytes are
//! worked out only for what is shown.

mod columns;
mod encoding;
mod last_places;
mod lines;
mod loader;
mod path;
mod source;
mod sources;
mod span;
mod terminal;

pub use columns::ColumnUnit;
pub use encoding::Encoding;
pub use last_places::LastPlaces;
pub use lines::{LineColumn, LineIndex};
pub use loader::{BrokenLink, Loader, MemoryLoader, NotUtf8, Numbered, Overlay, begins_program};
pub use path::{has_way_back, last_name, path_name, way_back, without_ways_back};
pub use source::{DecodeError, FileId, Location, SourceText};
pub use sources::Sources;
pub use span::Span;
pub(crate) use terminal::{is_unsafe, write_json_safe};
