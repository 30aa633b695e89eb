//! A line of JSON, written without intermediate values.

use super::records::AxisMap;
use crate::dict::{AxisLetter, Decimal, Micro};
use crate::sure::Sure;
use crate::text::is_unsafe;

/// A field's key with its comma and colon, as bytes of known length.
macro_rules! key {
    ($name:ident) => {
        key!(@ stringify!($name))
    };
    ($name:literal) => {
        key!(@ $name)
    };
    (@ $($name:tt)+) => {{
        const KEY: &str = concat!(",\"", $($name)+, "\":");
        const BYTES: &[u8; KEY.len()] = match KEY.as_bytes().first_chunk() {
            Some(bytes) => bytes,
            None => &[0; KEY.len()],
        };
        BYTES
    }};
}
pub(super) use key;

/// The letter of an address, which is ASCII.
pub(super) fn byte(letter: char) -> u8 {
    u8::try_from(letter).unwrap_or(b'?')
}

/// More than eight digits hold.
const EIGHT: u64 = 100_000_000;
/// Eight characters `0`.
const ZEROS: u64 = 0x3030_3030_3030_3030;
/// Four of them.
const FOUR_ZEROS: u32 = 0x3030_3030;

/// The digits of a number below 10000, a byte each, the first one in the lowest byte.
#[inline]
const fn four_digits(value: u32) -> u32 {
    let (high, low) = (value / 100, value % 100);
    (high / 10) | ((high % 10) << 8) | ((low / 10) << 16) | ((low % 10) << 24)
}

/// The eight digits of a number below [`EIGHT`], a byte each, the first one in the lowest byte.
#[inline]
const fn digits(value: u32) -> u64 {
    four_digits(value / 10_000) as u64 | ((four_digits(value % 10_000) as u64) << 32)
}

/// A line being written. It is handed on by value, so that its end stays in a register: there are sixty things to write
/// in a record, each of which would wait for the one before.
pub(super) struct Line<'r> {
    /// Its beginning, and room for more.
    room: &'r mut Vec<u8>,
    /// Its end.
    pub at: usize,
}

impl<'r> Line<'r> {
    /// An empty line. `room`: used again for the next.
    pub(super) fn new(room: &'r mut Vec<u8>) -> Self {
        Self { room, at: 0 }
    }

    /// The text written up to now.
    pub(super) fn text(&self) -> &[u8] {
        self.room.get(..self.at).sure()
    }

    /// Writes text of a length known beforehand.
    #[inline(always)]
    pub(super) fn put<const N: usize>(self, text: &[u8; N]) -> Self {
        let end = self.at + N;
        if end > self.room.len() {
            make_room(self.room, end);
        }
        if let Some(place) = self.room.get_mut(self.at..end) {
            place.copy_from_slice(text);
        }
        Self { at: end, ..self }
    }

    /// Writes text of any length.
    #[inline]
    pub(super) fn put_all(self, text: &[u8]) -> Self {
        let end = self.at + text.len();
        if end > self.room.len() {
            make_room(self.room, end);
        }
        if let Some(place) = self.room.get_mut(self.at..end) {
            place.copy_from_slice(text);
        }
        Self { at: end, ..self }
    }

    #[inline(always)]
    pub(super) fn flag<const N: usize>(self, key: &[u8; N], value: bool) -> Self {
        if value { self.put(key).put(b"true") } else { self }
    }

    #[inline(always)]
    pub(super) fn int(self, value: u64) -> Self {
        // Most have one digit or two.
        match u8::try_from(value) {
            Ok(value @ 0..=9) => self.put(&[b'0' + value]),
            Ok(value @ 10..=99) => self.put(&[b'0' + value / 10, b'0' + value % 10]),
            _ => self.long_int(value),
        }
    }

    fn long_int(self, value: u64) -> Self {
        // All digits are put down, without those before the first that counts, and the end is then taken back: a copy
        // of fixed length is quicker than one that fits.
        if let Some(value) = u32::try_from(value).ok().filter(|value| *value < 10_000) {
            let digits = four_digits(value);
            let unused = (digits.trailing_zeros() / 8).min(3);
            let line = self.put(&((digits | FOUR_ZEROS) >> (8 * unused)).to_le_bytes());
            return Self { at: line.at - unused as usize, ..line };
        }
        let (high, low) = (value / EIGHT, u32::try_from(value % EIGHT).unwrap_or(0));
        if high > 0 {
            return self.int(high).put(&(digits(low) | ZEROS).to_le_bytes());
        }
        let digits = digits(low);
        let unused = (digits.trailing_zeros() / 8).min(7);
        let line = self.put(&((digits | ZEROS) >> (8 * unused)).to_le_bytes());
        Self { at: line.at - unused as usize, ..line }
    }

    #[inline(always)]
    pub(super) fn int_field<const N: usize>(self, key: &[u8; N], value: u64) -> Self {
        self.put(key).int(value)
    }

    /// A number without exponent, trailing zeros or a negative zero.
    pub(super) fn number(self, value: Micro) -> Self {
        let millionths = value.millionths();
        let line = if millionths < 0 { self.put(b"-") } else { self };
        let magnitude = millionths.unsigned_abs();
        let line = line.int(magnitude / 1_000_000);
        let fraction = u32::try_from(magnitude % 1_000_000).unwrap_or(0);
        if fraction == 0 {
            return line;
        }
        if fraction.is_multiple_of(1000) {
            // As programmed.
            let digits = four_digits(fraction / 100);
            let unused = digits.leading_zeros() / 8;
            let line = line.put(b".").put(&(digits | FOUR_ZEROS).to_le_bytes());
            return Self { at: line.at - unused as usize, ..line };
        }
        let digits = digits(fraction * 100);
        let unused = digits.leading_zeros() / 8;
        let line = line.put(b".").put(&(digits | ZEROS).to_le_bytes());
        Self { at: line.at - unused as usize, ..line }
    }

    #[inline(always)]
    pub(super) fn number_field<const N: usize>(self, key: &[u8; N], value: Micro) -> Self {
        self.put(key).number(value)
    }

    #[inline(always)]
    pub(super) fn decimal_field<const N: usize>(self, key: &[u8; N], value: Option<Decimal>) -> Self {
        match value {
            Some(value) => self.number_field(key, Micro::from(value)),
            None => self,
        }
    }

    pub(super) fn list<T>(self, items: &[T], write: impl Fn(Self, &T) -> Self) -> Self {
        let mut line = self.put(b"[");
        for (place, item) in items.iter().enumerate() {
            line = write(if place > 0 { line.put(b",") } else { line }, item);
        }
        line.put(b"]")
    }

    /// A list of functions by group, `null` where none is in force.
    pub(super) fn functions(self, functions: &[Option<u8>]) -> Self {
        self.list(functions, |line, function| match *function {
            Some(number) => line.int(u64::from(number)),
            None => line.put(b"null"),
        })
    }

    #[inline]
    pub(super) fn numbers<const N: usize>(self, key: &[u8; N], values: &[u8]) -> Self {
        if values.is_empty() {
            return self;
        }
        self.put(key).list(values, |line, value| line.int(u64::from(*value)))
    }

    #[inline]
    pub(super) fn letters<const N: usize>(self, key: &[u8; N], values: &[(char, Decimal)]) -> Self {
        if values.is_empty() {
            return self;
        }
        let mut line = self.put(key);
        let mut before = b'{';
        for &(letter, value) in values {
            line = line.put(&[before, b'"', byte(letter), b'"', b':']).number(Micro::from(value));
            before = b',';
        }
        line.put(b"}")
    }

    #[inline]
    pub(super) fn parameters<const N: usize>(self, key: &[u8; N], values: &[(u8, Decimal)]) -> Self {
        if values.is_empty() {
            return self;
        }
        let mut line = self.put(key);
        let mut before = b"{\"R";
        for (parameter, value) in values {
            line = line.put(before).int(u64::from(*parameter)).put(b"\":").number(Micro::from(*value));
            before = b",\"R";
        }
        line.put(b"}")
    }

    #[inline]
    pub(super) fn axis_map<const N: usize>(self, key: &[u8; N], values: &AxisMap, order: &[AxisLetter]) -> Self {
        if values.is_empty() {
            return self;
        }
        let mut line = self.put(key);
        let mut before = b'{';
        for &axis in order {
            let Some(value) = values.get(axis) else { continue };
            line = line.put(&[before, b'"', byte(axis.letter()), b'"', b':']).number(value);
            before = b',';
        }
        line.put(b"}")
    }

    /// A JSON string. What a terminal might act on is escaped.
    pub(super) fn string(self, text: &str) -> Self {
        let mut line = self.put(b"\"");
        let mut rest = text;
        while let Some(at) = rest.bytes().position(|byte| matches!(byte, b'"' | b'\\' | 0x00..=0x1f | 0x7f..)) {
            let (before, after) = rest.split_at(at);
            line = line.put_all(before.as_bytes());
            let character = after.chars().next().unwrap_or_default();
            let (of_it, behind) = after.split_at(character.len_utf8());
            line = match character {
                '"' => line.put(b"\\\""),
                '\\' => line.put(b"\\\\"),
                '\n' => line.put(b"\\n"),
                '\r' => line.put(b"\\r"),
                '\t' => line.put(b"\\t"),
                _ if is_unsafe(character) => character
                    .encode_utf16(&mut [0; 2])
                    .iter()
                    .fold(line, |line, unit| line.put_all(format!("\\u{unit:04x}").as_bytes())),
                _ => line.put_all(of_it.as_bytes()),
            };
            rest = behind;
        }
        line.put_all(rest.as_bytes()).put(b"\"")
    }

    pub(super) fn string_field<const N: usize>(self, key: &[u8; N], text: &str) -> Self {
        self.put(key).string(text)
    }
}

/// Makes the room of a line hold at least `end` bytes.
#[cold]
fn make_room(room: &mut Vec<u8>, end: usize) {
    room.resize(end.next_power_of_two().max(1024), 0);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(millionths: i64) -> String {
        let mut room = Vec::new();
        let line = Line::new(&mut room).number(Micro::from_millionths(millionths));
        String::from_utf8(line.text().to_vec()).unwrap()
    }

    #[test]
    fn numbers() {
        for (millionths, text) in [
            (0, "0"),
            (-1, "-0.000001"),
            (1_500_000, "1.5"),
            (-20_000_000, "-20"),
            (69_999_999_000, "69999.999"),
            (100, "0.0001"),
            (9_000_000, "9"),
            (10_000_000, "10"),
            (100_000_000, "100"),
            (99_999_999_999_999, "99999999.999999"),
            (100_000_000_000_000, "100000000"),
            (1_000_000_020_300_000_000, "1000000020300"),
            (i64::MAX, "9223372036854.775807"),
            (i64::MIN, "-9223372036854.775808"),
        ] {
            assert_eq!(shown(millionths), text);
        }
        assert_eq!(shown(Micro::from_f64(-1e-9).millionths()), "0");
    }

    #[test]
    fn strings() {
        let mut room = Vec::new();
        let line = Line::new(&mut room).string("a\"\\\u{1b}ř\u{7f}ž\u{9b}\u{202e}\u{e0041}日");
        let expected = r#""a\"\\\u001bř\u007fž\u009b\u202e\udb40\udc41日""#;
        assert_eq!(std::str::from_utf8(line.text()).unwrap(), expected);
    }
}
