//! What is decided: a function written once over the scalar, a relation to zero, a domain.

use arithmetic::{ArithmeticError, Number, Rational, Sign, rational};
use num_traits::ToPrimitive;

/// A function of several numbers, written once over the scalar: rationals give its values exactly, intervals bounds, dual numbers derivatives, the
/// scalar [`Symbolic`](crate::Symbolic) the function itself.
pub trait Function: Sync {
    /// The value at a point of the domain.
    ///
    /// # Errors
    /// [`ArithmeticError`] where there is none, or the scalar cannot hold it.
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError>;
}

/// How a value is compared with zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Compared {
    /// Above zero.
    Positive,
    /// At least zero.
    NotNegative,
    /// Zero.
    Zero,
    /// Not zero.
    NotZero,
}

impl Compared {
    /// Whether a number of this sign is as asked.
    pub fn admits(self, sign: Sign) -> bool {
        match self {
            Compared::Positive => sign == Sign::Positive,
            Compared::NotNegative => sign != Sign::Negative,
            Compared::Zero => sign == Sign::Zero,
            Compared::NotZero => sign != Sign::Zero,
        }
    }
}

/// A function that is compared with zero.
#[derive(Debug, Clone)]
pub struct Literal<F> {
    /// The function.
    pub function: F,
    /// How it is compared.
    pub compared: Compared,
    /// Whether it may be taken for defined, because whoever asks decides that separately. Where it is not, a literal is true only where its function is
    /// defined.
    pub guarded: bool,
}

/// What a variable ranges over: from the lower to the upper end, without an end where there is none.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    /// Lower end.
    pub lo: Option<Rational>,
    /// Upper end.
    pub hi: Option<Rational>,
    /// Whether only the integers of that range are meant.
    pub integer: bool,
}

impl Side {
    /// From one number to another one.
    pub fn between(lo: Rational, hi: Rational) -> Self {
        Side { lo: Some(lo), hi: Some(hi), integer: false }
    }

    /// One number.
    pub fn point(at: Rational) -> Self {
        Side { lo: Some(at.clone()), hi: Some(at), integer: false }
    }

    /// All reals.
    pub fn line() -> Self {
        Side { lo: None, hi: None, integer: false }
    }

    /// The integers from one to another one.
    pub fn integers(lo: i64, hi: i64) -> Self {
        Side { lo: Some(rational(lo, 1)), hi: Some(rational(hi, 1)), integer: true }
    }

    /// With smaller ends where that leaves out no integer, if only integers are meant.
    pub(crate) fn rounded(mut self) -> Self {
        if self.integer {
            self.lo = self.lo.map(|lo| lo.ceil());
            self.hi = self.hi.map(|hi| hi.floor());
        }
        self
    }

    /// Whether it has no number.
    pub fn is_empty(&self) -> bool {
        self.lo.as_ref().zip(self.hi.as_ref()).is_some_and(|(lo, hi)| lo > hi)
    }

    /// The only number, where there is one only.
    pub fn as_point(&self) -> Option<&Rational> {
        self.lo.as_ref().filter(|lo| self.hi.as_ref() == Some(lo))
    }

    /// The number, moved into the range where it lies outside; the integer before it where only these are meant.
    pub fn nearest(&self, x: Rational) -> Rational {
        let x = if self.integer { x.floor() } else { x };
        match (&self.lo, &self.hi) {
            (Some(lo), _) if x < *lo => lo.clone(),
            (_, Some(hi)) if x > *hi => hi.clone(),
            _ => x,
        }
    }

    /// Whether the number lies in the range.
    pub fn contains(&self, x: &Rational) -> bool {
        let inside = self.lo.as_ref().is_none_or(|lo| lo <= x) && self.hi.as_ref().is_none_or(|hi| x <= hi);
        inside && (!self.integer || x.is_integer())
    }

    /// A number inside, in the middle where there is one.
    pub fn middle(&self) -> Rational {
        self.nearest(self.centre())
    }

    fn centre(&self) -> Rational {
        match (&self.lo, &self.hi) {
            (Some(lo), Some(hi)) => (lo + hi) * rational(1, 2),
            (Some(lo), None) => {
                if *lo < rational(1, 2) {
                    rational(1, 1)
                } else {
                    lo * rational(2, 1)
                }
            }
            (None, Some(hi)) => {
                if *hi > rational(-1, 2) {
                    rational(-1, 1)
                } else {
                    hi * rational(2, 1)
                }
            }
            (None, None) => rational(0, 1),
        }
    }

    /// Both ends as floats, infinite where there is none; not rounded outward.
    pub fn floats(&self) -> (f64, f64) {
        let end = |end: &Option<Rational>, none: f64| end.as_ref().map_or(none, |q| q.to_f64().unwrap_or(none));
        (end(&self.lo, f64::NEG_INFINITY), end(&self.hi, f64::INFINITY))
    }
}
