//! The corpus: texts and their trees, in the format of `tree-sitter test`.

use std::fmt::Write;
use std::fs;

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
            let shown = show(&tree.root_node().to_sexp());
            let _ = write!(now, "{HEAD}\n{}\n{HEAD}\n\n{}\n---\n\n{}\n\n", case.title, case.text, shown);
            count += 1;
        }
        crate::compare(&path, &format!("{}\n", now.trim_end()));
    }
    assert!(count > 20, "only {count}");
}

/// The tree with one node a line, as `tree-sitter` writes it.
fn show(tree: &str) -> String {
    let mut shown = String::new();
    let mut depth: usize = 0;
    let mut rest = tree;
    while let Some(character) = rest.chars().next() {
        // The character shown may be a bracket or a blank.
        let taken = match rest.strip_prefix("(UNEXPECTED '") {
            Some(unexpected) => rest.len() - unexpected.len() + unexpected.find("')").expect("a quote") + 1,
            None => character.len_utf8(),
        };
        let next = &rest[taken..];
        match character {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        let name = next.split([' ', '(', ')']).next().unwrap_or_default();
        if character == ' ' && (next.starts_with('(') || name.ends_with(':')) && !shown.ends_with(':') {
            let _ = write!(shown, "\n{}", "  ".repeat(depth));
        } else {
            shown.push_str(&rest[..taken]);
        }
        rest = next;
    }
    shown
}
