//! What holds at the blocks of a document when its program is executed.

use std::sync::OnceLock;

use super::analysis::Analysis;
use super::cancel::Cancel;
use super::observe::MOST;
use crate::analysis::state::{Arrival, Found, Index, Indexer, Timeline, TimelineReader, Timing};
use crate::config::Purpose;
use crate::resolve::Resolved;
use crate::session::Session;
use crate::sure::small;
use crate::syntax::BlockId;
use crate::text::{FileId, Sources};

/// Executions of a block that are listed.
const LISTED: usize = 20;

/// One execution of a program, kept so that any of its blocks is found in a moment.
#[derive(Debug)]
pub(crate) struct Indexed {
    index: Index,
    /// When its blocks end, once somebody asked.
    times: OnceLock<Timeline>,
    resolved: Resolved,
    sources: Sources,
}

/// How often a block is executed.
#[derive(Debug)]
pub(crate) enum Executions {
    /// Once.
    One(u64),
    /// Several times: the first of them, and how many.
    Several(Vec<Arrival>, u64),
    /// Never; `true`: as far as the program was executed, which is longer.
    Never(bool),
}

impl Indexed {
    /// That of a program, made when it is asked for first. `None` when the answer is not wanted any more.
    pub(crate) fn of<'a>(program: &'a Analysis, cancel: &Cancel) -> Option<&'a Self> {
        if program.state.get().is_none() {
            let indexed = Self::make(program, cancel)?;
            let _ = program.state.set(indexed);
        }
        program.state.get()
    }

    fn make(program: &Analysis, cancel: &Cancel) -> Option<Self> {
        let name = program.path.to_string_lossy();
        let goes_on = |_| !cancel.is_cancelled();
        let session = Session { progress: Some(&goes_on), ..program.session() };
        let mut execution = session.open(&program.path, &name, Purpose::Report).ok()?.despite_errors();
        let mut indexer = Indexer::new(&program.settings, MOST);
        execution.show(&mut &mut indexer);
        if cancel.is_cancelled() {
            return None;
        }
        let (resolved, sources) = (execution.program().resolved.clone(), execution.program().sources.clone());
        let whole = execution.finish().whole.is_some();
        Some(Self { index: indexer.finish(whole), times: OnceLock::new(), resolved, sources })
    }

    /// How many blocks were executed.
    pub(crate) fn executed(&self) -> u64 {
        self.index.executed()
    }

    /// The executions of a block of the document.
    pub(crate) fn executions(&self, program: &Analysis, document: &Analysis, block: BlockId) -> Executions {
        let cut = self.index.executed() >= MOST;
        let file = self.sources.iter().position(|(_, source)| program.is(source.name(), document));
        let Some(file) = file.map(|at| FileId(small(at))) else { return Executions::Never(cut) };
        let seqs: Vec<u64> = self.index.executions(file, block).collect();
        match seqs.as_slice() {
            [] => Executions::Never(cut),
            [seq] => Executions::One(*seq),
            seqs => Executions::Several(self.arrivals(program, seqs), seqs.len() as u64),
        }
    }

    /// How execution came to the first of some blocks.
    fn arrivals(&self, program: &Analysis, seqs: &[u64]) -> Vec<Arrival> {
        let mut left = seqs.get(..LISTED).unwrap_or(seqs);
        let mut found = Vec::new();
        while let Some((checkpoint, mut arrivals)) = self.index.arrivals_from(left) {
            let read = (&self.resolved, &self.sources);
            program.session().observe_from(&program.path, read, checkpoint, &mut arrivals);
            let arrived = arrivals.found();
            left = left.get(arrived.len()..).filter(|_| !arrived.is_empty()).unwrap_or_default();
            found.extend(arrived);
        }
        found
    }

    /// What holds before an executed block, or behind it. `None` as well when the answer is not wanted any more.
    pub(crate) fn at(&self, program: &Analysis, seq: u64, after: bool, cancel: &Cancel) -> Option<Found> {
        let (checkpoint, mut replay) = self.index.from(seq..seq + 1, after)?;
        let read = (&self.resolved, &self.sources);
        program.session().observe_from(&program.path, read, checkpoint, &mut replay);
        let mut found = replay.found().pop()?;
        if Timing::Configured.wants(&program.settings, self.executed()) {
            found.times = Some(self.timeline(program, cancel)?.around(found.blocks));
        }
        Some(found)
    }

    /// When its blocks end, planned when that is asked for first.
    fn timeline(&self, program: &Analysis, cancel: &Cancel) -> Option<&Timeline> {
        if self.times.get().is_none() {
            let goes_on = |_| !cancel.is_cancelled();
            let session = Session { progress: Some(&goes_on), ..program.session() };
            let mut reader = TimelineReader::new(&program.settings, self.executed());
            let (checkpoint, _) = self.index.from(0..1, false)?;
            session.observe_from(&program.path, (&self.resolved, &self.sources), checkpoint, &mut reader);
            let timeline = reader.finish();
            if cancel.is_cancelled() {
                return None;
            }
            let _ = self.times.set(timeline);
        }
        self.times.get()
    }

    /// Whether an error stands before an executed block; `after`: or in it.
    pub(crate) fn has_error_before(&self, seq: u64, after: bool) -> bool {
        self.index.has_error_before(seq, after)
    }
}
