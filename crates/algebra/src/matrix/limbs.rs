//! Products of whole matrices of non-negative integers stored as equally long arrays of 64-bit limbs.
//!
//! The sum over the inner index is accumulated limb by limb, so no product of two entries is ever stored; long entries
//! are split once per matrix and multiplied by Karatsuba's three products of half-length matrices.

use arithmetic::{Cancelled, Progress};
use num_bigint::BigUint;

/// Entries at least this long are split. Measured, see `benches/product.rs`.
const KARATSUBA_LIMBS: usize = 16;

/// The same where shorter ones are multiplied by pairs.
const KARATSUBA_OVER_PAIRS_LIMBS: usize = 26;

/// Entries at least this long are multiplied by pairs.
const PAIRS_LIMBS: usize = 6;

/// Orders from which pairs are worth their sums.
const PAIRS_ORDER: usize = 8;

/// Entry `(i, j)` is the little-endian number `limbs[(i cols + j) len ..][..len]`.
#[derive(Debug, Clone)]
pub(super) struct LimbMatrix {
    pub rows: usize,
    pub cols: usize,
    len: usize,
    limbs: Vec<u64>,
}

impl LimbMatrix {
    pub fn from_entries(rows: usize, cols: usize, entries: &[BigUint]) -> Self {
        let len = entries.iter().map(|x| x.iter_u64_digits().len()).max().unwrap_or(0).max(1);
        let mut limbs = vec![0; rows * cols * len];
        for (slot, entry) in limbs.chunks_exact_mut(len).zip(entries) {
            for (limb, digit) in slot.iter_mut().zip(entry.iter_u64_digits()) {
                *limb = digit;
            }
        }
        LimbMatrix { rows, cols, len, limbs }
    }

    fn zeros(rows: usize, cols: usize, len: usize) -> Self {
        LimbMatrix { rows, cols, len, limbs: vec![0; rows * cols * len] }
    }

    pub fn entry(&self, i: usize, j: usize) -> &[u64] {
        let start = (i * self.cols + j) * self.len;
        &self.limbs[start..start + self.len]
    }

    pub fn entries(&self) -> impl Iterator<Item = BigUint> + '_ {
        self.limbs.chunks_exact(self.len).map(to_biguint)
    }

    pub fn is_zero(&self, i: usize, j: usize) -> bool {
        self.entry(i, j).iter().all(|&limb| limb == 0)
    }

    /// Drops leading zero limbs that all entries share.
    fn trimmed(mut self) -> Self {
        let used = |entry: &[u64]| entry.iter().rposition(|&limb| limb != 0).map_or(1, |p| p + 1);
        let needed = self.limbs.chunks_exact(self.len).map(used).max().unwrap_or(1);
        if needed < self.len {
            let old = std::mem::take(&mut self.limbs);
            self.limbs = old.chunks_exact(self.len).flat_map(|entry| &entry[..needed]).copied().collect();
            self.len = needed;
        }
        self
    }

    /// `self * right`. No entry of the product needs more than `longest` limbs, and `small_rows` says that the rows of
    /// `self` sum to less than `2^64`.
    pub fn times(
        &self,
        right: &Self,
        longest: usize,
        small_rows: bool,
        progress: &dyn Progress,
    ) -> Result<Self, Cancelled> {
        if self.len == 1 && small_rows {
            return self.times_small(right, longest.min(right.len + 1), progress);
        }
        Ok(self.times_long(right, progress)?.trimmed())
    }

    /// Single limbs on the left: each output limb is one sum of `cols` products. The row sum bounds it:
    /// `sum_k a_ik p_k + carry <= (2^64 - 1) 2^64`.
    fn times_small(&self, right: &Self, out_len: usize, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let (inner, len) = (self.cols, right.len);
        let mut out = LimbMatrix::zeros(self.rows, right.cols, out_len);
        let mut column = vec![0u64; inner];
        let mut carries = vec![0u64; self.rows];
        for j in 0..right.cols {
            progress.checkpoint()?;
            carries.fill(0);
            for l in 0..len {
                for (k, limb) in column.iter_mut().enumerate() {
                    *limb = right.limbs[(k * right.cols + j) * len + l];
                }
                for (i, (row, carry)) in self.limbs.chunks_exact(inner).zip(&mut carries).enumerate() {
                    let sum = dot(row, &column, *carry);
                    out.limbs[(i * right.cols + j) * out_len + l] = sum as u64;
                    *carry = (sum >> 64) as u64;
                }
            }
            if out_len > len {
                for (i, &carry) in carries.iter().enumerate() {
                    out.limbs[(i * right.cols + j) * out_len + len] = carry;
                }
            }
        }
        Ok(out)
    }

    fn times_long(&self, right: &Self, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let (shorter, longer) = (self.len.min(right.len), self.len.max(right.len));
        let pairs = self.cols.is_multiple_of(2) && self.rows.min(self.cols).min(right.cols) >= PAIRS_ORDER;
        let split_from = if pairs { KARATSUBA_OVER_PAIRS_LIMBS } else { KARATSUBA_LIMBS };
        if shorter >= split_from && 3 * shorter >= 2 * longer {
            self.times_karatsuba(right, longer.div_ceil(2), progress)
        } else if pairs && shorter >= PAIRS_LIMBS && 5 * shorter >= 4 * longer {
            self.times_by_pairs(right, progress)
        } else {
            self.times_schoolbook(right, progress)
        }
    }

    /// Product scanning: one column of limbs after the other, over all inner indices, in a 192-bit accumulator.
    fn times_schoolbook(&self, right: &Self, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let (la, lb) = (self.len, right.len);
        let len = la + lb + 1;
        let mut out = LimbMatrix::zeros(self.rows, right.cols, len);
        // Right entries reversed and transposed, so that both operands of the inner loop run forward.
        let mut reversed = Vec::with_capacity(right.limbs.len());
        for j in 0..right.cols {
            for k in 0..right.rows {
                reversed.extend(right.entry(k, j).iter().rev());
            }
        }
        let rows = self.limbs.chunks_exact(self.cols * la);
        for (row, out_row) in rows.zip(out.limbs.chunks_exact_mut(right.cols * len)) {
            progress.checkpoint()?;
            for (column, slot) in reversed.chunks_exact(right.rows * lb).zip(out_row.chunks_exact_mut(len)) {
                scan_products(row, la, column, lb, slot);
            }
        }
        Ok(out)
    }

    /// With half of the products of long numbers, for an even number of columns, by Winograd's identity (1968):
    /// `sum_k a_2k b_2k + a_2k+1 b_2k+1 = sum_k (a_2k + b_2k+1)(a_2k+1 + b_2k) - x_i - y_j`, where `x_i = sum_k a_2k a_2k+1` depends on the
    /// row alone and `y_j` on the column.
    fn times_by_pairs(&self, right: &Self, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let width = self.len.max(right.len);
        let top = |limbs: &[u64], len: usize| if len == width { limbs[len - 1] } else { 0 };
        let full = |m: &Self| m.limbs.chunks_exact(m.len).any(|entry| top(entry, m.len) >> 63 == 1);
        // A sum of two entries may need a limb more.
        let width = width + usize::from(full(self) || full(right));
        let (pairs, length) = (self.cols / 2, 2 * width + 1);
        let mut work = Pairs::new(pairs, width);
        let column = |j: usize| move |k: usize| right.entry(k, j);
        let columns: Vec<Vec<u64>> = (0..right.cols).map(|j| work.own(column(j))).collect();
        let mut out = LimbMatrix::zeros(self.rows, right.cols, length);
        let mut slots = out.limbs.chunks_exact_mut(length);
        for i in 0..self.rows {
            progress.checkpoint()?;
            let row = |k: usize| self.entry(i, k);
            let own = work.own(row);
            for ((j, others), slot) in columns.iter().enumerate().zip(slots.by_ref()) {
                work.mixed(row, column(j), slot);
                add_signed(slot, &own, true);
                add_signed(slot, others, true);
            }
        }
        Ok(out)
    }

    /// `A = A0 + A1 x`, `B = B0 + B1 x` with `x = 2^(64 h)`: `AB = P0 + (Pm - P0 - P1) x + P1 x²`.
    fn times_karatsuba(&self, right: &Self, h: usize, progress: &dyn Progress) -> Result<Self, Cancelled> {
        let (a0, a1) = self.split(h);
        let (b0, b1) = right.split(h);
        let low = a0.times_long(&b0, progress)?;
        let high = a1.times_long(&b1, progress)?;
        let middle = a0.plus(&a1).times_long(&b0.plus(&b1), progress)?;
        let len = self.len + right.len + 1;
        let mut out = LimbMatrix::zeros(self.rows, right.cols, len);
        let parts = low
            .limbs
            .chunks_exact(low.len)
            .zip(high.limbs.chunks_exact(high.len))
            .zip(middle.limbs.chunks_exact(middle.len));
        let mut scratch = vec![0u64; middle.len];
        for (((low, high), middle), slot) in parts.zip(out.limbs.chunks_exact_mut(len)) {
            scratch.copy_from_slice(middle);
            add_signed(&mut scratch, low, true);
            add_signed(&mut scratch, high, true);
            add_signed(slot, low, false);
            add_signed(&mut slot[h..], &scratch, false);
            add_signed(&mut slot[(2 * h).min(len)..], high, false);
        }
        Ok(out)
    }

    /// The entries modulo `2^(64 h)` and divided by it.
    fn split(&self, h: usize) -> (Self, Self) {
        let upper = self.len.saturating_sub(h).max(1);
        let (mut low, mut high) = (Vec::with_capacity(self.limbs.len()), Vec::with_capacity(self.limbs.len()));
        let lower = h.min(self.len);
        for entry in self.limbs.chunks_exact(self.len) {
            low.extend_from_slice(&entry[..lower]);
            high.extend_from_slice(&entry[lower..]);
            if self.len <= h {
                high.push(0);
            }
        }
        let matrix = |len, limbs| LimbMatrix { rows: self.rows, cols: self.cols, len, limbs };
        (matrix(lower, low), matrix(upper, high))
    }

    fn plus(&self, other: &Self) -> Self {
        let len = self.len.max(other.len) + 1;
        let mut out = LimbMatrix::zeros(self.rows, self.cols, len);
        let pairs = self.limbs.chunks_exact(self.len).zip(other.limbs.chunks_exact(other.len));
        for ((a, b), slot) in pairs.zip(out.limbs.chunks_exact_mut(len)) {
            slot[..a.len()].copy_from_slice(a);
            add_signed(slot, b, false);
        }
        out
    }

    /// The largest `sum_k max(a_ik - a_jk, 0)` over pairs of rows; 0 for a single row.
    pub fn largest_excess(&self, progress: &dyn Progress) -> Result<BigUint, Cancelled> {
        let mut best = vec![0u64; self.len + 1];
        let mut sum = vec![0u64; self.len + 1];
        for i in 0..self.rows {
            progress.checkpoint()?;
            for j in (0..self.rows).filter(|&j| j != i) {
                sum.fill(0);
                for k in 0..self.cols {
                    let (a, b) = (self.entry(i, k), self.entry(j, k));
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

/// Working space of [`LimbMatrix::times_by_pairs`]: numbers of `width` limbs, those on the right reversed.
struct Pairs {
    width: usize,
    left: Vec<u64>,
    right: Vec<u64>,
}

impl Pairs {
    fn new(pairs: usize, width: usize) -> Self {
        let numbers = || vec![0; pairs * width];
        Pairs { width, left: numbers(), right: numbers() }
    }

    /// `sum_k x_2k x_2k+1`.
    fn own<'a>(&mut self, x: impl Fn(usize) -> &'a [u64]) -> Vec<u64> {
        let mut product = vec![0; 2 * self.width + 1];
        self.sums(|k| (x(2 * k), &[]), |k| (x(2 * k + 1), &[]));
        scan_products(&self.left, self.width, &self.right, self.width, &mut product);
        product
    }

    /// `sum_k (a_2k + b_2k+1)(a_2k+1 + b_2k)`.
    fn mixed<'a>(&mut self, a: impl Fn(usize) -> &'a [u64], b: impl Fn(usize) -> &'a [u64], slot: &mut [u64]) {
        self.sums(|k| (a(2 * k), b(2 * k + 1)), |k| (a(2 * k + 1), b(2 * k)));
        scan_products(&self.left, self.width, &self.right, self.width, slot);
    }

    fn sums<'a>(
        &mut self,
        left: impl Fn(usize) -> (&'a [u64], &'a [u64]),
        right: impl Fn(usize) -> (&'a [u64], &'a [u64]),
    ) {
        let slots = self.left.chunks_exact_mut(self.width).zip(self.right.chunks_exact_mut(self.width));
        for (k, (to_left, to_right)) in slots.enumerate() {
            let ((a, b), (c, d)) = (left(k), right(k));
            sum_into(a, b, to_left.iter_mut());
            sum_into(c, d, to_right.iter_mut().rev());
        }
    }
}

/// Writes `x + y`, lowest limb first, and zeros.
fn sum_into<'a>(x: &[u64], y: &[u64], slots: impl Iterator<Item = &'a mut u64>) {
    let mut carry = false;
    for (k, slot) in slots.enumerate() {
        let (a, b) = (x.get(k).copied().unwrap_or(0), y.get(k).copied().unwrap_or(0));
        let (sum, first) = a.overflowing_add(b);
        let (sum, second) = sum.overflowing_add(u64::from(carry));
        (*slot, carry) = (sum, first | second);
    }
}

/// `carry + sum_k a_k p_k`, four products at a time.
fn dot(a: &[u64], p: &[u64], carry: u64) -> u128 {
    let product = |x: u64, y: u64| u128::from(x) * u128::from(y);
    let (fours, rest) = a.as_chunks::<4>();
    let (other_fours, other_rest) = p.as_chunks::<4>();
    let mut sum = u128::from(carry);
    for (x, y) in fours.iter().zip(other_fours) {
        sum += (product(x[0], y[0]) + product(x[1], y[1])) + (product(x[2], y[2]) + product(x[3], y[3]));
    }
    rest.iter().zip(other_rest).fold(sum, |sum, (&x, &y)| sum + product(x, y))
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

/// `target += x` or `target -= x`; what lies beyond `target` must be zero.
fn add_signed(target: &mut [u64], x: &[u64], subtract: bool) {
    let mut carry = false;
    for (k, slot) in target.iter_mut().enumerate() {
        let digit = match x.get(k) {
            Some(&digit) => digit,
            None if carry => 0,
            None => break,
        };
        (*slot, carry) = if subtract {
            let (d, first) = slot.overflowing_sub(digit);
            let (d, second) = d.overflowing_sub(u64::from(carry));
            (d, first | second)
        } else {
            let (d, first) = slot.overflowing_add(digit);
            let (d, second) = d.overflowing_add(u64::from(carry));
            (d, first | second)
        };
    }
}

/// One entry of the product: `row` holds entries of `la` limbs, `column` entries of `lb` limbs in reversed order.
fn scan_products(row: &[u64], la: usize, column: &[u64], lb: usize, slot: &mut [u64]) {
    let (mut low, mut high) = (0u128, 0u64);
    for (c, limb) in slot.iter_mut().enumerate().take(la + lb) {
        // a index l runs over c - l < lb; the reversed b index of c - l is lb - 1 - c + l.
        let first = (c + 1).saturating_sub(lb);
        let last = c.min(la - 1);
        if first <= last {
            let start = lb - 1 + first - c;
            let count = last + 1 - first;
            for (a, b) in row.chunks_exact(la).zip(column.chunks_exact(lb)) {
                for (&x, &y) in a[first..=last].iter().zip(&b[start..start + count]) {
                    let (sum, overflow) = low.overflowing_add(u128::from(x) * u128::from(y));
                    low = sum;
                    high += u64::from(overflow);
                }
            }
        }
        *limb = low as u64;
        low = (low >> 64) | (u128::from(high) << 64);
        high = 0;
    }
    slot[la + lb] = low as u64;
}
