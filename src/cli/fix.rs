//! `check --fix`: applies fixes to files until none is left, and writes each file once, whole.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::common::Projects;
use super::diff;
use super::locale::Locale;
use super::replace::{Replacement, clean_up_when_interrupted};
use super::status::{complain, tell};
use super::walk::{Origin, Target};
use super::words::{Words, reason};
use crate::config::{Level, Settings};
use crate::diag::{Code, Diagnostic, Fix, FixTitle};
use crate::dict::Lang;
use crate::disk::{DiskLoader, canonical};
use crate::edit::apply_fixes;
use crate::session::Session;
use crate::text::{FileId, Loader, Overlay, Sources};

/// The program among the files of its run.
const PROGRAM: FileId = FileId(0);

/// So many findings of a code are kept in a round, some hundreds of bytes each: fixes come by hundred thousands where a
/// postprocessor writes decimal commas.
const AT_ONCE: usize = 1 << 17;

/// Fixes that overlap, and findings beyond those kept, need more rounds; a fix that calls for another for ever is a
/// mistake of ours that ends here.
const MOST_ROUNDS: usize = 200;

/// Most fixes of one file that are listed.
const MOST_LISTED: usize = 20;

/// Fixes the programs, and says what was done in which. Whether a file could not be written.
pub(super) fn fix_all(targets: &[Target], projects: &Projects, loader: &DiskLoader, lang: Lang) -> bool {
    clean_up_when_interrupted(lang);
    let fix = |target: &Target| {
        let Some(mut attempt) = attempt(target, projects, loader) else { return Attempt::default() };
        if let Some(Fixable { before, after, .. }) =
            attempt.fixable.as_ref().filter(|fixable| fixable.hindrance.is_none())
        {
            attempt.written = write(&target.path, loader, before, after).map(|done| !done);
        }
        // The written text is not used again, and there may be many files.
        if let Some(fixable) = &mut attempt.fixable {
            (fixable.before, fixable.after) = (Vec::new(), Vec::new());
        }
        attempt
    };
    let mut failed = false;
    let mut elsewhere = BTreeMap::new();
    for (target, attempt) in targets.iter().zip(of_all(targets, fix)) {
        let file = target.name();
        match (attempt.fixable, attempt.written) {
            (_, Err(error)) => {
                failed = true;
                complain(&Words::CannotWrite { file, reason: reason(&error, lang) }, lang);
            }
            (_, Ok(true)) => {
                failed = true;
                complain(&Words::FixChanged { file }, lang);
            }
            (Some(fixable), Ok(false)) => tell_fixes(&file, &fixable, lang),
            (None, Ok(false)) => {}
        }
        elsewhere.extend(attempt.elsewhere);
    }
    let known: BTreeSet<PathBuf> = targets.iter().map(|target| canonical(&target.path)).collect();
    for (file, count) in elsewhere {
        if !known.contains(&canonical(Path::new(&file))) {
            tell(&Words::FixElsewhere { file, count }, lang);
        }
    }
    failed
}

/// What fixing the programs would change, as unified diffs on `out`. Whether there is something, and whether a program
/// could not be read.
///
/// # Errors
/// When `out` takes no more.
pub(super) fn diff_all(
    targets: &[Target],
    projects: &Projects,
    loader: &DiskLoader,
    locale: Locale,
    out: &mut dyn Write,
) -> io::Result<(bool, bool)> {
    let terminal = io::stdout().is_terminal();
    let colors = locale.colors(terminal);
    let diff = |target: &Target| {
        let Some(attempt) = attempt(target, projects, loader) else { return (Attempt::default(), Vec::new()) };
        let Some(Fixable { before, after, hindrance: None, .. }) = &attempt.fixable else {
            return (attempt, Vec::new());
        };
        let encoding = projects.settings(target).map(|settings| settings.encoding).unwrap_or_default();
        let lines = |bytes| if terminal { diff::safe_lines(bytes, encoding) } else { diff::lines(bytes) };
        let text = diff::unified(&target.name(), &lines(before), &lines(after), colors);
        (Attempt { fixable: None, ..attempt }, text)
    };
    let (mut some, mut unreadable) = (false, false);
    for (target, (attempt, text)) in targets.iter().zip(of_all(targets, diff)) {
        let file = target.name();
        if let Some(error) = target.problem.as_ref().or(attempt.unreadable.as_ref()) {
            unreadable = true;
            complain(&Words::CannotRead { file: file.clone(), reason: reason(error, locale.lang) }, locale.lang);
        }
        if let Some(words) =
            attempt.fixable.and_then(|fixable| fixable.hindrance).map(|hindrance| hindrance.words(file))
        {
            tell(&words, locale.lang);
        }
        some |= !text.is_empty();
        out.write_all(&text)?;
    }
    out.flush()?;
    Ok((some, unreadable))
}

/// What `attempt` gives for each program: on all cores, when there are several.
fn of_all<T: Send>(targets: &[Target], attempt: impl Fn(&Target) -> T + Send + Sync) -> Vec<T> {
    match targets {
        [only] => vec![attempt(only)],
        _ => targets.par_iter().map(attempt).collect(),
    }
}

/// Says which fixes were applied to a file, or why not.
fn tell_fixes(file: &str, fixable: &Fixable, lang: Lang) {
    if let Some(hindrance) = fixable.hindrance {
        tell(&hindrance.words(file.to_owned()), lang);
        return;
    }
    let file = file.to_owned();
    match fixable.count {
        1 => tell(&Words::FixedOne { file: file.clone() }, lang),
        count => tell(&Words::Fixed { file: file.clone(), count }, lang),
    }
    for applied in &fixable.applied {
        let Applied { line, column, code, title } = applied;
        let title = title.text(lang);
        tell(&Words::FixApplied { file: file.clone(), line: *line, column: *column, code: *code, title }, lang);
    }
    if let Some(more @ 1..) = fixable.count.checked_sub(fixable.applied.len()) {
        tell(&Words::FixesNotListed { file, more }, lang);
    }
}

/// What came of fixing one file.
#[derive(Debug)]
struct Attempt {
    /// What can be fixed, if anything.
    fixable: Option<Fixable>,
    /// Whether somebody else wrote to the file meanwhile: theirs counts.
    written: io::Result<bool>,
    /// Why the program cannot be read.
    unreadable: Option<io::Error>,
    /// How many fixes there are in the macrocycles that it calls, by file.
    elsewhere: BTreeMap<String, usize>,
}

/// A file and what fixing makes of it.
#[derive(Debug)]
struct Fixable {
    before: Vec<u8>,
    after: Vec<u8>,
    /// How many fixes.
    count: usize,
    /// The first of them.
    applied: Vec<Applied>,
    /// Why the file is left as it is.
    hindrance: Option<Hindrance>,
}

/// A fix, and where it was applied: in the text as it was when its turn came.
#[derive(Debug)]
struct Applied {
    line: u32,
    column: u32,
    code: Code,
    title: FixTitle,
}

/// Why a file that nobody named is not fixed.
#[derive(Clone, Copy, Debug)]
enum Hindrance {
    /// It was reached through a link.
    Link,
    /// It does not look like a program of this control.
    Foreign,
}

impl Hindrance {
    const fn words(self, file: String) -> Words {
        match self {
            Self::Link => Words::FixLink { file },
            Self::Foreign => Words::FixForeign { file },
        }
    }
}

impl Default for Attempt {
    fn default() -> Self {
        Self { fixable: None, written: Ok(false), unreadable: None, elsewhere: BTreeMap::new() }
    }
}

/// Fixes a program in memory, round by round until no fix is left; `None` when it has no settings, or a problem.
fn attempt(target: &Target, projects: &Projects, disk: &DiskLoader) -> Option<Attempt> {
    let settings = projects.settings(target).filter(|_| target.problem.is_none())?;
    let settings = &Settings { findings: AT_ONCE, ..settings.clone() };
    let before = match disk.read(&target.path) {
        Ok(before) => before,
        Err(error) => return Some(Attempt { unreadable: Some(error), ..Attempt::default() }),
    };
    let mut now = before.clone();
    let mut count = 0;
    let mut applied = Vec::new();
    let mut elsewhere = BTreeMap::new();
    let mut hindrance = (target.origin == Origin::Linked).then_some(Hindrance::Link);
    for round in 0..MOST_ROUNDS {
        let overlay = Overlay { below: disk, path: &target.path, bytes: &now };
        let outcome = Session { loader: &overlay, settings, progress: None }.check(&target.path, &target.name());
        let mut found: Vec<&Diagnostic> =
            outcome.findings.items().iter().filter(|item| is_shown(item, settings)).collect();
        found.sort_by_key(|diagnostic| (diagnostic.at, diagnostic.code()));
        if round == 0 && target.origin == Origin::Searched {
            let foreign = found.iter().any(|item| is_foreign(item));
            if foreign || (settings.severity(Code::W0113).is_none() && is_for_other_control(target, &overlay, settings))
            {
                hindrance = Some(Hindrance::Foreign);
            }
        }
        elsewhere = fixes_elsewhere(&outcome.sources, &found);
        let Some(source) = outcome.sources.get(PROGRAM).filter(|_| !outcome.unusable) else { break };
        let own: Vec<(&Diagnostic, &Fix)> = found.into_iter().filter_map(|item| Some((item, fix_of(item)?))).collect();
        let fixed = apply_fixes(source, PROGRAM, &now, own.iter().map(|(_, fix)| *fix));
        if fixed.bytes == now {
            break;
        }
        for &at in fixed.applied.iter().take(MOST_LISTED.saturating_sub(applied.len())) {
            if let Some((diagnostic, fix)) = own.get(at) {
                let place = source.line_column(diagnostic.at.span.start);
                let (line, column) = (place.line, place.column);
                applied.push(Applied { line, column, code: diagnostic.code(), title: fix.title.clone() });
            }
        }
        count += fixed.applied.len();
        now = fixed.bytes;
    }
    let fixable = (now != before).then_some(Fixable { before, after: now, count, applied, hindrance });
    Some(Attempt { fixable, elsewhere, ..Attempt::default() })
}

/// Whether a program is for another control (W0113), also when that finding is allowed: then it is not shown, but what
/// it says of the file holds.
fn is_for_other_control(target: &Target, loader: &dyn Loader, settings: &Settings) -> bool {
    let mut settings = settings.clone();
    settings.lints.insert(Code::W0113, Level::Warn);
    let outcome = Session { loader, settings: &settings, progress: None }.check(&target.path, &target.name());
    outcome.findings.items().iter().any(is_foreign)
}

/// Whether a finding says that a file may be no program of this control, so that nothing in it is changed unasked.
fn is_foreign(diagnostic: &Diagnostic) -> bool {
    diagnostic.file() == PROGRAM && matches!(diagnostic.code(), Code::W0113 | Code::E0111 | Code::E0203)
}

/// Puts the fixed bytes in the place of the file, unless it is no longer as it was read.
fn write(path: &Path, disk: &DiskLoader, before: &[u8], after: &[u8]) -> io::Result<bool> {
    let mut file = Replacement::begin(path)?;
    file.write_all(after)?;
    put(file, path, disk, before)
}

/// Puts a new file in the place of the old one, unless that is no longer as it was read.
pub(super) fn put(file: Replacement, path: &Path, disk: &DiskLoader, before: &[u8]) -> io::Result<bool> {
    if disk.read(path)? != before {
        return Ok(false);
    }
    file.commit_safely()?;
    Ok(true)
}

fn is_shown(diagnostic: &Diagnostic, settings: &Settings) -> bool {
    settings.severity(diagnostic.code()).is_some()
}

/// The fix of a finding in the program's own file. Of several, which exclude each other, the first.
fn fix_of(diagnostic: &Diagnostic) -> Option<&Fix> {
    if diagnostic.file() == PROGRAM { diagnostic.certain_fix() } else { None }
}

/// How many findings in other files have fixes, by the file's name.
fn fixes_elsewhere(sources: &Sources, found: &[&Diagnostic]) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    for diagnostic in found.iter().filter(|item| item.file() != PROGRAM && item.certain_fix().is_some()) {
        if let Some(source) = sources.get(diagnostic.file()) {
            *counts.entry(source.name().to_owned()).or_default() += 1;
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[expect(clippy::disallowed_methods, reason = "a test makes the file and looks at it")]
    fn a_file_that_changed_meanwhile_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.nc");
        let disk = DiskLoader::default();
        std::fs::write(&path, "theirs").unwrap();
        assert!(!write(&path, &disk, b"ours before", b"ours after").unwrap());
        assert_eq!(std::fs::read(&path).unwrap(), b"theirs");
        assert!(write(&path, &disk, b"theirs", b"fixed").unwrap());
        assert_eq!(std::fs::read(&path).unwrap(), b"fixed");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
