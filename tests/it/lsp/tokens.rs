//! Semantic tokens over all samples: as clients read them, none overlaps another, none reaches past its line's end.

use std::path::PathBuf;

use cnc872c::session::Session;
use cnc872c::text::{Encoding, SourceText};
use serde_json::{Value, json};

use super::Client;
use crate::disk::files;
use crate::samples::root;

/// The lines of a document as the protocol ends them: LF, CR LF, CR. Their lengths in the units of the encoding.
fn lengths(text: &str, encoding: &str) -> Vec<u64> {
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    let length = |line: &str| match encoding {
        "utf-16" => line.encode_utf16().count(),
        "utf-32" => line.chars().count(),
        _ => line.len(),
    };
    text.split('\n').map(|line| u64::try_from(length(line)).unwrap()).collect()
}

/// What is wrong with the tokens of an answer; how many there are.
fn wrong(answer: &Value, lengths: &[u64]) -> (Vec<String>, usize) {
    let numbers: Vec<u64> = answer["data"].as_array().unwrap().iter().map(|number| number.as_u64().unwrap()).collect();
    let (mut line, mut column, mut end) = (0, 0, 0);
    let (mut wrong, tokens) = (Vec::new(), numbers.chunks_exact(5));
    let count = tokens.len();
    assert!(tokens.remainder().is_empty(), "{answer}");
    for token in tokens {
        if token[0] > 0 {
            (line, column, end) = (line + token[0], 0, 0);
        }
        column += token[1];
        let place = format!("{}:{} with length {}", line + 1, column + 1, token[2]);
        if column < end {
            wrong.push(format!("{place} overlaps the one before"));
        }
        end = column + token[2];
        if lengths.get(usize::try_from(line).unwrap()).is_none_or(|length| end > *length) {
            wrong.push(format!("{place} reaches past the end of its line"));
        }
        if token[2] == 0 {
            wrong.push(format!("{place} is empty"));
        }
    }
    (wrong, count)
}

/// Texts that no sample has: a comment before the `%` of a macrocycle, what stands behind a `%` in a file of CR.
const TEXTS: [(&str, &str); 4] = [
    ("L9001", "\"tool change\"\n%9001\nN10 G79 L9001\nN20 G01 X5\nN30 G70\n"),
    ("L9001", "\"a\" %1 \"b\"\nN10 G79 L9001\nN30 G70\n"),
    ("cr.nc", "%\rO2107\rN10 G0 X0\rN20 M30\r"),
    ("cr.nc", "%  \rO2107\rN10 G0 X0\rN20 M30\r"),
];

#[test]
fn every_sample() {
    let mut programs = files(&root().join("samples"));
    programs.retain(|path| path.extension().is_some_and(|name| name == "nc") || Session::is_macrocycle_name(path));
    let read = |path: PathBuf| {
        let source = SourceText::decode("", std::fs::read(&path).unwrap(), Encoding::default()).ok()?;
        Some((path, source.text().to_owned()))
    };
    let mut programs: Vec<(PathBuf, String)> = programs.into_iter().filter_map(read).collect();
    programs.extend(TEXTS.map(|(name, text)| (root().join(name), text.to_owned())));
    for encoding in ["utf-8", "utf-16", "utf-32"] {
        let capabilities = json!({ "general": { "positionEncodings": [encoding] } });
        let (mut client, declared) = Client::initialized(json!({ "capabilities": capabilities }));
        assert_eq!(declared["positionEncoding"], encoding);
        let (mut faults, mut count) = (Vec::new(), 0);
        for (path, text) in &programs {
            let uri = format!("file://{}", path.display());
            let document = json!({ "uri": uri, "languageId": "cnc872", "version": 0, "text": text });
            client.notify("textDocument/didOpen", json!({ "textDocument": document }));
            let params = json!({ "textDocument": { "uri": uri } });
            let answer = client.request("textDocument/semanticTokens/full", params.clone());
            assert!(answer["error"].is_null(), "{uri}: {answer}");
            // Long documents are coloured by ranges.
            if answer["result"].is_object() {
                let (found, tokens) = wrong(&answer["result"], &lengths(text, encoding));
                count += tokens;
                faults.extend(found.into_iter().map(|fault| format!("{}:{fault}", path.display())));
            }
            client.notify("textDocument/didClose", params);
        }
        assert!(faults.is_empty(), "{encoding}:\n{}", faults.join("\n"));
        assert!(count > 20_000, "{count}");
        assert_eq!(client.end(), 0);
    }
}
