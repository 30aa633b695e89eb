//! What holds between two executed blocks.

use crate::config::Settings;
use crate::diag::CallKind;
use crate::dict::{GCode, GGroup};
use crate::run::{ArmedCounter, AxisSet, Executed, Passed, State};

/// What holds before the next block: call [`Self::arrive`] at a block, ask, then [`Self::pass`] it.
#[derive(Clone, Debug)]
pub struct Before {
    state: State,
    /// The fixed cycle that is in force again behind the macrocycle that it calls.
    suspended: Option<GCode>,
    counters: Vec<ArmedCounter>,
}

impl Before {
    /// Before the first block.
    pub fn new(settings: &Settings) -> Self {
        Self { state: State::new(settings), suspended: None, counters: Vec::new() }
    }

    /// What is in force.
    pub const fn state(&self) -> &State {
        &self.state
    }

    /// The armed counters, outermost call first; those of calls that have ended since may still be among them.
    pub fn counters(&self) -> &[ArmedCounter] {
        &self.counters
    }

    /// What a call of the cycle map, or the return from it, changes before a block (GRP-6).
    #[inline]
    pub fn arrive(&mut self, block: &Executed<'_>) {
        if block.moves_on() {
            return;
        }
        let in_cycle = block.calls().any(|call| matches!(call.by, CallKind::Cycle(_)));
        if in_cycle && self.suspended.is_none() {
            self.suspended = self.state.g_in_force(GGroup::G8);
            self.state.set_cycle(GCode::G80);
        } else if let Some(cycle) = self.suspended.take_if(|_| !in_cycle) {
            self.state.set_cycle(cycle);
        }
        self.state.pass_machine_call();
    }

    /// The axes that a block left elsewhere; those of points are not looked up.
    #[inline]
    pub fn elsewhere(&self, block: &Executed<'_>) -> AxisSet {
        if block.moves_on() { AxisSet::default() } else { block.state().axes_elsewhere(&self.state) }
    }

    /// Becomes what holds after the block.
    #[inline]
    pub fn pass(&mut self, block: &Executed<'_>) {
        if !block.moves_on() {
            self.counters.clear();
            self.counters.extend(block.counters());
        }
        self.state.follow(block);
    }

    /// Becomes what holds after points.
    pub fn pass_over(&mut self, points: &Passed<'_>) {
        self.state.follow_points(points);
    }
}
