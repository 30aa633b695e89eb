//! The gear of the spindle (MFN-9): which one M40 chooses, whether S fits.

use super::block::InForce;
use super::parameters::with_origin;
use super::site::Site;
use super::state::State;
use super::words::BlockWords;
use crate::config::Machine;
use crate::diag::{Diagnostic, Finding, LabelText};
use crate::dict::{Decimal, GCode, GEAR_BY_SPEED, GEAR_GROUP, GEARS, GGroup};
use crate::syntax::Word;

/// The gear in a block with these functions. Under M40 one of the table stays as it was while S is no speed of the
/// spindle.
pub(super) fn in_block(machine: &Machine, state: &State, g: &InForce) -> Option<u8> {
    let by_speed = state.m(GEAR_GROUP) == Some(GEAR_BY_SPEED);
    if by_speed && !machine.gears.is_empty() && is_cutting_speed(machine, g) {
        state.gear
    } else {
        gear(machine, state)
    }
}

/// Whether S is no speed of the spindle: the cutting speed is constant (G96, and G97 where it counts so).
fn is_cutting_speed(machine: &Machine, g: &InForce) -> bool {
    g.of(GGroup::G6).and_then(|mode| machine.feed_mode(mode)).is_some_and(|mode| mode.constant_cut)
}

/// The gear in force, 1–4: by M41–M44, or the lowest that S fits under M40.
fn gear(machine: &Machine, state: &State) -> Option<u8> {
    match state.m(GEAR_GROUP) {
        Some(m) if GEARS.contains(&m) => Some(m - GEAR_BY_SPEED),
        Some(GEAR_BY_SPEED) => {
            let speed = speed(state)?;
            let gears = machine.gears.iter();
            gears.filter(|gear| gear.min <= speed && speed <= gear.max).map(|gear| gear.m - GEAR_BY_SPEED).min()
        }
        Some(_) | None => None,
    }
}

fn speed(state: &State) -> Option<u32> {
    state.speed.value().and_then(Decimal::as_whole).and_then(|speed| u32::try_from(speed).ok())
}

/// S outside the range of the gear programmed (E0607), or in no gear that M40 could choose (W0617): in blocks that
/// write S or M40–M44. Not while the cutting speed is constant: what S means then is in no source.
pub(super) fn check(site: &mut Site<'_>, state: &State, words: &BlockWords, g: &InForce) {
    let machine = site.machine();
    if machine.gears.is_empty() {
        return;
    }
    let m_word = words.m.iter().find(|(m, _)| usize::from(machine.m_functions.group(*m)) == GEAR_GROUP);
    let m_word: Option<Word> = m_word.map(|(_, word)| *word);
    let s_word = words.s.map(|valued| valued.word);
    let (Some(word), Some(m), Some(s)) = (s_word.or(m_word), state.m(GEAR_GROUP), speed(state)) else { return };
    if is_cutting_speed(machine, g) || g.unknown.has(GGroup::G6) {
        return;
    }
    let finding = if m == GEAR_BY_SPEED {
        // S0 turns nothing, whatever the gear.
        if s == 0 || gear(machine, state).is_some() {
            return;
        }
        let gears: Vec<String> =
            machine.gears.iter().map(|gear| format!("M{} {}–{}", gear.m, gear.min, gear.max)).collect();
        Finding::NoGearForSpeed { s, gears: gears.join(", ") }
    } else {
        match machine.gears.iter().find(|gear| gear.m == m) {
            Some(gear) if s < gear.min || gear.max < s => {
                let g97 = g.of(GGroup::G6) == Some(GCode::G97);
                Finding::SpeedOutsideGear { s, m, min: gear.min, max: gear.max, g97 }
            }
            Some(_) | None => return,
        }
    };
    let mut diagnostic = Diagnostic::new(finding, site.word_place(word));
    if let (Some(m_word), Some(_)) = (m_word, s_word) {
        diagnostic = diagnostic.with_label(site.word_place(m_word), LabelText::GearHere { m });
    }
    site.report(with_origin(state, diagnostic, word));
}
