//! Motions under linear laws in closed form, and the instants at which all of their state is known exactly: so that is decided what happens at one instant only.

use algebra::matrix::solve_over_field;
use arithmetic::{
    ArithmeticError, Complex, Field, Interval, Number, PreciseNumber, Rational, RealNumber, Ring, rational,
    simplest_between,
};
use motion::System;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::Zero;
use polynomials::univariate::Polynomial;
use polynomials::{Extension, Side, Symbolic};
use std::collections::BTreeMap;

/// A motion `sum t^j e^(at) cos(wt) c`, or with sines, with rational `a`, `w` and vectors `c`.
pub(super) struct ClosedForm {
    terms: Vec<Term>,
    /// All exponents `a` are multiples of this; 0 if there are none.
    growth: Rational,
    /// All frequencies `w` are multiples of this; 0 if there are none.
    turning: Rational,
}

/// `t^power` times the real part of `e^((rate + i turn) t)`, or its imaginary part.
struct Term {
    power: u64,
    exponent: Complex<Rational>,
    is_imaginary: bool,
    vector: Vec<Rational>,
}

/// A time, with what is known exactly at it.
struct Instant {
    time: PreciseNumber,
    /// `e^(growth t)`, where it is rational.
    growth: Option<Rational>,
    /// `e^(i turning t)`, where it is algebraic.
    turned: Option<Complex<PreciseNumber>>,
}

/// A vector, and how it is combined from the derivatives before.
type Reduced = (Vec<Rational>, Vec<Rational>);

impl ClosedForm {
    /// The motion from a start; nothing where the law is not linear with constant coefficients, or an exponent is not rational.
    pub fn of(law: &impl System, start: &[Rational]) -> Option<Self> {
        let extension = Extension::new(start.len() + 1);
        let mut arguments = extension.arguments();
        let time = arguments.pop()?;
        let rates = law.rate(&time, &arguments).ok()?;
        let rows: Vec<(Vec<Rational>, Rational)> = rates.iter().map(|rate| rate.affine()).collect::<Option<_>>()?;
        if rows.len() != start.len() || rows.iter().any(|(slopes, _)| slopes.last().is_none_or(|c| !c.is_zero())) {
            return None;
        }
        let (derivatives, polynomial) = derivatives(&rows, start);
        let mut terms = Vec::new();
        for (exponent, times) in exponents(&polynomial)? {
            for power in 0..times as u64 {
                for is_imaginary in [false, true].into_iter().take(if exponent.im.is_zero() { 1 } else { 2 }) {
                    terms.push(Term { power, exponent: exponent.clone(), is_imaginary, vector: Vec::new() });
                }
            }
        }
        if terms.len() != derivatives.len() {
            return None;
        }
        for place in 0..start.len() {
            let row = |(order, own): (u64, &Vec<Rational>)| {
                let values = terms.iter().map(|term| term.derivative(order));
                values.chain([own[place].clone()]).collect()
            };
            let found = solve_over_field((0..).zip(&derivatives).map(row).collect()).ok()?;
            terms.iter_mut().zip(found).for_each(|(term, c)| term.vector.push(c));
        }
        let unit = |part: fn(&Term) -> &Rational| terms.iter().map(part).fold(rational(0, 1), |a, b| common(&a, b));
        let (growth, turning) = (unit(|term| &term.exponent.re), unit(|term| &term.exponent.im));
        Some(ClosedForm { terms, growth, turning })
    }

    /// States at instants from one time to a later one, each with times between which it is: at the simplest time, the simplest value of the exponential, the simplest
    /// angle as a part of pi, and the simplest tangent of half an angle.
    pub fn states(
        &self,
        from: &Rational,
        to: &Rational,
        precision: u32,
    ) -> Vec<(Rational, Rational, Vec<PreciseNumber>)> {
        let number = |q: &Rational| Interval::from_rational(q, precision);
        let between = RealNumber::interval(Interval::hull_of_rationals(from, to, precision));
        let between = PreciseNumber { number: between, precision };
        let time = simplest_between(from, to);
        let own = Instant { time: PreciseNumber::exact(time.clone(), precision), growth: None, turned: None };
        let mut instants = Vec::new();
        if !self.growth.is_zero() {
            let value = |time: &Rational| Number::exp(&number(&(time * &self.growth)));
            let instant = |growth| Instant { time: between.clone(), growth: Some(growth), turned: None };
            instants.extend(inside(value(from), value(to)).map(instant));
        }
        if !self.turning.is_zero() {
            instants.extend(self.angles(from, to, &between));
        }
        let at = |instant: &Instant| Some((from.clone(), to.clone(), self.at(instant).ok()?));
        let first = self.at(&own).ok().map(|state| (time.clone(), time, state));
        first.into_iter().chain(instants.iter().filter_map(at)).collect()
    }

    fn angles(&self, from: &Rational, to: &Rational, between: &PreciseNumber) -> Vec<Instant> {
        let precision = between.precision;
        let angle = |time: &Rational| Interval::from_rational(&(time * &self.turning), precision);
        let parts = |time: &Rational| angle(time).over(&angle(time).circle()?);
        let part = inside(parts(from), parts(to)).and_then(|part| {
            let angle = PreciseNumber { number: RealNumber::integer(1), precision }.circle().ok()?;
            let angle = angle * PreciseNumber::exact(part, precision);
            let (sine, cosine) = angle.sin_cos().ok()?;
            let time = angle * PreciseNumber::exact(self.turning.recip(), precision);
            Some(Instant { time, growth: None, turned: Some(Complex::new(cosine, sine)) })
        });
        // Of less than half a turn the tangent grows, unless it has a pole there.
        let tangent = |time: &Rational| {
            let (sine, cosine) = (angle(time) * angle(time).ratio(1, 2).over(&angle(time).one())?).sin_cos()?;
            sine.over(&cosine)
        };
        let is_short = (to - from) * &self.turning < rational(3, 2);
        let half = inside(tangent(from), tangent(to)).filter(|_| is_short).map(|u| {
            let size = (u.square() + rational(1, 1)).recip();
            let parts = [rational(1, 1) - u.square(), u * rational(2, 1)].map(|part| part * &size);
            let [cosine, sine] = parts.map(|part| PreciseNumber::exact(part, precision));
            Instant { time: between.clone(), growth: None, turned: Some(Complex::new(cosine, sine)) }
        });
        part.into_iter().chain(half).collect()
    }

    /// The state from one time to a later one as quotients of polynomials in one number, and what that ranges over: the time itself, the exponential if there are no other
    /// functions, or the tangent of half the angle, in the frame turned by half a turn where it has a pole. Nothing where several of them occur.
    pub fn curve(&self, from: &Rational, to: &Rational, precision: u32) -> Option<(Vec<Symbolic>, Side)> {
        let s = Extension::new(1).arguments().pop()?;
        let has_powers = self.terms.iter().any(|term| term.power > 0);
        let whole = |ends: [Interval; 2]| {
            let [a, b] = ends.map(|end| end.to_rationals());
            Side::between(a.0.min(b.0), a.1.max(b.1))
        };
        if self.growth.is_zero() && self.turning.is_zero() {
            return Some((self.summed(&s, |term| Some(s.power(term.power)))?, Side::between(from.clone(), to.clone())));
        }
        if has_powers {
            return None;
        }
        if self.turning.is_zero() {
            let value = |time: &Rational| Number::exp(&Interval::from_rational(&(time * &self.growth), precision)).ok();
            let range = whole([value(from)?, value(to)?]);
            let factor = |term: &Term| {
                let (is_negative, count) = multiple(&term.exponent.re, &self.growth)?;
                let power = s.power(count);
                if is_negative { Field::recip(&power).ok() } else { Some(power) }
            };
            return Some((self.summed(&s, factor)?, range));
        }
        if !self.growth.is_zero() {
            return None;
        }
        let (range, is_turned) = self.half_tangent(from, to, precision)?;
        let size = Field::recip(&(s.square() + s.one())).ok()?;
        let parts = [s.one() - s.square(), s.clone() * s.integer(2)].map(|part| part * &size);
        let [re, im] = if is_turned { parts.map(|part| -part) } else { parts };
        let circle = Complex::new(re, im);
        let factor = |term: &Term| {
            let (_, count) = multiple(&term.exponent.im, &self.turning)?;
            let turned = circle.power(count);
            Some(if term.is_imaginary { turned.im } else { turned.re })
        };
        Some((self.summed(&s, factor)?, range))
    }

    /// The sum of the vectors times these factors.
    fn summed(&self, like: &Symbolic, factor: impl Fn(&Term) -> Option<Symbolic>) -> Option<Vec<Symbolic>> {
        let size = self.terms.first().map_or(0, |term| term.vector.len());
        let mut state = vec![like.zero(); size];
        for term in &self.terms {
            let factor = factor(term)?;
            for (x, c) in state.iter_mut().zip(&term.vector) {
                *x = x.clone() + like.rational(c) * &factor;
            }
        }
        Some(state)
    }

    /// The range of the tangent of half the angle from one time to a later one, less than half a turn after it, where it has no pole there; or of the angle half a turn back.
    fn half_tangent(&self, from: &Rational, to: &Rational, precision: u32) -> Option<(Side, bool)> {
        if (to - from) * &self.turning >= rational(3, 2) {
            return None;
        }
        let range = |is_turned: bool| {
            let end = |time: &Rational| {
                let half = Interval::from_rational(&(time * &self.turning * rational(1, 2)), precision);
                let (sine, cosine) = half.sin_cos().ok()?;
                let quotient = if is_turned { (-cosine).over(&sine) } else { sine.over(&cosine) };
                quotient.ok().map(|quotient| quotient.to_rationals())
            };
            let (a, b) = (end(from)?, end(to)?);
            // Between poles it grows, and beyond one it is smaller.
            let grows = from == to || a.1 < b.0;
            let near = rational(3, 1);
            (grows && a.0 > -near.clone() && b.1 < near).then(|| (Side::between(a.0, b.1), is_turned))
        };
        range(false).or_else(|| range(true))
    }

    /// The state, exact where what it depends on is.
    fn at(&self, instant: &Instant) -> Result<Vec<PreciseNumber>, ArithmeticError> {
        let size = self.terms.first().map_or(0, |term| term.vector.len());
        // What has one exponential in common may vanish although that is not known exactly.
        let mut parts: BTreeMap<Rational, Vec<PreciseNumber>> = BTreeMap::new();
        for term in &self.terms {
            let turned = instant.turned_by(&term.exponent.im, &self.turning)?;
            let factor = instant.time.power(term.power) * if term.is_imaginary { turned.im } else { turned.re };
            let sums = parts.entry(term.exponent.re.clone()).or_insert_with(|| vec![factor.zero(); size]);
            for (sum, c) in sums.iter_mut().zip(&term.vector) {
                *sum = sum.clone() + factor.rational(c) * &factor;
            }
        }
        let mut state = vec![instant.time.zero(); size];
        for (rate, sums) in parts {
            let grown = instant.grown_by(&rate, &self.growth)?;
            state.iter_mut().zip(sums).for_each(|(x, sum)| *x = x.clone() + sum * &grown);
        }
        Ok(state)
    }
}

impl Term {
    /// The derivative of its function at time 0, of that order.
    fn derivative(&self, order: u64) -> Rational {
        let Some(left) = order.checked_sub(self.power) else { return rational(0, 1) };
        let falling = (left + 1..=order).fold(rational(1, 1), |product, k| product * Rational::from_integer(k.into()));
        let power = self.exponent.power(left);
        falling * if self.is_imaginary { power.im } else { power.re }
    }
}

impl Instant {
    /// `e^(rate t)`.
    fn grown_by(&self, rate: &Rational, unit: &Rational) -> Result<PreciseNumber, ArithmeticError> {
        let exact = |q: Rational| PreciseNumber::exact(q, self.time.precision);
        match (&self.growth, multiple(rate, unit)) {
            (_, Some((_, 0))) => Ok(exact(rational(1, 1))),
            (Some(base), Some((is_negative, count))) => {
                let power = base.power(count);
                Ok(exact(if is_negative { Field::recip(&power)? } else { power }))
            }
            _ => (self.time.clone() * exact(rate.clone())).exp(),
        }
    }

    /// `e^(i turn t)`, for a turn that is not negative.
    fn turned_by(&self, turn: &Rational, unit: &Rational) -> Result<Complex<PreciseNumber>, ArithmeticError> {
        let exact = |q: Rational| PreciseNumber::exact(q, self.time.precision);
        match (&self.turned, multiple(turn, unit)) {
            (_, Some((_, 0))) => Ok(Complex::new(exact(rational(1, 1)), exact(rational(0, 1)))),
            (Some(base), Some((_, count))) => Ok(base.power(count)),
            _ => {
                let (sine, cosine) = (self.time.clone() * exact(turn.clone())).sin_cos()?;
                Ok(Complex::new(cosine, sine))
            }
        }
    }
}

/// Whether a number is negative, and which multiple of the unit its size is; 0 is the multiple of any unit.
fn multiple(number: &Rational, unit: &Rational) -> Option<(bool, u64)> {
    if number.is_zero() {
        return Some((false, 0));
    }
    let count = Field::over(number, unit).ok().filter(Rational::is_integer)?.numer();
    Some((count.sign() == num_bigint::Sign::Minus, u64::try_from(count.magnitude()).ok()?))
}

/// The largest rational of which both are integer multiples.
fn common(a: &Rational, b: &Rational) -> Rational {
    let numerator = (a.numer() * b.denom()).gcd(&(b.numer() * a.denom()));
    Rational::new(numerator, a.denom() * b.denom())
}

/// The simplest rational certainly between two enclosed numbers, one way or the other.
fn inside(from: Result<Interval, ArithmeticError>, to: Result<Interval, ArithmeticError>) -> Option<Rational> {
    let (from, to) = (from.ok()?.to_rationals(), to.ok()?.to_rationals());
    if from.1 <= to.0 {
        Some(simplest_between(&from.1, &to.0))
    } else if to.1 <= from.0 {
        Some(simplest_between(&to.1, &from.0))
    } else {
        None
    }
}

/// The start and its derivatives up to the first that depends on those before, and the polynomial of least degree in the derivative that vanishes on the start. The last
/// entry of each is that of the constant 1.
fn derivatives(rows: &[(Vec<Rational>, Rational)], start: &[Rational]) -> (Vec<Vec<Rational>>, Polynomial) {
    let mut found: Vec<Vec<Rational>> = Vec::new();
    let mut basis: Vec<Reduced> = Vec::new();
    let mut next: Vec<Rational> = start.iter().cloned().chain([rational(1, 1)]).collect();
    loop {
        let mut own = (next.clone(), vec![rational(0, 1); found.len()]);
        own.1.push(rational(1, 1));
        for (vector, from) in &basis {
            let Some(place) = vector.iter().position(|x| !x.is_zero()) else { continue };
            let factor = &own.0[place] / &vector[place];
            own.0.iter_mut().zip(vector).for_each(|(x, y)| *x -= &factor * y);
            own.1.iter_mut().zip(from).for_each(|(x, y)| *x -= &factor * y);
        }
        if own.0.iter().all(Zero::is_zero) {
            return (found, Polynomial::from_rationals(&own.1));
        }
        basis.push(own);
        let rate = |(slopes, constant): &(Vec<Rational>, Rational)| {
            let constant = constant * &next[start.len()];
            slopes.iter().take(start.len()).zip(&next).fold(constant, |sum, (a, x)| sum + a * x)
        };
        let after = rows.iter().map(rate).chain([rational(0, 1)]).collect();
        found.push(std::mem::replace(&mut next, after));
    }
}

/// The roots of a polynomial with how often each counts, of two conjugate ones the one above; nothing where a real or imaginary part is not rational, or the pairs of one
/// multiplicity do not have the same real part.
fn exponents(polynomial: &Polynomial) -> Option<Vec<(Complex<Rational>, usize)>> {
    let mut found = Vec::new();
    for (factor, times) in polynomial.square_free_factors() {
        let (real, rest) = rational_roots(&factor)?;
        found.extend(real.into_iter().map(|root| (Complex::real(root), times)));
        let Some((last, before)) = rest.coefficients().split_last().filter(|_| rest.degree() > 0) else { continue };
        let mean = Rational::new(-before.last()?.clone(), last * BigInt::from(rest.degree()));
        let centred = rest.with_roots_moved(&-mean.clone());
        let halves = |first: usize| centred.coefficients().iter().skip(first).step_by(2).cloned();
        if halves(1).any(|c| !c.is_zero()) {
            return None;
        }
        let (squares, left) = rational_roots(&Polynomial::new(halves(0).collect()))?;
        if left.degree() > 0 {
            return None;
        }
        for square in squares {
            let turn = Number::sqrt(&-square).ok()?;
            found.push((Complex::new(mean.clone(), turn), times));
        }
    }
    Some(found)
}

/// The real roots of a polynomial without multiple ones, and what is left without them; nothing if one is irrational.
fn rational_roots(polynomial: &Polynomial) -> Option<(Vec<Rational>, Polynomial)> {
    let largest = polynomial.coefficients().iter().map(|c| c.magnitude().clone()).max()?;
    let bound = Rational::from_integer(BigInt::from(largest) + 1);
    let mut rest = polynomial.clone();
    let mut found = Vec::new();
    for mut root in polynomial.roots_in(&-bound.clone(), &bound) {
        let root = polynomial.rational_root(&mut root)?;
        rest = rest.divided_by(&Polynomial::from_rationals(&[-root.clone(), rational(1, 1)]));
        found.push(root);
    }
    Some((found, rest))
}

#[cfg(test)]
mod tests;
