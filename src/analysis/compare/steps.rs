//! A program step by step: motions and other words. A million blocks take about 80 MB.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;

use super::ChangeKind;
use crate::dict::{AxisLetter, Decimal, GCode, Micro};
use crate::run::{FeedUnit, MotionType};

/// A value that differs or not.
#[derive(Clone, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
pub enum Value {
    /// A number, in millionths.
    Number(i64),
    /// A function, or words as written.
    Text(String),
}

impl From<Decimal> for Value {
    fn from(value: Decimal) -> Self {
        Self::Number(Micro::from(value).millionths())
    }
}

/// Something that is written beside motions.
#[derive(Clone, Debug, Eq, Hash, PartialEq)]
pub struct Event {
    /// The kind of a change in it.
    pub kind: ChangeKind,
    /// What holds one value at a time: `T`, `m5`, `G04`.
    pub slot: String,
    /// Its value.
    pub value: Value,
    /// Whether the value holds until another one is written.
    pub lasts: bool,
    /// It shares its block with a motion, and the sources do not say which of the two comes first.
    pub beside: bool,
}

impl Event {
    /// One that holds for its block.
    pub fn passing(kind: ChangeKind, slot: &str, value: Value) -> Self {
        Self { kind, slot: slot.to_owned(), value, lasts: false, beside: false }
    }

    /// Equal for the same word wherever it stands.
    pub fn word(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        (self.kind, &self.slot, &self.value).hash(&mut hasher);
        hasher.finish()
    }
}

/// The modal state at a step, as far as cutting depends on it.
#[derive(Clone, Debug, Default, Eq, Hash, PartialEq)]
pub struct Context {
    /// The tool in the spindle.
    pub tool: Option<Decimal>,
    /// Whether F counts: a working motion, a thread, a fixed cycle.
    pub working: bool,
    /// F, its unit, and whether a hundredth of it counts.
    pub feed: Option<(Decimal, FeedUnit, bool)>,
    /// Whether S counts: where F does, and where the spindle turns.
    pub turns: bool,
    /// S.
    pub speed: Option<Decimal>,
    /// Functions in force that change a motion.
    pub functions: Vec<GCode>,
    /// The dynamic set under G23.
    pub dynamic_set: Option<u8>,
}

/// The value of an axis of which neither end nor distance is known.
pub(super) const UNKNOWN: i64 = i64::MIN;

/// Most values of a motion: nine axes, a centre and an angle.
const MOST: usize = AxisLetter::ALL.len() + 3;

/// In [`Motion::by`]: the centre is counted from a start that nobody knows.
pub(super) const CENTER_BY: u16 = 1 << 15;

/// A motion, as it is read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    pub kind: MotionType,
    /// The axes of it, a bit each.
    pub axes: u16,
    /// Those that stay where they are.
    pub still: u16,
    /// Those of which distances are known, not the end; and [`CENTER_BY`].
    pub by: u16,
    /// The axes of the plane of an arc whose centre is known.
    pub plane: Option<[AxisLetter; 2]>,
    /// End by axis, or the sum of distances since nobody knows where the axis is; then the centre, and how far the arc
    /// turns.
    pub values: [i64; MOST],
    pub count: usize,
}

impl Motion {
    pub const fn new(kind: MotionType) -> Self {
        Self { kind, axes: 0, still: 0, by: 0, plane: None, values: [0; MOST], count: 0 }
    }

    pub fn push(&mut self, value: i64) {
        if let Some(slot) = self.values.get_mut(self.count) {
            *slot = value;
            self.count += 1;
        }
    }

    pub fn values(&self) -> &[i64] {
        self.values.get(..self.count).unwrap_or_default()
    }

    /// The axes in the order of their values.
    pub fn letters(&self) -> impl Iterator<Item = AxisLetter> {
        let axes = self.axes;
        AxisLetter::ALL.into_iter().filter(move |letter| axes & 1 << (*letter as u16) != 0)
    }

    /// The value of an axis; `Some(None)`: it moves to where nobody knows.
    pub fn value(&self, axis: AxisLetter) -> Option<Option<i64>> {
        let at = self.letters().position(|letter| letter == axis)?;
        self.values.get(at).map(|value| Some(*value).filter(|value| *value != UNKNOWN))
    }

    /// The centre.
    pub fn center(&self) -> Option<[i64; 2]> {
        let at = self.axes.count_ones() as usize;
        self.plane.and_then(|_| Some([*self.values.get(at)?, *self.values.get(at + 1)?]))
    }

    /// How far an arc turns, in millionths of degrees.
    pub fn sweep(&self) -> Option<i64> {
        self.plane.and_then(|_| self.values.get(self.axes.count_ones() as usize + 2).copied())
    }

    /// Hash of its effect: axes that stay are left out.
    fn hash(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.kind_key().hash(&mut hasher);
        let moving = self.letters().zip(self.values).filter(|(letter, _)| self.moves(*letter));
        moving.for_each(|(_, value)| value.hash(&mut hasher));
        self.center().hash(&mut hasher);
        hasher.finish()
    }

    pub fn moves(&self, letter: AxisLetter) -> bool {
        let turns = self.kind.is_arc() && self.plane.is_none_or(|plane| plane.contains(&letter));
        turns || self.still & 1 << (letter as u16) == 0
    }

    /// Whether an axis of it moves.
    pub fn moves_along(&self, letter: AxisLetter) -> bool {
        self.axes & 1 << (letter as u16) != 0 && self.moves(letter)
    }

    /// The axes that move, and those of them of which distances are known alone; with [`CENTER_BY`].
    pub fn moving(&self) -> (u16, u16) {
        let moving =
            self.letters().filter(|letter| self.moves(*letter)).fold(0, |all, letter| all | 1 << (letter as u16));
        (moving, self.by & (moving | CENTER_BY))
    }

    /// Motions with another key are never the same motion with other values.
    fn kind_key(&self) -> (MotionType, (u16, u16), Option<[AxisLetter; 2]>) {
        (self.kind, self.moving(), self.plane)
    }
}

/// A step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub seq: u32,
    pub n: u32,
    context: u32,
    /// Equal for steps with the same effect.
    pub token: u64,
    what: What,
}

#[derive(Clone, Copy, Debug)]
enum What {
    /// The index of its head.
    Motion(u32),
    Event(u32),
}

/// A motion without its values.
#[derive(Clone, Copy, Debug)]
struct Head {
    kind: MotionType,
    axes: u16,
    still: u16,
    by: u16,
    plane: Option<[AxisLetter; 2]>,
    at: u32,
}

/// The effect of a step.
#[derive(Clone, Copy, Debug)]
pub(super) enum Does<'s> {
    Motion(Motion),
    Event(&'s Event),
}

/// A program as steps.
#[derive(Debug, Default)]
pub struct Steps {
    pub(super) list: Vec<Step>,
    heads: Vec<Head>,
    values: Vec<i64>,
    contexts: Vec<Context>,
    context_at: HashMap<Context, u32>,
    events: Vec<Event>,
    event_at: HashMap<Event, u32>,
    /// Events that write what is in force already, and before which step each: of interest only where they are changes
    /// in the other program.
    repeated: Vec<(usize, u32)>,
    /// What holds before the first step.
    pub(super) start: Vec<Event>,
    /// Blocks executed.
    pub blocks: u64,
    /// The sum of known lengths.
    pub path: Micro,
    /// X is programmed as a diameter somewhere (G74).
    pub diameters: bool,
}

fn index(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}

impl Steps {
    pub(super) fn context(&mut self, context: &Context) -> u32 {
        if let Some(known) = self.context_at.get(context) {
            return *known;
        }
        let new = index(self.contexts.len());
        self.contexts.push(context.clone());
        self.context_at.insert(context.clone(), new);
        new
    }

    pub(super) fn add_motion(&mut self, seq: u64, n: u32, context: u32, motion: &Motion) {
        let head = index(self.heads.len());
        let Motion { kind, axes, still, by, plane, .. } = *motion;
        self.heads.push(Head { kind, axes, still, by, plane, at: index(self.values.len()) });
        self.values.extend_from_slice(motion.values());
        let seq = u32::try_from(seq).unwrap_or(u32::MAX);
        self.list.push(Step { seq, n, context, token: motion.hash(), what: What::Motion(head) });
    }

    pub(super) fn add_event(&mut self, seq: u64, n: u32, context: u32, event: Event) {
        let mut hasher = DefaultHasher::new();
        event.hash(&mut hasher);
        let token = hasher.finish();
        let at = self.event_id(event);
        let seq = u32::try_from(seq).unwrap_or(u32::MAX);
        self.list.push(Step { seq, n, context, token, what: What::Event(at) });
    }

    pub(super) fn add_repeated(&mut self, event: Event) {
        let at = self.event_id(event);
        self.repeated.push((self.list.len(), at));
    }

    fn event_id(&mut self, event: Event) -> u32 {
        if let Some(known) = self.event_at.get(&event) {
            return *known;
        }
        let new = index(self.events.len());
        self.event_at.insert(event.clone(), new);
        self.events.push(event);
        new
    }

    /// Whether an event is repeated before one of those steps, or the one behind them.
    pub(super) fn repeats(&self, event: &Event, steps: Range<usize>) -> bool {
        let from = self.repeated.partition_point(|(at, _)| *at < steps.start);
        let there = self.repeated.iter().skip(from).take_while(|(at, _)| *at <= steps.end);
        self.event_at.get(event).is_some_and(|event| there.into_iter().any(|(_, repeated)| repeated == event))
    }

    pub(super) fn step(&self, at: usize) -> Option<&Step> {
        self.list.get(at)
    }

    /// Whether the block of an event moves, without its motion among `alone`, which are in order.
    pub(super) fn moves_beside(&self, event: usize, alone: &[usize]) -> bool {
        let Some(seq) = self.step(event).map(|step| step.seq) else { return false };
        let is_motion = |at: &usize| self.step(*at).is_some_and(|step| step.seq == seq && Self::is_motion(step));
        let of_block = |at: &usize| self.step(*at).is_some_and(|step| step.seq == seq);
        let before = (0..event).rev().take_while(of_block);
        let behind = (event + 1..self.list.len()).take_while(of_block);
        before.chain(behind).find(is_motion).is_some_and(|motion| alone.binary_search(&motion).is_err())
    }

    pub(super) fn context_of(&self, step: &Step) -> Option<&Context> {
        self.contexts.get(step.context as usize)
    }

    /// Whether one of those steps is a motion.
    pub(super) fn moves(&self, steps: &[usize]) -> bool {
        steps.iter().any(|at| self.step(*at).is_some_and(Self::is_motion))
    }

    pub(super) const fn context_id(step: &Step) -> u32 {
        step.context
    }

    pub(super) fn is_motion(step: &Step) -> bool {
        matches!(step.what, What::Motion(_))
    }

    /// The axes of a motion and its values.
    pub(super) fn values(&self, step: &Step) -> Option<(u16, &[i64])> {
        self.head(step).map(|(head, values)| (head.axes, values))
    }

    fn head(&self, step: &Step) -> Option<(&Head, &[i64])> {
        let What::Motion(at) = step.what else { return None };
        let head = self.heads.get(at as usize)?;
        let end = self.heads.get(at as usize + 1).map_or(self.values.len(), |next| next.at as usize);
        Some((head, self.values.get(head.at as usize..end)?))
    }

    /// Whether a step is the same motion as one of another program, but for so many millionths.
    pub(super) fn is_near(&self, step: &Step, (other, step_of_other): (&Self, &Step), tolerance: i64) -> bool {
        let (Some((a, values)), Some((b, others))) = (self.head(step), other.head(step_of_other)) else { return false };
        let center = if a.plane.is_some() { 2 } else { 0 };
        let places = a.axes.count_ones() as usize + center;
        let near = |(a, b): (&i64, &i64)| a.abs_diff(*b) <= tolerance.unsigned_abs();
        (a.kind, a.axes, a.by, a.plane) == (b.kind, b.axes, b.by, b.plane)
            && values.iter().zip(others).take(places).all(near)
    }

    pub(super) fn does(&self, step: &Step) -> Option<Does<'_>> {
        match step.what {
            What::Event(at) => self.events.get(at as usize).map(Does::Event),
            What::Motion(_) => {
                let (head, values) = self.head(step)?;
                let Head { kind, axes, still, by, plane, .. } = *head;
                let mut motion = Motion { kind, axes, still, by, plane, ..Motion::new(kind) };
                values.iter().for_each(|value| motion.push(*value));
                Some(Does::Motion(motion))
            }
        }
    }

    /// Steps with another kind are never paired, except for motions along other axes that are near each other.
    pub(super) fn kind(&self, step: &Step, axes: bool) -> u64 {
        let mut hasher = DefaultHasher::new();
        match self.does(step) {
            Some(Does::Motion(motion)) if axes => motion.kind_key().hash(&mut hasher),
            Some(Does::Motion(motion)) => (motion.kind, motion.plane, motion.moving().1).hash(&mut hasher),
            Some(Does::Event(event)) => (event.kind, &event.slot).hash(&mut hasher),
            None => {}
        }
        hasher.finish()
    }
}

/// The positions of the axes, as far as they are known.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Stand([Option<i64>; AxisLetter::ALL.len()]);

impl Stand {
    /// The number of steps before a place that are read to find the positions there.
    const BACK: usize = 64;

    /// The positions before a step.
    pub fn before(steps: &Steps, at: usize) -> Self {
        let mut stand = Self::default();
        let before = steps.list.get(at.saturating_sub(Self::BACK)..at).unwrap_or_default();
        before.iter().for_each(|step| stand.pass(steps, step));
        stand
    }

    /// Follows a step.
    pub fn pass(&mut self, steps: &Steps, step: &Step) {
        let Some((head, values)) = steps.head(step) else { return };
        let (mut axes, mut values) = (head.axes, values.iter());
        while axes != 0 {
            let axis = axes.trailing_zeros();
            axes &= axes - 1;
            let (Some(place), Some(value)) = (self.0.get_mut(axis as usize), values.next()) else { return };
            *place = Some(*value).filter(|value| *value != UNKNOWN && head.by & 1 << axis == 0);
        }
    }

    pub fn of(&self, letter: AxisLetter) -> Option<i64> {
        self.0.get(letter as usize).copied().flatten()
    }
}

/// Steps by their effect.
pub(super) fn tokens(steps: &Steps, range: &Range<usize>) -> Vec<u64> {
    steps.list.get(range.clone()).unwrap_or_default().iter().map(|step| step.token).collect()
}

/// Steps by their kind and by the positions after them, rounded to `grid` millionths: most steps that differ in their
/// last digits only are equal.
pub(super) fn rounded(steps: &Steps, range: &Range<usize>, grid: i64) -> Vec<u64> {
    let mut stand = Stand::before(steps, range.start);
    let list = steps.list.get(range.clone()).unwrap_or_default();
    let round = |step: &Step| {
        stand.pass(steps, step);
        let mut hasher = DefaultHasher::new();
        steps.kind(step, false).hash(&mut hasher);
        match step.what {
            What::Motion(_) => stand.0.map(|place| place.map(|place| place.div_euclid(grid))).hash(&mut hasher),
            What::Event(_) => step.token.hash(&mut hasher),
        }
        hasher.finish()
    };
    list.iter().map(round).collect()
}

/// What steps move by, from the motion before each in their range: the same in runs that are shifted.
pub(super) fn increments(steps: &Steps, range: &Range<usize>) -> Vec<u64> {
    let mut last: [Option<i64>; AxisLetter::ALL.len()] = Default::default();
    let list = steps.list.get(range.clone()).unwrap_or_default();
    let increment = |step: &Step| {
        let Some(Does::Motion(motion)) = steps.does(step) else { return step.token };
        let mut hasher = DefaultHasher::new();
        motion.kind_key().hash(&mut hasher);
        for (letter, value) in motion.letters().zip(motion.values) {
            let Some(last) = last.get_mut(letter as usize) else { continue };
            let before = last.replace(value);
            if motion.moves(letter) {
                // Where an axis comes from is not known at the first motion: it is like no other.
                before.map_or(value, |before| value.saturating_sub(before)).hash(&mut hasher);
            }
        }
        if let (Some(plane), Some(center)) = (motion.plane, motion.center()) {
            for (letter, center) in plane.into_iter().zip(center) {
                motion.value(letter).flatten().map(|end| center.saturating_sub(end)).hash(&mut hasher);
            }
        }
        hasher.finish()
    };
    list.iter().map(increment).collect()
}
