//! Every sample typed: the server lives, and finds at the end what `check` finds. One of sixteen is typed character by
//! character, half of the others word by word, the rest line by line; the inside of comments at once.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::thread;

use cnc872c::session::Session;
use cnc872c::text::{Encoding, SourceText};
use serde_json::{Value, json};

use super::Client;
use crate::disk::files;
use crate::samples::root;

/// Of longer texts the rest is pasted.
const TYPED: usize = 600;

/// What is typed at once, outside comments.
#[derive(Clone, Copy, Eq, PartialEq)]
enum Stroke {
    Letter,
    Word,
    Line,
}

/// A finding: code, and place from 1.
type Finding = (String, [u64; 4]);

fn client() -> Client {
    let capabilities = json!({
        "general": { "positionEncodings": ["utf-32"] },
        "textDocument": { "rename": { "prepareSupport": true } },
    });
    Client::initialized(json!({ "capabilities": capabilities })).0
}

#[test]
fn every_sample() {
    let programs: Vec<PathBuf> = files(&root().join("samples"))
        .into_iter()
        // An editor hands over text, whatever the bytes of the file are.
        .filter(|path| !path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("E0115")))
        .filter(|path| !path.parent().is_some_and(|folder| folder.ends_with("FMT-6-utf-16")))
        .filter(|path| path.extension().is_some_and(|name| name == "nc") || Session::is_macrocycle_name(path))
        .collect();
    assert!(programs.len() > 300);
    let queue = Mutex::new(programs.into_iter().enumerate().collect::<Vec<_>>());
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(2, usize::from) {
            scope.spawn(|| {
                let mut client = client();
                while let Some((at, path)) = { queue.lock().unwrap().pop() } {
                    let stroke = match at % 16 {
                        0 => Stroke::Letter,
                        1..8 => Stroke::Word,
                        _ => Stroke::Line,
                    };
                    type_in(&mut client, &path, stroke);
                }
                assert_eq!(client.end(), 0);
            });
        }
    });
}

fn type_in(client: &mut Client, path: &Path, stroke: Stroke) {
    let uri = format!("file://{}", path.display());
    let source = SourceText::decode("", std::fs::read(path).unwrap(), Encoding::default()).unwrap();
    let document = json!({ "uri": uri, "languageId": "cnc872", "version": 0, "text": "" });
    client.notify("textDocument/didOpen", json!({ "textDocument": document }));
    client.findings(&uri, Some(0));
    let (mut line, mut column, mut version) = (0, 0, 0);
    let typed = source.text().char_indices().nth(TYPED).map_or(source.text().len(), |(at, _)| at);
    let (first, rest) = source.text().split_at(typed);
    for text in keystrokes(first, stroke).into_iter().chain(Some(rest).filter(|rest| !rest.is_empty())) {
        version += 1;
        let at = json!({ "line": line, "character": column });
        change(client, &uri, version, &json!({ "range": { "start": at, "end": at }, "text": text }));
        // Letter by letter each change has its findings; else the server gathers up to four.
        if stroke == Stroke::Letter || version % 4 == 0 {
            client.findings(&uri, Some(version));
        }
        if version % 32 == 0 {
            ask_everything(client, &uri, &at);
        }
        // A CR counts as a line end until an LF follows it.
        match text {
            "\n" if column == 0 && first[..].contains("\r\n") => {}
            "\n" | "\r" => (line, column) = (line + 1, 0),
            _ => column += text.chars().count(),
        }
    }
    let found = client.request("textDocument/diagnostic", json!({ "textDocument": { "uri": uri } }));
    let found: Vec<Finding> = found["result"]["items"].as_array().unwrap().iter().map(of_server).collect();
    assert_eq!(found, checked(path), "{}", path.display());
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
    client.forget();
}

/// A text as it is typed, and at once what a comment says, after its opening quote and before the closing one: most of
/// a sample is comments, and their letters are all alike to the server. Spaces between words come at once.
fn keystrokes(text: &str, stroke: Stroke) -> Vec<&str> {
    let mut strokes = Vec::new();
    let mut rest = text;
    let mut in_comment = false;
    while let Some(next) = rest.chars().next() {
        let until = |ends: &[char]| rest.find(ends).unwrap_or(rest.len());
        let length = match stroke {
            _ if in_comment => until(&['"', '\r', '\n']),
            Stroke::Letter => 0,
            Stroke::Word => until(&['"', ' ', '\r', '\n']).max(rest.len() - rest.trim_start_matches(' ').len()),
            Stroke::Line => until(&['"', '\r', '\n']),
        };
        let (typed, after) = rest.split_at(length.max(next.len_utf8()));
        in_comment = match typed {
            "\"" => !in_comment,
            "\r" | "\n" => false,
            _ => in_comment,
        };
        strokes.push(typed);
        rest = after;
    }
    strokes
}

#[test]
fn strokes() {
    let text = "%1\"ab c\"N10  X5\n\"d\r\nX";
    let each = ["%", "1", "\"", "ab c", "\"", "N", "1", "0", " ", " ", "X", "5", "\n", "\"", "d", "\r", "\n", "X"];
    assert_eq!(keystrokes(text, Stroke::Letter), each);
    let rows = ["%1", "\"", "ab c", "\"", "N10", "  ", "X5", "\n", "\"", "d", "\r", "\n", "X"];
    assert_eq!(keystrokes(text, Stroke::Word), rows);
    let rows = ["%1", "\"", "ab c", "\"", "N10  X5", "\n", "\"", "d", "\r", "\n", "X"];
    assert_eq!(keystrokes(text, Stroke::Line), rows);
}

/// As a new macrocycle begins.
#[test]
fn a_macrocycle_without_a_block() {
    let mut client = client();
    for (at, text) in ["", "%1\n", "*\nN10 G79 L1\nN20 X1\nN30 G70\n", "T5  G72 M06", "\"new"].iter().enumerate() {
        let uri = format!("file:///{at}/L1");
        let document = json!({ "uri": uri, "languageId": "cnc872", "version": 0, "text": text });
        client.notify("textDocument/didOpen", json!({ "textDocument": document }));
        ask_everything(&mut client, &uri, &json!({ "line": 0, "character": 0 }));
    }
}

fn change(client: &mut Client, uri: &str, version: i64, change: &Value) {
    let document = json!({ "uri": uri, "version": version });
    client.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [change] }));
}

/// Asks everything that can be asked about a place; no answer may be that the server failed.
fn ask_everything(client: &mut Client, uri: &str, at: &Value) {
    let line = at["line"].as_u64().unwrap();
    let lines = json!({ "start": { "line": line.saturating_sub(5), "character": 0 }, "end": at });
    for method in [
        "textDocument/hover",
        "textDocument/completion",
        "textDocument/definition",
        "textDocument/references",
        "textDocument/documentHighlight",
        "textDocument/prepareRename",
        "textDocument/rename",
        "textDocument/prepareCallHierarchy",
        "textDocument/documentLink",
        "textDocument/documentSymbol",
        "textDocument/foldingRange",
        "textDocument/selectionRange",
        "textDocument/codeAction",
        "textDocument/codeLens",
        "textDocument/inlayHint",
        "textDocument/onTypeFormatting",
        "textDocument/semanticTokens/range",
        "textDocument/semanticTokens/full",
        "textDocument/diagnostic",
    ] {
        let params = json!({
            "textDocument": { "uri": uri }, "position": at, "positions": [at], "range": lines,
            "context": { "includeDeclaration": true, "diagnostics": [], "triggerKind": 1 }, "newName": "77", "ch": "\n",
            "options": { "tabSize": 4, "insertSpaces": true },
        });
        let answer = client.request(method, params);
        // Of errors only refusals with a reason may come: neither a failure of the server nor parameters not
        // understood.
        let code = &answer["error"]["code"];
        assert!(code.is_null() || code == -32803, "{method} {uri} {at}: {answer}");
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
