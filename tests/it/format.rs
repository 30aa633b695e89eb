//! `format` and `renumber`: the layout of each rule, and that what the control executes stays the same.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use cnc872c::config::{Level, Settings};
use cnc872c::diag::Code;
use cnc872c::dict::Dialect;
use cnc872c::edit::format;
use cnc872c::session::{Outcome, Part, Run, Session};
use cnc872c::text::{Encoding, MemoryLoader, SourceText};
use proptest::prelude::*;

use crate::markers::files;
use crate::properties::cases;
use crate::samples::root;

/// The settings under which nothing is allowed, so that every finding shows.
fn settings(dialect: Dialect) -> Settings {
    let mut settings = Settings::new(dialect);
    settings.lints.extend([(Code::E0109, Level::Warn)]);
    settings.machine.limits.records = 2000;
    settings
}

fn formatted(path: &str, bytes: &[u8], settings: &Settings) -> Option<Vec<u8>> {
    let source = SourceText::decode(path, bytes.to_vec(), settings.encoding).unwrap();
    format(Path::new(path), &Arc::new(source), bytes, settings).ok().map(|(bytes, _)| bytes)
}

/// What the control executes: the records without the places in the text, and what was found, without places.
struct Meaning {
    records: Vec<serde_json::Value>,
    findings: BTreeMap<Code, usize>,
}

fn meaning(path: &str, bytes: &[u8], settings: &Settings) -> Meaning {
    let loader = MemoryLoader::new().with(path, bytes.to_vec());
    let session = Session { loader: &loader, settings, progress: None };
    let mut stream = Vec::new();
    if !Session::is_macrocycle_name(Path::new(path)) {
        let Run { .. } = session.compile(Path::new(path), path, Part::default(), &mut stream).unwrap();
    }
    let Outcome { findings, .. } = session.check(Path::new(path), path);
    let mut counts = BTreeMap::new();
    findings.items().iter().for_each(|item| *counts.entry(item.code()).or_default() += 1);
    for ((_, code), beyond) in findings.beyond() {
        *counts.entry(code).or_default() += beyond;
    }
    let records = stream.split(|byte| *byte == b'\n').filter(|line| !line.is_empty());
    let records = records.map(|line| without_places(serde_json::from_slice(line).unwrap())).collect();
    Meaning { records, findings: counts }
}

fn without_places(mut value: serde_json::Value) -> serde_json::Value {
    fn strip(value: &mut serde_json::Value) {
        if let Some(fields) = value.as_object_mut() {
            fields.remove("line");
            fields.remove("column");
            fields.values_mut().for_each(strip);
        } else if let Some(items) = value.as_array_mut() {
            items.iter_mut().for_each(strip);
        }
    }
    strip(&mut value);
    value
}

/// The comments as bytes, without the blanks at the ends of open ones.
fn long_lines(bytes: &[u8], encoding: Encoding) -> usize {
    let source = SourceText::decode("a", bytes.to_vec(), encoding).unwrap();
    source.text().split(['\n', '\r']).filter(|line| line.chars().count() > 80).count()
}

/// FMT-1, FMT-3, FMT-7: the same program, no finding more, no longer line, and formatting again changes nothing.
fn assert_same_program(path: &str, bytes: &[u8], settings: &Settings) -> Result<(), TestCaseError> {
    let Some(after) = formatted(path, bytes, settings) else { return Ok(()) };
    let shown = |bytes: &[u8]| SourceText::decode("a", bytes.to_vec(), settings.encoding).unwrap().text().to_owned();
    let context = || format!("{path}\n--- before\n{}\n--- after\n{}\n", shown(bytes), shown(&after));
    prop_assert_eq!(shown(&formatted(path, &after, settings).unwrap_or_default()), shown(&after), "{}", context());
    let (old, new) = (meaning(path, bytes, settings), meaning(path, &after, settings));
    for (code, count) in &new.findings {
        prop_assert!(*count <= old.findings.get(code).copied().unwrap_or(0), "{} more\n{}", code, context());
    }
    for (code, count) in &old.findings {
        let layout = matches!(*code, Code::W0108 | Code::E0109);
        let same = new.findings.get(code) == Some(count);
        prop_assert!(layout || same, "{} {count} {:?}\n{}", code, new.findings.get(code), context());
    }
    prop_assert_eq!(old.records.len(), new.records.len(), "{}", context());
    for (old, new) in old.records.iter().zip(&new.records) {
        prop_assert_eq!(old, new, "{}", context());
    }
    let (old, new) = (long_lines(bytes, settings.encoding), long_lines(&after, settings.encoding));
    prop_assert!(new <= old, "{} lines too long, {} before\n{}", new, old, context());
    Ok(())
}

fn samples() -> Vec<(String, Vec<u8>)> {
    let all: Vec<PathBuf> = files(&root().join("samples"));
    let programs = all
        .into_iter()
        .filter(|path| !matches!(path.extension().and_then(|e| e.to_str()), Some("toml" | "xml" | "md" | "snap")));
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
            if let Err(error) = assert_same_program(&name, &bytes, &settings) {
                panic!("{error}");
            }
        }
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

proptest! {
    #![proptest_config(cases(300))]

    /// FMT-1, FMT-6, FMT-7: samples with slips, in every code page, with every line end.
    #[test]
    fn slips_stay_the_same_programs(
        sample in any::<prop::sample::Index>(),
        slips in prop::collection::vec((any::<prop::sample::Index>(), slip()), 0..5),
        ends in prop::sample::select(vec!["\n", "\r\n", "\r"]),
        page in prop::sample::select(vec![Encoding::Cp852, Encoding::Windows1250, Encoding::Kamenicky]),
        style in (0_u8..3, 0_u8..2, 1_u8..5, 0_u8..3),
    ) {
        let samples = SAMPLES.with(Clone::clone);
        let (name, bytes) = &samples[sample.index(samples.len())];
        let bytes = slipped(&with_line_ends(bytes, ends), &slips);
        let mut settings = settings(Dialect::Cnc872);
        settings.encoding = page;
        settings.format.codes = cnc872c::config::Codes::NAMED[usize::from(style.0)].1;
        settings.format.numbers = cnc872c::config::Numbers::NAMED[usize::from(style.1)].1;
        (settings.format.indent, settings.format.blank_lines) = (style.2, style.3);
        assert_same_program(name, &bytes, &settings)?;
    }
}

thread_local! {
    static SAMPLES: Arc<Vec<(String, Vec<u8>)>> =
        Arc::new(samples().into_iter().filter(|(_, bytes)| bytes.len() < 3000).collect());
}

fn text(path: &str, text: &str) -> String {
    String::from_utf8(formatted(path, text.as_bytes(), &settings(Dialect::Cnc872)).unwrap()).unwrap()
}

/// FMT-1: text before `%` and from `*` on, comments, and the line ends that most lines have stay.
#[test]
fn what_stays() {
    let before = "zak. 12\n  part %1\r\nn10  g1 X1\r\nN20 M30  *  rest \n x\r\n\n";
    assert_eq!(text("a.nc", before), "zak. 12\n  part %1\r\nN10 G01 X1\r\nN20 M30 *  rest \n x\r\n\n");
    let dos = b"%1\r\nN10 G0 \"p\xfd\xa1ruba\"  X1\nN20 M30\r\n";
    let expected = b"%1\r\nN10 G00 \"p\xfd\xa1ruba\" X1\r\nN20 M30\r\n";
    assert_eq!(formatted("a.nc", dos, &settings(Dialect::Cnc872)).unwrap(), expected);
}

/// FMT-2: a block begins a line, one blank between words, none within; `%` with its comments is a line.
#[test]
fn blocks_and_words() {
    let before = "% 1\"t\" \"u\" N10G1X 1Y2\"c\"N20 R1 = 5 R2 6 m30*";
    assert_eq!(text("a.nc", before), "%1 \"t\" \"u\"\r\nN10 G01 X1 Y2 \"c\"\r\nN20 R1=5 R2 6 M30 *");
    assert_eq!(text("a.nc", "%1\nN10 / G1 X5\nN20 M30\n*\n"), "%1\nN10 / G01 X5\nN20 M30\n*\n");
}

/// FMT-3: line ends within a block stay, the lines they begin are indented; long lines are broken.
#[test]
fn lines_of_a_block() {
    let table = "%1\nN10 R1=1\n      R2=2\n\n\"c\" R3=3\nN20 M30\n";
    assert_eq!(text("a.nc", table), "%1\nN10 R1=1\n  R2=2\n\n  \"c\" R3=3\nN20 M30\n");
    let words = "G1 X1111.111 Y2222.222 Z3333.333 A44.444 B55.555 C66.666 F100 S1000 T12 M3";
    let long = format!("%1\nN10 G0\nN20 {words} M8\nN30 M30\n");
    let broken = "%1\nN10 G00\nN20 G01 X1111.111 Y2222.222 Z3333.333 A44.444 B55.555 C66.666 F100 S1000 T12 M03\n  M08\nN30 M30\n";
    assert_eq!(text("a.nc", &long), broken);
    let comment = "\"drazka pro pero 8P9, kontrolovat kalibrem po kazdem kusu\"";
    let beside = |first: &str| format!("%1\n{first}N20 G1 X1111.111 Y2222.222 {comment}\nN30 M30\n");
    let apart = format!("%1\nN10 G00\n{comment}\nN20 G01 X1111.111 Y2222.222\nN30 M30\n");
    assert_eq!(text("a.nc", &beside("N10 G0\n")), apart);
    // In the first block it would become the program's.
    let along = format!("%1\nN20 G01 X1111.111\n  Y2222.222 {comment}\nN30 M30\n");
    assert_eq!(text("a.nc", &beside("")), along);
}

/// FMT-3: no line gets longer than 80 characters: where it would, the block stays.
#[test]
fn no_line_grows() {
    let full = format!("N10\"{}\"", "x".repeat(75));
    assert_eq!(full.len(), 80);
    let before = format!("%1\n{full}\nN20 g1 X1\nN30 M30\n");
    assert_eq!(text("a.nc", &before), format!("%1\n{full}\nN20 G01 X1\nN30 M30\n"));
}

/// FMT-4: comments on lines of their own, open comments, empty lines, the end of the file.
#[test]
fn comments_and_empty_lines() {
    let before = "%1\n\n\n   \"own line   \n \t\nN10 G00 \"open \t\n\n\n\nN20 M30";
    assert_eq!(text("a.nc", before), "%1\n\n\"own line\n\nN10 G00 \"open\n\nN20 M30\n");
    let macrocycle = "\n\n \"title\"\n\nN1 G79 L5\nN2 G70\n\n\n";
    assert_eq!(text("L5", macrocycle), "\"title\"\nN1 G79 L5\nN2 G70\n");
    assert_eq!(text("a.nc", "%1\nN10 M30\n\u{1a}\0\n"), "%1\nN10 M30\n\u{1a}\0\n");
}

/// FMT-6: what cannot be read stays byte for byte, and so do the blocks that it cuts.
#[test]
fn what_cannot_be_read_stays() {
    let before = "%1\nn10  x1\nN20 X- 5\n  y7\nN30  g1 N40  ?\n  x5\nN50  m30\n";
    assert_eq!(text("a.nc", before), "%1\nN10 X1\nN20 X- 5\n  y7\nN30  g1 N40  ?\n  x5\nN50 M30\n");
    let settings = settings(Dialect::Cnc872);
    let utf16: Vec<u8> = "\u{feff}%1\nN10 M30\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(formatted("a.nc", &utf16, &settings), None);
}

/// FMT-5: how numbers are written.
#[test]
fn styles() {
    let mut settings = settings(Dialect::Cnc872);
    (settings.format.codes, settings.format.numbers) = (cnc872c::config::Codes::Short, cnc872c::config::Numbers::Short);
    (settings.format.indent, settings.format.blank_lines) = (4, 0);
    let before = b"%1\n\nN10 G01 X036.120 Y.5 Z36. F0100\n Q5 S0100 R01=-00.50 A-0\nN20 M30\n";
    let after = "%1\nN10 G1 X36.12 Y0.5 Z36 F100\n    Q5 S0100 R01=-0.5 A-0\nN20 M30\n";
    assert_eq!(String::from_utf8(formatted("a.nc", before, &settings).unwrap()).unwrap(), after);
}
