//! The motion of an executed block: which axes, from where, to where, along what, how long.

use super::motion::Travel;
use super::state::Position;
use crate::dict::{AxisLetter, Micro};
use crate::ir::MotionType;

/// How a block moves. Lengths are millimetres, of rotary axes degrees; positions are programmed coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Motion<'r> {
    pub(super) motion: &'r crate::ir::Motion,
    pub(super) travels: &'r [Travel],
    pub(super) stale: bool,
}

/// How long a motion is (MOT-6).
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Length {
    /// In millimetres.
    Mm(Micro),
    /// In degrees: only rotary axes move.
    Deg(Micro),
    /// Not known.
    Missing(Missing),
}

impl Length {
    /// In millimetres, when it is measured in them.
    pub const fn mm(self) -> Option<Micro> {
        match self {
            Self::Mm(length) => Some(length),
            Self::Deg(_) | Self::Missing(_) => None,
        }
    }

    /// In degrees, when it is measured in them.
    pub const fn deg(self) -> Option<Micro> {
        match self {
            Self::Deg(length) => Some(length),
            Self::Mm(_) | Self::Missing(_) => None,
        }
    }
}

/// Why the length of a motion is not known.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Missing {
    /// A distance is not known: the start of an axis (MOT-2), or a value that only the machine has (PAR-5).
    Start,
    /// After a change of origin or correction the tool does not stand where the program says (MOT-8).
    Origin,
    /// A motion to the reference point (MOT-7).
    Reference,
}

impl Missing {
    /// `start`, `origin`, `reference`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Origin => "origin",
            Self::Reference => "reference",
        }
    }
}

/// An arc (MOT-3…MOT-5).
#[derive(Clone, Copy, Debug)]
pub struct ArcPath {
    /// The axes of its plane, first-named first: G03 turns from the first to the second.
    pub plane: [AxisLetter; 2],
    /// The centre along these axes; `None` when the start or the end is not known.
    pub center: Option<[Micro; 2]>,
    /// At the start.
    pub radius_mm: Option<Micro>,
    /// Positive, up to 360.
    pub sweep_deg: Option<Micro>,
    /// The axis along which a helix moves.
    pub helix: Option<AxisLetter>,
}

impl<'r> Motion<'r> {
    /// What kind of motion.
    pub const fn kind(&self) -> MotionType {
        self.motion.kind
    }

    /// The axes that move, in machine order.
    pub fn axes(&self) -> impl Iterator<Item = AxisLetter> + 'r {
        self.motion.axes.iter()
    }

    /// Whether an axis moves.
    pub fn moves(&self, axis: AxisLetter) -> bool {
        self.motion.axes.contains(axis)
    }

    /// Where an axis that moves stands before; `None` when that is not known.
    pub fn start(&self, axis: AxisLetter) -> Option<Micro> {
        self.travel(axis)?.before.known()
    }

    /// Where an axis that moves stands after; `None` when that is not known.
    pub fn end(&self, axis: AxisLetter) -> Option<Micro> {
        match self.kind() {
            MotionType::Reference => None,
            MotionType::Rapid | MotionType::Linear | MotionType::ArcCw | MotionType::ArcCcw | MotionType::Thread => {
                self.travel(axis)?.after.known()
            }
        }
    }

    /// By how much the programmed coordinate of an axis changes, with its sign; known also of an axis that moves by G91
    /// from a position that is not.
    pub fn distance(&self, axis: AxisLetter) -> Option<Micro> {
        match self.kind() {
            MotionType::Reference => None,
            MotionType::Rapid | MotionType::Linear | MotionType::ArcCw | MotionType::ArcCcw | MotionType::Thread => {
                self.travel(axis)?.distance
            }
        }
    }

    /// The distance of an axis that moves by G91 from an unknown position (MOT-2); `None` for other axes.
    pub fn delta(&self, axis: AxisLetter) -> Option<Micro> {
        let travel = self.travel(axis)?;
        let from_unknown = travel.incremental && !matches!(travel.before, Position::Known(_));
        self.distance(axis).filter(|_| from_unknown)
    }

    /// Whether the programmed start is not where the tool stands, after a change of origin or correction (MOT-8).
    pub const fn is_stale(&self) -> bool {
        self.stale
    }

    /// How long it is.
    pub fn length(&self) -> Length {
        match (self.motion.length_mm, self.motion.length_deg) {
            (Some(length), _) => Length::Mm(length),
            (None, Some(length)) => Length::Deg(length),
            (None, None) if self.kind() == MotionType::Reference => Length::Missing(Missing::Reference),
            (None, None) if self.stale => Length::Missing(Missing::Origin),
            (None, None) => Length::Missing(Missing::Start),
        }
    }

    /// The arc, when it is one.
    pub fn arc(&self) -> Option<ArcPath> {
        let motion = self.motion;
        let plane = motion.plane?;
        let center = motion.center.get(plane[0]).zip(motion.center.get(plane[1]));
        Some(ArcPath {
            plane,
            center: center.map(|(first, second)| [first, second]),
            radius_mm: motion.radius_mm,
            sweep_deg: motion.sweep_deg,
            helix: self.axes().find(|axis| !plane.contains(axis)),
        })
    }

    /// The axis that is the spindle (M19, MFN-10), when it moves.
    pub const fn spindle_axis(&self) -> Option<AxisLetter> {
        self.motion.spindle_axis
    }

    fn travel(&self, axis: AxisLetter) -> Option<&'r Travel> {
        self.travels.iter().find(|travel| travel.definition.letter == axis)
    }
}
