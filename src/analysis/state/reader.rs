//! The reader: one pass over the executed blocks, to the place and on to the end.

use std::ops::ControlFlow;

use super::before::Before;
use super::clock::{Clock, Progress, TimedProgress};
use super::errors::Errors;
use super::place::{Arrival, Asked, CallAt, Finder, PlaceFault, calls};
use super::unknown::{Axes, Unknown};
use super::writers::{Slot, Writers, Written};
use crate::config::Settings;
use crate::diag::Findings;
use crate::dict::{AxisLetter, Micro, TOOL_CHANGE};
use crate::run::{ArmedCounter, End, Executed, MotionType, Program, Sink, State};

/// Executions of a block that are listed.
const LISTED: usize = 40;

/// A counter at a place.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct CounterAt {
    /// The number of the jump's block.
    pub n: u32,
    /// Index of its file.
    pub file: u32,
    /// The line of its `N`.
    pub line: u32,
    /// Jumps left.
    pub left: u32,
    /// Of how many.
    pub of: u32,
}

/// What holds at a place.
#[derive(Clone, Debug)]
pub struct Found {
    /// The block.
    pub seq: u64,
    /// Its number.
    pub n: u32,
    /// Index of its file.
    pub file: u32,
    /// The name of its file.
    pub file_name: String,
    /// The line of its `N`.
    pub line: u32,
    /// The column of its `N`.
    pub column: u32,
    /// How execution got there.
    pub calls: Vec<CallAt>,
    /// Behind the block, not before it.
    pub after: bool,
    /// What is in force.
    pub state: State,
    /// Who wrote what last.
    pub written: Vec<(Slot, Written)>,
    /// Axes whose position is not known, and why; those that the program moves.
    pub unknown: Vec<(AxisLetter, Unknown)>,
    /// Armed counters, outermost first.
    pub counters: Vec<CounterAt>,
    /// Blocks executed and left.
    pub blocks: Progress<u64>,
    /// The known path in mm.
    pub path: Progress<Micro>,
    /// The times.
    pub times: TimedProgress,
    /// The whole program was executed.
    pub whole: bool,
    /// The next executed block with M06.
    pub next_tool_change: Option<u64>,
    /// The next that stops: M00, or M01 with optional stop.
    pub next_stop: Option<u64>,
    /// The next that moves by G00.
    pub next_rapid: Option<u64>,
}

/// Reads the blocks of one execution, for one place.
#[derive(Debug)]
pub struct StateReader {
    finder: Finder,
    clock: Clock,
    errors: Errors,
    before: Before,
    writers: Writers,
    axes: Axes,
    arrivals: Vec<Arrival>,
    count: u64,
    executed: u64,
    blocks: Progress<u64>,
    path: Progress<Micro>,
    changed: bool,
    found: Option<Box<Found>>,
}

impl StateReader {
    /// For a program that is executed with these settings.
    pub fn new(settings: &Settings, asked: Asked) -> Self {
        Self {
            finder: Finder::new(asked),
            clock: Clock::new(settings),
            errors: Errors::default(),
            before: Before::new(settings),
            writers: Writers::default(),
            axes: Axes::default(),
            arrivals: Vec::new(),
            count: 0,
            executed: 0,
            blocks: Progress::default(),
            path: Progress::default(),
            changed: false,
            found: None,
        }
    }

    /// What holds at the place. `whole`: the program was executed to its end, without errors.
    ///
    /// # Errors
    /// When there is no such place, or several.
    pub fn finish(self, whole: bool) -> Result<Box<Found>, PlaceFault> {
        let asked = self.finder.asked();
        let Some(mut found) = self.found else {
            return Err(match (asked.pass, self.count) {
                (Some(_), count @ 1..) => PlaceFault::Passes { count },
                _ => self.finder.fault(self.executed),
            });
        };
        if asked.pass.is_none() && self.count > 1 {
            return Err(PlaceFault::Several { arrivals: self.arrivals, count: self.count });
        }
        found.unknown.retain(|(letter, _)| self.axes.is_moved(*letter));
        (found.blocks, found.path, found.times) = (self.blocks, self.path, self.clock.finish());
        found.whole = whole;
        Ok(found)
    }

    /// Whether an error stands before the place: that comes first.
    pub fn has_error_before(&self) -> bool {
        let place = self.found.as_ref().map_or(u64::MAX, |found| found.seq);
        let after = self.finder.asked().after;
        self.errors.first().is_some_and(|first| first < place || after && first == place)
    }

    /// Whether errors were found after the last block, as those of joints are (W0801 to W0804).
    pub fn has_late_error(&self, findings: &Findings) -> bool {
        self.errors.came_late(findings)
    }

    /// Whether this execution of the block is the one that is asked for.
    fn arrives(&mut self, block: &Executed<'_>) -> bool {
        if !self.finder.is_here(block) {
            return false;
        }
        self.count += 1;
        let asked = self.finder.asked();
        if asked.pass.is_none() && self.arrivals.len() < LISTED {
            let (seq, n, line) = (block.seq(), block.n(), block.line());
            self.arrivals.push(Arrival { seq, n, line, calls: calls(block) });
        }
        self.count == asked.pass.unwrap_or(1)
    }

    /// Keeps what holds now, before or behind the block.
    fn keep(&mut self, block: &Executed<'_>, after: bool) {
        let settings = block.settings();
        let mut state = self.before.state().clone();
        if after && block.last() {
            state.reset_functions(&settings.machine);
        }
        let axes = || settings.machine.axes.iter().enumerate();
        let unknown = axes().filter(|(place, _)| state.axis_position(*place).is_none());
        let unknown = unknown.map(|(_, axis)| (axis.letter, self.axes.why(axis.letter))).collect();
        let is_known = |slot: &Slot| match slot {
            Slot::Axis(letter) => {
                axes().any(|(place, axis)| axis.letter == *letter && state.axis_position(place).is_some())
            }
            Slot::R(index) => state.parameter(*index).is_some(),
            Slot::M(group) => state.m_in_force(*group).is_some(),
            Slot::G(_) | Slot::Value(_) => true,
        };
        let written = self.writers.of(Slot::all().filter(is_known), block);
        let place = block.line_column();
        self.found = Some(Box::new(Found {
            seq: block.seq(),
            n: block.n(),
            file: block.file_index(),
            file_name: block.file_name().to_owned(),
            line: place.line,
            column: place.column,
            calls: calls(block),
            after,
            written,
            unknown,
            counters: self.counters_at(block, after),
            state,
            blocks: Progress::default(),
            path: Progress::default(),
            times: TimedProgress::default(),
            whole: false,
            next_tool_change: None,
            next_stop: None,
            next_rapid: None,
        }));
    }

    /// The armed counters of the calls that are open at a block, before or behind it: that of its own jump is what it was.
    fn counters_at(&self, block: &Executed<'_>, after: bool) -> Vec<CounterAt> {
        let (depth, (file, id)) = (block.depth(), block.at());
        let is_own = |counter: &ArmedCounter| counter.depth == depth && counter.file == file && counter.block == id;
        let others = block.counters().filter(|counter| after || !is_own(counter));
        let own = self.before.counters().iter().copied().filter(|counter| !after && is_own(counter));
        let mut counters: Vec<ArmedCounter> = others.chain(own).collect();
        counters.sort_by_key(|counter| (counter.depth, counter.block));
        let at = |counter: ArmedCounter| {
            let file = block.file_of(counter.file)?;
            let line = block.line_of(file.n_place(counter.block));
            let (n, file) = (file.shown_number(counter.block), block.index_of(counter.file));
            Some(CounterAt { n, file, line, left: counter.left, of: counter.of })
        };
        counters.into_iter().filter_map(at).collect()
    }

    /// Counts a block as done or left.
    fn tally(&mut self, block: &Executed<'_>, left: bool, change: bool) {
        let length = block.motion().and_then(|motion| motion.length().mm()).unwrap_or_default();
        if change && left {
            self.changed = true;
        } else if change {
            (self.blocks.tool_done, self.path.tool_done) = (0, Micro::ZERO);
        }
        if !left {
            self.blocks.done += 1;
            self.blocks.tool_done += 1;
            self.path.done = self.path.done.plus(length);
            self.path.tool_done = self.path.tool_done.plus(length);
            return;
        }
        self.blocks.left += 1;
        self.path.left = self.path.left.plus(length);
        if !self.changed {
            self.blocks.tool_left += 1;
            self.path.tool_left = self.path.tool_left.plus(length);
        }
        let Some(found) = &mut self.found else { return };
        let seq = Some(block.seq());
        let stops = block.m_at_stop().is_some();
        let rapid = block.motion().is_some_and(|motion| motion.kind() == MotionType::Rapid);
        found.next_tool_change = found.next_tool_change.or(seq.filter(|_| change));
        found.next_stop = found.next_stop.or(seq.filter(|_| stops));
        found.next_rapid = found.next_rapid.or(seq.filter(|_| rapid));
    }

    /// What is known after a block.
    fn pass(&mut self, block: &Executed<'_>) {
        self.writers.note(block, self.before.state());
        self.axes.pass(block, self.before.state());
        self.before.pass(block);
    }
}

impl Sink for &mut StateReader {
    type Whole = End;

    fn begin(&mut self, program: &Program<'_>) {
        self.before = Before::new(program.settings);
    }

    fn block(&mut self, block: &Executed<'_>, findings: &mut Findings) -> ControlFlow<()> {
        self.errors.look(block, findings);
        self.executed += 1;
        self.before.arrive(block);
        let arrives = self.arrives(block);
        let after = self.finder.asked().after;
        let was_found = self.found.is_some();
        if arrives && !after {
            self.keep(block, false);
        }
        let change = block.m_written().contains(&TOOL_CHANGE);
        let left = self.found.is_some();
        self.clock.push(block, change, left && self.blocks.left == 0);
        self.tally(block, left, change);
        self.pass(block);
        if arrives && after && !was_found {
            self.keep(block, true);
        }
        ControlFlow::Continue(())
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        end
    }
}
