//! Call frames and the counters of jumps (FLW-1…FLW-4).

use std::collections::BTreeMap;

use crate::diag::CallKind;
use crate::dict::GCode;
use crate::resolve::{Unit, UnitId};
use crate::syntax::BlockId;
use crate::text::{FileId, Location};

/// The call that a frame executes.
#[derive(Clone, Copy, Debug)]
pub(super) struct CallInfo {
    pub(super) by: CallKind,
    pub(super) l: u32,
    /// Of the calling block.
    pub(super) file: FileId,
    pub(super) n: u32,
    pub(super) at: Location,
    /// From 1.
    pub(super) pass: u32,
    pub(super) of: u32,
}

/// A counter of a jump block: unarmed ones are not kept (FLW-4).
#[derive(Clone, Copy, Debug)]
pub(super) struct Counter {
    pub(super) left: u32,
    pub(super) of: u32,
}

/// One execution of a unit.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    pub(super) id: UnitId,
    pub(super) unit: Unit,
    /// The next block.
    pub(super) next: BlockId,
    /// `None`: the main program.
    pub(super) call: Option<CallInfo>,
    pub(super) counters: BTreeMap<BlockId, Counter>,
    /// The fixed cycle that is in force again after this frame (GRP-6).
    pub(super) suspended_cycle: Option<GCode>,
    /// The block that made the open call also holds G70: the unit ends when the call returns.
    pub(super) returns: bool,
}

impl Frame {
    pub(super) fn new(id: UnitId, unit: Unit, call: Option<CallInfo>) -> Self {
        Self { id, unit, next: unit.first, call, counters: BTreeMap::new(), suspended_cycle: None, returns: false }
    }

    /// Begins the next pass of the call, if there is one: a fresh execution, with fresh counters.
    pub(super) fn next_pass(&mut self) -> bool {
        match &mut self.call {
            Some(call) if call.pass < call.of => {
                call.pass += 1;
                self.next = self.unit.first;
                self.counters.clear();
                true
            }
            Some(_) | None => false,
        }
    }

    /// An arrival at the counter of `block`: whether the jump is taken, and what is left (FLW-4). `count` is asked when
    /// the counter is unarmed.
    pub(super) fn arrive(&mut self, block: BlockId, count: impl FnOnce() -> u32) -> Option<u32> {
        let counter = self.counters.entry(block).or_insert_with(|| {
            let of = count();
            Counter { left: of, of }
        });
        if counter.left == 0 {
            self.counters.remove(&block);
            return None;
        }
        counter.left -= 1;
        Some(counter.left)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::resolve::UnitKind;

    /// FLW-4: k jumps, then disarmed; armed afresh at the next arrival.
    #[test]
    fn counters() {
        let unit = Unit {
            kind: UnitKind::Main,
            file: FileId(0),
            first: BlockId(0),
            end: BlockId(3),
            entry: Location::default(),
        };
        let mut frame = Frame::new(UnitId(0), unit, None);
        let block = BlockId(2);
        for _ in 0..2 {
            assert_eq!(frame.arrive(block, || 2), Some(1));
            assert_eq!(frame.arrive(block, || 9), Some(0));
            assert_eq!(frame.arrive(block, || 9), None);
        }
    }
}
