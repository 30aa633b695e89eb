//! Lines, columns and byte offsets of many places, also in a file that is one endless line.

use std::cell::OnceCell;
use std::sync::Arc;

use crate::sure::{Sure, small};
use crate::text::{FileId, LineColumn, Location, SourceText, Sources, Span};

/// Bytes of text between two counts of characters.
const STEP: usize = 4096;

/// Where the places of a report are, as users and programs count. Each question costs the same, however long the lines
/// are and however far into the file the place is; [`SourceText::line_column`] counts from the start of the line.
pub(super) struct Places<'a> {
    files: Vec<File<'a>>,
}

struct File<'a> {
    source: &'a Arc<SourceText>,
    /// Number of characters before each multiple of [`STEP`]; counted at the first use.
    characters: OnceCell<Vec<u32>>,
    /// The same of units of UTF-16, for a file in it.
    units: OnceCell<Vec<u32>>,
}

impl<'a> Places<'a> {
    /// Of these texts.
    pub fn new(sources: &'a Sources) -> Self {
        Self {
            files: sources
                .iter()
                .map(|(_, source)| File { source, characters: OnceCell::new(), units: OnceCell::new() })
                .collect(),
        }
    }

    /// The text of a file.
    pub fn source(&self, file: FileId) -> Option<&'a SourceText> {
        self.files.get(file.0 as usize).map(|file| file.source.as_ref())
    }

    /// The file's name as the user gave it.
    pub fn name(&self, file: FileId) -> &'a str {
        self.source(file).map_or("?", SourceText::name)
    }

    /// Line and column of the start of a place.
    pub fn start(&self, at: Location) -> LineColumn {
        self.line_column(at.file, at.span.start)
    }

    /// Line and column one past the end of a place.
    pub fn end(&self, at: Location) -> LineColumn {
        self.line_column(at.file, at.span.end.max(at.span.start))
    }

    fn line_column(&self, file: FileId, offset: u32) -> LineColumn {
        let Some(file) = self.files.get(file.0 as usize) else {
            return LineColumn { line: 1, column: 1 };
        };
        let lines = file.source.lines();
        let line = lines.line_at(offset);
        let start = lines.start(line).unwrap_or(0);
        let column = file.characters_before(offset).saturating_sub(file.characters_before(start));
        LineColumn { line: small(line).saturating_add(1), column: column.saturating_add(1) }
    }

    /// Offsets of a place in the bytes of its file.
    pub fn bytes(&self, at: Location) -> (u64, u64) {
        let Some(file) = self.files.get(at.file.0 as usize) else {
            return (0, 0);
        };
        let Span { start, end } = at.span;
        let encoding = file.source.encoding();
        let byte = |offset: u32| match (encoding.is_single_byte(), encoding.is_utf16()) {
            (true, _) => u64::from(file.characters_before(offset)),
            (_, true) => 2 * u64::from(file.units_before(offset)) - file.source.missing_before(offset),
            (false, false) => u64::from(offset),
        };
        (byte(start), byte(end.max(start)))
    }
}

impl File<'_> {
    fn characters_before(&self, offset: u32) -> u32 {
        self.count_before(offset, &self.characters, count_characters)
    }

    fn units_before(&self, offset: u32) -> u32 {
        self.count_before(offset, &self.units, count_units)
    }

    fn count_before(&self, offset: u32, counts: &OnceCell<Vec<u32>>, count: fn(&[u8]) -> u32) -> u32 {
        let text = self.source.text().as_bytes();
        let offset = (offset as usize).min(text.len());
        let counts = counts.get_or_init(|| {
            let chunks = text.chunks(STEP).scan(0, |before, chunk| {
                *before += count(chunk);
                Some(*before)
            });
            std::iter::once(0).chain(chunks).collect()
        });
        let step = offset / STEP;
        let before = counts.get(step).copied().unwrap_or(0);
        before + count(text.get(step * STEP..offset).sure())
    }
}

/// How many units of UTF-16 the characters have that begin in these bytes of UTF-8.
fn count_units(bytes: &[u8]) -> u32 {
    let wide = bytes.iter().filter(|&&byte| byte >= 0xF0).count();
    count_characters(bytes) + small(wide)
}

/// How many characters begin in these bytes of UTF-8; fits 32 bits, because texts do.
fn count_characters(bytes: &[u8]) -> u32 {
    let count = bytes.iter().filter(|&&byte| byte & 0xC0 != 0x80).count();
    small(count)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::text::Encoding;

    proptest! {
        /// LEX-8, LEX-13: the same lines, columns and offsets as the source text itself tells, in every encoding.
        #[test]
        fn same_as_the_source_text(
            bytes in proptest::collection::vec(prop_oneof![Just(b'\n'), Just(b'\r'), Just(b'X'), any::<u8>()], 0..60),
            words in "(\u{feff}|)[ a-zř日\r\n]{0,40}",
            repeats in 0_usize..200,
            at in 0_u32..20_000,
        ) {
            let wide = SourceText::decode("wide", words.repeat(repeats).into_bytes(), Encoding::Cp852).unwrap();
            let narrow = SourceText::decode("narrow", bytes.repeat(repeats), Encoding::Cp852).unwrap();
            let utf16: Vec<u8> = bytes.iter().flat_map(|byte| [*byte, 0]).collect();
            let cut = [b"\xff\xfe".as_slice(), &utf16, &b"X"[..repeats % 2]].concat();
            let cut = SourceText::decode("cut", cut, Encoding::Cp852).unwrap();
            for source in [wide, narrow, cut] {
                let mut offset = at.min(source.len()).max(source.first_offset());
                while !source.text().is_char_boundary(offset as usize) {
                    offset -= 1;
                }
                let mut sources = Sources::new();
                let file = sources.add(source);
                let source = sources.get(file).unwrap();
                let at = Location { file, span: Span::empty(offset) };
                let places = Places::new(&sources);
                prop_assert_eq!(places.start(at), source.line_column(offset));
                prop_assert_eq!(places.bytes(at), (source.byte_offset(offset), source.byte_offset(offset)));
            }
        }
    }

    #[test]
    fn places_that_do_not_exist_are_the_first_one() {
        let sources = Sources::new();
        let at = Location { file: FileId(7), span: Span::new(5, 6) };
        let places = Places::new(&sources);
        assert_eq!((places.start(at), places.bytes(at)), (LineColumn { line: 1, column: 1 }, (0, 0)));
        assert_eq!(places.name(at.file), "?");
    }
}
