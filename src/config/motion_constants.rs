//! The machine constants that motion depends on, as data: which decades hold what (S3 A6.2, A7.3).

use super::motion::{MotionKey, Profile, Recognition, SetKey};
use crate::dict::Decimal;

/// A constant as the file writes it.
#[derive(Clone, Debug, Eq, PartialEq)]
pub(super) struct Written {
    /// Its digits; of a number as written.
    pub digits: String,
    /// Whether it is a text: its digits as they are, missing leading ones are zeros. A number is what the control
    /// shows, with three decimals.
    pub quoted: bool,
}

/// The eight decades of a constant, and its sign.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) struct Decades {
    digits: u32,
    negative: bool,
}

/// A mistake in the writing of a constant.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Miswritten {
    /// More than eight digits, or in a text something else than digits behind a sign.
    Digits,
    /// A sign where the constant has none.
    Sign,
}

impl Decades {
    /// Reads a constant.
    pub(super) fn read(written: &Written, signed: bool) -> Result<Self, Miswritten> {
        let thousandths = if written.quoted {
            let digits = written.digits.strip_prefix(['+', '-']).unwrap_or(&written.digits);
            if digits.is_empty() || digits.len() > 8 || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
                return Err(Miswritten::Digits);
            }
            digits.parse().map_err(|_| Miswritten::Digits)?
        } else {
            let (number, exact) = super::number::parse_rounding(&written.digits).ok_or(Miswritten::Digits)?;
            let shown = number.abs().thousandths();
            u32::try_from(shown)
                .ok()
                .filter(|shown| exact && Decimal::whole(i64::from(*shown)) <= Decimal::WHOLE_MAX)
                .ok_or(Miswritten::Digits)?
        };
        let negative = written.digits.starts_with('-') && thousandths != 0;
        if negative && !signed {
            return Err(Miswritten::Sign);
        }
        Ok(Self { digits: thousandths, negative })
    }

    /// Decades `first` to `last`, 1 the rightmost, as a whole number.
    pub(super) const fn part(self, first: u32, last: u32) -> u32 {
        self.digits / 10_u32.pow(first - 1) % 10_u32.pow(last - first + 1)
    }

    /// The constant as a number, in thousandths, with its sign.
    const fn thousandths(self) -> Decimal {
        let digits = self.digits as i64;
        Decimal::from_thousandths(if self.negative { -digits } else { digits })
    }
}

/// What decades of a constant hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Holds {
    /// These decades are a key's value.
    Whole(MotionKey, u32, u32),
    /// The constant as shown is a key's value; it may have a sign.
    Thousandths(MotionKey),
    /// A decade: 1 manual, 2 automatic recognition.
    Recognition(u32),
    /// A decade: 0 ramps, 1 linear, 2 parabolic.
    Profile(u32),
    /// The control word of a set, the rapid one being set 0.
    Control(u8),
    /// A value of a set.
    Set(u8, SetKey),
    /// Nothing that is used: W0707.
    Nothing,
}

impl Holds {
    /// Whether it is a key's number.
    pub(super) const fn is_number(self) -> bool {
        matches!(self, Self::Whole(..) | Self::Thousandths(_))
    }

    /// Whether the digits are a choice each, and no quantity.
    const fn is_choice(self) -> bool {
        matches!(self, Self::Recognition(_) | Self::Profile(_) | Self::Control(_))
    }
}

/// Whether a whole number of `--set`, where quotes are lost, is the digits of that constant and no quantity: digits
/// that are choices, or all eight.
pub(super) fn is_digits(number: u16, written: &str) -> bool {
    let choices = holds(number).is_some_and(|holds| holds.iter().any(|holds| holds.is_choice()));
    (choices || written.len() == 8) && written.bytes().all(|byte| byte.is_ascii_digit())
}

/// Every constant that motion depends on.
pub(super) const CONSTANTS: &[(u16, &[Holds])] = &[
    (39, &[Holds::Thousandths(MotionKey::Angle)]),
    (52, &[Holds::Whole(MotionKey::Accel, 1, 8)]),
    (97, &[Holds::Recognition(1)]),
    (232, &[Holds::Nothing]),
    (236, &[Holds::Whole(MotionKey::AccelContinuous, 1, 8)]),
    (237, &[Holds::Whole(MotionKey::AccelRapid, 1, 8)]),
    (338, &[Holds::Profile(2)]),
    (382, &[Holds::Thousandths(MotionKey::BreakLength)]),
    (383, &[Holds::Thousandths(MotionKey::MergeLength)]),
    (384, &[Holds::Whole(MotionKey::Accuracy, 1, 4), Holds::Whole(MotionKey::Red, 5, 6)]),
    (385, &[Holds::Whole(MotionKey::Overload, 1, 7)]),
    (386, &[Holds::Thousandths(MotionKey::RaiseLength)]),
    (395, &[Holds::Whole(MotionKey::Raise, 1, 8)]),
    (406, &[Holds::Control(1)]),
    (407, &[Holds::Set(1, SetKey::Parabolic)]),
    (408, &[Holds::Set(1, SetKey::Linear)]),
    (409, &[Holds::Set(1, SetKey::Accuracy), Holds::Whole(MotionKey::Red, 5, 6)]),
    (410, &[Holds::Set(1, SetKey::Overload)]),
    (411, &[Holds::Set(1, SetKey::Centripetal)]),
    (412, &[Holds::Control(2)]),
    (413, &[Holds::Set(2, SetKey::Parabolic)]),
    (414, &[Holds::Set(2, SetKey::Linear)]),
    (415, &[Holds::Set(2, SetKey::Accuracy)]),
    (416, &[Holds::Set(2, SetKey::Overload)]),
    (417, &[Holds::Set(2, SetKey::Centripetal)]),
    (418, &[Holds::Control(3)]),
    (419, &[Holds::Set(3, SetKey::Parabolic)]),
    (420, &[Holds::Set(3, SetKey::Linear)]),
    (421, &[Holds::Set(3, SetKey::Accuracy)]),
    (422, &[Holds::Set(3, SetKey::Overload)]),
    (423, &[Holds::Set(3, SetKey::Centripetal)]),
    (424, &[Holds::Control(4)]),
    (425, &[Holds::Set(4, SetKey::Parabolic)]),
    (426, &[Holds::Set(4, SetKey::Linear)]),
    (427, &[Holds::Set(4, SetKey::Accuracy)]),
    (428, &[Holds::Set(4, SetKey::Overload)]),
    (429, &[Holds::Set(4, SetKey::Centripetal)]),
    (430, &[Holds::Control(0)]),
    (431, &[Holds::Set(0, SetKey::Parabolic)]),
    (432, &[Holds::Set(0, SetKey::Linear)]),
];

/// The contents of the constant of that number; `None`: nothing about motion.
pub(super) fn holds(number: u16) -> Option<&'static [Holds]> {
    CONSTANTS.iter().find(|(constant, _)| *constant == number).map(|(_, holds)| *holds)
}

/// The meaning of a single decade.
pub(super) const fn recognition(digit: u32) -> Option<Recognition> {
    match digit {
        1 => Some(Recognition::Manual),
        2 => Some(Recognition::Automatic),
        _ => None,
    }
}

/// The meaning of a single decade, or the digits that it takes.
pub(super) fn profile(digit: u32) -> Result<Profile, &'static str> {
    match digit {
        0 => Ok(Profile::Ramps),
        1 => Ok(Profile::Linear),
        2 => Ok(Profile::Parabolic),
        _ => Err("0, 1, 2"),
    }
}

/// The value of a set in its constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SetDigits {
    /// The value, in thousandths of the key's unit.
    pub value: Decimal,
    /// Whether a correction is in decade 8 that nothing can be made of, or a percentage.
    pub unused: bool,
}

/// Reads the value of a set from its constant, or says which digits decade 8 takes.
pub(super) fn set_value(key: SetKey, decades: Decades) -> Result<SetDigits, &'static str> {
    let seven = i64::from(decades.part(1, 7));
    let eighth = decades.part(8, 8);
    let value =
        |thousandths: i64, unused: bool| Ok(SetDigits { value: Decimal::from_thousandths(thousandths), unused });
    match key {
        SetKey::Parabolic => match eighth {
            0 => value(seven * 1000, false),
            2 => value(seven * 10, false),
            3 => value(seven, false),
            _ => Err("0, 2, 3"),
        },
        SetKey::Linear => value(i64::from(decades.part(1, 8)) * 1000, false),
        SetKey::Accuracy => value(i64::from(decades.part(1, 4)) * 1000, false),
        SetKey::Overload => value(seven * 1000, eighth != 0),
        SetKey::Centripetal => match eighth {
            0 => value(0, seven != 0),
            1 => value(seven * 100, false),
            _ => Err("0, 1"),
        },
    }
}

/// The number of a key that decades hold.
pub(super) fn number(holds: Holds, decades: Decades) -> Option<(MotionKey, Decimal)> {
    match holds {
        Holds::Whole(key, first, last) => Some((key, Decimal::whole(i64::from(decades.part(first, last))))),
        Holds::Thousandths(key) => Some((key, decades.thousandths())),
        Holds::Recognition(_) | Holds::Profile(_) | Holds::Control(_) | Holds::Set(..) | Holds::Nothing => None,
    }
}
