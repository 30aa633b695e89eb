//! The lines of a program in space, for still pictures: which rows have one, where it runs.

use super::rows::Rows;
use super::shapes::ArcAxes;
use crate::dict::{AxisLetter, Micro};
use crate::run::MotionType;

/// A point in millimetres.
pub(super) type Point = [f64; 3];

/// How a line is drawn.
#[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
pub(super) enum Stroke {
    Rapid,
    Straight,
    Arc,
    Thread,
}

/// The line of a row.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Line {
    /// Nothing moves.
    Nothing,
    /// It moves, but its start or end is not known, or it moves none of X, Y, Z.
    LeftOut,
    Drawn(Stroke),
}

impl Stroke {
    const fn of(kind: MotionType) -> Self {
        match kind {
            MotionType::Rapid => Self::Rapid,
            MotionType::Linear | MotionType::Reference => Self::Straight,
            MotionType::ArcCw | MotionType::ArcCcw => Self::Arc,
            MotionType::Thread => Self::Thread,
        }
    }
}

/// The position of the tool after each row: X, Y and Z in millimetres. In place of an unknown coordinate it has the
/// next known one of the axis, or else the last known one, or 0 when none is known.
#[derive(Debug)]
pub(super) struct Lines<'r> {
    rows: &'r Rows,
    /// Places of X, Y, Z among the axes.
    axes: [Option<usize>; 3],
    /// By axis of space: the values of rows where it is not known, from the first of them on.
    filled: [Vec<f64>; 3],
}

impl<'r> Lines<'r> {
    pub fn new(rows: &'r Rows) -> Self {
        let axes = [AxisLetter::X, AxisLetter::Y, AxisLetter::Z].map(|letter| rows.place(letter));
        let filled = axes.map(|axis| axis.map_or_else(Vec::new, |axis| fill(rows, axis)));
        Self { rows, axes, filled }
    }

    /// Where the tool stands after a row.
    pub fn point(&self, row: usize) -> Point {
        let mut point = [0.0; 3];
        for (slot, values) in point.iter_mut().zip(&self.filled) {
            *slot = values.get(row).copied().unwrap_or_default();
        }
        point
    }

    /// Where the tool stands before a row.
    pub fn start(&self, row: usize) -> Point {
        self.point(self.rows.row_before(row))
    }

    /// The line of a row.
    pub fn line(&self, row: usize) -> Line {
        let Some(shape) = self.rows.shape_of(row) else { return Line::Nothing };
        let Some(kind) = shape.kind else { return if shape.opaque { Line::LeftOut } else { Line::Nothing } };
        let space = self.axes.into_iter().flatten().fold(0_u16, |bits, axis| bits | 1 << axis);
        let moved = shape.axes & space;
        if moved == 0 || moved & !shape.started != 0 || moved & !shape.known != 0 || kind == MotionType::Reference {
            return if shape.axes == 0 { Line::Nothing } else { Line::LeftOut };
        }
        if kind.is_arc() {
            let seen = |arc: ArcAxes| space & (1 << arc.first | 1 << arc.second) != 0;
            return if shape.arc.is_some_and(seen) { Line::Drawn(Stroke::Arc) } else { Line::LeftOut };
        }
        if self.point(row) != self.point(self.rows.row_before(row)) {
            Line::Drawn(Stroke::of(kind))
        } else if shape.axes == moved {
            Line::Nothing
        } else {
            Line::LeftOut
        }
    }

    /// The points of a line from its start to its end; arcs by chords that are nowhere further from them than
    /// `deviation`.
    pub fn points(&self, row: usize, deviation: f64, mut each: impl FnMut(Point)) {
        let before = self.rows.row_before(row);
        let (from, to) = (self.point(before), self.point(row));
        each(from);
        let arc = self.rows.shape_of(row).and_then(|shape| shape.arc);
        if let Some((arc, sweep)) = arc.zip(self.rows.sweep(row)) {
            let clockwise = self.rows.shape_of(row).is_some_and(|shape| shape.kind == Some(MotionType::ArcCw));
            let [to_u, to_v] = self.rows.to_center(row).map(Micro::to_f64);
            let way =
                |axis: usize| self.rows.positions.get(axis, row).minus(self.rows.positions.get(axis, before)).to_f64();
            let radius = (to_u * to_u + to_v * to_v).sqrt();
            let (end_u, end_v) = (way(arc.first) - to_u, way(arc.second) - to_v);
            let end_radius = (end_u * end_u + end_v * end_v).sqrt();
            let begin = libm::atan2(-to_v, -to_u);
            let chords = chords(radius, sweep, deviation);
            for chord in 1..chords {
                let share = f64::from(chord) / f64::from(chords);
                let angle = begin + if clockwise { -sweep } else { sweep } * share;
                let far = radius + (end_radius - radius) * share;
                let mut point = [0.0; 3];
                for (slot, ((axis, from), to)) in point.iter_mut().zip(self.axes.into_iter().zip(from).zip(to)) {
                    *slot = match axis {
                        Some(axis) if axis == arc.first => from + to_u + far * libm::cos(angle),
                        Some(axis) if axis == arc.second => from + to_v + far * libm::sin(angle),
                        Some(_) | None => from + (to - from) * share,
                    };
                }
                each(point);
            }
        }
        each(to);
    }

    /// How long the line of a row looks in each plane: XY, XZ, YZ.
    pub fn seen(&self, row: usize) -> [f64; 3] {
        let mut seen = [0.0; 3];
        let mut last: Option<Point> = None;
        self.points(row, 0.1, |point| {
            if let Some([x, y, z]) = last {
                let [dx, dy, dz] = [point[0] - x, point[1] - y, point[2] - z];
                for (sum, (a, b)) in seen.iter_mut().zip([(dx, dy), (dx, dz), (dy, dz)]) {
                    *sum += (a * a + b * b).sqrt();
                }
            }
            last = Some(point);
        });
        seen
    }
}

/// Into how many chords an arc is cut, radians.
fn chords(radius: f64, sweep: f64, deviation: f64) -> u32 {
    let step =
        if radius > deviation { 2.0 * libm::acos(1.0 - deviation / radius) } else { std::f64::consts::FRAC_PI_2 };
    let wanted = (sweep / step).ceil().clamp(2.0, 720.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 2 to 720")]
    let wanted = wanted as u32;
    wanted
}

fn fill(rows: &Rows, axis: usize) -> Vec<f64> {
    let count = rows.block.len();
    let is_known = |row: usize| rows.shape_of(row).is_some_and(|shape| shape.known & (1 << axis) != 0);
    let mut values = vec![0.0; count];
    let last = (0..count).rev().find(|row| is_known(*row));
    let mut next = last.map_or(0.0, |row| rows.positions.get(axis, row).to_f64());
    for (row, value) in values.iter_mut().enumerate().rev() {
        if is_known(row) {
            next = rows.positions.get(axis, row).to_f64();
        }
        *value = next;
    }
    values
}
