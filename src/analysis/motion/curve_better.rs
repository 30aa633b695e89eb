//! What may be faster than the first plan: without the places that were put in, the way between two others is planned again,
//! up to several velocities, or as one hump with a softer ramp.

#![expect(clippy::indexing_slicing, reason = "ids and places index the lists they were made for")]

use super::super::ramp::Limits;
use super::{Curve, HARD, NONE};
use crate::sure::Sure;

/// Levels that are tried between two lowest places.
const LEVELS: usize = 4;
/// Parts of the rise above two places that are tried as levels between them.
const PARTS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// Halvings of the acceleration when a softer ramp is looked for.
const HALVINGS: usize = 16;

impl Curve {
    /// Looks for a faster way between lowest places, and around each place that was put in or held low.
    pub(super) fn better(&mut self) {
        if self.places.len() > self.s.len() {
            self.between_lowest();
        }
        let mut at = 0;
        while self.places[at].next != NONE {
            let next = self.places[at].next;
            at = if !self.is_linked(at) {
                next
            } else if self.is_put(at) {
                let before = self.places[at].prev;
                let (far_before, far_next) = (self.kept_before(before), self.kept_after(next));
                let windows = [(before, next), (before, far_next), (far_before, next), (far_before, far_next)];
                for (left, right) in windows {
                    if self.is_linked(left) && self.is_linked(right) {
                        self.improve(left, right);
                    }
                }
                if self.is_linked(next) { next } else { self.next_kept(far_before) }
            } else {
                if self.holds_low(at) {
                    self.improve(at, next);
                }
                next
            };
        }
    }

    /// Whether the place is none of the joints.
    pub(super) fn is_put(&self, id: usize) -> bool {
        id >= self.s.len()
    }

    /// The first place from `id` on that was not put in.
    pub(super) fn kept_after(&self, id: usize) -> usize {
        let mut at = id;
        while self.is_put(at) {
            at = self.places[at].next;
        }
        at
    }

    /// The last place up to `id` that was not put in.
    pub(super) fn kept_before(&self, id: usize) -> usize {
        let mut at = id;
        while self.is_put(at) {
            at = self.places[at].prev;
        }
        at
    }

    /// The first place behind `id` that was not put in.
    fn next_kept(&self, id: usize) -> usize {
        self.kept_after(self.places[id].next)
    }

    /// Whether the hump behind a place holds a velocity that is below all caps there.
    fn holds_low(&self, at: usize) -> bool {
        let place = self.places[at];
        let Some(hump) = place.hump.filter(|hump| hump.hold > 0.0 && hump.peak < self.highest) else { return false };
        let from = place.s + hump.rise_way();
        let first = self.s.partition_point(|&joint| joint <= from).saturating_sub(1);
        let last = self.s.partition_point(|&joint| joint < from + hump.hold).min(self.blocks.len());
        let above = hump.peak * (1.0 + 1e-9);
        let is_above = |caps: &[f64]| caps.iter().all(|cap| *cap > above);
        is_above(&self.blocks[first..last.max(first)]) && is_above(&self.caps[first + 1..last.max(first + 1)])
    }

    /// Plans the ways between lowest places again, where places were put in, up to the caps of the blocks there.
    fn between_lowest(&mut self) {
        let mut left = 0;
        while let Some((right, _)) = self.next_lowest(left) {
            if self.between(left, right).any(|id| self.is_put(id)) {
                let mut levels = self.block_caps(left, right);
                levels.push(self.peak(left, right));
                in_order(&mut levels);
                levels.truncate(LEVELS);
                self.try_levels(left, right, &levels);
            }
            left = right;
        }
    }

    /// Plans the way between two places again, and keeps what is fastest. Whether that is another way.
    fn improve(&mut self, left: usize, right: usize) -> bool {
        let least = self.places[left].v.max(self.places[right].v);
        let peak = self.peak(left, right);
        let mut levels = self.block_caps(left, right);
        levels.extend(PARTS.map(|part| least + (peak - least) * part));
        levels.push(self.highest);
        in_order(&mut levels);
        let again = self.try_levels(left, right, &levels);
        let softer = self.soften(left, right, self.highest);
        again || softer
    }

    /// Plans the ways between lowest places again, where places were ever put in, up to the caps of the joints there; also
    /// without the lowest place between them, when it was put in.
    pub(super) fn up_to_joints(&mut self) {
        let mut put: Vec<f64> = self.places[self.s.len()..].iter().map(|place| place.s).collect();
        put.sort_by(f64::total_cmp);
        let mut left = 0;
        while let Some((right, _)) = self.next_lowest(left) {
            self.try_joints(left, right, &put);
            if self.is_put(right)
                && let Some((beyond, _)) = self.next_lowest(right)
            {
                self.try_joints(left, beyond, &put);
            }
            left = match self.is_linked(right) {
                true => right,
                false => self.next_lowest(left).map_or(right, |(next, _)| next),
            };
        }
    }

    /// Plans the way between two places again up to the caps of its joints, when it holds one of the places `put` in.
    fn try_joints(&mut self, left: usize, right: usize, put: &[f64]) {
        let (l, r) = (self.places[left], self.places[right]);
        if put.get(put.partition_point(|s| *s < l.s)).is_none_or(|s| *s > r.s) {
            return;
        }
        let joints = self.caps.get(l.after..r.before + 1).sure();
        let mut levels = self.levels(joints, l.v.max(r.v));
        in_order(&mut levels);
        self.try_levels(left, right, &levels);
        for level in levels {
            self.soften(left, right, level);
        }
    }

    /// The places between two others.
    pub(super) fn between(&self, left: usize, right: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(self.places[left].next), |&id| Some(self.places[id].next))
            .take_while(move |&id| id != right)
    }

    /// The caps of the blocks between two places, as far as they are not below both.
    fn block_caps(&self, left: usize, right: usize) -> Vec<f64> {
        let (l, r) = (self.places[left], self.places[right]);
        let blocks = &self.blocks[l.after.saturating_sub(1)..(r.before + 1).min(self.blocks.len())];
        self.levels(blocks, l.v.max(r.v))
    }

    /// The caps that are not below `least` and bind.
    fn levels(&self, caps: &[f64], least: f64) -> Vec<f64> {
        caps.iter().copied().filter(|cap| *cap >= least && *cap < self.highest).collect()
    }

    /// The greatest velocity between two places.
    fn peak(&self, left: usize, right: usize) -> f64 {
        let humps = std::iter::once(left).chain(self.between(left, right)).filter_map(|id| self.places[id].hump);
        humps.map(|hump| hump.peak).fold(0.0, f64::max)
    }

    /// Plans the way between two places again, up to each level, and keeps what is fastest.
    fn try_levels(&mut self, left: usize, right: usize, levels: &[f64]) -> bool {
        let mut time = self.time(left, right);
        let mut found = false;
        for &level in levels {
            let kept = self.places.len();
            let saved = self.room(left, right);
            self.drop_put(left, right);
            let held = self.hold(left, right, level);
            if held < time * (1.0 - 1e-9) {
                time = held;
                found = true;
            } else {
                self.restore(&saved, kept);
            }
        }
        found
    }

    fn drop_put(&mut self, left: usize, right: usize) {
        let mut at = self.places[left].next;
        while at != right {
            let next = self.places[at].next;
            if self.is_put(at) {
                self.drop(at);
            }
            at = next;
        }
    }

    /// Tries one hump between two places, not above `level`, whose rise or fall has less acceleration: the most with which no
    /// joint is passed too fast.
    fn soften(&mut self, left: usize, right: usize, level: f64) -> bool {
        if self.between(left, right).any(|id| !self.is_put(id)) {
            return false;
        }
        let (l, r) = (self.places[left], self.places[right]);
        let limits = self.limits(l.s, r.s);
        let mut time = self.time(left, right);
        let mut found = false;
        for side in [0, 1] {
            let kept = self.places.len();
            let saved = self.room(left, right);
            let (mut low, mut high) = (0.0, limits.accel.min((limits.jerk * self.highest).sqrt()));
            let mut best = None;
            for _ in 0..HALVINGS {
                let accel = f64::midpoint(low, high);
                if (Limits { accel, ..limits }).distance(l.v.min(r.v), l.v.max(r.v)) > r.s - l.s {
                    low = accel;
                    continue;
                }
                self.drop_put(left, right);
                if self.softened(left, right, side, accel, level).is_some() {
                    (low, best) = (accel, Some(accel));
                } else {
                    high = accel;
                }
                self.restore(&saved, kept);
            }
            self.drop_put(left, right);
            match best.and_then(|accel| self.softened(left, right, side, accel, level)) {
                Some(softened) if softened < time * (1.0 - 1e-9) => {
                    time = softened;
                    found = true;
                }
                Some(_) | None => self.restore(&saved, kept),
            }
        }
        found
    }

    /// The time of one hump between two neighbours, not above `level`, whose rise (side 0) or fall has no more than that
    /// acceleration, when no joint is in its way.
    fn softened(&mut self, left: usize, right: usize, side: usize, accel: f64, level: f64) -> Option<f64> {
        let cap = level.max(self.places[left].v).max(self.places[right].v);
        let place = &mut self.places[left];
        (place.soft, place.cap) = (HARD, cap);
        place.soft[side] = accel;
        loop {
            let hump = self.hump(left, right);
            let changed = self.find_places(left, right, &hump);
            if changed.any || changed.back.is_some() {
                return None;
            }
            if !self.lower_to_block(left, right, &hump) {
                self.places[left].hump = Some(hump);
                return Some(hump.time());
            }
        }
    }
}

/// Sorts levels, each once.
fn in_order(levels: &mut Vec<f64>) {
    levels.sort_by(f64::total_cmp);
    levels.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * *b);
}
