//! The configuration of programs: each project file is read once.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use cnc872c::config::{Settings, configure, find_project};
use cnc872c::diag::{Findings, Report};
use cnc872c::text::{Loader, Sources};

use crate::fault::{Fault, json};
use crate::files::Files;
use crate::options::{Config, Options};

/// What one project file, or none, makes together with the options.
struct Configured {
    /// The file by its one name.
    file: Option<PathBuf>,
    settings: Settings,
    sources: Sources,
    findings: Findings,
}

/// Programs with their configuration.
pub struct Setup<'o> {
    /// Where files come from.
    pub files: Files,
    options: &'o Options,
    configured: Vec<Configured>,
    /// Index in `configured`, by the folder of a program.
    by_folder: BTreeMap<PathBuf, usize>,
}

impl<'o> Setup<'o> {
    /// For the programs at these paths. A `text` replaces the program at the first of them.
    ///
    /// # Errors
    /// A folder of macrocycles that is not there.
    pub fn new(options: &'o Options, paths: &[PathBuf], text: Option<Arc<[u8]>>) -> Result<Self, Fault> {
        let mut files = Files::new(paths.iter().map(PathBuf::as_path));
        if let (Some(text), Some(path)) = (text, paths.first()) {
            files.give(path.clone(), text);
        }
        if let Config::Text(path, text) = &options.config {
            files.give(path.clone(), Arc::clone(text));
        }
        if let Some(folder) = options.overrides.macrocycles.iter().find(|folder| !files.is_folder(folder)) {
            return Err(Fault::Option(format!("macrocycles: there is no folder {:?}", folder.display().to_string())));
        }
        Ok(Self { files, options, configured: Vec::new(), by_folder: BTreeMap::new() })
    }

    /// Configures the programs of a folder.
    pub fn folder(&mut self, folder: &Path) -> Option<&Settings> {
        let known = self.by_folder.get(folder).copied();
        let index = known.unwrap_or_else(|| {
            let file = match &self.options.config {
                Config::Found => find_project(folder, &self.files),
                Config::File(path) | Config::Text(path, _) => Some(path.clone()),
            };
            self.load(file)
        });
        self.by_folder.insert(folder.to_path_buf(), index);
        self.configured.get(index).map(|configured| &configured.settings)
    }

    fn load(&mut self, file: Option<PathBuf>) -> usize {
        let identity = file.as_deref().map(|file| self.files.canonical(file));
        if let Some(index) = self.configured.iter().position(|known| known.file == identity) {
            return index;
        }
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let settings = configure(file.as_deref(), &self.options.overrides, &self.files, &mut sources, &mut findings);
        self.configured.push(Configured { file: identity, settings, sources, findings });
        self.configured.len() - 1
    }

    /// The settings of a folder's programs, which were configured.
    pub fn settings(&self, folder: &Path) -> Option<&Settings> {
        self.by_folder.get(folder).and_then(|&index| self.configured.get(index)).map(|known| &known.settings)
    }

    /// What was found in the project files, once all folders are configured.
    ///
    /// # Errors
    /// When there are errors among it.
    pub fn report(&mut self) -> Result<Report, Fault> {
        let mut report = Report::new();
        for configured in &mut self.configured {
            report.add(&configured.sources, std::mem::take(&mut configured.findings));
        }
        let control = |known: &Configured| known.settings.machine.dialect;
        if self.options.overrides.channel_config.is_some()
            && let Some(dialect) = self.configured.iter().map(control).find(|dialect| !dialect.has_channel_config())
        {
            return Err(Fault::Option(format!("channel_config does not go with {}", dialect.name())));
        }
        if report.errors() > 0 { Err(Fault::Config(json(&report, self.options.lang))) } else { Ok(report) }
    }
}
