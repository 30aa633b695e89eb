//! Text to text: what fixes and renumbering make of a file.

#[cfg(feature = "lsp")]
pub(crate) mod edit_texts;
mod fix;
#[cfg(feature = "lsp")]
pub(crate) mod line_length;
#[cfg(feature = "lsp")]
pub(crate) mod renumber;

pub use fix::{Fixed, apply_fixes, compatible_edits};
