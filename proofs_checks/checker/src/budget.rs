//! A bound on the work for one file.

use num_bigint::BigInt;

/// Products of 64-bit words, about a few seconds of them.
pub const MOST_WORK: u64 = 1 << 31;

/// What is left of the bound.
pub struct Budget {
    left: u64,
}

impl Budget {
    pub fn new(work: u64) -> Self {
        Budget { left: work }
    }

    /// Takes the cost of so many products of numbers of so many bits; false where it is not left.
    #[must_use]
    pub fn covers(&mut self, products: usize, bits: u64, other_bits: u64) -> bool {
        let words = |bits: u64| bits / 64 + 1;
        let each = words(bits).saturating_mul(words(other_bits)).saturating_add(16);
        match self.left.checked_sub(each.saturating_mul(products as u64)) {
            Some(left) => {
                self.left = left;
                true
            }
            None => false,
        }
    }
}

/// The length of the longest number.
pub fn bits<'a>(numbers: impl IntoIterator<Item = &'a BigInt>) -> u64 {
    numbers.into_iter().map(BigInt::bits).max().unwrap_or(0)
}
