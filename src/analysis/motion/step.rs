//! The facts of an executed block that the planner reads. One adapter makes them of the interpreter's blocks.

use crate::dict::Decimal;
use crate::run::MotionType;
use crate::text::Location;

/// The function of group G2, in as much as it decides how blocks join (CNT-1, CNT-2).
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum Mode {
    /// G23.
    Continuous,
    /// G24.
    Tight,
    /// G98.
    #[default]
    Basic,
    /// Any other function of the group.
    Other,
}

/// The unit of a length (MOT-6).
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum Unit {
    /// mm; velocities are mm/s.
    #[default]
    Mm,
    /// Degrees: only rotary axes move; velocities are deg/s.
    Deg,
}

/// The direction of a motion at one of its ends, in the first three linear axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Direction {
    /// Not known.
    #[default]
    Unknown,
    /// None of these axes moves.
    Still,
    /// Along this vector, of any length above 0.
    Along([f64; 3]),
}

/// The values of the dynamic set that is in force in a block (VEL-14). 0 is off.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dynamics {
    /// Greatest acceleration in a stretch, mm/s².
    pub accel: f64,
    /// Greatest jerk, mm/s³: P/32.768; parabolic only.
    pub jerk: f64,
    /// P is not known: nothing limits the jerk.
    pub jerk_free: bool,
    /// Criterion of accuracy, µm.
    pub accuracy_um: f64,
    /// Dynamic criterion, mm/s².
    pub overload: f64,
    /// Centripetal acceleration of arcs, mm/s².
    pub centripetal: f64,
}

/// The motion of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    /// Its kind.
    pub kind: MotionType,
    /// Its length; `None`: not known.
    pub length: Option<f64>,
    /// The unit of the length.
    pub unit: Unit,
    /// Direction at the start.
    pub from: Direction,
    /// Direction at the end.
    pub to: Direction,
    /// Distances of all linear axes, mm, in machine order: from end to end.
    pub vector: [f64; 9],
    /// Programmed velocity (VEL-1, VEL-2), mm/s or deg/s; `None`: not known.
    pub programmed: Option<f64>,
    /// Radius of an arc, mm.
    pub radius: Option<f64>,
    /// The dynamic set in force; of G00 with the parabolic profile that of G00.
    pub dynamics: Dynamics,
}

/// An executed block, as far as its time depends on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Its number in the order of execution.
    pub seq: u64,
    /// The block number.
    pub n: u32,
    /// The file, as records count files.
    pub file: u32,
    /// The line of the `N`, from 1.
    pub line: u32,
    /// The place of its `N`.
    pub place: Location,
    /// The function of group G2 in force.
    pub mode: Mode,
    /// What moves.
    pub motion: Option<Move>,
    /// G04 with its time in seconds.
    pub dwell_s: Option<f64>,
    /// M00, or M01 with optional stop.
    pub stops: bool,
    /// BreakCont: continuity is broken at the start of the block.
    pub breaks_before: bool,
    /// BreakContEnd: continuity is broken at the end of the block.
    pub breaks_after: bool,
    /// The longest time of its functions, seconds.
    pub function_s: f64,
    /// Whether it may be joined to its neighbours when it is short: in G90, no M, S, T, H, P or D word, and no G or F
    /// word that changes what was in force (CNT-4).
    pub plain: bool,
    /// It changes the tool, and nobody gave a time for that.
    pub untimed_change: bool,
    /// It has other functions that nobody gave a time for.
    pub untimed_function: bool,
    /// Axis words under a fixed cycle that is not mapped, or a macrocycle that only the machine has: nobody knows what
    /// moves (TIM-3).
    pub opaque: bool,
    /// The length is not known because no position was, up to here.
    pub approach: bool,
    /// The tool in the spindle.
    pub tool: Option<Decimal>,
}
