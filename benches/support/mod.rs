//! Inputs shared by the benches: the generator that the peer scripts use too (`benches/peers/common.py`).

use flockproof::matrix::StochasticMatrix;

/// 64-bit linear congruential generator; every draw updates first and then reads the upper half.
struct Lcg(u64);

impl Lcg {
    fn u32(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 32) as u32
    }
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
