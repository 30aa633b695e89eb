//! Plans of many links.

use super::super::ramp::Limits;
use super::{Curve, Link};

/// Even numbers from 0 up to 1, always the same.
fn unit(state: &mut u64) -> f64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    f64::from(u32::try_from(*state >> 32).unwrap()) / f64::from(u32::MAX)
}

/// Where limits change five times as often, the way takes about as long: the plan settles.
#[test]
fn many_changes_of_limits() {
    let sets = [(600.0, 1526.0), (300.0, 610.0), (900.0, 3052.0)].map(|(accel, jerk)| Limits { accel, jerk });
    let seconds = |every: usize| {
        let mut state = 88_172_645_463_325_252;
        let mut link = |at: usize| Link {
            length: 0.5 + unit(&mut state),
            cap: 5000.0 / 60.0,
            joint: if at == 0 { 0.0 } else { 10.0 + 90.0 * unit(&mut state) },
            limits: sets[at / every % 3],
        };
        let links: Vec<Link> = (0..3000).map(&mut link).collect();
        let mut curve = Curve::default();
        curve.plan(&links, 0.0, 0.0, 500, 0.0);
        curve.seconds()
    };
    let (often, seldom) = (seconds(20), seconds(100));
    assert!(often <= seldom * 1.03, "{often} s, {seldom} s with a fifth of the changes");
}
