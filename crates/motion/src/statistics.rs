//! Shares of runs and means over runs with confidence intervals.

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
        beside(self.interval(), number)
    }

    /// The interval as a value of the ledger, `[lo, hi]`, rounded outward.
    pub fn enclosure(self) -> String {
        outward(self.interval())
    }
}

impl fmt::Display for Share {
    /// `7 of 12 runs (95%: 0.31 to 0.81)`, the ends rounded outward.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (low, high) = widened(self.interval(), 2);
        write!(f, "{} of {} runs (95%: {low:.2} to {high:.2})", self.found, self.of)
    }
}

/// The mean of independent numbers, one of each run.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sample {
    /// How many numbers.
    pub of: usize,
    sum: f64,
    squares: f64,
}

impl Sample {
    /// The fewest numbers of which there is an interval.
    pub const FEWEST: usize = 8;

    /// All of these numbers.
    pub fn new(numbers: impl IntoIterator<Item = f64>) -> Self {
        numbers.into_iter().fold(Sample::default(), |sample, x| Sample {
            of: sample.of + 1,
            sum: sample.sum + x,
            squares: sample.squares + x * x,
        })
    }

    /// The mean; 0 without numbers.
    pub fn mean(self) -> f64 {
        self.sum / self.of.max(1) as f64
    }

    /// Student's 95% interval for the expected value; the whole line for fewer than [`Sample::FEWEST`] numbers.
    ///
    /// Source of the quantile, within 0.001 from [`Sample::FEWEST`] numbers on: Abramowitz and Stegun, Handbook of
    /// Mathematical Functions, 26.7.5.
    pub fn interval(self) -> (f64, f64) {
        if self.of < Sample::FEWEST {
            return (f64::NEG_INFINITY, f64::INFINITY);
        }
        let (count, free) = (self.of as f64, (self.of - 1) as f64);
        let variance = ((self.squares - self.sum * self.mean()) / free).max(0.0);
        let z = QUANTILE;
        let terms = [
            z,
            (z.powi(3) + z) / 4.0,
            (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / 96.0,
            (3.0 * z.powi(7) + 19.0 * z.powi(5) + 17.0 * z.powi(3) - 15.0 * z) / 384.0,
        ];
        let quantile = terms.iter().rev().fold(0.0, |sum, term| sum / free + term);
        let half = quantile * (variance / count).sqrt();
        (self.mean() - half, self.mean() + half)
    }

    /// Whether the expected value is above a number: `None` where that lies inside the interval.
    pub fn is_above(self, number: f64) -> Option<bool> {
        beside(self.interval(), number)
    }

    /// The interval as a value of the ledger, `[lo, hi]`, rounded outward.
    pub fn enclosure(self) -> String {
        outward(self.interval())
    }
}

impl fmt::Display for Sample {
    /// `1.45 (95%: 1.30 to 1.60, 20 runs)`, the ends rounded outward.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (low, high) = widened(self.interval(), 2);
        write!(f, "{:.2} (95%: {low:.2} to {high:.2}, {} runs)", self.mean(), self.of)
    }
}

/// Both ends with so many decimals, rounded outward; one that has no more stays.
fn widened((low, high): (f64, f64), decimals: i32) -> (f64, f64) {
    let unit = 10f64.powi(decimals);
    ((low * unit).floor() / unit, (high * unit).ceil() / unit)
}

/// `[lo, hi]` with three decimals, rounded outward.
fn outward(interval: (f64, f64)) -> String {
    let (below, above) = widened(interval, 3);
    format!("[{below:.3}, {above:.3}]")
}

/// Whether an interval is above a number or not above it: `None` where the number lies inside.
fn beside((low, high): (f64, f64), number: f64) -> Option<bool> {
    match (low > number, high <= number) {
        (true, _) => Some(true),
        (_, true) => Some(false),
        _ => None,
    }
}
