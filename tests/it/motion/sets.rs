//! VEL-12, VEL-13, VEL-14: programs whose dynamic sets change, and rises that save too little.

use cnc872c::analysis::motion::{Dynamics, Model, Profile, Step};

use super::build::{close, dynamics, line, model, plan};
use super::verify::verify;

/// A set of limits: P, acceleration, criterion of accuracy.
fn set(p: f64, accel: f64, accuracy_um: f64) -> Dynamics {
    Dynamics { jerk: p / 32.768, accel, accuracy_um, ..dynamics() }
}

/// Lines from point to point, from X0 Y0 on.
fn path(points: &[([f64; 2], f64, Dynamics)]) -> Vec<Step> {
    let mut at = [0.0, 0.0];
    let mut line_to = |(seq, (point, feed, set)): (u64, &([f64; 2], f64, Dynamics))| {
        let vector = [point[0] - at[0], point[1] - at[1], 0.0];
        at = *point;
        line(seq, vector, *feed, *set)
    };
    (0..).zip(points).map(&mut line_to).collect()
}

/// VEL-13: a program with three sets; a general optimiser found 0.954 s.
#[test]
fn a_ramp_takes_the_limits_of_each_block() {
    let [one, two, three] = [set(600_000.0, 800.0, 12.0), set(10_000.0, 2000.0, 12.0), set(80_000.0, 500.0, 12.0)];
    let steps = path(&[
        ([0.975, 0.0], 8000.0, three),
        ([2.125, -0.219], 8000.0, one),
        ([16.908, -3.035], 8000.0, two),
        ([43.67, -6.845], 8000.0, two),
        ([47.342, -7.368], 8000.0, two),
        ([71.963, -10.873], 8000.0, one),
    ]);
    let model = Model { shortest_s: 0.004, angle_deg: 120.0, raise_s: 0.001, ..model(Profile::Parabolic) };
    let planned = plan(&model, &steps);
    verify(&model, &steps, &planned.blocks);
    close(planned.time(), 0.954, 0.05);
}

/// VEL-12: the rise from 2.496 to 2.545 mm/s in the second block saves a tenth of a millisecond, and those behind it
/// save little: each is taken back, and the velocity of the first short block holds up to the end.
#[test]
fn rises_that_save_little_are_taken_back() {
    let set = set(150_000.0, 200.0, 50.0);
    let vectors: [[f64; 2]; 8] = [
        [-2.686, -5.365],
        [0.05, 0.064],
        [0.001, 0.002],
        [0.026, 0.054],
        [0.009, 0.022],
        [0.001, 0.003],
        [0.001, 0.005],
        [0.004, 0.064],
    ];
    let lines = (0..).zip(vectors).map(|(seq, [x, y])| line(seq, [x, y, 0.0], 6000.0, set));
    let steps: Vec<Step> = lines.collect();
    let model = Model {
        recognition: cnc872c::analysis::motion::Recognition::Manual,
        shortest_s: 0.004,
        raise_s: 0.5,
        ..model(Profile::Parabolic)
    };
    let planned = plan(&model, &steps);
    let peaks = planned.blocks.iter().map(|block| block.motion.as_ref().unwrap().velocities.unwrap().peak);
    let peaks: Vec<f64> = peaks.collect();
    let lowest = 0.001_f64.hypot(0.002) / 0.004;
    close(peaks[1], 2.496, 1e-3);
    for peak in &peaks[2..] {
        close(*peak, lowest, 1e-9);
    }
}

/// VEL-12: of two equal lowest velocities the left one counts as the higher, so that the rise before both is looked at.
#[test]
fn the_left_one_of_equals_counts_as_higher() {
    let set = set(50_000.0, 600.0, 0.0);
    let lengths = [(20.0, 6000.0), (5.0, 600.0), (0.5, 900.0), (5.0, 600.0), (20.0, 6000.0)];
    let steps: Vec<Step> =
        (0..).zip(lengths).map(|(seq, (length, feed))| line(seq, [length, 0.0, 0.0], feed, set)).collect();
    let peaks = |raise_s: f64| {
        let planned = plan(&Model { raise_s, ..model(Profile::Parabolic) }, &steps);
        let peaks = planned.blocks.iter().map(|block| block.motion.as_ref().unwrap().velocities.unwrap().peak);
        peaks.collect::<Vec<f64>>()
    };
    assert!(peaks(0.0)[2] > 10.1);
    let held = peaks(0.1);
    close(held[2], 10.0, 1e-9);
    // What rises between the lowest velocity and the ends of the stretch saves more.
    assert!(held[0] > 50.0 && held[4] > 50.0, "{held:?}");
}
