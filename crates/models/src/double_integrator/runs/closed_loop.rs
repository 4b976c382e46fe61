//! Laws as vector fields of the integrators: a list of positions and then velocities.

use crate::double_integrator::laws::{State, Vector};
use arithmetic::ArithmeticError;
use motion::{IntegrationError, Tolerance, VectorField, integrate};

/// `rdot = v`, `vdot = law(state)`. Where the law has no value, the rate is not a number, and integrators stop.
pub(super) struct ClosedLoop<L> {
    law: L,
    /// Working space.
    state: State<f64>,
}

impl<L: FnMut(&State<f64>) -> Result<Vec<Vector<f64>>, ArithmeticError>> ClosedLoop<L> {
    pub fn new(count: usize, law: L) -> Self {
        ClosedLoop { law, state: State { positions: vec![[0.0; 2]; count], velocities: vec![[0.0; 2]; count] } }
    }
}

impl<L: FnMut(&State<f64>) -> Result<Vec<Vector<f64>>, ArithmeticError>> VectorField for ClosedLoop<L> {
    fn rate(&mut self, _time: f64, list: &[f64], rate: &mut [f64]) {
        let half = 2 * self.state.count();
        let accelerations = self.state.read(list).and_then(|()| (self.law)(&self.state).ok());
        let Some(accelerations) = accelerations.filter(|a| 2 * a.len() == half) else {
            rate.fill(f64::NAN);
            return;
        };
        let rates = list.iter().skip(half).chain(accelerations.iter().flatten());
        rate.iter_mut().zip(rates).for_each(|(x, value)| *x = *value);
    }
}

/// The states at some times, which must not decrease, of `rdot = v`, `vdot = law(state)` from the start at time 0, for any
/// law that is smooth along the motion.
///
/// # Errors
/// [`IntegrationError`]; it stops where the law has no value.
pub fn follow(
    start: &State<f64>,
    times: &[f64],
    tolerance: Tolerance,
    law: impl FnMut(&State<f64>) -> Result<Vec<Vector<f64>>, ArithmeticError>,
) -> Result<Vec<State<f64>>, IntegrationError> {
    let count = start.count();
    let states = integrate(&mut ClosedLoop::new(count, law), 0.0, &start.to_list(), times, tolerance)?;
    Ok(states.iter().filter_map(|list| State::from_list(count, list)).collect())
}
