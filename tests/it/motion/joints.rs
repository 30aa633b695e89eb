//! Which joints are passed continuously, and why not.

use cnc872c::analysis::motion::{
    BlockTimes, Break, Direction, Dot, Joint, Limit, Mode, Move, Profile, Recognition, Step, Unit,
};
use cnc872c::run::MotionType;

use super::build::{close, dynamics, idle, line, lines, model, plan};

fn joint(block: &BlockTimes) -> Joint {
    block.motion.as_ref().unwrap().joint.unwrap()
}

/// The reason that breaks the joint between two blocks, what is between them included.
fn broken(steps: &[Step]) -> Option<Break> {
    let planned = plan(&model(Profile::Linear), steps);
    joint(planned.blocks.last().unwrap()).broken_by
}

fn with(step: Step, change: impl FnOnce(&mut Move)) -> Step {
    let mut motion = step.motion.unwrap();
    change(&mut motion);
    Step { motion: Some(motion), ..step }
}

/// CNT-2: each reason, and the first of several.
#[test]
fn reasons() {
    let two = || lines(&[[10.0, 0.0, 0.0], [10.0, 0.0, 0.0]], 1000.0, dynamics());
    let change = |place: usize, change: &dyn Fn(Step) -> Step| {
        let mut steps = two();
        steps[place] = change(steps[place]);
        broken(&steps)
    };
    assert_eq!(broken(&two()), None);
    assert_eq!(broken(&two()[..1]), Some(Break::Start));
    for mode in [Mode::Tight, Mode::Basic, Mode::Other] {
        assert_eq!(change(1, &|step| Step { mode, ..step }), Some(Break::Mode));
        // CNT-3: the earlier block may be in another mode, but for G98, in which it ends with a ramp (CNT-1).
        let basic = (mode == Mode::Basic).then_some(Break::Mode);
        assert_eq!(change(0, &|step| Step { mode, ..step }), basic);
    }
    for place in [0, 1] {
        for (kind, reason) in [
            (MotionType::Rapid, Break::Rapid),
            (MotionType::Thread, Break::OtherMotion),
            (MotionType::Reference, Break::OtherMotion),
        ] {
            assert_eq!(change(place, &|step| with(step, |motion| motion.kind = kind)), Some(reason));
        }
        let unknown: [&dyn Fn(&mut Move); 4] = [
            &|motion| motion.length = None,
            &|motion| (motion.from, motion.to) = (Direction::Unknown, Direction::Unknown),
            &|motion| motion.programmed = None,
            &|motion| motion.programmed = Some(0.0),
        ];
        for unknown in unknown {
            assert_eq!(change(place, &|step| with(step, unknown)), Some(Break::Unknown));
        }
        let still = |step| with(step, |motion| (motion.from, motion.to) = (Direction::Still, Direction::Still));
        assert_eq!(change(place, &still), Some(Break::Axes));
    }
    assert_eq!(change(0, &|step| Step { dwell_s: Some(0.0), ..step }), Some(Break::Dwell));
    assert_eq!(change(1, &|step| Step { dwell_s: Some(1.0), ..step }), None);
    assert_eq!(change(0, &|step| Step { stops: true, ..step }), Some(Break::Stop));
    assert_eq!(change(0, &|step| Step { breaks_after: true, ..step }), Some(Break::MFunction));
    assert_eq!(change(1, &|step| Step { breaks_before: true, ..step }), Some(Break::MFunction));
    assert_eq!(change(0, &|step| Step { breaks_before: true, ..step }), None);
    // A block without motion, and a motion of length 0, lie between.
    let first = line(0, [10.0, 0.0, 0.0], 1000.0, dynamics());
    let last = line(2, [10.0, 0.0, 0.0], 1000.0, dynamics());
    assert_eq!(broken(&[first, idle(1), last]), Some(Break::NoMotion));
    assert_eq!(broken(&[first, line(1, [0.0; 3], 1000.0, dynamics()), last]), Some(Break::NoMotion));
    // CNT-1: the ramp of G98 is the first reason but for the start.
    let basic = Step { mode: Mode::Basic, ..first };
    assert_eq!(broken(&[basic, line(1, [0.0, 10.0, 0.0], 1000.0, dynamics())]), Some(Break::Mode));
    assert_eq!(broken(&[Step { dwell_s: Some(0.0), ..basic }, last]), Some(Break::Mode));
    // The first reason counts.
    let stopped = Step { dwell_s: Some(1.0), stops: true, breaks_after: true, ..first };
    assert_eq!(broken(&[stopped, last]), Some(Break::Dwell));
    assert_eq!(broken(&[stopped, idle(1), last]), Some(Break::NoMotion));
    assert_eq!(broken(&[stopped, idle(1), Step { mode: Mode::Tight, ..last }]), Some(Break::Mode));
}

/// CNT-2, CNT-3: in manual recognition neither angle nor axes count, but units do.
#[test]
fn manual_recognition() {
    let mut manual = model(Profile::Linear);
    manual.recognition = Recognition::Manual;
    let steps = lines(&[[10.0, 0.0, 0.0], [-10.0, 0.1, 0.0]], 1000.0, dynamics());
    assert_eq!(joint(&plan(&manual, &steps).blocks[1]).broken_by, None);
    assert_eq!(broken(&steps), Some(Break::Angle));
    let turned = with(steps[1], |motion| {
        motion.unit = Unit::Deg;
        (motion.from, motion.to) = (Direction::Still, Direction::Still);
    });
    assert_eq!(joint(&plan(&manual, &[steps[0], turned]).blocks[1]).broken_by, Some(Break::Axes));
    let both = plan(&manual, &[with(turned, |_| ()), Step { seq: 2, ..turned }]);
    assert_eq!(joint(&both.blocks[1]).broken_by, None);
    assert_eq!(joint(&both.blocks[1]).angle_deg, None);
}

/// CNT-2: lengths, times and angles; what is equal to a limit breaks by angle only.
#[test]
fn short_blocks_and_angles() {
    let steps = lines(&[[10.0, 0.0, 0.0], [0.5, 0.0, 0.0], [10.0, 0.0, 0.0]], 6000.0, dynamics());
    let mut limited = model(Profile::Linear);
    limited.break_mm = 0.5;
    assert_eq!(joint(&plan(&limited, &steps).blocks[1]).broken_by, None);
    limited.break_mm = 0.501;
    for block in [1, 2] {
        assert_eq!(joint(&plan(&limited, &steps).blocks[block]).broken_by, Some(Break::ShortLength));
    }
    for (profile, reason) in [(Profile::Ramps, Some(Break::ShortTime)), (Profile::Linear, None)] {
        let mut limited = model(profile);
        // 0.5 mm at 100 mm/s take 5 ms.
        limited.shortest_s = 0.005;
        assert_eq!(joint(&plan(&limited, &steps).blocks[1]).broken_by, None);
        limited.shortest_s = 0.00501;
        assert_eq!(joint(&plan(&limited, &steps).blocks[1]).broken_by, reason);
    }
    for degrees in [30.0_f64, 45.0, 60.0, 90.0, 135.0, 180.0] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let steps = lines(&[[10.0, 0.0, 0.0], [10.0 * cosine, 10.0 * sine, 0.0]], 6000.0, dynamics());
        let mut limited = model(Profile::Linear);
        limited.angle_deg = degrees;
        assert_eq!(joint(&plan(&limited, &steps).blocks[1]).broken_by, Some(Break::Angle), "{degrees}");
        if degrees == 180.0 {
            continue;
        }
        limited.angle_deg = degrees + 0.001;
        let found = joint(&plan(&limited, &steps).blocks[1]);
        assert_eq!(found.broken_by, None, "{degrees}");
        close(found.angle_deg.unwrap(), degrees, 1e-9);
    }
    // R39 of 0 breaks every joint.
    let mut limited = model(Profile::Linear);
    limited.angle_deg = 0.0;
    let steps = lines(&[[10.0, 0.0, 0.0]; 2], 6000.0, dynamics());
    assert_eq!(joint(&plan(&limited, &steps).blocks[1]).broken_by, Some(Break::Angle));
}

/// CNT-5: a stretch is at rest at both ends, also one of a single working block in G23.
#[test]
fn stretches() {
    let mut steps = lines(&[[10.0, 0.0, 0.0]; 4], 1000.0, dynamics());
    steps[2].mode = Mode::Tight;
    let planned = plan(&model(Profile::Linear), &steps);
    let of = |block: usize| planned.blocks[block].motion.as_ref().unwrap().stretch.map(|place| place.index);
    // The block in G24 begins the last stretch: the one behind it joins it.
    assert_eq!([of(0), of(1), of(2), of(3)], [Some(0), Some(0), Some(1), Some(1)]);
    assert_eq!(planned.stretches.len(), 2);
    steps[3].mode = Mode::Tight;
    let planned = plan(&model(Profile::Linear), &steps);
    let of = |block: usize| planned.blocks[block].motion.as_ref().unwrap().stretch;
    assert_eq!((of(2), of(3)), (None, None));
    let single = plan(&model(Profile::Linear), &steps[..1]);
    assert!(!single.blocks[0].motion.as_ref().unwrap().stretch.unwrap().continued);
}

/// VEL-7, VEL-8: the least of the caps, and which acceleration counts where.
#[test]
fn caps_and_accelerations() {
    let mut model = model(Profile::Linear);
    (model.accel, model.accel_rapid) = (250.0, 1000.0);
    let step = line(0, [10.0, 0.0, 0.0], 60_000.0, dynamics());
    let time = |step: Step| plan(&model, &[step]).time();
    // From rest to rest over 10 mm: 2·√(L/a).
    close(time(step), 2.0 * (10.0_f64 / 600.0).sqrt(), 1e-12);
    close(time(Step { mode: Mode::Basic, ..step }), 2.0 * (10.0_f64 / 250.0).sqrt(), 1e-12);
    close(time(with(step, |motion| motion.kind = MotionType::Rapid)), 2.0 * (10.0_f64 / 1000.0).sqrt(), 1e-12);
    close(time(with(step, |motion| motion.kind = MotionType::Thread)), 2.0 * (10.0_f64 / 250.0).sqrt(), 1e-12);
    model.shortest_s = 0.5;
    let capped = plan(&model, &[step]);
    close(capped.blocks[0].motion.as_ref().unwrap().cap.unwrap().0, 20.0, 1e-12);
    // VEL-6 counts in stretches only.
    let tight = plan(&model, &[Step { mode: Mode::Tight, ..step }]);
    close(tight.blocks[0].motion.as_ref().unwrap().cap.unwrap().0, 1000.0, 1e-12);
    // In the parabolic profile every change of velocity is parabolic: in G00, G24, G98 and in threads.
    let curved = super::build::model(Profile::Parabolic);
    let jerk = dynamics().jerk;
    // √(L/2·√J)^(2/3) is the peak of an S curve over L.
    let peak = (10.0_f64 / 2.0 * jerk.sqrt()).powf(2.0 / 3.0);
    let alone = [
        with(step, |motion| motion.kind = MotionType::Rapid),
        with(step, |motion| motion.kind = MotionType::Thread),
        Step { mode: Mode::Tight, ..step },
        Step { mode: Mode::Basic, ..step },
    ];
    for step in alone {
        close(plan(&curved, &[step]).time(), 4.0 * (peak / jerk).sqrt(), 1e-9);
    }
}

/// VEL-9: the time criterion, and what limits a joint.
#[test]
fn rises_that_save_too_little() {
    let sharp = cnc872c::analysis::motion::Dynamics { overload: 8000.0, ..dynamics() };
    let (sine, cosine) = 50.0_f64.to_radians().sin_cos();
    let vectors = [[10.0, 0.0, 0.0], [10.0 * cosine, 10.0 * sine, 0.0], [10.0, 0.0, 0.0]];
    let steps = lines(&vectors, 6000.0, sharp);
    let mut model = model(Profile::Linear);
    let velocity = 8000.0 * 0.002 / 2.0 / 25.0_f64.to_radians().sin();
    model.raise_s = 10.0 / velocity * 1.001;
    let peak = |planned: &super::build::Planned| planned.blocks[1].motion.as_ref().unwrap().velocities.unwrap().peak;
    close(peak(&plan(&model, &steps)), velocity, 1e-9);
    model.raise_s = 10.0 / velocity * 0.999;
    close(peak(&plan(&model, &steps)), (velocity * velocity + 600.0 * 10.0).sqrt(), 1e-9);
    assert_eq!(joint(&plan(&model, &steps).blocks[1]).limited_by, Some(Limit::Overload));
}

/// VEL-10: one block ahead, no criteria, and no room to stop in a short last block.
#[test]
fn ramps_see_one_block() {
    let sharp = cnc872c::analysis::motion::Dynamics { overload: 10.0, accuracy_um: 0.1, ..dynamics() };
    let mut model = model(Profile::Ramps);
    model.raise_s = 1e9;
    let steps = lines(&[[100.0, 0.0, 0.0], [100.0, 0.0, 0.0], [1.0, 0.0, 0.0]], 6000.0, sharp);
    let planned = plan(&model, &steps);
    let found: Vec<Joint> = planned.blocks.iter().map(joint).collect();
    close(found[1].velocity, 100.0, 1e-12);
    // √(2·a·L) of the last block.
    close(found[2].velocity, (2.0 * 600.0_f64).sqrt(), 1e-12);
    assert_eq!((found[1].limited_by, found[2].limited_by), (Some(Limit::Feed), Some(Limit::Ramp)));
    assert_eq!(found.iter().map(|joint| joint.no_room_to_stop).collect::<Vec<_>>(), [false, false, true]);
    let slow = lines(&[[100.0, 0.0, 0.0], [1.0, 0.0, 0.0]], 60.0 * 30.0, sharp);
    assert!(!joint(&plan(&model, &slow).blocks[1]).no_room_to_stop);
}

/// VEL-12: between two lowest velocities the curve rises only when that pays.
#[test]
fn rises_of_the_curve() {
    let sharp = cnc872c::analysis::motion::Dynamics { overload: 8000.0, ..dynamics() };
    let (sine, cosine) = 50.0_f64.to_radians().sin_cos();
    let vectors = [[40.0, 0.0, 0.0], [40.0 * cosine, 40.0 * sine, 0.0], [40.0, 0.0, 0.0]];
    let steps = lines(&vectors, 6000.0, sharp);
    let mut model = model(Profile::Parabolic);
    let velocity = 8000.0 * 0.002 / 2.0 / 25.0_f64.to_radians().sin();
    let held = |model: &_| {
        let planned = plan(model, &steps);
        let velocities = planned.blocks[1].motion.as_ref().unwrap().velocities.unwrap();
        (velocities.peak < velocity * (1.0 + 1e-9), planned.blocks[1].duration_s)
    };
    let (flat, fast) = held(&model);
    assert!(!flat);
    model.raise_s = 1e9;
    let (flat, slow) = held(&model);
    assert!(flat);
    close(slow, 40.0 / velocity, 1e-9);
    for (part, expected) in [(0.999, false), (1.001, true)] {
        model.raise_s = (slow - fast) * part;
        assert_eq!(held(&model).0, expected);
    }
}

/// VEL-14: each block goes by its own set; where sets meet, both limit.
#[test]
fn sets_meet() {
    let fine = cnc872c::analysis::motion::Dynamics { accel: 100.0, jerk: 200.0, overload: 500.0, ..dynamics() };
    let mut steps = lines(&[[20.0, 0.0, 0.0], [20.0, 1.0, 0.0], [20.0, 1.0, 0.0]], 6000.0, dynamics());
    steps[1] = line(1, [20.0, 1.0, 0.0], 6000.0, fine);
    let planned = plan(&model(Profile::Parabolic), &steps);
    super::verify::verify(&model(Profile::Parabolic), &steps, &planned.blocks);
    let alpha = (1.0_f64 / 20.0).atan();
    let cap = 500.0 * 0.002 / 2.0 / (alpha / 2.0).sin();
    assert!(joint(&planned.blocks[1]).velocity <= cap * (1.0 + 1e-9));
}

/// DOT-1: one of both at least is a working block in G23.
#[test]
fn dots() {
    let mut steps =
        lines(&[[10.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [10.0, 0.0, 0.0]], 6000.0, dynamics());
    steps.push(Step { mode: Mode::Tight, ..line(4, [10.0, 0.0, 0.0], 6000.0, dynamics()) });
    steps.push(with(line(5, [10.0, 0.0, 0.0], 6000.0, dynamics()), |motion| motion.kind = MotionType::Rapid));
    let planned = plan(&model(Profile::Linear), &steps);
    let dots: Vec<_> = planned.blocks.iter().map(|block| joint(block).dot).collect();
    assert_eq!(dots, [None, Some(Dot::Yellow), Some(Dot::Red), Some(Dot::Red), Some(Dot::Red), None]);
    // A joint that is slower than its share is red.
    let crawl = cnc872c::analysis::motion::Dynamics { overload: 100.0, ..dynamics() };
    let steps = lines(&[[10.0, 0.0, 0.0], [10.0, 1.0, 0.0]], 6000.0, crawl);
    let mut model = model(Profile::Linear);
    let velocity = joint(&plan(&model, &steps).blocks[1]).velocity;
    for (red, dot) in
        [(velocity / 100.0 * 1.001, Dot::Red), (velocity / 100.0 * 0.999, Dot::Yellow), (0.0, Dot::Yellow)]
    {
        model.red = red;
        assert_eq!(joint(&plan(&model, &steps).blocks[1]).dot, Some(dot));
    }
}

/// TIM-1, TIM-2, TIM-3: what a block takes.
#[test]
fn times_of_blocks() {
    let mut model = model(Profile::Linear);
    (model.settle_s, model.gap_s) = (0.25, 0.125);
    let mut steps = lines(&[[10.0, 0.0, 0.0]; 4], 600.0, dynamics());
    steps[2].mode = Mode::Tight;
    steps[2].dwell_s = Some(2.0);
    steps[3].mode = Mode::Basic;
    steps.push(Step { function_s: 6.5, mode: Mode::Basic, ..idle(4) });
    steps.push(with(line(5, [1.0, 0.0, 0.0], 600.0, dynamics()), |motion| motion.length = None));
    steps.push(Step { opaque: true, ..idle(6) });
    let planned = plan(&model, &steps);
    let motion = |block: usize| planned.blocks[block].motion.as_ref().and_then(|motion| motion.motion_s).unwrap_or(0.0);
    let extra: Vec<f64> = (0..7).map(|block| planned.blocks[block].duration_s - motion(block)).collect();
    let expected = [0.0, 0.25, 2.25, 0.125, 6.625, 0.25, 0.0];
    extra.iter().zip(expected).for_each(|(found, expected)| assert!((found - expected).abs() < 1e-12, "{extra:?}"));
    assert_eq!(planned.blocks.iter().filter(|block| block.unknown).count(), 2);
    let mut clock = 0.0;
    for block in &planned.blocks {
        assert!((block.start_s - clock).abs() < 1e-9);
        clock += block.duration_s;
    }
    let stretch = |block: usize| planned.blocks[block].motion.as_ref().unwrap().stretch.unwrap();
    close(stretch(1).before_s, motion(0), 1e-12);
    close(planned.stretches[0], motion(0) + motion(1), 1e-12);
}
