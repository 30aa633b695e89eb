//! The keys of `cnc872c.toml`: type, range, default, meaning in both languages, and the rule each comes from. The tables
//! that they belong to are in [`sections`](super::sections).

use super::row::{Default, Row, row, words};
use super::{ArcCenters, G97, SpindleAxis, Takes};
use crate::dict::{AxisLetter, Decimal, Dialect, Operation};
use crate::text::Encoding;

/// The words for a linear and a rotary axis.
pub(super) const AXIS_KINDS: [(&str, bool); 2] = [("linear", false), ("rotary", true)];

fn dialects() -> Vec<&'static str> {
    Dialect::ALL.iter().map(|dialect| dialect.name()).collect()
}

fn encodings() -> Vec<&'static str> {
    Encoding::NAMED.iter().map(|(name, _)| *name).collect()
}

pub(super) fn letters() -> Vec<&'static str> {
    AxisLetter::ALL.iter().map(|letter| letter.name()).collect()
}

fn spindle_axes() -> Vec<&'static str> {
    letters().into_iter().chain([SpindleAxis::NONE]).collect()
}

fn axis_kinds() -> Vec<&'static str> {
    AXIS_KINDS.iter().map(|(name, _)| *name).collect()
}

fn g97_meanings() -> Vec<&'static str> {
    G97::ALL.iter().map(|meaning| meaning.name()).collect()
}

fn arc_centers() -> Vec<&'static str> {
    ArcCenters::ALL.iter().map(|order| order.name()).collect()
}

pub(super) fn operations() -> Vec<&'static str> {
    Operation::ALL.iter().map(|operation| operation.name()).collect()
}

/// Any position or distance (§2).
pub(super) const DIMENSION: Takes =
    Takes::Number { min: Decimal::DIMENSION_MAX.negated(), max: Decimal::DIMENSION_MAX };

pub(super) const DIALECT: Row = row(
    "dialect",
    Takes::OneOf(dialects),
    Default::Text("cnc872"),
    ("the control that the programs are for", "řídicí systém, pro který programy jsou"),
    "§12",
)
.with_option("--dialect");
pub(super) const ENCODING: Row = row(
    "encoding",
    Takes::OneOf(encodings),
    Default::Text("cp852"),
    (
        "the code page of programs that are not in UTF-8, which is recognised by itself; `utf-8`: all others are an error",
        "kódová stránka programů, které nejsou v UTF-8; to se pozná samo; `utf-8`: jiné jsou chyba",
    ),
    "LEX-13",
)
.with_option("--encoding");
pub(super) const CHANNEL_CONFIG: Row = row(
    "channel-config",
    Takes::Path,
    Default::Nothing,
    (
        "the ChannelConfig whose `MFunctions` give the M functions; CNC872 only",
        "ChannelConfig, jehož `MFunctions` určují M funkce; jen CNC872",
    ),
    "MFN-2",
)
.with_option("--channel-config")
.with_example("\"Channel.xml\"");
pub(super) const MACROCYCLES: Row = row(
    "macrocycles",
    Takes::Paths,
    words("the program's folder", "složka programu"),
    (
        "folders to search for macrocycles, in this order; folders in them are not searched",
        "složky, kde se hledají makrocykly, v tomto pořadí; jejich podsložky se neprohledávají",
    ),
    "PRG-6",
)
.with_option("-L")
.with_example("[\"macros\"]");
pub(super) const BLOCK_SKIP: Row = row(
    "block-skip",
    Takes::Flag,
    Default::Flag(false),
    ("whether blocks with `/` are left out", "zda se bloky s `/` vynechávají"),
    "BLK-6",
)
.with_option("--block-skip");
pub(super) const OPTIONAL_STOP: Row = row(
    "optional-stop",
    Takes::Flag,
    Default::Flag(false),
    ("whether M01 stops the program", "zda M01 program zastaví"),
    "MFN-8",
)
.with_option("--optional-stop");
pub(super) const ORIENTED_STOP: Row = row(
    "oriented-stop",
    Takes::Flag,
    Default::Flag(true),
    ("whether the machine has the oriented spindle stop M19", "zda stroj má orientovaný stop vřetena M19"),
    "MFN-10",
);
pub(super) const SPINDLE_AXIS: Row = row(
    "spindle-axis",
    Takes::OneOf(spindle_axes),
    words(
        "`\"C\"`, else `\"A\"` or `\"B\"`, if the machine has it",
        "`\"C\"`, jinak `\"A\"` nebo `\"B\"`, má-li ji stroj",
    ),
    (
        "the rotary axis that the spindle is while M19 holds; `\"none\"`: the spindle is no axis",
        "rotační osa, kterou je vřeteno po dobu platnosti M19; `\"none\"`: vřeteno osou není",
    ),
    "MFN-10",
)
.with_example("\"C\"");
pub(super) const ORIENTED_POSITION: Row = row(
    "oriented-position",
    DIMENSION,
    Default::Number(Decimal::ZERO),
    ("position of the spindle after M19, in degrees", "poloha vřetena po M19 ve stupních"),
    "MFN-10",
);
pub(super) const G97_ROW: Row = row(
    "g97",
    Takes::OneOf(g97_meanings),
    Default::ByDialect(|dialect| format!("\"{}\"", G97::of(dialect).name())),
    (
        "what G97 means: feed per minute without constant cutting speed, or feed per revolution with it",
        "význam G97: posuv za minutu bez konstantní řezné rychlosti, nebo posuv na otáčku s ní",
    ),
    "TEC-5",
);
pub(super) const ARC_CENTERS: Row = row(
    "arc-centers",
    Takes::OneOf(arc_centers),
    Default::Text("machine-order"),
    (
        "which axes of an arc I and J belong to: in the order of the machine's axes, or of the plane's name (YZ, ZX)",
        "ke kterým osám oblouku patří I a J: v pořadí os stroje, nebo podle názvu roviny (YZ, ZX)",
    ),
    "MOT-3",
);
pub(super) const EXTENSIONS: Row = row(
    "extensions",
    Takes::Extensions,
    Default::Texts(super::EXTENSIONS),
    (
        "extensions of programs, where a folder is searched for them; upper and lower case alike",
        "přípony programů, které se hledají ve složce; na velikosti písmen nezáleží",
    ),
    "§11",
);

/// What comes before all tables.
pub(super) const ROOT: &[Row] = &[
    DIALECT,
    ENCODING,
    CHANNEL_CONFIG,
    MACROCYCLES,
    BLOCK_SKIP,
    OPTIONAL_STOP,
    ORIENTED_STOP,
    SPINDLE_AXIS,
    ORIENTED_POSITION,
    G97_ROW,
    ARC_CENTERS,
    EXTENSIONS,
];

pub(super) const AXIS_LETTER: Row = row(
    "letter",
    Takes::OneOf(letters),
    Default::Required,
    ("letter of the axis, each once", "písmeno osy, každé jednou"),
    "ADR-4",
)
.with_example("\"X\"");
pub(super) const AXIS_KIND: Row = row(
    "kind",
    Takes::OneOf(axis_kinds),
    words("`\"rotary\"` for A, B and C, `\"linear\"` for the others", "`\"rotary\"` pro A, B a C, jinak `\"linear\"`"),
    ("whether the axis travels (millimetres) or turns (degrees)", "zda osa jezdí (milimetry), nebo se otáčí (stupně)"),
    "ADR-4",
)
.with_example("\"linear\"");
pub(super) const AXIS_MIN: Row = row(
    "min",
    DIMENSION,
    Default::Nothing,
    (
        "least programmed coordinate, in mm or degrees; one below is warned of",
        "nejmenší programovaná souřadnice v mm nebo stupních; menší dá varování",
    ),
    "§11",
)
.with_example("-10.0");
pub(super) const AXIS_MAX: Row = row(
    "max",
    DIMENSION,
    Default::Nothing,
    (
        "greatest programmed coordinate, in mm or degrees; one above is warned of",
        "největší programovaná souřadnice v mm nebo stupních; větší dá varování",
    ),
    "§11",
)
.with_example("650.0");
/// One of `[[axes]]`.
pub(super) const AXIS: &[Row] = &[AXIS_LETTER, AXIS_KIND, AXIS_MIN, AXIS_MAX];

/// Greatest S that can be configured, in rev/min (§11).
const HIGHEST_SPEED: i64 = 99_999;

pub(super) const GEAR_M: Row = row(
    "m",
    Takes::Whole { min: 41, max: Some(44) },
    Default::Required,
    ("the function of the range, M41 to M44, each once", "funkce rozsahu, M41 až M44, každá jednou"),
    "MFN-9",
)
.with_example("41");
pub(super) const GEAR_MIN: Row = row(
    "min",
    Takes::Whole { min: 0, max: Some(HIGHEST_SPEED) },
    Default::Required,
    ("least speed of the range in rev/min", "nejnižší otáčky rozsahu v ot/min"),
    "MFN-9",
)
.with_example("20");
pub(super) const GEAR_MAX: Row = row(
    "max",
    Takes::Whole { min: 0, max: Some(HIGHEST_SPEED) },
    Default::Required,
    (
        "greatest speed of the range in rev/min, not below `min`, not above `limits.speed`",
        "nejvyšší otáčky rozsahu v ot/min, ne pod `min`, ne nad `limits.speed`",
    ),
    "MFN-9",
)
.with_example("500");
pub(super) const GEAR_OUTPUT: Row = row(
    "output",
    Takes::Number { min: Decimal::from_thousandths(1), max: Decimal::whole(1) },
    Default::Number(Decimal::whole(1)),
    ("part of the full voltage at `max`, for PB11 and PB12", "část plného napětí při `max`, pro PB11 a PB12"),
    "PLC-8",
);
/// One of `[[gears]]`.
pub(super) const GEAR: &[Row] = &[GEAR_M, GEAR_MIN, GEAR_MAX, GEAR_OUTPUT];

pub(super) const RECORDS: Row = row(
    "records",
    Takes::Whole { min: 1, max: None },
    Default::Whole(10_000_000),
    ("most block records of a stream", "nejvyšší počet záznamů bloků ve výstupu"),
    "FLW-9",
)
.with_option("--max-blocks");
pub(super) const NESTING: Row = row(
    "nesting",
    Takes::Whole { min: 1, max: Some(1000) },
    Default::Whole(32),
    ("most calls open at once", "nejvyšší počet současně otevřených volání"),
    "FLW-2",
);
pub(super) const FEED: Row = row(
    "feed",
    Takes::Number { min: Decimal::whole(1), max: Decimal::whole(9_999_999) },
    Default::ByDialect(|dialect| dialect.highest_feed().to_string()),
    ("greatest feed per minute in mm/min (G94, G96)", "nejvyšší posuv za minutu v mm/min (G94, G96)"),
    "TEC-1",
);
pub(super) const SPEED: Row = row(
    "speed",
    Takes::Whole { min: 1, max: Some(HIGHEST_SPEED) },
    Default::Whole(9999),
    ("greatest spindle speed S in rev/min", "nejvyšší otáčky vřetena S v ot/min"),
    "§2",
);
pub(super) const ARC_TOLERANCE: Row = row(
    "arc-tolerance",
    Takes::Number { min: Decimal::ZERO, max: Decimal::DIMENSION_MAX },
    Default::Number(Decimal::from_thousandths(10)),
    (
        "how far the radii at the start and the end of an arc may differ, in mm; a thousandth of the radius where that is more",
        "o kolik se smí lišit poloměr na začátku a na konci oblouku, v mm; tisícina poloměru tam, kde je to víc",
    ),
    "MOT-4",
);
/// `[limits]`.
pub(super) const LIMITS: &[Row] = &[RECORDS, NESTING, FEED, SPEED, ARC_TOLERANCE];

pub(super) const CORRECTION_RADIUS: Row = row(
    "radius",
    Takes::Number { min: Decimal::ZERO, max: Decimal::DIMENSION_MAX },
    Default::Required,
    ("radius of the tool in mm", "poloměr nástroje v mm"),
    "EQU-1",
)
.with_example("5.0");
/// One of `[corrections]`.
pub(super) const CORRECTION: &[Row] = &[CORRECTION_RADIUS];

pub(super) const MACROCYCLE_AXES: Row = row(
    "axes",
    Takes::Letters,
    words("any axis", "kteroukoli osou"),
    (
        "the axes that it may move, `[]` for none; after a call the positions of these are not known",
        "osy, kterými smí pohnout, „[]“ žádnou; jejich polohy pak po volání nejsou známy",
    ),
    "FLW-12",
)
.with_example("[\"Z\"]");
/// One of `[machine-macrocycles]`.
pub(super) const MACHINE_MACROCYCLE: &[Row] = &[MACROCYCLE_AXES];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::{Limits, Settings};

    /// The defaults told in the table are those that hold.
    #[test]
    fn defaults_are_those_of_the_settings() {
        let settings = Settings::default();
        let machine = &settings.machine;
        let limits = Limits::of(Dialect::default());
        let text = |row: Row| match row.default {
            Default::Text(text) => text,
            Default::Nothing
            | Default::Required
            | Default::Flag(_)
            | Default::Whole(_)
            | Default::Number(_)
            | Default::Texts(_)
            | Default::ByDialect(_)
            | Default::Words(_) => "",
        };
        assert_eq!(text(DIALECT), machine.dialect.name());
        assert_eq!(Encoding::NAMED.iter().find(|(name, _)| *name == text(ENCODING)).unwrap().1, settings.encoding);
        assert_eq!(text(ARC_CENTERS), machine.arc_centers.name());
        assert!(matches!(BLOCK_SKIP.default, Default::Flag(flag) if flag == settings.block_skip));
        assert!(matches!(OPTIONAL_STOP.default, Default::Flag(flag) if flag == settings.optional_stop));
        assert!(matches!(ORIENTED_STOP.default, Default::Flag(flag) if flag == machine.oriented_stop));
        assert!(matches!(ORIENTED_POSITION.default, Default::Number(deg) if deg == machine.oriented_position));
        assert!(matches!(EXTENSIONS.default, Default::Texts(texts) if *texts == settings.extensions[..]));
        assert!(matches!(RECORDS.default, Default::Whole(records) if u64::try_from(records) == Ok(limits.records)));
        assert!(matches!(NESTING.default, Default::Whole(nesting) if u32::try_from(nesting) == Ok(limits.nesting)));
        assert!(matches!(SPEED.default, Default::Whole(speed) if u32::try_from(speed) == Ok(limits.speed)));
        assert!(matches!(ARC_TOLERANCE.default, Default::Number(mm) if mm == limits.arc_tolerance));
        assert_eq!(Dialect::Cnc8x9.highest_feed(), Decimal::whole(24_000));
        assert_eq!(Dialect::Cnc872.highest_feed(), Decimal::whole(99_999));
        assert_eq!((G97::of(Dialect::Cnc872), G97::of(Dialect::Cnc8x6)), (G97::PerMinute, G97::PerRevolution));
        assert_eq!(machine.spindle_axis, SpindleAxis::Assumed);
    }
}
