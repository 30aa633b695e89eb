//! What `motion --set` may name: the keys of `[motion]` and of the tables in it, and the constants that motion depends
//! on.

use super::motion_constants::holds;
use super::motion_keys::{MOTION, RAPID_SET, SET};
use super::names::Names;
use super::near::nearest;
use crate::dict::{AxisLetter, Dialect};

/// Why a value changes nothing.
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum TriedFault {
    /// There is no such key.
    Unknown {
        /// What was probably meant.
        near: Option<String>,
    },
    /// Motion does not depend on the constant.
    Constant,
    /// The control takes motion from no constant.
    Dialect,
}

/// What keeps a value of that key from changing anything; `None`: it is one of motion.
pub fn tried_fault(key: &str, dialect: Dialect) -> Option<TriedFault> {
    if let Some(number) = Names::Constants.number(key) {
        return match holds(number) {
            None => Some(TriedFault::Constant),
            Some(_) if dialect.has_channel_config() => Some(TriedFault::Dialect),
            Some(_) => None,
        };
    }
    let is_timed = |key: &str| key.strip_prefix("times.").is_some_and(|name| Names::Timed.number(name).is_some());
    let is_axis = |key: &str| {
        let letter = key.strip_prefix("rapid-mm-min.")?;
        AxisLetter::ALL.into_iter().find(|axis| axis.name() == letter)
    };
    let keys = keys();
    if is_timed(key) || is_axis(key).is_some() || keys.iter().any(|known| known == key) {
        return None;
    }
    let inner = key.strip_prefix("motion.").unwrap_or(key);
    let timed = || {
        let near = Names::Timed.near(inner.strip_prefix("times.").unwrap_or(inner))?;
        Some(format!("times.{near}"))
    };
    let near = Names::Constants.near(inner).filter(|near| Names::Constants.number(near).and_then(holds).is_some());
    let near = near.or_else(timed).or_else(|| nearest(inner, keys.iter().map(String::as_str)));
    Some(TriedFault::Unknown { near })
}

/// The keys of `[motion]`, and those of its sets with their tables.
fn keys() -> Vec<String> {
    let sets = ["1", "2", "3", "4"].into_iter().flat_map(|set| SET.iter().map(move |row| (set, row)));
    let sets = sets.chain(RAPID_SET.iter().map(|row| ("rapid", row)));
    let own = MOTION.iter().map(|row| row.name.to_owned());
    own.chain(sets.map(|(set, row)| format!("sets.{set}.{}", row.name))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_changes_something() {
        for key in [
            "accuracy-um",
            "profile",
            "rapid-mm-min",
            "rapid-mm-min.X",
            "sets.1.parabolic",
            "sets.rapid.linear-mm-s2",
            "times.M6",
            "R384",
        ] {
            assert_eq!(tried_fault(key, Dialect::Cnc8x9), None, "{key}");
        }
        assert_eq!(tried_fault("R384", Dialect::Cnc872), Some(TriedFault::Dialect));
        assert_eq!(tried_fault("R56", Dialect::Cnc8x9), Some(TriedFault::Constant));
    }

    #[test]
    fn what_was_meant() {
        for (key, near) in [
            ("foo", None),
            ("accuracy", Some("accuracy-um")),
            ("motion.accuracy-um", Some("accuracy-um")),
            ("sets.1.paraboli", Some("sets.1.parabolic")),
            ("r384", Some("R384")),
            ("M06", Some("times.M06")),
        ] {
            let near = near.map(str::to_owned);
            assert_eq!(tried_fault(key, Dialect::Cnc8x9), Some(TriedFault::Unknown { near }), "{key}");
        }
    }
}
