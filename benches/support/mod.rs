//! Inputs shared by the benches: the generator that the peer scripts use too (`benches/peers/common.py`).

use flockproof::arithmetic::{Rational, rational};
use flockproof::averaging::{Hysteresis, Start, Weights};
use flockproof::double_integrator::State;
use flockproof::matrix::{SparseMatrix, StochasticMatrix};
use flockproof::spectrum::Circulant;

/// 64-bit linear congruential generator; every draw updates first and then reads the upper bits.
pub struct Lcg(pub u64);

impl Lcg {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        self.0
    }

    pub fn u32(&mut self) -> u32 {
        (self.next() >> 32) as u32
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 * 2f64.powi(-53)
    }
}

/// The circulant Laplacian with weights `1/j` at the offsets `+-j`, `j <= 8`.
pub fn circulant(n: usize) -> Circulant {
    let arcs = (1..9).flat_map(|j| [(j, rational(1, j as i64)), (n - j, rational(1, j as i64))]);
    Circulant::laplacian(n, arcs).expect("weights in range")
}

/// Diagonal and side of the Laplacian of a weighted path.
pub fn weighted_path(n: usize) -> (Vec<f64>, Vec<f64>) {
    let mut random = Lcg(4001);
    let weights: Vec<f64> = (1..n).map(|_| 0.5 + random.unit()).collect();
    let weight = |i: usize| weights.get(i).copied().unwrap_or(0.0);
    let diagonal = (0..n).map(|i| weight(i) + if i > 0 { weight(i - 1) } else { 0.0 }).collect();
    (diagonal, weights.into_iter().map(|w| -w).collect())
}

/// The Laplacian of a ring with its vertices in another order.
pub fn ring(n: usize, shuffled: bool) -> SparseMatrix {
    let mut order: Vec<usize> = (0..n).collect();
    let mut random = Lcg(4003);
    for i in (1..n).rev().filter(|_| shuffled) {
        order.swap(i, random.u32() as usize % (i + 1));
    }
    let edge = |i: usize| {
        let (a, b) = (order[i], order[(i + 1) % n]);
        [(a, b, rational(-1, 1)), (b, a, rational(-1, 1)), (a, a, rational(2, 1))]
    };
    SparseMatrix::from_entries(n, (0..n).flat_map(edge))
}

/// Shares of the neighbours within 0.08 of random points in the unit square, and of the point itself.
pub fn geometric(n: usize) -> SparseMatrix {
    let mut random = Lcg(4002);
    let points: Vec<(f64, f64)> = (0..n).map(|_| (random.unit(), random.unit())).collect();
    let near = |i: usize, j: usize| {
        let (x, y) = (points[i].0 - points[j].0, points[i].1 - points[j].1);
        x * x + y * y <= 0.08 * 0.08
    };
    let row = |i: usize| {
        let close: Vec<usize> = (0..n).filter(|&j| near(i, j)).collect();
        let share = rational(1, close.len() as i64);
        close.into_iter().map(move |j| (i, j, share.clone()))
    };
    SparseMatrix::from_entries(n, (0..n).flat_map(row))
}

/// The entries of a symmetric matrix of random rationals, none of them left out.
pub fn full_of_rationals(n: usize) -> impl Iterator<Item = (usize, usize, Rational)> {
    let mut random = Lcg(4004);
    let entry = move |(i, j): (usize, usize)| {
        let (p, q) = (i64::from(random.u32() % 2000) - 1000, i64::from(random.u32() % 997) + 1);
        let value = rational(if p < 0 { p } else { p + 1 }, q);
        let mirrored = (i != j).then(|| (j, i, value.clone()));
        std::iter::once((i, j, value)).chain(mirrored)
    };
    (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))).flat_map(entry)
}

/// Phases between 0 and pi.
pub fn phases(n: usize) -> Vec<f64> {
    let mut random = Lcg(5);
    (0..n).map(|_| std::f64::consts::PI * random.unit()).collect()
}

/// Agents near the points of a square lattice, with random velocities.
pub fn lattice_flock(columns: usize, rows: usize) -> State<f64> {
    let mut random = Lcg((columns * rows) as u64);
    let (mut positions, mut velocities) = (Vec::new(), Vec::new());
    for row in 0..rows {
        for column in 0..columns {
            let mut near = |k: usize| k as f64 + 0.5 + 0.4 * (random.unit() - 0.5);
            positions.push([near(column), near(row)]);
            velocities.push([random.unit() - 0.5, random.unit() - 0.5]);
        }
    }
    State { positions, velocities }
}

/// Birds of the plane at two or three in a unit square, with lazy weights.
pub fn crowd(birds: usize) -> Start {
    let mut random = Lcg(birds as u64);
    let side = ((birds as f64 / 2.5).sqrt() * 1024.0) as u32;
    let (mut positions, mut velocities) = (Vec::new(), Vec::new());
    for _ in 0..birds {
        positions.push((0..2).map(|_| rational(i64::from(random.u32() % side), 1024)).collect());
        velocities.push((0..2).map(|_| rational(i64::from(random.u32() % 1024) - 512, 8192)).collect());
    }
    Start { positions, velocities, weights: Weights::Lazy, hysteresis: Hysteresis::None }
}

/// Row-stochastic matrices over the denominator 2520, every entry positive.
pub fn stochastic_matrices(n: usize, length: usize, seed: u64) -> Vec<StochasticMatrix> {
    const DENOMINATOR: i64 = 2520;
    let mut random = Lcg(seed);
    let mut matrix = || {
        let rows: Vec<Vec<i64>> = (0..n)
            .map(|i| {
                let weights: Vec<i64> = (0..n).map(|_| 1 + i64::from(random.u32() % 100)).collect();
                let sum: i64 = weights.iter().sum();
                let mut row: Vec<i64> = weights.iter().map(|w| 1 + (DENOMINATOR - n as i64) * w / sum).collect();
                row[i] += DENOMINATOR - row.iter().sum::<i64>();
                row
            })
            .collect();
        StochasticMatrix::from_integers(&rows, DENOMINATOR).expect("rows sum to the denominator")
    };
    (0..length).map(|_| matrix()).collect()
}
