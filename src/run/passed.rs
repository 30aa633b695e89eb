//! Points that were executed at once, as their readers see them.

use super::executed::Executed;
use super::interpreter::Stretch;
use super::moved::MotionType;
use super::state::{AxisSet, Position, State};
use super::travel::Reading;
use super::{Interpreter, Program};
use crate::config::Machine;
use crate::dict::{AxisLetter, Micro};
use crate::syntax::BlockId;

/// Blocks that only move axes straight, and that were executed at once: see [`Interpreter::pass_over`].
#[derive(Clone, Copy, Debug)]
pub struct Passed<'r> {
    /// Behind them.
    pub(super) interpreter: &'r Interpreter,
    pub(super) program: &'r Program<'r>,
    pub(super) points: Points,
}

/// Which points, and from where they move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Points {
    pub(super) stretch: Stretch,
    pub(super) kind: MotionType,
    pub(super) reading: Reading,
    /// Before the first, by place in machine order.
    pub(super) positions: [Position; 9],
    /// The same, see [`State::unsettled`].
    pub(super) unsettled: AxisSet,
    /// The last block that moves each axis.
    pub(super) last: [Option<BlockId>; 9],
}

impl Passed<'_> {
    /// Which blocks.
    pub const fn stretch(&self) -> Stretch {
        self.points.stretch
    }

    /// Which executed block the first of them is.
    pub fn first_seq(&self) -> u64 {
        self.interpreter.executed - u64::from(self.points.stretch.count())
    }

    /// How they move.
    pub const fn kind(&self) -> MotionType {
        self.points.kind
    }

    /// The state behind them.
    pub const fn state(&self) -> &State {
        &self.interpreter.state
    }

    /// The block executed before them, which stands in the same unit.
    pub const fn before(&self) -> Executed<'_> {
        Executed { interpreter: self.interpreter, program: self.program }
    }

    /// The axes that they move, each with the last block that does.
    pub fn axes(&self) -> impl Iterator<Item = (AxisLetter, BlockId)> + '_ {
        let axes = self.machine().axes.iter().zip(self.points.last);
        axes.filter_map(|(axis, last)| Some((axis.letter, last?)))
    }

    /// How long their path is, the sum of what `Motion::length` gives for each in mm: linear axes alone count, and a
    /// motion whose start is not known, or not where the tool stands, has no length (MOT-2, MOT-6, MOT-8).
    pub fn path(&self) -> Micro {
        let Points { stretch, reading, mut positions, mut unsettled, .. } = self.points;
        let (machine, mut path) = (self.machine(), Micro::ZERO);
        let Some(file) = self.program.resolved.file(stretch.file) else { return path };
        let rotary: AxisSet =
            machine.axes.iter().enumerate().filter(|(_, axis)| axis.rotary).map(|(at, _)| at).collect();
        for block in stretch.first.0..stretch.end.0 {
            let (mut squares, mut is_known) = (0.0, true);
            for word in file.words(BlockId(block)) {
                let Some(axis) = machine.axes.index_of(word.address) else { continue };
                let Some(position) = positions.get_mut(axis) else { continue };
                let start = std::mem::replace(position, reading.target(axis, word.number()));
                is_known &= !unsettled.contains(axis);
                unsettled.remove(axis);
                if rotary.contains(axis) {
                    continue;
                }
                match (start, *position) {
                    (Position::Known(start), Position::Known(end)) => {
                        let distance = end.minus(start).to_f64();
                        squares += distance * distance;
                    }
                    _ => is_known = false,
                }
            }
            if is_known {
                path = path.plus(Micro::from_f64(squares.sqrt()));
            }
        }
        path
    }

    const fn machine(&self) -> &Machine {
        &self.program.settings.machine
    }
}
