//! Slips of the keyboard in correct programs: what `check --fix` makes of each is the program that was meant, or has a
//! finding left, or was not touched (diagnostics.md, "Fixes"). `CNC872C_SLIPS=20000` tries so many, and
//! `CNC872C_SEED=5` others.

use std::env;
use std::fmt::Write as _;

use crate::slip_measure::{Outcome, PROGRAMS, Slip, measure};

/// So many slips are tried unless the environment asks for more.
const SLIPS: u64 = 800;

/// Numbers that look random and are the same each time (xorshift64*).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 33;
        usize::try_from(bits).unwrap() % limit
    }
}

#[test]
#[expect(clippy::print_stdout, reason = "figures, for those who ask for many slips")]
fn a_slip_is_never_fixed_into_another_program() {
    let slips = env::var("CNC872C_SLIPS").map_or(SLIPS, |count| count.parse().expect("a number of slips"));
    let seed = env::var("CNC872C_SEED").map_or(0x0872_0872_0872_0872, |seed| seed.parse().expect("a number"));
    let mut random = Random(seed);
    let (mut fixed, mut meant, mut silent, mut many, mut elsewhere) = (0, 0, 0, Vec::new(), Vec::new());
    let mut different = String::new();
    for _ in 0..slips {
        let program = &PROGRAMS[random.below(PROGRAMS.len())];
        let slip = Slip::take(program.text, || random.below(1 << 16));
        let (before, after) = slip.lines(program.text);
        let outcome = measure(program, &slip);
        fixed += usize::from(!matches!(outcome, Outcome::Untouched { .. }));
        match outcome {
            Outcome::Untouched { found } if found.is_empty() => silent += 1,
            Outcome::Untouched { found } | Outcome::Left { found } => {
                if found.len() > 2 {
                    many.push(format!("{}: {before:?} → {after:?}: {found:?}", program.name));
                }
                let lines = slip.line_numbers(program.text);
                if !found.iter().any(|(_, line)| lines.contains(line)) {
                    elsewhere.push(format!("{}:{lines:?}: {before:?} → {after:?}: {found:?}", program.name));
                }
            }
            Outcome::Meant => meant += 1,
            Outcome::Different { text } => {
                writeln!(different, "{}: {before:?} → {after:?}, fixed {text:?}", program.name).unwrap();
            }
        }
    }
    println!("{slips} slips: {fixed} with a fix, {meant} of them as meant; {silent} without a finding");
    println!("{} with more than two findings:\n{}", many.len(), many.join("\n"));
    println!("{} with findings in other lines only:\n{}", elsewhere.len(), elsewhere.join("\n"));
    assert!(different.is_empty(), "clean and different:\n{different}");
    assert!(many.len() * 200 <= usize::try_from(slips).unwrap(), "more than two findings:\n{}", many.join("\n"));
}
