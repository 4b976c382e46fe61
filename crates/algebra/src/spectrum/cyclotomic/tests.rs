//! Sums of roots of unity against their definition.

use super::super::testing::assert_equals;
use super::*;

/// Small sums of a few orders, with coefficients of both signs; some are real or zero, though no terms of them are.
fn sums() -> Vec<CyclotomicSum> {
    let mut list = Vec::new();
    for order in [1u64, 2, 3, 4, 5, 6, 8, 9, 12, 15, 24, 30] {
        for denominator in [1, 3] {
            let terms: [&[(u64, i64)]; 7] = [
                &[(0, 2), (1, 2)],
                &[(1, 1), (order - 1, 1)],
                &[(1, 1), (2, -1)],
                &[(0, -5), (1, 3), (order / 3, 7)],
                &[(0, 1), (order / 3, 1), (2 * order / 3, 1)],
                &[(1, 4), (order / 2, -4), (order + 1, 2)],
                &[(1, -2), (order - 1, 2)],
            ];
            list.extend(terms.map(|terms| CyclotomicSum::new(order, denominator, terms.iter().copied()).unwrap()));
        }
    }
    list
}

fn naive(sum: &CyclotomicSum) -> (f64, f64) {
    let angle = |e: u64| std::f64::consts::TAU * e as f64 / sum.order as f64;
    let part = |f: fn(f64) -> f64| {
        sum.terms.iter().map(|&(e, c)| c as f64 * f(angle(e))).sum::<f64>() / sum.denominator as f64
    };
    (part(f64::cos), part(f64::sin))
}

#[test]
fn values_and_what_is_zero_or_real() {
    for sum in sums() {
        let (re, im) = naive(&sum);
        let (found_re, found_im, radius) = sum.to_floats();
        assert!((found_re - re).abs() < 1e-13 && (found_im - im).abs() < 1e-13 && radius < 1e-13, "{sum:?}");
        let table = RootTable::new(sum.order, 128).expect("angles in a turn");
        let enclosed = sum.enclose(&table).unwrap();
        assert!((enclosed.re.to_f64() - re).abs() < 1e-13 && (enclosed.im.to_f64() - im).abs() < 1e-13);
        assert!(enclosed.re.width().to_f64() < 1e-34 && enclosed.im.width().to_f64() < 1e-34);
        assert_eq!((sum.is_real(), sum.is_zero()), (im.abs() < 1e-12, im.abs() + re.abs() < 1e-12), "{sum:?}");
        let real = sum.real_part();
        assert!(real.is_real() && (naive(&real).0 - re).abs() < 1e-13 && naive(&real).1.abs() < 1e-13);
        // Rational numbers are found as such: here they have the denominator of the sum, if any.
        let scaled = re * sum.denominator as f64;
        let is_rational = sum.is_real() && (scaled - scaled.round()).abs() < 1e-9;
        let expected = is_rational.then(|| rational(scaled.round() as i64, sum.denominator));
        if sum.is_real() {
            assert_eq!(sum.exact(&enclosed.re), expected, "{sum:?}");
        }
    }
}

/// `(CHORD_ERROR + (number of terms + 3) u) Σ |c (1 - cos)|/d + 3 u |re|`, and the same of the sines.
#[test]
fn the_error_of_floats_is_the_formula() {
    for sum in sums() {
        let angle = |e: u64| std::f64::consts::TAU * e as f64 / sum.order as f64;
        let sizes =
            |f: &dyn Fn(f64) -> f64| sum.terms.iter().map(|&(e, c)| (c as f64 * f(angle(e))).abs()).sum::<f64>();
        let (chords, sines) = (sizes(&|x| 2.0 * (x / 2.0).sin().powi(2)), sizes(&|x| x.sin()));
        let (d, rounding) = (sum.denominator as f64, (sum.terms.len() as f64 + 3.0) * UNIT);
        let of_re = (CHORD_ERROR + rounding) * chords / d + 3.0 * UNIT * naive(&sum).0.abs();
        let of_im = (ROOT_ERROR + rounding) * sines / d;
        // Cosines of floats are a little off themselves.
        let (found, derived) = (sum.to_floats().2, of_re.max(of_im) * SLACK);
        assert!((found - derived).abs() <= 1e-28, "{sum:?}: {found} {derived}");
    }
    // Imaginary parts that are larger than the real ones: a hundredth of a turn.
    let small = CyclotomicSum::new(100, 1, [(1, 1), (99, -1)]).unwrap();
    let derived = (ROOT_ERROR + 5.0 * UNIT) * 2.0 * (std::f64::consts::TAU / 100.0).sin() * SLACK;
    assert_equals(small.to_floats().2, derived, "two sines");
}

#[test]
fn primes_that_divide() {
    for n in 1..600u64 {
        let is_prime = |p: u64| (2..p).all(|q| !p.is_multiple_of(q));
        let naive: Vec<u64> = (2..=n).filter(|&p| n % p == 0 && is_prime(p)).collect();
        assert_eq!(prime_divisors(n), naive);
    }
}

#[test]
fn tables_have_all_roots() {
    for order in (1..40u64).chain([99, 100, 101]) {
        let table = RootTable::new(order, 100).expect("angles in a turn");
        for e in 0..order {
            let (root, angle) = (table.root(e), std::f64::consts::TAU * e as f64 / order as f64);
            assert!((root.re.to_f64() - angle.cos()).abs() < 1e-14 && (root.im.to_f64() - angle.sin()).abs() < 1e-14);
            assert!(root.re.width().to_f64() < 1e-26 && root.im.width().to_f64() < 1e-26);
        }
    }
}
