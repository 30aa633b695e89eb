//! From an executed block to the facts of its step, and of the step of its stop: the one place that knows how execution
//! tells of a block.

use super::dictionary::{AXES, Cell, Flag, OneBlock, Signal};
use super::facts::{Facts, STOPPED, StepTimes};
use super::steps::Onward;
use super::values::Part;
use crate::config::{Machine, Profile, SetKey};
use crate::dict::{Address, AxisLetter, GCode, GGroup, Micro};
use crate::run::{ArcPath, Executed, Length, Motion, MotionType};

/// How far an arc must go beyond both of its ends for an axis to turn back, in mm (PLC-5).
const TURNS_BACK: f64 = 0.001;

/// Reads blocks in the order of execution.
#[derive(Debug)]
pub(super) struct Blocks {
    /// What lasts of group G0: G30 holds in its block only.
    modal: Option<GCode>,
    /// The program stood after the block before.
    after_stop: bool,
    /// Some chosen signal is a direction: they take geometry to find.
    directions: bool,
    /// Motion is configured, with a parabolic profile.
    parabolic: bool,
    /// Nothing that holds for one block only is in the facts of the block before: one that moves on has them as well.
    steady: bool,
}

impl Blocks {
    /// Before the first block, for some signals.
    pub(super) fn new(machine: &Machine, signals: &[&'static Signal]) -> Self {
        let directions = signals.iter().any(|signal| matches!(signal.cell, Cell::Backwards(_)));
        let motion = &machine.motion;
        let parabolic = motion.configured && motion.profile.value == Profile::Parabolic;
        Self {
            modal: machine.power_up.get(GGroup::G0.index()).copied().flatten(),
            after_stop: false,
            directions,
            parabolic,
            steady: false,
        }
    }

    /// Brings the facts of the block before to those of one that only moves on; what of them is another. `None`: it
    /// does more.
    #[inline]
    pub(super) fn go_on(&self, block: &Executed<'_>, times: Option<StepTimes>, facts: &mut Facts) -> Option<Onward> {
        let motion = block.motion().filter(|_| self.steady && block.moves_on())?;
        let mut onward = Onward::default();
        let before = (facts.moves, facts.directed, facts.negative, facts.length);
        self.read_motion(facts, block, &motion);
        onward.put(Part::Moves, before.0 != facts.moves);
        onward.put(Part::Directions, (before.1, before.2) != (facts.directed, facts.negative));
        onward.put(Part::Length, before.3 != facts.length);
        let axes = &block.settings().machine.axes;
        for letter in motion.axes() {
            if let Some(place) = axes.index(letter)
                && let Some(slot) = facts.positions.get_mut(place)
            {
                let position = block.position(letter);
                if *slot != position {
                    *slot = position;
                    onward.places |= 1 << place;
                }
            }
        }
        if let Some(times) = times {
            let before = facts.motion;
            facts.motion.set_times(times);
            onward.put(Part::Motion, before != facts.motion);
        }
        Some(onward)
    }

    /// Puts the facts of the block's step into `facts`, in place of those of another one, with its times when motion is
    /// computed; the result are those of the step at which the program stands after it (PLC-16).
    pub(super) fn read(&mut self, block: &Executed<'_>, times: Option<StepTimes>, facts: &mut Facts) -> Option<Facts> {
        let machine = &block.settings().machine;
        facts.reset();
        facts.gear = block.gear();
        facts.tool = block.t();
        facts.h = block.h();
        facts.feed = block.feed().map(|feed| feed.value);
        // Where S is a cutting speed no source says what the spindle turns (PLC-6).
        facts.speed = block.s().filter(|_| !block.const_cut_speed());
        facts.dwell = block.dwell();
        facts.m = *block.m_of_groups();
        for &group in block.m_changed() {
            facts.mark(usize::from(group));
        }
        if std::mem::take(&mut self.after_stop) {
            STOPPED.into_iter().for_each(|group| facts.mark(group));
        }
        for function in block.m_written().iter().filter_map(|&number| OneBlock::from_number(number)) {
            facts.write(function);
        }
        self.set_flags(facts, block);
        for (axis, slot) in machine.axes.iter().zip(&mut facts.positions) {
            *slot = block.position(axis.letter);
        }
        if let Some(motion) = block.motion() {
            self.read_motion(facts, block, &motion);
        }
        if let Some(times) = times {
            facts.motion.set_times(times);
        }
        if self.parabolic && (facts.has(Flag::Rapid) || block.continuous_mode()) {
            let set = if facts.has(Flag::Rapid) { 0 } else { usize::from(block.dynamic_set().unwrap_or(1)) };
            let value = |key| {
                let value = machine.motion.dynamic(set, key, |number| block.parameter(number));
                Some(Micro::from(value)).filter(|value| *value > Micro::ZERO)
            };
            // P/500.
            let parabolic = value(SetKey::Parabolic).map(|p| Micro::from_millionths(p.millionths() / 500));
            (facts.motion.parabolic, facts.motion.linear) = (parabolic, value(SetKey::Linear));
        }
        let interpolation = block.g(GGroup::G0);
        if interpolation != Some(GCode::G30) {
            self.modal = interpolation;
        }
        self.steady = facts.marks == 0 && facts.written() == 0 && !block.first() && !facts.has(Flag::Reference);
        block.m_at_stop().map(|held| {
            self.steady = false;
            self.after_stop = true;
            let (rapid, thread) = (self.modal == Some(GCode::G00), self.modal == Some(GCode::G33));
            facts.at_stop([held.spindle, held.coolant_12, held.coolant_34], rapid, thread)
        })
    }

    /// How the axes move, and how far.
    #[inline]
    fn read_motion(&self, facts: &mut Facts, block: &Executed<'_>, motion: &Motion<'_>) {
        let axes = &block.settings().machine.axes;
        (facts.moves, facts.directed, facts.negative) = (0, 0, 0);
        facts.length = match motion.length() {
            Length::Mm(length) | Length::Deg(length) => Some(length),
            Length::Missing(_) => None,
        };
        let directed = self.directions && keeps_directions(block);
        // PLC-4: an axis moves that is written, or that is one of the two of an arc.
        let of_arc = motion.arc().into_iter().flat_map(|arc| arc.plane);
        for letter in motion.axes().chain(of_arc) {
            let Some(place) = axes.index(letter).filter(|place| *place < usize::from(AXES)) else { continue };
            facts.moves |= 1 << place;
            if directed && let Some(negative) = direction(block, motion, letter) {
                facts.directed |= 1 << place;
                facts.negative |= u16::from(negative) << place;
            }
        }
    }

    fn set_flags(&self, facts: &mut Facts, block: &Executed<'_>) {
        let interpolation = block.g(GGroup::G0);
        facts.set(Flag::First, block.first());
        facts.set(Flag::Last, block.last());
        facts.set(Flag::Stop, block.stop());
        facts.set(Flag::CondStop, block.cond_stop());
        facts.set(Flag::HProg, block.written(Address::H));
        facts.set(Flag::TProg, block.written(Address::T));
        facts.set(Flag::RevFeed, block.rev_feed());
        facts.set(Flag::ContinuousMode, block.continuous_mode());
        facts.set(Flag::ConstCutSpeed, block.const_cut_speed());
        facts.set(Flag::Rapid, interpolation == Some(GCode::G00));
        facts.set(Flag::Thread, interpolation == Some(GCode::G33));
        facts.set(Flag::Automatic, true);
        facts.set(Flag::Reference, block.g_written().any(|code| code == GCode::G30));
        facts.set(Flag::Dwell, block.dwell().is_some_and(|dwell| dwell > Micro::ZERO));
    }
}

/// Whether the servo moves as the programmed coordinates do: beside a function that moves the machine (ChangePos) the
/// way is another one, and under mirror, scale and rotation so is the direction (S0 8.1.8).
fn keeps_directions(block: &Executed<'_>) -> bool {
    !block.change_pos() && matches!(block.g(GGroup::G11), None | Some(GCode::G34 | GCode::G37))
}

/// PLC-5: whether an axis that moves does so in the negative direction; `None` when it does neither.
fn direction(block: &Executed<'_>, motion: &Motion<'_>, axis: AxisLetter) -> Option<bool> {
    // After a change of origin the way of an axis is another one (MOT-8).
    if motion.kind() == MotionType::Reference || motion.is_stale_along(axis) {
        return None;
    }
    let distance = motion.distance(axis).filter(|distance| *distance != Micro::ZERO)?;
    if motion.kind().is_arc()
        && let Some(arc) = motion.arc().filter(|arc| arc.plane.contains(&axis))
        && turns_back(block, motion, &arc, axis)?
    {
        return None;
    }
    Some(distance < Micro::ZERO)
}

/// Whether an arc passes an extreme of one of its axes, beyond both ends; `None` when that is not known.
fn turns_back(block: &Executed<'_>, motion: &Motion<'_>, arc: &ArcPath, axis: AxisLetter) -> Option<bool> {
    let [first, second] = arc.plane;
    let [center_first, center_second] = arc.center?;
    // The axis of an arc that is not written ends where it began.
    let stays = |axis| block.position(axis).filter(|_| !motion.moves(axis));
    let start = |axis, center: Micro| Some(motion.start(axis).or_else(|| stays(axis))?.minus(center).to_f64());
    let end = |axis, center: Micro| Some(motion.end(axis).or_else(|| stays(axis))?.minus(center).to_f64());
    let start = (start(first, center_first)?, start(second, center_second)?);
    let end = (end(first, center_first)?, end(second, center_second)?);
    let sweep = arc.sweep_deg?.to_f64().to_radians();
    let clockwise = motion.kind() == MotionType::ArcCw;
    Some(goes_beyond(start, end, sweep, clockwise, axis == second))
}

/// Whether an arc about the origin, from `start` to `end` through `sweep` radians, goes beyond both ends along its
/// first axis, or the second one. Where the radii differ it is a spiral between them.
fn goes_beyond(start: (f64, f64), end: (f64, f64), sweep: f64, clockwise: bool, second: bool) -> bool {
    use std::f64::consts::{FRAC_PI_2, PI, TAU};
    let (from, to) = if second { (start.1, end.1) } else { (start.0, end.0) };
    let (low, high) = (from.min(to), from.max(to));
    let angle = libm::atan2(start.1, start.0);
    let (radius, last) = (libm::hypot(start.0, start.1), libm::hypot(end.0, end.1));
    let extremes = if second { [(FRAC_PI_2, 1.0), (-FRAC_PI_2, -1.0)] } else { [(0.0, 1.0), (PI, -1.0)] };
    extremes.into_iter().any(|(at, sign)| {
        let turned = if clockwise { angle - at } else { at - angle };
        let turned = libm::fmod(libm::fmod(turned, TAU) + TAU, TAU);
        if turned > sweep || sweep <= 0.0 {
            return false;
        }
        let reached = sign * (radius + (last - radius) * turned / sweep);
        reached > high + TURNS_BACK || reached < low - TURNS_BACK
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// PLC-5: the axis keeps its direction on an arc that ends at an extreme, or up to 0.001 mm behind it.
    #[test]
    fn extremes_of_arcs() {
        use std::f64::consts::{FRAC_PI_2, PI};
        let (right, top, left) = ((10.0, 0.0), (0.0, 10.0), (-10.0, 0.0));
        // A quarter: both axes go one way.
        for second in [false, true] {
            assert!(!goes_beyond(right, top, FRAC_PI_2, false, second));
            assert!(!goes_beyond(top, right, FRAC_PI_2, true, second));
        }
        // Half a circle over the top: Y goes up and down, X only left.
        assert!(goes_beyond(right, left, PI, false, true));
        assert!(!goes_beyond(right, left, PI, false, false));
        // The long way round: both turn.
        for second in [false, true] {
            assert!(goes_beyond(right, top, 3.0 * FRAC_PI_2, true, second));
        }
        // From a little before the top to a little behind it.
        let around = |mm: f64| {
            let half = libm::acos((10.0 - mm) / 10.0);
            let (x, y) = (10.0 * libm::sin(half), 10.0 - mm);
            goes_beyond((x, y), (-x, y), 2.0 * half, false, true)
        };
        assert!(!around(0.0009) && around(0.0011));
        // The end has another radius, within the tolerance: the extreme is the end.
        assert!(!goes_beyond(right, (0.0, 9.995), FRAC_PI_2, false, true));
    }
}
