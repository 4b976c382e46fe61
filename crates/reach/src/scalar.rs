//! The enclosures that worst cases are computed in: floats first, dyadic intervals where more digits are asked for.

use arithmetic::{Enclosure, Field, FloatInterval, Interval, Sign, Signed};

/// An enclosure that is made from one of higher precision.
pub(crate) trait Scalar: Enclosure + Field + Signed {
    /// An enclosure of what `x` encloses, with the precision of `self`.
    fn of(&self, x: &Interval) -> Self;

    /// Bits that a result can be certain to.
    fn bits(&self) -> u32;

    /// Both signs of a bound.
    fn symmetric(bound: &Self) -> Self {
        bound.joined(&-bound.clone())
    }

    /// An upper bound of the absolute values.
    fn magnitude(&self) -> Self {
        match self.sign() {
            Some(Sign::Negative) => (-self.clone()).top(),
            Some(_) => self.top(),
            None => Self::symmetric(self).top(),
        }
    }

    /// All absolute values.
    fn moduli(&self) -> Self {
        match self.sign() {
            None => self.zero().joined(&self.magnitude()),
            Some(Sign::Negative) => -self.clone(),
            Some(_) => self.clone(),
        }
    }

    /// The upper end.
    fn top(&self) -> Self;
}

impl Scalar for FloatInterval {
    fn of(&self, x: &Interval) -> Self {
        FloatInterval::from_interval(x)
    }

    fn bits(&self) -> u32 {
        f64::MANTISSA_DIGITS
    }

    fn top(&self) -> Self {
        FloatInterval::point(self.hi())
    }
}

impl Scalar for Interval {
    fn of(&self, x: &Interval) -> Self {
        x.with_precision(self.precision())
    }

    fn bits(&self) -> u32 {
        self.precision()
    }

    fn top(&self) -> Self {
        Interval::between(self.hi().clone(), self.hi().clone(), self.precision())
    }
}

/// A square matrix by rows.
pub(crate) type Matrix<T> = Vec<Vec<T>>;

pub(crate) fn dot<T: Scalar>(a: &[T], b: &[T], zero: &T) -> T {
    a.iter().zip(b).fold(zero.clone(), |sum, (x, y)| sum + x.clone() * y)
}

pub(crate) fn apply<T: Scalar>(a: &Matrix<T>, x: &[T]) -> Vec<T> {
    a.iter().map(|row| dot(row, x, &x[0].zero())).collect()
}

pub(crate) fn times<T: Scalar>(a: &Matrix<T>, b: &Matrix<T>) -> Matrix<T> {
    let Some(zero) = a.first().and_then(|row| row.first()).map(|x| x.zero()) else { return Vec::new() };
    let columns: Matrix<T> = (0..b.len()).map(|j| b.iter().map(|row| row[j].clone()).collect()).collect();
    a.iter().map(|row| columns.iter().map(|column| dot(row, column, &zero)).collect()).collect()
}
