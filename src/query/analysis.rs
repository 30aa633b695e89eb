//! Facts about a program or macrocycle before it is executed.

use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use super::state::Indexed;
use crate::config::Settings;
use crate::resolve::Resolved;
use crate::run::Sink;
use crate::session::{Record, Session};
use crate::text::{Loader, Sources};

/// A document and what it leads to, resolved. The document itself is file 0.
pub(crate) struct Analysis {
    /// Canonical.
    pub(crate) path: PathBuf,
    /// The files as they were.
    pub(crate) loader: Arc<dyn Loader + Send + Sync>,
    /// The configuration.
    pub(crate) settings: Settings,
    /// The texts.
    pub(crate) sources: Sources,
    /// Units, targets, blocks, words.
    pub(crate) resolved: Resolved,
    /// Whether the program can be executed, so that positions and values are known.
    pub(crate) executable: bool,
    /// Whether structure and flow have no errors, so that everything that is executed is known.
    pub(crate) certain: bool,
    /// What its execution left behind, once it is over.
    pub(crate) record: Arc<OnceLock<Record>>,
    /// What is kept to tell what holds at its blocks, once that was asked.
    pub(crate) state: Arc<OnceLock<Indexed>>,
}

impl Analysis {
    /// A session over the same files.
    pub(crate) fn session(&self) -> Session<'_> {
        Session { loader: self.loader.as_ref(), settings: &self.settings, progress: None }
    }

    /// The texts, with those of macrocycles that execution loaded, once it is over.
    pub(crate) fn all_sources(&self) -> &Sources {
        self.record.get().map_or(&self.sources, Record::sources)
    }

    /// Whether `name`, in its program, is another document.
    pub(crate) fn is(&self, name: &str, document: &Self) -> bool {
        self.loader.canonical(Path::new(name)) == document.path
    }

    /// Whether its execution, once it is over, has loaded the file of another document.
    pub(crate) fn has_executed(&self, document: &Self) -> bool {
        let mut loaded = self.record.get().into_iter().flat_map(|record| record.sources().iter());
        self.path != document.path && loaded.any(|(_, source)| self.is(source.name(), document))
    }

    /// Executes the program and shows every block to a sink.
    pub(crate) fn observe(&self, sink: impl Sink) {
        self.session().observe(&self.path, self.resolved.clone(), self.sources.clone(), sink);
    }
}

impl fmt::Debug for Analysis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Analysis").field("path", &self.path).finish_non_exhaustive()
    }
}
