//! The queries: they compile, and colour what they should.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

use cnc872c::dict::GCode;
use tree_sitter::{Query, QueryCursor, StreamingIterator};
use tree_sitter_cnc872_check::{language, parse};

fn query(name: &str) -> Query {
    let text = fs::read_to_string(crate::grammar().join("queries").join(name)).unwrap();
    Query::new(&language(), &text).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The captures of a query in `text`, by place; names that begin with `_` are left out.
fn captures(query: &Query, text: &str) -> Vec<(usize, usize, String)> {
    let tree = parse(text);
    let mut cursor = QueryCursor::new();
    let mut found = Vec::new();
    let mut captures = cursor.captures(query, tree.root_node(), text.as_bytes());
    while let Some((found_match, index)) = captures.next() {
        let capture = found_match.captures()[*index];
        let name = query.capture_names()[capture.index as usize];
        if !name.starts_with('_') {
            found.push((capture.node.start_byte(), capture.node.end_byte(), name.to_owned()));
        }
    }
    found
}

#[test]
fn every_query_compiles() {
    for path in crate::files(&crate::grammar().join("queries")) {
        query(path.file_name().unwrap().to_str().unwrap());
    }
}

/// No node has two colours, so that it does not matter whether an editor takes the first or the last.
#[test]
fn one_capture_a_node() {
    let query = query("highlights.scm");
    for (name, source, _) in crate::words::programs(&["samples/ok", "samples/projects", "samples/err"]) {
        if source.len() > 100_000 {
            continue;
        }
        let mut seen = BTreeMap::new();
        for (start, end, capture) in captures(&query, source.text()) {
            let before = seen.insert((start, end), capture.clone());
            assert_eq!(before, None, "{name}, {start}: {capture}");
        }
    }
}

/// The known preparatory functions are those of the dictionary.
#[test]
fn preparatory_functions() {
    let query = query("highlights.scm");
    for number in 0..=120_u8 {
        let known = GCode::from_number(number).is_some();
        for word in [format!("G{number}"), format!("G{number:02}"), format!("g  {number:04}")] {
            let text = format!("N1 {word}");
            let found = captures(&query, &text);
            let [(_, _, capture)] = &found[1..] else { panic!("{text}: {found:?}") };
            assert_eq!(capture == "error", !known, "{text}: {capture}");
        }
    }
}

/// A sample line by line, with what each part of it is. A part in a coloured part has its own colour.
#[test]
fn snapshot() {
    let query = query("highlights.scm");
    let program = crate::grammar().join("check/snapshots/highlights.nc");
    let text = fs::read_to_string(&program).unwrap();
    let mut shown = String::new();
    let mut colours: Vec<(usize, usize, String)> = captures(&query, &text);
    colours.sort_by_key(|(start, end, _)| (*start, usize::MAX - end));
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let _ = write!(shown, "{line}");
        for (start, end, name) in colours.iter().filter(|(start, _, _)| (at..at + line.len()).contains(start)) {
            let before = text[at..*start].chars().count();
            let width = text[*start..(*end).min(at + line.trim_end().len())].chars().count();
            let _ = writeln!(shown, "{}{} {name}", " ".repeat(before), "^".repeat(width));
        }
        at += line.len();
    }
    crate::compare(&program.with_extension("txt"), &shown);
}

/// Subprograms and macrocycles are found by their numbers, calls as well.
#[test]
fn tags() {
    let text = "%1\nN1 G71 L5\nN2 L9001 G72 Q2\nN3 M30\nN4 G79 L5\nN5 G70\nN6 L6 G079\nN7 G70\n";
    let mut found: Vec<(String, String)> = captures(&query("tags.scm"), text)
        .into_iter()
        .map(|(start, end, name)| (name, text[start..end].trim().to_owned()))
        .collect();
    found.sort();
    let expected = [
        ("definition.function", "N4 G79 L5"),
        ("definition.function", "N6 L6 G079"),
        ("name", "5"),
        ("name", "5"),
        ("name", "6"),
        ("name", "9001"),
        ("reference.call", "L5"),
        ("reference.call", "L9001"),
    ];
    assert_eq!(found, expected.map(|(name, text)| (name.to_owned(), text.to_owned())));
}
