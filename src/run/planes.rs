//! The planes of arcs, and which axes an arc moves (§7, MOT-3).

use super::block::InForce;
use super::travel::Travel;
use crate::config::Axes;
use crate::dict::{GGroup, Plane, PlaneAxis};

/// The plane in force.
pub(super) fn in_force(g: &InForce) -> Plane {
    g.of(GGroup::G1).and_then(Plane::of).unwrap_or(Plane::XY)
}

/// The axes of a plane by place in machine order, first-named first; `None` when the machine lacks one.
pub(super) fn axes_of(axes: &Axes, plane: Plane) -> Option<[usize; 2]> {
    let [first, second] = plane.axes.map(|axis| match axis {
        PlaneAxis::Letter(letter) => axes.index(letter),
        PlaneAxis::Fourth => axes.fourth(),
    });
    first.zip(second).map(|(first, second)| [first, second])
}

/// The pair as its plane names it, first-named first (MOT-5).
pub(super) fn named(axes: &Axes, [a, b]: [usize; 2]) -> [usize; 2] {
    let (rising, falling) = ([a.min(b), a.max(b)], [a.max(b), a.min(b)]);
    let is_named = Plane::ALL.into_iter().any(|plane| axes_of(axes, plane) == Some(falling));
    if is_named { falling } else { rising }
}

/// The plane of a pair of axes, in whatever order.
pub(super) fn of_pair(axes: &Axes, pair: [usize; 2]) -> Option<Plane> {
    let same = |axes: [usize; 2]| axes.contains(&pair[0]) && axes.contains(&pair[1]);
    Plane::ALL.into_iter().find(|plane| axes_of(axes, *plane).is_some_and(same))
}

/// The two axes of an arc and the one of its helix, by the axis words (MOT-3). `plane`: the axes of the plane in force.
pub(super) fn of_arc(plane: Option<[usize; 2]>, travels: &[Travel]) -> Option<([usize; 2], Option<usize>)> {
    let in_plane = |travel: &Travel| plane.is_some_and(|plane| plane.contains(&travel.axis));
    match (travels, plane) {
        ([], Some(plane)) => Some((plane, None)),
        ([one], Some(plane)) if in_plane(one) => Some((plane, None)),
        ([first, second], _) => Some(([first.axis, second.axis], None)),
        (three @ [_, _, _], Some(plane)) if three.iter().filter(|travel| in_plane(travel)).count() == 2 => {
            Some((plane, three.iter().map(|travel| travel.axis).find(|axis| !plane.contains(axis))))
        }
        _ => None,
    }
}
