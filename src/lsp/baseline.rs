//! What is kept of a long straight program without findings, so that a change of a few blocks is judged by looking at those
//! alone.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::config::Settings;
use crate::diag::Findings;
use crate::dict::Address;
use crate::query::cursor::DOCUMENT;
use crate::resolve::Resolved;
use crate::run::{End, Executed, Program, Sink, State};
use crate::session::{Outcome, Session};
use crate::syntax::{BlockId, ParsedFile};
use crate::text::{Loader, SourceText, Span};

/// Programs with fewer blocks are checked anew as quickly. Fuzzing has short ones.
const LONG: u32 = if cfg!(fuzzing) { 6 } else { 20_000 };

/// Blocks between two marks. Fuzzing has short programs.
pub(super) const STRIDE: u64 = if cfg!(fuzzing) { 1 << 1 } else { 1 << 13 };

/// A place between two blocks.
#[derive(Debug)]
struct Mark {
    /// Where the block after it begins, in the text without findings.
    start: u32,
    /// The number of the block before it; 0 for none.
    before: u32,
    /// The number of the block after it.
    after: u32,
    known: State,
}

/// A program that has no findings, no calls, no jumps, and block numbers that rise, as it was then, and where it was changed
/// since: between two marks.
#[derive(Debug)]
pub(super) struct Baseline {
    settings: Arc<Settings>,
    marks: Vec<Mark>,
    /// Blocks that may still be added before a limit of the machine is reached.
    room: u64,
    changed: Option<Changed>,
}

/// The piece that was changed since the program had no findings.
#[derive(Clone, Copy, Debug)]
struct Changed {
    /// The marks around it.
    from: usize,
    to: usize,
    /// By how much it grew, in bytes.
    grown: i64,
}

/// What a look at the changed piece gave.
#[derive(Debug)]
pub(super) struct Seen {
    /// The findings, with places in the piece.
    pub(super) outcome: Outcome,
    /// The line of the document, from 0, that the piece begins with.
    pub(super) line: usize,
}

/// Takes the marks while a program is executed.
#[derive(Debug, Default)]
pub(super) struct Marker {
    marks: Vec<Mark>,
    lost: bool,
}

impl Marker {
    /// For a program that may become a baseline.
    pub(super) fn new(resolved: &Resolved) -> Self {
        let long = resolved.file(DOCUMENT).is_some_and(|file| file.block_count() >= LONG);
        Self { marks: Vec::new(), lost: !long || resolved.units().count() != 1 }
    }

    /// Marks the place before block `block`, where execution came by as many blocks as stand before it.
    fn mark(&mut self, file: &ParsedFile, block: BlockId, state: &State) {
        if block.0 >= file.block_count() {
            return;
        }
        let start = file.n_word(block).map_or(0, |word| word.start());
        let at_line = file.source.text().get(..start as usize).is_some_and(|text| text.ends_with(['\n', '\r']));
        let before = block.0.checked_sub(1).map(BlockId).map_or(Some(0), |block| file.number(block));
        match (before, file.number(block)) {
            (Some(before), Some(after)) if at_line => {
                self.marks.push(Mark { start, before, after, known: state.clone() });
            }
            _ => self.lost = true,
        }
    }

    /// The baseline, when the run found nothing.
    pub(super) fn finish(self, resolved: &Resolved, settings: &Settings, outcome: &Outcome) -> Option<Baseline> {
        let file = resolved.file(DOCUMENT)?;
        let blocks = u64::from(file.block_count());
        // How many lines begin with N decides whether others are findings (W0221).
        let lost = self.lost || resolved.has_continuing_lines();
        let straight = !lost && outcome.findings.is_empty() && outcome.executed == blocks;
        let rises = || {
            let mut numbers = file.block_ids().map(|block| file.number(block));
            let mut last = 0;
            numbers.all(|number| number.is_some_and(|number| std::mem::replace(&mut last, number) < number))
        };
        // Where a parameter got its value is a place, and places move.
        let assigns = || file.all_words().any(|word| word.address == Address::R);
        (straight && rises() && !assigns()).then(|| Baseline {
            settings: Arc::new(settings.clone()),
            marks: self.marks,
            room: settings.machine.limits.records.saturating_sub(blocks),
            changed: None,
        })
    }
}

impl Sink for &mut Marker {
    type Whole = ();

    fn begin(&mut self, program: &Program<'_>) {
        if let (false, Some(file)) = (self.lost, program.resolved.file(DOCUMENT)) {
            self.mark(file, BlockId(0), &State::new(program.settings));
        }
    }

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        let executed = block.seq() + 1;
        if !self.lost
            && executed.is_multiple_of(STRIDE)
            && let Some(file) = block.file()
        {
            let next = BlockId(u32::try_from(executed).unwrap_or(u32::MAX));
            // In a straight program as many blocks were executed as stand before.
            let (place, at) = block.at();
            self.lost = place != DOCUMENT || at.next() != next;
            if !self.lost {
                self.mark(file, next, block.state());
            }
        }
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) {}
}

impl Baseline {
    /// Follows a change: of the text before it, `replaced` became `inserted` bytes more. Whether the change lies between two
    /// marks, and all since the program had no findings between the same ones.
    fn follow(&mut self, replaced: Span, inserted: usize) -> bool {
        let Some(to) = (match self.changed {
            None => {
                let from = self.marks.partition_point(|mark| mark.start < replaced.start);
                let to = self.marks.partition_point(|mark| mark.start <= replaced.end);
                self.changed = from.checked_sub(1).map(|from| Changed { from, to, grown: 0 });
                self.changed.map(|changed| changed.to)
            }
            Some(changed) => Some(changed.to),
        }) else {
            return false;
        };
        let Some(changed) = &mut self.changed else { return false };
        let (Some(from), Some(to)) = (self.marks.get(changed.from), self.marks.get(to)) else { return false };
        let end = i64::from(to.start) + changed.grown;
        // The first letter and the last line end of the piece stay.
        let inside = from.start < replaced.start && i64::from(replaced.end) < end;
        changed.grown += i64::try_from(inserted).unwrap_or(i64::MAX) - i64::from(replaced.len());
        inside
    }

    /// Follows changes in a row, each as [`SourceText::replace`] took it, and looks at what they made of `source`. `None`
    /// when the whole program must be checked; the baseline is of no use then.
    pub(super) fn look(&mut self, changes: &[(Span, usize)], source: &SourceText, loader: &dyn Loader) -> Option<Seen> {
        if !changes.iter().all(|&(replaced, inserted)| self.follow(replaced, inserted)) {
            return None;
        }
        let changed = self.changed?;
        let (from, to) = (self.marks.get(changed.from)?, self.marks.get(changed.to)?);
        let end = u32::try_from(i64::from(to.start) + changed.grown).ok()?;
        let piece = source.slice(Span::new(from.start, end));
        if piece.is_empty() || piece.len() as u64 / 2 > self.room {
            return None;
        }
        let piece = Arc::new(SourceText::from_text(source.name(), piece));
        let session = Session { loader, settings: &self.settings, progress: None };
        let outcome = session.check_window(&piece, (from.before, to.after), &from.known, &to.known)?;
        let line = source.lines().line_at(from.start);
        if outcome.findings.is_empty() {
            self.settle();
        }
        Some(Seen { outcome, line })
    }

    /// The changed piece has no findings: the text as it is now is the one to compare with.
    fn settle(&mut self) {
        let Some(changed) = self.changed.take() else { return };
        for mark in self.marks.iter_mut().skip(changed.to) {
            mark.start = u32::try_from(i64::from(mark.start) + changed.grown).unwrap_or(u32::MAX);
        }
        // The marks within are of the text before.
        self.marks.drain(changed.from + 1..changed.to);
    }
}
