//! Differences of aligned steps, grouped: what is the same change at many blocks is one (CMP-4).

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;

use super::align::{Aligned, align};
use super::reader::INHERITED;
use super::steps::{Context, Does, Event, Motion, Stand, Step, Steps, Value};
use crate::dict::{AxisLetter, Decimal, GCode, GGroup, Micro};
use crate::named::named;
use crate::run::{FeedUnit, MotionType};
use crate::sure::small;

/// Of an arc, in millionths of degrees.
const HALF_TURN: u64 = 180_000_000;

named! {
    /// What differs.
    #[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
    pub enum ChangeKind {
        /// Where a motion ends, or its centre.
        Position "position",
        /// F.
        Feed "feed",
        /// S.
        Speed "speed",
        /// T, M06.
        Tool "tool",
        /// G or M functions, H, P.
        Function "function",
        /// G04.
        Dwell "dwell",
        /// M00, M01.
        Stop "stop",
        /// D, `&`.
        Correction "correction",
        /// Words that are data, or that nobody knows the meaning of.
        Data "data",
        /// Parameters and jumps.
        Parameter "parameter",
        /// Blocks of the new program alone.
        Added "added",
        /// Blocks of the old program alone.
        Removed "removed",
    }
}

/// Differences up to these count as none.
#[derive(Clone, Copy, Debug)]
pub struct Tolerances {
    /// Positions, mm and degrees.
    pub position: Micro,
    /// F and S, per cent.
    pub percent: f64,
}

impl Default for Tolerances {
    /// Positions up to 0.001 mm or degrees apart are the same; F and S exactly.
    fn default() -> Self {
        Self { position: Micro::from_millionths(1000), percent: 0.0 }
    }
}

/// Executed blocks of one program, in runs.
#[derive(Clone, Debug, Default, Eq, PartialEq)]
pub struct Blocks {
    /// From and to, by seq.
    pub runs: Vec<[u32; 2]>,
    /// How many.
    pub count: u64,
    /// The numbers of the first and the last.
    pub n: Option<(u32, u32)>,
}

impl Blocks {
    fn add(&mut self, step: &Step) {
        match self.runs.last_mut() {
            Some([_, to]) if *to >= step.seq => return,
            Some([_, to]) if *to + 1 == step.seq => *to = step.seq,
            _ => {
                // Most changes of programs with nothing alike have one run.
                self.runs.reserve_exact(usize::from(self.runs.is_empty()));
                self.runs.push([step.seq; 2]);
            }
        }
        self.count += 1;
        self.n = Some((self.n.map_or(step.n, |(first, _)| first), step.n));
    }
}

/// Runs in order, those that touch as one.
pub(super) fn merged(runs: impl Iterator<Item = [u32; 2]>) -> Vec<[u32; 2]> {
    let mut runs: Vec<[u32; 2]> = runs.collect();
    runs.sort_unstable();
    let mut merged: Vec<[u32; 2]> = Vec::new();
    for [from, to] in runs {
        match merged.last_mut() {
            Some([_, end]) if from <= end.saturating_add(1) => *end = to.max(*end),
            _ => merged.push([from, to]),
        }
    }
    merged
}

/// One change.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// What kind.
    pub kind: ChangeKind,
    /// The tool in the spindle.
    pub tool: Option<Decimal>,
    /// Axis, function or address.
    pub what: Option<Cow<'static, str>>,
    /// The old value, where it is one.
    pub old: Option<Value>,
    /// The new value, where it is one.
    pub new: Option<Value>,
    /// The difference, where it is one number.
    pub delta: Option<i64>,
    /// Old, new and difference are half of what the programs write (G74).
    pub halved: bool,
    /// Blocks of the old program.
    pub old_blocks: Blocks,
    /// Blocks of the new program.
    pub new_blocks: Blocks,
    /// The number of the block in the other program that added or removed blocks follow; of several places the first.
    pub behind: Option<u32>,
}

impl Change {
    /// How many blocks it is.
    pub fn count(&self) -> u64 {
        self.old_blocks.count.max(self.new_blocks.count)
    }
}

/// What two programs differ in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// In the order of their first places.
    pub changes: Vec<Change>,
}

/// A difference of two steps, or what one lacks.
struct Difference {
    kind: ChangeKind,
    what: Option<Cow<'static, str>>,
    old: Option<Value>,
    new: Option<Value>,
}

/// The group of changes of the spindle's speed where nothing is cut. Where there is the same change at cuts, that says
/// it: what a change of S costs is counted there.
const IDLE: u64 = u64::MAX;

/// Changes by what they are.
#[derive(Default)]
struct Groups {
    changes: Vec<Change>,
    /// By change.
    runs: Vec<u64>,
    /// The place of a change at its hash, or behind where another one has that.
    places: HashMap<u64, u32>,
}

impl Groups {
    /// The change that is the same as this one, without its blocks.
    fn of(&mut self, run: u64, new: Change) -> Option<&mut Change> {
        let Self { changes, runs, places } = self;
        // One shift is one change, whatever it shifts.
        let shift = new.kind == ChangeKind::Position && new.delta.is_some();
        let mut hasher = DefaultHasher::new();
        (run, new.kind, new.tool, &new.what, new.delta).hash(&mut hasher);
        if !shift {
            (&new.old, &new.new).hash(&mut hasher);
        }
        let mut hash = hasher.finish();
        let next = changes.len();
        let is_same = |at: usize| {
            let same = |known: &Change| {
                (known.kind, known.tool, known.delta, &known.what) == (new.kind, new.tool, new.delta, &new.what)
                    && (shift || (&known.old, &known.new) == (&new.old, &new.new))
            };
            runs.get(at) == Some(&run) && changes.get(at).is_some_and(same)
        };
        let place = loop {
            let place = *places.entry(hash).or_insert(small(next)) as usize;
            if place == next || is_same(place) {
                break place;
            }
            hash = hash.wrapping_add(1);
        };
        if place == next {
            runs.push(run);
            changes.push(new);
        } else if let Some(known) = changes.get_mut(place)
            && (&known.old, &known.new) != (&new.old, &new.new)
        {
            (known.old, known.new) = (None, None);
        }
        changes.get_mut(place)
    }

    /// All of them.
    fn finish(self) -> Vec<Change> {
        let Self { changes, runs, .. } = self;
        // Whichever tool is in the spindle: two programs may have different ones there.
        let key = |change: &Change| (change.what.clone(), change.old.clone(), change.new.clone());
        let counts =
            |(change, run): &(&Change, &u64)| **run != IDLE && is_of_speed(change.kind, change.what.as_deref());
        let cuts: HashSet<_> = changes.iter().zip(&runs).filter(counts).map(|(change, _)| key(change)).collect();
        let told = |(change, run): &(Change, u64)| *run != IDLE || !cuts.contains(&key(change));
        changes.into_iter().zip(runs).filter(told).map(|(change, _)| change).collect()
    }
}

/// Whether it is S, or a function that says what S means.
fn is_of_speed(kind: ChangeKind, what: Option<&str>) -> bool {
    kind == ChangeKind::Speed || matches!(what, Some("G96" | "G97"))
}

struct Grouping<'s> {
    old: &'s Steps,
    new: &'s Steps,
    tolerances: Tolerances,
    groups: Groups,
    /// Steps in a row without counterpart, of the old program and of the new one.
    alone: [Vec<usize>; 2],
    /// How many steps of either program stand up to the last pair.
    paired: [usize; 2],
    /// Single events of either program, by place; `true`: the other program has it too, where it is in force already.
    events: [Vec<(usize, bool)>; 2],
    /// The positions of the axes in either program.
    stands: [Stand; 2],
    /// What holds in either program, by slot.
    in_force: [HashMap<&'s str, &'s Value>; 2],
    /// Contexts that were the same.
    same_context: Option<(u32, u32)>,
}

/// Compares what two programs do.
pub fn compare(old: &Steps, new: &Steps, tolerances: Tolerances) -> Comparison {
    let mut grouping = Grouping {
        old,
        new,
        tolerances,
        groups: Groups::default(),
        alone: Default::default(),
        paired: [0; 2],
        events: Default::default(),
        stands: Default::default(),
        in_force: [old, new].map(|steps| steps.start.iter().map(|event| (event.slot.as_str(), &event.value)).collect()),
        same_context: None,
    };
    align(old, new, tolerances.position.millionths(), |aligned| match aligned {
        Aligned::Old(at) => grouping.alone[0].push(at),
        Aligned::New(at) => grouping.alone[1].push(at),
        Aligned::Both(a, b) => {
            grouping.end_runs([a, b]);
            grouping.pair(a, b);
            grouping.pass(0, a);
            grouping.pass(1, b);
            grouping.paired = [a + 1, b + 1];
        }
    });
    grouping.end_runs([old.list.len(), new.list.len()]);
    grouping.end_events();
    let mut changes: Vec<Change> = grouping.groups.finish();
    let first = |change: &Change| {
        let first = |blocks: &Blocks| blocks.runs.first().map_or(u32::MAX, |run| run[0]);
        (first(&change.new_blocks).min(first(&change.old_blocks)), change.kind)
    };
    changes.sort_by_cached_key(first);
    Comparison { changes }
}

impl<'s> Grouping<'s> {
    const fn steps(&self, side: usize) -> &'s Steps {
        if side == 0 { self.old } else { self.new }
    }

    /// Follows a step: values that hold on, and positions.
    fn pass(&mut self, side: usize, at: usize) {
        let steps = self.steps(side);
        let held = (self.stands.get_mut(side), self.in_force.get_mut(side));
        let (Some(step), (Some(stand), Some(in_force))) = (steps.step(at), held) else { return };
        if Steps::is_motion(step) {
            stand.pass(steps, step);
        } else if let Some(event) = event(steps, step).filter(|event| event.lasts) {
            in_force.insert(&event.slot, &event.value);
        }
    }

    /// Ends the runs without counterpart; `ends`: the next pair.
    fn end_runs(&mut self, ends: [usize; 2]) {
        let [mut old, mut new] = std::mem::take(&mut self.alone);
        let ([from, to], [end, last]) = (self.paired, ends);
        let stands = self.stands;
        old.iter().for_each(|at| self.pass(0, *at));
        new.iter().for_each(|at| self.pass(1, *at));
        let moving = [self.old.moves(&old), self.new.moves(&new)];
        if !moving[1] {
            self.leave_out_idle(self.old, &mut old, stands);
        }
        if !moving[0] {
            self.leave_out_idle(self.new, &mut new, [stands[1], stands[0]]);
        }
        self.end_run(0, old, to..last);
        self.end_run(1, new, from..end);
    }

    /// Leaves out motions that stay within the tolerance of the position in the other program (CMP-2).
    fn leave_out_idle(&self, steps: &Steps, run: &mut Vec<usize>, [mut own, other]: [Stand; 2]) {
        run.retain(|at| {
            let Some(step) = steps.step(*at) else { return true };
            let Some(Does::Motion(motion)) = steps.does(step) else { return true };
            let before = own;
            own.pass(steps, step);
            let near = |place: Option<i64>, stand: i64| place.is_some_and(|place| !self.beyond(place, stand));
            let stays = |letter: AxisLetter| {
                let (from, to) = (before.of(letter), own.of(letter));
                // From where an origin left it, an axis moves though its position stays.
                let stand = other.of(letter).filter(|_| from != to);
                stand.is_some_and(|stand| near(from, stand) && near(to, stand))
            };
            let straight = matches!(motion.kind, MotionType::Rapid | MotionType::Linear);
            !(straight && motion.letters().filter(|letter| motion.moves(*letter)).all(stays))
        });
    }

    /// Whether two places are more than the tolerance apart.
    const fn beyond(&self, a: i64, b: i64) -> bool {
        a.abs_diff(b) > self.tolerances.position.millionths().unsigned_abs()
    }

    /// A run without counterpart is blocks added or removed when it moves; else each of its words counts by itself. A
    /// word of a moving run counts by itself, too, where what it set holds in one program alone behind the run, and
    /// where its block moves in both. `beside`: the steps of the other program in its place.
    fn end_run(&mut self, side: usize, run: Vec<usize>, beside: Range<usize>) {
        if run.is_empty() {
            return;
        }
        let (steps, other) = (self.steps(side), self.steps(1 - side));
        let moves = steps.moves(&run);
        let (words, blocks): (Vec<usize>, Vec<usize>) =
            run.iter().partition(|at| !moves || self.counts_alone(side, **at, &run));
        if moves {
            // A loop executes the same change again.
            let run = run_of(blocks.iter().filter_map(|at| steps.step(*at)));
            let kind = if side == 0 { ChangeKind::Removed } else { ChangeKind::Added };
            let behind = beside.start.checked_sub(1).and_then(|at| other.step(at)).map(|step| step.n);
            for at in blocks {
                let [old, new] = if side == 0 { [Some(at), None] } else { [None, Some(at)] };
                let change = self.note(Difference { kind, what: None, old: None, new: None }, old, new, run);
                if let Some((change, behind)) = change.zip(behind).filter(|(change, _)| change.count() == 1) {
                    change.behind = Some(behind);
                }
            }
        }
        let repeated = |at: usize| {
            let event = steps.step(at).and_then(|step| event(steps, step));
            (at, event.is_some_and(|event| other.repeats(event, beside.clone())))
        };
        let words: Vec<_> = words.into_iter().map(repeated).collect();
        if let Some(events) = self.events.get_mut(side) {
            events.extend(words);
        }
    }

    /// Whether a word of a moving run counts by itself.
    fn counts_alone(&self, side: usize, at: usize, run: &[usize]) -> bool {
        let steps = self.steps(side);
        let Some(event) = steps.step(at).and_then(|step| event(steps, step)) else { return false };
        let [old, new] = [0, 1].map(|side| self.in_force.get(side).and_then(|held| held.get(event.slot.as_str())));
        let own = if side == 0 { old } else { new };
        let holds = event.lasts && own == Some(&&event.value) && old != new;
        holds || steps.moves_beside(at, run)
    }

    /// Words in one program alone: the same ones elsewhere in the other program are one change (CMP-4).
    fn end_events(&mut self) {
        let [mut old, mut new] = std::mem::take(&mut self.events);
        old.sort_unstable();
        new.sort_unstable();
        let mut waiting: BTreeMap<u64, Vec<(usize, bool)>> = BTreeMap::new();
        for at in old.iter().rev() {
            if let Some(event) = self.old.step(at.0).and_then(|step| event(self.old, step)) {
                waiting.entry(event.word()).or_default().push(*at);
            }
        }
        for (at, repeated) in new {
            let Some(step) = self.new.step(at) else { continue };
            let Some(event) = event(self.new, step).cloned() else { continue };
            let moved = waiting.get_mut(&event.word()).and_then(Vec::pop);
            if !repeated || moved.is_some_and(|(_, repeated)| !repeated) {
                let old = moved.map(|_| event.value.clone());
                let moved = moved.map(|(at, _)| at);
                let places = moved.and_then(|at| self.old.step(at)).map(|old| run_of([old, step].into_iter()));
                self.note(difference(&event, old, Some(event.value.clone())), moved, Some(at), places.unwrap_or(0));
            }
        }
        let left = waiting.into_values().flatten();
        let mut left: Vec<usize> = left.filter(|(_, repeated)| !repeated).map(|(at, _)| at).collect();
        left.sort_unstable();
        for at in left {
            let event = self.old.step(at).and_then(|step| event(self.old, step)).cloned();
            if let Some(event) = event {
                self.note(difference(&event, Some(event.value.clone()), None), Some(at), None, 0);
            }
        }
    }

    /// The differences of two steps that are one.
    fn pair(&mut self, a: usize, b: usize) {
        let (Some(old), Some(new)) = (self.old.step(a), self.new.step(b)) else { return };
        let contexts = (Steps::context_id(old), Steps::context_id(new));
        let mut found = Vec::new();
        let mut idle = false;
        let (of_old, of_new) = (self.old.values(old), self.new.values(new));
        let same = if of_old.is_some() { of_old == of_new } else { old.token == new.token };
        if !same {
            match (self.old.does(old), self.new.does(new)) {
                (Some(Does::Motion(old)), Some(Does::Motion(new))) => self.positions(&old, &new, &mut found),
                (Some(Does::Event(was)), Some(Does::Event(is))) => {
                    let difference = difference(is, Some(was.value.clone()), Some(is.value.clone()));
                    if was.word() == is.word() {
                        // The same word, which one program has beside a motion.
                        let places = run_of([old, new].into_iter());
                        self.note(difference, Some(a), Some(b), places);
                    } else {
                        found.push(difference);
                    }
                }
                _ => {}
            }
        }
        if self.same_context != Some(contexts)
            && let (Some(old), Some(new)) = (self.old.context_of(old), self.new.context_of(new))
        {
            let before = found.len();
            idle = !(old.working && new.working);
            self.contexts(old, new, &mut found);
            if found.len() == before {
                self.same_context = Some(contexts);
            }
        }
        for difference in found {
            let of_speed = is_of_speed(difference.kind, difference.what.as_deref());
            let run = if idle && of_speed { IDLE } else { 0 };
            self.note(difference, Some(a), Some(b), run);
        }
    }

    fn positions(&self, old: &Motion, new: &Motion, found: &mut Vec<Difference>) {
        let mut deltas = [0; AxisLetter::ALL.len()];
        let beyond = |a: i64, b: i64| self.beyond(a, b);
        // Where the other program stands along an axis that it does not name; none where nobody knows, or where the
        // axis moves though its position stays.
        let stands = |side: usize, letter: AxisLetter, value: Option<i64>| {
            let of = |side: usize| self.stands.get(side).and_then(|stand| stand.of(letter));
            of(1 - side).filter(|_| of(side) != value)
        };
        let mut add = |what: &'static str, old: Option<i64>, new: Option<i64>| {
            let (old, new) = (old.map(Value::Number), new.map(Value::Number));
            found.push(Difference { kind: ChangeKind::Position, what: Some(Cow::Borrowed(what)), old, new });
        };
        for letter in AxisLetter::ALL {
            let (a, b) = match (old.value(letter), new.value(letter)) {
                (Some(None), Some(None)) => continue,
                (Some(a), Some(b)) => {
                    if let (Some(delta), Some(a), Some(b)) = (deltas.get_mut(letter as usize), a, b) {
                        *delta = b.saturating_sub(a);
                    }
                    (a, b)
                }
                (Some(a), None) if old.moves(letter) => (a, stands(0, letter, a)),
                (None, Some(b)) if new.moves(letter) => (stands(1, letter, b), b),
                _ => continue,
            };
            if a.zip(b).is_none_or(|(a, b)| beyond(a, b)) {
                add(letter.name(), a, b);
            }
        }
        let (Some(plane), Some(a), Some(b)) = (new.plane, old.center(), new.center()) else { return };
        for ((letter, what), (a, b)) in plane.into_iter().zip(["I", "J"]).zip(a.into_iter().zip(b)) {
            let shift = deltas.get(letter as usize).copied().unwrap_or(0);
            if beyond(a, b) && beyond(a.saturating_add(shift), b) {
                add(what, Some(a), Some(b));
            }
        }
        // A whole circle ends near where an arc of no length does.
        let turns = [old.sweep(), new.sweep()].map(Option::unwrap_or_default);
        if found.is_empty() && turns[0].abs_diff(turns[1]) > HALF_TURN {
            let [a, b] = turns.map(|turn| Some(Value::Text(format!("{}°", Micro::from_millionths(turn).rounded()))));
            let what = Some(Cow::Borrowed(if new.kind == MotionType::ArcCw { "G02" } else { "G03" }));
            found.push(Difference { kind: ChangeKind::Position, what, old: a, new: b });
        }
    }

    fn contexts(&self, old: &Context, new: &Context, found: &mut Vec<Difference>) {
        let near = |a: Decimal, b: Decimal| {
            let (a, b) = (Micro::from(a).to_f64(), Micro::from(b).to_f64());
            (a - b).abs() <= a.abs().max(b.abs()) * self.tolerances.percent / 100.0 + 1e-9
        };
        if old.working && new.working && old.feed != new.feed {
            let same = matches!((old.feed, new.feed), (Some((a, unit, scale)), Some((b, new_unit, new_scale)))
                if (unit, scale) == (new_unit, new_scale) && near(a, b));
            if !same {
                let units = [old.feed, new.feed].map(|feed| feed.map(|(_, unit, scale)| (unit, scale)));
                let [unit, new_unit] = units;
                let plain = unit == new_unit || unit.is_none() || new_unit.is_none();
                let value = |feed: Option<(Decimal, FeedUnit, bool)>| feed.map(|feed| feed_value(feed, plain));
                let (old, new) = (value(old.feed), value(new.feed));
                found.push(Difference { kind: ChangeKind::Feed, what: Some(Cow::Borrowed("F")), old, new });
            }
        }
        let same_speed = match (old.speed, new.speed) {
            (Some(a), Some(b)) => near(a, b),
            (a, b) => a == b,
        };
        let turn = old.turns && new.turns;
        if turn && !same_speed {
            let (old, new) = (old.speed.map(Value::from), new.speed.map(Value::from));
            found.push(Difference { kind: ChangeKind::Speed, what: Some(Cow::Borrowed("S")), old, new });
        }
        let of =
            |context: &Context, group: GGroup| context.functions.iter().copied().find(|code| code.group() == group);
        for group in GGroup::ALL {
            let (a, b) = (of(old, group), of(new, group));
            // These count where both programs have them: the plane under a radius correction, all beside a macrocycle.
            let counts =
                if INHERITED.contains(&group) { a.is_some() && b.is_some() } else { turn || group != GGroup::G6 };
            if a != b && counts {
                let text = |code: Option<GCode>| code.map(|code| Value::Text(code.to_string()));
                let what = b.or(a).map(|code| Cow::Owned(code.to_string()));
                found.push(Difference { kind: ChangeKind::Function, what, old: text(a), new: text(b) });
            }
        }
        // Where G23 itself differs, that says it all.
        let continuous = |context: &Context| context.functions.contains(&GCode::G23);
        if continuous(old) == continuous(new) && old.dynamic_set != new.dynamic_set {
            let number = |set: Option<u8>| set.map(|set| Value::from(Decimal::whole(i64::from(set))));
            let (a, b) = (number(old.dynamic_set), number(new.dynamic_set));
            let what = Some(Cow::Owned(GCode::G23.to_string()));
            found.push(Difference { kind: ChangeKind::Function, what, old: a, new: b });
        }
    }

    /// Adds a difference to its group; a `run` other than 0 has its own group.
    fn note(
        &mut self,
        difference: Difference,
        old: Option<usize>,
        new: Option<usize>,
        run: u64,
    ) -> Option<&mut Change> {
        let Difference { kind, what, old: old_value, new: new_value } = difference;
        let old_step = old.and_then(|at| self.old.step(at));
        let new_step = new.and_then(|at| self.new.step(at));
        let context = new_step.and_then(|step| self.new.context_of(step));
        let context = context.or_else(|| old_step.and_then(|step| self.old.context_of(step)));
        let tool = context.and_then(|context| context.tool);
        let delta = match (&old_value, &new_value) {
            (Some(Value::Number(a)), Some(Value::Number(b))) if a != b => Some(b.saturating_sub(*a)),
            _ => None,
        };
        let (old_blocks, new_blocks) = (Blocks::default(), Blocks::default());
        let is_x = kind == ChangeKind::Position && what.as_deref() == Some("X");
        let halved = is_x && (self.old.diameters || self.new.diameters);
        let (old, new) = (old_value, new_value);
        let change = Change { kind, tool, what, old, new, delta, halved, old_blocks, new_blocks, behind: None };
        let change = self.groups.of(run, change)?;
        old_step.into_iter().for_each(|step| change.old_blocks.add(step));
        new_step.into_iter().for_each(|step| change.new_blocks.add(step));
        Some(change)
    }
}

/// The group of changes at these steps: the same for the same blocks.
fn run_of<'s>(steps: impl Iterator<Item = &'s Step>) -> u64 {
    let mut hasher = DefaultHasher::new();
    steps.for_each(|step| step.n.hash(&mut hasher));
    // Neither no group nor that of an idle spindle.
    hasher.finish().clamp(1, IDLE - 1)
}

fn feed_value((value, unit, hundredth): (Decimal, FeedUnit, bool), plain: bool) -> Value {
    if plain {
        return Value::from(value);
    }
    let scale = if hundredth { " (M37)" } else { "" };
    Value::Text(format!("{value} {}{scale}", unit.name()))
}

fn event<'s>(steps: &'s Steps, step: &Step) -> Option<&'s Event> {
    match steps.does(step) {
        Some(Does::Event(event)) => Some(event),
        Some(Does::Motion(_)) | None => None,
    }
}

fn difference(event: &Event, old: Option<Value>, new: Option<Value>) -> Difference {
    // M functions are called by their numbers.
    let function = |value: &Option<Value>| match value {
        Some(Value::Text(text)) if event.slot.starts_with('m') => Some(text.clone()),
        Some(Value::Text(_) | Value::Number(_)) | None => None,
    };
    let what = function(&new).or_else(|| function(&old)).map(Cow::Owned);
    let what = match event.kind {
        ChangeKind::Dwell => None,
        ChangeKind::Tool => Some(Cow::Borrowed("T")),
        ChangeKind::Position
        | ChangeKind::Feed
        | ChangeKind::Speed
        | ChangeKind::Function
        | ChangeKind::Stop
        | ChangeKind::Correction
        | ChangeKind::Data
        | ChangeKind::Parameter
        | ChangeKind::Added
        | ChangeKind::Removed => what.or_else(|| Some(Cow::Owned(event.slot.clone()))),
    };
    Difference { kind: event.kind, what, old, new }
}
