//! How the machine moves through the blocks that a request is about, where motion is configured.

use std::collections::{BTreeMap, VecDeque};

use super::values::Values;
use crate::analysis::motion::{BlockTimes, Break, Limit, Listener, Model, Planner, StepReader, Total, Unit};
use crate::config::Settings;
use crate::dict::Micro;
use crate::run::Executed;
use crate::syntax::BlockId;

/// What gives the velocity at the start of a motion.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub(crate) enum JoinedBy {
    /// The machine stops.
    Broken(Break),
    /// It goes on.
    Limited(Limit),
}

/// How the machine moves through one block.
#[derive(Clone, Debug, Default)]
pub(crate) struct Moved {
    /// Seconds.
    pub(crate) time_s: Values<Micro>,
    /// Velocities at the start, the greatest, at the end, in mm/min or deg/min.
    pub(crate) velocities: [Values<Micro>; 3],
    /// Only rotary axes move.
    pub(crate) in_degrees: bool,
    /// What gives the velocity at the start.
    pub(crate) joined: Values<JoinedBy>,
}

/// Plans the motion of an execution.
pub(crate) struct Moves {
    reader: StepReader,
    planner: Planner,
    seen: Seen,
}

/// What came out so far.
#[derive(Debug, Default)]
pub(crate) struct Seen {
    /// Blocks that are not given yet: which block of those asked for, and which unit.
    waiting: VecDeque<(Option<BlockId>, Option<usize>)>,
    /// Of the blocks asked for.
    pub(crate) blocks: BTreeMap<BlockId, Moved>,
    /// Times of the units asked for, without those that they call.
    pub(crate) units: Vec<Total>,
    /// Time of the program.
    pub(crate) total: Total,
}

impl Moves {
    /// For programs executed with these settings; so many units are asked for.
    pub(crate) fn new(settings: &Settings, units: usize) -> Self {
        Self {
            reader: StepReader::new(settings),
            planner: Planner::new(Model::of(settings), false),
            seen: Seen { units: vec![Total::default(); units], ..Seen::default() },
        }
    }

    /// The next executed block, with what it is of what was asked for.
    pub(crate) fn push(&mut self, executed: &Executed<'_>, block: Option<BlockId>, unit: Option<usize>) {
        self.seen.waiting.push_back((block, unit));
        self.planner.push(&self.reader.read(executed), &mut self.seen);
    }

    /// The program ended.
    pub(crate) fn finish(mut self) -> Seen {
        self.planner.finish(&mut self.seen);
        self.seen
    }
}

impl Listener for Seen {
    fn block(&mut self, times: &BlockTimes) {
        self.total.add(times);
        let Some((block, unit)) = self.waiting.pop_front() else { return };
        if let Some(sum) = unit.and_then(|unit| self.units.get_mut(unit)) {
            sum.add(times);
        }
        let Some(moved) = block.map(|block| self.blocks.entry(block).or_default()) else { return };
        moved.time_s.add((!times.unknown).then(|| Micro::from_f64(times.duration_s)));
        let Some(motion) = &times.motion else { return };
        moved.in_degrees |= motion.unit == Unit::Deg;
        if let Some(velocities) = motion.velocities {
            let values = [velocities.start, velocities.peak, velocities.end];
            for (seen, value) in moved.velocities.iter_mut().zip(values) {
                // Tenths are enough to look at.
                seen.add(Some(Micro::from_f64((value * 600.0).round() / 10.0)));
            }
        }
        let Some(joint) = &motion.joint else { return };
        moved.joined.add(joint.broken_by.map(JoinedBy::Broken).or(joint.limited_by.map(JoinedBy::Limited)));
    }
}
