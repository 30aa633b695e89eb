//! `check --fix` on the real binary.

use crate::cli::{GOOD, Place};

/// In CP852, with CR LF and a Ctrl-Z, as a DOS editor leaves it: a letter for a number, a decimal comma.
const DOS: &[u8] = b"%1 \"P\xfd\xa1RUBA\"\r\nN10 G0 G90 XO \"\x9fep\"\r\nN20 G1 X10,5 F100\r\nN30 M30\r\n\x1a";
const DOS_FIXED: &[u8] = b"%1 \"P\xfd\xa1RUBA\"\r\nN10 G0 G90 X0 \"\x9fep\"\r\nN20 G1 X10.5 F100\r\nN30 M30\r\n\x1a";

#[test]
fn only_files_can_be_fixed() {
    let place = Place::with(&[]);
    place.run_with_stdin(&["check", "--fix", "-"], GOOD.as_bytes()).ends(2).says("give a regular file");
    #[cfg(unix)]
    {
        crate::cli::make_fifo(&place.path("pipe"));
        place.run(&["check", "--fix", "pipe"]).ends(2).says("give a regular file");
    }
}

#[test]
fn a_file_without_findings_is_not_touched() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    let written = || std::fs::metadata(place.path("a.nc")).unwrap().modified().unwrap();
    let before = written();
    let run = place.run(&["check", "--fix", "a.nc"]).ends(0);
    assert_eq!(run.stderr, "");
    assert_eq!(written(), before);
}

#[test]
fn encoding_and_line_ends_are_kept() {
    let place = Place::with(&[("a.nc", DOS)]);
    let run = place.run(&["check", "--fix", "a.nc"]).ends(0);
    assert!(run.stderr.contains("a.nc: 2 fixes applied"), "{run:?}");
    assert_eq!(place.read("a.nc"), DOS_FIXED);
    assert_eq!(place.list(), ["a.nc"]);
    let again = place.run(&["check", "--fix", "a.nc"]).ends(0);
    assert_eq!(again.stderr, "");
}

#[test]
fn what_is_left_is_reported() {
    let place = Place::with(&[("a.nc", b"%1\nN10 G0 G90 X1,5 Y0 Y5\nN20 M30\n")]);
    let run = place.run(&["check", "--fix", "a.nc", "--format", "short", "--lang", "cs"]).ends(1);
    assert!(run.stderr.contains("a.nc: provedena 1 oprava"), "{run:?}");
    assert!(run.stdout.contains("E0306") && !run.stdout.contains("E0104"), "{run:?}");
    assert_eq!(place.read("a.nc"), b"%1\nN10 G0 G90 X1.5 Y0 Y5\nN20 M30\n");
}

/// A finding that is allowed is not fixed.
#[test]
fn levels_count() {
    let place = Place::with(&[("a.nc", b"%1\nn10 g0 g90 x1\nn20 m30\n")]);
    place.run(&["check", "--fix", "a.nc", "-A", "W0108"]).ends(0);
    assert_eq!(place.read("a.nc"), b"%1\nn10 g0 g90 x1\nn20 m30\n");
}

#[test]
fn a_folder_is_fixed_with_its_macrocycles() {
    let place = Place::with(&[
        ("a.nc", b"%1\nn10 g72 l5\nn20 m30\n"),
        ("b.nc", b"%2\nn10 g72 l5\nN20 M30\n"),
        ("L5", b"n1 g79 l5\nn2 g0 G90 X1\nn3 G70\n"),
    ]);
    let alone = place.run(&["check", "--fix", "a.nc"]).ends(0);
    assert!(alone.stderr.contains("L5: not fixed, because it is not among the files to check"), "{alone:?}");
    assert!(alone.stdout.contains("W0108"), "{alone:?}");
    let all = place.run(&["check", "--fix", "."]).ends(0);
    assert!(!all.stdout.contains("W0108"), "{all:?}");
    assert_eq!(place.read("a.nc"), b"%1\nN10 G72 L5\nN20 M30\n");
    assert_eq!(place.read("b.nc"), b"%2\nN10 G72 L5\nN20 M30\n");
    assert_eq!(place.read("L5"), b"N1 G79 L5\nN2 G0 G90 X1\nN3 G70\n");
}

/// diagnostics.md, "Fixes": what is certain is in the list, everything else is left as it is.
#[test]
fn only_what_is_certain_is_applied() {
    let lines: [(&str, &str); 62] = [
        // A decimal comma, not where another number may have been meant.
        ("X10,5", "X10.5"),
        ("XO,5", "XO,5"),
        ("X,5", "X,5"),
        ("X10,", "X10,"),
        ("X1,5,2", "X1,5,2"),
        ("X100, 20", "X100, 20"),
        ("T1,0", "T1,0"),
        // Letters that are the whole number.
        ("XO", "X0"),
        ("X-o", "X-0"),
        ("GOO X5", "G00 X5"),
        ("Xl", "X1"),
        ("XI", "XI"),
        ("XS", "XS"),
        ("X1O0", "X1O0"),
        ("Xl0", "Xl0"),
        ("RO=5", "R0=5"),
        // Not where they may be what is left of a comment.
        ("X5 to", "X5 to"),
        ("X5 GO", "X5 GO"),
        ("X5 Al", "X5 Al"),
        ("to X5", "to X5"),
        ("\"tam a \"CO X5", "\"tam a \"CO X5"),
        ("X5 CO\"", "X5 CO\""),
        // A comment, but not beside another quote, which may be the one too many, or behind `/`.
        ("X5 (dolu)", "X5 \"dolu\""),
        ("X5 \"Y5 \"(dolu)", "X5 \"Y5 \"(dolu)"),
        ("X5 \"Y5 \"\u{201e}dolu\u{201c}", "X5 \"Y5 \"\u{201e}dolu\u{201c}"),
        ("X5 \u{201e}dolu\u{201c}\" Y5", "X5 \u{201e}dolu\u{201c}\" Y5"),
        ("X5 /(dolu)", "X5 /(dolu)"),
        ("R1O=5", "R1O=5"),
        // A blank behind a sign, none inside a number.
        ("X-  36.12", "X-36.12"),
        ("X- R1", "X-R1"),
        ("R1=- 5", "R1=-5"),
        ("X36.  12", "X36.  12"),
        ("X70 40", "X70 40"),
        ("Z100 09", "Z100 09"),
        ("R1=11 72", "R1=11 72"),
        ("S- 500", "S- 500"),
        // A few addresses in lower case.
        ("X18y.924", "X18y.924"),
        // Typographic signs and blanks.
        ("X5 \u{201e}kapsa\u{201c}", "X5 \"kapsa\""),
        ("X5 \u{201e}kapsa", "X5 \"kapsa"),
        ("X5 \u{201e}kapsa Y5", "X5 \u{201e}kapsa Y5"),
        ("X\u{2212}5", "X-5"),
        ("R1=\u{2212}5", "R1=-5"),
        ("X5\u{a0}Y5", "X5 Y5"),
        ("X5\u{a0}\u{a0}Y5\u{a0}\"kapsa\"", "X5 Y5 \"kapsa\""),
        // One that stands in place of a sign or a digit.
        ("Z\u{a0}1.5", "Z\u{a0}1.5"),
        ("X5\u{a0} Z5", "X5\u{a0} Z5"),
        ("X5\u{a0}", "X5\u{a0}"),
        // Comments without a word of a block.
        ("X5 (kapsa 20 mm)", "X5 \"kapsa 20 mm\""),
        ("X5 ; KUS 2", "X5 \"KUS 2\""),
        ("X5 ; T1 KAPSA", "X5 ; T1 KAPSA"),
        ("X5 (kapsa, pak M05)", "X5 (kapsa, pak M05)"),
        ("X5 ;0 Z5", "X5 ;0 Z5"),
        ("X5 ;5", "X5 ;5"),
        ("X5 (", "X5 ("),
        ("X5;", "X5;"),
        ("X5 {kapsa}", "X5 {kapsa}"),
        // What other controls write.
        ("G04 X0.5", "G04 X0.5"),
        ("S1.2E+03", "S1.2E+03"),
        ("X=5", "X=5"),
        ("M03 SS00", "M03 SS00"),
        ("-X10", "-X10"),
        ("X5 / N15 X6", "X5 / N15 X6"),
    ];
    let place = Place::with(&[]);
    for (line, fixed) in lines {
        let program = |line: &str| format!("%1\nN5 G90 F100 T1\nN10 {line}\nN20 M30\n").into_bytes();
        place.put("a.nc", program(line));
        place.run(&["check", "--fix", "a.nc", "-A", "W0604"]);
        let shown = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        assert_eq!(shown(place.read("a.nc")), shown(program(fixed)), "{line}");
    }
}

/// Words that lost their block number are no comment.
#[test]
fn a_comment_of_words_is_not_written() {
    let program = b"%1\nN10 G0 G90 X1\nN5;0 Z5\nN16;0 M05\nN20 M30\n";
    let place = Place::with(&[("a.nc", program)]);
    place.run(&["check", "--fix", "a.nc"]).ends(1);
    assert_eq!(place.read("a.nc"), program);
}

#[cfg(unix)]
#[test]
fn permissions_and_links_are_kept_and_a_read_only_file_stays() {
    use std::fs::{self, Permissions};
    use std::os::unix::fs::PermissionsExt;
    let place = Place::with(&[("real/a.nc", DOS), ("locked.nc", DOS)]);
    fs::set_permissions(place.path("real/a.nc"), Permissions::from_mode(0o606)).unwrap();
    fs::set_permissions(place.path("locked.nc"), Permissions::from_mode(0o444)).unwrap();
    std::os::unix::fs::symlink("real/a.nc", place.path("a.nc")).unwrap();
    place.run(&["check", "--fix", "a.nc"]).ends(0);
    assert!(fs::symlink_metadata(place.path("a.nc")).unwrap().is_symlink());
    assert_eq!(fs::metadata(place.path("real/a.nc")).unwrap().permissions().mode() & 0o7777, 0o606);
    assert_eq!(place.read("real/a.nc"), DOS_FIXED);
    let run = place.run(&["check", "--fix", "locked.nc"]).ends(2);
    assert!(run.stderr.contains("cannot write locked.nc: permission denied"), "{run:?}");
    assert!(!run.stdout.contains("--fix"), "{run:?}");
    assert_eq!(place.read("locked.nc"), DOS);
}

#[cfg(target_os = "linux")]
#[test]
fn an_interruption_leaves_the_file_as_it_was() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};
    // The fix is in the first round; each round executes some hundred million blocks.
    let program = b"%1\nN10 g0 G90 X0\nN20 G1 X1 F100\nN30 G73 L20 Q9999\nN40 G73 L20 Q9999\nN50 M30\n";
    let place = Place::with(&[("a.nc", program)]);
    let mut command = place.interruptible(&["check", "--fix", "a.nc", "--max-blocks", "1000000000"]);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    // Wait until the signal is caught: bit 1 is SIGINT.
    let catches = || {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap().trim().to_owned();
        u64::from_str_radix(&caught, 16).unwrap() & 2 != 0
    };
    let start = Instant::now();
    while !catches() && start.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(10));
    }
    let kill = Command::new("sh").args(["-c", &format!("kill -INT {}", child.id())]).status().unwrap();
    assert!(kill.success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(std::os::unix::process::ExitStatusExt::signal(&output.status), Some(2));
    assert!(String::from_utf8(output.stderr).unwrap().contains("interrupted"));
    assert_eq!(place.read("a.nc"), program);
    assert_eq!(place.list(), ["a.nc"]);
}
