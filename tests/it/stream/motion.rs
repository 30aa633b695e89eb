//! Positions, lengths and arcs (§10).

use super::*;

/// G90, G91, unknown positions and distances (MOT-1, MOT-2).
#[test]
fn absolute_and_incremental() {
    let stream =
        case("%1\nN10 X10\nN20 G91 X5 Y3\nN30 X-20 Z0\nN40 G90 X-5 Y4\nN50 X-5\nN60 X-2 Y8\nN70 G91 Y-0.001\nN80 M30")
            .whole();
    let found = stream.blocks();
    assert_block(&found, 10, &json!({"position": {"X": 10}, "motion": {"type": "rapid", "axes": ["X"]}}));
    assert_block(
        &found,
        20,
        &json!({"position": {"X": 15}, "motion": {"type": "rapid", "axes": ["X", "Y"], "delta": {"Y": 3},
            "length_mm": 5.830_952}}),
    );
    assert_block(
        &found,
        30,
        &json!({"position": {"X": -5}, "motion": {"type": "rapid", "axes": ["X", "Z"], "delta": {"Z": 0}, "length_mm": 20}}),
    );
    assert_block(&found, 40, &json!({"position": {"X": -5, "Y": 4}, "motion": {"type": "rapid", "axes": ["X", "Y"]}}));
    assert_block(&found, 50, &json!({"motion": {"type": "rapid", "axes": ["X"], "length_mm": 0}}));
    assert_block(&found, 60, &json!({"motion": {"type": "rapid", "axes": ["X", "Y"], "length_mm": 5}}));
    assert_block(&found, 70, &json!({"position": {"X": -2, "Y": 7.999}}));
    assert_block(&found, 80, &json!({"motion": null, "position": {"X": -2, "Y": 7.999}}));
    assert_eq!(stream.end()["path_mm"], json!(30.831_952));
    assert_eq!(stream.end()["path_mm_by_type"], json!({"rapid": 30.831_952}));
    assert_eq!(stream.codes.iter().filter(|code| *code == "W0605").count(), 2);
}

/// Diameters: X words halve, I and J are radii, a half may have four decimals, G04 does not end them (MOT-1, §7).
#[test]
fn diameters() {
    let found = blocks(
        "%1\nN10 G74 X20 Z0\nN20 G91 X10.001\nN30 G90 G04 Q1 X0.001\nN40 G91 Z5 X-0.001\nN50 G90 X20 Z0\n\
         N60 G19 G03 X40 Z10 I10 J0 F100\nN70 G75 G00 X1 Y0\nN80 G74 G91 B1 X-2\nN90 M30",
    );
    assert_eq!(
        column(&found, "position"),
        json!([{"X": 10, "Z": 0}, {"X": 15.0005, "Z": 0}, {"X": 0.0005, "Z": 0}, {"X": 0, "Z": 5}, {"X": 10, "Z": 0},
            {"X": 20, "Z": 10}, {"X": 1, "Z": 10, "Y": 0}, {"X": 0, "Y": 0, "Z": 10}, {"X": 0, "Y": 0, "Z": 10}])
    );
    assert_eq!(lengths(&found), json!([null, 5.0005, 15, 5, 11.180_34, 15.707_963, null, 1, null]));
    assert_eq!(
        found[5]["motion"],
        json!({"type": "arc_ccw", "axes": ["X", "Z"], "length_mm": 15.707_963, "plane": "ZX", "center": {"X": 20, "Z": 0},
            "radius_mm": 10, "sweep_deg": 90})
    );
    let unknown = blocks("%1\nN10 G74 G91 X5\nN20 M30");
    assert_eq!(unknown[0]["motion"], json!({"type": "rapid", "axes": ["X"], "delta": {"X": 2.5}, "length_mm": 2.5}));
}

/// The motion of one block that starts at zero.
fn arc(words: &str) -> Value {
    from_zero("", &format!("N10 {words}"))[0]["motion"].clone()
}

/// Direction, plane and centre of arcs in the three planes (MOT-3, MOT-5, GRP-2).
#[test]
fn arcs_in_planes() {
    let quarter = |kind: &str, axes: Value, plane: &str, center: Value| {
        json!({"type": kind, "axes": axes, "length_mm": 15.707_963, "plane": plane, "center": center, "radius_mm": 10,
            "sweep_deg": 90})
    };
    let rest = |mut motion: Value, kind: &str| {
        motion["type"] = json!(kind);
        motion["length_mm"] = json!(47.123_89);
        motion["sweep_deg"] = json!(270);
        motion
    };
    let xy = quarter("arc_cw", json!(["X", "Y"]), "XY", json!({"X": 10, "Y": 0}));
    assert_eq!(arc("G02 X10 Y10 I10"), xy);
    assert_eq!(arc("G03 X10 Y10 I10 J0"), rest(xy, "arc_ccw"));
    let yz = quarter("arc_cw", json!(["Y", "Z"]), "YZ", json!({"Y": 10, "Z": 0}));
    assert_eq!(arc("G18 G02 Z10 Y10 I10"), yz);
    assert_eq!(arc("G17 G02 Z10 Y10 I10"), yz, "the plane is that of the words");
    assert_eq!(arc("G18 G03 Z10 Y10 I10"), rest(yz, "arc_ccw"));
    let zx = quarter("arc_ccw", json!(["X", "Z"]), "ZX", json!({"X": 10, "Z": 0}));
    assert_eq!(arc("G19 G03 X10 Z10 I10"), zx);
    assert_eq!(arc("G19 G02 X10 Z10 I10"), rest(zx, "arc_cw"));
    let zx = quarter("arc_cw", json!(["X", "Z"]), "ZX", json!({"X": 0, "Z": 10}));
    assert_eq!(arc("G02 X10 Z10 J10"), zx, "J is along Z");
}

const AXES_U: &str = "[[axes]]\nletter = \"X\"\nkind = \"linear\"\n[[axes]]\nletter = \"Y\"\nkind = \"linear\"\n\
    [[axes]]\nletter = \"Z\"\nkind = \"linear\"\n[[axes]]\nletter = \"U\"\nkind = \"linear\"\n[[axes]]\nletter = \"V\"\nkind = \"linear\"\n";
const AXES_U_FIRST: &str = "[[axes]]\nletter = \"U\"\nkind = \"linear\"\n[[axes]]\nletter = \"Z\"\nkind = \"linear\"\n\
    [[axes]]\nletter = \"Y\"\nkind = \"linear\"\n[[axes]]\nletter = \"X\"\nkind = \"linear\"\n[[axes]]\nletter = \"V\"\nkind = \"linear\"\n";

/// Planes with the 4th axis, and pairs that are no plane (MOT-3, MOT-5): direction by the plane's name, I and J by the
/// order of the machine.
#[test]
fn arcs_with_the_fourth_axis() {
    let shown = |config: &str, words: &str| {
        let found = from_zero(config, &format!("N5 U0 V0\nN10 {words}"));
        let motion = &found[1]["motion"];
        (motion["plane"].clone(), motion["sweep_deg"].clone(), motion["center"].clone(), motion["axes"].clone())
    };
    // Z4: from Z to U. Centre 10 along Z: the end lies a quarter away.
    for (config, words, plane, sweep, center, axes) in [
        (AXES_U, "G14 G03 Z10 U10 I10", "ZU", 270, json!({"Z": 10, "U": 0}), json!(["Z", "U"])),
        (AXES_U, "G14 G02 Z10 U10 I10", "ZU", 90, json!({"Z": 10, "U": 0}), json!(["Z", "U"])),
        (AXES_U_FIRST, "G14 G02 Z10 U10 J10", "ZU", 90, json!({"Z": 10, "U": 0}), json!(["U", "Z"])),
        (AXES_U_FIRST, "G14 G02 Z10 U10 I10", "ZU", 270, json!({"Z": 0, "U": 10}), json!(["U", "Z"])),
        (AXES_U, "G15 G02 Y10 U10 I10", "YU", 90, json!({"Y": 10, "U": 0}), json!(["Y", "U"])),
        (AXES_U_FIRST, "G15 G02 Y10 U10 J10", "YU", 90, json!({"Y": 10, "U": 0}), json!(["U", "Y"])),
        (AXES_U, "G16 G02 X10 U10 I10", "UX", 270, json!({"X": 10, "U": 0}), json!(["X", "U"])),
        (AXES_U, "G17 G03 X10 U10 I10", "UX", 90, json!({"X": 10, "U": 0}), json!(["X", "U"])),
        (AXES_U_FIRST, "G16 G02 X10 U10 I10", "UX", 90, json!({"X": 0, "U": 10}), json!(["U", "X"])),
        (AXES_U, "G02 X10 V10 I10", "XV", 90, json!({"X": 10, "V": 0}), json!(["X", "V"])),
        (AXES_U, "G02 U10 V10 I10", "UV", 90, json!({"U": 10, "V": 0}), json!(["U", "V"])),
        (AXES_U_FIRST, "G02 X10 Y10 J10", "XY", 90, json!({"X": 10, "Y": 0}), json!(["Y", "X"])),
        (AXES_U_FIRST, "G02 X10 Y10 I10", "XY", 270, json!({"X": 0, "Y": 10}), json!(["Y", "X"])),
        (AXES_U_FIRST, "G18 G02 Y10 Z10 I10", "YZ", 270, json!({"Y": 0, "Z": 10}), json!(["Z", "Y"])),
        (AXES_U_FIRST, "G19 G02 X10 Z10 I10", "ZX", 90, json!({"X": 0, "Z": 10}), json!(["Z", "X"])),
        (AXES_U_FIRST, "G02 Y10 V10 I10", "YV", 90, json!({"Y": 10, "V": 0}), json!(["Y", "V"])),
    ] {
        assert_eq!(shown(config, words), (json!(plane), json!(sweep), center, axes), "{words}");
    }
}

/// One axis word of the plane; none: a full circle; the end at the start: a full circle (MOT-3, MOT-4).
#[test]
fn half_and_full_circles() {
    assert_eq!(
        arc("G02 X20 I10"),
        json!({"type": "arc_cw", "axes": ["X", "Y"], "length_mm": 31.415_927, "plane": "XY", "center": {"X": 10, "Y": 0},
            "radius_mm": 10, "sweep_deg": 180})
    );
    assert_eq!(
        arc("G19 G03 Z-20 J-10"),
        json!({"type": "arc_ccw", "axes": ["X", "Z"], "length_mm": 31.415_927, "plane": "ZX", "center": {"X": 0, "Z": -10},
            "radius_mm": 10, "sweep_deg": 180})
    );
    let full = json!({"type": "arc_cw", "axes": ["X", "Y"], "length_mm": 31.415_927, "plane": "XY",
        "center": {"X": 3, "Y": -4}, "radius_mm": 5, "sweep_deg": 360});
    assert_eq!(arc("G02 I3 J-4"), full);
    assert_eq!(arc("G02 I3 J-4 X0 Y0"), full);
    assert_eq!(arc("G91 G02 I3 J-4 X0 Y0"), full);
    let found = from_zero("", "N10 G02 I1\nN20 J1\nN30 M03");
    assert_eq!(
        column(&found, "position"),
        json!([{"X": 0, "Y": 0, "Z": 0}, {"X": 0, "Y": 0, "Z": 0}, {"X": 0, "Y": 0, "Z": 0}])
    );
    assert_eq!(found[1]["motion"]["sweep_deg"], 360);
    assert_eq!(found[2].get("motion"), None);
    assert_eq!(found[0].get("words"), None);
    assert_eq!(case("%1\nN10 X0 Y0 Z0 F9\nN20 G02 Z5 I1\nN30 M30").run().errors, ["E0611"]);
    assert_eq!(case("%1\nN10 X0 Y0 Z0 F9\nN20 G02 X1 Y1\nN30 M30").run().errors, ["E0602"]);
    assert_eq!(case("%1\nN10 X0 Y0 Z0 F9\nN20 G02 X1 Y1 K1 I1\nN30 M30").run().errors, ["E0609"]);
}

/// Radii of start and end may differ by the tolerance; equal to it is allowed (MOT-4, §13 Motion).
#[test]
fn arc_tolerance() {
    let at = |x: &str| case(&format!("%1\nN10 X0 Y0 F9\nN20 G02 X{x} Y0 I1\nN30 M30")).run().errors;
    assert!(at("2.01").is_empty());
    assert!(at("1.99").is_empty());
    assert_eq!(at("2.011"), ["E0603"]);
    assert_eq!(at("1.989"), ["E0603"]);
    let wide = |x: &str| case(&format!("%1\nN10 X0 Y0 F9\nN20 G02 X{x} Y0 I100\nN30 M30")).run().errors;
    assert!(wide("200.1").is_empty());
    assert_eq!(wide("200.101"), ["E0603"]);
}

/// Arcs from an unknown start (§13 Motion).
#[test]
fn arcs_from_unknown() {
    let stream = case("%1\nN10 X0 F100\nN20 G02 X10 Y10 I3 J4\nN30 X20 I5\nN40 M30").whole();
    let found = stream.blocks();
    assert_fields(
        &found[1],
        &json!({"position": {"X": 10, "Y": 10},
            "motion": {"type": "arc_cw", "axes": ["X", "Y"], "plane": "XY", "radius_mm": 5}}),
    );
    assert_eq!(found[2]["motion"]["length_mm"], json!(15.707_963));
    assert!(stream.codes.contains(&"W0606".to_owned()));
    let found = blocks("%1\nN10 G91 X0 F100 G02 Y10 J5\nN20 M30");
    assert_eq!(found[0].get("position"), None);
    assert_eq!(
        found[0]["motion"],
        json!({"type": "arc_cw", "axes": ["X", "Y"], "delta": {"X": 0, "Y": 10}, "plane": "XY", "radius_mm": 5})
    );
}

/// Helices, and rotary words beside an arc (MOT-3, MOT-6, §13 Motion).
#[test]
fn helices() {
    assert_eq!(
        arc("G02 G09 X10 Y10 Z5 I10"),
        json!({"type": "arc_cw", "axes": ["X", "Y", "Z"], "length_mm": 16.484_542, "plane": "XY",
            "center": {"X": 10, "Y": 0}, "radius_mm": 10, "sweep_deg": 90})
    );
    assert_eq!(arc("G02 X10 Y10 A5 I10")["length_mm"], json!(15.707_963));
    assert_eq!(arc("G02 X10 Y10 A5 I10")["axes"], json!(["X", "Y", "A"]));
    // A third axis of unknown start leaves the length unknown, the arc itself is known.
    assert_eq!(
        arc("G02 X10 Y10 U5 I10"),
        json!({"type": "arc_cw", "axes": ["X", "Y", "U"], "plane": "XY", "center": {"X": 10, "Y": 0}, "radius_mm": 10,
            "sweep_deg": 90})
    );
    assert_eq!(arc("G91 G02 X10 Y10 U5 I10")["length_mm"], json!(16.484_542));
    assert_eq!(arc("G91 G02 X10 Y10 U5 I10")["delta"], json!({"U": 5}));
    assert_eq!(case("%1\nN10 X0 Y0 Z0 F9\nN20 G02 X1 Y1 Z1 A1 I1\nN30 M30").run().errors, ["E0611"]);
    assert_eq!(case("%1\nN10 X0 Y0 Z0 F9\nN20 G02 X1 A1 Z1 I1\nN30 M30").run().errors, ["E0611"]);
}

/// Lengths of rotary and mixed motions (MOT-6, §13 Motion).
#[test]
fn rotary_lengths() {
    let found = from_zero("", "N10 A0 B0\nN20 A30 B-40\nN30 X3 Y4 A0\nN40 A0\nN50 G91 C10\nN60 C1 Z2\nN70 G90 X5 C7");
    let motions = column(&found, "motion");
    assert_eq!(
        motions,
        json!([{"type": "rapid", "axes": ["A", "B"]}, {"type": "rapid", "axes": ["A", "B"], "length_deg": 50},
            {"type": "rapid", "axes": ["X", "Y", "A"], "length_mm": 5}, {"type": "rapid", "axes": ["A"], "length_deg": 0},
            {"type": "rapid", "axes": ["C"], "delta": {"C": 10}, "length_deg": 10},
            {"type": "rapid", "axes": ["Z", "C"], "delta": {"C": 1}, "length_mm": 2},
            {"type": "rapid", "axes": ["X", "C"], "length_mm": 2}])
    );
}

/// G30: positions are unknown after it, its values are not used (MOT-7, §13 Motion).
#[test]
fn reference() {
    let found = from_zero("", "N10 G30 X7 Z8\nN20 Y3\nN30 X1\nN40 G91 G30 Y1");
    assert_eq!(column(&found, "position"), json!([{"Y": 0}, {"Y": 3}, {"X": 1, "Y": 3}, {"X": 1}]));
    assert_eq!(
        column(&found, "motion"),
        json!([{"type": "reference", "axes": ["X", "Z"]}, {"type": "rapid", "axes": ["Y"], "length_mm": 3},
            {"type": "rapid", "axes": ["X"]}, {"type": "reference", "axes": ["Y"]}])
    );
}

/// The block that moves after a change of origin has no length, whatever changed it (MOT-8, §13 Motion).
#[test]
fn stale_start() {
    // What stands before X1, whether X1 has a length, and whether X2 has.
    for (lines, lengths_expected) in [
        ("N10 M03\nN20 X1\nN30 X3", json!([null, 1, 2])),
        ("N10 G54\nN20 X1\nN30 X3", json!([null, null, 2])),
        ("N10 G53\nN20 X1\nN30 X3", json!([null, 1, 2])),
        ("N10 G54\nN15 G53\nN20 X1\nN30 X3", json!([null, null, null, 2])),
        ("N20 G55 X1\nN30 X3", json!([null, 2])),
        ("N20 G58 X1\nN30 X3\nN40 X7", json!([null, null, 4])),
        ("N10 G58\nN20 X1\nN30 X3", json!([null, null, 2])),
        ("N20 G59 X1\nN30 G59 X3\nN40 X7\nN50 X15", json!([null, 2, null, 8])),
        ("N10 G54\nN20 G53 G30 Z0\nN30 X3\nN40 X7", json!([null, null, null, 4])),
        ("N20 G35 Z1\nN30 X3\nN40 X7\nN50 G34\nN60 X1\nN70 X3", json!([null, null, 4, null, null, 2])),
        ("N20 G34\nN30 X3", json!([null, 3])),
        ("N20 G92 X5 D3\nN30 X3\nN40 X7", json!([null, null, 4])),
        ("N20 G31 X5\nN30 X3\nN40 X7", json!([null, null, 4])),
        ("N10 &0\nN20 X1\nN30 X3", json!([null, 1, 2])),
        ("N10 &1000\nN20 X1\nN30 X3", json!([null, null, 2])),
        ("N10 &1000\nN20 X1\nN25 D1\nN30 X3\nN40 X7", json!([null, null, null, null, 4])),
        ("N10 &1000\nN20 X1\nN25 &1000\nN30 X3", json!([null, null, null, 2])),
        ("N10 &1000 X1\nN20 &0 X3\nN30 &0 X7", json!([null, null, 4])),
        ("N10 D1\nN20 X1\nN30 D2 X3", json!([null, 1, 2])),
        ("N10 D1 &1000\nN20 X1\nN30 D1 X3\nN40 D2 X7", json!([null, null, 2, null])),
        ("N10 G54\nN20 A1\nN30 X3\nN40 X7", json!([null, null, null, 4])),
        ("N10 G90\nN20 G54 G91 X5\nN30 X5", json!([null, null, 5])),
    ] {
        assert_eq!(lengths(&from_zero("", lines)), lengths_expected, "{lines}");
    }
    let rotary = from_zero("", "N10 A0\nN20 G54 A5\nN30 A7");
    let degrees: Value = rotary.iter().map(|block| block["motion"]["length_deg"].clone()).collect();
    assert_eq!(degrees, json!([null, null, 2]));
}

/// An arc after a change of origin is computed from the programmed start, without a length (MOT-8).
#[test]
fn stale_arc() {
    let stream = case("%1\nN10 X0 Y0 F100\nN20 G54\nN30 G02 X10 Y10 I10\nN40 X20 Y0 J-10\nN50 M30").whole();
    let found = stream.blocks();
    assert_eq!(
        found[2]["motion"],
        json!({"type": "arc_cw", "axes": ["X", "Y"], "plane": "XY", "center": {"X": 10, "Y": 0}, "radius_mm": 10,
            "sweep_deg": 90})
    );
    assert_eq!(found[3]["motion"]["length_mm"], json!(15.707_963));
    assert!(stream.codes.contains(&"W0610".to_owned()));
    assert_eq!(stream.end()["path_mm"], json!(15.707_963));
    assert_eq!(stream.end()["path_mm_by_type"], json!({"arc_cw": 15.707_963}));
}
