//! Parts of records that many blocks have in common: each is kept once, as JSON.

use std::collections::HashMap;
use std::hash::Hash;

use serde_json::{Map, Value};

use crate::dict::{Address, Decimal, GCode, GGroup};
use crate::run::{Executed, FeedUnit};
use crate::sure::small;

/// Fields that the page keeps elsewhere, or works out.
const ELSEWHERE: [&str; 11] =
    ["kind", "seq", "n", "file", "line", "column", "calls", "first_block", "last_block", "position", "feed"];

/// Fields that belong to what the block does, not to what is in force.
const DOES: [&str; 21] = [
    "skippable",
    "g_set",
    "m_set",
    "m_changed",
    "m_at_stop",
    "break_cont",
    "break_cont_end",
    "change_pos",
    "t_set",
    "h_set",
    "p_set",
    "d_set",
    "s_set",
    "f_set",
    "dwell_s",
    "stop",
    "cond_stop",
    "opaque_call",
    "data",
    "words",
    "params",
];

/// Different values, each once, in the order in which they came.
#[derive(Clone, Debug)]
pub(super) struct Interned<K> {
    known: HashMap<K, u32>,
    last: Option<(K, u32)>,
    values: Vec<Value>,
}

impl<K> Default for Interned<K> {
    fn default() -> Self {
        Self { known: HashMap::new(), last: None, values: Vec::new() }
    }
}

impl<K: Clone + Eq + Hash> Interned<K> {
    /// The index of a value by its key; `make` gives the value when the key is new.
    pub fn get(&mut self, key: K, make: impl FnOnce() -> Value) -> u32 {
        if let Some((_, index)) = self.last.as_ref().filter(|(last, _)| *last == key) {
            return *index;
        }
        let next = small(self.values.len());
        let index = *self.known.entry(key.clone()).or_insert_with(|| {
            self.values.push(make());
            next
        });
        self.last = Some((key, index));
        index
    }

    pub fn len(&self) -> usize {
        self.values.len()
    }

    pub fn values(&self) -> &[Value] {
        &self.values
    }
}

/// All that is in force in a block but positions and F: equal keys, equal JSON.
#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
pub(super) struct StateKey {
    g: [Option<GCode>; 12],
    /// The functions in force behind the block: without those for it alone, and reset where the program ends.
    held: [Option<GCode>; 12],
    m: [Option<u8>; 15],
    gear: Option<u8>,
    unit: Option<(FeedUnit, bool)>,
    words: [Option<Decimal>; 6],
    length_correction: Option<u16>,
    dynamic_set: Option<u8>,
}

impl StateKey {
    pub fn of(block: &Executed<'_>) -> Self {
        let machine = &block.settings().machine;
        let held =
            if block.last() { machine.power_up } else { GGroup::ALL.map(|group| block.state().g_in_force(group)) };
        let mut m = [None; 15];
        for (group, slot) in m.iter_mut().enumerate() {
            *slot = block.m(group);
        }
        Self {
            g: GGroup::ALL.map(|group| block.g(group)),
            held,
            m,
            gear: block.gear(),
            unit: block.feed().map(|feed| (feed.unit, feed.hundredth)),
            words: [block.s(), block.t(), block.h(), block.p(), block.d(), block.tool()],
            length_correction: block.length_correction(),
            dynamic_set: block.dynamic_set(),
        }
    }

    /// The G functions in force behind the block, by group, where the record does not list them.
    pub fn held(&self) -> Option<Value> {
        (self.held != self.g).then(|| self.held.iter().map(|code| code.map(|code| code.number())).collect())
    }

    /// Whether F counts hundredths (M37), where it counts per minute.
    pub fn fed(&self) -> Option<bool> {
        let (unit, hundredth) = self.unit?;
        matches!(unit, FeedUnit::MmPerMinute | FeedUnit::DegPerMinute).then_some(hundredth)
    }
}

/// Adds what a block does, as far as its functions and words tell, to a key: equal bytes, equal fields of [`DOES`].
/// Gives false where its values count.
pub(super) fn add_words(block: &Executed<'_>, key: &mut Vec<u8>) -> bool {
    let valued = block.dwell().is_some()
        || block.m_at_stop().is_some()
        || block.opaque_call().is_some()
        || block.jump().is_some()
        || block.data().is_some()
        || !block.words().is_empty();
    if valued {
        return false;
    }
    let marks = [
        block.skippable(),
        block.break_cont(),
        block.break_cont_end(),
        block.change_pos(),
        block.stop(),
        block.cond_stop(),
    ];
    let addresses = [Address::F, Address::S, Address::T, Address::H, Address::P, Address::D];
    key.extend(marks.into_iter().chain(addresses.map(|address| block.written(address))).map(u8::from));
    key.extend(block.g_written().map(|code| code.number()));
    key.push(u8::MAX);
    for list in [block.m_written(), block.m_changed()] {
        key.extend(small(list.len()).to_le_bytes());
        key.extend(list);
    }
    key.extend(block.params().iter().map(|(index, _)| *index));
    key.push(u8::MAX);
    true
}

/// The parts of a record.
pub(super) struct Parts {
    /// The modal state.
    pub state: Map<String, Value>,
    /// The effect of the block, apart from its motion.
    pub does: Map<String, Value>,
    /// Its motion, without what the page works out.
    pub motion: Map<String, Value>,
}

/// Takes the JSON of a record apart.
pub(super) fn parts(json: &[u8]) -> Parts {
    let record: Map<String, Value> = serde_json::from_slice(json).unwrap_or_default();
    let mut parts = Parts { state: Map::new(), does: Map::new(), motion: Map::new() };
    for (name, value) in record {
        match (name.as_str(), value) {
            (name, _) if ELSEWHERE.contains(&name) => {}
            ("motion", Value::Object(motion)) => parts.motion = motion,
            ("jump", Value::Object(mut jump)) => {
                jump.remove("left");
                parts.does.insert(name, Value::Object(jump));
            }
            // They stand in the text.
            ("comments", _) => {}
            (does, value) if DOES.contains(&does) => drop(parts.does.insert(name, value)),
            (_, value) => drop(parts.state.insert(name, value)),
        }
    }
    parts
}
