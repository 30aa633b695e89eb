//! Formatting in the editor gives what `format` gives on the command line.

use std::path::Path;
use std::sync::Arc;

use cnc872c::config::Settings;
use cnc872c::dict::Dialect;
use cnc872c::edit::format;
use cnc872c::session::Session;
use cnc872c::text::{Encoding, SourceText};
use serde_json::{Value, json};

use super::Client;
use super::scenario::apply;
use crate::disk::files;
use crate::samples::root;

/// FMT-1, FMT-7: every sample, as it is and with more blanks, empty lines and small letters.
#[test]
fn samples_as_on_the_command_line() {
    let capabilities = json!({ "general": { "positionEncodings": ["utf-16"] } });
    let (mut client, _) = Client::initialized(json!({ "capabilities": capabilities }));
    let settings = Settings::new(Dialect::Cnc872);
    let mut changed = 0;
    for path in files(&root().join("samples")) {
        let is_program = path.extension().is_some_and(|name| name == "nc") || Session::is_macrocycle_name(&path);
        let source = SourceText::decode("", std::fs::read(&path).unwrap(), Encoding::default()).unwrap();
        // A client of the tests counts line ends as LF.
        let text = source.text().replace("\r\n", "\n");
        if !is_program || text.contains('\r') || text.len() > 10_000 {
            continue;
        }
        let loose = text.replace(' ', "  ").replace("\nN", " \n\n\n\n n").replace(" G", " \t g");
        for text in [text, loose] {
            // In the root folder no project file says otherwise.
            let name = Path::new("/").join(path.file_name().unwrap());
            let uri = format!("file://{}", name.display());
            let document = json!({ "uri": uri, "languageId": "cnc872", "version": 0, "text": text });
            client.notify("textDocument/didOpen", json!({ "textDocument": document }));
            let params = json!({ "textDocument": { "uri": uri }, "options": { "tabSize": 4, "insertSpaces": true } });
            let answer = client.request("textDocument/formatting", params);
            let given = Arc::new(SourceText::from_text(name.to_string_lossy(), text.as_str()));
            let mut made = Vec::new();
            let expected = match format(&name, &given, &settings, &mut |part| made.extend_from_slice(part)) {
                Ok(formatted) if formatted.changed => String::from_utf8(made).unwrap(),
                Ok(_) | Err(_) => text.clone(),
            };
            changed += usize::from(expected != text);
            assert!(answer["error"].is_null(), "{}: {answer}", path.display());
            assert_eq!(edited(&text, &answer["result"]), expected, "{}", path.display());
            client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
        }
    }
    assert!(changed > 300, "{changed}");
    assert_eq!(client.end(), 0);
}

/// FMT-1, FMT-3: a part of a text keeps its comments, whichever line is formatted alone.
#[test]
fn parts_keep_their_comments() {
    let long = "a comment that does not fit behind the words of its block, however it is laid out";
    let several =
        format!("%1\nN10 X1\nN30 Y5 \"{long}\"\nN35 X1 X2\n  Y6 \"{long}\"\n\nn40 g1  x5 \"{long}\"\nN50 M30\n");
    let samples = files(&root().join("samples/format")).into_iter().filter_map(|path| {
        let source = SourceText::decode("", std::fs::read(&path).ok()?, Encoding::default()).ok()?;
        Some(source.text().replace("\r\n", "\n").replace('\r', "\n"))
    });
    let is_program = |text: &String| text.lines().all(|line| line.matches('"').count() % 2 == 0);
    let texts: Vec<String> = [several].into_iter().chain(samples.filter(is_program)).collect();
    let capabilities = json!({ "general": { "positionEncodings": ["utf-16"] } });
    let (mut client, _) = Client::initialized(json!({ "capabilities": capabilities }));
    let mut changed = 0;
    for (number, text) in texts.iter().enumerate() {
        let uri = format!("file:///part{number}.nc");
        let document = json!({ "uri": uri, "languageId": "cnc872", "version": 0, "text": text });
        client.notify("textDocument/didOpen", json!({ "textDocument": document }));
        for line in 0..text.lines().count() {
            let at = |line: usize| json!({ "line": line, "character": 0 });
            let options = json!({ "tabSize": 4, "insertSpaces": true });
            let document = json!({ "uri": uri });
            for (method, params) in [
                (
                    "textDocument/rangeFormatting",
                    json!({ "range": { "start": at(line), "end": at(line) }, "textDocument": document, "options": options }),
                ),
                (
                    "textDocument/onTypeFormatting",
                    json!({ "position": at(line + 1), "ch": "\n", "textDocument": document, "options": options }),
                ),
            ] {
                let made = edited(text, &client.request(method, params)["result"]);
                changed += usize::from(made != *text);
                assert_eq!(comments(&made), comments(text), "{method} in line {line} of {text}\ngives {made}");
            }
        }
    }
    assert!(changed > 60, "{changed}");
    assert_eq!(client.end(), 0);
}

/// The comments of a text, sorted.
fn comments(text: &str) -> Vec<&str> {
    let mut comments: Vec<&str> = text.lines().flat_map(|line| line.split('"').skip(1).step_by(2)).collect();
    comments.sort_unstable();
    comments
}

fn edited(text: &str, edits: &Value) -> String {
    let mut text = text.to_owned();
    let edits = edits.as_array().into_iter().flatten();
    let changes: Vec<Value> = edits.map(|edit| json!({ "range": edit["range"], "text": edit["newText"] })).collect();
    for change in changes.iter().rev() {
        apply(&mut text, std::slice::from_ref(change));
    }
    text
}
