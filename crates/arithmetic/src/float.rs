//! `f64` as a scalar: rounded to nearest, no error bound.

use super::{ArithmeticError, Field, Number, Rational, Real, Ring, Sign, Signed, rational};
use num_traits::ToPrimitive;

impl Ring for f64 {
    #[inline]
    fn integer(&self, n: i64) -> Self {
        n as f64
    }
}

impl Field for f64 {
    #[inline]
    fn rational(&self, q: &Rational) -> Self {
        q.to_f64().unwrap_or(f64::NAN)
    }

    #[inline]
    fn ratio(&self, p: i64, q: i64) -> Self {
        // Both integers are exact as floats, so that one division rounds correctly.
        const EXACT: u64 = 1 << f64::MANTISSA_DIGITS;
        if p.unsigned_abs() <= EXACT && q.unsigned_abs() <= EXACT {
            p as f64 / q as f64
        } else {
            self.rational(&rational(p, q))
        }
    }

    #[inline]
    fn recip(&self) -> Result<Self, ArithmeticError> {
        if *self == 0.0 { Err(ArithmeticError::DivisionByZero) } else { Ok(1.0 / self) }
    }

    #[inline]
    fn over(&self, divisor: &Self) -> Result<Self, ArithmeticError> {
        if *divisor == 0.0 { Err(ArithmeticError::DivisionByZero) } else { Ok(self / divisor) }
    }
}

impl Number for f64 {
    #[inline]
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(self.pi())
    }

    #[inline]
    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        if *self < 0.0 { Err(ArithmeticError::Argument("sqrt")) } else { Ok(f64::sqrt(*self)) }
    }

    #[inline]
    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        if *self < 0.0 { Err(ArithmeticError::Argument("root")) } else { Ok(f64::powf(*self, 1.0 / degree as f64)) }
    }

    #[inline]
    fn exp(&self) -> Result<Self, ArithmeticError> {
        Ok(f64::exp(*self))
    }

    #[inline]
    fn ln(&self) -> Result<Self, ArithmeticError> {
        if *self <= 0.0 { Err(ArithmeticError::Argument("ln")) } else { Ok(f64::ln(*self)) }
    }

    #[inline]
    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        Ok(f64::sin_cos(*self))
    }

    #[inline]
    fn atan(&self) -> Result<Self, ArithmeticError> {
        Ok(f64::atan(*self))
    }

    #[inline]
    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        Ok((f64::sinh(*self), f64::cosh(*self)))
    }

    /// By the library, which knows all sides; `y = -0.0` is 0, so that no angle is `-pi`.
    #[inline]
    fn angle(y: &Self, x: &Self) -> Result<Self, ArithmeticError> {
        if *x == 0.0 && *y == 0.0 { Err(ArithmeticError::Argument("heading")) } else { Ok((y + 0.0).atan2(*x)) }
    }
}

impl Real for f64 {
    #[inline]
    fn pi(&self) -> Self {
        std::f64::consts::PI
    }
}

impl Signed for f64 {
    #[inline]
    fn sign(&self) -> Option<Sign> {
        self.partial_cmp(&0.0).map(|order| match order {
            std::cmp::Ordering::Less => Sign::Negative,
            std::cmp::Ordering::Equal => Sign::Zero,
            std::cmp::Ordering::Greater => Sign::Positive,
        })
    }
}
