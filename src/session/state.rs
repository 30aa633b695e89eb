//! What holds at a place of a program, with the times around it.

use std::path::Path;

use super::{Execution, Outcome, Session};
use crate::analysis::state::{Asked, Clock, Found, PlaceFault, Progress, StateReader, TimedProgress, Timing};
use crate::config::Purpose;
use crate::run::Interpreter;

/// What `state` gives.
#[derive(Debug)]
pub struct StateRun {
    /// What was found on the way.
    pub outcome: Outcome,
    /// Whether the program was executed to its end, without errors.
    pub whole: bool,
    /// Whether an error stands before the place: that comes first.
    pub error_before: bool,
    /// What holds there; the fault when there is no such place, or several.
    pub found: Result<Box<Found>, PlaceFault>,
}

impl Session<'_> {
    /// What holds at a place of the program at `path`, which the user calls `name`.
    pub fn state(&self, path: &Path, name: &str, asked: Asked, timing: Timing) -> StateRun {
        let mut reader = StateReader::new(self.settings, asked);
        let mut execution = match self.open(path, name, Purpose::Report) {
            Ok(execution) => execution.despite_errors(),
            Err(outcome) => {
                let found = reader.found();
                return StateRun { outcome: *outcome, whole: false, error_before: false, found };
            }
        };
        let start = execution.interpreter();
        execution.show(&mut &mut reader);
        let mut found = reader.found();
        let error_before = reader.has_error_before();
        if let Ok(found) = &mut found
            && !error_before
            && timing.wants(self.settings, found.blocks.done + found.blocks.left)
        {
            found.times = self.times(&mut execution, start, found.blocks);
        }
        let run = execution.finish();
        let whole = run.whole.is_some();
        if let Ok(found) = &mut found {
            found.whole = whole;
        }
        let error_before = error_before || reader.has_late_error(&run.outcome.findings);
        StateRun { outcome: run.outcome, whole, error_before, found }
    }

    /// The times of what was executed; `None` when nobody waits for them any more.
    fn times(
        &self,
        execution: &mut Execution<'_>,
        mut behind: Interpreter,
        blocks: Progress<u64>,
    ) -> Option<TimedProgress> {
        let mut clock = Clock::new(self.settings, blocks);
        while let Some(block) = execution.follow(&mut behind) {
            if !self.goes_on(block.seq()) {
                return None;
            }
            clock.push(&block);
        }
        Some(clock.finish())
    }
}
