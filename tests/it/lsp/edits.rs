//! After any change of a long program the server finds what a fresh check finds.

use std::fmt::Write as _;
use std::path::Path;

use cnc872c::config::Settings;
use cnc872c::session::Session;
use cnc872c::text::MemoryLoader;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use serde_json::{Value, json};

use super::Client;

const URI: &str = "file:///long.nc";
const BLOCKS: usize = 22_000;

/// Milling with a few functions among it.
fn program() -> String {
    let mut text = "%1\nN1 G00 X0 Y0 Z5\nN2 G01 F2000 Z0\n".to_owned();
    for block in 3..BLOCKS {
        let n = block * 10;
        let _ = match block % 1000 {
            499 => writeln!(text, "N{n} X0 Y0"),
            500 => writeln!(text, "N{n} G02 X0 Y10 I0 J5 \"oblouk"),
            501 => writeln!(text, "N{n} G01 X0 Y0 M08"),
            502 => writeln!(text, "N{n} G91 X1"),
            503 => writeln!(text, "N{n} G90 X{} F{}", block % 90, 100 + block % 50),
            _ => writeln!(text, "N{n} X{}.125 Y{}.25 Z{}", block % 400, block % 70, block % 7),
        };
    }
    let _ = writeln!(text, "N{} M30", BLOCKS * 10);
    text
}

/// What may be typed somewhere.
const TYPED: [&str; 22] = [
    "",
    "9",
    "1",
    ".",
    "-",
    " X5",
    "X",
    "G91 ",
    "G02 I5 ",
    "M30",
    "\n",
    "N",
    "\"",
    ",",
    "x",
    "%",
    "*",
    "G99 ",
    "R1=5 ",
    "IF[#1EQ2]GOTO10 ",
    "\nN20005 X1\n",
    " ",
];

/// Findings as code and place, from 1.
fn checked(text: &str) -> Vec<(String, [u64; 4])> {
    let loader = MemoryLoader::new().with("long.nc", text);
    let settings = Settings::default();
    let outcome =
        Session { loader: &loader, settings: &settings, progress: None }.check(Path::new("long.nc"), "long.nc");
    let source = outcome.sources.get(cnc872c::text::FileId(0)).unwrap().clone();
    let findings = outcome.findings.into_sorted().into_iter();
    let at = |offset: u32| {
        let place = source.line_column(offset);
        [u64::from(place.line), u64::from(place.column)]
    };
    findings
        .map(|found| {
            let ([a, b], [c, d]) = (at(found.at.span.start), at(found.at.span.end));
            (found.code().as_str().to_owned(), [a, b, c, d])
        })
        .collect()
}

struct Editor {
    client: Client,
    text: String,
    version: i64,
}

impl Editor {
    /// Replaces characters of a line; what is then found.
    fn change(&mut self, line: usize, column: usize, length: usize, with: &str) -> Vec<(String, [u64; 4])> {
        let start = if line == 0 { 0 } else { self.text.match_indices('\n').nth(line - 1).map_or(0, |(at, _)| at + 1) };
        let end = self.text[start..].find('\n').map_or(self.text.len(), |at| start + at);
        let from = (start + column).min(end);
        let to = (from + length).min(end);
        self.text.replace_range(from..to, with);
        self.version += 1;
        let at = |offset: usize| json!({ "line": line, "character": offset - start });
        let document = json!({ "uri": URI, "version": self.version });
        let change = json!({ "range": { "start": at(from), "end": at(to) }, "text": with });
        let params = json!({ "textDocument": document, "contentChanges": [change] });
        self.client.notify("textDocument/didChange", params);
        self.findings()
    }

    fn findings(&mut self) -> Vec<(String, [u64; 4])> {
        let found = self.client.findings(URI, Some(self.version));
        let place = |at: &Value| [at["line"].as_u64().unwrap() + 1, at["character"].as_u64().unwrap() + 1];
        let of = |item: &Value| {
            let ([a, b], [c, d]) = (place(&item["range"]["start"]), place(&item["range"]["end"]));
            (item["code"].as_str().unwrap().to_owned(), [a, b, c, d])
        };
        found.as_array().unwrap().iter().map(of).collect()
    }
}

#[test]
fn as_a_fresh_check() {
    let capabilities = json!({ "general": { "positionEncodings": ["utf-32"] } });
    let (client, _) = Client::initialized(json!({ "capabilities": capabilities }));
    let mut editor = Editor { client, text: program(), version: 0 };
    let document = json!({ "uri": URI, "languageId": "cnc872", "version": 0, "text": editor.text });
    editor.client.notify("textDocument/didOpen", json!({ "textDocument": document }));
    assert_eq!(editor.findings(), []);

    // What makes it look like a program for another control concerns the whole of it.
    let elsewhere = "IF[#1EQ2]GOTO10 G65 P1234";
    let found = editor.change(300, 0, 0, &format!("{elsewhere}\n"));
    assert!(found.iter().any(|(code, _)| code == "W0113"), "{found:?}");
    assert_eq!(found, checked(&editor.text));
    assert_eq!(editor.change(300, 0, elsewhere.len(), ""), []);

    // A step is a place and some changes there; at the end of it everything is undone.
    let line = prop_oneof![8 => 100..BLOCKS - 100, 1 => 8180..8200_usize, 1 => 0..BLOCKS];
    let typed = proptest::collection::vec((0..30_usize, 0..4_usize, 0..TYPED.len()), 1..4);
    let mut runner = TestRunner::new(crate::properties::cases(12));
    let editor = std::cell::RefCell::new(editor);
    runner
        .run(&(line, typed), |(line, changes)| {
            let mut editor = editor.borrow_mut();
            let before = editor.text.clone();
            for (column, length, typed) in changes {
                let found = editor.change(line, column, length, TYPED[typed]);
                prop_assert_eq!(found, checked(&editor.text));
            }
            editor.text = before;
            editor.version += 1;
            let (version, text) = (editor.version, editor.text.clone());
            let document = json!({ "uri": URI, "version": version });
            let params = json!({ "textDocument": document, "contentChanges": [{ "text": text }] });
            editor.client.notify("textDocument/didChange", params);
            prop_assert_eq!(editor.findings(), Vec::new());
            Ok(())
        })
        .unwrap();
}
