//! How far motions reach.

use super::block_name::BlockName;
use crate::dict::{AxisLetter, Micro};
use crate::run::{Executed, Motion, MotionType};

/// How many blocks of unknown reach are named.
pub const MOST_BLOCKS: usize = 100;

/// How far an axis goes.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Reach {
    /// The least and the greatest programmed position; `None`: none is known.
    pub known: Option<(Micro, Micro)>,
    /// Whether there are positions that are not known: it goes at least as far as is known.
    pub lacks: bool,
}

/// How far each axis goes.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
pub struct Extents {
    axes: [Reach; AxisLetter::ALL.len()],
    /// X is programmed as a diameter.
    diameter: bool,
    unknown: Vec<BlockName>,
    /// The first block that works while nobody knows where an axis stands.
    unseen: [Option<BlockName>; AxisLetter::ALL.len()],
}

/// How far a program goes.
#[derive(Clone, Debug, Default)]
pub struct Size {
    /// By working motion.
    pub working: Extents,
    /// By all motion.
    pub all: Extents,
}

impl Size {
    /// Takes up a block.
    pub fn add(&mut self, block: &Executed<'_>) {
        let Self { working, all } = self;
        if let Some(motion) = block.motion() {
            all.add_motion(&motion, block);
            if motion.kind().is_working() {
                working.add_motion(&motion, block);
                working.add_standing(block, &motion);
            }
        }
        for letter in moved_unseen(block) {
            let name = BlockName::of(block);
            working.lack(letter, name);
            all.lack(letter, name);
        }
    }

    /// Behind the last block.
    pub fn end(&mut self) {
        self.working.end(&self.all);
        self.all.cover(&self.working);
    }
}

/// The axes of the planes that a block takes where nobody knows: a fixed cycle that is not mapped, a macrocycle of the
/// machine.
pub(super) fn moved_unseen(block: &Executed<'_>) -> Vec<AxisLetter> {
    if !block.is_opaque() {
        return Vec::new();
    }
    let cycle = block.is_unmapped_cycle();
    let unseen: Vec<AxisLetter> = block.moved_unseen().collect();
    let linear = block.settings().machine.axes.iter().filter(|axis| !axis.rotary).map(|axis| axis.letter);
    linear.filter(|letter| letter.is_of_the_planes() && (cycle || unseen.contains(letter))).collect()
}

impl Extents {
    /// The axes that moved, in the order of their letters; X as a diameter where it is programmed as one.
    pub fn axes(&self) -> impl Iterator<Item = (AxisLetter, Reach)> + '_ {
        let moved = |(_, reach): &(AxisLetter, Reach)| reach.known.is_some() || reach.lacks;
        AxisLetter::ALL.into_iter().zip(self.axes).filter(moved).map(|(letter, reach)| {
            let twice = |position: Micro| position.plus(position);
            let known = reach.known.map(|(least, greatest)| (twice(least), twice(greatest)));
            if letter == AxisLetter::X && self.diameter { (letter, Reach { known, ..reach }) } else { (letter, reach) }
        })
    }

    /// The first [`MOST_BLOCKS`] blocks whose reach is not known.
    pub fn unknown_blocks(&self) -> &[BlockName] {
        &self.unknown
    }

    /// Gives X as a diameter.
    pub(super) const fn in_diameters(&mut self) {
        self.diameter = true;
    }

    fn add(&mut self, letter: AxisLetter, position: Micro) {
        if let Some(Reach { known, .. }) = self.axes.get_mut(letter as usize) {
            let (least, greatest) = known.unwrap_or((position, position));
            *known = Some((least.min(position), greatest.max(position)));
        }
    }

    /// A block takes an axis where nobody knows.
    pub(super) fn lack(&mut self, letter: AxisLetter, block: BlockName) {
        if let Some(reach) = self.axes.get_mut(letter as usize) {
            reach.lacks = true;
        }
        if self.unknown.len() < MOST_BLOCKS && !self.unknown.contains(&block) {
            self.unknown.push(block);
        }
    }

    /// Adds the way of a block's motion, from where it is known; its end is missing where nobody knows it.
    pub(super) fn add_motion(&mut self, motion: &Motion<'_>, block: &Executed<'_>) {
        for letter in motion.axes() {
            // Behind a change of origin the start is counted from the old one (MOT-8).
            let stale = motion.is_stale_along(letter);
            let (start, end) = (motion.start(letter).filter(|_| !stale), motion.end(letter));
            if end.is_none() || stale && motion.kind().is_working() {
                self.lack(letter, BlockName::of(block));
            }
            if motion.kind() != MotionType::Reference {
                [start, end].into_iter().flatten().for_each(|position| self.add(letter, position));
            }
        }
        if let Some(arc) = motion.arc().filter(|arc| arc.center.is_none()) {
            arc.plane.into_iter().for_each(|letter| self.lack(letter, BlockName::of(block)));
        }
        motion.extremes().for_each(|(letter, position)| self.add(letter, position));
    }

    /// Adds where the linear axes stand that a working motion leaves alone: a hole is where X and Y stand.
    pub(super) fn add_standing(&mut self, block: &Executed<'_>, motion: &Motion<'_>) {
        let state = block.state();
        let axes = block.settings().machine.axes.iter().enumerate();
        for (at, axis) in axes.filter(|(_, axis)| !axis.rotary && !motion.moves(axis.letter)) {
            match state.axis_position(at).filter(|_| !state.is_unsettled(at)) {
                Some(position) => self.add(axis.letter, position),
                None => {
                    let unseen = self.unseen.get_mut(axis.letter as usize);
                    unseen.into_iter().for_each(|unseen| *unseen = unseen.or_else(|| Some(BlockName::of(block))));
                }
            }
        }
    }

    /// At the end of a program that moves as far as `all`: the other axes are left out.
    pub(super) fn end(&mut self, all: &Self) {
        for letter in AxisLetter::ALL {
            let Some(reach) = self.axes.get_mut(letter as usize) else { continue };
            let unseen = self.unseen.get(letter as usize).copied().flatten();
            if !all.has_moved(letter) {
                *reach = Reach::default();
            } else if let (false, Some(block)) = (reach.lacks, unseen) {
                self.lack(letter, block);
            }
        }
    }

    /// Adds how far a part of these motions goes.
    pub(super) fn cover(&mut self, part: &Self) {
        for (letter, reach) in AxisLetter::ALL.into_iter().zip(part.axes) {
            let ends = reach.known.into_iter().flat_map(|(least, greatest)| [least, greatest]);
            ends.for_each(|position| self.add(letter, position));
            if reach.lacks {
                part.unknown.iter().for_each(|block| self.lack(letter, *block));
            }
        }
    }

    fn has_moved(&self, letter: AxisLetter) -> bool {
        self.axes.get(letter as usize).is_some_and(|reach| reach.known.is_some() || reach.lacks)
    }
}
