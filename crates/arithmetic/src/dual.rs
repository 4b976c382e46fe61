//! Dual numbers over any scalar: a value with its first derivative along one direction.

use super::operators::operators;
use super::{ArithmeticError, Field, Number, Rational, Real, Ring, Sign, Signed};

/// `value + e derivative` with `e² = 0`.
#[derive(Debug, Clone, PartialEq)]
pub struct Dual<T> {
    /// The value.
    pub value: T,
    /// The derivative along the chosen direction.
    pub derivative: T,
}

impl<T: Ring> Dual<T> {
    /// A value that moves with the given derivative.
    #[inline]
    pub fn new(value: T, derivative: T) -> Self {
        Dual { value, derivative }
    }

    /// A constant.
    #[inline]
    pub fn constant(value: T) -> Self {
        let derivative = value.zero();
        Dual { value, derivative }
    }

    /// The chain rule: a function with this value and slope at `self.value`.
    #[inline]
    fn chain(&self, value: T, slope: T) -> Self {
        Dual { value, derivative: slope * &self.derivative }
    }
}

operators!(
    [T: Ring] Dual<T>,
    |a, b| Dual { value: a.value.clone() + &b.value, derivative: a.derivative.clone() + &b.derivative },
    |a, b| Dual { value: a.value.clone() - &b.value, derivative: a.derivative.clone() - &b.derivative },
    |a, b| Dual {
        value: a.value.clone() * &b.value,
        derivative: a.derivative.clone() * &b.value + a.value.clone() * &b.derivative,
    },
    |a| Dual { value: -a.value.clone(), derivative: -a.derivative.clone() }
);

impl<T: Ring> Ring for Dual<T> {
    #[inline]
    fn integer(&self, n: i64) -> Self {
        Dual::constant(self.value.integer(n))
    }
}

impl<T: Field> Field for Dual<T> {
    #[inline]
    fn rational(&self, q: &Rational) -> Self {
        Dual::constant(self.value.rational(q))
    }

    #[inline]
    fn recip(&self) -> Result<Self, ArithmeticError> {
        let value = self.value.recip()?;
        let slope = -value.square();
        Ok(self.chain(value, slope))
    }
}

impl<T: Number> Number for Dual<T> {
    #[inline]
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(Dual::constant(self.value.circle()?))
    }

    /// The derivative at zero does not exist: there it is a division by zero.
    #[inline]
    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        let value = self.value.sqrt()?;
        let slope = (value.clone() + &value).recip()?;
        Ok(self.chain(value, slope))
    }

    /// As the square root.
    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        let value = self.value.root(degree)?;
        let share = self.value.rational(&Rational::new(1.into(), degree.into()));
        let slope = (value.clone() * &share).over(&self.value)?;
        Ok(self.chain(value, slope))
    }

    #[inline]
    fn exp(&self) -> Result<Self, ArithmeticError> {
        let value = self.value.exp()?;
        Ok(self.chain(value.clone(), value))
    }

    #[inline]
    fn ln(&self) -> Result<Self, ArithmeticError> {
        Ok(self.chain(self.value.ln()?, self.value.recip()?))
    }

    #[inline]
    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        let (sin, cos) = self.value.sin_cos()?;
        Ok((self.chain(sin.clone(), cos.clone()), self.chain(cos, -sin)))
    }

    #[inline]
    fn atan(&self) -> Result<Self, ArithmeticError> {
        let slope = (self.value.square() + self.value.one()).recip()?;
        Ok(self.chain(self.value.atan()?, slope))
    }

    #[inline]
    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        let (sinh, cosh) = self.value.sinh_cosh()?;
        Ok((self.chain(sinh.clone(), cosh.clone()), self.chain(cosh, sinh)))
    }
}

impl<T: Real> Real for Dual<T> {
    #[inline]
    fn pi(&self) -> Self {
        Dual::constant(self.value.pi())
    }
}

impl<T: Ring + Signed> Signed for Dual<T> {
    /// The sign of the value, where it stays the same nearby; zero where value and derivative are.
    #[inline]
    fn sign(&self) -> Option<Sign> {
        match self.value.sign()? {
            Sign::Zero if self.derivative.sign() != Some(Sign::Zero) => None,
            sign => Some(sign),
        }
    }

    #[inline]
    fn side(&self) -> Option<Sign> {
        self.sign().or_else(|| self.value.side().filter(|side| *side != Sign::Zero))
    }
}
