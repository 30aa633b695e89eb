//! VEL-13 where sets change: the planner beside least times that are found by trying, from VEL-11 alone.

use std::collections::BTreeMap;

use cnc872c::analysis::motion::{Dynamics, Model, Profile, Step};

use super::build::{Random, dynamics, line, model, plan};

/// A line: length, cap, acceleration, jerk.
#[derive(Clone, Copy, Debug)]
struct Line {
    length: f64,
    cap: f64,
    accel: f64,
    jerk: f64,
}

/// The least time of lines in one direction from rest to rest, found by trying: time goes in steps of `dt`, in each of
/// which the jerk is a whole multiple of `unit`, so that accelerations and velocities lie on a lattice. Of all states
/// with the same acceleration and velocity in the same hundredth of the way, the one that has come farthest goes on.
/// What it finds is possible, and up to about `dt` above the least time.
fn least_time(lines: &[Line], dt: f64, unit: f64) -> Option<f64> {
    let ends: Vec<f64> = (1..=lines.len()).map(|count| lines[..count].iter().map(|line| line.length).sum()).collect();
    let total = ends[ends.len() - 1];
    let line_at = |s: f64| ends.iter().position(|end| s < *end).unwrap_or(ends.len() - 1);
    let (accel_unit, speed_unit) = (unit * dt, unit * dt * dt / 2.0);
    let mut states = BTreeMap::from([((0_i32, 0_i32, 0_i32), 0.0)]);
    for step in 1..200 {
        let mut next = BTreeMap::new();
        for (&(v, a, _), &s) in &states {
            let first = line_at(s);
            let most = (lines[first].jerk / unit).round() as i32;
            for j in -most..=most {
                let (a_next, v_next) = (a + j, v + 2 * a + j);
                let s_next = s + unit * dt * dt * dt * (f64::from(v + a) / 2.0 + f64::from(j) / 6.0);
                let fits = |line: &Line| {
                    f64::from(j.abs()) * unit <= line.jerk * (1.0 + 1e-9)
                        && f64::from(a.abs().max(a_next.abs())) * accel_unit <= line.accel
                        && f64::from(v.max(v_next)) * speed_unit <= line.cap
                };
                if v_next < 0 || s_next > total * 1.02 || !lines[first..=line_at(s_next)].iter().all(fits) {
                    continue;
                }
                if (v_next, a_next) == (0, 0) && s_next >= total {
                    return Some(f64::from(step) * dt);
                }
                let farthest = next.entry((v_next, a_next, (s_next / total * 100.0) as i32)).or_insert(s_next);
                *farthest = s_next.max(*farthest);
            }
        }
        states = next;
    }
    None
}

#[test]
fn beside_what_trying_finds_where_sets_change() {
    let mut compared = 0;
    for seed in 0..8 {
        let mut random = Random::new(500 + seed);
        let (unit, cap) = (random.scaled(500.0, 3000.0), random.scaled(30.0, 200.0));
        let mut any = |_| Line {
            length: random.scaled(1.0, 15.0),
            cap,
            accel: random.scaled(200.0, 900.0),
            jerk: unit * (1 + random.below(4)) as f64,
        };
        let lines: Vec<Line> = (0..2 + seed as usize % 3).map(&mut any).collect();
        let way: f64 = lines.iter().map(|line| line.length).sum();
        // A motion with twice that jerk alone takes 4·∛(way/4J).
        let dt = 4.0 * (way / (4.0 * unit)).cbrt() / 16.0;
        let Some(least) = least_time(&lines, dt, unit) else { continue };
        compared += 1;
        let step = |(seq, each): (u64, &Line)| {
            let set = Dynamics { accel: each.accel, jerk: each.jerk, ..dynamics() };
            line(seq, [each.length, 0.0, 0.0], each.cap * 60.0, set)
        };
        let steps: Vec<Step> = (0..).zip(&lines).map(step).collect();
        let planned = plan(&Model { raise_s: 0.0, ..model(Profile::Parabolic) }, &steps).time();
        assert!(planned <= 1.15 * (least - dt), "{planned} s beside {least} s by steps of {dt} s\n{lines:?}");
        assert!(planned >= 0.85 * (least - dt), "{planned} s is less than possible, {least} s\n{lines:?}");
    }
    assert!(compared >= 6, "{compared}");
}
