//! Times before and behind a place, from a second pass over the blocks: by then their number is known.

use std::ops::ControlFlow;

use crate::analysis::motion::{BlockTimes, Listener, Model, Planner, Step, StepReader};
use crate::config::Settings;
use crate::diag::Findings;
use crate::parallel::Fold;
use crate::run::{End, Executed, Sink};

/// What was done, and what is left, of one kind of thing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Progress<T> {
    /// Before the place.
    pub done: T,
    /// From the place on.
    pub left: T,
    /// Of what is done, since the last tool change.
    pub tool_done: T,
    /// Of what is left, up to the next tool change.
    pub tool_left: T,
}

impl Progress<u64> {
    /// How many blocks there are before the last tool change, the place, the next tool change and the end.
    pub(super) const fn ends(self) -> [u64; 4] {
        [self.done - self.tool_done, self.done, self.done + self.tool_left, self.done + self.left]
    }
}

/// Times in seconds, and whether they lack some.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TimedProgress {
    /// The times.
    pub seconds: Progress<f64>,
    /// Some blocks have no known time.
    pub lower_bound: bool,
}

impl TimedProgress {
    /// From when the blocks of [`Progress::ends`] end.
    pub(super) fn around([change, place, next, end]: [f64; 4], lower_bound: bool) -> Self {
        let seconds = Progress { done: place, left: end - place, tool_done: place - change, tool_left: next - place };
        Self { seconds, lower_bound }
    }
}

/// Whether a block may take longer than its time says.
pub(super) fn is_lower_bound(block: &BlockTimes) -> bool {
    block.unknown || block.motion.as_ref().is_some_and(|motion| motion.jerk_free)
}

/// Sums times up to some blocks.
#[derive(Clone, Debug, Default)]
struct Sums {
    /// Each number of blocks, and how long so many take.
    ends: [(u64, f64); 4],
    lower_bound: bool,
}

impl Listener for Sums {
    fn block(&mut self, block: &BlockTimes) {
        for (end, sum) in &mut self.ends {
            if block.seq < *end {
                *sum += block.duration_s;
            }
        }
        self.lower_bound |= is_lower_bound(block);
    }
}

/// When the times of a program are wanted.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Timing {
    /// Never.
    Never,
    /// Where motion is configured, and for up to [`Timing::ASSUMED`] executed blocks.
    Configured,
    /// Always.
    Always,
}

impl Timing {
    /// So many blocks at most have times that rest on an assumed machine: planning takes several times as long as
    /// executing.
    pub const ASSUMED: u64 = 1_000_000;

    /// Whether those of a program with so many executed blocks are wanted.
    pub const fn wants(self, settings: &Settings, blocks: u64) -> bool {
        match self {
            Self::Never => false,
            Self::Configured => settings.machine.motion.configured || blocks <= Self::ASSUMED,
            Self::Always => true,
        }
    }
}

/// Finds the times of a program around a place.
#[derive(Debug)]
pub struct Clock {
    reader: StepReader,
    planned: Fold<Step, (Planner, Sums)>,
}

impl Clock {
    /// For a program that is executed with these settings; `blocks`: around the place.
    pub fn new(settings: &Settings, blocks: Progress<u64>) -> Self {
        let sums = Sums { ends: blocks.ends().map(|end| (end, 0.0)), lower_bound: false };
        let planner = (Planner::new(Model::of(settings), false), sums);
        let planned = Fold::new("planner", planner, |(planner, sums), step| planner.push(step, sums));
        Self { reader: StepReader::new(settings), planned }
    }

    /// The next executed block.
    #[inline]
    pub fn push(&mut self, block: &Executed<'_>) {
        self.planned.push(self.reader.read(block));
    }

    /// The times, when all blocks were pushed.
    pub fn finish(self) -> TimedProgress {
        let (mut planner, mut sums) = self.planned.finish();
        planner.finish(&mut sums);
        TimedProgress::around(sums.ends.map(|(_, sum)| sum), sums.lower_bound)
    }
}

/// Times are shown to a millionth of a second.
const HALF_MICRO_S: f64 = 0.5e-6;

/// Looks for the block that is under way at a time.
#[derive(Clone, Debug, Default)]
struct Under {
    at_s: f64,
    sum_s: f64,
    seq: Option<u64>,
}

impl Listener for Under {
    fn block(&mut self, block: &BlockTimes) {
        self.sum_s += block.duration_s;
        // A block whose end is shown as the time asked for is over.
        if self.sum_s > self.at_s + HALF_MICRO_S {
            self.seq = self.seq.or(Some(block.seq));
        }
    }
}

/// A sink that finds the block under way so many seconds after program start.
#[derive(Debug)]
pub struct AtTime {
    reader: StepReader,
    planned: Fold<Step, (Planner, Under)>,
}

impl AtTime {
    /// Of programs executed with these settings.
    pub fn new(settings: &Settings, at_s: f64) -> Self {
        let planner = Planner::new(Model::of(settings), false);
        let under = Under { at_s, ..Under::default() };
        let planned = Fold::new("planner", (planner, under), |(planner, under), step| planner.push(step, under));
        Self { reader: StepReader::new(settings), planned }
    }

    /// The block, or how many seconds the program takes.
    ///
    /// # Errors
    /// When it takes no longer.
    pub fn found(self) -> Result<u64, f64> {
        let (mut planner, mut under) = self.planned.finish();
        planner.finish(&mut under);
        under.seq.ok_or(under.sum_s)
    }
}

impl Sink for &mut AtTime {
    type Whole = End;

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.planned.push(self.reader.read(block));
        ControlFlow::Continue(())
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        end
    }
}
