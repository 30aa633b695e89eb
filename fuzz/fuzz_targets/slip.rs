//! One slip of the keyboard in a correct program: what `check --fix` makes of it is never clean and another program.

#![no_main]

#[path = "../../tests/it/slip_measure.rs"]
#[allow(dead_code, reason = "the test counts findings, too")]
mod slip_measure;

use libfuzzer_sys::fuzz_target;

use crate::slip_measure::{Outcome, PROGRAMS, Slip, measure};

fuzz_target!(|data: &[u8]| {
    let mut pairs = data.chunks_exact(2).map(|pair| usize::from(u16::from_le_bytes([pair[0], pair[1]])));
    let mut next = || pairs.next().unwrap_or(0);
    let program = &PROGRAMS[next() % PROGRAMS.len()];
    let slip = Slip::take(program.text, next);
    if let Outcome::Different { text } = measure(program, &slip) {
        panic!("{}: {:?}, clean and different: {text:?}", program.name, slip.lines(program.text));
    }
});
