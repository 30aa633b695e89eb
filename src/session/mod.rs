//! One run over one program or macrocycle: load, resolve, execute, report. What the command line and the editor call.

mod stream;

use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

use crate::config::{Purpose, Settings};
use crate::diag::{Code, Diagnostic, Finding, Findings, Problem};
use crate::dict::AxisLetter;
use crate::resolve::{Library, Resolved, resolve_macrocycle, resolve_program, resolve_window};
use crate::run::{Checkpoint, End, Executor, Sink, Start};
use crate::syntax::ParsedFile;
use crate::text::{FileId, Loader, Location, SourceText, Sources, Span};
pub use stream::Part;
use stream::{Closed, JsonStream, write_beside};

/// Blocks between two reports of progress.
const PROGRESS: u64 = 1 << 16;
/// Blocks between two looks at a checked program; [`PROGRESS`] is a multiple of it. Fuzzing has short programs.
pub const STRIDE: u64 = if cfg!(fuzzing) { 1 << 1 } else { 1 << 13 };

/// What a run found, with the texts that the places are in.
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
}

impl Outcome {
    /// Whether a file could not be read, be it the program or a macrocycle that it calls, or the program is not what the
    /// command takes: exit status 2.
    pub fn lacks_file(&self) -> bool {
        self.findings.has(Code::E0112)
    }
}

/// A run with a sink: what was found, and what the sink made of the program.
#[derive(Debug)]
pub struct Run<T> {
    /// The findings, with the texts that they are in.
    pub outcome: Outcome,
    /// What the sink made of the whole program. `None`: the program has errors, or was not executed to its end.
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

impl Session<'_> {
    /// Checks the program or macrocycle at `path`, which the user calls `name`: everything that `check` finds.
    pub fn check(&self, path: &Path, name: &str) -> Outcome {
        let (mut outcome, mut resolved) = self.resolve(path, name);
        if self.can_execute(&resolved, &outcome) {
            self.execute(path, &mut resolved, &mut outcome, |_| {});
        }
        outcome
    }

    /// Executes the program at `path`, which the user calls `name`, and shows each executed block to `sink`. To check a
    /// macrocycle, there is nothing to execute.
    pub fn run<S: Sink>(&self, path: &Path, name: &str, purpose: Purpose, sink: S) -> Run<S::Whole> {
        if purpose == Purpose::Compile && Self::is_macrocycle_name(path) {
            let mut outcome = self.outcome(purpose);
            self.refuse(name, Problem::MacrocycleGiven, &mut outcome);
            return Run { outcome, whole: None };
        }
        let (mut outcome, mut resolved) = self.resolve_for(path, name, purpose);
        if resolved.main().is_none() || is_stopped(&outcome.findings, purpose) {
            return Run { outcome, whole: None };
        }
        let whole = self.execute_into(path, &mut resolved, &mut outcome, purpose, sink);
        Run { outcome, whole }
    }

    /// Shows the executed blocks of a resolved program to `sink`, up to the first that has an error; what is still to be
    /// found after that is found without it.
    fn execute_into<S: Sink>(
        &self,
        path: &Path,
        resolved: &mut Resolved,
        outcome: &mut Outcome,
        purpose: Purpose,
        mut sink: S,
    ) -> Option<S::Whole> {
        let mut library = self.library(path);
        let Outcome { sources, findings, executed, .. } = outcome;
        let name = sources.get(FileId(0)).map(Arc::clone);
        let name = name.as_ref().map_or("", |source| source.name());
        sink.begin(&Start { name, resolved, settings: self.settings });
        let mut executor = Executor::new(resolved, self.settings, &mut library, sources, findings, Purpose::Compile);
        let mut whole = true;
        while executor.step().is_some() {
            whole &= !is_stopped(executor.findings(), purpose);
            if whole && executor.show(&mut sink).is_break() {
                whole = false;
                break;
            }
            if self.is_cancelled(executor.executed()) {
                whole = false;
                break;
            }
        }
        *executed = executor.executed();
        let end = End::of(&executor).filter(|_| whole)?;
        let made = sink.end(end, findings);
        // The sink may have found errors at the end.
        (!findings.has_errors()).then_some(made)
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
        let resolved = match Library::number(path) {
            Some(l) => resolve_macrocycle(&source, l, self.settings, &mut library, sources, findings),
            None => resolve_program(&source, self.settings, &mut library, sources, findings),
        };
        (outcome, resolved)
    }

    /// Whether the second half of [`Self::check`] follows: it is a program, and nothing written in it is wrong. A warning that is
    /// denied does not keep it from being executed.
    pub fn can_execute(&self, resolved: &Resolved, outcome: &Outcome) -> bool {
        resolved.main().is_some() && !is_stopped(&outcome.findings, Purpose::Check)
    }

    /// Nothing found yet, at the levels of the run.
    fn outcome(&self, purpose: Purpose) -> Outcome {
        let findings = Findings::with_levels(self.settings.levels(purpose));
        Outcome { findings, ..Outcome::default() }
    }

    /// The second half of [`Self::check`]: what execution finds joins the outcome. `look` sees the executor before the first
    /// block and after every [`STRIDE`] blocks.
    pub fn execute(
        &self,
        path: &Path,
        resolved: &mut Resolved,
        outcome: &mut Outcome,
        mut look: impl FnMut(&Executor<'_, '_>),
    ) {
        let mut library = self.library(path);
        let Outcome { sources, findings, executed, .. } = outcome;
        let mut executor = Executor::new(resolved, self.settings, &mut library, sources, findings, Purpose::Check);
        look(&executor);
        while executor.step().is_some() {
            if executor.executed().is_multiple_of(STRIDE) {
                look(&executor);
                if self.is_cancelled(executor.executed()) {
                    break;
                }
            }
        }
        *executed = executor.executed();
    }

    /// Checks a piece of a long straight program alone: `source` is the text from one block up to another, whose numbers
    /// `between` stand around it, `from` is known before it and `to` after it. The findings, with places in the piece, are
    /// those of the whole program, when that has none outside of the piece. `None` when the piece cannot be judged alone, or
    /// leads to something else than `to`.
    pub fn check_window(
        &self,
        source: &Arc<SourceText>,
        between: (u32, u32),
        from: &Checkpoint,
        to: &Checkpoint,
    ) -> Option<Outcome> {
        let mut outcome = self.outcome(Purpose::Check);
        let Outcome { sources, findings, executed, .. } = &mut outcome;
        let mut resolved = resolve_window(source, between, self.settings, sources, findings)?;
        if is_stopped(findings, Purpose::Check) {
            return Some(outcome);
        }
        let blocks = resolved.file(FileId(0)).map_or(0, ParsedFile::block_count);
        let mut library = self.library(Path::new(source.name()));
        let mut executor = Executor::new(&mut resolved, self.settings, &mut library, sources, findings, Purpose::Check);
        executor.resume(from);
        for _ in 0..blocks {
            executor.step()?;
        }
        *executed = executor.executed();
        let converged = executor.checkpoint() == *to;
        converged.then_some(outcome)
    }

    /// Executes once more a program that has no errors, and shows every executed block to `sink`. What is found is known
    /// already.
    pub fn observe<S: Sink>(&self, path: &Path, resolved: &Resolved, sources: &Sources, sink: S) -> Option<S::Whole> {
        let mut outcome = Outcome { sources: sources.clone(), ..self.outcome(Purpose::Check) };
        self.execute_into(path, &mut resolved.clone(), &mut outcome, Purpose::Check, sink)
    }

    /// The macrocycles that the program at `path` may call.
    pub fn library(&self, path: &Path) -> Library<'_> {
        Library::new(self.loader, &self.settings.macrocycles, path)
    }

    /// Compiles the program at `path` to `out`. The stream has its `end` record when the run is whole, and only then.
    ///
    /// # Errors
    /// What writing to `out` gives.
    pub fn compile(&self, path: &Path, name: &str, part: Part, out: &mut (dyn Write + Send)) -> io::Result<Run<End>> {
        let letters: Vec<AxisLetter> = self.settings.machine.axes.iter().map(|axis| axis.letter).collect();
        write_beside(out, &letters, |records| {
            let run = self.run(path, name, Purpose::Compile, JsonStream::new(records, part));
            if records.is_closed() { Err(Closed) } else { Ok(run) }
        })
    }

    /// Whether the name is that of a macrocycle file: `L` and its number, with no extension, `.NC`, `.NCP`, `.MRC` or
    /// `.TXT`, in either case (PRG-6).
    pub fn is_macrocycle_name(path: &Path) -> bool {
        Library::number(path).is_some()
    }

    fn is_cancelled(&self, executed: u64) -> bool {
        executed.is_multiple_of(PROGRESS) && self.progress.is_some_and(|progress| !progress(executed))
    }

    fn read(&self, path: &Path, name: &str, outcome: &mut Outcome) -> Option<Arc<SourceText>> {
        match self.loader.load(path, name, self.settings.encoding) {
            Ok(source) => Some(source),
            Err(error) => {
                self.refuse(name, Problem::from_io(&error), outcome);
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

/// Whether execution does not begin, or its blocks are shown no longer. A warning that is denied does not keep `check` from
/// executing the program.
const fn is_stopped(findings: &Findings, purpose: Purpose) -> bool {
    match purpose {
        Purpose::Check => findings.fault_count() > 0,
        Purpose::Compile => findings.has_errors(),
    }
}

impl std::fmt::Debug for Session<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Session").field("settings", self.settings).finish_non_exhaustive()
    }
}
