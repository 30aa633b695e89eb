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
        let mut number = Self::default();
        let mut rest = text;
        match rest.split_first() {
            Some((b'-', after)) => (number.minus, rest) = (true, after),
            Some((b'+', after)) => (number.plus, rest) = (true, after),
            _ => {}
        }
        let mut whole: i64 = 0;
        let mut thousandths: i64 = 0;
        let mut digits = 0_usize;
        let mut decimals = 0_usize;
        let (mut round_up, mut dropped) = (false, false);
        for &byte in rest {
            match byte {
                b'0'..=b'9' => {
                    let digit = i64::from(byte - b'0');
                    digits += 1;
                    if !number.point {
                        whole = (whole * 10 + digit).min(HUGE);
                    } else {
                        match decimals {
                            0..3 => thousandths = thousandths * 10 + digit,
                            3 => {
                                round_up = digit >= 5;
                                dropped = digit != 0;
                            }
                            _ => dropped |= digit != 0,
                        }
                        decimals += 1;
                    }
                }
                b'.' if !number.point => number.point = true,
                _ => return None,
            }
        }
        if digits == 0 {
            return None;
        }
        for _ in decimals..3 {
            thousandths *= 10;
        }
        let magnitude = whole * 1000 + thousandths + i64::from(round_up);
        number.rounded = dropped;
        number.value = Decimal::from_thousandths(if number.minus { -magnitude } else { magnitude });
        Some(number)
    }
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
