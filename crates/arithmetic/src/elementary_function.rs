//! Functions of one number by name, for scalars in which some of them may have no value.

use super::{ArithmeticError, Field, Rational, Real, Ring, Signed};
use num_traits::Signed as _;

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Elementary {
    /// Square root.
    Root,
    /// Exponential.
    Exponential,
    /// Natural logarithm.
    Logarithm,
    /// Sine of an angle in radians.
    Sine,
    /// Cosine of an angle in radians.
    Cosine,
}

/// A scalar that laws, quantities and properties are evaluated over. A function that has no value there (a root of 2 among the rationals) is an
/// error of that value, not of the scalar. Every scalar that is [`Real`] and [`Signed`] is one.
pub trait Number: Field + Signed {
    /// The function at this number.
    ///
    /// # Errors
    /// [`ArithmeticError`] outside the domain, or where the scalar cannot hold the value.
    fn function(&self, function: Elementary) -> Result<Self, ArithmeticError>;

    /// The circle constant.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where the scalar has none.
    fn circle(&self) -> Result<Self, ArithmeticError>;

    /// The angle of the vector `(x, y)`, in (-pi, pi].
    ///
    /// # Errors
    /// [`ArithmeticError::Argument`] for the zero vector and where an enclosure meets the negative half of the first axis.
    fn angle(y: &Self, x: &Self) -> Result<Self, ArithmeticError>;

    /// The square root.
    ///
    /// # Errors
    /// As [`Number::function`].
    #[inline]
    fn root(&self) -> Result<Self, ArithmeticError> {
        self.function(Elementary::Root)
    }
}

impl<T: Real + Signed> Number for T {
    #[inline]
    fn function(&self, function: Elementary) -> Result<Self, ArithmeticError> {
        match function {
            Elementary::Root => self.sqrt(),
            Elementary::Exponential => self.exp(),
            Elementary::Logarithm => self.ln(),
            Elementary::Sine => self.sin(),
            Elementary::Cosine => self.cos(),
        }
    }

    #[inline]
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(self.pi())
    }

    #[inline]
    fn angle(y: &Self, x: &Self) -> Result<Self, ArithmeticError> {
        T::argument(y, x)
    }
}

const RATIONAL: ArithmeticError = ArithmeticError::Domain("numbers that are not rational, and exact runs have none");

impl Number for Rational {
    /// Exact where the value is rational: roots of squares, functions at 0, the logarithm of 1.
    fn function(&self, function: Elementary) -> Result<Self, ArithmeticError> {
        let whole = self.zero();
        match function {
            Elementary::Root if self.is_negative() => Err(ArithmeticError::Argument("sqrt")),
            Elementary::Root => {
                let (p, q) = (self.numer().sqrt(), self.denom().sqrt());
                let exact = &p * &p == self.numer() && &q * &q == self.denom();
                if exact { Ok(Rational::new(p, q)) } else { Err(RATIONAL) }
            }
            Elementary::Sine if *self == whole => Ok(whole),
            Elementary::Exponential | Elementary::Cosine if *self == whole => Ok(self.one()),
            Elementary::Logarithm if !self.is_positive() => Err(ArithmeticError::Argument("log")),
            Elementary::Logarithm if *self == self.one() => Ok(whole),
            _ => Err(RATIONAL),
        }
    }

    fn circle(&self) -> Result<Self, ArithmeticError> {
        Err(RATIONAL)
    }

    fn angle(y: &Self, x: &Self) -> Result<Self, ArithmeticError> {
        let along = *y == y.zero() && x.is_positive();
        if along { Ok(y.zero()) } else { Err(RATIONAL) }
    }
}
