//! JSON Schemas of lines of JSON, generated from the types of their records.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

use crate::dict::capitalized;

/// The schema of the records `T`, an enum tagged by `kind`, JSON Schema 2020-12: a definition for each record, named
/// after its kind. `schema` is name and version of the form.
pub fn record_schema<T: JsonSchema>(schema: &str) -> Value {
    let generator = SchemaSettings::draft2020_12().with(|settings| settings.inline_subschemas = true).into_generator();
    let mut root = generator.into_root_schema_for::<T>().to_value();
    let records = root.get_mut("oneOf").map(Value::take).unwrap_or_default();
    let Value::Array(records) = records else { return root };
    let mut named = Map::new();
    let mut choices = Vec::new();
    for mut record in records {
        forbid_null(&mut record);
        let name =
            record.pointer("/properties/kind/const").and_then(Value::as_str).map(capitalized).unwrap_or_default();
        if let Some(record) = record.as_object_mut() {
            record.insert("title".to_owned(), name.clone().into());
        }
        named.insert(name.clone(), record);
        choices.push(json!({ "$ref": format!("#/$defs/{name}") }));
    }
    if let Some(root) = root.as_object_mut() {
        root.insert("$id".to_owned(), format!("urn:{}", schema.replace('/', ":")).into());
        root.insert("oneOf".to_owned(), choices.into());
        root.insert("$defs".to_owned(), named.into());
    }
    root
}

/// The schema of the document `T`, JSON Schema 2020-12. `schema` is name and version of the form.
pub fn document_schema<T: JsonSchema>(schema: &str) -> Value {
    let generator = SchemaSettings::draft2020_12().into_generator();
    let mut document = generator.into_root_schema_for::<T>().to_value();
    forbid_null(&mut document);
    if let Some(Value::Object(definitions)) = document.get_mut("$defs") {
        definitions.values_mut().for_each(forbid_null);
    }
    if let Some(root) = document.as_object_mut() {
        root.insert("$id".to_owned(), format!("urn:{}", schema.replace('/', ":")).into());
    }
    document
}

/// Fields without a value are left out, never null; only the items of `g` and `m` are.
pub fn forbid_null(schema: &mut Value) {
    let Some(schema) = schema.as_object_mut() else { return };
    if let Some(Value::Object(properties)) = schema.get_mut("properties") {
        for property in properties.values_mut() {
            if let Some(Value::Array(types)) = property.get_mut("type") {
                types.retain(|name| name != "null");
                if let [only] = types.as_slice() {
                    let only = only.clone();
                    if let Some(kind) = property.get_mut("type") {
                        *kind = only;
                    }
                }
            }
            if let Some(Value::Array(choices)) = property.get_mut("anyOf") {
                choices.retain(|choice| choice.get("type").is_none_or(|kind| kind != "null"));
                choices.iter_mut().for_each(forbid_null);
            }
            if let Some(Value::Array(values)) = property.get_mut("enum") {
                values.retain(|value| !value.is_null());
            }
            if property.get("default").is_some_and(Value::is_null)
                && let Some(property) = property.as_object_mut()
            {
                property.remove("default");
            }
            forbid_null(property);
        }
    }
    if let Some(items) = schema.get_mut("items")
        && items.get("properties").is_some()
    {
        forbid_null(items);
    }
}
