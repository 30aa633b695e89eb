//! The spindle as an axis (MFN-10, MOT-9): when its position is known, when it may be programmed.

use super::parameters::with_origin;
use super::site::Site;
use super::state::{Position, State};
use super::travel::Travel;
use super::words::BlockWords;
use crate::config::Machine;
use crate::diag::{Diagnostic, Finding, SpindleFault};
use crate::dict::{Decimal, Micro, ORIENTED_STOP, SPINDLE_GROUP, SPINDLE_TURNS};

/// The axis that is the spindle at the moment, by place in machine order.
#[inline]
pub(super) fn axis(machine: &Machine, state: &State) -> Option<usize> {
    (state.m(SPINDLE_GROUP) == Some(ORIENTED_STOP)).then(|| machine.spindle()).flatten()
}

/// M19 puts the spindle at its oriented position; M03, M04 and M05 leave it anywhere, when M19 was in force or
/// configuration says which axis it is. `before`: the function of the group before the block. Comes before the block's
/// own motion.
pub(super) fn apply(machine: &Machine, state: &mut State, words: &BlockWords, before: Option<u8>) {
    let group = |m: u8| usize::from(machine.m_functions.group(m));
    let Some(&(written, _)) = words.m.iter().find(|(m, _)| group(*m) == SPINDLE_GROUP) else { return };
    if written == ORIENTED_STOP {
        orient(machine, state);
    } else if (before == Some(ORIENTED_STOP) || machine.spindle_is_configured())
        && let Some(axis) = machine.spindle()
    {
        state.set_position(axis, Position::Unknown);
    }
}

/// Brings the spindle to its oriented position: after M19, and after START when M19 was in force at a stop (MFN-8).
pub(super) fn orient(machine: &Machine, state: &mut State) {
    if machine.oriented_stop
        && let Some(axis) = machine.spindle()
    {
        state.set_position(axis, Position::Known(Micro::from(machine.oriented_position)));
    }
}

/// Whether words of the spindle's axis are errors: it turns, and configuration says which axis it is.
pub(super) fn turns(machine: &Machine, state: &State) -> bool {
    machine.spindle_is_configured() && state.m(SPINDLE_GROUP).is_some_and(|m| SPINDLE_TURNS.contains(&m))
}

/// E0614: words of the spindle's axis while it turns, and turns too far for one block.
pub(super) fn check(site: &mut Site<'_>, state: &State, travels: &[Travel]) {
    let machine = site.machine();
    let turning = if turns(machine, state) { machine.spindle() } else { None };
    let oriented = axis(machine, state);
    if turning.is_none() && oriented.is_none() {
        return;
    }
    for travel in travels {
        let Some(word) = travel.word else { continue };
        let letter = travel.definition.letter.letter();
        if turning == Some(travel.axis) {
            let m = state.m(SPINDLE_GROUP).unwrap_or_default();
            site.found(
                Finding::SpindleTurn { axis: letter, fault: SpindleFault::Turning { m } },
                site.word_place(word),
            );
        }
        let most = Micro::from(Decimal::DIMENSION_MAX);
        if oriented == Some(travel.axis)
            && let (Position::Known(before), Position::Known(after)) = (travel.before, travel.after)
            && after.minus(before).abs() > most
        {
            let fault = SpindleFault::TooFar { degrees: after.minus(before).abs().to_string() };
            let diagnostic = Diagnostic::new(Finding::SpindleTurn { axis: letter, fault }, site.word_place(word));
            site.report(with_origin(state, diagnostic, word));
        }
    }
}
