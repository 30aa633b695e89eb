//! The word, comment or block at a place of the text.

use super::analysis::Analysis;
use crate::resolve::{Unit, UnitId};
use crate::syntax::{BlockId, ParsedFile, Word};
use crate::text::{FileId, Span};

/// The document of an analysis: file 0.
pub(crate) const DOCUMENT: FileId = FileId(0);

/// A word with the block it is in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WordAt {
    /// `None`: the `%` word.
    pub(crate) block: Option<BlockId>,
    pub(crate) word: Word,
    /// All of it.
    pub(crate) span: Span,
}

/// The block that a place is in: from its `N` up to the next one.
pub(crate) fn block_at(file: &ParsedFile, offset: u32) -> Option<BlockId> {
    file.block_at(offset)
}

/// The word that covers a place, or ends there: at the border of two words the one that begins.
pub(crate) fn word_at(file: &ParsedFile, offset: u32) -> Option<WordAt> {
    let text = file.source.text();
    let block = block_at(file, offset);
    let of_block = block.into_iter().flat_map(|block| {
        let words = file.n_word(block).into_iter().chain(file.words(block).iter().copied());
        words.map(move |word| (Some(block), word))
    });
    let program = file.program.map(|word| (None, word));
    let touching = program.into_iter().chain(of_block).filter_map(|(block, word)| {
        let span = word.span(text);
        (span.start <= offset && offset <= span.end).then_some(WordAt { block, word, span })
    });
    touching.max_by_key(|found| found.span.start)
}

/// The unit that a block of the document belongs to.
pub(crate) fn unit_of(analysis: &Analysis, block: BlockId) -> Option<(UnitId, &Unit)> {
    analysis.resolved.units().find(|(_, unit)| unit.file == DOCUMENT && unit.contains(block))
}
