//! The type, range and field of a key in the project file: one description for the reader, the schema and the reference
//! page.

use serde_json::{Value, json};

use super::Rapid;
use super::draft::{Draft, Texts};
use super::motion_constants::Written;
use crate::diag::ConfigNeed;
use crate::dict::{AxisLetter, Decimal, Dialect, GCode, GGroup, Lang, Lasting};

/// The type and range of a value, and the function that puts it into its field.
#[derive(Clone, Copy, Debug)]
pub(super) enum Takes {
    /// `true` or `false`.
    Flag(fn(&mut Draft, bool)),
    /// A path, relative to the project file's folder.
    Path(fn(&mut Draft, String)),
    /// A list of texts.
    Texts(List, fn(&mut Draft, Texts)),
    /// One of these texts.
    OneOf(fn() -> Vec<&'static str>, fn(&mut Draft, &str)),
    /// A whole number, both ends included; without an upper end when that is `None`.
    Whole {
        /// Least.
        min: i64,
        /// Greatest.
        max: Option<i64>,
        /// Sets it.
        set: fn(&mut Draft, i64),
    },
    /// A speed in rev/min, up to `limits.speed`.
    Speed {
        /// Greatest of `limits.speed`.
        max: i64,
        /// Sets it.
        set: fn(&mut Draft, i64),
    },
    /// A number, both ends included; rounded to 0.001, halves away from zero.
    Number {
        /// Least.
        min: Decimal,
        /// Greatest.
        max: Decimal,
        /// Sets it.
        set: fn(&mut Draft, Decimal),
    },
    /// A number, or a table of numbers by axis letter; both ends included.
    Rapid {
        /// Least.
        min: Decimal,
        /// Greatest.
        max: Decimal,
        /// Sets it.
        set: fn(&mut Draft, Rapid),
    },
    /// A value that fits a parameter: ±69999.999, or a whole number of up to eight digits.
    ParameterValue(fn(&mut Draft, Decimal)),
    /// The number of a G function of that group that lasts beyond its block.
    GFunction(GGroup),
    /// The number of an M function. Which group it belongs to depends on the rest of the configuration.
    MFunction,
    /// A number, or its digits as a text.
    Constant(fn(&mut Draft, Written)),
}

/// The texts of a list.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum List {
    /// Paths, relative to the project file's folder.
    Paths,
    /// Extensions of files, without their points.
    Extensions,
    /// Axis letters.
    Letters,
}

impl List {
    /// The text as an element of the list; `None` when it is none.
    pub(super) fn element(self, text: &str) -> Option<&str> {
        match self {
            Self::Paths => Some(text),
            Self::Extensions => {
                let text = text.strip_prefix('.').unwrap_or(text);
                let good = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'-' || byte == b'_';
                (!text.is_empty() && text.bytes().all(good)).then_some(text)
            }
            Self::Letters => AxisLetter::ALL.iter().any(|letter| letter.name() == text).then_some(text),
        }
    }
}

/// A whole number, both ends included.
pub(super) const fn whole(min: i64, max: i64, set: fn(&mut Draft, i64)) -> Takes {
    Takes::Whole { min, max: Some(max), set }
}

/// A number, both ends included, which are thousandths.
pub(super) const fn number(min: i64, max: i64, set: fn(&mut Draft, Decimal)) -> Takes {
    Takes::Number { min: Decimal::from_thousandths(min), max: Decimal::from_thousandths(max), set }
}

/// A word that is one of the names of a type, or of pairs of names and values.
macro_rules! one_of {
    ([$pairs:expr], $set:expr) => {
        Takes::OneOf(
            || $pairs.into_iter().map(|(name, _)| name).collect(),
            |it, text| {
                let set: fn(&mut Draft, _) = $set;
                if let Some((_, value)) = $pairs.into_iter().find(|(name, _)| *name == text) {
                    set(it, value);
                }
            },
        )
    };
    ($type:ident, $set:expr) => {
        one_of!([$type::ALL.map(|value| (value.name(), value))], $set)
    };
}
pub(super) use one_of;

/// The highest M number (§2).
pub(super) const HIGHEST_M: i64 = Dialect::HIGHEST_M as i64;

impl Takes {
    /// The same under these limits: a speed is a whole number up to theirs.
    pub(super) fn under(self, speed: u32) -> Self {
        if let Self::Speed { set, .. } = self { whole(0, speed.into(), set) } else { self }
    }

    /// The description of the range in a message about a wrong value.
    pub(super) fn need(self) -> ConfigNeed {
        match self {
            Self::Flag(_) => ConfigNeed::Flag,
            Self::Path(_) => ConfigNeed::Text,
            Self::Texts(List::Paths, _) => ConfigNeed::Texts,
            Self::Texts(List::Extensions, _) => ConfigNeed::Extensions,
            Self::Texts(List::Letters, _) => ConfigNeed::Letters,
            Self::OneOf(choices, _) => ConfigNeed::OneOf { choices: choices().join(", ") },
            Self::Whole { min, max: Some(max), .. } => ConfigNeed::Whole { min, max },
            Self::Speed { max, .. } => ConfigNeed::Whole { min: 0, max },
            Self::Whole { min, max: None, .. } => ConfigNeed::AtLeast { min },
            Self::Number { min, max, .. } => ConfigNeed::Number { min: min.to_string(), max: max.to_string() },
            Self::Rapid { min, max, .. } => ConfigNeed::NumberOrAxes { min: min.to_string(), max: max.to_string() },
            Self::ParameterValue(_) => ConfigNeed::ParameterValue,
            Self::GFunction(group) => ConfigNeed::GOfGroup { group: group.to_string() },
            Self::MFunction => ConfigNeed::Whole { min: 0, max: HIGHEST_M },
            Self::Constant(_) => ConfigNeed::Constant,
        }
    }

    /// As JSON Schema.
    pub(super) fn schema(self) -> Value {
        match self {
            Self::Flag(_) => json!({ "type": "boolean" }),
            Self::Path(_) => json!({ "type": "string" }),
            Self::Texts(List::Paths, _) => json!({ "type": "array", "items": { "type": "string" } }),
            Self::OneOf(choices, _) => json!({ "enum": choices() }),
            Self::Whole { min, max: Some(max), .. } => json!({ "type": "integer", "minimum": min, "maximum": max }),
            Self::Whole { min, max: None, .. } => json!({ "type": "integer", "minimum": min }),
            Self::Speed { max, set } => whole(0, max, set).schema(),
            Self::Number { min, max, .. } => range(min, max, "number"),
            Self::Rapid { min, max, .. } => {
                let letters: serde_json::Map<String, Value> = AxisLetter::ALL
                    .iter()
                    .map(|letter| (letter.name().to_owned(), range(min, max, "number")))
                    .collect();
                json!({ "anyOf": [
                    range(min, max, "number"),
                    { "type": "object", "properties": letters, "additionalProperties": false },
                ] })
            }
            Self::ParameterValue(_) => json!({ "anyOf": [
                range(Decimal::DIMENSION_MAX.negated(), Decimal::DIMENSION_MAX, "number"),
                range(Decimal::WHOLE_MAX.negated(), Decimal::WHOLE_MAX, "integer"),
            ] }),
            Self::GFunction(group) => {
                json!({ "enum": lasting(group).map(GCode::number).collect::<Vec<_>>() })
            }
            Self::MFunction => json!({ "type": "integer", "minimum": 0, "maximum": HIGHEST_M }),
            Self::Texts(List::Extensions, _) => {
                json!({ "type": "array", "items": { "type": "string", "pattern": "^\\.?[A-Za-z0-9_-]+$" } })
            }
            Self::Texts(List::Letters, _) => {
                json!({ "type": "array", "items": { "enum": AxisLetter::ALL.map(AxisLetter::name) } })
            }
            Self::Constant(_) => json!({ "anyOf": [
                { "type": "number" },
                { "type": "string", "pattern": "^[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)$" },
            ] }),
        }
    }

    /// The values as TOML, where there are few.
    pub(super) fn choices(self) -> Vec<String> {
        if let Self::OneOf(choices, _) = self {
            choices().into_iter().map(|choice| format!("\"{choice}\"")).collect()
        } else if matches!(self, Self::Flag(_)) {
            vec!["true".to_owned(), "false".to_owned()]
        } else {
            Vec::new()
        }
    }

    /// As the reference page says it in `lang`.
    pub(super) fn shown(self, lang: Lang) -> String {
        let text = |en: &str, cs: &str| match lang {
            Lang::En => en.to_owned(),
            Lang::Cs => cs.to_owned(),
        };
        match self {
            Self::Flag(_) => "`true`, `false`".to_owned(),
            Self::Path(_) => text("path", "cesta"),
            Self::Texts(List::Paths, _) => text("list of paths", "seznam cest"),
            Self::OneOf(choices, _) => {
                choices().into_iter().map(|choice| format!("`\"{choice}\"`")).collect::<Vec<_>>().join(", ")
            }
            Self::Whole { min, max: Some(max), .. } => {
                text(&format!("whole number {min}–{max}"), &format!("celé číslo {min}–{max}"))
            }
            Self::Whole { min, max: None, .. } => {
                text(&format!("whole number, {min} or more"), &format!("celé číslo {min} nebo větší"))
            }
            Self::Speed { max, set } => whole(0, max, set).shown(lang),
            Self::Number { min, max, .. } => text(&format!("number {min}–{max}"), &format!("číslo {min}–{max}")),
            Self::Rapid { min, max, .. } => text(
                &format!("number {min}–{max}, or a table of such by axis letter"),
                &format!("číslo {min}–{max}, nebo tabulka takových čísel podle písmen os"),
            ),
            Self::ParameterValue(_) => {
                text("±69999.999, or a whole number up to ±99999999", "±69999.999, nebo celé číslo do ±99999999")
            }
            Self::GFunction(group) => {
                lasting(group).map(|code| format!("`{}`", code.number())).collect::<Vec<_>>().join(", ")
            }
            Self::MFunction => text("number of an M function of this group", "číslo M funkce této skupiny"),
            Self::Texts(List::Extensions, _) => {
                text("list of extensions, as `[\"nc\"]`", "seznam přípon, např. `[\"nc\"]`")
            }
            Self::Texts(List::Letters, _) => {
                text("list of axis letters, as `[\"Z\"]`", "seznam písmen os, např. `[\"Z\"]`")
            }
            Self::Constant(_) => text("number, or digits as a text", "číslo, nebo číslice jako text"),
        }
    }
}

/// The functions of a group that last beyond their block.
pub(super) fn lasting(group: GGroup) -> impl Iterator<Item = GCode> {
    GCode::ALL.iter().copied().filter(move |code| code.group() == group && !matches!(code.lasting(), Lasting::Block))
}

fn range(min: Decimal, max: Decimal, kind: &str) -> Value {
    json!({ "type": kind, "minimum": json_number(min), "maximum": json_number(max) })
}

/// A decimal as JSON writes it, whole numbers without a point; the limits of the language lie far below 2^53
/// thousandths.
pub(super) fn json_number(value: Decimal) -> Value {
    match value.as_whole() {
        Some(whole) => json!(whole),
        None => json!(value.thousandths() as f64 / 1000.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_json() {
        assert_eq!(json_number(Decimal::DIMENSION_MAX).to_string(), "69999.999");
        assert_eq!(json_number(Decimal::WHOLE_MAX.negated()).to_string(), "-99999999");
    }

    /// §7: what may be in force at power-up; none of G4, and of G7 only G70.
    #[test]
    fn lasting_functions() {
        let numbers = |group| lasting(group).map(GCode::number).collect::<Vec<_>>();
        assert_eq!(numbers(GGroup::G0), [0, 1, 2, 3, 33]);
        assert_eq!(numbers(GGroup::G4), [] as [u8; 0]);
        assert_eq!(numbers(GGroup::G7), [70]);
        assert_eq!(numbers(GGroup::G10), [74, 75]);
    }
}
