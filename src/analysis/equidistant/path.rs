//! The corrected path, element after element (EQU-1…EQU-4): an element is known once the corner behind it is.

use super::curve::{Curve, Point, cross, left, length, minus, plus, times};

/// Ends that are no further apart, in mm, are joined without a corner; an element vanishes when more is missing.
const CLOSE: f64 = 0.02;
/// How far chords may be from arcs, in mm.
const DEVIATION: f64 = 0.005;

/// A motion in the plane of the correction, with the third coordinate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    /// In the plane; `None`: nothing moves there.
    pub curve: Option<Curve>,
    pub from: Point,
    pub to: Point,
    /// The third coordinate at the start and at the end.
    pub heights: [f64; 2],
}

/// The block that an element comes from.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) struct Mark {
    pub seq: u64,
    /// Index among those of the caller.
    pub block: usize,
}

/// A piece of the corrected path: points of the plane, each with its third coordinate.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Piece {
    pub mark: Mark,
    pub points: Vec<(Point, f64)>,
    pub collides: bool,
}

/// An element whose end is not known yet.
#[derive(Clone, Copy, Debug)]
struct Element {
    mark: Mark,
    leg: Leg,
    original: Curve,
    /// `None`: nothing is left of an arc on its inner side.
    offset: Option<Curve>,
    /// To the left, or to the right when negative.
    by: f64,
    /// Shares of the way.
    start: f64,
    end: f64,
    collides: bool,
}

impl Element {
    fn new(mark: Mark, leg: Leg, original: Curve, by: f64) -> Self {
        let offset = original.offset(by);
        Self { mark, leg, original, offset, by, start: 0.0, end: 1.0, collides: offset.is_none() }
    }

    /// Where the corrected path would be at its start or end without a corner.
    fn beside(&self, share: f64) -> Point {
        plus(self.original.at(share), times(left(self.original.tangent(share)), self.by))
    }

    fn height(&self, share: f64) -> f64 {
        let [from, to] = self.leg.heights;
        from + (to - from) * share
    }

    /// How much is missing, in mm, when its start lies behind its end.
    fn missing(&self) -> f64 {
        self.offset.map_or(0.0, |curve| (self.start - self.end) * curve.length())
    }

    fn piece(&self) -> Piece {
        let collides = self.collides || self.missing() > CLOSE;
        let points = match self.offset {
            Some(curve) if !collides => {
                points(&curve, self.start, self.end.max(self.start), |share| self.height(share))
            }
            Some(curve) => points(&curve, 0.0, 1.0, |share| self.height(share)),
            None => vec![(self.beside(0.0), self.height(0.0)), (self.beside(1.0), self.height(1.0))],
        };
        Piece { mark: self.mark, points, collides }
    }
}

/// A curve by chords.
fn points(curve: &Curve, start: f64, end: f64, height: impl Fn(f64) -> f64) -> Vec<(Point, f64)> {
    let chords = match *curve {
        Curve::Line { .. } => 1,
        Curve::Arc { radius, sweep, .. } => {
            let step = if radius > DEVIATION { 2.0 * libm::acos(1.0 - DEVIATION / radius) } else { 1.0 };
            let wanted = (sweep.abs() * (end - start) / step).ceil().clamp(1.0, 720.0);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 720")]
            let wanted = wanted as u32;
            wanted
        }
    };
    let at = |chord: u32| start + (end - start) * f64::from(chord) / f64::from(chords);
    (0..=chords).map(at).map(|share| (curve.at(share), height(share))).collect()
}

/// The corrected path as it grows.
#[derive(Debug, Default)]
pub(super) struct Corrected {
    state: State,
    /// Motions of the third axis behind the current element, with their heights: the corner gives their place.
    verticals: Vec<(Mark, [f64; 2])>,
    pieces: Vec<Piece>,
}

#[derive(Debug, Default)]
enum State {
    /// Without correction.
    #[default]
    Off,
    /// The first motion after G41 or G42: where it starts.
    Approach { mark: Mark, from: Point, height: f64 },
    /// On the corrected path.
    On { element: Box<Element>, height: f64 },
}

impl Corrected {
    /// A motion with a correction: to the left by `by`, or to the right when that is negative.
    pub fn follow(&mut self, mark: Mark, leg: Leg, by: f64) {
        let [_, height] = leg.heights;
        self.state = match (std::mem::take(&mut self.state), leg.curve) {
            // The third axis alone changes nothing before the path is reached, and keeps the offset on it (EQU-4).
            (State::Off, None) => State::Off,
            (State::Approach { mark, from, height }, None) => State::Approach { mark, from, height },
            (State::On { element, height: before }, None) => {
                self.verticals.push((mark, [before, height]));
                State::On { element, height }
            }
            (State::Off, Some(_)) => {
                let [from_height, _] = leg.heights;
                State::Approach { mark, from: leg.from, height: from_height }
            }
            (State::Approach { mark: approach, from, height: from_height }, Some(curve)) => {
                let element = Box::new(Element::new(mark, leg, curve, by));
                let [element_height, _] = leg.heights;
                self.pieces.push(Piece {
                    mark: approach,
                    points: vec![(from, from_height), (element.beside(0.0), element_height)],
                    collides: false,
                });
                State::On { element, height }
            }
            (State::On { element, height: between }, Some(curve)) => {
                let next = Element::new(mark, leg, curve, by);
                let next = self.corner(*element, next, between);
                State::On { element: Box::new(next), height }
            }
        };
    }

    /// A motion after G40: the first one in the plane leads back to the programmed path (EQU-2), those of the third
    /// axis alone before it keep the offset (EQU-4).
    pub fn leave(&mut self, mark: Mark, leg: Leg) {
        let State::On { element, height } = std::mem::take(&mut self.state) else { return };
        let [_, end] = leg.heights;
        if leg.curve.is_none() {
            self.verticals.push((mark, [height, end]));
            self.state = State::On { element, height: end };
            return;
        }
        let point = self.finish(&element);
        self.pieces.push(Piece { mark, points: vec![(point, height), (leg.to, end)], collides: false });
    }

    /// What follows cannot be told: the path ends here.
    pub fn stop(&mut self) {
        if let State::On { element, .. } = std::mem::take(&mut self.state) {
            self.finish(&element);
        }
    }

    /// Adds an element whose end is known, and the motions of the third axis at its end; gives that end.
    fn finish(&mut self, element: &Element) -> Point {
        let piece = element.piece();
        let end = piece.points.last().map_or_else(|| element.beside(1.0), |(point, _)| *point);
        self.pieces.push(piece);
        for (mark, [from, to]) in self.verticals.drain(..) {
            self.pieces.push(Piece { mark, points: vec![(end, from), (end, to)], collides: false });
        }
        end
    }

    /// The pieces that are finished.
    pub fn take(&mut self) -> impl Iterator<Item = Piece> {
        self.pieces.drain(..)
    }

    /// Joins two elements; gives the second with its start.
    fn corner(&mut self, mut before: Element, mut next: Element, height: f64) -> Element {
        let (from, to) = (before.beside(1.0), next.beside(0.0));
        let turn = cross(before.original.tangent(1.0), next.original.tangent(0.0));
        let same_side = (before.by - next.by).abs() < 1e-9;
        let mut bridge = None;
        if length(minus(to, from)) > CLOSE {
            if !same_side {
                bridge = Some(vec![(from, height), (to, height)]);
            } else if turn * next.by > 0.0 {
                match before.offset.zip(next.offset).and_then(|(mine, its)| mine.inner_crossing(&its)) {
                    Some((mine, its)) => (before.end, next.start) = (mine, its),
                    // Both go on without meeting: the shorter one has no place.
                    None if before.original.length() < next.original.length() => before.collides = true,
                    None => next.collides = true,
                }
            } else {
                bridge = Some(round(next.leg.from, from, to, next.by, height));
            }
        }
        self.finish(&before);
        if let Some(points) = bridge {
            self.pieces.push(Piece { mark: before.mark, points, collides: false });
        }
        next
    }
}

/// The arc about an outer corner.
fn round(about: Point, from: Point, to: Point, by: f64, height: f64) -> Vec<(Point, f64)> {
    let angle = |[x, y]: Point| libm::atan2(y, x);
    let start = angle(minus(from, about));
    let mut sweep = angle(minus(to, about)) - start;
    // With the path on the left the corner is turned to the right, and the other way round.
    let turn = std::f64::consts::TAU;
    if by > 0.0 && sweep > 0.0 {
        sweep -= turn;
    } else if by < 0.0 && sweep < 0.0 {
        sweep += turn;
    }
    let curve = Curve::Arc { center: about, radius: by.abs(), start, sweep };
    points(&curve, 0.0, 1.0, |_| height)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn leg(from: Point, to: Point) -> Leg {
        let curve = (from != to).then_some(Curve::Line { from, to });
        Leg { curve, from, to, heights: [0.0, 0.0] }
    }

    /// Follows lines from the first point on, the first of them to the path, the last one back.
    fn along(points: &[Point], by: f64) -> Vec<Piece> {
        let mut corrected = Corrected::default();
        let last = points.len() - 2;
        for (at, pair) in points.windows(2).enumerate() {
            let mark = Mark { seq: at as u64, block: at };
            if at == last {
                corrected.leave(mark, leg(pair[0], pair[1]))
            } else {
                corrected.follow(mark, leg(pair[0], pair[1]), by)
            }
        }
        corrected.take().collect()
    }

    fn rounded(piece: &Piece) -> Vec<Point> {
        piece.points.iter().map(|([x, y], _)| [(x * 1e6).round() / 1e6, (y * 1e6).round() / 1e6]).collect()
    }

    /// EQU-1 inner corner, EQU-2 to the path and back.
    #[test]
    fn inner_corners_are_cut() {
        let pieces = along(&[[0.0, -5.0], [0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]], 2.0);
        let found: Vec<Vec<Point>> = pieces.iter().map(rounded).collect();
        assert_eq!(found[0], [[0.0, -5.0], [0.0, 2.0]]);
        assert_eq!(found[1], [[0.0, 2.0], [8.0, 2.0]]);
        assert_eq!(found[2], [[8.0, 2.0], [8.0, 10.0]]);
        assert_eq!(found[3], [[8.0, 10.0], [0.0, 10.0]]);
        assert!(pieces.iter().all(|piece| !piece.collides));
    }

    /// EQU-1 outer corner: an arc about it.
    #[test]
    fn outer_corners_are_rounded() {
        let pieces = along(&[[0.0, 5.0], [0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]], -2.0);
        let found: Vec<Vec<Point>> = pieces.iter().map(rounded).collect();
        assert_eq!(found[1], [[0.0, -2.0], [10.0, -2.0]]);
        assert_eq!((found[2][0], *found[2].last().unwrap()), ([10.0, -2.0], [12.0, 0.0]));
        let middle = pieces[2].points[pieces[2].points.len() / 2].0;
        assert!((length(minus(middle, [10.0, 0.0])) - 2.0).abs() < 1e-9 && middle[0] > 10.0 && middle[1] < 0.0);
        assert_eq!(found[3], [[12.0, 0.0], [12.0, 10.0]]);
    }

    /// EQU-3: a step that is narrower than the tool.
    #[test]
    fn a_short_element_vanishes() {
        let pieces = along(&[[-5.0, 0.0], [0.0, 0.0], [10.0, 0.0], [10.0, 1.0], [0.0, 1.0], [0.0, 9.0]], 2.0);
        let colliding: Vec<u64> = pieces.iter().filter(|piece| piece.collides).map(|piece| piece.mark.seq).collect();
        assert_eq!(colliding, [2]);
    }

    /// EQU-4: the third axis alone.
    #[test]
    fn the_third_axis_keeps_the_offset() {
        let mut corrected = Corrected::default();
        let mark = |seq: u64| Mark { seq, block: 0 };
        corrected.follow(mark(0), leg([0.0, -5.0], [0.0, 0.0]), 2.0);
        corrected.follow(mark(1), leg([0.0, 0.0], [10.0, 0.0]), 2.0);
        let down = Leg { curve: None, from: [10.0, 0.0], to: [10.0, 0.0], heights: [0.0, -3.0] };
        corrected.follow(mark(2), down, 2.0);
        corrected.follow(mark(3), Leg { heights: [-3.0, -3.0], ..leg([10.0, 0.0], [10.0, 10.0]) }, 2.0);
        corrected.stop();
        let pieces: Vec<Piece> = corrected.take().collect();
        let seqs: Vec<u64> = pieces.iter().map(|piece| piece.mark.seq).collect();
        assert_eq!(seqs, [0, 1, 2, 3]);
        assert_eq!(rounded(&pieces[2]), [[8.0, 2.0], [8.0, 2.0]]);
        assert_eq!([pieces[2].points[0].1, pieces[2].points[1].1], [0.0, -3.0]);
    }

    /// EQU-4 after G40: the tool is lifted beside the contour, and the first motion in the plane leads back.
    #[test]
    fn lifting_after_the_path_keeps_the_offset() {
        let mut corrected = Corrected::default();
        let mark = |seq: u64| Mark { seq, block: 0 };
        corrected.follow(mark(0), leg([0.0, -5.0], [0.0, 0.0]), 2.0);
        corrected.follow(mark(1), leg([0.0, 0.0], [10.0, 0.0]), 2.0);
        let up = Leg { curve: None, from: [10.0, 0.0], to: [10.0, 0.0], heights: [0.0, 20.0] };
        corrected.leave(mark(2), up);
        corrected.leave(mark(3), Leg { heights: [20.0, 20.0], ..leg([10.0, 0.0], [30.0, 0.0]) });
        corrected.leave(mark(4), leg([30.0, 0.0], [40.0, 0.0]));
        let pieces: Vec<Piece> = corrected.take().collect();
        let seqs: Vec<u64> = pieces.iter().map(|piece| piece.mark.seq).collect();
        assert_eq!(seqs, [0, 1, 2, 3]);
        assert_eq!(pieces[2].points, [([10.0, 2.0], 0.0), ([10.0, 2.0], 20.0)]);
        assert_eq!(pieces[3].points, [([10.0, 2.0], 20.0), ([30.0, 0.0], 20.0)]);
    }
}
