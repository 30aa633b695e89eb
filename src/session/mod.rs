//! One run over one program or macrocycle: load, resolve, execute, report. What the command line and the editor call.

mod stream;

use std::io::{self, Write};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

use crate::config::{Purpose, Settings};
use crate::diag::{Code, Diagnostic, Finding, Findings, Problem, Severity};
use crate::ir::{AxisRecord, EndRecord, FileRecord, MFunctionRecord, Micro, MotionType, ProgramRecord, SCHEMA};
use crate::resolve::{Library, Resolved, resolve_macrocycle, resolve_program, resolve_window};
use crate::run::{Checkpoint, Executor, Stop};
use crate::syntax::ParsedFile;
use crate::text::{FileId, Loader, Location, SourceText, Sources, Span};
use stream::{Closed, Rare, Records, write_beside};

/// Blocks between two reports of progress.
const PROGRESS: u64 = 1 << 16;
/// Blocks between two looks at a checked program; [`PROGRESS`] is a multiple of it. Fuzzing has short programs.
pub const STRIDE: u64 = if cfg!(fuzzing) { 1 << 1 } else { 1 << 13 };

/// Which block records of a stream are written; `program`, `file` and `end` always are.
#[derive(Clone, Copy, Debug, Default)]
pub struct Part {
    /// First `seq`.
    pub from: u64,
    /// Most block records; all when `None`.
    pub limit: Option<u64>,
}

impl Part {
    const fn contains(self, seq: u64) -> bool {
        seq >= self.from
            && match self.limit {
                Some(limit) => seq - self.from < limit,
                None => true,
            }
    }
}

/// What a run found, with the texts that the places are in.
#[derive(Debug, Default)]
pub struct Outcome {
    /// The files read; the program is file 0.
    pub sources: Sources,
    /// The findings, unsorted, levels not yet applied.
    pub findings: Findings,
    /// Whether the program itself could not be read, or is not what the command takes.
    pub unusable: bool,
    /// What the run was for: it decides the severity of W0503.
    pub purpose: Purpose,
    /// Blocks executed.
    pub executed: u64,
}

impl Outcome {
    /// Whether a file could not be read, be it the program or a macrocycle that it calls, or the program is not what the
    /// command takes: exit status 2.
    pub fn lacks_file(&self) -> bool {
        let unreadable = Code::E0112;
        self.findings.items().iter().any(|found| found.code() == unreadable)
            || self.findings.beyond_by_code().contains_key(&unreadable)
    }
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

    /// The first half of [`Self::check`]: what is found without executing the program.
    pub fn resolve(&self, path: &Path, name: &str) -> (Outcome, Resolved) {
        let mut outcome = Outcome::default();
        let Some(source) = self.read(path, name, &mut outcome) else { return (outcome, Resolved::default()) };
        let mut library = self.library(path);
        let Outcome { sources, findings, .. } = &mut outcome;
        let resolved = match Library::number(path) {
            Some(l) => resolve_macrocycle(&source, l, self.settings, &mut library, sources, findings),
            None => resolve_program(&source, self.settings, &mut library, sources, findings),
        };
        (outcome, resolved)
    }

    /// Whether the second half of [`Self::check`] follows: it is a program, and nothing written in it is wrong.
    pub fn can_execute(&self, resolved: &Resolved, outcome: &Outcome) -> bool {
        resolved.main().is_some() && !self.has_errors(&outcome.findings, Purpose::Check)
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
        let mut outcome = Outcome::default();
        let Outcome { sources, findings, executed, .. } = &mut outcome;
        let mut resolved = resolve_window(source, between, self.settings, sources, findings)?;
        if self.has_errors(findings, Purpose::Check) {
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

    /// Executes a program that has no errors and shows every executed block to `look`, until that breaks, or the
    /// program ends. Nothing is reported.
    pub fn observe(
        &self,
        path: &Path,
        resolved: &Resolved,
        sources: &Sources,
        mut look: impl FnMut(&Executor<'_, '_>) -> ControlFlow<()>,
    ) {
        let (mut resolved, mut sources, mut findings) = (resolved.clone(), sources.clone(), Findings::new());
        let mut library = self.library(path);
        let mut executor =
            Executor::new(&mut resolved, self.settings, &mut library, &mut sources, &mut findings, Purpose::Compile);
        while executor.step().is_some() {
            if look(&executor).is_break() || self.is_cancelled(executor.executed()) {
                break;
            }
        }
    }

    /// The macrocycles that the program at `path` may call.
    pub fn library(&self, path: &Path) -> Library<'_> {
        Library::new(self.loader, &self.settings.macrocycles, path)
    }

    /// Compiles the program at `path` to `out`. When the outcome has errors, the stream has no `end` record.
    ///
    /// # Errors
    /// What writing to `out` gives.
    pub fn compile(&self, path: &Path, name: &str, part: Part, out: &mut (dyn Write + Send)) -> io::Result<Outcome> {
        let mut outcome = Outcome { purpose: Purpose::Compile, ..Outcome::default() };
        if Library::number(path).is_some() {
            self.refuse(name, Problem::MacrocycleGiven, &mut outcome);
            return Ok(outcome);
        }
        let Some(source) = self.read(path, name, &mut outcome) else { return Ok(outcome) };
        let mut library = self.library(path);
        let Outcome { sources, findings, executed, .. } = &mut outcome;
        let mut resolved = resolve_program(&source, self.settings, &mut library, sources, findings);
        if self.has_errors(findings, Purpose::Compile) {
            return Ok(outcome);
        }
        let header = self.program_record(&resolved, name);
        let mut executor =
            Executor::new(&mut resolved, self.settings, &mut library, sources, findings, Purpose::Compile);
        let letters = executor.axes().to_vec();
        write_beside(out, &letters, |records| {
            records.rare(Rare::Program(header));
            let totals = self.write_blocks(&mut executor, part, records)?;
            if let Some(Stop::End(end)) = executor.end()
                && !self.has_errors(executor.findings(), Purpose::Compile)
            {
                records.rare(Rare::End(totals.record(end, executor.executed())));
            }
            Ok(())
        })?;
        *executed = executor.executed();
        Ok(outcome)
    }

    /// Whether the name is that of a macrocycle file: `L` and its number, with no extension, `.NC`, `.NCP`, `.MRC` or
    /// `.TXT`, in either case (PRG-6).
    pub fn is_macrocycle_name(path: &Path) -> bool {
        Library::number(path).is_some()
    }

    /// Gives records until the program ends or has an error.
    fn write_blocks(
        &self,
        executor: &mut Executor<'_, '_>,
        part: Part,
        records: &mut Records,
    ) -> Result<Totals, Closed> {
        let mut totals = Totals::default();
        let mut next_file = 1;
        while executor.step().is_some() {
            if executor.found_errors() || executor.read_unassigned() {
                // What is still to be found is found without writing.
                while executor.step().is_some() && !self.is_cancelled(executor.executed()) {}
                break;
            }
            let record = executor.record();
            if record.file == next_file {
                next_file += 1;
                let name = executor.source_name().unwrap_or_default().to_owned();
                records.rare(Rare::File(FileRecord { index: record.file, name }));
            }
            totals.add(record.motion.as_ref());
            if part.contains(record.seq) {
                records.block(record)?;
            }
            if self.is_cancelled(executor.executed()) {
                break;
            }
        }
        Ok(totals)
    }

    fn is_cancelled(&self, executed: u64) -> bool {
        executed.is_multiple_of(PROGRESS) && self.progress.is_some_and(|progress| !progress(executed))
    }

    /// Whether a finding is an error in this run.
    fn has_errors(&self, findings: &Findings, purpose: Purpose) -> bool {
        findings.items().iter().any(|diagnostic| {
            let code = diagnostic.code();
            let severity = self.settings.severity_for(code, purpose);
            match purpose {
                // A warning that is denied does not keep `check` from executing the program.
                Purpose::Check => code.severity() == Severity::Error && severity == Some(Severity::Error),
                Purpose::Compile => severity == Some(Severity::Error),
            }
        })
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

    fn program_record(&self, resolved: &Resolved, name: &str) -> ProgramRecord {
        let machine = &self.settings.machine;
        let file = resolved.file(FileId(0));
        let number = file.and_then(|file| file.program).and_then(|word| word.whole());
        ProgramRecord {
            schema: SCHEMA.to_owned(),
            generator: concat!("cnc872c ", env!("CARGO_PKG_VERSION")).to_owned(),
            dialect: machine.dialect.name().to_owned(),
            number: number.and_then(|number| u32::try_from(number).ok()).unwrap_or(0),
            title: file.and_then(|file| file.title.map(|title| file.comment_text(title).to_owned())),
            file: name.to_owned(),
            axes: machine
                .axes
                .iter()
                .map(|axis| AxisRecord {
                    letter: axis.letter.to_string(),
                    kind: if axis.rotary { "rotary" } else { "linear" }.to_owned(),
                })
                .collect(),
            block_skip: self.settings.block_skip,
            optional_stop: self.settings.optional_stop,
            m_functions: machine
                .m_functions
                .configured()
                .map(|function| MFunctionRecord {
                    no: function.number,
                    group: function.group,
                    break_cont: function.break_cont,
                    break_cont_end: function.break_cont_end,
                    change_pos: function.change_pos,
                })
                .collect(),
        }
    }
}

impl std::fmt::Debug for Session<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Session").field("settings", self.settings).finish_non_exhaustive()
    }
}

/// Sums over the lengths as written.
#[derive(Debug, Default)]
struct Totals {
    path: Micro,
    by_type: [Option<Micro>; MotionType::ALL.len()],
}

impl Totals {
    fn add(&mut self, motion: Option<&crate::ir::Motion>) {
        let Some(motion) = motion else { return };
        let Some(length) = motion.length_mm else { return };
        self.path = self.path.plus(length);
        if let Some(sum) = self.by_type.get_mut(motion.kind as usize) {
            *sum = Some(sum.unwrap_or_default().plus(length));
        }
    }

    fn record(&self, end: u8, blocks: u64) -> EndRecord {
        EndRecord {
            reason: format!("M{end:02}"),
            blocks,
            path_mm: self.path,
            path_mm_by_type: MotionType::ALL
                .into_iter()
                .zip(self.by_type)
                .filter_map(|(kind, sum)| Some((kind, sum?)))
                .collect(),
        }
    }
}
