//! The findings of a run, bounded in number.

use std::collections::HashSet;

use super::{Code, Diagnostic, Severity};
use crate::text::Location;

/// How many errors and how many warnings are kept; the rest is counted.
pub const LIMIT_PER_SEVERITY: usize = 10_000;

/// Collects findings: each code once at a place, a bounded number of each severity, the rest counted.
#[derive(Debug, Default)]
pub struct Findings {
    items: Vec<Diagnostic>,
    seen: HashSet<(Code, Location)>,
    errors: usize,
    warnings: usize,
    kept_errors: usize,
    kept_warnings: usize,
}

impl Findings {
    /// None yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a finding, unless the same code was found at the same place (a subprogram executed many times).
    pub fn add(&mut self, diagnostic: Diagnostic) {
        let error = diagnostic.code().severity() == Severity::Error;
        let kept = if error { &mut self.kept_errors } else { &mut self.kept_warnings };
        if *kept < LIMIT_PER_SEVERITY {
            if !self.seen.insert((diagnostic.code(), diagnostic.at)) {
                return;
            }
            *kept += 1;
            self.items.push(diagnostic);
        } else if self.seen.contains(&(diagnostic.code(), diagnostic.at)) {
            return;
        }
        *(if error { &mut self.errors } else { &mut self.warnings }) += 1;
    }

    /// Adds all findings of another collection.
    pub fn append(&mut self, other: Self) {
        let beyond = (other.errors - other.kept_errors, other.warnings - other.kept_warnings);
        for diagnostic in other.items {
            self.add(diagnostic);
        }
        self.errors += beyond.0;
        self.warnings += beyond.1;
    }

    /// Whether a finding that is an error by default is among them.
    pub const fn has_errors(&self) -> bool {
        self.errors > 0
    }

    /// How many findings are errors by default.
    pub const fn error_count(&self) -> usize {
        self.errors
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Those kept so far, in the order found.
    pub fn items(&self) -> &[Diagnostic] {
        &self.items
    }

    /// How many errors and warnings were found beyond those kept.
    pub const fn beyond(&self) -> (usize, usize) {
        (self.errors - self.kept_errors, self.warnings - self.kept_warnings)
    }

    /// The findings, sorted by file and place, then code.
    pub fn into_sorted(self) -> Vec<Diagnostic> {
        let mut items = self.items;
        items.sort_by_key(|diagnostic| (diagnostic.at, diagnostic.code()));
        items
    }
}
