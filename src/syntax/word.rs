//! One word of a block, in twelve bytes.

use super::number::Number;
use crate::dict::{Address, Decimal, GCode};
use crate::sure::{Sure, small};
use crate::text::Span;

/// A word: an address and its value. Where its parts stand is read again from the text when a finding needs it.
#[derive(Clone, Copy, Debug)]
pub struct Word {
    start: u32,
    raw: i32,
    /// Facts about the value, and from [`LENGTH`] on the length of the word.
    flags: u16,
    /// The address.
    pub address: Address,
    index: u8,
}

/// The value of a word.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Value {
    /// Nothing: `/`, or a word so malformed that no fix gives it a value.
    None,
    /// A number.
    Number(Decimal),
    /// The value of a parameter (PAR-2), or its negation.
    Parameter {
        /// Its number.
        index: u8,
        /// `-` stands before it.
        negated: bool,
    },
}

const POINT: u16 = 1;
const PLUS: u16 = 1 << 1;
const MINUS: u16 = 1 << 2;
const ROUNDED: u16 = 1 << 3;
/// The number has no room in `raw` alone: of R, `raw` counts ones; of other addresses, `index` are its highest bits.
const WIDE: u16 = 1 << 4;
const PARAMETER: u16 = 1 << 5;
const FAULTY: u16 = 1 << 6;
const VOID: u16 = 1 << 7;
/// The greatest number of thousandths that a word keeps: beyond every range, and within forty bits.
const WIDEST: i64 = 500_000_000_000;
/// The first bit of the length.
const LENGTH: u32 = 8;
/// Stands for this length and every longer one.
const LONG: u16 = (1 << (16 - LENGTH)) - 1;

impl Word {
    /// A word without a value.
    pub fn bare(address: Address, span: Span) -> Self {
        let length = u16::try_from(span.len()).unwrap_or(LONG).min(LONG);
        // An R word assigns no parameter until it is said which.
        let index = if address == Address::R { u8::MAX } else { 0 };
        Self { start: span.start, raw: 0, flags: VOID | length << LENGTH, address, index }
    }

    /// A word with a number.
    pub fn with_number(address: Address, span: Span, number: Number) -> Self {
        let mut word = Self::bare(address, span);
        word.flags &= !VOID;
        let flag = |set: bool, flag: u16| if set { flag } else { 0 };
        word.flags |= flag(number.point, POINT) | flag(number.plus, PLUS);
        word.flags |= flag(number.minus, MINUS) | flag(number.rounded, ROUNDED);
        match i32::try_from(number.value.thousandths()) {
            Ok(raw) => word.raw = raw,
            Err(_) => word.widen(number.value),
        }
        word
    }

    /// Takes a number that has no room in `raw`. It is kept exactly as far as any range reaches; beyond that it stays
    /// out of range, and with a fraction when it has one.
    #[cold]
    fn widen(&mut self, value: Decimal) {
        let thousandths = value.thousandths();
        if self.address != Address::R {
            self.flags |= WIDE;
            let [a, b, c, d, e, ..] = thousandths.clamp(-WIDEST, WIDEST).to_le_bytes();
            self.raw = i32::from_le_bytes([a, b, c, d]);
            self.index = e;
        } else if let Some(whole) = value.as_whole() {
            self.flags |= WIDE;
            self.raw = i32::try_from(whole).unwrap_or(i32::MAX);
        } else {
            // A parameter has no fraction that high, nor has what stays here.
            self.raw = if thousandths < 0 { i32::MIN } else { i32::MAX };
        }
    }

    /// A word whose value is a parameter.
    pub fn with_parameter(address: Address, span: Span, source: u8, sign: Option<u8>) -> Self {
        let mut word = Self::bare(address, span);
        word.flags &= !VOID;
        word.flags |= PARAMETER
            | match sign {
                Some(b'-') => MINUS,
                Some(_) => PLUS,
                None => 0,
            };
        word.raw = i32::from(source);
        word
    }

    /// The same word without its value, which is not one that its address takes: nothing is known of what it would have
    /// set (§13). What is written can still be asked for: [`Self::refused_number`].
    #[must_use]
    pub fn refused(mut self) -> Self {
        self.flags |= VOID;
        self
    }

    /// The number that is written in a refused word; `None` for every other word.
    pub fn refused_number(self) -> Option<Decimal> {
        let refused = self.flags & (VOID | FAULTY | PARAMETER) == VOID && self.address != Address::Skip;
        let mut written = self;
        written.flags &= !VOID;
        written.number().filter(|_| refused)
    }

    /// The same word as an assignment to parameter `target`.
    #[must_use]
    pub fn assigning(mut self, target: u8) -> Self {
        self.index = target;
        self
    }

    /// The same word, marked as one that has its finding already: its form is not judged again.
    #[must_use]
    pub fn faulty(mut self) -> Self {
        self.flags |= FAULTY;
        self
    }

    /// Its value.
    #[inline]
    pub fn value(self) -> Value {
        if self.flags & (VOID | PARAMETER | WIDE) == 0 {
            Value::Number(Decimal::from_thousandths(i64::from(self.raw)))
        } else if self.flags & VOID != 0 {
            Value::None
        } else if self.flags & PARAMETER != 0 {
            let index = u8::try_from(self.raw).unwrap_or(u8::MAX);
            Value::Parameter { index, negated: self.flags & MINUS != 0 }
        } else {
            Value::Number(self.wide())
        }
    }

    #[cold]
    fn wide(self) -> Decimal {
        if self.address == Address::R {
            return Decimal::whole(i64::from(self.raw));
        }
        let [a, b, c, d] = self.raw.to_le_bytes();
        let sign = if self.index & 0x80 == 0 { 0 } else { 0xff };
        Decimal::from_thousandths(i64::from_le_bytes([a, b, c, d, self.index, sign, sign, sign]))
    }

    /// Its value when it is a number written out.
    #[inline]
    pub fn number(self) -> Option<Decimal> {
        match self.value() {
            Value::Number(number) => Some(number),
            Value::None | Value::Parameter { .. } => None,
        }
    }

    /// Its value when it is a whole number written out.
    #[inline]
    pub fn whole(self) -> Option<i64> {
        self.number().and_then(Decimal::as_whole)
    }

    /// The G function that it writes out.
    pub fn g_code(self) -> Option<GCode> {
        if self.address != Address::G {
            return None;
        }
        self.whole().and_then(|number| u8::try_from(number).ok()).and_then(GCode::from_number)
    }

    /// Whether it is this M function, written out.
    pub fn is_m(self, function: u8) -> bool {
        self.address == Address::M && self.whole() == Some(i64::from(function))
    }

    /// The parameter that an R word assigns, above 95 when that cannot be read; of other words nothing.
    pub const fn target(self) -> u8 {
        self.index
    }

    /// Whether a decimal point is written.
    pub const fn has_point(self) -> bool {
        self.flags & POINT != 0
    }

    /// Whether a sign is written.
    pub const fn has_sign(self) -> bool {
        self.flags & (PLUS | MINUS) != 0
    }

    /// Whether rounding to 0.001 changed the value (ADR-2).
    pub const fn is_rounded(self) -> bool {
        self.flags & ROUNDED != 0
    }

    /// Whether the word has a finding about its form already.
    pub const fn is_faulty(self) -> bool {
        self.flags & FAULTY != 0
    }

    /// Whether it has no value that could be used.
    pub const fn is_void(self) -> bool {
        self.flags & VOID != 0
    }

    /// Whether it has no value that could be used, and needs one: a `/` needs none.
    pub fn lacks_value(self) -> bool {
        self.is_void() && self.address != Address::Skip
    }

    /// Whether its value is a parameter.
    pub const fn is_parametric(self) -> bool {
        self.flags & PARAMETER != 0
    }

    /// Whether nothing but a plain number is here: no finding, no parameter, no missing value.
    #[inline]
    pub const fn is_plain(self) -> bool {
        self.flags & (PARAMETER | FAULTY | VOID) == 0
    }

    /// Whether nothing but digits is the value: no sign, no point, no finding.
    #[inline]
    pub const fn is_digits(self) -> bool {
        self.flags & (POINT | PLUS | MINUS | ROUNDED | PARAMETER | FAULTY | VOID) == 0
    }

    /// Address and value without the place and the decimal point: equal for words that are executed alike.
    pub fn essence(self) -> u64 {
        let [flags, _] = (self.flags & !POINT).to_le_bytes();
        let [a, b, c, d] = self.raw.to_le_bytes();
        u64::from_le_bytes([a, b, c, d, self.index, flags, self.address as u8, 0])
    }

    /// First byte.
    pub const fn start(self) -> u32 {
        self.start
    }

    /// Where the whole word stands in `text`.
    pub fn span(self, text: &str) -> Span {
        match self.flags >> LENGTH {
            // A long run of blanks or digits, or a number in many pieces.
            LONG => super::parse::long_word(text, self.start),
            length => Span::new(self.start, self.start + u32::from(length)),
        }
    }

    /// Where its parts stand in `text`.
    pub fn parts(self, text: &str) -> WordParts {
        let span = self.span(text);
        let written = text.get(span.range()).sure();
        let bytes = written.as_bytes();
        // The letter may be one with an accent.
        let mut at = written.chars().next().map_or(1, char::len_utf8);
        let skip = |at: &mut usize, wanted: fn(&u8) -> bool| {
            while bytes.get(*at).is_some_and(wanted) {
                *at += 1;
            }
        };
        let blank: fn(&u8) -> bool = |byte| matches!(byte, b' ' | b'\t');
        skip(&mut at, blank);
        let mut target = None;
        if self.address == Address::R {
            let from = at;
            skip(&mut at, |byte| byte.is_ascii_digit() || matches!(byte, b'o' | b'O' | b'l'));
            target = Some(sub(span, from, at));
            skip(&mut at, blank);
            if bytes.get(at) == Some(&b'=') {
                at += 1;
                skip(&mut at, blank);
            }
        }
        let value = sub(span, at.min(bytes.len()), bytes.len());
        WordParts { word: span, target, value: if value.is_empty() { span } else { value } }
    }
}

fn sub(span: Span, from: usize, to: usize) -> Span {
    let place = |at: usize| span.start + small(at);
    Span::new(place(from), place(to))
}

/// Where the parts of a word stand.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct WordParts {
    /// All of it.
    pub word: Span,
    /// The number of the parameter that an R word assigns.
    pub target: Option<Span>,
    /// Its value with its sign; the whole word when there is none.
    pub value: Span,
}

const _: () = assert!(size_of::<Word>() == 12, "words lie in one arena by the million");

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::diag::Findings;
    use crate::syntax::{BlockId, Form, parse};
    use crate::text::{FileId, SourceText};

    /// The word that is written, and the text that it covers.
    fn read(text: &str) -> (Word, String) {
        let source = Arc::new(SourceText::from_text("t.nc", format!("%1\nN10 {text}\nN20 M30")));
        let parsed = parse(FileId(0), &source, Form::Program, &mut Findings::new());
        let word = parsed.words(BlockId(0))[0];
        (word, source.slice(word.span(source.text())).to_owned())
    }

    fn number(text: &str) -> Option<i64> {
        read(text).0.number().map(Decimal::thousandths)
    }

    #[test]
    fn values() {
        assert_eq!(number("X-1.5"), Some(-1500));
        assert_eq!(number("X2147483.647"), Some(2_147_483_647));
        assert_eq!(number("X2147484"), Some(2_147_484_000));
        assert_eq!(number("X-2147484"), Some(-2_147_484_000));
        assert_eq!(number("X2147484.5"), Some(2_147_484_500));
        assert_eq!(number("X-2147484.5"), Some(-2_147_484_500));
        assert_eq!(number("F9999999.999"), Some(9_999_999_999));
        assert_eq!(number("X-4294967.296"), Some(-4_294_967_296));
        assert_eq!(number("X400000000.001"), Some(400_000_000_001));
        assert_eq!(number("X999999999999"), Some(500_000_000_000));
        assert_eq!(number("R1=99999999"), Some(99_999_999_000));
        assert_eq!(number("R1=-99999999"), Some(-99_999_999_000));
        // Out of range for a parameter, as what is written.
        assert_eq!(number("R1=99999999.5"), Some(i64::from(i32::MAX)));
        assert_eq!(number("R1=-2147484.999"), Some(i64::from(i32::MIN)));
        assert_eq!(number("XR5"), None);
        assert_eq!(number("/"), None);
    }

    #[test]
    fn what_is_written() {
        for (text, digits, plain) in [
            ("X5", true, true),
            ("X5.", false, true),
            ("X+5", false, true),
            ("X-5", false, true),
            ("X0.0005", false, true),
            ("XR5", false, false),
            ("X1 5", false, false),
            ("X", false, false),
            ("/", false, false),
        ] {
            let (word, _) = read(text);
            assert_eq!((word.is_digits(), word.is_plain()), (digits, plain), "{text}");
        }
    }

    /// A word may be longer than its twelve bytes can tell.
    #[test]
    fn long_words() {
        for blanks in [0, 1, 200, 250, 251, 252, 253, 254, 255, 256, 600] {
            let blanks = " ".repeat(blanks);
            for text in [
                format!("X{blanks}5"),
                format!("X{blanks}R5"),
                format!("X-{blanks}5.5"),
                format!("R1{blanks}={blanks}R2"),
                format!("R1{blanks}={blanks}-5"),
                format!("X5{blanks}5{blanks}5"),
            ] {
                let (_, covered) = read(&format!("{text}  Y1 R3=4"));
                assert_eq!(covered, text);
            }
        }
    }
}
