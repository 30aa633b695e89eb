//! The mistakes of a program, the blocks that the control executes, and its block stream.
//! `cargo run --no-default-features --example library`

use std::io;
use std::ops::ControlFlow;
use std::path::Path;

use cnc872c::config::{Purpose, Settings};
use cnc872c::diag::{Findings, Format, Report, Shown, render};
use cnc872c::run::{End, Executed, Length, Sink};
use cnc872c::session::{Part, Session};
use cnc872c::text::MemoryLoader;

const PART: &str =
    "%1\nN10 G00 X0\nN20 G01 X30 F200\nN30 G71 L100 Q2\nN40 M30\nN50 G79 L100\nN60 G91 X10\nN70 G90 G70\n";

/// Reads executed blocks: how far the program moves, in millimetres, where that is known.
struct Travel(f64);

impl Sink for Travel {
    type Whole = f64;

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        if let Some(Length::Mm(length)) = block.motion().map(|motion| motion.length()) {
            self.0 += length.to_f64();
        }
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) -> f64 {
        self.0
    }
}

/// Looks at two programs: one that is right, and one with an axis written twice.
pub fn run() -> io::Result<()> {
    let loader = MemoryLoader::new().with("part.nc", PART).with("twice.nc", "%2\nN10 X1 X2\nN20 M30\n");
    let settings = Settings::default();
    let session = Session { loader: &loader, settings: &settings, progress: None };
    let (part, twice) = (Path::new("part.nc"), Path::new("twice.nc"));

    // Two passes of the subprogram follow the block that moves to X30. The first motion has no known start.
    let travel = session.run(part, "part.nc", Purpose::Compile, Travel(0.0));
    assert_eq!(travel.whole, Some(50.0));

    let mut stream = Vec::new();
    let whole = session.compile(part, "part.nc", Part::default(), &mut stream)?;
    assert!(whole.whole.is_some());
    let stream = String::from_utf8_lossy(&stream);
    assert!(stream.lines().any(|line| line.contains(r#""n":60"#) && line.contains(r#""position":{"X":50}"#)));

    let outcome = session.check(twice, "twice.nc");
    let mut report = Report::new();
    report.add_program(&outcome.sources, outcome.findings);
    let mut lines = Vec::new();
    render(Format::Short, &report, Shown::default(), &mut lines)?;
    assert!(String::from_utf8_lossy(&lines).starts_with("twice.nc:2:8: error[E0306]"));
    Ok(())
}

fn main() -> io::Result<()> {
    run()
}
