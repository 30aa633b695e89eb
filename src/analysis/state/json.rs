//! What holds at a place as JSON `cnc872c.state/1`, and its schema.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;

use super::found::{CounterAt, Found};
use super::place::CallAt;
use super::unknown::Unknown;
use super::writers::{Slot, Written, is_momentary};
use crate::analysis::{Number, document_schema};
use crate::config::Settings;
use crate::dict::{GCode, GGroup, M_GROUPS, Micro};

/// Name and version of the form.
pub const SCHEMA: &str = "cnc872c.state/1";

/// What holds at a place of a program. Of the fields that the block record has as well, those that are `false`, empty
/// or absent are left out, as there.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields, title = "State at a place cnc872c.state/1")]
struct Record {
    /// `state`.
    #[schemars(extend("const" = "state"))]
    kind: String,
    /// `cnc872c.state/1`.
    #[schemars(extend("const" = SCHEMA))]
    schema: String,
    /// Name and version of the compiler.
    generator: String,
    /// The program, as the user named it.
    name: String,
    /// Where.
    place: PlaceRecord,
    /// For each G group what is in force; functions that hold for one block only are not.
    g: [Option<u8>; 12],
    /// By group, 0 always null: what is in force; null in groups 1, 7 and 9.
    m: [Option<u8>; 15],
    /// 1–4: M41–M44 in force, or what M40 chose.
    #[serde(skip_serializing_if = "Option::is_none")]
    gear: Option<u8>,
    /// Every axis whose programmed position is known.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    #[schemars(default)]
    position: BTreeMap<String, Number>,
    /// F, as programmed.
    #[serde(skip_serializing_if = "Option::is_none")]
    feed: Option<Number>,
    /// What F counts by the G6 function in force, in a motion measured in millimetres.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("enum" = ["mm/min", "mm/rev", "deg/min", "deg/rev"]))]
    feed_unit: Option<String>,
    /// 0.01 under M37.
    #[serde(skip_serializing_if = "Option::is_none")]
    feed_scale: Option<Number>,
    /// S.
    #[serde(skip_serializing_if = "Option::is_none")]
    s: Option<Number>,
    /// T.
    #[serde(skip_serializing_if = "Option::is_none")]
    t: Option<Number>,
    /// The tool in the spindle: T at the last M06.
    #[serde(skip_serializing_if = "Option::is_none")]
    tool: Option<Number>,
    /// H.
    #[serde(skip_serializing_if = "Option::is_none")]
    h: Option<Number>,
    /// P.
    #[serde(skip_serializing_if = "Option::is_none")]
    p: Option<Number>,
    /// D.
    #[serde(skip_serializing_if = "Option::is_none")]
    d: Option<Number>,
    /// The four digits of `&`.
    #[serde(skip_serializing_if = "Option::is_none")]
    length_correction: Option<String>,
    /// The dynamic set.
    #[serde(skip_serializing_if = "Option::is_none")]
    dynamic_set: Option<u8>,
    /// G23 in force.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    #[schemars(default)]
    continuous_mode: bool,
    /// Why the position of an axis that the program moves is not known.
    unknown: BTreeMap<String, Reason>,
    /// Every parameter whose value is known.
    parameters: BTreeMap<String, Number>,
    /// The block that wrote something last: by `g3`, `m2`, `feed`, `R10`, `X`. What is not there holds since power-up.
    written: BTreeMap<String, WrittenRecord>,
    /// Armed counters of jumps, outermost call first.
    counters: Vec<CounterRecord>,
    /// What is done, and what is left.
    progress: ProgressRecord,
}

/// A place.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct PlaceRecord {
    /// Which executed block, from 0.
    seq: u64,
    /// Its number.
    n: u32,
    /// Index of its file, as the block stream counts.
    file: u32,
    /// The line of its `N`.
    line: u32,
    /// The column of its `N`.
    column: u32,
    /// How execution gets there, outermost first.
    calls: Vec<CallRecord>,
    /// Behind the block, not before it.
    after: bool,
}

/// A call.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct CallRecord {
    /// `G71`, `G72`, `G81`–`G89`.
    by: String,
    /// What was called.
    l: u32,
    /// Index of the file of the calling block.
    file: u32,
    /// The number of the calling block.
    n: u32,
    /// The line of its `N`.
    line: u32,
    /// Which pass, from 1.
    pass: u32,
    /// Of how many.
    of: u32,
}

/// A block that wrote something.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct WrittenRecord {
    /// Which executed block.
    seq: u64,
    /// Its number.
    n: u32,
    /// Index of its file.
    file: u32,
    /// The line of its `N`.
    line: u32,
}

/// A counter.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct CounterRecord {
    /// The number of the jump's block.
    n: u32,
    /// Index of its file.
    file: u32,
    /// The line of its `N`.
    line: u32,
    /// Jumps left.
    left: u32,
    /// Of how many.
    of: u32,
}

/// What is done, and what is left.
#[derive(Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
struct ProgressRecord {
    /// Blocks executed before the place.
    blocks: u64,
    /// Blocks from the place on.
    blocks_left: u64,
    /// Their known path.
    path_mm: Number,
    /// The known path from the place on: at least this.
    path_left_mm: Number,
    /// Time up to the place, as `motion` estimates it. Left out in programs of more than a million executed blocks,
    /// unless motion is configured.
    #[serde(skip_serializing_if = "Option::is_none")]
    time_s: Option<Number>,
    /// Time from the place on, likewise.
    #[serde(skip_serializing_if = "Option::is_none")]
    time_left_s: Option<Number>,
    /// Some times are not known, or the program does not get to its end: there is at least this.
    lower_bound: bool,
    /// The next executed block with M06.
    #[serde(skip_serializing_if = "Option::is_none")]
    next_tool_change: Option<u64>,
    /// The next one at which the program stops: M00, or M01 with optional stop.
    #[serde(skip_serializing_if = "Option::is_none")]
    next_stop: Option<u64>,
}

/// Why a position is not known.
#[derive(Serialize, JsonSchema)]
#[schemars(inline)]
struct Reason(#[schemars(extend("enum" = Unknown::ALL.map(Unknown::name)))] String);

/// The schema, JSON Schema 2020-12.
pub fn schema() -> Value {
    document_schema::<Record>(SCHEMA)
}

/// What was found in the program of that name, pretty, with a line end.
pub fn json(found: &Found, name: &str, settings: &Settings) -> String {
    // Numbers and texts always have a JSON.
    serde_json::to_string_pretty(&record(found, name, settings)).unwrap_or_default() + "\n"
}

/// The same as a value.
pub fn document(found: &Found, name: &str, settings: &Settings) -> Value {
    serde_json::to_value(record(found, name, settings)).unwrap_or_default()
}

fn record(found: &Found, name: &str, settings: &Settings) -> Record {
    let (state, machine) = (&found.state, &settings.machine);
    let feed = state.feed(machine);
    let axes = machine.axes.iter().enumerate();
    let positions = axes.filter_map(|(at, axis)| Some((axis.letter.to_string(), Number(state.axis_position(at)?))));
    let parameters = (0..96).filter_map(|index| Some((format!("R{index}"), state.parameter(index)?.into())));
    let m = |group: usize| state.m_in_force(group).filter(|_| group < M_GROUPS && !is_momentary(group));
    Record {
        kind: "state".to_owned(),
        schema: SCHEMA.to_owned(),
        generator: concat!("cnc872c ", env!("CARGO_PKG_VERSION")).to_owned(),
        name: name.to_owned(),
        place: PlaceRecord {
            seq: found.seq,
            n: found.n,
            file: found.file,
            line: found.line,
            column: found.column,
            calls: found.calls.iter().map(call).collect(),
            after: found.after,
        },
        g: GGroup::ALL.map(|group| state.g_in_force(group).map(GCode::number)),
        m: std::array::from_fn(m),
        gear: state.gear_in_force(),
        position: positions.collect(),
        feed: feed.map(|feed| feed.value.into()),
        feed_unit: feed.map(|feed| feed.unit.name().to_owned()),
        feed_scale: state.feed_is_hundredth().then_some(Number(Micro::from_millionths(10_000))),
        s: state.s().map(Number::from),
        t: state.t().map(Number::from),
        tool: state.tool_in_spindle().map(Number::from),
        h: state.h().map(Number::from),
        p: state.p().map(Number::from),
        d: state.d().map(Number::from),
        length_correction: state.length_correction().map(|digits| format!("{digits:04}")),
        dynamic_set: state.dynamic_set(),
        continuous_mode: state.g_in_force(GGroup::G2) == Some(GCode::G23),
        unknown: found.unknown.iter().map(|(axis, why)| (axis.to_string(), Reason(why.name().to_owned()))).collect(),
        parameters: parameters.collect(),
        written: found.written.iter().map(written).collect(),
        counters: found.counters.iter().map(counter).collect(),
        progress: progress(found),
    }
}

fn call(call: &CallAt) -> CallRecord {
    let CallAt { by, l, file, n, line, pass, of } = *call;
    CallRecord { by: by.to_owned(), l, file, n, line, pass, of }
}

fn written((slot, written): &(Slot, Written)) -> (String, WrittenRecord) {
    let Written { seq, n, file, line, call: _ } = *written;
    (slot.name(), WrittenRecord { seq, n, file, line })
}

const fn counter(counter: &CounterAt) -> CounterRecord {
    let CounterAt { n, file, line, left, of } = *counter;
    CounterRecord { n, file, line, left, of }
}

fn progress(found: &Found) -> ProgressRecord {
    ProgressRecord {
        blocks: found.blocks.done,
        blocks_left: found.blocks.left,
        path_mm: Number(found.path.done),
        path_left_mm: Number(found.path.left),
        time_s: found.times.map(|times| times.seconds.done.into()),
        time_left_s: found.times.map(|times| times.seconds.left.into()),
        lower_bound: found.is_lower_bound(),
        next_tool_change: found.next_tool_change,
        next_stop: found.next_stop,
    }
}
