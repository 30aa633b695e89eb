//! Where a block stands, and where findings about it go.

use super::frames::Frame;
use crate::config::{Machine, Settings};
use crate::diag::{CallSite, Diagnostic, Finding, Findings};
use crate::resolve::Resolved;
use crate::syntax::{BlockId, ParsedFile, Word};
use crate::text::Location;

/// The current block in its file, on its machine; its findings carry the calls that led to it.
pub(super) struct Site<'e> {
    pub(super) resolved: &'e Resolved,
    pub(super) file: &'e ParsedFile,
    pub(super) block: BlockId,
    pub(super) settings: &'e Settings,
    pub(super) frames: &'e [Frame],
    pub(super) findings: &'e mut Findings,
}

impl<'e> Site<'e> {
    pub(super) const fn machine(&self) -> &'e Machine {
        &self.settings.machine
    }

    /// The block's `N`.
    pub(super) fn block_place(&self) -> Location {
        self.file.n_place(self.block)
    }

    pub(super) fn word_place(&self, word: Word) -> Location {
        self.file.word_place(word)
    }

    pub(super) fn value_place(&self, word: Word) -> Location {
        self.file.value_place(word)
    }

    /// Adds a finding.
    pub(super) fn found(&mut self, finding: Finding, at: Location) {
        self.report(Diagnostic::new(finding, at));
    }

    /// Adds a finding that says more than what and where.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        report(self.frames, diagnostic, self.findings);
    }
}

/// Adds a finding with the calls that led to the block.
pub(super) fn report(frames: &[Frame], mut diagnostic: Diagnostic, findings: &mut Findings) {
    diagnostic.calls = call_sites(frames);
    findings.add(diagnostic);
}

/// The calls that led to the block.
pub(super) fn call_sites(frames: &[Frame]) -> Vec<CallSite> {
    let calls = frames.iter().filter_map(|frame| frame.call);
    calls.map(|call| CallSite { by: call.by, l: call.l, n: call.n, at: call.at }).collect()
}
