//! The reader of `state`: one pass over the executed blocks, to the place and on to the end.

use std::ops::ControlFlow;

use super::errors::Errors;
use super::follow::{Follow, Lengths, Next, Tally};
use super::found::Found;
use super::place::{Asked, PlaceFault, Search};
use crate::config::Settings;
use crate::diag::Findings;
use crate::run::{End, Executed, Passed, Sink};
use crate::syntax::BlockId;
use crate::text::FileId;

/// Reads the blocks of one execution, for one place.
#[derive(Debug)]
pub struct StateReader {
    search: Search,
    errors: Errors,
    follow: Follow,
    lengths: Lengths,
    /// The place, with what is done before it.
    found: Option<(Box<Found>, Tally)>,
    next: Next,
}

impl StateReader {
    /// For a program that is executed with these settings.
    pub fn new(settings: &Settings, asked: Asked) -> Self {
        Self {
            search: Search::new(asked),
            errors: Errors::default(),
            follow: Follow::new(settings),
            lengths: Lengths::default(),
            found: None,
            next: Next::default(),
        }
    }

    /// What holds at the place, without times.
    ///
    /// # Errors
    /// When there is no such place, or several.
    pub fn found(&self) -> Result<Box<Found>, PlaceFault> {
        let blocks = self.follow.done().blocks;
        if let Some(fault) = self.search.fault(blocks) {
            return Err(fault);
        }
        let Some((found, done)) = &self.found else { return Err(PlaceFault::Beyond { blocks }) };
        let mut found = found.clone();
        found.unknown.retain(|(letter, _)| self.follow.is_moved(*letter));
        found.add_left(*done, self.next, self.follow.done());
        Ok(found)
    }

    /// Whether an error stands before the place: that comes first.
    pub fn has_error_before(&self) -> bool {
        let place = self.found.as_ref().map_or(u64::MAX, |(found, _)| found.seq);
        let after = self.search.asked().after;
        self.errors.first().is_some_and(|first| first < place || after && first == place)
    }

    /// Whether errors were found after the last block, as those of joints are (W0801 to W0804); without a place every
    /// error counts.
    pub fn has_late_error(&self, findings: &Findings) -> bool {
        if self.found.is_some() { self.errors.came_late(findings) } else { findings.has_errors() }
    }

    /// Keeps what holds now, before or behind the block.
    fn keep(&mut self, block: &Executed<'_>, after: bool) {
        self.found = Some((Box::new(self.follow.found(block, after)), self.follow.done()));
    }
}

impl Sink for &mut StateReader {
    type Whole = End;

    fn spares(&self, next: (FileId, BlockId)) -> u64 {
        self.search.spares(next, self.follow.done().blocks)
    }

    fn passed(&mut self, points: &Passed<'_>) {
        let length = self.lengths.of(points);
        if self.found.is_some() {
            self.next.look_at_points(points);
            self.follow.count_points(points, length);
        } else {
            self.follow.pass_over(points, length);
        }
    }

    fn block(&mut self, block: &Executed<'_>, findings: &mut Findings) -> ControlFlow<()> {
        self.errors.look(block, findings);
        let (arrives, after) = (self.search.arrives(block), self.search.asked().after);
        if arrives && !after {
            self.follow.arrive(block);
            self.keep(block, false);
        }
        if self.found.is_some() {
            self.next.look(block, self.follow.done());
            self.follow.count(block);
            return ControlFlow::Continue(());
        }
        self.follow.arrive(block);
        self.follow.pass(block);
        if arrives {
            self.keep(block, true);
        }
        ControlFlow::Continue(())
    }

    fn end(self, end: End, _: &mut Findings) -> End {
        end
    }
}
