//! Lines that a block number was forgotten on (BLK-1): which they are is known before the words of their blocks are
//! judged.

use std::collections::{BTreeMap, BTreeSet};

use super::Unit;
use super::functions::{Conflict, Functions};
use super::judge_word::is_out_of_range;
use super::spelling::leading_number;
use crate::config::Settings;
use crate::dict::Address;
use crate::sure::small;
use crate::syntax::{BlockId, ParsedFile, Word};
use crate::text::{LineIndex, Span};

/// So many lines of a unit begin with `N`, at least.
const LEAST: usize = 5;
/// In so many lines of a file the block number was forgotten, at most, where lines often begin with other words.
const FEW: usize = 20;

/// The lines of a file whose block number was forgotten.
#[derive(Debug, Default)]
pub(super) struct Unnumbered {
    /// The first word, and its block, of each line that begins with another word than `N` and continues a block, in
    /// units where eight of ten lines with words begin with `N`.
    pub(super) usual: Vec<(Word, BlockId)>,
    /// Where the words begin of these lines, and of a few others that conflict twice or more with the lines above, in
    /// the order of the text.
    starts: Vec<u32>,
}

impl Unnumbered {
    /// Those of a file with these units.
    pub(super) fn of(settings: &Settings, parsed: &ParsedFile, units: &[Unit]) -> Self {
        let lines = Lines::of(parsed, units);
        let usual: Vec<_> = lines.usual.into_iter().filter(|(word, _)| begins_line(parsed, *word)).collect();
        let mut starts = conflicting(settings, parsed, &lines.continued);
        starts.extend(usual.iter().map(|(word, _)| word.start()));
        starts.sort_unstable();
        starts.dedup();
        Self { usual, starts }
    }

    /// Where the words begin of the last such line that begins before or at a place.
    pub(super) fn line_before(&self, at: u32) -> Option<u32> {
        let before = self.starts.partition_point(|start| *start <= at).checked_sub(1)?;
        self.starts.get(before).copied()
    }

    /// The line between two words that conflict.
    pub(super) fn line_between(&self, conflict: &Conflict) -> Option<u32> {
        self.line_before(conflict.second.start()).filter(|line| conflict.first.start() < *line)
    }
}

/// Where the words begin of a few lines with two conflicts or more with the lines above: these are no accident wherever
/// else lines begin with other words. `continued`: the blocks with words on several lines.
fn conflicting(settings: &Settings, parsed: &ParsedFile, continued: &[BlockId]) -> Vec<u32> {
    let lines = parsed.source.lines();
    let mut starts = Vec::new();
    for &block in continued {
        let words = parsed.words(block);
        let functions = Functions::of(words, settings);
        let mut signs: BTreeMap<usize, usize> = BTreeMap::new();
        for Conflict { first, second, .. } in functions.conflicts.iter().copied().chain(Conflict::of_addresses(words)) {
            let line = lines.line_at(second.start());
            if lines.start(line).is_some_and(|start| first.start() < start) {
                *signs.entry(line).or_default() += 1;
            }
        }
        for (line, conflicts) in signs {
            let Some(start) = other_word(parsed, line) else { continue };
            // `M1400 G79 L200` below a line with G70: the number is that of a block.
            let number = || {
                let first = words.get(words.partition_point(|word| word.start() < start));
                first.is_some_and(|word| is_out_of_range(settings, *word, &functions))
            };
            if conflicts > 1 || number() {
                starts.push(start);
            }
        }
        if starts.len() > FEW {
            return Vec::new();
        }
    }
    starts
}

/// Where the first word of a line begins, when it has another address than `N`.
fn other_word(parsed: &ParsedFile, line: usize) -> Option<u32> {
    let span = parsed.source.line_span(line);
    let text = parsed.source.slice(span).trim_start_matches([' ', '\t']);
    let start = span.end.saturating_sub(small(text.len()));
    text.starts_with(is_other_letter).then_some(start)
}

/// Whether a word is the first of its line, blanks aside.
pub(super) fn is_first_in_line(parsed: &ParsedFile, word: Word) -> bool {
    let start = parsed.source.line_span(parsed.source.lines().line_at(word.start())).start;
    parsed.source.slice(Span::new(start, word.start())).trim_start_matches([' ', '\t']).is_empty()
}

/// The lines of a file that begin with one of those numbers, alone or behind another letter than `N`: `50 X5`, `Z50
/// X5`.
pub(super) fn lines_by_number(parsed: &ParsedFile, wanted: &BTreeSet<u32>) -> BTreeMap<u32, usize> {
    let index = parsed.source.lines();
    let lines = index.line_at(parsed.start)..=index.line_at(parsed.end);
    let numbered =
        lines.filter_map(|line| Some((line_number(parsed.source.slice(parsed.source.line_span(line)))?, line)));
    numbered.filter(|(number, _)| wanted.contains(number)).collect()
}

/// The line, counted from 0, that lacks the block number and is the place for the block, by wanted number; of several
/// lines the first.
pub(super) fn lines_between(
    parsed: &ParsedFile,
    unnumbered: &[(Word, BlockId)],
    wanted: &BTreeSet<u32>,
) -> BTreeMap<u32, usize> {
    let mut lines = BTreeMap::new();
    for (word, block) in unnumbered.iter().rev() {
        let next = block.next();
        let behind = (next.0 < parsed.block_count()).then(|| parsed.number(next)).flatten().unwrap_or(u32::MAX);
        let Some(before) = parsed.number(*block).filter(|before| *before < behind) else { continue };
        let line = parsed.source.lines().line_at(word.start());
        lines.extend(wanted.range(before + 1..behind).map(|number| (*number, line)));
    }
    lines
}

/// The whole number that a line begins with, also behind another letter than `N`.
fn line_number(line: &str) -> Option<u32> {
    let line = line.trim_start_matches([' ', '\t']);
    let (number, behind) = leading_number(line.strip_prefix(is_other_letter).unwrap_or(line))?;
    behind.starts_with([' ', '\t']).then_some(number)
}

/// Whether a letter is another address than `N`.
const fn is_other_letter(letter: char) -> bool {
    letter.is_ascii_alphabetic() && !matches!(letter, 'N' | 'n')
}

/// The lines of a file with words.
#[derive(Default)]
struct Lines {
    /// The first word, and its block, of each that continues a block in a unit where that is not usual.
    usual: Vec<(Word, BlockId)>,
    /// The blocks with words on several lines.
    continued: Vec<BlockId>,
}

/// The lines of a unit, counted.
#[derive(Default)]
struct Counted {
    /// Those with words.
    with_words: usize,
    /// Those whose first word is an `N`.
    numbered: usize,
    /// The first word, and its block, of each of the others.
    continuing: Vec<(Word, BlockId)>,
}

impl Lines {
    fn of(parsed: &ParsedFile, units: &[Unit]) -> Self {
        let mut lines = Self::default();
        let mut behind = BlockId(0);
        for unit in units {
            lines.count(parsed, behind, unit.first);
            let counted = lines.count(parsed, unit.first, unit.end);
            if counted.numbered >= LEAST && counted.numbered * 10 >= counted.with_words * 8 {
                lines.usual.extend(counted.continuing);
            }
            behind = unit.end;
        }
        lines.count(parsed, behind, BlockId(parsed.block_count()));
        lines
    }

    /// Counts the lines of consecutive blocks, and notes the blocks with words on several of them.
    fn count(&mut self, parsed: &ParsedFile, first: BlockId, end: BlockId) -> Counted {
        let index = parsed.source.lines();
        let mut lines = Counted::default();
        let mut line = 0;
        let mut seen = None;
        for block in (first.0..end.0).map(BlockId) {
            let Some(n) = parsed.n_word(block) else { continue };
            line = index.line_near(n.start(), line);
            if seen != Some(line) {
                lines.with_words += 1;
                lines.numbered += 1;
                seen = Some(line);
            }
            let words = parsed.words(block);
            if words.last().is_none_or(|last| in_line(index, line, *last)) {
                continue;
            }
            self.continued.push(block);
            for &word in words {
                line = index.line_near(word.start(), line);
                if seen != Some(line) {
                    lines.with_words += 1;
                    lines.continuing.push((word, block));
                    seen = Some(line);
                }
            }
        }
        lines
    }
}

fn in_line(index: &LineIndex, line: usize, word: Word) -> bool {
    index.start(line + 1).is_none_or(|next| word.start() < next)
}

/// Whether a word without a finding begins its line, comments aside. A `/` there has W0213; a line that begins with a
/// blank or tab is meant to continue the block (BLK-1).
fn begins_line(parsed: &ParsedFile, word: Word) -> bool {
    if word.address == Address::Skip || (word.is_void() && word.is_faulty()) {
        return false;
    }
    let lines = parsed.source.lines();
    let mut from = lines.start(lines.line_at(word.start())).unwrap_or(word.start());
    if matches!(parsed.source.text().as_bytes().get(from as usize), Some(b' ' | b'\t')) {
        return false;
    }
    let comments = parsed.all_comments();
    let first = comments.partition_point(|comment| comment.start < from);
    let blank = |from: u32, to: u32| {
        let text = parsed.source.slice(Span::new(from, to));
        text.bytes().all(|byte| matches!(byte, b' ' | b'\t'))
    };
    for comment in comments.iter().skip(first).take_while(|comment| comment.start < word.start()) {
        if !blank(from, comment.start) {
            return false;
        }
        from = comment.end;
    }
    blank(from, word.start())
}
