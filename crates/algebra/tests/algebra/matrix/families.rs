//! Blocks, sums and families of matrices.

use algebra::matrix::{MatrixError, RationalMatrix, kronecker_of_rows, product_of_rows};
use arithmetic::{random::generator, rational};

fn matrix(rows: &[&[i64]]) -> RationalMatrix {
    RationalMatrix::from_integers(rows, 2).expect("a matrix")
}

#[test]
fn blocks_and_direct_sums() {
    let a = matrix(&[&[1, 2], &[3, 4]]);
    assert_eq!(a.block(&[1], &[1, 0]), Ok(matrix(&[&[4, 3]])));
    assert_eq!(a.block(&[0, 7], &[0, 9]), Ok(matrix(&[&[1, 0], &[0, 0]])));
    assert_eq!(a.block(&[], &[0]), Err(MatrixError::Empty));
    assert_eq!(matrix(&[&[5]]).direct_sum(&matrix(&[&[6, 7]])), Ok(matrix(&[&[5, 0, 0], &[0, 6, 7]])));
    assert_eq!(matrix(&[&[-1, 0], &[3, 2]]).least_positive(), Some(rational(1, 1)));
    assert_eq!(matrix(&[&[-1, 0]]).least_positive(), None);
}

#[test]
fn products_and_kronecker_products_of_rows() {
    let (a, b) = (matrix(&[&[1, 2], &[3, 4]]), matrix(&[&[0, 5], &[6, 7]]));
    assert_eq!(product_of_rows(&a.to_rows(), &b.to_rows()), a.times(&b).expect("square").to_rows());
    assert_eq!(kronecker_of_rows(&a.to_rows(), &b.to_rows()), a.kronecker(&b).to_rows());
}

#[test]
fn stochastic_matrices_of_a_denominator() {
    // Two rows, each one of the three compositions of 2 into two parts.
    let all = RationalMatrix::all_stochastic(2, 2, 2).expect("few");
    assert_eq!(all.len(), 9);
    let sums_to_one = |matrix: &RationalMatrix| {
        matrix.to_rows().iter().all(|row| {
            row.iter().sum::<arithmetic::Rational>() == rational(1, 1) && row.iter().all(|x| *x >= rational(0, 1))
        })
    };
    assert!(all.iter().all(sums_to_one));
    assert_eq!(RationalMatrix::all_stochastic(0, 2, 2), Err(MatrixError::Empty));
    let mut random = generator("flocks", "stochastic matrices", 0);
    for (rows, cols) in [(1, 1), (3, 2), (2, 5)] {
        let drawn = RationalMatrix::random_stochastic(rows, cols, &mut random).expect("a shape");
        assert!(sums_to_one(&drawn) && (drawn.rows(), drawn.cols()) == (rows, cols));
    }
    assert_eq!(RationalMatrix::random_stochastic(1, 0, &mut random), Err(MatrixError::Empty));
}
