//! Runs in floating point for the figures: random starts, and what is read off at the end.

use crate::arithmetic::Complex;
use crate::ledger::Run;
use crate::oscillator::{Flight, circle_centres};
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

/// The largest distance of a circle centre (3) from the mean of them; infinite for `omega = 0`.
pub fn centre_spread(omega: f64, flight: &Flight) -> f64 {
    let Ok(centres) = circle_centres(&omega, &flight.state()) else { return f64::INFINITY };
    let Ok(middle) = crate::oscillator::mean(&centres) else { return 0.0 };
    centres.into_iter().map(|c| (c - &middle).norm_squared().sqrt()).fold(0.0, f64::max)
}

/// Whether the phases form `clusters` clusters of equal size, evenly spaced within half the cluster angle.
pub fn is_pattern(flight: &Flight, clusters: usize) -> bool {
    let found = flight.clusters(CLUSTER);
    let (size, gap) = (flight.phases.len() / clusters, TAU / clusters as f64);
    // A cluster has some width, so that gaps are a little smaller.
    found.len() == clusters
        && found.iter().all(|&(count, angle)| count == size && (clusters == 1 || (angle - gap).abs() < CLUSTER / 2.0))
}
