//! The block numbers of a file: which jumps can reach, and which stand twice (BLK-7).

use crate::diag::{Diagnostic, Finding, Findings, LabelText};
use crate::dict::{Dialect, HIGHEST_L};
use crate::sure::Sure;
use crate::syntax::{BlockId, ParsedFile, Word};

/// The numbers of a file's blocks.
pub(super) struct Numbered {
    /// Numbers that stand twice.
    pub(super) findings: Findings,
    /// The blocks that these are reported at, copies of others included, in the order of the text.
    pub(super) repeated: Vec<BlockId>,
    /// The first block of each number that jumps can reach, by number.
    pub(super) reachable: Vec<(u32, BlockId)>,
}

/// Numbers the blocks of a file, without those of a second program in it.
pub(super) fn number_blocks(parsed: &ParsedFile) -> Numbered {
    let mut numbered = Numbered { findings: Findings::new(), repeated: Vec::new(), reachable: Vec::new() };
    let mut rising = true;
    let mut last = 0;
    let blocks = || (0..parsed.program_end().0).map(BlockId);
    for block in blocks() {
        let Some(number) = parsed.number(block) else { continue };
        rising &= number > last;
        last = number;
        if number <= HIGHEST_L {
            numbered.reachable.push((number, block));
        }
    }
    if rising {
        return numbered;
    }
    numbered.reachable.sort_unstable();
    numbered.reachable.dedup_by_key(|(number, _)| *number);
    let mut all: Vec<(u32, BlockId)> = blocks().filter_map(|block| Some((parsed.number(block)?, block))).collect();
    all.sort_unstable();
    // Each block whose number stands before, with the first block that has it, in the order of the text.
    let mut repeated: Vec<(BlockId, BlockId)> = Vec::new();
    let mut first: Option<(u32, BlockId)> = None;
    for (number, block) in all {
        match first {
            Some((known, first)) if known == number => repeated.push((block, first)),
            _ => first = Some((number, block)),
        }
    }
    repeated.sort_unstable();
    report(parsed, &repeated, &mut numbered);
    numbered.repeated.sort_unstable();
    numbered
}

/// Reports each run of blocks whose numbers are those of as many consecutive blocks before, in order: once. Of two
/// single blocks the second is reported, unless the numbers around the first alone say that it is the wrong one.
fn report(parsed: &ParsedFile, repeated: &[(BlockId, BlockId)], numbered: &mut Numbered) {
    let mut rest = repeated;
    while let Some((&(block, first), _)) = rest.split_first() {
        let follows = |(at, (again, before)): (u32, &(BlockId, BlockId))| {
            *again == BlockId(block.0 + at) && *before == BlockId(first.0 + at) && *before < block
        };
        let count = (0..).zip(rest).take_while(|&(at, pair)| follows((at, pair))).count();
        let last = rest.get(count.saturating_sub(1)).map_or(block, |(last, _)| *last);
        let last = (count > 1).then(|| parsed.shown_number(last));
        let number = parsed.shown_number(block);
        let twice = parsed.words(first).is_empty() && first.next() == block;
        let copied = last.is_some() || twice || is_copy(parsed, block, first);
        let (at, other, label) = if last.is_none() && !rises(parsed, first) && rises(parsed, block) {
            (first, block, LabelText::BlockHere { block: number })
        } else {
            (block, first, LabelText::FirstBlock { block: number })
        };
        let diagnostic =
            Diagnostic::new(Finding::DuplicateBlockNumber { block: number, last, copied }, parsed.n_place(at));
        numbered.findings.add(diagnostic.with_label(parsed.n_place(other), label));
        let (run, behind) = rest.split_at_checked(count.max(1)).sure();
        numbered.repeated.extend(run.iter().map(|(block, _)| if last.is_none() { at } else { *block }));
        rest = behind;
    }
}

/// The M function whose number an empty block has behind the words of another block on its line: `T2 N6`.
pub fn number_as_function(file: &ParsedFile, block: BlockId) -> Option<String> {
    let n = file.n_word(block).filter(|_| !has_number_of_next(file, block) && word_before(file, block).is_some())?;
    let digits = file.source.slice(n.span(file.source.text())).get(1..)?.trim_start_matches([' ', '\t']);
    let number: u8 = digits.parse().ok().filter(|_| digits.len() <= 2)?;
    (number <= Dialect::HIGHEST_M).then(|| format!("M{digits}"))
}

/// The last word before a block, on the line of its number.
pub(super) fn word_before(file: &ParsedFile, block: BlockId) -> Option<Word> {
    let (text, lines) = (file.source.text(), file.source.lines());
    let (last, n) = (*file.words(BlockId(block.0.checked_sub(1)?)).last()?, file.n_word(block)?);
    (lines.line_at(last.span(text).end) == lines.line_at(n.start())).then_some(last)
}

/// Whether a block is written twice, one behind the other, with its number (E0204).
pub(super) fn is_doubled(parsed: &ParsedFile, block: BlockId) -> bool {
    has_number_of_next(parsed, block) && is_copy(parsed, block, block.next())
}

/// Whether the block behind a block has its number, too (E0204).
pub(super) fn has_number_of_next(parsed: &ParsedFile, block: BlockId) -> bool {
    let next = block.next();
    next.0 < parsed.block_count() && parsed.number(block) == parsed.number(next)
}

/// Whether two blocks have the same words.
fn is_copy(parsed: &ParsedFile, one: BlockId, other: BlockId) -> bool {
    let text = parsed.source.text();
    let written = |block| parsed.words(block).iter().map(|word| parsed.source.slice(word.span(text)));
    !parsed.words(one).is_empty() && written(one).eq(written(other))
}

/// Whether the number of a block lies between those of its neighbours.
pub(super) fn rises(parsed: &ParsedFile, block: BlockId) -> bool {
    parsed.number(block).is_none_or(|number| is_between(parsed, block, number))
}

/// Whether a number lies between those of the neighbours of a block.
pub(super) fn is_between(parsed: &ParsedFile, block: BlockId, number: u32) -> bool {
    let before = block.0.checked_sub(1).and_then(|before| parsed.number(BlockId(before)));
    let behind = (block.next().0 < parsed.block_count()).then(|| parsed.number(block.next())).flatten();
    before.is_none_or(|before| before < number) && behind.is_none_or(|behind| number < behind)
}
