//! Dwell, jumps and calls (§6).

use super::*;

/// Dwell beside a motion, a call and a jump: Q is its time, and the call or jump has k = 1 (GRP-5, FLW-6).
#[test]
fn dwell() {
    let stream = case(
        "%1\nN10 X0\nN20 G04 Q150 X3\nN30 G04 Q0\nN40 G04 Q9999. G71 L100\nN50 G04 Q7 G73 L50\nN60\nN70 G04 Q5 G73 L90\n\
         N80 M99\nN90 G73 L70 Q2\nN100 M30\nN200 G79 L100\nN210 G70",
    )
    .whole();
    let found = stream.blocks();
    assert_eq!(column(&found, "n"), json!([10, 20, 30, 40, 200, 210, 50, 50, 60, 70, 90, 70, 80, 90, 70, 90, 100]));
    assert_eq!(
        column(&found, "dwell_s"),
        json!([null, 1.5, 0, 99.99, null, null, 0.07, 0.07, null, 0.05, null, 0.05, null, null, 0.05, null, null])
    );
    assert_eq!(found[1]["motion"], json!({"type": "rapid", "axes": ["X"], "length_mm": 3}));
    assert_eq!(found[4]["calls"], json!([{"by": "G71", "l": 100, "file": 0, "n": 40, "pass": 1, "of": 1}]));
    let once = json!({"to": 90, "left": 0});
    let back = |left: u32| json!({"to": 70, "left": left});
    assert_eq!(
        column(&found, "jump"),
        json!([NULL, NULL, NULL, NULL, NULL, NULL, {"to": 50, "left": 0}, NULL, NULL, once, back(1), NULL, NULL, back(0),
            once, NULL, NULL])
    );
    assert_eq!(stream.codes.iter().filter(|code| *code == "W0412").count(), 3);
}

fn jumps(found: &[Value]) -> Vec<(u64, Value)> {
    found.iter().map(|block| (block["n"].as_u64().unwrap(), block["jump"].clone())).collect()
}

/// An inner loop runs in full in every pass of an outer one (FLW-3, FLW-4).
#[test]
fn nested_jumps() {
    let found = blocks("%1\nN10\nN20 G73 L10 Q2\nN30 G73 L10 Q1\nN40 M30");
    let to = |left: u32| json!({"to": 10, "left": left});
    let inner = [(10, NULL), (20, to(1)), (10, NULL), (20, to(0)), (10, NULL), (20, NULL)];
    let mut expected = inner.to_vec();
    expected.push((30, to(0)));
    expected.extend(inner);
    expected.extend([(30, NULL), (40, NULL)]);
    assert_eq!(jumps(&found), expected);
}

/// Backward without Q once, forward without Q always and uncounted, to the own block backward (FLW-3).
#[test]
fn jumps_without_repeats() {
    let found = blocks("%1\nN10 G73 L30\nN20\nN30 G73 L10\nN40 G73 L40 Q2\nN50 G73 L50\nN60 M30");
    assert_eq!(
        jumps(&found),
        [
            (10, json!({"to": 30})),
            (30, json!({"to": 10, "left": 0})),
            (10, json!({"to": 30})),
            (30, NULL),
            (40, json!({"to": 40, "left": 1})),
            (40, json!({"to": 40, "left": 0})),
            (40, NULL),
            (50, json!({"to": 50, "left": 0})),
            (50, NULL),
            (60, NULL),
        ]
    );
}

/// A forward jump with Q counts, and falls through after its k jumps (FLW-4).
#[test]
fn counted_forward_jump() {
    let found = blocks("%1\nN10 G73 L30 Q1\nN20\nN30 G73 L10 Q3\nN40 M30");
    assert_eq!(
        jumps(&found),
        [
            (10, json!({"to": 30, "left": 0})),
            (30, json!({"to": 10, "left": 2})),
            (10, NULL),
            (20, NULL),
            (30, json!({"to": 10, "left": 1})),
            (10, json!({"to": 30, "left": 0})),
            (30, json!({"to": 10, "left": 0})),
            (10, NULL),
            (20, NULL),
            (30, NULL),
            (40, NULL),
        ]
    );
}

/// Counters belong to one execution of their unit, each pass of a call being one (FLW-4).
#[test]
fn counters_of_a_pass() {
    let found =
        blocks("%1\nN10 G71 L100 Q2\nN20 M30\nN100 G79 L100\nN110 G73 L130 Q5\nN120 M20\nN130 G73 L130 Q1\nN140 G70");
    let pass = [
        (100, NULL),
        (110, json!({"to": 130, "left": 4})),
        (130, json!({"to": 130, "left": 0})),
        (130, NULL),
        (140, NULL),
    ];
    let mut expected = vec![(10, NULL)];
    expected.extend(pass.clone());
    expected.extend(pass);
    expected.push((20, NULL));
    assert_eq!(jumps(&found), expected);
    let passes: Value = found.iter().map(|block| block["calls"][0]["pass"].clone()).collect();
    assert_eq!(passes, json!([null, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, null]));
}

/// A loop that is left by another jump keeps its counter (FLW-4).
#[test]
fn counter_of_a_loop_that_was_left() {
    let found = blocks("%1\nN10\nN20 G73 L40 Q1\nN30 G73 L10 Q3\nN40 G73 L20 Q1\nN50 M30");
    let ns: Vec<u64> = jumps(&found).iter().map(|(n, _)| *n).collect();
    // N20 jumps, N40 goes back, N20 falls through, N30 goes back with 2 left; N20 jumps anew, N40 falls through.
    assert_eq!(ns, [10, 20, 40, 20, 30, 10, 20, 40, 50]);
    assert_eq!(found[4]["jump"], json!({"to": 10, "left": 2}));
}

/// A parameter's value obeys the rules of forms and groups (PAR-3, BLK-10).
#[test]
fn unusable_parameters() {
    let errors = |line: &str| {
        case(&format!("%1\nN10 R1=2.5 R2=2 R3=-1 R4=0 R5=70\nN20 {line}\nN30 M30\nN40 G79 L2\nN50 G70")).run().errors
    };
    for (line, code) in [
        ("G71 LR1", "E0510"),
        ("G73 LR4", "E0510"),
        ("G04 QR1", "E0510"),
        ("G04 QR3", "E0510"),
        ("MR2", "E0510"),
        ("GR5", "E0510"),
        ("G03 GR2 X1 I1", "E0307"),
        ("GR1", "E0510"),
        ("SR3", "E0510"),
        ("TR1", "E0510"),
        ("&R5", "E0510"),
        ("FR4", "E0510"),
        ("M05 MR6 R6=3", "W0503"),
    ] {
        assert_eq!(errors(line), [code], "{line}");
    }
    assert!(errors("G71 LR2 QR2").is_empty());
    assert!(errors("G04 QR4").is_empty());
    assert!(errors("HR1 PR2 DR2").is_empty());
}

/// Q is read when the counter is armed, L at every arrival (§13 Parameters).
#[test]
fn jump_from_parameters() {
    let found = blocks("%1\nN10 R1=1 R2=20\nN20 R3=0\nN30 G73 LR2 QR1 R1=7 R2=30\nN40 M30");
    assert_eq!(
        jumps(&found),
        [(10, NULL), (20, NULL), (30, json!({"to": 20, "left": 0})), (20, NULL), (30, NULL), (40, NULL)]
    );
}

/// Calls with passes, outermost first, after everything else in their block; G70 with other words (FLW-1, PRG-3).
#[test]
fn calls() {
    let stream = case(
        "%1\nN10 X0 Y0\nN20 G71 L100 Q2 X10\nN30 X30\nN40 M30\nN100 G79 L100\nN110 G91 X1\nN120 G72 L9001 Q2\n\
         N130 G70 X2 M08",
    )
    .with("L9001", "N1 G79 L9001\nN2 Y1 G70")
    .whole();
    let found = stream.blocks();
    assert_eq!(
        column(&found, "n"),
        json!([10, 20, 100, 110, 120, 1, 2, 1, 2, 130, 100, 110, 120, 1, 2, 1, 2, 130, 30, 40])
    );
    let outer = |pass: u32| json!({"by": "G71", "l": 100, "file": 0, "n": 20, "pass": pass, "of": 2});
    let inner = |pass: u32| json!({"by": "G72", "l": 9001, "file": 0, "n": 120, "pass": pass, "of": 2});
    assert_fields(&found[1], &json!({"position": {"X": 10, "Y": 0}, "calls": null}));
    assert_fields(&found[3], &json!({"calls": [outer(1)], "position": {"X": 11, "Y": 0}}));
    assert_fields(&found[8], &json!({"calls": [outer(1), inner(2)], "file": 1, "line": 2, "column": 1}));
    assert_fields(&found[9], &json!({"calls": [outer(1)], "position": {"X": 13, "Y": 2}, "file": 0, "m_set": [8]}));
    assert_fields(&found[14], &json!({"calls": [outer(2), inner(1)], "position": {"X": 14, "Y": 3}}));
    assert_fields(&found[17], &json!({"calls": [outer(2)], "position": {"X": 16, "Y": 4}}));
    assert_fields(&found[18], &json!({"calls": null, "position": {"X": 46, "Y": 4}}));
    assert_eq!(stream.of("file"), [json!({"kind": "file", "index": 1, "name": "L9001"})]);
    let at = stream.records.iter().position(|record| record["kind"] == "file").unwrap();
    assert_eq!(stream.records[at + 1]["file"], 1);
}

/// Files are numbered as their records come, whatever was read before (block-stream.md, `file`).
#[test]
fn file_numbers() {
    let stream = case("%1\nN10 G73 L30\nN20 G72 L1\nN30 G72 L2\nN40 G72 L3\nN50 M30")
        .with("L1", "N1 G79 L1\nN2 G70")
        .with("L2", "N1 G79 L2\nN2 G70 G72 L3")
        .with("L3", "N1 G79 L3\nN2 G70")
        .run();
    assert_eq!(stream.errors, ["E0307"]);
    let stream = case("%1\nN10 G73 L30\nN20 G72 L1\nN30 G72 L2\nN40 G72 L3\nN50 M30")
        .with("L1", "N1 G79 L1\nN2 G70")
        .with("L2", "N1 G79 L2\nN2 G72 L3\nN3 G70")
        .with("L3", "N1 G79 L3\nN2 G70")
        .whole();
    assert_eq!(
        stream.of("file"),
        [json!({"kind": "file", "index": 1, "name": "L2"}), json!({"kind": "file", "index": 2, "name": "L3"})]
    );
    assert_eq!(column(&stream.blocks(), "file"), json!([0, 0, 1, 1, 2, 2, 1, 0, 2, 2, 0]));
}

/// A macrocycle may not call a subprogram (PRG-4).
#[test]
fn subprogram_from_a_macrocycle() {
    let stream =
        case("%1\nN10 G72 L1\nN20 M30\nN30 G79 L100\nN40 G70").with("L1", "N1 G79 L1\nN2 G71 L100\nN3 G70").run();
    assert_eq!(stream.errors, ["E0404"]);
    assert!(stream.records.iter().all(|record| record["kind"] != "end"));
}

/// Modal state, positions and parameters go through calls (FLW-10, PAR-6).
#[test]
fn state_through_calls() {
    let found = case("%1\nN10 R1=5\nN20 G72 L7\nN30 XR1 F10\nN40 M30")
        .with("L7", "N1 G79 L7\nN2 YR1 R1=8 G01 M03\nN3 G91 G70")
        .blocks();
    assert_block(&found, 2, &json!({"position": {"Y": 5}, "params": {"R1": 8}}));
    assert_fields(
        &found[5],
        &json!({"n": 30, "motion": {"type": "linear", "axes": ["X"], "delta": {"X": 8}, "length_mm": 8},
            "position": {"Y": 5}}),
    );
    assert_eq!(found[5]["m"][2], 3);
}

/// M30 in a macrocycle ends the program: it is the last block (PRG-5).
#[test]
fn end_in_a_macrocycle() {
    let stream = case("%1\nN10 G72 L7\nN20 M02").with("L7", "N1 G79 L7\nN2 M30\nN3 G70").whole();
    assert_eq!(column(&stream.blocks(), "last_block"), json!([null, null, true]));
    assert_eq!(column(&stream.blocks(), "first_block"), json!([true, null, null]));
    assert_fields(&stream.end(), &json!({"reason": "M30", "blocks": 3}));
}
