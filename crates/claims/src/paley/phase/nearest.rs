//! paley.scale, paley.scale.complete, paley.fishpeak: the potential of the fish on the graph of nearest neighbours.

use super::common::{identities, laplacian, supports};
use crate::prelude::*;
use algebra::graph::WeightedGraph;
use algebra::matrix::SparseMatrix;
use models::oscillator::{Interaction, Neighbours, mean, on_the_line, phase_potential, phasors, up_to_rotation};
use rand_chacha::rand_core::Rng;

type Point = (i64, i64);

/// The network in which everyone has the nearest `n` as neighbours, or `None` where a tie leaves open who they are.
fn nearest_network(points: &[Point], n: usize) -> Option<Neighbours> {
    let place = |&(x, y): &Point| Complex::new(rational(x, 1), rational(y, 1));
    Neighbours::nearest_without_ties(&points.iter().map(place).collect::<Vec<_>>(), n)
}

/// Whether a scale is claimed to do for `n` neighbours of `N` fish.
type Applies = fn(n: usize, fish: usize) -> bool;

/// A scale for the potential, given `n` and `N`.
type ScaleOf = fn(n: i64, fish: i64) -> Rational;

/// The factor with the parentheses as in Figure S3.
fn figure_scale(n: i64, _: i64) -> Rational {
    rational(2, n + 1)
}

/// The factor as printed in the text, `2/n + 1`.
fn text_scale(n: i64, _: i64) -> Rational {
    rational(n + 2, n)
}

/// For which `n` of `N` which scale is claimed to bring the potential into [0, 1].
#[derive(Clone)]
pub struct ScaleVariant(Vec<(Applies, ScaleOf)>);

impl ScaleVariant {
    fn fails_at(
        &self,
        network: &impl Interaction,
        n: usize,
        z: &[Complex<Rational>],
    ) -> Result<Option<String>, CheckError> {
        let potential = phase_potential(network, z, 1)?;
        let fish = z.len();
        for (_, scale) in self.0.iter().filter(|(applies, _)| applies(n, fish)) {
            let scaled = scale(n as i64, fish as i64) * &potential;
            if scaled < rational(0, 1) || scaled > rational(1, 1) {
                let phases: Vec<String> = z.iter().map(|z| format!("({}, {})", z.re, z.im)).collect();
                return Ok(Some(format!(
                    "N = {fish}, n = {n}, velocities {}: scaled W_1 = {scaled}",
                    phases.join(" ")
                )));
            }
        }
        Ok(None)
    }
}

impl ScaleVariant {
    /// `W_1` of alternating directions around a square, with the first scale.
    fn on_the_square(&self) -> Result<Outcome, CheckError> {
        let network =
            nearest_network(&SQUARE, 2).ok_or_else(|| CheckError::Other("a tie on the square".to_string()))?;
        let z: Vec<_> = [1, -1, 1, -1].map(|sign| Complex::real(rational(sign, 1))).into();
        let scale = self.0.first().map_or(rational(1, 1), |(_, scale)| scale(2, 4));
        let scaled = phase_potential(&network, &z, 1)? * scale;
        let what = || format!("the scaled potential on the square is {scaled}");
        unless((scaled != rational(4, 3)).then(what), exact("the square", "exact value").on([3])).for_all()
    }
}

/// All arrangements with phases 0 and pi.
fn signs(fish: usize) -> impl Iterator<Item = Vec<Complex<Rational>>> {
    let number = |sign: &usize| Complex::real(rational(1 - 2 * *sign as i64, 1));
    up_to_rotation(fish, 2).map(move |signs| signs.iter().map(number).collect())
}

/// Corners of a square, each with its two neighbours nearer than the opposite one.
const SQUARE: [Point; 4] = [(0, 0), (1, 0), (1, 1), (0, 1)];
/// Two rows of three: opposite to all in the other row and column, 14 of 18 arcs to the three nearest count.
const ROWS: [Point; 6] = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1)];

pub fn scale() -> Record<ScaleVariant> {
    Record::new(
        "paley.scale",
        "W_1 = (1/(2N)) sum over arcs of 1 - cos theta_kj <= n, with nN arcs, so 2 W_1/(n+1) <= 2n/(n+1), which can be reached: four fish at the corners of \
         a square, n = 2, each opposite to both neighbours, give 4/3. For n = 1 the bound is 1, and for n = N - 1 it is 1 - |p|^2 <= 1; N = 4, n = 2 is the \
         smallest case that is neither. W_1/n lies in [0, 1] for all n. The factor of the text, 2/n + 1, fails at once (N = 2, n = 1, opposite fish: 3).",
        ScaleVariant(vec![(|_, _| true, figure_scale)]),
        examine_scale,
    )
    .reading("The factor is that of the labels of Figure S3, 2/(n+1); with that of the text, 2/n + 1, it fails for two fish already")
    .repaired(
        Fault::False,
        "",
        ScaleVariant(vec![(|n, fish| n == 1 || n + 1 == fish, figure_scale), (|_, _| true, |n, _| rational(1, n))]),
    )
    .repaired_clauses(&[
        "With W_1 of the network of the n nearest neighbours of each of N >= 2 fish, 2/(n+1) W_1 lies in [0,1] for n = 1.",
        "2/(n+1) W_1 lies in [0,1] for n = N - 1.",
        "It is 4/3 for four fish on a square, n = 2, each opposite to both neighbours.",
        "For all n the scaled potential W_1/n lies in [0,1].",
    ])
    .control("2/n + 1, as in the text", ScaleVariant(vec![(|_, _| true, text_scale)]))
    .control("2/(n+1) for n = 3 too", ScaleVariant(vec![(|n, fish| n == 1 || n == 3 || n + 1 == fish, figure_scale)]))
}

fn examine_scale(variant: &ScaleVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const NEAREST: &str = "nearest neighbours";
    let mut random = run.random(0);
    let mut schools = vec![vec![(0, 0), (1, 0)], vec![(0, 0), (1, 0), (3, 0)], SQUARE.to_vec(), ROWS.to_vec()];
    for case in 0..run.cases(12, 60) {
        let mut number = || i64::from(random.next_u32() % 1000);
        schools.push((0..2 + case % 5).map(|_| (number(), number())).collect());
    }
    let networks = schools.iter().flat_map(|school| (1..school.len()).map(move |n| (school, n)));
    let networks = networks.filter_map(|(school, n)| Some((school, n, nearest_network(school, n)?)));
    let cases =
        networks.flat_map(|(school, n, network)| signs(school.len()).map(move |z| (school, n, network.clone(), z)));
    let evidence = fuzzed(NEAREST, "schools of 2 to 6 fish at random, all phases 0 and pi");
    let nearest = run.every(evidence, cases, |(school, n, network, z)| {
        let places: Vec<[Rational; 2]> = school.iter().map(|&(x, y)| [x, y].map(|x| rational(x, 1))).collect();
        let velocities: Vec<[Rational; 2]> = z.iter().map(|z| [z.re.clone(), z.im.clone()]).collect();
        let seen = |what| {
            Counterexample::new(format!("fish at {school:?}, {what}"), [Witness::agents(&places, &velocities, &[])])
        };
        Ok(variant.fails_at(&network, n, &z)?.map(seen))
    })?;
    let nearest = match nearest {
        Outcome::Fails { counterexample, .. } => Outcome::fails(counterexample, exact(NEAREST, "exact values")),
        other => other,
    };
    let detail = "all digraphs of up to 4 fish with the same number of neighbours, where the bounds are reached";
    let graphs = (2..=4).flat_map(WeightedGraph::all).filter_map(|graph| {
        let degrees = graph.out_degrees();
        let n = (1..graph.order()).find(|&n| degrees.iter().all(|d| *d == rational(n as i64, 1)))?;
        Some((graph, n))
    });
    let same = run.every(exhaustive("all phases 0 and pi", detail), graphs, |(graph, n)| {
        let laplacian = laplacian(&graph)?;
        for z in signs(graph.order()) {
            if let Some(what) = variant.fails_at(&laplacian, n, &z)? {
                return Ok(Some(format!("a digraph with n = {n} neighbours each, {what}")));
            }
        }
        Ok(None)
    })?;
    let bounds = [nearest, same].map(|outcome| Ok(supports(outcome, &[1, 2, 4])).checks("steps N1 and N2"));
    Run::all(
        bounds.into_iter().chain([
            variant.on_the_square(),
            argued(&[1, 2, 4], "every N and n", "notes/paley_phases.md, steps N1-N2"),
        ]),
    )
}

fn complete_sides(laplacian: SparseMatrix, scale: Rational) -> Identity<'static> {
    Identity::new(laplacian.order(), move |t| {
        let z = phasors(t)?;
        let scaled = phase_potential(&laplacian, &z, 1)? * t[0].rational(&scale);
        Ok((vec![scaled], vec![t[0].one() - mean(&z)?.norm_squared()]))
    })
}

pub fn complete_scale() -> Record<ScaleOf> {
    Record::new(
        "paley.scale.complete",
        "By (13) and (8) W_1 = (N/2)(1 - |p|^2), and N = n + 1: the factor is 2/(n+1), as the labels of Figure S3 have it.",
        text_scale as ScaleOf,
        |variant, run| {
            let parts = (2..=4usize).map(|fish| {
                let scale = variant(fish as i64 - 1, fish as i64);
                let identity = complete_sides(laplacian(&WeightedGraph::complete(fish))?, scale);
                Ok((identity, format!("N = {fish}, n = {}", fish - 1)))
            });
            identities(run, &[1], &[], parts)
        },
    )
    .repaired(
        Fault::Typo,
        "n = N-1 corresponds to the complete graph, in which case 2/(n+1) W_1(theta) = 1 - |p_theta|^2.",
        figure_scale,
    )
    .control("2/n", |n, _| rational(2, n))
}

/// The scale, and whether equal clusters count as unbalanced.
#[derive(Clone, Copy)]
pub struct PeakVariant {
    scale: ScaleOf,
    equal_clusters: bool,
}

pub fn three_and_one() -> Record<PeakVariant> {
    Record::new(
        "paley.fishpeak",
        "1 - |p|^2 with p = (3 - 1)/4. Unbalanced (2, 4)-patterns have M = 1 or 3 phases theta_0, which is the same shape: three and one, unique up to rotation and \
         exchange of fish. M = 2 is balanced, M = 0 synchronised: one cluster.",
        PeakVariant { scale: figure_scale, equal_clusters: false },
        |variant, run| {
            const FISH: usize = 4;
            let laplacian = laplacian(&WeightedGraph::complete(FISH))?;
            let sizes = (1..FISH).filter(|&m| variant.equal_clusters || 2 * m != FISH);
            let detail = "M = 1 and 3 of N = 4, all unbalanced (2, 4)-patterns";
            let found = run.exhaustive("value and uniqueness", detail, sizes, |m| {
                let z = on_the_line(FISH, FISH - m);
                let scaled = phase_potential(&laplacian, &z, 1)? * (variant.scale)(FISH as i64 - 1, FISH as i64);
                let sizes = (m.min(FISH - m), m.max(FISH - m));
                let wrong = scaled != rational(3, 4) || sizes != (1, 3);
                let clusters = format!("clusters of {} and {}", sizes.0, sizes.1);
                Ok(wrong.then(|| format!("M = {m} of N = 4: {clusters}, scaled potential {scaled}")))
            })?;
            Ok(found.on([1, 2]))
        },
    )
    .reading("The scale is that of the labels of Figure S3, 2/(n+1) (paley.scale.complete); patterns are counted up to rotation and exchange of fish")
    .clauses(&[
        "In the scaled potential for n = N-1 of four fish, three fish moving in parallel and one in the opposite direction have the value 0.75.",
        "This is the only unbalanced (2,N)-pattern for N = 4.",
    ])
    .altered("the scale 2/n + 1", |v| v.scale = text_scale)
    .altered("two and two counted too", |v| v.equal_clusters = true)
}
