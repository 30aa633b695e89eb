//! A column of whole numbers, and how it is packed for the page.
//!
//! A column is written as itself, as its first differences, or as its second ones, whichever is shortest; mostly-zero
//! results as pairs of gap and value. Numbers are zigzag varints, stored by planes: first the lowest seven bits of
//! every number, then the next seven of those that have more, and so on. Deflate finds much more in planes than in
//! numbers side by side. `web/src/data/columns.ts` reads this form.

/// Whole numbers, one a row.
#[derive(Clone, Debug)]
pub(super) enum Column {
    /// So many zeros, and nothing else yet.
    Zeros(usize),
    /// While all fit a byte.
    Tiny(Vec<i8>),
    /// While all fit.
    Narrow(Vec<i32>),
    /// Once one did not.
    Wide(Vec<i64>),
}

/// How the bytes of a packed column are read.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) struct Form {
    /// Numbers in the column.
    pub count: usize,
    /// How often differences were taken: 0, 1, 2.
    pub order: u8,
    /// Whether zeros are left out.
    pub sparse: bool,
    /// Whether 32 bits do not hold each number.
    pub wide: bool,
    /// Bytes of the packed column.
    pub bytes: usize,
}

impl Default for Column {
    fn default() -> Self {
        Self::Zeros(0)
    }
}

impl Column {
    /// Adds a number.
    pub fn push(&mut self, value: i64) {
        let fits = match self {
            Self::Zeros(count) => {
                *count += usize::from(value == 0);
                value == 0
            }
            Self::Tiny(values) => i8::try_from(value).map(|value| values.push(value)).is_ok(),
            Self::Narrow(values) => i32::try_from(value).map(|value| values.push(value)).is_ok(),
            Self::Wide(values) => {
                values.push(value);
                true
            }
        };
        if !fits {
            self.widen(value);
            self.push(value);
        }
    }

    /// Makes room for a number that does not fit.
    #[cold]
    fn widen(&mut self, value: i64) {
        let narrow = i32::try_from(value).is_ok();
        *self = match std::mem::take(self) {
            Self::Zeros(count) if i8::try_from(value).is_ok() => Self::Tiny(vec![0; count]),
            Self::Zeros(count) if narrow => Self::Narrow(vec![0; count]),
            Self::Zeros(count) => Self::Wide(vec![0; count]),
            Self::Tiny(values) if narrow => Self::Narrow(values.into_iter().map(i32::from).collect()),
            Self::Tiny(values) => Self::Wide(values.into_iter().map(i64::from).collect()),
            Self::Narrow(values) => Self::Wide(values.into_iter().map(i64::from).collect()),
            wide @ Self::Wide(_) => wide,
        };
    }

    /// The bytes that it takes.
    pub fn memory(&self) -> usize {
        match self {
            Self::Zeros(_) => 0,
            Self::Tiny(values) => values.capacity(),
            Self::Narrow(values) => 4 * values.capacity(),
            Self::Wide(values) => 8 * values.capacity(),
        }
    }

    /// How many numbers it holds.
    pub fn len(&self) -> usize {
        match self {
            Self::Zeros(count) => *count,
            Self::Tiny(values) => values.len(),
            Self::Narrow(values) => values.len(),
            Self::Wide(values) => values.len(),
        }
    }

    /// The number of a row.
    pub fn get(&self, row: usize) -> Option<i64> {
        match self {
            Self::Zeros(count) => (row < *count).then_some(0),
            Self::Tiny(values) => values.get(row).copied().map(i64::from),
            Self::Narrow(values) => values.get(row).copied().map(i64::from),
            Self::Wide(values) => values.get(row).copied(),
        }
    }

    /// How many bits its numbers have when they are packed: what the shorter of two columns has less of.
    pub fn cost(&self) -> u64 {
        match self {
            Self::Zeros(_) => 0,
            Self::Tiny(values) => shortest(values.iter().copied().map(i64::from)).bits,
            Self::Narrow(values) => shortest(values.iter().copied().map(i64::from)).bits,
            Self::Wide(values) => shortest(values.iter().copied()).bits,
        }
    }

    /// Appends the packed column to `out`.
    pub fn pack(&self, out: &mut Vec<u8>) -> Form {
        match self {
            Self::Zeros(count) => pack(out, *count, false, || std::iter::repeat_n(0, *count)),
            Self::Tiny(values) => pack(out, values.len(), false, || values.iter().copied().map(i64::from)),
            Self::Narrow(values) => pack(out, values.len(), false, || values.iter().copied().map(i64::from)),
            Self::Wide(values) => pack(out, values.len(), true, || values.iter().copied()),
        }
    }
}

fn pack<I: Iterator<Item = i64>>(out: &mut Vec<u8>, count: usize, wide: bool, values: impl Fn() -> I) -> Form {
    let before = out.len();
    let Shortest { order, zeros, .. } = shortest(values());
    let sparse = zeros * 8 >= count * 7;
    let mut differences = Differences::new(order);
    if sparse {
        let (mut gaps, mut kept, mut gap) = (Planes::default(), Planes::default(), 0);
        for value in values().map(|value| differences.next(value)) {
            if value == 0 {
                gap += 1;
            } else {
                gaps.push(gap);
                kept.push(value);
                gap = 0;
            }
        }
        out.extend_from_slice(&u32::try_from(count - zeros).unwrap_or(u32::MAX).to_le_bytes());
        gaps.append_to(out);
        kept.append_to(out);
    } else {
        let mut planes = Planes::default();
        for value in values() {
            planes.push(differences.next(value));
        }
        planes.append_to(out);
    }
    Form { count, order, sparse, wide, bytes: out.len() - before }
}

/// The order of differences with the fewest bits.
#[derive(Clone, Copy, Debug, Default)]
struct Shortest {
    order: u8,
    bits: u64,
    /// How many of the differences are 0.
    zeros: usize,
}

fn shortest(values: impl Iterator<Item = i64>) -> Shortest {
    let mut by_order = [Differences::new(0), Differences::new(1), Differences::new(2)];
    let mut found = [0, 1, 2].map(|order| Shortest { order, ..Shortest::default() });
    for value in values {
        for (differences, found) in by_order.iter_mut().zip(&mut found) {
            let difference = differences.next(value);
            found.bits += u64::from(64 - zigzag(difference).leading_zeros());
            found.zeros += usize::from(difference == 0);
        }
    }
    found.into_iter().min_by_key(|found| (found.bits, found.order)).unwrap_or_default()
}

/// Takes differences of the numbers that it is given one after another.
#[derive(Clone, Copy, Debug)]
struct Differences {
    order: u8,
    last: i64,
    last_difference: i64,
}

impl Differences {
    const fn new(order: u8) -> Self {
        Self { order, last: 0, last_difference: 0 }
    }

    fn next(&mut self, value: i64) -> i64 {
        if self.order == 0 {
            return value;
        }
        let difference = value.wrapping_sub(self.last);
        self.last = value;
        if self.order == 1 {
            return difference;
        }
        let second = difference.wrapping_sub(self.last_difference);
        self.last_difference = difference;
        second
    }
}

const fn zigzag(value: i64) -> u64 {
    ((value << 1) ^ (value >> 63)).cast_unsigned()
}

/// Zigzag varints by planes.
#[derive(Debug, Default)]
struct Planes {
    planes: [Vec<u8>; 10],
}

impl Planes {
    fn push(&mut self, value: i64) {
        let mut rest = zigzag(value);
        for plane in &mut self.planes {
            let low = u8::try_from(rest & 127).unwrap_or_default();
            rest >>= 7;
            plane.push(if rest == 0 { low } else { low | 128 });
            if rest == 0 {
                return;
            }
        }
    }

    fn append_to(&self, out: &mut Vec<u8>) {
        for plane in &self.planes {
            out.extend_from_slice(plane);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn packed(values: &[i64]) -> (Form, Vec<u8>) {
        let mut column = Column::default();
        for value in values {
            column.push(*value);
        }
        let mut out = Vec::new();
        (column.pack(&mut out), out)
    }

    #[test]
    fn even_steps_are_nothing_but_zeros() {
        let values: Vec<i64> = (0..100).map(|row| 5 + 3 * row).collect();
        let (form, bytes) = packed(&values);
        assert_eq!((form.order, form.sparse, form.bytes), (2, true, bytes.len()));
        // Two numbers that are not zero: 5 and 3 - 5.
        assert_eq!(bytes, [2, 0, 0, 0, 0, 0, 10, 3]);
    }

    #[test]
    fn planes_keep_low_bits_together() {
        let (form, bytes) = packed(&[300, -1, 2, 200]);
        assert_eq!((form.order, form.sparse, form.wide), (0, false, false));
        assert_eq!(bytes, [600 % 128 + 128, 1, 4, (400 % 128 + 128), (600 / 128), (400 / 128)].map(|n: i32| n as u8));
    }

    #[test]
    fn numbers_stay_when_a_column_widens() {
        let values = [0, 0, 100, -128, 128, 0, 70_000, -70_000, 1 << 40, 3];
        let mut column = Column::default();
        for (row, value) in values.into_iter().enumerate() {
            column.push(value);
            let held: Vec<i64> = (0..column.len()).filter_map(|row| column.get(row)).collect();
            assert_eq!(held, values[..=row]);
        }
    }

    #[test]
    fn one_long_number_widens_the_column() {
        let (form, _) = packed(&[1, i64::from(i32::MAX) + 1]);
        assert!(form.wide);
    }
}
