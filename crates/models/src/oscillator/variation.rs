//! Derivatives with respect to the phases, by duals: exact wherever the scalar is.

use super::state::State;
use arithmetic::{ArithmeticError, Complex, Dual, Ring};

/// The phasors with derivatives: each phase moves at its rate. One rate for each phasor.
pub fn turning<T: Ring>(phasors: &[Complex<T>], rates: &[T]) -> Vec<Complex<Dual<T>>> {
    State { positions: Vec::new(), phasors: phasors.to_vec() }.moving(rates, &[]).phasors
}

/// The rate of change of a function of the phases that move at these rates.
///
/// # Errors
/// Whatever the function returns.
pub fn rate_of_change<T: Ring>(
    phasors: &[Complex<T>],
    rates: &[T],
    function: impl FnOnce(&[Complex<Dual<T>>]) -> Result<Dual<T>, ArithmeticError>,
) -> Result<T, ArithmeticError> {
    Ok(function(&turning(phasors, rates))?.derivative)
}

/// The unit vector along the phase `k`.
fn direction<T: Ring>(phasors: &[Complex<T>], k: usize) -> Vec<T> {
    phasors.iter().enumerate().map(|(j, z)| z.re.integer(i64::from(j == k))).collect()
}

/// The derivatives of a potential with respect to each phase.
///
/// # Errors
/// Whatever the potential returns.
pub fn phase_gradient<T: Ring>(
    phasors: &[Complex<T>],
    potential: impl Fn(&[Complex<Dual<T>>]) -> Result<Dual<T>, ArithmeticError>,
) -> Result<Vec<T>, ArithmeticError> {
    (0..phasors.len()).map(|k| rate_of_change(phasors, &direction(phasors, k), &potential)).collect()
}

/// The derivatives of a vector field (a gradient: its Hessian; a control: its linearisation) with respect to the phases;
/// row `j` holds those with respect to the phase `j`.
///
/// # Errors
/// Whatever the field returns.
pub fn phase_jacobian<T: Ring>(
    phasors: &[Complex<T>],
    field: impl Fn(&[Complex<Dual<T>>]) -> Result<Vec<Dual<T>>, ArithmeticError>,
) -> Result<Vec<Vec<T>>, ArithmeticError> {
    let row = |j: usize| {
        let values = field(&turning(phasors, &direction(phasors, j)))?;
        Ok(values.into_iter().map(|value| value.derivative).collect())
    };
    (0..phasors.len()).map(row).collect()
}
