//! Fast Fourier transforms against exact roots of unity, and their bounds against the derivation.

use super::super::float_bounds::{SLACK, UNDERFLOW, UNIT};
use super::super::testing::{assert_equals, float, naive, weights};
use super::super::turn::ROOT_ERROR;
use super::{real_transform, transform_error};
use arithmetic::{Interval, Rational};

/// A product of complex floats: `√5 u`, rounded up.
const PRODUCT: f64 = 2.24 * UNIT;

/// A sum for each binary digit; the length is split into two, each with passes of radix four and at most one of radix two, each pass
/// with a root; two more products between them.
#[test]
fn the_error_of_a_power_of_two_is_the_formula() {
    for log in 0..24u32 {
        let (first, second) = (log - log / 2, log / 2);
        let passes = f64::from(first - first / 2 + (second - second / 2));
        let root = PRODUCT + ROOT_ERROR;
        assert_equals(
            transform_error(1 << log),
            (f64::from(log) * UNIT + (passes + 2.0) * root) * SLACK,
            "a power of two",
        );
    }
}

/// The bound that the comment on each method derives.
fn documented(x: &[f64]) -> f64 {
    let n = x.len();
    let norm = |power: i32| x.iter().map(|x| x.abs().powi(power)).sum::<f64>();
    if n.is_power_of_two() {
        let last = 2.0 * PRODUCT + 2.0 * ROOT_ERROR + 4.0 * UNIT;
        return (2.0 * transform_error(n / 2) + last) * norm(1) * SLACK * SLACK + UNDERFLOW;
    }
    let m = (2 * n - 1).next_power_of_two();
    let angle = |turns: usize, of: usize| std::f64::consts::TAU * (turns % of) as f64 / of as f64;
    // |G_k| of g_l = e^(-pi i l^2/n) for |l| < n.
    let sizes = (0..m).map(|k| {
        let term = |l: usize| (angle(l * l, 2 * n), 2.0 * angle(l * k, m).cos());
        let sum = (1..n).map(term).fold((1.0, 0.0), |(re, im), (a, c)| (re + a.cos() * c, im - a.sin() * c));
        sum.0.hypot(sum.1)
    });
    let root = |x: usize| (x as f64).sqrt() * SLACK;
    let (epsilon, mu) = (transform_error(m), ROOT_ERROR);
    let largest = sizes.fold(0.0, f64::max) * SLACK;
    let inside = (2.0 * epsilon + mu + 1.5 * UNIT + PRODUCT) * largest + (epsilon + mu) * root(2 * n);
    (inside + (PRODUCT + mu) * root(n)) * (norm(2).sqrt() * SLACK) * SLACK + UNDERFLOW * m as f64
}

#[test]
fn transforms_are_within_their_bounds_which_are_the_formulas() {
    // 33 and 65: the least length of the convolution is just above a power of two.
    for n in (2..=24).chain([32, 33, 48, 64, 65]) {
        let x = weights(n, 3 + n as u64);
        let (found, error) = real_transform(&x).expect("finite");
        assert_equals(error, documented(&x), &format!("the bound for {n}"));
        let exact: Vec<(usize, Rational)> = x.iter().map(|&x| float(x)).enumerate().collect();
        for k in 0..=n / 2 {
            let (re, im) = naive(n, &exact, k);
            for (value, part) in [(found.re[k], re), (found.im[k], im)] {
                let off = (Interval::from_rational(&float(value), 120) - part).magnitude().to_f64();
                assert!(off <= error, "n = {n}, k = {k}: {off} {error}");
            }
        }
    }
}

#[test]
fn transforms_of_one_number_of_none_and_of_zeros() {
    let (one, error) = real_transform(&[0.3]).expect("a number");
    assert_eq!((one.re, one.im, error), (vec![0.3], vec![0.0], 0.0));
    assert!(real_transform(&[]).is_none() && real_transform(&[f64::INFINITY, 1.0, 1.0]).is_none());
    assert_eq!(real_transform(&[0.0; 8]).expect("zeros").1, UNDERFLOW);
    assert_eq!(real_transform(&[0.0; 5]).expect("zeros").1, 16.0 * UNDERFLOW);
}
