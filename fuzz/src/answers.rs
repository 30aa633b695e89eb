//! What must hold of answers, and what is read from them.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::world::Shown;

/// Ranges anywhere in a result.
pub fn assert_ranges(value: &Value) {
    match value {
        Value::Array(items) => items.iter().for_each(assert_ranges),
        Value::Object(object) => {
            if let (Some(start), Some(end)) = (object.get("start"), object.get("end")) {
                let at = |place: &Value| (place["line"].as_u64(), place["character"].as_u64());
                assert!(at(start) <= at(end), "{value}");
            }
            object.values().for_each(assert_ranges);
        }
        _ => {}
    }
}

/// The text edits of a result, by document: those of a `WorkspaceEdit`, of one of a list of actions or completions, or
/// the list itself.
pub fn edits(uri: &str, result: &Value, which: usize) -> Vec<(String, Option<i64>, Vec<Value>)> {
    let list = result.as_array().or(result["items"].as_array());
    let chosen = match list {
        Some(list) if list.is_empty() => return Vec::new(),
        Some(list) if list[0].get("newText").is_some() => return vec![(uri.to_owned(), None, list.clone())],
        Some(list) => &list[which % list.len()],
        None => result,
    };
    if chosen["textEdit"].is_object() {
        let more = chosen["additionalTextEdits"].as_array().into_iter().flatten();
        let all = std::iter::once(&chosen["textEdit"]).chain(more).cloned().collect();
        return vec![(uri.to_owned(), None, all)];
    }
    let edit = chosen.get("edit").unwrap_or(chosen);
    let by_map = edit["changes"].as_object().into_iter().flatten();
    let by_map = by_map.map(|(uri, edits)| (uri.clone(), None, edits.as_array().cloned().unwrap_or_default()));
    let by_document = edit["documentChanges"].as_array().into_iter().flatten().map(|change| {
        let document = &change["textDocument"];
        let uri = document["uri"].as_str().unwrap_or_default().to_owned();
        (uri, document["version"].as_i64(), change["edits"].as_array().cloned().unwrap_or_default())
    });
    by_map.chain(by_document).collect()
}

/// A file's findings are those expected of it; what several documents find in the same place is shown once.
pub fn assert_shown(uri: &str, text: &str, items: &[Value], expected: &[Vec<Shown>]) {
    let number = |at: &Value| at.as_u64().expect("a number");
    let shown: Vec<Shown> = items
        .iter()
        .map(|item| {
            let (start, end) = (&item["range"]["start"], &item["range"]["end"]);
            let range = [&start["line"], &start["character"], &end["line"], &end["character"]].map(number);
            let code = item["code"].as_str().expect("a code").to_owned();
            let message = item["message"].as_str().expect("a message").to_owned();
            (range, code, number(&item["severity"]), message)
        })
        .collect();
    let places = |shown: &[Shown]| -> BTreeSet<([u64; 4], String)> {
        shown.iter().map(|(range, code, ..)| (*range, code.clone())).collect()
    };
    let all: Vec<Shown> = expected.iter().flatten().cloned().collect();
    assert_eq!(places(&shown), places(&all), "{uri}: {text:?}");
    for (range, code, severity, message) in &shown {
        let same = |other: &&Shown| {
            other.0 == *range && other.1 == *code && other.2 == *severity && message.starts_with(&other.3)
        };
        assert!(all.iter().any(|other| same(&other)), "{uri}: {code} {range:?} {message}: {all:?}");
    }
    if let [only] = expected {
        assert_eq!(shown.len(), only.len(), "{uri}: {text:?}");
    }
}
