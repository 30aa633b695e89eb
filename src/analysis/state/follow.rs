//! Follows an execution from block to block: state, writers, executed blocks and path.

use super::before::Before;
use super::clock::Progress;
use super::found::{CounterAt, Found};
use super::place::calls;
use super::unknown::Axes;
use super::writers::{Slot, Writers};
use crate::config::Settings;
use crate::dict::{AxisLetter, Micro, TOOL_CHANGE};
use crate::parallel::{map, threads};
use crate::run::{ArmedCounter, Executed, MotionType, Passed, PointPath, Points};
use crate::sure::small;

/// Blocks that were executed, and their known path.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    /// How many.
    pub blocks: u64,
    /// In mm.
    pub path: Micro,
}

impl Tally {
    /// With one more block.
    #[inline]
    fn add(&mut self, block: &Executed<'_>) {
        let length = block.motion().and_then(|motion| motion.length().mm()).unwrap_or_default();
        self.blocks += 1;
        self.path = self.path.plus(length);
    }
}

/// What comes next from a place on, each with what is done before it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Next {
    /// The next executed block with M06.
    pub change: Option<(u64, Tally)>,
    /// The next that stops.
    pub stop: Option<u64>,
    /// The next that moves by G00.
    pub rapid: Option<u64>,
}

impl Next {
    /// Looks at a block from the place on; `done`: before it.
    #[inline]
    pub fn look(&mut self, block: &Executed<'_>, done: Tally) {
        let seq = block.seq();
        if self.rapid.is_none() && block.motion().is_some_and(|motion| motion.kind() == MotionType::Rapid) {
            self.rapid = Some(seq);
        }
        if block.moves_on() {
            return;
        }
        if self.change.is_none() && changes_tool(block) {
            self.change = Some((seq, done));
        }
        if self.stop.is_none() && block.m_at_stop().is_some() {
            self.stop = Some(seq);
        }
    }

    /// Looks at points from the place on.
    pub fn look_at_points(&mut self, points: &Passed<'_>) {
        if points.kind() == MotionType::Rapid {
            self.rapid = self.rapid.or(Some(points.first_seq()));
        }
    }

    /// With what comes behind these.
    pub fn or(self, later: Self) -> Self {
        let Self { change, stop, rapid } = self;
        Self { change: change.or(later.change), stop: stop.or(later.stop), rapid: rapid.or(later.rapid) }
    }
}

/// Whether a block holds M06.
pub(super) fn changes_tool(block: &Executed<'_>) -> bool {
    block.m_written().contains(&TOOL_CHANGE)
}

/// How long the paths of points are. Loops come to the same points again and again, mostly from the same position.
#[derive(Debug, Default)]
pub(super) struct Lengths {
    /// Those computed last, by the first block.
    known: [Option<(Points, Micro)>; 16],
}

impl Lengths {
    /// In mm.
    pub fn of(&mut self, passed: &Passed<'_>) -> Micro {
        let (points, stretch) = (passed.points(), passed.stretch());
        let place = stretch.first.index() % self.known.len();
        if let Some(Some((known, length))) = self.known.get(place)
            && known == points
        {
            return *length;
        }
        let length = passed.path().map_or(Micro::ZERO, |path| match stretch.count() {
            0..10_000 => path.length(),
            // Beside each other saves more than it costs.
            _ => map(path.parts(small(threads())), PointPath::length).into_iter().fold(Micro::ZERO, Micro::plus),
        });
        if let Some(slot) = self.known.get_mut(place) {
            *slot = Some((*points, length));
        }
        length
    }
}

/// State, writers and tallies before the next block: call [`Self::arrive`] at a block, ask, then [`Self::pass`] it.
#[derive(Clone, Debug)]
pub(super) struct Follow {
    before: Before,
    writers: Writers,
    axes: Axes,
    /// Before the next block.
    done: Tally,
    /// Before the last tool change.
    change: Tally,
}

impl Follow {
    /// Before the first block.
    pub fn new(settings: &Settings) -> Self {
        Self {
            before: Before::new(settings),
            writers: Writers::default(),
            axes: Axes::new(settings),
            done: Tally::default(),
            change: Tally::default(),
        }
    }

    /// Blocks and path before the next block.
    pub const fn done(&self) -> Tally {
        self.done
    }

    /// Whether the program moved an axis so far.
    pub fn is_moved(&self, letter: AxisLetter) -> bool {
        self.axes.is_moved(letter)
    }

    /// Applies the change of the fixed cycle at a call of the cycle map, and at its return (GRP-6).
    #[inline]
    pub fn arrive(&mut self, block: &Executed<'_>) {
        self.before.arrive(block);
    }

    /// Follows a block.
    #[inline]
    pub fn pass(&mut self, block: &Executed<'_>) {
        if !block.moves_on() && changes_tool(block) {
            self.change = self.done;
        }
        self.done.add(block);
        let elsewhere = self.before.elsewhere(block);
        self.writers.note(block, self.before.state(), elsewhere);
        self.axes.pass(block, elsewhere);
        self.before.pass(block);
    }

    /// Counts a block, and notes what it moves: nobody asks any more what is in force.
    #[inline]
    pub fn count(&mut self, block: &Executed<'_>) {
        self.done.add(block);
        self.axes.note_moves(block);
    }

    /// Follows points that were executed at once; `length`: of their path.
    pub fn pass_over(&mut self, points: &Passed<'_>, length: Micro) {
        self.count_points(points, length);
        self.writers.note_points(points);
        self.before.pass_over(points);
    }

    /// Counts points, and notes what they move.
    pub fn count_points(&mut self, points: &Passed<'_>, length: Micro) {
        self.done.blocks += u64::from(points.stretch().count());
        self.done.path = self.done.path.plus(length);
        self.axes.pass_over(points);
    }

    /// What holds before or behind a block, without what is left.
    pub fn found(&self, block: &Executed<'_>, after: bool) -> Found {
        let settings = block.settings();
        let mut state = self.before.state().clone();
        if after && block.last() {
            state.reset_functions(&settings.machine);
        }
        // Behind its call a macrocycle of the machine has run.
        if after {
            state.pass_machine_call();
        }
        let axes = || settings.machine.axes.iter().enumerate();
        let unknown = axes().filter(|(place, _)| state.axis_position(*place).is_none());
        let unknown = unknown.map(|(_, axis)| (axis.letter, self.axes.why(axis.letter))).collect();
        let is_known = |slot: &Slot| match slot {
            Slot::Axis(letter) => {
                axes().any(|(place, axis)| axis.letter == *letter && state.axis_position(place).is_some())
            }
            Slot::R(index) => state.parameter(*index).is_some() || state.is_lost(*index),
            Slot::M(group) => state.m_in_force(*group).is_some(),
            Slot::G(_) | Slot::Value(_) => true,
        };
        let written = self.writers.of(Slot::all().filter(is_known), block);
        let place = block.line_column();
        Found {
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
            blocks: Progress {
                done: self.done.blocks,
                tool_done: self.done.blocks - self.change.blocks,
                ..Progress::default()
            },
            path: Progress {
                done: self.done.path,
                tool_done: self.done.path.minus(self.change.path),
                ..Progress::default()
            },
            times: None,
            whole: false,
            next_tool_change: None,
            next_stop: None,
            next_rapid: None,
        }
    }

    /// The armed counters of the open calls, before or behind a block. Before the block its jump has not counted yet.
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
}
