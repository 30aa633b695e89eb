//! The block stream against the rules: small programs, and the records that the specification gives for them.

mod data;
mod flow;
mod functions;
mod motion;
mod output;
mod parameters;
mod ways;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

use cnc872c::config::{configure, find_project};
use cnc872c::diag::{Findings, Severity};
use cnc872c::session::{Part, Session};
use cnc872c::text::{MemoryLoader, Sources};
use proptest::prelude::*;
use serde_json::{Value, json};

use crate::json_schema::{Validator, validator_for};
use crate::markers::options;

static SCHEMA: LazyLock<Validator> = LazyLock::new(|| validator_for(&cnc872c::stream::schema()));

/// A program with the other files of its folder, ready to be compiled.
#[derive(Clone, Debug, Default)]
struct Case {
    program: Vec<u8>,
    files: BTreeMap<String, String>,
    args: String,
    part: Part,
}

/// The result of a run.
#[derive(Debug)]
struct Stream {
    text: String,
    records: Vec<Value>,
    codes: Vec<String>,
    errors: Vec<String>,
}

fn case(program: &str) -> Case {
    Case { program: program.as_bytes().to_vec(), ..Case::default() }
}

impl Case {
    fn with(mut self, name: &str, text: &str) -> Self {
        self.files.insert(name.to_owned(), text.to_owned());
        self
    }

    fn config(self, text: &str) -> Self {
        self.with("cnc872c.toml", text)
    }

    fn args(mut self, args: &str) -> Self {
        args.clone_into(&mut self.args);
        self
    }

    fn run(&self) -> Stream {
        let mut loader = MemoryLoader::new().with("P.NC", self.program.clone());
        for (name, text) in &self.files {
            loader = loader.with(name, text.as_bytes());
        }
        let mut overrides = cnc872c::config::Overrides::default();
        options(&mut overrides, &self.args);
        let project = find_project(Path::new(""), &loader);
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let settings = configure(project.as_deref(), &overrides, &loader, &mut sources, &mut findings);
        assert!(findings.items().is_empty(), "the configuration: {:?}", findings.items());
        let session = Session { loader: &loader, settings: &settings, progress: None };
        let mut out = Vec::new();
        let outcome = session.compile(Path::new("P.NC"), "P.NC", self.part, &mut out).expect("memory").outcome;
        let text = String::from_utf8(out).expect("UTF-8");
        let records: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).expect(line)).collect();
        for record in &records {
            assert!(SCHEMA.is_valid(record), "not in the schema: {record}");
        }
        let (mut codes, mut errors) = (Vec::new(), Vec::new());
        for found in outcome.findings.items() {
            let code = found.code().to_string();
            if outcome.findings.levels().of(found.code()) == Some(Severity::Error) {
                errors.push(code.clone());
            }
            codes.push(code);
        }
        codes.sort();
        Stream { text, records, codes, errors }
    }

    /// The records of a program without errors.
    fn whole(&self) -> Stream {
        let stream = self.run();
        assert!(stream.errors.is_empty(), "{:?}", stream.errors);
        assert_eq!(stream.records.last().expect("records")["kind"], "end");
        stream
    }

    /// The block records of a program without errors.
    fn blocks(&self) -> Vec<Value> {
        self.whole().blocks()
    }
}

impl Stream {
    fn of(&self, kind: &str) -> Vec<Value> {
        self.records.iter().filter(|record| record["kind"] == kind).cloned().collect()
    }

    /// The block records without what follows from others: where a motion starts, why it has no length, what the feed
    /// counts. `ways.rs` is about these.
    fn blocks(&self) -> Vec<Value> {
        let mut blocks = self.of("block");
        for block in &mut blocks {
            block.as_object_mut().expect("an object").remove("feed_unit");
            if let Some(motion) = block.get_mut("motion").and_then(Value::as_object_mut) {
                motion.remove("start");
                motion.remove("length_missing");
            }
            for call in block.get_mut("calls").and_then(Value::as_array_mut).into_iter().flatten() {
                call.as_object_mut().expect("an object").remove("line");
            }
        }
        blocks
    }

    fn end(&self) -> Value {
        self.records.last().expect("records").clone()
    }
}

fn blocks(program: &str) -> Vec<Value> {
    case(program).blocks()
}

/// Asserts the named fields of a record; `null` means that the field is left out.
#[track_caller]
fn assert_fields(record: &Value, expected: &Value) {
    for (name, value) in expected.as_object().expect("an object") {
        let found = record.get(name);
        if value.is_null() {
            assert_eq!(found, None, "`{name}` of {record}");
        } else {
            assert_eq!(found, Some(value), "`{name}` of {record}");
        }
    }
}

/// The one block with this number, and fields that it has.
#[track_caller]
fn assert_block(blocks: &[Value], n: u32, expected: &Value) {
    let found: Vec<&Value> = blocks.iter().filter(|block| block["n"] == n).collect();
    assert_eq!(found.len(), 1, "blocks N{n}");
    assert_fields(found[0], expected);
}

/// One field of every block, `null` where it is left out.
fn column(blocks: &[Value], name: &str) -> Value {
    blocks.iter().map(|block| block.get(name).cloned().unwrap_or(Value::Null)).collect()
}

/// One entry of an array in every block.
fn entries(blocks: &[Value], name: &str, index: usize) -> Value {
    blocks.iter().map(|block| block[name][index].clone()).collect()
}

/// Lengths of the motions.
fn lengths(blocks: &[Value]) -> Value {
    blocks.iter().map(|block| block["motion"]["length_mm"].clone()).collect()
}

const NULL: Value = Value::Null;

/// Blocks after `N1 F100 S100` and a start at zero, with the records of the blocks behind those two.
fn from_zero(config: &str, lines: &str) -> Vec<Value> {
    let program = format!("%1\nN1 F100 S100\nN2 G00 X0 Y0 Z0\n{lines}\nN9999 M30");
    let mut found = case(&program).config(config).blocks();
    found.drain(..2);
    found.pop();
    found
}

const OPERATIONS: &str = "[operations]\n\"01\" = \"add\"\n\"02\" = \"sub\"\n\"03\" = \"mul\"\n\"04\" = \"div\"\n\
    \"05\" = \"neg\"\n\"06\" = \"abs\"\n\"07\" = \"sqrt\"\n\"08\" = \"sin\"\n\"09\" = \"cos\"\n\"10\" = \"tan\"\n\
    \"11\" = \"asin\"\n\"12\" = \"acos\"\n\"13\" = \"atan\"\n\"14\" = \"atan2\"\n\"15\" = \"mod\"\n\"16\" = \"min\"\n\
    \"17\" = \"max\"\n\"18\" = \"round\"\n\"19\" = \"trunc\"\n\"20\" = \"copy\"\n";

const GEARS: &str = "[[gears]]\nm = 41\nmin = 20\nmax = 500\n[[gears]]\nm = 42\nmin = 400\nmax = 2000\n";

const CYCLES: &str = "[cycles]\nG81 = 8100\nG82 = 8200\n";
