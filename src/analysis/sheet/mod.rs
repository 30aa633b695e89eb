//! The set-up sheet of a program: what the machine, the tools and the work must be like before it is started.

mod block_name;
mod document;
mod extents;
mod json;
mod reader;
mod render;
mod words;

pub use block_name::BlockName;
pub use document::{Document, document};
pub use extents::{Extents, MOST_BLOCKS, Reach, Size};
pub use json::{SCHEMA, json, schema};
pub use reader::{Head, MUse, ParameterUse, Path, Sheet, SheetReader, ToolUse, UnitUse};
pub use render::{html, markdown, text};
