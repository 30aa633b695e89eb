//! `check --fix` on the real binary.

use crate::cli::{GOOD, Place};

/// In CP852, with CR LF and a Ctrl-Z, as a DOS editor leaves it: an address in lower case, a decimal comma.
const DOS: &[u8] = b"%1 \"P\xfd\xa1RUBA\"\r\nN10 G0 G90 x0 \"\x9fep\"\r\nN20 G1 X10,5 F100\r\nN30 M30\r\n\x1a";
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
    let place = Place::with(&[("a.nc", b"%1\nN10 g0 G90 X1\nN20 M30\n")]);
    place.run(&["check", "--fix", "a.nc", "-A", "W0108"]).ends(0);
    assert_eq!(place.read("a.nc"), b"%1\nN10 g0 G90 X1\nN20 M30\n");
}

#[test]
fn a_folder_is_fixed_with_its_macrocycles() {
    let place = Place::with(&[
        ("a.nc", b"%1\nN10 G72 L5\nN20 m30\n"),
        ("b.nc", b"%2\nN10 g72 L5\nN20 M30\n"),
        ("L5", b"N1 G79 L5\nN2 g0 G90 X1\nN3 G70\n"),
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

/// Words behind `;` stay out of the program; what may be a coordinate or a border of blocks is only offered.
#[test]
fn doubtful_changes_are_offered_only() {
    let text = b"%1\nN10 G0 G90 X1 ;Y5\n; N15 X5\nN20 X2; N25 X3\nN30 G04 X500\nN35 G04 X0.5\nN40 S1.2E+03\nN50 M30\n";
    let fixed = b"%1\nN10 G0 G90 X1 ;Y5\n; N15 X5\nN20 X2; N25 X3\nN30 G04 X500\nN35 G04 Q50\nN40 S1200\nN50 M30\n";
    let place = Place::with(&[("a.nc", text)]);
    place.run(&["check", "--fix", "a.nc"]).ends(1);
    assert_eq!(place.read("a.nc"), fixed);
}

/// BLK-6: a `/` moves once, and only to a block that takes it.
#[test]
fn skips_move_once() {
    let cases: [(&[u8], &[u8]); 5] = [
        (b"N1 X1 / N2 X2 / N3 X3\n", b"N1 X1 N2 / X2 N3 / X3\n"),
        (b"N1 X1 / N2 X2 / N3 X3 /\n", b"N1 X1 / N2 X2 / N3 X3 /\n"),
        (b"N1 X1 / N2 / X2\n", b"N1 X1 / N2 / X2\n"),
        (b"N1 X1 / N2 N3 X3\n", b"N1 X1 / N2 N3 X3\n"),
        (b"N1 X1 //// N2 X2\n", b"N1 X1 ///N2 / X2\n"),
    ];
    for (before, after) in cases {
        let [before, after] = [before, after].map(|text| [b"%1\n".as_slice(), text, b"N9 M30\n"].concat());
        let place = Place::with(&[("a.nc", &before)]);
        place.run(&["check", "--fix", "a.nc"]);
        let shown = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        assert_eq!(shown(place.read("a.nc")), shown(after));
    }
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
    // Wait until the signal is caught: bit 1 stands for SIGINT.
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
