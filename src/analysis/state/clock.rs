//! Times before and behind a place. The planner gives the time of a block some blocks later: the place goes with the
//! blocks to it.

use std::collections::VecDeque;
use std::ops::ControlFlow;

use crate::analysis::motion::{BlockTimes, Listener, Model, Planner, Step, StepReader};
use crate::config::Settings;
use crate::diag::Findings;
use crate::parallel::Fold;
use crate::run::{End, Executed, Program, Sink};

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

/// Times in seconds, and whether they lack some.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TimedProgress {
    /// The times.
    pub seconds: Progress<f64>,
    /// Some blocks have no known time.
    pub lower_bound: bool,
}

/// Whether a block may take longer than its time says.
pub(super) fn is_lower_bound(block: &BlockTimes) -> bool {
    block.unknown || block.motion.as_ref().is_some_and(|motion| motion.jerk_free)
}

/// What goes to the planner with a block.
#[derive(Clone, Debug)]
struct Item {
    step: Step,
    change: bool,
    /// The first block that is left.
    first_left: bool,
}

/// Sums times.
#[derive(Clone, Debug, Default)]
struct Sums {
    place: Option<u64>,
    changes: VecDeque<u64>,
    changed: bool,
    progress: TimedProgress,
}

impl Listener for Sums {
    fn block(&mut self, block: &BlockTimes) {
        let seconds = &mut self.progress.seconds;
        let left = self.place.is_some_and(|place| block.seq >= place);
        if self.changes.front() == Some(&block.seq) {
            self.changes.pop_front();
            if left {
                self.changed = true;
            } else {
                seconds.tool_done = 0.0;
            }
        }
        if left {
            seconds.left += block.duration_s;
            if !self.changed {
                seconds.tool_left += block.duration_s;
            }
        } else {
            seconds.done += block.duration_s;
            seconds.tool_done += block.duration_s;
        }
        self.progress.lower_bound |= is_lower_bound(block);
    }
}

/// How many executed blocks have their times in the answer.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Timing {
    /// None: nobody asks.
    Never,
    /// All, where motion is configured. Else a program with more blocks than [`Timing::ASSUMED`] has no times.
    Configured,
    /// All.
    Always,
}

impl Timing {
    /// So many blocks at most have times that rest on an assumed machine: planning takes several times as long as
    /// executing.
    pub const ASSUMED: u64 = 1_000_000;

    fn most(self, settings: &Settings) -> u64 {
        match self {
            Self::Never => 0,
            Self::Configured if !settings.machine.motion.configured => Self::ASSUMED,
            Self::Configured | Self::Always => u64::MAX,
        }
    }
}

/// The times of a program around a place.
#[derive(Debug)]
pub(super) struct Clock {
    reader: StepReader,
    /// `None`: there are more blocks than have times.
    planned: Option<Fold<Item, (Planner, Sums)>>,
    /// How many more blocks have their times.
    room: u64,
}

impl Clock {
    pub fn new(settings: &Settings, timing: Timing) -> Self {
        let fold = || {
            let planner = Planner::new(Model::of(settings), false);
            Fold::new("planner", (planner, Sums::default()), |(planner, sums), item: &Item| {
                if item.first_left {
                    sums.place = Some(item.step.seq);
                }
                if item.change {
                    sums.changes.push_back(item.step.seq);
                }
                planner.push(&item.step, sums);
            })
        };
        let room = timing.most(settings);
        Self { reader: StepReader::new(settings), planned: (room > 0).then(fold), room }
    }

    /// A program with more blocks in its text than have times gets none: planning the first of them would be in vain.
    pub fn begin(&mut self, program: &Program<'_>) {
        let resolved = &program.resolved;
        let main = resolved.main().and_then(|id| resolved.unit(id));
        if main.is_some_and(|main| u64::from(main.end.0 - main.first.0) > self.room) {
            self.planned = None;
        }
    }

    /// Whether the times of the next block are wanted.
    pub const fn is_planning(&self) -> bool {
        self.planned.is_some()
    }

    /// The next block; `change`: it changes the tool, `first_left`: the place is before it.
    #[inline]
    pub fn push(&mut self, block: &Executed<'_>, change: bool, first_left: bool) {
        let Some(planned) = &mut self.planned else { return };
        if self.room == 0 {
            self.planned = None;
            return;
        }
        self.room -= 1;
        planned.push(Item { step: self.reader.read(block), change, first_left });
    }

    /// `None`: the program has too many blocks for them.
    pub fn finish(self) -> Option<TimedProgress> {
        let (mut planner, mut sums) = self.planned?.finish();
        planner.finish(&mut sums);
        Some(sums.progress)
    }
}

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
        if self.sum_s > self.at_s {
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
