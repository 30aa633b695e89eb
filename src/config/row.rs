//! A row of the table of keys: what one key of the project file takes and means. Reader, JSON Schema, reference page,
//! `init`, `explain` and the editor's settings are all made of rows.

use super::Takes;
use crate::dict::{Bilingual, Decimal, Dialect};

/// A key with a value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// The key, in its table.
    pub name: &'static str,
    /// The type and range of its value.
    pub takes: Takes,
    /// What holds without it.
    pub default: Default,
    /// Its effect.
    pub meaning: Bilingual,
    /// The rule.
    pub rule: &'static str,
    /// The option of the command line that wins over it; the editor's settings have a key of its name then.
    pub option: Option<&'static str>,
    /// A value as TOML, for keys that have no default to show.
    pub example: &'static str,
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
    /// These texts.
    Texts(&'static [&'static str]),
    /// A value as TOML that depends on the control.
    ByDialect(fn(Dialect) -> String),
    /// Something that depends.
    Words(Bilingual),
}

impl Row {
    /// With a value to show.
    pub(super) const fn with_example(self, example: &'static str) -> Self {
        Self { example, ..self }
    }

    /// With an option of the command line.
    pub(super) const fn with_option(self, option: &'static str) -> Self {
        Self { option: Some(option), ..self }
    }
}

/// A row without an option; `meaning` in English and Czech.
pub(super) const fn row(
    name: &'static str,
    takes: Takes,
    default: Default,
    meaning: (&'static str, &'static str),
    rule: &'static str,
) -> Row {
    Row { name, takes, default, meaning: Bilingual { en: meaning.0, cs: meaning.1 }, rule, option: None, example: "" }
}

/// A default in words, English and Czech.
pub(super) const fn words(en: &'static str, cs: &'static str) -> Default {
    Default::Words(Bilingual { en, cs })
}
