//! Birds with exactly equal velocities, by the way these come about: what recognises true ties.
//!
//! Two birds of one class have the same velocity, whatever it is: they had the same once, and every averaging since took the same
//! weights of the same velocities. Birds of different classes may have equal velocities too.

use super::links::Links;
use crate::averaging::Weights;
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
    pub fn average(&mut self, links: &Links, weights: &Weights) {
        if self.ties.is_empty() {
            self.of.clear();
            return;
        }
        let mut fresh: BTreeMap<(u64, usize, Vec<u64>), u64> = BTreeMap::new();
        let mut next = self.next;
        let after: Vec<u64> = (0..self.of.len())
            .map(|i| {
                let own = self.of[i];
                let near = links.near(i);
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
