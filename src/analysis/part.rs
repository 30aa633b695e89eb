//! A part of what a program executes.

/// Which executed blocks are written.
#[derive(Clone, Copy, Debug, Default)]
pub struct Part {
    /// First `seq`.
    pub from: u64,
    /// Most blocks; all when `None`.
    pub limit: Option<u64>,
}

impl Part {
    pub(crate) const fn contains(self, seq: u64) -> bool {
        seq >= self.from
            && match self.limit {
                Some(limit) => seq - self.from < limit,
                None => true,
            }
    }
}
