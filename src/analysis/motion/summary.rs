//! Sums over the times of blocks: what a program takes, and where it is slow.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::ops::ControlFlow;

use super::planned::Planned;
use super::planner::Listener;
use super::step::Unit;
use super::times::{BlockTimes, Break, Dot, Joint, Limit, Untimed};
use super::{Model, Profile};
use crate::config::Settings;
use crate::diag::Findings;
use crate::dict::Decimal;
use crate::run::{End, Executed, MotionType, Sink};
use crate::text::Location;

/// A joint with a red dot, as often as it was passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RedJoint {
    /// Number of the later block.
    pub n: u32,
    /// The place of its `N`.
    pub place: Location,
    /// Its line, from 1.
    pub line: u32,
    /// The joint, as it was passed first.
    pub joint: Joint,
    /// Programmed velocity of the later block, mm/s or deg/s.
    pub programmed: Option<f64>,
    /// Length of the later block, mm or degrees.
    pub length: Option<f64>,
    /// How often.
    pub times: u64,
    /// What all of them cost about, seconds.
    pub cost_s: f64,
}

/// Red joints that are kept at least while the program runs.
const CANDIDATES: usize = 8192;

impl RedJoint {
    /// The dearest first; of equal ones in the order of the text.
    fn by_cost(&self, other: &Self) -> Ordering {
        other.cost_s.total_cmp(&self.cost_s).then(self.key().cmp(&other.key()))
    }

    const fn key(&self) -> (Location, Option<u32>) {
        (self.place, self.joint.with_n)
    }
}

/// A time, and what it lacks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Total {
    /// Seconds that are known.
    pub time_s: f64,
    /// Blocks whose time is not known.
    pub unknown_blocks: u64,
    /// Those of them that lead to the first known position.
    pub approach_blocks: u64,
    /// Blocks whose jerk nothing limits, since P is not known: they take at least their times.
    pub jerk_free_blocks: u64,
    /// A criterion is on that needs the interpolation cycle, which is not known.
    pub lacks_cycle: bool,
}

impl Total {
    /// Adds the time of a block.
    pub fn add(&mut self, block: &BlockTimes) {
        self.time_s += block.duration_s;
        self.unknown_blocks += u64::from(block.unknown);
        self.approach_blocks += u64::from(block.unknown && block.approach);
        self.lacks_cycle |= block.lacks_cycle;
        self.jerk_free_blocks += u64::from(block.motion.as_ref().is_some_and(|motion| motion.jerk_free));
    }

    /// Whether there is neither a time nor something that lacks one.
    pub fn is_nothing(&self) -> bool {
        self.time_s <= 0.0 && self.unknown_blocks == 0
    }

    /// Whether more is not known than the way to the first known position.
    pub const fn lacks_more_than_approach(&self) -> bool {
        self.unknown_blocks > self.approach_blocks || self.has_loose_limits()
    }

    /// Whether some blocks take longer than is known.
    pub const fn is_lower_bound(&self) -> bool {
        self.unknown_blocks > 0 || self.has_loose_limits()
    }

    /// Whether a limit is not known: known times are the least possible.
    pub const fn has_loose_limits(&self) -> bool {
        self.jerk_free_blocks > 0 || self.lacks_cycle
    }
}

/// Times of a program, in seconds.
#[derive(Clone, Debug)]
pub struct Summary {
    /// All of it.
    pub total: Total,
    /// Each block at its programmed velocity, without ramps.
    pub ideal_s: f64,
    /// With the same limits and without one of jerk; parabolic only.
    pub no_jerk_s: Option<f64>,
    /// Motion, by place in [`MotionType::ALL`].
    pub by_type: [f64; MotionType::ALL.len()],
    /// Dwell.
    pub dwell_s: f64,
    /// Functions.
    pub function_s: f64,
    /// Waits at the end of motions.
    pub settle_s: f64,
    /// Gaps before blocks.
    pub gap_s: f64,
    /// By the tool in the spindle; none before the first M06.
    pub by_tool: BTreeMap<Option<Decimal>, Total>,
    /// Joints that are passed continuously.
    pub continuous: u64,
    /// Others, by place in [`Break::ALL`].
    pub broken: [u64; Break::ALL.len()],
    /// Continuous joints by what limits them, by place in [`Limit::ALL`].
    pub limited: [u64; Limit::ALL.len()],
    /// Yellow and red dots.
    pub dots: [u64; 2],
    /// Path of working motion in mm.
    pub working_mm: f64,
    /// Time of working motion, seconds.
    pub working_s: f64,
    /// What takes time and counts as 0 because nobody gave it, by place in [`Untimed::ALL`].
    pub untimed: [bool; Untimed::ALL.len()],
    /// Red joints; those that cost most are kept.
    red: Vec<RedJoint>,
    /// Whether there are others.
    more_red: bool,
    /// Which are kept, by place and the block before.
    red_at: BTreeMap<(Location, Option<u32>), usize>,
    most_red: usize,
}

impl Summary {
    /// Of a program whose velocity has this course; keeps so many red joints.
    pub fn new(profile: Profile, most_red: usize) -> Self {
        Self {
            total: Total::default(),
            ideal_s: 0.0,
            no_jerk_s: (profile == Profile::Parabolic).then_some(0.0),
            by_type: [0.0; MotionType::ALL.len()],
            dwell_s: 0.0,
            function_s: 0.0,
            settle_s: 0.0,
            gap_s: 0.0,
            by_tool: BTreeMap::new(),
            continuous: 0,
            broken: [0; Break::ALL.len()],
            limited: [0; Limit::ALL.len()],
            dots: [0; 2],
            working_mm: 0.0,
            working_s: 0.0,
            untimed: [false; Untimed::ALL.len()],
            red: Vec::new(),
            more_red: false,
            red_at: BTreeMap::new(),
            most_red,
        }
    }

    /// Motion times by type, without those that did not occur.
    pub fn types(&self) -> impl Iterator<Item = (MotionType, f64)> + '_ {
        MotionType::ALL.into_iter().zip(self.by_type).filter(|(_, seconds)| *seconds > 0.0)
    }

    /// Joints by what breaks them, without what did not occur.
    pub fn breaks(&self) -> impl Iterator<Item = (Break, u64)> + '_ {
        Break::ALL.into_iter().zip(self.broken).filter(|(_, count)| *count > 0)
    }

    /// Continuous joints by what limits them, without what did not occur.
    pub fn limits(&self) -> impl Iterator<Item = (Limit, u64)> + '_ {
        Limit::ALL.into_iter().zip(self.limited).filter(|(_, count)| *count > 0)
    }

    /// Mean velocity of working motion, mm/min.
    pub fn mean_feed(&self) -> Option<f64> {
        (self.working_s > 0.0).then(|| self.working_mm / self.working_s * 60.0)
    }

    /// The time with a tool in the spindle.
    pub fn of_tool(&self, tool: Option<Decimal>) -> Total {
        self.by_tool.get(&tool).copied().unwrap_or_default()
    }

    /// Adds the times of a block.
    pub fn add(&mut self, block: &BlockTimes) {
        let rest = block.dwell_s + block.function_s + block.settle_s + block.gap_s;
        self.total.add(block);
        self.ideal_s += rest;
        if rest > 0.0 {
            self.no_jerk(rest);
            self.dwell_s += block.dwell_s;
            self.function_s += block.function_s;
            self.settle_s += block.settle_s;
            self.gap_s += block.gap_s;
        }
        self.by_tool.entry(block.tool).or_default().add(block);
        self.untimed.iter_mut().zip(block.untimed).for_each(|(all, one)| *all |= one);
        let Some(motion) = &block.motion else { return };
        if let Some(seconds) = motion.motion_s {
            if let Some(sum) = self.by_type.get_mut(motion.kind as usize) {
                *sum += seconds;
            }
            if let (Some(length), Some(programmed)) = (motion.length, motion.programmed) {
                self.ideal_s += length / programmed;
                if motion.kind.is_working() && motion.unit == Unit::Mm {
                    self.working_mm += length;
                    self.working_s += seconds;
                }
            }
        }
        let Some(joint) = &motion.joint else { return };
        match (joint.broken_by, joint.limited_by) {
            (Some(reason), _) => count(&mut self.broken, reason as usize),
            (None, limit) => {
                self.continuous += 1;
                if let Some(limit) = limit {
                    count(&mut self.limited, limit as usize);
                }
            }
        }
        match joint.dot {
            Some(Dot::Yellow) => count(&mut self.dots, 0),
            Some(Dot::Red) => {
                count(&mut self.dots, 1);
                let red = RedJoint {
                    n: block.n,
                    place: block.place,
                    line: block.line,
                    joint: *joint,
                    programmed: motion.programmed,
                    length: motion.length,
                    times: 1,
                    cost_s: joint.cost_s,
                };
                self.add_red(red);
            }
            None => {}
        }
    }

    fn add_red(&mut self, red: RedJoint) {
        let key = red.key();
        let known = self.red_at.get(&key).copied();
        if let Some(known) = known.and_then(|at| self.red.get_mut(at)) {
            known.times += 1;
            known.cost_s += red.cost_s;
            return;
        }
        if self.most_red == 0 {
            self.more_red = true;
            return;
        }
        if self.red.len() >= self.most_red.saturating_mul(2).max(CANDIDATES) {
            // The cheaper half goes: memory does not grow with the program.
            self.more_red = true;
            self.red.sort_by(RedJoint::by_cost);
            self.red.truncate(self.most_red.max(CANDIDATES / 2));
            self.red_at = self.red.iter().zip(0..).map(|(red, at)| (red.key(), at)).collect();
        }
        self.red_at.insert(key, self.red.len());
        self.red.push(red);
    }

    /// The red joints that cost most, those first; and whether there are others.
    pub fn costly(&self) -> (Vec<RedJoint>, bool) {
        let mut red = self.red.clone();
        red.sort_by(RedJoint::by_cost);
        let more = self.more_red || red.len() > self.most_red;
        red.truncate(self.most_red);
        (red, more)
    }
}

fn count<const N: usize>(counts: &mut [u64; N], at: usize) {
    if let Some(count) = counts.get_mut(at) {
        *count += 1;
    }
}

impl Listener for Summary {
    fn block(&mut self, block: &BlockTimes) {
        self.add(block);
    }

    fn no_jerk(&mut self, motion_s: f64) {
        if let Some(sum) = &mut self.no_jerk_s {
            *sum += motion_s;
        }
    }
}

/// Sums up the times of a program: one pass, in constant memory.
#[derive(Debug)]
pub struct Estimate(Planned<Summary>);

impl Estimate {
    /// For programs executed with these settings; keeps so many red joints.
    pub fn new(settings: &Settings, most_red: usize) -> Self {
        Self(Planned::new(settings, Summary::new(Model::of(settings).profile, most_red)))
    }
}

impl Sink for Estimate {
    type Whole = Summary;

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.0.push(block);
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) -> Summary {
        self.0.finish()
    }
}
