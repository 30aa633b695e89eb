//! Who reads executed blocks.

use std::ops::ControlFlow;

use super::{End, Executed, Passed, Program};
use crate::diag::Findings;
use crate::syntax::BlockId;
use crate::text::FileId;

/// A reader of executed blocks. One execution may have several: a pair of sinks is a sink.
///
/// A sink sees the blocks of a program without errors, in the order of execution, up to the first that has one. What it
/// makes of a whole program it gives in [`Self::end`], which is called only when the program ended with M02 or M30 and
/// nothing in it is an error: half a program cannot be taken for a whole one.
pub trait Sink {
    /// The sink's result for a whole program.
    type Whole;

    /// Execution begins.
    fn begin(&mut self, _program: &Program<'_>) {}

    /// How many of the blocks that come next, from `next` on, need not be shown one by one where they are points: in a
    /// program without errors, [`Self::passed`] may show these together.
    fn spares(&self, _next: (FileId, BlockId)) -> u64 {
        0
    }

    /// The next executed blocks: points, none of which has a finding.
    fn passed(&mut self, _points: &Passed<'_>) {}

    /// The next executed block. Findings go to `findings`, those about this execution of the block made by
    /// [`Executed::found`]. `Break`: no more blocks are wanted, and the program is not taken for whole.
    fn block(&mut self, block: &Executed<'_>, findings: &mut Findings) -> ControlFlow<()>;

    /// The program ended, and has no errors.
    fn end(self, end: End, findings: &mut Findings) -> Self::Whole;
}

/// Nobody reads: what execution itself finds is wanted.
impl Sink for () {
    type Whole = End;

    fn block(&mut self, _: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        end
    }
}

/// Both read; when one wants no more, neither gets more.
impl<A: Sink, B: Sink> Sink for (A, B) {
    type Whole = (A::Whole, B::Whole);

    fn begin(&mut self, program: &Program<'_>) {
        self.0.begin(program);
        self.1.begin(program);
    }

    fn spares(&self, next: (FileId, BlockId)) -> u64 {
        self.0.spares(next).min(self.1.spares(next))
    }

    fn passed(&mut self, points: &Passed<'_>) {
        self.0.passed(points);
        self.1.passed(points);
    }

    fn block(&mut self, block: &Executed<'_>, findings: &mut Findings) -> ControlFlow<()> {
        self.0.block(block, findings)?;
        self.1.block(block, findings)
    }

    fn end(self, end: End, findings: &mut Findings) -> Self::Whole {
        (self.0.end(end, findings), self.1.end(end, findings))
    }
}
