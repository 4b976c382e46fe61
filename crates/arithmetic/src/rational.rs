//! Exact rationals as a scalar.

use super::{ArithmeticError, Field, Ring, Sign, Signed};
use num_bigint::BigInt;
use num_traits::Zero;

/// An exact rational number, always in lowest terms with a positive denominator.
pub type Rational = num_rational::BigRational;

/// The rational `p / q`; `q` must not be zero.
pub fn rational(p: i64, q: i64) -> Rational {
    Rational::new(BigInt::from(p), BigInt::from(q))
}

impl Ring for Rational {
    fn integer(&self, n: i64) -> Self {
        Rational::from_integer(BigInt::from(n))
    }
}

impl Field for Rational {
    fn rational(&self, q: &Rational) -> Self {
        q.clone()
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        if self.is_zero() { Err(ArithmeticError::DivisionByZero) } else { Ok(Rational::recip(self)) }
    }
}

impl Signed for Rational {
    fn sign(&self) -> Option<Sign> {
        Signed::sign(self.numer())
    }
}
