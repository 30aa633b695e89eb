//! What the panel of the page tells beside the records, as `cnc872c state --after` has it: what each block wrote, and
//! why positions are not known.

use crate::analysis::state::{Axes, Before, Slot, Unknown, each_written};
use crate::config::Settings;
use crate::dict::AxisLetter;
use crate::run::{AxisSet, Executed};
use crate::sure::small;

/// Follows an execution: [`Self::arrive`] at a block, ask, then [`Self::pass`] it.
#[derive(Debug)]
pub(super) struct Noter {
    before: Before,
    axes: Axes,
    /// The axes that the block left elsewhere.
    elsewhere: AxisSet,
}

impl Noter {
    /// Before the first block.
    pub fn new(settings: &Settings) -> Self {
        Self { before: Before::new(settings), axes: Axes::new(settings), elsewhere: AxisSet::default() }
    }

    /// Comes to the next block.
    pub fn arrive(&mut self, block: &Executed<'_>) {
        self.before.arrive(block);
        self.elsewhere = self.before.elsewhere(block);
        self.axes.pass(block, self.elsewhere);
    }

    /// Why an axis is not known after the block, if it is not.
    pub fn why(&self, letter: AxisLetter) -> Unknown {
        self.axes.why(letter)
    }

    /// Adds what the block wrote to a key.
    pub fn add_key(&self, block: &Executed<'_>, key: &mut Vec<u8>) {
        each_written(block, self.before.state(), self.elsewhere, |slot| {
            key.extend(small(slot.index()).to_le_bytes());
        });
    }

    /// What it wrote besides the positions of the axes of its motion, as `state` names it.
    pub fn written(&self, block: &Executed<'_>) -> Vec<String> {
        let mut written: Vec<Slot> = Vec::new();
        each_written(block, self.before.state(), self.elsewhere, |slot| {
            if !written.contains(&slot) {
                written.push(slot);
            }
        });
        written.into_iter().map(Slot::name).collect()
    }

    /// Follows the block.
    pub fn pass(&mut self, block: &Executed<'_>) {
        self.before.pass(block);
    }
}
