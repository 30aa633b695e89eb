//! Reads the words of a block, all with the values from before it (PAR-4).

use super::parameters::{evaluate_form, evaluate_g, evaluate_m, with_origin};
use super::site::Site;
use super::state::State;
use super::words::{BlockWords, Valued};
use crate::dict::{Address, Decimal, GCode, GGroup, PROGRAM_ENDS};
use crate::resolve::{conflicting_g, conflicting_m};
use crate::syntax::Word;

/// Reads the words of the block into `words`.
pub(super) fn read(site: &mut Site<'_>, state: &mut State, words: &mut BlockWords) {
    words.clear();
    let written = site.file.words(site.block);
    let mut late = false;
    for &word in written {
        let slot = match word.address {
            Address::G => {
                read_g(site, state, words, word);
                continue;
            }
            Address::M => {
                read_m(site, state, words, word);
                continue;
            }
            Address::R => {
                words.r.push(word);
                continue;
            }
            // What F and Q mean follows from G words that may come later.
            Address::F | Address::Q => {
                late = true;
                continue;
            }
            Address::I => &mut words.i,
            Address::J => &mut words.j,
            Address::K => &mut words.k,
            Address::S => &mut words.s,
            Address::T => &mut words.t,
            Address::H => &mut words.h,
            Address::P => &mut words.p,
            Address::D => &mut words.d,
            Address::Correction => &mut words.correction,
            Address::L => &mut words.l,
            Address::X
            | Address::Y
            | Address::Z
            | Address::A
            | Address::B
            | Address::C
            | Address::U
            | Address::V
            | Address::W => {
                let axis = site.machine().axes.index_of(word.address);
                let Some(slot) = axis.and_then(|axis| words.axes.get_mut(axis)) else {
                    words.other_axis = true;
                    continue;
                };
                words.axis_count += usize::from(slot.is_none());
                slot
            }
            Address::N | Address::Skip | Address::Program => continue,
        };
        put(slot, word, evaluate_form(site, state, word, false, None));
    }
    if late {
        for &word in written.iter().filter(|word| matches!(word.address, Address::F | Address::Q)) {
            read_late(site, state, words, word);
        }
    }
}

fn read_late(site: &mut Site<'_>, state: &mut State, words: &mut BlockWords, word: Word) {
    if word.address == Address::F {
        // TEC-1: the G6 function in force in the block that writes F decides.
        let written = words.written(GGroup::G6).map(|(code, _)| code);
        let mode =
            written.or_else(|| state.modal(GGroup::G6)).filter(|_| !words.unknown_g && !words.clashes.has(GGroup::G6));
        put(&mut words.f, word, evaluate_form(site, state, word, false, mode));
        return;
    }
    let dwell = words.has(GCode::G04).is_some() || words.unknown_g;
    put(&mut words.q, word, evaluate_form(site, state, word, dwell, None));
}

/// Takes a word. Of one that is written twice (E0306) nobody knows which was meant.
#[inline]
fn put(slot: &mut Option<Valued>, word: Word, value: Option<Decimal>) {
    let value = value.filter(|_| slot.is_none());
    *slot = Some(Valued { word, value });
}

fn read_g(site: &mut Site<'_>, state: &mut State, words: &mut BlockWords, word: Word) {
    words.parametric_g |= word.is_parametric();
    if word.is_void() {
        // A number in no group changes none (§13).
        let number = word.refused_number().is_some() && !word.has_point() && !word.has_sign();
        words.unknown_g = true;
        words.malformed_g |= !number;
        return;
    }
    let Some(code) = evaluate_g(site, state, words, word) else { return };
    if let Some((first, first_word)) = words.written(code.group()) {
        // Found before execution when both are written out.
        if word.is_parametric() || first_word.is_parametric() {
            let diagnostic = conflicting_g(site.file, (first, first_word), (code, word), false);
            let diagnostic = with_origin(state, diagnostic, word);
            site.report(with_origin(state, diagnostic, first_word));
        }
        words.clash(first, code);
        return;
    }
    if !words.clashes.has(code.group()) {
        words.push_g(code, word);
    }
}

fn read_m(site: &mut Site<'_>, state: &mut State, words: &mut BlockWords, word: Word) {
    if word.is_void() {
        // The end of the program is one in whatever form it is written: the structure of the file goes by it.
        match word.refused_number().and_then(Decimal::as_whole).and_then(|number| u8::try_from(number).ok()) {
            Some(number) if PROGRAM_ENDS.contains(&number) => words.m.push((number, word)),
            Some(_) | None => words.malformed_m = true,
        }
        return;
    }
    let Some(number) = evaluate_m(site, state, words, word) else { return };
    let functions = &site.machine().m_functions;
    let group = functions.group(number);
    let conflict = words.m.iter().copied().find(|(other, _)| functions.group(*other) == group);
    if let Some((first, first_word)) = conflict {
        if word.is_parametric() || first_word.is_parametric() {
            let diagnostic = conflicting_m(site.file, (first, first_word), (number, word), site.machine(), false);
            let diagnostic = with_origin(state, diagnostic, word);
            site.report(with_origin(state, diagnostic, first_word));
        }
        if !words.m_clashes.contains(&group) {
            words.m_clashes.push(group);
        }
    }
    words.m.push((number, word));
}
