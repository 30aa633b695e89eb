//! Centres of arcs as other controls write them: I, J, K for X, Y, Z in every plane (MOT-3).

use super::block::InForce;
use super::planes;
use super::site::Site;
use super::words::{BlockWords, Valued};
use crate::config::ArcCenters;
use crate::diag::{CenterPlace, Diagnostic, Edit, Finding, FixTitle};
use crate::dict::{AxisLetter, Decimal};
use crate::syntax::Word;

/// A K in an arc of X and Z or of Y and Z is the distance along Z: says so, with the words that are written here, and
/// leaves the centre unknown, so that one slip is one finding. Whether it did.
pub(super) fn report_k(site: &mut Site<'_>, words: &mut BlockWords, g: &InForce) -> bool {
    let Some(k) = words.k else { return false };
    let machine = site.machine();
    let [x, y, z] = [AxisLetter::X, AxisLetter::Y, AxisLetter::Z].map(|axis| machine.axes.index(axis));
    let mut written: Vec<Option<usize>> = words.axis_words().map(|(axis, _)| Some(axis)).collect();
    if written.len() != 2 {
        let plane = planes::axes_of(&machine.axes, planes::in_force(g));
        written = plane.map(|pair| pair.map(Some).to_vec()).unwrap_or_default();
    }
    let pair = |one: Option<usize>| one.is_some() && written.contains(&one) && z.is_some() && written.contains(&z);
    let zero = |valued: Option<Valued>| valued.is_none_or(|valued| valued.value == Some(Decimal::ZERO));
    // In machine order Z is the later axis of both pairs; the word of the axis that the arc does not have is left out.
    let (unused, renamed) = if machine.arc_centers != ArcCenters::MachineOrder {
        return false;
    } else if pair(x) && zero(words.j) {
        (words.j, None)
    } else if pair(y) && zero(words.i) {
        (words.i, words.j)
    } else {
        return false;
    };
    let text = |word: Word, letter: char| {
        let text = site.file.source.slice(site.word_place(word).span);
        format!("{letter}{}", text.get(1..).unwrap_or_default().trim_start_matches([' ', '\t']))
    };
    let for_k = text(k.word, 'J');
    let mut edits = vec![Edit { at: site.word_place(k.word), text: for_k.clone() }];
    let mut shown = for_k;
    if let Some(renamed) = renamed {
        let for_j = text(renamed.word, 'I');
        shown = format!("{for_j} {shown}");
        edits.push(Edit { at: site.word_place(renamed.word), text: for_j });
    }
    edits.extend(unused.map(|unused| Edit { at: site.word_place(unused.word), text: String::new() }));
    edits.sort_by_key(|edit| edit.at);
    let place = CenterPlace::OtherLetters;
    let finding = Finding::CenterWordNotUsable { letter: 'K', place, written: shown.clone() };
    let at = site.word_place(k.word);
    site.report(Diagnostic::new(finding, at).with_edits(FixTitle::Write { text: shown }, edits));
    words.j = Some(Valued { value: None, ..k });
    true
}
