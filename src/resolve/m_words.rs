//! M functions that the machine does not have.

use super::blocks::BlockChecker;
use crate::diag::{Diagnostic, Finding};
use crate::dict::{FEED_FUNCTIONS, ORIENTED_STOP};
use crate::syntax::Word;

impl BlockChecker<'_> {
    /// M19 on a machine without it (MFN-10), and functions that mean nothing on this machine (TEC-8).
    pub(super) fn check_m_meaning(&mut self, number: u8, word: Word) {
        let machine = &self.settings.machine;
        if number == ORIENTED_STOP && !machine.oriented_stop {
            let finding = Finding::OrientedStopUnavailable {};
            self.findings.add(Diagnostic::new(finding, self.file.word_place(word)));
        }
        if machine.m_functions.is_meaningless(number) && self.meaningless.iter().all(|(m, _)| *m != number) {
            let feed = FEED_FUNCTIONS.contains(&number);
            let finding = Finding::FunctionWithoutMeaning { m: number, feed };
            self.meaningless.push((number, Diagnostic::new(finding, self.file.word_place(word))));
        }
    }
}
