//! The velocity curve of a part of a stretch with the parabolic profile (VEL-11…VEL-13): places where the acceleration is
//! 0, with humps between them.
//!
//! 1. Joints become such places, the slowest first, when a ramp from and to those beside them fits. The others lie within
//!    a ramp: a ramp may span any number of blocks.
//! 2. Where a ramp passes a joint faster than it may, a place is put before it: the latest from which the rise meets the
//!    joint's cap exactly (after it for a fall). What can then no longer be reached is left out.
//! 3. Where places were put in between two lowest ones, a rise that ends at the cap of one of the blocks may be faster than
//!    one that meets the joints: it is tried.
//! 4. A rise between two lowest places that saves too little time is taken back (VEL-12).

#![expect(clippy::indexing_slicing, reason = "ids and places are made here and index the lists they were made for")]

use super::ramp::{Hump, Limits};

/// Levels that are tried between two lowest places.
const LEVELS: usize = 4;
/// Nobody: end of a list.
const NONE: usize = usize::MAX;

/// One motion of a stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    /// Its length.
    pub length: f64,
    /// Block cap.
    pub cap: f64,
    /// Joint cap at its start; 0 at the start of a stretch.
    pub joint: f64,
    /// Limits of acceleration and jerk.
    pub limits: Limits,
}

/// A place on the way where the acceleration is 0.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// Where, from the start of the first link.
    s: f64,
    /// Velocity there.
    v: f64,
    /// The first joint beyond it.
    after: usize,
    /// The last joint before it.
    before: usize,
    next: usize,
    prev: usize,
    /// Greatest velocity up to the next place.
    cap: f64,
    /// The way to the next place.
    hump: Option<Hump>,
}

/// Links with the same limits, one after another.
#[derive(Clone, Copy, Debug)]
struct Run {
    end: f64,
    limits: Limits,
}

/// Plans one part at a time; its room is used again.
#[derive(Debug, Default)]
pub(super) struct Curve {
    /// Where the joints are: of link k from `s[k]` to `s[k + 1]`.
    s: Vec<f64>,
    /// Caps at the joints, look-ahead included.
    caps: Vec<f64>,
    /// Block caps.
    blocks: Vec<f64>,
    /// How far is seen from each joint; without limit where nothing follows.
    seen: Vec<f64>,
    runs: Vec<Run>,
    places: Vec<Place>,
    /// Joints in the order of their caps.
    order: Vec<(f64, u32)>,
    /// A bit for each joint that is a place.
    taken: Vec<u64>,
    highest: f64,
    lowest_block: f64,
    /// What rounding may do to a place.
    tolerance: f64,
    /// Whether look-ahead ends before the stretch somewhere.
    blind: bool,
}

impl Curve {
    /// Plans the way over `links` from `offset` of the first on, which is passed at `entry` without acceleration, to rest
    /// at its end. The control sees `look_ahead` blocks from each joint. A rise that does not save `raise_s` is left out.
    pub(super) fn plan(&mut self, links: &[Link], offset: f64, entry: f64, look_ahead: usize, raise_s: f64) {
        self.measure(links, look_ahead);
        // What differs by rounding alone is the same: a ramp between both would be all rounding.
        for cap in &mut self.caps {
            if (*cap - entry).abs() <= 1e-11 * entry {
                *cap = entry;
            }
        }
        self.begin(offset, entry);
        self.take_joints();
        if !self.settle_all() {
            self.crawl(links, offset, entry);
        } else {
            self.try_levels();
        }
        if raise_s > 0.0 {
            self.take_back_rises(raise_s);
        }
    }

    /// The humps of the plan: place of the start, place of the end, hump.
    pub(super) fn humps(&self) -> impl Iterator<Item = (f64, f64, Hump)> + '_ {
        let mut at = 0;
        std::iter::from_fn(move || {
            let place = self.places[at];
            let next = self.places.get(place.next)?;
            at = place.next;
            Some((place.s, next.s, place.hump?))
        })
    }

    /// Where link `k` begins; the end of the last when `k` is their count.
    pub(super) fn joint(&self, k: usize) -> f64 {
        self.s[k]
    }

    /// The velocity from which the machine stops within what is seen from the start of link `k`, where more follows.
    pub(super) fn stoppable(&self, k: usize, limits: Limits) -> f64 {
        if self.seen[k].is_finite() { limits.stopping(self.seen[k]) } else { f64::INFINITY }
    }

    fn measure(&mut self, links: &[Link], look_ahead: usize) {
        let Self { s, caps, blocks, seen, runs, .. } = self;
        s.clear();
        caps.clear();
        blocks.clear();
        runs.clear();
        let mut way = 0.0;
        for link in links {
            s.push(way);
            caps.push(link.joint);
            blocks.push(link.cap);
            way += link.length;
            match runs.last_mut() {
                Some(run) if run.limits == link.limits => run.end = way,
                Some(_) | None => runs.push(Run { end: way, limits: link.limits }),
            }
        }
        s.push(way);
        caps.push(0.0);
        seen.clear();
        seen.resize(links.len() + 1, f64::INFINITY);
        for k in 0..links.len().saturating_sub(look_ahead) {
            let way = s[k + look_ahead] - s[k];
            seen[k] = way;
            // A quick look first: hardly ever does it bind.
            let cap = caps[k];
            if links[k].limits.distance(0.0, cap) > way {
                caps[k] = cap.min(links[k].limits.stopping(way));
            }
        }
        self.tolerance = 1e-12 + 1e-14 * way;
        self.blind = links.len() > look_ahead;
        self.highest = blocks.iter().copied().fold(0.0, f64::max);
        self.lowest_block = blocks.iter().copied().fold(f64::INFINITY, f64::min);
    }

    /// The first and the last place. Ids up to the count of links are those of the joints.
    fn begin(&mut self, offset: f64, entry: f64) {
        let last = self.s.len() - 1;
        let empty =
            Place { s: 0.0, v: 0.0, after: 0, before: 0, next: NONE, prev: NONE, cap: self.highest, hump: None };
        self.places.clear();
        self.places.extend(self.s.iter().zip(&self.caps).enumerate().map(|(k, (&s, &v))| Place {
            s,
            v,
            after: k + 1,
            before: k.saturating_sub(1),
            ..empty
        }));
        let first = &mut self.places[0];
        (first.s, first.v, first.next) = (offset, entry, last);
        self.places[last].prev = 0;
    }

    /// The limits that hold everywhere between two places.
    fn limits(&self, from: f64, to: f64) -> Limits {
        if let [run] = self.runs.as_slice() {
            return run.limits;
        }
        let first = self.runs.partition_point(|run| run.end <= from).min(self.runs.len() - 1);
        let mut limits = self.runs[first].limits;
        for (at, run) in self.runs.iter().enumerate().skip(first + 1) {
            if self.runs[at - 1].end >= to {
                break;
            }
            limits = limits.min(run.limits);
        }
        limits
    }

    /// Whether a ramp between two places fits.
    fn fits(&self, left: usize, right: usize) -> bool {
        let (left, right) = (self.places[left], self.places[right]);
        let way = right.s - left.s;
        if left.v == right.v {
            return true;
        }
        let limits = if self.runs.len() == 1 {
            self.runs[0].limits
        } else {
            // The ramp begins at the lower end.
            let limits = self.limits(left.s, right.s);
            let part = limits.distance(left.v, right.v).min(way);
            if left.v < right.v { self.limits(left.s, left.s + part) } else { self.limits(right.s - part, right.s) }
        };
        limits.distance(left.v, right.v) <= way * (1.0 + 1e-12) + self.tolerance
    }

    /// Makes places of joints, the slowest first.
    fn take_joints(&mut self) {
        let count = self.s.len() - 1;
        self.order.clear();
        self.order.extend((1..count).zip(&self.caps[1..count]).map(|(k, &cap)| (cap, u32::try_from(k).unwrap_or(0))));
        self.order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        self.taken.clear();
        self.taken.resize(count / 64 + 1, 0);
        self.take(0);
        self.take(count);
        for at in 0..self.order.len() {
            let k = self.order[at].1 as usize;
            let (left, right) = (self.taken_before(k), self.taken_after(k));
            if self.fits(left, k) && self.fits(k, right) {
                self.take(k);
                self.link(left, k, right);
            }
        }
    }

    fn take(&mut self, joint: usize) {
        self.taken[joint / 64] |= 1 << (joint % 64);
    }

    /// The nearest joint before `joint` that is a place; there is one.
    fn taken_before(&self, joint: usize) -> usize {
        let mut at = joint / 64;
        let mut word = self.taken[at] & ((1 << (joint % 64)) - 1);
        while word == 0 {
            at -= 1;
            word = self.taken[at];
        }
        at * 64 + 63 - word.leading_zeros() as usize
    }

    /// The nearest joint beyond `joint` that is a place; there is one.
    fn taken_after(&self, joint: usize) -> usize {
        let mut at = (joint + 1) / 64;
        let mut word = self.taken[at] & (!0 << ((joint + 1) % 64));
        while word == 0 {
            at += 1;
            word = self.taken[at];
        }
        at * 64 + word.trailing_zeros() as usize
    }

    fn link(&mut self, left: usize, id: usize, right: usize) {
        (self.places[id].prev, self.places[id].next) = (left, right);
        self.places[id].cap = self.places[left].cap;
        self.places[left].next = id;
        self.places[right].prev = id;
        self.places[left].hump = None;
    }

    /// Takes a place out; the first and the last stay. Whether it is out.
    fn drop(&mut self, id: usize) -> bool {
        let Place { prev, next, cap, .. } = self.places[id];
        if prev == NONE || next == NONE {
            return false;
        }
        self.places[prev].next = next;
        self.places[next].prev = prev;
        self.places[prev].cap = self.places[prev].cap.max(cap);
        self.places[prev].hump = None;
        true
    }

    /// Puts a place in behind `left`.
    fn insert(&mut self, left: usize, s: f64, v: f64) -> usize {
        let id = self.places.len();
        let after = self.s.partition_point(|&joint| joint <= s);
        let before = self.s.partition_point(|&joint| joint < s).saturating_sub(1);
        let right = self.places[left].next;
        self.places.push(Place { s, v, after, before, next: NONE, prev: NONE, cap: 0.0, hump: None });
        self.link(left, id, right);
        id
    }

    /// Finds the humps between all places. Whether that came to an end.
    fn settle_all(&mut self) -> bool {
        let mut left = 0;
        for _ in 0..self.s.len() * 64 + 1024 {
            if self.places[left].next == NONE {
                return true;
            }
            left = self.settle(left);
        }
        false
    }

    /// Finds the hump behind `left`, or changes the places around it. Gives the place to go on from.
    fn settle(&mut self, left: usize) -> usize {
        let right = self.places[left].next;
        if !self.fits(left, right) && !self.level(left, right) {
            let higher = if self.places[right].v >= self.places[left].v { right } else { left };
            let back = self.places[left].prev;
            if self.drop(higher) {
                return if higher == right { left } else { back };
            }
        }
        let hump = self.hump(left, right);
        let mut changed = self.find_places(left, right, &hump);
        if let Some(back) = changed.back {
            return back;
        }
        if !changed.any {
            changed.any = self.lower_to_block(left, right, &hump);
        }
        if changed.any {
            return left;
        }
        self.places[left].hump = Some(hump);
        right
    }

    /// Makes velocities equal that differ by rounding alone; that of the first place is settled already. Whether they were
    /// such.
    fn level(&mut self, left: usize, right: usize) -> bool {
        let (l, r) = (self.places[left], self.places[right]);
        if l.prev != NONE || r.next == NONE || (l.v - r.v).abs() > 1e-9 * l.v.max(r.v) {
            return false;
        }
        self.places[right].v = l.v;
        true
    }

    /// The fastest way between two places, with the limits of the blocks that its ramps cover.
    fn hump(&self, left: usize, right: usize) -> Hump {
        let (l, r) = (self.places[left], self.places[right]);
        let way = r.s - l.s;
        let cap = l.cap.max(l.v).max(r.v);
        if let [run] = self.runs.as_slice() {
            return Hump::new(l.v, r.v, run.limits, run.limits, way, cap);
        }
        let mut rise = self.limits(l.s, l.s);
        let mut fall = self.limits(r.s, r.s);
        // A place at a change of limits belongs to both sides.
        for _ in 0..=2 * self.runs.len() {
            let mut hump = Hump::new(l.v, r.v, rise, fall, way, cap);
            if hump.rise_way() + hump.fall_way() > way * (1.0 + 1e-9) {
                // Not even the slower ramp fits with what holds at both ends: what fits() found.
                let all = self.limits(l.s, r.s);
                hump = Hump::new(l.v, r.v, all, all, way, cap);
            }
            let rising = rise.min(self.limits(l.s, (l.s + hump.rise_way()).min(r.s)));
            let falling = fall.min(self.limits((r.s - hump.fall_way()).max(l.s), r.s));
            if rising == rise && falling == fall {
                return hump;
            }
            (rise, fall) = (rising, falling);
        }
        let all = self.limits(l.s, r.s);
        Hump::new(l.v, r.v, all, all, way, cap)
    }

    /// Looks for joints that the hump passes too fast, and puts places before or behind them.
    fn find_places(&mut self, left: usize, right: usize, hump: &Hump) -> Changed {
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
        // With the same limits everywhere, what is passed at the peak was found to fit before.
        if rising.is_none() && falling.is_none() && self.runs.len() > 1 {
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
    fn stops(&self, limits: Limits, phases: [super::times::Phase; 3], way: f64, k: usize) -> bool {
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
    fn lower_to_block(&mut self, left: usize, right: usize, hump: &Hump) -> bool {
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

    /// What surely holds everything: acceleration 0 at every joint.
    fn crawl(&mut self, links: &[Link], offset: f64, entry: f64) {
        self.begin(offset, entry);
        let count = links.len();
        for k in 1..=count {
            let way = self.s[k] - self.places[k - 1].s;
            let reached = links[k - 1].limits.reach(self.places[k - 1].v, way);
            self.places[k].v = self.places[k].v.min(reached);
        }
        for k in (1..count).rev() {
            let reached = links[k].limits.reach(self.places[k + 1].v, links[k].length);
            self.places[k].v = self.places[k].v.min(reached);
        }
        for (k, link) in links.iter().enumerate() {
            let (l, r) = (self.places[k], self.places[k + 1]);
            let limits = link.limits;
            let cap = link.cap.max(l.v).max(r.v);
            self.places[k].hump = Some(Hump::new(l.v, r.v, limits, limits, r.s - l.s, cap));
            (self.places[k].next, self.places[k + 1].prev) = (k + 1, k);
        }
    }

    /// Plans the way between two lowest places anew, not above the cap of one of its blocks, where that is faster.
    fn try_levels(&mut self) {
        let joints = self.s.len();
        if self.places.len() == joints {
            return;
        }
        let mut left = 0;
        while let Some((right, mut time)) = self.next_lowest(left) {
            let mut levels: Vec<f64> = self.levels(left, right);
            levels.truncate(LEVELS);
            for level in levels {
                let kept = self.places.len();
                let saved = self.room(left, right);
                let mut at = self.places[left].next;
                while at != right {
                    let next = self.places[at].next;
                    if at >= joints || self.places[at].v > level {
                        self.drop(at);
                    }
                    at = next;
                }
                let held = self.hold(left, right, level);
                if held < time * (1.0 - 1e-9) {
                    time = held;
                } else {
                    self.restore(&saved, kept);
                }
            }
            left = right;
        }
    }

    /// Caps of blocks between two places that were put together with others between them: above both, below the highest
    /// peak, the lowest first.
    fn levels(&self, left: usize, right: usize) -> Vec<f64> {
        let (mut at, mut peak, mut put) = (left, 0.0_f64, false);
        while at != right {
            let place = self.places[at];
            put |= at >= self.s.len();
            peak = peak.max(place.hump.map_or(0.0, |hump| hump.peak));
            at = place.next;
        }
        if !put {
            return Vec::new();
        }
        let (l, r) = (self.places[left], self.places[right]);
        let least = l.v.max(r.v);
        let blocks = self.blocks[l.after.saturating_sub(1)..r.before + 1].iter().copied();
        let mut levels: Vec<f64> = blocks.filter(|cap| *cap >= least && *cap < self.highest).collect();
        levels.push(peak);
        levels.sort_by(f64::total_cmp);
        levels.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * *b);
        levels
    }

    /// Takes back rises between two lowest places that save too little against holding the higher of them (VEL-12).
    fn take_back_rises(&mut self, raise_s: f64) {
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
    fn next_lowest(&self, left: usize) -> Option<(usize, f64)> {
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
    fn is_linked(&self, id: usize) -> bool {
        self.places.get(self.places[id].prev).is_none_or(|before| before.next == id)
    }

    fn rises_above(&self, left: usize, right: usize, level: f64) -> bool {
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
    fn room(&self, left: usize, right: usize) -> Vec<(usize, Place)> {
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

    fn restore(&mut self, saved: &[(usize, Place)], count: usize) {
        self.places.truncate(count);
        for &(id, place) in saved {
            self.places[id] = place;
        }
    }

    /// Plans the way between two places again, not above `level`; gives its time.
    fn hold(&mut self, left: usize, right: usize, level: f64) -> f64 {
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
            self.places[at].cap = self.places[at].cap.min(level).max(self.places[at].v);
            self.places[at].hump = None;
            at = self.places[at].next;
        }
        let mut at = left;
        for _ in 0..4096 {
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
}

/// What looking at a hump changed.
#[derive(Clone, Copy, Debug, Default)]
struct Changed {
    any: bool,
    /// The start of the hump is out: where to go on.
    back: Option<usize>,
}
