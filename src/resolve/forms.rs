//! Whether a value fits its address (§2, ADR-1, ADR-2, TEC-1). The same rules for values written out and for those that
//! parameters give.

use super::blocks::g_code;
use crate::config::Machine;
use crate::dict::{Address, Decimal, FEED_PER_REVOLUTION, GCode, GGroup, ValueForm};
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

/// The last function that says the unit of F before a block, in the order of the text, and its word.
pub fn feed_mode_before(file: &ParsedFile, block: BlockId) -> Option<(GCode, Word)> {
    /// So many blocks are looked at.
    const BLOCKS: u32 = 1 << 10;
    let of_group = |word: &Word| g_code(*word).filter(|code| code.group() == GGroup::G6).map(|code| (code, *word));
    let mut blocks = (block.0.saturating_sub(BLOCKS)..block.0).rev().map(BlockId);
    blocks.find_map(|block| file.words(block).iter().rev().find_map(of_group))
}

/// The range of F that counts: by the G6 function in force, or both when that is not known (TEC-1).
pub fn feed_range(machine: &Machine, mode: Option<GCode>) -> (Decimal, Decimal) {
    let per_revolution = FEED_PER_REVOLUTION;
    let per_minute = (Decimal::whole(1), machine.limits.feed);
    match mode {
        Some(mode) if machine.feeds_per_revolution(mode) => per_revolution,
        Some(_) => per_minute,
        None => (per_revolution.0, per_revolution.1.max(per_minute.1)),
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
    let within = |min: Decimal, max: Decimal, unit: &str| {
        if min <= value && value <= max { Ok(()) } else { Err(FormFault::Range(format!("{min}–{max}{unit}"))) }
    };
    let dimension = |unit: &str| {
        if value.abs() <= Decimal::DIMENSION_MAX {
            Ok(())
        } else {
            Err(FormFault::Range(format!("±{}{unit}", Decimal::DIMENSION_MAX)))
        }
    };
    match form {
        ValueForm::None => Ok(()),
        ValueForm::Whole { max, .. } if dwell && address == Address::Q => {
            within(Decimal::ZERO, Decimal::whole(max), " × 10 ms")
        }
        ValueForm::Whole { min, max } => {
            let speed = (i64::from(machine.limits.speed), " rev/min");
            let (max, unit) = if address == Address::S { speed } else { (max, "") };
            within(Decimal::whole(min), Decimal::whole(max), unit)
        }
        ValueForm::Dimension => {
            let axis = address.axis().and_then(|letter| machine.axes.index(letter));
            let rotary = axis.and_then(|axis| machine.axes.get(axis)).is_some_and(|axis| axis.rotary);
            dimension(if rotary { "°" } else { " mm" })
        }
        ValueForm::Auxiliary if form.takes_point(machine.dialect) => dimension(""),
        ValueForm::Auxiliary => within(Decimal::whole(1), Decimal::whole(99), ""),
        ValueForm::Technological => within(Decimal::ZERO, Decimal::whole(i64::from(machine.dialect.highest_m())), ""),
        ValueForm::Parameter if value.fits_parameter() => Ok(()),
        ValueForm::Parameter => Err(FormFault::Range(format!("±{}, ±{}", Decimal::DIMENSION_MAX, Decimal::WHOLE_MAX))),
        ValueForm::Feed => {
            let (min, max) = feed_range(machine, feed);
            let unit = match feed {
                Some(mode) if machine.feeds_per_revolution(mode) => " mm/rev",
                Some(_) => " mm/min",
                None if min <= value && value <= max => "",
                None => {
                    let range = |mode: GCode, unit: &str| {
                        let (min, max) = feed_range(machine, Some(mode));
                        format!("{min}–{max} {unit}")
                    };
                    let (minute, revolution) = (range(GCode::G94, "mm/min"), range(GCode::G95, "mm/rev"));
                    return Err(FormFault::Range(format!("{minute}, {revolution}")));
                }
            };
            within(min, max, unit)
        }
        ValueForm::CorrectionDigits => {
            let digits = value.as_whole().unwrap_or(-1);
            let fits =
                (0..10_000).contains(&digits) && [1, 10, 100, 1000].into_iter().all(|unit| (digits / unit) % 10 <= 2);
            if fits { Ok(()) } else { Err(FormFault::Digits) }
        }
    }
}
