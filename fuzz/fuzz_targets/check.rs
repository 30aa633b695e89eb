//! Any bytes as program and as macrocycle: check, and the findings in every form; the short way through plain blocks.

#![no_main]

use std::path::Path;

use cnc872c::session::Session;
use cnc872c::text::MemoryLoader;
use cnc872c_fuzz::{Mode, PROJECT, assert_outcome};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Some((mode, bytes)) = Mode::take(data) else { return };
    let loader =
        MemoryLoader::new().with("cnc872c.toml", PROJECT).with("p.nc", bytes).with("L1", bytes).with("L9001.NC", bytes);
    let settings = mode.settings(&loader);
    let session = Session { loader: &loader, settings: &settings, progress: None };
    let lengths = [("p.nc", bytes.len()), ("L1", bytes.len()), ("L9001.NC", bytes.len())];
    for name in ["p.nc", "L1"] {
        assert_outcome(session.check(Path::new(name), name), &lengths);
    }
    // The library has this only when it is fuzzed.
    #[cfg(fuzzing)]
    if let Ok(text) = std::str::from_utf8(bytes) {
        use cnc872c::syntax::{Form, short_way_agrees};
        for form in [Form::Program, Form::Macrocycle] {
            assert!(short_way_agrees(text, form), "{form:?}");
        }
    }
});
