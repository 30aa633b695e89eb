//! The validated configuration of one machine.

use std::collections::BTreeMap;
use std::path::PathBuf;

use super::{ArcCenters, G97, MFunctions, Motion, SpindleAxis, Style};
use crate::diag::{Code, LIMIT_PER_CODE, Levels, Severity};
use crate::dict::{
    Address, AxisLetter, Decimal, Dialect, FeedMode, FeedRow, GCode, GGroup, HIGHEST_S, M_GROUPS, Operation,
};
use crate::text::Encoding;

/// One axis of the machine.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Axis {
    /// Its letter.
    pub letter: AxisLetter,
    /// Whether it turns (degrees) or travels (millimetres).
    pub rotary: bool,
    /// Least programmed coordinate, in mm or degrees, when configured. Of X under diameter programming a diameter.
    pub min: Option<Decimal>,
    /// Greatest programmed coordinate, likewise.
    pub max: Option<Decimal>,
}

impl Axis {
    /// The axis of that letter with nothing configured (ADR-4).
    pub const fn of(letter: AxisLetter) -> Self {
        Self { letter, rotary: letter.is_rotary_by_default(), min: None, max: None }
    }
}

/// The axes, in the order of the machine (ADR-4).
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Axes {
    axes: Vec<Axis>,
    /// The configuration lists them.
    configured: bool,
    index: [Option<u8>; 9],
    /// The same by address.
    index_of: [Option<u8>; Address::ALL.len()],
}

impl Axes {
    /// Axes in machine order; a letter listed again is ignored (the configuration reports it).
    pub fn new(listed: impl IntoIterator<Item = Axis>) -> Self {
        let mut axes: Vec<Axis> = Vec::new();
        let mut index = [None; 9];
        for axis in listed {
            if let Some(slot @ None) = index.get_mut(axis.letter as usize) {
                *slot = u8::try_from(axes.len()).ok();
                axes.push(axis);
            }
        }
        let of_address =
            |at: usize| Address::ALL.get(at)?.axis().and_then(|letter| index.get(letter as usize).copied()?);
        Self { axes, configured: true, index, index_of: std::array::from_fn(of_address) }
    }

    /// Whether the configuration lists the axes; else all nine letters are there.
    pub const fn are_configured(&self) -> bool {
        self.configured
    }

    /// In machine order.
    pub fn iter(&self) -> impl Iterator<Item = Axis> + '_ {
        self.axes.iter().copied()
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.axes.len()
    }

    /// The place in machine order of that letter; `None` when the machine has no such axis (E0311).
    pub fn index(&self, letter: AxisLetter) -> Option<usize> {
        self.index.get(letter as usize).copied().flatten().map(usize::from)
    }

    /// The place in machine order of the axis that the address is.
    #[inline]
    pub fn index_of(&self, address: Address) -> Option<usize> {
        self.index_of.get(address as usize).copied().flatten().map(usize::from)
    }

    /// The axis at that place.
    pub fn get(&self, index: usize) -> Option<Axis> {
        self.axes.get(index).copied()
    }

    /// The 4th axis: the first that is not X, Y or Z (§13 Configuration).
    pub fn fourth(&self) -> Option<usize> {
        self.axes.iter().position(|axis| !matches!(axis.letter, AxisLetter::X | AxisLetter::Y | AxisLetter::Z))
    }

    /// Their letters, as in `X, Y, Z`.
    pub fn letters(&self) -> String {
        self.axes.iter().map(|axis| axis.letter.to_string()).collect::<Vec<_>>().join(", ")
    }
}

impl Default for Axes {
    /// All nine letters, A, B and C rotary (ADR-4).
    fn default() -> Self {
        Self { configured: false, ..Self::new(AxisLetter::ALL.map(Axis::of)) }
    }
}

/// The axes that a macrocycle of the machine may move (FLW-12).
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum MayMove {
    /// Any axis.
    All,
    /// These axes.
    Only(Vec<AxisLetter>),
}

impl MayMove {
    /// Whether its axes are named.
    pub const fn names_axes(&self) -> bool {
        matches!(self, Self::Only(_))
    }

    /// Whether it may move that axis.
    pub fn moves(&self, axis: AxisLetter) -> bool {
        match self {
            Self::All => true,
            Self::Only(axes) => axes.contains(&axis),
        }
    }
}

/// One range of the gearbox (MFN-9), both ends included.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Gear {
    /// M41–M44, by number.
    pub m: u8,
    /// Least speed in rev/min.
    pub min: u32,
    /// Greatest speed in rev/min.
    pub max: u32,
    /// The part of the full voltage at `max` (PLC-8).
    pub output: Decimal,
}

/// Where the compiler stops or draws a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Most records of a stream (FLW-9).
    pub records: u64,
    /// Most calls open at once (FLW-2).
    pub nesting: u32,
    /// Highest feed per minute in mm/min (TEC-1).
    pub feed: Decimal,
    /// Greatest S in rev/min, at most 99999 (§2).
    pub speed: u32,
    /// How far the radii of an arc may differ, in mm, where that is more than a thousandth of the radius (MOT-4).
    pub arc_tolerance: Decimal,
}

impl Limits {
    /// What holds unless configured.
    pub const fn of(dialect: Dialect) -> Self {
        Self {
            records: 10_000_000,
            nesting: 32,
            feed: dialect.highest_feed(),
            speed: HIGHEST_S,
            arc_tolerance: Decimal::from_thousandths(10),
        }
    }
}

/// A configured level of a diagnostic.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Level {
    /// Not shown.
    Allow,
    /// A warning.
    Warn,
    /// An error.
    Deny,
}

/// The machine, as far as programs see it.
#[derive(Clone, Debug)]
pub struct Machine {
    /// Which control.
    pub dialect: Dialect,
    /// Its axes.
    pub axes: Axes,
    /// Its M functions and their groups.
    pub m_functions: MFunctions,
    /// What holds in each G group at program start and after M02 and M30; none in G4.
    pub power_up: [Option<GCode>; 12],
    /// What holds in each M group at program start and after M02 and M30 (MFN-7): the `+` values of the table, and what
    /// is configured. At a stop the table's `+` values hold, those of [`MFunctions::defaults`] (MFN-8).
    pub m_power_up: [Option<u8>; M_GROUPS],
    /// Programmed positions before the first block, in mm or degrees; X as in records, so a radius where G74 holds at
    /// power-up (§13). Only letters of [`Self::axes`].
    pub start: BTreeMap<AxisLetter, Decimal>,
    /// The parameter table at program start.
    pub parameters: BTreeMap<u8, Decimal>,
    /// Operations of G26–G29 by code (PAR-9).
    pub operations: BTreeMap<u8, Operation>,
    /// Fixed cycles mapped to macrocycles: number of the G function to number of the macrocycle (GRP-6).
    pub cycles: BTreeMap<u8, u32>,
    /// Macrocycles that only the machine has, by number (FLW-12).
    pub macrocycles: BTreeMap<u32, MayMove>,
    /// The gear table, by rising M number.
    pub gears: Vec<Gear>,
    /// Whether M19 exists (MFN-10).
    pub oriented_stop: bool,
    /// The spindle's axis as configured; [`Self::spindle`] says which it is.
    pub spindle_axis: SpindleAxis,
    /// Where M19 puts the spindle, in degrees, ±69999.999 (MFN-10).
    pub oriented_position: Decimal,
    /// The axis along which the tool leaves the workpiece (RST-2), when it is configured.
    pub tool_axis: Option<AxisLetter>,
    /// What G97 means (TEC-5).
    pub g97: G97,
    /// Which axes I and J of an arc belong to (MOT-3).
    pub arc_centers: ArcCenters,
    /// Machine constants R0–R999: their digits as configured. What R56–R59 say is in `m_functions` already (MFN-5).
    pub constants: BTreeMap<u16, String>,
    /// Radius corrections in mm by the number of D, 1–99 (EQU-1).
    pub corrections: BTreeMap<u8, Decimal>,
    /// What motion is computed with.
    pub motion: Motion,
    /// Limits.
    pub limits: Limits,
}

impl Machine {
    /// A machine of that dialect with nothing configured.
    pub fn new(dialect: Dialect) -> Self {
        Self {
            dialect,
            axes: Axes::default(),
            m_power_up: *MFunctions::standard(dialect).defaults(),
            m_functions: MFunctions::standard(dialect),
            power_up: GGroup::ALL.map(GCode::power_up),
            start: BTreeMap::new(),
            parameters: BTreeMap::new(),
            operations: BTreeMap::new(),
            cycles: BTreeMap::new(),
            macrocycles: BTreeMap::new(),
            gears: Vec::new(),
            oriented_stop: true,
            spindle_axis: SpindleAxis::default(),
            oriented_position: Decimal::ZERO,
            tool_axis: None,
            g97: G97::of(dialect),
            arc_centers: ArcCenters::default(),
            constants: BTreeMap::new(),
            corrections: BTreeMap::new(),
            motion: Motion::new(dialect),
            limits: Limits::of(dialect),
        }
    }
}

impl Machine {
    /// The place in machine order of the axis that is the spindle while M19 holds: the configured one, else the first
    /// of C, A, B that the machine has (MFN-10). `None` where the spindle is no axis.
    pub fn spindle(&self) -> Option<usize> {
        match self.spindle_axis {
            SpindleAxis::Assumed => {
                [AxisLetter::C, AxisLetter::A, AxisLetter::B].into_iter().find_map(|letter| self.axes.index(letter))
            }
            SpindleAxis::Letter(letter) => self.axes.index(letter),
            SpindleAxis::None => None,
        }
    }

    /// What F counts, and whether the cutting speed is constant, under a function of group G6; `None` under others.
    pub const fn feed_mode(&self, function: GCode) -> Option<FeedMode> {
        match FeedRow::of(function) {
            Some(FeedRow::Mode(mode)) => Some(mode),
            Some(FeedRow::Key) => Some(self.g97.mode()),
            None => None,
        }
    }

    /// Whether configuration names the spindle's axis: then its words under M03 and M04 are errors, and M03, M04 and
    /// M05 make its position unknown (MFN-10).
    pub const fn spindle_is_configured(&self) -> bool {
        matches!(self.spindle_axis, SpindleAxis::Letter(_))
    }
}

impl Default for Machine {
    fn default() -> Self {
        Self::new(Dialect::default())
    }
}

/// Extensions of programs unless configured.
pub const EXTENSIONS: &[&str] = &["nc", "ncp", "mpf", "txt"];

/// All settings of a run: the machine, and how to read, execute and judge programs.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The machine.
    pub machine: Machine,
    /// What files are in that are not UTF-8.
    pub encoding: Encoding,
    /// Folders to search for macrocycles, in order; empty: the program's folder.
    pub macrocycles: Vec<PathBuf>,
    /// Whether skippable blocks are left out (BLK-6).
    pub block_skip: bool,
    /// Whether M01 stops (MFN-8).
    pub optional_stop: bool,
    /// Extensions of programs where a folder is searched, without points, in lower case.
    pub extensions: Vec<String>,
    /// Levels of diagnostics that differ from the registry's.
    pub lints: BTreeMap<Code, Level>,
    /// How programs are laid out.
    pub format: Style,
    /// How many findings of each code are kept for each file.
    pub findings: usize,
    /// The options that change the execution, as [`Overrides::arguments`](super::Overrides) gives them: with them a
    /// page says how to start at a block.
    pub arguments: Vec<String>,
}

impl Settings {
    /// With everything as it is unless configured.
    pub fn new(dialect: Dialect) -> Self {
        Self {
            machine: Machine::new(dialect),
            encoding: Encoding::default(),
            macrocycles: Vec::new(),
            block_skip: false,
            optional_stop: false,
            extensions: EXTENSIONS.iter().map(|&extension| extension.to_owned()).collect(),
            lints: BTreeMap::new(),
            format: Style::default(),
            findings: LIMIT_PER_CODE,
            arguments: Vec::new(),
        }
    }

    /// The severity of a code in this run; `None` when it is allowed.
    pub fn severity(&self, code: Code) -> Option<Severity> {
        match self.lints.get(&code) {
            Some(Level::Allow) => None,
            Some(Level::Warn) => Some(Severity::Warning),
            Some(Level::Deny) => Some(Severity::Error),
            None if code == Code::E0109 && self.machine.dialect.reads_long_lines() => Some(Severity::Warning),
            // Not a mistake, but a question that somebody may ask.
            None if code.is_off() => None,
            None => Some(code.severity()),
        }
    }
}

/// The purpose of a run.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum Purpose {
    /// `check`: findings.
    #[default]
    Check,
    /// `compile`: the stream; a parameter without a value is an error there (PAR-5).
    Compile,
    /// `report`: all that a program does. What only the machine knows is listed there, and is no error.
    Report,
}

impl Settings {
    /// The severity of a code in a run for that purpose; `None` when it is allowed.
    pub fn severity_for(&self, code: Code, purpose: Purpose) -> Option<Severity> {
        match purpose {
            Purpose::Compile if code == Code::W0503 => Some(Severity::Error),
            Purpose::Compile | Purpose::Check | Purpose::Report => self.severity(code),
        }
    }

    /// The severities of all codes in a run for that purpose.
    pub fn levels(&self, purpose: Purpose) -> Levels {
        Levels::new(|code| self.severity_for(code, purpose)).keeping(self.findings)
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self::new(Dialect::default())
    }
}
