//! VEL-13: profiles beside the least times of small programs, which `optimal/optimal.py` found numerically.

use cnc872c::analysis::motion::{Dynamics, Profile, Step};
use serde::Deserialize;

use super::build::{line, model, plan};
use super::verify::verify;

/// A program with its least time.
#[derive(Debug, Deserialize)]
struct Program {
    kind: String,
    /// What VEL-13 allows.
    bound: f64,
    accuracy_um: f64,
    blocks: Vec<Block>,
    time_s: f64,
}

#[derive(Debug, Deserialize)]
struct Block {
    vector: [f64; 3],
    feed: f64,
    accel: f64,
    p: f64,
}

impl Program {
    fn steps(&self) -> Vec<Step> {
        let dynamics = |block: &Block| Dynamics {
            accel: block.accel,
            jerk: block.p / 32.768,
            jerk_free: false,
            accuracy_um: self.accuracy_um,
            overload: 0.0,
            centripetal: 0.0,
        };
        (0..).zip(&self.blocks).map(|(seq, block)| line(seq, block.vector, block.feed, dynamics(block))).collect()
    }
}

/// Within the bounds of VEL-13; and not faster, for the limits hold.
#[test]
fn beside_numerical_optima() {
    let programs: Vec<Program> = serde_json::from_str(include_str!("optimal/programs.json")).unwrap();
    assert!(programs.len() > 15);
    let mut worst: Vec<(f64, String)> = Vec::new();
    for (at, program) in programs.iter().enumerate() {
        let (model, steps) = (model(Profile::Parabolic), program.steps());
        let planned = plan(&model, &steps);
        verify(&model, &steps, &planned.blocks);
        let over = planned.time() / program.time_s - 1.0;
        // The optima have a grid in time: a ramp may begin and end between its points.
        assert!(over > -0.01, "{at}: faster than what is possible: {over} {program:?}");
        worst.push((over - program.bound, format!("{at}: {:.2} % {}", over * 100.0, program.kind)));
    }
    worst.sort_by(|a, b| b.0.total_cmp(&a.0));
    let beyond: Vec<&str> = worst.iter().filter(|(over, _)| *over > 0.0).map(|(_, what)| what.as_str()).collect();
    assert!(beyond.is_empty(), "{beyond:#?}");
}
