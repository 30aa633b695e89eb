//! Joints and blocks that a hump passes too fast, and the places that keep it from that.

#![expect(clippy::indexing_slicing, reason = "ids and places index the lists they were made for")]

use super::super::ramp::{Hump, Limits};
use super::super::times::Phase;
use super::{Curve, Place};

impl Curve {
    /// Looks for joints that the hump passes too fast, and puts places before or behind them.
    pub(super) fn find_places(&mut self, left: usize, right: usize, hump: &Hump) -> Changed {
        let (l, r) = (self.places[left], self.places[right]);
        let mut changed = Changed::default();
        if l.after > r.before {
            return changed;
        }
        let tolerance = 4.0 * self.tolerance;
        let rise_end = l.s + hump.rise_way();
        let fall_start = r.s - hump.fall_way();
        // What stopping may take at most anywhere on it.
        let stop = if self.blind {
            hump.rise_way() + hump.fall.distance(0.0, hump.peak).max(hump.rise.distance(0.0, hump.peak))
        } else {
            0.0
        };
        let mut rising = None;
        let mut k = l.after;
        while k <= r.before && self.s[k] < rise_end {
            let (at, cap) = (self.s[k] - l.s, self.caps[k]);
            if cap < l.v && at > tolerance {
                if self.fits(left, k) {
                    self.insert(left, self.s[k], cap);
                    changed.any = true;
                    return changed;
                }
                if self.drop(left) {
                    changed.back = Some(l.prev);
                    return changed;
                }
            } else if cap < hump.peak && hump.rises_to(cap.max(l.v)) < at - tolerance {
                rising = Some((k, self.start_for(&l, hump.rise, at, cap)));
                break;
            } else if self.seen[k] < stop && !self.stops(hump.rise, hump.rise.phases(l.v, hump.peak), at, k) {
                rising = Some((k, (at, hump.rise.reach(l.v, at).min(cap))));
                break;
            }
            k += 1;
        }
        let mut falling = None;
        let mut k = r.before;
        while k >= l.after && k > 0 && self.s[k] > fall_start {
            let (at, cap) = (r.s - self.s[k], self.caps[k]);
            if cap < r.v && at > tolerance {
                if self.fits(k, right) {
                    self.insert(left, self.s[k], cap);
                    changed.any = true;
                    return changed;
                }
                if self.drop(right) {
                    changed.any = true;
                    return changed;
                }
            } else if cap < hump.peak && hump.falls_to(cap.max(r.v)) < at - tolerance {
                falling = Some((k, self.start_for(&r, hump.fall, at, cap)));
                break;
            } else if self.seen[k] < stop {
                let way = self.s[k] - fall_start;
                if !self.stops(hump.fall, hump.fall.phases(hump.peak, r.v), way, k) {
                    falling = Some((k, (at, hump.fall.reach(r.v, at).min(cap))));
                    break;
                }
            }
            k -= 1;
        }
        // With the same limits everywhere, what is passed at the peak was found to fit before, as long as all joints were taken
        // that fit.
        if rising.is_none() && falling.is_none() && (self.runs.len() > 1 || self.again) {
            let mut k = l.after;
            while k <= r.before {
                let inside = self.s[k] >= rise_end && self.s[k] <= fall_start;
                if inside && self.caps[k] < hump.peak * (1.0 - 1e-12) {
                    self.insert(left, self.s[k], self.caps[k]);
                    changed.any = true;
                    return changed;
                }
                if self.s[k] > fall_start {
                    break;
                }
                k += 1;
            }
        }
        let mut behind = left;
        if let Some((_, (at, v))) = rising {
            behind = self.insert(behind, l.s + at, v);
            changed.any = true;
        }
        if let Some((joint, (at, v))) = falling {
            let apart = rising.is_none_or(|(other, (start, _))| other < joint && l.s + start < r.s - at);
            if apart {
                self.insert(behind, r.s - at, v);
                changed.any = true;
            }
        }
        changed
    }

    /// How far from a place, and at what velocity, the rise begins again that comes to `cap` at the joint `at` from it:
    /// as fast as possible up to there.
    fn start_for(&self, place: &Place, limits: Limits, at: f64, cap: f64) -> (f64, f64) {
        if cap <= place.v {
            return (at, place.v);
        }
        let (mut low, mut high) = (place.v, cap);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            if limits.distance(place.v, middle) + limits.climb(middle, cap) <= at {
                low = middle;
            } else {
                high = middle;
            }
            if high - low <= 1e-15 * high {
                break;
            }
        }
        let way = limits.distance(place.v, low);
        // From where it stands still nothing is gained by waiting.
        if low == place.v { (at - limits.climb(low, cap), low) } else { (way, low) }
    }

    /// Whether the machine can stop within what is seen from joint `k`, which lies `way` behind the start of the ramp.
    fn stops(&self, limits: Limits, phases: [Phase; 3], way: f64, k: usize) -> bool {
        let mut rest = way;
        for phase in phases {
            let length = phase.way_at(phase.duration_s);
            if rest <= length && phase.duration_s > 0.0 {
                let state = phase.after(phase.time_at(rest));
                let own = self.limits(self.s[k], self.s[k]);
                let with = if own.accel < limits.accel || own.jerk < limits.jerk { own } else { limits };
                return with.stopping_way(state.velocity, state.acceleration) <= self.seen[k] * (1.0 + 1e-9);
            }
            rest -= length;
        }
        true
    }

    /// Where the peak lies within one block and above its cap, the cap becomes the highest velocity up to the next place.
    pub(super) fn lower_to_block(&mut self, left: usize, right: usize, hump: &Hump) -> bool {
        if hump.peak <= self.lowest_block * (1.0 + 1e-12) {
            return false;
        }
        let (l, r) = (self.places[left], self.places[right]);
        let top = (l.s + hump.rise_way()).clamp(l.s, r.s);
        let block = self.s.partition_point(|&joint| joint <= top).saturating_sub(1);
        let cap = self.blocks[block.min(self.blocks.len() - 1)];
        if hump.peak <= cap * (1.0 + 1e-12) || l.cap <= cap {
            return false;
        }
        self.places[left].cap = cap.max(l.v).max(r.v);
        self.places[left].cap < l.cap
    }
}

/// What looking at a hump changed.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Changed {
    pub(super) any: bool,
    /// The start of the hump is out: where to go on.
    pub(super) back: Option<usize>,
}
