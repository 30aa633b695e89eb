//! Directions of motions at their ends, as the page computes them (`web/src/data/tangents.ts`).

use super::rows::Rows;
use crate::dict::Micro;

/// The angle between two executed motions where they join, in degrees, by their directions in the first three linear
/// axes.
pub(super) fn angle_deg(rows: &Rows, before: usize, after: usize) -> f64 {
    let (Some(before), Some(after)) = (rows.row(before), rows.row(after)) else { return 0.0 };
    let [ax, ay, az] = tangent(rows, before, true);
    let [bx, by, bz] = tangent(rows, after, false);
    let cross = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
    let length = (cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]).sqrt();
    let dot = ax * bx + ay * by + az * bz;
    libm::atan2(length, dot) * 180.0 / std::f64::consts::PI
}

/// The direction at the start or end of a row's motion; its length means nothing.
fn tangent(rows: &Rows, row: usize, at_end: bool) -> [f64; 3] {
    let before = rows.row_before(row);
    let mut direction = [0.0; 3];
    let way = |axis: usize| rows.positions.get(axis, row).minus(rows.positions.get(axis, before)).to_f64();
    let arc = rows.shape_of(row).and_then(|shape| shape.arc.zip(shape.kind));
    let swept = arc.and_then(|(axes, kind)| {
        let [to_u, to_v] = rows.to_center(row).map(Micro::to_f64);
        let (mut from_u, mut from_v) = (-to_u, -to_v);
        if at_end {
            (from_u, from_v) = (way(axes.first) - to_u, way(axes.second) - to_v);
        }
        let clockwise = kind == crate::run::MotionType::ArcCw;
        let turned = if clockwise { [from_v, -from_u] } else { [-from_v, from_u] };
        Some((axes, turned, rows.sweep(row)?))
    });
    for (slot, axis) in direction.iter_mut().zip(rows.linear()) {
        *slot = match swept {
            Some((axes, [u, _], _)) if axis == axes.first => u,
            Some((axes, [_, v], _)) if axis == axes.second => v,
            Some((_, _, sweep)) => way(axis) / sweep,
            None => way(axis),
        };
    }
    direction
}
