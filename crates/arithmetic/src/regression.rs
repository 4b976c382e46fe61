//! The least-squares line.

use super::{ArithmeticError, Field};

/// Slope and intercept of the least-squares line through points `(x, y)`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] for fewer than two different abscissas.
pub fn regression_line<T: Field>(points: &[(T, T)]) -> Result<(T, T), ArithmeticError> {
    let Some((first, _)) = points.first() else { return Err(ArithmeticError::DivisionByZero) };
    let mean = |part: &dyn Fn(&(T, T)) -> T| {
        let sum = points.iter().fold(first.zero(), |sum, point| sum + part(point));
        sum * first.ratio(1, points.len() as i64)
    };
    let (x_mean, y_mean) = (mean(&|p| p.0.clone()), mean(&|p| p.1.clone()));
    let (mut above, mut below) = (first.zero(), first.zero());
    for (x, y) in points {
        let dx = x.clone() - &x_mean;
        above = above + dx.clone() * (y.clone() - &y_mean);
        below = below + dx.square();
    }
    let slope = above.over(&below)?;
    Ok((slope.clone(), y_mean - slope * x_mean))
}
