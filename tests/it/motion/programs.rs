//! Programs as texts: words that keep small blocks whole, short arcs, times of functions, rises in short blocks.

use std::ops::ControlFlow;
use std::path::Path;

use cnc872c::analysis::motion::{BlockTimes, Break, MotionTimes};
use cnc872c::config::Purpose;
use cnc872c::diag::Findings;
use cnc872c::run::{End, Executed};
use cnc872c::session::{TimedSink, Times};

use super::build::close;
use crate::plc::{Case, case};

/// The blocks of a run.
struct Blocks(Vec<BlockTimes>);

impl TimedSink for Blocks {
    type Whole = Vec<BlockTimes>;

    fn block(&mut self, _: &Executed<'_>, times: &BlockTimes, _: &mut Findings) -> ControlFlow<()> {
        self.0.push(times.clone());
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) -> Vec<BlockTimes> {
        self.0
    }
}

fn planned(case: &Case) -> Vec<BlockTimes> {
    case.in_session(|session| {
        let sink = Blocks(Vec::new());
        let run = session.run_timed(Path::new("P.NC"), "P.NC", Purpose::Compile, Times::default(), sink);
        run.whole.unwrap_or_else(|| panic!("{:?}", run.outcome.findings.items()))
    })
}

/// On CNC8x9, with these lines of configuration.
fn cnc8x9(config: &str, blocks: &str) -> Case {
    case(&format!("%1\nN1 G0 G90 X0 Y0\n{blocks}\nN9 M30\n")).config(&format!("dialect = \"cnc8x9\"\n{config}"))
}

fn motion(blocks: &[BlockTimes], n: u32) -> &MotionTimes {
    blocks.iter().find(|block| block.n == n).unwrap().motion.as_ref().unwrap()
}

/// Which of N2 to N5 are part of another block's piece.
fn merged(blocks: &str) -> [bool; 4] {
    let planned = planned(&cnc8x9("[machine-constants]\nR383 = 0.005\n", blocks));
    [2, 3, 4, 5].map(|n| motion(&planned, n).merged)
}

/// CNT-4: words that change nothing leave a block small; any other ends the piece at its block.
#[test]
fn words_in_small_blocks() {
    let keep = ["", "G1", "F1000", "G23", "G23 I1", "G90", "G94", "G40", "R5=1", "G80"];
    let end = ["F1001", "G23 I2", "G18", "G41", "M8", "S100", "T1", "H1", "P1", "D1", "G4 Q0"];
    let words = keep.map(|word| (word, true)).into_iter().chain(end.map(|word| (word, false)));
    for (word, small) in words {
        let blocks = format!("N2 G23 G1 X10 F1000\nN3 X10.003\nN4 X10.004 {word}\nN5 X20");
        assert_eq!(merged(&blocks), [false, true, small, false], "{word}");
    }
    // What F counts changed by the axes, and a jump is over: no word changed it.
    let by_angle =
        cnc8x9("[start]\nA = 0\n[machine-constants]\nR383 = 0.005\n", "N2 G23 G1 A10 F1000\nN3 X0.003 G1\nN4 X5");
    assert!(motion(&planned(&by_angle), 3).merged);
    assert_eq!(merged("N2 G23 G1 X10 F1000 G73 L3\nN3 X10.003 G1\nN4 X20\nN5 X30"), [false, true, false, false]);
    // In G91 no block is small, where it is written and behind it.
    assert_eq!(merged("N2 G23 G1 X10 F1000\nN3 X10.003\nN4 G91 X0.001\nN5 X10"), [false, true, false, false]);
    assert_eq!(merged("N2 G23 G1 G91 X10 F1000\nN3 X0.003\nN4 X0.001\nN5 X10"), [false; 4]);
}

/// W0801: both blocks beside the joint are in G23, also where the piece before it begins in G24 (DOT-1 takes its mode
/// from there).
#[test]
fn a_joint_is_in_g23_by_the_blocks_beside_it() {
    let within = |blocks: &str| {
        let planned = planned(&cnc8x9("[machine-constants]\nR383 = 0.005\n", blocks));
        let joint = motion(&planned, 5).joint.unwrap();
        (joint.within_g23, joint.broken_by)
    };
    assert_eq!(within("N2 G24 G1 X10 F1000\nN3 X10.003\nN4 G23 X20\nN5 Y30"), (true, Some(Break::Angle)));
    assert!(!within("N2 G24 G1 X10 F1000\nN3 G23 X20\nN4 G24 X30\nN5 G23 Y30").0);
}

/// CNT-2: an arc moves along an axis of the first three though one of its ends has no direction there.
#[test]
fn arcs_with_a_fourth_linear_axis() {
    let config = "[[axes]]\nletter = \"X\"\n[[axes]]\nletter = \"Y\"\n[[axes]]\nletter = \"Z\"\n[[axes]]\nletter = \"U\"\n\
        [start]\nU = 0\n[machine-constants]\nR39 = 0.090\n";
    let planned = planned(&cnc8x9(config, "N2 G23 G2 X5 U-5 I5 F600\nN3 G1 X20"));
    assert!(motion(&planned, 3).joint.as_ref().is_some_and(|joint| joint.broken_by.is_none()), "{planned:?}");
}

/// CNT-2: an arc that is shorter than `break-length-mm` breaks too, at both of its ends.
#[test]
fn short_arcs() {
    // A quarter of radius 0.2, 0.31416 mm long, between lines that it continues.
    let blocks = "N2 G23 G1 X10 F1000\nN3 G3 X10.2 Y0.2 I0 J0.2\nN4 G1 Y10";
    for (limit, short) in [
        ("[machine-constants]\nR382 = 0.5\n", true),
        ("[machine-constants]\nR382 = \"00000315\"\n", true),
        ("[machine-constants]\nR382 = \"00000314\"\n", false),
        ("[machine-constants]\nR382 = \"-00000500\"\n", false),
        ("[motion]\nbreak-length-mm = 0.5\n", true),
        ("", false),
    ] {
        let planned = planned(&cnc8x9(limit, blocks));
        for n in [3, 4] {
            let joint = motion(&planned, n).joint.unwrap();
            assert_eq!(joint.broken_by, short.then_some(Break::ShortLength), "{limit} N{n}");
        }
    }
}

/// The slowest function that acts at the start of the block, and after it the slowest that acts at its end; one with
/// both attributes acts at the start.
#[test]
fn times_of_functions() {
    let functions = "<C><MFunctions><MFunc No=\"92\" GroupNo=\"10\" BreakCont=\"1\"/>\
                     <MFunc No=\"95\" GroupNo=\"11\" BreakContEnd=\"1\"/>\
                     <MFunc No=\"96\" GroupNo=\"12\" BreakCont=\"1\" BreakContEnd=\"1\"/>\
                     <MFunc No=\"97\" GroupNo=\"13\" BreakContEnd=\"1\"/></MFunctions></C>";
    let config = "channel-config = \"C.xml\"\n[motion.times]\nM92 = 2\nM95 = 3\nM96 = 4\nM97 = 5\nT = 1\n";
    for (words, seconds) in [
        ("M92", 2.0),
        ("M95", 3.0),
        ("M96", 4.0),
        ("M92 M95", 5.0),
        ("M92 M96", 4.0),
        ("M92 M95 M96", 7.0),
        ("M95 M97", 5.0),
        ("T5 M92", 2.0),
        ("T5 M95", 4.0),
    ] {
        let program = case(&format!("%1\nN1 {words}\nN2 M30\n")).config(config).with("C.xml", functions);
        let block = &planned(&program)[0];
        assert_eq!((block.function_s, block.duration_s), (seconds, seconds), "{words}");
    }
}

/// VEL-9: in a block shorter than `raise-length-mm` the velocity does not rise, but where it stops at both ends.
#[test]
fn rises_in_short_blocks() {
    let key = "[motion]\nraise-length-mm = 10\nraise-ms = 1\n";
    let constant = "[machine-constants]\nR386 = \"00010000\"\nR395 = \"00000001\"\n";
    let negative = "[machine-constants]\nR386 = \"-00010000\"\nR395 = \"00000001\"\n";
    let off = "[motion]\nraise-ms = 1\n";
    let between = "N2 G23 G1 X50 F1000\nN3 X59.999 F3000\nN4 X90 F1000";
    let longer = "N2 G23 G1 X50 F1000\nN3 X60 F3000\nN4 X90 F1000";
    let first = "N3 G23 G1 X9.999 F3000\nN4 X90 F1000";
    let alone = "N2 G23 G1 X50 F1000 M0\nN3 X59.999 F3000 M0\nN4 X90 F1000";
    for (config, blocks, peak) in [
        (key, between, 1000.0),
        (constant, between, 1000.0),
        (negative, between, 3000.0),
        (off, between, 3000.0),
        (key, longer, 3000.0),
        (constant, longer, 3000.0),
        (key, first, 1000.0),
        (off, first, 3000.0),
        (key, alone, 3000.0),
        (constant, alone, 3000.0),
    ] {
        let planned = planned(&cnc8x9(config, blocks));
        close(motion(&planned, 3).velocities.unwrap().peak * 60.0, peak, 1e-9);
    }
}
