//! Exact rationals as a scalar.

use super::{ArithmeticError, Field, Ring, Sign, Signed};
use num_bigint::BigInt;
use num_traits::Zero;

/// An exact rational number, always in lowest terms with a positive denominator.
pub type Rational = num_rational::BigRational;

/// The rational `p / q` for numbers that come from data.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `q` is zero.
pub fn quotient(p: i64, q: i64) -> Result<Rational, ArithmeticError> {
    if q == 0 { Err(ArithmeticError::DivisionByZero) } else { Ok(rational(p, q)) }
}

/// The rational `p / q` for constants of the code, where `q` is seen not to be zero; [`quotient`] is for all others.
///
/// # Panics
/// Where `q` is zero: another value would be a wrong constant in a proof.
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
