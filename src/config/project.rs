//! `cnc872c.toml`: its text becomes values with their places. What depends on the dialect is left to
//! [`configure`](super::configure()), because the command line may choose another one than the file.

use toml_edit::{Document, Item, TableLike, Value};

use super::keys;
use super::motion::TimedFunction;
use super::motion_values::MotionValues;
use super::names::{LEVELS, Names, TIMED_ADDRESS, m_group};
use super::reader::{Entry, Reader, Table, entries, entry, to_span};
use super::row::Row;
use super::sections::{Form, ROOT, Section, TakeValues};
use super::taken::{Named, Setting, Values};
use super::toml_problem::toml_problem;
use super::{ArcCenters, Axis, G97, Gear, Level, SpindleAxis, Style};
use crate::diag::{Code, ConfigNeed, Diagnostic, Finding, Findings};
use crate::dict::{AxisLetter, Decimal, Dialect, GCode, Operation};
use crate::text::{Encoding, FileId, Location, SourceText, Span};

/// What the project file says: only what is of the right type and range; everything else is a finding.
#[derive(Debug, Default)]
pub(super) struct Project {
    /// The control.
    pub dialect: Option<Setting<Dialect>>,
    /// Whether there is a dialect, but one that is not known: then nothing that depends on it can be judged.
    pub dialect_unusable: bool,
    /// Code page of files that are not UTF-8.
    pub encoding: Option<Setting<Encoding>>,
    /// Path of the ChannelConfig as written.
    pub channel_config: Option<Setting<String>>,
    /// Folders of macrocycles as written, each at its place.
    pub macrocycles: Option<Setting<Vec<(String, Span)>>>,
    /// Block skip.
    pub block_skip: Option<Setting<bool>>,
    /// Optional stop.
    pub optional_stop: Option<Setting<bool>>,
    /// Whether M19 exists.
    pub oriented_stop: Option<Setting<bool>>,
    /// The spindle's axis.
    pub spindle_axis: Option<Setting<SpindleAxis>>,
    /// Position of the spindle after M19 in degrees.
    pub oriented_position: Option<Setting<Decimal>>,
    /// What G97 means.
    pub g97: Option<Setting<G97>>,
    /// Which axes I and J belong to.
    pub arc_centers: Option<Setting<ArcCenters>>,
    /// Extensions of programs.
    pub extensions: Option<Setting<Vec<(String, Span)>>>,
    /// Positions before the first block.
    pub start: Vec<Setting<(AxisLetter, Decimal)>>,
    /// The axes, each letter once, each at its table.
    pub axes: Vec<Setting<Axis>>,
    /// G functions at power-up, of different groups.
    pub power_up: Vec<Setting<GCode>>,
    /// M groups with their functions at power-up; whether they go together is looked at when all groups are known.
    pub m_power_up: Vec<Setting<(u8, u8)>>,
    /// Parameters R0–R95.
    pub parameters: Vec<Setting<(u8, Decimal)>>,
    /// Operations by code 0–99.
    pub operations: Vec<Setting<(u8, Operation)>>,
    /// Macrocycle 1–9999 of cycle 81–89.
    pub cycles: Vec<Setting<(u8, u32)>>,
    /// Macrocycles 1–9999 that only the machine has; their axes, each at its place.
    pub machine_macrocycles: Vec<(u32, Option<Texts>)>,
    /// The gears, each M once.
    pub gears: Vec<Setting<Gear>>,
    /// The ends of all gears, by key: they may reach `limits.speed`.
    pub gear_ends: Vec<(&'static str, Option<Setting<u32>>)>,
    /// Machine constants R0–R999, their digits, in the order of the text.
    pub constants: Vec<Setting<(u16, String)>>,
    /// What motion is computed with.
    pub motion: MotionValues,
    /// Radius corrections by D.
    pub corrections: Vec<Setting<(u8, Decimal)>>,
    /// Most records.
    pub records: Option<Setting<u64>>,
    /// Most open calls.
    pub nesting: Option<Setting<u32>>,
    /// Greatest feed in mm/min.
    pub feed: Option<Setting<Decimal>>,
    /// Greatest S.
    pub speed: Option<Setting<u32>>,
    /// Tolerance of arcs in mm.
    pub arc_tolerance: Option<Setting<Decimal>>,
    /// Levels of diagnostics.
    pub lints: Vec<Setting<(Code, Level)>>,
    /// How programs are laid out.
    pub format: Style,
    /// The axis along which the tool leaves the workpiece.
    pub tool_axis: Option<Setting<AxisLetter>>,
}

/// Texts, each at its place.
pub(super) type Texts = Setting<Vec<(String, Span)>>;

impl Project {
    /// Reads the text, which is `file` of the run: E0701 when it is no TOML, then nothing is set; E0702 for each value of
    /// the wrong type or range and W0705 for each unknown key, and the rest is set.
    pub(super) fn read(source: &SourceText, file: FileId, findings: &mut Findings) -> Self {
        let text = source.text();
        let document = match Document::parse(text) {
            Ok(document) => document,
            Err(error) => {
                let (reason, span) = toml_problem(text, &error);
                let at = Location { file, span };
                findings.add(Diagnostic::new(Finding::UnreadableConfiguration { reason }, at));
                return Self::default();
            }
        };
        let mut project = Self::default();
        let root = Table { path: "", at: Span::empty(source.first_offset()), table: document.as_table() };
        if let Form::Keys(rows, take) = ROOT.form {
            project.keys(&mut Reader::new(text, file, findings), ROOT, (rows, take), root);
        }
        project.dialect_unusable = project.dialect.is_none() && root.table.contains_key(keys::DIALECT.name);
        project
    }

    /// A table with these keys, and the tables in it.
    fn keys(
        &mut self,
        reader: &mut Reader<'_>,
        section: &Section,
        (rows, take): (&'static [Row], TakeValues),
        table: Table<'_>,
    ) {
        let known: Vec<&'static str> =
            rows.iter().map(|row| row.name).chain(section.children().map(Section::own_name)).collect();
        reader.warn_unknown(table, &known);
        let values = reader.values(table, rows);
        take(self, reader, &values);
        for child in section.children() {
            if let Some(entry) = entry(table.table, child.own_name()) {
                self.section(reader, child, entry);
            }
        }
    }

    fn section(&mut self, reader: &mut Reader<'_>, section: &'static Section, entry: Entry<'_>) {
        let path = format!("{}.", section.name);
        if let Form::List(rows, take) = section.form {
            for (at, table) in list(reader, section.name, entry) {
                self.keys(reader, section, (rows, take), Table { path: &path, at, table });
            }
            return;
        }
        let Some(table) = entry.item.as_table_like() else {
            reader.need(section.name, entry.at, ConfigNeed::Table);
            return;
        };
        let table = Table { path: &path, at: entry.key, table };
        match section.form {
            Form::Keys(rows, take) | Form::List(rows, take) => self.keys(reader, section, (rows, take), table),
            Form::Map(names, take) => {
                for (number, entry) in named(reader, names, table) {
                    if let Some(value) = reader.taken(table, entry, names.takes(number)) {
                        take(self, &Named { number, value, key: entry.key, at: entry.at });
                    }
                }
            }
            Form::Tables(names, rows, take) => {
                for (number, entry) in named(reader, names, table) {
                    let path = format!("{path}{}.", entry.name);
                    let Some(inner) = entry.item.as_table_like() else {
                        reader.need(path.trim_end_matches('.'), entry.at, ConfigNeed::Table);
                        continue;
                    };
                    let inner = Table { path: &path, at: entry.key, table: inner };
                    reader.warn_unknown(inner, &rows.iter().map(|row| row.name).collect::<Vec<_>>());
                    let values = reader.values(inner, rows);
                    take(self, reader, number, &values);
                }
            }
        }
    }

    /// What comes before all tables.
    pub(super) fn root(&mut self, _: &mut Reader<'_>, values: &Values) {
        self.dialect =
            values.choice(&keys::DIALECT, |name| Dialect::ALL.into_iter().find(|dialect| dialect.name() == name));
        self.encoding = values.choice(&keys::ENCODING, |name| {
            Encoding::NAMED.into_iter().find(|(known, _)| *known == name).map(|(_, encoding)| encoding)
        });
        self.channel_config = values.text(&keys::CHANNEL_CONFIG);
        self.macrocycles = values.texts(&keys::MACROCYCLES);
        self.block_skip = values.flag(&keys::BLOCK_SKIP);
        self.optional_stop = values.flag(&keys::OPTIONAL_STOP);
        self.oriented_stop = values.flag(&keys::ORIENTED_STOP);
        self.spindle_axis = values.choice(&keys::SPINDLE_AXIS, |name| {
            if name == SpindleAxis::NONE { Some(SpindleAxis::None) } else { letter(name).map(SpindleAxis::Letter) }
        });
        self.oriented_position = values.number(&keys::ORIENTED_POSITION);
        self.g97 = values.choice(&keys::G97_ROW, |name| G97::ALL.into_iter().find(|known| known.name() == name));
        self.arc_centers =
            values.choice(&keys::ARC_CENTERS, |name| ArcCenters::ALL.into_iter().find(|known| known.name() == name));
        self.extensions = values.texts(&keys::EXTENSIONS);
    }

    /// `[limits]`.
    pub(super) fn limits(&mut self, _: &mut Reader<'_>, values: &Values) {
        self.records = values.whole(&keys::RECORDS);
        self.nesting = values.whole(&keys::NESTING);
        self.feed = values.number(&keys::FEED);
        self.speed = values.whole(&keys::SPEED);
        self.arc_tolerance = values.number(&keys::ARC_TOLERANCE);
    }

    /// One of `[[axes]]` (ADR-4). Without `kind` the letter decides, as on a machine without configured axes.
    pub(super) fn axis(&mut self, reader: &mut Reader<'_>, values: &Values) {
        let kind = values.choice(&keys::AXIS_KIND, |name| {
            keys::AXIS_KINDS.into_iter().find(|(known, _)| *known == name).map(|(_, rotary)| rotary)
        });
        let (min, max) = (values.number(&keys::AXIS_MIN), values.number(&keys::AXIS_MAX));
        reader.ordered(values, min, max);
        let Some(letter) = values.choice(&keys::AXIS_LETTER, letter) else {
            return;
        };
        let axis = Axis {
            letter: letter.value,
            rotary: kind.map_or(letter.value.is_rotary_by_default(), |kind| kind.value),
            min: min.map(|min| min.value),
            max: max.map(|max| max.value),
        };
        match self.axes.iter().find(|other| other.value.letter == letter.value) {
            Some(first) => reader.repeated(letter.value.to_string(), first.at, letter.at),
            None => self.axes.push(Setting { value: axis, key: values.at, at: letter.at }),
        }
    }

    /// One of `[[gears]]` (MFN-9).
    pub(super) fn gear(&mut self, reader: &mut Reader<'_>, values: &Values) {
        let m = values.whole::<u8>(&keys::GEAR_M);
        let (min, max) = (values.whole::<u32>(&keys::GEAR_MIN), values.whole::<u32>(&keys::GEAR_MAX));
        reader.ordered(values, min, max);
        self.gear_ends.extend([(keys::GEAR_MIN.name, min), (keys::GEAR_MAX.name, max)]);
        let Some(m) = m else {
            return;
        };
        if let Some(first) = self.gears.iter().find(|gear| gear.value.m == m.value) {
            reader.repeated(format!("M{}", m.value), first.at, m.at);
            return;
        }
        if let (Some(min), Some(max)) = (min, max) {
            let output = values.number(&keys::GEAR_OUTPUT).map_or(Decimal::whole(1), |output| output.value);
            let gear = Gear { m: m.value, min: min.value, max: max.value, output };
            self.gears.push(Setting { value: gear, key: values.at, at: m.at });
        }
    }

    /// One of `[start]`.
    pub(super) fn start(&mut self, named: &Named) {
        let letter = AxisLetter::ALL.get(usize::from(named.number)).copied();
        self.start.extend(named.setting(|taken| Some((letter?, taken.number()?))));
    }

    /// One of `[power-up]` (GRP-3, MFN-7).
    pub(super) fn power_up(&mut self, named: &Named) {
        match m_group(named.number) {
            Some(group) => self.m_power_up.extend(named.setting(|taken| Some((group, taken.whole()?)))),
            None => self.power_up.extend(named.setting(|taken| GCode::from_number(taken.whole()?))),
        }
    }

    /// One of `[parameters]`.
    pub(super) fn parameter(&mut self, named: &Named) {
        let number = u8::try_from(named.number).ok();
        self.parameters.extend(named.setting(|taken| Some((number?, taken.number()?))));
    }

    /// One of `[operations]` (PAR-9).
    pub(super) fn operation(&mut self, named: &Named) {
        let number = u8::try_from(named.number).ok();
        self.operations.extend(named.setting(|taken| Some((number?, Operation::from_name(taken.text()?)?))));
    }

    /// One of `[cycles]` (GRP-6).
    pub(super) fn cycle(&mut self, named: &Named) {
        let number = u8::try_from(named.number).ok();
        self.cycles.extend(named.setting(|taken| Some((number?, taken.whole()?))));
    }

    /// One of `[machine-macrocycles]` (FLW-12).
    pub(super) fn machine_macrocycle(&mut self, _: &mut Reader<'_>, number: u16, values: &Values) {
        self.machine_macrocycles.push((u32::from(number), values.texts(&keys::MACROCYCLE_AXES)));
    }

    /// One of `[machine-constants]`.
    pub(super) fn constant(&mut self, named: &Named) {
        self.constants.extend(named.setting(|taken| Some((named.number, taken.text()?.to_owned()))));
    }

    /// One of `[corrections]` (EQU-1).
    pub(super) fn correction(&mut self, _: &mut Reader<'_>, number: u16, values: &Values) {
        let radius = values.number(&keys::CORRECTION_RADIUS);
        let number = u8::try_from(number).ok();
        self.corrections.extend(radius.and_then(|radius| radius.and_then(|value| Some((number?, value)))));
    }

    /// `[motion]`.
    pub(super) fn motion(&mut self, _: &mut Reader<'_>, values: &Values) {
        self.motion.take(values);
    }

    /// `[motion.sets.1]` and its like.
    pub(super) fn motion_set(&mut self, _: &mut Reader<'_>, values: &Values) {
        self.motion.take_set(values);
    }

    /// One of `[motion.times]`.
    pub(super) fn motion_time(&mut self, named: &Named) {
        self.motion.present = true;
        let function = match named.number.checked_sub(TIMED_ADDRESS) {
            Some(place) => {
                TimedFunction::ADDRESSES.get(usize::from(place)).map(|letter| TimedFunction::Address(letter))
            }
            None => Some(TimedFunction::M(named.number)),
        };
        self.motion.times.extend(named.setting(|taken| Some((function?, taken.number()?))));
    }

    /// One of `[lints]`.
    pub(super) fn lint(&mut self, named: &Named) {
        let level = |name: &str| LEVELS.into_iter().find(|(known, _)| *known == name).map(|(_, level)| level);
        self.lints.extend(named.setting(|taken| Some((code(named.number)?, level(taken.text()?)?))));
    }
}

/// The axis of that letter.
pub(super) fn letter(name: &str) -> Option<AxisLetter> {
    AxisLetter::ALL.into_iter().find(|letter| letter.name() == name)
}

/// The entries of a table whose keys are names of the control, with their numbers. A name that is not known, given twice,
/// or that of an error under `[lints]` is reported and left out.
fn named<'t>(reader: &mut Reader<'_>, names: Names, table: Table<'t>) -> Vec<(u16, Entry<'t>)> {
    let mut found: Vec<(u16, Entry<'t>)> = Vec::new();
    for entry in entries(table.table) {
        let Some(number) = names.number(entry.name) else {
            reader.unknown(entry.name, entry.key, names.near(entry.name), Some(names.known()));
            continue;
        };
        if let Some((_, first)) = found.iter().find(|(other, _)| *other == number) {
            reader.repeated(entry.name, first.key, entry.key);
            continue;
        }
        found.push((number, entry));
    }
    found.retain(|(number, entry)| {
        let fixed = (names == Names::Lints).then(|| code(*number)).flatten().filter(|code| !code.is_configurable());
        if fixed.is_some() {
            reader.need(format!("{}{}", table.path, entry.name), entry.key, ConfigNeed::ErrorLevel);
        }
        fixed.is_none()
    });
    found
}

/// The code at that place of [`Code::ALL`].
fn code(number: u16) -> Option<Code> {
    Code::ALL.get(usize::from(number)).copied()
}

/// The tables of a list, `[[name]]` or `name = [{ … }]`, each with its header; what is none of these is reported.
fn list<'t>(reader: &mut Reader<'_>, name: &str, entry: Entry<'t>) -> Vec<(Span, &'t dyn TableLike)> {
    let mut tables: Vec<(Span, &'t dyn TableLike)> = Vec::new();
    match entry.item {
        Item::ArrayOfTables(list) => {
            for table in list {
                tables.push((table.span().map_or(entry.key, to_span), table));
            }
        }
        Item::Value(Value::Array(list)) => {
            for value in list {
                let at = value.span().map_or(entry.at, to_span);
                match value.as_inline_table() {
                    Some(table) => tables.push((at, table)),
                    None => reader.need(name, at, ConfigNeed::Table),
                }
            }
        }
        Item::None | Item::Table(_) | Item::Value(_) => {
            reader.need(name, entry.at, ConfigNeed::List { name: name.to_owned() });
        }
    }
    tables
}
