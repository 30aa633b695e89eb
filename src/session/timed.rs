//! Executed blocks with their times. The planner needs later blocks for the times of an earlier one: it runs ahead, and
//! a second interpreter follows, so that memory does not depend on the length of the program.

use std::collections::VecDeque;
use std::ops::ControlFlow;
use std::path::Path;

use super::{Execution, Run, Session};
use crate::analysis::motion::{BlockTimes, Listener, Model, Planner, StepReader};
use crate::config::{Purpose, Settings};
use crate::diag::Findings;
use crate::run::{End, Executed, Interpreter, Program};

/// A reader of executed blocks that wants their times. What [`crate::run::Sink`] says holds for it too.
pub trait TimedSink {
    /// The sink's result for a whole program.
    type Whole;

    /// Execution begins.
    fn begin(&mut self, _program: &Program<'_>) {}

    /// The next executed block with its times. `Break`: no more blocks are wanted, and the program is not taken for
    /// whole.
    fn block(&mut self, block: &Executed<'_>, times: &BlockTimes, findings: &mut Findings) -> ControlFlow<()>;

    /// Receives the time of a block's motion without limited jerk and time criterion, in order of the motions.
    fn no_jerk(&mut self, _motion_s: f64) {}

    /// The program ended, and has no errors.
    fn end(self, end: End, findings: &mut Findings) -> Self::Whole;
}

/// Times that take more work.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Times {
    /// The phases of each motion.
    pub phases: bool,
    /// TIME_DIST (TIM-2): a second planner finds the end of each stretch before its first block is given.
    pub time_dist: bool,
}

impl Session<'_> {
    /// Executes the program at `path`, which the user calls `name`, and shows each executed block with its times to
    /// `sink`.
    pub fn run_timed<S: TimedSink>(
        &self,
        path: &Path,
        name: &str,
        purpose: Purpose,
        times: Times,
        sink: S,
    ) -> Run<S::Whole> {
        match self.open(path, name, purpose) {
            Ok(execution) => Timed::new(execution, self.settings, times, sink).run(),
            Err(outcome) => Run { outcome: *outcome, whole: None },
        }
    }
}

/// A planner with the reader of its blocks.
struct Planning<L> {
    reader: StepReader,
    planner: Planner,
    given: L,
}

impl<L: Listener> Planning<L> {
    fn new(settings: &Settings, phases: bool, given: L) -> Self {
        let planner = Planner::new(Model::of(settings), phases);
        Self { reader: StepReader::new(settings), planner, given }
    }

    fn push(&mut self, block: &Executed<'_>) {
        self.planner.push(&self.reader.read(block), &mut self.given);
    }

    fn finish(&mut self) {
        self.planner.finish(&mut self.given);
    }
}

/// Times that are ready.
#[derive(Default)]
struct Ready {
    blocks: VecDeque<BlockTimes>,
    no_jerk: VecDeque<f64>,
}

impl Listener for Ready {
    fn block(&mut self, block: &BlockTimes) {
        self.blocks.push_back(block.clone());
    }

    fn no_jerk(&mut self, motion_s: f64) {
        self.no_jerk.push_back(motion_s);
    }
}

/// What stretches take, from one of them on.
#[derive(Default)]
struct Stretches {
    first: u64,
    seconds: VecDeque<f64>,
}

impl Listener for Stretches {
    fn block(&mut self, _: &BlockTimes) {}

    fn stretch(&mut self, _: u64, motion_s: f64) {
        self.seconds.push_back(motion_s);
    }
}

impl Stretches {
    /// The time of a stretch; none while its end is not planned. Forgets those before it.
    fn of(&mut self, index: u64) -> Option<f64> {
        while self.first < index && self.seconds.pop_front().is_some() {
            self.first += 1;
        }
        self.seconds.front().copied().filter(|_| self.first == index)
    }
}

/// Looks for the ends of stretches; the blocks come from an interpreter behind it.
struct Far {
    planning: Planning<Stretches>,
    near: Interpreter,
}

/// A run with times.
struct Timed<'a, S> {
    execution: Execution<'a>,
    sink: S,
    /// Gives the blocks that the sink sees.
    behind: Interpreter,
    planning: Planning<Ready>,
    far: Option<Far>,
}

impl<'a, S: TimedSink> Timed<'a, S> {
    fn new(execution: Execution<'a>, settings: &Settings, times: Times, sink: S) -> Self {
        let far = times.time_dist.then(|| Far {
            planning: Planning::new(settings, false, Stretches::default()),
            near: execution.interpreter(),
        });
        Self {
            behind: execution.interpreter(),
            planning: Planning::new(settings, times.phases, Ready::default()),
            execution,
            sink,
            far,
        }
    }

    fn run(mut self) -> Run<S::Whole> {
        let ended = if self.execution.is_whole() {
            self.sink.begin(self.execution.program());
            self.show()
        } else {
            ControlFlow::Continue(())
        };
        if ended.is_break() {
            self.execution.give_up();
        }
        let Self { execution, sink, .. } = self;
        execution.finish_by(|end, findings| sink.end(end, findings))
    }

    /// Shows the blocks. Of a program that is not whole only those that have their times before execution stops.
    fn show(&mut self) -> ControlFlow<()> {
        loop {
            let waits = self.give()?;
            if waits || !self.follow() {
                if self.ahead() {
                    continue;
                }
                break;
            }
        }
        if self.execution.end().is_none() {
            return ControlFlow::Continue(());
        }
        if let Some(far) = &mut self.far {
            far.planning.finish();
        }
        loop {
            self.give()?;
            if !self.follow() {
                break;
            }
        }
        self.planning.finish();
        self.give().map_continue(|_| ())
    }

    /// Executes the next block. `false`: there is none.
    fn ahead(&mut self) -> bool {
        let Some((block, _)) = self.execution.step() else { return false };
        match &mut self.far {
            Some(far) => far.planning.push(&block),
            None => self.planning.push(&block),
        }
        true
    }

    /// Plans the next block that is executed already. `false`: there is none.
    fn follow(&mut self) -> bool {
        let Some(far) = &mut self.far else { return false };
        let Some((block, _)) = self.execution.follow_with(&mut far.near) else { return false };
        self.planning.push(&block);
        true
    }

    /// Shows the blocks that have their times. `true`: there are more, whose stretch is not planned to its end.
    fn give(&mut self) -> ControlFlow<(), bool> {
        let ready = &mut self.planning.given;
        for motion_s in ready.no_jerk.drain(..) {
            self.sink.no_jerk(motion_s);
        }
        while let Some(times) = ready.blocks.front_mut() {
            let stretch =
                times.motion.as_mut().and_then(|motion| motion.stretch.as_mut().or(motion.joined_in.as_mut()));
            if let (Some(stretch), Some(far)) = (stretch, &mut self.far) {
                match far.planning.given.of(stretch.index) {
                    Some(whole) => stretch.time_dist_s = Some((whole - stretch.before_s).max(0.0)),
                    None => return ControlFlow::Continue(true),
                }
            }
            let Some((block, findings)) = self.execution.follow_with(&mut self.behind) else { break };
            self.sink.block(&block, times, findings)?;
            ready.blocks.pop_front();
        }
        ControlFlow::Continue(false)
    }
}
