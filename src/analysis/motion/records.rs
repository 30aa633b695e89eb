//! The records of the motion stream `cnc872c.motion/1`, in the order in which their fields are written, and their
//! schema.
//! `json` fills them. What is `false`, empty or absent is left out.

use schemars::JsonSchema;
use serde::{Serialize, Serializer};
use serde_json::Value;

use super::times::{Break, CapBy, Limit};
use super::{Profile, Recognition};
use crate::analysis::json::Pairs;
use crate::analysis::{Number, record_schema};

/// Name and version of the form.
pub const SCHEMA: &str = "cnc872c.motion/1";

type Numbers = Pairs<String, Number>;
type Counts = Pairs<&'static str, u64>;

/// A line.
#[derive(JsonSchema, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
#[schemars(title = "Record of the motion stream cnc872c.motion/1")]
pub(super) enum Record<'a> {
    Machine(&'a MachineRecord<'a>),
    Block(&'a BlockRecord),
    Total(&'a TotalRecord),
}

/// The first record: the machine that the times are of. What is off or absent is left out.
#[derive(Default, JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
pub(super) struct MachineRecord<'a> {
    /// `cnc872c.motion/1`.
    #[schemars(extend("const" = SCHEMA))]
    pub schema: &'a str,
    /// Name and version of the compiler.
    pub generator: &'a str,
    /// The program, as the user named it.
    pub name: &'a str,
    /// Nothing is configured: all is assumed.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub assumed: bool,
    /// Course of the velocity.
    #[schemars(extend("enum" = Profile::ALL.map(Profile::name)))]
    pub profile: &'a str,
    /// How joints are recognised.
    #[schemars(extend("enum" = Recognition::ALL.map(Recognition::name)))]
    pub recognition: &'a str,
    /// Interpolation cycle Ts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycle_ms: Option<Number>,
    /// Tolerance angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(required)]
    pub angle_deg: Option<Number>,
    /// Acceleration of working motion outside continuity.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(required)]
    pub accel_mm_s2: Option<Number>,
    /// Acceleration of working motion within continuity.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(required)]
    pub accel_continuous_mm_s2: Option<Number>,
    /// Acceleration of G00; none where `sets.rapid` gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accel_rapid_mm_s2: Option<Number>,
    /// Shortest time of a block.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shortest_block_ms: Option<Number>,
    /// A shorter block breaks continuity.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub break_length_mm: Option<Number>,
    /// A shorter linear block is joined to its neighbour.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub merge_length_mm: Option<Number>,
    /// Criterion of accuracy.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accuracy_um: Option<Number>,
    /// A slower joint has a red dot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub red_percent: Option<Number>,
    /// Dynamic criterion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub overload_mm_s2: Option<Number>,
    /// In a shorter block the velocity does not rise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub raise_length_mm: Option<Number>,
    /// Time criterion for a rise of velocity.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(required)]
    pub raise_ms: Option<Number>,
    /// Blocks that the control sees.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(required, with = "u64")]
    pub look_ahead: Option<Number>,
    /// Greatest centripetal acceleration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centripetal_mm_s2: Option<Number>,
    /// Speed to assume where S is a cutting speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub constant_cutting_rpm: Option<Number>,
    /// Wait at the end of a motion that is not continued.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub settle_ms: Option<Number>,
    /// Gap before each block in G98.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub block_gap_ms: Option<Number>,
    /// Velocity of G00 along the path.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rapid_mm_min: Option<Number>,
    /// Velocity of G00 by axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rapid_axes_mm_min: Option<Numbers>,
    /// Dynamic sets: 1 to 4, and that of G00.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sets: Option<Pairs<&'static str, SetRecord>>,
    /// Seconds that functions take.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub times: Option<Numbers>,
    /// Where each value comes from: a key of the project file, a machine constant, `--set`, or `default`.
    pub from: Pairs<String, &'a str>,
}

/// A dynamic set. A text is the parameter that holds the value.
#[derive(Default, JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
pub(super) struct SetRecord {
    /// Parabolic acceleration P.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parabolic: Option<NumberOrParameter>,
    /// Linear acceleration A.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub linear_mm_s2: Option<NumberOrParameter>,
    /// Criterion of accuracy.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accuracy_um: Option<NumberOrParameter>,
    /// Dynamic criterion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub overload_mm_s2: Option<NumberOrParameter>,
    /// Greatest centripetal acceleration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centripetal_mm_s2: Option<NumberOrParameter>,
}

#[derive(JsonSchema, Serialize)]
#[serde(untagged)]
pub(super) enum NumberOrParameter {
    Number(Number),
    Parameter(String),
}

/// An executed block. Velocities in mm/min, or deg/min where only rotary axes move.
#[derive(JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
pub(super) struct BlockRecord {
    /// As in the block stream.
    pub seq: u64,
    /// Block number.
    pub n: u32,
    /// Index of the file, as in the block stream.
    pub file: u32,
    /// Line of the `N`, from 1.
    pub line: u32,
    /// When it starts, from program start.
    pub start_s: Number,
    /// How long it takes.
    pub duration_s: Number,
    /// Programmed velocity.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub programmed: Option<Number>,
    /// Greatest velocity in the block.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cap: Option<Number>,
    /// What gives it.
    #[schemars(extend("enum" = CapBy::ALL.map(CapBy::name)))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cap_by: Option<&'static str>,
    /// Velocity at its start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start: Option<Number>,
    /// The greatest velocity that it reaches.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak: Option<Number>,
    /// Velocity at its end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end: Option<Number>,
    /// Motion time from its start to the end of its stretch.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_dist_s: Option<Number>,
    /// It is part of a piece whose record is another one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub merged: Option<bool>,
    /// Length of the piece that other blocks are joined to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub piece_mm: Option<Number>,
    /// The joint with the motion before.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint: Option<JointRecord>,
    /// Duration in s, start velocity in mm/s, acceleration in mm/s², jerk in mm/s³; twelve significant digits. Phases
    /// shorter than 1e-12 s are left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub phases: Option<Vec<[Digits; 4]>>,
}

/// A number with twelve significant digits.
#[derive(Clone, Copy, JsonSchema)]
#[schemars(inline)]
pub(super) struct Digits(pub f64);

impl Serialize for Digits {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(twelve_digits(self.0))
    }
}

/// With twelve significant digits.
pub(crate) fn twelve_digits(value: f64) -> f64 {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    // A negative zero is a zero.
    rounded + 0.0
}

/// A joint.
#[derive(JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
pub(super) struct JointRecord {
    /// `seq` of the motion before; none at the first motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub with: Option<u64>,
    /// Angle between the tangents.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<Number>,
    /// It is passed continuously.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub continuous: Option<bool>,
    /// What breaks it.
    #[schemars(extend("enum" = breaks()))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub broken_by: Option<&'static str>,
    /// Velocity at the joint.
    pub feed: Number,
    /// What gives this velocity.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(required, extend("enum" = limits()))]
    pub limited_by: Option<&'static str>,
    /// The dot that the control shows.
    #[schemars(extend("enum" = ["yellow", "red"]))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dot: Option<&'static str>,
}

/// What breaks joints, as in records.
fn breaks() -> Vec<&'static str> {
    Break::ALL.map(Break::name).to_vec()
}

/// What gives the velocity at joints, as in records: for a broken one what breaks it.
fn limits() -> Vec<&'static str> {
    Limit::ALL.into_iter().map(Limit::name).chain(breaks()).collect()
}

/// The last record: the program ended without errors.
#[derive(JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
pub(super) struct TotalRecord {
    /// Time of the program.
    pub time_s: Number,
    /// Each block at its programmed velocity, no ramps.
    pub ideal_s: Number,
    /// The same limits with infinite jerk, no time criterion; parabolic only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_jerk_s: Option<Number>,
    /// Some blocks have no known time, or no known limit of jerk: the time is at least this.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lower_bound: Option<bool>,
    /// Blocks without known time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unknown_blocks: Option<u64>,
    /// Motion times by type.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_by_type: Option<Numbers>,
    /// Dwell.
    pub dwell_s: Number,
    /// Functions.
    pub function_s: Number,
    /// Waits at the end of motions.
    pub settle_s: Number,
    /// Gaps before blocks.
    pub gap_s: Number,
    /// Durations by the tool in the spindle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_by_tool: Option<Numbers>,
    /// Joints.
    pub joints: JointsRecord,
    /// Continuous joints by what limits them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limited: Option<Counts>,
    /// Dots.
    pub dots: DotsRecord,
    /// Mean velocity of working motion, mm/min.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_feed: Option<Number>,
}

/// Joints of a program.
#[derive(JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
pub(super) struct JointsRecord {
    /// Those that are passed continuously.
    pub continuous: u64,
    /// Others by reason.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub broken: Option<Counts>,
}

/// Dots of a program.
#[derive(JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
pub(super) struct DotsRecord {
    /// Yellow ones.
    pub yellow: u64,
    /// Red ones.
    pub red: u64,
}

/// The schema of a line, JSON Schema 2020-12.
pub fn schema() -> Value {
    record_schema::<Record<'_>>(SCHEMA)
}
