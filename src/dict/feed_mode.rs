//! What F counts under the functions of group G6, and whether the cutting speed is constant (§8: TEC-1, TEC-5).

use super::{Bilingual, GCode, GGroup};

/// What F counts.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum FeedPer {
    /// Millimetres or degrees per minute.
    Minute,
    /// Millimetres or degrees per revolution of the spindle.
    Revolution,
}

impl FeedPer {
    /// The unit of a path in millimetres, in words.
    pub const fn unit(self) -> Bilingual {
        match self {
            Self::Minute => Bilingual { en: "mm/min", cs: "mm/min" },
            Self::Revolution => Bilingual { en: "mm per revolution", cs: "mm na otáčku" },
        }
    }
}

/// The meaning of a function of group G6.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct FeedMode {
    /// What F counts.
    pub per: FeedPer,
    /// The cutting speed is constant: S is no number of revolutions.
    pub constant_cut: bool,
}

impl FeedMode {
    /// Whether a working motion needs S (TEC-3).
    pub const fn needs_speed(self) -> bool {
        match self.per {
            FeedPer::Minute => self.constant_cut,
            FeedPer::Revolution => true,
        }
    }
}

/// The row of a function of group G6.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum FeedRow {
    /// The same on every machine.
    Mode(FeedMode),
    /// The key `g97` of the project file says it (TEC-5).
    Key,
}

const fn mode(per: FeedPer, constant_cut: bool) -> FeedRow {
    FeedRow::Mode(FeedMode { per, constant_cut })
}

const ROWS: &[(GCode, FeedRow)] = &[
    (GCode::G94, mode(FeedPer::Minute, false)),
    (GCode::G95, mode(FeedPer::Revolution, false)),
    (GCode::G96, mode(FeedPer::Minute, true)),
    (GCode::G97, FeedRow::Key),
];

impl FeedRow {
    /// The row of a function; `None` when it is in another group.
    pub const fn of(function: GCode) -> Option<Self> {
        let mut rows = ROWS;
        while let [(code, row), rest @ ..] = rows {
            if code.number() == function.number() {
                return Some(*row);
            }
            rows = rest;
        }
        None
    }
}

/// A function of group G6 does not compile without its row.
const _: () = {
    let mut functions = GCode::ALL;
    while let [function, rest @ ..] = functions {
        let is_mode = matches!(function.group(), GGroup::G6);
        assert!(
            is_mode == FeedRow::of(*function).is_some(),
            "a function of group G6 needs its row, and no other has one"
        );
        functions = rest;
    }
};
