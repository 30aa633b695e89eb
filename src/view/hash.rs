//! Numbers that stand for rows in the search for equal ones.

/// 128 bits that differ for different numbers; the same on every machine.
pub(super) struct Hash(u64, u64);

impl Hash {
    pub const fn new() -> Self {
        Self(0x9E37_79B9_7F4A_7C15, 0xC2B2_AE3D_27D4_EB4F)
    }

    pub fn add(&mut self, value: u64) {
        let fold = |a: u64, b: u64| {
            let product = u128::from(a) * u128::from(b);
            (product ^ product >> 64) as u64
        };
        self.0 = fold(self.0 ^ value, 0xA076_1D64_78BD_642F).rotate_left(23) ^ self.1;
        self.1 = fold(self.1 ^ value, 0xE703_7ED1_A0B4_28DB).wrapping_add(self.0);
    }

    pub fn value(&self) -> u128 {
        u128::from(self.0) << 64 | u128::from(self.1)
    }
}
