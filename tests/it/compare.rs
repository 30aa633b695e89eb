//! `compare`: what two programs do differently (CMP).

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cnc872c::analysis::compare::{Change, ChangeKind, Comparison, StepReader, Steps, Tolerances, compare, schema};
use cnc872c::config::{Purpose, Settings};
use cnc872c::dict::Micro;
use cnc872c::session::Session;
use cnc872c::text::{Loader, MemoryLoader};
use serde_json::{Value, json};

use crate::cli::{BAD, Place};
use crate::disk::TestDisk;
use crate::json_schema::validator_for;
use crate::same_program::formatted;
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

/// What changed, as a key, and the blocks of both programs.
type Seen = BTreeMap<String, [BTreeSet<u32>; 2]>;

/// A comparison as it has to be the same from the other side, `mirrored`: that side. The tool of a change, and the
/// name of a function that replaces another one, are those of the new program: they are left out, so changes that
/// differ in nothing else are one.
fn seen(comparison: &Comparison, mirrored: bool) -> Seen {
    let mut seen = Seen::new();
    for change in &comparison.changes {
        let turn = |sides: [String; 2]| if mirrored { [sides[1].clone(), sides[0].clone()] } else { sides };
        let is_shift = change.kind == ChangeKind::Position && change.delta.is_some();
        let [old, new] = turn([format!("{:?}", change.old), format!("{:?}", change.new)]);
        let values = if is_shift { String::new() } else { format!("{old} {new}") };
        let delta = change.delta.map(|delta| if mirrored { -delta } else { delta });
        let replaces = change.old.is_some() && change.new.is_some() && change.old != change.new;
        let named = !matches!(change.kind, ChangeKind::Function | ChangeKind::Stop) || !replaces;
        let what = change.what.as_ref().filter(|_| named);
        let [added, removed] = turn(["added".to_owned(), "removed".to_owned()]);
        let kind = if change.kind == ChangeKind::Added {
            added
        } else if change.kind == ChangeKind::Removed {
            removed
        } else {
            change.kind.name().to_owned()
        };
        let blocks = seen.entry(format!("{kind} {what:?} {delta:?} {values}")).or_default();
        let sides = if mirrored { [1, 0] } else { [0, 1] };
        for (side, from) in sides.into_iter().zip([&change.old_blocks, &change.new_blocks]) {
            blocks[side].extend(from.runs.iter().flat_map(|[from, to]| *from..=*to));
        }
    }
    seen
}

/// CMP-6: a program is the same as itself, and two compare as they do the other way round, but for the tool, which is
/// that of the new program (CMP-4).
#[test]
fn the_same_and_the_mirror() {
    let mut before: Option<(String, Steps)> = None;
    let mut compared = 0;
    for sample in samples() {
        let Some(steps) = of_sample(&sample) else { continue };
        let again = of_sample(&sample).unwrap();
        assert_eq!(compare(&steps, &again, TOLERANCES), Comparison::default(), "{}", sample.name);
        if let Some((name, before)) = &before {
            let (there, back) = (compare(before, &steps, TOLERANCES), compare(&steps, before, TOLERANCES));
            assert_eq!(seen(&there, false), seen(&back, true), "{name} {}", sample.name);
        }
        before = Some((sample.name.clone(), steps));
        compared += 1;
    }
    assert!(compared > 100);
    let changed = OLD.replace("Z-1\n", "Z-1.2\n").replace("F200", "F250").replace("N50 M08\n", "N50 M00\n");
    let (old, new) = (of_text(OLD), of_text(&changed.replace("N65", "N62 X40\nN63 M05\nN65")));
    let there = compare(&old, &new, TOLERANCES);
    assert!(there.changes.len() > 4, "{there:#?}");
    assert_eq!(seen(&there, false), seen(&compare(&new, &old, TOLERANCES), true));
}

/// CMP-2: programs with nothing alike, with points in another order, or of few different blocks are aligned whatever
/// their length: blocks that both have in their order are never added or removed.
#[test]
fn long_programs_that_differ() {
    let body = |blocks: &[String]| {
        let lines: String = blocks.iter().enumerate().map(|(at, block)| format!("N{} {block}\n", at + 50)).collect();
        of_text(&format!("%1\nN10 G90 G0 X0 Y0 Z50 T5 M06\nN20 S1000 M3 F200\nN30 G1 X1 Z-1\n{lines}N9000000 M30\n"))
    };
    let points: Vec<String> =
        (0..40_000_u32).map(|at| format!("X{} Y{}", at * 37 % 20_011, at * 91 % 15_013)).collect();
    let shuffled: Vec<String> = (0..40_000).map(|at| points[at * 17_389 % 40_000].clone()).collect();
    let mut longer = points.clone();
    longer.splice(20_000..20_000, points[1000..9000].to_vec());
    let few: Vec<String> = (0..40_000_u32).map(|at| format!("X{}", at.wrapping_mul(2_654_435_761) >> 30)).collect();
    let [points, shuffled, longer, few] = [points, shuffled, longer, few].map(|blocks| body(&blocks));
    let counts = |old: &Steps, new: &Steps| {
        let changes = compare(old, new, TOLERANCES).changes;
        let count = |kind: ChangeKind| changes.iter().filter(|c| c.kind == kind).map(|c| c.count()).sum::<u64>();
        (count(ChangeKind::Added), count(ChangeKind::Removed), count(ChangeKind::Position) > 0)
    };
    // What stands twice is added once, as a whole.
    assert_eq!(counts(&points, &longer), (8000, 0, false));
    assert_eq!(counts(&longer, &points), (0, 8000, false));
    // The same points in another order: as many blocks come as go.
    let (added, removed, moved) = counts(&points, &shuffled);
    assert!(added == removed && moved, "{added} {removed}");
    assert_eq!(counts(&few, &few), (0, 0, false));
    assert!(counts(&few, &points).1 > 0 || counts(&few, &points).0 > 0);
}

/// CMP-6: formatted and renumbered programs do what they did.
#[test]
fn formatted_and_renumbered() {
    let mut compared = [0; 2];
    for sample in samples() {
        let bytes = fs::read(sample.disk.root.join(&sample.file)).unwrap();
        let Some(steps) = of_sample(&sample) else { continue };
        let again = |text: Vec<u8>, what: &str| {
            let loader = Over { disk: &sample.disk, file: &sample.file, text };
            let session = Session { loader: &loader, settings: &sample.settings, progress: None };
            let Some(other) = self::steps(&session, &sample.file) else { panic!("{} {what}", sample.name) };
            assert_eq!(compare(&steps, &other, TOLERANCES), Comparison::default(), "{} {what}", sample.name);
        };
        if let Some(text) = formatted(&sample.file, &bytes, &sample.settings) {
            again(text, "formatted");
            compared[0] += 1;
        }
        // Each is a process.
        if compared[0] % 8 == 0 && std::str::from_utf8(&bytes).is_ok() {
            let mut command =
                Place::with(&[]).command(&["renumber", "--dialect", sample.settings.machine.dialect.name(), "-"]);
            let input = fs::File::open(sample.disk.root.join(&sample.file)).unwrap();
            let output = command.current_dir(&sample.disk.root).stdin(input).output().unwrap();
            if output.status.success() {
                again(output.stdout, "renumbered");
                compared[1] += 1;
            }
        }
    }
    assert!(compared[0] > 100 && compared[1] > 10, "{compared:?}");
}

/// The files of a sample, with another text of its program.
struct Over<'a> {
    disk: &'a TestDisk,
    file: &'a str,
    text: Vec<u8>,
}

impl Loader for Over<'_> {
    fn read(&self, path: &Path) -> std::io::Result<Vec<u8>> {
        if path == Path::new(self.file) { Ok(self.text.clone()) } else { self.disk.read(path) }
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        self.disk.list(folder)
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        self.disk.folders(folder)
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        self.disk.canonical(path)
    }
}

/// A surface of so many blocks; `z`: the depth of each.
fn surface(blocks: u32, z: impl Fn(u32) -> f64, more: impl Fn(u32) -> String) -> String {
    let block = |at: u32| format!("N{} X{} Y{} Z{:.3}\n{}", at * 10 + 50, at % 37, at % 23, z(at), more(at));
    let body: String = (0..blocks).map(block).collect();
    format!("%1\nN10 G90 G0 X0 Y0 Z50 T5 M06\nN20 S1000 M3 F200\nN30 G1 X1 Z-1\n{body}N9000000 M30\n")
}

/// CMP-2: one shift of thousands of blocks is one change with its count, also where blocks come between; what is added
/// between motions of its kind is what is far from them; tolerances.
#[test]
fn shifts_and_what_is_near() {
    let plain = |at: u32| -2.0 - f64::from(at % 7) / 10.0;
    let none = |_: u32| String::new();
    let old = of_text(&surface(10_000, plain, none));
    let differs = |new: &str, tolerances: Tolerances| {
        let changes = compare(&old, &of_text(new), tolerances).changes;
        changes
            .into_iter()
            .map(|change| (change.kind.name(), change.count(), change.what.map(String::from)))
            .collect::<Vec<_>>()
    };
    let z = || Some("Z".to_owned());
    let shifted = surface(10_000, |at| plain(at) - 0.25, none);
    assert_eq!(differs(&shifted, TOLERANCES), [("position", 10_000, z())]);
    let wide = Tolerances { position: Micro::from_millionths(250_000), percent: 0.0 };
    assert_eq!(differs(&shifted, wide), []);
    let between = surface(
        10_000,
        |at| plain(at) - 0.25,
        |at| if at == 5000 { "N51 X90 Y90\n".to_owned() } else { String::new() },
    );
    let mut found = differs(&between, TOLERANCES);
    found.sort();
    assert_eq!(found, [("added", 1, None), ("position", 10_000, z())]);
    // A few blocks, each moved a little, and one far away between them.
    let few = of_text("%1\nN10 G90 G1 X0 Y0 F100\nN20 X10 Y1\nN30 X20 Y2\nN40 X30 Y3\nN50 M30\n");
    let new = of_text("%1\nN10 G90 G1 X0 Y0 F100\nN20 X10 Y1.5\nN25 X90 Y90\nN30 X20 Y2.6\nN40 X30 Y3.7\nN50 M30\n");
    let changes = compare(&few, &new, TOLERANCES).changes;
    assert!(
        changes.iter().any(|change| change.kind.name() == "added" && change.new_blocks.n == Some((25, 25))),
        "{changes:#?}"
    );
    assert!(
        changes.iter().all(|change| change.kind.name() == "added" || change.what.as_deref() == Some("Y")),
        "{changes:#?}"
    );
}

/// CMP-3: X of a lathe has its diameter.
#[test]
fn diameters() {
    let lathe = "%1\nN10 G74 G90 G00 X100 Z50 T1 M06\nN20 S1000 M3 F200\nN30 G1 X40\nN40 G00 X100\nN50 M30\n";
    let place = Place::with(&[("a.nc", lathe.as_bytes()), ("b.nc", lathe.replace("X40", "X40.01").as_bytes())]);
    let run = place.run(&["compare", "a.nc", "b.nc"]).ends(1);
    assert!(run.stdout.contains("T1: X +0.005 (Ø +0.01) in 1 block (N30)"), "{}", run.stdout);
}

/// CMP-3, CMP-7: a summary by tool; folders as a table, a line for each program.
#[test]
fn summaries() {
    let other = OLD.replace("F200", "F250").replace("N60 G1 X30", "N60 G1 X31");
    let place = Place::with(&[
        ("old/a.nc", OLD.as_bytes()),
        ("old/sub/b.nc", OLD.as_bytes()),
        ("old/gone.nc", OLD.as_bytes()),
        ("new/a.nc", OLD.as_bytes()),
        ("new/sub/b.nc", other.as_bytes()),
        ("new/more.nc", OLD.as_bytes()),
    ]);
    let run = place.run(&["compare", "old/sub/b.nc", "new/sub/b.nc"]).ends(1);
    assert!(run.stdout.contains("\nT5: changes 2, in blocks "), "{}", run.stdout);
    let run = place.run(&["compare", "old", "new"]).ends(1);
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines[0], "a.nc      the same");
    assert_eq!((lines[1], lines[2]), ("gone.nc   removed", "more.nc   added"));
    assert!(lines[3].starts_with("sub/b.nc  changes: 2, time −"), "{}", run.stdout);
    assert_eq!(lines[4], "programs 4: same 1, different 1, added 1, removed 1, with errors 0");
    place.run(&["compare", "old", "old"]).ends(0);
    place.run(&["compare", "old", "new", "--format", "json"]).ends(2).says("--format json");
    place.run(&["compare", "old", "new/a.nc"]).ends(2).says("two folders");
    place.run(&["compare", "-", "-"]).ends(2).says("standard input can be read once only");
    place.put("new/a.nc", BAD);
    let run = place.run(&["--lang", "cs", "compare", "old", "new"]).ends(2);
    assert!(run.stdout.starts_with("a.nc      chyby\n") && run.stderr.contains("E0306"), "{run:?}");
}

const OLD: &str = "%1\nN10 G90 G0 X0 Y0 Z50 T5 M06\nN20 S1000 M3 F200\nN30 G1 X10 Z-5\nN35 Y5\nN40 G2 X20 Y15 I10 J0\nN50 M08\n\
                   N60 G1 X30\nN65 G71 L9 Q2\nN70 M30\nN100 G79 L9\nN110 G1 Z-1\nN120 G0 Z5 G70\n";

/// A planted change: kind, name, old, new, count.
fn planted(from: &str, to: &str) -> Vec<(String, u64, Option<String>)> {
    assert!(OLD.contains(from));
    let comparison = compare(&of_text(OLD), &of_text(&OLD.replace(from, to)), TOLERANCES);
    let changes = comparison.changes.iter();
    changes
        .map(|change| (change.kind.name().to_owned(), change.count(), change.what.clone().map(String::from)))
        .collect()
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
    assert_eq!(planted("N30 G1 X10", "N30 G23 G1 X10"), one("function", 10, "G23"));
    assert_eq!(planted("N50 M08\n", ""), one("function", 1, "M08"));
    // An end that is known in one program alone is no difference of so many mm.
    let known = compare(&of_text("%1\nN10 G91 X5\nN20 M30\n"), &of_text("%1\nN10 XR1\nN20 M30\n"), TOLERANCES);
    assert!(known.changes.iter().all(|change| change.delta.is_none()), "{known:#?}");
    assert_eq!(planted("Y5\n", "Y5.001\n"), []);
    // What M09 and M05 end is not there any more, which changes nothing in them.
    let ending = OLD.replace("N70 M30", "N68 M09\nN69 M05\nN70 M30");
    for (gone, word) in [("N50 M08\n", "M08"), (" M3 ", "M03")] {
        let place = ending.replacen(gone, if gone.ends_with('\n') { "" } else { " " }, 1);
        for (a, b) in [(&ending, &place), (&place, &ending)] {
            let changes = compare(&of_text(a), &of_text(b), TOLERANCES).changes;
            let named: Vec<_> = changes.iter().map(|change| (change.kind, change.what.as_deref())).collect();
            assert_eq!(named, [(ChangeKind::Function, Some(word))], "{changes:#?}");
        }
    }
    // Written once more where it holds it says nothing; where it is written earlier, it comes earlier.
    assert_eq!(planted("N60 G1 X30", "N60 G1 X30 M08"), []);
    assert_eq!(planted("N35 Y5\n", "N33 M08\nN35 Y5\n"), one("function", 1, "M08"));
    // CMP-1: how it is written does not matter.
    assert_eq!(planted("N60 G1 X30", "N60 G01 X30. F200 \"again\""), []);
    assert_eq!(planted("N65 G71 L9 Q2", "N61 G1 Z-1\nN62 G0 Z5\nN63 G1 Z-1\nN64 G0 Z5"), []);
}

/// CMP-4, CMP-5: M08 earlier is one change with both places; JSON, exit status.
/// CMP-2: positions up to the tolerance apart are the same, also where an axis would else stand still; small steps add
/// up. A shift is one change, though some of its points are points of the other program too.
#[test]
fn tolerances_and_shifts() {
    let same = |old: &str, new: &str, tolerance: &str| {
        let place = Place::with(&[("o.nc", framed(old).as_bytes()), ("n.nc", framed(new).as_bytes())]);
        let run = |one: &str, other: &str| place.run(&["compare", one, other, "--tolerance", tolerance]);
        let both = [run("o.nc", "n.nc"), run("n.nc", "o.nc")].map(|run| run.code == Some(0));
        assert_eq!(both[0], both[1], "{old:?} {new:?}");
        both[0]
    };
    let part = "G01 Z2\nX50 Y20 Z2\nX80 Y20\nX80 Y40\nX70 Y40\nG17 G02 X80 Y40 I5 J0\nG01 X99";
    for (from, to, tolerance, expected) in [
        ("Y20 Z2\n", "Y20 Z2.001\n", "0.001", true),
        ("Y20 Z2\n", "Y20 Z2.002\n", "0.001", false),
        ("Y20 Z2\n", "Y20 Z2.005\n", "0.01", true),
        ("X80 Y20\n", "X80 Y20.001\n", "0.1", true),
        ("X80 Y40\n", "X80.05 Y40\n", "0.1", true),
        ("X80 Y40\n", "X80 Y40\nX80 Y40.05\n", "0.1", true),
        ("X80 Y40\n", "X80 Y40\nX80 Y40.05\n", "0.01", false),
        ("X80 Y40 I5", "X80 Y40 Z2 I5", "0", true),
        ("X80 Y40 I5", "X80 I5", "0", true),
        ("X80 Y40 I5", "X80 Y40 Z3 I5", "0.001", false),
    ] {
        assert!(part.contains(from), "{from}");
        assert_eq!(same(part, &part.replace(from, to), tolerance), expected, "{from:?} {to:?} {tolerance}");
    }
    let drift: String = (1..9).map(|x| format!("\nX{x} Z{}", 2.0 - f64::from(x) * 0.001)).collect();
    let flat: String = (1..9).map(|x| format!("\nX{x} Z2")).collect();
    assert!(!same(&format!("G01 Z2{flat}"), &format!("G01 Z2{drift}"), "0.001"));
    for (old, new, tolerance, expected) in [
        ("G01 X5 Z0.5\nX5.28 Z0.501\nZ0.6", "G01 X5 Z0.5\nX5.28 Z0.502\nZ0.6", "0.001", true),
        ("G01 X5 Z0.5\nX5.28 Z0.501\nZ0.6", "G01 X5 Z0.5\nX5.28\nZ0.6", "0.001", true),
        ("G01 X5 Z0.5\nZ0.501\nY6", "G01 X5 Z0.5\nZ0.502\nY6", "0.001", true),
        ("G01 X5 Z0.5\nZ0.501\nY6", "G01 X5 Z0.5\nY6", "0.001", true),
        // What stands beside either of them differs by twice as much.
        ("G01 Z10.05\nX5", "G01 Z9.95\nX5", "0.05", false),
        ("G01 Z10.001\nX5", "G01 Z9.999\nX5", "0.001", false),
        ("X19.4 Z-1.346\nX19.9 Z-1.487\nX20 Z-1.514", "X19.4 Z-1.346\nX19.9 Z-1.487\nX20 Z-1.214", "0.2", false),
        // A point that is nearly one of another pass, and exactly a third one.
        ("X3\nX2\nX3\nX1", "X3.001\nX2.001\nX3\nX0.999", "0.001", true),
        ("X3\nX1\nX3\nX1", "X2.999\nX0.999\nX3\nX1.001", "0.001", true),
        ("X1\nX1", "X1.001\nX1", "0.001", true),
        ("X0.015\nX0.005", "X0.025\nX0.015", "0.01", true),
        // There and back is no motion near a place.
        ("G01 X5\nX5.5\nX5", "G01 X5", "0.1", false),
        ("G55\nG01 X5 Y0", "G55\nG01 X5", "0.1", false),
    ] {
        assert_eq!(same(old, new, tolerance), expected, "{old:?} {new:?} {tolerance}");
    }
    // The same points from another postprocessor, with one Z changed, and one point more.
    let points = |noise: u32, z: f64, more: &str| {
        let block = |at: u32| {
            let wave = f64::from(at * 7 % 13) / 10.0;
            let off = [0.0, 0.001, -0.001][(at * noise % 3) as usize];
            let lower = if at == 300 { z } else { wave - 1.0 };
            let more = if at == 600 { more } else { "" };
            format!("{more}G01 X{:.3} Y{:.3} Z{:.3}", f64::from(at) * 0.366 + off, wave - off, lower + off)
        };
        of_text(&framed(&(0..800).map(block).collect::<Vec<_>>().join("\n")))
    };
    let exact = points(0, -3.0, "");
    assert_eq!(compare(&exact, &points(1, -3.0, ""), TOLERANCES), Comparison::default());
    let changes = compare(&exact, &points(1, -3.5, "G01 Y90\n"), TOLERANCES).changes;
    let told: Vec<_> = changes.iter().map(|change| (change.kind, change.count())).collect();
    assert_eq!(told, [(ChangeKind::Position, 1), (ChangeKind::Added, 1)], "{changes:#?}");
    // N65 of the new program is N60 of the old one.
    let points = [(10, 1, -1), (11, 5, 0), (15, 9, -1), (21, 2, 0), (28, 7, -1), (10, 1, 0), (33, 8, -1), (37, 3, 0)];
    let path = |by: i32| {
        let blocks = points.map(|(x, y, z)| format!("G01 X{x} Y{y} Z{}", z - by));
        of_text(&framed(&format!("G01 Z2\n{}", blocks.join("\n"))))
    };
    let changes = compare(&path(0), &path(1), TOLERANCES).changes;
    let told: Vec<_> = changes.iter().map(|change| (change.kind, change.what.as_deref(), change.count())).collect();
    assert_eq!(told, [(ChangeKind::Position, Some("Z"), 8)]);
}

/// CMP-4: a word that is written earlier or later is one change with both places, over however many motions.
#[test]
fn words_that_moved() {
    let part = |at: usize, words: &str| {
        let mut blocks: Vec<String> = (1..8).map(|x| format!("G01 X{x} Y{}", x % 3)).collect();
        blocks.insert(at, words.to_owned());
        of_text(&framed(&format!("M08\n{}", blocks.join("\n"))))
    };
    for words in ["M09", "M05", "M09 M05", "M12 M09", "G04 Q10", "M70", "D2", "T2 M06"] {
        for (from, to) in (0..7).flat_map(|from| (0..7).map(move |to| (from, to))).filter(|(from, to)| from != to) {
            let changes = compare(&part(from, words), &part(to, words), TOLERANCES).changes;
            let told: Vec<_> = changes.iter().map(|change| (change.kind, change.what.clone())).collect();
            let moved = changes.iter().all(|change| {
                !matches!(change.kind, ChangeKind::Added | ChangeKind::Removed | ChangeKind::Position)
                    && change.old_blocks.count == change.new_blocks.count
            });
            assert!(moved && !told.is_empty(), "{words} from {from} to {to}: {told:?}");
        }
    }
}

/// A part: the frame around the blocks of a case.
fn framed(blocks: &str) -> String {
    let numbered: String = blocks.lines().enumerate().map(|(at, block)| format!("N{} {block}\n", 10 + at)).collect();
    format!("%1\nN1 G90 G54 T1\nN2 M06\nN3 S500 M03 F100\nN4 G00 X0 Y0 Z10\n{numbered}N900 M30\n")
}

/// CMP-1: what a control does differently is a change, in whatever words it hides: the meaning of S, the frame of an
/// unmapped cycle, the centre of an arc whose start nobody knows, how often a macrocycle of the machine runs, an M19
/// that turns the spindle back. The order of M words in a block and a plane without a radius correction are none.
#[test]
fn hidden_differences() {
    let settings = "[machine-macrocycles]\nL7 = {}\n[operations]\n\"01\" = \"add\"\n";
    for (old, new, expected) in [
        ("G94 S200\nG01 X10", "G96 S200\nG01 X10", "G96 none → G96"),
        ("G81 X10 Z-5\nX20\nG80", "G91 G81 X10 Z-5\nX20\nG80", "T1: G91 G90 → G91"),
        ("G81 X10 Z-5\nG80", "G18 G81 X10 Z-5\nG80", "T1: G18 G17 → G18"),
        ("G30 X0 Y0\nG02 X10 Y0 I5 J0", "G30 X0 Y0\nG02 X10 Y0 I50 J0", "I +45 in 1 block"),
        ("G30 X0 Y0\nG02 I5 J0", "G30 X0 Y0\nG02 I0 J5", "changes 2, in blocks 1"),
        ("G01 X1\nG72 L7 Q2\nG01 X10", "G01 X1\nG72 L7 Q5\nG01 X10", "G72 L7 Q2 → L7 Q5"),
        ("M19\nG00 C90\nM19\nG00 Z5", "M19\nG00 C90\nG00 Z5", "M19"),
        // After a change of origin a motion to the same words is one.
        ("G01 Z5\nG55\nG00 X0 Y0\nG01 Z0", "G01 Z5\nG55\nG01 Z0", "1 block removed"),
        ("G55\nG01 X5 Y0", "G55\nG01 X5", "Y 0 → none in 1 block"),
        ("G55\nG01 X5", "G55\nG91 G01 X5", "changes"),
        ("G55\nG02 X10 Y0 I5 J0", "G55\nG91 G02 X10 Y0 I5 J0", "changes"),
        ("G55\nG01 X5\nX5", "G55\nG01 X5", "the programs do the same"),
        // Where G93 leaves an axis, a diameter counts as one; G92 only stores its words.
        ("G74\nG93 G54 X10\nG00 X30", "G93 G54 X10\nG74\nG00 X30", "G93 G54 X5 → G54 X10"),
        ("G74\nG92 G54 X10\nG00 X30", "G92 G54 X10\nG74\nG00 X30", "the programs do the same"),
        // A whole circle is no arc of no length, and a centre that stays is no change.
        ("G91 G02 X0 Y0 I5 J0", "G91 G02 X0 Y0.001 I5 J0", "T1: G02 360° → 0.011°"),
        ("G17 G02 X10 Y0 I5 J0", "G17 G02 X5 Y5 I5 J0", "changes 2, in blocks 1"),
        // Small distances from where nobody knows come to a long way.
        ("G91 G01 A0.1\nA0.1\nA0.1", "G91 G01 A0.101\nA0.101\nA0.101", "changes 2"),
        // What a macrocycle of the machine is called with.
        ("G91\nG72 L7\nG90 X9", "G72 L7\nG90 X9", "G90 G91 → G90"),
        ("G01 X1\nG72 L7", "G01 X1\nG00\nG72 L7", "G00 G01 → G00"),
        ("R1=90\nG72 L7\nG01 X1", "R1=45\nG72 L7\nG01 X1", "R1"),
        ("R1=90\nG01 X1", "R1=45\nG01 X1", "the programs do the same"),
        ("R2=1\nG85 Z-5\nG80", "R2=9\nG85 Z-5\nG80", "R2 1 → 9"),
        // A spindle that turns does so at its speed, whatever the program does meanwhile; one that stands has none.
        ("S600\nG04 Q900\nM05", "S900\nG04 Q900\nM05", "S 600 → 900 in 1 block (N11)"),
        ("S600\nG00 X5\nG01 X6", "S900\nG00 X5\nG01 X6", "S 600 → 900 in 1 block (N12)"),
        ("S600\nG00 X5", "G96 S600\nG00 X5", "G96 none → G96"),
        ("G00 X5\nM03\nG01 X6", "M03\nG00 X5\nG01 X6", "the programs do the same"),
        ("S600\nM03\nG01 X5", "M03\nS600\nG01 X5", "the programs do the same"),
        ("M05\nG00 X5\nM03\nG01 X9", "G00 X5\nM03\nG01 X9", "\nT1: M05 M05 → none in 1 block (N10)\n"),
        ("M05\nS600 M03\nG00 X5", "M05\nM03\nS600\nG00 X5", "the programs do the same"),
        // It runs up to what is written, even when less follows at once.
        ("M05\nS9000 M03\nS900\nG01 X5", "M05\nS900 M03\nG01 X5", "T1: S 9000 → none in 1 block (N11)"),
        ("S9000\nS500\nG01 X5", "G01 X5", "T1: S 9000 → none in 1 block (N10)"),
        ("S600\nG01 X5", "S600\nS5\nS6\nS600\nG01 X5", "the programs do the same"),
        ("G01 X5\nM05", "G01 X5\nS5\nS6\nM05", "the programs do the same"),
        // Where in its block M05 acts is in no source.
        ("G01 X5 M05", "G01 X5\nM05", "T1: M05 now in N11 (was N10)"),
        ("M05\nG01 X5", "G01 X5 M05", "M05 now in"),
        ("M10\nG01 X5", "G01 X5 M10", "T1: M10 now in N10 (was N10)"),
        ("T2 M06\nG01 X5", "T2 G01 X5 M06", "T2: T now in N10 (was N10)"),
        ("M08\nG01 X5", "G01 X5 M08", "the programs do the same"),
        // What nobody knows is told by the parameter that it comes from.
        ("G01 XR10", "G01 X-R10", "T1: X R10 → -R10 in 1 block"),
        ("G01 X5 FR10", "G01 X5 FR11", "T1: F R10 → R11 in 1 block"),
        ("R12=R10\nG01 XR12", "R12=R11\nG01 XR12", "T1: X R10 → R11 in 1 block"),
        ("G02 X5 IR10", "G02 X5 IR11", "T1: I R10 → R11 in 1 block"),
        ("G00 XR10\nXR10 Y5", "G00 XR10\nXR11 Y5", "T1: X none → R11 in 1 block (N11)"),
        ("R15=2 G26 R5=01101512\nG01 XR12", "R15=3 G26 R5=01101512\nG01 XR12", "X (1 R10 2) → (1 R10 3)"),
        ("G01 XR10\nG91 XR10", "G91 G01 XR10\nG91 XR10", "X R10 → G91 R10"),
        ("G74 G01 XR10\nG75", "G75 G01 XR10\nG75", "X G74 R10 → R10"),
        ("G95 G01 X5 FR10", "G94 G01 X5 FR10", "F R10 mm/rev → R10"),
        ("G02 X20 Y0 IR10 J5", "G02 X20 Y0 IR10 J-5", "J 5 → -5"),
        ("GR10 X1\nG90 G01 X5", "GR10 X2\nG90 G01 X5", "X 1 → 2"),
        ("GR10 X1\nG90 G01 X5\nZ-20", "GR10 X1\nG90 G01 X50\nZ-40", "X 5 → 50"),
        ("GR10 X1\nG90 G01 X5 F90", "GR10 X1\nG90 G01 X5 F80", "F 90 → 80"),
        ("G81 XR10\nG80", "G82 XR10\nG80", "G8"),
        // Nothing more than that is done: a repetition, a copy, what nothing reads, where an axis has its reference
        // point.
        ("G01 X5 FR10\nX6 FR10", "G01 X5 FR10\nX6", "the programs do the same"),
        ("R12=R10\nG01 XR12", "G01 XR10", "the programs do the same"),
        ("R12=R10\nG01 X-R12", "R12=-R10\nG01 XR12", "the programs do the same"),
        ("R10=R20\nG01 X5", "R10=R21\nG01 X5", "the programs do the same"),
        ("G30 ZR10", "G30 ZR11", "the programs do the same"),
        ("M05 S600\nG04 Q900\nG00 X5", "M05 S900\nG04 Q900\nG00 X5", "the programs do the same"),
        ("M05\nM00\nG01 X1", "M05 M00\nG01 X1", "the programs do the same"),
        ("G04 Q10\nM01\nG01 X1", "G04 Q10 M01\nG01 X1", "the programs do the same"),
        ("M00\nM05\nG00 X1", "M05 M00\nG00 X1", " now in N1"),
        ("M08\nM09\nM08\nM09", "M08\nM09\nM09\nM09\nM08\nM09\nM09\nM09", "the programs do the same"),
        ("G01 X5 M08 M41\nX6", "G01 X5 M41 M08\nX6", "the programs do the same"),
        ("G01 X5 M08 M77\nX6", "M77 M08 G01 X5\nX6", "the programs do the same"),
        ("G41 D1 G01 X6\nX8\nG40 G00 X9", "G41 D1 G01 X6\nX8\nG00 X9", "G41 G40 → G41"),
    ] {
        let place = Place::with(&[
            ("o.nc", framed(old).as_bytes()),
            ("n.nc", framed(new).as_bytes()),
            ("cnc872c.toml", settings.as_bytes()),
        ]);
        let same = expected.ends_with("same");
        let run = place.run(&["compare", "o.nc", "n.nc", "--lang", "en"]).ends(i32::from(!same));
        assert!(run.stdout.contains(expected), "{old:?} {new:?}\n{}", run.stdout);
        assert!(!run.stdout.contains(": G17"), "{}", run.stdout);
    }
}

/// MFN-4, CMP-1: a function that acts at the end of its block is not one before it, one at its beginning is; a centre
/// counted from an unknown start is no centre that is known.
#[test]
fn functions_that_move_the_machine() {
    let channel = "<C><MFunctions><MFunc No='92' GroupNo='10' BreakContEnd='1'/><MFunc No='95' ChangePos='1'/>\
                   <MFunc No='96' ChangePos='1' BreakContEnd='1'/></MFunctions></C>";
    let known = "M95\nG00 X10 Y10\nG02 X20 Y20 I10 J0";
    for (old, new, same) in [
        (known, &*known.replace("X10 ", ""), false),
        ("M92\nG01 X5", "G01 X5 M92", false),
        ("G01 X5\nM92\nX6", "G01 X5 M92\nX6", true),
        ("M96\nG01 X5 Y1 Z1", "G01 X5 Y1 Z1 M96", false),
        ("G01 X5 Y1 Z1\nM96", "G01 X5 Y1 Z1 M96", true),
        ("M95\nG01 X5 Y1 Z1", "G01 X5 Y1 Z1 M95", true),
    ] {
        let settings = [("cnc872c.toml", &b"channel-config = \"ch.xml\"\n"[..]), ("ch.xml", channel.as_bytes())];
        let (old, new) = (framed(old), framed(new));
        let place = Place::with(&[("o.nc", old.as_bytes()), ("n.nc", new.as_bytes()), settings[0], settings[1]]);
        for pair in [["o.nc", "n.nc"], ["n.nc", "o.nc"]] {
            let run = place.run(&["compare", pair[0], pair[1]]).ends(i32::from(!same));
            assert!(!run.stdout.contains(": I ") && !run.stdout.contains(": J "), "{}", run.stdout);
        }
    }
}

/// CMP-1, CMP-4: a word that holds on, or whose block moves in both programs, is told beside blocks that only one has;
/// what a loop executes again is one change.
#[test]
fn words_beside_blocks_of_one_program() {
    for (old, new, expected) in [
        ("G00 X20\nG01 Y4 M08\nX3", "G01 Y4\nX3", &[("removed", 1), ("M08", 1)][..]),
        ("G01 Y4 M00\nX20\nY5", "G01 Y4\nY5", &[("M00", 1), ("removed", 1)]),
        ("G00 X20\nG01 Y4 T2 M06\nX3", "G01 Y4\nX3", &[("removed", 1), ("T", 1)]),
        ("G00 X20\nM08\nG01 Y4\nX3", "G01 Y4\nX3", &[("removed", 1), ("M08", 1)]),
        ("G00 X10\nX20\nG01 Y4 M11\nX3", "G00 X10 M11\nG01 Y4\nX3", &[("M11", 1), ("removed", 1)]),
        ("G00 X20\nM08\nY5", "G00 X19\nM08\nX20\nY5", &[("added", 1), ("M08", 1)]),
        ("G01 X5\nX6 M05\nX7\nX8", "G01 X5\nX7\nX8", &[("M05", 1), ("removed", 1)]),
        ("G01 X5\nX6 M08\nX7 M09\nX8", "G01 X5\nX8", &[("removed", 2)]),
        ("G01 X1 M08\nX2\nM08", "G01 X2\nM08", &[("removed", 1), ("M08", 1)]),
        ("G91 G01 X1\nY1\nX-1\nG73 L10 Q9", "G91 G01 X1\nY1\nZ1\nX-1\nG73 L10 Q9", &[("added", 10)]),
        ("G91 G01 X1 M08\nY1\nX-1 M09\nG73 L10 Q9", "G91 G01 X1\nY1 M08\nX-1 M09\nG73 L10 Q9", &[("M08", 10)]),
    ] {
        for mirrored in [false, true] {
            let (a, b) = if mirrored { (new, old) } else { (old, new) };
            let changes = compare(&of_text(&framed(a)), &of_text(&framed(b)), TOLERANCES).changes;
            let told = |change: &Change| {
                let name = match (change.kind, mirrored) {
                    (ChangeKind::Added, true) => "removed",
                    (ChangeKind::Removed, true) => "added",
                    (kind, _) => change.what.as_deref().unwrap_or(kind.name()),
                };
                (name.to_owned(), change.count())
            };
            let mut told: Vec<_> = changes.iter().map(told).collect();
            told.sort();
            let mut expected: Vec<_> = expected.iter().map(|(name, count)| ((*name).to_owned(), *count)).collect();
            expected.sort();
            assert_eq!(told, expected, "{a:?} {b:?}\n{changes:#?}");
        }
    }
}

/// CMP-3: a block with several changes is one block. CMP-5: of what could not be executed nobody says that it is the
/// same.
#[test]
fn blocks_counted_and_half_programs() {
    let place = Place::with(&[
        ("o.nc", framed("G01 X1 Z-1").as_bytes()),
        ("n.nc", framed("G01 X2 Z-2 F120").as_bytes()),
        ("a.nc", framed("G71 L7").as_bytes()),
        ("b.nc", framed("G71 L8").as_bytes()),
    ]);
    let run = place.run(&["compare", "o.nc", "n.nc"]).ends(1);
    assert!(run.stdout.contains("T1: changes 3, in blocks 1\n"), "{}", run.stdout);
    let run = place.run(&["compare", "a.nc", "b.nc", "--partial"]).ends(0);
    assert!(run.stdout.contains("as far as the programs could be executed"), "{}", run.stdout);
    place.run(&["compare", "a.nc", "a.nc"]).ends(2);
}

#[test]
fn on_the_command_line() {
    let earlier = OLD.replace("N50 M08\n", "").replace("N35 Y5\n", "N33 M8\nN35 Y5\n");
    let files = [("a.nc", OLD.as_bytes()), ("b.nc", earlier.as_bytes()), ("bad.nc", BAD.as_bytes())];
    let place = Place::with(&files);
    let run = place.run(&["compare", "a.nc", "b.nc"]).ends(1);
    assert!(run.stdout.contains("T5: M08 now in N33 (was N50)"), "{}", run.stdout);
    let run = place.run(&["compare", "a.nc", "b.nc", "--format", "json"]).ends(1);
    let found: Value = serde_json::from_str(&run.stdout).unwrap();
    let validator = validator_for(&schema());
    assert_eq!(validator.validate(&found), Ok(()));
    assert_eq!((&found["same"], &found["changes"][0]["old_blocks"]), (&json!(false), &json!([[5, 5]])));
    let czech = place.run(&["--lang", "cs", "compare", "a.nc", "a.nc"]).ends(0);
    assert!(czech.stdout.contains("totéž"), "{}", czech.stdout);
    place.run(&["compare", "a.nc", "bad.nc"]).ends(2);
    place.run(&["compare", "a.nc", "bad.nc", "--partial"]).ends(1);
    place.run(&["compare", "a.nc", "none.nc"]).ends(2);
    place.run(&["compare", "a.nc", "."]).ends(2);
}

/// CMP-4: the page beside the answer; what it must not take the place of; nothing is written for programs with errors.
#[test]
fn the_page() {
    let new = OLD.replace("Z-1\n", "Z-1.2\n");
    let place = Place::with(&[("a.nc", OLD.as_bytes()), ("b.nc", new.as_bytes()), ("bad.nc", BAD.as_bytes())]);
    let run = place.run(&["compare", "a.nc", "b.nc", "-o", "page.html"]).ends(1);
    assert_eq!(run.stderr, "written: page.html\n");
    assert_eq!(run.stdout, place.run(&["compare", "a.nc", "b.nc"]).ends(1).stdout);
    let page = place.read("page.html");
    let page = String::from_utf8(page).unwrap();
    assert!(page.contains("id=\"cnc872c-data\"") && page.contains("id=\"cnc872c-old\""));
    assert!(!page.contains(&place.path("").display().to_string()), "a folder of the author");
    // Written to standard output it stands alone; the same programs give the same page.
    let again = place.run(&["compare", "a.nc", "b.nc", "-o", "-"]).ends(1);
    assert!(again.stdout == page);
    place.run(&["compare", "a.nc", "a.nc", "-o", "same.html", "--format", "json"]).ends(0);
    for (arguments, says) in [
        (["a.nc", "bad.nc", "-o", "none.html"], "E0306"),
        (["a.nc", "b.nc", "-o", "a.nc"], ".nc"),
        (["a.nc", "b.nc", "-o", "page.json"], ".json"),
        ([".", ".", "-o", "none.html"], "-o"),
    ] {
        let arguments: Vec<&str> = ["compare"].into_iter().chain(arguments).collect();
        place.run(&arguments).ends(2).says(says);
    }
    assert!(!place.path("none.html").exists() && place.read("a.nc") == OLD.as_bytes());
    place.run(&["compare", "a.nc", "bad.nc", "--partial", "-o", "partial.html"]).ends(1);
    assert!(place.path("partial.html").exists());
}
