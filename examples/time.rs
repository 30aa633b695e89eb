//! How long programs take: path over feed. A reader of executed blocks; acceleration and tool changes are left out.
//! `cargo run --example time -- part.nc`

use std::io::Write;
use std::ops::ControlFlow;
use std::path::Path;

use cnc872c::config::{Purpose, Settings};
use cnc872c::dict::Micro;
use cnc872c::run::{End, Executed, FeedUnit, Length, MotionType, Sink};
use cnc872c::{diag::Findings, disk::DiskLoader, session::Session};

/// Rapid motions, in mm/min.
const RAPID: f64 = 10_000.0;

/// Minutes so far, and how many motions have a time that is not known.
#[derive(Default)]
struct Time(f64, u32);

impl Sink for Time {
    type Whole = Self;

    fn block(&mut self, block: &Executed<'_>, _: &mut Findings) -> ControlFlow<()> {
        self.0 += block.dwell().map_or(0.0, |seconds| seconds.to_f64() / 60.0);
        let Some(motion) = block.motion() else { return ControlFlow::Continue(()) };
        let per_minute = match (motion.kind(), block.feed().map(|feed| (feed.unit, Micro::from(feed.value).to_f64()))) {
            (MotionType::Rapid, _) => Some(RAPID),
            (_, Some((FeedUnit::MmPerMinute | FeedUnit::DegPerMinute, feed))) => Some(feed),
            (_, Some((_, feed))) => block.s().map(|s| Micro::from(s).to_f64() * feed),
            (_, None) => None,
        };
        match (motion.length(), per_minute) {
            (Length::Mm(length) | Length::Deg(length), Some(speed)) if speed > 0.0 => self.0 += length.to_f64() / speed,
            _ => self.1 += 1,
        }
        ControlFlow::Continue(())
    }

    fn end(self, _: End, _: &mut Findings) -> Self {
        self
    }
}

/// The time of a program; none for one with errors, or whose execution stops before its end.
pub fn estimate(session: &Session<'_>, path: &Path) -> String {
    match session.run(path, &path.to_string_lossy(), Purpose::Compile, Time::default()).whole {
        Some(Time(minutes, 0)) => format!("{minutes:.3} min"),
        Some(Time(minutes, unknown)) => format!("at least {minutes:.3} min; {unknown} motions of unknown time"),
        None => "no time: errors, or no way to the end; see `cnc872c check`".to_owned(),
    }
}

fn main() -> std::io::Result<()> {
    for path in std::env::args().skip(1).map(std::path::PathBuf::from) {
        let (loader, settings) = (DiskLoader::new([path.as_path()]), Settings::default());
        let session = Session { loader: &loader, settings: &settings, progress: None };
        writeln!(std::io::stdout(), "{}: {}", path.display(), estimate(&session, &path))?;
    }
    Ok(())
}
