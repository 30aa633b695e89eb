//! Programs of other controls, as shops and CAM systems write them: few findings, and the first says what is the
//! matter. Programs for this control are never taken for such.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use cnc872c::diag::Code;
use cnc872c::diag::explain::examples;
use cnc872c::dict::Lang;
use cnc872c::syntax::{foreign, is_suspicious};
use cnc872c::text::{Encoding, MemoryLoader, SourceText};

use crate::disk::TestDisk;
use crate::disk::files;
use crate::markers::Request;
use crate::run::{Run, run};
use crate::samples::root;

/// Programs of which it cannot be told, and why.
const UNTOLD: [(&str, &str); 2] = [
    ("fanuc/plain-iso.nc", "numbered blocks of G0, G1, S and M: with `%1` it would be a program for this control"),
    ("sinumerik/plain-din.MPF", "the same"),
];

/// Findings of a line, at most, over a program.
const MOST: f64 = 2.0;

/// The folders, and what the first finding calls the controls.
const CONTROLS: [(&str, &str); 4] =
    [("fanuc", "Fanuc"), ("linuxcnc", "LinuxCNC"), ("sinumerik", "Sinumerik"), ("heidenhain", "Heidenhain")];

fn folder() -> PathBuf {
    root().join("tests/data/dialects")
}

/// The programs, as `fanuc/thread-m24.nc`.
fn programs() -> Vec<String> {
    let name = |path: PathBuf| path.strip_prefix(folder()).unwrap().to_str().unwrap().replace('\\', "/");
    files(&folder()).into_iter().map(name).collect()
}

fn check(name: &str) -> Run {
    run(&TestDisk { root: folder() }, name, &Request::default())
}

/// Lines that are not empty.
fn line_count(bytes: &[u8]) -> usize {
    bytes.split(|byte| *byte == b'\n').filter(|line| !line.trim_ascii().is_empty()).count()
}

#[test]
fn programs_of_other_controls() {
    let mut table = format!("{:<36}{:>6}{:>10}  first\n", "program", "lines", "findings");
    let mut wrong = Vec::new();
    let mut count: BTreeMap<String, usize> = BTreeMap::new();
    for name in programs() {
        let (control, _) = name.split_once('/').unwrap();
        *count.entry(control.to_owned()).or_default() += 1;
        let lines = line_count(&fs::read(folder().join(&name)).unwrap());
        let found = check(&name);
        let findings = found.report.errors() + found.report.warnings();
        let first = found.report.items().next().map(|item| item.diagnostic.finding.clone()).unwrap();
        let message = first.message(Lang::En);
        let told = first.code() == Code::W0113;
        writeln!(table, "{name:<36}{lines:>6}{findings:>10}  {}: {message}", first.code()).unwrap();
        #[expect(clippy::cast_precision_loss, reason = "small numbers")]
        if findings as f64 / lines as f64 >= MOST {
            wrong.push(format!("{name}: {findings} findings in {lines} lines"));
        }
        let untold = UNTOLD.iter().any(|(untold, _)| *untold == name);
        if told == untold {
            wrong.push(format!("{name}: the first finding is {}", first.code()));
        }
        let named = CONTROLS.iter().filter(|(_, text)| message.contains(text)).count();
        let (_, right) = CONTROLS.iter().find(|(folder, _)| *folder == control).unwrap();
        if told && !(named >= 1 && message.contains(right)) {
            wrong.push(format!("{name}: {message}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(CONTROLS.iter().all(|(control, _)| count.get(*control).is_some_and(|count| *count >= 25)), "{count:?}");
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("dialects", table));
}

/// With its whole text behind a readable `%1`, as somebody makes it who was told that `%` is missing, a program of
/// another control gives no flood either.
#[test]
fn with_a_program_number() {
    let mut wrong = Vec::new();
    for name in programs() {
        let text = SourceText::decode("", fs::read(folder().join(&name)).unwrap(), Encoding::Windows1250).unwrap();
        let text = format!("%1\n{}", text.text().trim_start_matches("%\n").trim_start_matches("%\r\n"));
        let loader = MemoryLoader::new().with("program.nc", text.as_bytes());
        let found = run(&loader, "program.nc", &Request::default());
        let (findings, lines) = (found.report.errors() + found.report.warnings(), line_count(text.as_bytes()));
        if findings >= 2 * lines {
            wrong.push(format!("{name}: {findings} findings in {lines} lines"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A long program of another control has findings beyond the bound: they are counted by lines too.
#[test]
fn long_programs() {
    let lines = 40_000;
    let text = format!("%\nO0001\n{}M30\n%\n", "G1 X#1 Y#2 Z-0.5 F100\n".repeat(lines));
    let loader = MemoryLoader::new().with("program.nc", text.as_bytes());
    let found = run(&loader, "program.nc", &Request::default());
    assert_eq!(found.codes()[0], Code::W0113);
    let findings = found.report.errors() + found.report.warnings();
    assert!((lines..lines + 10).contains(&findings), "{findings}");
}

/// Without the finding all others are there.
#[test]
fn allowed() {
    let mut request = Request::default();
    crate::markers::options(&mut request.overrides, "-A other-control");
    let disk = TestDisk { root: folder() };
    let found = run(&disk, "fanuc/drilling-plate.nc", &request);
    assert_eq!(found.codes().iter().filter(|code| **code == Code::E0203).count(), 1);
    assert!(found.report.errors() >= 8, "{}", found.report.errors());
    assert!(!found.codes().contains(&Code::W0113));
}

/// No false alarm: no sample is taken for a program of another control, even when nothing of it were wrong, and in
/// valid ones not a single sign of one is seen.
#[test]
fn own_programs() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for path in files(&root().join("samples")) {
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.extension().is_some_and(|extension| ["md", "toml", "xml"].iter().any(|other| *other == extension)) {
            continue;
        }
        count += 1;
        let source = SourceText::decode("", fs::read(&path).unwrap(), Encoding::Cp852).unwrap();
        let start = source.text().find('%').map_or(0, |start| u32::try_from(start).unwrap());
        let of_another = foreign(source.text(), start).is_some();
        let valid = path.starts_with(root().join("samples/ok")) || path.starts_with(root().join("samples/projects"));
        let sign = valid && is_suspicious(&source.text()[start as usize..]);
        let shows_it = name.starts_with("W0113")
            || name.ends_with("-foreign.nc")
            || name != "says.txt" && path.parent().is_some_and(|folder| folder.ends_with("FMT-6-other-control"));
        if of_another != shows_it || sign {
            wrong.push(path);
        }
    }
    assert!(count > 300 && wrong.is_empty(), "{count}: {wrong:?}");
}

/// The same for the programs on the pages of the findings.
#[test]
fn programs_on_pages() {
    for &code in Code::ALL {
        let programs = examples(code.page(Lang::En)).into_iter().filter(|example| example.file_name().is_none());
        for example in programs.filter(|_| code != Code::W0113) {
            assert!(foreign(&example.text, 0).is_none(), "{code}: {}", example.text);
        }
    }
}

/// Slips in programs for this control, a few of them in one.
#[test]
fn slips() {
    for text in [
        "%1 \"DESKA\"\nN10 G21 G90 G43 H1\nN20 G0 X#1 (najezd)\nN30 M30",
        "%1\nN10 O1000\nN20 G0 X0\nN30 M30",
        "%1\nN10 G0 X0 Y0 ;start\nN20 G2 X5 R10.\nN30 M30",
        "%1\nN10 G28 U0 W0\nN20 G1 X=5\nN30 M30",
        "%1\nG0 X0 Y0\nG1 X5\nM30",
        "%\nN10 G0 X0 (stul)\nN20 G49\nN30 M30",
        "N10 G0 X0 (stul)\nN20 G49\nN30 G43\nN40 M30",
        "%7\nN10 G0 X0 LOOP\nN20 R10=R1+5\nN30 G73 L10\nN40 M30",
    ] {
        assert!(foreign(text, 0).is_none(), "{text}");
    }
}
