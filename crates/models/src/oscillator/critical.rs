//! The critical points of `U_1` (8), and the flow (6) with (9) around them.

use super::arrangement::{ExactPhasors, exact_phasors, in_turns, on_the_line, up_to_rotation};
use super::laplacian::misalignment;
use super::moments::{kind, moment, moment_gradient};
use super::network::Interaction;
use super::steering::{gradient_control, sine_of_difference};
use super::variation::phase_jacobian;
use algebra::matrix::{Inertia, inertia};
use arithmetic::{ArithmeticError, Complex, CosineField, Field, Rational, Ring, Signed};

/// The kinds of critical points of `U_1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Equal phases.
    Synchronised,
    /// `p = 0`.
    Balanced,
    /// Neither of the two: two clusters of different sizes on opposite sides.
    Unbalanced,
}

impl Kind {
    /// The kind of a critical point.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] for no particles.
    pub fn of<T: Field + PartialEq>(z: &[Complex<T>]) -> Result<Kind, ArithmeticError> {
        let p = moment(z, 1)?;
        Ok(match (z.windows(2).all(|pair| pair[0] == pair[1]), p == p.zero()) {
            (true, _) => Kind::Synchronised,
            (_, true) => Kind::Balanced,
            _ => Kind::Unbalanced,
        })
    }
}

/// A critical point.
#[derive(Debug, Clone)]
pub struct Critical {
    /// Which kind.
    pub kind: Kind,
    /// What it looks like, in words.
    pub name: String,
    /// Its phasors.
    pub phasors: ExactPhasors,
}

/// The synchronised arrangement, all unbalanced ones, and balanced ones made of triangles and antipodal pairs at different angles,
/// one of each shape modulo rotation.
pub fn critical_points(particles: usize) -> Vec<Critical> {
    let field = CosineField::new(12);
    let line = |minority: usize| {
        let exponents: Vec<usize> = (0..particles).map(|k| if k + minority < particles { 0 } else { 6 }).collect();
        let kind = if minority == 0 { Kind::Synchronised } else { Kind::Unbalanced };
        let name = format!("{} phases opposite to {}", minority, particles - minority);
        Critical { kind, name, phasors: exact_phasors(&field, &exponents) }
    };
    let mut points: Vec<Critical> = (0..particles.div_ceil(2)).map(line).collect();
    for triangles in 0..=particles / 3 {
        let rest = particles - 3 * triangles;
        if !rest.is_multiple_of(2) {
            continue;
        }
        for step in if rest > 2 || (triangles > 0 && rest > 0) { 0..3 } else { 0..1 } {
            let mut exponents = [0, 4, 8].repeat(triangles);
            exponents.extend((0..rest / 2).flat_map(|pair| [pair * step, pair * step + 6]));
            let name = format!("balanced, {}", in_turns(&exponents, 12));
            points.push(Critical { kind: Kind::Balanced, name, phasors: exact_phasors(&field, &exponents) });
        }
    }
    points
}

/// Arrangements of two opposite clusters of different sizes, or of one: of 2 up to so many particles, with the size of the minority.
pub fn two_clusters(most: usize) -> impl Iterator<Item = (usize, usize, Vec<Complex<Rational>>)> {
    let sizes = (2..=most).flat_map(|n| (0..n.div_ceil(2)).map(move |minority| (n, minority)));
    sizes.map(|(n, minority)| (n, minority, on_the_line(n, minority)))
}

/// All arrangements of 2 and 3 phases at multiples of 1/12 turn and of 4 at multiples of 1/6, in words and exactly.
pub fn arrangements() -> impl Iterator<Item = (String, ExactPhasors)> {
    [(2, 12), (3, 12), (4, 6)].into_iter().flat_map(|(particles, parts)| {
        let field = CosineField::new(parts as u32);
        let named = move |exponents: Vec<usize>| (in_turns(&exponents, parts), exact_phasors(&field, &exponents));
        up_to_rotation(particles, parts).map(named)
    })
}

/// Whether the gradient of `U_1` vanishes.
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles.
pub fn is_critical<T: Field + PartialEq>(z: &[Complex<T>]) -> Result<bool, ArithmeticError> {
    Ok(moment_gradient(z, 1)?.iter().all(|slope| *slope == slope.zero()))
}

/// Whether all phases are on one line through the origin: every `sin theta_kj` is zero.
pub fn is_on_a_line<T: Field + PartialEq>(z: &[Complex<T>]) -> bool {
    z.iter().all(|a| sine_of_difference(a, &z[0]) == a.re.zero())
}

/// The inertia of the Hessian of `U_1`.
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles, or where a sign is not decided; so in what follows.
pub fn hessian<T: Field + Signed>(z: &[Complex<T>]) -> Result<Inertia, ArithmeticError> {
    inertia(&phase_jacobian(z, |z| moment_gradient(z, 1))?)
}

/// The inertia of the Hessian of `N W_1` (12) times a whole number, on an undirected network.
///
/// # Errors
/// As for [`hessian`].
pub fn laplacian_hessian<T: Field + Signed>(
    network: &impl Interaction,
    z: &[Complex<T>],
    factor: i64,
) -> Result<Inertia, ArithmeticError> {
    let scaled = |term: arithmetic::Dual<T>| term.integer(factor) * term;
    inertia(&phase_jacobian(z, |z| Ok(misalignment(network, z).into_iter().map(scaled).collect()))?)
}

/// The inertia of the linearisation of (6) with (9) for a gain.
///
/// # Errors
/// As for [`hessian`].
pub fn linearisation<T: Field + Signed>(z: &[Complex<T>], gain: i64) -> Result<Inertia, ArithmeticError> {
    inertia(&phase_jacobian(z, |z| gradient_control(&kind(z)?.integer(gain), z))?)
}

/// The rates of (6) with (9).
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles.
pub fn rates<T: Field>(z: &[Complex<T>], gain: i64, omega: i64) -> Result<Vec<T>, ArithmeticError> {
    let like = kind(z)?;
    let control = gradient_control(&like.integer(gain), z)?;
    Ok(control.into_iter().map(|u| u + like.integer(omega)).collect())
}
