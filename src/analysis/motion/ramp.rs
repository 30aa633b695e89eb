//! The parabolic ramp (S3 A7.1): a change of velocity with limited acceleration and jerk, acceleration 0 at both ends.

use super::climb::last_below;
use super::times::Phase;

/// Bounds of a ramp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Limits {
    /// Greatest acceleration, mm/s².
    pub accel: f64,
    /// Greatest jerk, mm/s³.
    pub jerk: f64,
}

impl Limits {
    /// The greater values of both.
    pub(super) fn max(self, other: Self) -> Self {
        Self { accel: self.accel.max(other.accel), jerk: self.jerk.max(other.jerk) }
    }

    /// Seconds for a change of velocity by `change` ≥ 0: 2·√(Δv/J), or A/J + Δv/A beyond A²/J.
    #[inline]
    pub(super) fn time(self, change: f64) -> f64 {
        let Self { accel, jerk } = self;
        if change * jerk <= accel * accel { 2.0 * (change / jerk).sqrt() } else { accel / jerk + change / accel }
    }

    /// The way of a ramp between two velocities, mm.
    #[inline]
    pub(super) fn distance(self, one: f64, other: f64) -> f64 {
        (one + other) / 2.0 * self.time((other - one).abs())
    }

    /// The velocity that a ramp from `low` upwards reaches within `way`.
    pub(super) fn reach(self, low: f64, way: f64) -> f64 {
        if way <= 0.0 {
            return low;
        }
        let Self { accel, jerk } = self;
        // (low + Δ/2)·(A/J + Δ/A) = way, where A is reached.
        let full = accel * accel / jerk;
        if self.distance(low, low + full) < way {
            let half = low / accel + accel / jerk / 2.0;
            let rest = low * accel / jerk - way;
            return low + accel * ((half * half - 2.0 * rest / accel).sqrt() - half);
        }
        // x³ + 2·low·x = way·√J with x² = Δ: convex, so Newton's steps from above come down to the root.
        let (linear, target) = (2.0 * low, way * jerk.sqrt());
        let mut x = libm::cbrt(target);
        if linear * x > target {
            x = target / linear;
        }
        for _ in 0..40 {
            let next = x - ((x * x + linear) * x - target) / (3.0 * x * x + linear);
            if next >= x || next <= 0.0 {
                break;
            }
            x = next;
        }
        low + x * x
    }

    /// The velocity from which a ramp comes to rest within `way`.
    pub(super) fn stopping(self, way: f64) -> f64 {
        self.reach(0.0, way)
    }

    /// The least way to rest from a velocity and an acceleration.
    pub(super) fn stopping_way(self, velocity: f64, acceleration: f64) -> f64 {
        let Self { accel, jerk } = self;
        if acceleration >= 0.0 {
            let time = acceleration / jerk;
            let top = velocity + acceleration * time / 2.0;
            return time * (velocity + acceleration * time / 3.0) + self.distance(0.0, top);
        }
        // Backwards in time: from rest the acceleration grows, holds, and falls to what it is now.
        let last = -acceleration;
        let highest = (jerk * velocity + last * last / 2.0).max(last * last).sqrt().min(accel).max(last);
        let grow = highest / jerk;
        let after_grow = highest * grow / 2.0;
        let mut way = highest * grow * grow / 6.0;
        let fall = (highest - last) / jerk;
        let change = highest * fall - jerk * fall * fall / 2.0;
        let hold = ((velocity - after_grow - change) / highest).max(0.0);
        way += after_grow * hold + highest * hold * hold / 2.0;
        let before_fall = after_grow + highest * hold;
        way + before_fall * fall + highest * fall * fall / 2.0 - jerk * fall * fall * fall / 6.0
    }

    /// The phases of a ramp between two velocities; those beyond the count last 0 s.
    pub(super) fn phases(self, from: f64, to: f64) -> [Phase; 3] {
        let Self { accel, jerk } = self;
        let change = (to - from).abs();
        let sign = if to < from { -1.0 } else { 1.0 };
        let full = change * jerk <= accel * accel;
        let grow = if full { (change / jerk).sqrt() } else { accel / jerk };
        let hold = if full { 0.0 } else { change / accel - grow };
        let top = jerk * grow;
        let step = top * grow / 2.0;
        let phase = |duration_s: f64, done: f64, acceleration: f64, jerk: f64| Phase {
            duration_s,
            velocity: from + sign * done,
            acceleration: sign * acceleration,
            jerk: sign * jerk,
        };
        [phase(grow, 0.0, 0.0, jerk), phase(hold, step, top, 0.0), phase(grow, change - step, top, -jerk)]
    }
}

impl Phase {
    /// Velocity after `time` of it.
    #[inline]
    pub(super) fn velocity_at(&self, time: f64) -> f64 {
        self.velocity + time * (self.acceleration + time * self.jerk / 2.0)
    }

    /// Way of its first `time`.
    #[inline]
    pub(super) fn way_at(&self, time: f64) -> f64 {
        time * (self.velocity + time * (self.acceleration / 2.0 + time * self.jerk / 6.0))
    }

    /// The rest of it after `time`.
    pub(super) fn after(&self, time: f64) -> Self {
        Self {
            duration_s: self.duration_s - time,
            velocity: self.velocity_at(time).max(0.0),
            acceleration: self.acceleration + time * self.jerk,
            jerk: self.jerk,
        }
    }

    /// Whether the velocity stays the same.
    pub(super) fn is_held(&self) -> bool {
        self.acceleration == 0.0 && self.jerk == 0.0
    }

    /// The same backwards.
    pub(super) fn turned(&self) -> Self {
        let Self { duration_s, acceleration, jerk, .. } = *self;
        Self { velocity: self.velocity_at(duration_s), acceleration: -acceleration - duration_s * jerk, ..*self }
    }

    /// The time after which its way is `way`, between 0 and its own.
    pub(super) fn time_at(&self, way: f64) -> f64 {
        if self.acceleration == 0.0 && self.jerk == 0.0 {
            return (way / self.velocity).min(self.duration_s);
        }
        let (mut low, mut high) = (0.0, self.duration_s);
        let total = self.way_at(high);
        let mut time = if self.velocity == 0.0 && self.acceleration == 0.0 {
            libm::cbrt(6.0 * way / self.jerk).min(high)
        } else {
            high * (way / total).clamp(0.0, 1.0)
        };
        for _ in 0..60 {
            let beyond = self.way_at(time) - way;
            if beyond > 0.0 {
                high = time;
            } else {
                low = time;
            }
            let next = time - beyond / self.velocity_at(time);
            let next = if next > low && next < high { next } else { f64::midpoint(low, high) };
            if (next - time).abs() <= 1e-15 * high {
                return next;
            }
            time = next;
        }
        time
    }
}

/// A rise from one velocity to a peak, a stretch at the peak, and the fall to another velocity, with the same limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hump {
    from: f64,
    /// Greatest velocity.
    pub peak: f64,
    to: f64,
    limits: Limits,
    /// Way between rise and fall, mm.
    hold: f64,
}

impl Hump {
    /// The fastest way over `way` between two velocities, up to `cap`, which is not below them. A ramp between them
    /// fits.
    pub(super) fn new(from: f64, to: f64, limits: Limits, way: f64, cap: f64) -> Self {
        let rest = |peak: f64| way - limits.distance(from, peak) - limits.distance(peak, to);
        let peak = if rest(cap) >= 0.0 {
            cap
        } else if from == to {
            limits.reach(from, way / 2.0).clamp(from, cap)
        } else {
            last_below(from.max(to), cap, |peak| -rest(peak) / way)
        };
        Self { from, peak, to, limits, hold: rest(peak).max(0.0) }
    }

    /// Its phases; those not needed last 0 s.
    pub(super) fn phases(&self) -> [Phase; 7] {
        let [a, b, c] = self.limits.phases(self.from, self.peak);
        let [e, f, g] = self.limits.phases(self.peak, self.to);
        let duration_s = if self.hold > 0.0 { self.hold / self.peak } else { 0.0 };
        let d = Phase { duration_s, velocity: self.peak, acceleration: 0.0, jerk: 0.0 };
        [a, b, c, d, e, f, g]
    }
}
