//! `plc` on the real binary: forms, parts, files, exit status.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::cli::{BAD, Place, Run};
use crate::json_schema::validator_for;

const PROGRAM: &str = "%1 \"STUL\"\nN10 G0 G90 X0 Y0 Z50\nN20 T12 M06\nN30 S1500 M03\nN40 G1 Z-2 F200\nN50 X40 M08\nN60 M00\n\
                       N70 G0 Z50 M05\nN80 M30\n";

impl Run {
    /// Asserts that this went to stdout.
    #[track_caller]
    fn prints(self, text: &str) -> Self {
        assert!(self.stdout.contains(text), "{self:?}");
        self
    }
}

fn place() -> Place {
    Place::with(&[("a.nc", PROGRAM.as_bytes()), ("bad.nc", BAD.as_bytes())])
}

#[test]
fn a_line_for_each_step_that_changes_a_signal() {
    let place = place();
    let run = place.run(&["plc", "a.nc", "--signals", "M0*PI,PB06,ZMM2PI"]).ends(0);
    let lines: Vec<String> =
        run.stdout.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    assert_eq!(
        lines[..6],
        [
            "0 N10 2 PB06=05h",
            "2 N30 4 ZMM2PI=1 PB06=03h M03PI=1",
            "3 N40 5 ZMM2PI=0",
            "4 N50 6 M08PI=1",
            "5 N60 7 stop ZMM2PI=1 PB06=05h M03PI=0 M08PI=0",
            "6 N70 8 M08PI=1",
        ]
    );
    let all = place.run(&["plc", "a.nc", "--signals", "PB06", "--all"]).ends(0);
    assert_eq!(all.stdout.lines().count(), 9);
}

/// JSON Lines against their schema: all signals in the first step, then those that change; the end.
#[test]
fn json() {
    let schema = cnc872c::analysis::plc::schema();
    let validator = validator_for(&schema);
    let place = place();
    let run = place.run(&["plc", "a.nc", "--format", "json", "--signals", "PB06,BLK.M[9],BLK.AxNC[2]"]).ends(0);
    let records: Vec<Value> = run.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    for record in &records {
        assert!(validator.is_valid(record), "{record}");
    }
    assert_eq!(records[0]["kind"], "plc");
    assert_eq!(records[0]["schema"], "cnc872c.plc/1");
    assert_eq!(records[0]["signals"], serde_json::json!(["BLK.M[9]", "BLK.AxNC[2]", "PB06"]));
    assert_eq!(records[1]["signals"], serde_json::json!({"BLK.M[9]": null, "BLK.AxNC[2]": 50, "PB06": 5}));
    assert_eq!(records[2]["signals"], serde_json::json!({"BLK.M[9]": 6}));
    assert_eq!(records[7]["stop"], true);
    assert_eq!(records.last().unwrap(), &serde_json::json!({"kind": "end", "reason": "M30", "blocks": 8}));
    let written = place.run(&["schema", "plc"]).ends(0);
    assert_eq!(serde_json::from_str::<Value>(&written.stdout).unwrap(), schema);
    let part =
        place.run(&["plc", "a.nc", "--format", "json", "--signals", "PB06", "--from", "5", "--limit", "1"]).ends(0);
    let seqs: Vec<Value> = part
        .stdout
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).unwrap())
        .filter(|record| record["kind"] == "step")
        .collect();
    assert_eq!(seqs.len(), 2);
    assert_eq!((&seqs[0]["seq"], &seqs[0]["signals"]["PB06"]), (&5.into(), &3.into()));
    assert!(part.stdout.ends_with("\"blocks\":8}\n"));
}

/// Another file is named before its first step, which separates its lines from others in the table.
#[test]
fn macrocycles() {
    let place = Place::with(&[("a.nc", b"%1\nN10 G72 L5 Q2\nN20 M30\n"), ("L5", b"N1 G79 L5\nN2 M92 G70\n")]);
    let run = place.run(&["plc", "a.nc", "--format", "json", "--signals", "BLK.M14"]).ends(0);
    let kinds: Vec<String> = run
        .stdout
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).unwrap()["kind"].as_str().unwrap().to_owned())
        .collect();
    assert_eq!(kinds, ["plc", "step", "file", "step", "step", "step", "step", "step", "end"]);
    let table = place.run(&["plc", "a.nc", "--signals", "BLK.M14"]).ends(0);
    assert!(table.stdout.lines().next().unwrap().contains("L5:2"), "{}", table.stdout);
    let found = place.run(&["plc", "a.nc", "--find", "BLK.M14"]).ends(0);
    assert_eq!(found.stdout, "L5:2:1: N2 seq=2 BLK.M14=1\nL5:2:1: N2 seq=4 BLK.M14=1\n");
}

#[test]
fn conditions() {
    let place = place();
    let found = place.run(&["plc", "a.nc", "--find", "M03PI & !M08PI & PO_OSZPI"]).ends(0);
    assert_eq!(found.stdout, "a.nc:5:1: N40 seq=3 M03PI=1 M08PI=0 PO_OSZPI=1\n");
    let stop = place.run(&["plc", "a.nc", "--find", "rising(PB06 == 05h)", "--from", "1", "--limit", "5"]).ends(0);
    assert_eq!(stop.stdout, "a.nc:7:1: N60 seq=5 stop PB06=05h\n");
    assert_eq!(place.run(&["plc", "a.nc", "--find", "rising(AUTPI)"]).ends(0).stdout.lines().count(), 1);
    assert_eq!(place.run(&["plc", "a.nc", "--find", "M19PI"]).ends(1).stdout, "");
    place.run(&["plc", "a.nc", "--find", "M03PI", "--from", "7"]).ends(1);
    place.run(&["plc", "bad.nc", "--find", "M03PI"]).ends(2).says("E0306");
    let wrong = place.run(&["plc", "a.nc", "--find", "M03PI && BLK.M[11] == 95"]).ends(2);
    let wrong = ["E0903", "--find:1:7", "write `&`", "E0904", "write `95h`"]
        .into_iter()
        .fold(wrong, |run, text| run.says(text));
    assert!(!wrong.stderr.contains("check --fix"));
    place.run(&["plc", "a.nc", "--find", "STOPPI", "--lang", "cs"]).ends(2).says("nastavuje ji sám PLC program");
    place.run(&["plc", "a.nc", "--find", "BLK.M1", "--dialect", "cnc8x6"]).ends(2).says("no command block");
    place.run(&["plc", "a.nc", "--find", "M03PI", "--format", "json"]).ends(2).says("cannot be used with");
    place.run(&["plc", "a.nc", "--find", "M03PI", "-o", "found.txt"]).ends(0);
    assert!(String::from_utf8(place.read("found.txt")).unwrap().starts_with("a.nc:4:1: N30"));
    place.run(&["plc", "a.nc", "--find", "M19PI", "-o", "found.txt"]).ends(1);
    assert_eq!(place.read("found.txt"), b"");
}

/// W0901 marks its place, once, and not with a condition.
#[test]
fn what_does_not_fit() {
    let place = Place::with(&[("a.nc", b"%1\nN10 M100\nN20 G73 L10 Q3\nN30 M30\n")]);
    let run = place.run(&["plc", "a.nc", "--compat"]).ends(0);
    assert_eq!(run.stderr.matches("W0901").count(), 2, "the finding, and its code in the last line");
    assert!(!place.run(&["plc", "a.nc"]).ends(0).stderr.contains("W0901"));
    assert!(!place.run(&["plc", "a.nc", "--find", "PB16 == 00h"]).ends(0).stderr.contains("W0901"));
    place.run(&["plc", "a.nc", "--compat", "-D", "W0901", "-o", "out"]).ends(1);
    assert_eq!(place.list(), ["a.nc"]);
}

/// A file is whole or as it was.
#[test]
fn files() {
    let place = place();
    for format in ["table", "json", "csv", "vcd"] {
        place.run(&["plc", "a.nc", "--format", format, "-o", "out"]).ends(0);
        let whole = place.read("out");
        assert!(!whole.is_empty());
        let printed = place.run(&["plc", "a.nc", "--format", format, "-o", "-"]).ends(0);
        assert_eq!(printed.stdout.as_bytes(), whole);
        place.run(&["plc", "bad.nc", "--format", format, "-o", "out"]).ends(1).says("E0306");
        assert_eq!(place.read("out"), whole);
    }
    place.run(&["plc", "a.nc", "-o", "a.nc"]).ends(2).says("another file belongs after -o");
    place.run(&["plc", "missing.nc"]).ends(2).says("E0112");
    assert_eq!(place.read("a.nc"), PROGRAM.as_bytes());
}

#[test]
fn names_that_are_none() {
    let place = place();
    place.run(&["plc", "a.nc", "--signals", "ZMM10P"]).ends(2).says("perhaps `ZMM10PI` is meant");
    place.run(&["plc", "a.nc", "--signals", "PB06,MP*"]).ends(2).says("a part program does not determine it");
    place
        .run(&["plc", "a.nc", "--signals", "BLK.T", "--dialect", "cnc8x9"])
        .ends(2)
        .says("cnc8x9 has no command block");
    place.run(&["plc", "a.nc", "--find", "SF_*"]).ends(2).says("a part program does not determine it");
    place.run(&["plc", "a.nc", "--find", "ZMM*"]).ends(2).says("`*` has no meaning in a condition");
    place.run(&["plc"]).ends(2).says("<FILE>");
}

/// The list of the control: a signal a line, with the letters of the machine.
#[test]
fn lists() {
    let place = Place::with(&[(
        "cnc872c.toml",
        b"[[axes]]\nletter = \"X\"\nkind = \"linear\"\n[[axes]]\nletter = \"Z\"\nkind = \"linear\"\n",
    )]);
    let run = place.run(&["plc", "--list"]).ends(0);
    let line = |name: &str| {
        let text = &run.stdout;
        let found = text.lines().find(|line| line.split_whitespace().next() == Some(name));
        found.unwrap_or_else(|| panic!("{name}")).to_owned()
    };
    assert!(line("PO_OSZPI").ends_with("axis Z: Z"), "{}", line("PO_OSZPI"));
    assert!(line("BLK.AxNC1Move").ends_with(": Z") && line("PO_OSYPI").ends_with("axis Y"));
    assert!(line("BLK.AxNC[2]").ends_with("[mm, deg]"));
    assert!(line("BLK.M[11]").contains("dword"));
    let old = place.run(&["plc", "--list", "--dialect", "cnc8x6", "--lang", "cs"]).ends(0);
    assert!(!old.stdout.contains("BLK.") && old.stdout.contains("změnový bit 10. skupiny M"));
    let json: Value = serde_json::from_str(&place.run(&["plc", "--list", "--format", "json"]).ends(0).stdout).unwrap();
    let signals = json["signals"].as_array().unwrap();
    let found = signals.iter().find(|signal| signal["name"] == "PO_OSZPI").unwrap();
    assert_eq!((&found["axis"], &found["type"], &found["source"]), (&"Z".into(), &"bit".into(), &"S0 8.1.7".into()));
    place.run(&["plc", "--list", "--format", "vcd"]).ends(2).says("--format json");
}

#[test]
fn explained() {
    let place = Place::with(&[]);
    place.run(&["explain", "ZMM10PI"]).ends(0).prints("change bit of M group 10");
    place.run(&["explain", "BLK[0].M[11]", "--lang", "cs"]).ends(0).prints("funkce 11. skupiny M");
    place.run(&["explain", "STOPPI", "MPxPI"]).ends(0).prints("A part program does not determine it");
    place.run(&["explain", "ZMM10P"]).ends(2).says("ZMM10PI");
}

const MOTION: &str = "[motion]\nprofile = \"parabolic\"\n[motion.times]\nM06 = 6.5\nM03 = 1.5\n[motion.sets.1]\nparabolic = 5000\n\
                      linear-mm-s2 = 500\n[motion.sets.2]\nparabolic = 7501\nlinear-mm-s2 = 800.5\n";

const CONTINUOUS: &str = "%1\nN10 G0 G90 X0 Y0 Z0\nN20 M3 S100\nN30 G23 G1 X20 F3000\nN40 X40\nN50 X60 Y1\nN60 G4 Q100\n\
                          N70 G23 I2 X80\nN80 M0\nN90 G98 X100\nN99 M30\n";

/// The cells of a table with a head, by column.
fn columns(text: &str) -> Vec<BTreeMap<String, String>> {
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| head.iter().map(|name| (*name).to_owned()).zip(line.split(',').map(str::to_owned)).collect();
    lines.map(row).collect()
}

/// PLC-15, TIM-2, S0 8.4.4: steps start when `motion` says that their blocks do; a stop at the end of its block.
/// TIME_DIST is in whole ms, in stretches of two blocks or more. In a dump each step is later than the one before.
#[test]
fn times() {
    let place = Place::with(&[("a.nc", CONTINUOUS.as_bytes()), ("cnc872c.toml", MOTION.as_bytes())]);
    let run = |arguments: &[&str]| place.run(arguments).ends(0).stdout;
    let motion = columns(&run(&["motion", "a.nc", "--format", "csv"]));
    let steps = columns(&run(&["plc", "a.nc", "--signals", "G23ACT,TIME_DIST", "--format", "csv"]));
    let number = |text: &str| text.parse::<f64>().unwrap();
    for block in &motion {
        let of_block: Vec<_> = steps.iter().filter(|step| step["seq"] == block["seq"]).collect();
        assert_eq!(of_block[0]["start_s"], block["start_s"]);
        if let Some(stop) = of_block.get(1) {
            assert_eq!(stop["stop"], "1");
            let end = number(&block["start_s"]) + number(&block["duration_s"]);
            assert!((number(&stop["start_s"]) - end).abs() < 2e-6);
        }
    }
    let shown: Vec<String> = steps.iter().map(|step| format!("{} {}", step["G23ACT"], step["TIME_DIST"])).collect();
    let ms = |seq: usize| format!("1 {:.0}", number(&motion[seq]["time_dist_s"]) * 1000.0);
    let none = || "0 ".to_owned();
    // A stretch of one block, seq 6, is none for the PLC.
    let wanted = [none(), none(), ms(2), ms(3), ms(4), none(), none(), none(), none(), none(), none()];
    assert_eq!(shown, wanted);
    assert_eq!(steps.len(), 11);

    // Every form says the same times.
    let validator = validator_for(&cnc872c::analysis::plc::schema());
    let records: Vec<Value> = run(&["plc", "a.nc", "--signals", "TIME_DIST,M03PI", "--format", "json"])
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert!(records.iter().all(|record| validator.is_valid(record)));
    let starts: Vec<f64> = records.iter().filter_map(|record| record["start_s"].as_f64()).collect();
    assert_eq!(starts, steps.iter().map(|step| number(&step["start_s"])).collect::<Vec<_>>());
    let dump = run(&["plc", "a.nc", "--signals", "M03PI", "--format", "vcd"]);
    let times: Vec<u64> = dump.lines().filter_map(|line| line.strip_prefix('#')?.parse().ok()).collect();
    assert_eq!(times.len(), steps.len() + 1, "a last time closes the last step");
    assert!(times.is_sorted_by(|a, b| a < b), "{times:?}");
    for (time, start) in times.iter().zip(&starts) {
        let late = *time as f64 - start * 1e6;
        assert!((-0.5..3.0).contains(&late), "{time} {start}");
    }

    let found = run(&["plc", "a.nc", "--find", "rising(G23ACT) & TIME_DIST > 1000"]);
    assert!(found.starts_with("a.nc:4:1: N30 seq=2 G23ACT=1 TIME_DIST="), "{found}");
}

/// PLC-6, S0 8.4.6: P/500 and A of the dynamic set in force, in G23 and under G00.
#[test]
fn dynamic_sets() {
    let place = Place::with(&[("a.nc", CONTINUOUS.as_bytes()), ("cnc872c.toml", MOTION.as_bytes())]);
    let text = place.run(&["plc", "a.nc", "--format", "csv"]).ends(0).stdout;
    let cells: Vec<String> =
        columns(&text).iter().map(|step| format!("{} {}", step["BLK.ParabAccel"], step["BLK.LinearAccel"])).collect();
    let (first, second) = ("10 500", "15.002 800.5");
    assert_eq!(cells, [first, first, first, first, first, first, second, second, second, " ", " "]);
    // With another profile the dynamic sets do not count; without [motion] the signals are not among the default.
    place.put("cnc872c.toml", "[motion]\nprofile = \"linear\"\n");
    let text = place.run(&["plc", "a.nc", "--compat", "--format", "csv"]).ends(0).stdout;
    assert!(columns(&text).iter().all(|step| step["BLK.ParabAccel"].is_empty() && !step["start_s"].is_empty()));
    assert!(text.lines().next().unwrap().ends_with(",G23ACT,TIME_DIST"));
    place.put("cnc872c.toml", "");
    let text = place.run(&["plc", "a.nc", "--compat", "--format", "csv"]).ends(0).stdout;
    let head = text.lines().next().unwrap();
    assert!(["ParabAccel", "LinearAccel", "G23ACT", "TIME_DIST"].iter().all(|name| !head.contains(name)));
    assert!(columns(&text).iter().all(|step| step["start_s"].is_empty()));
}

/// PLC-15, CNT-4: blocks that `merge-length-mm` joins lie in the stretch of their piece.
#[test]
fn joined_blocks() {
    let place = Place::with(&[
        (
            "a.nc",
            b"%1\nN10 G90 G00 X0 Y0 Z0 F1000\nN20 G01 G23 X10\nN30 X10.2\nN40 X10.4\nN50 X20\nN60 X20.1\nN70 M30\n",
        ),
        ("cnc872c.toml", b"[motion]\nmerge-length-mm=0.5\n"),
    ]);
    let text = place.run(&["plc", "a.nc", "--signals", "G23ACT,TIME_DIST", "--format", "csv"]).ends(0).stdout;
    let cells: Vec<String> =
        columns(&text).iter().map(|step| format!("{} {}", step["G23ACT"], step["TIME_DIST"])).collect();
    assert_eq!(cells, ["0 ", "1 1239", "1 623", "1 623", "1 623", "1 0", "0 "]);
}

/// Without `[motion]` a condition on motion is refused with that reason, and so is a choice of nothing else.
#[test]
fn what_needs_motion_says_so() {
    let place = place();
    place.run(&["plc", "a.nc", "--find", "TIME_DIST > 5"]).ends(1).says("TIME_DIST: no value without [motion]");
    place.run(&["plc", "a.nc", "--find", "M03PI & !G23ACT", "--lang", "cs"]).ends(1).says("G23ACT: bez [motion]");
    place.run(&["plc", "a.nc", "--signals", "G23ACT,TIME_DIST"]).ends(0).says("G23ACT, TIME_DIST: no value");
    for arguments in [&["--signals", "*"][..], &["--signals", "M03PI,G23ACT"], &["--find", "M03PI"], &["--compat"]] {
        let run = place.run(&[&["plc", "a.nc"], arguments].concat()).ends(0);
        assert!(run.stderr.is_empty(), "{run:?}");
    }
    place.put("cnc872c.toml", "[motion]\nprofile = \"linear\"\n");
    assert!(place.run(&["plc", "a.nc", "--find", "TIME_DIST > 5"]).ends(1).stderr.is_empty());
}

/// W0901 as an error: every place, and no end of the output.
#[test]
fn denied_bytes() {
    let place = Place::with(&[("a.nc", b"%1\nN1 G0 X0 H100\nN2 H-1\nN3 G73 L1 Q3\nN9 M30\n")]);
    for format in ["table", "json"] {
        let run = place.run(&["plc", "a.nc", "--signals", "PB05", "-D", "W0901", "--format", format]).ends(1);
        assert_eq!(run.stderr.matches("error[W0901]").count(), 2, "{run:?}");
        assert!(!run.stdout.contains("\"end\""), "{run:?}");
    }
}

/// BZH is a kind of bytes: its name gets the answer that its members get.
#[test]
fn names_of_kinds() {
    let place = place();
    let run = place.run(&["explain", "BZH"]).ends(0);
    assert!(run.stdout.contains("BZH10"), "{run:?}");
    place.run(&["plc", "a.nc", "--signals", "BZH"]).ends(2).says("BZH08PI");
    place.run(&["plc", "a.nc", "--find", "BZH"]).ends(2).says("BZH08PI");
}
