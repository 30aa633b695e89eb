//! What can be reported only when all calls have been followed.

use std::collections::BTreeMap;

use super::MacrocycleFault;
use super::structure::Context;
use super::targets::{Namesake, macrocycle_finding, report_of_machine};
use crate::diag::{Diagnostic, EarlyEnd, Finding, LabelText};
use crate::syntax::{BlockFlags, BlockId};
use crate::text::Location;

/// Findings that depend on the calls.
#[derive(Debug, Default)]
pub(super) struct Pending {
    /// Runs of blocks after the end of the main program that are in no subprogram, in the order of the text.
    pub(super) strays: Vec<Stray>,
    /// Macrocycles that are called and cannot be loaded, by number.
    missing: BTreeMap<u32, Missing>,
    /// The end of the main program, where blocks that follow it hold another one.
    early: Option<(EarlyEnd, Location)>,
    /// Macrocycles that only the machine has, each at its first call (FLW-12).
    of_machine: Vec<(u32, Location)>,
}

/// A run of blocks in no unit (PRG-2).
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

impl Pending {
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

    /// The run of blocks that is subprogram `l` without its G79, and whether it has been named before. It is not reported
    /// by itself then.
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
        if fault == MacrocycleFault::OfMachine {
            if self.of_machine.iter().all(|(known, _)| *known != l) {
                self.of_machine.push((l, at));
            }
            return;
        }
        self.missing.entry(l).or_insert(Missing { at, fault, namesake, calls: 0 }).calls += 1;
    }
}

impl Context<'_, '_> {
    /// Reports what was waiting for the calls.
    pub(super) fn report_pending(&mut self) {
        let Pending { strays, missing, mut early, of_machine } = std::mem::take(&mut self.pending);
        for stray in strays.into_iter().filter(|stray| stray.meant.is_none()) {
            let (early, place) = early.take().unzip();
            let diagnostic = Diagnostic::new(Finding::BlockAfterProgramEnd { block: stray.block, early }, stray.at);
            self.findings.add(match (early, place) {
                (Some(EarlyEnd { function, .. }), Some(place)) => {
                    diagnostic.with_label(place, LabelText::EndsHere { function })
                }
                _ => diagnostic,
            });
        }
        for (l, Missing { at, fault, namesake, calls }) in missing {
            self.findings.add(Diagnostic::new(macrocycle_finding(fault, l, namesake, calls), at));
        }
        for (l, at) in of_machine {
            let call = Diagnostic::new(macrocycle_finding(MacrocycleFault::OfMachine, l, Namesake::default(), 1), at);
            report_of_machine(self.findings, l, call);
        }
    }
}
