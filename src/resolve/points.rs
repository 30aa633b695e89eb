//! What is known of the points of a file together: its blocks of axis words and no others, nearly all of a long program.

use super::letters::bit;
use crate::dict::Address;

/// The points of a file.
#[derive(Clone, Copy, Debug, Default)]
pub struct Points {
    /// The addresses of their words, a bit for each.
    addresses: u32,
    /// Something is wrong with a word of one: its axis, its value, or that it stands there twice.
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

    /// Whether each of their words has an axis of the machine and a value in its range, and none stands twice in a block.
    pub const fn are_right(self) -> bool {
        !self.faulty
    }

    /// Whether one of them may have a word of that address.
    pub const fn may_have(self, address: Address) -> bool {
        self.addresses & bit(address) != 0
    }
}
