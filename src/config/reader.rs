//! The project file: its tables and keys, taken by the rows of the table of keys, each fault a finding at its place.

use toml_edit::{Array, Document, Item, TableLike, Value};

use super::draft::{Draft, Place, Texts, narrow};
use super::motion::{From, Rapid};
use super::motion_constants::Written;
use super::names::{Names, code};
use super::near::nearest;
use super::number::{parse_decimal, parse_rounding};
use super::row::{Default, Row};
use super::sections::{Form, ROOT, SECTIONS, Section};
use super::takes::{HIGHEST_M, List, Takes, lasting};
use super::toml_problem::toml_problem;
use super::{Axis, Gear, MayMove};
use crate::diag::{ConfigNeed, Diagnostic, Finding, Findings, FixTitle, KnownNames, LabelText, NameKind, shown};
use crate::dict::{AxisLetter, Decimal};
use crate::sure::small;
use crate::text::{FileId, Location, SourceText, Span};

/// The table whose values bound those of others.
const LIMITS: &str = "limits";

/// A key of a table and what it holds.
#[derive(Clone, Copy)]
struct Entry<'t> {
    /// The key.
    name: &'t str,
    /// Where the key stands.
    key: Location,
    /// Where the value stands; for a table the key in its header.
    at: Location,
    /// Its value.
    item: &'t Item,
}

/// A table and where something that it lacks is shown.
#[derive(Clone, Copy)]
struct Table<'t> {
    /// The path of keys that leads to it, with a point at the end; empty for the document.
    path: &'t str,
    /// Its header.
    at: Location,
    /// Its entries.
    table: &'t dyn TableLike,
}

/// Reads one document.
pub(super) struct Reader<'t> {
    text: &'t str,
    file: FileId,
    from: From,
    findings: &'t mut Findings,
    draft: &'t mut Draft,
}

/// Reads the text, which is `file` of the run, into `draft`: E0701 when it is no TOML, then nothing is set; E0702 for
/// each value of the wrong type or range and W0705 for each unknown key, and the rest is set. `from` says whose values
/// they are.
pub(super) fn read(draft: &mut Draft, from: From, source: &SourceText, file: FileId, findings: &mut Findings) {
    let text = source.text();
    let document = match Document::parse(text) {
        Ok(document) => document,
        Err(error) => {
            let (reason, span) = toml_problem(text, &error);
            let at = Location { file, span };
            return findings.add(Diagnostic::new(Finding::UnreadableConfiguration { reason }, at));
        }
    };
    let at = Location { file, span: Span::empty(source.first_offset()) };
    let root = Table { path: "", at, table: document.as_table() };
    Reader { text, file, from, findings, draft }.keys(ROOT, root);
    if root.table.contains_key("dialect") && !draft.places.contains_key("dialect") {
        draft.dialect_is_unusable = true;
    }
}

impl<'t> Reader<'t> {
    /// A table with the keys of that section, and the tables in it.
    fn keys(&mut self, section: &Section, table: Table<'_>) {
        let rows = section.form.rows();
        let mut known: Vec<&'static str> = rows.iter().map(|row| row.name).collect();
        known.extend(section.children().map(Section::own_name));
        self.values(table, rows, &known);
        (section.done)(self, table.at);
        // Limits first: gears go up to `limits.speed`.
        let mut children: Vec<_> = section.children().collect();
        children.sort_by_key(|child| child.name != LIMITS);
        for child in children {
            if let Some(entry) = self.entry(table.table, child.own_name()) {
                self.section(child, entry);
            }
        }
    }

    fn section(&mut self, section: &'static Section, entry: Entry<'_>) {
        let path = format!("{}.", section.name);
        if matches!(section.form, Form::List(_)) {
            for (at, table) in self.list(section.name, entry) {
                self.keys(section, Table { path: &path, at, table });
            }
            return;
        }
        let Some(table) = entry.item.as_table_like() else {
            return self.need(section.name, entry.at, ConfigNeed::Table);
        };
        let table = Table { path: &path, at: entry.key, table };
        match section.form {
            Form::Keys(_) | Form::List(_) => {
                self.draft.number = section.own_name().parse().unwrap_or(0);
                self.keys(section, table);
            }
            Form::Map(names) => {
                for (number, entry) in self.named(names, table) {
                    self.draft.number = number;
                    self.take(table, entry, names.takes(number));
                }
            }
            Form::Tables(names, rows) => {
                let known: Vec<&'static str> = rows.iter().map(|row| row.name).collect();
                for (number, entry) in self.named(names, table) {
                    let path = format!("{path}{}.", entry.name);
                    let Some(inner) = entry.item.as_table_like() else {
                        self.need(path.trim_end_matches('.'), entry.at, ConfigNeed::Table);
                        continue;
                    };
                    self.draft.number = number;
                    let inner = Table { path: &path, at: entry.key, table: inner };
                    self.values(inner, rows, &known);
                    (section.done)(self, entry.key);
                }
            }
        }
    }

    /// The tables of a list, `[[name]]` or `name = [{ … }]`, each with its header; what is none of these is reported.
    fn list<'v>(&mut self, name: &str, entry: Entry<'v>) -> Vec<(Location, &'v dyn TableLike)> {
        let mut tables: Vec<(Location, &'v dyn TableLike)> = Vec::new();
        match entry.item {
            Item::ArrayOfTables(list) => {
                tables.extend(
                    list.iter().map(|table| (self.place(table.span()).unwrap_or(entry.key), table as &dyn TableLike)),
                );
            }
            Item::Value(Value::Array(list)) => {
                for value in list {
                    let at = self.place(value.span()).unwrap_or(entry.at);
                    match value.as_inline_table() {
                        Some(table) => tables.push((at, table)),
                        None => self.need(name, at, ConfigNeed::Table),
                    }
                }
            }
            Item::None | Item::Table(_) | Item::Value(_) => {
                self.need(name, entry.at, ConfigNeed::List { name: name.to_owned() });
            }
        }
        tables
    }

    /// The entries of a table whose keys are names of the control, with their numbers. A name that is not known, given
    /// twice, or that of an error under `[lints]` is reported and left out.
    fn named<'v>(&mut self, names: Names, table: Table<'v>) -> Vec<(u16, Entry<'v>)> {
        let mut found: Vec<(u16, Entry<'v>)> = Vec::new();
        for entry in self.entries(table.table) {
            let Some(number) = names.number(entry.name) else {
                let misplaced = is_misplaced(table, entry.name).then_some(KnownNames::BeforeTables);
                let known = misplaced.unwrap_or(names.known());
                self.unknown(entry.name, entry.key, names.near(entry.name), Some(known));
                continue;
            };
            match found.iter().find(|(other, _)| *other == number) {
                Some((_, first)) => self.repeated(entry.name, first.key, entry.key),
                None => found.push((number, entry)),
            }
        }
        found.retain(|(number, entry)| {
            let fixed = names == Names::Lints && code(*number).is_some_and(|code| !code.is_configurable());
            if fixed {
                self.need(format!("{}{}", table.path, entry.name), entry.key, ConfigNeed::ErrorLevel);
            }
            !fixed
        });
        found
    }

    /// Takes the values of a table's keys: what a row does not take is reported and left out, and so are keys that are
    /// none of `known`, and one that must be there and is not.
    fn values(&mut self, table: Table<'_>, rows: &[Row], known: &[&'static str]) {
        for entry in self.entries(table.table) {
            if !known.contains(&entry.name) {
                let of = SECTIONS.iter().find(|section| {
                    let has_it = section.form.rows().iter().any(|row| row.name == entry.name);
                    has_it && matches!(section.form, Form::Keys(_)) && !section.name.is_empty()
                });
                let (near, known) = match of {
                    _ if is_misplaced(table, entry.name) => (None, Some(KnownNames::BeforeTables)),
                    Some(section) => (None, Some(KnownNames::OfTable { table: section.name.to_owned() })),
                    None => (nearest(entry.name, known.iter().copied()), None),
                };
                self.unknown(entry.name, entry.key, near, known);
            }
        }
        let mut required = rows.iter().filter(|row| matches!(row.default, Default::Required));
        if let Some(missing) = required.find(|row| !table.table.contains_key(row.name)) {
            let needs = ConfigNeed::Missing { key: missing.name.to_owned() };
            self.need(table.path.trim_end_matches('.'), table.at, needs);
        }
        for row in rows {
            if let Some(entry) = self.entry(table.table, row.name) {
                self.take(table, entry, row.takes);
            }
        }
    }

    /// Puts the value of an entry into its field when `takes` takes it; else it is reported.
    fn take(&mut self, table: Table<'_>, entry: Entry<'_>, takes: Takes) {
        let path = format!("{}{}", table.path, entry.name);
        let takes = takes.under(self.draft.settings.machine.limits.speed);
        self.draft.place = Place { key: entry.key, at: entry.at, from: self.from };
        let value = entry.item.as_value();
        let text = value.and_then(Value::as_str);
        let integer = value.and_then(Value::as_integer);
        let taken = match takes {
            Takes::Flag(set) => value.and_then(Value::as_bool).map(|flag| set(self.draft, flag)),
            Takes::Path(set) => text.map(|path| set(self.draft, path.to_owned())),
            Takes::OneOf(choices, set) => {
                text.filter(|text| choices().contains(text)).map(|text| set(self.draft, text))
            }
            // A speed is a whole number by now.
            Takes::Speed { .. } => None,
            Takes::Whole { min, max, set } => integer
                .filter(|&number| number >= min && max.is_none_or(|max| number <= max))
                .map(|number| set(self.draft, number)),
            Takes::MFunction => integer.filter(|m| (0..=HIGHEST_M).contains(m)).map(|m| self.draft.set_m_power_up(m)),
            Takes::GFunction(group) => integer
                .and_then(|number| lasting(group).find(|code| i64::from(code.number()) == number))
                .map(|code| self.draft.set_power_up(code)),
            Takes::Number { min, max, set } => self
                .number(value, entry.at, |number| (min..=max).contains(&number))
                .map(|number| set(self.draft, number)),
            Takes::ParameterValue(set) => {
                self.number(value, entry.at, Decimal::fits_parameter).map(|number| set(self.draft, number))
            }
            Takes::Rapid { min, max, set } => match entry.item.as_table_like() {
                Some(axes) => {
                    let Some(axes) = self.axes(&path, axes, takes, &|number| (min..=max).contains(&number)) else {
                        return;
                    };
                    set(self.draft, Rapid::Axes(axes));
                    Some(())
                }
                None => self
                    .number(value, entry.at, |number| (min..=max).contains(&number))
                    .map(|number| set(self.draft, Rapid::Path(number))),
            },
            Takes::Constant(set) => {
                value.and_then(|value| self.constant(value)).map(|written| set(self.draft, written))
            }
            Takes::Texts(list, set) => match value.and_then(Value::as_array) {
                Some(array) => {
                    let Some(texts) = self.texts(&path, array, takes, list) else { return };
                    set(self.draft, texts);
                    Some(())
                }
                None => None,
            },
        };
        match taken {
            Some(()) => {
                self.draft.places.insert(path, self.draft.place);
            }
            None => self.need(path, entry.at, takes.need()),
        }
    }

    /// A table of numbers by axis letter; what is none is reported at its place, and the table left out.
    fn axes(
        &mut self,
        path: &str,
        table: &dyn TableLike,
        takes: Takes,
        holds: &dyn Fn(Decimal) -> bool,
    ) -> Option<Vec<(AxisLetter, Decimal)>> {
        let mut axes = Vec::new();
        let mut wrong = false;
        for inner in self.entries(table) {
            let letter = AxisLetter::ALL.into_iter().find(|letter| letter.name() == inner.name);
            match (letter, self.number(inner.item.as_value(), inner.at, holds)) {
                (Some(letter), Some(number)) => axes.push((letter, number)),
                (None, _) => {
                    self.unknown(inner.name, inner.key, Names::Axes.near(inner.name), Some(Names::Axes.known()));
                }
                (Some(_), None) => {
                    wrong = true;
                    self.need(format!("{path}.{}", inner.name), inner.at, takes.need());
                }
            }
        }
        (!wrong).then_some(axes)
    }

    /// The elements of a list; what is none is reported at its place, and the list left out.
    fn texts(&mut self, path: &str, array: &Array, takes: Takes, list: List) -> Option<Texts> {
        let mut texts = Vec::new();
        let mut wrong = false;
        for value in array {
            let at = self.place(value.span()).unwrap_or(self.draft.place.at);
            match value.as_str().and_then(|text| list.element(text)) {
                Some(text) => texts.push((text.to_owned(), at)),
                None => {
                    wrong = true;
                    self.need(path, at, takes.need());
                }
            }
        }
        (!wrong).then_some(texts)
    }

    /// The digits of a number, as written but for `_`, or a text of digits.
    fn constant(&self, value: &Value) -> Option<Written> {
        let quoted = value.is_str();
        let mut digits = match value {
            Value::Integer(_) | Value::Float(_) => self.written(value)?,
            Value::String(text) => text.value().clone(),
            Value::Boolean(_) | Value::Datetime(_) | Value::Array(_) | Value::InlineTable(_) => return None,
        };
        // `0x10` and its like are numbers too, but no digits that a control shows.
        if let (Some(number), None) = (value.as_integer(), parse_decimal(&digits)) {
            digits = number.to_string();
        }
        let plain = !digits.contains(['e', 'E']) || value.is_float();
        parse_decimal(&digits).filter(|_| plain)?;
        Some(Written { digits, quoted })
    }

    /// A number that `holds` holds: a float by its digits in the text, never through binary. One that is finer than
    /// 0.001 gets W0303.
    fn number(&mut self, value: Option<&Value>, at: Location, holds: impl Fn(Decimal) -> bool) -> Option<Decimal> {
        let value = value?;
        let (number, exact) = match value.as_integer() {
            Some(whole) => (Decimal::whole(whole), true),
            None => parse_rounding(&self.written(value).filter(|_| value.is_float())?)?,
        };
        if !holds(number) {
            return None;
        }
        if !exact {
            let finding = Finding::FinerThanResolution { rounded: number.to_string() };
            self.findings.add(Diagnostic::new(finding, at));
        }
        Some(number)
    }

    /// A number as the text has it, without `_`.
    fn written(&self, value: &Value) -> Option<String> {
        self.text.get(value.span()?).map(|digits| digits.replace('_', ""))
    }

    fn place(&self, range: Option<std::ops::Range<usize>>) -> Option<Location> {
        range.map(|range| Location { file: self.file, span: to_span(range) })
    }

    /// The entry of that name.
    fn entry<'v>(&self, table: &'v dyn TableLike, name: &str) -> Option<Entry<'v>> {
        let (key, item) = table.get_key_value(name)?;
        let place = self.place(key.span()).unwrap_or(Location { file: self.file, span: Span::default() });
        let at = item.as_value().and_then(|value| self.place(value.span())).unwrap_or(place);
        Some(Entry { name: key.get(), key: place, at, item })
    }

    /// The entries of a table, in the order of the text.
    fn entries<'v>(&self, table: &'v dyn TableLike) -> Vec<Entry<'v>> {
        let mut entries: Vec<_> = table.iter().filter_map(|(name, _)| self.entry(table, name)).collect();
        entries.sort_by_key(|entry| entry.key);
        entries
    }

    /// Reports that the value of `key` is not what it must be (E0702).
    fn need(&mut self, key: impl AsRef<str>, at: Location, needs: ConfigNeed) {
        self.findings.add(Diagnostic::new(Finding::ConfigurationValue { key: shown(key.as_ref()), needs }, at));
    }

    /// Reports that `key` is there twice (E0702), at the second.
    fn repeated(&mut self, key: impl AsRef<str>, first: Location, second: Location) {
        let what = shown(key.as_ref());
        let finding = Finding::ConfigurationValue { key: what.clone(), needs: ConfigNeed::Repeated };
        self.findings.add(Diagnostic::new(finding, second).with_label(first, LabelText::First { what }));
    }

    /// Reports a key that is not known (W0705).
    fn unknown(&mut self, name: &str, at: Location, near: Option<String>, known: Option<KnownNames>) {
        let finding =
            Finding::UnknownConfigurationKey { kind: NameKind::Key, key: shown(name), near: near.clone(), known };
        let diagnostic = Diagnostic::new(finding, at);
        self.findings.add(match near {
            Some(near) => diagnostic.with_offer(FixTitle::Write { text: near.clone() }, at, near),
            None => diagnostic,
        });
    }

    /// Where the last value of that path stands.
    fn at(&self, path: &str) -> Location {
        self.draft.places.get(path).map(|place| place.at).unwrap_or_default()
    }

    /// Reports a lower end above its upper end, at the later of the two.
    fn ordered<T: PartialOrd>(&mut self, table: &str, min: Option<T>, max: Option<T>) {
        if let (Some(min), Some(max)) = (min, max)
            && min > max
        {
            let at = self.at(&format!("{table}.min")).max(self.at(&format!("{table}.max")));
            self.need(table, at, ConfigNeed::Range);
        }
    }

    /// Ends one of `[[axes]]` (ADR-4). Without `kind` the letter decides, as on a machine without configured axes.
    pub(super) fn axis(&mut self, table: Location) {
        let axis = std::mem::take(&mut self.draft.axis);
        self.ordered("axes", axis.min, axis.max);
        let Some(letter) = axis.letter else { return };
        let at = self.at("axes.letter");
        match self.draft.axes.iter().find(|(other, _)| other.letter == letter) {
            Some((_, first)) => self.repeated(letter.name(), first.at, at),
            None => {
                let rotary = axis.rotary.unwrap_or(letter.is_rotary_by_default());
                let axis = Axis { letter, rotary, min: axis.min, max: axis.max };
                self.draft.axes.push((axis, Place { key: table, at, from: self.from }));
            }
        }
    }

    /// Ends one of `[[gears]]` (MFN-9).
    pub(super) fn gear(&mut self, _: Location) {
        let gear = std::mem::take(&mut self.draft.gear);
        self.ordered("gears", gear.min, gear.max);
        let Some(m) = gear.m else { return };
        let at = self.at("gears.m");
        if let Some((_, first)) = self.draft.gears.iter().find(|(other, _)| *other == m) {
            return self.repeated(format!("M{m}"), *first, at);
        }
        if let (Some(min), Some(max)) = (gear.min, gear.max) {
            self.draft.gears.push((m, at));
            let output = gear.output.unwrap_or(Decimal::whole(1));
            self.draft.settings.machine.gears.push(Gear { m, min, max, output });
        }
    }

    /// Ends one of `[machine-macrocycles]` (FLW-12): without `axes` it may move any.
    pub(super) fn machine_macrocycle(&mut self, _: Location) {
        let number = u32::from(self.draft.number);
        self.draft.settings.machine.macrocycles.entry(number).or_insert(MayMove::All);
    }

    /// Ends `[motion]`.
    pub(super) fn motion(&mut self, _: Location) {
        self.draft.settings.machine.motion.configured |= self.from == From::Key;
    }

    /// Ends `[motion.sets.1]` and its like: the set is there, even without values.
    pub(super) fn motion_set(&mut self, _: Location) {
        let set: usize = narrow(self.draft.number);
        if let Some(slot) = self.draft.settings.machine.motion.sets.get_mut(set) {
            slot.get_or_insert_default();
        }
    }
}

/// Whether a key in a table is one of those before all tables.
fn is_misplaced(table: Table<'_>, name: &str) -> bool {
    !table.path.is_empty() && ROOT.form.rows().iter().any(|row| row.name == name)
}

/// A range of the parser as a span.
pub(super) fn to_span(range: std::ops::Range<usize>) -> Span {
    Span::new(small(range.start), small(range.end))
}
