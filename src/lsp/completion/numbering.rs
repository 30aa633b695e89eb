//! Numbers for new blocks, in the way the program numbers its own.

use std::collections::BTreeSet;

use super::context::previous;
use crate::dict::HIGHEST_BLOCK;
use crate::lsp::analysis::Analysis;
use crate::query::cursor::unit_of;
use crate::syntax::{BlockId, ParsedFile};

/// Between two blocks where the program does not show another.
const STEP: u32 = 10;
/// A larger difference is no step: another part begins there.
const LONGEST_STEP: u32 = 1000;
/// How many blocks are looked at for a number, or for a step.
const NEAR: u32 = 8;
/// How many series are tried before the highest number of the file is passed.
const TRIES: u32 = 64;

/// Numbers for `count` new blocks at `at`, rising and free: on from the block before, in the step of the last two
/// blocks, or closer where the block behind leaves less room. A block that begins at `at` itself does not count.
pub(crate) fn next_numbers(analysis: &Analysis, file: &ParsedFile, at: u32, count: u32) -> Option<Vec<u32>> {
    let last = previous(file, at);
    let near = |first: u32| (first..first.saturating_add(NEAR)).map(BlockId);
    let behind = near(last.map_or(0, |block| block.next().0));
    let base = last.map_or(0, |block| {
        let before = (block.0.saturating_sub(NEAR)..=block.0).rev().map(BlockId);
        before.into_iter().find_map(|block| number(file, block)).unwrap_or(0)
    });
    let is_typed = |block: BlockId| file.n_word(block).is_some_and(|word| word.start() == at);
    let next = behind.filter(|block| !is_typed(*block)).find_map(|block| file.number(block));
    let above = next.filter(|next| *next > base).unwrap_or(HIGHEST_BLOCK + 1);
    let usual = step(analysis, file, last);

    let room = above - base;
    let step = if usual.saturating_mul(count) < room { usual } else { room / (count + 1) };
    let reach = base.saturating_add(step.saturating_mul(count + TRIES)).min(above);
    let mut taken = BTreeSet::new();
    let mut highest = 0;
    for block in file.block_ids().filter(|block| !is_typed(*block)) {
        let Some(number) = number(file, block) else { continue };
        highest = highest.max(number);
        if base < number && number <= reach {
            taken.insert(number);
        }
    }
    let series = |first: u32, step: u32| -> Vec<u32> {
        (0..count).map(|place| first.saturating_add(step.saturating_mul(place))).collect()
    };
    let free = (1..=TRIES)
        .map(|place| series(base.saturating_add(step.saturating_mul(place)), step))
        .find(|series| step > 0 && series.iter().all(|number| *number < above && !taken.contains(number)));
    free.or_else(|| {
        let series = series(highest.saturating_add(usual), usual);
        series.iter().all(|number| *number <= HIGHEST_BLOCK).then_some(series)
    })
}

/// The number of a block, also of one that something touches: `N20N`.
fn number(file: &ParsedFile, block: BlockId) -> Option<u32> {
    file.number(block).or_else(|| {
        let text = file.source.text().get(file.n_word(block)?.start() as usize + 1..)?.trim_start_matches([' ', '\t']);
        let digits = text.split(|character: char| !character.is_ascii_digit()).next()?;
        digits.parse().ok().filter(|number| (1..=HIGHEST_BLOCK).contains(number))
    })
}

/// The step of the last two blocks of one unit.
fn step(analysis: &Analysis, file: &ParsedFile, last: Option<BlockId>) -> u32 {
    let Some(last) = last else { return STEP };
    let unit = |block| unit_of(analysis, block).map(|(id, _)| id);
    (last.0.saturating_sub(NEAR) + 1..=last.0)
        .rev()
        .find_map(|second| {
            let (first, second) = (BlockId(second - 1), BlockId(second));
            let step = file.number(second)?.checked_sub(file.number(first)?)?;
            ((1..=LONGEST_STEP).contains(&step) && unit(first) == unit(second)).then_some(step)
        })
        .unwrap_or(STEP)
}

/// A block number as the block before `at` writes its own: with as many digits when that has leading zeros.
pub(crate) fn written(file: &ParsedFile, at: u32, number: u32) -> String {
    let word = previous(file, at).and_then(|block| file.n_word(block));
    let digits = word.map_or("", |word| file.source.slice(word.parts(file.source.text()).value));
    let width = if digits.starts_with('0') { digits.len().min(8) } else { 0 };
    format!("N{number:0width$}")
}
