//! `[format]`: how programs are laid out.

use super::Takes;
use super::project::Project;
use super::reader::Reader;
use super::row::{Default as Unless, Row, row};
use super::taken::Values;

/// How the numbers of G and M are written.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum Codes {
    /// `G1` becomes `G01`.
    #[default]
    TwoDigits,
    /// `G01` becomes `G1`.
    Short,
    /// As written.
    Keep,
}

impl Codes {
    /// Each with its name in the project file.
    pub const NAMED: [(&'static str, Self); 3] =
        [("two-digits", Self::TwoDigits), ("short", Self::Short), ("keep", Self::Keep)];
}

/// How dimensional words, F and values of R are written.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum Numbers {
    /// As written.
    #[default]
    Keep,
    /// Without zeros that say nothing, one before the point: `X036.120` becomes `X36.12`, `X.5` becomes `X0.5`.
    Short,
}

impl Numbers {
    /// Each with its name in the project file.
    pub const NAMED: [(&'static str, Self); 2] = [("keep", Self::Keep), ("short", Self::Short)];
}

/// `[format]` of the project file (FMT-5).
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Style {
    /// How the numbers of G and M are written.
    pub codes: Codes,
    /// How dimensional words, F and values of R are written.
    pub numbers: Numbers,
    /// Blanks before a line that continues a block, 1 to 8.
    pub indent: u8,
    /// Most empty lines in a row, 0 to 9.
    pub blank_lines: u8,
}

impl Default for Style {
    fn default() -> Self {
        Self { codes: Codes::TwoDigits, numbers: Numbers::Keep, indent: 2, blank_lines: 1 }
    }
}

fn codes() -> Vec<&'static str> {
    Codes::NAMED.iter().map(|(name, _)| *name).collect()
}

fn numbers() -> Vec<&'static str> {
    Numbers::NAMED.iter().map(|(name, _)| *name).collect()
}

const CODES: Row = row(
    "codes",
    Takes::OneOf(codes),
    Unless::Text("two-digits"),
    (
        "how the numbers of G and M are written: `G01`, `G1`, or as they are",
        "jak se píšou čísla G a M: `G01`, `G1`, nebo beze změny",
    ),
    "FMT-5",
);
const NUMBERS: Row = row(
    "numbers",
    Takes::OneOf(numbers),
    Unless::Text("keep"),
    (
        "how coordinates, F and values of R are written: as they are, or without needless zeros (`X036.120` becomes `X36.12`)",
        "jak se píšou souřadnice, F a hodnoty R: beze změny, nebo bez zbytečných nul (z `X036.120` je `X36.12`)",
    ),
    "FMT-5",
);
const INDENT: Row = row(
    "indent",
    Takes::Whole { min: 1, max: Some(8) },
    Unless::Whole(2),
    ("blanks before a line that continues a block", "mezery před řádkem, na kterém blok pokračuje"),
    "FMT-3",
);
const BLANK_LINES: Row = row(
    "blank-lines",
    Takes::Whole { min: 0, max: Some(9) },
    Unless::Whole(1),
    ("most empty lines in a row", "nejvyšší počet prázdných řádků za sebou"),
    "FMT-4",
);
/// `[format]`.
pub(super) const FORMAT: &[Row] = &[CODES, NUMBERS, INDENT, BLANK_LINES];

impl Project {
    /// `[format]`.
    pub(super) fn format(&mut self, _: &mut Reader<'_>, values: &Values) {
        let named = |name: &str| Codes::NAMED.iter().find(|(known, _)| *known == name).map(|(_, codes)| *codes);
        self.format.codes = values.choice(&CODES, named).map_or(self.format.codes, |it| it.value);
        let named = |name: &str| Numbers::NAMED.iter().find(|(known, _)| *known == name).map(|(_, numbers)| *numbers);
        self.format.numbers = values.choice(&NUMBERS, named).map_or(self.format.numbers, |it| it.value);
        self.format.indent = values.whole(&INDENT).map_or(self.format.indent, |it| it.value);
        self.format.blank_lines = values.whole(&BLANK_LINES).map_or(self.format.blank_lines, |it| it.value);
    }
}
