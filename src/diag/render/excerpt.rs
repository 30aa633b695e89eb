//! The lines of a program that a finding shows, made fit for a terminal.
//!
//! An excerpt is a small text: only the lines that have marks, each character on which a terminal might act
//! replaced by one visible character, endless lines cut around the marks. Characters match one to one, so
//! that a column of the excerpt leads back to the column of the program.

use std::ops::Range;

use super::places::Places;
use crate::sure::small;
use crate::text::{FileId, LineColumn, Location, SourceText, Span, is_unsafe};

/// The longest line shown whole, in bytes.
const WHOLE_LINE: usize = 160;
/// Characters shown on each side of a mark in a line that is cut.
const AROUND: usize = 30;
/// Most characters of a mark shown in a line that is cut.
const LONGEST_MARK: usize = 60;

/// Lines of one file, and the places of the marks in them.
pub(super) struct Excerpt {
    /// The lines, each with its line end.
    pub text: String,
    /// Their numbers in the file, from 1; `None` for an empty line in place of omitted lines.
    pub numbers: Vec<Option<u32>>,
    /// Where each mark is in [`Self::text`], in characters; never empty, never across a line end.
    pub marks: Vec<Range<usize>>,
    /// Where each mark is in the file.
    pub places: Vec<LineColumn>,
}

impl Excerpt {
    /// The excerpt of `file` that shows `spans`, each from its start to the end of its line at most.
    pub fn new(places: &Places<'_>, file: FileId, spans: &[Span]) -> Self {
        let mut excerpt = Self {
            text: String::new(),
            numbers: Vec::new(),
            marks: vec![0..0; spans.len()],
            places: spans.iter().map(|&span| places.start(Location { file, span })).collect(),
        };
        let Some(source) = places.source(file) else {
            return excerpt;
        };
        let mut lines: Vec<usize> = spans.iter().map(|span| source.lines().line_at(span.start)).collect();
        lines.sort_unstable();
        lines.dedup();
        let mut written = 0;
        let mut before = None;
        for line in lines {
            if before.is_some_and(|before| line > before + 1) {
                excerpt.text.push('\n');
                excerpt.numbers.push(None);
                written += 1;
            }
            before = Some(line);
            written += excerpt.push_line(source, line, spans, written);
        }
        excerpt
    }

    /// Appends a line with its marks after `written` characters; how many it adds.
    fn push_line(&mut self, source: &SourceText, line: usize, spans: &[Span], written: usize) -> usize {
        let whole = source.line_span(line);
        let on_line: Vec<(usize, Span)> = spans
            .iter()
            .enumerate()
            .filter(|(_, span)| source.lines().line_at(span.start) == line)
            .map(|(index, span)| {
                let start = span.start.clamp(whole.start, whole.end);
                (index, Span::new(start, span.end.clamp(start, whole.end)))
            })
            .collect();
        let pieces = if whole.len() as usize <= WHOLE_LINE {
            vec![whole]
        } else {
            cut(source, whole, on_line.iter().map(|&(_, span)| span))
        };
        let mut shown = Shown { text: &mut self.text, written };
        let mut at = whole.start;
        for piece in pieces {
            if piece.start > at {
                shown.push('…');
            }
            at = piece.end;
            let first = shown.written;
            let text = source.slice(piece);
            let column = |offset: u32| first + source.slice(Span::new(piece.start, offset)).chars().count();
            for &(index, span) in &on_line {
                if piece.start <= span.start && span.start <= piece.end {
                    let start = column(span.start);
                    // A mark that goes on in what is cut off covers the ellipsis, an empty one the next character.
                    let end = if span.end > piece.end { column(piece.end) + 1 } else { column(span.end) };
                    if let Some(mark) = self.marks.get_mut(index) {
                        *mark = start..end.max(start + 1);
                    }
                }
            }
            text.chars().for_each(|character| shown.push(visible(character)));
        }
        if at < whole.end {
            shown.push('…');
        }
        // A mark may be behind the last character.
        shown.push(' ');
        shown.push('\n');
        let added = shown.written - written;
        self.numbers.push(Some(small(line).saturating_add(1)));
        added
    }
}

/// A text with its length in characters.
struct Shown<'a> {
    text: &'a mut String,
    written: usize,
}

impl Shown<'_> {
    fn push(&mut self, character: char) {
        self.text.push(character);
        self.written += 1;
    }
}

/// The parts of a long line that are shown, in order: what stands around each mark.
fn cut(source: &SourceText, whole: Span, marks: impl Iterator<Item = Span>) -> Vec<Span> {
    let mut pieces: Vec<Span> = marks
        .map(|mark| {
            let end = mark.end.min(ahead(source, mark.start, whole.end, LONGEST_MARK));
            Span::new(back(source, whole.start, mark.start), ahead(source, end, whole.end, AROUND))
        })
        .collect();
    pieces.sort_unstable();
    let mut apart: Vec<Span> = Vec::new();
    for piece in pieces {
        match apart.last_mut() {
            Some(last) if piece.start <= last.end => last.end = last.end.max(piece.end),
            _ => apart.push(piece),
        }
    }
    apart
}

/// [`AROUND`] characters before `offset`, not before `first`.
fn back(source: &SourceText, first: u32, offset: u32) -> u32 {
    // Four bytes hold any character, so only that much is looked at.
    let near = boundary(source, offset.saturating_sub(4 * (AROUND as u32)).max(first));
    let before = source.slice(Span::new(near, offset));
    before.char_indices().rev().nth(AROUND - 1).map_or(near, |(at, _)| near + at as u32)
}

/// `count` characters after `offset`, not after `last`.
fn ahead(source: &SourceText, offset: u32, last: u32, count: usize) -> u32 {
    let after = source.slice(Span::new(offset, last));
    after.char_indices().nth(count).map_or(last, |(at, _)| offset + at as u32)
}

/// The first place from `offset` on where a character begins.
fn boundary(source: &SourceText, mut offset: u32) -> u32 {
    while !source.text().is_char_boundary(offset as usize) {
        offset += 1;
    }
    offset
}

/// One character that shows `character` and that no terminal acts on: the picture of a control character, a blank for a
/// tab, the replacement character for the rest.
fn visible(character: char) -> char {
    match character {
        '\t' => ' ',
        '\0'..='\u{1f}' => char::from_u32(0x2400 + u32::from(character)).unwrap_or('\u{fffd}'),
        '\u{7f}' => '\u{2421}',
        _ if is_unsafe(character) => '\u{fffd}',
        _ if character.is_whitespace() => ' ',
        _ => character,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Sources;

    /// Text, line numbers, marked texts, places.
    type Parts = (String, Vec<Option<u32>>, Vec<String>, Vec<(u32, u32)>);

    fn excerpt(text: &str, spans: &[Span]) -> Parts {
        let mut sources = Sources::new();
        let file = sources.add(SourceText::from_text("a.nc", text));
        let Excerpt { text, numbers, marks, places } = Excerpt::new(&Places::new(&sources), file, spans);
        let characters: Vec<char> = text.chars().collect();
        let marked = marks.into_iter().map(|mark| characters[mark].iter().collect()).collect();
        (text, numbers, marked, places.iter().map(|place| (place.line, place.column)).collect())
    }

    fn find(text: &str, what: &str) -> Span {
        let start = u32::try_from(text.find(what).unwrap()).unwrap();
        Span::new(start, start + u32::try_from(what.len()).unwrap())
    }

    #[test]
    fn only_the_lines_with_marks() {
        let text = "%1\nN10 X1\rN20 X2\r\nN30\nN40 Y5";
        let (shown, numbers, marked, places) = excerpt(text, &[find(text, "Y5"), find(text, "X1"), find(text, "X2")]);
        assert_eq!(shown, "N10 X1 \nN20 X2 \n\nN40 Y5 \n");
        assert_eq!(numbers, [Some(2), Some(3), None, Some(5)]);
        assert_eq!(marked, ["Y5", "X1", "X2"]);
        assert_eq!(places, [(5, 5), (2, 5), (3, 5)]);
    }

    #[test]
    fn what_a_terminal_acts_on_is_replaced_one_to_one() {
        let text = "N1\t\u{1b}[2J\u{7f}\u{85}\u{b}\u{c}\u{2028}\u{202e}\u{61c}\u{3000}日 X5";
        let (shown, numbers, marked, places) = excerpt(text, &[find(text, "X5")]);
        assert_eq!(shown, "N1 ␛[2J␡\u{fffd}␋␌\u{fffd}\u{fffd}\u{fffd} 日 X5 \n");
        assert_eq!((numbers, marked), (vec![Some(1)], vec!["X5".to_owned()]));
        assert_eq!(places, [(1, 18)]);
    }

    #[test]
    fn empty_marks_cover_one_character() {
        let text = "N1 X5\r\n";
        let (_, numbers, marked, places) = excerpt(text, &[Span::empty(3), Span::empty(5), Span::empty(7)]);
        assert_eq!(numbers, [Some(1), Some(2)]);
        assert_eq!(marked, ["X", " ", " "]);
        assert_eq!(places, [(1, 4), (1, 6), (2, 1)]);
    }

    #[test]
    fn a_mark_ends_with_its_line() {
        let text = "N1 X\n5 Y6";
        assert_eq!(excerpt(text, &[Span::new(3, 6)]).2, ["X"]);
    }

    #[test]
    fn long_lines_are_cut_around_the_marks() {
        let text = format!("%1\n{} X7 {} Y8 {}", "ř".repeat(5_000_000), "z".repeat(300), "日".repeat(1000));
        let (shown, _, marked, places) = excerpt(&text, &[find(&text, "Y8"), find(&text, "X7")]);
        let (around, wide) = ("z".repeat(29), "日".repeat(29));
        assert_eq!(shown, format!("…{} X7 {around}…{around} Y8 {wide}… \n", "ř".repeat(29)));
        assert_eq!(marked, ["Y8", "X7"]);
        assert_eq!(places, [(2, 5_000_306), (2, 5_000_002)]);
    }

    #[test]
    fn long_marks_are_cut_too() {
        let text = format!("N1 \"{}\" X5", "a".repeat(10_000_000));
        let (shown, _, marked, _) = excerpt(&text, &[Span::new(3, 10_000_005), find(&text, "X5")]);
        assert_eq!(shown, format!("N1 \"{0}…{1}\" X5 \n", "a".repeat(89), "a".repeat(28)));
        assert_eq!(marked[0].chars().count(), 91);
    }
}
