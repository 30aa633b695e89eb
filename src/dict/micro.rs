//! Numbers in millionths: what computed values become.

use super::Decimal;

/// A number of whole millionths: what a record shows of a length, an angle or a position. Programmed values are exact
/// in it; computed ones are rounded to it once.
#[derive(Clone, Copy, Debug, Default, Eq, Ord, PartialEq, PartialOrd)]
pub struct Micro(i64);

impl Micro {
    /// Zero.
    pub const ZERO: Self = Self(0);

    /// From millionths.
    pub const fn from_millionths(millionths: i64) -> Self {
        Self(millionths)
    }

    /// A computed value, rounded to six decimals, half of one away from zero. Saturates, and a NaN is 0: geometry gives
    /// neither for values of the language.
    pub fn from_f64(value: f64) -> Self {
        Self::from_millionths_f64(value * 1e6)
    }

    #[inline]
    fn from_millionths_f64(millionths: f64) -> Self {
        // `f64::round` is a call, and lengths of millions of blocks are rounded.
        #[expect(clippy::cast_possible_truncation, reason = "saturating, as wanted")]
        let whole = millionths as i64;
        #[expect(clippy::cast_precision_loss, reason = "what has more than 53 bits has no fraction")]
        let rest = millionths - whole as f64;
        Self(whole.saturating_add(i64::from(rest >= 0.5) - i64::from(rest <= -0.5)))
    }

    /// In millionths.
    pub const fn millionths(self) -> i64 {
        self.0
    }

    /// For geometry.
    pub fn to_f64(self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "positions have far fewer than 53 bits")]
        let value = self.0 as f64;
        value / 1e6
    }

    /// Its square, in millionths of a millionth.
    #[inline]
    pub fn square(self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "positions have far fewer than 53 bits")]
        let millionths = self.0 as f64;
        millionths * millionths
    }

    /// The length of a way, from the sum of the squares of its parts along the axes.
    #[inline]
    pub fn root(square: f64) -> Self {
        Self::from_millionths_f64(square.sqrt())
    }

    /// The sum; saturates far outside any machine.
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }

    /// The difference; saturates far outside any machine.
    #[must_use]
    pub const fn minus(self, other: Self) -> Self {
        Self(self.0.saturating_sub(other.0))
    }

    /// Without its sign.
    #[must_use]
    pub const fn abs(self) -> Self {
        Self(self.0.saturating_abs())
    }

    /// Rounded to thousandths: what people read of a computed length.
    #[must_use]
    pub const fn rounded(self) -> Self {
        Self((self.0.saturating_add(500)).div_euclid(1000).saturating_mul(1000))
    }

    /// A hundredth of it, exactly for every programmed value (TEC-6).
    #[must_use]
    pub const fn hundredth(self) -> Self {
        Self(self.0 / 100)
    }

    /// Half of it, exactly for every programmed value (MOT-1: diameters).
    #[must_use]
    pub const fn half(self) -> Self {
        Self(self.0 / 2)
    }
}

/// All decimals that are not zero: `12.5`, `-0.000001`, `3`.
impl std::fmt::Display for Micro {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (sign, value) = (if self.0 < 0 { "-" } else { "" }, self.0.unsigned_abs());
        let (whole, fraction) = (value / 1_000_000, format!("{:06}", value % 1_000_000));
        match fraction.trim_end_matches('0') {
            "" => write!(f, "{sign}{whole}"),
            fraction => write!(f, "{sign}{whole}.{fraction}"),
        }
    }
}

impl From<Decimal> for Micro {
    fn from(value: Decimal) -> Self {
        Self(value.thousandths().saturating_mul(1000))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn rounded(value: f64) -> Micro {
        #[expect(clippy::cast_possible_truncation, reason = "saturating, as wanted")]
        Micro((value * 1e6).round() as i64)
    }

    #[test]
    fn values_without_a_millionth() {
        for value in [0.0, -0.0, 4e-7, 5e-7, -5e-7, 1.5e-6, 1e300, -1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert_eq!(Micro::from_f64(value), rounded(value), "{value}");
        }
    }

    proptest! {
        #[test]
        fn a_value_is_rounded_to_the_nearest(value: f64, halves in -1_000_000_000_i32..1_000_000_000) {
            let half = f64::from(halves) / 2e6;
            for value in [value, half, half.next_down(), half.next_up()] {
                prop_assert_eq!(Micro::from_f64(value), rounded(value), "{}", value);
            }
        }
    }
}
