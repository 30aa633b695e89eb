//! Times before and behind a place, from a second pass over the blocks: by then their number is known.

use std::ops::ControlFlow;

use crate::analysis::motion::{BlockTimes, Listener, Planned};
use crate::config::Settings;
use crate::diag::Findings;
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
fn is_lower_bound(block: &BlockTimes) -> bool {
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
pub struct Clock(Planned<Sums>);

impl Clock {
    /// For a program that is executed with these settings; `blocks`: around the place.
    pub fn new(settings: &Settings, blocks: Progress<u64>) -> Self {
        Self(Planned::new(settings, Sums { ends: blocks.ends().map(|end| (end, 0.0)), lower_bound: false }))
    }

    /// The next executed block.
    #[inline]
    pub fn push(&mut self, block: &Executed<'_>) {
        self.0.push(block);
    }

    /// The times, when all blocks were pushed.
    pub fn finish(self) -> TimedProgress {
        let sums = self.0.finish();
        TimedProgress::around(sums.ends.map(|(_, sum)| sum), sums.lower_bound)
    }
}

/// When each block of an execution ends, in seconds after program start.
#[derive(Clone, Debug, Default)]
pub struct Timeline {
    ends: Vec<f64>,
    lower_bound: bool,
}

impl Listener for Timeline {
    fn block(&mut self, block: &BlockTimes) {
        let before = self.ends.last().copied().unwrap_or_default();
        self.ends.push(before + block.duration_s);
        self.lower_bound |= is_lower_bound(block);
    }
}

impl Timeline {
    /// How long so many blocks take.
    fn of(&self, blocks: u64) -> f64 {
        let last = usize::try_from(blocks).ok().and_then(|blocks| blocks.checked_sub(1));
        last.and_then(|last| self.ends.get(last)).copied().unwrap_or_default()
    }

    /// The times around a place with so many blocks before it and behind it.
    pub fn around(&self, blocks: Progress<u64>) -> TimedProgress {
        TimedProgress::around(blocks.ends().map(|end| self.of(end)), self.lower_bound)
    }
}

/// A sink that makes a [`Timeline`].
#[derive(Debug)]
pub struct TimelineReader {
    planned: Planned<Timeline>,
    blocks: u64,
}

impl TimelineReader {
    /// Of the first so many blocks of a program that is executed with these settings.
    pub fn new(settings: &Settings, blocks: u64) -> Self {
        Self { planned: Planned::new(settings, Timeline::default()), blocks }
    }

    /// The times, when all blocks were read.
    pub fn finish(self) -> Timeline {
        self.planned.finish()
    }
}

impl Sink for &mut TimelineReader {
    type Whole = ();

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.planned.push(block);
        if block.seq() + 1 < self.blocks { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    fn end(self, _: End, _: &mut Findings) {}
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
pub struct AtTime(Planned<Under>);

impl AtTime {
    /// Of programs executed with these settings.
    pub fn new(settings: &Settings, at_s: f64) -> Self {
        Self(Planned::new(settings, Under { at_s, ..Under::default() }))
    }

    /// The block, or how many seconds the program takes.
    ///
    /// # Errors
    /// When it takes no longer.
    pub fn found(self) -> Result<u64, f64> {
        let under = self.0.finish();
        under.seq.ok_or(under.sum_s)
    }
}

impl Sink for &mut AtTime {
    type Whole = End;

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.0.push(block);
        ControlFlow::Continue(())
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        end
    }
}
