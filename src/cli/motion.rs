//! `motion`: how the machine moves through a program, and how long it takes.

use std::io::{self, Write};
use std::ops::ControlFlow;
use std::path::Path;

use super::args::{FindingsArgs, MotionArgs, MotionFormat};
use super::common::{Projects, overrides};
use super::compile::{Stream, cannot_write};
use super::job::{Ends, Job, unusable};
use super::locale::Locale;
use super::progress::{Counted, Progress};
use super::status::{Failure, Status, tell};
use super::threads;
use super::walk::Target;
use super::words::Words;
use crate::analysis::motion::{
    Account, Basis, BlockTimes, CSV_HEAD, Estimate, Profile, Summary, machine, total, write_block, write_csv,
};
use crate::config::{Overrides, Purpose, Settings, TriedFault, tried_fault};
use crate::diag::{Findings, Format};
use crate::dict::Dialect;
use crate::run::{End, Executed, Program};
use crate::session::{Outcome, Run, Session, TimedSink, Times};
use crate::text::Loader;

/// Red joints that are listed without `--all`.
const RED: usize = 20;
/// Bytes that are written at once.
const BUFFER: usize = 1 << 16;

pub(super) fn run(args: &MotionArgs, locale: Locale) -> Result<Status, Failure> {
    if args.phases && matches!(args.format, MotionFormat::Human | MotionFormat::Csv) {
        return Err(Words::PhasesFormat.into());
    }
    let configured = Overrides { computes_motion: true, ..overrides(&args.common, locale.lang)? };
    let tried = args.set.iter().map(|text| set(text)).collect::<Result<Vec<_>, _>>()?;
    let overrides = Overrides { motion: tried, ..configured.clone() };
    threads::prepare();
    let shown = FindingsArgs { format: Format::Human, all: args.all };
    let job = Job::new(args.file.clone(), args.output.clone());
    let mut projects = job.configure(&overrides)?;
    let report = projects.report();
    if let Some(settings) = projects.settings(job.target()) {
        check_tried(&overrides.motion, settings.machine.dialect)?;
    }
    let Some(settings) = projects.settings(job.target()).filter(|_| report.errors() == 0) else {
        return Ok(unusable(report, &shown, locale));
    };
    let before = if args.set.is_empty() { Projects::default() } else { job.configure(&configured)? };
    // Mistakes in the project file alone are found with the other values as well.
    let before = before.settings(job.target());
    #[cfg(feature = "arrow")]
    if args.format == MotionFormat::Arrow {
        super::compile::refuse_terminal(job.output())?;
    }
    let mut stream = Stream::open(job.output(), locale.lang)?;
    let progress = Progress::start(Counted::Blocks, matches!(stream, Stream::Stdout(_)), locale.lang);
    let count = progress.counter();
    let run = OneRun { loader: &job.loader, count: &count, target: job.target(), settings };
    let made = match args.format {
        MotionFormat::Human => run.account(before, args.all, locale, &mut stream).map(|made| (made, 0)),
        MotionFormat::Json | MotionFormat::Csv => run.rows(args, &mut stream),
        #[cfg(feature = "arrow")]
        MotionFormat::Arrow => run.columns(args.phases, &mut stream),
    };
    drop(progress);
    let made = made.map_err(|error| cannot_write(error, job.output(), locale.lang))?;
    let (made, jerk_free) = made;
    // A table has no place for it.
    if args.format == MotionFormat::Csv && !settings.machine.motion.configured {
        tell(&Words::AssumedMachine, locale.lang);
    }
    if jerk_free > 0 {
        tell(&Words::JerkFree { blocks: jerk_free }, locale.lang);
    }
    let reason = Words::NoWholeTime { file: job.target().name() };
    let ends = Ends { whole: Status::Fine, broken: Status::Faulty, reason };
    job.finish(stream, made, report, ends, &shown, locale)
}

/// `KEY=VALUE` of `--set`.
fn set(text: &str) -> Result<(String, String), Words> {
    match text.split_once('=') {
        Some((key, value)) if !key.trim().is_empty() && !value.trim().is_empty() => {
            Ok((key.trim().to_owned(), value.trim().to_owned()))
        }
        _ => Err(Words::SetForm { text: text.to_owned() }),
    }
}

/// Refuses a key that changes nothing.
fn check_tried(tried: &[(String, String)], dialect: Dialect) -> Result<(), Words> {
    let fault = |(key, value): &(String, String)| {
        let text = format!("{key}={value}");
        Some(match tried_fault(key, dialect)? {
            TriedFault::Unknown { near: Some(near) } => Words::SetUnknownNear { text, key: key.clone(), near },
            TriedFault::Unknown { near: None } => Words::SetUnknown { text, key: key.clone() },
            TriedFault::Constant => Words::SetConstant { text, key: key.clone() },
            TriedFault::Dialect => Words::SetDialect { text, dialect: dialect.name().to_owned() },
        })
    };
    tried.iter().find_map(fault).map_or(Ok(()), Err)
}

/// A run over one program.
struct OneRun<'a> {
    loader: &'a dyn Loader,
    count: &'a (dyn Fn(u64) -> bool + Sync),
    target: &'a Target,
    settings: &'a Settings,
}

impl OneRun<'_> {
    fn session<'s>(&'s self, settings: &'s Settings) -> Session<'s> {
        Session { loader: self.loader, settings, progress: Some(self.count) }
    }

    fn path(&self) -> &Path {
        &self.target.path
    }

    /// The account for people.
    fn account(
        &self,
        before: Option<&Settings>,
        all: bool,
        locale: Locale,
        out: &mut impl Write,
    ) -> io::Result<(Outcome, Option<End>)> {
        let name = self.target.name();
        let run = |settings, red| {
            self.session(settings).run(self.path(), &name, Purpose::Compile, (Estimate::new(settings, red), ()))
        };
        let Run { outcome, whole } = run(self.settings, if all { usize::MAX } else { RED });
        let Some((summary, end)) = whole else { return Ok((outcome, None)) };
        let before = before.map(|settings| (Basis::of(settings), run(settings, 0).whole));
        let account = Account {
            name: &name,
            basis: &Basis::of(self.settings),
            summary: &summary,
            configured: before.as_ref().map(|(basis, whole)| (basis, whole.as_ref().map(|(summary, _)| summary))),
            sources: &outcome.sources,
        };
        out.write_all(account.text(locale.lang).as_bytes())?;
        out.flush()?;
        Ok((outcome, Some(end)))
    }

    /// A row or record for each block. Also how many blocks take longer than is known, since P is not.
    fn rows(&self, args: &MotionArgs, out: &mut (impl Write + Send)) -> io::Result<((Outcome, Option<End>), u64)> {
        let name = self.target.name();
        let json = args.format == MotionFormat::Json;
        let profile: Profile = self.settings.machine.motion.profile.value;
        let head = if json { machine(&Basis::of(self.settings), &name) } else { CSV_HEAD.to_owned() };
        let mut rows = Rows { out, text: Vec::new(), row: String::new(), jerk_free: 0, error: None };
        let times = Times { phases: args.phases, time_dist: true };
        let sink = RowSink { rows: &mut rows, head, summary: Summary::new(profile, 0), json };
        let run = self.session(self.settings).run_timed(self.path(), &name, Purpose::Compile, times, sink);
        rows.flush();
        match rows.error {
            Some(error) => Err(error),
            None => Ok(((run.outcome, run.whole), rows.jerk_free)),
        }
    }
}

#[cfg(feature = "arrow")]
impl OneRun<'_> {
    /// The same as columns.
    fn columns(&self, phases: bool, out: &mut Stream) -> io::Result<((Outcome, Option<End>), u64)> {
        let name = self.target.name();
        let (mut failed, mut jerk_free) = (None, 0);
        let mut out = crate::columns::Ipc::new(io::BufWriter::with_capacity(BUFFER, out));
        let first = machine(&Basis::of(self.settings), &name);
        let profile = self.settings.machine.motion.profile.value;
        let sink = crate::columns::MotionTable::new(first, profile, &mut out, &mut failed, &mut jerk_free);
        let times = Times { phases, time_dist: true };
        let run = self.session(self.settings).run_timed(self.path(), &name, Purpose::Compile, times, sink);
        failed.map_or(Ok(((run.outcome, run.whole), jerk_free)), Err)
    }
}

/// Text on its way out.
struct Rows<'o, W> {
    out: &'o mut W,
    text: Vec<u8>,
    /// A row of CSV.
    row: String,
    /// Blocks whose jerk nothing limits, since P is not known.
    jerk_free: u64,
    error: Option<io::Error>,
}

impl<W: Write> Rows<'_, W> {
    fn flush(&mut self) {
        if self.error.is_none() {
            self.error = self.out.write_all(&self.text).and_then(|()| self.out.flush()).err();
        }
        self.text.clear();
    }
}

/// Writes blocks with their times.
struct RowSink<'r, 'o, W> {
    rows: &'r mut Rows<'o, W>,
    /// What comes before the first block.
    head: String,
    summary: Summary,
    json: bool,
}

impl<W: Write> TimedSink for RowSink<'_, '_, W> {
    type Whole = End;

    fn begin(&mut self, _: &Program<'_>) {
        self.rows.text.extend_from_slice(self.head.as_bytes());
    }

    fn block(&mut self, _: &Executed<'_>, times: &BlockTimes, _: &mut Findings) -> ControlFlow<()> {
        let Self { rows, summary, json, .. } = self;
        rows.jerk_free += u64::from(times.motion.as_ref().is_some_and(|motion| motion.jerk_free));
        if *json {
            summary.add(times);
            write_block(&mut rows.text, times);
        } else {
            rows.row.clear();
            write_csv(&mut rows.row, times);
            rows.text.extend_from_slice(rows.row.as_bytes());
        }
        if rows.text.len() >= BUFFER {
            rows.flush();
        }
        if rows.error.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn no_jerk(&mut self, motion_s: f64) {
        crate::analysis::motion::Listener::no_jerk(&mut self.summary, motion_s);
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        if self.json {
            self.rows.text.extend_from_slice(total(&self.summary).as_bytes());
        }
        end
    }
}
