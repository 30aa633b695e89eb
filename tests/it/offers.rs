//! Changes that findings offer without being sure: each removes its finding and gives no other one.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use cnc872c::config::{configure, find_project};
use cnc872c::diag::{Code, Diagnostic, Findings, Fix};
use cnc872c::dict::Lang;
use cnc872c::edit::apply_fixes;
use cnc872c::session::Session;
use cnc872c::text::{FileId, MemoryLoader, SourceText, Sources};

use crate::disk::files;
use crate::markers::{Request, request};
use crate::samples::root;

/// The findings of a program in memory.
fn check(loader: &MemoryLoader, file: &str, request: &Request) -> Option<Vec<Diagnostic>> {
    let project = find_project(Path::new(""), loader);
    let (mut sources, mut findings) = (Sources::new(), Findings::new());
    let settings = configure(project.as_deref(), &request.overrides, loader, &mut sources, &mut findings);
    if findings.has_errors() {
        return None;
    }
    let session = Session { loader, settings: &settings, progress: None };
    let outcome = session.check(Path::new(file), file);
    Some(outcome.findings.items().iter().filter(|item| settings.severity(item.code()).is_some()).cloned().collect())
}

/// The findings of a program alone.
fn check_text(program: &str) -> Vec<Diagnostic> {
    check(&MemoryLoader::new().with("p.nc", program), "p.nc", &Request::default()).unwrap()
}

fn counts(found: &[Diagnostic]) -> BTreeMap<Code, usize> {
    let mut counts = BTreeMap::new();
    for item in found {
        *counts.entry(item.code()).or_default() += 1;
    }
    counts
}

/// The text after a change of it.
fn changed(text: &str, fix: &Fix) -> String {
    let source = SourceText::from_text("", text);
    let fixed = apply_fixes(&source, FileId(0), text.as_bytes(), [fix]);
    assert_eq!(fixed.applied, [0], "{}", fix.title.text(Lang::En));
    String::from_utf8(fixed.bytes).unwrap()
}

/// The offers for the only finding of that code, and the program after each.
fn offered(program: &str, code: Code) -> (String, String) {
    let found = check_text(program);
    let item = found.iter().find(|item| item.code() == code);
    let item = item.unwrap_or_else(|| panic!("no {code} in {program:?}: {:?}", counts(&found)));
    let fix = item.fixes.first().unwrap_or_else(|| panic!("{code} offers nothing in {program:?}"));
    assert!(fix.certain.is_none(), "{code}: nothing applies this by itself");
    let now = changed(program, fix);
    let (before, after) = (counts(&found), counts(&check_text(&now)));
    assert_eq!(after.get(&code).copied().unwrap_or(0) + 1, before[&code], "{code} stays in {now:?}");
    for (code, count) in &after {
        assert!(before.get(code).is_some_and(|before| count <= before), "{code} comes by the offer: {now:?}");
    }
    (fix.title.text(Lang::En), now)
}

#[test]
fn what_is_offered() {
    let cases = [
        (
            Code::E0404,
            "%1\nN10 G71 L110\nN20 M30\nN30 G79 L100\nN40 G0 X1\nN50 G70\n",
            "write `G71 L100`",
            "G71 L100\n",
        ),
        (Code::E0406, "%1\nN10 G0 X1\nN20 G73 L11 Q2\nN30 M30\n", "write `G73 L10`", "G73 L10 Q2\n"),
        (Code::E0304, "%1\nN10 G0. X1\nN20 M30\n", "write `G0`", "N10 G0 X1\n"),
        (Code::E0205, "%1\nN10 G0 X1\nN20 M20\n", "write `M30`", "N20 M30\n"),
        (Code::E0305, "%1\nN10 S+500 M03\nN20 M30\n", "write `S500`", "N10 S500 M03\n"),
        (Code::E0205, "%1\nN10 G0 X1\n", "insert `N20 M30`", "N10 G0 X1\nN20 M30\n"),
        (
            Code::E0207,
            "%1\nN10 G71 L5\nN20 M30\nN30 G79 L5\nN40 G0 X1 \"up\"\n",
            "insert `N50 G70`",
            "N40 G0 X1 \"up\"\nN50 G70\n",
        ),
        (Code::E0204, "%1\nN10 G0 X1\nN10 X2\nN20 M30\n", "write `N15`", "N10 G0 X1\nN15 X2\n"),
        // N20 belongs where the first one is.
        (Code::E0204, "%1\nN10 G0 X1\nN30 X2\nN30 X3\nN40 M30\n", "write `N20`", "N20 X2\nN30 X3\n"),
        (Code::E0401, "%1\nN10 G71 Q2\nN20 M30\nN30 G79 L5\nN40 G0 X1\nN50 G70\n", "write `G71 L5`", "G71 L5 Q2\n"),
        (Code::E0411, "%1\nN10 G04\nN20 M30\n", "write `G04 Q100`", "N10 G04 Q100\n"),
        (Code::W0214, "%1\nN10 G0 X1\nN20\nN30 M30\n", "delete N20", "%1\nN10 G0 X1\nN30 M30\n"),
        (
            Code::W0211,
            "%1\nN10 G0 X1\nN20 M30\n\n\"a pocket\"\nN30 G79 L5\nN40 X1\nN50 G70\n",
            "delete the subprogram L5",
            "N20 M30\n\n",
        ),
        (Code::W0303, "%1\nN10 G0 X10.0012\nN20 M30\n", "write `X10.001`", "X10.001\n"),
        (Code::W0402, "%1\nN10 G0 X1 L5\nN20 M30\n", "delete `L5`", "N10 G0 X1\n"),
        (Code::W0403, "%1\nN10 G0 X1 Q5\nN20 M30\n", "delete `Q5`", "N10 G0 X1\n"),
    ];
    for (code, program, title, result) in cases {
        let (offered, now) = offered(program, code);
        assert_eq!(offered, title, "{code}");
        assert!(now.contains(result), "{code}: {now:?}");
    }
}

/// A macrocycle is called as one, and the lines of a file end as they did.
#[test]
fn other_functions_and_line_ends() {
    let loader = |text: &str| MemoryLoader::new().with("p.nc", text).with("L9001", "N1 G79 L9001\nN2 G0 X1\nN3 G70\n");
    let text = "%1\r\nN10 G71 L9001\r\n";
    let found = check(&loader(text), "p.nc", &Request::default()).unwrap();
    let fixes: Vec<&Fix> = found.iter().flat_map(|item| &item.fixes).collect();
    let mut now = text.to_owned();
    for fix in fixes.iter().rev() {
        now = changed(&now, fix);
    }
    assert_eq!(now, "%1\r\nN10 G72 L9001\r\nN20 M30\r\n");
    assert!(check(&loader(&now), "p.nc", &Request::default()).unwrap().is_empty());
}

/// A program in which nothing is wrong, for slips.
const MODEL: &str = "%1200 \"PRIRUBA\"\n\
    N10 G54 G17 G90 G94 G40\n\
    N20 T1 M06 \"FREZA D16\"\n\
    N30 S1200 M03\n\
    N40 G00 X-15 Y-75\n\
    N50 Z50 M08\n\
    N60 Z2\n\
    N70 G01 Z0 F600 D1\n\
    N80 G71 L100 Q3\n\
    N90 G00 Z2\n\
    N100 G01 X45 Y10.5 F300\n\
    N130 G91 G01 X-5 Y0.5\n\
    N140 G73 L130 Q4\n\
    N150 G90 G00 Z100 M09\n\
    N160 M30\n\
    N1000 G79 L100\n\
    N1010 G91 G01 Z-4.2 F400\n\
    N1020 G90 X100 Y20 F260\n\
    N1030 G70\n";

/// Where it is not certain what was meant, `--fix` changes nothing: it would be another move, jump or call without a
/// word.
#[test]
fn what_a_fix_would_guess() {
    assert!(check_text(MODEL).is_empty());
    for (right, slip) in [
        ("X45 Y10.5", "X45 10.5"),
        ("X-5 Y0.5", "X-5 0.5"),
        ("X100 Y20", "X100 20"),
        ("X45 Y10.5", "Y45 10.5"),
        ("X45 Y10.5", "XX45 10.5"),
        ("N60 Z2", "NN60 2"),
        ("X100 Y20", "X100, 20"),
        ("Z50 M08", "Z50 ,8"),
        ("T1 M06", "T1,0 M06"),
        ("G79 L100", "G79 L1,00"),
        ("T1 M06 \"FREZA D16\"", "T1 (FREZA D16 M06"),
        ("G00 Z100 M09", "(ZPET G00 Z100 M09"),
        ("G00 Z100 M09", "{ZPET G00 Z100 M09"),
        ("N60 Z2", "N60 Z2 ; DOLU N65 G01 Z0"),
        ("Y10.5 F300", "Y10;5 F300"),
        ("Z50 M08", "Z5(0 M08"),
        ("S1200 M03", "S12;00 M03"),
        ("L100 Q3", "L100;3"),
        ("X-15 Y-75", "X15− Y-75"),
        ("X45", "X#1*2"),
    ] {
        assert!(MODEL.contains(right), "{right}");
        let found = check_text(&MODEL.replacen(right, slip, 1));
        assert!(!found.is_empty(), "{slip}: nothing is said");
        for item in &found {
            assert!(item.certain_fix().is_none(), "{slip}: {} {:?}", item.code(), item.certain_fix());
        }
    }
    for (right, slip, fixed) in [
        ("X45 Y10.5", "XO Y10.5", "X0 Y10.5"),
        ("X45 Y10.5", "X45 Y-  10.5", "X45 Y-10.5"),
        ("X45 Y10.5", "X45,5 Y10.5", "X45.5 Y10.5"),
        ("N60 Z2", "N60 Z2 (dolu)", "N60 Z2 \"dolu\""),
    ] {
        let program = MODEL.replacen(right, slip, 1);
        let found = check_text(&program);
        let fix = found.iter().find_map(Diagnostic::certain_fix).unwrap_or_else(|| panic!("{slip}: {found:?}"));
        assert_eq!(changed(&program, fix), MODEL.replacen(right, fixed, 1), "{slip}");
    }
}

/// Where a slip may have been one of several, each reading is offered, and none that its address does not take.
#[test]
fn several_readings() {
    let cases: [(&str, &[&str]); 55] = [
        ("F1 50X3", &["write `F150`"]),
        ("G0X41. 5Z2", &["write `Z52`", "write `X41.5`"]),
        ("T1 2M6", &["write `M26`", "write `T12`"]),
        ("Z2 5D12", &["write `Z2.5`", "write `Z25`"]),
        ("S14 80M03", &["write `M80`", "write `S1480`"]),
        ("X-31Y5 5", &["write `Z5`", "write `Y5.5`", "write `Y55`"]),
        ("S1 780 M03", &["write `S1780`"]),
        ("X45 10.5", &["write `Y10.5`", "write `X4510.5`"]),
        ("5.000 D1", &[]),
        ("G1 -5", &[]),
        ("S118, M3", &[]),
        ("S15,0", &[]),
        ("G4é0", &[]),
        ("X5áY3", &["write `X58`", "write a plain blank"]),
        ("G01áX5", &["write a plain blank"]),
        ("MM530", &[]),
        ("G5e4", &[]),
        ("M31=2.000", &[]),
        ("G100.000", &[]),
        ("X1 P129.0", &[]),
        ("G73 .L30", &[]),
        ("S+480", &["write `S480`", "write `S1480`"]),
        ("G+1", &[]),
        ("T2 N6", &["write `M6`", "delete N6"]),
        ("G91 X5\nN40 G91 X5", &["delete N40", "write `N50`"]),
        ("X1\nN45 X2\nN40 G73 L40 Q2", &[]),
        ("X-3LY55", &[]),
        ("F100O", &["write `F1000`", "write `F100`"]),
        ("S450BM03", &["write `S4508`", "write `S450`"]),
        ("X1O0", &["write `X100`", "write `X10`"]),
        ("T2.0 M6", &["write `T2`", "write `T20`"]),
        ("X5\nN50 X6 N40", &["write `M40`", "delete N40"]),
        ("R15B25.5", &[]),
        ("X5YřZ1", &["write `Y5`"]),
        ("X-ě5 Y1", &["write `X-25`"]),
        ("T2\" M6     \"vrtak D8\"", &["delete `\"`"]),
        ("G0\n1 Z-2", &[]),
        ("G71 1100", &["write `L1100`", "write `L100`"]),
        ("G71 100", &["write `L100`"]),
        ("G2 X10.05 Y10 I0 J10", &[]),
        ("G2 X20 Y0 I0 J10", &["write `I10 J0`"]),
        ("G0\n50 Z-2", &["write `N50`"]),
        ("Z50 0M9", &["write `M09`", "write `Z50.0`", "write `Z500`"]),
        ("T5 0M6", &["write `M06`", "write `T50`"]),
        ("Z100 09", &["write `M09`", "write `Z100.09`", "write `Z10009`"]),
        ("X1 00", &["write `X1.00`", "write `X100`"]),
        ("G95 Z-3 F0 12", &["write `F0.12`", "write `F012`"]),
        ("Y0 3", &["write `Z3`", "write `Y0.3`"]),
        ("S-500", &[]),
        ("G71 L10 3x", &["write `Q3`"]),
        ("X=65", &["write `X65`", "write `X-65`"]),
        ("Z=R12", &["write `ZR12`", "write `Z-R12`"]),
        ("F=100", &["write `F100`"]),
        ("X=-65", &["write `X-65`"]),
        ("T=2", &["write `T2`"]),
    ];
    for (slip, wanted) in cases {
        let program = format!("%1\nN20 T1 M06 D1\nN30 G00 X0 Y0 Z5 F100 S500 M03\nN40 {slip}\nN90 M30\n");
        let found = check_text(&program);
        let [item] = found.as_slice() else { panic!("{slip}: {found:?}") };
        let titles: Vec<String> = item.fixes.iter().map(|fix| fix.title.text(Lang::En)).collect();
        assert_eq!(titles, wanted, "{slip}: {}", item.code());
    }
    // A blank within a block number, or a function without its letter: the numbers of the blocks around tell.
    for (above, slip, wanted) in [
        ("N90 G1", "N1 00 X50", &["write `N100`"][..]),
        ("N90 G1", "N1\t00 M5", &["write `N100`"]),
        ("N90 G1", "N1 01 X50", &["write `N101`"]),
        ("N90 G1", "N1 08 X50", &["write `N108`"]),
        ("N90 G1", "N1 00", &["write `N100`"]),
        ("N90 G1", "N100 00 X50", &["write `G00`"]),
        ("\"start\"", "N1 00 X50", &["write `G00`", "write `N100`"]),
        ("N90 T1", "N1 02 M6", &["write `N102`"]),
    ] {
        let found = check_text(&format!("%1\n{above} F100\n{slip}\nN110 M30\n"));
        let item = found.iter().find(|item| item.code() == Code::E0102).unwrap_or_else(|| panic!("{slip}: {found:?}"));
        let titles: Vec<String> = item.fixes.iter().map(|fix| fix.title.text(Lang::En)).collect();
        assert_eq!(titles, wanted, "{slip}");
    }
    // No turning cycle is a call of the only subprogram.
    let found = check_text("%1\nN10 G71 U10 W2\nN20 M30\nN30 G79 L10\nN40 G0 X1\nN50 G70\n");
    assert!(matches!(found.as_slice(), [item] if item.code() == Code::E0401 && item.fixes.is_empty()), "{found:?}");
}

/// An offer is applied also where the text holds letters of a code page: letters outside ASCII keep their bytes.
#[test]
fn words_with_a_comment_between_brackets() {
    let program = "%1\n(N10 G0 X5 \"díra\" Y0)\nN20 M30\n";
    let (title, now) = offered(program, Code::E0101);
    assert_eq!(title, "write `N10 G0 X5 \"díra\" Y0`");
    assert_eq!(now, "%1\nN10 G0 X5 \"díra\" Y0\nN20 M30\n");
}

/// Findings that appear after a change, in samples with more than one slip.
const BROUGHT_TO_LIGHT: [(&str, &[Code]); 10] = [
    ("lex-bracket-words.nc", &[Code::E0603]),
    ("lex-numbers.nc", &[Code::E0307]),
    ("blk-skip-on.nc", &[Code::W0601]),
    ("lex-one-finding.nc", &[Code::E0203, Code::E0302, Code::E0305, Code::W0402, Code::W0403]),
    ("E0101-semicolons.nc", &[Code::E0306]),
    ("W0113-other-control.nc", &[Code::E0101, Code::E0203]),
    // The comma may be in a number that other blocks write without it.
    ("entry-number-malformed.nc", &[Code::E0404]),
    // The point may be one too many.
    ("entry-number-point.nc", &[Code::E0404]),
    ("end-number-point.nc", &[Code::E0205]),
    // The number may be that of M03.
    ("function-letter-lost.nc", &[Code::W0619]),
];

/// In all samples: what is offered removes its finding, and gives no other. So does what `--fix` writes where one thing
/// is wrong.
#[test]
fn offers_in_samples() {
    let mut tried = 0;
    let mut wrong = Vec::new();
    for folder in ["err", "rules", "slips"] {
        let mut samples: Vec<PathBuf> =
            fs::read_dir(root().join("samples").join(folder)).unwrap().map(|entry| entry.unwrap().path()).collect();
        samples.sort();
        for sample in samples {
            let (base, file) = if sample.is_dir() {
                (sample.clone(), "program.nc".to_owned())
            } else {
                (sample.parent().unwrap().to_path_buf(), sample.file_name().unwrap().to_str().unwrap().to_owned())
            };
            let Ok(bytes) = fs::read(base.join(&file)) else { continue };
            let (request, Ok(text)) = (request(&bytes), String::from_utf8(bytes)) else { continue };
            let mut loader = MemoryLoader::new();
            if sample.is_dir() {
                for path in files(&base) {
                    loader = loader.with(path.strip_prefix(&base).unwrap(), fs::read(&path).unwrap());
                }
            }
            let Some(found) = check(&loader.clone().with(&file, text.as_str()), &file, &request) else { continue };
            let before = counts(&found);
            for (item, fix) in found.iter().flat_map(|item| item.fixes.iter().map(move |fix| (item, fix))) {
                if fix.certain.is_some() && folder != "slips" || item.at.file != FileId(0) {
                    continue;
                }
                tried += 1;
                let now = changed(&text, fix);
                let after = counts(&check(&loader.clone().with(&file, now), &file, &request).unwrap());
                let name = sample.display().to_string();
                let title = format!("{}: {} {}", sample.display(), item.code(), fix.title.text(Lang::En));
                if after.get(&item.code()).copied().unwrap_or(0) >= before[&item.code()] {
                    wrong.push(format!("{title}: the finding stays"));
                }
                for (code, count) in &after {
                    let shown =
                        BROUGHT_TO_LIGHT.iter().any(|(file, codes)| name.ends_with(file) && codes.contains(code));
                    if !shown && before.get(code).is_none_or(|before| count > before) {
                        wrong.push(format!("{title}: gives {code}"));
                    }
                }
            }
        }
    }
    assert!(tried > 40, "{tried}");
    assert!(wrong.is_empty(), "{} of {tried}:\n{}", wrong.len(), wrong.join("\n"));
}
