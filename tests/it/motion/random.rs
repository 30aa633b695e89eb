//! Random programs against the verifier.

use cnc872c::analysis::motion::{Model, Profile, Step};

use super::build::{Random, dynamics, line, model, plan};
use super::verify::verify;

/// A random walk: lengths from hundredths to tens of millimetres, angles mostly small, feeds that change now and then.
fn walk(random: &mut Random, count: usize) -> Vec<Step> {
    let mut dynamics = dynamics();
    dynamics.accel = random.scaled(50.0, 5000.0);
    dynamics.jerk = random.scaled(100.0, 1e6);
    if random.unit() < 0.7 {
        dynamics.accuracy_um = random.scaled(0.5, 100.0);
    }
    if random.unit() < 0.7 {
        dynamics.overload = random.scaled(100.0, 30_000.0);
    }
    let mut heading: f64 = 0.0;
    let mut feed = random.scaled(100.0, 20_000.0);
    let length = random.scaled(0.02, 20.0);
    let turn = random.scaled(0.001, 1.0);
    (0..count as u64)
        .map(|seq| {
            heading += random.between(-turn, turn);
            if random.unit() < 0.1 {
                feed = random.scaled(100.0, 20_000.0);
            }
            let length = length * random.scaled(0.1, 10.0);
            line(seq, [length * heading.cos(), length * heading.sin(), 0.0], feed, dynamics)
        })
        .collect()
}

fn any_model(random: &mut Random, profile: Profile) -> Model {
    let mut model = model(profile);
    if random.unit() < 0.5 {
        model.shortest_s = random.scaled(0.001, 0.06);
    }
    if random.unit() < 0.3 {
        model.look_ahead = 1 + random.below(30);
    }
    model.raise_s = if random.unit() < 0.5 { 1e-9 } else { random.scaled(0.01, 1.0) };
    model
}

#[test]
fn constraints_hold_on_random_programs() {
    for profile in [Profile::Ramps, Profile::Linear, Profile::Parabolic] {
        for seed in 0..300 {
            let mut random = Random::new(seed);
            let count = 2 + random.below(60);
            let steps = walk(&mut random, count);
            let model = any_model(&mut random, profile);
            let planned = plan(&model, &steps);
            verify(&model, &steps, &planned.blocks);
        }
    }
}

/// Programs longer than what is planned at once.
#[test]
fn constraints_hold_on_long_programs() {
    for profile in [Profile::Linear, Profile::Parabolic] {
        for seed in 0..4 {
            let mut random = Random::new(1000 + seed);
            let steps = walk(&mut random, 8000);
            let model = any_model(&mut random, profile);
            let planned = plan(&model, &steps);
            verify(&model, &steps, &planned.blocks);
        }
    }
}

/// Programs in which the dynamic set changes now and then: other accelerations, jerks up to twenty times smaller or
/// larger.
#[test]
fn constraints_hold_where_sets_change() {
    for seed in 0..300 {
        let mut random = Random::new(3000 + seed);
        let count = if seed < 3 { 4000 } else { 2 + random.below(60) };
        let mut steps = walk(&mut random, count);
        let mut set = (1.0, 1.0);
        for dynamics in steps.iter_mut().filter_map(|step| step.motion.as_mut()).map(|motion| &mut motion.dynamics) {
            if random.unit() < 0.3 {
                set = (random.scaled(0.2, 5.0), random.scaled(0.05, 20.0));
            }
            dynamics.accel *= set.0;
            dynamics.jerk *= set.1;
        }
        let model = any_model(&mut random, Profile::Parabolic);
        let planned = plan(&model, &steps);
        verify(&model, &steps, &planned.blocks);
    }
}
