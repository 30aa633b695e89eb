//! Feed, speed, tool and auxiliary words of a block (§9).

use super::parameters::report_unusable;
use super::site::Site;
use super::state::{Held, State};
use super::words::{BlockWords, Valued};
use crate::diag::{Finding, ParameterNeed};
use crate::dict::{Address, DYNAMIC_SETS, GCode, GGroup, Lang, Micro};

/// F, S, T, H, P (D and `&` belong to the origin).
pub(super) fn hold(site: &Site<'_>, state: &mut State, words: &BlockWords) {
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
    if let Some(feed) = words.f {
        let mode = words.written(GGroup::G6).map(|(code, _)| code).or_else(|| state.modal(GGroup::G6));
        let mode = mode.filter(|_| !words.unknown_g).and_then(|mode| site.machine().feed_mode(mode));
        state.feed_per = mode.map(|mode| mode.per);
        state.said.feed_unit = false;
        state.origins.feed = Some(site.word_place(feed.word));
    }
}

/// The dwell, in units of 10 ms (GRP-5).
pub(super) fn dwell(words: &BlockWords) -> Option<Micro> {
    words.has(GCode::G04)?;
    let units = words.q?.value?.as_whole()?;
    Some(Micro::from_millionths(units * 10_000))
}

/// I as the dynamic set of G23 (GRP-7): whether the word was used so.
pub(super) fn choose_dynamic_set(site: &mut Site<'_>, state: &mut State, words: &BlockWords) -> bool {
    let (Some(i), Some(_)) = (words.i, words.has(GCode::G23)) else { return false };
    state.dynamic_set = None;
    let Some(value) = i.value else { return true };
    match value.as_whole() {
        Some(set) if DYNAMIC_SETS.contains(value) => state.dynamic_set = u8::try_from(set).ok(),
        _ if i.word.is_parametric() => {
            let range = || ParameterNeed::Range(DYNAMIC_SETS.text(Lang::En));
            let needs = if value.is_whole() { range() } else { ParameterNeed::Whole };
            report_unusable(site, state, i.word, value, needs);
        }
        _ => {
            let finding = Finding::ValueOutOfRange {
                address: Address::I,
                range: DYNAMIC_SETS.text(Lang::En),
                mode: Some(GCode::G23),
                call: None,
            };
            site.found(finding, site.value_place(i.word));
        }
    }
    true
}
