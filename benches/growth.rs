//! How time grows with the input: a table for each kind of input, with the time of one unit of it at each size. Work
//! that grows as its input does has the same time in a whole row.
//!
//! ```text
//! cargo bench --bench growth             # all sizes: half an hour, 2 GB of disk, 3 GB of memory
//! cargo bench --bench growth -- small    # without the two largest sizes
//! cargo bench --bench growth -- LINES    # one table: BLOCKS, FILES, LINES, FINDINGS, FIXES, DOCUMENTS
//! ```
//!
//! Times are the least of several runs of the whole process, less the least time of one that has nothing to do. So at
//! the smallest sizes they are coarse.
#![expect(clippy::disallowed_methods, clippy::print_stdout, reason = "a benchmark writes files and prints")]
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use client::Client;
use serde_json::{Value, json};

#[path = "../tests/it/lsp/client.rs"]
#[allow(dead_code, reason = "tests need more of it")]
mod client;
#[path = "../examples/generate.rs"]
#[expect(dead_code, reason = "the example's command line is not used here")]
mod generate;

/// The program that is measured.
const CNC872C: &str = env!("CARGO_BIN_EXE_cnc872c");

/// A process is run again until so much time is spent on it, and this often at least and at most.
const SPENT: Duration = Duration::from_millis(1500);
const LEAST_RUNS: usize = 2;
const MOST_RUNS: usize = 40;

/// A measured thing, and its place.
struct Bench {
    folder: tempfile::TempDir,
    /// Leaves the largest sizes out.
    small: bool,
    /// Of a process that has nothing to do.
    start: Duration,
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if arguments.iter().any(|argument| argument == "--test") {
        return;
    }
    let tables = ["BLOCKS", "FILES", "LINES", "FINDINGS", "FIXES", "DOCUMENTS"];
    let named = arguments.iter().any(|argument| tables.contains(&argument.as_str()));
    let wants = |table: &str| !named || arguments.iter().any(|argument| argument == table);
    let mut bench = Bench {
        folder: tempfile::tempdir().unwrap(),
        small: arguments.iter().any(|argument| argument == "small"),
        start: Duration::ZERO,
    };
    let nothing = bench.file("nothing.nc", "%1\nN10 M30\n");
    bench.start = bench.time(&["check"], &nothing, &|| {});
    println!("start and end of a process: {:.2} ms", bench.start.as_secs_f64() * 1e3);
    for (table, measure) in tables.into_iter().zip([blocks, files, lines, findings, fixes, documents]) {
        if wants(table) {
            measure(&bench);
        }
    }
}

impl Bench {
    fn file(&self, name: &str, text: &str) -> PathBuf {
        let path = self.folder.path().join(name);
        fs::write(&path, text).unwrap();
        path
    }

    /// The least time of a command.
    fn time(&self, arguments: &[&str], path: &Path, before: &dyn Fn()) -> Duration {
        let (mut least, mut spent) = (Duration::MAX, Duration::ZERO);
        for run in 0..MOST_RUNS {
            if run >= LEAST_RUNS && spent > SPENT {
                break;
            }
            before();
            let mut command = Command::new(CNC872C);
            command.args(arguments).arg(path).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
            let begun = Instant::now();
            let status = command.status().unwrap();
            let time = begun.elapsed();
            assert!(matches!(status.code(), Some(0 | 1)), "{arguments:?} {}", path.display());
            (least, spent) = (least.min(time), spent + time);
        }
        least.saturating_sub(self.start)
    }

    /// The sizes from one power of ten to another.
    fn sizes(&self, from: u32, to: u32) -> Vec<usize> {
        let to = if self.small { to - 2 } else { to };
        (from..=to).map(|power| 10_usize.pow(power)).collect()
    }
}

/// Prints the head of a table.
fn head(what: &str, sizes: &[usize]) {
    println!("\n{what}\n");
    let sizes: Vec<String> = sizes.iter().map(|size| grouped(*size)).collect();
    println!("| | {} |", sizes.join(" | "));
    println!("|---|{}", "---|".repeat(sizes.len()));
}

fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Prints a row: the time of one unit.
fn row(name: &str, times: impl Iterator<Item = (usize, Duration)>) {
    print!("| {name} |");
    for (count, time) in times {
        let nanoseconds = time.as_secs_f64() * 1e9 / count as f64;
        let shown = match nanoseconds {
            unit if unit < 10.0 => format!("{unit:.1} ns"),
            unit if unit < 1e4 => format!("{unit:.0} ns"),
            unit => format!("{:.0} µs", unit / 1e3),
        };
        print!(" {shown} |");
        std::io::stdout().flush().unwrap();
    }
    println!();
}

fn blocks(bench: &Bench) {
    let sizes = bench.sizes(3, 7);
    let linear = bench.file("linear.toml", "[motion]\n");
    let parabolic =
        bench.file("parabolic.toml", "[motion]\nprofile = \"parabolic\"\n[motion.sets.1]\nparabolic = 50000\n");
    let path = |count: usize| bench.folder.path().join(format!("cam{count}.nc"));
    for &count in &sizes {
        let mut out = BufWriter::new(File::create(path(count)).unwrap());
        generate::cam(&mut out, u32::try_from(count).unwrap()).and_then(|()| out.flush()).unwrap();
    }
    head("Per block of a program", &sizes);
    let (linear, parabolic) = (linear.to_str().unwrap(), parabolic.to_str().unwrap());
    let most = ["--max-blocks", "100000000"];
    for (name, arguments) in [
        ("`check`", vec!["check"]),
        ("`compile`", vec!["compile"]),
        ("`motion`, linear", vec!["motion", "--config", linear]),
        ("`motion`, parabolic", vec!["motion", "--config", parabolic]),
        ("`motion --format json`", vec!["motion", "--config", linear, "--format", "json"]),
        ("`plc --format vcd`", vec!["plc", "--format", "vcd"]),
    ] {
        let arguments = [arguments, most.to_vec()].concat();
        row(name, sizes.iter().map(|&count| (count, bench.time(&arguments, &path(count), &|| {}))));
    }
    for count in sizes {
        fs::remove_file(path(count)).unwrap();
    }
}

fn files(bench: &Bench) {
    let sizes = bench.sizes(2, 5);
    let mut program = Vec::new();
    generate::cam(&mut program, 20).unwrap();
    let folders: Vec<(usize, PathBuf)> = sizes
        .iter()
        .map(|&count| {
            let folder = bench.folder.path().join(format!("folder{count}"));
            fs::create_dir(&folder).unwrap();
            for file in 0..count {
                fs::write(folder.join(format!("part{file:06}.nc")), &program).unwrap();
            }
            (count, folder)
        })
        .collect();
    head("Per file of 20 blocks in a folder", &sizes);
    row("`check`", folders.iter().map(|(count, folder)| (*count, bench.time(&["check"], folder, &|| {}))));
    row(
        "`check --format json`",
        folders.iter().map(|(count, folder)| (*count, bench.time(&["check", "--format", "json"], folder, &|| {}))),
    );
}

fn lines(bench: &Bench) {
    let sizes = bench.sizes(3, 7);
    head("Per character of one line", &sizes);
    for (name, piece) in [("`X[`", "X["), ("`(a`", "(a"), ("`\"`", "\""), ("digits", "7"), ("blanks", " ")] {
        for format in ["human", "json"] {
            let times = sizes.iter().map(|&count| {
                let line = piece.repeat(count / piece.len());
                let path = bench.file("line.nc", &format!("%1\nN10 G90 G0 X{line}\nN20 M30\n"));
                (count, bench.time(&["check", "--format", format], &path, &|| {}))
            });
            row(&format!("{name}, {format}"), times);
        }
    }
    let sizes = bench.sizes(2, 6);
    head("Per block, all in one line", &sizes);
    for block in ["X5", "X5.1.2", "X5 (a)", "g1 x5", "G73 N5", "R1=5 XR1"] {
        for command in [&["check"][..], &["check", "--format", "json"], &["check", "--fix"], &["motion"], &["plc"]] {
            let times = sizes.iter().map(|&count| {
                let text = program(count, block).replace('\n', " ").replacen(' ', "\n", 1);
                let path = bench.file("line.nc", &text);
                let write = || fs::write(&path, &text).unwrap();
                (count, bench.time(command, &path, &write))
            });
            row(&format!("`{block}`, `{}`", command.join(" ")), times);
        }
    }
}

/// A program with so many lines, each a block.
fn program(count: usize, block: &str) -> String {
    let mut text = "%1\nN1 G0 G90 X0\nN2 G1 F500\n".to_owned();
    for n in 0..count {
        let _ = writeln!(text, "N{} {block}", n + 3);
    }
    let _ = writeln!(text, "N{} M30", count + 3);
    text
}

fn findings(bench: &Bench) {
    let sizes = bench.sizes(2, 6);
    head("Per finding", &sizes);
    for format in ["human", "short", "json", "sarif", "github"] {
        for all in [false, true] {
            if all && !matches!(format, "human" | "short") {
                continue;
            }
            let arguments: &[&str] =
                if all { &["check", "--all", "--format", format] } else { &["check", "--format", format] };
            let times = sizes.iter().map(|&count| {
                let path = bench.file("faults.nc", &program(count, "X5 X6"));
                (count, bench.time(arguments, &path, &|| {}))
            });
            row(&format!("`{format}`{}", if all { ", `--all`" } else { "" }), times);
        }
    }
}

fn fixes(bench: &Bench) {
    let sizes = bench.sizes(2, 6);
    head("Per edit of `check --fix`", &sizes);
    for (name, arguments) in [("`--fix`", ["check", "--fix"]), ("`--diff`", ["check", "--diff"])] {
        let times = sizes.iter().map(|&count| {
            let text = program(count, "x5");
            let path = bench.file("fix.nc", &text);
            (count, bench.time(&arguments, &path, &|| fs::write(&path, &text).unwrap()))
        });
        row(name, times);
    }
}

/// The editor with so many documents open: what one of them waits for.
fn documents(bench: &Bench) {
    let sizes: Vec<usize> = if bench.small { vec![1, 10] } else { vec![1, 10, 100, 300] };
    head("Per open document, 1,000 blocks each", &sizes);
    let text = program(1000, "X5.5 Y6");
    let timed = |count: usize| {
        let (mut client, _) = Client::initialized(json!({ "capabilities": {} }));
        let uri = |at: usize| format!("file:///bench/part{at}.nc");
        let begun = Instant::now();
        for at in 0..count {
            let document = json!({ "uri": uri(at), "languageId": "cnc872", "version": 0, "text": text });
            client.notify("textDocument/didOpen", json!({ "textDocument": document }));
        }
        for at in 0..count {
            client.findings(&uri(at), Some(0));
        }
        let opened = begun.elapsed();
        let mut waits: Vec<Duration> = (1..=100).map(|version| change(&mut client, &uri(count / 2), version)).collect();
        waits.sort_unstable();
        (opened, waits[waits.len() / 2])
    };
    let times: Vec<(usize, (Duration, Duration))> = sizes.iter().map(|&count| (count, timed(count))).collect();
    row("opened", times.iter().map(|(count, (opened, _))| (*count, *opened)));
    row("findings after a change in one of them, in all", times.iter().map(|(_, (_, wait))| (1, *wait)));
}

/// Puts a digit into a block, or takes it out again; gives how long the findings took.
fn change(client: &mut Client, uri: &str, version: i64) -> Duration {
    let from = json!({ "line": 500, "character": 6 });
    let (to, text) = if version % 2 == 1 { (6, "9") } else { (7, "") };
    let range = json!({ "start": from, "end": { "line": 500, "character": to } });
    let changes: Value = json!([{ "range": range, "text": text }]);
    let document = json!({ "uri": uri, "version": version });
    let begun = Instant::now();
    client.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    client.findings(uri, Some(version));
    begun.elapsed()
}
