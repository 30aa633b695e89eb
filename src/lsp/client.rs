//! What the client can do and wants.

use std::path::PathBuf;

use serde_json::Value;

use super::settings::{ClientSettings, folder_path, workspace_folders};
use crate::dict::Lang;
use crate::text::ColumnUnit;

/// What is known of the client since `initialize`, and its settings now.
#[derive(Clone, Debug, Default)]
pub(super) struct Client {
    capabilities: Value,
    /// What columns count.
    pub(super) unit: ColumnUnit,
    /// By its locale.
    locale: Lang,
    /// By the settings.
    pub(super) settings: ClientSettings,
    /// The folders of the workspace.
    pub(super) folders: Vec<PathBuf>,
}

impl Client {
    /// From the parameters of `initialize`; `lang` when the client names no locale.
    pub(super) fn new(initialize: &Value, lang: Lang) -> Self {
        let capabilities = initialize.get("capabilities").cloned().unwrap_or_default();
        let locale = initialize.get("locale").and_then(Value::as_str).map_or(lang, |locale| {
            let language = locale.split(['-', '_', '.']).next().unwrap_or_default();
            if language.eq_ignore_ascii_case("cs") { Lang::Cs } else { Lang::En }
        });
        Self {
            unit: unit(&capabilities),
            locale,
            settings: ClientSettings::default(),
            folders: workspace_folders(initialize),
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

    /// Whether the client asks for findings itself, so that they are not sent for open documents: it must also be told
    /// when to ask again, because a file may get findings by a change of another.
    pub(super) fn pulls(&self) -> bool {
        self.has("/textDocument/diagnostic")
            && (self.has("/workspace/diagnostics/refreshSupport") || self.has("/workspace/diagnostic/refreshSupport"))
    }

    /// Follows `workspace/didChangeWorkspaceFolders`.
    pub(super) fn change_folders(&mut self, params: &Value) {
        let folders = |list: &str| {
            let list = params.pointer(list).and_then(Value::as_array).into_iter().flatten();
            list.filter_map(|folder| folder_path(folder.get("uri")?)).collect::<Vec<_>>()
        };
        let removed = folders("/event/removed");
        self.folders.retain(|folder| !removed.contains(folder));
        self.folders.extend(folders("/event/added"));
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
