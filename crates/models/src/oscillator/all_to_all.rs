//! The phase law (10) in floats for many phases: on all processors, in O(N) a step. The law over any scalar is
//! [`gradient_control`](super::gradient_control), its twin in the tests.

use motion::{CHUNK, VectorField, sin_cos_of};
use rayon::prelude::*;

/// `dθ_k/dt = frequency + (gain/N) sum_j sin(θ_k - θ_j)` (Paley, Leonard, Sepulchre, Grünbaum and Parrish 2007, the phase model
/// with the first harmonic): with the order parameter `p = (1/N) sum_j e^(iθ_j) = c + is`, the sum is
/// `N (c sin θ_k - s cos θ_k)`.
#[derive(Debug, Clone)]
pub struct AllToAll {
    frequency: f64,
    gain: f64,
    sines: Vec<f64>,
    cosines: Vec<f64>,
}

/// Sums are kept in so many interleaved parts.
const LANES: usize = 8;

impl AllToAll {
    /// With the natural frequency `ω0` (radians a unit of time) and the gain `K1`; negative gains synchronise.
    pub fn new(frequency: f64, gain: f64) -> Self {
        AllToAll { frequency, gain, sines: Vec::new(), cosines: Vec::new() }
    }

    /// The order parameter `(c, s)` of some phases; (0, 0) for none.
    pub fn order_parameter(&mut self, phases: &[f64]) -> (f64, f64) {
        self.sines.resize(phases.len(), 0.0);
        self.cosines.resize(phases.len(), 0.0);
        let chunk = |((phases, sines), cosines): ((&[f64], &mut [f64]), &mut [f64])| {
            sin_cos_of(phases, sines, cosines);
            (sum(cosines), sum(sines))
        };
        let parts = phases.par_chunks(CHUNK).zip(self.sines.par_chunks_mut(CHUNK));
        let sums: Vec<(f64, f64)> = parts.zip(self.cosines.par_chunks_mut(CHUNK)).map(chunk).collect();
        let (c, s) = sums.into_iter().fold((0.0, 0.0), |(c, s), part| (c + part.0, s + part.1));
        let count = phases.len().max(1) as f64;
        (c / count, s / count)
    }
}

/// In the same order on every processor.
fn sum(numbers: &[f64]) -> f64 {
    let chunks = numbers.chunks_exact(LANES);
    let rest: f64 = chunks.remainder().iter().sum();
    let mut lanes = [0.0; LANES];
    for chunk in chunks {
        lanes.iter_mut().zip(chunk).for_each(|(lane, x)| *lane += x);
    }
    lanes.iter().sum::<f64>() + rest
}

impl VectorField for AllToAll {
    fn rate(&mut self, _time: f64, phases: &[f64], rate: &mut [f64]) {
        let (c, s) = self.order_parameter(phases);
        let (frequency, along, across) = (self.frequency, self.gain * c, self.gain * s);
        let parts = self.sines.par_chunks(CHUNK).zip(self.cosines.par_chunks(CHUNK));
        rate.par_chunks_mut(CHUNK).zip(parts).for_each(|(rate, (sines, cosines))| {
            for ((rate, sine), cosine) in rate.iter_mut().zip(sines).zip(cosines) {
                *rate = frequency + (along * sine - across * cosine);
            }
        });
    }
}
