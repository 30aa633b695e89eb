//! The client: its capabilities and settings.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use serde_json::Value;

use super::files::EditorFiles;
use super::settings::{self, ClientSettings, folder_path, workspace_folders};
use crate::config::{Overrides, Settings};
use crate::dict::Lang;
use crate::sure::Sure;
use crate::text::{ColumnUnit, Loader};

/// The client's answers in `initialize`, and its present settings.
#[derive(Clone, Debug, Default)]
pub(super) struct Client {
    capabilities: Value,
    /// What columns count.
    pub(super) unit: ColumnUnit,
    /// By its locale.
    locale: Lang,
    /// The settings of the window.
    settings: ClientSettings,
    /// The settings as they came: of the window, then of each folder.
    sections: Vec<Value>,
    /// Settings by folder of the workspace; relative paths in them begin there.
    by_folder: Vec<(PathBuf, Overrides)>,
    /// The folders of the workspace.
    pub(super) folders: Vec<PathBuf>,
    /// The last configuration without errors, by project file.
    good: Arc<Mutex<BTreeMap<PathBuf, Settings>>>,
}

impl Client {
    /// From the parameters of `initialize`; `lang` when the client names no locale.
    pub(super) fn new(initialize: &Value, lang: Lang) -> Self {
        let capabilities = initialize.get("capabilities").cloned().unwrap_or_default();
        let locale = initialize.get("locale").and_then(Value::as_str).map_or(lang, |locale| {
            let language = locale.split(['-', '_', '.']).next().sure();
            if language.eq_ignore_ascii_case("cs") { Lang::Cs } else { Lang::En }
        });
        Self {
            unit: unit(&capabilities),
            locale,
            settings: ClientSettings::default(),
            sections: Vec::new(),
            by_folder: Vec::new(),
            folders: workspace_folders(initialize),
            good: Arc::default(),
            capabilities,
        }
    }

    /// The language of messages.
    pub(super) fn lang(&self) -> Lang {
        self.settings.lang.unwrap_or(self.locale)
    }

    /// Whether the client has the capability at that path, as in `/textDocument/diagnostic`.
    pub(super) fn has(&self, capability: &str) -> bool {
        match self.capabilities.pointer(capability) {
            None | Some(Value::Null | Value::Bool(false)) => false,
            Some(_) => true,
        }
    }

    /// The first of the names that the client lists at that path.
    pub(super) fn first(&self, capability: &str) -> Option<&str> {
        self.capabilities.pointer(capability)?.as_array()?.first()?.as_str()
    }

    /// Whether the client lists a name at that path.
    pub(super) fn lists(&self, capability: &str, name: &str) -> bool {
        let list = self.capabilities.pointer(capability).and_then(Value::as_array);
        list.is_some_and(|list| list.iter().any(|listed| listed.as_str() == Some(name)))
    }

    /// Whether the client asks for findings itself, so that they are not sent for open documents: it must also be told
    /// when to ask again, because a file may get findings by a change of another.
    pub(super) fn pulls(&self) -> bool {
        self.has("/textDocument/diagnostic")
            && (self.has("/workspace/diagnostics/refreshSupport") || self.has("/workspace/diagnostic/refreshSupport"))
    }

    /// Takes the settings of the window, and behind them those of its folders as far as there are. Values that cannot
    /// be used are left out and returned.
    pub(super) fn configure(&mut self, sections: Vec<Value>) -> Vec<String> {
        self.sections = sections;
        let window = self.sections.first().cloned().unwrap_or_default();
        let (read, wrong) = settings::read(&window, &self.root());
        self.settings = read;
        let mut wrong: BTreeSet<String> = wrong.into_iter().collect();
        self.by_folder.clear();
        for (place, folder) in self.folders.iter().enumerate() {
            let section = self.sections.get(place + 1).filter(|section| section.is_object()).unwrap_or(&window);
            let (read, also_wrong) = settings::read(section, folder);
            wrong.extend(also_wrong);
            self.by_folder.push((folder.clone(), read.overrides));
        }
        self.good = Arc::default();
        wrong.into_iter().collect()
    }

    /// The settings for the file at `path`: those of the innermost workspace folder that holds it.
    pub(super) fn overrides(&self, path: &Path, files: &EditorFiles) -> &Overrides {
        let holds = |folder: &Path| path.starts_with(folder) || path.starts_with(files.canonical(folder));
        let within = self.by_folder.iter().filter(|(folder, _)| holds(folder));
        within.max_by_key(|(folder, _)| folder.components().count()).map_or(&self.settings.overrides, |(_, own)| own)
    }

    /// Keeps a configuration without errors.
    pub(super) fn keep_good(&self, project: &Path, settings: &Settings) {
        let mut good = self.good.lock().unwrap_or_else(PoisonError::into_inner);
        good.insert(project.to_path_buf(), settings.clone());
    }

    /// Forgets them: what was typed into a project file was not saved.
    pub(super) fn forget_good(&self) {
        self.good.lock().unwrap_or_else(PoisonError::into_inner).clear();
    }

    /// The last configuration of that project file that had no errors.
    pub(super) fn last_good(&self, project: &Path) -> Option<Settings> {
        self.good.lock().unwrap_or_else(PoisonError::into_inner).get(project).cloned()
    }

    /// Follows `workspace/didChangeWorkspaceFolders`, as [`Self::configure`] does.
    pub(super) fn change_folders(&mut self, params: &Value) -> Vec<String> {
        let folders = |list: &str| {
            let list = params.pointer(list).and_then(Value::as_array).into_iter().flatten();
            list.filter_map(|folder| folder_path(folder.get("uri")?)).collect::<Vec<_>>()
        };
        let removed = folders("/event/removed");
        self.folders.retain(|folder| !removed.contains(folder));
        self.folders.extend(folders("/event/added"));
        // The settings of folders are asked for anew.
        let window = self.sections.drain(..).take(1).collect();
        self.configure(window)
    }

    /// The root of the workspace, to which the paths in settings are relative.
    pub(super) fn root(&self) -> PathBuf {
        self.folders.first().cloned().unwrap_or_default()
    }
}

/// UTF-8 when the client offers it, UTF-16 as ever when it says nothing.
fn unit(capabilities: &Value) -> ColumnUnit {
    let offered = capabilities.pointer("/general/positionEncodings").and_then(Value::as_array);
    let offers = |name: &str| offered.is_some_and(|list| list.iter().any(|offer| offer.as_str() == Some(name)));
    if offers("utf-8") {
        ColumnUnit::Bytes
    } else if offers("utf-32") && !offers("utf-16") {
        ColumnUnit::Characters
    } else {
        ColumnUnit::Utf16
    }
}
