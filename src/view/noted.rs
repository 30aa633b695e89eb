//! What the panel of the page tells beside the records, as `cnc872c state` has it: what each block wrote, and why
//! positions and parameters are not known.

use serde_json::{Map, Value};

use crate::analysis::state::{Axes, Before, Slot, Unknown, each_written};
use crate::config::Settings;
use crate::dict::AxisLetter;
use crate::run::{AxisSet, Executed, State};
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

    /// Adds what the block did to a key: equal bytes, equal fields of [`Self::fields`].
    pub fn add_key(&self, block: &Executed<'_>, key: &mut Vec<u8>) {
        each_written(block, self.before.state(), self.elsewhere, |slot| {
            key.extend(small(slot.index()).to_le_bytes());
        });
        key.push(u8::MAX);
        for parameters in self.unknown_parameters(block) {
            key.extend(parameters);
            key.push(u8::MAX);
        }
    }

    /// What it did, where that was something: `written` (as in `state`, besides the axes of its motion), parameters
    /// whose value was `lost`, and those that were `read` from the machine's table.
    pub fn fields(&self, block: &Executed<'_>) -> Option<Value> {
        let mut written = Vec::new();
        each_written(block, self.before.state(), self.elsewhere, |slot| {
            if !written.contains(&slot) {
                written.push(slot);
            }
        });
        let [lost, read] = self.unknown_parameters(block).map(|all| all.map(Slot::R).collect::<Vec<_>>());
        let named = |slots: Vec<Slot>| slots.into_iter().map(|slot| Value::from(slot.name())).collect::<Value>();
        let fields = [("written", written), ("lost", lost), ("read", read)];
        let fields: Map<String, Value> = fields
            .into_iter()
            .filter(|(_, slots)| !slots.is_empty())
            .map(|(name, slots)| (name.to_owned(), named(slots)))
            .collect();
        (!fields.is_empty()).then_some(Value::Object(fields))
    }

    /// The parameters that are lost since the block, and those that are read from the machine since then.
    fn unknown_parameters<'a>(&'a self, block: &'a Executed<'_>) -> [impl Iterator<Item = u8> + 'a; 2] {
        let (before, after) = (self.before.state(), block.state());
        let may = block.has_parameters();
        let since = move |is: fn(&State, u8) -> bool| {
            (0..96).filter(move |index| may && is(after, *index) && !is(before, *index))
        };
        [since(State::is_lost), since(State::is_read_from_machine)]
    }

    /// Follows the block.
    pub fn pass(&mut self, block: &Executed<'_>) {
        self.before.pass(block);
    }
}
