//! The lines of a still picture: those of the program, joined while they go on in one kind, without those that others
//! cover. A program that goes to and fro a million times draws each place a few times, not a million.

use std::collections::{BTreeMap, HashSet};

use super::display::{Class, Item, Place};
use super::lines::{Lines, Stroke};
use super::projection::Projection;

/// Points that are nearer to the one before, in pixels, are left out.
const SAME: f64 = 0.15;
/// Programs with more motions are thinned.
const MANY: usize = 20_000;
/// Lines shorter than this are always drawn: they cost little.
const SHORT: f64 = 8.0;
/// Lines whose ends are in the same squares with sides of so many pixels are one.
const END: f64 = 0.25;
/// Where so many lines run through each square of so many pixels on its way, one more changes nothing.
const COVERED: (u8, f64) = (6, 4.0);

/// The lines, kind by kind in the order of the program.
pub(super) fn chains(
    lines: &Lines<'_>,
    strokes: &[(usize, Stroke)],
    projection: &Projection,
    [width, height]: [u32; 2],
) -> Vec<Item> {
    let deviation = 0.1 / projection.scale;
    let mut chains = Chains::default();
    let mut thin = (strokes.len() > MANY).then(|| Thin::new(width, height));
    for (row, stroke) in strokes {
        let mut before: Option<Place> = None;
        lines.points(*row, deviation, |point| {
            let place = projection.at(point);
            if let Some(before) = before.replace(place) {
                if thin.as_mut().is_none_or(|thin| thin.adds(*stroke, before, place)) {
                    chains.add(*stroke, before, place);
                } else {
                    chains.close();
                }
            }
        });
    }
    chains.close();
    let Chains { mut items, .. } = chains;
    // Rapid motions lie under working ones, and what has one colour is painted at once.
    items.sort_by_key(|(stroke, _)| *stroke);
    items.into_iter().map(|(stroke, places)| Item::Lines(class(stroke), places)).collect()
}

const fn class(stroke: Stroke) -> Class {
    match stroke {
        Stroke::Rapid => Class::Rapid,
        Stroke::Straight => Class::Straight,
        Stroke::Arc => Class::Arc,
        Stroke::Thread => Class::Thread,
    }
}

fn near([ax, ay]: Place, [bx, by]: Place, reach: f64) -> bool {
    (ax - bx).abs() <= reach && (ay - by).abs() <= reach
}

/// Lines that are joined.
#[derive(Default)]
struct Chains {
    items: Vec<(Stroke, Vec<Place>)>,
    /// The one that may go on, and where it ends.
    open: Option<(Stroke, Vec<Place>, Place)>,
}

impl Chains {
    fn add(&mut self, stroke: Stroke, from: Place, to: Place) {
        let goes_on = self.open.as_ref().is_some_and(|(kind, _, last)| *kind == stroke && near(*last, from, 1e-6));
        if !goes_on {
            self.close();
        }
        let (_, places, last) = self.open.get_or_insert_with(|| (stroke, vec![from], from));
        *last = to;
        if places.last().is_none_or(|before| !near(*before, to, SAME)) {
            places.push(to);
        }
    }

    fn close(&mut self) {
        if let Some((stroke, mut places, last)) = self.open.take() {
            if places.last() != Some(&last) || places.len() == 1 {
                places.push(last);
            }
            self.items.push((stroke, places));
        }
    }
}

/// What is drawn so far.
struct Thin {
    ends: HashSet<(Stroke, [i32; 4])>,
    columns: usize,
    rows: usize,
    /// By kind: how many lines run through each square.
    covered: BTreeMap<Stroke, Vec<u8>>,
}

impl Thin {
    fn new(width: u32, height: u32) -> Self {
        let [columns, rows] =
            [width, height].map(|side| whole(f64::from(side) / COVERED.1).unsigned_abs() as usize + 1);
        Self { ends: HashSet::new(), columns, rows, covered: BTreeMap::new() }
    }

    /// Whether a line shows something that others do not.
    fn adds(&mut self, stroke: Stroke, from: Place, to: Place) -> bool {
        let ([ax, ay], [bx, by]) = (from, to);
        let (dx, dy) = (bx - ax, by - ay);
        let length = dx.abs().max(dy.abs());
        if length < SHORT {
            return true;
        }
        let [start, end] = [from, to].map(|place| place.map(|value| whole(value / END)));
        let [[ax4, ay4], [bx4, by4]] = if start <= end { [start, end] } else { [end, start] };
        if !self.ends.insert((stroke, [ax4, ay4, bx4, by4])) {
            return false;
        }
        let (most, side) = COVERED;
        let (columns, rows) = (self.columns, self.rows);
        let covered = self.covered.entry(stroke).or_insert_with(|| vec![0; columns * rows]);
        let steps = whole(length / (2.0 * side));
        let squares = (0..=steps).filter_map(|step| {
            let share = f64::from(step) / f64::from(steps);
            let [x, y] = [ax + dx * share, ay + dy * share].map(|value| usize::try_from(whole(value / side)));
            Some(y.ok().filter(|y| *y < rows)? * columns + x.ok().filter(|x| *x < columns)?)
        });
        if squares.clone().all(|square| covered.get(square).is_some_and(|count| *count >= most)) {
            return false;
        }
        for square in squares {
            if let Some(count) = covered.get_mut(square) {
                *count = count.saturating_add(1);
            }
        }
        true
    }
}

#[expect(clippy::cast_possible_truncation, reason = "saturating; places on a picture are small")]
const fn whole(value: f64) -> i32 {
    value.floor() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_others_cover_is_left_out() {
        let mut thin = Thin::new(200, 100);
        assert!(thin.adds(Stroke::Straight, [10.0, 10.0], [150.0, 10.0]));
        assert!(!thin.adds(Stroke::Straight, [150.1, 10.1], [10.1, 10.0]), "the way back");
        assert!(thin.adds(Stroke::Rapid, [10.0, 10.0], [150.0, 10.0]), "of another kind");
        assert!(thin.adds(Stroke::Straight, [10.0, 10.0], [13.0, 10.0]), "short ones stay");
        assert!(thin.adds(Stroke::Straight, [10.0, 10.0], [13.0, 10.0]));
        let drawn = (0..1000).filter(|step| {
            let y = 40.0 + f64::from(*step) / 100.0;
            thin.adds(Stroke::Straight, [10.0, y], [150.0, 60.0 - y / 3.0])
        });
        assert!((30..80).contains(&drawn.count()), "ten pixels are not covered by fewer, and need no more");
    }
}
