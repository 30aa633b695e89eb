//! The findings of a whole run over many programs, as they are rendered.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Code, Diagnostic, Findings, LIMIT_PER_CODE, Severity};
use crate::dict::Lang;
use crate::text::{FileId, Location, SourceText, Sources};

/// A finding with the severity it has in this run.
#[derive(Clone, Debug)]
pub struct Reported {
    /// Its severity, the configured levels applied.
    pub severity: Severity,
    /// The finding; its places are in the report's sources.
    pub diagnostic: Diagnostic,
}

/// The findings of all programs of a run, each code once at a place, in the order of output: by file, the files in the
/// order in which they were added, then by place, then by code. Bounded: of each code [`LIMIT_PER_CODE`] are kept for
/// each file, the rest is counted. What is found in one file takes no place from another.
#[derive(Debug, Default)]
pub struct Report {
    sources: Sources,
    by_name: BTreeMap<String, Vec<FileId>>,
    items: BTreeMap<(Location, Code, u8), Reported>,
    counts: BTreeMap<(FileId, Code), Count>,
    files: Vec<String>,
    not_executed: Vec<NotExecuted>,
    stayed_unknown: Vec<StayedUnknown>,
    unusable: bool,
    fixed: bool,
}

/// Where positions are not known any more, because a call cannot be followed.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct StayedUnknown {
    /// The program, as the user named it.
    pub file: String,
    /// The number of the calling block.
    pub n: u32,
    /// The number that it calls, where that is known.
    pub l: Option<u32>,
    /// That does not exist.
    pub missing: bool,
}

impl StayedUnknown {
    /// In one sentence.
    pub fn text(&self, lang: Lang) -> String {
        let Self { n, l, missing, .. } = self;
        match (l, lang) {
            (Some(l), Lang::En) if *missing => format!("after N{n} positions are not known: L{l} is missing"),
            (Some(l), Lang::Cs) if *missing => format!("za N{n} nejsou známy polohy: chybí L{l}"),
            (_, Lang::En) => format!("after N{n} positions are not known: its call cannot be followed"),
            (_, Lang::Cs) => format!("za N{n} nejsou známy polohy: jeho volání nelze provést"),
        }
    }
}

/// A program that was not executed, so that what only execution finds is not known of it.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct NotExecuted {
    /// The program, as the user named it.
    pub file: String,
    /// The first finding that prevents it.
    pub code: Code,
    /// The line of that finding, from 1.
    pub line: u32,
    /// The macrocycle that it is in, when it is in one.
    pub macrocycle: Option<String>,
}

impl NotExecuted {
    /// Why, in one sentence.
    pub fn reason(&self, lang: Lang) -> String {
        let Self { code, line, macrocycle, .. } = self;
        let place = macrocycle.as_ref().map(|name| format!("{name}, ")).unwrap_or_default();
        match lang {
            Lang::En => format!(
                "{code} ({place}line {line}): arcs, feeds and calls by parameter are checked once it is corrected"
            ),
            Lang::Cs => {
                format!("{code} ({place}řádek {line}): oblouky, posuvy a volání parametrem se zkontrolují po opravě")
            }
        }
    }
}

/// How many findings of one code are in one file.
#[derive(Clone, Copy, Debug)]
struct Count {
    kept: usize,
    beyond: usize,
    /// Of those beyond.
    severity: Severity,
}

impl Report {
    /// No programs, no findings.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds the findings of one program, as [`Self::add`] does, and counts the program.
    pub fn add_program(&mut self, sources: &Sources, findings: Findings) {
        let name = sources.get(FileId(0)).map(|source| source.name().to_owned());
        self.files.push(name.unwrap_or_default());
        self.add(sources, findings);
    }

    /// Adds findings, whose places are in `sources`, at the levels that they have. A file that another program led to
    /// already (same name, same text) is one file; what was found in it before is not added again, and has the higher
    /// severity of the two. Texts that no finding is in are not kept.
    pub fn add(&mut self, sources: &Sources, findings: Findings) {
        let levels = *findings.levels();
        let beyond: Vec<_> = findings.beyond().collect();
        let found = findings.into_sorted();
        let files = self.merge(sources, &found);
        for mut diagnostic in found {
            let Some(severity) = levels.of(diagnostic.code()) else { continue };
            move_to(&files, &mut diagnostic);
            self.add_one(severity, diagnostic);
        }
        for ((file, code), beyond) in beyond {
            let (Some(&file), Some(severity)) = (files.get(&file), levels.of(code)) else { continue };
            let count = self.count(file, code, severity);
            count.severity = count.severity.min(severity);
            // What two programs lead to is counted once.
            count.beyond = count.beyond.max(beyond);
        }
    }

    fn count(&mut self, file: FileId, code: Code, severity: Severity) -> &mut Count {
        self.counts.entry((file, code)).or_insert(Count { kept: 0, beyond: 0, severity })
    }

    fn add_one(&mut self, severity: Severity, diagnostic: Diagnostic) {
        let key = (diagnostic.at, diagnostic.code(), diagnostic.which());
        if let Some(known) = self.items.get_mut(&key) {
            known.severity = known.severity.min(severity);
            return;
        }
        let count = self.count(key.0.file, key.1, severity);
        if count.kept < LIMIT_PER_CODE {
            count.kept += 1;
            self.items.insert(key, Reported { severity, diagnostic });
        } else {
            count.beyond += 1;
            count.severity = count.severity.min(severity);
        }
    }

    /// Takes over the texts that the findings are in; the number here of each file of `sources`.
    fn merge(&mut self, sources: &Sources, findings: &[Diagnostic]) -> BTreeMap<FileId, FileId> {
        let mut used: Vec<FileId> = findings.iter().flat_map(files_of).collect();
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
        self.files.len()
    }

    /// The programs that were checked, as the user named them.
    pub fn files(&self) -> &[String] {
        &self.files
    }

    /// How many errors there are, those that were not kept included.
    pub fn errors(&self) -> usize {
        self.of_severity(Severity::Error)
    }

    /// How many warnings there are, those that were not kept included.
    pub fn warnings(&self) -> usize {
        self.of_severity(Severity::Warning)
    }

    fn of_severity(&self, severity: Severity) -> usize {
        let kept = self.items.values().filter(|item| item.severity == severity).count();
        let beyond = self.counts.values().filter(|count| count.severity == severity).map(|count| count.beyond);
        kept + beyond.sum::<usize>()
    }

    /// How many findings of a code are kept for a file, and how many are only counted.
    pub fn of(&self, file: FileId, code: Code) -> (usize, usize) {
        self.counts.get(&(file, code)).map_or((0, 0), |count| (count.kept, count.beyond))
    }

    /// How many findings of a file are only counted.
    pub fn beyond(&self, file: FileId) -> usize {
        self.counts.iter().filter(|((found_in, _), _)| *found_in == file).map(|(_, count)| count.beyond).sum()
    }

    /// How many findings of each code there are, those that were not kept included.
    pub fn by_code(&self) -> BTreeMap<Code, usize> {
        let mut found = BTreeMap::new();
        for ((_, code), count) in &self.counts {
            *found.entry(*code).or_default() += count.kept + count.beyond;
        }
        found
    }

    /// Notes that a program was not executed.
    pub fn add_not_executed(&mut self, not_executed: NotExecuted) {
        self.not_executed.push(not_executed);
    }

    /// Notes what stayed unknown in a program.
    pub fn add_unknown(&mut self, unknown: StayedUnknown) {
        self.stayed_unknown.push(unknown);
    }

    /// The programs in which something stayed unknown.
    pub fn stayed_unknown(&self) -> &[StayedUnknown] {
        &self.stayed_unknown
    }

    /// The programs that were not executed.
    pub fn not_executed(&self) -> &[NotExecuted] {
        &self.not_executed
    }

    /// Notes that the run could not do what it was asked for: a file cannot be read, or the configuration is wrong.
    pub const fn set_unusable(&mut self) {
        self.unusable = true;
    }

    /// Notes that the run fixed what it may fix: nobody is advised to do it again.
    pub const fn set_fixed(&mut self) {
        self.fixed = true;
    }

    /// Whether the run fixed what it may fix.
    pub const fn is_fixed(&self) -> bool {
        self.fixed
    }

    /// Whether the run could not do what it was asked for.
    pub const fn is_unusable(&self) -> bool {
        self.unusable
    }

    /// How many findings were counted, but not kept.
    pub fn suppressed(&self) -> usize {
        self.counts.values().map(|count| count.beyond).sum()
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
    use crate::diag::{Finding, LabelText, Levels};
    use crate::text::Span;

    fn sources(files: &[(&str, &str)]) -> Sources {
        let mut sources = Sources::new();
        for (name, text) in files {
            sources.add(SourceText::from_text(*name, *text));
        }
        sources
    }

    fn empty_block(file: u32, at: u32) -> Diagnostic {
        Diagnostic::new(
            Finding::EmptyBlock { block: 1, function: None },
            Location { file: FileId(file), span: Span::new(at, at + 1) },
        )
    }

    fn findings(items: impl IntoIterator<Item = Diagnostic>) -> Findings {
        at_levels(Levels::default(), items)
    }

    fn at_levels(levels: Levels, items: impl IntoIterator<Item = Diagnostic>) -> Findings {
        let mut findings = Findings::with_levels(levels);
        items.into_iter().for_each(|item| findings.add(item));
        findings
    }

    fn all(severity: Severity) -> Levels {
        Levels::new(|_| Some(severity))
    }

    fn places(report: &Report) -> Vec<(String, u32)> {
        let name = |at: Location| report.sources().get(at.file).unwrap().name().to_owned();
        report.items().map(|item| (name(item.diagnostic.at), item.diagnostic.at.span.start)).collect()
    }

    /// diagnostics.md: findings sorted by file and place; a macrocycle reached from two programs is one file.
    #[test]
    fn programs_share_their_macrocycles() {
        let mut report = Report::new();
        let first = sources(&[("a.nc", "%1 N10 N20"), ("L9001", "N1 G79 L9001 N2 N3 G70")]);
        report.add_program(&first, findings([empty_block(1, 13), empty_block(0, 7), empty_block(0, 3)]));
        let second = sources(&[("b.nc", "%2 N10"), ("L9002", "N1"), ("L9001", "N1 G79 L9001 N2 N3 G70")]);
        report.add_program(&second, findings([empty_block(2, 13), empty_block(2, 16), empty_block(0, 3)]));
        let expected = [("a.nc", 3), ("a.nc", 7), ("L9001", 13), ("L9001", 16), ("b.nc", 3)];
        assert_eq!(places(&report), expected.map(|(name, at)| (name.to_owned(), at)));
        assert_eq!((report.programs(), report.errors(), report.warnings(), report.suppressed()), (2, 0, 5, 0));
        assert_eq!(report.sources().iter().count(), 3, "texts without findings are not kept");
    }

    /// diagnostics.md: a finding reached by two programs has the higher of its levels, whichever comes first.
    #[test]
    fn the_higher_level_of_two_programs() {
        let [warning, error] = [Severity::Warning, Severity::Error];
        for order in [[warning, error], [error, warning]] {
            let mut report = Report::new();
            for (severity, program) in order.into_iter().zip(["a.nc", "b.nc"]) {
                let files = sources(&[(program, ""), ("L9001", "N1 N2")]);
                report.add_program(&files, at_levels(all(severity), [empty_block(1, 3)]));
            }
            assert_eq!((report.errors(), report.warnings()), (1, 0), "{order:?}");
        }
    }

    #[test]
    fn a_file_that_changed_during_the_run_is_another_file() {
        let mut report = Report::new();
        report.add_program(&sources(&[("a.nc", "N1")]), findings([empty_block(0, 0)]));
        report.add_program(&sources(&[("a.nc", "N2")]), findings([empty_block(0, 0)]));
        assert_eq!(report.items().count(), 2);
    }

    #[test]
    fn severities_of_the_run() {
        let files = sources(&[("a.nc", "N1 N2")]);
        let text_after_end =
            Diagnostic::new(Finding::TextAfterEnd { meant: crate::diag::AfterEndMeant::Text }, empty_block(0, 3).at);
        let levels = Levels::new(|code| (code != Code::W0110).then_some(Severity::Error));
        let mut report = Report::new();
        report.add(&files, at_levels(levels, [empty_block(0, 0), text_after_end]));
        assert_eq!((report.programs(), report.errors(), report.warnings()), (0, 1, 0));
        assert!(report.items().all(|item| item.severity == Severity::Error));
    }

    #[test]
    fn labels_calls_and_edits_move_with_their_files() {
        let files = sources(&[("a.nc", "N1 N2"), ("unused", ""), ("L5", "N7")]);
        let label = Location { file: FileId(2), span: Span::new(0, 1) };
        let mut report = Report::new();
        report.add(&files, findings([empty_block(0, 0).with_label(label, LabelText::First { what: "X0".to_owned() })]));
        let item = report.items().next().unwrap();
        assert_eq!(report.sources().get(item.diagnostic.labels[0].at.file).unwrap().name(), "L5");
    }

    /// The number of findings of a code is bounded for each file; what is left out is counted, by its level. A file
    /// with many takes no place from the next, and a macrocycle of two programs is counted once.
    #[test]
    fn bounded() {
        let many = |file: u32| (0..10_005).map(move |at| empty_block(file, at));
        let mut report = Report::new();
        for program in ["a.nc", "b.nc"] {
            let files = sources(&[(program, "N1"), ("L9001", "N2")]);
            report.add(&files, at_levels(all(Severity::Error), many(1).chain(many(0))));
        }
        let kept = |name: &str| places(&report).iter().filter(|(file, _)| file == name).count();
        assert_eq!(["a.nc", "b.nc", "L9001"].map(kept), [LIMIT_PER_CODE; 3]);
        assert_eq!((report.errors(), report.warnings(), report.suppressed()), (30_015, 0, 15));
    }
}
