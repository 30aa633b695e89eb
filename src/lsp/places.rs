//! Places as the client counts them.

use gen_lsp_types::{Location as LspLocation, Position, Range};

use super::files::EditorFiles;
use crate::sure::small;
use crate::text::{ColumnUnit, Location, SourceText, Sources, Span};

/// Offsets of one text as positions. Places asked for in the order of the text are quick, also within a very long line.
#[derive(Debug)]
pub(super) struct Places<'a> {
    source: &'a SourceText,
    unit: ColumnUnit,
    /// The last offset in its line, and its column.
    last: Option<(usize, u32, u32)>,
}

impl<'a> Places<'a> {
    pub(super) fn new(source: &'a SourceText, unit: ColumnUnit) -> Self {
        Self { source, unit, last: None }
    }

    /// The position of `offset`.
    pub(super) fn position(&mut self, offset: u32) -> Position {
        let line = self.source.lines().line_at(offset);
        let column = match self.last {
            Some((last_line, last, column)) if last_line == line && last <= offset => {
                column.saturating_add(self.unit.count(self.source.slice(Span::new(last, offset))))
            }
            _ => self.source.position_of(offset, self.unit).1,
        };
        self.last = Some((line, offset, column));
        Position { line: small(line), character: column }
    }

    /// The range of `span`.
    pub(super) fn range(&mut self, span: Span) -> Range {
        Range { start: self.position(span.start), end: self.position(span.end) }
    }
}

/// The offset of a position of the client.
pub(super) fn offset(source: &SourceText, position: Position, unit: ColumnUnit) -> u32 {
    source.offset_at(position.line as usize, position.character, unit)
}

/// The span of a range of the client; empty when its end is before its start.
pub(super) fn span(source: &SourceText, range: Range, unit: ColumnUnit) -> Span {
    let start = offset(source, range.start, unit);
    Span::new(start, offset(source, range.end, unit).max(start))
}

/// A place of a run for the client; `None` for a file that has no URI.
pub(super) fn location(files: &EditorFiles, sources: &Sources, at: Location, unit: ColumnUnit) -> Option<LspLocation> {
    let source = sources.get(at.file)?;
    let uri = files.uri_of(std::path::Path::new(source.name()))?;
    Some(LspLocation { uri, range: Places::new(source, unit).range(at.span) })
}
