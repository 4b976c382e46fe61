//! Networks over time: all sequences of a length, random ones, and those of exact flocks, each constant at the end.

use super::flock::{Flock, Start};
use super::weights::FlockError;
use algebra::graph::Graph;
use algebra::matrix::{Footprint, Stabiliser, StabiliserStream};
use arithmetic::words;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// A network over time: `G_1, ..., G_L`, then `G_L` for ever.
#[derive(Debug, Clone)]
pub struct NetworkHistory {
    order: usize,
    graphs: Vec<Graph>,
    footprints: Vec<Footprint>,
}

impl NetworkHistory {
    /// From `G_1, ..., G_L`, all on so many birds; where there are none, no two birds are ever joined.
    fn new(order: usize, mut graphs: Vec<Graph>) -> Self {
        while graphs.len() > 1 && graphs[graphs.len() - 2] == graphs[graphs.len() - 1] {
            graphs.pop();
        }
        if graphs.is_empty() {
            graphs.push(Graph::empty(order));
        }
        let footprints = graphs.iter().map(Graph::closed_adjacency).collect();
        NetworkHistory { order, graphs, footprints }
    }

    /// All sequences of so many networks on so many birds.
    pub fn all(order: usize, length: usize) -> impl Iterator<Item = NetworkHistory> {
        let graphs: Vec<Graph> = Graph::all(order).collect();
        let graph = move |word: Vec<usize>| word.into_iter().map(|k| graphs[k].clone()).collect();
        let count = Graph::all(order).count();
        words(count, length).map(move |word| NetworkHistory::new(order, graph(word)))
    }

    /// A random sequence of so many networks, in each of which a pair is joined with probability `joined` out of 4.
    pub fn random(order: usize, length: usize, joined: u32, random: &mut ChaCha8Rng) -> Self {
        NetworkHistory::new(order, (0..length).map(|_| random_network(order, joined, random)).collect())
    }

    /// The networks of so many steps of a flock, as if the last one stayed for ever.
    ///
    /// # Errors
    /// As for [`Flock::new`] and [`Flock::step`].
    pub fn of_flock(start: &Start, steps: usize) -> Result<Self, FlockError> {
        let mut flock = Flock::new(start)?;
        let mut graphs = Vec::with_capacity(steps);
        for _ in 0..steps {
            flock.step()?;
            graphs.push(flock.network().clone());
        }
        Ok(NetworkHistory::new(flock.birds(), graphs))
    }

    /// Number of birds.
    pub fn order(&self) -> usize {
        self.order
    }

    /// `G_1, ..., G_L`, at least one.
    pub fn graphs(&self) -> &[Graph] {
        &self.graphs
    }

    /// `L`: the network is constant from then on.
    pub fn constant_from(&self) -> usize {
        self.graphs.len()
    }

    /// `G_t`, for `t` from 1.
    pub fn at(&self, t: usize) -> &Graph {
        &self.graphs[t.clamp(1, self.graphs.len()) - 1]
    }

    /// The footprint of `P(t)`, for `t` from 1.
    pub fn footprint(&self, t: usize) -> &Footprint {
        &self.footprints[t.clamp(1, self.footprints.len()) - 1]
    }

    /// The number of `u`, `first <= u <= last`, with `G_u` and `G_{u-1}` different on the given birds; `first >= 2`.
    pub fn changes_within(&self, birds: &[usize], first: usize, last: usize) -> usize {
        let at = |t: usize| self.footprint(t).restricted(birds);
        (first.max(2)..=last.min(self.constant_from())).filter(|&u| at(u) != at(u - 1)).count()
    }

    /// The number of `u`, `first <= u <= last`, with `G_u != G_{u-1}`; `first >= 2`.
    pub fn changes(&self, first: usize, last: usize) -> usize {
        let differs = |&u: &usize| self.footprint(u) != self.footprint(u - 1);
        (first.max(2)..=last.min(self.constant_from())).filter(differs).count()
    }

    /// `t_1 = s, t_2, ...`: the times at which a column of `P(t, s)` acquires its successive weights.
    pub fn growth_times(&self, column: usize, s: usize) -> Vec<usize> {
        let mut product = self.footprint(s).clone();
        let mut times = vec![s];
        for t in s + 1..=self.constant_from() + self.order {
            let next = self.footprint(t).times(&product);
            if next.column(column).len() > product.column(column).len() {
                times.push(t);
            }
            product = next;
        }
        times
    }

    /// The first `levels` stabilisers for `s = 1`, final for all future time: once the network is constant, each level
    /// settles within `order` more factors, and the next one starts after it.
    pub fn stabilisers(&self, levels: usize) -> Vec<Stabiliser> {
        let mut stream = StabiliserStream::new(self.order, levels);
        for t in 1..=self.constant_from() + (levels + 1) * self.order {
            stream.push(self.footprint(t));
        }
        stream.stabilisers().cloned().collect()
    }
}

/// A random network in which every pair is joined with probability `joined` out of 4.
pub fn random_network(order: usize, joined: u32, random: &mut ChaCha8Rng) -> Graph {
    let pairs: Vec<bool> = (0..order * order).map(|_| random.next_u32() % 4 < joined).collect();
    Graph::from_fn(order, |i, j| pairs[i * order + j])
}
