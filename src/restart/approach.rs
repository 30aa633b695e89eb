//! How the tool comes to the place (RST-2).

use super::reason::Reason;
use crate::dict::{AxisLetter, Decimal, Micro};

/// A place where a program can start, as far as what was executed before tells.
#[derive(Clone, Debug, Default)]
pub(super) struct Target {
    pub unknown: UnknownAxes,
    /// The height of the place, where nothing but a rapid of the program says that the tool is clear there: nothing may
    /// be worked at that height behind it, with the same tool and origin.
    pub level: Option<Micro>,
    pub approach: Approach,
}

/// Why an axis is not where the program says that it is.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Lack {
    /// It was never programmed.
    Fresh,
    /// It was never programmed, and a macrocycle that may move any axis was called.
    Unseen,
    /// It stands where `[start]` of the project file has it, and the program has not moved it since the origin or a
    /// correction changed, or has not moved anything.
    FromStart,
    /// The spindle turned.
    Turned,
    /// It was moved to where nobody knows.
    Lost,
}

/// The axes whose positions are not known at a place, a bit for each in machine order.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub(super) struct UnknownAxes {
    /// See [`Lack::Fresh`], [`Lack::Unseen`] and [`Lack::Turned`].
    pub fresh: u16,
    /// See [`Lack::FromStart`].
    pub from_start: u16,
    /// See [`Lack::Lost`].
    pub lost: u16,
    /// Those of `fresh` that the spindle turned, where the preamble changes the origin: the first motion of one has its
    /// length in the program, and none in one that starts here (MOT-8).
    pub turned: u16,
}

impl UnknownAxes {
    /// Whether there is none.
    pub const fn is_empty(self) -> bool {
        self.fresh | self.from_start | self.lost | self.turned == 0
    }
}

/// What says where the other axes move.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub(super) enum Height {
    /// The program: it stood there before.
    #[default]
    Highest,
    /// The user.
    Safe,
    /// The place, which the tool came to in rapid, above what the user says.
    Place,
}

/// The axes and heights of the approach. Positions in mm or degrees; X as a radius.
#[derive(Clone, Debug, Default)]
pub(super) struct Approach {
    /// Axes at their reference points, which they go to again.
    pub reference: Vec<AxisLetter>,
    /// The tool's axis, and where it stands at the place; nothing when that is not known, or nothing was moved.
    pub tool: Option<(AxisLetter, Micro)>,
    /// The other axes.
    pub others: Vec<(AxisLetter, Micro)>,
    /// Where the other axes move.
    pub top: Micro,
    /// What says so.
    pub height: Height,
    /// Why a start needs another `--safe`, if it does.
    pub lacks: Option<Reason>,
    /// How far above the place rapid ends.
    pub clearance: Micro,
    /// X is programmed as a diameter (G74).
    pub diameters: bool,
    /// The machine is a lathe: the program may have come to the place by another way, as into a bore.
    pub lathe: bool,
}

impl Approach {
    /// Whether the words of an axis are diameters.
    pub fn is_diameter(&self, axis: AxisLetter) -> bool {
        self.diameters && axis == AxisLetter::X
    }

    /// The tool's axis, where the approach comes to the place along it.
    pub fn descends(&self) -> Option<AxisLetter> {
        self.tool.filter(|(_, place)| *place < self.top).map(|(axis, _)| axis)
    }

    /// Where rapid ends and feed begins; nothing when the tool is there already.
    pub fn down(&self) -> Option<Micro> {
        let (_, place) = self.tool?;
        Some(place.plus(self.clearance)).filter(|down| *down < self.top)
    }

    /// The position of an axis as the program writes it.
    ///
    /// # Errors
    /// When thousandths are too coarse for it, or the control does not take it.
    pub fn written(&self, axis: AxisLetter, position: Micro) -> Result<Decimal, Reason> {
        let position = if self.is_diameter(axis) { position.plus(position) } else { position };
        let millionths = position.millionths();
        let value = Decimal::from_thousandths(millionths / 1000);
        let fits = millionths % 1000 == 0 && value.abs() <= Decimal::DIMENSION_MAX;
        if fits { Ok(value) } else { Err(Reason::Unwritable { axis: axis.to_string() }) }
    }
}
