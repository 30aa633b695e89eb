//! Which signals are shown: names and patterns.

use super::dictionary::{Signal, signals};
use super::run_time::{self, RunTime};
use crate::config::Machine;
use crate::dict::{AxisLetter, Dialect};
use crate::sure::Sure;

/// A name or pattern that matches no signal of the control.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct NoSignal {
    /// As written.
    pub name: String,
    /// What can be said of it.
    pub why: Why,
}

/// What can be said of a name that matches no signal.
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum Why {
    /// A part program does not determine it.
    RunTime {
        /// Why not; the first such name that matches.
        name: &'static str,
    },
    /// Another control has it.
    OtherControl,
    /// It is like that one.
    Near(String),
    /// Nothing is like it.
    Nothing,
}

/// The signals that are shown when none are named: those of the command block on CNC872, else the compatible ones, with
/// `compatible` both. Those that only `[motion]` gives a value are left out without it.
pub fn default(dialect: Dialect, compatible: bool, motion: bool) -> Vec<&'static Signal> {
    let has_block = dialect.has_command_block();
    let shown = |signal: &&Signal| {
        signal.row.is_of(dialect)
            && (signal.row.is_of_command_block() || compatible || !has_block)
            && (motion || !signal.needs_motion())
    };
    signals().iter().filter(shown).collect()
}

/// The signals that a list of names and patterns chooses, separated by commas, in the order of the dictionary.
///
/// # Errors
/// The first name that matches nothing.
pub fn named(list: &str, dialect: Dialect) -> Result<Vec<&'static Signal>, NoSignal> {
    let patterns: Vec<String> = list
        .split(',')
        .map(|name| name.split_whitespace().collect::<String>())
        .filter(|name| !name.is_empty())
        .collect();
    let of = |pattern: &str| {
        let pattern = pattern.to_owned();
        signals().iter().filter(move |signal| signal.row.is_of(dialect) && matches(&pattern, &signal.name))
    };
    for pattern in &patterns {
        if of(pattern).next().is_none() {
            return Err(NoSignal { name: pattern.clone(), why: why_none(pattern, dialect) });
        }
    }
    if patterns.is_empty() {
        return Err(NoSignal { name: list.trim().to_owned(), why: Why::Nothing });
    }
    let chosen = |signal: &&Signal| patterns.iter().any(|pattern| matches(pattern, &signal.name));
    Ok(signals().iter().filter(|signal| signal.row.is_of(dialect)).filter(chosen).collect())
}

/// The same signals, and the compatible ones, in the order of the dictionary; those that need `[motion]` only with it.
pub fn with_compatible(chosen: &[&'static Signal], dialect: Dialect, motion: bool) -> Vec<&'static Signal> {
    let compatible = |signal: &Signal| !signal.row.is_of_command_block() && (motion || !signal.needs_motion());
    let is_chosen = |signal: &Signal| chosen.iter().any(|other| other.name == signal.name);
    let of_control = signals().iter().filter(|signal| signal.row.is_of(dialect));
    of_control.filter(|signal| compatible(signal) || is_chosen(signal)).collect()
}

/// What can be said of a name or pattern that matches no signal of the control.
pub fn why_none(name: &str, dialect: Dialect) -> Why {
    let known = |known: &&RunTime| {
        known.is_of(dialect) && (matches(name, &known.name) || known.family.as_deref() == Some(name))
    };
    let named = || run_time::find(name).filter(|known| known.is_of(dialect));
    if let Some(known) = run_time::names().iter().find(known).or_else(named) {
        return Why::RunTime { name: &known.name };
    }
    if signals().iter().any(|signal| matches(name, &signal.name)) {
        return Why::OtherControl;
    }
    nearest(name, dialect).map_or(Why::Nothing, Why::Near)
}

/// The signal that the word of a program means which somebody wrote for it: `M03PI` for `M03`, `BLK.AxNC[2]` for `Z`.
pub fn of_word(name: &str, machine: &Machine) -> Option<String> {
    let has = |signal: &str| signals().iter().any(|known| known.name == signal && known.row.is_of(machine.dialect));
    let mut letters = name.chars();
    let letter = letters.next()?.to_ascii_uppercase();
    let digits = letters.as_str();
    let candidates = if digits.is_empty() {
        let axis = AxisLetter::ALL.into_iter().find(|axis| axis.letter() == letter);
        match (letter, axis) {
            ('T', _) => vec!["BLK.T".to_owned(), "PB07".to_owned()],
            ('H', _) => vec!["BLK.H".to_owned(), "PB05".to_owned()],
            ('S', _) => vec!["BLK.SpindleSpeed".to_owned(), "PB12".to_owned()],
            ('F', _) => vec!["BLK.FeedProgr".to_owned()],
            (_, Some(axis)) => {
                let place = machine.axes.index(axis)?;
                vec![format!("BLK.AxNC[{place}]"), format!("PO_OS{letter}PI")]
            }
            (_, None) => Vec::new(),
        }
    } else {
        let number: u8 = digits.parse().ok()?;
        let word = format!("{letter}{number:02}");
        vec![format!("{word}PI"), format!("{word}PID"), format!("{word}_PID")]
    };
    candidates.into_iter().find(|candidate| has(candidate))
}

/// The name most like `name`. `BLK[0].M11`, as PLC programs write it, is `BLK.M11`.
pub fn nearest(name: &str, dialect: Dialect) -> Option<String> {
    let plain = run_time::plain(name);
    let upper = plain.to_ascii_uppercase();
    let like = |signal: &'static Signal| {
        let likeness = if signal.name == plain {
            1.0
        } else {
            // The case of letters counts little: an exact name in another case is the nearest.
            0.99 * strsim::normalized_damerau_levenshtein(&signal.name.to_ascii_uppercase(), &upper)
        };
        (signal, likeness)
    };
    // Another number is another function: `G00PI` is no help for `G01PI`.
    let numbers = |name: &str| name.bytes().filter(u8::is_ascii_digit).collect::<Vec<_>>();
    let own = numbers(&plain);
    let is_other = |signal: &Signal| !own.is_empty() && numbers(&signal.name) != own;
    let of_control = signals().iter().filter(|signal| signal.row.is_of(dialect) && !is_other(signal));
    // Of equals the first of the dictionary.
    let best = of_control.map(like).fold(None, |best: Option<(&Signal, f64)>, next| match best {
        Some(best) if best.1 >= next.1 => Some(best),
        _ => Some(next),
    });
    best.filter(|(_, likeness)| *likeness >= 0.6).map(|(signal, _)| signal.name.clone())
}

/// Whether the pattern, in which `*` matches any characters, matches the whole name.
pub fn matches(pattern: &str, name: &str) -> bool {
    let mut parts = pattern.split('*');
    let first = parts.next().unwrap_or_default();
    let Some(mut rest) = name.strip_prefix(first) else { return false };
    let parts: Vec<&str> = parts.collect();
    let Some((last, middle)) = parts.split_last() else { return rest.is_empty() };
    for part in middle {
        match rest.find(part) {
            Some(at) => rest = rest.get(at + part.len()..).sure(),
            None => return false,
        }
    }
    rest.ends_with(last)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(list: &str) -> Vec<&'static str> {
        named(list, Dialect::Cnc872).unwrap().iter().map(|signal| signal.name.as_str()).collect()
    }

    #[test]
    fn patterns() {
        for (pattern, name, expected) in [
            ("ZMM*", "ZMM1PI", true),
            ("*", "PB06", true),
            ("ZMM*PI", "ZMM14PI", true),
            ("BLK.M[*]", "BLK.M[10]", true),
            ("BLK.M[*]", "BLK.M10", false),
            ("*PI*PI", "M03PI", false),
            ("PB06", "PB06", true),
            ("PB0", "PB06", false),
            ("a*b*a", "aba", true),
            ("a*ba", "aba", true),
            ("ab*ba", "aba", false),
        ] {
            assert_eq!(matches(pattern, name), expected, "{pattern} {name}");
        }
    }

    #[test]
    fn chosen_in_the_order_of_the_dictionary_each_once() {
        assert_eq!(names(" PB0 6, BLK.M[10],PB06 ,"), ["BLK.M[10]", "PB06"]);
        assert_eq!(names("ZMM1*PI"), ["ZMM1PI", "ZMM10PI", "ZMM11PI", "ZMM12PI", "ZMM13PI", "ZMM14PI"]);
    }

    #[test]
    fn defaults() {
        let count = |dialect, compatible, motion| default(dialect, compatible, motion).len();
        let block = count(Dialect::Cnc872, false, false);
        let old = count(Dialect::Cnc8x6, false, false);
        assert_eq!(count(Dialect::Cnc872, true, false), block + old);
        assert_eq!(count(Dialect::Cnc872, false, true), block + 2);
        assert_eq!(count(Dialect::Cnc8x9, false, true), old + 2);
        assert_eq!(count(Dialect::Cnc8x6, true, true), old + 2);
        let named = named("BLK.T,G23ACT,PB06", Dialect::Cnc872).unwrap();
        assert_eq!(with_compatible(&named, Dialect::Cnc872, false).len(), old + 2);
        assert!(default(Dialect::Cnc872, false, true).iter().all(|signal| signal.name.starts_with("BLK.")));
    }

    /// Words of programs, and numbers that are other functions.
    #[test]
    fn words_and_numbers() {
        let new = Machine::new(Dialect::Cnc872);
        let word = |name: &str| of_word(name, &new);
        let is = |name: &str| Some(name.to_owned());
        assert_eq!(
            [word("M03"), word("m3"), word("M00"), word("M06")],
            [is("M03PI"), is("M03PI"), is("M00_PID"), is("M06PID")]
        );
        assert_eq!([word("Z"), word("T"), word("S")], [is("BLK.AxNC[2]"), is("BLK.T"), is("BLK.SpindleSpeed")]);
        assert_eq!([word("M91"), word("G01"), word("Q"), word("PB06")], [None, None, None, None]);
        assert_eq!(of_word("Z", &Machine::new(Dialect::Cnc8x6)), is("PO_OSZPI"));
        assert_eq!(nearest("G01PI", Dialect::Cnc872), None);
    }

    #[test]
    fn what_matches_nothing_gets_its_reason() {
        let why = |list: &str, dialect| named(list, dialect).unwrap_err().why;
        let near = |name: &str| Why::Near(name.to_owned());
        assert_eq!(why("ZMM10P", Dialect::Cnc872), near("ZMM10PI"));
        assert_eq!(why("m03pi", Dialect::Cnc872), near("M03PI"));
        assert_eq!(why("BLK[0].M11", Dialect::Cnc872), near("BLK.M11"));
        assert_eq!(why("BLK[1].REAL.H", Dialect::Cnc872), near("BLK.H"));
        assert_eq!(why("MP*PI", Dialect::Cnc872), Why::RunTime { name: "MPXPI" });
        assert_eq!(why("MPxPI", Dialect::Cnc872), Why::RunTime { name: "MPXPI" });
        assert_eq!(why("BLK.*", Dialect::Cnc8x9), Why::OtherControl);
        assert_eq!(why("BLK[1].TchlOff", Dialect::Cnc872), Why::RunTime { name: "BLK.TchlOff" });
        assert_eq!(why("BLK.M[0]", Dialect::Cnc872), Why::RunTime { name: "BLK.M[0]" });
        assert_eq!(why("AxG", Dialect::Cnc872), Why::RunTime { name: "BLK.AxG[0]" });
        assert_eq!(why("DISPTOC1.TOC_ROW", Dialect::Cnc8x6), Why::RunTime { name: "TOC_ROW" });
        assert_eq!(why("ZMMxPI", Dialect::Cnc872), near("ZMM1PI"));
        assert_eq!(why("PO_OSxPI", Dialect::Cnc872), near("PO_OSXPI"));
        assert_eq!(why("", Dialect::Cnc872), Why::Nothing);
        assert_eq!(why("příruba", Dialect::Cnc872), Why::Nothing);
        assert_eq!(named("PB06,QQQQQ", Dialect::Cnc872).unwrap_err().name, "QQQQQ");
    }
}
