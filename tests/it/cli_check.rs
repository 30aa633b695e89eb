//! `check` on the real binary.

use serde_json::Value;

use crate::cli::{BAD, GOOD, Place, closed_pipe};

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// The codes and files of `--format json`.
fn found(text: &str) -> Vec<(String, String)> {
    let object = json(text);
    let findings = object["diagnostics"].as_array().unwrap();
    let text = |value: &Value| value.as_str().unwrap().to_owned();
    findings.iter().map(|finding| (text(&finding["code"]), text(&finding["file"]))).collect()
}

#[test]
fn levels_that_make_no_sense_are_wrong_usage() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    place.run(&["check", "a.nc", "-D", "empty-blok"]).ends(2).says("perhaps empty-block is meant");
    place.run(&["check", "a.nc", "-A", "E0306"]).ends(2).says("-A E0306: it is an error and cannot be switched off");
    place.run(&["check", "a.nc", "-W", "duplicate-address"]).ends(2).says("cannot be switched off");
    place.run(&["check", "a.nc", "-A", "E0109", "-A", "line-too-long"]).ends(0);
}

#[test]
fn parameters_that_make_no_sense_are_wrong_usage() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    place.run(&["check", "a.nc", "--param", "R96=5"]).ends(2).says("R0 to R95");
    place.run(&["check", "a.nc", "--param", "10=5"]).ends(2).says("R10=5");
    place.run(&["check", "a.nc", "--param", "R10=5", "--param", "r11=-2.5"]).ends(0);
}

/// §13: `--channel-config` with CNC8x6 or CNC8x9 is wrong usage, also when the project file chooses the control.
#[test]
fn a_channel_config_needs_a_cnc872() {
    let place = Place::with(&[
        ("a.nc", GOOD.as_bytes()),
        ("Channel.xml", b"<ChannelConfig><MFunctions/></ChannelConfig>"),
        ("old/b.nc", GOOD.as_bytes()),
        ("old/cnc872c.toml", b"dialect = \"cnc8x9\"\n"),
    ]);
    let option = ["--channel-config", "Channel.xml"];
    place.run(&[&["check", "a.nc", "--dialect", "cnc8x6"], &option[..]].concat()).ends(2).says("cnc8x6");
    place.run(&[&["check", "old"], &option[..]].concat()).ends(2).says("cnc8x9");
    place.run(&[&["compile", "old/b.nc"], &option[..]].concat()).ends(2).says("cnc8x9");
    place.run(&[&["check", "a.nc"], &option[..]].concat()).ends(0);
    place.run(&[&["check", "old", "--dialect", "cnc872"], &option[..]].concat()).ends(0);
}

/// §13: a wrong configuration ends the run before any program is read, and is still shown as findings.
#[test]
fn a_wrong_configuration_ends_with_status_2() {
    let place = Place::with(&[("a.nc", BAD.as_bytes()), ("cnc872c.toml", b"block-skip = 7\n")]);
    let run = place.run(&["check", "a.nc", "--format", "json"]).ends(2);
    assert_eq!(found(&run.stdout), [("E0702".to_owned(), "cnc872c.toml".to_owned())]);
    let run = place.run(&["compile", "a.nc", "-o", "a.jsonl", "--format", "json"]).ends(2);
    assert_eq!(found(&run.stderr), [("E0702".to_owned(), "cnc872c.toml".to_owned())]);
    assert_eq!(place.list(), ["a.nc", "cnc872c.toml"]);
    place.put("other.toml", "");
    place.run(&["check", "--config", "missing.toml", "a.nc"]).ends(2);
}

#[test]
fn each_program_has_the_nearest_project_file() {
    let place = Place::with(&[
        ("one/a.nc", GOOD.as_bytes()),
        ("one/deep/b.nc", GOOD.as_bytes()),
        ("one/cnc872c.toml", b"wrong = 1\n"),
        ("two/c.nc", GOOD.as_bytes()),
        ("two/cnc872c.toml", b"[lints]\nnonsense = \"deny\"\n"),
    ]);
    let run = place.run(&["check", ".", "--format", "json"]).ends(0);
    let warning = |file: &str| ("W0705".to_owned(), file.to_owned());
    let found = found(&run.stdout);
    assert_eq!(found.len(), 2, "each file is read once: {found:?}");
    assert!(found[0].1.ends_with("one/cnc872c.toml") && found[1].1.ends_with("two/cnc872c.toml"), "{found:?}");
    assert_eq!(warning("x").0, found[0].0);
    place.run(&["check", "one", "-A", "unknown-configuration-key", "--deny-warnings"]).ends(0);
    place.run(&["check", "one", "--deny-warnings"]).ends(1);
    place.run(&["check", "one", "-D", "W0705"]).ends(2);
    // The last one on the line counts.
    place.run(&["check", "one", "-D", "W0705", "-A", "W0705", "--deny-warnings"]).ends(0);
    place.run(&["check", "one", "-A", "W0705", "-W", "W0705", "--deny-warnings"]).ends(1);
}

#[test]
fn a_folder_without_programs_is_told() {
    let place = Place::with(&[("notes.txt", b"oil the spindle")]);
    place.run(&["check", "."]).ends(2).says("no program found in .");
}

#[cfg(unix)]
#[test]
fn pipes_in_a_folder_are_passed_by() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    crate::cli::make_fifo(&place.path("b.nc"));
    crate::cli::make_fifo(&place.path("c.txt"));
    crate::cli::make_fifo(&place.path("L5"));
    let run = place.run(&["check", "."]).ends(0);
    let named: Vec<&str> = run
        .stderr
        .lines()
        .filter_map(|line| line.strip_suffix(": not read, it is a pipe or a device: name it to check it"))
        .collect();
    assert_eq!(named, ["L5", "b.nc", "c.txt"]);
}

#[test]
fn errors_give_status_1_and_warnings_only_when_denied() {
    let place = Place::with(&[
        ("good.nc", GOOD.as_bytes()),
        ("bad.nc", BAD.as_bytes()),
        ("warn.nc", b"%1\nN10 G0 G90 X0\nN15\nN20 M30\n"),
    ]);
    place.run(&["check", "good.nc"]).ends(0);
    place.run(&["check", "bad.nc", "good.nc"]).ends(1);
    place.run(&["check", "warn.nc"]).ends(0);
    place.run(&["check", "warn.nc", "--deny-warnings"]).ends(1);
    place.run(&["check", "warn.nc", "-D", "empty-block"]).ends(1);
    let allowed = place.run(&["check", "warn.nc", "-A", "W0214", "--deny-warnings", "--format", "short"]).ends(0);
    assert_eq!(allowed.stdout, "");
}

#[test]
fn a_folder_is_checked_in_a_fixed_order() {
    let place = Place::with(&[
        ("b/z.nc", BAD.as_bytes()),
        ("b/L9001", b"N1 G79 L9001 N2 X1 X2 N3 G70"),
        ("c.MPF", BAD.as_bytes()),
    ]);
    for number in 0..40 {
        place.put(&format!("a/{number:02}.nc"), BAD);
    }
    let first = place.run(&["check", ".", "--format", "json"]).ends(1).stdout;
    let files: Vec<String> = found(&first).into_iter().map(|(_, file)| file.replace('\\', "/")).collect();
    let mut expected: Vec<String> = (0..40).map(|number| format!("a/{number:02}.nc")).collect();
    expected.extend(["b/L9001", "b/z.nc", "c.MPF"].map(str::to_owned));
    assert_eq!(files, expected);
    for _ in 0..3 {
        assert_eq!(place.run(&["check", ".", "--format", "json"]).stdout, first);
    }
}

#[test]
fn standard_input_is_a_program() {
    let place = Place::with(&[]);
    place.run_with_stdin(&["check", "-"], GOOD.as_bytes()).ends(0);
    let run = place.run_with_stdin(&["check", "-", "--format", "json"], BAD.as_bytes()).ends(1);
    assert_eq!(found(&run.stdout), [("E0306".to_owned(), "-".to_owned())]);
}

#[test]
fn what_cannot_be_read_is_a_finding_with_status_2() {
    let place = Place::with(&[("good.nc", GOOD.as_bytes()), ("bad.nc", BAD.as_bytes())]);
    let run = place.run(&["check", "missing.nc", "bad.nc", "--format", "json"]).ends(2);
    let codes: Vec<String> = found(&run.stdout).into_iter().map(|(code, _)| code).collect();
    assert_eq!(codes, ["E0112", "E0306"]);
    let run = place.run(&["check", "missing\u{1b}[2J.nc"]).ends(2);
    assert!(!run.stdout.contains('\u{1b}') && !run.stderr.contains('\u{1b}'), "{run:?}");
    #[cfg(unix)]
    {
        let device = place.run(&["check", "/dev/null", "--lang", "cs"]).ends(2);
        assert!(device.stdout.contains("není to obyčejný soubor"), "{device:?}");
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_that_is_named_is_read() {
    let place = Place::with(&[]);
    let pipe = place.path("pipe");
    crate::cli::make_fifo(&pipe);
    let writer = std::thread::spawn(move || std::fs::write(pipe, BAD).unwrap());
    let run = place.run(&["check", "pipe", "--format", "json"]).ends(1);
    writer.join().unwrap();
    assert_eq!(found(&run.stdout), [("E0306".to_owned(), "pipe".to_owned())]);
}

#[test]
fn a_closed_pipe_leaves_the_status() {
    let place = Place::with(&[("bad.nc", BAD.as_bytes())]);
    for format in ["human", "short", "json", "sarif", "github"] {
        let run = place.run_into(&["check", "bad.nc", "--format", format], closed_pipe()).ends(1);
        assert_eq!(run.stderr, "", "{format}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let place = Place::with(&[("bad.nc", BAD.as_bytes())]);
    let full = crate::cli::open_for_writing("/dev/full");
    place.run_into(&["check", "bad.nc"], full).ends(2).says("the disk is full");
}

/// diagnostics.md: the summary says which programs were not executed, and why.
#[test]
fn programs_that_are_not_executed() {
    let place =
        Place::with(&[("a.nc", b"%1\nG0 X0\n"), ("b.nc", b"%1\nN10 G71 L5\nN20 M30\n"), ("c.nc", GOOD.as_bytes())]);
    let run = place.run(&["check", ".", "--format", "json"]).ends(1);
    let json: Value = serde_json::from_str(&run.stdout).unwrap();
    let listed: Vec<(&str, &str)> = json["summary"]["not_executed"]
        .as_array()
        .unwrap()
        .iter()
        .map(|program| (program["file"].as_str().unwrap(), program["reason"].as_str().unwrap()))
        .collect();
    let checked = "arcs, feeds and calls by parameter are checked once it is corrected";
    assert_eq!(listed, [("a.nc", format!("E0203 (line 2): {checked}").as_str()),]);
    let human = place.run(&["check", "a.nc", "--lang", "cs"]).ends(1);
    assert!(human.stdout.contains("a.nc nebyl proveden kvůli E0203 (řádek 2): oblouky, posuvy"), "{human:?}");
    let lost = place.run(&["check", "b.nc"]).ends(1);
    assert!(lost.stdout.contains("b.nc: after N10 positions are not known: L5 is missing"), "{lost:?}");
    let sarif = place.run(&["check", "none.nc", "--format", "sarif"]).ends(2);
    assert!(sarif.stdout.contains("\"executionSuccessful\":false"), "{sarif:?}");
}

/// diagnostics.md: people see 20 findings of each code and file; --all shows the others.
#[test]
fn the_first_of_many() {
    let place = Place::with(&[("a.nc", format!("%1\nN10 G90 {}\nN20 M30\n", "X1 ".repeat(31)).as_bytes())]);
    let shown = |options: &[&str]| {
        let run = place.run(&[&["check", "a.nc"], options].concat()).ends(1);
        (
            run.stdout.matches("[E0306]").count(),
            run.stdout.contains("10 more E0306 (duplicate-address); --all shows them"),
        )
    };
    assert_eq!(shown(&[]), (20, true));
    assert_eq!(shown(&["--format", "short"]), (20, true));
    assert_eq!(shown(&["--all"]), (30, false));
    assert_eq!(shown(&["--format", "short", "--all"]), (30, false));
}

#[test]
fn a_pattern_that_no_shell_expanded() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    let run = place.run(&["check", "*.nc"]).ends(2);
    assert!(run.stdout.contains("the shell passed the pattern on"), "{run:?}");
    let run = place.run(&["check", "b.nc"]).ends(2);
    assert!(!run.stdout.contains("pattern"), "{run:?}");
    place.run(&["celo.nc"]).ends(2).says("cnc872c check celo.nc");
    place.run(&["check", "a.nc", "--fix", "--diff"]).ends(2).says("cannot be used with");
    for format in ["short", "json", "sarif", "github"] {
        let run = place.run(&["check", "a.nc", "--diff", "--format", format]).ends(2).says("cannot be used with");
        assert_eq!(run.stdout, "");
    }
}

/// diagnostics.md, "As JSON": which program found it, and in which files it looked.
#[test]
fn json_names_the_program_and_the_files() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("b.nc", BAD.as_bytes())]);
    let run = place.run(&["check", ".", "--format", "json"]).ends(1);
    assert!(
        run.stdout.starts_with("{\"tool\":{\"name\":\"cnc872c\",\"version\":\"0.2.0\"},\"files\":[\"a.nc\",\"b.nc\"],")
    );
    let sarif = json(&place.run(&["check", ".", "--format", "sarif"]).ends(1).stdout);
    assert_eq!(sarif["runs"][0]["tool"]["driver"]["version"], "0.2.0");
}

/// Offers and fixes that `--fix` applies are marked; the certain one comes first.
#[test]
fn json_says_which_fixes_are_certain() {
    let place = Place::with(&[("a.nc", b"%1\nN10 G00 G90 X7 0\nN20 Y36,12\nN30 M30\n")]);
    let found = json(&place.run(&["check", "a.nc", "--format", "json"]).ends(1).stdout);
    let certain = |code: &str| {
        let items = found["diagnostics"].as_array().unwrap();
        let item = items.iter().find(|item| item["code"] == code).unwrap();
        let fixes = item["fixes"].as_array().unwrap();
        fixes.iter().map(|fix| fix["certain"].as_bool().unwrap()).collect::<Vec<_>>()
    };
    assert_eq!(certain("E0104"), [true]);
    assert!(certain("E0102").iter().all(|certain| !certain), "{found:#}");
}

/// A file in lower case is one finding with many edits: as JSON it stays near the size of the file.
#[test]
fn many_edits_stay_small() {
    let lines: String = (2..5000).map(|n| format!("n{n} x{n} y5\n")).collect();
    let program = format!("%1\nn1 g0 g90 x0\n{lines}n5000 m30\n");
    let place = Place::with(&[("a.nc", program.as_bytes())]);
    for form in ["json", "sarif"] {
        let run = place.run(&["check", "a.nc", "--format", form, "-A", "W0110"]).ends(0);
        assert!(run.stdout.contains("W0108"), "{}", &run.stdout[..500]);
        assert!(run.stdout.len() < 2 * program.len() + 20_000, "{form}: {}", run.stdout.len());
    }
}

/// UTF-16 in which half a character stands is not written anew: the rest of it would be lost.
#[test]
fn broken_utf16_is_not_fixed() {
    let wide = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    let (head, tail) = (wide("\u{feff}%1 \"x"), wide("\"\r\nN10 G90 G00 X0\r\nN20 M30\r\n"));
    let whole = [head.clone(), tail.clone()].concat();
    let lone = [head, vec![0, 0xd8], tail].concat();
    let odd = [whole.clone(), vec![0x0d]].concat();
    for (bytes, fixed) in [(&whole, true), (&lone, false), (&odd, false)] {
        let place = Place::with(&[("a.nc", bytes)]);
        place.run(&["check", "a.nc", "--fix"]).ends(if fixed { 0 } else { 1 });
        assert_eq!(place.read("a.nc") == *bytes, !fixed);
    }
}

/// UTF-32 begins like UTF-16 or has no mark at all; what its zeros would become in UTF-8 could even pass for UTF-16.
#[test]
fn utf_32_is_not_fixed() {
    let text = "%1 \"ž\"\r\nN10 G54\r\nN20 M30\r\n";
    let wide = |text: &str, unit: fn(u32) -> [u8; 4]| text.chars().map(u32::from).flat_map(unit).collect::<Vec<u8>>();
    for mark in ["\u{feff}", ""] {
        for unit in [u32::to_le_bytes, u32::to_be_bytes] {
            let bytes = wide(&format!("{mark}{text}"), unit);
            let place = Place::with(&[("a.nc", &bytes)]);
            place.run(&["check", "a.nc", "--fix"]).ends(1);
            assert_eq!(place.read("a.nc"), bytes);
        }
    }
}

/// A help and the word that is offered are one line.
#[test]
fn a_finding_says_once_what_to_write() {
    for (code, block) in [
        ("E0204", "N10 X1"),
        ("E0305", "N20 F-100"),
        ("E0401", "N20 G71 P1"),
        ("E0411", "N20 G04 X1.5"),
        ("W0303", "N20 X1.23456"),
    ] {
        let program = format!("%1\nN10 G90 G00 X0\n{block}\nN900 M30\n");
        let place = Place::with(&[("a.nc", program.as_bytes())]);
        for (lang, help) in [("en", "help: "), ("cs", "nápověda: ")] {
            let shown = place.run(&["check", "a.nc", "--lang", lang]);
            let text = format!("{}{}", shown.stdout, shown.stderr);
            assert!(text.contains(code), "{text}");
            assert_eq!(text.matches(help).count(), 1, "{text}");
        }
    }
}

/// Fixes in a macrocycle that the command does not name are not among those that `--fix` would apply.
#[test]
fn fixes_elsewhere_are_not_promised() {
    let place = Place::with(&[
        ("a.nc", b"%1\nN10 G72 L9001\nN20 M30\n".as_slice()),
        ("L9001", b"N1 G79 L9001\nN2 G00 X3,5\nN3 G70\n".as_slice()),
    ]);
    let both = place.run(&["check", "a.nc", "L9001"]);
    assert!(format!("{}{}", both.stdout, both.stderr).contains("check --fix: 1"), "{both:?}");
    let one = place.run(&["check", "a.nc"]);
    let text = format!("{}{}", one.stdout, one.stderr);
    assert!(text.contains("E0104") && !text.contains("--fix"), "{text}");
}
