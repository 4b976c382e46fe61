//! Symmetric tridiagonal matrices of floats: every enclosure against exact counts of eigenvalues, and radii as derived.

use super::{SLACK, UNIT, float};
use algebra::spectrum::{FloatEnclosure, tridiagonal_eigenvalues};
use arithmetic::Rational;
use arithmetic::random::{generator, uniform};
use num_traits::{One, Signed, Zero};

/// How many eigenvalues are below a number: the changes of sign from one leading minor of `A - x` to the next, where a zero counts as a change.
fn below(diagonal: &[f64], beside: &[f64], x: &Rational) -> usize {
    let (mut last, mut this, mut count) = (Rational::zero(), Rational::one(), 0);
    for (i, a) in diagonal.iter().enumerate() {
        let square = if i > 0 { float(beside[i - 1]).pow(2) } else { Rational::zero() };
        let next = (float(*a) - x) * &this - square * &last;
        count += usize::from(next.is_zero() || next.is_negative() != this.is_negative() && !this.is_zero());
        // Two minors in a row vanish only where the matrix falls apart; the shifts of the tests are no eigenvalues of parts.
        assert!(!next.is_zero() || !this.is_zero());
        (last, this) = (this, next);
    }
    count
}

fn assert_enclosed(name: &str, diagonal: &[f64], beside: &[f64]) {
    let found = tridiagonal_eigenvalues(diagonal, beside).expect("a bound");
    assert_eq!(found.len(), diagonal.len(), "{name}");
    let size = diagonal.iter().chain(beside).fold(0.0, |most: f64, x| most.max(x.abs()));
    for (k, FloatEnclosure { re, im, radius, multiplicity }) in found.iter().copied().enumerate() {
        assert_eq!((im, multiplicity), (0.0, 1));
        let (lo, hi) = (float(re) - float(radius), float(re) + float(radius));
        assert!(below(diagonal, beside, &lo) <= k && below(diagonal, beside, &hi) > k, "{name}, {k}: {re} {radius}");
        assert!(radius <= 200.0 * UNIT * size + 1e-149, "{name}, {k}: {radius}");
        assert!(k == 0 || found[k - 1].re <= re);
    }
}

#[test]
fn every_enclosure_holds_the_eigenvalue_of_its_number() {
    let mut random = generator("tridiagonals", "entries", 1);
    let mut even = || 2.0 * uniform(&mut random) - 1.0;
    for order in [1, 2, 3, 5, 8, 17, 24] {
        let diagonal: Vec<f64> = (0..order).map(|_| even()).collect();
        let beside: Vec<f64> = (1..order).map(|_| even()).collect();
        assert_enclosed("random", &diagonal, &beside);
        // Nearly equal pairs: Wilkinson's matrix; entries of all sizes; parts that hardly touch, or not at all.
        let middle = (order / 2) as f64;
        let from_middle: Vec<f64> = (0..order).map(|i| (i as f64 - middle).abs()).collect();
        assert_enclosed("Wilkinson", &from_middle, &vec![1.0; order - 1]);
        let graded =
            |x: &[f64], base: f64| -> Vec<f64> { x.iter().enumerate().map(|(i, x)| x * base.powi(i as i32)).collect() };
        assert_enclosed("graded", &graded(&diagonal, 0.1), &graded(&beside, 0.1));
        assert_enclosed("graded the other way", &graded(&diagonal, 7.0), &graded(&beside, 7.0));
        let weak = |weak: f64| -> Vec<f64> { (1..order).map(|i| if i % 3 == 0 { weak } else { 1.0 }).collect() };
        assert_enclosed("glued", &vec![0.3; order], &weak(1e-9));
        assert_enclosed("in parts", &diagonal, &weak(0.0));
        assert_enclosed("around zero", &vec![0.0; order], &beside);
        assert_enclosed("large", &vec![1e90; order], &beside.iter().map(|x| x * 1e90).collect::<Vec<_>>());
    }
    assert_enclosed("all equal", &[0.7; 9], &[0.0; 8]);
}

/// With `s = 14 u max b` (and what underflows), values within `r = 16 u size + s` are proved by counts whose shifts are rounded by `2 u (size + r)`, and the
/// matrix that is counted is within `s`.
#[test]
fn radii_are_those_that_were_derived() {
    for (diagonal, beside, size, largest) in [
        (vec![1.0], vec![], 1.0, 0.0),
        (vec![-3.0, 2.0], vec![0.0], 3.0, 0.0),
        (vec![0.0, 0.0], vec![1.0], 1.0, 1.0),
        (vec![0.0, 0.0, 0.0], vec![-4.0, 3.0], 5.0, 4.0),
        (vec![-8.0; 20], vec![0.0; 19], 8.0, 0.0),
    ] {
        let spread = 14.0 * UNIT * largest;
        let first = 16.0 * UNIT * size + spread;
        let derived = first + 2.0 * UNIT * (size + first) + spread;
        for found in tridiagonal_eigenvalues(&diagonal, &beside).expect("a bound") {
            assert!(
                derived <= found.radius && found.radius <= derived * SLACK.powi(3),
                "{diagonal:?}: {}",
                found.radius / UNIT
            );
        }
    }
    // An entry whose square vanishes is not beyond the bound.
    let hidden = tridiagonal_eigenvalues(&[0.0, 0.0], &[1e-100]).expect("a bound");
    assert!(hidden.iter().all(|x| x.re.abs() + 1e-100 <= 2e-100 + x.radius && x.radius >= 1e-150));
}

#[test]
fn what_is_no_matrix_or_out_of_range_is_refused() {
    for (diagonal, beside) in [(0, 0), (2, 0), (1, 1), (3, 3), (3, 1)] {
        assert!(tridiagonal_eigenvalues(&vec![1.0; diagonal], &vec![1.0; beside]).is_err(), "{diagonal}, {beside}");
    }
    for bad in [1e101, -1e101, 1e-101, -1e-101, f64::NAN, f64::INFINITY] {
        assert!(tridiagonal_eigenvalues(&[1.0, bad], &[1.0]).is_err());
        assert!(tridiagonal_eigenvalues(&[1.0, 1.0], &[bad]).is_err());
    }
    assert!(tridiagonal_eigenvalues(&[0.0, -1e99], &[-0.0]).is_ok());
}
