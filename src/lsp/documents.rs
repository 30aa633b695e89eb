//! Changes of open documents, the runs that they start, what is found in them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use gen_lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams, Range,
    TextDocumentContentChangeEvent, Uri,
};
use lsp_server::{ErrorCode, ResponseError};
use serde::Deserialize as _;
use serde_json::{Value, json};

use super::analysis::{self, Found, is_configuration};
use super::files::Document;
use super::findings::by_file;
use super::places::span;
use super::roots::{Event, Reporter, Root, Run, Waiting};
use super::server::{Refreshes, Server};
use super::texts::Text;
use super::workers::guarded;
use crate::session::Session;
use crate::text::{Loader as _, SourceText, Span};

impl Server {
    pub(super) fn did_open(&mut self, params: Value) -> Result<(), String> {
        let params: DidOpenTextDocumentParams = serde_json::from_value(params).map_err(|error| error.to_string())?;
        let document = params.text_document;
        self.files.forget();
        let path = self.files.path_of(&document.uri);
        let source = SourceText::from_text(path.to_string_lossy(), document.text);
        // Findings in this file that other documents led to were sent; from now on the client fetches them.
        if self.client.pulls()
            && let Some(uri) = self.files.uri_of(&path)
            && !self.publisher.get(&uri).1.is_empty()
        {
            self.notify("textDocument/publishDiagnostics", json!({ "uri": uri, "diagnostics": [] }));
        }
        self.checked.changed(false);
        let opened = Document { uri: document.uri, version: document.version, source: Arc::new(source) };
        self.files.open_mut().insert(path.clone(), opened);
        self.openings += 1;
        self.roots.entry(path.clone()).or_default().open(self.openings);
        self.changed(&path, true);
        Ok(())
    }

    pub(super) fn did_change(&mut self, mut params: Value) -> Result<(), String> {
        // A client that counts no versions: what it sends is the newest text all the same.
        let counts = params.pointer("/textDocument/version").is_some_and(Value::is_i64);
        if let (false, Some(document)) = (counts, params.pointer_mut("/textDocument").and_then(Value::as_object_mut)) {
            let uri = document.get("uri").and_then(Value::as_str).and_then(|uri| Uri::parse(uri).ok());
            let path = uri.map(|uri| self.files.path_of(&uri));
            let version = path.and_then(|path| self.files.buffer(&path)).map_or(0, |document| document.version);
            document.insert("version".to_owned(), version.into());
        }
        // A change of a part must not be taken for a new text.
        let changes = params.get("contentChanges").and_then(Value::as_array).into_iter().flatten();
        for range in changes.filter_map(|change| change.get("range")).filter(|range| !range.is_null()) {
            Range::deserialize(range).map_err(|error| format!("range: {error}"))?;
        }
        let params: DidChangeTextDocumentParams = serde_json::from_value(params).map_err(|error| error.to_string())?;
        let path = self.files.path_of(&params.text_document.text_document_identifier.uri);
        let unit = self.client.unit;
        if self.files.buffer(&path).is_none() {
            return Err("not open".to_owned());
        }
        // The results for the old text are dropped before the text changes: then the text has one owner and is not
        // copied.
        if let Some(root) = self.roots.get_mut(&path) {
            root.touch();
            let outdated = std::mem::take(&mut root.waiting);
            for waiting in outdated {
                self.outdated(waiting);
            }
        }
        let Some(document) = self.files.open_mut().get_mut(&path) else { return Err("not open".to_owned()) };
        let version = params.text_document.version;
        let goes_back = (version < document.version).then(|| format!("version {version} after {}", document.version));
        document.version = version;
        let source = Arc::make_mut(&mut document.source);
        for change in params.content_changes {
            let (replaced, text) = match change {
                TextDocumentContentChangeEvent::TextDocumentContentChangePartial(change) => {
                    (span(source, change.range, unit), change.text)
                }
                TextDocumentContentChangeEvent::TextDocumentContentChangeWholeDocument(change) => {
                    (Span::new(0, source.len()), change.text)
                }
            };
            source.replace(replaced, &text);
        }
        self.changed(&path, false);
        // The text is taken: without it nothing would be right from here on.
        goes_back.map_or(Ok(()), Err)
    }

    /// Answers a request whose positions are those of a text that is no more.
    fn outdated(&mut self, waiting: Waiting) {
        if waiting.method == "textDocument/diagnostic" {
            let data = Some(json!({ "retriggerRequest": true }));
            let message = "the document has changed".to_owned();
            let code = ErrorCode::ServerCancelled as i32;
            self.answer(waiting.id, Err(ResponseError { code, message, data }));
        } else {
            self.refuse(waiting.id, ErrorCode::ContentModified, "the document has changed");
        }
    }

    pub(super) fn did_close(&mut self, params: Value) -> Result<(), String> {
        let params: DidCloseTextDocumentParams = serde_json::from_value(params).map_err(|error| error.to_string())?;
        let uri = params.text_document.uri;
        let path = self.files.path_of(&uri);
        self.files.forget();
        let Some(closed) = self.files.open_mut().remove(&path) else { return Err("not open".to_owned()) };
        if is_configuration(&path)
            && !self.files.read(&path).is_ok_and(|saved| saved == closed.source.text().as_bytes())
        {
            self.client.forget_good();
        }
        self.checked.changed(false);
        if let Some(root) = self.roots.remove(&path) {
            root.cancel();
            for waiting in root.waiting {
                self.refuse(waiting.id, ErrorCode::ContentModified, "the document is closed");
            }
        }
        let touched = self.publisher.remove(&path);
        self.publish(touched);
        // What other documents found in it stays, but is sent from now on.
        self.publish(vec![uri]);
        self.changed(&path, true);
        self.serve_others(&path);
        Ok(())
    }

    /// A document at `path` changed, came or went: what was found by way of it is old.
    fn changed(&mut self, path: &Path, listed: bool) {
        let is_macrocycle = Session::is_macrocycle_name(path);
        let everywhere = is_configuration(path) || (listed && is_macrocycle);
        for (root_path, root) in &mut self.roots {
            // Which macrocycles parameters and cycles lead to is known when the run is over.
            let reads = || root.read.iter().any(|read| read == path) || is_macrocycle && !root.is_judged();
            if root_path != path && (everywhere || reads()) {
                root.touch();
                self.refreshes = Refreshes { views: true, findings: true };
            }
        }
    }

    /// Files of the disk, or settings, changed.
    pub(super) fn files_changed(&mut self) {
        self.files.forget();
        for root in self.roots.values_mut() {
            root.touch();
            self.refreshes = Refreshes { views: true, findings: true };
        }
    }

    /// Starts the runs that changes ask for.
    pub(super) fn start_analyses(&mut self) {
        for (path, root) in &mut self.roots {
            let Some((run, cancel)) = root.begin(path) else { continue };
            let (files, client, events) = (self.files.clone(), Arc::clone(&self.client), self.events.clone());
            self.analysts.run(None, move || {
                let reporter = Reporter { run: run.clone(), events: events.clone() };
                let found = guarded(|| analysis::run(run.path(), &files, &client, &cancel, &reporter));
                let _ = events.send(Event::Finished { run, found });
            });
        }
    }

    /// Takes what a thread reports.
    pub(super) fn finish(&mut self, event: Event) {
        match event {
            Event::Answered { id, result } => self.answered(id, result),
            Event::Analysed { run, analysis, read } => {
                // Open macrocycles show how this program executes them.
                let concerns = read.iter().any(|file| file != run.path() && self.roots.contains_key(file));
                if self.newest(&run).is_some() {
                    self.watch_outside(&read);
                }
                if let Some(root) = self.newest(&run) {
                    root.resolved(analysis);
                    root.read = read;
                    self.serve_waiting(run.path());
                    self.serve_others(run.path());
                    if concerns {
                        self.refreshes.views = true;
                    }
                }
            }
            Event::FoundSoFar { run, found } => {
                if self.newest(&run).is_some() {
                    self.show(run.path(), &found);
                    self.begin_progress(&run);
                }
            }
            Event::Finished { run, found } => {
                self.end_progress(&run);
                self.finished(&run, found);
            }
        }
        self.refresh();
    }

    /// Asks the client to ask again for what a change made old, once all of that is known: once for all documents.
    fn refresh(&mut self) {
        if self.everything_known() && std::mem::take(&mut self.refreshes.views) {
            self.ask_to_refresh();
        }
        if self.roots.values().all(Root::is_judged)
            && std::mem::take(&mut self.refreshes.findings)
            && self.client.pulls()
        {
            self.ask_to_pull();
        }
    }

    /// The document of a run, when nothing changed since that began.
    fn newest(&mut self, run: &Run) -> Option<&mut Root> {
        self.roots.get_mut(run.path()).filter(|root| root.is_newest(run))
    }

    fn finished(&mut self, run: &Run, found: Result<Option<Found>, String>) {
        let Some(root) = self.newest(run) else { return };
        match found {
            Ok(None) => {}
            Ok(Some(found)) => {
                let found = Arc::new(found);
                let before = std::mem::replace(&mut root.read, found.read.clone());
                root.judged(Arc::clone(&found));
                // Macrocycles that execution led to show it, too.
                let is_new = |file: &PathBuf| !before.contains(file) && self.roots.contains_key(file);
                self.refreshes.views |= found.read.iter().any(is_new);
                self.show(run.path(), &found);
                self.tell_misconfigured(run.path(), found.misconfigured);
                self.serve_waiting(run.path());
                self.serve_others(run.path());
            }
            Err(panic) => {
                root.failed();
                self.log(&format!("analysis: {panic}"));
                self.serve_waiting(run.path());
                self.serve_others(run.path());
            }
        }
    }

    /// Answers the requests of other documents that waited for this one.
    fn serve_others(&mut self, path: &Path) {
        let waiting =
            |(other, root): (&PathBuf, &Root)| (other != path && !root.waiting.is_empty()).then(|| other.clone());
        let others: Vec<PathBuf> = self.roots.iter().filter_map(waiting).collect();
        for other in others {
            self.serve_waiting(&other);
        }
    }

    /// Whether all other open documents that lead to `path` have their findings.
    pub(super) fn others_judged(&self, path: &Path) -> bool {
        let leads_here = |root: &Root| root.read.iter().any(|read| read == path);
        self.roots.iter().all(|(other, root)| other == path || root.is_judged() || !leads_here(root))
    }

    /// Whether all open documents are resolved.
    pub(super) fn everything_known(&self) -> bool {
        self.roots.values().all(Root::is_known)
    }

    /// Says once that the configuration of programs has errors; not while somebody edits it.
    fn tell_misconfigured(&mut self, path: &Path, misconfigured: bool) {
        let misconfigured = misconfigured && !is_configuration(path);
        let edited = self.roots.keys().any(|open| is_configuration(open));
        if misconfigured && !self.told_misconfigured && !edited {
            self.show_warning(&Text::Misconfigured.text(self.client.lang()));
        }
        self.told_misconfigured = misconfigured;
    }

    /// Shows what was found from one document on.
    fn show(&mut self, path: &Path, found: &Found) {
        let diagnostics = by_file(&found.report, &self.files, self.client.unit, self.client.lang());
        let own = self.files.uri_of(path);
        let mut touched = self.publisher.set(path, diagnostics);
        // The document's own findings are sent after every change, also when they are the same.
        touched.retain(|uri| Some(uri) != own.as_ref());
        touched.extend(own);
        self.publish(touched);
    }

    /// Sends the findings of files; those of open documents are fetched by clients that can.
    fn publish(&mut self, uris: Vec<Uri>) {
        for uri in uris {
            let open = self.files.open().values().find(|document| document.uri == uri);
            if open.is_some() && self.client.pulls() {
                continue;
            }
            let mut params = json!({ "uri": uri, "diagnostics": self.publisher.get(&uri).1 });
            if let (Some(document), Some(params)) = (open, params.as_object_mut()) {
                params.insert("version".to_owned(), document.version.into());
            }
            self.notify("textDocument/publishDiagnostics", params);
        }
    }

    /// The answer to `textDocument/diagnostic`.
    pub(super) fn pulled(&self, path: &Path, params: &Value) -> Value {
        let Some(document) = self.files.buffer(path) else { return json!({ "kind": "full", "items": [] }) };
        let (revision, found) = self.publisher.get(&document.uri);
        let revision = revision.to_string();
        match params.get("previousResultId").and_then(Value::as_str) {
            Some(previous) if previous == revision => json!({ "kind": "unchanged", "resultId": revision }),
            _ => json!({ "kind": "full", "resultId": revision, "items": found }),
        }
    }
}
