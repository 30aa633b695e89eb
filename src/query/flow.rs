//! The unit or block that a block calls, enters or jumps to, as written.

use super::analysis::Analysis;
use super::cursor::DOCUMENT;
use crate::dict::GCode;
use crate::resolve::{Roles, Taker, Target};
use crate::syntax::{BlockId, ParsedFile, Word};
use crate::text::FileId;

/// The call, jump or entry of a block, its function written out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flow {
    /// G71, G72, G73 or G79.
    pub(crate) code: GCode,
    pub(crate) word: Word,
    pub(crate) l: Option<Word>,
    /// Q, unless it is a dwell (FLW-6).
    pub(crate) repeat: Option<Word>,
    /// Forward it jumps every time (FLW-3).
    pub(crate) uncounted: bool,
    /// Where it leads, when that is written with digits and exists; none for an entry.
    pub(crate) target: Option<Target>,
}

impl Flow {
    /// Of a block of the document.
    pub(crate) fn of(analysis: &Analysis, file: &ParsedFile, block: BlockId) -> Option<Self> {
        let roles = Roles::written(file.words(block));
        let Taker::One(code, word) = roles.taker else { return None };
        let target = analysis.resolved.target(DOCUMENT, block);
        Some(Self { code, word, l: roles.l, repeat: roles.repeat(), uncounted: roles.is_uncounted(), target })
    }

    /// How often it calls or jumps; `None` when Q is no number written out. A jump without Q counts one.
    pub(crate) fn times(&self) -> Option<i64> {
        self.repeat.map_or(Some(1), |q| q.whole())
    }

    /// The block that it jumps to.
    pub(crate) const fn jump(&self) -> Option<BlockId> {
        match self.target {
            Some(Target::Block(block)) => Some(block),
            Some(Target::Unit(_)) | None => None,
        }
    }

    /// The file and block that it leads to.
    pub(crate) fn place(&self, analysis: &Analysis) -> Option<(FileId, BlockId)> {
        match self.target? {
            Target::Block(block) => Some((DOCUMENT, block)),
            Target::Unit(unit) => analysis.resolved.unit(unit).map(|unit| (unit.file, unit.first)),
        }
    }

    /// Where its last word ends.
    pub(crate) fn end(&self, text: &str) -> u32 {
        let words = [Some(self.word), self.l, self.repeat];
        words.into_iter().flatten().map(|word| word.span(text).end).max().unwrap_or(0)
    }
}
