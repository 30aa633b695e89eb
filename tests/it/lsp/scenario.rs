//! Scenarios: what a client does, and what it must get, one file each in `tests/lsp`.
//!
//! A scenario is a text of sections. Each begins with a line `=== verb argument…`; what follows up to the next such
//! line is its body:
//!
//! | section | does | body |
//! |---|---|---|
//! | `client` | initializes; first, and optional | parameters of `initialize`, JSON |
//! | `file NAME` | writes a file into the scenario's folder | its text |
//! | `open NAME` | opens a document, also one that is no file yet | its text, with marks |
//! | `replace NAME A B` | replaces the text between two marks | the new text |
//! | `text NAME` | replaces the whole text | the new text, with marks |
//! | `close NAME` | closes a document | |
//! | `notify METHOD` | sends a notification | its parameters |
//! | `findings NAME` | waits for the findings of the newest version, or of a file that is not open | a line each |
//! | `request METHOD [NAME[@MARK[..MARK]]]` | sends a request about a document, a place, a range | more parameters |
//! | `answer` | | the answer |
//! | `edited` | applies the `WorkspaceEdit`, `TextEdit`s or first code action of the last answer to the open texts | the text of each document |
//! | `said METHOD` | waits for a message of the server | its parameters |
//!
//! A mark is `‹1›`; it is taken out of the text, also of `file`s, and names a place: in the text as it was opened.
//! `DIR/` in JSON is the URI of the folder, with which all names begin. Of packed `data` and of a `page` an answer
//! shows only that it is some. Lines of `#` before the first section are a comment. `LSP=write cargo test --test it
//! lsp` writes what comes into `findings`, `answer`, `edited` and `said`.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;

use serde_json::{Value, json};
use tempfile::TempDir;

use super::Client;
use crate::cli::write_older;
use crate::samples::root;

/// Runs every scenario; reports all failures together.
pub fn run_all() {
    let mut paths: Vec<_> =
        fs::read_dir(root().join("tests/lsp")).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    assert!(!paths.is_empty());
    let write = std::env::var_os("LSP").is_some_and(|value| value == "write");
    let mut wrong = String::new();
    for path in paths {
        let text = fs::read_to_string(&path).unwrap();
        let got = Scenario::run(&text);
        if got == text {
            continue;
        }
        if write {
            fs::write(&path, got).unwrap();
        } else {
            let _ = writeln!(wrong, "{}:\n{}", path.display(), difference(&text, &got));
        }
    }
    assert!(wrong.is_empty(), "{wrong}\nAfter looking: LSP=write cargo test --test it lsp");
}

fn difference(expected: &str, got: &str) -> String {
    let same = expected.lines().zip(got.lines()).take_while(|(a, b)| a == b).count();
    let piece = |text: &str| text.lines().skip(same.saturating_sub(2)).take(14).collect::<Vec<_>>().join("\n");
    format!("line {}: expected\n{}\ngot\n{}", same + 1, piece(expected), piece(got))
}

struct Scenario {
    folder: TempDir,
    client: Option<Client>,
    open: BTreeMap<String, (i64, String)>,
    marks: BTreeMap<(String, String), Value>,
    utf8: bool,
    last: Value,
}

impl Scenario {
    /// Runs a scenario; its text as it should be.
    fn run(text: &str) -> String {
        let folder = tempfile::tempdir().unwrap();
        let mut scenario = Self {
            folder,
            client: None,
            open: BTreeMap::new(),
            marks: BTreeMap::new(),
            utf8: false,
            last: Value::Null,
        };
        let mut result = String::new();
        let mut sections: Vec<(String, String)> = Vec::new();
        for line in text.lines() {
            if let Some(head) = line.strip_prefix("=== ") {
                sections.push((head.to_owned(), String::new()));
            } else if let Some((_, body)) = sections.last_mut() {
                body.push_str(line);
                body.push('\n');
            } else {
                assert!(line.starts_with('#') || line.is_empty(), "before the first section: {line}");
                result.push_str(line);
                result.push('\n');
            }
        }
        for (head, body) in sections {
            let body = scenario.section(&head, &body);
            let _ = write!(result, "=== {head}\n{body}");
        }
        if let Some(client) = scenario.client.take() {
            assert_eq!(client.end(), 0);
        }
        result
    }

    fn uri(&self, name: &str) -> String {
        format!("{}{name}", self.dir())
    }

    /// The folder's URI, with a slash at its end.
    fn dir(&self) -> String {
        format!("file://{}/", fs::canonicalize(self.folder.path()).unwrap().display())
    }

    fn client(&mut self) -> &mut Client {
        if self.client.is_none() {
            self.initialize(json!({}));
        }
        self.client.as_mut().unwrap()
    }

    fn initialize(&mut self, mut params: Value) {
        assert!(self.client.is_none(), "client comes first");
        if params.get("capabilities").is_none() {
            params["capabilities"] = json!({});
        }
        if params.get("workspaceFolders").is_none() {
            params["workspaceFolders"] = json!([{ "uri": self.dir(), "name": "w" }]);
        }
        let (client, capabilities) = Client::initialized(params);
        self.utf8 = capabilities["positionEncoding"] == "utf-8";
        self.client = Some(client);
    }

    /// Does what a section says; its body as it should be.
    fn section(&mut self, head: &str, body: &str) -> String {
        let (verb, rest) = head.split_once(' ').unwrap_or((head, ""));
        match verb {
            "client" => {
                let params = self.json(body);
                self.initialize(params);
            }
            "file" => {
                let text = self.unmark(rest, body);
                write_older(&self.folder.path().join(rest), text);
            }
            "open" => {
                let text = self.unmark(rest, body);
                let uri = self.uri(rest);
                self.open.insert(rest.to_owned(), (1, text.clone()));
                let document = json!({ "uri": uri, "languageId": "cnc872", "version": 1, "text": text });
                self.client().notify("textDocument/didOpen", json!({ "textDocument": document }));
            }
            "replace" => {
                let words: Vec<&str> = rest.split(' ').collect();
                let [name, from, to] = words[..] else { panic!("replace NAME A B: {rest}") };
                let range = json!({ "start": self.mark(name, from), "end": self.mark(name, to) });
                let text = body.strip_suffix('\n').unwrap_or(body).to_owned();
                self.change(name, json!({ "range": range, "text": text }));
            }
            "text" => {
                let text = self.unmark(rest, body);
                self.change(rest, json!({ "text": text }));
            }
            "close" => {
                let uri = self.uri(rest);
                self.open.remove(rest);
                self.client().notify("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
            }
            "notify" => {
                let params = self.json(body);
                self.client().notify(rest, params);
            }
            "findings" => return self.findings(rest),
            "request" => {
                let params = self.parameters(rest, body);
                let method = rest.split(' ').next().unwrap();
                let answer = self.client().request(method, params);
                self.last = answer.get("result").or_else(|| answer.get("error")).unwrap().clone();
            }
            "answer" => return self.shown(&self.last.clone()),
            "edited" => return self.edited(),
            "said" => {
                let message = self.client().said(rest);
                return self.shown(&message["params"].clone());
            }
            _ => panic!("unknown section {head}"),
        }
        body.to_owned()
    }

    fn json(&self, body: &str) -> Value {
        if body.trim().is_empty() {
            return json!({});
        }
        serde_json::from_str(&body.replace("DIR/", &self.dir())).unwrap_or_else(|error| panic!("{error}: {body}"))
    }

    /// The server's message, pretty, with the folder left out.
    fn shown(&self, value: &Value) -> String {
        let mut value = value.clone();
        for name in ["data", "page"] {
            if let Some(data) = value.get_mut(name).filter(|data| data.as_str().is_some_and(|data| data.len() > 200)) {
                *data = json!("…");
            }
        }
        let text = serde_json::to_string_pretty(&value).unwrap();
        let path = self.dir();
        let text = text.replace(&path, "DIR/").replace(path.trim_start_matches("file://"), "DIR/");
        format!("{text}\n")
    }

    /// Takes the marks out of a text and remembers where they stood.
    fn unmark(&mut self, name: &str, body: &str) -> String {
        let mut text = String::new();
        let mut rest = body;
        while let Some((before, after)) = rest.split_once('‹') {
            text.push_str(before);
            let (mark, after) = after.split_once('›').unwrap();
            let (line, start) = (text.matches('\n').count(), text.rfind('\n').map_or(0, |at| at + 1));
            let line_text = &text[start..];
            let column = if self.utf8 { line_text.len() } else { line_text.encode_utf16().count() };
            self.marks.insert((name.to_owned(), mark.to_owned()), json!({ "line": line, "character": column }));
            rest = after;
        }
        text + rest
    }

    fn mark(&self, name: &str, mark: &str) -> Value {
        let key = (name.to_owned(), mark.to_owned());
        self.marks.get(&key).unwrap_or_else(|| panic!("no mark {mark} in {name}")).clone()
    }

    fn change(&mut self, name: &str, change: Value) {
        let uri = self.uri(name);
        let (version, text) = self.open.get_mut(name).unwrap();
        *version += 1;
        let version = *version;
        apply(text, std::slice::from_ref(&change));
        let document = json!({ "uri": uri, "version": version });
        let params = json!({ "textDocument": document, "contentChanges": [change] });
        self.client().notify("textDocument/didChange", params);
    }

    fn findings(&mut self, name: &str) -> String {
        let uri = self.uri(name);
        let version = self.open.get(name).map(|(version, _)| *version);
        let found = self.client().findings(&uri, version);
        let mut lines = String::new();
        for item in found.as_array().unwrap() {
            let place = |end: &str| {
                let at = &item["range"][end];
                format!("{}:{}", at["line"], at["character"])
            };
            let code = item["code"].as_str().unwrap();
            let message = item["message"].as_str().unwrap().replace('\n', " | ");
            let message = message.replace(self.dir().trim_start_matches("file://"), "DIR/");
            let _ = writeln!(lines, "{}-{} {code} {message}", place("start"), place("end"));
        }
        lines
    }

    /// The parameters of a request: the document, place or range, and what the body adds.
    fn parameters(&self, rest: &str, body: &str) -> Value {
        let mut params = self.json(body);
        let Some((_, place)) = rest.split_once(' ') else { return params };
        let (name, marks) = place.split_once('@').map_or((place, None), |(name, marks)| (name, Some(marks)));
        params["textDocument"] = json!({ "uri": self.uri(name) });
        match marks.map(|marks| marks.split_once("..").ok_or(marks)) {
            None => {}
            Some(Err(mark)) => params["position"] = self.mark(name, mark),
            Some(Ok((from, to))) => {
                params["range"] = json!({ "start": self.mark(name, from), "end": self.mark(name, to) });
            }
        }
        params
    }

    /// The open texts after the edits of the last answer.
    fn edited(&self) -> String {
        let mut result = String::new();
        let of_action = self.last.pointer("/edit").or_else(|| self.last.pointer("/0/edit"));
        let edit = of_action.unwrap_or(&self.last);
        for (name, (_, text)) in &self.open {
            let uri = self.uri(name);
            let by_document = edit["documentChanges"].as_array().into_iter().flatten();
            let by_document = by_document
                .filter(|change| change["textDocument"]["uri"] == *uri)
                .map(|change| change["edits"].as_array().unwrap().clone());
            let by_map = edit["changes"].get(&uri).and_then(Value::as_array).cloned();
            let plain = edit.as_array().cloned();
            let edits: Vec<Value> = by_document.chain(by_map).chain(plain).flatten().collect();
            let mut text = text.clone();
            let mut changes: Vec<Value> =
                edits.iter().map(|edit| json!({ "range": edit["range"], "text": edit["newText"] })).collect();
            changes.sort_by_key(|change| {
                let start = &change["range"]["start"];
                std::cmp::Reverse((start["line"].as_u64(), start["character"].as_u64()))
            });
            apply(&mut text, &changes);
            let _ = write!(result, "--- {name}\n{text}");
        }
        result
    }
}

/// Changes a text as the protocol says, columns in UTF-16 (texts of scenarios have the same columns in UTF-8 where that
/// counts).
pub(super) fn apply(text: &mut String, changes: &[Value]) {
    for change in changes {
        let new = change["text"].as_str().unwrap();
        let Some(range) = change.get("range") else {
            new.clone_into(text);
            continue;
        };
        let offset = |at: &Value| {
            let line = usize::try_from(at["line"].as_u64().unwrap()).unwrap();
            let start =
                if line == 0 { 0 } else { text.match_indices('\n').nth(line - 1).map_or(text.len(), |(at, _)| at + 1) };
            let mut left = at["character"].as_u64().unwrap();
            let mut end = start;
            for character in text[start..].chars().take_while(|character| *character != '\n') {
                if left == 0 {
                    break;
                }
                left = left.saturating_sub(character.len_utf16() as u64);
                end += character.len_utf8();
            }
            end
        };
        let (from, to) = (offset(&range["start"]), offset(&range["end"]));
        text.replace_range(from..to, new);
    }
}
