//! Which signals are shown: names and patterns.

use super::dictionary::{Signal, signals};
use super::run_time::{self, RunTime};
use crate::dict::Dialect;
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
    let of_control = signals().iter().filter(|signal| signal.row.is_of(dialect));
    // Of equals the first of the dictionary.
    let best = of_control.map(like).fold(None, |best: Option<(&Signal, f64)>, next| match best {
        Some(best) if best.1 >= next.1 => Some(best),
        _ => Some(next),
    });
    best.filter(|(_, likeness)| *likeness >= 0.6).map(|(signal, _)| signal.name.clone())
}

/// Whether the pattern, in which `*` stands for any characters, matches the whole name.
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
