//! Whether a value fits its address (§2, ADR-1, ADR-2, TEC-1). The same rules for values written out and for those that
//! parameters give.

use crate::config::Machine;
use crate::diag::{Diagnostic, LabelText};
use crate::dict::{Address, Decimal, GCode, GGroup, Lang, ValueForm, ValueRange, When};
use crate::syntax::{BlockId, ParsedFile, Word};

/// How a value does not fit.
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum FormFault {
    /// It has a fraction where the address takes whole numbers.
    Fraction,
    /// `&` takes four digits, each 0, 1 or 2.
    Digits,
    /// Outside the range, which is given for the message.
    Range(String),
}

/// The last function before a block that gives the unit of F, in the order of the text, and its word.
pub fn feed_mode_before(file: &ParsedFile, block: BlockId) -> Option<(GCode, Word)> {
    /// So many blocks are looked at.
    const BLOCKS: u32 = 1 << 10;
    let of_group = |word: &Word| word.g_code().filter(|code| code.group() == GGroup::G6).map(|code| (code, *word));
    let mut blocks = (block.0.saturating_sub(BLOCKS)..block.0).rev().map(BlockId);
    blocks.find_map(|block| file.words(block).iter().rev().find_map(of_group))
}

/// Adds a label at the function that gives the unit of F, when a block before has it.
pub fn with_feed_mode(diagnostic: Diagnostic, file: &ParsedFile, before: Option<(GCode, Word)>) -> Diagnostic {
    match before {
        Some((mode, word)) => {
            diagnostic.with_label(file.word_place(word), LabelText::InForce { function: mode.to_string() })
        }
        None => diagnostic,
    }
}

/// Checks `value` for `address`; `dwell`: Q is a dwell time; `feed`: the range that F must keep, none: not yet known.
///
/// # Errors
/// The first way in which it does not fit.
pub fn check_form(
    machine: &Machine,
    address: Address,
    value: Decimal,
    dwell: bool,
    feed: Option<GCode>,
) -> Result<(), FormFault> {
    let form = address.row().form;
    if !form.takes_point(machine.dialect) && !value.is_whole() {
        return Err(FormFault::Fraction);
    }
    match form {
        ValueForm::None => Ok(()),
        ValueForm::Dimension if value.abs() <= Decimal::DIMENSION_MAX => Ok(()),
        ValueForm::Parameter if value.fits_parameter() => Ok(()),
        ValueForm::Parameter => Err(FormFault::Range(format!("±{}, ±{}", Decimal::DIMENSION_MAX, Decimal::WHOLE_MAX))),
        ValueForm::Whole { .. }
        | ValueForm::Dimension
        | ValueForm::Feed
        | ValueForm::Auxiliary
        | ValueForm::Technological => {
            let per = feed.and_then(|function| machine.feed_mode(function)).map(|mode| mode.per);
            let holds = |range: &ValueRange| match range.when {
                When::Always => !(dwell && address == Address::Q),
                When::With(function) => dwell && function == GCode::G04,
                When::Feed(counted) => per.is_none_or(|per| per == counted),
            };
            let ranges = machine.ranges(address).into_iter().flatten().filter(holds);
            if ranges.clone().any(|range| range.contains(value)) {
                return Ok(());
            }
            let texts: Vec<String> = ranges.map(|range| range.text(Lang::En)).collect();
            Err(FormFault::Range(texts.join(", ")))
        }
        ValueForm::CorrectionDigits => {
            let digits = value.as_whole().unwrap_or(-1);
            let fits =
                (0..10_000).contains(&digits) && [1, 10, 100, 1000].into_iter().all(|unit| (digits / unit) % 10 <= 2);
            if fits { Ok(()) } else { Err(FormFault::Digits) }
        }
    }
}
