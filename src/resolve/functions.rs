//! The G and M functions of a block, the words that go with them, and its words that conflict.

use super::Roles;
use super::targets::{conflicting_g, conflicting_m};
use crate::config::{Machine, Settings};
use crate::diag::{Diagnostic, Finding, LabelText, shown};
use crate::dict::{Address, CALL_ELSEWHERE, FIRST_CONTROL, GCode, GGroup, M_GROUPS};
use crate::syntax::{ParsedFile, Word};

/// The functions written in a block.
#[derive(Default)]
pub(super) struct Functions {
    g: [Option<(GCode, Word)>; 12],
    /// Groups of which two functions are written (E0307): which of them was meant is not known.
    clash: [bool; 12],
    pub(super) m: [Option<(u8, Word)>; M_GROUPS],
    /// What L and Q belong to.
    pub(super) roles: Roles,
    /// Has a G function of other controls with words that belong to it: a call or a cycle.
    foreign: bool,
    /// M98 where the machine has no such function.
    call_elsewhere: Option<Word>,
    /// The conflicts of these functions.
    pub(super) conflicts: Vec<Conflict>,
}

impl Functions {
    /// Those of a block with these words.
    pub(super) fn of(words: &[Word], settings: &Settings) -> Self {
        let mut functions = Self { roles: Roles::written(words), ..Self::default() };
        for &word in words {
            if word.address == Address::G {
                functions.add_g(word);
            } else if let Some(number) = m_number(word, settings) {
                functions.add_m(number, word, &settings.machine);
            }
        }
        functions
    }

    fn add_g(&mut self, word: Word) {
        self.foreign |= word.whole().is_some_and(|number| matches!(number, 65 | 66 | 76 | 77));
        let Some(code) = word.g_code() else { return };
        let group = code.group().index();
        match self.g.get_mut(group) {
            Some(Some((first, first_word))) => {
                let conflict = Conflict { first: *first_word, second: word, of: Shared::GGroup(*first, code) };
                self.conflicts.push(conflict);
                if let Some(clash) = self.clash.get_mut(group) {
                    *clash = true;
                }
            }
            Some(slot) => *slot = Some((code, word)),
            None => {}
        }
    }

    fn add_m(&mut self, number: u8, word: Word, machine: &Machine) {
        let configured = machine.m_functions.get(number).is_some_and(|function| function.configured);
        if number == CALL_ELSEWHERE && !configured {
            self.call_elsewhere = Some(word);
        }
        match self.m.get_mut(usize::from(machine.m_functions.group(number))) {
            Some(Some((first, first_word))) => {
                let conflict = Conflict { first: *first_word, second: word, of: Shared::MGroup(*first, number) };
                self.conflicts.push(conflict);
            }
            Some(slot) => *slot = Some((number, word)),
            None => {}
        }
    }

    /// The one function of that group.
    pub(super) fn of_group(&self, group: GGroup) -> Option<(GCode, Word)> {
        let clash = self.clash.get(group.index()).copied().unwrap_or(false);
        self.g.get(group.index()).copied().flatten().filter(|_| !clash)
    }

    /// M98, which calls a subprogram on other controls.
    pub(super) const fn calls_elsewhere(&self) -> Option<Word> {
        self.call_elsewhere
    }

    /// Whether the block calls a subprogram by M98 and P.
    pub(super) fn is_call_elsewhere(&self, words: &[Word]) -> bool {
        let p = words.iter().find(|word| word.address == Address::P).and_then(|word| word.whole());
        self.calls_elsewhere().is_some() && self.roles.l.is_none() && p.is_some_and(|p| (1..=99).contains(&p))
    }

    /// Whether a word of that address belongs to what a function means on other controls: the time of a dwell, the
    /// words of a call or a cycle.
    pub(super) fn takes_elsewhere(&self, address: Address) -> bool {
        let dwell = address == Address::P && self.roles.dwell.is_some() && self.roles.q.is_none();
        dwell || (self.foreign && matches!(address, Address::P | Address::Q | Address::L | Address::D | Address::H))
    }

    /// Whether the word assigns a parameter that the arithmetic of the block takes as a control word (PAR-7).
    pub(super) fn is_control_word(&self, word: Word) -> bool {
        let count = self.of_group(GGroup::G4).map_or(0, |(function, _)| function.operations());
        let at = word.target().checked_sub(FIRST_CONTROL).filter(|_| word.address == Address::R);
        at.is_some_and(|at| usize::from(at) < count)
    }
}

/// The number of the M function that a word writes out, when the dialect has it.
pub fn m_number(word: Word, settings: &Settings) -> Option<u8> {
    if word.address != Address::M {
        return None;
    }
    let number = word.whole().and_then(|number| u8::try_from(number).ok())?;
    (number <= settings.machine.dialect.highest_m()).then_some(number)
}

/// Two words of a block of which it takes one (BLK-3, GRP-1, MFN-1).
#[derive(Clone, Copy, Debug)]
pub(super) struct Conflict {
    pub(super) first: Word,
    pub(super) second: Word,
    of: Shared,
}

/// What both words of a conflict have.
#[derive(Clone, Copy, Debug)]
enum Shared {
    /// Functions of one group.
    GGroup(GCode, GCode),
    MGroup(u8, u8),
    /// The address, or the parameter that they assign.
    Address,
}

impl Conflict {
    /// The conflicts between words of one address; G and M have theirs by group.
    pub(super) fn of_addresses(words: &[Word]) -> Vec<Self> {
        let mut addresses: [Option<Word>; Address::ALL.len()] = [None; Address::ALL.len()];
        let mut parameters: [Option<Word>; 96] = [None; 96];
        let mut conflicts = Vec::new();
        for &word in words {
            if word.lacks_value() || matches!(word.address, Address::G | Address::M) {
                continue;
            }
            let slot = if word.address == Address::R {
                parameters.get_mut(usize::from(word.target()))
            } else {
                addresses.get_mut(word.address as usize)
            };
            let Some(slot) = slot else { continue };
            match *slot {
                None => *slot = Some(word),
                Some(first) => conflicts.push(Self { first, second: word, of: Shared::Address }),
            }
        }
        conflicts
    }

    /// The finding; `unnumbered`: the line between the two words lacks its block number.
    pub(super) fn diagnostic(self, file: &ParsedFile, machine: &Machine, unnumbered: bool) -> Diagnostic {
        let Self { first, second, of } = self;
        match of {
            Shared::GGroup(one, other) => conflicting_g(file, (one, first), (other, second), unnumbered),
            Shared::MGroup(one, other) => conflicting_m(file, (one, first), (other, second), machine, unnumbered),
            Shared::Address => {
                let is_parameter = second.address == Address::R;
                let address = if is_parameter { format!("R{}", second.target()) } else { second.address.to_string() };
                let there = file.word_place(first);
                let what = shown(file.source.slice(there.span));
                Diagnostic::new(Finding::DuplicateAddress { address, unnumbered }, file.word_place(second))
                    .with_label(there, LabelText::First { what })
            }
        }
    }
}
