//! What findings advise, in both languages: the words that lead to what was meant (diagnostics.md, "Advice").

use cnc872c::diag::Code;
use cnc872c::dict::Lang;
use cnc872c::text::MemoryLoader;

use crate::markers::{Request, options};
use crate::run::{Run, run};

/// A program, what belongs to it, and words that the advice of one finding has.
#[derive(Default)]
struct Case<'a> {
    /// The blocks between the beginning and the end of a program.
    blocks: &'a str,
    /// What stands behind the end of the program.
    behind: &'a str,
    /// The project file.
    config: &'a str,
    args: &'a str,
    en: &'a [&'a str],
    cs: &'a [&'a str],
    /// Words that the advice has in no language.
    never: &'a [&'a str],
}

impl Case<'_> {
    fn run(&self) -> Run {
        let Self { blocks, behind, config, args, .. } = self;
        let program = format!("%1\nN10 G90 G00 X0 Y0 Z5\n{blocks}N800 M30\n{behind}");
        let loader = MemoryLoader::new().with("p.nc", program).with("cnc872c.toml", *config);
        let loader = loader.with("L9001", "N1 G79 L9001\nN2 G70\n");
        let mut request = Request::default();
        options(&mut request.overrides, args);
        run(&loader, "p.nc", &request)
    }
}

/// The help and the note of the only finding of that code.
fn advice(run: &Run, code: Code, lang: Lang) -> String {
    let found: Vec<_> = run.report.items().filter(|item| item.diagnostic.code() == code).collect();
    assert_eq!(found.len(), 1, "{code}: {:?}", run.codes());
    let finding = &found[0].diagnostic.finding;
    [finding.help(lang), finding.note(lang)].into_iter().flatten().collect::<Vec<_>>().join("\n")
}

#[track_caller]
fn assert_advice(code: Code, case: &Case<'_>) {
    let run = case.run();
    for (lang, words) in [(Lang::En, case.en), (Lang::Cs, case.cs)] {
        let said = advice(&run, code, lang);
        for word in words {
            assert!(said.contains(word), "{code} of {:?} without `{word}`: {said}", case.blocks);
        }
        for word in case.never {
            assert!(!said.contains(word), "{code} of {:?} with `{word}`: {said}", case.blocks);
        }
    }
}

/// A call of what is a block, a jump to what is a subprogram: the other function. One fault gives one finding, so that
/// the subprogram is not told to be without use (FLW-1, FLW-5).
#[test]
fn calls_and_jumps_exchanged() {
    let behind = "N900 G79 L100\nN910 G70\n";
    for (code, blocks, behind, right) in [
        (Code::E0406, "N40 G73 L100\n", behind, "G71 L100"),
        (Code::E0404, "N40 G71 L60\nN60 X5\n", "", "G73 L60"),
        (Code::E0405, "N70 X5\nN75 G72 L70 Q5\n", "", "G73 L70"),
        (Code::W0402, "N80 L9001\n", "", "G72 L9001"),
    ] {
        let (en, cs) = (format!("`{right}`"), format!("„{right}“"));
        let case = Case { blocks, behind, en: &[&en], cs: &[&cs], never: &["-L"], ..Case::default() };
        assert_advice(code, &case);
        assert_eq!(case.run().codes(), [code], "{blocks}");
    }
}

/// A number that is written twice in one line: the empty block is the copy, also where a subprogram begins.
#[test]
fn a_number_written_twice() {
    for (blocks, behind) in [("N40 N40 X5\n", ""), ("N40 G71 L100\n", "N900 N900 G79 L100\nN910 G70\n")] {
        let (en, cs) = (["delete one of the copies"], ["jednu kopii vymazat"]);
        let case = Case { blocks, behind, en: &en, cs: &cs, ..Case::default() };
        assert_advice(Code::E0204, &case);
        assert_eq!(case.run().codes(), [Code::E0204], "{blocks}");
    }
}

/// Jumps as other controls write them: the help names the block that they name (E0111).
#[test]
fn jumps_of_other_controls() {
    let (en, cs) = (["block N60 is `G73 L60`"], ["blok N60 se píše „G73 L60“"]);
    for statement in ["GOTOB N60", "GOTO 60", "IF R20<100 GOTO 60"] {
        let blocks = format!("N60 X5\nN75 {statement}\n");
        assert_advice(Code::E0111, &Case { blocks: &blocks, en: &en, cs: &cs, never: &["190"], ..Case::default() });
    }
}

/// Without a place for the macrocycle: where the machine alone has it, its line of the project file (FLW-12).
#[test]
fn a_macrocycle_of_the_machine() {
    let en = ["`L3500 = {}`", "`[machine-macrocycles]`", "`-L`"];
    let cs = ["L3500 = {}", "[machine-macrocycles]", "-L"];
    assert_advice(Code::E0405, &Case { blocks: "N20 G72 L3500\n", en: &en, cs: &cs, ..Case::default() });
    // `axes` is advised where one of them has none yet.
    for (blocks, advised) in [("N20 G72 L3500\n", false), ("N20 G72 L3500\nN30 G72 L3600\n", true)] {
        let config = "[machine-macrocycles]\nL3500 = { axes = [\"Z\"] }\nL3600 = {}\n";
        let run = Case { blocks, config, ..Case::default() }.run();
        assert_eq!(run.codes(), [Code::W0612], "{blocks}");
        for lang in [Lang::En, Lang::Cs] {
            assert_eq!(advice(&run, Code::W0612, lang).contains("axes"), advised, "{blocks}");
        }
    }
}

/// M30 where M03 was meant ends the program: the first block behind it says which block that is, and what was meant.
#[test]
fn an_end_by_mistake() {
    let blocks = "N30 S900 M30\nN40 G01 X5 F100\n";
    let en = ["the program ends in N30 with M30", "`M03`?"];
    let case = Case { blocks, en: &en, cs: &["program končí už blokem N30 s M30", "„M03“?"], ..Case::default() };
    assert_advice(Code::E0206, &case);
    let run = case.run();
    let found = run.report.items().find(|item| item.diagnostic.code() == Code::E0206).unwrap();
    let label = &found.diagnostic.labels[0];
    let source = run.report.sources().get(label.at.file).unwrap();
    assert_eq!(source.line_column(label.at.span.start).line, 3, "the line of N30");
    assert_eq!(label.text.text(Lang::En), "M30 ends the program here");
    assert_eq!(label.text.text(Lang::Cs), "M30 končí program už zde");
}

/// A feed that does not fit the range: in constant cutting speed the advice is G97, as the key `g97` says, and not G95
/// (TEC-1).
#[test]
fn feeds_by_revolution() {
    let blocks = "N40 G96 S200 M03\nN50 G01 X10 F0.3\n";
    for args in ["--dialect=cnc8x6", "--dialect=cnc8x9", "--dialect=cnc872"] {
        let (en, cs) =
            (["under G97, where the key `g97` is `per-revolution`"], ["s G97, má-li klíč g97 hodnotu per-revolution"]);
        assert_advice(Code::E0302, &Case { blocks, args, en: &en, cs: &cs, never: &["G95"], ..Case::default() });
    }
    let (en, cs) = (["as the key `g97` says"], ["jak určuje klíč g97"]);
    let blocks = "N40 G97 S200 M03\nN50 G01 X10 F0.3\n";
    assert_advice(Code::E0302, &Case { blocks, en: &en, cs: &cs, ..Case::default() });
    let config = "g97 = \"per-revolution\"\n";
    assert!(Case { blocks, config, ..Case::default() }.run().codes().is_empty(), "what it advises helps");
}

/// S outside the gear under G97: it may be a cutting speed there (MFN-9).
#[test]
fn speeds_under_g97() {
    let config = "[[gears]]\nm = 42\nmin = 200\nmax = 2000\n";
    let words = ["g97 = \"per-revolution\""];
    for (blocks, never) in [("N20 G97 S180 M42\n", &[][..]), ("N20 G94 S180 M42\n", &["g97"])] {
        let words = if never.is_empty() { &words[..] } else { &[] };
        assert_advice(Code::E0607, &Case { blocks, config, en: words, cs: words, never, ..Case::default() });
    }
}

/// An origin as Fanuc writes it: its axis words move here.
#[test]
fn origins_of_other_controls() {
    let blocks = "N40 G10 L2 X0 Y5 Z0\n";
    let en = ["G92 with G54 to G59", "X, Y and Z in this block move"];
    let cs = ["G92 s funkcí G54 až G59", "X, Y a Z v tomto bloku jsou pohyb"];
    assert_advice(Code::W0402, &Case { blocks, en: &en, cs: &cs, ..Case::default() });
}

/// E0603: I and J that fit in several ways are all named; under G74 a coordinate of X may be a diameter.
#[test]
fn centers_of_arcs() {
    let arc = "N20 G01 X50 Y50 F300\nN30 G02 ";
    for (blocks, words) in [
        (format!("{arc}X66 Y58 I60 J50\n"), "I10 J0"),
        (format!("{arc}X60 Y40 I-10 J0\n"), "I10 J0 / I0 J-10"),
        (format!("{arc}X64 Y50 I2 J7\n"), "I7 J2"),
        ("N20 G74 G01 X24 Y0 F300\nN30 G03 X30 Y-3 I24 J-3\n".to_owned(), "I0 J-3"),
    ] {
        let case = Case { blocks: &blocks, en: &[words], cs: &[words], ..Case::default() };
        assert_advice(Code::E0603, &case);
    }
}

/// Fixed cycles are modal; a straight line of Heidenhain is G01, in rapid G00; a second `=` is one too many.
#[test]
fn statements_and_lines_of_other_controls() {
    let cycle = Case { blocks: "N20 MCALL CYCLE81(10,0,2)\n", en: &["until G80"], cs: &["do G80"], ..Case::default() };
    assert_advice(Code::E0111, &cycle);
    let line = Case { blocks: "N20 L X+10 Y5 FMAX\n", en: &["G00", "G01"], cs: &["G00", "G01"], ..Case::default() };
    assert_advice(Code::E0103, &line);
    let chain = Case {
        blocks: "N20 R1 = R2 = 5\n",
        en: &["only one"],
        cs: &["jediné"],
        never: &["radius", "poloměr"],
        ..Case::default()
    };
    assert_advice(Code::E0106, &chain);
}
