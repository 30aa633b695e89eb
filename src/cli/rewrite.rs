//! What `format` and `renumber` have in common: files read, made anew in memory, and replaced whole, or only shown.

use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::PathBuf;
use std::sync::Arc;

use rayon::prelude::*;

use super::args::{CommonArgs, FindingsArgs, RewriteArgs};
use super::check::{tell_unsearched, unreadable};
use super::common::{Origins, Projects, overrides, print_beside};
use super::diff;
use super::fix;
use super::locale::Locale;
use super::replace::clean_up_when_interrupted;
use super::status::{Failure, Status, complain, tell};
use super::threads;
use super::walk::{Origin, Target, targets};
use super::words::{Words, reason};
use crate::config::Settings;
use crate::diag::{Findings, Format, Report};
use crate::disk::{DiskLoader, is_stdin};
use crate::edit::FileBytes;
use crate::text::{Loader, SourceText, Sources};

/// How many files are made anew before they are written: bounds what is kept of them.
const AT_ONCE: usize = 64;

/// A command's result for one file.
pub(super) struct Made {
    /// Its bytes; `None` when they stay.
    pub bytes: Option<Vec<u8>>,
    /// What to say of it.
    pub said: Vec<Words>,
    /// Findings that keep it as it is.
    pub findings: Option<(Sources, Findings)>,
    /// Why the command does not do what was asked.
    pub refused: Option<Words>,
}

impl Made {
    /// As it is, without a word.
    pub(super) const fn unchanged() -> Self {
        Self { bytes: None, said: Vec::new(), findings: None, refused: None }
    }
}

/// How a command makes one file anew: its target, its text, its bytes, the settings.
pub(super) type Make<'a> = dyn Fn(&Target, &Arc<SourceText>, &[u8], &Settings) -> Made + Sync + 'a;

/// A file as it was and as it is to be.
struct Rewritten {
    before: FileBytes,
    made: Made,
}

/// Makes the named files anew, and those found in named folders.
pub(super) fn run(
    paths: &[PathBuf],
    args: &RewriteArgs,
    common: &CommonArgs,
    locale: Locale,
    make: &Make<'_>,
) -> Result<Status, Failure> {
    let overrides = overrides(common, locale.lang)?;
    threads::prepare();
    let loader = DiskLoader::new(paths.iter().map(PathBuf::as_path));
    let origins = Origins { named: common.config.as_deref(), overrides: &overrides, loader: &loader };
    let mut projects = Projects::default();
    let found = targets(paths, &mut |folder| projects.extensions(folder, origins));
    tell_unsearched(&found, locale);
    projects.configure(&found.targets, origins)?;
    let shown = FindingsArgs { format: Format::Human, all: false };
    let report = projects.report();
    if report.errors() > 0 {
        print_beside(&shown, &report, locale);
        return Ok(Status::Unusable);
    }
    clean_up_when_interrupted(locale.lang);
    let mut rewriting = Rewriting {
        args,
        locale,
        loader: &loader,
        out: BufWriter::with_capacity(1 << 16, io::stdout().lock()),
        report,
        changed: 0,
        same: 0,
        refused: false,
        unusable: found.targets.is_empty(),
    };
    for some in found.targets.chunks(AT_ONCE) {
        let one = |target: &Target| rewritten(target, &projects, &loader, make);
        let all: Vec<_> =
            if some.len() == 1 { some.iter().map(one).collect() } else { some.par_iter().map(one).collect() };
        for (target, rewritten) in some.iter().zip(all) {
            rewriting.take(target, rewritten, &projects)?;
        }
    }
    rewriting.finish(&shown)
}

fn rewritten(target: &Target, projects: &Projects, loader: &DiskLoader, make: &Make<'_>) -> io::Result<Rewritten> {
    if let Some(problem) = &target.problem {
        return Err(io::Error::new(problem.kind(), problem.to_string()));
    }
    let settings = projects.settings(target);
    let encoding = settings.map(|settings| settings.encoding).unwrap_or_default();
    let before = FileBytes::decode(target.name(), loader.read(&target.path)?, encoding)?;
    let made = settings.map(|settings| make(target, before.source(), before.bytes(), settings));
    let made = made.unwrap_or_else(Made::unchanged);
    Ok(Rewritten { before, made })
}

/// The files so far.
struct Rewriting<'a> {
    args: &'a RewriteArgs,
    locale: Locale,
    loader: &'a DiskLoader,
    out: BufWriter<io::StdoutLock<'static>>,
    report: Report,
    changed: usize,
    same: usize,
    refused: bool,
    unusable: bool,
}

impl Rewriting<'_> {
    fn take(&mut self, target: &Target, file: io::Result<Rewritten>, projects: &Projects) -> io::Result<()> {
        let lang = self.locale.lang;
        let name = target.name();
        let Rewritten { before, made } = match file {
            Ok(file) => file,
            Err(error) => {
                self.unusable = true;
                let outcome = unreadable(&name, &error);
                self.report.add(&outcome.sources, outcome.findings);
                return Ok(());
            }
        };
        for words in &made.said {
            tell(words, lang);
        }
        if let Some((sources, findings)) = made.findings {
            self.report.add(&sources, findings);
        }
        if let Some(words) = &made.refused {
            self.refused = true;
            complain(words, lang);
            return Ok(());
        }
        let shows = self.args.check || self.args.diff;
        if is_stdin(&target.path) && !shows {
            return self.out.write_all(made.bytes.as_deref().unwrap_or(before.bytes()));
        }
        let Some(after) = made.bytes else {
            self.same += 1;
            return Ok(());
        };
        self.changed += 1;
        if self.args.diff {
            let terminal = io::stdout().is_terminal();
            let encoding = projects.settings(target).map(|settings| settings.encoding).unwrap_or_default();
            let lines = |bytes| if terminal { diff::safe_lines(bytes, encoding) } else { diff::lines(bytes) };
            let colors = self.locale.colors(terminal);
            return self.out.write_all(&diff::unified(&name, &lines(before.bytes()), &lines(&after), colors));
        }
        if self.args.check {
            return writeln!(self.out, "{}", crate::diag::terminal_safe(&name));
        }
        self.replace(target, before.bytes(), &after);
        Ok(())
    }

    /// Puts the new bytes in the place of the file, unless nobody named it and a link leads there.
    fn replace(&mut self, target: &Target, before: &[u8], after: &[u8]) {
        let (lang, file) = (self.locale.lang, target.name());
        if target.origin == Origin::Linked {
            (self.changed, self.same) = (self.changed - 1, self.same + 1);
            tell(&Words::RewriteLink { file }, lang);
            return;
        }
        if self.loader.is_stream(&target.path) {
            self.unusable = true;
            complain(&Words::RewriteNeedsFile { file }, lang);
            return;
        }
        match fix::write(&target.path, self.loader, before, after) {
            Ok(true) => {}
            Ok(false) => {
                self.unusable = true;
                complain(&Words::RewriteChanged { file }, lang);
            }
            Err(error) => {
                self.unusable = true;
                complain(&Words::CannotWrite { file, reason: reason(&error, lang) }, lang);
            }
        }
    }

    fn finish(mut self, shown: &FindingsArgs) -> Result<Status, Failure> {
        self.out.flush()?;
        if self.report.items().len() > 0 {
            print_beside(shown, &self.report, self.locale);
        }
        let shows = self.args.check || self.args.diff;
        if self.changed + self.same > 0 {
            let (changed, same) = (self.changed, self.same);
            let words = if shows { Words::WouldRewrite { changed, same } } else { Words::Rewrote { changed, same } };
            tell(&words, self.locale.lang);
        }
        Ok(match (self.unusable, self.refused || (shows && self.changed > 0)) {
            (true, _) => Status::Unusable,
            (false, true) => Status::Faulty,
            (false, false) => Status::Fine,
        })
    }
}
