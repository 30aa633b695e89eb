//! The documentation keeps to the program: examples of the grammar, generated pages, rules, links.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;

use cnc872c::config::Settings;
use cnc872c::diag::{Code, Findings};
use cnc872c::dict::{Address, Dialect, GCode, standard_m_functions};
use cnc872c::session::Session;
use cnc872c::syntax::{Form, parse};
use cnc872c::text::{FileId, MemoryLoader, SourceText};

use crate::disk::files;

#[path = "../../examples/reference/pages.rs"]
mod pages;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// An example of the grammar: `(* not E0102 words: X36.  12 *)`.
struct Example<'g> {
    code: Option<&'g str>,
    form: &'g str,
    text: String,
}

fn example(line: &str) -> Option<Example<'_>> {
    let comment = line.strip_prefix("(* ")?.strip_suffix(" *)")?;
    let (head, text) = comment.split_once(": ")?;
    let (code, form) = match head.strip_prefix("not ") {
        Some(rest) => {
            let (code, form) = rest.split_once(' ')?;
            (Some(code), form)
        }
        None => (None, head),
    };
    let text = [("\\n", "\n"), ("\\r", "\r"), ("\\t", "\t"), ("\\z", "\u{1a}"), ("\\0", "\0")]
        .into_iter()
        .fold(text.trim_start().to_owned(), |text, (escape, character)| text.replace(escape, character));
    ["file", "macrocycle", "blocks", "words"].contains(&form).then_some(Example { code, form, text })
}

impl Example<'_> {
    /// Codes of the findings about its form, warnings that have nothing to do with the grammar left out.
    fn codes(&self) -> Vec<String> {
        let findings = match self.form {
            "file" => check("program.nc", &self.text),
            "macrocycle" => check("L9001", &self.text),
            "blocks" => syntax(&format!("%1\n{}", self.text)),
            _ => syntax(&format!("%1\nN10 {}", self.text)),
        };
        let codes = findings.into_sorted().into_iter().map(|found| found.code());
        codes.filter(|code| *code != Code::W0108).map(|code| code.to_string()).collect()
    }
}

fn check(name: &str, text: &str) -> Findings {
    let loader = MemoryLoader::new().with(name, text);
    let settings = Settings::default();
    Session { loader: &loader, settings: &settings, progress: None }.check(Path::new(name), name).findings
}

fn syntax(text: &str) -> Findings {
    let mut findings = Findings::new();
    parse(FileId(0), &Arc::new(SourceText::from_text("program.nc", text)), Form::Program, &mut findings);
    findings
}

/// Every production has an example that is read without a finding; what is marked as wrong gives exactly its finding.
#[test]
fn grammar_examples() {
    let grammar = read("grammar/part-program.ebnf");
    let mut wrong = Vec::new();
    let mut examples_of: BTreeMap<&str, usize> = BTreeMap::new();
    let mut production = "";
    let mut defined = BTreeSet::new();
    for line in grammar.lines() {
        if let Some((name, _)) = line.split_once('=').filter(|_| line.starts_with(|c: char| c.is_ascii_lowercase())) {
            production = name.trim();
            examples_of.insert(production, 0);
            defined.insert(production);
        }
        let Some(example) = example(line) else { continue };
        let codes = example.codes();
        match example.code {
            None => *examples_of.get_mut(production).expect("an example stands under its production") += 1,
            Some(code) => assert!(Code::find(code).is_some(), "{line}"),
        }
        if codes != Vec::from_iter(example.code.map(str::to_owned)) {
            wrong.push(format!("{line}\n    gives {codes:?}\n"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.concat());
    assert!(defined.len() > 15, "the productions are not found");
    let bare: Vec<_> = examples_of.iter().filter(|(_, count)| **count == 0).map(|(name, _)| name).collect();
    assert!(bare.is_empty(), "productions without an example: {bare:?}");
}

/// Generated pages are those that the program makes now.
#[test]
fn generated_pages() {
    let folder = root().join(pages::FOLDER);
    let made = pages::pages();
    let mut stale = Vec::new();
    for (name, text) in &made {
        if fs::read_to_string(folder.join(name)).ok().as_deref() != Some(text.as_str()) {
            stale.push(name.clone());
        }
    }
    for path in files(&folder) {
        let name = path.strip_prefix(&folder).expect("below").to_string_lossy().replace('\\', "/");
        if !made.contains_key(&name) {
            stale.push(format!("{name} (no longer made: delete it)"));
        }
    }
    assert!(stale.is_empty(), "out of date: {stale:?}; write them anew with `cargo run --example reference`");
}

/// The ids of the rules of the language, one a line.
const RULES: &str = include_str!("../data/rule-ids.txt");

/// The reference states each rule once, in order.
#[test]
fn reference_states_every_rule() {
    let stated: Vec<String> = read("docs/reference/language.md")
        .lines()
        .filter_map(|line| Some(line.strip_prefix("**")?.split_once(".**")?.0.to_owned()))
        .filter(|name| name.contains('-'))
        .collect();
    // What `format` and `renumber` do is no part of the language.
    let rules = RULES.lines().filter(|rule| !rule.starts_with("FMT-") && !rule.starts_with("REN-"));
    assert_eq!(stated, Vec::from_iter(rules));
}

/// The reference states the rules that rows of the language cite.
#[test]
fn rows_cite_rules() {
    let language = read("docs/reference/language.md");
    let addresses = Address::ALL.iter().map(|address| address.row().rule);
    let functions = GCode::ALL.iter().map(|code| code.rule());
    let standard = Dialect::ALL.into_iter().flat_map(standard_m_functions).map(|row| row.rule);
    for rule in addresses.chain(functions).chain(standard) {
        assert!(language.contains(&format!("**{rule}.**")), "{rule}");
    }
}

/// Every code named in the documentation exists, and every code is named in the reference of the language or is about
/// files and their configuration.
#[test]
fn codes_exist() {
    let mut unknown = Vec::new();
    for path in markdown() {
        let text = fs::read_to_string(&path).unwrap();
        let words = text.split(|c: char| !c.is_ascii_alphanumeric());
        let codes =
            words.filter(|word| word.len() == 5 && word.starts_with(['E', 'W']) && word[1..].parse::<u32>().is_ok());
        unknown
            .extend(codes.filter(|code| Code::find(code).is_none()).map(|code| format!("{}: {code}", path.display())));
    }
    assert!(unknown.is_empty(), "{unknown:#?}");
    let reference = read("docs/reference/language.md");
    let ranges = ["E0101–E0107", "E0307–E0309"];
    assert!(ranges.iter().all(|range| reference.contains(range)));
    let unnamed: Vec<_> = Code::ALL.iter().filter(|code| !reference.contains(code.as_str())).collect();
    assert!(unnamed.iter().all(|code| **code == Code::E0112), "{unnamed:?}");
}

/// Links between the files of the project lead somewhere.
#[test]
fn links_lead_somewhere() {
    let mut broken = Vec::new();
    for path in markdown() {
        let text = fs::read_to_string(&path).unwrap();
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let file = link.split('#').next().unwrap_or_default();
            let outside = link.starts_with("http") || link.starts_with("mailto") || file.is_empty();
            if !outside && !path.parent().unwrap().join(file).exists() {
                broken.push(format!("{}: {link}", path.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

/// The Markdown of the project that people read in the repository; pages of findings have a test of their own.
fn markdown() -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> =
        ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(|name| root().join(name)).to_vec();
    found.push(root().join("samples/README.md"));
    for folder in ["docs/guide", "docs/reference", "docs/decisions"] {
        found
            .extend(files(&root().join(folder)).into_iter().filter(|path| path.extension().is_some_and(|e| e == "md")));
    }
    found
}

/// Terminal sessions in the documents show the program's output: each `$ cnc872c …` in a fence `console`, run in a
/// folder with the samples and the examples of the guide. A line `…` matches any lines. `DOCS=write cargo test` writes
/// the output anew.
#[test]
fn terminal_sessions() {
    let mut different = Vec::new();
    let mut sessions = 0;
    for path in markdown() {
        let text = fs::read_to_string(&path).unwrap();
        if !text.contains("```console\n") {
            continue;
        }
        let place = tempfile::tempdir().unwrap();
        copy(&root().join("samples"), &place.path().join("samples"));
        copy(&root().join("docs/guide/examples"), place.path());
        let mut written = String::new();
        let mut rest = text.as_str();
        while let Some((before, session)) = rest.split_once("```console\n") {
            let (session, after) = session.split_once("```\n").expect("the end of a fence");
            let now = run_session(session, place.path());
            if now != session {
                different.push(format!("{}:\n{now}", path.display()));
            }
            written += &format!("{before}```console\n{now}```\n");
            rest = after;
            sessions += 1;
        }
        written += rest;
        if written != text && std::env::var_os("DOCS").is_some_and(|value| value == "write") {
            fs::write(&path, written).unwrap();
        }
    }
    assert!(different.is_empty(), "{}update with `DOCS=write cargo test --test it docs`", different.join("\n"));
    assert!(sessions > 10, "the sessions are not found");
}

fn copy(from: &Path, to: &Path) {
    for file in files(from) {
        let to = to.join(file.strip_prefix(from).unwrap());
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        fs::copy(&file, to).unwrap();
    }
}

/// The session with the output that its commands give now.
fn run_session(session: &str, folder: &Path) -> String {
    let mut now = String::new();
    let mut commands = session.split("$ ").skip(1).peekable();
    assert!(commands.peek().is_some(), "a session without a command: {session}");
    for command in commands {
        let (line, shown) = command.split_once('\n').expect("a line");
        let output = run(line, folder);
        now += &format!("$ {line}\n{}", if matches(shown, &output) { shown } else { &output });
    }
    now
}

fn run(line: &str, folder: &Path) -> String {
    let line = line.strip_prefix("cnc872c ").expect(line);
    let mut command = Command::new(env!("CARGO_BIN_EXE_cnc872c"));
    command.current_dir(folder).stdin(Stdio::null());
    command.args(arguments(line));
    for variable in ["LC_ALL", "LC_MESSAGES", "LANG", "NO_COLOR", "TERM", "CLICOLOR", "CLICOLOR_FORCE", "COLUMNS"] {
        command.env_remove(variable);
    }
    let output = command.output().expect("the program runs");
    String::from_utf8(output.stdout).unwrap() + &String::from_utf8(output.stderr).unwrap()
}

/// The arguments of a command line: between single quotes blanks are kept.
fn arguments(line: &str) -> Vec<String> {
    let mut all = vec![String::new()];
    for (part, quoted) in line.split('\'').zip([false, true].into_iter().cycle()) {
        for (index, text) in if quoted { vec![part] } else { part.split(' ').collect() }.into_iter().enumerate() {
            if index > 0 {
                all.push(String::new());
            }
            all.last_mut().expect("one at least").push_str(text);
        }
    }
    all.retain(|argument| !argument.is_empty());
    all
}

/// Whether `output` matches the shown text, where a line `…` matches any lines.
fn matches(shown: &str, output: &str) -> bool {
    let mut rest = output;
    let mut parts = shown.split("…\n");
    let first = parts.next().unwrap_or_default();
    let Some(after) = rest.strip_prefix(first) else { return false };
    rest = after;
    let mut last = first;
    for part in parts {
        let Some(at) = rest.find(part) else { return false };
        rest = rest.get(at + part.len()..).unwrap_or_default();
        last = part;
    }
    rest.is_empty() || (last.is_empty() && shown.ends_with("…\n"))
}

/// The records shown in the documents are those that `compile` writes.
#[test]
fn records_shown() {
    let mut shown = 0;
    for (document, folder) in [("docs/guide/stream.md", "docs/guide/examples"), ("README.md", "")] {
        for part in read(document).split("<!-- record ").skip(1) {
            let (head, rest) = part.split_once(" -->\n```json\n").expect("a record");
            let (number, program) = head.split_once(" of ").expect("which record");
            let (text, _) = rest.split_once("```\n").expect("the end of a fence");
            let stream = run(&format!("cnc872c compile {program}"), &root().join(folder));
            let line = stream.lines().nth(number.parse::<usize>().unwrap() - 1).expect("a record");
            let [shown_now, written]: [serde_json::Value; 2] =
                [text, line].map(|json| serde_json::from_str(json).expect("JSON"));
            assert_eq!(shown_now, written);
            shown += 1;
        }
    }
    assert!(shown > 2);
}

/// Files that the guides show are those of the samples: `<!-- file PATH -->` before the fence.
#[test]
fn files_shown() {
    let mut shown = 0;
    let mut wrong = Vec::new();
    for path in markdown() {
        let text = fs::read_to_string(&path).unwrap();
        for part in text.split("<!-- file ").skip(1) {
            let (name, rest) = part.split_once(" -->\n").expect("the comment ends");
            let (_, rest) = rest.split_once('\n').expect("a fence follows");
            let (inside, _) = rest.split_once("```").expect("the fence ends");
            shown += 1;
            if read(name).replace("\r\n", "\n") != inside {
                wrong.push(format!("{}: {name}", path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "the file is shown otherwise than it is: {wrong:?}");
    assert!(shown >= 5, "{shown} files are shown");
}

/// The picture in the README shows what the program says about the program of the guide, once its slips are fixed.
#[test]
fn picture() {
    let place = tempfile::tempdir().unwrap();
    let program = read("docs/guide/examples/plate.nc").replace("Z-4,2", "Z-4.2").replace("GO", "G0");
    fs::write(place.path().join("plate.nc"), program).unwrap();
    let line = "cnc872c check plate.nc";
    let shown = format!("$ {line}\n{}", run(line, place.path()));
    let picture = read("docs/images/check.svg");
    let (_, text) = picture.split_once("<g ").expect("the text");
    let drawn: String = text.split('<').filter_map(|part| part.split_once('>')).map(|(_, text)| text).collect();
    let dense = |text: &str| text.split_whitespace().collect::<String>();
    assert_eq!(dense(&drawn), dense(&shown));
}
