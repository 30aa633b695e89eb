//! Climbs: how fast a motion gains velocity from a place that it passes without acceleration, under caps at joints and
//! limits that change from block to block (VEL-11).
//!
//! A climb takes the greatest jerk, then the greatest acceleration. Its only care is that the motion could *relax* at
//! any time, that is let its acceleration fall to 0, and would pass no joint too fast. Where it is about to lose that,
//! it relaxes up to the joint in its way, and climbs on from there.

#![expect(clippy::indexing_slicing, reason = "links and joints are counted here")]

use super::ramp::Limits;
use super::times::Phase;

/// Joints and the links between them, in the order in which a motion meets them.
#[derive(Clone, Debug, Default)]
pub(super) struct Road {
    /// Where the joints are, mm: link k lies between `s[k]` and `s[k + 1]`.
    pub s: Vec<f64>,
    /// Caps at the joints, mm/s.
    pub caps: Vec<f64>,
    /// Limits of the links.
    pub limits: Vec<Limits>,
    /// The joint up to which the limits of a link stay the same.
    pub until: Vec<usize>,
    /// The way within which the machine must be able to stop from a joint, mm; empty when nothing asks for that.
    pub sight: Vec<f64>,
}

/// A place, velocity and acceleration of a motion that gains velocity, and the link that it is about to pass.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    pub s: f64,
    pub v: f64,
    pub a: f64,
    pub link: usize,
}

impl State {
    fn phase(self, duration_s: f64, jerk: f64) -> Phase {
        Phase { duration_s, velocity: self.v, acceleration: self.a, jerk }
    }

    /// After `time` with a jerk, in the same link or behind it.
    fn after(self, time: f64, jerk: f64) -> Self {
        let phase = self.phase(time, jerk);
        Self { s: self.s + phase.way_at(time), v: phase.velocity_at(time), a: self.a + jerk * time, ..self }
    }

    /// The velocity at which the motion has relaxed, with the jerk of these limits.
    fn relaxed(self, limits: Limits) -> f64 {
        self.v + self.a * self.a / (2.0 * limits.jerk)
    }
}

/// A part of a climb with one jerk.
#[derive(Clone, Copy, Debug)]
struct Leg {
    from: State,
    phase: Phase,
    /// The velocity that the motion comes to when it relaxes from the start of the leg.
    level: f64,
}

/// A climb.
#[derive(Clone, Debug)]
pub(super) struct Climb {
    legs: Vec<Leg>,
    /// Where it comes to.
    end: State,
    /// The velocity that it comes to when it relaxes there.
    pub top: f64,
}

impl Road {
    /// Adds a link with the cap of the joint before it.
    pub(super) fn push(&mut self, joint: f64, length: f64, limits: Limits) {
        let s = self.s.last().copied().unwrap_or(0.0);
        if self.s.is_empty() {
            self.s.push(0.0);
        }
        self.s.push(s + length);
        self.caps.push(joint);
        self.limits.push(limits);
    }

    /// All links are there: the last joint has this cap.
    pub(super) fn close(&mut self, joint: f64) {
        self.caps.push(joint);
        self.until.clear();
        self.until.resize(self.limits.len(), self.limits.len());
        for k in (1..self.limits.len()).rev() {
            self.until[k - 1] = if self.limits[k - 1] == self.limits[k] { self.until[k] } else { k };
        }
    }

    pub(super) fn clear(&mut self) {
        let Self { s, caps, limits, until, sight } = self;
        s.clear();
        caps.clear();
        limits.clear();
        until.clear();
        sight.clear();
    }

    /// Climbs from a place without acceleration up to the velocity `top`, and no farther than to `end`; under the caps
    /// of joints when `capped`.
    pub(super) fn climb(&self, from: State, top: f64, end: f64, capped: bool) -> Climb {
        let (mut legs, mut now) = (Vec::new(), from);
        while now.s < end && now.link < self.limits.len() {
            let limits = self.limits[now.link];
            let change = self.until[now.link];
            // As long as possible: to the change of limits, or until relaxing leads to `top`.
            let longest = self.thrust_over(now, self.s[change] - now.s);
            let mut thrust = self.thrust_to(now, top, longest);
            let mut door = None;
            for k in now.link + 1..self.s.len() {
                let excess = |state: State| self.excess(k, state, capped);
                let Some(state) = self.passing(now, thrust, k) else { break };
                if excess(state) > 0.0 {
                    let excess = |time: f64| self.passing(now, time, k).map_or(-1.0, excess);
                    thrust = last_below(0.0, thrust, excess);
                    door = Some(k);
                }
            }
            let grow = ((limits.accel - now.a) / limits.jerk).max(0.0);
            for (time, jerk) in [(thrust.min(grow), limits.jerk), ((thrust - grow).max(0.0), 0.0)] {
                if time > 0.0 {
                    legs.push(Leg { from: now, phase: now.phase(time, jerk), level: self.level(now) });
                    now = now.after(time, jerk);
                }
            }
            let stop = match door {
                Some(k) => self.s[k],
                None if thrust < longest => f64::INFINITY,
                None => now.s,
            };
            let level = self.level(now);
            now = self.relax(now, stop, |from, phase| legs.push(Leg { from, phase, level }));
            if now.s < stop {
                break;
            }
            now.link = door.unwrap_or(change);
            now.s = self.s[now.link];
        }
        Climb { legs, end: now, top: self.level(now) }
    }

    /// A climb up to a lower velocity, without acceleration there: its phases go to `phase`. Gives the place.
    pub(super) fn cut(&self, climb: &Climb, level: f64, mut phase: impl FnMut(Phase)) -> f64 {
        let count = climb.legs.partition_point(|leg| leg.level <= level);
        let (whole, rest) = climb.legs.split_at(count.saturating_sub(1));
        whole.iter().for_each(|leg| phase(leg.phase));
        let mut now = climb.end;
        if let Some(Leg { from, phase: Phase { duration_s, jerk, .. }, .. }) = rest.first().copied() {
            now = from;
            if jerk >= 0.0 {
                let time = self.time_to(
                    level,
                    duration_s,
                    |time| from.after(time, jerk),
                    |limits| match jerk > 0.0 {
                        true => {
                            ((limits.jerk * (level - from.v) + from.a * from.a / 2.0).max(0.0).sqrt() - from.a) / jerk
                        }
                        false => (level - from.relaxed(limits)) / from.a,
                    },
                );
                phase(from.phase(time, jerk));
                now = from.after(time, jerk);
            }
        }
        self.relax(now, f64::INFINITY, |_, part| phase(part)).s
    }

    /// Lets the acceleration fall to 0, no farther than to `until`; each phase of that goes to `leg`.
    fn relax(&self, from: State, until: f64, mut leg: impl FnMut(State, Phase)) -> State {
        let mut now = from;
        while now.a > 0.0 && now.s < until {
            let link = now.link.min(self.limits.len() - 1);
            let jerk = self.limits[link].jerk;
            let phase = now.phase(now.a / jerk, -jerk);
            let change = self.until[link];
            let bound = if change == self.limits.len() { until } else { until.min(self.s[change]) };
            let end = now.s + phase.way_at(phase.duration_s);
            if end <= bound {
                leg(now, phase);
                return State { s: end, v: now.relaxed(self.limits[link]), a: 0.0, link };
            }
            let time = phase.time_at(bound - now.s);
            leg(now, Phase { duration_s: time, ..phase });
            let next = now.after(time, -jerk);
            now = State { s: bound, a: next.a.max(0.0), link: if bound < until { change } else { link }, ..next };
        }
        now
    }

    /// The velocity that a motion comes to when it relaxes.
    fn level(&self, from: State) -> f64 {
        self.relax(from, f64::INFINITY, |_, _| {}).v
    }

    /// After `time` with the greatest jerk and acceleration of the link.
    fn thrust(&self, from: State, time: f64) -> State {
        let Limits { accel, jerk } = self.limits[from.link];
        let grow = ((accel - from.a) / jerk).max(0.0);
        if time <= grow { from.after(time, jerk) } else { from.after(grow, jerk).after(time - grow, 0.0) }
    }

    /// The time in which a thrust covers a way.
    fn thrust_over(&self, from: State, way: f64) -> f64 {
        let Limits { accel, jerk } = self.limits[from.link];
        let grow = ((accel - from.a) / jerk).max(0.0);
        let growing = from.phase(grow, jerk);
        let rest = way - growing.way_at(grow);
        if rest <= 0.0 {
            return growing.time_at(way);
        }
        let v = growing.velocity_at(grow);
        grow + 2.0 * rest / (v + (v * v + 2.0 * accel * rest).sqrt())
    }

    /// The time of a thrust after which the motion relaxes to `top`, at most `longest`.
    fn thrust_to(&self, from: State, top: f64, longest: f64) -> f64 {
        self.time_to(
            top,
            longest,
            |time| self.thrust(from, time),
            |Limits { accel, jerk }| {
                let grow = ((accel - from.a) / jerk).max(0.0);
                let grown = from.after(grow, jerk);
                let rest = top - grown.relaxed(Limits { accel, jerk });
                if rest > 0.0 {
                    return grow + rest / accel;
                }
                ((jerk * (top - from.v) + from.a * from.a / 2.0).max(0.0).sqrt() - from.a) / jerk
            },
        )
    }

    /// The time, at most `longest`, after which a motion relaxes to `level`; `guess` gives it where limits do not
    /// change.
    fn time_to(&self, level: f64, longest: f64, after: impl Fn(f64) -> State, guess: impl Fn(Limits) -> f64) -> f64 {
        let link = after(0.0).link;
        let change = self.until[link];
        let time = guess(self.limits[link]).clamp(0.0, longest);
        if change == self.limits.len() || self.relax(after(time), f64::INFINITY, |_, _| {}).s <= self.s[change] {
            return time;
        }
        let beyond = |time: f64| self.level(after(time)) / level - 1.0;
        if beyond(longest) <= 0.0 { longest } else { last_below(0.0, longest, beyond) }
    }

    /// At joint `k`, the motion that relaxes after a thrust; none when it has relaxed before.
    fn passing(&self, from: State, thrust: f64, k: usize) -> Option<State> {
        let spot = self.s[k];
        let launched = self.thrust(from, thrust);
        if launched.s >= spot {
            return Some(self.thrust(from, self.thrust_over(from, spot - from.s)));
        }
        let state = self.relax(launched, spot, |_, _| {});
        (state.s >= spot).then_some(state)
    }

    /// How far a motion is beyond what joint `k` allows, as a part of it; not above 0 where it is allowed.
    fn excess(&self, k: usize, state: State, capped: bool) -> f64 {
        let mut excess = if capped { state.v / self.caps[k] - 1.0 } else { -1.0 };
        if let Some(limits) = self.limits.get(k) {
            excess = excess.max(state.a / limits.accel - 1.0);
            if let Some(sight) = self.sight.get(k).filter(|sight| sight.is_finite()) {
                excess = excess.max(limits.stopping_way(state.v, state.a) / sight - 1.0);
            }
        }
        excess - 1e-12
    }
}

/// The greatest value between two others at which a growing function is not above 0, as it is at the lower one.
pub(super) fn last_below(mut low: f64, mut high: f64, function: impl Fn(f64) -> f64) -> f64 {
    let (mut at_low, mut at_high) = (function(low), function(high));
    let mut last = 0;
    for step in 0..100 {
        if high - low <= 1e-15 * high {
            break;
        }
        // Where a straight line between both crosses 0; every third step the middle.
        let part = if step % 3 == 2 { 0.5 } else { at_low / (at_low - at_high) };
        let middle = low + (high - low) * part.clamp(1e-6, 1.0 - 1e-6);
        let value = function(middle);
        if value <= 0.0 {
            (low, at_low) = (middle, value);
            if value >= -1e-13 {
                break;
            }
            // The same side again: the other one counts half (the method called Illinois).
            at_high = if last == 1 { at_high / 2.0 } else { at_high };
            last = 1;
        } else {
            (high, at_high) = (middle, value);
            at_low = if last == 2 { at_low / 2.0 } else { at_low };
            last = 2;
        }
    }
    low
}
