//! The one place that decides whether a run over a program is whole.

use super::{Interpreter, Stop};
use crate::diag::Findings;

/// Proof that a program was executed to its M02 or M30, and that nothing that was found is an error in this run. Only
/// `End::of` makes one. No stream has its `end` record without it, `compile` does not succeed without it, and no sink
/// is asked what it makes of the program: what stops early cannot be taken for a whole.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct End {
    m: u8,
    blocks: u64,
}

impl End {
    /// When the program ended, and has no errors.
    pub(crate) fn of(interpreter: &Interpreter, findings: &Findings) -> Option<Self> {
        match interpreter.end() {
            Some(Stop::End(m)) if !findings.has_errors() => Some(Self { m, blocks: interpreter.executed() }),
            Some(Stop::End(_) | Stop::Halted) | None => None,
        }
    }

    /// M02 or M30, by number.
    pub const fn m(self) -> u8 {
        self.m
    }

    /// Blocks executed.
    pub const fn blocks(self) -> u64 {
        self.blocks
    }

    /// `M02`, `M30`.
    pub fn reason(self) -> String {
        format!("M{:02}", self.m)
    }
}
