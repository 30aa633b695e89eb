//! Puts edits into the bytes of a file, in whatever encoding: all between them stays byte by byte.

use crate::sure::Sure;
use crate::text::{Encoding, SourceText, Span};

/// Bytes with edits, which come in the order of the text.
#[derive(Debug)]
pub(super) struct Splice<'a> {
    source: &'a SourceText,
    bytes: &'a [u8],
    result: Vec<u8>,
    /// The end of the finished part, in the text and in the bytes: [`SourceText::byte_offset`] counts from the start.
    text_at: u32,
    byte_at: usize,
}

impl<'a> Splice<'a> {
    /// Without edits yet; `bytes` are those of the text.
    pub fn new(source: &'a SourceText, bytes: &'a [u8]) -> Self {
        Self { source, bytes, result: Vec::with_capacity(bytes.len()), text_at: 0, byte_at: 0 }
    }

    /// Replaces a place by a text, which is ASCII, or in UTF-8 any.
    pub fn write(&mut self, span: Span, text: &str) {
        let edit_at = self.byte_at + self.length(Span::new(self.text_at, span.start));
        self.result.extend_from_slice(self.bytes.get(self.byte_at..edit_at).sure());
        self.result.extend_from_slice(text.as_bytes());
        // Of a character at the end of a file in UTF-16 a byte can be missing.
        self.byte_at = (edit_at + self.length(span)).min(self.bytes.len());
        self.text_at = span.end;
    }

    /// The bytes with all edits.
    pub fn finish(mut self) -> Vec<u8> {
        self.result.extend_from_slice(self.bytes.get(self.byte_at..).sure());
        self.result
    }

    fn length(&self, span: Span) -> usize {
        let encoding = self.source.encoding();
        if encoding == Encoding::Utf8 { span.len() as usize } else { encoding.length(self.source.slice(span)) }
    }
}
