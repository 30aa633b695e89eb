//! JSON Schema of the project file, made of the table of keys.

use serde_json::{Map, Value, json};

use super::names::Names;
use super::row::{Default, Row};
use super::sections::{Form, ROOT, Section};
use crate::diag::Code;

/// The JSON Schema (2020-12) of `cnc872c.toml`, with which editors complete and check it: what `cnc872c schema config`
/// prints. It takes every file that is read without a finding; what it cannot say, as that an axis is there once, is
/// left to [`configure`](super::configure()).
pub fn schema() -> Value {
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": "urn:cnc872c.config:1",
        "title": "cnc872c.toml",
        "description": "Configuration of the compiler cnc872c: the machine that part programs are for.",
        "type": "object",
        "properties": properties(ROOT),
        "additionalProperties": false,
    })
}

/// The keys of a table and the tables in it.
fn properties(section: &Section) -> Map<String, Value> {
    let mut properties = rows(section.form.rows());
    for child in section.children() {
        properties.insert(child.own_name().to_owned(), described(table(child), child.meaning.en));
    }
    properties
}

fn table(section: &Section) -> Value {
    match section.form {
        Form::Keys(keys) => object(keys, properties(section)),
        Form::List(keys) => json!({ "type": "array", "items": object(keys, properties(section)) }),
        Form::Map(names) => map(names, |number| names.takes(number).schema()),
        Form::Tables(names, keys) => map(names, |_| object(keys, rows(keys))),
    }
}

fn object(keys: &[Row], properties: Map<String, Value>) -> Value {
    let required: Vec<_> =
        keys.iter().filter(|row| matches!(row.default, Default::Required)).map(|row| row.name).collect();
    let mut object = json!({ "type": "object", "properties": properties, "additionalProperties": false });
    if !required.is_empty() {
        insert(&mut object, "required", json!(required));
    }
    object
}

fn rows(keys: &[Row]) -> Map<String, Value> {
    keys.iter().map(|row| (row.name.to_owned(), value(row))).collect()
}

fn value(row: &Row) -> Value {
    let mut value = described(row.takes.schema(), row.meaning.en);
    if let Default::Is(default) = row.default
        && let Ok(default) = serde_json::from_str(default)
    {
        insert(&mut value, "default", default);
    }
    value
}

fn map(names: Names, schema_of: impl Fn(u16) -> Value) -> Value {
    let mut map = json!({ "type": "object", "additionalProperties": false });
    if let Some(listed) = names.listed() {
        let properties: Map<String, Value> = listed
            .into_iter()
            .map(|(name, number)| {
                let value = schema_of(number);
                let value = match (names, Code::find(&name)) {
                    (Names::Lints, Some(code)) => described(value, code.as_str()),
                    _ => value,
                };
                (name, value)
            })
            .collect();
        insert(&mut map, "properties", Value::Object(properties));
    }
    if let Some(pattern) = names.pattern() {
        let mut patterns = Map::new();
        patterns.insert(pattern.to_owned(), schema_of(0));
        insert(&mut map, "patternProperties", Value::Object(patterns));
    }
    map
}

fn described(mut schema: Value, meaning: &str) -> Value {
    insert(&mut schema, "description", json!(meaning));
    schema
}

fn insert(object: &mut Value, key: &str, value: Value) {
    if let Some(object) = object.as_object_mut() {
        object.insert(key.to_owned(), value);
    }
}
