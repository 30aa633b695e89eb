//! `plc`: what the PLC program reads of a part program.

use std::io::{self, BufWriter, Write};

use super::args::{FindingsArgs, PlcArgs, PlcFormat};
use super::common::overrides;
use super::compile::{Stream, cannot_write};
use super::job::{Ends, Job, unusable};
use super::locale::Locale;
use super::progress::{Counted, Progress};
use super::status::{Failure, Status, stdout, tell};
use super::threads;
use super::walk::Target;
use super::words::Words;
use crate::analysis::Part;
use crate::analysis::plc::{
    self, Cell, Condition, Csv, Finder, Json, NoSignal, Reader, Signal, Table, Wave, Writer, signal_problem,
};
use crate::config::{Machine, Overrides, Purpose};
use crate::diag::{Diagnostic, Finding, Findings, Format, Report};
use crate::dict::{Dialect, Lang};
use crate::run::End;
use crate::session::{Outcome, Session, TimedSignals, Times};
use crate::text::{SourceText, Sources};

/// The name that a condition has in findings.
const CONDITION: &str = "--find";
/// Bytes that are written at once.
const BUFFER: usize = 1 << 16;

pub(super) fn run(args: &PlcArgs, locale: Locale) -> Result<Status, Failure> {
    let overrides = Overrides { computes_motion: true, ..overrides(&args.common, locale.lang)? };
    threads::prepare();
    let shown = FindingsArgs { format: Format::Human, all: args.all };
    let job = Job::new(args.file.clone().unwrap_or_default(), args.output.clone());
    let mut projects = job.configure(&overrides)?;
    let mut report = projects.report();
    let Some(settings) = projects.settings(job.target()).filter(|_| report.errors() == 0) else {
        return Ok(unusable(report, &shown, locale));
    };
    let dialect = settings.machine.dialect;
    let motion = settings.machine.motion.configured;
    if args.list {
        return list(args.format, &settings.machine, locale.lang);
    }
    let condition = match args
        .find
        .as_deref()
        .map(|text| Condition::read(text, &settings.machine).map_err(|found| (text, found)))
    {
        Some(Err((text, found))) => {
            add_condition(&mut report, text, found);
            return Ok(unusable(report, &shown, locale));
        }
        Some(Ok(condition)) => Some(condition),
        None => None,
    };
    let signals = match (&condition, &args.signals) {
        (Some(condition), _) => condition.signals().to_vec(),
        (None, Some(names)) => {
            let named = plc::named(names, dialect).map_err(|none| no_signal(&none, dialect, locale.lang))?;
            if args.compat { plc::with_compatible(&named, dialect, motion) } else { named }
        }
        (None, None) => plc::default(dialect, args.compat, motion),
    };
    if !motion {
        tell_of_motion(&signals, condition.is_some(), locale.lang);
    }
    #[cfg(feature = "arrow")]
    if args.format == PlcFormat::Arrow {
        super::compile::refuse_terminal(job.output())?;
    }
    let mut stream = Stream::open(job.output(), locale.lang)?;
    let progress = Progress::start(Counted::Blocks, matches!(stream, Stream::Stdout(_)), locale.lang);
    let count = progress.counter();
    let session = Session { loader: &job.loader, settings, progress: Some(&count) };
    let out = BufWriter::with_capacity(BUFFER, &mut stream);
    let run = Run {
        session,
        target: job.target(),
        signals,
        part: Part { from: args.from, limit: args.limit },
        tells_time: args.format != PlcFormat::Table,
    };
    let written = match condition {
        Some(condition) => {
            let mut finder = Finder::new(out, condition);
            run.to(&mut finder, false).map(|outcome| (outcome, Some(finder.found())))
        }
        None => write(run, args, out).map(|outcome| (outcome, None)),
    };
    drop(progress);
    let (made, found) = written.map_err(|error| cannot_write(error, job.output(), locale.lang))?;
    let ends = Ends {
        whole: if found == Some(0) { Status::Faulty } else { Status::Fine },
        broken: if found.is_some() { Status::Unusable } else { Status::Faulty },
        reason: Words::NotWhole { file: job.target().name() },
    };
    job.finish(stream, made, report, ends, &shown, locale)
}

/// A run over one program.
struct Run<'a> {
    session: Session<'a>,
    target: &'a Target,
    signals: Vec<&'static Signal>,
    part: Part,
    /// The form tells when steps start.
    tells_time: bool,
}

impl Run<'_> {
    /// Gives the steps to a writer; `shown` says that their values are, so that what does not fit is reported. Also
    /// how the whole program ended.
    fn to(self, writer: &mut dyn Writer, shown: bool) -> io::Result<(Outcome, Option<End>)> {
        let times = self.times(shown);
        let Self { session, target, signals, part, .. } = self;
        let mut failed = None;
        let reader = Reader::new(signals, &session.settings.machine, part, writer, &mut failed);
        let reader = if shown { reader } else { reader.unreported() };
        let (path, name) = (&target.path, target.name());
        let run = match times {
            Some(times) => session.run_timed(path, &name, Purpose::Compile, times, TimedSignals(reader)),
            None => session.run(path, &name, Purpose::Compile, reader),
        };
        match failed {
            Some(error) => Err(error),
            None => Ok((run.outcome, run.whole)),
        }
    }

    /// What must be computed of motion, where it is configured: for the signals, and for the times of steps.
    fn times(&self, shown: bool) -> Option<Times> {
        let has = |cell: Cell| self.signals.iter().any(|signal| signal.cell == cell);
        let time_dist = has(Cell::TimeDist);
        let wanted = time_dist || has(Cell::Stretch) || (shown && self.tells_time);
        (wanted && self.session.settings.machine.motion.configured).then_some(Times { phases: false, time_dist })
    }

    /// The same, with all that the writer does beside execution.
    fn beside(self, mut writer: impl Writer + Send) -> io::Result<(Outcome, Option<End>)> {
        let (ran, written) = plc::beside(&mut writer, |writer| self.to(writer, true));
        written.and(ran)
    }
}

fn write(run: Run<'_>, args: &PlcArgs, out: impl Write + Send) -> io::Result<(Outcome, Option<End>)> {
    match args.format {
        PlcFormat::Table => run.beside(Table::new(out, args.all)),
        PlcFormat::Json => run.beside(Json::new(out)),
        PlcFormat::Csv => run.beside(Csv::new(out)),
        PlcFormat::Vcd => run.beside(Wave::new(out)),
        #[cfg(feature = "arrow")]
        PlcFormat::Arrow => {
            let (mut out, mut failed) = (crate::columns::Ipc::new(out), None);
            run.beside(crate::columns::StepTable::new(&mut out, &mut failed))
        }
    }
}

/// Says which signals have no value because `[motion]` is not there: those that a condition names, or all that were
/// chosen.
fn tell_of_motion(signals: &[&'static Signal], condition: bool, lang: Lang) {
    let names: Vec<&str> =
        signals.iter().filter(|signal| signal.needs_motion()).map(|signal| signal.name.as_str()).collect();
    if !names.is_empty() && (condition || names.len() == signals.len()) {
        tell(&Words::NeedMotion { names: names.join(", ") }, lang);
    }
}

/// Shows what is wrong with a condition as findings in a program are shown.
fn add_condition(report: &mut Report, text: &str, found: Vec<Diagnostic>) {
    let mut sources = Sources::new();
    sources.add(SourceText::from_text(CONDITION, text));
    let mut findings = Findings::new();
    found.into_iter().for_each(|diagnostic| findings.add(diagnostic));
    report.add(&sources, findings);
}

/// Message about a name of `--signals` that matches nothing.
fn no_signal(none: &NoSignal, dialect: Dialect, lang: Lang) -> Words {
    let finding = Finding::UnknownSignal { name: none.name.clone(), why: signal_problem(&none.why, dialect) };
    let parts = [Some(finding.message(lang)), finding.note(lang), finding.help(lang)];
    Words::Signals { text: parts.into_iter().flatten().collect::<Vec<_>>().join("; ") }
}

/// `--list`: the dictionary of the control.
fn list(format: PlcFormat, machine: &Machine, lang: Lang) -> Result<Status, Failure> {
    let text = match format {
        PlcFormat::Table => plc::list_table(machine, lang),
        PlcFormat::Json => format!("{:#}\n", plc::list_json(machine, lang)),
        PlcFormat::Csv | PlcFormat::Vcd => return Err(Words::ListFormat.into()),
        #[cfg(feature = "arrow")]
        PlcFormat::Arrow => return Err(Words::ListFormat.into()),
    };
    let mut out = stdout()?;
    out.write_all(text.as_bytes())?;
    out.flush()?;
    Ok(Status::Fine)
}
