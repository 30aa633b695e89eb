//! Programs of the workspace that are not open, as they were checked last.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex};

use gen_lsp_types::{Diagnostic, Uri};
use serde_json::Value;

/// Results of checking programs that are not open; copies share them.
#[derive(Clone, Debug, Default)]
pub(super) struct Checked {
    pub(super) known: Arc<Mutex<Known>>,
    /// Grows with every change of configuration and macrocycles.
    pub(super) environment: u64,
    /// Grows with every change of files, and with documents that are opened and closed.
    pub(super) files: u64,
}

/// The programs that were checked.
#[derive(Debug, Default)]
pub(super) struct Known {
    /// The changes of files that were seen.
    pub(super) seen: Option<u64>,
    /// Grows with every program that is checked.
    pub(super) revision: u64,
    pub(super) programs: BTreeMap<PathBuf, Program>,
}

/// One program, with what it was checked as, and its findings.
#[derive(Debug)]
pub(super) struct Program {
    pub(super) environment: u64,
    pub(super) text: u64,
    pub(super) uri: Uri,
    pub(super) id: String,
    pub(super) items: Value,
    /// The findings in macrocycles that it calls, by their files.
    pub(super) called: BTreeMap<Uri, Vec<Diagnostic>>,
}

impl Checked {
    /// Files changed; `environment`: among them what programs depend on.
    pub(super) const fn changed(&mut self, environment: bool) {
        self.files += 1;
        self.environment += environment as u64;
    }
}
