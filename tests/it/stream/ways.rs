//! A record needs no other one: it repeats where its motion starts, why it has no length, what its feed counts, the
//! tool in the spindle, the lines of its calls (block-stream.md).

use std::collections::BTreeMap;

use super::*;

fn raw(program: &str, args: &str, config: &str) -> Vec<Value> {
    case(program).args(args).config(config).whole().of("block")
}

/// MOT-2, MOT-7, MOT-8: where the axes that move stand before, and why a length is missing.
#[test]
fn starts_and_missing_lengths() {
    let found =
        raw("%1\nN1 F100\nN10 G0 X1 Y2\nN20 G91 X3 Z1\nN30 G90 G54 X9\nN40 G2 X11 I1\nN50 G30 X0\nN60 M30", "", "");
    let motions: Vec<Value> = found.iter().map(|block| block["motion"].clone()).collect();
    assert_eq!(motions[1], json!({"type": "rapid", "axes": ["X", "Y"], "length_missing": "start"}));
    assert_eq!(
        motions[2],
        json!({"type": "rapid", "axes": ["X", "Z"], "start": {"X": 1}, "delta": {"Z": 1}, "length_mm": 3.162_278})
    );
    assert_eq!(motions[3], json!({"type": "rapid", "axes": ["X"], "start": {"X": 4}, "length_missing": "origin"}));
    assert_eq!(motions[4]["start"], json!({"X": 9, "Y": 2}));
    assert_eq!(
        motions[5],
        json!({"type": "reference", "axes": ["X"], "start": {"X": 11}, "length_missing": "reference"})
    );
}

/// TEC-1, TEC-5, TEC-6, MOT-6: what the feed counts, and M37.
#[test]
fn feeds() {
    let found = raw(
        "%1\nN1 G0 X0 C0 S100 M3\nN10 X1\nN20 F100 M37\nN30 G1 C90\nN40 X1 C0\nN50 X2 C90\nN60 G95 F0.2 X3\nN70 C0\nN80 M30",
        "--dialect=cnc8x9",
        "",
    );
    assert_eq!(
        column(&found, "feed_unit"),
        json!([null, null, "mm/min", "deg/min", "deg/min", "mm/min", "mm/rev", "deg/rev", "mm/rev"])
    );
    assert_eq!(column(&found, "feed_scale"), json!([null, null, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01]));
    assert_eq!(found[4]["motion"]["length_deg"], 90);
    assert_eq!(found[5]["motion"]["length_mm"], 1);
}

/// MFN-10: the spindle as an axis goes by degrees per minute, under G95 too. MOT-8: an axis moves from where an origin
/// left it, though its number stays; by a distance of 0 it does not.
#[test]
fn feeds_of_the_spindle_and_behind_origins() {
    let found = raw("%1\nN1 G95 F2 S100 M19\nN2 G1 C90\nN3 X1 C0\nN4 M30", "", "");
    assert_eq!(column(&found, "feed_unit"), json!(["mm/rev", "deg/min", "mm/rev", "mm/rev"]));
    let found = raw("%1\nN1 G1 X0 A0 F600\nN2 G54\nN3 X0 A9\nN4 X0 A8\nN5 G91 G55 X0 A1\nN6 M30", "", "");
    assert_eq!(column(&found, "feed_unit"), json!(["mm/min", "mm/min", "mm/min", "deg/min", "deg/min", "mm/min"]));
}

/// TEC-1, MOT-8: so does the feed of G30, by the axes that it moves, whatever the lengths are.
#[test]
fn feeds_of_reference_motions() {
    for start in [0, 5] {
        let program = format!("%1\nN10 G00 X0 Z{start} A3 F100\nN20 G91\nN30 G30 Z0 A0\nN40 G30 A0\nN50 M30");
        let found = raw(&program, "", "");
        assert_eq!(found[2]["motion"]["type"], "reference");
        assert_eq!(column(&found, "feed_unit"), json!(["mm/min", "mm/min", "mm/min", "deg/min", "mm/min"]), "{start}");
    }
}

/// TEC-4: the tool in the spindle is T at the last M06.
#[test]
fn tool() {
    let found = raw("%1\nN10 T5\nN20 M6\nN30 T6\nN40 T7 M6\nN50 M30", "", "");
    assert_eq!(column(&found, "tool"), json!([null, 5, 5, 7, 7]));
    assert_eq!(column(&found, "t"), json!([5, 5, 6, 7, 7]));
}

/// The line of each calling block.
#[test]
fn lines_of_calls() {
    let found = raw("%1\n\nN10 G71 L5\nN20 M30\nN30 G79 L5\nN40 G70", "", "");
    assert_eq!(found[1]["calls"], json!([{"by": "G71", "l": 5, "file": 0, "n": 10, "line": 3, "pass": 1, "of": 1}]));
}

/// The first record holds what the stream was made for.
#[test]
fn what_the_stream_was_made_for() {
    let config = format!(
        "spindle-axis = \"none\"\ng97 = \"per-revolution\"\narc-centers = \"plane-order\"\n[start]\nX = 1.5\n[parameters]\n\
         R10 = -2.5\n[cycles]\nG81 = 8100\n[limits]\narc-tolerance = 0.02\n{GEARS}"
    );
    let stream = case("%1 \"a\"\n\"b\"\nN10 M30").config(&config).whole();
    assert_fields(
        &stream.records[0],
        &json!({"title": "a", "comments": ["a", "b"], "start": {"X": 1.5}, "parameters": {"R10": -2.5},
            "cycles": {"G81": 8100}, "gears": [{"m": 41, "min": 20, "max": 500}, {"m": 42, "min": 400, "max": 2000}],
            "g97": "per-revolution", "arc_centers": "plane-order", "arc_tolerance": 0.02, "spindle_axis": null}),
    );
}

/// One name has one type in all records, whatever its depth, so that table readers take the stream.
#[test]
fn one_type_for_a_name() {
    let schema = cnc872c::stream::schema();
    let mut types = BTreeMap::new();
    for (record, definition) in schema["$defs"].as_object().expect("definitions") {
        for (name, property) in definition["properties"].as_object().expect("properties") {
            let kind = property["type"].as_str().unwrap_or("object").to_owned();
            let (first, known) = types.entry(name.clone()).or_insert_with(|| (record.clone(), kind.clone()));
            assert_eq!(*known, kind, "`{name}` of {first} and {record}");
        }
    }
    assert_eq!(schema["$defs"].as_object().map(serde_json::Map::len), Some(4));
}
