//! From space onto a picture: parallel projections.

use super::lines::Point;

/// The plane of projection.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Plane {
    /// X to the right, Y up.
    Xy,
    /// X to the right, Z up.
    Xz,
    /// Y to the right, Z up.
    Yz,
    /// Z to the right, X up, as a lathe is drawn.
    Zx,
    /// From X-Y-Z+.
    Iso,
}

impl Plane {
    /// All, as they are named on the command line.
    pub const ALL: [(&'static str, Self); 5] =
        [("XY", Self::Xy), ("XZ", Self::Xz), ("YZ", Self::Yz), ("ZX", Self::Zx), ("iso", Self::Iso)];

    /// Directions to the right, up, and towards the eye.
    const fn directions(self) -> [Point; 3] {
        /// Half of the root of 2, a root of a sixth, a root of a third.
        const S: [f64; 3] = [std::f64::consts::FRAC_1_SQRT_2, 0.408_248_290_463_863, 0.577_350_269_189_625_8];
        match self {
            Self::Xy => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            Self::Xz => [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]],
            Self::Yz => [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]],
            Self::Zx => [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            Self::Iso => [[S[0], -S[0], 0.0], [S[1], S[1], 2.0 * S[1]], [-S[2], -S[2], S[2]]],
        }
    }
}

/// A box around points, in millimetres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub min: Point,
    pub max: Point,
}

impl Bounds {
    pub const EMPTY: Self = Self { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] };

    pub fn include(&mut self, point: Point) {
        for ((low, high), value) in self.min.iter_mut().zip(&mut self.max).zip(point) {
            *low = low.min(value);
            *high = high.max(value);
        }
    }

    /// Takes in what others hold.
    pub fn join(&mut self, other: &Self) {
        self.min.iter_mut().zip(other.min).for_each(|(low, other)| *low = low.min(other));
        self.max.iter_mut().zip(other.max).for_each(|(high, other)| *high = high.max(other));
    }

    pub fn is_empty(&self) -> bool {
        self.min > self.max
    }
}

/// Places on the picture, in pixels from its top left corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    pub right: Point,
    pub up: Point,
    pub towards: Point,
    /// Pixels a millimetre.
    pub scale: f64,
    offset: [f64; 2],
}

fn dot(a: Point, b: Point) -> f64 {
    let [ax, ay, az] = a;
    let [bx, by, bz] = b;
    ax * bx + ay * by + az * bz
}

impl Projection {
    /// Shows `bounds` within a frame: left, top, right, bottom in pixels.
    pub fn fit(plane: Plane, bounds: &Bounds, frame: [f64; 4]) -> Self {
        let [right, up, towards] = plane.directions();
        let [left, top, far, bottom] = frame;
        let extent = |direction: Point| {
            let sides = direction.into_iter().zip(bounds.min.into_iter().zip(bounds.max));
            sides.map(|(share, (low, high))| share.abs() * (high - low)).sum::<f64>().max(1e-3)
        };
        let scale = ((far - left) / extent(right)).min((bottom - top) / extent(up));
        let mut middle = [0.0; 3];
        for (slot, (low, high)) in middle.iter_mut().zip(bounds.min.into_iter().zip(bounds.max)) {
            *slot = (low + high) / 2.0;
        }
        let offset = [(left + far) / 2.0 - dot(right, middle) * scale, (top + bottom) / 2.0 + dot(up, middle) * scale];
        Self { right, up, towards, scale, offset }
    }

    /// Where a point stands.
    pub fn at(&self, point: Point) -> [f64; 2] {
        let [x, y] = self.offset;
        [x + dot(self.right, point) * self.scale, y - dot(self.up, point) * self.scale]
    }
}
