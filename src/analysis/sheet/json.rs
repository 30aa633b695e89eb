//! The set-up sheet as JSON `cnc872c.report/1`, and its schema.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;

use super::block_name::BlockName;
use super::extents::Extents;
use super::reader::{Sheet, ToolUse};
use crate::analysis::motion::Summary;
use crate::analysis::{Number, document_schema};
use crate::dict::AxisLetter;

/// Name and version of the form.
pub const SCHEMA: &str = "cnc872c.report/1";

/// Least and greatest position by axis, and what is missing in them.
#[derive(Serialize, JsonSchema)]
#[schemars(inline)]
struct Reach {
    /// By letter; an axis of which no position is known is in `lower_bound_axes` only.
    #[serde(flatten)]
    axes: BTreeMap<String, [Number; 2]>,
    /// Some motions are not known: the extent is at least this.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    lower_bound: bool,
    /// The axes that go at least so far.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    lower_bound_axes: Vec<String>,
    /// The numbers of the blocks whose motions are missing, in the order in which they are executed first; the first
    /// 100.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    unknown_blocks: Vec<u32>,
}

/// The set-up sheet of a program. What is `false`, empty or absent is left out.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields, title = "Set-up sheet cnc872c.report/1")]
struct Record {
    /// `cnc872c.report/1`.
    #[schemars(extend("const" = SCHEMA))]
    schema: String,
    /// Name and version of the compiler.
    generator: String,
    /// The program, as the user named it.
    name: String,
    /// The number after `%`.
    #[serde(skip_serializing_if = "Option::is_none")]
    number: Option<u32>,
    /// The title.
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<String>,
    /// The control.
    #[schemars(extend("enum" = ["cnc8x6", "cnc8x9", "cnc872"]))]
    dialect: String,
    /// A lathe: X of all extents is a diameter.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    diameter: bool,
    /// Time of the program, as `motion` estimates it.
    time_s: Number,
    /// The machine of the estimate is not configured.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    assumed: bool,
    /// Some blocks have no known time: the time is at least this.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    lower_bound: bool,
    /// How far motions reach, in programmed coordinates.
    extents: ExtentsRecord,
    /// Tools in the order in which they come into the spindle.
    tools: Vec<ToolRecord>,
    /// M functions by number.
    m_functions: Vec<MRecord>,
    /// Parameters that are read before the program gives them a value.
    parameters: Vec<ParameterRecord>,
    /// Subprograms and macrocycles in the order in which they run first.
    units: Vec<UnitRecord>,
}

/// How far motions reach.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct ExtentsRecord {
    /// G01, G02, G03.
    working: Reach,
    /// All motions.
    all: Reach,
}

/// A tool.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct ToolRecord {
    /// Its number; none before the first M06.
    #[serde(skip_serializing_if = "Option::is_none")]
    t: Option<Number>,
    /// The first block with it.
    n: u32,
    /// The macrocycle that this block belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    l: Option<u32>,
    /// How often M06 is executed with it; 0 before the first M06.
    changes: u64,
    /// Duration of the blocks with it.
    time_s: Number,
    /// Some blocks with it have no known time: the time is at least this.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    time_lower_bound: bool,
    /// Path of working motion; none where nothing of it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    working_mm: Option<Number>,
    /// Some working motions have no known length: the path is at least this.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    working_lower_bound: bool,
    /// Path of G00; none where nothing of it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    rapid_mm: Option<Number>,
    /// Some motions by G00 have no known length: the path is at least this.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    rapid_lower_bound: bool,
    /// F of working motion as it acts, M37 included, by what it counts.
    feeds: Vec<FeedRecord>,
    /// S of working motion and of fixed cycles, rev/min: least and greatest.
    #[serde(skip_serializing_if = "Option::is_none")]
    speeds: Option<[Number; 2]>,
    /// S under constant cutting speed: least and greatest.
    #[serde(skip_serializing_if = "Option::is_none")]
    cutting_speeds: Option<[Number; 2]>,
    /// D of working motion.
    d: Vec<Number>,
    /// F, S, D: those of which some values are not known.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    undetermined: Vec<String>,
    /// How far working motion reaches.
    extents: Reach,
}

/// F.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct FeedRecord {
    /// The unit of F.
    #[schemars(extend("enum" = ["mm/min", "mm/rev", "deg/min", "deg/rev"]))]
    unit: String,
    /// The least.
    min: Number,
    /// The greatest.
    max: Number,
}

/// An M function.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct MRecord {
    /// Its number.
    no: u8,
    /// How often it is executed.
    count: u64,
    /// The first block with it.
    n: u32,
    /// The macrocycle that this block belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    l: Option<u32>,
}

/// A parameter.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct ParameterRecord {
    /// Its number.
    r: u8,
    /// The value that it holds at the start.
    #[serde(skip_serializing_if = "Option::is_none")]
    value: Option<Number>,
    /// The first block that reads it.
    n: u32,
    /// The macrocycle that this block belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    l: Option<u32>,
}

/// A subprogram or macrocycle.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct UnitRecord {
    /// Its number.
    l: u32,
    /// Subprogram or macrocycle.
    #[schemars(extend("enum" = ["subprogram", "macrocycle"]))]
    kind: String,
    /// How often it runs: passes.
    runs: u64,
}

/// The schema, JSON Schema 2020-12.
pub fn schema() -> Value {
    document_schema::<Record>(SCHEMA)
}

/// The sheet, pretty, with a line end; `assumed`: the machine is not configured.
pub fn json(sheet: &Sheet, summary: &Summary, assumed: bool) -> String {
    let head = &sheet.head;
    let record = Record {
        schema: SCHEMA.to_owned(),
        generator: concat!("cnc872c ", env!("CARGO_PKG_VERSION")).to_owned(),
        name: head.name.clone(),
        number: head.number,
        title: head.title.clone(),
        dialect: head.dialect.to_owned(),
        diameter: head.diameter,
        time_s: summary.total.time_s.into(),
        assumed,
        lower_bound: summary.total.is_lower_bound(),
        extents: ExtentsRecord { working: reach(&sheet.size.working), all: reach(&sheet.size.all) },
        tools: sheet.tools.iter().map(|used| tool(used, summary)).collect(),
        m_functions: sheet
            .m_functions
            .iter()
            .map(|(number, used)| MRecord { no: *number, count: used.count, n: used.first.n, l: used.first.l })
            .collect(),
        parameters: sheet
            .parameters
            .iter()
            .map(|(index, used)| {
                let BlockName { n, l } = used.first;
                ParameterRecord { r: *index, value: used.value.map(Number::from), n, l }
            })
            .collect(),
        units: sheet
            .units
            .iter()
            .map(|unit| UnitRecord {
                l: unit.l,
                kind: if unit.macrocycle { "macrocycle" } else { "subprogram" }.to_owned(),
                runs: unit.runs,
            })
            .collect(),
    };
    // Numbers and texts always have a JSON.
    serde_json::to_string_pretty(&record).unwrap_or_default() + "\n"
}

fn tool(used: &ToolUse, summary: &Summary) -> ToolRecord {
    let total = summary.of_tool(used.tool);
    ToolRecord {
        t: used.tool.map(Number::from),
        n: used.first.n,
        l: used.first.l,
        changes: used.changes,
        time_s: total.time_s.into(),
        time_lower_bound: total.is_lower_bound(),
        working_mm: used.working.known().map(Number),
        working_lower_bound: used.working.is_lower_bound(),
        rapid_mm: used.rapid.known().map(Number),
        rapid_lower_bound: used.rapid.is_lower_bound(),
        feeds: used
            .feeds
            .iter()
            .map(|(unit, (min, max))| FeedRecord { unit: unit.name().to_owned(), min: Number(*min), max: Number(*max) })
            .collect(),
        speeds: used.speeds.map(|(least, greatest)| [least.into(), greatest.into()]),
        cutting_speeds: used.cutting_speeds.map(|(least, greatest)| [least.into(), greatest.into()]),
        d: used.d.iter().map(|d| Number::from(*d)).collect(),
        undetermined: used.undetermined.iter().map(|address| address.letter().to_string()).collect(),
        extents: reach(&used.extents),
    }
}

fn reach(extents: &Extents) -> Reach {
    let known = |(letter, reach): (AxisLetter, super::Reach)| {
        reach.known.map(|(least, greatest)| (letter.to_string(), [Number(least), Number(greatest)]))
    };
    let lower_bound_axes: Vec<String> =
        extents.axes().filter(|(_, reach)| reach.lacks).map(|(letter, _)| letter.to_string()).collect();
    Reach {
        axes: extents.axes().filter_map(known).collect(),
        lower_bound: !lower_bound_axes.is_empty(),
        lower_bound_axes,
        unknown_blocks: extents.unknown_blocks().iter().map(|block| block.n).collect(),
    }
}
