//! What a network and its changes mean for the averaging.

use crate::averaging::weights::{FlockError, Weights};
use algebra::graph::Graph;
use arithmetic::{Rational, Ring, lcm};
use num_bigint::BigInt;

/// Pairs whose status changes at a time.
#[derive(Debug, Clone)]
pub(super) struct Change {
    pub time: u64,
    pub pairs: Vec<(u32, u32)>,
}

/// The least common denominator of the weights of all birds with neighbours: what a step multiplies the common denominator by.
pub(super) fn multiplier(network: &Graph, weights: &Weights) -> BigInt {
    let mut degrees: Vec<(usize, usize)> = (0..network.order()).map(|i| (network.degree(i), i)).collect();
    if !matches!(weights, Weights::Given(_)) {
        degrees.sort_unstable();
        degrees.dedup_by_key(|(degree, _)| *degree);
    }
    let joined = degrees.into_iter().filter(|(degree, _)| *degree > 0);
    let denominators = joined.filter_map(|(degree, i)| weights.of(degree, i)).map(|c| c.denom());
    denominators.fold(BigInt::from(1), |m, d| lcm(&m, &d))
}

/// [`multiplier`] of a network that changes a pair at a time.
pub(super) struct Multiplier<'a> {
    network: Graph,
    weights: &'a Weights,
    /// How many birds have each number of neighbours.
    degrees: Vec<usize>,
}

impl<'a> Multiplier<'a> {
    pub fn new(network: Graph, weights: &'a Weights) -> Self {
        let mut degrees = Vec::new();
        (0..network.order()).for_each(|i| count(&mut degrees, network.degree(i), true));
        Multiplier { network, weights, degrees }
    }

    pub fn toggle(&mut self, (i, j): (u32, u32)) {
        let ends = [i as usize, j as usize];
        ends.iter().for_each(|&end| count(&mut self.degrees, self.network.degree(end), false));
        self.network.toggle(ends[0], ends[1]);
        ends.iter().for_each(|&end| count(&mut self.degrees, self.network.degree(end), true));
    }

    pub fn value(&self) -> BigInt {
        if matches!(self.weights, Weights::Given(_)) {
            return multiplier(&self.network, self.weights);
        }
        let there = self.degrees.iter().enumerate().skip(1).filter(|(_, count)| **count > 0);
        let denominators = there.filter_map(|(degree, _)| self.weights.of(degree, 0)).map(|c| c.denom());
        denominators.fold(BigInt::from(1), |m, d| lcm(&m, &d))
    }
}

fn count(degrees: &mut Vec<usize>, degree: usize, more: bool) {
    if degrees.len() <= degree {
        degrees.resize(degree + 1, 0);
    }
    degrees[degree] = if more { degrees[degree] + 1 } else { degrees[degree].saturating_sub(1) };
}

/// `c_i`, where it suits the number of neighbours.
pub(super) fn weight(network: &Graph, weights: &Weights, i: usize, time: &BigInt) -> Result<Rational, FlockError> {
    let degree = network.degree(i);
    let c = weights.of(degree, i).ok_or(FlockError::Weights { birds: network.order(), bird: i + 1 })?;
    if degree > 0 && (&c * BigInt::from(degree) >= c.one() || c <= c.zero()) {
        let (c, time) = (c.to_string(), time.to_string());
        return Err(FlockError::Inadmissible { bird: i + 1, degree, c, time });
    }
    Ok(c)
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::rational;

    /// A path of three birds, a pair and one alone.
    fn network() -> Graph {
        Graph::from_edges(6, &[(0, 4), (4, 2), (1, 5)]).expect("a graph")
    }

    /// `2/(3d)` and `1/(d + 1)` for the degrees 1 and 2, and given weights of those who have neighbours.
    #[test]
    fn a_step_multiplies_the_denominator_by_that_of_the_weights() {
        assert_eq!(multiplier(&network(), &Weights::Lazy), BigInt::from(3));
        assert_eq!(multiplier(&network(), &Weights::Vicsek), BigInt::from(6));
        let given = [(1, 5), (1, 7), (1, 4), (1, 11), (1, 6), (1, 7)].map(|(p, q)| rational(p, q)).to_vec();
        assert_eq!(multiplier(&network(), &Weights::Given(given)), BigInt::from(5 * 7 * 12));
        assert_eq!(multiplier(&Graph::empty(3), &Weights::Lazy), BigInt::from(1));
        // Changed a pair at a time, to all and to none.
        for weights in [Weights::Lazy, Weights::Vicsek, Weights::Given(vec![rational(1, 7); 6])] {
            let mut changing = Multiplier::new(network(), &weights);
            let mut network = network();
            for (i, j) in (0..6).flat_map(|j| (0..j).map(move |i| (i, j))).cycle().take(30) {
                network.toggle(i as usize, j as usize);
                changing.toggle((i, j));
                assert_eq!(changing.value(), multiplier(&network, &weights));
            }
        }
    }

    #[test]
    fn weights_suit_the_number_of_neighbours() {
        let time = BigInt::from(9);
        let weight_of =
            |c: (i64, i64), i: usize| weight(&network(), &Weights::Given(vec![rational(c.0, c.1); 6]), i, &time);
        assert_eq!(weight_of((1, 3), 4), Ok(rational(1, 3)));
        for (c, i) in [((1, 2), 4), ((1, 1), 0), ((2, 3), 4), ((0, 1), 0), ((-1, 5), 0)] {
            let (degree, time) = (network().degree(i), time.to_string());
            let refused = FlockError::Inadmissible { bird: i + 1, degree, c: rational(c.0, c.1).to_string(), time };
            assert_eq!(weight_of(c, i), Err(refused));
        }
        // Who is alone needs none that suits.
        assert_eq!(weight_of((5, 1), 3), Ok(rational(5, 1)));
        let few = weight(&network(), &Weights::Given(vec![rational(1, 3); 2]), 4, &time);
        assert_eq!(few, Err(FlockError::Weights { birds: 6, bird: 5 }));
    }
}
