//! Sequences of networks that the checks run over: all of a length, with a constant end, or of an exact flock.

use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::{Footprint, RationalMatrix, Stabiliser, StabiliserStream};
use models::averaging::settle::{Limits, Settlement, settle};
use models::averaging::{Flock, Hysteresis, Start, Switch, Weights};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// The edges of a network, birds from 1.
pub(super) fn show(graph: &Graph) -> String {
    let edges: Vec<String> = graph.edges().iter().map(|(i, j)| format!("{}-{}", i + 1, j + 1)).collect();
    if edges.is_empty() { "no edges".to_string() } else { edges.join(" ") }
}

/// The initial conditions of a flock.
pub(super) fn show_start(start: &Start) -> String {
    let list = |rows: &[Vec<Rational>]| {
        let row = |row: &Vec<Rational>| row.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        rows.iter().map(|r| format!("({})", row(r))).collect::<Vec<_>>().join(", ")
    };
    let (x, v) = (list(&start.positions), list(&start.velocities));
    let hysteresis = match &start.hysteresis {
        Hysteresis::None => "none".to_string(),
        Hysteresis::Paper => "that of the paper".to_string(),
        Hysteresis::Constant(threshold) => format!("with the threshold {threshold}"),
    };
    let weights = match &start.weights {
        Weights::Lazy => "lazy".to_string(),
        Weights::Vicsek => "c_i = 1/(d_i+1)".to_string(),
        Weights::Given(c) => format!("c = ({})", c.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")),
    };
    format!("x(0) = {x}, v(1) = {v}, weights {weights}, hysteresis {hysteresis}")
}

/// The networks one after the other.
pub(super) fn show_all(graphs: &[Graph]) -> String {
    graphs.iter().map(show).collect::<Vec<_>>().join(", then ")
}

/// All words of this length over `0..letters`.
pub(super) fn words(letters: usize, length: u32) -> impl Iterator<Item = Vec<usize>> {
    (0..letters.pow(length)).map(move |mut code| {
        let mut letter = || {
            let last = code % letters;
            code /= letters;
            last
        };
        (0..length).map(|_| letter()).collect()
    })
}

/// A random network in which every pair is joined with probability `joined` out of 4.
pub(super) fn random_graph(order: usize, joined: u32, random: &mut ChaCha8Rng) -> Graph {
    let pairs: Vec<bool> = (0..order * order).map(|_| random.next_u32() % 4 < joined).collect();
    Graph::from_fn(order, |i, j| pairs[i * order + j])
}

/// The weights with `c_i d_i` equal to this share for birds with neighbours.
pub(super) fn share_weights(graph: &Graph, (p, q): (i64, i64)) -> Weights {
    Weights::Given((0..graph.order()).map(|i| rational(p, q * (graph.degree(i) as i64).max(1))).collect())
}

/// The matrix in which `i` no longer sees `j > i` (its weight stays with `i`): not of the model.
pub(super) fn seen_from_one_side(matrix: &RationalMatrix) -> Result<RationalMatrix, CheckError> {
    let mut rows = matrix.to_rows();
    for (i, row) in rows.iter_mut().enumerate() {
        for j in i + 1..row.len() {
            let moved = std::mem::replace(&mut row[j], rational(0, 1));
            row[i] += moved;
        }
    }
    Ok(RationalMatrix::from_rows(&rows)?)
}

/// The networks `G_1, ..., G_steps` of a flock on the line that starts with `x(0)` and `v(1)`.
pub(super) fn line_networks(
    positions: Vec<Rational>,
    velocities: Vec<Rational>,
    weights: &Weights,
    hysteresis: Option<Rational>,
    steps: usize,
) -> Result<Vec<Graph>, CheckError> {
    let hysteresis = hysteresis.map_or(Hysteresis::None, Hysteresis::Constant);
    let mut flock = Flock::new(&Start::on_the_line(positions, velocities, weights.clone(), hysteresis))?;
    let mut networks = Vec::with_capacity(steps);
    for _ in 0..steps {
        flock.step()?;
        networks.push(flock.network().clone());
    }
    Ok(networks)
}

/// A network over time: `G_1, ..., G_L`, then `G_L` for ever.
pub(super) struct NetworkHistory {
    graphs: Vec<Graph>,
    footprints: Vec<Footprint>,
}

impl NetworkHistory {
    /// From `G_1, ..., G_L`, of the same order and at least one.
    pub fn new(mut graphs: Vec<Graph>) -> Self {
        while graphs.len() > 1 && graphs[graphs.len() - 2] == graphs[graphs.len() - 1] {
            graphs.pop();
        }
        let footprints = graphs.iter().map(Graph::closed_adjacency).collect();
        NetworkHistory { graphs, footprints }
    }

    pub fn order(&self) -> usize {
        self.graphs[0].order()
    }

    /// `L`: the network is constant from then on.
    pub fn constant_from(&self) -> usize {
        self.graphs.len()
    }

    /// `G_t`, for `t` from 1.
    pub fn at(&self, t: usize) -> &Graph {
        &self.graphs[t.clamp(1, self.graphs.len()) - 1]
    }

    /// The footprint of `P(t)`.
    pub fn footprint(&self, t: usize) -> &Footprint {
        &self.footprints[t.clamp(1, self.graphs.len()) - 1]
    }

    /// The number of `u`, `first <= u <= last`, with `G_u` and `G_{u-1}` different on the given birds; `first >= 2`.
    pub fn changes_within(&self, birds: &[usize], first: usize, last: usize) -> usize {
        let last = last.min(self.constant_from());
        let differs = |u: &usize| self.footprint(*u).restricted(birds) != self.footprint(u - 1).restricted(birds);
        (first..=last).filter(differs).count()
    }

    /// The number of `u`, `first <= u <= last`, with `G_u != G_{u-1}`; `first >= 2`.
    pub fn changes(&self, first: usize, last: usize) -> usize {
        let last = last.min(self.constant_from());
        (first..=last).filter(|&u| self.footprint(u) != self.footprint(u - 1)).count()
    }

    /// The first `levels` stabilisers for `s = 1`, final for all future time: once the network is constant, each level
    /// settles within `order` more factors, and the next one starts after it.
    pub fn stabilisers(&self, levels: usize) -> Vec<Stabiliser> {
        let mut stream = StabiliserStream::new(self.order(), levels);
        for t in 1..=self.constant_from() + (levels + 1) * self.order() {
            stream.push(self.footprint(t));
        }
        stream.stabilisers().cloned().collect()
    }

    /// The networks in words.
    pub fn show(&self) -> String {
        format!("{} birds, {}, and so for ever", self.order(), show_all(&self.graphs))
    }
}

/// All sequences of so many networks on so many birds, with a constant end.
pub(super) fn histories(sizes: impl IntoIterator<Item = (usize, u32)>) -> impl Iterator<Item = NetworkHistory> {
    sizes.into_iter().flat_map(|(order, length)| {
        let graphs: Vec<Graph> = Graph::all(order).collect();
        words(graphs.len(), length)
            .map(move |word| NetworkHistory::new(word.iter().map(|&k| graphs[k].clone()).collect()))
    })
}

/// A random flock of 2 to 5 birds on the line with the hysteresis of the paper, near enough to meet.
pub(super) fn random_line_flock(random: &mut ChaCha8Rng, steps: usize) -> Result<NetworkHistory, CheckError> {
    let mut below = |bound: i64| i64::from(random.next_u32()) % bound;
    let n = 2 + below(4);
    let positions = (0..n).map(|i| rational(12 * i + below(9), 16)).collect();
    let velocities = (0..n).map(|_| rational(below(17) - 8, 16)).collect();
    let weights = if below(2) == 0 { Weights::Lazy } else { Weights::Vicsek };
    let networks = line_networks(positions, velocities, &weights, Some(paper_threshold(n)), steps)?;
    Ok(NetworkHistory::new(networks))
}

/// The hysteresis threshold of the paper, `n^(-n^4)`.
pub(super) fn paper_threshold(n: i64) -> Rational {
    rational(1, n).pow(n.pow(4) as i32)
}

/// A crowded flock of 2 to 5 birds in dimension 1 to 3.
pub(super) fn random_start(random: &mut ChaCha8Rng, hysteresis: Hysteresis) -> Start {
    let mut below = |bound: i64| i64::from(random.next_u32()) % bound;
    let (n, dimension) = (2 + below(4), 1 + below(3));
    let mut vectors = |range: i64, shift: i64, unit: i64| -> Vec<Vec<Rational>> {
        (0..n).map(|_| (0..dimension).map(|_| rational(below(range) - shift, unit)).collect()).collect()
    };
    let (positions, velocities) = (vectors(40, 0, 16), vectors(13, 6, 48));
    let weights = if below(2) == 0 { Weights::Lazy } else { Weights::Vicsek };
    Start { positions, velocities, weights, hysteresis }
}

/// The four birds of Section 3 of the paper.
pub(super) fn four_birds(hysteresis: Hysteresis) -> Start {
    let over = |list: [i64; 4], unit: i64| list.map(|x| rational(x, unit)).to_vec();
    Start::on_the_line(over([0, 8, 21, 29], 16), over([1, -1, 1, -1], 8), Weights::Lazy, hysteresis)
}

/// All switches of a flock and what becomes of it.
pub fn settled(start: &Start, run: &Run) -> Result<(Vec<Switch>, Settlement), CheckError> {
    let mut switches = Vec::new();
    let settled = settle(Flock::new(start)?, &Limits::default(), &mut |switch| switches.push(switch.clone()), run)?;
    run.checkpoint()?;
    Ok((switches, settled))
}
