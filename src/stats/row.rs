//! The facts of a program.

use std::collections::BTreeMap;
use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::Value;

use crate::analysis::document_schema;

/// Name and version of the form.
pub const SCHEMA: &str = "cnc872c.stats/1";

/// A number; whole ones are written without a point.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq)]
#[serde(transparent)]
#[schemars(inline)]
pub struct Number(pub f64);

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[expect(clippy::cast_possible_truncation, reason = "whole, and far fewer than 63 bits")]
        if self.0.fract() == 0.0 && self.0.abs() < 1e15 {
            serializer.serialize_i64(self.0 as i64)
        } else {
            serializer.serialize_f64(self.0)
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// Least and greatest position by axis.
pub type Reach = BTreeMap<String, [Number; 2]>;

/// How far motions reach, in programmed coordinates.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Extents {
    /// G01, G02, G03.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub working: Reach,
    /// All motions.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub all: Reach,
}

/// A program. What execution gives is there only when the program was executed to its end without errors; what is
/// false, empty or absent is left out.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    /// The file, as named or found.
    pub path: String,
    /// SHA-256 of its bytes, hexadecimal; none when it cannot be read.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hash: Option<String>,
    /// The number after `%`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub number: Option<u32>,
    /// The title (BLK-9).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// The control that the program seems to be for: `cnc8x6`, `cnc8x9`, `cnc872`; of programs for others `fanuc`,
    /// `linuxcnc`, `sinumerik`, `heidenhain`, or `iso`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dialect: Option<String>,
    /// How its bytes are read.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub encoding: Option<String>,
    /// Blocks written in the file.
    pub blocks: u64,
    /// Blocks executed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub executed: Option<u64>,
    /// Time of the program in seconds, as `motion` estimates it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time_s: Option<Number>,
    /// Some blocks have no known time: the time is at least this.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub lower_bound: bool,
    /// Path in mm by type of motion.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub path_mm_by_type: BTreeMap<String, Number>,
    /// How far motions reach.
    #[serde(default)]
    pub extents: Extents,
    /// Tools: T written, and tools in the spindle.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tools: Vec<u32>,
    /// M functions used.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub m: Vec<u8>,
    /// G functions used.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub g: Vec<u8>,
    /// H used.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub h: Vec<Number>,
    /// Subprograms that run.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub subprograms: Vec<u32>,
    /// Macrocycles that run.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub macrocycles: Vec<u32>,
    /// Parameters that are read before the program gives them a value: `R10`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parameters: Vec<String>,
    /// How many findings of each code there are.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub findings: BTreeMap<String, u64>,
}

/// All programs.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields, title = "Programs of an archive cnc872c.stats/1")]
#[expect(dead_code, reason = "the schema is all it is for: rows are written one by one")]
struct Document {
    /// `cnc872c.stats/1`.
    #[schemars(extend("const" = SCHEMA))]
    schema: String,
    /// The programs, in the order in which they were named or found.
    programs: Vec<Row>,
}

/// The schema, JSON Schema 2020-12.
pub fn schema() -> Value {
    document_schema::<Document>(SCHEMA)
}
