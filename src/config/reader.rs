//! Values of a TOML document, taken by the rows of the table of keys: each with its places, each fault a finding.

use toml_edit::{Array, Item, TableLike, Value};

use super::Takes;
use super::names::Names;
use super::near::nearest;
use super::number::{parse_decimal, parse_rounding};
use super::row::{Default, Row};
use super::taken::{Setting, Taken, Values};
use crate::diag::{ConfigNeed, Diagnostic, Finding, Findings, FixTitle, KnownNames, LabelText, NameKind, shown};
use crate::dict::{AxisLetter, Decimal};
use crate::sure::small;
use crate::text::{FileId, Location, Span};

/// A key of a table and what it holds.
#[derive(Clone, Copy)]
pub(super) struct Entry<'t> {
    /// The key.
    pub name: &'t str,
    /// Where the key stands.
    pub key: Span,
    /// Where the value stands; for a table the key in its header.
    pub at: Span,
    /// Its value.
    pub item: &'t Item,
}

/// A table and where something that it lacks is shown.
#[derive(Clone, Copy)]
pub(super) struct Table<'t> {
    /// The path of keys that leads to it, with a point at the end; empty for the document.
    pub path: &'t str,
    /// Its header.
    pub at: Span,
    /// Its entries.
    pub table: &'t dyn TableLike,
}

impl<'t> Table<'t> {
    /// Its name, without the point.
    pub(super) fn name(self) -> &'t str {
        self.path.trim_end_matches('.')
    }
}

/// Reads one document.
pub(super) struct Reader<'t> {
    text: &'t str,
    file: FileId,
    findings: &'t mut Findings,
}

impl<'t> Reader<'t> {
    /// For the document that was parsed from `text`, byte-order mark included.
    pub(super) const fn new(text: &'t str, file: FileId, findings: &'t mut Findings) -> Self {
        Self { text, file, findings }
    }

    /// Reports that the value of `key` is not what it must be (E0702).
    pub(super) fn need(&mut self, key: impl AsRef<str>, at: Span, needs: ConfigNeed) {
        let finding = Finding::ConfigurationValue { key: shown(key.as_ref()), needs };
        self.findings.add(Diagnostic::new(finding, self.place(at)));
    }

    /// Reports that `key` is there twice (E0702), at the second.
    pub(super) fn repeated(&mut self, key: impl AsRef<str>, first: Span, second: Span) {
        let finding = Finding::ConfigurationValue { key: shown(key.as_ref()), needs: ConfigNeed::Repeated };
        let first = self.place(first);
        let label = LabelText::First { what: shown(key.as_ref()) };
        self.findings.add(Diagnostic::new(finding, self.place(second)).with_label(first, label));
    }

    /// Reports a key that is not known (W0705).
    pub(super) fn unknown(&mut self, name: &str, at: Span, near: Option<String>, known: Option<KnownNames>) {
        let finding =
            Finding::UnknownConfigurationKey { kind: NameKind::Key, key: shown(name), near: near.clone(), known };
        let meant = near.map(|near| (FixTitle::Write { text: near.clone() }, near));
        let place = self.place(at);
        let diagnostic = Diagnostic::new(finding, place);
        self.findings.add(match meant {
            Some((title, near)) => diagnostic.with_offer(title, place, near),
            None => diagnostic,
        });
    }

    /// Reports the keys of a table that are none of `known`.
    pub(super) fn warn_unknown(&mut self, table: Table<'_>, known: &[&'static str]) {
        for entry in entries(table.table) {
            if !known.contains(&entry.name) {
                self.unknown(entry.name, entry.key, nearest(entry.name, known.iter().copied()), None);
            }
        }
    }

    /// Reports a lower end above its upper end, at the later of the two.
    pub(super) fn ordered<T: PartialOrd>(&mut self, values: &Values, min: Option<Setting<T>>, max: Option<Setting<T>>) {
        if let (Some(min), Some(max)) = (min, max)
            && min.value > max.value
        {
            self.need(&values.name, min.at.max(max.at), ConfigNeed::Range);
        }
    }

    /// The place of a span in this document.
    pub(super) const fn place(&self, span: Span) -> Location {
        Location { file: self.file, span }
    }

    /// The values of a table's keys, each checked by its row: what a row does not take is reported and left out, and so
    /// is a key that must be there and is not.
    pub(super) fn values(&mut self, table: Table<'_>, rows: &'static [Row]) -> Values {
        let mut required = rows.iter().filter(|row| matches!(row.default, Default::Required));
        if let Some(missing) = required.find(|row| !table.table.contains_key(row.name)) {
            self.need(table.name(), table.at, ConfigNeed::Missing { key: missing.name.to_owned() });
        }
        let mut taken = Vec::new();
        for row in rows {
            if let Some(entry) = entry(table.table, row.name)
                && let Some(value) = self.taken(table, entry, row.takes)
            {
                taken.push((row.name, Setting { value, key: entry.key, at: entry.at }));
            }
        }
        Values { name: table.name().to_owned(), at: table.at, taken }
    }

    /// The value of an entry when `takes` takes it; else it is reported.
    pub(super) fn taken(&mut self, table: Table<'_>, entry: Entry<'_>, takes: Takes) -> Option<Taken> {
        let key = format!("{}{}", table.path, entry.name);
        if let (Takes::NumberOrAxes { .. }, Some(axes)) = (takes, entry.item.as_table_like()) {
            return self.axes(&key, axes, takes);
        }
        let taken = entry.item.as_value().and_then(|value| match takes {
            Takes::Flag => value.as_bool().map(Taken::Flag),
            Takes::Path => value.as_str().map(|path| Taken::Text(path.to_owned())),
            Takes::Paths => value.as_array().and_then(|list| self.texts(&key, entry, list, takes, Some)),
            Takes::Extensions => value.as_array().and_then(|list| self.texts(&key, entry, list, takes, extension)),
            Takes::Letters => value.as_array().and_then(|list| self.texts(&key, entry, list, takes, letter)),
            Takes::OneOf(choices) => {
                value.as_str().filter(|text| choices().contains(text)).map(|text| Taken::Text(text.to_owned()))
            }
            Takes::Whole { .. } | Takes::GFunction(_) | Takes::MFunction => {
                value.as_integer().filter(|&number| takes.holds_whole(number)).map(Taken::Whole)
            }
            Takes::Number { .. } | Takes::NumberOrAxes { .. } | Takes::ParameterValue => {
                self.number(value, entry.at, takes).map(Taken::Number)
            }
            Takes::Constant => self.digits(value).map(Taken::Text),
        });
        let is_list = matches!(takes, Takes::Paths | Takes::Extensions | Takes::Letters);
        if taken.is_none() && !(is_list && entry.item.as_array().is_some()) {
            self.need(key, entry.at, takes.need());
        }
        taken
    }

    /// A table of numbers by axis letter; what is none is reported at its place, and the table left out.
    fn axes(&mut self, key: &str, table: &dyn TableLike, takes: Takes) -> Option<Taken> {
        let mut axes = Vec::new();
        let mut wrong = false;
        for inner in entries(table) {
            let letter = AxisLetter::ALL.into_iter().find(|letter| letter.name() == inner.name);
            let number = inner.item.as_value().and_then(|value| self.number(value, inner.at, takes));
            match (letter, number) {
                (Some(letter), Some(number)) => axes.push((letter, number)),
                (None, _) => {
                    self.unknown(inner.name, inner.key, Names::Axes.near(inner.name), Some(Names::Axes.known()));
                }
                (Some(_), None) => {
                    wrong = true;
                    self.need(format!("{key}.{}", inner.name), inner.at, takes.need());
                }
            }
        }
        if wrong { None } else { Some(Taken::Axes(axes)) }
    }

    /// A list of texts that `form` takes, as it gives them; what is none is reported at its place, and the list left out.
    fn texts<'v>(
        &mut self,
        key: &str,
        entry: Entry<'_>,
        list: &'v Array,
        takes: Takes,
        form: fn(&'v str) -> Option<&'v str>,
    ) -> Option<Taken> {
        let mut texts = Vec::new();
        let mut wrong = false;
        for value in list {
            let at = value.span().map_or(entry.at, to_span);
            match value.as_str().and_then(form) {
                Some(text) => texts.push((text.to_owned(), at)),
                None => {
                    wrong = true;
                    self.need(key, at, takes.need());
                }
            }
        }
        if wrong { None } else { Some(Taken::Texts(texts)) }
    }

    /// The digits of a number, as written but for `_`, or a text of digits.
    fn digits(&self, value: &Value) -> Option<String> {
        let text = match value {
            Value::Integer(_) | Value::Float(_) => written(self.text, value)?,
            Value::String(text) => text.value().clone(),
            Value::Boolean(_) | Value::Datetime(_) | Value::Array(_) | Value::InlineTable(_) => {
                return None;
            }
        };
        let text = match value {
            // `0x10` and its like are numbers too, but no digits that a control shows.
            Value::Integer(number) if parse_decimal(&text).is_none() => number.value().to_string(),
            Value::Integer(_)
            | Value::Float(_)
            | Value::String(_)
            | Value::Boolean(_)
            | Value::Datetime(_)
            | Value::Array(_)
            | Value::InlineTable(_) => text,
        };
        let plain = !text.contains(['e', 'E']) || matches!(value, Value::Float(_));
        parse_decimal(&text).filter(|_| plain)?;
        Some(text)
    }

    /// A number in the range that `takes` gives: a float by its digits in the text, never through binary. One that is
    /// finer than 0.001 gets W0303.
    fn number(&mut self, value: &Value, at: Span, takes: Takes) -> Option<Decimal> {
        let (number, exact) = match value {
            Value::Integer(number) => (Decimal::whole(*number.value()), true),
            Value::Float(_) => parse_rounding(&written(self.text, value)?)?,
            Value::String(_) | Value::Boolean(_) | Value::Datetime(_) | Value::Array(_) | Value::InlineTable(_) => {
                return None;
            }
        };
        if !takes.holds_number(number) {
            return None;
        }
        if !exact {
            let finding = Finding::FinerThanResolution { rounded: number.to_string() };
            self.findings.add(Diagnostic::new(finding, self.place(at)));
        }
        Some(number)
    }
}

/// An axis letter.
fn letter(text: &str) -> Option<&str> {
    AxisLetter::ALL.iter().any(|letter| letter.name() == text).then_some(text)
}

/// An extension without its point.
fn extension(text: &str) -> Option<&str> {
    let text = text.strip_prefix('.').unwrap_or(text);
    let good = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'-' || byte == b'_';
    if !text.is_empty() && text.bytes().all(good) { Some(text) } else { None }
}

/// A number as the text has it, without `_`.
fn written(text: &str, value: &Value) -> Option<String> {
    text.get(value.span()?).map(|digits| digits.replace('_', ""))
}

/// A range of the parser as a span.
pub(super) fn to_span(range: std::ops::Range<usize>) -> Span {
    Span::new(small(range.start), small(range.end))
}

/// The entry of that name.
pub(super) fn entry<'t>(table: &'t dyn TableLike, name: &str) -> Option<Entry<'t>> {
    let (key, item) = table.get_key_value(name)?;
    let place = key.span().map_or(Span::default(), to_span);
    let at = match item {
        Item::Value(value) => value.span().map_or(place, to_span),
        Item::None | Item::Table(_) | Item::ArrayOfTables(_) => place,
    };
    Some(Entry { name: key.get(), key: place, at, item })
}

/// The entries of a table, in the order of the text.
pub(super) fn entries(table: &dyn TableLike) -> Vec<Entry<'_>> {
    let mut entries: Vec<_> = table.iter().filter_map(|(name, _)| entry(table, name)).collect();
    entries.sort_by_key(|entry| entry.key);
    entries
}
