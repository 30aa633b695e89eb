//! `state`: what holds at a place of a program.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use cnc872c::analysis::state::{Asked, Index, Indexer, Place as At, StateReader, Timing, document, json, schema};
use cnc872c::config::{Overrides, Purpose, Settings, configure, find_project};
use cnc872c::diag::Findings;
use cnc872c::dict::{GCode, Lasting};
use cnc872c::resolve::Resolved;
use cnc872c::run::Sink;
use cnc872c::session::{Part, Session};
use cnc872c::text::{FileId, Sources};
use serde_json::Value;

use crate::cli::{BAD, Place};
use crate::disk::TestDisk;
use crate::json_schema::validator_for;
use crate::markers::{files, request};
use crate::samples::root;

/// A program of the samples, with how it is executed.
pub struct Sample {
    pub name: String,
    pub disk: TestDisk,
    pub file: String,
    pub settings: Settings,
}

impl Sample {
    pub fn session(&self) -> Session<'_> {
        Session { loader: &self.disk, settings: &self.settings, progress: None }
    }

    /// The block records; none of a program with errors.
    pub fn blocks(&self) -> Vec<Value> {
        let mut out = Vec::new();
        let run = self.session().compile(Path::new(&self.file), &self.file, Part::default(), &mut out).unwrap();
        if run.whole.is_none() {
            return Vec::new();
        }
        let records = std::str::from_utf8(&out).unwrap().lines().map(|line| serde_json::from_str(line).unwrap());
        records.filter(|record: &Value| record["kind"] == "block").collect()
    }
}

/// All programs among the samples.
pub fn samples() -> Vec<Sample> {
    let mut found = Vec::new();
    for path in files(&root().join("samples")) {
        if path.extension().is_none_or(|extension| extension != "nc") {
            continue;
        }
        let folder: PathBuf = path.parent().unwrap().to_path_buf();
        let disk = TestDisk { root: folder };
        let file = path.file_name().unwrap().to_str().unwrap().to_owned();
        let overrides = request(&std::fs::read(&path).unwrap()).overrides;
        let project = find_project(Path::new(""), &disk);
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let settings = configure(project.as_deref(), &overrides, &disk, &mut sources, &mut findings);
        if !findings.has_errors() {
            found.push(Sample { name: path.display().to_string(), disk, file, settings });
        }
    }
    assert!(found.len() > 200);
    found
}

/// Fields of block records that say what is in force.
const SAME: [&str; 12] =
    ["gear", "position", "feed", "s", "t", "tool", "h", "p", "d", "length_correction", "dynamic_set", "feed_scale"];

/// What holds before or behind each executed block is what the records say.
#[test]
fn state_is_what_the_records_say() {
    let validator = validator_for(&schema());
    let mut looked_at = 0;
    for sample in samples() {
        let blocks = sample.blocks();
        let step = blocks.len() / 9 + 1;
        for (seq, after) in (0..blocks.len()).step_by(step).flat_map(|seq| [(seq, false), (seq, true)]) {
            let asked = Asked { place: At::Seq(seq as u64), file: None, pass: None, after };
            let mut reader = StateReader::new(&sample.settings, asked, Timing::Configured);
            let run = sample.session().watch(Path::new(&sample.file), &sample.file, Purpose::Report, &mut &mut reader);
            let found = reader.finish(run.whole.is_some()).unwrap();
            let state: Value = serde_json::from_str(&json(&found, &sample.file, &sample.settings)).unwrap();
            let context = format!("{} seq {seq} after {after}\n{state:#}", sample.name);
            assert_eq!(validator.validate(&state), Ok(()), "{context}");
            assert_eq!(state["progress"]["blocks"], seq + usize::from(after), "{context}");
            assert_eq!(state["progress"]["blocks_left"], blocks.len() - seq - usize::from(after), "{context}");
            let at = &blocks[seq];
            for key in ["seq", "n", "file", "line", "column"] {
                assert_eq!(state["place"][key], at[key], "{key} {context}");
            }
            let record = if after { at } else { &blocks[seq.max(1) - 1] };
            if seq == 0 && !after {
                continue;
            }
            looked_at += 1;
            compare(&state, record, after && seq + 1 == blocks.len(), at, &context);
        }
    }
    assert!(looked_at > 1000);
}

/// Compares a state with the record of the block before it; `end`: it is behind the program, `at`: the block at the
/// place.
fn compare(state: &Value, record: &Value, end: bool, at: &Value, context: &str) {
    for key in SAME {
        if matches!(key, "feed_scale" | "dynamic_set" | "continuous_mode") && end {
            continue;
        }
        // Before the next block a macrocycle of the machine has moved what it may.
        if key == "position" && record.get("opaque_call").is_some() && record["seq"] != at["seq"] {
            continue;
        }
        assert_eq!(state.get(key), record.get(key), "{key} {context}");
    }
    for group in 0..12 {
        let function = record["g"][group].as_u64().and_then(|number| GCode::from_number(number as u8));
        let hidden = function.is_some_and(|function| function.lasting() == Lasting::Block);
        // A call of the cycle map suspends the cycle, and its return brings it back.
        let cycles = group == 8 && record["calls"] != at["calls"];
        if !hidden && !cycles && !end {
            assert_eq!(state["g"][group], record["g"][group], "g{group} {context}");
        }
    }
    for group in 1..15 {
        let expected = if [1, 7, 9].contains(&group) { &Value::Null } else { &record["m"][group] };
        assert_eq!(&state["m"][group], expected, "m{group} {context}");
    }
}

/// The index of a whole execution, and what its replays need.
fn indexed(sample: &Sample) -> (Index, Resolved, Sources) {
    let path = Path::new(&sample.file);
    let session = sample.session();
    let mut execution = session.open(path, &sample.file, Purpose::Report).unwrap().despite_errors();
    let mut indexer = Indexer::new(&sample.settings, u64::MAX);
    (&mut indexer).begin(execution.program());
    while let Some((block, findings)) = execution.step() {
        assert!((&mut indexer).block(&block, findings).is_continue());
    }
    let (resolved, sources) = (execution.program().resolved.clone(), execution.program().sources.clone());
    let whole = execution.finish().whole.is_some();
    (indexer.finish(whole), resolved, sources)
}

/// What holds before or behind every executed block of every sample, from its checkpoints, is what the records say.
#[test]
fn every_block_of_every_sample() {
    let mut looked_at = 0;
    let all = std::env::var_os("STATE_PLACES").is_some_and(|value| value == "all");
    for sample in samples() {
        let blocks = sample.blocks();
        if blocks.is_empty() {
            continue;
        }
        let (index, resolved, sources) = indexed(&sample);
        assert_eq!(index.executed(), blocks.len() as u64);
        let ids: BTreeMap<u64, u64> =
            blocks.iter().map(|block| (block["seq"].as_u64().unwrap(), block["n"].as_u64().unwrap())).collect();
        // Of a long sample a part; with STATE_PLACES all.
        let step = if all { 1 } else { blocks.len() / 40 + 1 };
        for (seq, after) in (0..blocks.len()).step_by(step).flat_map(|seq| [(seq, false), (seq, true)]) {
            let (checkpoint, mut replay) = index.from(seq as u64, after).unwrap();
            sample.session().observe_from(Path::new(&sample.file), (&resolved, &sources), checkpoint, &mut replay);
            let state = document(&replay.found().unwrap(), &sample.file, &sample.settings);
            let context = format!("{} seq {seq} after {after}\n{state:#}", sample.name);
            assert_eq!(state["progress"]["blocks"], seq + usize::from(after), "{context}");
            assert_eq!(state["progress"]["blocks_left"], blocks.len() - seq - usize::from(after), "{context}");
            let next = |field: &str, group: u64| {
                let is_it = |block: &&Value| {
                    block["m_set"].as_array().is_some_and(|set| set.contains(&group.into()))
                        || field == "next_stop" && block.get("m_at_stop").is_some()
                };
                blocks.iter().skip(seq + usize::from(after)).find(is_it).map(|block| block["seq"].clone())
            };
            assert_eq!(state["progress"].get("next_tool_change"), next("next_tool_change", 6).as_ref(), "{context}");
            assert_eq!(state["progress"].get("next_stop"), next("next_stop", 255).as_ref(), "{context}");
            if seq > 0 || after {
                let at = &blocks[seq];
                let record = if after { at } else { &blocks[seq - 1] };
                compare(&state, record, after && seq + 1 == blocks.len(), at, &context);
                looked_at += 1;
            }
        }
        // Each block of the program is executed where the records have it.
        let file = resolved.file(FileId(0)).unwrap();
        for id in file.block_ids() {
            let seqs: Vec<u64> = index.executions(FileId(0), id).collect();
            assert!(seqs.iter().all(|seq| ids[seq] == u64::from(file.shown_number(id))), "{}", sample.name);
            let (checkpoint, mut arrivals) = match index.arrivals_from(&seqs) {
                Some(found) => found,
                None => continue,
            };
            sample.session().observe_from(Path::new(&sample.file), (&resolved, &sources), checkpoint, &mut arrivals);
            let calls = arrivals.found().into_iter().map(|arrival| (arrival.seq, arrival.calls.len()));
            for (seq, depth) in calls {
                assert_eq!(blocks[seq as usize]["calls"].as_array().map_or(0, Vec::len), depth, "{}", sample.name);
            }
        }
    }
    assert!(looked_at > 3000, "{looked_at}");
}

/// From checkpoints the answer is the same as from the beginning, in a program longer than the distance between them.
#[test]
fn checkpoints_tell_the_same() {
    let mut text = "%1\nN1 G90 G54 G0 X0 Y0 Z50 T1 M06\nN2 S1000 M3 F500 R1=3 G1 Z-1\nN3 G71 L100 Q7\n".to_owned();
    (10..9000).for_each(|n| text += &format!("N{n} X{}.5 Y{}\n", n % 90, n % 7));
    text += "N9000 T2 M06 G91\nN9001 G0 Z5 M00\nN9002 X1 G73 L8000 Q2\nN9003 M30\nN9100 G79 L100\nN9110 XR1 R2=5\nN9120 M8 G70\n";
    let place = Place::with(&[("a.nc", text.as_bytes()), ("cnc872c.toml", b"[motion]\naccel-mm-s2 = 300.0\n")]);
    let disk = TestDisk { root: place.path("") };
    let project = find_project(Path::new(""), &disk);
    let (mut sources, mut findings) = (Sources::new(), Findings::new());
    let settings = configure(project.as_deref(), &Overrides::default(), &disk, &mut sources, &mut findings);
    let sample = Sample { name: "a.nc".to_owned(), disk, file: "a.nc".to_owned(), settings };
    let (index, resolved, sources) = indexed(&sample);
    let last = index.executed() - 1;
    assert!(last > 2 << 12);
    for seq in [0, 1, 3, 8, 4095, 4096, 4097, 8191, 9010, 9011, 9012, last - 1500, last - 2, last] {
        for after in [false, true] {
            let (checkpoint, mut replay) = index.from(seq, after).unwrap();
            sample.session().observe_from(Path::new("a.nc"), (&resolved, &sources), checkpoint, &mut replay);
            let quick = json(&replay.found().unwrap(), "a.nc", &sample.settings);
            let asked = Asked { place: At::Seq(seq), file: None, pass: None, after };
            let mut reader = StateReader::new(&sample.settings, asked, Timing::Always);
            let run = sample.session().watch(Path::new("a.nc"), "a.nc", Purpose::Report, &mut &mut reader);
            let slow = json(&reader.finish(run.whole.is_some()).unwrap(), "a.nc", &sample.settings);
            assert_eq!(quick, slow, "seq {seq} after {after}");
        }
    }
}

const LOOP: &str = "%1\nN10 G90 G0 X0 Y0 Z50 T5 M06\nN20 S1000 M3 F200\nN30 G1 X10 R10=4\nN40 G91 X1 G73 L30 Q2\nN50 G90 G71 L9 Q2\n\
                    N60 G1 A5\nN70 M30\nN100 G79 L9\nN110 G1 Z-1\nN120 G0 Z5 G70\n";

fn answer(place: &Place, arguments: &[&str]) -> Value {
    let run = place.run(&[&["state", "a.nc", "--format", "json"], arguments].concat()).ends(0);
    serde_json::from_str(&run.stdout).unwrap()
}

/// Who wrote what, counters, calls, what is left.
#[test]
fn places_and_their_parts() {
    let place = Place::with(&[("a.nc", LOOP.as_bytes())]);
    let state = answer(&place, &["--n", "110", "--pass", "2"]);
    assert_eq!(state["place"]["calls"][0]["pass"], 2);
    assert_eq!(state["place"]["calls"][0]["n"], 50);
    assert_eq!(state["written"]["feed"]["n"], 20);
    assert_eq!(state["written"]["R10"]["n"], 30);
    assert_eq!(state["written"]["m2"]["n"], 20);
    assert_eq!(state["written"].get("g1"), None);
    assert_eq!(state["parameters"], serde_json::json!({ "R10": 4 }));
    assert_eq!(state["unknown"], serde_json::json!({ "A": "not_programmed" }));
    let state = answer(&place, &["--n", "30", "--pass", "2"]);
    assert_eq!(state["counters"], serde_json::json!([{ "n": 40, "file": 0, "line": 5, "left": 1, "of": 2 }]));
    // Before its own jump, which lowers it, and behind it.
    let left = |state: &Value| state["counters"][0]["left"].clone();
    assert_eq!(left(&answer(&place, &["--n", "40", "--pass", "1"])), Value::Null);
    assert_eq!(left(&answer(&place, &["--n", "40", "--pass", "2"])), 1);
    assert_eq!(left(&answer(&place, &["--n", "40", "--pass", "3"])), 0);
    assert_eq!(left(&answer(&place, &["--n", "40", "--pass", "2", "--after"])), 0);
    assert_eq!(answer(&place, &["--n", "40", "--pass", "3", "--after"])["counters"], serde_json::json!([]));
    let state = answer(&place, &["--at-tool", "T5"]);
    assert_eq!((&state["place"]["n"], &state["progress"]["next_tool_change"]), (&10.into(), &0.into()));
    assert_eq!(answer(&place, &["--line", "3"])["place"]["n"], 20);
    let whole = answer(&place, &["--seq", "0"])["progress"]["time_left_s"].as_f64().unwrap();
    let late = answer(&place, &["--time", &format!("{}", whole - 0.01)]);
    assert_eq!(late["place"]["n"], 120);
    for (arguments, says) in [
        (&["--n", "110"][..], "--pass 2  N110, line 10, seq 13, L9 from N50 (2/2)"),
        (&["--n", "111"], "the nearest number is N110"),
        (&["--n", "110", "--pass", "3"], "counts to 2"),
        (&["--seq", "99"], "blocks that the program executes"),
        (&["--time", "9:00:00"], "the program takes 0:0"),
        (&["--time", "soon"], "0:12:30"),
        (&["--n", "1", "--file", "L77"], "no macrocycle"),
        (&["--at-tool", "T9"], "never executed"),
        (&[], "is missing"),
    ] {
        let run = place.run(&[&["state", "a.nc"], arguments].concat()).ends(2);
        assert!(run.stderr.contains(says) && run.stdout.is_empty(), "{arguments:?}: {}", run.stderr);
    }
    let czech = place.run(&["--lang", "cs", "state", "a.nc", "--n", "60"]).ends(0);
    assert!(
        czech.stdout.contains("Před N60 (řádek 7") && czech.stdout.contains("není známa: dosud"),
        "{}",
        czech.stdout
    );
}

/// An error before the place is status 1; one behind it is not.
#[test]
fn errors_before_and_behind() {
    let place =
        Place::with(&[("bad.nc", BAD.as_bytes()), ("late.nc", b"%1\nN10 G0 X1\nN20 G1 X5 F99999999\nN30 M30\n")]);
    place.run(&["state", "bad.nc", "--n", "20"]).ends(1);
    place.run(&["state", "bad.nc", "--n", "10"]).ends(0);
    place.run(&["state", "late.nc", "--n", "20"]).ends(0);
    place.run(&["state", "late.nc", "--n", "20", "--after"]).ends(1);
    place.run(&["state", "late.nc", "--n", "30"]).ends(1);
    place.run(&["state", "none.nc", "--n", "30"]).ends(2);
}
