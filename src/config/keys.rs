//! Every key of `cnc872c.toml`: type, range, default, meaning in both languages, and the rule it comes from. The reader
//! takes names and ranges from here; the JSON Schema and the reference page are made of nothing else. The tables that the
//! keys stand in are in [`sections`](super::sections).

use super::Takes;
use crate::dict::{Bilingual, Decimal, Dialect, Operation};
use crate::text::Encoding;

/// A key with a value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// The key, in its section.
    pub name: &'static str,
    /// What it takes.
    pub takes: Takes,
    /// What holds without it.
    pub default: Default,
    /// What it sets.
    pub meaning: Bilingual,
    /// The rule.
    pub rule: &'static str,
}

/// What holds without a key.
#[derive(Clone, Copy, Debug)]
pub(super) enum Default {
    /// Nothing.
    Nothing,
    /// The key must be there.
    Required,
    /// A flag.
    Flag(bool),
    /// A whole number.
    Whole(i64),
    /// A number, in thousandths.
    Number(Decimal),
    /// One of the texts it takes.
    Text(&'static str),
    /// Something that depends.
    Words(Bilingual),
}

/// The keys of a table.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Rows {
    /// What stands before all tables.
    Root,
    /// One axis.
    Axis,
    /// One gear.
    Gear,
    /// `[limits]`.
    Limits,
}

impl Rows {
    /// The rows.
    pub(super) const fn rows(self) -> &'static [Row] {
        match self {
            Self::Root => ROOT,
            Self::Axis => &[AXIS_LETTER, AXIS_KIND],
            Self::Gear => &[GEAR_M, GEAR_MIN, GEAR_MAX],
            Self::Limits => &[RECORDS, NESTING, FEED, ARC_TOLERANCE],
        }
    }

    /// Their names.
    pub(super) fn names(self) -> Vec<&'static str> {
        self.rows().iter().map(|row| row.name).collect()
    }
}

const fn row(
    name: &'static str,
    takes: Takes,
    default: Default,
    meaning: (&'static str, &'static str),
    rule: &'static str,
) -> Row {
    Row { name, takes, default, meaning: Bilingual { en: meaning.0, cs: meaning.1 }, rule }
}

const fn words(en: &'static str, cs: &'static str) -> Default {
    Default::Words(Bilingual { en, cs })
}

/// The words for a linear and a rotary axis.
pub(super) const AXIS_KINDS: [(&str, bool); 2] = [("linear", false), ("rotary", true)];

fn dialects() -> Vec<&'static str> {
    Dialect::ALL.iter().map(|dialect| dialect.name()).collect()
}

fn encodings() -> Vec<&'static str> {
    Encoding::NAMED.iter().map(|(name, _)| *name).collect()
}

fn letters() -> Vec<&'static str> {
    vec!["X", "Y", "Z", "A", "B", "C", "U", "V", "W"]
}

fn axis_kinds() -> Vec<&'static str> {
    AXIS_KINDS.iter().map(|(name, _)| *name).collect()
}

pub(super) fn operations() -> Vec<&'static str> {
    Operation::ALL.iter().map(|operation| operation.name()).collect()
}

pub(super) const DIALECT: Row = row(
    "dialect",
    Takes::OneOf(dialects),
    Default::Text("cnc872"),
    ("the control that the programs are for", "řídicí systém, pro který programy jsou"),
    "§12",
);
pub(super) const ENCODING: Row = row(
    "encoding",
    Takes::OneOf(encodings),
    Default::Text("cp852"),
    ("the code page of programs that are not in UTF-8", "kódová stránka programů, které nejsou v UTF-8"),
    "LEX-13",
);
pub(super) const CHANNEL_CONFIG: Row = row(
    "channel-config",
    Takes::Path,
    Default::Nothing,
    (
        "the ChannelConfig whose `MFunctions` give the M functions; CNC872 only",
        "ChannelConfig, jehož `MFunctions` určují M funkce; jen CNC872",
    ),
    "MFN-2",
);
pub(super) const MACROCYCLES: Row = row(
    "macrocycles",
    Takes::Paths,
    words("the program's folder", "složka programu"),
    (
        "folders to search for macrocycles, in this order; folders in them are not searched",
        "složky, kde se hledají makrocykly, v tomto pořadí; jejich podsložky se neprohledávají",
    ),
    "PRG-6",
);
pub(super) const BLOCK_SKIP: Row = row(
    "block-skip",
    Takes::Flag,
    Default::Flag(false),
    ("whether blocks with `/` are left out", "zda se bloky s `/` vynechávají"),
    "BLK-6",
);
pub(super) const OPTIONAL_STOP: Row = row(
    "optional-stop",
    Takes::Flag,
    Default::Flag(false),
    ("whether M01 stops the program", "zda M01 program zastaví"),
    "MFN-8",
);
pub(super) const ORIENTED_STOP: Row = row(
    "oriented-stop",
    Takes::Flag,
    Default::Flag(true),
    ("whether the machine has the oriented spindle stop M19", "zda stroj má orientovaný stop vřetena M19"),
    "MFN-10",
);

pub(super) const AXIS_LETTER: Row = row(
    "letter",
    Takes::OneOf(letters),
    Default::Required,
    ("letter of the axis, each once", "písmeno osy, každé jednou"),
    "ADR-4",
);
pub(super) const AXIS_KIND: Row = row(
    "kind",
    Takes::OneOf(axis_kinds),
    words("`\"rotary\"` for A, B and C, `\"linear\"` for the others", "`\"rotary\"` pro A, B a C, jinak `\"linear\"`"),
    ("whether the axis travels (millimetres) or turns (degrees)", "zda osa jezdí (milimetry), nebo se otáčí (stupně)"),
    "ADR-4",
);

pub(super) const GEAR_M: Row = row(
    "m",
    Takes::Whole { min: 41, max: Some(44) },
    Default::Required,
    ("the function of the range, M41 to M44, each once", "funkce rozsahu, M41 až M44, každá jednou"),
    "MFN-9",
);
pub(super) const GEAR_MIN: Row = row(
    "min",
    Takes::Whole { min: 0, max: Some(9999) },
    Default::Required,
    ("least speed of the range in rev/min", "nejnižší otáčky rozsahu v ot/min"),
    "MFN-9",
);
pub(super) const GEAR_MAX: Row = row(
    "max",
    Takes::Whole { min: 0, max: Some(9999) },
    Default::Required,
    ("greatest speed of the range in rev/min, not below `min`", "nejvyšší otáčky rozsahu v ot/min, ne pod `min`"),
    "MFN-9",
);

pub(super) const RECORDS: Row = row(
    "records",
    Takes::Whole { min: 1, max: None },
    Default::Whole(10_000_000),
    ("most block records of a stream", "nejvyšší počet záznamů bloků ve výstupu"),
    "FLW-9",
);
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
    words("24000; 99999 on CNC872", "24000; u CNC872 99999"),
    ("greatest feed per minute in mm/min (G94, G96)", "nejvyšší posuv za minutu v mm/min (G94, G96)"),
    "TEC-1",
);
pub(super) const ARC_TOLERANCE: Row = row(
    "arc-tolerance",
    Takes::Number { min: Decimal::ZERO, max: Decimal::DIMENSION_MAX },
    Default::Number(Decimal::from_thousandths(10)),
    (
        "how far the radii at the start and the end of an arc may differ, in mm; a thousandth of the radius where that is more",
        "o kolik se smí lišit poloměr na počátku a na konci oblouku, v mm; tisícina poloměru tam, kde je to víc",
    ),
    "MOT-4",
);

const ROOT: &[Row] = &[DIALECT, ENCODING, CHANNEL_CONFIG, MACROCYCLES, BLOCK_SKIP, OPTIONAL_STOP, ORIENTED_STOP];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::{Limits, Settings};
    use crate::dict::AxisLetter;

    /// The defaults told in the table are those that hold.
    #[test]
    fn defaults_are_those_of_the_settings() {
        let settings = Settings::default();
        let limits = Limits::of(Dialect::default());
        let text = |row: Row| match row.default {
            Default::Text(text) => text,
            Default::Nothing
            | Default::Required
            | Default::Flag(_)
            | Default::Whole(_)
            | Default::Number(_)
            | Default::Words(_) => "",
        };
        assert_eq!(text(DIALECT), settings.machine.dialect.name());
        assert_eq!(Encoding::NAMED.iter().find(|(name, _)| *name == text(ENCODING)).unwrap().1, settings.encoding);
        assert!(matches!(BLOCK_SKIP.default, Default::Flag(flag) if flag == settings.block_skip));
        assert!(matches!(OPTIONAL_STOP.default, Default::Flag(flag) if flag == settings.optional_stop));
        assert!(matches!(ORIENTED_STOP.default, Default::Flag(flag) if flag == settings.machine.oriented_stop));
        assert!(matches!(RECORDS.default, Default::Whole(records) if u64::try_from(records) == Ok(limits.records)));
        assert!(matches!(NESTING.default, Default::Whole(nesting) if u32::try_from(nesting) == Ok(limits.nesting)));
        assert!(matches!(ARC_TOLERANCE.default, Default::Number(mm) if mm == limits.arc_tolerance));
        assert_eq!(Dialect::Cnc8x9.highest_feed(), Decimal::whole(24_000));
        assert_eq!(Dialect::Cnc872.highest_feed(), Decimal::whole(99_999));
    }

    #[test]
    fn names_are_unique() {
        for rows in [Rows::Root, Rows::Axis, Rows::Gear, Rows::Limits] {
            let mut names = rows.names();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), rows.rows().len(), "{rows:?}");
        }
    }

    #[test]
    fn letters_are_those_of_the_axes() {
        let expected: Vec<_> = AxisLetter::ALL.iter().map(ToString::to_string).collect();
        assert_eq!(letters(), expected);
    }
}
