//! What rows have in common about their motion and the axes that are known.

use serde_json::{Map, Value};

use crate::analysis::state::Unknown;
use crate::dict::AxisLetter;
use crate::run::{Missing, MotionType};

/// The unit of a motion's length.
#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
pub(super) enum LengthUnit {
    Mm,
    Deg,
}

/// The axes of an arc whose centre is known, first-named first, by their places in the machine.
#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
pub(super) struct ArcAxes {
    pub first: usize,
    pub second: usize,
}

/// Equal keys, equal shapes. Axes are bits.
#[derive(Clone, Copy, Debug, Default, Eq, Hash, PartialEq)]
pub(super) struct ShapeKey {
    pub kind: Option<MotionType>,
    /// Those that move.
    pub axes: u16,
    /// Those of them whose start is known.
    pub started: u16,
    /// Those that make the length.
    pub measured: u16,
    /// Those whose position is known after the block.
    pub known: u16,
    /// Those whose position is in the column of positions.
    pub coded: u16,
    /// Why axes are not known behind the block.
    pub why: [Unknown; AxisLetter::ALL.len()],
    pub length: Option<LengthUnit>,
    pub missing: Option<Missing>,
    pub plane: Option<(usize, usize)>,
    pub arc: Option<ArcAxes>,
    pub spindle: Option<AxisLetter>,
    /// The block moves where nobody knows: a fixed cycle that is not mapped, a macrocycle of the machine.
    pub opaque: bool,
    /// The motion starts where the tool does not stand: behind a change of origin (MOT-8).
    pub stale: bool,
}

impl ShapeKey {
    /// As the header of a page has it; `motion` is the motion of the record without its numbers.
    pub fn json(&self, letters: &[AxisLetter], motion: Map<String, Value>) -> Value {
        let named = |bits: u16| -> String {
            let among = letters.iter().enumerate().filter(|(axis, _)| bits & (1 << axis) != 0);
            among.map(|(_, letter)| letter.letter()).collect()
        };
        let letter = |axis: usize| letters.get(axis).map(|letter| letter.letter());
        let mut shape = Map::new();
        for (name, bits) in [("k", self.known), ("c", self.coded), ("s", self.started), ("a", self.measured)] {
            if bits != 0 {
                shape.insert(name.to_owned(), Value::String(named(bits)));
            }
        }
        let unknown = letters.iter().zip(self.why).filter(|(_, why)| *why != Unknown::default());
        let unknown: Map<String, Value> =
            unknown.map(|(letter, why)| (letter.to_string(), Value::from(why.name()))).collect();
        if !unknown.is_empty() {
            shape.insert("w".to_owned(), Value::Object(unknown));
        }
        if self.kind.is_some() {
            shape.insert("m".to_owned(), Value::Object(motion));
        }
        if let Some(unit) = self.length {
            let unit = match unit {
                LengthUnit::Mm => "mm",
                LengthUnit::Deg => "deg",
            };
            shape.insert("l".to_owned(), Value::from(unit));
        }
        if let Some(ArcAxes { first, second }) = self.arc {
            let axes: String = letter(first).into_iter().chain(letter(second)).collect();
            shape.insert("r".to_owned(), Value::String(axes));
        }
        for (name, holds) in [("u", self.opaque), ("o", self.stale)] {
            if holds {
                shape.insert(name.to_owned(), Value::Bool(true));
            }
        }
        Value::Object(shape)
    }
}
