//! The JSON Schema of the stream, generated from its types.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;

use super::{BlockRecord, EndRecord, FileRecord, ProgramRecord};

/// One line of the stream.
#[derive(JsonSchema)]
#[schemars(tag = "kind", rename_all = "lowercase", title = "Record of the block stream cnc872c.blocks/1")]
#[expect(dead_code, reason = "the schema is all it is for: records are written one by one")]
enum Record {
    Program(ProgramRecord),
    File(FileRecord),
    Block(Box<BlockRecord>),
    End(EndRecord),
}

/// The schema, JSON Schema 2020-12.
pub fn schema() -> serde_json::Value {
    let generator = SchemaSettings::draft2020_12().with(|settings| settings.inline_subschemas = true).into_generator();
    generator.into_root_schema_for::<Record>().to_value()
}
