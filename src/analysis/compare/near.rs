//! Steps of short runs paired with the nearest of their kind (CMP-2).

use std::ops::Range;

use super::align::Aligned;
use super::steps::{Does, Motion, Stand, Step, Steps, Value};
use crate::dict::AxisLetter;

/// Longest runs are paired so while the product of their lengths is no more.
const MOST: usize = 10_000;

/// The cost of a step without a counterpart; two of them cost more than any pair of one kind.
const ALONE: f64 = 0.6;

/// The cost of a pair that moves along different axes, beside its distance: only motions that are near are paired.
const OTHER_AXES: f64 = 0.9;

/// Distance in mm at which a pair costs half of the most that it can cost.
const HALF_MM: f64 = 5.0;

/// Pairs the steps of two runs so that the sum of distances is least. `false`: the runs are too long, nothing was
/// given.
pub(super) fn by_nearness(
    (first, from): (&Steps, Range<usize>),
    (second, to): (&Steps, Range<usize>),
    give: &mut dyn FnMut(Aligned),
) -> bool {
    let (rows, columns) = (from.len(), to.len());
    if rows == 0 || columns == 0 {
        from.for_each(|at| give(Aligned::Old(at)));
        to.for_each(|at| give(Aligned::New(at)));
        return true;
    }
    if rows.saturating_mul(columns) > MOST {
        return false;
    }
    let (rows_ready, columns_ready) = (Point::all(first, &from), Point::all(second, &to));
    // From the ends, so that the way is read from the beginning.
    let width = columns + 1;
    let mut ways = vec![Way::Old; (rows + 1) * width];
    let mut below: Vec<f64> = Vec::with_capacity(width);
    for left in (0..=columns).rev() {
        below.push(cost_of(left));
        if let Some(way) = ways.get_mut(rows * width + columns - left) {
            *way = Way::New;
        }
    }
    for (row, old_step) in rows_ready.iter().enumerate().rev() {
        let mut right = cost_of(rows - row);
        let mut costs = vec![right; width];
        for (column, new_step) in columns_ready.iter().enumerate().rev() {
            let near = distance(old_step, new_step);
            let cost = |list: &[f64], at: usize| list.get(at).copied().unwrap_or(f64::INFINITY);
            let both = near.map_or(f64::INFINITY, |near| near + cost(&below, column + 1));
            let (old, new) = (ALONE + cost(&below, column), ALONE + right);
            let (least, way) = if both <= old && both <= new {
                (both, Way::Both)
            } else if old <= new {
                (old, Way::Old)
            } else {
                (new, Way::New)
            };
            right = least;
            if let (Some(slot), Some(step)) = (costs.get_mut(column), ways.get_mut(row * width + column)) {
                (*slot, *step) = (least, way);
            }
        }
        below = costs;
    }
    follow(&ways, (from, to), give);
    true
}

#[derive(Clone, Copy, Debug, Eq, PartialEq)]
enum Way {
    Both,
    Old,
    New,
}

/// So many steps alone.
fn cost_of(steps: usize) -> f64 {
    (0..steps).map(|_| ALONE).sum()
}

fn follow(ways: &[Way], (from, to): (Range<usize>, Range<usize>), give: &mut dyn FnMut(Aligned)) {
    let width = to.len() + 1;
    let (mut row, mut column) = (0, 0);
    while row < from.len() || column < to.len() {
        let way = ways.get(row * width + column).copied().unwrap_or(Way::Old);
        match way {
            Way::Both => give(Aligned::Both(from.start + row, to.start + column)),
            Way::Old => give(Aligned::Old(from.start + row)),
            Way::New => give(Aligned::New(to.start + column)),
        }
        row += usize::from(way != Way::New);
        column += usize::from(way != Way::Old);
    }
}

/// What counts of a step when it is compared with many.
struct Point<'s> {
    kind: u64,
    motion: Option<Motion>,
    stand: Stand,
    event: Option<&'s Value>,
}

impl<'s> Point<'s> {
    fn all(steps: &'s Steps, range: &Range<usize>) -> Vec<Self> {
        let mut stand = Stand::before(steps, range.start);
        let point = |step: &Step| {
            stand.pass(steps, step);
            let (motion, event) = match steps.does(step) {
                Some(Does::Motion(motion)) => (Some(motion), None),
                Some(Does::Event(event)) => (None, Some(&event.value)),
                None => (None, None),
            };
            Self { kind: steps.kind(step, false), motion, stand, event }
        };
        steps.list.get(range.clone()).unwrap_or_default().iter().map(point).collect()
    }
}

/// How far two steps are from each other, 0 to 1; nothing of two kinds.
fn distance(a: &Point<'_>, b: &Point<'_>) -> Option<f64> {
    if a.kind != b.kind {
        return None;
    }
    if a.event.is_some() {
        return Some(if a.event == b.event { 0.0 } else { 0.5 });
    }
    let (Some(from), Some(to)) = (&a.motion, &b.motion) else { return Some(0.0) };
    let place = |point: &Point<'_>, motion: &Motion, letter: AxisLetter| {
        motion.value(letter).unwrap_or_else(|| point.stand.of(letter))
    };
    let apart = |letter: &AxisLetter| {
        let (a, b) = (place(a, from, *letter)?, place(b, to, *letter)?);
        Some(a.abs_diff(b))
    };
    let moved = AxisLetter::ALL.iter().filter(|letter| from.moves_along(**letter) || to.moves_along(**letter));
    let centers = from.center().zip(to.center()).into_iter().flat_map(|(a, b)| a.into_iter().zip(b));
    let centers = centers.map(|(a, b)| a.abs_diff(b));
    let mm = moved.filter_map(apart).chain(centers).map(|apart| apart as f64 / 1e6).sum::<f64>();
    let near = mm / (mm + HALF_MM);
    Some(if from.moving() == to.moving() { near } else { OTHER_AXES + near })
}
