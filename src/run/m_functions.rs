//! The M functions of a block (§8).

use super::parameters::with_origin;
use super::site::Site;
use super::state::{Position, State};
use super::words::BlockWords;
use crate::config::{Gear, Machine};
use crate::diag::{Diagnostic, Finding, LabelText};
use crate::dict::{Decimal, M_GROUPS, PROGRAM_ENDS};

/// Groups whose value is shown only in the block that programs them (MFN-6).
const MOMENTARY: [usize; 3] = [1, 7, 9];

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

/// What the M functions of a block do.
#[derive(Clone, Debug, Default)]
pub(super) struct MFunctionsOfBlock {
    /// What holds after the block, by group; momentary functions in their block only.
    pub(super) in_force: [Option<u8>; M_GROUPS],
    /// In written order.
    pub(super) written: Vec<u8>,
    /// The groups with a change mark, ascending (MFN-6).
    pub(super) changed: Vec<u8>,
    pub(super) break_cont: bool,
    pub(super) break_cont_end: bool,
    /// One of them moves the machine.
    pub(super) moves: bool,
    /// M00 or M01.
    pub(super) stop: Option<u8>,
    /// M02 or M30.
    pub(super) end: Option<u8>,
    /// The block has no M word, and this says so: for the next such block it need not be said again.
    settled: bool,
}

/// Puts the M functions of the block into force (MFN-6…MFN-10).
pub(super) fn apply(site: &mut Site<'_>, state: &mut State, words: &BlockWords, m: &mut MFunctionsOfBlock) {
    if words.m.is_empty() && m.settled {
        check_gear(site, state, words);
        return;
    }
    m.settled = words.m.is_empty();
    m.written.clear();
    m.changed.clear();
    (m.break_cont, m.break_cont_end, m.moves) = (false, false, false);
    (m.stop, m.end) = (None, None);
    let mut changed = [false; M_GROUPS];
    for &(number, word) in &words.m {
        let Some(function) = site.machine().m_functions.get(number) else { continue };
        let group = usize::from(function.group);
        if let (Some(held), Some(changed)) = (state.m.get_mut(group), changed.get_mut(group)) {
            *held = Some(number);
            *changed = true;
        }
        m.written.push(number);
        m.moves |= function.change_pos;
        m.break_cont |= function.break_cont;
        m.break_cont_end |= function.break_cont_end;
        match number {
            0 | 1 => m.stop = Some(number),
            6 => state.in_spindle = state.tool,
            19 if !site.settings.machine.oriented_stop => {
                site.found(Finding::OrientedStopUnavailable {}, site.word_place(word));
            }
            number if PROGRAM_ENDS.contains(&number) => m.end = Some(number),
            _ => {}
        }
    }
    if m.end.is_some() {
        reset(site.machine(), state, &mut changed);
    }
    check_gear(site, state, words);
    m.in_force = state.m;
    m.changed.extend((0..).zip(changed).filter_map(|(group, changed)| changed.then_some(group)));
    for group in MOMENTARY {
        if let Some(held) = state.m.get_mut(group) {
            *held = None;
        }
    }
}

/// M02 and M30 set the groups to their `+` values, and mark those that change (MFN-6, MFN-7).
fn reset(machine: &Machine, state: &mut State, changed: &mut [bool; M_GROUPS]) {
    let defaults = *machine.m_functions.defaults();
    for ((held, default), changed) in state.m.iter_mut().zip(defaults).zip(changed) {
        if let Some(default) = default {
            *changed |= *held != Some(default);
            *held = Some(default);
        }
    }
}

/// What holds while the program stands (MFN-8).
pub(super) fn at_stop(machine: &Machine) -> MStop {
    let default = |group: usize| machine.m_functions.defaults().get(group).copied().flatten();
    MStop {
        spindle: default(2).unwrap_or(5),
        coolant_12: default(5).unwrap_or(9),
        coolant_34: default(6).unwrap_or(53),
    }
}

/// The range in force, or the one that M40 chooses by S (MFN-9).
pub(super) fn gear(machine: &Machine, state: &State) -> Option<u8> {
    match state.m(3) {
        Some(m @ 41..=44) => Some(m - 40),
        Some(40) => {
            let speed = state.speed.value()?.as_whole()?;
            let fits = |gear: &&Gear| i64::from(gear.min) <= speed && speed <= i64::from(gear.max);
            machine.gears.iter().filter(fits).map(|gear| gear.m - 40).min()
        }
        Some(_) | None => None,
    }
}

/// S outside the range of the gear programmed (MFN-9): in blocks that write S or M41–M44.
fn check_gear(site: &mut Site<'_>, state: &State, words: &BlockWords) {
    let Some(m @ 41..=44) = state.m(3) else { return };
    let m_word = words.m.iter().find(|(number, _)| (41..=44).contains(number)).map(|(_, word)| *word);
    let s_word = words.s.map(|valued| valued.word);
    let Some(word) = s_word.or(m_word) else { return };
    let gear = site.machine().gears.iter().copied().find(|gear| gear.m == m);
    let speed = state.speed.value().and_then(Decimal::as_whole).and_then(|speed| u32::try_from(speed).ok());
    let (Some(gear), Some(s)) = (gear, speed) else { return };
    if gear.min <= s && s <= gear.max {
        return;
    }
    let finding = Finding::SpeedOutsideGear { s, m, min: gear.min, max: gear.max };
    let mut diagnostic = Diagnostic::new(finding, site.word_place(word));
    if let (Some(m_word), Some(_)) = (m_word, s_word) {
        diagnostic = diagnostic.with_label(site.word_place(m_word), LabelText::GearHere { m });
    }
    site.report(with_origin(state, diagnostic, word));
}

/// After a block that moves the machine by an M function all positions are unknown (MFN-4).
pub(super) fn forget_positions(state: &mut State, m: &MFunctionsOfBlock) {
    if m.moves {
        state.positions = [Position::Unknown; 9];
    }
}
