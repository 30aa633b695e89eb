//! The values of the keys in one table of the project file, each already checked by its row.

use super::row::Row;
use crate::dict::{AxisLetter, Decimal};
use crate::text::Span;

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

impl<T> Setting<T> {
    /// With another value at the same places; `None` when `f` returns `None`.
    pub(super) fn and_then<U>(self, f: impl FnOnce(T) -> Option<U>) -> Option<Setting<U>> {
        let (key, at) = (self.key, self.at);
        f(self.value).map(|value| Setting { value, key, at })
    }
}

/// A value that its row takes.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Taken {
    /// A flag.
    Flag(bool),
    /// A text: a path, one of several, the digits of a constant.
    Text(String),
    /// Texts, each at its place.
    Texts(Vec<(String, Span)>),
    /// A whole number.
    Whole(i64),
    /// A number.
    Number(Decimal),
    /// Numbers by axis letter.
    Axes(Vec<(AxisLetter, Decimal)>),
}

impl Taken {
    /// The text.
    pub(super) fn text(&self) -> Option<&str> {
        if let Self::Text(text) = self { Some(text) } else { None }
    }

    /// The whole number, as `T`.
    pub(super) fn whole<T: TryFrom<i64>>(&self) -> Option<T> {
        if let Self::Whole(number) = self { T::try_from(*number).ok() } else { None }
    }

    /// The number.
    pub(super) const fn number(&self) -> Option<Decimal> {
        if let Self::Number(number) = self { Some(*number) } else { None }
    }
}

/// The keys of one table that are there and have a value that their rows take. A getter of another type than the row's
/// gives nothing; tests show that each row is read by the right one.
#[derive(Clone, Debug)]
pub(super) struct Values {
    /// The name of the table.
    pub name: String,
    /// Its header.
    pub at: Span,
    /// The values, by key.
    pub taken: Vec<(&'static str, Setting<Taken>)>,
}

impl Values {
    fn get(&self, row: &Row) -> Option<Setting<&Taken>> {
        let (_, Setting { value, key, at }) = self.taken.iter().find(|(name, _)| *name == row.name)?;
        Some(Setting { value, key: *key, at: *at })
    }

    /// A flag.
    pub(super) fn flag(&self, row: &Row) -> Option<Setting<bool>> {
        self.get(row)?.and_then(|taken| if let Taken::Flag(flag) = taken { Some(*flag) } else { None })
    }

    /// The value as it is.
    pub(super) fn any(&self, row: &Row) -> Option<Setting<Taken>> {
        self.get(row)?.and_then(|taken| Some(taken.clone()))
    }

    /// A text.
    pub(super) fn text(&self, row: &Row) -> Option<Setting<String>> {
        self.get(row)?.and_then(|taken| taken.text().map(str::to_owned))
    }

    /// Texts with their places.
    pub(super) fn texts(&self, row: &Row) -> Option<Setting<Vec<(String, Span)>>> {
        self.get(row)?.and_then(|taken| if let Taken::Texts(texts) = taken { Some(texts.clone()) } else { None })
    }

    /// The meaning of the text.
    pub(super) fn choice<T>(&self, row: &Row, meaning: impl FnOnce(&str) -> Option<T>) -> Option<Setting<T>> {
        self.get(row)?.and_then(|taken| taken.text().and_then(meaning))
    }

    /// A whole number.
    pub(super) fn whole<T: TryFrom<i64>>(&self, row: &Row) -> Option<Setting<T>> {
        self.get(row)?.and_then(Taken::whole)
    }

    /// A number.
    pub(super) fn number(&self, row: &Row) -> Option<Setting<Decimal>> {
        self.get(row)?.and_then(Taken::number)
    }
}

/// A name of a table whose keys are names of the control, with its value.
#[derive(Clone, Debug)]
pub(super) struct Named {
    /// The number of the name, from [`Names::number`](super::names::Names::number).
    pub number: u16,
    /// Its value.
    pub value: Taken,
    /// Its key.
    pub key: Span,
    /// The value as written.
    pub at: Span,
}

impl Named {
    /// With a value of another type; `None` when `f` returns `None`.
    pub(super) fn setting<T>(&self, f: impl FnOnce(&Taken) -> Option<T>) -> Option<Setting<T>> {
        f(&self.value).map(|value| Setting { value, key: self.key, at: self.at })
    }
}
