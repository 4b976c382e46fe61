//! One step, and steps with a chosen width.

use super::linear::{IntervalMatrix, unit_vectors};
use super::rough::{box_of_step, jacobian, spread};
use super::taylor::{coefficients, horner};
use super::{IntervalVector, Parallelepiped, ValidationError};
use crate::System;
use arithmetic::{ArithmeticError, Dual, FloatInterval};

/// Terms of the expansion of the solution.
const ORDER: usize = 14;

/// Terms of the expansion of its derivative by the start. It multiplies the width of the set, so that few will do.
const DERIVATIVE_ORDER: usize = 5;

/// Widest remainder of a step aimed at, relative to the size of the state.
const REMAINDER: f64 = 1e-16;

/// Steps are not made shorter than this part of the time.
const SHORTEST: f64 = 1e-9;

/// A flow that is followed in validated steps.
#[derive(Debug, Clone)]
pub struct Flow<L> {
    law: L,
    length: f64,
}

/// A step: the solutions from a set, over some time.
#[derive(Debug, Clone)]
pub struct Step {
    /// Taylor's coefficients over the whole set, the last ones over the box of the step, coordinate by coordinate.
    expansion: Vec<IntervalVector>,
    /// The time at its end.
    pub until: f64,
    /// The time it takes, an enclosure of the difference of two floats.
    pub span: FloatInterval,
    /// The set at its end.
    pub end: Parallelepiped,
}

impl Step {
    /// All states after some part of the step: `after` lies between 0 and the span.
    pub fn states(&self, after: FloatInterval) -> IntervalVector {
        self.expansion.iter().map(|c| horner(c, &after)).collect()
    }

    /// Coordinate `i` less coordinate `j` after some part of the step: narrower than the difference of [`Self::states`], since both are
    /// taken at the same time.
    pub fn difference(&self, i: usize, j: usize, after: FloatInterval) -> FloatInterval {
        let difference = self.expansion[i].iter().zip(&self.expansion[j]).map(|(a, b)| *a - b);
        horner(&difference.collect::<Vec<_>>(), &after)
    }
}

impl<L: System> Flow<L> {
    /// A flow; the first step tried has the given length.
    pub fn new(law: L, length: f64) -> Self {
        Flow { law, length }
    }

    /// The law.
    pub fn law(&self) -> &L {
        &self.law
    }

    /// A step from a set at `time`, as long as the remainder stays small, and not beyond `until`.
    ///
    /// # Errors
    /// [`ValidationError`].
    pub fn step(&mut self, from: &Parallelepiped, time: f64, until: f64) -> Result<Step, ValidationError> {
        let mut length = self.length;
        loop {
            let next = if time + 1.01 * length >= until { until } else { time + length };
            match self.attempt(from, time, next) {
                Ok(Some((step, remainder))) => {
                    let size = from.centre().iter().fold(1.0, |most: f64, x| most.max(x.abs()));
                    let factor = (REMAINDER * size / remainder.max(1e-300)).powf(1.0 / ORDER as f64) * 0.9;
                    if factor < 0.5 {
                        length = (next - time) * factor.max(0.2);
                    } else {
                        if next < until || factor < 1.0 {
                            self.length = (next - time) * factor.min(1.5);
                        }
                        return Ok(step);
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

    /// A step to `next` exactly, with the width of its remainder; `None` where no box was found.
    fn attempt(&self, from: &Parallelepiped, time: f64, next: f64) -> Result<Option<(Step, f64)>, ArithmeticError> {
        let span = FloatInterval::point(next) - FloatInterval::point(time);
        let (start, begin) = (from.hull(), FloatInterval::point(time));
        let during = begin.hull(&FloatInterval::point(next));
        let Some(around) = box_of_step(&start, span, |b| self.law.rate(&during, b))? else { return Ok(None) };
        let remainder: IntervalVector =
            coefficients(&self.law, &during, &around, ORDER)?.into_iter().map(|c| c[ORDER]).collect();
        let closed = |mut inner: Vec<IntervalVector>| -> Vec<IntervalVector> {
            inner.iter_mut().zip(&remainder).for_each(|(c, last)| c.push(*last));
            inner
        };
        let centre: IntervalVector = from.centre().iter().map(|&x| FloatInterval::point(x)).collect();
        let of_centre = closed(coefficients(&self.law, &begin, &centre, ORDER - 1)?);
        let expansion = closed(coefficients(&self.law, &begin, &start, ORDER - 1)?);
        let image: IntervalVector = of_centre.iter().map(|c| horner(c, &span)).collect();
        let Some(derivative) = self.derivative([&begin, &during], [&start, &around], span)? else { return Ok(None) };
        let Some(end) = from.mapped(&image, &derivative) else { return Ok(None) };
        let power = span.magnitude().powi(ORDER as i32);
        let width = remainder.iter().map(|c| c.magnitude() * power).fold(0.0, f64::max);
        Ok(Some((Step { expansion, until: next, span, end }, width)))
    }

    /// The derivatives of the state after the span by the state before it.
    fn derivative(
        &self,
        [begin, during]: [&FloatInterval; 2],
        [start, around]: [&[FloatInterval]; 2],
        span: FloatInterval,
    ) -> Result<Option<IntervalMatrix>, ArithmeticError> {
        let Some(far) = spread(&jacobian(&self.law, *during, around)?, span) else { return Ok(None) };
        let size = start.len();
        let mut rows: IntervalMatrix = vec![Vec::with_capacity(size); size];
        for direction in unit_vectors(size, &span) {
            let seeded = |state: &[FloatInterval], add: Option<FloatInterval>| -> Vec<Dual<FloatInterval>> {
                let pairs = state.iter().zip(&direction);
                pairs.map(|(x, d)| Dual::new(*x, add.map_or(*d, |far| *d + far))).collect()
            };
            let [begin, during] = [begin, during].map(|t| Dual::constant(*t));
            let inner = coefficients(&self.law, &begin, &seeded(start, None), DERIVATIVE_ORDER - 1)?;
            let rest = coefficients(&self.law, &during, &seeded(around, Some(far)), DERIVATIVE_ORDER)?;
            for ((row, c), last) in rows.iter_mut().zip(inner).zip(rest) {
                let mut c: IntervalVector = c.into_iter().map(|d| d.derivative).collect();
                c.push(last[DERIVATIVE_ORDER].derivative);
                row.push(horner(&c, &span));
            }
        }
        Ok(Some(rows))
    }
}
