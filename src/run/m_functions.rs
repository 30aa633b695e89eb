//! The M functions of a block (§8).

use super::block::InForce;
use super::site::Site;
use super::state::State;
use super::words::BlockWords;
use super::{gears, spindle};
use crate::config::{Machine, Settings};
use crate::diag::Finding;
use crate::dict::{
    FEED_GROUP, GEAR_BY_SPEED, GEAR_GROUP, GGroup, HELD_AT_STOP, M_GROUPS, MOMENTARY_GROUPS, OPTIONAL_STOP,
    ORIENTED_STOP, PROGRAM_ENDS, PROGRAM_STOP, SPINDLE_GROUP, TOOL_CHANGE,
};

/// What M groups 2, 5 and 6 hold while the program stands.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct MStop {
    /// Group 2: the spindle.
    pub spindle: u8,
    /// Group 5: coolant 1 and 2.
    pub coolant_12: u8,
    /// Group 6: coolant 3 and 4.
    pub coolant_34: u8,
}

/// The effects of a block's M functions.
#[derive(Clone, Debug, Default)]
pub(super) struct MFunctionsOfBlock {
    /// What holds after the block, by group; momentary functions in their block only.
    pub(super) in_force: [Option<u8>; M_GROUPS],
    /// In written order.
    pub(super) written: Vec<u8>,
    /// The groups with a change bit, ascending (MFN-6).
    pub(super) changed: Vec<u8>,
    pub(super) break_cont: bool,
    pub(super) break_cont_end: bool,
    /// One of them moves the machine before the block's own motion (MFN-4).
    pub(super) moves_before: bool,
    /// One of them moves the machine at the end of the block.
    pub(super) moves_after: bool,
    /// M00 or M01.
    pub(super) stop: Option<u8>,
    /// M02 or M30.
    pub(super) end: Option<u8>,
    /// The block has no M word and no S, and this says so: for the next such block it need not be said again.
    settled: bool,
}

/// Puts the M functions of the block into force (MFN-6…MFN-10).
pub(super) fn apply(
    site: &mut Site<'_>,
    state: &mut State,
    words: &BlockWords,
    g: &InForce,
    m: &mut MFunctionsOfBlock,
) {
    // Under another G6 function S may be a speed of the spindle again (MFN-9).
    let mode = words.written(GGroup::G6).is_some() || words.unknown_g;
    let plain = words.m.is_empty() && words.s.is_none() && !words.malformed_m && !mode;
    if plain && m.settled {
        return;
    }
    m.settled = plain;
    m.written.clear();
    m.changed.clear();
    (m.break_cont, m.break_cont_end) = (false, false);
    (m.moves_before, m.moves_after) = (false, false);
    (m.stop, m.end) = (None, None);
    let mut changed = [false; M_GROUPS];
    let spindle_before = state.m(SPINDLE_GROUP);
    for &(number, word) in &words.m {
        let Some(function) = site.machine().m_functions.get(number) else { continue };
        let group = usize::from(function.group);
        if let (Some(held), Some(changed)) = (state.m.get_mut(group), changed.get_mut(group)) {
            *held = Some(number);
            *changed = true;
        }
        m.written.push(number);
        if function.change_pos {
            // At its end by its own attributes, else before the block's motion (MFN-4).
            *(if function.acts_at_end() { &mut m.moves_after } else { &mut m.moves_before }) = true;
            state.origins.moved = Some((number, site.word_place(word)));
        }
        m.break_cont |= function.break_cont;
        m.break_cont_end |= function.break_cont_end;
        match number {
            PROGRAM_STOP | OPTIONAL_STOP => m.stop = Some(number),
            TOOL_CHANGE => state.in_spindle = state.tool,
            // Found before execution when it is written out.
            ORIENTED_STOP if word.is_parametric() && !site.settings.machine.oriented_stop => {
                site.found(Finding::OrientedStopUnavailable {}, site.word_place(word));
            }
            number if PROGRAM_ENDS.contains(&number) => m.end = Some(number),
            _ => {}
        }
    }
    forget_functions(state, words);
    let spindle = state.m(SPINDLE_GROUP);
    state.feed_reduced = site.machine().m_functions.reduces_feed(state.m(FEED_GROUP));
    if m.end.is_some() {
        reset(site.machine(), state, &mut changed);
    }
    let gear = gears::in_block(site.machine(), state, g);
    if let Some(changed) = changed.get_mut(GEAR_GROUP) {
        *changed |= state.m(GEAR_GROUP) == Some(GEAR_BY_SPEED) && gear != state.gear;
    }
    state.gear = gear;
    gears::check(site, state, words, g);
    m.in_force = state.m;
    m.changed.extend((0..).zip(changed).filter_map(|(group, changed)| changed.then_some(group)));
    for group in MOMENTARY_GROUPS {
        if let Some(held) = state.m.get_mut(usize::from(group)) {
            *held = None;
        }
    }
    // The spindle goes on until the motion of the block has ended.
    hold_spindle(state, spindle);
    if m.moves_before {
        state.lose_positions();
    }
    spindle::apply(site.machine(), state, words, spindle_before);
}

/// After two functions of one group nobody knows which holds, after a malformed one none of all groups (§13).
fn forget_functions(state: &mut State, words: &BlockWords) {
    if words.malformed_m {
        state.m = [None; M_GROUPS];
    }
    for &group in &words.m_clashes {
        if let Some(held) = state.m.get_mut(usize::from(group)) {
            *held = None;
        }
    }
}

/// M02 and M30 set the groups to what holds at power-up; those that change are marked, groups 2, 5 and 6 always, since
/// M05, M09 and M53 are sent (MFN-6, MFN-7).
fn reset(machine: &Machine, state: &mut State, changed: &mut [bool; M_GROUPS]) {
    let defaults = machine.m_power_up;
    for (group, ((held, default), changed)) in state.m.iter_mut().zip(defaults).zip(changed).enumerate() {
        if let Some(default) = default {
            *changed |= *held != Some(default) || HELD_AT_STOP.iter().any(|(sent, _)| *sent == group);
            *held = Some(default);
        }
    }
}

fn hold_spindle(state: &mut State, function: Option<u8>) {
    if let Some(held) = state.m.get_mut(SPINDLE_GROUP) {
        *held = function;
    }
}

/// What holds while the program stands (MFN-8).
pub(super) fn at_stop(machine: &Machine) -> MStop {
    let defaults = machine.m_functions.defaults();
    let held = |(group, function): (usize, u8)| defaults.get(group).copied().flatten().unwrap_or(function);
    let [spindle, coolant_12, coolant_34] = HELD_AT_STOP.map(held);
    MStop { spindle, coolant_12, coolant_34 }
}

/// What follows from the M functions at the end of the block: one may move the machine (MFN-4), and START after a stop
/// orients the spindle again (MFN-10).
pub(super) fn finish(site: &Site<'_>, state: &mut State, m: &MFunctionsOfBlock) {
    if m.moves_after {
        state.lose_positions();
    }
    if m.end.is_some() {
        hold_spindle(state, m.in_force.get(SPINDLE_GROUP).copied().flatten());
    }
    state.orients = halts(site.settings, m) && spindle::axis(site.machine(), state).is_some();
}

/// Whether the program waits at the end of the block (MFN-8): M00, and M01 with optional stop.
pub(super) fn halts(settings: &Settings, m: &MFunctionsOfBlock) -> bool {
    m.stop == Some(PROGRAM_STOP) || (m.stop == Some(OPTIONAL_STOP) && settings.optional_stop)
}
