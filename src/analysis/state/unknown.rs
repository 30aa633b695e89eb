//! The axes whose positions are not known, and why.

use crate::config::Settings;
use crate::dict::{AxisLetter, GCode, GGroup, SPINDLE_GROUP};
use crate::named::named;
use crate::run::{AxisSet, Executed, MotionType, Passed};

named! {
    /// Why the position of an axis is not known.
    #[derive(Clone, Copy, Debug, Default, Eq, Hash, PartialEq)]
    pub enum Unknown {
        /// Not programmed yet (MOT-2).
        #[default]
        NotProgrammed "not_programmed" ("not programmed yet", "dosud neprogramováno"),
        /// At its reference point (MOT-7).
        Reference "reference" ("it stands at its reference point (G30)", "stojí v referenčním bodě (G30)"),
        /// An M function moved the machine (MFN-4).
        MFunction "m_function" ("an M function moved the machine", "strojem pohnula M funkce"),
        /// A fixed cycle that is not mapped (GRP-6).
        Cycle "cycle" ("a fixed cycle moved it that is not configured", "pohnul jí pevný cyklus, který není nastaven"),
        /// A macrocycle that only the machine has (FLW-12).
        Macrocycle "macrocycle" ("a macrocycle moved it that only the machine has", "pohnul jí makrocyklus, který má jen stroj"),
        /// The spindle turned (MFN-10).
        Spindle "spindle" ("it is the spindle, which turned", "je to vřeteno, které se točilo"),
        /// Moved by G91 from an unknown position (MOT-2).
        Incremental "incremental" ("moved by G91 from an unknown position", "pohyb v G91 z neznámé polohy"),
        /// A value that is not known (PAR-5).
        Value "value" ("a value is not known", "není známa hodnota"),
    }
}

/// What execution does to the axes.
#[derive(Clone, Debug)]
pub struct Axes {
    why: [Unknown; AxisLetter::ALL.len()],
    moved: [bool; AxisLetter::ALL.len()],
}

impl Axes {
    /// Before the first block of a program that is executed with these settings.
    pub fn new(settings: &Settings) -> Self {
        let (why, moved) = ([Unknown::default(); AxisLetter::ALL.len()], [false; AxisLetter::ALL.len()]);
        let mut axes = Self { why, moved };
        settings.machine.start.keys().for_each(|axis| axes.note_moved(*axis));
        axes
    }

    /// Why an axis is not known, if it is not.
    pub fn why(&self, letter: AxisLetter) -> Unknown {
        self.why.get(letter as usize).copied().unwrap_or_default()
    }

    /// Whether the program has moved it, or where it stands was said.
    pub fn is_moved(&self, letter: AxisLetter) -> bool {
        self.moved.get(letter as usize).copied().unwrap_or(false)
    }

    /// Notes what a block does; `elsewhere`: the axes that it left elsewhere.
    #[inline]
    pub fn pass(&mut self, block: &Executed<'_>, elsewhere: AxisSet) {
        self.note_moves(block);
        // A motion by a distance may take an axis from its reference point.
        if !block.moves_on() || block.g(GGroup::G9) == Some(GCode::G91) {
            self.note(block, elsewhere);
        }
    }

    /// Notes which axes a block moves, and of which it says where they stand: no more is wanted.
    #[inline]
    pub fn note_moves(&mut self, block: &Executed<'_>) {
        block.motion().into_iter().flat_map(|motion| motion.axes()).for_each(|axis| self.note_moved(axis));
        if block.moves_on() || block.motion().is_some() {
            return;
        }
        let stands = block.data().filter(|data| data.g == GCode::G93).map_or(&[][..], |data| data.values);
        let cycle = if block.is_unmapped_cycle() { block.words() } else { &[] };
        let letters = stands.iter().chain(cycle).map(|(letter, _)| *letter);
        letters.filter_map(AxisLetter::from_letter).for_each(|axis| self.note_moved(axis));
    }

    fn note_moved(&mut self, axis: AxisLetter) {
        if let Some(moved) = self.moved.get_mut(axis as usize) {
            *moved = true;
        }
    }

    /// Notes what points do.
    pub fn pass_over(&mut self, points: &Passed<'_>) {
        points.axes().for_each(|(axis, _)| self.note_moved(axis));
    }

    fn note(&mut self, block: &Executed<'_>, elsewhere: AxisSet) {
        let (after, motion) = (block.state(), block.motion());
        let by_cycle = block.is_unmapped_cycle();
        let is_unseen = by_cycle || block.opaque_call().is_some() || block.change_pos();
        let axes = &block.settings().machine.axes;
        let is_lost = |place: usize| after.axis_position(place).is_none();
        let moved = || motion.into_iter().flat_map(|motion| motion.axes()).filter_map(|axis| axes.index(axis));
        // Nearly all blocks of programs do nothing else to axes than move them to known places.
        if !is_unseen && !moved().any(is_lost) && !elsewhere.places().any(is_lost) {
            return;
        }
        for (place, axis) in axes.iter().enumerate() {
            let letter = axis.letter;
            let moves = elsewhere.contains(place) || motion.is_some_and(|motion| motion.moves(letter));
            let Some(unknown) = self.why.get_mut(letter as usize).filter(|_| moves || is_unseen) else { continue };
            let cycle = by_cycle && block.words().iter().any(|(word, _)| *word == letter.letter());
            if block.moved_unseen().any(|unseen| unseen == letter) {
                *unknown = Unknown::Macrocycle;
            } else if after.axis_position(place).is_some() {
                *unknown = Unknown::NotProgrammed;
            } else if moves || cycle || *unknown == Unknown::Reference && block.change_pos() {
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
        // It has left its reference point.
        if matches!(before, Unknown::NotProgrammed | Unknown::Reference) { Unknown::Incremental } else { before }
    } else if turned() {
        Unknown::Spindle
    } else {
        Unknown::Value
    }
}
