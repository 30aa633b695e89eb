//! One execution of one program: the only loop over executed blocks there is.

use std::ops::ControlFlow;
use std::path::Path;

use super::checks::Checks;
use super::record::{Record, Recorder};
use super::{Outcome, Run, Session, is_stopped, offers};
use crate::config::Purpose;
use crate::diag::{Findings, StayedUnknown};
use crate::resolve::Resolved;
use crate::run::{End, Executed, Interpreter, LostCall, Passed, Program, Sink};
use crate::text::FileId;

/// Blocks between two reports of progress.
pub(super) const PROGRESS: u64 = 1 << 16;

/// A running execution. [`Session::run`] shows its blocks to a sink; other callers ask for them with [`Self::step`],
/// and callers that need later blocks before an earlier one follow with a second interpreter: see [`Self::follow`].
#[derive(Debug)]
pub struct Execution<'a> {
    session: Session<'a>,
    program: Program<'a>,
    interpreter: Interpreter,
    outcome: Outcome,
    purpose: Purpose,
    /// What else is looked for in the blocks.
    checks: Option<Box<Checks>>,
    /// No error was found, and nobody gave up.
    whole: bool,
    /// Blocks after an error are shown as well.
    despite_errors: bool,
    /// Somebody wants the findings no more.
    given_up: bool,
    /// Keeps from where execution can go on.
    recorder: Option<Box<Recorder>>,
}

impl<'a> Execution<'a> {
    /// Ready for the first block of a resolved program. The outcome is that of resolving it: with errors in it, the
    /// program is executed for what is still to be found, and no block is shown.
    pub(super) fn new(
        session: Session<'a>,
        path: &Path,
        resolved: Resolved,
        mut outcome: Outcome,
        purpose: Purpose,
    ) -> Self {
        let library = session.library(path);
        let sources = std::mem::take(&mut outcome.sources);
        let program = Program { resolved, settings: session.settings, library, sources };
        let interpreter = Interpreter::new(&program);
        let interpreter = if purpose == Purpose::Compile { interpreter.compiling() } else { interpreter };
        Self {
            session,
            program,
            interpreter,
            whole: !is_stopped(&outcome.findings, purpose),
            outcome,
            purpose,
            checks: None,
            despite_errors: false,
            given_up: false,
            recorder: None,
        }
    }

    /// The same, from where an interpreter of the program stands.
    pub(super) fn from(self, interpreter: Interpreter) -> Self {
        Self { interpreter, ..self }
    }

    /// The same, with a record: [`Self::finish_with_record`] gives it.
    pub(super) fn recorded(self) -> Self {
        Self { recorder: Some(Box::new(Recorder::new(self.interpreter.clone()))), ..self }
    }

    /// The same, with what else its run looks for in executed blocks.
    pub(super) fn with_checks(self) -> Self {
        let checks = Checks::of(self.session.settings, self.purpose);
        Self { checks, ..self }
    }

    /// Whether all blocks must be shown for what is looked for in them.
    pub(super) const fn has_checks(&self) -> bool {
        self.checks.is_some()
    }

    /// The same, with blocks after an error shown as well: for facts about a program with mistakes.
    #[must_use]
    pub fn despite_errors(self) -> Self {
        Self { despite_errors: true, ..self }
    }

    /// Whether no error was found so far, and nobody gave up.
    pub(super) const fn is_whole(&self) -> bool {
        self.whole
    }

    /// The program.
    pub const fn program(&self) -> &Program<'a> {
        &self.program
    }

    /// An interpreter of the program as it stands now; before the first step, one that stands before the first block.
    pub fn interpreter(&self) -> Interpreter {
        self.interpreter.clone()
    }

    /// The next block of what is a whole program so far, and where findings about it go. `None` at its end, where it
    /// cannot go on, when a block has an error, and when the run is cancelled: [`Self::finish`] tells them apart.
    #[inline]
    pub fn step(&mut self) -> Option<(Executed<'_>, &mut Findings)> {
        let executed = self.interpreter.executed();
        if !(self.whole || self.despite_errors) || self.is_over(executed) {
            return None;
        }
        let block = self.interpreter.step(&mut self.program, &mut self.outcome.findings)?;
        if let Some(recorder) = &mut self.recorder {
            recorder.block(&block);
        }
        let findings = &mut self.outcome.findings;
        if let Some(checks) = &mut self.checks {
            checks.block(&block, findings);
        }
        if is_stopped(findings, self.purpose) {
            self.whole = false;
            if !self.despite_errors {
                return None;
            }
        }
        Some((block, findings))
    }

    /// The next block of an interpreter that follows this execution: that is not ahead of it. What it finds is found
    /// already.
    pub fn follow<'r>(&'r mut self, follower: &'r mut Interpreter) -> Option<Executed<'r>> {
        self.follow_with(follower).map(|(block, _)| block)
    }

    /// The same, with where findings about the block go.
    pub(super) fn follow_with<'r>(
        &'r mut self,
        follower: &'r mut Interpreter,
    ) -> Option<(Executed<'r>, &'r mut Findings)> {
        if follower.executed() >= self.interpreter.executed() {
            return None;
        }
        let block = follower.step(&mut self.program, &mut Findings::new())?;
        Some((block, &mut self.outcome.findings))
    }

    /// Whether nothing is looked for in each block, and no block may have an error.
    fn may_pass_over(&self) -> bool {
        self.checks.is_none() && !self.given_up && !self.outcome.findings.has_errors()
    }

    /// Executes the points that come next at once, at most so many.
    #[inline]
    fn pass_over(&mut self, most: u64) -> Option<Passed<'_>> {
        let executed = self.interpreter.executed();
        let room = self.recorder.as_ref().map_or(u64::MAX, |recorder| recorder.room(executed));
        let most = most.min(room.min(PROGRESS - executed % PROGRESS) - 1);
        let passed = self.interpreter.pass_over(&self.program, most)?;
        if let Some(recorder) = &mut self.recorder {
            recorder.visit(passed.stretch());
        }
        Some(passed)
    }

    /// Nobody wants more: the program is not taken for whole.
    pub const fn give_up(&mut self) {
        self.whole = false;
        self.given_up = true;
    }

    /// Shows the blocks to a sink, up to the first that has an error.
    pub fn show(&mut self, sink: &mut impl Sink) {
        if !(self.whole || self.despite_errors) {
            return;
        }
        sink.begin(&self.program);
        let mut wanted = ControlFlow::Continue(());
        loop {
            let spared = self.interpreter.next().map_or(0, |next| sink.spares(next));
            if spared > 0
                && self.may_pass_over()
                && let Some(points) = self.pass_over(spared)
            {
                sink.passed(&points);
            }
            let Some((block, findings)) = self.step() else { break };
            wanted = sink.block(&block, findings);
            if wanted.is_break() {
                break;
            }
        }
        if wanted.is_break() {
            self.give_up();
        }
    }

    /// Finds what is still to be found, and gives how the program ended; `None` when it has errors, or was not executed
    /// to its end.
    pub(super) fn end(&mut self) -> Option<End> {
        while !self.is_over(self.interpreter.executed()) {
            self.pass_over(u64::MAX);
            let Some(block) = self.interpreter.step(&mut self.program, &mut self.outcome.findings) else { break };
            if let Some(recorder) = &mut self.recorder {
                recorder.block(&block);
            }
        }
        self.outcome.executed = self.interpreter.executed();
        let name = || self.program.sources.get(FileId(0)).map_or_else(String::new, |source| source.name().to_owned());
        self.outcome.stayed_unknown = self.interpreter.lost_call().map(|LostCall { n, l, missing }| {
            let file = name();
            StayedUnknown { file, n, l, missing }
        });
        let end = End::of(&self.interpreter, &self.outcome.findings).filter(|_| self.whole)?;
        if let Some(checks) = self.checks.take() {
            checks.end(end, &mut self.outcome.findings);
        }
        End::of(&self.interpreter, &self.outcome.findings)
    }

    /// Ends the run: what it found, and how the program ended; `None` when it has errors, or was not executed to its
    /// end.
    pub fn finish(mut self) -> Run<End> {
        let whole = self.end();
        Run { whole, outcome: self.into_outcome() }
    }

    /// The outcome of the run, and its record, when it has one.
    pub(super) fn finish_with_record(mut self) -> (Outcome, Option<Record>) {
        self.end();
        let Self { recorder, interpreter, program: Program { resolved, sources, .. }, .. } = &mut self;
        let record = recorder.take().map(|recorder| recorder.finish(interpreter, resolved, sources));
        (self.into_outcome(), record)
    }

    /// The same, with what a sink made of the program.
    pub(super) fn finish_with<S: Sink>(self, sink: S) -> Run<S::Whole> {
        self.finish_by(|end, findings| sink.end(end, findings))
    }

    /// The same, with what is made of a whole program.
    pub(super) fn finish_by<T>(mut self, make: impl FnOnce(End, &mut Findings) -> T) -> Run<T> {
        let made = self.end().map(|end| make(end, &mut self.outcome.findings));
        // The sink may have found errors at the end.
        let whole = made.filter(|_| !self.outcome.findings.has_errors());
        Run { whole, outcome: self.into_outcome() }
    }

    fn into_outcome(mut self) -> Outcome {
        offers::add(&mut self.outcome.findings, &self.program.resolved);
        Outcome { sources: self.program.sources, ..self.outcome }
    }

    /// Whether no more blocks are executed after so many.
    fn is_over(&mut self, executed: u64) -> bool {
        if !self.session.goes_on(executed) {
            self.give_up();
        }
        self.given_up
    }
}
