//! The JSON Schema of the stream, generated from its types.

use schemars::generate::SchemaSettings;

use super::records::Record;

/// The schema, JSON Schema 2020-12.
pub fn schema() -> serde_json::Value {
    let generator = SchemaSettings::draft2020_12().with(|settings| settings.inline_subschemas = true).into_generator();
    generator.into_root_schema_for::<Record>().to_value()
}
