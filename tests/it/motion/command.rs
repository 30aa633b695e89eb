//! `motion` on the real binary: its forms, and that they agree with one another, with the block stream and with the
//! rules.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::build::close;
use crate::cli::{BAD, Place, Run, closed_pipe};
use crate::json_schema::validator_for;

const CONFIG: &str = "[motion]\nprofile = \"parabolic\"\ncycle-ms = 2\naccuracy-um = 8\nsettle-ms = 20\nblock-gap-ms = 5\n\
                      raise-ms = 1\nmerge-length-mm = 0.5\nrapid-mm-min = { X = 12000, Z = 6000 }\n\
                      [motion.times]\nM06 = 6.5\nT = 0.2\n\
                      [motion.sets.1]\nparabolic = 50000\nlinear-mm-s2 = 600\ncentripetal-mm-s2 = 400\n\
                      [motion.sets.rapid]\nparabolic = 90000\nlinear-mm-s2 = 1200\n";

/// Motions of all kinds, a loop, a subprogram, functions, dwell, small blocks that are joined.
const PROGRAM: &str = "%1 \"TRY\"\nN10 G90 G17 G0 X0 Y0 Z10 T1 M6\nN20 G23 G94 G1 Z0 F500 S1000 M3\nN30 X50 F5000\nN40 X100\n\
                       N50 X100 Y50\nN60 G3 X90 Y60 I-10 J0\nN70 G1 X50\nN80 M8\nN90 X0\nN91 X-0.2\nN92 X-0.4 Y60.1\n\
                       N93 X-0.6\nN94 X-10\nN95 G71 L5 Q3\nN100 G4 Q150\nN105 T2 M6\nN110 G98 G0 Z50\nN120 M30\n\
                       N200 G79 L5\nN210 X0 Y0\nN220 X5 Y1\nN230 X10 Y0\nN240 X0 Y60 G70\n";

fn place() -> Place {
    Place::with(&[("a.nc", PROGRAM.as_bytes()), ("t.toml", CONFIG.as_bytes()), ("bad.nc", BAD.as_bytes())])
}

/// The records of a run, each valid.
fn records(run: &Run) -> Vec<Value> {
    let validator = validator_for(&cnc872c::analysis::motion::schema());
    let records: Vec<Value> = run.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    for record in &records {
        assert_eq!(validator.validate(record), Ok(()), "{record}");
    }
    records
}

fn number(record: &Value, field: &str) -> f64 {
    record[field].as_f64().unwrap_or_else(|| panic!("{field} of {record}"))
}

/// The machine, a record a block joined by `seq`, and a total that is the sum of the blocks.
#[test]
fn stream() {
    let place = place();
    for options in [vec![], vec!["--config", "t.toml"], vec!["--dialect", "cnc8x6"]] {
        let arguments = [vec!["motion", "a.nc", "--format", "json", "--phases"], options.clone()].concat();
        let run = place.run(&arguments).ends(0);
        let records = records(&run);
        let (machine, total) = (&records[0], records.last().unwrap());
        let blocks = &records[1..records.len() - 1];
        assert_eq!((&machine["kind"], &total["kind"]), (&json!("machine"), &json!("total")));
        assert_eq!(machine.get("assumed").is_some(), options != ["--config", "t.toml"]);
        let compiled = place.run(&[vec!["compile", "a.nc"], options].concat());
        let compiled: Vec<Value> = compiled.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        let compiled: Vec<&Value> = compiled.iter().filter(|record| record["kind"] == "block").collect();
        assert_eq!(compiled.len(), blocks.len());
        let (mut clock, mut by_tool) = (0.0, BTreeMap::new());
        for (block, compiled) in blocks.iter().zip(compiled) {
            for field in ["seq", "n", "file", "line"] {
                assert_eq!(block[field], compiled[field], "{block}");
            }
            assert!((number(block, "start_s") - clock).abs() < 1e-5, "{block}");
            clock += number(block, "duration_s");
            if let Some(tool) = compiled["tool"].as_i64() {
                *by_tool.entry(tool.to_string()).or_insert(0.0) += number(block, "duration_s");
            }
            check_motion(block, compiled);
        }
        close(number(total, "time_s"), clock, 1e-6);
        let types = total["time_by_type"].as_object().unwrap().values().map(|seconds| seconds.as_f64().unwrap());
        let parts = ["dwell_s", "function_s", "settle_s", "gap_s"].map(|field| number(total, field));
        close(types.sum::<f64>() + parts.iter().sum::<f64>(), number(total, "time_s"), 1e-6);
        for (tool, seconds) in by_tool {
            close(number(&total["time_by_tool"], &tool), seconds, 1e-6);
        }
        check_counts(blocks, total);
        assert!(number(total, "ideal_s") <= number(total, "time_s"));
        if let Some(seconds) = total["no_jerk_s"].as_f64() {
            assert!(number(total, "ideal_s") <= seconds && seconds <= number(total, "time_s"), "{total}");
        }
    }
}

/// Phases give the length and the velocities; TIME_DIST counts down to the end of the stretch.
fn check_motion(block: &Value, compiled: &Value) {
    let Some(phases) = block["phases"].as_array() else { return };
    let (mut way, mut seconds, mut velocity) = (0.0, 0.0, 0.0);
    for phase in phases {
        let [t, v, a, j] = [0, 1, 2, 3].map(|at| phase[at].as_f64().unwrap());
        if seconds == 0.0 {
            assert!((v * 60.0 - number(block, "start")).abs() < 1e-5, "{block}");
        }
        way += v * t + a * t * t / 2.0 + j * t * t * t / 6.0;
        velocity = v + a * t + j * t * t / 2.0;
        seconds += t;
    }
    assert!((velocity * 60.0 - number(block, "end")).abs() < 1e-3, "{block}");
    let length = block["piece_mm"].as_f64().or(compiled["motion"]["length_mm"].as_f64()).unwrap();
    close(way, length, 1e-6);
    assert!(number(block, "peak") <= number(block, "cap") * (1.0 + 1e-6), "{block}");
    if let Some(rest) = block["time_dist_s"].as_f64() {
        assert!(rest >= seconds - 1e-5, "{block}");
        if number(block, "end") == 0.0 {
            close(rest, seconds, 1e-5);
        }
    }
}

/// The total counts what the blocks say.
fn check_counts(blocks: &[Value], total: &Value) {
    let joints: Vec<&Value> = blocks.iter().filter_map(|block| block.get("joint")).collect();
    let count = |field: &str| {
        let mut counts: BTreeMap<&str, u64> = BTreeMap::new();
        for name in joints.iter().filter_map(|joint| joint[field].as_str()) {
            *counts.entry(name).or_default() += 1;
        }
        counts
    };
    let continuous: Vec<&&Value> = joints.iter().filter(|joint| joint["continuous"] == true).collect();
    assert_eq!(total["joints"]["continuous"], continuous.len());
    assert_eq!(total["joints"]["broken"], json!(count("broken_by")));
    let dots = count("dot");
    let dot = |name| dots.get(name).copied().unwrap_or(0);
    assert_eq!(total["dots"], json!({ "yellow": dot("yellow"), "red": dot("red") }));
    let limited: u64 = total["limited"].as_object().map_or(0, |limits| limits.values().filter_map(Value::as_u64).sum());
    assert_eq!(limited, continuous.len() as u64);
}

/// The values in force, and their sources.
#[test]
fn machine() {
    let place = place();
    let of = |arguments: &[&str]| {
        let run = place.run(&[&["motion", "a.nc", "--format", "json"], arguments].concat()).ends(0);
        records(&run).remove(0)
    };
    let machine = of(&["--config", "t.toml", "--set", "accuracy-um=4"]);
    assert_eq!(machine["accuracy_um"], 4);
    assert_eq!(machine["from"]["accuracy_um"], "--set");
    assert_eq!(machine["from"]["cycle_ms"], "motion.cycle-ms");
    assert_eq!(machine["from"]["angle_deg"], "default");
    assert_eq!(machine["rapid_axes_mm_min"], json!({ "X": 12000, "Z": 6000 }));
    assert_eq!(machine["times"], json!({ "M06": 6.5, "T": 0.2 }));
    assert_eq!(machine["sets"]["rapid"], json!({ "parabolic": 90000, "linear_mm_s2": 1200 }));
    assert!(machine.get("overload_mm_s2").is_none() && machine.get("assumed").is_none(), "{machine}");
    let assumed = of(&["--dialect", "cnc8x6"]);
    assert_eq!(assumed["assumed"], true);
    assert_eq!((&assumed["profile"], &assumed["shortest_block_ms"]), (&json!("ramps"), &json!(60)));
    place.put("r.toml", "dialect = \"cnc8x9\"\n[motion]\ncycle-ms = 2\n[machine-constants]\nR384 = \"00200008\"\n");
    let constants = of(&["--config", "r.toml"]);
    assert_eq!((&constants["accuracy_um"], &constants["red_percent"]), (&json!(8), &json!(20)));
    assert_eq!(
        (&constants["from"]["accuracy_um"], &constants["from"]["red_percent"]),
        (&json!("R384"), &json!("R384"))
    );
}

/// CSV has the same values in columns of the same names.
#[test]
fn csv() {
    let place = place();
    let json = place.run(&["motion", "a.nc", "--config", "t.toml", "--format", "json"]).ends(0);
    let csv = place.run(&["motion", "a.nc", "--config", "t.toml", "--format", "csv"]).ends(0);
    let blocks = records(&json);
    let mut lines = csv.stdout.split("\r\n");
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    for block in &blocks[1..blocks.len() - 1] {
        let cells: Vec<&str> = lines.next().unwrap().split(',').collect();
        assert_eq!(cells.len(), head.len());
        for (name, cell) in head.iter().zip(cells).filter(|(name, _)| **name != "motion") {
            let value = block.get(*name).or_else(|| block.get("joint")?.get(*name));
            match value {
                None => assert!(cell.is_empty() || cell == "false", "{name} {cell} {block}"),
                Some(Value::String(text)) => assert_eq!(cell, text),
                Some(other) => assert_eq!(cell, other.to_string(), "{name}"),
            }
        }
    }
    assert_eq!(lines.collect::<Vec<_>>(), [""]);
}

/// For people: what it rests on, times, joints with what would help; in both languages.
#[test]
fn account() {
    let place = place();
    let run = place.run(&["motion", "a.nc", "--lang", "en"]).ends(0);
    let first: Vec<&str> = run.stdout.lines().take(3).collect();
    assert!(first[0].starts_with("a.nc: 0:00:1") && first[0].ends_with(" without the approach"), "{}", first[0]);
    assert!(first[1].starts_with("The machine is assumed"), "{}", first[1]);
    assert!(first[2].contains("angle-deg 60") && first[2].contains("accel-mm-s2 500"), "{}", first[2]);
    assert!(run.stdout.contains("a.nc:4  N30 after N20: 90°; stop: angle; an arc in the corner"), "{}", run.stdout);
    assert!(run.stdout.contains("3 times"), "a joint in a loop is listed once: {}", run.stdout);
    let run = place.run(&["motion", "a.nc", "--config", "t.toml", "--lang", "cs"]).ends(0);
    assert!(run.stdout.contains("Nastaveno: profile parabolic, cycle-ms 2"), "{}", run.stdout);
    assert!(run.stdout.contains("Červená napojení"), "{}", run.stdout);
    let known = place.run(&["motion", "a.nc", "--config", "t.toml", "--set", "accuracy-um=1"]).ends(0);
    assert!(known.stdout.contains("  accuracy-um 8 → 1\n  time 0:"), "{}", known.stdout);
    assert!(known.stdout.contains("accuracy-um 1 (--set)"), "{}", known.stdout);
    let same = place.run(&["motion", "a.nc", "--config", "t.toml", "--set", "accuracy-um=8"]).ends(0);
    assert!(same.stdout.contains("  nothing differs\n"), "{}", same.stdout);
}

/// motion.md: every output says that the machine is assumed; a table on stderr.
#[test]
fn assumed_machines() {
    let place = place();
    let said = |arguments: &[&str]| place.run(&[&["motion", "a.nc"], arguments].concat()).ends(0).stderr;
    assert!(said(&["--format", "csv"]).contains("the machine of the estimate is assumed"));
    assert_eq!(said(&["--format", "csv", "--config", "t.toml"]), "");
    place.put("empty.toml", "[motion]\n");
    let run = place.run(&["motion", "a.nc", "--config", "empty.toml"]).ends(0);
    assert!(run.stdout.contains("\n[motion] gives no value, all are assumed."), "{}", run.stdout);
    place.put("table.toml", "[motion]\nrapid-mm-min = {}\n");
    let run = place.run(&["motion", "a.nc", "--config", "table.toml", "--format", "json"]).ends(0);
    assert!(!run.stdout.contains("{}"), "{}", run.stdout);
}

/// Edges: only the way to the first known position is an approach; other blocks without length are counted.
#[test]
fn approaches() {
    let place = Place::with(&[]);
    let total = |program: &str| {
        place.put("a.nc", format!("%1\n{program}"));
        let run = place.run(&["motion", "a.nc", "--lang", "en"]).ends(0);
        run.stdout.lines().next().unwrap().trim_start_matches("a.nc: ").to_owned()
    };
    for program in [
        "N1 G0 X0 Y0\nN2 G1 X10 F600\nN3 M30\n",
        "N1 G0 G54 X0 Y0\nN2 G0 Z5\nN3 G1 X10 F600\nN4 M30\n",
        "N1 G1 X0 Y0 Z5 F100\nN2 X10 F600\nN3 M30\n",
    ] {
        let total = total(program);
        assert!(total.starts_with("0:00:0") && total.ends_with(" without the approach"), "{program}: {total}");
    }
    for (program, blocks) in [
        // Working motions after a change of origin.
        ("N1 G00 X0 Y0\nN2 G01 F100 M06 T3\nN3 G54 X5\nN4 G55 X9\nN5 M30\n", 3),
        // The tool goes down from nobody knows where.
        ("N1 G0 X0 Y0\nN2 G1 Z-5 F100\nN3 G1 X10 F600\nN4 M30\n", 2),
        // X was known.
        ("N1 G0 X0 Y0\nN2 G0 G54 X5\nN3 G1 X10 F600\nN4 M30\n", 2),
    ] {
        let total = total(program);
        let lacks = format!("; blocks of unknown time: {blocks}");
        assert!(total.starts_with("at least ") && total.ends_with(&lacks), "{program}: {total}");
    }
}

/// A separate set for G00 is in force, with values from set 1 where it has none, and the key is not.
#[test]
fn rapid_set_in_force() {
    let place = place();
    let constants = "R338 = \"20\"\nR406 = \"1\"\nR407 = \"50000\"\nR408 = \"300\"\n";
    let of = |text: &str| {
        place.put("s.toml", format!("dialect = \"cnc8x9\"\n[motion]\ncycle-ms = 2\n{text}"));
        let run = place.run(&["motion", "a.nc", "--format", "json", "--config", "s.toml"]).ends(0);
        records(&run).remove(0)
    };
    let without = of(&format!("[machine-constants]\n{constants}"));
    assert_eq!((without.get("accel_rapid_mm_s2"), without["sets"].get("rapid")), (None, None));
    for text in [
        format!("[machine-constants]\n{constants}R430 = \"1\"\n"),
        format!("[motion.sets.rapid]\n[machine-constants]\n{constants}"),
    ] {
        let machine = of(&text);
        assert_eq!(machine["sets"]["rapid"], json!({ "parabolic": 50000, "linear_mm_s2": 300 }), "{text}");
        assert_eq!(machine["from"]["sets.rapid.parabolic"], "R407");
        assert!(machine.get("accel_rapid_mm_s2").is_none(), "{machine}");
        assert!(machine["from"].get("accel_rapid_mm_s2").is_none(), "{machine}");
    }
    // Values by parameter stay so; A of the keys.
    let by_parameter = "R338 = \"20\"\nR406 = \"11\"\nR407 = \"10\"\nR430 = \"1\"\n";
    let machine = of(&format!("[machine-constants]\nR52 = \"700\"\n{by_parameter}"));
    assert_eq!(machine["sets"]["rapid"], json!({ "parabolic": "R10", "linear_mm_s2": 700 }));
    assert_eq!(machine["from"]["sets.rapid.linear_mm_s2"], "R52");
    // With another profile sets do not count.
    let linear = of("profile = \"linear\"\n[motion.sets.rapid]\nlinear-mm-s2 = 300\n");
    assert_eq!(linear["accel_rapid_mm_s2"], 1000);
}

/// VEL-2: one number for G00 needs no length. A dot at M00 has advice; phases that rounding leaves are not written.
#[test]
fn details() {
    let place = Place::with(&[]);
    place.put("a.nc", "%1\nN1 G0 G90 X0\nN2 G23 G1 X10 F600\nN3 X20 M0\nN4 X30\nN5 M30\n");
    let run = place.run(&["motion", "a.nc", "--format", "json", "--phases"]).ends(0);
    let records = records(&run);
    assert_eq!((&records[1]["programmed"], records[1].get("cap")), (&json!(10000), None), "{}", records[1]);
    let run = place.run(&["motion", "a.nc", "--lang", "en"]).ends(0);
    let advice = "stop: M00 or M01; write M00 or M01 where the machine stops anyway";
    assert!(run.stdout.contains(advice), "{}", run.stdout);
}

/// An unknown P: the jerk is not limited, the time is a lower bound, and the output says so.
#[test]
fn unknown_p() {
    let place = Place::with(&[]);
    place.put("a.nc", "%1\nN1 G0 G90 X0\nN2 G23 G1 X60 F600\nN3 X90\nN4 M30\n");
    let constants = "R338 = \"20\"\nR406 = \"11\"\nR407 = \"10\"\nR408 = \"300\"\n";
    place.put(
        "cnc872c.toml",
        format!("dialect = \"cnc8x9\"\n[start]\nX = 5\n[motion]\ncycle-ms = 2\n[machine-constants]\n{constants}"),
    );
    let total = |arguments: &[&str]| {
        let run = place.run(&[&["motion", "a.nc", "--format", "json"], arguments].concat()).ends(0);
        let total = serde_json::from_str::<Value>(run.stdout.lines().last().unwrap()).unwrap();
        (total["lower_bound"] == true, run.stderr)
    };
    let (bound, said) = total(&[]);
    assert!(bound && said.contains("P is not known where it counts") && said.contains("such blocks: 3"), "{said}");
    assert_eq!(total(&["--param", "R10=50000"]), (false, String::new()));
    let run = place.run(&["motion", "a.nc"]).ends(0);
    assert!(run.stdout.starts_with("a.nc: at least 0:00:"), "{}", run.stdout);
    let sheet = place.run(&["report", "a.nc", "--format", "json"]).ends(0).stdout;
    assert_eq!(serde_json::from_str::<Value>(&sheet).unwrap()["lower_bound"], true);
}

/// `--set` names something that motion depends on.
#[test]
fn what_is_tried() {
    let place = place();
    let said = |set: &str| {
        let run = place.run(&["motion", "a.nc", "--set", set]).ends(2);
        assert_eq!(run.stdout, "");
        run.stderr
    };
    assert!(said("foo=1").contains("--set foo=1: foo is neither a key of [motion] nor a machine constant\n"));
    assert!(said("accuracy=1").contains("perhaps accuracy-um is meant"));
    assert!(said("R384=00200008").contains("on cnc872 [motion] describes the machine"));
    place.put("9.toml", "dialect = \"cnc8x9\"\n");
    let run = place.run(&["motion", "a.nc", "--config", "9.toml", "--set", "R56=91"]).ends(2);
    assert!(run.stderr.contains("--set R56=91: motion does not depend on R56"), "{run:?}");
    // The place is that of the option.
    let second = place.run(&["motion", "a.nc", "--set", "angle-deg=50", "--set", "accuracy-um=fast"]).ends(2);
    assert!(second.stderr.contains("[ --set:2:"), "{second:?}");
}

/// A constant of `--set` whose digits are choices is its digits, though it has no quotes: `10` is no 10.000.
#[test]
fn digits_that_are_tried() {
    let place = place();
    place.put("9.toml", "dialect = \"cnc8x9\"\n[machine-constants]\nR338 = \"00000000\"\n");
    let tried =
        |arguments: &[&str]| place.run(&[&["motion", "a.nc", "--config", "9.toml"], arguments].concat()).ends(0);
    for (value, profile) in [("10", "linear"), ("00000010", "linear"), ("0", "ramps"), ("10.0", "ramps")] {
        let set = format!("R338={value}");
        let run = tried(&["--set", &set, "--lang", "en"]);
        let basis: Vec<&str> = run.stdout.lines().take(3).filter(|line| line.starts_with("Configured: ")).collect();
        assert_eq!(basis, [format!("Configured: profile {profile} (--set)")], "{set}");
    }
    assert!(tried(&["--set", "R338=10", "--lang", "en"]).stdout.contains("\n  profile ramps → linear\n"));
}

/// More red joints than are listed.
#[test]
fn the_first_twenty() {
    let place = Place::with(&[]);
    let zigzag: String = (0..30).map(|at| format!("N{} X{} Y{}\n", at + 30, at, at % 2 * 9)).collect();
    place.put("a.nc", format!("%1\nN10 G90 G0 X0 Y0\nN20 G1 G23 X-1 F900\n{zigzag}N99 M30\n"));
    let listed = |arguments: &[&str]| {
        let run = place.run(&[&["motion", "a.nc", "--lang", "en"], arguments].concat()).ends(0);
        (run.stdout.matches(" after N").count(), run.stdout.contains("--all lists them"))
    };
    assert_eq!(listed(&[]), (20, true));
    assert_eq!(listed(&["--all"]), (31, false));
}

/// Red joints come in the order of what they cost, the most expensive first.
#[test]
fn the_most_expensive_joints_first() {
    let place = Place::with(&[]);
    let zigzag = |at: usize| format!("N{} X{at} Y{} F{}\n", at + 30, at % 2 * (at + 1), 300 * (at % 4 + 1));
    let zigzag: String = (0..8).map(zigzag).collect();
    place.put("a.nc", format!("%1\nN10 G90 G0 X0 Y0\nN20 G1 G23 X-1 F900\n{zigzag}N99 M30\n"));
    let run = place.run(&["motion", "a.nc", "--lang", "en"]).ends(0);
    let costs = run.stdout.lines().filter_map(|line| line.split_once("costs about ")?.1.strip_suffix(" s"));
    let costs: Vec<f64> = costs.map(|cost| cost.parse().unwrap()).collect();
    assert!(costs.len() > 5 && costs.is_sorted_by(|one, next| one >= next), "{}", run.stdout);
    assert!(costs.first() > costs.last(), "they differ: {}", run.stdout);
}

/// What a joint costs is what passing it saves: its ramps by A and P, and the wait where it is broken.
#[test]
fn what_a_joint_costs() {
    let program = "%1\nN5 G90 G94 G0 X0 Y0\nN10 G23 G01 X0 F3000\nN20 X200\nN30 X290 Y173.205\nN40 X500\nN50 M30\n";
    let place = Place::with(&[("a.nc", program.as_bytes())]);
    for config in [
        "profile = 'parabolic'\nraise-ms = 1\n[motion.sets.1]\nparabolic = 30000\nlinear-mm-s2 = 1000\n",
        "profile = 'linear'\naccuracy-um = 0\noverload-mm-s2 = 0\nsettle-ms = 500\n",
    ] {
        place.put("cnc872c.toml", format!("[motion]\n{config}"));
        let run = place.run(&["motion", "a.nc", "--lang", "en"]).ends(0);
        // G23 would not help beside G00.
        assert!(run.stdout.contains("N20 after N5: stop: G00; costs"), "{}", run.stdout);
        let costs = run.stdout.lines().filter(|line| line.contains(": 62.543°; stop: angle"));
        let costs = costs.filter_map(|line| line.split_once("costs about ")?.1.strip_suffix(" s"));
        let costs: f64 = costs.map(|cost| cost.parse::<f64>().unwrap()).sum();
        let time = |more: &[&str]| {
            let run = place.run(&[&["motion", "a.nc", "--format", "json"], more].concat()).ends(0);
            let total: Value = serde_json::from_str(run.stdout.lines().last().unwrap()).unwrap();
            total["time_s"].as_f64().unwrap()
        };
        let saved = time(&[]) - time(&["--set", "angle-deg=80"]);
        assert!(costs > 0.2 && (costs - saved).abs() < 0.02 * saved, "{costs} for {saved}: {config}");
    }
}

/// What counts as 0 because its time is not given is said in one line, in both languages.
#[test]
fn counted_as_nothing() {
    let place = Place::with(&[]);
    place.put("a.nc", "%1\nN10 G90 G0 X0 Y0 T1 M06\nN20 G1 X10 F100\nN30 T2 M06\nN40 X0\nN50 M30\n");
    let line = |config: &str, lang: &str, start: &str| {
        place.put("t.toml", config);
        let run = place.run(&["motion", "a.nc", "--config", "t.toml", "--lang", lang]).ends(0);
        let line = run.stdout.lines().find(|line| line.starts_with(start)).map(str::to_owned);
        line.unwrap_or_else(|| panic!("{start}: {}", run.stdout))
    };
    let (en, cs) = ("Count as 0, because no time is given: ", "S nulovým časem se počítají, protože čas není zadán: ");
    let (change, change_cs) = ("tool changes (M06 in [motion.times])", "výměny nástroje (M06 v [motion.times])");
    for config in ["", "[motion.times]\nM03 = 1.5\n"] {
        assert!(line(config, "en", en).contains(change), "{config}");
        assert!(line(config, "cs", cs).contains(change_cs), "{config}");
    }
    // The time of a change may be given as that of T.
    for config in ["[motion.times]\nM06 = 6.5\n", "[motion.times]\nT = 6.5\n"] {
        assert!(!line(config, "en", en).contains("M06"), "{config}");
    }
    // The time of a T in another block is that of the magazine. H and P are functions as M are.
    place.put("a.nc", "%1\nN10 G90 G0 X0 Y0\nN20 T1\nN30 G1 X10 F100\nN40 M06\nN50 M30\n");
    assert!(line("[motion.times]\nT = 0.2\n", "en", en).contains(change));
    place.put("a.nc", "%1\nN10 G90 G0 X0 Y0\nN20 H3\nN30 G1 X10 F100\nN50 M30\n");
    assert!(line("", "en", en).contains("functions ([motion.times])"));
    assert!(!line("[motion.times]\nH = 0.2\n", "en", en).contains("functions"));
}

/// Exit status, and what is left when a program has no time.
#[test]
fn faults() {
    let place = place();
    place.run(&["motion", "bad.nc"]).ends(1).says("E0306");
    let bad = place.run(&["motion", "bad.nc", "--format", "json"]).ends(1);
    assert!(bad.stderr.contains("E0306") && bad.stdout.is_empty(), "{bad:?}");
    assert_eq!(place.run(&["motion", "bad.nc", "--format", "csv"]).ends(1).stdout, "");
    place.run(&["motion", "missing.nc"]).ends(2).says("missing.nc");
    place.run(&["motion", "a.nc", "--set", "accuracy-um"]).ends(2).says("--set accuracy-um");
    place.run(&["motion", "a.nc", "--set", "accuracy-um=fast"]).ends(2).says("E0702");
    let bound = place.run(&["motion", "a.nc", "--set", "accuracy-um=8"]).ends(0);
    assert!(bound.stdout.contains("Ts (cycle-ms) is not known") && bound.stderr.contains("W0707"), "{bound:?}");
    let bound = place.run(&["motion", "a.nc", "--set", "accuracy-um=8", "--format", "json"]).ends(0);
    assert!(bound.stdout.contains("\"lower_bound\":true"), "{bound:?}");
    let rapid = place.run(&["motion", "a.nc", "--set", "rapid-mm-min.X=3000", "--set", "rapid-mm-min.Y=4000"]).ends(0);
    assert!(rapid.stdout.contains("rapid-mm-min 10000 → "), "{rapid:?}");
    place.run(&["motion", "a.nc", "--phases"]).ends(2).says("--format json");
    place.run(&["motion", "a.nc", "-o", "a.nc"]).ends(2).says("another file belongs after -o");
    place.put("endless.nc", "%1\nN10 G0 X0\nN20 G1 X5 F100\nN30 G73 N20\nN40 M30\n");
    let endless = place.run(&["motion", "endless.nc", "--format", "json", "--max-blocks", "50"]).ends(1);
    assert!(!endless.stdout.contains("\"total\""), "{}", endless.stdout);
    assert_eq!(place.run_into(&["motion", "a.nc", "--format", "json"], closed_pipe()).code, Some(0));
    place.run(&["motion", "a.nc", "-o", "a.txt"]).ends(0);
    assert!(place.read("a.txt").starts_with(b"a.nc: "));
}
