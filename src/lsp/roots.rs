//! Open documents with their results, and the runs that make these.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use lsp_server::{RequestId, ResponseError};
use serde_json::Value;

use super::analysis::{Analysis, Found, Progress};
use super::snapshot::Needs;
use crate::query::cancel::Cancel;

/// What threads report.
#[derive(Debug)]
pub(super) enum Event {
    /// A document is resolved.
    Analysed {
        /// Which run.
        run: Run,
        /// Its analysis.
        analysis: Arc<Analysis>,
        /// The files that it read.
        read: Vec<PathBuf>,
    },
    /// The findings so far.
    FoundSoFar {
        /// Which run.
        run: Run,
        /// Its findings.
        found: Found,
    },
    /// A run is over: with its findings, none when it was cancelled, or with the message of a panic.
    Finished {
        /// Which run.
        run: Run,
        /// Its findings.
        found: Result<Option<Found>, String>,
    },
    /// A request has its answer.
    Answered {
        /// Which.
        id: RequestId,
        /// The result as JSON, or why there is none.
        result: Result<String, ResponseError>,
    },
}

/// One run over one document.
#[derive(Clone, Debug, Eq, PartialEq)]
pub(super) struct Run {
    path: PathBuf,
    opening: u64,
    generation: u64,
}

impl Run {
    /// The document.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }
}

/// A request that is not answered yet.
#[derive(Debug)]
pub(super) struct Waiting {
    pub(super) id: RequestId,
    pub(super) method: String,
    pub(super) params: Value,
    pub(super) needs: Needs,
}

/// The state of the newest text of a document.
#[derive(Debug, Default)]
enum Known {
    /// Nothing; a run over it is to begin.
    #[default]
    Nothing,
    /// Nothing; a run is under way.
    Running,
    /// It is resolved; its findings are still to come.
    Resolved(Arc<Analysis>),
    /// Its findings; what is no program is not resolved.
    Judged(Option<Arc<Analysis>>, Arc<Found>),
    /// No more than this: the run failed.
    Failed(Option<Arc<Analysis>>),
}

/// An open document with its results.
#[derive(Debug, Default)]
pub(super) struct Root {
    /// Which opening of a document this is: one that is closed and opened again is another one.
    opening: u64,
    /// Grows with every change that may change what is found.
    generation: u64,
    known: Known,
    running: Cancel,
    /// The files of the last run: a change of one of them makes the results old.
    pub(super) read: Vec<PathBuf>,
    pub(super) waiting: Vec<Waiting>,
}

impl Root {
    /// The document is opened with a new text; `opening` differs from all others of the server.
    pub(super) fn open(&mut self, opening: u64) {
        self.opening = opening;
        self.touch();
    }

    /// Marks the results as old.
    pub(super) fn touch(&mut self) {
        self.generation += 1;
        self.running.cancel();
        self.known = Known::Nothing;
    }

    /// Begins a run, when one is to begin.
    pub(super) fn begin(&mut self, path: &Path) -> Option<(Run, Cancel)> {
        if !matches!(self.known, Known::Nothing) {
            return None;
        }
        self.known = Known::Running;
        self.running = Cancel::default();
        let run = Run { path: path.to_path_buf(), opening: self.opening, generation: self.generation };
        Some((run, self.running.clone()))
    }

    /// Nobody wants what a run would find.
    pub(super) fn cancel(&self) {
        self.running.cancel();
    }

    /// Whether nothing changed since a run began.
    pub(super) const fn is_newest(&self, run: &Run) -> bool {
        self.opening == run.opening && self.generation == run.generation
    }

    /// It is resolved.
    pub(super) fn resolved(&mut self, analysis: Arc<Analysis>) {
        self.known = Known::Resolved(analysis);
    }

    /// Its findings are known.
    pub(super) fn judged(&mut self, found: Arc<Found>) {
        self.known = Known::Judged(self.analysis().cloned(), found);
    }

    /// Its run failed.
    pub(super) fn failed(&mut self) {
        self.known = Known::Failed(self.analysis().cloned());
    }

    /// The program, once it is resolved.
    pub(super) const fn analysis(&self) -> Option<&Arc<Analysis>> {
        match &self.known {
            Known::Nothing | Known::Running => None,
            Known::Resolved(analysis) => Some(analysis),
            Known::Judged(analysis, _) | Known::Failed(analysis) => analysis.as_ref(),
        }
    }

    /// Its findings, once they are known.
    pub(super) const fn found(&self) -> Option<&Arc<Found>> {
        match &self.known {
            Known::Judged(_, found) => Some(found),
            Known::Nothing | Known::Running | Known::Resolved(_) | Known::Failed(_) => None,
        }
    }

    /// Whether the newest text is resolved, or cannot be.
    pub(super) const fn is_known(&self) -> bool {
        !matches!(self.known, Known::Nothing | Known::Running)
    }

    /// Whether its findings are known, or cannot be.
    pub(super) const fn is_judged(&self) -> bool {
        matches!(self.known, Known::Judged(..) | Known::Failed(_))
    }

    /// Takes the requests that have what they need. `everything`: all open documents are known; `judged`: those that
    /// lead here have their findings.
    pub(super) fn take_ready(&mut self, everything: bool, judged: bool) -> Vec<Waiting> {
        let (ready, waiting) = std::mem::take(&mut self.waiting).into_iter().partition(|waiting| match waiting.needs {
            Needs::Nothing => true,
            Needs::Analysis => self.is_known(),
            Needs::Everything | Needs::Blocks | Needs::Run => everything,
            Needs::Findings => self.is_judged() && (judged || waiting.method != "textDocument/diagnostic"),
        });
        self.waiting = waiting;
        ready
    }
}

/// Reports what a run gives on its way.
pub(super) struct Reporter {
    pub(super) run: Run,
    pub(super) events: crossbeam_channel::Sender<Event>,
}

impl Progress for Reporter {
    fn analysed(&self, analysis: Analysis, read: Vec<PathBuf>) {
        // Without a listener the server is at its end; so below.
        let _ = self.events.send(Event::Analysed { run: self.run.clone(), analysis: Arc::new(analysis), read });
    }

    fn found_so_far(&self, found: Found) {
        let _ = self.events.send(Event::FoundSoFar { run: self.run.clone(), found });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_document_opened_again_is_another_one() {
        let (mut first, mut second) = (Root::default(), Root::default());
        first.open(1);
        let (run, _) = first.begin(Path::new("a.nc")).unwrap();
        assert!(first.is_newest(&run));
        second.open(2);
        assert!(!second.is_newest(&run));
        first.touch();
        assert!(!first.is_newest(&run));
    }
}
