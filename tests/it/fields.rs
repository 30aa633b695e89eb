//! Fields that guides and the examples of `--help` name are fields of the schemas.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use serde_json::Value;

use crate::samples::root;

/// The paths of all fields, through lists and references: `joint.dot`.
fn paths(schema: &Value) -> BTreeSet<String> {
    let mut paths = BTreeSet::new();
    collect(schema, schema, "", &mut paths);
    paths
}

fn collect(root: &Value, schema: &Value, path: &str, paths: &mut BTreeSet<String>) {
    if path.matches('.').count() > 4 {
        return;
    }
    if let Some(reference) = schema["$ref"].as_str() {
        collect(root, root.pointer(&reference[1..]).unwrap(), path, paths);
    }
    let inner = ["anyOf", "oneOf"].into_iter().filter_map(|keyword| schema[keyword].as_array()).flatten();
    for schema in inner.chain(schema.get("items")) {
        collect(root, schema, path, paths);
    }
    for (name, schema) in schema["properties"].as_object().into_iter().flatten() {
        paths.insert(format!("{path}{name}"));
        collect(root, schema, &format!("{path}{name}."), paths);
    }
}

/// The schema of what a command writes.
fn schema_of(command: &str) -> Option<Value> {
    Some(match command {
        "compile" => cnc872c::stream::schema(),
        "check" => cnc872c::diag::schema(),
        "motion" => cnc872c::analysis::motion::schema(),
        "plc" => cnc872c::analysis::plc::schema(),
        "report" => cnc872c::analysis::sheet::schema(),
        "state" => cnc872c::analysis::state::schema(),
        "compare" => cnc872c::analysis::compare::schema(),
        "stats" => cnc872c::stats::schema(),
        _ => return None,
    })
}

/// The files of a folder with that ending.
fn texts(folder: &str, ending: &str) -> Vec<(PathBuf, String)> {
    let entries = fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let files = entries.filter(|path| path.to_string_lossy().ends_with(ending));
    files.map(|path| (path.clone(), fs::read_to_string(path).unwrap())).collect()
}

/// The paths in a filter of jq: `.joint.dot`, `.tools[].t`.
fn jq_paths(filter: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = filter;
    while let Some(at) = rest.find('.') {
        let is_path = |c: char| c.is_ascii_alphanumeric() || "._[]".contains(c);
        let end = rest[at..].find(|c| !is_path(c)).map_or(rest.len(), |length| at + length);
        found.push(rest[at..end].replace("[]", "").trim_matches(['.', ']']).to_owned());
        rest = &rest[end..];
    }
    found.retain(|path| !path.is_empty());
    found
}

#[test]
fn filters_in_examples() {
    assert_eq!(jq_paths("-c 'select(.joint.dot == \"red\") | [.n, .tools[].t]'"), ["joint.dot", "n", "tools.t"]);
    let mut count = 0;
    for (file, text) in [texts("docs/guide", ".md"), texts("src/cli/help", ".txt")].concat() {
        for line in text.lines() {
            let Some((command, filter)) = line.split_once("| jq ") else { continue };
            let command =
                command.trim_start().strip_prefix("cnc872c ").and_then(|rest| rest.split(' ').next()).unwrap();
            let paths = paths(&schema_of(command).unwrap_or_else(|| panic!("{}: {line}", file.display())));
            for path in jq_paths(filter) {
                assert!(paths.contains(&path), "{}: {path} is no field of {command}", file.display());
                count += 1;
            }
        }
    }
    assert!(count >= 10, "{count}");
}

#[test]
fn fields_in_the_guide_of_the_stream() {
    let known = paths(&schema_of("compile").unwrap());
    let guide = fs::read_to_string(root().join("docs/guide/stream.md")).unwrap();
    let is_known = |name: &str| known.iter().any(|path| path == name || path.ends_with(&format!(".{name}")));
    assert!(is_known("motion.length_mm") && is_known("length_mm") && !is_known("motion.lenght_mm"));
    let mut count = 0;
    for table in guide.split("| field | |").skip(1) {
        for row in table.lines().skip(2).take_while(|line| line.starts_with('|')) {
            let cell = row.split('|').nth(1).unwrap();
            for name in cell.split('`').skip(1).step_by(2) {
                assert!(is_known(name), "{name} is no field of the stream: {row}");
                count += 1;
            }
        }
    }
    assert!(count >= 40, "{count}");
}
