//! Exact decimal numbers from text: of `--param` and of the project file. No binary fraction ever stands between the
//! written digits and the [`Decimal`].

use crate::dict::{Bilingual, Decimal, Lang};

/// Digits of thousandths that surely fit an `i64`; what has more saturates, far outside any range of the language.
const MOST_DIGITS: usize = 18;

/// The number that `text` writes: optional sign, digits with an optional point among, before or behind them, optional
/// exponent (`1.5e3`). What is finer than 0.001 is rounded, halves away from zero (ADR-2). What is too large for a
/// [`Decimal`] becomes its largest, so that every range check refuses it.
///
/// `None` when the text is no such number.
pub fn parse_decimal(text: &str) -> Option<Decimal> {
    parse_rounding(text).map(|(number, _)| number)
}

/// A position as somebody types it: at most three decimals, within the range of axis words.
pub fn parse_position(text: &str) -> Option<Decimal> {
    let fits = |(number, exact): &(Decimal, bool)| *exact && number.abs() <= Decimal::DIMENSION_MAX;
    parse_rounding(text).filter(fits).map(|(number, _)| number)
}

/// As [`parse_decimal`], and whether the number is exactly the written one.
pub(super) fn parse_rounding(text: &str) -> Option<(Decimal, bool)> {
    let (negative, unsigned) = match text.strip_prefix(['+', '-']) {
        Some(rest) => (text.starts_with('-'), rest),
        None => (false, text),
    };
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, parse_exponent(exponent)?),
        None => (unsigned, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all_digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    if (whole.is_empty() && fraction.is_empty()) || !all_digits(whole) || !all_digits(fraction) {
        return None;
    }
    let digits: Vec<u8> =
        whole.bytes().chain(fraction.bytes()).skip_while(|&digit| digit == b'0').map(|digit| digit - b'0').collect();
    let fraction_digits = i64::try_from(fraction.len()).unwrap_or(i64::MAX);
    let shift = exponent.saturating_sub(fraction_digits).saturating_add(3);
    let thousandths = shifted(&digits, shift);
    let dropped = usize::try_from(shift.saturating_neg()).unwrap_or(0);
    let exact = digits.iter().rev().take(dropped).all(|&digit| digit == 0);
    Some((Decimal::from_thousandths(if negative { -thousandths } else { thousandths }), exact))
}

/// The exponent, saturated: beyond a few thousand every number is zero or too large alike.
fn parse_exponent(text: &str) -> Option<i64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let limit = i64::MAX / 4;
    let magnitude = digits.parse::<i64>().map_or(limit, |value| value.min(limit));
    Some(if text.starts_with('-') { -magnitude } else { magnitude })
}

/// The number of these digits (the first is not 0) times ten to the power `shift`, rounded, halves up; saturated.
fn shifted(digits: &[u8], shift: i64) -> i64 {
    if digits.is_empty() {
        return 0;
    }
    let length = i64::try_from(digits.len()).unwrap_or(i64::MAX).saturating_add(shift);
    let Ok(kept) = usize::try_from(length) else {
        return 0;
    };
    if kept > MOST_DIGITS {
        return i64::MAX;
    }
    let value = (0..kept).fold(0_i64, |value, at| value * 10 + i64::from(digits.get(at).copied().unwrap_or(0)));
    value + i64::from(digits.get(kept).is_some_and(|&dropped| dropped >= 5))
}

/// Why the text of `--param` is not taken.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum ParameterFault {
    /// It does not have the form `R10=5`.
    Form,
    /// There is no such parameter (§4).
    Number,
    /// A parameter cannot hold the value (§2).
    Value,
    /// The value is finer than 0.001 (ADR-2).
    Finer,
}

impl ParameterFault {
    /// The mistake, in `lang`, without the given text.
    pub const fn text(self, lang: Lang) -> &'static str {
        let text = match self {
            Self::Form => Bilingual {
                en: "a parameter is given as `R10=5` or `R10=-2.5`",
                cs: "parametr se zadává jako R10=5 nebo R10=-2.5",
            },
            Self::Number => Bilingual { en: "there are parameters R0 to R95", cs: "jsou jen parametry R0 až R95" },
            Self::Value => Bilingual {
                en: "a parameter takes a number within ±69999.999, or a whole number of up to eight digits",
                cs: "hodnota parametru je číslo v rozsahu ±69999.999, nebo celé číslo nejvýše o osmi číslicích",
            },
            Self::Finer => Bilingual {
                en: "a parameter has three decimals at most",
                cs: "hodnota parametru má nejvýše tři desetinná místa",
            },
        };
        text.get(lang)
    }
}

/// Highest number of a parameter (§4).
pub(super) const HIGHEST_PARAMETER: u16 = 95;

/// The parameter and value of `--param R10=5`: R0–R95 in either case, `=`, a number without exponent; blanks may stand
/// around both sides.
///
/// # Errors
/// [`ParameterFault`], by what is wrong first.
pub fn parse_parameter(text: &str) -> Result<(u8, Decimal), ParameterFault> {
    let (name, value) = text.split_once('=').ok_or(ParameterFault::Form)?;
    let number = name.trim().strip_prefix(['R', 'r']).ok_or(ParameterFault::Form)?;
    if number.is_empty() || !number.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(ParameterFault::Form);
    }
    let number = number
        .parse::<u8>()
        .ok()
        .filter(|&number| u16::from(number) <= HIGHEST_PARAMETER)
        .ok_or(ParameterFault::Number)?;
    let value = value.trim();
    if value.contains(['e', 'E']) {
        return Err(ParameterFault::Form);
    }
    let (value, exact) = parse_rounding(value).ok_or(ParameterFault::Form)?;
    match (value.fits_parameter(), exact) {
        (true, true) => Ok((number, value)),
        (true, false) => Err(ParameterFault::Finer),
        (false, _) => Err(ParameterFault::Value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thousandths(text: &str) -> Option<i64> {
        parse_decimal(text).map(Decimal::thousandths)
    }

    #[test]
    fn exact_digits() {
        for (text, expected) in [
            ("0", 0),
            ("-0.0", 0),
            ("25.5", 25_500),
            ("+.5", 500),
            ("5.", 5_000),
            ("000012", 12_000),
            ("69999.999", 69_999_999),
            ("1.5e3", 1_500_000),
            ("15E-4", 2),
            ("-15e-4", -2),
            ("1e-400", 0),
            ("0e999999999999999999999", 0),
            ("0.1", 100),
            ("16777216.001", 16_777_216_001),
        ] {
            assert_eq!(thousandths(text), Some(expected), "{text}");
        }
    }

    /// ADR-2: halves away from zero, decided by the written digits.
    #[test]
    fn finer_than_the_resolution_is_rounded() {
        for (text, expected) in [
            ("0.0005", 1),
            ("-0.0005", -1),
            ("0.0004999999999999999999999", 0),
            ("0.00049", 0),
            ("1.0015", 1_002),
            ("69999.9995", 70_000_000),
            ("0.00005", 0),
            ("0.9999", 1_000),
        ] {
            assert_eq!(thousandths(text), Some(expected), "{text}");
        }
    }

    #[test]
    fn too_large_saturates() {
        for text in ["1e400", "999999999999999999999", "1e99999999999999999999999"] {
            assert_eq!(thousandths(text), Some(i64::MAX), "{text}");
        }
        assert_eq!(thousandths("-1e400"), Some(-i64::MAX));
        let long = "9".repeat(1_000_000);
        assert_eq!(thousandths(&long), Some(i64::MAX));
    }

    #[test]
    fn what_is_no_number() {
        for text in ["", "-", ".", "+.", "1.2.3", "1,5", "e5", "1e", "1e+", "--1", "1_0", "inf", "nan", " 1", "1 ", "١"]
        {
            assert_eq!(thousandths(text), None, "{text}");
        }
    }

    /// PAR-5: `--param R10=5`.
    #[test]
    fn parameters_of_the_command_line() {
        assert_eq!(parse_parameter("R10=5"), Ok((10, Decimal::whole(5))));
        assert_eq!(parse_parameter(" r095 = -2.5 "), Ok((95, Decimal::from_thousandths(-2_500))));
        assert_eq!(parse_parameter("R0=99999999"), Ok((0, Decimal::WHOLE_MAX)));
        for text in ["", "R10", "10=5", "R=5", "R1=", "R1=x", "R1=5,5", "R1=1e3", "R1=R2", "R-1=5", "R1==5", "P1=5"] {
            assert_eq!(parse_parameter(text), Err(ParameterFault::Form), "{text}");
        }
        for text in ["R96=5", "R256=5", "R99999999999=5"] {
            assert_eq!(parse_parameter(text), Err(ParameterFault::Number), "{text}");
        }
        for text in ["R1=100000000", "R1=70000.5", "R1=-99999999.5"] {
            assert_eq!(parse_parameter(text), Err(ParameterFault::Value), "{text}");
        }
        for text in ["R1=0.0001", "R1=-5.1234", "R1=0.0000000000000000001"] {
            assert_eq!(parse_parameter(text), Err(ParameterFault::Finer), "{text}");
        }
        assert_eq!(parse_parameter("R1=0.50000"), Ok((1, Decimal::from_thousandths(500))));
    }

    #[test]
    fn faults_speak_both_languages() {
        assert!(ParameterFault::Form.text(Lang::En).contains("R10=5"));
        assert!(ParameterFault::Number.text(Lang::Cs).contains("až R95"));
        assert!(ParameterFault::Value.text(Lang::Cs).contains("osmi"));
    }
}
