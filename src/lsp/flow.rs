//! What a block calls, enters or jumps to, as it is written.

use super::analysis::Analysis;
use super::cursor::DOCUMENT;
use crate::dict::GCode;
use crate::resolve::{Roles, Taker, Target};
use crate::syntax::{BlockId, ParsedFile, Word};
use crate::text::FileId;

/// The call, jump or entry of a block, its function written out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flow {
    /// G71, G72, G73 or G79.
    pub(super) code: GCode,
    pub(super) word: Word,
    pub(super) l: Option<Word>,
    /// Q, unless it is a dwell (FLW-6).
    pub(super) repeat: Option<Word>,
    /// Forward it jumps every time (FLW-3).
    pub(super) uncounted: bool,
    /// Where it leads, when that is written with digits and exists; none for an entry.
    pub(super) target: Option<Target>,
}

impl Flow {
    /// Of a block of the document.
    pub(super) fn of(analysis: &Analysis, file: &ParsedFile, block: BlockId) -> Option<Self> {
        let roles = Roles::written(file.words(block));
        let Taker::One(code, word) = roles.taker else { return None };
        let target = analysis.resolved.target(DOCUMENT, block);
        Some(Self { code, word, l: roles.l, repeat: roles.repeat(), uncounted: roles.is_uncounted(), target })
    }

    /// How often it calls or jumps; `None` when Q is no number written out. A jump without Q counts one.
    pub(super) fn times(&self) -> Option<i64> {
        self.repeat.map_or(Some(1), |q| q.whole())
    }

    /// The block that it jumps to.
    pub(super) const fn jump(&self) -> Option<BlockId> {
        match self.target {
            Some(Target::Block(block)) => Some(block),
            Some(Target::Unit(_)) | None => None,
        }
    }

    /// The file and block that it leads to.
    pub(super) fn place(&self, analysis: &Analysis) -> Option<(FileId, BlockId)> {
        match self.target? {
            Target::Block(block) => Some((DOCUMENT, block)),
            Target::Unit(unit) => analysis.resolved.unit(unit).map(|unit| (unit.file, unit.first)),
        }
    }

    /// Where its last word ends.
    pub(super) fn end(&self, text: &str) -> u32 {
        let words = [Some(self.word), self.l, self.repeat];
        words.into_iter().flatten().map(|word| word.span(text).end).max().unwrap_or(0)
    }
}
