//! A row of the table of keys: what one key of the project file takes and means. Reader, JSON Schema, reference page,
//! `init`, `explain` and the editor's settings are all made of rows.

use super::takes::Takes;
use crate::dict::{Bilingual, Dialect};

/// A key with a value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// The key, in its table.
    pub name: &'static str,
    /// The type and range of its value, and where it goes.
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
    /// This value, as TOML that is JSON too.
    Is(&'static str),
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

    /// The default as TOML, where there is one.
    pub(super) fn literal(&self, dialect: Dialect) -> Option<String> {
        match self.default {
            Default::Is(_) if self.name == "dialect" => Some(format!("\"{}\"", dialect.name())),
            Default::Is(value) => Some(value.to_owned()),
            Default::ByDialect(value) => Some(value(dialect)),
            Default::Nothing | Default::Required | Default::Words(_) => None,
        }
    }

    /// The line that sets it to its default, else to its example.
    pub(super) fn line(&self, dialect: Dialect) -> String {
        format!("{} = {}", self.name, self.literal(dialect).unwrap_or_else(|| self.example.to_owned()))
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

/// Tables of rows: name and rule, option and example where there are any; what it takes; what holds without it; its
/// effect in English and Czech.
macro_rules! rows {
    ($($(#[$doc:meta])* $table:ident: $($name:literal $rule:literal $(option $option:literal)? $(example $example:literal)?
        : $takes:expr, $default:expr => $en:literal, $cs:literal;)*)*) => {$(
        $(#[$doc])*
        pub(super) const $table: &[Row] = &[$(
            row($name, $takes, $default, ($en, $cs), $rule)$(.with_option($option))?$(.with_example($example))?,
        )*];
    )*};
}
pub(super) use rows;
