//! Linearisation at a relative equilibrium, in the frame that turns with it: exact wherever the scalar is.

use super::moments::quarter_turn;
use super::state::State;
use arithmetic::{ArithmeticError, Complex, Dual, Field};

/// The matrix of the linearised particle model in the frame that turns about the origin at `omega`:
/// `rdot_k = e^{i theta_k} - i omega r_k`, `thetadot_k = u_k - omega`. Rows and columns are the `N` real parts, the `N` imaginary
/// parts, the `N` phases.
///
/// `steering` must be invariant under rotations, and the state a formation that turns about the origin at `omega`;
/// otherwise the matrix is that of the field at that instant only.
///
/// # Errors
/// Whatever the steering returns; [`ArithmeticError::Domain`] where there are not as many positions and rates of steering as phasors.
pub fn linearisation<T: Field>(
    state: &State<T>,
    omega: &T,
    steering: impl Fn(&State<Dual<T>>) -> Result<Vec<Dual<T>>, ArithmeticError>,
) -> Result<Vec<Vec<T>>, ArithmeticError> {
    let particles = state.phasors.len();
    if state.positions.len() != particles {
        return Err(ArithmeticError::Domain("a position for each phasor"));
    }
    let mut columns = Vec::with_capacity(3 * particles);
    for direction in 0..3 * particles {
        let moved = displaced(state, direction);
        let rates = steering(&moved)?;
        if rates.len() != particles {
            return Err(ArithmeticError::Domain("a rate of steering for each phasor"));
        }
        let turning = Dual::constant(omega.clone());
        let velocity = |k: usize| moved.phasors[k].clone() - quarter_turn(&moved.positions[k]).scale(&turning);
        let velocities: Vec<Complex<Dual<T>>> = (0..particles).map(velocity).collect();
        let re = velocities.iter().map(|v| v.re.derivative.clone());
        let im = velocities.iter().map(|v| v.im.derivative.clone());
        columns.push(re.chain(im).chain(rates.into_iter().map(|u| u.derivative)).collect::<Vec<T>>());
    }
    let row = |i: usize| columns.iter().map(|column| column[i].clone()).collect();
    Ok((0..3 * particles).map(row).collect())
}

/// The state with derivatives along one coordinate.
fn displaced<T: Field>(state: &State<T>, direction: usize) -> State<Dual<T>> {
    let particles = state.phasors.len();
    let along = |x: &T, coordinate: usize| Dual::new(x.clone(), x.integer(i64::from(coordinate == direction)));
    let position = |(k, r): (usize, &Complex<T>)| Complex::new(along(&r.re, k), along(&r.im, particles + k));
    let phasor = |(k, z): (usize, &Complex<T>)| {
        let rate = z.re.integer(i64::from(2 * particles + k == direction));
        Complex::new(Dual::new(z.re.clone(), -(z.im.clone() * &rate)), Dual::new(z.im.clone(), z.re.clone() * &rate))
    };
    State {
        positions: state.positions.iter().enumerate().map(position).collect(),
        phasors: state.phasors.iter().enumerate().map(phasor).collect(),
    }
}
