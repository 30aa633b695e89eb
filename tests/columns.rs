//! Columns: what they hold is what the records of the same stream say, over all samples.

#![expect(
    clippy::wildcard_enum_match_arm,
    clippy::if_same_then_else,
    reason = "a column of another type fails the test"
)]
#![expect(clippy::disallowed_methods, reason = "tests read files")]
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

#[path = "it/disk.rs"]
mod disk;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int8Type, UInt8Type, UInt32Type, UInt64Type};
use arrow_array::{Array, RecordBatch};
use arrow_ipc::reader::StreamReader;
use arrow_schema::{DataType, Schema};
use cnc872c::analysis::motion::{Basis, machine, total, write_block};
use cnc872c::analysis::plc::{self, Json, Reader};
use cnc872c::columns::{BlockTable, Ipc, Kept, MotionTable, PROGRAM, StepTable};
use cnc872c::config::{Overrides, Purpose, Settings, configure, find_project};
use cnc872c::diag::Findings;
use cnc872c::session::{Part, Session, TimedSink, Times};
use cnc872c::text::{Loader, Sources};
use serde_json::{Map, Value, json};

use crate::disk::{TestDisk, files};

/// A cell as JSON. Whole numbers are whole.
fn cell(array: &dyn Array, row: usize) -> Value {
    if array.is_null(row) {
        return Value::Null;
    }
    let list = |items: Arc<dyn Array>| (0..items.len()).map(|at| cell(&items, at)).collect::<Vec<_>>();
    match array.data_type() {
        DataType::UInt8 => array.as_primitive::<UInt8Type>().value(row).into(),
        DataType::UInt32 => array.as_primitive::<UInt32Type>().value(row).into(),
        DataType::UInt64 => array.as_primitive::<UInt64Type>().value(row).into(),
        DataType::Float64 => number(array.as_primitive::<Float64Type>().value(row)),
        DataType::Boolean => array.as_boolean().value(row).into(),
        DataType::Utf8 => array.as_string::<i32>().value(row).into(),
        DataType::Dictionary(..) => {
            let names = array.as_dictionary::<Int8Type>();
            cell(names.values(), names.keys().value(row) as usize)
        }
        DataType::List(_) => list(array.as_list::<i32>().value(row)).into(),
        DataType::FixedSizeList(..) => list(array.as_fixed_size_list().value(row)).into(),
        DataType::Map(..) => {
            let entries = array.as_map().value(row);
            let pairs = (0..entries.len()).map(|at| {
                let key = cell(entries.column(0), at);
                (key.as_str().unwrap().to_owned(), cell(entries.column(1), at))
            });
            Value::Object(pairs.collect())
        }
        DataType::Struct(fields) => {
            let columns = fields.iter().zip(array.as_struct().columns());
            columns.map(|(field, column)| (field.name().clone(), cell(column, row))).collect::<Map<_, _>>().into()
        }
        other => panic!("{other} is no type of a column"),
    }
}

fn number(value: f64) -> Value {
    if value.fract() == 0.0 && value.abs() < 9e15 { json!(value as i64) } else { json!(value) }
}

/// Numbers of records in the same form.
fn plain(value: &Value) -> Value {
    match value {
        Value::Number(number) if number.is_f64() => self::number(number.as_f64().unwrap()),
        Value::Array(items) => items.iter().map(plain).collect(),
        Value::Object(fields) => {
            fields.iter().map(|(key, value)| (key.clone(), plain(value))).collect::<Map<_, _>>().into()
        }
        other => other.clone(),
    }
}

/// The path of a column's value in a record: `motion_start_x` is `motion`, `start`, `X`.
fn path(name: &str) -> Vec<String> {
    let axis = |name: &str| name.len() == 1 && "xyzabcuvw".contains(name);
    if axis(name) {
        return vec!["position".to_owned(), name.to_uppercase()];
    }
    for (prefix, inner) in [("motion_", true), ("jump_", false), ("data_", false), ("joint_", false)] {
        let Some(rest) = name.strip_prefix(prefix) else { continue };
        let outer = prefix.trim_end_matches('_').to_owned();
        return match rest.split_once('_') {
            Some((map, letter)) if inner && axis(letter) => vec![outer, map.to_owned(), letter.to_uppercase()],
            _ => vec![outer, rest.to_owned()],
        };
    }
    vec![name.to_owned()]
}

/// Rows as records again. What is null or false is left out, as in records; `kept` are fields that never are.
fn records(batches: &[RecordBatch], path: impl Fn(&str) -> Vec<String>, kept: &[&str]) -> Vec<Value> {
    let mut records = Vec::new();
    for batch in batches {
        for row in 0..batch.num_rows() {
            let mut record = json!({});
            for (field, column) in batch.schema().fields().iter().zip(batch.columns()) {
                let value = cell(column, row);
                if (value.is_null() || value == false) && !kept.contains(&field.name().as_str()) {
                    continue;
                }
                path(field.name()).into_iter().fold(&mut record, |inner, key| &mut inner[key]).clone_from(&value);
            }
            records.push(record);
        }
    }
    records
}

/// Every sample that may be a whole program, with its folder and its settings.
fn samples() -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    for folder in ["ok", "projects", "rules", "err"] {
        for path in files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("samples").join(folder)) {
            if path.extension().is_some_and(|extension| extension == "nc") && !Session::is_macrocycle_name(&path) {
                let name = path.file_name().unwrap().to_str().unwrap().to_owned();
                found.push((path.parent().unwrap().to_path_buf(), name));
            }
        }
    }
    assert!(found.len() > 100, "the samples are gone");
    found
}

fn settings(loader: &dyn Loader) -> Settings {
    let project = find_project(Path::new(""), loader);
    configure(project.as_deref(), &Overrides::default(), loader, &mut Sources::new(), &mut Findings::new())
}

fn read(bytes: &[u8]) -> (Arc<Schema>, Vec<RecordBatch>) {
    let reader = StreamReader::try_new(bytes, None).unwrap();
    (reader.schema(), reader.map(Result::unwrap).collect())
}

fn lines(text: &[u8]) -> Vec<Value> {
    std::str::from_utf8(text).unwrap().lines().map(|line| plain(&serde_json::from_str(line).unwrap())).collect()
}

/// The records of that kind, without it.
fn of_kind(records: &[Value], kind: &str) -> Vec<Value> {
    let mut found: Vec<Value> = records.iter().filter(|record| record["kind"] == kind).cloned().collect();
    found.iter_mut().for_each(|record| drop(record.as_object_mut().unwrap().remove("kind")));
    found
}

/// The block stream: nothing is lost, nothing is added, and the file is that of what is kept in memory.
#[test]
fn blocks() {
    let mut whole = 0;
    for (folder, name) in samples() {
        let loader = TestDisk { root: folder };
        let settings = settings(&loader);
        let session = Session { loader: &loader, settings: &settings, progress: None };
        let path = Path::new(&name);
        let mut text = Vec::new();
        let run = session.compile(path, &name, Part::default(), &mut text).unwrap();
        let (mut bytes, mut failed) = (Vec::new(), None);
        let mut out = Ipc::new(&mut bytes);
        let sink = BlockTable::new(Part::default(), &mut out, &mut failed);
        assert_eq!(session.run(path, &name, Purpose::Compile, sink).whole, run.whole);
        let (mut kept, mut failed) = (Kept::default(), None);
        session.run(path, &name, Purpose::Compile, BlockTable::new(Part::default(), &mut kept, &mut failed));
        assert_eq!(kept.end.is_some(), run.whole.is_some());
        if run.whole.is_none() {
            continue;
        }
        whole += 1;
        let lines = lines(&text);
        let (schema, batches) = read(&bytes);
        let first: Value = serde_json::from_str(&schema.metadata()[PROGRAM]).unwrap();
        assert_eq!(plain(&first), lines[0], "{name}");
        assert_eq!(batches.last().unwrap().num_rows(), 0);
        let end = kept.end.unwrap();
        assert_eq!(plain(&serde_json::from_str(end.record()).unwrap()), *lines.last().unwrap());
        let others: Vec<Value> = serde_json::from_str(end.files()).unwrap();
        let expected: Vec<Value> = lines.iter().filter(|record| record["kind"] == "file").cloned().collect();
        assert_eq!(others, expected, "{name}");
        let in_file = String::from_utf8_lossy(&bytes).into_owned();
        assert!(in_file.contains(end.record()), "{name}");
        let expected = of_kind(&lines, "block");
        assert_eq!(records(&batches, self::path, &[]), expected, "{name}");
        assert_eq!(records(&kept.batches, self::path, &[]), expected, "{name}");
    }
    assert!(whole > 50, "{whole}");
}

/// A program of several batches, and parts of it.
#[test]
fn batches() {
    let rows: String = (0..700).map(|at| format!("N{} G1 X{at} F100\n", at * 10 + 20)).collect();
    let program = format!("%1\nN1 G73 L8000 Q200\n{rows}N8000 M30\n").replace("N1 G73 L8000 Q200\n", "N10 G0 G90 X0\n");
    let program = program.replace("N8000 M30", "N8000 G73 L20 Q150\nN8010 M30");
    for part in [Part::default(), Part { from: 70_000, limit: Some(5) }, Part { from: 0, limit: Some(0) }] {
        same_columns(&program, part);
    }
}

/// Points in a row: batches of nothing else, and some between which more changes.
#[test]
fn points() {
    let row = |at: u32| {
        let more = match at {
            100 => " F200 \"faster",
            101 => " Y7",
            70_000 => " M08",
            70_001 | 70_002 => " T5 S300 \"a\"",
            140_000..140_100 if at.is_multiple_of(3) => " G00",
            140_000..140_100 if at % 3 == 1 => " G01",
            _ => "",
        };
        format!("N{} X{}{more}\n", at + 20, f64::from(at % 5000) / 10.0)
    };
    let rows: String = (0..3 * 65_536 + 50).map(row).collect();
    let program = format!("%1\nN1 G54 G17 G90 G94 T1 M06\nN2 G00 X0 Y0 Z5\nN3 G01 Z-1 F100\n{rows}N999999 M30\n");
    same_columns(&program, Part::default());
    same_columns(&program, Part { from: 65_530, limit: Some(65_600) });
}

/// The columns of a part of a program hold its records.
fn same_columns(program: &str, part: Part) {
    let loader = cnc872c::text::MemoryLoader::new().with("a.nc", program);
    let settings = settings(&loader);
    let session = Session { loader: &loader, settings: &settings, progress: None };
    let mut text = Vec::new();
    let whole = session.compile(Path::new("a.nc"), "a.nc", part, &mut text).unwrap().whole;
    assert!(whole.is_some());
    let (mut bytes, mut failed) = (Vec::new(), None);
    let mut out = Ipc::new(&mut bytes);
    let sink = BlockTable::new(part, &mut out, &mut failed);
    assert_eq!(session.run(Path::new("a.nc"), "a.nc", Purpose::Compile, sink).whole, whole);
    let (found, expected) = (records(&read(&bytes).1, path, &[]), of_kind(&lines(&text), "block"));
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        assert_eq!(found, expected);
    }
}

/// The records of the motion stream.
struct Lines(String, cnc872c::analysis::motion::Summary);

impl TimedSink for &mut Lines {
    type Whole = ();

    fn block(
        &mut self,
        _: &cnc872c::run::Executed<'_>,
        times: &cnc872c::analysis::motion::BlockTimes,
        _: &mut Findings,
    ) -> std::ops::ControlFlow<()> {
        self.1.add(times);
        let mut record = Vec::new();
        write_block(&mut record, times);
        self.0.push_str(&String::from_utf8(record).unwrap());
        std::ops::ControlFlow::Continue(())
    }

    fn no_jerk(&mut self, motion_s: f64) {
        cnc872c::analysis::motion::Listener::no_jerk(&mut self.1, motion_s);
    }

    fn end(self, _: cnc872c::run::End, _: &mut Findings) {
        self.0.push_str(&total(&self.1));
    }
}

/// The motion stream, phases included.
#[test]
fn motion() {
    let mut whole = 0;
    for (folder, name) in samples() {
        let loader = TestDisk { root: folder };
        let settings = settings(&loader);
        let session = Session { loader: &loader, settings: &settings, progress: None };
        let times = Times { phases: true, time_dist: true };
        let profile = settings.machine.motion.profile.value;
        let mut text = Lines(String::new(), cnc872c::analysis::motion::Summary::new(profile, 0));
        if session.run_timed(Path::new(&name), &name, Purpose::Compile, times, &mut text).whole.is_none() {
            continue;
        }
        whole += 1;
        let (mut kept, mut failed, mut jerk_free) = (Kept::default(), None, 0);
        let first = machine(&Basis::of(&settings), &name);
        let sink = MotionTable::new(first, profile, &mut kept, &mut failed, &mut jerk_free);
        session.run_timed(Path::new(&name), &name, Purpose::Compile, times, sink);
        let lines = lines(text.0.as_bytes());
        let end: Value = serde_json::from_str(kept.end.unwrap().record()).unwrap();
        assert_eq!(plain(&end), *lines.last().unwrap());
        let mut expected = of_kind(&lines, "block");
        for record in &mut expected {
            // As everywhere, what is no number is left out: an empty list of phases too.
            if record["phases"] == json!([]) {
                record.as_object_mut().unwrap().remove("phases");
            } else if record["phases"].is_null() {
                record.as_object_mut().unwrap().remove("phases");
            }
        }
        let mut found = records(&kept.batches, path, &[]);
        for record in &mut found {
            if record["phases"] == json!([]) || record["phases"].is_null() {
                record.as_object_mut().unwrap().remove("phases");
            }
        }
        assert_eq!(found, expected, "{name}");
    }
    assert!(whole > 50, "{whole}");
}

/// Signals: the values of a row are those that the records have given so far.
#[test]
fn signals() {
    let mut whole = 0;
    for (folder, name) in samples() {
        let loader = TestDisk { root: folder };
        let settings = settings(&loader);
        let session = Session { loader: &loader, settings: &settings, progress: None };
        let chosen = || plc::default(settings.machine.dialect, true, false);
        let mut text = Vec::new();
        let (mut out, mut failed) = (Json::new(&mut text), None);
        let reader = Reader::new(chosen(), &settings.machine, Part::default(), &mut out, &mut failed);
        if session.run(Path::new(&name), &name, Purpose::Compile, reader).whole.is_none() {
            continue;
        }
        whole += 1;
        let (mut kept, mut broken, mut failed) = (Kept::default(), None, None);
        let mut table = StepTable::new(&mut kept, &mut broken);
        let reader = Reader::new(chosen(), &settings.machine, Part::default(), &mut table, &mut failed);
        session.run(Path::new(&name), &name, Purpose::Compile, reader);
        let lines = lines(&text);
        let end: Value = serde_json::from_str(kept.end.unwrap().record()).unwrap();
        assert_eq!(end, *lines.last().unwrap());
        let mut now = Map::new();
        let mut expected = of_kind(&lines, "step");
        for record in &mut expected {
            let Some(Value::Object(changed)) = record.as_object_mut().unwrap().remove("signals") else { panic!() };
            now.extend(changed);
            let some = now.iter().filter(|(_, value)| !value.is_null());
            record.as_object_mut().unwrap().extend(some.map(|(name, value)| (name.clone(), value.clone())));
        }
        assert_eq!(records(&kept.batches, |name| vec![name.to_owned()], &[]), expected, "{name}");
    }
    assert!(whole > 50, "{whole}");
}
