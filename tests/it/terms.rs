//! `docs/reference/terms.md`: no text uses a word that the table names as wrong.

use std::fs;
use std::path::PathBuf;

use crate::disk::files;
use crate::samples::root;

const TABLE: &str = "docs/reference/terms.md";

/// The words of the last column.
fn wrong_words() -> Vec<String> {
    let table = fs::read_to_string(root().join(TABLE)).unwrap();
    let rows = table.lines().filter_map(|line| line.strip_suffix(" |")?.rsplit_once("| "));
    rows.flat_map(|(_, not)| not.split('`').skip(1).step_by(2)).map(str::to_lowercase).collect()
}

/// Whether the line has the word, not as part of another one.
fn has(line: &str, word: &str) -> bool {
    let borders = |at: usize| {
        let before = line[..at].chars().next_back();
        let after = line[at + word.len()..].chars().next();
        [before, after].into_iter().flatten().all(|next| !(next.is_alphanumeric() || next == '_'))
    };
    line.match_indices(word).any(|(at, _)| borders(at))
}

/// Messages, pages, guides, and comments in the sources.
fn texts() -> Vec<PathBuf> {
    let mut texts: Vec<PathBuf> = [
        "README.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
        "samples/README.md",
        "Cargo.toml",
        ".ci/run",
    ]
    .map(|name| root().join(name))
    .to_vec();
    for folder in ["src", "tests/it", "examples", "docs", "editors/vscode/src", "editors/vscode/l10n", "web/src"] {
        texts.extend(files(&root().join(folder)).into_iter().filter(|path| {
            let name = path.to_str().unwrap();
            [".rs", ".md", ".ts", ".json"].iter().any(|end| name.ends_with(end)) && !name.ends_with(TABLE)
        }));
    }
    texts.extend(["vscode", "neovim", "helix"].map(|editor| root().join(format!("editors/{editor}/README.md"))));
    texts
}

#[test]
fn words_of_the_table() {
    let words = wrong_words();
    assert!(words.len() > 20, "the table is not read: {words:?}");
    let mut wrong = Vec::new();
    for path in texts() {
        let text = fs::read_to_string(&path).unwrap().to_lowercase();
        for (at, line) in text.lines().enumerate() {
            for word in words.iter().filter(|word| has(line, word)) {
                wrong.push(format!("{}:{}: {word}", path.strip_prefix(root()).unwrap().display(), at + 1));
            }
        }
    }
    assert!(wrong.is_empty(), "see {TABLE}:\n{}", wrong.join("\n"));
}

#[test]
fn whole_words() {
    assert!(has("to feel it", "feel") && has("feel", "feel"));
    assert!(!has("unfeeling", "feel") && !has("feels", "feel"));
}
