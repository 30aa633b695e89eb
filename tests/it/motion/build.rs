//! Programs for the planner, made directly: points and feeds.

use cnc872c::analysis::motion::{
    BlockTimes, Direction, Dynamics, Listener, Mode, Model, Move, Planner, Profile, Recognition, Step, Unit,
};
use cnc872c::run::MotionType;

/// A machine without criteria.
pub fn model(profile: Profile) -> Model {
    Model {
        recognition: Recognition::Automatic,
        angle_deg: 60.0,
        profile,
        accel: 500.0,
        accel_rapid: 1000.0,
        shortest_s: 0.0,
        break_mm: 0.0,
        merge_mm: 0.0,
        red: 0.2,
        raise_mm: 0.0,
        raise_s: 1e-6,
        look_ahead: 500,
        cycle_ms: 2.0,
        lacks_cycle: false,
        settle_s: 0.0,
        settle_given: false,
        gap_s: 0.0,
        gap_given: false,
    }
}

/// Dynamics of S3's example: P 50.000, A 600.
pub fn dynamics() -> Dynamics {
    Dynamics {
        accel: 600.0,
        jerk: 50_000.0 / 32.768,
        jerk_free: false,
        accuracy_um: 0.0,
        overload: 0.0,
        centripetal: 0.0,
    }
}

/// A block that does nothing.
pub fn idle(seq: u64) -> Step {
    Step {
        seq,
        n: u32::try_from(seq).unwrap() * 10 + 10,
        file: 0,
        line: u32::try_from(seq).unwrap() + 2,
        place: cnc872c::text::Location::default(),
        mode: Mode::Continuous,
        motion: None,
        dwell_s: None,
        stops: false,
        breaks_before: false,
        breaks_after: false,
        function_s: 0.0,
        plain: true,
        untimed_change: false,
        untimed_function: false,
        opaque: false,
        approach: false,
        tool: None,
    }
}

/// A linear block over `vector` at `feed` mm/min.
pub fn line(seq: u64, vector: [f64; 3], feed: f64, dynamics: Dynamics) -> Step {
    let length = vector.iter().map(|part| part * part).sum::<f64>().sqrt();
    let along = if length > 0.0 { Direction::Along(vector) } else { Direction::Still };
    let mut all = [0.0; 9];
    all[..3].copy_from_slice(&vector);
    let motion = Move {
        kind: MotionType::Linear,
        length: Some(length),
        unit: Unit::Mm,
        from: along,
        to: along,
        vector: all,
        programmed: Some(feed / 60.0),
        radius: None,
        dynamics,
    };
    Step { motion: Some(motion), ..idle(seq) }
}

/// Lines of these vectors, all at one feed.
pub fn lines(vectors: &[[f64; 3]], feed: f64, dynamics: Dynamics) -> Vec<Step> {
    (0..).zip(vectors).map(|(seq, vector)| line(seq, *vector, feed, dynamics)).collect()
}

/// The plan of a program.
#[derive(Debug, Default)]
pub struct Planned {
    pub blocks: Vec<BlockTimes>,
    pub stretches: Vec<f64>,
    pub no_jerk: f64,
}

impl Listener for Planned {
    fn block(&mut self, block: &BlockTimes) {
        self.blocks.push(block.clone());
    }
    fn stretch(&mut self, index: u64, motion_s: f64) {
        assert_eq!(index, self.stretches.len() as u64);
        self.stretches.push(motion_s);
    }
    fn no_jerk(&mut self, motion_s: f64) {
        self.no_jerk += motion_s;
    }
}

impl Planned {
    /// Seconds of the whole program.
    pub fn time(&self) -> f64 {
        self.blocks.iter().map(|block| block.duration_s).sum()
    }
}

/// Plans a program, with phases.
pub fn plan(model: &Model, steps: &[Step]) -> Planned {
    let mut planner = Planner::new(model.clone(), true);
    let mut planned = Planned::default();
    for step in steps {
        planner.push(step, &mut planned);
    }
    planner.finish(&mut planned);
    let seqs: Vec<u64> = planned.blocks.iter().map(|block| block.seq).collect();
    assert_eq!(seqs, steps.iter().map(|step| step.seq).collect::<Vec<_>>(), "every block comes out once, in order");
    planned
}

/// Whether two numbers agree so far.
#[track_caller]
pub fn close(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{found} is not {expected}");
}

/// A random generator of the tests' own: xorshift.
#[derive(Debug)]
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }
    /// From 0 up to 1.
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
    /// Between both, evenly by size.
    pub fn scaled(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }
    pub fn below(&mut self, count: usize) -> usize {
        (self.unit() * count as f64) as usize
    }
}
