//! Runs in floating point for the figures: random starts, shares with confidence intervals.

use crate::arithmetic::Complex;
use crate::ledger::Run;
use crate::oscillator::Flight;
use rand_chacha::rand_core::Rng;
use std::f64::consts::TAU;

/// The angle in radians below which neighbouring phases belong to one cluster: 10 degrees.
pub const CLUSTER: f64 = TAU / 36.0;

/// What every run declares: the choices that the paper does not state.
pub const DECLARATION: &str =
    "classical Runge-Kutta with fixed step; positions uniform in a square of half-width 10, phases uniform";

/// `N` particles with positions uniform in a square of half-width 10 and uniform phases.
pub fn random_start(run: &Run, replicate: u64, particles: usize) -> Flight {
    let mut random = run.random(replicate);
    let mut uniform = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
    let positions = (0..particles).map(|_| Complex::new(20.0 * uniform() - 10.0, 20.0 * uniform() - 10.0)).collect();
    Flight { positions, phases: (0..particles).map(|_| TAU * uniform()).collect() }
}

/// The 95% confidence interval of a share (Wilson), as a value of the ledger.
pub fn share(found: usize, of: usize) -> String {
    const Z: f64 = 1.96;
    let (n, p) = (of as f64, found as f64 / of as f64);
    let middle = (p + Z * Z / (2.0 * n)) / (1.0 + Z * Z / n);
    let half = Z / (1.0 + Z * Z / n) * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).sqrt();
    format!("[{:.3}, {:.3}]", (middle - half).max(0.0), (middle + half).min(1.0))
}

/// The largest distance of a circle centre (3) from the mean of them; infinite for `omega = 0`.
pub fn centre_spread(omega: f64, flight: &Flight) -> f64 {
    crate::oscillator::centre_spread(&omega, &flight.state()).unwrap_or(f64::INFINITY)
}

/// Whether the phases form `clusters` clusters of equal size, evenly spaced within half the cluster angle.
pub fn is_pattern(flight: &Flight, clusters: usize) -> bool {
    flight.forms_pattern(clusters, CLUSTER)
}
