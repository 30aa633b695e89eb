//! Checkpoints of one execution, and the order of its blocks: the state at any block needs only a replay from the
//! checkpoint before it.

use std::ops::{ControlFlow, Range};

use super::errors::Errors;
use super::follow::{Follow, Lengths, Next, Tally};
use super::found::Found;
use super::place::Arrival;
use crate::config::Settings;
use crate::diag::Findings;
use crate::run::{End, Executed, Interpreter, Passed, Program, Sink, Stretch};
use crate::syntax::BlockId;
use crate::text::FileId;

/// Executed blocks between two checkpoints.
const STRIDE: u64 = if cfg!(fuzzing) { 2 } else { 1 << 12 };

/// Blocks of a file that were executed one after the other.
#[derive(Clone, Copy, Debug)]
struct Row {
    /// The first of them, as execution counts.
    seq: u32,
    file: FileId,
    first: BlockId,
}

/// The execution from one checkpoint up to the next.
#[derive(Clone, Debug)]
struct Part {
    from: Interpreter,
    known: Follow,
    next: Next,
}

/// An execution, of which at most so many blocks are kept.
#[derive(Debug)]
pub struct Index {
    rows: Vec<Row>,
    parts: Vec<Part>,
    follow: Follow,
    errors: Errors,
    /// Execution came to its end without errors.
    whole: bool,
}

impl Index {
    /// Notes which block is executed next.
    fn go_on(&mut self, seq: u64, file: FileId, id: BlockId) {
        let goes_on = self.rows.last().is_some_and(|row| {
            row.file == file && u64::from(id.0) == u64::from(row.first.0) + (seq - u64::from(row.seq))
        });
        if !goes_on {
            self.rows.push(Row { seq: u32::try_from(seq).unwrap_or(u32::MAX), file, first: id });
        }
    }

    /// How many blocks were executed.
    pub fn executed(&self) -> u64 {
        self.follow.done().blocks
    }

    /// Whether an error stands before an executed block; `after`: or in it.
    pub fn has_error_before(&self, seq: u64, after: bool) -> bool {
        self.errors.first().is_some_and(|first| first < seq || after && first == seq)
    }

    /// The executions of a block, in their order.
    pub fn executions(&self, file: FileId, block: BlockId) -> impl Iterator<Item = u64> + '_ {
        let ends = self.rows.iter().skip(1).map(|row| u64::from(row.seq)).chain([self.executed()]);
        self.rows.iter().zip(ends).filter_map(move |(row, end)| {
            let ahead = block.0.checked_sub(row.first.0).filter(|_| row.file == file)?;
            let seq = u64::from(row.seq) + u64::from(ahead);
            (seq < end).then_some(seq)
        })
    }

    /// From where execution has to go on to come by some blocks, with what reads them from there: those of `seqs` up to
    /// the next checkpoint.
    pub fn from(&self, seqs: Range<u64>, after: bool) -> Option<(&Interpreter, Replay<'_>)> {
        let at = self.parts.partition_point(|part| part.from.executed() <= seqs.start).checked_sub(1)?;
        let part = self.parts.get(at).filter(|_| seqs.start < self.executed())?;
        let until = self.parts.get(at + 1).map_or(self.executed(), |next| next.from.executed());
        let follow = part.known.clone();
        let replay = Replay { index: self, at, follow, seqs, until, after, found: Vec::new() };
        Some((&part.from, replay))
    }

    /// The same for the calls that led to some executions of blocks, in their order, as far as they are in one part.
    pub fn arrivals_from<'s>(&self, seqs: &'s [u64]) -> Option<(&Interpreter, Arrivals<'s>)> {
        let first = *seqs.first()?;
        let at = self.parts.partition_point(|part| part.from.executed() <= first).checked_sub(1)?;
        let until = self.parts.get(at + 1).map_or(u64::MAX, |next| next.from.executed());
        let here = seqs.partition_point(|seq| *seq < until);
        let arrivals = Arrivals { seqs: seqs.get(..here)?, found: Vec::new() };
        self.parts.get(at).map(|part| (&part.from, arrivals))
    }
}

/// Makes an [`Index`] while a program is executed.
#[derive(Debug)]
pub struct Indexer {
    index: Index,
    lengths: Lengths,
    most: u64,
}

impl Indexer {
    /// For a program that is executed with these settings; blocks beyond `most` are not kept.
    pub fn new(settings: &Settings, most: u64) -> Self {
        let follow = Follow::new(settings);
        let (rows, parts, errors) = (Vec::new(), Vec::new(), Errors::default());
        let index = Index { rows, parts, follow, errors, whole: false };
        Self { index, lengths: Lengths::default(), most: most.min(u64::from(u32::MAX)) }
    }

    /// The index. `whole`: the program was executed to its end, without errors.
    pub fn finish(self, whole: bool) -> Index {
        Index { whole, ..self.index }
    }
}

impl Sink for &mut Indexer {
    type Whole = End;

    fn begin(&mut self, program: &Program<'_>) {
        let Index { parts, follow, .. } = &mut self.index;
        parts.push(Part { from: Interpreter::new(program), known: follow.clone(), next: Next::default() });
    }

    fn spares(&self, _: (FileId, BlockId)) -> u64 {
        let executed = self.index.executed();
        // Checkpoints follow blocks that are shown.
        let room = (STRIDE - executed % STRIDE).min(self.most.saturating_sub(executed));
        room.saturating_sub(1)
    }

    fn passed(&mut self, points: &Passed<'_>) {
        let Stretch { file, first, .. } = points.stretch();
        self.index.go_on(points.first_seq(), file, first);
        if let Some(part) = self.index.parts.last_mut() {
            part.next.look_at_points(points);
        }
        self.index.follow.pass_over(points, self.lengths.of(points));
    }

    fn block(&mut self, block: &Executed<'_>, findings: &mut Findings) -> ControlFlow<()> {
        let (seq, (file, id)) = (block.seq(), block.at());
        self.index.go_on(seq, file, id);
        let Index { parts, follow, errors, .. } = &mut self.index;
        errors.look(block, findings);
        if let Some(part) = parts.last_mut() {
            part.next.look(block, follow.done());
        }
        follow.arrive(block);
        follow.pass(block);
        let executed = seq + 1;
        if executed.is_multiple_of(STRIDE) {
            parts.push(Part { from: block.checkpoint(), known: follow.clone(), next: Next::default() });
        }
        if executed >= self.most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        end
    }
}

/// Reads the blocks from a checkpoint up to the next one, for some of them.
#[derive(Debug)]
pub struct Replay<'a> {
    index: &'a Index,
    /// Which part.
    at: usize,
    follow: Follow,
    seqs: Range<u64>,
    until: u64,
    after: bool,
    /// Each with what comes between it and the one behind it.
    found: Vec<(Found, Tally, Next)>,
}

impl Replay<'_> {
    /// What holds at the blocks.
    pub fn found(self) -> Vec<Found> {
        let Self { index, at, found, .. } = self;
        let later = index.parts.iter().skip(at + 1).map(|part| part.next);
        let mut next = later.fold(Next::default(), Next::or);
        let whole = |(mut found, done, own): (Found, Tally, Next)| {
            next = own.or(next);
            found.unknown.retain(|(letter, _)| index.follow.is_moved(*letter));
            found.add_left(done, next, index.follow.done());
            found.whole = index.whole;
            found
        };
        let mut all: Vec<Found> = found.into_iter().rev().map(whole).collect();
        all.reverse();
        all
    }

    fn keep(&mut self, block: &Executed<'_>) {
        if self.seqs.contains(&block.seq()) {
            let found = self.follow.found(block, self.after);
            self.found.push((found, self.follow.done(), Next::default()));
        }
    }
}

impl Sink for &mut Replay<'_> {
    type Whole = ();

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.follow.arrive(block);
        if !self.after {
            self.keep(block);
        }
        if let Some((.., next)) = self.found.last_mut() {
            next.look(block, self.follow.done());
        }
        self.follow.pass(block);
        if self.after {
            self.keep(block);
        }
        if block.seq() + 1 >= self.until { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn end(self, _: End, _: &mut Findings) {}
}

/// Notes the calls that led to some executed blocks.
#[derive(Debug)]
pub struct Arrivals<'s> {
    seqs: &'s [u64],
    found: Vec<Arrival>,
}

impl Arrivals<'_> {
    /// Where they are.
    pub fn found(self) -> Vec<Arrival> {
        self.found
    }
}

impl Sink for &mut Arrivals<'_> {
    type Whole = ();

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        if self.seqs.get(self.found.len()) == Some(&block.seq()) {
            self.found.push(Arrival::of(block));
        }
        if self.found.len() < self.seqs.len() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    fn end(self, _: End, _: &mut Findings) {}
}
