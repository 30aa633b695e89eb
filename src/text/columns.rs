//! What editors count columns in.

use crate::sure::small;

/// The unit of an editor's columns.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum ColumnUnit {
    /// Bytes of UTF-8.
    Bytes,
    /// Code units of UTF-16: what every language client knows.
    #[default]
    Utf16,
    /// Characters.
    Characters,
}

impl ColumnUnit {
    /// How many units a character takes.
    pub const fn width(self, character: char) -> u32 {
        match self {
            Self::Bytes if character.is_ascii() => 1,
            Self::Bytes => character.len_utf8() as u32,
            Self::Utf16 => character.len_utf16() as u32,
            Self::Characters => 1,
        }
    }

    /// How many units a text takes.
    pub fn count(self, text: &str) -> u32 {
        let count = match self {
            Self::Bytes => text.len(),
            _ if text.is_ascii() => text.len(),
            Self::Utf16 => text.encode_utf16().count(),
            Self::Characters => text.chars().count(),
        };
        small(count)
    }
}
