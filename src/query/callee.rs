//! The target of a call: its comments, and the parameters that it takes.

use super::extents::comments_above;
use super::names::{Name, Names, Usage};
use super::sections::heading;
use crate::dict::{Address, TOOL_CHANGE};
use crate::resolve::{Unit, UnitKind};
use crate::syntax::{BlockId, ParsedFile};

/// Most lines of comments that are shown.
const LINES: usize = 12;
/// Blocks behind that of T in which its M06 is looked for.
const CHANGE: u32 = 4;

/// The comments that describe a unit: those at the head of a macrocycle's file, those above the first block of a
/// subprogram, beside and below it.
pub(crate) fn about<'f>(file: &'f ParsedFile, unit: &Unit) -> Vec<&'f str> {
    let above = match unit.kind {
        UnitKind::Macrocycle(_) => file.comments_before_blocks(),
        UnitKind::Main | UnitKind::Subprogram(_) => comments_above(file, unit.first),
    };
    let behind = file.comments_behind(unit.first).iter().filter(|_| unit.kind != UnitKind::Main);
    above.iter().chain(behind).filter_map(|comment| heading(file, *comment)).take(LINES).collect()
}

/// The parameters that a unit reads before it gives them a value, its blocks taken in the order in which they are
/// written.
pub(crate) fn inputs(names: &Names<'_>, unit: &Unit) -> Vec<u8> {
    let mut assigned = Vec::new();
    let mut inputs = Vec::new();
    for block in unit.blocks() {
        let mut named = names.of_block(block, |name| matches!(name, Name::Parameter(_)));
        // Words are read before they assign anything; operations see the results of those before (PAR-7).
        named.sort_by_key(|naming| (naming.is_operand(), !naming.is_operand() && naming.usage == Usage::Write));
        for naming in named {
            let Name::Parameter(index) = naming.name else { continue };
            match naming.usage {
                Usage::Read if !assigned.contains(&index) && !inputs.contains(&index) => inputs.push(index),
                Usage::Write => assigned.push(index),
                Usage::Read | Usage::Definition | Usage::Call => {}
            }
        }
    }
    inputs.sort_unstable();
    inputs
}

/// The program's name of a tool: the comment in the line of its T, or of the M06 behind it.
pub(crate) fn tool(file: &ParsedFile, number: i64) -> Option<&str> {
    let chooses = |block: &BlockId| {
        file.words(*block).iter().any(|word| word.address == Address::T && word.whole() == Some(number))
    };
    let beside = |block: BlockId| {
        let text = file.source.text();
        let comments = file.comments_behind(block).iter();
        comments.filter(|comment| !super::extents::stands_alone(text, **comment)).find_map(|c| heading(file, *c))
    };
    let changes = |block: &BlockId| file.words(*block).iter().any(|word| word.is_m(TOOL_CHANGE));
    file.block_ids().filter(chooses).find_map(|block| {
        let behind = || (block.0 + 1..=block.0 + CHANGE).map(BlockId).find(changes).and_then(beside);
        beside(block).or_else(behind)
    })
}
