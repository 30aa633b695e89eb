//! One program with one configuration has one exit status in all commands that execute it (command-line.md). Commands
//! whose status answers another question have theirs in all of these cases too.

use crate::cli::{BAD, GOOD, Place};

/// The commands that execute a program; what they make goes to a file.
const COMMANDS: [&[&str]; 8] = [
    &["compile", "a.nc", "-o", "out"],
    &["motion", "a.nc", "-o", "out"],
    &["motion", "a.nc", "-o", "out", "--format", "json"],
    &["plc", "a.nc", "-o", "out"],
    &["report", "a.nc", "-o", "out"],
    &["report", "a.nc", "-o", "out", "--format", "json"],
    &["view", "a.nc", "-o", "out.html"],
    &["view", "a.nc", "-o", "out.svg"],
];

/// A machine with joints to judge, and radii of corrections.
const MACHINE: &str = "[motion]\nprofile = \"ramps\"\n\n[corrections.1]\nradius = 5.0\n";

/// A corner that motion stops in, a correction without an entry, a pocket narrower than the tool.
const CORNER: &str = "%1\nN10 G90 G23 G00 X0 Y0\nN20 G01 X10 F1000\nN30 Y10\nN40 X20\nN50 Y30\nN60 M30\n";
const NO_ENTRY: &str = "%1\nN10 G90 G17 G00 X0 Y0 D7\nN20 G41 G01 X10 F100\nN30 Y10\nN40 G40 X0\nN50 M30\n";
const NARROW: &str =
    "%1\nN10 G90 G17 G00 X0 Y0 D1\nN20 G41 G01 X10 F100\nN30 Y2\nN40 X14\nN50 Y20\nN60 G40 X0\nN70 M30\n";
const EMPTY: &str = "%1\nN10 G90 G00 X0\nN20\nN30 M30\n";
const MISSING: &str = "%1\nN10 G90 G00 X0\nN20 G72 L77\nN30 G02 X5\nN40 M30\n";
const ENDLESS: &str = "%1\nN10 G90 G00 X0\nN20 G73 L10\nN30 M30\n";

const LEVELS: [&[&str]; 8] = [
    &[],
    &["-D", "W0801"],
    &["-D", "W0802"],
    &["-D", "W0803"],
    &["-D", "W0811"],
    &["-D", "W0812"],
    &["-D", "empty-block", "-D", "W0604"],
    &["-A", "W0812", "-W", "W0801"],
];

#[test]
fn one_status_in_all_commands() {
    for (name, program) in [
        ("good", GOOD),
        ("bad", BAD),
        ("corner", CORNER),
        ("no entry", NO_ENTRY),
        ("narrow", NARROW),
        ("empty block", EMPTY),
        ("missing macrocycle", MISSING),
        ("endless", ENDLESS),
    ] {
        let files = [("a.nc", program), ("b.nc", program), ("cnc872c.toml", MACHINE)];
        let place = Place::with(&files.map(|(name, text)| (name, text.as_bytes())));
        let last = program.lines().count().to_string();
        for (at, levels) in LEVELS.iter().enumerate() {
            // These are errors at all levels.
            if at > 0 && matches!(name, "bad" | "missing macrocycle" | "endless") {
                break;
            }
            let limit = ["--max-blocks", "1000"];
            let status = place.run(&[&["check", "a.nc"], *levels, &limit].concat()).code;
            for command in COMMANDS {
                let line = [command, levels, &limit].concat();
                let run = place.run(&line);
                assert_eq!(run.code, status, "{name}: {line:?}\n{run:?}");
            }
            for (command, code) in others(status, &last) {
                let line = [command.as_slice(), levels, &limit].concat();
                let run = place.run(&line);
                assert_eq!(run.code, code, "{name}: {line:?}\n{run:?}");
            }
        }
    }
}

/// The commands that answer another question, with the status that they have where the others have `status`: `state`
/// behind the last block and `restart` have errors before their place, `compare` cannot compare a program with errors,
/// and facts and layout do not depend on errors.
fn others(status: Option<i32>, last: &str) -> [(Vec<&str>, Option<i32>); 8] {
    let compared = Some(if status == Some(0) { 0 } else { 2 });
    [
        (vec!["state", "a.nc", "--line", last, "--after"], status),
        (vec!["state", "a.nc", "--line", last, "--format", "json"], status),
        (vec!["restart", "a.nc", "--list"], status),
        (vec!["compare", "a.nc", "a.nc"], compared),
        (vec!["compare", "a.nc", "a.nc", "--format", "json"], compared),
        (vec!["stats", "a.nc"], Some(0)),
        (vec!["format", "b.nc"], Some(0)),
        (vec!["renumber", "b.nc"], Some(0)),
    ]
}

/// The levels above change the status of the programs above, or nothing would be shown.
#[test]
fn levels_change_the_status() {
    for (program, level) in [(CORNER, "W0801"), (NO_ENTRY, "W0812"), (NARROW, "W0811"), (EMPTY, "W0214")] {
        let place = Place::with(&[("a.nc", program.as_bytes()), ("cnc872c.toml", MACHINE.as_bytes())]);
        let run = place.run(&["check", "a.nc", "-D", level]).ends(1);
        assert!(run.stdout.contains(level), "{run:?}");
        place.run(&["check", "a.nc", "-A", level]).ends(0);
    }
}
