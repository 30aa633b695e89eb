//! What is shipped for editors keeps to the program: the grammar that colours programs, the settings, the snippets.

use std::fs;
use std::path::Path;

use cnc872c::config::Settings;
use cnc872c::dict::Dialect;
use cnc872c::session::Session;
use cnc872c::text::{Encoding, MemoryLoader};
use serde_json::Value;

use crate::samples::root;

#[path = "../../examples/reference/textmate.rs"]
mod textmate;

/// The extension for VS Code.
const VSCODE: &str = "editors/vscode";

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn json(file: &str) -> Value {
    serde_json::from_str(&read(&format!("{VSCODE}/{file}"))).expect("JSON")
}

/// The TextMate grammar is the one that the dictionary gives now.
#[test]
fn textmate_grammar() {
    let same = read(textmate::FILE) == textmate::grammar();
    assert!(same, "{} is out of date; write it anew with `cargo run --example reference`", textmate::FILE);
}

/// The settings offer what the project file takes.
#[test]
fn settings_of_vscode() {
    let manifest = json("package.json");
    let offered = |name: &str| -> Vec<String> {
        let values = &manifest["contributes"]["configuration"]["properties"][name]["enum"];
        values.as_array().expect("a list").iter().filter_map(Value::as_str).map(str::to_owned).collect()
    };
    assert_eq!(offered("cnc872c.dialect"), Dialect::ALL.map(Dialect::name));
    assert_eq!(offered("cnc872c.encoding"), Encoding::NAMED.map(|(name, _)| name));
}

/// The extension has the version of the program.
#[test]
fn version_of_vscode() {
    assert_eq!(json("package.json")["version"], env!("CARGO_PKG_VERSION"));
}

/// A body with its placeholders filled in, and its last place left empty.
fn fill(body: &str) -> String {
    let mut filled = String::new();
    let mut rest = body;
    while let Some((before, place)) = rest.split_once('$') {
        filled += before;
        rest = match place.strip_prefix('0') {
            Some(after) => after,
            None => {
                let (inside, after) = place.strip_prefix('{').and_then(|place| place.split_once('}')).expect("a place");
                let (_, text) = inside.split_once([':', '|']).expect("a text");
                filled += text.split([',', '|']).next().unwrap_or_default();
                after
            }
        };
    }
    filled + rest
}

/// The findings of a file, others beside it.
fn findings(name: &str, text: &str, macrocycle: &str) -> Vec<String> {
    let loader = MemoryLoader::new().with(name, text).with("L9001", macrocycle);
    let settings = Settings::default();
    let outcome = Session { loader: &loader, settings: &settings, progress: None }.check(Path::new(name), name);
    outcome.findings.into_sorted().iter().map(|found| found.code().to_string()).collect()
}

/// Each snippet, put where it belongs, is free of findings.
#[test]
fn snippets_of_vscode() {
    let snippets = json("snippets/cnc872.json");
    let snippet = |name: &str| -> String {
        let lines = snippets[name]["body"].as_array().unwrap_or_else(|| panic!("{name}"));
        lines.iter().map(|line| fill(line.as_str().expect("a line")) + "\n").collect()
    };
    let macrocycle = snippet("Macrocycle");
    let none: Vec<String> = Vec::new();
    assert_eq!(findings("L9001", &macrocycle, &macrocycle), none);
    assert_eq!(findings("program.nc", &snippet("Program"), &macrocycle), none);
    let within = |text: &str| format!("%1\nN10 G54 G00 X0 Y0 Z0 F100\n{text}N900 M30\n");
    for name in ["Jump loop", "Macrocycle call", "Arc", "Dwell"] {
        assert_eq!(findings("program.nc", &within(&snippet(name)), &macrocycle), none, "{name}");
    }
    let program = within(&snippet("Subprogram call")) + &snippet("Subprogram");
    assert_eq!(findings("program.nc", &program, &macrocycle), none, "{program}");
    assert_eq!(snippets.as_object().map(serde_json::Map::len), Some(8), "a snippet that is not tried");
}
