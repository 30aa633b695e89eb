//! The axis letters of a program for a machine without configured axes (ADR-4).

use crate::config::Machine;
use crate::diag::Finding;
use crate::dict::{Address, AxisLetter};
use crate::syntax::ParsedFile;

/// How many axes the control has beside X, Y and Z, where it has not room for all letters.
const BESIDE: usize = 3;

/// The axis letters beside X, Y and Z that a program uses, as far as the control has axes: the first different ones in
/// the order of the text, program before macrocycles. Every other one is one too many, and so is the third where none
/// of the three is one that the sixth axis may have.
#[derive(Clone, Debug, Default)]
pub(super) struct AxisLetters {
    beside: Vec<AxisLetter>,
}

impl AxisLetters {
    /// Whether a program may not use all letters: the control has too few axes, and the configuration does not name
    /// them.
    pub(super) fn are_limited(machine: &Machine) -> bool {
        !machine.axes.are_configured() && machine.dialect.axes() < AxisLetter::ALL.len()
    }

    /// Takes note of the letters of a file.
    pub(super) fn read(&mut self, machine: &Machine, parsed: &ParsedFile) {
        if !Self::are_limited(machine) {
            return;
        }
        for letter in parsed.all_words().filter_map(|word| word.address.axis()) {
            if self.beside.len() >= BESIDE {
                return;
            }
            if !letter.is_of_the_planes() && !self.beside.contains(&letter) {
                self.beside.push(letter);
            }
        }
    }

    /// Those that the control has.
    fn known(&self, machine: &Machine) -> &[AxisLetter] {
        let sixth = self.beside.iter().any(|letter| machine.dialect.takes_sixth_axis(*letter));
        let room = if sixth { BESIDE } else { BESIDE - 1 };
        self.beside.get(..room.min(self.beside.len())).unwrap_or_default()
    }

    /// The addresses of axes that the control does not have, a bit for each [`Address`].
    pub(super) fn surplus(&self, machine: &Machine) -> u32 {
        if !Self::are_limited(machine) || self.beside.len() < BESIDE {
            return 0;
        }
        let known = self.known(machine);
        let is_surplus = |address: &Address| {
            address.axis().is_some_and(|letter| !letter.is_of_the_planes() && !known.contains(&letter))
        };
        Address::ALL.iter().filter(|address| is_surplus(address)).fold(0, |bits, address| bits | bit(*address))
    }

    /// The finding at a word of a letter that is one too many.
    pub(super) fn finding(&self, machine: &Machine, letter: AxisLetter) -> Finding {
        let axes = self.known(machine).iter().map(AxisLetter::to_string).collect::<Vec<_>>().join(", ");
        Finding::UnknownAxis { axis: letter.letter(), axes, limit: Some(BESIDE) }
    }
}

/// The axis letters that a program may use: those that it has already, and others where there is room for one more.
pub fn usable_axes(machine: &Machine, parsed: &ParsedFile) -> Vec<AxisLetter> {
    let mut used = AxisLetters::default();
    used.read(machine, parsed);
    let fits = |letter: &AxisLetter| {
        let mut with = used.clone();
        if with.beside.len() < BESIDE && !with.beside.contains(letter) {
            with.beside.push(*letter);
        }
        with.known(machine).contains(letter)
    };
    let limited = AxisLetters::are_limited(machine);
    AxisLetter::ALL.into_iter().filter(|letter| !limited || letter.is_of_the_planes() || fits(letter)).collect()
}

/// The bit of an address in a set of them.
pub(super) const fn bit(address: Address) -> u32 {
    1 << (address as u8)
}
