//! The facts of one step that cells are computed from: they all follow from the executed block.

use super::dictionary::{AXES, Flag, OneBlock};
use crate::dict::{Decimal, HELD_AT_STOP, M_GROUPS, MOMENTARY_GROUPS, Micro};

/// Places of axes, as indices.
pub(super) const PLACES: usize = AXES as usize;
/// M groups that a stop switches off for its length (MFN-8).
pub const STOPPED: [usize; 3] = {
    let [(spindle, _), (coolant_12, _), (coolant_34, _)] = HELD_AT_STOP;
    [spindle, coolant_12, coolant_34]
};

/// One step as the PLC sees it.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
pub struct Facts {
    /// By group: the function in force; 0 is not used.
    pub m: [Option<u8>; M_GROUPS],
    /// A bit for each group with a change bit.
    pub marks: u16,
    /// A bit for each [`Flag`] that holds.
    pub(super) flags: u16,
    /// A bit for each [`OneBlock`] written in the block.
    pub(super) written: u8,
    /// A bit for each place whose axis moves.
    pub moves: u16,
    /// A bit for each place whose axis moves in a known direction.
    pub directed: u16,
    /// Of these those that move in the negative one.
    pub negative: u16,
    /// The gear (MFN-9).
    pub gear: Option<u8>,
    /// T in force.
    pub tool: Option<Decimal>,
    /// H in force.
    pub h: Option<Decimal>,
    /// F in force.
    pub feed: Option<Decimal>,
    /// S in force.
    pub speed: Option<Decimal>,
    /// The dwell, in seconds.
    pub dwell: Option<Micro>,
    /// The length of the block, mm or degrees.
    pub length: Option<Micro>,
    /// By place: programmed positions after the block.
    pub positions: [Option<Micro>; PLACES],
    /// What `[motion]` adds.
    pub motion: MotionFacts,
}

/// What only the computation of motion gives (PLC-6, PLC-15).
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct MotionFacts {
    /// Start of the step, in seconds from that of the program.
    pub start_s: Option<Micro>,
    /// End of the block likewise.
    pub end_s: Option<Micro>,
    /// Whether the block lies in a continuous stretch of two blocks or more; absent without `[motion]`.
    pub in_stretch: Option<bool>,
    /// Time to the end of that stretch, in ms.
    pub time_dist_ms: Option<u32>,
    /// P/500 of the set in force, in G00 and G23 with a parabolic profile.
    pub parabolic: Option<Micro>,
    /// Linear acceleration of that set, in mm/s².
    pub linear: Option<Micro>,
}

/// The times of a block, seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepTimes {
    /// When it starts, from the start of the program.
    pub start_s: f64,
    /// How long it takes.
    pub duration_s: f64,
    /// Whether it lies in a continuous stretch of two blocks or more.
    pub in_stretch: bool,
    /// Motion to the end of its stretch, when that was asked for.
    pub time_dist_s: Option<f64>,
}

impl MotionFacts {
    /// Takes over the times of the block (PLC-15).
    pub(super) fn set_times(&mut self, times: StepTimes) {
        self.start_s = Some(Micro::from_f64(times.start_s));
        self.end_s = Some(Micro::from_f64(times.start_s + times.duration_s));
        self.in_stretch = Some(times.in_stretch);
        // Whole ms, halves away from zero; a DWORD holds 49 days.
        let ms = times.time_dist_s.filter(|_| times.in_stretch).map(|seconds| Micro::from_f64(seconds).millionths());
        self.time_dist_ms = ms.and_then(|millionths| u32::try_from((millionths + 500) / 1000).ok());
    }
}

impl Facts {
    /// Values that a block may leave unchanged, as before any block; each block sets the others.
    pub(super) fn reset(&mut self) {
        (self.marks, self.flags, self.written) = (0, 0, 0);
        (self.moves, self.directed, self.negative) = (0, 0, 0);
        self.length = None;
        self.motion = MotionFacts::default();
    }

    /// A bit for each place whose position is another one.
    pub(super) fn moved_places(&self, other: &Self) -> u16 {
        let pairs = self.positions.iter().zip(&other.positions);
        pairs.enumerate().fold(0, |mask, (place, (a, b))| mask | u16::from(a != b) << place)
    }

    /// Whether the flag holds.
    pub const fn has(&self, flag: Flag) -> bool {
        self.flags & (1 << flag as u8) != 0
    }

    /// Sets a flag.
    pub const fn set(&mut self, flag: Flag, holds: bool) {
        let bit = 1 << flag as u8;
        self.flags = if holds { self.flags | bit } else { self.flags & !bit };
    }

    /// Whether the group has a change bit.
    pub const fn is_marked(&self, group: usize) -> bool {
        group < M_GROUPS && self.marks >> group & 1 == 1
    }

    /// What does not depend on where the axes are and how they move.
    #[must_use]
    pub fn without_motion(self) -> Self {
        Self {
            moves: 0,
            directed: 0,
            negative: 0,
            dwell: None,
            length: None,
            positions: [None; PLACES],
            motion: MotionFacts::default(),
            ..self
        }
    }

    /// All flags.
    pub const fn flags(&self) -> u16 {
        self.flags
    }

    /// Whether the block has the function.
    pub const fn is_written(&self, function: OneBlock) -> bool {
        self.written & (1 << function as u8) != 0
    }

    /// Notes that the block has the function.
    pub const fn write(&mut self, function: OneBlock) {
        self.written |= 1 << function as u8;
    }

    /// All of [`OneBlock`] that the block has.
    pub const fn written(&self) -> u8 {
        self.written
    }

    /// Marks a group as changed.
    pub const fn mark(&mut self, group: usize) {
        self.marks |= 1 << group;
    }

    /// PLC-16: the step of a stop after this block. `held` are the values of groups 2, 5, 6 while the program stands,
    /// `rapid` and `thread` say whether G00 or G33 is in force after the block.
    #[must_use]
    pub fn at_stop(&self, held: [u8; 3], rapid: bool, thread: bool) -> Self {
        let mut m = self.m;
        let mut step = Self {
            gear: self.gear,
            tool: self.tool,
            h: self.h,
            feed: self.feed,
            speed: self.speed,
            positions: self.positions,
            ..Self::default()
        };
        for group in MOMENTARY_GROUPS {
            if let Some(slot) = m.get_mut(usize::from(group)) {
                *slot = None;
            }
        }
        for (group, value) in STOPPED.into_iter().zip(held) {
            if let Some(slot) = m.get_mut(group) {
                *slot = Some(value);
            }
            step.mark(group);
        }
        step.m = m;
        for flag in [Flag::RevFeed, Flag::ContinuousMode, Flag::ConstCutSpeed] {
            step.set(flag, self.has(flag));
        }
        step.set(Flag::Standing, true);
        step.set(Flag::Rapid, rapid);
        step.set(Flag::Thread, thread);
        step.set(Flag::Automatic, true);
        // How long the program stands is not known.
        step.motion.start_s = self.motion.end_s;
        step.motion.end_s = self.motion.end_s;
        step.motion.in_stretch = self.motion.in_stretch.map(|_| false);
        step.motion.parabolic = self.motion.parabolic;
        step.motion.linear = self.motion.linear;
        step
    }
}
