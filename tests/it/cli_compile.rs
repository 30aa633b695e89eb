//! `compile` on the real binary: where the stream goes, and what is left when it cannot.

use std::fs;

use crate::cli::{BAD, GOOD, Place, closed_pipe};

#[test]
fn the_output_must_be_a_place_for_a_file() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("folder/x", b"")]);
    place.run(&["compile", "a.nc", "-o", "folder"]).ends(2).says("cannot write folder: it is a directory");
    place.run(&["compile", "a.nc", "-o", "missing/a.jsonl"]).ends(2).says("cannot write missing/a.jsonl: no such file");
    place.run(&["compile", "a.nc", "-o", "missing/a.jsonl", "--lang", "cs"]).ends(2).says("nelze zapsat");
    assert_eq!(place.list(), ["a.nc", "folder"]);
}

#[test]
fn the_program_is_not_overwritten() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    place.run(&["compile", "a.nc", "-o", "a.nc"]).ends(2).says("the program itself");
    place.run(&["compile", "./a.nc", "-o", "a.nc"]).ends(2);
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("a.nc", place.path("link")).unwrap();
        place.run(&["compile", "a.nc", "-o", "link"]).ends(2).says("the program itself");
    }
    assert_eq!(place.read("a.nc"), GOOD.as_bytes());
    let macrocycle = "N1 G79 L5\nN2 G70\n";
    place.put("L5", macrocycle);
    place.put("b.nc", "%1\nN10 G72 L5\nN20 M30\n");
    place.run(&["compile", "b.nc", "-o", "L5"]).ends(2).says("a macrocycle of it");
    assert_eq!(place.read("L5"), macrocycle.as_bytes());
}

#[test]
fn a_read_only_file_stays() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("a.jsonl", b"old")]);
    let mut permissions = fs::metadata(place.path("a.jsonl")).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(place.path("a.jsonl"), permissions).unwrap();
    place.run(&["compile", "a.nc", "-o", "a.jsonl"]).ends(2).says("cannot write a.jsonl: permission denied");
    assert_eq!(place.read("a.jsonl"), b"old");
    assert_eq!(place.list(), ["a.jsonl", "a.nc"]);
}

#[cfg(unix)]
#[test]
fn new_files_have_ordinary_permissions_and_old_ones_keep_theirs() {
    use std::os::unix::fs::PermissionsExt;
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("ordinary", b""), ("kept", b"old")]);
    let mode = |name: &str| fs::metadata(place.path(name)).unwrap().permissions().mode() & 0o7777;
    fs::set_permissions(place.path("kept"), fs::Permissions::from_mode(0o604)).unwrap();
    place.run(&["compile", "a.nc", "-o", "new"]).ends(0);
    place.run(&["compile", "a.nc", "-o", "kept"]).ends(0);
    assert_eq!(mode("new"), mode("ordinary"));
    assert_eq!(mode("kept"), 0o604);
    assert_ne!(place.read("kept"), b"old");
    assert_eq!(place.list(), ["a.nc", "kept", "new", "ordinary"]);
}

#[cfg(unix)]
#[test]
fn links_are_followed() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("out/old", b"old")]);
    for (link, target) in [("link", "out/old"), ("dangling", "out/new")] {
        std::os::unix::fs::symlink(target, place.path(link)).unwrap();
        place.run(&["compile", "a.nc", "-o", link]).ends(0);
        assert!(fs::symlink_metadata(place.path(link)).unwrap().is_symlink());
        assert_ne!(place.read(target), b"old");
    }
}

#[cfg(unix)]
#[test]
fn devices_are_written_to_directly() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    place.run(&["compile", "a.nc", "-o", "/dev/null"]).ends(0);
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
}

#[test]
fn the_stream_goes_to_stdout_or_to_a_file() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    let run = place.run(&["compile", "a.nc"]).ends(0);
    let kinds: Vec<serde_json::Value> = run
        .stdout
        .lines()
        .map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap()["kind"].clone())
        .collect();
    assert_eq!(kinds, ["program", "block", "block", "block", "end"]);
    assert_eq!(run.stderr, "");
    place.run(&["compile", "a.nc", "-o", "a.jsonl"]).ends(0);
    assert_eq!(place.read("a.jsonl"), run.stdout.as_bytes());
    let part = place.run(&["compile", "a.nc", "--from", "1", "--limit", "1"]).ends(0).stdout;
    assert_eq!(part.lines().count(), 3, "program, one block, end: {part}");
    assert_eq!(place.run(&["compile", "a.nc", "-o", "-"]).ends(0).stdout, run.stdout);
    let piped = place.run_with_stdin(&["compile", "-"], GOOD.as_bytes()).ends(0);
    assert!(piped.stdout.contains("\"name\":\"-\""), "{piped:?}");
}

#[test]
fn a_program_with_errors_leaves_the_old_file() {
    let place = Place::with(&[("bad.nc", BAD.as_bytes()), ("a.jsonl", b"old")]);
    let run = place.run(&["compile", "bad.nc", "-o", "a.jsonl"]).ends(1).says("E0306");
    assert!(!run.stderr.contains('\u{1b}'));
    assert_eq!(place.read("a.jsonl"), b"old");
    assert_eq!(place.list(), ["a.jsonl", "bad.nc"]);
    let run = place.run(&["compile", "bad.nc", "--format", "short"]).ends(1);
    assert!(run.stderr.starts_with("bad.nc:2:"), "{run:?}");
    assert!(!run.stdout.contains("\"kind\":\"end\""));
}

/// PAR-5: in `compile` a parameter without a value is an error, and `-A` cannot change that.
#[test]
fn a_parameter_without_a_value_is_an_error_in_compile() {
    let place = Place::with(&[("a.nc", b"%1\nN10 G0 G90 XR10\nN20 M30\n")]);
    place.run(&["check", "a.nc"]).ends(0);
    place.run(&["compile", "a.nc", "-A", "W0503"]).ends(1);
    place.run(&["compile", "a.nc", "--param", "R10=5"]).ends(0);
}

#[test]
fn what_is_no_program_gives_status_2() {
    let place = Place::with(&[("L9001", b"N1 G79 L9001 N2 G70"), ("out", b"old")]);
    place.run(&["compile", "L9001", "-o", "out"]).ends(2).says("it is a macrocycle");
    place.run(&["compile", "missing.nc", "-o", "out"]).ends(2).says("E0112");
    place.run(&["compile", ".", "-o", "out"]).ends(2).says("it is a directory");
    assert_eq!(place.read("out"), b"old");
}

#[test]
fn a_closed_pipe_is_no_error() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    let run = place.run_into(&["compile", "a.nc"], closed_pipe()).ends(0);
    assert_eq!(run.stderr, "");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    let full = crate::cli::open_for_writing("/dev/full");
    place.run_into(&["compile", "a.nc"], full).ends(2).says("standard output: the disk is full");
    place.run(&["compile", "a.nc", "-o", "/dev/full"]).ends(2).says("cannot write /dev/full: the disk is full");
}

#[cfg(unix)]
#[test]
fn a_pipe_is_written_to_directly() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    let pipe = place.path("pipe");
    crate::cli::make_fifo(&pipe);
    let reader = std::thread::spawn(move || fs::read(pipe).unwrap());
    place.run(&["compile", "a.nc", "-o", "pipe"]).ends(0);
    assert_eq!(reader.join().unwrap(), place.run(&["compile", "a.nc"]).stdout.as_bytes());
}
