//! The parser is the one that the grammar makes.

use std::fs;

use tree_sitter_generate::{OptLevel, generate_parser_in_directory};

/// Understood by every editor that reads tree-sitter grammars, old ones too.
const ABI: usize = 14;

const FILES: [&str; 6] = [
    "grammar.json",
    "node-types.json",
    "parser.c",
    "tree_sitter/alloc.h",
    "tree_sitter/array.h",
    "tree_sitter/parser.h",
];

#[test]
fn parser() {
    let place = tempfile::tempdir().unwrap();
    let grammar = crate::grammar().join("grammar.js");
    let mut diagnostics = Vec::new();
    generate_parser_in_directory(
        crate::grammar(),
        Some(place.path()),
        Some(grammar),
        ABI,
        None,
        Some("native"),
        true,
        OptLevel::default(),
        &mut diagnostics,
    )
    .unwrap();
    assert!(diagnostics.is_empty(), "the grammar is ambiguous or has rules that nothing uses");
    for name in FILES {
        let now = fs::read_to_string(place.path().join(name)).unwrap();
        crate::compare(&crate::grammar().join("src").join(name), &now);
    }
}
