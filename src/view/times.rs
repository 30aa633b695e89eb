//! Velocities, joints and times of executed blocks, packed: what the page can foretell costs nothing, only what differs
//! is kept. `web/src/data/times.ts` foretells the same way.

use std::collections::{HashMap, VecDeque};
use std::hash::{DefaultHasher, Hash, Hasher};

use serde_json::{Map, Value, json};

use super::column::Column;
use super::foretold::{Limits, PER_FEED, Programmed, correction, feed, float, gained, is_near, whole};
use super::parts::Interned;
use super::picture::MOST_YELLOW;
use super::rows::{Keep, Part, Rows};
use super::tangents::angle_deg;
use crate::analysis::motion::{BlockTimes, Break, Dot, Limit, Listener, MotionTimes, Total};
use crate::run::MotionType;
use crate::sure::small;

/// Angles are whole parts of a degree.
const PER_DEGREE: f64 = 200.0;
/// Equal executions of a loop are found among so many at most.
const REMEMBERED: usize = 1 << 21;
/// No velocity at a joint.
const NONE_YET: i64 = i64::MIN;
/// Microseconds that a time may differ before it is corrected.
const SLACK_US: i64 = 200;

/// What the planner said of an executed block: feeds in parts of a mm/min or deg/min, 0 where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Planned {
    /// What is no motion, in microseconds.
    other_us: i64,
    /// In mm or degrees, of the piece when blocks are joined.
    length: f64,
    programmed: i64,
    cap: i64,
    /// At the start, the greatest, at the end.
    velocities: [i64; 3],
    /// At the joint before; 0 where it is broken.
    joint: i64,
    /// At the joint before.
    angle_deg: f32,
    /// How many blocks before this the motion before the joint is.
    with: u32,
    /// Index in the codes.
    code: u32,
}

/// Bits of what a record has.
mod has {
    pub(super) const MOTION: u16 = 1;
    pub(super) const PROGRAMMED: u16 = 1 << 1;
    pub(super) const CAP: u16 = 1 << 2;
    pub(super) const VELOCITIES: u16 = 1 << 3;
    pub(super) const JOINT: u16 = 1 << 4;
    pub(super) const ANGLE: u16 = 1 << 5;
    pub(super) const WITH: u16 = 1 << 6;
    pub(super) const PIECE: u16 = 1 << 7;
    pub(super) const UNKNOWN: u16 = 1 << 8;
    pub(super) const STRETCH: u16 = 1 << 9;
    pub(super) const MERGED: u16 = 1 << 10;
    pub(super) const RAPID: u16 = 1 << 11;
}

/// What many motions have in common.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, PartialEq)]
struct Code {
    has: u16,
    cap_by: Option<&'static str>,
    broken_by: Option<&'static str>,
    limited_by: Option<&'static str>,
    dot: Option<&'static str>,
    accel: u8,
    /// The base of the foretold velocity at the joint: the caps of both blocks (0), the joint before (1), behind (2).
    joint: u8,
    /// The base of the foretold greatest velocity: cap and acceleration (0), the velocities at both ends (1).
    peak: u8,
}

impl Code {
    const fn has(self, bit: u16) -> bool {
        self.has & bit != 0
    }

    /// Whether the joint before the motion is passed.
    const fn is_continuous(self) -> bool {
        self.has(has::JOINT) && self.broken_by.is_none()
    }

    fn json(&self) -> Value {
        let mut code = Map::new();
        let mut put = |name: &str, value: Value| drop(code.insert(name.to_owned(), value));
        put("has", json!(self.has));
        for (name, value) in
            [("cap_by", self.cap_by), ("broken_by", self.broken_by), ("limited_by", self.limited_by), ("dot", self.dot)]
        {
            if let Some(value) = value {
                put(name, json!(value));
            }
        }
        for (name, value) in [("a", self.accel), ("j", self.joint), ("k", self.peak)] {
            if value != 0 {
                put(name, json!(value));
            }
        }
        Value::Object(code)
    }
}

/// Of an executed block that goes to the planner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Expected {
    /// The acceleration of its dynamic set, in mm/s².
    pub accel: f64,
    /// Whether it is an execution that the rows have: what is planned of it may be known as well.
    pub again: bool,
}

/// Collects what the planner gives.
#[derive(Clone, Debug, Default)]
pub(super) struct Times {
    part: Part,
    /// Dots alone are wanted.
    dots_only: bool,
    dots: Dots,
    /// What was planned, equal executions of a loop once.
    planned: Vec<Planned>,
    /// By executed block: the index of what was planned.
    plan_of: Column,
    /// By executed block, and of the one behind the last: when it starts, in seconds.
    starts: Vec<f64>,
    /// Of executions that the rows had: where they are in `planned`, by their hash.
    equal: HashMap<u64, u32>,
    known: Interned<Code>,
    codes: Vec<Code>,
    /// Accelerations of motions, in mm/s².
    accels: Vec<f64>,
    /// Of blocks that are not planned yet.
    waiting: VecDeque<Expected>,
    /// Of motions outside of stretches: working, rapid.
    alone: [f64; 2],
    end_s: f64,
    beyond: Beyond,
    total: Total,
}

/// The rest of the stretch in which the part ends.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Beyond {
    /// The velocity at its first joint, in parts of a mm/min.
    feed: Option<i64>,
    /// How long its motions take, in seconds.
    rest_s: f64,
    /// It has ended.
    is_over: bool,
}

impl Beyond {
    fn pass(&mut self, block: &BlockTimes) {
        let motion = block.motion.as_ref();
        let joint = motion.filter(|motion| motion.stretch.is_some()).and_then(|motion| motion.joint.as_ref());
        let merged = motion.is_some_and(|motion| motion.merged);
        let goes_on = merged || joint.is_some_and(|joint| joint.broken_by.is_none());
        self.is_over |= !goes_on;
        if !self.is_over {
            self.feed = self.feed.or(joint.map(|joint| feed(joint.velocity)));
            self.rest_s += block.duration_s - other_s(block);
        }
    }

    fn feed(&self) -> i64 {
        self.feed.unwrap_or_default()
    }

    /// For the header of a page.
    pub fn json(&self) -> Value {
        json!({ "feed": self.feed(), "rest_s": self.rest_s })
    }
}

/// How long a block takes without its motion, in seconds.
const fn other_s(block: &BlockTimes) -> f64 {
    block.dwell_s + block.function_s + block.settle_s + block.gap_s
}

/// The packed times.
#[derive(Debug, Default)]
pub(super) struct PackedTimes {
    pub columns: Vec<(String, Column)>,
    pub codes: Vec<Value>,
    pub accels: Vec<f64>,
    /// When the first block starts.
    pub start_s: f64,
    pub beyond: Beyond,
}

impl Times {
    /// Of the blocks of a part. `alone`: accelerations of working motion and of G00 outside of stretches.
    pub fn new(part: Part, keep: Keep, alone: [f64; 2]) -> Self {
        Self { part, dots_only: keep == Keep::Geometry, alone, ..Self::default() }
    }

    /// A block goes to the planner.
    pub fn expect(&mut self, expected: Expected) {
        self.waiting.push_back(expected);
    }

    /// The index of an acceleration.
    fn accel(&mut self, accel: f64) -> u8 {
        let known = self.accels.iter().position(|known| known.to_bits() == accel.to_bits());
        let index = known.unwrap_or_else(|| {
            self.accels.push(accel);
            self.accels.len() - 1
        });
        u8::try_from(index).unwrap_or(u8::MAX)
    }

    /// How long all of the program takes, and what of it is not known.
    pub const fn total(&self) -> &Total {
        &self.total
    }

    /// The dots of the executed blocks in the picture.
    pub const fn dots(&self) -> &Dots {
        &self.dots
    }

    /// Packs the times of the executed blocks that `rows` has.
    pub fn pack(&self, rows: &Rows) -> PackedTimes {
        Packer::new(self, rows).pack()
    }
}

impl Listener for Times {
    fn block(&mut self, block: &BlockTimes) {
        let Some(expected) = self.waiting.pop_front() else { return };
        self.end_s = block.start_s + block.duration_s;
        self.total.add(block);
        if !self.part.has(block.seq) {
            if block.seq >= self.part.from && self.starts.len() == self.plan_of.len() && !self.dots_only {
                self.starts.push(block.start_s);
            }
            if block.seq >= self.part.from {
                self.beyond.pass(block);
            }
            return;
        }
        if self.dots_only {
            let joint = block.motion.as_ref().and_then(|motion| motion.joint.as_ref());
            self.dots.add(block.seq - self.part.from, joint.and_then(|joint| joint.dot));
            return;
        }
        let [working, rapid] = self.alone;
        let accel = match &block.motion {
            None => 0,
            Some(motion) if motion.stretch.is_some() => self.accel(expected.accel),
            Some(motion) if motion.kind == MotionType::Rapid => self.accel(rapid),
            Some(_) => self.accel(working),
        };
        let mut code = Code { accel, ..Code::default() };
        if block.unknown {
            code.has |= has::UNKNOWN;
        }
        let mut planned = Planned { other_us: whole(other_s(block) * 1e6), ..Planned::default() };
        if let Some(motion) = &block.motion {
            describe(motion, &mut code);
            planned.length = motion.length.unwrap_or_default();
            planned.programmed = motion.programmed.map_or(0, feed);
            planned.cap = motion.cap.map_or(0, |(cap, _)| feed(cap));
            planned.velocities = motion.velocities.map_or([0; 3], |all| [all.start, all.peak, all.end].map(feed));
            if let Some(joint) = &motion.joint {
                planned.joint = if joint.broken_by.is_none() { feed(joint.velocity) } else { 0 };
                planned.angle_deg = narrow(joint.angle_deg.unwrap_or_default());
                planned.with =
                    joint.with.map_or(0, |with| u32::try_from(block.seq.saturating_sub(with)).unwrap_or(u32::MAX));
            }
        }
        let Self { known, codes, .. } = self;
        planned.code = known.get(code, || {
            codes.push(code);
            Value::Null
        });
        self.starts.push(block.start_s);
        let index = self.index(planned, expected.again);
        self.plan_of.push(i64::from(index));
    }
}

impl Times {
    /// Where something planned is among all.
    fn index(&mut self, planned: Planned, again: bool) -> u32 {
        let next = small(self.planned.len());
        if again {
            let hash = planned.hash();
            let known = self.equal.get(&hash).copied();
            let equal = known.filter(|index| self.planned.get(*index as usize) == Some(&planned));
            if let Some(equal) = equal {
                return equal;
            }
            if self.equal.len() < REMEMBERED {
                self.equal.insert(hash, next);
            }
        }
        self.planned.push(planned);
        next
    }
}

impl Planned {
    fn hash(&self) -> u64 {
        let Self { other_us, length, programmed, cap, velocities, joint, angle_deg, with, code } = self;
        let mut hash = DefaultHasher::new();
        (other_us, length.to_bits(), programmed, cap, velocities, joint).hash(&mut hash);
        (angle_deg.to_bits(), with, code).hash(&mut hash);
        hash.finish()
    }
}

/// The dots of a still picture, as indices of executed blocks.
#[derive(Clone, Debug, Default)]
pub(super) struct Dots {
    /// The first ones; those beyond [`MOST_YELLOW`] are counted.
    pub yellow: Vec<u32>,
    pub yellow_count: usize,
    pub red: Vec<u32>,
}

impl Dots {
    fn add(&mut self, index: u64, dot: Option<Dot>) {
        let index = u32::try_from(index).unwrap_or(u32::MAX);
        match dot {
            Some(Dot::Red) => self.red.push(index),
            Some(Dot::Yellow) => {
                self.yellow_count += 1;
                if self.yellow.len() < MOST_YELLOW {
                    self.yellow.push(index);
                }
            }
            None => {}
        }
    }
}

/// Angles have no finer parts than [`PER_DEGREE`] of a degree.
#[expect(clippy::cast_possible_truncation, reason = "seven digits are more than enough")]
const fn narrow(angle: f64) -> f32 {
    angle as f32
}

struct Packer<'t> {
    times: &'t Times,
    rows: &'t Rows,
    /// How many executed blocks.
    count: usize,
    /// Of motions with velocities, in order: where they are in `planned`.
    timed: Vec<u32>,
    /// By place in `timed`: the velocity at the joint before, as the reader will have it; [`NONE_YET`] at first.
    joints: Vec<i64>,
    modes: Vec<u8>,
}

impl<'t> Packer<'t> {
    fn new(times: &'t Times, rows: &'t Rows) -> Self {
        let count = rows.count().min(times.plan_of.len());
        let mut packer = Self { times, rows, count, timed: Vec::new(), joints: Vec::new(), modes: Vec::new() };
        packer.timed = (0..count).filter(|index| packer.code(*index).has(has::VELOCITIES)).map(small).collect();
        packer.joints = vec![NONE_YET; packer.timed.len()];
        packer.modes = vec![0; packer.timed.len()];
        packer
    }

    /// What was planned of an executed block.
    fn planned(&self, index: usize) -> Option<&'t Planned> {
        let plan = self.times.plan_of.get(index).filter(|_| index < self.count)?;
        self.times.planned.get(usize::try_from(plan).ok()?)
    }

    fn code(&self, index: usize) -> Code {
        let code = self.planned(index).and_then(|planned| self.times.codes.get(planned.code as usize));
        code.copied().unwrap_or_default()
    }

    /// The motion at a place in `timed`.
    fn motion(&self, place: usize) -> Option<(&'t Planned, Code)> {
        let index = *self.timed.get(place)? as usize;
        Some((self.planned(index)?, self.code(index)))
    }

    fn accel(&self, code: Code) -> f64 {
        self.times.accels.get(usize::from(code.accel)).copied().unwrap_or_default()
    }

    fn pack(mut self) -> PackedTimes {
        let mut joint = Column::default();
        self.plan_joints(&mut joint);
        let mut columns = self.columns();
        columns.push(("time.joint".to_owned(), joint));
        let (codes, coded) = self.codes();
        columns.extend(coded);
        let (accels, beyond) = (self.times.accels.clone(), self.times.beyond);
        PackedTimes { columns, codes, accels, start_s: self.start_s(), beyond }
    }

    /// Decides what each joint is foretold from. Joints at a cap first, then those of rising velocity in the order of
    /// the program, then those of falling velocity backwards; the reader does the same.
    fn plan_joints(&mut self, corrections: &mut Column) {
        let places = self.timed.len();
        let mut ramps = Vec::new();
        let mut corrected = vec![0_i64; places];
        for place in 0..places {
            let Some((motion, code)) = self.motion(place) else { continue };
            let truth = motion.joint;
            if !code.is_continuous() {
                self.set_joint(place, 0, 0);
                continue;
            }
            let caps = self.caps(place);
            if is_near(truth, caps) || !matches!(code.limited_by, Some("ramp" | "look_ahead")) {
                let by = correction(truth, caps);
                if let Some(slot) = corrected.get_mut(place) {
                    *slot = by;
                }
                self.set_joint(place, 0, caps + by);
            } else {
                ramps.push(place);
            }
        }
        // Rising: from the joint before.
        ramps.retain(|&place| {
            let foretold = self.risen(place);
            let truth = self.motion(place).map_or(0, |(motion, _)| motion.joint);
            let rises = foretold.is_some_and(|foretold| is_near(truth, foretold));
            if rises {
                self.set_joint(place, 1, foretold.unwrap_or_default());
            }
            !rises
        });
        for &place in ramps.iter().rev() {
            let truth = self.motion(place).map_or(0, |(motion, _)| motion.joint);
            let (mode, base) = self.fallen(place).map_or_else(|| (0, self.caps(place)), |fallen| (2, fallen));
            let by = correction(truth, base);
            if let Some(slot) = corrected.get_mut(place) {
                *slot = by;
            }
            self.set_joint(place, mode, base + by);
        }
        for by in corrected {
            corrections.push(by);
        }
    }

    /// The lesser of the caps on both sides of the joint before a motion.
    fn caps(&self, place: usize) -> i64 {
        let cap = |place: usize| self.motion(place).map_or(0, |(motion, _)| motion.cap);
        place.checked_sub(1).map_or(0, cap).min(cap(place))
    }

    fn set_joint(&mut self, place: usize, mode: u8, velocity: i64) {
        if let Some(slot) = self.joints.get_mut(place) {
            *slot = velocity;
        }
        if let Some(slot) = self.modes.get_mut(place) {
            *slot = mode;
        }
    }

    fn joint(&self, place: usize) -> Option<i64> {
        self.joints.get(place).copied().filter(|joint| *joint != NONE_YET)
    }

    /// What acceleration over the motion before leads to.
    fn risen(&self, place: usize) -> Option<i64> {
        let before = place.checked_sub(1)?;
        let (motion, code) = self.motion(before)?;
        let start = float(self.joint(before)?);
        Some(whole((start * start + gained(self.accel(code), motion.length)).sqrt()))
    }

    /// What deceleration over the motion itself comes from.
    fn fallen(&self, place: usize) -> Option<i64> {
        let (motion, code) = self.motion(place)?;
        let end = float(self.passed_at(place + 1)?);
        Some(whole((end * end + gained(self.accel(code), motion.length)).sqrt()))
    }

    /// Velocities of a timed motion as the reader foretells them: at the start, at the end.
    fn ends(&self, place: usize) -> [i64; 2] {
        let start = self.joint(place).unwrap_or_default();
        [start, self.passed_at(place + 1).unwrap_or_default()]
    }

    /// The velocity at the joint before a motion, which may lie beyond the part; `None`: it is not foretold yet.
    fn passed_at(&self, place: usize) -> Option<i64> {
        match self.motion(place) {
            Some((_, motion)) if motion.is_continuous() => self.joint(place),
            Some(_) => Some(0),
            None => Some(self.times.beyond.feed()),
        }
    }

    /// The greatest velocity as the reader foretells it.
    fn peak(&self, motion: &Planned, code: Code, [start, end]: [i64; 2], mode: u8) -> i64 {
        if mode == 1 {
            return start.max(end);
        }
        let (from, to) = (float(start), float(end));
        let reached = ((from * from + to * to) / 2.0 + gained(self.accel(code), motion.length) / 2.0).sqrt();
        motion.cap.min(whole(reached)).max(start.max(end))
    }

    fn columns(&self) -> Vec<(String, Column)> {
        let mut programmed = Programmed::default();
        let [mut feeds, mut caps, mut other, mut angle, mut with, mut piece] = <[Column; 6]>::default();
        let mut last_motion = None;
        let mut limits = Limits::default();
        for index in 0..self.count {
            let Some(planned) = self.planned(index) else { continue };
            let code = self.code(index);
            other.push(planned.other_us);
            if code.has(has::PROGRAMMED) {
                let rapid = code.has(has::RAPID);
                let fed = self.rows.row(index).and_then(|row| self.rows.fed(row)).filter(|_| !rapid);
                feeds.push(programmed.correction(rapid, fed, planned.programmed));
            }
            if let (true, Some(by)) = (code.has(has::CAP), code.cap_by) {
                let foretold = match by {
                    "feed" | "rapid" => planned.programmed,
                    other => limits.foretell(other, planned.length),
                };
                let wrong = correction(planned.cap, foretold);
                caps.push(wrong);
                limits.learn(by, planned.length, foretold + wrong);
            }
            if code.has(has::PIECE) {
                piece.push(whole(planned.length * 1e6));
            }
            if code.has(has::WITH) {
                let expected = last_motion.map_or(0, |last: usize| index - last);
                with.push(i64::from(planned.with) - i64::try_from(expected).unwrap_or_default());
            }
            if code.has(has::ANGLE) {
                let before = index.checked_sub(planned.with as usize);
                let foretold = before.map_or(0.0, |before| angle_deg(self.rows, before, index));
                let wrong = f64::from(planned.angle_deg) - foretold;
                angle.push(if wrong.abs() < 0.004 { 0 } else { whole(wrong * PER_DEGREE) });
            }
            if code.has(has::MOTION) && !code.has(has::MERGED) {
                last_motion = Some(index);
            }
        }
        let named = [
            ("time.programmed", feeds),
            ("time.cap", caps),
            ("time.other", other),
            ("time.angle", angle),
            ("time.with", with),
            ("time.piece", piece),
        ];
        named.map(|(name, column)| (name.to_owned(), column)).into()
    }

    /// Codes of all blocks; and what their greatest velocities and durations differ from what is foretold.
    fn codes(&self) -> (Vec<Value>, Vec<(String, Column)>) {
        let mut codes: Interned<Code> = Interned::default();
        let [mut code_of, mut peaks, mut durations] = <[Column; 3]>::default();
        let (mut place, mut clock) = (0, 0_i64);
        for index in 0..self.count {
            let Some(planned) = self.planned(index) else { continue };
            let mut code = self.code(index);
            let mut motion_s = 0.0;
            if code.has(has::VELOCITIES) {
                let [start, peak, end] = planned.velocities;
                let ends = self.ends(place);
                code.joint = self.modes.get(place).copied().unwrap_or_default();
                let truth = peak.max(start).max(end);
                let [rising, flat] = [0, 1].map(|mode| self.peak(planned, code, ends, mode));
                code.peak = u8::from(!is_near(truth, rising) && is_near(truth, flat));
                let foretold = if code.peak == 1 { flat } else { rising };
                let wrong = correction(truth, foretold);
                peaks.push(wrong);
                motion_s = duration_s(ends, foretold + wrong, self.accel(code), planned.length);
                place += 1;
            }
            let end_s = self.times.starts.get(index + 1).copied().unwrap_or(self.times.end_s);
            let foretold = clock + whole(motion_s * 1e6) + planned.other_us;
            let wrong = whole(end_s * 1e6) - whole(self.start_s() * 1e6) - foretold;
            let by = if wrong.abs() <= SLACK_US { 0 } else { wrong };
            durations.push(by);
            clock = foretold + by;
            code_of.push(i64::from(codes.get(code, || code.json())));
        }
        let columns = [("time.code", code_of), ("time.peak", peaks), ("time.duration", durations)];
        (codes.values().to_vec(), columns.map(|(name, column)| (name.to_owned(), column)).into())
    }

    /// When the first block of the page starts.
    fn start_s(&self) -> f64 {
        self.times.starts.first().copied().unwrap_or_default()
    }
}

fn describe(motion: &MotionTimes, code: &mut Code) {
    let joint = motion.joint.as_ref();
    let angle = joint.is_some_and(|joint| joint.with.is_some() && joint.angle_deg.is_some());
    for (bit, on) in [
        (has::MOTION, true),
        (has::PROGRAMMED, motion.programmed.is_some()),
        (has::CAP, motion.cap.is_some()),
        (has::VELOCITIES, motion.velocities.is_some()),
        (has::JOINT, joint.is_some()),
        (has::ANGLE, angle),
        (has::WITH, joint.is_some_and(|joint| joint.with.is_some())),
        (has::PIECE, motion.is_piece),
        (has::STRETCH, motion.stretch.is_some()),
        (has::MERGED, motion.merged),
        (has::RAPID, motion.kind == MotionType::Rapid),
    ] {
        code.has |= if on { bit } else { 0 };
    }
    code.cap_by = motion.cap.map(|(_, by)| by.name());
    if let Some(joint) = joint {
        code.broken_by = joint.broken_by.map(Break::name);
        code.limited_by = joint.limited_by.map(Limit::name);
        code.dot = joint.dot.map(Dot::name);
    }
}

/// Seconds of a motion that rises to its greatest velocity and falls, by one acceleration.
fn duration_s([start, end]: [i64; 2], peak: i64, accel: f64, length: f64) -> f64 {
    let second = |feed: i64| float(feed) / PER_FEED / 60.0;
    let (start, peak, end) = (second(start), second(peak), second(end));
    if peak <= 0.0 {
        return 0.0;
    }
    if accel <= 0.0 {
        return length / peak;
    }
    let ramps = (peak * peak - start * start + peak * peak - end * end) / (2.0 * accel);
    (peak - start) / accel + (peak - end) / accel + (length - ramps).max(0.0) / peak
}
