//! The equations of motion in vector form (Section 2, equation (3)).

use super::law::Gains;
use algebra::matrix::{MatrixError, RationalMatrix};
use arithmetic::{Field, Rational, Ring};

/// A 2 x 2 matrix that acts on the pair (position, velocity) of one agent.
pub type Block<T> = [[T; 2]; 2];

/// `A = [[0, 1], [0, 0]]`, of the kind of `like`.
pub fn geodesic_block<T: Ring>(like: &T) -> Block<T> {
    [[like.zero(), like.one()], [like.zero(), like.zero()]]
}

/// `K = [[0, 0], [f, g]]`.
pub fn control_block<T: Ring>(gains: &Gains<T>) -> Block<T> {
    [[gains.f.zero(), gains.f.zero()], [gains.f.clone(), gains.g.clone()]]
}

/// `outer ⊗ inner` times the pairs `vector`, without forming the product: the block `i` is `inner` times the sum of
/// `outer_ij vector_j`. `outer` has as many columns as there are pairs.
pub fn kronecker_apply<T: Field>(outer: &[Vec<Rational>], inner: &Block<T>, vector: &[[T; 2]]) -> Vec<[T; 2]> {
    let zero = inner[0][0].zero();
    let row = |coefficients: &Vec<Rational>| {
        let mixed = |part: usize| {
            let terms = coefficients.iter().zip(vector);
            terms.fold(zero.clone(), |sum, (c, pair)| sum + zero.rational(c) * &pair[part])
        };
        let pair = [mixed(0), mixed(1)];
        [0, 1].map(|i| inner[i][0].clone() * &pair[0] + inner[i][1].clone() * &pair[1])
    };
    outer.iter().map(row).collect()
}

/// The matrix `M = I ⊗ A + P ⊗ K` of equation (3) for a reduced Laplacian `P` of order m, as the rows of a matrix of order 2m.
pub fn motion_rows<T: Field>(reduced: &RationalMatrix, gains: &Gains<T>) -> Vec<Vec<T>> {
    motion_rows_of_cars(reduced, |_| gains)
}

/// The same where each car has its own gains: `gains(k)` are those of row `k` of `P`.
pub fn motion_rows_of_cars<'a, T: Field + 'a>(
    reduced: &RationalMatrix,
    gains: impl Fn(usize) -> &'a Gains<T>,
) -> Vec<Vec<T>> {
    motion_rows_of([reduced; 2], gains)
}

/// The same with a reduced Laplacian for the positions and one for the velocities, of the same order.
pub(super) fn motion_rows_of<'a, T: Field + 'a>(
    reduced: [&RationalMatrix; 2],
    gains: impl Fn(usize) -> &'a Gains<T>,
) -> Vec<Vec<T>> {
    let entry = |i: usize, j: usize| {
        let gains = gains(i / 2);
        let (a, k) = (geodesic_block(&gains.f), control_block(gains));
        let own = if i / 2 == j / 2 { a[i % 2][j % 2].clone() } else { gains.f.zero() };
        own + gains.f.rational(&reduced[j % 2].entry(i / 2, j / 2)) * &k[i % 2][j % 2]
    };
    let order = 2 * reduced[0].rows();
    (0..order).map(|i| (0..order).map(|j| entry(i, j)).collect()).collect()
}

/// [`motion_rows`] over the rationals, as a matrix.
///
/// # Errors
/// [`MatrixError`] where `P` is not square.
pub fn motion_matrix(reduced: &RationalMatrix, gains: &Gains<Rational>) -> Result<RationalMatrix, MatrixError> {
    RationalMatrix::from_rows(&motion_rows(reduced, gains))
}

/// Whether every motion `x' = M x` dies out: whether all eigenvalues of `M` have negative real parts, decided exactly from the characteristic
/// polynomial. Of [`motion_matrix`] it says whether the followers come to rest behind a resting leader.
///
/// # Errors
/// [`MatrixError::NotSquare`].
pub fn is_stable(motion: &RationalMatrix) -> Result<bool, MatrixError> {
    Ok(motion.primitive_characteristic()?.is_hurwitz())
}

/// `A + lambda K`, by which a mode of the eigenvalue `lambda` of `P` moves.
pub fn mode_block<T: Ring>(gains: &Gains<T>, lambda: &T) -> Block<T> {
    let (a, k) = (geodesic_block(&gains.f), control_block(gains));
    [0, 1].map(|i| [0, 1].map(|j| a[i][j].clone() + lambda.clone() * &k[i][j]))
}

/// The product of `det(xI - A - lambda K) = x² - lambda g x - lambda f` over the spectrum of `P`, lowest coefficient first: with
/// `det(yI - P) = sum p_k y^k` (`reduced` holds the `p_k`) it is the sum of `p_k x^{2k} (g x + f)^{m-k}`.
pub fn characteristic_by_modes<T: Field>(reduced: &[Rational], gains: &Gains<T>) -> Vec<T> {
    let Gains { f, g } = gains;
    let order = reduced.len().saturating_sub(1);
    let mut sum = vec![f.zero(); 2 * order + 1];
    for (k, coefficient) in reduced.iter().enumerate() {
        // p_k (g x + f)^(m-k), lowest first.
        let mut power = vec![f.rational(coefficient)];
        for _ in k..order {
            let mut next = vec![f.zero(); power.len() + 1];
            for (n, c) in power.iter().enumerate() {
                next[n] = next[n].clone() + f.clone() * c;
                next[n + 1] = g.clone() * c;
            }
            power = next;
        }
        for (n, c) in power.into_iter().enumerate() {
            sum[2 * k + n] = sum[2 * k + n].clone() + c;
        }
    }
    sum
}
