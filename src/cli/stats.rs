//! `stats`: one row of facts a program.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::args::{FindingsArgs, StatsArgs, StatsFormat};
use super::check::{tell_unsearched, unreadable};
use super::common::{Origins, Projects, is_input, overrides, print_beside};
use super::compile::{Stream, cannot_write};
use super::job::unusable;
use super::locale::Locale;
use super::progress::{Counted, Progress};
use super::replace::clean_up_when_interrupted;
use super::stats_cache::Cache;
use super::status::{Failure, Status, tell};
use super::threads;
use super::walk::{Target, targets};
use super::words::Words;
use crate::diag::{Format, Report};
use crate::disk::{DiskLoader, is_stdin};
use crate::session::{Outcome, Session};
use crate::stats::{CSV_HEAD, Row, csv, human, json_break, json_end, json_head, json_row};
use crate::text::{Loader, path_name};

/// How many programs are executed before their rows are written in order, and go to the cache.
const AT_ONCE: usize = 1024;
/// Bytes that are written at once.
const BUFFER: usize = 1 << 16;

pub(super) fn run(args: &StatsArgs, locale: Locale) -> Result<Status, Failure> {
    let overrides = overrides(&args.common, locale.lang)?;
    threads::prepare();
    let output = args.output.as_deref().filter(|output| !is_stdin(output));
    #[cfg(feature = "arrow")]
    if args.format == StatsFormat::Arrow {
        super::compile::refuse_terminal(output)?;
    }
    let loader = DiskLoader::new(args.paths.iter().map(PathBuf::as_path));
    let origins = Origins { overrides: &overrides, loader: &loader };
    let mut projects = Projects::default();
    let found = targets(&args.paths, &mut |folder| projects.extensions(folder, origins));
    tell_unsearched(&found, locale);
    let mut targets = found.targets;
    let first = targets.first().map(Target::name);
    targets.retain(|target| !Session::is_macrocycle(&target.path, &loader));
    if let Some(file) = first.filter(|_| targets.is_empty()) {
        return Err(Words::OnlyMacrocycles { file }.into());
    }
    projects.configure(&targets, origins)?;
    let mut report = projects.report();
    let shown = FindingsArgs { format: Format::Human, all: false };
    if report.errors() > 0 {
        return Ok(unusable(report, &shown, locale));
    }
    refuse_input(output.filter(|output| targets.par_iter().any(|target| is_input(output, target, &loader))))?;
    let cache = args.cache.as_deref().map(|folder| {
        clean_up_when_interrupted(locale.lang);
        Cache::open(folder).map_err(|error| cannot_write(error, Some(folder), locale.lang))
    });
    let cache = cache.transpose()?;
    if let Some(damage) = cache.as_ref().and_then(Cache::damage) {
        tell(&damage, locale.lang);
    }
    let mut stream = Stream::open(output, locale.lang)?;
    let archive = Archive { projects: &projects, loader: &loader, cache: cache.as_ref() };
    let progress = Progress::start(Counted::Files(targets.len() as u64), output.is_none(), locale.lang);
    let written = write(&archive, &targets, args.format, &mut stream, &progress, &mut report);
    drop(progress);
    // Macrocycles are read with the programs.
    refuse_input(output.filter(|output| loader.has_read(output)))?;
    written.and_then(|()| stream.keep()).map_err(|error| cannot_write(error, output, locale.lang))?;
    if let Some((folder, error)) = args.cache.as_deref().zip(cache.and_then(Cache::into_fault)) {
        return Err(Words::cannot_write(folder, &error, locale.lang).into());
    }
    if report.errors() > 0 || targets.is_empty() {
        return Ok(unusable(report, &shown, locale));
    }
    print_beside(&shown, &report, locale);
    Ok(Status::Fine)
}

/// Refuses an output that is one of the files read.
fn refuse_input(output: Option<&Path>) -> Result<(), Failure> {
    output.map_or(Ok(()), |output| Err(Words::OutputIsRead { file: path_name(output) }.into()))
}

/// What rows are made from.
struct Archive<'a> {
    projects: &'a Projects,
    loader: &'a DiskLoader,
    cache: Option<&'a Cache>,
}

impl Archive<'_> {
    /// The row of a program, and what is to be told of one that cannot be read.
    fn row(&self, target: &Target) -> (Row, Option<Outcome>) {
        let name = target.name();
        let unread = |error| {
            let outcome = unreadable(&name, &error);
            let findings = outcome.findings.items().iter().map(|item| (item.code().to_string(), 1)).collect();
            (Row { path: name.clone(), findings, ..Row::default() }, Some(outcome))
        };
        if let Some(problem) = &target.problem {
            let again = problem.get_ref().map_or_else(|| problem.kind().into(), |_| crate::text::BrokenLink::error());
            return unread(again);
        }
        let Some(settings) = self.projects.settings(target) else {
            return unread(io::ErrorKind::NotFound.into());
        };
        let bytes = match self.loader.read(&target.path) {
            Ok(bytes) => bytes,
            Err(error) => return unread(error),
        };
        let session = Session { loader: self.loader, settings, progress: None };
        let row = match self.cache {
            Some(cache) => cache.row(&session, target, &name, &bytes),
            None => super::stats_cache::fresh(&session, &target.path, &name, &bytes).0,
        };
        (row, None)
    }
}

/// Writes the rows in the order of the programs.
fn write(
    archive: &Archive<'_>,
    targets: &[Target],
    format: StatsFormat,
    out: &mut Stream,
    progress: &Progress,
    report: &mut Report,
) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(BUFFER, out);
    let mut first = true;
    match format {
        StatsFormat::Human => {
            for_each(archive, targets, progress, report, |row| human(&row), |text| out.write_all(text.as_bytes()))?;
        }
        StatsFormat::Json => {
            out.write_all(json_head().as_bytes())?;
            for_each(
                archive,
                targets,
                progress,
                report,
                |row| json_row(&row),
                |text| {
                    out.write_all(json_break(std::mem::take(&mut first)).as_bytes())?;
                    out.write_all(text.as_bytes())
                },
            )?;
            out.write_all(json_end().as_bytes())?;
        }
        StatsFormat::Csv => {
            out.write_all(CSV_HEAD.as_bytes())?;
            for_each(archive, targets, progress, report, |row| csv(&row), |text| out.write_all(text.as_bytes()))?;
        }
        #[cfg(feature = "arrow")]
        StatsFormat::Arrow => {
            let (mut columns, mut failed) = (crate::columns::Ipc::new(&mut out), None);
            let mut rows = crate::stats::RowTable::new(&mut columns, &mut failed);
            for_each(archive, targets, progress, report, |row| row, |row| rows.row(&row))?;
            rows.end()?;
        }
    }
    out.flush()
}

/// Writes what `make` makes of the rows, on several threads.
fn for_each<T: Send>(
    archive: &Archive<'_>,
    targets: &[Target],
    progress: &Progress,
    report: &mut Report,
    make: impl Fn(Row) -> T + Sync,
    mut write: impl FnMut(T) -> io::Result<()>,
) -> io::Result<()> {
    for some in targets.chunks(AT_ONCE) {
        let of = |target| {
            let (row, outcome) = archive.row(target);
            progress.advance();
            (make(row), outcome)
        };
        let made: Vec<_> = some.par_iter().map(of).collect();
        for (made, outcome) in made {
            if let Some(outcome) = outcome {
                report.add_program(&outcome.sources, outcome.findings);
            }
            write(made)?;
        }
        if let Some(cache) = archive.cache {
            cache.write();
        }
    }
    Ok(())
}
