//! Any bytes as program and as macrocycle, formatted in any style: the control executes the same, findings and comments
//! stay, no line gets too long, and formatting again changes nothing.

#![no_main]

use cnc872c::config::{Codes, Level, Numbers};
use cnc872c::diag::Code;
use cnc872c::text::MemoryLoader;
use cnc872c_fuzz::Mode;
use libfuzzer_sys::fuzz_target;

#[path = "../../tests/it/same_program.rs"]
mod same_program;

fuzz_target!(|data: &[u8]| {
    let Some((mode, rest)) = Mode::take(data) else { return };
    let Some((&style, bytes)) = rest.split_first() else { return };
    let mut mode = mode;
    mode.with_project = false;
    let mut settings = mode.settings(&MemoryLoader::new());
    // Formatting may put right what they report; as errors they would keep the program from being compiled.
    settings.lints.extend([Code::E0109, Code::W0108].map(|code| (code, Level::Warn)));
    settings.format.codes = Codes::NAMED[usize::from(style % 3)].1;
    settings.format.numbers = Numbers::NAMED[usize::from(style >> 2 & 1)].1;
    settings.format.indent = 1 + (style >> 3 & 7);
    settings.format.blank_lines = style >> 6;
    for name in ["p.nc", "L1"] {
        if let Err(difference) = same_program::stays_the_same(name, bytes, &settings) {
            panic!("{difference}");
        }
    }
});
