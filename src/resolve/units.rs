//! Splits files into units (§5): the main program, its subprograms, a macrocycle. A fault leaves a hole: a unit whose
//! number cannot be read, blocks without their G79, an end that may be malformed or come after a `*`.

use std::collections::BTreeMap;

use super::functions::m_number;
use super::holes::{may_have_end, may_hold};
use super::load::Context;
use super::numbers::{has_number_of_next, is_doubled};
use super::open_ends::Stray;
use super::spelling;
use super::star::Star;
use super::{Resolved, Unit, UnitId, UnitKind, l_number};
use crate::config::Settings;
use crate::diag::{Diagnostic, EarlyEnd, Finding, LabelText};
use crate::dict::{Address, GCode, PROGRAM_ENDS, SPINDLE_TURNS, standard_m_functions};
use crate::sure::small;
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Word};
use crate::text::{FileId, Location, Span};

/// Most subprograms of a file (PRG-4).
const SUBPROGRAMS: usize = 99;
/// M functions that end subprograms on other controls: M99, M17.
const RETURNS_ELSEWHERE: [i64; 2] = [99, 17];

/// A file while it is split into units.
struct Split<'f> {
    parsed: &'f ParsedFile,
    /// The `*` that ends it.
    star: Option<Star>,
    /// Blocks with M02 or M30 that are part of another finding.
    excused: Vec<BlockId>,
    /// The L of each subprogram number so far.
    first_of: BTreeMap<u32, Word>,
}

impl<'f> Split<'f> {
    fn of(parsed: &'f ParsedFile) -> Self {
        Self { parsed, star: Star::of(parsed), excused: Vec::new(), first_of: BTreeMap::new() }
    }
}

impl Context<'_, '_> {
    /// Splits a program into its main program and subprograms, and checks every block (PRG-2…PRG-5).
    pub(super) fn add_program(&mut self, resolved: &mut Resolved, parsed: ParsedFile) {
        let program = parsed.program.map_or(Location::default(), |word| parsed.word_place(word));
        let file = FileId(0);
        let (end, ended) = main_end(&parsed);
        let first = BlockId(0);
        let main = Unit { kind: UnitKind::Main, file, first, end, entry: program };
        resolved.add_unit(main);
        let mut split = Split::of(&parsed);
        self.add_subprograms(resolved, &mut split, end);
        // Words without any block are one error already (BLK-2).
        let no_block = parsed.block_count() == 0 && !parsed.outside.is_empty();
        if !ended && !no_block && !may_have_end(&parsed, &main) {
            self.report_endless_program(resolved, &split, end);
        }
        if let Some(last) = end.0.checked_sub(1).map(BlockId).filter(|_| ended)
            && let Some((function, word)) = end_word(self.settings, &parsed, last)
        {
            let early = EarlyEnd { function, block: parsed.shown_number(last) };
            self.open.ends_early(early, parsed.word_place(word));
        }
        self.check_ends_in_main(&parsed, first, end);
        let Split { star, excused, .. } = split;
        self.add_judged(resolved, parsed, star, 0, &excused);
    }

    /// A main program without M02 and M30 (PRG-2), whose blocks end before `end`.
    fn report_endless_program(&mut self, resolved: &mut Resolved, split: &Split<'_>, end: BlockId) {
        let parsed = split.parsed;
        let last = end.0.checked_sub(1).map(BlockId);
        let program = || parsed.program.map(|word| parsed.word_place(word)).unwrap_or_default();
        let place = last.map_or_else(program, |last| parsed.n_place(last));
        // An end after the subprograms is the one that is missing before them.
        let late = self.open.take_end().and_then(|block| end_word(self.settings, parsed, block));
        let function = late.map(|(function, _)| function);
        let instead = last
            .and_then(|last| self.return_elsewhere(parsed, last).or_else(|| mistyped_end(self.settings, parsed, last)));
        let instead = instead.map(|(function, _)| function);
        let star = split.star.as_ref().filter(|_| late.is_none());
        let (star, unread) = star.and_then(|star| Some((star.at, star.program_end(parsed)?))).unzip();
        let finding = Finding::MissingProgramEnd { skipped: false, late: function, instead, unread };
        let mut diagnostic = Diagnostic::new(finding, place);
        if let Some(star) = star {
            resolved.tell_of_star(parsed.file);
            diagnostic = diagnostic.with_label(star, LabelText::FileEnds);
        }
        if let Some((function, word)) = late {
            diagnostic = diagnostic.with_label(parsed.word_place(word), LabelText::EndHere { function });
        }
        self.findings.add(diagnostic);
    }

    /// Adds the subprograms from a block on, and the runs of blocks between them that are in none.
    fn add_subprograms(&mut self, resolved: &mut Resolved, split: &mut Split<'_>, from: BlockId) {
        let parsed = split.parsed;
        let mut block = from;
        let (mut stray, mut unread) = (false, false);
        let mut count = 0;
        while block < parsed.program_end() {
            let flags = parsed.flags(block);
            let entry = flags.has(BlockFlags::ENTRY);
            let again = || block.0.checked_sub(1).is_some_and(|before| is_doubled(parsed, BlockId(before)));
            let begins_next = || has_number_of_next(parsed, block) && parsed.flags(block.next()).has(BlockFlags::ENTRY);
            // The second one of two ends is too many, and the first `N100` of `N100 N100 G79 L1`.
            if !entry && !stray && (again() || begins_next()) {
                block = block.next();
                continue;
            }
            if entry {
                stray = false;
                count += 1;
                if count == SUBPROGRAMS + 1 {
                    self.report(entry_place(parsed, block), Finding::TooManySubprograms {});
                }
                block = self.add_subprogram(resolved, split, block);
                continue;
            }
            if !stray {
                // With a G79 that cannot be read it is a subprogram, nobody knows which.
                unread = may_hold(parsed, block, Address::G, &[GCode::G79.number()]);
                resolved.nameless_subprogram |= unread;
                if !unread {
                    self.open.strays.push(Stray::new(parsed.n_place(block), parsed.shown_number(block)));
                }
            }
            stray = true;
            if !unread {
                self.open.note(block, flags);
            }
            block = block.next();
        }
    }

    /// Adds the subprogram that begins at a block, and gives where it ends.
    fn add_subprogram(&mut self, resolved: &mut Resolved, split: &mut Split<'_>, block: BlockId) -> BlockId {
        let parsed = split.parsed;
        let entry = entry_place(parsed, block);
        // Written twice, one behind the other, it begins one unit.
        let begins = if is_doubled(parsed, block) { block.next() } else { block };
        let (end, ended) = unit_end(parsed, begins);
        let l_word = entry_l(parsed, block);
        let l = l_word.and_then(l_number);
        let unit = Unit { kind: UnitKind::Subprogram(l), file: FileId(0), first: block, end, entry };
        let ends_before = ends_before_entry(parsed, block) || returns_before_entry(parsed, block);
        split.excused.extend(ends_before.then_some(block));
        self.check_entry(parsed, block, ends_before);
        let id = resolved.add_unit(unit);
        // The number that a fix makes of it is a guess.
        resolved.nameless_subprogram |= l_word.is_some_and(|word| word.is_faulty() || !word.is_digits());
        if !ended {
            self.report_unterminated(resolved, split, &unit);
        }
        if let (Some(word), Some(l)) = (l_word, l) {
            match split.first_of.get(&l) {
                None => {
                    split.first_of.insert(l, word);
                    resolved.subprograms.insert(l, id);
                }
                Some(first) => {
                    let diagnostic = Diagnostic::new(Finding::DuplicateSubprogram { l }, parsed.word_place(word));
                    let label = parsed.word_place(*first);
                    self.findings.add(diagnostic.with_label(label, LabelText::First { what: format!("L{l}") }));
                }
            }
        }
        end
    }

    /// A unit without G70 (PRG-3). A block at its end that holds M02 or M30 instead has no other finding.
    fn report_unterminated(&mut self, resolved: &mut Resolved, split: &mut Split<'_>, unit: &Unit) {
        let parsed = split.parsed;
        if may_have_end(parsed, unit) {
            return;
        }
        let Unit { kind, first, end, entry, .. } = *unit;
        let macrocycle = matches!(kind, UnitKind::Macrocycle(_));
        let star = split.star.as_ref();
        let (star, unread) = star.and_then(|star| Some((star.at, star.unit_end(parsed, unit)?))).unzip();
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
        if let Some(star) = star {
            resolved.tell_of_star(parsed.file);
            self.findings.add(diagnostic.with_label(star, LabelText::FileEnds));
            return;
        }
        if let Some((function, word)) = instead {
            diagnostic = diagnostic.with_label(parsed.word_place(word), LabelText::InPlaceOfG70 { function });
        }
        self.findings.add(diagnostic);
        split.excused.extend(last.filter(|_| ends.is_some()));
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
    pub(super) fn add_macrocycle(&mut self, resolved: &mut Resolved, parsed: ParsedFile, l: u32) -> UnitId {
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
        let mut split = Split::of(&parsed);
        if !ended && (begins || empty) {
            self.report_unterminated(resolved, &mut split, &unit);
        }
        if end.0 < parsed.block_count() {
            let finding = Finding::BlockAfterMacrocycleEnd { block: parsed.shown_number(end) };
            self.report(parsed.n_place(end), finding);
        }
        let known = resolved.units.len();
        let id = resolved.add_unit(unit);
        resolved.macrocycles.insert(l, id);
        let Split { star, excused, .. } = split;
        self.add_judged(resolved, parsed, star, known, &excused);
        id
    }

    /// G70 ends subprograms only (PRG-5).
    fn check_ends_in_main(&mut self, parsed: &ParsedFile, first: BlockId, end: BlockId) {
        for block in (first.0..end.0).map(BlockId) {
            if parsed.flags(block).has(BlockFlags::RETURN)
                && let Some(&word) = parsed.words(block).iter().find(|word| word.g_code() == Some(GCode::G70))
            {
                let has = |address: Address| parsed.words(block).iter().any(|word| word.address == address);
                let finishing = has(Address::P) && has(Address::Q);
                self.report(parsed.word_place(word), Finding::EndOutsideSubprogram { finishing });
            }
        }
    }

    /// The block that begins a unit has only `N`, G79 and L (PRG-3).
    fn check_entry(&mut self, parsed: &ParsedFile, block: BlockId, unnumbered: bool) {
        for &word in parsed.words(block) {
            // A function of the same group, or a second L, has another finding.
            let of_group = word.g_code().is_some_and(|code| code.group() == GCode::G79.group());
            if !of_group && word.address != Address::L && !word.is_faulty() {
                let place = parsed.word_place(word);
                let shown = crate::diag::shown(parsed.source.slice(place.span));
                self.open.crowded.insert(place);
                let finding = Finding::CrowdedSubprogramStart { word: shown, unnumbered };
                let diagnostic = Diagnostic::new(finding, place);
                let l = entry_l(parsed, block).and_then(l_number).filter(|_| unnumbered);
                self.findings.add(match l {
                    Some(l) => diagnostic.with_label(entry_place(parsed, block), LabelText::UnitBegins { l }),
                    None => diagnostic,
                });
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

/// Whether the block that begins a subprogram holds the end of the main program on a line above G79, whose block number
/// was forgotten.
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

/// The M function that is all a block has and as the last one of a program is an end with another digit: M03 for M30,
/// or one without a meaning, such as M20.
fn mistyped_end(settings: &Settings, parsed: &ParsedFile, block: BlockId) -> Option<(u8, Word)> {
    let [word] = parsed.words(block) else { return None };
    let m = m_number(*word, settings)?;
    let [start, _] = SPINDLE_TURNS;
    let is_standard = standard_m_functions(settings.machine.dialect).any(|row| row.number == m);
    let is_configured = settings.machine.m_functions.get(m).is_some_and(|function| function.configured);
    let near = PROGRAM_ENDS.into_iter().any(|end| spelling::distance(u32::from(end), u32::from(m)).0 == 1);
    (m == start || near && !is_standard && !is_configured).then_some((m, *word))
}

fn entry_place(parsed: &ParsedFile, block: BlockId) -> Location {
    parsed
        .words(block)
        .iter()
        .find(|word| word.g_code() == Some(GCode::G79))
        .map_or_else(|| parsed.n_place(block), |word| parsed.word_place(*word))
}

/// The L of a block that begins a subprogram.
pub(super) fn entry_l(parsed: &ParsedFile, block: BlockId) -> Option<Word> {
    parsed.words(block).iter().copied().find(|word| word.address == Address::L)
}
