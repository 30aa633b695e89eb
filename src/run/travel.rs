//! How axis words move their axes (MOT-1, MOT-2).

use super::block::InForce;
use super::state::{Position, State};
use super::words::{BlockWords, Valued};
use crate::config::{Axis, Machine};
use crate::dict::{AxisLetter, Decimal, GCode, GGroup, Micro};
use crate::syntax::Word;

/// How one axis moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Travel {
    /// Its place in machine order.
    pub(super) axis: usize,
    pub(super) definition: Axis,
    pub(super) before: Position,
    pub(super) after: Position,
    /// `None`: unknown.
    pub(super) distance: Option<Micro>,
    pub(super) incremental: bool,
    pub(super) word: Option<Word>,
}

/// How the values of axis words are read.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) struct Reading {
    /// G91.
    incremental: bool,
    /// The axis whose values are diameters: X under G74 (MOT-1).
    diameter: Option<usize>,
}

impl Reading {
    /// How the values of axes are read in a block where these functions hold.
    pub(super) fn of(machine: &Machine, state: &State, g: &InForce) -> Self {
        let incremental = g.of(GGroup::G9) == Some(GCode::G91);
        let diameters = state.modal(GGroup::G10) == Some(GCode::G74);
        let diameter = if diameters { machine.axes.index(AxisLetter::X) } else { None };
        Self { incremental, diameter }
    }

    /// Whether values are ways from where an axis stands.
    pub(super) const fn is_incremental(self) -> bool {
        self.incremental
    }

    /// Where an axis is after a word with that value, a coordinate. Without a value nobody knows (PAR-5).
    #[inline]
    pub(super) fn target(self, axis: usize, value: Option<Decimal>) -> Position {
        value.map_or(Position::Undetermined, |value| Position::Known(self.coordinate(axis, value)))
    }

    /// A programmed value as a coordinate.
    #[inline]
    pub(super) fn coordinate(self, axis: usize, value: Decimal) -> Micro {
        let value = Micro::from(value);
        if self.diameter == Some(axis) { value.half() } else { value }
    }

    /// How the axis words of a block move their axes. `travels` is reused for all blocks.
    pub(super) fn travels(self, machine: &Machine, state: &State, words: &BlockWords, travels: &mut Vec<Travel>) {
        travels.clear();
        for (axis, valued) in words.axis_words() {
            if let Some(travel) = self.travel(machine, state, axis, valued) {
                travels.push(travel);
            }
        }
    }

    /// How an axis word moves its axis from where the state has it.
    #[inline]
    pub(super) fn travel(self, machine: &Machine, state: &State, axis: usize, valued: Valued) -> Option<Travel> {
        let definition = machine.axes.get(axis)?;
        let before = state.position(axis);
        let incremental = self.incremental;
        let value = valued.value.map(|value| self.coordinate(axis, value));
        let (after, distance) = match (incremental, value, before) {
            (false, Some(target), Position::Known(start)) => (Position::Known(target), Some(target.minus(start))),
            (false, Some(target), _) => (Position::Known(target), None),
            (true, Some(distance), Position::Known(start)) => (Position::Known(start.plus(distance)), Some(distance)),
            (true, Some(distance), unknown) => (unknown, Some(distance)),
            (_, None, _) => (Position::Undetermined, None),
        };
        Some(Travel { axis, definition, before, after, distance, incremental, word: Some(valued.word) })
    }
}
