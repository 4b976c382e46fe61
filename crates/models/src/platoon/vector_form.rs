//! The equations of motion in vector form (Section 2, equation (3)).

use super::Gains;
use algebra::matrix::{MatrixError, RationalMatrix};
use arithmetic::{Rational, Ring};

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
pub fn kronecker_apply<T: arithmetic::Field>(
    outer: &[Vec<Rational>],
    inner: &Block<T>,
    vector: &[[T; 2]],
) -> Vec<[T; 2]> {
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

/// The matrix `M = I ⊗ A + P ⊗ K` of equation (3) for a reduced Laplacian `P` of order m, as a matrix of order 2m.
///
/// # Errors
/// [`MatrixError`] where `P` is not square.
pub fn motion_matrix(reduced: &RationalMatrix, gains: &Gains<Rational>) -> Result<RationalMatrix, MatrixError> {
    let block = |b: Block<Rational>| RationalMatrix::from_rows(&b.map(|row| row.to_vec()));
    let free = RationalMatrix::identity(reduced.rows())?.kronecker(&block(geodesic_block(&gains.f))?);
    free.plus(&reduced.kronecker(&block(control_block(gains))?))
}
