//! JSON Schema as far as our schemas and that of SARIF use it, so that tests look at every record without a library
//! that takes a tenth of their build. A keyword that is not known here stops the test.

use std::collections::BTreeMap;

use regex_lite::Regex;
use serde_json::{Map, Value};

/// A schema whose references and patterns are known.
pub struct Validator {
    root: Value,
    patterns: BTreeMap<String, Regex>,
}

/// Keywords that say nothing about a value.
const REMARKS: [&str; 8] = ["$schema", "$id", "$defs", "definitions", "title", "description", "default", "examples"];

/// # Panics
/// When the schema has a keyword or a form of one that is not known here, a reference that leads nowhere, a wrong
/// pattern.
#[track_caller]
pub fn validator_for(schema: &Value) -> Validator {
    let mut validator = Validator { root: schema.clone(), patterns: BTreeMap::new() };
    let mut patterns = Vec::new();
    check(&validator, schema, &mut patterns);
    validator.patterns = patterns.into_iter().map(|pattern| (pattern.clone(), Regex::new(&pattern).unwrap())).collect();
    validator
}

/// Looks at the form of a schema, so that nothing in it is passed over in silence.
fn check(validator: &Validator, schema: &Value, patterns: &mut Vec<String>) {
    let Some(schema) = schema.as_object() else {
        assert!(schema.is_boolean(), "no schema: {schema}");
        return;
    };
    for (keyword, value) in schema {
        let mut each =
            |values: &mut dyn Iterator<Item = &Value>| values.for_each(|value| check(validator, value, patterns));
        match keyword.as_str() {
            "$defs" | "definitions" | "properties" | "patternProperties" => {
                each(&mut value.as_object().unwrap().values());
                if keyword == "patternProperties" {
                    patterns.extend(value.as_object().unwrap().keys().cloned());
                }
            }
            "anyOf" | "oneOf" => each(&mut value.as_array().unwrap().iter()),
            "items" | "additionalProperties" => each(&mut [value].into_iter()),
            "pattern" => patterns.push(value.as_str().unwrap().to_owned()),
            "$ref" => assert!(validator.target(value).is_some(), "{value}"),
            "enum" | "required" => assert!(value.is_array(), "{value}"),
            "minItems" | "maxItems" => assert!(value.is_u64(), "{value}"),
            "minimum" | "maximum" => assert!(value.is_number(), "{value}"),
            "uniqueItems" => assert!(value.is_boolean(), "{value}"),
            "type" => assert!(types(value).all(|name| TYPES.contains(&name)), "{value}"),
            "format" => assert!(FORMATS.contains(&value.as_str().unwrap()), "{value}"),
            "const" => {}
            remark => assert!(REMARKS.contains(&remark), "unknown keyword {remark}"),
        }
    }
}

const TYPES: [&str; 7] = ["null", "boolean", "object", "array", "number", "string", "integer"];
/// Those of numbers only remark what `type`, `minimum` and `maximum` say.
const FORMATS: [&str; 8] = ["uint", "uint8", "uint32", "uint64", "double", "date-time", "uri", "uri-reference"];

fn types(value: &Value) -> impl Iterator<Item = &str> {
    let list = value.as_array().map_or(std::slice::from_ref(value), Vec::as_slice);
    list.iter().map(|name| name.as_str().unwrap())
}

impl Validator {
    /// Whether the value fits.
    pub fn is_valid(&self, value: &Value) -> bool {
        self.validate(value).is_ok()
    }

    /// # Errors
    /// The first thing wrong with the value, behind its path.
    pub fn validate(&self, value: &Value) -> Result<(), String> {
        self.look(&self.root, value)
    }

    fn target(&self, reference: &Value) -> Option<&Value> {
        self.root.pointer(reference.as_str()?.strip_prefix('#')?)
    }

    fn look(&self, schema: &Value, value: &Value) -> Result<(), String> {
        let Some(schema) = schema.as_object() else {
            return if schema == true { Ok(()) } else { Err(": is not known".to_owned()) };
        };
        if let Some(target) = schema.get("$ref").and_then(|reference| self.target(reference)) {
            self.look(target, value)?;
        }
        if let Some((keyword, _)) = schema.iter().find(|(keyword, rule)| !self.follows(keyword, rule, value)) {
            return Err(format!(": does not follow `{keyword}`"));
        }
        for (name, member) in value.as_object().into_iter().flatten() {
            self.look_at_member(schema, name, member).map_err(|error| format!("/{name}{error}"))?;
        }
        if let (Some(list), Some(items)) = (value.as_array(), schema.get("items")) {
            for (at, item) in list.iter().enumerate() {
                self.look(items, item).map_err(|error| format!("/{at}{error}"))?;
            }
        }
        Ok(())
    }

    fn look_at_member(&self, schema: &Map<String, Value>, name: &str, member: &Value) -> Result<(), String> {
        let all = |keyword: &str| schema.get(keyword).and_then(Value::as_object);
        let own = all("properties").and_then(|properties| properties.get(name));
        let by_pattern = all("patternProperties").into_iter().flatten();
        let by_pattern = by_pattern.filter(|(pattern, _)| self.patterns[*pattern].is_match(name));
        let schemas: Vec<_> = own.into_iter().chain(by_pattern.map(|(_, schema)| schema)).collect();
        let others = schema.get("additionalProperties").filter(|_| schemas.is_empty());
        schemas.into_iter().chain(others).try_for_each(|schema| self.look(schema, member))
    }

    /// Whether a value follows a keyword, but for those about its members, which [`Self::look`] looks at.
    fn follows(&self, keyword: &str, rule: &Value, value: &Value) -> bool {
        let fitting =
            || rule.as_array().into_iter().flatten().filter(|schema| self.look(schema, value).is_ok()).count();
        let bound = || rule.as_u64().unwrap();
        let length = value.as_array().map(|list| list.len() as u64);
        match keyword {
            "type" => types(rule).any(|name| is_of_type(name, value)),
            "const" => same(rule, value),
            "enum" => rule.as_array().unwrap().iter().any(|choice| same(choice, value)),
            "anyOf" => fitting() > 0,
            "oneOf" => fitting() == 1,
            "required" => value.as_object().is_none_or(|object| {
                rule.as_array().unwrap().iter().all(|name| object.contains_key(name.as_str().unwrap()))
            }),
            "minItems" => length.is_none_or(|length| length >= bound()),
            "maxItems" => length.is_none_or(|length| length <= bound()),
            "uniqueItems" => {
                let list = value.as_array().map_or(&[][..], Vec::as_slice);
                rule == false || list.iter().enumerate().all(|(at, item)| !list[..at].contains(item))
            }
            "minimum" => value.as_f64().is_none_or(|number| number >= rule.as_f64().unwrap()),
            "maximum" => value.as_f64().is_none_or(|number| number <= rule.as_f64().unwrap()),
            "pattern" => value.as_str().is_none_or(|text| self.patterns[rule.as_str().unwrap()].is_match(text)),
            "format" if ["uri", "uri-reference"].contains(&rule.as_str().unwrap()) => value.as_str().is_none_or(is_uri),
            // Remarks, and what is followed elsewhere; `validator_for` has refused all others.
            _ => true,
        }
    }
}

fn is_of_type(name: &str, value: &Value) -> bool {
    match name {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "object" => value.is_object(),
        "array" => value.is_array(),
        "number" => value.is_number(),
        "string" => value.is_string(),
        _ => value.as_f64().is_some_and(|number| number.fract() == 0.0),
    }
}

/// Numbers are equal by value: 1 is 1.0.
fn same(one: &Value, other: &Value) -> bool {
    one == other || one.as_f64().is_some_and(|number| other.as_f64() == Some(number))
}

/// Characters of a URI, and `%` with two digits.
fn is_uri(text: &str) -> bool {
    let allowed = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~:/?#[]@!$&'()*+,;=%".contains(&byte);
    let escaped = text
        .split('%')
        .skip(1)
        .all(|rest| rest.len() >= 2 && rest.bytes().take(2).all(|byte| byte.is_ascii_hexdigit()));
    escaped && text.bytes().all(allowed)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// Each keyword takes the first values and refuses the second ones.
    #[test]
    fn keywords() {
        for (schema, right, wrong) in [
            (json!({"type": "integer"}), vec![json!(1), json!(1.0)], vec![json!(1.5), json!("1")]),
            (json!({"type": ["string", "null"]}), vec![json!("a"), json!(null)], vec![json!(true), json!([])]),
            (json!({"const": 1}), vec![json!(1), json!(1.0)], vec![json!(2), json!("1")]),
            (json!({"enum": ["a", 7]}), vec![json!("a"), json!(7)], vec![json!("b"), json!(8)]),
            (
                json!({"minimum": 0, "maximum": 2.5}),
                vec![json!(0), json!(2.5), json!("x")],
                vec![json!(-1), json!(2.6)],
            ),
            (json!({"minItems": 1, "maxItems": 2}), vec![json!([1]), json!([1, 2])], vec![json!([]), json!([1, 2, 3])]),
            (json!({"uniqueItems": true}), vec![json!([1, 2])], vec![json!([1, 2, 1])]),
            (json!({"items": {"type": "string"}}), vec![json!(["a"]), json!([])], vec![json!(["a", 1])]),
            (json!({"pattern": "^a+$"}), vec![json!("aa"), json!(1)], vec![json!("ab")]),
            (json!({"format": "uri"}), vec![json!("a/%1B")], vec![json!("a b"), json!("%1"), json!("č")]),
            (json!({"required": ["a"]}), vec![json!({"a": 1})], vec![json!({"b": 1})]),
            (
                json!({"properties": {"a": {"type": "null"}}, "additionalProperties": false}),
                vec![json!({"a": null}), json!({})],
                vec![json!({"a": 1}), json!({"b": 1})],
            ),
            (
                json!({"patternProperties": {"^R[0-9]$": {"type": "number"}}, "additionalProperties": {"const": "x"}}),
                vec![json!({"R1": 1}), json!({"b": "x"})],
                vec![json!({"R1": "x"}), json!({"b": 1})],
            ),
            (json!({"anyOf": [{"type": "string"}, {"minimum": 5}]}), vec![json!("a"), json!(6)], vec![json!(4)]),
            (json!({"oneOf": [{"minimum": 1}, {"maximum": 3}]}), vec![json!(0), json!(4)], vec![json!(2)]),
            (
                json!({"$ref": "#/$defs/t", "$defs": {"t": {"items": {"$ref": "#/$defs/t"}, "type": "array"}}}),
                vec![json!([[], [[]]])],
                vec![json!([[1]]), json!(1)],
            ),
        ] {
            let validator = validator_for(&schema);
            for value in &right {
                assert_eq!(validator.validate(value), Ok(()), "{schema}");
            }
            for value in &wrong {
                assert!(!validator.is_valid(value), "{schema} {value}");
            }
        }
    }

    #[test]
    fn what_is_not_known_stops() {
        for schema in
            [json!({"not": {}}), json!({"$ref": "#/$defs/a"}), json!({"type": "text"}), json!({"minItems": "a"})]
        {
            let found = std::panic::catch_unwind(|| validator_for(&schema).is_valid(&json!(1)));
            assert!(found.is_err(), "{schema}");
        }
    }
}
