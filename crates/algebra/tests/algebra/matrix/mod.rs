//! Mirrors `src/matrix`: fast kernels against naive twins, the definitions, the reader.

mod stabiliser;

use algebra::matrix::floating::{eigenvalues, to_floats};
use algebra::matrix::read::{ReadError, read_sequence};
use algebra::matrix::{
    Footprint, MatrixError, Norm, RationalMatrix, SparseMatrix, StochasticMatrix, diameter, inertia, prefix_products,
    product_sequential, product_tree, stabilisers, tau_1, tau_2_squared, tau_2_squared_watched, tau_infinity,
};
use arithmetic::{Cancelled, Progress, Rational, Ring, Unwatched, rational};
use dense::Mat;
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use proptest::prelude::*;

mod axes;
mod characteristic;
mod elimination;
mod families;
mod inertia;
mod integer_rows;
mod smallest_entries;
mod solve;
mod sparse;

/// A matrix of entries -3/d, .., 3/d with d up to 4.
fn rational_matrix(rows: usize, cols: usize) -> impl Strategy<Value = RationalMatrix> {
    (prop::collection::vec(-3i64..4, rows * cols), 1i64..5).prop_map(move |(entries, denominator)| {
        RationalMatrix::from_integers(&entries.chunks(cols).collect::<Vec<_>>(), denominator).expect("a filled shape")
    })
}

/// A random stochastic matrix whose entries have about `bits` bits.
fn stochastic(rows: usize, cols: usize, bits: u32) -> impl Strategy<Value = StochasticMatrix> {
    let words = bits.div_ceil(32) as usize;
    let entry = (prop::collection::vec(any::<u32>(), words), any::<bool>());
    prop::collection::vec(prop::collection::vec(entry, cols), rows).prop_map(move |rows| {
        let rows: Vec<Vec<Rational>> = rows
            .into_iter()
            .map(|row| {
                let mut weights: Vec<BigInt> = row
                    .into_iter()
                    .map(
                        |(digits, zero)| {
                            if zero { 0.into() } else { BigInt::from_slice(num_bigint::Sign::Plus, &digits) }
                        },
                    )
                    .collect();
                let denominator = BigInt::from(1) << (32 * words + 8);
                let rest = &denominator - weights.iter().sum::<BigInt>();
                weights[0] += rest;
                weights.into_iter().map(|w| Rational::new(w, denominator.clone())).collect()
            })
            .collect();
        StochasticMatrix::from_rows(&rows).expect("rows sum to one")
    })
}

fn shape() -> impl Strategy<Value = (usize, usize, usize, u32, u32)> {
    // Entry sizes around the threshold of the splitting kernel (32 digits of 28 bits), unequal ones among them.
    (1usize..5, 1usize..6, 1usize..5, 1u32..2600, 1u32..2600)
}

/// `max_{i,j} |a_i* - a_j*|_p` over the rows, for `p` = 1, 2 or infinity; tau_1 is half of it for `p` = 1.
fn row_diameter(matrix: &Mat<f64>, p: f64) -> f64 {
    let distance = |i: usize, j: usize| {
        let differences = (0..matrix.ncols()).map(|k| (matrix[(i, k)] - matrix[(j, k)]).abs());
        if p == 1.0 {
            differences.sum()
        } else if p == 2.0 {
            differences.map(|x| x * x).sum::<f64>().sqrt()
        } else {
            differences.fold(0.0, f64::max)
        }
    };
    (0..matrix.nrows()).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| distance(i, j)).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn products_of_planes_of_digits_agree_with_the_naive_product(
        (a, b) in shape().prop_flat_map(|(m, n, p, x, y)| (stochastic(m, n, x), stochastic(n, p, y)))
    ) {
        let fast = a.times(&b).unwrap();
        let naive = a.to_rational_matrix().times(&b.to_rational_matrix()).unwrap();
        prop_assert_eq!(fast.to_rational_matrix(), naive.clone());
        prop_assert_eq!(fast.denominator() , naive.denominator().magnitude());
        prop_assert!(StochasticMatrix::try_from(&naive).is_ok());
        prop_assert_eq!(fast.footprint(), a.footprint().times(&b.footprint()));
    }

    #[test]
    fn products_in_several_tiles_agree_with_the_naive_product(
        (a, b) in (8usize..10, 8usize..11, 8usize..10, 300u32..2600, 0u32..200)
            .prop_flat_map(|(m, n, p, x, more)| (stochastic(m, n, x), stochastic(n, p, x + more)))
    ) {
        let naive = a.to_rational_matrix().times(&b.to_rational_matrix()).unwrap();
        prop_assert_eq!(a.times(&b).unwrap().to_rational_matrix(), naive);
    }

    #[test]
    fn the_fast_coefficient_agrees_with_the_definition(a in (1usize..6, 1usize..6, 1u32..400).prop_flat_map(|(m, n, x)| stochastic(m, n, x))) {
        prop_assert_eq!(a.tau_1(), tau_1(&a.to_rational_matrix()));
    }

    #[test]
    fn tree_and_sequence_agree(factors in prop::collection::vec(stochastic(3, 3, 40), 1..40)) {
        let sequential = product_sequential(&factors).unwrap();
        prop_assert_eq!(product_tree(&factors).unwrap(), sequential.clone());
        let prefixes: Vec<StochasticMatrix> = prefix_products(&factors).collect::<Result<_, _>>().unwrap();
        prop_assert_eq!(prefixes.len(), factors.len());
        prop_assert_eq!(prefixes.last(), Some(&sequential));
        // tau_1 never increases along prefixes.
        for pair in prefixes.windows(2) {
            prop_assert!(pair[1].tau_1() <= pair[0].tau_1());
        }
    }

    #[test]
    fn diameters_agree_with_floats(a in stochastic(4, 5, 30)) {
        let exact = a.to_rational_matrix();
        let floats = to_floats(&exact);
        // 5 differences and a sum: below 16 roundings of numbers at most 2.
        let tolerance = 32.0 * f64::EPSILON;
        let value = |x: Rational| x.to_f64().unwrap();
        prop_assert!((2.0 * value(tau_1(&exact)) - row_diameter(&floats, 1.0)).abs() <= tolerance);
        prop_assert!((value(tau_2_squared(&exact)).sqrt() - row_diameter(&floats, 2.0)).abs() <= tolerance);
        prop_assert!((value(tau_infinity(&exact)) - row_diameter(&floats, f64::INFINITY)).abs() <= tolerance);
    }

    #[test]
    fn any_text_is_read_or_refused(text in "[0-9/ .,#\\n\\[\\]\"-]{0,80}") {
        let _ = read_sequence(&text);
    }
}

#[test]
fn bad_matrices_are_refused() {
    let rows = |rows: &[&[i64]], d| RationalMatrix::from_integers(rows, d);
    assert_eq!(rows(&[], 1).unwrap_err(), MatrixError::Empty);
    assert_eq!(rows(&[&[]], 1).unwrap_err(), MatrixError::Empty);
    assert_eq!(rows(&[&[1, 2], &[1]], 1).unwrap_err(), MatrixError::Ragged { row: 2, expected: 2, found: 1 });
    assert_eq!(rows(&[&[1]], 0).unwrap_err(), MatrixError::ZeroDenominator);
    assert_eq!(RationalMatrix::identity(0).unwrap_err(), MatrixError::Empty);
    let stochastic = |m: RationalMatrix| StochasticMatrix::try_from(&m).unwrap_err();
    assert_eq!(stochastic(rows(&[&[2, -1]], 1).unwrap()), MatrixError::Negative { row: 1, col: 2 });
    assert_eq!(stochastic(rows(&[&[0, 4], &[-1, -1]], 4).unwrap()), MatrixError::Negative { row: 2, col: 1 });
    assert_eq!(stochastic(rows(&[&[1, 1], &[1, 2]], 2).unwrap()), MatrixError::RowSum { row: 2, sum: "3/2".into() });
    assert_eq!(product_tree(&[]).unwrap_err(), MatrixError::NoFactors);
    let (one, two) = (
        StochasticMatrix::from_integers(&[[1]], 1).unwrap(),
        StochasticMatrix::from_integers(&[[1, 1], [1, 1]], 2).unwrap(),
    );
    let shapes = MatrixError::Shapes { left_cols: 1, right_rows: 2 };
    assert_eq!(one.times(&two).unwrap_err(), shapes);
    let column = StochasticMatrix::from_integers(&[[1], [1], [1]], 1).unwrap();
    assert_eq!(two.times(&column).unwrap_err(), MatrixError::Shapes { left_cols: 2, right_rows: 3 });
    assert_eq!(column.times(&column).unwrap_err(), MatrixError::Shapes { left_cols: 1, right_rows: 3 });
    let prefixes: Vec<_> = prefix_products(&[two.clone(), one, two]).collect();
    assert_eq!(prefixes.len(), 2);
    assert_eq!(prefixes[1].as_ref().unwrap_err(), &shapes);
}

#[test]
fn a_negative_denominator_is_turned_around() {
    let m = RationalMatrix::from_integers(&[[-1, -2]], -3).unwrap();
    assert_eq!(m, RationalMatrix::from_integers(&[[2, 4]], 6).unwrap());
    assert_eq!(m.reduced().denominator(), &BigInt::from(3));
    assert_eq!(RationalMatrix::from_integers(&[[2, 4]], 6).unwrap().reduced().denominator(), &BigInt::from(3));
}

#[test]
fn reading_sequences() {
    let text = "# two factors\n12/15, 3/15\n10/15 5/15   # comment\n\n0.5 0.5\n0 1\n";
    let matrices = read_sequence(text).unwrap();
    assert_eq!(matrices.len(), 2);
    assert_eq!(read_sequence("[[[\"12/15\",0.2],[\"2/3\",\"1/3\"]],[[0.5,0.5],[0,1]]]").unwrap(), matrices);
    let error = |text| read_sequence(text).unwrap_err();
    assert_eq!(error(""), ReadError::Nothing);
    assert_eq!(error("[]"), ReadError::Nothing);
    assert!(matches!(error("1/0"), ReadError::Number { line: 1, .. }));
    assert!(matches!(error("1 0\n\n0 1\n1"), ReadError::Matrix { matrix: 2, line: 3, .. }));
    assert!(matches!(error("1/2 1/3"), ReadError::Matrix { error: MatrixError::RowSum { .. }, .. }));
    assert!(matches!(error("[[1]]"), ReadError::JsonMatrix { matrix: 1, .. }));
    assert!(matches!(error("[[[1],[1,0]]]"), ReadError::JsonMatrix { matrix: 1, .. }));
    assert!(matches!(error("[[[1]"), ReadError::Json(_)));
    assert!(matches!(error("1\n\n1/2 1/2\n1 0"), ReadError::Sequence { matrix: 2, .. }));
}

#[test]
fn footprints_and_stabilisers() {
    let edge = |i: usize, j: usize| Footprint::from_fn(3, 3, |a, b| a == b || (a, b) == (i, j) || (a, b) == (j, i));
    let (one_two, two_three) = (edge(0, 1), edge(1, 2));
    let product = two_three.times(&one_two);
    assert_eq!(product.to_string(), "110 111 111");
    assert!(product.contains(&one_two) && !one_two.contains(&product) && !product.is_symmetric());
    // Bird 1 reaches 2 and then, through the second edge, 3; afterwards nothing changes.
    let sequence = [one_two.clone(), two_three, one_two.clone(), one_two];
    let found = stabilisers(&sequence);
    assert_eq!(found[0].members, vec![0, 1, 2]);
    assert!(found.windows(2).all(|w| w[1].members.iter().all(|m| w[0].members.contains(m)) && w[0].time < w[1].time));
    assert!(stabilisers(&[]).is_empty());
}

/// Shapes that are not square, with one word in a row and with several, against their entries.
#[test]
fn footprints_of_any_shape_are_their_entries() {
    let ones = |i: usize, j: usize| (3 * i + 5 * j + i * j) % 7 < 2;
    for (rows, cols) in
        [(1usize, 1usize), (2, 3), (3, 2), (5, 5), (3, 64), (64, 3), (2, 65), (65, 2), (70, 130), (65, 65)]
    {
        let context = format!("{rows} x {cols}");
        let f = Footprint::from_fn(rows, cols, ones);
        assert_eq!(f.rows(), rows);
        let inside = |i: usize, j: usize| i < rows && j < cols && ones(i, j);
        let around = || (0..rows + 2).flat_map(|i| (0..cols + 2).map(move |j| (i, j)));
        assert!(around().all(|(i, j)| f.get(i, j) == inside(i, j)), "{context}");
        for j in 0..cols {
            assert_eq!(f.column(j), (0..rows).filter(|&i| ones(i, j)).collect::<Vec<_>>(), "{context}");
        }
        let lines: Vec<String> =
            (0..rows).map(|i| (0..cols).map(|j| if ones(i, j) { '1' } else { '0' }).collect()).collect();
        assert_eq!(f.to_string(), lines.join(" "));
        // Other entries, in this shape and in others: the ones of both, where this one has a place.
        let others = |i: usize, j: usize| (i + 2 * j).is_multiple_of(5);
        for (m, n) in [(rows, cols), (cols, rows), (rows + 1, cols), (rows, cols + 1), (rows.div_ceil(2), cols)] {
            let other = Footprint::from_fn(m, n, others);
            let either = Footprint::from_fn(rows, cols, |i, j| ones(i, j) || (i < m && j < n && others(i, j)));
            assert_eq!(f.or(&other), either, "{context} {m} x {n}");
            assert!(!f.contains(&other) || (m, n) == (rows, cols), "{context} {m} x {n}");
            let nothing = Footprint::from_fn(m, n, |_, _| false);
            assert_eq!(f.contains(&nothing), (m, n) == (rows, cols), "{context} {m} x {n}");
            assert!(either.contains(&f));
        }
        let less = (0..rows).flat_map(|i| (0..cols).map(move |j| (i, j))).filter(|&(i, j)| ones(i, j));
        for (a, b) in less {
            let without = Footprint::from_fn(rows, cols, |i, j| ones(i, j) && (i, j) != (a, b));
            assert!(f.contains(&without) && !without.contains(&f), "{context} {a} {b}");
        }
        // Products by their definition, also with a factor that has too few rows.
        for m in [cols, cols.div_ceil(2)] {
            let right = Footprint::from_fn(m, 67, others);
            let entry = |i: usize, j: usize| (0..m).any(|k| ones(i, k) && others(k, j));
            assert_eq!(f.times(&right), Footprint::from_fn(rows, 67, entry), "{context}");
        }
    }
}

#[test]
fn symmetry_and_diagonals_of_footprints() {
    for n in [1usize, 2, 3, 66] {
        let of = |f: &dyn Fn(usize, usize) -> bool| Footprint::from_fn(n, n, f);
        let symmetric = |i: usize, j: usize| (i * j + i + j).is_multiple_of(3);
        assert!(of(&symmetric).is_symmetric());
        let places = [0, 1, 2, 63, 64, 65].into_iter().filter(|&i| i < n);
        for (a, b) in places.clone().flat_map(|i| places.clone().map(move |j| (i, j))) {
            let altered = |i: usize, j: usize| symmetric(i, j) != ((i, j) == (a, b));
            assert_eq!(of(&altered).is_symmetric(), a == b, "{n} {a} {b}");
            assert_eq!(of(&|i, j| (i, j) != (a, b)).has_full_diagonal(), a != b, "{n} {a} {b}");
        }
    }
    for (rows, cols) in [(2usize, 3usize), (3, 2), (2, 70), (70, 2)] {
        assert!(!Footprint::from_fn(rows, cols, |_, _| true).is_symmetric());
        let diagonal = |without: usize| Footprint::from_fn(rows, cols, |i, j| i == j && i != without);
        assert!(
            diagonal(2).has_full_diagonal() && !diagonal(1).has_full_diagonal() && !diagonal(0).has_full_diagonal()
        );
    }
}

#[test]
fn restrictions_of_footprints() {
    let ones = |i: usize, j: usize| (3 * i + 5 * j + i * j) % 7 < 3;
    let all: Vec<usize> = (0..70).collect();
    let (swapped, backwards) = ([1, 0].into_iter().chain(2..70).collect::<Vec<_>>(), (0..70).rev().collect());
    for (rows, cols) in [(70usize, 70usize), (70, 80), (80, 70), (3, 70), (70, 3), (2, 2), (3, 3)] {
        let f = Footprint::from_fn(rows, cols, ones);
        for to in [
            &all,
            &swapped,
            &backwards,
            &all[..3].to_vec(),
            &all[2..67].to_vec(),
            &vec![2, 2, 0, 79],
            &vec![0, 2],
            &vec![],
        ] {
            let entries = Footprint::from_fn(to.len(), to.len(), |i, j| f.get(to[i], to[j]));
            assert_eq!(f.restricted(to), entries, "{rows} x {cols} {to:?}");
        }
    }
}

#[test]
fn roots_of_footprints_that_are_not_square() {
    // All hear bird 0, through a chain as long as there are birds; or all but one.
    for n in [1usize, 2, 3, 4, 5, 8, 9, 33] {
        for cut in 0..=n {
            let chain = |i: usize, j: usize| i == j + 1 && i != cut;
            assert_eq!(Footprint::from_fn(n, n, chain).is_rooted(), cut == 0 || cut == n, "{n} {cut}");
            assert_eq!(Footprint::from_fn(n, n, |i, j| chain(j, i)).is_rooted(), cut == 0 || cut == n, "{n} {cut}");
        }
    }
    // Each row hears itself, where it has a column: nobody else is added.
    assert!(!Footprint::from_fn(70, 3, |i, j| j == 0 && i != 65).is_rooted());
    assert!(Footprint::from_fn(2, 3, |i, j| (i, j) == (0, 1)).is_rooted());
    assert!(
        Footprint::from_fn(2, 3, |_, j| j == 2).is_rooted() && !Footprint::from_fn(3, 2, |i, j| i == j).is_rooted()
    );
}

/// 130 columns: three words per row.
#[test]
fn wide_footprints() {
    let f = Footprint::from_fn(130, 130, |i, j| j == (i + 1) % 130);
    assert_eq!(f.times(&f), Footprint::from_fn(130, 130, |i, j| j == (i + 2) % 130));
}

#[test]
fn floating_eigenvalues_carry_small_residuals() {
    // Cyclic permutations, on which another solver does not return.
    for n in [4usize, 6, 8, 12] {
        let rows: Vec<Vec<i64>> = (0..n).map(|i| (0..n).map(|j| i64::from(j == (i + 1) % n)).collect()).collect();
        let matrix = to_floats(&RationalMatrix::from_integers(&rows, 1).unwrap());
        let values = eigenvalues(&matrix).unwrap();
        assert_eq!(values.len(), n);
        for value in values {
            // Backward stable: residual of the order of n eps |A|.
            assert!(value.residual < 64.0 * n as f64 * f64::EPSILON, "{value:?}");
            assert!((value.re.hypot(value.im) - 1.0).abs() < 64.0 * n as f64 * f64::EPSILON);
        }
    }
    let worked = to_floats(&RationalMatrix::from_integers(&[[12, 3], [10, 5]], 15).unwrap());
    let values = eigenvalues(&worked).unwrap();
    assert!((values[0].re - 1.0).abs() < 1e-14 && (values[1].re - 2.0 / 15.0).abs() < 1e-14);
    assert!(eigenvalues(&to_floats(&RationalMatrix::from_integers(&[[1, 0]], 1).unwrap())).is_err());
}

/// Products, sums and differences of matrices that are not square, entry by entry.
#[test]
fn matrices_of_any_shape_are_multiplied_and_added() {
    let q = |n: usize, m: usize| rational(n as i64 % 7 - 3, m as i64 % 5 + 1);
    let rows = |m: usize, n: usize, shift: usize| -> Vec<Vec<Rational>> {
        (0..m).map(|i| (0..n).map(|j| q(5 * i + 3 * j + shift, i + 2 * j + shift)).collect()).collect()
    };
    let matrix = |rows: &[Vec<Rational>]| RationalMatrix::from_rows(rows).expect("a matrix");
    for (m, n, r) in [(1, 3, 2), (4, 1, 3), (2, 5, 1), (3, 2, 4)] {
        let (a, b, c) = (rows(m, n, 1), rows(n, r, 2), rows(m, n, 4));
        let product: Vec<Vec<Rational>> =
            a.iter().map(|row| (0..r).map(|j| (0..n).map(|k| &row[k] * &b[k][j]).sum()).collect()).collect();
        assert_eq!(matrix(&a).times(&matrix(&b)).expect("shapes").to_rows(), product);
        let column: Vec<Rational> = b.iter().map(|row| row[0].clone()).collect();
        let first: Vec<Rational> = product.iter().map(|row| row[0].clone()).collect();
        assert_eq!(matrix(&a).apply(&column), Ok(first));
        let pairs = || a.iter().zip(&c).map(|(x, y)| x.iter().zip(y));
        let sum: Vec<Vec<Rational>> = pairs().map(|row| row.map(|(x, y)| x + y).collect()).collect();
        let difference: Vec<Vec<Rational>> = pairs().map(|row| row.map(|(x, y)| x - y).collect()).collect();
        assert_eq!(matrix(&a).plus(&matrix(&c)).expect("shapes").to_rows(), sum);
        assert_eq!(matrix(&a).minus(&matrix(&c)).expect("shapes").to_rows(), difference);
        // Other shapes are refused with both told, also where the number of entries is the same.
        let error = matrix(&a).times(&matrix(&rows(n + 1, r, 0))).expect_err("shapes");
        assert_eq!(error, MatrixError::Shapes { left_cols: n, right_rows: n + 1 });
        let turned = matrix(&a).transpose();
        let error = matrix(&a).plus(&turned).expect_err("shapes");
        assert_eq!(error, MatrixError::DifferentShapes { left: (m, n), right: (n, m) });
        assert!(matrix(&a) != turned && turned.transpose() == matrix(&a));
    }
    // The first row that differs in its length is told.
    let ragged = [vec![rational(1, 1)], vec![], vec![]];
    let error = RationalMatrix::from_rows(&ragged).expect_err("ragged");
    assert_eq!(error, MatrixError::Ragged { row: 2, expected: 1, found: 0 });
}

#[test]
fn applying_a_matrix() {
    let p = RationalMatrix::from_integers(&[[12, 3], [10, 5]], 15).unwrap();
    assert_eq!(p.apply(&[rational(3, 1), rational(-10, 1)]).unwrap(), vec![rational(2, 5), rational(-4, 3)]);
    assert_eq!(p.apply(&[rational(1, 1).one()]).unwrap_err(), MatrixError::Shapes { left_cols: 2, right_rows: 1 });
}

/// Rows (1/6, 3/6, 2/6), (4/6, 0, 2/6), (0, 0, 1): differences by hand.
#[test]
fn diameters_of_rows_in_three_norms() {
    let matrix = RationalMatrix::from_integers(&[[1, 3, 2], [4, 0, 2], [0, 0, 6]], 6).expect("a filled shape");
    assert_eq!(diameter(&matrix, Norm::One), rational(8, 6));
    assert_eq!(diameter(&matrix, Norm::TwoSquared), rational(32, 36));
    assert_eq!(diameter(&matrix, Norm::Infinity), rational(4, 6));
    let lower = RationalMatrix::from_integers(&[[5, 0, 1], [1, 4, 1]], 6).expect("a filled shape");
    assert_eq!(diameter(&lower, Norm::Infinity), rational(4, 6));
    let skew = RationalMatrix::from_integers(&[[6, 0, 0], [1, 3, 2]], 6).expect("a filled shape");
    assert_eq!(diameter(&skew, Norm::Infinity), rational(5, 6));
    let other = RationalMatrix::from_integers(&[[1, 3, 2], [6, 0, 0]], 6).expect("a filled shape");
    assert_eq!(diameter(&other, Norm::Infinity), rational(5, 6));
}

struct Stopped;

impl Progress for Stopped {
    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn work_that_is_stopped_says_so() {
    let matrix = RationalMatrix::from_integers(&[[1, 1], [2, 0]], 2).unwrap();
    assert_eq!(tau_2_squared_watched(&matrix, &Stopped), Err(Cancelled));
    assert_eq!(tau_2_squared_watched(&matrix, &Unwatched), Ok(rational(1, 2)));
    let stochastic = StochasticMatrix::try_from(&matrix).unwrap();
    assert_eq!(stochastic.tau_1_watched(&Stopped), Err(Cancelled));
    assert_eq!(stochastic.times_watched(&stochastic, &Stopped).unwrap_err(), MatrixError::Cancelled(Cancelled));
}

/// Symmetric matrices with a few entries in each row or all of them, and what spoils them, small and large enough for several threads.
#[test]
fn symmetry_is_equality_with_the_transpose() {
    for order in [1usize, 2, 5, 40, 255, 256, 300] {
        for spacing in [1usize, 7] {
            let places = (0..order).flat_map(|i| (0..order).map(move |j| (i, j)));
            let kept = places.filter(|(i, j)| (i + j) % spacing == 0);
            let entries = kept.map(|(i, j)| (i, j, rational((i * j % 5) as i64 - 2, (i + j + 1) as i64)));
            let matrix = SparseMatrix::from_entries(order, entries.clone());
            assert!(matrix.is_symmetric() && matrix == matrix.transpose());
            // The order of the entries does not matter, nor do zeros and sums at one place.
            let halves = entries.clone().map(|(i, j, x)| (i, j, x / rational(2, 1))).collect::<Vec<_>>();
            let twice = halves.iter().rev().chain(&halves).cloned();
            assert_eq!(SparseMatrix::from_entries(order, twice), matrix);
            for place in [(0, order - 1), (order - 1, 0), (order / 2, 0), (0, order / 2)] {
                let one = (place.0, place.1, rational(1, 3));
                let altered = SparseMatrix::from_entries(order, entries.clone().chain([one]));
                let lost = SparseMatrix::from_entries(order, entries.clone().filter(|&(i, j, _)| (i, j) != place));
                for spoilt in [altered, lost] {
                    assert_eq!(spoilt.is_symmetric(), spoilt == spoilt.transpose(), "{order} {spacing} {place:?}");
                }
            }
        }
    }
}

/// Only the part on and below the diagonal is read; rows that do not reach it are refused.
#[test]
fn an_inertia_needs_rows_up_to_the_diagonal() {
    let q = |n: i64| rational(n, 1);
    let signs = |rows: &[Vec<Rational>]| inertia(rows).map(|found| (found.positive, found.negative, found.zero));
    assert_eq!(signs(&[vec![q(0)], vec![q(1), q(0)]]), Ok((1, 1, 0)));
    assert_eq!(signs(&[vec![q(0), q(9)], vec![q(1), q(0), q(9)], vec![q(0), q(0), q(0)]]), Ok((1, 1, 1)));
    assert_eq!(signs(&[]), Ok((0, 0, 0)));
    assert!(signs(&[vec![q(1)], vec![q(1)]]).is_err() && signs(&[vec![]]).is_err());
}
