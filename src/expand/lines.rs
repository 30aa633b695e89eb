//! Lines and columns of blocks for records, quick because execution mostly moves on.

use std::collections::BTreeMap;

use crate::resolve::FileIndex;
use crate::syntax::{BlockId, ParsedFile};
use crate::text::LineColumn;

/// Remembers the line of the last block of each file.
#[derive(Debug, Default)]
pub(super) struct Lines {
    hints: BTreeMap<FileIndex, usize>,
}

impl Lines {
    /// Where the `N` of a block stands.
    pub(super) fn of(&mut self, index: FileIndex, file: &ParsedFile, block: BlockId) -> LineColumn {
        let offset = file.n_word(block).map_or(0, |word| word.start());
        let hint = self.hints.entry(index).or_default();
        *hint = file.source.lines().line_near(offset, *hint);
        file.source.column_in(*hint, offset)
    }
}
