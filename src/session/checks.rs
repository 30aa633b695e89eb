//! Checks of executed blocks beyond the rules of execution: joints (W0629, W0801 to W0804) and corrections (W0811,
//! W0812).

use std::ops::ControlFlow;

use crate::analysis::equidistant::Equidistant;
use crate::analysis::motion::JointFindings;
use crate::config::{Purpose, Settings};
use crate::diag::{Code, Findings, Severity};
use crate::run::{End, Executed, Sink};

/// The codes that these checks give.
const CODES: [Code; 7] = [Code::W0629, Code::W0801, Code::W0802, Code::W0803, Code::W0804, Code::W0811, Code::W0812];

/// The checks of one execution.
#[derive(Debug)]
pub(super) struct Checks(JointFindings, Equidistant);

impl Checks {
    /// Those that a run has: `check` all that are not allowed. Other commands only when one of them is an error in this
    /// run, so that a program has one exit status in all commands.
    pub fn of(settings: &Settings, purpose: Purpose) -> Option<Box<Self>> {
        let levels = settings.levels(purpose);
        let denied = || CODES.iter().any(|&code| levels.of(code) == Some(Severity::Error));
        if purpose != Purpose::Check && !denied() {
            return None;
        }
        let checks = Self(JointFindings::new(settings), Equidistant::new(settings, false));
        (checks.0.is_wanted() || checks.1.is_wanted()).then(|| Box::new(checks))
    }

    /// The next executed block.
    pub fn block(&mut self, block: &Executed<'_>, findings: &mut Findings) {
        // Neither of them gives up.
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = self.0.block(block, findings);
        self.1.read(block, findings);
    }

    /// The program ended, and has no errors so far.
    pub fn end(self, end: End, findings: &mut Findings) {
        self.0.end(end, findings);
        Sink::end(self.1, end, findings);
    }
}
