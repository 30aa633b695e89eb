//! Reads the words of a block, all with the values from before it (PAR-4).

use super::parameters::{evaluate_form, evaluate_g, evaluate_m, with_origin};
use super::site::Site;
use super::state::State;
use super::words::BlockWords;
use crate::diag::{Diagnostic, Finding, LabelText};
use crate::dict::{Address, GCode, GGroup};
use crate::syntax::Word;

/// Reads the words of the block into `words`.
pub(super) fn read(site: &mut Site<'_>, state: &mut State, words: &mut BlockWords) {
    words.clear();
    let written = site.file.words(site.block);
    let mut late = false;
    for &word in written {
        if let Some(axis) = site.machine().axes.index_of(word.address) {
            let valued = evaluate_form(site, state, word, false, None);
            if let Some(slot) = words.axes.get_mut(axis) {
                words.axis_count += usize::from(slot.is_none());
                *slot = Some(valued);
            }
            continue;
        }
        let mut plain = |site: &mut Site<'_>| Some(evaluate_form(site, state, word, false, None));
        match word.address {
            Address::G => read_g(site, state, words, word),
            Address::M => read_m(site, state, words, word),
            Address::R => words.r.push(word),
            // What F and Q mean follows from G words that may come later.
            Address::F | Address::Q => late = true,
            Address::I => words.i = plain(site),
            Address::J => words.j = plain(site),
            Address::K => words.k = plain(site),
            Address::S => words.s = plain(site),
            Address::T => words.t = plain(site),
            Address::H => words.h = plain(site),
            Address::P => words.p = plain(site),
            Address::D => words.d = plain(site),
            Address::Correction => words.correction = plain(site),
            Address::L => words.l = plain(site),
            Address::X
            | Address::Y
            | Address::Z
            | Address::A
            | Address::B
            | Address::C
            | Address::U
            | Address::V
            | Address::W
            | Address::N
            | Address::Skip
            | Address::Program => {}
        }
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
        let mode = written.or_else(|| state.modal(GGroup::G6)).filter(|_| !words.unknown_g);
        words.f = Some(evaluate_form(site, state, word, false, mode));
        return;
    }
    let dwell = words.has(GCode::G04).is_some() || words.unknown_g;
    words.q = Some(evaluate_form(site, state, word, dwell, None));
}

fn read_g(site: &mut Site<'_>, state: &mut State, words: &mut BlockWords, word: Word) {
    words.parametric_g |= word.is_parametric();
    let Some(code) = evaluate_g(site, state, words, word) else { return };
    if let Some((first, first_word)) = words.written(code.group()) {
        // Found before execution when both are written out.
        let finding = Finding::ConflictingG { first, second: code, group: code.group() };
        let diagnostic = Diagnostic::new(finding, site.word_place(word));
        let diagnostic =
            diagnostic.with_label(site.word_place(first_word), LabelText::First { what: first.to_string() });
        let diagnostic = with_origin(state, diagnostic, word);
        site.report(with_origin(state, diagnostic, first_word));
        return;
    }
    words.g.push((code, word));
}

fn read_m(site: &mut Site<'_>, state: &mut State, words: &mut BlockWords, word: Word) {
    let Some(number) = evaluate_m(site, state, word) else { return };
    let functions = &site.machine().m_functions;
    let group = functions.group(number);
    let conflict = words.m.iter().copied().find(|(other, _)| functions.group(*other) == group);
    if let Some((first, first_word)) = conflict {
        let finding = Finding::ConflictingM { first, second: number, group };
        let diagnostic = Diagnostic::new(finding, site.word_place(word));
        let diagnostic =
            diagnostic.with_label(site.word_place(first_word), LabelText::First { what: format!("M{first:02}") });
        let diagnostic = with_origin(state, diagnostic, word);
        site.report(with_origin(state, diagnostic, first_word));
        return;
    }
    words.m.push((number, word));
}
