//! The configuration as a whole: files, command line, places of findings.

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use super::*;
use crate::diag::{Code, ConfigNeed, ConfigProblem, Diagnostic, Finding, Findings};
use crate::dict::{AxisLetter, Decimal, Dialect, GCode, Lang, Operation};
use crate::text::{Encoding, Loader, MemoryLoader, Sources};

/// The example of the specification, each key once.
pub(super) const EXAMPLE: &str = r#"
dialect = "cnc872"              # cnc8x6, cnc8x9, cnc872
encoding = "cp852"              # when a file is not UTF-8: cp852, windows-1250, iso-8859-2, kamenicky
channel-config = "Channel.xml"  # its MFunctions
macrocycles = ["macros"]        # folders to search, in order; default: the program's folder
block-skip = false
optional-stop = false
oriented-stop = true            # M19 exists on this machine
spindle-axis = "C"              # MFN-10; "none"
oriented-position = 0.0         # deg
g97 = "per-minute"              # or "per-revolution": TEC-5
arc-centers = "machine-order"   # or "plane-order": MOT-3
extensions = ["nc", "ncp"]      # of programs, when a folder is checked; default .nc .ncp .mpf .txt, case ignored

[[axes]]                        # in machine order; with none listed, ADR-4 holds
letter = "X"
kind = "linear"                 # or "rotary"
min = -10.0                     # programmed coordinates outside give W0621
max = 650.0

[[axes]]
letter = "C"

[start]                         # programmed positions before the first block
X = 0.0

[power-up]                      # by G or M group
G0 = 0
G5 = 53
M2 = 5

[parameters]                    # the machine's table at program start
R10 = 25.5

[operations]                    # PAR-9: code = name
"01" = "add"

[cycles]                        # GRP-6
G81 = 8100

[[gears]]                       # MFN-9
m = 41
min = 20
max = 500

[machine-constants]             # digits as a string, or a number as the control shows it
R39 = 60.0

[corrections.7]
radius = 5.0

[limits]
records = 10_000_000
nesting = 32
feed = 24000.0
speed = 9999                    # S; up to 99999
arc-tolerance = 0.01

[lints]                         # allow, warn, deny; by name or code; warnings, and E0109
empty-block = "allow"
"#;

const CHANNEL: &str = "<C><MFunctions><MFunc No='91' GroupNo='10'/></MFunctions></C>";

pub(super) struct Run {
    settings: Settings,
    pub(super) sources: Sources,
    pub(super) findings: Vec<Diagnostic>,
}

impl Run {
    pub(super) fn with(project: Option<&str>, overrides: &Overrides, loader: &dyn Loader) -> Self {
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let settings = configure(project.map(Path::new), overrides, loader, &mut sources, &mut findings);
        Self { settings, sources, findings: findings.into_sorted() }
    }

    fn of(text: &str, overrides: &Overrides) -> Self {
        let mut loader = MemoryLoader::new().with("m/cnc872c.toml", text).with("m/Channel.xml", CHANNEL);
        for folder in ["m/macros", "m/a", "m/own", "shared", "abs", "/abs", "m/../shared"] {
            loader = loader.with(format!("{folder}/L1"), "");
        }
        Self::with(Some("m/cnc872c.toml"), overrides, &loader)
    }

    /// Codes and the texts at their places.
    fn found(&self) -> Vec<(Code, &str)> {
        self.findings.iter().map(|found| (found.code(), self.sources.slice(found.at))).collect()
    }

    /// Of a file that stands alone, with two files that are a ChannelConfig and folders `a` and `own`.
    pub(super) fn plain(text: &str) -> Self {
        let other = CHANNEL.replace("91", "92");
        let loader =
            MemoryLoader::new().with("cnc872c.toml", text).with("Channel.xml", CHANNEL).with("Other.xml", other);
        let loader = loader.with("a/L1", "").with("own/L1", "").with("macros/L1", "");
        Self::with(Some("cnc872c.toml"), &Overrides::default(), &loader)
    }

    pub(super) const fn settings(&self) -> &Settings {
        &self.settings
    }

    fn clean(text: &str) -> Settings {
        let run = Self::of(text, &Overrides::default());
        assert_eq!(run.found(), [], "{text}");
        run.settings
    }

    fn one(text: &str) -> (Code, String) {
        let run = Self::of(text, &Overrides::default());
        assert_eq!(run.findings.len(), 1, "{text}: {:?}", run.found());
        let (code, at) = run.found()[0];
        (code, at.to_owned())
    }
}

#[test]
fn example_of_the_specification() {
    // On CNC872 motion is computed with no constant.
    let run = Run::of(EXAMPLE, &Overrides::default());
    assert_eq!(run.found(), [(Code::W0707, "R39")]);
    let settings = run.settings;
    let machine = &settings.machine;
    assert_eq!(machine.dialect, Dialect::Cnc872);
    assert_eq!(settings.macrocycles, [PathBuf::from("m/macros")]);
    assert_eq!(machine.axes.letters(), "X, C");
    let x = machine.axes.get(0).unwrap();
    assert_eq!((x.min, x.max), (Some(Decimal::whole(-10)), Some(Decimal::whole(650))));
    assert_eq!((machine.spindle(), machine.spindle_is_configured()), (Some(1), true));
    assert_eq!((machine.g97, machine.arc_centers), (G97::PerMinute, ArcCenters::MachineOrder));
    assert_eq!(settings.extensions, ["nc", "ncp"]);
    assert_eq!(machine.start[&AxisLetter::X], Decimal::ZERO);
    assert_eq!(machine.m_power_up[2], Some(5));
    assert_eq!(machine.corrections[&7], Decimal::whole(5));
    assert_eq!(machine.limits.speed, 9999);
    assert_eq!(machine.m_functions.group(91), 10);
    assert_eq!(machine.parameters[&10], Decimal::from_thousandths(25_500));
    assert_eq!(machine.operations[&1], Operation::Add);
    assert_eq!(machine.cycles[&81], 8100);
    assert_eq!(machine.gears, [Gear { m: 41, min: 20, max: 500, output: Decimal::whole(1) }]);
    assert_eq!(machine.constants[&39], "60.0");
    assert_eq!(machine.limits.feed, Decimal::whole(24_000));
    assert_eq!(settings.lints[&Code::W0214], Level::Allow);
}

/// §12: what holds with nothing configured.
#[test]
fn defaults() {
    for project in [None, Some("cnc872c.toml")] {
        let run = Run::with(project, &Overrides::default(), &MemoryLoader::new().with("cnc872c.toml", ""));
        assert_eq!(run.found(), []);
        let machine = &run.settings.machine;
        assert_eq!((machine.dialect, machine.axes.count()), (Dialect::Cnc872, 9));
        assert_eq!(machine.limits, Limits::of(Dialect::Cnc872));
        assert!(machine.oriented_stop && run.settings.macrocycles.is_empty());
    }
    let old = Run::clean("dialect = 'cnc8x6'");
    assert_eq!(old.machine.limits.feed, Decimal::whole(24_000));
}

#[test]
fn values_are_set() {
    let settings = Run::clean(
        "dialect = 'cnc8x9'\nencoding = 'kamenicky'\nblock-skip = true\noptional-stop = true\noriented-stop = false\n\
         macrocycles = ['.', '../shared', './own', '/abs']\naxes = [{ letter = 'Z' }, { letter = 'A', kind = 'linear' \
         }, { letter = 'C' }]\npower-up = { G0 = 1, G1 = 19, G10 = 74 }\nparameters.R0 = -0.001\nparameters.R95 = \
         99_999_999\nparameters.R1 = 1.5e1\nparameters.R2 = 0x10\n[operations]\n'2' = \
         'sqrt'\n[machine-constants]\nR56 = 91\nR57 = '00000092'\nR06 = -1\nR340 = '0012'\n[[gears]]\nm = 44\nmin = \
         5\nmax = 5\n[[gears]]\nm = 41\nmin = 0\nmax = 9999\n[limits]\nnesting = 1000\nfeed = 1\narc-tolerance = \
         0\n[lints]\nW0214 = 'deny'\nline-too-long = 'warn'\n",
    );
    let machine = &settings.machine;
    assert_eq!(settings.encoding, Encoding::Kamenicky);
    assert!(settings.block_skip && settings.optional_stop && !machine.oriented_stop);
    assert_eq!(settings.macrocycles, ["m", "m/../shared", "m/own", "/abs"].map(PathBuf::from));
    assert_eq!(machine.axes.letters(), "Z, A, C");
    let rotary: Vec<_> = machine.axes.iter().map(|axis| axis.rotary).collect();
    assert_eq!(rotary, [false, false, true]);
    assert_eq!(machine.axes.fourth(), machine.axes.index(AxisLetter::A));
    assert_eq!((machine.power_up[0], machine.power_up[1]), (Some(GCode::G01), Some(GCode::G19)));
    assert_eq!((machine.power_up[10], machine.power_up[5]), (Some(GCode::G74), Some(GCode::G53)));
    let thousandths: Vec<_> = machine.parameters.values().map(|value| value.thousandths()).collect();
    assert_eq!(thousandths, [-1, 15_000, 16_000, 99_999_999_000]);
    assert_eq!(machine.operations[&2], Operation::Sqrt);
    assert_eq!((machine.m_functions.group(91), machine.m_functions.group(92)), (10, 11));
    assert_eq!((machine.constants[&6].as_str(), machine.constants[&340].as_str()), ("-1", "0012"));
    assert_eq!(machine.gears.iter().map(|gear| gear.m).collect::<Vec<_>>(), [41, 44]);
    assert_eq!((machine.limits.nesting, machine.limits.arc_tolerance), (1000, Decimal::ZERO));
    assert_eq!((settings.lints[&Code::W0214], settings.lints[&Code::E0109]), (Level::Deny, Level::Warn));
}

/// Wrong values, and where their finding is.
const WRONG: &[(&str, &str)] = &[
    ("dialect = 872", "872"),
    ("dialect = 'CNC872'", "'CNC872'"),
    ("block-skip = 'ano'", "'ano'"),
    ("channel-config = true", "true"),
    ("macrocycles = 'macros'", "'macros'"),
    ("macrocycles = ['a', 7]", "7"),
    ("macrocycles = ['a', 'none']", "'none'"),
    ("extensions = 'nc'", "'nc'"),
    ("extensions = ['nc', '']", "''"),
    ("extensions = ['nc', 'a/b']", "'a/b'"),
    ("spindle-axis = 'E'", "'E'"),
    ("spindle-axis = 'c'", "'c'"),
    ("spindle-axis = 'C'\naxes = [{ letter = 'X' }]", "'C'"),
    ("oriented-position = 70000", "70000"),
    ("g97 = 'iso'", "'iso'"),
    ("arc-centers = true", "true"),
    ("[start]\nX = 'a'", "'a'"),
    ("[start]\nY = 1\n[[axes]]\nletter = 'X'", "Y"),
    ("axes = [{ letter = 'X', min = 2, max = 1.999 }]", "1.999"),
    ("axes = [{ letter = 'X', max = -2, min = 1 }]", "1"),
    ("[corrections]\n7 = 5", "5"),
    ("[corrections.7]\nradius = -1", "-1"),
    ("[corrections.7]", "7"),
    ("[power-up]\nM2 = 101", "101"),
    ("[power-up]\nM2 = 41", "41"),
    ("[power-up]\nM7 = 10", "10"),
    ("[power-up]\nM10 = 92", "92"),
    ("dialect = 'cnc8x9'\n[power-up]\nM14 = 100", "100"),
    ("[limits]\nspeed = 100000", "100000"),
    ("[limits]\nspeed = 0", "0"),
    ("gears = [{ m = 41, min = 1, max = 12000 }]", "12000"),
    ("limits.speed = 24000\ngears = [{ m = 41, min = 1, max = 24001 }]", "24001"),
    ("[dialect]", "dialect"),
    ("[[block-skip]]", "block-skip"),
    ("axes = 3", "3"),
    ("axes = [3]", "3"),
    ("[axes]\nletter = 'X'", "axes"),
    ("limits = 5", "5"),
    ("[[limits]]", "limits"),
    ("[[axes]]\nkind = 'linear'", "[[axes]]"),
    ("[[axes]]\nletter = 'x'", "'x'"),
    ("[[axes]]\nletter = 'XY'", "'XY'"),
    ("[[axes]]\nletter = ''", "''"),
    ("axes = [{ letter = 'X' }, { letter = 'X' }]", "'X'"),
    ("[power-up]\nG0 = 'G1'", "'G1'"),
    ("[power-up]\nG0 = 30", "30"),
    ("[power-up]\nG0 = 256", "256"),
    ("[power-up]\nG7 = 71", "71"),
    ("[parameters]\nR1 = 70000.5", "70000.5"),
    ("[parameters]\nR1 = 100000000", "100000000"),
    ("[parameters]\nR1 = inf", "inf"),
    ("[parameters]\nR1 = -nan", "-nan"),
    ("[parameters]\nR1 = 1e300", "1e300"),
    ("[parameters]\nR1 = '5'", "'5'"),
    ("[parameters.R1]", "R1"),
    ("[operations]\n'01' = 1", "1"),
    ("[operations]\n'01' = 'add'\n'1' = 'sub'", "'1'"),
    ("[cycles]\nG81 = 0", "0"),
    ("[cycles]\nG81 = 8100.0", "8100.0"),
    ("[[gears]]\nm = 40\nmin = 1\nmax = 2", "40"),
    ("[[gears]]\nm = 41\nmin = 1\nmax = 10000", "10000"),
    ("[[gears]]\nm = 41\nmin = 3\nmax = 2", "2"),
    ("[[gears]]\nm = 41\nmax = 2\nmin = 3", "3"),
    ("[[gears]]\nm = 41\nmin = 3", "[[gears]]"),
    ("gears = [{ m = 41, min = 1, max = 2 }, { m = 41, min = 1, max = 2 }]", "41"),
    ("[machine-constants]\nR39 = true", "true"),
    ("[machine-constants]\nR39 = 'x'", "'x'"),
    ("[machine-constants]\nR39 = '1e3'", "'1e3'"),
    ("[machine-constants]\nR39 = nan", "nan"),
    ("[machine-constants]\nR6 = 1\nR06 = 1", "R06"),
    ("[limits]\nrecords = 0", "0"),
    ("[limits]\nrecords = 5.0", "5.0"),
    ("[limits]\nnesting = 1001", "1001"),
    ("[limits]\nfeed = 0.5", "0.5"),
    ("[limits]\narc-tolerance = -0.001", "-0.001"),
    ("[lints]\nempty-block = true", "true"),
    ("[lints]\nunknown-g-function = 'allow'", "unknown-g-function"),
    ("[lints]\nE0302 = 'nonsense'", "E0302"),
    ("[lints]\nempty-block = 'allow'\nW0214 = 'deny'", "W0214"),
];

/// §11: wrong types and ranges are errors at the value.
#[test]
fn wrong_values() {
    for (text, at) in WRONG {
        assert_eq!(Run::one(text), (Code::E0702, (*at).to_owned()), "{text}");
    }
}

#[test]
fn unknown_keys() {
    for (text, at) in [
        ("dialekt = 'cnc872'", "dialekt"),
        ("[limit]\nrecords = 5", "limit"),
        ("[[axis]]\nletter = 'X'", "axis"),
        ("[limits]\nrecrods = 500", "recrods"),
        ("[[axes]]\nletter = 'X'\nlimit = 5", "limit"),
        ("gears = [{ m = 41, min = 1, max = 2, mex = 3 }]", "mex"),
        ("[parameters]\nR96 = 5", "R96"),
        ("[parameters]\n\"R\\u0031\\u0030x\" = 5", "\"R\\u0031\\u0030x\""),
        ("[power-up]\nG4 = 26", "G4"),
        ("[power-up]\nM15 = 1", "M15"),
        ("[start]\nx = 1", "x"),
        ("[corrections.100]\nradius = 1", "100"),
        ("[corrections.7]\nradius = 1\nlength = 2", "length"),
        ("[cycles]\nG80 = 1", "G80"),
        ("[operations]\n'100' = 'add'", "'100'"),
        ("[machine-constants]\nR1000 = 1", "R1000"),
        ("[lints]\nemptyblock = 'allow'", "emptyblock"),
        ("a.b.c = 1", "a"),
    ] {
        assert_eq!(Run::one(text), (Code::W0705, at.to_owned()), "{text}");
    }
    for (text, note) in [
        ("angle-deg = 60", "[motion]"),
        ("[motion]\nindent = 4", "[format]"),
        ("[limits]\nfeed = 5000\nblock-skip = true", "před první tabulku"),
        ("[parameters]\nencoding = 'cp852'", "před první tabulku"),
    ] {
        let run = Run::of(text, &Overrides::default());
        assert!(run.findings[0].finding.note(Lang::Cs).unwrap().contains(note), "{text}");
    }
    let run = Run::of("block_skip = true", &Overrides::default());
    assert!(run.findings[0].finding.help(Lang::Cs).unwrap().contains("block-skip"));
    assert!(!run.settings.block_skip);
}

#[test]
fn repeated_things_show_the_first() {
    for text in [
        "axes = [{ letter = 'X' }, { letter = 'X' }]",
        "[lints]\nW0214 = 'warn'\nempty-block = 'warn'",
        "[[gears]]\nm = 41\nmin = 1\nmax = 2\n[[gears]]\nm = 41\nmin = 1\nmax = 2",
    ] {
        let run = Run::of(text, &Overrides::default());
        assert!(run.findings[0].labels[0].at < run.findings[0].at, "{text}");
    }
}

/// §13 Configuration: what the control of the run does not have.
#[test]
fn what_a_control_does_not_have() {
    let axes = "axes = [{letter='X'},{letter='Y'},{letter='Z'},{letter='A'},{letter='B'},{letter='C'},{letter='U'}]\n";
    for (text, at) in [
        ("[machine-constants]\nR56 = '91'", "R56"),
        ("dialect = 'cnc8x9'\nchannel-config = 'Channel.xml'", "channel-config"),
        (&format!("dialect = 'cnc8x6'\n{axes}"), "{letter='U'}"),
    ] {
        assert_eq!(Run::one(text), (Code::E0702, at.to_owned()), "{text}");
    }
    Run::clean(axes);
    // A dialect that is not known is one fault, not three.
    let text = "dialect = 'cnc'\nchannel-config = 'Channel.xml'\n[machine-constants]\nR56 = '03'";
    assert_eq!(Run::one(text), (Code::E0702, "'cnc'".to_owned()));
}

/// §2, §13 More: CNC8x6 and CNC8x9 have a sixth axis A, B or C.
#[test]
fn the_sixth_axis() {
    let listed =
        |letters: &str| letters.chars().map(|letter| format!("[[axes]]\nletter = '{letter}'\n")).collect::<String>();
    let old = "dialect = 'cnc8x6'\n";
    assert_eq!(Run::one(&format!("{old}{}", listed("XYZABU"))), (Code::E0702, "'U'".to_owned()));
    assert_eq!(Run::one(&format!("{old}{}", listed("UVWXYZ"))), (Code::E0702, "'W'".to_owned()));
    Run::clean(&format!("{old}{}", listed("XUVYCZ")));
    Run::clean(&listed("XYZABU"));
}

/// MFN-7: `[power-up]` takes M groups, by the groups of the whole configuration; MFN-8: stops know the table's values.
#[test]
fn m_groups_at_power_up() {
    let machine = Run::clean("channel-config = 'Channel.xml'\n[power-up]\nM2 = 19\nM10 = 91\nM14 = 70").machine;
    assert_eq!((machine.m_power_up[2], machine.m_power_up[10], machine.m_power_up[14]), (Some(19), Some(91), Some(70)));
    assert_eq!((machine.m_power_up[3], machine.m_functions.defaults()[2]), (Some(40), Some(5)));
    let machine =
        Run::clean("dialect = 'cnc8x9'\npower-up.M4 = 37\npower-up.M13 = 99\nmachine-constants.R59 = '99'").machine;
    assert_eq!((machine.m_power_up[4], machine.m_power_up[13]), (Some(37), Some(99)));
    let run = Run::of("[power-up]\nM7 = 10", &Overrides::default());
    let message = run.findings[0].finding.message(Lang::Cs);
    assert_eq!(message, "power-up.M7 nastavit nelze: funkce M skupiny 7 platí jen ve svém bloku");
}

/// MFN-10: the spindle's axis.
#[test]
fn the_axis_of_the_spindle() {
    for (text, axis, configured) in [
        ("", Some(AxisLetter::C), false),
        ("spindle-axis = 'none'", None, false),
        ("spindle-axis = 'B'", Some(AxisLetter::B), true),
        ("axes = [{ letter = 'X' }, { letter = 'B' }]", Some(AxisLetter::B), false),
        ("axes = [{ letter = 'X' }]", None, false),
    ] {
        let machine = Run::clean(text).machine;
        let letter = machine.spindle().and_then(|at| machine.axes.get(at)).map(|axis| axis.letter);
        assert_eq!((letter, machine.spindle_is_configured()), (axis, configured), "{text}");
    }
}

/// ADR-2: numbers finer than the control resolves have a finding that they are rounded.
#[test]
fn numbers_finer_than_the_resolution() {
    for (text, at) in [
        ("[parameters]\nR1 = 0.0004", "0.0004"),
        ("oriented-position = 1.23456", "1.23456"),
        ("[start]\nX = 1e-4", "1e-4"),
    ] {
        assert_eq!(Run::one(text), (Code::W0303, at.to_owned()), "{text}");
    }
    Run::clean("[parameters]\nR1 = 0.5000\nR2 = 12e-3");
}

/// §13 Configuration: options win, value by value; the checks are those of the dialect that wins.
#[test]
fn the_command_line_wins() {
    let text = "dialect = 'cnc8x6'\nencoding = 'cp852'\nblock-skip = true\nmacrocycles = ['a']\n[parameters]\nR1 = 1\n\
                R2 = 2\n[limits]\nrecords = 5\n[lints]\nempty-block = 'allow'\nunused-repeat = 'deny'\n";
    let overrides = Overrides {
        project: None,
        computes_motion: false,
        motion: Vec::new(),
        dialect: Some(Dialect::Cnc872),
        channel_config: Some(PathBuf::from("m/Channel.xml")),
        macrocycles: vec![PathBuf::from("x"), PathBuf::from("y/z")],
        parameters: vec![(2, Decimal::whole(20)), (3, Decimal::whole(30)), (3, Decimal::whole(31))],
        block_skip: Some(false),
        optional_stop: Some(true),
        encoding: Some(Encoding::Windows1250),
        max_blocks: Some(7),
        lints: vec![(Code::W0214, Level::Deny), (Code::W0214, Level::Warn), (Code::E0302, Level::Allow)],
    };
    let run = Run::of(text, &overrides);
    assert_eq!(run.found(), []);
    let (settings, machine) = (&run.settings, &run.settings.machine);
    assert_eq!((machine.dialect, settings.encoding), (Dialect::Cnc872, Encoding::Windows1250));
    assert_eq!(machine.m_functions.group(91), 10);
    assert_eq!(settings.macrocycles, overrides.macrocycles);
    let parameters: Vec<_> = machine.parameters.iter().map(|(&r, value)| (r, value.as_whole())).collect();
    assert_eq!(parameters, [(1, Some(1)), (2, Some(20)), (3, Some(31))]);
    assert!(!settings.block_skip && settings.optional_stop);
    assert_eq!(machine.limits.records, 7);
    assert_eq!(machine.limits.feed, Decimal::whole(99_999));
    let lints: Vec<_> = settings.lints.iter().map(|(&code, &level)| (code, level)).collect();
    assert_eq!(lints, [(Code::W0214, Level::Warn), (Code::W0403, Level::Deny)]);

    let old = Overrides { dialect: Some(Dialect::Cnc8x9), ..Overrides::default() };
    assert_eq!(Run::of("[machine-constants]\nR56 = '91'", &old).found(), []);
    assert_eq!(Run::of("dialect = 'cnc'", &old).found(), [(Code::E0702, "'cnc'")]);
    assert_eq!(Run::of("channel-config = 'Channel.xml'", &old).found(), [(Code::E0702, "channel-config")]);
    let new = Overrides { dialect: Some(Dialect::Cnc872), ..Overrides::default() };
    assert_eq!(Run::of("dialect = 'cnc8x9'\n[machine-constants]\nR56 = '91'", &new).found(), [(Code::E0702, "R56")]);
}

#[test]
fn files_that_cannot_be_read() {
    let none = MemoryLoader::new();
    let run = Run::with(Some("m/x.toml"), &Overrides::default(), &none);
    assert_eq!(run.found(), [(Code::E0701, "")]);
    assert_eq!(run.sources.get(run.findings[0].at.file).unwrap().name(), "m/x.toml");
    assert_eq!(run.findings[0].finding.message(Lang::Cs), "konfiguraci nelze přečíst: soubor m/x.toml neexistuje");

    let run = Run::of("channel-config = 'c.xml'", &Overrides::default());
    assert_eq!(run.found(), [(Code::E0701, "'c.xml'")]);
    assert!(run.findings[0].finding.message(Lang::En).ends_with("there is no file `m/c.xml`"));

    let overrides = Overrides { channel_config: Some(PathBuf::from("c.xml")), ..Overrides::default() };
    let run = Run::of("channel-config = 'none.xml'", &overrides);
    assert_eq!(run.found(), [(Code::E0701, "")]);
    assert_eq!(run.sources.get(run.findings[0].at.file).unwrap().name(), "c.xml");

    let overrides = Overrides { dialect: Some(Dialect::Cnc8x6), ..overrides };
    let run = Run::with(None, &overrides, &none);
    assert_eq!(run.found(), [(Code::E0702, "")]);
    assert_eq!(run.findings[0].finding.message(Lang::En), "`--channel-config` does not exist on cnc8x6");
}

/// A file that the system does not give out.
struct Refused(ErrorKind);

impl Loader for Refused {
    fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
        Err(self.0.into())
    }

    fn list(&self, _: &Path) -> Vec<PathBuf> {
        Vec::new()
    }

    fn folders(&self, _: &Path) -> Vec<PathBuf> {
        Vec::new()
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }
}

#[test]
fn why_a_file_cannot_be_read() {
    let name = || "c.toml".to_owned();
    for (kind, expected) in [
        (ErrorKind::NotFound, ConfigProblem::NotFound { name: name() }),
        (ErrorKind::NotADirectory, ConfigProblem::NotFound { name: name() }),
        (ErrorKind::PermissionDenied, ConfigProblem::Denied { name: name() }),
        (ErrorKind::IsADirectory, ConfigProblem::Directory { name: name() }),
        (ErrorKind::TimedOut, ConfigProblem::File { problem: format!("c.toml: {}", ErrorKind::TimedOut) }),
    ] {
        let run = Run::with(Some("c.toml"), &Overrides::default(), &Refused(kind));
        assert_eq!(run.findings.len(), 1);
        assert_eq!(run.findings[0].finding, Finding::UnreadableConfiguration { reason: expected });
    }
}

/// LEX-13: code pages of the files themselves; a byte-order mark is tolerated.
#[test]
fn encodings_of_the_files() {
    let mut toml = b"\xef\xbb\xbf".to_vec();
    toml.extend(b"channel-config = 'C.xml'\nblock-skip = true\n");
    let mut xml =
        b"<?xml version='1.0' encoding='windows-1250'?>\n<C note='\xf8'><MFunctions><MFunc No='\xe8'/>".to_vec();
    xml.extend(b"</MFunctions></C>");
    let loader = MemoryLoader::new().with("cnc872c.toml", toml).with("C.xml", xml);
    let run = Run::with(Some("cnc872c.toml"), &Overrides::default(), &loader);
    assert_eq!(run.found(), [(Code::E0702, "č")]);
    assert!(run.settings.block_skip);

    for encoding in ["iso-8859-2", "ISO8859-2", "latin2", "windows-1250", "cp1250", "cp852", "ibm852"] {
        let letter = if encoding.ends_with("852") { 0x9f } else { 0xe8 };
        let mut xml = format!("<?xml version='1.0' encoding=\"{encoding}\"?><C><MFunctions><MFunc No='").into_bytes();
        xml.push(letter);
        xml.extend(b"'/></MFunctions></C>");
        let loader = MemoryLoader::new().with("c.toml", b"channel-config = 'C.xml'".to_vec()).with("C.xml", xml);
        // The declared encoding wins.
        let other = if letter == 0x9f { Encoding::Windows1250 } else { Encoding::Cp852 };
        let overrides = Overrides { encoding: Some(other), ..Overrides::default() };
        let run = Run::with(Some("c.toml"), &overrides, &loader);
        assert_eq!(run.found(), [(Code::E0702, "č")], "{encoding}");
    }

    for utf16 in [b"\xff\xfed\0", b"\xfe\xff\0d"] {
        let loader = MemoryLoader::new().with("cnc872c.toml", utf16.to_vec());
        let run = Run::with(Some("cnc872c.toml"), &Overrides::default(), &loader);
        assert_eq!(run.found(), [(Code::E0701, "")]);
        assert_eq!(run.findings[0].finding, Finding::UnreadableConfiguration { reason: ConfigProblem::Utf16 });
    }

    // TOML is UTF-8: in another code page names would be other names.
    let loader = MemoryLoader::new().with("cnc872c.toml", b"# p\xfd\xa1ruba\nblock-skip = 5\n".to_vec());
    let run = Run::with(Some("cnc872c.toml"), &Overrides::default(), &loader);
    assert_eq!(run.found(), [(Code::E0701, "ý")], "as Windows writes it");
    let reason = ConfigProblem::NotUtf8 { line: 1, byte: "FDh".to_owned() };
    assert_eq!(run.findings[0].finding, Finding::UnreadableConfiguration { reason });
}

/// R56 as the control shows it is a number with three decimals; as a text it is its digits.
#[test]
fn constants_as_the_control_shows_them() {
    for (value, expected) in [
        ("'91929394'", None),
        ("91929.394", None),
        ("'91929.394'", Some(Code::E0706)),
        ("91929.39", Some(Code::E0706)),
        ("-91929.394", Some(Code::E0706)),
    ] {
        let run = Run::of(&format!("dialect = 'cnc8x9'\n[machine-constants]\nR56 = {value}\n"), &Overrides::default());
        let codes: Vec<_> = run.findings.iter().map(Diagnostic::code).collect();
        assert_eq!(codes, Vec::from_iter(expected), "{value}");
        if expected.is_none() {
            let group = |m| run.settings.machine.m_functions.group(m);
            assert_eq!([91, 92, 93, 94].map(group), [10; 4], "{value}");
        }
    }
}

/// §13 Configuration: an error leaves the defaults; one run reports all faults of a file.
#[test]
fn faults_do_not_hide_each_other() {
    let text = "dialect = 'x'\nblock-skip = 1\n[limits]\nnesting = 0\nrecrods = 1\n[lints]\nno-such = 'warn'\n";
    let run = Run::of(text, &Overrides::default());
    let codes: Vec<_> = run.findings.iter().map(Diagnostic::code).collect();
    assert_eq!(codes, [Code::E0702, Code::E0702, Code::E0702, Code::W0705, Code::W0705]);
    assert_eq!(run.settings.machine.limits, Limits::of(Dialect::Cnc872));
}

/// The texts of findings are sentences in both languages.
#[test]
fn messages() {
    for (text, en, cs) in [
        (
            "[limits]\nnesting = 0",
            "`limits.nesting` takes a whole number from 1 to 1000",
            "limits.nesting musí být celé číslo od 1 do 1000",
        ),
        (
            "dialect = ''",
            "`dialect` takes one of cnc8x6, cnc8x9, cnc872",
            "dialect musí být jedno z: cnc8x6, cnc8x9, cnc872",
        ),
        (
            "[limits]\nrecords = 0",
            "`limits.records` takes a whole number, 1 or more",
            "limits.records musí být celé číslo 1 nebo větší",
        ),
        ("[[gears]]\nm = 41\nmin = 1", "`gears` lacks `max`", "gears nemá uvedeno max"),
        (
            "[power-up]\nG0 = 17",
            "`power-up.G0` takes a lasting function of group G0",
            "power-up.G0 musí být trvalá funkce skupiny G0",
        ),
        ("[parameters]\nR96 = 0", "unknown key `R96`", "neznámý klíč „R96“"),
        (
            "a = 25,5",
            "the configuration cannot be read: a number has a decimal point, not a comma",
            "konfiguraci nelze přečíst: číslo má desetinnou tečku, ne čárku",
        ),
    ] {
        let run = Run::of(text, &Overrides::default());
        assert_eq!(run.findings[0].finding.message(Lang::En), en);
        assert_eq!(run.findings[0].finding.message(Lang::Cs), cs);
    }
}

/// Both ends of a gear have one limit, wherever `limits.speed` stands, and whatever is wrong with them.
#[test]
fn gears_reach_the_speed_of_the_limits() {
    for (limits, max) in [("", 9999), ("[limits]\nspeed = 20000", 20_000)] {
        let text = format!("[[gears]]\nm = 41\nmin = 20000.5\nmax = 20001\n{limits}");
        let run = Run::of(&text, &Overrides::default());
        let wrong = |key: &str| {
            let needs = ConfigNeed::Whole { min: 0, max };
            Finding::ConfigurationValue { key: key.to_owned(), needs }
        };
        let found: Vec<_> = run.findings.iter().map(|found| found.finding.clone()).collect();
        assert_eq!(found, [wrong("gears.min"), wrong("gears.max")], "{text}");
    }
}

/// Names in messages are short and have no control characters.
#[test]
fn hostile_names_are_shown_harmless() {
    let text = format!("\"\\u001b[2J{}\" = 1", "x".repeat(1000));
    let run = Run::of(&text, &Overrides::default());
    let message = run.findings[0].finding.message(Lang::En);
    assert!(!message.contains('\u{1b}') && message.len() < 120, "{message}");
}
