//! Records as lines of JSON, by the types that their schemas are made of.

use std::io::{self, Write};

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::ser::{Serialize, Serializer};
use serde_json::ser::Formatter;

use super::number::write_real;
use crate::dict::Micro;
use crate::text::write_json_safe;

/// Name and version of the compiler, as records have it.
pub const GENERATOR: &str = concat!("cnc872c ", env!("CARGO_PKG_VERSION"));

/// Appends a record, without a line end. Its numbers have no exponent. With `safe`, characters on which a terminal
/// might act are escaped.
pub fn push(out: &mut Vec<u8>, record: &impl Serialize, safe: bool) {
    let mut serializer = serde_json::Serializer::with_formatter(out, Plain { safe, digits: String::new() });
    // Records of texts and finite numbers have a JSON, and memory takes it.
    let _ = record.serialize(&mut serializer);
}

/// A record as [`push`] writes it.
pub fn text(record: &impl Serialize, safe: bool) -> String {
    let mut out = Vec::new();
    push(&mut out, record, safe);
    String::from_utf8(out).unwrap_or_default()
}

struct Plain {
    safe: bool,
    digits: String,
}

impl Formatter for Plain {
    fn write_f64<W: ?Sized + Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        let rounded = Micro::from_f64(value);
        #[expect(clippy::float_cmp, reason = "whether it has six decimals at most")]
        if rounded.to_f64() != value {
            return write!(writer, "{value}");
        }
        self.digits.clear();
        write_real(rounded.millionths(), &mut self.digits);
        writer.write_all(self.digits.as_bytes())
    }

    fn write_string_fragment<W: ?Sized + Write>(&mut self, writer: &mut W, fragment: &str) -> io::Result<()> {
        if self.safe { write_json_safe(writer, fragment) } else { writer.write_all(fragment.as_bytes()) }
    }
}

/// An object whose fields have an order of their own.
#[derive(Clone, Debug, Default)]
pub struct Pairs<K, V>(pub Vec<(K, V)>);

impl<K, V> Pairs<K, V> {
    /// `None` when there are none: the field is left out.
    pub fn some(pairs: impl IntoIterator<Item = (K, V)>) -> Option<Self> {
        let pairs: Vec<(K, V)> = pairs.into_iter().collect();
        (!pairs.is_empty()).then_some(Self(pairs))
    }
}

impl<K: Serialize, V: Serialize> Serialize for Pairs<K, V> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

impl<K, V: JsonSchema> JsonSchema for Pairs<K, V> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        std::collections::BTreeMap::<String, V>::schema_name()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        std::collections::BTreeMap::<String, V>::json_schema(generator)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_without_exponent() {
        for (value, text_of_it) in [
            (0.0, "0"),
            (1.5, "1.5"),
            (-2.0, "-2"),
            (0.000_001, "0.000001"),
            (1_234_567.891_235, "1234567.891235"),
            (0.333_333_333_333, "0.333333333333"),
            (1e-7, "0.0000001"),
            (666_666_666_667_000.0, "666666666667000"),
        ] {
            assert_eq!(text(&value, false), text_of_it);
        }
    }

    #[test]
    fn texts() {
        let name = "a\u{1b}\u{7f}\u{202e}ř\"\\\n";
        let quoted = text(&name, true);
        assert!(!quoted.chars().any(crate::text::is_unsafe));
        assert_eq!(serde_json::from_str::<String>(&quoted).unwrap(), name);
        assert_eq!(text(&name, false), serde_json::to_string(name).unwrap());
        assert_eq!(text(&Pairs(vec![("b", 1), ("a", 2)]), false), r#"{"b":1,"a":2}"#);
    }
}
