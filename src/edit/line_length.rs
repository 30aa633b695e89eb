//! Whether an edit makes a line longer than the control reads (LEX-7).

use crate::sure::small;
use crate::syntax::ParsedFile;
use crate::text::Span;

/// Most characters of a line.
const LINE: u32 = 80;

/// The first line, from 1, that gets longer than 80 characters by edits in the order of the text: each replaces a span
/// by so many ASCII characters. A line that is too long already has its finding.
pub(crate) fn first_long_line(file: &ParsedFile, edits: impl Iterator<Item = (Span, usize)>) -> Option<u32> {
    let lines = file.source.lines();
    let mut hint = 0;
    let with_lines = edits.map(|(span, new)| {
        hint = lines.line_near(span.start, hint);
        let grown = i64::try_from(new).unwrap_or(0) - i64::from(span.len());
        (hint, grown)
    });
    let mut with_lines = with_lines.peekable();
    while let Some((line, mut grown)) = with_lines.next() {
        while let Some((_, more)) = with_lines.next_if(|(next, _)| *next == line) {
            grown += more;
        }
        let Ok(grown @ 1..) = u32::try_from(grown) else { continue };
        let span = file.source.line_span(line);
        if span.len() + grown <= LINE {
            continue;
        }
        let length = small(file.source.slice(span).chars().count());
        if length <= LINE && length + grown > LINE {
            return Some(small(line + 1));
        }
    }
    None
}
