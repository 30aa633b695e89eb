//! `restart`: programs that start in the middle.

use std::path::Path;

use cnc872c::analysis::state::{Asked, Place as At};
use cnc872c::dict::{Decimal, Lang};
use cnc872c::restart::{Answer, Options, Restart, restart};
use cnc872c::session::{Part, Session};
use serde_json::Value;

use crate::cli::{BAD, Place, Run};
use crate::state::{Sample, samples};

const OPTIONS: Options = Options { safe: None, clearance: Decimal::from_thousandths(2000), all_m: true };

fn at(seq: u64) -> Asked {
    Asked { place: At::Seq(seq), file: None, pass: None, after: false }
}

/// The block records of a program that replaces the sample's.
fn records(sample: &Sample, text: &str) -> Vec<Value> {
    let loader = Over { sample, text };
    let session = Session { loader: &loader, settings: &sample.settings, progress: None };
    let mut out = Vec::new();
    let run = session.compile(Path::new(&sample.file), &sample.file, Part::default(), &mut out).unwrap();
    assert!(run.whole.is_some(), "{}\n{text:.2500}\n{:#?}", sample.name, run.outcome.findings.items());
    let records = std::str::from_utf8(&out).unwrap().lines().map(|line| serde_json::from_str(line).unwrap());
    records.filter(|record: &Value| record["kind"] == "block").collect()
}

/// A text over the files of a sample.
struct Over<'a> {
    sample: &'a Sample,
    text: &'a str,
}

impl cnc872c::text::Loader for Over<'_> {
    fn read(&self, path: &Path) -> std::io::Result<Vec<u8>> {
        if path == Path::new(&self.sample.file) {
            Ok(self.text.as_bytes().to_vec())
        } else {
            self.sample.disk.read(path)
        }
    }

    fn list(&self, folder: &Path) -> Vec<std::path::PathBuf> {
        self.sample.disk.list(folder)
    }

    fn folders(&self, folder: &Path) -> Vec<std::path::PathBuf> {
        self.sample.disk.folders(folder)
    }

    fn canonical(&self, path: &Path) -> std::path::PathBuf {
        self.sample.disk.canonical(path)
    }
}

/// Fields that say where a block stands.
const WHERE: [&str; 7] = ["seq", "n", "file", "line", "column", "calls", "first_block"];
/// Fields that differ where calls and loops are written out.
const FLAT: [&str; 4] = ["jump", "g_set", "params", "comments"];

/// The record without what may differ; `flat`: it is of a block of a call or a loop that is written out.
fn comparable(record: &Value, flat: bool, lacks: bool) -> Value {
    let mut record = record.clone();
    let object = record.as_object_mut().unwrap();
    for key in WHERE.iter().chain(if flat { &FLAT[..] } else { &[] }) {
        object.remove(*key);
    }
    if flat {
        object["g"][7] = Value::Null;
    }
    if lacks && let Some(motion) = object.get_mut("motion").and_then(Value::as_object_mut) {
        for key in ["length_mm", "length_deg", "length_missing"] {
            motion.remove(key);
        }
    }
    record
}

/// Whether a block of the old program does nothing outside of calls and jumps.
fn does_nothing(record: &Value) -> bool {
    let flow = |g: &Value| [70, 71, 72, 73, 79].contains(&g.as_u64().unwrap());
    let g_set = record["g_set"].as_array().is_none_or(|list| list.iter().all(flow));
    let other = ["m_set", "motion", "data", "params", "words", "opaque_call"];
    let set = ["t_set", "h_set", "p_set", "d_set", "s_set", "f_set"];
    g_set && other.iter().chain(&set).all(|key| record.get(key).is_none())
}

/// RST-5: the stream of the rest is that of the full run.
fn compare(sample: &Sample, blocks: &[Value], seq: usize, made: &Restart) {
    let text = made.text();
    let shown: String = text.chars().take(2500).collect();
    let new = records(sample, &text);
    let mut new = new.iter().skip(made.preamble as usize);
    let from = made.text_from.unwrap_or(u64::MAX) as usize;
    for (at, old) in blocks.iter().enumerate().skip(seq) {
        let in_cycle =
            old["calls"].as_array().is_some_and(|calls| calls.iter().any(|call| call["by"].as_str() > Some("G80")));
        let flat = at < from && !in_cycle;
        if flat && does_nothing(old) && old.get("length_correction") == blocks[at.max(1) - 1].get("length_correction") {
            continue;
        }
        let Some(other) = new.next() else { panic!("{} seq {seq}: {at} is missing\n{shown}", sample.name) };
        let missing = |record: &Value| record["motion"].get("length_missing").cloned();
        let lacks = missing(old).is_some_and(|why| why == "origin" || missing(other).is_some());
        let (old, other) = (comparable(old, flat, lacks), comparable(other, flat, lacks));
        assert_eq!(old, other, "{} seq {seq}, at {at}\n{shown}", sample.name);
    }
    assert_eq!(new.next(), None, "{} seq {seq}\n{shown}", sample.name);
}

/// RST-2: nothing moves in rapid across below the top, and nothing goes down in rapid further than the clearance.
fn comes_from_above(sample: &Sample, made: &Restart) {
    let text = made.text();
    let shown: String = text.chars().take(2500).collect();
    let new = records(sample, &text);
    let tool = sample.settings.machine.tool_axis.map_or_else(|| "Z".to_owned(), |axis| axis.to_string());
    let approach: Vec<&Value> =
        new.iter().take(made.preamble as usize).filter(|record| record["motion"].is_object()).collect();
    let heights = approach.iter().filter_map(|record| record["position"][&tool].as_f64());
    let top = heights.fold(f64::NEG_INFINITY, f64::max);
    let place = approach.last().and_then(|record| record["position"][&tool].as_f64());
    for record in approach {
        let motion = &record["motion"];
        let axes: Vec<&str> = motion["axes"].as_array().unwrap().iter().map(|axis| axis.as_str().unwrap()).collect();
        let height = record["position"][&tool].as_f64();
        let across = axes.iter().any(|axis| *axis != tool);
        assert!(!(across && axes.contains(&tool.as_str())), "{} moves down and across\n{shown}", sample.name);
        if motion["type"] == "rapid" {
            let low = if across { top } else { place.unwrap_or(0.0) + 2.0 };
            assert!(
                height.is_none_or(|height| height >= low - 1e-9 || height >= top),
                "{} {record}\n{shown}",
                sample.name
            );
        } else if motion["type"] != "reference" {
            assert_eq!((motion["type"].as_str(), height), (Some("linear"), place), "{}\n{shown}", sample.name);
        }
    }
}

/// RST-1, RST-3, RST-4, RST-5: at places all over the samples a program starts as the full run goes on, or it says why
/// not.
#[test]
fn starts_all_over_the_samples() {
    let (mut made, mut refused, mut flat) = (0, std::collections::BTreeMap::<String, u32>::new(), 0);
    let places: usize = std::env::var("RESTART_PLACES").ok().and_then(|text| text.parse().ok()).unwrap_or(2);
    for sample in samples() {
        let blocks = sample.blocks();
        let step = blocks.len() / places + 1;
        for seq in (0..blocks.len()).step_by(step) {
            let made_here =
                restart(&sample.session(), Path::new(&sample.file), &sample.file, &at(seq as u64), OPTIONS, Lang::En);
            match made_here.answer {
                Answer::Program(program) => {
                    compare(&sample, &blocks, seq, &program);
                    comes_from_above(&sample, &program);
                    made += 1;
                    flat += u32::from(program.written_out > 0);
                }
                Answer::Refused { reason, nearest } => {
                    let text = format!("{reason:?}");
                    let kind = text.split([' ', '{']).next().unwrap().to_owned();
                    let differs = ["Differs", "Length", "Longer", "Shorter"].contains(&kind.as_str());
                    assert!(!differs, "{} seq {seq}: {reason:?}", sample.name);
                    assert!(nearest.is_none_or(|nearest| nearest.seq < seq as u64));
                    *refused.entry(kind).or_default() += 1;
                }
                other @ (Answer::Place(_) | Answer::Broken) => panic!("{} seq {seq}: {other:?}", sample.name),
            }
        }
    }
    assert!(
        made > 100 && flat > 10 && refused.len() > 8,
        "{made} made, {flat} of them written out, refused {refused:?}"
    );
}

/// `restart` of a program under a project file.
pub fn started(config: &str, text: &str, args: &[&str]) -> Run {
    let place = Place::with(&[("a.nc", text.as_bytes()), ("cnc872c.toml", config.as_bytes())]);
    place.run(&[&["restart", "a.nc", "--lang", "en"], args].concat())
}

const LOOP: &str = "%872 \"FLANGE\"\r\nN10 G90 G54 G0 X0 Y0 Z100\r\nN20 T5 D1 M06\r\nN30 S1200 M41 M03 M08\r\nN40 G0 X10 Y10 Z5\r\n\
    N50 G1 Z-1 F200 M25\r\nN60 G71 L100 Q3\r\nN70 G0 Z100 M10\r\nN80 G41 X5\r\nN90 G40 X0\r\nN100 M30\r\n\"p\u{f8}\u{ed}ruba\r\nN1000 G79 L100\r\n\
    N1010 G91 G1 Z-1\r\nN1020 G90 XR10 R10=20\r\nN1030 Y20 G70\r\n";

/// The bytes of [`LOOP`] in Windows-1250: its comment is no UTF-8.
fn bytes() -> Vec<u8> {
    LOOP.chars().map(|character| u8::try_from(u32::from(character)).unwrap()).collect()
}

/// RST-1, RST-2, RST-3, RST-6: the contents of the new program, in their order.
#[test]
fn the_program_that_starts_there() {
    let place = Place::with(&[("a.nc", &bytes())]);
    let run = place.run(&["restart", "a.nc", "--n", "1030", "--pass", "2", "--param", "R10=15", "-o", "b.nc"]).ends(0);
    assert_eq!(run.stderr, "blocks of calls and loops written out: 4\n");
    let written = place.read("b.nc");
    // The rest keeps its bytes.
    assert!(written.ends_with(&bytes()[bytes().len() - 120..]));
    let text: String = written.iter().map(|byte| char::from(*byte)).collect();
    let expected = [
        "%872 \"a.nc from N1030, pass 2\"",
        "\"blocks of calls and loops written out: 4\"",
        "\"not restored: M25 of group 14 (--all-m)\"",
        "N1040 G54 \"functions in force\"",
        "N1050 T5 D1 M06 \"tool change, N20\"",
        "N1060 M41 S1200 M03 \"spindle, N30\"",
        "N1070 M08 \"coolant 2 on, N30\"",
        "N1080 F200 \"feed, N50\"",
        "N1090 G00 G90 Z100 \"up to the program's highest with this tool\"",
        "N1100 G00 X20 Y20 \"across\"",
        "N1110 G00 Z-1 \"down to 2 mm above the place\"",
        "N1120 G01 Z-3 \"to the place at F\"",
        "N1440 Y20 \"N1030\"",
        "N1441 G91 G01 Z-1 \"N1010\"",
        "N1442 G90 X20 R10=20 \"N1020\"",
        "N1443 Y20 \"N1030\"",
        "N70 G0 Z100 M10",
    ];
    assert_eq!(text.lines().take(expected.len()).collect::<Vec<_>>(), expected, "{text}");
    place.run(&["check", "b.nc", "--param", "R10=15"]).ends(0);
    let written = |arguments: &[&str]| {
        let fixed = ["restart", "a.nc", "--param", "R10=15", "-o", "c.nc"];
        place.run(&[&fixed[..], arguments].concat()).ends(0);
        place.read("c.nc").into_iter().map(char::from).collect::<String>()
    };
    let all = written(&["--n", "100", "--all-m", "--safe", "150"]);
    assert!(all.contains("G00 G90 Z150 \"up to --safe\""), "{all}");
    assert!(all.contains("M25 \"N50\"") && all.contains("M10 \"clamp the workpiece, N70\""), "{all}");
    let czech = written(&["--lang", "cs", "--at-tool", "T5", "--safe", "100"]);
    let skipping = written(&["--n", "1030", "--pass", "2", "--block-skip"]);
    assert!(skipping.contains("\"there without the blocks with /, as --block-skip says\""), "{skipping}");
    assert!(czech.starts_with("%872 \"a.nc od N20\"") && czech.contains("platne funkce"), "{czech}");
    let list = place.run(&["restart", "a.nc", "--list", "--param", "R10=15", "--safe", "100"]).ends(0);
    assert!(list.stdout.contains("--seq 1  N20  line 3  pass 1  T5  tool change\n"), "{}", list.stdout);
    assert!(!list.stdout.contains("N90"), "{}", list.stdout);
}

/// RST-4: refusals say why and where a start is possible; places that are none, errors and endless loops write nothing.
#[test]
fn what_is_refused() {
    let endless = "%1\nN10 G0 X1\nN20 G73 L10 Q9999\nN30 G73 L10 Q9999\nN40 M30\n";
    let lathe = "%1\nN10 G90 G74 G0 X100 Z50\nN20 G1 X40 F100\nN30 Z-10\nN40 M30\n";
    let flat = "%1\nN10 G90 G1 X0 Z5 F100\nN20 X10\nN30 M30\n";
    let place = Place::with(&[
        ("a.nc", &bytes()),
        ("bad.nc", BAD.as_bytes()),
        ("endless.nc", endless.as_bytes()),
        ("lathe.nc", lathe.as_bytes()),
        ("flat.nc", flat.as_bytes()),
    ]);
    for (arguments, status, says) in [
        (&["a.nc", "--n", "90", "--param", "R10=15"][..], 1, "G41 is in force"),
        (
            &["a.nc", "--n", "90", "--param", "R10=15"],
            1,
            "nearest earlier place that works: --seq 19, N80 (line 9), 0:0",
        ),
        (&["a.nc", "--n", "50"], 1, "no F is in force"),
        (&["a.nc", "--n", "1030"], 2, "--pass 3  N1030"),
        (&["a.nc", "--n", "1031"], 2, "the nearest number is N1030"),
        (&["a.nc", "--seq", "99"], 2, "blocks that the program executes"),
        (&["a.nc", "--time", "9:00:00"], 2, "the program takes"),
        (&["a.nc", "--n", "100", "--after"], 2, "N100: nothing comes behind it"),
        (&["a.nc"], 2, "is missing"),
        (&["a.nc", "--n", "100", "--list"], 2, "--list"),
        (&["a.nc", "--n", "20", "-o", "a.nc"], 2, "another file belongs after -o"),
        (&["a.nc", "--n", "20", "--clearance", "0"], 2, "--clearance"),
        (&["a.nc", "--n", "20", "--safe", "60.0004"], 2, "--safe"),
        (&["bad.nc", "--n", "10"], 1, "E0306"),
        (&["bad.nc", "--list"], 1, "E0306"),
        (&["endless.nc", "--n", "40", "--max-blocks", "1000"], 1, "E0410"),
        (&["lathe.nc", "--n", "30"], 1, "`tool-axis` of `[restart]`"),
        (&["flat.nc", "--n", "20"], 2, "--safe is missing"),
        (&["none.nc", "--n", "20"], 2, "E0112"),
    ] {
        let before = place.list();
        let run = place.run(&[&["restart", "--lang", "en"], arguments].concat()).ends(status);
        assert!(run.stderr.contains(says) && run.stdout.is_empty(), "{arguments:?}: {}", run.stderr);
        let refused = place.run(&[&["restart"], arguments, &["-o", "new.nc"]].concat());
        assert!(place.list() == before && refused.stdout.is_empty(), "{arguments:?}");
    }
    assert_eq!(place.read("a.nc"), bytes());
}

/// RST-2, RST-4: what looks like a start and is none. A height of another origin or correction, of a block that cut, or
/// a `--safe` below the place is no clear height; an axis that left its reference point is not there; G74 once is a
/// lathe.
#[test]
fn starts_that_would_be_wrong() {
    let head = "%1\nN10 G54 T1 D1 M06\nN20 G90 G00 X0 Y0 Z50 S800 M03 F200\n";
    let start = |blocks: &str, arguments: &[&str]| {
        started("", &format!("{head}{blocks}N900 M30\n"), &[&["--n", "70"], arguments].concat())
    };
    let across = |blocks: &str, safe: &str| start(blocks, &[safe]).ends(0).stdout;
    for (blocks, top) in [
        ("N60 G55 G00 Z5\nN65 G01 Z-5 X1 Y0\nN70 X30\n", "Z5 "),
        ("N30 &0010 Z40\nN60 D2 Z8\nN65 G01 Z-5 X1 Y0\nN70 X30\n", "Z8 "),
        // Without length correction D is the radius: the heights stay.
        ("N60 D2 Z8\nN65 G01 Z-5 X1 Y0\nN70 X30\n", "Z50 "),
        ("N60 G01 Z0 D2\nN65 G01 Z-5 X1 Y0\nN70 X30\n", "Z50 "),
        // Back at an origin, or with a tool, the heights there are those from before.
        ("N30 G00 Z8\nN60 G55\nN61 Z60\nN62 G54\nN63 Z7\nN65 G01 Z-5 X1 Y0\nN70 X30\n", "Z50 "),
        // Corrections that are written for another D are none of those in force.
        ("N30 G92 D9 Z0\nN40 G00 X0 Y0 Z8\nN65 G01 Z-5 X1 Y0\nN70 X30\n", "Z50 "),
        ("N30 G58 X9\nN40 G00 X0 Y0 Z8\nN65 G01 Z-5 X1 Y0\nN70 X30\n", "Z50 "),
        ("N30 T1 M06\nN60 G00 Z8\nN65 G01 Z-5 X1 Y0\nN70 X30\n", "Z50 "),
        ("N30 T2 M06\nN40 G00 Z8\nN50 T1 M06\nN60 Z9\nN65 G01 Z-5 X1 Y0\nN70 X30\n", "Z50 "),
    ] {
        let run = start(blocks, &[]).ends(0);
        assert!(run.stdout.contains(&format!("G00 G90 {top}\"up to the program's highest")), "{blocks}{}", run.stdout);
    }
    // The program came to Z-5 and Z-10 by cutting only; what rises clears.
    let fell = "N30 G53 Z0\nN40 G55 X50 Y50\nN50 G01 Z-5\nN60 X80\nN65 Z-10\nN70 X50\n";
    start(fell, &[]).ends(2).says("--safe is missing");
    let rises = "N30 G53 Z0\nN40 G55 X50 Y50 Z-9\nN50 G01 Z5\nN60 Z-10\nN65 X9\nN70 X50\n";
    assert!(start(rises, &[]).ends(0).stdout.contains("G00 G90 Z5 \"up to"), "{rises}");
    // F in mm/min is none in mm/rev.
    let unit = "N30 G94 G01 Z5 F600\nN40 G95\nN60 G00 X20\nN70 G01 X25 F0.2\n";
    start(unit, &["--safe", "70"]).ends(1).says("F was written under G94");
    // By a distance from where the origin changed nobody knows where the axis comes to.
    let drift = "N30 G55\nN40 G91 X5 Y5 Z-20\nN70 G01 Z-5\n";
    start(drift, &["--safe", "70"]).ends(1).says("has not moved since the origin");
    let cut = "N30 G01 Z-5\nN40 X40\nN70 X60\n";
    let stands = "N30 G01 Z-5\nN40 X40\nN50 M05\nN70 G00 Z50\n";
    start(stands, &[]).ends(1).says("the spindle stands");
    start(cut, &["--safe=-10"]).ends(2).says("--safe is not above the place");
    start(cut, &["--safe=-5"]).ends(2).says("--safe is not above the place");
    assert!(across(cut, "--safe=-4").contains("G00 G90 Z-4 \"up to --safe\""));
    // The program came to its highest place in rapid, and cuts there before it or behind it.
    start("N30 G53 Z0\nN60 G55 X-80 Y0 Z-5\nN65 X-85\nN70 G01 X80\n", &[]).ends(2).says("--safe is missing");
    start("N30 G53 Z0\nN60 G55 X-80 Y0 Z-5\nN65 X-85\nN70 X-90\nN80 G01 X80\n", &[]).ends(2).says("--safe is missing");
    start("N30 G53 Z0\nN40 G55 X0 Y0 Z5\nN50 G01 X80\nN55 Z-5\nN60 G00 Z5\nN70 X9\n", &[])
        .ends(2)
        .says("--safe is missing");
    let level =
        "N30 G53 Z0\nN60 G55 X-80 Y0 Z5\nN65 X-85\nN70 X-90\nN80 G01 X80 Z-5\nN90 G00 Z5\nN95 T2 M06\nN96 G01 Z5 X8\n";
    assert!(start(level, &[]).ends(0).stdout.contains("G00 G90 Z5 \"up to the program's highest"));
    // Nothing shows that the tool can cross at the height to which it came.
    start("N30 G53 Z0\nN60 G55 X-80 Y0 Z5\nN70 G01 Z-5\n", &[]).ends(2).says("--safe is missing");
    let rose = "N30 G53 Z0\nN60 G55 X-80 Y0 Z-5\nN65 Z20\nN70 X9\n";
    assert!(start(rose, &[]).ends(0).stdout.contains("G00 G90 Z20 \"up to"), "{rose}");
    // Another tool worked higher at this origin, or this one at all its heights.
    let boss = "N30 G00 Z22\nN35 G01 Z20\nN40 X50\nN50 T2 M06\nN55 G00 X60 Y0 Z5\nN60 G01 Z-5\nN70 X70\n";
    start(boss, &[]).ends(2).says("--safe is missing");
    // So it is where an origin left the axis at a height that nobody knows, on a thread, and on the ridge of two feeds.
    for work in
        ["N35 G58 X5\nN40 G01 X60\nN45 G00 Z100", "N40 G33 X50 K2\nN45 G00 Z90", "N32 G01 Z0\nN35 X9 Z30\nN40 X20 Z0"]
    {
        let text = format!(
            "N30 G00 Z60\n{work}\nN48 G53 G00 Z0\nN50 T2 M06\nN55 G54 X60 Y0 Z5\nN57 X50\nN60 G01 Z-5\nN70 X70\n"
        );
        start(&text, &[]).ends(2).says("--safe is missing");
    }
    // A feed that rises alone clears, and M05 behind it stops no spindle in the cut.
    let bored = "N30 G55 T2 M06\nN35 G00 X0 Y0\nN40 S9 M03\nN50 Z2\nN55 G01 Z-5\nN60 Z20 M05\nN70 G00 X5\n";
    assert!(start(bored, &[]).ends(0).stdout.contains("G00 G90 Z20 \"up to"), "{bored}");
    let other = boss.replace("T2 M06", "G55 T2 M06");
    assert!(start(&other, &[]).ends(0).stdout.contains("G00 G90 Z5 \"up to"), "{other}");
    assert!(across("N70 X60\n", "--safe=10").contains("Z50 \"the height of the place, which is above --safe\""));
    start("N30 G00 X5\nN40 G01 X10\nN70 X60\n", &[]).ends(2).says("--safe is missing");
    let lost = "N30 G30 Z0\nN40 G91 G00 Z-120\nN50 G01 X40\nN70 Y20\n";
    start(lost, &[]).ends(1).says("the position of Z is not known");
    start("N30 G74 X90\nN40 G01 Z-5\nN50 G75 X40\nN70 Z-9\n", &["--safe", "120"]).ends(1).says("`tool-axis`");
    for conversion in ["G35 Z1", "G35 K1", "G36 K2"] {
        start(&format!("N30 {conversion}\nN40 X0 Y0 Z50\nN50 G01 Z-5\nN70 X9\n"), &[]).ends(1).says("is in force");
    }
}

/// RST-6: what is said at the top fits in lines of the control (LEX-7), and the place stands in the title.
#[test]
fn long_names_and_comments() {
    let name = "deska_upinaci_prava_DN250_operace_20_dokonceni_obvodu_leva_strana_rev3.nc";
    let text = "%3\nN10 G54 G90 T1 M06\nN20 S500 M03\nN30 G00 X0 Y0 Z50\nN40 G72 L9002\nN50 G01 X0 Y0 Z5 F100\nN60 X10\nN90 M30\n";
    let config = "dialect = \"cnc8x6\"\n[machine-macrocycles]\nL9002 = {}\n";
    let place = Place::with(&[(name, text.as_bytes()), ("cnc872c.toml", config.as_bytes())]);
    for (lang, said) in [("en", "from N60\"\n"), ("cs", "od N60\"\n")] {
        let made = place.run(&["restart", name, "--n", "60", "--safe", "90", "--lang", lang]).ends(0).stdout;
        assert!(made.lines().all(|line| line.len() <= 80), "{made}");
        assert!(made.starts_with("%3 \"deska_") && made.contains(said), "{made}");
    }
}

/// RST-1: parameters are written in as many blocks as a control takes (BLK-3).
#[test]
fn many_parameters() {
    let assigned: String = (0..96).map(|index| format!("N{} R{index}={index}\n", index + 100)).collect();
    let read: String = (0..96).map(|index| format!("N{} XR{index}\n", index + 300)).collect();
    let text = format!("%3\nN10 G54 G90 G00 X0 Y0 Z50\n{assigned}N290 Y5\n{read}N900 M30\n");
    assert!(started("", &text, &["--n", "290", "--safe", "50"]).ends(0).stdout.contains("R95=95"));
}

/// RST-4: an axis that the spindle turned has a length in the program, and none in one that changes the origin first:
/// such places are not listed.
#[test]
fn axes_that_the_spindle_turned() {
    let text = "%1\nN10 G90 G54\nN20 T1 M06\nN30 S600 M03\nN40 G00 X0 Y0 Z50\nN50 G01 Z-5 F300\nN60 G00 Z50\nN70 M19\n\
        N80 G01 C30\nN90 M03\nN100 G01 Z-3\nN110 G00 Z50\nN120 X20\nN130 M19\nN140 G01 C60\nN150 M03\nN160 G00 Z60\nN170 M30\n";
    for (origin, listed) in [("G54", false), ("G53", true)] {
        let place = Place::with(&[
            ("a.nc", text.replace("G54", origin).as_bytes()),
            ("cnc872c.toml", b"spindle-axis = \"C\"\n"),
        ]);
        let list = place.run(&["restart", "a.nc", "--list", "--safe", "100"]).ends(0).stdout;
        assert_eq!(list.contains("N120"), listed, "{list}");
        let numbers = list.lines().filter_map(|line| line.split_whitespace().nth(1));
        for seq in numbers {
            place.run(&["restart", "a.nc", "--seq", seq, "--safe", "100"]).ends(0);
        }
        let run =
            place.run(&["restart", "a.nc", "--n", "120", "--safe", "100", "--lang", "en"]).ends(i32::from(!listed));
        assert_eq!(run.stderr.contains("the length of the motion in N140"), !listed, "{}", run.stderr);
    }
}

/// RST-4, RST-6: an axis that stands where nobody knows is no axis to go on beside: what a macrocycle of the machine,
/// a distance or an M function left it at, whether the program names it later or not.
#[test]
fn axes_that_stand_where_nobody_knows() {
    let head = "%1\nN10 T2 M06\nN20 G90 G00 X0 Y0 Z50\nN30 S900 M03 F300\n";
    let start = |config: &str, blocks: &str, n: &str| {
        let text = format!("{head}{blocks}N900 M30\n");
        started(config, &text, &["--n", n, "--safe", "60"])
    };
    let table = "[machine-macrocycles]\nL9002 = { axes = [\"B\"] }\n";
    let cut = "N40 R1=90\nN50 G72 L9002\nN60 G01 Z-5\nN70 X40\nN80 G00 Z50\n";
    let refused = start(table, cut, "70").ends(1);
    refused.says("the position of B is not known").says("--seq 4, N50");
    // What the program assigned is written for the macrocycle that may read it, whatever the text after it reads.
    let before = start(table, cut, "50").ends(0).stdout;
    assert!(before.contains("R1=90 \"parameters read later\""), "{before}");
    let any = "[machine-macrocycles]\nL9002 = {}\n";
    let after = start(any, "N50 G72 L9002\nN55 G00 X0 Y0 Z50\nN60 G01 Z-5\nN70 X40\n", "70").ends(0).stdout;
    assert!(after.contains("\"a macrocycle of the machine may have moved A, B, C, U, V, W:"), "{after}");
    for (config, lost) in [
        ("[machine-macrocycles]\nL9002 = { axes = [\"Y\"] }\n", "N40 G72 L9002\n"),
        ("", "N40 G81 Y9 Z-5\nN45 G80\nN46 Z50\n"),
    ] {
        let refused = start(config, &format!("{lost}N50 G90 G01 Z-5\nN60 X20\nN70 X40\nN76 G00 Z50\n"), "70");
        refused.ends(1).says("the position of Y is not known");
    }
    // The preamble would go down beside it, or the rest would move on.
    let lost = "[machine-macrocycles]\nL9003 = { axes = [\"X\"] }\n";
    start(lost, "N40 G01 Z-5\nN50 G72 L9003\nN70 G00 X60 Y10\n", "70").ends(1).says("the position of X is not known");
    start(lost, "N40 G00 Z60\nN50 G72 L9003\nN70 G00 X60 Y10\n", "70").ends(0);
    for on in ["70", "80"] {
        let refused = start(lost, "N40 G00 Z60\nN50 G72 L9003\nN70 G00 Y10\nN80 Y0\nN90 X5\n", on);
        refused.ends(1).says("the position of X is not known, and N");
    }
    // The length of the tool is none of a rotary axis, its origin is.
    let turned = |blocks: &str| start("", &format!("N32 B88\n{blocks}N50 G00 X5 Y5 Z20\nN60 G01 Z-2\nN70 X30\n"), "70");
    turned("N35 &0100\nN40 G55\n").ends(1).says("B has not moved since the origin");
    turned("N35 G55\nN40 &0100\n").ends(1).says("B has not moved since the origin");
    assert!(turned("N35 &0100\n").ends(0).stdout.contains("B88 \"across\""));
}

/// RST-1: S of a spindle that turns never counts otherwise than in the program; RST-4: what a macrocycle of the machine
/// left is none to call another one from, a spindle that turned is no axis to wait for, conversions may add up.
#[test]
fn spindles_macrocycles_and_conversions() {
    let start = |config: &str, blocks: &str, n: &str| {
        let text = format!("%1\nN10 T1 D1 M06\n{blocks}N900 M30\n");
        started(config, &text, &["--n", n, "--safe", "100"])
    };
    let cutting = |first: &str, then: &str| {
        format!(
            "N20 {first} M03\nN30 G00 X60 Y0 Z50\nN40 G01 Z1\nN50 G00 Z60\nN60 {then}\nN70 G00 X20 Z2\nN80 G01 Z-3\n"
        )
    };
    for (first, then, blocks) in [
        ("G96 S250 F180", "G97 S800", ["S800 M03", "F180"]),
        ("G96 S250 F180", "G97", ["G96 S250", "G97 M03"]),
        ("G94 S800 F180", "G96 S150", ["S150 M03", "F180"]),
        ("G95 S800 F2", "G96 S150 F90", ["S150 M03", "F90"]),
    ] {
        let made = start("", &cutting(first, then), "80").ends(0).stdout;
        let at = |block: &str| made.find(&format!(" {block} \"")).unwrap_or_else(|| panic!("{block}: {made}"));
        assert!(at(blocks[0]) < at(blocks[1]), "{made}");
        assert!(first.contains("G95") || !made.contains("G96 F") && !made.contains("G94 F"), "{made}");
    }
    let any = "[machine-macrocycles]\nL9001 = {}\n";
    let moved = "N30 G00 X0 Y0 Z50\nN60 G72 L9001\nN70 G91\nN80 G72 L9001\nN90 G01 X5 F100\n";
    start(any, moved, "80").ends(1).says("the position of X is not known, and N80 goes on from it");
    let turned = "N30 S9 M03\nN40 G00 X0 Y0 Z50\nN50 M19\nN60 S500 M03\nN70 G00 Z3\nN80 G01 X7 F100\nN90 X20\n";
    let made = start("", turned, "90").ends(0).stdout;
    assert!(!made.contains("\"C "), "{made}");
    // C was moved behind the change of origin, and the new program does not move it.
    let turned = "N25 G54\nN30 M19\nN31 G00 C30\nN32 M03 S9\nN40 G00 X0 Y0 Z50\nN70 Z3\nN80 G01 X7 F100\nN90 X20\nN92 M05\nN94 M19\nN96 G00 C60\n";
    start("", turned, "90").ends(1).says("the length of the motion in N96 would not be known");
    let converted = |blocks: &str| start("", &format!("{blocks}N50 G00 X0 Y0 Z50\nN70 G01 Z5 F100\nN80 X7\n"), "80");
    converted("N30 G35 X1\nN40 G35 Y1\n").ends(1).says("whether they add up");
    converted("N30 G35 X1\nN40 G34\nN41 G35 Y1\n").ends(0);
    converted("N30 G35 X1\nN40 G35 X1\n").ends(0);
}

/// RST-2: axes stand where `[start]` has them before the program moves any; later they are moved there like others,
/// and where the origin has changed since, they are none to cut from.
#[test]
fn axes_from_the_project_file() {
    let start = |blocks: &str, n: &str| {
        let text = format!("%1\nN10 T3 M06\nN20 S900 M03 F300\n{blocks}N900 M30\n");
        started("[start]\nX = 1\nY = 2\nZ = 80\n", &text, &["--n", n, "--safe", "90"])
    };
    let cut = "N30 G90 G00 Z10\nN40 G01 Z-5\nN50 X20\nN60 Y30\nN70 G00 Z50\n";
    let across = start(cut, "50").ends(0).stdout;
    assert!(across.contains("G00 X1 Y2 \"across\""), "{across}");
    let begin = start(cut, "20").ends(0).stdout;
    assert!(!begin.contains("G00 ") || begin.contains("N30 G90 G00 Z10"), "{begin}");
    assert!(begin.contains("\"Z was not programmed yet"), "{begin}");
    let moved = format!("N25 G54 G00 Z10\n{cut}");
    start(&moved, "50").ends(1).says("the position of X is not known, and N50 goes on from it");
    start("N25 G54\nN30 G90 G00 X5 Y5\nN40 X9\nN50 Z3\nN60 G01 Z-5\n", "40")
        .ends(1)
        .says("the position of Z is not known");
}

/// RST-4: what nobody knows stays unknown, whatever `[start]` says of the beginning; an axis that a distance took from
/// its reference point is lost, in whatever blocks; the tool's axis is known before others move in rapid.
#[test]
fn axes_that_are_lost_stay_lost() {
    let start = |config: &str, blocks: &str, n: &str| {
        let text = format!("%1\nN10 G90 T1 D1 F9\n{blocks}N900 M30\n");
        started(config, &text, &["--n", n, "--safe", "100"])
    };
    let table = "[start]\nX = 0\nY = 0\nZ = 300\n[machine-macrocycles]\nL9001 = {}\n";
    let changes =
        "N20 G72 L9001\nN30 M06\nN40 S9 M03\nN50 G00 X0 Y0 Z50\nN60 T2\nN70 G72 L9001\nN80 M06\nN85 G00 X1 Y1 Z9\n";
    for n in ["30", "80", "85"] {
        start(table, changes, n).ends(0);
    }
    let turned = "spindle-axis = \"C\"\n[start]\nX = 0\nY = 0\nZ = 300\nC = 0\n";
    start(turned, "N20 S9 M03\nN30 G00 X1 Y1 Z5\nN40 M05\nN50 T2 M06\nN60 S8 M03\nN65 G00 X2 Y2 Z3\n", "50").ends(0);
    for falls in ["Z-20", "Z-20 F9", "G01 Z-20"] {
        let blocks =
            format!("N20 G01 X0 Y0 Z0 F9\nN30 G30 Z0\nN40 G01 G91 X1\nN50 X1\nN60 {falls}\nN70 X1\nN80 X5 Z-1\n");
        start("", &blocks, "70").ends(1).says("the position of Z is not known");
    }
    let blind = "N20 S9 M03\nN30 G00 X1 Y1\nN40 G00 X50 Y5\n";
    start("", &format!("{blind}N50 Z50 F9\nN60 G01 Z-1\n"), "50").ends(1).says("the position of Z is not known");
    // Nothing but the user moves it.
    assert!(start("", &format!("{blind}N50 G01 X9 F9\n"), "50").ends(0).stdout.contains("Z is not known here"));
}

/// RST-2, RST-4: where the tool works by another axis than the tool's, nothing says that it is clear.
#[test]
fn tools_that_another_axis_moves() {
    let start = |config: &str, blocks: &str, n: &str| {
        let text = format!("%1\nN10 G90 T1 M06\nN20 S900 M03 F80\n{blocks}N900 M30\n");
        started(config, &text, &["--n", n, "--safe", "100"])
    };
    let quill = "N30 G00 X100 Y100 W50\nN40 W2\nN50 G01 W-60\nN60 G00 W50\nN70 X200\nN80 W2\nN90 G01 W-60\nN95 X210\n";
    start("", quill, "95").ends(1).says("the position of Z is not known");
    start("[restart]\ntool-axis = \"W\"\n", quill, "95").ends(0);
    let mill = "N30 G00 X0 Y0 Z50\nN40 Z2\nN50 G01 Z-10\nN60 X50\n";
    for axis in ["W", "B"] {
        let config = format!("[restart]\ntool-axis = \"{axis}\"\n");
        start(&config, mill, "60").ends(1).says(&format!("the position of {axis} is not known"));
    }
    let both = "N30 G00 X0 Y0 Z50 W0\nN40 Z5\nN50 G01 W-60\nN60 X10\nN70 G00 W0\nN80 X30\n";
    start("", both, "60").ends(1).says("W is parallel to Z and does not stand at its highest").says("--seq 4, N50");
    assert!(start("", both, "80").ends(0).stdout.contains("X10 Y0 W0 \"across\""));
}

/// RST-4: `--safe` is asked for only where it opens a place.
#[test]
fn what_no_safe_opens() {
    let text = "%1\nN10 T1 M06\nN20 S1000 M03 F200\nN30 G00 X0 Y0 Z50\nN35 G91 B10\nN40 G90 Z2\nN50 G01 Z-1\nN60 X10\nN110 M30\n";
    for safe in [&[][..], &["--safe=60"], &["--safe=10"]] {
        let refused = started("", text, &[&["--n=35"], safe].concat()).ends(1);
        refused.says("the position of B is not known, and N35 goes on from it");
    }
    assert!(!started("", text, &["--list"]).stdout.contains("--safe would open"));
}

/// RST-1: an axis that the program did not move yet has to stand where the program found it; the set of G23 is
/// restored where G23 is in force from power-up on.
#[test]
fn what_holds_from_power_up_on() {
    let text = "%1\nN10 G54 T1 D1 M06\nN20 G90 G00 X0 Z50 S800 M03 F200\nN30 G23 I2\nN40 G01 Z-2\nN50 X5\nN60 Y9\n\
        N900 M30\n";
    let run = started("[power-up]\nG2 = 23\n", text, &["--n", "50"]).ends(0);
    assert!(
        run.stdout.contains("\"Y was not programmed yet: move it to where the program found it\""),
        "{}",
        run.stdout
    );
    assert!(run.stdout.contains(" G23 I2 \"as at the place\""), "{}", run.stdout);
}

/// RST-6: M functions of the last group do not exclude each other: each is named, and written with `--all-m`.
#[test]
fn functions_beside_each_other() {
    let text = "%1\nN10 G54 T1 M06\nN20 G90 G00 Z50 S8 M03 F2 M70\nN25 M71\nN30 M72 M11\nN35 M70\nN40 G01 Z-2\nN50 X5\nN90 M30\n";
    let started = |more: &[&str]| started("", text, &[&["--n", "50"], more].concat()).ends(0).stdout;
    assert!(started(&[]).contains("\"not restored: M71, M72, M70 of group 14 (--all-m)\""), "{}", started(&[]));
    let all = started(&["--all-m"]);
    let written: Vec<&str> = all
        .lines()
        .filter_map(|line| line.split(' ').find(|word| matches!(word.get(..2), Some("M7" | "M1"))))
        .collect();
    assert_eq!(written, ["M71", "M11", "M72", "M70"], "{all}");
    assert!(!all.contains("not restored"), "{all}");
}

/// RST-4: after an M whose number is not known no function of its groups is.
#[test]
fn functions_that_nobody_knows() {
    let text = "%1\nN10 G90 G54 G00 X0 Y0 Z50 T1 M06 S100 M03 F100\nN20 MR40\nN30 G01 X5\nN40 G00 X9\nN70 M30\n";
    started("", text, &["--n=40"]).ends(1).says("the value of M is not known");
    assert!(!started("", text, &["--list"]).stdout.contains("N40"));
    started("", text, &["--n=40", "--param=R40=8", "--safe=60"]).ends(0);
}

/// A place in a macrocycle is named with its file, and the size counts the blocks that are written.
#[test]
fn a_place_in_a_macrocycle() {
    let program =
        "%1\nN10 G90 G0 X0 Y0 Z50\nN20 T1 M6 S500 M3\nN30 G1 Z0 F100\nN40 G72 L9001 Q2\nN50 G0 Z50\nN60 M30\n";
    let macrocycle = "N10 G79 L9001\nN20 G91 X1\nN30 G90 G70\n";
    let place = Place::with(&[("m.nc", program.as_bytes()), ("L9001", macrocycle.as_bytes())]);
    let run = place.run(&["restart", "m.nc", "--file", "L9001", "--n", "20", "--pass", "2", "--lang", "en"]).ends(0);
    assert!(
        run.stdout.starts_with("%1 \"m.nc from L9001 N20, pass 2\"\n\"blocks of calls and loops written out: 2\"\n")
    );
    assert!(run.stdout.contains("\nN470 G91 X1 \"L9001 N20\"\nN471 G90 \"L9001 N30\"\nN50 G0 Z50\n"), "{}", run.stdout);
    let run = place.run(&["restart", "m.nc", "--file", "L9001", "--n", "30", "--pass", "2", "--lang", "en"]).ends(0);
    assert!(run.stdout.contains("\"blocks of calls and loops written out: 1\""), "{}", run.stdout);
}
