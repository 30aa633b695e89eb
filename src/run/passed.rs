//! Points that were executed at once, as their readers see them.

use std::ops::Range;

use super::executed::Executed;
use super::interpreter::Stretch;
use super::moved::MotionType;
use super::state::{AxisSet, Position, State};
use super::travel::Reading;
use super::{Interpreter, Program};
use crate::config::Machine;
use crate::dict::{AxisLetter, Micro};
use crate::syntax::{BlockId, ParsedFile, Word};

/// Blocks that only move axes straight, and that were executed at once: see [`Interpreter::pass_over`].
#[derive(Clone, Copy, Debug)]
pub struct Passed<'r> {
    /// Behind them.
    pub(super) interpreter: &'r Interpreter,
    pub(super) program: &'r Program<'r>,
    pub(super) points: Points,
}

/// Which points, and from where they move: the same have the same path.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Points {
    pub(super) stretch: Stretch,
    pub(super) kind: MotionType,
    pub(super) reading: Reading,
    /// Before the first, by place in machine order.
    pub(super) positions: [Position; 9],
    /// The same, see [`State::unsettled`].
    pub(super) unsettled: AxisSet,
    /// The last block that moves each axis.
    pub(super) last: [Option<BlockId>; 9],
    /// The last block that writes the G00 or G01 in force again.
    pub(super) function: Option<BlockId>,
}

impl Passed<'_> {
    /// Which, and from where.
    pub const fn points(&self) -> &Points {
        &self.points
    }

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

    /// The last block that writes the G00 or G01 in force again.
    pub const fn function(&self) -> Option<BlockId> {
        self.points.function
    }

    /// Their path.
    pub fn path(&self) -> Option<PointPath<'_>> {
        let file = self.program.resolved.file(self.points.stretch.file)?;
        Some(PointPath { machine: self.machine(), file, points: self.points })
    }

    const fn machine(&self) -> &Machine {
        &self.program.settings.machine
    }
}

/// For each axis, by place in machine order, its last word in some points, and which block that is in;
/// `axes`: the only ones that there may be words of.
pub(super) fn last_words(
    file: &ParsedFile,
    machine: &Machine,
    blocks: Range<BlockId>,
    mut axes: AxisSet,
) -> [Option<(BlockId, Word)>; 9] {
    let mut last = [None; 9];
    for block in (blocks.start.0..blocks.end.0).rev().map(BlockId) {
        if axes.is_empty() {
            break;
        }
        for word in file.words(block) {
            let Some(axis) = machine.axes.index_of(word.address) else { continue };
            let Some(last @ None) = last.get_mut(axis) else { continue };
            *last = Some((block, *word));
            axes.remove(axis);
        }
    }
    last
}

/// The path of points that come one after the other.
#[derive(Clone, Copy, Debug)]
pub struct PointPath<'r> {
    machine: &'r Machine,
    file: &'r ParsedFile,
    points: Points,
}

impl PointPath<'_> {
    /// It in so many parts of about the same length, one behind the other.
    pub fn parts(self, count: u32) -> Vec<Self> {
        let (mut parts, mut rest) = (Vec::new(), self);
        for left in (2..=count).rev() {
            let Stretch { first, end, .. } = rest.points.stretch;
            let (part, behind) = rest.split(BlockId(first.0 + (end.0 - first.0).div_ceil(left)));
            parts.push(part);
            rest = behind;
        }
        parts.push(rest);
        parts
    }

    /// It up to a block, and from there on.
    fn split(self, at: BlockId) -> (Self, Self) {
        let (mut part, mut behind) = (self, self);
        part.points.stretch.end = at;
        let points = &mut behind.points;
        let moved = points.last.iter().enumerate().filter(|(_, last)| last.is_some()).map(|(axis, _)| axis).collect();
        let last = last_words(self.file, self.machine, points.stretch.first..at, moved);
        for (axis, (position, last)) in points.positions.iter_mut().zip(last).enumerate() {
            let Some((_, word)) = last else { continue };
            *position = points.reading.target(axis, word.number());
            points.unsettled.remove(axis);
        }
        points.stretch.first = at;
        (part, behind)
    }

    /// How long it is, the sum of what `Motion::length` gives for each in mm: linear axes alone count, and a motion
    /// whose start is not known, or not where the tool stands, has no length (MOT-2, MOT-6, MOT-8).
    pub fn length(self) -> Micro {
        let Points { stretch, reading, mut positions, mut unsettled, .. } = self.points;
        let (axes, mut length) = (&self.machine.axes, Micro::ZERO);
        let rotary: AxisSet = axes.iter().enumerate().filter(|(_, axis)| axis.rotary).map(|(at, _)| at).collect();
        for block in stretch.first.0..stretch.end.0 {
            let (mut squares, mut is_known) = (0.0, true);
            for word in self.file.words(BlockId(block)) {
                let Some(axis) = axes.index_of(word.address) else { continue };
                let Some(position) = positions.get_mut(axis) else { continue };
                let start = std::mem::replace(position, reading.target(axis, word.number()));
                is_known &= !unsettled.contains(axis);
                unsettled.remove(axis);
                if rotary.contains(axis) {
                    continue;
                }
                match (start, *position) {
                    (Position::Known(start), Position::Known(end)) => {
                        squares += end.minus(start).square();
                    }
                    _ => is_known = false,
                }
            }
            if is_known {
                length = length.plus(Micro::root(squares));
            }
        }
        length
    }
}
