//! Truncated power series over any scalar: expansions to a stated order, exact wherever the coefficients are.

use super::operators::operators;
use super::{ArithmeticError, Field, Number, Rational, Real, Ring, Sign, Signed};

/// `c_0 + c_1 h + ... + c_{n-1} h^{n-1} + O(h^n)`.
///
/// The order `n` of a result is the smaller order of the operands. There is always at least `c_0`.
#[derive(Debug, Clone, PartialEq)]
pub struct Series<T> {
    coefficients: Vec<T>,
}

impl<T: Ring> Series<T> {
    /// The constant `value + O(h^order)`; an order of 0 is taken as 1.
    pub fn constant(value: T, order: usize) -> Self {
        let zero = value.zero();
        let mut coefficients = vec![zero; order.max(1)];
        coefficients[0] = value;
        Series { coefficients }
    }

    /// The variable `h`, scaled: `scale h + O(h^order)`.
    pub fn variable(scale: T, order: usize) -> Self {
        let mut series = Series::constant(scale.zero(), order.max(2));
        series.coefficients[1] = scale;
        series
    }

    /// The series with these coefficients, lowest first, of which there is at least one: the order is their number.
    pub fn from_coefficients(first: T, rest: impl IntoIterator<Item = T>) -> Self {
        Series { coefficients: std::iter::once(first).chain(rest).collect() }
    }

    /// The coefficients, lowest first.
    pub fn coefficients(&self) -> &[T] {
        &self.coefficients
    }

    /// The series with `f` of each coefficient.
    pub fn map(&self, f: impl FnMut(&T) -> T) -> Self {
        Series { coefficients: self.coefficients.iter().map(f).collect() }
    }

    /// The same series with each coefficient multiplied by `factor`.
    pub fn scale(&self, factor: &T) -> Self {
        self.map(|c| c.clone() * factor)
    }

    fn zip(a: &Self, b: &Self, f: impl Fn(&T, &T) -> T) -> Self {
        Series { coefficients: a.coefficients.iter().zip(&b.coefficients).map(|(x, y)| f(x, y)).collect() }
    }

    fn convolve(a: &Self, b: &Self) -> Self {
        let order = a.coefficients.len().min(b.coefficients.len());
        let coefficient = |n: usize| {
            let term = |k: usize| a.coefficients[k].clone() * &b.coefficients[n - k];
            (1..=n).fold(term(0), |sum, k| sum + term(k))
        };
        Series { coefficients: (0..order).map(coefficient).collect() }
    }
}

operators!(
    [T: Ring] Series<T>,
    |a, b| Series::zip(a, b, |x, y| x.clone() + y),
    |a, b| Series::zip(a, b, |x, y| x.clone() - y),
    Series::convolve,
    |a| a.map(|c| -c.clone())
);

impl<T: Ring> Ring for Series<T> {
    fn integer(&self, n: i64) -> Self {
        Series::constant(self.coefficients[0].integer(n), self.coefficients.len())
    }
}

impl<T: Field> Series<T> {
    /// The square root with constant term 1 of a series with constant term 1 (which is not checked):
    /// `2 r_n = s_n - sum_{0<k<n} r_k r_{n-k}`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] in characteristic 2.
    pub fn sqrt_of_unit(&self) -> Result<Self, ArithmeticError> {
        let one = self.coefficients[0].one();
        let half = (one.clone() + &one).recip()?;
        let mut root = vec![one];
        for n in 1..self.coefficients.len() {
            let mut rest = self.coefficients[n].clone();
            for k in 1..n {
                rest = rest - root[k].clone() * &root[n - k];
            }
            root.push(rest * &half);
        }
        Ok(Series { coefficients: root })
    }
}

impl<T: Field> Field for Series<T> {
    fn rational(&self, q: &Rational) -> Self {
        Series::constant(self.coefficients[0].rational(q), self.coefficients.len())
    }

    /// Needs a constant term that is not zero.
    fn recip(&self) -> Result<Self, ArithmeticError> {
        let first = self.coefficients[0].recip()?;
        let mut inverse = vec![first.clone()];
        for n in 1..self.coefficients.len() {
            let mut sum = first.zero();
            for k in 1..=n {
                sum = sum + self.coefficients[k].clone() * &inverse[n - k];
            }
            inverse.push(-(sum * &first));
        }
        Ok(Series { coefficients: inverse })
    }
}

impl<T: Field> Series<T> {
    /// The series whose coefficient `n > 0` times `n` is what `term` says of those before it.
    fn by_recurrence(
        &self,
        first: T,
        term: impl Fn(&[T], usize) -> Result<T, ArithmeticError>,
    ) -> Result<Self, ArithmeticError> {
        let mut all = vec![first];
        for n in 1..self.coefficients.len() {
            let next = term(&all, n)?;
            all.push(next.clone() * &next.ratio(1, n as i64));
        }
        Ok(Series { coefficients: all })
    }

    /// `sum k c_k b_{n-k}` over `k` from 1 to `most`: coefficient `n - 1` of the derivative of `c` times `b`.
    fn of_derivative(c: &[T], b: &[T], n: usize, most: usize) -> T {
        let term = |k: usize| c[k].integer(k as i64) * &c[k] * &b[n - k];
        (1..=most).fold(c[0].zero(), |sum, k| sum + term(k))
    }

    /// A function and another one, from their values at the constant term, where the derivative of the first is the second, that of the second `sign` times the first.
    fn pair(&self, (first, second): (T, T), sign: i64) -> (Self, Self) {
        let c = &self.coefficients;
        let (mut a, mut b) = (vec![first], vec![second]);
        for n in 1..c.len() {
            let part = |of: &[T]| {
                let sum = Series::of_derivative(c, of, n, n);
                sum.clone() * &sum.ratio(1, n as i64)
            };
            let (next_a, next_b) = (part(&b), part(&a));
            a.push(next_a);
            b.push(next_b.clone() * &next_b.integer(sign));
        }
        (Series { coefficients: a }, Series { coefficients: b })
    }
}

/// Functions of a series by the recurrences of their differential equations.
impl<T: Number> Number for Series<T> {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(Series::constant(self.coefficients[0].circle()?, self.coefficients.len()))
    }

    /// Needs a constant term that is not zero, unless there is no other: `2 r_0 r_n = c_n - sum_{0<k<n} r_k r_{n-k}`.
    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        let c = &self.coefficients;
        let mut root = vec![c[0].sqrt()?];
        for n in 1..c.len() {
            let rest = (1..n).fold(c[n].clone(), |rest, k| rest - root[k].clone() * &root[n - k]);
            let twice = root[0].clone() + &root[0];
            root.push(rest.over(&twice)?);
        }
        Ok(Series { coefficients: root })
    }

    /// Needs a constant term that is not zero: `q c r' = c' r`.
    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        let c = &self.coefficients;
        let share = c[0].rational(&Rational::new(1.into(), degree.into()));
        self.by_recurrence(c[0].root(degree)?, |r, n| {
            let whole = Series::of_derivative(c, r, n, n) * &share;
            (whole - Series::of_derivative(r, c, n, n - 1)).over(&c[0])
        })
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        let c = &self.coefficients;
        self.by_recurrence(c[0].exp()?, |e, n| Ok(Series::of_derivative(c, e, n, n)))
    }

    /// `c l' = c'`.
    fn ln(&self) -> Result<Self, ArithmeticError> {
        let c = &self.coefficients;
        self.by_recurrence(c[0].ln()?, |l, n| {
            let whole = c[n].integer(n as i64) * &c[n];
            (whole - Series::of_derivative(l, c, n, n - 1)).over(&c[0])
        })
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        Ok(self.pair(self.coefficients[0].sin_cos()?, -1))
    }

    /// `(1 + c²) a' = c'`.
    fn atan(&self) -> Result<Self, ArithmeticError> {
        let c = &self.coefficients;
        let around = self.square() + self.one();
        self.by_recurrence(c[0].atan()?, |a, n| {
            let whole = c[n].integer(n as i64) * &c[n];
            (whole - Series::of_derivative(a, &around.coefficients, n, n - 1)).over(&around.coefficients[0])
        })
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        Ok(self.pair(self.coefficients[0].sinh_cosh()?, 1))
    }
}

impl<T: Real> Real for Series<T> {
    fn pi(&self) -> Self {
        Series::constant(self.coefficients[0].pi(), self.coefficients.len())
    }
}

impl<T: Ring + Signed> Signed for Series<T> {
    /// The sign of the sum for all small `h`, where the constant term tells it; zero where all terms are.
    fn sign(&self) -> Option<Sign> {
        match self.coefficients[0].sign()? {
            Sign::Zero if self.coefficients.iter().any(|c| c.sign() != Some(Sign::Zero)) => None,
            sign => Some(sign),
        }
    }

    fn side(&self) -> Option<Sign> {
        self.sign().or_else(|| self.coefficients[0].side().filter(|side| *side != Sign::Zero))
    }
}
