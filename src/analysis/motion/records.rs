//! The records of the motion stream `cnc872c.motion/1`, for its schema. They are written by `json`, one field after the
//! other; what is `false`, empty or absent is left out.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde_json::Value;

use super::times::{Break, CapBy, Limit};
use super::{Profile, Recognition};
use crate::analysis::record_schema;

/// Name and version of the form.
pub const SCHEMA: &str = "cnc872c.motion/1";

type Numbers = BTreeMap<String, f64>;
type Counts = BTreeMap<String, u64>;

/// A line.
#[derive(JsonSchema)]
#[schemars(tag = "kind", rename_all = "lowercase", title = "Record of the motion stream cnc872c.motion/1")]
#[expect(dead_code, reason = "the schema is all it is for: records are written field by field")]
enum Record {
    Machine(Box<MachineRecord>),
    Block(Box<BlockRecord>),
    Total(Box<TotalRecord>),
}

/// The first record: the machine that the times are of. What is off or absent is left out.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct MachineRecord {
    /// `cnc872c.motion/1`.
    #[schemars(extend("const" = SCHEMA))]
    schema: String,
    /// Name and version of the compiler.
    generator: String,
    /// The program, as the user named it.
    name: String,
    /// Nothing is configured: all is assumed.
    #[schemars(default)]
    assumed: bool,
    /// Course of the velocity.
    #[schemars(extend("enum" = Profile::ALL.map(Profile::name)))]
    profile: String,
    /// How joints are recognised.
    #[schemars(extend("enum" = Recognition::ALL.map(Recognition::name)))]
    recognition: String,
    /// Interpolation cycle Ts.
    cycle_ms: Option<f64>,
    /// Tolerance angle.
    angle_deg: f64,
    /// Acceleration of working motion outside continuity.
    accel_mm_s2: f64,
    /// Acceleration of working motion within continuity.
    accel_continuous_mm_s2: f64,
    /// Acceleration of G00; none where `sets.rapid` gives it.
    accel_rapid_mm_s2: Option<f64>,
    /// Velocity of G00 along the path.
    rapid_mm_min: Option<f64>,
    /// Velocity of G00 by axis.
    rapid_axes_mm_min: Option<Numbers>,
    /// Shortest time of a block.
    shortest_block_ms: Option<f64>,
    /// A shorter block breaks continuity.
    break_length_mm: Option<f64>,
    /// A shorter linear block is joined to its neighbour.
    merge_length_mm: Option<f64>,
    /// Criterion of accuracy.
    accuracy_um: Option<f64>,
    /// A slower joint has a red dot.
    red_percent: Option<f64>,
    /// Dynamic criterion.
    overload_mm_s2: Option<f64>,
    /// In a shorter block the velocity does not rise.
    raise_length_mm: Option<f64>,
    /// Time criterion for a rise of velocity.
    raise_ms: f64,
    /// Blocks that the control sees.
    look_ahead: u64,
    /// Greatest centripetal acceleration.
    centripetal_mm_s2: Option<f64>,
    /// Speed to assume where S is a cutting speed.
    constant_cutting_rpm: Option<f64>,
    /// Wait at the end of a motion that is not continued.
    settle_ms: Option<f64>,
    /// Gap before each block in G98.
    block_gap_ms: Option<f64>,
    /// Dynamic sets: 1 to 4, and that of G00.
    sets: Option<BTreeMap<String, SetRecord>>,
    /// Seconds that functions take.
    times: Option<Numbers>,
    /// Where each value comes from: a key of the project file, a machine constant, `--set`, or `default`.
    from: BTreeMap<String, String>,
}

/// A dynamic set. A text is the parameter that holds the value.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct SetRecord {
    /// Parabolic acceleration P.
    parabolic: Option<NumberOrParameter>,
    /// Linear acceleration A.
    linear_mm_s2: Option<NumberOrParameter>,
    /// Criterion of accuracy.
    accuracy_um: Option<NumberOrParameter>,
    /// Dynamic criterion.
    overload_mm_s2: Option<NumberOrParameter>,
    /// Greatest centripetal acceleration.
    centripetal_mm_s2: Option<NumberOrParameter>,
}

#[derive(JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "as above")]
enum NumberOrParameter {
    Number(f64),
    Parameter(String),
}

/// An executed block. Velocities in mm/min, or deg/min where only rotary axes move.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct BlockRecord {
    /// As in the block stream.
    seq: u64,
    /// Block number.
    n: u32,
    /// Index of the file, as in the block stream.
    file: u32,
    /// Line of the `N`, from 1.
    line: u32,
    /// When it starts, from program start.
    start_s: f64,
    /// How long it takes.
    duration_s: f64,
    /// Programmed velocity.
    programmed: Option<f64>,
    /// Greatest velocity in the block.
    cap: Option<f64>,
    /// What gives it.
    #[schemars(extend("enum" = CapBy::ALL.map(CapBy::name)))]
    cap_by: Option<String>,
    /// Velocity at its start.
    start: Option<f64>,
    /// The greatest velocity that it reaches.
    peak: Option<f64>,
    /// Velocity at its end.
    end: Option<f64>,
    /// Motion time from its start to the end of its stretch.
    time_dist_s: Option<f64>,
    /// It is part of a piece whose record is another one.
    merged: Option<bool>,
    /// Length of the piece that other blocks are joined to.
    piece_mm: Option<f64>,
    /// The joint with the motion before.
    joint: Option<JointRecord>,
    /// Duration in s, start velocity in mm/s, acceleration in mm/s², jerk in mm/s³; twelve significant digits. Phases
    /// shorter than 1e-12 s are left out.
    phases: Option<Vec<[f64; 4]>>,
}

/// A joint.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct JointRecord {
    /// `seq` of the motion before; none at the first motion.
    with: Option<u64>,
    /// Angle between the tangents.
    angle_deg: Option<f64>,
    /// It is passed continuously.
    continuous: Option<bool>,
    /// What breaks it.
    #[schemars(extend("enum" = breaks()))]
    broken_by: Option<String>,
    /// Velocity at the joint.
    feed: f64,
    /// What gives this velocity.
    #[schemars(extend("enum" = limits()))]
    limited_by: String,
    /// The dot that the control shows.
    #[schemars(extend("enum" = ["yellow", "red"]))]
    dot: Option<String>,
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
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct TotalRecord {
    /// Time of the program.
    time_s: f64,
    /// Each block at its programmed velocity, no ramps.
    ideal_s: f64,
    /// The same limits with infinite jerk, no time criterion; parabolic only.
    no_jerk_s: Option<f64>,
    /// Some blocks have no known time, or no known limit of jerk: the time is at least this.
    lower_bound: Option<bool>,
    /// Blocks without known time.
    unknown_blocks: Option<u64>,
    /// Motion times by type.
    time_by_type: Option<Numbers>,
    /// Dwell.
    dwell_s: f64,
    /// Functions.
    function_s: f64,
    /// Waits at the end of motions.
    settle_s: f64,
    /// Gaps before blocks.
    gap_s: f64,
    /// Durations by the tool in the spindle.
    time_by_tool: Option<Numbers>,
    /// Joints.
    joints: JointsRecord,
    /// Continuous joints by what limits them.
    limited: Option<Counts>,
    /// Dots.
    dots: DotsRecord,
    /// Mean velocity of working motion, mm/min.
    mean_feed: Option<f64>,
}

/// Joints of a program.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct JointsRecord {
    /// Those that are passed continuously.
    continuous: u64,
    /// Others by reason.
    broken: Option<Counts>,
}

/// Dots of a program.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct DotsRecord {
    /// Yellow ones.
    yellow: u64,
    /// Red ones.
    red: u64,
}

/// The schema of a line, JSON Schema 2020-12.
pub fn schema() -> Value {
    record_schema::<Record>(SCHEMA)
}
