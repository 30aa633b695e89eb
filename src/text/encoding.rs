//! The code pages that part programs come in (LEX-13).

use std::borrow::Cow;

use crate::named::named;
use crate::sure::Sure;

named! {
    /// How the bytes of a file become characters, when they are not valid UTF-8.
    #[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
    #[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
    pub enum Encoding {
        /// UTF-8: tried first on every file; as the configured one it takes no other.
        #[cfg_attr(feature = "cli", value(name = "utf-8"))]
        Utf8 "utf-8",
        /// DOS Latin 2, the default of what is not UTF-8.
        #[default]
        #[cfg_attr(feature = "cli", value(name = "cp852"))]
        Cp852 "cp852",
        /// Windows, Central European.
        #[cfg_attr(feature = "cli", value(name = "windows-1250", aliases = ["cp1250", "win1250"]))]
        Windows1250 "windows-1250",
        /// ISO Latin 2.
        #[cfg_attr(feature = "cli", value(name = "iso-8859-2"))]
        Iso88592 "iso-8859-2",
        /// The code of the Kamenický brothers (CP895), of Czech DOS machines.
        #[cfg_attr(feature = "cli", value(name = "kamenicky", alias = "cp895"))]
        Kamenicky "kamenicky",
        /// UTF-16, the lower byte of each unit first: told by its bytes, and no encoding of part programs.
        #[cfg_attr(feature = "cli", value(skip))]
        Utf16Le "utf-16le",
        /// UTF-16, the higher byte first.
        #[cfg_attr(feature = "cli", value(skip))]
        Utf16Be "utf-16be",
    }
}

/// So many bytes are looked at for UTF-16 without a byte-order mark.
const HEAD: usize = 256;
/// So many characters the first lines must have for that.
const LEAST: usize = 4;

/// The upper half of Kamenický's code page: 0x80–0xAF its own, the rest as in code page 437.
const KAMENICKY: [char; 128] = [
    'Č', 'ü', 'é', 'ď', 'ä', 'Ď', 'Ť', 'č', 'ě', 'Ě', 'Ĺ', 'Í', 'ľ', 'ĺ', 'Ä', 'Á', 'É', 'ž', 'Ž', 'ô', 'ö', 'Ó', 'ů',
    'Ú', 'ý', 'Ö', 'Ü', 'Š', 'Ľ', 'Ý', 'Ř', 'ť', 'á', 'í', 'ó', 'ú', 'ň', 'Ň', 'Ů', 'Ô', 'š', 'ř', 'ŕ', 'Ŕ', '¼', '§',
    '«', '»', '░', '▒', '▓', '│', '┤', '╡', '╢', '╖', '╕', '╣', '║', '╗', '╝', '╜', '╛', '┐', '└', '┴', '┬', '├', '─',
    '┼', '╞', '╟', '╚', '╔', '╩', '╦', '╠', '═', '╬', '╧', '╨', '╤', '╥', '╙', '╘', '╒', '╓', '╫', '╪', '┘', '┌', '█',
    '▄', '▌', '▐', '▀', 'α', 'ß', 'Γ', 'π', 'Σ', 'σ', 'µ', 'τ', 'Φ', 'Θ', 'Ω', 'δ', '∞', 'φ', 'ε', '∩', '≡', '±', '≥',
    '≤', '⌠', '⌡', '÷', '≈', '°', '∙', '·', '√', 'ⁿ', '²', '■', '\u{a0}',
];

impl Encoding {
    /// Whether every unit of UTF-16 in the bytes belongs to a character: no half pairs, no half unit at the end.
    pub(super) fn is_exact(self, bytes: &[u8]) -> bool {
        let unit: fn(&[u8; 2]) -> u16 = match self {
            Self::Utf16Le => |pair| u16::from_le_bytes(*pair),
            Self::Utf16Be => |pair| u16::from_be_bytes(*pair),
            Self::Utf8 | Self::Cp852 | Self::Windows1250 | Self::Iso88592 | Self::Kamenicky => return true,
        };
        let (pairs, rest) = bytes.as_chunks();
        rest.is_empty() && char::decode_utf16(pairs.iter().map(unit)).all(|unit| unit.is_ok())
    }

    /// Decodes every byte to exactly one character (in the one-byte code pages): nothing is lost, nothing merged.
    pub(super) fn decode(self, bytes: &[u8]) -> String {
        match self {
            Self::Utf8 => String::from_utf8_lossy(bytes).into_owned(),
            Self::Cp852 => oem_cp::decode_string_complete_table(bytes, &oem_cp::code_table::DECODING_TABLE_CP852),
            Self::Utf16Le => encoding_rs::UTF_16LE.decode_without_bom_handling(bytes).0.into_owned(),
            Self::Utf16Be => encoding_rs::UTF_16BE.decode_without_bom_handling(bytes).0.into_owned(),
            Self::Windows1250 => encoding_rs::WINDOWS_1250.decode_without_bom_handling(bytes).0.into_owned(),
            Self::Iso88592 => encoding_rs::ISO_8859_2.decode_without_bom_handling(bytes).0.into_owned(),
            Self::Kamenicky => bytes
                .iter()
                .map(|&byte| match byte.checked_sub(0x80) {
                    Some(upper) => KAMENICKY.get(usize::from(upper)).copied().unwrap_or('\u{fffd}'),
                    None => char::from(byte),
                })
                .collect(),
        }
    }

    /// The bytes of a text: the way back of decoding, where no byte was lost in it. In the one-byte code pages the text
    /// has the characters of the page only.
    pub fn encode(self, text: &str) -> Cow<'_, [u8]> {
        match self {
            Self::Utf16Le => return text.encode_utf16().flat_map(u16::to_le_bytes).collect(),
            Self::Utf16Be => return text.encode_utf16().flat_map(u16::to_be_bytes).collect(),
            Self::Utf8 => return Cow::Borrowed(text.as_bytes()),
            Self::Cp852 | Self::Windows1250 | Self::Iso88592 | Self::Kamenicky => {}
        }
        if text.is_ascii() {
            return Cow::Borrowed(text.as_bytes());
        }
        let upper = self.decode(&(0x80..=0xff).collect::<Vec<u8>>());
        let mut bytes: Vec<(char, u8)> = upper.chars().zip(0x80..=0xff).collect();
        bytes.sort_unstable();
        let byte = |character: char| match u8::try_from(character) {
            Ok(ascii) if ascii.is_ascii() => ascii,
            _ => {
                let at = bytes.binary_search_by_key(&character, |(known, _)| *known).ok();
                at.and_then(|at| bytes.get(at)).map(|(_, byte)| *byte).sure()
            }
        };
        text.chars().map(byte).collect()
    }

    /// The encodings that the project file and `--encoding` name, each with its name there.
    pub const NAMED: [(&'static str, Self); 5] = [
        ("cp852", Self::Cp852),
        ("windows-1250", Self::Windows1250),
        ("iso-8859-2", Self::Iso88592),
        ("kamenicky", Self::Kamenicky),
        ("utf-8", Self::Utf8),
    ];

    /// Whether each byte of the file is one character.
    pub const fn is_single_byte(self) -> bool {
        !matches!(self, Self::Utf8 | Self::Utf16Le | Self::Utf16Be)
    }

    /// Whether the file is in UTF-16.
    pub const fn is_utf16(self) -> bool {
        matches!(self, Self::Utf16Le | Self::Utf16Be)
    }

    /// How many bytes of the file a text has that was decoded from it.
    pub fn length(self, text: &str) -> usize {
        match self {
            Self::Utf8 => text.len(),
            Self::Utf16Le | Self::Utf16Be => 2 * text.encode_utf16().count(),
            Self::Cp852 | Self::Windows1250 | Self::Iso88592 | Self::Kamenicky => text.chars().count(),
        }
    }

    /// UTF-16, when the bytes begin with its byte-order mark, or nearly every second byte of the first lines is zero
    /// (LEX-13).
    pub fn utf16(bytes: &[u8]) -> Option<Self> {
        match bytes {
            [0xff, 0xfe, ..] => return Some(Self::Utf16Le),
            [0xfe, 0xff, ..] => return Some(Self::Utf16Be),
            _ => {}
        }
        let head = bytes.get(..HEAD).unwrap_or(bytes);
        let line_end = |pair: &[u8]| matches!(pair, [0, b'\n' | b'\r'] | [b'\n' | b'\r', 0]);
        let characters = || head.chunks_exact(2).filter(|pair| !line_end(pair));
        let count = characters().count();
        let low = characters().filter(|pair| matches!(pair, [0, other] if *other != 0)).count();
        let high = characters().filter(|pair| matches!(pair, [other, 0] if *other != 0)).count();
        let nearly = |zeros: usize| count >= LEAST && zeros * 4 >= count * 3;
        match (nearly(high), nearly(low)) {
            (true, _) => Some(Self::Utf16Le),
            (_, true) => Some(Self::Utf16Be),
            (false, false) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// LEX-13: in every code page each of the 256 bytes is a different character, so positions and bytes agree.
    #[test]
    fn every_byte_is_one_character_of_its_own() {
        let bytes: Vec<u8> = (0..=255).collect();
        for encoding in [Encoding::Cp852, Encoding::Windows1250, Encoding::Iso88592, Encoding::Kamenicky] {
            let text = encoding.decode(&bytes);
            let mut characters: Vec<char> = text.chars().collect();
            assert_eq!(characters.len(), 256, "{encoding:?}");
            assert!(!characters.contains(&'\u{fffd}'), "{encoding:?}");
            characters.sort_unstable();
            characters.dedup();
            assert_eq!(characters.len(), 256, "{encoding:?} maps two bytes to one character");
            assert_eq!(*encoding.encode(&text), bytes, "{encoding:?}");
        }
    }

    /// LEX-13: UTF-16 is recognised by its mark, or by the zeros of its first lines.
    #[test]
    fn utf16() {
        let units = |text: &str, swap: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(swap).collect::<Vec<u8>>();
        for text in ["\u{feff}%1", "%1 \"příruba\"\r\nN10 X5", "%123\n", "%1\r\nN1 X1\r\nN2 M30\r\n"] {
            assert_eq!(Encoding::utf16(&units(text, u16::to_le_bytes)), Some(Encoding::Utf16Le), "{text}");
            assert_eq!(Encoding::utf16(&units(text, u16::to_be_bytes)), Some(Encoding::Utf16Be), "{text}");
        }
        for bytes in [&b"%1\0\0\0\0\0\0"[..], b"%1\0", b"%1 X5\r\nN1 Y\0\x1a", b"", b"%\x001\0"] {
            assert_eq!(Encoding::utf16(bytes), None, "{bytes:?}");
        }
        let text = "%1 \"ř😀\" X5";
        assert_eq!(Encoding::Utf16Le.decode(&units(text, u16::to_le_bytes)), text);
        assert_eq!(Encoding::Utf16Be.length(text), units(text, u16::to_be_bytes).len());
        assert_eq!(*Encoding::Utf16Be.encode(text), units(text, u16::to_be_bytes));
        assert_eq!(*Encoding::Utf16Le.encode(text), units(text, u16::to_le_bytes));
    }

    #[test]
    fn czech_words_in_each_code_page() {
        assert_eq!(Encoding::Cp852.decode(b"p\xfd\xa1ruba"), "příruba");
        assert_eq!(Encoding::Windows1250.decode(b"p\xf8\xedruba"), "příruba");
        assert_eq!(Encoding::Iso88592.decode(b"\xb9roub"), "šroub");
        assert_eq!(Encoding::Kamenicky.decode(b"p\xa9\xa1ruba \xa8roub \x87ep"), "příruba šroub čep");
    }
}
