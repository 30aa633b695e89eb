//! The motion stream as columns.

use std::fmt;
use std::io;
use std::ops::ControlFlow;

use super::batches::{Batches, End as LastBatch, PROGRAM, Rows};
use super::table::Table;
use crate::analysis::motion::{
    BlockTimes, Break, CapBy, Dot, Joint, Limit, Listener, MotionTimes, PER_MINUTE, Profile, Summary, total,
    twelve_digits,
};
use crate::diag::Findings;
use crate::dict::Micro;
use crate::run::{End, Executed, Program};
use crate::session::TimedSink;

/// Velocities: the second in blocks that move rotary axes only.
const FEED: &str = "mm/min or deg/min";

/// The motion stream as columns: a reader of executed blocks with their times.
pub struct MotionTable<'o> {
    rows: Rows<'o>,
    /// The first record.
    machine: String,
    summary: Summary,
    jerk_free: &'o mut u64,
}

impl fmt::Debug for MotionTable<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("MotionTable").finish_non_exhaustive()
    }
}

impl<'o> MotionTable<'o> {
    /// Gives record batches to `out`. What that fails with goes to `failed`, and ends the reading; how many blocks have
    /// no limit of their jerk, to `jerk_free`. `machine` is the first record.
    pub fn new(
        machine: String,
        profile: Profile,
        out: &'o mut (dyn Batches + Send),
        failed: &'o mut Option<io::Error>,
        jerk_free: &'o mut u64,
    ) -> Self {
        Self { rows: Rows::new(out, failed), machine, summary: Summary::new(profile, 0), jerk_free }
    }
}

impl TimedSink for MotionTable<'_> {
    type Whole = End;

    fn begin(&mut self, _: &Program<'_>) {
        put(&mut self.rows.table, &BlockTimes::default());
        self.rows.begin(PROGRAM, &self.machine);
    }

    fn block(&mut self, _: &Executed<'_>, times: &BlockTimes, _: &mut Findings) -> ControlFlow<()> {
        *self.jerk_free += u64::from(times.motion.as_ref().is_some_and(|motion| motion.jerk_free));
        self.summary.add(times);
        put(&mut self.rows.table, times);
        self.rows.row();
        if self.rows.goes_on() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    fn no_jerk(&mut self, motion_s: f64) {
        Listener::no_jerk(&mut self.summary, motion_s);
    }

    fn end(mut self, end: End, _: &mut Findings) -> End {
        self.rows.end(&LastBatch::new(&total(&self.summary), &[]));
        end
    }
}

/// As the records have it.
fn rounded(value: f64) -> f64 {
    Micro::from_f64(value).to_f64()
}

fn put(table: &mut Table, block: &BlockTimes) {
    let BlockTimes {
        seq,
        n,
        file,
        line,
        place: _,
        start_s,
        duration_s,
        dwell_s: _,
        function_s: _,
        settle_s: _,
        gap_s: _,
        unknown: _,
        untimed: _,
        approach: _,
        lacks_cycle: _,
        tool: _,
        motion,
    } = block;
    table.long("seq", Some(*seq));
    table.whole("n", "", Some(*n));
    table.whole("file", "", Some(*file));
    table.whole("line", "", Some(*line));
    table.number("start_s", "s", Some(rounded(*start_s)));
    table.number("duration_s", "s", Some(rounded(*duration_s)));
    put_motion(table, motion.as_ref());
}

fn put_motion(table: &mut Table, motion: Option<&MotionTimes>) {
    let minute = |velocity: f64| rounded(velocity * PER_MINUTE);
    let velocities = motion.and_then(|motion| motion.velocities);
    let cap = motion.and_then(|motion| motion.cap);
    table.number("programmed", FEED, motion.and_then(|motion| motion.programmed).map(minute));
    table.number("cap", FEED, cap.map(|(cap, _)| minute(cap)));
    let by = cap.and_then(|(_, by)| CapBy::ALL.iter().position(|other| *other == by));
    table.name("cap_by", || CapBy::ALL.into_iter().map(CapBy::name), by);
    table.number("start", FEED, velocities.map(|velocities| minute(velocities.start)));
    table.number("peak", FEED, velocities.map(|velocities| minute(velocities.peak)));
    table.number("end", FEED, velocities.map(|velocities| minute(velocities.end)));
    let time_dist = motion.and_then(|motion| motion.stretch?.time_dist_s);
    table.number("time_dist_s", "s", time_dist.map(rounded));
    table.flag("merged", motion.is_some_and(|motion| motion.merged));
    let piece = motion.filter(|motion| motion.is_piece).and_then(|motion| motion.length);
    table.number("piece_mm", "mm", piece.map(rounded));
    put_joint(table, motion.and_then(|motion| motion.joint.as_ref()));
    let phases = motion.map(|motion| motion.phases.as_slice()).filter(|phases| !phases.is_empty());
    let phases = phases.map(|phases| phases.iter().filter(|phase| phase.lasts()));
    let row = |phase: &crate::analysis::motion::Phase| {
        [phase.duration_s, phase.velocity, phase.acceleration, phase.jerk].map(twelve_digits)
    };
    table.quadruples("phases", phases.map(|phases| phases.map(row)));
}

fn put_joint(table: &mut Table, joint: Option<&Joint>) {
    let broken = joint.and_then(|joint| joint.broken_by);
    let limited = joint.and_then(|joint| joint.limited_by);
    table.long("joint_with", joint.and_then(|joint| joint.with));
    table.number("joint_angle_deg", "deg", joint.and_then(|joint| joint.angle_deg).map(rounded));
    table.flag("joint_continuous", joint.is_some() && broken.is_none());
    let place = broken.and_then(|broken| Break::ALL.iter().position(|other| *other == broken));
    table.name("joint_broken_by", || Break::ALL.into_iter().map(Break::name), place);
    table.number("joint_feed", FEED, joint.map(|joint| rounded(joint.velocity * PER_MINUTE)));
    // What broke the joint limits it too.
    let limits = || Limit::ALL.into_iter().map(Limit::name).chain(Break::ALL.into_iter().map(Break::name));
    let limited = limited.and_then(|limit| Limit::ALL.iter().position(|other| *other == limit));
    table.name("joint_limited_by", limits, place.map(|place| place + Limit::ALL.len()).or(limited));
    let dot = joint.and_then(|joint| joint.dot);
    let dot = dot.and_then(|dot| Dot::ALL.iter().position(|other| *other == dot));
    table.name("joint_dot", || Dot::ALL.into_iter().map(Dot::name), dot);
}
