//! The commands as a user runs them, on large programs: time of the whole process, and its memory where the system
//! tells.
//!
//! ```text
//! cargo bench --bench commands            # all rows but the gigabyte
//! cargo bench --bench commands -- big     # with it: 1 GB of disk, 3 GB of memory
//! ```
//!
//! Every row is run several times, the commands in turn; the least time and the median are shown.
#![expect(clippy::disallowed_methods, clippy::print_stdout, reason = "a benchmark writes files and prints")]
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing)]

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use cnc872c::config::Settings;
use cnc872c::session::Session;
use cnc872c::text::MemoryLoader;

#[path = "../examples/generate.rs"]
#[expect(dead_code, reason = "the example's command line is not used here")]
mod generate;

/// The program that is measured.
const CNC872C: &str = env!("CARGO_BIN_EXE_cnc872c");

const MILLION: u32 = 1_000_000;

/// More than any of the programs executes.
const MOST_BLOCKS: u64 = 100_000_000;

/// Programs in the folder that is checked, and the blocks of each.
const FOLDER: (u32, u32) = (2_000, 500);

/// A command, what it has to do, and what that took.
struct Row {
    name: &'static str,
    arguments: Vec<String>,
    /// One thread only.
    alone: bool,
    /// Executed blocks.
    blocks: u64,
    bytes: u64,
    runs: usize,
    times: Vec<Duration>,
    memory_kb: u64,
}

fn main() {
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let big = std::env::args().any(|argument| argument == "big");
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name);
    let write = |name: &str, program: &dyn Fn(&mut BufWriter<File>) -> io::Result<()>| {
        fs::create_dir_all(file(name).parent().unwrap()).unwrap();
        let mut out = BufWriter::new(File::create(file(name)).unwrap());
        program(&mut out).and_then(|()| out.flush()).unwrap();
        out.into_inner().unwrap()
    };
    // Pending writes of the system would be timed with the programs.
    let write_through = |name: &str, program: &dyn Fn(&mut BufWriter<File>) -> io::Result<()>| {
        write(name, program).sync_all().unwrap();
    };
    write_through("cam.nc", &|out| generate::cam(out, MILLION));
    write_through("arcs.nc", &|out| generate::arcs(out, 200_000));
    write_through("rich.nc", &|out| generate::rich(out, 300_000));
    write_through("loose.nc", &|out| loose(out, MILLION));
    write_through("loops.nc", &|out| generate::loops(out));
    write_through("start.nc", &|out| generate::cam(out, 20));
    for program in 0..FOLDER.0 {
        write(&format!("folder/part{program:04}.nc"), &|out| generate::cam(out, FOLDER.1));
    }
    let (stream, wave) = (file("cam.jsonl"), file("cam.vcd"));
    let config = |name: &str, text: &str| {
        fs::write(file(name), text).unwrap();
        shown(&file(name))
    };
    let linear = config("linear.toml", "[motion]\n");
    let parabolic = config("parabolic.toml", "[motion]\nprofile = \"parabolic\"\n[motion.sets.1]\nparabolic = 50000\n");
    let row = |name, arguments: &[&str], path: &str, runs| Row {
        name,
        arguments: arguments.iter().map(|&argument| argument.to_owned()).chain([shown(&file(path))]).collect(),
        alone: false,
        blocks: executed(&file(path)),
        bytes: bytes(&file(path)),
        runs,
        times: Vec::new(),
        memory_kb: 0,
    };
    let mut rows = vec![
        row("check cam", &["check"], "cam.nc", 9),
        row("compile cam to a file", &["compile", "-o", &shown(&stream)], "cam.nc", 5),
        row("plc cam as VCD to a file", &["plc", "--format", "vcd", "-o", &shown(&wave)], "cam.nc", 9),
        row("motion cam", &["motion", "--config", &linear], "cam.nc", 5),
        row("motion cam, parabolic", &["motion", "--config", &parabolic], "cam.nc", 5),
        row("view cam, page", &["view", "-o", &shown(&file("cam.html"))], "cam.nc", 5),
        row("view cam, SVG", &["view", "-o", &shown(&file("cam.svg"))], "cam.nc", 5),
        row("view cam, PNG", &["view", "-o", &shown(&file("cam.png"))], "cam.nc", 5),
        row("check arcs", &["check"], "arcs.nc", 5),
        row("check rich", &["check"], "rich.nc", 5),
        row("compile loops", &["compile"], "loops.nc", 3),
        row("check loose", &["check"], "loose.nc", 5),
        row("format loose, --check", &["format", "--check"], "loose.nc", 5),
        row("format cam, --check", &["format", "--check"], "cam.nc", 5),
        row("check 2,000 programs", &["check"], "folder", 5),
        Row { alone: true, ..row("check 2,000 programs, one thread", &["check"], "folder", 5) },
        row("check 20 blocks", &["check"], "start.nc", 50),
    ];
    if big {
        write_through("big.nc", &|out| generate::cam(out, 30 * MILLION));
        rows.push(row("compile cam", &["compile"], "cam.nc", 5));
        rows.push(row("compile big", &["compile", "--max-blocks", &MOST_BLOCKS.to_string()], "big.nc", 2));
    }
    for round in 0..rows.iter().map(|row| row.runs).max().unwrap_or(0) {
        for row in rows.iter_mut().filter(|row| round < row.runs) {
            row.run();
        }
    }
    println!("{:<34} {:>9} {:>9} {:>10} {:>12} {:>9}", "", "least", "median", "MB/s", "blocks/s", "memory");
    for row in &mut rows {
        row.show();
    }
}

fn shown(path: &Path) -> String {
    path.to_str().unwrap().to_owned()
}

/// Size of a file, or of the files in a folder.
fn bytes(path: &Path) -> u64 {
    if path.is_dir() {
        return fs::read_dir(path).unwrap().map(|entry| entry.unwrap().metadata().unwrap().len()).sum();
    }
    path.metadata().unwrap().len()
}

/// Milling in which formatting changes every block.
fn loose(out: &mut impl Write, blocks: u32) -> io::Result<()> {
    write!(out, "%1\r\nN1 G54 G17 G90 G94 G40\r\nN2 G0 X0 Y0 Z5 S1000 M3\r\nN3 G1 Z-1 F800\r\n")?;
    for number in 4..blocks {
        let (x, y) = (number % 200, number % 77);
        write!(out, "N{number}  G1X{x}.{:03}  Y{y}.5Z-1\r\n", number % 1000)?;
    }
    write!(out, "N{blocks} M30\r\n")
}

/// How many blocks the programs execute: those in a folder, or one.
fn executed(path: &Path) -> u64 {
    if path.is_dir() {
        return fs::read_dir(path).unwrap().map(|entry| executed(&entry.unwrap().path())).sum();
    }
    let loader = MemoryLoader::new().with("bench.nc", fs::read(path).unwrap());
    let mut settings = Settings::default();
    settings.machine.limits.records = MOST_BLOCKS;
    let session = Session { loader: &loader, settings: &settings, progress: None };
    let outcome = session.check(Path::new("bench.nc"), "bench.nc");
    assert!(outcome.findings.is_empty(), "{} has findings", path.display());
    outcome.executed
}

impl Row {
    fn run(&mut self) {
        let mut command = Command::new(CNC872C);
        command.args(&self.arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        if self.alone {
            command.env("RAYON_NUM_THREADS", "1");
        }
        let begin = Instant::now();
        let mut child = command.spawn().unwrap();
        self.memory_kb = self.memory_kb.max(watch(&mut child));
        self.times.push(begin.elapsed());
        // 1: there is something to format.
        assert!(child.wait().unwrap().code().is_some_and(|code| code < 2), "{} failed", self.name);
    }

    fn show(&mut self) {
        self.times.sort_unstable();
        let (least, median) = (self.times[0], self.times[self.times.len() / 2]);
        let rate = |count: u64| count as f64 / median.as_secs_f64() / 1e6;
        println!(
            "{:<34} {:>7.1}ms {:>7.1}ms {:>10.1} {:>11.2}M {:>6}MB",
            self.name,
            least.as_secs_f64() * 1e3,
            median.as_secs_f64() * 1e3,
            rate(self.bytes),
            rate(self.blocks),
            self.memory_kb / 1000,
        );
    }
}

/// Waits for the end of a process; gives the most memory that it held, in kB, where the system tells.
fn watch(child: &mut Child) -> u64 {
    let status = format!("/proc/{}/status", child.id());
    let mut most = 0;
    while child.try_wait().unwrap().is_none() {
        let text = fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap_or_default();
        most = most.max(line.trim().trim_end_matches(" kB").parse().unwrap_or(0));
        std::thread::sleep(Duration::from_micros(500));
    }
    most
}
