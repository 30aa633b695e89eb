//! Results of the planner for each block: its time, its velocities, the joint before it.

use super::step::Unit;
use crate::dict::{Decimal, bilingual};
use crate::named::named;
use crate::run::MotionType;
use crate::text::Location;

named! {
    /// Why a joint is not passed continuously (CNT-2), in the order in which reasons are looked for.
    #[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
    pub enum Break {
        /// The first motion of the program.
        Start "start" ("first motion", "první pohyb"),
        /// The later block is not in G23, or the earlier one is in G98.
        Mode "mode" ("not in G23", "není G23"),
        /// One of the two is G00.
        Rapid "rapid" ("G00", "G00"),
        /// Blocks without motion were executed between them.
        NoMotion "no_motion" ("blocks without motion between", "bloky bez pohybu"),
        /// One is a thread or a motion to the reference point.
        OtherMotion "other_motion" ("thread or reference point", "závit nebo nájezd do reference"),
        /// G04 in the earlier block.
        Dwell "dwell" ("dwell", "prodleva"),
        /// M00, or M01 with optional stop, in the earlier block.
        Stop "stop" ("M00 or M01", "M00 nebo M01"),
        /// An M function with BreakContEnd in the earlier block, or with BreakCont in the later one.
        MFunction "m_function" ("M function", "M funkce"),
        /// Length, direction or velocity of one is not known.
        Unknown "unknown" ("motion is not known", "pohyb není znám"),
        /// One does not move the first three linear axes, or the two are measured in different units.
        Axes "axes" ("other axes", "jiné osy"),
        /// One is shorter than `break-length-mm`.
        ShortLength "short_length" ("block shorter than break-length-mm", "blok kratší než break-length-mm"),
        /// One lasts less than `shortest-block-ms`.
        ShortTime "short_time" ("block below shortest-block-ms", "blok pod shortest-block-ms"),
        /// The angle between the tangents is not below `angle-deg`.
        Angle "angle" ("angle", "úhel návaznosti"),
    }
}

named! {
    /// What gives the velocity at a continuous joint; of several the first that alone gives it.
    #[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
    pub enum Limit {
        /// The programmed velocity of one of the two blocks (VEL-1).
        Feed "feed" ("programmed feed", "programovaný posuv"),
        /// Centripetal acceleration of an arc (VEL-3).
        Centripetal "centripetal" ("centripetal acceleration", "odstředivé zrychlení"),
        /// The shortest time of a block (VEL-6).
        ShortestBlock "shortest_block" ("shortest time of a block", "nejkratší trvání bloku"),
        /// Criterion of accuracy (VEL-4).
        Accuracy "accuracy" ("criterion of accuracy", "kritérium přesnosti"),
        /// Dynamic criterion (VEL-5).
        Overload "overload" ("dynamic criterion", "dynamické kritérium"),
        /// Stopping within the blocks that the control sees (VEL-9).
        LookAhead "look_ahead" ("look-ahead", "předvídání bloků"),
        /// Acceleration from or towards a slower place.
        Ramp "ramp" ("acceleration", "zrychlení"),
    }
}

named! {
    /// What gives the cap of a block (VEL-7).
    #[derive(Clone, Copy, Debug, Eq, PartialEq)]
    pub enum CapBy {
        /// The programmed feed.
        Feed "feed",
        /// The velocity of G00.
        Rapid "rapid",
        /// Centripetal acceleration.
        Centripetal "centripetal",
        /// The shortest time of a block.
        ShortestBlock "shortest_block",
    }
}

named! {
    /// The dot that the control draws at a joint (DOT-1).
    #[derive(Clone, Copy, Debug, Eq, PartialEq)]
    pub enum Dot {
        /// Passed continuously.
        Yellow "yellow",
        /// Continuity is broken, or the velocity drops.
        Red "red",
    }
}

/// The joint between a motion block and the motion block executed before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// `seq` of the block before; of the first motion none.
    pub with: Option<u64>,
    /// Its block number.
    pub with_n: Option<u32>,
    /// Angle between the tangents, degrees; where both are known.
    pub angle_deg: Option<f64>,
    /// Why it is not passed continuously.
    pub broken_by: Option<Break>,
    /// Velocity at the joint, mm/s; 0 where it is broken.
    pub velocity: f64,
    /// What gives this velocity; none where the joint is broken.
    pub limited_by: Option<Limit>,
    /// The dot.
    pub dot: Option<Dot>,
    /// Whether both blocks are working motion in G23 (W0801).
    pub within_g23: bool,
    /// Whether one of the two is G00, which no mode makes continuous.
    pub beside_rapid: bool,
    /// Its approximate cost in seconds, against passing it at the programmed velocities.
    pub cost_s: f64,
    /// The least of both programmed velocities, mm/s; 0 where the joint is broken.
    pub feed_cap: f64,
    /// VEL-10: the block after it, the last of its stretch, is too short to stop from the programmed velocity.
    pub no_room_to_stop: bool,
}

bilingual! {
    /// What takes time and counts as 0, because nobody gave it.
    #[derive(Copy)]
    Untimed {
        Change "tool changes (M06 in [motion.times])", "výměny nástroje (M06 v [motion.times])";
        Function "functions ([motion.times])", "funkce ([motion.times])";
        Settle "waits at the end of motions (settle-ms)", "čekání na konci pohybů (settle-ms)";
        Gap "gaps before blocks in G98 (block-gap-ms)", "prodlevy před bloky při G98 (block-gap-ms)";
    }
}

impl Untimed {
    /// Every one.
    pub const ALL: [Self; 4] = [Self::Change, Self::Function, Self::Settle, Self::Gap];
}

/// A part of a motion with constant jerk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase {
    /// How long, seconds.
    pub duration_s: f64,
    /// Velocity at its start, mm/s.
    pub velocity: f64,
    /// Acceleration at its start, mm/s².
    pub acceleration: f64,
    /// Jerk, mm/s³.
    pub jerk: f64,
}

impl Phase {
    /// Whether it is more than what rounding leaves where a joint lies at the end of a phase.
    pub fn lasts(&self) -> bool {
        self.duration_s >= 1e-12
    }
}

/// The velocities of a motion, mm/s or deg/s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocities {
    /// At the start of the block.
    pub start: f64,
    /// The greatest in the block.
    pub peak: f64,
    /// At the end of the block.
    pub end: f64,
}

/// Where in its stretch a motion is (CNT-5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InStretch {
    /// Which stretch of the program, counted from 0.
    pub index: u64,
    /// Seconds of motion in the stretch before it.
    pub before_s: f64,
    /// Whether the stretch has two blocks or more.
    pub continued: bool,
    /// Seconds of motion from its start to the end of the stretch (TIM-2); none while the stretch is not planned to its
    /// end.
    pub time_dist_s: Option<f64>,
}

/// Times and velocities of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionTimes {
    /// Its kind.
    pub kind: MotionType,
    /// What velocities are measured in: mm/s or deg/s.
    pub unit: Unit,
    /// Length of the block, or of the piece when blocks are joined (CNT-4).
    pub length: Option<f64>,
    /// Seconds; `None`: not known, or in the record of the piece that it is part of.
    pub motion_s: Option<f64>,
    /// Programmed velocity (VEL-1, VEL-2).
    pub programmed: Option<f64>,
    /// Block cap (VEL-7) and what gives it.
    pub cap: Option<(f64, CapBy)>,
    /// Velocities, where the time is known.
    pub velocities: Option<Velocities>,
    /// Part of a piece that another block records (CNT-4).
    pub merged: bool,
    /// Whether it ends in G24.
    pub tight: bool,
    /// Whether other blocks are joined to it: `length` is that of the piece.
    pub is_piece: bool,
    /// The joint before it.
    pub joint: Option<Joint>,
    /// Acceleration that it goes by, mm/s²; 0 where its time is not known.
    pub accel: f64,
    /// Nothing limits its jerk, though the profile does (VEL-11): P is not known. It takes at least its time.
    pub jerk_free: bool,
    /// Where in its stretch it is; none outside of stretches, and of a block that is merged.
    pub stretch: Option<InStretch>,
    /// Of a block that is merged: where it is in the stretch of its piece.
    pub joined_in: Option<InStretch>,
    /// Its phases, when asked for.
    pub phases: Vec<Phase>,
}

/// Times of a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlockTimes {
    /// The block, as the stream counts.
    pub seq: u64,
    /// Its number.
    pub n: u32,
    /// The index of its file.
    pub file: u32,
    /// The line of its `N`.
    pub line: u32,
    /// The place of its `N`.
    pub place: Location,
    /// When it starts, seconds from program start.
    pub start_s: f64,
    /// How long it takes, seconds (TIM-1).
    pub duration_s: f64,
    /// Dwell, seconds.
    pub dwell_s: f64,
    /// Its functions, seconds.
    pub function_s: f64,
    /// Wait at the end of its motion, seconds.
    pub settle_s: f64,
    /// Gap before it, seconds.
    pub gap_s: f64,
    /// Whether a time of it is not known (TIM-3).
    pub unknown: bool,
    /// Whether only the way to the first known position lacks a length.
    pub approach: bool,
    /// The tool in the spindle.
    pub tool: Option<Decimal>,
    /// What takes time in it and counts as 0, because nobody gave it; by place in [`Untimed::ALL`].
    pub untimed: [bool; 4],
    /// A criterion is on that needs the cycle, which is not known: its time is a lower bound.
    pub lacks_cycle: bool,
    /// Its motion.
    pub motion: Option<MotionTimes>,
}
