//! Every sample typed character by character: the server lives, and finds at the end what `check` finds.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::thread;

use cnc872c::session::Session;
use cnc872c::text::{Encoding, SourceText};
use serde_json::{Value, json};

use super::Client;
use crate::markers::files;
use crate::samples::root;

/// Of longer texts the rest is pasted.
const TYPED: usize = 1500;

/// A finding: code, and place from 1.
type Finding = (String, [u64; 4]);

#[test]
fn every_sample() {
    let programs: Vec<PathBuf> = files(&root().join("samples"))
        .into_iter()
        .filter(|path| path.extension().is_some_and(|name| name == "nc") || Session::is_macrocycle_name(path))
        .collect();
    assert!(programs.len() > 300);
    let queue = Mutex::new(programs);
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(2, usize::from) {
            scope.spawn(|| {
                let capabilities = json!({ "general": { "positionEncodings": ["utf-32"] } });
                let (mut client, _) = Client::initialized(json!({ "capabilities": capabilities }));
                while let Some(path) = { queue.lock().unwrap().pop() } {
                    type_in(&mut client, &path);
                }
                assert_eq!(client.end(), 0);
            });
        }
    });
}

fn type_in(client: &mut Client, path: &Path) {
    let uri = format!("file://{}", path.display());
    let source = SourceText::decode("", std::fs::read(path).unwrap(), Encoding::default()).unwrap();
    let document = json!({ "uri": uri, "languageId": "cnc872", "version": 0, "text": "" });
    client.notify("textDocument/didOpen", json!({ "textDocument": document }));
    client.findings(&uri, Some(0));
    let (mut line, mut column, mut version) = (0, 0, 0);
    let typed = source.text().char_indices().nth(TYPED).map_or(source.text().len(), |(at, _)| at);
    let (first, rest) = source.text().split_at(typed);
    let characters = first.chars().map(String::from);
    for text in characters.chain(Some(rest.to_owned()).filter(|rest| !rest.is_empty())) {
        version += 1;
        let at = json!({ "line": line, "character": column });
        change(client, &uri, version, &json!({ "range": { "start": at, "end": at }, "text": text }));
        client.findings(&uri, Some(version));
        if version % 16 == 0 {
            ask_everything(client, &uri, &at);
        }
        // A CR counts as a line end until an LF follows it.
        match text.as_str() {
            "\n" if column == 0 && first[..].contains("\r\n") => {}
            "\n" | "\r" => (line, column) = (line + 1, 0),
            _ => column += 1,
        }
    }
    let found = client.request("textDocument/diagnostic", json!({ "textDocument": { "uri": uri } }));
    let found: Vec<Finding> = found["result"]["items"].as_array().unwrap().iter().map(of_server).collect();
    assert_eq!(found, checked(path), "{}", path.display());
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
}

fn change(client: &mut Client, uri: &str, version: i64, change: &Value) {
    let document = json!({ "uri": uri, "version": version });
    client.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [change] }));
}

/// Asks everything that can be asked about a place; no answer may be that the server failed.
fn ask_everything(client: &mut Client, uri: &str, at: &Value) {
    for method in ["textDocument/hover"] {
        let params = json!({ "textDocument": { "uri": uri }, "position": at });
        let answer = client.request(method, params);
        assert_ne!(answer["error"]["code"], -32603, "{method} {uri} {at}: {answer}");
    }
}

fn of_server(item: &Value) -> Finding {
    let place = |end: &str| {
        let at = &item["range"][end];
        [at["line"].as_u64().unwrap() + 1, at["character"].as_u64().unwrap() + 1]
    };
    let ([a, b], [c, d]) = (place("start"), place("end"));
    (item["code"].as_str().unwrap().to_owned(), [a, b, c, d])
}

/// What `check` finds in the file itself.
fn checked(path: &Path) -> Vec<Finding> {
    let output =
        Command::new(env!("CARGO_BIN_EXE_cnc872c")).args(["check", "--format", "json"]).arg(path).output().unwrap();
    let document: Value = serde_json::from_slice(&output.stdout).unwrap();
    let items = document["diagnostics"].as_array().unwrap().iter();
    let own = items.filter(|item| Path::new(item["file"].as_str().unwrap()) == path);
    own.map(|item| {
        let place = |end: &str| {
            let at = &item["span"][end];
            [at["line"].as_u64().unwrap(), at["column"].as_u64().unwrap()]
        };
        let ([a, b], [c, d]) = (place("start"), place("end"));
        (item["code"].as_str().unwrap().to_owned(), [a, b, c, d])
    })
    .collect()
}
