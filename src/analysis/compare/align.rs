//! Which step of one program is which of the other: the same ones first, between them those that move by the same
//! increments, then those of one kind that are near each other (CMP-2).

use std::collections::HashMap;
use std::ops::Range;

use imara_diff::{Algorithm, Diff, Token};

use super::near::by_nearness;
use super::steps::{Steps, increments};

/// A step of one program or both, by index.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Aligned {
    Both(usize, usize),
    Old(usize),
    New(usize),
}

/// Gives both programs step by step. It is the mirror image of what the exchanged programs give.
pub(super) fn align(old: &Steps, new: &Steps, mut give: impl FnMut(Aligned)) {
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
    each(&a, &b, |same, before, after| {
        if same {
            before.zip(after).for_each(|(a, b)| give(turned(Aligned::Both(a, b))));
            return;
        }
        // A shifted run moves by the same increments.
        let (a, b) = (increments(first, &before), increments(second, &after));
        each(&a, &b, |same, from, to| {
            let from = from.start + before.start..from.end + before.start;
            let to = to.start + after.start..to.end + after.start;
            if same {
                from.zip(to).for_each(|(a, b)| give(turned(Aligned::Both(a, b))));
            } else {
                pair((first, from), (second, to), &mut |aligned| give(turned(aligned)));
            }
        });
    });
}

/// Pairs steps of one kind: in short runs the nearest ones, in long ones in their order.
fn pair((first, from): (&Steps, Range<usize>), (second, to): (&Steps, Range<usize>), give: &mut dyn FnMut(Aligned)) {
    if by_nearness((first, from.clone()), (second, to.clone()), give) {
        return;
    }
    let kinds = |steps: &Steps, range: &Range<usize>| {
        let steps_in = steps.list.get(range.clone()).unwrap_or_default();
        steps_in.iter().map(|step| steps.kind(step)).collect::<Vec<_>>()
    };
    let (a, b) = (kinds(first, &from), kinds(second, &to));
    each(&a, &b, |same, before, after| {
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

/// Gives the runs of two sequences in order: whether they are the same, and where.
fn each(a: &[u64], b: &[u64], mut give: impl FnMut(bool, Range<usize>, Range<usize>)) {
    let mut known: HashMap<u64, u32> = HashMap::new();
    let mut intern = |list: &[u64]| {
        let token = |value: &u64| {
            let next = u32::try_from(known.len()).unwrap_or(u32::MAX);
            Token(*known.entry(*value).or_insert(next))
        };
        list.iter().map(token).collect::<Vec<_>>()
    };
    let (before, after) = (intern(a), intern(b));
    let count = u32::try_from(known.len()).unwrap_or(u32::MAX);
    let mut diff = Diff::default();
    diff.compute_with(Algorithm::Myers, &before, &after, count);
    let (mut from, mut to) = (0, 0);
    for hunk in diff.hunks() {
        let [old, new] = [&hunk.before, &hunk.after].map(|range| range.start as usize..range.end as usize);
        give(true, from..old.start, to..new.start);
        (from, to) = (old.end, new.end);
        give(false, old, new);
    }
    give(true, from..a.len(), to..b.len());
}
