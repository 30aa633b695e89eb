//! Splits files into units: the main program, its subprograms, a macrocycle (§5).

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use rayon::prelude::*;

use super::blocks::{BlockChecker, g_code};
use super::foreign::Origin;
use super::{Library, MacrocycleFault, Resolved, Unit, UnitId, UnitKind, flow, rings};
use crate::config::{Machine, Settings};
use crate::diag::{Diagnostic, Finding, Findings, LabelText};
use crate::dict::{Address, Decimal, GCode};
use crate::syntax::{BlockFlags, BlockId, Form, ParsedFile, Word, parse};
use crate::text::{FileId, Location, SourceText, Sources, Span};

/// Most subprograms of a file (PRG-4).
const SUBPROGRAMS: usize = 99;
/// Longer files are checked in parts of so many blocks, on all cores.
const SIDE_BY_SIDE: u32 = 1 << 14;
/// Jumps and calls reach numbers of four digits (FLW-5).
const REACHABLE: u32 = 9999;

/// What resolving works with.
pub(super) struct Context<'a, 'l> {
    pub(super) settings: &'a Settings,
    pub(super) library: &'a mut Library<'l>,
    pub(super) sources: &'a mut Sources,
    pub(super) findings: &'a mut Findings,
}

/// Resolves the program in `source`, and the macrocycles that its written calls lead to.
pub fn resolve_program(
    source: &Arc<SourceText>,
    settings: &Settings,
    library: &mut Library<'_>,
    sources: &mut Sources,
    findings: &mut Findings,
) -> Resolved {
    let file = sources.add(Arc::clone(source));
    let parsed = parse(file, source, Form::Program, findings);
    let origin = Origin::of(&parsed);
    let mut resolved = Resolved::default();
    let mut context = Context { settings, library, sources, findings };
    if let Some(word) = parsed.program {
        let mut checker = BlockChecker { settings, file: &parsed, findings: context.findings };
        checker.check_program_word(word);
        context.add_program(&mut resolved, parsed);
        flow::follow_calls(&mut context, &mut resolved);
        flow::check_unused(&mut context, &resolved);
        rings::check(&mut context, &resolved);
    }
    origin.point_out(settings, findings);
    resolved
}

/// Resolves the macrocycle in `source`, whose file is named after number `l`, and those that it calls.
pub fn resolve_macrocycle(
    source: &Arc<SourceText>,
    l: u32,
    settings: &Settings,
    library: &mut Library<'_>,
    sources: &mut Sources,
    findings: &mut Findings,
) -> Resolved {
    let file = sources.add(Arc::clone(source));
    let parsed = parse(file, source, Form::Macrocycle, findings);
    let origin = Origin::of(&parsed);
    let mut resolved = Resolved::default();
    let mut context = Context { settings, library, sources, findings };
    context.add_macrocycle(&mut resolved, parsed, l);
    flow::follow_calls(&mut context, &mut resolved);
    rings::check(&mut context, &resolved);
    origin.point_out(settings, findings);
    resolved
}

impl Resolved {
    /// The unit of macrocycle `l`, loaded and resolved when it was not before: for calls whose number comes from a
    /// parameter or the cycle map.
    ///
    /// # Errors
    /// Why there is no such macrocycle.
    pub fn load_macrocycle(
        &mut self,
        l: u32,
        settings: &Settings,
        library: &mut Library<'_>,
        sources: &mut Sources,
        findings: &mut Findings,
    ) -> Result<UnitId, MacrocycleFault> {
        let mut context = Context { settings, library, sources, findings };
        let known = self.units.len();
        let unit = context.macrocycle(self, l)?;
        if self.units.len() > known {
            flow::follow_calls(&mut context, self);
        }
        Ok(unit)
    }
}

impl Context<'_, '_> {
    /// The unit of macrocycle `l`; its own calls are not followed yet.
    pub(super) fn macrocycle(&mut self, resolved: &mut Resolved, l: u32) -> Result<UnitId, MacrocycleFault> {
        if let Some(&id) = resolved.macrocycles.get(&l) {
            return Ok(id);
        }
        let path = self.library.find(l)?;
        let source = self.library.load(&path, &display_name(&path), self.settings.encoding)?;
        let file = self.sources.add(Arc::clone(&source));
        let parsed = parse(file, &source, Form::Macrocycle, self.findings);
        Ok(self.add_macrocycle(resolved, parsed, l))
    }

    fn report(&mut self, at: Location, finding: Finding) {
        self.findings.add(Diagnostic::new(finding, at));
    }

    /// Splits a program into its main program and subprograms, and checks every block (PRG-2…PRG-5).
    fn add_program(&mut self, resolved: &mut Resolved, parsed: ParsedFile) {
        let program = parsed.program.map_or(Location::default(), |word| parsed.word_place(word));
        let file = FileId(0);
        let main_end = parsed
            .block_ids()
            .find_map(|block| match parsed.flags(block) {
                flags if flags.has(BlockFlags::ENTRY) => Some((block, false)),
                flags if flags.has(BlockFlags::END) => Some((block.next(), true)),
                _ => None,
            })
            .unwrap_or((BlockId(parsed.block_count()), false));
        let (end, ended) = main_end;
        let first = BlockId(0);
        resolved.add_unit(Unit { kind: UnitKind::Main, file, first, end, entry: program });
        // Words without any block are one error already (BLK-2).
        let no_block = parsed.block_count() == 0 && parsed.words_outside;
        if !ended && !no_block {
            let place = if end == first { program } else { parsed.n_place(BlockId(end.0 - 1)) };
            self.report(place, Finding::MissingProgramEnd { skipped: false });
        }
        self.add_subprograms(resolved, &parsed, end);
        let (found, numbered) = look_at_blocks(self.settings, &parsed, &resolved.units);
        self.findings.append(found);
        self.check_ends_in_main(&parsed, first, end);
        self.findings.append(numbered.findings);
        resolved.add_file(parsed, numbered.reachable);
    }

    fn add_subprograms(&mut self, resolved: &mut Resolved, parsed: &ParsedFile, from: BlockId) {
        let mut block = from;
        let mut stray = false;
        let mut count = 0;
        let mut first_of: BTreeMap<u32, Word> = BTreeMap::new();
        while block.0 < parsed.block_count() {
            if !parsed.flags(block).has(BlockFlags::ENTRY) {
                if !stray {
                    let finding = Finding::BlockAfterProgramEnd { block: parsed.shown_number(block) };
                    self.report(parsed.n_place(block), finding);
                }
                stray = true;
                block = block.next();
                continue;
            }
            stray = false;
            count += 1;
            let entry = entry_place(parsed, block);
            let (end, ended) = unit_end(parsed, block);
            if !ended {
                self.report(entry, Finding::UnterminatedSubprogram { macrocycle: false, skipped: false });
            }
            if count == SUBPROGRAMS + 1 {
                self.report(entry, Finding::TooManySubprograms {});
            }
            self.check_entry(parsed, block);
            let l_word = entry_l(parsed, block);
            let l = l_word.and_then(l_number);
            let kind = UnitKind::Subprogram(l);
            let id = resolved.add_unit(Unit { kind, file: FileId(0), first: block, end, entry });
            if let (Some(word), Some(l)) = (l_word, l) {
                match first_of.get(&l) {
                    None => {
                        first_of.insert(l, word);
                        resolved.subprograms.insert(l, id);
                    }
                    Some(first) => {
                        let diagnostic = Diagnostic::new(Finding::DuplicateSubprogram { l }, parsed.word_place(word));
                        let label = parsed.word_place(*first);
                        self.findings.add(diagnostic.with_label(label, LabelText::First));
                    }
                }
            }
            block = end;
        }
    }

    /// A macrocycle file has the form of one subprogram (PRG-7).
    fn add_macrocycle(&mut self, resolved: &mut Resolved, parsed: ParsedFile, l: u32) -> UnitId {
        let first = BlockId(0);
        let begins = parsed.flags(first).has(BlockFlags::ENTRY);
        let empty = parsed.block_count() == 0;
        let entry = if begins {
            entry_place(&parsed, first)
        } else if empty {
            parsed.at(Span::empty(parsed.start))
        } else {
            parsed.n_place(first)
        };
        let (end, ended) = unit_end(&parsed, first);
        let name = parsed.source.name().to_owned();
        if begins {
            self.check_entry(&parsed, first);
            if let Some(word) = entry_l(&parsed, first)
                && let Some(found) = l_number(word).filter(|found| *found != l)
            {
                let finding = Finding::MacrocycleNumberMismatch { file: name, expected: l, found: Some(found) };
                self.report(parsed.value_place(word), finding);
            }
        } else if !empty {
            let finding = Finding::MacrocycleNumberMismatch { file: name, expected: l, found: None };
            self.report(entry, finding);
        }
        if !ended && (begins || empty) {
            self.report(entry, Finding::UnterminatedSubprogram { macrocycle: true, skipped: false });
        }
        if end.0 < parsed.block_count() {
            let finding = Finding::BlockAfterMacrocycleEnd { block: parsed.shown_number(end) };
            self.report(parsed.n_place(end), finding);
        }
        let file = FileId(u32::try_from(resolved.files.len()).unwrap_or(u32::MAX));
        let known = resolved.units.len();
        let id = resolved.add_unit(Unit { kind: UnitKind::Macrocycle(l), file, first, end, entry });
        resolved.macrocycles.insert(l, id);
        let (found, numbered) = look_at_blocks(self.settings, &parsed, resolved.units.get(known..).unwrap_or_default());
        self.findings.append(found);
        self.findings.append(numbered.findings);
        resolved.add_file(parsed, numbered.reachable);
        id
    }

    /// G70 ends subprograms only (PRG-5).
    fn check_ends_in_main(&mut self, parsed: &ParsedFile, first: BlockId, end: BlockId) {
        for block in (first.0..end.0).map(BlockId) {
            if parsed.flags(block).has(BlockFlags::RETURN)
                && let Some(&word) = parsed.words(block).iter().find(|word| g_code(**word) == Some(GCode::G70))
            {
                self.report(parsed.word_place(word), Finding::EndOutsideSubprogram {});
            }
        }
    }

    /// Nothing but `N`, G79 and L stands in the block that begins a unit (PRG-3).
    fn check_entry(&mut self, parsed: &ParsedFile, block: BlockId) {
        for &word in parsed.words(block) {
            // A function of the same group, or a second L, is a finding of its own already.
            let of_group = g_code(word).is_some_and(|code| code.group() == GCode::G79.group());
            if !of_group && word.address != Address::L && !word.is_faulty() {
                let place = parsed.word_place(word);
                let shown = crate::diag::shown(parsed.source.slice(place.span));
                self.report(place, Finding::CrowdedSubprogramStart { word: shown });
                return;
            }
        }
    }
}

/// Checks every block of a file whose units are those, also blocks of no unit, and numbers them. Both look at all of a
/// file: the one beside the other in a long one.
fn look_at_blocks(settings: &Settings, parsed: &ParsedFile, units: &[Unit]) -> (Findings, Numbered) {
    let check = || check_blocks(settings, parsed, units);
    let number = || number_blocks(parsed);
    if parsed.block_count() > SIDE_BY_SIDE { rayon::join(check, number) } else { (check(), number()) }
}

fn check_blocks(settings: &Settings, parsed: &ParsedFile, units: &[Unit]) -> Findings {
    let check = |blocks: Range<u32>| {
        let mut findings = Findings::new();
        let mut checker = BlockChecker { settings, file: parsed, findings: &mut findings };
        let mut units = units.iter().peekable();
        for block in blocks.map(BlockId) {
            while units.next_if(|unit| unit.end <= block).is_some() {}
            let unit = units.peek().filter(|unit| unit.contains(block)).map(|unit| unit.kind);
            checker.check(block, unit);
        }
        findings
    };
    let count = parsed.block_count();
    if count <= SIDE_BY_SIDE {
        return check(0..count);
    }
    let parts = count.div_ceil(SIDE_BY_SIDE);
    let part = |part: u32| part * SIDE_BY_SIDE..count.min((part + 1) * SIDE_BY_SIDE);
    let found: Vec<Findings> = (0..parts).into_par_iter().map(|at| check(part(at))).collect();
    let mut findings = Findings::new();
    found.into_iter().for_each(|part| findings.append(part));
    findings
}

/// What the numbers of a file's blocks lead to.
struct Numbered {
    /// Numbers that stand twice (BLK-7).
    findings: Findings,
    /// The first block of each number that jumps can reach, by number.
    reachable: Vec<(u32, BlockId)>,
}

fn number_blocks(parsed: &ParsedFile) -> Numbered {
    let mut numbered = Numbered { findings: Findings::new(), reachable: Vec::new() };
    let mut rising = true;
    let mut last = 0;
    for block in parsed.block_ids() {
        let Some(number) = parsed.number(block) else { continue };
        rising &= number > last;
        last = number;
        if number <= REACHABLE {
            numbered.reachable.push((number, block));
        }
    }
    if rising {
        return numbered;
    }
    numbered.reachable.sort_unstable();
    numbered.reachable.dedup_by_key(|(number, _)| *number);
    let mut all: Vec<(u32, BlockId)> =
        parsed.block_ids().filter_map(|block| Some((parsed.number(block)?, block))).collect();
    all.sort_unstable();
    let mut first: Option<(u32, BlockId)> = None;
    for (number, block) in all {
        match first {
            Some((known, first)) if known == number => {
                let finding = Finding::DuplicateBlockNumber { block: number };
                let diagnostic = Diagnostic::new(finding, parsed.n_place(block));
                numbered.findings.add(diagnostic.with_label(parsed.n_place(first), LabelText::First));
            }
            _ => first = Some((number, block)),
        }
    }
    numbered
}

/// Where a unit that begins at `first` ends: after its first G70, before the next G79, or with the file; and whether it
/// has its G70.
fn unit_end(parsed: &ParsedFile, first: BlockId) -> (BlockId, bool) {
    for block in (first.0..parsed.block_count()).map(BlockId) {
        let flags = parsed.flags(block);
        if block != first && flags.has(BlockFlags::ENTRY) {
            return (block, false);
        }
        if flags.has(BlockFlags::RETURN) {
            return (block.next(), true);
        }
    }
    (BlockId(parsed.block_count()), false)
}

fn entry_place(parsed: &ParsedFile, block: BlockId) -> Location {
    parsed
        .words(block)
        .iter()
        .find(|word| g_code(**word) == Some(GCode::G79))
        .map_or_else(|| parsed.n_place(block), |word| parsed.word_place(*word))
}

fn entry_l(parsed: &ParsedFile, block: BlockId) -> Option<Word> {
    parsed.words(block).iter().copied().find(|word| word.address == Address::L)
}

/// The number that an L word writes out, when it is in range.
pub fn l_number(word: Word) -> Option<u32> {
    let number = word.whole().and_then(|number| u32::try_from(number).ok())?;
    (1..=REACHABLE).contains(&number).then_some(number)
}

fn display_name(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

/// A control word taken apart (PAR-8).
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct ControlWord {
    /// The operation.
    pub operation: crate::dict::Operation,
    /// The parameter that is the first operand.
    pub first: u8,
    /// The one that is the second, when the operation has two.
    pub second: Option<u8>,
    /// The one that takes the result.
    pub result: u8,
    /// `-`: whole-number arithmetic.
    pub whole: bool,
}

/// Takes a control word apart (PAR-8, PAR-9).
///
/// # Errors
/// What is wrong with it: its form, its operation, its fields, in this order.
pub fn control_word(machine: &Machine, value: Decimal) -> Result<ControlWord, Finding> {
    let whole = value.as_whole().filter(|whole| whole.abs() <= 99_999_999);
    let Some(whole) = whole else { return Err(Finding::MalformedControlWord { field: None }) };
    let digits = whole.abs();
    let operation_code = digits / 1_000_000;
    let operation = u8::try_from(operation_code).ok().and_then(|code| machine.operations.get(&code)).copied();
    let Some(operation) = operation else { return Err(Finding::UnknownOperation { operation: operation_code }) };
    let field = |unit: i64| {
        let field = (digits / unit) % 100;
        match u8::try_from(field) {
            Ok(parameter) if parameter <= 95 => Ok(parameter),
            _ => Err(Finding::MalformedControlWord { field: Some(field) }),
        }
    };
    let first = field(10_000)?;
    let second = if operation.takes_two() { Some(field(100)?) } else { None };
    let result = field(1)?;
    Ok(ControlWord { operation, first, second, result, whole: whole < 0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::MemoryLoader;

    fn resolve(body: &str) -> (Arc<SourceText>, Resolved, Findings) {
        let source = Arc::new(SourceText::from_text("t.nc", format!("%1\n{body}")));
        let (loader, settings) = (MemoryLoader::new(), Settings::default());
        let mut library = Library::new(&loader, &settings.macrocycles, Path::new("t.nc"));
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let resolved = resolve_program(&source, &settings, &mut library, &mut sources, &mut findings);
        (source, resolved, findings)
    }

    /// FLW-5: jumps reach numbers of up to four digits; of a number that stands twice, the first block.
    #[test]
    fn blocks_by_number() {
        let (_, resolved, _) = resolve("N30 X1\nN9999 X2\nN10 X3\nN30 X4\nN10000 X5\nN10 X6\nN30 X7\nN5 M30\n");
        for (number, block) in [(5, Some(7)), (10, Some(2)), (30, Some(0)), (9999, Some(1)), (10_000, None), (20, None)]
        {
            assert_eq!(resolved.numbered(FileId(0), number), block.map(BlockId), "{number}");
        }
    }

    /// Parts of a long file that are checked side by side leave no block out and check none twice.
    #[test]
    fn every_block_of_a_long_file_is_checked() {
        let faulty = [1, 2, SIDE_BY_SIDE, SIDE_BY_SIDE + 1, 2 * SIDE_BY_SIDE, 2 * SIDE_BY_SIDE + 1, 3 * SIDE_BY_SIDE];
        let block = |n: u32| format!("N{n} {}\n", if faulty.contains(&n) { "X99999" } else { "X1" });
        for last in [2 * SIDE_BY_SIDE - 1, 2 * SIDE_BY_SIDE, 3 * SIDE_BY_SIDE + 1] {
            let body: String = (1..=last).map(block).collect();
            let (source, _, findings) = resolve(&format!("{body}N{} M30\n", last + 1));
            let lines: Vec<u32> =
                findings.items().iter().map(|found| source.line_column(found.at.span.start).line - 1).collect();
            let expected: Vec<u32> = faulty.into_iter().filter(|n| *n <= last).collect();
            assert_eq!(lines, expected, "{last}");
        }
    }
}
