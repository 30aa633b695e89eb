//! After a rename a program means the same: the same findings, the same stream but for the number.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use cnc872c::config::{Overrides, Settings, configure, find_project};
use cnc872c::diag::Findings;
use cnc872c::session::{Part, Session};
use cnc872c::text::{Loader, SourceText, Sources};
use serde_json::{Value, json};

use super::Client;
use super::scenario::apply;
use crate::disk::TestDisk;
use crate::disk::files;
use crate::samples::root;

/// Folders of samples, and most numbers that are tried in one of them, evenly spread.
const FOLDERS: [(&str, usize); 4] =
    [("samples/ok", 12), ("samples/projects", 12), ("samples/rules", 2), ("samples/err", 2)];
/// Longer programs have nothing that shorter ones have not.
const LONGEST: usize = 20_000;
/// Findings about the form of a number, or about two of the same: another number has none.
const FIXED: [&str; 8] = ["E0102", "E0103", "E0104", "E0105", "E0106", "E0107", "E0204", "E0209"];
/// Most records of a run.
const RECORDS: u64 = 1000;

/// The disk, with another text for one file.
struct Edited<'a> {
    path: &'a Path,
    text: &'a str,
}

fn disk() -> TestDisk {
    TestDisk { root: root().to_path_buf() }
}

impl Loader for Edited<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        if path == self.path { Ok(self.text.as_bytes().to_vec()) } else { disk().read(path) }
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        disk().list(folder)
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        disk().folders(folder)
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        disk().canonical(path)
    }
}

/// The findings (code and line), and the stream.
fn outcome(settings: &Settings, path: &Path, text: &str) -> (Vec<(String, u32)>, Vec<Value>) {
    let loader = Edited { path, text };
    let session = Session { loader: &loader, settings, progress: None };
    let name = path.to_str().unwrap();
    let checked = session.check(path, name);
    let mut found: Vec<(String, u32)> = checked
        .findings
        .items()
        .iter()
        .map(|item| {
            let source = checked.sources.get(item.file()).unwrap();
            (item.code().to_string(), source.line_column(item.at.span.start).line)
        })
        .collect();
    found.sort();
    let mut stream = Vec::new();
    session.compile(path, name, Part::default(), &mut stream).unwrap();
    let stream = String::from_utf8(stream).unwrap();
    let records = stream.lines().map(|line| {
        let mut record: Value = serde_json::from_str(line).unwrap();
        record.as_object_mut().unwrap().remove("column");
        record
    });
    (found, records.collect())
}

/// The numbers behind `N`, `L` and `R` outside comments: letter, digits, and where the last digit ends.
fn numbers(text: &str) -> Vec<(char, String, usize)> {
    let mut found = Vec::new();
    let mut quoted = false;
    let mut letter = None;
    let mut digits = String::new();
    for (at, character) in text.char_indices().chain([(text.len(), '\n')]) {
        if let (Some(known), false, false) = (letter, digits.is_empty(), character.is_ascii_digit()) {
            found.push((known, std::mem::take(&mut digits), at));
            letter = None;
        }
        match character {
            '"' => quoted = !quoted,
            '\n' | '\r' => quoted = false,
            _ if quoted => {}
            '0'..='9' => {
                if letter.is_some() {
                    digits.push(character);
                }
            }
            ' ' => {}
            _ => letter = matches!(character, 'N' | 'L' | 'R').then_some(character),
        }
    }
    found
}

fn position(text: &str, at: usize) -> Value {
    let line = text[..at].matches('\n').count();
    let start = text[..at].rfind('\n').map_or(0, |at| at + 1);
    json!({ "line": line, "character": text[start..at].encode_utf16().count() })
}

/// The record with `old` in place of `new` in the fields that hold the renamed number.
fn renamed_back(record: &mut Value, letter: char, new: u64, old: u64) {
    fn change(value: Option<&mut Value>, new: u64, old: u64) {
        if let Some(value) = value.filter(|value| value.as_u64() == Some(new)) {
            *value = old.into();
        }
    }
    let of_program = |value: &Value| value.get("file").and_then(Value::as_u64).unwrap_or(0) == 0;
    if letter == 'R' {
        forget_control_words(record);
        if let Some(params) = record.get_mut("params").and_then(Value::as_object_mut)
            && let Some(value) = params.remove(&format!("R{new}"))
        {
            params.insert(format!("R{old}"), value);
        }
        return;
    }
    if letter == 'N' && of_program(record) {
        change(record.get_mut("n"), new, old);
        change(record.pointer_mut("/jump/to"), new, old);
    }
    for call in record.get_mut("calls").and_then(Value::as_array_mut).into_iter().flatten() {
        if letter == 'L' && call["by"] == "G71" {
            change(call.get_mut("l"), new, old);
        }
        if letter == 'N' && of_program(call) {
            change(call.get_mut("n"), new, old);
        }
    }
}

/// Takes the control words of arithmetic out: they name parameters.
fn forget_control_words(record: &mut Value) {
    let written = record.get("g_set").and_then(Value::as_array).into_iter().flatten();
    let calculates = written.filter_map(Value::as_u64).any(|number| (26..=29).contains(&number));
    if let Some(params) = record.get_mut("params").and_then(Value::as_object_mut).filter(|_| calculates) {
        params.retain(|name, _| !matches!(name.as_str(), "R5" | "R6" | "R7" | "R8"));
    }
}

/// What was renamed by these edits: a block when an `N` is among them.
fn kind(text: &str, edits: &[Value]) -> char {
    let letters = edits.iter().map(|edit| {
        let line = text.split('\n').nth(edit["range"]["start"]["line"].as_u64().unwrap() as usize).unwrap();
        let before = edit["range"]["start"]["character"].as_u64().unwrap() as usize;
        let units: Vec<u16> = line.encode_utf16().take(before).collect();
        String::from_utf16(&units).unwrap().trim_end().chars().last().unwrap()
    });
    let letters: Vec<char> = letters.collect();
    ['N', 'R'].into_iter().find(|letter| letters.contains(letter)).unwrap_or('L')
}

/// The programs of the samples, and how many numbers are tried.
fn programs() -> Vec<(PathBuf, usize)> {
    let all = FOLDERS.iter().flat_map(|(folder, most)| {
        files(&root().join(folder)).into_iter().map(|path| (path, *most)).collect::<Vec<_>>()
    });
    all.filter(|(path, _)| path.extension().is_some_and(|extension| extension == "nc")).collect()
}

#[test]
fn a_renamed_program_means_the_same() {
    let uri = |path: &Path| format!("file://{}", path.display());
    let (mut client, _) = Client::initialized(json!({
        "capabilities": {}, "initializationOptions": { "limits": { "records": RECORDS } }, "workspaceFolders": [{ "uri": uri(root()), "name": "w" }],
    }));
    let (mut done, mut refused) = ([0; 3], 0);
    for (path, most) in programs() {
        let name = path.strip_prefix(root()).unwrap();
        let loader = disk();
        let project = find_project(name.parent().unwrap(), &loader);
        let settings = configure(
            project.as_deref(),
            &Overrides { max_blocks: Some(RECORDS), ..Overrides::default() },
            &loader,
            &mut Sources::new(),
            &mut Findings::new(),
        );
        let bytes = fs::read(&path).unwrap();
        let text = SourceText::decode("", bytes, settings.encoding).unwrap().text().to_owned();
        if text.len() > LONGEST {
            continue;
        }
        let (found, stream) = outcome(&settings, name, &text);
        if found.iter().any(|(code, _)| FIXED.contains(&code.as_str())) {
            continue;
        }
        let document = json!({ "uri": uri(&path), "languageId": "cnc872", "version": 1, "text": text });
        client.notify("textDocument/didOpen", json!({ "textDocument": document }));
        let all = numbers(&text);
        for (letter, old, at) in all.iter().step_by(all.len().div_ceil(most).max(1)) {
            // A free number of as many digits: lines keep their lengths.
            let free = (0..10_u64.pow(u32::try_from(old.len().min(4)).unwrap()))
                .rev()
                .map(|new| format!("{new:0width$}", width = old.len()));
            let free = free.filter(|new| new.parse::<u64>().unwrap() > 0);
            let used = |new: &String| {
                all.iter().any(|(_, known, _)| known.trim_start_matches('0') == new.trim_start_matches('0'))
            };
            let Some(new) =
                free.filter(|new| (*letter != 'R' || new.parse::<u64>().unwrap() < 95) && !used(new)).nth(1)
            else {
                continue;
            };
            let params = json!({
                "textDocument": { "uri": uri(&path) }, "position": position(&text, *at), "newName": new,
            });
            let answer = client.request("textDocument/rename", params);
            let Some(edits) = answer["result"]["changes"][&uri(&path)].as_array() else {
                assert!(answer["error"]["message"].is_string(), "{}: {letter}{old}: {answer}", name.display());
                refused += 1;
                continue;
            };
            assert!(!edits.is_empty());
            let mut changes: Vec<Value> =
                edits.iter().map(|edit| json!({ "range": edit["range"], "text": edit["newText"] })).collect();
            changes.reverse();
            let mut changed = text.clone();
            apply(&mut changed, &changes);
            let what = kind(&text, edits);
            let (found_then, mut stream_then) = outcome(&settings, name, &changed);
            let at = format!("{}: {letter}{old} to {new}\n{changed}", name.display());
            assert_eq!(found_then, found, "{at}");
            for record in &mut stream_then {
                renamed_back(record, what, new.parse().unwrap(), old.parse().unwrap());
            }
            assert_eq!(stream_then.len(), stream.len(), "{at}");
            for (then, before) in stream_then.iter().zip(&stream) {
                let mut before = before.clone();
                if what == 'R' {
                    forget_control_words(&mut before);
                }
                assert_eq!(*then, before, "{at}");
            }
            done[usize::from(what == 'L') + 2 * usize::from(what == 'R')] += 1;
        }
        client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri(&path) } }));
    }
    // Blocks, subprograms, parameters.
    assert!(done[0] > 150 && done[1] > 10 && done[2] > 5, "{done:?}, refused {refused}");
    assert_eq!(client.end(), 0);
}
