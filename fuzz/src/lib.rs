//! Common parts of the fuzz targets: settings out of the first bytes, and invariants of every outcome.

pub mod answers;
pub mod client;
pub mod connection;
pub mod editor;
pub mod script;
pub mod world;

use std::path::Path;

use cnc872c::config::{Level, Overrides, Settings, configure};
use cnc872c::diag::{Code, Diagnostic, Findings, Format, Report, Severity, Shown, render};
use cnc872c::dict::{Dialect, Lang};
use cnc872c::session::Outcome;
use cnc872c::text::{Encoding, Loader, Location, Sources};

/// Most block records of a run.
pub const MOST_BLOCKS: u64 = 2000;

/// Parts of an input stand before and behind this byte.
pub const SEPARATOR: u8 = 0x1e;

/// The project of every run that does not bring its own: each table of the file has something in it.
pub const PROJECT: &str = r#"
macrocycles = ["."]
oriented-stop = true
[operations]
"01" = "add"
"02" = "sub"
"03" = "mul"
"04" = "div"
"10" = "sin"
"11" = "cos"
[cycles]
G81 = 9001
G82 = 9002
[parameters]
R1 = 1
R2 = -2.5
R3 = 3
R60 = 9001
"#;

/// The request for a run.
#[derive(Clone, Debug)]
pub struct Mode {
    pub overrides: Overrides,
    /// Whether [`PROJECT`] is the project.
    pub with_project: bool,
}

impl Mode {
    /// Takes the first two bytes, and two more when they ask for levels; the rest is the input.
    pub fn take(data: &[u8]) -> Option<(Self, &[u8])> {
        let (&[first, second], rest) = data.split_first_chunk()?;
        let (levels, rest) = match second & 0x20 {
            0 => (None, rest),
            _ => rest.split_first_chunk().map(|(&bytes, rest)| (Some(u16::from_le_bytes(bytes)), rest))?,
        };
        let dialect = [Dialect::Cnc872, Dialect::Cnc8x6, Dialect::Cnc8x9][usize::from(first % 3)];
        let encoding =
            [Encoding::Cp852, Encoding::Windows1250, Encoding::Iso88592, Encoding::Kamenicky][usize::from(second & 3)];
        let overrides = Overrides {
            dialect: Some(dialect),
            encoding: Some(encoding),
            block_skip: Some(first & 0x10 != 0),
            optional_stop: Some(first & 0x20 != 0),
            max_blocks: Some(MOST_BLOCKS),
            lints: levels.map(lints).unwrap_or_default(),
            ..Overrides::default()
        };
        Some((Self { overrides, with_project: second & 0x10 != 0 }, rest))
    }

    /// The settings of the run; the loader has [`PROJECT`] as `cnc872c.toml`.
    pub fn settings(&self, loader: &dyn Loader) -> Settings {
        let project = self.with_project.then_some(Path::new("cnc872c.toml"));
        let mut findings = Findings::new();
        let settings = configure(project, &self.overrides, loader, &mut Sources::new(), &mut findings);
        assert!(!findings.has_errors(), "{:?}", findings.items());
        settings
    }
}

/// A level for about three of four codes that may have one, out of a seed: as `-A`, `-W` and `-D` give them.
fn lints(seed: u16) -> Vec<(Code, Level)> {
    let mut state = u32::from(seed) | 1;
    let configurable = Code::ALL.iter().copied().filter(|code| code.is_configurable());
    let level = |code| {
        // Knuth's multiplicative steps.
        state = state.wrapping_mul(2_654_435_769).wrapping_add(1);
        [None, Some(Level::Allow), Some(Level::Warn), Some(Level::Deny)][(state >> 30) as usize]
            .map(|level| (code, level))
    };
    configurable.filter_map(level).collect()
}

/// Places of a finding.
fn places(found: &Diagnostic) -> impl Iterator<Item = Location> + '_ {
    std::iter::once(found.at)
        .chain(found.labels.iter().map(|label| label.at))
        .chain(found.calls.iter().map(|call| call.at))
        .chain(found.fixes.iter().flat_map(|fix| fix.edits.iter().map(|edit| edit.at)))
}

/// Every place lies in its file, between characters; edits of a fix do not overlap.
pub fn assert_places(sources: &Sources, findings: &Findings) {
    for found in findings.items() {
        for at in places(found) {
            let text = sources.get(at.file).expect("a file of the run").text();
            let (start, end) = (at.span.start as usize, at.span.end as usize);
            assert!(start <= end && end <= text.len(), "{}: {at:?} of {}", found.code(), text.len());
            assert!(text.is_char_boundary(start) && text.is_char_boundary(end), "{}: {at:?}", found.code());
        }
        for fix in &found.fixes {
            let mut edits: Vec<Location> = fix.edits.iter().map(|edit| edit.at).collect();
            edits.sort();
            assert!(edits.windows(2).all(|pair| pair[0].span.end <= pair[1].span.start), "{}: overlap", found.code());
        }
    }
}

/// Looks at the places of an outcome, and renders it in every form.
pub fn assert_outcome(outcome: Outcome, lengths: &[(&str, usize)]) -> Report {
    assert_places(&outcome.sources, &outcome.findings);
    assert!(outcome.executed <= MOST_BLOCKS + 1, "{} blocks", outcome.executed);
    let counted = outcome.findings.error_count();
    let mut report = Report::new();
    report.add_program(&outcome.sources, outcome.findings);
    assert_eq!(report.errors(), counted, "errors by the report and by the findings");
    let shown = report.items().filter(|item| item.severity == Severity::Error).count();
    assert_eq!(shown == 0, counted == 0, "an error of each code is shown");
    assert_rendered(&report, lengths);
    report
}

/// Renders a report in all forms and both languages. `lengths` are the bytes of the files by name.
pub fn assert_rendered(report: &Report, lengths: &[(&str, usize)]) {
    let order: Vec<Location> = report.items().map(|item| item.diagnostic.at).collect();
    assert!(order.is_sorted());
    for lang in [Lang::En, Lang::Cs] {
        for format in [Format::Human, Format::Short, Format::Json, Format::Sarif, Format::Github] {
            let text = rendered(report, format, lang, false);
            assert!(!text.chars().any(|c| c.is_control() && c != '\n'), "{format:?}: {text:?}");
            match format {
                Format::Human => {
                    rendered(report, format, lang, true);
                }
                Format::Short => {
                    let lines = text.lines().filter(|line| line.contains("[E") || line.contains("[W")).count();
                    assert!(lines >= report.items().len());
                }
                Format::Json => {
                    let value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
                    let found = value["diagnostics"].as_array().expect("findings");
                    assert_eq!(found.len(), report.items().len());
                    found.iter().for_each(|item| assert_offsets(item, lengths));
                }
                Format::Sarif => {
                    serde_json::from_str::<serde_json::Value>(&text).expect("JSON");
                }
                Format::Github => assert!(text.lines().all(|line| line.starts_with("::")), "{text}"),
            }
        }
    }
}

fn rendered(report: &Report, format: Format, lang: Lang, colour: bool) -> String {
    let mut bytes = Vec::new();
    render(format, report, Shown { lang, colour, all: true }, &mut bytes).expect("memory takes all");
    String::from_utf8(bytes).expect("UTF-8")
}

/// Offsets of a finding lie in the bytes of its file.
fn assert_offsets(item: &serde_json::Value, lengths: &[(&str, usize)]) {
    let name = item["file"].as_str().expect("a name");
    let Some((_, length)) = lengths.iter().find(|(file, _)| *file == name) else { return };
    let offset = |end: &str| item["span"][end]["offset"].as_u64().expect("an offset");
    let (start, end) = (offset("start"), offset("end"));
    assert!(start <= end && end <= *length as u64, "{name}: {start}..{end} of {length}");
}
