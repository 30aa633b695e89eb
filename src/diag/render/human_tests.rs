//! Findings as people see them.

use proptest::prelude::*;

use super::human::calls;
use super::places::Places;
use super::samples::{self, find, rendered};
use crate::diag::{CallSite, Diagnostic, Finding, Format, LabelText, Report};
use crate::dict::Lang;
use crate::text::{Location, SourceText, Sources, Span};

fn human(report: &Report, lang: Lang) -> String {
    rendered(Format::Human, report, lang, false)
}

#[test]
fn labels_in_english() {
    insta::assert_snapshot!(human(&samples::plain(), Lang::En), @r#"
        error[E0306]: `X` is written twice in this block
           ╭─[ part.nc:2:14 ]
           │
         2 │ N10 G0 X0 Y0 X5
           │        ─┬    ──
           │         ╰──────── `X0` is the first one
           │ help: keep one of them, or begin a new block with `N…`
        ───╯

        error[E0104]: a decimal comma
           ╭─[ part.nc:3:9 ]
           │
         3 │ N20 G1 X36,12 F100
           │         ─────
           │ help: the control knows the decimal point only: write `X36.12`
        ───╯

        warning[W0214]: block N30 is empty
           ╭─[ part.nc:4:1 ]
           │
         4 │ N30 M30
           │ ───
           │ help: delete it, or say in a comment what it is for
        ───╯

        1 program: 2 errors, 1 warning
        fixable with cnc872c check --fix: 1
        details: cnc872c explain E0104 W0214 E0306
        "#);
}

#[test]
fn two_files_and_calls_in_czech() {
    insta::assert_snapshot!(human(&samples::called(), Lang::Cs), @r"
        chyba[E0510]: R1 má hodnotu 2.5, ale D musí být celé číslo
           ╭─[ cykly/\u{1b}[31mL9081:2:7 ]
           │
         2 │ N2 G1 DR1
           │       ───
           │
           ├─[ díly/a b.nc:2:8 ]
           │
         2 │ N10 R1=2.5
           │        ─┬─
           │         ╰─── zde dostal R1 hodnotu 2.5
           │ poznámka: voláno z bloku N110 G81 jako L9081 (díly/a b.nc:6)
           │ poznámka: voláno z bloku N80 G71 L100 (díly/a b.nc:3)
           │ nápověda: napsat „D2“
        ───╯

        1 program: 1 chyba
        podrobnosti: cnc872c explain E0510
        ");
    insta::assert_snapshot!(human(&samples::called(), Lang::En).lines().nth(12).unwrap(), @"   │ note: called by N80 \
        G71 L100 (díly/a b.nc:3)");
}

/// A program in CP852, a mark behind its last character, a file that cannot be read.
#[test]
fn code_page_end_of_file_and_no_file() {
    insta::assert_snapshot!(human(&samples::mixed(), Lang::Cs), @r#"
        varování[W0503]: R1 se čte dřív, než mu program dal hodnotu
           ╭─[ dos.nc:2:13 ]
           │
         2 │ N10 "šroub" XR1
           │             ───
           │ poznámka: hodnota pochází z tabulky parametrů stroje: co na ní závisí, se nezkontroluje
           │ nápověda: nejdřív přiřadit: „R1=…“, nebo zadat hodnotu ze stroje volbou --param R1=…
        ───╯

        chyba[E0205]: program nemá konec: v žádném bloku není M02 ani M30
           ╭─[ dos.nc:3:8 ]
           │
         3 │ N20 M30
           │        ─
           │ nápověda: ukončit hlavní program samostatným blokem: „N… M30“
        ───╯

        chyba[E0112]: soubor nelze přečíst: soubor neexistuje
           ╭─[ missing.nc:1:1 ]
        ───╯

        chyba[E0201]: chybí %: systém by celý soubor přeskočil
           ╭─[ missing.nc:1:1 ]
           │ nápověda: začít program znakem % a číslem: „%1“
        ───╯

        1 program: 3 chyby, 1 varování
        podrobnosti: cnc872c explain E0112 E0201 E0205 W0503
        "#);
}

#[test]
fn terminals_get_nothing_raw() {
    insta::assert_snapshot!(human(&samples::hostile(), Lang::En), @r#"
        error[E0111]: `\u{7}\u{1b}[31m` is text outside a comment
           ╭─[ a\u{202e}\u{a}\u{1b}]0;x\u{7}b.nc:2:17 ]
           │
         2 │ N1 "␛[2J␡�" �␋␌�X␇
           │          ┬      ──
           │          ╰────────── one of them: \u{7}\u{1b}[31m
           │ help: if it is meant as a comment, put it between quotes: `"\u{7}\u{1b}[31m"`
        ───╯

        1 program: 1 error
        fixable with cnc872c check --fix: 1
        details: cnc872c explain E0111
        "#);
}

#[test]
fn in_colour() {
    let text = rendered(Format::Human, &samples::plain(), Lang::En, true);
    insta::assert_snapshot!(text.replace('\u{1b}', "^"), @r#"
        ^[1;31merror[E0306]^[0m^[1m: `X` is written twice in this block^[0m
           ^[38;5;246m╭─[^[0m part.nc:2:14 ^[38;5;246m]^[0m
           ^[38;5;246m│^[0m
         ^[38;5;246m2 │^[0m ^[38;5;249mN10 G0 ^[0m^[36mX0^[0m^[38;5;249m Y0 ^[0m^[31mX5^[0m
           ^[38;5;240m│^[0m        ^[36m─┬^[0m    ^[31m──^[0m
           ^[38;5;240m│^[0m         ^[36m╰────────^[0m `X0` is the first one
           ^[38;5;246m│^[0m ^[36mhelp^[0m: keep one of them, or begin a new block with `N…`
        ^[38;5;246m───╯^[0m

        ^[1;31merror[E0104]^[0m^[1m: a decimal comma^[0m
           ^[38;5;246m╭─[^[0m part.nc:3:9 ^[38;5;246m]^[0m
           ^[38;5;246m│^[0m
         ^[38;5;246m3 │^[0m ^[38;5;249mN20 G1 X^[0m^[31m36,12^[0m^[38;5;249m F100^[0m
           ^[38;5;240m│^[0m         ^[31m─────^[0m
           ^[38;5;246m│^[0m ^[36mhelp^[0m: the control knows the decimal point only: write `X36.12`
        ^[38;5;246m───╯^[0m

        ^[1;33mwarning[W0214]^[0m^[1m: block N30 is empty^[0m
           ^[38;5;246m╭─[^[0m part.nc:4:1 ^[38;5;246m]^[0m
           ^[38;5;246m│^[0m
         ^[38;5;246m4 │^[0m ^[33mN30^[0m^[38;5;249m M30^[0m
           ^[38;5;240m│^[0m ^[33m───^[0m
           ^[38;5;246m│^[0m ^[36mhelp^[0m: delete it, or say in a comment what it is for
        ^[38;5;246m───╯^[0m

        ^[1;31m1 program: 2 errors, 1 warning^[0m
        fixable with cnc872c check --fix: 1
        details: cnc872c explain E0104 W0214 E0306
        "#);
}

#[test]
fn lines_left_out_and_labels_before_the_finding() {
    let text = format!("%1\nN1 G79 L1\n{}N9 G79 L1\nN10 G79 L1\n", "N2\n".repeat(120));
    let sources = samples::sources(&[("a.nc", text.as_bytes())]);
    let diagnostic = Diagnostic::new(Finding::DuplicateSubprogram { l: 1 }, find(&sources, 0, "L1", 2))
        .with_label(find(&sources, 0, "L1", 1), LabelText::UnitBegins { l: 1 })
        .with_label(find(&sources, 0, "L1", 0), LabelText::First { what: "X0".to_owned() });
    insta::assert_snapshot!(human(&samples::report(&sources, [diagnostic]), Lang::Cs), @r#"
        chyba[E0209]: podprogram L1 je v souboru dvakrát
             ╭─[ a.nc:124:9 ]
             │
           2 │ N1 G79 L1
             │        ─┬
             │         ╰── první je X0
             │
         123 │ N9 G79 L1
             │        ─┬
             │         ╰── L1 začíná zde
         124 │ N10 G79 L1
             │         ──
             │ nápověda: jednomu z nich dát jiné číslo
        ─────╯

        1 program: 1 chyba
        podrobnosti: cnc872c explain E0209
        "#);
}

#[test]
fn many_calls_are_counted() {
    let report = samples::called();
    let mut diagnostic = report.items().next().unwrap().diagnostic.clone();
    diagnostic.calls = (1..=20).map(|n| CallSite { n, ..*diagnostic.calls.first().unwrap() }).collect();
    let calls = calls(&Places::new(report.sources()), &diagnostic, Lang::Cs);
    insta::assert_snapshot!(calls.join("\n"), @"
    voláno z bloku N20 G71 L100 (díly/a b.nc:3)
    voláno z bloku N19 G71 L100 (díly/a b.nc:3)
    voláno z bloku N18 G71 L100 (díly/a b.nc:3)
    … dalších volání: 15
    voláno z bloku N2 G71 L100 (díly/a b.nc:3)
    voláno z bloku N1 G71 L100 (díly/a b.nc:3)
    ");
}

/// A fix is named only where the help does not say it already.
#[test]
fn fixes_are_named_once() {
    let report = samples::plain();
    for lang in [Lang::En, Lang::Cs] {
        let text = human(&report, lang);
        assert_eq!(text.matches("X36.12").count(), 1, "{text}");
    }
}

#[test]
fn no_findings() {
    let mut report = Report::new();
    assert_eq!(human(&report, Lang::En), "no errors\n");
    for _ in 0..5 {
        report.add_program(&Sources::new(), crate::diag::Findings::new());
    }
    assert_eq!(human(&report, Lang::Cs), "5 programů: bez chyb\n");
}

#[test]
fn a_line_of_ten_megabytes() {
    let text = format!("%1\nN1 {}X5 X6 {}", "\"ř\" ".repeat(1_000_000), "Y1 ".repeat(2_000_000));
    let sources = samples::sources(&[("a.nc", text.as_bytes())]);
    let (first, second) = (find(&sources, 0, "X5", 0), find(&sources, 0, "X6", 0));
    let items = (0..5000).map(|index| {
        let mut at = second;
        at.span.start += 1200 * index;
        at.span.end = at.span.start + 2;
        Diagnostic::new(Finding::DuplicateAddress { address: "X".to_owned(), unnumbered: false }, at)
            .with_label(first, LabelText::First { what: "X0".to_owned() })
    });
    let text = human(&samples::report(&sources, items), Lang::En);
    let shown = text.lines().take(18).collect::<Vec<_>>().join("\n");
    insta::assert_snapshot!(shown, @r#"
        error[E0306]: `X` is written twice in this block
           ╭─[ a.nc:2:4000007 ]
           │
         2 │ …" "ř" "ř" "ř" "ř" "ř" "ř" "ř" X5 X6 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1…
           │                                ─┬ ──
           │                                 ╰───── `X0` is the first one
           │ help: keep one of them, or begin a new block with `N…`
        ───╯

        error[E0306]: `X` is written twice in this block
           ╭─[ a.nc:2:4001207 ]
           │
         2 │ …" "ř" "ř" "ř" "ř" "ř" "ř" "ř" X5 X6 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1…Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1 Y1…
           │                                ─┬                                                             ──
           │                                 ╰───────────────────────────────────────────────────────────────── `X0` is the first one
           │ help: keep one of them, or begin a new block with `N…`
        ───╯
        "#);
}

/// The time grows with the findings alone, not with how far into the file they are: ten times as many take ten times as
/// long, where a search from the beginning would take a hundred times. The bound leaves room for a busy machine.
#[test]
fn ten_thousand_findings() {
    let time_of = |count: u32| {
        let report = samples::many(count);
        let start = std::time::Instant::now();
        let text = rendered(Format::Human, &report, Lang::En, true);
        assert_eq!(text.matches("is the first one").count(), count as usize);
        start.elapsed()
    };
    let (few, many) = (time_of(999), time_of(9_999));
    assert!(many < 50 * few, "{few:?}, {many:?}");
}

proptest! {
    /// Whatever a file, its name and the places in it are: no form panics, nothing reaches the terminal raw.
    #[test]
    fn any_text_any_places(
        name in "\\PC{0,5}[\u{1b}\u{202e}\n]?",
        text in "([ -~\t\u{1b}\u{85}\u{2028}\u{202e}řš日\u{301}\u{1f600}]{0,60}(\r\n|\n|\r|\u{b})?){0,5}",
        repeats in 1_usize..10,
        places in proptest::collection::vec((0_u32..2000, 0_u32..300), 1..5),
    ) {
        let mut sources = Sources::new();
        let file = sources.add(SourceText::from_text(name, text.repeat(repeats)));
        let source = sources.get(file).unwrap();
        let boundary = |mut at: u32| {
            at = at.min(source.len());
            while !source.text().is_char_boundary(at as usize) {
                at -= 1;
            }
            at
        };
        let mut places = places
            .into_iter()
            .map(|(start, len)| Location { file, span: Span::new(boundary(start), boundary(start + len)) });
        let mut diagnostic = Diagnostic::new(Finding::MissingProgramStart { number: 1 }, places.next().unwrap());
        for place in places {
            diagnostic = diagnostic.with_label(place, LabelText::First { what: "X0".to_owned() });
        }
        let report = samples::report(&sources, [diagnostic]);
        for format in <Format as clap::ValueEnum>::value_variants() {
            prop_assert!(!samples::is_raw(&rendered(*format, &report, Lang::Cs, false)));
        }
    }
}
