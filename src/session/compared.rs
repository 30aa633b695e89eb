//! What one of two programs does that are compared.

use std::path::Path;

use super::{Run, Session};
use crate::analysis::compare::{Side, StepReader, Steps};
use crate::analysis::state::AtTime;
use crate::config::Purpose;
use crate::run::End;

impl Session<'_> {
    /// Executes the program at `path`, which the user calls `name`, as far as possible, for a comparison. `parameters`:
    /// also what is assigned to parameters, and jumps.
    pub fn steps(&self, path: &Path, name: &str, parameters: bool) -> (Run<End>, Side, Steps) {
        let mut reader = StepReader::new(parameters);
        let mut clock = AtTime::new(self.settings, f64::INFINITY);
        let run = self.watch(path, name, Purpose::Report, &mut (&mut reader, &mut clock));
        let steps = reader.finish();
        let (blocks, path, time_s) = (steps.blocks, steps.path, clock.found().err());
        let side = Side { name: name.to_owned(), blocks, path, time_s, whole: run.whole.is_some() };
        (run, side, steps)
    }
}
