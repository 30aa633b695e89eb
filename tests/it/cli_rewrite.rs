//! `format` and `renumber` on the real binary.

use crate::cli::Place;

const UNTIDY: &[u8] = b"%1\r\nn10  g0 X1 \"\xfd\xa1\"\r\nN20 M30\r\n\x1a";
const TIDY: &[u8] = b"%1\r\nN10 G00 X1 \"\xfd\xa1\"\r\nN20 M30\r\n\x1a";

/// FMT-1: the file is replaced, byte by byte as it was but for its layout; a second time nothing changes.
#[test]
fn files_are_formatted() {
    let place = Place::with(&[("a.nc", UNTIDY), ("b.nc", TIDY)]);
    let run = place.run(&["format", "a.nc", "b.nc"]).ends(0);
    assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("", "changed: 1, unchanged: 1\n"));
    assert_eq!((place.read("a.nc"), place.read("b.nc")), (TIDY.to_vec(), TIDY.to_vec()));
    let again = place.run(&["fmt", ".", "--lang", "cs"]).ends(0);
    assert_eq!(again.stderr, "změněno: 0, beze změny: 2\n");
    assert_eq!(place.list(), ["a.nc", "b.nc"]);
}

/// FMT-7: `--check` names what would change, `--diff` shows it in the file's own bytes; both leave the file.
#[test]
fn checks_and_diffs() {
    let place = Place::with(&[("a.nc", UNTIDY), ("b.nc", TIDY)]);
    let run = place.run(&["format", "--check", "a.nc", "b.nc"]).ends(1);
    assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("a.nc\n", "would change: 1, unchanged: 1\n"));
    place.run(&["format", "--check", "b.nc"]).ends(0);
    place.run(&["format", "--diff", "b.nc"]).ends(0);
    assert_eq!(place.read("a.nc"), UNTIDY);
    let place = Place::with(&[("a.nc", b"%1\nN10  X1\nN20 M30\n")]);
    let run = place.run(&["format", "--diff", "a.nc"]).ends(1);
    assert_eq!(run.stdout, "--- a.nc\n+++ a.nc\n@@ -1,3 +1,3 @@\n %1\n-N10  X1\n+N10 X1\n N20 M30\n");
}

/// FMT-6: programs for other controls and in UTF-16 stay, with the finding that says so; so does what is no program.
#[test]
fn what_is_left() {
    let wide: Vec<u8> = "\u{feff}%1\nN10  M30\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let foreign = b"%\nO1234\nG21 G17 G40 G80\nT1 M6\nG0 X0 Y0 S1000 M3\nG1 Z-5. F100.\nM30\n%\n";
    let place = Place::with(&[("w.nc", wide.as_slice()), ("f.nc", foreign), ("e.nc", b"")]);
    place.run(&["format", "w.nc"]).ends(0).says("E0115");
    place.run(&["format", "f.nc"]).ends(0).says("W0113");
    place.run(&["format", "e.nc"]).ends(0);
    assert_eq!((place.read("w.nc"), place.read("f.nc"), place.read("e.nc")), (wide, foreign.to_vec(), Vec::new()));
    let errors = Place::with(&[("a.nc", b"%1\nN10 G1  X- 5\nN20  G0 X1 X2\nN30 M30\n")]);
    errors.run(&["format", "a.nc"]).ends(0).says("could not be read: 1");
    assert_eq!(errors.read("a.nc"), b"%1\nN10 G1  X- 5\nN20 G00 X1 X2\nN30 M30\n");
}

#[test]
fn bad_input() {
    let place = Place::with(&[("cnc872c.toml", b"[format]\nindent = 0\n"), ("a.nc", UNTIDY)]);
    place.run(&["format", "a.nc"]).ends(2).says("E0702");
    assert_eq!(place.read("a.nc"), UNTIDY);
    let place = Place::with(&[]);
    place.run(&["format", "none.nc"]).ends(2).says("E0112");
    place.run(&["format", "."]).ends(2);
    place.run(&["renumber", "none.nc"]).ends(2).says("E0112");
}

#[test]
fn standard_input() {
    let place = Place::with(&[]);
    let run = place.run_with_stdin(&["format", "-"], b"%1\nN10  g1 X1\nN20 M30\n").ends(0);
    assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("%1\nN10 G01 X1\nN20 M30\n", ""));
    let run = place.run_with_stdin(&["renumber", "-"], b"%1\nN1 X1\nN2 M30\n").ends(0);
    assert_eq!(run.stdout, "%1\nN10 X1\nN20 M30\n");
}

const PROGRAM: &str =
    "%1\nN1 G0 X0 \"zpet na N3\"\nN2 G71 L5\nN3 X10\nN4 G73 L3 Q2\nN5 M30\nN6 G79 L5\nN7 X1 G73 L7 Q1\nN8 G70\n";

fn renumbered(arguments: &[&str]) -> String {
    let place = Place::with(&[("a.nc", PROGRAM.as_bytes())]);
    place.run(&[&["renumber", "a.nc"], arguments].concat()).ends(0);
    String::from_utf8(place.read("a.nc")).unwrap()
}

/// REN-1, REN-2: one sequence through the file, or a part of it; jumps follow; `--width` fills up N, not L.
#[test]
fn blocks_are_renumbered() {
    let all = "%1\nN10 G0 X0 \"zpet na N3\"\nN20 G71 L5\nN30 X10\nN40 G73 L30 Q2\nN50 M30\nN60 G79 L5\nN70 X1 G73 L70 Q1\nN80 G70\n";
    assert_eq!(renumbered(&[]), all);
    let wide = renumbered(&["--start", "5", "--step", "5", "--width", "4"]);
    assert!(wide.contains("N0005 G0") && wide.contains("N0020 G73 L15 Q2"), "{wide}");
    let unit = renumbered(&["--unit", "L5", "--start", "100"]);
    assert!(unit.contains("N5 M30\nN100 G79 L5\nN110 X1 G73 L110 Q1\nN120 G70"), "{unit}");
    let part = renumbered(&["--from", "N3", "--to", "4", "--start", "100"]);
    assert!(part.contains("N2 G71 L5\nN100 X10\nN110 G73 L100 Q2\nN5 M30"), "{part}");
}

/// REN-4: comments that name blocks are listed, and stay.
#[test]
fn comments_that_name_blocks() {
    let place = Place::with(&[("a.nc", PROGRAM.as_bytes())]);
    place.run(&["renumber", "a.nc"]).ends(0).says("a.nc:2: the comment names N3, which is N30 now");
}

/// REN-2, REN-3, REN-5: what is refused, with the reason; the file stays.
#[test]
fn refusals() {
    let refused = |program: &str, arguments: &[&str], reason: &str| {
        let place = Place::with(&[("a.nc", program.as_bytes())]);
        place.run(&[&["renumber", "a.nc"], arguments].concat()).ends(1).says(reason);
        assert_eq!(place.read("a.nc"), program.as_bytes());
    };
    refused("%1\nN1 R1=1\nN2 G73 LR1\nN3 M30\n", &[], "where N2 in line 3 jumps depends on a parameter: LR1");
    refused("%1\nN1 R1=73\nN2 GR1 L1\nN3 M30\n", &[], "where N2 in line 3 jumps depends on a parameter: GR1");
    refused(PROGRAM, &["--step", "2000"], "the largest step that works is 1664");
    refused(
        PROGRAM,
        &["--from", "3", "--to", "4", "--start", "4", "--step", "1"],
        "N5 belongs to a block outside the part",
    );
    refused(PROGRAM, &["--unit", "L6"], "there is no subprogram L6");
    refused(PROGRAM, &["--from", "N9"], "there is no block N9");
    refused("%1\nN1 X1\nN1 X2\nN2 G73 L1\nN3 M30\n", &[], "several blocks have the number N1");
    refused("%1\nN1 X- 1\nN2 M30\n", &[], "line 2 cannot be read (E0102)");
    refused("%1\nX1\nN2 M30\n", &[], "line 2 cannot be read (E0203)");
}

/// REN-5: numbers that stand twice become different ones when no jump names them.
#[test]
fn double_numbers() {
    let place = Place::with(&[("a.nc", b"%1\nN1 X1\nN1 X2\nN2 M30\n")]);
    place.run(&["renumber", "a.nc"]).ends(0);
    assert_eq!(place.read("a.nc"), b"%1\nN10 X1\nN20 X2\nN30 M30\n");
}
