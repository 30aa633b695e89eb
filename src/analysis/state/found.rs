//! What holds at a place.

use super::clock::{Progress, TimedProgress};
use super::follow::{Next, Tally};
use super::place::CallAt;
use super::unknown::Unknown;
use super::writers::{Slot, Written};
use crate::dict::{AxisLetter, Micro};
use crate::run::State;

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
    /// The times; `None`: nobody asked, or there are too many blocks, see [`Timing`](super::Timing).
    pub times: Option<TimedProgress>,
    /// The whole program was executed.
    pub whole: bool,
    /// The next executed block with M06.
    pub next_tool_change: Option<u64>,
    /// The next that stops: M00, or M01 with optional stop.
    pub next_stop: Option<u64>,
    /// The next that moves by G00.
    pub next_rapid: Option<u64>,
}

impl Found {
    /// The block that wrote something last.
    pub fn writer(&self, slot: Slot) -> Option<&Written> {
        self.written.iter().find(|(written, _)| *written == slot).map(|(_, written)| written)
    }

    /// Whether some times are not known, or the program does not get to its end.
    pub fn is_lower_bound(&self) -> bool {
        !self.whole || self.times.is_none_or(|times| times.lower_bound)
    }

    /// Adds what is left; `done`: before the place, `end`: when the program ends.
    pub(super) fn add_left(&mut self, done: Tally, next: Next, end: Tally) {
        let change = next.change.map_or(end, |(_, tally)| tally);
        self.blocks.left = end.blocks - done.blocks;
        self.blocks.tool_left = change.blocks - done.blocks;
        self.path.left = end.path.minus(done.path);
        self.path.tool_left = change.path.minus(done.path);
        self.next_tool_change = next.change.map(|(seq, _)| seq);
        (self.next_stop, self.next_rapid) = (next.stop, next.rapid);
    }
}
