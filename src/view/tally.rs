//! A column of millimetres or degrees, in as coarse parts of one as all its values allow.

use super::column::Column;
use crate::dict::Micro;

/// Parts of a millimetre that are tried, coarsest first, with the millionths in one.
const PARTS: [(u32, i64); 3] = [(1000, 1000), (10_000, 100), (1_000_000, 1)];

/// Values in whole parts of a millimetre or degree.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    /// Index in [`PARTS`].
    part: usize,
    column: Column,
}

impl Tally {
    fn millionths(&self) -> i64 {
        PARTS.get(self.part).map_or(1, |(_, millionths)| *millionths)
    }

    /// How many parts make a millimetre or degree.
    pub fn per(&self) -> u32 {
        PARTS.get(self.part).map_or(1, |(per, _)| *per)
    }

    pub fn push(&mut self, value: Micro) {
        let value = value.millionths();
        loop {
            if let Some(parts) = self.parts(value) {
                return self.column.push(parts);
            }
            self.refine();
        }
    }

    /// So many millionths as parts; `None`: finer ones are needed.
    fn parts(&self, value: i64) -> Option<i64> {
        // Dividing by a constant is ten times as fast, and most columns count thousandths.
        if self.part == 0 {
            return (value % 1000 == 0).then_some(value / 1000);
        }
        let millionths = self.millionths();
        (value % millionths == 0).then(|| value / millionths)
    }

    /// Counts in the next finer parts.
    fn refine(&mut self) {
        let before = self.millionths();
        self.part += 1;
        let factor = before / self.millionths();
        let mut finer = Column::default();
        for row in 0..self.column.len() {
            finer.push(self.column.get(row).unwrap_or_default() * factor);
        }
        self.column = finer;
    }

    pub fn len(&self) -> usize {
        self.column.len()
    }

    pub fn get(&self, row: usize) -> Option<Micro> {
        Some(Micro::from_millionths(self.column.get(row)? * self.millionths()))
    }

    pub const fn column(&self) -> &Column {
        &self.column
    }
}

/// Two columns in the same parts of a millimetre.
pub(super) fn alike(first: &Tally, second: &Tally) -> [Tally; 2] {
    let mut pair = [first.clone(), second.clone()];
    let part = first.part.max(second.part);
    for tally in &mut pair {
        while tally.part < part {
            tally.refine();
        }
    }
    pair
}
