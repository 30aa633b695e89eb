//! What `format` and `renumber` have in common: files read, made anew, and replaced whole, or only shown.

use std::borrow::Cow;
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
use super::replace::{Replacement, clean_up_when_interrupted};
use super::status::{Failure, Status, complain, stdout, tell};
use super::threads;
use super::walk::{Origin, Target, targets};
use super::words::{Words, reason};
use crate::config::Settings;
use crate::diag::{Findings, Format, Report};
use crate::disk::{DiskLoader, is_stdin};
use crate::text::{DecodeError, Encoding, Loader, SourceText, Sources};

/// How many files are made anew before they get their names: bounds what is kept of them.
const AT_ONCE: usize = 64;

/// A command's result for one file.
pub(super) struct Made {
    /// Whether it becomes another one. If not, the bytes given do not count.
    pub changed: bool,
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
        Self { changed: false, said: Vec::new(), findings: None, refused: None }
    }
}

/// How a command makes one file anew: its target, its text, the settings, and what takes its bytes.
pub(super) type Make<'a> = dyn Fn(&Target, &Arc<SourceText>, &Settings, &mut dyn FnMut(&[u8])) -> Made + Sync + 'a;

/// A file as it was and as it is to be.
struct Rewritten {
    before: Before,
    made: Made,
    after: After,
}

/// A file as it was.
struct Before {
    source: Arc<SourceText>,
    /// Of a file in UTF-16, which may have lost some when it was decoded. Those of others follow from the text.
    bytes: Option<Vec<u8>>,
}

impl Before {
    fn decode(name: String, bytes: Vec<u8>, fallback: Encoding) -> Result<Self, DecodeError> {
        let is_wide = Encoding::utf16(&bytes).is_some();
        let kept = is_wide.then(|| bytes.clone());
        Ok(Self { source: Arc::new(SourceText::decode(name, bytes, fallback)?), bytes: kept })
    }

    fn bytes(&self) -> Cow<'_, [u8]> {
        let encode = || self.source.encoding().encode(self.source.text());
        self.bytes.as_deref().map_or_else(encode, Cow::Borrowed)
    }
}

/// What takes the bytes of a file that is made anew. They are not held beside the tree of its blocks unless they must
/// be.
enum After {
    /// Nobody wants them.
    Nowhere,
    /// They are shown, or written when those of the files before it are.
    Memory(Vec<u8>),
    /// The only file goes to standard output.
    Out(io::Result<bool>),
    /// The file that takes the place of the old one, from the first bytes on.
    File(PathBuf, Option<io::Result<Box<Replacement>>>),
}

impl After {
    fn of(target: &Target, args: &RewriteArgs, loader: &DiskLoader, alone: bool) -> Self {
        let shows = args.check || args.diff;
        match is_stdin(&target.path) {
            _ if args.diff => Self::Memory(Vec::new()),
            true if !shows && alone => Self::Out(Ok(false)),
            true if !shows => Self::Memory(Vec::new()),
            false if !shows && target.origin != Origin::Linked && !loader.is_stream(&target.path) => {
                Self::File(target.path.clone(), None)
            }
            _ => Self::Nowhere,
        }
    }

    fn take(&mut self, bytes: &[u8]) {
        match self {
            Self::Nowhere => {}
            Self::Memory(all) => all.extend_from_slice(bytes),
            Self::Out(written) => {
                if written.is_ok() {
                    *written = io::stdout().write_all(bytes).map(|()| true);
                }
            }
            Self::File(path, file) => {
                let file = file.get_or_insert_with(|| Replacement::begin(path).map(Box::new));
                if let Ok(open) = file
                    && let Err(error) = open.write_all(bytes)
                {
                    *file = Err(error);
                }
            }
        }
    }
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
    let origins = Origins { overrides: &overrides, loader: &loader };
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
    let shows = args.diff || args.check;
    let writes = shows || found.targets.iter().any(|target| is_stdin(&target.path));
    let out = if writes { stdout()? } else { io::stdout().lock() };
    clean_up_when_interrupted(locale.lang);
    let mut rewriting = Rewriting {
        args,
        locale,
        loader: &loader,
        out: BufWriter::with_capacity(1 << 16, out),
        report,
        changed: 0,
        same: 0,
        refused: false,
        unusable: found.targets.is_empty(),
    };
    let alone = found.targets.len() == 1;
    let after = |target: &Target| After::of(target, args, &loader, alone);
    for some in found.targets.chunks(AT_ONCE) {
        let one = |target: &Target| rewritten(target, &projects, &loader, after(target), make);
        let all: Vec<_> =
            if some.len() == 1 { some.iter().map(one).collect() } else { some.par_iter().map(one).collect() };
        for (target, rewritten) in some.iter().zip(all) {
            rewriting.take(target, rewritten, &projects)?;
        }
    }
    rewriting.finish(&shown)
}

fn rewritten(
    target: &Target,
    projects: &Projects,
    loader: &DiskLoader,
    mut after: After,
    make: &Make<'_>,
) -> io::Result<Rewritten> {
    if let Some(problem) = &target.problem {
        return Err(io::Error::new(problem.kind(), problem.to_string()));
    }
    let settings = projects.settings(target);
    let encoding = settings.map(|settings| settings.encoding).unwrap_or_default();
    let only = matches!(after, After::Out(_));
    let bytes = if only { loader.read_once(&target.path)? } else { loader.read(&target.path)? };
    let before = Before::decode(target.name(), bytes, encoding)?;
    let made = settings.map(|settings| make(target, &before.source, settings, &mut |bytes| after.take(bytes)));
    let made = made.unwrap_or_else(Made::unchanged);
    Ok(Rewritten { before, made, after })
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
        let Rewritten { before, made, after } = match file {
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
            return match after {
                After::Out(Err(error)) => Err(error),
                After::Out(Ok(true)) => Ok(()),
                After::Memory(after) if made.changed => self.out.write_all(&after),
                After::Out(Ok(false)) | After::Memory(_) | After::Nowhere | After::File(..) => {
                    self.out.write_all(&before.bytes())
                }
            };
        }
        if !made.changed {
            self.same += 1;
            return Ok(());
        }
        match after {
            After::Memory(after) => {
                self.changed += 1;
                let terminal = io::stdout().is_terminal();
                let encoding = projects.settings(target).map(|settings| settings.encoding).unwrap_or_default();
                let lines = |bytes| if terminal { diff::safe_lines(bytes, encoding) } else { diff::lines(bytes) };
                let colors = self.locale.colors(terminal);
                let (before, after) = (lines(&before.bytes()), lines(&after));
                self.out.write_all(&diff::unified(&name, &before, &after, colors))?;
            }
            After::Nowhere | After::Out(_) if self.args.check => {
                self.changed += 1;
                writeln!(self.out, "{}", crate::diag::terminal_safe(&name))?;
            }
            After::File(_, Some(file)) => self.replace(target, &before.bytes(), file),
            After::Nowhere | After::Out(_) | After::File(..) => self.leave(target),
        }
        Ok(())
    }

    /// Leaves a file that is a stream, or that nobody named and a link leads to.
    fn leave(&mut self, target: &Target) {
        let (lang, file) = (self.locale.lang, target.name());
        if target.origin == Origin::Linked {
            self.same += 1;
            tell(&Words::RewriteLink { file }, lang);
        } else {
            self.unusable = true;
            complain(&Words::RewriteNeedsFile { file }, lang);
        }
    }

    /// Puts the new file in the place of the old one.
    fn replace(&mut self, target: &Target, before: &[u8], new: io::Result<Box<Replacement>>) {
        let file = target.name();
        let problem = match new.and_then(|new| fix::put(*new, &target.path, self.loader, before)) {
            Ok(true) => {
                self.changed += 1;
                return;
            }
            Ok(false) => Words::RewriteChanged { file },
            Err(error) => Words::CannotWrite { file, reason: reason(&error, self.locale.lang) },
        };
        self.unusable = true;
        complain(&problem, self.locale.lang);
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
