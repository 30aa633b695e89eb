//! Which axes stand where nobody knows, and why.

use crate::dict::{AxisLetter, SPINDLE_GROUP};
use crate::run::{Executed, MotionType, Passed, State};

/// Why the position of an axis is not known.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum Unknown {
    /// Not programmed yet (MOT-2).
    #[default]
    NotProgrammed,
    /// At its reference point (MOT-7).
    Reference,
    /// An M function moved the machine (MFN-4).
    MFunction,
    /// A fixed cycle that is not mapped (GRP-6).
    Cycle,
    /// A macrocycle that only the machine has (FLW-12).
    Macrocycle,
    /// The spindle turned (MFN-10).
    Spindle,
    /// Moved by G91 from an unknown position (MOT-2).
    Incremental,
    /// A value that is not known (PAR-5).
    Value,
}

impl Unknown {
    /// As in JSON.
    pub const fn name(self) -> &'static str {
        match self {
            Self::NotProgrammed => "not_programmed",
            Self::Reference => "reference",
            Self::MFunction => "m_function",
            Self::Cycle => "cycle",
            Self::Macrocycle => "macrocycle",
            Self::Spindle => "spindle",
            Self::Incremental => "incremental",
            Self::Value => "value",
        }
    }

    /// Every one.
    pub const ALL: [Self; 8] = [
        Self::NotProgrammed,
        Self::Reference,
        Self::MFunction,
        Self::Cycle,
        Self::Macrocycle,
        Self::Spindle,
        Self::Incremental,
        Self::Value,
    ];
}

/// What execution does to the axes.
#[derive(Clone, Debug, Default)]
pub struct Axes {
    why: [Unknown; AxisLetter::ALL.len()],
    moved: [bool; AxisLetter::ALL.len()],
}

impl Axes {
    /// Why an axis is not known, if it is not.
    pub fn why(&self, letter: AxisLetter) -> Unknown {
        self.why.get(letter as usize).copied().unwrap_or_default()
    }

    /// Whether the program has moved it.
    pub fn is_moved(&self, letter: AxisLetter) -> bool {
        self.moved.get(letter as usize).copied().unwrap_or(false)
    }

    /// Notes what a block does; `before`: what was in force before it.
    #[inline]
    pub fn pass(&mut self, block: &Executed<'_>, before: &State) {
        for axis in block.motion().into_iter().flat_map(|motion| motion.axes()) {
            if let Some(moved) = self.moved.get_mut(axis as usize) {
                *moved = true;
            }
        }
        if !block.moves_on() {
            self.note(block, before);
        }
    }

    /// Notes what points do.
    pub fn pass_over(&mut self, points: &Passed<'_>) {
        for (axis, _) in points.axes() {
            if let Some(moved) = self.moved.get_mut(axis as usize) {
                *moved = true;
            }
        }
    }

    fn note(&mut self, block: &Executed<'_>, before: &State) {
        let after = block.state();
        let by_cycle = block.is_unmapped_cycle();
        for (place, axis) in block.settings().machine.axes.iter().enumerate() {
            let letter = axis.letter;
            let (Some(unknown), Some(moved)) = (self.why.get_mut(letter as usize), self.moved.get_mut(letter as usize))
            else {
                continue;
            };
            let was_known = before.axis_position(place).is_some();
            let cycle = by_cycle && block.words().iter().any(|(word, _)| *word == letter.letter());
            *moved |= cycle || was_known;
            if block.opaque_call().is_some() && block.moved_unseen().any(|unseen| unseen == letter) {
                *unknown = Unknown::Macrocycle;
            } else if after.axis_position(place).is_some() {
                *unknown = Unknown::NotProgrammed;
            } else if was_known
                || cycle
                || block.motion().is_some_and(|motion| motion.moves(letter))
                || *unknown == Unknown::Reference && block.change_pos()
            {
                *unknown = why(block, letter, cycle, *unknown);
            }
        }
    }
}

/// Why an axis is not known after a block.
fn why(block: &Executed<'_>, axis: AxisLetter, cycle: bool, before: Unknown) -> Unknown {
    let functions = &block.settings().machine.m_functions;
    let turned = || block.m_written().iter().any(|number| usize::from(functions.group(*number)) == SPINDLE_GROUP);
    let motion = block.motion();
    if motion.is_some_and(|motion| motion.kind() == MotionType::Reference && motion.moves(axis)) {
        Unknown::Reference
    } else if block.change_pos() {
        Unknown::MFunction
    } else if cycle {
        Unknown::Cycle
    } else if motion.is_some_and(|motion| motion.delta(axis).is_some()) {
        // It stands at its reference point no longer.
        if matches!(before, Unknown::NotProgrammed | Unknown::Reference) { Unknown::Incremental } else { before }
    } else if turned() {
        Unknown::Spindle
    } else {
        Unknown::Value
    }
}
