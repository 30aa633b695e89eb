//! Ramps against their integration.

use super::ramp::Limits;

/// Numbers of a simple generator, between 0 and 1.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 32).unwrap()) / f64::from(u32::MAX)
    }

    fn scaled(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.unit())
    }
}

/// Integrates the acceleration of a ramp that lasts `time`, in so many steps for each stretch between its corners: what
/// it adds to the velocity, and the way.
fn integrate(limits: Limits, low: f64, time: f64, steps: u32) -> (f64, f64) {
    let acceleration = |at: f64| (limits.jerk * at).min(limits.accel).min(limits.jerk * (time - at)).max(0.0);
    let corner = (limits.accel / limits.jerk).min(time / 2.0);
    let (mut velocity, mut way) = (low, 0.0);
    for (from, to) in [(0.0, corner), (corner, time - corner), (time - corner, time)] {
        let step = (to - from) / f64::from(steps);
        for number in 0..steps {
            let at = from + f64::from(number) * step;
            let (first, middle, last) = (acceleration(at), acceleration(at + step / 2.0), acceleration(at + step));
            let half = velocity + step / 24.0 * (5.0 * first + 8.0 * middle - last);
            let end = velocity + step / 6.0 * (first + 4.0 * middle + last);
            way += step / 6.0 * (velocity + 4.0 * half + end);
            velocity = end;
        }
    }
    (velocity - low, way)
}

/// VEL-11: time and way of ramps, from rest and between velocities, with and without a part of constant acceleration.
#[test]
fn times_and_ways() {
    let mut random = Random(872);
    let mut worst = 0.0_f64;
    let mut flat = 0;
    for number in 0..200_000_u32 {
        let limits = Limits { accel: random.scaled(10.0, 20_000.0), jerk: random.scaled(10.0, 1e6) };
        let change = random.scaled(0.01, 1000.0);
        let low = if number.is_multiple_of(3) { 0.0 } else { random.scaled(0.01, 1000.0) };
        let time = limits.time(change);
        flat += u32::from(change * limits.jerk > limits.accel * limits.accel);
        let (changed, way) = integrate(limits, low, time, 32);
        worst =
            worst.max((changed - change).abs() / change).max((way - limits.distance(low, low + change)).abs() / way);
        if number.is_multiple_of(100) {
            let reached = limits.reach(low, limits.distance(low, low + change));
            assert!((reached - low - change).abs() < 1e-6 * (low + change), "{limits:?} {low} {change}");
        }
    }
    assert!(flat > 50_000 && flat < 150_000, "{flat}");
    assert!(worst < 1e-8, "{worst}");
}
