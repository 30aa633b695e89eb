//! Random programs, without `[motion]` and with it: JSON, CSV and the value change dump say the same, also when steps
//! start, and change bits are those of the block stream.

use std::collections::BTreeMap;

use cnc872c::analysis::plc::{Condition, Json, signals};
use cnc872c::config::Machine;
use cnc872c::dict::Dialect;
use cnc872c::session::Part;
use proptest::prelude::*;
use serde_json::Value;
use wellen::simple::Waveform;
use wellen::{SignalRef, SignalValueRef};

use crate::plc::{Case, case};
use crate::properties::cases;

/// A block of a program: any words that go together.
fn block() -> impl Strategy<Value = String> {
    let optional = |words: &'static [&'static str]| {
        prop_oneof![2 => Just(""), 3 => prop::sample::select(words)].prop_map(str::to_owned)
    };
    let number = || prop_oneof![Just(0), Just(5), -2000_i32..2000].prop_map(|n| format!("{}.{}", n / 10, n.abs() % 10));
    let motion = prop_oneof![
        2 => Just(String::new()),
        2 => (number(), number()).prop_map(|(x, y)| format!(" G0 X{x} Y{y}")),
        3 => (number(), number()).prop_map(|(x, z)| format!(" G1 X{x} Z{z}")),
        1 => Just(" G2 I5 J0".to_owned()),
        1 => number().prop_map(|x| format!(" G91 G1 X{x} C3 G90")).prop_map(|text| text.replace(" G90", "")),
    ];
    (
        motion,
        optional(&[" G23", " G98", " G4 Q50", " G4 Q0", " G35", " G34"]),
        optional(&[" G94", " G95", " G96"]),
        optional(&[" M3", " M4", " M5", " M19"]),
        optional(&[" M7", " M8", " M9", " M17"]),
        optional(&[" M41", " M42", " M40"]),
        optional(&[" M0", " M1"]),
        optional(&[" M91", " M92", " M95", " M100", " M6 T12345678", " T7", " M10", " M60"]),
        optional(&[" H5", " H2.5", " H-120", " S100", " S300", " F1"]),
    )
        .prop_map(|words| {
            let (a, b, c, d, e, f, g, h, i) = words;
            [a, b, c, d, e, f, g, h, i].concat()
        })
}

fn program() -> impl Strategy<Value = Case> {
    let motion = prop::sample::select(&[
        "",
        "[motion]\nraise-ms = 20\n",
        "[motion]\nprofile = \"linear\"\n",
        "[motion]\nmerge-length-mm = 60\n",
        "[motion]\nprofile = \"parabolic\"\ncycle-ms = 2\n[motion.sets.1]\nparabolic = 50000\nlinear-mm-s2 = 600\n",
    ]);
    let blocks = prop::collection::vec(block(), 1..12);
    (blocks, any::<bool>(), 0..4_u32, motion).prop_map(|(blocks, stop, repeats, motion)| {
        let mut text = "%1\nN1 G0 G90 X0 Y0 Z0 C0\n".to_owned();
        for (index, block) in blocks.iter().enumerate() {
            text += &format!("N{}{block}\n", index + 2);
        }
        if repeats > 0 {
            text += &format!("N90 G73 L2 Q{repeats}\n");
        }
        text += "N99 M30\n";
        let channel = "<C><MFunc No=\"92\" GroupNo=\"12\"/></C>"
            .replace("<C>", "<C><MFunctions>")
            .replace("</C>", "</MFunctions></C>");
        let config = "channel-config = \"C.xml\"\n[[gears]]\nm = 41\nmin = 0\nmax = 200\n[[gears]]\nm = 42\nmin = 0\nmax = 9000\n";
        let case = case(&text).config(&format!("{config}{motion}")).with("C.xml", &channel);
        if stop { case.args("--optional-stop") } else { case }
    })
}

/// Values of a step as text that all forms share: absent is empty.
type Step = BTreeMap<String, String>;

fn of_json(case: &Case) -> Option<Vec<Step>> {
    let mut out = Vec::new();
    let outcome = case.written("*", &mut Json::new(&mut out));
    if outcome.findings.has_errors() {
        return None;
    }
    let mut now = Step::new();
    let mut steps = Vec::new();
    for line in std::str::from_utf8(&out).unwrap().lines() {
        let record: Value = serde_json::from_str(line).unwrap();
        if record["kind"] == "step" {
            for (name, value) in record["signals"].as_object().unwrap() {
                now.insert(name.clone(), if value.is_null() { String::new() } else { value.to_string() });
            }
            now.insert("seq".to_owned(), record["seq"].to_string());
            now.insert("n".to_owned(), record["n"].to_string());
            now.insert("stop".to_owned(), record["stop"].as_bool().map_or(0, u8::from).to_string());
            now.insert("start_s".to_owned(), seconds(&record["start_s"].to_string()));
            steps.push(now.clone());
        }
    }
    Some(steps)
}

/// A time as text that JSON and CSV share; absent is empty.
fn seconds(text: &str) -> String {
    text.parse::<f64>().map_or_else(|_| String::new(), |seconds| seconds.to_string())
}

fn of_csv(case: &Case) -> Vec<Step> {
    let text = case.csv("*");
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let cell = |name: &str, cell: &str| match cell.strip_suffix('h') {
        Some(digits) => u32::from_str_radix(digits, 16).unwrap().to_string(),
        None if name == "stop" && cell.is_empty() => "0".to_owned(),
        None if name == "start_s" => seconds(cell),
        None => cell.to_owned(),
    };
    let left_out = ["file", "line"];
    lines
        .map(|line| {
            let cells = head.iter().zip(line.split(',')).filter(|(name, _)| !left_out.contains(name));
            cells.map(|(name, text)| ((*name).to_owned(), cell(name, text))).collect()
        })
        .collect()
}

/// The dump as an independent reader sees it; and when its steps start, in µs, and when the last one ends.
fn of_vcd(case: &Case) -> (Vec<Step>, Vec<u64>) {
    let mut waves: Waveform = wellen::simple::read_from_reader(std::io::Cursor::new(case.vcd("*"))).expect("a dump");
    let names: BTreeMap<String, String> = signals()
        .iter()
        .map(|signal| {
            let scope = if signal.name.starts_with("BLK.") { "" } else { "PLC." };
            (format!("{scope}{}", signal.name.replace('[', "_").replace(']', "")), signal.name.clone())
        })
        .chain(["seq", "n", "stop"].map(|name| (format!("PLC.{name}"), name.to_owned())))
        .collect();
    let hierarchy = waves.hierarchy();
    let variables: Vec<(SignalRef, String)> = hierarchy
        .all_vars()
        .map(|variable| {
            let variable = &hierarchy[variable];
            let full = variable.full_name(hierarchy);
            (variable.signal_ref(), names.get(&full).unwrap_or_else(|| panic!("{full}")).clone())
        })
        .collect();
    assert_eq!(variables.len(), names.len());
    let references: Vec<SignalRef> = variables.iter().map(|(signal, _)| *signal).collect();
    waves.load_signals(&references);
    let times = waves.time_table().to_vec();
    // The last time closes the last step.
    let steps = (0..times.len() - 1)
        .map(|time| {
            let value = |signal: SignalRef| {
                let signal = waves.get_signal(signal).expect("loaded");
                let offset = signal.get_offset(u32::try_from(time).unwrap()).expect("a value from the beginning");
                match signal.get_value_at(&offset, 0) {
                    SignalValueRef::Real(number) if number.is_nan() => String::new(),
                    SignalValueRef::Real(number) => number.to_string(),
                    other @ (SignalValueRef::Event | SignalValueRef::BitVec(_) | SignalValueRef::String(_)) => {
                        let bits = other.to_bit_string().expect("bits");
                        if bits.contains('x') {
                            String::new()
                        } else {
                            u64::from_str_radix(&bits, 2).unwrap().to_string()
                        }
                    }
                }
            };
            variables.iter().map(|(signal, name)| (name.clone(), value(*signal))).collect()
        })
        .collect();
    (steps, times)
}

/// Change marks of the block stream, and whether the program stands after the block.
fn marks(case: &Case) -> Vec<(Vec<u64>, bool)> {
    case.in_session(|session| {
        let mut out = Vec::new();
        session.compile("P.NC".as_ref(), "P.NC", Part::default(), &mut out).unwrap();
        let records =
            std::str::from_utf8(&out).unwrap().lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
        records
            .filter(|record| record["kind"] == "block")
            .map(|record| {
                let changed = record["m_changed"].as_array().cloned().unwrap_or_default();
                (changed.iter().map(|group| group.as_u64().unwrap()).collect(), record["m_at_stop"].is_object())
            })
            .collect()
    })
}

/// Pieces of conditions, whole ones and scraps.
fn condition() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "M03PI",
        "PB06",
        "BLK.M[11]",
        "BLK.H",
        "STOPPI",
        "nic",
        "&",
        "|",
        "&&",
        "=",
        "==",
        "!=",
        "<",
        ">=",
        "!",
        "(",
        ")",
        "rising(",
        "falling(",
        "19h",
        "95",
        "-12.5",
        "0FFh",
        "FFh",
        "1e9",
        ".",
        "99999999999999999999999",
        "'",
        "é",
        "\u{1F600}",
        "\t",
        "\0",
    ]);
    prop::collection::vec((piece, prop::sample::select(vec!["", " "])), 0..14)
        .prop_map(|pieces| pieces.into_iter().map(|(piece, blank)| format!("{piece}{blank}")).collect())
}

proptest! {
    #![proptest_config(cases(2000))]

    /// Whatever stands after `--find` is a condition or has findings, each at a place of it.
    #[test]
    fn any_condition_is_read(text in condition()) {
        for dialect in Dialect::ALL {
            match Condition::read(&text, &Machine::new(dialect)) {
                Ok(condition) => prop_assert!(!condition.signals().is_empty()),
                Err(found) => {
                    prop_assert!(!found.is_empty());
                    for diagnostic in found {
                        prop_assert!(text.get(diagnostic.at.span.range()).is_some(), "{:?}", diagnostic.at);
                    }
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(120))]

    /// PLC-2, PLC-16: all forms say the same; marks are `m_changed`, at a stop and after it those of groups 2, 5 and 6
    /// too.
    #[test]
    fn all_forms_say_the_same(program in program()) {
        let Some(json) = of_json(&program) else { return Ok(()) };
        let csv = of_csv(&program);
        prop_assert_eq!(&json, &csv);
        let (vcd, times) = of_vcd(&program);
        prop_assert_eq!(csv.len(), vcd.len());
        let mut after = 0;
        for ((mut csv, vcd), time) in csv.into_iter().zip(&vcd).zip(&times) {
            // A step that takes no time is 1 µs after the one before it.
            let start = csv.remove("start_s").expect("a column").parse::<f64>().map_or(after, |seconds| {
                after.max((seconds * 1e6).round() as u64)
            });
            prop_assert_eq!(start, *time);
            after = start + 1;
            prop_assert_eq!(&csv, vcd);
        }
        prop_assert!(times.last() >= Some(&after));

        let marks = marks(&program);
        let mut steps = json.iter();
        let mut stood = false;
        for (mut wanted, stops) in marks {
            let marked = |step: &Step| -> Vec<u64> {
                (1..=14).filter(|group| step[&format!("ZMM{group}PI")] == "1").collect()
            };
            if stood {
                wanted.extend([2, 5, 6]);
                wanted.sort_unstable();
                wanted.dedup();
            }
            let step = steps.next().unwrap();
            prop_assert_eq!(marked(step), wanted);
            prop_assert_eq!(&step["stop"], "0");
            stood = stops;
            if stops {
                let step = steps.next().unwrap();
                prop_assert_eq!(marked(step), [2, 5, 6]);
                prop_assert_eq!(&step["stop"], "1");
            }
        }
        prop_assert!(steps.next().is_none());
    }
}
