//! The signals that follow from a part program, as data: name, meaning, type, source, and the rule of their value.

use std::sync::LazyLock;

pub use super::cell::{Cell, Flag, Form, OneBlock};
pub use super::value_texts::rule_text;
use super::value_texts::value_of;
use crate::config::Machine;
use crate::dict::{AxisLetter, Bilingual, Dialect, Lang};

/// M groups are numbered from 1.
pub const GROUPS: u8 = 14;
/// Places of axes in the command block.
pub const AXES: u8 = 16;

/// The names of a row.
#[derive(Clone, Copy, Debug)]
pub enum Names {
    /// One signal.
    One(&'static str),
    /// One for each M group, its number between the two parts.
    Groups(&'static str, &'static str),
    /// One for each place 0–15 of an axis.
    Places(&'static str, &'static str),
    /// One for each axis X, Y, Z, 4–16.
    Axes(&'static str, &'static str),
}

/// A row of the dictionary: one signal, or a family.
#[derive(Debug)]
pub struct Row {
    /// Its names.
    pub names: Names,
    /// Its type.
    pub form: Form,
    /// Its meaning; `{x}` is the number of the group or the place of the axis.
    pub meaning: Bilingual,
    /// Where S0 describes it: the section.
    pub section: &'static str,
    /// Number of the rule PLC-… that gives its value.
    pub rule: u8,
    cell: fn(u8) -> Cell,
}

/// One signal.
#[derive(Debug)]
pub struct Signal {
    /// As S0 and PLC programs write it.
    pub name: String,
    /// What its value is taken from.
    pub cell: Cell,
    /// The row that it comes from.
    pub row: &'static Row,
    /// Which of the row: the group, or the place of the axis.
    member: u8,
}

const fn row(
    names: Names,
    cell: fn(u8) -> Cell,
    form: Form,
    section: &'static str,
    rule: u8,
    en: &'static str,
    cs: &'static str,
) -> Row {
    Row { names, form, meaning: Bilingual { en, cs }, section, rule, cell }
}

const fn flag(
    name: &'static str,
    cell: fn(u8) -> Cell,
    section: &'static str,
    rule: u8,
    en: &'static str,
    cs: &'static str,
) -> Row {
    row(One(name), cell, Form::Bit, section, rule, en, cs)
}

const fn byte(name: &'static str, cell: fn(u8) -> Cell, en: &'static str, cs: &'static str) -> Row {
    row(One(name), cell, Form::Byte, "8.2.5", 7, en, cs)
}

const fn real(
    name: &'static str,
    cell: fn(u8) -> Cell,
    section: &'static str,
    en: &'static str,
    cs: &'static str,
) -> Row {
    row(One(name), cell, Form::Real, section, 6, en, cs)
}

use Names::{Axes, Groups, One, Places};

/// Every signal, in the order of tables.
pub const ROWS: &[Row] = &[
    row(
        Groups("BLK.M[", "]"),
        Cell::Group,
        Form::DWord,
        "8.3.3",
        1,
        "the function of M group {x}",
        "funkce {x}. skupiny M",
    ),
    row(
        Groups("BLK.M", ""),
        Cell::Mark,
        Form::Bit,
        "8.3.1",
        2,
        "change bit of M group {x}",
        "změnový bit {x}. skupiny M",
    ),
    flag(
        "BLK.FirstBlock",
        |_| Cell::Flag(Flag::First),
        "8.3.1",
        3,
        "first block of the program",
        "první blok programu",
    ),
    flag(
        "BLK.LastBlock",
        |_| Cell::Flag(Flag::Last),
        "8.3.1",
        3,
        "last block of the program",
        "poslední blok programu",
    ),
    flag(
        "BLK.Stop",
        |_| Cell::Flag(Flag::Stop),
        "8.3.1",
        3,
        "M00 is programmed in the block",
        "v bloku je programována M00",
    ),
    flag(
        "BLK.CondStop",
        |_| Cell::Flag(Flag::CondStop),
        "8.3.1",
        3,
        "M01 is programmed in the block",
        "v bloku je programována M01",
    ),
    flag("BLK.HProg", |_| Cell::Flag(Flag::HProg), "8.3.1", 3, "change bit of H", "změnový bit funkce H"),
    flag("BLK.TProg", |_| Cell::Flag(Flag::TProg), "8.3.1", 3, "change bit of T", "změnový bit funkce T"),
    flag(
        "BLK.RevFeed",
        |_| Cell::Flag(Flag::RevFeed),
        "8.3.1",
        3,
        "feed per revolution (G95)",
        "posuv na otáčku (G95)",
    ),
    flag(
        "BLK.ContinuousMode",
        |_| Cell::Flag(Flag::ContinuousMode),
        "8.3.1",
        3,
        "continuous path (G23)",
        "plynulá jízda (G23)",
    ),
    flag(
        "BLK.ConstCutSpeed",
        |_| Cell::Flag(Flag::ConstCutSpeed),
        "8.3.1",
        3,
        "constant cutting speed (G96)",
        "konstantní řezná rychlost (G96)",
    ),
    row(
        Places("BLK.AxNC", "Move"),
        Cell::Moves,
        Form::Bit,
        "8.3.1",
        4,
        "NC axis {x} moves in the block",
        "NC osa {x} se v bloku pohybuje",
    ),
    row(One("BLK.T"), |_| Cell::Tool, Form::DWord, "8.3.3", 6, "tool number T", "číslo nástroje T"),
    real("BLK.H", |_| Cell::H, "8.3.4", "auxiliary function H", "pomocná funkce H"),
    real("BLK.Delay", |_| Cell::Delay, "8.3.4", "dwell of the block [s]", "časová prodleva bloku [s]"),
    row(
        Places("BLK.AxNC[", "]"),
        Cell::Position,
        Form::Real,
        "8.3.4",
        6,
        "programmed position of NC axis {x} after the block [mm, deg]",
        "programovaná poloha NC osy {x} po bloku [mm, °]",
    ),
    real("BLK.BlockLen", |_| Cell::BlockLen, "8.3.4", "length of the block [mm, deg]", "délka dráhy bloku [mm, °]"),
    real(
        "BLK.FeedProgr",
        |_| Cell::FeedProgr,
        "8.3.4",
        "programmed feed [mm/min; with RevFeed mm/rev]",
        "programovaný posuv [mm/min; při RevFeed mm/ot]",
    ),
    real("BLK.SpindleSpeed", |_| Cell::SpindleSpeed, "8.3.4", "spindle speed [rev/min]", "otáčky vřetena [ot/min]"),
    real(
        "BLK.ParabAccel",
        |_| Cell::ParabAccel,
        "8.3.4",
        "parabolic acceleration in G00 and G23 [m/s³·65.536]",
        "parabolické zrychlení při G00 a G23 [m/s³·65.536]",
    ),
    real(
        "BLK.LinearAccel",
        |_| Cell::LinearAccel,
        "8.3.4",
        "linear acceleration in G00 and G23 [mm/s²]",
        "lineární zrychlení při G00 a G23 [mm/s²]",
    ),
    row(
        Groups("ZMM", "PI"),
        Cell::Mark,
        Form::Bit,
        "8.2.6",
        2,
        "change bit of M group {x}",
        "změnový bit {x}. skupiny M",
    ),
    row(
        Axes("PO_OS", "PI"),
        Cell::Request,
        Form::Bit,
        "8.1.7",
        4,
        "request to move axis {x}",
        "požadavek na pohyb osy {x}",
    ),
    row(
        Axes("SM_PO", "PI"),
        Cell::Backwards,
        Form::Bit,
        "8.1.8",
        5,
        "direction of axis {x}: 1 is negative",
        "směr pohybu osy {x}: 1 je záporný",
    ),
    byte("PB03", |_| Cell::GroupByte(10), "the function of M group 10", "funkce 10. skupiny M"),
    byte("PB05", |_| Cell::HByte, "auxiliary function H", "pomocná funkce H"),
    byte("PB06", |_| Cell::GroupByte(2), "the function of M group 2: the spindle", "funkce 2. skupiny M: vřeteno"),
    byte("PB07", |_| Cell::ToolByte(0), "T, the two lowest digits", "T, dvě nejnižší číslice"),
    byte("PB08", |_| Cell::ToolByte(1), "T, digits 3 and 4 from the right", "T, 3. a 4. číslice zprava"),
    byte("PB09", |_| Cell::ToolByte(2), "T, digits 5 and 6 from the right", "T, 5. a 6. číslice zprava"),
    byte("PB10", |_| Cell::ToolByte(3), "T, the two highest digits", "T, dvě nejvyšší číslice"),
    row(
        One("PB11"),
        |_| Cell::SpeedByte { high: false },
        Form::Byte,
        "8.1.2",
        8,
        "output for the programmed spindle speed, low byte",
        "výstup pro programované otáčky vřetena, nižší bajt",
    ),
    row(
        One("PB12"),
        |_| Cell::SpeedByte { high: true },
        Form::Byte,
        "8.1.2",
        8,
        "output for the programmed spindle speed, high byte",
        "výstup pro programované otáčky vřetena, vyšší bajt",
    ),
    byte("PB13", |_| Cell::GroupByte(11), "the function of M group 11", "funkce 11. skupiny M"),
    byte("PB14", |_| Cell::GroupByte(12), "the function of M group 12", "funkce 12. skupiny M"),
    byte("PB15", |_| Cell::GroupByte(13), "the function of M group 13", "funkce 13. skupiny M"),
    byte("PB16", |_| Cell::GroupByte(14), "the function of M group 14", "funkce 14. skupiny M"),
    flag(
        "M00_PID",
        |_| Cell::Written(OneBlock::M00),
        "8.2.7",
        9,
        "M00 is programmed: stop",
        "programována M00: programový stop",
    ),
    flag(
        "M01_PID",
        |_| Cell::Written(OneBlock::M01),
        "8.2.7",
        9,
        "M01 is programmed: optional stop",
        "programována M01: volitelný stop",
    ),
    flag(
        "M02_PID",
        |_| Cell::Written(OneBlock::M02),
        "8.2.7",
        9,
        "M02 is programmed: end of program",
        "programována M02: konec partprogramu",
    ),
    flag(
        "M30_PID",
        |_| Cell::Written(OneBlock::M30),
        "8.2.7",
        9,
        "M30 is programmed: end of program",
        "programována M30: konec partprogramu",
    ),
    flag(
        "M10PID",
        |_| Cell::Written(OneBlock::M10),
        "8.2.12",
        9,
        "M10 is programmed: clamp the workpiece",
        "programována M10: upnutí obrobku",
    ),
    flag(
        "M11PID",
        |_| Cell::Written(OneBlock::M11),
        "8.2.12",
        9,
        "M11 is programmed: release the workpiece",
        "programována M11: uvolnění obrobku",
    ),
    flag(
        "M06PID",
        |_| Cell::Written(OneBlock::M06),
        "8.2.13",
        9,
        "M06 is programmed: tool change",
        "programována M06: výměna nástroje",
    ),
    flag(
        "M60PI",
        |_| Cell::Written(OneBlock::M60),
        "8.2.13",
        9,
        "M60 is programmed: workpiece change",
        "programována M60: výměna obrobku",
    ),
    flag(
        "M03PI",
        |_| Cell::Spindle(3),
        "8.2.8",
        10,
        "M03 in force: spindle clockwise",
        "platí M03: vřeteno ve směru hodinových ručiček",
    ),
    flag(
        "M04PI",
        |_| Cell::Spindle(4),
        "8.2.8",
        10,
        "M04 in force: spindle counter-clockwise",
        "platí M04: vřeteno proti směru hodinových ručiček",
    ),
    flag(
        "M19PI",
        |_| Cell::Spindle(19),
        "8.2.8",
        10,
        "M19 in force: oriented stop",
        "platí M19: stop v orientovaném bodě",
    ),
    flag("M41PI", |_| Cell::Range(1), "8.2.9", 10, "spindle range 1", "1. rozsah otáček vřetena"),
    flag("M42PI", |_| Cell::Range(2), "8.2.9", 10, "spindle range 2", "2. rozsah otáček vřetena"),
    flag("M43PI", |_| Cell::Range(3), "8.2.9", 10, "spindle range 3", "3. rozsah otáček vřetena"),
    flag("M44PI", |_| Cell::Range(4), "8.2.9", 10, "spindle range 4", "4. rozsah otáček vřetena"),
    flag("M07PI", |_| Cell::Coolant12(7), "8.2.10", 10, "M07 or M17 in force", "platí M07 nebo M17"),
    flag("M08PI", |_| Cell::Coolant12(8), "8.2.10", 10, "M08 or M17 in force", "platí M08 nebo M17"),
    flag("M50PI", |_| Cell::Coolant34(50), "8.2.11", 10, "M50 or M52 in force", "platí M50 nebo M52"),
    flag("M51PI", |_| Cell::Coolant34(51), "8.2.11", 10, "M51 or M52 in force", "platí M51 nebo M52"),
    flag("G00PI", |_| Cell::Flag(Flag::Rapid), "8.2.4", 11, "rapid traverse (G00)", "rychloposuv (G00)"),
    flag("G33PI", |_| Cell::Flag(Flag::Thread), "8.2.3", 11, "thread cutting (G33)", "závitování (G33)"),
    flag("AUTPI", |_| Cell::Flag(Flag::Automatic), "8.2.2", 11, "automatic mode", "režim AUT"),
    flag("ZMSHPI", |_| Cell::Flag(Flag::HProg), "8.2.6", 12, "change bit of H", "změnový bit funkce H"),
    flag("ZMSTPI", |_| Cell::Flag(Flag::TProg), "8.2.6", 12, "change bit of T", "změnový bit funkce T"),
    row(
        One("SPINDLE_GEAR_ACT_1"),
        |_| Cell::Gear,
        Form::Word,
        "8.1.3",
        13,
        "spindle gear in force, 1 to 4",
        "zařazený převodový stupeň vřetena, 1 až 4",
    ),
    flag("PRODLEVA", |_| Cell::Flag(Flag::Dwell), "8.1.21", 14, "the block dwells (G04)", "v bloku je prodleva (G04)"),
    flag(
        "SF_DELAYINPROGR",
        |_| Cell::Flag(Flag::Dwell),
        "8.3.6",
        14,
        "the block dwells (G04)",
        "v bloku je prodleva (G04)",
    ),
    flag(
        "SF_STOP",
        |_| Cell::Flag(Flag::Standing),
        "8.3.6",
        17,
        "the program stands at M00 or M01",
        "program stojí na M00 nebo M01",
    ),
    flag(
        "PO_STOP",
        |_| Cell::Flag(Flag::Standing),
        "8.1.16",
        17,
        "the program stands at M00 or M01",
        "program stojí na M00 nebo M01",
    ),
    flag(
        "REFPI",
        |_| Cell::Flag(Flag::Reference),
        "8.2.2",
        17,
        "the program starts a reference (G30)",
        "program spouští nájezd do reference (G30)",
    ),
    flag(
        "G23ACT",
        |_| Cell::Stretch,
        "8.4.4",
        15,
        "the block lies in a continuous stretch",
        "blok leží v plynulém úseku",
    ),
    row(
        One("TIME_DIST"),
        |_| Cell::TimeDist,
        Form::DWord,
        "8.4.4",
        15,
        "time to the end of the continuous stretch [ms]",
        "čas do konce plynulého úseku [ms]",
    ),
];

/// The axes as names of signals have them.
pub const AXIS_NAMES: [&str; AXES as usize] =
    ["X", "Y", "Z", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15", "16"];

/// The place in machine order of the axis that names of signals call X, Y, Z, 4 … 16: the first three are these
/// letters, the others the other letters in machine order (PLC-4).
pub(super) fn place_of(name: u8, machine: &Machine) -> Option<usize> {
    const LETTERS: [AxisLetter; 3] = [AxisLetter::X, AxisLetter::Y, AxisLetter::Z];
    match LETTERS.get(usize::from(name)) {
        Some(letter) => machine.axes.index(*letter),
        None => {
            let others = machine.axes.iter().enumerate().filter(|(_, axis)| !LETTERS.contains(&axis.letter));
            others.map(|(place, _)| place).nth(usize::from(name) - LETTERS.len())
        }
    }
}

impl Names {
    /// Every name, with the group or place that it is for.
    pub fn each(self) -> Vec<(String, u8)> {
        match self {
            One(name) => vec![(name.to_owned(), 0)],
            Groups(before, after) => (1..=GROUPS).map(|group| (format!("{before}{group}{after}"), group)).collect(),
            Places(before, after) => (0..AXES).map(|place| (format!("{before}{place}{after}"), place)).collect(),
            Axes(before, after) => {
                (0..AXES).zip(AXIS_NAMES).map(|(place, axis)| (format!("{before}{axis}{after}"), place)).collect()
            }
        }
    }

    /// The name of a family with `x` for the member, as S0 writes it.
    pub fn family(self) -> Option<String> {
        match self {
            One(_) => None,
            Groups(before, after) | Places(before, after) | Axes(before, after) => Some(format!("{before}x{after}")),
        }
    }

    /// The name of the row: that of its signal, or its first and last.
    pub fn shown(self) -> String {
        let each = self.each();
        match each.as_slice() {
            [(first, _), .., (last, _)] => format!("{first} … {last}"),
            [(only, _)] => only.clone(),
            [] => String::new(),
        }
    }
}

impl Row {
    /// What gives the value of its signals: more than the rule says, where that is about several cells.
    pub fn value_text(&self) -> Bilingual {
        value_of((self.cell)(0)).unwrap_or_else(|| rule_text(self.rule))
    }

    /// Whether that is more than its rule.
    pub fn has_own_text(&self) -> bool {
        value_of((self.cell)(0)).is_some()
    }

    /// Which controls have its signals.
    pub const fn is_of(&self, dialect: Dialect) -> bool {
        !self.is_of_command_block() || dialect.has_command_block()
    }

    /// Whether it belongs to the command block of CNC872, whose names begin with `BLK.`.
    pub const fn is_of_command_block(&self) -> bool {
        let (One(name) | Groups(name, _) | Places(name, _) | Axes(name, _)) = self.names;
        matches!(name.as_bytes(), [b'B', b'L', b'K', b'.', ..])
    }
}

impl Signal {
    /// Its meaning.
    pub fn meaning(&self, lang: Lang) -> String {
        let member = match self.row.names {
            Axes(..) => AXIS_NAMES.get(usize::from(self.member)).map_or_else(String::new, |name| (*name).to_owned()),
            One(_) | Groups(..) | Places(..) => self.member.to_string(),
        };
        self.row.meaning.get(lang).replace("{x}", &member)
    }

    /// Its type.
    pub const fn form(&self) -> Form {
        self.row.form
    }

    /// The place of the axis in the order of the machine, where its name counts so; from 0.
    pub const fn place(&self) -> Option<u8> {
        match self.row.names {
            Places(..) => Some(self.member),
            One(_) | Groups(..) | Axes(..) => None,
        }
    }

    /// The place of the axis that it is about, on this machine, from 0.
    pub fn axis(&self, machine: &Machine) -> Option<usize> {
        match self.row.names {
            Places(..) => Some(usize::from(self.member)),
            Axes(..) => place_of(self.member, machine),
            One(_) | Groups(..) => None,
        }
    }

    /// Whether its value is a number in BCD.
    pub const fn is_bcd(&self) -> bool {
        matches!(self.cell, Cell::Group(_) | Cell::Tool | Cell::GroupByte(_) | Cell::HByte | Cell::ToolByte(_))
    }

    /// Whether its value is shown in hexadecimal.
    pub const fn is_hexadecimal(&self) -> bool {
        self.is_bcd() || matches!(self.cell, Cell::SpeedByte { .. })
    }

    /// Whether only `[motion]` gives it a value (PLC-15).
    pub const fn needs_motion(&self) -> bool {
        matches!(self.cell, Cell::Stretch | Cell::TimeDist | Cell::ParabAccel | Cell::LinearAccel)
    }
}

static SIGNALS: LazyLock<Vec<Signal>> = LazyLock::new(|| {
    let of_row = |row: &'static Row| {
        row.names.each().into_iter().map(move |(name, member)| Signal { name, cell: (row.cell)(member), row, member })
    };
    ROWS.iter().flat_map(of_row).collect()
});

/// Every signal of every control, in the order of tables.
pub fn signals() -> &'static [Signal] {
    &SIGNALS
}

/// The signal of that name; case counts.
pub fn find(name: &str) -> Option<&'static Signal> {
    signals().iter().find(|signal| signal.name == name)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn names_are_unique() {
        let names: BTreeSet<&str> = signals().iter().map(|signal| signal.name.as_str()).collect();
        assert_eq!(names.len(), signals().len());
    }

    /// PLC-1…PLC-17: every rule gives the value of some signal, and every signal has its rule.
    #[test]
    fn every_rule_has_signals() {
        let rules: BTreeSet<u8> = ROWS.iter().map(|row| row.rule).collect();
        assert_eq!(rules, (1..=15).chain([17]).collect());
        for lang in [Lang::En, Lang::Cs] {
            let texts: BTreeSet<&str> = rules.iter().map(|rule| rule_text(*rule).get(lang)).collect();
            assert_eq!(texts.len(), rules.len());
        }
    }

    #[test]
    fn families_have_a_name_for_each_member() {
        let of = |name: &str| {
            let signal = find(name).unwrap();
            (signal.cell, signal.form(), signal.meaning(Lang::En))
        };
        assert_eq!(of("BLK.M[11]"), (Cell::Group(11), Form::DWord, "the function of M group 11".to_owned()));
        assert_eq!(of("ZMM10PI"), (Cell::Mark(10), Form::Bit, "change bit of M group 10".to_owned()));
        assert_eq!(of("BLK.AxNC15Move").0, Cell::Moves(15));
        assert_eq!(of("BLK.AxNC[0]").0, Cell::Position(0));
        assert_eq!(of("PO_OSZPI").0, Cell::Request(2));
        assert_eq!(of("PO_OSZPI").2, "request to move axis Z");
        assert_eq!(of("SM_PO16PI").0, Cell::Backwards(15));
        assert!(find("zmm10pi").is_none() && find("BLK.M15").is_none() && find("BLK.M[0]").is_none());
    }

    /// A rule about many cells has a text for each of them; BCD is spoken of where the cell is in BCD.
    #[test]
    fn every_cell_says_what_gives_its_value() {
        for row in ROWS.iter().filter(|row| matches!(row.rule, 3 | 6)) {
            for lang in [Lang::En, Lang::Cs] {
                let text = row.value_text().get(lang);
                assert_ne!(text, rule_text(row.rule).get(lang), "{}", row.names.shown());
                let bcd =
                    signals().iter().any(|signal| signal.row.names.shown() == row.names.shown() && signal.is_bcd());
                assert_eq!(text.contains("BCD"), bcd, "{text}");
            }
        }
    }

    /// BLK signals exist on CNC872, the compatible ones everywhere.
    #[test]
    fn dialects() {
        for signal in signals() {
            let old = signal.row.is_of(Dialect::Cnc8x6);
            assert_eq!(old, !signal.name.starts_with("BLK."), "{}", signal.name);
            assert_eq!(old, signal.row.is_of(Dialect::Cnc8x9));
            assert!(signal.row.is_of(Dialect::Cnc872));
        }
    }
}
