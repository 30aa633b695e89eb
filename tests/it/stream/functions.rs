//! G and M functions, feed, speed and tool in records (§7–§9).

use super::*;

/// The whole of the shortest program (GRP-3, MFN-6, BLK-9).
#[test]
fn shortest_program() {
    let stream = case("before\r\n%12 \" Title\t\" \"more\"\r\nN10 M30\r\n*\r\n").whole();
    let axes: Vec<Value> = "XYZABCUVW"
        .chars()
        .map(|letter| json!({"letter": letter, "kind": if "ABC".contains(letter) { "rotary" } else { "linear" }}))
        .collect();
    assert_eq!(
        stream.records,
        [
            json!({"kind": "program", "schema": "cnc872c.blocks/2", "generator": concat!("cnc872c ", env!("CARGO_PKG_VERSION")),
                "dialect": "cnc872", "number": 12, "title": "Title", "comments": ["Title", "more"], "name": "P.NC", "axes": axes, "g97": "per-minute",
                "arc_centers": "machine-order", "arc_tolerance": 0.01, "spindle_axis": "C"}),
            json!({"kind": "block", "seq": 0, "n": 10, "file": 0, "line": 3, "column": 1,
                "first_block": true, "last_block": true,
                "g": [0, 17, 98, 40, null, 53, 94, 70, 80, 90, 75, 34],
                "m": [null, 30, 5, 40, null, 9, 53, null, 48, null, null, null, null, null, null],
                "m_set": [30], "m_changed": [1, 2, 5, 6]}),
            json!({"kind": "end", "reason": "M30", "blocks": 1, "path_mm": 0}),
        ]
    );
}

/// An empty first comment is no title, and a later one does not become it (§13 Structure, More).
#[test]
fn empty_title() {
    let stream = case("%1 \" \" \"second\"\nN1 M02").whole();
    assert_fields(
        &stream.records[0],
        &json!({"title": null, "block_skip": null, "optional_stop": null, "m_functions": null}),
    );
    assert_fields(&stream.end(), &json!({"reason": "M02"}));
}

/// Modal and x functions (§7): each covers its group for its block only.
#[test]
fn g_functions_of_one_block() {
    let found = blocks(
        "%1\nN10 G74 G54\nN20 G04 Q5 G58\nN30 X1\nN40 G30 X0\nN50 X2 F100 G01 Y1\nN60 G30 Y0\nN70 Y1 R1=1\nN80 G71 L100\n\
         N90 G73 L110\nN100\nN110 G59\nN120 G92 X1\nN130 M30\nN200 G79 L100\nN210 G70",
    );
    let shown = |group| entries(&found, "g", group);
    assert_eq!(column(&found, "n"), json!([10, 20, 30, 40, 50, 60, 70, 80, 200, 210, 90, 110, 120, 130]));
    assert_eq!(shown(0), json!([0, 0, 0, 30, 1, 30, 1, 1, 1, 1, 1, 1, 1, 1]));
    assert_eq!(shown(5), json!([54, 58, 54, 54, 54, 54, 54, 54, 54, 54, 54, 59, 54, 54]));
    assert_eq!(shown(7), json!([70, 70, 70, 70, 70, 70, 70, 71, 79, 70, 73, 70, 70, 70]));
    assert_eq!(shown(10), json!([74, 4, 74, 74, 74, 74, 74, 74, 74, 74, 74, 74, 92, 74]));
    assert_eq!(
        column(&found, "g_set"),
        json!([[74, 54], [4, 58], null, [30], [1], [30], null, [71], [79], [70], [73], [59], [92], null])
    );
}

/// In the record of M02 and M30 the G groups show what held in the block (block-stream.md, `g`).
#[test]
fn g_groups_in_the_last_block() {
    let found = blocks("%1\nN10 G91 G18 G41 G95 G23 G38 X1\nN20 G55 M30");
    assert_eq!(found[1]["g"], json!([0, 18, 23, 41, null, 55, 95, 70, 80, 91, 75, 38]));
}

/// Power-up values can be set (GRP-3).
#[test]
fn power_up_values() {
    let config = "[power-up]\nG0 = 1\nG1 = 18\nG9 = 91\nG10 = 74\n";
    let found = case("%1\nN10 X10 F100\nN20 M30").config(config).blocks();
    assert_eq!(found[0]["g"], json!([1, 18, 98, 40, null, 53, 94, 70, 80, 91, 74, 34]));
    assert_eq!(found[0]["motion"], json!({"type": "linear", "axes": ["X"], "delta": {"X": 5}, "length_mm": 5}));
}

/// Values and change bits of the M groups (MFN-6, MFN-7).
#[test]
fn m_groups() {
    let found = blocks("%1\nN10 M03 M08 M99\nN20\nN30 M03\nN40 M06 M10 M49\nN50 M41 M51 M20\nN60 M04 M07 M30");
    let m = |n: usize| found[n]["m"].clone();
    assert_eq!(m(0), json!([null, null, 3, 40, null, 8, 53, null, 48, null, null, null, null, null, 99]));
    assert_eq!(m(1), m(0));
    assert_eq!(m(2), m(0));
    assert_eq!(m(3), json!([null, null, 3, 40, null, 8, 53, 10, 49, 6, null, null, null, null, 99]));
    assert_eq!(m(4), json!([null, null, 3, 41, null, 8, 51, null, 49, null, null, null, null, null, 20]));
    assert_eq!(m(5), json!([null, 30, 5, 40, null, 9, 53, null, 48, null, null, null, null, null, 20]));
    assert_eq!(column(&found, "m_changed"), json!([[2, 5, 14], null, [2], [7, 8, 9], [3, 6, 14], [1, 2, 3, 5, 6, 8]]));
    assert_eq!(column(&found, "m_set"), json!([[3, 8, 99], null, [3], [6, 10, 49], [41, 51, 20], [4, 7, 30]]));
}

/// M02 and M30 send M05, M09 and M53: groups 2, 5 and 6 are marked whether they change or not (MFN-6).
#[test]
fn m_marks_of_the_end() {
    let end = |words: &str| blocks(&format!("%1\nN10 {words}"))[0].clone();
    assert_fields(&end("M03 M30"), &json!({"m_changed": [1, 2, 5, 6]}));
    assert_eq!(end("M03 M30")["m"][2], 5);
    assert_fields(&end("M05 M02"), &json!({"m_changed": [1, 2, 5, 6], "m_set": [5, 2]}));
    assert_fields(&end("M02"), &json!({"m_changed": [1, 2, 5, 6]}));
}

/// M00 and M01: what holds while the program stands, and after START (MFN-8).
#[test]
fn stops() {
    let program = "%1\nN10 M03 M07 M52\nN20 M00\nN30 M01\nN40 M00 M04 M50\nN50\nN60 M01 M09\nN70 M30";
    let stands = json!({"2": 5, "5": 9, "6": 53});
    let off = blocks(program);
    assert_eq!(column(&off, "m_at_stop"), json!([null, stands, null, stands, null, null, null]));
    assert_eq!(entries(&off, "m", 2), json!([3, 3, 3, 4, 4, 4, 5]));
    assert_eq!(entries(&off, "m", 5), json!([7, 7, 7, 7, 7, 9, 9]));
    assert_eq!(entries(&off, "m", 6), json!([52, 52, 52, 50, 50, 50, 53]));
    assert_eq!(entries(&off, "m", 1), json!([null, 0, 1, 0, null, 1, 30]));
    assert_eq!(column(&off, "m_changed"), json!([[2, 5, 6], [1], [1], [1, 2, 6], null, [1, 5], [1, 2, 5, 6]]));
    assert_eq!(column(&off, "stop"), json!([null, true, null, true, null, null, null]));
    assert_eq!(column(&off, "cond_stop"), json!([null, null, true, null, null, true, null]));
    let stream = case(program).args("--optional-stop").whole();
    assert_fields(&stream.records[0], &json!({"optional_stop": true}));
    assert_eq!(column(&stream.blocks(), "m_at_stop"), json!([null, stands, stands, stands, null, stands, null]));
}

/// Group 4 and the numbers by dialect (§8, MFN-3).
#[test]
fn m_by_dialect() {
    let program = "%1\nN10 M37\nN20 M36 M07\nN30 M37\nN40 M30";
    let old = case(program).args("--dialect=cnc8x9").blocks();
    assert_eq!(entries(&old, "m", 4), json!([37, 36, 37, 36]));
    assert_eq!(entries(&old, "m", 14), json!([null, null, null, null]));
    assert_eq!(old[3]["m_changed"], json!([1, 2, 4, 5, 6]));
    let new = blocks(program);
    assert_eq!(entries(&new, "m", 4), json!([null, null, null, null]));
    assert_eq!(entries(&new, "m", 14), json!([37, 36, 37, 37]));
    assert_eq!(new[3]["m_changed"], json!([1, 2, 5, 6]));
}

/// R56–R59 name groups 10–13 (MFN-5); the record lists them with their group only (§13 Records).
#[test]
fn m_groups_of_machine_constants() {
    let config = "dialect = \"cnc8x6\"\n[machine-constants]\nR56 = \"91929394\"\nR59 = 7071\n";
    let stream = case("%1\nN10 M92 M70\nN20 M91 M95\nN30 M30").config(config).whole();
    assert_eq!(
        stream.records[0]["m_functions"],
        json!([{"no": 70, "group": 13}, {"no": 71, "group": 13}, {"no": 91, "group": 10}, {"no": 92, "group": 10},
            {"no": 93, "group": 10}, {"no": 94, "group": 10}])
    );
    let found = stream.blocks();
    assert_eq!(entries(&found, "m", 10), json!([92, 91, 91]));
    assert_eq!(entries(&found, "m", 13), json!([70, 70, 70]));
    assert_eq!(entries(&found, "m", 14), json!([null, 95, 95]));
    assert_eq!(column(&found, "m_changed"), json!([[10, 13], [10, 14], [1, 2, 5, 6]]));
}

const CHANNEL: &str = "<C><MFunctions><MFunc No=\"6\" BreakCont=\"1\" ChangePos=\"1\"/><MFunc No=\"36\" GroupNo=\"4\"/>\
    <MFunc No=\"37\" GroupNo=\"4\" BreakContEnd=\"1\"/><MFunc No=\"100\" GroupNo=\"12\"/></MFunctions></C>";

/// MFunctions of a ChannelConfig: groups and attributes (MFN-2, MFN-3, MFN-4).
#[test]
fn m_functions_of_a_channel() {
    let stream = case("%1\nN10 X10 Y5\nN20 X13 Y9 M06 M37\nN30 X20\nN40 M100 M36\nN50 M30")
        .config("channel-config = \"C.xml\"\n")
        .with("C.xml", CHANNEL)
        .whole();
    assert_eq!(
        stream.records[0]["m_functions"],
        json!([{"no": 6, "group": 9, "break_cont": true, "change_pos": true}, {"no": 36, "group": 4},
            {"no": 37, "group": 4, "break_cont_end": true}, {"no": 100, "group": 12}])
    );
    let found = stream.blocks();
    assert_fields(
        &found[1],
        &json!({"break_cont": true, "break_cont_end": true, "change_pos": true, "position": {"X": 13, "Y": 9}, "m_changed": [4, 9],
            "motion": {"type": "rapid", "axes": ["X", "Y"]}}),
    );
    assert_fields(
        &found[2],
        &json!({"break_cont": null, "break_cont_end": null, "change_pos": null, "position": {"X": 20, "Y": 9},
            "motion": {"type": "rapid", "axes": ["X"], "length_mm": 7}}),
    );
    assert_eq!(entries(&found, "m", 4), json!([null, 37, 37, 36, 36]));
    assert_eq!(entries(&found, "m", 12), json!([null, null, null, 100, 100]));
}

/// The gear follows S with M40, and is the one written with M41–M44 (MFN-9, §13 More).
#[test]
fn gears() {
    let program = "%1\nN10\nN20 S450\nN30 S600\nN40 S3000\nN50 M42 S500\nN60 M40 S500\nN70 S0\nN80 M42 S1000\nN90 M30";
    assert_eq!(column(&case(program).config(GEARS).blocks(), "gear"), json!([null, 1, 2, null, 2, 1, null, 2, 2]));
    assert_eq!(
        column(&blocks("%1\nN10 S100\nN20 M43\nN30\nN40 M44 S9999\nN50 M30"), "gear"),
        json!([null, 3, 3, 4, null])
    );
    // Without a table M40 chooses none, whatever was in force.
    for end in ["M40\nN30 M30", "G97 M40\nN30 M30", "M30"] {
        let found = case(&format!("%1\nN10 G96 M42 S100\nN20 {end}")).args("--dialect=cnc8x9").blocks();
        assert_eq!((&found[0]["gear"], found[1].get("gear")), (&json!(2), None), "{end}");
    }
    assert_eq!(case("%1\nN10 M41 S501\nN20 M30").config(GEARS).run().errors, ["E0607"]);
}

/// Feed and what it means (TEC-1, TEC-5).
#[test]
fn feeds() {
    let found = case("%1\nN10\nN20 F120.5\nN30\nN40 G95\nN50 F0.2\nN60 G96\nN70 G97 F99.999\nN80 G94 F24000\nN90 M30")
        .args("--dialect=cnc8x9")
        .blocks();
    assert_eq!(column(&found, "feed"), json!([null, 120.5, 120.5, 120.5, 0.2, 0.2, 99.999, 24000, 24000]));
    assert_eq!(column(&found, "f_set"), json!([null, true, null, null, true, null, true, true, null]));
    assert_eq!(column(&found, "rev_feed"), json!([null, null, null, true, true, null, true, null, null]));
    assert_eq!(column(&found, "const_cut_speed"), json!([null, null, null, null, null, true, true, null, null]));
}

/// S, T, H, P, D and `&`: absent until programmed, in force afterwards, marked where written.
#[test]
fn technology_words() {
    let found = blocks("%1\nN10\nN20 S0 T0 H-1.5 P7 D9 &12\nN30\nN40 S9999 T69999999 H0 P99 D1 &1020\nN50 M30");
    let absent = json!({"s": null, "t": null, "h": null, "p": null, "d": null, "length_correction": null, "s_set": null,
        "t_set": null, "h_set": null, "p_set": null, "d_set": null, "f_set": null, "feed": null, "dwell_s": null});
    assert_fields(&found[0], &absent);
    let set = json!({"s_set": true, "t_set": true, "h_set": true, "p_set": true, "d_set": true, "f_set": null});
    let unset = json!({"s_set": null, "t_set": null, "h_set": null, "p_set": null, "d_set": null});
    let first = json!({"s": 0, "t": 0, "h": -1.5, "p": 7, "d": 9, "length_correction": "0012"});
    let second = json!({"s": 9999, "t": 69_999_999, "h": 0, "p": 99, "d": 1, "length_correction": "1020"});
    for (block, values, marks) in [(1, &first, &set), (2, &first, &unset), (3, &second, &set), (4, &second, &unset)] {
        assert_fields(&found[block], values);
        assert_fields(&found[block], marks);
    }
}

/// ADR-2: words outside their ranges are errors beside G74 and G75 too, so that the stream has no end.
#[test]
fn ranges_beside_diameters() {
    for word in ["Q0", "Q999990", "L0", "L99999", "D100", "P0", "P100", "H0"] {
        for function in ["G74", "G75"] {
            let stream = case(&format!("%1\nN10 {function} {word}\nN20 M30")).args("--dialect=cnc8x6").run();
            assert_eq!(stream.errors, ["E0302"], "{function} {word}");
            assert!(stream.of("end").is_empty(), "{function} {word}: {}", stream.text);
        }
    }
}
