//! chazelle.lem2.2.entries, and beyond.chazelle.entries: how small the nonzero entries of products get.

use super::sequences::{seen_from_one_side, show_all};
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::{RationalMatrix, StochasticMatrix, prefix_products, product_sequential, smallest_entries};
use arithmetic::words;
use models::averaging::{Weights, random_network, transition_matrix};
use num_bigint::BigInt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// A bound from below for the nonzero entries of all products.
#[derive(Clone, Copy)]
pub enum Floor {
    /// `(n^-a)^e(n)`, where `n^-a` bounds the positive entries of the factors: `a = 1` for `vicsek`, 2 for the rest.
    Power(fn(u32) -> u32),
    /// This multiple of the smallest entry that occurs: `1/n!` for `vicsek`, `2^(n-2)/(3^(n-1) (n-1)!)` for `lazy`.
    Smallest(i64, i64),
}

/// A statement about the entries of products.
#[derive(Clone, Copy)]
pub struct EntriesVariant {
    pub floor: Floor,
    /// Whether the bound is claimed to be attained.
    pub attained: bool,
    /// `c_i d_i` for all birds with neighbours, instead of the two models.
    pub share: Option<(i64, i64)>,
    /// Whether edges are seen from one side only.
    pub one_sided: bool,
}

impl EntriesVariant {
    pub const PRINTED: Self =
        EntriesVariant { floor: Floor::Power(|n| n * n), attained: false, share: None, one_sided: false };
    pub const SHARP: Self = EntriesVariant { floor: Floor::Smallest(1, 1), attained: true, ..Self::PRINTED };

    fn models(&self) -> &'static [Model] {
        if self.share.is_some() { &[Model::Lazy] } else { &[Model::Lazy, Model::Vicsek] }
    }

    fn matrix(&self, model: Model, graph: &Graph) -> Result<RationalMatrix, CheckError> {
        let weights = match (self.share, model) {
            (Some((p, q)), _) => Weights::of_share(graph, &rational(p, q)),
            (None, Model::Lazy) => Weights::Lazy,
            (None, Model::Vicsek) => Weights::Vicsek,
        };
        let matrix = transition_matrix(graph, &weights)?;
        if self.one_sided { seen_from_one_side(&matrix) } else { Ok(matrix) }
    }

    fn floor(&self, model: Model, order: usize) -> Rational {
        let n = order as i64;
        match (self.floor, model) {
            (Floor::Power(exponent), _) => {
                let base = n.pow(if matches!(model, Model::Vicsek) { 1 } else { 2 });
                rational(1, base).pow(exponent(order as u32) as i32)
            }
            _ if n == 1 => rational(1, 1),
            (Floor::Smallest(p, q), Model::Vicsek) => rational(p, q) / factorial(n),
            (Floor::Smallest(p, q), Model::Lazy) => {
                rational(p, q) * rational(2, 1).pow(n as i32 - 2)
                    / (rational(3, 1).pow(n as i32 - 1) * factorial(n - 1))
            }
        }
    }
}

#[derive(Clone, Copy)]
enum Model {
    Lazy,
    Vicsek,
}

impl Model {
    fn name(self) -> &'static str {
        match self {
            Model::Lazy => "lazy",
            Model::Vicsek => "vicsek",
        }
    }
}

fn factorial(n: i64) -> Rational {
    Rational::from_integer((1..=n).map(BigInt::from).product())
}

/// The sequence that attains the bound: at step `k` bird `k` (from 0) is joined to bird `k - 1`, which has the smallest
/// entry so far, and to all birds that the column has not reached.
fn extremal_sequence(order: usize) -> Vec<Graph> {
    (1..order).map(|k| Graph::from_fn(order, |i, j| (i, j) == (k - 1, k) || (i == k && j > k))).collect()
}

/// What is wrong where an entry of the product of these networks is below the bound.
fn below(model: Model, graphs: &[Graph], entry: &Rational, floor: &Rational) -> Option<String> {
    let (name, order) = (model.name(), graphs[0].order());
    let what = || format!("{name}, {order} birds, {}: a nonzero entry is {entry}, below {floor}", show_all(graphs));
    (entry < floor).then(what)
}

fn factors(
    graphs: &[Graph],
    matrix: impl FnMut(&Graph) -> Result<RationalMatrix, CheckError>,
) -> Result<Vec<StochasticMatrix>, CheckError> {
    graphs.iter().map(matrix).map(|m| Ok(StochasticMatrix::try_from(&m?)?)).collect()
}

/// Decides a bound for the nonzero entries.
pub fn examine_entries(variant: &EntriesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // What is printed is less than what is proved.
    let beside = |outcome: Result<Outcome, CheckError>| match variant.attained {
        true => outcome.checks("the conclusion"),
        false => outcome,
    };
    Run::all([
        beside(all_products(variant, run)),
        beside(long_products(variant, run)),
        attained(variant, run),
        given_weights(variant, run),
    ])
}

fn all_products(variant: &EntriesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    for (order, length) in [(1, 3), (2, 6), (3, 5), (4, run.cases(3, 4))] {
        let graphs: Vec<Graph> = Graph::all(order).collect();
        for &model in variant.models() {
            run.checkpoint()?;
            let matrices: Vec<RationalMatrix> =
                graphs.iter().map(|g| variant.matrix(model, g)).collect::<Result<_, _>>()?;
            // All graphs are among the factors, so the first column stands for every column.
            let (entries, count) = smallest_entries(&matrices, length)?;
            cases += count;
            let floor = variant.floor(model, order);
            let mut least = rational(1, 1);
            for smallest in entries {
                let Some(entry) = smallest.entry else { continue };
                let sequence: Vec<Graph> = smallest.factors.iter().map(|&k| graphs[k].clone()).collect();
                if let Some(what) = below(model, &sequence, &entry, &floor) {
                    return Ok(Outcome::fails(what, exact("the bound", "one exact product")));
                }
                least = least.min(entry);
            }
            run.value(&format!("smallest_entry_{}_{order}", model.name()), least.to_string());
        }
    }
    let detail = "all products of up to 6, 5, 3 factors (4 with --full) on 2, 3, 4 birds, lazy and vicsek";
    holds(exhaustive("the bound", detail).on([1]).cases(cases))
}

/// Products of 64 factors that alternate between two networks on three birds.
fn long_products(variant: &EntriesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const LENGTH: usize = 64;
    let graphs: Vec<Graph> = Graph::all(3).collect();
    let mut cases = 0;
    for &model in variant.models() {
        let floor = variant.floor(model, 3);
        let matrices = factors(&graphs, |graph| variant.matrix(model, graph))?;
        for pair in words(graphs.len(), 2) {
            run.checkpoint()?;
            let factors: Vec<StochasticMatrix> = (0..LENGTH).map(|t| matrices[pair[t % 2]].clone()).collect();
            for (t, product) in prefix_products(&factors).enumerate() {
                cases += 1;
                let entry = product?.to_rational_matrix().least_positive().unwrap_or_default();
                let sequence: Vec<Graph> = (0..=t).map(|t| graphs[pair[t % 2]].clone()).collect();
                if let Some(what) = below(model, &sequence, &entry, &floor) {
                    return Ok(Outcome::fails(what, exact("independence of t", "one exact product")));
                }
            }
        }
    }
    let detail = "products of up to 64 factors that alternate between any two networks on 3 birds";
    holds(exact("independence of t", detail).on([1]).cases(cases))
}

fn attained(variant: &EntriesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const LARGEST: usize = 9;
    if !variant.attained {
        return Ok(Outcome::Holds(Vec::new()));
    }
    let cases = (2..=LARGEST).flat_map(|order| variant.models().iter().map(move |&model| (order, model)));
    let place = "notes/chazelle_switches.md, Smallest entries, steps 1-5";
    for (order, model) in cases {
        run.checkpoint()?;
        let factors = factors(&extremal_sequence(order), |graph| variant.matrix(model, graph))?;
        let entry = product_sequential(&factors)?.to_rational_matrix().least_positive().unwrap_or_default();
        let floor = variant.floor(model, order);
        if entry != floor {
            let what = format!("{}, {order} birds: the smallest entry is {entry}, not {floor}", model.name());
            return Ok(Outcome::fails(what, exact("the bound is attained", "the extremal sequence")));
        }
    }
    let evidence = exact("the bound is attained", "a product of n - 1 factors for n = 2, ..., 9").on([2]);
    Run::all([
        holds(evidence.cases(LARGEST - 1)).checks("step 5, and the values of step 4"),
        argued(&[1, 2], "the smallest entries, for all n and all products", place),
    ])
}

/// Random rational weights `p/n²`, so that all positive entries of the factors are at least `n^-2`.
fn given_weights(variant: &EntriesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    if !matches!(variant.floor, Floor::Power(_)) || variant.share.is_some() {
        return Ok(Outcome::Holds(Vec::new()));
    }
    let mut random = run.random(0);
    let evidence = fuzzed("any weights of O(log n) bits", "random c_i(t) = p/n^2, up to 5 birds, 10 factors");
    run.every(evidence, 0..run.cases(60, 1000), |_| {
        let order = 2 + random.next_u32() as usize % 4;
        let graphs: Vec<Graph> = (0..10).map(|_| random_network(order, 1, &mut random)).collect();
        let factors = factors(&graphs, |g| Ok(transition_matrix(g, &small_weights(g, 2, &mut random))?))?;
        let floor = variant.floor(Model::Lazy, order);
        for product in prefix_products(&factors) {
            let entry = product?.to_rational_matrix().least_positive().unwrap_or_default();
            if let Some(what) = below(Model::Lazy, &graphs, &entry, &floor) {
                return Ok(Some(what));
            }
        }
        Ok(None)
    })
}

/// Random admissible weights `p/n^a`.
pub(super) fn small_weights(graph: &Graph, a: u32, random: &mut ChaCha8Rng) -> Weights {
    let denominator = (graph.order() as i64).pow(a);
    let weight = |i: usize, random: &mut ChaCha8Rng| {
        // c_i d_i < 1 for all choices below.
        let most = ((denominator - 1) / (graph.degree(i) as i64).max(1)).max(1);
        let p = if random.next_u32().is_multiple_of(2) { 1 } else { 1 + i64::from(random.next_u32()) % most };
        rational(p, denominator)
    };
    Weights::Given((0..graph.order()).map(|i| weight(i, random)).collect())
}

pub fn entries() -> Record<EntriesVariant> {
    Record::new(
        "chazelle.lem2.2.entries",
        "Follow one column of P(t,s) and its support S. While S does not grow, symmetry keeps all neighbours of S in \
         S, and the rows of S average entries of S: the smallest does not drop. When S grows, it drops by a factor \
         n^-a at worst. S grows at most n - 1 times: every nonzero entry is at least n^(-a(n-1)), which is more than \
         printed (beyond.chazelle.entries, notes/chazelle_switches.md).",
        EntriesVariant::PRINTED,
        examine_entries,
    )
    .reading(
        "At least n^(-b n²), for c_i(t) of O(log n) bits, so that positive entries of every P(t) are at least n^-a (a \
         = 1 for vicsek, 2 for lazy); b = a will do.",
    )
    .altered("the bound of a single factor", |v| v.floor = Floor::Power(|_| 1))
    .altered("exponent n - 2", |v| v.floor = Floor::Power(|n| n.saturating_sub(2)))
    .altered("c_i d_i = 1", |v| v.share = Some((1, 1)))
    .altered("edges seen from one side", |v| v.one_sided = true)
}
