//! Parameter arithmetic: G26–G29 (PAR-7…PAR-10).

use crate::diag::ArithmeticFault;
use crate::dict::{Decimal, Operation};

/// Computes one operation. `whole`: whole-number arithmetic, operands and result rounded to whole numbers (PAR-8). All
/// but trigonometry is exact, then rounded, halves away from zero (§13 Parameters).
///
/// # Errors
/// What makes the result impossible, or its range (PAR-10).
pub(super) fn compute(
    operation: Operation,
    first: Decimal,
    second: Decimal,
    whole: bool,
) -> Result<Decimal, ArithmeticFault> {
    // Everything below counts in units of the mode: thousandths, or ones.
    let scale: i128 = if whole { 1 } else { 1000 };
    let unit = |value: Decimal| {
        let thousandths = i128::from(value.thousandths());
        if whole { divide(thousandths, 1000) } else { thousandths }
    };
    let (a, b) = (unit(first), unit(second));
    let degrees = |units: i128| units * (1000 / scale);
    let result = match operation {
        Operation::Add => a + b,
        Operation::Sub => a - b,
        Operation::Mul => divide(a * b, scale),
        Operation::Div | Operation::Mod if b == 0 => return Err(ArithmeticFault::DivisionByZero),
        Operation::Div => divide(a * scale, b),
        Operation::Mod => a % b,
        Operation::Neg => -a,
        Operation::Abs => a.abs(),
        Operation::Min => a.min(b),
        Operation::Max => a.max(b),
        Operation::Copy => a,
        Operation::Round => divide(a, scale) * scale,
        Operation::Trunc => a / scale * scale,
        Operation::Sqrt if a < 0 => {
            return Err(ArithmeticFault::NegativeRoot { operand: first.to_string() });
        }
        Operation::Sqrt => nearest_root(a * scale),
        Operation::Sin => of_sine(degrees(a), scale),
        Operation::Cos => of_sine(degrees(a) + 90_000, scale),
        Operation::Tan => {
            let angle = degrees(a).rem_euclid(180_000);
            if angle == 90_000 {
                return Err(ArithmeticFault::NoTangent { operand: first.to_string() });
            }
            scaled(if angle == 0 { 0.0 } else { libm::tan(radians(angle)) }, scale)
        }
        Operation::Asin | Operation::Acos if a.abs() > scale => {
            return Err(ArithmeticFault::NoAngle { operand: first.to_string() });
        }
        Operation::Asin => scaled(libm::asin(ratio(a, scale)).to_degrees(), scale),
        Operation::Acos => scaled(libm::acos(ratio(a, scale)).to_degrees(), scale),
        Operation::Atan => scaled(libm::atan(ratio(a, scale)).to_degrees(), scale),
        Operation::Atan2 => scaled(libm::atan2(ratio(a, scale), ratio(b, scale)).to_degrees(), scale),
    };
    let limit = if whole { Decimal::WHOLE_MAX } else { Decimal::DIMENSION_MAX };
    let thousandths = i64::try_from(result * (1000 / scale)).unwrap_or(i64::MAX);
    let value = Decimal::from_thousandths(thousandths);
    if value.abs() > limit {
        return Err(ArithmeticFault::ResultOutOfRange { result: value.to_string(), limit: limit.to_string() });
    }
    Ok(value)
}

/// The quotient, rounded, halves away from zero.
fn divide(dividend: i128, divisor: i128) -> i128 {
    let (quotient, remainder) = (dividend / divisor, dividend % divisor);
    if 2 * remainder.abs() >= divisor.abs() {
        quotient + if (dividend < 0) == (divisor < 0) { 1 } else { -1 }
    } else {
        quotient
    }
}

/// The whole number nearest to the root.
fn nearest_root(square: i128) -> i128 {
    let root = square.isqrt();
    if 4 * square >= (2 * root + 1) * (2 * root + 1) { root + 1 } else { root }
}

#[expect(clippy::cast_precision_loss, reason = "operands have far fewer than 53 bits")]
fn ratio(units: i128, scale: i128) -> f64 {
    units as f64 / scale as f64
}

#[expect(clippy::cast_possible_truncation, reason = "saturating; the range is checked after it")]
fn scaled(value: f64, scale: i128) -> i128 {
    (value * ratio(scale, 1)).round() as i128
}

/// The sine of an angle in thousandths of a degree, in units of the mode: to 0.001 as the control resolves it, so that
/// the half of 30° is one, then to whole numbers.
fn of_sine(thousandths: i128, scale: i128) -> i128 {
    divide(scaled(sine(thousandths), 1000), 1000 / scale)
}

fn radians(thousandths: i128) -> f64 {
    ratio(thousandths, 1000).to_radians()
}

/// The sine of an angle in thousandths of a degree; exact in the quadrants.
fn sine(thousandths: i128) -> f64 {
    match thousandths.rem_euclid(360_000) {
        0 | 180_000 => 0.0,
        90_000 => 1.0,
        270_000 => -1.0,
        angle => libm::sin(radians(angle)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn real(operation: Operation, a: i64, b: i64) -> Option<i64> {
        compute(operation, Decimal::from_thousandths(a), Decimal::from_thousandths(b), false)
            .ok()
            .map(Decimal::thousandths)
    }

    fn whole(operation: Operation, a: i64, b: i64) -> Option<i64> {
        compute(operation, Decimal::from_thousandths(a), Decimal::from_thousandths(b), true)
            .ok()
            .map(Decimal::thousandths)
    }

    /// PAR-8, PAR-10: exact, rounded halves away from zero.
    #[test]
    fn exact_operations() {
        assert_eq!(real(Operation::Add, 100, 200), Some(300));
        assert_eq!(real(Operation::Mul, 1500, 1001), Some(1502));
        assert_eq!(real(Operation::Mul, -1500, 1001), Some(-1502));
        assert_eq!(real(Operation::Div, 10_000, 3000), Some(3333));
        assert_eq!(real(Operation::Div, 1, 2000), Some(1));
        assert_eq!(real(Operation::Div, -1, 2000), Some(-1));
        assert_eq!(real(Operation::Div, 1, -2000), Some(-1));
        assert_eq!(real(Operation::Div, -1, -2000), Some(1));
        assert_eq!(real(Operation::Mod, -7000, 3000), Some(-1000));
        assert_eq!(real(Operation::Sqrt, 2000, 0), Some(1414));
        assert_eq!(real(Operation::Sqrt, 7000, 0), Some(2646));
        assert_eq!(real(Operation::Sqrt, 0, 0), Some(0));
        assert_eq!(real(Operation::Round, -2500, 0), Some(-3000));
        assert_eq!(real(Operation::Trunc, -2900, 0), Some(-2000));
        assert_eq!(whole(Operation::Div, 10_000, 4000), Some(3000));
        assert_eq!(whole(Operation::Add, 400, 1500), Some(2000));
    }

    #[test]
    fn angles() {
        assert_eq!(real(Operation::Sin, 30_000, 0), Some(500));
        assert_eq!(real(Operation::Cos, 90_000, 0), Some(0));
        assert_eq!(real(Operation::Cos, 60_000, 0), Some(500));
        assert_eq!(real(Operation::Tan, 45_000, 0), Some(1000));
        assert_eq!(real(Operation::Atan2, 1000, -1000), Some(135_000));
        assert_eq!(real(Operation::Acos, -1000, 0), Some(180_000));
        assert_eq!(real(Operation::Asin, 500, 0), Some(30_000));
    }

    /// PAR-8: the halves of sine and cosine are rounded away from zero.
    #[test]
    fn whole_sines() {
        for (operation, degrees, expected) in [
            (Operation::Sin, 30, 1),
            (Operation::Sin, 150, 1),
            (Operation::Sin, -30, -1),
            (Operation::Sin, 29, 0),
            (Operation::Cos, 60, 1),
            (Operation::Cos, 120, -1),
            (Operation::Cos, 300, 1),
            (Operation::Cos, 90, 0),
        ] {
            assert_eq!(whole(operation, degrees * 1000, 0), Some(expected * 1000), "{operation:?} {degrees}");
        }
    }

    #[test]
    fn faults() {
        assert_eq!(real(Operation::Div, 1, 0), None);
        assert_eq!(real(Operation::Mod, 1, 0), None);
        assert_eq!(real(Operation::Sqrt, -1, 0), None);
        assert_eq!(real(Operation::Tan, 270_000, 0), None);
        assert_eq!(real(Operation::Asin, 1001, 0), None);
        assert_eq!(real(Operation::Mul, 69_999_000, 2000), None);
        assert_eq!(whole(Operation::Mul, 69_999_000, 2000), Some(139_998_000));
        assert_eq!(real(Operation::Copy, 70_000_000, 0), None);
    }
}
