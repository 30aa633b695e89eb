//! From where to where in the text blocks, units and loops reach.

use super::analysis::Analysis;
use super::cursor::DOCUMENT;
use crate::resolve::{Target, Unit, UnitKind};
use crate::sure::{Sure, small};
use crate::syntax::{BlockId, ParsedFile};
use crate::text::Span;

/// A block from its `N` to its last word.
pub(crate) fn words_span(file: &ParsedFile, block: BlockId) -> Span {
    let text = file.source.text();
    let first = file.n_word(block).map_or(Span::empty(file.start), |word| word.span(text));
    let end = file.words(block).last().map_or(first.end, |word| word.span(text).end);
    Span::new(first.start, end.max(first.end))
}

/// A block from its `N` to the last of its words and of the comments behind them.
pub(crate) fn block_span(file: &ParsedFile, block: BlockId) -> Span {
    let words = words_span(file, block);
    let comments = file.comments_behind(block).last().map_or(words.end, |comment| comment.end);
    Span::new(words.start, words.end.max(comments))
}

/// Whether a comment has its lines to itself.
pub(crate) fn stands_alone(text: &str, comment: Span) -> bool {
    let blank = [' ', '\t', '\u{feff}'];
    let before = text.get(..comment.start as usize).sure().trim_end_matches(blank);
    let after = text.get(comment.end as usize..).sure().trim_start_matches(blank);
    (before.is_empty() || before.ends_with(['\n', '\r'])) && (after.is_empty() || after.starts_with(['\n', '\r']))
}

/// Whether `next` begins in the line after that in which `before` ends, with nothing in between.
pub(crate) fn adjoin(text: &str, before: u32, next: u32) -> bool {
    // Not when it stands before: a comment within an `N` word.
    let between = text.get(before as usize..next as usize);
    between.is_some_and(|between| matches!(between.trim_matches([' ', '\t']), "\r\n" | "\n" | "\r"))
}

/// The comments in the lines directly above a block.
pub(crate) fn comments_above(file: &ParsedFile, block: BlockId) -> &[Span] {
    let text = file.source.text();
    let before = match block.0.checked_sub(1) {
        Some(before) => file.comments_behind(BlockId(before)),
        None => file.comments_before_blocks(),
    };
    let mut next = file.n_word(block).map_or(file.start, |word| word.start());
    let above = before.iter().rev().take_while(|comment| {
        let above = stands_alone(text, **comment) && adjoin(text, comment.end, next);
        next = comment.start;
        above
    });
    let first = before.len() - above.count();
    before.get(first..).sure()
}

/// Where a unit of the document begins: a program at `%`, a subprogram with the comments above it.
pub(crate) fn unit_start(file: &ParsedFile, unit: &Unit) -> u32 {
    match unit.kind {
        UnitKind::Main => file.start,
        UnitKind::Subprogram(_) | UnitKind::Macrocycle(_) => {
            let above = comments_above(file, unit.first).first().map(|comment| comment.start);
            above.unwrap_or_else(|| file.n_word(unit.first).map_or(file.start, |word| word.start()))
        }
    }
}

/// A unit of the document, with the comments that belong to it.
pub(crate) fn unit_span(file: &ParsedFile, unit: &Unit) -> Span {
    let start = unit_start(file, unit);
    let end = match unit.end.0.checked_sub(1).map(BlockId).filter(|last| unit.contains(*last)) {
        Some(last) => block_span(file, last).end,
        None => file.program.map_or(start, |word| word.span(file.source.text()).end),
    };
    // What stands directly above the next subprogram is that one's.
    let above_next = comments_above(file, unit.end).first().map(|comment| comment.start);
    match above_next.filter(|next| *next < end && file.flags(unit.end).has(crate::syntax::BlockFlags::ENTRY)) {
        Some(next) => Span::new(start, content_end(file, next).max(start)),
        None => Span::new(start, end.max(start)),
    }
}

/// Where the last thing before `offset` ends.
pub(crate) fn content_end(file: &ParsedFile, offset: u32) -> u32 {
    let before = file.source.text().get(..offset as usize).sure().trim_end();
    small(before.len())
}

/// The loops of the document, as the block that a jump goes back to and the block of the jump, in the order of the
/// jumps.
pub(crate) fn loops(analysis: &Analysis) -> impl Iterator<Item = (BlockId, BlockId)> + '_ {
    analysis.resolved.targets(DOCUMENT).iter().filter_map(|(jump, target)| match target {
        Target::Block(first) if first <= jump => Some((*first, *jump)),
        Target::Block(_) | Target::Unit(_) => None,
    })
}
