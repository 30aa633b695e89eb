//! Numbers and words as hovers show them.

use crate::dict::{Address, Decimal, Lang, Micro, Operation};
use crate::resolve::ControlWord;
use crate::syntax::{Value, Word};

/// A count with its thousands apart: `2 000 000`.
pub(crate) fn count(number: u64) -> String {
    let digits = number.to_string();
    if digits.len() < 5 {
        return digits;
    }
    let mut shown = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            shown.push('\u{a0}');
        }
        shown.push(digit);
    }
    shown
}

/// To thousandths, the resolution of the control: for computed lengths.
pub(crate) fn rounded(value: Micro) -> String {
    let millionths = value.millionths();
    let thousandths = (millionths + if millionths < 0 { -500 } else { 500 }) / 1000;
    Decimal::from_thousandths(thousandths).to_string()
}

/// The unit of S.
pub(crate) const fn speed_unit(lang: Lang) -> &'static str {
    match lang {
        Lang::En => "rev/min",
        Lang::Cs => "ot/min",
    }
}

/// A word as one would write it: `G01`, `X -12.5 mm`, `R11 = -R10`.
pub(crate) fn word(word: Word, unit: &str) -> String {
    let letter = word.address.letter();
    let value = match word.value() {
        Value::None => return letter.to_owned(),
        Value::Parameter { index, negated } => format!("{}R{index}", if negated { "-" } else { "" }),
        Value::Number(number) => match (word.address, number.as_whole()) {
            (Address::G | Address::M, Some(whole)) => return format!("{letter}{whole:02}"),
            (Address::Correction, Some(whole)) => return format!("{letter}{whole:04}"),
            (
                Address::N | Address::Program | Address::L | Address::Q | Address::T | Address::D | Address::P,
                Some(whole),
            ) => {
                return format!("{letter}{whole}");
            }
            _ => number.to_string(),
        },
    };
    if word.address == Address::R {
        format!("R{} = {value}", word.target())
    } else if unit.is_empty() || word.is_parametric() {
        format!("{letter} {value}")
    } else {
        format!("{letter} {value} {unit}")
    }
}

/// `R12 = R10 + R11`
pub(crate) fn formula(control: ControlWord) -> String {
    let a = format!("R{}", control.first);
    let b = control.second.map_or(String::new(), |second| format!("R{second}"));
    let right = match control.operation {
        Operation::Add => format!("{a} + {b}"),
        Operation::Sub => format!("{a} − {b}"),
        Operation::Mul => format!("{a} · {b}"),
        Operation::Div => format!("{a} / {b}"),
        Operation::Neg => format!("−{a}"),
        Operation::Abs => format!("|{a}|"),
        Operation::Sqrt => format!("√{a}"),
        Operation::Copy => a,
        Operation::Atan2 | Operation::Mod | Operation::Min | Operation::Max => {
            format!("{}({a}, {b})", control.operation.name())
        }
        Operation::Sin
        | Operation::Cos
        | Operation::Tan
        | Operation::Asin
        | Operation::Acos
        | Operation::Atan
        | Operation::Round
        | Operation::Trunc => format!("{}({a})", control.operation.name()),
    };
    format!("R{} = {right}", control.result)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers() {
        let counts = [0, 999, 2000, 12_345, 2_000_000].map(count);
        assert_eq!(counts, ["0", "999", "2000", "12\u{a0}345", "2\u{a0}000\u{a0}000"]);
        let micro = Micro::from_millionths;
        assert_eq!(rounded(micro(1_234_567)), "1.235");
        assert_eq!(rounded(micro(-1_234_500)), "-1.235");
    }
}
