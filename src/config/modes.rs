//! What machines differ in, and configuration names by a word.

use crate::dict::{AxisLetter, Dialect, FeedMode, FeedPer};
use crate::named::named;

named! {
    /// What G97 means (TEC-5): the sources disagree.
    #[derive(Clone, Copy, Debug, Eq, PartialEq)]
    pub enum G97 {
        /// Feed per minute, no constant cutting speed, as in ISO.
        PerMinute "per-minute",
        /// Feed per revolution with constant cutting speed.
        PerRevolution "per-revolution",
    }
}

impl G97 {
    /// What holds on that control unless configured.
    pub const fn of(dialect: Dialect) -> Self {
        match dialect {
            Dialect::Cnc8x6 | Dialect::Cnc8x9 => Self::PerRevolution,
            Dialect::Cnc872 => Self::PerMinute,
        }
    }

    /// What F counts then, and whether the cutting speed is constant.
    pub const fn mode(self) -> FeedMode {
        match self {
            Self::PerMinute => FeedMode { per: FeedPer::Minute, constant_cut: false },
            Self::PerRevolution => FeedMode { per: FeedPer::Revolution, constant_cut: true },
        }
    }
}

named! {
    /// Which of the two axes of an arc I belongs to, and which J (MOT-3).
    #[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
    pub enum ArcCenters {
        /// I to the one that comes first in the order of the machine's axes.
        #[default]
        MachineOrder "machine-order",
        /// I to the one that the plane's name says first: Y in YZ, Z in ZX.
        PlaneOrder "plane-order",
    }
}

/// Which axis the spindle is while M19 holds (MFN-10). [`Machine::spindle`](super::Machine::spindle) says what comes of
/// it.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum SpindleAxis {
    /// Not configured: the first of C, A, B that the machine has.
    #[default]
    Assumed,
    /// That one.
    Letter(AxisLetter),
    /// None: the spindle is no axis.
    None,
}

impl SpindleAxis {
    /// [`Self::None`] as written in the project file.
    pub const NONE: &'static str = "none";
}
