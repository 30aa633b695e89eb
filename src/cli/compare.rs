//! `compare`: what two programs do differently.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::args::{CompareArgs, FindingsArgs, StateFormat};
use super::common::{Origins, Projects, overrides, print_beside};
use super::compile::{Stream, cannot_write};
use super::job::{Job, unusable};
use super::locale::Locale;
use super::memory;
use super::status::{Failure, Status, stdout, tell};
use super::threads;
use super::walk::targets;
use super::words::Words;
use crate::analysis::compare::{Row, Side, Steps, Tolerances, Verdict, compare, for_page, json, table, text};
use crate::config::Overrides;
use crate::diag::{Format, Report};
use crate::dict::Micro;
use crate::disk::{DiskLoader, is_stdin};
use crate::session::Session;
use crate::text::{FileId, last_name, path_name};
use crate::view::{Collector, Keep, Naming, Part, page};

/// A program that was read; its steps only when it could be executed, and has no errors or `--partial` is given.
struct Read {
    job: Job,
    projects: Projects,
    report: Report,
    found: Option<(Side, Steps)>,
}

pub(super) fn run(args: &CompareArgs, locale: Locale) -> Result<Status, Failure> {
    if args.old.is_dir() && args.new.is_dir() {
        return folders(args, locale);
    }
    let there = |path: &Path| is_stdin(path) || path.exists();
    if let Some(folder) = [&args.old, &args.new].into_iter().find(|path| path.is_dir())
        && there(&args.old)
        && there(&args.new)
    {
        return Err(Words::CompareFolder { folder: folder.display().to_string() }.into());
    }
    if is_stdin(&args.old) && is_stdin(&args.new) {
        return Err(Words::StdinTwice.into());
    }
    check_page(args.output.as_deref())?;
    let computes_motion = args.output.is_some();
    let overrides = Overrides { computes_motion, ..overrides(&args.common, locale.lang)? };
    threads::prepare();
    let shown = FindingsArgs { format: Format::Human, all: args.all };
    let read_one = |file: &Path| read(file, args, &overrides);
    let (old, new) = crate::parallel::join(|| read_one(&args.old), || read_one(&args.new));
    let (mut old_read, mut new_read) = (old?, new?);
    let (Some((old, old_steps)), Some((new, new_steps))) = (old_read.found.take(), new_read.found.take()) else {
        if old_read.report.errors() > 0 {
            print_beside(&shown, &old_read.report, locale);
        }
        return Ok(unusable(new_read.report, &shown, locale));
    };
    if args.partial {
        print_beside(&shown, &old_read.report, locale);
        print_beside(&shown, &new_read.report, locale);
    }
    let tolerances = Tolerances { position: Micro::from_f64(args.tolerance), percent: args.feed_tolerance };
    let changes = compare(&old_steps, &new_steps, tolerances).changes;
    drop((old_steps, new_steps));
    let text = match args.format {
        _ if args.output.as_deref().is_some_and(is_stdin) => String::new(),
        StateFormat::Human => text(&old, &new, &changes, args.all, locale.lang),
        StateFormat::Json => json(&old, &new, &changes),
    };
    let status = if changes.is_empty() { Status::Fine } else { Status::Faulty };
    if let Some(output) = &args.output {
        let compared = for_page(&old, &new, &changes);
        // Of two programs of a million blocks, changes and a picture take 200 MB each.
        drop(changes);
        let old_data = draw(&old_read, &old, None)?;
        let data = draw(&new_read, &new, Some(compared))?;
        let page = page(&data, Some(&old_data), &last_name(&args.new), locale.chosen);
        let output = Some(output.as_path()).filter(|output| !is_stdin(output));
        let mut stream = Stream::open(output, locale.lang)?;
        let written = stream.write_all(page.as_bytes()).and_then(|()| stream.flush()).and_then(|()| stream.keep());
        written.map_err(|error| cannot_write(error, output, locale.lang))?;
        if let Some(output) = output {
            tell(&Words::PictureWritten { file: path_name(output) }, locale.lang);
        }
    }
    let mut out = stdout()?;
    out.write_all(text.as_bytes())?;
    out.flush()?;
    Ok(status)
}

/// Refuses what is no page.
fn check_page(output: Option<&Path>) -> Result<(), Words> {
    match output.and_then(Path::extension) {
        Some(extension) if !matches!(extension.to_ascii_lowercase().to_str(), Some("html" | "htm")) => {
            Err(Words::NoSuchComparison { extension: path_name(Path::new(extension)) })
        }
        _ => Ok(()),
    }
}

/// The data of the picture of one of two programs.
fn draw(read: &Read, side: &Side, compared: Option<Value>) -> Result<Vec<u8>, Failure> {
    let Read { job, projects, report, .. } = read;
    let target = job.target();
    let changed = || Failure::from(Words::ProgramChanged { file: path_name(&target.path) });
    let settings = projects.settings(target).ok_or_else(changed)?;
    let mut collector = Collector::new(settings, Part::default(), Keep::Records).within(|| memory::room() / 2);
    let session = Session { loader: &job.loader, settings, progress: None };
    let outcome = session.draw(&target.path, &target.name(), collector.sink()).outcome;
    if collector.is_too_large() {
        return Err(Words::ComparisonNeedsMemory.into());
    }
    if outcome.executed != side.blocks {
        return Err(changed());
    }
    job.refuse_input()?;
    let naming = Naming { program: &target.path, loader: &job.loader };
    let view = collector.finish(outcome.sources.get(FileId(0)), naming, outcome.executed);
    Ok(view.data(report, naming, compared))
}

/// Two folders: programs of the same path are compared (CMP-7).
fn folders(args: &CompareArgs, locale: Locale) -> Result<Status, Failure> {
    if args.format == StateFormat::Json {
        return Err(Words::CompareFoldersJson.into());
    }
    if args.output.is_some() {
        return Err(Words::CompareFoldersPage.into());
    }
    let overrides = overrides(&args.common, locale.lang)?;
    threads::prepare();
    let shown = FindingsArgs { format: Format::Human, all: args.all };
    let tolerances = Tolerances { position: Micro::from_f64(args.tolerance), percent: args.feed_tolerance };
    let (old, new) = (programs(&args.old, &overrides), programs(&args.new, &overrides));
    let names: BTreeSet<&PathBuf> = old.union(&new).collect();
    if names.is_empty() {
        return Err(Words::NoPrograms { folder: args.new.display().to_string() }.into());
    }
    let mut rows = Vec::new();
    for name in names {
        let read_in = |programs: &BTreeSet<PathBuf>, folder: &Path| {
            programs.contains(name).then(|| read(&folder.join(name), args, &overrides)).transpose()
        };
        let (old, new) = crate::parallel::join(|| read_in(&old, &args.old), || read_in(&new, &args.new));
        let (old, new) = (old?, new?);
        for read in old.iter().chain(&new).filter(|read| read.report.errors() > 0) {
            print_beside(&shown, &read.report, locale);
        }
        let verdict = judge(old.map(|read| read.found), new.map(|read| read.found), tolerances);
        rows.push(Row { name: path_name(name), verdict });
    }
    let mut out = stdout()?;
    out.write_all(table(&rows, locale.lang).as_bytes())?;
    out.flush()?;
    let any = |is: fn(&Verdict) -> bool| rows.iter().any(|row| is(&row.verdict));
    Ok(if any(|verdict| matches!(verdict, Verdict::Broken)) {
        Status::Unusable
    } else if any(|verdict| !matches!(verdict, Verdict::Same | Verdict::SameSoFar)) {
        Status::Faulty
    } else {
        Status::Fine
    })
}

/// A program of one folder, if it is there; then its steps, if it can be compared.
type InFolder = Option<Option<(Side, Steps)>>;

/// What became of a program.
fn judge(old: InFolder, new: InFolder, tolerances: Tolerances) -> Verdict {
    match (old, new) {
        (Some(None), _) | (_, Some(None)) => Verdict::Broken,
        (None, _) => Verdict::Added,
        (_, None) => Verdict::Removed,
        (Some(Some((old, old_steps))), Some(Some((new, new_steps)))) => {
            match compare(&old_steps, &new_steps, tolerances).changes.len() {
                0 if old.whole && new.whole => Verdict::Same,
                0 => Verdict::SameSoFar,
                changes => Verdict::Different { changes, old, new },
            }
        }
    }
}

/// The programs of a folder, by their paths in it; macrocycles are executed with the programs that call them.
fn programs(folder: &Path, overrides: &Overrides) -> BTreeSet<PathBuf> {
    let loader = DiskLoader::new([]);
    let origins = Origins { overrides, loader: &loader };
    let mut projects = Projects::default();
    let found = targets(&[folder.to_path_buf()], &mut |folder| projects.extensions(folder, origins));
    let inside = |path: PathBuf| path.strip_prefix(folder).map(Path::to_path_buf).unwrap_or(path);
    let programs = found.targets.into_iter().filter(|target| !Session::is_macrocycle(&target.path, &loader));
    programs.map(|target| inside(target.path)).collect()
}

/// Executes one of the programs.
fn read(file: &Path, args: &CompareArgs, overrides: &Overrides) -> Result<Read, Failure> {
    let job = Job::new(file.to_path_buf(), args.output.clone()).refusing(|file| Words::PageIsProgram { file });
    let mut projects = job.configure(overrides)?;
    let mut report = projects.report();
    let mut found = None;
    if let Some(settings) = projects.settings(job.target()).filter(|_| report.errors() == 0) {
        let session = Session { loader: &job.loader, settings, progress: None };
        let (path, name) = (&job.target().path, job.target().name());
        let (run, side, steps) = session.steps(path, &name, args.parameters);
        let usable = !run.outcome.unusable && run.outcome.not_executed.is_none();
        let outcome = if side.whole { run.outcome } else { session.why_unfinished(path, &name, run.outcome) };
        outcome.add_to(&mut report);
        found = (usable && (side.whole || args.partial)).then_some((side, steps));
    }
    Ok(Read { job, projects, report, found })
}
