//! Where axes stand, block after block.

use super::tally::Tally;
use crate::dict::Micro;

/// Positions of all axes at one time.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Known {
    bits: u16,
    values: [Micro; 9],
}

impl Known {
    pub fn set(&mut self, axis: usize, value: Option<Micro>) {
        if let Some(slot) = self.values.get_mut(axis) {
            *slot = value.unwrap_or_default();
            self.bits = if value.is_some() { self.bits | 1 << axis } else { self.bits & !(1 << axis) };
        }
    }

    pub fn get(&self, axis: usize) -> Option<Micro> {
        self.values.get(axis).copied().filter(|_| self.bits & (1 << axis) != 0)
    }

    /// A bit for each axis that is known.
    pub const fn bits(&self) -> u16 {
        self.bits
    }

    /// All, 0 where one is not known.
    pub const fn values(&self) -> [Micro; 9] {
        self.values
    }

    /// A bit for each axis that is known and did not stand here before.
    pub fn changed_from(&self, before: &Self) -> u16 {
        let mut bits = 0;
        for (axis, (value, old)) in self.values.iter().zip(before.values).enumerate() {
            if *value != old || before.bits & (1 << axis) == 0 {
                bits |= 1 << axis;
            }
        }
        bits & self.bits
    }
}

/// Positions by axis and row.
#[derive(Debug)]
pub(super) struct Positions {
    axes: Vec<Tally>,
    rows: usize,
}

impl Positions {
    pub fn new(axes: usize) -> Self {
        Self { axes: vec![Tally::default(); axes], rows: 0 }
    }

    /// The positions of the next row.
    pub fn push(&mut self, known: &Known) {
        for (axis, tally) in self.axes.iter_mut().enumerate() {
            let value = known.get(axis);
            // An axis that nothing is known of costs nothing.
            if tally.len() > 0 || value.is_some() {
                while tally.len() < self.rows {
                    tally.push(Micro::ZERO);
                }
                tally.push(value.unwrap_or_default());
            }
        }
        self.rows += 1;
    }

    /// The bytes that they take.
    pub fn memory(&self) -> usize {
        self.axes.iter().map(|tally| tally.column().memory()).sum()
    }

    /// Where an axis stands after a row; 0 where it is not known.
    pub fn get(&self, axis: usize, row: usize) -> Micro {
        self.axes.get(axis).and_then(|tally| tally.get(row)).unwrap_or_default()
    }

    /// Of an axis: the values of the rows for which `coded` says so.
    pub fn coded(&self, axis: usize, coded: impl Fn(usize) -> bool) -> Tally {
        let mut found = Tally::default();
        if let Some(tally) = self.axes.get(axis) {
            for row in (0..tally.len()).filter(|row| coded(*row)) {
                found.push(tally.get(row).unwrap_or_default());
            }
        }
        found
    }
}
