//! Greatest common divisors: the binary algorithm for words, Lehmer's for long numbers.
//!
//! Lehmer (1938), in the form of Cohen, *A Course in Computational Algebraic Number Theory*, algorithm 1.3.7: as long as the leading bits alone
//! show the next quotient of Euclid's algorithm, its steps are collected in one matrix, which is then applied to the whole numbers.

use super::Rational;
use num_bigint::{BigInt, BigUint};
use num_traits::{One, ToPrimitive, Zero};

/// The greatest common divisor; `gcd(0, b) = b`.
#[inline]
pub(super) fn gcd_u64(mut a: u64, mut b: u64) -> u64 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let twos = (a | b).trailing_zeros();
    a >>= a.trailing_zeros();
    b >>= b.trailing_zeros();
    while a != b {
        let (low, high) = if a < b { (a, b) } else { (b, a) };
        (a, b) = (low, high - low);
        b >>= b.trailing_zeros();
    }
    a << twos
}

/// The greatest common divisor; `gcd(0, b) = b`. Cost: about `2 n^2` products of words for numbers of `n` words.
pub fn gcd(a: &BigUint, b: &BigUint) -> BigUint {
    if let (Some(a), Some(b)) = (a.to_u64(), b.to_u64()) {
        return BigUint::from(gcd_u64(a, b));
    }
    let (high, low) = if a >= b { (a, b) } else { (b, a) };
    let (mut high, mut low) = (high.to_u64_digits(), low.to_u64_digits());
    loop {
        trim(&mut high);
        trim(&mut low);
        if low.len() <= 1 {
            let word = low.first().copied().unwrap_or(0);
            return if word == 0 { number(&high) } else { BigUint::from(gcd_u64(word, rest(&high, word))) };
        }
        match Steps::shown(&high, &low) {
            Some(steps) => steps.apply(&mut high, &mut low),
            None => {
                let rest = number(&high) % number(&low);
                high = std::mem::replace(&mut low, rest.to_u64_digits());
            }
        }
    }
}

/// The least common multiple, not negative.
pub fn lcm(a: &BigInt, b: &BigInt) -> BigInt {
    if a.is_zero() || b.is_zero() {
        return BigInt::ZERO;
    }
    let (a, b) = (a.magnitude(), b.magnitude());
    BigInt::from(a / gcd(a, b) * b)
}

/// The least common denominator of some rationals; of none, 1.
pub fn common_denominator<'a>(rationals: impl IntoIterator<Item = &'a Rational>) -> BigInt {
    rationals.into_iter().fold(BigInt::one(), |common, x| lcm(&common, &x.denom()))
}

/// The greatest common divisor of some integers, not negative; of none, and of zeros, 0.
pub fn content<'a>(integers: impl IntoIterator<Item = &'a BigInt>) -> BigInt {
    BigInt::from(integers.into_iter().fold(BigUint::ZERO, |common, x| gcd(&common, x.magnitude())))
}

/// Takes leading zeros away.
fn trim(words: &mut Vec<u64>) {
    while words.last() == Some(&0) {
        words.pop();
    }
}

fn number(words: &[u64]) -> BigUint {
    let halves = words.iter().flat_map(|word| [*word as u32, (*word >> 32) as u32]);
    BigUint::new(halves.collect())
}

/// The number modulo a word.
fn rest(words: &[u64], word: u64) -> u64 {
    let step = |rest: u128, digit: &u64| ((rest << 64) | u128::from(*digit)) % u128::from(word);
    words.iter().rev().fold(0, step) as u64
}

/// Steps of Euclid's algorithm at once: `(high, low)` becomes `(a high + b low, c high + d low)`; factors below `2^32` in size.
struct Steps {
    first: [i64; 2],
    second: [i64; 2],
}

impl Steps {
    /// What the leading 62 bits show; `None` where they show no step.
    fn shown(high: &[u64], low: &[u64]) -> Option<Self> {
        let (mut x, mut y) = (leading(high, high), leading(low, high));
        let (mut first, mut second) = ([1, 0], [0, 1]);
        // The whole numbers, divided by the same power of two, lie in [x, x + 1) and [y, y + 1): the quotient must be the same at both ends.
        while y + second[0] > 0 && y + second[1] > 0 {
            let quotient = (x + first[0]) / (y + second[0]);
            if quotient != (x + first[1]) / (y + second[1]) {
                break;
            }
            let next = |first: i64, second: i64| first.checked_sub(quotient.checked_mul(second)?);
            let (Some(c), Some(d)) = (next(first[0], second[0]), next(first[1], second[1])) else { break };
            if c.unsigned_abs().max(d.unsigned_abs()) > u64::from(u32::MAX) {
                break;
            }
            (first, second) = (second, [c, d]);
            (x, y) = (y, x - quotient * y);
        }
        (first[1] != 0).then_some(Steps { first, second })
    }

    fn apply(&self, high: &mut [u64], low: &mut Vec<u64>) {
        low.resize(high.len(), 0);
        let combined = |[a, b]: [i64; 2], x: u64, y: u64, carry: i128| {
            i128::from(a) * i128::from(x) + i128::from(b) * i128::from(y) + carry
        };
        let (mut carry, mut borrow) = (0, 0);
        for (x, y) in high.iter_mut().zip(low) {
            let (one, other) = (combined(self.first, *x, *y, carry), combined(self.second, *x, *y, borrow));
            (*x, *y) = (one as u64, other as u64);
            (carry, borrow) = (one >> 64, other >> 64);
        }
    }
}

/// The 62 leading bits of `of`, and what stands in the same places of a number that is not larger.
fn leading(words: &[u64], of: &[u64]) -> i64 {
    let top = of.len() - 1;
    let word = |k: usize| u128::from(words.get(k).copied().unwrap_or(0));
    let both = word(top) << 64 | word(top - 1);
    (both >> (66 - of[top].leading_zeros())) as i64
}
