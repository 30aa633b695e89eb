//! `check FOLDER`: what is found in folders, and what `--fix` and `--diff` do with it.

use crate::cli::{GOOD, Place};

const FIXABLE: &[u8] = b"%1\r\nN10 GO G90 X1,5\r\nN20 M30\r\n";
const FIXED: &[u8] = b"%1\r\nN10 G0 G90 X1.5\r\nN20 M30\r\n";

/// Nothing found is not all right, unless that is what was meant.
#[test]
fn no_program_at_all() {
    let place = Place::with(&[("notes/a.txt", b"done 80 %, 5 left"), ("b/x.nc", GOOD.as_bytes())]);
    place.run(&["check", "notes"]).ends(2).says("no program found in notes");
    place.run(&["check", "notes", "--allow-empty"]).ends(0).says("no program found in notes");
    place.run(&["check", "notes", "--diff"]).ends(2);
    place.run(&["check", "notes", "--diff", "--allow-empty"]).ends(0);
    let run = place.run(&["check", "notes", "--format", "json"]).ends(2);
    assert!(run.stdout.contains("\"diagnostics\":[]"), "{run:?}");
    // One of two is enough.
    place.run(&["check", "notes", "b"]).ends(0);
}

/// Key `extensions`: of the project file of the folder that is searched.
#[test]
fn extensions_of_the_project_file() {
    let bad = b"%1\nN10 X1 X2\nN20 M30\n";
    let place = Place::with(&[
        ("a/one.TAP", bad),
        ("a/two.nc", bad),
        ("a/cnc872c.toml", b"extensions = [\".tap\"]\n"),
        ("a/deep/three.tap", bad),
        ("b/four.nc", bad),
        ("b/five.tap", bad),
    ]);
    let run = place.run(&["check", ".", "--format", "short"]).ends(1);
    let files: Vec<&str> =
        run.stdout.lines().filter(|line| line.contains("E0306")).filter_map(|line| line.split(':').next()).collect();
    assert_eq!(files, ["a/deep/three.tap", "a/one.TAP", "b/four.nc"]);
}

/// What nobody named is fixed only where it is surely a program.
#[test]
fn notes_and_foreign_programs_are_not_fixed() {
    let foreign = b"%1 (PART)\nO0001 (PART)\ng21 g90\nG54 x1,5\nM30\n%\n";
    let notes = b"%1 holes, n 10 x 5,5\nhotovo\n";
    let place = Place::with(&[("a.nc", FIXABLE), ("f.nc", foreign), ("n.txt", notes)]);
    let run = place.run(&["check", "--fix", "."]).ends(1);
    assert_eq!(
        (place.read("a.nc"), place.read("f.nc"), place.read("n.txt")),
        (FIXED.to_vec(), foreign.to_vec(), notes.to_vec())
    );
    assert!(run.stderr.contains("f.nc: not fixed, because it does not look like a program"), "{run:?}");
    // Named, it is the user's wish.
    place.run(&["check", "--fix", "n.txt"]).ends(1);
    assert_ne!(place.read("n.txt"), notes);
}

#[cfg(unix)]
#[test]
fn links_are_not_fixed_unless_named() {
    use std::os::unix::fs::symlink;
    let place =
        Place::with(&[("house/rc.nc", FIXABLE), ("p/in/a.nc", GOOD.as_bytes()), ("p/real/.hidden.nc", FIXABLE)]);
    symlink("../house/rc.nc", place.path("p/part.nc")).unwrap();
    symlink("../house", place.path("p/folder")).unwrap();
    symlink(".hidden.nc", place.path("p/real/seen.nc")).unwrap();
    symlink("nowhere", place.path("p/gone.nc")).unwrap();
    let run = place.run(&["check", "--fix", "p", "--format", "short"]).ends(2);
    assert!(run.stdout.contains("p/gone.nc:1:1: error[E0112]"), "{run:?}");
    for words in [
        "p/part.nc: not searched, the link leads out",
        "p/folder: not searched, the link leads out",
        "p/real/seen.nc: not fixed, because a link leads to it",
    ] {
        assert!(run.stderr.contains(words), "{words}: {run:?}");
    }
    assert_eq!((place.read("house/rc.nc"), place.read("p/real/.hidden.nc")), (FIXABLE.to_vec(), FIXABLE.to_vec()));
    place.run(&["check", "--fix", "p/part.nc"]).ends(0);
    assert_eq!(place.read("house/rc.nc"), FIXED);
}

/// A link beside its file does not keep the file from being fixed, formatted, renumbered.
#[cfg(unix)]
#[test]
fn a_link_beside_its_file_is_passed_over() {
    use std::os::unix::fs::symlink;
    let place = Place::with(&[("plate.nc", FIXABLE)]);
    symlink("plate.nc", place.path("a.nc")).unwrap();
    place.run(&["check", "--fix", "."]).ends(0);
    assert_eq!(place.read("plate.nc"), FIXED);
    place.run(&["format", "."]).ends(0).says("changed: 1, unchanged: 0");
    place.run(&["renumber", ".", "--start", "5"]).ends(0).says("changed: 1, unchanged: 0");
    assert_eq!(place.read("plate.nc"), b"%1\r\nN5 G00 G90 X1.5\r\nN15 M30\r\n");
    assert!(place.path("a.nc").is_symlink());
}

/// `--fix` lists what it does, `--diff` shows it and changes nothing.
#[test]
fn fixes_are_listed_and_shown() {
    let place = Place::with(&[("a.nc", FIXABLE), ("b.nc", GOOD.as_bytes())]);
    let run = place.run(&["check", "--diff", "."]).ends(1);
    assert_eq!(
        run.stdout,
        "--- a.nc\n+++ a.nc\n@@ -1,3 +1,3 @@\n %1\r\n-N10 GO G90 X1,5\r\n+N10 G0 G90 X1.5\r\n N20 M30\r\n"
    );
    assert_eq!(place.read("a.nc"), FIXABLE);
    place.run(&["check", "--diff", "b.nc"]).ends(0);
    place.run(&["check", "--diff", "--fix", "a.nc"]).ends(2).says("--diff cannot be used with --fix");
    assert_eq!(place.read("a.nc"), FIXABLE);
    place.run(&["check", "--diff", "missing.nc"]).ends(2).says("missing.nc: cannot be read");
    let run = place.run(&["check", "--fix", "a.nc"]).ends(0);
    assert!(run.stderr.contains("a.nc: 2 fixes applied\n  a.nc:2:5: E0107 "), "{run:?}");
    assert!(run.stderr.contains("  a.nc:2:12: E0104 "), "{run:?}");
    assert_eq!(place.read("a.nc"), FIXED);
    place.run(&["check", "--diff", "."]).ends(0);
}

/// A diff is one that `patch` takes.
#[cfg(unix)]
#[test]
fn a_diff_is_a_patch() {
    use std::process::Command;
    if Command::new("patch").arg("--version").output().is_err() {
        return;
    }
    let long: String = (1..400).map(|n| format!("n{n} {} X{n}\n", if n % 7 == 0 { "G1" } else { "g1" })).collect();
    let place = Place::with(&[("a.nc", format!("%1\n{long}N999 M30").as_bytes())]);
    let run = place.run(&["check", "--diff", "a.nc"]).ends(1);
    place.put("changes.diff", run.stdout.as_bytes());
    let done =
        Command::new("patch").args(["-p0", "-s", "-i", "changes.diff"]).current_dir(place.path(".")).status().unwrap();
    assert!(done.success());
    assert!(!String::from_utf8(place.read("a.nc")).unwrap().contains(['g', 'n']));
    place.run(&["check", "--diff", "a.nc"]).ends(0);
}

/// A macrocycle that the projects of two folders reach by two spellings is one file, with one name, and found once.
#[test]
fn one_macrocycle_of_two_projects() {
    let project = "macrocycles = [\"../m\"]\n".as_bytes();
    let program = b"%1\nN1 G72 L9001\nN2 M30\n";
    let place = Place::with(&[
        ("p/cnc872c.toml", project),
        ("q/cnc872c.toml", project),
        ("p/a.nc", program),
        ("q/b.nc", program),
        ("m/L9001", b"N1 G79 L9001\nN2\nN3 G70\n"),
    ]);
    let run = place.run(&["check", ".", "--format", "short"]).ends(0);
    assert_eq!(run.stdout, "m/L9001:2:1: warning[W0214]: block N2 is empty\n", "{run:?}");
    let run = place.run(&["compile", "p/a.nc"]).ends(0);
    assert!(run.stdout.contains("\"name\":\"m/L9001\""), "{run:?}");
}
