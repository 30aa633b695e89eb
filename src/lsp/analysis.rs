//! The run over one open document: what requests are answered from, and what is found.

use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock};
use std::time::{Duration, Instant};

use super::client::Client;
use super::files::EditorFiles;
use crate::config::{PROJECT_FILE, Settings, configure, find_project};
use crate::diag::{Findings, Report};
use crate::edit::edit_texts::EditText;
use crate::edit::renumber::{Renumbering, first_unread, renumber_evenly};
use crate::query;
use crate::query::cancel::Cancel;
use crate::session::{Outcome, Session};
use crate::text::{Loader, Sources};

/// Findings that need no execution are shown after this time, when execution takes longer.
const PATIENCE: Duration = Duration::from_millis(400);

/// An analysed document, with the editor's files that it was read from.
#[derive(Debug)]
pub(super) struct Analysis {
    /// What queries answer from.
    known: query::analysis::Analysis,
    /// The files as they were.
    pub(super) files: EditorFiles,
    /// The first line that could not be read, as renumbering says it.
    unread: Option<EditText>,
    /// Whether the configuration has errors, and always had: how the program is to be laid out nobody knows.
    pub(super) misconfigured: bool,
}

impl Analysis {
    /// New numbers for the blocks of the document.
    ///
    /// # Errors
    /// Why there are none.
    pub(super) fn renumbering(&self) -> Result<Renumbering, EditText> {
        match &self.unread {
            Some(unread) => Err(unread.clone()),
            None => renumber_evenly(&self.resolved),
        }
    }
}

impl Deref for Analysis {
    type Target = query::analysis::Analysis;

    fn deref(&self) -> &Self::Target {
        &self.known
    }
}

/// What was found, and where was looked for it.
#[derive(Debug)]
pub(super) struct Found {
    /// The findings of the configuration, the program and what it leads to.
    pub(super) report: Report,
    /// Every file that was read: a change of one of them makes the findings old.
    pub(super) read: Vec<PathBuf>,
    /// Whether the configuration has errors, and always had: the program was judged by the client's settings alone.
    pub(super) misconfigured: bool,
}

/// An intermediate result of a run.
pub(super) trait Progress: Sync {
    /// The document is resolved; not called for configuration files.
    fn analysed(&self, analysis: Analysis, read: Vec<PathBuf>);
    /// Execution takes long; what is found so far.
    fn found_so_far(&self, found: Found);
}

/// Whether the document is one that configures, no program.
pub(super) fn is_configuration(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == PROJECT_FILE)
        || path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("xml"))
}

/// The configuration of the programs in the folder of `path`: the settings of the client over those of the project
/// file; and what was found in which files.
pub(super) fn configuration(path: &Path, files: &EditorFiles, client: &Client) -> (Settings, Sources, Findings) {
    let project = find_project(path.parent().unwrap_or(Path::new("")), files);
    let (mut sources, mut findings) = (Sources::new(), Findings::new());
    let overrides = client.overrides(path, files);
    let settings = configure(project.as_deref(), overrides, files, &mut sources, &mut findings);
    (settings, sources, findings)
}

/// The settings that programs in the folder of `path` are judged by, and whether they are the client's alone: `current`
/// when it has no errors, else the last ones of the project file that had none, else those of the client.
fn judged_by(
    current: Settings,
    has_errors: bool,
    path: &Path,
    files: &EditorFiles,
    client: &Client,
) -> (Settings, bool) {
    let project = find_project(path.parent().unwrap_or(Path::new("")), files);
    if !has_errors {
        if let Some(project) = project {
            client.keep_good(&project, &current);
        }
        return (current, false);
    }
    match project.and_then(|project| client.last_good(&project)) {
        Some(good) => (good, false),
        None => {
            let (mut sources, mut findings) = (Sources::new(), Findings::new());
            (configure(None, client.overrides(path, files), files, &mut sources, &mut findings), true)
        }
    }
}

/// Runs over the document at `path`. `None` when that was cancelled.
pub(super) fn run(
    path: &Path,
    files: &EditorFiles,
    client: &Client,
    cancel: &Cancel,
    progress: &dyn Progress,
) -> Option<Found> {
    if cancel.is_cancelled() {
        return None;
    }
    let (current, config_sources, config_findings) = configuration(path, files, client);
    let configured = || {
        let mut report = Report::new();
        report.add(&config_sources, config_findings.clone());
        report
    };
    let mut report = configured();
    let (settings, misconfigured) = judged_by(current, report.errors() > 0, path, files, client);
    let mut read = paths(files, &config_sources);
    read.extend(settings.macrocycles.iter().map(|folder| files.canonical(folder)));
    if is_configuration(path) {
        return Some(Found { report, read, misconfigured });
    }

    let begun = Instant::now();
    let name = path.to_string_lossy().into_owned();
    let interim = Mutex::new(None);
    let goes_on = |_| {
        if begun.elapsed() > PATIENCE
            && let Ok(mut interim) = interim.lock()
            && let Some(found) = interim.take()
        {
            progress.found_so_far(found);
        }
        !cancel.is_cancelled()
    };
    let session = Session { loader: files, settings: &settings, progress: Some(&goes_on) };
    let (mut outcome, resolved) = session.resolve(path, &name);
    let executable = Session::can_execute(&resolved);
    if cancel.is_cancelled() {
        return None;
    }
    let record = Arc::new(OnceLock::new());
    progress.analysed(
        Analysis {
            known: query::analysis::Analysis {
                path: path.to_path_buf(),
                loader: Arc::new(files.clone()),
                settings: settings.clone(),
                sources: outcome.sources.clone(),
                resolved: resolved.clone(),
                executable,
                certain: executable && !outcome.findings.prevent_execution(),
                record: Arc::clone(&record),
                state: Arc::default(),
            },
            files: files.clone(),
            unread: first_unread(&outcome),
            misconfigured,
        },
        [read.clone(), paths(files, &outcome.sources)].concat(),
    );
    if executable {
        if let Ok(mut interim) = interim.lock() {
            let (mut report, findings) = (configured(), outcome.findings.clone());
            report.add_program(&outcome.sources, findings);
            *interim = Some(Found { report, read: read.clone(), misconfigured });
        }
        let recorded;
        (outcome, recorded) = session.execute_recorded(path, resolved, outcome);
        if cancel.is_cancelled() {
            return None;
        }
        let _ = recorded.is_none_or(|recorded| record.set(recorded).is_ok());
    }
    read.extend(paths(files, &outcome.sources));
    let Outcome { sources, findings, .. } = outcome;
    report.add_program(&sources, findings);
    Some(Found { report, read, misconfigured })
}

fn paths(files: &EditorFiles, sources: &Sources) -> Vec<PathBuf> {
    sources.iter().map(|(_, source)| files.canonical(Path::new(source.name()))).collect()
}
