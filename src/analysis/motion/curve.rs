//! The velocity curve of a part of a stretch with the parabolic profile (VEL-11…VEL-13): *places*, which are passed
//! without acceleration, and between two neighbouring places one rise and one fall.
//!
//! 1. A joint becomes a place, passed at its cap, when a climb from the place before it comes up to that, and so does a
//!    climb backwards from the place behind it: seen backwards, a fall is a climb. The other joints lie within a climb.
//! 2. Between two places the climb from the one and the backward climb from the other are cut at the highest velocity
//!    at which they leave room for each other; what is left between them is passed at that velocity.
//! 3. A rise between two lowest places that saves too little time is taken back (VEL-12).

#![expect(clippy::indexing_slicing, reason = "places are made here and index the list they were made for")]

use super::climb::{Road, State, last_below};
use super::ramp::{Hump, Limits};
use super::times::Phase;

/// No place: the end of the list.
const NONE: usize = usize::MAX;

/// What rounding may do to a place, mm.
pub(super) const ROUNDING: f64 = 1e-9;

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

/// A place on the way where the acceleration is 0, with the way up to the next one.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// Where, from the start of the first link.
    s: f64,
    /// Velocity there.
    v: f64,
    /// The link behind it.
    link: usize,
    next: usize,
    prev: usize,
    /// No velocity up to the next place may be above this one.
    cap: f64,
    /// The greatest velocity up to the next place.
    peak: f64,
    /// Time up to the next place.
    time: f64,
    /// Its phases: from one place in the list of all to another. None: it is not planned.
    phases: Option<(usize, usize)>,
}

/// Plans one part at a time; its room is used again.
#[derive(Clone, Debug, Default)]
pub(super) struct Curve {
    ahead: Road,
    /// The same way backwards.
    back: Road,
    /// Block caps.
    blocks: Vec<f64>,
    places: Vec<Place>,
    phases: Vec<Phase>,
    highest: f64,
    /// Whether look-ahead may bind somewhere.
    blind: bool,
    /// The greatest limits of all links.
    fastest: Option<Limits>,
}

impl Curve {
    /// Plans the way over `links` from `offset` of the first on, which is passed at `entry` without acceleration, to
    /// rest at its end. The control sees `look_ahead` blocks from each joint. A rise that does not save `raise_s` is
    /// left out.
    pub(super) fn plan(&mut self, links: &[Link], offset: f64, entry: f64, look_ahead: usize, raise_s: f64) {
        self.measure(links, look_ahead);
        self.choose_places(offset, entry);
        let mut at = 0;
        while self.places[at].next != NONE {
            self.join(at);
            at = self.places[at].next;
        }
        if raise_s > 0.0 {
            self.take_back_rises(raise_s);
        }
    }

    /// The phases of the plan in their order, each with the place where it begins.
    pub(super) fn phases(&self) -> impl Iterator<Item = (f64, Phase)> + '_ {
        let places = std::iter::successors(self.places.first(), |place| self.places.get(place.next));
        places.flat_map(|place| self.phases_behind(place))
    }

    fn phases_behind(&self, place: &Place) -> impl Iterator<Item = (f64, Phase)> + '_ {
        let (from, to) = place.phases.unwrap_or_default();
        self.phases[from..to].iter().scan(place.s, |s, phase| {
            let start = *s;
            *s += phase.way_at(phase.duration_s);
            Some((start, *phase))
        })
    }

    /// Where the plan goes on from when more is known: the last place up to `until`, or `until` itself where the
    /// velocity is held there; with the velocity.
    pub(super) fn last_rest(&self, until: f64) -> Option<(f64, f64)> {
        let places = std::iter::successors(self.places.first(), |place| self.places.get(place.next));
        let place = places.take_while(|place| place.s <= until).last()?;
        let held =
            |(s, phase): &(f64, Phase)| phase.is_held() && *s <= until && until <= s + phase.way_at(phase.duration_s);
        let held = self.phases_behind(place).find(held).map(|(_, phase)| (until, phase.velocity));
        Some(held.unwrap_or((place.s, place.v)))
    }

    /// Where link `k` begins; the end of the last when `k` is their count.
    pub(super) fn joint(&self, k: usize) -> f64 {
        self.ahead.s[k]
    }

    /// The velocity from which the machine stops within what is seen from the start of link `k`, where more follows.
    pub(super) fn stoppable(&self, k: usize, limits: Limits) -> f64 {
        let sight = self.ahead.sight.get(k).copied().unwrap_or(f64::INFINITY);
        if sight.is_finite() { limits.stopping(sight) } else { f64::INFINITY }
    }

    fn measure(&mut self, links: &[Link], look_ahead: usize) {
        let Self { ahead, back, blocks, .. } = self;
        ahead.clear();
        back.clear();
        let highest = links.iter().map(|link| link.cap).fold(0.0, f64::max);
        for link in links {
            ahead.push(link.joint, link.length, link.limits);
        }
        for (k, Link { limits, .. }) in links.iter().enumerate().take(links.len().saturating_sub(look_ahead)) {
            let sight = ahead.s[k + look_ahead] - ahead.s[k];
            // Hardly ever does it bind: no velocity is above the highest, no acceleration above that of the link.
            if limits.stopping_way(highest, limits.accel) <= sight {
                ahead.sight.push(f64::INFINITY);
            } else {
                ahead.sight.push(sight);
                ahead.caps[k] = ahead.caps[k].min(limits.stopping(sight));
            }
        }
        ahead.close(0.0);
        let caps = ahead.caps.iter().rev();
        for (link, cap) in links.iter().rev().zip(caps) {
            back.push(*cap, link.length, link.limits);
        }
        back.close(ahead.caps[0]);
        blocks.clear();
        blocks.extend(links.iter().map(|link| link.cap));
        self.highest = highest;
        self.blind = self.ahead.sight.iter().any(|sight| sight.is_finite());
        self.fastest = links.iter().map(|link| link.limits).reduce(Limits::max);
    }

    /// Makes places of joints, the slowest first: what is slower than a joint decides whether it is a place. Only the
    /// first place, which is settled, may be faster.
    fn choose_places(&mut self, offset: f64, entry: f64) {
        self.places.clear();
        self.phases.clear();
        let place = Place {
            s: offset,
            v: entry,
            link: self.ahead.s.partition_point(|s| *s <= offset).saturating_sub(1),
            next: NONE,
            prev: NONE,
            cap: self.highest,
            peak: 0.0,
            time: 0.0,
            phases: None,
        };
        let count = self.blocks.len();
        let at = |k: usize| match k {
            _ if k == place.link => place,
            _ => Place { s: self.ahead.s[k], v: self.ahead.caps[k], link: k, ..place },
        };
        let (mut places, mut others) = (Marks::new(count), Marks::new(count));
        places.mark(place.link);
        places.mark(count);
        let mut joints: Vec<(f64, usize)> = (place.link + 1..count).map(|k| (self.ahead.caps[k], k)).collect();
        joints.sort_unstable_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        for (_, k) in joints {
            let fits = |left: usize, right: usize| self.fits(&at(left), &at(right), &others);
            let (left, right) = (places.before(k), places.behind(k));
            let is_place = match at(left).v > at(k).v {
                true => self.slows_down(&place, &at(k)),
                false => fits(left, k),
            } && fits(k, right);
            if is_place {
                places.mark(k)
            } else {
                others.mark(k)
            };
        }
        let marked = std::iter::successors(Some(place.link), |k| Some(places.behind(*k)).filter(|k| *k <= count));
        self.places.extend(marked.map(at));
        let count = self.places.len();
        for (at, place) in self.places.iter_mut().enumerate() {
            place.prev = at.checked_sub(1).unwrap_or(NONE);
            place.next = if at + 1 < count { at + 1 } else { NONE };
        }
    }

    /// Whether a climb from the slower one of two places comes to the velocity of the other on the way between them;
    /// joints that are no places, `others`, may be in its way.
    fn fits(&self, left: &Place, right: &Place, others: &Marks) -> bool {
        let way = (right.s - left.s) * (1.0 + 1e-12) + ROUNDING;
        let same = self.limits(left, right);
        let is_free = || others.behind(left.link) >= right.link;
        let least = same.or(self.fastest).map_or(0.0, |limits| limits.distance(left.v, right.v));
        if least > way || least == 0.0 || same.is_some() && !self.blind && is_free() {
            return least <= way;
        }
        let (road, from) =
            if left.v < right.v { (&self.ahead, left.ahead()) } else { (&self.back, self.backwards(right)) };
        let level = left.v.max(right.v);
        let climb = road.climb(from, level, from.s + way, true);
        climb.top >= level * (1.0 - 1e-9) && road.cut(&climb, level, |_| {}) <= from.s + way
    }

    /// Whether the first place, which is settled, leaves room to slow down to a joint.
    fn slows_down(&self, first: &Place, joint: &Place) -> bool {
        let from = self.backwards(joint);
        let end = from.s + joint.s - first.s + ROUNDING;
        let climb = self.back.climb(from, first.v, end, false);
        climb.top >= first.v * (1.0 - 1e-9) && self.back.cut(&climb, first.v, |_| {}) <= end
    }

    /// The limits between two places, where they are the same everywhere.
    fn limits(&self, left: &Place, right: &Place) -> Option<Limits> {
        (self.ahead.until[left.link] >= right.link).then(|| self.ahead.limits[left.link])
    }

    fn backwards(&self, place: &Place) -> State {
        let (links, way) = (self.blocks.len(), self.ahead.s[self.blocks.len()]);
        State { s: way - place.s, v: place.v, a: 0.0, link: links - place.link }
    }

    /// Plans the way from a place to the next one.
    fn join(&mut self, left: usize) {
        let (l, r) = (self.places[left], self.places[self.places[left].next]);
        let first = self.phases.len();
        let least = l.v.max(r.v);
        let peak = match self.limits(&l, &r).filter(|_| l.link + 1 == r.link) {
            Some(limits) if limits.distance(l.v, r.v) <= r.s - l.s => {
                let cap = l.cap.min(self.blocks[l.link]).max(least);
                let hump = Hump::new(l.v, r.v, limits, r.s - l.s, cap);
                self.phases.extend(hump.phases().into_iter().filter(|phase| phase.duration_s > 0.0));
                hump.peak
            }
            Some(_) | None => self.join_climbs(&l, &r, least),
        };
        let time = self.phases[first..].iter().map(|phase| phase.duration_s).sum();
        let phases = Some((first, self.phases.len()));
        self.places[left] = Place { peak, time, phases, ..l };
    }

    /// Plans the way between two places by the climbs from both; gives the greatest velocity, which is at least
    /// `least`.
    fn join_climbs(&mut self, l: &Place, r: &Place, least: f64) -> f64 {
        let Self { ahead, back, phases, .. } = self;
        let way = r.s - l.s;
        let total = ahead.s[self.blocks.len()];
        let from_right = State { s: total - r.s, v: r.v, a: 0.0, link: self.blocks.len() - r.link };
        let rise = ahead.climb(l.ahead(), l.cap.max(least), r.s, true);
        let fall = back.climb(from_right, l.cap.max(least), total - l.s, true);
        let ways = |level: f64| {
            let rise = ahead.cut(&rise, level, |_| {}) - l.s;
            let fall = back.cut(&fall, level, |_| {}) - from_right.s;
            (rise, fall)
        };
        let beyond = |level: f64| {
            let (rise, fall) = ways(level);
            (rise + fall) / way - 1.0
        };
        let most = l.cap.min(rise.top).min(fall.top).max(least);
        let mut peak = if beyond(most) <= 0.0 { most } else { last_below(least, most, beyond) };
        let (rising, falling) = ways(peak);
        // Where it is highest within a block, the cap of that block holds.
        let spot = f64::midpoint(l.s + rising, r.s - falling);
        let block = ahead.s.partition_point(|s| *s <= spot).saturating_sub(1).min(self.blocks.len() - 1);
        peak = peak.min(self.blocks[block]).max(least);
        let (rising, falling) = ways(peak);
        let first = phases.len();
        ahead.cut(&rise, peak, |phase| phases.push(phase));
        let hold = way - rising - falling;
        if hold > 0.0 {
            phases.push(Phase { duration_s: hold / peak, velocity: peak, acceleration: 0.0, jerk: 0.0 });
        }
        let behind = phases.len();
        back.cut(&fall, peak, |phase| phases.push(phase.turned()));
        phases[behind..].reverse();
        if hold < 0.0 {
            // What rounding left: a little faster than the limits.
            let part = way / (rising + falling);
            for phase in &mut phases[first..] {
                let Phase { duration_s, acceleration, jerk, .. } = *phase;
                phase.duration_s = duration_s * part;
                (phase.acceleration, phase.jerk) = (acceleration / part, jerk / (part * part));
            }
        }
        peak
    }

    /// Takes back rises between two lowest places that save too little against holding the higher of them (VEL-12).
    fn take_back_rises(&mut self, raise_s: f64) {
        let mut left = 0;
        while let Some((right, time)) = self.next_lowest(left) {
            let (l, r) = (self.places[left], self.places[right]);
            let higher = l.v.max(r.v);
            let rises = self.between(left, right).any(|id| self.places[id].peak > higher * (1.0 + 1e-12));
            if higher > 0.0 && rises {
                let phases = self.phases.len();
                let saved: Vec<_> = self.between(left, right).map(|id| (id, self.places[id])).collect();
                if self.hold(left, right, higher) - time < raise_s {
                    // The higher one is no lowest place any more.
                    if l.v >= r.v {
                        left = self.lowest_before(left);
                    } else if r.next == NONE {
                        return;
                    }
                    continue;
                }
                for (id, place) in saved {
                    self.places[id] = place;
                }
                self.places[right].prev = r.prev;
                self.phases.truncate(phases);
            }
            left = right;
        }
    }

    /// The places from one on up to another, which does not count.
    fn between(&self, left: usize, right: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(left), |&id| Some(self.places[id].next)).take_while(move |&id| id != right)
    }

    /// The next place behind `left` that is lower than its neighbours, or the last one; with the time up to there.
    fn next_lowest(&self, left: usize) -> Option<(usize, f64)> {
        let (mut at, mut time, mut fallen) = (left, 0.0, false);
        loop {
            let place = self.places[at];
            let Some(next) = self.places.get(place.next) else { return (at != left).then_some((at, time)) };
            if fallen && place.peak > place.v {
                return Some((at, time));
            }
            time += place.time;
            fallen = next.v < place.peak || fallen && place.peak == place.v;
            at = place.next;
        }
    }

    /// The lowest place before `id`, or the first one.
    fn lowest_before(&self, id: usize) -> usize {
        let (mut at, mut risen) = (id, false);
        while let Some(before) = self.places.get(self.places[at].prev) {
            let next = self.places[at];
            if risen && next.v < before.peak {
                return at;
            }
            risen = before.peak > before.v || risen;
            at = next.prev;
        }
        at
    }

    /// Plans the way between two places again, not above `level`; gives its time.
    fn hold(&mut self, left: usize, right: usize, level: f64) -> f64 {
        let mut at = left;
        let mut time = 0.0;
        while at != right {
            let cap = self.places[at].cap.min(level).max(self.places[at].v);
            let mut next = self.places[at].next;
            let near = next;
            while next != right && self.places[next].v > level {
                next = self.places[next].next;
            }
            let replanned = next != near || self.places[at].peak > level;
            self.places[at] = Place { next, cap, ..self.places[at] };
            self.places[next].prev = at;
            if replanned {
                self.join(at);
            }
            time += self.places[at].time;
            at = next;
        }
        time
    }
}

/// Marked joints: a bit for each.
#[derive(Clone, Debug)]
struct Marks(Vec<u64>);

impl Marks {
    /// For joints up to `last`.
    fn new(last: usize) -> Self {
        Self(vec![0; last / 64 + 1])
    }

    fn mark(&mut self, k: usize) {
        self.0[k / 64] |= 1 << (k % 64);
    }

    /// The nearest marked joint before `k`; 0 without any.
    fn before(&self, k: usize) -> usize {
        let first = self.0[k / 64] & ((1 << (k % 64)) - 1);
        let words = std::iter::once(first).chain(self.0[..k / 64].iter().rev().copied());
        let (back, word) = words.enumerate().find(|(_, word)| *word != 0).unwrap_or((k / 64, 1));
        (k / 64 - back) * 64 + 63 - word.leading_zeros() as usize
    }

    /// The nearest marked joint behind `k`; beyond all of them without any.
    fn behind(&self, k: usize) -> usize {
        let first = self.0[k / 64] & (!1 << (k % 64));
        let words = std::iter::once(first).chain(self.0[k / 64 + 1..].iter().copied());
        let found = words.enumerate().find(|(_, word)| *word != 0);
        found.map_or(self.0.len() * 64, |(on, word)| (k / 64 + on) * 64 + word.trailing_zeros() as usize)
    }
}

impl Place {
    fn ahead(&self) -> State {
        State { s: self.s, v: self.v, a: 0.0, link: self.link }
    }
}
