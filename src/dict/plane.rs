//! The planes of G14–G19, as §7 names them: the reverse of ISO 6983 for G18 and G19.

use super::{AxisLetter, GCode, GGroup};

/// An axis of a plane.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum PlaneAxis {
    /// X, Y or Z.
    Letter(AxisLetter),
    /// The 4th axis of the machine, whatever its letter.
    Fourth,
}

/// A plane: its function, its name, its axes in the order of the name.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Plane {
    /// G14–G19.
    pub function: GCode,
    /// As the manual names it, such as `ZX` or `Z4`.
    pub name: &'static str,
    /// First-named and second-named axis: G03 turns from the first to the second (MOT-5).
    pub axes: [PlaneAxis; 2],
}

const X: PlaneAxis = PlaneAxis::Letter(AxisLetter::X);
const Y: PlaneAxis = PlaneAxis::Letter(AxisLetter::Y);
const Z: PlaneAxis = PlaneAxis::Letter(AxisLetter::Z);
const FOURTH: PlaneAxis = PlaneAxis::Fourth;

const fn plane(function: GCode, name: &'static str, axes: [PlaneAxis; 2]) -> Plane {
    Plane { function, name, axes }
}

impl Plane {
    /// The plane at power-up, XY.
    pub const XY: Self = plane(GCode::G17, "XY", [X, Y]);

    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::XY,
        plane(GCode::G18, "YZ", [Y, Z]),
        plane(GCode::G19, "ZX", [Z, X]),
        plane(GCode::G14, "Z4", [Z, FOURTH]),
        plane(GCode::G15, "Y4", [Y, FOURTH]),
        plane(GCode::G16, "4X", [FOURTH, X]),
    ];

    /// The plane of a function; `None` when it chooses none.
    pub fn of(function: GCode) -> Option<Self> {
        Self::ALL.into_iter().find(|plane| plane.function == function)
    }

    /// The axis of X, Y, Z that is perpendicular to the plane; `None` for planes with the 4th axis.
    pub fn perpendicular(self) -> Option<AxisLetter> {
        let others = [AxisLetter::X, AxisLetter::Y, AxisLetter::Z];
        let mut others = others.into_iter().filter(|letter| !self.axes.contains(&PlaneAxis::Letter(*letter)));
        let only = others.next();
        only.filter(|_| others.next().is_none())
    }
}

/// A function of group G1 does not compile without its plane.
const _: () = {
    let mut functions = GCode::ALL;
    while let [function, rest @ ..] = functions {
        let (mut planes, mut has_plane): (&[Plane], bool) = (&Plane::ALL, false);
        while let [plane, others @ ..] = planes {
            has_plane |= plane.function.number() == function.number();
            planes = others;
        }
        let is_plane = matches!(function.group(), GGroup::G1);
        assert!(is_plane == has_plane, "a function of group G1 needs its plane, and no other has one");
        functions = rest;
    }
};
