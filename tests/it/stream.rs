//! The block stream against the rules: small programs, and the records that the specification gives for them.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

use cnc872c::config::{configure, find_project};
use cnc872c::diag::{Findings, Severity};
use cnc872c::session::{Part, Session};
use cnc872c::text::{MemoryLoader, Sources};
use serde_json::{Value, json};

use crate::markers::options;

static SCHEMA: LazyLock<jsonschema::Validator> =
    LazyLock::new(|| jsonschema::validator_for(&cnc872c::ir::schema()).expect("a schema"));

/// A program with the files beside it, ready to be compiled.
#[derive(Clone, Debug, Default)]
struct Case {
    program: Vec<u8>,
    files: BTreeMap<String, String>,
    args: String,
    part: Part,
}

/// What a run gave.
#[derive(Debug)]
struct Stream {
    text: String,
    records: Vec<Value>,
    codes: Vec<String>,
    errors: Vec<String>,
}

fn case(program: &str) -> Case {
    Case { program: program.as_bytes().to_vec(), ..Case::default() }
}

impl Case {
    fn with(mut self, name: &str, text: &str) -> Self {
        self.files.insert(name.to_owned(), text.to_owned());
        self
    }

    fn config(self, text: &str) -> Self {
        self.with("cnc872c.toml", text)
    }

    fn args(mut self, args: &str) -> Self {
        args.clone_into(&mut self.args);
        self
    }

    fn run(&self) -> Stream {
        let mut loader = MemoryLoader::new().with("P.NC", self.program.clone());
        for (name, text) in &self.files {
            loader = loader.with(name, text.as_bytes());
        }
        let mut overrides = cnc872c::config::Overrides::default();
        options(&mut overrides, &self.args);
        let project = find_project(Path::new(""), &loader);
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let settings = configure(project.as_deref(), &overrides, &loader, &mut sources, &mut findings);
        assert!(findings.items().is_empty(), "the configuration: {:?}", findings.items());
        let session = Session { loader: &loader, settings: &settings, progress: None };
        let mut out = Vec::new();
        let outcome = session.compile(Path::new("P.NC"), "P.NC", self.part, &mut out).expect("memory");
        let text = String::from_utf8(out).expect("UTF-8");
        let records: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).expect(line)).collect();
        for record in &records {
            assert!(SCHEMA.is_valid(record), "not in the schema: {record}");
        }
        let (mut codes, mut errors) = (Vec::new(), Vec::new());
        for found in outcome.findings.items() {
            let code = found.code().to_string();
            if settings.severity_for(found.code(), outcome.purpose) == Some(Severity::Error) {
                errors.push(code.clone());
            }
            codes.push(code);
        }
        codes.sort();
        Stream { text, records, codes, errors }
    }

    /// The records of a program without errors.
    fn whole(&self) -> Stream {
        let stream = self.run();
        assert!(stream.errors.is_empty(), "{:?}", stream.errors);
        assert_eq!(stream.records.last().expect("records")["kind"], "end");
        stream
    }

    /// The block records of a program without errors.
    fn blocks(&self) -> Vec<Value> {
        self.whole().blocks()
    }
}

impl Stream {
    fn of(&self, kind: &str) -> Vec<Value> {
        self.records.iter().filter(|record| record["kind"] == kind).cloned().collect()
    }

    fn blocks(&self) -> Vec<Value> {
        self.of("block")
    }

    fn end(&self) -> Value {
        self.records.last().expect("records").clone()
    }
}

fn blocks(program: &str) -> Vec<Value> {
    case(program).blocks()
}

/// Asserts the named fields of a record; `null` means that the field is left out.
#[track_caller]
fn assert_fields(record: &Value, expected: &Value) {
    for (name, value) in expected.as_object().expect("an object") {
        let found = record.get(name);
        if value.is_null() {
            assert_eq!(found, None, "`{name}` of {record}");
        } else {
            assert_eq!(found, Some(value), "`{name}` of {record}");
        }
    }
}

/// The one block with this number, and fields that it has.
#[track_caller]
fn assert_block(blocks: &[Value], n: u32, expected: &Value) {
    let found: Vec<&Value> = blocks.iter().filter(|block| block["n"] == n).collect();
    assert_eq!(found.len(), 1, "blocks N{n}");
    assert_fields(found[0], expected);
}

/// One field of every block, `null` where it is left out.
fn column(blocks: &[Value], name: &str) -> Value {
    blocks.iter().map(|block| block.get(name).cloned().unwrap_or(Value::Null)).collect()
}

/// One entry of an array in every block.
fn entries(blocks: &[Value], name: &str, index: usize) -> Value {
    blocks.iter().map(|block| block[name][index].clone()).collect()
}

/// Lengths of the motions.
fn lengths(blocks: &[Value]) -> Value {
    blocks.iter().map(|block| block["motion"]["length_mm"].clone()).collect()
}

const NULL: Value = Value::Null;

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
            json!({"kind": "program", "schema": "cnc872c.blocks/1", "generator": concat!("cnc872c ", env!("CARGO_PKG_VERSION")),
                "dialect": "cnc872", "number": 12, "title": "Title", "file": "P.NC", "axes": axes}),
            json!({"kind": "block", "seq": 0, "n": 10, "file": 0, "line": 3, "column": 1,
                "first_block": true, "last_block": true,
                "g": [0, 17, 98, 40, null, 53, 94, 70, 80, 90, 75, 34],
                "m": [null, 30, 5, 40, null, 9, 53, null, 48, null, null, null, null, null, null],
                "m_set": [30], "m_changed": [1]}),
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

/// Values and change marks of the M groups (MFN-6, MFN-7).
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

/// `M03 M30` marks group 2 and shows 05; M05 M02 marks it too, an unchanged group 2 is not marked (§13 Records).
#[test]
fn m_marks_of_the_end() {
    let end = |words: &str| blocks(&format!("%1\nN10 {words}"))[0].clone();
    assert_fields(&end("M03 M30"), &json!({"m_changed": [1, 2]}));
    assert_eq!(end("M03 M30")["m"][2], 5);
    assert_fields(&end("M05 M02"), &json!({"m_changed": [1, 2], "m_set": [5, 2]}));
    assert_fields(&end("M02"), &json!({"m_changed": [1]}));
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
    assert_eq!(column(&off, "m_changed"), json!([[2, 5, 6], [1], [1], [1, 2, 6], null, [1, 5], [1, 2, 6]]));
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
    assert_eq!(old[3]["m_changed"], json!([1, 4, 5]));
    let new = blocks(program);
    assert_eq!(entries(&new, "m", 4), json!([null, null, null, null]));
    assert_eq!(entries(&new, "m", 14), json!([37, 36, 37, 37]));
    assert_eq!(new[3]["m_changed"], json!([1, 5]));
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
    assert_eq!(column(&found, "m_changed"), json!([[10, 13], [10, 14], [1]]));
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
        &json!({"break_cont": true, "break_cont_end": true, "change_pos": true, "position": null, "m_changed": [4, 9],
            "motion": {"type": "rapid", "axes": ["X", "Y"], "length_mm": 5}}),
    );
    assert_fields(
        &found[2],
        &json!({"break_cont": null, "break_cont_end": null, "change_pos": null, "position": {"X": 20},
            "motion": {"type": "rapid", "axes": ["X"]}}),
    );
    assert_eq!(entries(&found, "m", 4), json!([null, 37, 37, 36, 36]));
    assert_eq!(entries(&found, "m", 12), json!([null, null, null, 100, 100]));
}

const GEARS: &str = "[[gears]]\nm = 41\nmin = 20\nmax = 500\n[[gears]]\nm = 42\nmin = 400\nmax = 2000\n";

/// The gear follows S with M40, and is the one written with M41–M44 (MFN-9, §13 More).
#[test]
fn gears() {
    let program = "%1\nN10\nN20 S450\nN30 S600\nN40 S3000\nN50 M42 S500\nN60 M40 S500\nN70 S0\nN80 M42 S1000\nN90 M30";
    assert_eq!(column(&case(program).config(GEARS).blocks(), "gear"), json!([null, 1, 2, null, 2, 1, null, 2, 2]));
    assert_eq!(
        column(&blocks("%1\nN10 S100\nN20 M43\nN30\nN40 M44 S9999\nN50 M30"), "gear"),
        json!([null, 3, 3, 4, null])
    );
    assert_eq!(case("%1\nN10 M41 S501\nN20 M30").config(GEARS).run().errors, ["E0607"]);
}

/// Feed and what it means (TEC-1, TEC-5).
#[test]
fn feeds() {
    let found =
        blocks("%1\nN10\nN20 F120.5\nN30\nN40 G95\nN50 F0.2\nN60 G96\nN70 G97 F99.999\nN80 G94 F24000\nN90 M30");
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

const OPERATIONS: &str = "[operations]\n\"01\" = \"add\"\n\"02\" = \"sub\"\n\"03\" = \"mul\"\n\"04\" = \"div\"\n\
    \"05\" = \"neg\"\n\"06\" = \"abs\"\n\"07\" = \"sqrt\"\n\"08\" = \"sin\"\n\"09\" = \"cos\"\n\"10\" = \"tan\"\n\
    \"11\" = \"asin\"\n\"12\" = \"acos\"\n\"13\" = \"atan\"\n\"14\" = \"atan2\"\n\"15\" = \"mod\"\n\"16\" = \"min\"\n\
    \"17\" = \"max\"\n\"18\" = \"round\"\n\"19\" = \"trunc\"\n\"20\" = \"copy\"\n";

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

/// Blocks after `N1 F100 S100` and a start at zero, with the records of the blocks behind those two.
fn from_zero(config: &str, lines: &str) -> Vec<Value> {
    let program = format!("%1\nN1 F100 S100\nN2 G00 X0 Y0 Z0\n{lines}\nN9999 M30");
    let mut found = case(&program).config(config).blocks();
    found.drain(..2);
    found.pop();
    found
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
        json!({"type": "arc_cw", "axes": ["X"], "length_mm": 31.415_927, "plane": "XY", "center": {"X": 10, "Y": 0},
            "radius_mm": 10, "sweep_deg": 180})
    );
    assert_eq!(
        arc("G19 G03 Z-20 J-10"),
        json!({"type": "arc_ccw", "axes": ["Z"], "length_mm": 31.415_927, "plane": "ZX", "center": {"X": 0, "Z": -10},
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
        ("N10 G54\nN20 G53 G30 Z0\nN30 X3", json!([null, null, 3])),
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
        ("N10 G54\nN20 A1\nN30 X3", json!([null, null, 3])),
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
            {"g": 31, "values": {"X": 1}},
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
    assert_eq!(column(&found, "dynamic_set"), json!([null, 2, 2, 2, 4, 4, 4, 1, 1]));
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
        json!([{"K": 1.5}, {"I": 2, "J": 3, "K": 4}, {"K": 5}, {"I": 1, "J": 0, "K": 2}, {"K": 7}, {"I": 8}, null])
    );
    assert_eq!(found[0]["motion"], json!({"type": "thread", "axes": ["Z"], "length_mm": 10}));
    assert_eq!(found[3]["motion"]["center"], json!({"X": 1, "Y": 0}));
    assert_eq!(entries(&found, "g", 8), json!([80, 80, 80, 80, 81, 81, 80]));
}

const CYCLES: &str = "[cycles]\nG81 = 8100\nG82 = 8200\n";

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

/// M19: the spindle is an axis until M03, M04 or M05 (MFN-10, §13 M functions).
#[test]
fn oriented_spindle() {
    let found = blocks(
        "%1\nN10 C0 A0\nN20 M19 C90\nN30 A10\nN40 X0 C100\nN50 M05 C110\nN60 C120\nN70 M19\nN80 G01 C0 F10\nN90 M30",
    );
    let motions = column(&found, "motion");
    assert_eq!(motions[1], json!({"type": "rapid", "axes": ["C"], "length_deg": 90, "spindle_axis": "C"}));
    assert_eq!(motions[2], json!({"type": "rapid", "axes": ["A"], "length_deg": 10}));
    assert_eq!(motions[3], json!({"type": "rapid", "axes": ["X", "C"], "spindle_axis": "C"}));
    assert_eq!(motions[4], json!({"type": "rapid", "axes": ["C"], "length_deg": 10}));
    assert_eq!(motions[7], json!({"type": "linear", "axes": ["C"], "length_deg": 120, "spindle_axis": "C"}));
    assert_eq!(found[4]["position"]["C"], 110);
    assert_eq!(entries(&found, "m", 2), json!([5, 19, 19, 19, 5, 5, 19, 19, 5]));
    let linear = "[[axes]]\nletter = \"X\"\nkind = \"linear\"\n[[axes]]\nletter = \"B\"\nkind = \"linear\"\n\
        [[axes]]\nletter = \"A\"\nkind = \"linear\"\n";
    let found = case("%1\nN10 A0 B0\nN20 A5 B5\nN30 M19 A9\nN40 M30").config(linear).blocks();
    assert_eq!(found[1]["motion"]["length_mm"], json!(7.071_068));
    assert_eq!(found[2]["motion"], json!({"type": "rapid", "axes": ["A"], "length_deg": 4, "spindle_axis": "A"}));
}

/// Comments of a block: trimmed, in order, up to the next N; empty ones are left out (BLK-9, LEX-6).
#[test]
fn comments() {
    let found = blocks(
        "%1 \"title\"\n\"before\"\nN10 \"  one\t\" X1 \"\" \"two\" \" \"\n\"three\nN20\n\"řez \\ 'x'\"\nN30 M30 \"end\"\n* \"after\"",
    );
    assert_eq!(column(&found, "comments"), json!([["one", "two", "three"], ["řez \\ 'x'"], ["end"]]));
}

/// Line and column of the `N`, in characters, in any encoding (block-stream.md, LEX-13).
#[test]
fn places() {
    let text = "\u{feff}x\n%1 \"čř\"\r\n  N10 X1 \"žluť\" N20 Y1\r\n\tN30\rN40 \"ž\"X1 n050 N60\n\nN70 M30";
    let shown = |found: Vec<Value>| (column(&found, "line"), column(&found, "column"));
    let expected = (json!([3, 3, 4, 5, 5, 5, 7]), json!([3, 17, 2, 1, 11, 16, 1]));
    assert_eq!(shown(blocks(text)), expected);
    let mut bytes = Vec::new();
    for letter in text.chars().skip(1) {
        bytes.push(if letter.is_ascii() { letter as u8 } else { 0x9f });
    }
    assert_eq!(shown(Case { program: bytes, ..Case::default() }.blocks()), expected);
}

/// Columns of blocks that follow, or go back, within one line that is not ASCII.
#[test]
fn columns_within_a_line() {
    let found = blocks("%1\nN1 \"ž\" N10 M99\"ř\nN20 \"řeřicha\" N30 \"ů\" N40 G73 L30 N50 G73 L20 \"ě\" N60 M30");
    assert_eq!(column(&found, "n"), json!([1, 10, 20, 30, 40, 30, 40, 50, 20, 30, 40, 30, 40, 50, 60]));
    assert_eq!(column(&found, "column"), json!([1, 8, 1, 15, 23, 15, 23, 35, 1, 15, 23, 15, 23, 35, 51]));
    assert_eq!(column(&found, "line"), json!([2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3]));
}

/// Sizes that a quadratic step anywhere would make unbearable: blocks of one line, calls, jumps, unknown targets, rings.
#[test]
fn large_programs() {
    let of = |count: u32, line: &dyn Fn(u32) -> String| (1..=count).map(line).collect::<String>();
    let one_line = format!("%1 N1 {} N999999 M30", of(20_000, &|n| format!("N{n}0 X1 ")));
    assert_eq!(case(&one_line).whole().end()["blocks"], 20_002);
    let jumps = format!("%1\n{}N9999 M30", of(2000, &|n| format!("N{n} G73 L{n} Q2\n")));
    assert_eq!(case(&jumps).whole().end()["blocks"], 6001);
    let unknown = format!(
        "%1\n{}{}N999999 M30",
        of(5000, &|n| format!("N{n} M05\n")),
        of(20_000, &|n| format!("N{} G73 L{}\n", n + 10_000, 6000 + n % 3000))
    );
    assert_eq!(case(&unknown).run().errors.len(), 10_000);
    let mut macrocycles = case(&format!("%1\n{}N999999 M30", of(6000, &|n| format!("N{n} G72 L{}\n", n % 2000 + 1))));
    for n in 1..=2000 {
        macrocycles = macrocycles.with(&format!("L{n}"), &format!("N1 G79 L{n}\nN2 G70"));
    }
    assert_eq!(macrocycles.whole().end()["blocks"], 18_001);
    let mut ring = case("%1\nN1 G72 L1\nN2 M30");
    for n in 1..=2000 {
        ring = ring.with(&format!("L{n}"), &format!("N1 G79 L{n}\nN2 G72 L{}\nN3 G72 L1\nN4 G70", n % 2000 + 1));
    }
    assert_eq!(ring.run().errors.len(), 2001);
}

/// Block skip, on and off (BLK-6).
#[test]
fn block_skip() {
    let program = "%1\nN10 / X1\nN20 R1=1\nN30 /1 G73 L20 Q5\nN40 R1=2 / \nN50 M30";
    let stream = case(program).whole();
    assert_fields(&stream.records[0], &json!({"block_skip": null}));
    assert_eq!(stream.blocks().len(), 15);
    assert_fields(&stream.blocks()[0], &json!({"skippable": true, "first_block": true}));
    assert_fields(&stream.blocks()[1], &json!({"skippable": null}));
    let stream = case(program).args("--block-skip").whole();
    assert_fields(&stream.records[0], &json!({"block_skip": true}));
    let found = stream.blocks();
    assert_eq!(column(&found, "n"), json!([20, 50]));
    assert_eq!(column(&found, "seq"), json!([0, 1]));
    assert_fields(&found[0], &json!({"first_block": true, "last_block": null, "position": null}));
    assert_fields(&stream.end(), &json!({"blocks": 2}));
}

/// A skipped block is not executed, as the target of a jump neither: execution goes on behind it (BLK-6, FLW-3).
#[test]
fn jump_to_a_skipped_block() {
    let found = case("%1\nN10 G73 L30\nN20 M99\nN30 / M98\nN40 M30").args("--block-skip").blocks();
    assert_eq!(column(&found, "n"), json!([10, 40]));
    assert_eq!(found[0]["jump"], json!({"to": 30}));
}

/// `--from` and `--limit` write a part of the block records; everything else is as in the whole stream.
#[test]
fn parts() {
    let program = "%1\nN10 X0\nN20 G72 L7 Q2\nN30 X5\nN40 M30";
    let of = |from, limit| {
        let part = Part { from, limit };
        Case { part, ..case(program).with("L7", "N1 G79 L7\nN2 G91 X1\nN3 G90 G70") }.whole()
    };
    let all = of(0, None);
    assert_eq!(all.blocks().len(), 10);
    for (from, limit) in
        [(0, Some(0)), (0, Some(3)), (4, None), (4, Some(2)), (9, Some(u64::MAX)), (20, Some(1)), (u64::MAX, None)]
    {
        let part = of(from, limit);
        let wanted: Vec<Value> = all
            .records
            .iter()
            .filter(|record| {
                record["kind"] != "block" || {
                    let seq = record["seq"].as_u64().unwrap();
                    seq >= from && limit.is_none_or(|limit| seq - from < limit)
                }
            })
            .cloned()
            .collect();
        assert_eq!(part.records, wanted, "{from} {limit:?}");
    }
    assert_fields(&all.end(), &json!({"blocks": 10, "path_mm": 5, "path_mm_by_type": {"rapid": 5}}));
}

/// With a limit of k records, k are written, and there is no end (FLW-9, §13 Checking).
#[test]
fn record_limit() {
    let program = "%1\nN10 X0\nN20 G73 L10 Q9999\nN30 G73 L10 Q9999\nN40 M30";
    let stream = case(program).args("--max-blocks=5").run();
    assert_eq!(stream.errors, ["E0410"]);
    assert_eq!(column(&stream.blocks(), "seq"), json!([0, 1, 2, 3, 4]));
    assert_eq!(stream.end()["kind"], "block");
    assert_eq!(case("%1\nN10 X0\nN20\nN30 M30").args("--max-blocks=3").whole().blocks().len(), 3);
}

/// After an error there is no end record, and no record of the block with the error (block-stream.md).
#[test]
fn errors_end_the_stream() {
    let stream = case("%1\nN10 R1=1\nN20 G26 R5=04010203 R2=0\nN30 XR3\nN40 M30").config(OPERATIONS).run();
    assert_eq!(stream.errors[0], "E0509");
    assert!(stream.records.iter().all(|record| record["kind"] != "end"));
    let stream = case("%1\nN10 X0\nN20 XR1\nN30 M30").run();
    assert_eq!(stream.errors, ["W0503"]);
    assert!(stream.records.iter().all(|record| record["kind"] != "end"));
    let stream = case("%1\nN10 XR1 R2=R1\nN20 YR2\nN30 M30").args("--param R1=-2.5").whole();
    assert_eq!(stream.blocks()[1]["position"], json!({"X": -2.5, "Y": -2.5}));
}

/// How numbers are written: no exponent, no negative zero, no trailing zeros (block-stream.md).
#[test]
fn number_formats() {
    let stream = case(
        "%1\nN10 X-0 Y+0.10 Z-0.000 A-.001 F1.50\nN20 G02 X-0.002 Y0.1 I-0.001\nN30 X0 Y0.1 I0.001 J-0\nN40 R1=-0\nN45 G00 R2=R1 R3=-R1 X-R1\n\
         N50 G00 X69999.999 U-69999.999\nN60 M30",
    )
    .run();
    assert_eq!(stream.errors, Vec::<String>::new());
    assert!(!stream.text.contains("-0,") && !stream.text.contains("-0}"), "{}", stream.text);
    assert!(stream.text.contains(r#""position":{"X":0,"Y":0.1,"Z":0,"A":-0.001}"#), "{}", stream.text);
    assert!(stream.text.contains(r#""feed":1.5,"#));
    assert!(!stream.text.to_lowercase().contains("e-"), "{}", stream.text);
}

/// Sums are taken over the lengths as written (§13 More), by motion type.
#[test]
fn path_sums() {
    let stream = case(
        "%1\nN5 F100\nN10 X0 Y0\nN40 G91 G01 X1 Y1\nN50 G73 L40 Q2\nN60 G03 X10 Y10 J10\nN70 G33 X0.5\nN80 G00 A5\nN90 M30",
    )
    .whole();
    assert_fields(
        &stream.end(),
        &json!({"path_mm": 20.450_605, "path_mm_by_type": {"linear": 4.242_642, "arc_ccw": 15.707_963, "thread": 0.5}}),
    );
}

/// The same bytes for the same input (block-stream.md).
#[test]
fn deterministic() {
    let program = case("%1\nN10 X0 Y0 F10 R9=1 R2=3 R44=5\nN20 G03 X10 Y10 J10 M06\nN30 G72 L1\nN40 M30")
        .config(GEARS)
        .with("L1", "N1 G79 L1\nN2 G70");
    assert_eq!(program.run().text, program.run().text);
}
