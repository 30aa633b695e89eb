//! Closed forms: numbers that can be computed by hand.

use cnc872c::analysis::motion::{Mode, Move, Profile};
use cnc872c::run::MotionType;

use super::build::{close, dynamics, line, lines, model, plan};
use super::verify::verify;

/// VEL-11: one line from rest to rest.
#[test]
fn one_line_from_rest() {
    let steps = lines(&[[100.0, 0.0, 0.0]], 5000.0, dynamics());
    let planned = plan(&model(Profile::Parabolic), &steps);
    verify(&model(Profile::Parabolic), &steps, &planned.blocks);
    close(planned.time(), 1.667_390, 1e-6);
}

/// VEL-11, VEL-13: a cut line takes the same time.
#[test]
fn the_same_line_in_pieces() {
    for count in [10, 100, 1000] {
        let steps = lines(&vec![[100.0 / f64::from(count), 0.0, 0.0]; count as usize], 5000.0, dynamics());
        let planned = plan(&model(Profile::Parabolic), &steps);
        verify(&model(Profile::Parabolic), &steps, &planned.blocks);
        close(planned.time(), 1.667_390, 1e-6);
    }
}

/// CNT-1: in G98 and G24 each piece begins and ends with a ramp.
#[test]
fn pieces_in_tight_and_basic_mode() {
    for mode in [Mode::Tight, Mode::Basic] {
        for profile in [Profile::Ramps, Profile::Linear, Profile::Parabolic] {
            let mut steps = lines(&[[10.0, 0.0, 0.0]; 10], 5000.0, dynamics());
            steps.iter_mut().for_each(|step| step.mode = mode);
            let planned = plan(&model(profile), &steps);
            let alone = plan(&model(profile), &steps[..1]);
            close(planned.time(), 10.0 * alone.time(), 1e-9);
            // v² = a·L stays below F.
            let jerk = dynamics().jerk;
            let peak = (10.0_f64 / 2.0 * jerk.sqrt()).powf(2.0 / 3.0);
            let curved = 4.0 * (peak / jerk).sqrt();
            let expected = if profile == Profile::Parabolic { curved } else { 2.0 * (10.0_f64 / 500.0).sqrt() };
            close(alone.time(), expected, 1e-9);
        }
    }
}

/// VEL-3: full circles.
#[test]
fn circles_by_centripetal_acceleration() {
    for profile in [Profile::Ramps, Profile::Linear, Profile::Parabolic] {
        let dynamics = cnc872c::analysis::motion::Dynamics { centripetal: 200.0, ..dynamics() };
        let mut step = line(0, [1.0, 0.0, 0.0], 5000.0, dynamics);
        let length = 2.0 * std::f64::consts::PI * 2.0;
        step.motion = step.motion.map(|motion| Move {
            kind: MotionType::ArcCcw,
            length: Some(length),
            radius: Some(2.0),
            ..motion
        });
        let steps = [step];
        let planned = plan(&model(profile), &steps);
        verify(&model(profile), &steps, &planned.blocks);
        let motion = planned.blocks[0].motion.as_ref().unwrap();
        close(motion.cap.unwrap().0, 20.0, 1e-12);
        let change = 20.0_f64;
        let expected = if profile == Profile::Parabolic {
            let ramp = 2.0 * (change / dynamics.jerk).sqrt();
            2.0 * ramp + (length - change * ramp) / change
        } else {
            length / change + change / 600.0
        };
        close(planned.time(), expected, 1e-9);
    }
}

/// VEL-4, VEL-5: the table of joints.
#[test]
fn joints_by_angle() {
    let table = [
        (1.0, 27501.0, 68756.0),
        (5.0, 5496.9, 13755.0),
        (10.0, 2743.2, 6884.0),
        (30.0, 895.7, 2318.0),
        (60.0, 415.7, 1200.0),
    ];
    for (angle, accuracy, overload) in table {
        for (on, expected) in [((8.0, 0.0), accuracy), ((0.0, 10_000.0), overload)] {
            let dynamics = cnc872c::analysis::motion::Dynamics {
                accel: 1e6,
                accuracy_um: on.0,
                overload: on.1,
                jerk: 1e12,
                jerk_free: false,
                centripetal: 0.0,
            };
            let (sine, cosine) = f64::to_radians(angle).sin_cos();
            let steps = lines(&[[1000.0, 0.0, 0.0], [1000.0 * cosine, 1000.0 * sine, 0.0]], 1e5, dynamics);
            for profile in [Profile::Linear, Profile::Parabolic] {
                let mut model = model(profile);
                model.angle_deg = 61.0;
                let planned = plan(&model, &steps);
                let joint = planned.blocks[1].motion.as_ref().unwrap().joint.unwrap();
                close(joint.angle_deg.unwrap(), angle, 1e-9);
                close(joint.velocity * 60.0, expected, 1.1e-4);
            }
        }
    }
}
