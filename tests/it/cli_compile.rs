//! `compile` on the real binary: where the stream goes, and what is left when it cannot.

use std::fs;

use crate::cli::{BAD, GOOD, Place, Run, closed_pipe};

#[test]
fn the_output_must_be_a_place_for_a_file() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("folder/x", b"")]);
    place.run(&["compile", "a.nc", "-o", "folder"]).ends(2).says("cannot write folder: it is a folder");
    place
        .run(&["compile", "a.nc", "-o", "missing/a.jsonl"])
        .ends(2)
        .says("cannot write missing/a.jsonl: there is no such folder");
    place.run(&["compile", "a.nc", "-o", "missing/a.jsonl", "--lang", "cs"]).ends(2).says("nelze zapsat");
    assert_eq!(place.list(), ["a.nc", "folder"]);
}

#[test]
fn the_program_is_not_overwritten() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    place.run(&["compile", "a.nc", "-o", "a.nc"]).ends(2).says("what the stream is made from");
    place.run(&["compile", "./a.nc", "-o", "a.nc"]).ends(2);
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("a.nc", place.path("link")).unwrap();
        place.run(&["compile", "a.nc", "-o", "link"]).ends(2).says("what the stream is made from");
    }
    assert_eq!(place.read("a.nc"), GOOD.as_bytes());
    let macrocycle = "N1 G79 L5\nN2 G70\n";
    place.put("L5", macrocycle);
    place.put("b.nc", "%1\nN10 G72 L5\nN20 M30\n");
    place.run(&["compile", "b.nc", "-o", "L5"]).ends(2).says("what the stream is made from");
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
    // What the value is for differs.
    for (lang, note) in
        [("en", "without it nothing is written from here on"), ("cs", "bez ní se od tohoto bloku nic nezapíše")]
    {
        let compiled = place.run(&["compile", "a.nc", "--lang", lang]);
        assert!(compiled.stderr.contains(note), "{compiled:?}");
    }
    for level in ["-W", "-D"] {
        let checked = place.run(&["check", "a.nc", level, "W0503"]).stdout;
        assert!(checked.contains("what depends on it is not checked"), "{checked}");
    }
    place.run(&["compile", "a.nc", "--param", "R10=5"]).ends(0);
}

#[test]
fn what_is_no_program_gives_status_2() {
    let place = Place::with(&[("L9001", b"N1 G79 L9001 N2 G70"), ("out", b"old")]);
    place.run(&["compile", "L9001", "-o", "out"]).ends(2).says("it is a macrocycle");
    place.run(&["compile", "missing.nc", "-o", "out"]).ends(2).says("E0112");
    place.run(&["compile", ".", "-o", "out"]).ends(2).says("it is a folder");
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

/// command-line.md: -o never replaces what the run has read.
#[test]
fn what_was_read_is_not_overwritten() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("cnc872c.toml", b"# ours\n"), ("my.toml", b"# mine\n")]);
    place.put("ch.xml", "<ChannelConfig><MFunctions><MFunc No=\"60\"/></MFunctions></ChannelConfig>");
    for line in [
        &["-o", "cnc872c.toml"][..],
        &["--config", "my.toml", "-o", "my.toml"],
        &["--channel-config", "ch.xml", "-o", "ch.xml"],
    ] {
        let output = line[line.len() - 1];
        let before = place.read(output);
        place.run(&[&["compile", "a.nc"], line].concat()).ends(2).says("what the stream is made from");
        assert_eq!(place.read(output), before, "{output}");
    }
    // A hard link is the same file by another name.
    fs::hard_link(place.path("a.nc"), place.path("b.nc")).unwrap();
    #[cfg(unix)]
    place.run(&["compile", "a.nc", "-o", "b.nc"]).ends(2);
    assert_eq!(place.list(), ["a.nc", "b.nc", "ch.xml", "cnc872c.toml", "my.toml"]);
    place.run(&["compile", "a.nc", "-o", "other.toml"]).ends(0);
}

/// Files are compared as files: names may be in an old code page.
#[cfg(unix)]
#[test]
fn names_that_are_not_utf8() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let place = Place::with(&[]);
    let folder = place.path("").join(OsStr::from_bytes(b"m\xff"));
    fs::create_dir(&folder).unwrap();
    let macrocycle = "N1 G79 L9001\nN2 G70\n";
    fs::write(folder.join("L9001"), macrocycle).unwrap();
    fs::write(folder.join("p.nc"), "%1\nN10 G72 L9001\nN20 M30\n").unwrap();
    let mut command = place.command(&["compile"]);
    command.arg(folder.join("p.nc")).arg("-o").arg(folder.join("L9001"));
    assert_eq!(command.output().unwrap().status.code(), Some(2));
    assert_eq!(fs::read_to_string(folder.join("L9001")).unwrap(), macrocycle);
    // Two files of one text are two.
    let bad = [&b"bad\xff.nc"[..], b"bad\xfe.nc"].map(|name| place.path("").join(OsStr::from_bytes(name)));
    let mut command = place.command(&["check", "--format", "short"]);
    for file in &bad {
        fs::write(file, BAD).unwrap();
        command.arg(file);
    }
    let run = Run::of(command.output().unwrap()).ends(1);
    assert_eq!(run.stdout.matches("[E0306]").count(), 2, "{run:?}");
    assert!(run.stdout.contains("bad\\xff.nc:2:") && run.stdout.contains("bad\\xfe.nc:2:"), "{run:?}");
}

/// Where the system gives no threads, one does the work: the stack that is asked for is more than there is.
#[cfg(target_os = "linux")]
#[test]
fn a_run_without_threads() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("b.nc", BAD.as_bytes())]);
    let long: String = (2..60_000).map(|n| format!("N{n} X{n}\n")).collect();
    place.put("c.nc", format!("%1\nN1 G0 G90 X0\n{long}N60000 M30\n"));
    let alone = |arguments: &[&str]| {
        Run::of(place.command(arguments).env("RUST_MIN_STACK", (1_u64 << 46).to_string()).output().unwrap())
    };
    let expected = place.run(&["compile", "c.nc"]).ends(0);
    assert!(alone(&["compile", "c.nc"]).ends(0).stdout == expected.stdout);
    assert!(alone(&["check", ".", "--format", "short"]).ends(1).stdout.contains("[E0306]"));
}

/// command-line.md: `-o` never replaces what the run has read, also when it came by standard input.
#[cfg(target_os = "linux")]
#[test]
fn the_file_behind_standard_input_is_kept() {
    let place = Place::with(&[("p.nc", b"%1\nN1 G90 G0 X0\nN2 M30\n")]);
    for command in ["compile", "motion", "plc", "view"] {
        let input = fs::File::open(place.path("p.nc")).unwrap();
        let output = place.command(&[command, "-", "-o", "p.nc"]).stdin(input).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{command}: {output:?}");
        assert_eq!(place.read("p.nc"), b"%1\nN1 G90 G0 X0\nN2 M30\n", "{command}");
    }
}
