//! The rules of the language: every one is cited by a test, and no other is cited.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::disk::files;
use crate::samples::root;

/// The ids of the rules of the language document, one a line.
const RULES: &str = include_str!("../data/rule-ids.txt");

fn rules() -> BTreeSet<&'static str> {
    RULES.lines().collect()
}

/// The rule ids that a text cites: the families of the list, a hyphen, a number.
fn cited(text: &str) -> BTreeSet<String> {
    let families: BTreeSet<&str> = rules().iter().map(|rule| rule.split_once('-').unwrap().0).collect();
    let mut found = BTreeSet::new();
    for (at, _) in text.match_indices('-') {
        let Some(family) = at.checked_sub(3).and_then(|start| text.get(start..at)) else { continue };
        let number: String = text[at + 1..].chars().take_while(char::is_ascii_digit).collect();
        if families.contains(family) && !number.is_empty() {
            found.insert(format!("{family}-{number}"));
        }
    }
    found
}

/// The text of a file, whatever its code page: ids are ASCII.
fn text(path: &Path) -> String {
    String::from_utf8_lossy(&fs::read(path).unwrap()).into_owned()
}

fn below(folder: &str) -> Vec<PathBuf> {
    let folder = root().join(folder);
    if folder.is_dir() { files(&folder) } else { Vec::new() }
}

/// The tests within a source file: all of it when the file is nothing else.
fn tests_of(path: &Path) -> String {
    let text = text(path);
    let stem = path.file_stem().unwrap().to_str().unwrap();
    if stem == "tests" || stem == "samples" || stem.ends_with("_tests") {
        return text;
    }
    text.split_once("#[cfg(test)]").map(|(_, tests)| tests.to_owned()).unwrap_or_default()
}

/// The list has the form that the other tests rely on.
#[test]
fn the_list_of_rules() {
    assert_eq!(RULES.lines().count(), rules().len(), "a rule stands twice");
    for rule in rules() {
        let (family, number) = rule.split_once('-').unwrap();
        assert!(family.len() == 3 && family.bytes().all(|byte| byte.is_ascii_uppercase()), "{rule}");
        assert!(number.parse::<u8>().is_ok_and(|number| number > 0), "{rule}");
    }
    assert_eq!(cited("see MOT-3…MOT-5, ISO-8859 and LEX-13."), ["LEX-13", "MOT-3", "MOT-5"].map(str::to_owned).into());
}

/// Every rule of the language is cited by at least one test or sample.
#[test]
fn every_rule_is_cited_by_a_test() {
    let mut found = BTreeSet::new();
    for path in below("tests/it").into_iter().chain(below("samples")) {
        found.append(&mut cited(&text(&path)));
        // Samples of `format` and `renumber` are named after their rules.
        found.append(&mut cited(&path.display().to_string()));
    }
    for path in below("src") {
        found.append(&mut cited(&tests_of(&path)));
    }
    let missing: Vec<&str> = rules().into_iter().filter(|rule| !found.contains(*rule)).collect();
    assert!(missing.is_empty(), "no test cites {}", missing.join(", "));
}

/// Documentation, sources and tests cite no rule that does not exist.
#[test]
fn no_unknown_rule_is_cited() {
    let rules = rules();
    let mut unknown = Vec::new();
    let folders = ["docs", "src", "tests", "samples", "grammar", "examples"];
    let pages = fs::read_dir(root()).unwrap().map(|entry| entry.unwrap().path());
    let pages = pages.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    for path in folders.into_iter().flat_map(below).chain(pages) {
        for rule in cited(&text(&path)) {
            if !rules.contains(rule.as_str()) {
                unknown.push(format!("{}: {rule}", path.strip_prefix(root()).unwrap().display()));
            }
        }
    }
    assert!(unknown.is_empty(), "{}", unknown.join("\n"));
}
