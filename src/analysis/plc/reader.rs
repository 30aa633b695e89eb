//! The reader of executed blocks: steps for a writer, or those in which a condition holds.

use std::io;
use std::ops::ControlFlow;

use super::blocks::Blocks;
use super::dictionary::Signal;
use super::facts::StepTimes;
use super::fits::Fits;
use super::steps::{Place, Step, Tracker};
use crate::analysis::Part;
use crate::config::{Machine, Purpose, Settings};
use crate::diag::{Code, Findings, Severity};
use crate::run::{End, Executed, Program, Sink};
use crate::text::{LastPlaces, LineColumn};

/// Facts about a program before its first step.
#[derive(Clone, Copy, Debug)]
pub struct Header<'a> {
    /// The program, as the user named it.
    pub name: &'a str,
    /// With which configuration it is executed.
    pub settings: &'a Settings,
    /// The chosen signals.
    pub signals: &'a [&'static Signal],
}

/// Where steps go.
pub trait Writer {
    /// Whether the lines and columns of places are wanted: finding them takes time. Asked once, before the first step.
    fn wants_lines(&self) -> bool {
        true
    }

    /// Before the first step.
    ///
    /// # Errors
    /// What writing gives, here and below.
    fn begin(&mut self, header: &Header<'_>) -> io::Result<()>;

    /// Before the first step of another file.
    ///
    /// # Errors
    /// What writing gives.
    fn file(&mut self, index: u32, name: &str) -> io::Result<()>;

    /// The next step.
    ///
    /// # Errors
    /// What writing gives.
    fn step(&mut self, step: &Step<'_>) -> io::Result<()>;

    /// The program ended, and has no errors.
    ///
    /// # Errors
    /// What writing gives.
    fn end(&mut self, end: End) -> io::Result<()>;
}

/// Follows chosen signals through a program, and gives the steps to a writer.
pub struct Reader<'w> {
    tracker: Tracker,
    blocks: Blocks,
    fits: Option<Fits>,
    /// W0901 where it is an error: an error ends the showing of blocks, and each place is to be found, so that it comes
    /// at the end.
    held: Option<Findings>,
    part: Part,
    next_file: u32,
    /// The last ones, when the writer wants lines and columns.
    places: Option<LastPlaces>,
    writer: &'w mut dyn Writer,
    /// The first error of the writer.
    failed: &'w mut Option<io::Error>,
}

impl<'w> Reader<'w> {
    /// Gives the steps of a part, with the values of these signals. What the writer fails with goes to `failed`, and
    /// ends the reading.
    pub fn new(
        signals: Vec<&'static Signal>,
        machine: &Machine,
        part: Part,
        writer: &'w mut dyn Writer,
        failed: &'w mut Option<io::Error>,
    ) -> Self {
        Self {
            fits: Some(Fits::of(&signals)),
            held: None,
            blocks: Blocks::new(machine, &signals),
            tracker: Tracker::new(signals),
            part,
            next_file: 1,
            places: writer.wants_lines().then(LastPlaces::default),
            writer,
            failed,
        }
    }

    /// The same without W0901: the values are asked about, not shown.
    #[must_use]
    pub fn unreported(self) -> Self {
        Self { fits: None, ..self }
    }

    /// The step whose facts the tracker has been given.
    fn step(&mut self, place: Place, machine: &Machine) -> io::Result<()> {
        self.tracker.take(machine);
        self.give(place)
    }

    fn give(&mut self, place: Place) -> io::Result<()> {
        if self.part.contains(place.seq) { self.writer.step(&self.tracker.step(place)) } else { Ok(()) }
    }

    /// The next block with its times: in place of [`Sink::block`] where motion is computed.
    pub fn timed(&mut self, block: &Executed<'_>, times: StepTimes, findings: &mut Findings) -> ControlFlow<()> {
        self.take(block, Some(times), findings)
    }

    fn take(&mut self, block: &Executed<'_>, times: Option<StepTimes>, findings: &mut Findings) -> ControlFlow<()> {
        if self.failed.is_some() {
            return ControlFlow::Break(());
        }
        let read = self.read(block, times, findings);
        self.keep(read)
    }

    fn read(&mut self, block: &Executed<'_>, times: Option<StepTimes>, findings: &mut Findings) -> io::Result<()> {
        let index = block.file_index();
        if index == self.next_file {
            self.next_file += 1;
            self.writer.file(index, block.file_name())?;
        }
        let machine = &block.settings().machine;
        let place = self.places.as_mut().map(|places| block.line_column_from(places));
        let LineColumn { line, column } = place.unwrap_or(LineColumn { line: 0, column: 0 });
        let place = Place { seq: block.seq(), n: block.n(), file: index, line, column, stop: false };
        if let Some(onward) = self.blocks.go_on(block, times, self.tracker.current()) {
            self.tracker.go_on(onward, machine);
            return self.give(place);
        }
        let stop = self.blocks.read(block, times, self.tracker.room());
        if let Some(fits) = &self.fits {
            fits.check(block, self.held.as_mut().unwrap_or(findings));
        }
        self.step(place, machine)?;
        match stop {
            Some(facts) => {
                *self.tracker.room() = facts;
                self.step(Place { stop: true, ..place }, machine)
            }
            None => Ok(()),
        }
    }

    /// Keeps the first error.
    fn keep(&mut self, result: io::Result<()>) -> ControlFlow<()> {
        match result {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                self.failed.get_or_insert(error);
                ControlFlow::Break(())
            }
        }
    }
}

impl Sink for Reader<'_> {
    type Whole = End;

    fn begin(&mut self, program: &Program<'_>) {
        let header = Header { name: program.name(), settings: program.settings, signals: self.tracker.signals() };
        let begun = self.writer.begin(&header);
        // The first block ends the run.
        let _ = self.keep(begun);
        let denied = program.settings.severity(Code::W0901) == Some(Severity::Error);
        self.held = denied.then(|| Findings::with_levels(program.settings.levels(Purpose::Compile)));
    }

    fn block(&mut self, block: &Executed<'_>, findings: &mut Findings) -> ControlFlow<()> {
        self.take(block, None, findings)
    }

    fn end(mut self, end: End, findings: &mut Findings) -> End {
        let held = self.held.take().unwrap_or_default();
        held.items().iter().for_each(|found| findings.add(found.clone()));
        if self.failed.is_none() && !held.has_errors() {
            let ended = self.writer.end(end);
            let _ = self.keep(ended);
        }
        end
    }
}
