//! What is measured on a motion in time, in floating point: the amplitude that the last car shows, where it is largest, gaps and
//! velocities.

use super::law::Gains;
use super::time_domain::Modes;
use arithmetic::ArithmeticError;
use motion::golden;

/// More sections than the precision allows.
const MOST_SECTIONS: usize = 100;

/// A value with where it is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// The value.
    pub value: f64,
    /// The place: a time or a frequency.
    pub at: f64,
}

/// The largest value of `f` on an interval: golden sections around the best of `samples + 1` equidistant points. Right if
/// `f` has one maximum within two steps of that point.
///
/// # Errors
/// Those of `f`.
pub fn largest<E>((low, high): (f64, f64), samples: usize, f: impl Fn(f64) -> Result<f64, E>) -> Result<Extreme, E> {
    let step = (high - low) / samples.max(1) as f64;
    let mut best = Extreme { value: f(low)?, at: low };
    for k in 1..=samples {
        let at = low + step * k as f64;
        let value = f(at)?;
        if value > best.value {
            best = Extreme { value, at };
        }
    }
    // A maximum is flat: beyond the root of the precision nothing is gained.
    let bracket = ((best.at - step).max(low), (best.at + step).min(high));
    let (at, least) = golden(bracket, MOST_SECTIONS, 1e-8, |x| f(x).map(|value| -value))?;
    if -least > best.value {
        best = Extreme { value: -least, at };
    }
    Ok(best)
}

/// The amplitude that the last car shows behind the leader `cos wt`, starting from rest: the largest `|y_M|` during the last
/// of so many periods of the leader.
///
/// # Errors
/// [`ArithmeticError`] where a mode has a double root.
pub fn measured_amplitude(modes: &Modes<f64>, w: f64, periods: f64) -> Result<f64, ArithmeticError> {
    let start = modes.behind_harmonic_leader(&w)?;
    let period = 2.0 * std::f64::consts::PI / w;
    let window = ((periods - 1.0).max(0.0) * period, periods * period);
    Ok(largest(window, 24, |t| Ok::<f64, ArithmeticError>(start.last(&t)?.abs()))?.value)
}

/// The frequency near `guess` at which that amplitude is largest, as the paper looks for it: by golden section.
///
/// # Errors
/// As [`measured_amplitude`].
pub fn measured_resonance(
    gains: &Gains<f64>,
    followers: u64,
    guess: f64,
    periods: f64,
) -> Result<Extreme, ArithmeticError> {
    let modes = Modes::new(gains, followers)?;
    largest((0.5 * guess, 1.5 * guess), 16, |w| measured_amplitude(&modes, w, periods))
}

/// The smallest gap between a car and the one in front, `spacing + y_{k-1} - y_k`, for all cars at one time.
pub fn smallest_gap(leader: f64, positions: &[f64], spacing: f64) -> f64 {
    let front = std::iter::once(&leader).chain(positions);
    front.zip(positions).map(|(front, own)| spacing + front - own).fold(f64::INFINITY, f64::min)
}
