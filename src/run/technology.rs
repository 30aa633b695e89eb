//! Feed, speed, tool and auxiliary words of a block (§9).

use super::block::InForce;
use super::parameters::report_unusable;
use super::site::Site;
use super::state::{Held, State};
use super::words::{BlockWords, Valued};
use crate::diag::{Finding, ParameterNeed};
use crate::dict::{Address, GCode, GGroup, Micro};
use crate::text::Location;

/// F, S, T, H, P (D and `&` belong to the origin).
pub(super) fn hold(state: &mut State, words: &BlockWords) {
    let hold = |word: Option<Valued>, held: &mut Held| {
        if let Some(word) = word {
            *held = Held::of(word.value);
        }
    };
    hold(words.f, &mut state.feed);
    hold(words.s, &mut state.speed);
    hold(words.t, &mut state.tool);
    hold(words.h, &mut state.h);
    hold(words.p, &mut state.p);
}

/// The dwell, in units of 10 ms (GRP-5).
pub(super) fn dwell(words: &BlockWords) -> Option<Micro> {
    words.has(GCode::G04)?;
    let units = words.q?.value?.as_whole()?;
    Some(Micro::from_millionths(units * 10_000))
}

/// What F and S a working motion needs (TEC-2, TEC-3); each said once a program.
pub(super) fn check_working_motion(site: &mut Site<'_>, state: &mut State, g: &InForce, at: Location) {
    if state.feed == Held::None && !state.said.feed {
        state.said.feed = true;
        site.found(Finding::MissingFeed {}, at);
    }
    let Some(function) = speed_reader(g) else { return };
    if state.speed == Held::None && !state.said.speed {
        state.said.speed = true;
        site.found(Finding::MissingSpindleSpeed { function }, at);
    }
}

/// Whether [`check_working_motion`] may have something to say.
pub(super) fn may_lack_technology(state: &State, g: &InForce) -> bool {
    (state.feed == Held::None && !state.said.feed)
        || (state.speed == Held::None && !state.said.speed && speed_reader(g).is_some())
}

/// The G6 function in force, when a working motion under it needs S (TEC-3).
fn speed_reader(g: &InForce) -> Option<GCode> {
    g.of(GGroup::G6).filter(|mode| matches!(mode, GCode::G95 | GCode::G96 | GCode::G97))
}

/// I as the dynamic set of G23 (GRP-7): whether the word was used so.
pub(super) fn choose_dynamic_set(site: &mut Site<'_>, state: &mut State, words: &BlockWords) -> bool {
    let (Some(i), Some(_)) = (words.i, words.has(GCode::G23)) else { return false };
    let Some(value) = i.value else { return true };
    match value.as_whole() {
        Some(set @ 1..=4) => state.dynamic_set = u8::try_from(set).ok(),
        _ if i.word.is_parametric() => {
            let range = || ParameterNeed::Range("1–4".to_owned());
            let needs = if value.is_whole() { range() } else { ParameterNeed::Whole };
            report_unusable(site, state, i.word, value, needs);
        }
        _ => {
            let finding = Finding::ValueOutOfRange { address: Address::I, range: "1–4 (G23)".to_owned() };
            site.found(finding, site.value_place(i.word));
        }
    }
    true
}
