//! The type and range of a key in the project file: one description for the reader, the schema and the reference page.

use serde_json::{Value, json};

use crate::diag::ConfigNeed;
use crate::dict::{AxisLetter, Decimal, Dialect, GCode, GGroup, Lang, Lasting};

/// The type and range of a value.
#[derive(Clone, Copy, Debug)]
pub enum Takes {
    /// `true` or `false`.
    Flag,
    /// A path, relative to the project file's folder.
    Path,
    /// A list of paths, relative to the project file's folder.
    Paths,
    /// One of these texts.
    OneOf(fn() -> Vec<&'static str>),
    /// A whole number, both ends included; without an upper end when that is `None`.
    Whole {
        /// Least.
        min: i64,
        /// Greatest.
        max: Option<i64>,
    },
    /// A number, both ends included; rounded to 0.001, halves away from zero.
    Number {
        /// Least.
        min: Decimal,
        /// Greatest.
        max: Decimal,
    },
    /// A number, or a table of numbers by axis letter; both ends included.
    NumberOrAxes {
        /// Least.
        min: Decimal,
        /// Greatest.
        max: Decimal,
    },
    /// A value that fits a parameter: ±69999.999, or a whole number of up to eight digits.
    ParameterValue,
    /// The number of a G function of that group that lasts beyond its block.
    GFunction(GGroup),
    /// The number of an M function. Which group it belongs to depends on the rest of the configuration.
    MFunction,
    /// A list of extensions of files, without their points.
    Extensions,
    /// A list of axis letters.
    Letters,
    /// A number, or its digits as a text.
    Constant,
}

impl Takes {
    /// The description of the range in a message about a wrong value.
    pub(super) fn need(self) -> ConfigNeed {
        match self {
            Self::Flag => ConfigNeed::Flag,
            Self::Path => ConfigNeed::Text,
            Self::Paths => ConfigNeed::Texts,
            Self::OneOf(choices) => ConfigNeed::OneOf { choices: choices().join(", ") },
            Self::Whole { min, max: Some(max) } => ConfigNeed::Whole { min, max },
            Self::Whole { min, max: None } => ConfigNeed::AtLeast { min },
            Self::Number { min, max } => ConfigNeed::Number { min: min.to_string(), max: max.to_string() },
            Self::NumberOrAxes { min, max } => ConfigNeed::NumberOrAxes { min: min.to_string(), max: max.to_string() },
            Self::ParameterValue => ConfigNeed::ParameterValue,
            Self::GFunction(group) => ConfigNeed::GOfGroup { group: group.to_string() },
            Self::MFunction => Self::M_NUMBER.need(),
            Self::Extensions => ConfigNeed::Extensions,
            Self::Letters => ConfigNeed::Letters,
            Self::Constant => ConfigNeed::Constant,
        }
    }

    /// Whether the whole number is taken; only of those that take whole numbers alone.
    pub(super) fn holds_whole(self, value: i64) -> bool {
        match self {
            Self::Whole { min, max } => value >= min && max.is_none_or(|max| value <= max),
            Self::MFunction => Self::M_NUMBER.holds_whole(value),
            Self::GFunction(group) => lasting(group).any(|code| i64::from(code.number()) == value),
            Self::Flag
            | Self::Path
            | Self::Paths
            | Self::OneOf(_)
            | Self::Number { .. }
            | Self::NumberOrAxes { .. }
            | Self::ParameterValue
            | Self::Extensions
            | Self::Letters
            | Self::Constant => false,
        }
    }

    /// Whether the number is taken; only of those that take numbers.
    pub(super) fn holds_number(self, value: Decimal) -> bool {
        match self {
            Self::Number { min, max } | Self::NumberOrAxes { min, max } => value >= min && value <= max,
            Self::ParameterValue => value.fits_parameter(),
            Self::Flag
            | Self::Path
            | Self::Paths
            | Self::OneOf(_)
            | Self::Whole { .. }
            | Self::GFunction(_)
            | Self::MFunction
            | Self::Extensions
            | Self::Letters
            | Self::Constant => false,
        }
    }

    /// The range of M numbers (§2).
    const M_NUMBER: Self = Self::Whole { min: 0, max: Some(Dialect::HIGHEST_M as i64) };

    /// As JSON Schema.
    pub(super) fn schema(self) -> Value {
        match self {
            Self::Flag => json!({ "type": "boolean" }),
            Self::Path => json!({ "type": "string" }),
            Self::Paths => json!({ "type": "array", "items": { "type": "string" } }),
            Self::OneOf(choices) => json!({ "enum": choices() }),
            Self::Whole { min, max: Some(max) } => json!({ "type": "integer", "minimum": min, "maximum": max }),
            Self::Whole { min, max: None } => json!({ "type": "integer", "minimum": min }),
            Self::Number { min, max } => range(min, max, "number"),
            Self::NumberOrAxes { min, max } => {
                let letters: serde_json::Map<String, Value> = AxisLetter::ALL
                    .iter()
                    .map(|letter| (letter.name().to_owned(), range(min, max, "number")))
                    .collect();
                json!({ "anyOf": [
                    range(min, max, "number"),
                    { "type": "object", "properties": letters, "additionalProperties": false },
                ] })
            }
            Self::ParameterValue => json!({ "anyOf": [
                range(Decimal::DIMENSION_MAX.negated(), Decimal::DIMENSION_MAX, "number"),
                range(Decimal::WHOLE_MAX.negated(), Decimal::WHOLE_MAX, "integer"),
            ] }),
            Self::GFunction(group) => {
                json!({ "enum": lasting(group).map(GCode::number).collect::<Vec<_>>() })
            }
            Self::MFunction => Self::M_NUMBER.schema(),
            Self::Extensions => {
                json!({ "type": "array", "items": { "type": "string", "pattern": "^\\.?[A-Za-z0-9_-]+$" } })
            }
            Self::Letters => {
                json!({ "type": "array", "items": { "enum": AxisLetter::ALL.map(AxisLetter::name) } })
            }
            Self::Constant => json!({ "anyOf": [
                { "type": "number" },
                { "type": "string", "pattern": "^[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)$" },
            ] }),
        }
    }

    /// The values as TOML, where there are few.
    pub(super) fn choices(self) -> Vec<String> {
        if let Self::OneOf(choices) = self {
            choices().into_iter().map(|choice| format!("\"{choice}\"")).collect()
        } else if matches!(self, Self::Flag) {
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
            Self::Flag => "`true`, `false`".to_owned(),
            Self::Path => text("path", "cesta"),
            Self::Paths => text("list of paths", "seznam cest"),
            Self::OneOf(choices) => {
                choices().into_iter().map(|choice| format!("`\"{choice}\"`")).collect::<Vec<_>>().join(", ")
            }
            Self::Whole { min, max: Some(max) } => {
                text(&format!("whole number {min}–{max}"), &format!("celé číslo {min}–{max}"))
            }
            Self::Whole { min, max: None } => {
                text(&format!("whole number, {min} or more"), &format!("celé číslo {min} nebo větší"))
            }
            Self::Number { min, max } => text(&format!("number {min}–{max}"), &format!("číslo {min}–{max}")),
            Self::NumberOrAxes { min, max } => text(
                &format!("number {min}–{max}, or a table of such by axis letter"),
                &format!("číslo {min}–{max}, nebo tabulka takových čísel podle písmen os"),
            ),
            Self::ParameterValue => {
                text("±69999.999, or a whole number up to ±99999999", "±69999.999, nebo celé číslo do ±99999999")
            }
            Self::GFunction(group) => {
                lasting(group).map(|code| format!("`{}`", code.number())).collect::<Vec<_>>().join(", ")
            }
            Self::MFunction => text("number of an M function of this group", "číslo M funkce této skupiny"),
            Self::Extensions => text("list of extensions, as `[\"nc\"]`", "seznam přípon, např. `[\"nc\"]`"),
            Self::Letters => text("list of axis letters, as `[\"Z\"]`", "seznam písmen os, např. `[\"Z\"]`"),
            Self::Constant => text("number, or digits as a text", "číslo, nebo číslice jako text"),
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

/// A decimal as JSON writes it, whole numbers without a point; the limits of the language lie far below 2^53 thousandths.
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
    fn ranges() {
        let whole = Takes::Whole { min: 1, max: Some(9) };
        assert!(whole.holds_whole(1) && whole.holds_whole(9));
        assert!(!whole.holds_whole(0) && !whole.holds_whole(10) && !whole.holds_number(Decimal::whole(5)));
        assert!(Takes::Whole { min: 1, max: None }.holds_whole(i64::MAX));
        let number = Takes::Number { min: Decimal::ZERO, max: Decimal::whole(1) };
        assert!(number.holds_number(Decimal::whole(1)) && !number.holds_number(Decimal::from_thousandths(1001)));
        assert!(!Takes::Flag.holds_whole(1) && !Takes::Flag.holds_number(Decimal::ZERO));
    }

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
