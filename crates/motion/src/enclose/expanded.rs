//! A scalar: a polynomial in the time and the start with a bound of the distance from it (a Taylor model). What is measured on an enclosed motion is computed in it,
//! so that what cancels in the measure cancels.

use super::bound::Bound;
use super::errors::{UNIT, lost, slope_of, start_error};
use super::expansion::composed;
use super::shape::Shape;
use super::tape::{Kind, value_of};
use arithmetic::{ArithmeticError, Field, FloatInterval, Number, Rational, Real, Ring, Sign, Signed};
use std::sync::Arc;

/// All numbers within `error` of a polynomial in variables from -1 to 1.
#[derive(Debug, Clone)]
pub struct Expanded {
    shape: Arc<Shape>,
    coefficients: Vec<f64>,
    error: Bound,
}

/// Intervals narrower than this, relative to the number, are no variables of their own.
const NARROW: f64 = 1e-12;

/// Most variables of a start; further numbers are enclosed alone.
pub(super) const MOST_VARIABLES: usize = 12;

fn is_wide(x: &FloatInterval) -> bool {
    x.width() > NARROW * x.magnitude().max(1e-300) && x.is_bounded()
}

/// The degree of the polynomials in so many variables that is the best bargain.
pub(super) fn degree_of(variables: usize) -> usize {
    match variables {
        0 => 0,
        1 | 2 => 8,
        3 => 6,
        4 => 5,
        5..=8 => 4,
        _ => 2,
    }
}

/// Parts of the cube on which the polynomial is bounded.
const PARTS: usize = 48;

/// As much of the width as is left to chance.
const SLACK: f64 = 0.02;

impl Expanded {
    /// Everything in an interval.
    pub(super) fn of_interval(shape: &Arc<Shape>, x: FloatInterval) -> Self {
        let mut coefficients = vec![0.0; shape.size()];
        coefficients[0] = x.midpoint();
        let error = Bound::of((x - FloatInterval::point(coefficients[0])).magnitude());
        Expanded { shape: shape.clone(), coefficients, error }
    }

    /// Numbers in a box, with nothing known of them but that.
    pub fn of_box(state: &[FloatInterval]) -> Vec<Self> {
        let shape = Arc::new(Shape::new(0, 0));
        state.iter().map(|x| Expanded::of_interval(&shape, *x)).collect()
    }

    /// The numbers of a start in a box: each one that is wide is a variable of its own, the widest first.
    pub fn of_start(state: &[FloatInterval]) -> Vec<Self> {
        let wide = state.iter().filter(|x| is_wide(x)).count().min(MOST_VARIABLES);
        Expanded::with_degree(state, degree_of(wide))
    }

    /// The same with polynomials of this degree.
    pub fn with_degree(state: &[FloatInterval], degree: usize) -> Vec<Self> {
        let mut wide: Vec<usize> = (0..state.len()).filter(|&i| is_wide(&state[i])).collect();
        wide.sort_by(|i, j| state[*j].width().total_cmp(&state[*i].width()).then(i.cmp(j)));
        wide.truncate(MOST_VARIABLES);
        let shape = Arc::new(Shape::new(wide.len(), degree));
        let number = |(i, x): (usize, &FloatInterval)| match wide.iter().position(|k| *k == i) {
            None => Expanded::of_interval(&shape, *x),
            Some(variable) => {
                let centre = x.midpoint();
                Expanded::variable(&shape, variable, centre, (*x - FloatInterval::point(centre)).magnitude())
            }
        };
        state.iter().enumerate().map(number).collect()
    }

    /// `centre + radius s` for one of the variables.
    pub(super) fn variable(shape: &Arc<Shape>, variable: usize, centre: f64, radius: f64) -> Self {
        let mut own = Expanded::of_interval(shape, FloatInterval::point(centre));
        own.coefficients[1 + variable] = radius;
        own
    }

    /// A polynomial in this shape.
    pub(super) fn of_polynomial(shape: &Arc<Shape>, coefficients: Vec<f64>) -> Self {
        Expanded { shape: shape.clone(), coefficients, error: Bound::ZERO }
    }

    /// With a larger distance.
    pub(super) fn widened(mut self, error: Bound) -> Self {
        self.error = self.error + error;
        self
    }

    /// The polynomial and the distance from it.
    pub(super) fn parts(&self) -> (&Arc<Shape>, &[f64], f64) {
        (&self.shape, &self.coefficients, self.error.value())
    }

    /// Encloses it for one value of the variables.
    pub fn at(&self, variables: &[f64]) -> FloatInterval {
        self.around(self.shape.value(&self.coefficients, variables))
    }

    fn boxed(&self, x: FloatInterval) -> Self {
        Expanded::of_interval(&self.shape, x)
    }

    fn around(&self, x: FloatInterval) -> FloatInterval {
        x + FloatInterval::between(-self.error.value(), self.error.value())
    }

    /// An enclosure of all its numbers at no great cost.
    pub fn natural(&self) -> FloatInterval {
        self.around(self.shape.range(&self.coefficients))
    }

    /// An enclosure of all its numbers, by dividing the cube of the variables where that helps.
    pub fn range(&self) -> FloatInterval {
        let mut parts = vec![Part::of(&self.shape, self.coefficients.clone(), Bound::ZERO)];
        // Ends of both kinds that no part of the cube needs to be looked at again for.
        let (mut done_lo, mut done_hi) = (f64::INFINITY, f64::NEG_INFINITY);
        for _ in 0..PARTS {
            let lowest = parts.iter().fold(done_lo, |lo, part| lo.min(part.range.lo()));
            let highest = parts.iter().fold(done_hi, |hi, part| hi.max(part.range.hi()));
            let slack = SLACK * (highest - lowest);
            // The part with the most to gain at an end of the whole.
            let gain = |part: &Part| {
                let at_an_end = part.range.lo() < lowest + slack || part.range.hi() > highest - slack;
                if at_an_end { part.curved } else { 0.0 }
            };
            let best = (0..parts.len()).max_by(|i, j| gain(&parts[*i]).total_cmp(&gain(&parts[*j])).then(j.cmp(i)));
            let Some(best) = best.filter(|k| gain(&parts[*k]) > slack) else { break };
            let part = parts.swap_remove(best);
            match part.halves(&self.shape) {
                Some(halves) => parts.extend(halves),
                None => (done_lo, done_hi) = (done_lo.min(part.range.lo()), done_hi.max(part.range.hi())),
            }
        }
        let lo = parts.iter().fold(done_lo, |lo, part| lo.min(part.range.lo()));
        let hi = parts.iter().fold(done_hi, |hi, part| hi.max(part.range.hi()));
        self.around(FloatInterval::between(lo, hi))
    }

    /// The absolute value.
    pub fn size(&self) -> Self {
        match self.sign() {
            Some(Sign::Negative) => -self.clone(),
            Some(_) => self.clone(),
            None => self.boxed(FloatInterval::between(0.0, self.range().magnitude())),
        }
    }

    /// The larger of two numbers: one of the two where it is certain which.
    pub fn greater(&self, other: &Self) -> Self {
        match (self.clone() - other).sign() {
            Some(Sign::Negative) => other.clone(),
            Some(_) => self.clone(),
            None => {
                let (a, b) = (self.range(), other.range());
                self.boxed(FloatInterval::between(a.lo().max(b.lo()), a.hi().max(b.hi())))
            }
        }
    }

    fn norms(&self) -> Vec<Bound> {
        self.shape.norms(&self.coefficients).collect()
    }

    fn combined(a: &Self, b: &Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let coefficients: Vec<f64> = a.coefficients.iter().zip(&b.coefficients).map(|(x, y)| f(*x, *y)).collect();
        let error = a.error + b.error + Bound::total(coefficients.iter().copied()) * UNIT;
        Expanded { shape: a.shape.clone(), coefficients, error }
    }

    fn times(a: &Self, b: &Self) -> Self {
        let mut coefficients = vec![0.0; a.shape.size()];
        a.shape.multiply_add(&a.coefficients, &b.coefficients, &mut coefficients);
        let (p, q) = (a.norms(), b.norms());
        let [whole, other] = [&p, &q].map(|norms| norms.iter().copied().sum::<Bound>());
        let inherited = whole * b.error + other * a.error + a.error * b.error;
        let error = inherited + lost(&p, &q, 1, a.shape.degree);
        Expanded { shape: a.shape.clone(), coefficients, error }
    }

    /// A function, as a polynomial or as an interval, whichever is narrower.
    fn applied(&self, kind: Kind) -> Result<Self, ArithmeticError> {
        let argument = self.natural();
        let plain = value_of(kind, &argument).map(|value| (value, self.boxed(value)));
        let expanded = || -> Result<Self, ArithmeticError> {
            let (value, _) = plain.clone()?;
            let coefficients = composed(&self.shape, kind, &self.coefficients)?;
            let far = start_error(&self.shape, kind, (&self.coefficients, &coefficients))?;
            let error = far + self.error * slope_of(kind, argument, value)?;
            Ok(Expanded { shape: self.shape.clone(), coefficients, error })
        };
        match (expanded(), &plain) {
            (Ok(found), Ok((_, plain))) if found.error < plain.error => Ok(found),
            (_, Ok((_, plain))) => Ok(plain.clone()),
            // Once more with better bounds of the argument.
            (_, Err(_)) => value_of(kind, &self.range()).map(|value| self.boxed(value)),
        }
    }
}

/// A part of the cube with the polynomial in variables of its own from -1 to 1.
struct Part {
    coefficients: Vec<f64>,
    error: Bound,
    range: FloatInterval,
    /// The sum of the absolute coefficients that are not linear.
    curved: f64,
}

impl Part {
    fn of(shape: &Shape, coefficients: Vec<f64>, error: Bound) -> Self {
        let around = FloatInterval::between(-error.value(), error.value());
        let range = shape.range(&coefficients) + around;
        let curved =
            coefficients[1 + shape.variables.min(coefficients.len() - 1)..].iter().fold(0.0, |s, x| s + x.abs());
        Part { coefficients, error, range, curved }
    }

    /// Its halves along the variable in which it is curved most.
    fn halves(&self, shape: &Shape) -> Option<[Part; 2]> {
        let mut curved = vec![0.0; shape.variables];
        for (c, exponents) in self.coefficients.iter().zip(&shape.exponents).skip(1 + shape.variables) {
            curved.iter_mut().zip(exponents).for_each(|(sum, e)| *sum += c.abs() * f64::from(*e));
        }
        let variable = (0..curved.len()).max_by(|i, j| curved[*i].total_cmp(&curved[*j]).then(j.cmp(i)))?;
        // Each coefficient of a half is a sum of at most d + 1 products, and each term goes to coefficients whose absolute values add up to its own.
        let rounding = Bound::total(self.coefficients.iter().copied()) * ((shape.degree + 4) as f64 * UNIT);
        let error = self.error + rounding + Bound::UNDERFLOW;
        Some([-1.0, 1.0].map(|side| Part::of(shape, shape.half(&self.coefficients, variable, side), error)))
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident $function:expr),*) => {$(
        impl std::ops::$trait<&Expanded> for Expanded {
            type Output = Expanded;
            fn $method(self, right: &Expanded) -> Expanded {
                $function(&self, right)
            }
        }
        impl std::ops::$trait for Expanded {
            type Output = Expanded;
            fn $method(self, right: Expanded) -> Expanded {
                $function(&self, &right)
            }
        }
    )*};
}

operators!(
    Add add |a, b| Expanded::combined(a, b, |x, y| x + y),
    Sub sub |a, b| Expanded::combined(a, b, |x, y| x - y),
    Mul mul Expanded::times
);

impl std::ops::Neg for Expanded {
    type Output = Expanded;
    fn neg(mut self) -> Expanded {
        self.coefficients.iter_mut().for_each(|x| *x = -*x);
        self
    }
}

impl Ring for Expanded {
    fn integer(&self, n: i64) -> Self {
        self.boxed(FloatInterval::ZERO.integer(n))
    }
}

impl Field for Expanded {
    fn rational(&self, q: &Rational) -> Self {
        self.boxed(FloatInterval::from_rational(q))
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        self.applied(Kind::Reciprocal)
    }
}

impl Signed for Expanded {
    fn sign(&self) -> Option<Sign> {
        self.natural().sign().or_else(|| self.range().sign())
    }

    fn absolute(&self) -> Result<Self, ArithmeticError> {
        Ok(self.size())
    }

    fn larger(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(self.greater(other))
    }

    fn smaller(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(-(-self.clone()).greater(&-other.clone()))
    }
}

impl Number for Expanded {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(self.boxed(FloatInterval::ZERO.pi()))
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        self.applied(Kind::Root)
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        self.applied(Kind::Exponential)
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        self.applied(Kind::Logarithm)
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        Ok((self.applied(Kind::Sine)?, self.applied(Kind::Cosine)?))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        self.applied(Kind::ArcTangent)
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        Ok((self.applied(Kind::HyperbolicSine)?, self.applied(Kind::HyperbolicCosine)?))
    }
}
