//! The core alone, as other programs use it: `cargo test --no-default-features --test core`. With the other features it
//! gives the same.
#![expect(clippy::disallowed_methods, reason = "tests read files")]
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

use std::fs;
use std::path::{Path, PathBuf};

use cnc872c::config::Settings;
use cnc872c::diag::{Format, Report, Shown, render};
use cnc872c::disk::DiskLoader;
use cnc872c::session::{Part, Session};
use cnc872c::text::MemoryLoader;

#[path = "../examples/library.rs"]
#[expect(dead_code, reason = "the example prints and checks itself")]
mod example;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// `compile` without threads gives the streams that the snapshots hold: of each its first lines and the last.
#[test]
fn streams() {
    let settings = Settings::default();
    let mut compiled = 0;
    for entry in fs::read_dir(folder("samples/ok")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        let loader = DiskLoader::default();
        let session = Session { loader: &loader, settings: &settings, progress: None };
        let mut out = Vec::new();
        let run = session.compile(&path, name, Part::default(), &mut out).unwrap();
        assert!(run.whole.is_some(), "{name}");
        let version = concat!("cnc872c ", env!("CARGO_PKG_VERSION"));
        let out = String::from_utf8(out).unwrap().replacen(version, "cnc872c [version]", 1);
        let snapshot = folder("snapshots/streams").join(name).with_extension("snap");
        let snapshot = fs::read_to_string(snapshot).unwrap();
        let mut lines = out.lines();
        for expected in snapshot.lines().filter(|line| line.starts_with('{')) {
            assert!(lines.any(|line| line == expected), "{name}: no line {expected}");
        }
        assert_eq!(lines.next(), None, "{name}: lines after those of the snapshot");
        compiled += 1;
    }
    assert!(compiled >= 10);
}

/// More than a megabyte.
const BLOCKS: u32 = 60_000;

/// A program of many blocks, which the full program reads and checks in pieces.
#[test]
fn a_long_program() {
    let blocks: String = (1..=BLOCKS).map(|n| format!("N{n} G01 X{} F200\n", n % 100)).collect();
    let loader = MemoryLoader::new().with("long.nc", format!("%1\n{blocks}N{} M30\n", BLOCKS + 1));
    let settings = Settings::default();
    let session = Session { loader: &loader, settings: &settings, progress: None };
    let outcome = session.check(Path::new("long.nc"), "long.nc");
    assert_eq!((outcome.executed, outcome.findings.has_errors()), (u64::from(BLOCKS) + 1, false));
    let mut out = Vec::new();
    let last = Part { from: u64::from(BLOCKS) - 1, limit: None };
    assert!(session.compile(Path::new("long.nc"), "long.nc", last, &mut out).unwrap().whole.is_some());
    // The program, two blocks, the end.
    assert_eq!(out.iter().filter(|byte| **byte == b'\n').count(), 4);
}

/// Findings in the forms for programs.
#[test]
fn findings() {
    let loader = MemoryLoader::new().with("part.nc", "%1\nN10 G90 G0 X10 X20\nN20 M30\n");
    let settings = Settings::default();
    let session = Session { loader: &loader, settings: &settings, progress: None };
    let outcome = session.check(Path::new("part.nc"), "part.nc");
    let mut report = Report::new();
    report.add_program(&outcome.sources, outcome.findings);
    for format in [Format::Short, Format::Json, Format::Sarif, Format::Github] {
        let mut out = Vec::new();
        render(format, &report, Shown::default(), &mut out).unwrap();
        assert!(String::from_utf8(out).unwrap().contains("E0306"), "{format:?}");
    }
}

#[test]
fn the_example() {
    example::run().unwrap();
}
