//! One file's text, and places in files.

use std::sync::OnceLock;

use super::{ColumnUnit, Encoding, LineColumn, LineIndex, NotUtf8, Span};
use crate::sure::{Sure, small};

/// Index of a file among the sources of one run; the program is 0.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, Ord, PartialEq, PartialOrd)]
pub struct FileId(pub u32);

/// A span in a file.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, Ord, PartialEq, PartialOrd)]
pub struct Location {
    /// The file.
    pub file: FileId,
    /// The place in its text.
    pub span: Span,
}

/// A file whose bytes cannot become a text.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum DecodeError {
    /// Spans hold 32 bits.
    TooLarge,
    /// Only UTF-8 is taken, and it is none.
    NotUtf8(NotUtf8),
}

/// The text of one file, decoded, with the way back to its bytes.
#[derive(Clone, Debug)]
pub struct SourceText {
    name: String,
    text: String,
    encoding: Encoding,
    bom: bool,
    /// Its last character is half a one in the file, which is in UTF-16 and has an odd number of bytes.
    half: bool,
    /// No byte was lost in decoding.
    exact: bool,
    lines: OnceLock<LineIndex>,
}

impl SourceText {
    /// Decodes `bytes`: as UTF-16 when they are that, as UTF-8 when they are valid UTF-8, else by `fallback` (LEX-13).
    /// A byte-order mark is kept in the text, and skipped by [`Self::first_offset`] (LEX-8).
    ///
    /// # Errors
    /// [`DecodeError::TooLarge`] when the text has 4 GiB or more, [`DecodeError::NotUtf8`] when `fallback` is UTF-8 and
    /// the bytes are not.
    pub fn decode(name: impl Into<String>, bytes: Vec<u8>, fallback: Encoding) -> Result<Self, DecodeError> {
        let size = bytes.len();
        let mut exact = true;
        let (text, encoding) = match Encoding::utf16(&bytes) {
            Some(wide) => {
                exact = wide.is_exact(&bytes);
                (wide.decode(&bytes), wide)
            }
            None => match String::from_utf8(bytes) {
                Ok(text) => (text, Encoding::Utf8),
                Err(error) if fallback == Encoding::Utf8 => {
                    return Err(DecodeError::NotUtf8(NotUtf8::at(error.as_bytes(), error.utf8_error().valid_up_to())));
                }
                Err(error) => (fallback.decode(error.as_bytes()), fallback),
            },
        };
        if u32::try_from(text.len()).is_err() {
            return Err(DecodeError::TooLarge);
        }
        let bom = !encoding.is_single_byte() && text.starts_with('\u{feff}');
        let half = encoding.is_utf16() && encoding.length(&text) > size;
        Ok(Self { name: name.into(), text, encoding, bom, half, exact, lines: OnceLock::new() })
    }

    /// A text that is already decoded: an editor's buffer, a test.
    pub fn from_text(name: impl Into<String>, text: impl Into<String>) -> Self {
        let text = text.into();
        let bom = text.starts_with('\u{feff}');
        let encoding = Encoding::Utf8;
        Self { name: name.into(), text, encoding, bom, half: false, exact: true, lines: OnceLock::new() }
    }

    /// Another text of the same file.
    #[must_use]
    pub fn with_text(&self, text: String) -> Self {
        Self { encoding: self.encoding, ..Self::from_text(self.name.as_str(), text) }
    }

    /// The text without its byte-order mark, as editors count in it.
    #[must_use]
    pub fn without_mark(&self) -> Self {
        let text = self.text.strip_prefix('\u{feff}').unwrap_or(&self.text).to_owned();
        Self { half: self.half, exact: self.exact, ..self.with_text(text) }
    }

    /// The file as the user named it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The decoded text, byte-order mark included.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The decoded text alone.
    pub fn into_text(self) -> String {
        self.text
    }

    /// The encoding of the bytes.
    pub const fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// Whether the text is all that its bytes say: UTF-16 may have units that are no character.
    pub const fn is_exact(&self) -> bool {
        self.exact
    }

    /// Where the text begins: after a byte-order mark.
    pub const fn first_offset(&self) -> u32 {
        if self.bom { 3 } else { 0 }
    }

    /// Length of the text in bytes; below 4 GiB by construction.
    pub fn len(&self) -> u32 {
        small(self.text.len())
    }

    /// Whether the file is empty.
    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// The text of `span`, which is one of this text; of another it is empty, and with debug assertions a panic.
    pub fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).sure()
    }

    /// The lines, indexed at the first use.
    pub fn lines(&self) -> &LineIndex {
        self.lines.get_or_init(|| LineIndex::new(&self.text, self.first_offset()))
    }

    /// Line and column of `offset`.
    pub fn line_column(&self, offset: u32) -> LineColumn {
        let lines = self.lines();
        let line = lines.line_at(offset);
        self.column_in(line, offset)
    }

    /// Line and column of `offset`, which lies in line `line` (from 0).
    pub fn column_in(&self, line: usize, offset: u32) -> LineColumn {
        let start = self.lines().start(line).unwrap_or(0);
        let before = self.slice(Span::new(start, offset));
        let column = if before.is_ascii() { before.len() } else { before.chars().count() };
        LineColumn { line: small(line + 1), column: small(column + 1) }
    }

    /// Offset in the bytes of the file of `offset` in the text.
    pub fn byte_offset(&self, offset: u32) -> u64 {
        if self.encoding == Encoding::Utf8 {
            u64::from(offset)
        } else {
            self.encoding.length(self.slice(Span::new(0, offset))) as u64 - self.missing_before(offset)
        }
    }

    /// How many bytes the file lacks of the characters before `offset`: one at the end of UTF-16 with an odd number of
    /// bytes.
    pub fn missing_before(&self, offset: u32) -> u64 {
        u64::from(self.half && offset == self.len())
    }

    /// Replaces the text of `span`, as an editor does; a span that is none of this text, or a text that would reach 4
    /// GiB, changes nothing, and `false` comes back.
    pub fn replace(&mut self, span: Span, with: &str) -> bool {
        let grown = u32::try_from(self.text.len() + with.len()).is_ok();
        if !grown || self.text.get(span.range()).is_none() {
            return false;
        }
        // At the end the half character goes, or it is at the end no more.
        self.half &= span.end < self.len();
        self.text.replace_range(span.range(), with);
        let bom = self.text.starts_with('\u{feff}');
        let first = self.first_offset();
        match self.lines.get_mut() {
            // Behind a byte-order mark the first line begins elsewhere.
            Some(lines) if bom == self.bom && span.start >= first => {
                lines.replaced(&self.text, span.start, span.end, span.start + small(with.len()));
            }
            _ => self.lines = OnceLock::new(),
        }
        self.bom = bom;
        true
    }

    /// The offset of column `column` (from 0, in `unit`s) of line `line` (from 0), both counted from the very start of
    /// the text. Places behind the end of a line are its end, lines behind the last are the end of the text, and a
    /// column inside a character is the begin of it.
    pub fn offset_at(&self, line: usize, column: u32, unit: ColumnUnit) -> u32 {
        if line >= self.lines().count() {
            return self.len();
        }
        let span = self.editor_line(line);
        let text = self.slice(span);
        if unit == ColumnUnit::Bytes || text.is_ascii() {
            let at = span.start.saturating_add(column).min(span.end);
            return (span.start..=at).rev().find(|&at| self.text.is_char_boundary(at as usize)).unwrap_or(span.start);
        }
        let mut passed = 0;
        for (at, character) in text.char_indices() {
            passed += unit.width(character);
            if passed > column {
                return span.start + small(at);
            }
        }
        span.end
    }

    /// A line as an editor counts it: the first one with its byte-order mark.
    fn editor_line(&self, line: usize) -> Span {
        let span = self.line_span(line);
        if line == 0 { Span::new(0, span.end) } else { span }
    }

    /// Line and column (both from 0, the column in `unit`s) of `offset`, as [`Self::offset_at`] takes them.
    pub fn position_of(&self, offset: u32, unit: ColumnUnit) -> (usize, u32) {
        let line = self.lines().line_at(offset);
        let start = self.editor_line(line).start;
        (line, unit.count(self.slice(Span::new(start, offset.max(start)))))
    }

    /// What ends a line that is added: CR LF where the text has one.
    pub fn line_end(&self) -> &'static str {
        if self.text().contains("\r\n") { "\r\n" } else { "\n" }
    }

    /// The span of line `line` (from 0), its line end excluded.
    pub fn line_span(&self, line: usize) -> Span {
        let lines = self.lines();
        let start = lines.start(line).unwrap_or(self.len());
        let end = lines.start(line + 1).unwrap_or(self.len());
        let text = self.slice(Span::new(start, end));
        Span::new(start, start + small(text.trim_end_matches(['\r', '\n']).len()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// LEX-13: positions are characters, and offsets lead back to the bytes, in UTF-8 and in a code page.
    #[test]
    fn positions_in_utf8_and_code_page() {
        let utf8 = SourceText::decode("a", "%1 \"př\" X".as_bytes().to_vec(), Encoding::Cp852).unwrap();
        let dos = SourceText::decode("b", b"%1 \"p\xfd\" X".to_vec(), Encoding::Cp852).unwrap();
        assert_eq!(utf8.text(), dos.text());
        let x = u32::try_from(utf8.text().find('X').unwrap()).unwrap();
        assert_eq!(utf8.line_column(x), LineColumn { line: 1, column: 9 });
        assert_eq!(dos.line_column(x), LineColumn { line: 1, column: 9 });
        assert_eq!((utf8.byte_offset(x), dos.byte_offset(x)), (9, 8));
    }

    /// Editors count in bytes, UTF-16 or characters; every place leads back to itself.
    #[test]
    fn editor_positions() {
        let source = SourceText::from_text("a", "\u{feff}%1\r\nN1 \"ř😀\" X5\nN2");
        let offset = |text: &str| u32::try_from(source.text().find(text).unwrap()).unwrap();
        for (unit, column) in [(ColumnUnit::Bytes, 12), (ColumnUnit::Utf16, 9), (ColumnUnit::Characters, 8)] {
            assert_eq!(source.position_of(offset("X5"), unit), (1, column), "{unit:?}");
            assert_eq!(source.offset_at(1, column, unit), offset("X5"), "{unit:?}");
            assert_eq!(source.offset_at(1, 99, unit), offset("\nN2"), "{unit:?}");
            assert_eq!(source.offset_at(7, 0, unit), source.len(), "{unit:?}");
            assert_eq!(source.offset_at(2, 1, unit), offset("N2") + 1, "{unit:?}");
        }
        assert_eq!(source.offset_at(1, 6, ColumnUnit::Utf16), offset("😀"), "inside a surrogate pair");
        assert_eq!(source.offset_at(0, 1, ColumnUnit::Utf16), 3, "behind the byte-order mark");
    }

    /// A replaced text is as a new one.
    #[test]
    fn replacements() {
        let mut source = SourceText::from_text("a", "%1\nN1 X5\nN2");
        assert_eq!(source.lines().count(), 3);
        assert!(source.replace(Span::new(3, 8), "N1 X5\nN15"));
        assert_eq!((source.text(), source.lines().count()), ("%1\nN1 X5\nN15\nN2", 4));
        assert!(source.replace(Span::new(0, 0), "\u{feff}"));
        assert_eq!((source.first_offset(), source.lines().start(0)), (3, Some(3)));
        assert!(!source.replace(Span::new(1, 2), ""), "inside a character");
        assert!(!source.replace(Span::new(0, 99), ""), "behind the end");
    }

    /// A file in UTF-16 may end within a character.
    #[test]
    fn half_a_character() {
        let source = SourceText::decode("a", b"\xff\xfe%\x001\x00\n".to_vec(), Encoding::Cp852).unwrap();
        assert_eq!(source.byte_offset(u32::try_from(source.text().len()).unwrap()), 7);
    }

    /// Offsets lead to the bytes of a replaced text too, in a code page and in UTF-16.
    #[test]
    fn bytes_of_replaced_texts() {
        let end = |source: &SourceText| source.byte_offset(source.len());
        let mut dos = SourceText::decode("a", b"%1 \"p\xfd\"".to_vec(), Encoding::Cp852).unwrap();
        assert!(dos.replace(Span::new(0, 2), "%12345"));
        assert_eq!((dos.text(), end(&dos)), ("%12345 \"př\"", 11));
        let mut wide = SourceText::decode("a", b"\xff\xfe%\x001\x00\n".to_vec(), Encoding::Cp852).unwrap();
        assert!(wide.replace(Span::new(4, 5), "345"));
        assert_eq!((wide.text(), end(&wide)), ("\u{feff}%345\u{fffd}", 11));
        assert!(wide.replace(Span::new(wide.len(), wide.len()), "6"));
        assert_eq!(end(&wide), 14, "the character before the last is a whole one");
    }

    /// LEX-8: a byte-order mark takes no column.
    #[test]
    fn byte_order_mark() {
        let source = SourceText::decode("a", "\u{feff}%1".as_bytes().to_vec(), Encoding::Cp852).unwrap();
        assert_eq!(source.line_column(source.first_offset()), LineColumn { line: 1, column: 1 });
        assert_eq!(source.byte_offset(3), 3);
    }
}
