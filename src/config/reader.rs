//! Values of a TOML document, taken by the rows of the table of keys: each with its places, each fault a finding.

use toml_edit::{Item, TableLike, Value};

use super::Takes;
use super::keys::Row;
use super::near::nearest;
use super::number::parse_decimal;
use crate::diag::{ConfigNeed, Diagnostic, Finding, Findings, LabelText, shown};
use crate::dict::Decimal;
use crate::text::{FileId, Location, Span};

/// A value with its places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Setting<T> {
    /// The value.
    pub value: T,
    /// Its key.
    pub key: Span,
    /// The value as written; of a table its key.
    pub at: Span,
}

/// A key of a table and what it holds.
#[derive(Clone, Copy)]
pub(super) struct Entry<'t> {
    /// The key.
    pub name: &'t str,
    /// Where the key stands.
    pub key: Span,
    /// Where the value stands; for a table the key in its header.
    pub at: Span,
    /// What it holds.
    pub item: &'t Item,
}

/// A table and where something that it lacks is shown.
#[derive(Clone, Copy)]
pub(super) struct Table<'t> {
    /// The path of keys that leads to it, with a point at the end; empty for the document.
    pub path: &'t str,
    /// Its header.
    pub at: Span,
    /// What it holds.
    pub table: &'t dyn TableLike,
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
        self.findings.add(Diagnostic::new(finding, self.place(second)).with_label(first, LabelText::First));
    }

    /// Reports a key that is not known (W0705).
    pub(super) fn unknown(&mut self, name: &str, at: Span, near: Option<String>) {
        let finding = Finding::UnknownConfigurationKey { key: shown(name), near };
        self.findings.add(Diagnostic::new(finding, self.place(at)));
    }

    /// Reports the keys of a table that are none of `known`.
    pub(super) fn warn_unknown(&mut self, table: Table<'_>, known: &[&'static str]) {
        for entry in entries(table.table) {
            if !known.contains(&entry.name) {
                self.unknown(entry.name, entry.key, nearest(entry.name, known.iter().copied()));
            }
        }
    }

    /// The place of a span in this document.
    pub(super) const fn place(&self, span: Span) -> Location {
        Location { file: self.file, span }
    }

    /// The value of the row's key when it is there and `read` takes it; else reports what the row takes.
    pub(super) fn take<T>(
        &mut self,
        table: Table<'_>,
        row: &Row,
        read: impl FnOnce(&Value) -> Option<T>,
    ) -> Option<Setting<T>> {
        let entry = entry(table.table, row.name)?;
        match entry.item.as_value().and_then(read) {
            Some(value) => Some(Setting { value, key: entry.key, at: entry.at }),
            None => {
                self.need(format!("{}{}", table.path, row.name), entry.at, row.takes.need());
                None
            }
        }
    }

    /// A flag.
    pub(super) fn flag(&mut self, table: Table<'_>, row: &Row) -> Option<Setting<bool>> {
        self.take(table, row, Value::as_bool)
    }

    /// A text.
    pub(super) fn text(&mut self, table: Table<'_>, row: &Row) -> Option<Setting<String>> {
        self.take(table, row, |value| value.as_str().map(str::to_owned))
    }

    /// A list of texts; one that is none is reported at its place, and the list left out.
    pub(super) fn texts(&mut self, table: Table<'_>, row: &Row) -> Option<Setting<Vec<String>>> {
        let list = self.take(table, row, |value| value.as_array().cloned())?;
        let mut texts = Vec::new();
        let mut wrong = false;
        for value in &list.value {
            match value.as_str() {
                Some(text) => texts.push(text.to_owned()),
                None => {
                    wrong = true;
                    self.need(row.name, value.span().map_or(list.at, to_span), row.takes.need());
                }
            }
        }
        if wrong { None } else { Some(Setting { value: texts, key: list.key, at: list.at }) }
    }

    /// What one of the texts of a row means.
    pub(super) fn choice<T>(
        &mut self,
        table: Table<'_>,
        row: &Row,
        meaning: impl FnOnce(&str) -> Option<T>,
    ) -> Option<Setting<T>> {
        self.take(table, row, |value| value.as_str().and_then(meaning))
    }

    /// A whole number in the row's range.
    pub(super) fn whole<T: TryFrom<i64>>(&mut self, table: Table<'_>, row: &Row) -> Option<Setting<T>> {
        self.take(table, row, |value| whole(value, row.takes))
    }

    /// A number in the row's range.
    pub(super) fn number(&mut self, table: Table<'_>, row: &Row) -> Option<Setting<Decimal>> {
        let text = self.text;
        self.take(table, row, |value| number(text, value, row.takes))
    }

    /// The digits of a number, as written but for `_` and a `+`, or a text of digits.
    pub(super) fn digits(&self, value: &Value) -> Option<String> {
        let text = match value {
            Value::Integer(number) => number.value().to_string(),
            Value::Float(_) => written(self.text, value)?,
            Value::String(text) => text.value().clone(),
            Value::Boolean(_) | Value::Datetime(_) | Value::Array(_) | Value::InlineTable(_) => {
                return None;
            }
        };
        let plain = !text.contains(['e', 'E']) || matches!(value, Value::Float(_));
        parse_decimal(&text).filter(|_| plain)?;
        Some(text.strip_prefix('+').unwrap_or(&text).to_owned())
    }

    /// A number that `takes` holds.
    pub(super) fn number_of(&self, value: &Value, takes: Takes) -> Option<Decimal> {
        number(self.text, value, takes)
    }
}

/// A whole number in the range that `takes` gives.
pub(super) fn whole<T: TryFrom<i64>>(value: &Value, takes: Takes) -> Option<T> {
    value.as_integer().filter(|&number| takes.holds_whole(number)).and_then(|number| T::try_from(number).ok())
}

/// A number in the range that `takes` gives: a float by its digits in the text, never through binary.
fn number(text: &str, value: &Value, takes: Takes) -> Option<Decimal> {
    let number = match value {
        Value::Integer(number) => Decimal::whole(*number.value()),
        Value::Float(_) => parse_decimal(&written(text, value)?)?,
        Value::String(_) | Value::Boolean(_) | Value::Datetime(_) | Value::Array(_) | Value::InlineTable(_) => {
            return None;
        }
    };
    Some(number).filter(|&number| takes.holds_number(number))
}

/// A number as it stands in the text, without `_`.
fn written(text: &str, value: &Value) -> Option<String> {
    text.get(value.span()?).map(|digits| digits.replace('_', ""))
}

/// A range of the parser as a span.
pub(super) fn to_span(range: std::ops::Range<usize>) -> Span {
    let offset = |at| u32::try_from(at).unwrap_or(u32::MAX);
    Span::new(offset(range.start), offset(range.end))
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
