//! Birds with exactly equal velocities, by the way these come about: what recognises true ties.
//!
//! Two birds of one class have the same velocity, whatever it is: they had the same once, and every averaging since took the same
//! weights of the same velocities. Birds of different classes may have equal velocities too.

use crate::averaging::weights::Weights;
use algebra::graph::Graph;
use std::collections::{BTreeMap, BTreeSet};

/// The classes of all birds, and the pairs at distance exactly 1 that have been of one class ever since that was found.
#[derive(Debug, Clone, Default)]
pub(super) struct Classes {
    of: Vec<u64>,
    next: u64,
    ties: BTreeSet<(u32, u32)>,
}

impl Classes {
    /// Notes a pair that is at distance exactly 1 after the next move, in which the two move alike; `classes` tells which birds
    /// have equal velocities in this move.
    pub fn note(&mut self, pair: (u32, u32), classes: impl FnOnce() -> Vec<u64>) {
        if self.ties.is_empty() {
            self.of = classes();
            self.next = self.of.iter().max().map_or(0, |most| most + 1);
        }
        if self.are_alike(pair) {
            self.ties.insert(pair);
        }
    }

    /// Whether anything is known.
    pub fn are_known(&self) -> bool {
        !self.ties.is_empty()
    }

    /// Whether a pair is known to be at distance exactly 1.
    pub fn is_tie(&self, pair: (u32, u32)) -> bool {
        self.ties.contains(&pair)
    }

    /// Whether two birds are known to have the same velocity; nothing is known as long as no tie is.
    fn are_alike(&self, (i, j): (u32, u32)) -> bool {
        match (self.of.get(i as usize), self.of.get(j as usize)) {
            (Some(a), Some(b)) => a == b,
            _ => false,
        }
    }

    /// The class of all these birds, where they are known to be of one.
    pub fn common(&self, birds: &[usize]) -> Option<u64> {
        let first = *self.of.get(*birds.first()?)?;
        birds.iter().all(|&i| self.of[i] == first).then_some(first)
    }

    /// Whether the velocities of all birds of each component agree, so that they never change.
    pub fn is_still(&self, component_of: &[u32], components: usize) -> Vec<bool> {
        let mut first = vec![None; components];
        let mut still = vec![!self.of.is_empty(); components];
        for (&class, &component) in self.of.iter().zip(component_of) {
            let component = component as usize;
            still[component] &= *first[component].get_or_insert(class) == class;
        }
        still
    }

    /// The classes after averaging on a network.
    pub fn average(&mut self, network: &Graph, weights: &Weights) {
        if self.ties.is_empty() {
            self.of.clear();
            return;
        }
        let mut fresh: BTreeMap<(u64, usize, Vec<u64>), u64> = BTreeMap::new();
        let mut next = self.next;
        let after: Vec<u64> = (0..self.of.len())
            .map(|i| {
                let own = self.of[i];
                let near = network.neighbours(i);
                if near.iter().all(|&j| self.of[j as usize] == own) {
                    return own;
                }
                let mut others: Vec<u64> = near.iter().map(|&j| self.of[j as usize]).collect();
                others.sort_unstable();
                // Given weights belong to birds, the others to degrees.
                let weight = if matches!(weights, Weights::Given(_)) { i } else { 0 };
                *fresh.entry((own, weight, others)).or_insert_with(|| {
                    next += 1;
                    next - 1
                })
            })
            .collect();
        self.of = after;
        self.next = next;
        let of = &self.of;
        self.ties.retain(|&(i, j)| of[i as usize] == of[j as usize]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::averaging::transition_matrix;
    use arithmetic::random::generator;
    use arithmetic::{Rational, rational};
    use rand_chacha::rand_core::Rng;

    /// Classes with these ties, noted in order.
    fn noted(of: &[u64], pairs: &[(u32, u32)]) -> Classes {
        let mut classes = Classes::default();
        pairs.iter().for_each(|&pair| classes.note(pair, || of.to_vec()));
        classes
    }

    fn network(edges: &[(usize, usize)]) -> Graph {
        Graph::from_edges(6, edges).expect("a graph")
    }

    #[test]
    fn ties_are_of_one_class() {
        let mut classes = noted(&[0, 1, 0, 2, 1, 7], &[(0, 2)]);
        // While there is a tie the classes are not asked for again.
        classes.note((1, 4), || panic!("known"));
        classes.note((0, 1), || panic!("known"));
        assert_eq!([(0, 2), (1, 4), (0, 1), (3, 5)].map(|pair| classes.is_tie(pair)), [true, true, false, false]);
        // Where there is none they are, and what is known of others is not more.
        let mut classes = noted(&[0, 1, 0, 2, 1, 7], &[(0, 1)]);
        classes.note((0, 1), || vec![5; 6]);
        assert!(classes.is_tie((0, 1)) && !classes.is_tie((0, 2)));
        assert!(!Classes::default().are_alike((0, 0)) && !classes.are_alike((0, 6)));
    }

    #[test]
    fn components_are_still_where_all_are_of_one_class() {
        let classes = noted(&[3, 3, 1, 1, 2, 3], &[(0, 1)]);
        assert_eq!(classes.is_still(&[0, 0, 1, 1, 2, 0], 3), [true; 3]);
        assert_eq!(classes.is_still(&[0, 1, 1, 2, 2, 0], 3), [true, false, false]);
        assert_eq!(Classes::default().is_still(&[0, 1], 2), [false; 2]);
    }

    /// Birds of one class stay so with neighbours of the same classes, in any order; with weights of their own they do not, unless nothing changes.
    #[test]
    fn averages_of_the_same_are_the_same() {
        let of = [0, 0, 1, 2, 2, 1];
        let ties = [(0, 1), (2, 5), (3, 4)];
        let both = network(&[(0, 2), (0, 3), (1, 4), (1, 5)]);
        let after = |network: &Graph, weights: &Weights| {
            let mut classes = noted(&of, &ties);
            classes.average(network, weights);
            ties.map(|pair| classes.is_tie(pair))
        };
        let given = Weights::Given(vec![rational(1, 5); 6]);
        assert_eq!(after(&both, &Weights::Lazy), [true; 3]);
        assert_eq!(after(&both, &given), [false; 3]);
        assert_eq!(after(&network(&[(0, 1), (2, 5)]), &given), [true; 3]);
        // Another neighbour, one more for bird 1, or one of the own class beside it.
        assert_eq!(after(&network(&[(0, 2), (1, 3)]), &Weights::Lazy), [false; 3]);
        assert_eq!(after(&network(&[(0, 2), (1, 5), (1, 3)]), &Weights::Lazy), [false, true, false]);
        assert_eq!(after(&network(&[(0, 2), (0, 1), (1, 5)]), &Weights::Lazy), [true, true, true]);
        // Without ties nothing is known.
        let mut classes = noted(&of, &[(0, 2)]);
        classes.average(&both, &Weights::Lazy);
        assert!(classes.of.is_empty());
    }

    /// The exact twin: velocities by classes, any numbers at first, averaged by the matrix. What is of one class has one velocity.
    #[test]
    fn birds_of_one_class_have_one_velocity() {
        let (mut alike, mut kept) = (0, 0);
        for case in 0..300 {
            let mut random = generator("test", "classes", case);
            let mut below = |k: u32| random.next_u32() % k;
            let of: Vec<u64> = (0..6).map(|_| u64::from(below(3))).collect();
            let mut velocities: Vec<Rational> = of.iter().map(|&c| rational([2, 7, 31][c as usize], 1)).collect();
            let all: Vec<(u32, u32)> = (0..6).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
            let mut classes = noted(&of, &all);
            let weights =
                [Weights::Lazy, Weights::Vicsek, Weights::Given(vec![rational(1, 7); 6])][below(3) as usize].clone();
            for _ in 0..4 {
                let edges: Vec<(usize, usize)> =
                    all.iter().filter(|_| below(4) == 0).map(|&(i, j)| (i as usize, j as usize)).collect();
                let graph = Graph::from_edges(6, &edges).expect("a graph");
                let rows = transition_matrix(&graph, &weights).expect("admissible").to_rows();
                velocities = rows.iter().map(|row| row.iter().zip(&velocities).map(|(p, v)| p * v).sum()).collect();
                classes.average(&graph, &weights);
                for &(i, j) in &all {
                    if classes.are_alike((i, j)) || classes.is_tie((i, j)) {
                        assert_eq!(velocities[i as usize], velocities[j as usize], "{case}: {i} {j}");
                        alike += 1;
                    }
                    kept += usize::from(classes.is_tie((i, j)));
                }
            }
        }
        assert!(alike > 300 && kept > 300, "{alike} {kept}");
    }
}
