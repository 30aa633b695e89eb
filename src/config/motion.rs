//! What motion is computed with: `[motion]` of the project file, or the machine constants that give the same values.

use std::collections::BTreeMap;

pub use super::motion_keys::MotionKey;
use super::motion_keys::SET;
use crate::dict::{AxisLetter, Decimal, Dialect};
use crate::named::named;

named! {
    /// How the control recognises that blocks join continuously (S3 A3, A4).
    #[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
    pub enum Recognition {
        /// G23 and G24 alone decide.
        Manual "manual",
        /// G23 switches it on; the angle decides.
        #[default]
        Automatic "automatic",
    }
}

named! {
    /// The course of the velocity.
    #[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
    pub enum Profile {
        /// Without envelope velocity (S3 A3).
        Ramps "ramps",
        /// Envelope velocity with constant accelerations (S3 A6).
        #[default]
        Linear "linear",
        /// Envelope velocity with limited jerk (S3 A7).
        Parabolic "parabolic",
    }
}

impl Profile {
    /// Of a control that says nothing.
    pub const fn of(dialect: Dialect) -> Self {
        match dialect {
            Dialect::Cnc8x6 => Self::Ramps,
            Dialect::Cnc8x9 | Dialect::Cnc872 => Self::Linear,
        }
    }
}

/// The values of a dynamic set.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub enum SetKey {
    /// `parabolic`: P.
    Parabolic,
    /// `linear-mm-s2`: A.
    Linear,
    /// `accuracy-um`.
    Accuracy,
    /// `overload-mm-s2`.
    Overload,
    /// `centripetal-mm-s2`.
    Centripetal,
}

impl SetKey {
    /// Every one, in the order of the constants.
    pub const ALL: [Self; 5] = [Self::Parabolic, Self::Linear, Self::Accuracy, Self::Overload, Self::Centripetal];

    /// As in the project file.
    pub fn name(self) -> &'static str {
        SET.get(self as usize).map_or("", |row| row.name)
    }
}

/// A value of a set.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum SetValue {
    /// This number.
    Number(Decimal),
    /// The value of the parameter of that number at the time.
    Parameter(u8),
}

/// Where a value comes from.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum From {
    /// Nobody said anything.
    #[default]
    Default,
    /// The key of the project file.
    Key,
    /// A machine constant.
    Constant(u16),
    /// The command line.
    Set,
}

impl From {
    /// As records say it, `key` being the name of the key.
    pub fn shown(self, key: &str) -> String {
        match self {
            Self::Default => "default".to_owned(),
            Self::Key => format!("motion.{key}"),
            Self::Constant(number) => format!("R{number}"),
            Self::Set => "--set".to_owned(),
        }
    }
}

/// A value and where it comes from.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Given<T> {
    /// The value.
    pub value: T,
    /// Who gave it.
    pub from: From,
}

/// Velocity of G00, mm/min or deg/min (VEL-2).
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum Rapid {
    /// Along the path.
    Path(Decimal),
    /// By axis; 10000 for those that it lacks.
    Axes(Vec<(AxisLetter, Decimal)>),
}

impl Rapid {
    /// What an axis that a table lacks has, mm/min.
    pub const DEFAULT: Decimal = Decimal::whole(10_000);
}

/// A function that takes time.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub enum TimedFunction {
    /// An M function, by number.
    M(u16),
    /// Writing T, S, H, P, D or F.
    Address(&'static str),
}

impl TimedFunction {
    /// The addresses whose words take time.
    pub const ADDRESSES: [&'static str; 6] = ["T", "S", "H", "P", "D", "F"];

    /// `M06`, `T`.
    pub fn name(self) -> String {
        match self {
            Self::M(number) => format!("M{number:02}"),
            Self::Address(letter) => letter.to_owned(),
        }
    }
}

/// A dynamic set: the values that are given.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
pub struct DynamicSet {
    /// By place in [`SetKey::ALL`].
    pub values: [Option<Given<SetValue>>; 5],
}

impl DynamicSet {
    /// A value.
    pub fn get(&self, key: SetKey) -> Option<Given<SetValue>> {
        self.values.get(key as usize).copied().flatten()
    }

    pub(super) fn set(&mut self, key: SetKey, value: Given<SetValue>) {
        if let Some(slot) = self.values.get_mut(key as usize) {
            *slot = Some(value);
        }
    }
}

/// What motion is computed with.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Motion {
    /// Whether the project file says anything about it; else all is assumed.
    pub configured: bool,
    /// By place in [`MotionKey::ALL`].
    numbers: [Given<Option<Decimal>>; MotionKey::ALL.len()],
    /// How joints are recognised.
    pub recognition: Given<Recognition>,
    /// The course of the velocity.
    pub profile: Given<Profile>,
    /// Velocity of G00.
    pub rapid: Given<Rapid>,
    /// Set 0 is that of G00, 1 to 4 those of G23; none where a set is not there.
    pub sets: [Option<DynamicSet>; 5],
    /// A criterion is on that needs `cycle-ms`, which nobody gave: it does not limit anything.
    pub lacks_cycle: bool,
    /// Seconds that functions take (TIM-1).
    pub times: BTreeMap<TimedFunction, Given<Decimal>>,
}

impl Motion {
    /// What holds on a control whose project file says nothing.
    pub fn new(dialect: Dialect) -> Self {
        Self {
            configured: false,
            numbers: MotionKey::ALL.map(|key| Given { value: key.default(dialect), from: From::Default }),
            recognition: Given::default(),
            profile: Given { value: Profile::of(dialect), from: From::Default },
            rapid: Given { value: Rapid::Path(Rapid::DEFAULT), from: From::Default },
            sets: Default::default(),
            lacks_cycle: false,
            times: BTreeMap::new(),
        }
    }

    /// A number with its source; `None` where there is none.
    pub fn given(&self, key: MotionKey) -> Given<Option<Decimal>> {
        self.numbers.get(key as usize).copied().unwrap_or_default()
    }

    /// A number in force; 0 where there is none. `raise-ms` 0 is 500, `accel-continuous-mm-s2` 0 is `accel-mm-s2`.
    pub fn number(&self, key: MotionKey) -> Decimal {
        let value = self.given(key).value.unwrap_or(Decimal::ZERO);
        let or = |other| if value == Decimal::ZERO { other } else { value };
        if key == MotionKey::Raise {
            or(Decimal::whole(500))
        } else if key == MotionKey::AccelContinuous {
            or(self.number(MotionKey::Accel))
        } else {
            value
        }
    }

    /// The value of a dynamic set that counts in a block (VEL-14): of the set, else of set 1, else of the keys above. A
    /// value by parameter that is unknown or 0 is missing. 0: none.
    pub fn dynamic(&self, set: usize, key: SetKey, parameter: impl Fn(u8) -> Option<Decimal>) -> Decimal {
        let of = |set: usize| {
            let value = match self.sets.get(set)?.as_ref()?.get(key)?.value {
                SetValue::Number(number) => number,
                SetValue::Parameter(number) => parameter(number)?,
            };
            (value > Decimal::ZERO).then_some(value)
        };
        let single = || match key {
            SetKey::Parabolic => Decimal::ZERO,
            SetKey::Linear => self.number(MotionKey::AccelContinuous),
            SetKey::Accuracy => self.number(MotionKey::Accuracy),
            SetKey::Overload => self.number(MotionKey::Overload),
            SetKey::Centripetal => self.number(MotionKey::Centripetal),
        };
        of(set).or_else(|| of(1)).unwrap_or_else(single)
    }

    /// Whether values of dynamic sets depend on parameters.
    pub fn depends_on_parameters(&self) -> bool {
        let values = self.sets.iter().flatten().flat_map(|set| set.values.iter().flatten());
        self.profile.value == Profile::Parabolic
            && values.into_iter().any(|value| matches!(value.value, SetValue::Parameter(_)))
    }

    pub(super) fn set_number(&mut self, key: MotionKey, value: Decimal, from: From) {
        if let Some(slot) = self.numbers.get_mut(key as usize) {
            *slot = Given { value: Some(value), from };
        }
    }
}
