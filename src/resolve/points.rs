//! Facts about the points of a file together: its blocks with axis words and at most a G00 or G01, nearly all of a long
//! program.

use super::axis_letters::bit;
use crate::dict::Address;

/// The points of a file.
#[derive(Clone, Copy, Debug, Default)]
pub struct Points {
    /// The addresses of their words, a bit for each.
    addresses: u32,
    /// A word of one has the wrong axis or value, or is written twice.
    faulty: bool,
}

impl Points {
    /// Takes note of a point with words of these addresses.
    pub(super) const fn add(&mut self, addresses: u32, is_right: bool) {
        self.addresses |= addresses;
        self.faulty |= !is_right;
    }

    /// Takes note of those of another part of the file.
    pub(super) const fn join(&mut self, other: Self) {
        self.add(other.addresses, !other.faulty);
    }

    /// Whether each of their axis words has an axis of the machine and a value in its range, and none stands twice in
    /// a block.
    pub const fn are_right(self) -> bool {
        !self.faulty
    }

    /// Whether one of them may have a word of that address.
    pub const fn may_have(self, address: Address) -> bool {
        self.addresses & bit(address) != 0
    }
}
