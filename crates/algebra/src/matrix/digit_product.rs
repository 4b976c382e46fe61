//! Products of matrices of long integers whose digits lie in planes: `sum_l A_l x^l` times `sum_l B_l x^l` with `x = 2^28`.
//!
//! A digit of the product is a sum of products of small integers over the inner index and over pairs of planes. Several entries
//! of a row are computed side by side in the lanes of the processor. Long factors are split by Karatsuba, which with planes is
//! one cut of the list of digits.

use arithmetic::{Cancelled, Progress};
use pulp::Simd;
use pulp::bytemuck::{cast_slice, cast_slice_mut};

/// Bits of a digit.
pub(super) const DIGIT_BITS: u32 = 28;

const MASK: u64 = (1 << DIGIT_BITS) - 1;

/// The sum of so many products of two digits is below `2^64`.
const PRODUCTS: usize = 1 << (64 - 2 * DIGIT_BITS);

/// Factors of at least so many digits are split. Measured, see `benches/product.rs`.
const KARATSUBA_DIGITS: usize = 32;

/// Rows of the product that are computed together.
const ROWS: usize = 4;

/// A matrix of `rows x inner` times one of `inner x cols`.
#[derive(Clone, Copy)]
pub(super) struct Shape {
    pub rows: usize,
    pub inner: usize,
    pub cols: usize,
}

impl Shape {
    /// All digits of the product, one plane more than both factors together.
    pub fn product(self, a: &[u32], b: &[u32], progress: &dyn Progress) -> Result<Vec<u32>, Cancelled> {
        let (left, right, size) = (self.rows * self.inner, self.inner * self.cols, self.rows * self.cols);
        let (of_a, of_b) = (a.len() / left, b.len() / right);
        let (shorter, longer) = (of_a.min(of_b), of_a.max(of_b));
        if shorter < KARATSUBA_DIGITS || 3 * shorter < 2 * longer {
            return pulp::Arch::new().dispatch(Schoolbook { shape: self, a, b, progress });
        }
        // `A = A0 + A1 x`, `B = B0 + B1 x`: `AB = P0 + (Pm - P0 - P1) x + P1 x²`.
        let h = longer.div_ceil(2);
        let ((a0, a1), (b0, b1)) = (a.split_at(h * left), b.split_at(h * right));
        let low = self.product(a0, b0, progress)?;
        let high = self.product(a1, b1, progress)?;
        let middle = self.product(&sum(a0, a1, left), &sum(b0, b1, right), progress)?;
        let mut total = vec![0; (of_a + of_b + 1) * size];
        let shift = h * size;
        add(&mut total, &low, 1);
        add(&mut total[2 * shift..], &high, 1);
        for (part, sign) in [(&middle, 1), (&low, -1), (&high, -1)] {
            add(&mut total[shift..], part, sign);
        }
        Ok(carried(&total, size))
    }
}

/// `total += sign digits`, without carries; what lies beyond `total` is zero in the end.
fn add(total: &mut [i64], digits: &[u32], sign: i64) {
    total.iter_mut().zip(digits).for_each(|(sum, &digit)| *sum += sign * i64::from(digit));
}

/// `x + y`; a plane more than the longer one if it is needed.
fn sum(x: &[u32], y: &[u32], size: usize) -> Vec<u32> {
    let mut total = vec![0; x.len().max(y.len()) + size];
    add(&mut total, x, 1);
    add(&mut total, y, 1);
    let mut digits = carried(&total, size);
    let top = digits.len() - size;
    if digits[top..].iter().all(|&digit| digit == 0) {
        digits.truncate(top);
    }
    digits
}

/// The digits of what is not negative, and was added up without carries.
fn carried(total: &[i64], size: usize) -> Vec<u32> {
    let mut carries = vec![0i64; size];
    let mut digits = vec![0; total.len()];
    for (sums, plane) in total.chunks_exact(size).zip(digits.chunks_exact_mut(size)) {
        for ((&sum, carry), digit) in sums.iter().zip(&mut carries).zip(plane) {
            let sum = sum + *carry;
            *digit = (sum & MASK as i64) as u32;
            *carry = sum >> DIGIT_BITS;
        }
    }
    digits
}

/// All pairs of planes.
struct Schoolbook<'a> {
    shape: Shape,
    a: &'a [u32],
    b: &'a [u32],
    progress: &'a dyn Progress,
}

impl pulp::WithSimd for Schoolbook<'_> {
    type Output = Result<Vec<u32>, Cancelled>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        if self.shape.cols <= S::U64_LANES { self.by_tiles::<S, 1>(simd) } else { self.by_tiles::<S, 2>(simd) }
    }
}

impl Schoolbook<'_> {
    /// By tiles of `ROWS` rows and `V` vectors of columns, filled with zeros at the edges.
    #[inline(always)]
    fn by_tiles<S: Simd, const V: usize>(self, simd: S) -> Result<Vec<u32>, Cancelled> {
        let Shape { rows, inner, cols } = self.shape;
        let (left, right, size) = (rows * inner, inner * cols, rows * cols);
        let (of_a, of_b) = (self.a.len() / left, self.b.len() / right);
        let mut product = vec![0; (of_a + of_b + 1) * size];
        let panels = self.panels::<S, V>(simd);
        let mut band = vec![[0u32; ROWS]; of_a * inner];
        for i in (0..rows).step_by(ROWS) {
            let height = ROWS.min(rows - i);
            for (slots, plane) in band.chunks_exact_mut(inner).zip(self.a.chunks_exact(left)) {
                for (r, row) in plane[i * inner..(i + height) * inner].chunks_exact(inner).enumerate() {
                    slots.iter_mut().zip(row).for_each(|(slot, &digit)| slot[r] = digit);
                }
            }
            for (panel, j) in panels.chunks_exact(of_b * inner).zip((0..cols).step_by(V * S::U64_LANES)) {
                let mut carry = [[simd.splat_u64s(0); V]; ROWS];
                for (c, plane) in product.chunks_exact_mut(size).enumerate() {
                    if c % 64 == 0 {
                        self.progress.checkpoint()?;
                    }
                    // Plane l of A meets plane c - l of B, which is the (of_b - 1 - c + l)th in the panel.
                    let met = (c + 1).saturating_sub(of_b)..(c + 1).min(of_a);
                    let (mut x, mut y): (&[_], &[_]) = (&[], &[]);
                    if !met.is_empty() {
                        x = &band[met.start * inner..met.end * inner];
                        y = &panel[(of_b - 1 + met.start - c) * inner..][..x.len()];
                    }
                    let digits = tile(simd, &mut carry, x, y);
                    for (r, digits) in digits.iter().take(height).enumerate() {
                        let slots = plane[(i + r) * cols..][..cols].iter_mut().skip(j);
                        slots.zip(cast_slice::<_, u64>(digits)).for_each(|(slot, &digit)| *slot = digit as u32);
                    }
                }
            }
        }
        Ok(product)
    }

    /// The right factor, `V` vectors of columns after the other, each with the highest plane first: so both factors are read
    /// forwards.
    #[inline(always)]
    fn panels<S: Simd, const V: usize>(&self, simd: S) -> Vec<[S::u64s; V]> {
        let Shape { inner, cols, .. } = self.shape;
        let width = V * S::U64_LANES;
        let length = self.b.len() / cols;
        let mut panels = vec![[simd.splat_u64s(0); V]; length * cols.div_ceil(width)];
        for (panel, j) in panels.chunks_exact_mut(length).zip((0..cols).step_by(width)) {
            for (slots, plane) in panel.chunks_exact_mut(inner).zip(self.b.rchunks_exact(inner * cols)) {
                for (slot, row) in slots.iter_mut().zip(plane.chunks_exact(cols)) {
                    let lanes = cast_slice_mut::<_, u64>(slot).iter_mut();
                    lanes.zip(&row[j..]).for_each(|(lane, &digit)| *lane = u64::from(digit));
                }
            }
        }
        panels
    }
}

/// The digits `carry + sum_k x_k y_k` modulo `2^28`, and what is carried to the next.
#[inline(always)]
fn tile<S: Simd, const V: usize>(
    simd: S,
    carry: &mut [[S::u64s; V]; ROWS],
    left: &[[u32; ROWS]],
    right: &[[S::u64s; V]],
) -> [[S::u64s; V]; ROWS] {
    let (zero, mask) = (simd.splat_u64s(0), simd.splat_u64s(MASK));
    let mut digits = std::mem::replace(carry, [[zero; V]; ROWS]);
    for (left, right) in left.chunks(PRODUCTS).zip(right.chunks(PRODUCTS)) {
        let mut sums = [[zero; V]; ROWS];
        for (x, y) in left.iter().zip(right) {
            for r in 0..ROWS {
                for v in 0..V {
                    sums[r][v] = simd.add_u64s(sums[r][v], products(simd, x[r], y[v]));
                }
            }
        }
        for r in 0..ROWS {
            for v in 0..V {
                digits[r][v] = simd.add_u64s(digits[r][v], simd.and_u64s(sums[r][v], mask));
                carry[r][v] = simd.add_u64s(carry[r][v], without_digit::<S>(sums[r][v]));
            }
        }
    }
    for r in 0..ROWS {
        for v in 0..V {
            carry[r][v] = simd.add_u64s(carry[r][v], without_digit::<S>(digits[r][v]));
            digits[r][v] = simd.and_u64s(digits[r][v], mask);
        }
    }
    digits
}

/// The products of one digit with the digits in the lanes.
#[inline(always)]
fn products<S: Simd>(simd: S, x: u32, y: S::u64s) -> S::u64s {
    // Compilers do not find this instruction by themselves.
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = (&simd as &dyn std::any::Any).downcast_ref::<pulp::x86::V3>() {
        let x = pulp::bytemuck::cast(simd.splat_u32s(x));
        return pulp::bytemuck::cast(simd.avx2._mm256_mul_epu32(x, pulp::bytemuck::cast(y)));
    }
    let _ = simd;
    lanewise::<S>(y, |digit| (digit & u64::from(u32::MAX)) * u64::from(x))
}

#[inline(always)]
fn without_digit<S: Simd>(x: S::u64s) -> S::u64s {
    lanewise::<S>(x, |x| x >> DIGIT_BITS)
}

#[inline(always)]
fn lanewise<S: Simd>(mut x: S::u64s, f: impl Fn(u64) -> u64) -> S::u64s {
    cast_slice_mut(std::slice::from_mut(&mut x)).iter_mut().for_each(|lane| *lane = f(*lane));
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::Unwatched;
    use pulp::WithSimd;

    #[test]
    fn digits_do_not_depend_on_the_processor() {
        // All digits as large as they can be: the sums come as near to 2^64 as they can.
        for (rows, inner, cols, of_a, of_b) in
            [(1, 1, 1, 1, 1), (5, 300, 9, 2, 3), (4, 16, 8, 20, 17), (3, 2, 3, 40, 1)]
        {
            let shape = Shape { rows, inner, cols };
            let (a, b) = (vec![MASK as u32; of_a * rows * inner], vec![MASK as u32; of_b * inner * cols]);
            let work = || Schoolbook { shape, a: &a, b: &b, progress: &Unwatched };
            let alone = work().with_simd(pulp::Scalar::new());
            assert_eq!(alone, pulp::Arch::new().dispatch(work()));
        }
    }
}
