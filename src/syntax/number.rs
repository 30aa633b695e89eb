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
    #[inline]
    pub fn parse(text: &[u8]) -> Option<Self> {
        let mut number = Self::default();
        let mut rest = text;
        match rest.split_first() {
            Some((b'-', after)) => (number.minus, rest) = (true, after),
            Some((b'+', after)) => (number.plus, rest) = (true, after),
            _ => {}
        }
        let (whole, after) = leading_digits(rest);
        let mut decimals: &[u8] = &[];
        match after.split_first() {
            None => {}
            Some((b'.', after)) => (number.point, decimals) = (true, after),
            Some(_) => return None,
        }
        if after.len() == rest.len() && decimals.is_empty() {
            return None;
        }
        let (first, rest) = decimals.split_at(decimals.len().min(3));
        let (fraction, after) = leading_digits(first);
        if !after.is_empty() {
            return None;
        }
        let mut magnitude = whole * 1000
            + match first.len() {
                0 => 0,
                1 => fraction * 100,
                2 => fraction * 10,
                _ => fraction,
            };
        if let Some(next) = rest.first() {
            if !rest.iter().all(u8::is_ascii_digit) {
                return None;
            }
            magnitude += i64::from(*next >= b'5');
            number.rounded = rest.iter().any(|digit| *digit != b'0');
        }
        number.value = Decimal::from_thousandths(if number.minus { -magnitude } else { magnitude });
        Some(number)
    }
}

/// The value of the digits that `text` begins with, at most [`HUGE`], and what comes after them.
#[inline]
fn leading_digits(text: &[u8]) -> (i64, &[u8]) {
    let mut value = 0;
    let mut rest = text;
    while let [byte @ b'0'..=b'9', after @ ..] = rest {
        value = (value * 10 + i64::from(byte - b'0')).min(HUGE);
        rest = after;
    }
    (value, rest)
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
        assert!(value(&"9".repeat(1000)).unwrap() >= HUGE * 1000);
    }
}
