//! A stretch with the parabolic profile, planned in parts: constant memory, whatever its length.

use super::curve::{Curve, Link, ROUNDING};
use super::times::{Phase, Velocities};

/// Blocks that are planned at once beyond those that are looked ahead over.
const PART: usize = 2048;

/// The plan of one motion.
#[derive(Clone, Debug, Default)]
pub(super) struct Curved {
    /// Its velocities.
    pub velocities: Velocities,
    /// Seconds.
    pub time_s: f64,
    /// The velocity at its start from which the machine stops within what is seen, where more follows.
    pub seen: f64,
    /// Its phases, when asked for.
    pub phases: Vec<Phase>,
}

/// Plans stretches.
#[derive(Clone, Debug)]
pub(super) struct Parabola {
    look_ahead: usize,
    raise_s: f64,
    wants_phases: bool,
    links: Vec<Link>,
    curve: Curve,
    /// How much of the first link is settled, and the velocity there; the acceleration is 0.
    offset: f64,
    entry: f64,
    /// The settled part of the current link.
    part: Curved,
    /// So many links are gathered before the next part is planned.
    wanted: usize,
}

impl Parabola {
    /// For a control that sees so many blocks. A rise that does not save `raise_s` is left out (VEL-12).
    pub(super) fn new(look_ahead: usize, raise_s: f64, wants_phases: bool) -> Self {
        let look_ahead = look_ahead.max(1);
        Self {
            look_ahead,
            raise_s,
            wants_phases,
            links: Vec::new(),
            curve: Curve::default(),
            offset: 0.0,
            entry: 0.0,
            part: Curved::default(),
            wanted: 2 * look_ahead + PART,
        }
    }

    /// Adds a motion; gives those that are settled by it to `done`.
    pub(super) fn push(&mut self, link: Link, done: impl FnMut(&Link, Curved)) {
        self.links.push(link);
        if self.links.len() < self.wanted {
            return;
        }
        let before = self.links.len();
        self.plan(false, done);
        // A ramp over all that is here: more is gathered first.
        let least = 2 * self.look_ahead + PART;
        self.wanted = if self.links.len() == before { 2 * before } else { (self.links.len() + PART / 2).max(least) };
    }

    /// Ends the stretch: the rest is settled.
    pub(super) fn close(&mut self, done: impl FnMut(&Link, Curved)) {
        self.plan(true, done);
        self.links.clear();
        (self.offset, self.entry) = (0.0, 0.0);
        self.part = Curved::default();
        self.wanted = 2 * self.look_ahead + PART;
    }

    fn plan(&mut self, closed: bool, mut done: impl FnMut(&Link, Curved)) {
        if self.links.is_empty() {
            return;
        }
        let count = self.links.len();
        self.curve.plan(&self.links, self.offset, self.entry, self.look_ahead, self.raise_s);
        // The end of the known path bears on these links: they are not settled yet.
        let until = if closed { f64::INFINITY } else { self.curve.joint(count - 2 * self.look_ahead - 1) };
        let Some((end, velocity)) = self.curve.last_rest(until).filter(|(end, _)| closed || *end > self.offset) else {
            return;
        };
        let mut walk = Walk { k: 0, s: self.offset, finished: 0 };
        let phases: Vec<(f64, Phase)> = self.curve.phases().collect();
        for (s, phase) in phases {
            let rest = end - s;
            if rest <= 0.0 {
                break;
            }
            walk.s = s;
            let cut = phase.is_held() && phase.way_at(phase.duration_s) > rest;
            self.walk(
                &mut walk,
                if cut { Phase { duration_s: rest / phase.velocity, ..phase } } else { phase },
                &mut done,
            );
        }
        walk.s = end;
        self.finish_up_to(&mut walk, end, closed, &mut done);
        if closed {
            // What rounding left.
            while walk.finished < self.links.len() {
                self.finish(&mut walk, &mut done);
            }
        }
        (self.offset, self.entry) = ((end - self.curve.joint(walk.finished.min(count))).max(0.0), velocity);
        self.links.drain(..walk.finished);
    }

    /// Goes through a phase; finishes the links whose ends lie in it.
    fn walk(&mut self, walk: &mut Walk, phase: Phase, done: &mut impl FnMut(&Link, Curved)) {
        let mut rest = phase;
        let way = phase.way_at(phase.duration_s);
        let from = walk.s;
        let mut passed = 0.0;
        while walk.k + 1 < self.links.len() {
            let joint = self.curve.joint(walk.k + 1) - from;
            // What rounding leaves of a phase on the other side of a joint belongs to neither.
            if joint >= way - ROUNDING {
                break;
            }
            let time = if joint <= ROUNDING { 0.0 } else { phase.time_at(joint).max(passed) };
            let first = Phase { duration_s: time - passed, ..rest };
            let after = phase.after(time);
            self.add(first, after.velocity);
            self.finish(walk, done);
            (rest, passed) = (after, time);
        }
        let last = phase.velocity_at(phase.duration_s).max(0.0);
        if rest.duration_s > 0.0 {
            self.add(rest, last);
        }
        walk.s = from + way;
    }

    /// Finishes the links that end at or before a place where the acceleration is 0.
    fn finish_up_to(&mut self, walk: &mut Walk, s: f64, all: bool, done: &mut impl FnMut(&Link, Curved)) {
        while walk.k < self.links.len() && (all || self.curve.joint(walk.k + 1) <= s + ROUNDING) {
            self.finish(walk, done);
        }
    }

    fn add(&mut self, phase: Phase, end: f64) {
        let Curved { velocities, time_s, phases, .. } = &mut self.part;
        if *time_s == 0.0 {
            velocities.start = phase.velocity;
            velocities.peak = phase.velocity;
        }
        velocities.peak = velocities.peak.max(phase.velocity).max(end);
        velocities.end = end;
        *time_s += phase.duration_s;
        if self.wants_phases && phase.lasts() {
            match phases.last_mut() {
                // Holding goes on.
                Some(last)
                    if last.jerk == phase.jerk && phase.jerk == 0.0 && last.acceleration == phase.acceleration =>
                {
                    last.duration_s += phase.duration_s;
                }
                Some(_) | None => phases.push(phase),
            }
        }
    }

    fn finish(&mut self, walk: &mut Walk, done: &mut impl FnMut(&Link, Curved)) {
        let Some(link) = self.links.get(walk.k) else { return };
        let mut curved = std::mem::take(&mut self.part);
        self.part.velocities.start = curved.velocities.end;
        curved.seen = self.curve.stoppable(walk.k, link.limits);
        done(link, curved);
        walk.k += 1;
        walk.finished += 1;
    }
}

/// Where the way through a plan has come to.
#[derive(Debug)]
struct Walk {
    /// The current link.
    k: usize,
    /// The place.
    s: f64,
    /// Links that are finished.
    finished: usize,
}
