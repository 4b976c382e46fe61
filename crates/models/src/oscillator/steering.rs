//! Orientation controls (9), (14) and that of Theorem 3, and the same laws as sums over pairs (10), (15).

use super::laplacian::misalignment;
use super::moments::{kind, moment_gradient, pattern_gradient};
use super::network::Interaction;
use algebra::graph::WeightedGraph;
use arithmetic::{ArithmeticError, Complex, Field};

/// `u_k = -K_1 <i e^{i theta_k}, p_theta>` (9), `N` of them.
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles.
pub fn gradient_control<T: Field>(gain: &T, phasors: &[Complex<T>]) -> Result<Vec<T>, ArithmeticError> {
    Ok(moment_gradient(phasors, 1)?.into_iter().map(|slope| -(slope * gain)).collect())
}

/// `u_k = (K_1/N) <i e^{i theta_k}, L_k e^{i theta}>` (14), `N` of them.
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles.
pub fn laplacian_control<T: Field>(
    gain: &T,
    network: &impl Interaction,
    phasors: &[Complex<T>],
) -> Result<Vec<T>, ArithmeticError> {
    let share = kind(phasors)?.ratio(1, phasors.len() as i64) * gain;
    Ok(misalignment(network, phasors).into_iter().map(|term| term * &share).collect())
}

/// The negative gradient of (25), with `gains = [K_1, ..., K_M]`.
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles.
pub fn pattern_control<T: Field>(gains: &[T], phasors: &[Complex<T>]) -> Result<Vec<T>, ArithmeticError> {
    Ok(pattern_gradient(gains, phasors)?.into_iter().map(|slope| -slope).collect())
}

/// `(K_1/N) sum_j a_kj sin(theta_k - theta_j)`, `N` of them: (15) without `omega_0`, and (10) on the complete graph. The
/// arc from `k` to `j` means that `j` is a neighbour of `k`.
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles, and for a graph of another number of vertices.
pub fn pairwise_control<T: Field>(
    gain: &T,
    graph: &WeightedGraph,
    phasors: &[Complex<T>],
) -> Result<Vec<T>, ArithmeticError> {
    let share = kind(phasors)?.ratio(1, phasors.len() as i64) * gain;
    if graph.order() != phasors.len() {
        return Err(ArithmeticError::Domain("a vertex for each particle"));
    }
    let sum = |(k, z): (usize, &Complex<T>)| {
        let term = |(j, weight): &(usize, _)| sine_of_difference(z, &phasors[*j]) * share.rational(weight);
        graph.adjacency().row(k).iter().map(term).fold(share.zero(), |sum, term| sum + term)
    };
    Ok(phasors.iter().enumerate().map(|pair| sum(pair) * &share).collect())
}

/// `sin(theta_k - theta_j)` of two phasors.
#[inline(always)]
pub fn sine_of_difference<T: Field>(k: &Complex<T>, j: &Complex<T>) -> T {
    k.im.clone() * &j.re - k.re.clone() * &j.im
}
