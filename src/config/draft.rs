//! The settings while a project file is read: values go straight into their fields. What must fit other values is kept
//! with its place until all of them are known.

use std::collections::BTreeMap;

use super::motion::{From, Given, MotionKey, Profile, Rapid, Recognition, SetKey, SetValue, TimedFunction};
use super::motion_constants::Written;
use super::names::{TIMED_ADDRESS, m_group};
use super::{Axis, Limits, MayMove, Motion, Settings};
use crate::dict::{AxisLetter, Decimal, Dialect, GCode};
use crate::sure::Sure;
use crate::text::Location;

/// Texts, each at its place.
pub(super) type Texts = Vec<(String, Location)>;

/// Where a value stands.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place {
    /// Its key.
    pub key: Location,
    /// The value as written; of a table its key.
    pub at: Location,
    /// The project file or the command line.
    pub from: From,
}

/// The keys of one of `[[axes]]`.
#[derive(Debug, Default)]
pub(super) struct NewAxis {
    /// `letter`.
    pub letter: Option<AxisLetter>,
    /// `kind`.
    pub rotary: Option<bool>,
    /// `min`.
    pub min: Option<Decimal>,
    /// `max`.
    pub max: Option<Decimal>,
}

/// The keys of one of `[[gears]]`.
#[derive(Debug, Default)]
pub(super) struct NewGear {
    /// `m`.
    pub m: Option<u8>,
    /// `min`.
    pub min: Option<u32>,
    /// `max`.
    pub max: Option<u32>,
    /// `output`.
    pub output: Option<Decimal>,
}

/// A machine constant, R0–R999.
#[derive(Clone, Debug)]
pub(super) struct WrittenConstant {
    /// Its number.
    pub number: u16,
    /// Its digits.
    pub written: Written,
    /// Its place.
    pub place: Place,
}

/// The settings so far, and what cannot be judged yet.
#[derive(Debug, Default)]
pub(super) struct Draft {
    /// The settings.
    pub settings: Settings,
    /// The command line says which control it is: `dialect` of the file does not count.
    pub dialect_is_fixed: bool,
    /// The file has a dialect that is not known: nothing that depends on it can be judged.
    pub dialect_is_unusable: bool,
    /// The number of the name whose value is being taken.
    pub number: u16,
    /// The place of the value that is being taken.
    pub place: Place,
    /// The places of all values that were taken, by path: `limits.speed`, `start.X`. Of a list those of its last table.
    pub places: BTreeMap<String, Place>,
    /// The axis that is being read.
    pub axis: NewAxis,
    /// The gear that is being read.
    pub gear: NewGear,
    /// The axes, each letter once: the places of their tables and letters.
    pub axes: Vec<(Axis, Place)>,
    /// The gears, each M once, at their M.
    pub gears: Vec<(u8, Location)>,
    /// Letters under `machine-macrocycles`, with the number of the macrocycle.
    pub moved_axes: Vec<(u32, AxisLetter, Location)>,
    /// Folders of macrocycles as written.
    pub macrocycles: Texts,
    /// Path of the ChannelConfig as written.
    pub channel_config: Option<(String, Place)>,
    /// M groups with their functions at power-up; whether they go together shows when all groups are known.
    pub m_power_up: Vec<(u8, u8, Location)>,
    /// Machine constants, in the order of the text.
    pub constants: Vec<WrittenConstant>,
}

/// A number of another type; its row keeps it in range.
pub(super) fn narrow<T: TryFrom<N> + Default, N>(number: N) -> T {
    T::try_from(number).ok().sure()
}

impl Draft {
    /// The defaults of the control that the command line says, else of the default one.
    pub(super) fn new(dialect: Option<Dialect>) -> Self {
        let settings = Settings::new(dialect.unwrap_or_default());
        Self { settings, dialect_is_fixed: dialect.is_some(), ..Self::default() }
    }

    /// `dialect`. It is the first row: nothing that depends on it is set yet.
    pub(super) fn set_dialect(&mut self, dialect: Dialect) {
        if !self.dialect_is_fixed {
            self.settings = Settings::new(dialect);
        }
    }

    /// `extensions`.
    pub(super) fn set_extensions(&mut self, extensions: Texts) {
        self.settings.extensions = extensions.into_iter().map(|(name, _)| name.to_ascii_lowercase()).collect();
    }

    /// `[limits]`.
    pub(super) const fn limits(&mut self) -> &mut Limits {
        &mut self.settings.machine.limits
    }

    /// One of `[power-up]` (GRP-3).
    pub(super) fn set_power_up(&mut self, code: GCode) {
        if let Some(slot) = self.settings.machine.power_up.get_mut(code.group().index()) {
            *slot = Some(code);
        }
    }

    /// One of `[power-up]` (MFN-7).
    pub(super) fn set_m_power_up(&mut self, m: i64) {
        self.m_power_up.extend(m_group(self.number).map(|group| (group, narrow(m), self.place.at)));
    }

    /// `axes` of `[machine-macrocycles.L9001]` (FLW-12).
    pub(super) fn set_moved_axes(&mut self, names: Texts) {
        let number = u32::from(self.number);
        let letter = |name: &str| AxisLetter::ALL.into_iter().find(|letter| letter.name() == name);
        let axes: Vec<_> = names.iter().filter_map(|(name, at)| Some((letter(name)?, *at))).collect();
        self.moved_axes.extend(axes.iter().map(|(letter, at)| (number, *letter, *at)));
        let axes = axes.into_iter().map(|(letter, _)| letter).collect();
        self.settings.machine.macrocycles.insert(number, MayMove::Only(axes));
    }

    /// `radius` of `[corrections.7]` (EQU-1).
    pub(super) fn set_correction(&mut self, radius_mm: Decimal) {
        self.settings.machine.corrections.insert(narrow(self.number), radius_mm);
    }

    /// One of `[machine-constants]`; those of the command line concern motion alone.
    pub(super) fn set_constant(&mut self, written: Written) {
        if self.place.from == From::Key {
            let digits = written.digits.strip_prefix('+').unwrap_or(&written.digits);
            self.settings.machine.constants.insert(self.number, digits.to_owned());
        }
        self.constants.push(WrittenConstant { number: self.number, written, place: self.place });
    }

    const fn motion(&mut self) -> &mut Motion {
        &mut self.settings.machine.motion
    }

    const fn given<T>(&self, value: T) -> Given<T> {
        Given { value, from: self.place.from }
    }

    /// A number of `[motion]`.
    pub(super) fn number(&mut self, key: MotionKey, value: Decimal) {
        let from = self.place.from;
        self.motion().set_number(key, value, from);
    }

    /// A whole number of `[motion]`.
    pub(super) fn whole(&mut self, key: MotionKey, value: i64) {
        self.number(key, Decimal::whole(value));
    }

    /// `recognition` of `[motion]`.
    pub(super) fn set_recognition(&mut self, recognition: Recognition) {
        self.motion().recognition = self.given(recognition);
    }

    /// `profile` of `[motion]`.
    pub(super) fn set_profile(&mut self, profile: Profile) {
        self.motion().profile = self.given(profile);
    }

    /// `rapid-mm-min` of `[motion]`. Axes of the command line stand over those of the file.
    pub(super) fn set_rapid(&mut self, mut rapid: Rapid) {
        if let (From::Set, Rapid::Axes(tried), Rapid::Axes(before)) =
            (self.place.from, &mut rapid, &self.settings.machine.motion.rapid.value)
        {
            let kept: Vec<_> =
                before.iter().filter(|(letter, _)| tried.iter().all(|(other, _)| other != letter)).copied().collect();
            tried.extend(kept);
            tried.sort_unstable_by_key(|(letter, _)| *letter as usize);
        }
        self.motion().rapid = self.given(rapid);
    }

    /// A value of `[motion.sets.1]` and its like; the set for G00 is set 0.
    pub(super) fn set_of_motion(&mut self, key: SetKey, value: Decimal) {
        let (set, given) = (usize::from(self.number), self.given(SetValue::Number(value)));
        if let Some(slot) = self.motion().sets.get_mut(set) {
            slot.get_or_insert_default().set(key, given);
        }
    }

    /// One of `[motion.times]`.
    pub(super) fn set_time(&mut self, seconds: Decimal) {
        let function = match self.number.checked_sub(TIMED_ADDRESS) {
            Some(place) => TimedFunction::Address(TimedFunction::ADDRESSES.get(usize::from(place)).copied().sure()),
            None => TimedFunction::M(self.number),
        };
        let given = self.given(seconds);
        self.motion().times.insert(function, given);
    }
}
