//! The findings of a whole run over many programs, as they are rendered.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::Arc;

use super::{Code, Diagnostic, Findings, LIMIT_PER_SEVERITY, Severity};
use crate::text::{FileId, Location, SourceText, Sources};

/// A finding with the severity it has in this run.
#[derive(Clone, Debug)]
pub struct Reported {
    /// Its severity, the configured levels applied.
    pub severity: Severity,
    /// The finding; its places are in the report's sources.
    pub diagnostic: Diagnostic,
}

/// Findings and how many of them.
#[derive(Clone, Copy, Debug, Default)]
struct Count {
    found: usize,
    kept: usize,
}

/// The findings of all programs of a run, each code once at a place, in the order of output: by file, the files in the
/// order in which they were added, then by place, then by code. Bounded: of each severity [`LIMIT_PER_SEVERITY`] are
/// kept, the rest is counted.
#[derive(Debug, Default)]
pub struct Report {
    sources: Sources,
    by_name: BTreeMap<String, Vec<FileId>>,
    items: BTreeMap<(Location, Code), Reported>,
    errors: Count,
    warnings: Count,
    programs: usize,
}

impl Report {
    /// No programs, no findings.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds the findings of one program, as [`Self::add`] does, and counts the program.
    pub fn add_program(&mut self, sources: &Sources, findings: Findings, severity: impl Fn(Code) -> Option<Severity>) {
        self.programs += 1;
        self.add(sources, findings, severity);
    }

    /// Adds findings, whose places are in `sources`, with the severity that each code has in this run; those without
    /// one are allowed, and dropped. A file that another program led to already (same name, same text) is one file, and
    /// what was found in it before is not added again. Texts that no finding is in are not kept.
    pub fn add(&mut self, sources: &Sources, findings: Findings, severity: impl Fn(Code) -> Option<Severity>) {
        for (&code, &count) in findings.beyond_by_code() {
            if let Some(severity) = severity(code) {
                self.count_mut(severity).found += count;
            }
        }
        let shown: Vec<(Severity, Diagnostic)> = findings
            .into_sorted()
            .into_iter()
            .filter_map(|diagnostic| Some((severity(diagnostic.code())?, diagnostic)))
            .collect();
        let files = self.merge(sources, &shown);
        for (severity, mut diagnostic) in shown {
            move_to(&files, &mut diagnostic);
            self.add_one(severity, diagnostic);
        }
    }

    fn add_one(&mut self, severity: Severity, diagnostic: Diagnostic) {
        let Count { kept, .. } = *self.count_mut(severity);
        let Entry::Vacant(place) = self.items.entry((diagnostic.at, diagnostic.code())) else {
            return;
        };
        let keep = kept < LIMIT_PER_SEVERITY;
        if keep {
            place.insert(Reported { severity, diagnostic });
        }
        let count = self.count_mut(severity);
        count.found += 1;
        count.kept += usize::from(keep);
    }

    /// Takes over the texts that the findings are in; the number here of each file of `sources`.
    fn merge(&mut self, sources: &Sources, findings: &[(Severity, Diagnostic)]) -> BTreeMap<FileId, FileId> {
        let mut used: Vec<FileId> = findings.iter().flat_map(|(_, diagnostic)| files_of(diagnostic)).collect();
        used.sort_unstable();
        used.dedup();
        used.into_iter().filter_map(|id| Some((id, self.file(sources.get(id)?)))).collect()
    }

    /// The file of that name and text, added when it is not there yet.
    fn file(&mut self, source: &Arc<SourceText>) -> FileId {
        let known = self.by_name.entry(source.name().to_owned()).or_default();
        let same = known.iter().copied().find(|&id| {
            self.sources.get(id).is_some_and(|other| Arc::ptr_eq(other, source) || other.text() == source.text())
        });
        same.unwrap_or_else(|| {
            let id = self.sources.add(Arc::clone(source));
            known.push(id);
            id
        })
    }

    fn count_mut(&mut self, severity: Severity) -> &mut Count {
        match severity {
            Severity::Error => &mut self.errors,
            Severity::Warning => &mut self.warnings,
        }
    }

    /// The findings, in the order of output.
    pub fn items(&self) -> impl ExactSizeIterator<Item = &Reported> {
        self.items.values()
    }

    /// The texts that the findings are in.
    pub const fn sources(&self) -> &Sources {
        &self.sources
    }

    /// How many programs were checked.
    pub const fn programs(&self) -> usize {
        self.programs
    }

    /// How many errors there are, those that were not kept included.
    pub const fn errors(&self) -> usize {
        self.errors.found
    }

    /// How many warnings there are, those that were not kept included.
    pub const fn warnings(&self) -> usize {
        self.warnings.found
    }

    /// How many findings were counted, but not kept.
    pub const fn suppressed(&self) -> usize {
        self.errors.found + self.warnings.found - self.errors.kept - self.warnings.kept
    }
}

/// Every file that the finding has a place in.
fn files_of(diagnostic: &Diagnostic) -> impl Iterator<Item = FileId> + '_ {
    std::iter::once(diagnostic.at)
        .chain(diagnostic.labels.iter().map(|label| label.at))
        .chain(diagnostic.calls.iter().map(|call| call.at))
        .chain(diagnostic.fixes.iter().flat_map(|fix| fix.edits.iter().map(|edit| edit.at)))
        .map(|at| at.file)
}

/// Gives every place of the finding the number that its file has in `files`.
fn move_to(files: &BTreeMap<FileId, FileId>, diagnostic: &mut Diagnostic) {
    let edits = diagnostic.fixes.iter_mut().flat_map(|fix| fix.edits.iter_mut().map(|edit| &mut edit.at));
    let places = std::iter::once(&mut diagnostic.at)
        .chain(diagnostic.labels.iter_mut().map(|label| &mut label.at))
        .chain(diagnostic.calls.iter_mut().map(|call| &mut call.at))
        .chain(edits);
    for at in places {
        at.file = files.get(&at.file).copied().unwrap_or(FileId(u32::MAX));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Finding, LabelText};
    use crate::text::Span;

    fn sources(files: &[(&str, &str)]) -> Sources {
        let mut sources = Sources::new();
        for (name, text) in files {
            sources.add(SourceText::from_text(*name, *text));
        }
        sources
    }

    fn empty_block(file: u32, at: u32) -> Diagnostic {
        Diagnostic::new(Finding::EmptyBlock { block: 1 }, Location { file: FileId(file), span: Span::new(at, at + 1) })
    }

    fn findings(items: impl IntoIterator<Item = Diagnostic>) -> Findings {
        let mut findings = Findings::new();
        items.into_iter().for_each(|item| findings.add(item));
        findings
    }

    fn places(report: &Report) -> Vec<(String, u32)> {
        let name = |at: Location| report.sources().get(at.file).unwrap().name().to_owned();
        report.items().map(|item| (name(item.diagnostic.at), item.diagnostic.at.span.start)).collect()
    }

    /// diagnostics.md: findings sorted by file and place; a macrocycle reached from two programs is one file.
    #[test]
    fn programs_share_their_macrocycles() {
        let mut report = Report::new();
        let level = |code: Code| Some(code.severity());
        let first = sources(&[("a.nc", "%1 N10 N20"), ("L9001", "N1 G79 L9001 N2 N3 G70")]);
        report.add_program(&first, findings([empty_block(1, 13), empty_block(0, 7), empty_block(0, 3)]), level);
        let second = sources(&[("b.nc", "%2 N10"), ("L9002", "N1"), ("L9001", "N1 G79 L9001 N2 N3 G70")]);
        report.add_program(&second, findings([empty_block(2, 13), empty_block(2, 16), empty_block(0, 3)]), level);
        let expected = [("a.nc", 3), ("a.nc", 7), ("L9001", 13), ("L9001", 16), ("b.nc", 3)];
        assert_eq!(places(&report), expected.map(|(name, at)| (name.to_owned(), at)));
        assert_eq!((report.programs(), report.errors(), report.warnings(), report.suppressed()), (2, 0, 5, 0));
        assert_eq!(report.sources().iter().count(), 3, "texts without findings are not kept");
    }

    #[test]
    fn a_file_that_changed_during_the_run_is_another_file() {
        let mut report = Report::new();
        report.add_program(&sources(&[("a.nc", "N1")]), findings([empty_block(0, 0)]), |code| Some(code.severity()));
        report.add_program(&sources(&[("a.nc", "N2")]), findings([empty_block(0, 0)]), |code| Some(code.severity()));
        assert_eq!(report.items().count(), 2);
    }

    #[test]
    fn severities_of_the_run() {
        let files = sources(&[("a.nc", "N1 N2")]);
        let found = || findings([empty_block(0, 0), Diagnostic::new(Finding::TextAfterEnd {}, empty_block(0, 3).at)]);
        let mut report = Report::new();
        report.add(&files, found(), |code| (code != Code::W0110).then_some(Severity::Error));
        assert_eq!((report.programs(), report.errors(), report.warnings()), (0, 1, 0));
        assert!(report.items().all(|item| item.severity == Severity::Error));
    }

    #[test]
    fn labels_calls_and_edits_move_with_their_files() {
        let files = sources(&[("a.nc", "N1 N2"), ("unused", ""), ("L5", "N7")]);
        let label = Location { file: FileId(2), span: Span::new(0, 1) };
        let mut report = Report::new();
        report
            .add(&files, findings([empty_block(0, 0).with_label(label, LabelText::First)]), |_| Some(Severity::Error));
        let item = report.items().next().unwrap();
        assert_eq!(report.sources().get(item.diagnostic.labels[0].at.file).unwrap().name(), "L5");
    }

    /// The number of findings is bounded in a run as in a program; what is left out is counted, by its level.
    #[test]
    fn bounded() {
        let files = sources(&[("a.nc", "N1")]);
        let many = |from: u32| findings((from..from + 10_005).map(|at| empty_block(0, at)));
        let mut report = Report::new();
        report.add(&files, many(0), |_| Some(Severity::Error));
        report.add(&files, many(10_000), |_| Some(Severity::Error));
        report.add(&files, many(0), |_| None);
        assert_eq!(report.items().count(), LIMIT_PER_SEVERITY);
        assert_eq!((report.errors(), report.warnings(), report.suppressed()), (20_010, 0, 10_010));
    }
}
