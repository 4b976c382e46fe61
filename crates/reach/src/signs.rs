//! Where a function that is enclosed by a polynomial and a remainder is positive and where negative: roots are narrowed by the interval Newton step, and
//! what stays without a sign is as short as the enclosure allows.

use crate::scalar::Scalar;
use arithmetic::{Rational, Sign, rational};

/// A polynomial, and a bound of its difference from the function on [0, 2].
#[derive(Debug, Clone)]
pub(crate) struct Expansion<T> {
    pub coefficients: Vec<T>,
    pub error: T,
}

/// A part of the domain, in which the function has one sign or an unknown one.
pub(crate) struct Part<T> {
    pub from: Rational,
    pub to: Rational,
    pub sign: Option<Sign>,
    /// The derivative where the sign is not known but the function increases, or decreases, throughout.
    pub slope: Option<T>,
}

/// Halvings before a part is left without a sign.
const DEEPEST: u32 = 60;

impl<T: Scalar> Expansion<T> {
    /// Adds a multiple of another.
    pub fn add(&mut self, other: &Self, factor: &T) -> &mut Self {
        let zero = factor.zero();
        self.coefficients.resize(self.coefficients.len().max(other.coefficients.len()), zero);
        for (x, y) in self.coefficients.iter_mut().zip(&other.coefficients) {
            *x = x.clone() + y.clone() * factor;
        }
        self.error = self.error.clone() + other.error.clone() * factor.magnitude();
        self
    }

    /// The value at a point or over an interval, the argument between 0 and 2.
    fn horner(&self, x: &T) -> T {
        let value = self.coefficients.iter().rev().fold(x.zero(), |sum, c| sum * x + c);
        value + T::symmetric(&self.error)
    }

    /// The derivative of the polynomial; of the function it is another, whose remainder is bounded apart.
    fn derivative(&self, x: &T) -> T {
        let terms = self.coefficients.iter().enumerate().skip(1).rev();
        terms.fold(x.zero(), |sum, (k, c)| sum * x + c.clone() * x.integer(k as i64))
    }

    /// The integral of the function from `a` to `b`.
    pub fn integral(&self, a: &Rational, b: &Rational) -> T {
        let like = &self.error;
        let (x, y) = (like.rational(a), like.rational(b));
        let value = |x: &T| {
            let terms = self.coefficients.iter().enumerate().rev();
            terms.fold(x.zero(), |sum, (k, c)| sum * x + c.clone() * x.ratio(1, k as i64 + 1)) * x
        };
        value(&y) - value(&x) + T::symmetric(&(self.error.clone() * like.rational(&(b - a)).magnitude()))
    }

    /// Everything between two points.
    pub fn over(&self, a: &Rational, b: &Rational) -> T {
        self.horner(&self.error.around(a, b))
    }

    /// The largest absolute value between two points.
    pub fn size(&self, a: &Rational, b: &Rational) -> T {
        self.over(a, b).magnitude()
    }

    /// The sign on all of `[0, end]` of what is off by at most `slack` more, by the sizes of the coefficients.
    pub fn plain_sign(&self, end: f64, slack: f64) -> Option<Sign> {
        let mut power = 1.0;
        let rest: f64 = self.coefficients[1..].iter().fold(0.0, |sum, c| {
            power *= end;
            sum + c.largest() * power
        });
        // Sums of products of so few positive floats are off by far less.
        let rest = (rest + self.error.largest() + slack) * (1.0 + 1e-12) + f64::MIN_POSITIVE;
        let first = &self.coefficients[0];
        match () {
            () if first.lower() > rest => Some(Sign::Positive),
            () if first.upper() < -rest => Some(Sign::Negative),
            () => None,
        }
    }

    /// Whether it is zero throughout.
    pub fn is_zero(&self) -> bool {
        self.error.largest() == 0.0 && self.coefficients.iter().all(|c| c.largest() == 0.0)
    }

    /// Cuts `[0, end]` into parts of one sign.
    pub fn parts(&self, end: &Rational) -> Vec<Part<T>> {
        let mut parts = Vec::new();
        let spread: f64 = self.coefficients.iter().map(|c| c.spread()).sum();
        let noise = 4.0 * (spread + 2.0 * self.error.largest());
        self.cut(rational(0, 1), end.clone(), DEEPEST, noise, &mut parts);
        parts
    }

    fn cut(&self, a: Rational, b: Rational, depth: u32, noise: f64, parts: &mut Vec<Part<T>>) {
        let whole = self.error.around(&a, &b);
        let slope = self.derivative(&whole);
        let middle = (&a + &b) * rational(1, 2);
        let point = self.error.rational(&middle);
        // The mean value is of the polynomial; the remainder is in the value already.
        let value = self.horner(&point) + slope.clone() * (whole - &point) + T::symmetric(&self.error);
        let sign = value.sign().filter(|sign| *sign != Sign::Zero);
        if sign.is_some() || depth == 0 || value.largest() <= noise {
            parts.push(Part { from: a, to: b, sign, slope: None });
        } else if self.error.largest() < slope_margin(&slope) {
            self.narrow(a, b, slope, parts);
        } else {
            self.cut(a, middle.clone(), depth - 1, noise, parts);
            self.cut(middle, b, depth - 1, noise, parts);
        }
    }

    /// Cuts where the polynomial increases, or decreases, throughout: for every function in the enclosure, what lies on either side of all its
    /// possible roots has a sign.
    fn narrow(&self, a: Rational, b: Rational, mut slope: T, parts: &mut Vec<Part<T>>) {
        let rises = slope.lower() > 0.0;
        let (mut left, mut right) = (a.clone(), b.clone());
        loop {
            let middle = (&left + &right) * rational(1, 2);
            let point = self.error.rational(&middle);
            // The sign of polynomial plus a number within the remainder: its root is where the polynomial takes minus that number.
            let Some((low, high)) = self.horner(&point).over(&slope).ok().and_then(|step| (point - step).ends()) else {
                break;
            };
            let (new_left, new_right) =
                (low.clamp(left.clone(), right.clone()), high.clamp(left.clone(), right.clone()));
            let shrinks = (&new_right - &new_left) * rational(4, 3) < &right - &left;
            (left, right) = (new_left, new_right);
            if !shrinks || left == right {
                break;
            }
            slope = self.derivative(&self.error.around(&left, &right));
        }
        let (before, after) = if rises { (Sign::Negative, Sign::Positive) } else { (Sign::Positive, Sign::Negative) };
        if a < left {
            parts.push(Part { from: a, to: left.clone(), sign: Some(before), slope: None });
        }
        if left < right {
            // The derivative of what follows the last coefficient, by its own series.
            let order = self.coefficients.len() as i64 + 1;
            let slope = slope + T::symmetric(&(self.error.clone() * self.error.integer(order)));
            parts.push(Part { from: left.clone(), to: right.clone(), sign: None, slope: Some(slope) });
        }
        if right < b {
            parts.push(Part { from: right, to: b, sign: Some(after), slope: None });
        }
    }
}

/// How far the slope is from zero.
fn slope_margin<T: Scalar>(slope: &T) -> f64 {
    slope.lower().max(-slope.upper())
}
