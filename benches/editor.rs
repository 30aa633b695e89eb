//! How long an editor waits: changes, questions, and the opening of a large program, with the real server.
//!
//! Not a statistical benchmark: a session as a user has it, with the median and the 95th percentile of each wait.
#![expect(clippy::disallowed_methods, clippy::print_stdout, reason = "a benchmark reads and prints")]
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

#[path = "../tests/it/lsp/client.rs"]
#[allow(dead_code, reason = "tests need more of it")]
mod client;

use std::fmt::Write as _;
use std::time::{Duration, Instant};

use client::Client;
use serde_json::{Value, json};

const URI: &str = "file:///bench/part.nc";

fn main() {
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    small();
    formatting(100_000);
    large(1_000_000);
}

/// A program of 1,000 blocks with a subprogram and a loop.
fn small() {
    let mut text = "%1\nN1 G01 F500 X0 Y0 Z0\nN2 G71 L100\n".to_owned();
    for block in 3..900 {
        let _ = writeln!(text, "N{block} X{}.5 Y{}.25", block % 90, block % 70);
    }
    text.push_str("N900 G73 L3 Q2\nN901 M30\nN902 G79 L100\n");
    for block in 903..1000 {
        let _ = writeln!(text, "N{block} R1={block}");
    }
    text.push_str("N1000 G70\n");
    let mut editor = Editor::open(&text, 6);
    println!("1,000 blocks: first findings {:?}", editor.first);
    let waits = (0..300).map(|round| editor.change(450, round)).collect();
    show("findings after a change", waits);
    let at = |line: u32, character: u32| json!({ "textDocument": { "uri": URI }, "position": { "line": line, "character": character } });
    for (what, method, line, character) in
        [("hover", "textDocument/hover", 451, 6), ("definition", "textDocument/definition", 2, 9)]
    {
        let waits = (0..300).map(|_| editor.ask(method, at(line, character))).collect();
        show(what, waits);
    }
}

/// Straight-line milling, as CAM writes it.
fn large(blocks: u32) {
    let mut text = "%1\nN1 G00 X0 Y0 Z5\nN2 G01 F2000 Z0\n".to_owned();
    for block in 3..blocks {
        let (x, y, z) = (block % 1000, block / 1000, block % 37);
        let _ = writeln!(text, "N{block} X{x}.125 Y{y}.250 Z{z}.375");
    }
    let _ = writeln!(text, "N{blocks} M30");
    println!("{blocks} blocks, {:.1} MB", text.len() as f64 / 1e6);
    let mut editor = Editor::open(&text, 9);
    drop(text);
    println!("  first findings {:?}, memory {} MB", editor.first, editor.memory_mb());
    // The run over the whole may still go on.
    std::thread::sleep(Duration::from_secs(2));
    let waits = (0..200).map(|round| editor.change(blocks / 2, round)).collect();
    show("findings after a change", waits);
    let at = json!({ "textDocument": { "uri": URI }, "position": { "line": blocks / 2, "character": 0 } });
    println!("  state at a block, first {:?}", editor.ask("cnc872c/state", at.clone()));
    let waits = (0..50).map(|_| editor.ask("cnc872c/state", at.clone())).collect();
    show("state at a block, then", waits);
    println!("  memory {} MB", editor.memory_mb());
}

/// A program that has no layout yet: every block changes, every second, which are most edits, or every tenth.
fn formatting(blocks: u32) {
    for (what, every) in [("every block", 1), ("every second block", 2), ("every tenth block", 10)] {
        let mut text = "%1\nN1 G00 X0 Y0 Z5\n".to_owned();
        for block in 2..blocks {
            let (x, y) = (block % 1000, block / 1000);
            let words = if block % every == 0 { "  g1" } else { "G01" };
            let _ = writeln!(text, "N{block} {words} X{x}.125 Y{y}.250 F100");
        }
        let _ = writeln!(text, "N{blocks} M30");
        let mut editor = Editor::open(&text, 9);
        println!("{blocks} blocks, {what} to be formatted");
        let params = |more: Value| {
            let mut params =
                json!({ "textDocument": { "uri": URI }, "options": { "tabSize": 4, "insertSpaces": true } });
            more.as_object().into_iter().flatten().for_each(|(key, value)| params[key] = value.clone());
            params
        };
        let waits = (0..20).map(|_| editor.ask("textDocument/formatting", params(json!({})))).collect();
        show("formatting", waits);
        let enter = json!({ "position": { "line": blocks / 2, "character": 0 }, "ch": "\n" });
        let waits = (0..20).map(|_| editor.ask("textDocument/onTypeFormatting", params(enter.clone()))).collect();
        show("Enter", waits);
    }
}

struct Editor {
    client: Client,
    version: i64,
    /// Where a digit is put into a line.
    column: u32,
    first: Duration,
}

impl Editor {
    /// Opens a program, whose changes will be at that column.
    fn open(text: &str, column: u32) -> Self {
        let (mut client, _) = Client::initialized(json!({ "capabilities": {} }));
        let document = json!({ "uri": URI, "languageId": "cnc872", "version": 0, "text": text });
        let message =
            json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": { "textDocument": document } });
        let content = message.to_string();
        let begun = Instant::now();
        client.write(format!("Content-Length: {}\r\n\r\n", content.len()).as_bytes());
        client.write(content.as_bytes());
        client.findings(URI, Some(0));
        Self { client, version: 0, column, first: begun.elapsed() }
    }

    /// Changes a digit of a block, and waits for the findings.
    fn change(&mut self, line: u32, round: u32) -> Duration {
        self.version += 1;
        // Behind the first digit of the last word.
        let column = self.column;
        let from = json!({ "line": line, "character": column });
        // A digit more, and away again.
        let (to, text) = if round.is_multiple_of(2) { (column, "9") } else { (column + 1, "") };
        let range = json!({ "start": from, "end": { "line": line, "character": to } });
        let document = json!({ "uri": URI, "version": self.version });
        let params = json!({ "textDocument": document, "contentChanges": [{ "range": range, "text": text }] });
        let begun = Instant::now();
        self.client.notify("textDocument/didChange", params);
        self.client.findings(URI, Some(self.version));
        begun.elapsed()
    }

    fn ask(&mut self, method: &str, params: Value) -> Duration {
        let begun = Instant::now();
        let answer = self.client.request(method, params);
        assert!(answer.get("result").is_some(), "{answer}");
        begun.elapsed()
    }

    /// The most memory that the server held so far, where the system tells.
    fn memory_mb(&self) -> u64 {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.client.process_id())).unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap_or_default();
        line.trim().trim_end_matches(" kB").parse::<u64>().map_or(0, |kilobytes| kilobytes / 1024)
    }
}

fn show(what: &str, mut waits: Vec<Duration>) {
    waits.sort_unstable();
    let (median, late) = (waits[waits.len() / 2], waits[waits.len() * 95 / 100]);
    println!("  {what}: median {median:?}, 95 % within {late:?}");
}
