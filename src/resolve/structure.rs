//! Splits files into units: the main program, its subprograms, a macrocycle (§5).

use std::collections::BTreeMap;
use std::sync::Arc;

use super::blocks::{BlockChecker, m_number};
use super::checks::look_at_blocks;
use super::cut::{self, CutOff};
use super::foreign::Origin;
use super::letters::Letters;
use super::meant::{may_have_end, may_hold};
use super::pending::{Pending, Stray};
use super::{Library, MacrocycleFault, Resolved, Unit, UnitId, UnitKind, flow, lines, rings};
use crate::config::{Machine, Settings};
use crate::diag::{Diagnostic, EarlyEnd, Finding, Findings, LabelText};
use crate::dict::{Address, Decimal, GCode, HIGHEST_L, HIGHEST_PARAMETER, PROGRAM_ENDS};
use crate::sure::{Sure, small};
use crate::syntax::{BlockFlags, BlockId, Form, ParsedFile, Word, parse};
use crate::text::{FileId, Location, SourceText, Sources, Span, path_name};

/// Most subprograms of a file (PRG-4).
const SUBPROGRAMS: usize = 99;
/// M functions that end subprograms on other controls: M99, M17.
const RETURNS_ELSEWHERE: [i64; 2] = [99, 17];

/// What resolving works with.
pub(super) struct Context<'a, 'l> {
    pub(super) settings: &'a Settings,
    pub(super) library: &'a mut Library<'l>,
    pub(super) sources: &'a mut Sources,
    pub(super) findings: &'a mut Findings,
    /// What is reported when all calls have been followed.
    pub(super) pending: Pending,
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
    let mut parsed = parse(file, source, Form::Program, findings);
    let case = parsed.take_case();
    let origin = Origin::of(&parsed);
    let mut resolved = Resolved::default();
    let mut context = Context { settings, library, sources, findings, pending: Pending::default() };
    if let Some(word) = parsed.program {
        BlockChecker::new(settings, &parsed, &Letters::default(), context.findings).check_program_word(word);
        context.add_program(&mut resolved, parsed);
        flow::follow_calls(&mut context, &mut resolved);
        flow::check_unused(&mut context, &resolved);
        flow::name_macrocycles(&mut context, &resolved);
        cut::join(&resolved, context.findings);
        flow::join_calls(&resolved, context.findings);
        if let Some(parsed) = resolved.file(file) {
            lines::join(parsed, context.findings);
        }
        rings::check(&mut context, &resolved);
    }
    resolved.written_files = resolved.files.len();
    add_case(case, findings);
    origin.point_out(settings, findings);
    resolved
}

/// Gives the finding of addresses in lower case; of a single one none when its word has another finding, because the word
/// is to be looked at anyway (LEX-11).
fn add_case(case: Option<Diagnostic>, findings: &mut Findings) {
    let Some(case) = case else { return };
    let of_word = |found: &Diagnostic| {
        // Its letter, or its number.
        let behind = found.at.span.start.checked_sub(case.at.span.start);
        found.at.file == case.at.file && matches!(behind, Some(0 | 1))
    };
    let single = matches!(case.finding, Finding::LowercaseAddress { count: 1 });
    if !(single && findings.items().iter().any(of_word)) {
        findings.add(case);
    }
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
    let mut parsed = parse(file, source, Form::Macrocycle, findings);
    add_case(parsed.take_case(), findings);
    let origin = Origin::of(&parsed);
    let mut resolved = Resolved::default();
    let mut context = Context { settings, library, sources, findings, pending: Pending::default() };
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
        let mut context = Context { settings, library, sources, findings, pending: Pending::default() };
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
        let source = self.library.load(&path, &path_name(&path), self.settings.encoding)?;
        let file = self.sources.add(Arc::clone(&source));
        let mut findings = Findings::with_levels(*self.findings.levels());
        let mut parsed = parse(file, &source, Form::Macrocycle, &mut findings);
        add_case(parsed.take_case(), &mut findings);
        if Self::is_program(&parsed) {
            return Ok(self.add_misnamed(resolved, parsed, l));
        }
        self.findings.append(findings);
        Ok(self.add_macrocycle(resolved, parsed, l))
    }

    fn report(&mut self, at: Location, finding: Finding) {
        self.findings.add(Diagnostic::new(finding, at));
    }

    /// Splits a program into its main program and subprograms, and checks every block (PRG-2…PRG-5).
    fn add_program(&mut self, resolved: &mut Resolved, parsed: ParsedFile) {
        let program = parsed.program.map_or(Location::default(), |word| parsed.word_place(word));
        let file = FileId(0);
        let (end, ended) = main_end(&parsed);
        let first = BlockId(0);
        let main = Unit { kind: UnitKind::Main, file, first, end, entry: program };
        resolved.add_unit(main);
        let mut excused = Vec::new();
        self.add_subprograms(resolved, &parsed, end, &mut excused);
        // Words without any block are one error already (BLK-2).
        let no_block = parsed.block_count() == 0 && parsed.words_outside;
        if !ended && !no_block && !may_have_end(&parsed, &main) {
            let place = if end == first { program } else { parsed.n_place(BlockId(end.0 - 1)) };
            // An end that stands behind subprograms is the one that is missing before them.
            let late = self.pending.take_end().and_then(|block| end_word(self.settings, &parsed, block));
            let function = late.map(|(function, _)| function);
            let last = end.0.checked_sub(1).map(BlockId);
            let instead = last.and_then(|last| self.return_elsewhere(&parsed, last)).map(|(function, _)| function);
            let (cut_off, unread) = function.is_none().then(|| cut::program_end(&parsed, place)).flatten().unzip();
            let finding = Finding::MissingProgramEnd { skipped: false, late: function, instead, unread };
            let mut diagnostic = Diagnostic::new(finding, place);
            if let Some(cut_off) = cut_off {
                resolved.cut_off = Some(cut_off);
                diagnostic = diagnostic.with_label(cut_off.star, LabelText::FileEnds);
            }
            if let Some((function, word)) = late {
                diagnostic = diagnostic.with_label(parsed.word_place(word), LabelText::EndHere { function });
            }
            self.findings.add(diagnostic);
        }
        if let Some(last) = end.0.checked_sub(1).map(BlockId).filter(|_| ended)
            && let Some((function, word)) = end_word(self.settings, &parsed, last)
        {
            let early = EarlyEnd { function, block: parsed.shown_number(last) };
            self.pending.ends_early(early, parsed.word_place(word));
        }
        self.check_ends_in_main(&parsed, first, end);
        self.add_checked(resolved, parsed, 0, &excused);
    }

    fn add_subprograms(
        &mut self,
        resolved: &mut Resolved,
        parsed: &ParsedFile,
        from: BlockId,
        excused: &mut Vec<BlockId>,
    ) {
        let mut block = from;
        let (mut stray, mut unread) = (false, false);
        let mut count = 0;
        let mut first_of: BTreeMap<u32, Word> = BTreeMap::new();
        let program_end = parsed.program_end();
        while block < program_end {
            let flags = parsed.flags(block);
            if !flags.has(BlockFlags::ENTRY) {
                if !stray {
                    // With a G79 that cannot be read it is a subprogram, nobody knows which.
                    unread = may_hold(parsed, block, Address::G, &[GCode::G79.number()]);
                    resolved.nameless_subprogram |= unread;
                }
                if !stray && !unread {
                    let number = parsed.shown_number(block);
                    self.pending.strays.push(Stray::new(parsed.n_place(block), number));
                }
                stray = true;
                if !unread {
                    self.pending.note(block, flags);
                }
                block = block.next();
                continue;
            }
            stray = false;
            count += 1;
            let entry = entry_place(parsed, block);
            let (end, ended) = unit_end(parsed, block);
            if count == SUBPROGRAMS + 1 {
                self.report(entry, Finding::TooManySubprograms {});
            }
            let l_word = entry_l(parsed, block);
            let l = l_word.and_then(l_number);
            let kind = UnitKind::Subprogram(l);
            let unit = Unit { kind, file: FileId(0), first: block, end, entry };
            let ends_before = ends_before_entry(parsed, block) || returns_before_entry(parsed, block);
            excused.extend(ends_before.then_some(block));
            self.check_entry(parsed, block, ends_before);
            let id = resolved.add_unit(unit);
            // The number that a fix makes of it is a guess.
            resolved.nameless_subprogram |= l_word.is_some_and(Word::is_faulty);
            if !ended {
                let (ends, cut_off) = self.report_unterminated(parsed, &unit);
                excused.extend(ends);
                resolved.cut_off = resolved.cut_off.or(cut_off);
            }
            if let (Some(word), Some(l)) = (l_word, l) {
                match first_of.get(&l) {
                    None => {
                        first_of.insert(l, word);
                        resolved.subprograms.insert(l, id);
                    }
                    Some(first) => {
                        let diagnostic = Diagnostic::new(Finding::DuplicateSubprogram { l }, parsed.word_place(word));
                        let label = parsed.word_place(*first);
                        self.findings.add(diagnostic.with_label(label, LabelText::First { what: format!("L{l}") }));
                    }
                }
            }
            block = end;
        }
    }

    /// A unit without G70 (PRG-3). Gives the block at its end that holds M02 or M30 instead, which has no finding of its
    /// own, or the `*` that G70 stands behind.
    fn report_unterminated(&mut self, parsed: &ParsedFile, unit: &Unit) -> (Option<BlockId>, Option<CutOff>) {
        let Unit { kind, first, end, entry, .. } = *unit;
        let macrocycle = matches!(kind, UnitKind::Macrocycle(_));
        if may_have_end(parsed, unit) {
            return (None, None);
        }
        let (cut_off, unread) = cut::subprogram(parsed, unit).unzip();
        let last = end.0.checked_sub(1).map(BlockId).filter(|last| *last >= first);
        let ends = last.and_then(|last| end_word(self.settings, parsed, last));
        let instead = ends.or_else(|| self.return_elsewhere(parsed, last?));
        let finding = Finding::UnterminatedSubprogram {
            macrocycle,
            skipped: false,
            last: end.0 >= parsed.block_count(),
            instead: instead.map(|(function, _)| function),
            unread,
        };
        let mut diagnostic = Diagnostic::new(finding, entry);
        if let Some(cut_off) = cut_off {
            self.findings.add(diagnostic.with_label(cut_off.star, LabelText::FileEnds));
            return (None, Some(cut_off));
        }
        if let Some((function, word)) = instead {
            diagnostic = diagnostic.with_label(parsed.word_place(word), LabelText::InPlaceOfG70 { function });
        }
        self.findings.add(diagnostic);
        (last.filter(|_| ends.is_some()), None)
    }

    /// The M function of a block that returns from a subprogram on other controls.
    fn return_elsewhere(&self, parsed: &ParsedFile, block: BlockId) -> Option<(u8, Word)> {
        let returns = |word: &&Word| {
            word.address == Address::M && word.whole().is_some_and(|number| RETURNS_ELSEWHERE.contains(&number))
        };
        let word = parsed.words(block).iter().find(returns).copied()?;
        Some((m_number(word, self.settings)?, word))
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
            self.check_entry(&parsed, first, false);
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
        let file = FileId(small(resolved.files.len()));
        let unit = Unit { kind: UnitKind::Macrocycle(l), file, first, end, entry };
        let mut excused = None;
        if !ended && (begins || empty) {
            (excused, _) = self.report_unterminated(&parsed, &unit);
        }
        if end.0 < parsed.block_count() {
            let finding = Finding::BlockAfterMacrocycleEnd { block: parsed.shown_number(end) };
            self.report(parsed.n_place(end), finding);
        }
        let known = resolved.units.len();
        let id = resolved.add_unit(unit);
        resolved.macrocycles.insert(l, id);
        self.add_checked(resolved, parsed, known, excused.as_slice());
        id
    }

    /// Checks every block of a file, whose units are those from `units` on, and adds it.
    fn add_checked(&mut self, resolved: &mut Resolved, mut parsed: ParsedFile, units: usize, excused: &[BlockId]) {
        resolved.letters.read(&self.settings.machine, &parsed);
        let units = resolved.units.get(units..).sure();
        let checked = look_at_blocks(self.settings, &parsed, units, &resolved.letters, excused);
        self.findings.append(checked.findings);
        for (operation, diagnostic) in checked.judged.operations {
            if resolved.unknown_operations.insert(operation) {
                self.findings.add(diagnostic);
            }
        }
        for (m, diagnostic) in checked.judged.meaningless {
            if resolved.meaningless.insert(m) {
                self.findings.add(diagnostic);
            }
        }
        parsed.refuse(&checked.judged.refused);
        parsed.mark_merged(&checked.merged);
        resolved.add_file(parsed, checked.reachable, checked.judged.points);
    }

    /// G70 ends subprograms only (PRG-5).
    fn check_ends_in_main(&mut self, parsed: &ParsedFile, first: BlockId, end: BlockId) {
        for block in (first.0..end.0).map(BlockId) {
            if parsed.flags(block).has(BlockFlags::RETURN)
                && let Some(&word) = parsed.words(block).iter().find(|word| word.g_code() == Some(GCode::G70))
            {
                self.report(parsed.word_place(word), Finding::EndOutsideSubprogram { finishing: false });
            }
        }
    }

    /// Nothing but `N`, G79 and L stands in the block that begins a unit (PRG-3).
    fn check_entry(&mut self, parsed: &ParsedFile, block: BlockId, unnumbered: bool) {
        for &word in parsed.words(block) {
            // A function of the same group, or a second L, is a finding of its own already.
            let of_group = word.g_code().is_some_and(|code| code.group() == GCode::G79.group());
            if !of_group && word.address != Address::L && !word.is_faulty() {
                let place = parsed.word_place(word);
                let shown = crate::diag::shown(parsed.source.slice(place.span));
                self.report(place, Finding::CrowdedSubprogramStart { word: shown, unnumbered });
                return;
            }
        }
    }
}

/// Where the main program ends: behind its first M02 or M30 that is not skippable, or before G79; and whether it has an
/// end at all (PRG-2).
fn main_end(parsed: &ParsedFile) -> (BlockId, bool) {
    let mut ended = false;
    for block in parsed.block_ids() {
        let flags = parsed.flags(block);
        if flags.has(BlockFlags::ENTRY) {
            return (block, ended || ends_before_entry(parsed, block));
        }
        if flags.has(BlockFlags::END) {
            ended = true;
            if !flags.has(BlockFlags::SKIP) {
                return (block.next(), true);
            }
        }
    }
    (BlockId(parsed.block_count()), ended)
}

/// Whether the block that begins a subprogram holds the end of the main program on a line above G79: the number of its own
/// was forgotten on that line.
fn ends_before_entry(parsed: &ParsedFile, block: BlockId) -> bool {
    let end = |word: &Word| PROGRAM_ENDS.into_iter().any(|function| word.is_m(function));
    parsed.flags(block).has(BlockFlags::END) && is_above_entry(parsed, block, end)
}

/// Whether the block that begins a subprogram holds the G70 of the one before on a line above G79.
fn returns_before_entry(parsed: &ParsedFile, block: BlockId) -> bool {
    let flags = parsed.flags(block);
    let returns = |word: &Word| word.g_code() == Some(GCode::G70);
    flags.has(BlockFlags::ENTRY) && flags.has(BlockFlags::RETURN) && is_above_entry(parsed, block, returns)
}

/// Whether such a word of a block stands on a line above its G79.
fn is_above_entry(parsed: &ParsedFile, block: BlockId, wanted: impl Fn(&Word) -> bool) -> bool {
    let entry = entry_place(parsed, block).span.start;
    let line = |at: u32| parsed.source.lines().line_at(at);
    parsed.words(block).iter().any(|word| wanted(word) && line(word.start()) < line(entry))
}

/// The M02 or M30 of a block.
fn end_word(settings: &Settings, parsed: &ParsedFile, block: BlockId) -> Option<(u8, Word)> {
    let end = |word: &Word| Some((m_number(*word, settings).filter(|m| PROGRAM_ENDS.contains(m))?, *word));
    parsed.words(block).iter().find_map(end)
}

/// Where a unit that begins at `first` ends: after its first G70, before the next G79, or with the file; and whether it
/// has its G70.
fn unit_end(parsed: &ParsedFile, first: BlockId) -> (BlockId, bool) {
    for block in (first.0..parsed.block_count()).map(BlockId) {
        let flags = parsed.flags(block);
        let before_entry = returns_before_entry(parsed, block);
        if block != first && flags.has(BlockFlags::ENTRY) {
            return (block, before_entry);
        }
        if flags.has(BlockFlags::RETURN) && !before_entry {
            return (block.next(), true);
        }
    }
    (BlockId(parsed.block_count()), false)
}

fn entry_place(parsed: &ParsedFile, block: BlockId) -> Location {
    parsed
        .words(block)
        .iter()
        .find(|word| word.g_code() == Some(GCode::G79))
        .map_or_else(|| parsed.n_place(block), |word| parsed.word_place(*word))
}

fn entry_l(parsed: &ParsedFile, block: BlockId) -> Option<Word> {
    parsed.words(block).iter().copied().find(|word| word.address == Address::L)
}

/// The number that an L word writes out, when it is in range.
pub fn l_number(word: Word) -> Option<u32> {
    let number = word.whole().and_then(|number| u32::try_from(number).ok())?;
    (1..=HIGHEST_L).contains(&number).then_some(number)
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
    let whole = value.as_whole().filter(|_| value.abs() <= Decimal::WHOLE_MAX);
    let Some(whole) = whole else { return Err(Finding::MalformedControlWord { field: None }) };
    let digits = whole.abs();
    let operation_code = digits / 1_000_000;
    let operation = u8::try_from(operation_code).ok().and_then(|code| machine.operations.get(&code)).copied();
    let Some(operation) = operation else {
        return Err(Finding::UnknownOperation { operation: operation_code, digits });
    };
    let field = |unit: i64| {
        let field = (digits / unit) % 100;
        match u8::try_from(field) {
            Ok(parameter) if parameter <= HIGHEST_PARAMETER => Ok(parameter),
            _ => Err(Finding::MalformedControlWord { field: Some(field) }),
        }
    };
    let first = field(10_000)?;
    let second = if operation.takes_two() { Some(field(100)?) } else { None };
    let result = field(1)?;
    Ok(ControlWord { operation, first, second, result, whole: whole < 0 })
}

/// The parameter that receives the result of a control word, also of one that is wrong elsewhere; `None` when that cannot be
/// told (§13).
pub fn control_result(value: Decimal) -> Option<u8> {
    let whole = value.as_whole().filter(|_| value.abs() <= Decimal::WHOLE_MAX)?;
    u8::try_from(whole.abs() % 100).ok().filter(|parameter| *parameter <= HIGHEST_PARAMETER)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

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
}
