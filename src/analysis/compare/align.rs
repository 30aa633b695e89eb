//! Which step of one program is which of the other: the same ones first, between them those that move by the same
//! increments, then those of one kind that are near each other (CMP-2).

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;

use imara_diff::{Algorithm, Diff, Token};

use super::near::by_nearness;
use super::steps::{Steps, increments, rounded};
use super::straight::Straight;
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
pub(super) fn align(old: &Steps, new: &Steps, tolerance: i64, give: impl FnMut(Aligned)) {
    let mut straight = Straight::new([old, new], give);
    let tokens = |steps: &Steps| steps.list.iter().map(|step| step.token).collect::<Vec<_>>();
    let (a, b) = (tokens(old), tokens(new));
    let swapped = a > b;
    let turned = |aligned| match aligned {
        Aligned::Both(a, b) if swapped => Aligned::Both(b, a),
        Aligned::Old(at) if swapped => Aligned::New(at),
        Aligned::New(at) if swapped => Aligned::Old(at),
        Aligned::Both(..) | Aligned::Old(_) | Aligned::New(_) => aligned,
    };
    let (first, second) = if swapped { (new, old) } else { (old, new) };
    let (a, b) = if swapped { (b, a) } else { (a, b) };
    let shifted = shifted((first, &a), (second, &b));
    let mut part = |alike: Alike, before: Range<usize>, after: Range<usize>| {
        refine((first, before), (second, after), alike, tolerance, &mut |aligned| straight.push(turned(aligned)));
    };
    match shifted {
        Some(middle) => {
            let end = a.len();
            part(Alike::Same, 0..middle.start, 0..middle.start);
            part(Alike::Shifted, middle.clone(), middle.clone());
            part(Alike::Same, middle.end..end, middle.end..end);
        }
        None => each(a, b, |same, before, after| part(if same { Alike::Same } else { Alike::Rounded }, before, after)),
    }
    straight.flush();
}

/// The steps that two programs differ in, where most of them move by the same increments in their places: a shift. Some
/// of the shifted points may be points of the other program too, elsewhere.
fn shifted((first, a): (&Steps, &[u64]), (second, b): (&Steps, &[u64])) -> Option<Range<usize>> {
    if a.len() != b.len() {
        return None;
    }
    let (start, tail) = alike(a, b);
    let middle = start..a.len() - tail;
    let (old, new) = (increments(first, &middle), increments(second, &middle));
    let same = old.iter().zip(&new).filter(|(old, new)| old == new).count();
    (!middle.is_empty() && same * 2 > middle.len()).then_some(middle)
}

/// What steps of two runs may have in common.
#[derive(Clone, Copy)]
enum Alike {
    /// They are the same one by one.
    Same,
    /// Most of them may be the same but for some digits.
    Rounded,
    /// They may move by the same increments.
    Shifted,
}

/// Steps whose places are the same on a grid of so many tolerances may be the same.
const GRID: i64 = 4;

/// Aligns two runs: those steps that are the same within the tolerance at either end, then what is alike.
fn refine(
    (first, from): (&Steps, Range<usize>),
    (second, to): (&Steps, Range<usize>),
    alike: Alike,
    tolerance: i64,
    give: &mut dyn FnMut(Aligned),
) {
    let is_near = |(a, b): &(usize, usize)| {
        let both = first.step(*a).zip(second.step(*b));
        both.is_some_and(|(a, b)| a.token == b.token || first.is_near(a, (second, b), tolerance))
    };
    let start = match alike {
        Alike::Same => from.len(),
        Alike::Rounded | Alike::Shifted => from.clone().zip(to.clone()).take_while(is_near).count(),
    };
    let (rest, other) = (from.start + start..from.end, to.start + start..to.end);
    let tail = rest.clone().rev().zip(other.clone().rev()).take_while(is_near).count();
    let (before, after) = (rest.start..rest.end - tail, other.start..other.end - tail);
    from.zip(to).take(start).for_each(|(a, b)| give(Aligned::Both(a, b)));
    let inner = |same: bool, (from, to): (Range<usize>, Range<usize>), give: &mut dyn FnMut(Aligned)| {
        let from = from.start + before.start..from.end + before.start;
        let to = to.start + after.start..to.end + after.start;
        match alike {
            _ if same => from.zip(to).for_each(|(a, b)| give(Aligned::Both(a, b))),
            Alike::Same | Alike::Rounded => {
                refine((first, from), (second, to), Alike::Shifted, tolerance, give);
            }
            Alike::Shifted => pair((first, from), (second, to), give),
        }
    };
    if !before.is_empty() || !after.is_empty() {
        let (a, b) = match alike {
            Alike::Same | Alike::Rounded => {
                let grid = tolerance.max(1).saturating_mul(GRID);
                (rounded(first, &before, grid), rounded(second, &after, grid))
            }
            // A shifted run moves by the same increments.
            Alike::Shifted => (increments(first, &before), increments(second, &after)),
        };
        each(a, b, |same, from, to| inner(same, (from, to), give));
    }
    let ends = before.end..before.end + tail;
    ends.zip(after.end..after.end + tail).for_each(|(a, b)| give(Aligned::Both(a, b)));
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
