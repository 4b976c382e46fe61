//! For the tests of bounds: matrices without rounding, and what it means that a bound is rounded up.

/// Whole numbers up to 4 in size, so that sums of products of a few of them are exact.
pub fn whole(a: usize, b: usize) -> f64 {
    ((a * 7 + b * b * 3 + a * b) % 9) as f64 - 4.0
}

/// A bound that is not below the exact one, and above it by a part in 10^5 at most.
pub fn assert_rounded_up(found: f64, exact: f64, what: &str) {
    assert!(exact <= found && found <= exact * (1.0 + 1e-5), "{what}: {found} instead of {exact}");
}
