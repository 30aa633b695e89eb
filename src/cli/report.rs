//! `report`: the set-up sheet of a program.

use std::ffi::OsStr;
use std::io::Write;
use std::path::Path;

use super::args::{FindingsArgs, ReportArgs, ReportFormat};
use super::common::overrides;
use super::compile::{Stream, cannot_write};
use super::job::{Ends, Job, unusable};
use super::locale::Locale;
use super::progress::{Counted, Progress};
use super::status::{Failure, Status};
use super::threads;
use super::words::Words;
use crate::analysis::motion::Estimate;
use crate::analysis::sheet::{SheetReader, document, html, json, markdown, text};
use crate::config::{Overrides, Purpose};
use crate::diag::Format;
use crate::session::{Run, Session};

/// As asked for, else as the name of the file says.
fn format(args: &ReportArgs) -> ReportFormat {
    let extension = args.output.as_deref().and_then(Path::extension).map(OsStr::to_ascii_lowercase);
    args.format.unwrap_or_else(|| match extension.as_deref().and_then(OsStr::to_str) {
        Some("html" | "htm") => ReportFormat::Html,
        Some("md") => ReportFormat::Markdown,
        Some("json") => ReportFormat::Json,
        _ => ReportFormat::Human,
    })
}

pub(super) fn run(args: &ReportArgs, locale: Locale) -> Result<Status, Failure> {
    let overrides = Overrides { computes_motion: true, ..overrides(&args.common, locale.lang)? };
    threads::prepare();
    let shown = FindingsArgs { format: Format::Human, all: args.all };
    let job = Job::new(args.file.clone(), args.output.clone());
    let mut projects = job.configure(&overrides)?;
    let report = projects.report();
    let Some(settings) = projects.settings(job.target()).filter(|_| report.errors() == 0) else {
        return Ok(unusable(report, &shown, locale));
    };
    let mut stream = Stream::open(job.output(), locale.lang)?;
    let progress = Progress::start(Counted::Blocks, matches!(stream, Stream::Stdout(_)), locale.lang);
    let count = progress.counter();
    let session = Session { loader: &job.loader, settings, progress: Some(&count) };
    let sinks = ((SheetReader::new(), Estimate::new(settings, 0)), ());
    // A parameter of the machine is no error here: the sheet lists it.
    let (path, name) = (&job.target().path, job.target().name());
    let Run { mut outcome, whole } = session.run(path, &name, Purpose::Report, sinks);
    if whole.is_none() {
        outcome = session.why_unfinished(path, &name, outcome);
    }
    drop(progress);
    job.refuse_input()?;
    if let Some(((sheet, summary), _)) = &whole {
        let assumed = !settings.machine.motion.configured;
        let page = || document(sheet, summary, assumed, locale.lang);
        let written = match format(args) {
            ReportFormat::Human => text(&page()),
            ReportFormat::Json => json(sheet, summary, assumed),
            ReportFormat::Markdown => markdown(&page()),
            ReportFormat::Html => html(&page()),
        };
        let done = stream.write_all(written.as_bytes()).and_then(|()| stream.flush());
        done.map_err(|error| cannot_write(error, job.output(), locale.lang))?;
    }
    let reason = Words::NoWholeSheet { file: job.target().name() };
    let ends = Ends { whole: Status::Fine, broken: Status::Faulty, reason };
    job.finish(stream, (outcome, whole.map(|(_, end)| end)), report, ends, &shown, locale)
}
