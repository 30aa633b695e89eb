//! Properties of whatever bytes come: no panic, no hang, places inside the files, bounded findings, the same output
//! again.
//!
//! The seed is fixed, so that a run is the same everywhere; `PROPTEST_CASES=10000 cargo test --test it properties::`
//! looks further, with other seeds.

use std::path::{Path, PathBuf};

use cnc872c::config::{Overrides, Settings, configure, find_project};
use cnc872c::diag::{Diagnostic, Findings, Format, Report, Shown, render};
use cnc872c::dict::{Dialect, Lang};
use cnc872c::session::{Outcome, Part, Session};
use cnc872c::text::{Loader, Location, MemoryLoader, Sources};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use crate::disk::TestDisk;
use crate::disk::files;
use crate::samples::root;

/// Most block records of a run.
const MOST_BLOCKS: u64 = 300;

/// So many cases, with a fixed seed unless the environment asks for more.
pub fn cases(cases: u32) -> ProptestConfig {
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::default() };
    if std::env::var("PROPTEST_CASES").is_ok() {
        return config;
    }
    ProptestConfig { cases, rng_seed: RngSeed::Fixed(872), ..config }
}

/// The settings of every dialect, with and without block skip, for the project of a loader's folder.
fn modes(loader: &dyn Loader) -> Vec<Settings> {
    let project = find_project(Path::new(""), loader);
    let mut modes = Vec::new();
    for dialect in [Dialect::Cnc872, Dialect::Cnc8x6, Dialect::Cnc8x9] {
        for block_skip in [false, true] {
            let overrides = Overrides {
                dialect: Some(dialect),
                block_skip: Some(block_skip),
                optional_stop: Some(block_skip),
                max_blocks: Some(MOST_BLOCKS),
                ..Overrides::default()
            };
            modes.push(configure(project.as_deref(), &overrides, loader, &mut Sources::new(), &mut Findings::new()));
        }
    }
    modes
}

/// Every place of a finding.
fn places(found: &Diagnostic) -> impl Iterator<Item = Location> + '_ {
    std::iter::once(found.at)
        .chain(found.labels.iter().map(|label| label.at))
        .chain(found.calls.iter().map(|call| call.at))
        .chain(found.fixes.iter().flat_map(|fix| fix.edits.iter().map(|edit| edit.at)))
}

/// Places lie in their files and between characters; fixes do not overlap.
fn assert_places(outcome: &Outcome) {
    for found in outcome.findings.items() {
        for at in places(found) {
            let source = outcome.sources.get(at.file).expect("a file of the run");
            let text = source.text();
            let (start, end) = (at.span.start as usize, at.span.end as usize);
            assert!(start <= end && end <= text.len(), "{}: {at:?} of {}", found.code(), text.len());
            assert!(text.is_char_boundary(start) && text.is_char_boundary(end), "{}: {at:?}", found.code());
        }
        for fix in &found.fixes {
            let mut edits: Vec<Location> = fix.edits.iter().map(|edit| edit.at).collect();
            edits.sort();
            assert!(edits.windows(2).all(|pair| pair[0].span.end <= pair[1].span.start), "{}: overlap", found.code());
        }
    }
}

/// An upper bound of the tokens of a text.
fn tokens(text: &str) -> usize {
    let class = |character: char| match character {
        ' ' | '\t' | '\r' | '\n' => 0,
        '0'..='9' | '.' => 1,
        _ => 2,
    };
    let mut last = 0;
    let mut count = 0;
    for character in text.chars() {
        let class = class(character);
        count += usize::from(class == 2 || (class == 1 && last != 1));
        last = class;
    }
    count
}

/// Checks or compiles, and looks at what came out: the findings as text, and the stream.
fn outcome(loader: &dyn Loader, file: &str, settings: &Settings, compile: bool) -> (Vec<u8>, Vec<u8>) {
    let session = Session { loader, settings, progress: None };
    let mut stream = Vec::new();
    let (outcome, whole) = if compile {
        let run = session.compile(Path::new(file), file, Part::default(), &mut stream).unwrap();
        (run.outcome, run.whole.is_some())
    } else {
        (session.check(Path::new(file), file), false)
    };
    assert_places(&outcome);
    assert!(outcome.executed <= MOST_BLOCKS + 1);
    let count = outcome.findings.items().len();
    let most: usize = outcome.sources.iter().map(|(_, source)| 2 * tokens(source.text()) + 4).sum();
    assert!(count <= most, "{count} findings of {most}");
    let ended = stream.ends_with(b"}\n") && stream.windows(13).any(|window| window == b"\"kind\":\"end\",");
    let mut report = Report::new();
    report.add_program(&outcome.sources, outcome.findings);
    if compile {
        assert_eq!(ended, report.errors() == 0, "the end of the stream against the errors");
        assert_eq!(ended, whole);
    }
    let order: Vec<Location> = report.items().map(|item| item.diagnostic.at).collect();
    assert!(order.is_sorted());
    let mut text = Vec::new();
    render(Format::Short, &report, Shown { lang: Lang::Cs, colour: false, all: true }, &mut text).unwrap();
    (text, stream)
}

/// All that must hold for any file.
fn assert_sound(bytes: &[u8], mode: usize) {
    let settings = modes(&MemoryLoader::new()).swap_remove(mode % 6);
    let loader = MemoryLoader::new().with("p.nc", bytes).with("L1", bytes).with("L9001.NC", bytes);
    for (file, compile) in [("p.nc", false), ("p.nc", true), ("L1", false)] {
        let first = outcome(&loader, file, &settings, compile);
        assert!(first == outcome(&loader, file, &settings, compile), "another output the second time");
    }
    let session = Session { loader: &loader, settings: &settings, progress: None };
    let outcome = session.check(Path::new("p.nc"), "p.nc");
    let mut report = Report::new();
    report.add_program(&outcome.sources, outcome.findings);
    for format in [Format::Human, Format::Json, Format::Sarif, Format::Github] {
        let mut text = Vec::new();
        render(format, &report, Shown { lang: Lang::En, colour: true, all: false }, &mut text).unwrap();
        assert!(std::str::from_utf8(&text).is_ok());
    }
}

/// Pieces of programs, right and wrong.
const WORDS: &[&str] = &[
    "%",
    "%1",
    "N",
    "N1",
    "N2",
    "N10",
    "N10",
    "N020",
    "N99999999",
    "/",
    "*",
    "\"",
    "\"KAPSA\"",
    "\"a",
    "“",
    "”",
    "é",
    "\u{1a}",
    "\0",
    "\u{2028}",
    "G0",
    "G1",
    "G2",
    "G3",
    "G4",
    "G26",
    "G27",
    "G29",
    "G31",
    "G33",
    "G30",
    "G54",
    "G58",
    "G70",
    "G71",
    "G72",
    "G73",
    "G74",
    "G79",
    "G81",
    "G80",
    "G90",
    "G91",
    "G92",
    "G93",
    "G94",
    "G95",
    "G18",
    "G19",
    "G23",
    "G09",
    "G20",
    "G100",
    "GR1",
    "g1",
    "M0",
    "M1",
    "M2",
    "M3",
    "M6",
    "M19",
    "M30",
    "M40",
    "M41",
    "M101",
    "MR1",
    "X",
    "X1",
    "X-1.5",
    "X.5",
    "X1.0005",
    "X36,5",
    "XO",
    "X1O",
    "Xl0",
    "X- 1",
    "X1.2.3",
    "X--5",
    "X+5",
    "XR1",
    "X R1",
    "X-R2",
    "Y0",
    "Y5",
    "Z10",
    "A90",
    "C-360",
    "I",
    "I5",
    "J-5",
    "K1",
    "IR1",
    "R",
    "R1",
    "R1=5",
    "R1=R2",
    "R1=-R2",
    "R1 5",
    "R5=1020304",
    "R5=-4010203",
    "R6=1",
    "R95=1",
    "R96=1",
    "R1R2=5",
    "R1=",
    "=",
    "=5",
    "F",
    "F500",
    "F0",
    "F0.1",
    "FR1",
    "S1000",
    "S-1",
    "T1",
    "D1",
    "H5",
    "P5",
    "&0",
    "&12",
    "&2222",
    "&3",
    "L1",
    "L2",
    "L10",
    "L9001",
    "LR1",
    "Q1",
    "Q2",
    "Q0",
    "Q50",
    "QR1",
    "Q5.",
    "E5",
    "O",
    "5",
    ".",
    "-",
    "+",
    "99999999999999999999",
    "N1G73L1Q2",
    "N10 G73 L1",
    "N2 M30",
    "N5 G79 L1",
    "N6 G70",
];

/// Words and signs in any order.
pub fn soup() -> impl Strategy<Value = String> {
    let gap = prop::sample::select(&["", " ", " ", " ", "\n", "\r\n", "\t", "\r"][..]);
    prop::collection::vec((prop::sample::select(WORDS), gap), 0..60)
        .prop_map(|pieces| pieces.into_iter().flat_map(|(word, gap)| [word, gap]).collect())
}

/// Words that are right by themselves: of these most programs are executed.
const RIGHT: &[&str] = &[
    "G0",
    "G1",
    "G2",
    "G3",
    "G4 Q1",
    "G4 Q9999",
    "G9",
    "G18",
    "G19",
    "G23",
    "G26 R5=1020304",
    "G27 R5=1020304 R6=-2020305",
    "G33",
    "G30",
    "G31",
    "G35",
    "G54",
    "G58",
    "G74",
    "G81",
    "G90",
    "G91",
    "G92",
    "G93",
    "G95",
    "G96",
    "G71 L1",
    "G71 L1 Q3",
    "G71 LR1",
    "G72 L1",
    "G72 L9001",
    "G73 L1",
    "G73 L2 Q2",
    "G73 L3 Q3",
    "G73 L4",
    "G73 LR2",
    "G73 L2 QR3",
    "M0",
    "M1",
    "M3",
    "M6",
    "M19",
    "M40",
    "M41",
    "M52",
    "X0",
    "X5",
    "X-69999.999",
    "X1.0005",
    "XR1",
    "Y0",
    "Y10",
    "Y-R2",
    "Z5",
    "ZR3",
    "A90",
    "C-720.5",
    "I5",
    "I-5",
    "J5",
    "IR1",
    "K2",
    "R1=1",
    "R1=2.5",
    "R2=3",
    "R3=R1",
    "R2=-R3",
    "R4=99999999",
    "F500",
    "F0.05",
    "FR2",
    "S100",
    "S9999",
    "SR4",
    "T5",
    "D1",
    "D2",
    "H1",
    "P1",
    "&1200",
    "&0",
    "/",
    "\"note\"",
    "GR1",
    "MR2",
];

/// Programs of which most are executed.
pub fn executed() -> impl Strategy<Value = String> {
    let blocks = prop::collection::vec(prop::collection::vec(prop::sample::select(RIGHT), 0..6), 1..8);
    (blocks, 0..8_usize).prop_map(|(blocks, main)| {
        let mut text = "%1 \"T\"\n".to_owned();
        let number = |index: usize| index + 1;
        for (index, words) in blocks.iter().enumerate() {
            text += &format!("N{} {}\n", number(index), words.join(" "));
            if index == main.min(blocks.len() - 1) {
                text += "N20 M30\nN30 G79 L1\n";
            }
        }
        text + "N40 G70\n"
    })
}

proptest! {
    #![proptest_config(cases(400))]

    /// LEX-13: any bytes.
    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..300), mode in 0..6_usize) {
        assert_sound(&bytes, mode);
    }

    /// Bytes in a program that begins well.
    #[test]
    fn random_text(text in "(%1\n)?([ -~]|[XYZNGM][0-9]{1,3} ?|\n|\"){0,120}", mode in 0..6_usize) {
        assert_sound(text.as_bytes(), mode);
    }

    #[test]
    fn token_soup(text in soup(), mode in 0..6_usize) {
        assert_sound(text.as_bytes(), mode);
    }

    /// The same behind what lets most of it be read.
    #[test]
    fn token_soup_in_a_program(text in soup(), mode in 0..6_usize) {
        assert_sound(format!("%1\nN7 G0 X0 Y0\n{text}\nN8 M30\n").as_bytes(), mode);
    }

    #[test]
    fn executed_soup(text in executed(), mode in 0..6_usize) {
        assert_sound(text.as_bytes(), mode);
    }
}

/// Checks prefixes of every file of a folder of samples: all of a small one, some of a large one. Dialects and modes
/// take turns.
fn prefixes(folder: &str) {
    let mut entries: Vec<PathBuf> =
        std::fs::read_dir(root().join("samples").join(folder)).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for entry in entries {
        let (home, paths) = if entry.is_dir() {
            (entry.clone(), files(&entry))
        } else {
            (entry.parent().unwrap().to_path_buf(), vec![entry])
        };
        let disk = TestDisk { root: home.clone() };
        let mut loader = MemoryLoader::new();
        for path in &paths {
            loader = loader.with(path.strip_prefix(&home).unwrap(), std::fs::read(path).unwrap());
        }
        let modes = modes(&disk);
        for path in &paths {
            if path.extension().is_some_and(|extension| extension == "toml" || extension == "xml") {
                continue;
            }
            let file = path.strip_prefix(&home).unwrap().to_str().unwrap();
            let bytes = std::fs::read(path).unwrap();
            let step = if bytes.len() > 100_000 { bytes.len() / 24 } else { bytes.len() / 150 + 1 };
            for (count, length) in (0..=bytes.len()).step_by(step).enumerate() {
                let loader = loader.clone().with(file, &bytes[..length]);
                let compile = count % 4 == 3 && !Session::is_macrocycle_name(Path::new(file));
                outcome(&loader, file, &modes[count % 6], compile);
            }
        }
    }
}

#[test]
fn prefixes_of_valid_samples() {
    prefixes("ok");
}

#[test]
fn prefixes_of_erroneous_samples() {
    prefixes("err");
}

#[test]
fn prefixes_of_rule_samples() {
    prefixes("rules");
}
