//! Linearisation at a relative equilibrium, in the frame that turns with it: exact wherever the scalar is.

use super::moments::quarter_turn;
use super::state::State;
use algebra::matrix::{MatrixError, RationalMatrix};
use algebra::spectrum::Polynomial;
use arithmetic::{ArithmeticError, Complex, Dual, Field, Rational, rational};

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

fn square(_: MatrixError) -> ArithmeticError {
    ArithmeticError::Domain("a square matrix")
}

/// The characteristic polynomial of a [`linearisation`] without the zeros, which are counted, and without `± i omega` once.
///
/// `translations` says whether the law is invariant under translations, so that `± i omega` are eigenvalues.
///
/// # Errors
/// [`ArithmeticError::Domain`] for rows that are no square matrix, or where `± i omega` should be eigenvalues and are not.
pub fn without_symmetries(
    rows: &[Vec<Rational>],
    omega: &Rational,
    translations: bool,
) -> Result<(usize, Polynomial), ArithmeticError> {
    let polynomial = RationalMatrix::from_rows(rows).and_then(|matrix| matrix.characteristic_polynomial());
    let polynomial = Polynomial::from_rationals(&polynomial.map_err(square)?.coefficients());
    let (zeros, rest) = polynomial.without_root(0);
    if !translations {
        return Ok((zeros, rest));
    }
    let factor = Polynomial::from_rationals(&[omega * omega, rational(0, 1), rational(1, 1)]);
    if rest.gcd(&factor).degree() != 2 {
        return Err(ArithmeticError::Domain("a law that is invariant under translations"));
    }
    Ok((zeros, rest.divided_by(&factor)))
}

/// What a linearisation in the turning frame has beside its symmetries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stability {
    /// Multiplicity of the eigenvalue 0.
    pub zeros: usize,
    /// Whether all eigenvalues but 0 and `± i omega` (the translations, once) have negative real parts.
    pub stable: bool,
    /// Whether there is a positive eigenvalue.
    pub positive: bool,
}

/// Decides the stability of a [`linearisation`] exactly, from its characteristic polynomial; `translations` as in [`without_symmetries`].
///
/// # Errors
/// As there.
pub fn stability(rows: &[Vec<Rational>], omega: &Rational, translations: bool) -> Result<Stability, ArithmeticError> {
    let (zeros, rest) = without_symmetries(rows, omega, translations)?;
    let sizes = rest.coefficients().iter().map(|c| Rational::from_integer(c.magnitude().clone().into()));
    let bound = sizes.fold(rational(1, 1), |sum, size| sum + size);
    let simple = rest.divided_by(&rest.gcd(&rest.derivative()));
    let positive = !simple.roots_in(&rational(0, 1), &bound).is_empty();
    Ok(Stability { zeros, stable: rest.is_hurwitz(), positive })
}

/// The number of directions in which the shape can change at a state: the rank of the derivative of all shape variables, `theta_k - theta_j` and
/// `(r_k - r_j) e^{-i theta_k}`.
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles.
pub fn shape_dimension(state: &State<Rational>) -> Result<usize, ArithmeticError> {
    let particles = state.phasors.len();
    let mut rows = Vec::new();
    for direction in 0..3 * particles {
        let unit = |coordinate: usize| rational(i64::from(coordinate == direction), 1);
        let steering: Vec<Rational> = (0..particles).map(|k| unit(2 * particles + k)).collect();
        // The drift makes the velocity the unit vector of the direction.
        let drift = state.phasors.iter().enumerate().map(|(k, z)| Complex::new(unit(k), unit(particles + k)) - z);
        let moving = state.moving(&steering, &drift.collect::<Vec<_>>());
        let mut row = Vec::new();
        for (r, z) in moving.positions.iter().zip(&moving.phasors) {
            for (s, w) in moving.positions.iter().zip(&moving.phasors) {
                for shape in [z.clone() * w.conj(), (r.clone() - s) * z.conj()] {
                    row.extend([shape.re.derivative, shape.im.derivative]);
                }
            }
        }
        rows.push(row);
    }
    let matrix = RationalMatrix::from_rows(&rows).map_err(|_| ArithmeticError::Domain("at least one particle"))?;
    Ok(3 * particles - matrix.transpose().kernel().len())
}
