//! Rows of long signed integers, all of one width, for state vectors over a common denominator that are stepped many
//! times without allocation.
//!
//! Two's complement, least significant limb first. Between operations the topmost limb of each row is nothing but its sign, so
//! that a product with a coefficient below 2^62 still fits.

use num_bigint::{BigInt, BigUint, Sign};
use num_traits::{One, Signed, ToPrimitive, Zero};

/// Rows of signed integers of one common width.
#[derive(Debug, Clone)]
pub struct IntegerRows {
    count: usize,
    /// Limbs in use.
    width: usize,
    /// Limbs from the start of one row to the next.
    stride: usize,
    limbs: Vec<u64>,
}

/// Single-limb coefficients are below this: two products and their carries fit 128 bits, and a row times one fits its width.
const SMALL_BITS: u64 = 62;

/// How one row of an average is made: a multiple of itself plus a multiple of the sum of others, both not negative.
#[derive(Debug, Clone)]
pub struct AverageRow {
    near: Vec<usize>,
    coefficients: Coefficients,
}

#[derive(Debug, Clone)]
enum Coefficients {
    Small { own: u64, other: u64 },
    Long { own: BigInt, other: BigInt },
}

impl AverageRow {
    /// `own row + other (sum of the rows in near)`.
    pub fn new(own: BigInt, other: BigInt, near: Vec<usize>) -> Self {
        let small = (&own + &other * near.len()).bits() <= SMALL_BITS;
        let coefficients = match (own.to_u64(), other.to_u64()) {
            (Some(own), Some(other)) if small => Coefficients::Small { own, other },
            _ => Coefficients::Long { own, other },
        };
        AverageRow { near, coefficients }
    }
}

impl IntegerRows {
    /// The rows with these values.
    pub fn new(values: &[BigInt]) -> Self {
        let width = values.iter().map(|x| x.bits() / 64 + 2).max().unwrap_or(2) as usize;
        let mut rows = IntegerRows { count: values.len(), width, stride: width, limbs: vec![0; values.len() * width] };
        for (i, value) in values.iter().enumerate() {
            rows.set(i, value);
        }
        rows
    }

    /// Number of rows.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Limbs of each row; the topmost is sign only.
    pub fn width(&self) -> usize {
        self.width
    }

    fn set(&mut self, i: usize, value: &BigInt) {
        let negative = value.is_negative();
        let start = i * self.stride;
        let row = &mut self.limbs[start..start + self.width];
        row.fill(0);
        for (limb, digit) in row.iter_mut().zip(value.magnitude().iter_u64_digits()) {
            *limb = digit;
        }
        if negative {
            negate(row);
        }
    }

    fn row(&self, i: usize) -> &[u64] {
        if i < self.count { &self.limbs[i * self.stride..i * self.stride + self.width] } else { &[] }
    }

    /// The value of row `i`; zero of one that is not there.
    pub fn value(&self, i: usize) -> BigInt {
        to_integer(self.row(i).to_vec())
    }

    /// Row `i` minus row `j`.
    pub fn difference(&self, i: usize, j: usize) -> BigInt {
        let mut borrow = false;
        let limbs = self.row(i).iter().zip(self.row(j)).map(|(&a, &b)| {
            let (first, over) = a.overflowing_sub(b);
            let (second, under) = first.overflowing_sub(u64::from(borrow));
            borrow = over || under;
            second
        });
        to_integer(limbs.collect())
    }

    /// `floor(row i / 2^shift)`, or `None` where it does not fit 128 bits.
    pub fn window(&self, i: usize, shift: u64) -> Option<i128> {
        let row = self.row(i);
        let (limb, bits) = ((shift / 64) as usize, (shift % 64) as u32);
        let at = |k: usize| row.get(k).copied().unwrap_or_else(|| sign_limb(row));
        let mut low = ((u128::from(at(limb + 1)) << 64) | u128::from(at(limb))) >> bits;
        if bits > 0 {
            low |= u128::from(at(limb + 2)) << (128 - bits);
        }
        let sign = if low >> 127 == 1 { u64::MAX } else { 0 };
        let fits = (at(limb + 2) as i64) >> bits == sign as i64 && row.iter().skip(limb + 3).all(|&k| k == sign);
        fits.then_some(low as i128)
    }

    /// The number of bits of `|row i|`, at most one too many.
    pub fn bits(&self, i: usize) -> u64 {
        let row = self.row(i);
        let sign = sign_limb(row);
        let top = row.iter().rposition(|&limb| limb != sign);
        top.map_or(1, |k| 64 * k as u64 + u64::from(64 - (row[k] ^ sign).leading_zeros()) + 1)
    }

    /// Makes room so that products with coefficients of `limbs` limbs fit, and later ones without allocation.
    fn reserve(&mut self, limbs: usize) {
        let wanted = self.width + limbs;
        if wanted > self.stride {
            let stride = 2 * wanted;
            let mut wider = vec![0; self.count * stride];
            for i in 0..self.count {
                wider[i * stride..i * stride + self.width].copy_from_slice(self.row(i));
            }
            self.limbs = wider;
            self.stride = stride;
        }
    }

    /// Extends all rows to `width` limbs by their signs.
    fn widen(&mut self, width: usize) {
        if width <= self.width {
            return;
        }
        self.reserve(width - self.width);
        for i in 0..self.count {
            let row = &mut self.limbs[i * self.stride..i * self.stride + width];
            let sign = sign_limb(&row[..self.width]);
            row[self.width..].fill(sign);
        }
        self.width = width;
    }

    /// Widens by as many limbs as the values need to have a topmost limb of sign only.
    fn settle_width(&mut self) {
        let tight = |row: &[u64]| {
            let sign = row[row.len() - 1];
            (sign != 0 && sign != u64::MAX) || (sign ^ row[row.len() - 2]) >> 63 != 0
        };
        if (0..self.count).any(|i| tight(self.row(i))) {
            self.widen(self.width + 1);
        }
    }

    /// `row i = factor row i + add row i` with `factor > 0` for the rows of `add`; the rows of `self` beyond those are only
    /// multiplied.
    pub fn scale_and_add(&mut self, factor: &BigInt, add: &IntegerRows) {
        if factor.bits() > SMALL_BITS {
            self.widen(self.width + factor.bits() as usize / 64 + 1);
            for i in 0..self.count {
                let scaled = self.value(i) * factor;
                self.set(i, &scaled);
            }
            return self.scale_and_add(&BigInt::one(), add);
        }
        let factor = factor.to_u64().unwrap_or(1);
        self.widen(add.width);
        for i in 0..self.count {
            let row = &mut self.limbs[i * self.stride..i * self.stride + self.width];
            if i >= add.count {
                scale(row, factor, 0);
                continue;
            }
            let (low, high) = row.split_at_mut(add.width);
            let mut carry = 0u128;
            for (limb, &more) in low.iter_mut().zip(add.row(i)) {
                carry += u128::from(*limb) * u128::from(factor) + u128::from(more);
                *limb = carry as u64;
                carry >>= 64;
            }
            // Beyond its width a negative number goes on with all ones: minus one in the next limb.
            let carry = carry as i128 - i128::from(sign_limb(add.row(i)) & 1);
            scale(high, factor, carry);
        }
        self.settle_width();
    }

    /// Overwrites every row `i` by the average `rule[i]` of the rows of `from`, which has as many.
    pub fn average(&mut self, from: &mut IntegerRows, rule: &[AverageRow]) {
        let room = rule.iter().map(|row| match &row.coefficients {
            Coefficients::Small { .. } => 0,
            Coefficients::Long { own, other } => own.bits().max(other.bits()) as usize / 64 + 2,
        });
        from.widen(from.width + room.max().unwrap_or(0));
        self.widen(from.width);
        self.width = from.width;
        for (i, row) in rule.iter().enumerate() {
            match &row.coefficients {
                &Coefficients::Small { own, other } => {
                    let out = &mut self.limbs[i * self.stride..i * self.stride + from.width];
                    match row.near.as_slice() {
                        [] => {
                            out.copy_from_slice(from.row(i));
                            scale(out, own, 0);
                        }
                        [j] => average_into(out, from.row(i), own, other, [from.row(*j)]),
                        [j, k] => average_into(out, from.row(i), own, other, [from.row(*j), from.row(*k)]),
                        many => average_many(out, from, i, own, other, many),
                    }
                }
                Coefficients::Long { own, other } => {
                    let sum: BigInt = row.near.iter().map(|&j| from.value(j)).sum();
                    let value = from.value(i) * own + sum * other;
                    self.set(i, &value);
                }
            }
        }
        self.settle_width();
    }
}

fn average_into<const N: usize>(out: &mut [u64], own_row: &[u64], own: u64, other: u64, near: [&[u64]; N]) {
    let width = out.len();
    let own_row = &own_row[..width];
    let near = near.map(|row| &row[..width]);
    let (mut sum_carry, mut carry) = (0u64, 0u128);
    for k in 0..width {
        let sum = near.iter().fold(u128::from(sum_carry), |sum, row| sum + u128::from(row[k]));
        sum_carry = (sum >> 64) as u64;
        carry += u128::from(sum as u64) * u128::from(other) + u128::from(own_row[k]) * u128::from(own);
        out[k] = carry as u64;
        carry >>= 64;
    }
}

fn average_many(out: &mut [u64], from: &IntegerRows, i: usize, own: u64, other: u64, near: &[usize]) {
    let base = from.row(i);
    let (mut sum_carry, mut carry) = (0u128, 0u128);
    for (k, slot) in out.iter_mut().enumerate() {
        let sum = near.iter().fold(sum_carry, |sum, &j| sum + u128::from(from.limbs[j * from.stride + k]));
        sum_carry = sum >> 64;
        carry += u128::from(sum as u64) * u128::from(other) + u128::from(base[k]) * u128::from(own);
        *slot = carry as u64;
        carry >>= 64;
    }
}

/// `row = factor row + carry` with wrapping; the carry is -1 or more.
fn scale(row: &mut [u64], factor: u64, mut carry: i128) {
    if factor == 1 && carry == 0 {
        return;
    }
    for limb in row {
        // Below 2^126 in absolute value; the shift keeps the sign.
        carry += (u128::from(*limb) * u128::from(factor)) as i128;
        *limb = carry as u64;
        carry >>= 64;
    }
}

fn sign_limb(row: &[u64]) -> u64 {
    if row.last().is_some_and(|&top| top >> 63 == 1) { u64::MAX } else { 0 }
}

fn negate(row: &mut [u64]) {
    let mut carry = true;
    for limb in row {
        let (flipped, over) = (!*limb).overflowing_add(u64::from(carry));
        *limb = flipped;
        carry = over;
    }
}

fn biguint(limbs: &[u64]) -> BigUint {
    let halves = limbs.iter().flat_map(|&limb| [limb as u32, (limb >> 32) as u32]).collect();
    BigUint::new(halves)
}

fn to_integer(mut limbs: Vec<u64>) -> BigInt {
    let negative = sign_limb(&limbs) != 0;
    if negative {
        negate(&mut limbs);
    }
    let magnitude = biguint(&limbs);
    if magnitude.is_zero() {
        return BigInt::zero();
    }
    BigInt::from_biguint(if negative { Sign::Minus } else { Sign::Plus }, magnitude)
}
