//! The planes of arcs, and which axes an arc moves (§7, MOT-3).

use super::block::InForce;
use super::travel::Travel;
use crate::config::Axes;
use crate::dict::{AxisLetter, GCode, GGroup};

/// The plane in force, by the letters of §7.
pub(super) struct Plane {
    /// Its axes by place in machine order, first-named first; `None` when the machine lacks one.
    pub(super) axes: Option<[usize; 2]>,
    pub(super) name: &'static str,
}

/// The plane in force.
pub(super) fn in_force(axes: &Axes, g: &InForce) -> Plane {
    let (x, y, z) = (axes.index(AxisLetter::X), axes.index(AxisLetter::Y), axes.index(AxisLetter::Z));
    let fourth = axes.fourth();
    let ((first, second), name) = match g.of(GGroup::G1) {
        Some(GCode::G18) => ((y, z), "YZ"),
        Some(GCode::G19) => ((z, x), "ZX"),
        Some(GCode::G14) => ((z, fourth), "Z4"),
        Some(GCode::G15) => ((y, fourth), "Y4"),
        Some(GCode::G16) => ((fourth, x), "4X"),
        Some(_) | None => ((x, y), "XY"),
    };
    Plane { axes: first.zip(second).map(|(first, second)| [first, second]), name }
}

/// The pair as its plane names it, first-named first (MOT-5).
pub(super) fn named(axes: &Axes, pair: [usize; 2]) -> [usize; 2] {
    let letters = |axis: usize| axes.get(axis).map(|axis| axis.letter);
    let [a, b] = if pair[0] <= pair[1] { pair } else { [pair[1], pair[0]] };
    let (x, y, z, fourth) =
        (Some(AxisLetter::X), Some(AxisLetter::Y), Some(AxisLetter::Z), axes.fourth().and_then(letters));
    let named = [[x, y], [y, z], [z, x], [z, fourth], [y, fourth], [fourth, x]];
    if named.contains(&[letters(b), letters(a)]) && letters(b).is_some() { [b, a] } else { [a, b] }
}

/// The two axes of an arc and the one of its helix, by the axis words (MOT-3).
pub(super) fn of_arc(plane: &Plane, travels: &[Travel]) -> Option<([usize; 2], Option<usize>)> {
    let in_plane = |travel: &Travel| plane.axes.is_some_and(|plane| plane.contains(&travel.axis));
    match (travels, plane.axes) {
        ([], Some(plane)) => Some((plane, None)),
        ([one], Some(plane)) if in_plane(one) => Some((plane, None)),
        ([first, second], _) => Some(([first.axis, second.axis], None)),
        (three @ [_, _, _], Some(plane)) if three.iter().filter(|travel| in_plane(travel)).count() == 2 => {
            Some((plane, three.iter().map(|travel| travel.axis).find(|axis| !plane.contains(axis))))
        }
        _ => None,
    }
}
