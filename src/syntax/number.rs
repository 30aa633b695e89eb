//! Numbers as written, read exactly (LEX-4, LEX-5, ADR-2).

use crate::dict::Decimal;

/// A number as written.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Number {
    /// Its value, rounded to 0.001, halves away from zero; saturated far outside every range.
    pub value: Decimal,
    /// `-` was written.
    pub minus: bool,
    /// `+` was written.
    pub plus: bool,
    /// A decimal point was written.
    pub point: bool,
    /// Rounding changed the value.
    pub rounded: bool,
}

/// More than any range of the language, and far from overflow.
const HUGE: i64 = 1_000_000_000;

impl Number {
    /// Reads `[+-]digits[.digits]`; `None` when it is anything else or has no digit.
    pub fn parse(text: &[u8]) -> Option<Self> {
        Self::leading(text).filter(|(_, rest)| rest.is_empty()).map(|(number, _)| number)
    }

    /// Reads the number that `text` begins with, and gives what comes after it; `None` when there is no digit.
    #[inline(always)]
    pub fn leading(text: &[u8]) -> Option<(Self, &[u8])> {
        let (minus, plus) = (text.first() == Some(&b'-'), text.first() == Some(&b'+'));
        let unsigned = text.get(usize::from(minus | plus)..)?;
        let Unsigned { magnitude, point, rounded, length } = Unsigned::read(unsigned)?;
        let value = Decimal::from_thousandths(if minus { -magnitude } else { magnitude });
        Some((Self { value, minus, plus, point, rounded }, unsigned.get(length..)?))
    }
}

/// A number without its sign.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
struct Unsigned {
    /// In thousandths.
    magnitude: i64,
    point: bool,
    rounded: bool,
    /// How many bytes it has.
    length: usize,
}

impl Unsigned {
    /// Reads the number that `text` begins with; `None` when there is no digit.
    #[inline]
    fn read(text: &[u8]) -> Option<Self> {
        let (value, whole) = leading_digits(text, usize::MAX);
        let magnitude = value * 1000;
        let Some(b'.') = text.get(whole) else {
            return (whole > 0).then_some(Self { magnitude, point: false, rounded: false, length: whole });
        };
        let decimals = text.get(whole + 1..)?;
        let (fraction, kept) = leading_digits(decimals, 3);
        let finer = decimals.get(kept..)?;
        let finer = finer.get(..leading_digits(finer, usize::MAX).1)?;
        let up = finer.first().is_some_and(|digit| *digit >= b'5');
        let magnitude = magnitude + fraction * scale(kept)? + i64::from(up);
        let rounded = finer.iter().any(|digit| *digit != b'0');
        let length = whole + 1 + kept + finer.len();
        (length > 1).then_some(Self { magnitude, point: true, rounded, length })
    }
}

/// How many thousandths the last of so many decimals counts; `None` when they are more than three.
#[inline]
fn scale(decimals: usize) -> Option<i64> {
    [1000, 100, 10, 1].get(decimals).copied()
}

/// The value of the digits that `text` begins with, at most so many, and at most [`HUGE`]; and how many they are.
#[inline]
fn leading_digits(text: &[u8], most: usize) -> (i64, usize) {
    let (mut value, mut count) = (0, 0);
    for byte in text.iter().take(most).take_while(|byte| byte.is_ascii_digit()) {
        value = (value * 10 + i64::from(byte - b'0')).min(HUGE);
        count += 1;
    }
    (value, count)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> Option<i64> {
        Number::parse(text.as_bytes()).map(|number| number.value.thousandths())
    }

    /// LEX-4, LEX-5.
    #[test]
    fn forms() {
        assert_eq!(value("384."), Some(384_000));
        assert_eq!(value(".12"), Some(120));
        assert_eq!(value("-0.5"), Some(-500));
        assert_eq!(value("+7"), Some(7000));
        for bad in ["", "-", ".", "-.", "1.2.3", "--5", "1-2", "1,5"] {
            assert_eq!(value(bad), None, "{bad}");
        }
    }

    /// ADR-2: to the nearest, halves away from zero.
    #[test]
    fn rounding() {
        assert_eq!(value("1.2345"), Some(1235));
        assert_eq!(value("-1.2345"), Some(-1235));
        assert_eq!(value("1.23449999"), Some(1234));
        assert!(!Number::parse(b"1.2340000").unwrap().rounded);
        assert!(Number::parse(b"1.2340001").unwrap().rounded);
        for end in ["", ".", ".5", ".1239"] {
            assert!(value(&("9".repeat(1000) + end)).unwrap() >= HUGE * 1000);
        }
    }
}
