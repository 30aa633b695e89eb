//! Which block wrote what is in force last.

use crate::diag::CallKind;
use crate::dict::{Address, AxisLetter, GCode, GEAR_GROUP, GGroup, Lasting, M_GROUPS, MOMENTARY_GROUPS, TOOL_CHANGE};
use crate::run::{AxisSet, Executed, Passed, State};
use crate::syntax::BlockId;
use crate::text::FileId;

/// The values beside G, M, parameters and axes that blocks write, in the order of records, each with the address whose
/// words write it.
const VALUES: [(&str, Option<Address>); 10] = [
    ("feed", Some(Address::F)),
    ("gear", None),
    ("tool", None),
    ("s", Some(Address::S)),
    ("t", Some(Address::T)),
    ("h", Some(Address::H)),
    ("p", Some(Address::P)),
    ("d", Some(Address::D)),
    ("length_correction", Some(Address::Correction)),
    ("dynamic_set", None),
];

/// The places in [`VALUES`] of what words write, by address.
#[expect(clippy::indexing_slicing, reason = "a constant: the compiler computes it")]
const BY_WORD: [Option<usize>; Address::ALL.len()] = {
    let mut places = [None; Address::ALL.len()];
    let mut at = 0;
    while at < VALUES.len() {
        if let Some(address) = VALUES[at].1 {
            places[address as usize] = Some(at);
        }
        at += 1;
    }
    places
};

/// Something that a block writes.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Slot {
    /// A G group.
    G(usize),
    /// An M group.
    M(usize),
    /// A value, by its place in the list of them.
    Value(usize),
    /// A parameter.
    R(u8),
    /// The position of an axis.
    Axis(AxisLetter),
}

const VALUES_AT: usize = 12 + M_GROUPS;
const PARAMETERS_AT: usize = VALUES_AT + VALUES.len();
const PARAMETERS: usize = 96;
const AXES_AT: usize = PARAMETERS_AT + PARAMETERS;
const SLOTS: usize = AXES_AT + AxisLetter::ALL.len();

impl Slot {
    /// As in JSON: `g3`, `m2`, `feed`, `R10`, `X`.
    pub fn name(self) -> String {
        match self {
            Self::G(group) => format!("g{group}"),
            Self::M(group) => format!("m{group}"),
            Self::Value(at) => VALUES.get(at).map_or("", |(name, _)| *name).to_owned(),
            Self::R(index) => format!("R{index}"),
            Self::Axis(letter) => letter.to_string(),
        }
    }

    /// The value of that name.
    pub fn value(name: &str) -> Self {
        Self::Value(VALUES.iter().position(|(value, _)| *value == name).unwrap_or(0))
    }

    /// The value that words of an address write.
    #[inline]
    fn by_word(address: Address) -> Option<Self> {
        BY_WORD.get(address as usize).copied().flatten().map(Self::Value)
    }

    /// Its place among all.
    pub fn index(self) -> usize {
        match self {
            Self::G(group) => group,
            Self::M(group) => 12 + group,
            Self::Value(at) => VALUES_AT + at,
            Self::R(index) => PARAMETERS_AT + usize::from(index),
            Self::Axis(letter) => AXES_AT + letter as usize,
        }
    }

    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> {
        let groups = (0..12).map(Self::G).chain((1..M_GROUPS).map(Self::M));
        let values = (0..VALUES.len()).map(Self::Value);
        let parameters = (0..96).map(Self::R);
        groups.chain(values).chain(parameters).chain(AxisLetter::ALL.map(Self::Axis))
    }
}

/// The block that wrote something.
#[derive(Clone, Copy, Debug)]
struct Writer {
    seq: u64,
    file: FileId,
    block: BlockId,
    call: Option<(CallKind, u32)>,
}

/// The same, for people and for JSON.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Written {
    /// Which executed block.
    pub seq: u64,
    /// Its number.
    pub n: u32,
    /// The index of its file.
    pub file: u32,
    /// The line of its `N`.
    pub line: u32,
    /// The innermost call that it was executed in.
    pub call: Option<(&'static str, u32)>,
}

/// Who wrote what last.
#[derive(Clone, Debug)]
pub(super) struct Writers {
    last: Box<[Option<Writer>; SLOTS]>,
}

impl Default for Writers {
    fn default() -> Self {
        Self { last: Box::new([None; SLOTS]) }
    }
}

impl Writers {
    /// Notes what a block wrote; `before`: what was in force before it; `elsewhere`: the axes that it left elsewhere.
    #[inline]
    pub fn note(&mut self, block: &Executed<'_>, before: &State, elsewhere: AxisSet) {
        let (file, id) = block.at();
        let writer = Writer { seq: block.seq(), file, block: id, call: call(block) };
        for axis in block.motion().into_iter().flat_map(|motion| motion.axes()) {
            self.set(Slot::Axis(axis), writer);
        }
        each_written(block, before, elsewhere, |slot| self.set(slot, writer));
    }

    /// Notes what points wrote.
    pub fn note_points(&mut self, points: &Passed<'_>) {
        let (stretch, call) = (points.stretch(), call(&points.before()));
        let function = points.function().map(|block| (Slot::G(GGroup::G0.index()), block));
        for (slot, block) in points.axes().map(|(axis, block)| (Slot::Axis(axis), block)).chain(function) {
            let seq = points.first_seq() + u64::from(block.0 - stretch.first.0);
            self.set(slot, Writer { seq, file: stretch.file, block, call });
        }
    }

    fn set(&mut self, slot: Slot, writer: Writer) {
        if let Some(last) = self.last.get_mut(slot.index()) {
            *last = Some(writer);
        }
    }

    /// Who wrote each of `slots`, as far as somebody did. `block`: one of the same execution.
    pub fn of(&self, slots: impl Iterator<Item = Slot>, block: &Executed<'_>) -> Vec<(Slot, Written)> {
        let written = |slot: Slot| {
            let writer = self.last.get(slot.index()).copied().flatten()?;
            let file = block.file_of(writer.file)?;
            let written = Written {
                seq: writer.seq,
                n: file.shown_number(writer.block),
                file: block.index_of(writer.file),
                line: block.line_of(file.n_place(writer.block)),
                call: writer.call.map(|(by, l)| (by.name(), l)),
            };
            Some((slot, written))
        };
        slots.filter_map(written).collect()
    }
}

/// Calls `each` with what a block writes besides the axes of its motion, perhaps more than once; `before`: what was in
/// force before it; `elsewhere`: the axes that it left elsewhere.
#[inline]
pub fn each_written(block: &Executed<'_>, before: &State, elsewhere: AxisSet, mut each: impl FnMut(Slot)) {
    // What holds for its block alone is no more in force, and what it hid was written by another.
    let lasting = block.g_written().filter(|code| code.lasting() != Lasting::Block);
    lasting.for_each(|code| each(Slot::G(code.group().index())));
    if !block.moves_on() {
        each_by_words(block, before, elsewhere, each);
    }
}

fn each_by_words(block: &Executed<'_>, before: &State, elsewhere: AxisSet, mut each: impl FnMut(Slot)) {
    let functions = &block.settings().machine.m_functions;
    for &number in block.m_written() {
        each(Slot::M(usize::from(functions.group(number))));
        if number == TOOL_CHANGE {
            each(Slot::value("tool"));
        }
    }
    if block.last() {
        (0..12).map(Slot::G).for_each(&mut each);
        block.m_changed().iter().map(|group| Slot::M(usize::from(*group))).for_each(&mut each);
    }
    block.source_words().iter().filter_map(|word| Slot::by_word(word.address)).for_each(&mut each);
    let after = block.state();
    let ranges = || block.m_written().iter().any(|number| usize::from(functions.group(*number)) == GEAR_GROUP);
    if before.gear_in_force() != after.gear_in_force() || after.gear_in_force().is_some() && ranges() {
        each(Slot::value("gear"));
    }
    let arc = || block.motion().is_some_and(|motion| motion.kind().is_arc());
    let chooses = || block.g_written().any(|code| code == GCode::G23) && block.written(Address::I) && !arc();
    if before.chosen_dynamic_set() != after.chosen_dynamic_set() || chooses() {
        each(Slot::value("dynamic_set"));
    }
    block.params().iter().for_each(|(index, _)| each(Slot::R(*index)));
    if block.has_parameters() {
        let assigned = block.source_words().iter().filter(|word| word.address == Address::R);
        let lost = (0..96).filter(|index| after.is_lost(*index) && !before.is_lost(*index));
        assigned.map(|word| word.target()).chain(lost).for_each(|index| each(Slot::R(index)));
    }
    let stands = block.data().filter(|data| data.g == GCode::G93).map_or(&[][..], |data| data.values);
    let stands = stands.iter().filter_map(|(letter, _)| AxisLetter::from_letter(*letter));
    stands.for_each(|axis| each(Slot::Axis(axis)));
    let axes = &block.settings().machine.axes;
    let left = elsewhere.places().filter_map(|place| axes.get(place));
    left.for_each(|axis| each(Slot::Axis(axis.letter)));
}

/// The innermost call that a block was executed in.
fn call(block: &Executed<'_>) -> Option<(CallKind, u32)> {
    block.calls().last().map(|call| (call.by, call.l))
}

/// Whether an M group holds for one block only.
pub(super) fn is_momentary(group: usize) -> bool {
    MOMENTARY_GROUPS.iter().any(|momentary| usize::from(*momentary) == group)
}
