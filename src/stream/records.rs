//! The records of the stream, one type a kind, and the list of the kinds. Fields that are `false`,
//! empty or absent are left out when written, except where a field says otherwise.

use std::collections::BTreeMap;

use schemars::JsonSchema;

use crate::dict::{AxisLetter, Decimal, Dialect, Micro};
use crate::run::{FeedUnit, Jump, MStop, Missing, MotionType};

/// Name and version of the stream's form.
pub const SCHEMA: &str = "cnc872c.blocks/2";

// The list of the kinds of records, for writing and schema alike.
/// One line of the stream.
#[derive(Debug, JsonSchema)]
#[schemars(tag = "kind", rename_all = "lowercase", title = "Record of the block stream cnc872c.blocks/2")]
pub enum Record {
    Program(Box<ProgramRecord>),
    File(FileRecord),
    #[expect(dead_code, reason = "blocks come by the million: they are handed on in batches, without the box")]
    Block(Box<BlockRecord>),
    End(EndRecord),
}

/// The first record: what the stream was made from and for.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ProgramRecord {
    /// `cnc872c.blocks/2`.
    #[schemars(extend("const" = SCHEMA))]
    pub schema: String,
    /// Name and version of the compiler.
    pub generator: String,
    /// The control.
    #[schemars(extend("enum" = Dialect::ALL.map(Dialect::name)))]
    pub dialect: String,
    /// The number after `%`.
    pub number: u32,
    /// The title (BLK-9).
    pub title: Option<String>,
    /// All comments between the number and the first `N`, the title included; empty ones left out.
    #[schemars(default)]
    pub comments: Vec<String>,
    /// The program, as the user named it; its index is 0.
    pub name: String,
    /// The axes, in the order of the machine.
    pub axes: Vec<AxisRecord>,
    /// Whether skippable blocks were left out.
    #[schemars(default)]
    pub block_skip: bool,
    /// Whether M01 stops.
    #[schemars(default)]
    pub optional_stop: bool,
    /// Values of parameters given for program start.
    #[schemars(with = "Numbers", default)]
    pub parameters: Vec<(u8, Decimal)>,
    /// Programmed positions given for program start.
    #[schemars(with = "Numbers", default)]
    pub start: AxisMap,
    /// The gear table (MFN-9).
    #[schemars(default)]
    pub gears: Vec<GearRecord>,
    /// Fixed cycles that are macrocycles: number of the macrocycle by function (GRP-6).
    #[schemars(with = "BTreeMap<String, u32>", default)]
    pub cycles: Vec<(u8, u32)>,
    /// What G97 means (TEC-5).
    #[schemars(extend("enum" = ["per-minute", "per-revolution"]))]
    pub g97: String,
    /// Which axes I and J of an arc belong to (MOT-3).
    #[schemars(extend("enum" = ["machine-order", "plane-order"]))]
    pub arc_centers: String,
    /// How far the radii of an arc may differ, in mm (MOT-4).
    #[schemars(with = "f64")]
    pub arc_tolerance: Decimal,
    /// The axis that the spindle is under M19; left out when there is none (MFN-10).
    #[schemars(with = "Option<String>")]
    pub spindle_axis: Option<AxisLetter>,
    /// Every M function that configuration names, by number.
    #[schemars(default)]
    pub m_functions: Vec<MFunctionRecord>,
}

/// A gear.
#[derive(Clone, Copy, Debug, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearRecord {
    /// 41–44.
    pub m: u8,
    /// Least speed in rev/min.
    pub min: u32,
    /// Greatest speed in rev/min.
    pub max: u32,
    /// The part of the converter's range at the greatest speed; left out when all of it (PLC-8).
    #[schemars(with = "Option<f64>")]
    pub output: Option<Decimal>,
}

/// An axis of the machine.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AxisRecord {
    /// Its letter.
    pub letter: String,
    /// How it moves.
    #[schemars(extend("enum" = ["linear", "rotary"]))]
    pub kind: String,
}

/// An M function that configuration names.
#[derive(Clone, Copy, Debug, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MFunctionRecord {
    /// Its number.
    pub no: u8,
    /// Its group.
    pub group: u8,
    /// Breaks continuous motion at the start of the block.
    #[schemars(default)]
    pub break_cont: bool,
    /// Breaks continuous motion at the end of the block.
    #[schemars(default)]
    pub break_cont_end: bool,
    /// Moves the machine.
    #[schemars(default)]
    pub change_pos: bool,
}

/// Before the first record that comes from another file.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FileRecord {
    /// 1, 2 …
    pub index: u32,
    /// The macrocycle's path as found.
    pub name: String,
}

/// A value for some axes, by letter.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct AxisMap {
    /// Zero where an axis has no value.
    values: [Micro; 9],
    /// Which axes have one, a bit each.
    present: u16,
}

impl AxisMap {
    /// Sets the value of an axis.
    pub fn set(&mut self, axis: AxisLetter, value: Option<Micro>) {
        if let Some(slot) = self.values.get_mut(axis as usize) {
            *slot = value.unwrap_or_default();
        }
        let bit = 1 << axis as u16;
        self.present = if value.is_some() { self.present | bit } else { self.present & !bit };
    }

    /// The value of an axis.
    #[inline]
    pub fn get(&self, axis: AxisLetter) -> Option<Micro> {
        self.values.get(axis as usize).copied().filter(|_| self.present & (1 << axis as u16) != 0)
    }

    /// Whether no axis has a value.
    pub const fn is_empty(&self) -> bool {
        self.present == 0
    }
}

/// Some axes, in machine order.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct AxisList {
    letters: [Option<AxisLetter>; 9],
    count: usize,
}

impl AxisList {
    /// Adds an axis at the end.
    #[inline]
    pub fn push(&mut self, axis: AxisLetter) {
        if let Some(slot) = self.letters.get_mut(self.count) {
            *slot = Some(axis);
            self.count += 1;
        }
    }

    /// In order.
    pub fn iter(&self) -> impl Iterator<Item = AxisLetter> + '_ {
        self.letters.iter().copied().flatten()
    }
}

type Numbers = BTreeMap<String, f64>;

/// One executed block.
#[derive(Debug, Default, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BlockRecord {
    /// 0, 1, 2 …
    pub seq: u64,
    /// Block number.
    pub n: u32,
    /// Index of the file.
    pub file: u32,
    /// Line of the `N`, from 1.
    pub line: u32,
    /// Column of the `N` in characters, from 1.
    pub column: u32,
    /// How execution got here, outermost first.
    #[schemars(default)]
    pub calls: Vec<Call>,
    /// The jump that is taken at the end of this block.
    #[schemars(with = "Option<JumpRecord>")]
    pub jump: Option<Jump>,
    /// The block carries `/` (and was executed).
    #[schemars(default)]
    pub skippable: bool,
    /// First executed block of the program.
    #[schemars(default)]
    pub first_block: bool,
    /// Last executed block of the program.
    #[schemars(default)]
    pub last_block: bool,
    /// For each G group what is in force in this block, x functions included.
    pub g: [Option<u8>; 12],
    /// G functions written in this block, in written order.
    #[schemars(default)]
    pub g_set: Vec<u8>,
    /// By group, 0 always null: what is in force after this block; groups 1, 7, 9 only here.
    pub m: [Option<u8>; 15],
    /// M functions written in this block, in written order.
    #[schemars(default)]
    pub m_set: Vec<u8>,
    /// Groups with a change bit (MFN-6), ascending.
    #[schemars(default)]
    pub m_changed: Vec<u8>,
    /// Values of groups 2, 5, 6 while the program stands (MFN-8).
    #[schemars(with = "Option<BTreeMap<String, u8>>")]
    pub m_at_stop: Option<MStop>,
    /// Some M of this block breaks continuous motion at its start.
    #[schemars(default)]
    pub break_cont: bool,
    /// Some M of this block breaks continuous motion at its end.
    #[schemars(default)]
    pub break_cont_end: bool,
    /// Some M of this block moves the machine.
    #[schemars(default)]
    pub change_pos: bool,
    /// 1–4: M41–M44 in force, or what M40 chose (MFN-9).
    pub gear: Option<u8>,
    /// The motion of the block.
    pub motion: Option<Motion>,
    /// AxNC: every axis whose programmed position is known, after the block.
    #[schemars(with = "Numbers", default)]
    pub position: AxisMap,
    /// FeedProgr, as programmed.
    #[schemars(with = "Option<f64>")]
    pub feed: Option<Decimal>,
    /// What `feed` counts in this block.
    #[schemars(with = "Option<FeedUnitName>")]
    pub feed_unit: Option<FeedUnit>,
    /// 0.01 under M37: the machine moves at a hundredth of `feed` (TEC-6).
    #[schemars(with = "Option<f64>")]
    pub feed_scale: Option<Decimal>,
    /// The tool in the spindle: T at the last M06.
    #[schemars(with = "Option<u32>")]
    pub tool: Option<Decimal>,
    /// RevFeed: the feed counts per revolution.
    #[schemars(default)]
    pub rev_feed: bool,
    /// ConstCutSpeed: the cutting speed is constant.
    #[schemars(default)]
    pub const_cut_speed: bool,
    /// SpindleSpeed, rev/min.
    #[schemars(with = "Option<u32>")]
    pub s: Option<Decimal>,
    /// T in force.
    #[schemars(with = "Option<u32>")]
    pub t: Option<Decimal>,
    /// H in force.
    #[schemars(with = "Option<f64>")]
    pub h: Option<Decimal>,
    /// P in force.
    #[schemars(with = "Option<u32>")]
    pub p: Option<Decimal>,
    /// D in force.
    #[schemars(with = "Option<u32>")]
    pub d: Option<Decimal>,
    /// T is written in this block (TProg).
    #[schemars(default)]
    pub t_set: bool,
    /// H is written in this block (HProg).
    #[schemars(default)]
    pub h_set: bool,
    /// P is written in this block.
    #[schemars(default)]
    pub p_set: bool,
    /// D is written in this block.
    #[schemars(default)]
    pub d_set: bool,
    /// S is written in this block.
    #[schemars(default)]
    pub s_set: bool,
    /// F is written in this block.
    #[schemars(default)]
    pub f_set: bool,
    /// The four digits of `&` in force.
    #[schemars(with = "Option<String>")]
    pub length_correction: Option<u16>,
    /// Delay, in seconds.
    #[schemars(with = "Option<f64>")]
    pub dwell_s: Option<Micro>,
    /// M00.
    #[schemars(default)]
    pub stop: bool,
    /// M01; whether it halts follows from `optional_stop` of the first record.
    #[schemars(default)]
    pub cond_stop: bool,
    /// ContinuousMode: G23 in force.
    #[schemars(default)]
    pub continuous_mode: bool,
    /// Under G23: 1, until G23 with I chooses another, 1–4 (GRP-7).
    pub dynamic_set: Option<u8>,
    /// The number of the macrocycle that it calls at its end and that only the machine has (FLW-12): the axes that it
    /// may move are unknown after it.
    pub opaque_call: Option<u32>,
    /// Words that are data (GRP-4).
    pub data: Option<Data>,
    /// Words as written: I, J, K (GRP-8), axes under a fixed cycle that nothing maps (GRP-6).
    #[schemars(with = "Numbers", default)]
    pub words: Vec<(char, Decimal)>,
    /// Parameters this block wrote, with their values after its arithmetic.
    #[schemars(with = "Numbers", default)]
    pub params: Vec<(u8, Decimal)>,
    /// Texts of its comments, trimmed, empty ones left out.
    #[schemars(default)]
    pub comments: Vec<String>,
}

impl Clone for BlockRecord {
    fn clone(&self) -> Self {
        let mut clone = Self::default();
        clone.clone_from(self);
        clone
    }

    /// Uses the memory of its lists again: records are handed on by the million.
    fn clone_from(&mut self, source: &Self) {
        fn again<T: Clone>(list: &mut Vec<T>, source: &Vec<T>) -> Vec<T> {
            let mut list = std::mem::take(list);
            list.clone_from(source);
            list
        }
        *self = Self {
            calls: again(&mut self.calls, &source.calls),
            g_set: again(&mut self.g_set, &source.g_set),
            m_set: again(&mut self.m_set, &source.m_set),
            m_changed: again(&mut self.m_changed, &source.m_changed),
            data: source.data.clone(),
            words: again(&mut self.words, &source.words),
            params: again(&mut self.params, &source.params),
            comments: again(&mut self.comments, &source.comments),
            // Numbers and flags.
            ..*source
        };
    }
}

/// What calls.
pub const CALLS_BY: [&str; 11] = ["G71", "G72", "G81", "G82", "G83", "G84", "G85", "G86", "G87", "G88", "G89"];

/// One call on the way to a block.
#[derive(Clone, Copy, Debug, Eq, JsonSchema, PartialEq)]
#[schemars(deny_unknown_fields)]
pub struct Call {
    /// G71, G72, or a fixed cycle by the cycle map.
    #[schemars(extend("enum" = CALLS_BY))]
    pub by: &'static str,
    /// What was called.
    pub l: u32,
    /// File of the calling block.
    pub file: u32,
    /// Number of the calling block.
    pub n: u32,
    /// Line of the calling block, from 1.
    pub line: u32,
    /// Which pass this is, from 1.
    pub pass: u32,
    /// Of how many.
    pub of: u32,
}

/// The schema of a jump.
#[derive(JsonSchema)]
#[schemars(rename = "Jump", deny_unknown_fields)]
#[expect(dead_code, reason = "the schema is all it is for")]
pub struct JumpRecord {
    /// The block jumped to.
    to: u32,
    /// The counter after lowering; left out when uncounted.
    left: Option<u32>,
}

/// The schema of the kinds of motion.
#[derive(JsonSchema)]
#[schemars(rename = "MotionType", rename_all = "snake_case")]
#[expect(dead_code, reason = "the schema is all it is for")]
pub enum MotionName {
    /// G00.
    Rapid,
    /// G01.
    Linear,
    /// G02.
    ArcCw,
    /// G03.
    ArcCcw,
    /// G33.
    Thread,
    /// G30.
    Reference,
}

/// The schema of the reasons why a length is missing.
#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
#[expect(dead_code, reason = "the schema is all it is for")]
pub enum MissingName {
    /// A distance is not known (MOT-2).
    Start,
    /// The start is not where the tool stands (MOT-8).
    Origin,
    /// A motion to the reference point (MOT-7).
    Reference,
}

/// The schema of what a feed counts.
#[derive(JsonSchema)]
#[expect(dead_code, reason = "the schema is all it is for")]
pub enum FeedUnitName {
    /// Feed per minute.
    #[schemars(rename = "mm/min")]
    MmPerMinute,
    /// Feed per revolution.
    #[schemars(rename = "mm/rev")]
    MmPerRevolution,
    /// Only rotary axes or the spindle move.
    #[schemars(rename = "deg/min")]
    DegPerMinute,
    /// The same per revolution.
    #[schemars(rename = "deg/rev")]
    DegPerRevolution,
}

/// The motion of a block.
#[derive(Clone, Copy, Debug, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Motion {
    /// What kind.
    #[schemars(rename = "type", with = "MotionName")]
    pub kind: MotionType,
    /// Axes that move, in machine order (AxNCxMove): those written in the block, and both of an arc.
    #[schemars(with = "Vec<String>")]
    pub axes: AxisList,
    /// Where these axes stand before, as far as known.
    #[schemars(with = "Numbers", default)]
    pub start: AxisMap,
    /// Distances of axes moved by G91 from an unknown position (MOT-2).
    #[schemars(with = "Numbers", default)]
    pub delta: AxisMap,
    /// BlockLen in mm (MOT-6).
    #[schemars(with = "Option<f64>")]
    pub length_mm: Option<Micro>,
    /// BlockLen in degrees, when rotary axes only move.
    #[schemars(with = "Option<f64>")]
    pub length_deg: Option<Micro>,
    /// Why neither length is there.
    #[schemars(with = "Option<MissingName>")]
    pub length_missing: Option<Missing>,
    /// Arcs: `XY`, `YZ`, `ZX`, else the two letters, first-named first.
    #[schemars(with = "Option<String>")]
    pub plane: Option<[AxisLetter; 2]>,
    /// Arcs: the centre, absolute.
    #[schemars(with = "Numbers", default)]
    pub center: AxisMap,
    /// Arcs: the radius at the start.
    #[schemars(with = "Option<f64>")]
    pub radius_mm: Option<Micro>,
    /// Arcs: the angle turned through, positive, up to 360.
    #[schemars(with = "Option<f64>")]
    pub sweep_deg: Option<Micro>,
    /// The axis that is the spindle (M19), when it moves.
    #[schemars(with = "Option<String>")]
    pub spindle_axis: Option<AxisLetter>,
}

/// Words of a block that are data and move nothing (GRP-4).
#[derive(Clone, Debug, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Data {
    /// The function that makes them data.
    pub g: u8,
    /// The G5 function in force, for G92 and G93.
    pub origin: Option<u8>,
    /// D, when written.
    #[schemars(with = "Option<u32>")]
    pub d: Option<Decimal>,
    /// The words, as programmed.
    #[schemars(with = "Numbers", default)]
    pub values: Vec<(char, Decimal)>,
}

/// The last record. A stream is complete when it has it.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct EndRecord {
    /// What ended the program.
    #[schemars(extend("enum" = ["M02", "M30"]))]
    pub reason: String,
    /// Block records of the program, all of them.
    pub blocks: u64,
    /// Exact sum of the written `length_mm`.
    #[schemars(with = "f64")]
    pub path_mm: Micro,
    /// The same by motion type.
    #[schemars(with = "Numbers", default)]
    pub path_mm_by_type: Vec<(MotionType, Micro)>,
}
