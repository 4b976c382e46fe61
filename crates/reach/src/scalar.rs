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

    /// The sum of products.
    fn dot(a: &[Self], b: &[Self], zero: &Self) -> Self {
        a.iter().zip(b).fold(zero.clone(), |sum, (x, y)| sum + x.clone() * y)
    }
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

    /// Rounded outwards once: `n` products and sums in floats are off by less than `(n + 1) 2^-53` of the sum of their sizes, and by the smallest normal float where
    /// they underflow.
    fn dot(a: &[Self], b: &[Self], _: &Self) -> Self {
        let (mut lo, mut hi, mut sizes, mut count) = (0.0, 0.0, 0.0, 0.0);
        for (x, y) in a.iter().zip(b) {
            let ends = [x.lo() * y.lo(), x.lo() * y.hi(), x.hi() * y.lo(), x.hi() * y.hi()];
            let (least, most) =
                (ends[0].min(ends[1]).min(ends[2].min(ends[3])), ends[0].max(ends[1]).max(ends[2].max(ends[3])));
            if x.magnitude() != 0.0 && y.magnitude() != 0.0 {
                (lo, hi, count) = (lo + least, hi + most, count + 1.0);
                sizes += (-least).max(most);
            }
        }
        if count == 0.0 {
            return FloatInterval::ZERO;
        }
        let off = sizes * (count + 2.0) * f64::EPSILON + count * f64::MIN_POSITIVE;
        FloatInterval::between((lo - off).next_down(), (hi + off).next_up())
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
    T::dot(a, b, zero)
}

pub(crate) fn apply<T: Scalar>(a: &Matrix<T>, x: &[T]) -> Vec<T> {
    a.iter().map(|row| dot(row, x, &x[0].zero())).collect()
}

pub(crate) fn times<T: Scalar>(a: &Matrix<T>, b: &Matrix<T>) -> Matrix<T> {
    let Some(zero) = a.first().and_then(|row| row.first()).map(|x| x.zero()) else { return Vec::new() };
    let columns: Matrix<T> = (0..b.len()).map(|j| b.iter().map(|row| row[j].clone()).collect()).collect();
    a.iter().map(|row| columns.iter().map(|column| dot(row, column, &zero)).collect()).collect()
}
