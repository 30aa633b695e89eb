//! The preparatory functions (§7 of the language).

use std::fmt;

use super::Bilingual;

/// How long a G function holds.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Lasting {
    /// Until another of its group.
    Modal,
    /// `+`: also what holds after power-up, a reset, M02 and M30.
    Default,
    /// `x`: in its own block; hides but does not cancel what was in force.
    Block,
}

impl Lasting {
    /// As in the manual's tables; in brackets where the manual has no mark.
    pub const fn mark(self, decided: bool) -> &'static str {
        match (self, decided) {
            (Self::Modal, _) => "",
            (Self::Default, false) => "+",
            (Self::Default, true) => "(+)",
            (Self::Block, false) => "x",
            (Self::Block, true) => "(x)",
        }
    }
}

/// A group of G functions; one of each holds at a time.
#[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
pub enum GGroup {
    /// Interpolation.
    G0,
    /// Plane.
    G1,
    /// Joining of blocks, copying, helix.
    G2,
    /// Radius correction.
    G3,
    /// Parameter arithmetic.
    G4,
    /// Zero offsets.
    G5,
    /// Unit of feed.
    G6,
    /// Calls and jumps.
    G7,
    /// Fixed cycles.
    G8,
    /// Absolute or incremental.
    G9,
    /// Dwell, tables, diameters.
    G10,
    /// Conversions of coordinates.
    G11,
}

impl GGroup {
    /// All groups, by number.
    pub const ALL: [Self; 12] = [
        Self::G0,
        Self::G1,
        Self::G2,
        Self::G3,
        Self::G4,
        Self::G5,
        Self::G6,
        Self::G7,
        Self::G8,
        Self::G9,
        Self::G10,
        Self::G11,
    ];

    /// Its number, 0–11.
    pub const fn index(self) -> usize {
        self as usize
    }

    /// What its functions have in common.
    pub const fn meaning(self) -> Bilingual {
        let (en, cs) = match self {
            Self::G0 => ("interpolation", "interpolace"),
            Self::G1 => ("plane", "rovina"),
            Self::G2 => ("joining of blocks, copying, helix", "napojování bloků, kopírování, šroubovice"),
            Self::G3 => ("radius correction", "poloměrová korekce"),
            Self::G4 => ("parameter arithmetic", "aritmetika parametrů"),
            Self::G5 => ("zero offsets", "posunutí nulového bodu"),
            Self::G6 => ("unit of feed", "jednotka posuvu"),
            Self::G7 => ("calls and jumps", "volání a skoky"),
            Self::G8 => ("fixed cycles", "pevné cykly"),
            Self::G9 => ("absolute or incremental", "absolutně nebo přírůstkově"),
            Self::G10 => ("dwell, tables, diameters", "prodleva, tabulky, průměry"),
            Self::G11 => ("conversions of coordinates", "přepočty souřadnic"),
        };
        Bilingual { en, cs }
    }
}

impl fmt::Display for GGroup {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "G{}", self.index())
    }
}

macro_rules! g_functions {
    ($($variant:ident $number:literal $group:ident $lasting:ident $rule:literal $en:literal, $cs:literal;)*) => {
        /// A preparatory function of the control.
        #[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
        #[repr(u8)]
        pub enum GCode {
            $(#[doc = $en] $variant = $number,)*
        }

        impl GCode {
            /// Every function, by group.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// The function of that number; `None` when it is in no group (GRP-1).
            #[inline]
            pub const fn from_number(number: u8) -> Option<Self> {
                match number {
                    $($number => Some(Self::$variant),)*
                    _ => None,
                }
            }

            /// Its number.
            #[inline]
            pub const fn number(self) -> u8 {
                self as u8
            }

            /// Its group.
            #[inline]
            pub const fn group(self) -> GGroup {
                match self { $(Self::$variant => GGroup::$group,)* }
            }

            /// How long it holds.
            #[inline]
            pub const fn lasting(self) -> Lasting {
                match self { $(Self::$variant => Lasting::$lasting,)* }
            }

            /// The rule of the language that says most of it, such as `MOT-5`.
            pub const fn rule(self) -> &'static str {
                match self { $(Self::$variant => $rule,)* }
            }

            /// Its effect.
            pub const fn meaning(self) -> Bilingual {
                match self { $(Self::$variant => Bilingual { en: $en, cs: $cs },)* }
            }
        }
    };
}

g_functions! {
    G00 0 G0 Default "MOT-1" "rapid traverse", "rychloposuv";
    G01 1 G0 Modal "MOT-1" "linear interpolation", "lineární interpolace";
    G02 2 G0 Modal "MOT-5" "circular interpolation, clockwise", "kruhová interpolace ve směru hodinových ručiček";
    G03 3 G0 Modal "MOT-5" "circular interpolation, counter-clockwise",
        "kruhová interpolace proti směru hodinových ručiček";
    G30 30 G0 Block "MOT-7" "approach of the reference point", "nájezd do reference";
    G33 33 G0 Modal "TEC-3" "thread cutting", "řezání závitu";
    G17 17 G1 Default "GRP-2" "plane XY", "rovina XY";
    G18 18 G1 Modal "GRP-2" "plane YZ (in ISO 6983 G18 is ZX)", "rovina YZ (v ISO 6983 je G18 rovina ZX)";
    G19 19 G1 Modal "GRP-2" "plane ZX (in ISO 6983 G19 is YZ)", "rovina ZX (v ISO 6983 je G19 rovina YZ)";
    G14 14 G1 Modal "GRP-2" "plane of Z and the 4th axis", "rovina Z a 4. osy";
    G15 15 G1 Modal "GRP-2" "plane of Y and the 4th axis", "rovina Y a 4. osy";
    G16 16 G1 Modal "GRP-2" "plane of the 4th axis and X", "rovina 4. osy a X";
    G05 5 G2 Modal "GRP-8" "copying from a template", "kopírování podle předlohy";
    G06 6 G2 Modal "GRP-8" "copying from memory", "kopírování z paměti";
    G07 7 G2 Modal "GRP-8" "copying into memory", "kopírování do paměti";
    G08 8 G2 Modal "GRP-8" "dragged axis", "vlečení osy";
    G09 9 G2 Modal "GRP-8" "helix (spiral)", "šroubovice (spirála)";
    G10 10 G2 Modal "GRP-8" "pitch of the spiral", "zadání stoupání spirály";
    G23 23 G2 Modal "GRP-7" "continuous path: blocks join without a stop", "plynulá návaznost bloků";
    G24 24 G2 Modal "CNT-1" "tight joining of blocks: a ramp in each", "těsné napojování bloků";
    G98 98 G2 Default "CNT-1"
        "basic state of the group: blocks join with ramps",
        "základní stav skupiny: bloky se napojují s rampami";
    G40 40 G3 Default "EQU-1" "radius correction off", "zrušení poloměrové korekce";
    G41 41 G3 Modal "EQU-1" "radius correction, tool left of the path", "poloměrová korekce vlevo";
    G42 42 G3 Modal "EQU-1" "radius correction, tool right of the path", "poloměrová korekce vpravo";
    G26 26 G4 Block "PAR-7" "parameter arithmetic, one operation (R5)", "aritmetika parametrů, jedna operace (R5)";
    G27 27 G4 Block "PAR-7"
        "parameter arithmetic, two operations (R5, R6)",
        "aritmetika parametrů, dvě operace (R5, R6)";
    G28 28 G4 Block "PAR-7"
        "parameter arithmetic, three operations (R5–R7)",
        "aritmetika parametrů, tři operace (R5–R7)";
    G29 29 G4 Block "PAR-7"
        "parameter arithmetic, four operations (R5–R8)",
        "aritmetika parametrů, čtyři operace (R5–R8)";
    G53 53 G5 Default "MOT-8" "zero offset 0", "0. posunutí nulového bodu";
    G54 54 G5 Modal "MOT-8" "zero offset 1", "1. posunutí nulového bodu";
    G55 55 G5 Modal "MOT-8" "zero offset 2", "2. posunutí nulového bodu";
    G56 56 G5 Modal "MOT-8" "zero offset 3", "3. posunutí nulového bodu";
    G57 57 G5 Modal "MOT-8" "zero offset 4", "4. posunutí nulového bodu";
    G58 58 G5 Block "MOT-8" "zero offset 5", "5. posunutí nulového bodu";
    G59 59 G5 Block "MOT-8" "zero offset 6", "6. posunutí nulového bodu";
    G94 94 G6 Default "TEC-1" "feed per minute", "posuv za minutu";
    G95 95 G6 Modal "TEC-1" "feed per revolution", "posuv na otáčku";
    G96 96 G6 Modal "TEC-1" "feed per minute, constant cutting speed", "posuv za minutu, konstantní řezná rychlost";
    G97 97 G6 Modal "TEC-5" "feed per minute, or per revolution with constant cutting speed: by the key `g97`",
        "posuv za minutu, nebo na otáčku s konstantní řeznou rychlostí: podle klíče `g97`";
    G70 70 G7 Default "PRG-3" "end of a subprogram or macrocycle", "konec podprogramu nebo makrocyklu";
    G71 71 G7 Block "FLW-1" "call of a subprogram", "volání podprogramu";
    G72 72 G7 Block "FLW-1" "call of a macrocycle", "volání makrocyklu";
    G73 73 G7 Block "FLW-3" "jump to a block of the same unit", "skok na blok téhož programového celku";
    G79 79 G7 Block "PRG-3" "entry of a subprogram or macrocycle", "vstup do podprogramu nebo makrocyklu";
    G80 80 G8 Default "GRP-6" "no fixed cycle", "zrušení pevného cyklu";
    G81 81 G8 Modal "GRP-6" "fixed cycle 81 of the ISO standard", "pevný cyklus 81 podle normy ISO";
    G82 82 G8 Modal "GRP-6" "fixed cycle 82 of the ISO standard", "pevný cyklus 82 podle normy ISO";
    G83 83 G8 Modal "GRP-6" "fixed cycle 83 of the ISO standard", "pevný cyklus 83 podle normy ISO";
    G84 84 G8 Modal "GRP-6" "fixed cycle 84 of the ISO standard", "pevný cyklus 84 podle normy ISO";
    G85 85 G8 Modal "GRP-6" "fixed cycle 85 of the ISO standard", "pevný cyklus 85 podle normy ISO";
    G86 86 G8 Modal "GRP-6" "fixed cycle 86 of the ISO standard", "pevný cyklus 86 podle normy ISO";
    G87 87 G8 Modal "GRP-6" "fixed cycle 87 of the ISO standard", "pevný cyklus 87 podle normy ISO";
    G88 88 G8 Modal "GRP-6" "fixed cycle 88 of the ISO standard", "pevný cyklus 88 podle normy ISO";
    G89 89 G8 Modal "GRP-6" "fixed cycle 89 of the ISO standard", "pevný cyklus 89 podle normy ISO";
    G90 90 G9 Default "MOT-1" "absolute coordinates", "absolutní souřadnice";
    G91 91 G9 Modal "MOT-1" "incremental coordinates", "přírůstkové souřadnice";
    G04 4 G10 Block "GRP-5" "dwell, Q in units of 10 ms", "časová prodleva, Q po 10 ms";
    G92 92 G10 Block "GRP-4" "writes the table of origins or of corrections", "zápis do tabulky počátků nebo korekcí";
    G93 93 G10 Block "GRP-4" "writes the origin so that the tool stands at the programmed coordinates",
        "zápis počátku tak, aby nástroj stál na programovaných souřadnicích";
    G74 74 G10 Modal "MOT-1" "diameter programming: X is a diameter", "průměrové programování: X je průměr";
    G75 75 G10 Default "MOT-1" "radius programming", "poloměrové programování";
    G34 34 G11 Default "MOT-8" "all conversions of coordinates off", "zrušení všech přepočtů souřadnic";
    G35 35 G11 Modal "GRP-4" "mirror image", "zrcadlení";
    G36 36 G11 Modal "GRP-4" "scale", "změna měřítka";
    G37 37 G11 Modal "GRP-4" "independent shift", "nezávislý posun";
    G38 38 G11 Modal "GRP-4" "first plane transformation", "první rovinná transformace";
    G39 39 G11 Modal "GRP-4" "second plane transformation", "druhá rovinná transformace";
    G31 31 G11 Modal "GRP-4" "spatial transformation", "prostorová transformace";
}

impl GCode {
    /// The function that holds in `group` after power-up unless configured (§7, GRP-3); none in G4.
    pub fn power_up(group: GGroup) -> Option<Self> {
        Self::ALL.iter().copied().find(|code| code.group() == group && matches!(code.lasting(), Lasting::Default))
    }

    /// Whether it is one of the fixed cycles G81–G89.
    #[inline]
    pub const fn is_cycle(self) -> bool {
        self.number() >= 81 && self.number() <= 89
    }

    /// Whether its block's axis words are data of a table or transformation, and nothing moves (GRP-4).
    #[inline]
    pub const fn makes_words_data(self) -> bool {
        matches!(self, Self::G92 | Self::G93 | Self::G31 | Self::G35 | Self::G36 | Self::G37 | Self::G38 | Self::G39)
    }

    /// Whether the manual marks neither how long it holds nor that it holds after power-up: [`Self::lasting`] is a
    /// decision then (GRP-3, §7).
    pub const fn is_lasting_decided(self) -> bool {
        matches!(self.group(), GGroup::G4)
            || matches!(self, Self::G00 | Self::G30 | Self::G53 | Self::G75 | Self::G34 | Self::G79)
    }

    /// How many operations G26–G29 perform; 0 for the other functions.
    pub const fn operations(self) -> usize {
        match self.group() {
            GGroup::G4 => (self.number() - 25) as usize,
            GGroup::G0
            | GGroup::G1
            | GGroup::G2
            | GGroup::G3
            | GGroup::G5
            | GGroup::G6
            | GGroup::G7
            | GGroup::G8
            | GGroup::G9
            | GGroup::G10
            | GGroup::G11 => 0,
        }
    }

    /// Whether records show what it does; copying and dragging they do not (GRP-8).
    pub const fn is_modelled(self) -> bool {
        !matches!(self, Self::G05 | Self::G06 | Self::G07 | Self::G08)
    }

    /// Whether it calls or jumps: G71, G72, G73.
    #[inline]
    pub const fn is_flow(self) -> bool {
        matches!(self, Self::G71 | Self::G72 | Self::G73)
    }

    /// Whether it names a unit or a block by L: G71, G72, G73, G79.
    #[inline]
    pub const fn takes_l(self) -> bool {
        self.is_flow() || matches!(self, Self::G79)
    }
}

impl fmt::Display for GCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "G{:02}", self.number())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// GRP-3: power-up state.
    #[test]
    fn power_up_state() {
        let numbers: Vec<Option<u8>> =
            GGroup::ALL.into_iter().map(|group| GCode::power_up(group).map(GCode::number)).collect();
        let expected = [Some(0), Some(17), Some(98), Some(40), None, Some(53), Some(94), Some(70), Some(80), Some(90)];
        assert_eq!(numbers[..10], expected);
        assert_eq!(numbers[10..], [Some(75), Some(34)]);
    }

    #[test]
    fn numbers_are_unique() {
        let mut numbers: Vec<u8> = GCode::ALL.iter().map(|code| code.number()).collect();
        numbers.sort_unstable();
        numbers.dedup();
        assert_eq!(numbers.len(), GCode::ALL.len());
    }
}
