//! New numbers for the blocks of a file: N10, N20, and so on through all its units, with the jumps rewritten.
//!
//! `%` and the L of calls and subprograms stay. When ten by ten gives a jump a target that it cannot reach (FLW-5), or a
//! line that is too long (LEX-7), a smaller step is taken. Duplicate numbers are corrected, unless a jump leads to one.

use std::collections::BTreeMap;

use super::edit_texts::EditText;
use super::line_length::first_long_line;
use crate::dict::{Address, GCode, HIGHEST_BLOCK, HIGHEST_L};
use crate::query::analysis::Analysis;
use crate::query::cursor::DOCUMENT;
use crate::resolve::{Roles, Taker, Target};
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Word};
use crate::text::Span;

/// Distances of numbers, the usual one first.
const STEPS: [u32; 4] = [10, 5, 2, 1];

/// The new numbers of a file.
#[derive(Debug)]
pub(crate) struct Renumbering {
    pub(crate) step: u32,
    /// What is replaced, in the order of the text.
    pub(crate) edits: Vec<(Span, String)>,
}

/// The L word of a jump and the block that it leads to, by the block of the jump.
type Jumps = BTreeMap<BlockId, (Word, BlockId)>;

/// Renumbers the document.
///
/// # Errors
/// Why that cannot be done.
pub(crate) fn renumber(analysis: &Analysis) -> Result<Renumbering, EditText> {
    let Some(file) = analysis.resolved.file(DOCUMENT).filter(|file| file.block_count() > 0) else {
        return Err(EditText::NoBlocks);
    };
    if let Some(block) = file.block_ids().find(|block| unreadable(file, *block)) {
        return Err(EditText::UnreadableNumber { line: line_of(file, block) });
    }
    let jumps = jumps(analysis, file)?;
    unambiguous(file, &jumps)?;
    let mut obstacle = EditText::NumberedAlready;
    for step in STEPS {
        match numbered(file, &jumps, step) {
            Ok(edits) if edits.is_empty() => return Err(EditText::NumberedAlready),
            Ok(edits) => return Ok(Renumbering { step, edits }),
            Err(why) => obstacle = why,
        }
    }
    Err(obstacle)
}

fn unreadable(file: &ParsedFile, block: BlockId) -> bool {
    file.number(block).is_none() || file.n_word(block).is_none_or(|word| !word.is_plain())
}

fn line_of(file: &ParsedFile, block: BlockId) -> u32 {
    file.source.line_column(file.n_place(block).span.start).line
}

/// Every jump, with where it leads: all of that must be known.
fn jumps(analysis: &Analysis, file: &ParsedFile) -> Result<Jumps, EditText> {
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
        if l.is_parametric() || functions().any(|word| word.is_parametric()) {
            return Err(EditText::JumpByParameter { line: line_of(file, block) });
        }
        let clear = matches!(taker, Taker::One(..)) && l.is_plain() && !functions().any(|word| word.is_faulty());
        let once = words.iter().filter(|word| word.address == Address::L).count() == 1;
        match analysis.resolved.target(DOCUMENT, block) {
            Some(Target::Block(target)) if clear && once => {
                jumps.insert(block, (l, target));
            }
            Some(_) | None => return Err(EditText::UnclearJump { line: line_of(file, block) }),
        }
    }
    Ok(jumps)
}

/// That no two blocks have the number of a jump's target.
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

/// The edits that give the blocks numbers of that distance.
fn numbered(file: &ParsedFile, jumps: &Jumps, step: u32) -> Result<Vec<(Span, String)>, EditText> {
    let number = |block: BlockId| block.0.checked_add(1)?.checked_mul(step).filter(|number| *number <= HIGHEST_BLOCK);
    if number(BlockId(file.block_count() - 1)).is_none() {
        return Err(EditText::TooManyBlocks);
    }
    let text = file.source.text();
    let mut edits = Vec::new();
    let mut replace = |word: Word, number: u32| {
        let (span, number) = (word.parts(text).value, number.to_string());
        if file.source.slice(span) != number {
            edits.push((span, number));
        }
    };
    for block in file.block_ids() {
        let (Some(word), Some(new)) = (file.n_word(block), number(block)) else { return Err(EditText::TooManyBlocks) };
        replace(word, new);
        if let Some((l, target)) = jumps.get(&block) {
            let Some(target) = number(*target).filter(|target| *target <= HIGHEST_L) else {
                return Err(EditText::TargetTooHigh);
            };
            replace(*l, target);
        }
    }
    match first_long_line(file, edits.iter().map(|(span, new)| (*span, new.len()))) {
        Some(line) => Err(EditText::LineTooLong { line }),
        None => Ok(edits),
    }
}
