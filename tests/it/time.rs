//! `examples/time.rs`: a reader of executed blocks is one short file, and is right about programs that are not whole.

use std::path::Path;

use cnc872c::config::Settings;
use cnc872c::session::Session;
use cnc872c::text::MemoryLoader;

#[path = "../../examples/time.rs"]
#[expect(dead_code, reason = "the example's command line is not used here")]
mod example;

fn estimate(body: &str) -> String {
    let loader = MemoryLoader::new().with("t.nc", format!("%1\nN10 G54 G90 G94\n{body}\n"));
    let settings = Settings::default();
    example::estimate(&Session { loader: &loader, settings: &settings, progress: None }, Path::new("t.nc"))
}

#[test]
fn whole_programs() {
    assert_eq!(
        estimate("N20 G00 X0\nN30 G01 X100 F50\nN40 G04 Q300\nN50 M30"),
        "at least 2.050 min; 1 motions of unknown time"
    );
    assert_eq!(estimate("N20 G04 Q6000\nN50 M30"), "1.000 min");
    // Per revolution: F·S.
    assert_eq!(
        estimate("N20 G00 X0\nN30 G95 G01 X100 F.1 S500 M03\nN50 M30"),
        "at least 2.000 min; 1 motions of unknown time"
    );
}

/// A program with an error (E0603), one whose execution stops (an unknown L), one without an end.
#[test]
fn half_programs() {
    for body in [
        "N20 G01 X0 Y0 F100\nN30 G02 X10 Y0 I2 J0\nN40 M30",
        "N20 G01 X0 F100\nN30 G01 X100\nN40 G71 LR5\nN50 M30",
        "N20 G01 X0 F100\nN30 G01 X100",
    ] {
        assert!(estimate(body).starts_with("no time"), "{body}");
    }
}
