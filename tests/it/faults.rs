//! One fault in a valid program gives exactly its own finding, at its place.

use cnc872c::diag::Code;
use cnc872c::text::MemoryLoader;
use proptest::prelude::*;

use crate::markers::{Request, options};
use crate::model::{Block, Flow, Motion, Program, first_number, joined, last_number, program};
use crate::properties::cases;
use crate::run::run;

/// Where a fault may stand.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
enum Where {
    /// In any unit: found without execution.
    Any,
    /// In the main program, behind its first block.
    Main,
}
use Where::{Any, Main};

/// A block with one fault, its code, and the text at its place.
const BLOCKS: &[(&str, &str, &str, Where)] = &[
    ("N9 G0 X1 é Y2", "E0101", "é", Any),
    ("N9 G0 X1 ;:; Y2", "E0101", ";:;", Any),
    ("N9 G0 X36. 12", "E0102", "X36. 12", Any),
    ("N9 G0 X- 36", "E0102", "X- 36", Any),
    ("N9 G0 X Y2", "E0103", "X", Any),
    ("N9 G0 X- Y2", "E0103", "X-", Any),
    ("N9 R10 G0 X1", "E0103", "R10", Any),
    ("N9 G0 X \"POZN\" 5 Y1", "E0103", "X", Any),
    ("N9 G0 X36,5 Y1", "E0104", "X36,5", Any),
    ("N9 G0 X1 “poznamka", "E0105", "“", Any),
    ("N9 G0 X1.2.3 Y1", "E0106", "X1.2.3", Any),
    ("N9 G0 X--5 Y1", "E0106", "X--5", Any),
    ("N9 G0 XO Y1", "E0107", "XO", Any),
    ("N9 G0 X1O0 Y1", "E0107", "X1O0", Any),
    ("N9 g0 X1", "W0108", "g", Any),
    ("N9 %5 G0 X1", "E0202", "%5", Any),
    ("N10 G90", "E0204", "N10", Main),
    ("N9 G70", "E0212", "G70", Main),
    ("N9", "W0214", "N9", Any),
    ("N9 E5 G0 X1", "E0301", "E5", Any),
    ("N9 G0 X70000", "E0302", "70000", Any),
    ("N9 G0 X-100000.5 Y1", "E0302", "-100000.5", Any),
    ("N9 G100 S100", "E0302", "100", Any),
    ("N9 S10000", "E0302", "10000", Any),
    ("N9 D0", "E0302", "0", Any),
    ("N9 G94 F0.5", "E0302", "0.5", Any),
    ("N9 G0 X1.0005", "W0303", "1.0005", Any),
    ("N9 M3.5", "E0304", "3.5", Any),
    ("N9 T5.5", "E0304", "5.5", Any),
    ("N9 T-5", "E0305", "-5", Any),
    ("N9 S+500", "E0305", "+500", Any),
    ("N9 G0 X1 Y1 X2", "E0306", "X2", Any),
    ("N9 F100 F100", "E0306", "F100", Any),
    ("N9 R10=1 R11=2 R10=3", "E0306", "R10=3", Any),
    ("N9 / G90 /", "E0306", "/", Any),
    ("N9 G0 G1 X1", "E0307", "G1", Any),
    ("N9 G90 G91 S100", "E0307", "G91", Any),
    ("N9 G71 G73 L100", "E0307", "G73", Any),
    ("N9 G74 G4 Q50", "E0307", "G4", Any),
    ("N9 G94 G95 F0.2", "E0307", "G95", Any),
    ("N9 G26 G27 R5=1010203", "E0307", "G27", Any),
    ("N9 M3 M4", "E0308", "M4", Any),
    ("N9 M3 M5", "E0308", "M5", Any),
    ("N9 G20 S100", "E0309", "20", Any),
    ("N9 &3", "E0312", "3", Any),
    ("N9 &12000", "E0312", "12000", Any),
    ("N9 G71", "E0401", "G71", Main),
    ("N9 G73 Q2", "E0401", "G73", Any),
    ("N9 L5 X1 G0", "W0402", "L5", Any),
    ("N9 Q5 X1 G0", "W0403", "Q5", Any),
    ("N9 G71 L9999", "E0404", "9999", Main),
    ("N9 G72 L9999", "E0405", "9999", Any),
    ("N9 G73 L9999", "E0406", "9999", Any),
    ("N9 G4", "E0411", "G4", Any),
    ("N9 R96=5", "E0501", "96", Any),
    ("N9 G0 XR96", "E0501", "96", Any),
    ("N9 R95=5", "W0502", "R95=5", Any),
    ("N9 G0 XR1", "W0503", "XR1", Main),
    ("N9 G26", "E0505", "G26", Any),
    ("N9 G26 R5=99010203", "E0508", "99010203", Any),
    ("N9 G2 X5 Y5", "E0602", "G2", Main),
    ("N9 G91 G2 X10 Y0 I4", "E0603", "I4", Main),
    ("N9 G1 X5 I5", "E0609", "I5", Main),
    ("N9 G2 X5 Y5 I5 K1", "E0609", "K1", Main),
    ("N9 G2 X5 Y5 Z5 A5 I5", "E0611", "G2", Main),
    ("N9 G5 X5", "W0612", "G5", Main),
    ("N9 G91 G3 X0 Y0 Z-5 I5", "W0613", "G3", Main),
];

/// Faulty words that any block may have, behind its other words.
const WORDS: &[(&str, &str, &str)] = &[
    ("E5", "E0301", "E5"),
    ("é", "E0101", "é"),
    ("P", "E0103", "P"),
    ("P5O", "E0107", "P5O"),
    ("P5. 5", "E0102", "P5. 5"),
    ("P1,5", "E0104", "P1,5"),
    ("P1.5.5", "E0106", "P1.5.5"),
    ("“", "E0105", "“"),
    ("P100", "E0302", "100"),
    ("P1.5", "E0304", "1.5"),
    ("P-1", "E0305", "-1"),
    ("P1 P1", "E0306", "P1"),
    ("M10 M10", "E0308", "M10"),
    ("G54 G55", "E0307", "G55"),
    ("G20", "E0309", "20"),
    ("&9", "E0312", "9"),
    ("R99=1", "E0501", "99"),
];

fn request(program: &Program) -> Request {
    let mut request = Request::default();
    if program.block_skip {
        options(&mut request.overrides, "--block-skip");
    }
    request
}

/// Codes and the texts of their places.
fn found(program: &Program, text: &str) -> Vec<(String, String)> {
    let run = run(&MemoryLoader::new().with("p.nc", text), "p.nc", &request(program));
    let place = |item: &cnc872c::diag::Reported| {
        (item.diagnostic.code().to_string(), run.report.sources().slice(item.diagnostic.at).to_owned())
    };
    // Programs made at random cut before they start the spindle, and break lines anywhere.
    let made = |item: &&cnc872c::diag::Reported| [Code::W0619, Code::W0221].contains(&item.diagnostic.code());
    run.report.items().filter(|item| !made(item)).map(place).collect()
}

/// Exactly this finding. A block that moves changes where later arcs begin: what is wrong with those is left out.
fn assert_fault(program: &Program, text: &str, code: &str, place: &str) {
    let of_motion = |code: &str| code.get(1..3) == Some("06");
    let mut found = found(program, text);
    found.retain(|(other, _)| of_motion(code) || !of_motion(other));
    assert_eq!(found, [(code.to_owned(), place.to_owned())], "{text}");
}

/// Puts the block behind the first of the unit.
fn insert(program: &Program, unit: usize, block: &str) -> String {
    let mut blocks = program.blocks();
    let first = format!("N{} ", first_number(unit));
    let at = blocks.iter().position(|text| text.trim_start().starts_with(&first)).unwrap();
    blocks.insert(at + 1, format!("{block}\n"));
    joined(&blocks)
}

/// The program with a word at the end of its block number `index` of all steps; none when it has none.
fn append(program: &Program, index: usize, word: &str) -> Option<String> {
    let mut blocks = program.blocks();
    let structure: Vec<u32> =
        (0..program.units.len()).flat_map(|unit| [first_number(unit), last_number(unit)]).collect();
    let is_step = |text: &&mut String| {
        let number = text.trim_start().trim_start_matches(['N', '0']);
        let number: String = number.chars().take_while(char::is_ascii_digit).collect();
        number.parse().is_ok_and(|number: u32| !structure.contains(&number))
    };
    let mut steps: Vec<&mut String> = blocks.iter_mut().filter(is_step).collect();
    let count = steps.len();
    let step = steps.get_mut(index % count.max(1))?;
    let content = step.split('"').next().unwrap().trim_end().to_owned();
    // A comment on a separate line belongs to the next block (BLK-9).
    let between = if word == "“" { ' ' } else { '\n' };
    **step = format!("{content}{between}{word}\n");
    Some(joined(&blocks))
}

/// Every fault once, in the smallest program of two units.
#[test]
fn every_fault() {
    let block =
        |flow| Block { motion: Motion::None, flow, skip: false, spindle: None, speed: None, comment: false, style: 0 };
    let main = vec![block(Flow::Call { to: 1, times: None })];
    let program = Program { units: vec![main, vec![block(Flow::None)]], block_skip: false, end: 30 };
    assert_eq!(found(&program, &program.text()), []);
    let mut wrong = String::new();
    let mut compare = |text: &str, code: &str, place: &str| {
        let found = found(&program, text);
        if found != [(code.to_owned(), place.to_owned())] {
            wrong += &format!("{code} at {place:?}: {found:?} in\n{text}\n\n");
        }
    };
    for (block, code, place, at) in BLOCKS {
        compare(&insert(&program, 0, block), code, place);
        if *at == Any {
            compare(&insert(&program, 1, block), code, place);
        }
    }
    for (word, code, place) in WORDS {
        compare(&append(&program, 0, word).unwrap(), code, place);
    }
    assert!(wrong.is_empty(), "{wrong}");
}

proptest! {
    #![proptest_config(cases(500))]

    /// diagnostics.md, Places: one fault injected into a valid program gives its own finding and no other.
    #[test]
    fn a_faulty_block(program in program(), fault in prop::sample::select(BLOCKS), unit in any::<usize>()) {
        let (block, code, place, at) = fault;
        let unit = if at == Any { unit % program.units.len() } else { 0 };
        prop_assume!(program.execute().is_some());
        assert_fault(&program, &insert(&program, unit, block), code, place);
    }

    #[test]
    fn a_faulty_word(program in program(), (word, code, place) in prop::sample::select(WORDS), index in any::<usize>()) {
        prop_assume!(program.execute().is_some());
        if let Some(text) = append(&program, index, word) {
            assert_fault(&program, &text, code, place);
        }
    }

    /// PRG-1, PRG-2, PRG-3, PRG-4: faults of the structure.
    #[test]
    fn a_faulty_structure(program in program(), unit in any::<usize>()) {
        prop_assume!(program.execute().is_some());
        let text = program.text();
        assert_fault(&program, text.strip_prefix("%1 \"MODEL\"").unwrap(), "E0201", "");
        let end = format!("N{} M{:02}", last_number(0), program.end);
        assert_fault(&program, &text.replace(&end, "N999 G90"), "E0205", "N999");
        assert_fault(&program, &text.replace(&end, &format!("{end} N9 G90")), "E0206", "N9");
        assert_fault(&program, &text.replace(&end, &format!("N9 G70 {end}")), "E0212", "G70");
        assert_fault(&program, &format!("{text}\n*\nX5"), "W0110", "X5");
        if program.units.len() > 1 {
            let unit = 1 + unit % (program.units.len() - 1);
            let (first, last) = (first_number(unit), last_number(unit));
            assert_fault(&program, &text.replace(&format!("N{last} G70"), &format!("N{last} G90")), "E0207", "G79");
            assert_fault(&program, &text.replace(&format!("N{first} G79"), &format!("N{first} X1 G79")), "E0208", "X1");
            assert_fault(&program, &format!("{text}\nN9 G79 L{} N8 G70", 100 * unit), "E0209", &format!("L{}", 100 * unit));
            assert_fault(&program, &format!("{text}\nN9 G79 L9 N8 G70"), "W0211", "G79");
            let jump = insert(&program, 0, &format!("N9 G73 L{last}"));
            assert_fault(&program, &jump, "E0407", &last.to_string());
        }
    }
}
