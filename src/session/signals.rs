//! Signals of the PLC together with the times of blocks.

use std::ops::ControlFlow;

use super::TimedSink;
use crate::analysis::motion::BlockTimes;
use crate::analysis::plc::{Reader, StepTimes};
use crate::diag::Findings;
use crate::run::{End, Executed, Program, Sink};

/// Reads the signals of blocks with their times.
pub struct TimedSignals<'w>(pub Reader<'w>);

impl std::fmt::Debug for TimedSignals<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TimedSignals").finish_non_exhaustive()
    }
}

impl TimedSink for TimedSignals<'_> {
    type Whole = End;

    fn begin(&mut self, program: &Program<'_>) {
        Sink::begin(&mut self.0, program);
    }

    fn block(&mut self, block: &Executed<'_>, times: &BlockTimes, findings: &mut Findings) -> ControlFlow<()> {
        let stretch = times.motion.as_ref().and_then(|motion| motion.stretch.or(motion.joined_in));
        let stretch = stretch.filter(|stretch| stretch.continued);
        let times = StepTimes {
            start_s: times.start_s,
            duration_s: times.duration_s,
            in_stretch: stretch.is_some(),
            time_dist_s: stretch.and_then(|stretch| stretch.time_dist_s),
        };
        self.0.timed(block, times, findings)
    }

    fn end(self, end: End, findings: &mut Findings) -> End {
        Sink::end(self.0, end, findings)
    }
}
