//! What people see of many findings of one kind: the first of each code and file, and how many more there are.

use std::collections::BTreeMap;

use crate::diag::{Code, Report, Reported};
use crate::text::FileId;

/// So many findings of one code in one file are shown.
const SHOWN: usize = 20;

/// A part of what is shown.
pub(super) enum Part<'a> {
    /// A finding.
    Finding(&'a Reported),
    /// Findings of one code in one file that are not shown; behind the last that is.
    More(More),
}

/// Findings of one code in one file that are not shown.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) struct More {
    pub(super) file: FileId,
    pub(super) code: Code,
    /// How many.
    pub(super) count: usize,
    /// How many of them are only counted, and are shown by nothing.
    pub(super) counted: usize,
}

/// The findings in the order of output, of each code and file the first, or `all` that are kept. What is left out of a
/// file is counted behind its findings.
pub(super) fn parts(report: &Report, all: bool) -> Vec<Part<'_>> {
    let limit = if all { usize::MAX } else { SHOWN };
    let mut parts = Vec::new();
    let mut items = report.items().peekable();
    while let Some(item) = items.next() {
        let file = item.diagnostic.file();
        let mut shown: BTreeMap<Code, usize> = BTreeMap::new();
        let of_file =
            std::iter::once(item).chain(std::iter::from_fn(|| items.next_if(|item| item.diagnostic.file() == file)));
        for item in of_file {
            let count = shown.entry(item.diagnostic.code()).or_default();
            if *count < limit {
                *count += 1;
                parts.push(Part::Finding(item));
            }
        }
        for (code, shown) in shown {
            let (kept, counted) = report.of(file, code);
            let count = kept + counted - shown;
            if count > 0 {
                parts.push(Part::More(More { file, code, count, counted }));
            }
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::render::samples;

    #[test]
    fn the_first_of_many() {
        for (count, all, shown, more) in [
            (20, false, 20, None),
            (21, false, 20, Some((1, 0))),
            (21, true, 21, None),
            (10_003, false, 20, Some((9983, 3))),
            (10_003, true, 10_000, Some((3, 3))),
        ] {
            let report = samples::many(count);
            let parts = parts(&report, all);
            let findings = parts.iter().filter(|part| matches!(part, Part::Finding(_))).count();
            let last = parts.last().and_then(|part| match part {
                Part::More(more) => Some((more.count, more.counted)),
                Part::Finding(_) => None,
            });
            assert_eq!((findings, last), (shown, more), "{count} {all}");
        }
    }
}
