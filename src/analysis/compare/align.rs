//! Which step of one program is which of the other: the same motions first, between them the same steps, then those
//! that move by the same increments, then those of one kind that are near each other (CMP-2).

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;

use imara_diff::{Algorithm, Diff, Token};

use super::near::by_nearness;
use super::steps::{Steps, increments, rounded, tokens};
use crate::sure::small;

/// A step of one program or both, by index.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Aligned {
    Both(usize, usize),
    Old(usize),
    New(usize),
}

/// Gives both programs step by step. It is the mirror image of what the exchanged programs give.
///
/// `tolerance`: places up to so many millionths apart are the same.
pub(super) fn align(old: &Steps, new: &Steps, tolerance: i64, mut give: impl FnMut(Aligned)) {
    let swapped = old.list.iter().map(|step| step.token).gt(new.list.iter().map(|step| step.token));
    let turned = |aligned| match aligned {
        Aligned::Both(a, b) if swapped => Aligned::Both(b, a),
        Aligned::Old(at) if swapped => Aligned::New(at),
        Aligned::New(at) if swapped => Aligned::Old(at),
        Aligned::Both(..) | Aligned::Old(_) | Aligned::New(_) => aligned,
    };
    let (first, second) = if swapped { (new, old) } else { (old, new) };
    let ranges = (0..first.list.len(), 0..second.list.len());
    let aligner = Aligner { first, second, tolerance };
    aligner.refine(ranges, Alike::Motions, &mut |aligned| give(turned(aligned)));
}

/// Runs of either program.
type Runs = (Range<usize>, Range<usize>);

/// What steps of two runs may have in common, in the order of trying.
#[derive(Clone, Copy, Eq, PartialEq)]
enum Alike {
    /// Motions may be the same: where these and the words between them changed places, the words stand elsewhere
    /// (CMP-4).
    Motions,
    /// Steps may be the same.
    Exact,
    /// Steps may be the same but for some digits.
    Rounded,
    /// Steps may move by the same increments.
    Shifted,
}

impl Alike {
    /// How steps between those may still be alike.
    const fn next(self) -> Option<Self> {
        match self {
            Self::Motions => Some(Self::Exact),
            Self::Exact => Some(Self::Rounded),
            Self::Rounded => Some(Self::Shifted),
            Self::Shifted => None,
        }
    }
}

/// Steps whose places are the same on a grid of so many tolerances may be the same.
const GRID: i64 = 4;

struct Aligner<'s> {
    first: &'s Steps,
    second: &'s Steps,
    tolerance: i64,
}

impl Aligner<'_> {
    /// Whether two steps are the same, up to the tolerance.
    fn is_near(&self, (a, b): (usize, usize)) -> bool {
        let both = self.first.step(a).zip(self.second.step(b));
        both.is_some_and(|(a, b)| a.token == b.token || self.first.is_near(a, (self.second, b), self.tolerance))
    }

    /// Aligns two runs: the steps that are the same at either end, or in their places where most are; else by what is
    /// alike.
    fn refine(&self, (from, to): Runs, alike: Alike, give: &mut dyn FnMut(Aligned)) {
        let start = from.clone().zip(to.clone()).take_while(|both| self.is_near(*both)).count();
        let (rest, other) = (from.start + start..from.end, to.start + start..to.end);
        let tail = rest.clone().rev().zip(other.clone().rev()).take_while(|both| self.is_near(*both)).count();
        let middle = (rest.start..rest.end - tail, other.start..other.end - tail);
        from.zip(to).take(start).for_each(|(a, b)| give(Aligned::Both(a, b)));
        let ends = (middle.0.end..rest.end, middle.1.end..other.end);
        if middle.0.is_empty() || middle.1.is_empty() {
            middle.0.for_each(|at| give(Aligned::Old(at)));
            middle.1.for_each(|at| give(Aligned::New(at)));
        } else {
            self.refine_middle(middle, alike, give);
        }
        ends.0.zip(ends.1).for_each(|(a, b)| give(Aligned::Both(a, b)));
    }

    fn refine_middle(&self, (from, to): Runs, alike: Alike, give: &mut dyn FnMut(Aligned)) {
        let near = || from.clone().zip(to.clone()).filter(|both| self.is_near(*both)).count();
        if from.len() == to.len() && near() * 2 > from.len() {
            return self.in_place((from, to), give);
        }
        let alike = if alike == Alike::Motions && self.is_shifted(&from, &to) { Alike::Shifted } else { alike };
        let ((places, a), (others, b)) = (self.keys(self.first, &from, alike), self.keys(self.second, &to, alike));
        let (mut before, mut after) = (from.start, to.start);
        each(a, b, |same, old, new| {
            let both = old.zip(new).take_while(|_| same);
            for (a, b) in both.filter_map(|(a, b)| Some((*places.get(a)?, *others.get(b)?))) {
                self.between((before..a, after..b), alike, give);
                give(Aligned::Both(a, b));
                (before, after) = (a + 1, b + 1);
            }
        });
        self.between((before..from.end, after..to.end), alike, give);
    }

    /// Aligns what is between steps that are alike.
    fn between(&self, (from, to): Runs, alike: Alike, give: &mut dyn FnMut(Aligned)) {
        match alike.next() {
            Some(next) => self.refine((from, to), next, give),
            None => pair((self.first, from), (self.second, to), give),
        }
    }

    /// The steps of a run that may have something in common with those of the other one: where each is, and what.
    fn keys(&self, steps: &Steps, range: &Range<usize>, alike: Alike) -> (Vec<usize>, Vec<u64>) {
        let keys = match alike {
            Alike::Motions | Alike::Exact => tokens(steps, range),
            Alike::Rounded => rounded(steps, range, self.tolerance.max(1).saturating_mul(GRID)),
            Alike::Shifted => increments(steps, range),
        };
        let counts = |at: usize| alike != Alike::Motions || steps.step(at).is_some_and(Steps::is_motion);
        range.clone().zip(keys).filter(|(at, _)| counts(*at)).unzip()
    }

    /// Pairs the steps that are the same in their places, and aligns what is between them.
    fn in_place(&self, (from, to): Runs, give: &mut dyn FnMut(Aligned)) {
        let (mut before, mut after) = (from.start, to.start);
        for (a, b) in from.clone().zip(to.clone()).filter(|both| self.is_near(*both)) {
            self.refine((before..a, after..b), Alike::Motions, give);
            give(Aligned::Both(a, b));
            (before, after) = (a + 1, b + 1);
        }
        self.refine((before..from.end, after..to.end), Alike::Motions, give);
    }

    /// Whether most steps move by the same increments in their places: a shift. Some of the shifted points may be
    /// points of the other program too, elsewhere.
    fn is_shifted(&self, from: &Range<usize>, to: &Range<usize>) -> bool {
        if from.len() != to.len() {
            return false;
        }
        let (old, new) = (increments(self.first, from), increments(self.second, to));
        old.iter().zip(&new).filter(|(old, new)| old == new).count() * 2 > from.len()
    }
}

/// Pairs steps of one kind: in short runs the nearest ones, in long ones in their order.
fn pair((first, from): (&Steps, Range<usize>), (second, to): (&Steps, Range<usize>), give: &mut dyn FnMut(Aligned)) {
    if by_nearness((first, from.clone()), (second, to.clone()), give) {
        return;
    }
    let kinds = |steps: &Steps, range: &Range<usize>| {
        let steps_in = steps.list.get(range.clone()).unwrap_or_default();
        steps_in.iter().map(|step| steps.kind(step, true)).collect::<Vec<_>>()
    };
    let (a, b) = (kinds(first, &from), kinds(second, &to));
    each(a, b, |same, before, after| {
        let before = before.start + from.start..before.end + from.start;
        let after = after.start + to.start..after.end + to.start;
        if same {
            before.zip(after).for_each(|(a, b)| give(Aligned::Both(a, b)));
        } else {
            before.for_each(|at| give(Aligned::Old(at)));
            after.for_each(|at| give(Aligned::New(at)));
        }
    });
}

/// Gives the runs of two sequences in order: whether they are the same, and where. The sequences are gone by then.
fn each(a: Vec<u64>, b: Vec<u64>, mut give: impl FnMut(bool, Range<usize>, Range<usize>)) {
    let (end_a, end_b) = (a.len(), b.len());
    let mut same = common(&a, &b);
    drop((a, b));
    same.push(Run { a: end_a, b: end_b, length: 0 });
    let (mut from, mut to) = (0, 0);
    for Run { a, b, length } in same {
        if (from, to) != (a, b) {
            give(false, from..a, to..b);
        }
        (from, to) = (a + length, b + length);
        if length > 0 {
            give(true, a..from, b..to);
        }
    }
}

/// Where two sequences are the same.
#[derive(Clone, Copy, Debug)]
struct Run {
    a: usize,
    b: usize,
    length: usize,
}

/// How far two sequences are the same from their beginnings, and behind that from their ends.
fn alike(a: &[u64], b: &[u64]) -> (usize, usize) {
    let start = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let (rest_a, rest_b) = (a.get(start..).unwrap_or_default(), b.get(start..).unwrap_or_default());
    (start, rest_a.iter().rev().zip(rest_b.iter().rev()).take_while(|(a, b)| a == b).count())
}

/// The longest runs in which two sequences are the same, in their order.
fn common(a: &[u64], b: &[u64]) -> Vec<Run> {
    let (start, tail) = alike(a, b);
    let (rest_a, rest_b) = (a.get(start..).unwrap_or_default(), b.get(start..).unwrap_or_default());
    let middle = |rest: &[u64], other: &[u64]| {
        let inner = |list: &[u64]| list.len() - tail;
        labelled(rest.get(..inner(rest)).unwrap_or_default(), other.get(..inner(other)).unwrap_or_default())
    };
    let mut found = vec![Run { a: 0, b: 0, length: start }];
    let mut add = |next: Run| match found.last_mut() {
        Some(run) if (run.a + run.length, run.b + run.length) == (next.a, next.b) => run.length += next.length,
        _ => found.push(next),
    };
    matched(&middle(rest_a, rest_b), &middle(rest_b, rest_a), &mut |a, b| {
        add(Run { a: a + start, b: b + start, length: 1 });
    });
    add(Run { a: a.len() - tail, b: b.len() - tail, length: tail });
    found
}

/// A step that may be matched: equal labels are the same, and where it is.
type Labelled = (u64, usize);

/// The steps of a list that the other one has too. One that is there often has another label after so many: Myers is
/// quick where no label is everywhere.
fn labelled(list: &[u64], other: &[u64]) -> Vec<Labelled> {
    const OFTEN: u32 = 50;
    let mut known = other.to_vec();
    known.sort_unstable();
    let shared = list.iter().enumerate().filter(|(_, token)| known.binary_search(token).is_ok());
    let mut counts: HashMap<u64, u32> = HashMap::new();
    let label = |(at, token): (usize, &u64)| {
        let count = counts.entry(*token).or_default();
        *count += 1;
        let mut hasher = DefaultHasher::new();
        (token, *count / OFTEN).hash(&mut hasher);
        (hasher.finish(), at)
    };
    shared.map(label).collect()
}

/// Gives the places of steps that are the same. What is long is matched at a sample of its steps, then between those:
/// the bound of Myers grows with the length.
fn matched(x: &[Labelled], y: &[Labelled], give: &mut dyn FnMut(usize, usize)) {
    const LONG: usize = 1 << 14;
    const SAMPLE: u64 = 16;
    let (mut from, mut to) = (0, 0);
    if x.len().max(y.len()) > LONG {
        let sample = |list: &[Labelled]| {
            let sampled = list.iter().zip(0..).filter(|((label, _), _)| label % SAMPLE == 0);
            sampled.map(|((label, _), at)| (label / SAMPLE, at)).collect::<Vec<_>>()
        };
        matched(&sample(x), &sample(y), &mut |a, b| {
            myers(x.get(from..=a).unwrap_or_default(), y.get(to..=b).unwrap_or_default(), give);
            (from, to) = (a + 1, b + 1);
        });
    }
    myers(x.get(from..).unwrap_or_default(), y.get(to..).unwrap_or_default(), give);
}

/// The same for steps as they are.
fn myers(x: &[Labelled], y: &[Labelled], give: &mut dyn FnMut(usize, usize)) {
    let mut known: HashMap<u64, u32> = HashMap::new();
    let mut intern = |list: &[Labelled]| {
        let token = |(label, _): &Labelled| {
            let next = small(known.len());
            Token(*known.entry(*label).or_insert(next))
        };
        list.iter().map(token).collect::<Vec<_>>()
    };
    let (before, after) = (intern(x), intern(y));
    let count = small(known.len());
    let mut diff = Diff::default();
    diff.compute_with(Algorithm::Myers, &before, &after, count);
    let kept = |list: &[Labelled], is_changed: &dyn Fn(u32) -> bool| {
        let kept = list.iter().zip(0..).filter(|(_, at)| !is_changed(*at));
        kept.map(|((_, at), _)| *at).collect::<Vec<_>>()
    };
    let old = kept(x, &|at| diff.is_removed(at));
    old.into_iter().zip(kept(y, &|at| diff.is_added(at))).for_each(|(a, b)| give(a, b));
}
