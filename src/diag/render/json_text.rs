//! JSON that a terminal may get: what it might act on is escaped.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

use crate::text::write_json_safe;

/// Writes `value` in one line.
pub(super) fn write(value: &impl Serialize, mut out: &mut dyn Write) -> io::Result<()> {
    value.serialize(&mut Serializer::with_formatter(&mut out, Safe))?;
    out.write_all(b"\n")
}

struct Safe;

impl Formatter for Safe {
    fn write_string_fragment<W: ?Sized + Write>(&mut self, writer: &mut W, fragment: &str) -> io::Result<()> {
        write_json_safe(writer, fragment)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escaped_and_the_same() {
        let text = "a\u{1b}\u{7f}\u{85}\u{202e}\u{e0041}ř\"\\\n";
        let mut out = Vec::new();
        write(&text, &mut out).unwrap();
        let out = String::from_utf8(out).unwrap();
        assert_eq!(out, "\"a\\u001b\\u007f\\u0085\\u202e\\udb40\\udc41ř\\\"\\\\\\n\"\n");
        assert_eq!(serde_json::from_str::<String>(&out).unwrap(), text);
    }
}
