//! The PLC's reading, against the tables of S0 chapter 8: small programs, and the cells that the manual gives for them.

use std::collections::BTreeMap;
use std::io;
use std::path::Path;

use cnc872c::analysis::Part;
use cnc872c::analysis::plc::{Csv, Header, Json, Reader, Step, Wave, Writer, beside, named};
use cnc872c::config::{Overrides, Purpose, Settings, configure, find_project};
use cnc872c::diag::Findings;
use cnc872c::session::{Outcome, Session, TimedSignals, Times};
use cnc872c::text::{MemoryLoader, Sources};

use crate::markers::options;

/// Runs `plc` with these signals for what it reports.
pub fn signals(session: &Session<'_>, file: &str, signals: &str) -> Outcome {
    let mut out = Vec::new();
    run(session, file, signals, Part::default(), &mut Json::new(&mut out))
}

fn run(session: &Session<'_>, file: &str, signals: &str, range: Part, writer: &mut dyn Writer) -> Outcome {
    let machine = &session.settings.machine;
    let signals = named(signals, machine.dialect).expect("signals");
    let mut failed = None;
    let reader = Reader::new(signals, machine, range, writer, &mut failed);
    let path = Path::new(file);
    // As the command does where motion is configured.
    let outcome = if machine.motion.configured {
        let times = Times { phases: false, time_dist: true };
        session.run_timed(path, file, Purpose::Compile, times, TimedSignals(reader)).outcome
    } else {
        session.run(path, file, Purpose::Compile, reader).outcome
    };
    assert!(failed.is_none(), "{failed:?}");
    outcome
}

/// A program with its other files.
#[derive(Clone, Debug, Default)]
pub struct Case {
    program: String,
    files: BTreeMap<String, String>,
    args: String,
    pub range: Part,
}

/// One step: its cells as tables show them, by name; absent ones are empty.
#[derive(Clone, Debug)]
pub struct Row {
    pub seq: u64,
    pub stop: bool,
    cells: BTreeMap<String, String>,
}

impl Row {
    pub fn get(&self, name: &str) -> &str {
        self.cells.get(name).map_or_else(|| panic!("no {name}"), String::as_str)
    }
}

pub fn case(program: &str) -> Case {
    Case { program: program.to_owned(), ..Case::default() }
}

impl Case {
    pub fn with(mut self, name: &str, text: &str) -> Self {
        self.files.insert(name.to_owned(), text.to_owned());
        self
    }

    pub fn config(self, text: &str) -> Self {
        self.with("cnc872c.toml", text)
    }

    pub fn args(mut self, args: &str) -> Self {
        args.clone_into(&mut self.args);
        self
    }

    pub fn written(&self, signals: &str, writer: &mut dyn Writer) -> Outcome {
        self.in_session(|session| run(session, "P.NC", signals, self.range, writer))
    }

    pub fn in_session<T>(&self, with: impl FnOnce(&Session<'_>) -> T) -> T {
        let mut loader = MemoryLoader::new().with("P.NC", self.program.as_bytes());
        for (name, text) in &self.files {
            loader = loader.with(name, text.as_bytes());
        }
        let mut overrides = Overrides::default();
        options(&mut overrides, &self.args);
        let project = find_project(Path::new(""), &loader);
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let settings: Settings = configure(project.as_deref(), &overrides, &loader, &mut sources, &mut findings);
        assert!(findings.items().is_empty(), "the configuration: {:?}", findings.items());
        with(&Session { loader: &loader, settings: &settings, progress: None })
    }

    pub fn csv(&self, signals: &str) -> String {
        let mut out = Vec::new();
        let outcome = self.written(signals, &mut Csv::new(&mut out));
        assert!(!outcome.findings.has_errors(), "{:?}", outcome.findings.items());
        String::from_utf8(out).unwrap()
    }

    pub fn vcd(&self, signals: &str) -> Vec<u8> {
        let mut out = Vec::new();
        self.written(signals, &mut Wave::new(&mut out));
        out
    }

    /// The steps of a program without errors.
    pub fn rows(&self, signals: &str) -> Vec<Row> {
        let text = self.csv(signals);
        let mut lines = text.lines();
        let head: Vec<&str> = lines.next().unwrap().split(',').collect();
        lines
            .map(|line| {
                let cells: BTreeMap<String, String> = head
                    .iter()
                    .zip(line.split(','))
                    .map(|(name, cell)| ((*name).to_owned(), cell.to_owned()))
                    .collect();
                Row { seq: cells["seq"].parse().unwrap(), stop: cells["stop"] == "1", cells }
            })
            .collect()
    }
}

/// The cells of some signals in each step, joined by blanks; `-` is absent, a stop has `!` before it.
fn table(case: &Case, signals: &str) -> Vec<String> {
    let names: Vec<&str> = signals.split_whitespace().collect();
    let shown = |row: &Row| {
        let cells = names.iter().map(|name| match row.get(name) {
            "" => "-",
            cell => cell,
        });
        let stop = if row.stop { "! " } else { "" };
        stop.to_owned() + &cells.collect::<Vec<_>>().join(" ")
    };
    case.rows(&names.join(",")).iter().map(shown).collect()
}

/// S0 8.2.1 and 8.3.5: each function is in the cell of its group, with the mark of the group; those without a group in
/// 14.
#[test]
fn groups_of_functions() {
    let groups: [(u8, &[u8]); 9] = [
        (1, &[0, 1]),
        (2, &[3, 4, 5, 19]),
        (3, &[41, 42, 43, 44, 40]),
        (5, &[7, 8, 9, 17]),
        (6, &[50, 51, 52, 53]),
        (7, &[10, 11]),
        (8, &[48, 49]),
        (9, &[6, 60]),
        (14, &[12, 77, 99]),
    ];
    for (group, functions) in groups {
        let cells = format!("BLK.M[{group}] BLK.M{group} ZMM{group}PI");
        for function in functions {
            let program = case(&format!("%1\nN10 S9\nN20 M{function:02}\nN30\nN40 M02"));
            assert_eq!(table(&program, &cells)[1], format!("{function:02}h 1 1"), "M{function}");
            let all: Vec<String> = (1..=14).map(|group| format!("BLK.M{group}")).collect();
            let marks = table(&program, &all.join(" "));
            assert_eq!(marks[1].matches('1').count(), 1, "M{function} is of one group");
        }
    }
    for end in ["M02", "M30"] {
        let program = case(&format!("%1\nN10 S9\nN20 {end}"));
        assert_eq!(table(&program, "BLK.M[1] ZMM1PI")[1], format!("{}h 1", &end[1..]));
    }
}

/// S0 8.3.5: the example of the manual's configuration.
#[test]
fn configured_groups() {
    let rows: String = (91..=98)
        .map(|number| format!("<MFunc No=\"{number}\" GroupNo=\"{}\"/>", if number < 95 { 10 } else { 11 }))
        .collect();
    let channel = format!("<C><MFunctions>{rows}</MFunctions></C>");
    for number in 91..=98 {
        let program = case(&format!("%1\nN10 M{number}\nN20 M30")).config("channel-config = \"C.xml\"\n");
        let program = program.with("C.xml", &channel);
        let (cell, mark) = if number < 95 { ("BLK.M[10] PB03", "ZMM10PI") } else { ("BLK.M[11] PB13", "ZMM11PI") };
        assert_eq!(table(&program, &format!("{cell} {mark}"))[0], format!("{number}h {number}h 1"));
    }
}

/// S0 8.2.8, PLC-10: the functions of group 2.
#[test]
fn spindle() {
    let program = case("%1\nN10 S100\nN20 M03\nN30 M04\nN40 M19\nN50 M05\nN60 M03\nN70 M30");
    let cells = ["0 0 0 05h", "1 0 0 03h", "0 1 0 04h", "0 0 1 19h", "0 0 0 05h", "1 0 0 03h", "0 0 0 05h"];
    assert_eq!(table(&program, "M03PI M04PI M19PI PB06"), cells);
    assert_eq!(table(&program.args("--dialect=cnc8x6"), "M03PI M04PI M19PI PB06"), cells);
}

/// PLC-16, MFN-10: at a stop the oriented spindle stands where its block left it; START orients it again, so that the
/// next block turns it from 0.
#[test]
fn a_stop_of_an_oriented_spindle() {
    let program = case("%1\nN10 G00 C0 S100\nN15 M19\nN20 C720\nN40 G91 C-90 M00\nN50 C10\nN60 M30");
    let rows = table(&program, "BLK.AxNC[5] BLK.BlockLen SM_PO6PI");
    assert_eq!(rows[2..6], ["720 720 0", "630 90 1", "! 630 - -", "10 10 0"]);
    let program = case("%1\nN1 M19\nN2 C90 M00\nN3 C100 M01\nN4 M30").args("--optional-stop");
    let cells = ["0 -", "90 90", "! 90 -", "100 100", "! 100 -", "0 -"];
    assert_eq!(table(&program, "BLK.AxNC[5] BLK.BlockLen"), cells);
}

/// S0 8.2.10, PLC-10: the functions of group 5. The bits go by the functions, whichever coolant these are.
#[test]
fn coolant_1_and_2() {
    for dialect in ["cnc872", "cnc8x9"] {
        let program = case("%1\nN10 M07\nN20 M08\nN30 M09\nN40 M17\nN50 M30").args(&format!("--dialect={dialect}"));
        assert_eq!(table(&program, "M07PI M08PI"), ["1 0", "0 1", "0 0", "1 1", "0 0"]);
    }
}

/// S0 8.2.11, PLC-10: the functions of group 6.
#[test]
fn coolant_3_and_4() {
    let program = case("%1\nN10 M50\nN20 M51\nN30 M52\nN40 M53\nN50 M30");
    assert_eq!(table(&program, "M50PI M51PI"), ["1 0", "0 1", "1 1", "0 0", "0 0"]);
}

const GEARS: &str = "[[gears]]\nm = 41\nmin = 20\nmax = 500\n[[gears]]\nm = 42\nmin = 400\nmax = 2000\n";

/// S0 8.2.9 and 8.1.3, PLC-10, PLC-13: the functions of group 3, and M40 by the gear table.
#[test]
fn ranges() {
    let names = "M41PI M42PI M43PI M44PI SPINDLE_GEAR_ACT_1";
    let program = case("%1\nN10 M41\nN20 M42\nN30 M43\nN40 M44\nN50 M40\nN60 M30");
    let direct = ["1 0 0 0 1", "0 1 0 0 2", "0 0 1 0 3", "0 0 0 1 4"];
    assert_eq!(table(&program, names)[..4], direct);
    // Without a table M40 chooses nothing that is known.
    assert_eq!(table(&program, names)[4], "- - - - -");
    // A function that the machine builder put into the group is none of the ranges.
    let builder = case("%1\nN10 M41\nN20 M90\nN30 M30").config("channel-config = \"C.xml\"\n");
    let builder = builder.with("C.xml", "<C><MFunctions><MFunc No=\"90\" GroupNo=\"3\"/></MFunctions></C>");
    assert_eq!(table(&builder, names)[1], "0 0 0 0 -");
    let program = case("%1\nN10 M40\nN20 S450\nN30 S1500\nN40 S1600\nN50 S400\nN60 M30").config(GEARS);
    let cells = ["- - - - -", "1 0 0 0 1", "0 1 0 0 2", "0 1 0 0 2", "1 0 0 0 1", "1 0 0 0 1"];
    assert_eq!(table(&program, names), cells);
}

/// S0 8.1.2, PLC-8: the spindle output, and its absence.
#[test]
fn spindle_output() {
    let program =
        case("%1\nN10 M41\nN20 S500\nN30 S250\nN40 S1000 M42\nN50 S2000\nN60 M43\nN70 M40\nN80 M30").config(GEARS);
    let words = [None, Some(0x7FFF), Some(0x4000), Some(0x4000), Some(0x7FFF), None, Some(0x7FFF), Some(0x7FFF)];
    let cells: Vec<String> = words
        .iter()
        .map(|word: &Option<u16>| {
            word.map_or("- -".to_owned(), |word| format!("{:02X}h {:02X}h", word & 0xFF, word >> 8))
        })
        .collect();
    assert_eq!(table(&program, "PB11 PB12"), cells);
    let without = case("%1\nN10 S100 M41\nN20 M30");
    assert_eq!(table(&without, "PB11 PB12"), ["- -", "- -"]);
    let stopped = case("%1\nN10 S0 M41\nN20 M30").config("[[gears]]\nm = 41\nmin = 0\nmax = 0\n");
    assert_eq!(table(&stopped, "PB11 PB12"), ["- -", "- -"]);
}

/// S0 8.2.7, 8.2.12, 8.2.13, PLC-9: bits for one block. M01 also when optional stop is off.
#[test]
fn decoded_for_one_block() {
    let names = "M00_PID M01_PID M02_PID M30_PID M10PID M11PID M06PID M60PI";
    let program = case("%1\nN10 M10\nN20 M11\nN30 M01\nN40\nN50 T1 M06 M01\nN60 M60\nN70 M30");
    let cells = [
        "0 0 0 0 1 0 0 0",
        "0 0 0 0 0 1 0 0",
        "0 1 0 0 0 0 0 0",
        "0 0 0 0 0 0 0 0",
        "0 1 0 0 0 0 1 0",
        "0 0 0 0 0 0 0 1",
        "0 0 0 1 0 0 0 0",
    ];
    assert_eq!(table(&program, names), cells);
    let program = case("%1\nN10 M00\nN20 M02");
    assert_eq!(table(&program, names), ["1 0 0 0 0 0 0 0", "! 0 0 0 0 0 0 0 0", "0 0 1 0 0 0 0 0"]);
}

/// S0 8.2.2 to 8.2.4, PLC-11: modes. G30 and functions of other groups in the block do not end what is in force after
/// it.
#[test]
fn modes() {
    let program = case("%1\nN10 G0 X0\nN20 G1 X5 F100\nN30 G33 X9 K1 G95 F1 S5\nN40\nN50 G30 X0\nN60\nN70 M30");
    let cells = ["1 0 1", "0 0 1", "0 1 1", "0 1 1", "0 0 1", "0 1 1", "0 1 1"];
    assert_eq!(table(&program, "G00PI G33PI AUTPI"), cells);
}

const CHANNEL: &str = "<C><MFunctions>\
    <MFunc No=\"91\" GroupNo=\"10\"/><MFunc No=\"92\" GroupNo=\"12\" BreakCont=\"1\"/><MFunc No=\"95\" GroupNo=\"11\"/>\
    <MFunc No=\"96\" GroupNo=\"13\"/></MFunctions></C>";

/// A machine with the M functions of the manual's examples.
fn configured(program: &str) -> Case {
    case(program).config("channel-config = \"C.xml\"\n").with("C.xml", CHANNEL)
}

/// S0 8.2.5, PLC-7: functions in BCD. S0's example: M92 in group 12.
#[test]
fn bcd_bytes() {
    let program = configured("%1\nN10 M91\nN20 M92\nN30 M95\nN40 M96\nN50 M77\nN60 M100\nN70 M30");
    let cells = [
        "91h - - - -",
        "91h - 92h - -",
        "91h 95h 92h - -",
        "91h 95h 92h 96h -",
        "91h 95h 92h 96h 77h",
        "91h 95h 92h 96h 00h",
        "91h 95h 92h 96h 00h",
    ];
    assert_eq!(table(&program, "PB03 PB13 PB14 PB15 PB16"), cells);
    let constants =
        case("%1\nN10 M91\nN20 M30").config("dialect = \"cnc8x6\"\n[machine-constants]\nR56 = \"91929394\"\n");
    assert_eq!(table(&constants, "PB03 ZMM10PI"), ["91h 1", "91h 0"]);
}

/// S0 8.2.5, PLC-7: H, also one that does not fit, and T with its two lowest digits in PB07.
#[test]
fn h_and_t_as_bytes() {
    let program = case("%1\nN10 H7\nN20 H99\nN30 H100\nN40 H2.5\nN50 H-1\nN60 H0\nN70 M30");
    assert_eq!(table(&program, "PB05"), ["07h", "99h", "00h", "00h", "00h", "00h", "00h"]);
    let program = case("%1\nN10\nN20 T7\nN30 T61234567\nN40 T0\nN50 M30").args("--dialect=cnc8x9");
    let cells = ["- - - -", "07h 00h 00h 00h", "67h 45h 23h 61h", "00h 00h 00h 00h", "00h 00h 00h 00h"];
    assert_eq!(table(&program, "PB07 PB08 PB09 PB10"), cells);
}

/// S0 8.2.6 and 8.3.1, PLC-2, PLC-12: marks, also when the same function is programmed again, for the length of the
/// block.
#[test]
fn change_marks() {
    let program = configured("%1\nN10 M03 S9\nN20 M03\nN30 M92\nN40 M92\nN50 T5\nN60 T5 H1\nN70 H1\nN80\nN90 M30");
    let names = "ZMM2PI ZMM12PI ZMSTPI ZMSHPI BLK.M2 BLK.M12 BLK.TProg BLK.HProg";
    let cells = [
        "1 0 0 0 1 0 0 0",
        "1 0 0 0 1 0 0 0",
        "0 1 0 0 0 1 0 0",
        "0 1 0 0 0 1 0 0",
        "0 0 1 0 0 0 1 0",
        "0 0 1 1 0 0 1 1",
        "0 0 0 1 0 0 0 1",
        "0 0 0 0 0 0 0 0",
        "1 0 0 0 1 0 0 0",
    ];
    assert_eq!(table(&program, names), cells);
    let groups: Vec<String> = (1..=14).map(|group| format!("BLK.M{group}")).collect();
    assert_eq!(table(&program, &groups.join(" "))[2], "0 0 0 0 0 0 0 0 0 0 0 1 0 0");
}

/// S0 8.3.1, PLC-3: bits of the command block.
#[test]
fn bits_of_the_block() {
    let names = "BLK.FirstBlock BLK.LastBlock BLK.CondStop BLK.RevFeed BLK.ContinuousMode BLK.ConstCutSpeed";
    let program = case("%1\nN10 G0 X0\nN20 G95 M01\nN30 G96 G23\nN40 G94 G98\nN50 M30");
    let cells = ["1 0 0 0 0 0", "0 0 1 1 0 0", "0 0 0 0 1 1", "0 0 0 0 0 0", "0 1 0 0 0 0"];
    assert_eq!(table(&program, names), cells);
}

/// S0 8.3.3, PLC-1, PLC-6: values of groups and T. S0's example: M95 in group 11 is 95h. M100 is 100h.
#[test]
fn whole_numbers_of_the_block() {
    let program = configured("%1\nN10 M95\nN20 M100\nN30 T12345678 M06\nN40\nN50 M30");
    let names = "BLK.M[1] BLK.M[2] BLK.M[3] BLK.M[4] BLK.M[9] BLK.M[11] BLK.M[14] BLK.T";
    let cells = [
        "- 05h 40h - - 95h - -",
        "- 05h 40h - - 95h 100h -",
        "- 05h 40h - 06h 95h 100h 12345678h",
        "- 05h 40h - - 95h 100h 12345678h",
        "30h 05h 40h - - 95h 100h 12345678h",
    ];
    assert_eq!(table(&program, names), cells);
}

/// S0 8.3.4 and 8.1.21, PLC-6, PLC-14: real numbers, and the dwell.
#[test]
fn real_numbers_of_the_block() {
    let program = case(
        "%1\nN10 G0 X0 Y0 H-2.5\nN20 G1 X3 Y4 F150.5 S800 M3\nN30 G4 Q25\nN40 G4 Q0 X4\nN50 G0 A90\nN60 G91 A0\nN70 M30",
    );
    let names =
        "BLK.H BLK.Delay BLK.AxNC[0] BLK.AxNC[1] BLK.AxNC[3] BLK.BlockLen BLK.FeedProgr BLK.SpindleSpeed PRODLEVA";
    let cells = [
        "-2.5 - 0 0 - - - - 0",
        "-2.5 - 3 4 - 5 150.5 800 0",
        "-2.5 0.25 3 4 - - 150.5 800 1",
        "-2.5 0 4 4 - 1 150.5 800 0",
        "-2.5 - 4 4 90 - 150.5 800 0",
        "-2.5 - 4 4 90 0 150.5 800 0",
        "-2.5 - 4 4 90 - 150.5 800 0",
    ];
    assert_eq!(table(&program, names), cells);
}

/// S0 8.1.7 and 8.3.1, PLC-4: requests to move. An arc moves both of its axes; beyond the axes of the machine there are
/// none.
#[test]
fn requests_to_move() {
    let program = case("%1\nN10 G0 X0 Y0 Z0\nN20 G2 X10 I5\nN30 G0 Z5 C1\nN40 G92 X1 G54\nN50\nN60 M30");
    let names = "PO_OSXPI PO_OSYPI PO_OSZPI PO_OS4PI PO_OS6PI PO_OS16PI BLK.AxNC1Move BLK.AxNC5Move BLK.AxNC15Move";
    let cells = [
        "1 1 1 0 0 0 1 0 0",
        "1 1 0 0 0 0 1 0 0",
        "0 0 1 0 1 0 0 1 0",
        "0 0 0 0 0 0 0 0 0",
        "0 0 0 0 0 0 0 0 0",
        "0 0 0 0 0 0 0 0 0",
    ];
    assert_eq!(table(&program, names), cells);
}

/// PLC-5: after a change of origin each axis has its direction again with its own next motion.
#[test]
fn directions_by_axis() {
    let program = "%1\nN10 G54 G90 G0 X0 Y0\nN20 G55\nN30 X10\nN40 X0 Y-5\nN50 Y-9\nN60 M30";
    assert_eq!(table(&case(program), "SM_POXPI SM_POYPI"), ["- -", "- -", "- -", "1 -", "- 1", "- -"]);
}

/// PLC-4, PLC-5: places are those of the machine, `PO_OS` and `SM_PO` say X, Y, Z of these letters: on a lathe with X,
/// Z and C Z is the second place and `PO_OSZPI`, C is `PO_OS4PI`.
#[test]
fn a_lathe() {
    let axes = "[[axes]]\nletter = \"X\"\nkind = \"linear\"\n[[axes]]\nletter = \"Z\"\nkind = \"linear\"\n\
                [[axes]]\nletter = \"C\"\nkind = \"rotary\"\n";
    let turned = case("%1\nN10 G0 C10\nN20 G90 C5\nN30 M30").config(axes);
    assert_eq!(table(&turned, "PO_OS4PI SM_PO4PI BLK.AxNC2Move PO_OS5PI"), ["1 - 1 0", "1 1 1 0", "0 - 0 0"]);
    let program = case("%1\nN10 G0 X10 Z5\nN20 Z2\nN30 X8\nN40 M30").config(axes);
    let names = "PO_OSXPI PO_OSYPI PO_OSZPI BLK.AxNC1Move BLK.AxNC[0] BLK.AxNC[1] BLK.AxNC[2] SM_POZPI";
    let cells = ["1 0 1 1 10 5 - -", "0 0 1 1 10 2 - 1", "1 0 0 0 8 2 - -", "0 0 0 0 8 2 - -"];
    assert_eq!(table(&program, names), cells);
}

/// PLC-6, PLC-8: under G96 S is a cutting speed; after it S counts as it stands.
#[test]
fn cutting_speeds() {
    let gears = "[[gears]]\nm = 41\nmin = 0\nmax = 1000\noutput = 0.5\n";
    let program = case("%1\nN10 G95 S500 M41 M3 F0.1\nN20 G96 S180\nN30 G94\nN40 M30").config(gears);
    let cells = ["500 00h 20h", "- - -", "180 85h 0Bh", "180 85h 0Bh"];
    assert_eq!(table(&program, "BLK.SpindleSpeed PB11 PB12"), cells);
}

/// PLC-14, PLC-17: a dwell, a reference that the program starts, and a stop.
#[test]
fn states_of_a_program() {
    let program = case("%1\nN10 G0 X5\nN20 G4 Q10\nN30 G30 X0\nN40 G30 M0\nN50 X7\nN60 M30");
    let names = "PRODLEVA SF_DELAYINPROGR REFPI SF_STOP PO_STOP";
    let cells = ["0 0 0 0 0", "1 1 0 0 0", "0 0 1 0 0", "0 0 1 0 0", "! 0 0 0 1 1", "0 0 0 0 0", "0 0 0 0 0"];
    assert_eq!(table(&program, names), cells);
}

/// S0 8.1.8, PLC-5: directions by programmed coordinates.
#[test]
fn directions() {
    let names = "SM_POXPI SM_POYPI";
    let program =
        case("%1\nN10 G0 X0 Y0\nN20 X-5 Y5\nN30 X-5\nN40 G91 X2 Y-1\nN50 G90 X-3\nN60 G30 X0\nN70 G91 X-1\nN80 M30");
    let cells = ["- -", "1 0", "- -", "0 1", "- -", "- -", "1 -", "- -"];
    assert_eq!(table(&program, names), cells);
    // A quarter keeps both directions; half a circle turns one of them back, a full one has no distance.
    let arcs = case(
        "%1\nN10 G0 X10 Y0\nN20 G3 X0 Y10 I-10 J0 F9\nN30 G3 X0 Y-10 I0 J-10\nN40 G2 I0 J10\nN50 G2 X-10 Y0 I0 J10\nN60 M30",
    );
    assert_eq!(table(&arcs, names), ["- -", "1 0", "- 1", "- -", "1 0", "- -"]);
}

/// PLC-5: no direction under a conversion, but under G34 and G37, nor after a change of origin.
#[test]
fn directions_under_conversions() {
    let program = case(
        "%1\nN10 G0 X0\nN20 G35\nN30 X5\nN40 X9\nN50 G34\nN60 X5\nN70 X9\nN80 G37\nN90 X5\nN95 X9\nN97 G54\nN98 X5\nN99 X9\nN100 M30",
    );
    let cells = ["-", "-", "-", "-", "-", "-", "0", "-", "-", "0", "-", "-", "0", "-"];
    assert_eq!(table(&program, "SM_POXPI"), cells);
}

/// PLC-5: no direction beside a function that moves the machine, before the block's motion or after it.
#[test]
fn directions_beside_change_pos() {
    for attributes in ["", "BreakContEnd=\"1\"", "BreakCont=\"1\""] {
        let functions = format!("<C><MFunctions><MFunc No=\"88\" ChangePos=\"1\" {attributes}/></MFunctions></C>");
        let program = case("%1\nN10 G0 X3\nN20 X2 M88\nN30 X5\nN40 X4\nN50 M30")
            .with("c.xml", &functions)
            .config("channel-config = \"c.xml\"\n");
        assert_eq!(table(&program, "SM_POXPI")[1], "-", "{attributes}");
    }
}

/// PLC-16, S1 8.4: the program waits at M00: a separate step, after which groups 2, 5 and 6 are marked.
#[test]
fn a_stop() {
    let program =
        case("%1\nN10 G0 X0 S99 M3 M8\nN20 G1 G95 F1 X5 T7 H1 M0 M50 G23 G4 Q5\nN30 X9 M7\nN40 M1 M10\nN50\nN60 M30");
    let names = "BLK.M[1] BLK.M[2] BLK.M[5] BLK.M[6] BLK.M[7] ZMM1PI ZMM2PI ZMM5PI ZMM6PI ZMM7PI M03PI M08PI M50PI";
    let running = [
        "- 03h 08h 53h - 0 1 1 0 0 1 1 0",
        "00h 03h 08h 50h - 1 0 0 1 0 1 1 1",
        "! - 05h 09h 53h - 0 1 1 1 0 0 0 0",
        "- 03h 07h 50h - 0 1 1 1 0 1 0 1",
        "01h 03h 07h 50h 10h 1 0 0 0 1 1 0 1",
        "- 03h 07h 50h - 0 0 0 0 0 1 0 1",
    ];
    assert_eq!(table(&program, names)[..6], running);
    let stopping = table(&program.clone().args("--optional-stop"), names);
    assert_eq!(stopping[5], "! - 05h 09h 53h - 0 1 1 1 0 0 0 0");
    assert_eq!(stopping[6], "- 03h 07h 50h - 0 1 1 1 0 1 0 1");
    // Nothing moves or dwells, nothing is programmed; what is in force stays.
    let names = "PO_OSXPI BLK.BlockLen BLK.AxNC[0] BLK.Delay PRODLEVA BLK.Stop M00_PID ZMSTPI BLK.T BLK.H BLK.SpindleSpeed \
                 BLK.RevFeed BLK.ContinuousMode G00PI AUTPI BLK.FeedProgr SM_POXPI";
    let rows = table(&program, names);
    assert_eq!(rows[1], "1 5 5 0.05 1 1 1 1 07h 1 99 1 1 0 1 1 0");
    assert_eq!(rows[2], "! 0 - 5 - 0 0 0 0 07h 1 99 1 1 0 1 1 -");
}

/// PLC-16: the step of a stop belongs to its block.
#[test]
fn parts() {
    let mut program = case("%1\nN10 M3 S9\nN20 M0\nN30\nN40 M30");
    let steps =
        |program: &Case| -> Vec<(u64, bool)> { program.rows("M03PI").iter().map(|row| (row.seq, row.stop)).collect() };
    assert_eq!(steps(&program), [(0, false), (1, false), (1, true), (2, false), (3, false)]);
    program.range = Part { from: 1, limit: Some(1) };
    assert_eq!(steps(&program), [(1, false), (1, true)]);
    program.range = Part { from: 2, limit: None };
    assert_eq!(steps(&program), [(2, false), (3, false)]);
    program.range = Part { from: 9, limit: Some(0) };
    assert!(steps(&program).is_empty());
}

/// PLC-15: without the times of motion there are no values.
#[test]
fn what_only_motion_gives() {
    let program = case("%1\nN10 G0 X0\nN20 G23 G1 X5 F9\nN30 X9\nN40 M30");
    let cells = ["- - - -"; 4];
    assert_eq!(table(&program, "G23ACT TIME_DIST BLK.ParabAccel BLK.LinearAccel"), cells);
}

/// Thousands of steps, from several files.
fn long() -> Case {
    let program =
        "%1\nN10 G0 G90 X0 Y0 S99\nN20 G91 X0.1 M3\nN30 G72 L7\nN40 M7 M77\nN50 M5\nN60 G73 L20 Q4000\nN70 M30";
    case(program).with("L7", "N1 G79 L7\nN2 M8 H1\nN3 G70\n").with("L8", "N1 G79 L8\nN2 G70\n")
}

/// Makes a writer.
type Form = fn(&mut Vec<u8>) -> Box<dyn Writer + Send + '_>;

/// What goes to a writer in a thread beside execution is what goes to the writer itself.
#[test]
fn beside_execution() {
    let case = long();
    let forms: [Form; 3] =
        [|out| Box::new(Csv::new(out)), |out| Box::new(Json::new(out)), |out| Box::new(Wave::new(out))];
    for (from, limit) in [(0, None), (3000, Some(2000))] {
        let case = Case { range: Part { from, limit }, ..case.clone() };
        for form in forms {
            let (mut direct, mut through) = (Vec::new(), Vec::new());
            case.written("*", &mut *form(&mut direct));
            let (_, written) = beside(&mut *form(&mut through), |writer| case.written("*", writer));
            written.unwrap();
            assert!(direct.len() > 10_000);
            assert_eq!(String::from_utf8(direct).unwrap(), String::from_utf8(through).unwrap());
        }
    }
}

/// Fails at a step.
struct Full(u64);

impl Writer for Full {
    fn begin(&mut self, _: &Header<'_>) -> io::Result<()> {
        Ok(())
    }

    fn file(&mut self, _: u32, _: &str) -> io::Result<()> {
        Ok(())
    }

    fn step(&mut self, _: &Step<'_>) -> io::Result<()> {
        self.0 = self.0.checked_sub(1).ok_or(io::ErrorKind::StorageFull)?;
        Ok(())
    }

    fn end(&mut self, _: cnc872c::run::End) -> io::Result<()> {
        self.0.checked_sub(1).map(|_| ()).ok_or(io::ErrorKind::StorageFull.into())
    }
}

/// An error of a writer ends the run, and is the one that is returned.
#[test]
fn errors_beside_execution() {
    let case = long();
    let steps = case.rows("AUTPI").len() as u64;
    for (room, fails) in [(0, true), (5000, true), (steps, true), (steps + 1, false)] {
        let run = |writer: &mut dyn Writer| {
            case.in_session(|session| {
                let machine = &session.settings.machine;
                let mut failed = None;
                let signals = named("AUTPI", machine.dialect).unwrap();
                let reader = Reader::new(signals, machine, Part::default(), writer, &mut failed);
                let run = session.run(Path::new("P.NC"), "P.NC", Purpose::Compile, reader);
                (failed.is_some(), run.outcome.executed)
            })
        };
        let ((stopped, executed), written) = beside(&mut Full(room), run);
        assert_eq!(written.err().map(|error| error.kind()), fails.then_some(io::ErrorKind::StorageFull), "{room}");
        if room == 0 {
            assert!(stopped && executed < steps, "the run goes on: {executed}");
        }
    }
}
