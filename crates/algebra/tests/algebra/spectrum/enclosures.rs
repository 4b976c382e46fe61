//! Closed forms and enclosures against exact characteristic polynomials.

use algebra::graph::{LaplacianKind, NamedGraph, WeightedGraph};
use algebra::matrix::{CharacteristicPolynomial, SparseMatrix};
use algebra::spectrum::{
    CyclotomicSum, Eigenvalue, Method, Spectrum, SpectrumError, closed_form, matrix_spectrum, named_spectrum,
    real_spectrum,
};
use arithmetic::{Rational, rational};
use num_traits::Zero;
use proptest::prelude::*;

fn named(text: &str) -> NamedGraph {
    text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn spectrum(text: &str, kind: LaplacianKind, digits: Option<u32>) -> Spectrum {
    named_spectrum(&named(text), kind, digits).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn multiplicities(spectrum: &Spectrum) -> Vec<usize> {
    spectrum.eigenvalues.iter().map(|part| part.multiplicity).collect()
}

/// As many roots of a polynomial with real roots only in the closed enclosure as it says.
fn assert_counts(polynomial: &CharacteristicPolynomial, part: &Eigenvalue, context: &str) {
    assert!(part.is_real(), "{context}");
    let (lo, hi) = part.re.to_rationals();
    let inside = polynomial.degree() - polynomial.count_below(&lo) - polynomial.count_above(&hi);
    assert_eq!(inside, part.multiplicity, "{context}: {:?}", part);
    if let Some(exact) = &part.exact {
        assert_eq!(polynomial.multiplicity(exact), part.multiplicity, "{context}: {exact}");
    }
}

/// Sums of powers are traces of powers: the eigenvalues with their multiplicities are right, complex ones too.
fn assert_power_sums(matrix: &SparseMatrix, parts: &[Eigenvalue], context: &str) {
    use arithmetic::{Complex, Ring};
    let dense = matrix.to_dense().expect("not empty");
    let mut power = dense.clone();
    for exponent in 1..=matrix.order() as u64 {
        let trace: Rational = (0..matrix.order()).map(|i| power.entry(i, i)).sum();
        let Some(first) = parts.first() else { panic!("{context}: empty") };
        let zero = Complex::new(first.re.zero(), first.re.zero());
        let sum = parts.iter().fold(zero, |sum, part| {
            let z = Complex::new(part.re.clone(), part.im.clone()).power(exponent);
            sum + z.scale(&part.re.integer(part.multiplicity as i64))
        });
        assert!(sum.re.contains(&trace) && sum.im.contains_zero(), "{context}: power {exponent}, {trace}");
        power = power.times(&dense).expect("square");
    }
}

#[test]
fn closed_forms_are_the_spectra_of_small_graphs() {
    let mut compared = 0;
    for n in 1..=12usize {
        let mut names: Vec<String> =
            ["ring", "cycle", "path", "complete", "star", "platoon1", "platoon2"].map(|f| format!("{f}:{n}")).to_vec();
        for code in 1..1usize << (n / 2).min(5) {
            let offsets: Vec<String> =
                (1..=n / 2).filter(|a| code >> (a - 1) & 1 == 1).map(|a| a.to_string()).collect();
            names.push(format!("circulant:{n}:{}", offsets.join(",")));
        }
        for name in names {
            let Ok(graph) = name.parse::<NamedGraph>() else { continue };
            for (kind_name, kind) in LaplacianKind::NAMES {
                let context = format!("{name} {kind_name}");
                let Some(form) = closed_form(&graph, kind) else { continue };
                let parts = form.enclose(30).expect("enclosed");
                let matrix = graph.build().expect("small").matrix(kind).expect(&context);
                assert_eq!(parts.iter().map(|p| p.multiplicity).sum::<usize>(), matrix.order(), "{context}");
                let polynomial = matrix.to_dense().expect("dense").characteristic_polynomial().expect("square");
                match real_spectrum(&matrix.to_dense().expect("dense"), 30).expect("square") {
                    Some(exact) => {
                        parts.iter().for_each(|part| assert_counts(&polynomial, part, &context));
                        assert_eq!(exact.len(), parts.len(), "{context}");
                        for (a, b) in exact.iter().zip(&parts) {
                            assert!(a.re.overlaps(&b.re) && a.multiplicity == b.multiplicity, "{context}");
                            assert_eq!(a.exact, b.exact, "{context}");
                        }
                    }
                    None => assert_power_sums(&matrix, &parts, &context),
                }
                compared += 1;
            }
        }
    }
    assert!(compared > 800, "{compared}");
}

#[test]
fn multiplicities_of_rings() {
    for n in 3..60usize {
        let found = multiplicities(&spectrum(&format!("ring:{n}"), LaplacianKind::Combinatorial, Some(5)));
        let mut expected = vec![2; n / 2 + 1];
        expected[0] = 1;
        if n % 2 == 0 {
            expected[n / 2] = 1;
        }
        assert_eq!(found, expected, "{n}");
    }
}

#[test]
fn sums_of_roots_of_unity_are_compared_exactly() {
    // The n-th roots of unity sum to zero, and cos(pi/5) - cos(2 pi/5) = 1/2.
    for n in 2..40 {
        assert!(CyclotomicSum::new(n, 1, (0..n).map(|k| (k, 1))).unwrap().is_zero());
        assert!(!CyclotomicSum::new(n, 1, (1..n).map(|k| (k, 1))).unwrap().is_zero());
    }
    let golden = CyclotomicSum::new(10, 2, [(1, 1), (9, 1), (2, -1), (8, -1), (0, -1)]).unwrap();
    assert!(golden.is_zero() && golden.is_real());
    assert!(!CyclotomicSum::new(10, 1, [(1, 1)]).unwrap().is_real());
}

#[test]
fn digits_are_kept() {
    for digits in [1, 17, 100, 1000] {
        for part in spectrum("path:9", LaplacianKind::Combinatorial, Some(digits)).eigenvalues {
            let (lo, hi) = part.re.to_rationals();
            let width = &hi - &lo;
            assert!(width * rational(10, 1).pow(digits as i32) <= lo || hi.is_zero());
        }
    }
    let refused = |digits| named_spectrum(&named("ring:5"), LaplacianKind::Walk, Some(digits)).expect_err("refused");
    assert_eq!(refused(0), SpectrumError::Digits(0));
    assert_eq!(refused(10_001), SpectrumError::Digits(10_001));
    let graph = named("geometric:60:1/3:1");
    let error = named_spectrum(&graph, LaplacianKind::Combinatorial, Some(50)).expect_err("too many");
    assert!(matches!(error, SpectrumError::TooManyDigits { asked: 50, possible: 8..=15, .. }), "{error}");
    assert!(named_spectrum(&graph, LaplacianKind::Combinatorial, Some(8)).is_ok());
}

#[test]
fn floating_enclosures_hold_exact_spectra() {
    for seed in 1..6 {
        for kind in
            [LaplacianKind::Combinatorial, LaplacianKind::Walk, LaplacianKind::Adjacency, LaplacianKind::Reduced]
        {
            let text = format!("geometric:16:1/2:{seed}");
            let context = format!("{text} {}", kind.name());
            let found = spectrum(&text, kind, None);
            assert_eq!(found.eigenvalues.iter().map(|p| p.multiplicity).sum::<usize>(), found.order, "{context}");
            let matrix = named(&text).build().expect("small").matrix(kind).expect("exists");
            let polynomial = matrix.to_dense().expect("dense").characteristic_polynomial().expect("square");
            found.eigenvalues.iter().for_each(|part| assert_counts(&polynomial, part, &context));
        }
    }
}

#[test]
fn multiple_eigenvalues_come_as_one_enclosure() {
    let matrix = named("ring:40").build().expect("small").matrix(LaplacianKind::Combinatorial).expect("exists");
    let found = matrix_spectrum(&matrix, None).expect("certified");
    assert_eq!(found.method, Method::Certified);
    let exact = spectrum("ring:40", LaplacianKind::Combinatorial, None);
    assert_eq!(multiplicities(&found), multiplicities(&exact));
    for (wide, thin) in found.eigenvalues.iter().zip(&exact.eigenvalues) {
        assert!(wide.re.encloses(&thin.re) && wide.re.width().to_f64() < 1e-11);
    }
}

/// Symmetric matrices with entries p/q.
fn symmetric() -> impl Strategy<Value = SparseMatrix> {
    (2usize..8).prop_flat_map(|n| {
        prop::collection::vec((-9i64..10, 1i64..8), n * n).prop_map(move |entries| {
            let entry = |k: usize| (k / n, k % n, rational(entries[k].0, entries[k].1));
            let lower = (0..n * n).filter(move |k| k / n >= k % n);
            SparseMatrix::from_entries(
                n,
                lower.flat_map(|k| {
                    let (i, j, x) = entry(k);
                    if i == j { vec![(i, j, x)] } else { vec![(i, j, x.clone()), (j, i, x)] }
                }),
            )
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    /// Two copies of a matrix, the second shifted by a tiny number or not: floating point and exact arithmetic agree.
    #[test]
    fn doubled_symmetric_matrices(matrix in symmetric(), shift in prop_oneof![Just(0i64), Just(1i64)]) {
        let n = matrix.order();
        let shift = rational(shift, 1i64 << 45);
        let copies = matrix.entries().flat_map(|(i, j, x)| [(i, j, x.clone()), (n + i, n + j, x.clone())]);
        let shifted = (n..2 * n).map(|i| (i, i, shift.clone()));
        let doubled = SparseMatrix::from_entries(2 * n, copies.chain(shifted));
        let polynomial = doubled.to_dense().expect("dense").characteristic_polynomial().expect("square");
        let exact = matrix_spectrum(&doubled, Some(40)).expect("exact");
        prop_assert_eq!(exact.method, Method::Exact);
        exact.eigenvalues.iter().for_each(|part| assert_counts(&polynomial, part, "exact"));
        prop_assert_eq!(exact.eigenvalues.iter().map(|p| p.multiplicity).sum::<usize>(), 2 * n);
        // The irreducible whole in floating point: mix the copies by an exact rotation (3/5, 4/5).
        let rotated = rotate(&doubled, n);
        let found = algebra::spectrum::symmetric_enclosures(&rotated).expect("certified");
        found.iter().for_each(|part| assert_counts(&polynomial, part, "certified"));
        prop_assert_eq!(found.iter().map(|p| p.multiplicity).sum::<usize>(), 2 * n);
    }
}

/// `Q A Q^T` with `Q = [[3, 4], [-4, 3]]/5` acting on the two halves.
fn rotate(matrix: &SparseMatrix, half: usize) -> SparseMatrix {
    let turn = (0..half).flat_map(|i| {
        let (c, s) = (rational(3, 5), rational(4, 5));
        [(i, i, c.clone()), (i, half + i, s.clone()), (half + i, i, -s), (half + i, half + i, c)]
    });
    let turn = SparseMatrix::from_entries(2 * half, turn).to_dense().expect("dense");
    let product = turn.times(&matrix.to_dense().expect("dense")).and_then(|m| m.times(&turn.transpose()));
    SparseMatrix::from_dense(&product.expect("shapes")).expect("square")
}

#[test]
fn cyclic_permutations_return() {
    for n in [2usize, 3, 4, 6, 8, 12, 24, 40, 64, 100] {
        let arcs = (0..n).map(|i| (i, (i + 1) % n, rational(1, 1)));
        let matrix = SparseMatrix::from_entries(n, arcs);
        let found = matrix_spectrum(&matrix, None).expect("discs");
        let exact = spectrum(&format!("cycle:{n}"), LaplacianKind::Adjacency, Some(30)).eigenvalues;
        assert_eq!(found.eigenvalues.len(), n, "{n}");
        for thin in exact {
            let hits = found.eigenvalues.iter().filter(|p| p.re.overlaps(&thin.re) && p.im.overlaps(&thin.im));
            assert_eq!(hits.map(|p| p.multiplicity).sum::<usize>(), 1, "{n}");
        }
        let real = found.eigenvalues.iter().filter(|p| p.is_real()).count();
        assert_eq!(real, 2 - n % 2, "{n}: real eigenvalues");
    }
}

#[test]
fn defective_and_complex_blocks() {
    // The companion matrix of (x² + 1)² (x - 2): i and -i twice, with one eigenvector each.
    let last = [2i64, -1, 4, -2, 2];
    let companion = (0..4).map(|i| (i + 1, i, rational(1, 1)));
    let column = last.iter().enumerate().map(|(i, &c)| (i, 4, rational(c, 1)));
    let matrix = SparseMatrix::from_entries(5, companion.chain(column));
    let found = matrix_spectrum(&matrix, Some(50)).expect("exact");
    assert_eq!((found.method, multiplicities(&found)), (Method::Exact, vec![2, 2, 1]));
    assert_power_sums(&matrix, &found.eigenvalues, "companion");
    assert_eq!(found.eigenvalues[2].exact, Some(rational(2, 1)));
}

/// `I + N` of order `n` with a corner that keeps it irreducible: its eigenvalues lie on a circle around 1 of the radius
/// `corner^(1/n)`.
fn nearly_jordan(n: usize, corner: Rational) -> SparseMatrix {
    let ones = (0..n).map(|i| (i, i, rational(1, 1)));
    let above = (1..n).map(|i| (i - 1, i, rational(1, 1)));
    SparseMatrix::from_entries(n, ones.chain(above).chain([(n - 1, 0, corner)]))
}

#[test]
fn large_defective_blocks_have_wide_but_true_bounds() {
    for n in [41usize, 60, 100] {
        let matrix = nearly_jordan(n, Rational::new(1.into(), num_bigint::BigInt::from(10).pow(90)));
        let found = matrix_spectrum(&matrix, None).expect("a bound");
        assert_eq!(found.eigenvalues.iter().map(|p| p.multiplicity).sum::<usize>(), n);
        let circle = 10f64.powf(-90.0 / n as f64);
        for k in 0..n {
            let angle = std::f64::consts::TAU * k as f64 / n as f64;
            let (re, im) = (1.0 + circle * angle.cos(), circle * angle.sin());
            let inside = |part: &&Eigenvalue| {
                let holds =
                    |x: &arithmetic::Interval, y: f64| x.lo().to_f64() - 1e-12 <= y && y <= x.hi().to_f64() + 1e-12;
                holds(&part.re, re) && holds(&part.im, im)
            };
            assert!(found.eigenvalues.iter().any(|part| inside(&part)), "{n} {k}");
        }
        let width = found.eigenvalues.iter().map(|part| part.re.width().to_f64()).fold(0.0, f64::max);
        assert!(width < 4.0, "{n}: {width}");
    }
}

#[test]
fn directed_paths_and_trees_are_triangular() {
    // The walk Laplacian of a directed path has a Jordan block of order n - 1: the blocks of order one give it exactly.
    for n in [2usize, 50, 2000] {
        let arcs = (1..n).map(|i| (i, i - 1, rational(1, 1)));
        for kind in [LaplacianKind::Walk, LaplacianKind::OutDegree] {
            let matrix = WeightedGraph::from_arcs(n, arcs.clone()).matrix(kind).expect("exists");
            let found = matrix_spectrum(&matrix, None).expect("triangular");
            assert_eq!((found.method, multiplicities(&found)), (Method::Exact, vec![1, n - 1]));
            assert_eq!(found.eigenvalues[1].exact, Some(rational(1, 1)));
        }
    }
}

/// Weighted paths `D - A` with given weights, and a leader at one end.
fn weighted_path(weights: &[(i64, i64)]) -> SparseMatrix {
    let n = weights.len() + 1;
    let edge = |(i, &(p, q)): (usize, &(i64, i64))| {
        let w = rational(p, q);
        [(i, i + 1, -w.clone()), (i + 1, i, -w.clone()), (i, i, w.clone()), (i + 1, i + 1, w)]
    };
    SparseMatrix::from_entries(n, weights.iter().enumerate().flat_map(edge))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn counts_enclose_weighted_paths(weights in prop::collection::vec((1i64..1000, 1i64..1000), 13..20)) {
        let matrix = weighted_path(&weights);
        let polynomial = matrix.to_dense().expect("dense").characteristic_polynomial().expect("square");
        let found = matrix_spectrum(&matrix, None).expect("certified");
        prop_assert_eq!(found.method, Method::Certified);
        prop_assert_eq!(found.eigenvalues.iter().map(|p| p.multiplicity).sum::<usize>(), matrix.order());
        found.eigenvalues.iter().for_each(|part| assert_counts(&polynomial, part, "path"));
    }

    #[test]
    fn discs_enclose_directed_graphs(entries in prop::collection::vec((-9i64..10, 1i64..8), 14 * 14)) {
        let entries = entries.iter().enumerate().map(|(k, &(p, q))| (k / 14, k % 14, rational(p, q)));
        let matrix = SparseMatrix::from_entries(14, entries);
        if let Ok(found) = matrix_spectrum(&matrix, None) {
            prop_assert_eq!(found.eigenvalues.iter().map(|p| p.multiplicity).sum::<usize>(), 14);
            assert_power_sums(&matrix, &found.eigenvalues, "directed");
            // The exact roots lie in the discs, one for one.
            let exact = matrix_spectrum(&matrix, Some(30)).expect("exact");
            prop_assert_eq!(exact.method, Method::Exact);
            for wide in &found.eigenvalues {
                let hits = exact.eigenvalues.iter().filter(|p| wide.re.overlaps(&p.re) && wide.im.overlaps(&p.im));
                prop_assert_eq!(hits.map(|p| p.multiplicity).sum::<usize>(), wide.multiplicity);
            }
        }
    }
}

#[test]
fn long_paths_agree_with_their_closed_form() {
    let matrix = named("path:500").build().expect("small").matrix(LaplacianKind::Combinatorial).expect("exists");
    let found = matrix_spectrum(&matrix, None).expect("certified");
    let exact = spectrum("path:500", LaplacianKind::Combinatorial, None);
    assert_eq!(found.eigenvalues.len(), 500);
    for (wide, thin) in found.eigenvalues.iter().zip(&exact.eigenvalues) {
        assert!(wide.re.encloses(&thin.re) && wide.re.width().to_f64() < 1e-13);
    }
}

#[test]
fn small_matrices_are_enclosed_as_exactly() {
    use algebra::graph::LaplacianKind;
    use algebra::graph::classes::graphs;
    use algebra::spectrum::small_symmetric_eigenvalues;
    use arithmetic::Unwatched;
    use num_traits::ToPrimitive;
    for order in 1..=6 {
        for graph in graphs(order, &Unwatched).expect("graphs") {
            let matrix =
                algebra::graph::WeightedGraph::from(&graph).matrix(LaplacianKind::Combinatorial).expect("a matrix");
            let entry = |place: usize| {
                matrix.get(place / order, place % order).map_or(0.0, |x| x.to_integer().to_f64().expect("small"))
            };
            let entries: Vec<f64> = (0..order * order).map(entry).collect();
            let found = small_symmetric_eigenvalues(&entries, order).expect("proved");
            let exact = algebra::spectrum::matrix_spectrum(&matrix, Some(20)).expect("exact").eigenvalues;
            let exact: Vec<f64> =
                exact.iter().flat_map(|part| std::iter::repeat_n(part.re.to_f64(), part.multiplicity)).collect();
            for (own, value) in found.iter().zip(&exact) {
                assert!((own.re - value).abs() <= own.radius + 1e-15 && own.radius < 1e-13, "{own:?} {value}");
            }
        }
    }
    assert!(small_symmetric_eigenvalues(&[0.0, 1.0, 2.0, 0.0], 2).is_none());
    assert!(small_symmetric_eigenvalues(&[0.0, f64::NAN, f64::NAN, 0.0], 2).is_none());
}
