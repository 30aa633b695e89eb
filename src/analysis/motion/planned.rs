//! The plan of a whole program, made on another thread.

use super::model::Model;
use super::planner::{Listener, Planner};
use super::read::StepReader;
use super::step::Step;
use crate::config::Settings;
use crate::parallel::Fold;
use crate::run::Executed;

/// Plans the motions of a program for a listener.
#[derive(Debug)]
pub struct Planned<L> {
    reader: StepReader,
    planned: Fold<Step, (Planner, L)>,
}

impl<L: Listener + Clone + Send + 'static> Planned<L> {
    /// For a program that is executed with these settings.
    pub fn new(settings: &Settings, listener: L) -> Self {
        let planner = (Planner::new(Model::of(settings), false), listener);
        let planned = Fold::new("planner", planner, |(planner, listener), step| planner.push(step, listener));
        Self { reader: StepReader::new(settings), planned }
    }

    /// The next executed block.
    #[inline]
    pub fn push(&mut self, block: &Executed<'_>) {
        self.planned.push(self.reader.read(block));
    }

    /// The listener, when all blocks were pushed.
    pub fn finish(self) -> L {
        let (mut planner, mut listener) = self.planned.finish();
        planner.finish(&mut listener);
        listener
    }
}
