//! The calls and jumps that multiply what is executed (FLW-9).

use super::frames::CallInfo;
use crate::text::FileId;

/// So many are kept.
const MOST: usize = 12;

/// A call or jump that is repeated.
#[derive(Clone, Debug, Eq, PartialEq)]
struct Repeat {
    /// Its file and block number.
    at: (FileId, u32),
    /// `G71 L5`, `G73`.
    what: String,
    /// How often what it leads to is executed at a stretch.
    times: u64,
}

/// Those with the highest counts, in the order in which they came.
#[derive(Clone, Debug, Default)]
pub(super) struct Repeats {
    kept: Vec<Repeat>,
}

impl Repeats {
    /// A call under way.
    pub(super) fn note_call(&mut self, call: &CallInfo) {
        if call.of > 1 && self.is_news((call.file, call.n), u64::from(call.of)) {
            let what = format!("{} L{}", call.by.name(), call.l);
            self.note(Repeat { at: (call.file, call.n), what, times: u64::from(call.of) });
        }
    }

    /// A jump back in block `n`, made `of` times: its stretch runs once more than that (FLW-3).
    pub(super) fn note_jump(&mut self, file: FileId, n: u32, of: u32) {
        let times = u64::from(of) + 1;
        if self.is_news((file, n), times) {
            self.note(Repeat { at: (file, n), what: "G73".to_owned(), times });
        }
    }

    /// Whether something changes with it: most are known from an earlier pass.
    fn is_news(&self, at: (FileId, u32), times: u64) -> bool {
        self.kept.iter().all(|kept| kept.at != at || kept.times < times)
    }

    fn note(&mut self, repeat: Repeat) {
        self.kept.retain(|kept| kept.at != repeat.at);
        self.kept.push(repeat);
        if self.kept.len() > MOST
            && let Some((least, _)) = self.kept.iter().enumerate().min_by_key(|(_, kept)| kept.times)
        {
            self.kept.remove(least);
        }
    }

    /// These, then the others, as a text.
    pub(super) fn with(mut self, others: &Self) -> String {
        for other in &others.kept {
            if self.kept.iter().all(|kept| kept.at != other.at) {
                self.kept.push(other.clone());
            }
        }
        let shown =
            self.kept.iter().take(MOST).map(|Repeat { at: (_, n), what, times }| format!("N{n} {what} ×{times}"));
        shown.collect::<Vec<_>>().join(", ")
    }
}
