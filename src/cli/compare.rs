//! `compare`: what two programs do differently.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::args::{CompareArgs, FindingsArgs, StateFormat};
use super::common::{Origins, Projects, overrides, print_beside};
use super::job::{Job, unusable};
use super::locale::Locale;
use super::status::{Failure, Status, stdout};
use super::threads;
use super::walk::targets;
use super::words::Words;
use crate::analysis::compare::{Row, Side, StepReader, Steps, Tolerances, Verdict, compare, json, table, text};
use crate::analysis::state::AtTime;
use crate::config::{Overrides, Purpose};
use crate::diag::{Format, Report};
use crate::dict::Micro;
use crate::disk::DiskLoader;
use crate::session::Session;
use crate::text::path_name;

/// A program that was read; nothing when it could not be, or has errors.
type Read = (Report, Option<(Side, Steps)>);

pub(super) fn run(args: &CompareArgs, locale: Locale) -> Result<Status, Failure> {
    if args.old.is_dir() && args.new.is_dir() {
        return folders(args, locale);
    }
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

/// Two folders: programs of the same path are compared (CMP-7).
fn folders(args: &CompareArgs, locale: Locale) -> Result<Status, Failure> {
    if args.format == StateFormat::Json {
        return Err(Words::CompareFoldersJson.into());
    }
    let overrides = overrides(&args.common, locale.lang)?;
    threads::prepare();
    let shown = FindingsArgs { format: Format::Human, all: args.all };
    let tolerances = Tolerances { position: Micro::from_f64(args.tolerance), percent: args.feed_tolerance };
    let (old, new) = (programs(&args.old, args, &overrides), programs(&args.new, args, &overrides));
    let names: BTreeSet<&PathBuf> = old.iter().chain(&new).collect();
    if names.is_empty() {
        return Err(Words::NoPrograms { folder: args.new.display().to_string() }.into());
    }
    let mut rows = Vec::new();
    for name in names {
        let verdict = match (old.contains(name), new.contains(name)) {
            (true, false) => Verdict::Removed,
            (false, _) => Verdict::Added,
            (true, true) => {
                let read_one = |folder: &Path| read(&folder.join(name), args, &overrides);
                let (old, new) = crate::parallel::join(|| read_one(&args.old), || read_one(&args.new));
                let ((old_report, old), (new_report, new)) = (old?, new?);
                for report in [old_report, new_report].into_iter().filter(|report| report.errors() > 0) {
                    print_beside(&shown, &report, locale);
                }
                judge(old, new, tolerances)
            }
        };
        rows.push(Row { name: path_name(name), verdict });
    }
    let mut out = stdout()?;
    out.write_all(table(&rows, locale.lang).as_bytes())?;
    out.flush()?;
    let any = |is: fn(&Verdict) -> bool| rows.iter().any(|row| is(&row.verdict));
    Ok(if any(|verdict| matches!(verdict, Verdict::Broken)) {
        Status::Unusable
    } else if any(|verdict| !matches!(verdict, Verdict::Same)) {
        Status::Faulty
    } else {
        Status::Fine
    })
}

/// What two programs of one name are to each other.
fn judge(old: Option<(Side, Steps)>, new: Option<(Side, Steps)>, tolerances: Tolerances) -> Verdict {
    let (Some((old, old_steps)), Some((new, new_steps))) = (old, new) else { return Verdict::Broken };
    match compare(&old_steps, &new_steps, tolerances).changes.len() {
        0 => Verdict::Same,
        changes => Verdict::Different { changes, old, new },
    }
}

/// The programs of a folder, by their paths in it; macrocycles are executed with the programs that call them.
fn programs(folder: &Path, args: &CompareArgs, overrides: &Overrides) -> BTreeSet<PathBuf> {
    let loader = DiskLoader::new([]);
    let origins = Origins { named: args.common.config.as_deref(), overrides, loader: &loader };
    let mut projects = Projects::default();
    let found = targets(&[folder.to_path_buf()], &mut |folder| projects.extensions(folder, origins));
    let inside = |path: PathBuf| path.strip_prefix(folder).map(Path::to_path_buf).unwrap_or(path);
    let programs = found.targets.into_iter().filter(|target| !Session::is_macrocycle_name(&target.path));
    programs.map(|target| inside(target.path)).collect()
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
