//! The changes as JSON `cnc872c.compare/1`, and its schema.

use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;
use serde_json::{Value as Json, json};

use super::changes::{Blocks, Change, ChangeKind, merged};
use super::steps::Value;
use super::text::{head, line};
use crate::analysis::{Number, document_schema};
use crate::dict::{Lang, Micro};
use crate::text::last_name;

/// Name and version of the form.
pub const SCHEMA: &str = "cnc872c.compare/1";

/// So many changes stand one by one on a page.
const LISTED: usize = 10_000;

/// One of the programs.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// As the user named it.
    pub name: String,
    /// Blocks executed.
    pub blocks: u64,
    /// The sum of known lengths.
    pub path: Micro,
    /// The known time.
    pub time_s: Option<f64>,
    /// It was executed to its end, without errors.
    pub whole: bool,
}

impl Side {
    /// The same by the name of its file alone: a page holds no folder of the computer that made it.
    fn without_folder(&self) -> Self {
        Self { name: last_name(Path::new(&self.name)), ..self.clone() }
    }
}

/// Two programs compared.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields, title = "Comparison cnc872c.compare/1")]
struct Record {
    /// `compare`.
    #[schemars(extend("const" = "compare"))]
    kind: String,
    /// `cnc872c.compare/1`.
    #[schemars(extend("const" = SCHEMA))]
    schema: String,
    /// Name and version of the compiler.
    generator: String,
    /// Whether nothing differs.
    same: bool,
    /// The first program.
    old: SideRecord,
    /// The second program.
    new: SideRecord,
    /// What differs, in the order of first places.
    changes: Vec<ChangeRecord>,
}

/// A program.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct SideRecord {
    /// As the user named it.
    name: String,
    /// Blocks executed.
    blocks: u64,
    /// The sum of known lengths.
    path_mm: Number,
    /// The known time, as `motion` estimates it.
    #[serde(skip_serializing_if = "Option::is_none")]
    time_s: Option<Number>,
}

/// A change.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct ChangeRecord {
    /// What kind.
    #[schemars(extend("enum" = ChangeKind::ALL.map(ChangeKind::name)))]
    kind: String,
    /// The tool in the spindle, of the new program; of the old one where only that has blocks.
    #[serde(skip_serializing_if = "Option::is_none")]
    tool: Option<Number>,
    /// How many blocks.
    count: u64,
    /// Axis, function or address.
    #[serde(skip_serializing_if = "Option::is_none")]
    what: Option<String>,
    /// The old value: a number, or a function or words as written.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Scalar>")]
    old: Option<Json>,
    /// The new value.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Scalar>")]
    new: Option<Json>,
    /// The difference, where it is one number.
    #[serde(skip_serializing_if = "Option::is_none")]
    delta: Option<Number>,
    /// Executed blocks of the old program: from and to, by seq.
    old_blocks: Vec<[u32; 2]>,
    /// Executed blocks of the new program.
    new_blocks: Vec<[u32; 2]>,
}

/// A value.
#[derive(JsonSchema)]
#[schemars(inline, untagged)]
#[expect(dead_code, reason = "only its schema is used")]
enum Scalar {
    /// A number.
    Number(f64),
    /// A function, or words.
    Text(String),
}

/// The schema, JSON Schema 2020-12.
pub fn schema() -> Json {
    document_schema::<Record>(SCHEMA)
}

/// The comparison, pretty, with a line end.
pub fn json(old: &Side, new: &Side, changes: &[Change]) -> String {
    // Numbers and texts always have a JSON.
    serde_json::to_string_pretty(&record(old, new, changes)).unwrap_or_default() + "\n"
}

fn record(old: &Side, new: &Side, changes: &[Change]) -> Record {
    Record {
        kind: "compare".to_owned(),
        schema: SCHEMA.to_owned(),
        generator: concat!("cnc872c ", env!("CARGO_PKG_VERSION")).to_owned(),
        same: changes.is_empty(),
        old: side(old),
        new: side(new),
        changes: changes.iter().map(change).collect(),
    }
}

/// The comparison for a page: the record with its texts in both languages. Changes beyond the first `LISTED` are one
/// `rest`.
pub fn for_page(old: &Side, new: &Side, changes: &[Change]) -> Json {
    let (listed, rest) = changes.split_at(changes.len().min(LISTED));
    let in_both = |text: &dyn Fn(Lang) -> Json| json!({ "en": text(Lang::En), "cs": text(Lang::Cs) });
    let (old, new) = (&old.without_folder(), &new.without_folder());
    let Json::Object(mut page) = json!(record(old, new, listed)) else { return Json::Null };
    let mut put = |name: &str, value: Json| drop(page.insert(name.to_owned(), value));
    put("same", json!(changes.is_empty()));
    put("head", in_both(&|lang| json!(head(old, new, changes, lang))));
    put("texts", in_both(&|lang| listed.iter().map(|change| line(change, lang)).collect()));
    if !rest.is_empty() {
        let blocks =
            |of: fn(&Change) -> &Blocks| merged(rest.iter().flat_map(|change| of(change).runs.iter().copied()));
        put(
            "rest",
            json!({
                "count": rest.len(),
                "old_blocks": blocks(|change| &change.old_blocks),
                "new_blocks": blocks(|change| &change.new_blocks),
            }),
        );
    }
    Json::Object(page)
}

fn side(side: &Side) -> SideRecord {
    let Side { name, blocks, path, time_s, whole: _ } = side;
    SideRecord { name: name.clone(), blocks: *blocks, path_mm: Number(*path), time_s: time_s.map(Number::from) }
}

fn change(change: &Change) -> ChangeRecord {
    let value = |value: &Value| match value {
        Value::Number(number) => json!(Number(Micro::from_millionths(*number))),
        Value::Text(text) => json!(text),
    };
    let runs = |blocks: &Blocks| blocks.runs.clone();
    ChangeRecord {
        kind: change.kind.name().to_owned(),
        tool: change.tool.map(Number::from),
        count: change.count(),
        what: change.what.as_ref().map(ToString::to_string),
        old: change.old.as_ref().map(value),
        new: change.new.as_ref().map(value),
        delta: change.delta.map(|delta| Number(Micro::from_millionths(delta))),
        old_blocks: runs(&change.old_blocks),
        new_blocks: runs(&change.new_blocks),
    }
}
