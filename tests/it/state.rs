//! `state`: what holds at a place of a program.

use std::ops::{ControlFlow, Range};
use std::path::{Path, PathBuf};

use cnc872c::analysis::state::{
    Asked, AtTime, Found, Index, Indexer, Place as At, PlaceFault, Search, Timeline, TimelineReader, Timing, document,
    json, schema,
};
use cnc872c::config::{Overrides, Purpose, Settings, configure, find_project};
use cnc872c::diag::Findings;
use cnc872c::dict::{Decimal, GCode, Lasting};
use cnc872c::resolve::Resolved;
use cnc872c::run::{End, Executed, Sink};
use cnc872c::session::{Part, Session};
use cnc872c::text::{FileId, LineColumn, Sources};
use serde_json::Value;

use crate::cli::{BAD, Place};
use crate::disk::TestDisk;
use crate::disk::files;
use crate::json_schema::validator_for;
use crate::markers::request;
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

    /// What holds at a place.
    fn found(&self, asked: Asked, timing: Timing) -> Box<Found> {
        self.session().state(Path::new(&self.file), &self.file, asked, timing).found.unwrap()
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
        let step = blocks.len() / 4 + 1;
        for (seq, after) in (0..blocks.len()).step_by(step).flat_map(|seq| [(seq, false), (seq, true)]) {
            let asked = Asked { place: At::Seq(seq as u64), file: None, pass: None, after };
            let mut found = sample.found(asked.clone(), Timing::Configured);
            let text = json(&found, &sample.file, &sample.settings);
            let state: Value = serde_json::from_str(&text).unwrap();
            let context = || format!("{} seq {seq} after {after}\n{state:#}", sample.name);
            // Without times, points are passed over.
            found.times = None;
            let untimed = json(&found, &sample.file, &sample.settings);
            let of_seq = json(&sample.found(asked.clone(), Timing::Never), &sample.file, &sample.settings);
            assert_eq!(of_seq, untimed, "{}", context());
            if blocks[seq]["file"] == 0 {
                let n = blocks[seq]["n"].as_u64().unwrap() as u32;
                let is_here = |block: &&Value| block["file"] == 0 && block["n"] == n;
                let pass = blocks[..=seq].iter().filter(is_here).count() as u64;
                let asked = Asked { place: At::N(n), pass: Some(pass), ..asked };
                let of_n = json(&sample.found(asked, Timing::Never), &sample.file, &sample.settings);
                assert_eq!(of_n, untimed, "N{n} {}", context());
            }
            assert_eq!(validator.validate(&state), Ok(()), "{}", context());
            assert_eq!(state["progress"]["blocks"], seq + usize::from(after), "{}", context());
            assert_eq!(state["progress"]["blocks_left"], blocks.len() - seq - usize::from(after), "{}", context());
            let at = &blocks[seq];
            for key in ["seq", "n", "file", "line", "column"] {
                assert_eq!(state["place"][key], at[key], "{key} {}", context());
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
fn compare(state: &Value, record: &Value, end: bool, at: &Value, context: &dyn Fn() -> String) {
    for key in SAME {
        if matches!(key, "feed_scale" | "dynamic_set" | "continuous_mode") && end {
            continue;
        }
        // The record stands before the macrocycle of the machine, which has moved what it may when the block is over.
        if key == "position" && record.get("opaque_call").is_some() {
            continue;
        }
        assert_eq!(state.get(key), record.get(key), "{key} {}", context());
    }
    for group in 0..12 {
        let function = record["g"][group].as_u64().and_then(|number| GCode::from_number(number as u8));
        let hidden = function.is_some_and(|function| function.lasting() == Lasting::Block);
        // A call of the cycle map suspends the cycle, and its return brings it back.
        let cycles = group == 8 && record["calls"] != at["calls"];
        if !hidden && !cycles && !end {
            assert_eq!(state["g"][group], record["g"][group], "g{group} {}", context());
        }
    }
    for group in 1..15 {
        let expected = if [1, 7, 9].contains(&group) { &Value::Null } else { &record["m"][group] };
        assert_eq!(&state["m"][group], expected, "m{group} {}", context());
    }
}

/// FLW-12: behind a block that calls a macrocycle of the machine, what it may move is not known, as before the next
/// one.
#[test]
fn behind_a_macrocycle_of_the_machine() {
    let settings = "[machine-macrocycles]\nL9500 = { axes = [\"Z\"] }\nL9501 = {}\n[cycles]\nG84 = 9500\n";
    let program = "%1\nN10 G00 X1 Y2 Z60\nN20 X5 G72 L9501\nN30 G00 X7 Y8 Z9\nN40 X6 G84\nN50 G80 X1\nN60 M30\n";
    let place = Place::with(&[("p.nc", program.as_bytes()), ("cnc872c.toml", settings.as_bytes())]);
    let at = |n: &str, more: &[&str]| {
        let run = place.run(&[&["state", "p.nc", "--n", n, "--format", "json"], more].concat()).ends(0);
        let state: Value = serde_json::from_str(&run.stdout).unwrap();
        (state["position"].clone(), state["unknown"].clone())
    };
    let all = serde_json::json!({ "X": "macrocycle", "Y": "macrocycle", "Z": "macrocycle" });
    assert_eq!(at("20", &["--after"]), (Value::Null, all));
    assert_eq!(
        at("40", &["--after"]),
        (serde_json::json!({ "X": 6, "Y": 8 }), serde_json::json!({ "Z": "macrocycle" }))
    );
    assert_eq!(at("40", &["--after"]), at("50", &[]));
    assert_eq!(at("20", &["--after"]), at("30", &[]));
}

/// The index of a whole execution, and what its replays need.
fn indexed(sample: &Sample) -> (Index, Resolved, Sources) {
    let path = Path::new(&sample.file);
    let session = sample.session();
    let mut execution = session.open(path, &sample.file, Purpose::Report).unwrap().despite_errors();
    let mut indexer = Indexer::new(&sample.settings, u64::MAX);
    execution.show(&mut &mut indexer);
    let (resolved, sources) = (execution.program().resolved.clone(), execution.program().sources.clone());
    let whole = execution.finish().whole.is_some();
    (indexer.finish(whole), resolved, sources)
}

/// When the blocks of an execution end.
fn timeline(sample: &Sample, (index, resolved, sources): &(Index, Resolved, Sources)) -> Timeline {
    let mut reader = TimelineReader::new(&sample.settings, index.executed());
    let (checkpoint, _) = index.from(0..1, false).unwrap();
    sample.session().observe_from(Path::new(&sample.file), (resolved, sources), checkpoint, &mut reader);
    reader.finish()
}

/// What holds before and behind every executed block of every sample is what the records say: one pass over each
/// program that asks at every block.
#[test]
fn every_block_of_every_sample() {
    let mut looked_at = 0;
    for sample in samples() {
        let blocks = sample.blocks();
        if blocks.is_empty() {
            continue;
        }
        let (index, resolved, sources) = indexed(&sample);
        assert_eq!(index.executed(), blocks.len() as u64);
        let replayed = |seqs: Range<u64>, after: bool| {
            let (checkpoint, mut replay) = index.from(seqs, after).unwrap();
            sample.session().observe_from(Path::new(&sample.file), (&resolved, &sources), checkpoint, &mut replay);
            replay.found()
        };
        for after in [false, true] {
            let mut all = Vec::new();
            while all.len() < blocks.len() {
                all.extend(replayed(all.len() as u64..u64::MAX, after));
            }
            let mut next = [None, None];
            for (seq, found) in all.iter().enumerate().rev() {
                let state = document(found, &sample.file, &sample.settings);
                let context = || format!("{} seq {seq} after {after}\n{state:#}", sample.name);
                let (at, progress) = (&blocks[seq], &state["progress"]);
                assert_eq!(progress["blocks"], seq + usize::from(after), "{}", context());
                assert_eq!(progress["blocks_left"], blocks.len() - seq - usize::from(after), "{}", context());
                let changes = at["m_set"].as_array().is_some_and(|set| set.contains(&6.into()));
                let comes = [changes, at.get("m_at_stop").is_some()].map(|comes| comes.then(|| &at["seq"]));
                let told = [progress.get("next_tool_change"), progress.get("next_stop")];
                let behind = next;
                next = [comes[0].or(next[0]), comes[1].or(next[1])];
                assert_eq!(told, if after { behind } else { next }, "{}", context());
                for key in ["seq", "n", "file", "line", "column"] {
                    assert_eq!(state["place"][key], at[key], "{key} {}", context());
                }
                if seq > 0 || after {
                    let record = if after { at } else { &blocks[seq - 1] };
                    compare(&state, record, after && seq + 1 == blocks.len(), at, &context);
                    looked_at += 1;
                }
            }
        }
        // Each block of the program is executed where the records have it.
        let file = resolved.file(FileId(0)).unwrap();
        for id in file.block_ids().step_by(file.block_count() as usize / 100 + 1) {
            let seqs: Vec<u64> = index.executions(FileId(0), id).collect();
            let n = |seq: u64| blocks[seq as usize]["n"].as_u64();
            assert!(seqs.iter().all(|seq| n(*seq) == Some(file.shown_number(id).into())), "{}", sample.name);
            let Some((checkpoint, mut arrivals)) = index.arrivals_from(&seqs) else { continue };
            sample.session().observe_from(Path::new(&sample.file), (&resolved, &sources), checkpoint, &mut arrivals);
            for arrival in arrivals.found() {
                let calls = blocks[arrival.seq as usize]["calls"].as_array().map_or(0, Vec::len);
                assert_eq!(calls, arrival.calls.len(), "{}", sample.name);
            }
        }
    }
    assert!(looked_at > 10_000, "{looked_at}");
}

/// The facts of each executed block that a place is named by: file, number, place, and the tool of its M06.
#[derive(Default)]
struct Facts(Vec<Fact>);

/// File, number and place of a block, and the tool that it changes to.
type Fact = (String, u32, LineColumn, Option<Decimal>);

impl Sink for &mut Facts {
    type Whole = ();

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        let tool = block.m_written().contains(&6).then(|| block.tool()).flatten();
        self.0.push((block.file_name().to_owned(), block.n(), block.line_column(), tool));
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) {}
}

/// Many places looked for in one execution, each with where it was found.
struct Searches(Vec<(Search, Option<u64>)>);

impl Sink for &mut Searches {
    type Whole = ();

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        for (search, found) in &mut self.0 {
            if search.arrives(block) {
                assert_eq!(found.replace(block.seq()), None);
            }
        }
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) {}
}

/// Every executed block of every sample is found by its number, its line, its seq, and its tool, with its pass; without
/// a pass only when it is executed once.
#[test]
fn every_place_of_every_sample() {
    let mut found = [0; 4];
    for sample in samples() {
        let (session, path) = (sample.session(), Path::new(&sample.file));
        let mut facts = Facts::default();
        session.watch(path, &sample.file, Purpose::Report, &mut &mut facts);
        let facts = facts.0;
        // Looking for many places in long programs takes long: of those some.
        let step = facts.len() / 400 + 1;
        let mut searches = Searches(Vec::new());
        let mut expected = Vec::new();
        let mut ask = |kind: usize, place: At, file: &str, same: Vec<usize>, seq: usize| {
            let file = (file != sample.file).then(|| file.to_owned());
            let pass = same.iter().position(|other| *other == seq).unwrap() as u64 + 1;
            for (pass, seq) in [(Some(pass), seq), (None, same[0])] {
                let asked = Asked { place, file: file.clone(), pass, after: false };
                searches.0.push((Search::new(asked), None));
                expected.push((kind, seq, (pass.is_none() && same.len() > 1).then_some(same.len() as u64)));
            }
        };
        for (seq, (file, n, at, tool)) in facts.iter().enumerate().step_by(step) {
            let all = |is: &dyn Fn(&Fact) -> bool| -> Vec<usize> {
                facts.iter().enumerate().filter(|(_, fact)| is(fact)).map(|(at, _)| at).collect()
            };
            ask(2, At::Seq(seq as u64), &sample.file, vec![seq], seq);
            if let Some(tool) = tool {
                ask(3, At::Tool(*tool), &sample.file, all(&|fact| fact.3 == Some(*tool)), seq);
            }
            let of_line = all(&|fact| (&fact.0, fact.2.line) == (file, at.line));
            let of_number = all(&|fact| (&fact.0, fact.1) == (file, *n));
            // Numbers that stand twice, and lines with two blocks, name the first.
            // A block without a number of its own cannot be asked for.
            let is_it = |other: &usize| facts[*other].1 == *n && facts[*other].2 == *at;
            if *n > 0 && of_line.iter().chain(&of_number).all(is_it) {
                ask(0, At::N(*n), file, of_number, seq);
                ask(1, At::Line(at.line), file, of_line, seq);
            }
        }
        session.watch(path, &sample.file, Purpose::Report, &mut &mut searches);
        for ((search, at), (kind, seq, several)) in searches.0.into_iter().zip(expected) {
            let context = format!("{} {:?} {seq}", sample.name, search.asked());
            assert_eq!(at, Some(seq as u64), "{context}");
            let fault = search.fault(facts.len() as u64);
            let count = if let Some(PlaceFault::Several { count, .. }) = fault { Some(count) } else { None };
            assert_eq!((fault.is_some(), count), (several.is_some(), several), "{context}");
            found[kind] += 1;
        }
    }
    assert!(found.iter().all(|count| *count > 100), "{found:?}");
}

/// The block under way at the beginning of each block's time, as shown, and in the middle is that block: `--time`.
#[test]
fn every_time_of_short_samples() {
    let mut looked_at = 0;
    for sample in samples() {
        let path = Path::new(&sample.file);
        if !(1..=40).contains(&sample.blocks().len()) {
            continue;
        }
        let indexed = indexed(&sample);
        let timeline = timeline(&sample, &indexed);
        let (index, resolved, sources) = &indexed;
        let (checkpoint, mut replay) = index.from(0..u64::MAX, true).unwrap();
        sample.session().observe_from(path, (resolved, sources), checkpoint, &mut replay);
        let ends = replay.found().into_iter().map(|found| timeline.around(found.blocks).seconds.done);
        let ends: Vec<f64> = ends.collect();
        let starts = std::iter::once(0.0).chain(ends.clone());
        for (seq, (start, end)) in starts.zip(ends).enumerate().filter(|(_, (start, end))| end - start > 0.002) {
            for at_s in [(start * 1e6).round() / 1e6, (start + end) / 2.0] {
                let mut at_time = AtTime::new(&sample.settings, at_s);
                sample.session().watch(path, &sample.file, Purpose::Report, &mut &mut at_time);
                assert_eq!(at_time.found(), Ok(seq as u64), "{} {at_s}: {start} {end}", sample.name);
            }
            looked_at += 1;
        }
    }
    assert!(looked_at > 30, "{looked_at}");
}

/// From checkpoints the answer is the same as from the beginning, in a program longer than the distance between them.
#[test]
fn checkpoints_tell_the_same() {
    let mut text = "%1\nN1 G90 G54 G0 X0 Y0 Z50 T1 M06\nN2 S1000 M3 F500 R1=3 G1 Z-1\nN3 G71 L100 Q7\n".to_owned();
    (10..9000).for_each(|n| text += &format!("N{n} X{}.5 Y{}\n", n % 90, n % 7));
    text += "N9000 T2 M06 G91\nN9001 G0 Z5 M00\nN9002 X1 G73 L8000 Q2\nN9003 M30\nN9100 G79 L100\nN9110 XR1 R2=5\nN9120 M8 G70\n";
    for project in ["[motion]\naccel-mm-s2 = 300.0\n", ""] {
        let place = Place::with(&[("a.nc", text.as_bytes()), ("cnc872c.toml", project.as_bytes())]);
        let disk = TestDisk { root: place.path("") };
        let project = find_project(Path::new(""), &disk);
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let settings = configure(project.as_deref(), &Overrides::default(), &disk, &mut sources, &mut findings);
        let sample = Sample { name: "a.nc".to_owned(), disk, file: "a.nc".to_owned(), settings };
        let indexed = indexed(&sample);
        let timeline = timeline(&sample, &indexed);
        let (index, resolved, sources) = &indexed;
        let last = index.executed() - 1;
        assert!(last > 2 << 12);
        for seq in [0, 1, 3, 8, 4095, 4096, 4097, 8191, 9010, 9011, 9012, last - 1500, last - 2, last] {
            for after in [false, true] {
                let (checkpoint, mut replay) = index.from(seq..seq + 1, after).unwrap();
                sample.session().observe_from(Path::new("a.nc"), (resolved, sources), checkpoint, &mut replay);
                let mut quick = replay.found().remove(0);
                let asked = Asked { place: At::Seq(seq), file: None, pass: None, after };
                // Without times, points are passed over.
                let [untimed, timed] = [Timing::Never, Timing::Always]
                    .map(|timing| json(&sample.found(asked.clone(), timing), "a.nc", &sample.settings));
                assert_eq!(json(&quick, "a.nc", &sample.settings), untimed, "seq {seq} after {after}");
                quick.times = Some(timeline.around(quick.blocks));
                assert_eq!(json(&quick, "a.nc", &sample.settings), timed, "seq {seq} after {after}");
            }
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
    let again = Place::with(&[("a.nc", b"%1\nN10 G00 X0\nN20 G23 I2\nN30 G23 I2\nN40 X1\nN50 M30\n")]);
    assert_eq!(answer(&again, &["--n", "40"])["written"]["dynamic_set"]["n"], 30, "the same set, chosen again");
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
    // The limit is met behind every block that was executed.
    place.put("long.nc", "%1\nN10 G0 X1\nN20 G91 X1\nN30 G73 L20 Q9999\nN40 G73 L20 Q9999\nN50 M30\n");
    let long = ["--max-blocks", "1000"];
    let before = place.run(&[&["state", "long.nc", "--seq", "3"], &long[..]].concat()).ends(0).stdout;
    assert!(before.contains("N20 (line 3, seq 3)"), "{before}");
    place.run(&[&["state", "long.nc", "--n", "50"], &long[..]].concat()).ends(1).says("E0410");
}

/// What a parameter of the machine's table gives is programmed, and not known.
#[test]
fn values_that_are_not_known() {
    let place =
        Place::with(&[("a.nc", b"%1\nN10 G90 T1 M06\nN20 SR2 M03 HR3\nN30 G0 X1\nN40 GR4\nN50 MR5\nN60 M30\n")]);
    let before = |n: &str| place.run(&["state", "a.nc", "--n", n, "--lang", "en", "-A", "W0503"]).ends(0).stdout;
    let known = before("30");
    for row in [
        "F               not programmed yet\n",
        "S               not known here  N20 (line 3)\n",
        "H               not known",
    ] {
        assert!(known.contains(row), "{row}: {known}");
    }
    assert!(!known.contains("others"), "{known}");
    assert_eq!(before("50").matches("\n  others  not known here\n").count(), 1);
    assert_eq!(before("60").matches("\n  others  not known here\n").count(), 2);
    // A dynamic set stays behind G23.
    let sets = "%1\nN10 G23 I3\nN20 G24\nN30 M30\n";
    let place = Place::with(&[("a.nc", sets.as_bytes())]);
    let behind = place.run(&["state", "a.nc", "--n", "30", "--lang", "en"]).ends(0).stdout;
    assert!(behind.contains("dynamic set     3  N10 (line 2)"), "{behind}");
    let gears = "%1\nN10 S100 M41\nN20 M42\nN30 S200\nN40 M30\n";
    let place = Place::with(&[("a.nc", gears.as_bytes())]);
    let behind = place.run(&["state", "a.nc", "--n", "40", "--lang", "en"]).ends(0).stdout;
    assert!(behind.contains("gear            2    N20 (line 3)"), "{behind}");
}

/// Under G74 the table shows the diameter, as programs write it, beside the position of X, which is a radius.
#[test]
fn a_lathe() {
    let lathe = "%1\nN10 G90 G74 G00 X60 Z5\nN20 Z2\nN30 G75 X60\nN40 Z5\nN50 M30\n";
    let place = Place::with(&[("a.nc", lathe.as_bytes())]);
    let x = |n: &str| {
        let run = place.run(&["state", "a.nc", "--n", n]).ends(0);
        run.stdout.lines().find(|line| line.starts_with("  X ")).unwrap().split("N").next().unwrap().trim().to_owned()
    };
    assert_eq!(x("20"), "X  30 (Ø 60)");
    assert_eq!(x("40"), "X  60");
}
