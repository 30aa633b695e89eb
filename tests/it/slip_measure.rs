//! One slip of the keyboard in a correct program, and what `check --fix` makes of it. The fuzz target `slip` reads this
//! file too.

use std::path::Path;

use cnc872c::config::{Overrides, Settings, configure, find_project};
use cnc872c::diag::{Code, Diagnostic, Findings, Fix};
use cnc872c::edit::apply_fixes;
use cnc872c::session::Part;
use cnc872c::session::Session;
use cnc872c::text::{FileId, MemoryLoader, Sources};

/// A correct program, and the files that it needs.
pub struct Program {
    /// How it is called.
    pub name: &'static str,
    /// Its text.
    pub text: &'static str,
    /// Names and texts of the project file and the macrocycles.
    pub files: &'static [(&'static str, &'static str)],
}

macro_rules! sample {
    ($path:literal) => {
        include_str!(concat!("../../samples/", $path))
    };
}

const fn alone(name: &'static str, text: &'static str) -> Program {
    Program { name, text, files: &[] }
}

/// Correct programs.
pub const PROGRAMS: [Program; 10] = [
    alone("flange.nc", sample!("ok/flange.nc")),
    alone("groove-helix.nc", sample!("ok/groove-helix.nc")),
    alone("multiline.nc", sample!("ok/multiline.nc")),
    alone("nested-loops.nc", sample!("ok/nested-loops.nc")),
    alone("postprocessor.nc", sample!("ok/postprocessor.nc")),
    Program {
        name: "plate.nc",
        text: sample!("projects/model/plate.nc"),
        files: &[("cnc872c.toml", sample!("projects/model/cnc872c.toml")), ("L8100", sample!("projects/model/L8100"))],
    },
    Program {
        name: "hub.nc",
        text: sample!("projects/five-axis/hub.nc"),
        files: &[("cnc872c.toml", sample!("projects/five-axis/cnc872c.toml"))],
    },
    Program {
        name: "gearbox.nc",
        text: sample!("projects/old-mill/gearbox.nc"),
        files: &[("cnc872c.toml", sample!("projects/old-mill/cnc872c.toml"))],
    },
    Program {
        name: "rectangular.nc",
        text: sample!("projects/pockets/rectangular.nc"),
        files: &[("cnc872c.toml", sample!("projects/pockets/cnc872c.toml"))],
    },
    Program {
        name: "bracket.nc",
        text: sample!("projects/tool-change/bracket.nc"),
        files: &[
            ("cnc872c.toml", sample!("projects/tool-change/cnc872c.toml")),
            ("ChannelConfig.xml", sample!("projects/tool-change/ChannelConfig.xml")),
            ("L9010", sample!("projects/tool-change/L9010")),
        ],
    },
];

/// The characters that a keyboard writes.
const KEYS: &[u8] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz+-.,;:=/*%&\"'()[]{}<>#$@!?_ \t\n";

/// One slip.
#[derive(Debug)]
pub struct Slip {
    /// The bytes that it replaces: two when keys change places.
    at: std::ops::Range<usize>,
    /// By what.
    text: String,
}

impl Slip {
    /// A slip in a text, chosen by numbers that `next` gives.
    pub fn take(text: &str, mut next: impl FnMut() -> usize) -> Self {
        let places: Vec<(usize, char)> = text.char_indices().filter(|(_, letter)| letter.is_ascii()).collect();
        let (at, first) = places[next() % places.len()];
        let key = char::from(KEYS[next() % KEYS.len()]);
        let behind = text[at + 1..].chars().next().filter(char::is_ascii);
        match (next() % 4, behind) {
            (0, _) => Self { at: at..at, text: key.to_string() },
            (1, _) => Self { at: at..at + 1, text: String::new() },
            (2, Some(second)) => Self { at: at..at + 2, text: [second, first].into_iter().collect() },
            _ => Self { at: at..at + 1, text: key.to_string() },
        }
    }

    /// The text with the slip in it.
    fn applied(&self, text: &str) -> String {
        let mut slipped = text.to_owned();
        slipped.replace_range(self.at.clone(), &self.text);
        slipped
    }

    /// The line of the slip, without and with it.
    pub fn lines(&self, text: &str) -> (String, String) {
        let line = |text: &str, end: usize| {
            let start = text[..self.at.start].rfind('\n').map_or(0, |at| at + 1);
            let end = text[end..].find('\n').map_or(text.len(), |length| end + length);
            text[start..end].to_owned()
        };
        (line(text, self.at.end), line(&self.applied(text), self.at.start + self.text.len()))
    }

    /// The numbers of the lines that the slip touches.
    pub fn line_numbers(&self, text: &str) -> std::ops::RangeInclusive<u32> {
        let line = |at: usize| u32::try_from(text[..at].matches('\n').count()).unwrap_or(u32::MAX) + 1;
        let joined = text[self.at.clone()].contains('\n') || self.text.contains('\n');
        line(self.at.start)..=line(self.at.start) + u32::from(joined)
    }

    /// Whether the reader of the text takes the key for another one, whatever it was meant for: a comma beside a digit
    /// is the point, O and l alone behind an address are digits, and a blank behind a sign is one too many.
    fn is_taken_for_another(&self, slipped: &str) -> bool {
        let (before, behind) = (&slipped[..self.at.start], &slipped[self.at.start + self.text.len()..]);
        let digit = |neighbour: Option<char>| neighbour.is_some_and(|letter| letter.is_ascii_digit());
        match self.text.as_str() {
            "," => digit(before.chars().next_back()) || digit(behind.chars().next()),
            "O" | "o" | "l" => !digit(before.chars().next_back()) && !digit(behind.chars().next()),
            " " | "\t" => before.ends_with(['+', '-']),
            _ => false,
        }
    }
}

/// What came of a slip.
pub enum Outcome {
    /// No fix is certain.
    Untouched { found: Vec<Found> },
    /// Something was fixed, and there are findings left. These were there before.
    Left { found: Vec<Found> },
    /// Fixed, and the program that was meant.
    Meant,
    /// Fixed, clean, and another program.
    Different { text: String },
}

/// A finding, and its line.
pub type Found = (Code, u32);

/// Makes a slip in a program and fixes what is certain.
pub fn measure(program: &Program, slip: &Slip) -> Outcome {
    let slipped = slip.applied(program.text);
    let (found, fixed) = fix(program, slipped.clone());
    if fixed == slipped {
        return Outcome::Untouched { found };
    }
    let (left, _) = check(program, &fixed);
    if !left.is_empty() {
        return Outcome::Left { found };
    }
    let same = slip.is_taken_for_another(&slipped)
        || fixed.eq_ignore_ascii_case(&slipped)
        || stream(program, &fixed) == stream(program, program.text);
    if same { Outcome::Meant } else { Outcome::Different { text: slip.lines(&fixed).1 } }
}

/// The findings of a text before any fix, and the text after all that is certain.
fn fix(program: &Program, mut text: String) -> (Vec<Found>, String) {
    let mut first = None;
    loop {
        let (found, sources) = check(program, &text);
        let line = |found: &Diagnostic| {
            sources.get(found.file()).map_or(0, |source| source.line_column(found.at.span.start).line)
        };
        first.get_or_insert_with(|| found.iter().map(|found| (found.code(), line(found))).collect());
        let fixes = found.iter().filter(|item| item.file() == FileId(0)).filter_map(Diagnostic::certain_fix);
        let source = sources.get(FileId(0)).expect("the program");
        let fixed = apply_fixes(source, FileId(0), text.as_bytes(), fixes.collect::<Vec<&Fix>>());
        if fixed.applied.is_empty() {
            return (first.unwrap_or_default(), text);
        }
        text = String::from_utf8(fixed.bytes).expect("UTF-8");
    }
}

fn with_session<T>(program: &Program, text: &str, ask: impl FnOnce(&Session<'_>) -> T) -> T {
    let files = program.files.iter();
    let loader = files.fold(MemoryLoader::new(), |loader, (name, text)| loader.with(name, *text));
    let loader = loader.with(program.name, text);
    let project = find_project(Path::new(""), &loader);
    let (mut sources, mut findings) = (Sources::new(), Findings::new());
    let overrides = Overrides { max_blocks: Some(20_000), ..Overrides::default() };
    let settings: Settings = configure(project.as_deref(), &overrides, &loader, &mut sources, &mut findings);
    ask(&Session { loader: &loader, settings: &settings, progress: None })
}

fn check(program: &Program, text: &str) -> (Vec<Diagnostic>, Sources) {
    with_session(program, text, |session| {
        let outcome = session.check(Path::new(program.name), program.name);
        let shown = |item: &&Diagnostic| session.settings.severity(item.code()).is_some();
        let found = outcome.findings.items().iter().filter(shown).cloned().collect();
        (found, outcome.sources)
    })
}

fn stream(program: &Program, text: &str) -> Vec<u8> {
    with_session(program, text, |session| {
        let mut written = Vec::new();
        session.compile(Path::new(program.name), program.name, Part::default(), &mut written).expect("memory");
        written
    })
}
