//! JSON Schema of the project file, made of the table of keys.

use serde_json::{Map, Value, json};

use super::keys::{Default, Row, Rows};
use super::names::Names;
use super::sections::{Form, SECTIONS, Section};
use crate::diag::Code;

/// The JSON Schema (2020-12) of `cnc872c.toml`, with which editors complete and check it: what `cnc872c schema config`
/// prints. It takes every file that is read without a finding; what it cannot say, as that an axis is there once, is
/// left to [`configure`](super::configure()).
pub fn schema() -> Value {
    let mut properties = Map::new();
    for section in SECTIONS {
        match section.form {
            Form::Keys(Rows::Root) => properties.extend(rows(Rows::Root)),
            Form::Keys(_) | Form::List(_) | Form::Map(_) => {
                properties.insert(section.name.to_owned(), described(table(section), section.meaning.en));
            }
        }
    }
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "cnc872c.toml",
        "description": "Configuration of the compiler cnc872c: the machine that part programs are for.",
        "type": "object",
        "properties": properties,
        "additionalProperties": false,
    })
}

fn table(section: &Section) -> Value {
    match section.form {
        Form::Keys(keys) => object(keys),
        Form::List(keys) => json!({ "type": "array", "items": object(keys) }),
        Form::Map(names) => map(names),
    }
}

fn object(keys: Rows) -> Value {
    let required: Vec<_> =
        keys.rows().iter().filter(|row| matches!(row.default, Default::Required)).map(|row| row.name).collect();
    let mut object = json!({ "type": "object", "properties": rows(keys), "additionalProperties": false });
    if !required.is_empty() {
        insert(&mut object, "required", json!(required));
    }
    object
}

fn rows(keys: Rows) -> Map<String, Value> {
    keys.rows().iter().map(|row| (row.name.to_owned(), value(row))).collect()
}

fn value(row: &Row) -> Value {
    let mut value = described(row.takes.schema(), row.meaning.en);
    let default = match row.default {
        Default::Flag(flag) => json!(flag),
        Default::Whole(number) => json!(number),
        Default::Number(number) => super::takes::json_number(number),
        Default::Text(text) => json!(text),
        Default::Nothing | Default::Required | Default::Words(_) => return value,
    };
    insert(&mut value, "default", default);
    value
}

fn map(names: Names) -> Value {
    let mut map = json!({ "type": "object", "additionalProperties": false });
    if let Some(listed) = names.listed() {
        let properties: Map<String, Value> = listed
            .into_iter()
            .map(|(name, number)| {
                let value = names.takes(number).schema();
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
        patterns.insert(pattern.to_owned(), names.takes(0).schema());
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
mod tests {
    use super::*;

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

    fn fits(text: &str) -> bool {
        let document = toml_edit::Document::parse(text).unwrap();
        let table = document.into_table().into_inline_table();
        let validator = jsonschema::draft202012::new(&schema()).unwrap();
        validator.is_valid(&as_json(&toml_edit::Value::InlineTable(table)))
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
