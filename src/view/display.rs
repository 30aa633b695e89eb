//! A still picture as shapes in the order of drawing, for every file format.

use super::picture::LeftOut;
use crate::sure::small;

/// What an item is, for its colour and width.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Class {
    Grid,
    GridStrong,
    Rapid,
    Straight,
    Arc,
    Thread,
    Equidistant,
    Collision,
    Axis(u8),
    Ink,
    Faint,
}

/// A place in pixels.
pub(super) type Place = [f64; 2];

/// One thing that is drawn.
#[derive(Clone, Debug)]
pub(super) enum Item {
    /// Joined lines.
    Lines(Class, Vec<Place>),
    /// A dot before the block `seq`.
    Dot { at: Place, red: bool, seq: u64 },
    /// A text; `at` is the left end of its base line.
    Text { at: Place, class: Class, text: String },
}

/// A still picture.
#[derive(Debug)]
pub(super) struct Display {
    pub width: u32,
    pub height: u32,
    /// A description of it, for those who do not see it.
    pub title: String,
    /// Under the path.
    pub under: Vec<Item>,
    pub path: Vec<Item>,
    /// Over the path.
    pub over: Vec<Item>,
    /// Whether yellow dots are small and have no edge, because there are many.
    pub fine: bool,
    pub left_out: LeftOut,
}

impl Class {
    pub const fn name(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::GridStrong => "grid strong",
            Self::Rapid => "rapid",
            Self::Straight => "linear",
            Self::Arc => "arc",
            Self::Thread => "thread",
            Self::Equidistant => "equidistant",
            Self::Collision => "collision",
            Self::Axis(0) => "axis x",
            Self::Axis(1) => "axis y",
            Self::Axis(_) => "axis z",
            Self::Ink => "ink",
            Self::Faint => "faint",
        }
    }

    /// Red, green, blue.
    pub const fn colour(self) -> [u8; 3] {
        match self {
            Self::Grid => [0xe6, 0xeb, 0xef],
            Self::GridStrong => [0xc3, 0xce, 0xd6],
            Self::Rapid => [0x8a, 0x97, 0xa3],
            Self::Straight => [0x33, 0x41, 0x4d],
            Self::Arc => [0x00, 0x80, 0x5f],
            Self::Thread => [0x8a, 0x3f, 0x86],
            Self::Equidistant => [0x1f, 0x62, 0xe0],
            Self::Collision => [0xd8, 0x1f, 0x26],
            Self::Axis(0) => [0xb3, 0x26, 0x1e],
            Self::Axis(1) => [0x1c, 0x7a, 0x2e],
            Self::Axis(_) => [0x1f, 0x4f, 0xbf],
            Self::Ink => [0x1d, 0x2b, 0x36],
            Self::Faint => [0x52, 0x62, 0x6e],
        }
    }

    /// Width of lines, in pixels.
    pub const fn width(self) -> f32 {
        match self {
            Self::Grid | Self::GridStrong => 1.0,
            Self::Rapid => 1.1,
            Self::Equidistant | Self::Collision => 1.2,
            Self::Straight | Self::Arc | Self::Thread => 1.8,
            Self::Axis(_) => 2.0,
            Self::Ink | Self::Faint => 1.5,
        }
    }
}

/// Length of a dash of rapid motion, and of the gap behind it.
pub(super) const DASH: f32 = 5.0;
/// Red and yellow of dots, and their edge.
pub(super) const DOTS: [[u8; 3]; 3] = [[0xd8, 0x1f, 0x26], [0xf2, 0xb7, 0x05], [0x26, 0x32, 0x3b]];
/// Half the height of a red dot, radius of a yellow one, of one of many.
pub(super) const DOT_SIZES: [f64; 3] = [5.0, 3.0, 1.6];
/// Size of letters, and how wide one is taken to be.
pub(super) const LETTER: [f64; 2] = [12.0, 7.2];

/// How wide a text is taken to be, in pixels.
pub(super) fn text_width(text: &str) -> f64 {
    let letters = small(text.chars().count());
    f64::from(letters) * LETTER[1]
}
