//! `compare`: what two programs do differently (CMP).

use std::path::Path;

use cnc872c::analysis::compare::{Comparison, StepReader, Steps, Tolerances, compare, schema};
use cnc872c::config::{Purpose, Settings};
use cnc872c::dict::Micro;
use cnc872c::session::Session;
use cnc872c::text::MemoryLoader;
use serde_json::{Value, json};

use crate::cli::{BAD, Place};
use crate::state::{Sample, samples};

const TOLERANCES: Tolerances = Tolerances { position: Micro::from_millionths(1000), percent: 0.0 };

fn steps(session: &Session<'_>, file: &str) -> Option<Steps> {
    let mut reader = StepReader::new(true);
    let run = session.watch(Path::new(file), file, Purpose::Report, &mut &mut reader);
    run.whole.map(|_| reader.finish())
}

fn of_sample(sample: &Sample) -> Option<Steps> {
    steps(&sample.session(), &sample.file)
}

fn of_text(text: &str) -> Steps {
    let loader = MemoryLoader::new().with("a.nc", text.as_bytes().to_vec());
    let settings = Settings::default();
    steps(&Session { loader: &loader, settings: &settings, progress: None }, "a.nc").unwrap()
}

/// What a comparison is from the other side.
fn mirrored(comparison: &Comparison) -> Vec<String> {
    let mut shown: Vec<String> = comparison
        .changes
        .iter()
        .filter(|change| change.old_blocks.count > 0 && change.new_blocks.count > 0)
        .map(|change| format!("{:?} {:?} {:?}", change.kind, change.old_blocks, change.new_blocks))
        .collect();
    shown.sort();
    shown
}

/// CMP-6: a program is the same as itself, and two compare as they do the other way round.
#[test]
fn the_same_and_the_mirror() {
    let mut before: Option<Steps> = None;
    let mut compared = 0;
    for sample in samples() {
        let Some(steps) = of_sample(&sample) else { continue };
        let again = of_sample(&sample).unwrap();
        assert_eq!(compare(&steps, &again, TOLERANCES), Comparison::default(), "{}", sample.name);
        if let Some(before) = &before {
            let (there, mut back) = (compare(before, &steps, TOLERANCES), compare(&steps, before, TOLERANCES));
            for change in &mut back.changes {
                std::mem::swap(&mut change.old_blocks, &mut change.new_blocks);
            }
            let pairs = |comparison: &Comparison| -> u64 { comparison.changes.iter().map(|c| c.count()).sum() };
            assert_eq!(pairs(&there), pairs(&back), "{}", sample.name);
            assert_eq!(there.changes.is_empty(), back.changes.is_empty());
            if there.changes.len() == 1 {
                assert_eq!(mirrored(&there), mirrored(&back), "{}", sample.name);
            }
        }
        before = Some(steps);
        compared += 1;
    }
    assert!(compared > 100);
}

const OLD: &str = "%1\nN10 G90 G0 X0 Y0 Z50 T5 M06\nN20 S1000 M3 F200\nN30 G1 X10 Z-5\nN35 Y5\nN40 G2 X20 Y15 I10 J0\nN50 M08\n\
                   N60 G1 X30\nN65 G71 L9 Q2\nN70 M30\nN100 G79 L9\nN110 G1 Z-1\nN120 G0 Z5 G70\n";

/// What a planted change is: kind, what, old, new, count.
fn planted(from: &str, to: &str) -> Vec<(String, u64, Option<String>)> {
    assert!(OLD.contains(from));
    let comparison = compare(&of_text(OLD), &of_text(&OLD.replace(from, to)), TOLERANCES);
    let changes = comparison.changes.iter();
    changes.map(|change| (change.kind.name().to_owned(), change.count(), change.what.clone())).collect()
}

fn one(kind: &str, count: u64, what: &str) -> Vec<(String, u64, Option<String>)> {
    vec![(kind.to_owned(), count, (!what.is_empty()).then(|| what.to_owned()))]
}

/// CMP-4: a planted change is one change with its count.
#[test]
fn planted_changes() {
    assert_eq!(planted("Z-1\n", "Z-1.2\n"), one("position", 2, "Z"));
    assert_eq!(planted("F200", "F250"), one("feed", 6, "F"));
    assert_eq!(planted("S1000", "S900"), one("speed", 6, "S"));
    assert_eq!(planted("N60 G1 X30", "N60 G1 X30\nN61 X40\nN62 Y0\nN63 X50"), one("added", 3, ""));
    assert_eq!(planted("N60 G1 X30", "N60 G1 X30\nN61 M00"), one("stop", 1, "M00"));
    assert_eq!(planted("N60 G1 X30", "N60 G1 X30\nN61 G4 Q50"), one("dwell", 1, ""));
    assert_eq!(planted("T5", "T6"), one("tool", 1, "T"));
    assert_eq!(planted("Y5\n", "Y5.001\n"), []);
    // CMP-1: how it is written does not matter.
    assert_eq!(planted("N60 G1 X30", "N60 G01 X30. F200 \"again\""), []);
    assert_eq!(planted("N65 G71 L9 Q2", "N61 G1 Z-1\nN62 G0 Z5\nN63 G1 Z-1\nN64 G0 Z5"), []);
}

/// CMP-4, CMP-5: M08 earlier is one change with both places; JSON, exit status.
#[test]
fn on_the_command_line() {
    let earlier = OLD.replace("N50 M08\n", "").replace("N35 Y5\n", "N33 M8\nN35 Y5\n");
    let files = [("a.nc", OLD.as_bytes()), ("b.nc", earlier.as_bytes()), ("bad.nc", BAD.as_bytes())];
    let place = Place::with(&files);
    let run = place.run(&["compare", "a.nc", "b.nc"]).ends(1);
    assert!(run.stdout.contains("T5: M08 now in N33 (was N50)"), "{}", run.stdout);
    let run = place.run(&["compare", "a.nc", "b.nc", "--format", "json"]).ends(1);
    let found: Value = serde_json::from_str(&run.stdout).unwrap();
    let validator = jsonschema::validator_for(&schema()).unwrap();
    assert!(validator.is_valid(&found), "{:?}", validator.iter_errors(&found).next());
    assert_eq!((&found["same"], &found["changes"][0]["old_blocks"]), (&json!(false), &json!([[5, 5]])));
    let czech = place.run(&["--lang", "cs", "compare", "a.nc", "a.nc"]).ends(0);
    assert!(czech.stdout.contains("totéž"), "{}", czech.stdout);
    place.run(&["compare", "a.nc", "bad.nc"]).ends(2);
    place.run(&["compare", "a.nc", "bad.nc", "--partial"]).ends(1);
    place.run(&["compare", "a.nc", "none.nc"]).ends(2);
    place.run(&["compare", "a.nc", "."]).ends(2);
}
