//! From the options that `check` and `compile` have in common to the settings of each program.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::args::CommonArgs;
use super::disk::canonical;
use super::status::Failure;
use super::topic::nearest;
use super::walk::Target;
use super::words::Words;
use crate::config::{Overrides, Settings, configure, find_project, parse_parameter};
use crate::diag::{Code, Findings, Report};
use crate::dict::Lang;
use crate::text::{Loader, Sources};

/// What the command line says over the project files.
///
/// # Errors
/// What is wrong with `--param`, `-D`, `-W` or `-A`.
pub(super) fn overrides(args: &CommonArgs, lang: Lang) -> Result<Overrides, Failure> {
    Ok(Overrides {
        dialect: args.dialect,
        channel_config: args.channel_config.clone(),
        macrocycles: args.macrocycles.clone(),
        parameters: args.param.iter().map(|text| parameter(text, lang)).collect::<Result<_, _>>()?,
        block_skip: args.block_skip.then_some(true),
        optional_stop: args.optional_stop.then_some(true),
        encoding: args.encoding,
        max_blocks: args.max_blocks,
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
    pub fn configure(
        targets: &[Target],
        named: Option<&Path>,
        overrides: &Overrides,
        loader: &dyn Loader,
    ) -> Result<Self, Failure> {
        if let Some(folder) = overrides.macrocycles.iter().find(|folder| !loader.is_folder(folder)) {
            return Err(Words::NoFolder { folder: folder.display().to_string() }.into());
        }
        let mut projects = Self::default();
        for target in targets {
            if !projects.by_folder.contains_key(target.folder()) {
                let file = named.map(Path::to_path_buf).or_else(|| find_project(target.folder(), loader));
                let index = projects.load(file, overrides, loader);
                projects.by_folder.insert(target.folder().to_path_buf(), index);
            }
        }
        if overrides.channel_config.is_some() {
            let mut dialects = projects.configured.iter().map(|configured| configured.settings.machine.dialect);
            if let Some(dialect) = dialects.find(|dialect| !dialect.has_channel_config()) {
                return Err(Words::ChannelConfigDialect { dialect: dialect.name().to_owned() }.into());
            }
        }
        Ok(projects)
    }

    fn load(&mut self, file: Option<PathBuf>, overrides: &Overrides, loader: &dyn Loader) -> usize {
        let identity = file.as_deref().map(canonical);
        if let Some(index) = self.configured.iter().position(|known| known.file == identity) {
            return index;
        }
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let settings = configure(file.as_deref(), overrides, loader, &mut sources, &mut findings);
        self.configured.push(Configured { file: identity, settings, sources, findings });
        self.configured.len() - 1
    }

    /// The settings of a program that was configured.
    pub fn settings(&self, target: &Target) -> Option<&Settings> {
        let index = self.by_folder.get(target.folder())?;
        self.configured.get(*index).map(|configured| &configured.settings)
    }

    /// What is wrong with the project files.
    pub fn report(&mut self) -> Report {
        let mut report = Report::new();
        for configured in &mut self.configured {
            let findings = std::mem::take(&mut configured.findings);
            report.add(&configured.sources, findings);
        }
        report
    }
}
