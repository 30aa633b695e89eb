//! Blocks as the sheet names them.

use std::fmt::{self, Display};

use crate::run::Executed;

/// A block: macrocycles have block numbers of their own.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct BlockName {
    /// Its number.
    pub n: u32,
    /// The macrocycle that it belongs to.
    pub l: Option<u32>,
}

impl BlockName {
    /// The name of an executed block.
    pub(super) fn of(block: &Executed<'_>) -> Self {
        let l = block.calls().filter(|call| call.by.is_macrocycle()).last().map(|call| call.l);
        Self { n: block.n(), l }
    }
}

impl Display for BlockName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.l {
            Some(l) => write!(f, "N{} (L{l})", self.n),
            None => write!(f, "N{}", self.n),
        }
    }
}
