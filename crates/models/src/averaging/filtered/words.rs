//! Integers of a fixed number of limbs, in two's complement, least limb first: the numbers of the balls.

#![expect(clippy::needless_range_loop, reason = "a carry runs through several arrays at once")]

use num_bigint::{BigInt, Sign};

/// An integer below `2^(64 L - 1)` in absolute value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Words<const L: usize>([u64; L]);

impl<const L: usize> Words<L> {
    pub const ZERO: Self = Words([0; L]);

    /// The integer, or `None` where it does not fit.
    pub fn from_integer(x: &BigInt) -> Option<Self> {
        let words = Self::modulo(x);
        (words.to_integer() == *x).then_some(words)
    }

    /// `floor(x 2^(64 L))` for `0 <= x < 1` given as `numerator/denominator`: an unsigned share for [`Words::share`].
    pub fn fraction(numerator: &BigInt, denominator: &BigInt) -> Self {
        Self::modulo(&((numerator << (64 * L)) / denominator))
    }

    fn modulo(x: &BigInt) -> Self {
        let mut limbs = [0; L];
        for (limb, digit) in limbs.iter_mut().zip(x.magnitude().iter_u64_digits()) {
            *limb = digit;
        }
        let words = Words(limbs);
        if x.sign() == Sign::Minus { Self::ZERO.minus(words) } else { words }
    }

    #[inline(always)]
    pub fn is_negative(self) -> bool {
        self.0[L - 1] >> 63 == 1
    }

    #[inline(always)]
    pub fn plus(self, other: Self) -> Self {
        let (mut out, mut carry) = ([0; L], false);
        for k in 0..L {
            let (sum, over) = self.0[k].overflowing_add(other.0[k]);
            let (sum, more) = sum.overflowing_add(u64::from(carry));
            out[k] = sum;
            carry = over | more;
        }
        Words(out)
    }

    #[inline(always)]
    pub fn minus(self, other: Self) -> Self {
        let (mut out, mut borrow) = ([0; L], false);
        for k in 0..L {
            let (difference, under) = self.0[k].overflowing_sub(other.0[k]);
            let (difference, more) = difference.overflowing_sub(u64::from(borrow));
            out[k] = difference;
            borrow = under | more;
        }
        Words(out)
    }

    /// A multiple that fits.
    #[inline(always)]
    pub fn times(self, factor: u32) -> Self {
        let (mut out, mut carry) = ([0; L], 0u128);
        for k in 0..L {
            carry += u128::from(self.0[k]) * u128::from(factor);
            out[k] = carry as u64;
            carry >>= 64;
        }
        Words(out)
    }

    /// `self share / 2^(64 L)` for an unsigned share, at most `L` too small and never too large.
    #[inline(always)]
    pub fn share(self, share: &Self) -> Self {
        // Only the columns from 2^(64 (L-1)) on: each product left out is below one unit of the result.
        let (mut out, mut below) = ([0u64; L], 0u64);
        for i in 0..L {
            let mut carry = 0u128;
            for j in L - 1 - i..L {
                let column = i + j - (L - 1);
                let cell = if column == 0 { below } else { out[column - 1] };
                carry += u128::from(self.0[i]) * u128::from(share.0[j]) + u128::from(cell);
                if column == 0 {
                    below = carry as u64;
                } else {
                    out[column - 1] = carry as u64;
                }
                carry >>= 64;
            }
            out[i] = carry as u64;
        }
        let product = Words(out);
        // What was multiplied is larger by 2^(64 L) than a negative number.
        if self.is_negative() { product.minus(*share) } else { product }
    }

    /// `self 2^shift`, where that fits.
    pub fn raised(self, shift: u32) -> Self {
        Self::modulo(&(self.to_integer() << shift))
    }

    /// The number of bits of the absolute value.
    pub fn bits(self) -> u32 {
        let size = if self.is_negative() { Self::ZERO.minus(self) } else { self };
        let top = (0..L).rev().find(|&k| size.0[k] != 0);
        top.map_or(0, |k| 64 * k as u32 + 64 - size.0[k].leading_zeros())
    }

    /// `floor(self/2^shift)`.
    pub fn shifted(self, shift: u32) -> Self {
        Self::modulo(&(self.to_integer() >> shift))
    }

    /// The number times the scale, with a relative error below `2^-51`: `scales[k]` is the value of limb `k`.
    #[inline(always)]
    pub fn to_f64(self, scales: &[f64; L]) -> f64 {
        let size = if self.is_negative() { Self::ZERO.minus(self) } else { self };
        let mut value = 0.0;
        for k in 0..L {
            value += size.0[k] as f64 * scales[k];
        }
        if self.is_negative() { -value } else { value }
    }

    pub fn to_integer(self) -> BigInt {
        let size = if self.is_negative() { Self::ZERO.minus(self) } else { self };
        let digits: Vec<u32> = size.0.iter().flat_map(|&limb| [limb as u32, (limb >> 32) as u32]).collect();
        BigInt::from_slice(if self.is_negative() { Sign::Minus } else { Sign::Plus }, &digits)
    }
}

#[cfg(test)]
impl<const L: usize> Words<L> {
    /// The integer that a share is in units of `2^(-64 L)`.
    pub fn unsigned(self) -> BigInt {
        let digits: Vec<u32> = self.0.iter().flat_map(|&limb| [limb as u32, (limb >> 32) as u32]).collect();
        BigInt::from_slice(Sign::Plus, &digits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::random::generator;
    use num_traits::{Pow, Signed};
    use rand_chacha::rand_core::Rng;

    fn two(power: u32) -> BigInt {
        Pow::pow(BigInt::from(2), power)
    }

    /// Integers of all lengths and signs below `2^(64 L - 1)`, the ends among them.
    fn integers<const L: usize>(count: u32) -> Vec<BigInt> {
        let end = two(64 * L as u32 - 1);
        let mut all = vec![BigInt::ZERO, BigInt::from(1), BigInt::from(-1), &end - 1, -&end, two(64) - 1, -two(63)];
        let mut random = generator("test", "words", L as u64);
        for k in 0..count {
            let mut x = BigInt::ZERO;
            (0..L).for_each(|_| x = (&x << 64) + random.next_u64());
            let x = x >> (1 + 64 * L as u32 * (k % 16) / 16);
            all.push(if k % 2 == 0 { x } else { -x });
        }
        all.retain(|x| -&end <= *x && *x < end);
        all
    }

    /// The integer modulo `2^(64 L)`, as it stands in two's complement.
    fn wrapped<const L: usize>(x: &BigInt) -> BigInt {
        let whole = two(64 * L as u32);
        let rest = ((x % &whole) + &whole) % &whole;
        if rest >= &whole / 2 { rest - whole } else { rest }
    }

    fn arithmetic_is_that_of_integers<const L: usize>() {
        let all = integers::<L>(24);
        let words = |x: &BigInt| Words::<L>::from_integer(x).expect("fits");
        let whole = two(64 * L as u32);
        for x in &all {
            assert_eq!((words(x).to_integer(), words(x).is_negative()), (x.clone(), x.is_negative()));
            for factor in [0u32, 1, 7, u32::MAX] {
                assert_eq!(words(x).times(factor).to_integer(), wrapped::<L>(&(x * factor)));
            }
            for shift in [0u32, 1, 31, 64, 64 * L as u32 - 1] {
                assert_eq!(words(x).shifted(shift).to_integer(), x >> shift);
            }
            for y in &all {
                assert_eq!(words(x).plus(words(y)).to_integer(), wrapped::<L>(&(x + y)));
                assert_eq!(words(x).minus(words(y)).to_integer(), wrapped::<L>(&(x - y)));
                // A share of any unsigned fraction: less than L below the product, never above it.
                let fraction = ((y % &whole) + &whole) % &whole;
                let share = Words::<L>::modulo(&fraction);
                let found = words(x).share(&share).to_integer() * &whole;
                let product = x * &fraction;
                assert!(found <= product && product < found + &whole * L as u64, "{x} {fraction}");
            }
        }
        let end = two(64 * L as u32 - 1);
        for x in [end.clone(), -&end - 1, two(64 * L as u32), -two(64 * L as u32 + 3)] {
            assert_eq!(Words::<L>::from_integer(&x), None);
        }
        for (p, q) in [(0, 1), (1, 2), (1, 3), (2, 3), (999, 1000)] {
            let (p, q) = (BigInt::from(p), BigInt::from(q));
            let floor = (&p << (64 * L)) / &q;
            let found = Words::<L>::fraction(&p, &q).to_integer();
            assert_eq!(wrapped::<L>(&floor), found);
        }
    }

    #[test]
    fn words_are_integers() {
        arithmetic_is_that_of_integers::<1>();
        arithmetic_is_that_of_integers::<2>();
        arithmetic_is_that_of_integers::<3>();
        arithmetic_is_that_of_integers::<8>();
    }

    #[test]
    fn values_have_their_scale() {
        let scales = [2f64.powi(-70), 2f64.powi(-6)];
        for x in integers::<2>(40) {
            let found = Words::<2>::from_integer(&x).expect("fits").to_f64(&scales);
            // The nearest float of the integer, over 2^70.
            let known = x.to_string().parse::<f64>().expect("a number") * 2f64.powi(-70);
            assert!((found - known).abs() <= 2f64.powi(-51) * known.abs(), "{x}: {found} {known}");
        }
    }
}
