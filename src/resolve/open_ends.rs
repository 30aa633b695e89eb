//! Decides, when all calls have been followed, which fault explains a call or jump that leads nowhere, and whether the
//! fault still needs a finding.

use std::collections::{BTreeMap, BTreeSet};

use super::load::Context;
use super::spelling;
use super::star::Star;
use super::targets::{Namesake, macrocycle_finding};
use super::unnumbered::{lines_between, lines_by_number};
use super::{MacrocycleFault, Resolved, Target, UnitId};
use crate::diag::{Diagnostic, EarlyEnd, Finding, LabelText, UnusedMeant};
use crate::sure::small;
use crate::syntax::{BlockFlags, BlockId, Word};
use crate::text::{FileId, Location};

/// Findings that depend on the calls.
#[derive(Debug, Default)]
pub(super) struct OpenEnds {
    /// Runs of blocks after the end of the main program that are in no subprogram, in the order of the text.
    pub(super) strays: Vec<Stray>,
    /// Calls of subprograms that are missing, each with its number, in the order of the text.
    pub(super) calls: Vec<(u32, Diagnostic)>,
    /// Jumps to blocks that are missing, likewise.
    pub(super) jumps: Vec<(u32, Diagnostic)>,
    /// Macrocycles that are called and cannot be loaded, by number.
    missing: BTreeMap<u32, Missing>,
    /// The end of the main program, where blocks that follow it hold another one.
    early: Option<(EarlyEnd, Location)>,
    /// The words too many in blocks that begin subprograms (E0208): a line that they begin has no other finding.
    pub(super) crowded: BTreeSet<Location>,
    /// L without use (W0402), with its number: its function was lost.
    pub(super) lost_calls: Vec<(u32, Diagnostic)>,
    /// What each file leaves open.
    pub(super) files: Vec<OpenFile>,
}

/// The findings of a file that wait for the calls.
#[derive(Debug)]
pub(super) struct OpenFile {
    pub(super) file: FileId,
    /// The findings at the `*`, which it may explain.
    pub(super) at_star: Vec<Diagnostic>,
    /// Lines that lack their block number (W0221), by their first words.
    pub(super) unnumbered: Vec<(Word, BlockId)>,
    /// Lines with a finding that says so, by where they begin.
    pub(super) told: Vec<u32>,
}

/// A run of blocks in no unit (PRG-2): a hole where the G79 of a subprogram may be missing.
#[derive(Debug)]
pub(super) struct Stray {
    /// The `N` of its first block.
    pub(super) at: Location,
    /// The number of that block.
    pub(super) block: u32,
    /// It holds G70: the end of a subprogram whose G79 is missing.
    returns: bool,
    /// Its first block with M02 or M30.
    end: Option<BlockId>,
    /// The subprogram that it is, as a call to it told.
    meant: Option<u32>,
}

impl Stray {
    pub(super) const fn new(at: Location, block: u32) -> Self {
        Self { at, block, returns: false, end: None, meant: None }
    }
}

#[derive(Debug)]
struct Missing {
    /// At the number of the first call.
    at: Location,
    fault: MacrocycleFault,
    namesake: Namesake,
    calls: usize,
}

impl OpenEnds {
    /// Takes note of a block of the last stray run.
    pub(super) fn note(&mut self, block: BlockId, flags: BlockFlags) {
        let Some(stray) = self.strays.last_mut() else { return };
        stray.returns |= flags.has(BlockFlags::RETURN);
        if flags.has(BlockFlags::END) && stray.end.is_none() {
            stray.end = Some(block);
        }
    }

    /// The first block with M02 or M30 in a stray run. That run is not reported then.
    pub(super) fn take_end(&mut self) -> Option<BlockId> {
        let at = self.strays.iter().position(|stray| stray.end.is_some())?;
        self.strays.remove(at).end
    }

    /// The run of blocks that is subprogram `l` without its G79, and whether a call has named it before. It is not
    /// reported by itself then.
    pub(super) fn without_entry(&mut self, l: u32) -> Option<(&Stray, bool)> {
        let is_it = |stray: &Stray| stray.meant == Some(l);
        let known = self.strays.iter().position(is_it);
        let at = known.or_else(|| self.strays.iter().position(|stray| stray.returns && stray.meant.is_none()))?;
        let stray = self.strays.get_mut(at)?;
        stray.meant = Some(l);
        Some((stray, known.is_some()))
    }

    /// The main program ends at `at`: too early, where the blocks behind it hold an end of their own.
    pub(super) fn ends_early(&mut self, end: EarlyEnd, at: Location) {
        if self.strays.first().is_some_and(|stray| stray.end.is_some() && !stray.returns) {
            self.early = Some((end, at));
        }
    }

    /// Takes note of a call to macrocycle `l`, which cannot be loaded.
    pub(super) fn miss(&mut self, l: u32, fault: MacrocycleFault, namesake: Namesake, at: Location) {
        self.missing.entry(l).or_insert(Missing { at, fault, namesake, calls: 0 }).calls += 1;
    }
}

impl Context<'_, '_> {
    /// Gives the findings that had to wait for the calls.
    pub(super) fn report_open_ends(&mut self, resolved: &Resolved) {
        let open = std::mem::take(&mut self.open);
        let OpenEnds { strays, calls, jumps, missing, early, lost_calls, files, crowded } = open;
        // Asked for once more, when subprograms are counted.
        self.open.crowded = crowded;
        self.report_calls(resolved, calls);
        let lines = self.report_jumps(resolved, jumps, &files);
        self.report_lost_calls(resolved, lost_calls, &strays);
        self.report_strays(resolved, strays, early);
        let mut missing: Vec<_> = missing.into_iter().collect();
        missing.sort_by_key(|(_, missing)| missing.at);
        for (l, Missing { at, fault, namesake, calls }) in missing {
            let of_machine = matches!(fault, MacrocycleFault::OfMachine { .. });
            let diagnostic = Diagnostic::new(macrocycle_finding(fault, l, namesake, calls), at);
            if of_machine {
                self.findings.add_of_machine(diagnostic);
            } else {
                self.findings.add(diagnostic);
            }
        }
        for OpenFile { file, at_star, unnumbered, told: _ } in files {
            let Some(parsed) = resolved.file(file) else { continue };
            let star = resolved.told_star(file);
            let open = at_star.into_iter().filter(|found| !star.is_some_and(|star| star.leads_to(found)));
            open.for_each(|found| self.findings.add(found));
            let index = parsed.source.lines();
            let open = unnumbered.into_iter().filter(|(word, _)| !lines.contains(&(file, index.line_at(word.start()))));
            for (word, block) in open {
                let finding = Finding::LineWithoutNumber { block: parsed.shown_number(block) };
                self.report(parsed.word_place(word), finding);
            }
        }
    }

    /// Calls of one subprogram that is missing are one finding, at the first of them, where the file has a subprogram
    /// that nothing calls: the number in its G79 is wrong, or all calls were to be written anew. So it is of one call
    /// whose number is that of a block, where one slip makes the other number of it.
    fn report_calls(&mut self, resolved: &Resolved, calls: Vec<(u32, Diagnostic)>) {
        let mut counts: BTreeMap<u32, usize> = BTreeMap::new();
        calls.iter().for_each(|(l, _)| *counts.entry(*l).or_default() += 1);
        let again = |l: u32| counts.get(&l).is_some_and(|count| *count > 1);
        let names_block = |call: &Diagnostic| matches!(call.finding, Finding::UnknownSubprogram { block: true, .. });
        let wanted = calls.iter().any(|(l, call)| again(*l) || names_block(call));
        let uncalled = if wanted { uncalled(resolved) } else { Vec::new() };
        let mut told = BTreeSet::new();
        for (l, mut call) in calls {
            let nearest = uncalled.iter().min_by_key(|(other, _)| spelling::distance(*other, l));
            let is_slip = |other: u32| names_block(&call) && spelling::distance(other, l).0 == 1;
            let nearest = nearest.filter(|(other, _)| again(l) || is_slip(*other));
            if let Some((other, unit)) = nearest.and_then(|(other, unit)| Some((*other, resolved.unit(*unit)?))) {
                if !told.insert(l) {
                    continue;
                }
                if let Finding::UnknownSubprogram { near, uncalled, .. } = &mut call.finding {
                    (*near, *uncalled) = (None, Some(other));
                }
                call = call.with_label(unit.entry, LabelText::UnitBegins { l: other });
            }
            self.findings.add(call);
        }
    }

    /// Of jumps to a block whose line begins with its number (`50 X5`, `Z50 X5`) the first has the finding, and says
    /// all that a warning of that line would say. Gives these lines.
    fn report_jumps(
        &mut self,
        resolved: &Resolved,
        jumps: Vec<(u32, Diagnostic)>,
        files: &[OpenFile],
    ) -> BTreeSet<(FileId, usize)> {
        let mut wanted: BTreeMap<FileId, BTreeSet<u32>> = BTreeMap::new();
        jumps.iter().for_each(|(l, jump)| _ = wanted.entry(jump.at.file).or_default().insert(*l));
        let unnumbered = |file: FileId| files.iter().find(|open| open.file == file).map(|open| &open.unnumbered);
        let lines = |(file, wanted): (&FileId, &BTreeSet<u32>)| {
            let parsed = resolved.file(*file)?;
            let mut lines = lines_between(parsed, unnumbered(*file)?, wanted);
            lines.extend(lines_by_number(parsed, wanted));
            Some((*file, lines))
        };
        let lines: BTreeMap<FileId, BTreeMap<u32, usize>> = wanted.iter().filter_map(lines).collect();
        let mut told = BTreeSet::new();
        for open in files.iter().filter(|open| lines.contains_key(&open.file)) {
            let index = resolved.file(open.file).map(|parsed| parsed.source.lines());
            let line = |start: &u32| Some((open.file, index?.line_at(*start)));
            told.extend(open.told.iter().filter_map(line));
        }
        for (l, mut jump) in jumps {
            let file = jump.at.file;
            if resolved.is_behind_told_star(file, l) {
                continue;
            }
            if let Some(&at) = lines.get(&file).and_then(|lines| lines.get(&l)) {
                if !told.insert((file, at)) {
                    continue;
                }
                if let Finding::UnknownJumpTarget { near, line, .. } = &mut jump.finding {
                    (*near, *line) = (None, Some(small(at + 1)));
                }
            }
            self.findings.add(jump);
        }
        told
    }

    /// L without use (W0402), with the call that was meant when a macrocycle has its number; none where it begins
    /// the subprogram without G79 that a call meant.
    fn report_lost_calls(&mut self, resolved: &Resolved, lost_calls: Vec<(u32, Diagnostic)>, strays: &[Stray]) {
        for (l, mut diagnostic) in lost_calls {
            let file = resolved.file(diagnostic.at.file);
            let n = file.and_then(|file| Some(file.n_place(file.block_at(diagnostic.at.span.start)?)));
            if strays.iter().any(|stray| stray.meant == Some(l) && Some(stray.at) == n) {
                continue;
            }
            if self.library.find(l).is_ok() || self.library.is_of_machine(l) {
                let meant = UnusedMeant::Macrocycle { written: format!("G72 L{l}") };
                diagnostic.finding = Finding::UnusedTarget { meant };
            }
            self.findings.add(diagnostic);
        }
    }

    /// Runs of blocks in no unit, but for those that a call or the `*` in their line explains.
    fn report_strays(&mut self, resolved: &Resolved, strays: Vec<Stray>, mut early: Option<(EarlyEnd, Location)>) {
        let program = FileId(0);
        let at_star = resolved.told_star(program).and_then(Star::block);
        let at_star = at_star.and_then(|block| Some(resolved.file(program)?.n_place(block)));
        for stray in strays.into_iter().filter(|stray| stray.meant.is_none()) {
            let (early, place) = early.take().unzip();
            if Some(stray.at) == at_star {
                continue;
            }
            let diagnostic = Diagnostic::new(Finding::BlockAfterProgramEnd { block: stray.block, early }, stray.at);
            self.findings.add(match (early, place) {
                (Some(EarlyEnd { function, .. }), Some(place)) => {
                    diagnostic.with_label(place, LabelText::EndsHere { function })
                }
                _ => diagnostic,
            });
        }
    }
}

/// The subprograms that no call leads to, by number.
fn uncalled(resolved: &Resolved) -> Vec<(u32, UnitId)> {
    let targets = resolved.files.iter().flat_map(|file| &file.targets);
    let called = targets.filter_map(|(_, target)| match target {
        Target::Unit(unit) => Some(*unit),
        Target::Block(_) => None,
    });
    let called: BTreeSet<UnitId> = called.collect();
    let subprograms = resolved.subprograms.iter().map(|(l, unit)| (*l, *unit));
    subprograms.filter(|(_, unit)| !called.contains(unit)).collect()
}
