//! Text to text: what fixes, formatting and renumbering make of a file.

mod alone;
#[cfg(feature = "lsp")]
pub(crate) mod edit_texts;
mod fix;
pub(crate) mod format;
#[cfg(feature = "lsp")]
pub(crate) mod line_length;
mod output;
#[cfg(feature = "lsp")]
pub(crate) mod renumber;
mod splice;

pub use fix::{Fixed, apply_fixes, compatible_edits};
pub use format::{Formatted, format};
