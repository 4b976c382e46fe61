//! Attempts at counterexamples: each made from the statement alone, without the models and without the checks, mostly in floats. What
//! was tried and what survived is listed in notes/attempts.md.

mod chazelle;
mod chazelle_late;
mod chazelle_networks;
mod veerman;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// Random numbers that depend on the name only.
struct Dice(ChaCha8Rng);

impl Dice {
    fn new(name: &str) -> Self {
        Dice(arithmetic::random::generator("attempts", name, 0))
    }

    /// An integer below `bound`.
    fn below(&mut self, bound: usize) -> usize {
        self.0.next_u32() as usize % bound
    }

    /// A number in `[0, 1)`.
    fn unit(&mut self) -> f64 {
        f64::from(self.0.next_u32()) / 4_294_967_296.0
    }

    /// A number in `[low, high)`.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

type Matrix = Vec<Vec<f64>>;

fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let entry = |row: &Vec<f64>, j: usize| row.iter().zip(b).map(|(x, line)| x * line[j]).sum();
    a.iter().map(|row| (0..b[0].len()).map(|j| entry(row, j)).collect()).collect()
}

fn identity(n: usize) -> Matrix {
    (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect()
}

fn apply(a: &Matrix, x: &[f64]) -> Vec<f64> {
    a.iter().map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect()
}

fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-8 * (1.0 + a.abs() + b.abs())
}
