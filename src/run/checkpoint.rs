//! The state of execution between two blocks, kept to go on from there.

use super::Executor;
use super::state::State;
use crate::dict::GCode;

/// What execution knows between two blocks of the main program, outside of calls and jumps. Two that are equal lead to the
/// same in all that follows.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    state: State,
    feed_warned: bool,
    speed_warned: bool,
    incremental_warned: [bool; 9],
    unmodelled_warned: Vec<GCode>,
    unassigned_warned: [bool; 96],
}

impl Executor<'_, '_> {
    /// What is known after the last step.
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            state: self.state.clone(),
            feed_warned: self.feed_warned,
            speed_warned: self.speed_warned,
            incremental_warned: self.incremental_warned,
            unmodelled_warned: self.unmodelled_warned.clone(),
            unassigned_warned: self.unassigned_warned,
        }
    }

    /// Begins with what was known there, in place of the state after power-up. For an executor that made no step yet.
    pub fn resume(&mut self, from: &Checkpoint) {
        self.state = from.state.clone();
        self.feed_warned = from.feed_warned;
        self.speed_warned = from.speed_warned;
        self.incremental_warned = from.incremental_warned;
        self.unmodelled_warned.clone_from(&from.unmodelled_warned);
        self.unassigned_warned = from.unassigned_warned;
    }
}
