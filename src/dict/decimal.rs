//! Exact numbers in thousandths, the resolution of the control (ADR-2).

use std::fmt;

/// A number of whole thousandths: millimetres, degrees, or a plain number, by the address that carries it.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, Ord, PartialEq, PartialOrd)]
pub struct Decimal(i64);

impl Decimal {
    /// Zero.
    pub const ZERO: Self = Self(0);
    /// Largest value of a dimensional word: 69999.999.
    pub const DIMENSION_MAX: Self = Self(69_999_999);
    /// Largest whole value of a parameter: 99999999.
    pub const WHOLE_MAX: Self = Self::whole(99_999_999);

    /// From a whole number; saturates far outside any range of the language.
    pub const fn whole(value: i64) -> Self {
        Self(value.saturating_mul(1000))
    }

    /// From thousandths.
    pub const fn from_thousandths(thousandths: i64) -> Self {
        Self(thousandths)
    }

    /// In thousandths.
    pub const fn thousandths(self) -> i64 {
        self.0
    }

    /// The number when it has no fraction.
    pub const fn as_whole(self) -> Option<i64> {
        if self.0 % 1000 == 0 { Some(self.0 / 1000) } else { None }
    }

    /// Whether the number has no fraction.
    pub const fn is_whole(self) -> bool {
        self.0 % 1000 == 0
    }

    /// Without its sign.
    pub const fn abs(self) -> Self {
        Self(self.0.saturating_abs())
    }

    /// With the sign changed.
    #[must_use]
    pub const fn negated(self) -> Self {
        Self(self.0.saturating_neg())
    }

    /// Whether a parameter can hold it: a whole number of up to eight digits, or ±69999.999 (§2, §13 Parameters).
    pub const fn fits_parameter(self) -> bool {
        let magnitude = self.0.saturating_abs();
        magnitude <= Self::DIMENSION_MAX.0 || (self.is_whole() && magnitude <= Self::WHOLE_MAX.0)
    }
}

impl fmt::Display for Decimal {
    /// Without trailing zeros and without a point when whole: `25.5`, `-0.012`, `300`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let magnitude = self.0.unsigned_abs();
        let sign = if self.0 < 0 { "-" } else { "" };
        let (whole, fraction) = (magnitude / 1000, magnitude % 1000);
        if fraction == 0 {
            return write!(f, "{sign}{whole}");
        }
        let digits = format!("{fraction:03}");
        write!(f, "{sign}{whole}.{}", digits.trim_end_matches('0'))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shown_without_trailing_zeros() {
        for (thousandths, shown) in [(0, "0"), (25_500, "25.5"), (-12, "-0.012"), (300_000, "300"), (-1, "-0.001")] {
            assert_eq!(Decimal::from_thousandths(thousandths).to_string(), shown);
        }
    }

    #[test]
    fn what_a_parameter_holds() {
        assert!(Decimal::DIMENSION_MAX.fits_parameter());
        assert!(Decimal::WHOLE_MAX.negated().fits_parameter());
        assert!(!Decimal::from_thousandths(70_000_001).fits_parameter());
        assert!(!Decimal::whole(100_000_000).fits_parameter());
    }
}
