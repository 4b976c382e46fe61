//! chazelle.lem2.2.bits and chazelle.lem2.3: how long the numbers get.

use super::sequences::show_all;
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use arithmetic::{common_denominator, words};
use models::averaging::{Weights, averaged, random_network, transition_matrix};
use num_bigint::BigInt;
use num_traits::Signed;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// The matrices of a network with the `a` for which the `c_i` have denominators up to `n^a`.
fn models(graph: &Graph) -> Result<Vec<(u32, RationalMatrix)>, CheckError> {
    let heavy = heavy_weights(graph.order()).filter(|weights| weights.are_admissible(graph));
    let all = [(2, Weights::Lazy), (1, Weights::Vicsek)].into_iter().chain(heavy.map(|weights| (2, weights)));
    all.map(|(a, weights)| Ok((a, transition_matrix(graph, &weights)?.reduced()))).collect()
}

/// `c_i = 1/q_i` with different primes `q_i <= n²`: the longest common denominators.
fn heavy_weights(order: usize) -> Option<Weights> {
    let square = (order * order) as i64;
    let primes: Vec<i64> = (2..=square).rev().filter(|q| (2..*q).all(|r| q % r != 0)).take(order).collect();
    (primes.len() == order).then(|| Weights::Given(primes.into_iter().map(|q| rational(1, q)).collect()))
}

fn power(n: usize, exponent: u64) -> BigInt {
    BigInt::from(n).pow(exponent as u32)
}

/// The exponent of `n` in the bound of the common denominator.
#[derive(Clone, Copy)]
pub struct ProductLengthVariant {
    /// From `n`, `t - s + 1` and `a`.
    exponent: fn(u64, u64, u64) -> u64,
}

impl ProductLengthVariant {
    fn fails_at(&self, graphs: &[Graph], model: usize) -> Result<Option<String>, CheckError> {
        let (n, length) = (graphs[0].order(), graphs.len() as u64);
        let (mut product, mut a) = (RationalMatrix::identity(n)?, 2);
        for graph in graphs {
            // Where given weights are not admissible for a network, the lazy ones stand in.
            let all = models(graph)?;
            let (given, matrix) = all.get(model).unwrap_or(&all[0]);
            (product, a) = (matrix.times(&product)?, *given);
        }
        let bound = power(n, (self.exponent)(n as u64, length, u64::from(a)));
        let denominator = product.reduced().denominator().clone();
        let all = || show_all(graphs);
        let what = || {
            format!("{n} birds, a = {a}, {}: the least common denominator is {denominator}, more than {bound}", all())
        };
        Ok((denominator > bound).then(what))
    }
}

pub fn product_length() -> Record<ProductLengthVariant> {
    Record::new(
        "chazelle.lem2.2.bits",
        "Reading: c_i(t) is a rational with a denominator q_i <= n^a (O(log n) bits; a = 1 for vicsek, 2 for lazy), n \
         >= 2. Row i of P(t) has the denominator q_i, all of P(t) the product of the q_i, at most n^(a n). A product \
         of t - s + 1 factors has the product of their denominators: at most n^(a n (t-s+1)), which is a n (t-s+1) \
         log n bits; entries lie in [0,1], so numerators are no longer.",
        ProductLengthVariant { exponent: |n, length, a| a * n * length },
        check_product_length,
    )
    .altered("without n", |v| v.exponent = |_, length, a| a * length)
    .altered("without t - s + 1", |v| v.exponent = |n, _, a| a * n)
    .altered("two thirds of the length", |v| v.exponent = |n, length, a| 2 * a * n * length / 3)
}

fn check_product_length(variant: &ProductLengthVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let all = [(1, 3), (2, 5), (3, 3), (4, 1)].into_iter().flat_map(|(order, length)| {
        let graphs: Vec<Graph> = Graph::all(order).collect();
        let models = if heavy_weights(order).is_some() { 3 } else { 2 };
        words(graphs.len(), length).flat_map(move |word| {
            let sequence: Vec<Graph> = word.iter().map(|&k| graphs[k].clone()).collect();
            (0..models).map(move |model| (sequence.clone(), model))
        })
    });
    let mut random = run.random(0);
    let detail = "all products of 5, 3, 1 factors on 2, 3, 4 birds: lazy, vicsek, prime denominators";
    Run::all([
        run.every(exhaustive("at most a n (t-s+1) log n bits", detail), all, |(graphs, model)| {
            variant.fails_at(&graphs, model)
        }),
        run.every(fuzzed("the same", "six random networks on 5 to 7 birds"), 0..run.cases(20, 400), |_| {
            let order = 5 + random.next_u32() as usize % 3;
            let graphs: Vec<Graph> = (0..6).map(|_| random_network(order, 3, &mut random)).collect();
            (0..3).find_map(|model| variant.fails_at(&graphs, model).transpose()).transpose()
        }),
    ])
}

/// The exponent of `n` in the bound of numerators and denominators.
#[derive(Clone, Copy)]
pub struct StateLengthVariant {
    /// From `n`, `t` and the constant `a + 2bd + b + 1`.
    exponent: fn(u64, u64, u64) -> u64,
}

/// The common denominator of all coordinates, or the largest numerator over it, whichever is longer.
fn longest<'a>(coordinates: impl Iterator<Item = &'a Rational> + Clone) -> BigInt {
    let denominator = common_denominator(coordinates.clone());
    let numerator = coordinates.map(|x| (x.numer() * (&denominator / x.denom())).abs()).max().unwrap_or_default();
    denominator.max(numerator)
}

type Vectors = Vec<Vec<Rational>>;

impl StateLengthVariant {
    /// Runs a flock with `a = 2`, `b = 1` whose networks are given.
    fn fails_at(
        &self,
        mut positions: Vectors,
        mut velocities: Vectors,
        weights: &Weights,
        graphs: &[Graph],
    ) -> Result<Option<String>, CheckError> {
        let (n, d) = (positions.len(), positions[0].len());
        let (a, b) = (2, 1);
        let constant = a + 2 * b * d as u64 + b + 1;
        for (t, graph) in (1..).zip(graphs) {
            for (x, v) in positions.iter_mut().flatten().zip(velocities.iter().flatten()) {
                *x += v;
            }
            let bound = power(n, (self.exponent)(n as u64, t, constant));
            for (name, state) in [("x", &positions), ("v", &velocities)] {
                let length = longest(state.iter().flatten());
                if length > bound {
                    let bits = (length.bits(), bound.bits());
                    return Ok(Some(format!(
                        "{n} birds, d = {d}: {name}({t}) needs {} bits, more than {}",
                        bits.0, bits.1
                    )));
                }
            }
            velocities = averaged(&transition_matrix(graph, weights)?, &velocities)?;
        }
        Ok(None)
    }

    /// A random flock of 16 steps with the longest denominators, or `lazy` where there are none.
    fn fails_at_random(&self, n: usize, d: usize, random: &mut ChaCha8Rng) -> Result<Option<String>, CheckError> {
        let input = |random: &mut ChaCha8Rng| -> Vectors {
            let mut below = |k: usize| (random.next_u32() as usize % k) as i64;
            let mut coordinate = || rational(below(2 * n + 1) - n as i64, 1 + below(n));
            (0..n).map(|_| (0..d).map(|_| coordinate()).collect()).collect()
        };
        let (positions, velocities) = (input(random), input(random));
        let weights = heavy_weights(n).filter(|w| w.are_admissible(&Graph::complete(n)));
        let graphs: Vec<Graph> = (0..16).map(|_| random_network(n, 3, random)).collect();
        self.fails_at(positions, velocities, &weights.unwrap_or(Weights::Lazy), &graphs)
    }
}

/// All flocks of two birds on the line with these coordinates, given over 2, and all networks of four steps.
fn pairs_on_the_line(halves: &[i64]) -> impl Iterator<Item = (Vectors, Vectors, Vec<Graph>)> {
    let numbers: Vec<Rational> = halves.iter().map(|&x| rational(x, 2)).collect();
    let graphs: Vec<Graph> = Graph::all(2).collect();
    words(numbers.len(), 4).flat_map(move |input| {
        let of = |k: usize| vec![numbers[input[k]].clone()];
        let (positions, velocities) = (vec![of(0), of(1)], vec![of(2), of(3)]);
        let graphs = graphs.clone();
        words(2, 4)
            .map(move |word| (positions.clone(), velocities.clone(), word.iter().map(|&k| graphs[k].clone()).collect()))
    })
}

pub fn state_length() -> Record<StateLengthVariant> {
    Record::new(
        "chazelle.lem2.3",
        "Reading: input coordinates have numerators and denominators up to n^b, c_i(t) denominators up to n^a, n >= \
         2, d fixed. The 2dn inputs have a common denominator Q <= n^(2bdn); v(t) = (P(t-1,1) kron I_d) v(1) and x(t) \
         = x(0) + v(1) + ... + v(t) have the denominator Q n^(an(t-1)) at most, and coordinates up to n^b (t+1) <= \
         n^(b+t). Both numerators and denominators are at most n^(Ktn), K = a + 2bd + b + 1: K t n log n bits.",
        StateLengthVariant { exponent: |n, t, constant| constant * t * n },
        check_state_length,
    )
    .altered("without t", |v| v.exponent = |n, _, constant| constant * n)
    .altered("without n", |v| v.exponent = |_, t, constant| constant * t)
    .altered("two ninths of the length", |v| v.exponent = |n, t, constant| 2 * constant * t * n / 9)
}

fn check_state_length(variant: &StateLengthVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let halves: &[i64] = if run.cases(0, 1) == 0 { &[-4, -1, 1, 2] } else { &[-4, -2, -1, 0, 1, 2, 4] };
    let mut random = run.random(0);
    let repeats = run.cases(2, 40);
    let sizes = (2..=6).flat_map(|n| (1..=3).flat_map(move |d| (0..repeats).map(move |_| (n, d))));
    let part = "numerators and denominators up to n^(Ktn), K = a + 2bd + b + 1";
    let detail =
        "all lazy pairs on the line with inputs -2, -1/2, 1/2, 1 (--full: all up to 2) and all networks of 4 steps";
    let sampled = fuzzed("the same", "exact runs of 16 steps, 2 to 6 birds in dimension 1 to 3, a = 2, b = 1");
    Run::all([
        run.every(exhaustive(part, detail), pairs_on_the_line(halves), |(positions, velocities, graphs)| {
            variant.fails_at(positions, velocities, &Weights::Lazy, &graphs)
        }),
        run.every(sampled, sizes, |(n, d)| variant.fails_at_random(n, d, &mut random)),
    ])
}
