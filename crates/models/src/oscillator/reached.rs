//! Which of the named states a run has reached: measures of synchrony, of circular formations, of patterns and of rest.

use super::flight::Flight;
use super::moments::{moment, quarter_turn};
use super::state::State;
use crate::angles::modulo_turns;
use arithmetic::ArithmeticError;
use std::f64::consts::TAU;

/// The angle in radians below which neighbouring phases belong to one cluster: 10 degrees.
pub const CLUSTER: f64 = TAU / 36.0;

/// `m |p_m|` (23): 1 where the phases are equal modulo `2 pi/m`, 0 where they are balanced modulo it; `|p_theta|` for `m = 1`.
///
/// # Errors
/// [`ArithmeticError`] for no particles or `m = 0`.
pub fn order(flight: &Flight, m: u32) -> Result<f64, ArithmeticError> {
    Ok(f64::from(m) * moment(&flight.state().phasors, m)?.norm_squared().sqrt())
}

/// The gap in radians that parts clusters of so many phases: [`CLUSTER`], or a third of the mean gap where that is smaller.
pub fn cluster_gap(phases: usize) -> f64 {
    CLUSTER.min(TAU / (3.0 * phases.max(1) as f64))
}

impl Flight {
    /// Whether the phases form `clusters` clusters of equal size at evenly spaced places: each phase is within half of `tolerance` of its place,
    /// and within a sixth of the gap between places.
    pub fn forms_pattern(&self, clusters: usize, tolerance: f64) -> bool {
        let count = self.phases.len();
        if clusters == 0 || !count.is_multiple_of(clusters) || count == 0 {
            return false;
        }
        let turns = clusters as f64;
        let (sin, cos) = self.phases.iter().fold((0.0, 0.0), |(s, c), theta| {
            let (sin, cos) = (turns * theta).sin_cos();
            (s + sin, c + cos)
        });
        let first = f64::atan2(sin, cos) / turns;
        let gap = TAU / turns;
        let mut sizes = vec![0; clusters];
        for theta in &self.phases {
            let place = ((theta - first) / gap).round();
            if (theta - first - place * gap).abs() > (tolerance / 2.0).min(gap / 6.0) {
                return false;
            }
            sizes[place.rem_euclid(turns) as usize % clusters] += 1;
        }
        sizes.iter().all(|size| size * clusters == count)
    }
}

/// The number of clusters of the symmetric pattern that the phases form, clusters by [`CLUSTER`], if any. Cost: `N log N` unless there is one.
pub fn pattern(flight: &Flight) -> Option<usize> {
    let count = flight.phases.len();
    let mut gaps: Vec<f64> = flight.gaps();
    gaps.sort_by(|a, b| b.total_cmp(a));
    // Places are whole turns over M apart, phases at most a sixth of that away from them.
    let parted =
        |m: &usize| gaps[m - 1] > 0.6 * TAU / *m as f64 && gaps.get(*m).is_none_or(|gap| *gap < 0.4 * TAU / *m as f64);
    let divisors = (1..=count).filter(|m| count.is_multiple_of(*m));
    divisors.filter(parted).find(|&m| flight.forms_pattern(m, CLUSTER))
}

/// The angles in `[-pi, pi]` from each phase to the next around a ring, `N` of them.
pub fn ring_differences(phases: &[f64]) -> Vec<f64> {
    let next = |k: usize| phases[(k + 1) % phases.len()];
    phases.iter().enumerate().map(|(k, theta)| modulo_turns(next(k) - theta)).collect()
}

/// The number of turns that [`ring_differences`] make together: `m` for the twisted state `theta_k = 2 pi m k/N`.
pub fn winding(phases: &[f64]) -> i64 {
    (ring_differences(phases).iter().sum::<f64>() / TAU).round() as i64
}

/// The `m` of the twisted state `theta_k = 2 pi m k/N` whose step from each phase to the next is nearest to the mean step, in
/// `(-N/2, N/2]`, and the largest angle between a step and that of the twisted state.
pub fn nearest_twist(phases: &[f64]) -> (i64, f64) {
    let (count, steps) = (phases.len() as f64, ring_differences(phases));
    let (sin, cos) = steps.iter().fold((0.0, 0.0), |(s, c), step| (s + step.sin(), c + step.cos()));
    let m = (count * f64::atan2(sin, cos) / TAU).round();
    let m = if 2.0 * m <= -count { m + count } else { m };
    let off = |step: &f64| modulo_turns(step - TAU * m / count).abs();
    (m as i64, steps.iter().map(off).fold(0.0, f64::max))
}

/// The largest rate of change of a relative position `r_kj e^{-i theta_k}` or relative phase: 0 in a relative equilibrium. Particles without a
/// steering are left out.
pub fn shape_rate(state: &State<f64>, steering: &[f64]) -> f64 {
    let mut largest: f64 = 0.0;
    let particles = || state.positions.iter().zip(&state.phasors).zip(steering);
    for ((r, z), own) in particles() {
        for ((s, w), other) in particles() {
            let turning = quarter_turn(&(r.clone() - s)).scale(own);
            let rate = z.clone() - w - turning;
            largest = largest.max(rate.norm_squared().sqrt()).max((own - other).abs());
        }
    }
    largest
}
