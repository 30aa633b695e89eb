//! The addresses of words (§2 of the language).

use std::fmt;

use super::{Bilingual, Decimal, Dialect};

/// One of the nine letters an axis may have.
#[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
pub enum AxisLetter {
    /// First axis.
    X,
    /// Second axis.
    Y,
    /// Third axis.
    Z,
    /// 4th to 6th axis, rotary unless configured.
    A,
    /// 4th to 6th axis, rotary unless configured.
    B,
    /// 4th to 6th axis, rotary unless configured; as a rule the spindle's under M19.
    C,
    /// 4th or 5th axis.
    U,
    /// 4th or 5th axis.
    V,
    /// 4th or 5th axis.
    W,
}

impl AxisLetter {
    /// All, in the order of a machine without configured axes (ADR-4).
    pub const ALL: [Self; 9] = [Self::X, Self::Y, Self::Z, Self::A, Self::B, Self::C, Self::U, Self::V, Self::W];

    /// The letter, in upper case.
    pub const fn letter(self) -> char {
        match self {
            Self::X => 'X',
            Self::Y => 'Y',
            Self::Z => 'Z',
            Self::A => 'A',
            Self::B => 'B',
            Self::C => 'C',
            Self::U => 'U',
            Self::V => 'V',
            Self::W => 'W',
        }
    }

    /// The letter of the linear axis beside it (ISO 841): U along X, V along Y, W along Z, and the other way round.
    pub const fn parallel(self) -> Option<Self> {
        match self {
            Self::X => Some(Self::U),
            Self::Y => Some(Self::V),
            Self::Z => Some(Self::W),
            Self::U => Some(Self::X),
            Self::V => Some(Self::Y),
            Self::W => Some(Self::Z),
            Self::A | Self::B | Self::C => None,
        }
    }

    /// The letter as a text.
    pub const fn name(self) -> &'static str {
        match self {
            Self::X => "X",
            Self::Y => "Y",
            Self::Z => "Z",
            Self::A => "A",
            Self::B => "B",
            Self::C => "C",
            Self::U => "U",
            Self::V => "V",
            Self::W => "W",
        }
    }

    /// The axis of that upper-case letter.
    pub fn from_letter(letter: char) -> Option<Self> {
        Self::ALL.into_iter().find(|axis| axis.letter() == letter)
    }

    /// Whether planes are named after the axis: X, Y, Z (§7).
    pub const fn is_of_the_planes(self) -> bool {
        matches!(self, Self::X | Self::Y | Self::Z)
    }

    /// Whether the axis is rotary on a machine without configured axes (ADR-4).
    pub const fn is_rotary_by_default(self) -> bool {
        matches!(self, Self::A | Self::B | Self::C)
    }
}

impl fmt::Display for AxisLetter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.letter())
    }
}

macro_rules! addresses {
    ($($variant:ident $letter:literal $byte:literal $form:expr, $sign:literal, $lasting:literal, $rule:literal,
        $en:literal, $cs:literal;)*) => {
        /// The letter or sign that a word begins with.
        #[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
        #[repr(u8)]
        pub enum Address {
            $(#[doc = concat!("`", $letter, "`: ", $en)] $variant,)*
        }

        impl Address {
            /// Every address, in the order of the specification's table.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// The address of that byte, in either case (LEX-11).
            #[inline]
            pub const fn from_byte(byte: u8) -> Option<Self> {
                match byte.to_ascii_uppercase() {
                    $($byte => Some(Self::$variant),)*
                    _ => None,
                }
            }

            /// Its row in the dictionary.
            pub const fn row(self) -> &'static AddressRow {
                match self {
                    $(Self::$variant => &AddressRow {
                        letter: $letter,
                        form: $form,
                        sign: $sign,
                        lasts_until_changed: $lasting,
                        rule: $rule,
                        meaning: Bilingual { en: $en, cs: $cs },
                    },)*
                }
            }
        }
    };
}

/// The form of the value that an address takes (ADR-1, ADR-2 and the table of §2).
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum ValueForm {
    /// No value: `/`.
    None,
    /// A whole number in a range, both ends included.
    Whole {
        /// Least.
        min: i64,
        /// Greatest.
        max: i64,
    },
    /// A length in mm or an angle in degrees, ±69999.999.
    Dimension,
    /// The number of a parameter, then its value.
    Parameter,
    /// A feed (TEC-1).
    Feed,
    /// Whole 1–99; on CNC872 a real number, ±69999.999.
    Auxiliary,
    /// Four digits, each 0, 1 or 2.
    CorrectionDigits,
    /// 0–99; on CNC872 0–100.
    Technological,
}

impl ValueForm {
    /// Whether the value may have a decimal point (ADR-1).
    pub const fn takes_point(self, dialect: Dialect) -> bool {
        match self {
            Self::Dimension | Self::Parameter | Self::Feed => true,
            Self::Auxiliary => dialect.has_real_h(),
            Self::None | Self::Whole { .. } | Self::CorrectionDigits | Self::Technological => false,
        }
    }
}

/// A row of the dictionary of addresses.
#[derive(Clone, Copy, Debug)]
pub struct AddressRow {
    /// As written.
    pub letter: &'static str,
    /// What its value looks like.
    pub form: ValueForm,
    /// Whether the value may carry a sign (H: on CNC872 only).
    pub sign: bool,
    /// Whether it holds until changed; else, but for axes, which move once, it holds in its block.
    pub lasts_until_changed: bool,
    /// The rule of the language that says most of it, such as `ADR-2`.
    pub rule: &'static str,
    /// Its meaning.
    pub meaning: Bilingual,
}

/// The highest block number (BLK-7).
pub const HIGHEST_BLOCK: u32 = 99_999_999;
/// The highest number of a subprogram or macrocycle, and of a block that L can name (FLW-5).
pub const HIGHEST_L: u32 = 9999;
/// The highest number of a parameter (PAR-1).
pub const HIGHEST_PARAMETER: u8 = 95;
/// Reserved for control functions.
pub const RESERVED_PARAMETER: u8 = 95;
/// The first parameter that holds a control word (PAR-7).
pub const FIRST_CONTROL: u8 = 5;
/// The last one.
pub const LAST_CONTROL: u8 = 8;
/// The most repeats, and the longest dwell in units of 10 ms (GRP-5).
pub const HIGHEST_Q: i64 = 9999;
/// The highest P (ADR-2).
pub const HIGHEST_P: i64 = 99;
/// The highest spindle speed, unless configured.
pub const HIGHEST_S: u32 = 9999;
/// The range of F per revolution, in mm (TEC-1).
pub const FEED_PER_REVOLUTION: (Decimal, Decimal) = (Decimal::from_thousandths(1), Decimal::from_thousandths(99_999));

use ValueForm::{Auxiliary, CorrectionDigits, Dimension, Feed, Parameter, Technological, Whole};

addresses! {
    Program "%" b'%' Whole { min: 1, max: 999_999 }, false, false, "PRG-1",
        "program number", "číslo partprogramu";
    N "N" b'N' Whole { min: 1, max: HIGHEST_BLOCK as i64 }, false, false, "BLK-7",
        "block number", "číslo bloku";
    Skip "/" b'/' ValueForm::None, false, false, "BLK-6",
        "block skip: the block is left out while block skip is on",
        "vynechání bloku: při zapnutém režimu „/“ se blok neprovede";
    G "G" b'G' Whole { min: 0, max: 99 }, false, false, "GRP-1",
        "preparatory function", "přípravná funkce";
    X "X" b'X' Dimension, true, false, "MOT-1", "1st axis", "1. osa";
    Y "Y" b'Y' Dimension, true, false, "MOT-1", "2nd axis", "2. osa";
    Z "Z" b'Z' Dimension, true, false, "MOT-1", "3rd axis", "3. osa";
    A "A" b'A' Dimension, true, false, "ADR-4",
        "4th to 6th axis, by the machine builder",
        "4. až 6. osa, podle výrobce stroje";
    B "B" b'B' Dimension, true, false, "ADR-4",
        "4th to 6th axis, by the machine builder",
        "4. až 6. osa, podle výrobce stroje";
    C "C" b'C' Dimension, true, false, "ADR-4",
        "4th to 6th axis, by the machine builder",
        "4. až 6. osa, podle výrobce stroje";
    U "U" b'U' Dimension, true, false, "ADR-4",
        "4th or 5th axis, by the machine builder",
        "4. nebo 5. osa, podle výrobce stroje";
    V "V" b'V' Dimension, true, false, "ADR-4",
        "4th or 5th axis, by the machine builder",
        "4. nebo 5. osa, podle výrobce stroje";
    W "W" b'W' Dimension, true, false, "ADR-4",
        "4th or 5th axis, by the machine builder",
        "4. nebo 5. osa, podle výrobce stroje";
    I "I" b'I' Dimension, true, false, "MOT-3",
        "distance from the start of an arc to its centre along the first interpolated axis; with G23 the dynamic set",
        "vzdálenost středu kružnice od začátku oblouku v první interpolované ose; s G23 sada dynamiky";
    J "J" b'J' Dimension, true, false, "MOT-3",
        "distance from the start of an arc to its centre along the second interpolated axis",
        "vzdálenost středu kružnice od začátku oblouku ve druhé interpolované ose";
    K "K" b'K' Dimension, true, false, "GRP-8",
        "word of G09, G10, G33, fixed cycles and transformations",
        "slovo funkcí G09, G10, G33, pevných cyklů a transformací";
    R "R" b'R' Parameter, true, true, "PAR-1", "parameter R0–R95", "parametr R0–R95";
    Correction "&" b'&' CorrectionDigits, false, true, "ADR-2",
        "length corrections: which axis takes which, and in which direction",
        "délkové korekce: která patří do které osy a v jakém směru";
    D "D" b'D' Whole { min: 1, max: 99 }, false, true, "TEC-7",
        "entry in the table of corrections",
        "číslo položky v tabulce korekcí";
    F "F" b'F' Feed, false, true, "TEC-1",
        "feed: mm/min under G94 and G96, mm/rev under G95; under G97 by the key `g97`",
        "posuv: při G94 a G96 v mm/min, při G95 v mm/ot; při G97 podle klíče `g97`";
    S "S" b'S' Whole { min: 0, max: HIGHEST_S as i64 }, false, true, "TEC-3",
        "spindle speed in rev/min",
        "otáčky vřetena za minutu";
    L "L" b'L' Whole { min: 1, max: HIGHEST_L as i64 }, false, false, "FLW-7",
        "number of a subprogram or macrocycle, or the block to jump to",
        "číslo podprogramu nebo makrocyklu, případně bloku, na který se skáče";
    Q "Q" b'Q' Whole { min: 1, max: HIGHEST_Q }, false, false, "FLW-1",
        "repeats of a call or jump; with G04 the dwell in units of 10 ms",
        "počet opakování volání nebo skoku; s G04 časová prodleva po 10 ms";
    H "H" b'H' Auxiliary, false, true, "ADR-1",
        "auxiliary function, by the machine builder",
        "pomocná funkce, podle výrobce stroje";
    P "P" b'P' Whole { min: 1, max: HIGHEST_P }, false, true, "ADR-2",
        "auxiliary function, by the machine builder", "pomocná funkce, podle výrobce stroje";
    T "T" b'T' Whole { min: 0, max: 69_999_999 }, false, true, "TEC-4",
        "tool number; M06 changes the tool", "číslo nástroje; vymění ho až M06";
    M "M" b'M' Technological, false, false, "MFN-1", "technological function", "technologická funkce";
}

impl Address {
    /// As written.
    pub const fn letter(self) -> &'static str {
        self.row().letter
    }

    /// Whether it is a dimensional word: one whose value may have a decimal point in every dialect (ADR-1).
    pub const fn is_dimensional(self) -> bool {
        matches!(self.row().form, Dimension | Parameter | Feed)
    }

    /// Whether a sign may stand before the value (ADR-1).
    pub const fn takes_sign(self, dialect: Dialect) -> bool {
        if matches!(self.row().form, Auxiliary) { dialect.has_real_h() } else { self.row().sign }
    }

    /// The axis that the address may be.
    pub const fn axis(self) -> Option<AxisLetter> {
        match self {
            Self::X => Some(AxisLetter::X),
            Self::Y => Some(AxisLetter::Y),
            Self::Z => Some(AxisLetter::Z),
            Self::A => Some(AxisLetter::A),
            Self::B => Some(AxisLetter::B),
            Self::C => Some(AxisLetter::C),
            Self::U => Some(AxisLetter::U),
            Self::V => Some(AxisLetter::V),
            Self::W => Some(AxisLetter::W),
            Self::Program
            | Self::N
            | Self::Skip
            | Self::G
            | Self::I
            | Self::J
            | Self::K
            | Self::R
            | Self::Correction
            | Self::D
            | Self::F
            | Self::S
            | Self::L
            | Self::Q
            | Self::H
            | Self::P
            | Self::T
            | Self::M => None,
        }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.letter())
    }
}
