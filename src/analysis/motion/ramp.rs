//! The parabolic ramp (S3 A7.1): a change of velocity with limited acceleration and jerk, acceleration 0 at both ends.

use super::times::Phase;

/// What a ramp keeps within.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Limits {
    /// Greatest acceleration, mm/s².
    pub accel: f64,
    /// Greatest jerk, mm/s³.
    pub jerk: f64,
}

impl Limits {
    /// The smaller values of both.
    pub(super) fn min(self, other: Self) -> Self {
        Self { accel: self.accel.min(other.accel), jerk: self.jerk.min(other.jerk) }
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

    /// How the way grows with the higher velocity of the ramp.
    fn slope(self, low: f64, high: f64) -> f64 {
        let Self { accel, jerk } = self;
        let change = high - low;
        let rate = if change * jerk <= accel * accel { 1.0 / (change * jerk).sqrt() } else { 1.0 / accel };
        self.time(change) / 2.0 + (low + high) / 2.0 * rate
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

    /// The way of the beginning of a rise: from `low` with acceleration 0 up to `high`, the acceleration growing as long
    /// as it may.
    pub(super) fn climb(self, low: f64, high: f64) -> f64 {
        let Self { accel, jerk } = self;
        let change = high - low;
        let turn = accel * accel / (2.0 * jerk);
        if change <= turn {
            return (2.0 * change / jerk).sqrt() * (low + change / 3.0);
        }
        let top = low + turn;
        accel / jerk * (low + turn / 3.0) + (high * high - top * top) / (2.0 * accel)
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

    /// What is left of it after `time`.
    pub(super) fn after(&self, time: f64) -> Self {
        Self {
            duration_s: self.duration_s - time,
            velocity: self.velocity_at(time).max(0.0),
            acceleration: self.acceleration + time * self.jerk,
            jerk: self.jerk,
        }
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

/// A rise from one velocity to a peak, a stretch at the peak, and the fall to another velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hump {
    /// Velocity at its start; the acceleration is 0.
    pub from: f64,
    /// Greatest velocity.
    pub peak: f64,
    /// Velocity at its end; the acceleration is 0.
    pub to: f64,
    /// Limits of the rise.
    pub rise: Limits,
    /// Limits of the fall.
    pub fall: Limits,
    /// Way between rise and fall, mm.
    pub hold: f64,
}

impl Hump {
    /// The fastest way over `way` between two velocities, up to `cap`, which is not below them. The ways of the ramps
    /// between them fit.
    pub(super) fn new(from: f64, to: f64, rise: Limits, fall: Limits, way: f64, cap: f64) -> Self {
        let ways = |peak: f64| rise.distance(from, peak) + fall.distance(peak, to);
        let at_cap = way - ways(cap);
        if at_cap >= 0.0 {
            return Self { from, peak: cap, to, rise, fall, hold: at_cap };
        }
        let least = from.max(to);
        let peak = if from == to && rise == fall {
            rise.reach(from, way / 2.0).clamp(least, cap)
        } else {
            // Newton's steps, kept between what is too low and what is too high.
            let (mut low, mut high) = (least, cap);
            let mut peak = f64::midpoint(low, high);
            for _ in 0..80 {
                let beyond = ways(peak) - way;
                if beyond > 0.0 {
                    high = peak;
                } else {
                    low = peak;
                }
                let next = peak - beyond / (rise.slope(from, peak) + fall.slope(to, peak));
                let next = if next > low && next < high { next } else { f64::midpoint(low, high) };
                if (next - peak).abs() <= 1e-16 * high {
                    break;
                }
                peak = next;
            }
            // Close to both ends the way grows by leaps of rounding: the lower side always fits.
            if ways(peak) > way { low } else { peak }
        };
        Self { from, peak, to, rise, fall, hold: (way - ways(peak)).max(0.0) }
    }

    /// The same backwards.
    pub(super) const fn turned(self) -> Self {
        Self { from: self.to, to: self.from, rise: self.fall, fall: self.rise, ..self }
    }

    /// Way of the rise.
    pub(super) fn rise_way(&self) -> f64 {
        self.rise.distance(self.from, self.peak)
    }

    /// Way of the fall.
    pub(super) fn fall_way(&self) -> f64 {
        self.fall.distance(self.peak, self.to)
    }

    /// Seconds; without end when it stands still on its way.
    pub(super) fn time(&self) -> f64 {
        let hold = if self.hold > 0.0 { self.hold / self.peak } else { 0.0 };
        self.rise.time(self.peak - self.from) + hold + self.fall.time(self.peak - self.to)
    }

    /// Its phases; those not needed last 0 s.
    pub(super) fn phases(&self) -> [Phase; 7] {
        let [a, b, c] = self.rise.phases(self.from, self.peak);
        let [e, f, g] = self.fall.phases(self.peak, self.to);
        let duration_s = if self.hold > 0.0 { self.hold / self.peak } else { 0.0 };
        let d = Phase { duration_s, velocity: self.peak, acceleration: 0.0, jerk: 0.0 };
        [a, b, c, d, e, f, g]
    }

    /// Where the rise reaches `velocity` (between its start and its peak), from the start.
    pub(super) fn rises_to(&self, velocity: f64) -> f64 {
        place(self.rise, self.from, self.peak, velocity)
    }

    /// Where the fall comes to `velocity`, from the end backwards.
    pub(super) fn falls_to(&self, velocity: f64) -> f64 {
        place(self.fall, self.to, self.peak, velocity)
    }
}

/// Where a ramp from `low` to `high` has `velocity`, from its lower end.
fn place(limits: Limits, low: f64, high: f64, velocity: f64) -> f64 {
    let change = high - low;
    let turn = (limits.accel * limits.accel / (2.0 * limits.jerk)).min(change / 2.0);
    if velocity <= high - turn {
        return limits.climb(low, velocity);
    }
    // The last part is the first one backwards in time: its way is what a fall from the top covers.
    let rest = high - velocity;
    let time = (2.0 * rest / limits.jerk).sqrt();
    limits.distance(low, high) - time * (high - rest / 3.0)
}
