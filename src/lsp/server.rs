//! The server's one thread that listens: it keeps the documents, starts work in other threads, and answers.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, BufRead, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;

use crossbeam_channel::{Receiver, Sender, bounded, select, unbounded};
use gen_lsp_types::Uri;
use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response, ResponseError};
use serde_json::{Value, json};

use super::analysis::is_configuration;
use super::checked::Checked;
use super::client::Client;
use super::files::{Disk, EditorFiles};
use super::publisher::Publisher;
use super::requests::handler;
use super::roots::{Event, Root, Run, Waiting};
use super::snapshot::{Needs, Snapshot};
use super::texts::Text;
use super::transport::{self, Incoming, Outgoing};
use super::workers::{Workers, guarded};
use super::{capabilities, settings};
use crate::dict::Lang;
use crate::query::cancel::Cancel;
use crate::session::Session;

/// Messages that wait between the reading thread and this one: then reading waits.
const QUEUE: usize = 64;
/// Threads for analyses, and as many for requests: a long analysis keeps no request waiting.
const THREADS: usize = 2;

/// How the server ended.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Ended {
    /// By `shutdown` and `exit`.
    Orderly,
    /// By `exit` alone, or the client was gone.
    Abruptly,
}

/// Serves a client that writes to `input` and reads `output`, until it leaves. `disk` is where files are that the
/// client has not open; `lang` is for clients that name no locale.
///
/// # Errors
/// When threads cannot be started.
pub fn serve(
    disk: Disk,
    lang: Lang,
    input: impl BufRead + Send + 'static,
    output: impl Write + Send + 'static,
) -> io::Result<Ended> {
    let (into, incoming) = bounded(QUEUE);
    let (outgoing, out) = unbounded();
    thread::Builder::new().name("reader".to_owned()).spawn(move || read_all(input, &into))?;
    let writer = thread::Builder::new().name("writer".to_owned()).spawn(move || write_all(output, &out))?;
    let ended = Server::new(disk, lang, outgoing)?.run(&incoming);
    // The server is dropped: the writer writes what is left, and ends.
    let _ = writer.join();
    Ok(ended)
}

fn read_all(mut input: impl BufRead, into: &Sender<Incoming>) {
    while let Ok(Some(incoming)) = transport::read(&mut input) {
        if into.send(incoming).is_err() {
            return;
        }
    }
}

fn write_all(mut output: impl Write, out: &Receiver<Outgoing>) {
    for outgoing in out {
        if transport::write(&mut output, outgoing).is_err() {
            return;
        }
    }
}

/// Where the client is in its life.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
enum Stage {
    Fresh,
    Running,
    ShutDown,
}

/// The requests that the client should repeat, collected until all effects of a change are known.
#[derive(Debug, Default)]
pub(super) struct Refreshes {
    /// Hints and lenses are old.
    pub(super) views: bool,
    pub(super) findings: bool,
}

/// Whether files changed that programs depend on, and not only programs.
fn concerns_programs(params: &Value) -> bool {
    let changes = params.get("changes").and_then(Value::as_array).into_iter().flatten();
    let paths = changes.filter_map(|change| Uri::parse(change.get("uri")?.as_str()?).ok()?.to_file_path().ok());
    paths.into_iter().any(|path| is_configuration(&path) || Session::is_macrocycle_name(&path))
}

/// The state of the server.
#[derive(Debug)]
pub(super) struct Server {
    stage: Stage,
    pub(super) client: Arc<Client>,
    lang: Lang,
    pub(super) files: EditorFiles,
    /// By the canonical path of the open document.
    pub(super) roots: BTreeMap<PathBuf, Root>,
    /// How many documents were opened.
    pub(super) openings: u64,
    pub(super) publisher: Publisher,
    pub(super) refreshes: Refreshes,
    /// Programs that are not open.
    pub(super) checked: Checked,
    /// Requests not answered yet: the client may cancel them.
    pending: BTreeMap<RequestId, Cancel>,
    /// Requests for the settings.
    settings_asked: BTreeSet<RequestId>,
    asked_count: i32,
    outgoing: Sender<Outgoing>,
    pub(super) events: Sender<Event>,
    finished: Receiver<Event>,
    pub(super) analysts: Workers,
    helpers: Workers,
    /// Runs whose progress the client shows, with their tokens.
    pub(super) in_progress: Vec<(Run, String)>,
    pub(super) progress_count: u64,
    /// Folders outside of the workspace that the client watches.
    pub(super) watched: BTreeSet<PathBuf>,
    /// Whether the client was told that its configuration has errors.
    pub(super) told_misconfigured: bool,
}

impl Server {
    fn new(disk: Disk, lang: Lang, outgoing: Sender<Outgoing>) -> io::Result<Self> {
        let (events, finished) = unbounded();
        Ok(Self {
            stage: Stage::Fresh,
            client: Arc::default(),
            lang,
            files: EditorFiles::new(disk),
            roots: BTreeMap::new(),
            openings: 0,
            publisher: Publisher::default(),
            refreshes: Refreshes::default(),
            checked: Checked::default(),
            pending: BTreeMap::new(),
            settings_asked: BTreeSet::new(),
            asked_count: 0,
            outgoing,
            events,
            finished,
            analysts: Workers::new("analysis", THREADS)?,
            // More: neither checking all programs of the workspace nor executing one keeps other requests waiting.
            helpers: Workers::new("request", THREADS + 2)?,
            in_progress: Vec::new(),
            progress_count: 0,
            watched: BTreeSet::new(),
            told_misconfigured: false,
        })
    }

    fn run(mut self, incoming: &Receiver<Incoming>) -> Ended {
        let finished = self.finished.clone();
        loop {
            let step = select! {
                recv(incoming) -> message => match message {
                    Ok(Incoming::Message(Message::Notification(note))) if note.method == "exit" => {
                        return if self.stage == Stage::ShutDown { Ended::Orderly } else { Ended::Abruptly };
                    }
                    Ok(incoming) => guarded(|| self.receive(incoming)),
                    Err(_) => return Ended::Abruptly,
                },
                recv(finished) -> event => match event {
                    Ok(event) => guarded(|| self.finish(event)),
                    Err(_) => return Ended::Abruptly,
                },
            };
            if let Err(panic) = step {
                self.log(&panic);
            }
            // Of several changes that came at once, only the last is looked at.
            if incoming.is_empty() {
                self.start_analyses();
            }
        }
    }

    fn receive(&mut self, incoming: Incoming) {
        match incoming {
            Incoming::Message(Message::Request(request)) => self.request(request),
            Incoming::Message(Message::Notification(note)) => self.notification(note),
            Incoming::Message(Message::Response(response)) => self.response(response),
            Incoming::Malformed { id, code, message } => {
                let _ = self.outgoing.send(Outgoing::refusal(&id, code, &message));
            }
        }
    }

    fn request(&mut self, request: Request) {
        let Request { id, method, params } = request;
        match (self.stage, method.as_str()) {
            (Stage::Fresh, "initialize") => self.initialize(id, &params),
            (Stage::Fresh, _) => self.refuse(id, ErrorCode::ServerNotInitialized, "initialize comes first"),
            (Stage::Running, "shutdown") => {
                self.stage = Stage::ShutDown;
                self.answer(id, Ok(Value::Null));
            }
            (Stage::Running, "initialize") => self.refuse(id, ErrorCode::InvalidRequest, "initialized already"),
            (Stage::ShutDown, _) => self.refuse(id, ErrorCode::InvalidRequest, "the server is shut down"),
            (Stage::Running, _) if self.pending.contains_key(&id) => {
                self.refuse(id, ErrorCode::InvalidRequest, "a request of this id is not answered yet");
            }
            (Stage::Running, "textDocument/diagnostic") => self.queue(id, method, params, Needs::Findings),
            (Stage::Running, _) => match handler(&method) {
                Some(handler) => self.queue(id, method, params, handler.needs),
                None => self.refuse(id, ErrorCode::MethodNotFound, &format!("unknown request {method}")),
            },
        }
    }

    fn initialize(&mut self, id: RequestId, params: &Value) {
        let mut client = Client::new(params, self.lang);
        let options = params.get("initializationOptions").cloned().unwrap_or_default();
        let wrong = client.configure(vec![options]);
        let capabilities = capabilities::capabilities(&client);
        self.client = Arc::new(client);
        self.files.set_root(self.client.root());
        self.stage = Stage::Running;
        let result = json!({
            "capabilities": capabilities,
            "serverInfo": { "name": "cnc872c", "version": env!("CARGO_PKG_VERSION") },
        });
        self.answer(id, Ok(result));
        self.complain(&wrong);
    }

    fn notification(&mut self, note: Notification) {
        let Notification { method, params } = note;
        if self.stage != Stage::Running {
            return;
        }
        match method.as_str() {
            "initialized" => {
                if self.client.has("/workspace/didChangeWatchedFiles/dynamicRegistration") {
                    self.ask("client/registerCapability", capabilities::registrations());
                }
                self.ask_settings();
            }
            "$/cancelRequest" => self.cancel(&params),
            "workspace/didChangeConfiguration" => {
                if self.client.has("/workspace/configuration") {
                    self.ask_settings();
                } else if let Some(section) = params.pointer("/settings/cnc872c") {
                    self.set_settings(vec![section.clone()]);
                }
            }
            "workspace/didChangeWatchedFiles" => {
                self.checked.changed(concerns_programs(&params));
                self.files_changed();
            }
            "workspace/didChangeWorkspaceFolders" => {
                let wrong = Arc::make_mut(&mut self.client).change_folders(&params);
                self.complain(&wrong);
                self.files.set_root(self.client.root());
                self.checked.changed(true);
                self.files_changed();
                self.ask_settings();
            }
            // A client that watches no files still reports the ones it saves.
            "textDocument/didSave" if !self.client.has("/workspace/didChangeWatchedFiles/dynamicRegistration") => {
                self.files_changed();
            }
            "textDocument/didOpen" => self.documented(&method, |server| server.did_open(params)),
            "textDocument/didChange" => self.documented(&method, |server| server.did_change(params)),
            "textDocument/didClose" => self.documented(&method, |server| server.did_close(params)),
            _ => {}
        }
    }

    /// Runs the handler of a notification about a document; one that makes no sense is named in the client's log.
    fn documented(&mut self, method: &str, handle: impl FnOnce(&mut Self) -> Result<(), String>) {
        if let Err(message) = handle(self) {
            self.log(&format!("{method}: {message}"));
        }
    }

    fn response(&mut self, response: Response) {
        if self.settings_asked.remove(&response.id)
            && let Ok(Value::Array(sections)) = response.response_result
        {
            self.set_settings(sections);
        }
    }

    /// Asks for the settings of the window, then of each folder: two folders may be two machines.
    fn ask_settings(&mut self) {
        if self.client.has("/workspace/configuration") {
            let folders = self.client.folders.iter().filter_map(|folder| Uri::from_file_path(folder).ok());
            let scoped = folders.map(|uri| json!({ "scopeUri": uri, "section": settings::SECTION }));
            let items: Vec<Value> = std::iter::once(json!({ "section": settings::SECTION })).chain(scoped).collect();
            let id = self.ask("workspace/configuration", json!({ "items": items }));
            self.settings_asked.insert(id);
        }
    }

    /// Takes the settings of the window, and behind them those of its folders.
    fn set_settings(&mut self, sections: Vec<Value>) {
        if !sections.first().is_some_and(Value::is_object) {
            return;
        }
        let wrong = Arc::make_mut(&mut self.client).configure(sections);
        self.complain(&wrong);
        self.checked.changed(true);
        self.files_changed();
    }

    fn complain(&mut self, wrong: &[String]) {
        if !wrong.is_empty() {
            let text = Text::Settings { wrong: wrong.join(", ") };
            self.show_warning(&text.text(self.client.lang()));
        }
    }

    fn cancel(&mut self, params: &Value) {
        let Some(id) = params.get("id").and_then(|id| serde_json::from_value::<RequestId>(id.clone()).ok()) else {
            return;
        };
        if self.pending.contains_key(&id) {
            for root in self.roots.values_mut() {
                root.waiting.retain(|waiting| waiting.id != id);
            }
            self.refuse(id, ErrorCode::RequestCanceled, "cancelled");
        }
    }

    /// Answers a request when what it needs is known.
    fn queue(&mut self, id: RequestId, method: String, params: Value, needs: Needs) {
        self.pending.insert(id.clone(), Cancel::default());
        let waiting = Waiting { id, method, params, needs };
        if needs == Needs::Nothing {
            self.start(waiting, None);
            return;
        }
        let uri = ["/textDocument/uri", "/item/uri", "/data/uri"]
            .into_iter()
            .find_map(|at| waiting.params.pointer(at)?.as_str());
        let path = uri.and_then(|uri| Uri::parse(uri).ok()).map(|uri| self.files.path_of(&uri));
        match path.filter(|path| self.roots.contains_key(path)) {
            Some(path) => {
                if let Some(root) = self.roots.get_mut(&path) {
                    root.waiting.push(waiting);
                }
                self.serve_waiting(&path);
            }
            // A macrocycle that is not open, reached from a program that is: call hierarchies go there.
            None if waiting.method.starts_with("callHierarchy/") => self.start(waiting, None),
            None => self.refuse(waiting.id, ErrorCode::InvalidParams, "this document is not open"),
        }
    }

    /// Answers the requests of a document that have what they need.
    pub(super) fn serve_waiting(&mut self, path: &Path) {
        let (everything, judged) = (self.everything_known(), self.others_judged(path));
        let Some(root) = self.roots.get_mut(path) else { return };
        let ready = root.take_ready(everything, judged);
        for waiting in ready {
            if waiting.method == "textDocument/diagnostic" {
                let result = self.pulled(path, &waiting.params);
                self.answer(waiting.id, Ok(result));
            } else {
                self.start(waiting, Some(path));
            }
        }
    }

    /// Runs the handler of a request in a thread.
    fn start(&mut self, waiting: Waiting, path: Option<&Path>) {
        let Waiting { id, method, params, needs } = waiting;
        let (Some(handler), Some(cancel)) = (handler(&method), self.pending.get(&id).cloned()) else { return };
        let root = path.and_then(|path| self.roots.get(path));
        let snapshot = Snapshot {
            client: Arc::clone(&self.client),
            files: self.files.clone(),
            analysis: root.and_then(Root::analysis).cloned(),
            found: root.and_then(Root::found).cloned(),
            analyses: self.roots.values().filter_map(Root::analysis).cloned().collect(),
            checked: self.checked.clone(),
            cancel,
        };
        let events = self.events.clone();
        // However many requests ask for the execution of one program, they keep those of others waiting no longer than
        // two do.
        let executes = matches!(needs, Needs::Blocks | Needs::Run);
        let lane = path.filter(|_| executes).map(|path| (path.to_path_buf(), needs));
        self.helpers.run(lane, move || {
            if snapshot.cancel.is_cancelled() {
                return;
            }
            let result = match guarded(|| (handler.run)(&snapshot, params)) {
                Ok(result) => result.map_err(ResponseError::from),
                Err(panic) => {
                    let message = format!("{method}: {panic}");
                    Err(ResponseError { code: ErrorCode::InternalError as i32, message, data: None })
                }
            };
            // Without a listener the server is at its end.
            let _ = events.send(Event::Answered { id, result });
        });
    }

    /// Sends the answer to a request, unless it has one.
    pub(super) fn answer(&mut self, id: RequestId, result: Result<Value, ResponseError>) {
        self.pending.remove(&id);
        self.send(Response { id, response_result: result });
    }

    /// The answer of a thread: nothing, when the request was cancelled in between.
    pub(super) fn answered(&mut self, id: RequestId, result: Result<String, ResponseError>) {
        match result {
            _ if !self.pending.contains_key(&id) => {}
            Err(error) => self.answer(id, Err(error)),
            Ok(result) => {
                self.pending.remove(&id);
                let _ = self.outgoing.send(Outgoing::Result { id, result });
            }
        }
    }

    pub(super) fn refuse(&mut self, id: RequestId, code: ErrorCode, message: &str) {
        if let Some(cancel) = self.pending.get(&id) {
            cancel.cancel();
        }
        self.answer(id, Err(ResponseError { code: code as i32, message: message.to_owned(), data: None }));
    }

    /// Asks the client; gives the request, for an answer that matters.
    pub(super) fn ask(&mut self, method: &str, params: Value) -> RequestId {
        self.asked_count += 1;
        let id = RequestId::from(self.asked_count);
        self.send(Request { id: id.clone(), method: method.to_owned(), params });
        id
    }

    /// Asks the client to ask for findings again.
    pub(super) fn ask_to_pull(&mut self) {
        self.ask("workspace/diagnostic/refresh", Value::Null);
    }

    /// Asks the client to ask again for what is shown between the lines.
    pub(super) fn ask_to_refresh(&mut self) {
        for (what, method) in [("inlayHint", "workspace/inlayHint/refresh"), ("codeLens", "workspace/codeLens/refresh")]
        {
            if self.client.has(&format!("/workspace/{what}/refreshSupport")) {
                self.ask(method, Value::Null);
            }
        }
    }

    pub(super) fn notify(&self, method: &str, params: Value) {
        self.send(Notification { method: method.to_owned(), params });
    }

    fn send(&self, message: impl Into<Message>) {
        // Without a writer the client is gone; the reader will say so.
        let _ = self.outgoing.send(Outgoing::Message(message.into()));
    }

    pub(super) fn log(&self, message: &str) {
        self.notify("window/logMessage", json!({ "type": 1, "message": message }));
    }

    pub(super) fn show_warning(&self, message: &str) {
        self.notify("window/showMessage", json!({ "type": 2, "message": message }));
    }
}
