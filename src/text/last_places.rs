//! Lines and columns of blocks for records, quick because execution mostly moves on.

use crate::syntax::{BlockId, ParsedFile};
use crate::text::{FileId, LineColumn, Span};

/// Where the last block of a file stood.
#[derive(Clone, Copy, Debug)]
struct Last {
    offset: u32,
    place: LineColumn,
}

/// Remembers the place of the last block of each file: a line may hold any number of blocks, and counting its
/// characters from its begin for each of them takes long.
#[derive(Debug, Default)]
pub(super) struct Lines {
    /// By file.
    last: Vec<Option<Last>>,
}

impl Lines {
    /// Where the `N` of a block stands.
    pub(super) fn of(&mut self, index: FileId, file: &ParsedFile, block: BlockId) -> LineColumn {
        let offset = file.n_word(block).map_or(0, |word| word.start());
        if self.last.len() <= index.0 as usize {
            self.last.resize(index.0 as usize + 1, None);
        }
        let last = self.last.get(index.0 as usize).copied().flatten();
        let hint = last.map_or(0, |last| last.place.line.saturating_sub(1) as usize);
        let lines = file.source.lines();
        let line = lines.line_near(offset, hint);
        let from_start = offset.saturating_sub(lines.start(line).unwrap_or(0));
        let near = last.filter(|last| line == hint && last.offset.abs_diff(offset) < from_start);
        let place = match near {
            Some(Last { offset: from, place }) => {
                let between = file.source.slice(Span::new(from.min(offset), from.max(offset))).chars().count();
                let between = u32::try_from(between).unwrap_or(u32::MAX);
                let column = if from <= offset {
                    place.column.saturating_add(between)
                } else {
                    place.column.saturating_sub(between)
                };
                LineColumn { line: place.line, column }
            }
            None => file.source.column_in(line, offset),
        };
        if let Some(slot) = self.last.get_mut(index.0 as usize) {
            *slot = Some(Last { offset, place });
        }
        place
    }
}
