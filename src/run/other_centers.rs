//! Centres of arcs as other controls write them: I, J, K for X, Y, Z in every plane (MOT-3).

use super::arc_findings::{because_of, center_axes};
use super::block::InForce;
use super::planes;
use super::site::Site;
use super::state::State;
use super::words::{BlockWords, Valued};
use crate::diag::{CenterPlace, Diagnostic, Edit, Finding, FixTitle};
use crate::dict::{AxisLetter, Decimal};
use crate::sure::Sure;
use crate::syntax::Word;

/// A K in an arc of X and Z or of Y and Z is the distance along Z: says so, with the words that are written here, and
/// leaves the centre unknown, so that one slip is one finding. Whether it did.
pub(super) fn report_k(site: &mut Site<'_>, state: &State, words: &mut BlockWords, g: &InForce) -> bool {
    let Some(k) = words.k.filter(|k| !k.word.is_void()) else { return false };
    let machine = site.machine();
    let [x, y, z] = [AxisLetter::X, AxisLetter::Y, AxisLetter::Z].map(|axis| machine.axes.index(axis));
    let written: Vec<usize> = words.axis_words().map(|(axis, _)| axis).collect();
    let pair = match *written.as_slice() {
        [one, other] => Some([one, other]),
        _ => planes::axes_of(&machine.axes, planes::in_force(g)),
    };
    let (Some(pair), Some(z)) = (pair, z) else { return false };
    let of_pair = |axis: Option<usize>| axis.is_some_and(|axis| pair.contains(&axis)) && pair.contains(&z);
    let zero = |valued: Option<Valued>| valued.is_none_or(|valued| valued.value == Some(Decimal::ZERO));
    // The word of the axis that the arc does not have is left out.
    let (unused, other, old_letter) = if of_pair(x) && zero(words.j) {
        (words.j, words.i, 'I')
    } else if of_pair(y) && zero(words.i) {
        (words.i, words.j, 'J')
    } else {
        return false;
    };
    let [for_i, _] = center_axes(machine, planes::named(&machine.axes, pair));
    let (for_z, for_other) = if for_i == z { ('I', 'J') } else { ('J', 'I') };
    let text = |word: Word, letter: char| {
        let text = site.file.source.slice(site.word_place(word).span);
        format!("{letter}{}", text.get(1..).sure().trim_start_matches([' ', '\t']))
    };
    let for_k = text(k.word, for_z);
    let mut edits = vec![Edit { at: site.word_place(k.word), text: for_k.clone() }];
    let mut shown = for_k;
    if let Some(renamed) = other.filter(|_| old_letter != for_other) {
        let renamed_text = text(renamed.word, for_other);
        shown = if for_other == 'I' { format!("{renamed_text} {shown}") } else { format!("{shown} {renamed_text}") };
        edits.push(Edit { at: site.word_place(renamed.word), text: renamed_text });
    }
    edits.extend(unused.map(|unused| Edit { at: site.word_place(unused.word), text: String::new() }));
    edits.sort_by_key(|edit| edit.at);
    let place = CenterPlace::OtherLetters;
    let finding = Finding::CenterWordNotUsable { letters: "K".to_owned(), place, written: shown.clone() };
    let at = site.word_place(k.word);
    let diagnostic = Diagnostic::new(finding, at).with_offers(FixTitle::Write { text: shown }, edits);
    site.report(because_of(state, words, g, diagnostic));
    words.j = Some(Valued { value: None, ..k });
    true
}
