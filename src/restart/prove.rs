//! Executes both programs side by side: the new one must do what the old one does from the place on (RST-5).

use super::gather::{flat_words, is_in_cycle};
use super::reason::Reason;
use crate::analysis::state::Before;
use crate::dict::{BUILDER_GROUPS, GGroup, M_GROUPS};
use crate::run::{Executed, Missing, Motion};
use crate::session::Execution;

/// A length that is known in one program only.
const LENGTH: &str = "length";

/// The blocks and the parts of them that are compared.
#[derive(Clone, Copy)]
pub(super) struct Proof {
    /// The first block of the old program.
    pub place: u64,
    /// From here on the new program has the old one's text.
    pub text: u64,
    /// M groups 10 to 14 are compared too.
    pub all_m: bool,
    /// Blocks of the preamble.
    pub preamble: u64,
}

/// Compares what two programs do.
///
/// # Errors
/// The first difference.
pub(super) fn prove(mut old: Execution<'_>, mut new: Execution<'_>, proof: Proof) -> Result<(), Reason> {
    for _ in 0..proof.preamble {
        if new.step().is_none() {
            return Err(failed(new, 0));
        }
    }
    let mut before = Before::new(old.program().settings);
    loop {
        let Some((block, _)) = old.step() else {
            return if new.step().is_none() { Ok(()) } else { Err(Reason::Longer) };
        };
        before.arrive(&block);
        let n = block.n();
        if block.seq() >= proof.place {
            let flat = block.seq() < proof.text;
            let is_left_out = flat && !is_in_cycle(&block) && flat_words(&block, before.state()).is_empty();
            if !is_left_out {
                let Some((other, _)) = new.step() else { return Err(failed(new, n)) };
                if let Some(field) = difference(&block, &other, flat && !is_in_cycle(&block), proof.all_m) {
                    return Err(if field == LENGTH { Reason::Length { n } } else { Reason::Differs { field, n } });
                }
            }
        }
        before.pass(&block);
    }
}

/// The new program ends too early: it has an error.
fn failed(new: Execution<'_>, n: u32) -> Reason {
    let outcome = new.finish().outcome;
    let levels = outcome.findings.levels();
    let error =
        outcome.findings.items().iter().find(|found| levels.of(found.code()) == Some(crate::diag::Severity::Error));
    match error {
        Some(found) => Reason::Fails { code: found.code().to_string() },
        None => Reason::Shorter { n },
    }
}

/// The field of records in which two executed blocks differ; `flat`: the new one is written out.
fn difference(old: &Executed<'_>, new: &Executed<'_>, flat: bool, all_m: bool) -> Option<&'static str> {
    let machine = &old.settings().machine;
    if machine.axes.iter().any(|axis| old.position(axis.letter) != new.position(axis.letter)) {
        return Some("position");
    }
    match (old.motion(), new.motion()) {
        (None, None) => {}
        (Some(old), Some(new)) => {
            if let Some(what) = other_motion(old, new) {
                return Some(what);
            }
        }
        _ => return Some("motion"),
    }
    let groups = GGroup::ALL.into_iter().filter(|group| !(flat && *group == GGroup::G7));
    for group in groups {
        if old.g(group) != new.g(group) {
            return Some("g");
        }
    }
    let m_groups = (0..M_GROUPS).filter(|group| all_m || !BUILDER_GROUPS.contains(group));
    if m_groups.into_iter().any(|group| old.m(group) != new.m(group)) {
        return Some("m");
    }
    let same = [
        ("m_set", old.m_written() == new.m_written()),
        ("m_changed", old.m_changed() == new.m_changed()),
        ("m_at_stop", old.m_at_stop() == new.m_at_stop()),
        ("gear", old.gear() == new.gear()),
        ("feed", old.feed() == new.feed()),
        ("s", old.s() == new.s()),
        ("t", old.t() == new.t()),
        ("tool", old.tool() == new.tool()),
        ("h", old.h() == new.h()),
        ("p", old.p() == new.p()),
        ("d", old.d() == new.d()),
        ("length_correction", old.length_correction() == new.length_correction()),
        ("dynamic_set", old.state().dynamic_set() == new.state().dynamic_set()),
        ("dwell_s", old.dwell() == new.dwell()),
        ("opaque_call", old.opaque_call() == new.opaque_call()),
        ("words", old.words() == new.words()),
        ("skippable", old.skippable() == new.skippable()),
        ("last_block", old.last() == new.last()),
        (
            "data",
            old.data().map(|data| (data.g, data.origin, data.d, data.values))
                == new.data().map(|data| (data.g, data.origin, data.d, data.values)),
        ),
        ("g_set", flat || old.g_written().eq(new.g_written())),
        ("params", flat || old.params() == new.params()),
        ("comments", flat || old.comments().eq(new.comments())),
        ("jump", flat || old.jump() == new.jump()),
    ];
    same.into_iter().find(|(_, same)| !same).map(|(what, _)| what)
}

/// The field in which two motions differ. A length that the old one lacks after a change of origin may be known in the
/// new one.
fn other_motion(old: Motion<'_>, new: Motion<'_>) -> Option<&'static str> {
    if old.kind() != new.kind() || !old.axes().eq(new.axes()) || old.spindle_axis() != new.spindle_axis() {
        return Some("motion");
    }
    if old.axes().any(|axis| old.start(axis) != new.start(axis) || old.delta(axis) != new.delta(axis)) {
        return Some("start");
    }
    let (length, other) = (old.length(), new.length());
    let lacks = length.missing() == Some(Missing::Origin) || (length.missing().is_some() && other.missing().is_some());
    if length != other && !lacks {
        return Some(LENGTH);
    }
    let arc = |motion: Motion<'_>| {
        let arc = motion.arc()?;
        Some((arc.plane, arc.center, arc.radius_mm, arc.sweep_deg, arc.helix))
    };
    (arc(old) != arc(new)).then_some("arc")
}
