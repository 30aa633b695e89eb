//! `compare`: what two programs do differently.

use std::io::Write;
use std::path::Path;

use super::args::{CompareArgs, FindingsArgs, StateFormat};
use super::common::{overrides, print_beside};
use super::job::{Job, unusable};
use super::locale::Locale;
use super::status::{Failure, Status, stdout};
use super::threads;
use super::words::Words;
use crate::analysis::compare::{Side, StepReader, Steps, Tolerances, compare, json, text};
use crate::analysis::state::AtTime;
use crate::config::{Overrides, Purpose};
use crate::diag::{Format, Report};
use crate::dict::Micro;
use crate::session::Session;

/// A program that was read; nothing when it could not be, or has errors.
type Read = (Report, Option<(Side, Steps)>);

pub(super) fn run(args: &CompareArgs, locale: Locale) -> Result<Status, Failure> {
    if let Some(folder) = [&args.old, &args.new].into_iter().find(|path| path.is_dir()) {
        return Err(Words::CompareFolder { folder: folder.display().to_string() }.into());
    }
    let overrides = overrides(&args.common, locale.lang)?;
    threads::prepare();
    let shown = FindingsArgs { format: Format::Human, all: args.all };
    let read_one = |file: &Path| read(file, args, &overrides);
    let (old, new) = crate::parallel::join(|| read_one(&args.old), || read_one(&args.new));
    let ((old_report, old), (new_report, new)) = (old?, new?);
    let (Some((old, old_steps)), Some((new, new_steps))) = (old, new) else {
        let fault = |report: &Report| report.errors() > 0;
        if fault(&old_report) {
            print_beside(&shown, &old_report, locale);
        }
        return Ok(unusable(new_report, &shown, locale));
    };
    if args.partial {
        print_beside(&shown, &old_report, locale);
        print_beside(&shown, &new_report, locale);
    }
    let tolerances = Tolerances { position: Micro::from_f64(args.tolerance), percent: args.feed_tolerance };
    let changes = compare(&old_steps, &new_steps, tolerances).changes;
    let text = match args.format {
        StateFormat::Human => text(&old, &new, &changes, args.all, locale.lang),
        StateFormat::Json => json(&old, &new, &changes),
    };
    let mut out = stdout()?;
    out.write_all(text.as_bytes())?;
    out.flush()?;
    Ok(if changes.is_empty() { Status::Fine } else { Status::Faulty })
}

/// Executes one of the programs.
fn read(file: &Path, args: &CompareArgs, overrides: &Overrides) -> Result<Read, Failure> {
    let job = Job::new(file.to_path_buf(), None);
    let mut projects = job.configure(&args.common, overrides)?;
    let mut report = projects.report();
    let Some(settings) = projects.settings(job.target()).filter(|_| report.errors() == 0) else {
        return Ok((report, None));
    };
    let session = Session { loader: &job.loader, settings, progress: None };
    let (path, name) = (&job.target().path, job.target().name());
    let mut reader = StepReader::new(args.parameters);
    let mut clock = AtTime::new(settings, f64::INFINITY);
    let run = session.watch(path, &name, Purpose::Report, &mut (&mut reader, &mut clock));
    let whole = run.whole.is_some();
    let usable = !run.outcome.unusable && run.outcome.not_executed.is_none();
    report.add_program(&run.outcome.sources, run.outcome.findings);
    run.outcome.not_executed.into_iter().for_each(|program| report.add_not_executed(program));
    if !usable || !(whole || args.partial) {
        return Ok((report, None));
    }
    let steps = reader.finish();
    let side = Side { name, blocks: steps.blocks, path: steps.path, time_s: clock.found().err() };
    Ok((report, Some((side, steps))))
}
