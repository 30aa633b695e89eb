//! Control words of the arithmetic functions G26 to G29, taken apart (PAR-8, PAR-9).

use crate::config::Machine;
use crate::diag::Finding;
use crate::dict::{Decimal, HIGHEST_PARAMETER, Operation};

/// A control word taken apart (PAR-8).
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct ControlWord {
    /// The operation.
    pub operation: Operation,
    /// The parameter that is the first operand.
    pub first: u8,
    /// The one that is the second, when the operation has two.
    pub second: Option<u8>,
    /// The one that takes the result.
    pub result: u8,
    /// `-`: whole-number arithmetic.
    pub whole: bool,
}

/// Takes a control word apart (PAR-8, PAR-9).
///
/// # Errors
/// A fault of its form, its operation, or a field, in this order.
pub fn control_word(machine: &Machine, value: Decimal) -> Result<ControlWord, Finding> {
    let whole = value.as_whole().filter(|_| value.abs() <= Decimal::WHOLE_MAX);
    let Some(whole) = whole else { return Err(Finding::MalformedControlWord { field: None }) };
    let digits = whole.abs();
    let operation_code = digits / 1_000_000;
    let operation = u8::try_from(operation_code).ok().and_then(|code| machine.operations.get(&code)).copied();
    let Some(operation) = operation else {
        return Err(Finding::UnknownOperation { operation: operation_code, digits, written: 0 });
    };
    let field = |unit: i64| {
        let field = (digits / unit) % 100;
        match u8::try_from(field) {
            Ok(parameter) if parameter <= HIGHEST_PARAMETER => Ok(parameter),
            _ => Err(Finding::MalformedControlWord { field: Some(field) }),
        }
    };
    let first = field(10_000)?;
    let second = if operation.takes_two() { Some(field(100)?) } else { None };
    let result = field(1)?;
    Ok(ControlWord { operation, first, second, result, whole: whole < 0 })
}

/// The parameter that receives the result of a control word, also of one that is wrong elsewhere; `None` when that
/// cannot be told (§13).
pub fn control_result(value: Decimal) -> Option<u8> {
    let whole = value.as_whole().filter(|_| value.abs() <= Decimal::WHOLE_MAX)?;
    u8::try_from(whole.abs() % 100).ok().filter(|parameter| *parameter <= HIGHEST_PARAMETER)
}
