//! chazelle.lem2.1 and chazelle.eq2.3: changes of distances, and lengths of velocities.

use crate::prelude::*;
use algebra::graph::Graph;
use arithmetic::{Sign, sign_of_surd, words};
use models::averaging::{Weights, averaged, random_network, transition_matrix};
use rand_chacha::rand_core::Rng;

#[derive(Clone, Copy)]
pub struct DistanceChangeVariant {
    /// A factor of the right side, squared.
    squared_factor: (i64, i64),
    /// The Euclidean norm, or the largest coordinate.
    euclidean: bool,
    /// Strictly less.
    strict: bool,
}

impl DistanceChangeVariant {
    /// Whether `| |r + w| - |r| | <= |w|` (or what is claimed instead) for integer vectors.
    fn holds(&self, r: &[i64], w: &[i64]) -> bool {
        let squared = |x: &mut dyn Iterator<Item = i64>| rational(x.map(|x| x * x).sum(), 1);
        let after = squared(&mut r.iter().zip(w).map(|(a, b)| a + b));
        let before = squared(&mut r.iter().copied());
        let size = if self.euclidean {
            squared(&mut w.iter().copied())
        } else {
            squared(&mut w.iter().map(|x| x.abs()).max().into_iter())
        };
        let bound = size * rational(self.squared_factor.0, self.squared_factor.1);
        // sqrt(A) <= sqrt(B) + sqrt(W) exactly when B + W - A + 2 sqrt(BW) >= 0, both ways.
        [(&after, &before), (&before, &after)].into_iter().all(|(a, b)| {
            let slack = b.clone() + &bound - a;
            match sign_of_surd(&slack, &rational(2, 1), &(b.clone() * &bound)) {
                Some(Sign::Positive) => true,
                Some(Sign::Zero) => !self.strict,
                _ => false,
            }
        })
    }
}

pub fn distance_change() -> Record<DistanceChangeVariant> {
    Record::new(
        "chazelle.lem2.1",
        "With r = x_i(t-1) - x_j(t-1) and w = v_i(t) - v_j(t): x_i(t) - x_j(t) = r + w, and | |r + w| - |r| | <= |w| \
         is the triangle inequality, twice, in any dimension. Equality where w is a multiple m r with m >= -1, or r = \
         0 or r + w = 0.",
        DistanceChangeVariant { squared_factor: (1, 1), euclidean: true, strict: false },
        check_distance_change,
    )
    .altered("a factor 0.99", |v| v.squared_factor = (9801, 10000))
    .altered("the largest coordinate", |v| v.euclidean = false)
    .altered("strictly less", |v| v.strict = true)
}

/// 0, 1, -1, 2, -2, ... for 0, 1, 2, 3, 4, ...
fn from_zero_outward(k: &usize) -> i64 {
    let half = k.div_ceil(2) as i64;
    if k % 2 == 1 { half } else { -half }
}

fn check_distance_change(variant: &DistanceChangeVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let cases = [(1usize, 6i64), (2, 3), (3, 1)].into_iter().flat_map(|(d, size)| {
        words((2 * size + 1) as usize, 2 * d)
            .map(move |word| (d, word.iter().map(from_zero_outward).collect::<Vec<_>>()))
    });
    let detail =
        "the triangle inequality (notes/chazelle_switches.md); all integer vectors up to 6, 3, 1 in dimension 1, 2, 3";
    run.every(exhaustive("the bound, in any dimension", detail), cases, |(d, numbers)| {
        let (r, w) = numbers.split_at(d);
        let what = || format!("x_i(t-1) - x_j(t-1) = {r:?}, v_i(t) - v_j(t) = {w:?}");
        Ok((!variant.holds(r, w)).then(what))
    })
}

#[derive(Clone, Copy)]
pub enum VelocityNormVariant {
    /// A multiple of `sqrt(n)` times the largest speed at the start, squared.
    LargestSpeed(i64, i64),
    /// The largest speed at the start, without `sqrt(n)`.
    WithoutRoot,
    /// The norm at the start.
    NormAtStart,
}

pub fn velocity_norm() -> Record<VelocityNormVariant> {
    Record::new(
        "chazelle.eq2.3",
        "Reading: coordinates of v(1) are at most n^b in absolute value (O(log n) bits), d is fixed. Each v_i(t+1) is \
         a convex combination of the v_j(t), so |v_i(t)| <= max_j |v_j(1)| <= sqrt(d) n^b and ||v(t)||_2 <= sqrt(n) \
         max_j |v_j(1)| <= sqrt(d) n^(b + 1/2). The constant sqrt(n) is attained by equal velocities. ||v(t)||_2 <= \
         ||v(1)||_2 would be false: P can stretch.",
        VelocityNormVariant::LargestSpeed(1, 1),
        check_velocity_norm,
    )
    .control("0.995 sqrt(n)", VelocityNormVariant::LargestSpeed(99, 100))
    .control("without sqrt(n)", VelocityNormVariant::WithoutRoot)
    .control("||v(t)|| <= ||v(1)||", VelocityNormVariant::NormAtStart)
}

fn check_velocity_norm(variant: &VelocityNormVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let start = |word: Vec<usize>| word.iter().map(|&k| vec![rational(k as i64 - 1, 1)]).collect();
    let all = (1..=4usize).flat_map(Graph::all);
    let steps = all.flat_map(|graph| words(3, graph.order()).map(move |word| (graph.clone(), word)));
    let mut random = run.random(0);
    let flocks = (0..run.cases(80, 2000)).map(|case| {
        let (n, d) = (1 + case % 5, 1 + case / 5 % 3);
        let mut number = || rational(i64::from(random.next_u32() % 17) - 8, 4);
        let velocities = (0..n).map(|_| (0..d).map(|_| number()).collect()).collect();
        (velocities, (0..5).map(|_| random_network(n, 2, &mut random)).collect::<Vec<Graph>>())
    });
    let part = "||v(t)||_2 <= sqrt(n) max |v_j(1)|, for all sequences of networks";
    let detail = "one step of all networks on up to 4 birds, velocities -1, 0, 1 (equal ones attain it)";
    let sampled = fuzzed("the same", "exact runs of 1 to 5 birds in dimension 1 to 3");
    Run::all([
        run.every(exhaustive(part, detail), steps, |(graph, word)| {
            variant.fails_at(start(word), &[graph], &Weights::Lazy)
        }),
        run.every(sampled, flocks, |(velocities, graphs)| variant.fails_at(velocities, &graphs, &Weights::Vicsek)),
    ])
}

impl VelocityNormVariant {
    /// Where `v(1), v(2), ...` exceeds the bound for these networks, if anywhere.
    fn fails_at(
        &self,
        start: Vec<Vec<Rational>>,
        graphs: &[Graph],
        weights: &Weights,
    ) -> Result<Option<String>, CheckError> {
        let (n, d) = (start.len(), start[0].len());
        let speed_squared = |v: &Vec<Rational>| v.iter().map(Ring::square).sum::<Rational>();
        let total = |v: &[Vec<Rational>]| v.iter().map(speed_squared).sum::<Rational>();
        let largest = start.iter().map(speed_squared).max().unwrap_or_else(|| rational(0, 1));
        let bound = match *self {
            VelocityNormVariant::LargestSpeed(p, q) => largest * rational(n as i64 * p, q),
            VelocityNormVariant::WithoutRoot => largest,
            VelocityNormVariant::NormAtStart => total(&start),
        };
        let mut velocities = start;
        for t in 1..=graphs.len() + 1 {
            let norm = total(&velocities);
            if norm > bound {
                return Ok(Some(format!(
                    "{n} birds, d = {d}, t = {t}: ||v(t)||_2 squared is {norm}, the bound is {bound}"
                )));
            }
            let Some(graph) = graphs.get(t - 1) else { break };
            velocities = averaged(&transition_matrix(graph, weights)?, &velocities)?;
        }
        Ok(None)
    }
}
