//! Whole matrices of non-negative integers, digit by digit: the plane of all lowest digits first, the plane of all highest last.

use super::digit_product::{DIGIT_BITS, Shape};
use arithmetic::{Cancelled, Progress};
use num_bigint::BigUint;

/// Digit `l` of entry `(i, j)` is `planes[(l rows + i) cols + j]`.
#[derive(Debug, Clone)]
pub(super) struct DigitMatrix {
    pub rows: usize,
    pub cols: usize,
    planes: Vec<u32>,
}

impl DigitMatrix {
    pub fn from_entries(rows: usize, cols: usize, entries: &[BigUint]) -> Self {
        let bits = entries.iter().map(BigUint::bits).max().unwrap_or(0);
        let count = (bits.div_ceil(u64::from(DIGIT_BITS)) as usize).max(1);
        let size = rows * cols;
        let mut planes = vec![0; count * size];
        for (at, entry) in entries.iter().enumerate() {
            let mut words = entry.iter_u32_digits();
            let (mut held, mut bits) = (0u64, 0);
            for plane in planes.chunks_exact_mut(size) {
                if bits < DIGIT_BITS {
                    held |= u64::from(words.next().unwrap_or(0)) << bits;
                    bits += u32::BITS;
                }
                plane[at] = held as u32 & ((1 << DIGIT_BITS) - 1);
                held >>= DIGIT_BITS;
                bits -= DIGIT_BITS;
            }
        }
        DigitMatrix { rows, cols, planes }
    }

    fn size(&self) -> usize {
        self.rows * self.cols
    }

    pub fn entries(&self) -> impl Iterator<Item = BigUint> + '_ {
        let (len, limbs) = self.limbs();
        (0..self.size()).map(move |at| to_biguint(&limbs[at * len..][..len]))
    }

    pub fn is_zero(&self, i: usize, j: usize) -> bool {
        self.planes.iter().skip(i * self.cols + j).step_by(self.size()).all(|&digit| digit == 0)
    }

    /// `self * right`. The cost is driven by order³ x digits².
    pub fn times(&self, right: &Self, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let (rows, cols) = (self.rows, right.cols);
        let mut planes = Shape { rows, inner: self.cols, cols }.product(&self.planes, &right.planes, progress)?;
        // Leading zeros that all entries share are dropped.
        let used = planes.iter().rposition(|&digit| digit != 0).map_or(1, |at| at / (rows * cols) + 1);
        planes.truncate(used * rows * cols);
        Ok(DigitMatrix { rows, cols, planes })
    }

    /// How many limbs of 64 bits each entry has, and those of all entries, one after the other.
    fn limbs(&self) -> (usize, Vec<u64>) {
        let (size, bits) = (self.size(), DIGIT_BITS as usize);
        let len = (self.planes.len() / size * bits).div_ceil(64);
        let mut limbs = vec![0; size * len];
        for (l, plane) in self.planes.chunks_exact(size).enumerate() {
            let (limb, shift) = (l * bits / 64, l * bits % 64);
            for (&digit, entry) in plane.iter().zip(limbs.chunks_exact_mut(len)) {
                entry[limb] |= u64::from(digit) << shift;
                if shift + bits > 64 {
                    entry[limb + 1] = u64::from(digit) >> (64 - shift);
                }
            }
        }
        (len, limbs)
    }

    /// The largest `sum_k max(a_ik - a_jk, 0)` over pairs of rows; 0 for a single row.
    pub fn largest_excess(&self, progress: &dyn Progress) -> Result<BigUint, Cancelled> {
        let (len, limbs) = self.limbs();
        let mut best = vec![0u64; len + 1];
        let mut sum = vec![0u64; len + 1];
        let row = |i: usize| limbs[i * self.cols * len..][..self.cols * len].chunks_exact(len);
        for i in 0..self.rows {
            progress.checkpoint()?;
            for j in (0..self.rows).filter(|&j| j != i) {
                sum.fill(0);
                for (a, b) in row(i).zip(row(j)) {
                    if is_greater(a, b) {
                        add_difference(&mut sum, a, b);
                    }
                }
                if is_greater(&sum, &best) {
                    std::mem::swap(&mut sum, &mut best);
                }
            }
        }
        Ok(to_biguint(&best))
    }
}

fn to_biguint(limbs: &[u64]) -> BigUint {
    BigUint::new(limbs.iter().flat_map(|&limb| [limb as u32, (limb >> 32) as u32]).collect())
}

fn is_greater(a: &[u64], b: &[u64]) -> bool {
    a.iter().rev().cmp(b.iter().rev()) == std::cmp::Ordering::Greater
}

/// `sum += a - b` for `a >= b`, all little-endian, `sum` one limb longer.
fn add_difference(sum: &mut [u64], a: &[u64], b: &[u64]) {
    let mut carry = 0i128;
    for ((s, &x), &y) in sum.iter_mut().zip(a).zip(b) {
        let t = i128::from(*s) + i128::from(x) - i128::from(y) + carry;
        *s = t as u64;
        carry = t >> 64;
    }
    if let Some(last) = sum.last_mut() {
        *last = last.wrapping_add(carry as u64);
    }
}

#[cfg(test)]
mod tests;
