//! Functions over one program.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use cnc872c::analysis::compare::{Side, Steps, Tolerances, compare as changes, json as changes_json};
use cnc872c::analysis::motion::{Basis, machine};
use cnc872c::analysis::plc::{
    Cell, Condition, Header, Reader, Signal, Step, Writer, default, named, signal_problem, with_compatible,
};
use cnc872c::columns::{BlockTable, Kept, MotionTable, StepTable};
use cnc872c::config::{Machine, Purpose, Settings, tried_fault};
use cnc872c::diag::{Diagnostic, Finding, Findings, Report};
use cnc872c::dict::{Lang, Micro};
use cnc872c::edit::format as layout;
use cnc872c::run::End;
use cnc872c::session::{Outcome, Part, Run, Session, TimedSignals, Times};
use cnc872c::text::{SourceText, Sources, path_name};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::fault::{Fault, json};
use crate::options::{Options, count, tried};
use crate::setup::Setup;
use crate::table::Table;
use crate::work::{GoesOn, work};

/// A table, and the findings as JSON.
type Made = (Table, String);

/// A program: its path, and the text that replaces it.
pub type Program = (PathBuf, Option<Vec<u8>>);

/// One program under way.
pub struct One<'a> {
    pub session: Session<'a>,
    pub path: &'a Path,
    pub name: String,
    pub report: Report,
    pub lang: Lang,
}

/// Configures one program, and does `work` with it, without the interpreter's lock.
pub fn one<T: Send + 'static>(
    py: Python<'_>,
    program: Program,
    options: Options,
    run: impl FnOnce(One<'_>) -> Result<T, Fault> + Send + 'static,
) -> PyResult<T> {
    work(py, move |goes_on| with_one(program, &options, goes_on, run))?.map_err(|fault| fault.raise(py))
}

fn with_one<T>(
    (path, text): Program,
    options: &Options,
    goes_on: &GoesOn<'_>,
    run: impl FnOnce(One<'_>) -> Result<T, Fault>,
) -> Result<T, Fault> {
    let path = path.as_path();
    let mut setup = Setup::new(options, &[path.to_path_buf()], text.map(Arc::from))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    setup.folder(folder);
    let report = setup.report()?;
    let Some(settings) = setup.settings(folder) else { return Err(Fault::Config(String::new())) };
    let session = Session { loader: &setup.files, settings, progress: Some(goes_on) };
    run(One { session, path, name: path_name(path), report, lang: options.lang })
}

impl One<'_> {
    /// Adds what was found.
    ///
    /// # Errors
    /// When the program cannot be read.
    pub fn add(&mut self, outcome: Outcome) -> Result<(), Fault> {
        if outcome.unusable
            && let Err(error) = self.session.loader.read(self.path)
        {
            return Err(Fault::Io(self.path.to_path_buf(), error));
        }
        outcome.add_to(&mut self.report);
        Ok(())
    }

    /// The findings as JSON.
    pub fn json(&self) -> String {
        json(&self.report, self.lang)
    }

    /// The columns of a whole program.
    fn finish(mut self, run: Run<End>, kept: Kept, failed: Option<io::Error>) -> Result<Made, Fault> {
        if let Some(error) = failed {
            return Err(Fault::Io(self.path.to_path_buf(), error));
        }
        self.add(run.outcome)?;
        let report = self.json();
        if run.whole.is_some() { Ok((kept.into(), report)) } else { Err(Fault::Program(report)) }
    }
}

/// A part of what is executed.
fn part(first: i64, limit: Option<i64>) -> Result<Part, Fault> {
    let limit = limit.map(|limit| count("limit", limit)).transpose()?;
    Ok(Part { from: count("first", first)?, limit })
}

/// The block stream.
#[pyfunction]
pub fn compile(
    py: Python<'_>,
    program: Program,
    options: &Bound<'_, PyDict>,
    first: i64,
    limit: Option<i64>,
) -> PyResult<Made> {
    one(py, program, Options::new(options)?, move |one| {
        let part = part(first, limit)?;
        let (mut kept, mut failed) = (Kept::default(), None);
        let sink = BlockTable::new(part, &mut kept, &mut failed);
        let run = one.session.run(one.path, &one.name, Purpose::Compile, sink);
        one.finish(run, kept, failed)
    })
}

/// The motion stream.
#[pyfunction]
pub fn motion(
    py: Python<'_>,
    program: Program,
    options: &Bound<'_, PyDict>,
    phases: bool,
    set: &Bound<'_, PyAny>,
) -> PyResult<Made> {
    let tried = tried(set)?;
    one(py, program, Options::new(options)?.with_motion(tried.clone()), move |one| {
        let settings = one.session.settings;
        check_tried(&tried, settings)?;
        let (mut kept, mut failed, mut jerk_free) = (Kept::default(), None, 0);
        let first = machine(&Basis::of(settings), &one.name);
        let profile = settings.machine.motion.profile.value;
        let sink = MotionTable::new(first, profile, &mut kept, &mut failed, &mut jerk_free);
        let times = Times { phases, time_dist: true };
        let run = one.session.run_timed(one.path, &one.name, Purpose::Compile, times, sink);
        one.finish(run, kept, failed)
    })
}

/// Refuses a key that changes nothing.
fn check_tried(tried: &[(String, String)], settings: &Settings) -> Result<(), Fault> {
    let fault = |(key, _): &&(String, String)| tried_fault(key, settings.machine.dialect).is_some();
    match tried.iter().find(fault) {
        Some((key, _)) => Err(Fault::Option(format!("set: {key:?} is nothing that motion depends on"))),
        None => Ok(()),
    }
}

/// Gives on the steps in which a condition holds.
struct Matching<W> {
    inner: W,
    condition: Option<Condition>,
}

impl<W: Writer> Writer for Matching<W> {
    fn begin(&mut self, header: &Header<'_>) -> io::Result<()> {
        self.inner.begin(header)
    }

    fn file(&mut self, index: u32, name: &str) -> io::Result<()> {
        self.inner.file(index, name)
    }

    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        let holds = self.condition.as_ref().is_none_or(|condition| condition.holds(step.before, step.values));
        if holds { self.inner.step(step) } else { Ok(()) }
    }

    fn end(&mut self, end: End) -> io::Result<()> {
        self.inner.end(end)
    }
}

/// What of the signals is asked for.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Wanted {
    signals: Option<String>,
    compat: bool,
    find: Option<String>,
    first: i64,
    limit: Option<i64>,
}

/// The signals of the PLC.
#[pyfunction]
pub fn plc(py: Python<'_>, program: Program, options: &Bound<'_, PyDict>, wanted: Wanted) -> PyResult<Made> {
    one(py, program, Options::new(options)?.with_motion(Vec::new()), move |mut one| {
        let session = one.session;
        let machine = &session.settings.machine;
        let condition = match wanted.find.as_deref().map(|text| (text, Condition::read(text, machine))) {
            Some((text, Err(found))) => return Err(wrong_condition(&mut one, text, found)),
            Some((_, Ok(condition))) => Some(condition),
            None => None,
        };
        let signals = chosen(&wanted, condition.as_ref(), machine, one.lang)?;
        let has = |cell: Cell| signals.iter().any(|signal| signal.cell == cell);
        let times = Times { phases: false, time_dist: has(Cell::TimeDist) };
        let timed = machine.motion.configured;
        let (mut kept, mut broken, mut failed) = (Kept::default(), None, None);
        let mut writer = Matching { inner: StepTable::new(&mut kept, &mut broken), condition };
        let range = part(wanted.first, wanted.limit)?;
        let reader = Reader::new(signals, machine, range, &mut writer, &mut failed);
        let run = if timed {
            session.run_timed(one.path, &one.name, Purpose::Compile, times, TimedSignals(reader))
        } else {
            session.run(one.path, &one.name, Purpose::Compile, reader)
        };
        one.finish(run, kept, failed.or(broken))
    })
}

fn wrong_condition(one: &mut One<'_>, text: &str, found: Vec<Diagnostic>) -> Fault {
    let mut sources = Sources::new();
    sources.add(SourceText::from_text("find", text));
    let mut findings = Findings::new();
    found.into_iter().for_each(|diagnostic| findings.add(diagnostic));
    one.report.add(&sources, findings);
    Fault::Config(one.json())
}

fn chosen(
    wanted: &Wanted,
    condition: Option<&Condition>,
    machine: &Machine,
    lang: Lang,
) -> Result<Vec<&'static Signal>, Fault> {
    let (dialect, motion) = (machine.dialect, machine.motion.configured);
    if let Some(condition) = condition {
        if wanted.signals.is_some() || wanted.compat {
            return Err(Fault::Option("find: the condition names the signals, without signals and compat".to_owned()));
        }
        return Ok(condition.signals().to_vec());
    }
    let Some(names) = &wanted.signals else { return Ok(default(dialect, wanted.compat, motion)) };
    let chosen = named(names, dialect).map_err(|none| {
        let finding = Finding::UnknownSignal { name: none.name.clone(), why: signal_problem(&none.why, dialect) };
        let parts = [Some(finding.message(lang)), finding.note(lang), finding.help(lang)];
        Fault::Option(parts.into_iter().flatten().collect::<Vec<_>>().join("; "))
    })?;
    Ok(if wanted.compat { with_compatible(&chosen, dialect, motion) } else { chosen })
}

/// What counts as a difference.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Differences {
    tolerance: f64,
    feed_tolerance: f64,
    parameters: bool,
    partial: bool,
}

impl Differences {
    fn tolerances(&self) -> Result<Tolerances, Fault> {
        for (name, value) in [("tolerance", self.tolerance), ("feed_tolerance", self.feed_tolerance)] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(Fault::Option(format!("{name}: {value} is no tolerance: at least 0")));
            }
        }
        Ok(Tolerances { position: Micro::from_f64(self.tolerance), percent: self.feed_tolerance })
    }
}

/// What two programs do differently, as JSON.
#[pyfunction]
pub fn compare(
    py: Python<'_>,
    old: Program,
    new: Program,
    options: &Bound<'_, PyDict>,
    differences: Differences,
) -> PyResult<String> {
    let options = Options::new(options)?;
    let tolerances = differences.tolerances().map_err(|fault| fault.raise(py))?;
    let made = work(py, move |goes_on| {
        let read = |program| with_one(program, &options, goes_on, |one| steps(one, &differences));
        let (old, new) = rayon::join(|| read(old), || read(new));
        let ((old, old_steps), (new, new_steps)) = (old?, new?);
        Ok(changes_json(&old, &new, &changes(&old_steps, &new_steps, tolerances).changes))
    })?;
    made.map_err(|fault: Fault| fault.raise(py))
}

/// What one of two programs does.
fn steps(mut one: One<'_>, differences: &Differences) -> Result<(Side, Steps), Fault> {
    let (run, side, steps) = one.session.steps(one.path, &one.name, differences.parameters);
    let usable = !run.outcome.unusable && run.outcome.not_executed.is_none();
    one.add(run.outcome)?;
    if !usable || !(side.whole || differences.partial) {
        return Err(Fault::Program(one.json()));
    }
    Ok((side, steps))
}

/// A program in one layout, and how many lines stay because they cannot be read.
#[pyfunction]
pub fn format(py: Python<'_>, program: Program, options: &Bound<'_, PyDict>) -> PyResult<(Vec<u8>, usize)> {
    one(py, program, Options::new(options)?, move |mut one| {
        let unread = |error| Fault::Io(one.path.into(), error);
        let bytes = one.session.loader.read(one.path).map_err(unread)?;
        let settings = one.session.settings;
        let Ok(source) = SourceText::decode(one.name.as_str(), bytes.clone(), settings.encoding) else {
            let outcome = one.session.check(one.path, &one.name);
            one.add(outcome)?;
            return Err(Fault::Program(one.json()));
        };
        let mut made = Vec::new();
        match layout(one.path, &Arc::new(source), settings, &mut |part| made.extend_from_slice(part)) {
            Ok(formatted) => Ok((if formatted.changed { made } else { bytes }, formatted.lines_left)),
            // Text without a program, as of a macrocycle, stays as it is.
            Err(outcome) if outcome.findings.items().is_empty() => Ok((bytes, 0)),
            Err(outcome) => {
                one.add(*outcome)?;
                Err(Fault::Program(one.json()))
            }
        }
    })
}
