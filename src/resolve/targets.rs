//! Where calls and jumps lead, and what is said when they lead nowhere: the same for numbers that are written and for those
//! that parameters give.

use std::collections::BTreeSet;

use super::{Library, MacrocycleFault, Resolved, Unit, UnitId, UnitKind};
use crate::config::Machine;
use crate::diag::{Diagnostic, Finding, Findings, LabelText, Unmodelled, shown};
use crate::dict::GCode;
use crate::syntax::{BlockId, ParsedFile, Word};
use crate::text::Location;

/// The number of a word; the whole word when a parameter stands for it.
pub fn value_or_word(file: &ParsedFile, word: Word) -> Location {
    if word.is_parametric() { file.word_place(word) } else { file.value_place(word) }
}

/// Two functions of one group in one block (BLK-3): the finding at the second one. `name`: of the first, for a word whose
/// number comes from a parameter.
fn conflict(file: &ParsedFile, first: Word, name: String, second: Word, finding: Finding) -> Diagnostic {
    let there = file.word_place(first);
    let what = if first.is_parametric() { name } else { shown(file.source.slice(there.span)) };
    Diagnostic::new(finding, file.word_place(second)).with_label(there, LabelText::First { what })
}

/// Two G functions of one group in one block.
pub fn conflicting_g(file: &ParsedFile, first: (GCode, Word), second: (GCode, Word)) -> Diagnostic {
    let finding =
        Finding::ConflictingG { first: first.0, second: second.0, group: second.0.group(), unnumbered: false };
    conflict(file, first.1, first.0.to_string(), second.1, finding)
}

/// Two M functions of one group in one block.
pub fn conflicting_m(file: &ParsedFile, first: (u8, Word), second: (u8, Word), machine: &Machine) -> Diagnostic {
    let group = machine.m_functions.group(second.0);
    let finding =
        Finding::ConflictingM { first: first.0, second: second.0, group, dialect: machine.dialect, unnumbered: false };
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

/// The block that a jump of `unit` to `l` reaches (FLW-5).
///
/// # Errors
/// Why there is none, at `at`; nothing when it may be a block whose number cannot be read, which has its finding.
pub fn jump_target(resolved: &Resolved, unit: &Unit, l: u32, at: Location) -> Result<BlockId, Option<Box<Diagnostic>>> {
    match resolved.numbered(unit.file, l) {
        Some(block) if unit.contains(block) => Ok(block),
        Some(block) => {
            let there = resolved.file(unit.file).map(|file| file.n_place(block)).unwrap_or_default();
            let label = LabelText::BlockHere { block: l };
            Err(Some(Box::new(Diagnostic::new(Finding::JumpOutOfUnit { l }, at).with_label(there, label))))
        }
        None if resolved.may_have_block(unit, l) => Err(None),
        None => {
            let near = resolved.nearest_block(unit, l);
            let subprogram = resolved.subprogram(l).is_some() && !matches!(unit.kind, UnitKind::Macrocycle(_));
            let near = near.filter(|_| !subprogram);
            Err(Some(Box::new(Diagnostic::new(Finding::UnknownJumpTarget { l, near, line: None, subprogram }, at))))
        }
    }
}

/// The subprogram that a G71 of a unit calls (FLW-1).
///
/// # Errors
/// Why there is none, at `at`.
pub fn subprogram(
    resolved: &Resolved,
    library: &mut Library<'_>,
    from: &Unit,
    l: u32,
    at: Location,
) -> Result<UnitId, Box<Diagnostic>> {
    let from_macrocycle = matches!(from.kind, UnitKind::Macrocycle(_));
    if let (Some(unit), false) = (resolved.subprogram(l), from_macrocycle) {
        return Ok(unit);
    }
    let near = resolved.nearest_subprogram(l);
    let macrocycle = library.find(l).is_ok() || library.is_of_machine(l);
    let (without_entry, uncalled, unread) = (None, None, None);
    let block = has_block(resolved, from, l);
    let finding =
        Finding::UnknownSubprogram { l, near, macrocycle, from_macrocycle, without_entry, uncalled, unread, block };
    Err(Box::new(Diagnostic::new(finding, at)))
}

/// Whether a block of the unit has that number: a jump was meant, perhaps.
pub fn has_block(resolved: &Resolved, unit: &Unit, l: u32) -> bool {
    resolved.numbered(unit.file, l).is_some_and(|block| unit.contains(block))
}

/// What else has the number of a macrocycle that is missing.
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
        MacrocycleFault::OfMachine => of_machine(l),
        MacrocycleFault::Missing { searched, near } => {
            Finding::UnknownMacrocycle { l, searched, subprogram, calls, near, block }
        }
        MacrocycleFault::Ambiguous { first, second } => Finding::DuplicateMacrocycle { l, first, second },
        MacrocycleFault::Unreadable { file, problem } => Finding::UnreadableFile { problem, file: Some(file) },
    }
}

/// W0612 of a macrocycle that only the machine has (FLW-12).
fn of_machine(l: u32) -> Finding {
    Finding::FunctionNotModelled { what: Unmodelled::Macrocycles(BTreeSet::from([l])) }
}

/// Reports a macrocycle that only the machine has, at a call: a program has one such finding, at its first call, which names
/// all of them (FLW-12).
pub fn report_of_machine(findings: &mut Findings, l: u32, call: Diagnostic) {
    let mut known = None;
    for found in findings.items() {
        if let Finding::FunctionNotModelled { what: Unmodelled::Macrocycles(numbers) } = &found.finding {
            known = Some(numbers.contains(&l));
        }
    }
    match known {
        None => findings.add(call),
        Some(true) => {}
        Some(false) => findings.revise(|found| {
            if let Finding::FunctionNotModelled { what: Unmodelled::Macrocycles(numbers) } = &mut found.finding {
                numbers.insert(l);
            }
            true
        }),
    }
}
