//! What rounding may have done: bounds of conversions, norms and products of floats, against rationals, and not much wider than they must be.

use super::super::testing::float;
use super::{Split, UNIT, around, frobenius, nearest, nearest_root};
use arithmetic::random::{generator, uniform};
use arithmetic::{Rational, rational};
use dense::Mat;
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

/// Floats with full significands, those of row `i` of the size `2^(scale i)`.
fn random(rows: usize, columns: usize, scale: i32, seed: u64) -> Mat<f64> {
    let mut random = generator("rounding", "matrix", seed);
    Mat::from_fn(rows, columns, |i, _| (2.0 * uniform(&mut random) - 1.0) * 2f64.powi(scale * i as i32))
}

#[test]
fn rationals_are_within_the_error_of_their_floats() {
    let long = BigInt::one() << 53u32;
    let exact = [rational(0, 1), rational(-7, 1), Rational::from_integer(1 - &long)];
    assert!(exact.iter().all(|q| nearest(q).is_some_and(|(value, error)| float(value) == *q && error == 0.0)));
    let rounded = [
        Rational::from_integer(long + 1),
        rational(1, 3),
        rational(-2, 7),
        rational(1, 10).pow(99),
        rational(10, 1).pow(99),
    ];
    for q in &rounded {
        let (value, error) = nearest(q).expect("in range");
        assert!((float(value) - q).abs() <= float(error) && error <= 4.0 * UNIT * value.abs() && error > 0.0, "{q}");
        let (root, error) = nearest_root(&q.abs(), -1.0).expect("in range");
        assert!(root < 0.0 && error <= -4.0 * UNIT * root);
        let [inner, outer] = [float(error), -float(error)].map(|away| (float(root) + away).pow(2));
        assert!(inner <= q.abs() && q.abs() <= outer, "{q}");
    }
    for far in [rational(10, 1).pow(101), rational(1, 10).pow(101), -rational(1, 10).pow(400)] {
        assert!(nearest(&far).is_none() && nearest_root(&(&far * &far), 1.0).is_none());
    }
    assert!(nearest_root(&rational(-2, 1), 1.0).is_none());
}

#[test]
fn norms_are_rounded_up_and_hardly_at_all() {
    for (rows, columns) in [(1, 1), (3, 2), (8, 3), (13, 5), (40, 1)] {
        let a = random(rows, columns, 1, rows as u64);
        let square = |x: &f64| float(*x).pow(2);
        let exact: Rational = a.col_iter().flat_map(|column| column.iter().map(square).collect::<Vec<_>>()).sum();
        // Columns and rows lie differently in memory.
        for norm in [frobenius(a.as_ref()), frobenius(a.transpose())] {
            let norm = float(norm).pow(2);
            assert!(exact <= norm && norm <= exact.clone() * rational(100_001, 100_000), "{rows} x {columns}");
        }
    }
    // Squares that vanish, numbers that are too large, and what is no number.
    let small = Mat::from_fn(9, 9, |_, _| 1e-170);
    assert!(frobenius(small.as_ref()) >= 9e-170);
    for bad in [1e200, f64::INFINITY, f64::NAN] {
        let a = Mat::from_fn(3, 3, |i, j| if (i, j) == (1, 2) { bad } else { 1.0 });
        assert_eq!([frobenius(a.as_ref()), frobenius(a.transpose())], [f64::INFINITY; 2]);
    }
}

#[test]
fn products_of_floats_are_within_their_error_and_far_better_than_rounded_ones() {
    for (rows, inner, columns, scale) in [(1, 1, 1, 0), (2, 3, 1, 5), (3, 1, 4, -9), (9, 8, 5, 0), (30, 41, 20, 1)] {
        let a = random(rows, inner, scale, inner as u64);
        let b = random(inner, columns, 0, 100 + inner as u64);
        let product = Split::new(a.clone()).times(&b);
        let mut square = Rational::zero();
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            let exact: Rational = (0..inner).map(|k| float(a[(i, k)]) * float(b[(k, j)])).sum();
            square += (exact - float(product.exact[(i, j)]) - float(product.rest[(i, j)])).pow(2);
        }
        assert!(square <= float(product.error).pow(2), "{rows} x {inner} x {columns}");
        let usual = UNIT * frobenius(a.as_ref()) * frobenius(b.as_ref());
        assert!(product.error <= 1e-4 * usual, "{}", product.error / usual);
    }
}

/// Two products of sums that are split after 25 bits: the parts beyond have the norm `2^-30 sqrt(2)`, and the error is `2 (2 + 2) u` times what they are multiplied with.
#[test]
fn the_error_of_a_product_is_as_derived() {
    let long = 1.0 + 2f64.powi(-30);
    for (left, right, parts) in [(1.0, 1.0, 0.0), (long, 1.0, 1.0), (1.0, -long, 1.0), (-long, long, 2.0)] {
        let [a, b] =
            [(1, 2, left), (2, 1, right)].map(|(rows, columns, entry)| Mat::from_fn(rows, columns, |_, _| entry));
        let product = Split::new(a).times(&b);
        let derived = 8.0 * UNIT * 2f64.powi(-29) * parts;
        assert!(derived <= product.error && product.error <= derived * (1.0 + 1e-5) + 1e-160, "{left}, {right}");
        assert_eq!(product.exact[(0, 0)], 2.0 * left.signum() * right.signum());
    }
}

#[test]
fn intervals_around_floats_hold_the_ends() {
    for (centre, radius) in [(1.0, 0.0), (-1.0, 0.3), (0.1, 0.2), (1e100, 1e84), (0.0, 1e-100)] {
        let (lo, hi) = around(centre, radius).expect("finite").to_rationals();
        let width = float(radius) * rational(2, 1);
        assert!(lo < float(centre) - float(radius) && float(centre) + float(radius) < hi);
        assert!(hi - lo <= width + float(4.0 * f64::EPSILON * (f64::abs(centre) + radius)));
    }
    assert!([f64::NAN, f64::INFINITY].iter().all(|bad| around(*bad, 1.0).is_none()));
}
