//! `stats` on the real binary: rows, forms, the cache.

use std::fs;

use serde_json::{Value, json};

use crate::cli::{BAD, Place};
use crate::json_schema::validator_for;

fn place() -> Place {
    Place::with(&[
        ("in/a.nc", b"%7 \"DIL\"\nN10 G54 G90 G0 X0 Y0\nN20 T25 M06\nN30 G1 X30 F100 M52\nN40 G72 L9 Q2\nN50 M30\n"),
        ("in/L9", b"N5 G79 L9\nN10 G1 Y10 H3\nN20 G70\n"),
        ("in/bad.nc", BAD.as_bytes()),
        ("in/notes.txt", b"no program"),
    ])
}

fn programs(text: &str) -> Vec<Value> {
    let document: Value = serde_json::from_str(text).unwrap();
    let validator = validator_for(&cnc872c::stats::schema());
    assert!(validator.is_valid(&document), "{document}");
    assert_eq!(document["schema"], "cnc872c.stats/1");
    document["programs"].as_array().unwrap().clone()
}

#[test]
fn rows() {
    let place = place();
    let run = place.run(&["stats", "in", "--format", "json"]).ends(0);
    let found = programs(&run.stdout);
    let names: Vec<&Value> = found.iter().map(|row| &row["path"]).collect();
    assert_eq!(names, ["in/a.nc", "in/bad.nc"], "macrocycles have no row");
    let row = &found[0];
    assert_eq!((&row["number"], &row["title"], &row["dialect"]), (&json!(7), &json!("DIL"), &json!("cnc872")));
    assert_eq!((&row["blocks"], &row["executed"]), (&json!(5), &json!(11)));
    assert_eq!((&row["tools"], &row["h"], &row["macrocycles"]), (&json!([25]), &json!([3]), &json!([9])));
    assert!(row["m"].as_array().unwrap().contains(&json!(52)));
    assert_eq!(row["extents"]["all"], json!({"X": [0, 30], "Y": [0, 10]}));
    assert_eq!(row["path_mm_by_type"]["linear"], json!(40));
    assert_eq!(row["hash"].as_str().unwrap().len(), 64);
    assert!(found[1]["findings"].as_object().unwrap().keys().any(|code| code.starts_with('E')));
    assert_eq!(found[1].get("time_s"), None);
    let csv = place.run(&["stats", "in", "--format", "csv"]).ends(0).stdout;
    assert_eq!(csv.lines().count(), 3);
    assert_eq!(csv.lines().next().unwrap().split(',').count(), 21);
    let human = place.run(&["stats", "in"]).ends(0).stdout;
    assert!(human.starts_with("in/a.nc  %7 \"DIL\"  5 → 11"), "{human}");
    let missing = place.run(&["stats", "in/notes.txt", "missing.nc"]).ends(2);
    assert!(missing.stderr.contains("missing.nc"), "{missing:?}");
    place.run(&["stats", "in", "-o", "in/a.nc"]).ends(2);
    let schema = place.run(&["schema", "stats"]).ends(0).stdout;
    assert_eq!(serde_json::from_str::<Value>(&schema).unwrap(), cnc872c::stats::schema());
}

/// Known rows come from the cache, and only while it holds.
#[test]
fn the_cache() {
    let place = place();
    let cached = || place.run(&["stats", "in", "--format", "json", "--cache", "cache"]).ends(0);
    let plain = || programs(&place.run(&["stats", "in", "--format", "json"]).ends(0).stdout);
    let files = || {
        let mut files: Vec<_> = fs::read_dir(place.path("cache")).unwrap().map(|entry| entry.unwrap().path()).collect();
        files.sort();
        files
    };
    assert_eq!(programs(&cached().stdout), plain());
    let before = files();
    assert_eq!(before.len(), 1);
    assert_eq!(programs(&cached().stdout), plain());
    assert_eq!(files(), before, "nothing is new");
    // A row that the cache alone can have.
    let text = fs::read_to_string(&before[0]).unwrap();
    // A macrocycle is another: the row too.
    fs::write(place.path("in/L9"), "N5 G79 L9\nN10 G1 Y25 H4\nN20 G70\n").unwrap();
    assert_eq!(programs(&cached().stdout), plain());
    assert_eq!(plain()[0]["h"], json!([4]));
    assert_eq!(files().len(), 2);
    // Another configuration.
    fs::write(place.path("cnc872c.toml"), "[motion]\naccel-mm-s2 = 3\n").unwrap();
    assert_eq!(programs(&cached().stdout), plain());
    fs::remove_file(place.path("cnc872c.toml")).unwrap();
    // Damaged lines are noticed and made anew; half a file is what a disk that is full leaves.
    for damaged in [text.replace("\"h\":[3]", "\"h\":[8]"), text[..text.len() / 2].to_owned(), "\u{0}\n".to_owned()] {
        fs::write(place.path("in/L9"), "N5 G79 L9\nN10 G1 Y10 H3\nN20 G70\n").unwrap();
        fs::remove_dir_all(place.path("cache")).unwrap();
        cached();
        fs::write(&before[0], damaged).unwrap();
        let run = cached();
        assert!(run.stderr.contains("damaged"), "{run:?}");
        assert_eq!(programs(&run.stdout), plain());
        assert_eq!(cached().stderr, "", "what was damaged is gone");
    }
}

/// A run that is killed leaves what it wrote, and the next one goes on from there.
#[test]
fn a_killed_run_leaves_a_good_cache() {
    let place = Place::with(&[]);
    fs::create_dir(place.path("in")).unwrap();
    for number in 0..2500 {
        place.put(&format!("in/{number:04}.nc"), format!("%1\nN10 G90 G0 X{number}\nN20 G1 X0 F100\nN30 M30\n"));
    }
    let entries = || fs::read_dir(place.path("cache")).map(Iterator::count).unwrap_or(0);
    let mut child =
        place.command(&["stats", "in", "--format", "csv", "-o", "out", "--cache", "cache"]).spawn().unwrap();
    while entries() == 0 && child.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let _ = child.kill();
    child.wait().unwrap();
    assert!(entries() > 0);
    let cached = place.run(&["stats", "in", "--format", "csv", "--cache", "cache"]).ends(0);
    assert_eq!(cached.stderr, "", "nothing is damaged");
    assert_eq!(cached.stdout, place.run(&["stats", "in", "--format", "csv"]).ends(0).stdout);
}

/// A table takes the place of no file that the run reads, macrocycles included. A program whose file is named as a
/// macrocycle is one (PRG-6).
#[test]
fn macrocycles_and_their_names() {
    let files: [(&str, &[u8]); 3] = [
        ("a.nc", b"%1\nN1 G72 L7\nN2 M30\n"),
        ("L7", b"N10 G79 L7\nN20 G70\n"),
        ("L12.nc", b"%4\nN1 G90 G00 X1\nN2 M30\n"),
    ];
    let place = Place::with(&files);
    for arguments in [&["a.nc"][..], &["."], &["a.nc", "--cache", "c"], &["a.nc", "--cache", "c"]] {
        let run = place.run(&[&["stats", "-o", "L7"], arguments].concat()).ends(2);
        assert!(run.stderr.contains("L7"), "{run:?}");
        assert_eq!(place.read("L7"), files[1].1);
    }
    let names = |path: &str| -> Vec<String> {
        let rows = programs(&place.run(&["stats", path, "--format", "json"]).ends(0).stdout);
        rows.iter().map(|row| row["path"].as_str().unwrap().trim_start_matches("./").to_owned()).collect()
    };
    assert_eq!(
        (names("L12.nc"), names(".")),
        (vec!["L12.nc".to_owned()], vec!["L12.nc".to_owned(), "a.nc".to_owned()])
    );
    place.run(&["stats", "L7", "--lang", "en"]).ends(2).says("L7 is a macrocycle: it has no row of its own");
    place.put("new/L12.nc", "%4\nN1 G90 G00 X2\nN2 M30\n");
    place.put("new/L7", "N10 G79 L7\nN20 G70\n");
    place.put("old/L12.nc", "%4\nN1 G90 G00 X1\nN2 M30\n");
    assert!(place.run(&["compare", "old", "new", "--lang", "en"]).ends(1).stdout.contains("L12.nc"));
}
