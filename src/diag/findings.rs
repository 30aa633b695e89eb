//! The findings of a run, bounded in number.

use std::collections::{BTreeMap, HashSet};

use super::{Code, Diagnostic, Finding, Fix, Levels, Severity, Unmodelled};
use crate::text::{FileId, LineIndex, Location};

/// How many findings of each code are kept for each file, unless [`Levels::keeping`] says otherwise; the rest is
/// counted.
pub const LIMIT_PER_CODE: usize = 10_000;

/// Collects findings at the levels of the run: each code once at a place, a bounded number of each code and file, the
/// rest counted. What is allowed is not a finding.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    levels: Levels,
    items: Vec<Diagnostic>,
    seen: HashSet<(Code, Location, u8)>,
    counts: BTreeMap<(FileId, Code), Count>,
    /// Those beyond the limit included.
    errors: usize,
    /// The errors of which [`Levels::is_fault`] holds.
    faults: usize,
    /// So many of those kept have been asked for what can be offered.
    asked: usize,
}

/// How many findings of one code are in one file.
#[derive(Clone, Copy, Debug, Default)]
struct Count {
    kept: usize,
    beyond: usize,
}

/// The macrocycles that a finding says only the machine has.
const fn of_machine(finding: &mut Finding) -> Option<&mut BTreeMap<u32, bool>> {
    let Finding::FunctionNotModelled { what: Unmodelled::Macrocycles(numbers) } = finding else { return None };
    Some(numbers)
}

impl Findings {
    /// None yet; codes have the levels of the registry.
    pub fn new() -> Self {
        Self::default()
    }

    /// None yet; codes have these levels.
    pub fn with_levels(levels: Levels) -> Self {
        Self { levels, ..Self::default() }
    }

    /// The level of each code.
    pub const fn levels(&self) -> &Levels {
        &self.levels
    }

    /// Gives the codes other levels, also in what was found so far: the configuration says them when it is read.
    pub fn set_levels(&mut self, levels: Levels) {
        let before = std::mem::replace(self, Self::with_levels(levels));
        self.append(before);
    }

    /// Adds a finding, unless it is allowed, or the same code was found at the same place (a subprogram executed many
    /// times).
    pub fn add(&mut self, diagnostic: Diagnostic) {
        let code = diagnostic.code();
        if self.levels.of(code).is_none() {
            return;
        }
        let key = (code, diagnostic.at, diagnostic.which());
        let count = self.counts.entry((diagnostic.at.file, code)).or_default();
        if count.kept < self.levels.kept() {
            if self.seen.insert(key) {
                count.kept += 1;
                self.items.push(diagnostic);
                self.count(code, 1);
            }
        } else if !self.seen.contains(&key) {
            count.beyond += 1;
            self.count(code, 1);
        }
    }

    /// Adds all findings of another collection.
    pub fn append(&mut self, other: Self) {
        for diagnostic in other.items {
            self.add(diagnostic);
        }
        for (key, Count { beyond, .. }) in other.counts {
            self.add_beyond(key, beyond);
        }
    }

    /// Adds a macrocycle that only the machine has, at a call of it: one finding names all of a program (FLW-12).
    pub fn add_of_machine(&mut self, call: Diagnostic) {
        let known = self.items.iter_mut().find_map(|found| of_machine(&mut found.finding));
        let Some(known) = known else { return self.add(call) };
        let Diagnostic { mut finding, .. } = call;
        known.extend(of_machine(&mut finding).map(std::mem::take).unwrap_or_default());
    }

    fn add_beyond(&mut self, key: (FileId, Code), beyond: usize) {
        if beyond > 0 && self.levels.of(key.1).is_some() {
            self.counts.entry(key).or_default().beyond += beyond;
            self.count(key.1, beyond);
        }
    }

    fn count(&mut self, code: Code, added: usize) {
        if self.levels.of(code) == Some(Severity::Error) {
            self.errors += added;
        }
        if self.levels.is_fault(code) {
            self.faults += added;
        }
    }

    /// Adds those of another collection, of each line of a file only the first error, or the first warning when it has
    /// no error. Those beyond the limit are counted as if they were one a line, errors first.
    pub fn append_one_a_line(&mut self, other: Self, file: FileId, lines: &LineIndex) {
        let severity = |code: Code| other.levels.of(code).unwrap_or(Severity::Warning);
        let mut first: BTreeMap<usize, (Severity, Location, Code)> = BTreeMap::new();
        for item in other.items.iter().filter(|item| item.at.file == file) {
            let key = (severity(item.code()), item.at, item.code());
            let kept = first.entry(lines.line_at(item.at.span.start)).or_insert(key);
            *kept = key.min(*kept);
        }
        let mut room = lines.count().saturating_sub(first.len());
        let kept: HashSet<(Code, Location)> = first.into_values().map(|(_, at, code)| (code, at)).collect();
        let mut beyond: Vec<_> = other.counts.iter().map(|(key, count)| (*key, count.beyond)).collect();
        beyond.sort_by_key(|((found_in, code), _)| (severity(*code), *found_in, *code));
        for item in other.items {
            if item.at.file != file || kept.contains(&(item.code(), item.at)) {
                self.add(item);
            }
        }
        for (key, count) in beyond {
            let counted = if key.0 == file { count.min(room) } else { count };
            if key.0 == file {
                room -= counted;
            }
            self.add_beyond(key, counted);
        }
    }

    /// Whether an error is among them, be it kept or only counted.
    pub const fn has_errors(&self) -> bool {
        self.errors > 0
    }

    /// How many are errors, those that are only counted included.
    pub const fn error_count(&self) -> usize {
        self.errors
    }

    /// How many are errors in this run and unless configured: a warning that is denied is an error that keeps nothing
    /// from being executed.
    pub const fn fault_count(&self) -> usize {
        self.faults
    }

    /// Whether one of them is an error of structure or flow.
    pub fn prevent_execution(&self) -> bool {
        self.counts.keys().any(|(_, code)| code.prevents_execution())
    }

    /// Whether there are none.
    pub const fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Those kept so far, in the order found. The first of each code is among them.
    pub fn items(&self) -> &[Diagnostic] {
        &self.items
    }

    /// Adds the changes that `make` offers to the findings that have no fix, at most so many; each finding is asked
    /// once.
    pub fn offer(&mut self, most: usize, mut make: impl FnMut(&Diagnostic) -> Vec<Fix>) {
        let from = std::mem::replace(&mut self.asked, self.items.len());
        let new = self.items.iter_mut().skip(from).filter(|diagnostic| diagnostic.fixes.is_empty());
        new.take(most).for_each(|diagnostic| diagnostic.fixes = make(diagnostic));
    }

    /// Whether a finding of that code is among them.
    pub fn has(&self, code: Code) -> bool {
        self.counts.keys().any(|(_, found)| *found == code)
    }

    /// How many findings of each code and file are only counted.
    pub fn beyond(&self) -> impl Iterator<Item = ((FileId, Code), usize)> + '_ {
        self.counts.iter().filter(|(_, count)| count.beyond > 0).map(|(key, count)| (*key, count.beyond))
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
        Diagnostic::new(
            Finding::EmptyBlock { block: at, function: None },
            Location { file: FileId(0), span: Span::new(at, at + 1) },
        )
    }

    #[test]
    fn each_code_once_at_a_place() {
        let mut findings = Findings::new();
        findings.add(empty_block(3));
        findings.add(empty_block(3));
        assert_eq!(findings.items().len(), 1);
        assert!(!findings.has_errors());
    }

    fn long_line(at: u32) -> Diagnostic {
        let at = Location { file: FileId(0), span: Span::new(at, at + 1) };
        Diagnostic::new(Finding::LineTooLong { length: 81 }, at)
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
        findings.add(Diagnostic::new(Finding::EndOutsideSubprogram { finishing: false }, at(5)));
        findings.add(Diagnostic::new(Finding::EndOutsideSubprogram { finishing: false }, at(15)));
        findings.add(Diagnostic::new(Finding::EndOutsideSubprogram { finishing: false }, at(14)));
        findings.add_beyond((FileId(0), Code::E0203), 1000);
        findings.add_beyond((FileId(1), Code::W0214), 7);
        let found = std::mem::take(&mut findings);
        findings.append_one_a_line(found, FileId(0), &lines);
        let beyond: Vec<_> = findings.beyond().collect();
        let expected = [((FileId(0), Code::E0203), 1), ((FileId(1), Code::W0214), 7)];
        assert_eq!((findings.error_count(), &beyond[..]), (3, &expected[..]), "the third line may have one");
        let found: Vec<_> =
            findings.into_sorted().into_iter().map(|item| (item.at.file.0, item.at.span.start)).collect();
        assert_eq!(found, [(0, 5), (0, 14), (1, 5)]);
    }

    /// A warning of this run, though an error unless configured, takes no place from an error of its line.
    #[test]
    fn one_a_line_by_the_levels_of_the_run() {
        let lines = LineIndex::new("0123456789", 0);
        let warn = Levels::new(|code| Some(if code == Code::E0109 { Severity::Warning } else { code.severity() }));
        let mut findings = Findings::with_levels(warn);
        findings.add(long_line(1));
        findings.add(Diagnostic::new(Finding::EndOutsideSubprogram { finishing: false }, empty_block(8).at));
        let found = std::mem::replace(&mut findings, Findings::with_levels(warn));
        findings.append_one_a_line(found, FileId(0), &lines);
        assert!(findings.has_errors());
        let codes: Vec<Code> = findings.items().iter().map(Diagnostic::code).collect();
        assert_eq!(codes, [Code::E0212]);
    }

    #[test]
    fn what_is_not_kept_is_counted_by_code_and_file() {
        let mut findings = Findings::new();
        for at in 0..10_003 {
            findings.add(empty_block(at));
        }
        findings.add(empty_block(7));
        findings.add(Diagnostic::new(Finding::EndOutsideSubprogram { finishing: false }, empty_block(20_000).at));
        let mut all = Findings::new();
        all.append(findings);
        assert_eq!(all.items().len(), LIMIT_PER_CODE + 1, "the first of each code is kept");
        assert_eq!(all.beyond().collect::<Vec<_>>(), [((FileId(0), Code::W0214), 3)]);
        assert_eq!((all.error_count(), all.fault_count()), (1, 1));
    }

    /// diagnostics.md: levels come before limits.
    #[test]
    fn levels_before_limits() {
        let denied = |code: Code| if code == Code::W0214 { Severity::Error } else { code.severity() };
        let levels = Levels::new(|code| (code != Code::E0109).then(|| denied(code)));
        let mut findings = Findings::with_levels(levels);
        for at in 0..10_003 {
            findings.add(long_line(at));
            findings.add(empty_block(at));
        }
        assert_eq!((findings.items().len(), findings.error_count()), (LIMIT_PER_CODE, 10_003));
        assert_eq!(findings.fault_count(), 0, "a warning that is denied");
        assert!(!findings.has(Code::E0109), "what is allowed is no finding");
        findings.set_levels(Levels::default());
        assert_eq!((findings.items().len(), findings.error_count()), (LIMIT_PER_CODE, 0));
        assert_eq!(findings.beyond().collect::<Vec<_>>(), [((FileId(0), Code::W0214), 3)]);
    }
}
