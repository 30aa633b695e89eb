//! The corpus: texts and their trees, in the format of `tree-sitter test`.

use std::fmt::Write;
use std::fs;

use tree_sitter::{Node, TreeCursor};
use tree_sitter_cnc872_check::parse;

const HEAD: &str = "==================";

/// One case of a file of the corpus.
struct Case<'c> {
    title: &'c str,
    text: &'c str,
}

fn cases(file: &str) -> Vec<Case<'_>> {
    let mut cases = Vec::new();
    for part in file.split(&format!("{HEAD}\n")).collect::<Vec<_>>()[1..].chunks(2) {
        let (text, _) = part[1].split_once("\n---\n").expect("a line of dashes behind the text");
        cases.push(Case { title: part[0].trim_end(), text: text.strip_prefix('\n').unwrap_or(text) });
    }
    cases
}

#[test]
fn corpus() {
    let mut count = 0;
    for path in crate::files(&crate::grammar().join("test/corpus")) {
        let file = fs::read_to_string(&path).unwrap();
        let mut now = String::new();
        for case in cases(&file) {
            let tree = parse(case.text);
            // A case that shows a mistake says so in its title.
            assert_eq!(tree.root_node().has_error(), case.title.starts_with("Error"), "{}", case.title);
            let mut shown = String::new();
            show(&mut tree.walk(), 0, &mut shown);
            let _ = write!(now, "{HEAD}\n{}\n{HEAD}\n\n{}\n---\n\n{}\n\n", case.title, case.text, shown.trim_end());
            count += 1;
        }
        crate::compare(&path, &format!("{}\n", now.trim_end()));
    }
    assert!(count > 20, "only {count}");
}

/// The tree as `tree-sitter` writes it: a node on each line.
fn show(cursor: &mut TreeCursor<'_>, depth: usize, text: &mut String) {
    let node: Node<'_> = cursor.node();
    if node.is_named() || node.is_missing() {
        let field = cursor.field_name().map(|name| format!("{name}: ")).unwrap_or_default();
        let name = match node.is_missing() {
            true => format!("MISSING {}", node.kind()),
            false => node.kind().to_owned(),
        };
        let _ = write!(text, "\n{}{field}({name}", "  ".repeat(depth));
        if cursor.goto_first_child() {
            loop {
                show(cursor, depth + 1, text);
                if !cursor.goto_next_sibling() {
                    break;
                }
            }
            cursor.goto_parent();
        }
        text.push(')');
    }
    if depth == 0 {
        *text = text.trim_start().to_owned();
    }
}
