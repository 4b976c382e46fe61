//! How the peak response grows with the number of cars, in floating point: an exploration, not a proof.

use super::banded::{BandedPlatoon, modulus};
use super::cars::Platoon;
use super::communication_graph::CommunicationGraph;
use super::law::Gains;
use super::observe::{Extreme, largest};
use arithmetic::ArithmeticError;

/// Sizes stop growing once the peak is beyond this.
pub const LARGEST_PEAK: f64 = 1e6;

/// What the peaks of growing sizes look like, by their local exponents `ln(peak ratio)/ln(size ratio)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Growth {
    /// The last two exponents are within 0.05 of 1.
    Linear,
    /// The last two exponents agree within 0.05 otherwise. Power 0: the peaks stay bounded.
    Power(f64),
    /// The last exponent is at least one and a half times the last but two.
    Exponential,
    /// None of these, or fewer than three exponents.
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

    /// Classifies peaks given with their sizes. Over three exponents the sizes should double.
    pub fn of(peaks: &[(f64, f64)]) -> Self {
        let exponents: Vec<f64> = peaks.windows(2).map(|p| (p[1].1 / p[0].1).ln() / (p[1].0 / p[0].0).ln()).collect();
        let [.., first, before, last] = exponents[..] else { return Growth::Undecided };
        let near = |a: f64, b: f64| (a - b).abs() < 0.05;
        match () {
            () if near(before, 1.0) && near(last, 1.0) => Growth::Linear,
            () if near(before, last) => Growth::Power(last),
            () if first > 0.05 && last >= 1.5 * first => Growth::Exponential,
            () => Growth::Undecided,
        }
    }
}

/// The peak of `|a_k(w)|` over all cars and frequencies `w > 0`, with its frequency.
///
/// Candidates are refined by golden sections: around the frequency of the slowest mode, `sqrt(|f| lambda)`, in steps of a quarter
/// of its width, and around the best three local maxima of a grid of 48 frequencies per factor of 10.
///
/// `None` where the eigenvalue `lambda` of the slowest mode is below `1e-9`: rounding shifts it by some `1e-16`, which must be far less than the
/// width `lambda^(3/2)` of its resonance, or that is missed.
///
/// # Errors
/// [`ArithmeticError`] where the response does not exist.
pub fn peak(graph: &CommunicationGraph, gains: &Gains<f64>) -> Result<Option<Extreme>, ArithmeticError> {
    let platoon = BandedPlatoon::new(graph);
    peak_by(&platoon, graph.followers(), (gains, gains), |w| platoon.largest_amplitude(gains, w))
}

/// The peak of the amplitude `|a_car(w)|` of one follower, `1 <= car <= M`; found as [`peak`] finds it, for gains that do not differ by many orders
/// of magnitude.
///
/// # Errors
/// As [`peak`]; [`ArithmeticError::Domain`] where there is no such car.
pub fn peak_of_car(platoon: &Platoon<f64>, car: usize) -> Result<Option<Extreme>, ArithmeticError> {
    let missing = || ArithmeticError::Domain("a car of the platoon");
    let (gains, banded) = (platoon.gains(), BandedPlatoon::of(platoon));
    let amplitude = |w: f64| {
        let all = banded.response_of_cars(gains, w)?;
        all.get(car.wrapping_sub(1)).map(modulus).ok_or_else(missing)
    };
    let by_strength = |a: &&Gains<f64>, b: &&Gains<f64>| b.f.total_cmp(&a.f);
    let weakest = gains.iter().min_by(by_strength).ok_or_else(missing)?;
    let strongest = gains.iter().max_by(by_strength).ok_or_else(missing)?;
    peak_by(&banded, platoon.followers(), (weakest, strongest), amplitude)
}

/// The peak of a response, whose slow mode has about the weakest gains, and whose frequencies reach up to those of the strongest.
fn peak_by(
    platoon: &BandedPlatoon,
    followers: usize,
    (gains, strongest): (&Gains<f64>, &Gains<f64>),
    response: impl Fn(f64) -> Result<f64, ArithmeticError>,
) -> Result<Option<Extreme>, ArithmeticError> {
    let top = 4.0 * (strongest.f / gains.f).sqrt();
    let (root, damping) = (gains.f.abs().sqrt(), gains.g.abs() / gains.f.abs().sqrt());
    const SMALLEST_EIGENVALUE: f64 = 1e-9;
    let Some((eigenvalue, change)) = platoon.smallest_eigenvalue().ok().filter(|(l, _)| *l >= SMALLEST_EIGENVALUE)
    else {
        return Ok(None);
    };
    let slow = root * eigenvalue.sqrt();
    // Relative half-width of the resonance of that mode; a mode that is not settled is looked for in a wider range.
    let width = 0.5 * damping * eigenvalue.sqrt();
    let steps = if change < 1e-9 { 24 } else { 200 };
    let reach = (0.125 * width * f64::from(steps)).min(0.7);
    let mut best = largest((slow * (1.0 - reach), slow * (1.0 + reach)), steps as usize, &response)?;
    let low = (0.2 / followers as f64).min(0.01);
    let count = (48.0 * (top / low).log10()) as i32;
    let at = |k: i32| root * low * (top / low).powf(f64::from(k) / f64::from(count));
    let grid = (0..=count).map(|k| response(at(k))).collect::<Result<Vec<f64>, _>>()?;
    let mut tops: Vec<usize> =
        (1..grid.len().saturating_sub(1)).filter(|&k| grid[k] >= grid[k - 1] && grid[k] >= grid[k + 1]).collect();
    tops.sort_by(|&a, &b| grid[b].total_cmp(&grid[a]));
    for k in tops.into_iter().take(3) {
        let found = largest((at(k as i32 - 1), at(k as i32 + 1)), 8, &response)?;
        if found.value > best.value {
            best = found;
        }
    }
    if grid.iter().chain([&best.value]).any(|value| !value.is_finite()) {
        return Err(ArithmeticError::Domain("amplitudes below the largest float; here they are larger"));
    }
    Ok(Some(best))
}
