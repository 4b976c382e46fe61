//! beyond.chazelle.recurrent: flocks whose networks are connected only over windows of time.

use crate::prelude::*;
use algebra::graph::{Graph, WeightedGraph};
use algebra::matrix::{Footprint, RationalMatrix, StochasticMatrix};
use models::averaging::{Weights, transition_matrix};
use rand_chacha::rand_core::Rng;
use std::sync::Arc;

/// What counts as a window, and the bound: one factor `1 - alpha^power` for every `windows` windows of `n` birds.
#[derive(Clone, Copy)]
pub struct RecurrentVariant {
    /// Windows are connected together; otherwise any factor is one.
    connected: bool,
    /// An arc leads to the bird that is heard; otherwise to the one that hears.
    to_the_heard: bool,
    /// Birds give weight to themselves.
    keeps_own: bool,
    windows: fn(n: usize) -> usize,
    network_power: fn(n: usize) -> usize,
    directed_power: fn(n: usize, length: usize) -> usize,
}

/// A matrix that may be chosen at each time.
struct Factor {
    matrix: StochasticMatrix,
    heard: Footprint,
    least: Rational,
    arcs: Arc<str>,
    is_tree: bool,
}

impl Factor {
    fn new(matrix: &RationalMatrix) -> Result<Self, CheckError> {
        let least = matrix.least_positive().unwrap_or_default();
        let matrix = StochasticMatrix::try_from(matrix)?;
        let heard = matrix.footprint();
        let n = heard.rows();
        let pairs = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).filter(|&(i, j)| i != j && heard.get(i, j));
        let arcs: Vec<String> = pairs.map(|(i, j)| format!("{}<-{}", i + 1, j + 1)).collect();
        let pairs_heard = arcs.len();
        let arcs = if arcs.is_empty() { "nothing".to_string() } else { arcs.join(" ") };
        let is_tree = heard.is_symmetric() && pairs_heard == 2 * (n - 1) && heard.is_rooted();
        Ok(Factor { matrix, heard, least, arcs: arcs.into(), is_tree })
    }

    /// Model D on a network.
    fn network(graph: &Graph, weights: &Weights) -> Result<Self, CheckError> {
        Factor::new(&transition_matrix(graph, weights)?)
    }

    /// Everybody gives equal weight to itself and to the birds it listens to: `listens(i, j)`.
    fn directed(n: usize, listens: impl Fn(usize, usize) -> bool) -> Result<Self, CheckError> {
        let row = |i: usize| {
            let ones: Vec<bool> = (0..n).map(|j| i == j || listens(i, j)).collect();
            let count = ones.iter().filter(|one| **one).count() as i64;
            ones.into_iter().map(|one| rational(i64::from(one), count)).collect::<Vec<_>>()
        };
        Factor::new(&RationalMatrix::from_rows(&(0..n).map(row).collect::<Vec<_>>())?)
    }
}

/// The factors of all networks on `n` birds, lazy and with equal weights; or without any weight for the bird itself.
fn networks(n: usize, keeps_own: bool) -> Result<Vec<Factor>, CheckError> {
    let weights = |graph: &Graph| match keeps_own {
        true => vec![Weights::Lazy, Weights::Vicsek],
        false => vec![Weights::of_share(graph, &rational(1, 1))],
    };
    let all = Graph::all(n).flat_map(|graph| weights(&graph).into_iter().map(move |w| (graph.clone(), w)));
    all.map(|(graph, weights)| Factor::network(&graph, &weights)).collect()
}

/// The factors of all directed networks on `n` birds.
fn directed_networks(n: usize) -> Result<Vec<Factor>, CheckError> {
    WeightedGraph::all(n).map(|graph| Factor::directed(n, |i, j| graph.adjacency().get(i, j).is_some())).collect()
}

/// A product of factors, the latest on the left, cut into windows.
#[derive(Clone)]
struct Product {
    matrix: StochasticMatrix,
    least: Rational,
    /// What was heard since the last window ended, and for how long.
    heard: Footprint,
    since: usize,
    windows: usize,
    /// Whether all windows were connected.
    recurrent: bool,
    arcs: Vec<Arc<str>>,
}

impl Product {
    fn empty(n: usize) -> Result<Self, CheckError> {
        let identity = RationalMatrix::identity(n)?;
        Ok(Product {
            matrix: StochasticMatrix::try_from(&identity)?,
            least: rational(1, 1),
            heard: Footprint::from_fn(n, n, |_, _| false),
            since: 0,
            windows: 0,
            recurrent: true,
            arcs: Vec::new(),
        })
    }
}

/// How windows end: when they are connected, or after so many factors, connected or not.
#[derive(Clone, Copy)]
enum Windows {
    Any,
    Of(usize),
}

impl RecurrentVariant {
    fn after(&self, before: &Product, factor: &Factor, windows: Windows) -> Result<Product, CheckError> {
        let n = factor.heard.rows();
        let mut next = before.clone();
        next.matrix = factor.matrix.times(&before.matrix)?;
        next.least = factor.least.clone().min(before.least.clone());
        next.heard = before.heard.or(&factor.heard);
        next.since += 1;
        next.arcs.push(factor.arcs.clone());
        let arcs = match self.to_the_heard {
            true => next.heard.clone(),
            false => Footprint::from_fn(n, n, |i, j| next.heard.get(j, i)),
        };
        let rooted = !self.connected || arcs.is_rooted();
        let ends = match windows {
            Windows::Any => rooted,
            Windows::Of(length) => next.since == length,
        };
        if ends {
            next.recurrent &= rooted;
            next.windows += 1;
            next.since = 0;
            next.heard = Footprint::from_fn(n, n, |_, _| false);
        }
        Ok(next)
    }

    /// What is wrong with the bound after these factors.
    fn fails_at(&self, product: &Product, windows: Windows) -> Option<String> {
        let n = product.heard.rows();
        let power = match windows {
            Windows::Any => (self.network_power)(n),
            Windows::Of(length) => (self.directed_power)(n, length),
        };
        let factor = rational(1, 1) - product.least.power(power as u64);
        let bound = factor.power((product.windows / (self.windows)(n)) as u64);
        let tau = product.matrix.tau_1();
        let times = || product.arcs.join(", then ");
        (tau > bound).then(|| format!("{n} birds, who hears whom: {}: tau_1 = {tau}, the bound is {bound}", times()))
    }

    /// Runs over all sequences of up to `left` more factors; the first that fails.
    fn search(
        &self,
        factors: &[Factor],
        (before, left): (&Product, usize),
        windows: Windows,
        (cases, run): (&mut usize, &Run),
    ) -> Result<Option<String>, CheckError> {
        run.checkpoint()?;
        for factor in factors.iter().filter(|_| left > 0) {
            let next = self.after(before, factor, windows)?;
            if !next.recurrent {
                continue;
            }
            *cases += 1;
            if let Some(what) = self.fails_at(&next, windows) {
                return Ok(Some(what));
            }
            if let Some(what) = self.search(factors, (&next, left - 1), windows, (cases, run))? {
                return Ok(Some(what));
            }
        }
        Ok(None)
    }

    /// Runs over one sequence; `cases` are the products whose bound is below 1.
    fn follow(&self, factors: &[&Factor], windows: Windows, cases: &mut usize) -> Result<Option<String>, CheckError> {
        let Some(first) = factors.first() else { return Ok(None) };
        let n = first.heard.rows();
        let mut product = Product::empty(n)?;
        for factor in factors {
            product = self.after(&product, factor, windows)?;
            if !product.recurrent {
                break;
            }
            if let Some(what) = self.fails_at(&product, windows) {
                return Ok(Some(what));
            }
            *cases += usize::from(product.windows >= (self.windows)(n));
        }
        Ok(None)
    }

    /// All sequences over all networks of 2 and 3 birds, and over the trees on 4; none of the bounds is 1 at their
    /// ends.
    fn on_networks(&self, run: &Run) -> Result<Outcome, CheckError> {
        const PART: &str = "tau_1 against the bound, networks";
        let mut cases = 0;
        for (n, length) in [(2, 5), (3, run.cases(3, 4)), (4, 3)] {
            let factors = networks(n, self.keeps_own)?;
            let factors: Vec<Factor> = factors.into_iter().filter(|f| n < 4 || f.is_tree).collect();
            let start = Product::empty(n)?;
            if let Some(what) = self.search(&factors, (&start, length), Windows::Any, (&mut cases, run))? {
                return Ok(failure(PART, what));
            }
        }
        let detail = "all sequences of networks on 2 and 3 birds and of three trees on 4, lazy and equal weights";
        holds(exhaustive(PART, detail).on([1]).cases(cases))
    }

    /// All sequences of directed networks of 2 and 3 birds.
    fn on_directed_networks(&self, run: &Run) -> Result<Outcome, CheckError> {
        const PART: &str = "tau_1 against the bound, directed networks";
        let mut cases = 0;
        for (n, length, window) in [(2, 6, 1), (2, 6, 2), (2, 6, 3), (3, run.cases(2, 3), 1)] {
            let factors = directed_networks(n)?;
            let start = Product::empty(n)?;
            if let Some(what) = self.search(&factors, (&start, length), Windows::Of(window), (&mut cases, run))? {
                return Ok(failure(PART, what));
            }
        }
        let detail = "all sequences of directed networks on 2 and 3 birds, equal weights";
        holds(exhaustive(PART, detail).on([2]).cases(cases))
    }

    /// Long sequences: in the last step of a window the birds 1 and 3 nearly lose each other; random ones.
    fn sampled(&self, run: &Run) -> Result<Outcome, CheckError> {
        const PART: &str = "tau_1 against the bound, random sequences";
        let mut cases = 0;
        let arc = |i: usize, j: usize| Factor::directed(3, move |a, b| (a, b) == (i, j));
        let (third, first, second) = (arc(2, 0)?, arc(0, 1)?, arc(1, 2)?);
        for length in 2..=8 {
            let again = std::iter::repeat_n(&first, length - 1);
            let word: Vec<&Factor> = [&third].into_iter().chain(again.clone()).chain(again).chain([&second]).collect();
            if let Some(what) = self.follow(&word, Windows::Of(length), &mut cases)? {
                return Ok(failure(PART, what));
            }
        }
        let mut random = run.random(0);
        // As many cases for every seed: how many a sequence holds depends on what is drawn.
        let wanted = run.cases(1900, 19_000);
        for case in 0..wanted {
            if cases >= wanted {
                break;
            }
            run.checkpoint()?;
            let (n, window) = (3 + case % 3, 1 + case % 4);
            let mut bits = || random.next_u32() as usize;
            let mut word = Vec::new();
            for _ in 0..2 * (n - 1) * window {
                let chosen = bits() & bits();
                word.push(if case % 2 == 0 {
                    let graph = Graph::from_fn(n, |i, j| chosen >> (i * n + j) & 1 == 1);
                    Factor::network(&graph, &if bits() % 2 == 0 { Weights::Lazy } else { Weights::Vicsek })?
                } else {
                    Factor::directed(n, |i, j| chosen >> (i * n + j) & 1 == 1)?
                });
            }
            let windows = if case % 2 == 0 { Windows::Any } else { Windows::Of(window) };
            if let Some(what) = self.follow(&word.iter().collect::<Vec<_>>(), windows, &mut cases)? {
                return Ok(failure(PART, what));
            }
        }
        let detail = "random sequences of networks on 3 to 5 birds; cases are products whose bound is below 1";
        holds(fuzzed(PART, detail).on([1, 2]).cases(cases.min(wanted)))
    }
}

fn failure(part: &str, what: String) -> Outcome {
    Outcome::fails(what, exact(part, "exact product"))
}

pub fn recurrent() -> Record<RecurrentVariant> {
    let printed = RecurrentVariant {
        connected: true,
        to_the_heard: true,
        keeps_own: true,
        windows: |n| n - 1,
        network_power: |n| n - 1,
        directed_power: |n, length| (n - 1) * length,
    };
    Record::new(
        "beyond.chazelle.recurrent",
        "Follow backwards in time the birds that two birds have listened to. While the two sets are disjoint, in \
         every window one of them grows: else both would be closed and both would hold a root. After n - 1 windows \
         they meet, and the two rows overlap by a positive entry of the product, which is at least alpha^((n-1)B), \
         and for networks at least alpha^(n-1) however long the windows are, because a closed set of birds keeps its \
         smallest entry. tau_1 <= 1 - overlap, and tau_1 of a product is at most the product of tau_1. Later \
         velocities are averages of earlier ones, so the bounds give one Cauchy sequence \
         (proofs_checks/coq/chazelle_recurrent.v, chazelle_agreement.v, chazelle_reals.v).",
        printed,
        |variant, run| Run::all([variant.on_networks(run), variant.on_directed_networks(run), variant.sampled(run)]),
    )
    .stated("extends chazelle, section 3, to networks that change", "")
    .clauses(&[
        "Let P(1), P(2), ... be matrices of model D, P(t) = I - C(t) L(t) with L(t) the Laplacian of the network at time t and C(t) the \
         diagonal matrix of the c_i(t), 0 < c_i(t) d_i(t) < 1 where bird i has d_i(t) > 0 neighbours, for n >= 2 birds, with positive \
         entries at least alpha > 0, and v(t+1) = P(t) v(t): after m consecutive windows of any lengths, in each of which the union of the \
         networks is connected, the differences of velocities are at most (1 - alpha^(n-1))^floor(m/(n-1)) times the largest at their \
         start, in any norm.",
        "Let P(1), P(2), ... be any stochastic matrices of n >= 2 birds with positive diagonals and positive entries at least alpha > 0 \
         (directed networks, with an arc from i to j where p_ij > 0: bird i hears bird j) and B >= 1: if in the union over every B \
         consecutive times a path leads from every bird to one bird, t factors contract by tau_1 <= (1 - alpha^((n-1)B))^floor(t/((n-1)B)), \
         where tau_1 of a matrix is half the largest distance of two of its rows in the 1-norm.",
        "Matrices of model D as in the first sentence: if there are infinitely many such windows, one after another, all velocities converge to one limit.",
        "Stochastic matrices as in the second sentence, every B consecutive times with such a union, and v(t+1) = P(t) \
         v(t): the velocities converge to one limit, at the rate of the bound.",
    ])
    .altered("windows that are not connected", |v| v.connected = false)
    .altered("arcs from the bird that is heard: two birds that hear nobody, heard by the third", |v| v.to_the_heard = false)
    .altered("no weight for the bird itself", |v| v.keeps_own = false)
    .altered("a factor for every window", |v| v.windows = |_| 1)
    .altered("alpha^(n-2)", |v| v.network_power = |n| n - 2)
    .altered("alpha^(n-1) on directed networks, however long the windows", |v| v.directed_power = |n, _| n - 1)
}
