//! What an estimate rests on: every value in force, with where it comes from.

use crate::config::{GivenBy, Motion, MotionKey, Profile, Rapid, SetKey, SetValue, Settings};
use crate::dict::{AxisLetter, Decimal};

/// A value of the machine.
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum BasisValue {
    /// A number.
    Number(Decimal),
    /// One of a closed set.
    Name(&'static str),
    /// A number by axis.
    Axes(Vec<(AxisLetter, Decimal)>),
    /// The value of a parameter at the time.
    Parameter(u8),
}

impl std::fmt::Display for BasisValue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(number) => number.fmt(f),
            Self::Name(name) => f.write_str(name),
            Self::Parameter(number) => write!(f, "R{number}"),
            Self::Axes(axes) if axes.is_empty() => f.write_str("{}"),
            Self::Axes(axes) => {
                let axes: Vec<String> = axes.iter().map(|(letter, value)| format!("{letter} {value}")).collect();
                f.write_str(&axes.join(", "))
            }
        }
    }
}

/// Where in the tables of the project file a value is.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Table {
    /// `[motion]`.
    Motion,
    /// `[motion.sets.1]` to `4`; 0 is `[motion.sets.rapid]`.
    Set(usize),
    /// `[motion.times]`.
    Times,
}

/// A value in force.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct InForce {
    /// The table that it belongs to.
    pub table: Table,
    /// Its key in that table.
    pub key: String,
    /// The value.
    pub value: BasisValue,
    /// `motion.accuracy-um`, `R384`, `default`, `--set`.
    pub from: String,
    /// Nobody gave it.
    pub assumed: bool,
}

impl InForce {
    /// The key with those of its tables, without `motion`: `accuracy-um`, `sets.1.parabolic`.
    pub fn path(&self) -> String {
        path(self.table, &self.key)
    }
}

fn path(table: Table, key: &str) -> String {
    match table {
        Table::Motion => key.to_owned(),
        Table::Set(0) => format!("sets.rapid.{key}"),
        Table::Set(set) => format!("sets.{set}.{key}"),
        Table::Times => format!("times.{key}"),
    }
}

/// What an estimate rests on.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Basis {
    /// Nothing is configured: all is assumed.
    pub assumed: bool,
    /// The values in force, in the order of the reference page. What is off or absent is left out.
    pub values: Vec<InForce>,
}

impl Basis {
    /// The machine of these settings.
    pub fn of(settings: &Settings) -> Self {
        let motion = &settings.machine.motion;
        let mut values = Vec::new();
        let mut add = |table: Table, key: &str, value: BasisValue, (from, of): (GivenBy, &str)| {
            values.push(InForce {
                table,
                key: key.to_owned(),
                value,
                from: from.shown(of),
                assumed: from == GivenBy::Default,
            });
        };
        let own = |key| (Table::Motion, key);
        let (table, key) = own("profile");
        add(table, key, BasisValue::Name(motion.profile.value.name()), (motion.profile.from, key));
        let (table, key) = own("recognition");
        add(table, key, BasisValue::Name(motion.recognition.value.name()), (motion.recognition.from, key));
        let parabolic = motion.profile.value == Profile::Parabolic;
        let rapid_set = parabolic && motion.sets.first().is_some_and(Option::is_some);
        for key in MotionKey::ALL {
            // G00 goes by P and A there, from the rapid set or from set 1.
            if parabolic && key == MotionKey::AccelRapid {
                continue;
            }
            if let Some((value, given)) = number(motion, key) {
                add(Table::Motion, key.name(), BasisValue::Number(value), given);
            }
        }
        let rapid = match &motion.rapid.value {
            Rapid::Path(velocity) => BasisValue::Number(*velocity),
            Rapid::Axes(table) => BasisValue::Axes(table.clone()),
        };
        add(Table::Motion, "rapid-mm-min", rapid, (motion.rapid.from, "rapid-mm-min"));
        for (set, dynamic) in motion.sets.iter().enumerate() {
            if rapid_set && set == 0 {
                for key in [SetKey::Parabolic, SetKey::Linear] {
                    if let Some((value, (from, of))) = of_rapid(motion, key) {
                        add(Table::Set(set), key.name(), value, (from, &of));
                    }
                }
                continue;
            }
            for key in SetKey::ALL {
                let Some(given) = dynamic.as_ref().and_then(|dynamic| dynamic.get(key)) else { continue };
                let Some(value) = of_set(given.value) else { continue };
                let table = Table::Set(set);
                add(table, key.name(), value, (given.from, &path(table, key.name())));
            }
        }
        for (function, given) in &motion.times {
            let name = function.name();
            let of = path(Table::Times, &name);
            add(Table::Times, &name, BasisValue::Number(given.value), (given.from, &of));
        }
        Self { assumed: !motion.configured, values }
    }

    /// What differs from another basis: the key, and both values; none where a value is off.
    pub fn changes(&self, from: &Self) -> Vec<(String, Option<BasisValue>, Option<BasisValue>)> {
        let find = |basis: &Self, value: &InForce| {
            let same = |other: &&InForce| other.table == value.table && other.key == value.key;
            basis.values.iter().find(same).map(|found| found.value.clone())
        };
        let mut changes = Vec::new();
        for value in &self.values {
            let before = find(from, value);
            if before.as_ref() != Some(&value.value) {
                changes.push((value.path(), before, Some(value.value.clone())));
            }
        }
        for value in &from.values {
            if find(self, value).is_none() {
                changes.push((value.path(), Some(value.value.clone()), None));
            }
        }
        changes
    }
}

/// The value of a set; none where it is off.
fn of_set(value: SetValue) -> Option<BasisValue> {
    match value {
        SetValue::Number(number) if number == Decimal::ZERO => None,
        SetValue::Number(number) => Some(BasisValue::Number(number)),
        SetValue::Parameter(number) => Some(BasisValue::Parameter(number)),
    }
}

/// The values for G00 with its own set, and the path of the key that gives them: those of the set, else those of set 1,
/// else that of the keys.
fn of_rapid(motion: &Motion, key: SetKey) -> Option<(BasisValue, (GivenBy, String))> {
    let own = [0, 1].into_iter().find_map(|set| {
        let given = motion.sets.get(set)?.as_ref()?.get(key)?;
        Some((of_set(given.value)?, (given.from, path(Table::Set(set), key.name()))))
    });
    own.or_else(|| {
        let (value, (from, of)) = number(motion, MotionKey::AccelContinuous).filter(|_| key == SetKey::Linear)?;
        Some((BasisValue::Number(value), (from, of.to_owned())))
    })
}

/// A number in force with the key that gives it; none where it is off or absent.
fn number(motion: &Motion, key: MotionKey) -> Option<(Decimal, (GivenBy, &'static str))> {
    let value = motion.number(key);
    let given = motion.given(key);
    // 0 means the other acceleration.
    let other = key == MotionKey::AccelContinuous && given.value.is_none_or(|own| own == Decimal::ZERO);
    let from =
        if other { (motion.given(MotionKey::Accel).from, MotionKey::Accel.name()) } else { (given.from, key.name()) };
    let off = match key {
        MotionKey::Angle => false,
        MotionKey::BreakLength | MotionKey::MergeLength | MotionKey::RaiseLength => value <= Decimal::ZERO,
        MotionKey::Cycle
        | MotionKey::Accel
        | MotionKey::AccelContinuous
        | MotionKey::AccelRapid
        | MotionKey::ShortestBlock
        | MotionKey::Accuracy
        | MotionKey::Red
        | MotionKey::Overload
        | MotionKey::Raise
        | MotionKey::LookAhead
        | MotionKey::Centripetal
        | MotionKey::ConstantCutting
        | MotionKey::Settle
        | MotionKey::BlockGap => value == Decimal::ZERO,
    };
    (!off).then_some((value, from))
}
