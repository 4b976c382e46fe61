//! Circulants against exact roots of unity, and their two methods against each other.

use algebra::spectrum::{Circulant, CirculantSpectrum};
use arithmetic::{Field, Interval, Rational, Real, Ring, rational};
use proptest::prelude::*;

/// Real and imaginary part of eigenvalue `k`, straight from the definition.
fn naive(n: usize, row: &[(usize, Rational)], k: usize) -> (Interval, Interval) {
    let one = Interval::from_rational(&rational(1, 1), 120);
    let turn = one.pi() * one.integer(2);
    let mut sum = (one.zero(), one.zero());
    for (s, c) in row {
        let share = Rational::new((s * k % n).into(), n.into());
        let (sin, cos) = (turn.clone() * turn.rational(&share)).sin_cos().expect("an angle");
        sum = (sum.0 + cos * one.rational(c), sum.1 + sin * one.rational(c));
    }
    sum
}

fn float(x: f64) -> Rational {
    Rational::from_float(x).expect("finite")
}

/// Every one of some eigenvalues lies within the bound; returns the largest error against the bound.
fn assert_bounds(found: &CirculantSpectrum, row: &[(usize, Rational)], numbers: impl Iterator<Item = usize>) -> f64 {
    let n = found.order();
    let mut used: f64 = 0.0;
    for k in numbers {
        let (re, im) = naive(n, row, k);
        let parts = [(found.re()[k], re), (found.im().get(k).copied().unwrap_or(0.0), im)];
        for (value, exact) in parts {
            let error = (Interval::from_rational(&float(value), 120) - exact).magnitude().to_f64();
            let radius = found.radius(value);
            assert!(error <= radius + 1e-33, "n = {n}, k = {k}: {value} is off by {error}, bound {radius}");
            used = used.max(error / radius);
        }
    }
    used
}

fn weights(n: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 * 2f64.powi(-53) - 0.5
    };
    (0..n).map(|_| next()).collect()
}

#[test]
fn transforms_of_all_small_lengths() {
    for n in 1..=70 {
        let row = weights(n, n as u64);
        let exact: Vec<(usize, Rational)> = row.iter().map(|&x| float(x)).enumerate().collect();
        let found = Circulant::from_first_row(&row).and_then(|c| c.eigenvalues()).expect("a spectrum");
        assert_eq!(found.re().len(), n / 2 + 1);
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
        assert!(found.im().is_empty());
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
    assert!(zero.re().iter().all(|&x| x == 0.0));
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
