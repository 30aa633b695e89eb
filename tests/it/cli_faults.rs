//! Faults around a run, on the real binary: full disks, files that cannot be read or that change meanwhile, what is no
//! file at all, readers that go away, interruptions. The old file is whole, the message says what happened, the status
//! is right.
#![cfg(unix)]

use std::fs;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::symlink;
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::cli::{BAD, GOOD, Place, Run, closed_pipe, make_fifo};

/// Two hours at the machine: executes some hundred million blocks, longer than any test waits.
const LONG: &str = "%1\nN10 G0 G90 X0\nN20 G1 X1 F100\nN30 G73 L20 Q9999\nN40 G73 L20 Q9999\nN50 M30\n";

/// The same with a fix.
const LONG_TO_FIX: &str = "%1\nn10 g0 g90 x0\nn20 g1 x1 f100\nn30 g73 l20 q9999\nn40 g73 l20 q9999\nn50 m30\n";

/// What happens to the files of a run.
type Event = fn(&Place);

const CALL: &str = "%1\nN10 G72 L9001\nN20 M30\n";

const FORMATS: [&str; 5] = ["human", "short", "json", "sarif", "github"];

/// Longer than anything here takes.
const HANG: Duration = Duration::from_secs(120);

/// A program whose stream is long.
fn big() -> String {
    (1..2000).fold("%1\nN9998 G90 G0 X0\n".to_owned(), |text, n| text + &format!("N{n} X{n}\n")) + "N9999 M30\n"
}

/// A disk that holds no more than a kilobyte for each file: the limit on file sizes, whose signal ends other programs.
fn on_a_small_disk(place: &Place, arguments: &[&str]) -> Run {
    let limit = "ulimit -f 1; exec \"$0\" \"$@\"";
    Run::of(place.command_through(&["sh", "-c", limit], arguments).output().unwrap())
}

/// A cache that cannot be written, or is none: the table is whole, and the message names the cache.
#[test]
fn a_cache_that_cannot_be_written() {
    let place = Place::with(&[("taken", b"")]);
    (0..20).for_each(|at| place.put(&format!("in/{at}.nc"), GOOD));
    let run = on_a_small_disk(&place, &["stats", "in", "--cache", "cache"]).ends(2);
    assert_eq!(run.stdout.lines().count(), 20, "{run:?}");
    assert_eq!(run.stderr, "error: cannot write cache: it is too large\n");
    place.run(&["stats", "in", "--cache", "taken"]).ends(2).says("cannot write taken: something else has this name");
}

/// A run with these signals ignored, as soon as it writes its file beside the two of the place.
fn writing_with_ignored(place: &Place, signals: &str, arguments: &[&str]) -> Child {
    let ignoring = format!("trap '' {signals}; exec \"$0\" \"$@\"");
    let mut command = place.command_through(&["sh", "-c", &ignoring], arguments);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    wait_until("it writes", || place.list().len() == 3);
    child
}

fn signal(child: &Child, name: &str) {
    let kill = Command::new("sh").args(["-c", &format!("kill -{name} {}", child.id())]).status().unwrap();
    assert!(kill.success());
}

/// Waits until that holds.
fn wait_until(what: &str, mut holds: impl FnMut() -> bool) {
    let start = Instant::now();
    while !holds() {
        assert!(start.elapsed() < HANG, "{what}");
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn a_file_on_a_full_disk_stays() {
    let place = Place::with(&[("a.nc", big().as_bytes()), ("out", b"old")]);
    let run = on_a_small_disk(&place, &["compile", "a.nc", "-o", "out"]).ends(2);
    assert_eq!(run.stderr, "error: cannot write out: it is too large\n");
    on_a_small_disk(&place, &["compile", "a.nc", "-o", "new", "--lang", "cs"]).ends(2).says("nelze zapsat new: soubor");
    assert_eq!(place.read("out"), b"old");
    assert_eq!(place.list(), ["a.nc", "out"]);
}

#[test]
fn a_program_on_a_full_disk_stays() {
    let lower = big().to_lowercase();
    let place = Place::with(&[("a.nc", lower.as_bytes()), ("small.nc", b"%1\nn10 g90 g0 x1\nn20 m30\n")]);
    let run = on_a_small_disk(&place, &["check", "--fix", "a.nc", "small.nc", "--format", "short"]).ends(2);
    assert!(run.stderr.contains("error: cannot write a.nc: it is too large\n"), "{run:?}");
    assert!(run.stderr.contains("small.nc: 1 fix applied\n"), "the other one is fixed: {run:?}");
    assert!(run.stdout.contains("a.nc:2:1: warning[W0108]"), "the finding is still there: {run:?}");
    assert_eq!(place.read("a.nc"), lower.as_bytes());
    assert_eq!(place.read("small.nc"), b"%1\nN10 G90 G0 X1\nN20 M30\n");
    assert_eq!(place.list(), ["a.nc", "small.nc"]);
}

#[cfg(target_os = "linux")]
#[test]
fn findings_for_a_full_disk() {
    let lower = b"%1\nn10 g0 g90 x0 x1\nn20 m30\n";
    let place = Place::with(&[("a.nc", lower)]);
    let full = || crate::cli::open_for_writing("/dev/full");
    for format in FORMATS {
        place.run_into(&["check", "a.nc", "--format", format], full()).ends(2).says("the disk is full");
    }
    place.run_into(&["check", "a.nc", "--lang", "cs"], full()).ends(2).says("disk je plný");
    // The fix is made, and its findings cannot be told.
    let run = place.run_into(&["check", "a.nc", "--fix"], full()).ends(2).says("the disk is full");
    assert!(run.stderr.contains("1 fix applied"), "{run:?}");
    assert_eq!(place.read("a.nc"), b"%1\nN10 G0 G90 X0 X1\nN20 M30\n");
    // Findings of compile go to stderr: nobody can be told, and the status still is.
    let status = place.command(&["compile", "a.nc"]).stdout(Stdio::null()).stderr(full()).status().unwrap();
    assert_eq!(status.code(), Some(1));
}

/// A macrocycle that is there and cannot be read is named at its call, and the status is 2.
#[test]
fn macrocycles_that_cannot_be_read() {
    let spoil: [(Event, &str, &str); 3] = [
        (|place| make_fifo(&place.path("m/L9001")), "it is not a regular file", "není to obyčejný soubor"),
        (|place| symlink("nothing", place.path("m/L9001")).unwrap(), "a link that leads to no file", "je to odkaz"),
        (|place| symlink("L9001", place.path("m/L9001")).unwrap(), "a link that leads to no file", "je to odkaz"),
    ];
    for (spoil, en, cs) in spoil {
        let place = Place::with(&[("a.nc", CALL.as_bytes()), ("m/x", b""), ("out", b"old")]);
        spoil(&place);
        let run = place.run(&["check", "a.nc", "-L", "m", "--format", "short"]).ends(2);
        assert!(run.stdout.starts_with("a.nc:2:10: error[E0112]: m/L9001 cannot be read: "), "{run:?}");
        assert!(run.stdout.contains(en) && run.stdout.lines().count() == 1, "{run:?}");
        let run = place.run(&["check", "a.nc", "-L", "m", "--lang", "cs"]).ends(2);
        assert!(run.stdout.contains("m/L9001 nelze přečíst: ") && run.stdout.contains(cs), "{run:?}");
        place.run(&["compile", "a.nc", "-L", "m", "-o", "out"]).ends(2).says("m/L9001 cannot be read");
        assert_eq!(place.read("out"), b"old");
        // Called by a number that only execution knows.
        place.put("b.nc", "%1\nN10 R1=9001\nN20 G72 LR1\nN30 M30\n");
        place.run(&["compile", "b.nc", "-L", "m", "-o", "out"]).ends(2).says("m/L9001 cannot be read");
        assert_eq!(place.read("out"), b"old");
        // That a macrocycle is broken does not keep the program from being fixed.
        place.put("c.nc", CALL.to_lowercase());
        place.run(&["check", "--fix", "c.nc", "-L", "m"]).ends(2);
        assert_eq!(place.read("c.nc"), CALL.as_bytes());
    }
}

/// A folder is no macrocycle, and bytes of any kind are a text with findings.
#[test]
fn macrocycles_that_are_none() {
    let place = Place::with(&[("a.nc", CALL.as_bytes()), ("L9001/L9001", b""), ("out", b"old")]);
    place.run(&["compile", "a.nc", "-o", "out"]).ends(1).says("macrocycle L9001 is not on the search path");
    assert_eq!(place.read("out"), b"old");
    fs::remove_dir_all(place.path("L9001")).unwrap();
    let bytes: Vec<u8> = (0..4000_u32).map(|n| u8::try_from(n * n * 7 % 251).unwrap() ^ 0x80).collect();
    place.put("L9001", &bytes);
    let run = place.run(&["check", "a.nc", "--format", "short"]).ends(1);
    assert!(run.stdout.lines().all(|line| line.starts_with("L9001:")) && !run.stdout.is_empty(), "{run:?}");
    place.run(&["compile", "a.nc", "-o", "out"]).ends(1).says("L9001");
    assert_eq!(place.read("out"), b"old");
    assert_eq!(place.read("L9001"), bytes);
}

/// A folder, a pipe, a link to nothing in place of a configuration: never passed over, never waited for.
#[test]
fn configurations_that_are_no_files() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("folder/x", b"")]);
    make_fifo(&place.path("pipe"));
    symlink("nothing", place.path("broken")).unwrap();
    symlink("ring", place.path("ring")).unwrap();
    let said = [
        ("folder", "`folder` is a directory", "folder je složka"),
        ("pipe", "`pipe` is not a regular file", "pipe není obyčejný soubor"),
        ("broken", "`broken` is a link that leads to no file", "broken je odkaz, který k žádnému souboru nevede"),
        ("ring", "`ring` is a link that leads to no file", "ring je odkaz, který k žádnému souboru nevede"),
        ("missing", "there is no file `missing`", "soubor missing neexistuje"),
    ];
    for (file, en, cs) in said {
        for option in ["--config", "--channel-config"] {
            let run = place.run(&["check", "a.nc", option, file, "--format", "short"]).ends(2);
            let expected = format!("{file}:1:1: error[E0701]: the configuration cannot be read: {en}\n");
            assert_eq!((run.stdout, run.stderr), (expected, String::new()));
            place.run(&["compile", "a.nc", option, file, "--lang", "cs"]).ends(2).says(cs);
        }
        let place_in_project = "cnc872c.toml:1:18: error[E0701]";
        place.put("cnc872c.toml", format!("channel-config = \"{file}\"\n"));
        let run = place.run(&["check", "a.nc", "--format", "short"]).ends(2);
        assert!(run.stdout.starts_with(place_in_project) && run.stdout.contains(en), "{run:?}");
        fs::remove_file(place.path("cnc872c.toml")).unwrap();
    }
    // As the project file itself. A folder of that name is none.
    for (file, status) in [("pipe", 2), ("broken", 2), ("ring", 2), ("folder", 0)] {
        let here = Place::with(&[("a.nc", GOOD.as_bytes())]);
        match file {
            "pipe" => make_fifo(&here.path("cnc872c.toml")),
            "broken" => symlink("nothing", here.path("cnc872c.toml")).unwrap(),
            "ring" => symlink("cnc872c.toml", here.path("cnc872c.toml")).unwrap(),
            _ => fs::create_dir(here.path("cnc872c.toml")).unwrap(),
        }
        let run = here.run(&["check", "a.nc", "--format", "short"]).ends(status);
        assert_eq!(run.stdout.starts_with("cnc872c.toml:1:1: error[E0701]"), status == 2, "{file}: {run:?}");
    }
}

/// §13 Configuration: search paths that are no folders are wrong usage on the command line, E0702 in the project file.
#[test]
fn search_paths_that_are_no_folders() {
    let place = Place::with(&[("a.nc", CALL.as_bytes()), ("file", b"")]);
    make_fifo(&place.path("pipe"));
    symlink("ring", place.path("ring")).unwrap();
    symlink("folder", place.path("link")).unwrap();
    fs::create_dir(place.path("folder")).unwrap();
    for name in ["file", "pipe", "ring", "missing"] {
        place
            .run(&["check", "a.nc", "-L", "folder", "-L", name])
            .ends(2)
            .says(&format!("-L {name}: there is no such folder"));
        fs::write(place.path("cnc872c.toml"), format!("macrocycles = ['folder', '{name}']\n")).unwrap();
        let run = place.run(&["check", "a.nc", "--format", "short"]).ends(2);
        assert!(run.stdout.starts_with("cnc872c.toml:1:26: error[E0702]"), "{run:?}");
        fs::remove_file(place.path("cnc872c.toml")).unwrap();
    }
    let run = place.run(&["check", "a.nc", "-L", "folder", "-L", "link"]).ends(1);
    assert!(run.stdout.contains("note: searched: folder, link"), "{run:?}");
}

#[test]
fn programs_that_are_no_files() {
    let place = Place::with(&[("folder/x", b""), ("out", b"old")]);
    symlink("nothing", place.path("broken.nc")).unwrap();
    symlink("ring.nc", place.path("ring.nc")).unwrap();
    for (file, en) in [("broken.nc", "it is a link that leads to no file"), ("ring.nc", "it is a link that leads to")] {
        let run = place.run(&["check", file, "--format", "short"]).ends(2);
        let expected = format!("{file}:1:1: error[E0112]: the file cannot be read: {en}");
        assert!(run.stdout.starts_with(&expected) && run.stderr.is_empty(), "{run:?}");
        place.run(&["check", "--fix", file]).ends(2);
        place.run(&["compile", file, "-o", "out", "--lang", "cs"]).ends(2).says("je to odkaz");
    }
    let run = place.run(&["check", "folder/x/y.nc", "--format", "short", "--lang", "cs"]).ends(2);
    assert!(run.stdout.ends_with("soubor nelze přečíst: soubor je zde uveden jako složka\n"), "{run:?}");
    place.run(&["compile", "folder", "-o", "out"]).ends(2).says("it is a folder");
    place.run(&["check", "--fix", "folder"]).ends(2).says("no program found in folder");
    assert_eq!(place.read("out"), b"old");
}

/// The link of a ring cannot be written to either.
#[test]
fn outputs_that_cannot_be_files() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("file", b"")]);
    symlink("ring", place.path("ring")).unwrap();
    for output in ["ring", "file/out", "/dev/null/out", ""] {
        let run = place.run(&["compile", "a.nc", "-o", output]).ends(2);
        assert!(run.stdout.is_empty() && run.stderr.starts_with("error: "), "{run:?}");
    }
    assert_eq!(place.list(), ["a.nc", "file", "ring"]);
}

/// Its processor time in hundredths of a second.
#[cfg(target_os = "linux")]
fn processor_time(child: &Child) -> u64 {
    let stat = fs::read_to_string(format!("/proc/{}/stat", child.id())).unwrap();
    let numbers: Vec<&str> = stat.rsplit(')').next().unwrap().split_whitespace().collect();
    numbers[11].parse().unwrap()
}

/// A program that an editor writes to while `--fix` works on it is the editor's: not overwritten, not brought back.
#[cfg(target_os = "linux")]
#[test]
fn a_program_that_changes_while_it_is_fixed() {
    const THEIRS: &str = "%1\nN10 G0 G90 X7\nN20 M30\n";
    let grown = format!("{LONG_TO_FIX}\"theirs\n");
    let change: [(Event, Option<&str>, &str); 4] = [
        // It grows.
        (
            |place| {
                use std::io::Write;
                let mut file = fs::OpenOptions::new().append(true).open(place.path("a.nc")).unwrap();
                file.write_all(b"\"theirs\n").unwrap();
            },
            Some(&grown),
            "a.nc: not fixed, because it changed meanwhile",
        ),
        // It shrinks.
        (|place| place.put("a.nc", THEIRS), Some(THEIRS), "a.nc: not fixed, because it changed meanwhile"),
        // It is replaced.
        (
            |place| {
                place.put("theirs", THEIRS);
                fs::rename(place.path("theirs"), place.path("a.nc")).unwrap();
            },
            Some(THEIRS),
            "neopraveno, protože se soubor mezitím změnil",
        ),
        // It goes away.
        (|place| fs::remove_file(place.path("a.nc")).unwrap(), None, "cannot write a.nc: no such file"),
    ];
    for (change, after, said) in change {
        let place = Place::with(&[("a.nc", LONG_TO_FIX.as_bytes())]);
        let lang = if said.is_ascii() { "en" } else { "cs" };
        let line = ["check", "--fix", "a.nc", "--max-blocks", "300000", "--format", "short", "--lang", lang];
        let child = place.interruptible(&line).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // It has read the program when it executes it, which takes longer by far.
        wait_until("the program is executed", || processor_time(&child) >= 5);
        signal(&child, "STOP");
        change(&place);
        signal(&child, "CONT");
        let run = Run::of(child.wait_with_output().unwrap()).ends(2);
        assert!(run.stderr.contains(said), "{run:?}");
        assert_eq!(place.path("a.nc").exists().then(|| place.read("a.nc")).as_deref(), after.map(str::as_bytes));
        assert_eq!(place.list().len(), usize::from(after.is_some()), "nothing is left beside it");
    }
}

/// A program that grows and shrinks while it is read is one text or another, or a finding.
#[test]
fn a_program_that_changes_while_it_is_read() {
    use std::sync::atomic::{AtomicBool, Ordering};
    let long = big();
    let place = Place::with(&[("a.nc", long.as_bytes())]);
    let done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            for length in (0..long.len()).rev().step_by(97).cycle() {
                if done.load(Ordering::Relaxed) {
                    break;
                }
                fs::write(place.path("a.nc"), &long[..length]).unwrap();
            }
        });
        let runs: Vec<Run> = (0..20).map(|_| place.run(&["check", "a.nc", "--format", "json"])).collect();
        done.store(true, Ordering::Relaxed);
        for run in runs {
            // The finding is that of a file that is written to all the time.
            assert!(matches!(run.code, Some(0..=2)) && run.stderr.is_empty(), "{run:?}");
            assert!(run.code != Some(2) || run.stdout.contains("E0112"), "{run:?}");
            let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
            assert_eq!(json["summary"]["files"], 1);
        }
    });
}

#[test]
fn readers_that_go_away() {
    let place = Place::with(&[("a.nc", b"%1\nn10 g0 g90 x0 x1\nn20 m30\n"), ("good.nc", GOOD.as_bytes())]);
    // The fix is made even when nobody reads what is left.
    place.run_into(&["check", "--fix", "a.nc"], closed_pipe()).ends(1);
    assert_eq!(place.read("a.nc"), b"%1\nN10 G0 G90 X0 X1\nN20 M30\n");
    let status = place.command(&["compile", "a.nc"]).stdout(Stdio::null()).stderr(closed_pipe()).status().unwrap();
    assert_eq!(status.code(), Some(1), "the program has an error, whoever reads it");
    // A pipe after -o.
    let pipe = place.path("pipe");
    make_fifo(&pipe);
    let reader = std::thread::spawn(move || drop(fs::File::open(pipe).unwrap()));
    place.put("long.nc", LONG);
    let run = place.run(&["compile", "long.nc", "-o", "pipe", "--max-blocks", "1000000000"]).ends(0);
    reader.join().unwrap();
    assert_eq!((run.stdout, run.stderr), (String::new(), String::new()));
}

/// `compile … | head -1`, and the same of findings: the rest is not computed.
#[test]
fn readers_that_go_away_in_the_middle() {
    let place = Place::with(&[("long.nc", LONG.as_bytes()), ("many.nc", b"")]);
    place.put("many.nc", "%1\n".to_owned() + &"N1 X1 X2\n".repeat(20_000));
    for (line, status) in [
        (&["compile", "long.nc", "--max-blocks", "1000000000"][..], 0),
        (&["check", "many.nc", "--all"], 1),
        (&["check", "many.nc", "--format", "short"], 1),
        (&["check", "many.nc", "--format", "github"], 1),
    ] {
        let start = Instant::now();
        let mut child = place.command(line).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut output = BufReader::new(child.stdout.take().unwrap());
        let mut first = String::new();
        output.read_line(&mut first).unwrap();
        assert!(first.ends_with('\n'), "{first}");
        drop(output);
        let run = Run::of(child.wait_with_output().unwrap()).ends(status);
        assert_eq!(run.stderr, "", "{line:?}");
        assert!(start.elapsed() < HANG);
    }
}

/// Every signal that ends a run leaves the old file and nothing else.
#[test]
fn signals_in_the_middle_of_an_output() {
    for (name, number) in [("INT", 2), ("TERM", 15), ("HUP", 1)] {
        let place = Place::with(&[("a.nc", LONG.as_bytes()), ("out", b"old")]);
        let line = ["compile", "a.nc", "-o", "out", "--max-blocks", "1000000000", "--lang", "cs"];
        let child = place.interruptible(&line).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        wait_until("it writes", || place.list().len() == 3);
        signal(&child, name);
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.signal(), Some(number), "{output:?}");
        let run = Run::of(output);
        assert_eq!(run.stderr, "chyba: přerušeno; žádný soubor nezůstal zapsaný napůl\n");
        assert_eq!(place.read("out"), b"old");
        assert_eq!(place.list(), ["a.nc", "out"]);
    }
}

/// A run that only reads and computes ends by the signal too, and says nothing of what it has not finished.
#[cfg(target_os = "linux")]
#[test]
fn signals_in_the_middle_of_a_computation() {
    let place = Place::with(&[("a.nc", LONG.as_bytes()), ("b.nc", LONG.as_bytes())]);
    // Processor time in ticks, of which there are a hundred a second: fields 14 and 15, the name before them is in
    // brackets.
    let busy = |child: &Child| -> u64 {
        let stat = fs::read_to_string(format!("/proc/{}/stat", child.id())).unwrap();
        let fields: Vec<&str> = stat.rsplit_once(')').unwrap().1.split_whitespace().collect();
        fields[11].parse::<u64>().unwrap() + fields[12].parse::<u64>().unwrap()
    };
    for line in [&["state", "a.nc", "--n", "50"][..], &["compare", "a.nc", "b.nc"], &["motion", "a.nc"]] {
        let line = [line, &["--max-blocks", "1000000000"]].concat();
        let child = place.interruptible(&line).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        wait_until("it computes", || busy(&child) >= 10);
        signal(&child, "TERM");
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.signal(), Some(15), "{line:?}: {output:?}");
        assert!(output.stdout.is_empty(), "{line:?}: {output:?}");
        assert_eq!(place.list(), ["a.nc", "b.nc"]);
    }
}

/// Interrupted among many files: each is as before or fixed, whole, and no other file is left.
#[test]
fn an_interruption_while_many_programs_are_fixed() {
    let after = format!("%1\nN10 G0 G90 X0\n{}N20 M30\n", "\"COMMENT\n".repeat(500));
    let before = after.replace("N10 G0 G90 X0", "n10 g0 g90 x0");
    let names: Vec<String> = (0..150).map(|number| format!("{number:03}.nc")).collect();
    let mut cut = 0;
    for wait in [1, 20, 60] {
        let files: Vec<(&str, &[u8])> = names.iter().map(|name| (name.as_str(), before.as_bytes())).collect();
        let place = Place::with(&files);
        let is_fixed = |name: &String| place.read(name) == after.as_bytes();
        let child = place.interruptible(&["check", "--fix", "."]).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
        let mut child = child.unwrap();
        // In the middle of it: when so many are fixed.
        wait_until("files are fixed", || names.iter().filter(|name| is_fixed(name)).count() >= wait);
        signal(&child, "INT");
        let status = child.wait().unwrap();
        let fixed = names.iter().filter(|name| is_fixed(name)).count();
        assert!(names.iter().all(|name| is_fixed(name) || place.read(name) == before.as_bytes()));
        assert_eq!(place.list(), names, "nothing is left beside them");
        match status.signal() {
            Some(2) => cut += usize::from(fixed < names.len()),
            // It was done before the signal came.
            _ => assert_eq!((status.code(), fixed), (Some(0), names.len())),
        }
    }
    assert!(cut > 0, "no run was cut off");
}

/// A program with errors, and a signal that is not for it: what `nohup` ignores stays ignored.
#[test]
fn ignored_signals_stay_ignored() {
    let place = Place::with(&[("a.nc", LONG.as_bytes()), ("bad.nc", BAD.as_bytes())]);
    let line = ["compile", "a.nc", "-o", "out", "--max-blocks", "300000"];
    let child = writing_with_ignored(&place, "HUP INT TERM", &line);
    signal(&child, "HUP");
    let run = Run::of(child.wait_with_output().unwrap()).ends(1);
    assert!(run.stderr.contains("E0410"), "{run:?}");
    assert_eq!(place.list(), ["a.nc", "bad.nc"]);
}

/// A signal that ends the run is heard though another one is ignored, as of jobs in the background.
#[test]
fn an_ignored_signal_does_not_hide_the_others() {
    let place = Place::with(&[("a.nc", LONG.as_bytes()), ("out", b"old")]);
    let line = ["compile", "a.nc", "-o", "out", "--max-blocks", "1000000000"];
    let child = writing_with_ignored(&place, "INT", &line);
    signal(&child, "INT");
    signal(&child, "TERM");
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.signal(), Some(15), "{output:?}");
    let run = Run::of(output);
    assert!(run.stderr.contains("no file is left half written"), "{run:?}");
    assert_eq!(place.read("out"), b"old");
    assert_eq!(place.list(), ["a.nc", "out"]);
}

/// A program that is written anew in place, with the same length, is one of its versions or E0112, never both: unless
/// the writer waits so long between two pieces that nobody can tell them from the end.
#[test]
fn a_program_is_never_read_as_halves_of_two() {
    use std::io::{Seek, SeekFrom, Write};
    use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
    let version = |x: u32| {
        let blocks: String = (2..20_000).map(|n| format!("N{n} X{x} Y{x}\n")).collect();
        format!("%1\nN1 G90 G00 X{x}\n{blocks}N20000 M30\n").into_bytes()
    };
    let versions = [version(111), version(222)];
    let place = Place::with(&[("a.nc", &versions[0])]);
    let done = AtomicBool::new(false);
    // How many pieces were written, and the longest wait between two of them, in milliseconds.
    let (pieces, longest) = (AtomicU64::new(0), AtomicU64::new(0));
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let mut file = fs::OpenOptions::new().write(true).open(place.path("a.nc")).unwrap();
            let mut last = Instant::now();
            for bytes in versions.iter().cycle() {
                if done.load(Ordering::Relaxed) {
                    break;
                }
                file.seek(SeekFrom::Start(0)).unwrap();
                for piece in bytes.chunks(1 << 14) {
                    file.write_all(piece).unwrap();
                    longest.fetch_max(last.elapsed().as_millis() as u64, Ordering::SeqCst);
                    pieces.fetch_add(1, Ordering::SeqCst);
                    last = Instant::now();
                    std::thread::yield_now();
                }
                std::thread::sleep(Duration::from_millis(7));
            }
        });
        let judged = || {
            longest.store(0, Ordering::SeqCst);
            let run = place.run(&["compile", "a.nc"]);
            // A wait that began meanwhile ends with the next piece.
            let (seen, ended) = (pieces.load(Ordering::SeqCst), Instant::now());
            while pieces.load(Ordering::SeqCst) == seen && ended.elapsed() < HANG {
                std::thread::sleep(Duration::from_millis(1));
            }
            (longest.load(Ordering::SeqCst) < 80).then_some(run)
        };
        let begun = Instant::now();
        let tried = std::iter::repeat_with(judged).take_while(|_| begun.elapsed() < HANG);
        let runs: Vec<Run> = tried.flatten().take(12).collect();
        done.store(true, Ordering::Relaxed);
        assert_eq!(runs.len(), 12, "the writer rests all the time");
        for run in runs {
            let both = run.stdout.contains("111") && run.stdout.contains("\"X\":222");
            assert!(!both, "halves of two versions");
            assert!(run.code == Some(0) || run.stderr.contains("E0112"), "{:?} {}", run.code, run.stderr);
        }
    });
}

/// Each command that writes to standard output reports data that would be lost.
#[cfg(target_os = "linux")]
#[test]
fn a_closed_standard_output() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    let run = |redirected: &str, line: &[&str]| {
        let script = format!("exec \"$@\" {redirected}");
        Run::of(place.command_through(&["sh", "-c", &script, "sh"], line).output().unwrap())
    };
    for line in [
        &["check", "a.nc"][..],
        &["check", "a.nc", "--format", "json"],
        &["check", "a.nc", "--diff"],
        &["compile", "a.nc"],
        &["compile", "a.nc", "-o", "/dev/stdout"],
        &["motion", "a.nc"],
        &["plc", "a.nc"],
        &["plc", "--list"],
        &["report", "a.nc"],
        &["view", "a.nc", "-o", "-"],
        &["format", "-"],
        &["explain", "G01"],
        &["schema"],
        &["man"],
        &["--help"],
        &["--version"],
    ] {
        run(">&-", line).ends(2).says("standard output is closed");
        run("> /dev/null", line).ends(0);
        // What programs give that throw the output away.
        run("1<> /dev/null", line).ends(0);
    }
    run(">&-", &["compile", "a.nc", "-o", "out"]).ends(0);
    for command in ["format", "renumber"] {
        run(">&-", &[command, "--check", "a.nc"]).ends(2).says("standard output is closed");
        run(">&-", &[command, "a.nc"]).ends(0);
    }
}

/// project-file.md: with `encoding = "utf-8"` other files are E0112, which names the byte.
#[test]
fn only_utf_8() {
    let program = b"%1\nN10 G0 X0 \"p\xf8iruba\"\nN20 M30\n";
    let place = Place::with(&[("a.nc", program), ("cnc872c.toml", b"encoding = \"utf-8\"\n")]);
    let run = place.run(&["check", "a.nc"]).ends(2);
    assert!(run.stdout.contains("byte F8h in line 2"), "{}", run.stdout);
    place.put("a.nc", "%1\nN10 G0 X0 \"příruba\"\nN20 M30\n");
    place.run(&["check", "a.nc"]).ends(0);
    place.put("a.nc", program);
    place.put("cnc872c.toml", "");
    place.run(&["check", "a.nc"]).ends(0);
    place.run(&["check", "a.nc", "--encoding", "utf-8"]).ends(2);
}
