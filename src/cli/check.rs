//! `check`: every finding of every program.

use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::PathBuf;

use rayon::prelude::*;

use super::args::{CheckArgs, FindingsArgs};
use super::common::{Origins, Projects, overrides};
use super::fix::{diff_all, fix_all};
use super::locale::Locale;
use super::progress::{Counted, Progress};
use super::status::{Failure, Status, stdout, tell, tell_unshown};
use super::threads;
use super::walk::{Found, Target, targets};
use super::words::Words;
use crate::diag::{Diagnostic, Finding, Findings, Format, Problem, Report, Shown, render};
use crate::disk::DiskLoader;
use crate::session::{Outcome, Session};
use crate::text::{Location, SourceText, Sources, path_name};

/// How many programs are checked before their findings are put in order: bounds what is kept of them.
const AT_ONCE: usize = 1024;

pub(super) fn run(args: &CheckArgs, locale: Locale) -> Result<Status, Failure> {
    let overrides = overrides(&args.common, locale.lang)?;
    threads::prepare();
    let loader = DiskLoader::new(args.paths.iter().map(PathBuf::as_path));
    let origins = Origins { overrides: &overrides, loader: &loader };
    let mut projects = Projects::default();
    let found = targets(&args.paths, &mut |folder| projects.extensions(folder, origins));
    tell_unsearched(&found, locale);
    let targets = found.targets;
    if let Some(stream) = targets.iter().find(|target| args.fix && loader.is_stream(&target.path)) {
        return Err(Words::FixNeedsFile { file: stream.name() }.into());
    }
    projects.configure(&targets, origins)?;
    if args.diff {
        return show_diff(&targets, projects, &loader, args, locale);
    }
    let mut report = projects.report();
    let mut unusable = report.errors() > 0 || (targets.is_empty() && !args.allow_empty);
    if !unusable {
        if args.fix {
            unusable = fix_all(&targets, &projects, &loader, locale.lang);
            report.set_fixed();
        }
        unusable |= check_all(&targets, &projects, &loader, locale, &mut report);
    }
    if unusable {
        report.set_unusable();
    }
    // Where nothing was checked, "no errors" would say too much.
    let nothing = targets.is_empty() && report.items().len() == 0;
    if !nothing || !matches!(args.shown.format, Format::Human | Format::Short) {
        print(&args.shown, &report, locale)?;
    }
    Ok(match report.errors() > 0 || (args.deny_warnings && report.warnings() > 0) {
        _ if unusable => Status::Unusable,
        true => Status::Faulty,
        false => Status::Fine,
    })
}

/// `--diff`: what `--fix` would change, and nothing else on standard output.
fn show_diff(
    targets: &[Target],
    mut projects: Projects,
    loader: &DiskLoader,
    args: &CheckArgs,
    locale: Locale,
) -> Result<Status, Failure> {
    let report = projects.report();
    if report.errors() > 0 {
        print(&args.shown, &report, locale)?;
        return Ok(Status::Unusable);
    }
    let mut out = BufWriter::with_capacity(1 << 16, stdout()?);
    let (some, unreadable) = diff_all(targets, &projects, loader, locale, &mut out)?;
    Ok(match (unreadable || (targets.is_empty() && !args.allow_empty), some) {
        (true, _) => Status::Unusable,
        (false, true) => Status::Faulty,
        (false, false) => Status::Fine,
    })
}

/// Says what a search of folders did not find, or left alone.
pub(super) fn tell_unsearched(found: &Found, locale: Locale) {
    let named = |path: &PathBuf| path_name(path);
    for folder in &found.barren {
        tell(&Words::NoPrograms { folder: named(folder) }, locale.lang);
    }
    for link in &found.outward {
        tell(&Words::OutwardLink { link: named(link) }, locale.lang);
    }
    for file in &found.special {
        tell(&Words::SpecialFile { file: named(file) }, locale.lang);
    }
    for link in &found.dangling {
        tell(&Words::DanglingLink { link: named(link) }, locale.lang);
    }
}

/// Checks the programs on all cores, and adds what is found in their order. Whether one could not be read.
fn check_all(
    targets: &[Target],
    projects: &Projects,
    loader: &DiskLoader,
    locale: Locale,
    report: &mut Report,
) -> bool {
    let counted = match targets {
        [_] => Counted::Blocks,
        _ => Counted::Files(targets.len() as u64),
    };
    let progress = Progress::start(counted, false, locale.lang);
    let count = progress.counter();
    let blocks = |blocks: u64| matches!(counted, Counted::Files(_)) || count(blocks);
    let check = |target: &Target| {
        let settings = projects.settings(target)?;
        let outcome = check_one(target, &Session { loader, settings, progress: Some(&blocks) });
        if matches!(counted, Counted::Files(_)) {
            progress.advance();
        }
        Some(outcome)
    };
    let mut unusable = false;
    let mut add = |outcome: Outcome| {
        unusable |= outcome.lacks_file();
        outcome.add_to(report);
    };
    if let [only] = targets {
        // The threads of the pool are not started for one program.
        check(only).into_iter().for_each(&mut add);
    } else {
        for some in targets.chunks(AT_ONCE) {
            let outcomes: Vec<_> = some.par_iter().filter_map(check).collect();
            outcomes.into_iter().for_each(&mut add);
        }
    }
    unusable
}

fn check_one(target: &Target, session: &Session<'_>) -> Outcome {
    if let Some(error) = &target.problem {
        return unreadable(&target.name(), error);
    }
    let outcome = session.check(&target.path, &target.name());
    if !outcome.findings.is_empty() {
        return outcome;
    }
    // Its name is enough, and there may be many programs.
    let mut sources = Sources::new();
    sources.add(SourceText::from_text(target.name(), ""));
    Outcome { sources, ..outcome }
}

/// E0112 for what cannot be read, shown as an empty file.
pub(super) fn unreadable(name: &str, error: &io::Error) -> Outcome {
    let mut sources = Sources::new();
    let file = sources.add(SourceText::from_text(name, ""));
    let mut findings = Findings::new();
    let at = Location { file, ..Location::default() };
    findings.add(Diagnostic::new(Finding::UnreadableFile { problem: Problem::from_io(error), file: None }, at));
    Outcome { sources, findings, unusable: true, ..Outcome::default() }
}

/// Writes the findings to standard output.
fn print(args: &FindingsArgs, report: &Report, locale: Locale) -> Result<(), Failure> {
    let colors = locale.colors(io::stdout().is_terminal());
    let mut out = BufWriter::with_capacity(1 << 16, stdout()?);
    let shown = Shown { lang: locale.lang, colour: colors, all: args.all };
    match render(args.format, report, shown, &mut out).and_then(|()| out.flush()) {
        Ok(()) => tell_unshown(args.format, report, locale.lang),
        // A reader that has read enough does not make the programs right.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {}
        Err(error) => return Err(error.into()),
    }
    Ok(())
}
