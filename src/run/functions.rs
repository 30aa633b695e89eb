//! The G functions of a block, and what a change of origin follows from.

use super::block::InForce;
use super::parameters::with_origin;
use super::site::Site;
use super::state::{AxisSet, Held, State};
use super::unknown::Groups;
use super::words::BlockWords;
use crate::diag::{Diagnostic, Finding, Unmodelled};
use crate::dict::{Decimal, GCode, GGroup, Lasting};
use crate::resolve::missing_axis;
use crate::syntax::Word;
use crate::text::Location;

/// Puts the G functions of the block into force, in `state` what lasts and in `in_force` what holds in the block: x
/// functions hold in it only.
pub(super) fn apply(site: &mut Site<'_>, state: &mut State, words: &BlockWords, in_force: &mut InForce) {
    for &(code, word) in &words.g {
        match code.lasting() {
            Lasting::Modal | Lasting::Default => {
                if code.group() == GGroup::G3 {
                    change_correction(site, state, code, word);
                }
                state.set_modal(code);
                state.said.arc_mode &= code.group() != GGroup::G9;
                if code.group() == GGroup::G1 {
                    state.said.other_axes = None;
                }
                if code.group() == GGroup::G0 {
                    state.origins.note_motion(site.file, site.block, word);
                }
            }
            Lasting::Block => {}
        }
        // GRP-2: found before execution when it is written out.
        if word.is_parametric()
            && let Some(finding) = missing_axis(&site.machine().axes, code)
        {
            site.report(with_origin(state, Diagnostic::new(finding, site.word_place(word)), word));
        }
        // GRP-8: what G05–G08 do is not modelled; said once of each. Beside an L without use one is the rest of a call
        // or jump, which has its finding (W0402).
        if !code.is_modelled() && !words.roles().has_unused_l() {
            report_unmodelled(site, state, code, site.word_place(word));
        }
    }
    state.unknown = state.unknown.and(words.lasting_clashes);
    if words.malformed_g {
        state.unknown = state.unknown.and(Groups::lasting());
    }
    *in_force = InForce { functions: state.g, unknown: state.unknown.and(words.clashes) };
    for &(code, _) in &words.g {
        if let Some(slot) = in_force.functions.get_mut(code.group().index()) {
            *slot = Some(code);
        }
    }
    if !in_force.unknown.is_empty() {
        for (group, slot) in GGroup::ALL.into_iter().zip(&mut in_force.functions) {
            *slot = slot.filter(|_| !in_force.unknown.has(group));
        }
    }
}

/// Notes a change of the radius correction; from one side to the other it takes a G40 between (W0624).
fn change_correction(site: &mut Site<'_>, state: &mut State, code: GCode, word: Word) {
    let Some(before) = state.modal(GGroup::G3).filter(|before| *before != code) else { return };
    state.corrects = Some(code);
    if before != GCode::G40 && code != GCode::G40 {
        let diagnostic =
            Diagnostic::new(Finding::CorrectionOnArc { function: code, sides: true }, site.word_place(word));
        site.report(with_origin(state, diagnostic, word));
    }
}

/// W0612, once for each function.
pub(super) fn report_unmodelled(site: &mut Site<'_>, state: &mut State, function: GCode, at: Location) {
    if !state.said.unmodelled.contains(&function) {
        state.said.unmodelled.push(function);
        site.found(Finding::FunctionNotModelled { what: Unmodelled::Function(function) }, at);
    }
}

/// Notes whether the origin, a conversion or a correction changed since the block before (MOT-8).
pub(super) fn track_origin(state: &mut State, words: &BlockWords, g: &InForce) {
    let origin = (g.of(GGroup::G5), g.of(GGroup::G11));
    // Whether what is unknown changed is unknown.
    let differs = |new: Option<GCode>, old: Option<GCode>| new.is_some() && old.is_some() && new != old;
    let mut changed = differs(origin.0, state.last_origin.0) || differs(origin.1, state.last_origin.1);
    state.last_origin = origin;
    let active = |held: Held| held.value().is_some_and(|value| value != Decimal::ZERO);
    let corrected = active(state.correction);
    if let Some(word) = words.correction {
        let new = Held::of(word.value);
        let both_known = new.value().is_some() && state.correction != Held::Undetermined;
        changed |= both_known && new != state.correction && (active(new) || corrected);
        state.correction = new;
    }
    if let Some(word) = words.d {
        let new = Held::of(word.value);
        let both_known = new.value().is_some() && state.d != Held::Undetermined;
        changed |= corrected && both_known && new != state.d;
        state.d = new;
    }
    if changed {
        state.unsettled = AxisSet::ALL;
    }
}
