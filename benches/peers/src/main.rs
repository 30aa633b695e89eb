//! Times `check` beside other parsers of G-code, on the same words. See README.md for what each of them does.

#![forbid(unsafe_code)]

use std::hint::black_box;
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use cnc872c::config::Settings;
use cnc872c::session::Session;
use cnc872c::text::Loader;
use futures::executor::block_on;
use futures::stream;

#[path = "../../../examples/generate.rs"]
#[expect(dead_code, reason = "the example's command line is not used here")]
mod generate;

/// The name of the program in memory.
const NAME: &str = "cam.nc";

/// A timed reader: its name, and a function that gives the number of things it read.
type Timed<'a> = (&'static str, Box<dyn Fn() -> usize + 'a>);

fn main() -> ExitCode {
    let number = |at: usize, default: u32| match std::env::args().nth(at) {
        Some(text) => text.parse().ok(),
        None => Some(default),
    };
    let (Some(blocks), Some(runs)) = (number(1, 1_000_000), number(2, 7)) else {
        eprintln!("usage: peers [BLOCKS [RUNS]]");
        return ExitCode::from(2);
    };
    let mut program = Vec::new();
    if generate::cam(&mut program, blocks).is_err() {
        return ExitCode::FAILURE;
    }
    let program = String::from_utf8_lossy(&program).into_owned();
    let words = words(&program);
    let short_numbers = with_short_block_numbers(&words);
    println!("cam, {blocks} blocks, {:.1} MB, {runs} runs", program.len() as f64 / 1e6);

    let loader = InMemory::default();
    let settings = Settings::default();
    let check = || {
        let session = Session { loader: &loader, settings: &settings, progress: None };
        let outcome = session.check(Path::new(NAME), NAME);
        assert!(outcome.findings.is_empty(), "the program has findings");
        usize::try_from(outcome.executed).unwrap_or(usize::MAX)
    };
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let alone = match alone {
        Ok(pool) => pool,
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::FAILURE;
        }
    };
    let timed: [Timed<'_>; 4] = [
        ("cnc872c check", Box::new(check)),
        ("cnc872c check, one thread", Box::new(|| alone.install(check))),
        ("gcode::parse", Box::new(|| parse_with_gcode(&words))),
        ("async-gcode", Box::new(|| parse_with_async_gcode(&short_numbers))),
    ];
    let mut times: Vec<Vec<Duration>> = vec![Vec::new(); timed.len()];
    let mut read = Vec::new();
    let mut work: Vec<Vec<Duration>> = vec![Vec::new(); timed.len()];
    // In turns, so that what else the computer does meets all of them.
    for _ in 0..runs {
        for (((_, run), times), work) in timed.iter().zip(&mut times).zip(&mut work) {
            loader.put(program.as_bytes());
            let (begin, worked) = (Instant::now(), processor_time());
            read.push(black_box(run()));
            times.push(begin.elapsed());
            work.extend(processor_time().zip(worked).map(|(after, before)| after - before));
        }
    }
    let mut fastest = None;
    for ((((name, _), times), work), read) in timed.iter().zip(&mut times).zip(&work).zip(read) {
        times.sort_unstable();
        let (Some(least), Some(median)) = (times.first(), times.get(times.len() / 2)) else { continue };
        let first: Duration = *fastest.get_or_insert(*least);
        let work = work.iter().min().map_or(String::new(), |work| format!("   processors {:>5} ms", work.as_millis()));
        println!(
            "{name:<26} least {:>7.1} ms   median {:>7.1} ms   least ×{:.2}{work}   read {read}",
            least.as_secs_f64() * 1e3,
            median.as_secs_f64() * 1e3,
            least.as_secs_f64() / first.as_secs_f64(),
        );
    }
    ExitCode::SUCCESS
}

/// Hands over one text that lies in memory, once: the others do not copy theirs either.
#[derive(Default)]
struct InMemory(Mutex<Option<Vec<u8>>>);

impl InMemory {
    fn put(&self, text: &[u8]) {
        if let Ok(mut slot) = self.0.lock() {
            *slot = Some(text.to_vec());
        }
    }
}

impl Loader for InMemory {
    fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
        let taken = self.0.lock().ok().and_then(|mut slot| slot.take());
        taken.ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn list(&self, _: &Path) -> Vec<PathBuf> {
        Vec::new()
    }

    fn folders(&self, _: &Path) -> Vec<PathBuf> {
        Vec::new()
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }
}

/// How long the processors worked for this process, in steps of 10 ms: tells more than the clock where they are shared.
/// `None` where the system does not say.
fn processor_time() -> Option<Duration> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    let (_, fields) = stat.rsplit_once(')')?;
    let ticks: u64 = fields.split_whitespace().skip(11).take(2).filter_map(|field| field.parse::<u64>().ok()).sum();
    Some(Duration::from_millis(ticks * 10))
}

/// The program without what the other parsers do not know: the first line with its comment in quotes, and the `*`.
fn words(program: &str) -> String {
    program.lines().skip(1).filter(|line| *line != "*").flat_map(|line| [line, "\n"]).collect()
}

/// The same with the last four digits of each block number: `async-gcode` takes no more.
fn with_short_block_numbers(words: &str) -> String {
    let mut short = String::with_capacity(words.len());
    for line in words.lines() {
        let (number, rest) = line.split_once(' ').unwrap_or((line, ""));
        let digits = number.trim_start_matches('N');
        let kept = digits.get(digits.len().saturating_sub(4)..).unwrap_or(digits);
        short.push('N');
        short.push_str(kept);
        short.push(' ');
        short.push_str(rest);
        short.push('\n');
    }
    short
}

/// Blocks that `gcode` reads into its tree.
fn parse_with_gcode(text: &str) -> usize {
    match gcode::parse(text) {
        Ok(program) => black_box(program).blocks.len(),
        Err(diagnostics) => panic!("{diagnostics:?}"),
    }
}

/// Words and line ends that `async-gcode` gives.
fn parse_with_async_gcode(text: &str) -> usize {
    block_on(async {
        let input = stream::iter(text.bytes().map(Result::<u8, async_gcode::Error>::Ok));
        let mut parser = async_gcode::Parser::new(input);
        let mut count = 0;
        while let Some(found) = parser.next().await {
            match black_box(found) {
                Ok(_) => count += 1,
                Err(error) => panic!("{error:?}"),
            }
        }
        count
    })
}
