//! Planning a piece of the way again, and what VEL-12 takes back by it.

#![expect(clippy::indexing_slicing, reason = "ids and places index the lists they were made for")]

use super::{Curve, HARD, NONE, Place};

/// Beside two for each place, so many steps find the humps of a piece.
const STEPS: usize = 64;

impl Curve {
    /// Takes back rises between two lowest places that save too little against holding the higher of them (VEL-12).
    pub(super) fn take_back_rises(&mut self, raise_s: f64) {
        let mut left = 0;
        loop {
            let Some((right, time)) = self.next_lowest(left) else { return };
            let (l, r) = (self.places[left], self.places[right]);
            let higher = l.v.max(r.v);
            if higher > 0.0 && self.rises_above(left, right, higher) {
                let kept = self.places.len();
                let saved = self.room(left, right);
                let time_held = self.hold(left, right, higher);
                if time_held.is_finite() && time_held - time < raise_s {
                    self.taken_back = true;
                    // The higher one is no lowest place any more: looked at again from the one before.
                    if l.v >= r.v {
                        left = self.lowest_before(left);
                    } else if self.places[right].next == NONE {
                        return;
                    }
                    continue;
                }
                self.restore(&saved, kept);
            }
            left = right;
        }
    }

    /// The next place behind `left` that is lower than what is around it, or the last one; with the time up to there.
    pub(super) fn next_lowest(&self, left: usize) -> Option<(usize, f64)> {
        let mut at = left;
        let mut time = 0.0;
        let mut fallen = false;
        loop {
            let place = self.places[at];
            if place.next == NONE {
                return (at != left).then_some((at, time));
            }
            let hump = place.hump?;
            if at != left && fallen && hump.peak > hump.from {
                return Some((at, time));
            }
            time += hump.time();
            if hump.to < hump.peak {
                fallen = true;
            } else if hump.peak > hump.from {
                fallen = false;
            }
            at = place.next;
        }
    }

    /// The lowest place before `id`, or the first one.
    fn lowest_before(&self, id: usize) -> usize {
        let mut at = id;
        let mut falls = false;
        while let Some(before) = self.places.get(self.places[at].prev) {
            let id = self.places[at].prev;
            if let Some(hump) = before.hump {
                // Backwards: it goes down when the hump rises towards where we come from.
                if falls && hump.to < hump.peak {
                    return at;
                }
                if hump.peak > hump.from {
                    falls = true;
                }
            }
            at = id;
        }
        at
    }

    /// Whether a place is still among those of the plan.
    pub(super) fn is_linked(&self, id: usize) -> bool {
        self.places.get(self.places[id].prev).is_none_or(|before| before.next == id)
    }

    pub(super) fn rises_above(&self, left: usize, right: usize, level: f64) -> bool {
        let mut at = left;
        while at != right {
            let place = self.places[at];
            if place.hump.is_some_and(|hump| hump.peak > level * (1.0 + 1e-12)) {
                return true;
            }
            at = place.next;
        }
        false
    }

    /// What is needed to undo [`Self::hold`].
    pub(super) fn room(&self, left: usize, right: usize) -> Vec<(usize, Place)> {
        let around = [self.places[left].prev, self.places[right].next];
        let mut saved: Vec<_> =
            around.into_iter().filter_map(|id| self.places.get(id).map(|place| (id, *place))).collect();
        let mut at = left;
        loop {
            saved.push((at, self.places[at]));
            if at == right {
                return saved;
            }
            at = self.places[at].next;
        }
    }

    pub(super) fn restore(&mut self, saved: &[(usize, Place)], count: usize) {
        self.places.truncate(count);
        for &(id, place) in saved {
            self.places[id] = place;
        }
    }

    /// Plans the way between two places again, not above `level`; gives its time.
    pub(super) fn hold(&mut self, left: usize, right: usize, level: f64) -> f64 {
        let mut at = left;
        while at != right {
            let next = self.places[at].next;
            if at != left && self.places[at].v > level {
                self.drop(at);
            }
            at = next;
        }
        let mut at = left;
        while at != right {
            self.places[at].cap = level.max(self.places[at].v);
            self.places[at].soft = HARD;
            self.places[at].hump = None;
            at = self.places[at].next;
        }
        self.settle_between(left, right)
    }

    /// Finds the humps between two places; gives the time, without end when they do not fit.
    pub(super) fn settle_between(&mut self, left: usize, right: usize) -> f64 {
        let mut at = left;
        // What does not come to an end puts in and takes out the same places again and again.
        for _ in 0..STEPS + 2 * self.between(left, right).count() {
            if at == right {
                break;
            }
            at = self.settle(at);
            if !self.is_linked(left) || !self.is_linked(right) {
                return f64::INFINITY;
            }
        }
        if at != right {
            return f64::INFINITY;
        }
        let mut time = 0.0;
        let mut at = left;
        while at != right {
            let place = self.places[at];
            time += place.hump.map_or(f64::INFINITY, |hump| hump.time());
            at = place.next;
        }
        time
    }

    pub(super) fn time(&self, left: usize, right: usize) -> f64 {
        let (mut at, mut time) = (left, 0.0);
        while at != right {
            let place = self.places[at];
            time += place.hump.map_or(f64::INFINITY, |hump| hump.time());
            at = place.next;
        }
        time
    }
}
