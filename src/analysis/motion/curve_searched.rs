//! Velocities at joints that are looked for: where limits change, and in small stretches that needed places of their own, a
//! way whose acceleration is 0 at a joint, at a velocity below its cap, may be faster than what was found step by step.

#![expect(clippy::indexing_slicing, reason = "ids and places index the lists they were made for")]

use super::super::ramp::Limits;
use super::{Curve, HARD, NONE};

/// In stretches of so many motions every joint is looked at, where places were put in.
const SMALL: usize = 16;
/// With more changes of limits in a part they are not looked at.
const MOST_RUNS: usize = 256;
/// Velocities that are tried at once, evenly up to the greatest.
const GRID: u32 = 8;
/// How often the neighbourhood of the fastest is tried.
const FINER: usize = 3;

impl Curve {
    /// Looks for the velocities at joints that make the way faster: one after another, and for motions that are passed at one
    /// velocity.
    pub(super) fn search_joints(&mut self) {
        let at = self.searched();
        for k in 0..at.len() {
            self.search(&at[k..=k]);
            if k > 0 {
                self.search(&at[k - 1..=k]);
            }
        }
    }

    /// The joints at which velocities are looked for, as places on the way: those beside places that were put in, where limits
    /// change, and all of a small stretch.
    fn searched(&self) -> Vec<f64> {
        let joints = 1..self.s.len() - 1;
        if joints.len() < SMALL && self.places.len() > self.s.len() {
            return self.s[joints].to_vec();
        }
        let mut found = vec![false; self.s.len()];
        for id in self.between(0, self.s.len() - 1).filter(|&id| self.is_put(id)) {
            found[self.kept_before(id) + 1..self.kept_after(id)].fill(true);
        }
        if self.runs.len() <= MOST_RUNS {
            for run in &self.runs[..self.runs.len() - 1] {
                found[self.s.partition_point(|s| *s < run.end)] = true;
            }
        }
        joints.filter(|&k| found[k]).map(|k| self.s[k]).collect()
    }

    /// Looks for the velocity at which the joints at these one or two places are passed without acceleration.
    fn search(&mut self, at: &[f64]) {
        let (Some(&first), Some(&last)) = (at.first(), at.last()) else { return };
        let cap = at.iter().map(|s| self.cap_at(*s)).fold(self.highest, f64::min);
        let (left, right) = (self.kept_left_of(first), self.kept_right_of(last));
        let wider = |id: usize, beyond: usize| if beyond == NONE { id } else { beyond };
        let far_left = wider(left, self.places[left].prev);
        let far_right = wider(right, self.places[right].next);
        let far = (self.kept_before(far_left), self.kept_after(far_right));
        self.search_between((left, right), at, cap);
        if far != (left, right) {
            self.search_between(far, at, cap);
        }
    }

    fn search_between(&mut self, (left, right): (usize, usize), at: &[f64], cap: f64) {
        let (Some(&first), Some(&last)) = (at.first(), at.last()) else { return };
        if !self.is_linked(left) || !self.is_linked(right) {
            return;
        }
        let (l, r) = (self.places[left], self.places[right]);
        let fastest = self.fastest_limits();
        let cap = cap.min(fastest.reach(l.v, first - l.s)).min(fastest.reach(r.v, r.s - last));
        let (mut low, mut high) = (0.0, cap);
        for _ in 0..FINER {
            let step = (high - low) / f64::from(GRID);
            let mut best = None;
            for part in 1..=GRID {
                let v = low + step * f64::from(part);
                if self.try_velocity(left, right, at, v) {
                    best = Some(v);
                }
            }
            let Some(v) = best else { return };
            (low, high) = ((v - step).max(0.0), (v + step).min(cap));
        }
    }

    /// Plans the way between two places again, with places at `at` in which it has the velocity `v`; keeps it when it is
    /// faster. Whether it is.
    fn try_velocity(&mut self, left: usize, right: usize, at: &[f64], v: f64) -> bool {
        let time = self.time(left, right);
        let kept = self.places.len();
        let saved = self.room(left, right);
        let mut id = self.places[left].next;
        while id != right {
            let next = self.places[id].next;
            self.drop(id);
            id = next;
        }
        (self.places[left].cap, self.places[left].soft) = (self.highest, HARD);
        let mut behind = left;
        for &s in at {
            behind = self.insert(behind, s, v);
        }
        let faster = self.settle_between(left, right) < time * (1.0 - 1e-9);
        if !faster {
            self.restore(&saved, kept);
        }
        faster
    }

    /// The greatest accelerations and jerks of all limits.
    fn fastest_limits(&self) -> Limits {
        let mut fastest = self.runs[0].limits;
        for Limits { accel, jerk } in self.runs.iter().map(|run| run.limits) {
            fastest = Limits { accel: fastest.accel.max(accel), jerk: fastest.jerk.max(jerk) };
        }
        fastest
    }

    /// The cap of the joint at `s`.
    fn cap_at(&self, s: f64) -> f64 {
        let k = self.s.partition_point(|&joint| joint < s);
        self.caps[k.min(self.caps.len() - 1)]
    }

    /// The last place before `s` that was not put in.
    fn kept_left_of(&self, s: f64) -> usize {
        let (mut at, mut found) = (0, 0);
        while let Some(place) = self.places.get(at).filter(|place| place.s < s) {
            if !self.is_put(at) {
                found = at;
            }
            at = place.next;
        }
        found
    }

    /// The first place behind `s` that was not put in.
    fn kept_right_of(&self, s: f64) -> usize {
        let mut at = 0;
        while self.places[at].next != NONE && (self.places[at].s <= s || self.is_put(at)) {
            at = self.places[at].next;
        }
        at
    }
}
