//! Whether a program turns.

use crate::dict::{AxisLetter, GCode, GGroup};
use crate::run::{Executed, Motion, MotionType};

/// What tells a lathe.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Turning {
    /// A plane of lathes is in force at power-up, or at the first working motion.
    plane: bool,
    worked: bool,
    /// Axes besides X and Z move.
    others: bool,
    moved: bool,
    /// G74 is in force at a motion: X is a diameter.
    pub diameter: bool,
}

impl Turning {
    /// Whether it is drawn as lathes are.
    pub const fn is_lathe(self) -> bool {
        self.diameter || (self.plane && self.moved && !self.others)
    }

    /// Reads the next motion.
    pub fn read(&mut self, block: &Executed<'_>, motion: Motion<'_>) {
        let plane = |code: Option<GCode>| matches!(code, Some(GCode::G18 | GCode::G19));
        if !self.moved {
            let [_, power_up, ..] = block.settings().machine.power_up;
            self.plane = plane(power_up);
            self.moved = true;
        }
        if !self.worked && motion.kind() != MotionType::Rapid {
            self.worked = true;
            self.plane |= plane(block.g(GGroup::G1));
        }
        self.others |= motion.axes().any(|axis| !matches!(axis, AxisLetter::X | AxisLetter::Z));
        self.diameter |= block.g(GGroup::G10) == Some(GCode::G74);
    }
}
