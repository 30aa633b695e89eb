//! Lines and columns of places in files, quick because readers mostly move on.

use super::{FileId, LineColumn, SourceText, Span};
use crate::sure::small;

/// Where the last place of a file was.
#[derive(Clone, Copy, Debug)]
struct Last {
    offset: u32,
    place: LineColumn,
}

/// Remembers the last place of each file: a line may hold any number of blocks, and counting its characters from the
/// start for each of them takes long.
#[derive(Debug, Default)]
pub struct LastPlaces {
    /// By file.
    last: Vec<Option<Last>>,
}

impl LastPlaces {
    /// Line and column of a place in that file.
    pub fn of(&mut self, file: FileId, source: &SourceText, offset: u32) -> LineColumn {
        if self.last.len() <= file.0 as usize {
            self.last.resize(file.0 as usize + 1, None);
        }
        let last = self.last.get(file.0 as usize).copied().flatten();
        let hint = last.map_or(0, |last| last.place.line.saturating_sub(1) as usize);
        let lines = source.lines();
        let line = lines.line_near(offset, hint);
        let from_start = offset.saturating_sub(lines.start(line).unwrap_or(0));
        let near = last.filter(|last| line == hint && last.offset.abs_diff(offset) < from_start);
        let place = match near {
            Some(Last { offset: from, place }) => {
                let between = source.slice(Span::new(from.min(offset), from.max(offset))).chars().count();
                let column = if from <= offset {
                    place.column.saturating_add(small(between))
                } else {
                    place.column.saturating_sub(small(between))
                };
                LineColumn { line: place.line, column }
            }
            None => source.column_in(line, offset),
        };
        if let Some(slot) = self.last.get_mut(file.0 as usize) {
            *slot = Some(Last { offset, place });
        }
        place
    }
}
