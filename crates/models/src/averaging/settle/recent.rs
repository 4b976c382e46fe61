//! The networks of the last steps, and whether they go round.

use crate::averaging::flock::Switch;
use algebra::graph::Graph;

/// The longest cycle of networks that is looked for.
const LONGEST_CYCLE: usize = 6;

/// Times a cycle is seen before it is analysed.
const REPETITIONS: usize = 6;

/// So many networks are remembered; then all are forgotten.
const MOST: usize = 4 * LONGEST_CYCLE * REPETITIONS;

/// The networks of the last steps, as long as switches follow one another closely.
#[derive(Default)]
pub(super) struct Recent {
    /// The pairs that each step changed.
    changes: Vec<Vec<(usize, usize)>>,
}

impl Recent {
    /// Notes what a step changed.
    pub fn push(&mut self, switch: Option<&Switch>) {
        if self.changes.len() == MOST {
            self.clear();
        }
        let pairs = switch.iter().flat_map(|switch| switch.gained.iter().chain(&switch.lost)).copied().collect();
        self.changes.push(pairs);
    }

    pub fn clear(&mut self) {
        self.changes.clear();
    }

    /// The length of the shortest cycle that the networks have gone round often enough; found only where their number is a multiple of twice as
    /// many steps, so not at every one.
    pub fn period(&self) -> Option<usize> {
        let steps = self.changes.len();
        let repeats = |period: usize| {
            let seen = REPETITIONS * period;
            steps.is_multiple_of(2 * seen)
                && steps >= 2 * seen
                && (steps - seen..steps).all(|k| leave_nothing(&self.changes[k + 1 - period..=k]))
        };
        (2..=LONGEST_CYCLE).find(|&p| repeats(p))
    }

    /// The networks of the last steps, at most so many, up to this one.
    pub fn last(&self, count: usize, now: &Graph) -> Vec<Graph> {
        let mut networks = Vec::new();
        let mut network = now.clone();
        for pairs in self.changes.iter().rev().take(count) {
            networks.push(network.clone());
            pairs.iter().for_each(|&(i, j)| network.toggle(i, j));
        }
        networks.reverse();
        networks
    }
}

/// Whether these changes together change nothing.
fn leave_nothing(changes: &[Vec<(usize, usize)>]) -> bool {
    let mut pairs: Vec<_> = changes.iter().flatten().map(|&(i, j)| (i.min(j), i.max(j))).collect();
    pairs.sort_unstable();
    pairs.chunk_by(|a, b| a == b).all(|same| same.len().is_multiple_of(2))
}
