//! One run over one program or macrocycle: load, resolve, execute, report. What the command line and the editor call.

mod checks;
mod compared;
mod execution;
mod offers;
mod record;
mod signals;
mod state;
mod timed;

use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

use crate::config::{Purpose, Settings};
use crate::diag::{Code, Diagnostic, Finding, Findings, NotExecuted, Problem, Report, StayedUnknown};
use crate::resolve::{Library, Resolved, is_program, report_misnamed, resolve};
use crate::run::{End, Interpreter, Sink};
use crate::stream;
use crate::text::{Encoding, FileId, Loader, Location, SourceText, Sources, Span};
pub use execution::Execution;
use execution::PROGRESS;
pub use record::Record;
pub use signals::TimedSignals;
pub use state::StateRun;
pub use timed::{TimedSink, Times};

pub use crate::analysis::Part;

/// The findings of a run, with the texts that they refer to.
#[derive(Debug, Default)]
pub struct Outcome {
    /// The files read; the program is file 0.
    pub sources: Sources,
    /// The findings at the levels of the run, unsorted.
    pub findings: Findings,
    /// Whether the program itself could not be read, or is not what the command takes.
    pub unusable: bool,
    /// Blocks executed.
    pub executed: u64,
    /// That the program was not executed, and why; nothing for a macrocycle, and for a file that cannot be read.
    pub not_executed: Option<NotExecuted>,
    /// The first call that could not be followed: positions are not known after it.
    pub stayed_unknown: Option<StayedUnknown>,
}

impl Outcome {
    /// Adds what was found in the program to a report.
    pub fn add_to(self, report: &mut Report) {
        let Self { sources, findings, not_executed, stayed_unknown, .. } = self;
        report.add_program(&sources, findings);
        not_executed.into_iter().for_each(|program| report.add_not_executed(program));
        stayed_unknown.into_iter().for_each(|unknown| report.add_unknown(unknown));
    }

    /// Whether a file could not be read, be it the program or a macrocycle that it calls, or the program is not what
    /// the command takes: exit status 2.
    pub fn lacks_file(&self) -> bool {
        self.findings.has(Code::E0112)
    }
}

/// A run with a sink: what was found, and what the sink made of the program.
#[derive(Debug)]
pub struct Run<T> {
    /// The findings, with the texts that they are in.
    pub outcome: Outcome,
    /// The sink's result for the whole program. `None`: the program has errors, or was not executed to its end.
    pub whole: Option<T>,
}

/// Runs programs with one loader and one configuration.
#[derive(Clone, Copy)]
pub struct Session<'a> {
    /// Where files come from.
    pub loader: &'a dyn Loader,
    /// The configuration.
    pub settings: &'a Settings,
    /// Called from time to time during long work with the number of blocks executed; `false` stops the run.
    pub progress: Option<&'a (dyn Fn(u64) -> bool + Sync)>,
}

impl<'a> Session<'a> {
    /// Checks the program or macrocycle at `path`, which the user calls `name`: everything that `check` finds.
    pub fn check(&self, path: &Path, name: &str) -> Outcome {
        match self.open(path, name, Purpose::Check) {
            Ok(mut execution) => {
                if execution.has_checks() {
                    execution.show(&mut ());
                }
                execution.finish().outcome
            }
            Err(outcome) => *outcome,
        }
    }

    /// Compiles the program at `path` to `out`. The stream has its `end` record when the run is whole, and only then.
    ///
    /// # Errors
    /// What writing to `out` gives.
    pub fn compile(&self, path: &Path, name: &str, part: Part, out: &mut (dyn Write + Send)) -> io::Result<Run<End>> {
        stream::write(out, self.settings, part, |sink| self.run(path, name, Purpose::Compile, sink))
    }

    /// Executes the program at `path`, which the user calls `name`, and shows each executed block to `sink`. Of a
    /// macrocycle it checks only the text.
    pub fn run<S: Sink>(&self, path: &Path, name: &str, purpose: Purpose, sink: S) -> Run<S::Whole> {
        match self.open(path, name, purpose) {
            Ok(execution) => show(execution, sink),
            Err(outcome) => Run { outcome: *outcome, whole: None },
        }
    }

    /// The same, with the blocks shown despite errors: for a sink that itself ends where it wants no more.
    pub fn draw<S: Sink>(&self, path: &Path, name: &str, sink: S) -> Run<S::Whole> {
        match self.open(path, name, Purpose::Compile) {
            Ok(execution) => show(execution.despite_errors(), sink),
            Err(outcome) => Run { outcome: *outcome, whole: None },
        }
    }

    /// Executes the program at `path`, which the user calls `name`, as far as possible, and shows every executed block
    /// to `sink`, also those after an error.
    pub fn watch(&self, path: &Path, name: &str, purpose: Purpose, sink: &mut impl Sink) -> Run<End> {
        match self.open(path, name, purpose) {
            Ok(execution) => {
                let mut execution = execution.despite_errors();
                execution.show(sink);
                execution.finish()
            }
            Err(outcome) => Run { outcome: *outcome, whole: None },
        }
    }

    /// The outcome of a run that is not whole. Where no error says why, a parameter that only the machine knows keeps
    /// the program from its end: an error, as in a compilation.
    pub fn why_unfinished(&self, path: &Path, name: &str, outcome: Outcome) -> Outcome {
        if outcome.findings.has_errors() || outcome.unusable {
            return outcome;
        }
        self.run(path, name, Purpose::Compile, ()).outcome
    }

    /// Resolves the program at `path`, which the user calls `name`, for an execution whose blocks the caller asks for.
    ///
    /// # Errors
    /// What was found, when there is nothing to execute: the file cannot be read, has no blocks, is for another
    /// control, or is a macrocycle.
    pub fn open(&self, path: &Path, name: &str, purpose: Purpose) -> Result<Execution<'a>, Box<Outcome>> {
        let (mut outcome, resolved) = self.resolve_for(path, name, purpose);
        let is_macrocycle = Self::is_macrocycle_name(path) && resolved.main().is_none();
        if purpose != Purpose::Check && is_macrocycle && !outcome.unusable {
            outcome = self.outcome(purpose);
            self.refuse(name, Problem::MacrocycleGiven, &mut outcome);
            return Err(Box::new(outcome));
        }
        if !Self::can_execute(&resolved) {
            if !is_macrocycle && !outcome.unusable {
                outcome.not_executed = first_fault(&outcome, name);
            }
            return Err(Box::new(outcome));
        }
        Ok(Execution::new(*self, path, resolved, outcome, purpose).with_checks())
    }

    /// The first half of [`Self::check`]: what is found without executing the program.
    pub fn resolve(&self, path: &Path, name: &str) -> (Outcome, Resolved) {
        self.resolve_for(path, name, Purpose::Check)
    }

    fn resolve_for(&self, path: &Path, name: &str, purpose: Purpose) -> (Outcome, Resolved) {
        let mut outcome = self.outcome(purpose);
        let Some(source) = self.read(path, name, &mut outcome) else { return (outcome, Resolved::default()) };
        let mut library = self.library(path);
        let Outcome { sources, findings, .. } = &mut outcome;
        let number = Library::number(path);
        let macrocycle = number.filter(|_| !is_program(&source));
        let resolved = resolve(&source, macrocycle, self.settings, &mut library, sources, findings);
        if let Some(l) = number {
            report_misnamed(&resolved, l, findings);
        }
        offers::add(&mut outcome.findings, &resolved);
        (outcome, resolved)
    }

    /// Whether the second half of [`Self::check`] follows: it is a program with blocks. What is wrong does not keep it
    /// from being executed: what it would have set or called is unknown then (§13).
    pub fn can_execute(resolved: &Resolved) -> bool {
        let main = resolved.main().and_then(|id| resolved.unit(id));
        main.is_some_and(|main| main.first < main.end)
    }

    /// Nothing found yet, at the levels of the run.
    fn outcome(&self, purpose: Purpose) -> Outcome {
        let findings = Findings::with_levels(self.settings.levels(purpose));
        Outcome { findings, ..Outcome::default() }
    }

    /// The second half of [`Self::check`]: executes a resolved program and shows its blocks to `sink`. What execution
    /// finds joins the outcome.
    pub fn execute<S: Sink>(&self, path: &Path, resolved: Resolved, outcome: Outcome, sink: S) -> Run<S::Whole> {
        show(Execution::new(*self, path, resolved, outcome, Purpose::Check), sink)
    }

    /// The second half of [`Self::check`] with a record of the execution, from which questions about it are answered.
    pub fn execute_recorded(&self, path: &Path, resolved: Resolved, outcome: Outcome) -> (Outcome, Option<Record>) {
        let mut execution = Execution::new(*self, path, resolved, outcome, Purpose::Check).with_checks().recorded();
        if execution.has_checks() {
            execution.show(&mut ());
        }
        execution.finish_with_record()
    }

    /// Executes once more a resolved program that has no written errors, and shows every executed block to `sink`, also
    /// those after an error. What execution finds is known already.
    pub fn observe(&self, path: &Path, resolved: Resolved, sources: Sources, mut sink: impl Sink) {
        let outcome = Outcome { sources, ..self.outcome(Purpose::Check) };
        Execution::new(*self, path, resolved, outcome, Purpose::Check).despite_errors().show(&mut sink);
    }

    /// The same for the blocks that execution comes by from a checkpoint on.
    pub fn observe_from(
        &self,
        path: &Path,
        (resolved, sources): (&Resolved, &Sources),
        checkpoint: &Interpreter,
        mut sink: impl Sink,
    ) {
        let outcome = Outcome { sources: sources.clone(), ..self.outcome(Purpose::Check) };
        let execution = Execution::new(*self, path, resolved.clone(), outcome, Purpose::Check);
        execution.from(checkpoint.clone()).despite_errors().show(&mut sink);
    }

    /// The macrocycles that the program at `path` may call.
    pub fn library(&self, path: &Path) -> Library<'a> {
        let Settings { machine, macrocycles, .. } = self.settings;
        Library::new(self.loader, macrocycles, path).with_machine(&machine.macrocycles)
    }

    /// Whether the name is that of a macrocycle file: `L` and its number, with no extension, `.NC`, `.NCP`, `.MRC` or
    /// `.TXT`, in either case (PRG-6).
    pub fn is_macrocycle_name(path: &Path) -> bool {
        Library::number(path).is_some()
    }

    /// Whether a file is a macrocycle: named as one, and no program (PRG-6). One that cannot be read goes by its name.
    pub fn is_macrocycle(path: &Path, loader: &dyn Loader) -> bool {
        let source = || loader.load(path, "", Encoding::default());
        Self::is_macrocycle_name(path) && !source().is_ok_and(|source| is_program(&source))
    }

    /// Whether the caller wants more after so many blocks, who is asked after each [`PROGRESS`] of them.
    #[inline]
    fn goes_on(&self, executed: u64) -> bool {
        let is_asked = executed > 0 && executed.is_multiple_of(PROGRESS);
        !is_asked || self.progress.is_none_or(|progress| progress(executed))
    }

    fn read(&self, path: &Path, name: &str, outcome: &mut Outcome) -> Option<Arc<SourceText>> {
        match self.loader.load(path, name, self.settings.encoding) {
            Ok(source) => Some(source),
            Err(error) => {
                let problem = Problem::from_io(&error);
                let pattern = problem == Problem::NotFound && name.contains(['*', '?']);
                let problem = if pattern { Problem::Pattern } else { problem };
                self.refuse(name, problem, outcome);
                None
            }
        }
    }

    fn refuse(&self, name: &str, problem: Problem, outcome: &mut Outcome) {
        outcome.sources.add(SourceText::from_text(name, ""));
        outcome.unusable = true;
        let at = Location { file: FileId(0), span: Span::empty(0) };
        outcome.findings.add(Diagnostic::new(Finding::UnreadableFile { problem, file: None }, at));
    }
}

/// What keeps a program from being executed: the first such finding.
fn first_fault(outcome: &Outcome, name: &str) -> Option<NotExecuted> {
    let findings = &outcome.findings;
    let faults = findings.items().iter().filter(|found| found.code().prevents_execution());
    let first = faults.min_by_key(|found| (found.at, found.code()))?;
    let source = outcome.sources.get(first.at.file)?;
    Some(NotExecuted {
        file: name.to_owned(),
        code: first.code(),
        line: source.line_column(first.at.span.start).line,
        macrocycle: (first.at.file != FileId(0)).then(|| source.name().to_owned()),
    })
}

/// Whether execution does not begin, or its blocks are shown no longer. A warning that is denied does not keep `check`
/// from executing the program.
const fn is_stopped(findings: &Findings, purpose: Purpose) -> bool {
    match purpose {
        Purpose::Check | Purpose::Report => findings.fault_count() > 0,
        Purpose::Compile => findings.has_errors(),
    }
}

/// Shows the blocks of an execution to a sink, and what it makes of the whole program.
fn show<S: Sink>(mut execution: Execution<'_>, mut sink: S) -> Run<S::Whole> {
    execution.show(&mut sink);
    execution.finish_with(sink)
}

impl std::fmt::Debug for Session<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Session").field("settings", self.settings).finish_non_exhaustive()
    }
}
