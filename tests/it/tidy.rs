//! The architecture, as rules over the text of the sources.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::disk::files;
use crate::samples::root;

/// Longest source file, in lines.
const LONGEST: usize = 650;
/// Longest function in `src`, in lines.
const LONGEST_FUNCTION: usize = 80;

/// Widest comment, in columns.
const WIDEST: usize = 120;

/// Which top-level modules each may use.
const LAYERS: [(&str, &[&str]); 23] = [
    ("sure", &[]),
    ("named", &["dict"]),
    ("text", &[]),
    ("disk", &["text"]),
    ("parallel", &[]),
    ("dict", &[]),
    ("diag", &["text", "dict"]),
    ("syntax", &["text", "dict", "diag", "parallel"]),
    ("config", &["text", "dict", "diag"]),
    ("explain", &["text", "dict", "diag", "config", "analysis"]),
    ("resolve", &["text", "dict", "diag", "syntax", "config", "parallel"]),
    ("run", &["text", "dict", "diag", "syntax", "config", "resolve"]),
    ("analysis", &["text", "dict", "diag", "syntax", "config", "resolve", "run", "parallel"]),
    ("stream", &["text", "dict", "diag", "syntax", "config", "resolve", "run", "analysis", "parallel"]),
    ("view", &["text", "dict", "diag", "syntax", "config", "resolve", "run", "analysis", "stream", "parallel"]),
    ("session", &["text", "dict", "diag", "syntax", "config", "resolve", "run", "analysis", "stream"]),
    ("columns", &["text", "dict", "diag", "config", "run", "analysis", "stream", "session", "parallel"]),
    ("stats", &["text", "dict", "diag", "config", "resolve", "run", "analysis", "session", "columns"]),
    ("restart", &["text", "dict", "diag", "syntax", "config", "resolve", "run", "analysis", "session"]),
    ("query", &["text", "dict", "diag", "syntax", "config", "resolve", "run", "analysis", "session"]),
    ("edit", &["text", "dict", "diag", "config", "syntax", "resolve", "session", "query"]),
    (
        "lsp",
        &[
            "text", "dict", "diag", "syntax", "config", "resolve", "run", "analysis", "view", "session", "explain",
            "query", "edit", "restart",
        ],
    ),
    (
        "cli",
        &[
            "text", "disk", "dict", "diag", "syntax", "config", "resolve", "run", "analysis", "stream", "view",
            "session", "columns", "stats", "explain", "edit", "restart", "lsp", "parallel",
        ],
    ),
];

struct Source {
    /// Relative to the project, with slashes.
    name: String,
    text: String,
}

fn sources(folder: &str) -> Vec<Source> {
    files(&root().join(folder))
        .into_iter()
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .map(|path| Source { name: relative(&path), text: fs::read_to_string(&path).unwrap() })
        .collect()
}

fn relative(path: &Path) -> String {
    path.strip_prefix(root()).unwrap().to_str().unwrap().replace('\\', "/")
}

fn fail_with(wrong: &[String]) {
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The top-level module that a source belongs to; none for `lib.rs` and `main.rs`.
fn module(name: &str) -> Option<&str> {
    let inner = name.strip_prefix("src/")?;
    let module = inner.split(['/', '.']).next()?;
    (!matches!(module, "lib" | "main")).then_some(module)
}

/// The names that stand after `crate::`, those within braces included.
fn used(text: &str) -> Vec<String> {
    let mut names = Vec::new();
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let code: String = code.flat_map(|line| [line, "\n"]).collect();
    for (at, _) in code.match_indices("crate::") {
        // `$crate::` and `othercrate::` end in the same letters.
        if code[..at].ends_with(|before: char| before.is_alphanumeric() || before == '_') {
            continue;
        }
        let rest = &code[at + "crate::".len()..];
        let first = |text: &str| text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
        match rest.strip_prefix('{') {
            None => names.push(first(rest)),
            Some(list) => {
                let mut depth = 0;
                let mut item = String::new();
                for character in list.chars() {
                    match character {
                        '{' => depth += 1,
                        '}' if depth == 0 => break,
                        '}' => depth -= 1,
                        ',' if depth == 0 => names.push(first(std::mem::take(&mut item).trim())),
                        _ if depth == 0 => item.push(character),
                        _ => {}
                    }
                }
                names.push(first(item.trim()));
            }
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

#[test]
fn names_after_crate() {
    let text = "use crate::diag::{A, B};\n// crate::no\nuse crate::{text::{Span, X}, dict};\n$crate::run::x";
    assert_eq!(used(text), ["diag", "text", "dict", "run"]);
}

/// Layers: a module uses itself and those below it.
#[test]
fn layers() {
    let layers: BTreeMap<&str, &[&str]> = LAYERS.into();
    let mut wrong = Vec::new();
    for source in sources("src") {
        let Some(module) = module(&source.name) else { continue };
        let Some(allowed) = layers.get(module) else {
            wrong.push(format!("{}: module {module} has no layer", source.name));
            continue;
        };
        for name in used(&source.text) {
            // These two are everybody's.
            let own = name == module || matches!(name.as_str(), "sure" | "named");
            if !own && layers.contains_key(name.as_str()) && !allowed.contains(&name.as_str()) {
                wrong.push(format!("{}: {module} may not use {name}", source.name));
            }
        }
    }
    fail_with(&wrong);
}

/// Limits of the language, without separators.
const LIMITS: [&str; 7] = ["9999", "99999", "24000", "69999", "69999999", "9999999", "99999999"];

/// The fault of a line of code outside the rows of the language: it holds a limit, or the number of an M function or
/// group.
fn number_of_the_language(line: &str) -> Option<&str> {
    let code = line.trim_start();
    if code.starts_with("//") {
        return None;
    }
    // Texts have their own words for limits.
    let outside = code.split('"').step_by(2);
    let mut words = outside.flat_map(|code| code.split(|c: char| !(c.is_alphanumeric() || "_.".contains(c))));
    let limit = words.find(|word| LIMITS.contains(&word.replace('_', "").as_str()));
    let digits = |rest: &&str| rest.starts_with(|c: char| c.is_ascii_digit());
    let after = |before: &str| line.split(before).nth(1);
    let m_group = after(".m(").filter(digits);
    let m_function = after(".m(").and_then(|rest| rest.split(") == Some(").nth(1)).filter(digits);
    // The number of an M word, of the stop of a block, and the group that a cell of the PLC follows from.
    let of_m = line.contains("Address::M").then(|| after("Some(")).flatten().filter(digits);
    let of_stop = ["stop == Some(", "in_force == ", "group("].into_iter().filter_map(after).find(|rest| digits(rest));
    let of_cell = line.contains("Cell::").then(|| after("Some(")).flatten().filter(digits);
    limit.or(m_group).or(m_function).or(of_m).or(of_stop).or(of_cell)
}

/// Limits and M numbers are in rows only: of `dict`, and of the keys of the project file.
#[test]
fn the_language_is_data() {
    let mut wrong = Vec::new();
    for source in sources("src") {
        let is_row = source.name.starts_with("src/dict/") || source.name.ends_with("keys.rs");
        if is_row || source.name.contains("tests.rs") || source.name.ends_with("/samples.rs") {
            continue;
        }
        let code = source.text.split("#[cfg(test)]\nmod tests").next().unwrap();
        for (at, line) in code.lines().enumerate() {
            if let Some(number) = number_of_the_language(line) {
                wrong.push(format!("{}:{}: {number}", source.name, at + 1));
            }
        }
    }
    fail_with(&wrong);
    assert!(number_of_the_language("if number <= 9_999 {").is_some());
    assert!(number_of_the_language("state.m(SPINDLE_GROUP) == Some(19)").is_some());
    assert!(number_of_the_language("block.m(1)").is_some());
    assert!(number_of_the_language("word.address == Address::M && word.whole() == Some(6)").is_some());
    assert!(number_of_the_language("self.interpreter.block.m.stop == Some(0)").is_some());
    assert!(number_of_the_language("Cell::Coolant12(_) => Some(5),").is_some());
    assert!(number_of_the_language("Cell::Coolant12(_) => group(5),").is_some());
    assert!(number_of_the_language("let help = \"up to 9999\";").is_none());
}

/// The core is used by the command line only through the library: `main.rs` is short.
#[test]
fn main_is_short() {
    let lines = fs::read_to_string(root().join("src/main.rs")).unwrap().lines().count();
    assert!(lines <= 60, "src/main.rs has {lines} lines");
}

/// One concept, one file; each opens with what it is for.
#[test]
fn every_file_is_short_and_says_what_it_is_for() {
    let mut wrong = Vec::new();
    for source in sources("src").into_iter().chain(sources("tests")).chain(sources("examples")) {
        let lines = source.text.lines().count();
        if lines > LONGEST {
            wrong.push(format!("{}: {lines} lines, at most {LONGEST}", source.name));
        }
        if !source.text.starts_with("//! ") {
            wrong.push(format!("{}: does not open with `//!`", source.name));
        }
        if source.name.matches('/').count() > 3 {
            wrong.push(format!("{}: more than two levels of folders", source.name));
        }
    }
    fail_with(&wrong);
}

/// A function of `src` fits on a screen or two: from its `fn` to the brace that closes it, which stands under it.
#[test]
fn every_function_is_short() {
    let mut wrong = Vec::new();
    for source in sources("src") {
        let lines: Vec<&str> = source.text.lines().collect();
        for (at, line) in lines.iter().enumerate() {
            let begins = line.trim_start();
            let name = ["fn ", "pub fn ", "pub(crate) fn ", "pub(super) fn ", "const fn ", "pub const fn "]
                .into_iter()
                .find_map(|start| begins.strip_prefix(start));
            let Some(name) = name.filter(|_| !line.ends_with(['}', ';'])) else { continue };
            let closes = format!("{}}}", &line[..line.len() - begins.len()]);
            let length = lines[at..].iter().position(|line| *line == closes).map_or(0, |end| end + 1);
            if length > LONGEST_FUNCTION {
                let name = name.split(['(', '<']).next().unwrap();
                wrong.push(format!("{}: {name} has {length} lines, at most {LONGEST_FUNCTION}", source.name));
            }
        }
    }
    fail_with(&wrong);
}

/// Comments end at column 120; rows of tables cannot be broken.
#[test]
fn comments_are_narrow() {
    let wide = |line: &&str| line.chars().count() > WIDEST && line.trim_start().starts_with("//");
    let mut wrong = Vec::new();
    for Source { name, text } in ["src", "tests", "benches", "examples"].into_iter().flat_map(sources) {
        let lines = text.lines().filter(wide).filter(|line| !line.contains(" | "));
        wrong.extend(lines.map(|line| format!("{name}: {line}")));
    }
    fail_with(&wrong);
}

/// No code that is unsafe or unfinished, and no silenced lint without its reason.
#[test]
fn no_unfinished_code() {
    // Put together so that this file does not contain them.
    let words =
        [["uns", "afe "], ["uns", "afe{"], ["tod", "o!("], ["unimple", "mented!("], ["FIX", "ME"], ["XX", "X:"]];
    let mut wrong = Vec::new();
    for source in sources("src").into_iter().chain(sources("tests")).chain(sources("examples")) {
        for word in &words {
            let word = word.concat();
            let code = source.text.lines().filter(|line| !line.trim_start().starts_with("//"));
            for line in code.filter(|line| line.contains(&word)) {
                wrong.push(format!("{}: {}", source.name, line.trim()));
            }
        }
        for opening in ["#[allow(", "#[expect(", "#![allow(", "#![expect("] {
            for (at, _) in source.text.match_indices(opening) {
                if source.text[..at].ends_with('"') {
                    continue;
                }
                let attribute = source.text[at..].split(")]").next().unwrap();
                if source.name.starts_with("src/") && !attribute.contains("reason = ") {
                    wrong.push(format!("{}: {attribute})] gives no reason", source.name));
                }
            }
        }
    }
    fail_with(&wrong);
}

/// Only records and documents with a schema, and the findings as JSON and SARIF, are serialised by derive.
#[test]
fn what_is_serialised() {
    let wrong: Vec<String> = sources("src")
        .into_iter()
        .filter(|source| {
            let of_findings = ["src/diag/render/json.rs", "src/diag/render/sarif.rs"].contains(&source.name.as_str());
            let objects = [
                "src/analysis/sheet/json.rs",
                "src/analysis/state/json.rs",
                "src/analysis/compare/json.rs",
                "src/analysis/motion/records.rs",
                "src/analysis/plc/json.rs",
                "src/stats/row.rs",
                "src/cli/stats_cache.rs",
            ];
            let sheet = objects.contains(&source.name.as_str());
            !source.name.starts_with("src/stream/") && !of_findings && !sheet
        })
        .filter(|source| {
            let derives = source.text.split("derive(").skip(1).filter_map(|rest| rest.split(')').next());
            derives.flat_map(|list| list.split(',')).any(|name| name.trim().ends_with("Serialize"))
        })
        .map(|source| format!("{}: derives Serialize", source.name))
        .collect();
    fail_with(&wrong);
}

/// Only the command line prints.
#[test]
fn what_prints() {
    let mut wrong = Vec::new();
    for source in sources("src") {
        if matches!(module(&source.name), Some("cli") | None) {
            continue;
        }
        for word in [["print", "ln!("], ["print", "!("], ["io::std", "out()"], ["io::std", "err()"]] {
            let word = word.concat();
            if source.text.contains(&word) {
                wrong.push(format!("{}: {word}", source.name));
            }
        }
    }
    fail_with(&wrong);
}

/// No text names a place that only one machine has.
#[test]
fn no_paths_of_one_machine() {
    let mut tracked: Vec<PathBuf> = Vec::new();
    // Builds, what fuzzing gathers, and what npm installs and its scripts make are not of the project.
    let made = ["target", "corpus", "artifacts", "coverage", "node_modules", "dist", "out", "run", "server"];
    let is_made = |path: &Path| path.is_dir() && made.iter().any(|made| path.ends_with(made));
    for entry in fs::read_dir(root()).unwrap().map(|entry| entry.unwrap().path()) {
        let name = entry.file_name().unwrap().to_str().unwrap().to_owned();
        if (name.starts_with('.') && name != ".ci") || is_made(&entry) {
            continue;
        } else if entry.is_file() {
            tracked.push(entry);
        } else {
            let inner = |path: &PathBuf| !path.ancestors().take_while(|folder| *folder != root()).any(is_made);
            tracked.extend(files(&entry).into_iter().filter(inner));
        }
    }
    let homes = [
        ["/ho", "me/"],
        ["/ro", "ot/"],
        ["/Us", "ers/"],
        ["/wo", "rk/main"],
        ["/wo", "rk/shared"],
        ["/tmp/", "wt"],
        ["C:\\Us", "ers"],
    ];
    let mut wrong = Vec::new();
    for path in tracked {
        let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
        for home in &homes {
            let home = home.concat();
            for line in text.lines().filter(|line| line.contains(&home)) {
                wrong.push(format!("{}: {}", relative(&path), line.chars().take(100).collect::<String>()));
            }
        }
    }
    fail_with(&wrong);
}

/// A counted repetition multiplies the states of the lexer: with three of them an optimizing build did not end.
#[test]
fn the_lexer_counts_no_repetitions() {
    let lexer = fs::read_to_string(root().join("src/syntax/tokens.rs")).unwrap();
    let counted =
        lexer.match_indices('{').filter(|(at, _)| lexer[at + 1..].starts_with(|next: char| next.is_ascii_digit()));
    assert_eq!(counted.map(|(at, _)| &lexer[at..at + 8]).collect::<Vec<_>>(), Vec::<&str>::new());
}
