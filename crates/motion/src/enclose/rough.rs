//! Boxes that contain the solution on a whole step.

use super::IntervalVector;
use arithmetic::{ArithmeticError, FloatInterval};

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
