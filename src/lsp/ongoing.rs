//! Progress of long runs, and watchers for files outside the client's folders.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::roots::Run;
use super::server::Server;
use super::texts::Text;
use crate::text::Loader;

impl Server {
    /// A run takes long: the client shows that it goes on.
    pub(super) fn begin_progress(&mut self, run: &Run) {
        if !self.client.has("/window/workDoneProgress") || self.in_progress.iter().any(|(begun, _)| begun == run) {
            return;
        }
        self.progress_count += 1;
        let token = format!("cnc872c-{}", self.progress_count);
        self.ask("window/workDoneProgress/create", json!({ "token": token }));
        let name = run.path().file_name().map(|name| name.to_string_lossy().into_owned());
        let title = Text::Checking.text(self.client.lang());
        let value = json!({ "kind": "begin", "title": title, "message": name });
        self.notify("$/progress", json!({ "token": token, "value": value }));
        self.in_progress.push((run.clone(), token));
    }

    /// A run is over, or nobody wants it any more.
    pub(super) fn end_progress(&mut self, run: &Run) {
        if let Some(at) = self.in_progress.iter().position(|(begun, _)| begun == run) {
            let (_, token) = self.in_progress.swap_remove(at);
            self.notify("$/progress", json!({ "token": token, "value": { "kind": "end" } }));
        }
    }

    /// Registers watchers for files that were read outside the client's folders: macrocycles elsewhere, a project file
    /// above.
    pub(super) fn watch_outside(&mut self, read: &[PathBuf]) {
        if !self.client.has("/workspace/didChangeWatchedFiles/relativePatternSupport")
            || !self.client.has("/workspace/didChangeWatchedFiles/dynamicRegistration")
        {
            return;
        }
        let folders: Vec<PathBuf> = self.client.folders.iter().map(|folder| self.files.canonical(folder)).collect();
        for path in read {
            let folder = if self.files.is_folder(path) { Some(path.as_path()) } else { path.parent() };
            let outside = |folder: &&Path| !folders.iter().any(|inside| folder.starts_with(inside));
            let Some(folder) = folder.filter(outside).map(Path::to_path_buf) else { continue };
            if self.watched.insert(folder.clone()) {
                self.watch(&folder);
            }
        }
    }

    fn watch(&mut self, folder: &Path) {
        let Ok(uri) = gen_lsp_types::Uri::from_file_path(folder) else { return };
        let pattern: Value = json!({ "baseUri": uri, "pattern": "*" });
        let registration = json!({
            "id": format!("outside-{}", self.watched.len()),
            "method": "workspace/didChangeWatchedFiles",
            "registerOptions": { "watchers": [{ "globPattern": pattern }] },
        });
        self.ask("client/registerCapability", json!({ "registrations": [registration] }));
    }
}
