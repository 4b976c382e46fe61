//! Linear systems, determinants and polynomials over other scalars, and products in order, against definitions.

use super::{Stopped, rational_matrix};
use algebra::matrix::{
    MatrixError, RationalMatrix, StochasticMatrix, characteristic_coefficients, determinant_over_field,
    prefix_products, product_sequential, product_tree, smallest_entries, solve_over_field,
};
use arithmetic::{ArithmeticError, Cancelled, Interval, Rational, rational};
use num_bigint::BigInt;
use num_traits::Zero;
use proptest::prelude::*;

/// The determinant by expansion along the first row.
fn expanded(rows: &[Vec<Rational>]) -> Rational {
    let Some((first, rest)) = rows.split_first() else { return rational(1, 1) };
    let minor =
        |k: usize| -> Vec<Vec<Rational>> { rest.iter().map(|row| [&row[..k], &row[k + 1..]].concat()).collect() };
    let sign = |k: usize| rational(if k.is_multiple_of(2) { 1 } else { -1 }, 1);
    first.iter().enumerate().map(|(k, x)| x * sign(k) * expanded(&minor(k))).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn determinants_are_expansions(a in (1usize..5).prop_flat_map(|n| rational_matrix(n, n))) {
        let exact = expanded(&a.to_rows());
        prop_assert_eq!(a.determinant().unwrap(), exact.clone());
        prop_assert_eq!(determinant_over_field(a.to_rows(), rational(1, 1)).unwrap(), exact);
    }

    #[test]
    fn coefficients_over_a_field_are_those_of_the_polynomial(a in (1usize..5).prop_flat_map(|n| rational_matrix(n, n))) {
        let found = characteristic_coefficients(&a.to_rows(), &rational(7, 3));
        prop_assert_eq!(found, a.characteristic_polynomial().unwrap().coefficients());
    }

    #[test]
    fn systems_over_a_field_are_solved((a, b) in (1usize..5).prop_flat_map(|n| (rational_matrix(n, n), rational_matrix(n, 1)))) {
        let rows = a.to_rows().into_iter().zip(b.to_rows()).map(|(row, right)| [row, right].concat()).collect();
        match solve_over_field::<Rational>(rows) {
            Ok(x) => prop_assert_eq!(a.apply(&x).unwrap(), b.to_rows().concat()),
            Err(error) => {
                prop_assert_eq!(error, ArithmeticError::DivisionByZero);
                prop_assert!(a.determinant().unwrap().is_zero());
            }
        }
    }

    /// One vector for each column without pivot, with a one there and zeros in the others of these columns.
    #[test]
    fn kernels_are_in_echelon_form(a in (1usize..4, 1usize..6).prop_flat_map(|(n, m)| rational_matrix(n, m))) {
        let kernel = a.kernel();
        let free: Vec<usize> = kernel.iter().map(|x| x.iter().rposition(|y| !y.is_zero()).expect("not zero")).collect();
        for (k, vector) in kernel.iter().enumerate() {
            let ones: Vec<Rational> = free.iter().map(|&j| vector[j].clone()).collect();
            prop_assert!(ones.iter().enumerate().all(|(l, x)| *x == rational(i64::from(k == l), 1)));
            prop_assert!(a.apply(vector).unwrap().iter().all(Zero::is_zero));
        }
    }
}

#[test]
fn results_are_reduced_and_can_be_stopped() {
    let a = RationalMatrix::from_integers(&[[6, 0], [0, 4]], 2).expect("filled");
    let inverse = a.inverse().expect("regular");
    assert_eq!(
        (inverse.denominator(), inverse.row(0), inverse.row(1)),
        (&6.into(), &[2.into(), 0.into()][..], &[0.into(), 3.into()][..])
    );
    assert_eq!(a.solve_watched(&a, &Stopped), Err(MatrixError::Cancelled(Cancelled)));
    assert_eq!(a.inverse_watched(&Stopped), Err(MatrixError::Cancelled(Cancelled)));
    assert_eq!(a.times_watched(&a, &Stopped), Err(MatrixError::Cancelled(Cancelled)));
    assert_eq!(a.reduced_watched(&Stopped), Err(MatrixError::Cancelled(Cancelled)));
    assert_eq!(RationalMatrix::from_rows_watched(&a.to_rows(), &Stopped), Err(MatrixError::Cancelled(Cancelled)));
    assert_eq!(determinant_over_field(Vec::new(), rational(5, 1)), Ok(rational(5, 1)));
    assert_eq!(solve_over_field::<Rational>(Vec::new()), Ok(Vec::new()));
}

#[test]
fn rows_of_other_lengths_are_refused() {
    let rows = |lengths: &[usize]| lengths.iter().map(|&n| vec![rational(1, 1); n]).collect::<Vec<_>>();
    for lengths in [&[2][..], &[0], &[2, 1], &[1, 2], &[3, 3]] {
        let wrong = Err(ArithmeticError::Domain("as many columns as rows"));
        assert_eq!(determinant_over_field(rows(lengths), rational(1, 1)), wrong, "{lengths:?}");
    }
    for lengths in [&[1][..], &[3], &[3, 2], &[3, 4], &[0, 3]] {
        let wrong = Err(ArithmeticError::Domain("one column more than rows"));
        assert_eq!(solve_over_field(rows(lengths)), wrong, "{lengths:?}");
    }
}

#[test]
fn pivots_of_intervals_are_those_that_can_be_inverted() {
    let between = |lo: i64, hi: i64| Interval::hull_of_rationals(&rational(lo, 1), &rational(hi, 1), 64);
    let point = |x: i64| between(x, x);
    // x + 2y = 5 with a coefficient of x around zero, 4x = 12.
    let rows = vec![vec![between(-1, 1), point(2), point(5)], vec![point(4), point(0), point(12)]];
    let x = solve_over_field(rows).expect("a pivot");
    assert_eq!(x[0].to_rationals(), (rational(3, 1), rational(3, 1)));
    assert_eq!(x[1].to_rationals(), (rational(1, 1), rational(4, 1)));
    assert_eq!(solve_over_field(vec![vec![between(-1, 1), point(1)]]).err(), Some(ArithmeticError::DivisionByZero));
    assert!(determinant_over_field(vec![vec![between(-1, 1)]], point(1)).is_err());
    assert!(determinant_over_field(vec![vec![point(0)]], point(1)).expect("zero").contains_zero());
}

/// Numerators and denominators as they are kept, and what is refused.
#[test]
fn matrices_over_a_common_denominator() {
    let half = rational(1, 2);
    let a = RationalMatrix::from_rows(&[vec![half.clone(), rational(2, 3)], vec![rational(0, 1), rational(-1, 6)]])
        .expect("filled");
    assert_eq!(
        (a.denominator(), a.row(0), a.row(1)),
        (&6.into(), &[3.into(), 4.into()][..], &[0.into(), BigInt::from(-1)][..])
    );
    assert_eq!(
        (a.rows(), a.cols(), a.entry(1, 1), a.entry(2, 0), a.entry(0, 2)),
        (2, 2, rational(-1, 6), rational(0, 1), rational(0, 1))
    );
    let wide = RationalMatrix::new(2, 3, (0..6).map(BigInt::from).collect(), 4.into()).expect("filled");
    assert_eq!(wide.transpose().to_rows(), [[0, 3], [1, 4], [2, 5]].map(|row| row.map(|x| rational(x, 4)).to_vec()));
    assert_eq!(wide.scaled(&rational(-2, 5)).to_rows()[1], [-6, -8, -10].map(|x| rational(x, 20)));
    assert_eq!((wide.scaled(&half).denominator(), wide.scaled(&half).row(1)), (&8.into(), wide.row(1)));
    let reduced = wide.scaled(&rational(2, 1)).reduced();
    assert_eq!((reduced.denominator(), reduced.row(1)), (&2.into(), wide.row(1)));
    assert_eq!(reduced, wide.scaled(&rational(2, 1)));
    assert!(reduced != wide && wide.transpose() != wide);
    // Over the least common denominator, 12.
    let sum = wide.plus(&RationalMatrix::new(2, 3, vec![1.into(); 6], 6.into()).expect("filled")).expect("one shape");
    assert_eq!((sum.denominator(), sum.row(0)), (&12.into(), &[2.into(), 5.into(), 8.into()][..]));
    let product = a.times(&wide).expect("shapes");
    assert_eq!(
        (product.denominator(), product.row(0), product.row(1)),
        (&24.into(), &[12.into(), 19.into(), 26.into()][..], &[BigInt::from(-3), (-4).into(), (-5).into()][..])
    );
    assert_eq!(wide.times(&a), Err(MatrixError::Shapes { left_cols: 3, right_rows: 2 }));
    assert_eq!(a.apply(&[half, rational(3, 4)]), Ok(vec![rational(3, 4), rational(-1, 8)]));
    let new = |rows, cols, count: usize, denominator: i64| {
        RationalMatrix::new(rows, cols, vec![1.into(); count], denominator.into())
    };
    assert_eq!(new(0, 3, 0, 1), Err(MatrixError::Empty));
    assert_eq!(new(3, 0, 0, 1), Err(MatrixError::Empty));
    assert_eq!(new(2, 2, 3, 1), Err(MatrixError::EntryCount { rows: 2, cols: 2, found: 3 }));
    assert_eq!(new(1, 2, 2, 0), Err(MatrixError::ZeroDenominator));
    assert_eq!(new(1, 1, 1, -3).map(|x| x.entry(0, 0)), Ok(rational(-1, 3)));
    assert_eq!(RationalMatrix::identity(0), Err(MatrixError::Empty));
    assert_eq!(RationalMatrix::from_rows(&[]), Err(MatrixError::Empty));
    assert_eq!(RationalMatrix::from_rows(&[vec![], vec![]]), Err(MatrixError::Empty));
    let ragged = RationalMatrix::from_integers(&[vec![1, 2], vec![1, 2], vec![1]], 1);
    assert_eq!(ragged, Err(MatrixError::Ragged { row: 3, expected: 2, found: 1 }));
}

#[test]
fn eigenvalues_are_counted_with_their_multiplicities() {
    // 3/2 twice, 0 twice, -5/3, and the roots of x² = 1/2.
    let rows: [[i64; 7]; 7] = [
        [9, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0],
        [0, 0, 9, 0, 0, 0, 0],
        [0, 0, 0, -10, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 3],
        [0, 0, 0, 0, 0, 6, 0],
    ];
    let polynomial =
        RationalMatrix::from_integers(&rows, 6).and_then(|a| a.characteristic_polynomial()).expect("square");
    let q = rational;
    for (x, above, equal) in [
        (q(-2, 1), 7, 0),
        (q(-5, 3), 6, 1),
        (q(-1, 1), 6, 0),
        (q(-7, 10), 5, 0),
        (q(0, 1), 3, 2),
        (q(7, 10), 3, 0),
        (q(1, 1), 2, 0),
        (q(3, 2), 0, 2),
        (q(2, 1), 0, 0),
    ] {
        let counts = (polynomial.count_above(&x), polynomial.multiplicity(&x), polynomial.count_below(&x));
        assert_eq!(counts, (above, equal, 7 - above - equal), "{x}");
    }
    assert_eq!(polynomial.rational_eigenvalues(), [(q(3, 2), 2), (q(0, 1), 2), (q(-5, 3), 1)]);
    // Nothing but zero; and a root that is as large as the bound.
    let zero = RationalMatrix::from_integers(&[[0, 0], [0, 0]], 1)
        .and_then(|a| a.characteristic_polynomial())
        .expect("square");
    assert_eq!(zero.rational_eigenvalues(), [(q(0, 1), 2)]);
    for x in [-1, 1, 5, -5] {
        let one = RationalMatrix::from_integers(&[[x]], 2).and_then(|a| a.characteristic_polynomial()).expect("square");
        assert_eq!(one.rational_eigenvalues(), [(q(x, 2), 1)]);
    }
}

fn stochastic(rows: [[i64; 2]; 2], denominator: i64) -> StochasticMatrix {
    let matrix = RationalMatrix::from_integers(&rows, denominator).expect("filled");
    StochasticMatrix::try_from(&matrix).expect("stochastic")
}

#[test]
fn the_new_factor_comes_on_the_left() {
    let factors = [stochastic([[1, 1], [0, 2]], 2), stochastic([[0, 3], [1, 2]], 3), stochastic([[4, 1], [5, 0]], 5)];
    let dense = StochasticMatrix::to_rational_matrix;
    let mut product = dense(&factors[0]);
    let mut expected = vec![product.clone()];
    for factor in &factors[1..] {
        product = dense(factor).times(&product).expect("shapes");
        expected.push(product.clone());
    }
    let prefixes: Vec<RationalMatrix> = prefix_products(&factors).map(|x| dense(&x.expect("shapes"))).collect();
    assert_eq!(prefixes, expected);
    for count in 1..=3 {
        for found in [product_sequential(&factors[..count]), product_tree(&factors[..count])] {
            assert_eq!(dense(&found.expect("shapes")), expected[count - 1]);
        }
    }
    assert_eq!(product_sequential(&[]).err(), Some(MatrixError::NoFactors));
    assert_eq!(product_tree(&[]).err(), Some(MatrixError::NoFactors));
    // Nothing follows what is refused.
    let one = StochasticMatrix::try_from(&RationalMatrix::identity(1).expect("an order")).expect("stochastic");
    let mixed = [factors[0].clone(), one.clone(), one, factors[1].clone()];
    let found: Vec<bool> = prefix_products(&mixed).map(|x| x.is_ok()).collect();
    assert_eq!(found, [true, false]);
}

/// Over 2 and 3: the least common denominator is 6, and `(6 · 5/6)^k` has to fit 128 bits.
#[test]
fn smallest_entries_of_factors_with_different_denominators() {
    let m = |rows: &[[i64; 2]; 2], denominator| RationalMatrix::from_integers(rows, denominator).expect("filled");
    let set = [m(&[[1, 1], [0, 2]], 2), m(&[[1, 2], [3, 0]], 3)];
    let (found, count) = smallest_entries(&set, 2).expect("short");
    assert_eq!(count, 2 + 4);
    assert_eq!((found[0].entry.clone(), &found[0].factors), (Some(rational(1, 3)), &vec![1]));
    // First columns (1/4, 0), (1/6, 1/2), (2/3, 1) and (7/9, 1/3).
    assert_eq!((found[1].entry.clone(), &found[1].factors), (Some(rational(1, 6)), &vec![0, 1]));
    // Rows of sum 1 over 2: 2^127 fits, 2^128 does not.
    let halves = [m(&[[2, 0], [0, 2]], 2)];
    assert!(smallest_entries(&halves, 127).is_ok());
    assert_eq!(smallest_entries(&halves, 128).err(), Some(MatrixError::TooLong));
    assert_eq!(smallest_entries(&[m(&[[1, 1], [1, 1]], 1)], 128).err(), Some(MatrixError::TooLong));
}
