//! `state`: what holds at a place of a program.

use std::io::Write;

use super::args::{FindingsArgs, StateArgs, StateFormat};
use super::common::{overrides, print_beside};
use super::job::{Job, unusable};
use super::locale::Locale;
use super::place::Named;
use super::progress::{Counted, Progress};
use super::status::{Failure, Status, complain, stdout, tell};
use super::threads;
use super::words::Words;
use crate::analysis::state::{Asked, AtTime, Place, PlaceFault, Timing, fault_text, json, text};
use crate::config::Purpose;
use crate::diag::Format;
use crate::session::Session;

pub(super) fn run(args: &StateArgs, locale: Locale) -> Result<Status, Failure> {
    let named = Named::of(&args.place, args.after)?;
    let overrides = overrides(&args.common, locale.lang)?;
    threads::prepare();
    let shown = FindingsArgs { format: Format::Human, all: args.all };
    let job = Job::new(args.file.clone(), None);
    let mut projects = job.configure(&overrides)?;
    let mut report = projects.report();
    let Some(settings) = projects.settings(job.target()).filter(|_| report.errors() == 0) else {
        return Ok(unusable(report, &shown, locale));
    };
    let progress = Progress::start(Counted::Blocks, true, locale.lang);
    let count = progress.counter();
    let session = Session { loader: &job.loader, settings, progress: Some(&count) };
    let (path, name) = (&job.target().path, job.target().name());
    let asked = match named {
        Named::At(asked) => Ok(asked),
        Named::Time(seconds, asked) => {
            let mut at_time = AtTime::new(settings, seconds);
            let run = session.watch(path, &name, Purpose::Report, &mut &mut at_time);
            match at_time.found() {
                Ok(seq) => Ok(Asked { place: Place::Seq(seq), ..asked }),
                Err(seconds) => Err((run.outcome, asked, seconds)),
            }
        }
    };
    let (outcome, asked, found) = match asked {
        Ok(asked) => {
            let run = session.state(path, &name, asked.clone(), Timing::Configured);
            let unfinished = run.found.is_err() && !run.whole;
            let outcome = if unfinished { session.why_unfinished(path, &name, run.outcome) } else { run.outcome };
            (outcome, asked, (!run.error_before).then_some(run.found))
        }
        Err((outcome, asked, seconds)) => {
            let found = (!outcome.findings.has_errors()).then_some(Err(PlaceFault::TooLate { seconds }));
            (outcome, asked, found)
        }
    };
    drop(progress);
    let status = match &found {
        _ if outcome.unusable => Status::Unusable,
        _ if outcome.not_executed.is_some() => Status::Faulty,
        Some(Err(_)) if outcome.findings.has_errors() => Status::Faulty,
        None => Status::Faulty,
        Some(Err(fault)) => {
            let text = fault_text(fault, &asked, locale.lang);
            let mut lines = text.lines().map(|line| Words::Place { text: line.to_owned() });
            lines.next().into_iter().for_each(|line| complain(&line, locale.lang));
            lines.for_each(|line| tell(&line, locale.lang));
            return Ok(Status::Unusable);
        }
        Some(Ok(found)) => {
            let text = match args.format {
                StateFormat::Human => text(found, &name, settings, locale.lang),
                StateFormat::Json => json(found, &name, settings),
            };
            let mut out = stdout()?;
            out.write_all(text.as_bytes())?;
            out.flush()?;
            Status::Fine
        }
    };
    outcome.add_to(&mut report);
    if status == Status::Unusable {
        report.set_unusable();
    }
    print_beside(&shown, &report, locale);
    Ok(status)
}
