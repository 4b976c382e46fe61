//! Characteristic polynomials, counts of eigenvalues, determinants, kernels and Kronecker products.

use super::rational_matrix;
use algebra::matrix::RationalMatrix;
use algebra::spectrum::Polynomial;
use arithmetic::{Rational, rational};
use num_traits::Zero;
use proptest::prelude::*;

fn value(coefficients: &[Rational], x: &Rational) -> Rational {
    coefficients.iter().rev().fold(rational(0, 1), |sum, c| sum * x + c)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(80))]

    /// det(xI - A) by the polynomial and by elimination.
    #[test]
    fn the_polynomial_is_the_determinant(a in (1usize..6).prop_flat_map(|n| rational_matrix(n, n)), p in -9i64..10, q in 1i64..5) {
        let x = rational(p, q);
        let shifted = RationalMatrix::identity(a.rows()).unwrap().scaled(&x).minus(&a).unwrap();
        let polynomial = a.characteristic_polynomial().unwrap();
        prop_assert_eq!(value(&polynomial.coefficients(), &x), shifted.determinant().unwrap());
        prop_assert_eq!(polynomial.degree(), a.rows());
        prop_assert_eq!(polynomial.multiplicity(&x) > 0, shifted.determinant().unwrap().is_zero());
    }

    /// The primitive multiple, which larger matrices have by residues modulo primes, against the rational polynomial; also of matrices with repeated rows and zero blocks.
    #[test]
    fn the_primitive_multiple_is_one(a in (10usize..16).prop_flat_map(|n| rational_matrix(n, n)), kept in 0usize..10) {
        let n = a.rows();
        let zeroed = |i: usize, j: usize| if kept < 5 && (i > kept || j > kept) { rational(0, 1) } else { a.entry(i % (n - kept / 2), j) };
        let rows: Vec<Vec<Rational>> = (0..n).map(|i| (0..n).map(|j| zeroed(i, j)).collect()).collect();
        let matrix = RationalMatrix::from_rows(&rows).unwrap();
        let rational = Polynomial::from_rationals(&matrix.characteristic_polynomial().unwrap().coefficients());
        let primitive = matrix.primitive_characteristic().unwrap();
        prop_assert_eq!(primitive.coefficients(), rational.coefficients());
    }

    /// The counts for a symmetric matrix against floating-point eigenvalues, away from ties.
    #[test]
    fn counts_agree_with_floats(a in (1usize..6).prop_flat_map(|n| rational_matrix(n, n)), p in -40i64..40) {
        use algebra::matrix::floating::{eigenvalues, to_floats};
        let symmetric = a.plus(&a.transpose()).unwrap();
        let x = rational(2 * p + 1, 7);
        let polynomial = symmetric.characteristic_polynomial().unwrap();
        let float = (2 * p + 1) as f64 / 7.0;
        let floats: Vec<f64> = eigenvalues(&to_floats(&symmetric)).unwrap().iter().map(|e| e.re).collect();
        prop_assume!(floats.iter().all(|e| (e - float).abs() > 1e-6));
        prop_assert_eq!(polynomial.count_above(&x), floats.iter().filter(|e| **e > float).count());
        prop_assert_eq!(polynomial.count_below(&x), floats.iter().filter(|e| **e < float).count());
    }

    #[test]
    fn kernels_are_solved_and_complete(a in (1usize..5, 1usize..6).prop_flat_map(|(n, m)| rational_matrix(n, m))) {
        let kernel = a.kernel();
        for vector in &kernel {
            prop_assert!(a.apply(vector).unwrap().iter().all(Zero::is_zero));
            prop_assert!(vector.iter().any(|x| !x.is_zero()));
        }
        // The rank is that of the transpose.
        prop_assert_eq!(a.cols() - kernel.len(), a.rows() - a.transpose().kernel().len());
    }

    /// (A (x) B)(C (x) D) = AC (x) BD, and the entries of the definition.
    #[test]
    fn kronecker_products_multiply(
        (a, c) in (1usize..3, 1usize..3, 1usize..3).prop_flat_map(|(m, n, p)| (rational_matrix(m, n), rational_matrix(n, p))),
        (b, d) in (1usize..3, 1usize..3, 1usize..3).prop_flat_map(|(m, n, p)| (rational_matrix(m, n), rational_matrix(n, p))),
    ) {
        let product = a.kronecker(&b).times(&c.kronecker(&d)).unwrap();
        prop_assert_eq!(product, a.times(&c).unwrap().kronecker(&b.times(&d).unwrap()));
        let (i, j, k, l) = (a.rows() - 1, b.rows() - 1, a.cols() - 1, 0);
        let entry = a.kronecker(&b).entry(i * b.rows() + j, k * b.cols() + l);
        prop_assert_eq!(entry, a.entry(i, k) * b.entry(j, l));
    }
}

#[test]
fn rational_eigenvalues_in_order() {
    // Eigenvalues 3/2 (twice), -1/3 and the roots of x² - 2.
    let rows: [[i64; 5]; 5] = [[9, 0, 0, 0, 0], [0, -2, 0, 0, 0], [0, 0, 9, 0, 0], [0, 0, 0, 0, 12], [0, 0, 0, 6, 0]];
    let polynomial = RationalMatrix::from_integers(&rows, 6).unwrap().characteristic_polynomial().unwrap();
    assert_eq!(polynomial.rational_eigenvalues(), vec![(rational(3, 2), 2), (rational(-1, 3), 1)]);
    assert_eq!(polynomial.count_above(&rational(141, 100)), 3);
    assert_eq!(polynomial.count_above(&rational(142, 100)), 2);
    assert_eq!(polynomial.count_below(&rational(-142, 100)), 0);
    assert!(RationalMatrix::from_integers(&[[1, 2]], 1).unwrap().characteristic_polynomial().is_err());
    assert!(RationalMatrix::from_integers(&[[1, 2]], 1).unwrap().determinant().is_err());
}
