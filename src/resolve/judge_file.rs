//! Judges the words of all blocks of a file, on all cores when it is long.

use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::OnceLock;

use super::axis_letters::AxisLetters;
use super::judge_block::BlockJudge;
use super::load::Context;
use super::numbers::{has_number_of_next, number_blocks};
use super::open_ends::OpenFile;
use super::points::Points;
use super::star::Star;
use super::unnumbered::Unnumbered;
use super::{Resolved, Unit};
use crate::config::Settings;
use crate::diag::{Diagnostic, Findings};
use crate::parallel;
use crate::sure::Sure;
use crate::syntax::{BlockId, ParsedFile, Word};
use crate::text::Location;

/// Longer files are judged in parts of so many blocks, on all cores.
const SIDE_BY_SIDE: u32 = 1 << 14;

/// The results of judging blocks.
#[derive(Default)]
pub(super) struct Judged {
    pub(super) findings: Findings,
    /// Where words begin whose values are not what their addresses take.
    pub(super) refused: Vec<u32>,
    /// Control words whose operation is not configured, by its code: each code is reported once for a program (PAR-9).
    pub(super) operations: Vec<(i64, Diagnostic)>,
    /// M functions without a meaning on this machine, by number: each is reported once for a program (TEC-8).
    pub(super) meaningless: Vec<(u8, Diagnostic)>,
    /// The first S under G97 that a speed of the spindle was probably meant by (W0116): reported once for a program.
    pub(super) cutting_speed: Option<Diagnostic>,
    /// L alone in a block, with its number: a macrocycle of that number was to be called.
    pub(super) lost_calls: Vec<(u32, Diagnostic)>,
    /// Blocks without words, each with the warning of it.
    pub(super) empty: Vec<(BlockId, Diagnostic)>,
    /// The warning that the block before the `*` is empty, which the `*` may explain.
    pub(super) at_star: Vec<Diagnostic>,
    /// Lines without their block number that conflict with those above, by where they begin, and their blocks, which
    /// are two each.
    pub(super) merged: Vec<(u32, BlockId)>,
    /// The facts about the points.
    pub(super) points: Points,
}

/// A file whose blocks are judged.
#[derive(Clone, Copy)]
pub(super) struct JudgedFile<'a> {
    pub(super) parsed: &'a ParsedFile,
    pub(super) units: &'a [Unit],
    /// The axes that the program uses.
    pub(super) letters: &'a AxisLetters,
    /// Blocks with M02 or M30 that are part of another finding.
    excused: &'a [BlockId],
    /// The words too many in blocks that begin subprograms (E0208).
    pub(super) crowded: &'a BTreeSet<Location>,
    /// The block whose words may come after the `*` that ends the file.
    pub(super) at_star: Option<BlockId>,
    /// Found at the first use.
    unnumbered: &'a OnceLock<Unnumbered>,
}

impl<'a> JudgedFile<'a> {
    /// The lines that lack their block number.
    pub(super) fn unnumbered(&self, settings: &Settings) -> &'a Unnumbered {
        self.unnumbered.get_or_init(|| Unnumbered::of(settings, self.parsed, self.units))
    }
}

impl Context<'_, '_> {
    /// Judges every block of a file, whose units are those from `units` on, also blocks of no unit, and adds the file.
    pub(super) fn add_judged(
        &mut self,
        resolved: &mut Resolved,
        mut parsed: ParsedFile,
        star: Option<Star>,
        units: usize,
        excused: &[BlockId],
    ) {
        let settings = self.settings;
        resolved.letters.read(&settings.machine, &parsed);
        let (letters, units) = (&resolved.letters, resolved.units.get(units..).sure());
        let (at_star, unnumbered) = (star.as_ref().and_then(Star::block), OnceLock::new());
        let (crowded, unnumbered) = (&self.open.crowded, &unnumbered);
        let file = JudgedFile { parsed: &parsed, units, letters, excused, crowded, at_star, unnumbered };
        let judge = || judge_blocks(settings, file);
        let layout = || {
            file.unnumbered(settings);
            number_blocks(&parsed)
        };
        let long = parsed.block_count() > SIDE_BY_SIDE;
        let (parts, numbered) = if long { parallel::join(judge, layout) } else { (judge(), layout()) };
        let lines = unnumbered.get().map(|unnumbered| unnumbered.usual.clone()).unwrap_or_default();
        let mut at_star = parsed.take_findings_at_star();
        let (mut points, mut told) = (Points::default(), Vec::new());
        for judged in parts {
            self.findings.append(judged.findings);
            let operations = judged.operations.into_iter();
            let operations = operations.filter(|(operation, _)| resolved.unknown_operations.insert(*operation));
            operations.for_each(|(_, diagnostic)| self.findings.add(diagnostic));
            let meaningless = judged.meaningless.into_iter().filter(|(m, _)| resolved.meaningless.insert(*m));
            meaningless.for_each(|(_, diagnostic)| self.findings.add(diagnostic));
            if let Some(speed) = judged.cutting_speed.filter(|_| !std::mem::replace(&mut resolved.cutting_speed, true))
            {
                self.findings.add(speed);
            }
            self.open.lost_calls.extend(judged.lost_calls);
            // An empty block whose number stands twice is not meant to be one: that has its finding.
            let is_new = |(block, _): &(BlockId, Diagnostic)| {
                numbered.repeated.binary_search(block).is_err() && !has_number_of_next(&parsed, *block)
            };
            judged.empty.into_iter().filter(is_new).for_each(|(_, warning)| self.findings.add(warning));
            told.extend(judged.merged.iter().map(|(start, _)| *start));
            at_star.extend(judged.at_star);
            points.join(judged.points);
            parsed.refuse(&judged.refused);
            parsed.mark_merged(judged.merged.iter().map(|(_, block)| *block));
        }
        self.findings.append(numbered.findings);
        let is_open = |(word, block): &(Word, BlockId)| {
            let other =
                told.binary_search(&word.start()).is_ok() || self.open.crowded.contains(&parsed.word_place(*word));
            !other && !excused.contains(block)
        };
        let unnumbered = lines.into_iter().filter(is_open).collect();
        self.open.files.push(OpenFile { file: parsed.file, at_star, unnumbered, told });
        resolved.add_file(parsed, star, numbered.reachable, points);
    }
}

fn judge_blocks(settings: &Settings, file: JudgedFile<'_>) -> Vec<Judged> {
    let judge = |blocks: Range<u32>| {
        let mut judge = BlockJudge::new(settings, file);
        if blocks.start == 0 {
            judge.judge_program_word();
        }
        let mut units = file.units.iter().peekable();
        for block in blocks.map(BlockId) {
            while units.next_if(|unit| unit.end <= block).is_some() {}
            let unit = units.peek().filter(|unit| unit.contains(block)).map(|unit| unit.kind);
            judge.judge(block, unit.filter(|_| !file.excused.contains(&block)));
        }
        judge.finish()
    };
    let count = file.parsed.block_count();
    if count <= SIDE_BY_SIDE {
        return vec![judge(0..count)];
    }
    let parts = count.div_ceil(SIDE_BY_SIDE);
    let part = |part: u32| part * SIDE_BY_SIDE..count.min((part + 1) * SIDE_BY_SIDE);
    parallel::map((0..parts).collect(), |at| judge(part(at)))
}

#[cfg(test)]
mod tests {
    use std::path::Path;
    use std::sync::Arc;

    use super::*;
    use crate::resolve::{Library, resolve};
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
            resolve(&source, None, &settings, &mut library, &mut sources, &mut findings);
            let lines: Vec<u32> =
                findings.items().iter().map(|found| source.line_column(found.at.span.start).line - 1).collect();
            let expected: Vec<u32> = faulty.into_iter().filter(|n| *n <= last).collect();
            assert_eq!(lines, expected, "{last}");
        }
    }
}
