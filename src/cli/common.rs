//! From the options that `check` and `compile` have in common to the settings of each program.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};

use super::args::{CommonArgs, FindingsArgs};
use super::locale::Locale;
use super::status::{Failure, tell_unshown};
use super::walk::Target;
use super::words::Words;
use crate::config::{Overrides, Settings, configure, find_project, parse_parameter};
use crate::diag::{Code, Findings, Format, Report, Shown, render};
use crate::dict::Lang;
use crate::disk::{DiskLoader, canonical, is_same_file, is_stdin};
use crate::explain::nearest;
use crate::text::{Loader, Sources};

/// The options that override the project files.
///
/// # Errors
/// Mistakes in `--param`, `-D`, `-W` or `-A`.
pub(super) fn overrides(args: &CommonArgs, lang: Lang) -> Result<Overrides, Failure> {
    Ok(Overrides {
        project: args.config.clone(),
        dialect: args.dialect,
        channel_config: args.channel_config.clone(),
        macrocycles: args.macrocycles.clone(),
        parameters: args.param.iter().map(|text| parameter(text, lang)).collect::<Result<_, _>>()?,
        block_skip: args.block_skip.then_some(true),
        optional_stop: args.optional_stop.then_some(true),
        encoding: args.encoding,
        max_blocks: args.max_blocks,
        motion: Vec::new(),
        computes_motion: false,
        lints: args
            .levels
            .0
            .iter()
            .map(|arg| Ok((code(arg.option, &arg.name)?, arg.level)))
            .collect::<Result<_, Words>>()?,
    })
}

fn parameter(text: &str, lang: Lang) -> Result<(u8, crate::dict::Decimal), Words> {
    parse_parameter(text)
        .map_err(|fault| Words::Parameter { text: text.to_owned(), fault: fault.text(lang).to_owned() })
}

/// The diagnostic that a level option names.
fn code(option: &'static str, name: &str) -> Result<Code, Words> {
    let (option, name) = (option.to_owned(), name.to_owned());
    match Code::find(&name) {
        Some(code) if code.is_configurable() => Ok(code),
        Some(_) => Err(Words::LevelOfError { option, name }),
        None => Err(match nearest(&name) {
            Some(near) => Words::LevelUnknownNear { option, name, near: near.to_owned() },
            None => Words::LevelUnknown { option, name },
        }),
    }
}

/// What one project file, or none, together with the command line makes.
#[derive(Debug)]
struct Configured {
    /// The file by its one name.
    file: Option<PathBuf>,
    settings: Settings,
    sources: Sources,
    findings: Findings,
}

/// Where settings come from.
#[derive(Clone, Copy)]
pub(super) struct Origins<'a> {
    /// The options of the command line.
    pub overrides: &'a Overrides,
    pub loader: &'a dyn Loader,
}

/// The settings of programs, each project file read once.
#[derive(Debug, Default)]
pub(super) struct Projects {
    /// In the order met.
    configured: Vec<Configured>,
    /// Index in `configured`, by the folder of a program.
    by_folder: BTreeMap<PathBuf, usize>,
}

impl Projects {
    /// Configures every program: by the project file that the user named, else by that of its folder.
    ///
    /// # Errors
    /// When a folder of `-L` does not exist, or `--channel-config` meets a control that has none.
    pub fn configure(&mut self, targets: &[Target], origins: Origins<'_>) -> Result<(), Failure> {
        let mut folders = origins.overrides.macrocycles.iter();
        if let Some(folder) = folders.find(|folder| !origins.loader.is_folder(folder)) {
            return Err(Words::NoFolder { folder: folder.display().to_string() }.into());
        }
        let used: BTreeSet<usize> = targets.iter().map(|target| self.of_folder(target.folder(), origins)).collect();
        if origins.overrides.channel_config.is_some() {
            let used = used.iter().filter_map(|&index| self.configured.get(index));
            let mut dialects = used.map(|configured| configured.settings.machine.dialect);
            if let Some(dialect) = dialects.find(|dialect| !dialect.has_channel_config()) {
                return Err(Words::ChannelConfigDialect { dialect: dialect.name().to_owned() }.into());
            }
        }
        Ok(())
    }

    /// The extensions that programs of a folder have.
    pub fn extensions(&mut self, folder: &Path, origins: Origins<'_>) -> Vec<String> {
        let index = self.of_folder(folder, origins);
        self.configured.get(index).map(|configured| configured.settings.extensions.clone()).unwrap_or_default()
    }

    /// The index of what the programs of a folder are configured by.
    fn of_folder(&mut self, folder: &Path, origins: Origins<'_>) -> usize {
        if let Some(&index) = self.by_folder.get(folder) {
            return index;
        }
        let file = origins.overrides.project.clone().or_else(|| find_project(folder, origins.loader));
        let index = self.load(file, origins);
        self.by_folder.insert(folder.to_path_buf(), index);
        index
    }

    fn load(&mut self, file: Option<PathBuf>, origins: Origins<'_>) -> usize {
        let identity = file.as_deref().map(canonical);
        if let Some(index) = self.configured.iter().position(|known| known.file == identity) {
            return index;
        }
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let settings = configure(file.as_deref(), origins.overrides, origins.loader, &mut sources, &mut findings);
        self.configured.push(Configured { file: identity, settings, sources, findings });
        self.configured.len() - 1
    }

    /// The settings of a program that was configured.
    pub fn settings(&self, target: &Target) -> Option<&Settings> {
        let index = self.by_folder.get(target.folder())?;
        self.configured.get(*index).map(|configured| &configured.settings)
    }

    /// Mistakes in the project files.
    pub fn report(&mut self) -> Report {
        let mut report = Report::new();
        let mut in_order: Vec<&mut Configured> = self.configured.iter_mut().collect();
        in_order.sort_by(|a, b| a.file.cmp(&b.file));
        for configured in in_order {
            let findings = std::mem::take(&mut configured.findings);
            report.add(&configured.sources, findings);
        }
        report
    }
}

/// Writes the findings to standard error: what the command makes may be on standard output. People need no word about
/// none.
pub(super) fn print_beside(args: &FindingsArgs, report: &Report, locale: Locale) {
    if report.items().len() == 0 && args.format == Format::Human {
        return;
    }
    let shown = Shown { lang: locale.lang, colour: locale.colors(io::stderr().is_terminal()), all: args.all };
    let mut out = BufWriter::new(io::stderr().lock());
    // Nobody can be told that stderr is gone.
    let _ = render(args.format, report, shown, &mut out).and_then(|()| out.flush());
    drop(out);
    tell_unshown(args.format, report, locale.lang);
}

/// Whether the file that a command is to write is one that it reads: asked before each of its steps that read.
pub(super) fn is_input(output: &Path, target: &Target, loader: &DiskLoader) -> bool {
    let redirected = is_stdin(&target.path) && is_same_file(output, Path::new("/dev/stdin"));
    redirected || is_same_file(output, &target.path) || loader.has_read(output)
}
