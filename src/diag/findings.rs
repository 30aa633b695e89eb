//! The findings of a run, bounded in number.

use std::collections::{BTreeMap, HashSet};

use super::{Code, Diagnostic, Severity};
use crate::text::{FileId, LineIndex, Location};

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

    /// Keeps, of each line of a file, the first error, or the first warning when there is no error. What is beyond the limit
    /// is counted as if it were one a line.
    pub fn keep_one_a_line(&mut self, file: FileId, lines: &LineIndex) {
        let mut first: BTreeMap<usize, (Severity, Location, Code)> = BTreeMap::new();
        for item in self.items.iter().filter(|item| item.at.file == file) {
            let key = (item.code().severity(), item.at, item.code());
            let kept = first.entry(lines.line_at(item.at.span.start)).or_insert(key);
            *kept = key.min(*kept);
        }
        let mut room = lines.count().saturating_sub(first.len());
        let kept: HashSet<(Code, Location)> = first.into_values().map(|(_, at, code)| (code, at)).collect();
        let Self { items, beyond, .. } = std::mem::take(self);
        for item in items {
            if item.at.file != file || kept.contains(&(item.code(), item.at)) {
                self.add(item);
            }
        }
        for (code, count) in beyond {
            let counted = count.min(room);
            room -= counted;
            if counted > 0 {
                self.beyond.insert(code, counted);
            }
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
    use crate::text::Span;

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
    fn one_a_line() {
        let lines = LineIndex::new("0123456789\n0123456789\n0123456789", 0);
        let at = |at: u32| Location { file: FileId(0), span: Span::new(at, at + 1) };
        let mut findings = Findings::new();
        let mut elsewhere = empty_block(5);
        elsewhere.at.file = FileId(1);
        for found in [empty_block(12), empty_block(3), empty_block(1), elsewhere] {
            findings.add(found);
        }
        findings.add(Diagnostic::new(Finding::EndOutsideSubprogram {}, at(5)));
        findings.add(Diagnostic::new(Finding::EndOutsideSubprogram {}, at(15)));
        findings.add(Diagnostic::new(Finding::EndOutsideSubprogram {}, at(14)));
        findings.beyond.insert(Code::E0203, 1000);
        findings.keep_one_a_line(FileId(0), &lines);
        assert_eq!((findings.error_count(), findings.beyond()), (3, (1, 0)), "the third line may have one");
        let found: Vec<_> =
            findings.into_sorted().into_iter().map(|item| (item.at.file.0, item.at.span.start)).collect();
        assert_eq!(found, [(0, 5), (0, 14), (1, 5)]);
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
