//! How the peak response grows with the number of cars, in floating point: an exploration, not a proof.

use super::banded::BandedPlatoon;
use super::observe::{Extreme, largest};
use super::{CommunicationGraph, Gains};
use crate::arithmetic::ArithmeticError;

/// Sizes stop growing once the peak is beyond this: by then it is clear, and rounding has not eaten the numbers.
pub const LARGEST_PEAK: f64 = 1e6;

/// What the peaks of sizes that double look like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Growth {
    /// They double: both of the last two exponents are within 0.05 of 1.
    Linear,
    /// They grow like another power: the last two exponents agree within 0.05. Power 0: they stay bounded.
    Power(f64),
    /// They exceed [`LARGEST_PEAK`], or the exponent grows by half or more with each of the last two doublings.
    Exponential,
    /// None of these.
    Undecided,
}

impl Growth {
    /// One word.
    pub fn word(self) -> &'static str {
        match self {
            Growth::Linear => "linear",
            Growth::Power(_) => "polynomial",
            Growth::Exponential => "exponential",
            Growth::Undecided => "undecided",
        }
    }

    /// Classifies the peaks of sizes that double.
    pub fn of(peaks: &[f64]) -> Self {
        if peaks.iter().any(|peak| *peak > LARGEST_PEAK) {
            return Growth::Exponential;
        }
        let exponents: Vec<f64> = peaks.windows(2).map(|pair| (pair[1] / pair[0]).log2()).collect();
        let [.., before, last] = exponents[..] else { return Growth::Undecided };
        let near = |a: f64, b: f64| (a - b).abs() < 0.05;
        match () {
            () if near(before, 1.0) && near(last, 1.0) => Growth::Linear,
            () if near(before, last) => Growth::Power(last),
            () if last > 1.5 * before && before > 0.05 => Growth::Exponential,
            () => Growth::Undecided,
        }
    }
}

/// The peak of `|a_k(w)|` over all cars and frequencies `w > 0`, with its frequency.
///
/// Candidates are refined by golden sections: around the frequency of the slowest mode, `sqrt(|f| lambda)`, in steps of a quarter
/// of its width, and around the best three local maxima of a grid of 48 frequencies per factor of 10.
///
/// Where the eigenvalue of the slowest mode cannot be told from 0 in floating point (below `1e-13`), the peak is not searched for: the
/// resonance of that mode alone, `sqrt|f|/(|g| sqrt(lambda))`, stands for it, with `1e-13` for `lambda`. It exceeds [`LARGEST_PEAK`] for
/// `|g| < 3 sqrt|f|`.
///
/// # Errors
/// [`ArithmeticError`] where the response does not exist.
pub fn peak(graph: &CommunicationGraph, gains: &Gains<f64>) -> Result<Extreme, ArithmeticError> {
    let platoon = BandedPlatoon::new(graph);
    let response = |w: f64| platoon.largest_amplitude(gains, w);
    let (root, damping) = (gains.f.abs().sqrt(), gains.g.abs() / gains.f.abs().sqrt());
    const ROUNDING: f64 = 1e-13;
    let (eigenvalue, change) = platoon.smallest_eigenvalue().unwrap_or((0.0, 0.0));
    let slow = root * eigenvalue.max(ROUNDING).sqrt();
    if eigenvalue < ROUNDING {
        return Ok(Extreme { value: root / (damping * slow), at: slow });
    }
    // Relative half-width of the resonance of that mode; a mode that is not settled is looked for in a wider range.
    let width = 0.5 * damping * eigenvalue.sqrt();
    let steps = if change < 1e-9 { 24 } else { 200 };
    let reach = (0.125 * width * f64::from(steps)).min(0.7);
    let mut best = largest((slow * (1.0 - reach), slow * (1.0 + reach)), steps as usize, response)?;
    let low = (0.2 / graph.followers() as f64).min(0.01);
    let count = (48.0 * (4.0 / low).log10()) as i32;
    let at = |k: i32| root * low * (4.0 / low).powf(f64::from(k) / f64::from(count));
    let grid = (0..=count).map(|k| response(at(k))).collect::<Result<Vec<f64>, _>>()?;
    let mut tops: Vec<usize> =
        (1..grid.len().saturating_sub(1)).filter(|&k| grid[k] >= grid[k - 1] && grid[k] >= grid[k + 1]).collect();
    tops.sort_by(|&a, &b| grid[b].total_cmp(&grid[a]));
    for k in tops.into_iter().take(3) {
        let found = largest((at(k as i32 - 1), at(k as i32 + 1)), 8, response)?;
        if found.value > best.value {
            best = found;
        }
    }
    Ok(best)
}
