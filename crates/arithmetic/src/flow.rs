//! Derivatives along a flow and gradients, by dual numbers: exact wherever the scalar is.

use super::{ArithmeticError, Dual, Ring};

/// The derivative of `potential` at `state` along the vector `velocity`: with `velocity = law(state)` this is the time
/// derivative along the closed loop, so a printed d/dt can be tested against the law itself.
///
/// `state` and `velocity` have the same length; what is missing in the shorter one is left out.
///
/// # Errors
/// Whatever the potential returns (a pole, a domain).
pub fn along_flow<T: Ring>(
    state: &[T],
    velocity: &[T],
    potential: impl FnOnce(&[Dual<T>]) -> Result<Dual<T>, ArithmeticError>,
) -> Result<T, ArithmeticError> {
    let moving: Vec<Dual<T>> = state.iter().zip(velocity).map(|(x, v)| Dual::new(x.clone(), v.clone())).collect();
    Ok(potential(&moving)?.derivative)
}

/// The gradient of `potential` at `state`, one coordinate at a time.
///
/// # Errors
/// Whatever the potential returns (a pole, a domain).
pub fn gradient<T: Ring>(
    state: &[T],
    potential: impl Fn(&[Dual<T>]) -> Result<Dual<T>, ArithmeticError>,
) -> Result<Vec<T>, ArithmeticError> {
    (0..state.len())
        .map(|k| {
            let direction: Vec<T> = state.iter().enumerate().map(|(j, x)| x.integer(i64::from(j == k))).collect();
            along_flow(state, &direction, &potential)
        })
        .collect()
}
