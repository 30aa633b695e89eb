//! The schema of the project file takes and refuses what the reader does.

use serde_json::{Value, json};

use super::schema;
use crate::json_schema::{Validator, validator_for};

static VALIDATOR: std::sync::LazyLock<Validator> = std::sync::LazyLock::new(|| validator_for(&schema()));

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

pub(super) fn fits(text: &str) -> bool {
    let document = toml_edit::Document::parse(text).unwrap();
    let table = document.into_table().into_inline_table();
    VALIDATOR.is_valid(&as_json(&toml_edit::Value::InlineTable(table)))
}

#[test]
fn takes_the_example_of_the_specification() {
    assert!(fits(super::tests::EXAMPLE));
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
