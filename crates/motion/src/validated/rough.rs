//! Boxes that contain the solution on a whole step.

use super::IntervalVector;
use super::linear::{IntervalMatrix, row_norm, unit_vectors};
use crate::System;
use arithmetic::{ArithmeticError, Dual, FloatInterval};

/// Attempts to widen a box.
const ATTEMPTS: usize = 12;

/// `start + [0, h] F(B)` for a box `B` that has it in its interior, where `F` encloses the right-hand sides on `B`. Every solution
/// from `start` stays in it for the time `h`, also one of a differential inclusion `y' in F(y)`: until a solution leaves `B` it lies in
/// `start + [0, h] F(B)`, so it never gets to the boundary of `B`. `None` where none was found.
///
/// # Errors
/// What `rates` returns for the first box.
pub fn box_of_step(
    start: &[FloatInterval],
    span: FloatInterval,
    rates: impl Fn(&[FloatInterval]) -> Result<IntervalVector, ArithmeticError>,
) -> Result<Option<IntervalVector>, ArithmeticError> {
    let span = span.hull(&FloatInterval::point(0.0));
    let image = |b: &[FloatInterval]| -> Result<IntervalVector, ArithmeticError> {
        Ok(start.iter().zip(rates(b)?).map(|(x, f)| *x + span * f).collect())
    };
    let mut tried = image(start)?;
    for _ in 0..ATTEMPTS {
        tried = tried.iter().map(wider).collect();
        let Ok(next) = image(&tried) else { return Ok(None) };
        if next.iter().any(|x| !x.is_bounded()) {
            return Ok(None);
        }
        if tried.iter().zip(&next).all(|(b, x)| b.lo() < x.lo() && x.hi() < b.hi()) {
            return Ok(Some(next));
        }
        tried = next;
    }
    Ok(None)
}

/// A tenth wider on both sides.
fn wider(x: &FloatInterval) -> FloatInterval {
    let more = 0.1 * x.width() + 1e-12 * x.magnitude() + 1e-300;
    FloatInterval::between(x.lo() - more, x.hi() + more)
}

/// The derivatives `df_i/dy_j` over a box and a stretch of time.
///
/// # Errors
/// Whatever the law returns.
pub(super) fn jacobian(
    law: &impl System,
    time: FloatInterval,
    over: &[FloatInterval],
) -> Result<IntervalMatrix, ArithmeticError> {
    let size = over.len();
    let Some(like) = over.first() else { return Ok(Vec::new()) };
    let mut rows = vec![Vec::with_capacity(size); size];
    for direction in unit_vectors(size, like) {
        let moved: Vec<Dual<FloatInterval>> = over.iter().zip(direction).map(|(x, d)| Dual::new(*x, d)).collect();
        rows.iter_mut().zip(law.rate(&Dual::constant(time), &moved)?).for_each(|(row, rate)| row.push(rate.derivative));
    }
    Ok(rows)
}

/// How far the derivative of the flow is from the identity on a step, at most, in every entry: `V' = A V`, `V(0) = I` gives
/// `‖V - I‖ <= e^a - 1 <= a + a²` with `a = h ‖A‖ <= 1`. `None` for larger ones.
pub(super) fn spread(jacobian: &IntervalMatrix, span: FloatInterval) -> Option<FloatInterval> {
    let a = FloatInterval::point(row_norm(jacobian)) * FloatInterval::point(span.magnitude());
    let bound = (a + a * a).hi();
    (a.hi() <= 1.0).then(|| FloatInterval::between(-bound, bound))
}
