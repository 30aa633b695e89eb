//! Where calls and jumps lead, and the findings when they lead nowhere: the same for written numbers and for those that
//! parameters give.

use std::collections::BTreeMap;

use super::units::entry_l;
use super::{Known, Library, MacrocycleFault, Resolved, Unit, UnitId, UnitKind, l_number};
use crate::config::Machine;
use crate::diag::{CenterPlace, Diagnostic, Finding, LabelText, Unmodelled, shown};
use crate::dict::GCode;
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Word};
use crate::text::{FileId, Location};

/// The place of a word's number; the whole word when the number comes from a parameter.
pub fn value_or_word(file: &ParsedFile, word: Word) -> Location {
    if word.is_parametric() { file.word_place(word) } else { file.value_place(word) }
}

/// Two functions of one group in one block (BLK-3): the finding at the second one. `name`: of the first, for a word
/// whose number comes from a parameter.
fn conflict(file: &ParsedFile, first: Word, name: String, second: Word, finding: Finding) -> Diagnostic {
    let there = file.word_place(first);
    let what = if first.is_parametric() { name } else { shown(file.source.slice(there.span)) };
    Diagnostic::new(finding, file.word_place(second)).with_label(there, LabelText::First { what })
}

/// Two G functions of one group in one block.
/// `unnumbered`: the line between them lacks its block number.
pub fn conflicting_g(file: &ParsedFile, first: (GCode, Word), second: (GCode, Word), unnumbered: bool) -> Diagnostic {
    let finding = Finding::ConflictingG { first: first.0, second: second.0, group: second.0.group(), unnumbered };
    conflict(file, first.1, first.0.to_string(), second.1, finding)
}

/// Two M functions of one group in one block.
/// `unnumbered`: the line between them lacks its block number.
pub fn conflicting_m(
    file: &ParsedFile,
    first: (u8, Word),
    second: (u8, Word),
    machine: &Machine,
    unnumbered: bool,
) -> Diagnostic {
    let group = machine.m_functions.group(second.0);
    let finding =
        Finding::ConflictingM { first: first.0, second: second.0, group, dialect: machine.dialect, unnumbered };
    conflict(file, first.1, format!("M{:02}", first.0), second.1, finding)
}

/// The control words that G26–G29 need and the block lacks (PAR-7); `has`: whether it assigns a parameter.
pub fn missing_control_words(function: GCode, has: impl Fn(u8) -> bool) -> Option<Finding> {
    let missing: Vec<String> = (5..)
        .take(function.operations())
        .filter(|parameter| !has(*parameter))
        .map(|parameter| format!("R{parameter}"))
        .collect();
    (!missing.is_empty()).then(|| Finding::MissingControlWord {
        function,
        missing: missing.join(", "),
        reference: false,
    })
}

/// That some of I, J and K have no use in their block (E0609): one finding, at the first of them.
pub fn centers_without_use(words: &[(char, Location)], place: CenterPlace) -> Option<(Finding, Location)> {
    let &(_, at) = words.first()?;
    let letters = words.iter().map(|(letter, _)| *letter).collect();
    Some((Finding::CenterWordNotUsable { letters, place, written: String::new() }, at))
}

/// The block that a jump of `unit` to `l` reaches (FLW-5); a finding is at `at`.
pub fn jump_target(resolved: &Resolved, unit: &Unit, l: u32, at: Location) -> Known<BlockId> {
    match resolved.numbered(unit.file, l) {
        Some(block) if unit.contains(block) => Known::Yes(block),
        Some(block) => {
            let there = resolved.file(unit.file).map(|file| file.n_place(block)).unwrap_or_default();
            let label = LabelText::BlockHere { block: l };
            Known::No(Box::new(Diagnostic::new(Finding::JumpOutOfUnit { l }, at).with_label(there, label)))
        }
        None if resolved.may_have_block(unit, l) => Known::Unknown,
        None if second_program(resolved, unit.file, |file, block| file.number(block) == Some(l)) => Known::Unknown,
        None => {
            let near = resolved.nearest_block(unit, l);
            let subprogram = resolved.subprogram(l).is_some() && !matches!(unit.kind, UnitKind::Macrocycle(_));
            let wrong = resolved.misnumbered_block(unit, l).filter(|_| !subprogram);
            let near = near.filter(|_| !subprogram && wrong.is_none());
            let finding = Finding::UnknownJumpTarget { l, near, line: None, subprogram, wrong };
            Known::No(Box::new(Diagnostic::new(finding, at)))
        }
    }
}

/// The subprogram that a G71 of a unit calls (FLW-1); a finding is at `at`. Of calls to subprograms behind the `*` of
/// the program the first has a finding, which says what the `*` cuts off.
pub fn subprogram(
    resolved: &mut Resolved,
    library: &mut Library<'_>,
    from: &Unit,
    l: u32,
    at: Location,
) -> Known<UnitId> {
    let from_macrocycle = matches!(from.kind, UnitKind::Macrocycle(_));
    match resolved.subprogram(l) {
        Some(unit) if !from_macrocycle => return Known::Yes(unit),
        None if !from_macrocycle && resolved.nameless_subprogram => return Known::Unknown,
        None if second_program(resolved, from.file, |file, block| is_entry(file, block, l)) => return Known::Unknown,
        Some(_) | None => {}
    }
    // A macrocycle that calls itself would be a ring.
    let macrocycle = from.kind != UnitKind::Macrocycle(l) && (library.find(l).is_ok() || library.is_of_machine(l));
    let program = FileId(0);
    let star = resolved.star(program).filter(|_| !from_macrocycle && !macrocycle);
    let hidden = star.zip(resolved.file(program)).and_then(|(star, file)| Some((star.at, star.entry(file, l)?)));
    let own = match from.kind {
        UnitKind::Subprogram(own) => own,
        UnitKind::Main | UnitKind::Macrocycle(_) => None,
    };
    let near = resolved.nearest_subprogram(l, own).filter(|_| hidden.is_none());
    let own_block = resolved.file(from.file).and_then(|file| file.number(file.block_at(at.span.start)?));
    let block = own_block != Some(l) && has_block(resolved, from, l);
    let (star, unread) = hidden.unzip();
    let (without_entry, uncalled) = (None, None);
    let finding =
        Finding::UnknownSubprogram { l, near, macrocycle, from_macrocycle, without_entry, uncalled, unread, block };
    let diagnostic = Diagnostic::new(finding, at);
    match star {
        Some(star) if resolved.told_of_star.insert(program) => {
            Known::No(Box::new(diagnostic.with_label(star, LabelText::FileEnds)))
        }
        Some(_) => Known::Unknown,
        None => Known::No(Box::new(diagnostic)),
    }
}

/// Whether a block behind a second `%` (E0202) is such: the `%` may be what is wrong.
fn second_program(resolved: &Resolved, file: FileId, is: impl Fn(&ParsedFile, BlockId) -> bool) -> bool {
    let Some(file) = resolved.file(file).filter(|file| file.second_program.is_some()) else { return false };
    (file.program_end().0..file.block_count()).any(|block| is(file, BlockId(block)))
}

/// Whether a block begins subprogram `l`.
fn is_entry(file: &ParsedFile, block: BlockId, l: u32) -> bool {
    file.flags(block).has(BlockFlags::ENTRY) && entry_l(file, block).and_then(l_number) == Some(l)
}

/// Whether a block of the unit has that number: a jump was meant, perhaps.
pub fn has_block(resolved: &Resolved, unit: &Unit, l: u32) -> bool {
    resolved.numbered(unit.file, l).is_some_and(|block| unit.contains(block))
}

/// Other things with the number of a macrocycle that is missing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Namesake {
    /// A subprogram of the program.
    pub subprogram: bool,
    /// A block of the calling unit.
    pub block: bool,
}

/// The finding at the first of `calls` calls of a macrocycle that cannot be loaded.
pub fn macrocycle_finding(fault: MacrocycleFault, l: u32, namesake: Namesake, calls: usize) -> Finding {
    let Namesake { subprogram, block } = namesake;
    match fault {
        MacrocycleFault::OfMachine { axes_named } => {
            Finding::FunctionNotModelled { what: Unmodelled::Macrocycles(BTreeMap::from([(l, axes_named)])) }
        }
        MacrocycleFault::Missing { searched, near } => {
            Finding::UnknownMacrocycle { l, searched, subprogram, calls, near, block }
        }
        MacrocycleFault::Ambiguous { first, second } => Finding::DuplicateMacrocycle { l, first, second },
        MacrocycleFault::Unreadable { file, problem } => Finding::UnreadableFile { problem, file: Some(file) },
    }
}
