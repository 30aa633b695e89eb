//! The keys of those tables whose keys are names of the control: groups, parameters, codes, functions, constants.

use super::draft::{Draft, narrow};
use super::motion::TimedFunction;
use super::near::nearest;
use super::number::HIGHEST_PARAMETER;
use super::takes::{Takes, one_of, whole};
use crate::diag::{Code, KnownNames};
use crate::dict::{AxisLetter, Decimal, Dialect, GGroup, HIGHEST_L, Lang, M_GROUPS, Operation};

/// Highest number of a machine constant.
const HIGHEST_CONSTANT: u16 = 999;
/// Offset of the numbers of addresses among functions that take time.
pub(super) const TIMED_ADDRESS: u16 = 1000;
/// Highest operation code (PAR-8: two digits).
const HIGHEST_OPERATION: u16 = 99;
/// Highest number of a macrocycle.
const HIGHEST_MACROCYCLE: u16 = HIGHEST_L as u16;
/// Words for levels, with what they mean.
const LEVELS: [(&str, super::Level); 3] =
    [("allow", super::Level::Allow), ("warn", super::Level::Warn), ("deny", super::Level::Deny)];

/// A kind of names.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Names {
    /// G groups, `G0`–`G11` but `G4`, and M groups, `M1`–`M14`.
    Groups,
    /// Axes: their letters.
    Axes,
    /// Parameters: `R0`–`R95`.
    Parameters,
    /// Entries of the correction table: `1`–`99`, by D.
    Corrections,
    /// Operation codes: `00`–`99`; the leading zero may be left out.
    Operations,
    /// Fixed cycles: `G81`–`G89`.
    Cycles,
    /// Macrocycles: `L1`–`L9999`.
    Macrocycles,
    /// Functions that take time: M functions, and T, S, H, P, D, F.
    Timed,
    /// Machine constants: `R0`–`R999`; leading zeros may be written (`R06`).
    Constants,
    /// Diagnostics whose level can be set, by name or code.
    Lints,
}

impl Names {
    /// The number of the name; `None` when the name is not known. For [`Self::Lints`] the place in
    /// [`Code::ALL`], errors included; for [`Self::Axes`] the place in [`AxisLetter::ALL`]; for an M group
    /// [`M_GROUP`] more than its number.
    pub(super) fn number(self, name: &str) -> Option<u16> {
        match self {
            Self::Groups => plain(name, "G", 11).filter(|&number| number != 4).or_else(|| {
                let group = plain(name, "M", HIGHEST_M_GROUP).filter(|&group| group > 0)?;
                Some(M_GROUP + group)
            }),
            Self::Axes => (0..).zip(AxisLetter::ALL).find(|(_, letter)| letter.name() == name).map(|(at, _)| at),
            Self::Parameters => plain(name, "R", HIGHEST_PARAMETER),
            Self::Corrections => digits(name).filter(|&number| name.len() <= 2 && number > 0),
            Self::Operations => digits(name).filter(|_| name.len() <= 2),
            Self::Cycles => plain(name, "G", 89).filter(|&number| number >= 81),
            Self::Macrocycles => plain(name, "L", HIGHEST_MACROCYCLE).filter(|&number| number > 0),
            Self::Timed => match name.strip_prefix('M') {
                Some(number) => digits(number).filter(|number| *number <= u16::from(Dialect::HIGHEST_M)),
                None => {
                    let place = TimedFunction::ADDRESSES.iter().position(|letter| name == *letter)?;
                    u16::try_from(place).ok().map(|place| TIMED_ADDRESS + place)
                }
            },
            Self::Constants => digits(name.strip_prefix('R')?).filter(|_| name.len() <= 4),
            Self::Lints => {
                let code = Code::find(name).filter(|code| [code.name(), code.as_str()].contains(&name))?;
                Code::ALL.iter().position(|&other| other == code).and_then(|at| u16::try_from(at).ok())
            }
        }
    }

    /// The values that the name with that number takes; those of tables have rows.
    pub(super) fn takes(self, number: u16) -> Takes {
        match self {
            Self::Groups => group(number).map_or(Takes::MFunction, Takes::GFunction),
            Self::Axes => Takes::Number {
                min: Decimal::DIMENSION_MAX.negated(),
                max: Decimal::DIMENSION_MAX,
                set: |it, position| {
                    let letter = AxisLetter::ALL.get(usize::from(it.number)).copied();
                    it.settings.machine.start.extend(letter.map(|letter| (letter, position)));
                },
            },
            Self::Parameters => {
                Takes::ParameterValue(|it, value| it.settings.machine.parameters.extend([(narrow(it.number), value)]))
            }
            Self::Operations => one_of!(Operation, |it, operation| {
                it.settings.machine.operations.insert(narrow(it.number), operation);
            }),
            Self::Cycles => whole(1, i64::from(HIGHEST_L), |it, l| {
                it.settings.machine.cycles.insert(narrow(it.number), narrow(l));
            }),
            Self::Timed => Takes::Number { min: Decimal::ZERO, max: Decimal::whole(1_000_000), set: Draft::set_time },
            Self::Constants => Takes::Constant(Draft::set_constant),
            Self::Lints => one_of!([LEVELS], |it, level| {
                it.settings.lints.extend(code(it.number).map(|code| (code, level)));
            }),
            Self::Corrections | Self::Macrocycles => Takes::Flag(|_, _| {}),
        }
    }

    /// The name that was probably meant by one that is not known: one written a little otherwise, but no other number.
    pub(super) fn near(self, name: &str) -> Option<String> {
        if self == Self::Lints {
            let code = Code::find(name).filter(|code| code.is_configurable());
            return match code {
                Some(code) => Some(code.to_string()),
                None => nearest(name, settable().map(Code::name)),
            };
        }
        let upper = name.trim().to_ascii_uppercase();
        if matches!(self, Self::Axes | Self::Timed) {
            return self.number(&upper).map(|_| upper);
        }
        let (prefix, number) = upper.split_at_checked(upper.find(|c: char| c.is_ascii_digit())?)?;
        let number: u16 = number.parse().ok()?;
        let meant = match self {
            Self::Operations => format!("{number:02}"),
            Self::Corrections => number.to_string(),
            Self::Groups
            | Self::Axes
            | Self::Parameters
            | Self::Cycles
            | Self::Macrocycles
            | Self::Timed
            | Self::Constants
            | Self::Lints => {
                format!("{}{number}", prefix.trim_end())
            }
        };
        self.number(&meant).map(|_| meant)
    }

    /// All names with their numbers, for kinds with few of them; a pattern says the others.
    pub(super) fn listed(self) -> Option<Vec<(String, u16)>> {
        match self {
            Self::Groups => {
                let g = (0..=11).filter(|&number| number != 4).map(|number| format!("G{number}"));
                let m =
                    (1..=HIGHEST_M_GROUP).filter(|group| ![1, 7, 9].contains(group)).map(|group| format!("M{group}"));
                Some(g.chain(m).filter_map(|name| self.number(&name).map(|number| (name, number))).collect())
            }
            Self::Axes => Some(AxisLetter::ALL.into_iter().map(|letter| letter.name().to_owned()).zip(0..).collect()),
            Self::Cycles => Some((81..=89).map(|number| (format!("G{number}"), number)).collect()),
            Self::Lints => Some(
                settable()
                    .flat_map(|code| [code.name(), code.as_str()])
                    .filter_map(|name| Some((name.to_owned(), self.number(name)?)))
                    .collect(),
            ),
            Self::Parameters
            | Self::Corrections
            | Self::Operations
            | Self::Macrocycles
            | Self::Timed
            | Self::Constants => None,
        }
    }

    /// The names as a regular expression, for kinds with many of them.
    pub(super) const fn pattern(self) -> Option<&'static str> {
        match self {
            Self::Parameters => Some("^R([0-9]|[1-8][0-9]|9[0-5])$"),
            Self::Corrections => Some("^(0?[1-9]|[1-9][0-9])$"),
            Self::Operations => Some("^[0-9]{1,2}$"),
            Self::Macrocycles => Some("^L[1-9][0-9]{0,3}$"),
            Self::Timed => Some("^(M(0*([0-9]{1,2}|100))|[TSHPDF])$"),
            Self::Constants => Some("^R[0-9]{1,3}$"),
            Self::Groups | Self::Axes | Self::Cycles | Self::Lints => None,
        }
    }

    /// The names as a note of W0705 says them.
    pub(super) const fn known(self) -> KnownNames {
        match self {
            Self::Groups => KnownNames::Groups,
            Self::Axes => KnownNames::Axes,
            Self::Parameters => KnownNames::Parameters,
            Self::Corrections => KnownNames::Corrections,
            Self::Operations => KnownNames::Operations,
            Self::Cycles => KnownNames::Cycles,
            Self::Macrocycles => KnownNames::Macrocycles,
            Self::Timed => KnownNames::Timed,
            Self::Constants => KnownNames::Constants,
            Self::Lints => KnownNames::Lints,
        }
    }

    /// The names as the reference page gives them in `lang`.
    pub(super) fn shown(self, lang: Lang) -> String {
        let to = match lang {
            Lang::En => "to",
            Lang::Cs => "až",
        };
        match self {
            Self::Groups => String::new(),
            Self::Axes => AxisLetter::ALL.map(|letter| format!("`{letter}`")).join(", "),
            Self::Parameters => format!("`R0` {to} `R{HIGHEST_PARAMETER}`"),
            Self::Corrections => format!("`1` {to} `99`"),
            Self::Operations => format!("`\"00\"` {to} `\"{HIGHEST_OPERATION}\"`"),
            Self::Cycles => format!("`G81` {to} `G89`"),
            Self::Macrocycles => format!("`L1` {to} `L{HIGHEST_MACROCYCLE}`"),
            Self::Timed => format!("`M00` {to} `M100`, `T`, `S`, `H`, `P`, `D`, `F`"),
            Self::Constants => format!("`R0` {to} `R{HIGHEST_CONSTANT}`"),
            Self::Lints => match lang {
                Lang::En => "name or code".to_owned(),
                Lang::Cs => "jméno nebo kód".to_owned(),
            },
        }
    }
}

/// What [`Names::Groups`] adds to the number of an M group.
const M_GROUP: u16 = 100;
/// The last M group.
const HIGHEST_M_GROUP: u16 = M_GROUPS as u16 - 1;

/// The M group that a number of [`Names::Groups`] is.
pub(super) fn m_group(number: u16) -> Option<u8> {
    u8::try_from(number.checked_sub(M_GROUP)?).ok()
}

/// The G group that a number of [`Names::Groups`] is.
pub(super) fn group(number: u16) -> Option<GGroup> {
    GGroup::ALL.get(usize::from(number)).copied()
}

/// The code at that place of [`Code::ALL`].
pub(super) fn code(number: u16) -> Option<Code> {
    Code::ALL.get(usize::from(number)).copied()
}

/// The codes whose level can be set.
pub(super) fn settable() -> impl Iterator<Item = Code> {
    Code::ALL.iter().copied().filter(|code| code.is_configurable())
}

/// A number without leading zeros behind `prefix`, at most `highest`.
fn plain(name: &str, prefix: &str, highest: u16) -> Option<u16> {
    let text = name.strip_prefix(prefix)?;
    digits(text).filter(|&number| number <= highest && (text.len() == 1 || !text.starts_with('0')))
}

/// Digits and nothing else.
fn digits(text: &str) -> Option<u16> {
    if text.is_empty() || !text.bytes().all(|byte| byte.is_ascii_digit()) { None } else { text.parse().ok() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_numbers() {
        for (names, name, number) in [
            (Names::Groups, "G0", Some(0)),
            (Names::Groups, "G11", Some(11)),
            (Names::Groups, "G4", None),
            (Names::Groups, "G12", None),
            (Names::Groups, "G01", None),
            (Names::Groups, "M2", Some(102)),
            (Names::Groups, "M14", Some(114)),
            (Names::Groups, "M0", None),
            (Names::Groups, "M15", None),
            (Names::Axes, "X", Some(0)),
            (Names::Axes, "W", Some(8)),
            (Names::Axes, "x", None),
            (Names::Axes, "E", None),
            (Names::Parameters, "R95", Some(95)),
            (Names::Parameters, "R96", None),
            (Names::Parameters, "R", None),
            (Names::Corrections, "7", Some(7)),
            (Names::Corrections, "07", Some(7)),
            (Names::Corrections, "0", None),
            (Names::Corrections, "100", None),
            (Names::Operations, "01", Some(1)),
            (Names::Operations, "1", Some(1)),
            (Names::Operations, "00", Some(0)),
            (Names::Operations, "100", None),
            (Names::Operations, "+1", None),
            (Names::Cycles, "G81", Some(81)),
            (Names::Cycles, "G80", None),
            (Names::Macrocycles, "L9001", Some(9001)),
            (Names::Macrocycles, "L09001", None),
            (Names::Macrocycles, "L0", None),
            (Names::Constants, "R06", Some(6)),
            (Names::Constants, "R432", Some(432)),
            (Names::Constants, "R1000", None),
            (Names::Constants, "R0006", None),
            (Names::Constants, "56", None),
            (Names::Lints, "no-such-name", None),
            (Names::Lints, "w0214", None),
        ] {
            assert_eq!(names.number(name), number, "{name}");
        }
        assert_eq!(Names::Lints.number("W0214"), Names::Lints.number("empty-block"));
    }

    #[test]
    fn near_names() {
        for (names, name, near) in [
            (Names::Parameters, "r10", Some("R10")),
            (Names::Parameters, "R010", Some("R10")),
            (Names::Parameters, "R96", None),
            (Names::Operations, "001", Some("01")),
            (Names::Cycles, "g81", Some("G81")),
            (Names::Macrocycles, "l09001", Some("L9001")),
            (Names::Corrections, "D7", Some("7")),
            (Names::Groups, "G4", None),
            (Names::Groups, "G 5", Some("G5")),
            (Names::Groups, "m02", Some("M2")),
            (Names::Axes, "x", Some("X")),
            (Names::Axes, "E", None),
            (Names::Lints, "emptyblock", Some("empty-block")),
            (Names::Lints, "w0214", Some("W0214")),
            (Names::Lints, "e0302", None),
            (Names::Constants, "R", None),
            (Names::Constants, "č1", None),
        ] {
            assert_eq!(names.near(name).as_deref(), near, "{name}");
        }
    }

    /// Listed names, and those that fit the pattern, are the known ones.
    #[test]
    fn lists_agree_with_numbers() {
        for names in [Names::Groups, Names::Axes, Names::Cycles, Names::Lints] {
            for (name, number) in names.listed().unwrap() {
                assert_eq!(names.number(&name), Some(number), "{name}");
            }
            assert!(names.pattern().is_none());
        }
    }
}
