//! The axis letters of a program for a machine without configured axes (ADR-4).

use crate::config::Machine;
use crate::diag::Finding;
use crate::dict::{Address, AxisLetter};
use crate::syntax::ParsedFile;

/// The axis letters that a program uses, as far as the control has axes: the first different ones in the order of the text,
/// program before macrocycles. Every other one is one too many.
#[derive(Clone, Debug, Default)]
pub(super) struct Letters {
    known: Vec<AxisLetter>,
}

impl Letters {
    /// How many axis letters a program may use; `None` when the configuration names them, or the control has all of them.
    pub(super) fn limit(machine: &Machine) -> Option<usize> {
        let limit = machine.dialect.axes();
        (!machine.axes.are_configured() && limit < AxisLetter::ALL.len()).then_some(limit)
    }

    /// Takes note of the letters of a file.
    pub(super) fn read(&mut self, machine: &Machine, parsed: &ParsedFile) {
        let Some(limit) = Self::limit(machine) else { return };
        for letter in parsed.all_words().filter_map(|word| word.address.axis()) {
            if self.known.len() >= limit {
                return;
            }
            if !self.known.contains(&letter) {
                self.known.push(letter);
            }
        }
    }

    /// The addresses of axes that the control does not have, a bit for each [`Address`].
    pub(super) fn surplus(&self, machine: &Machine) -> u32 {
        let full = Self::limit(machine).is_some_and(|limit| self.known.len() >= limit);
        let is_surplus = |address: &Address| address.axis().is_some_and(|letter| !self.known.contains(&letter));
        Address::ALL.iter().filter(|address| full && is_surplus(address)).fold(0, |bits, address| bits | bit(*address))
    }

    /// The finding at a word of a letter that is one too many.
    pub(super) fn finding(&self, machine: &Machine, letter: AxisLetter) -> Finding {
        let axes = self.known.iter().map(AxisLetter::to_string).collect::<Vec<_>>().join(", ");
        Finding::UnknownAxis { axis: letter.letter(), axes, limit: Self::limit(machine) }
    }
}

/// The bit of an address in a set of them.
pub(super) const fn bit(address: Address) -> u32 {
    1 << (address as u8)
}
