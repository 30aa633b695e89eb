//! What the look at the blocks of a file gives besides findings.

use super::points::Points;
use crate::diag::Diagnostic;

/// What the look at blocks gave besides findings.
#[derive(Default)]
pub(super) struct Judged {
    /// Where words begin whose values are not what their addresses take.
    pub(super) refused: Vec<u32>,
    /// Control words whose operation is not configured, by its code: each code is reported once for a program (PAR-9).
    pub(super) operations: Vec<(i64, Diagnostic)>,
    /// M functions without a meaning on this machine, by number: each is reported once for a program (TEC-8).
    pub(super) meaningless: Vec<(u8, Diagnostic)>,
    /// What is known of the points.
    pub(super) points: Points,
}

impl Judged {
    /// Takes what the look at the blocks behind gave.
    pub(super) fn append(&mut self, other: Self) {
        self.refused.extend(other.refused);
        self.operations.extend(other.operations);
        self.meaningless.extend(other.meaningless);
        self.points.join(other.points);
    }
}
