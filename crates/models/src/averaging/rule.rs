//! One averaging step as integers.

use super::weights::{FlockError, Weights};
use algebra::graph::Graph;
use algebra::matrix::AverageRow;
use arithmetic::{Rational, Ring, lcm};
use num_bigint::BigInt;

/// `multiplier (P(t) (x) I_d)` in integers.
#[derive(Debug, Clone)]
pub(super) struct Rule {
    pub multiplier: BigInt,
    pub rows: Vec<AverageRow>,
}

impl Rule {
    /// For a network, with the smallest multiplier that makes the entries integers.
    pub fn new(network: &Graph, weights: &Weights, dimension: usize, time: &BigInt) -> Result<Self, FlockError> {
        let birds = network.order();
        let mut factors = Vec::with_capacity(birds);
        for i in 0..birds {
            let degree = network.degree(i);
            let c = weights.of(degree, i).ok_or(FlockError::Weights { birds, bird: i + 1 })?;
            let share = &c * BigInt::from(degree);
            // Where it is not positive, [`super::Flock::resume`] has refused it.
            if share >= share.one() {
                let (c, time) = (c.to_string(), time.to_string());
                return Err(FlockError::Inadmissible { bird: i + 1, degree, c, time });
            }
            factors.push((c, share));
        }
        let multiplier = factors
            .iter()
            .zip(0..)
            .fold(BigInt::from(1), |m, ((c, _), i)| if network.degree(i) > 0 { lcm(&m, &c.denom()) } else { m });
        // An integer, but for the weight of a bird without neighbours, which weighs nothing.
        let times = |q: &Rational| (q * &multiplier).to_integer();
        let mut rows = Vec::with_capacity(birds * dimension);
        for (i, (c, share)) in factors.iter().enumerate() {
            let near = network.neighbours(i);
            for k in 0..dimension {
                let near: Vec<usize> = near.iter().map(|&j| j as usize * dimension + k).collect();
                rows.push(AverageRow::new(times(&(share.one() - share)), times(c), near));
            }
        }
        Ok(Rule { multiplier, rows })
    }
}
