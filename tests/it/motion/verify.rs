//! Checks a plan against the rules by integrating its phases. Nothing here is taken from the planner but its input and
//! output.

use cnc872c::analysis::motion::{BlockTimes, Direction, Mode, Model, Move, Phase, Profile, Recognition, Step};
use cnc872c::run::MotionType;

/// Relative error that is allowed.
const EPS: f64 = 2e-6;

fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

fn angle(earlier: Direction, later: Direction) -> Option<f64> {
    let (Direction::Along(a), Direction::Along(b)) = (earlier, later) else { return None };
    let norm = |v: [f64; 3]| (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    let unit = |v: [f64; 3]| v.map(|part| part / norm(v));
    let (a, b) = (unit(a), unit(b));
    let difference = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    Some(2.0 * (norm(difference) / 2.0).clamp(0.0, 1.0).asin())
}

/// The end of a list of phases: way, velocity, acceleration.
fn integrate(phases: &[Phase], mut each: impl FnMut(&Phase, f64)) -> (f64, f64) {
    let (mut way, mut velocity) = (0.0, 0.0);
    for phase in phases {
        let t = phase.duration_s;
        each(phase, way);
        way += phase.velocity * t + phase.acceleration * t * t / 2.0 + phase.jerk * t * t * t / 6.0;
        velocity = phase.velocity + phase.acceleration * t + phase.jerk * t * t / 2.0;
    }
    (way, velocity)
}

/// The greatest velocity in a phase.
fn highest(phase: &Phase) -> f64 {
    let at = |t: f64| phase.velocity + phase.acceleration * t + phase.jerk * t * t / 2.0;
    let mut highest = at(0.0).max(at(phase.duration_s));
    if phase.jerk != 0.0 {
        let turn = -phase.acceleration / phase.jerk;
        if turn > 0.0 && turn < phase.duration_s {
            highest = highest.max(at(turn));
        }
    }
    highest
}

/// The cap of a block by VEL-1, VEL-2, VEL-3, VEL-6.
fn block_cap(model: &Model, motion: &Move, length: f64, stretch: bool) -> f64 {
    let mut caps = vec![motion.programmed.unwrap()];
    if let Some(radius) = motion.radius
        && motion.dynamics.centripetal > 0.0
    {
        caps.push((motion.dynamics.centripetal * radius).sqrt());
    }
    if stretch && model.profile != Profile::Ramps && model.shortest_s > 0.0 {
        caps.push(length / model.shortest_s);
    }
    least(&caps)
}

/// Least way from a velocity to rest.
fn stop(profile: Profile, motion: &Move, velocity: f64) -> f64 {
    let (a, j) = (motion.dynamics.accel, motion.dynamics.jerk);
    match profile {
        Profile::Ramps | Profile::Linear => velocity * velocity / (2.0 * a),
        Profile::Parabolic if velocity * j <= a * a => velocity * (velocity / j).sqrt(),
        Profile::Parabolic => velocity / 2.0 * (a / j + velocity / a),
    }
}

/// Checks every constraint on what a program became, no blocks joined (CNT-4 is tested apart).
pub fn verify(model: &Model, steps: &[Step], blocks: &[BlockTimes]) {
    assert_eq!(steps.len(), blocks.len());
    let moving: Vec<usize> =
        (0..steps.len()).filter(|&k| steps[k].motion.is_some_and(|motion| motion.length != Some(0.0))).collect();
    let jerk = model.profile == Profile::Parabolic;
    for (place, &k) in moving.iter().enumerate() {
        let (step, motion) = (&steps[k], steps[k].motion.unwrap());
        let times = blocks[k].motion.as_ref().unwrap();
        let joint = times.joint.as_ref().unwrap();
        let (Some(time), Some(velocities)) = (times.motion_s, times.velocities) else {
            assert!(motion.length.is_none() || motion.programmed.is_none() || motion.kind == MotionType::Reference);
            continue;
        };
        let length = motion.length.unwrap();
        let stretch = times.stretch.is_some();
        let cap = block_cap(model, &motion, length, stretch);
        assert!((times.cap.unwrap().0 - cap).abs() <= EPS * cap);
        // The phases give length, time and velocities.
        let (way, end) = integrate(&times.phases, |_, _| {});
        assert!((way - length).abs() <= EPS * length, "block {k}: way {way} of {length}\n{times:#?}");
        let sum: f64 = times.phases.iter().map(|phase| phase.duration_s).sum();
        assert!((sum - time).abs() <= EPS * time, "block {k}: {sum} s of {time} s");
        let scale = velocities.peak;
        assert!((times.phases[0].velocity - velocities.start).abs() <= EPS * scale);
        assert!((end - velocities.end).abs() <= EPS * scale, "block {k}: ends at {end}, said {}", velocities.end);
        let top = times.phases.iter().map(highest).fold(0.0, f64::max);
        assert!((top - velocities.peak).abs() <= EPS * scale, "block {k}: peak {top}, said {}", velocities.peak);
        assert!(top <= cap * (1.0 + EPS), "block {k}: {top} above its cap {cap}");
        // Accelerations, jerks, no jump within it.
        let accel = match (stretch, motion.kind) {
            (true, _) => motion.dynamics.accel,
            (false, _) if jerk => motion.dynamics.accel,
            (false, MotionType::Rapid) => model.accel_rapid,
            (false, _) => model.accel,
        };
        let curved = jerk;
        for phase in &times.phases {
            let last = phase.acceleration + phase.jerk * phase.duration_s;
            assert!(
                phase.acceleration.abs().max(last.abs()) <= accel * (1.0 + EPS),
                "block {k}: {phase:?} above {accel}"
            );
            assert!(phase.velocity >= -EPS * scale);
            if curved {
                assert!(phase.jerk.abs() <= motion.dynamics.jerk * (1.0 + EPS), "block {k}: {phase:?}");
            } else {
                assert!(phase.jerk == 0.0);
            }
        }
        for pair in times.phases.windows(2) {
            let t = pair[0].duration_s;
            let velocity = pair[0].velocity + pair[0].acceleration * t + pair[0].jerk * t * t / 2.0;
            assert!((velocity - pair[1].velocity).abs() <= EPS * scale, "block {k}: velocity jumps");
            if curved {
                let acceleration = pair[0].acceleration + pair[0].jerk * t;
                assert!((acceleration - pair[1].acceleration).abs() <= EPS * accel, "block {k}: acceleration jumps");
            }
        }
        // The joint before it.
        let before = place.checked_sub(1).map(|before| moving[before]);
        let previous = before.map(|k| (k, &steps[k], steps[k].motion.unwrap()));
        if joint.broken_by.is_some() {
            assert!(velocities.start == 0.0 && joint.velocity == 0.0);
            if curved {
                assert!(times.phases[0].acceleration == 0.0);
            }
            if let Some((p, ..)) = previous
                && let Some(earlier) = blocks[p].motion.as_ref().and_then(|motion| motion.velocities)
            {
                assert!(earlier.end.abs() <= 1e-6, "block {p} ends at {}", earlier.end);
            }
        } else {
            let (p, earlier, earlier_motion) = previous.unwrap();
            let earlier_times = blocks[p].motion.as_ref().unwrap();
            assert_eq!(joint.with, Some(earlier.seq));
            assert!(step.mode == Mode::Continuous && p + 1 == k);
            assert!((earlier_times.velocities.unwrap().end - velocities.start).abs() <= EPS * scale);
            assert!((joint.velocity - velocities.start).abs() <= EPS * scale);
            if curved {
                let last = earlier_times.phases.last().unwrap();
                let acceleration = last.acceleration + last.jerk * last.duration_s;
                let least = earlier_motion.dynamics.accel.min(motion.dynamics.accel);
                let first = times.phases[0].acceleration;
                assert!((acceleration - first).abs() <= 1e-5 * least, "joint {k}: {acceleration} then {first}");
                assert!(acceleration.abs() <= least * (1.0 + EPS));
            }
            let alpha = angle(earlier_motion.to, motion.from);
            if model.recognition == Recognition::Automatic {
                assert!(alpha.unwrap().to_degrees() < model.angle_deg * (1.0 + 1e-9));
            }
            let mut caps = vec![cap, block_cap(model, &earlier_motion, earlier_motion.length.unwrap(), true)];
            if model.profile != Profile::Ramps
                && let Some(alpha) = alpha.filter(|alpha| *alpha > 0.0)
            {
                for dynamics in [earlier_motion.dynamics, motion.dynamics] {
                    if dynamics.accuracy_um > 0.0 {
                        caps.push(dynamics.accuracy_um / model.cycle_ms / (alpha / 2.0).tan());
                    }
                    if dynamics.overload > 0.0 {
                        caps.push(dynamics.overload * model.cycle_ms / 1000.0 / 2.0 / (alpha / 2.0).sin());
                    }
                }
            }
            let cap = least(&caps);
            assert!(velocities.start <= cap * (1.0 + EPS), "joint {k}: {} above {cap}", velocities.start);
            let sees = if model.profile == Profile::Ramps { 1 } else { model.look_ahead };
            let of = times.stretch.unwrap().index;
            let ahead: Vec<usize> = moving[place..]
                .iter()
                .copied()
                .take(sees + 1)
                .take_while(|&k| blocks[k].motion.as_ref().unwrap().stretch.is_some_and(|at| at.index == of))
                .collect();
            if ahead.len() > sees {
                let way: f64 = ahead[..sees].iter().map(|&k| steps[k].motion.unwrap().length.unwrap()).sum();
                let needs = stop(model.profile, &motion, velocities.start);
                assert!(needs <= way * (1.0 + 1e-5), "joint {k}: stops in {needs}, sees {way}");
            }
        }
    }
    if let Some(&k) = moving.last()
        && let Some(velocities) = blocks[k].motion.as_ref().and_then(|motion| motion.velocities)
    {
        assert!(velocities.end.abs() <= 1e-6);
    }
}
