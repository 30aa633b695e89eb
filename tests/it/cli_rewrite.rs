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
    // `patch` takes a name with blanks up to the tab.
    let place = Place::with(&[("a b.nc", b"%1\nN10  X1\nN20 M30\n")]);
    let run = place.run(&["format", "--diff", "a b.nc"]).ends(1);
    assert!(run.stdout.starts_with("--- a b.nc\t\n+++ a b.nc\t\n@@"), "{}", run.stdout);
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

/// What stays because it cannot be replaced does not count as changed; other files are done.
#[test]
#[cfg(unix)]
fn a_file_that_cannot_be_replaced() {
    use std::os::unix::fs::PermissionsExt;

    let place = Place::with(&[("a.nc", UNTIDY), ("b.nc", UNTIDY), ("c.nc", TIDY)]);
    for name in ["a.nc", "c.nc"] {
        std::fs::set_permissions(place.path(name), std::fs::Permissions::from_mode(0o444)).unwrap();
    }
    let run = place.run(&["format", "a.nc", "b.nc", "c.nc"]).ends(2).says("cannot write a.nc");
    assert!(run.stderr.ends_with("changed: 1, unchanged: 1\n"), "{}", run.stderr);
    assert_eq!((place.read("a.nc"), place.read("b.nc")), (UNTIDY.to_vec(), TIDY.to_vec()));
    assert_eq!(place.list(), ["a.nc", "b.nc", "c.nc"]);
}

/// FMT-1: a file that comes in many parts, each in the code page of the file, with an error near its end or without.
#[test]
fn long_files() {
    for last in ["M30", "X- 5"] {
        let block = |number: u32, word: &str| format!("N{number}{word}\"\u{e9}\"\n");
        let text = |word: &str| {
            let blocks: String = (1..20_000).map(|number| block(number, word)).collect();
            format!("%1\n{blocks}N20000 {last}\n")
                .chars()
                .map(|letter| u8::try_from(letter).unwrap())
                .collect::<Vec<u8>>()
        };
        let (loose, tidy) = (text("  X1  "), text(" X1 "));
        let place = Place::with(&[("a.nc", loose.as_slice())]);
        place.run(&["format", "--encoding", "windows-1250", "a.nc"]).ends(0);
        assert!(place.read("a.nc") == tidy, "{last}");
    }
}

#[test]
fn standard_input() {
    let place = Place::with(&[("a.nc", UNTIDY)]);
    let run = place.run_with_stdin(&["format", "-", "a.nc"], b"%1\nN10  g1 X1\nN20 M30\n").ends(0);
    assert_eq!(run.stdout, "%1\nN10 G01 X1\nN20 M30\n");
    assert_eq!(place.read("a.nc"), TIDY);
    let run = place.run_with_stdin(&["format", "-"], b"%1\nN10  g1 X1\nN20 M30\n").ends(0);
    assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("%1\nN10 G01 X1\nN20 M30\n", ""));
    let run = place.run_with_stdin(&["renumber", "-"], b"%1\nN1 X1\nN2 M30\n").ends(0);
    assert_eq!(run.stdout, "%1\nN10 X1\nN20 M30\n");
}
