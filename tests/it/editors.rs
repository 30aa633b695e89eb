//! Files for editors match the program: the grammar that colours programs, the settings, the snippets.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use cnc872c::config::{Settings, client_keys, schema};
use cnc872c::session::Session;
use cnc872c::text::MemoryLoader;
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

/// Settings of the extension itself, which no project file has.
const OWN: [&str; 6] = ["language", "inlayHints", "motion.dots", "server.path", "server.arguments", "trace.server"];

/// The settings are those that the server reads, each of the type and with the values that the project file takes.
#[test]
fn settings_of_vscode() {
    let manifest = json("package.json");
    let offered = manifest["contributes"]["configuration"]["properties"].as_object().expect("settings");
    let known: BTreeSet<String> = client_keys().into_iter().chain(OWN.map(str::to_owned)).collect();
    let names: BTreeSet<String> =
        offered.keys().map(|name| name.strip_prefix("cnc872c.").expect("of the extension").to_owned()).collect();
    assert_eq!(names, known);
    let schema = schema();
    for key in client_keys() {
        let pointer = key.split('.').map(|name| format!("/properties/{name}")).collect::<String>();
        let taken = schema.pointer(&pointer).unwrap_or_else(|| panic!("{key}"));
        let setting = &offered[&format!("cnc872c.{key}")];
        let form = if taken["enum"].is_array() { "string" } else { taken["type"].as_str().expect("a type") };
        assert_eq!(setting["type"], serde_json::json!([form, "null"]), "{key}");
        assert!(setting["default"].is_null(), "{key}: what is not set wins over no project file");
        assert_eq!(setting["items"]["type"], taken["items"]["type"], "{key}");
        assert_eq!(setting["minimum"], taken["minimum"], "{key}");
        if let Some(values) = taken["enum"].as_array() {
            let offered: Vec<&Value> =
                setting["enum"].as_array().expect("values").iter().filter(|value| !value.is_null()).collect();
            assert_eq!(offered, values.iter().collect::<Vec<_>>(), "{key}");
        }
    }
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

/// The findings of a file, with a macrocycle in its folder.
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
