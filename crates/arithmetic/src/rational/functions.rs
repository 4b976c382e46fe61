//! Real functions where their values are rational: roots of squares, functions at 0, the logarithm of 1.

use super::Rational;
use crate::{ArithmeticError, Number, Ring};
use num_traits::{One, Signed, Zero};

const IRRATIONAL: ArithmeticError = ArithmeticError::Domain("numbers that are not rational, and exact runs have none");

/// The value at one point; elsewhere it is not rational.
fn at<T>(is_there: bool, value: impl FnOnce() -> T) -> Result<T, ArithmeticError> {
    if is_there { Ok(value()) } else { Err(IRRATIONAL) }
}

impl Number for Rational {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Err(IRRATIONAL)
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        if self.is_negative() {
            return Err(ArithmeticError::Argument("sqrt"));
        }
        let (p, q) = (self.numer().sqrt(), self.denom().sqrt());
        at(&p * &p == self.numer() && &q * &q == self.denom(), || Rational::new(p, q))
    }

    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        if self.is_negative() {
            return Err(ArithmeticError::Argument("root"));
        }
        let degree = u32::try_from(degree).map_err(|_| IRRATIONAL)?;
        let root = Rational::new(self.numer().nth_root(degree), self.denom().nth_root(degree));
        at(Ring::power(&root, degree.into()) == *self, || root)
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        at(self.is_zero(), || self.one())
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        if !self.is_positive() {
            return Err(ArithmeticError::Argument("ln"));
        }
        at(self.is_one(), || self.zero())
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        at(self.is_zero(), || (self.zero(), self.one()))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        at(self.is_zero(), || self.zero())
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        at(self.is_zero(), || (self.zero(), self.one()))
    }

    fn angle(y: &Self, x: &Self) -> Result<Self, ArithmeticError> {
        at(y.is_zero() && x.is_positive(), Zero::zero)
    }
}
