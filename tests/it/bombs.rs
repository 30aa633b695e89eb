//! Inputs made to bring a program down, on the real binary: time and memory stay bounded, and messages stay short,
//! true, and at the right place.
#![cfg(unix)]

use std::fmt::Write as _;
use std::fs::File;
use std::io::{Read, Seek};
use std::process::Output;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::cli::{BAD, GOOD, Place, Run};

/// Nothing here takes a tenth of this, not even without optimisation.
const HANG: Duration = Duration::from_secs(120);

/// Address space for each run, in MiB: threads and libraries included.
const MEMORY_MIB: u64 = 1024;

/// Most findings of one code in one file that a run keeps (diagnostics.md; the rest is counted).
const SHOWN: usize = 10_000;

const FORMATS: [&str; 5] = ["human", "short", "json", "sarif", "github"];

/// A run with bounded memory, which is ended when it hangs.
#[track_caller]
fn bounded(place: &Place, arguments: &[&str]) -> Run {
    bounded_by(MEMORY_MIB, place, arguments)
}

#[track_caller]
fn bounded_by(mib: u64, place: &Place, arguments: &[&str]) -> Run {
    let limit = format!("ulimit -v {}; exec \"$0\" \"$@\"", mib * 1024);
    let mut command = place.command_through(&["sh", "-c", &limit], arguments);
    // Each thread, and each arena of the allocator, takes address space that it may never use.
    command.envs([("RAYON_NUM_THREADS", "2"), ("MALLOC_ARENA_MAX", "2")]);
    let mut outputs = [tempfile::tempfile().unwrap(), tempfile::tempfile().unwrap()];
    let [stdout, stderr] = &outputs;
    let mut child = command.stdout(stdout.try_clone().unwrap()).stderr(stderr.try_clone().unwrap()).spawn().unwrap();
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if start.elapsed() > HANG {
            child.kill().unwrap();
            panic!("{arguments:?} hangs");
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    let mut read = |file: &mut File| {
        let mut bytes = Vec::new();
        file.rewind().unwrap();
        file.read_to_end(&mut bytes).unwrap();
        bytes
    };
    let [stdout, stderr] = outputs.each_mut().map(&mut read);
    Run::of(Output { status, stdout, stderr })
}

/// The run of `check` on one program.
fn check(program: &str, options: &[&str]) -> Run {
    let place = Place::with(&[("a.nc", program.as_bytes())]);
    bounded(&place, &[&["check", "a.nc"], options].concat())
}

fn json(run: &Run) -> Value {
    serde_json::from_str(&run.stdout).unwrap()
}

/// Codes without repetition, sorted.
fn codes(run: &Run) -> Vec<String> {
    let mut codes: Vec<String> = json(run)["diagnostics"]
        .as_array()
        .unwrap()
        .iter()
        .map(|finding| finding["code"].as_str().unwrap().to_owned())
        .collect();
    codes.sort();
    codes.dedup();
    codes
}

/// FLW-9: repeats that multiply end at the limit, with few words, and with nothing half written.
#[test]
fn nested_repeats() {
    let jumps: String = (1..=30).map(|n| format!("N{} G73 L20 Q9999\n", 100 + n)).collect();
    let calls: String = (1..=9)
        .map(|n| {
            format!(
                "N{} G79 L{}\nN{} G71 L{} Q9999\nN{} G70\n",
                100 * n,
                100 * n,
                100 * n + 1,
                100 * n + 100,
                100 * n + 2
            )
        })
        .collect();
    let programs = [
        format!("%1\nN10 G0 G90 X0\nN20 X1\n{jumps}N999 M30\n"),
        format!("%1\nN10 G71 L100 Q9999\nN20 M30\n{calls}N1000 G79 L1000\nN1001 X1\nN1002 G70\n"),
        "%1\nN10 G0 G90 X0\nN20 G72 L5 Q9999\nN30 M30\n".to_owned(),
    ];
    for program in programs {
        let macrocycle = b"N1 G79 L5\nN2 G72 L6 Q9999\nN3 G70\n";
        let innermost = b"N1 G79 L6\nN2 X1\nN3 G73 L2 Q9999\nN4 G70\n";
        let files: [(&str, &[u8]); 4] =
            [("a.nc", program.as_bytes()), ("L5", macrocycle), ("L6", innermost), ("out", b"old")];
        let place = Place::with(&files);
        let run = bounded(&place, &["check", "a.nc", "--max-blocks", "100000", "--format", "json"]).ends(1);
        assert!(codes(&run).contains(&"E0410".to_owned()), "{run:?}");
        let run = bounded(&place, &["compile", "a.nc", "-o", "out", "--max-blocks", "100000"]).ends(1);
        assert!(run.stderr.contains("more than 100,000 blocks"), "{run:?}");
        assert_eq!(place.read("out"), b"old");
        assert_eq!(place.list().len(), 4);
    }
}

/// Ten million bytes in one line, of every kind: what is shown of it is short.
#[test]
fn one_endless_line() {
    let blocks: String = (1..10_000).fold("%1 ".to_owned(), |mut text, n| {
        let _ = write!(text, "N{n} G0 X{n}. \"{}\" ", "COMMENT ".repeat(125));
        text
    });
    assert!(blocks.len() > 10_000_000);
    let filled = |piece: &str, bytes: usize| format!("%1 N10 G90 G0 {} N20 M30", piece.repeat(bytes / piece.len()));
    let (long, short) = (|piece| filled(piece, 10_000_000), |piece| filled(piece, 1_000_000));
    let lines = [
        ("blocks", blocks + "X2 M30", 1),
        ("comment", format!("%1 N10 G90 G0 X1 X2 N20 M30 \"{}", "x".repeat(10_000_000)), 1),
        ("quotes", short("\"\""), 0),
        ("digits", long("9"), 1),
        ("zeros", short("X0000000000000000000000000000000000000000"), 1),
        ("one number", format!("%1 N10 G90 G0 X{} N20 M30", "9".repeat(10_000_000)), 1),
        ("one fraction", format!("%1 N10 G90 G0 X1.{} N20 M30", "3".repeat(10_000_000)), 0),
        ("unknown", short("?"), 1),
        ("accents", short("ř"), 1),
        ("letters", long("X"), 1),
        ("signs", format!("%1 N10 G90 G0 X{} N20 M30", "-".repeat(1_000_000)), 1),
        ("blanks", short(" "), 0),
        ("nothing", "\0".repeat(10_000_000), 1),
    ];
    for (name, line, status) in lines {
        let place = Place::with(&[("a.nc", line.as_bytes()), ("out", b"old")]);
        let run = bounded(&place, &["check", "a.nc"]);
        assert_eq!(run.code, Some(status), "{name}: {run:?}");
        let longest = run.stdout.lines().map(|line| line.chars().count()).max().unwrap();
        assert!(longest < 300, "{name}: a line of {longest} characters");
        if name == "blocks" {
            bounded(&place, &["compile", "a.nc", "-o", "out"]).ends(1);
            assert_eq!(place.read("out"), b"old", "{name}");
        }
    }
}

/// The other forms of output show an endless line as briefly; the columns are right to the end.
#[test]
fn one_endless_line_in_every_form() {
    let line = format!("%1 N10 G90 G0 \"{}\" X1 X2 N20 M30", "ř".repeat(5_000_000));
    let column = line.chars().take_while(|character| *character != 'X').count() + 4;
    for format in FORMATS {
        let run = check(&line, &["--format", format, "-A", "E0109"]).ends(1);
        assert!(run.stdout.len() < 20_000, "{format}: {} bytes", run.stdout.len());
        let place = match format {
            "human" | "short" => format!("a.nc:1:{column}"),
            "json" => format!("\"line\":1,\"column\":{column}"),
            "sarif" => format!("\"startColumn\":{column}"),
            _ => format!("line=1,col={column}"),
        };
        assert!(run.stdout.contains(&place), "{format}: {run:?}");
    }
}

/// A comment of another control with a million blanks in it: each is looked at once.
#[test]
fn a_comment_of_blanks() {
    let run = check(&format!("%1\nN10 G0 X1 (a{}b)\nN20 M30\n", " ".repeat(1_000_000)), &["--format", "json"]).ends(1);
    assert!(codes(&run).contains(&"E0101".to_owned()), "{run:?}");
}

/// Seven million quotes, the last of them open: comments take no more than their places.
#[test]
fn a_line_of_quotes() {
    let run = check(&format!("%1\nN10 X1 {}\nN20 M30\n", "\"".repeat(7_000_001)), &["--format", "short"]).ends(0);
    assert!(run.stdout.contains("W0109") || run.stdout.contains("E0109"), "{run:?}");
    for (part, count) in [("X1\"0\"", 300_001), ("“0\"", 300_000), ("abc\" ", 100_001), ("\"1 X1 Y2\"b", 100_001)] {
        check(&format!("%1\nN10 X1{}\nN20 M30\n", part.repeat(count)), &["--format", "short"]);
    }
}

/// A million words in one block: as many findings as are shown, and the number of all.
/// `format`: the comments of one block, or of the line of the program's start.
#[test]
fn a_line_of_comments() {
    let comments = "\"abc\" ".repeat(300_000);
    for program in [
        format!("%1\nN1 G0\nN2 X1 {comments}\nN3 M30\n"),
        format!("%1 {comments}\nN1 G0\nN3 M30\n"),
        format!("%1\nN1 G0\n{comments}\nN3 M30 {comments}*\n"),
    ] {
        let place = Place::with(&[("p.nc", program.as_bytes())]);
        bounded(&place, &["format", "--check", "p.nc"]).ends(1);
    }
}

#[test]
fn a_million_words_in_a_block() {
    let words = [
        ("X1 Y2\n", &["E0306"][..], 1_000_000),
        ("G0 G1\n", &["E0307"], 100_000),
        ("R1=5 R2=6\n", &["E0306", "E0310"], 100_000),
        ("/ / ", &["E0306", "E0109"], 100_000),
        ("E5 O6\n", &["E0301"], 100_000),
    ];
    for (pair, expected, count) in words {
        let run = check(&format!("%1\nN10 {}\nN20 M30\n", pair.repeat(count / 2)), &["--format", "json"]).ends(1);
        let json = json(&run);
        let found = codes(&run);
        assert!(found.iter().all(|code| expected.contains(&code.as_str())), "{pair}: {found:?}");
        let shown = json["diagnostics"].as_array().unwrap().iter().filter(|finding| finding["severity"] == "error");
        let shown = shown.count();
        assert!((SHOWN..=SHOWN * expected.len()).contains(&shown), "{pair}: {shown}");
        let (errors, beyond) = (&json["summary"]["errors"], &json["summary"]["suppressed"]);
        assert_eq!(errors.as_u64().unwrap(), shown as u64 + beyond.as_u64().unwrap(), "{pair}");
        assert!(errors.as_u64().unwrap() >= count as u64 - 100, "{pair}: {errors}");
    }
}

/// A million findings: the output shows ten thousand, and counts the others, in every form and both languages.
#[test]
fn a_million_findings() {
    let place = Place::with(&[]);
    let put = |count: usize| place.put("a.nc", format!("%1\nN10 G90 G0 {}N20 M30\n", "X1\n".repeat(count + 1)));
    put(1_000_000);
    let run = bounded(&place, &["check", "a.nc"]).ends(1);
    assert_eq!(run.stdout.matches("[E0306]").count(), 20);
    assert!(
        run.stdout.contains("a.nc: 999980 more E0306 (duplicate-address); --all shows the first 10000\n"),
        "{run:?}"
    );
    assert!(run.stdout.contains("1 program: 1000000 errors\n"), "{run:?}");
    // The forms differ in what they show only.
    const FOUND: usize = 30_000;
    let more = FOUND - SHOWN;
    put(FOUND);
    let (en, cs) = (
        format!("a.nc: {more} more E0306 (duplicate-address) are counted, but not kept\n"),
        format!("a.nc: E0306 (duplicate-address) ještě {more}×, jen započteno\n"),
    );
    for (lang, said) in [("en", en), ("cs", cs)] {
        for format in FORMATS {
            if lang == "cs" && format != "short" {
                continue;
            }
            let run = bounded(&place, &["check", "a.nc", "--all", "--format", format, "--lang", lang]).ends(1);
            assert!(run.stdout.len() < 10_000_000, "{format}");
            let (shown, counted) = match format {
                "human" => (run.stdout.matches("[E0306]").count(), run.stdout.contains(&said)),
                // One line each.
                "short" => (run.stdout.lines().count() - 1, run.stdout.ends_with(&said)),
                // Words for people surround them.
                "github" => {
                    let told = format!("{more} more findings are counted, but not shown\n");
                    (run.stdout.lines().count(), run.stderr == told)
                }
                "json" => {
                    let json = json(&run);
                    let counted = json["summary"]["errors"] == FOUND && json["summary"]["suppressed"] == more;
                    (json["diagnostics"].as_array().unwrap().len(), counted)
                }
                _ => {
                    let run = &json(&run)["runs"][0];
                    (run["results"].as_array().unwrap().len(), run["properties"]["suppressed"] == more)
                }
            };
            assert_eq!((shown, counted), (SHOWN, true), "{format} {lang}");
            assert!(run.stderr.is_empty() || format == "github", "{format}: {}", run.stderr);
        }
    }
    // The same of compile, whose findings go to stderr.
    let run = bounded(&place, &["compile", "a.nc", "--all", "--format", "short"]).ends(1);
    assert_eq!(run.stderr.lines().count(), SHOWN + 1);
    assert!(run.stderr.ends_with(&format!("{more} more E0306 (duplicate-address) are counted, but not kept\n")));
}

/// Many programs with many findings: none takes the place of those in another.
#[test]
fn a_million_findings_in_many_programs() {
    let program = format!("%1\nN10 G90 G0 {}N20 M30\n", "X1\n".repeat(1001));
    let place = Place::with(&[]);
    for number in 0..15 {
        place.put(&format!("{number:02}.nc"), &program);
    }
    let run = bounded(&place, &["check", ".", "--format", "json"]).ends(1);
    let json = json(&run);
    assert_eq!(json["diagnostics"].as_array().unwrap().len(), 15_000);
    let summary = &json["summary"];
    let counts = [&summary["files"], &summary["errors"], &summary["warnings"], &summary["by_code"]["E0306"]];
    assert_eq!(counts, [&15.into(), &15_000.into(), &0.into(), &Value::from(15_000)]);
    assert_eq!(
        summary["not_executed"].as_array().unwrap().len(),
        0,
        "wrong words do not keep a program from being executed"
    );
}

/// All the macrocycles that there can be: each called by the program, checked as a folder, and called by one another.
#[test]
fn ten_thousand_macrocycles() {
    const ALL: u32 = 9999;
    let place = Place::with(&[]);
    let write = |body: &dyn Fn(u32) -> String| {
        for l in 1..=ALL {
            place.put(&format!("m/L{l}"), format!("N1 G79 L{l}\n{}N3 G70\n", body(l)));
        }
    };
    let calls: String = (1..=ALL).map(|l| format!("N{l} G72 L{l}\n")).collect();
    // The last number is taken by the calls: the neighbour of the last block holds the end.
    place.put("a.nc", format!("%1\n{}N9999 M30\n", calls.strip_suffix("N9999 G72 L9999\n").unwrap()));
    write(&|l| format!("N2 G0 G90 X{}\n", l % 100));
    bounded(&place, &["check", "a.nc", "-L", "m"]).ends(0);
    bounded(&place, &["compile", "a.nc", "-L", "m", "-o", "out"]).ends(0);
    let stream = String::from_utf8(place.read("out")).unwrap();
    assert_eq!(stream.matches("\"kind\":\"file\"").count(), 9998);
    let run = bounded(&place, &["check", "m"]).ends(0);
    assert!(run.stdout.contains("9999 programs"), "{run:?}");
    // One behind the other, deeper than calls may be open; then the last one calls the first.
    write(&|l| format!("N2 G72 L{}\n", l + 1));
    for last in ["G0", "G72 L1"] {
        place.put(&format!("m/L{ALL}"), format!("N1 G79 L{ALL}\nN2 {last}\nN3 G70\n"));
        let run = bounded(&place, &["check", "a.nc", "-L", "m", "--format", "json"]).ends(1);
        let code = if last == "G0" { "E0409" } else { "E0408" };
        assert!(codes(&run).contains(&code.to_owned()), "{:?}", codes(&run));
        assert!(run.stdout.len() < 100_000, "{}", run.stdout.len());
    }
}

/// As many files as a folder can hold for one number.
#[test]
fn many_files_of_one_macrocycle() {
    let place = Place::with(&[("a.nc", b"%1\nN10 G72 L5\nN20 M30\n")]);
    for zeros in 0..200 {
        for extension in ["", ".nc", ".MRC"] {
            place.put(&format!("L{}5{extension}", "0".repeat(zeros)), "N1 G79 L5\nN2 G70\n");
        }
    }
    let run = bounded(&place, &["check", "a.nc", "--format", "json"]).ends(1);
    assert_eq!(codes(&run), ["E0217"]);
}

/// Elements in elements, attributes, entities that multiply: read, or refused at their place.
#[test]
fn deep_and_wide_xml() {
    let function = "<MFunctions><MFunc No='77' GroupNo='5'/></MFunctions>";
    let deep = |count: usize| format!("{}{function}{}", "<a>".repeat(count), "</a>".repeat(count));
    let laughs: String = (1..10).map(|n| format!("<!ENTITY l{n} '{}'>", format!("&l{};", n - 1).repeat(10))).collect();
    let documents = [
        (deep(300_000), None),
        ("<a>".repeat(300_000), Some("E0701")),
        (format!("<a>{function}{}</a>", "<b/>".repeat(300_000)), None),
        (format!("<a><MFunctions>{}</MFunctions></a>", "<MFunc No='999'/>".repeat(30_000)), Some("E0702")),
        (format!("<a {}/>", (0..100_000).map(|n| format!("a{n}='' ")).collect::<String>()), Some("E0701")),
        (format!("<!DOCTYPE a [<!ENTITY l0 'ha'>{laughs}]><a>&l9;</a>"), Some("E0701")),
        (format!("<a b='{}'>{function}</a>", "x".repeat(10_000_000)), None),
        (format!("<a><{}/></a>", "n".repeat(10_000_000)), Some("W0708")),
        (format!("<a><MFunctions><MFunc No='{}'/></MFunctions></a>", "9".repeat(10_000_000)), Some("E0702")),
    ];
    for (document, code) in documents {
        let begin: String = document.chars().take(60).collect();
        let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("c.xml", document.as_bytes())]);
        let run = bounded(&place, &["check", "a.nc", "--channel-config", "c.xml"]);
        assert_eq!(
            run.code,
            Some(if code.is_some_and(|code| code.starts_with('E')) { 2 } else { 0 }),
            "{begin}: {:.500}",
            run.stdout
        );
        let details = code.map_or("no errors".to_owned(), |code| format!("\ndetails: cnc872c explain {code}\n"));
        assert!(run.stdout.contains(&details), "{begin}: {:.500}", run.stdout);
        let longest = run.stdout.lines().map(|line| line.chars().count()).max().unwrap();
        assert!(longest < 300, "{begin}: a line of {longest} characters");
    }
}

/// The same of the project file.
#[test]
fn deep_and_wide_toml() {
    let texts = [
        format!("a = {}1{}", "[".repeat(100_000), "]".repeat(100_000)),
        format!("a = {}", "{b=".repeat(100_000)),
        format!("[{}]", vec!["a"; 100_000].join(".")),
        (0..30_000).map(|n| format!("k{n} = {n}\n")).collect(),
        (0..20_000).map(|_| "[[axes]]\nletter = 'X'\nkind = 'linear'\n").collect(),
        format!("dialect = \"{}\"", "x".repeat(10_000_000)),
        format!("\"{}\" = 1", "k".repeat(1_000_000)),
        format!("macrocycles = [{}]", "'m', ".repeat(100_000)),
        "x".repeat(10_000_000),
    ];
    for text in texts {
        let begin: String = text.chars().take(60).collect();
        let place = Place::with(&[("a.nc", BAD.as_bytes()), ("cnc872c.toml", text.as_bytes())]);
        let run = bounded(&place, &["check", "a.nc"]);
        assert!(matches!(run.code, Some(1 | 2)), "{begin}: {run:?}");
        let longest = run.stdout.lines().map(|line| line.chars().count()).max().unwrap();
        assert!(longest < 300, "{begin}: a line of {longest} characters");
        assert!(run.stdout.len() < 10_000_000, "{begin}: {}", run.stdout.len());
    }
}

/// Numbers beyond every type, wherever a number may stand: a finding or wrong usage at the number, nothing else.
#[test]
fn huge_numbers() {
    let numbers = ["18446744073709551616", "99999999999999999999999999999999999999999", "1e999", "9223372036854775808"];
    let addresses = ["N", "X", "-X", "G", "M", "L", "Q", "T", "S", "F", "D", "R", "R1=", "R1=-", "%", "&", "I", "G4 Q"];
    for number in numbers {
        for address in addresses {
            let (address, sign) = address.strip_prefix('-').map_or((address, ""), |address| (address, "-"));
            let program = format!("%1\nN10 G0 G90 X1\nN15 {address}{sign}{number}\nN20 M30\n");
            let run = check(&program, &["--format", "json"]).ends(1);
            let found = json(&run);
            for finding in found["diagnostics"].as_array().unwrap() {
                assert_eq!(finding["span"]["start"]["line"], 3, "{address}{number}: {finding}");
            }
        }
        let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
        let run = bounded(&place, &["check", "a.nc", "--param", &format!("R10={number}")]).ends(2);
        assert!(run.stderr.contains("--param") && run.stderr.contains(number), "{run:?}");
        for option in ["--from", "--limit", "--max-blocks"] {
            // The greatest numbers of 64 bits are numbers of blocks as any.
            let status = if number == "9223372036854775808" { 0 } else { 2 };
            let run = bounded(&place, &["compile", "a.nc", option, number]).ends(status);
            assert!(status == 0 || (run.stderr.contains(option) && run.stderr.contains(number)), "{run:?}");
        }
        for key in ["[limits]\nrecords", "[limits]\nnesting", "[limits]\nfeed", "[parameters]\nR1", "[cycles]\nG81"] {
            place.put("cnc872c.toml", format!("{key} = {number}\n"));
            let run = bounded(&place, &["check", "a.nc", "--format", "json"]).ends(2);
            assert_eq!(json(&run)["diagnostics"][0]["span"]["start"]["line"], 2, "{key}: {}", run.stdout);
            assert_eq!(json(&run)["diagnostics"].as_array().unwrap().len(), 1, "{key}: {}", run.stdout);
        }
        place.put("cnc872c.toml", "channel-config = 'c.xml'\n");
        for attribute in ["No", "GroupNo", "BreakCont", "ChangePos"] {
            let others = if attribute == "No" { "GroupNo='5'" } else { "No='77'" };
            place.put("c.xml", format!("<a><MFunctions><MFunc {others} {attribute}='{number}'/></MFunctions></a>"));
            let run = bounded(&place, &["check", "a.nc", "--format", "json"]).ends(2);
            assert_eq!(codes(&run), ["E0702"], "{attribute}: {}", run.stdout);
        }
    }
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    let most = u64::MAX.to_string();
    let run = bounded(&place, &["compile", "a.nc", "--from", &most, "--limit", &most, "--max-blocks", &most]).ends(0);
    assert_eq!(run.stdout.lines().count(), 2, "program and end: {run:?}");
}

/// Sums of counters beyond what a number holds: the limit comes first.
#[test]
fn huge_counts_that_computation_makes() {
    let folder = Place::with(&[
        ("cnc872c.toml", b"[operations]\n\"03\" = \"mul\"\n[limits]\nrecords = 9223372036854775807\n"),
        ("a.nc", b"%1\nN10 R1=69999 R2=69999\nN20 G26 R5=3010204\nN30 G0 G90 XR4\nN40 M30\n"),
    ]);
    let run = bounded(&folder, &["check", "a.nc", "--format", "json"]).ends(1);
    assert!(codes(&run).iter().all(|code| ["E0509", "E0507", "E0510", "E0508"].contains(&code.as_str())), "{run:?}");
}

/// A project file that names itself, or the program, as something else: read as what it is called, once.
#[test]
fn a_project_file_that_names_itself() {
    let call = b"%1\nN10 G72 L5\nN20 M30\n";
    let cases = [
        ("channel-config = \"cnc872c.toml\"", 2, "E0701"),
        ("channel-config = \"./x/../cnc872c.toml\"", 2, "E0701"),
        ("channel-config = \"a.nc\"", 2, "E0701"),
        ("channel-config = \".\"", 2, "E0701"),
        ("channel-config = \"\"", 2, "E0701"),
        ("macrocycles = [\"cnc872c.toml\"]", 2, "E0702"),
        ("macrocycles = [\"cnc872c.toml/..\"]", 2, "E0702"),
        ("macrocycles = [\"a.nc\", \"\", \".\"]", 2, "E0702"),
        ("macrocycles = [\"\", \".\", \"./.\", \"x\", \"x/..\", \"/\"]", 1, "E0405"),
    ];
    for (text, status, code) in cases {
        let place = Place::with(&[("a.nc", call), ("x/y", b""), ("cnc872c.toml", text.as_bytes())]);
        let run = bounded(&place, &["check", "a.nc", "--format", "json"]).ends(status);
        assert_eq!(codes(&run), [code], "{text}");
        let run = bounded(&place, &["check", "a.nc", "--config", "cnc872c.toml", "--format", "json"]).ends(status);
        assert_eq!(codes(&run), [code], "{text}");
    }
    // The command line the same.
    let place = Place::with(&[("a.nc", call), ("cnc872c.toml", b""), ("L7", b"N1 G79 L7\nN2 G72 L7\nN3 G70\n")]);
    for option in ["--config", "--channel-config"] {
        for file in ["a.nc", "."] {
            let run = bounded(&place, &["check", "a.nc", option, file, "--format", "json"]).ends(2);
            assert_eq!(codes(&run), ["E0701"], "{option} {file}");
        }
    }
    let run = bounded(&place, &["check", "cnc872c.toml", "L7", "--format", "json"]).ends(1);
    assert!(codes(&run).contains(&"E0408".to_owned()), "a macrocycle that calls itself: {run:?}");
    // A folder that holds itself.
    std::os::unix::fs::symlink(".", place.path("round")).unwrap();
    place.put("cnc872c.toml", "macrocycles = [\"round\", \"round/round/round\", \".\"]\n");
    let run = bounded(&place, &["check", ".", "--format", "json"]).ends(1);
    assert_eq!(json(&run)["summary"]["files"], 2, "each file once: {run:?}");
    assert!(!codes(&run).contains(&"E0217".to_owned()), "one file by two names is not two files: {run:?}");
}

/// Records that are long by their comments are written as they come: few of them are in memory at once.
#[test]
fn a_loop_of_long_comments() {
    let long = "x".repeat(5_000_000);
    let many = "\"x\"".repeat(300_000);
    for comments in [format!("\"{long}\""), many] {
        let program = format!("%1\nN10 G0 G90 X0\nN20 X1 {comments}\nN30 X2\nN40 G73 L20 Q99\nN50 M30\n");
        let place = Place::with(&[("a.nc", program.as_bytes())]);
        let run = bounded(&place, &["compile", "a.nc", "-o", "/dev/null"]).ends(0);
        assert!(run.stderr.len() < 1000, "{run:?}");
    }
}

/// Signals of the PLC are written as they come, in every form: no steps are kept. The 800,000 steps that the program
/// makes would take more than the memory there is.
#[test]
fn signals_of_a_long_loop() {
    let program =
        "%1\nN10 G0 G90 X0 Y0 S99\nN20 G91 X0.1 M3 T1\nN30 Y0.2 M5 H2\nN40 G73 L20 Q9999\nN50 G73 L20 Q1\nN60 M30\n";
    let place = Place::with(&[("a.nc", program.as_bytes())]);
    for format in ["table", "json", "csv", "vcd"] {
        bounded_by(64, &place, &["plc", "a.nc", "--compat", "--format", format, "-o", "/dev/null"]).ends(0);
    }
    bounded_by(64, &place, &["plc", "a.nc", "--find", "PB05 == 02h", "-o", "/dev/null"]).ends(0);
}
