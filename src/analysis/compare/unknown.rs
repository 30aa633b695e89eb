//! What tells values apart that nobody knows: the parameters of the machine that they come from.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};

use super::steps::Value;
use crate::dict::{Address, AxisLetter, FIRST_CONTROL, GCode, GGroup};
use crate::resolve::control_word;
use crate::run::{Executed, FeedUnit, MotionType};
use crate::syntax::{Value as WordValue, Word};

/// A longer description of a value is its hash.
const LONGEST: usize = 80;

/// Follows an execution.
#[derive(Debug, Default)]
pub(super) struct Unknowns {
    /// Of parameters that were assigned, and whose values are not known: what these were computed from.
    from: BTreeMap<u8, String>,
    /// What was told last, by address.
    told: BTreeMap<Address, String>,
}

impl Unknowns {
    /// Follows what a block assigns to parameters.
    pub fn assign(&mut self, block: &Executed<'_>) {
        if block.opaque_call().is_some() {
            self.from.clear();
        }
        for word in block.source_words().iter().copied().filter(|word| word.address == Address::R) {
            if let WordValue::Parameter { index, negated } = word.value() {
                let from = self.source(block, index, negated);
                self.from.insert(word.target(), from);
            }
        }
        let operations = block.g_written().map(GCode::operations).max().unwrap_or(0);
        for control in (FIRST_CONTROL..).take(operations) {
            let Some(value) = block.parameter(control) else { continue };
            let Ok(word) = control_word(&block.settings().machine, value) else { continue };
            let operand = |index: u8| self.source(block, index, false);
            let second = word.second.map_or_else(String::new, operand);
            let operation = value.as_whole().unwrap_or_default() / 1_000_000;
            let from = format!("({operation} {} {second})", operand(word.first));
            self.from.insert(word.result, shortened(from));
        }
    }

    /// What the word that is in force of an address comes from; empty where its value is known.
    pub fn told(&self, address: Address) -> &str {
        self.told.get(&address).map_or("", String::as_str)
    }

    /// Whether words without known values are in force.
    pub fn has_told(&self) -> bool {
        !self.told.is_empty()
    }

    /// A parameter as a value: known, or what it comes from.
    fn source(&self, block: &Executed<'_>, index: u8, negated: bool) -> String {
        let known = block.parameter(index).map(|value| value.to_string());
        let from = known.or_else(|| self.from.get(&index).cloned()).unwrap_or_else(|| format!("R{index}"));
        match from.strip_prefix('-') {
            _ if !negated => from,
            Some(positive) => positive.to_owned(),
            None => format!("-{from}"),
        }
    }

    /// The words of a block whose values are not known, with what these come from; a repetition of what lasts is none.
    pub fn words(&mut self, block: &Executed<'_>) -> Vec<(Address, String)> {
        let returns = block.motion().is_some_and(|motion| motion.kind() == MotionType::Reference);
        let mut found = Vec::new();
        for word in block.source_words().iter().copied().filter(|word| word.address != Address::R) {
            let axis = word.address.axis();
            let unknown = match word.value() {
                WordValue::Parameter { index, negated } => Some((index, negated)),
                WordValue::Number(_) | WordValue::None => None,
            };
            let Some((index, negated)) = unknown.filter(|(index, _)| block.parameter(*index).is_none()) else {
                self.told.remove(&word.address);
                continue;
            };
            if returns && axis.is_some() {
                continue;
            }
            let mut from = self.source(block, index, negated);
            // The same number goes elsewhere by distance and as a diameter.
            let by_distance = axis.is_some() && block.g(GGroup::G9) == Some(GCode::G91);
            if by_distance {
                from.insert_str(0, "G91 ");
            }
            if axis == Some(AxisLetter::X) && block.g(GGroup::G10) == Some(GCode::G74) {
                from.insert_str(0, "G74 ");
            }
            let unit =
                Some(block.feed_unit()).filter(|unit| word.address == Address::F && *unit != FeedUnit::MmPerMinute);
            if let Some(unit) = unit {
                from = format!("{from} {}", unit.name());
            }
            let known = self.told.insert(word.address, from.clone());
            if by_distance || !lasts(word.address) || known.as_ref() != Some(&from) {
                found.push((word.address, from));
            }
        }
        found
    }
}

/// Whether the value of a word holds until the next one of its address.
const fn lasts(address: Address) -> bool {
    use Address::{Correction, D, F, H, P, S, T};
    address.axis().is_some() || matches!(address, F | S | T | D | H | P | Correction)
}

/// Whether nobody knows what the axis words of a block do, because a function of it is not known.
pub(super) fn is_unclear(block: &Executed<'_>) -> bool {
    let other = block.motion().is_some() || block.data().is_some() || block.is_unmapped_cycle();
    !other && !block.moves_on() && block.source_words().iter().any(|word| word.address.axis().is_some())
}

/// The axes and centre words of a block as written, where no motion says what they do.
pub(super) fn as_written(block: &Executed<'_>) -> Vec<(Address, Value)> {
    let lost_centre = block
        .motion()
        .is_some_and(|motion| motion.arc().is_some_and(|arc| arc.center.is_none() && arc.to_center.is_none()));
    let unclear = is_unclear(block);
    let centre = |address: Address| matches!(address, Address::I | Address::J | Address::K);
    let wanted =
        |word: &Word| unclear && word.address.axis().is_some() || (unclear || lost_centre) && centre(word.address);
    let value = |word: Word| match word.value() {
        WordValue::Number(number) => Some(number),
        WordValue::Parameter { index, negated } => {
            block.parameter(index).map(|value| if negated { value.negated() } else { value })
        }
        WordValue::None => None,
    };
    block
        .source_words()
        .iter()
        .copied()
        .filter(wanted)
        .filter_map(|word| Some((word.address, Value::from(value(word)?))))
        .collect()
}

fn shortened(text: String) -> String {
    if text.len() <= LONGEST {
        return text;
    }
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    format!("#{:016x}", hasher.finish())
}
