//! The scalar layer: laws, potentials and identities are written once over the traits here and then run over any of
//! the arithmetics below.
//!
//! | scalar | what a result means |
//! |---|---|
//! | `f64` | rounded to nearest, no bound |
//! | [`Rational`] | exact |
//! | [`Interval`] | encloses the exact value, outward rounded at a chosen precision |
//! | [`FloatInterval`] | encloses the exact value, between floats, without allocation |
//! | [`Ball<LIMBS>`] | encloses the exact value at a fixed absolute precision, without allocation |
//! | [`RealCyclotomic`] | exact: cosines and sines of rational parts of a turn |
//! | [`PreciseNumber`] | a real number, exact where it can be, otherwise enclosed, with a separation bound where it is algebraic: equality is decided |
//! | [`Complex<T>`] | a pair over any of these; over [`Rational`] the Gaussian rationals |
//! | [`Dual<T>`] | value and first derivative, exact wherever `T` is |
//! | [`Series<T>`] | truncated power series, for expansions to a stated order; functions by recurrences |
//! | [`Residue`] | exact modulo a prime |
//! | [`DegreeBound`] | degrees and coefficient sizes of numerator and denominator, for the error bound of an identity test |
//! | [`Probe`] | one of the three that an identity test needs |
//!
//! Generic code asks for the weakest trait that will do: [`Ring`], [`Field`], [`Signed`], [`Number`] (also functions, which may have no value in the
//! scalar), [`Real`] (functions that have one); [`Enclosure`] is what intervals and balls have in common.
//!
//! A sum without rounding, and the square root of two between bounds that are proved:
//!
//! ```
//! use flockproof_arithmetic::{ArithmeticError, Interval, Number, Rational, rational};
//!
//! let tenths: Rational = (0..10).map(|_| rational(1, 10)).sum();
//! assert_eq!(tenths, rational(1, 1));
//! assert_ne!((0..10).map(|_| 0.1).sum::<f64>(), 1.0);
//!
//! let root = Interval::from_rational(&rational(2, 1), 100).sqrt()?;
//! let (lo, hi) = root.to_rationals();
//! assert!(&lo * &lo < rational(2, 1) && rational(2, 1) < &hi * &hi);
//! assert!(&hi - &lo < rational(1, 10).pow(25));
//! # Ok::<(), ArithmeticError>(())
//! ```

/// Crates that stand in signatures.
pub use {num_bigint, num_rational, num_traits, rand_chacha};

mod alike;
mod ball;
mod complex;
mod degree;
mod dual;
mod dyadic;
mod elementary;
mod enclosure;
mod fixed;
mod float;
mod float_interval;
mod flow;
pub mod identity;
mod integer;
mod interval;
mod number;
mod operators;
mod probe;
mod progress;
mod radical;
pub mod random;
mod rational;
mod real_cyclotomic;
mod real_number;
mod regression;
mod residue;
mod series;
mod surd;
pub mod threads;
mod words;

pub use alike::{nearest_ids, nearest_name};
pub use ball::Ball;
pub use complex::Complex;
pub use degree::DegreeBound;
pub use dual::Dual;
pub use dyadic::Dyadic;
pub use enclosure::Enclosure;
pub use float_interval::FloatInterval;
pub use flow::{along_flow, gradient};
pub use interval::{Interval, decimals, significant_digits};
pub use number::{NumberError, decimal, parse_rational, shown};
pub use probe::Probe;
pub use progress::{Cancelled, Progress, Unwatched};
pub use radical::RadicalSum;
pub use rational::{NoRational, Rational, common_denominator, content, gcd, lcm, rational, simplest_between};
pub use real_cyclotomic::{CosineField, RealCyclotomic};
pub use real_number::{Algebraic, Obstacle, PreciseNumber, RealNumber};
pub use regression::regression_line;
pub use residue::{Residue, is_prime, random_prime};
pub use series::Series;
pub use surd::{sign_of_square_root_difference, sign_of_surd};
pub use words::words;

use std::fmt::Debug;
use std::ops::{Add, Mul, Neg, Sub};

/// Why an arithmetic operation has no result.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ArithmeticError {
    /// The divisor is zero, or is an interval that contains zero.
    #[error("division by zero (or by an interval that contains zero)")]
    DivisionByZero,
    /// The argument of the named function lies outside its domain, or is an interval that is not inside it.
    #[error("the argument of {0} lies outside its domain")]
    Argument(&'static str),
    /// What was given lacks what is named.
    #[error("this needs {0}")]
    Domain(&'static str),
}

impl ArithmeticError {
    /// A choice by a sign that an enclosure does not decide.
    pub const UNDECIDED_SIGN: Self =
        ArithmeticError::Domain("a condition that is decided, and here it may be true or false");
}

/// The sign of a real number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sign {
    /// Less than zero.
    Negative,
    /// Equal to zero.
    Zero,
    /// Greater than zero.
    Positive,
}

impl Sign {
    /// The sign of the negated number.
    pub fn negate(self) -> Self {
        match self {
            Sign::Negative => Sign::Positive,
            Sign::Zero => Sign::Zero,
            Sign::Positive => Sign::Negative,
        }
    }
}

/// A commutative ring with the integers in it. Operators take the right operand by value or by reference.
///
/// Constants are made from an existing value (`x.integer(2)`), because an interval constant needs a precision and a
/// series constant an order.
pub trait Ring:
    Clone
    + Debug
    + Send
    + Sync
    + Sized
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + for<'a> Add<&'a Self, Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
{
    /// The integer `n` as a scalar of the same kind, precision and order as `self`.
    fn integer(&self, n: i64) -> Self;

    /// Zero, of the same kind as `self`.
    #[inline]
    fn zero(&self) -> Self {
        self.integer(0)
    }

    /// One, of the same kind as `self`.
    #[inline]
    fn one(&self) -> Self {
        self.integer(1)
    }

    /// `self * self`; overridden where a square is cheaper or tighter than a product.
    #[inline]
    fn square(&self) -> Self {
        self.clone() * self
    }

    /// `self` to a non-negative power, by repeated squaring.
    #[inline]
    fn power(&self, exponent: u64) -> Self {
        let mut result = self.one();
        for bit in (0..u64::BITS - exponent.leading_zeros()).rev() {
            result = result.square();
            if exponent >> bit & 1 == 1 {
                result = result * self;
            }
        }
        result
    }
}

/// A field, or an arithmetic that encloses one.
pub trait Field: Ring {
    /// The rational `q` as a scalar of the same kind as `self`.
    fn rational(&self, q: &Rational) -> Self;

    /// `1 / self`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where `self` is zero or may be zero.
    fn recip(&self) -> Result<Self, ArithmeticError>;

    /// `self / divisor`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where the divisor is zero or may be zero.
    #[inline]
    fn over(&self, divisor: &Self) -> Result<Self, ArithmeticError> {
        Ok(self.clone() * divisor.recip()?)
    }

    /// `p / q` as a scalar of the same kind as `self`; `q` must not be zero.
    #[inline]
    fn ratio(&self, p: i64, q: i64) -> Self {
        self.rational(&rational(p, q))
    }
}

/// A scalar that laws, quantities and properties are evaluated over: a field with signs, and the real functions that they need. A function that has no
/// value in the scalar (a root of 2 among the rationals) is an error of that value, not of the scalar.
///
/// Every function returns [`ArithmeticError::Argument`] where the argument is not certainly inside the domain, and [`ArithmeticError::Domain`] where the
/// scalar cannot hold the value.
pub trait Number: Field + Signed {
    /// The circle constant, as precise as `self`.
    fn circle(&self) -> Result<Self, ArithmeticError>;
    /// Square root of a non-negative number.
    fn sqrt(&self) -> Result<Self, ArithmeticError>;
    /// The root of a degree of at least 1 of a number that is not negative; where the scalar needs a logarithm for it, or a slope, of one above 0.
    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        let share = Rational::new(1.into(), degree.into());
        (self.ln()? * self.rational(&share)).exp()
    }
    /// Exponential.
    fn exp(&self) -> Result<Self, ArithmeticError>;
    /// Natural logarithm of a positive number.
    fn ln(&self) -> Result<Self, ArithmeticError>;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError>;
    /// Inverse tangent, in (-pi/2, pi/2).
    fn atan(&self) -> Result<Self, ArithmeticError>;
    /// Hyperbolic sine and cosine.
    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError>;

    /// A number that stands for whether this one is negative, 1 or 0, of which nothing else is known; in scalars that stand for all numbers at once only.
    #[inline]
    fn indicator(&self) -> Option<Self> {
        None
    }

    /// What may be one of two numbers, whichever; in enclosures only.
    #[inline]
    fn either(&self, _: &Self) -> Option<Self> {
        None
    }

    /// Sine of an angle in radians.
    #[inline]
    fn sin(&self) -> Result<Self, ArithmeticError> {
        Ok(self.sin_cos()?.0)
    }
    /// Cosine of an angle in radians.
    #[inline]
    fn cos(&self) -> Result<Self, ArithmeticError> {
        Ok(self.sin_cos()?.1)
    }
    /// Hyperbolic cosine.
    #[inline]
    fn cosh(&self) -> Result<Self, ArithmeticError> {
        Ok(self.sinh_cosh()?.1)
    }

    /// The angle of the vector `(x, y)`, in (-pi, pi], by the side of the axes on which it is; no value for the zero vector and where an enclosure
    /// meets the negative half of the first axis.
    fn angle(y: &Self, x: &Self) -> Result<Self, ArithmeticError> {
        let quarter = |sign: i64| Ok(y.circle()? * &y.ratio(sign, 2));
        match (x.sign(), y.sign()) {
            (Some(Sign::Positive), _) => y.over(x)?.atan(),
            (_, Some(Sign::Positive)) => Ok(quarter(1)? - x.over(y)?.atan()?),
            (_, Some(Sign::Negative)) => Ok(quarter(-1)? - x.over(y)?.atan()?),
            (Some(Sign::Negative), Some(Sign::Zero)) => y.circle(),
            _ => Err(ArithmeticError::Argument("heading")),
        }
    }
}

/// Numbers among which all real ones are, or their enclosures: where the functions of [`Number`] have values on their whole domains.
pub trait Real: Number {
    /// The circle constant, as precise as `self`.
    fn pi(&self) -> Self;
}

/// Scalars whose sign can be asked for.
pub trait Signed: Ring {
    /// The sign, or `None` where it is not decided (an interval around zero, NaN).
    fn sign(&self) -> Option<Sign>;

    /// Whether the value is certainly greater than zero.
    #[inline]
    fn is_certainly_positive(&self) -> bool {
        self.sign() == Some(Sign::Positive)
    }
    /// Whether the value is certainly less than zero.
    #[inline]
    fn is_certainly_negative(&self) -> bool {
        self.sign() == Some(Sign::Negative)
    }

    /// The sign as far as a choice between two formulas needs it: an enclosure of a function on a box, with ends that may be zero, has one side on all of the box.
    #[inline]
    fn side(&self) -> Option<Sign> {
        self.sign()
    }

    /// The absolute value.
    ///
    /// # Errors
    /// [`ArithmeticError::UNDECIDED_SIGN`] where it depends on a sign that is not decided.
    fn absolute(&self) -> Result<Self, ArithmeticError> {
        match self.side().ok_or(ArithmeticError::UNDECIDED_SIGN)? {
            Sign::Negative => Ok(-self.clone()),
            _ => Ok(self.clone()),
        }
    }

    /// The larger one of two.
    ///
    /// # Errors
    /// As [`Signed::absolute`].
    fn larger(&self, other: &Self) -> Result<Self, ArithmeticError> {
        let sign = (self.clone() - other).side().ok_or(ArithmeticError::UNDECIDED_SIGN)?;
        Ok(if sign == Sign::Negative { other.clone() } else { self.clone() })
    }

    /// The smaller one of two.
    ///
    /// # Errors
    /// As [`Signed::absolute`].
    fn smaller(&self, other: &Self) -> Result<Self, ArithmeticError> {
        let sign = (self.clone() - other).side().ok_or(ArithmeticError::UNDECIDED_SIGN)?;
        Ok(if sign == Sign::Positive { other.clone() } else { self.clone() })
    }
}
