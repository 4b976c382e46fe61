//! Claims about flocks with a network that does not change (section 3, and the closed forms in the proof of Lemma 3.9).
//! Proofs for all networks are in notes/chazelle_fixed_network.md.

mod closed_forms;
mod denominators;
mod fiedler;
mod flight;
mod limits;
mod mixing;
mod powers;
mod spectrum;

use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use ledger::Claim;
use models::averaging::{Weights, transition_matrix};

pub fn claims() -> Vec<Box<dyn Claim>> {
    claims! {
        spectrum: stationary, symmetrised;
        powers: powers;
        mixing: second_eigenvalue, entrywise_rate, halving_time;
        fiedler: fiedler_rate;
        limits: limit_of_gamma, positions, relative_limit;
        denominators: short_limit;
        closed_forms: geometric_sums, with_gamma, two_birds_apart;
    }
}

/// How the evidence of these claims begins.
const FAMILY: &str = "every connected graph up to isomorphism";

/// The three kinds of weights that the instances carry.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Lazy,
    Vicsek,
    /// `c_i = i/((i+1) d_i)`, birds counted from 1: different shares for all birds. `O(log n)`-bit: numerators and
    /// denominators are at most `n^2`.
    Uneven,
    /// `c_i = 1/n`: a symmetric matrix.
    Uniform,
    /// `c_i = 1/d_i`, which model D forbids; for controls.
    Whole,
    /// `c_i = 4^-n`, which is not `O(log n)`-bit; for controls.
    Tiny,
}

impl Kind {
    const ADMISSIBLE: [Kind; 3] = [Kind::Lazy, Kind::Vicsek, Kind::Uneven];

    fn weights(self, graph: &Graph) -> Weights {
        let equal = |c: Rational| Weights::Given(vec![c; graph.order()]);
        match self {
            Kind::Lazy => Weights::Lazy,
            Kind::Vicsek => Weights::Vicsek,
            Kind::Uneven => Weights::uneven(graph),
            Kind::Uniform => equal(rational(1, graph.order() as i64)),
            Kind::Whole => Weights::of_share(graph, &rational(1, 1)),
            Kind::Tiny => equal(rational(1, 4).pow(graph.order() as i32)),
        }
    }
}

/// One network with its weights and transition matrix.
#[derive(Clone)]
struct Network {
    graph: Graph,
    kind: Kind,
    c: Vec<Rational>,
    p: RationalMatrix,
}

impl Network {
    fn new(graph: Graph, kind: Kind) -> Result<Self, CheckError> {
        let weights = kind.weights(&graph);
        let (c, p) = (weights.all(&graph)?, transition_matrix(&graph, &weights)?);
        Ok(Network { graph, kind, c, p })
    }

    fn order(&self) -> usize {
        self.graph.order()
    }

    /// `(tr C^k)^-1 C^k 1`; the stationary distribution for `k = -1`.
    fn normalised_power(&self, k: i32) -> Vec<Rational> {
        let powers: Vec<Rational> = self.c.iter().map(|c| c.pow(k)).collect();
        let trace: Rational = powers.iter().sum();
        powers.iter().map(|x| x / &trace).collect()
    }

    /// The stationary distribution, by its formula and whether or not the network is connected.
    fn pi(&self) -> Vec<Rational> {
        self.normalised_power(-1)
    }

    fn identity(&self) -> Result<RationalMatrix, CheckError> {
        Ok(RationalMatrix::identity(self.order())?)
    }

    /// Exponents with `1 - mu >= n^-gap` and both `sqrt(c_i/c_j)` and `1/sqrt(2 pi_i)` at most `n^factor`. They are
    /// proved for the admissible kinds; controls use them for the others too.
    fn exponents(&self) -> Exponents {
        Exponents { factor: 1, gap: if matches!(self.kind, Kind::Uneven | Kind::Tiny) { 4 } else { 3 } }
    }

    /// The network, to be seen.
    fn witness(&self) -> Witness {
        Witness::networks(self.order(), vec![self.graph.edges()])
    }

    /// The network in words, birds counted from 1.
    fn show(&self) -> String {
        let edges: Vec<String> = self.graph.edges().iter().map(|(i, j)| format!("{}-{}", i + 1, j + 1)).collect();
        let edges = if edges.is_empty() { "none".to_string() } else { edges.join(" ") };
        format!("n = {}, edges {edges}, c = ({})", self.order(), list(&self.c))
    }
}

/// The exponents of `n^factor e^(-s n^-gap)`.
#[derive(Clone, Copy)]
struct Exponents {
    factor: i32,
    gap: i32,
}

/// Two cliques of `m` birds joined by a path through `m` more: the slowest to mix, `1 - lambda_2` is of the order
/// `n^-3`.
fn barbell(m: usize) -> Graph {
    let clique = |i: usize| {
        if i < m {
            0
        } else if i < 2 * m {
            1
        } else {
            2
        }
    };
    Graph::from_fn(3 * m, |i, j| i + 1 == j || (clique(i) != 1 && clique(i) == clique(j)))
}

/// An upper bound of `1 - lambda_2` on lazy barbells, exactly: the Rayleigh quotient of the function that is -1 on
/// one clique, 1 on the other and linear between. Where it is below `n^-gap / 2`, no bound `n^O(1) e^(-s n^-gap)` or
/// `n^O(1) 2^(-s n^-gap)` can hold for all `s`, because `1 - e^-x > 1 - 2^-x >= x/2` for `x <= 1`.
fn too_slow_for(gap: i32) -> Result<Option<String>, CheckError> {
    for m in [2, 8, 26] {
        let network = Network::new(barbell(m), Kind::Lazy)?;
        let (n, pi) = (network.order(), network.pi());
        let place = |i: usize| rational((i as i64 + 1 - m as i64).clamp(0, m as i64 + 1), m as i64 + 1);
        let f: Vec<Rational> = (0..n).map(|i| place(i) * rational(2, 1) - rational(1, 1)).collect();
        let edges = network.graph.edges().into_iter();
        let form: Rational = edges.map(|(i, j)| &pi[i] * network.p.entry(i, j) * (&f[i] - &f[j]).pow(2)).sum();
        let mean: Rational = pi.iter().zip(&f).map(|(p, x)| p * x).sum();
        let variance = pi.iter().zip(&f).map(|(p, x)| p * (x - &mean).pow(2)).sum::<Rational>();
        let most = form / variance;
        if most < power_of_order(n, -gap) / rational(2, 1) {
            let what = "two lazy cliques of m birds joined by a path through m more";
            return Ok(Some(format!("{what}, m = {m}: 1 - lambda_2 <= {most}, less than n^-{gap}/2")));
        }
    }
    Ok(None)
}

/// `n^k` for any integer `k`.
fn power_of_order(n: usize, k: i32) -> Rational {
    rational(n as i64, 1).pow(k)
}

#[derive(Clone, Copy)]
struct Family<'a> {
    kinds: &'a [Kind],
    /// Only connected graphs, one of each isomorphism class; otherwise all labelled graphs.
    connected: bool,
}

impl Family<'static> {
    /// What section 3 is about.
    const PRINTED: Family<'static> = Family { kinds: &Kind::ADMISSIBLE, connected: true };
    /// Without the hypothesis that the graph is connected.
    const ANY_GRAPH: Family<'static> = Family { kinds: &Kind::ADMISSIBLE, connected: false };
    /// Without `c_i d_i < 1`.
    const WHOLE: Family<'static> = Family { kinds: &[Kind::Whole], connected: true };
    /// Without the hypothesis on the length of the weights.
    const TINY: Family<'static> = Family { kinds: &[Kind::Tiny], connected: true };
}

impl Family<'_> {
    fn networks(self, largest: usize) -> Result<Vec<Network>, CheckError> {
        // Without the hypothesis a small counterexample is enough.
        let largest = if self.connected { largest } else { largest.min(3) };
        let graphs = (1..=largest).flat_map(|order| {
            if self.connected { Graph::connected_up_to_isomorphism(order) } else { Graph::all(order).collect() }
        });
        graphs.flat_map(|graph| self.kinds.iter().map(move |&kind| Network::new(graph.clone(), kind))).collect()
    }

    /// All labelled graphs of the family on up to `every` birds, one of each isomorphism class beyond.
    fn labelled(self, every: usize, largest: usize) -> Result<Vec<Network>, CheckError> {
        if !self.connected {
            return self.networks(largest);
        }
        let small = (1..=every).flat_map(|order| Graph::all(order).filter(Graph::is_connected));
        let larger = (every + 1..=largest).flat_map(Graph::connected_up_to_isomorphism);
        small
            .chain(larger)
            .flat_map(|graph| self.kinds.iter().map(move |&kind| Network::new(graph.clone(), kind)))
            .collect()
    }
}

/// A check of all networks as the whole evidence of a part.
fn exhaustively(
    networks: &[Network],
    run: &Run,
    part: &str,
    detail: impl Into<String>,
    mut check: impl FnMut(&Network) -> Result<Option<String>, CheckError>,
) -> Result<Outcome, CheckError> {
    run.every(exhaustive(part, detail), networks, |network| {
        let text = |what: String| format!("{}: {what}", network.show());
        Ok(check(network)?.map(|what| Counterexample::new(text(what), [network.witness()])))
    })
}
