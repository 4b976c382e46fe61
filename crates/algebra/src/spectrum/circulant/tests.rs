//! Circulants against exact roots of unity, and their two methods against each other.

use super::super::float_bounds::{SLACK, UNDERFLOW, UNIT};
use super::super::fourier::real_transform;
use super::super::testing::{assert_equals, float, naive, weights};
use super::super::turn::{CHORD_ERROR, ROOT_ERROR};
use super::{Circulant, CirculantSpectrum};
use arithmetic::{Interval, Rational, rational};
use num_traits::ToPrimitive;
use proptest::prelude::*;

/// Every one of some eigenvalues lies within the bound; returns the largest error against the bound.
fn assert_bounds(found: &CirculantSpectrum, row: &[(usize, Rational)], numbers: impl Iterator<Item = usize>) -> f64 {
    let n = found.order;
    let mut used: f64 = 0.0;
    for k in numbers {
        let (re, im) = naive(n, row, k);
        let parts = [(found.re[k], re), (found.im.get(k).copied().unwrap_or(0.0), im)];
        for (value, exact) in parts {
            let error = (Interval::from_rational(&float(value), 120) - exact).magnitude().to_f64();
            let radius = found.radius(value);
            assert!(error <= radius + 1e-33, "n = {n}, k = {k}: {value} is off by {error}, bound {radius}");
            used = used.max(error / radius);
        }
    }
    used
}

#[test]
fn transforms_of_all_small_lengths() {
    for n in 1..=70 {
        let row = weights(n, n as u64);
        let exact: Vec<(usize, Rational)> = row.iter().map(|&x| float(x)).enumerate().collect();
        let found = Circulant::from_first_row(&row).and_then(|c| c.eigenvalues()).expect("a spectrum");
        assert_eq!(found.re.len(), n / 2 + 1);
        assert_bounds(&found, &exact, 0..=n / 2);
    }
}

#[test]
fn transforms_of_long_rows() {
    // Powers of two, primes and composites.
    for n in [1024usize, 2048, 1021, 1000, 2187] {
        let row = weights(n, 7 + n as u64);
        let exact: Vec<(usize, Rational)> = row.iter().map(|&x| float(x)).enumerate().collect();
        let found = Circulant::from_first_row(&row).and_then(|c| c.eigenvalues()).expect("a spectrum");
        let size: f64 = row.iter().map(|x| x.abs()).sum();
        assert!(found.absolute < 2e-12 * size, "{n}: {}", found.absolute);
        assert_bounds(&found, &exact, [1, n / 3, n / 2].into_iter());
    }
}

#[test]
fn large_sparse_rows_and_the_bound_of_a_laplacian() {
    for n in [1usize << 16, 65_537, 60_000] {
        let arcs =
            |sign: i64| (1..9).flat_map(move |j| [(j, rational(sign, j as i64)), (n - j, rational(sign, j as i64))]);
        let found = Circulant::laplacian(n, arcs(1)).and_then(|c| c.eigenvalues()).expect("a spectrum");
        let row: Vec<(usize, Rational)> =
            arcs(-1).chain([(0, (1..9).map(|j| rational(2, j)).sum::<Rational>())]).collect();
        assert!(found.absolute < 1e-200 && found.relative < 4e-15, "{} {}", found.absolute, found.relative);
        assert!(found.im.is_empty());
        assert_bounds(&found, &row, [0, 1, 2, 17, n / 5, n / 2 - 1, n / 2].into_iter());
    }
}

#[test]
fn rows_in_exact_ranges_only() {
    assert!(Circulant::from_first_row(&[]).is_err());
    assert!(Circulant::from_first_row(&[1.0, f64::NAN]).is_err());
    assert!(Circulant::from_first_row(&[1.0, 1e200]).is_err());
    assert!(Circulant::new(0, []).is_err());
    assert!(Circulant::laplacian(0, [(1, rational(1, 1))]).is_err());
    let zero = Circulant::new(5, []).and_then(|c| c.eigenvalues()).expect("zeros");
    assert!(zero.re.iter().all(|&x| x == 0.0));
}

#[test]
fn weights_whose_floats_alone_are_symmetric() {
    let third = rational(1, 3);
    let more = &third + Rational::new(1.into(), num_bigint::BigInt::from(10).pow(30));
    for count in [1, 30] {
        let n = 2 * count + 3;
        let arcs = |s: usize| [(s, third.clone()), (n - s, if s == 1 { more.clone() } else { third.clone() })];
        let row: Vec<(usize, Rational)> = (1..=count).flat_map(arcs).collect();
        let matrix = Circulant::new(n, row.clone()).expect("in range");
        assert!(!matrix.is_symmetric());
        let found = matrix.eigenvalues().expect("a spectrum");
        assert_eq!(found.im.len(), n / 2 + 1);
        assert_bounds(&found, &row, 0..=n / 2);
        let enclosed = found.enclosures().expect("finite");
        assert!(enclosed.iter().filter(|part| part.is_real()).all(|part| part.multiplicity == 1));
    }
}

#[test]
fn symmetry_is_that_of_the_weights() {
    let symmetric = |row: &[f64]| Circulant::from_first_row(row).expect("in range").is_symmetric();
    assert!(symmetric(&[5.0]) && symmetric(&[5.0, 2.0]) && symmetric(&[1.0, 2.0, 3.0, 2.0]));
    assert!(
        !symmetric(&[1.0, 2.0, 3.0]) && !symmetric(&[1.0, 2.0, 0.0, 0.0]) && !symmetric(&[1.0, 1.0, 3.0, 4.0, 2.0])
    );
    let symmetric = |entries: &[(usize, i64)]| {
        let row = entries.iter().map(|&(s, c)| (s, rational(c, 1)));
        Circulant::new(6, row).expect("in range").is_symmetric()
    };
    assert!(symmetric(&[]) && symmetric(&[(0, 3)]) && symmetric(&[(3, 1)]) && symmetric(&[(1, 2), (5, 2), (2, 0)]));
    assert!(!symmetric(&[(1, 2)]) && !symmetric(&[(1, 2), (5, 3)]) && !symmetric(&[(4, 2), (5, 2)]));
}

/// The bound of the sums: `(CHORD_ERROR + e + (J + 3) u) S`, where `S` is `|r| + |λ|` for weights of one sign and otherwise twice the sum
/// of all weights, and the error of the sines; a rounding for the difference.
#[test]
fn the_bound_of_sums_is_the_formula() {
    let third = rational(1, 3);
    let quarter = rational(1, 4);
    // Order, entries, pairs of offsets, sum of the sizes of all entries, whether the weights are of one sign.
    let cases = [
        (7, vec![(1, quarter.clone()), (6, quarter.clone()), (0, rational(-1, 2))], 1, 1.0, true),
        (7, vec![(1, -quarter.clone()), (3, -quarter.clone()), (4, rational(-1, 2))], 2, 1.0, true),
        (7, vec![(1, quarter.clone()), (3, -quarter.clone()), (4, rational(-1, 2))], 2, 1.0, false),
        (7, vec![(1, -quarter.clone()), (2, quarter.clone())], 2, 0.5, false),
        (6, vec![(3, third.clone()), (0, rational(1, 3))], 1, 2.0 / 3.0, true),
        (9, vec![(4, third.clone()), (5, -third.clone()), (0, rational(-5, 1))], 1, 17.0 / 3.0, false),
        (9, vec![(4, quarter.clone()), (5, third.clone()), (0, rational(-7, 12))], 1, 7.0 / 6.0, true),
        (5, vec![(0, third.clone())], 0, 1.0 / 3.0, true),
        (5, vec![(1, -third.clone()), (2, quarter.clone()), (0, rational(-1, 12))], 2, 2.0 / 3.0, false),
    ];
    for (n, row, pairs, sum, one_sign) in cases {
        let context = format!("{n} {row:?}");
        let matrix = Circulant::new(n, row.clone()).expect("in range");
        let found = matrix.eigenvalues().expect("a spectrum");
        // Thirds and twelfths are within four units of their floats, the others are floats.
        let inexact = |q: &Rational| Rational::from_float(q.to_f64().unwrap_or(0.0)).as_ref() != Some(q);
        let weight_error = if row.iter().any(|(_, c)| inexact(c)) { 4.0 * UNIT * SLACK } else { 0.0 };
        let r: Rational = row.iter().map(|(_, c)| c).sum();
        let row_error = if inexact(&r) { 4.0 * UNIT * r.to_f64().unwrap_or(0.0).abs() } else { 0.0 };
        let rounding = weight_error + (pairs as f64 + 3.0) * UNIT;
        let eta = (CHORD_ERROR + rounding) * SLACK;
        let size = if one_sign { r.to_f64().unwrap_or(0.0).abs() } else { 2.0 * sum * SLACK };
        let sines = if matrix.is_symmetric() { 0.0 } else { (ROOT_ERROR + rounding) * sum * SLACK };
        assert_equals(found.absolute, (eta * size + row_error).max(sines) * SLACK + UNDERFLOW, &context);
        assert_equals(found.relative, (if one_sign { eta + UNIT } else { UNIT }) * SLACK, &context);
        assert_equals(found.radius(-3.0), (found.absolute + found.relative * 3.0) * SLACK, &context);
        assert_bounds(&found, &row, 0..=n / 2);
    }
}

#[test]
fn sums_are_taken_up_to_48_offsets() {
    // Weights that are floats, so that the transform alone makes the error.
    let row = |count: usize| (1..=count).map(|s| (2 * s, rational(s as i64, 8))).chain([(0, rational(-3, 2))]);
    for (count, by_sums) in [(48, true), (49, false)] {
        let matrix = Circulant::new(120, row(count)).expect("in range");
        let found = matrix.eigenvalues().expect("a spectrum");
        assert_eq!(found.relative > 0.0, by_sums);
        if !by_sums {
            let mut floats = vec![0.0; 120];
            row(count).for_each(|(s, c)| floats[s] = c.to_f64().expect("a float"));
            let (_, error) = real_transform(&floats).expect("finite");
            assert_equals(found.absolute, error * SLACK, "the bound of the transform");
        }
        assert_bounds(&found, &row(count).collect::<Vec<_>>(), 0..=60);
    }
}

#[test]
fn the_error_of_weights_is_added_to_that_of_the_transform() {
    for diagonal in [rational(-5, 7), rational(0, 1)] {
        let row: Vec<(usize, Rational)> =
            (1..60).map(|s| (s, rational(s as i64, 3))).chain([(0, diagonal.clone())]).collect();
        let found = Circulant::new(61, row.clone()).and_then(|c| c.eigenvalues()).expect("a spectrum");
        let mut floats = vec![0.0; 61];
        row.iter().for_each(|(s, c)| floats[*s] = c.to_f64().expect("a float"));
        let (_, error) = real_transform(&floats).expect("finite");
        let size = (diagonal.to_f64().expect("a float").abs() + 590.0) * SLACK;
        assert_equals(found.absolute, (error + 4.0 * UNIT * SLACK * size) * SLACK, "transform and weights");
        assert_bounds(&found, &row, 0..=30);
    }
}

#[test]
fn transforms_of_symmetric_rows_are_real() {
    let row: Vec<f64> = (0..101usize).map(|s| 1.0 / (s.min(101 - s) + 1) as f64).collect();
    let matrix = Circulant::from_first_row(&row).expect("in range");
    let found = matrix.eigenvalues().expect("a spectrum");
    assert!(found.relative == 0.0 && found.im.is_empty());
    assert!(found.enclosures().expect("finite").iter().all(|part| part.is_real()));
}

#[test]
fn rows_may_have_zeros_and_ones() {
    for row in [vec![0.0, 1.0, 0.0, 0.0, -1.0], vec![1.0, 1.0, 1.0], vec![0.0; 4]] {
        let exact: Vec<(usize, Rational)> = row.iter().map(|&x| float(x)).enumerate().collect();
        let found = Circulant::from_first_row(&row).and_then(|c| c.eigenvalues()).expect("a spectrum");
        assert!(found.absolute > 0.0);
        assert_bounds(&found, &exact, 0..=row.len() / 2);
    }
}

/// Each enclosure holds as many of the exact eigenvalues as it says, and together they hold all.
#[test]
fn enclosures_hold_the_eigenvalues() {
    for (n, mirrored) in [(1usize, false), (2, true), (7, false), (8, false), (7, true), (8, true)] {
        let mut row = vec![(0, rational(1, 3)), (1 % n, rational(2, 7)), (2 % n, rational(-1, 5))];
        if mirrored {
            row.extend(row.clone().into_iter().map(|(s, c)| (n - s, c)));
        }
        let found = Circulant::new(n, row.clone()).and_then(|c| c.eigenvalues()).expect("a spectrum");
        let parts = found.enclosures().expect("finite");
        let exact: Vec<_> = (0..n).map(|k| naive(n, &row, k)).collect();
        for part in &parts {
            let held = exact.iter().filter(|(re, im)| part.re.overlaps(re) && part.im.overlaps(im));
            assert_eq!(held.count(), part.multiplicity, "{n} {mirrored} {part:?}");
            // No eigenvalue is larger than 2.
            assert!(part.re.width().to_f64() < 2.0 * found.radius(2.0) + 1e-15 && (!mirrored || part.is_real()));
        }
        assert_eq!(parts.iter().map(|part| part.multiplicity).sum::<usize>(), n);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn sums_of_few_offsets(
        n in 1usize..400,
        entries in prop::collection::vec((0usize..400, -50i64..50, 1i64..20), 0..9),
        mirrored in any::<bool>(),
    ) {
        let mut row: Vec<(usize, Rational)> = entries.into_iter().map(|(s, p, q)| (s % n, rational(p, q))).collect();
        if mirrored {
            row.extend(row.clone().into_iter().map(|(s, c)| (n - s, c)));
        }
        let matrix = Circulant::new(n, row.clone()).expect("in range");
        prop_assert!(!mirrored || matrix.is_symmetric());
        let found = matrix.eigenvalues().expect("a spectrum");
        assert_bounds(&found, &row, 0..=n / 2);
        let enclosed = found.enclosures().expect("finite");
        prop_assert_eq!(enclosed.iter().map(|part| part.multiplicity).sum::<usize>(), n);
    }
}
