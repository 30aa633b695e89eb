//! The traps into which tools made for other controls fall, one test for each.

use cnc872c::dict::{Dialect, standard_m_functions};
use cnc872c::text::MemoryLoader;
use serde_json::{Value, json};

use crate::markers::{Request, options};
use crate::run::{Run, run};

fn request(args: &str, compile: bool) -> Request {
    let mut request = Request { compile, ..Request::default() };
    options(&mut request.overrides, args);
    request
}

/// The block records of a program that must have no error.
fn blocks(args: &str, program: &str) -> Vec<Value> {
    let run = compiled(args, program);
    assert_eq!(run.report.errors(), 0, "{:?}\n{program}", run.codes());
    run.records().into_iter().filter(|record| record["kind"] == "block").collect()
}

fn compiled(args: &str, program: &str) -> Run {
    run(&MemoryLoader::new().with("p.nc", program), "p.nc", &request(args, true))
}

/// Codes and the text of their places, in the order of output.
fn checked(args: &str, program: &str) -> Vec<(String, String)> {
    let run = run(&MemoryLoader::new().with("p.nc", program), "p.nc", &request(args, false));
    let place = |item: &cnc872c::diag::Reported| {
        (item.diagnostic.code().to_string(), run.report.sources().slice(item.diagnostic.at).to_owned())
    };
    run.report.items().map(place).collect()
}

fn found(code: &str, place: &str) -> (String, String) {
    (code.to_owned(), place.to_owned())
}

/// The block of that number, executed once.
fn block(blocks: &[Value], n: u32) -> &Value {
    let mut of_number = blocks.iter().filter(|block| block["n"] == n);
    let block = of_number.next().expect("the block is executed");
    assert!(of_number.next().is_none(), "N{n} is executed more than once");
    block
}

fn order(blocks: &[Value]) -> Vec<u64> {
    blocks.iter().map(|block| block["n"].as_u64().unwrap()).collect()
}

/// GRP-2, MOT-3, MOT-5: G18 is YZ and G19 is ZX, the reverse of ISO 6983; I is along the earlier axis of the machine.
#[test]
fn planes_18_and_19_are_swapped() {
    let blocks = blocks(
        "",
        "%1\nN10 G90 G0 X0 Y0 Z0 F500\nN20 G18\nN30 G2 I0 J5\nN40 G19\nN50 G2 I0 J5\nN60 G2 X5 Z5 I0 J5\nN70 M30\n",
    );
    let (g18, g19) = (&block(&blocks, 30)["motion"], &block(&blocks, 50)["motion"]);
    assert_eq!((&g18["plane"], &g18["axes"]), (&json!("YZ"), &json!(["Y", "Z"])));
    assert_eq!(g18["center"], json!({"Y": 0, "Z": 5}));
    assert_eq!((&g19["plane"], &g19["axes"]), (&json!("ZX"), &json!(["X", "Z"])));
    assert_eq!(g19["center"], json!({"X": 0, "Z": 5}), "I is along X, J along Z");
    // G02 in ZX goes from +X to +Z, so from -Z to +X it is a quarter.
    assert_eq!(block(&blocks, 60)["motion"]["sweep_deg"], 90);
}

/// MOT-3: R is a parameter, never a radius.
#[test]
fn r_is_never_a_radius() {
    let program = "%1\nN10 G90 G0 X0 Y0 F500\nN20 G2 X10 Y0 R5\nN30 M30\n";
    assert_eq!(checked("", program), [found("E0103", "R5")]);
    let program = "%1\nN10 G90 G0 X0 Y0 F500\nN20 G2 X10 Y0 R5=5\nN30 M30\n";
    assert_eq!(checked("", program), [found("E0602", "G2")]);
    let blocks = blocks("", "%1\nN10 G90 G0 X0 Y0 F500\nN20 G2 X10 Y0 I5 R5=50\nN30 M30\n");
    assert_eq!(block(&blocks, 20)["motion"]["radius_mm"], 5);
    assert_eq!(block(&blocks, 20)["params"], json!({"R5": 50}));
}

/// FLW-6, GRP-5: beside G04 the Q is the dwell time, and the call is made once.
#[test]
fn q_is_a_dwell_beside_a_call() {
    let program = "%1\nN10 G4 G71 L100 Q50\nN20 M30\nN100 G79 L100\nN110 G70\n";
    assert_eq!(checked("", program), [found("W0412", "Q50")]);
    let blocks = blocks("", program);
    assert_eq!(order(&blocks), [10, 100, 110, 20]);
    assert_eq!(block(&blocks, 10)["dwell_s"], 0.5);
    assert_eq!(block(&blocks, 110)["calls"][0]["of"], 1);
    assert_eq!(checked("", "%1\nN10 G4 Q0.5\nN20 M30\n"), [found("E0304", "0.5")]);
    assert_eq!(block(&self::blocks("", "%1\nN10 G4 Q5.\nN20 M30\n"), 10)["dwell_s"], 0.05);
}

/// LEX-6: a comment that is not closed ends with its line.
#[test]
fn a_comment_ends_with_its_line() {
    let blocks = blocks("", "%1 \"TITLE\nN10 G0 X1 \"OPEN N15 G71\nY2 \"A\" Z3\nN20 M30\n");
    assert_eq!(block(&blocks, 10)["position"], json!({"X": 1, "Y": 2, "Z": 3}));
    assert_eq!(block(&blocks, 10)["comments"], json!(["OPEN N15 G71", "A"]));
    assert_eq!(order(&blocks), [10, 20]);
}

/// BLK-1: a block over several lines, and several blocks in a line.
#[test]
fn blocks_and_lines_are_independent() {
    let blocks = blocks("", "%1\nN10 G0 X1\nY2\n\nZ3 N20 X4 N30 Y5\nM3 N40 M30");
    assert_eq!(order(&blocks), [10, 20, 30, 40]);
    assert_eq!(block(&blocks, 10)["position"], json!({"X": 1, "Y": 2, "Z": 3}));
    assert_eq!((&block(&blocks, 20)["line"], &block(&blocks, 20)["column"]), (&json!(5), &json!(4)));
    assert_eq!((&block(&blocks, 30)["line"], &block(&blocks, 30)["column"]), (&json!(5), &json!(11)));
    assert_eq!(block(&blocks, 30)["m_set"], json!([3]));
}

/// BLK-6: a `/` before `N` belongs to the block before it.
#[test]
fn a_slash_before_n_skips_the_block_before() {
    let program = "%1\nN10 G0 X0\nN20 X1\n/N30 X2\nN40 M30\n";
    assert_eq!(checked("", program), [found("W0213", "/")]);
    let blocks = blocks("--block-skip", program);
    assert_eq!(order(&blocks), [10, 30, 40]);
    let meant = "%1\nN10 G0 X0\nN20 X1\nN30 / X2\nN40 M30\n";
    assert_eq!(checked("", meant), []);
    assert_eq!(order(&self::blocks("--block-skip", meant)), [10, 20, 40]);
}

/// LEX-10, BLK-11: digits behind `/` are not read where a blank is before them, and the word in front keeps its value.
/// LEX-12: a small `l` behind a block number is L where a function takes one.
#[test]
fn words_glued_to_others() {
    let program = "%1\nN1 G90 G0/ 1 X0 Y0 Z0 F9\nN2 X5/ 1\nN3 Y7/ 1 Z5\nN4 M8/\t1\nN5 S500/ 2 M3\nN6l10 G71\nN7 M30\nN8l10 G79\nN9 G70\n";
    let at = |n: u32, program: &str| blocks("", program).into_iter().find(|block| block["n"] == n).unwrap();
    let apart = program.replace('/', " / ").replace('l', " L");
    for n in [1, 2, 3, 4, 5, 6, 9] {
        let [mut glued, mut apart] = [program, apart.as_str()].map(|program| at(n, program));
        for block in [&mut glued, &mut apart] {
            block.as_object_mut().unwrap().remove("column");
        }
        assert_eq!(glued, apart, "N{n}");
    }
    assert_eq!(
        [&at(3, program)["position"], &at(4, program)["m_set"]],
        [&json!({"X": 5, "Y": 7, "Z": 5}), &json!([8])]
    );
    assert_eq!(checked("", program), [found("W0108", "l")]);
}

/// FLW-3, FLW-4: k is the number of jumps; an inner loop runs in full in every pass of the outer one.
#[test]
fn counters_of_nested_jumps() {
    let blocks = blocks("", "%1\nN10 G0 X0\nN20 X1\nN30 G73 L20 Q2\nN40 G73 L20 Q1\nN50 M30\n");
    assert_eq!(order(&blocks), [10, 20, 30, 20, 30, 20, 30, 40, 20, 30, 20, 30, 20, 30, 40, 50]);
    let left: Vec<&Value> =
        blocks.iter().filter(|block| block["n"] == 30).map(|block| &block["jump"]["left"]).collect();
    assert_eq!(left, [&json!(1), &json!(0), &Value::Null, &json!(1), &json!(0), &Value::Null]);
}

/// §8, MFN-6: which coolant M07 and M08 are depends on the control, so both stay what was written; the group is one.
#[test]
fn coolants_by_dialect() {
    let meaning = |m: u8, dialect| standard_m_functions(dialect).find(|row| row.number == m).unwrap().meaning.en;
    for old in [Dialect::Cnc8x6, Dialect::Cnc8x9] {
        assert_eq!((meaning(7, old), meaning(8, old)), ("coolant 2 on", "coolant 1 on"));
    }
    assert_eq!((meaning(7, Dialect::Cnc872), meaning(8, Dialect::Cnc872)), ("coolant 1 on", "coolant 2 on"));
    for dialect in ["cnc8x6", "cnc8x9", "cnc872"] {
        let args = format!("--dialect={dialect}");
        let blocks = blocks(&args, "%1\nN10 M7\nN20 M8\nN30 M17\nN40 M9\nN50 M30\n");
        let values: Vec<&Value> = blocks.iter().map(|block| &block["m"][5]).collect();
        assert_eq!(values, [7, 8, 17, 9, 9], "{dialect}");
        assert_eq!(checked(&args, "%1\nN10 M7 M8\nN20 M30\n"), [found("E0308", "M8")]);
    }
}

/// MFN-7: coolants 3 and 4 are switched off by M53; M52 switches both on.
#[test]
fn m52_is_on_and_m53_off() {
    let blocks = blocks("", "%1\nN10 M52\nN20 M0\nN30 M30\n");
    assert_eq!(blocks.iter().map(|block| &block["m"][6]).collect::<Vec<_>>(), [52, 52, 53]);
    assert_eq!(block(&blocks, 20)["m_at_stop"]["6"], 53);
    assert_eq!(block(&blocks, 30)["m_changed"], json!([1, 2, 5, 6]));
}

/// ADR-2, PAR-8, §13: halves are rounded away from zero, also below it.
#[test]
fn halves_are_rounded_away_from_zero() {
    let program = "%1\nN10 G90 G0 X1.0005 Y-1.0005 Z0.0004\nN20 M30\n";
    assert_eq!(checked("", program), [found("W0303", "1.0005"), found("W0303", "-1.0005"), found("W0303", "0.0004")]);
    assert_eq!(block(&blocks("", program), 10)["position"], json!({"X": 1.001, "Y": -1.001, "Z": 0}));
    let folder = MemoryLoader::new().with("cnc872c.toml", "[operations]\n\"04\" = \"div\"\n").with(
        "p.nc",
        "%1\nN10 R1=1 R2=-1 R3=2000\nN20 G26 R5=4010304 \"0.0005\nN30 G26 R5=4020304\nN40 G26 R5=-4010304\nN50 M30\n",
    );
    let run = run(&folder, "p.nc", &request("", true));
    let results: Vec<Value> = run.records().iter().filter_map(|record| record["params"].get("R4").cloned()).collect();
    assert_eq!(results, [json!(0.001), json!(-0.001), json!(0)], "{:?}", run.codes());
}

/// MOT-8: after a change of origin the start is not where the tool stands, until the next motion.
#[test]
fn lengths_after_a_change_of_origin() {
    let program = "%1\nN10 G90 G1 F500 X0 Y0\nN20 X10\nN30 G55\nN40 X20\nN50 X30\nN60 G58 X40\nN70 X50\nN80 X60\n\
        N90 G54\nN100 G2 X60 I5\nN110 M30\n";
    assert_eq!(checked("", program), [found("W0610", "G2")]);
    let blocks = blocks("", program);
    let length = |n| block(&blocks, n)["motion"]["length_mm"].clone();
    assert_eq!((length(20), length(40), length(50)), (json!(10), Value::Null, json!(10)));
    assert_eq!(
        (length(60), length(70), length(80)),
        (Value::Null, Value::Null, json!(10)),
        "G58 holds in its block only"
    );
    assert_eq!((length(100), block(&blocks, 100)["motion"]["radius_mm"].clone()), (Value::Null, json!(5)));
    assert_eq!(block(&blocks, 40)["position"]["X"], 20, "the programmed position stays known");
}
