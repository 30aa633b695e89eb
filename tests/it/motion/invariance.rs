//! What must not change the time of a program, and what must not make it longer.

use cnc872c::analysis::motion::{Dynamics, Model, Profile, Step};

use super::build::{Planned, Random, close, dynamics, line, model, plan};

/// A program as it is changed: vectors, feeds, dynamics.
#[derive(Clone, Debug)]
struct Path {
    vectors: Vec<[f64; 3]>,
    feeds: Vec<f64>,
    dynamics: Dynamics,
    /// Blocks in which a slower set holds.
    slow: Vec<bool>,
}

impl Path {
    /// A walk in space; where `smooth` no angle is above the tolerance.
    fn random(random: &mut Random, count: usize) -> Self {
        let mut heading: f64 = random.between(0.0, 6.0);
        let mut feed = random.scaled(200.0, 15_000.0);
        let (length, turn) = (random.scaled(0.05, 10.0), random.scaled(0.001, 1.2));
        let mut path = Self {
            vectors: Vec::new(),
            feeds: Vec::new(),
            dynamics: Dynamics {
                accel: random.scaled(100.0, 3000.0),
                jerk: random.scaled(500.0, 1e5),
                jerk_free: false,
                accuracy_um: random.scaled(0.5, 50.0),
                overload: random.scaled(500.0, 20_000.0),
                centripetal: 0.0,
            },
            slow: vec![false; count],
        };
        for _ in 0..count {
            heading += random.between(-turn, turn);
            if random.unit() < 0.2 {
                feed = random.scaled(200.0, 15_000.0);
            }
            let length = length * random.scaled(0.3, 3.0);
            path.vectors.push([length * heading.cos(), length * heading.sin(), length * random.between(-0.1, 0.1)]);
            path.feeds.push(feed);
        }
        path
    }

    fn steps(&self) -> Vec<Step> {
        let lines = self.vectors.iter().zip(&self.feeds).enumerate();
        let slower = Dynamics { accel: self.dynamics.accel / 2.0, jerk: self.dynamics.jerk / 10.0, ..self.dynamics };
        let dynamics = |seq: usize| if self.slow[seq] { slower } else { self.dynamics };
        lines.map(|(seq, (vector, feed))| line(seq as u64, *vector, *feed, dynamics(seq))).collect()
    }

    fn planned(&self, model: &Model) -> Planned {
        plan(model, &self.steps())
    }

    fn time(&self, model: &Model) -> f64 {
        self.planned(model).time()
    }

    fn turned(&self) -> Self {
        let mut back = self.map(|vector| vector.map(|part| -part));
        back.vectors.reverse();
        back.feeds.reverse();
        back.slow.reverse();
        back
    }

    fn map(&self, change: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        Self { vectors: self.vectors.iter().map(|vector| change(*vector)).collect(), ..self.clone() }
    }
}

fn paths(profile: Profile) -> impl Iterator<Item = (Model, Path, Random)> {
    (0..120).map(move |seed| {
        let mut random = Random::new(7000 + seed);
        let count = 1 + random.below(40);
        let path = Path::random(&mut random, count);
        (model(profile), path, random)
    })
}

/// How far a parabolic profile may be from one of the same time: it is not optimal (VEL-13).
const SLACK: f64 = 0.05;

/// What more of something may cost with a parabolic profile, which is near the fastest one (VEL-13): of 10,000 such
/// changes of random programs eight cost more than a ten thousandth, one more than a hundredth.
const LOSS: f64 = 1.0 + 1e-4;

const PROFILES: [Profile; 3] = [Profile::Ramps, Profile::Linear, Profile::Parabolic];

/// Directions and the names of axes do not matter.
#[test]
fn turned_paths() {
    for profile in PROFILES {
        for (model, path, mut random) in paths(profile) {
            let time = path.time(&model);
            let (sine, cosine) = random.between(0.0, 6.0).sin_cos();
            let turned = path.map(|[x, y, z]| [cosine * x - sine * y, sine * x + cosine * y, z]);
            close(turned.time(&model), time, 1e-6);
            close(path.map(|[x, y, z]| [z, x, y]).time(&model), time, 1e-6);
            close(path.map(|[x, y, z]| [-x, y, z]).time(&model), time, 1e-9);
        }
    }
}

/// Backwards it takes as long. With ramps the control sees one block, so that the way back differs.
#[test]
fn reversed_paths() {
    for profile in [Profile::Linear, Profile::Parabolic] {
        for (model, path, _) in paths(profile) {
            close(path.turned().time(&model), path.time(&model), 1e-9);
        }
    }
}

/// Also with changes of sets. The time criterion looks from left to right, so that the way back may differ.
#[test]
fn reversed_paths_with_sets() {
    for (model, mut path, mut random) in paths(Profile::Parabolic) {
        path.slow.iter_mut().for_each(|slow| *slow = random.unit() < 0.3);
        close(path.turned().time(&model), path.time(&model), 1e-9);
    }
}

/// Two lines with a change of sets, and three in which the middle one has the slower set, take no longer for a little
/// more jerk or when one is cut.
#[test]
fn changes_of_sets_do_not_leap() {
    let of = |accel: f64, p: f64, accuracy_um: f64| Dynamics { accel, jerk: p / 32.768, accuracy_um, ..dynamics() };
    let planned = |lines: &[([f64; 2], f64, Dynamics)]| {
        let steps = (0..).zip(lines).map(|(seq, ([x, y], feed, set))| line(seq, [*x, *y, 0.0], *feed, *set));
        plan(&model(Profile::Parabolic), &steps.collect::<Vec<_>>()).time()
    };
    let three = |p: f64| {
        let (fast, slow) = (of(792.0, 41_310.0, 20.9), of(288.0, p, 20.9));
        planned(&[([12.64, 0.0], 9960.0, fast), ([1.19, -0.08], 9960.0, slow), ([12.62, -1.86], 9960.0, fast)])
    };
    let mut last = f64::INFINITY;
    for p in [3538.0, 3540.0, 3550.0, 3570.0, 5000.0, 10_000.0, 20_000.0, 41_310.0] {
        let time = three(p);
        assert!(time <= last * LOSS, "P {p}: {last} s becomes {time} s");
        last = time;
    }
    let (one, other) = (of(900.0, 104_591.0, 2.6), of(406.0, 6444.0, 2.6));
    let second = ([15.18, -10.42], 3144.0, other);
    let whole = planned(&[([21.36, 0.0], 3144.0, one), second]);
    let cut = planned(&[([10.68, 0.0], 3144.0, one), ([10.68, 0.0], 3144.0, one), second]);
    close(cut, whole, 0.01);
}

/// A line in two takes as long as the whole.
#[test]
fn cut_lines() {
    for profile in [Profile::Linear, Profile::Parabolic] {
        for (model, path, mut random) in paths(profile) {
            let mut cut = path.clone();
            let at = random.below(path.vectors.len());
            let part = random.between(0.1, 0.9);
            let vector = path.vectors[at];
            cut.vectors[at] = vector.map(|length| length * part);
            cut.vectors.insert(at + 1, vector.map(|length| length * (1.0 - part)));
            cut.feeds.insert(at, path.feeds[at]);
            cut.slow.insert(at, path.slow[at]);
            close(cut.time(&model), path.time(&model), if profile == Profile::Linear { 1e-9 } else { SLACK });
        }
    }
}

/// More feed, acceleration, jerk, accuracy or overload never takes longer, where no time criterion holds velocity back.
#[test]
fn more_is_not_slower() {
    for profile in PROFILES {
        for (model, path, mut random) in paths(profile) {
            let time = path.time(&model);
            let more = 1.0 + random.unit() * 2.0;
            let mut others = vec![path.clone(); 5];
            others[0].feeds.iter_mut().for_each(|feed| *feed *= more);
            others[1].dynamics.accel *= more;
            others[2].dynamics.jerk *= more;
            others[3].dynamics.accuracy_um *= more;
            others[4].dynamics.overload *= more;
            for (kind, other) in others.iter().enumerate() {
                let slack = if profile == Profile::Parabolic { LOSS } else { 1.0 + 1e-9 };
                let changed = other.time(&model);
                assert!(
                    changed <= time * slack,
                    "{profile:?} {kind}: {time} s becomes {changed} s by {more}\n{path:?}"
                );
            }
        }
    }
}

/// Σ length/F ≤ without limit of jerk ≤ time.
#[test]
fn bounds() {
    for (model, path, _) in paths(Profile::Parabolic) {
        let ideal: f64 = path.steps().iter().map(|step| step.motion.unwrap()).map(ideal).sum();
        let planned = path.planned(&model);
        assert!(ideal <= planned.no_jerk * (1.0 + 1e-12) && planned.no_jerk <= planned.time() * (1.0 + 1e-9));
        let linear = path.time(&Model { profile: Profile::Linear, accel: path.dynamics.accel, ..model });
        close(planned.no_jerk, linear, 1e-9);
    }
}

fn ideal(motion: cnc872c::analysis::motion::Move) -> f64 {
    motion.length.unwrap() / motion.programmed.unwrap()
}
