//! Exact inverses and sums.

use super::rational_matrix;
use algebra::matrix::{MatrixError, RationalMatrix, determinant_over_field};
use arithmetic::rational;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn a_solution_solves((a, b) in (1usize..6, 1usize..4).prop_flat_map(|(n, m)| (rational_matrix(n, n), rational_matrix(n, m)))) {
        match a.solve(&b) {
            Ok(x) => {
                prop_assert_eq!(a.times(&x).unwrap(), b);
                let identity = RationalMatrix::identity(a.rows()).unwrap();
                prop_assert_eq!(a.inverse().unwrap().times(&a).unwrap(), identity);
            }
            // Entries up to 3 make singular matrices common; each must have a row that depends on the others.
            Err(error) => {
                prop_assert_eq!(error, MatrixError::Singular);
                prop_assert!(a.transpose().inverse().is_err());
            }
        }
    }

    #[test]
    fn determinants_agree(a in (1usize..6).prop_flat_map(|n| rational_matrix(n, n))) {
        prop_assert_eq!(determinant_over_field(a.to_rows(), rational(1, 1)).unwrap(), a.determinant().unwrap());
    }

    #[test]
    fn sums_and_transposes((a, b) in (1usize..5, 1usize..5).prop_flat_map(|(n, m)| (rational_matrix(n, m), rational_matrix(n, m)))) {
        let sum = a.plus(&b).unwrap();
        prop_assert_eq!(sum.minus(&b).unwrap(), a.clone());
        prop_assert_eq!(sum.transpose(), a.transpose().plus(&b.transpose()).unwrap());
        prop_assert_eq!(a.transpose().entry(0, a.rows() - 1), a.entry(a.rows() - 1, 0));
        prop_assert_eq!(a.plus(&a).unwrap(), a.scaled(&rational(2, 1)));
        prop_assert_eq!(a.times(&b.transpose()).unwrap().transpose(), b.times(&a.transpose()).unwrap());
    }
}

#[test]
fn systems_that_are_refused() {
    let m = |rows: &[&[i64]]| RationalMatrix::from_integers(rows, 3).unwrap();
    let square = m(&[&[1, 2], &[2, 4]]);
    assert_eq!(square.inverse(), Err(MatrixError::Singular));
    assert_eq!(m(&[&[1, 2]]).inverse(), Err(MatrixError::NotSquare { rows: 1, cols: 2 }));
    assert_eq!(square.solve(&m(&[&[1]])), Err(MatrixError::Shapes { left_cols: 2, right_rows: 1 }));
    assert_eq!(square.plus(&m(&[&[1]])), Err(MatrixError::DifferentShapes { left: (2, 2), right: (1, 1) }));
    // A zero pivot that a row exchange cures.
    assert_eq!(m(&[&[0, 3], &[3, 0]]).inverse().unwrap(), m(&[&[0, 3], &[3, 0]]));
}
