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
        Form::Keys(keys, _) => object(keys, properties(section)),
        Form::List(keys, _) => json!({ "type": "array", "items": object(keys, properties(section)) }),
        Form::Map(names, _) => map(names, |number| names.takes(number).schema()),
        Form::Tables(names, keys, _) => map(names, |_| object(keys, rows(keys))),
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
    let default = match row.default {
        Default::Flag(flag) => json!(flag),
        Default::Whole(number) => json!(number),
        Default::Number(number) => super::takes::json_number(number),
        Default::Text(text) => json!(text),
        Default::Texts(texts) => json!(texts),
        Default::Nothing | Default::Required | Default::ByDialect(_) | Default::Words(_) => return value,
    };
    insert(&mut value, "default", default);
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

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    static VALIDATOR: std::sync::LazyLock<jsonschema::Validator> =
        std::sync::LazyLock::new(|| jsonschema::draft202012::new(&schema()).unwrap());

    fn as_json(item: &toml_edit::Value) -> Value {
        match item {
            toml_edit::Value::String(text) => json!(text.value()),
            toml_edit::Value::Integer(number) => json!(number.value()),
            toml_edit::Value::Float(number) => json!(number.value()),
            toml_edit::Value::Boolean(flag) => json!(flag.value()),
            toml_edit::Value::Datetime(time) => json!(time.to_string()),
            toml_edit::Value::Array(list) => list.iter().map(as_json).collect(),
            toml_edit::Value::InlineTable(table) => {
                Value::Object(table.iter().map(|(key, value)| (key.to_owned(), as_json(value))).collect())
            }
        }
    }

    pub(in crate::config) fn fits(text: &str) -> bool {
        let document = toml_edit::Document::parse(text).unwrap();
        let table = document.into_table().into_inline_table();
        VALIDATOR.is_valid(&as_json(&toml_edit::Value::InlineTable(table)))
    }

    #[test]
    fn is_a_schema_of_2020_12() {
        assert!(jsonschema::meta::is_valid(&schema()));
    }

    #[test]
    fn takes_the_example_of_the_specification() {
        assert!(fits(super::super::tests::EXAMPLE));
        assert!(fits(""));
    }

    #[test]
    fn refuses_what_the_reader_refuses() {
        for text in [
            "dialekt = 'cnc872'",
            "dialect = 'cnc999'",
            "block-skip = 1",
            "macrocycles = 'a'",
            "[[axes]]\nkind = 'linear'",
            "[[axes]]\nletter = 'E'",
            "[power-up]\nG0 = 17",
            "[power-up]\nG4 = 26",
            "[parameters]\nR96 = 1",
            "[parameters]\nR1 = 70000.5",
            "[operations]\n'100' = 'add'",
            "[operations]\n'01' = 'plus'",
            "[power-up]\nM2 = 101",
            "[power-up]\nM7 = 10",
            "[start]\nE = 1",
            "spindle-axis = 'E'",
            "extensions = ['n.c']",
            "[[axes]]\nletter = 'X'\nmin = 'a'",
            "[limits]\nspeed = 100000",
            "[cycles]\nG80 = 1",
            "[cycles]\nG81 = 10000",
            "[[gears]]\nm = 41\nmin = 1",
            "[machine-constants]\nR56 = 'x'",
            "[limits]\nrecords = 0",
            "[limits]\nnesting = 1001",
            "[limits]\narc-tolerance = -1",
            "[lints]\nempty-block = 'off'",
            "[lints]\nE0302 = 'allow'",
        ] {
            assert!(!fits(text), "{text}");
        }
        for text in [
            "[parameters]\nR1 = 99999999",
            "[power-up]\nM2 = 19",
            "spindle-axis = 'none'\nextensions = ['.H']\n[start]\nZ = -3.5",
            "[lints]\nW0214 = 'deny'\nE0109 = 'allow'",
            "[machine-constants]\nR06 = '-1.5'",
        ] {
            assert!(fits(text), "{text}");
        }
    }

    /// Editors show what they are given: each key says what it sets, and what holds without it.
    #[test]
    fn keys_are_described() {
        let schema = schema();
        assert_eq!(schema["properties"]["oriented-stop"]["default"], json!(true));
        assert_eq!(schema["properties"]["limits"]["properties"]["arc-tolerance"]["default"], json!(0.01));
        for (name, value) in schema["properties"].as_object().unwrap() {
            assert!(value["description"].is_string(), "{name}");
        }
        // A level by the name of the finding says its code.
        assert_eq!(schema["properties"]["lints"]["properties"]["empty-block"]["description"], "W0214");
    }
}
