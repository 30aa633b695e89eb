//! Lines and arcs in a plane: points, directions, offsets, crossings. Lengths in millimetres, angles in radians; shares
//! of a curve run from 0 at its start to 1 at its end.

use std::f64::consts::TAU;

/// A point or a vector in the plane.
pub(super) type Point = [f64; 2];

/// A line, or an arc about its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Curve {
    Line {
        from: Point,
        to: Point,
    },
    /// `sweep` is positive from the first axis of the plane towards the second.
    Arc {
        center: Point,
        radius: f64,
        start: f64,
        sweep: f64,
    },
}

pub(super) fn minus([ax, ay]: Point, [bx, by]: Point) -> Point {
    [ax - bx, ay - by]
}

pub(super) fn plus([ax, ay]: Point, [bx, by]: Point) -> Point {
    [ax + bx, ay + by]
}

pub(super) fn times([x, y]: Point, by: f64) -> Point {
    [x * by, y * by]
}

pub(super) fn cross([ax, ay]: Point, [bx, by]: Point) -> f64 {
    ax * by - ay * bx
}

pub(super) fn dot([ax, ay]: Point, [bx, by]: Point) -> f64 {
    ax * bx + ay * by
}

pub(super) fn length(vector: Point) -> f64 {
    dot(vector, vector).sqrt()
}

/// The vector turned by a right angle, from the first axis towards the second: to the left.
pub(super) const fn left([x, y]: Point) -> Point {
    [-y, x]
}

fn unit(vector: Point) -> Point {
    let length = length(vector);
    if length > 0.0 { times(vector, 1.0 / length) } else { vector }
}

fn direction(angle: f64) -> Point {
    [libm::cos(angle), libm::sin(angle)]
}

impl Curve {
    /// The point at a share of the way.
    pub fn at(&self, share: f64) -> Point {
        match *self {
            Self::Line { from, to } => plus(from, times(minus(to, from), share)),
            Self::Arc { center, radius, start, sweep } => plus(center, times(direction(start + sweep * share), radius)),
        }
    }

    /// The direction at a share of the way, of length 1.
    pub fn tangent(&self, share: f64) -> Point {
        match *self {
            Self::Line { from, to } => unit(minus(to, from)),
            Self::Arc { start, sweep, .. } => times(left(direction(start + sweep * share)), sweep.signum()),
        }
    }

    pub fn length(&self) -> f64 {
        match *self {
            Self::Line { from, to } => length(minus(to, from)),
            Self::Arc { radius, sweep, .. } => radius * sweep.abs(),
        }
    }

    /// The parallel curve, to the left by `by`, or to the right when that is negative (EQU-1). `None` when an arc has
    /// nothing left on its inner side (EQU-3).
    pub fn offset(&self, by: f64) -> Option<Self> {
        match *self {
            Self::Line { from, to } => {
                let aside = times(left(self.tangent(0.0)), by);
                Some(Self::Line { from: plus(from, aside), to: plus(to, aside) })
            }
            Self::Arc { center, radius, start, sweep } => {
                let radius = radius - by * sweep.signum();
                (radius > 1e-9).then_some(Self::Arc { center, radius, start, sweep })
            }
        }
    }

    /// Where this curve, going on backwards from its end, meets the one that follows it, going on from its start: the
    /// shares of both. Of several places that which is least far from the corner. `None` when they do not meet.
    pub fn inner_crossing(&self, next: &Self) -> Option<(f64, f64)> {
        let far = |(mine, its): &(f64, f64)| (1.0 - mine) * self.length() + its * next.length();
        let before = |share: f64| self.near(share, 1.0);
        let after = |share: f64| next.near(share, 0.0);
        let shares = self.crossings(next).into_iter().flatten();
        shares.map(|(mine, its)| (before(mine), after(its))).min_by(|a, b| far(a).total_cmp(&far(b)))
    }

    /// A share of the same place: of an arc that which lies before its end, or behind its start.
    fn near(&self, share: f64, end: f64) -> f64 {
        match *self {
            Self::Line { .. } => share,
            Self::Arc { sweep, .. } => {
                let round = TAU / sweep.abs();
                let turns = ((share - end) / round).round();
                let nearest = share - turns * round;
                // A place just beyond the corner is the corner itself.
                let slack = 1e-6;
                match (end > 0.5, nearest > end + slack, nearest < end - slack) {
                    (true, true, _) => nearest - round,
                    (false, _, true) => nearest + round,
                    _ => nearest,
                }
            }
        }
    }

    /// All places that lie on both, as lines without ends and whole circles: shares of both.
    fn crossings(&self, other: &Self) -> [Option<(f64, f64)>; 2] {
        let shares = |point: Point| (self.share_of(point), other.share_of(point));
        match (*self, *other) {
            (Self::Line { from, to }, Self::Line { from: other_from, to: other_to }) => {
                let (way, other_way) = (minus(to, from), minus(other_to, other_from));
                let across = cross(way, other_way);
                if across.abs() < 1e-12 {
                    return [None, None];
                }
                let share = cross(minus(other_from, from), other_way) / across;
                [Some(shares(self.at(share))), None]
            }
            (Self::Line { from, to }, Self::Arc { center, radius, .. })
            | (Self::Arc { center, radius, .. }, Self::Line { from, to }) => {
                line_and_circle(from, to, center, radius).map(|point| point.map(shares))
            }
            (Self::Arc { center, radius, .. }, Self::Arc { center: other, radius: other_radius, .. }) => {
                circles(center, radius, other, other_radius).map(|point| point.map(shares))
            }
        }
    }

    /// The share of the way at which a point lies that is on the curve or goes on from it.
    fn share_of(&self, point: Point) -> f64 {
        match *self {
            Self::Line { from, to } => {
                let way = minus(to, from);
                dot(minus(point, from), way) / dot(way, way)
            }
            Self::Arc { center, start, sweep, .. } => {
                let [x, y] = minus(point, center);
                (libm::atan2(y, x) - start) / sweep
            }
        }
    }
}

fn line_and_circle(from: Point, to: Point, center: Point, radius: f64) -> [Option<Point>; 2] {
    let way = unit(minus(to, from));
    let along = dot(minus(center, from), way);
    let foot = plus(from, times(way, along));
    let aside = length(minus(center, foot));
    let half = radius * radius - aside * aside;
    if half < 0.0 {
        return [None, None];
    }
    let half = half.sqrt();
    [Some(plus(foot, times(way, half))), Some(minus(foot, times(way, half)))]
}

fn circles(a: Point, a_radius: f64, b: Point, b_radius: f64) -> [Option<Point>; 2] {
    let apart = length(minus(b, a));
    if apart < 1e-9 || apart > a_radius + b_radius || apart < (a_radius - b_radius).abs() {
        return [None, None];
    }
    let along = (apart * apart + a_radius * a_radius - b_radius * b_radius) / (2.0 * apart);
    let half = (a_radius * a_radius - along * along).max(0.0).sqrt();
    let way = unit(minus(b, a));
    let foot = plus(a, times(way, along));
    let aside = times(left(way), half);
    [Some(plus(foot, aside)), Some(minus(foot, aside))]
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;

    fn line(from: Point, to: Point) -> Curve {
        Curve::Line { from, to }
    }

    #[test]
    fn offsets_lie_to_the_left() {
        assert_eq!(line([0.0, 0.0], [10.0, 0.0]).offset(2.0), Some(line([0.0, 2.0], [10.0, 2.0])));
        let arc = Curve::Arc { center: [0.0, 0.0], radius: 5.0, start: 0.0, sweep: FRAC_PI_2 };
        assert_eq!(arc.offset(2.0).map(|arc| arc.length()), Some(3.0 * FRAC_PI_2));
        assert_eq!(arc.offset(-2.0).map(|arc| arc.length()), Some(7.0 * FRAC_PI_2));
        assert_eq!(arc.offset(5.0), None);
        let clockwise = Curve::Arc { center: [0.0, 0.0], radius: 5.0, start: PI, sweep: -FRAC_PI_2 };
        assert_eq!(clockwise.offset(2.0).map(|arc| arc.length()), Some(7.0 * FRAC_PI_2));
    }

    #[test]
    fn inner_corners_cross() {
        let first = line([0.0, 0.0], [10.0, 0.0]).offset(2.0).unwrap();
        let second = line([10.0, 0.0], [10.0, 10.0]).offset(2.0).unwrap();
        let (mine, its) = first.inner_crossing(&second).unwrap();
        assert!((mine - 0.8).abs() < 1e-12 && (its - 0.2).abs() < 1e-12);
        let arc = Curve::Arc { center: [10.0, 5.0], radius: 5.0, start: -FRAC_PI_2, sweep: PI };
        let (mine, its) =
            line([4.0, 1.0], [10.0, 0.0]).offset(1.0).unwrap().inner_crossing(&arc.offset(1.0).unwrap()).unwrap();
        assert!(mine < 1.0 && its > 0.0 && its < 0.1, "{mine} {its}");
        assert_eq!(line([0.0, 0.0], [1.0, 0.0]).inner_crossing(&line([2.0, 1.0], [3.0, 1.0])), None);
    }
}
