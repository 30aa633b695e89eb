//! Where execution meets the first error.

use std::collections::BTreeSet;

use crate::diag::{Code, Findings, Severity};
use crate::run::Executed;
use crate::syntax::BlockId;
use crate::text::FileId;

/// Notes the first executed block that has an error.
#[derive(Debug, Default)]
pub(super) struct Errors {
    /// Errors after the last block.
    count: usize,
    known: usize,
    blocks: BTreeSet<(FileId, BlockId)>,
    first: Option<u64>,
}

impl Errors {
    /// The first executed block with an error.
    pub const fn first(&self) -> Option<u64> {
        self.first
    }

    /// Whether errors were added after the last block, beside that of the limit: that is met behind every block.
    pub fn came_late(&self, findings: &Findings) -> bool {
        let limit = usize::from(findings.has(Code::E0410));
        findings.error_count() > self.count + limit
    }

    /// Looks at an executed block, after what was found in it.
    #[inline]
    pub fn look(&mut self, block: &Executed<'_>, findings: &Findings) {
        if findings.has_errors() {
            self.count = findings.error_count();
            if self.first.is_none() {
                self.find(block, findings);
            }
        }
    }

    #[cold]
    fn find(&mut self, block: &Executed<'_>, findings: &Findings) {
        let count = findings.error_count();
        if count > self.known {
            // What this block was executed with is its own, and so is what is found nowhere in particular.
            let mut elsewhere = self.known > 0 || block.seq() > 0;
            self.blocks.clear();
            let is_error = |code| findings.levels().of(code) == Some(Severity::Error);
            let mut kept = 0;
            for found in findings.items().iter().filter(|found| is_error(found.code())) {
                kept += 1;
                match block.file_of(found.at.file).and_then(|file| file.block_at(found.at.span.start)) {
                    Some(id) => {
                        self.blocks.insert((found.at.file, id));
                    }
                    None => elsewhere = true,
                }
            }
            if elsewhere || kept < count {
                self.first = Some(block.seq());
            }
            self.known = count;
        }
        if self.blocks.contains(&block.at()) {
            self.first = self.first.or(Some(block.seq()));
        }
    }
}
