//! Integers as a scalar: numerators over a common denominator.

use super::{Ring, Sign, Signed};
use num_bigint::BigInt;

impl Ring for BigInt {
    fn integer(&self, n: i64) -> Self {
        BigInt::from(n)
    }
}

impl Signed for BigInt {
    fn sign(&self) -> Option<Sign> {
        Some(match BigInt::sign(self) {
            num_bigint::Sign::Minus => Sign::Negative,
            num_bigint::Sign::NoSign => Sign::Zero,
            num_bigint::Sign::Plus => Sign::Positive,
        })
    }
}
