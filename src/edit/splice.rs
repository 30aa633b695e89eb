//! Puts edits into the bytes of a file, in whatever encoding: all between them stays byte by byte.

use std::sync::Arc;

use crate::sure::Sure;
use crate::text::{DecodeError, Encoding, SourceText, Span};

/// An edit: `before`, the bytes of `copied`, and `after` take the place of `span`.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Written<'a> {
    /// The replaced place.
    pub span: Span,
    /// ASCII, or in UTF-8 any text.
    pub before: &'a str,
    /// A part of the same text, at or behind `span`.
    pub copied: Option<Span>,
    /// As `before`.
    pub after: &'a str,
}

/// A file: its text and its bytes, which are held once where they are the same.
#[derive(Debug)]
pub struct FileBytes {
    source: Arc<SourceText>,
    /// `None`: those of the text.
    bytes: Option<Vec<u8>>,
}

impl FileBytes {
    /// Reads the text in the bytes, by `fallback` when they are neither UTF-8 nor UTF-16.
    ///
    /// # Errors
    /// [`DecodeError::TooLarge`] when the text has 4 GiB or more.
    pub fn decode(name: impl Into<String>, bytes: Vec<u8>, fallback: Encoding) -> Result<Self, DecodeError> {
        let source = SourceText::decode(name, bytes.clone(), fallback)?;
        let is_text = source.encoding() == Encoding::Utf8;
        Ok(Self { source: Arc::new(source), bytes: (!is_text).then_some(bytes) })
    }

    /// Its text.
    pub const fn source(&self) -> &Arc<SourceText> {
        &self.source
    }

    /// Its bytes.
    pub fn bytes(&self) -> &[u8] {
        self.bytes.as_deref().unwrap_or(self.source.text().as_bytes())
    }

    /// Its bytes alone.
    pub fn into_bytes(self) -> Vec<u8> {
        match self.bytes {
            Some(bytes) => bytes,
            None => match Arc::try_unwrap(self.source) {
                Ok(source) => source.into_text().into_bytes(),
                Err(source) => source.text().as_bytes().to_vec(),
            },
        }
    }
}

/// Bytes with edits, which come in the order of the text.
#[derive(Debug)]
pub struct Splice<'a> {
    source: &'a SourceText,
    bytes: &'a [u8],
    /// Empty before the first edit.
    result: Vec<u8>,
    edited: bool,
    /// The end of the finished part, in the text and in the bytes: [`SourceText::byte_offset`] counts from the start.
    text_at: u32,
    byte_at: usize,
}

impl<'a> Splice<'a> {
    /// Without edits yet; `bytes` are those of the text.
    pub fn new(source: &'a SourceText, bytes: &'a [u8]) -> Self {
        Self { source, bytes, result: Vec::new(), edited: false, text_at: 0, byte_at: 0 }
    }

    /// One more edit.
    pub fn write(&mut self, edit: Written<'_>) {
        let Written { span, before, copied, after } = edit;
        if !self.edited {
            self.edited = true;
            self.result.reserve(self.bytes.len() + self.bytes.len() / 16);
        }
        let edit_at = self.byte_at + self.length(Span::new(self.text_at, span.start));
        self.result.extend_from_slice(self.bytes.get(self.byte_at..edit_at).sure());
        self.result.extend_from_slice(before.as_bytes());
        if let Some(copied) = copied {
            let from = edit_at + self.length(Span::new(span.start, copied.start));
            self.result.extend_from_slice(self.bytes.get(from..from + self.length(copied)).sure());
        }
        self.result.extend_from_slice(after.as_bytes());
        // Of a character at the end of a file in UTF-16 a byte can be missing.
        self.byte_at = (edit_at + self.length(span)).min(self.bytes.len());
        self.text_at = span.end;
    }

    /// The bytes with all edits; `None` when they change nothing.
    pub fn finish(mut self) -> Option<Vec<u8>> {
        if !self.edited {
            return None;
        }
        self.result.extend_from_slice(self.bytes.get(self.byte_at..).sure());
        (self.result != self.bytes).then_some(self.result)
    }

    fn length(&self, span: Span) -> usize {
        let encoding = self.source.encoding();
        if encoding == Encoding::Utf8 { span.len() as usize } else { encoding.length(self.source.slice(span)) }
    }
}
