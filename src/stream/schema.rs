//! The JSON Schema of the stream, generated from its types.

use serde_json::Value;

use super::records::{Record, SCHEMA};
use crate::analysis::record_schema;

/// The schema, JSON Schema 2020-12: a named definition for each record.
pub fn schema() -> Value {
    record_schema::<Record>(SCHEMA)
}
