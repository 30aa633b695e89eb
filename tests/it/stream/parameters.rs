//! Assignments, parameters in words, arithmetic (§4).

use super::*;

/// All words read the values from before the block, copies too (PAR-1, PAR-4).
#[test]
fn assignments() {
    let found = blocks(
        "%1\nN10 R1=5 R2 7.25 R3-4\nN20 R1=R2 R2=R1 XR1\nN30 R4=-R1 Y-R2 R5=+R3\nN40 XR1 Y+R4 ZR 5\nN50 R95=99999999 R0=-0\n\
         N60 M30",
    );
    assert_eq!(
        column(&found, "params"),
        json!([{"R1": 5, "R2": 7.25, "R3": -4}, {"R1": 7.25, "R2": 5}, {"R4": -7.25, "R5": -4}, null,
            {"R95": 99_999_999, "R0": 0}, null])
    );
    assert_eq!(found[1]["position"], json!({"X": 5}));
    assert_eq!(found[2]["position"], json!({"X": 5, "Y": -5}));
    assert_eq!(found[3]["position"], json!({"X": 7.25, "Y": -7.25, "Z": -4}));
}

/// Parameters in place of other numbers: G, M, F, S, L, Q (ADR-3, PAR-2).
#[test]
fn parameters_in_words() {
    let found = blocks("%1\nN10 R1=1 R2=3 R3=100\nN20 GR1 MR2 XR3 FR3 SR3 &R3 D R1 R4=R3\nN30 M30");
    assert_fields(
        &found[1],
        &json!({"g_set": [1], "m_set": [3], "m_changed": [2], "position": {"X": 100}, "feed": 100, "f_set": true,
            "s": 100, "length_correction": "0100", "d": 1, "params": {"R4": 100}}),
    );
}

/// The result of one operation on R1 and R2, or the errors.
fn operation(code: u32, whole: bool, first: &str, second: &str) -> Result<Value, Vec<String>> {
    let sign = if whole { "-" } else { "" };
    let program = format!("%1\nN10 R1={first} R2={second}\nN20 G26 R5={sign}{code:02}010203\nN30 M30");
    let stream = case(&program).config(OPERATIONS).run();
    if stream.errors.is_empty() { Ok(stream.blocks()[1]["params"]["R3"].clone()) } else { Err(stream.errors) }
}

/// Every operation in real arithmetic (PAR-8, PAR-9, §13 Parameters).
#[test]
fn real_arithmetic() {
    for (code, first, second, expected) in [
        (1, "1.5", "2.25", json!(3.75)),
        (2, "1.5", "2.25", json!(-0.75)),
        (3, "0.001", "0.5", json!(0.001)),
        (3, "-0.001", "0.5", json!(-0.001)),
        (3, "0.001", "0.499", json!(0)),
        (3, "-0.001", "0.499", json!(0)),
        (4, "1", "3", json!(0.333)),
        (4, "2", "3", json!(0.667)),
        (4, "-2", "3", json!(-0.667)),
        (4, "0.001", "2", json!(0.001)),
        (5, "4.5", "0", json!(-4.5)),
        (5, "0", "0", json!(0)),
        (6, "-4.5", "0", json!(4.5)),
        (7, "2", "0", json!(1.414)),
        (7, "0.25", "0", json!(0.5)),
        (7, "69999.999", "0", json!(264.575)),
        (8, "30", "0", json!(0.5)),
        (8, "180", "0", json!(0)),
        (9, "60", "0", json!(0.5)),
        (9, "90", "0", json!(0)),
        (10, "45", "0", json!(1)),
        (11, "0.5", "0", json!(30)),
        (12, "0.5", "0", json!(60)),
        (12, "-1", "0", json!(180)),
        (13, "-1", "0", json!(-45)),
        (14, "1", "-1", json!(135)),
        (14, "0", "-1", json!(180)),
        (14, "-1", "0", json!(-90)),
        (15, "-7.5", "2", json!(-1.5)),
        (15, "7.5", "-2", json!(1.5)),
        (16, "3", "-2", json!(-2)),
        (17, "3", "-2", json!(3)),
        (18, "2.5", "0", json!(3)),
        (18, "-2.5", "0", json!(-3)),
        (18, "-0.4", "0", json!(0)),
        (19, "-2.9", "0", json!(-2)),
        (20, "-2.9", "0", json!(-2.9)),
    ] {
        assert_eq!(operation(code, false, first, second), Ok(expected), "{code} of {first}, {second}");
    }
}

/// The function of arithmetic may come from a parameter; what it lacks is then told in execution (PAR-9).
#[test]
fn arithmetic_by_parameter() {
    let text = "%1\nN10 R1=26 R2=2 R3=5 R4=27\nN20 GR1 R5=01020306\nN30 G0 XR6\nN40 M30";
    assert_eq!(case(text).config(OPERATIONS).blocks()[1]["params"]["R6"], json!(7));
    let stream = case(&text.replace("GR1", "GR4")).config(OPERATIONS).run();
    assert_eq!(stream.errors[0], "E0505");
}

/// A control word of nothing but zeros is no negative one: its arithmetic is not that of whole numbers (PAR-8).
#[test]
fn the_control_word_zero() {
    let found =
        case("%1\nN10 R0=0.3\nN20 G26 R5=0\nN30 G0 XR0\nN40 M30").config("[operations]\n\"00\" = \"add\"").blocks();
    assert_eq!(found[1]["params"]["R0"], json!(0.6));
}

/// Whole-number arithmetic rounds operands and results (PAR-8).
#[test]
fn whole_arithmetic() {
    for (code, first, second, expected) in [
        (1, "1.5", "2.4", json!(4)),
        (2, "-1.5", "0.4", json!(-2)),
        (3, "0.5", "5", json!(5)),
        (4, "7", "2", json!(4)),
        (4, "-7", "2", json!(-4)),
        (4, "1", "3", json!(0)),
        (7, "2", "0", json!(1)),
        (8, "90.4", "0", json!(1)),
        (15, "7.5", "3", json!(2)),
        (3, "33333333", "3", json!(99_999_999)),
        (20, "-2.9", "0", json!(-3)),
    ] {
        assert_eq!(operation(code, true, first, second), Ok(expected), "{code} of {first}, {second}");
    }
}

/// Results that there are not (PAR-10).
#[test]
fn arithmetic_errors() {
    for (code, whole, first, second) in [
        (1, false, "69999.999", "0.001"),
        (1, true, "99999999", "1"),
        (3, false, "70000", "1"),
        (3, false, "69999.999", "69999.999"),
        (4, false, "1", "0"),
        (4, true, "1", "0.4"),
        (7, false, "-0.001", "0"),
        (10, false, "90", "0"),
        (10, false, "-270", "0"),
        (11, false, "1.001", "0"),
        (12, false, "-1.001", "0"),
        (15, false, "1", "0"),
    ] {
        assert_eq!(operation(code, whole, first, second), Err(vec!["E0509".to_owned()]), "{code} of {first}, {second}");
    }
    assert_eq!(operation(21, false, "1", "1"), Err(vec!["E0508".to_owned()]));
}

/// G27–G29 work in order, each on the results before; a result does not change a control word (PAR-7, §13 Parameters).
#[test]
fn operations_in_order() {
    let found = case(
        "%1\nN10 R1=2 R2=3 R10=10 R5=1\nN20 G29 R8=03101010 R5=01010203 R6=02030201 R7=03030304 XR10\n\
         N30 G27 R6=01010210 R5=01010206\nN40 G26 R5=20959911 R95=4\nN50 R5=7\nN60 M30",
    )
    .config(OPERATIONS)
    .blocks();
    assert_fields(
        &found[1],
        &json!({"position": {"X": 10}, "params": {"R1": 2, "R3": 5, "R4": 25, "R10": 100, "R5": 1_010_203, "R6": 2_030_201,
            "R7": 3_030_304, "R8": 3_101_010}}),
    );
    assert_eq!(found[1]["g"][4], 29);
    assert_eq!(found[1]["g_set"], json!([29]));
    assert_eq!(found[2]["params"], json!({"R5": 1_010_206, "R6": 5, "R10": 5}));
    assert_eq!(found[3]["params"], json!({"R5": 20_959_911, "R95": 4, "R11": 4}));
    assert_fields(&found[4], &json!({"params": {"R5": 7}}));
    assert_eq!(found[4]["g"][4], NULL);
}
