//! Shares of runs with confidence intervals.

use std::fmt;

/// The quantile of the normal distribution for an interval of 95%.
const QUANTILE: f64 = 1.959_963_984_540_054;

/// How many of a number of independent runs show something.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Share {
    /// The runs that show it.
    pub found: usize,
    /// All runs.
    pub of: usize,
}

impl Share {
    /// The share `found / of`; `found` is at most `of`.
    pub fn new(found: usize, of: usize) -> Self {
        Share { found, of }
    }

    /// The share of what passes among all.
    pub fn count<T>(all: impl IntoIterator<Item = T>, mut passes: impl FnMut(T) -> bool) -> Self {
        all.into_iter().fold(Share::default(), |share, one| share.with(passes(one)))
    }

    /// One run more.
    pub fn with(self, found: bool) -> Self {
        Share { found: self.found + usize::from(found), of: self.of + 1 }
    }

    /// The share as a number; 0 without runs.
    pub fn value(self) -> f64 {
        self.found as f64 / self.of.max(1) as f64
    }

    /// Wilson's 95% interval for the probability; all of `[0, 1]` without runs.
    ///
    /// Source: E. B. Wilson, Probable inference, the law of succession, and statistical inference (1927).
    pub fn interval(self) -> (f64, f64) {
        if self.of == 0 {
            return (0.0, 1.0);
        }
        let (n, p, square) = (self.of as f64, self.value(), QUANTILE * QUANTILE);
        let middle = (p + square / (2.0 * n)) / (1.0 + square / n);
        let half = QUANTILE / (1.0 + square / n) * (p * (1.0 - p) / n + square / (4.0 * n * n)).sqrt();
        // At the ends the formula is exact; rounding must not show.
        let low = if self.found == 0 { 0.0 } else { middle - half };
        let high = if self.found == self.of { 1.0 } else { middle + half };
        (low, high)
    }

    /// Whether the probability is above a number: `None` where that lies inside the interval.
    pub fn is_above(self, number: f64) -> Option<bool> {
        let (low, high) = self.interval();
        match (low > number, high <= number) {
            (true, _) => Some(true),
            (_, true) => Some(false),
            _ => None,
        }
    }

    /// The interval as a value of the ledger, `[lo, hi]`.
    pub fn enclosure(self) -> String {
        let (low, high) = self.interval();
        format!("[{low:.3}, {high:.3}]")
    }
}

impl fmt::Display for Share {
    /// `7 of 12 runs (95%: 0.32 to 0.81)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (low, high) = self.interval();
        write!(f, "{} of {} runs (95%: {low:.2} to {high:.2})", self.found, self.of)
    }
}
