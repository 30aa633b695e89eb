//! Text to text: what fixes and renumbering make of a file.

pub(crate) mod edit_texts;
mod fix;
pub(crate) mod line_length;
pub(crate) mod renumber;

pub use fix::{Fixed, apply_fixes, compatible_edits};
