//! Blocks whose words are data, cycles, the spindle as an axis (GRP-4…GRP-8, MFN-10).

use super::*;

/// Blocks that write tables and transformations (GRP-4, §13 Records).
#[test]
fn data_blocks() {
    let found = from_zero(
        "",
        "N10 G92 G54 X10 Y-20.5\nN20 G92 D5 X1\nN30 G92 D6 G55 Z1\nN40 G92 X2\nN50 G91 G93 X5\nN55 G90 G74\nN60 G93 X5\nN65 G75\n\
         N70 G31 X1 I2 J3 K4\nN80 G36 X0\nN90 G92 G37 X3\nN100 G37 G92 X3\nN110 G93\nN120 G38\nN130 G93 G59 D7 A1\n\
         N140 G31 D8 X1\nN150 X9",
    );
    let data = column(&found, "data");
    assert_eq!(
        data,
        json!([
            {"g": 92, "origin": 54, "values": {"X": 10, "Y": -20.5}},
            {"g": 92, "d": 5, "values": {"X": 1}},
            {"g": 92, "origin": 55, "d": 6, "values": {"Z": 1}},
            {"g": 92, "origin": 55, "values": {"X": 2}},
            {"g": 93, "origin": 55, "values": {"X": 5}},
            null,
            {"g": 93, "origin": 55, "values": {"X": 5}},
            null,
            {"g": 31, "values": {"X": 1, "I": 2, "J": 3, "K": 4}},
            {"g": 36, "values": {"X": 0}},
            {"g": 92, "origin": 55, "values": {"X": 3}},
            {"g": 37, "origin": 55, "values": {"X": 3}},
            {"g": 93, "origin": 55},
            {"g": 38},
            {"g": 93, "origin": 59, "d": 7, "values": {"A": 1}},
            {"g": 31, "d": 8, "values": {"X": 1}},
            null
        ])
    );
    assert!(found[..16].iter().all(|block| block.get("motion").is_none()));
    assert!(found.iter().all(|block| block.get("words").is_none()));
    assert_eq!(column(&found, "d"), json!([null, 5, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 7, 8, 8]));
    let xs: Value = found.iter().map(|block| block["position"]["X"].clone()).collect();
    assert_eq!(xs, json!([0, 0, 0, 0, 5, 5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 2.5, 9]));
    assert_eq!(found[15]["position"]["A"], 1);
    assert_eq!(case("%1\nN10 G92 X1 I1\nN20 M30").run().errors, ["E0609"]);
}

/// The dynamic set (GRP-7, §13 Motion).
#[test]
fn dynamic_sets() {
    let found = from_zero(
        "",
        "N10 G01 X1\nN20 G23 I2\nN30 X2\nN40 G24\nN50 G23 I4 X3\nN60 G23\nN70 G02 X5 Y0 I1 J0 G23\nN80 G23 I1\nN90 G98",
    );
    assert_eq!(column(&found, "dynamic_set"), json!([null, 2, 2, null, 4, 4, 4, 1, null]));
    assert_eq!(column(&found, "continuous_mode"), json!([null, true, true, null, true, true, true, true, null]));
    assert_eq!(found[6]["motion"]["center"], json!({"X": 4, "Y": 0}));
    assert_eq!(found[7].get("motion"), None);
    assert!(found.iter().all(|block| block.get("words").is_none()));
}

/// I, J and K of G09, G10, G33 and fixed cycles go into the record as they are (GRP-8, §13 More).
#[test]
fn words_as_written() {
    let found = from_zero(
        "",
        "N10 G33 Z-10 K1.5\nN20 Z-20 I2 J3 K4\nN30 G00 G10 Z0 K5\nN40 G09 G02 X2 Y0 Z1 I1 J0 K2\nN50 G98 G01 G81 Z-5 K7\nN60 I8\n\
         N70 G80 X9",
    );
    assert_eq!(
        column(&found, "words"),
        json!([{"K": 1.5}, {"I": 2, "J": 3, "K": 4}, {"K": 5}, {"I": 1, "J": 0, "K": 2}, {"Z": -5, "K": 7}, {"I": 8}, null])
    );
    assert_eq!(found[0]["motion"], json!({"type": "thread", "axes": ["Z"], "length_mm": 10}));
    assert_eq!(found[3]["motion"]["center"], json!({"X": 1, "Y": 0}));
    assert_eq!(entries(&found, "g", 8), json!([80, 80, 80, 80, 81, 81, 80]));
}

/// A mapped cycle calls its macrocycle after each motion; which blocks are exempt (GRP-6, §13 Checking).
#[test]
fn mapped_cycles() {
    let stream = case(
        "%1\nN10 G81\nN20 X1 Y0 F100 S100\nN30 M03\nN40 G30 X0\nN50 G92 X1\nN60 G02 I1\nN70 G01 X2\nN80 G80 X3\nN90 G82 X4\n\
         N100 G80\nN110 M30",
    )
    .config(CYCLES)
    .with("L8100", "N1 G79 L8100\nN2 Z-1\nN3 G70")
    .with("L8200", "N1 G79 L8200\nN2 G70")
    .run();
    // The full circle of N60 starts at an X that G30 left unknown.
    assert!(stream.errors.is_empty(), "{:?}", stream.errors);
    let found = stream.blocks();
    assert_eq!(column(&found, "n"), json!([10, 20, 1, 2, 3, 30, 40, 50, 60, 70, 1, 2, 3, 80, 90, 1, 2, 100, 110]));
    assert_eq!(
        entries(&found, "g", 8),
        json!([81, 81, 80, 80, 80, 81, 81, 81, 81, 81, 80, 80, 80, 80, 82, 80, 80, 80, 80])
    );
    assert_eq!(found[3]["calls"], json!([{"by": "G81", "l": 8100, "file": 0, "n": 20, "pass": 1, "of": 1}]));
    assert_eq!(found[16]["calls"], json!([{"by": "G82", "l": 8200, "file": 0, "n": 90, "pass": 1, "of": 1}]));
    assert_eq!(column(&stream.of("file"), "name"), json!(["L8100", "L8200"]));
}

/// Inside the macrocycle of a cycle a G8 function holds and calls nothing; afterwards the cycle is in force again.
#[test]
fn cycles_inside_cycles() {
    let found = case("%1\nN10 G81 X0\nN20 G71 L50\nN30 X2\nN40 M30\nN50 G79 L50\nN60 X1\nN70 X2 G70")
        .config(CYCLES)
        .with("L8100", "N1 G79 L8100\nN2 Z-1\nN3 G82 Z1\nN4 G72 L9\nN5 Z5\nN6 G70")
        .with("L8200", "N1 G79 L8200\nN2 G70")
        .with("L9", "N1 G79 L9\nN8 Z2\nN9 G81 Z2 G70")
        .blocks();
    let inside = [1, 2, 3, 4, 1, 8, 9, 5, 6];
    let mut expected = vec![10];
    expected.extend(inside);
    expected.extend([20, 50, 60]);
    expected.extend(inside);
    expected.push(70);
    expected.extend(inside);
    expected.push(30);
    expected.extend(inside);
    expected.push(40);
    assert_eq!(column(&found, "n"), json!(expected));
    let cycle = json!([80, 80, 82, 82, 82, 82, 81, 81, 81]);
    assert_eq!(entries(&found[1..10], "g", 8), cycle);
    assert_eq!(entries(&found[10..13], "g", 8), json!([81, 81, 81]));
    assert_eq!(entries(&found[13..22], "g", 8), cycle);
    assert_eq!(entries(&found[22..23], "g", 8), json!([81]));
    let sub = json!({"by": "G71", "l": 50, "file": 0, "n": 20, "pass": 1, "of": 1});
    let by = |n: u32| json!({"by": "G81", "l": 8100, "file": 0, "n": n, "pass": 1, "of": 1});
    assert_eq!(found[14]["calls"], json!([sub, by(60)]));
    // The G70 block calls the cycle before its unit ends.
    assert_eq!(found[24]["calls"], json!([sub, by(70)]));
    let nine = json!({"by": "G72", "l": 9, "file": 1, "n": 4, "pass": 1, "of": 1});
    assert_eq!(found[6]["calls"], json!([by(10), nine]));
    assert_eq!(found[42]["g"][8], 81);
}

/// A G70 block that calls a cycle ends one pass of its unit, a macrocycle too.
#[test]
fn cycle_in_the_last_block_of_a_pass() {
    let found = case("%1\nN10 G81\nN20 G72 L9 Q2\nN30 M30")
        .config(CYCLES)
        .with("L9", "N1 G79 L9\nN2 G91 X1 G70")
        .with("L8100", "N1 G79 L8100\nN3 G73 L3\nN4 G70")
        .blocks();
    let pass = [1, 2, 1, 3, 3, 4];
    let expected: Vec<u32> = [10, 20].into_iter().chain(pass).chain(pass).chain([30]).collect();
    assert_eq!(column(&found, "n"), json!(expected));
    let depth: Vec<usize> = found.iter().map(|block| block["calls"].as_array().map_or(0, Vec::len)).collect();
    assert_eq!(depth, [0, 0, 1, 1, 2, 2, 2, 2, 1, 1, 2, 2, 2, 2, 0]);
    let passes: Value = found.iter().map(|block| block["calls"][0]["pass"].clone()).collect();
    assert_eq!(passes, json!([null, null, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, null]));
    assert_eq!(found[14]["g"][8], 81);
}

/// A cycle that nobody mapped calls nothing (GRP-6).
#[test]
fn unmapped_cycle() {
    let found = case("%1\nN10 G83 X0\nN20 X2\nN30 M30").config(CYCLES).blocks();
    assert_eq!(entries(&found, "g", 8), json!([83, 83, 83]));
}

/// A mapped cycle beside a call, a jump or the end of the program (GRP-6, §13 Checking).
#[test]
fn cycle_and_flow() {
    let errors = |lines: &str| {
        case(&format!("%1\n{lines}\nN90 M30\nN91 G79 L91\nN92 G70"))
            .config(CYCLES)
            .with("L8100", "N1 G79 L8100\nN2 G70")
            .with("L8200", "N1 G79 L8200\nN2 G70")
            .run()
            .errors
    };
    assert_eq!(errors("N10 G81 X1 G71 L91"), ["E0307"]);
    assert_eq!(errors("N10 G81\nN20 X1 G73 L90"), ["E0307"]);
    assert!(errors("N10 G81\nN20 G71 L91").is_empty());
    let end = case("%1\nN10 G81 X1 M30").config(CYCLES).with("L8100", "N1 G79 L8100\nN2 G70").run();
    assert_eq!(end.errors, ["E0413"]);
}

/// A macrocycle that only the machine has: the calling block keeps its position, the next one knows what was not moved
/// (FLW-12).
#[test]
fn macrocycles_of_the_machine() {
    let machine =
        "[machine-macrocycles]\nL9001 = {}\n[machine-macrocycles.L9002]\naxes = [\"Z\"]\n[cycles]\nG81 = 9002\n";
    let program = "%1\nN10 G0 X0 Y0 Z5 F100\nN20 G72 L9002 Q3\nN30 G1 X10\nN40 G81 Y1\nN50 G80 X20 G72 L9001\nN60 G91 X5\n\
                   N70 G90 G71 L5\nN80 M30\nN90 G79 L5\nN100 X1 G72 L9001\nN110 G70";
    let found = case(program).config(machine).blocks();
    let calls = column(&found, "opaque_call");
    assert_eq!(calls, json!([null, 9002, null, 9002, 9001, null, null, null, 9001, null, null]));
    let positions = column(&found, "position");
    assert_eq!(positions[1], json!({"X": 0, "Y": 0, "Z": 5}));
    assert_eq!(positions[2], json!({"X": 10, "Y": 0}));
    assert_eq!(positions[4], json!({"X": 20, "Y": 1}));
    assert_eq!(positions[5], Value::Null);
    assert_eq!((&positions[8], &positions[9]), (&json!({"X": 1}), &Value::Null));
    assert_eq!(found[4]["motion"]["length_mm"], 10);
    let stream = case(program).config(machine).run();
    assert_eq!(stream.codes, ["W0612"]);
    let undeclared = case("%1\nN10 G72 L9002\nN20 M30").config("[machine-macrocycles]\nL9001 = {}").run();
    assert_eq!(undeclared.errors, ["E0405"]);
    let as_subprogram = case("%1\nN10 G71 L9001\nN20 M30").config("[machine-macrocycles]\nL9001 = {}").run();
    assert_eq!(as_subprogram.errors, ["E0404"]);
}

/// MFN-10, MFN-8: M00 under M19 stops the program behind its motion, which ends where it is programmed; START puts the
/// spindle at 0 again.
#[test]
fn a_stop_of_an_oriented_spindle() {
    let found = case("%1\nN10 G00 C0 S100\nN15 M19\nN20 C720\nN40 G91 C-90 M00\nN50 C10\nN60 M30").whole().of("block");
    assert_eq!(found[2]["position"]["C"], 720);
    assert_eq!(found[3]["position"]["C"], 630);
    assert_eq!(found[3]["motion"]["start"]["C"], 720);
    assert_eq!(found[3]["motion"]["length_deg"], 90);
    assert_eq!(found[3]["stop"], true);
    assert_eq!(found[4]["motion"]["start"]["C"], 0);
    assert_eq!(found[4]["position"]["C"], 10);
}

/// M19: the spindle is an axis until M03, M04 or M05 (MFN-10, §13 M functions).
#[test]
fn oriented_spindle() {
    let found = blocks(
        "%1\nN10 C0 A0\nN20 M19 C90\nN30 A10\nN40 X0 C100\nN50 M05 C110\nN60 C120\nN70 M19\nN80 G01 C0 F10\nN90 M30",
    );
    // M19 puts the spindle at 0; M05 in force again leaves it anywhere.
    let motions = column(&found, "motion");
    assert_eq!(motions[1], json!({"type": "rapid", "axes": ["C"], "length_deg": 90, "spindle_axis": "C"}));
    assert_eq!(motions[2], json!({"type": "rapid", "axes": ["A"], "length_deg": 10}));
    assert_eq!(motions[3], json!({"type": "rapid", "axes": ["X", "C"], "spindle_axis": "C"}));
    assert_eq!(motions[4], json!({"type": "rapid", "axes": ["C"]}));
    assert_eq!(motions[5], json!({"type": "rapid", "axes": ["C"], "length_deg": 10}));
    assert_eq!(motions[7], json!({"type": "linear", "axes": ["C"], "length_deg": 0, "spindle_axis": "C"}));
    assert_eq!(found[4]["position"]["C"], 110);
    assert_eq!(found[6]["position"]["C"], 0);
    assert_eq!(entries(&found, "m", 2), json!([5, 19, 19, 19, 5, 5, 19, 19, 5]));
    let linear = "[[axes]]\nletter = \"X\"\nkind = \"linear\"\n[[axes]]\nletter = \"B\"\nkind = \"linear\"\n\
        [[axes]]\nletter = \"A\"\nkind = \"linear\"\n";
    let found = case("%1\nN10 A0 B0\nN20 A5 B5\nN30 M19 A9\nN40 M30").config(linear).blocks();
    assert_eq!(found[1]["motion"]["length_mm"], json!(7.071_068));
    assert_eq!(found[2]["motion"], json!({"type": "rapid", "axes": ["A"], "length_deg": 9, "spindle_axis": "A"}));
}
