//! A number in JSON objects, and its digits.

use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use crate::dict::{Decimal, Micro};

/// A number with at most six decimals; whole ones without a point.
#[derive(Clone, Copy, Debug, JsonSchema)]
#[schemars(inline)]
pub struct Number(#[schemars(with = "f64")] pub Micro);

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0.millionths() % 1_000_000 == 0 {
            serializer.serialize_i64(self.0.millionths() / 1_000_000)
        } else {
            serializer.serialize_f64(self.0.to_f64())
        }
    }
}

impl From<Decimal> for Number {
    fn from(value: Decimal) -> Self {
        Self(value.into())
    }
}

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        Self(Micro::from_f64(value))
    }
}

/// A number of millionths without exponent and trailing zeros.
pub fn write_real(millionths: i64, out: &mut String) {
    let magnitude = millionths.unsigned_abs();
    if millionths < 0 {
        out.push('-');
    }
    push_digits(magnitude / 1_000_000, 1, out);
    let fraction = magnitude % 1_000_000;
    if fraction > 0 {
        out.push('.');
        push_digits(fraction, 6, out);
        out.truncate(out.trim_end_matches('0').len());
    }
}

/// Decimal digits, at least so many.
pub fn push_digits(number: u64, least: usize, out: &mut String) {
    let mut digits = itoa::Buffer::new();
    let digits = digits.format(number);
    (digits.len()..least).for_each(|_| out.push('0'));
    out.push_str(digits);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals_are_written_exactly() {
        for millionths in
            (-2_000_003..2_000_003).step_by(977).chain([i64::MAX, i64::MIN, 999_999, 1_000_000, 1_001_001])
        {
            let mut text = String::new();
            write_real(millionths, &mut text);
            let sign = if millionths < 0 { "-" } else { "" };
            let (whole, part) = (millionths.unsigned_abs() / 1_000_000, millionths.unsigned_abs() % 1_000_000);
            let long = format!("{sign}{whole}.{part:06}");
            assert_eq!(text, long.trim_end_matches('0').trim_end_matches('.'));
        }
    }

    #[test]
    fn digits() {
        for number in [0, 9, 10, 4_294_967_295, u64::MAX] {
            let mut digits = String::new();
            push_digits(number, 1, &mut digits);
            assert_eq!(digits, number.to_string());
        }
    }
}
