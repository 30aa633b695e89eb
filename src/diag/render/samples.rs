//! Reports that the tests of all forms render.

use super::{Format, Shown, render};
use crate::diag::{
    CallKind, CallSite, Certain, Diagnostic, Finding, Findings, FixTitle, LabelText, ParameterNeed, Problem, Report,
    Severity, TextMeant,
};
use crate::dict::{Address, AxisLetter, Lang};
use crate::text::{Encoding, FileId, Location, SourceText, Sources, Span};

/// A file of a sample: name, and bytes, which are CP852 unless UTF-8.
pub(super) type File<'a> = (&'a str, &'a [u8]);

/// The texts of these files.
pub(super) fn sources(files: &[File<'_>]) -> Sources {
    let mut sources = Sources::new();
    for (name, bytes) in files {
        sources.add(SourceText::decode(*name, bytes.to_vec(), Encoding::Cp852).unwrap());
    }
    sources
}

/// A report on one program, each finding with its own severity.
pub(super) fn report(sources: &Sources, items: impl IntoIterator<Item = Diagnostic>) -> Report {
    let mut findings = Findings::new();
    items.into_iter().for_each(|item| findings.add(item));
    let mut report = Report::new();
    report.add_program(sources, findings);
    report
}

/// The place of `what` in a file, the `nth` one from 0.
pub(super) fn find(sources: &Sources, file: u32, what: &str, nth: usize) -> Location {
    let text = sources.get(FileId(file)).unwrap().text();
    let (start, _) = text.match_indices(what).nth(nth).unwrap();
    let start = u32::try_from(start).unwrap();
    Location { file: FileId(file), span: Span::new(start, start + u32::try_from(what.len()).unwrap()) }
}

/// An axis word twice in a block, the first one as a label, and a decimal comma with its fix.
pub(super) fn plain() -> Report {
    let sources = sources(&[("part.nc", b"%1 \"FLANGE\"\r\nN10 G0 X0 Y0 X5\r\nN20 G1 X36,12 F100\r\nN30 M30\r\n")]);
    let twice = Finding::DuplicateAddress { address: "X".to_owned(), unnumbered: false };
    let comma = Finding::DecimalComma { meant: crate::diag::CommaMeant::Point { written: "X36.12".to_owned() } };
    let at = find(&sources, 0, "36,12", 0);
    report(
        &sources,
        [
            Diagnostic::new(comma, at).with_fix(
                Certain::DecimalComma,
                FixTitle::Write { text: "X36.12".to_owned() },
                at,
                "36.12",
            ),
            Diagnostic::new(twice, find(&sources, 0, "X5", 0))
                .with_label(find(&sources, 0, "X0", 0), LabelText::First { what: "X0".to_owned() }),
            Diagnostic::new(Finding::EmptyBlock { block: 30, function: None }, find(&sources, 0, "N30", 0)),
        ],
    )
}

/// A finding in a macrocycle, with a label in the program, the calls that led there, a note and a fix that the help
/// does not name; the file names hold a blank, a letter beyond ASCII and an escape sequence.
pub(super) fn called() -> Report {
    let sources = sources(&[
        (
            "díly/a b.nc",
            "%1 \"p\u{159}íruba\"\nN10 R1=2.5\nN80 G71 L100\nN90 M30\nN100 G79 L100\nN110 G81 X5\nN120 G70".as_bytes(),
        ),
        ("cykly/\u{1b}[31mL9081", b"N1 G79 L9081\rN2 G1 DR1\rN3 G70"),
    ]);
    let unusable = Finding::UnusableParameterValue {
        address: Address::ALL.iter().copied().find(|address| address.to_string() == "D").unwrap(),
        parameter: 1,
        value: "2.5".to_owned(),
        needs: ParameterNeed::Whole,
    };
    let mut diagnostic = Diagnostic::new(unusable, find(&sources, 1, "DR1", 0))
        .with_label(find(&sources, 0, "2.5", 0), LabelText::ParameterValue { parameter: 1, value: "2.5".to_owned() })
        .with_fix(Certain::DecimalComma, FixTitle::Write { text: "D2".to_owned() }, find(&sources, 1, "DR1", 0), "D2");
    diagnostic.calls = vec![
        CallSite { by: CallKind::Subprogram, l: 100, n: 80, at: find(&sources, 0, "N80", 0) },
        CallSite { by: CallKind::Cycle(81), l: 9081, n: 110, at: find(&sources, 0, "N110", 0) },
    ];
    report(&sources, [diagnostic])
}

/// A program in CP852, and one that cannot be read.
pub(super) fn mixed() -> Report {
    let sources =
        sources(&[("dos.nc", b"%1 \"p\xfd\xa1ruba\"\r\nN10 \"\xe7roub\" XR1\r\nN20 M30"), ("missing.nc", b"")]);
    let missing = Location { file: FileId(1), span: Span::empty(0) };
    let end = find(&sources, 0, "M30", 0);
    report(
        &sources,
        [
            Diagnostic::new(
                Finding::UnassignedParameter { parameter: 1, compiled: false },
                find(&sources, 0, "XR1", 0),
            ),
            Diagnostic::new(
                Finding::MissingProgramEnd { skipped: false, late: None, instead: None, unread: None },
                Location { file: end.file, span: Span::empty(end.span.end) },
            ),
            Diagnostic::new(Finding::UnreadableFile { problem: Problem::NotFound, file: None }, missing),
            Diagnostic::new(Finding::MissingProgramStart { number: 1 }, missing),
        ],
    )
}

/// What no terminal must get raw.
pub(super) fn hostile() -> Report {
    let bytes = "%1\nN1\t\"\u{1b}[2J\u{7f}\u{202e}\" \u{85}\u{b}\u{c}\u{2028}X\u{7}\r\nN2".as_bytes();
    let sources = sources(&[("a\u{202e}\n\u{1b}]0;x\u{7}b.nc", bytes)]);
    let text = "\u{7}\u{1b}[31m".to_owned();
    let stray = Diagnostic::new(
        Finding::StrayText { text: text.clone(), meant: TextMeant::Comment { text: text.clone() } },
        find(&sources, 0, "X\u{7}", 0),
    )
    .with_label(find(&sources, 0, "\u{202e}", 0), LabelText::MacrocycleFile { name: text.clone() })
    .with_fix(Certain::DecimalComma, FixTitle::Write { text: text.clone() }, find(&sources, 0, "X\u{7}", 0), text);
    report(&sources, [stray])
}

/// `count` findings of two kinds in a file of as many lines, in CP852.
pub(super) fn many(count: u32) -> Report {
    let mut text = b"%1 \"p\xfd\xa1ruba\"\r\n".to_vec();
    for block in 1..=count {
        text.extend_from_slice(format!("N{block} G1 X{block}.5 Y20.25 F200 \"").as_bytes());
        text.extend_from_slice(b"p\xfd\xa1ruba\"\r\n");
    }
    let sources = sources(&[("big.nc", &text)]);
    let source = sources.get(FileId(0)).unwrap();
    let lines = 1..=usize::try_from(count).unwrap();
    let items = lines.map(|line| {
        let start = source.line_span(line).start;
        let at = Location { file: FileId(0), span: Span::new(start, start + 2) };
        let first = Location { file: FileId(0), span: Span::new(start + 5, start + 7) };
        Diagnostic::new(Finding::IncrementalFromUnknown { axis: AxisLetter::X.to_string().chars().next().unwrap() }, at)
            .with_label(first, LabelText::First { what: "X0".to_owned() })
    });
    report(&sources, items)
}

/// What `render` writes.
pub(super) fn rendered(format: Format, report: &Report, lang: Lang, colour: bool) -> String {
    let mut out = Vec::new();
    render(format, report, Shown { lang, colour, all: true }, &mut out).unwrap();
    String::from_utf8(out).unwrap()
}

/// Whether the text holds anything that a terminal acts on, line ends aside.
pub(super) fn is_raw(text: &str) -> bool {
    text.chars().any(|character| character != '\n' && crate::text::is_unsafe(character))
}

#[test]
fn severities() {
    let report = plain();
    assert!(report.items().map(|item| item.severity).eq([Severity::Error, Severity::Error, Severity::Warning]));
}
