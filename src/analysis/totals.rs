//! Sums over the lengths of the motions.

use std::ops::ControlFlow;

use crate::diag::Findings;
use crate::dict::Micro;
use crate::run::{End, Executed, MotionType, Sink};

/// The path of a program: exact sums of lengths as the stream writes them.
#[derive(Clone, Debug, Default)]
pub struct Totals {
    path: Micro,
    by_type: [Option<Micro>; MotionType::ALL.len()],
}

impl Totals {
    /// Nothing moved yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds the motion of a block.
    pub fn add(&mut self, block: &Executed<'_>) {
        self.add_motion(block.motion().and_then(|motion| Some((motion.kind(), motion.length().mm()?))));
    }

    /// Adds a motion with its length in millimetres.
    pub fn add_motion(&mut self, motion: Option<(MotionType, Micro)>) {
        let Some((kind, length)) = motion else { return };
        self.path = self.path.plus(length);
        if let Some(sum) = self.by_type.get_mut(kind as usize) {
            *sum = Some(sum.unwrap_or_default().plus(length));
        }
    }

    /// The sum of all lengths in millimetres.
    pub const fn path(&self) -> Micro {
        self.path
    }

    /// The same by type of motion; without those that did not occur.
    pub fn by_type(&self) -> impl Iterator<Item = (MotionType, Micro)> {
        MotionType::ALL.into_iter().zip(self.by_type).filter_map(|(kind, sum)| Some((kind, sum?)))
    }
}

impl Sink for Totals {
    type Whole = Self;

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.add(block);
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) -> Self {
        self
    }
}
