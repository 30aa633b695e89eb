//! New numbers for the blocks of a file (REN-1 to REN-5): one sequence through all its units, or through a part of
//! them, with the jumps rewritten. `%` and the L of calls and subprograms stay.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use super::alone;
use super::edit_texts::EditText;
use super::line_length::first_long_line;
use super::output::{Output, Written};
use crate::config::Settings;
use crate::diag::Code;
use crate::dict::{Address, GCode, HIGHEST_BLOCK, HIGHEST_L};
use crate::resolve::{Resolved, Roles, Taker, Target, UnitKind};
use crate::session::Outcome;
use crate::sure::small;
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Word};
use crate::text::{FileId, SourceText, Span};

/// The file itself.
const FILE: FileId = FileId(0);

/// Distances of numbers that the editor tries, the usual one first.
const STEPS: [u32; 4] = [10, 5, 2, 1];

/// Which numbers blocks get (REN-1).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Numbering {
    /// The first number, 1 to 99999999.
    pub start: u32,
    /// From one to the next, at least 1.
    pub step: u32,
    /// Digits of N, filled up with zeros; 0 for none.
    pub width: usize,
    /// Which blocks.
    pub part: Part,
}

/// Which blocks get new numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Part {
    /// All of the file.
    All,
    /// Those of one subprogram, by its L.
    Unit(u32),
    /// From the first block of one number to the first of another behind it, both included.
    Blocks(Option<u32>, Option<u32>),
}

/// The new numbers of a file.
#[derive(Debug)]
pub(crate) struct Renumbering {
    pub(crate) step: u32,
    /// The replaced places, in the order of the text.
    pub(crate) edits: Vec<(Span, String)>,
    /// Numbers in comments that look like those of blocks: where, the number, and the new one of that block (REN-4).
    pub(crate) mentions: Vec<(u32, u32, u32)>,
}

/// The L word of a jump and the block that it leads to, by the block of the jump.
type Jumps = BTreeMap<BlockId, (Word, BlockId)>;

/// Renumbers the whole file evenly. When ten by ten gives a jump a target that it cannot reach (FLW-5), or a line that
/// is too long (LEX-7), a smaller step is taken. Of a file that was read whole: see [`first_unread`].
///
/// # Errors
/// Why that cannot be done.
pub(crate) fn renumber_evenly(resolved: &Resolved) -> Result<Renumbering, EditText> {
    let mut obstacle = EditText::NumberedAlready;
    for step in STEPS {
        match renumber(resolved, Numbering { start: step, step, width: 0, part: Part::All }) {
            Ok(renumbering) if renumbering.edits.is_empty() => return Err(EditText::NumberedAlready),
            Err(
                why @ (EditText::TargetTooHigh { .. }
                | EditText::TargetTooFar
                | EditText::LineTooLong { .. }
                | EditText::TooManyBlocks),
            ) => {
                obstacle = why;
            }
            result => return result,
        }
    }
    Err(obstacle)
}

/// Renumbers a file, and gives its bytes to `out`, part by part, unless they stay; whether it becomes another one.
///
/// # Errors
/// Why that cannot be done.
pub(crate) fn renumbered(
    path: &Path,
    source: &Arc<SourceText>,
    settings: &Settings,
    numbering: Numbering,
    out: &mut dyn FnMut(&[u8]),
) -> Result<(bool, Renumbering), EditText> {
    let (outcome, resolved) = alone::resolve(path, source, settings);
    if let Some(unread) = first_unread(&outcome) {
        return Err(unread);
    }
    let renumbering = renumber(&resolved, numbering)?;
    let mut out = |text: &str| out(&source.encoding().encode(text));
    let mut output = Output::new(source, &mut out);
    for (span, number) in &renumbering.edits {
        output.write(Written { span: *span, before: number, copied: None, after: "" });
    }
    Ok((output.finish(), renumbering))
}

/// The first line of a file that could not be read: then no number is safe to change (REN-5).
pub(crate) fn first_unread(outcome: &Outcome) -> Option<EditText> {
    let is_unread = |code: Code| code.is_malformed() || matches!(code, Code::E0115 | Code::E0203);
    let unread = outcome.findings.items().iter().filter(|item| item.at.file == FILE && is_unread(item.code()));
    let first = unread.min_by_key(|item| item.at)?;
    let source = outcome.sources.get(FILE)?;
    Some(EditText::Unread { line: source.line_column(first.at.span.start).line, code: first.code() })
}

/// Renumbers the file.
///
/// # Errors
/// Why that cannot be done.
pub(crate) fn renumber(resolved: &Resolved, numbering: Numbering) -> Result<Renumbering, EditText> {
    let Some(file) = resolved.file(FILE).filter(|file| file.block_count() > 0) else {
        return Err(EditText::NoBlocks);
    };
    if let Some(block) = file.block_ids().find(|block| unreadable(file, *block)) {
        return Err(EditText::UnreadableNumber { line: line_of(file, block) });
    }
    let jumps = jumps(resolved, file)?;
    unambiguous(file, &jumps)?;
    let part = blocks_of(resolved, file, numbering.part)?;
    Numbers { file, jumps: &jumps, numbering, part }.renumbering()
}

fn unreadable(file: &ParsedFile, block: BlockId) -> bool {
    file.number(block).is_none() || file.n_word(block).is_none_or(|word| !word.is_plain())
}

fn line_of(file: &ParsedFile, block: BlockId) -> u32 {
    file.source.line_column(file.n_place(block).span.start).line
}

/// The blocks of a part.
fn blocks_of(resolved: &Resolved, file: &ParsedFile, part: Part) -> Result<Range<u32>, EditText> {
    let numbered = |number: u32, from: u32| {
        let mut blocks = (from..file.block_count()).map(BlockId);
        blocks.find(|block| file.number(*block) == Some(number)).ok_or(EditText::NoSuchBlock { number })
    };
    match part {
        Part::All => Ok(0..file.block_count()),
        Part::Unit(l) => {
            let mut units = resolved.units().map(|(_, unit)| unit).filter(|unit| unit.file == FILE);
            let unit = units.find(|unit| unit.kind == UnitKind::Subprogram(Some(l)));
            unit.map(|unit| unit.first.0..unit.end.0).ok_or(EditText::NoSuchUnit { l })
        }
        Part::Blocks(from, to) => {
            let first = from.map_or(Ok(BlockId(0)), |number| numbered(number, 0))?;
            let last = match to {
                Some(to) => match (numbered(to, first.0), from.filter(|_| numbered(to, 0).is_ok())) {
                    (Err(_), Some(from)) => return Err(EditText::PartBackwards { from, to }),
                    (last, _) => last?.next(),
                },
                None => BlockId(file.block_count()),
            };
            Ok(first.0..last.0)
        }
    }
}

/// Every jump, with where it leads: all of that must be known (REN-2).
fn jumps(resolved: &Resolved, file: &ParsedFile) -> Result<Jumps, EditText> {
    let mut jumps = Jumps::new();
    for block in file.block_ids().filter(|block| file.flags(*block).has(BlockFlags::RICH)) {
        let words = file.words(block);
        let Roles { taker, l: Some(l), .. } = Roles::written(words) else { continue };
        let functions = || words.iter().filter(|word| word.address == Address::G);
        // A clash of two calls is no jump.
        if !taker.may_be(GCode::G73) || !functions().any(|word| word.g_code().is_none_or(|code| code == GCode::G73)) {
            continue;
        }
        // A G whose number is not written may turn out to be a jump.
        if let Some(word) = [l].into_iter().chain(functions().copied()).find(|word| word.is_parametric()) {
            let word = file.source.slice(word.span(file.source.text())).to_owned();
            return Err(EditText::JumpByParameter {
                block: file.shown_number(block),
                line: line_of(file, block),
                word,
            });
        }
        let clear = matches!(taker, Taker::One(..)) && l.is_plain() && !functions().any(|word| word.is_faulty());
        let once = words.iter().filter(|word| word.address == Address::L).count() == 1;
        match resolved.target(FILE, block) {
            Some(Target::Block(target)) if clear && once => {
                jumps.insert(block, (l, target));
            }
            Some(_) | None => return Err(EditText::UnclearJump { line: line_of(file, block) }),
        }
    }
    Ok(jumps)
}

/// That no two blocks have the number of a jump's target (REN-5).
fn unambiguous(file: &ParsedFile, jumps: &Jumps) -> Result<(), EditText> {
    let numbers = jumps.values().filter_map(|(_, target)| Some((file.number(*target)?, 0_u32)));
    let mut counts: BTreeMap<u32, u32> = numbers.collect();
    if counts.is_empty() {
        return Ok(());
    }
    for number in file.block_ids().filter_map(|block| file.number(block)) {
        if let Some(count) = counts.get_mut(&number) {
            *count += 1;
            if *count > 1 {
                return Err(EditText::DuplicateTarget { number });
            }
        }
    }
    Ok(())
}

/// The new numbers of a part of a file.
struct Numbers<'a> {
    file: &'a ParsedFile,
    jumps: &'a Jumps,
    numbering: Numbering,
    part: Range<u32>,
}

impl Numbers<'_> {
    fn renumbering(&self) -> Result<Renumbering, EditText> {
        let last = BlockId(self.part.end.saturating_sub(1));
        if self.new_number(last).is_none_or(|number| number > HIGHEST_BLOCK) {
            return Err(EditText::TooManyBlocks);
        }
        self.targets_in_reach()?;
        self.free_outside()?;
        let mut edits = Vec::new();
        let mut replace = |word: Word, number: String| {
            let span = word.parts(self.file.source.text()).value;
            if self.file.source.slice(span) != number {
                edits.push((span, number));
            }
        };
        for block in self.file.block_ids() {
            if let (Some(word), Some(new)) = (self.file.n_word(block), self.new_number(block)) {
                replace(word, format!("{new:0width$}", width = self.numbering.width));
            }
            if let Some((l, target)) = self.jumps.get(&block)
                && let Some(new) = self.new_number(*target)
            {
                replace(*l, new.to_string());
            }
        }
        match first_long_line(self.file, edits.iter().map(|(span, new)| (*span, new.len()))) {
            Some(line) => Err(EditText::LineTooLong { line }),
            None => Ok(Renumbering { step: self.numbering.step, edits, mentions: self.mentions() }),
        }
    }

    /// The number that a block of the part gets; `None` for others, and beyond 32 bits.
    fn new_number(&self, block: BlockId) -> Option<u32> {
        let at = block.0.checked_sub(self.part.start).filter(|_| block.0 < self.part.end)?;
        at.checked_mul(self.numbering.step)?.checked_add(self.numbering.start)
    }

    /// That every jump reaches its target (REN-3).
    fn targets_in_reach(&self) -> Result<(), EditText> {
        let targets = || self.jumps.values().map(|(_, target)| *target);
        if targets().filter_map(|target| self.new_number(target)).all(|number| number <= HIGHEST_L) {
            return Ok(());
        }
        let farthest = targets().filter(|target| self.part.contains(&target.0)).max();
        let places = farthest.map_or(0, |target| target.0 - self.part.start);
        let step = HIGHEST_L.saturating_sub(self.numbering.start).checked_div(places).unwrap_or(0);
        Err(if step > 0 { EditText::TargetTooHigh { step } } else { EditText::TargetTooFar })
    }

    /// That no new number stands outside the part (REN-1).
    fn free_outside(&self) -> Result<(), EditText> {
        let outside = self.file.block_ids().filter(|block| !self.part.contains(&block.0));
        let is_new = |number: &u32| {
            let Some(distance) = number.checked_sub(self.numbering.start) else { return false };
            distance % self.numbering.step == 0 && distance / self.numbering.step < self.part.end - self.part.start
        };
        match outside.filter_map(|block| self.file.number(block)).find(is_new) {
            Some(number) => Err(EditText::NumberTaken { number }),
            None => Ok(()),
        }
    }

    /// The numbers in comments that look like those of blocks and stood for one that has another now (REN-4).
    fn mentions(&self) -> Vec<(u32, u32, u32)> {
        let comments = self.file.all_comments();
        let said: Vec<(u32, u32)> = comments
            .iter()
            .flat_map(|comment| {
                let text = self.file.comment_text(*comment);
                mentioned(text).map(move |(_, number)| (comment.start, number))
            })
            .collect();
        if said.is_empty() {
            return Vec::new();
        }
        let changed = self.file.block_ids().filter_map(|block| {
            let (old, new) = (self.file.number(block)?, self.new_number(block)?);
            (old != new).then_some((old, new))
        });
        let mut new_of = BTreeMap::new();
        for (old, new) in changed {
            new_of.entry(old).or_insert(new);
        }
        let line = |at: u32| self.file.source.line_column(at).line;
        said.into_iter().filter_map(|(at, old)| Some((line(at), old, *new_of.get(&old)?))).collect()
    }
}

/// The numbers in a text that look like those of blocks, and where: `N120`, `blok 120`.
fn mentioned(text: &str) -> impl Iterator<Item = (u32, u32)> + '_ {
    let bytes = text.as_bytes();
    let digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    let starts = (0..bytes.len()).filter(move |&at| digit(at) && at.checked_sub(1).is_none_or(|before| !digit(before)));
    starts.filter_map(move |at| {
        let before = text.get(..at)?;
        let letters = before.trim_end_matches([' ', '\t']);
        let word = letters.rsplit(|letter: char| !letter.is_alphanumeric()).next()?.to_lowercase();
        let block = (word == "n" && letters.len() == before.len()) || word.starts_with("blok") || word == "block";
        let digits = text.get(at..)?.split(|letter: char| !letter.is_ascii_digit()).next()?;
        let number = digits.parse().ok().filter(|_| block)?;
        Some((small(at), number))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// REN-4
    #[test]
    fn numbers_in_comments() {
        let said = |text| mentioned(text).map(|(_, number)| number).collect::<Vec<_>>();
        assert_eq!(said("zpet na N120, n 5, blok 130 a bloku 0140"), [120, 130, 140]);
        assert_eq!(said("HLAVA 63 AN10 R120 N"), [0_u32; 0]);
        assert_eq!(said("see block 7 and N999999999999"), [7]);
    }
}
