//! The settings of an editor: JSON whose keys are those of the project file that the command line has an option for.
//! They are read by the same rows as the project file.

use std::path::Path;

use serde_json::{Map, Value};

use super::Overrides;
use super::draft::Draft;
use super::key::Key;
use super::motion::From;
use super::reader::read;
use super::sections::{Form, ROOT, SECTIONS, Section};
use crate::diag::Findings;
use crate::text::{FileId, SourceText};

/// Letters that a misspelt name may have wrong.
const SLIPS: usize = 2;

/// The editor's settings that override the project files, folders and files in them relative to `folder`; and the
/// keys whose values cannot be used, as `limits.records: -1`. Keys that have no option on the command line are those of
/// others, and left alone; so is what is `null`.
pub fn client_overrides(settings: &Map<String, Value>, folder: &Path) -> (Overrides, Vec<String>) {
    let mut wrong = Vec::new();
    let mut texts = Vec::new();
    for section in SECTIONS {
        let Some(values) = object_of(section, settings) else { continue };
        for row in section.form.rows().iter().filter(|row| row.option.is_some()) {
            let Some(value) = values.get(row.name) else { continue };
            let key = key_of(section, row.name);
            texts.push((format!("{key} = {}\n", toml(value)), key, value));
        }
        wrong.extend(unknown_keys(section, values));
    }
    for section in SECTIONS.iter().filter(|section| section.option.is_some()) {
        match (settings.get(section.name), section.form) {
            (Some(value @ Value::Object(names)), Form::Map(_)) => {
                let lines = names.iter().map(|(name, value)| format!("{} = {}\n", quoted(name), toml(value)));
                let text = format!("[{}]\n{}", section.name, lines.collect::<String>());
                texts.push((text, section.name.to_owned(), value));
            }
            (Some(value), _) => texts.push((String::new(), section.name.to_owned(), value)),
            (None, _) => {}
        }
    }
    wrong.extend(misspelt(settings));
    let mut overrides = Overrides::default();
    for (text, key, value) in texts {
        // An empty text is how editors say that nothing is set.
        if value.is_null() || value.as_str() == Some("") {
            continue;
        }
        let mut findings = Findings::new();
        let mut draft = Draft::default();
        read(&mut draft, From::Key, &SourceText::from_text("", &text), FileId(0), &mut findings);
        if text.is_empty() || !findings.into_sorted().is_empty() {
            wrong.push(format!("{key}: {value}"));
        }
        take(&mut overrides, draft, folder);
    }
    (overrides, wrong)
}

/// The keys of an editor's settings that say something over the project files, in the order of its reference, as
/// `limits.records`.
pub fn client_keys() -> Vec<String> {
    let mut keys = Vec::new();
    for section in SECTIONS {
        let rows = section.form.rows().iter().filter(|row| row.option.is_some());
        keys.extend(rows.map(|row| key_of(section, row.name)));
        keys.extend(section.option.map(|_| section.name.to_owned()));
    }
    keys
}

/// A key as it is written in full: `limits.records`.
fn key_of(section: &Section, name: &str) -> String {
    if section.name.is_empty() { name.to_owned() } else { format!("{}.{name}", section.name) }
}

/// The keys of a table that are no settings; at the top level others may have keys too.
fn unknown_keys(section: &Section, values: &Map<String, Value>) -> Vec<String> {
    let is_setting = |name: &str| section.form.rows().iter().any(|row| row.option.is_some() && row.name == name);
    let has_settings = section.form.rows().iter().any(|row| row.option.is_some());
    let ours = section.name != ROOT.name && has_settings;
    let unknown = values.iter().filter(|(name, value)| ours && !value.is_null() && !is_setting(name));
    unknown.map(|(name, value)| format!("{}: {value}", key_of(section, name))).collect()
}

/// Names that nearly are those of settings, `dialec`, and keys of the project file that have no effect here: `axes`,
/// `limits.records` in one word. Others are somebody else's.
fn misspelt(settings: &Map<String, Value>) -> Vec<String> {
    let rows = ROOT.form.rows().iter().filter(|row| row.option.is_some()).map(|row| row.name);
    let tables = SECTIONS.iter().filter(|section| !section.name.is_empty());
    let tables =
        tables.filter(|section| section.option.is_some() || section.form.rows().iter().any(|row| row.option.is_some()));
    let known: Vec<&str> = rows.chain(tables.map(|section| section.name)).chain(["language"]).collect();
    let unknown = settings.iter().filter(|(name, value)| !value.is_null() && !known.contains(&name.as_str()));
    let near = |name: &str| {
        let plain = name.to_lowercase().replace('_', "-");
        known.iter().copied().find(|known| strsim::osa_distance(&plain, known) <= SLIPS && plain.len() > SLIPS + 1)
    };
    let said = unknown.filter_map(|(name, value)| match near(name) {
        Some(near) => Some(format!("{name} ({near}?)")),
        None => is_of_projects(name).then(|| format!("{name}: {value}")),
    });
    said.collect()
}

/// Whether it is a key of the project file that no extension has for something else, as `motion`.
fn is_of_projects(name: &str) -> bool {
    let is_table = |section: &Section| section.name == name && !matches!(section.form, Form::Keys(_));
    SECTIONS.iter().any(is_table)
        || ROOT.form.rows().iter().any(|row| row.name == name)
        || (name.contains('.') && Key::find(name).is_some_and(|key| !key.is_table()))
}

/// The settings of one table: those before all tables, `{"limits": {…}}`.
fn object_of<'s>(section: &Section, settings: &'s Map<String, Value>) -> Option<&'s Map<String, Value>> {
    if section.name == ROOT.name { Some(settings) } else { settings.get(section.name)?.as_object() }
}

/// The value as TOML; of an object something that no row takes. Numbers in quotes are numbers.
fn toml(value: &Value) -> String {
    match value {
        Value::String(text) if super::parse_decimal(text).is_some() => text.clone(),
        Value::String(text) => quoted(text),
        Value::Array(list) => format!("[{}]", list.iter().map(toml).collect::<Vec<_>>().join(", ")),
        Value::Bool(_) | Value::Number(_) => value.to_string(),
        Value::Null | Value::Object(_) => "{}".to_owned(),
    }
}

fn quoted(text: &str) -> String {
    toml_edit::Value::from(text).to_string()
}

fn take(overrides: &mut Overrides, draft: Draft, folder: &Path) {
    let Draft { settings, places, channel_config, macrocycles, .. } = draft;
    let has = |path: &str| places.contains_key(path);
    overrides.dialect = overrides.dialect.or(has("dialect").then_some(settings.machine.dialect));
    overrides.encoding = overrides.encoding.or(has("encoding").then_some(settings.encoding));
    overrides.block_skip = overrides.block_skip.or(has("block-skip").then_some(settings.block_skip));
    overrides.optional_stop = overrides.optional_stop.or(has("optional-stop").then_some(settings.optional_stop));
    overrides.max_blocks = overrides.max_blocks.or(has("limits.records").then_some(settings.machine.limits.records));
    if let Some((path, _)) = channel_config {
        overrides.channel_config = Some(folder.join(path));
    }
    overrides.macrocycles.extend(macrocycles.into_iter().map(|(name, _)| folder.join(name)));
    overrides.parameters.extend(settings.machine.parameters);
    overrides.lints.extend(settings.lints);
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn read(settings: &Value) -> (Overrides, Vec<String>) {
        client_overrides(settings.as_object().unwrap(), Path::new("/w"))
    }

    /// Each key that the command line has an option for is one of the editor's.
    #[test]
    fn each_option_is_a_setting() {
        let nothing = format!("{:?}", Overrides::default());
        for section in SECTIONS {
            for row in section.form.rows().iter().filter(|row| row.option.is_some()) {
                let value = match row.takes.schema() {
                    schema if schema["enum"].is_array() => schema["enum"][0].clone(),
                    schema if schema["type"] == "boolean" => json!(true),
                    schema if schema["type"] == "array" => json!(["a"]),
                    schema if schema["type"] == "integer" => json!(7),
                    _ => json!("a"),
                };
                let object = json!({ row.name: value });
                let object = if section.name.is_empty() { object } else { json!({ section.name: object }) };
                let (overrides, wrong) = read(&object);
                assert!(wrong.is_empty() && format!("{overrides:?}") != nothing, "{object}: {overrides:?} {wrong:?}");
            }
            if section.option.is_some() {
                let name = if section.name == "lints" { ("W0214", "allow") } else { ("R1", "2.5") };
                let object = json!({ section.name: { name.0: name.1 } });
                let (overrides, wrong) = read(&object);
                assert!(wrong.is_empty() && format!("{overrides:?}") != nothing, "{object}: {overrides:?} {wrong:?}");
            }
        }
    }

    /// A name that is nearly that of a setting is named; what is far from all is somebody else's.
    #[test]
    fn misspelt_names() {
        let (_, wrong) = read(&json!({ "dialec": "cnc872", "block_skip": true, "inlayHints": false, "trace": {} }));
        assert_eq!(wrong, ["block_skip (block-skip?)", "dialec (dialect?)"]);
        let settings = json!({ "limits.records": 2, "axes": [], "g97": "per-minute", "motion": { "dots": true } });
        let (_, mut wrong) = read(&settings);
        wrong.sort_unstable();
        assert_eq!(wrong, ["axes: []", "g97: \"per-minute\"", "limits.records: 2"], "no setting, but of project files");
    }

    /// A part of a key that cannot be used does not hide the rest.
    #[test]
    fn wrong_parts() {
        let (overrides, wrong) = read(&json!({ "parameters": { "R1": 2, "R99": 1, "R2": 0.00001 }, "lints": [] }));
        assert_eq!(wrong.len(), 2, "{wrong:?}");
        assert_eq!(overrides.parameters.len(), 2);
        let (overrides, wrong) = read(&json!({ "dialect": "a\"b\n", "macrocycles": ["a", 7], "block-skip": {} }));
        assert_eq!(wrong.len(), 3, "{wrong:?}");
        assert_eq!(format!("{overrides:?}"), format!("{:?}", Overrides::default()));
    }
}
