//! Laplacian quadratic forms and phase potentials: (11), (12), `W_m` and their gradient.
//!
//! The Laplacian `L = D - A` has `a_kj = 1` where `j` is a neighbour of `k`: it is
//! [`LaplacianKind::OutDegree`](algebra::graph::LaplacianKind) of a [`WeightedGraph`](algebra::graph::WeightedGraph) with
//! the arc from `k` to `j`. (The paper draws that arc from `j` to `k`, along the flow of information.)

use super::moments::{kind, powers, quarter_turn};
use super::network::Interaction;
use algebra::matrix::SparseMatrix;
use arithmetic::{ArithmeticError, Complex, Field, Ring};

/// The eigenvalue `sum_s (1 - w^(qs))` of the Laplacian of the circulant digraph in which `k + s` is a neighbour of `k` for each offset `s`, on the
/// eigenvector `w^(qk)`; given `w^k = e^{2 pi i k/N}`, `N` of them, at least one. Undirected graphs have `s` and `N - s` among the offsets.
///
/// # Panics
/// Where there are no roots.
pub fn circulant_eigenvalue<T: Ring>(
    roots: &[Complex<T>],
    offsets: impl IntoIterator<Item = usize>,
    q: usize,
) -> Complex<T> {
    let one = &roots[0];
    offsets
        .into_iter()
        .fold(one.zero(), |sum, s| sum + one - &roots[(q % roots.len()) * (s % roots.len()) % roots.len()])
}

/// `Q_L(x) = (1/(2N)) <x, L x>` (11).
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles.
pub fn quadratic_form<T: Field>(network: &impl Interaction, x: &[Complex<T>]) -> Result<T, ArithmeticError> {
    let share = kind(x)?.ratio(1, 2 * x.len() as i64);
    let zero = share.zero();
    let sum = x.iter().zip(network.laplacian_of(x)).fold(zero, |sum, (x, lx)| sum + x.dot(&lx));
    Ok(sum * share)
}

/// `W_m = Q_L((1/m) e^{i m theta})`, for `m >= 1`; `W_1` is (12).
///
/// # Errors
/// [`ArithmeticError`] for no particles or `m = 0`.
pub fn phase_potential<T: Field>(
    network: &impl Interaction,
    phasors: &[Complex<T>],
    m: u32,
) -> Result<T, ArithmeticError> {
    let scale = kind(phasors)?.integer(i64::from(m)).recip()?;
    let scaled: Vec<Complex<T>> = powers(phasors, m).iter().map(|z| z.scale(&scale)).collect();
    quadratic_form(network, &scaled)
}

/// `<i e^{i theta_k}, L_k e^{i theta}>`, `N` of them: the left side of (16).
pub fn misalignment<T: Field>(network: &impl Interaction, phasors: &[Complex<T>]) -> Vec<T> {
    phasors.iter().zip(network.laplacian_of(phasors)).map(|(z, lz)| quarter_turn(z).dot(&lz)).collect()
}

/// Whether `L z` is a multiple of `z`, whose entries have modulus one: then `L_k z` conj(z_k) is the same for all `k`.
pub fn is_eigenvector<T: Field + PartialEq>(network: &impl Interaction, phasors: &[Complex<T>]) -> bool {
    let factors: Vec<_> = network.laplacian_of(phasors).into_iter().zip(phasors).map(|(lz, z)| lz * z.conj()).collect();
    factors.windows(2).all(|pair| pair[0] == pair[1])
}

/// `dW_1/dtheta_k = (1/(2N)) <i e^{i theta_k}, (L + L^T)_k e^{i theta}>`, on any graph (display before (14)).
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles.
pub fn phase_potential_gradient<T: Field>(
    laplacian: &SparseMatrix,
    phasors: &[Complex<T>],
) -> Result<Vec<T>, ArithmeticError> {
    let share = kind(phasors)?.ratio(1, 2 * phasors.len() as i64);
    let back = misalignment(&laplacian.transpose(), phasors);
    let both = misalignment(laplacian, phasors).into_iter().zip(back);
    Ok(both.map(|(there, back)| (there + back) * &share).collect())
}
