//! A program and up to two macrocycles, cut from the input at separators: compile, and what must hold of the stream.

#![no_main]

use std::path::Path;

use cnc872c::session::{Part, Session};
use cnc872c::text::MemoryLoader;
use cnc872c_fuzz::{Mode, PROJECT, SEPARATOR, assert_outcome};
use libfuzzer_sys::fuzz_target;
use serde_json::Value;

const FILES: [&str; 3] = ["p.nc", "L9001", "L9002.NC"];

fuzz_target!(|data: &[u8]| {
    let Some((mode, bytes)) = Mode::take(data) else { return };
    let Some((&[from, limit], bytes)) = bytes.split_first_chunk() else { return };
    let parts: Vec<&[u8]> = bytes.splitn(FILES.len(), |byte| *byte == SEPARATOR).collect();
    let files: Vec<(&str, &[u8])> = FILES.into_iter().zip(parts).collect();
    let loader = files
        .iter()
        .fold(MemoryLoader::new().with("cnc872c.toml", PROJECT), |loader, (name, text)| loader.with(name, *text));
    let settings = mode.settings(&loader);
    let session = Session { loader: &loader, settings: &settings, progress: None };
    let compile = |part| {
        let mut stream = Vec::new();
        let run = session.compile(Path::new("p.nc"), "p.nc", part, &mut stream).expect("memory takes all");
        (run, String::from_utf8(stream).expect("UTF-8"))
    };
    let (run, stream) = compile(Part::default());
    let (outcome, whole) = (run.outcome, run.whole.is_some());
    let executed = outcome.executed;
    let lengths: Vec<(&str, usize)> = files.iter().map(|(name, text)| (*name, text.len())).collect();
    let report = assert_outcome(outcome, &lengths);
    assert_eq!(whole, report.errors() == 0, "a run is whole when it has no error, and only then");
    let blocks = assert_stream(&stream, report.errors() > 0, executed);

    let part = Part { from: u64::from(from), limit: (limit != 0).then_some(u64::from(limit)) };
    let (_, shorter) = compile(part);
    let last = part.limit.map_or(u64::MAX, |limit| part.from + limit);
    let expected: Vec<&str> =
        blocks.iter().filter(|(seq, _)| (part.from..last).contains(seq)).map(|(_, line)| *line).collect();
    let written: Vec<&str> = shorter.lines().filter(|line| kind(line).1 == "block").collect();
    // Modal parts of a record are written when they change, so the first written may say more.
    assert_eq!(written.len(), expected.len());
});

fn kind(line: &str) -> (Value, String) {
    let value: Value = serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"));
    let kind = value["kind"].as_str().expect("a kind").to_owned();
    (value, kind)
}

/// The block records, by number. Lines are JSON; `program` comes first, `end` last and only without errors; a file is
/// named before its first block; numbers are consecutive.
fn assert_stream(stream: &str, errors: bool, executed: u64) -> Vec<(u64, &str)> {
    assert!(stream.is_empty() || stream.ends_with('\n'));
    let mut blocks = Vec::new();
    let (mut files, mut ended) = (1, false);
    for (index, line) in stream.lines().enumerate() {
        assert!(!ended, "{line} behind the end");
        let (value, kind) = kind(line);
        assert_eq!(index == 0, kind == "program", "{line}");
        match kind.as_str() {
            "program" => {}
            "file" => {
                assert_eq!(value["index"], files);
                files += 1;
            }
            "block" => {
                assert_eq!(value["seq"], blocks.len() as u64);
                assert!(value["file"].as_u64().unwrap_or(0) < files);
                blocks.push((blocks.len() as u64, line));
            }
            "end" => {
                assert!(!errors, "an end with errors");
                assert_eq!(value["blocks"], executed);
                assert_eq!(value["blocks"], blocks.len() as u64);
                ended = true;
            }
            other => panic!("a record {other}"),
        }
    }
    assert_eq!(ended, !errors, "errors: {errors}");
    blocks
}
