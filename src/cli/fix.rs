//! `check --fix`: applies fixes to files until none is left, and writes each file once, whole.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::common::Projects;
use super::disk::{DiskLoader, canonical};
use super::replace::{Replacement, clean_up_when_interrupted};
use super::status::{complain, tell};
use super::walk::Target;
use super::words::{Words, reason};
use crate::config::Settings;
use crate::diag::{Diagnostic, Fix, apply_fixes};
use crate::dict::Lang;
use crate::session::Session;
use crate::text::{FileId, Loader, Sources};

/// The program among the files of its run.
const PROGRAM: FileId = FileId(0);

/// Fixes that overlap, and findings beyond those kept, need more rounds; a fix that calls for another for ever is a
/// mistake of ours that ends here.
const MOST_ROUNDS: usize = 200;

/// Fixes the programs, and says how much in which. Whether a file could not be written.
pub(super) fn fix_all(targets: &[Target], projects: &Projects, loader: &DiskLoader, lang: Lang) -> bool {
    clean_up_when_interrupted(lang);
    let fix = |target: &Target| match projects.settings(target) {
        Some(settings) if target.problem.is_none() => fix_one(target, settings, loader),
        _ => Attempt::default(),
    };
    let attempts: Vec<Attempt> = match targets {
        [only] => vec![fix(only)],
        _ => targets.par_iter().map(fix).collect(),
    };
    let mut failed = false;
    let mut elsewhere = BTreeMap::new();
    for (target, attempt) in targets.iter().zip(attempts) {
        let file = target.name();
        match attempt.written {
            Ok(Written::Nothing) => {}
            Ok(Written::Fixes(1)) => tell(&Words::FixedOne { file }, lang),
            Ok(Written::Fixes(count)) => tell(&Words::Fixed { file, count }, lang),
            Ok(Written::Changed) => {
                failed = true;
                complain(&Words::FixChanged { file }, lang);
            }
            Err(error) => {
                failed = true;
                complain(&Words::CannotWrite { file, reason: reason(&error, lang) }, lang);
            }
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

/// What came of fixing one file.
#[derive(Debug)]
struct Attempt {
    written: io::Result<Written>,
    /// How many fixes there are in the macrocycles that it calls, by file.
    elsewhere: BTreeMap<String, usize>,
}

#[derive(Debug)]
enum Written {
    Nothing,
    Fixes(usize),
    /// Somebody else wrote to the file meanwhile: theirs counts.
    Changed,
}

impl Default for Attempt {
    fn default() -> Self {
        Self { written: Ok(Written::Nothing), elsewhere: BTreeMap::new() }
    }
}

fn fix_one(target: &Target, settings: &Settings, disk: &DiskLoader) -> Attempt {
    let Ok(before) = disk.read(&target.path) else {
        // The check that follows says why.
        return Attempt::default();
    };
    let mut now = InMemory { disk, path: disk.canonical(&target.path), bytes: before.clone() };
    let mut count = 0;
    let mut elsewhere = BTreeMap::new();
    for _ in 0..MOST_ROUNDS {
        let outcome = Session { loader: &now, settings, progress: None }.check(&target.path, &target.name());
        let mut found: Vec<&Diagnostic> =
            outcome.findings.items().iter().filter(|item| is_shown(item, settings)).collect();
        found.sort_by_key(|diagnostic| (diagnostic.at, diagnostic.code()));
        elsewhere = fixes_elsewhere(&outcome.sources, &found);
        let Some(source) = outcome.sources.get(PROGRAM).filter(|_| !outcome.unusable) else { break };
        let round = apply_fixes(source, PROGRAM, &now.bytes, found.into_iter().filter_map(fix_of));
        if round.bytes == now.bytes {
            break;
        }
        count += round.count;
        now.bytes = round.bytes;
    }
    let written = if now.bytes == before {
        Ok(Written::Nothing)
    } else {
        write(&target.path, disk, &before, &now.bytes)
            .map(|done| if done { Written::Fixes(count) } else { Written::Changed })
    };
    Attempt { written, elsewhere }
}

/// Puts the fixed bytes in the place of the file, unless it is no longer as it was read.
fn write(path: &Path, disk: &DiskLoader, before: &[u8], after: &[u8]) -> io::Result<bool> {
    let mut file = Replacement::begin(path)?;
    file.write_all(after)?;
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
    if diagnostic.file() == PROGRAM { diagnostic.fixes.first() } else { None }
}

/// How many findings in other files have fixes, by the file's name.
fn fixes_elsewhere(sources: &Sources, found: &[&Diagnostic]) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    for diagnostic in found.iter().filter(|item| item.file() != PROGRAM && !item.fixes.is_empty()) {
        if let Some(source) = sources.get(diagnostic.file()) {
            *counts.entry(source.name().to_owned()).or_default() += 1;
        }
    }
    counts
}

/// The disk, with one file as it stands after the fixes so far.
struct InMemory<'a> {
    disk: &'a DiskLoader,
    /// By its one name.
    path: PathBuf,
    bytes: Vec<u8>,
}

impl Loader for InMemory<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        if self.disk.canonical(path) == self.path { Ok(self.bytes.clone()) } else { self.disk.read(path) }
    }

    fn is_folder(&self, path: &Path) -> bool {
        self.disk.is_folder(path)
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        self.disk.list(folder)
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        self.disk.folders(folder)
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        self.disk.canonical(path)
    }
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
