//! The current block: its words, the modal state in it, and its effect. [`super::Executed`] shows it.

use super::m_functions::MFunctionsOfBlock;
use super::moved::Moving;
use super::travel::Travel;
use super::unknown::Groups;
use super::words::BlockWords;
use crate::dict::{Decimal, GCode, GGroup};
use crate::syntax::BlockId;
use crate::text::FileId;

/// A jump that is taken.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Jump {
    /// The number of the block jumped to.
    pub to: u32,
    /// The counter after lowering; `None` when the jump is not counted.
    pub left: Option<u32>,
}

/// The effect of a block besides changes of the modal state.
#[derive(Clone, Copy, Debug, Default)]
pub(super) enum Effect {
    /// Nothing moves.
    #[default]
    None,
    /// The axes of the travels move.
    Motion(Moving),
    /// The words are data (GRP-4).
    Data(DataFacts),
}

/// The meaning of the words in a block with data.
#[derive(Clone, Copy, Debug)]
pub(super) struct DataFacts {
    pub(super) g: GCode,
    pub(super) origin: Option<GCode>,
    pub(super) d: Option<Decimal>,
}

/// G functions by group, x functions included.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct InForce {
    pub(super) functions: [Option<GCode>; 12],
    /// Groups of which nobody knows the function.
    pub(super) unknown: Groups,
}

impl InForce {
    /// The function of a group.
    #[inline]
    pub(super) fn of(&self, group: GGroup) -> Option<GCode> {
        self.functions.get(group.index()).copied().flatten()
    }
}

/// One block, as execution finds it. One is reused for all blocks.
#[derive(Clone, Debug, Default)]
pub(super) struct Block {
    pub(super) file: FileId,
    pub(super) id: BlockId,
    /// Its words with their values, from before it.
    pub(super) words: BlockWords,
    /// G functions in it.
    pub(super) g: InForce,
    pub(super) m: MFunctionsOfBlock,
    pub(super) effect: Effect,
    /// How its axes move, when they do.
    pub(super) travels: Vec<Travel>,
    /// The words that are data.
    pub(super) values: Vec<(char, Decimal)>,
    /// I, J, K where they are no centre (GRP-8).
    pub(super) centers: Vec<(char, Decimal)>,
    /// Parameters that it wrote, by number; without those whose value is not known.
    pub(super) params: Vec<(u8, Decimal)>,
    pub(super) jump: Option<Jump>,
    /// The macrocycle that it calls and only the machine has (FLW-12).
    pub(super) opaque_call: Option<u32>,
    /// How often it makes its call.
    pub(super) call_count: u32,
    /// Its motion is measured in degrees; of a block of axis words only.
    pub(super) degrees: bool,
    /// It differs from the block before it in place, motion and positions alone.
    pub(super) moves_on: bool,
}

impl Block {
    /// Forgets what the block before it did. What is collected from its words is cleared where that is done.
    pub(super) fn clear(&mut self) {
        self.effect = Effect::None;
        self.values.clear();
        self.centers.clear();
        self.params.clear();
        self.jump = None;
        self.opaque_call = None;
        self.call_count = 1;
        self.moves_on = false;
    }
}
