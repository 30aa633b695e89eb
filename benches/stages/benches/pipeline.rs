//! How fast the stages are, on the programs of `examples/generate.rs`, in bytes or blocks a second. Compare ratios:
//! machines differ, and the same one differs from hour to hour.
#![allow(missing_docs, reason = "criterion's macros make items without docs")]
#![expect(clippy::expect_used, reason = "a benchmark that cannot run has nothing to say")]

use std::hint::black_box;
use std::io;
use std::path::Path;
use std::sync::Arc;

use cnc872c::analysis::Totals;
use cnc872c::config::Settings;
use cnc872c::diag::Findings;
use cnc872c::resolve::{Library, resolve};
use cnc872c::run::{Interpreter, Program};
use cnc872c::session::{Part, Session};
use cnc872c::syntax::{Form, parse, tokens};
use cnc872c::text::{FileId, MemoryLoader, SourceText, Sources};
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};

#[path = "../../../examples/generate.rs"]
#[expect(dead_code, reason = "the example's command line is not used here")]
mod generate;

/// Blocks of the programs that can have any number of them: a tenth of a large file.
const BLOCKS: u32 = 100_000;

/// The name of every program in memory.
const NAME: &str = "bench.nc";

fn program(write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>) -> Vec<u8> {
    let mut text = Vec::new();
    write(&mut text).expect("memory");
    text
}

/// Runs `check` or `compile` on one program; gives the number of executed blocks.
fn run(loader: &MemoryLoader, compile: bool) -> u64 {
    let settings = Settings::default();
    let session = Session { loader, settings: &settings, progress: None };
    let path = Path::new(NAME);
    let outcome = if compile {
        session.compile(path, NAME, Part::default(), &mut io::sink()).expect("a sink").outcome
    } else {
        session.check(path, NAME)
    };
    assert!(outcome.findings.is_empty(), "the program has findings");
    outcome.executed
}

fn whole(group: &mut BenchmarkGroup<'_, criterion::measurement::WallTime>, name: &str, text: Vec<u8>) {
    let loader = MemoryLoader::new().with(NAME, text);
    group.throughput(Throughput::Elements(run(&loader, false)));
    group.bench_function(format!("check {name}"), |bencher| bencher.iter(|| run(&loader, false)));
    group.bench_function(format!("compile {name}"), |bencher| bencher.iter(|| run(&loader, true)));
}

/// `check` and `compile` of whole programs, in executed blocks a second.
fn programs(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("blocks");
    group.sample_size(10);
    whole(&mut group, "cam", program(|out| generate::cam(out, BLOCKS)));
    whole(&mut group, "arcs", program(|out| generate::arcs(out, BLOCKS)));
    whole(&mut group, "rich", program(|out| generate::rich(out, BLOCKS)));
    group.finish();
}

/// Execution alone, in executed blocks a second: as in `check`, where nobody reads, and with the lengths of all
/// motions.
fn expansion(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("expansion");
    group.sample_size(10);
    for (name, text) in [
        ("cam", program(|out| generate::cam(out, BLOCKS))),
        ("arcs", program(|out| generate::arcs(out, BLOCKS))),
        ("rich", program(|out| generate::rich(out, BLOCKS))),
        ("loops", program(generate::loops)),
    ] {
        let settings = Settings::default();
        let loader = MemoryLoader::new();
        let source = Arc::new(SourceText::from_text(NAME, String::from_utf8(text).expect("UTF-8")));
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let mut library = Library::new(&loader, &settings.macrocycles, Path::new(NAME));
        let resolved = resolve(&source, None, &settings, &mut library, &mut sources, &mut findings);
        let mut program = Program { resolved, settings: &settings, library, sources };
        let mut execute = |totals: Option<&mut Totals>| {
            let mut interpreter = Interpreter::new(&program);
            let mut read = Totals::new();
            while let Some(block) = interpreter.step(&mut program, &mut findings) {
                if totals.is_some() {
                    read.add(&block);
                } else {
                    black_box(block.seq());
                }
            }
            if let Some(totals) = totals {
                *totals = read;
            }
            interpreter.executed()
        };
        group.throughput(Throughput::Elements(execute(None)));
        group.bench_function(format!("{name}, not read"), |bencher| bencher.iter(|| execute(None)));
        group.bench_function(format!("{name}, lengths"), |bencher| {
            bencher.iter(|| execute(Some(&mut black_box(Totals::new()))));
        });
    }
    group.finish();
}

/// Reading alone, in bytes a second: blocks of cam are plain, of rich most are not.
fn stages(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("bytes");
    for (name, text) in
        [("cam", program(|out| generate::cam(out, BLOCKS))), ("rich", program(|out| generate::rich(out, BLOCKS)))]
    {
        let source = Arc::new(SourceText::from_text(NAME, String::from_utf8(text).expect("UTF-8")));
        group.throughput(Throughput::Bytes(u64::from(source.len())));
        group.bench_function(format!("lex {name}"), |bencher| {
            bencher.iter(|| tokens(black_box(source.text()), 0, source.len()).count());
        });
        group.bench_function(format!("parse {name}"), |bencher| {
            bencher.iter(|| parse(FileId(0), &source, Form::Program, &mut Findings::new()).block_count());
        });
    }
    group.finish();
}

criterion_group!(benches, programs, stages, expansion);
criterion_main!(benches);
