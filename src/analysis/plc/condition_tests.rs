//! Conditions as people write them: precedence, three values, numbers, faults with their fixes.

use super::*;
use crate::dict::{Dialect, Lang};

fn read(text: &str) -> Condition {
    Condition::read(text, &Machine::new(Dialect::Cnc872)).unwrap_or_else(|found| panic!("{text}: {found:?}"))
}

/// Whether a condition holds, with values of signals by name, now and before.
fn holds(text: &str, before: &[(&str, Value)], now: &[(&str, Value)]) -> bool {
    let condition = read(text);
    let of = |values: &[(&str, Value)]| -> Vec<Value> {
        let value = |signal: &&Signal| values.iter().find(|(name, _)| *name == signal.name).and_then(|found| found.1);
        condition.signals().iter().map(value).collect()
    };
    condition.holds(&of(before), &of(now))
}

fn now(text: &str, values: &[(&str, Value)]) -> bool {
    holds(text, &[], values)
}

#[test]
fn operators_bind_as_they_should() {
    let bits = |a, b, c| [("M03PI", Some(a)), ("M04PI", Some(b)), ("M19PI", Some(c))];
    for (a, b, c) in [(0, 0, 0), (0, 0, 1), (0, 1, 0), (0, 1, 1), (1, 0, 0), (1, 0, 1), (1, 1, 0), (1, 1, 1)] {
        let values = bits(a, b, c);
        let (x, y, z) = (a == 1, b == 1, c == 1);
        assert_eq!(now("M03PI | M04PI & M19PI", &values), x || y && z);
        assert_eq!(now("(M03PI | M04PI) & M19PI", &values), (x || y) && z);
        assert_eq!(now("!M03PI & M04PI | !(M19PI | M03PI)", &values), !x && (y || !z));
        assert_eq!(now("!!M03PI & M04PI != M19PI", &values), x && y != z);
        assert_eq!(now("!(M03PI == 0)", &values), x);
    }
}

/// An absent value is neither true nor false.
#[test]
fn three_values() {
    let absent = [("M03PI", Some(1)), ("M04PI", Some(0)), ("M41PI", None), ("BLK.H", None)];
    for text in ["M41PI", "!M41PI", "M41PI == 0", "BLK.H > 0", "!(BLK.H > 0)", "M41PI & M03PI", "M41PI | M04PI"] {
        assert!(!now(text, &absent), "{text}");
    }
    for text in ["M41PI | M03PI", "!(M41PI & M04PI)", "BLK.H == 5 | !M04PI"] {
        assert!(now(text, &absent), "{text}");
    }
    // The end of what was absent is no rise; of a conjunction that is false anyway it is.
    let bit = |value| [("M03PI", Some(1)), ("M41PI", value)];
    assert!(!holds("rising(M41PI)", &bit(None), &bit(Some(1))));
    assert!(holds("rising(M41PI)", &bit(Some(0)), &bit(Some(1))));
    assert!(holds("falling(M41PI)", &bit(Some(1)), &bit(Some(0))));
    assert!(!holds("falling(M41PI)", &bit(Some(1)), &bit(None)));
    assert!(!holds("rising(M41PI)", &bit(Some(1)), &bit(Some(1))));
    let low = [("M03PI", Some(0)), ("M41PI", None)];
    assert!(holds("rising(M03PI & M41PI)", &low, &bit(Some(1))));
}

#[test]
fn numbers() {
    let values = [("PB06", Some(0x19)), ("BLK.SpindleSpeed", Some(3_000_000_000)), ("BLK.H", Some(-500_000))];
    for (text, expected) in [
        ("PB06 == 19h", true),
        ("PB06 == 019H", true),
        ("PB06 == 1Ah", false),
        ("BLK.SpindleSpeed > 3000", false),
        ("BLK.SpindleSpeed >= +3000", true),
        ("BLK.SpindleSpeed < 3000.0000001", true),
        ("BLK.SpindleSpeed == 3000.0000001", false),
        ("BLK.SpindleSpeed == 3000.0000000", true),
        ("BLK.H == -.5", true),
        ("BLK.H > -0.50000001", true),
        ("BLK.H <= -0.5", true),
        ("BLK.H < BLK.SpindleSpeed", true),
        ("PB06 > BLK.H", true),
        ("PB06 <> 5", false),
    ] {
        if let Ok(condition) = Condition::read(text, &Machine::new(Dialect::Cnc872)) {
            assert!(!condition.signals().is_empty());
            assert_eq!(now(text, &values), expected, "{text}");
        } else {
            assert_eq!(text, "PB06 <> 5");
        }
    }
}

/// Mistakes: code, the text at their place, the fix.
fn wrong(text: &str) -> Vec<String> {
    let found = Condition::read(text, &Machine::new(Dialect::Cnc872)).expect_err(text);
    let shown = |diagnostic: &Diagnostic| {
        let Span { start, end } = diagnostic.at.span;
        let fix = diagnostic.fixes.first().map_or("-", |fix| fix.edits[0].text.as_str());
        assert!(!diagnostic.finding.message(Lang::En).is_empty());
        format!("{} `{}` at {start}: {fix}", diagnostic.code(), &text[start as usize..end as usize])
    };
    found.iter().map(shown).collect()
}

#[test]
fn errors_have_their_places_and_fixes() {
    for (text, expected) in [
        ("M03PI && !M08PI", vec!["E0903 `&&` at 6: &"]),
        ("PB06 === 19h | PB06 !== 19h", vec!["E0903 `===` at 5: ==", "E0903 `!==` at 20: !="]),
        ("M03PI || PB06 = 19h", vec!["E0903 `||` at 6: |", "E0903 `=` at 14: =="]),
        ("BLK.M[11] == 95", vec!["E0904 `95` at 13: 95h"]),
        ("PB06 == 300", vec!["E0904 `300` at 8: -"]),
        ("BLK.T > 9.5", vec!["E0904 `9.5` at 8: -"]),
        ("BLK.T == 12.0", vec!["E0904 `12.0` at 9: 12h"]),
        ("BLK.T == +12.", vec!["E0904 `+12.` at 9: 12h"]),
        ("NOT M03PI", vec!["E0903 `NOT` at 0: !"]),
        ("M03PI and M08PI Or M07PI", vec!["E0903 `and` at 6: &", "E0903 `Or` at 16: |"]),
        ("not PB06 == 19h", vec!["E0903 `not PB06 == 19h` at 0: !(PB06 == 19h)"]),
        ("M03PI NOT M04PI", vec!["E0903 `NOT` at 6: !"]),
        ("!PB06 == 19h", vec!["E0903 `!PB06 == 19h` at 0: !(PB06 == 19h)"]),
        ("M03PI & m08PI", vec!["E0902 `m08PI` at 8: M08PI"]),
        ("BLK[0].M11", vec!["E0902 `BLK[0].M11` at 0: BLK.M11"]),
        ("STOPPI", vec!["E0902 `STOPPI` at 0: -"]),
        ("PB06", vec!["E0903 `PB06` at 0: -"]),
        ("PB11 == FFh", vec!["E0903 `FFh` at 8: 0FFh"]),
        ("19h == PB06", vec!["E0903 `19h` at 0: -"]),
        ("", vec!["E0903 `` at 0: -"]),
        ("M03PI &", vec!["E0903 `` at 7: -"]),
        ("(M03PI", vec!["E0903 `` at 6: -"]),
        ("M03PI)", vec!["E0903 `)` at 5: -"]),
        ("M03PI M04PI", vec!["E0903 `M04PI` at 6: -"]),
        ("()", vec!["E0903 `)` at 1: -"]),
        ("1 < BLK.H < 3", vec!["E0903 `1` at 0: -"]),
        ("BLK.H < 3 < 5", vec!["E0903 `<` at 10: -"]),
        ("rising M03PI", vec!["E0903 `M03PI` at 7: -"]),
        ("rising(falling(M03PI))", vec!["E0903 `falling` at 7: -"]),
        ("BLK.H > 3,5", vec!["E0903 `3,5` at 8: 3.5"]),
        ("BLK.H > 1e5", vec!["E0903 `1e5` at 8: -"]),
        ("M03PI == 2", vec!["E0903 `2` at 9: -"]),
        ("M03PI < 0", vec!["E0903 `0` at 8: -"]),
        ("PB06 == 1.5", vec!["E0903 `1.5` at 8: -"]),
        ("PB11 > 0FFh", vec!["E0903 `0FFh` at 7: -"]),
        ("SPINDLE_GEAR_ACT_1 == 5", vec!["E0903 `5` at 22: -"]),
        ("M03PI & G01PI", vec!["E0902 `G01PI` at 8: -"]),
        ("M03", vec!["E0902 `M03` at 0: -"]),
        ("Z < 0", vec!["E0902 `Z` at 0: -"]),
        ("M03PI § M04PI", vec!["E0903 `§` at 6: -"]),
        ("BLK.H > 1234567890123456789", vec!["E0903 `1234567890123456789` at 8: -"]),
    ] {
        assert_eq!(wrong(text), expected, "{text}");
    }
    assert_eq!(Condition::read("BLK.T == 5", &Machine::new(Dialect::Cnc8x6)).unwrap_err()[0].code().as_str(), "E0902");
}

/// Words of programs in place of signals: the help names the signal, or the list where there is none.
#[test]
fn words_of_programs() {
    let list = ("`cnc872c plc --list` shows all signals", "všechny signály vypíše „cnc872c plc --list“");
    for (text, (en, cs)) in [
        ("M03", ("perhaps `M03PI` is meant", "možná mělo být „M03PI“")),
        ("Z<0", ("perhaps `BLK.AxNC[2]` is meant", "možná mělo být „BLK.AxNC[2]“")),
        ("G01PI", list),
    ] {
        let found = Condition::read(text, &Machine::new(Dialect::Cnc872)).unwrap_err();
        let help = |lang| found[0].finding.help(lang);
        assert_eq!((found.len(), help(Lang::En).as_deref(), help(Lang::Cs).as_deref()), (1, Some(en), Some(cs)));
    }
}

/// Depth is bounded, length is not; `!` of neighbours do not add up.
#[test]
fn deep_and_long() {
    for deep in ["(".repeat(101) + "M03PI", "!".repeat(100_000) + "M03PI", "!(".repeat(51) + "M03PI"] {
        let found = Condition::read(&deep, &Machine::new(Dialect::Cnc872)).unwrap_err();
        assert_eq!(found.len(), 1);
        let message = found[0].finding.message(Lang::En);
        assert_eq!(message, "more than 100 parentheses and `!` are within one another");
    }
    let group = format!("{}M03PI{}", "(".repeat(100), ")".repeat(100));
    for fine in [group, vec!["!M03PI"; 20_000].join(" & "), vec!["(M03PI)"; 20_000].join("|")] {
        assert!(!holds(&fine, &[], &[("M03PI", None)]));
    }
}

/// After a comparison a number may stand too.
#[test]
fn what_is_missing() {
    let said = |text: &str| {
        let found = Condition::read(text, &Machine::new(Dialect::Cnc872)).expect_err(text);
        found.iter().map(|found| found.finding.message(Lang::En)).collect::<Vec<_>>()
    };
    for text in ["PB06 ==", "PB06 == !", "PB06 = ", "(PB06 >= )"] {
        assert!(said(text).contains(&"a signal or a number is missing here".to_owned()), "{text}");
    }
    for text in ["PB06 == 19h &", "M03PI & | M04PI", "!"] {
        assert_eq!(said(text), ["a signal is missing here"], "{text}");
    }
}

/// A condition with its fixes applied can be read.
#[test]
fn fixes_help() {
    for text in [
        "M03PI && PB06 = 19",
        "M03PI AND NOT(M08PI)or not PB06 == 19h",
        "BLK.H => 3,5 || !PB06 == 19h",
        "blk.m11 & m03pi",
        "PB11 == FFh",
    ] {
        let mut fixed = text.to_owned();
        for _ in 0..4 {
            let Err(found) = Condition::read(&fixed, &Machine::new(Dialect::Cnc872)) else { break };
            let edit = found.iter().rev().find_map(|found| Some(found.fixes.first()?.edits[0].clone())).expect(text);
            let Span { start, end } = edit.at.span;
            fixed.replace_range(start as usize..end as usize, &edit.text);
        }
        assert!(Condition::read(&fixed, &Machine::new(Dialect::Cnc872)).is_ok(), "{text}: {fixed}");
    }
}

proptest::proptest! {
    /// No text makes it panic; places lie in the text.
    #[test]
    fn any_text(text in "([A-Za-z0-9 _.\\[\\]!&|=<>()ř,+-]{0,30}|(M03PI|PB06|BLK\\.H|!|&|\\||\\(|\\)| \
        |==|<|95h|12|rising){0,12})") {
        if let Err(found) = Condition::read(&text, &Machine::new(Dialect::Cnc872)) {
            assert!(!found.is_empty());
            for diagnostic in found {
                let Span { start, end } = diagnostic.at.span;
                assert!(text.get(start as usize..end as usize).is_some());
            }
        }
    }
}
