//! `cnc872c.toml`: its text becomes values with their places. What depends on the dialect is left to
//! [`configure`](super::configure()), because the command line may choose another one than the file.

use toml_edit::{Document, Item, TableLike, Value};

use super::keys::{self, Rows};
use super::names::{LEVELS, Names, group};
use super::reader::{Entry, Reader, Setting, Table, entries, entry, to_span, whole};
use super::sections::{Form, SECTIONS, Section};
use super::takes::lasting;
use super::toml_problem::toml_problem;
use super::{Axis, Gear, Level};
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
    /// Folders of macrocycles as written.
    pub macrocycles: Option<Setting<Vec<String>>>,
    /// Block skip.
    pub block_skip: Option<Setting<bool>>,
    /// Optional stop.
    pub optional_stop: Option<Setting<bool>>,
    /// Whether M19 exists.
    pub oriented_stop: Option<Setting<bool>>,
    /// The axes, each letter once, each at its table.
    pub axes: Vec<Setting<Axis>>,
    /// Functions at power-up, of different groups.
    pub power_up: Vec<Setting<GCode>>,
    /// Parameters R0–R95.
    pub parameters: Vec<Setting<(u8, Decimal)>>,
    /// Operations by code 0–99.
    pub operations: Vec<Setting<(u8, Operation)>>,
    /// Macrocycle 1–9999 of cycle 81–89.
    pub cycles: Vec<Setting<(u8, u32)>>,
    /// The gears, each M once.
    pub gears: Vec<Setting<Gear>>,
    /// Machine constants R0–R999, their digits, in the order of the text.
    pub constants: Vec<Setting<(u16, String)>>,
    /// Most records.
    pub records: Option<Setting<u64>>,
    /// Most open calls.
    pub nesting: Option<Setting<u32>>,
    /// Greatest feed in mm/min.
    pub feed: Option<Setting<Decimal>>,
    /// Tolerance of arcs in mm.
    pub arc_tolerance: Option<Setting<Decimal>>,
    /// Levels of diagnostics.
    pub lints: Vec<Setting<(Code, Level)>>,
}

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
        project.document(&mut Reader::new(text, file, findings), root);
        project
    }

    fn document(&mut self, reader: &mut Reader<'_>, root: Table<'_>) {
        let sections = SECTIONS.iter().map(|section| section.name).filter(|name| !name.is_empty());
        let known: Vec<&'static str> = Rows::Root.names().into_iter().chain(sections).collect();
        reader.warn_unknown(root, &known);
        self.root(reader, root);
        for section in SECTIONS {
            if let Some(entry) = entry(root.table, section.name) {
                self.section(reader, section, entry);
            }
        }
    }

    fn root(&mut self, reader: &mut Reader<'_>, root: Table<'_>) {
        self.dialect =
            reader.choice(root, &keys::DIALECT, |name| Dialect::ALL.into_iter().find(|dialect| dialect.name() == name));
        self.dialect_unusable = self.dialect.is_none() && root.table.contains_key(keys::DIALECT.name);
        self.encoding = reader.choice(root, &keys::ENCODING, |name| {
            Encoding::NAMED.into_iter().find(|(known, _)| *known == name).map(|(_, encoding)| encoding)
        });
        self.channel_config = reader.text(root, &keys::CHANNEL_CONFIG);
        self.macrocycles = reader.texts(root, &keys::MACROCYCLES);
        self.block_skip = reader.flag(root, &keys::BLOCK_SKIP);
        self.optional_stop = reader.flag(root, &keys::OPTIONAL_STOP);
        self.oriented_stop = reader.flag(root, &keys::ORIENTED_STOP);
    }

    fn section(&mut self, reader: &mut Reader<'_>, section: &Section, entry: Entry<'_>) {
        let path = format!("{}.", section.name);
        if let Form::List(rows) = section.form {
            for (at, table) in list(reader, section.name, entry) {
                self.keys(reader, rows, Table { path: &path, at, table });
            }
            return;
        }
        let Some(table) = entry.item.as_table_like() else {
            reader.need(section.name, entry.at, ConfigNeed::Table);
            return;
        };
        let table = Table { path: &path, at: entry.key, table };
        match section.form {
            Form::Map(names) => self.map(reader, names, table),
            Form::Keys(rows) | Form::List(rows) => self.keys(reader, rows, table),
        }
    }

    /// A table with these keys.
    fn keys(&mut self, reader: &mut Reader<'_>, rows: Rows, table: Table<'_>) {
        reader.warn_unknown(table, &rows.names());
        let required = rows.rows().iter().filter(|row| matches!(row.default, keys::Default::Required));
        if let Some(missing) = required.into_iter().find(|row| !table.table.contains_key(row.name)) {
            let name = table.path.trim_end_matches('.');
            reader.need(name, table.at, ConfigNeed::Missing { key: missing.name.to_owned() });
        }
        match rows {
            Rows::Root => self.root(reader, table),
            Rows::Axis => self.axis(reader, table),
            Rows::Gear => self.gear(reader, table),
            Rows::Limits => self.limits(reader, table),
        }
    }

    fn limits(&mut self, reader: &mut Reader<'_>, table: Table<'_>) {
        self.records = reader.whole(table, &keys::RECORDS);
        self.nesting = reader.whole(table, &keys::NESTING);
        self.feed = reader.number(table, &keys::FEED);
        self.arc_tolerance = reader.number(table, &keys::ARC_TOLERANCE);
    }

    /// One of `[[axes]]` (ADR-4). Without `kind` the letter decides, as on a machine without configured axes.
    fn axis(&mut self, reader: &mut Reader<'_>, table: Table<'_>) {
        let letter = reader.choice(table, &keys::AXIS_LETTER, |name| {
            let mut characters = name.chars();
            let letter = characters.next().and_then(AxisLetter::from_letter);
            letter.filter(|_| characters.next().is_none())
        });
        let kind = reader.choice(table, &keys::AXIS_KIND, |name| {
            keys::AXIS_KINDS.into_iter().find(|(known, _)| *known == name).map(|(_, rotary)| rotary)
        });
        let Some(letter) = letter else {
            return;
        };
        let rotary = kind.map_or(letter.value.is_rotary_by_default(), |kind| kind.value);
        let axis = Setting { value: Axis { letter: letter.value, rotary }, key: table.at, at: letter.at };
        match self.axes.iter().find(|other| other.value.letter == letter.value) {
            Some(first) => reader.repeated(letter.value.to_string(), first.at, letter.at),
            None => self.axes.push(axis),
        }
    }

    /// One of `[[gears]]` (MFN-9).
    fn gear(&mut self, reader: &mut Reader<'_>, table: Table<'_>) {
        let m = reader.whole::<u8>(table, &keys::GEAR_M);
        let min = reader.whole::<u32>(table, &keys::GEAR_MIN);
        let max = reader.whole::<u32>(table, &keys::GEAR_MAX);
        if let (Some(min), Some(max)) = (min, max)
            && min.value > max.value
        {
            let name = table.path.trim_end_matches('.');
            reader.need(name, min.at.max(max.at), ConfigNeed::Range);
        }
        let Some(m) = m else {
            return;
        };
        if let Some(first) = self.gears.iter().find(|gear| gear.value.m == m.value) {
            reader.repeated(format!("M{}", m.value), first.at, m.at);
            return;
        }
        let (min, max) = (min.map_or(0, |min| min.value), max.map_or(9999, |max| max.value));
        self.gears.push(Setting { value: Gear { m: m.value, min, max }, key: table.at, at: m.at });
    }

    /// A table whose keys are names of the control.
    fn map(&mut self, reader: &mut Reader<'_>, names: Names, table: Table<'_>) {
        let mut seen: Vec<(u16, Span)> = Vec::new();
        for entry in entries(table.table) {
            let Some(number) = names.number(entry.name) else {
                reader.unknown(entry.name, entry.key, names.near(entry.name));
                continue;
            };
            if let Some((_, first)) = seen.iter().find(|(other, _)| *other == number) {
                reader.repeated(entry.name, *first, entry.key);
                continue;
            }
            seen.push((number, entry.key));
            let fixed = (names == Names::Lints).then(|| code(number)).flatten().filter(|code| !code.is_configurable());
            if fixed.is_some() {
                reader.need(format!("{}{}", table.path, entry.name), entry.key, ConfigNeed::ErrorLevel);
                continue;
            }
            let taken = entry.item.as_value().and_then(|value| self.named(reader, names, number, value, entry));
            if taken.is_none() {
                let key = format!("{}{}", table.path, entry.name);
                reader.need(key, entry.at, names.takes(number).need());
            }
        }
    }

    /// Sets what the name of that kind and number is given; `None` when the value is not what it takes.
    fn named(&mut self, reader: &Reader<'_>, names: Names, number: u16, value: &Value, entry: Entry<'_>) -> Option<()> {
        let takes = names.takes(number);
        let small = u8::try_from(number).ok();
        match names {
            Names::Groups => {
                let function = u8::try_from(value.as_integer()?).ok().and_then(GCode::from_number)?;
                let value = lasting(group(number)?).find(|&code| code == function)?;
                self.power_up.push(placed(value, entry));
            }
            Names::Parameters => {
                let value = reader.number_of(value, takes)?;
                self.parameters.push(placed((small?, value), entry));
            }
            Names::Operations => {
                let operation = Operation::from_name(value.as_str()?)?;
                self.operations.push(placed((small?, operation), entry));
            }
            Names::Cycles => self.cycles.push(placed((small?, whole(value, takes)?), entry)),
            Names::Constants => self.constants.push(placed((number, reader.digits(value)?), entry)),
            Names::Lints => {
                let name = value.as_str()?;
                let (_, level) = LEVELS.into_iter().find(|(known, _)| *known == name)?;
                self.lints.push(placed((code(number)?, level), entry));
            }
        }
        Some(())
    }
}

fn placed<T>(value: T, entry: Entry<'_>) -> Setting<T> {
    Setting { value, key: entry.key, at: entry.at }
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
        Item::None | Item::Table(_) | Item::Value(_) => reader.need(name, entry.at, ConfigNeed::List),
    }
    tables
}
