//! The findings of a run, bounded in number.

use std::collections::{BTreeMap, HashSet};

use super::{Code, Diagnostic, Severity};
use crate::text::Location;

/// How many errors and how many warnings are kept; the rest is counted.
pub const LIMIT_PER_SEVERITY: usize = 10_000;

/// Collects findings: each code once at a place, a bounded number of each severity, the rest counted.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    items: Vec<Diagnostic>,
    seen: HashSet<(Code, Location)>,
    kept_errors: usize,
    kept_warnings: usize,
    beyond: BTreeMap<Code, usize>,
}

impl Findings {
    /// None yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a finding, unless the same code was found at the same place (a subprogram executed many times).
    pub fn add(&mut self, diagnostic: Diagnostic) {
        let key = (diagnostic.code(), diagnostic.at);
        let kept = match key.0.severity() {
            Severity::Error => &mut self.kept_errors,
            Severity::Warning => &mut self.kept_warnings,
        };
        if *kept < LIMIT_PER_SEVERITY {
            if self.seen.insert(key) {
                *kept += 1;
                self.items.push(diagnostic);
            }
        } else if !self.seen.contains(&key) {
            *self.beyond.entry(key.0).or_default() += 1;
        }
    }

    /// Adds all findings of another collection.
    pub fn append(&mut self, other: Self) {
        for diagnostic in other.items {
            self.add(diagnostic);
        }
        for (code, count) in other.beyond {
            *self.beyond.entry(code).or_default() += count;
        }
    }

    /// Whether a finding that is an error by default is among them.
    pub fn has_errors(&self) -> bool {
        self.kept_errors > 0
    }

    /// How many findings are errors by default.
    pub fn error_count(&self) -> usize {
        // Asked after every executed block, and hardly ever is there anything beyond.
        if self.beyond.is_empty() { self.kept_errors } else { self.kept_errors + self.beyond().0 }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Those kept so far, in the order found.
    pub fn items(&self) -> &[Diagnostic] {
        &self.items
    }

    /// How many errors and warnings, by default level, were found beyond those kept.
    pub fn beyond(&self) -> (usize, usize) {
        let of =
            |severity| self.beyond.iter().filter(|(code, _)| code.severity() == severity).map(|(_, count)| count).sum();
        (of(Severity::Error), of(Severity::Warning))
    }

    /// How many findings of each code were found beyond those kept.
    pub const fn beyond_by_code(&self) -> &BTreeMap<Code, usize> {
        &self.beyond
    }

    /// The findings, sorted by file and place, then code.
    pub fn into_sorted(self) -> Vec<Diagnostic> {
        let mut items = self.items;
        items.sort_by_key(|diagnostic| (diagnostic.at, diagnostic.code()));
        items
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Finding;
    use crate::text::{FileId, Span};

    fn empty_block(at: u32) -> Diagnostic {
        Diagnostic::new(Finding::EmptyBlock { block: at }, Location { file: FileId(0), span: Span::new(at, at + 1) })
    }

    #[test]
    fn each_code_once_at_a_place() {
        let mut findings = Findings::new();
        findings.add(empty_block(3));
        findings.add(empty_block(3));
        assert_eq!(findings.items().len(), 1);
        assert!(!findings.has_errors());
    }

    #[test]
    fn what_is_not_kept_is_counted_by_code() {
        let mut findings = Findings::new();
        for at in 0..10_003 {
            findings.add(empty_block(at));
        }
        findings.add(empty_block(7));
        let mut all = Findings::new();
        all.append(findings);
        assert_eq!(all.items().len(), LIMIT_PER_SEVERITY);
        assert_eq!(all.beyond(), (0, 3));
        assert_eq!(all.beyond_by_code(), &BTreeMap::from([(Code::W0214, 3)]));
    }
}
