//! An editor that does what a script says, and looks at everything that the server answers.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use cnc872c::config::Overrides;
use cnc872c::dict::Lang;
use cnc872c::lsp::{Ended, serve};
use serde_json::{Value, json};

use crate::answers::{assert_ranges, assert_shown, edits};
use crate::client::Kind;
use crate::connection::{Input, Output, take_frame};
use crate::script::{Place, Script, Step};
use crate::world::{Disk, FILES, expected, is_configuration_faulty, is_exact, offset, path, settings};

/// Longer than any answer takes.
const PATIENCE: Duration = Duration::from_secs(60);

/// Most requests of a script that are asked of a second server too.
const MOST_COMPARED: usize = 12;

/// Every request that the server knows.
const METHODS: [&str; 28] = [
    "textDocument/hover",
    "textDocument/completion",
    "textDocument/codeAction",
    "textDocument/rename",
    "textDocument/prepareRename",
    "textDocument/references",
    "textDocument/documentHighlight",
    "textDocument/definition",
    "textDocument/declaration",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/selectionRange",
    "textDocument/semanticTokens/full",
    "textDocument/semanticTokens/range",
    "textDocument/inlayHint",
    "textDocument/codeLens",
    "textDocument/documentLink",
    "textDocument/formatting",
    "textDocument/rangeFormatting",
    "textDocument/onTypeFormatting",
    "textDocument/prepareCallHierarchy",
    "callHierarchy/incomingCalls",
    "callHierarchy/outgoingCalls",
    "codeAction/resolve",
    "workspace/symbol",
    "workspace/executeCommand",
    "workspace/textDocumentContent",
    "textDocument/diagnostic",
];

struct Document {
    version: i32,
    text: String,
}

struct Asked {
    method: &'static str,
    file: usize,
    params: Value,
    /// Of the documents, when it was asked.
    generation: u64,
    answer: Option<Value>,
}

/// An editor with its server.
pub struct Editor {
    kind: Kind,
    disk: Arc<Disk>,
    server: JoinHandle<io::Result<Ended>>,
    input: Option<Sender<Vec<u8>>>,
    output: Receiver<Vec<u8>>,
    received: Vec<u8>,
    /// A message was sent that may be anything: what the server knows is not known.
    wild: bool,
    gone: bool,
    open: BTreeMap<usize, Document>,
    /// Grows with every change of a document.
    generation: u64,
    asked: Vec<Asked>,
    by_id: BTreeMap<String, usize>,
    unanswered: BTreeSet<usize>,
    /// Answers to what is no request: those there must be, and those there are.
    refusals: (usize, usize),
    /// The settings, as the client has them and as the server took them.
    settings: u8,
    taken: u8,
    published: BTreeMap<String, Value>,
    versions: i32,
}

impl Editor {
    /// Runs the script with a fresh server.
    pub fn run(script: &Script) {
        let kind = Kind { client: script.client, way: script.way };
        let mut editor = Self::start(kind, Arc::new(Disk::new()), script.settings);
        for step in &script.steps {
            editor.step(step);
            if kind.is_steady() {
                editor.wait_for_all();
            }
        }
        if !kind.is_hasty() {
            editor.settle();
            let in_other_folders = script.steps.iter().any(|step| matches!(step, Step::Folders(_)));
            if kind.compares() && !editor.wild && !in_other_folders {
                editor.assert_as_fresh();
            }
        }
        editor.end();
    }

    fn start(kind: Kind, disk: Arc<Disk>, chosen: u8) -> Self {
        let (input, from) = channel();
        let (to, output) = channel();
        let of_server = Arc::clone(&disk);
        let server = thread::spawn(move || {
            let input = Input::new(from);
            serve(of_server, Lang::En, input, Output::new(to))
        });
        let mut editor = Self {
            kind,
            disk,
            server,
            input: Some(input),
            output,
            received: Vec::new(),
            wild: false,
            gone: false,
            open: BTreeMap::new(),
            generation: 0,
            asked: Vec::new(),
            by_id: BTreeMap::new(),
            unanswered: BTreeSet::new(),
            refusals: (0, 0),
            settings: chosen,
            taken: chosen,
            published: BTreeMap::new(),
            versions: 0,
        };
        let params = kind.initialize(&settings(chosen).0);
        editor.ask("initialize", 0, params);
        editor.wait_for_all();
        editor.notify("initialized", json!({}));
        editor
    }

    fn send(&mut self, message: &Value) {
        self.send_content(message.to_string().as_bytes());
    }

    fn send_content(&mut self, content: &[u8]) {
        let mut frame = format!("Content-Length: {}\r\n\r\n", content.len()).into_bytes();
        frame.extend_from_slice(content);
        if let Some(input) = &self.input {
            let _ = input.send(frame);
        }
    }

    fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    fn id(number: usize) -> Value {
        if number.is_multiple_of(2) { json!(1_000_000 + number) } else { json!(format!("r{number}")) }
    }

    fn ask(&mut self, method: &'static str, file: usize, params: Value) -> usize {
        let number = self.asked.len();
        let id = Self::id(number);
        let message = json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params });
        self.asked.push(Asked { method, file, params, generation: self.generation, answer: None });
        self.by_id.insert(id.to_string(), number);
        self.unanswered.insert(number);
        self.send(&message);
        number
    }

    /// Takes the next message of the server; whether there was one.
    fn receive(&mut self) -> bool {
        loop {
            if let Some(message) = take_frame(&mut self.received) {
                self.take(message);
                return true;
            }
            if self.gone {
                return false;
            }
            match self.output.recv_timeout(PATIENCE) {
                Ok(piece) => self.received.extend(piece),
                Err(RecvTimeoutError::Disconnected) => {
                    self.gone = true;
                    assert!(self.received.is_empty(), "a frame that is cut short");
                }
                Err(RecvTimeoutError::Timeout) => {
                    let methods: Vec<&str> = self.unanswered.iter().map(|at| self.asked[*at].method).collect();
                    panic!("not answered: {methods:?}");
                }
            }
        }
    }

    fn take(&mut self, message: Value) {
        let id = message.get("id").cloned();
        let Some(method) = message["method"].as_str() else {
            let id = id.unwrap_or_default();
            match self.by_id.get(&id.to_string()) {
                Some(&number) => {
                    assert!(self.unanswered.remove(&number) || self.wild, "answered twice: {message}");
                    self.assert_answer(number, &message);
                    self.asked[number].answer = Some(message);
                }
                None => self.refusals.1 += 1,
            }
            return;
        };
        match (method, id) {
            ("workspace/configuration", Some(id)) => {
                let value = settings(self.settings).0;
                self.taken = self.settings;
                self.send(&json!({ "jsonrpc": "2.0", "id": id, "result": [value] }));
            }
            (_, Some(id)) => self.send(&json!({ "jsonrpc": "2.0", "id": id, "result": null })),
            ("textDocument/publishDiagnostics", None) => {
                let uri = message["params"]["uri"].as_str().expect("a URI").to_owned();
                self.published.insert(uri, message["params"].clone());
            }
            _ => {}
        }
    }

    /// What must hold of every answer.
    fn assert_answer(&self, number: usize, answer: &Value) {
        let asked = &self.asked[number];
        let result = &answer["result"];
        if asked.method.starts_with("textDocument/semanticTokens") {
            assert_eq!(result["data"].as_array().map_or(0, Vec::len) % 5, 0, "{answer}");
        }
        assert_ranges(result);
    }

    fn wait_for_all(&mut self) {
        while !self.unanswered.is_empty() {
            if !self.receive() {
                assert!(self.wild, "the server left");
                self.unanswered.clear();
            }
        }
    }

    /// Everything that was sent is done; then the client has the findings of the files as they are.
    fn settle(&mut self) {
        // The server's own requests are answered between these two; the answers change its knowledge.
        for _ in 0..2 {
            self.ask("nonsense", 0, Value::Null);
            self.wait_for_all();
        }
        // The findings of one document may come from the run over another.
        self.pull();
        let pulled = self.pull();
        if !self.wild {
            self.assert_findings(&pulled);
        }
    }

    fn pull(&mut self) -> BTreeMap<usize, Value> {
        let files: Vec<usize> = self.open.keys().copied().collect();
        let asked: Vec<(usize, usize)> = files
            .into_iter()
            .map(|file| (file, self.ask("textDocument/diagnostic", file, document(file, json!({})))))
            .collect();
        self.wait_for_all();
        asked.into_iter().map(|(file, number)| (file, self.asked[number].answer.clone().unwrap_or_default())).collect()
    }

    fn step(&mut self, step: &Step) {
        match step {
            Step::Open(file, text) => self.open_document(*file, text),
            Step::Change(file, changes) => self.change(*file, changes),
            Step::Close(file) => {
                self.generation += 1;
                self.open.remove(file);
                self.notify("textDocument/didClose", document(*file, json!({})));
            }
            Step::Save(file) => {
                if let Some(document) = self.open.get(file) {
                    self.disk.set(&path(*file, self.kind.rooted()), Some(document.text.clone().into_bytes()));
                }
                self.notify("textDocument/didSave", document(*file, json!({})));
                self.watched(*file);
            }
            Step::Disk(file, bytes) => {
                self.disk.set(&path(*file, self.kind.rooted()), bytes.clone());
                self.watched(*file);
            }
            Step::Settings(chosen) => {
                self.settings = *chosen;
                if !self.kind.configures() {
                    self.taken = *chosen;
                }
                let value = settings(*chosen).0;
                self.notify("workspace/didChangeConfiguration", json!({ "settings": { "cnc872c": value } }));
            }
            Step::Folders(bits) => {
                let folders = ["file:///w", "file:///w/m", "file:///", "nonsense"];
                let some = |bits: u8| -> Vec<Value> {
                    let chosen = folders.iter().enumerate().filter(|(at, _)| bits & (1 << at) != 0);
                    chosen.map(|(_, uri)| json!({ "uri": uri, "name": uri })).collect()
                };
                let event = json!({ "event": { "added": some(*bits), "removed": some(bits >> 4) } });
                self.notify("workspace/didChangeWorkspaceFolders", event);
            }
            Step::Request { method, file, from, to, extra, text } => {
                let method = METHODS[usize::from(*method) % METHODS.len()];
                let params = self.params(method, *file, *from, *to, *extra, text);
                self.ask(method, *file, params);
            }
            Step::Cancel(back) => {
                let Some(number) = self.asked.len().checked_sub(1 + usize::from(back % 8)) else { return };
                self.notify("$/cancelRequest", json!({ "id": Self::id(number) }));
            }
            Step::Settle => self.settle(),
            Step::Apply(which) => self.apply(*which),
            Step::Content(content) => {
                match serde_json::from_slice::<Value>(content) {
                    Ok(Value::Object(message))
                        if ["method", "result", "error"].iter().any(|key| message.contains_key(*key)) =>
                    {
                        self.wild = true;
                    }
                    Ok(Value::Object(message))
                        if message.get("id").is_some_and(|id| self.by_id.contains_key(&id.to_string())) =>
                    {
                        self.wild = true;
                    }
                    _ => self.refusals.0 += 1,
                }
                self.send_content(content);
            }
        }
    }

    fn watched(&mut self, file: usize) {
        let changes = json!([{ "uri": FILES[file].1, "type": 2 }]);
        self.notify("workspace/didChangeWatchedFiles", json!({ "changes": changes }));
    }

    fn open_document(&mut self, file: usize, text: &str) {
        self.generation += 1;
        self.versions += 1;
        let version = self.versions;
        self.open.insert(file, Document { version, text: text.to_owned() });
        let document = json!({ "uri": FILES[file].1, "languageId": "cnc872", "version": version, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": document }));
    }

    fn change(&mut self, file: usize, changes: &[(Option<(Place, Place)>, String)]) {
        self.generation += 1;
        self.versions += 1;
        let unit = self.kind.unit();
        if let Some(document) = self.open.get_mut(&file) {
            document.version = self.versions;
            for (range, new) in changes {
                let text = &mut document.text;
                let (from, to) = range.map_or((0, text.len()), |(from, to)| {
                    let from = offset(text, from.0, from.1, unit);
                    (from, offset(text, to.0, to.1, unit).max(from))
                });
                text.replace_range(from..to, new);
            }
        }
        let sent = |(range, text): &(Option<(Place, Place)>, String)| match range {
            Some((from, to)) => json!({ "range": { "start": place(*from), "end": place(*to) }, "text": text }),
            None => json!({ "text": text }),
        };
        let changes: Vec<Value> = changes.iter().map(sent).collect();
        let document = json!({ "uri": FILES[file].1, "version": self.versions });
        self.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    /// The last answer to a request of one of the methods, when no document changed since.
    fn last(&self, methods: &[&str]) -> Option<(usize, Value)> {
        let asked = self.asked.iter().rev().take_while(|asked| asked.generation == self.generation);
        let mut wanted = asked.filter(|asked| methods.contains(&asked.method));
        wanted.find_map(|asked| Some((asked.file, asked.answer.as_ref()?.get("result")?.clone())))
    }

    fn params(&self, method: &str, file: usize, from: Place, to: Place, extra: u8, text: &str) -> Value {
        let range = json!({ "start": place(from), "end": place(to) });
        let uri = FILES[file].1;
        let which = usize::from(extra);
        let nth = |list: &Value| {
            let list = list.as_array().filter(|list| !list.is_empty())?;
            list.get(which % list.len()).cloned()
        };
        match method {
            "callHierarchy/incomingCalls" | "callHierarchy/outgoingCalls" => {
                let prepared = self.last(&["textDocument/prepareCallHierarchy"]).and_then(|(_, items)| nth(&items));
                let related = self.last(&["callHierarchy/incomingCalls", "callHierarchy/outgoingCalls"]);
                let related = related.and_then(|(_, calls)| nth(&calls));
                let related = related.and_then(|call| call.get("from").or(call.get("to")).cloned());
                let made = json!({
                    "name": text, "kind": 12, "uri": uri, "range": range, "selectionRange": range, "data": extra,
                });
                json!({ "item": if extra & 0x80 == 0 { prepared } else { related }.unwrap_or(made) })
            }
            "codeAction/resolve" => {
                let offered = self.last(&["textDocument/codeAction"]).and_then(|(_, actions)| nth(&actions));
                let data = json!({ "uri": uri, "version": self.versions });
                offered.unwrap_or_else(|| json!({ "title": text, "kind": "source.renumber.cnc872c", "data": data }))
            }
            "workspace/symbol" => json!({ "query": text }),
            "workspace/executeCommand" => {
                let command = if extra == 255 { text } else { "cnc872c.stream" };
                json!({ "command": command, "arguments": [uri] })
            }
            "workspace/textDocumentContent" => {
                let uri =
                    if extra < 128 { "cnc872c:/explain/cs/E0307.md".to_owned() } else { format!("cnc872c:{text}") };
                json!({ "uri": uri })
            }
            _ => {
                let kinds = [json!(["quickfix"]), json!(["source.fixAll"]), json!(["source"]), Value::Null];
                document(
                    file,
                    json!({
                        "position": place(from),
                        "range": range,
                        "positions": [place(from), place(to)],
                        "newName": text,
                        "ch": "\n",
                        "options": { "tabSize": 4, "insertSpaces": true },
                        "previousResultId": text,
                        "context": {
                            "includeDeclaration": extra & 1 != 0,
                            "diagnostics": [],
                            "only": kinds[which % kinds.len()],
                            "triggerKind": 1 + (extra >> 7),
                        },
                    }),
                )
            }
        }
    }

    /// Does the edit of the last answer, when it is one of the texts as they are now.
    fn apply(&mut self, which: u8) {
        self.wait_for_all();
        let edited = [
            "textDocument/codeAction",
            "codeAction/resolve",
            "textDocument/rename",
            "textDocument/formatting",
            "textDocument/rangeFormatting",
            "textDocument/onTypeFormatting",
            "textDocument/completion",
        ];
        let Some((file, result)) = self.last(&edited).filter(|_| !self.wild) else { return };
        for (uri, version, edits) in edits(FILES[file].1, &result, usize::from(which)) {
            let file = FILES.iter().position(|(_, known)| *known == uri);
            let Some(document) = file.and_then(|file| self.open.get(&file)) else { continue };
            assert!(version.is_none_or(|version| version == i64::from(document.version)), "{result}");
            let unit = self.kind.unit();
            let number = |at: &Value| at.as_u64().expect("a number");
            let mut changes: Vec<(Place, Place, String)> = edits
                .iter()
                .map(|edit| {
                    let at =
                        |end: &str| (number(&edit["range"][end]["line"]), number(&edit["range"][end]["character"]));
                    (at("start"), at("end"), edit["newText"].as_str().expect("a text").to_owned())
                })
                .collect();
            for (from, to, _) in &changes {
                assert!(from <= to, "{result}");
                for at in [from, to] {
                    assert!(is_exact(&document.text, at.0, at.1, unit), "{at:?} of {:?}: {result}", document.text);
                }
            }
            changes.sort();
            assert!(changes.windows(2).all(|pair| pair[0].1 <= pair[1].0), "edits overlap: {result}");
            let changes: Vec<_> = changes.into_iter().rev().map(|(from, to, text)| (Some((from, to)), text)).collect();
            if let (Some(file), false) = (file, changes.is_empty()) {
                self.change(file, &changes);
            }
        }
    }

    /// The findings that the client has are those of the files as they are.
    fn assert_findings(&self, pulled: &BTreeMap<usize, Value>) {
        assert_eq!(self.refusals.0, self.refusals.1, "refusals");
        let (kind, rooted) = (self.kind, self.kind.rooted());
        let open = self.open.iter().map(|(file, document)| (path(*file, rooted), document.text.clone())).collect();
        let (_, overrides, lang): (_, Overrides, _) = settings(self.taken);
        if is_configuration_faulty(&self.disk, &open, &overrides) {
            return;
        }
        let found = expected(&self.disk, &open, &overrides, kind.unit(), lang.unwrap_or(kind.locale()));
        for (file, (_, uri)) in FILES.iter().enumerate() {
            let expected = found.get(&path(file, rooted)).map(Vec::as_slice).unwrap_or_default();
            let published = self.published.get(*uri);
            if let Some(document) = self.open.get(&file) {
                let answer = &pulled[&file];
                let items = answer["result"]["items"].as_array().unwrap_or_else(|| panic!("{uri}: {answer}"));
                assert_shown(uri, &document.text, items, expected);
                if kind.pulls() {
                    continue;
                }
                let published = published.unwrap_or_else(|| panic!("{uri}: nothing published"));
                assert_eq!(published["version"], document.version, "{uri}");
                assert_eq!(published["diagnostics"], answer["result"]["items"], "{uri}");
            } else {
                let items = published.and_then(|published| published["diagnostics"].as_array());
                assert_shown(uri, "", items.map(Vec::as_slice).unwrap_or_default(), expected);
            }
        }
    }

    /// Compares with the answers of a server that sees the documents for the first time.
    fn assert_as_fresh(&mut self) {
        let mut fresh = Self::start(self.kind, Arc::clone(&self.disk), self.taken);
        for (file, document) in &self.open {
            fresh.versions = document.version - 1;
            fresh.open_document(*file, &document.text);
        }
        fresh.settle();
        let again = |asked: &&Asked| METHODS.contains(&asked.method) && asked.method != "textDocument/diagnostic";
        let again = self.asked.iter().filter(again).take(MOST_COMPARED);
        let again: Vec<_> = again.map(|asked| (asked.method, asked.file, asked.params.clone())).collect();
        let (ours, theirs) = (self.views(&again), fresh.views(&again));
        for (ours, theirs) in ours.into_iter().zip(theirs) {
            assert_eq!(ours, theirs);
        }
        fresh.end();
    }

    /// The answers to these requests, and about every open document.
    fn views(&mut self, requests: &[(&'static str, usize, Value)]) -> Vec<(&'static str, usize, Value)> {
        let text = ["textDocument/semanticTokens/full", "textDocument/documentSymbol", "textDocument/foldingRange"];
        let programs = ["textDocument/inlayHint", "textDocument/codeLens", "textDocument/documentLink"];
        let files: Vec<usize> = self.open.keys().copied().collect();
        let range = json!({ "start": place((0, 0)), "end": place((1 << 20, 0)) });
        let about_all = |methods: [&'static str; 3]| -> Vec<_> {
            let each = methods.into_iter().flat_map(|method| files.iter().map(move |file| (method, *file)));
            each.map(|(method, file)| (method, file, document(file, json!({ "range": range })))).collect()
        };
        let (first, mut second) = (about_all(text), about_all(programs));
        second.extend_from_slice(requests);
        let mut views = Vec::new();
        // The second kind depends on all documents.
        for requests in [first, second] {
            let asked: Vec<usize> =
                requests.into_iter().map(|(method, file, params)| self.ask(method, file, params)).collect();
            self.wait_for_all();
            views.extend(asked.into_iter().map(|number| {
                let Asked { method, file, answer, .. } = &self.asked[number];
                let mut answer = answer.clone().unwrap_or_default();
                answer["id"] = Value::Null;
                (*method, *file, answer)
            }));
        }
        views
    }

    /// Leaves, and looks at how the server does.
    fn end(mut self) {
        let way = self.kind.way & 3;
        if way < 2 {
            self.ask("shutdown", 0, Value::Null);
        }
        if way < 3 {
            self.notify("exit", Value::Null);
        }
        self.input = None;
        // A hasty client gets no answers to what was not done.
        while self.receive() {}
        let ended = self.server.join().expect("the server ends").expect("threads");
        let orderly = if way < 2 { Ended::Orderly } else { Ended::Abruptly };
        assert!(ended == orderly || self.wild, "{ended:?}");
    }
}

fn place((line, character): Place) -> Value {
    json!({ "line": line, "character": character })
}

/// Parameters about a document.
fn document(file: usize, mut params: Value) -> Value {
    params["textDocument"] = json!({ "uri": FILES[file].1 });
    params
}
