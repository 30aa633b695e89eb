//! Lines that a block number was forgotten on (BLK-1).

use std::collections::{BTreeMap, BTreeSet};

use super::Unit;
use crate::diag::{Code, Diagnostic, Finding, Findings};
use crate::dict::Address;
use crate::sure::small;
use crate::syntax::{BlockId, ParsedFile, Word};
use crate::text::{LineIndex, Location, Span};

/// So many lines of a unit begin with `N`, at least.
const LEAST: usize = 5;
/// In so many lines of a file the block number was forgotten, at most, where lines often begin with other words.
const FEW: usize = 20;

/// Warns of lines that begin with another word than `N` and continue a block, in units where eight of ten lines with words
/// begin with `N`.
pub(super) fn check(parsed: &ParsedFile, units: &[Unit]) -> Findings {
    let mut findings = Findings::new();
    for unit in units {
        let lines = Lines::of(parsed, unit);
        if lines.numbered < LEAST || lines.numbered * 10 < lines.with_words * 8 {
            continue;
        }
        for &(word, block) in lines.continuing.iter().filter(|(word, _)| begins_line(parsed, *word)) {
            let finding = Finding::LineWithoutNumber { block: parsed.shown_number(block) };
            findings.add(Diagnostic::new(finding, parsed.word_place(word)));
        }
    }
    findings
}

/// Makes one finding of a line that was warned of and the conflicts of its words with those above it, which follow from the
/// block number that was forgotten there: the first conflict, an error, takes the place of the warning and says so. Blocks
/// without words that are numbered further on in the line are part of it. `entries`: begin subprograms, and have a finding
/// about such a line. Gives the blocks that such lines continue.
pub(super) fn join_conflicts(
    parsed: &ParsedFile,
    entries: &[BlockId],
    warned: &mut Findings,
    findings: &mut Findings,
) -> Vec<BlockId> {
    let lines = parsed.source.lines();
    let starts = unnumbered(parsed, warned, findings);
    if starts.is_empty() {
        return Vec::new();
    }
    let line_of = |found: &Diagnostic| {
        let at = starts.partition_point(|start| *start <= found.at.span.start).checked_sub(1)?;
        starts.get(at).copied()
    };
    let mut first: BTreeMap<u32, Location> = BTreeMap::new();
    for found in findings.items() {
        if let Some(line) = line_of(found).filter(|line| conflicts_above(found, *line)) {
            let place = first.entry(line).or_insert(found.at);
            *place = found.at.min(*place);
        }
    }
    findings.revise(|found| {
        let Some(line) = line_of(found) else { return true };
        let start = found.at.span.start;
        // An L or Q that begins such a line is part of it.
        if matches!(found.code(), Code::W0402 | Code::W0403) && start == line {
            return false;
        }
        if is_number_at_line(parsed, found) && first.contains_key(&line) {
            return false;
        }
        if found.code() == Code::W0214 && lines.line_at(start) == lines.line_at(line) {
            return false;
        }
        if !conflicts_above(found, line) {
            return true;
        }
        if let Finding::DuplicateAddress { unnumbered, .. }
        | Finding::ConflictingG { unnumbered, .. }
        | Finding::ConflictingM { unnumbered, .. } = &mut found.finding
        {
            *unnumbered = true;
        }
        first.get(&line) == Some(&found.at)
    });
    warned.revise(|found| {
        let entry = parsed.block_at(found.at.span.start).is_some_and(|block| entries.contains(&block));
        !entry && !first.contains_key(&found.at.span.start)
    });
    first.values().filter_map(|at| parsed.block_at(at.span.start)).collect()
}

/// Where the words begin of the lines whose block number was forgotten, in their order: those that are warned of, and a few
/// with two conflicts or more with the lines above, which are no accident wherever else lines begin with other words.
fn unnumbered(parsed: &ParsedFile, warned: &Findings, findings: &Findings) -> Vec<u32> {
    let lines = parsed.source.lines();
    let line_of = |found: &Diagnostic| lines.line_at(found.at.span.start);
    let mut signs: BTreeMap<usize, usize> = BTreeMap::new();
    for found in findings.items() {
        let line = line_of(found);
        if lines.start(line).is_some_and(|start| conflicts_above(found, start)) {
            *signs.entry(line).or_default() += 1;
        }
    }
    // `M1400 G79 L200` below a line with G70: the number is that of a block.
    for found in findings.items().iter().filter(|found| is_number_at_line(parsed, found)) {
        if let Some(count) = signs.get_mut(&line_of(found)) {
            *count += 1;
        }
    }
    signs.retain(|_, count| *count > 1);
    let begins = |line: usize| {
        let span = parsed.source.line_span(line);
        let text = parsed.source.slice(span).trim_start_matches([' ', '\t']);
        let start = span.end.saturating_sub(small(text.len()));
        text.starts_with(is_other_letter).then_some(start)
    };
    let few = Some(signs).filter(|signs| signs.len() <= FEW).unwrap_or_default();
    let mut starts: Vec<u32> = few.into_keys().filter_map(begins).collect();
    starts.extend(warned.items().iter().map(|found| found.at.span.start));
    starts.sort_unstable();
    starts.dedup();
    starts
}

/// Whether a finding says that the number of the first word of a line is out of range.
fn is_number_at_line(parsed: &ParsedFile, found: &Diagnostic) -> bool {
    let before = || {
        let at = found.at.span.start;
        let start = parsed.source.line_span(parsed.source.lines().line_at(at)).start;
        parsed.source.slice(Span::new(start, at)).trim_start_matches([' ', '\t'])
    };
    found.code() == Code::E0302 && before().len() == 1
}

/// Leaves out what follows from a line without its `N`. A word that does not belong into the block that begins a subprogram is
/// an error already. Of jumps to a block whose line begins with its number (`50 X5`, `Z50 X5`) the first stays, and says
/// all that a warning of that line would say.
pub(super) fn join(parsed: &ParsedFile, findings: &mut Findings) {
    let of_code = |code: Code| findings.items().iter().filter(move |found| found.code() == code).map(|found| found.at);
    let crowded: BTreeSet<Location> = of_code(Code::E0208).collect();
    if of_code(Code::W0221).any(|at| crowded.contains(&at)) {
        findings.revise(|found| found.code() != Code::W0221 || !crowded.contains(&found.at));
    }
    let missing = |found: &Diagnostic| {
        let Finding::UnknownJumpTarget { l, .. } = found.finding else { return None };
        (found.at.file == parsed.file).then_some(l)
    };
    let mut first: BTreeMap<u32, Location> = BTreeMap::new();
    for (l, at) in findings.items().iter().filter_map(|found| Some((missing(found)?, found.at))) {
        let place = first.entry(l).or_insert(at);
        *place = at.min(*place);
    }
    if first.is_empty() {
        return;
    }
    let index = parsed.source.lines();
    let lines = index.line_at(parsed.start)..=index.line_at(parsed.end);
    let numbered =
        lines.filter_map(|line| Some((line_number(parsed.source.slice(parsed.source.line_span(line)))?, line)));
    let unnumbered: BTreeMap<u32, usize> = numbered.filter(|(number, _)| first.contains_key(number)).collect();
    let warned: BTreeSet<usize> = unnumbered.values().copied().collect();
    findings.revise(|found| {
        let Some((l, at)) = missing(found).and_then(|l| Some((l, *unnumbered.get(&l)?))) else {
            return found.code() != Code::W0221 || !warned.contains(&index.line_at(found.at.span.start));
        };
        if let Finding::UnknownJumpTarget { near, line, .. } = &mut found.finding {
            (*near, *line) = (None, Some(small(at + 1)));
        }
        first.get(&l) == Some(&found.at)
    });
}

/// The whole number that a line begins with, also behind another letter than `N`.
fn line_number(line: &str) -> Option<u32> {
    let line = line.trim_start_matches([' ', '\t']);
    let (number, behind) = leading_number(line.strip_prefix(is_other_letter).unwrap_or(line))?;
    behind.starts_with([' ', '\t']).then_some(number)
}

/// The whole number that a text begins with, and what stands behind it.
pub(super) fn leading_number(text: &str) -> Option<(u32, &str)> {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let (digits, behind) = text.split_at(digits);
    Some((digits.parse().ok()?, behind))
}

/// Whether a letter is another address than `N`.
const fn is_other_letter(letter: char) -> bool {
    letter.is_ascii_alphabetic() && !matches!(letter, 'N' | 'n')
}

/// Whether a finding says that words conflict, of which one stands before the line that begins at `line`.
fn conflicts_above(found: &Diagnostic, line: u32) -> bool {
    let conflict = matches!(found.code(), Code::E0306 | Code::E0307 | Code::E0308);
    conflict && found.labels.iter().any(|label| label.at.span.start < line)
}

/// The lines of a unit.
#[derive(Default)]
struct Lines {
    /// Those with words.
    with_words: usize,
    /// Those whose first word is an `N`.
    numbered: usize,
    /// The first word, and its block, of each of the others.
    continuing: Vec<(Word, BlockId)>,
}

impl Lines {
    fn of(parsed: &ParsedFile, unit: &Unit) -> Self {
        let index = parsed.source.lines();
        let mut lines = Self::default();
        let mut line = 0;
        let mut seen = None;
        for block in (unit.first.0..unit.end.0).map(BlockId) {
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

/// Whether a word that has no finding of its own there begins its line, comments aside. A `/` there has W0213; a line that
/// begins with a blank or tab is meant to continue the block (BLK-1).
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
