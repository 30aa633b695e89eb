//! The G functions of a block, and what a change of origin follows from.

use super::block::InForce;
use super::site::Site;
use super::state::{AxisSet, Held, Noted, State};
use super::words::BlockWords;
use crate::diag::Finding;
use crate::dict::{Decimal, GCode, GGroup, Lasting};
use crate::text::Location;

/// Puts the G functions of the block into force, and gives what holds in it: x functions hold in it only.
pub(super) fn apply(site: &mut Site<'_>, state: &mut State, words: &BlockWords) -> InForce {
    for &(code, word) in &words.g {
        match code.lasting() {
            Lasting::Modal | Lasting::Default => {
                state.set_modal(code);
                if code.group() == GGroup::G0 {
                    state.origins.motion = Noted(Some((site.file.shown_number(site.block), site.word_place(word))));
                }
            }
            Lasting::Block => {}
        }
        // GRP-8: what G05–G08 do is not modelled; said once of each.
        if !code.is_modelled() {
            report_unmodelled(site, state, code, site.word_place(word));
        }
    }
    let mut in_force = InForce(state.g);
    for &(code, _) in &words.g {
        if let Some(slot) = in_force.0.get_mut(code.group().index()) {
            *slot = Some(code);
        }
    }
    in_force
}

/// W0612, once for each function.
pub(super) fn report_unmodelled(site: &mut Site<'_>, state: &mut State, function: GCode, at: Location) {
    if !state.said.unmodelled.contains(&function) {
        state.said.unmodelled.push(function);
        site.found(Finding::FunctionNotModelled { function }, at);
    }
}

/// Notes whether the origin, a conversion or a correction changed since the block before (MOT-8).
pub(super) fn track_origin(state: &mut State, words: &BlockWords, g: &InForce) {
    let origin = (g.of(GGroup::G5), g.of(GGroup::G11));
    let mut changed = origin != state.last_origin;
    state.last_origin = origin;
    let active = |held: Held| !matches!(held, Held::None) && held.value() != Some(Decimal::ZERO);
    let corrected = active(state.correction);
    if let Some(word) = words.correction {
        let new = Held::of(word.value);
        changed |= new != state.correction && (active(new) || corrected);
        state.correction = new;
    }
    if let Some(word) = words.d {
        let new = Held::of(word.value);
        changed |= corrected && new != state.d;
        state.d = new;
    }
    if changed {
        state.unsettled = AxisSet::ALL;
    }
}
