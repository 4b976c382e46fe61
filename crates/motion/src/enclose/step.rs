//! One step, and steps with a chosen length.

use super::bound::{Bound, values};
use super::errors::{TINY, UNIT};
use super::expanded::Expanded;
use super::expansion::{Expansion, range};
use super::linear::IntervalMatrix;
use super::set::{Set, longest_edge};
use super::shape::Shape;
use super::tape::{Derivatives, Tape};
use super::variation::Variation;
use super::{IntervalVector, ValidationError};
use crate::System;
use arithmetic::{ArithmeticError, Field, FloatInterval, Ring};
use std::sync::Arc;

/// Powers of time of an expansion from one state.
const ORDER: usize = 20;

/// Powers of time of an expansion from a set.
const ORDER_OF_SETS: usize = 12;

/// Largest part of an expansion that is cut off, relative to the size of the state.
const CUT: f64 = 1e-17;

/// The same relative to the width of the set.
const CUT_OF_SETS: f64 = 1e-9;

/// Steps are not made shorter than this part of the time.
const SHORTEST: f64 = 1e-9;

/// Powers of time of the derivative of the flow, which multiplies the parallelepiped around the expansion.
const ORDER_OF_DERIVATIVE: usize = 9;

/// The degree of the derivative of the flow in the variables of the start.
const DEGREE_OF_DERIVATIVE: usize = 2;

/// Attempts to bound the distance from the expansion.
const ATTEMPTS: usize = 6;

/// A flow that is followed in validated steps.
#[derive(Debug, Clone)]
pub struct Flow<L> {
    law: L,
    length: f64,
    written: Option<Written>,
}

/// The right-hand side as it was written down, alone and with its derivatives.
#[derive(Debug, Clone)]
struct Written {
    tape: Tape,
    extended: Tape,
    derivatives: Derivatives,
}

impl Written {
    fn of(law: &impl System, time: FloatInterval, over: &[FloatInterval]) -> Result<Self, ArithmeticError> {
        let tape = Tape::of(law, time, over)?;
        let (extended, derivatives) = tape.differentiated(over.len());
        Ok(Written { tape, extended, derivatives })
    }
}

/// A step: the solutions from a set, over some time.
#[derive(Debug, Clone)]
pub struct Step {
    shape: Arc<Shape>,
    /// Polynomials in the time of the step, from 0 to 1, and in the start.
    expansion: Vec<Vec<f64>>,
    /// Bounds of the distance of each number from its polynomial.
    distances: Vec<Bound>,
    /// The time at its end.
    pub until: f64,
    /// The time it takes, an enclosure of the difference of two floats.
    pub span: FloatInterval,
    /// The set at its end.
    pub end: Set,
    /// Whether the set at its beginning was put into new variables.
    pub is_renewed: bool,
}

impl Step {
    /// A part of the step on the scale of the expansion, from 0 to 1.
    fn during(&self, after: FloatInterval) -> FloatInterval {
        let whole = FloatInterval::between(0.0, 1.0);
        after.over(&self.span).ok().and_then(|part| part.intersection(&whole)).unwrap_or(whole)
    }

    /// All states after some part of the step: `after` lies between 0 and the span.
    pub fn states(&self, after: FloatInterval) -> IntervalVector {
        let during = self.during(after);
        let around = |d: &Bound| FloatInterval::between(-d.value(), d.value());
        self.expansion.iter().zip(&self.distances).map(|(p, d)| range(&self.shape, p, during) + around(d)).collect()
    }

    /// All states after some part of the step, as polynomials in the time and the start.
    pub fn expanded(&self, after: FloatInterval) -> Vec<Expanded> {
        let (during, timed, size) = (self.during(after), self.shape.timed(), self.shape.size());
        let middle = during.midpoint();
        let radius = (during - FloatInterval::point(middle)).magnitude();
        let time = Expanded::variable(&timed.shape, self.shape.variables, middle, radius);
        let lifted = |part: &[f64]| {
            let mut own = vec![0.0; timed.shape.size()];
            part.iter().zip(&timed.places).for_each(|(c, place)| own[*place] = *c);
            Expanded::of_polynomial(&timed.shape, own)
        };
        let number = |(p, distance): (&Vec<f64>, &Bound)| {
            let sum = p.rchunks_exact(size).map(lifted).reduce(|sum, part| time.clone() * &sum + part);
            sum.unwrap_or_else(|| time.zero()).widened(*distance)
        };
        self.expansion.iter().zip(&self.distances).map(number).collect()
    }

    /// The states after some part of the step for one value of the variables of the set that it began with.
    pub fn states_at(&self, variables: &[f64], after: FloatInterval) -> IntervalVector {
        let (during, size) = (self.during(after), self.shape.size());
        let value = |p: &Vec<f64>| {
            let parts = p.rchunks_exact(size).map(|part| self.shape.value(part, variables));
            parts.fold(FloatInterval::ZERO, |sum, part| sum * during + part)
        };
        let around = |d: &Bound| FloatInterval::between(-d.value(), d.value());
        self.expansion.iter().zip(&self.distances).map(|(p, d)| value(p) + around(d)).collect()
    }

    /// Coordinate `i` less coordinate `j` after some part of the step: narrower than the difference of [`Self::states`], since both are
    /// taken at the same time and for the same start.
    pub fn difference(&self, i: usize, j: usize, after: FloatInterval) -> FloatInterval {
        let (p, q) = (&self.expansion[i], &self.expansion[j]);
        let difference: Vec<f64> = p.iter().zip(q).map(|(x, y)| x - y).collect();
        let rounding = Bound::total(difference.iter().copied()) * UNIT;
        let around = (self.distances[i] + self.distances[j] + rounding).value();
        range(&self.shape, &difference, self.during(after)) + FloatInterval::between(-around, around)
    }
}

impl<L: System> Flow<L> {
    /// A flow; the first step tried has the given length.
    pub fn new(law: L, length: f64) -> Self {
        Flow { law, length, written: None }
    }

    /// A step from a set at `time`, as long as what is cut off stays small, and not beyond `until`.
    ///
    /// # Errors
    /// [`ValidationError`].
    pub fn step(&mut self, from: &Set, time: f64, until: f64) -> Result<Step, ValidationError> {
        let is_point = from.shape.variables == 0;
        let renewed = from.renewed();
        let from = renewed.as_ref().unwrap_or(from);
        let order = if is_point { ORDER } else { ORDER_OF_SETS };
        let hull = from.hull();
        let size = hull.iter().fold(1.0, |most: f64, x| most.max(x.magnitude()));
        let width = longest_edge(&hull);
        let aim = if is_point { CUT * size } else { (CUT_OF_SETS * width).max(CUT * size) };
        let mut length = self.length;
        loop {
            let next = if time + 1.01 * length >= until { until } else { time + length };
            match self.attempt(from, order, (time, next)) {
                Ok(Some((step, last))) => {
                    let factor = (aim / last.max(1e-300)).powf(1.0 / (order - 1) as f64) * 0.9;
                    if factor < 0.8 {
                        length = (next - time) * factor.max(0.1);
                    } else {
                        if next < until || factor < 1.0 {
                            self.length = (next - time) * factor.min(2.0);
                        }
                        return Ok(Step { is_renewed: renewed.is_some(), ..step });
                    }
                }
                Ok(None) => length = (next - time) / 2.0,
                Err(reason) if length <= SHORTEST => return Err(ValidationError::Law { time, reason }),
                Err(_) => length = (next - time) / 4.0,
            }
            if length.is_nan() || length < SHORTEST * time.abs().max(1e-3) {
                return Err(ValidationError::Step(time));
            }
        }
    }

    /// A step to `next` exactly, with the size of what is cut off; `None` where no bounds were found.
    fn attempt(
        &mut self,
        from: &Set,
        order: usize,
        (time, next): (f64, f64),
    ) -> Result<Option<(Step, f64)>, ArithmeticError> {
        let span = FloatInterval::point(next) - FloatInterval::point(time);
        let (length, slack) = (span.midpoint(), Bound::of(span.width()));
        let begin = FloatInterval::point(time);
        let written = match self.written.take() {
            Some(written) if !written.tape.branches => written,
            _ => Written::of(&self.law, begin, &from.hull())?,
        };
        let expansion = Expansion::new(&written.tape, &from.shape, order, &from.polynomials, (time, length))?;
        let mut inputs = vec![Bound::ZERO; from.dimension()];
        inputs.push(slack);
        let errors = expansion.errors(&inputs)?;
        let defects = expansion.defects(&errors, length, slack);
        let found = self.bounded(&written, &expansion, from, &defects, (begin, span));
        let (last, state) = (expansion.last(), expansion.state);
        self.written = Some(written);
        let Some((distances, end)) = found? else { return Ok(None) };
        let mut expansion = state;
        expansion.pop();
        Ok(Some((
            Step { shape: from.shape.clone(), expansion, distances, until: next, span, end, is_renewed: false },
            last,
        )))
    }

    /// Bounds of the distance of the solutions from the expansion on the step, and the set at its end. The distance `e` satisfies `e' = h A e - d`, where `A` lies
    /// between the derivatives of the right-hand side on all states between, and `d` is the defect. As long as the bound that follows from a larger one is
    /// smaller than that, no solution leaves it.
    fn bounded(
        &self,
        written: &Written,
        expansion: &Expansion,
        from: &Set,
        defects: &[Bound],
        (begin, span): (FloatInterval, FloatInterval),
    ) -> Result<Option<(Vec<Bound>, Set)>, ArithmeticError> {
        let (time, length) = (begin.midpoint(), span.midpoint());
        // Derivatives of a lower degree: what the polynomials have beyond it counts as distance.
        let shape = Shape::new(from.shape.variables, DEGREE_OF_DERIVATIVE.min(from.shape.degree));
        let start: Vec<Vec<f64>> = from.polynomials.iter().map(|p| p[..shape.size()].to_vec()).collect();
        let slopes = Expansion::new(&written.extended, &shape, ORDER_OF_DERIVATIVE, &start, (time, length))?;
        let slack = Bound::of(span.width());
        let beyond: Vec<Bound> = (0..from.dimension()).map(|i| expansion.distance_of(&slopes, i)).collect();
        let variation = Variation::new(&shape, ORDER_OF_DERIVATIVE, (&slopes, &written.derivatives), (length, slack));
        let before = from.rest.radii();
        let first: Vec<Bound> = before.iter().zip(defects).map(|(x, y)| Bound::of(*x) + *y + TINY).collect();
        let mut tried: Vec<Bound> = first.iter().map(|x| *x * 2.0).collect();
        for _ in 0..ATTEMPTS {
            if written.tape.branches && !self.is_valid(written, expansion, &tried, (begin, span))? {
                return Ok(None);
            }
            let mut inputs: Vec<Bound> = tried.iter().zip(&beyond).map(|(x, y)| *x + *y).collect();
            inputs.push(slack);
            let errors = slopes.errors(&inputs)?;
            let most = magnitudes(&slopes, &errors, &written.derivatives, span.magnitude());
            let growth = |x: &[Bound]| exponential_of(&most, x);
            let Some(found) = growth(&first) else { return Ok(None) };
            if found.iter().zip(&tried).all(|(x, bound)| x < bound) {
                let Some(derivative) = variation.enclosed(&errors, growth) else { return Ok(None) };
                let Some(added) = growth(defects) else { return Ok(None) };
                return Ok(end_of(expansion, from, &derivative, &added).map(|end| (found, end)));
            }
            tried = found.iter().map(|x| *x * 2.0 + TINY).collect();
        }
        Ok(None)
    }

    /// Whether the right-hand side is the one that was written down on all states at these distances from the expansion.
    fn is_valid(
        &self,
        written: &Written,
        expansion: &Expansion,
        distances: &[Bound],
        (begin, span): (FloatInterval, FloatInterval),
    ) -> Result<bool, ArithmeticError> {
        let whole = FloatInterval::between(0.0, 1.0);
        let around =
            |(i, d): (usize, &Bound)| expansion.range(i, whole) + FloatInterval::between(-d.value(), d.value());
        let states: IntervalVector = distances.iter().enumerate().map(around).collect();
        Ok(Tape::of(&self.law, begin + span * whole, &states)? == written.tape)
    }
}

/// Bounds of the derivatives of the right-hand side times the length of the step.
fn magnitudes(slopes: &Expansion, errors: &[Bound], derivatives: &Derivatives, length: f64) -> Vec<Vec<Bound>> {
    let row = |row: &Vec<(usize, usize)>| {
        let mut all = vec![Bound::ZERO; derivatives.len()];
        row.iter().for_each(|&(j, id)| all[j] = Bound::of(slopes.whole(id, errors[id]).magnitude()) * length);
        all
    };
    derivatives.iter().map(row).collect()
}

/// A bound of `e^M x` for a matrix and a vector that are not negative, where the norm of the exponent is at most 1.
fn exponential_of(matrix: &[Vec<Bound>], x: &[Bound]) -> Option<Vec<Bound>> {
    const TERMS: u32 = 6;
    let most = |list: &[Bound]| list.iter().copied().fold(Bound::ZERO, Bound::max);
    let norm = most(&matrix.iter().map(|row| row.iter().copied().sum()).collect::<Vec<_>>());
    // Also where it is not a number.
    if norm.value().is_nan() || norm.value() > 1.0 {
        return None;
    }
    let (mut sum, mut term) = (x.to_vec(), x.to_vec());
    for k in 1..=TERMS {
        term = matrix.iter().map(|row| Bound::dot(row, &term).over(f64::from(k))).collect();
        sum.iter_mut().zip(&term).for_each(|(s, t)| *s = *s + *t);
    }
    // The next terms are at most the largest number of the last one times norm/7, norm²/(7 * 8) and so on, less than norm/6 all together.
    let rest = (most(&term) * norm).over(f64::from(TERMS));
    sum.iter_mut().for_each(|s| *s = *s + rest);
    sum.iter().all(|s| s.is_finite()).then_some(sum)
}

/// The set at the end of a step.
fn end_of(expansion: &Expansion, from: &Set, derivative: &IntervalMatrix, added: &[Bound]) -> Option<Set> {
    let size = from.shape.size();
    let (mut polynomials, mut radii) = (Vec::new(), Vec::new());
    for (series, added) in expansion.state.iter().zip(added) {
        // The smallest terms first: each sum is rounded by half a step of its own.
        let (mut sum, mut slack) = (vec![0.0; size], Bound::ZERO);
        for part in series.rchunks_exact(size) {
            sum.iter_mut().zip(part).for_each(|(s, c)| *s += c);
            slack = slack + Bound::total(sum.iter().copied()) * UNIT;
        }
        radii.push(*added + slack);
        polynomials.push(sum);
    }
    Some(Set { shape: from.shape.clone(), polynomials, rest: from.rest.mapped(derivative, &values(&radii))? })
}
