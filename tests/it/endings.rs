//! All ways in which a run may end, on the real binary: status 0, the `end` record and no error come together or not at
//! all.

use std::fmt::Write as _;

use serde_json::Value;

use crate::cli::{Place, Run};

/// A program with its other files, and the expected outcome.
struct Way {
    what: &'static str,
    files: Vec<(&'static str, String)>,
    arguments: &'static [&'static str],
    /// Exit status of `compile`; with 0 the stream has its `end`, else it has none.
    status: i32,
    /// The first error of the run.
    error: Option<&'static str>,
}

fn way(what: &'static str, program: impl Into<String>, status: i32, error: impl Into<Option<&'static str>>) -> Way {
    Way { what, files: vec![("p.nc", program.into())], arguments: &[], status, error: error.into() }
}

impl Way {
    fn with(mut self, name: &'static str, text: impl Into<String>) -> Self {
        self.files.push((name, text.into()));
        self
    }

    fn says(mut self, arguments: &'static [&'static str]) -> Self {
        self.arguments = arguments;
        self
    }
}

/// `count` blocks from N2 on that each have one finding by `body`.
fn many(count: usize, body: &str) -> String {
    let mut text = String::from("%1\nN1 G90 G0 X0 Y0 F100\n");
    for n in 2..2 + count {
        writeln!(text, "N{n} {body}").unwrap();
    }
    text
}

/// A line of more than 80 characters: E0109, on CNC872 a warning.
fn long(block: &str) -> String {
    format!("{block} \"{}\"\n", "c".repeat(80))
}

fn ways() -> Vec<Way> {
    let ok = "%1\nN1 G0 X1\nN2 M30\n";
    let comment = "c".repeat(80);
    let broken_cycle = format!("N1 G79 L9001\n{}N3 G70\n", long("N2 Z-5"));
    let cycle = "[cycles]\nG81 = 9001\n";
    let crowd = 10_001;
    vec![
        way("M30", ok, 0, None),
        way("M02", "%1\nN1 G0 X1\nN2 M02\n", 0, None),
        way("an end in a subprogram", "%1\nN1 G71 L5\nN2 M30\nN3 G79 L5\nN4 M30\nN5 G70\n", 0, None),
        way("warnings", "%1\nN1\nN2 M30\n", 0, None),
        way("a warning that is denied", "%1\nN1\nN2 M30\n", 1, "W0214").says(&["-D", "W0214"]),
        way("a warning of execution that is denied", "%1\nN1 G1 X5\nN2 M30\n", 1, "W0601").says(&["-D", "W0601"]),
        way("a denied warning of a macrocycle by parameter", "%1\nN1 R1=9001\nN2 G72 LR1\nN3 M30\n", 1, "W0214")
            .with("L9001", "N1 G79 L9001\nN2\nN3 G70\n")
            .says(&["-D", "W0214"]),
        way("an error in what is written", "%1\nN1 X1 X2\nN2 M30\n", 1, "E0306"),
        way("an error of execution", "%1\nN1 G0 X0 Y0 F100\nN2 G2 X1 Y1 I9 J9\nN3 M30\n", 1, "E0603"),
        way("no program", "", 1, "E0201"),
        way("no M30", "%1\nN1 X1\n", 1, "E0205"),
        way("a skipped end", "%1\nN1 G0 X1\nN2 / M30\n", 1, "E0205").says(&["--block-skip"]),
        way("a skipped end of a subprogram", "%1\nN1 G71 L5\nN2 M30\nN3 G79 L5\nN4 / G70\n", 1, "E0207")
            .says(&["--block-skip"]),
        way("a ring", "%1\nN1 R1=5\nN9 G71 L5\nN2 M30\nN3 G79 L5\nN4 G71 LR1\nN5 G70\n", 1, "E0408"),
        way("too many blocks", "%1\nN1 G0 X1\nN2 G73 L1 Q9\nN3 M30\n", 1, "E0410").says(&["--max-blocks", "5"]),
        way("no such subprogram", "%1\nN1 R1=7\nN9 G71 LR1\nN2 M30\n", 1, "E0404"),
        way("no such macrocycle", "%1\nN1 R1=7\nN9 G72 LR1\nN2 M30\n", 1, "E0405"),
        way("no such block", "%1\nN1 R1=7\nN9 G73 LR1\nN2 M30\n", 1, "E0406"),
        way("no value for L", "%1\nN1 G71 LR1\nN2 M30\nN3 G79 L5\nN4 G70\n", 1, "W0503"),
        way("no value for L, allowed", "%1\nN1 G71 LR1\nN2 M30\nN3 G79 L5\nN4 G70\n", 1, "W0503")
            .says(&["-A", "W0503"]),
        way("no value for an axis", "%1\nN1 G0 XR1\nN2 M30\n", 1, "W0503"),
        way("no value for Q", "%1\nN1 G0 X1\nN2 G73 L1 QR1\nN3 M30\n", 1, "W0503"),
        way("a macrocycle with an error by parameter", "%1\nN1 R1=9001\nN2 G72 LR1\nN3 M30\n", 1, "E0306")
            .with("L9001", "N1 G79 L9001\nN2 X1 X2\nN3 G70\n"),
        way("a macrocycle with an error by cycle", "%1\nN1 G81 G0 X1\nN2 M30\n", 1, "E0306")
            .with("cnc872c.toml", cycle)
            .with("L9001", "N1 G79 L9001\nN2 X1 X2\nN3 G70\n"),
        way("a long line in a macrocycle by cycle", "%1\nN1 G81 G0 X1\nN2 X2\nN3 M30\n", 0, None)
            .with("cnc872c.toml", cycle)
            .with("L9001", &broken_cycle),
        way("the same on CNC8x6", "%1\nN1 G81 G0 X1\nN2 X2\nN3 M30\n", 1, "E0109")
            .with("cnc872c.toml", cycle)
            .with("L9001", &broken_cycle)
            .says(&["--dialect", "cnc8x6"]),
        way("the same on CNC8x6, allowed", "%1\nN1 G81 G0 X1\nN2 X2\nN3 M30\n", 0, None)
            .with("cnc872c.toml", cycle)
            .with("L9001", &broken_cycle)
            .says(&["--dialect", "cnc8x6", "-A", "E0109"]),
        way("a long line in a macrocycle by parameter", "%1\nN1 R1=9001\nN2 G72 LR1\nN3 M30\n", 0, None)
            .with("L9001", &broken_cycle),
        way(
            "an error behind column 80 of a program for another control",
            format!("%1 N1 G90 G0 X0 Y0 F100\nN2 G1 {}Z-#<depth> X10\nN3 X2\nN5 M30\n", " ".repeat(80)),
            1,
            "E0103",
        ),
        way(
            "the same, E0109 allowed",
            format!("%1 N1 G90 G0 X0 Y0 F100\nN2 G1 {}Z-#<depth> X10\nN3 X2\nN5 M30\n", " ".repeat(80)),
            1,
            "E0103",
        )
        .says(&["-A", "E0109"]),
        way(
            "an error of execution behind many warnings",
            many(crowd, &format!("X1 \"{comment}\"")) + "N50000 G2 X1 Y1 I9 J9\nN50001 X5\nN50002 M30\n",
            1,
            "E0603",
        ),
        way(
            "an error behind many warnings",
            many(crowd, &format!("X1 \"{comment}\"")) + "N50000 X1 X2\nN50001 M30\n",
            1,
            "E0306",
        ),
        way(
            "an error behind many that are allowed",
            many(crowd, &format!("X1 \"{comment}\"")) + "N50000 X1 X2\nN50001 M30\n",
            1,
            "E0306",
        )
        .says(&["-A", "E0109"]),
        way(
            "a parameter without a value behind many warnings",
            many(crowd, "X0.0004") + "N50000 XR50\nN50001 M30\n",
            1,
            "W0503",
        ),
        way("the same, they are allowed", many(crowd, "X0.0004") + "N50000 XR50\nN50001 M30\n", 1, "W0503")
            .says(&["-A", "W0303"]),
        way("many errors of execution", many(crowd, "G2 X1 Y1 I9 J9") + "N50001 M30\n", 1, "E0603"),
        way("many warnings", many(crowd, "X0.0004") + "N50001 M30\n", 0, None),
        way("a fraction of a high parameter", "%1\nN1 G90 G0 R10=2147484.5\nN2 M30\n", 1, "E0302"),
        way("a fraction of the highest parameter", "%1\nN1 G90 G0 R10=-99999999.5\nN2 M30\n", 1, "E0302"),
        way("a fraction of a control word", "%1\nN1 R2=5 R4=2 G26 R5=04010203.5\nN2 M30\n", 1, "E0302")
            .with("cnc872c.toml", "[operations]\n\"04\" = \"div\"\n"),
        way("a fraction of a high feed", "%1\nN1 G1 X1 F2147484.5\nN2 M30\n", 0, None)
            .with("cnc872c.toml", "[limits]\nfeed = 9999999\n"),
        way("a fraction of a high block number", "%1\nN2147484.5 G0 X1\nN2147485 M30\n", 1, "E0304"),
        way("no such file", ok, 2, "E0112").says(&["../missing.nc"]),
        way("a macrocycle", ok, 2, "E0112").with("L5", "N1 G79 L5\nN2 G70\n").says(&["L5"]),
        way("a wrong configuration", ok, 2, "E0701").with("cnc872c.toml", "[["),
    ]
}

fn codes(text: &str, severity: &str) -> Vec<String> {
    let mut codes: Vec<String> = text
        .lines()
        .filter_map(|line| line.split_once(&format!(": {severity}["))?.1.split_once(']'))
        .map(|(code, _)| code.to_owned())
        .collect();
    codes.dedup();
    codes
}

/// The last record of a stream.
fn last(stream: &str) -> Option<Value> {
    stream.lines().last().map(|line| serde_json::from_str(line).expect(line))
}

fn assert_way(way: &Way) {
    let files: Vec<(&str, &[u8])> = way.files.iter().map(|(name, text)| (*name, text.as_bytes())).collect();
    let place = Place::with(&files);
    place.put("old.jsonl", "old");
    // A path among the arguments is the program.
    let named = way.arguments.first().filter(|argument| !argument.starts_with('-'));
    let program: &[&str] = if named.is_some() { &[] } else { &["p.nc"] };
    let run = |command: &[&str]| -> Run { place.run(&[command, program, way.arguments].concat()) };

    let compiled = run(&["compile", "--format", "short"]);
    assert_eq!(compiled.code, Some(way.status), "{}: {}", way.what, compiled.stderr);
    let errors = codes(&compiled.stderr, "error");
    assert_eq!(errors.first().map(String::as_str), way.error, "{}: {}", way.what, compiled.stderr);
    let end = last(&compiled.stdout).filter(|record| record["kind"] == "end");
    assert_eq!(end.is_some(), way.status == 0, "{}: {}", way.what, compiled.stdout);
    if let Some(end) = end {
        let blocks = compiled.stdout.lines().filter(|line| line.starts_with("{\"kind\":\"block\"")).count();
        assert_eq!(end["blocks"], blocks, "{}", way.what);
    }
    assert_eq!(compiled.stdout.matches("\"kind\":\"end\"").count(), usize::from(way.status == 0), "{}", way.what);

    // A file is replaced by a whole stream only.
    let written = run(&["compile", "-o", "old.jsonl", "--format", "short"]);
    assert_eq!(written.code, Some(way.status), "{}", way.what);
    let kept = place.read("old.jsonl");
    assert_eq!(kept == b"old", way.status != 0, "{}", way.what);
    if way.status == 0 {
        assert!(kept == compiled.stdout.as_bytes(), "{}", way.what);
    }

    // `check` finds the same; W0503 is a warning there, and a macrocycle is something that it takes.
    let checked = run(&["check", "--format", "short"]);
    let accepted = way.what == "a macrocycle" || way.error == Some("W0503");
    let status = if accepted { 0 } else { way.status };
    assert_eq!(checked.code, Some(status), "{}: {}", way.what, checked.stdout);
    if !accepted {
        assert_eq!(codes(&checked.stdout, "error").first().map(String::as_str), way.error, "{}", way.what);
    }
}

/// block-stream.md: a stream is complete when its last record is `end`; with an error there is none, and status 1.
#[test]
fn status_end_and_errors_agree() {
    ways().iter().for_each(assert_way);
}
