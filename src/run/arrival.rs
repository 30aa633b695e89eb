//! Checks of every axis that a motion brings somewhere, by whatever means it moves.

use super::site::Site;
use super::state::State;
use super::travel::{Reading, Travel};
use super::warnings::{check_travel, has_limits, warn_incremental};
use crate::config::Machine;

/// A rule of arriving axes. Execution passes over motions that nobody looks at where every rule is silent: a new rule
/// says when it is.
#[derive(Clone, Copy, Debug)]
enum Rule {
    /// An axis goes some way from where nobody knows (MOT-2).
    FromUnknown,
    /// The target is outside of the configured travel (W0621).
    Limits,
}

impl Rule {
    const ALL: [Self; 2] = [Self::FromUnknown, Self::Limits];

    /// Whether it has nothing to say of any word that is read so.
    fn is_silent(self, machine: &Machine, reading: Reading) -> bool {
        match self {
            Self::FromUnknown => !reading.is_incremental(),
            Self::Limits => !machine.axes.iter().any(|axis| has_limits(&axis)),
        }
    }

    #[inline]
    fn check(self, site: &mut Site<'_>, state: &mut State, travel: &Travel) {
        match self {
            Self::FromUnknown => warn_incremental(site, state, travel),
            Self::Limits => check_travel(site, state, travel),
        }
    }
}

/// Puts the positions after the motion into force, and holds each against the rules.
#[inline]
pub(super) fn arrive(site: &mut Site<'_>, state: &mut State, travels: &[Travel]) {
    for travel in travels {
        for rule in Rule::ALL {
            rule.check(site, state, travel);
        }
        state.set_position(travel.axis, travel.after);
    }
}

/// Takes over the positions after an arc with an unknown start: that has another finding.
pub(super) fn arrive_from_unknown(site: &mut Site<'_>, state: &mut State, travels: &[Travel]) {
    for travel in travels {
        for rule in Rule::ALL.into_iter().filter(|rule| !matches!(rule, Rule::FromUnknown)) {
            rule.check(site, state, travel);
        }
        state.set_position(travel.axis, travel.after);
    }
}

/// Whether no rule has anything to say of any word that is read so.
pub(super) fn is_silent(machine: &Machine, reading: Reading) -> bool {
    Rule::ALL.into_iter().all(|rule| rule.is_silent(machine, reading))
}
