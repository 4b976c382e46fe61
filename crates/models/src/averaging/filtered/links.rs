//! Who is joined to whom, as lists that change a pair at a time.

use crate::averaging::{FlockError, Weights};
use algebra::graph::{Graph, component_numbers};
use arithmetic::{Rational, Ring, lcm};
use num_bigint::BigInt;

/// The neighbours of each bird.
#[derive(Debug, Clone)]
pub(super) struct Links(Vec<Vec<u32>>);

/// Pairs whose status changes at a time.
#[derive(Debug, Clone)]
pub(super) struct Change {
    pub time: u64,
    pub pairs: Vec<(u32, u32)>,
}

impl Links {
    pub fn new(graph: &Graph) -> Self {
        let row = |i| graph.neighbours(i).into_iter().map(|j| j as u32).collect();
        Links((0..graph.order()).map(row).collect())
    }

    pub fn near(&self, i: usize) -> &[u32] {
        &self.0[i]
    }

    pub fn degree(&self, i: usize) -> usize {
        self.0[i].len()
    }

    pub fn order(&self) -> usize {
        self.0.len()
    }

    /// Joins a pair, or parts it where it is joined.
    pub fn toggle(&mut self, (i, j): (u32, u32)) {
        for (a, b) in [(i, j), (j, i)] {
            let row = &mut self.0[a as usize];
            match row.iter().position(|&k| k == b) {
                Some(place) => drop(row.swap_remove(place)),
                None => row.push(b),
            }
        }
    }

    /// The number of the connected component of each bird, and how many there are.
    pub fn components(&self) -> (Vec<usize>, usize) {
        let pairs = self.0.iter().enumerate().flat_map(|(i, row)| row.iter().map(move |&j| (i, j as usize)));
        component_numbers(self.order(), pairs.filter(|(i, j)| i < j))
    }

    /// The least common denominator of the weights of all birds with neighbours: what a step multiplies the common denominator by.
    pub fn multiplier(&self, weights: &Weights) -> BigInt {
        let mut degrees: Vec<(usize, usize)> = (0..self.order()).map(|i| (self.degree(i), i)).collect();
        if !matches!(weights, Weights::Given(_)) {
            degrees.sort_unstable();
            degrees.dedup_by_key(|(degree, _)| *degree);
        }
        let joined = degrees.into_iter().filter(|(degree, _)| *degree > 0);
        let denominators = joined.filter_map(|(degree, i)| weights.of(degree, i)).map(|c| c.denom());
        denominators.fold(BigInt::from(1), |m, d| lcm(&m, &d))
    }

    /// `c_i`, where it suits the number of neighbours.
    pub fn weight(&self, weights: &Weights, i: usize, time: &BigInt) -> Result<Rational, FlockError> {
        let degree = self.degree(i);
        let c = weights.of(degree, i).ok_or(FlockError::Weights { birds: self.order(), bird: i + 1 })?;
        if degree > 0 && (&c * BigInt::from(degree) >= c.one() || c <= c.zero()) {
            let (c, time) = (c.to_string(), time.to_string());
            return Err(FlockError::Inadmissible { bird: i + 1, degree, c, time });
        }
        Ok(c)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::rational;

    /// A path of three birds, a pair and one alone.
    fn links() -> Links {
        Links::new(&Graph::from_edges(6, &[(0, 4), (4, 2), (1, 5)]).expect("a graph"))
    }

    #[test]
    fn links_are_those_of_the_graph() {
        let mut links = links();
        assert_eq!(links.order(), 6);
        assert_eq!((0..6).map(|i| links.degree(i)).collect::<Vec<_>>(), [1, 1, 1, 0, 2, 1]);
        assert_eq!(links.components(), (vec![0, 1, 0, 2, 0, 1], 3));
        links.toggle((3, 5));
        assert_eq!((links.near(3), links.near(5), links.components().1), (&[5][..], &[1, 3][..], 2));
        links.toggle((1, 5));
        assert_eq!(
            (links.near(1), links.near(5), links.components()),
            (&[][..], &[3][..], (vec![0, 1, 0, 2, 0, 2], 3))
        );
        links.toggle((0, 4));
        links.toggle((2, 4));
        assert_eq!(links.components(), (vec![0, 1, 2, 3, 4, 3], 5));
    }

    /// `2/(3d)` and `1/(d + 1)` for the degrees 1 and 2, and given weights of those who have neighbours.
    #[test]
    fn a_step_multiplies_the_denominator_by_that_of_the_weights() {
        assert_eq!(links().multiplier(&Weights::Lazy), BigInt::from(3));
        assert_eq!(links().multiplier(&Weights::Vicsek), BigInt::from(6));
        let given = [(1, 5), (1, 7), (1, 4), (1, 11), (1, 6), (1, 7)].map(|(p, q)| rational(p, q)).to_vec();
        assert_eq!(links().multiplier(&Weights::Given(given)), BigInt::from(5 * 7 * 12));
        assert_eq!(Links::new(&Graph::empty(3)).multiplier(&Weights::Lazy), BigInt::from(1));
    }

    #[test]
    fn weights_suit_the_number_of_neighbours() {
        let time = BigInt::from(9);
        let weight = |c: (i64, i64), i: usize| links().weight(&Weights::Given(vec![rational(c.0, c.1); 6]), i, &time);
        assert_eq!(weight((1, 3), 4), Ok(rational(1, 3)));
        for (c, i) in [((1, 2), 4), ((1, 1), 0), ((2, 3), 4), ((0, 1), 0), ((-1, 5), 0)] {
            let (degree, time) = (links().degree(i), time.to_string());
            let refused = FlockError::Inadmissible { bird: i + 1, degree, c: rational(c.0, c.1).to_string(), time };
            assert_eq!(weight(c, i), Err(refused));
        }
        // Who is alone needs none that suits.
        assert_eq!(weight((5, 1), 3), Ok(rational(5, 1)));
        let few = links().weight(&Weights::Given(vec![rational(1, 3); 2]), 4, &time);
        assert_eq!(few, Err(FlockError::Weights { birds: 6, bird: 5 }));
    }
}
