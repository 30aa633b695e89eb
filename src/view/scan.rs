//! Lines of a still picture as an array of how far each pixel is covered. A path has a million of them and more, most
//! of them shorter than a pixel: outlines that are filled, as tiny-skia strokes, take a hundred times as long.

use super::display::Place;
use crate::parallel;

/// Pieces of a line that are drawn side by side with others.
const PART: usize = 1 << 16;

/// How far pixels are covered by lines of one colour: lines that touch or cross make no darker places.
#[derive(Debug)]
pub(super) struct Coverage {
    width: u32,
    height: u32,
    covered: Vec<u8>,
    /// The rows with something in them: from, up to.
    rows: [usize; 2],
}

/// A piece of a line.
#[derive(Clone, Copy, Debug)]
struct Piece {
    from: Place,
    to: Place,
    /// Half its width.
    half: f64,
    /// Whether it ends squarely, as dashes do; other ends are round, so that pieces join.
    square: bool,
}

impl Coverage {
    pub fn new(width: u32, height: u32) -> Self {
        let pixels = (width as usize).saturating_mul(height as usize);
        Self { width, height, covered: vec![0; pixels], rows: [usize::MAX, 0] }
    }

    /// Draws joined lines. `dash`: the length of dashes and of the gaps between them, 0 for none.
    pub fn lines(&mut self, places: &[Place], width: f64, dash: f64) {
        let half = width / 2.0;
        if dash > 0.0 {
            let mut done = 0.0;
            for pair in places.windows(2) {
                let [from, to] = *pair else { continue };
                done = self.dashes(from, to, half, dash, done);
            }
        } else if places.len() <= 2 * PART || parallel::threads() == 1 {
            self.whole_lines(places, half);
        } else {
            // Each part begins where the one before ends. What is covered does not depend on who draws it.
            let count = places.len().div_ceil(parallel::threads()).max(PART);
            let parts = (0..places.len()).step_by(count);
            let parts = parts.filter_map(|from| places.get(from..(from + count + 1).min(places.len()))).collect();
            let (width, height) = (self.width, self.height);
            let drawn = parallel::map(parts, |part| {
                let mut coverage = Self::new(width, height);
                coverage.whole_lines(part, half);
                coverage
            });
            drawn.iter().for_each(|other| self.add(other));
        }
    }

    fn whole_lines(&mut self, places: &[Place], half: f64) {
        for pair in places.windows(2) {
            let [from, to] = *pair else { continue };
            self.piece(Piece { from, to, half, square: false });
        }
    }

    /// Adds what another one of the same size covers.
    fn add(&mut self, other: &Self) {
        for (covered, other) in self.covered.iter_mut().zip(&other.covered) {
            *covered = (*covered).max(*other);
        }
        let ([first, end], [other_first, other_end]) = (self.rows, other.rows);
        self.rows = [first.min(other_first), end.max(other_end)];
    }

    /// Draws the dashes of a line that begins `done` behind the start of a dash; gives the same of its end.
    fn dashes(&mut self, [ax, ay]: Place, [bx, by]: Place, half: f64, dash: f64, done: f64) -> f64 {
        let length = ((bx - ax) * (bx - ax) + (by - ay) * (by - ay)).sqrt();
        if length <= 0.0 {
            return done;
        }
        let at = |way: f64| [ax + (bx - ax) * way / length, ay + (by - ay) * way / length];
        let mut begin = -done;
        while begin < length {
            let (from, to) = (begin.max(0.0), (begin + dash).min(length));
            if to > from {
                self.piece(Piece { from: at(from), to: at(to), half, square: true });
            }
            begin += 2.0 * dash;
        }
        (length + done) % (2.0 * dash)
    }

    fn piece(&mut self, piece: Piece) {
        let Piece { from: [ax, ay], to: [bx, by], half, .. } = piece;
        let (dx, dy) = (bx - ax, by - ay);
        let steep = dy.abs() > dx.abs();
        // Along the longer side `u`, across it `v`.
        let (mut start, mut end) = if steep { ([ay, ax], [by, bx]) } else { ([ax, ay], [bx, by]) };
        if end[0] < start[0] {
            (start, end) = (end, start);
        }
        let ([u0, v0], [u1, v1]) = (start, end);
        let slope = if u1 > u0 { (v1 - v0) / (u1 - u0) } else { 0.0 };
        let reach = half + 0.5;
        let spread = reach * (1.0 + slope * slope).sqrt();
        let (along, across) = if steep { (self.height, self.width) } else { (self.width, self.height) };
        let edge = Edge::new(start, end, half, piece.square);
        for u in pixels(u0 - reach, u1 + reach, along) {
            let middle = f64::from(u) + 0.5;
            let v = v0 + (middle.clamp(u0, u1) - u0) * slope;
            for w in pixels(v - spread, v + spread, across) {
                let covered = edge.covers([middle, f64::from(w) + 0.5]);
                if covered > 0 {
                    let (x, y) = if steep { (w, u) } else { (u, w) };
                    self.cover(x, y, covered);
                }
            }
        }
    }

    fn cover(&mut self, x: u32, y: u32, covered: u8) {
        let y = y as usize;
        if let Some(slot) = self.covered.get_mut(y * self.width as usize + x as usize) {
            *slot = (*slot).max(covered);
            let [first, end] = self.rows;
            self.rows = [first.min(y), end.max(y + 1)];
        }
    }

    /// Paints what is covered over pixels of four bytes, their colours multiplied by their opacity; nothing is covered
    /// then.
    pub fn paint(&mut self, pixels: &mut [u8], colour: [u8; 3]) {
        let [first, end] = self.rows;
        let (from, to) = (first.min(end) * self.width as usize, end * self.width as usize);
        let covered = self.covered.get_mut(from..to).unwrap_or_default();
        let under = pixels.get_mut(4 * from..4 * to).unwrap_or_default();
        let [red, green, blue] = colour;
        for (pixel, covered) in under.chunks_exact_mut(4).zip(covered) {
            let share = u32::from(std::mem::take(covered));
            if share == 0 {
                continue;
            }
            for (part, colour) in pixel.iter_mut().zip([red, green, blue, 255]) {
                let mixed = (u32::from(colour) * share + u32::from(*part) * (255 - share) + 127) / 255;
                *part = u8::try_from(mixed).unwrap_or(u8::MAX);
            }
        }
        self.rows = [usize::MAX, 0];
    }
}

/// The pixels from one place to another that the picture has.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturating; within the picture")]
fn pixels(from: f64, to: f64, limit: u32) -> std::ops::Range<u32> {
    from.floor().max(0.0) as u32..((to.floor() + 1.0).max(0.0) as u32).min(limit)
}

/// A piece prepared for asking how far it covers a pixel.
struct Edge {
    start: Place,
    way: [f64; 2],
    length: f64,
    /// One over the square of its length, 0 when it has none.
    inverse: f64,
    half: f64,
    square: bool,
}

impl Edge {
    fn new(start: Place, [u1, v1]: Place, half: f64, square: bool) -> Self {
        let way = [u1 - start[0], v1 - start[1]];
        let long = way[0] * way[0] + way[1] * way[1];
        Self { start, way, length: long.sqrt(), inverse: if long > 0.0 { 1.0 / long } else { 0.0 }, half, square }
    }

    /// How far the pixel about a point is covered.
    fn covers(&self, [u, v]: Place) -> u8 {
        let [from_u, from_v] = [u - self.start[0], v - self.start[1]];
        let share = (from_u * self.way[0] + from_v * self.way[1]) * self.inverse;
        let near = share.clamp(0.0, 1.0);
        let (off_u, off_v) = (from_u - near * self.way[0], from_v - near * self.way[1]);
        let far = off_u * off_u + off_v * off_v;
        let reach = self.half + 0.5;
        if far >= reach * reach {
            return 0;
        }
        let mut covered = (reach - far.sqrt()).min(1.0).min(2.0 * self.half);
        if self.square {
            let along = share * self.length;
            covered = covered.min(along + 0.5).min(self.length - along + 0.5);
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 255")]
        let covered = (covered.max(0.0) * 255.0).round() as u8;
        covered
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of digits: tenths of what is covered, `.` for nothing, `#` for all.
    fn drawn(width: u32, height: u32, draw: impl FnOnce(&mut Coverage)) -> Vec<String> {
        let mut coverage = Coverage::new(width, height);
        draw(&mut coverage);
        let digit = |covered: &u8| match covered {
            0 => '.',
            255 => '#',
            part => char::from(b'0' + part / 26),
        };
        coverage.covered.chunks(width as usize).map(|row| row.iter().map(digit).collect()).collect()
    }

    #[test]
    fn a_line_covers_its_width() {
        let level = drawn(8, 5, |coverage| coverage.lines(&[[2.0, 2.5], [6.0, 2.5]], 2.0, 0.0));
        assert_eq!(level, ["........", ".344443.", ".######.", ".344443.", "........"]);
        let upright = drawn(5, 6, |coverage| coverage.lines(&[[2.5, 0.0], [2.5, 6.0]], 1.0, 0.0));
        assert_eq!(upright, ["..#.."; 6]);
    }

    /// Drawn in one piece or in several side by side.
    #[test]
    fn long_lines_cover_the_same() {
        let count = u32::try_from(5 * PART / 2).unwrap();
        let places: Vec<Place> = (0..count)
            .map(|at| {
                let angle = f64::from(at) / 1000.0;
                [30.0 + libm::cos(angle) * f64::from(at % 5000) / 200.0, 25.0 + libm::sin(angle) * 20.0]
            })
            .collect();
        let drawn = |by: fn(&mut Coverage, &[Place])| {
            let mut coverage = Coverage::new(60, 50);
            by(&mut coverage, &places);
            (coverage.covered, coverage.rows)
        };
        let side_by_side = drawn(|coverage, places| coverage.lines(places, 1.3, 0.0));
        assert_eq!(side_by_side, drawn(|coverage, places| coverage.whole_lines(places, 0.65)));
    }

    #[test]
    fn dashes_go_on_behind_corners_and_end_squarely() {
        let dashed = drawn(12, 1, |coverage| coverage.lines(&[[0.0, 0.5], [3.0, 0.5], [12.0, 0.5]], 1.0, 4.0));
        assert_eq!(dashed, ["####....####"]);
    }

    #[test]
    fn what_is_covered_twice_is_no_darker_and_what_is_painted_is_gone() {
        let mut coverage = Coverage::new(4, 3);
        let mut pixels = vec![255; 4 * 3 * 4];
        coverage.lines(&[[1.0, 1.0], [3.0, 1.0], [1.0, 1.0]], 1.0, 0.0);
        let once = coverage.covered.clone();
        coverage.lines(&[[1.0, 1.0], [3.0, 1.0]], 1.0, 0.0);
        assert_eq!(coverage.covered, once);
        coverage.paint(&mut pixels, [255, 0, 0]);
        assert!(coverage.covered.iter().all(|covered| *covered == 0));
        assert!(pixels.chunks(4).all(|pixel| pixel[0] == 255 && pixel[3] == 255));
        assert!(pixels.chunks(4).any(|pixel| pixel[1] < 255));
        // Beyond the picture nothing is drawn.
        coverage.lines(&[[-90.0, -5.0], [90.0, 1e9]], 3.0, 0.0);
    }
}
