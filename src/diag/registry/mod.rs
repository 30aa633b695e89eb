//! Every diagnostic: code, name, level, fields, English and Czech text. Everything else about diagnostics is made from
//! the rows of these files: `explain`, the reference pages, JSON names, `[lints]`.
//!
//! A text is a format string with the fields by name, or an expression in parentheses over the fields that gives a
//! string; an empty help or note is left out. Messages are short and complete alone; the note says why, the help says
//! what to write.

mod characters;
mod flow;
mod motion;
mod parameters;
mod rows;
mod settings;
mod structure;
mod words;

use characters::characters;
use flow::flow;
use motion::motion;
use parameters::parameters;
use settings::settings;
use structure::structure;
use words::words;

use super::advice::{center_help, either, is_exchanged, is_value, unnumbered_line, unused_centers};
use super::other_controls::foreign_g;
use super::values::{control_digits, of_group, other_range, range_cs};
use super::{
    AddressMeant, AfterEndMeant, ArcMeant, ArcPoints, ArithmeticFault, CenterPlace, CommaMeant, ConfigNeed,
    ConfigProblem, ConstantProblem, DwellMeant, EarlyEnd, JointBreak, JointLimit, KnownNames, Meant, NameKind, NotUsed,
    NumberMeant, OtherControl, OtherMeaning, ParameterNeed, PlaneFault, PointMeant, QuoteMeant, SpindleFault,
    TargetMeant, TextMeant, Unmodelled, Unread, UnreadEnd, UnusedMeant, ValueMeant,
};
use crate::dict::{Address, Dialect, FeedPer, GCode, GGroup, Lang, Plane, REDUCED_FEED};
use crate::sure::Sure;
pub use rows::Severity;
use rows::{diagnostics, optional_text, text};

/// A number with its thousands apart.
fn grouped(number: u64, separator: char) -> String {
    let digits = number.to_string();
    let ends = (1..=digits.len()).rev();
    let apart = |(digit, left): (char, usize)| {
        let separator = (left % 3 == 1 && left > 1).then_some(separator);
        std::iter::once(digit).chain(separator)
    };
    digits.chars().zip(ends).flat_map(apart).collect()
}

/// Blocks in Czech behind their number.
const fn blocks_cs(count: u64) -> &'static str {
    match count {
        1 => "blok",
        2..=4 => "bloky",
        _ => "bloků",
    }
}

/// `text` with the nearest thing in it, or nothing when there is none.
fn nearest<T: std::fmt::Display>(candidate: Option<&T>, before: &str, after: &str) -> String {
    candidate.map(|found| format!("{before}{found}{after}")).unwrap_or_default()
}

// Each file hands its rows on to the next; the last makes types of all.
characters! { [structure words flow parameters motion settings diagnostics] }

/// The names that the table knows, where they can be said in a line.
fn known_names(known: Option<&KnownNames>, near: Option<&str>, lang: Lang) -> String {
    match (known, near, lang) {
        (Some(known), _, _) => known.text(lang),
        (None, Some("dialect"), Lang::En) => "the run goes on for cnc872, unless --dialect says otherwise".to_owned(),
        (None, Some("dialect"), Lang::Cs) => "kontroluje se pro cnc872, neurčí-li --dialect jinak".to_owned(),
        (None, _, _) => String::new(),
    }
}

/// How often a joint is passed, when more than once.
fn times(count: u64, lang: Lang) -> String {
    match (count, lang) {
        (0 | 1, _) => String::new(),
        (_, Lang::En) => format!("{count} times in this program"),
        (_, Lang::Cs) => format!("v programu {count}×"),
    }
}

/// What happens at a block that is too short to stop in.
fn no_room_note(count: u64, lang: Lang) -> String {
    let why = match lang {
        Lang::En => "without envelope velocity the control brakes at most one block ahead",
        Lang::Cs => "bez obálkové rychlosti systém brzdí nejvýše jeden blok předem",
    };
    let times = times(count, lang);
    if times.is_empty() { why.to_owned() } else { format!("{why}; {times}") }
}
