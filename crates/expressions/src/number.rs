//! What a scalar must have so that a law can be evaluated over it.

use arithmetic::{ArithmeticError, Dual, Field, FloatInterval, Interval, Rational, Real, Ring, Series, Sign, Signed};
use num_traits::Signed as _;

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Function {
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

/// A scalar that laws are evaluated over. A function that has no value there (a root of 2 among the rationals) is an error of that value, not of
/// the scalar.
pub trait Number: Field + Signed {
    /// The function at this number.
    ///
    /// # Errors
    /// [`ArithmeticError`] outside the domain, or where the scalar cannot hold the value.
    fn function(&self, function: Function) -> Result<Self, ArithmeticError>;

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
}

/// [`Number::angle`] from the inverse tangent, by the side of the axes on which the vector is.
fn angle_by_sides<T: Real + Signed>(y: &T, x: &T) -> Result<T, ArithmeticError> {
    let quarter = |sign: i64| y.pi() * &y.ratio(sign, 2);
    match (x.sign(), y.sign()) {
        (Some(Sign::Positive), _) => y.over(x)?.atan(),
        (_, Some(Sign::Positive)) => Ok(quarter(1) - x.over(y)?.atan()?),
        (_, Some(Sign::Negative)) => Ok(quarter(-1) - x.over(y)?.atan()?),
        (Some(Sign::Negative), Some(Sign::Zero)) => Ok(y.pi()),
        _ => Err(ArithmeticError::Argument("heading")),
    }
}

/// [`Number::angle`] by the library, which knows all sides.
#[inline]
fn angle_of_floats(y: &f64, x: &f64) -> Result<f64, ArithmeticError> {
    if *x == 0.0 && *y == 0.0 { Err(ArithmeticError::Argument("heading")) } else { Ok(y.atan2(*x)) }
}

fn real_function<T: Real>(x: &T, function: Function) -> Result<T, ArithmeticError> {
    match function {
        Function::Root => x.sqrt(),
        Function::Exponential => x.exp(),
        Function::Logarithm => x.ln(),
        Function::Sine => x.sin(),
        Function::Cosine => x.cos(),
    }
}

macro_rules! number {
    ([$($generics:tt)*] $type:ty, $angle:expr) => {
        impl<$($generics)*> Number for $type {
            #[inline]
            fn function(&self, function: Function) -> Result<Self, ArithmeticError> {
                real_function(self, function)
            }
            #[inline]
            fn circle(&self) -> Result<Self, ArithmeticError> {
                Ok(self.pi())
            }
            #[inline]
            fn angle(y: &Self, x: &Self) -> Result<Self, ArithmeticError> {
                $angle(y, x)
            }
        }
    };
}

number!([] f64, angle_of_floats);
number!([] FloatInterval, angle_by_sides);
number!([] Interval, angle_by_sides);
number!([T: Real + Signed] Series<T>, angle_by_sides);
number!([T: Real + Signed] Dual<T>, angle_by_sides);

const RATIONAL: ArithmeticError = ArithmeticError::Domain("numbers that are not rational, and exact runs have none");

impl Number for Rational {
    /// Exact where the value is rational: roots of squares, functions at 0, the logarithm of 1.
    fn function(&self, function: Function) -> Result<Self, ArithmeticError> {
        let whole = self.zero();
        match function {
            Function::Root if self.is_negative() => Err(ArithmeticError::Argument("sqrt")),
            Function::Root => {
                let (p, q) = (self.numer().sqrt(), self.denom().sqrt());
                let exact = &p * &p == self.numer() && &q * &q == self.denom();
                if exact { Ok(Rational::new(p, q)) } else { Err(RATIONAL) }
            }
            Function::Sine if *self == whole => Ok(whole),
            Function::Exponential | Function::Cosine if *self == whole => Ok(self.one()),
            Function::Logarithm if !self.is_positive() => Err(ArithmeticError::Argument("log")),
            Function::Logarithm if *self == self.one() => Ok(whole),
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
