//! Programs in files that are named as macrocycles are (PRG-6).

use std::sync::Arc;

use super::load::Context;
use super::{Points, Resolved, Unit, UnitId, UnitKind};
use crate::diag::{Diagnostic, Finding, Findings};
use crate::sure::small;
use crate::syntax::{BlockFlags, BlockId, Form, ParsedFile, parse};
use crate::text::{FileId, SourceText};

/// Whether a file that is named as a macrocycle is a program: it begins with `%`, not with G79, and holds M02 or M30.
pub fn is_program(source: &Arc<SourceText>) -> bool {
    begins_as_program(source) && is_program_inside(&parse(FileId(0), source, Form::Macrocycle, &mut Findings::new()))
}

/// Whether a file begins with a G79, as a macrocycle does.
pub fn begins_macrocycle(source: &Arc<SourceText>) -> bool {
    let parsed = parse(FileId(0), source, Form::Macrocycle, &mut Findings::new());
    begins_with_entry(&parsed)
}

/// W0222: the name of the program's file is that of a macrocycle.
pub fn report_misnamed(resolved: &Resolved, l: u32, findings: &mut Findings) {
    let file = resolved.main().and_then(|_| resolved.file(FileId(0)));
    if let Some((file, word)) = file.and_then(|file| Some((file, file.program?))) {
        findings.add(Diagnostic::new(Finding::ProgramNamedAsMacrocycle { l }, file.word_place(word)));
    }
}

/// Whether the first sign behind comments and blanks is `%`.
fn begins_as_program(source: &SourceText) -> bool {
    let text = source.text().get(source.first_offset() as usize..).unwrap_or_default();
    let first = text.lines().map(str::trim_start).find(|line| !line.is_empty() && !line.starts_with('"'));
    first.is_some_and(|line| line.starts_with('%'))
}

fn is_program_inside(parsed: &ParsedFile) -> bool {
    let ends = |block: BlockId| parsed.flags(block).has(BlockFlags::END);
    parsed.block_count() > 0 && !begins_with_entry(parsed) && parsed.block_ids().any(ends)
}

fn begins_with_entry(parsed: &ParsedFile) -> bool {
    parsed.block_count() > 0 && parsed.flags(BlockId(0)).has(BlockFlags::ENTRY)
}

impl Context<'_, '_> {
    /// Whether a file that a G72 calls, parsed as a macrocycle, is a program.
    pub(super) fn is_program(parsed: &ParsedFile) -> bool {
        begins_as_program(&parsed.source) && is_program_inside(parsed)
    }

    /// A program in place of a macrocycle: one E0216, and a unit that nothing is known of.
    pub(super) fn add_misnamed(&mut self, resolved: &mut Resolved, parsed: ParsedFile, l: u32) -> UnitId {
        let first = BlockId(0);
        let entry = parsed.n_place(first);
        let file = parsed.source.name().to_owned();
        let finding = Finding::MacrocycleNumberMismatch { file, expected: l, found: None };
        self.findings.add(Diagnostic::new(finding, entry));
        let file = FileId(small(resolved.files.len()));
        let id = resolved.add_unit(Unit { kind: UnitKind::Macrocycle(l), file, first, end: first, entry });
        resolved.macrocycles.insert(l, id);
        resolved.add_file(parsed, None, Vec::new(), Points::default());
        id
    }
}
