//! The checks of all blocks of a file, on all cores when it is long.

use std::ops::Range;

use super::Unit;
use super::blocks::BlockChecker;
use super::judged::Judged;
use super::letters::Letters;
use super::lines;
use super::numbers::number_blocks;
use crate::config::Settings;
use crate::diag::Findings;
use crate::parallel;
use crate::syntax::{BlockId, ParsedFile};

/// Longer files are checked in parts of so many blocks, on all cores.
const SIDE_BY_SIDE: u32 = 1 << 14;

/// What the look at all blocks of a file gave.
#[derive(Default)]
pub(super) struct Checked {
    pub(super) findings: Findings,
    pub(super) judged: Judged,
    /// The first block of each number that jumps can reach, by number.
    pub(super) reachable: Vec<(u32, BlockId)>,
    /// The blocks that are two: a line of each lacks its block number.
    pub(super) merged: Vec<BlockId>,
}

impl Checked {
    fn append(&mut self, other: Self) {
        self.findings.append(other.findings);
        self.judged.append(other.judged);
    }
}

/// Checks every block of a file whose units are those, also blocks of no unit, numbers them, and looks at their lines. All
/// look at the whole file: the one beside the other in a long one. `excused`: blocks with M02 or M30 that are part of
/// another finding.
pub(super) fn look_at_blocks(
    settings: &Settings,
    parsed: &ParsedFile,
    units: &[Unit],
    letters: &Letters,
    excused: &[BlockId],
) -> Checked {
    let check = || check_blocks(settings, parsed, units, letters, excused);
    let layout = || (number_blocks(parsed), lines::check(parsed, units));
    let long = parsed.block_count() > SIDE_BY_SIDE;
    let (mut checked, (numbered, mut findings)) =
        if long { parallel::join(check, layout) } else { (check(), layout()) };
    checked.merged = lines::join_conflicts(parsed, excused, &mut findings, &mut checked.findings);
    checked.findings.append(numbered.findings);
    checked.findings.append(findings);
    checked.reachable = numbered.reachable;
    checked
}

fn check_blocks(
    settings: &Settings,
    parsed: &ParsedFile,
    units: &[Unit],
    letters: &Letters,
    excused: &[BlockId],
) -> Checked {
    let check = |blocks: Range<u32>| {
        let mut findings = Findings::new();
        let mut checker = BlockChecker::new(settings, parsed, letters, &mut findings);
        checker.units = units;
        let mut units = units.iter().peekable();
        for block in blocks.map(BlockId) {
            while units.next_if(|unit| unit.end <= block).is_some() {}
            let unit = units.peek().filter(|unit| unit.contains(block)).map(|unit| unit.kind);
            checker.check(block, unit.filter(|_| !excused.contains(&block)));
        }
        let judged = checker.finish();
        Checked { findings, judged, ..Checked::default() }
    };
    let count = parsed.block_count();
    if count <= SIDE_BY_SIDE {
        return check(0..count);
    }
    let parts = count.div_ceil(SIDE_BY_SIDE);
    let part = |part: u32| part * SIDE_BY_SIDE..count.min((part + 1) * SIDE_BY_SIDE);
    let found: Vec<Checked> = parallel::map((0..parts).collect(), |at| check(part(at)));
    let mut checked = Checked::default();
    found.into_iter().for_each(|part| checked.append(part));
    checked
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::sync::Arc;

    use super::*;
    use crate::resolve::{Library, resolve_program};
    use crate::text::{MemoryLoader, SourceText, Sources};

    /// Parts of a long file that are checked side by side leave no block out and check none twice.
    #[test]
    fn every_block_of_a_long_file_is_checked() {
        let faulty = [1, 2, SIDE_BY_SIDE, SIDE_BY_SIDE + 1, 2 * SIDE_BY_SIDE, 2 * SIDE_BY_SIDE + 1, 3 * SIDE_BY_SIDE];
        let block = |n: u32| format!("N{n} {}\n", if faulty.contains(&n) { "X99999" } else { "X1" });
        for last in [2 * SIDE_BY_SIDE - 1, 2 * SIDE_BY_SIDE, 3 * SIDE_BY_SIDE + 1] {
            let body: String = (1..=last).map(block).collect();
            let text = format!("%1\n{body}N{} M30\n", last + 1);
            let source = Arc::new(SourceText::from_text("t.nc", text));
            let (loader, settings) = (MemoryLoader::new(), Settings::default());
            let mut library = Library::new(&loader, &settings.macrocycles, Path::new("t.nc"));
            let (mut sources, mut findings) = (Sources::new(), Findings::new());
            resolve_program(&source, &settings, &mut library, &mut sources, &mut findings);
            let lines: Vec<u32> =
                findings.items().iter().map(|found| source.line_column(found.at.span.start).line - 1).collect();
            let expected: Vec<u32> = faulty.into_iter().filter(|n| *n <= last).collect();
            assert_eq!(lines, expected, "{last}");
        }
    }
}
