//! From the facts of one step after another to the signals that change.

use super::dictionary::{Cell, Signal};
use super::facts::{Facts, MotionFacts, PLACES};
use super::values::{Part, Value, value};
use crate::config::Machine;
use crate::dict::Micro;

/// The place of a step.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Place {
    /// `seq` of the block.
    pub seq: u64,
    /// Number of the block.
    pub n: u32,
    /// Index of its file.
    pub file: u32,
    /// Line of its `N`, from 1; 0 when the writer wants no lines.
    pub line: u32,
    /// Column of its `N` in characters, from 1; 0 likewise.
    pub column: u32,
    /// Whether the program waits at M00 or M01 (PLC-16).
    pub stop: bool,
}

/// One step with the values of the chosen signals.
#[derive(Clone, Copy, Debug, Default)]
pub struct Step<'a> {
    /// Where.
    pub place: Place,
    /// When it starts, in seconds from the start of the program; with `[motion]`.
    pub start_s: Option<Micro>,
    /// When its block ends, likewise; of a stop the same as `start_s`.
    pub end_s: Option<Micro>,
    /// Values of all chosen signals.
    pub values: &'a [Value],
    /// Values in the step before.
    pub before: &'a [Value],
    /// Indices of those that changed since the step before, ascending.
    pub changed: &'a [usize],
}

/// The parts that change in a step that only moves.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Onward {
    /// A bit for each [`Part`].
    parts: u8,
    /// A bit for each place whose axis has another position.
    pub(super) places: u16,
}

impl Onward {
    /// The part is another, when `changed`.
    pub(super) const fn put(&mut self, part: Part, changed: bool) {
        self.parts |= (changed as u8) << part as u8;
    }
}

/// Follows the values of some signals from step to step. Before the first step bits are 0, all else is absent.
#[derive(Debug)]
pub struct Tracker {
    signals: Vec<&'static Signal>,
    /// By [`Part`]: indices of its signals.
    parts: [Vec<usize>; Part::ALL.len()],
    /// By place of the axis: the index of its position.
    places: [Option<usize>; PLACES],
    has_positions: bool,
    /// Of the step taken last.
    facts: Box<Facts>,
    /// Of the next one.
    next: Box<Facts>,
    values: Vec<Value>,
    before: Vec<Value>,
    changed: Vec<usize>,
    started: bool,
}

impl Tracker {
    /// For these signals.
    pub fn new(signals: Vec<&'static Signal>) -> Self {
        let of_part = |part: Part| {
            let of = signals.iter().enumerate().filter(|(_, signal)| Part::of(signal.cell) == Some(part));
            of.map(|(index, _)| index).collect()
        };
        let values = initial(&signals);
        let mut places = [None; PLACES];
        for (index, signal) in signals.iter().enumerate() {
            if let Cell::Position(place) = signal.cell
                && let Some(slot) = places.get_mut(usize::from(place))
            {
                *slot = Some(index);
            }
        }
        Self {
            has_positions: places.iter().any(Option::is_some),
            places,
            parts: Part::ALL.map(of_part),
            facts: Box::default(),
            next: Box::default(),
            before: values.clone(),
            values,
            changed: Vec::new(),
            started: false,
            signals,
        }
    }

    /// The signals.
    pub fn signals(&self) -> &[&'static Signal] {
        &self.signals
    }

    /// Where the facts of the next step are put; they still are those of a step before.
    pub fn room(&mut self) -> &mut Facts {
        &mut self.next
    }

    /// The facts of the step taken last, for one that only moves on: see [`Self::go_on`].
    pub(super) fn current(&mut self) -> &mut Facts {
        &mut self.facts
    }

    /// Takes the facts of the next step.
    pub fn take(&mut self, machine: &Machine) {
        self.forget();
        for (part, indices) in Part::ALL.into_iter().zip(&self.parts) {
            if indices.is_empty() || (self.started && part.is_same(&self.facts, &self.next)) {
                continue;
            }
            update(indices, &self.next, machine, &self.signals, &mut self.values, &mut self.changed);
        }
        if self.has_positions {
            self.take_positions(self.facts.moved_places(&self.next), true);
        }
        self.changed.sort_unstable();
        std::mem::swap(&mut self.facts, &mut self.next);
        self.started = true;
    }

    /// Takes the next step, whose facts have been put in place of those of the step before.
    #[inline]
    pub(super) fn go_on(&mut self, onward: Onward, machine: &Machine) {
        self.forget();
        if onward.parts != 0 {
            for (part, indices) in Part::ALL.into_iter().zip(&self.parts) {
                if onward.parts >> part as u8 & 1 == 1 && !indices.is_empty() {
                    update(indices, &self.facts, machine, &self.signals, &mut self.values, &mut self.changed);
                }
            }
        }
        if self.has_positions {
            self.take_positions(onward.places, false);
        }
        self.changed.sort_unstable();
    }

    /// What changed in the step before holds before the next one.
    #[inline]
    fn forget(&mut self) {
        for &index in &self.changed {
            if let (Some(before), Some(now)) = (self.before.get_mut(index), self.values.get(index)) {
                *before = *now;
            }
        }
        self.changed.clear();
    }

    /// Takes over what nearly every block changes: the positions at these places, of the next step or of the current
    /// one.
    #[inline]
    fn take_positions(&mut self, mut moved: u16, next: bool) {
        let facts = if next { &self.next } else { &self.facts };
        while moved != 0 {
            let place = moved.trailing_zeros() as usize;
            moved &= moved - 1;
            let (Some(&Some(index)), Some(position)) = (self.places.get(place), facts.positions.get(place)) else {
                continue;
            };
            if let Some(slot) = self.values.get_mut(index) {
                *slot = position.map(Micro::millionths);
                self.changed.push(index);
            }
        }
    }

    /// The step taken last.
    pub fn step(&self, place: Place) -> Step<'_> {
        let MotionFacts { start_s, end_s, .. } = self.facts.motion;
        Step { place, start_s, end_s, values: &self.values, before: &self.before, changed: &self.changed }
    }
}

/// Brings the values of some signals up to the facts, and adds those that change.
#[inline]
fn update(
    indices: &[usize],
    facts: &Facts,
    machine: &Machine,
    signals: &[&'static Signal],
    values: &mut [Value],
    changed: &mut Vec<usize>,
) {
    for &index in indices {
        let (Some(signal), Some(slot)) = (signals.get(index), values.get_mut(index)) else { continue };
        let now = value(signal.cell, facts, machine);
        if now != *slot {
            *slot = now;
            changed.push(index);
        }
    }
}

/// What holds before the first block: bits are 0.
pub fn initial(signals: &[&'static Signal]) -> Vec<Value> {
    use super::dictionary::Form;
    signals.iter().map(|signal| (signal.form() == Form::Bit).then_some(0)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::plc::choose::{default, named};
    use crate::analysis::plc::dictionary::Flag;
    use crate::dict::{Decimal, Dialect};

    /// A signal keeps its value exactly as long as the facts give the same: what is left out because its part is the
    /// same would not have changed.
    #[test]
    fn parts_hold_all_that_their_signals_depend_on() {
        let machine = Machine::default();
        let signals = default(Dialect::Cnc872, true, true);
        let mut many = vec![Facts::default()];
        let mut add = |change: &dyn Fn(&mut Facts)| {
            let mut facts = many[0].clone();
            change(&mut facts);
            many.push(facts);
        };
        add(&|facts| facts.m[2] = Some(3));
        add(&|facts| facts.m[5] = Some(17));
        add(&|facts| facts.mark(7));
        add(&|facts| facts.set(Flag::Thread, true));
        add(&|facts| facts.write(super::super::dictionary::OneBlock::M60));
        add(&|facts| facts.moves = 5);
        add(&|facts| (facts.directed, facts.negative) = (3, 2));
        add(&|facts| facts.gear = Some(2));
        add(&|facts| facts.tool = Some(Decimal::whole(12_345_678)));
        add(&|facts| facts.h = Some(Decimal::whole(5)));
        add(&|facts| facts.feed = Some(Decimal::whole(5)));
        add(&|facts| facts.speed = Some(Decimal::whole(5)));
        add(&|facts| facts.dwell = Some(Micro::ZERO));
        add(&|facts| facts.length = Some(Micro::ZERO));
        add(&|facts| facts.positions[15] = Some(Micro::ZERO));
        add(&|facts| facts.motion.in_stretch = Some(true));
        add(&|facts| facts.motion.time_dist_ms = Some(7));
        add(&|facts| facts.motion.parabolic = Some(Micro::ZERO));
        add(&|facts| facts.motion.linear = Some(Micro::ZERO));
        let mut tracker = Tracker::new(signals.clone());
        for from in &many {
            for to in &many {
                tracker.room().clone_from(from);
                tracker.take(&machine);
                let before = tracker.step(Place::default()).values.to_vec();
                tracker.room().clone_from(to);
                tracker.take(&machine);
                let step = tracker.step(Place::default());
                assert_eq!(step.before, before);
                let all: Vec<Value> = signals.iter().map(|signal| value(signal.cell, to, &machine)).collect();
                assert_eq!(step.values, all, "{from:?} {to:?}");
                let differ: Vec<usize> = (0..all.len()).filter(|&index| before[index] != all[index]).collect();
                assert_eq!(step.changed, differ);
            }
        }
    }

    #[test]
    fn before_the_first_step_bits_are_0() {
        let signals = named("AUTPI,PB06,SM_POXPI", Dialect::Cnc872).unwrap();
        assert_eq!(initial(&signals), [Some(0), None, Some(0)]);
    }
}
