//! The velocity curve of a part of a stretch with the parabolic profile (VEL-11…VEL-13): places where the acceleration is
//! 0, with humps between them.
//!
//! 1. Joints become such places, the slowest first, when a ramp from and to those beside them fits. The others lie within
//!    a ramp: a ramp may span any number of blocks.
//! 2. Where a ramp passes a joint faster than it may, a place is put before it: the latest from which the rise meets the
//!    joint's cap exactly (after it for a fall). What can then no longer be reached is left out.
//! 3. Where places were put in between two lowest ones, a rise that ends at the cap of one of the blocks may be faster than
//!    one that meets the joints: it is tried.
//! 4. A place that was put in costs time. Without it, up to other velocities, or with a ramp of less acceleration that meets
//!    the joint, the way may be faster: `better` tries that.
//! 5. Where limits change, beside places that were put in, and in small stretches, velocities at joints are tried:
//!    `searched`; then ways that rise to the cap of a joint and no higher.
//! 6. A rise between two lowest places that saves too little time is taken back (VEL-12).

#![expect(clippy::indexing_slicing, reason = "ids and places are made here and index the lists they were made for")]

#[path = "curve_again.rs"]
mod again;
#[path = "curve_better.rs"]
mod better;
#[path = "curve_joints.rs"]
mod joints;
#[path = "curve_searched.rs"]
mod searched;

use super::ramp::{Hump, Limits};
use crate::sure::small;

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
    /// Greatest accelerations of the rise and of the fall up to the next place, where they are kept below the limits.
    soft: [f64; 2],
    /// The way to the next place.
    hump: Option<Hump>,
}

/// No acceleration is kept below the limits.
const HARD: [f64; 2] = [f64::INFINITY; 2];

/// Links with the same limits, one after another.
#[derive(Clone, Copy, Debug)]
struct Run {
    end: f64,
    limits: Limits,
}

/// Plans one part at a time; its room is used again.
#[derive(Clone, Debug, Default)]
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
    /// A first plan is there: ways are planned again, where joints may be left out.
    again: bool,
    /// Rises were taken back.
    taken_back: bool,
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
            self.again = true;
            self.better();
            self.search_joints();
            self.up_to_joints();
        }
        self.again = true;
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

    /// Whether the plan was looked for: places were put in, limits change, or rises were taken back, so that the way backwards
    /// may give another one.
    pub(super) fn is_searched(&self) -> bool {
        !self.blind && (self.places.len() > self.s.len() || self.runs.len() > 1 || self.taken_back)
    }

    /// The time of the plan.
    pub(super) fn seconds(&self) -> f64 {
        self.humps().map(|(.., hump)| hump.time()).sum()
    }

    /// Takes over the plan of the way backwards.
    pub(super) fn turn(&mut self, back: &Self) {
        let way = self.s.last().copied().unwrap_or(0.0);
        let humps: Vec<(f64, f64, Hump)> = back.humps().collect();
        let empty =
            Place { s: way, v: 0.0, after: 0, before: 0, next: NONE, prev: NONE, cap: 0.0, soft: HARD, hump: None };
        self.places.clear();
        for (at, (_, end, hump)) in humps.iter().rev().enumerate() {
            self.places.push(Place { s: way - end, v: hump.to, next: at + 1, hump: Some(hump.turned()), ..empty });
        }
        self.places.push(empty);
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
        (self.again, self.taken_back) = (false, false);
        self.highest = blocks.iter().copied().fold(0.0, f64::max);
        self.lowest_block = blocks.iter().copied().fold(f64::INFINITY, f64::min);
    }

    /// The first and the last place. Ids up to the count of links are those of the joints.
    fn begin(&mut self, offset: f64, entry: f64) {
        let last = self.s.len() - 1;
        let empty = Place {
            s: 0.0,
            v: 0.0,
            after: 0,
            before: 0,
            next: NONE,
            prev: NONE,
            cap: self.highest,
            soft: HARD,
            hump: None,
        };
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
        let (left, right) = (&self.places[left], &self.places[right]);
        left.v == right.v || self.ramp_limits(left, right).is_some()
    }

    /// The limits of a ramp between two places that begins or ends at the lower one: of all links that it covers. `None`: it
    /// does not fit.
    fn ramp_limits(&self, left: &Place, right: &Place) -> Option<Limits> {
        let way = right.s - left.s;
        let room = way * (1.0 + 1e-12) + self.tolerance;
        let low = if left.v < right.v { left.s } else { right.s };
        let mut limits = self.limits(low, low);
        loop {
            let ramp = limits.distance(left.v, right.v);
            if ramp > room {
                return None;
            }
            let ramp = ramp.min(way);
            let covered = if left.v < right.v { self.limits(low, low + ramp) } else { self.limits(low - ramp, low) };
            if limits.min(covered) == limits {
                return Some(limits);
            }
            limits = limits.min(covered);
        }
    }

    /// Makes places of joints, the slowest first.
    fn take_joints(&mut self) {
        let count = self.s.len() - 1;
        self.order.clear();
        self.order.extend((1..count).zip(&self.caps[1..count]).map(|(k, &cap)| (cap, small(k))));
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
        self.places.push(Place { s, v, after, before, next: NONE, prev: NONE, cap: 0.0, soft: HARD, hump: None });
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
            if l.soft == HARD {
                return Hump::new(l.v, r.v, run.limits, run.limits, way, cap);
            }
            let [rise, fall] = l.soft.map(|accel| Limits { accel: run.limits.accel.min(accel), ..run.limits });
            let whole = if l.v <= r.v { rise } else { fall };
            if whole.distance(l.v, r.v) <= way {
                return Hump::new(l.v, r.v, rise, fall, way, cap);
            }
            return Hump::new(l.v, r.v, run.limits, run.limits, way, cap);
        }
        // A place at a change of limits belongs to both sides.
        let (mut rise, mut fall) = (self.limits(l.s, l.s), self.limits(r.s, r.s));
        loop {
            let hump = Hump::new(l.v, r.v, rise, fall, way, cap);
            if hump.rise_way() + hump.fall_way() > way * (1.0 + 1e-9) {
                break;
            }
            let rising = rise.min(self.limits(l.s, (l.s + hump.rise_way()).min(r.s)));
            let falling = fall.min(self.limits((r.s - hump.fall_way()).max(l.s), r.s));
            if rising == rise && falling == fall {
                return hump;
            }
            (rise, fall) = (rising, falling);
        }
        // Higher than both, it would cover links that leave no room for it: only the ramp between both is left.
        let limits = self.ramp_limits(&l, &r).unwrap_or_else(|| self.limits(l.s, r.s));
        Hump::new(l.v, r.v, limits, limits, way, l.v.max(r.v))
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
}

#[cfg(test)]
#[path = "curve_tests.rs"]
mod tests;
