//! Steps as JSON Lines `cnc872c.plc/1`, and the schema of these lines.

use std::collections::BTreeMap;
use std::io::{self, Write};

use schemars::JsonSchema;

use super::dictionary::{Form, Signal};
use super::reader::{Header, Writer};
use super::steps::Step;
use super::values::{Value, push_digits, write_real};
use crate::analysis::record_schema;
use crate::run::End;
use crate::text::is_unsafe;

/// Name and version of the form.
pub const SCHEMA: &str = "cnc872c.plc/1";

/// A line.
#[derive(JsonSchema)]
#[schemars(tag = "kind", rename_all = "lowercase", title = "Record of the signals cnc872c.plc/1")]
#[expect(dead_code, reason = "the schema is all it is for: records are written one by one")]
enum Record {
    /// The first record.
    Plc(PlcRecord),
    /// Before the first step that comes from another file.
    File(FileRecord),
    /// One executed block, or the stop after it.
    Step(StepRecord),
    /// The last record: the program ended without errors.
    End(EndRecord),
}

/// What the steps are of.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct PlcRecord {
    /// `cnc872c.plc/1`.
    #[schemars(extend("const" = SCHEMA))]
    schema: String,
    /// Name and version of the compiler.
    generator: String,
    /// The program, as the user named it; its index is 0.
    name: String,
    /// The control.
    #[schemars(extend("enum" = ["cnc8x6", "cnc8x9", "cnc872"]))]
    dialect: String,
    /// The chosen signals, in the order of the dictionary.
    signals: Vec<String>,
}

/// Another file.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct FileRecord {
    /// 1, 2 …
    index: u32,
    /// The macrocycle's path as found.
    name: String,
}

/// A step.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct StepRecord {
    /// `seq` of the block.
    seq: u64,
    /// Block number.
    n: u32,
    /// Index of the file.
    file: u32,
    /// Line of the `N`, from 1.
    line: u32,
    /// When it starts, in seconds; with `[motion]`.
    start_s: Option<f64>,
    /// The program stands at the M00 or M01 of this block (PLC-16); else left out.
    stop: Option<bool>,
    /// Values by name: of all chosen signals in the first step, after that of those that changed. Absent is `null`; bits are
    /// 0 and 1.
    signals: BTreeMap<String, Option<f64>>,
}

/// The end.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
#[expect(dead_code, reason = "as above")]
struct EndRecord {
    /// The function that ends the program.
    #[schemars(extend("enum" = ["M02", "M30"]))]
    reason: String,
    /// Executed blocks of the program, all of them.
    blocks: u64,
}

/// The schema of a line, JSON Schema 2020-12.
pub fn schema() -> serde_json::Value {
    record_schema::<Record>(SCHEMA)
}

/// JSON Lines.
#[derive(Debug)]
pub struct Json<W> {
    out: W,
    signals: Vec<&'static Signal>,
    begun: bool,
    line: String,
}

impl<W: Write> Json<W> {
    /// Writes to `out`.
    pub const fn new(out: W) -> Self {
        Self { out, signals: Vec::new(), begun: false, line: String::new() }
    }

    fn push(&mut self, index: usize, value: Value) {
        let Some(signal) = self.signals.get(index) else { return };
        if !self.line.ends_with('{') {
            self.line.push(',');
        }
        // Names need no escapes.
        self.line.push('"');
        self.line.push_str(&signal.name);
        self.line.push_str("\":");
        match value {
            None => self.line.push_str("null"),
            Some(number) if signal.form() == Form::Real => write_real(number, &mut self.line),
            Some(number) => push_digits(number.unsigned_abs(), 1, &mut self.line),
        }
    }
}

/// A text as a string of JSON; what a terminal might act on is escaped.
fn string(text: &str) -> String {
    let quoted = serde_json::Value::from(text).to_string();
    let mut safe = String::with_capacity(quoted.len());
    for character in quoted.chars() {
        if is_unsafe(character) {
            for unit in character.encode_utf16(&mut [0; 2]) {
                safe.push_str(&format!("\\u{unit:04x}"));
            }
        } else {
            safe.push(character);
        }
    }
    safe
}

/// The first record.
pub(crate) fn header_text(header: &Header<'_>) -> String {
    let signals: Vec<String> = header.signals.iter().map(|signal| format!("\"{}\"", signal.name)).collect();
    format!(
        "{{\"kind\":\"plc\",\"schema\":\"{SCHEMA}\",\"generator\":\"{}\",\"name\":{},\"dialect\":\"{}\",\"signals\":[{}]}}",
        concat!("cnc872c ", env!("CARGO_PKG_VERSION")),
        string(header.name),
        header.settings.machine.dialect.name(),
        signals.join(",")
    )
}

/// The record of another file.
pub(crate) fn file_text(index: u32, name: &str) -> String {
    format!("{{\"kind\":\"file\",\"index\":{index},\"name\":{}}}", string(name))
}

/// The last record.
pub(crate) fn end_text(end: End) -> String {
    format!("{{\"kind\":\"end\",\"reason\":\"{}\",\"blocks\":{}}}", end.reason(), end.blocks())
}

impl<W: Write> Writer for Json<W> {
    fn begin(&mut self, header: &Header<'_>) -> io::Result<()> {
        self.signals = header.signals.to_vec();
        writeln!(self.out, "{}", header_text(header))
    }

    fn file(&mut self, index: u32, name: &str) -> io::Result<()> {
        writeln!(self.out, "{}", file_text(index, name))
    }

    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        let place = step.place;
        self.line = format!(
            "{{\"kind\":\"step\",\"seq\":{},\"n\":{},\"file\":{},\"line\":{}",
            place.seq, place.n, place.file, place.line
        );
        if let Some(start) = step.start_s {
            self.line.push_str(",\"start_s\":");
            write_real(start.millionths(), &mut self.line);
        }
        if place.stop {
            self.line.push_str(",\"stop\":true");
        }
        self.line.push_str(",\"signals\":{");
        if self.begun {
            for &index in step.changed {
                self.push(index, step.values.get(index).copied().flatten());
            }
        } else {
            for (index, value) in step.values.iter().enumerate() {
                self.push(index, *value);
            }
        }
        self.begun = true;
        self.line.push_str("}}\n");
        self.out.write_all(self.line.as_bytes())
    }

    fn end(&mut self, end: End) -> io::Result<()> {
        writeln!(self.out, "{}", end_text(end))?;
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_and_numbers() {
        let text = "a\u{1b}\u{7f}\u{202e}ř\"\\\n";
        let quoted = string(text);
        assert!(!quoted.chars().any(is_unsafe));
        assert_eq!(serde_json::from_str::<String>(&quoted).unwrap(), text);
        for number in [0, 9, 10, 4_294_967_295, u64::MAX] {
            let mut digits = String::new();
            push_digits(number, 1, &mut digits);
            assert_eq!(digits, number.to_string());
        }
    }
}
