//! Steps as JSON Lines `cnc872c.plc/1`, and the schema of these lines.

use std::collections::BTreeMap;
use std::io::{self, Write};

use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use super::dictionary::{Form, Signal};
use super::reader::{Header, Writer};
use super::steps::{Place, Step};
use super::values::Value;
use crate::analysis::json::{GENERATOR, push, text};
use crate::analysis::{Number, record_schema};
use crate::dict::Micro;
use crate::run::End;

/// Name and version of the form.
pub const SCHEMA: &str = "cnc872c.plc/1";

/// A line.
#[derive(JsonSchema, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
#[schemars(title = "Record of the signals cnc872c.plc/1")]
enum Record<'a> {
    /// The first record.
    Plc(&'a PlcRecord<'a>),
    /// Before the first step that comes from another file.
    File(&'a FileRecord<'a>),
    /// One executed block, or the stop after it.
    Step(&'a StepRecord<'a>),
    /// The last record: the program ended without errors.
    End(&'a EndRecord<'a>),
}

/// The program and signals of the steps.
#[derive(JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
struct PlcRecord<'a> {
    /// `cnc872c.plc/1`.
    #[schemars(extend("const" = SCHEMA))]
    schema: &'a str,
    /// Name and version of the compiler.
    generator: &'a str,
    /// The program, as the user named it; its index is 0.
    name: &'a str,
    /// The control.
    #[schemars(extend("enum" = ["cnc8x6", "cnc8x9", "cnc872"]))]
    dialect: &'a str,
    /// The chosen signals, in the order of the dictionary.
    signals: Vec<&'a str>,
}

/// Another file.
#[derive(JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
struct FileRecord<'a> {
    /// 1, 2 …
    index: u32,
    /// The macrocycle's path as found.
    name: &'a str,
}

/// A step.
#[derive(JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
struct StepRecord<'a> {
    /// `seq` of the block.
    seq: u64,
    /// Block number.
    n: u32,
    /// Index of the file.
    file: u32,
    /// Line of the `N`, from 1.
    line: u32,
    /// When it starts, in seconds; with `[motion]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    start_s: Option<Number>,
    /// The program waits at the M00 or M01 of this block (PLC-16); else left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    stop: Option<bool>,
    /// Values by name: of all chosen signals in the first step, after that of those that changed. Absent is `null`;
    /// bits are 0 and 1.
    #[schemars(with = "BTreeMap<String, Option<f64>>")]
    signals: Values<'a>,
}

/// The end.
#[derive(JsonSchema, Serialize)]
#[schemars(deny_unknown_fields)]
struct EndRecord<'a> {
    /// The function that ends the program.
    #[schemars(extend("enum" = ["M02", "M30"]))]
    reason: &'a str,
    /// Executed blocks of the program, all of them.
    blocks: u64,
}

/// Values of signals by name.
struct Values<'a> {
    signals: &'a [&'static Signal],
    step: &'a Step<'a>,
    /// Of all signals, not only of those that changed.
    all: bool,
}

impl Serialize for Values<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { signals, step, all } = *self;
        let value = |index: usize| {
            let signal = signals.get(index)?;
            Some((signal.name.as_str(), Shown { value: *step.values.get(index)?, form: signal.form() }))
        };
        if all {
            serializer.collect_map((0..step.values.len()).filter_map(value))
        } else {
            serializer.collect_map(step.changed.iter().filter_map(|index| value(*index)))
        }
    }
}

/// A value of a signal.
struct Shown {
    value: Value,
    form: Form,
}

impl Serialize for Shown {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.value {
            None => serializer.serialize_none(),
            Some(number) if self.form == Form::Real => Number(Micro::from_millionths(number)).serialize(serializer),
            Some(number) => serializer.serialize_u64(number.unsigned_abs()),
        }
    }
}

/// The schema of a line, JSON Schema 2020-12.
pub fn schema() -> serde_json::Value {
    record_schema::<Record<'_>>(SCHEMA)
}

/// JSON Lines.
#[derive(Debug)]
pub struct Json<W> {
    out: W,
    signals: Vec<&'static Signal>,
    begun: bool,
    line: Vec<u8>,
}

impl<W: Write> Json<W> {
    /// Writes to `out`.
    pub const fn new(out: W) -> Self {
        Self { out, signals: Vec::new(), begun: false, line: Vec::new() }
    }
}

/// The first record.
pub(crate) fn header_text(header: &Header<'_>) -> String {
    let record = PlcRecord {
        schema: SCHEMA,
        generator: GENERATOR,
        name: header.name,
        dialect: header.settings.machine.dialect.name(),
        signals: header.signals.iter().map(|signal| signal.name.as_str()).collect(),
    };
    text(&Record::Plc(&record), true)
}

/// The record of another file.
pub(crate) fn file_text(index: u32, name: &str) -> String {
    text(&Record::File(&FileRecord { index, name }), true)
}

/// The last record.
pub(crate) fn end_text(end: End) -> String {
    text(&Record::End(&EndRecord { reason: &end.reason(), blocks: end.blocks() }), true)
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
        let Place { seq, n, file, line, column: _, stop } = step.place;
        let all = !std::mem::replace(&mut self.begun, true);
        let signals = Values { signals: &self.signals, step, all };
        let start_s = step.start_s.map(Number);
        let record = StepRecord { seq, n, file, line, start_s, stop: stop.then_some(true), signals };
        self.line.clear();
        push(&mut self.line, &Record::Step(&record), true);
        self.line.push(b'\n');
        self.out.write_all(&self.line)
    }

    fn end(&mut self, end: End) -> io::Result<()> {
        writeln!(self.out, "{}", end_text(end))?;
        self.out.flush()
    }
}
