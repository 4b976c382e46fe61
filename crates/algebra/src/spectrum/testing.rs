//! For the tests of bounds: matrices without rounding, what it means that a bound is rounded up, eigenvalues of circulants from the definition; and work that
//! is stopped.

use arithmetic::{Field, Interval, Number, Progress, Rational, Real, Ring, rational};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Whole numbers up to 4 in size, so that sums of products of a few of them are exact.
pub fn whole(a: usize, b: usize) -> f64 {
    ((a * 7 + b * b * 3 + a * b) % 9) as f64 - 4.0
}

/// A bound that is not below the exact one, and above it by a part in 10^5 at most.
pub fn assert_rounded_up(found: f64, exact: f64, what: &str) {
    assert!(exact <= found && found <= exact * (1.0 + 1e-5), "{what}: {found} instead of {exact}");
}

/// Real and imaginary part of eigenvalue `k`, straight from the definition.
pub fn naive(n: usize, row: &[(usize, Rational)], k: usize) -> (Interval, Interval) {
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

pub fn float(x: f64) -> Rational {
    Rational::from_float(x).expect("finite")
}

pub fn weights(n: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 * 2f64.powi(-53) - 0.5
    };
    (0..n).map(|_| next()).collect()
}

/// Equal but for the rounding of a few floats, far less than `SLACK`.
pub fn assert_equals(value: f64, expected: f64, context: &str) {
    assert!((value - expected).abs() <= 1e-12 * expected.abs(), "{context}: {value} is not {expected}");
}

/// Stops the work when it asks once more than so often.
pub struct After(AtomicUsize);

impl After {
    pub fn new(questions: usize) -> Self {
        After(questions.into())
    }
}

impl Progress for After {
    fn is_cancelled(&self) -> bool {
        self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1)).is_err()
    }
}
