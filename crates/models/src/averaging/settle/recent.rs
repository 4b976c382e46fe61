//! The networks of the last steps, and whether they go round.

use algebra::graph::Graph;
use std::sync::Arc;

/// The longest cycle of networks that is looked for.
const LONGEST_CYCLE: usize = 6;

/// Times a cycle is seen before it is analysed.
const REPETITIONS: usize = 6;

/// So many networks are remembered; then all are forgotten.
const MOST: usize = 4 * LONGEST_CYCLE * REPETITIONS;

/// The networks of the last steps, as long as switches follow one another closely.
#[derive(Default)]
pub(super) struct Recent {
    networks: Vec<Arc<Graph>>,
}

impl Recent {
    /// Notes the network of a step.
    pub fn push(&mut self, network: Graph) {
        self.note(Arc::new(network));
    }

    /// Notes that the network of a step is the one before; `false` where none is remembered.
    pub fn push_same(&mut self) -> bool {
        let last = self.networks.last().filter(|_| self.networks.len() < MOST).cloned();
        last.map(|same| self.note(same)).is_some()
    }

    fn note(&mut self, network: Arc<Graph>) {
        if self.networks.len() == MOST {
            self.clear();
        }
        self.networks.push(network);
    }

    pub fn clear(&mut self) {
        self.networks.clear();
    }

    /// The length of the shortest cycle that the networks have gone round often enough; found only where their number is a multiple of twice as
    /// many steps, so not at every one.
    pub fn period(&self) -> Option<usize> {
        let networks = &self.networks;
        let repeats = |period: usize| {
            let seen = REPETITIONS * period;
            networks.len().is_multiple_of(2 * seen)
                && networks.len() >= 2 * seen
                && (networks.len() - seen..networks.len()).all(|k| networks[k] == networks[k - period])
        };
        (2..=LONGEST_CYCLE).find(|&p| repeats(p))
    }

    /// The networks of the last steps, at most so many.
    pub fn last(&self, count: usize) -> Vec<Graph> {
        let first = self.networks.len().saturating_sub(count);
        self.networks[first..].iter().map(|network| (**network).clone()).collect()
    }
}
