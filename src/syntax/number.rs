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
    #[inline]
    pub fn leading(text: &[u8]) -> Option<(Self, &[u8])> {
        let mut number = Self::default();
        let unsigned = match text {
            [b'-', after @ ..] => {
                number.minus = true;
                after
            }
            [b'+', after @ ..] => {
                number.plus = true;
                after
            }
            _ => text,
        };
        let (whole, mut rest) = leading_digits(unsigned);
        let has_whole = rest.len() < unsigned.len();
        let mut magnitude = whole * 1000;
        if let [b'.', decimals @ ..] = rest {
            number.point = true;
            let first = decimals.get(..3).unwrap_or(decimals);
            let (fraction, not_digits) = leading_digits(first);
            let count = first.len() - not_digits.len();
            if !has_whole && count == 0 {
                return None;
            }
            magnitude += match count {
                0 => 0,
                1 => fraction * 100,
                2 => fraction * 10,
                _ => fraction,
            };
            rest = decimals.get(count..).unwrap_or_default();
            if let (3, [digit @ b'0'..=b'9', ..]) = (count, rest) {
                magnitude += i64::from(*digit >= b'5');
                let more = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
                let (dropped, after) = rest.split_at(more);
                number.rounded = dropped.iter().any(|digit| *digit != b'0');
                rest = after;
            }
        } else if !has_whole {
            return None;
        }
        number.value = Decimal::from_thousandths(if number.minus { -magnitude } else { magnitude });
        Some((number, rest))
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
