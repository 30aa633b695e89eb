//! `format`: what the control executes stays the same, in samples with slips and in generated programs, in every code
//! page. `rewrites` has the layout of each rule.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use cnc872c::config::{Codes, Level, Numbers, Settings};
use cnc872c::diag::Code;
use cnc872c::dict::{Dialect, Lang};
use cnc872c::session::Session;
use cnc872c::text::{Encoding, MemoryLoader};
use proptest::prelude::*;

use crate::disk::files;
use crate::model::program;
use crate::properties::{cases, executed, soup};
use crate::same_program::{formatted, stays_the_same};
use crate::samples::root;

/// The settings under which nothing is allowed, so that every finding shows.
fn settings(dialect: Dialect) -> Settings {
    let mut settings = Settings::new(dialect);
    settings.lints.extend([(Code::E0109, Level::Warn)]);
    settings.machine.limits.records = 2000;
    settings
}

fn samples() -> Vec<(String, Vec<u8>)> {
    let all: Vec<PathBuf> = files(&root().join("samples"));
    let programs = all.into_iter().filter(|path| {
        !matches!(path.extension().and_then(|e| e.to_str()), Some("toml" | "xml" | "md" | "snap" | "txt"))
    });
    let name = |path: &Path| path.file_name().unwrap().to_string_lossy().into_owned();
    programs
        .map(|path| (name(&path), std::fs::read(path).unwrap()))
        .filter(|(_, bytes)| bytes.len() < 100_000)
        .collect()
}

/// FMT-1, FMT-7: every sample.
#[test]
fn samples_stay_the_same_programs() {
    for dialect in [Dialect::Cnc872, Dialect::Cnc8x6] {
        let settings = settings(dialect);
        for (name, bytes) in samples() {
            if let Err(difference) = stays_the_same(&name, &bytes, &settings) {
                panic!("{difference}");
            }
        }
    }
}

/// FMT-7: a long line never becomes two.
#[test]
fn one_long_line_stays() {
    let comment = "x".repeat(85);
    let program = format!("%1 N1 G0 G90 X1 \"{comment}\" N2 X2 \"{comment}\" N3 M30\n");
    assert_eq!(stays_the_same("p.nc", program.as_bytes(), &settings(Dialect::Cnc872)), Ok(()));
}

/// FMT-3, FMT-6: characters between the last word and `*` are no word, and so their line stays.
/// One letter that is no address stands for all that it may have set.
#[test]
fn a_letter_that_is_no_address() {
    for words in ["X1 E 5", "X1   E5", "M3 O 0", "X1 O  12 Y2"] {
        let program = format!("%1\nN10 {words}\nN20 M30\n");
        assert_eq!(stays_the_same("p.nc", program.as_bytes(), &settings(Dialect::Cnc872)), Ok(()), "{words}");
    }
}

#[test]
fn characters_before_the_star_stay() {
    let program = format!("%1\nN7 G0 X0 Y0\nN20 G1X1Y1\"{}\"G26%*X+5\tg1\n", "x".repeat(53));
    assert_eq!(stays_the_same("p.nc", program.as_bytes(), &settings(Dialect::Cnc872)), Ok(()));
}

/// FMT-7: the blank before `*` does not change what a help advises.
#[test]
fn helps_about_a_star_stay() {
    let settings = settings(Dialect::Cnc872);
    let helps = |text: &[u8]| {
        let loader = MemoryLoader::new().with("p.nc", text.to_vec());
        let outcome = Session { loader: &loader, settings: &settings, progress: None }.check(Path::new("p.nc"), "p.nc");
        outcome.findings.items().iter().map(|item| item.finding.help(Lang::En)).collect::<Vec<_>>()
    };
    for star in ["N20 Z5*2\nN30 M30\n", "N20 R50=R50*2\nN30 M30\n", "N20 M30*5\n"] {
        let before = format!("%1\nN10 G00 G90 X0\n{star}");
        let after = formatted("p.nc", before.as_bytes(), &settings).unwrap();
        assert!(after.contains(&b'*'), "{star}");
        assert_eq!(helps(before.as_bytes()), helps(&after), "{star}");
    }
}

/// A change of a text at a place: something that slips of the keyboard and other editors leave.
#[derive(Clone, Debug)]
enum Slip {
    Delete,
    Double,
    Insert(&'static str),
}

fn slip() -> impl Strategy<Value = Slip> {
    const TEXTS: &[&str] = &[
        " ",
        "  ",
        "\t",
        "\r\n",
        "\n",
        "\r",
        "\n\n\n",
        "\"",
        "\"x y\"",
        "*",
        "/",
        "N",
        "N5 ",
        "x",
        "G1 ",
        "R1=2 ",
        "R3 4 ",
        "%",
        ";",
        "0",
        ".",
        "-",
        "\u{1a}",
        " X1 Y2 Z3 A4 B5 C6 S1000 T12 H1 P1 ",
        "\"a comment that is rather long, as they are\"",
    ];
    prop_oneof![2 => Just(Slip::Delete), 1 => Just(Slip::Double), 6 => prop::sample::select(TEXTS).prop_map(Slip::Insert)]
}

fn slipped(bytes: &[u8], slips: &[(prop::sample::Index, Slip)]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for (at, slip) in slips {
        let at = if bytes.is_empty() { 0 } else { at.index(bytes.len()) };
        match slip {
            Slip::Delete if !bytes.is_empty() => drop(bytes.remove(at)),
            Slip::Double if !bytes.is_empty() => bytes.insert(at, bytes[at]),
            Slip::Delete | Slip::Double => {}
            Slip::Insert(text) => drop(bytes.splice(at..at, text.bytes())),
        }
    }
    bytes
}

/// The line ends of the text made others.
fn with_line_ends(bytes: &[u8], ends: &str) -> Vec<u8> {
    let text: Vec<u8> = bytes.iter().copied().filter(|byte| *byte != b'\r').collect();
    text.split(|byte| *byte == b'\n').collect::<Vec<_>>().join(ends.as_bytes())
}

/// What stands between words and between blocks; comments have letters of every code page.
const GAPS: &[&str] = &[
    " ",
    "",
    "  ",
    "\t",
    "\n",
    " \n  ",
    "\n\n\n\n",
    "\n\n\"příruba\"\n \"šroub\"\n",
    " \"čep Ž 5\" ",
    "\n\"open \t\n",
    "\"a comment that is rather long, as they are\"",
    " X1 Y2 Z3 A4 B5 C6 S1000 T12 H1 P1 ",
];

/// Programs, most of which are executed, with other gaps now and then.
fn loose() -> impl Strategy<Value = String> {
    let executed = executed().boxed();
    let soup = soup().prop_map(|soup| format!("%1\nN7 G0 X0 Y0\n{soup}\nN8 M30\n")).boxed();
    let model = program().prop_map(|program| program.text()).boxed();
    let gaps = prop::collection::vec(prop::option::weighted(0.2, prop::sample::select(GAPS)), 1..40);
    (prop_oneof![executed, soup, model], gaps).prop_map(|(text, gaps)| {
        let mut gaps = gaps.into_iter().cycle();
        let pieces = text.split_inclusive([' ', '\n']).map(|piece| {
            let gap = gaps.next().flatten();
            gap.map_or_else(|| piece.to_owned(), |gap| format!("{}{gap}", piece.trim_end()))
        });
        pieces.collect()
    })
}

/// Settings of one layout, as the project file can have it.
fn styled(page: Encoding) -> impl Strategy<Value = Settings> {
    (0..Codes::NAMED.len(), 0..Numbers::NAMED.len(), 1_u8..5, 0_u8..3).prop_map(
        move |(codes, numbers, indent, blank)| {
            let mut settings = settings(Dialect::Cnc872);
            settings.encoding = page;
            settings.format.codes = Codes::NAMED[codes].1;
            settings.format.numbers = Numbers::NAMED[numbers].1;
            (settings.format.indent, settings.format.blank_lines) = (indent, blank);
            settings
        },
    )
}

/// The code pages of files that are not in UTF-8.
fn page() -> impl Strategy<Value = Encoding> {
    prop::sample::select(vec![Encoding::Cp852, Encoding::Windows1250, Encoding::Iso88592, Encoding::Kamenicky])
}

fn line_end() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec!["\n", "\r\n", "\r"])
}

proptest! {
    #![proptest_config(cases(300))]

    /// FMT-1, FMT-6, FMT-7: samples with slips, in every code page, with every line end.
    #[test]
    fn slips_stay_the_same_programs(
        sample in any::<prop::sample::Index>(),
        slips in prop::collection::vec((any::<prop::sample::Index>(), slip()), 0..5),
        ends in line_end(),
        settings in page().prop_flat_map(styled),
    ) {
        let samples = SAMPLES.with(Clone::clone);
        let (name, bytes) = &samples[sample.index(samples.len())];
        let bytes = slipped(&with_line_ends(bytes, ends), &slips);
        prop_assert_eq!(stays_the_same(name, &bytes, &settings), Ok(()));
    }

    /// The same of generated programs and macrocycles.
    #[test]
    fn generated_programs_stay_the_same(
        text in loose(),
        slips in prop::collection::vec((any::<prop::sample::Index>(), slip()), 0..3),
        ends in line_end(),
        utf8 in any::<bool>(),
        name in prop::sample::select(vec!["p.nc", "L1"]),
        settings in page().prop_flat_map(styled),
    ) {
        let encoding = if utf8 { Encoding::Utf8 } else { settings.encoding };
        // Letters that not every code page has.
        let text = text.replace(|letter: char| !letter.is_ascii() && !GAPS.concat().contains(letter), "?");
        let bytes = slipped(&with_line_ends(&encoding.encode(&text), ends), &slips);
        prop_assert_eq!(stays_the_same(name, &bytes, &settings), Ok(()));
    }
}

thread_local! {
    static SAMPLES: Arc<Vec<(String, Vec<u8>)>> =
        Arc::new(samples().into_iter().filter(|(_, bytes)| bytes.len() < 3000).collect());
}
