//! `[format]`: how programs are laid out.

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
