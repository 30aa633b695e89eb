//! Blocks of axis words and nothing else: nearly all blocks of long programs. What they do follows from what is in force,
//! which is looked up once for a run of them; the rules of motion are those of every block.

use super::block::Valued;
use super::executor::Executor;
use super::motion::{Reading, Travel, motion_type};
use super::state::Held;
use crate::dict::{GCode, GGroup};
use crate::ir::MotionType;
use crate::syntax::BlockId;

/// What blocks of axis words do while no other word comes between them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) enum Run {
    /// Not known: the block before may have changed what is in force.
    #[default]
    Unknown,
    /// More than move straight.
    Involved,
    /// They move straight, and nothing but positions changes.
    Straight(MotionType, Reading),
}

impl Executor<'_, '_> {
    /// Executes a block that has no G, M, L, Q, R, `/` or `&` word and no parameter, when it only moves axes straight.
    /// `false`: it does more, and nothing is done yet.
    #[inline]
    pub(super) fn run_point(&mut self, block: BlockId) -> bool {
        if matches!(self.run, Run::Unknown) {
            self.settle();
        }
        let Run::Straight(kind, reading) = self.run else { return false };
        if !self.wants_records && !reading.is_incremental() {
            return self.pass_point(block, reading);
        }
        let mut travels = std::mem::take(&mut self.travels);
        let straight = self.read_point(block, reading, &mut travels);
        if straight {
            self.begin_record(block);
            let stale = std::mem::take(&mut self.state.origin_changed);
            self.run_straight(kind, stale, &travels);
            if self.wants_records {
                for travel in &travels {
                    self.record.position.set(travel.definition.letter, travel.after.known());
                }
            }
        }
        self.travels = travels;
        straight
    }

    /// The same where nobody asks for the motion: the axes are where the words say.
    #[inline]
    fn pass_point(&mut self, block: BlockId, reading: Reading) -> bool {
        let Some(file) = self.resolved.file(self.file) else { return false };
        let (words, axes) = (file.words(block), &self.settings.machine.axes);
        if words.is_empty() || words.iter().any(|word| axes.index_of(word.address).is_none()) {
            return false;
        }
        for word in words {
            if let Some(axis) = axes.index_of(word.address) {
                self.state.set_position(axis, reading.target(axis, word.number()));
            }
        }
        self.record.jump = None;
        self.state.origin_changed = false;
        true
    }

    /// The motions of a block's words. `false`: there is another word.
    #[inline]
    fn read_point(&self, block: BlockId, reading: Reading, travels: &mut Vec<Travel>) -> bool {
        travels.clear();
        let Some(file) = self.resolved.file(self.file) else { return false };
        for &word in file.words(block) {
            let Some(axis) = self.settings.machine.axes.index_of(word.address) else { return false };
            let Some(travel) = self.travel(axis, Valued { word, value: word.number() }, reading) else { return false };
            // In machine order; of words for the same axis the last one counts.
            if travels.last().is_none_or(|last| last.axis < axis) {
                travels.push(travel);
                continue;
            }
            let at = travels.partition_point(|known| known.axis < axis);
            match travels.get_mut(at) {
                Some(known) if known.axis == axis => *known = travel,
                _ => travels.insert(at, travel),
            }
        }
        !travels.is_empty()
    }

    /// Finds out what a block of axis words will do: puts into force, and into the record, what a block without words has.
    #[inline(never)]
    fn settle(&mut self) {
        self.words.clear();
        self.apply_g();
        self.track_origin();
        self.apply_m();
        self.record.data = None;
        self.record.words.clear();
        self.finish_record(false);
        let kind = self.in_force(GGroup::G0).and_then(motion_type).unwrap_or(MotionType::Rapid);
        let straight = match kind {
            MotionType::Rapid | MotionType::Thread => true,
            MotionType::Linear => !self.lacks_technology(),
            MotionType::ArcCw | MotionType::ArcCcw | MotionType::Reference => false,
        };
        let cycle = self.in_force(GGroup::G8).is_some_and(GCode::is_cycle);
        self.run = if straight && !cycle { Run::Straight(kind, self.reading()) } else { Run::Involved };
    }

    /// Whether a working motion may have something to say about F and S (TEC-2, TEC-3).
    fn lacks_technology(&self) -> bool {
        let state = &self.state;
        (state.feed == Held::None && !self.feed_warned)
            || (state.speed == Held::None && !self.speed_warned && self.speed_reader().is_some())
    }

    /// What is known of the blocks of axis words after a block that did more. `plain`: it has no G, M or other word that
    /// changes what is in force.
    #[inline]
    pub(super) fn unsettle(&mut self, plain: bool) {
        let lasts = matches!(self.run, Run::Involved) && plain && self.words.f.is_none() && self.words.s.is_none();
        if !lasts {
            self.run = Run::Unknown;
        }
    }
}
