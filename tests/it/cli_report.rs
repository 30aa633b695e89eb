//! `report` on the real binary: what the set-up sheet holds, its forms, exit status.

use serde_json::{Value, json};

use crate::cli::{BAD, Place};
use crate::json_schema::validator_for;

const PROGRAM: &str = "%7 \"FLANGE <1>\"\nN10 G90 G17 G0 X0 Y0 Z50 T1 D1 M6\nN20 G1 Z-2 F200 S1000 M3\nN30 X40 F800 S1500\n\
                       N40 G3 X40 Y20 I0 J10\nN50 G0 Z50\nN60 T5 M6\nN70 G71 L5 Q3\nN80 G72 L9\nN90 R10=4\nN100 G1 XR10 YR11 F300\n\
                       N110 T1 M6\nN120 G1 X-5\nN130 M30\nN200 G79 L5\nN210 G1 Z-1 F100\nN220 G0 Z5 M8 G70\n";

fn place() -> Place {
    let macrocycle = "N1 G79 L9\nN2 G0 X60\nN3 G70\n";
    Place::with(&[("a.nc", PROGRAM.as_bytes()), ("L9", macrocycle.as_bytes()), ("bad.nc", BAD.as_bytes())])
}

/// The sheet of a program, as its schema has it.
fn valid_sheet(place: &Place, file: &str, program: &str) -> Value {
    place.put(file, format!("%1\n{program}"));
    let run = place.run(&["report", file, "--format", "json"]).ends(0);
    let sheet: Value = serde_json::from_str(&run.stdout).unwrap();
    let validator = validator_for(&cnc872c::analysis::sheet::schema());
    assert_eq!(validator.validate(&sheet), Ok(()));
    sheet
}

#[test]
fn json() {
    let place = place();
    let run = place.run(&["report", "a.nc", "--format", "json", "--param", "R11=7.5"]).ends(0);
    let sheet: Value = serde_json::from_str(&run.stdout).unwrap();
    let validator = validator_for(&cnc872c::analysis::sheet::schema());
    assert_eq!(validator.validate(&sheet), Ok(()));
    assert_eq!((&sheet["number"], &sheet["title"]), (&json!(7), &json!("FLANGE <1>")));
    // The arc bulges to X50.
    assert_eq!(sheet["extents"]["working"], json!({ "X": [-5, 60], "Y": [0, 20], "Z": [-2, 50] }));
    assert_eq!(sheet["extents"]["all"]["X"], json!([-5, 60]));
    let tools = sheet["tools"].as_array().unwrap();
    assert_eq!(tools.len(), 2);
    let (first, second) = (&tools[0], &tools[1]);
    assert_eq!((&first["t"], &first["changes"], &first["n"]), (&json!(1), &json!(2), &json!(10)));
    assert_eq!(first["feeds"], json!([{ "unit": "mm/min", "min": 200, "max": 800 }]));
    assert_eq!((&first["speeds"], &first["d"]), (&json!([1000, 1500]), &json!([1])));
    assert_eq!(first["extents"]["X"], json!([-5, 50]));
    assert_eq!((&second["t"], &second["changes"]), (&json!(5), &json!(1)));
    // M06 is counted, not the tool that was in the spindle before.
    place.put("twice.nc", "%1\nN1 G0 G90 X0\nN2 T3 M6\nN3 M6\nN4 G1 X5 F100\nN5 M30\n");
    let twice: Value =
        serde_json::from_str(&place.run(&["report", "twice.nc", "--format", "json"]).ends(0).stdout).unwrap();
    assert_eq!((&twice["tools"][0]["changes"], &twice["tools"][1]["changes"]), (&json!(0), &json!(2)));
    assert_eq!(sheet["m_functions"][0], json!({ "no": 3, "count": 1, "n": 20 }));
    assert!(sheet["m_functions"].as_array().unwrap().contains(&json!({ "no": 8, "count": 3, "n": 220 })));
    assert_eq!(sheet["parameters"], json!([{ "r": 11, "value": 7.5, "n": 100 }]));
    let units = json!([{ "l": 5, "kind": "subprogram", "runs": 3 }, { "l": 9, "kind": "macrocycle", "runs": 1 }]);
    assert_eq!(sheet["units"], units);
    let motion = place.run(&["motion", "a.nc", "--format", "json", "--param", "R11=7.5"]).ends(0);
    let total: Value = serde_json::from_str(motion.stdout.lines().last().unwrap()).unwrap();
    assert_eq!(sheet["time_s"], total["time_s"]);
    assert_eq!(first["time_s"], total["time_by_tool"]["1"]);
}

/// A path that nobody knows is not 0, and one that is known in part is at least that.
#[test]
fn unknown_paths() {
    let place = place();
    let sheet = |program: &str| valid_sheet(&place, "path.nc", program);
    let text = || place.run(&["report", "path.nc", "--lang", "en"]).ends(0).stdout;
    let unknown = sheet("N1 G00 X0 Y0\nN2 G01 F100 M06 T3\nN3 G54 X5\nN4 G55 X9\nN5 M30\n");
    let tool = &unknown["tools"][1];
    assert!(tool.get("working_mm").is_none() && tool.get("working_lower_bound").is_none(), "{tool}");
    assert_eq!(tool["rapid_mm"], 0);
    assert!(text().contains("at least 0:00:00.0; blocks of unknown time: 3"), "{}", text());
    assert!(text().contains("at least 0:00:00.0  not known     0 mm"), "{}", text());
    assert_eq!(tool["time_lower_bound"], true);
    let motion = place.run(&["motion", "path.nc", "--lang", "en"]).ends(0).stdout;
    assert!(motion.lines().any(|line| line.starts_with("  T3 ") && line.ends_with("at least")), "{motion}");
    let part = sheet("N1 T3 M6\nN2 G01 X5 F100\nN3 X9\nN4 A90\nN5 M30\n");
    assert_eq!((&part["tools"][0]["working_mm"], &part["tools"][0]["working_lower_bound"]), (&json!(4), &json!(true)));
    assert!(text().contains("at least 4 mm"), "{}", text());
    // A motion of a rotary axis has no path in mm, and lacks none.
    let rotary = sheet("N1 G0 A0 T3 M6\nN2 G0 A0\nN3 G01 A90 F100\nN4 M30\n");
    assert_eq!(rotary["tools"][0]["working_mm"], 0);
    // Nobody knows what a fixed cycle that is not mapped moves.
    let cycle = sheet("N1 G0 X0 Y0 T3 M6\nN2 G81\nN3 X5\nN4 M30\n");
    assert!(cycle["tools"][0].get("working_mm").is_none(), "{cycle}");
}

/// Where axes stand while others work is a part of the work; so is the place of a hole that is drilled by Z alone.
#[test]
fn axes_that_stand_while_others_work() {
    let place = place();
    let extents = |program: &str| -> Value {
        place.put("reach.nc", format!("%1\n{program}"));
        let sheet = place.run(&["report", "reach.nc", "--format", "json"]).ends(0).stdout;
        serde_json::from_str::<Value>(&sheet).unwrap()
    };
    let holes = extents(
        "N1 G90 T1 M6 S900 M3\nN2 G0 X0 Y0 Z10\nN3 G1 Z0 F100\nN4 X10 Y5\nN5 G0 Z10\nN6 X50 Y40\nN7 G1 Z-5\n\
         N8 G0 Z10\nN9 M30\n",
    );
    let expected = json!({ "X": [0, 50], "Y": [0, 40], "Z": [-5, 10] });
    assert_eq!(holes["extents"]["working"], expected, "{holes}");
    assert_eq!(holes["tools"][0]["extents"], expected, "{holes}");
    // Y never moves here, and X stands at a place that nobody knows after its return.
    let unknown = extents("N1 G90 T1 M6 S900 M3\nN2 G0 X0 Z10\nN3 G1 X5 F100\nN4 G30 X0\nN5 G1 Z-5\nN6 Z-6\nN7 M30\n");
    let working = &unknown["extents"]["working"];
    assert_eq!(
        *working,
        json!({ "X": [0, 5], "Z": [-6, 10], "lower_bound": true, "lower_bound_axes": ["X"],
        "unknown_blocks": [5] }),
        "{unknown}"
    );
    // X works before anybody knows where it stands.
    let early = extents("N1 G90 T1 M6 S900 M3\nN2 G1 Z5 F100\nN3 G0 X7\nN4 G1 Z-5\nN5 M30\n");
    let working = &early["extents"]["working"];
    assert_eq!((&working["X"], &working["unknown_blocks"]), (&json!([7, 7]), &json!([2])), "{early}");
    // All motions reach as far as those that work.
    place.put("cnc872c.toml", "[start]\nX = 1\nY = 2\nZ = 80\n");
    let start = extents("N1 G90 T2 M6 S900 M3\nN2 G0 X10 Z50\nN3 G82 X3 Z-4\nN4 G80\nN5 G1 X5 Z5 F300\nN6 M30\n");
    assert_eq!([&start["extents"]["working"]["Y"], &start["extents"]["all"]["Y"]], [&json!([2, 2]); 2], "{start}");
}

/// Operands of arithmetic are read, its results are the program's own; a macrocycle of the machine runs as often as its
/// Q says; the F of a thread is no feed of working motion.
#[test]
fn what_the_sheet_counts() {
    let place = place();
    place.put("cnc872c.toml", "[operations]\n\"01\" = \"add\"\n[machine-macrocycles]\nL9001 = {}\n");
    place.put(
        "count.nc",
        "%1\nN1 G54 G90 T1 M06 S100 M03\nN2 G26 R5=01060708\nN3 G00 XR8 Y0\nN4 G94 G01 X5 F200\nN5 R20=1\nN6 XR20\n\
         N7 G72 L9001 Q7\nN8 G33 X9 F2\nN9 M30\n",
    );
    let args = ["report", "count.nc", "--format", "json", "--param", "R7=3"];
    let sheet: Value = serde_json::from_str(&place.run(&args).ends(0).stdout).unwrap();
    assert_eq!(sheet["parameters"], json!([{ "r": 6, "n": 2 }, { "r": 7, "n": 2, "value": 3 }]), "{sheet}");
    assert_eq!(sheet["units"][0]["runs"], 7, "{sheet}");
    assert_eq!(sheet["tools"][0]["feeds"], json!([{ "min": 200, "max": 200, "unit": "mm/min" }]), "{sheet}");
}

/// An extent whose motions are not all known says so, by axis and with the blocks, in each form.
#[test]
fn unknown_extents() {
    let place = place();
    let extents = |program: &str| valid_sheet(&place, "reach.nc", program);
    let cycle =
        "N1 G90 G0 X0 Y0 Z5 F100 S900 M3 T1 M6\nN2 G81 X50 Y40 Z-30\nN3 X80 Y90\nN4 G80\nN5 G1 X10 Y10\nN6 M30\n";
    let sheet = extents(cycle);
    let working = json!({ "X": [10, 10], "Y": [10, 10], "lower_bound": true, "lower_bound_axes": ["X", "Y", "Z"],
        "unknown_blocks": [2, 3] });
    let known = |sheet: &Value, of: &str| {
        let reach = &sheet["extents"][of];
        (reach["lower_bound"] == true, reach["unknown_blocks"].clone())
    };
    assert_eq!(known(&sheet, "working"), (true, working["unknown_blocks"].clone()), "{sheet}");
    assert_eq!(sheet["extents"]["working"]["lower_bound_axes"], working["lower_bound_axes"]);
    assert_eq!(known(&sheet, "all"), (true, json!([2, 3])));
    assert_eq!(sheet["tools"][0]["extents"]["unknown_blocks"], json!([2, 3]));
    for (form, says) in [("human", "without N2, N3"), ("markdown", "without N2, N3"), ("html", "without N2, N3")] {
        let text = place.run(&["report", "reach.nc", "--format", form, "--lang", "en"]).ends(0).stdout;
        assert!(text.contains("at least ") && text.contains(says), "{text}");
    }
    // G91 from the reference point, G91 alone, a parameter that the machine has.
    let from_reference =
        extents("N1 G90 G0 X0 Y0 Z6 S900 M3 T1 M6\nN2 G1 Z0 F100\nN4 G30 Z0\nN5 G91 X500\nN6 G1 Z-20\nN7 M30\n");
    assert_eq!(known(&from_reference, "working"), (true, json!([6])), "{from_reference}");
    let incremental = extents("N1 G91 G1 X10 F100 S900 M3\nN2 Z-5\nN3 M30\n");
    assert_eq!(known(&incremental, "working"), (true, json!([1, 2])));
    let parameter = extents("N1 G90 G0 X0 Y0 S900 M3\nN2 G1 X5 F100\nN3 XR50\nN4 X9\nN5 M30\n");
    assert_eq!(known(&parameter, "working"), (true, json!([3])), "{parameter}");
    // Behind a change of origin the start is counted from the old one.
    let origin =
        extents("N1 G90 G54 G0 X90 Z50 S900 M3\nN2 G1 X80 F100\nN3 G55\nN4 G1 X20 Z0\nN5 X30\nN6 G54 G0 Z70\nN7 M30\n");
    assert_eq!((known(&origin, "working"), &origin["extents"]["working"]["X"]), ((true, json!([4])), &json!([20, 90])));
    // The approach, from wherever it comes, leaves the extents whole.
    let whole = extents("N1 G90 G0 X0 Y0 Z5 S900 M3\nN2 G1 X5 F100\nN3 M30\n");
    assert_eq!((known(&whole, "working").0, known(&whole, "all").0), (false, false), "{whole}");
}

/// Working motions are a part of all motions; a motion that only turns lacks no path; F, S and D from parameters that
/// nobody knows are told beside the others; blocks of macrocycles are named with them.
#[test]
fn what_is_known_in_part() {
    let place = place();
    let sheet = |program: &str| valid_sheet(&place, "part.nc", program);
    let origin = sheet("N1 G90 G54 G0 X0 Y0 Z5 T1 M6\nN2 S9 M3 F100\nN3 G1 Z-1\nN4 G55\nN5 X50\nN6 Y50\nN7 M30\n");
    for part in ["working", "all"] {
        assert_eq!(origin["extents"][part]["lower_bound_axes"], json!(["X", "Y", "Z"]), "{origin}");
    }
    let turns = sheet("N1 G90 G0 X0 Y0 A0 T1 M6\nN2 G1 X9 F100\nN3 G54\nN4 A90\nN5 M30\n");
    let tool = &turns["tools"][0];
    assert_eq!((&tool["working_mm"], tool.get("working_lower_bound")), (&json!(9), None), "{turns}");
    let values = sheet("N1 G90 G0 X0 Y0 T1 M6\nN2 SR20 M3 FR21\nN3 G1 X9\nN4 S200 F5\nN5 X5\nN6 M30\n");
    let tool = &values["tools"][0];
    assert_eq!((&tool["undetermined"], &tool["speeds"]), (&json!(["F", "S"]), &json!([200, 200])), "{values}");
    let text = place.run(&["report", "part.nc", "--lang", "en"]).ends(0).stdout;
    assert!(text.contains("5 mm/min; partly not known") && text.contains("200 rev/min; partly not known"), "{text}");
    place.put("cnc872c.toml", "[cycles]\nG81 = 8100\n");
    place.put("L8100", "N1 G79 L8100\nN3 G1 Z-R2\nN9 G70\n");
    let cycle = sheet("N3 G90 G0 X0 Y0 Z5 T1 M6 S9 M3 F9\nN4 G81 X9\nN5 M30\n");
    assert_eq!(cycle["parameters"], json!([{ "r": 2, "n": 3, "l": 8100 }]), "{cycle}");
    let text = place.run(&["report", "part.nc", "--lang", "en"]).ends(0).stdout;
    assert!(text.contains("N3 (L8100)"), "{text}");
}

/// X of a lathe is a diameter, F is as it acts, S under constant cutting speed counts no revolutions.
#[test]
fn of_a_lathe() {
    let place = place();
    let program =
        "%1\nN1 G90 G74 G0 X100 Z5 T1 M6 S900 M3\nN2 G95 G1 X40 Z0 F0.25\nN3 Z-20\nN4 G96 S180 F200\nN5 X10\nN6 M30\n";
    place.put("lathe.nc", program);
    let sheet: Value =
        serde_json::from_str(&place.run(&["report", "lathe.nc", "--format", "json"]).ends(0).stdout).unwrap();
    assert_eq!((&sheet["diameter"], &sheet["extents"]["working"]["X"]), (&json!(true), &json!([10, 100])));
    let tool = &sheet["tools"][0];
    assert_eq!((&tool["speeds"], &tool["cutting_speeds"]), (&json!([900, 900]), &json!([180, 180])));
    let text = place.run(&["report", "lathe.nc", "--lang", "cs"]).ends(0).stdout;
    assert!(text.contains("X (průměr)") && text.contains("0.25 mm/ot") && !text.contains("mm/rev"), "{text}");
    assert!(text.contains("900 ot/min; 180 (konstantní řezná rychlost)"), "{text}");
    place.put("slow.nc", "%1\nN1 G0 G90 X0 Y0 T1 M6 S900 M3\nN2 G1 X5 F100 M37\nN3 G3 X5 Y10 I0 J5\nN4 M36 M30\n");
    let run = place.run(&["report", "slow.nc", "--format", "json", "--dialect", "cnc8x6"]).ends(0);
    let sheet: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(sheet["tools"][0]["feeds"][0]["max"], json!(1), "{sheet}");
    // A thread keeps its pitch.
    place.put("pitch.nc", "%1\nN1 G0 X0 T1 M6\nN2 S100 M3 M37 G95 F1.5\nN3 G33 X10\nN4 M30\n");
    let run = place.run(&["report", "pitch.nc", "--format", "json", "--dialect", "cnc8x6"]).ends(0);
    let sheet: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(sheet["tools"][0]["feeds"], json!([{ "unit": "mm/rev", "min": 1.5, "max": 1.5 }]), "{sheet}");
    let text = place.run(&["report", "slow.nc", "--lang", "en", "--dialect", "cnc8x6"]).ends(0).stdout;
    assert!(text.contains("20.708 mm"), "{text}");
}

#[test]
fn forms_for_people() {
    let place = place();
    let with =
        |arguments: &[&str]| place.run(&[&["report", "a.nc", "--param", "R11=7.5"], arguments].concat()).ends(0).stdout;
    let human = with(&["--lang", "en"]);
    assert!(human.starts_with("Set-up sheet: a.nc\n\nProgram  %7 \"FLANGE <1>\"\n"), "{human}");
    assert!(human.contains("subprogram L5  3"), "{human}");
    let markdown = with(&["--format", "markdown", "--lang", "cs"]);
    assert!(markdown.starts_with("# Seřizovací list: a.nc\n"), "{markdown}");
    assert!(markdown.contains("\"FLANGE \\<1\\>\"") && markdown.contains("| R11 | 7.5 | N100 |"), "{markdown}");
    let html = with(&["--format", "html", "--lang", "cs"]);
    assert!(html.contains("<html lang=\"cs\">") && html.contains("FLANGE &lt;1&gt;"), "{html}");
    assert!(html.contains("<td>podprogram L5</td><td>3</td>"), "{html}");
    assert!(!html.contains("<script") && !html.contains("http"), "{html}");
}

#[test]
fn faults() {
    let place = place();
    place.run(&["report", "bad.nc"]).ends(1).says("E0306");
    place.run(&["report", "missing.nc"]).ends(2).says("missing.nc");
    place.run(&["report", "a.nc", "-o", "a.nc"]).ends(2).says("another file belongs after -o");
    place.run(&["report", "a.nc", "-o", "sheet.html", "--format", "html"]).ends(0);
    assert!(place.read("sheet.html").starts_with(b"<!DOCTYPE html>"));
    // A call by a parameter that nobody knows: no end, and so no sheet.
    place.put("call.nc", "%1\nN1 G0 X0\nN2 G71 LR10\nN3 M30\nN4 G79 L5\nN5 G70\n");
    let run = place.run(&["report", "call.nc"]).ends(1);
    assert!(run.stderr.starts_with("error[W0503]") && !run.stderr.contains("no set-up sheet"), "{run:?}");
}

/// A macrocycle has no sheet, as it has no stream.
#[test]
fn of_a_macrocycle() {
    let run = place().run(&["report", "L9"]).ends(2);
    assert!(run.stderr.contains("E0112") && run.stderr.contains("name the program that calls it"), "{run:?}");
}
