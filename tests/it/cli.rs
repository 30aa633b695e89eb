//! The command line on the real binary: help, languages, colours, explanations, wrong usage. Here is also what the
//! other modules of the kind use.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, SystemTime};

use tempfile::TempDir;

/// A program without a finding.
pub const GOOD: &str = "%1 \"PLATE\"\r\nN10 G0 G90 X0 Y0\r\nN20 G1 X10 F100\r\nN30 M30\r\n";

/// A program with one error, E0306.
pub const BAD: &str = "%1\nN10 G0 G90 X0 X5\nN20 M30\n";

/// Writes a file that looks as if it had been there for a while: the program waits for those just written to.
pub fn write_older(path: &Path, bytes: impl AsRef<[u8]>) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let mut file = fs::File::create(path).unwrap();
    file.write_all(bytes.as_ref()).unwrap();
    file.set_modified(SystemTime::now() - Duration::from_secs(1)).unwrap();
}

/// A folder for one test, and runs in it.
pub struct Place {
    folder: TempDir,
}

impl Place {
    /// With these files.
    pub fn with(files: &[(&str, &[u8])]) -> Self {
        let place = Self { folder: tempfile::tempdir().unwrap() };
        for (name, bytes) in files {
            place.put(name, bytes);
        }
        place
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Writes a file that looks as if it had been there for a while.
    pub fn put(&self, name: &str, bytes: impl AsRef<[u8]>) {
        write_older(self.path(name).as_ref(), bytes);
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }

    /// The names in the folder, sorted.
    pub fn list(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    /// The program in this folder, in an environment that says nothing about language and colours.
    pub fn command(&self, arguments: &[&str]) -> Command {
        self.command_through(&[], arguments)
    }

    /// The same, started by another program: its words come first.
    pub fn command_through(&self, starter: &[&str], arguments: &[&str]) -> Command {
        let words = [starter, &[env!("CARGO_BIN_EXE_cnc872c")], arguments].concat();
        let mut command = Command::new(words[0]);
        command.current_dir(self.folder.path()).args(&words[1..]).stdin(Stdio::null());
        for variable in ["LC_ALL", "LC_MESSAGES", "LANG", "NO_COLOR", "TERM", "CLICOLOR", "CLICOLOR_FORCE"] {
            command.env_remove(variable);
        }
        command
    }

    /// A command that signals end, even where this test was started with them ignored, as `nohup` and shells in the
    /// background do.
    pub fn interruptible(&self, arguments: &[&str]) -> Command {
        let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
        let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:")).unwrap_or("0");
        // HUP, INT, TERM.
        let of_interest = 1 | 1 << 1 | 1 << 14;
        if u64::from_str_radix(ignored.trim(), 16).unwrap() & of_interest == 0 {
            return self.command(arguments);
        }
        self.command_through(&["env", "--default-signal=HUP,INT,TERM"], arguments)
    }

    pub fn run(&self, arguments: &[&str]) -> Run {
        Run::of(self.command(arguments).output().unwrap())
    }

    pub fn run_with_stdin(&self, arguments: &[&str], input: &[u8]) -> Run {
        let mut command = self.command(arguments);
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // It may end without reading.
        let _ = child.stdin.take().unwrap().write_all(input);
        Run::of(child.wait_with_output().unwrap())
    }

    /// With standard output into that file, as `/dev/full`.
    pub fn run_into(&self, arguments: &[&str], output: impl Into<Stdio>) -> Run {
        let child = self.command(arguments).stdout(output).stderr(Stdio::piped()).spawn().unwrap();
        Run::of(child.wait_with_output().unwrap())
    }
}

/// What came of a run.
#[derive(Debug)]
pub struct Run {
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Run {
    pub fn of(output: Output) -> Self {
        Self {
            code: output.status.code(),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Asserts the exit status.
    #[track_caller]
    pub fn ends(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "{self:?}");
        self
    }

    /// Asserts that nothing went to stdout, and that stderr says this.
    #[track_caller]
    pub fn says(self, text: &str) -> Self {
        assert_eq!(self.stdout, "", "{self:?}");
        assert!(self.stderr.contains(text), "{self:?}");
        self
    }
}

/// The writing end of a pipe that nobody reads.
pub fn closed_pipe() -> Stdio {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    writer.into()
}

pub fn open_for_writing(path: &str) -> Stdio {
    fs::OpenOptions::new().write(true).open(path).unwrap().into()
}

/// A named pipe.
#[cfg(unix)]
pub fn make_fifo(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

#[test]
fn help_and_version_go_to_stdout() {
    let place = Place::with(&[]);
    for line in [&["--help"][..], &["-h"], &["check", "--help"], &["help"], &["help", "compile"]] {
        let run = place.run(line).ends(0);
        assert!(run.stdout.contains("Usage: cnc872c") && run.stdout.contains("Examples:"), "{run:?}");
        assert_eq!(run.stderr, "");
    }
    assert!(place.run(&["--version"]).ends(0).stdout.starts_with("cnc872c 0."));
}

#[test]
fn wrong_usage_goes_to_stderr_with_status_2() {
    let place = Place::with(&[]);
    place.run(&[]).ends(2).says("Usage: cnc872c");
    place.run(&["chekc"]).ends(2).says("perhaps this is meant: check");
    place.run(&["check"]).ends(2).says("<PATH>... is missing");
    place.run(&["check", "a.nc", "--nope"]).ends(2).says("--nope");
    place.run(&["check", "a.nc", "--dialect", "fanuc"]).ends(2).says("[cnc8x6, cnc8x9, cnc872]");
    place.run(&["compile", "a.nc", "b.nc"]).ends(2).says("b.nc");
    place.run(&["help", "plot"]).ends(2).says("no command plot");
    place.run(&["--lang", "cs", "check"]).ends(2).says("chyba: chybí <CESTA>...");
}

#[test]
fn the_language_is_that_of_the_option_else_of_the_environment() {
    let place = Place::with(&[]);
    let language = |variables: &[(&str, &str)], arguments: &[&str]| {
        let output = place.command(arguments).envs(variables.iter().copied()).output().unwrap();
        if String::from_utf8(output.stdout).unwrap().contains("Použití:") { "cs" } else { "en" }
    };
    assert_eq!(language(&[], &["--help"]), "en");
    assert_eq!(language(&[("LANG", "cs_CZ.UTF-8")], &["--help"]), "cs");
    assert_eq!(language(&[("LANG", "cs_CZ.UTF-8"), ("LC_ALL", "C")], &["--help"]), "en");
    assert_eq!(language(&[("LANG", "en_US"), ("LC_MESSAGES", "cs_CZ")], &["--help"]), "cs");
    assert_eq!(language(&[("LANG", "cs_CZ")], &["--lang", "en", "--help"]), "en");
    assert_eq!(language(&[("LC_ALL", "C")], &["check", "--lang=cs", "--help"]), "cs");
}

#[test]
fn colours_only_on_a_terminal_or_when_asked_for() {
    let place = Place::with(&[]);
    let coloured = |arguments: &[&str]| place.run(arguments).ends(0).stdout.contains('\u{1b}');
    assert!(!coloured(&["explain", "G73"]));
    assert!(coloured(&["explain", "G73", "--color", "always"]));
    assert!(!coloured(&["explain", "G73", "--color", "never"]));
    assert!(!coloured(&["help"]));
    assert!(coloured(&["--color=always", "help"]));
    // An option says more than the environment.
    let asked = place.command(&["--color", "always", "explain", "G73"]).env("NO_COLOR", "1").output().unwrap();
    assert!(asked.stdout.contains(&0x1b));
}

#[test]
fn explanations_of_findings_functions_and_addresses() {
    let place = Place::with(&[]);
    let explain = |arguments: &[&str]| place.run(&[&["explain"], arguments].concat()).ends(0).stdout;
    assert!(explain(&["E0306"]).contains("duplicate-address"));
    assert_eq!(explain(&["E0306"]), explain(&["duplicate-address"]));
    assert_eq!([explain(&["e306"]), explain(&["W801"])], [explain(&["E0306"]), explain(&["W0801"])]);
    place.put("a.nc", "%1\nN10 M30\n");
    for other in [["--dialect", "CNC8x9"], ["--encoding", "cp1250"], ["--encoding", "Windows-1250"]] {
        place.run(&[&["check", "a.nc"], &other[..]].concat()).ends(0);
    }
    assert!(explain(&["E0306", "--lang", "cs"]).contains("Proč"));
    assert!(explain(&["G73"]).contains("Group G7, calls and jumps"));
    assert!(explain(&["M19"]).contains("oriented spindle stop"));
    assert!(explain(&["&", "--lang", "cs"]).contains("Čtyři číslice"));
    let list = explain(&[]);
    assert!(list.lines().count() > 80 && list.contains("E0306") && list.contains("duplicate-address"), "{list}");
}

#[test]
fn an_unknown_name_gets_the_nearest_one() {
    let place = Place::with(&[]);
    place.run(&["explain", "duplicate-adress"]).ends(2).says("perhaps duplicate-address is meant");
    place.run(&["explain", "W0306"]).ends(2).says("perhaps E0306 is meant");
    place.run(&["explain", "G28.1"]).ends(2).says("no such diagnostic, function, address, key or signal");
    place.run(&["explain", "G21"]).ends(2).says("always in millimetres");
    place.run(&["explain", "qwertz"]).ends(2).says("no page has the word");
    // Wrong usage: nothing on standard output, whatever the other names are.
    for names in [["nonsense", "G04"], ["G04", "nonsense"]] {
        let both = place.run(&["explain", names[0], names[1]]).ends(2).says("nonsense");
        assert_eq!(both.stdout, "");
    }
}

/// A word that names nothing lists the pages that have it; a key may have the name of a function.
#[test]
fn words_and_keys_are_explained() {
    let place = Place::with(&[]);
    let run = place.run(&["explain", "posuv", "--lang", "cs"]).ends(0);
    assert!(run.stdout.starts_with("Stránky, kde je „posuv“:\n  G94 "), "{run:?}");
    assert!(place.run(&["explain", "vrtání"]).ends(0).stdout.contains("\n  G81 "));
    place.run(&["explain", &"q".repeat(100_000)]).ends(2).says("no page has the word");
    let run = place.run(&["explain", "radius"]).ends(0);
    assert!(run.stdout.contains("\n  G41 ") && run.stdout.contains("\n  E0603 "), "{run:?}");
    let run = place.run(&["explain", "g97"]).ends(0);
    assert!(run.stdout.starts_with("G97: ") && run.stdout.contains("\ng97: "), "{run:?}");
    let run = place.run(&["explain", "limits.feed"]).ends(0);
    assert!(run.stdout.contains("[limits]\n    feed = 99999"), "{run:?}");
    let table = place.run(&["explain", "W0113"]).ends(0);
    assert!(!table.stdout.contains('|'), "{table:?}");
}

#[test]
fn schemas_are_json_schemas() {
    let place = Place::with(&[]);
    for name in ["diagnostics", "config"] {
        let text = place.run(&["schema", name]).ends(0).stdout;
        let schema: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema", "{name}");
    }
}

#[test]
fn the_schema_of_blocks_is_the_default() {
    let place = Place::with(&[]);
    let text = place.run(&["schema"]).ends(0).stdout;
    assert_eq!(text, place.run(&["schema", "blocks"]).ends(0).stdout);
    let schema: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
}

#[test]
fn completions_and_manual_pages() {
    let place = Place::with(&[]);
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(place.run(&["completions", shell]).ends(0).stdout.contains("deny-warnings"), "{shell}");
    }
    assert!(place.run(&["man"]).ends(0).stdout.contains(".TH cnc872c 1"));
    assert!(place.run(&["man", "check"]).ends(0).stdout.contains(".TH cnc872c-check 1"));
    assert!(place.run(&["man", "compile", "--lang", "cs"]).ends(0).stdout.contains("proud bloků"));
    place.run(&["man", "nothing"]).ends(2).says("no command nothing");
}

#[test]
fn a_closed_pipe_is_no_error() {
    let place = Place::with(&[("a.nc", BAD.as_bytes())]);
    let lines: [&[&str]; 7] = [
        &["--help"],
        &["explain"],
        &["explain", "E0306"],
        &["schema", "config"],
        &["completions", "zsh"],
        &["man"],
        &["help", "check"],
    ];
    for line in lines {
        let run = place.run_into(line, closed_pipe()).ends(0);
        assert_eq!(run.stderr, "", "{line:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let place = Place::with(&[]);
    for line in [&["--help"][..], &["explain"], &["schema", "config"], &["completions", "zsh"], &["man"]] {
        place.run_into(line, open_for_writing("/dev/full")).ends(2).says("standard output: the disk is full");
    }
}

#[test]
fn control_characters_of_the_command_line_do_not_reach_the_terminal() {
    let place = Place::with(&[]);
    let lines: [&[&str]; 5] = [
        &["\u{1b}[2J"],
        &["explain", "\u{1b}[2J\u{202e}"],
        &["check", "a.nc", "-D", "\u{1b}[2J"],
        &["check", "a.nc", "--param", "\u{1b}[2J"],
        &["compile", "a.nc", "-o", "missing/\u{1b}[2J"],
    ];
    for line in lines {
        let run = place.run(line).ends(2);
        assert!(!run.stderr.contains('\u{1b}') && !run.stderr.contains('\u{202e}'), "{run:?}");
        assert!(run.stderr.contains("\\u{1b}[2J"), "{run:?}");
    }
}
