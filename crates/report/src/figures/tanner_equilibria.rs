//! Exploration: the equilibria of complete graphs, paths, rings and trees, found from many starts and classified.

use super::{Reproduced, csv};
use crate::plot::{Axis, PALETTE, Panel, Picture, Series};
use algebra::graph::Graph;
use algebra::matrix::Inertia;
use arithmetic::random::generator;
use arithmetic::rational;
use arithmetic::threads::side_by_side;
use ledger::{CheckError, Options};
use models::double_integrator::Potential;
use models::double_integrator::equilibria::{Equilibrium, Framework, classes, distances, random_places};
use std::fmt::Write;

/// Translations and rotations: zeros of the Hessian of every configuration that is not a single point.
const MOTIONS: usize = 3;

/// A graph and what was found from its starts, half of them descents, half searches for critical configurations of any kind.
struct Found {
    name: String,
    graph: Graph,
    starts: u64,
    at_rest: usize,
    /// Configurations that can be bent: more zeros of the Hessian; and those of them from which the potential can fall.
    bent: (usize, usize),
    /// Isolated ones: with how often each was found, and the enclosed inertia where it was proved.
    isolated: Vec<(Equilibrium, usize, Option<Inertia>)>,
}

fn explore(name: String, graph: Graph, starts: u64) -> Found {
    let framework = Framework { edges: graph.edges(), potential: Potential::inverse_square_log(&rational(1, 1)) };
    let search = |&replicate: &u64| {
        let id = format!("tanner.equilibria.{name}");
        let start = random_places(graph.order(), &mut generator(&Options::default().seed, &id, replicate));
        if replicate.is_multiple_of(2) { framework.descend(&start) } else { framework.approach(&start) }
    };
    let replicates: Vec<u64> = (0..starts).collect();
    let rest: Vec<Equilibrium> = side_by_side(&replicates, search).into_iter().flatten().collect();
    let at_rest = rest.len();
    let (bent, isolated): (Vec<_>, Vec<_>) = rest.into_iter().partition(|found| found.inertia.zero > MOTIONS);
    let falling = bent.iter().filter(|found| found.inertia.negative > 0).count();
    let isolated = side_by_side(&classes(isolated), |(found, times)| (found.clone(), *times, framework.enclose(found)));
    Found { name, graph, starts, at_rest, bent: (bent.len(), falling), isolated }
}

fn graphs() -> Vec<(String, Graph, u64)> {
    let mut all: Vec<(String, Graph, u64)> = (2..=10)
        .map(|n| (format!("complete {n}"), Graph::from_fn(n, |_, _| true), if n < 8 { 200 } else { 120 }))
        .collect();
    for n in [4, 5, 6] {
        all.push((format!("ring {n}"), Graph::from_fn(n, move |i, j| j == i + 1 || (i == 0 && j + 1 == n)), 100));
    }
    for n in [4, 6] {
        all.push((format!("path {n}"), Graph::path(n), 40));
    }
    all.push(("star 5".to_string(), Graph::from_fn(5, |i, _| i == 0), 40));
    // Two stars of three joined at their centres.
    let double = [(0, 1), (0, 2), (0, 3), (3, 4), (3, 5)];
    all.push(("tree 6".to_string(), Graph::from_fn(6, move |i, j| double.contains(&(i, j))), 40));
    all
}

impl Found {
    /// Negative eigenvalues, by the enclosure where there is one.
    fn indices(&self) -> impl Iterator<Item = usize> + '_ {
        self.isolated.iter().map(|(found, _, proved)| proved.map_or(found.inertia.negative, |i| i.negative))
    }

    fn row(&self) -> String {
        let minima = self.indices().filter(|index| *index == 0).count();
        let proved = self.isolated.iter().filter(|(.., proved)| proved.is_some()).count();
        let least = self.isolated.first().map_or("-".to_string(), |(found, ..)| format!("{:.5}", found.energy));
        format!(
            "{:11} {:6} {:7} {:9} {:7} {:8} {:7} {:5} {:>10}",
            self.name,
            self.starts,
            self.at_rest,
            self.isolated.len(),
            minima,
            self.isolated.len() - minima,
            proved,
            self.bent.0,
            least
        )
    }
}

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let found = side_by_side(&graphs(), |(name, graph, starts)| explore(name.clone(), graph.clone(), *starts));
    let mut text = String::from(
        "EXPLORATION: equilibria of V = 1/s + log s; uniform starts in a square of side\n\
         2, half by descent, half by steps on |grad V|² (which find saddles). Distinct:\n\
         by all distances within 1e-5, up to congruence and names. Proved: Krawczyk's\n\
         test in intervals finds exactly one equilibrium in a box, and the signs of its\n\
         Hessian are enclosed over the box. Bent: starts that ended where more than the\n\
         three rigid motions cost nothing. That there are no others is not proved.\n\n\
         graph       starts at rest  distinct  minima  saddles  proved  bent  least V\n",
    );
    for one in &found {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", one.row());
    }
    let falling: Vec<String> =
        found.iter().filter(|one| one.bent.1 > 0).map(|one| format!("{} on {}", one.bent.1, one.name)).collect();
    let falling = if falling.is_empty() { "none".to_string() } else { falling.join(", ") };
    let _ = write!(
        text,
        "\nOn trees every equilibrium has all links at distance 1 (V' = 0 on each, as the\n\
         incidence matrix has independent columns), so all are minima with V = N - 1 and\n\
         can be bent. On rings all links at distance 1 are one family of minima; what is\n\
         isolated there are rows, in which each link pulls or pushes with the same force.\n\
         Bent configurations from which V can fall to second order: {falling}.\n"
    );
    let rows = found.iter().flat_map(|one| {
        one.isolated.iter().map(|(equilibrium, times, proved)| {
            let all = distances(&equilibrium.positions);
            let index = |inertia: Inertia| format!("{} {} {}", inertia.negative, inertia.zero, inertia.positive);
            [
                one.name.clone(),
                one.graph.order().to_string(),
                format!("{:.12}", equilibrium.energy),
                times.to_string(),
                index(equilibrium.inertia),
                proved.map_or("no".to_string(), |i| format!("{} {} {}", i.negative, MOTIONS, i.positive)),
                format!("{:.9}", all[0]),
                format!("{:.9}", all[all.len() - 1]),
            ]
        })
    });
    let csv = csv("graph,agents,energy,times_found,signs_in_floats,signs_proved,least_distance,largest_distance", rows);
    let complete: Vec<&Found> = found.iter().filter(|one| one.name.starts_with("complete")).collect();
    let of = |minima: bool| {
        complete.iter().flat_map(move |one| {
            let least = one.isolated.first().map_or(0.0, |(found, ..)| found.energy);
            one.isolated.iter().zip(one.indices()).filter(move |(_, index)| (*index == 0) == minima).map(
                move |((found, ..), _)| {
                    (one.graph.order() as f64, (found.energy - least) / one.graph.edges().len() as f64)
                },
            )
        })
    };
    let number = |minima: bool| {
        complete.iter().map(move |one| {
            let count = one.indices().filter(|index| (*index == 0) == minima).count();
            (one.graph.order() as f64, count as f64)
        })
    };
    let agents = || Axis::linear("agents").between(1.5, 10.5).ticks((2..=10).map(f64::from).collect::<Vec<_>>());
    let picture = Picture::new("Exploration: equilibria of complete graphs, V = 1/s + log s")
        .grid(2, (520.0, 400.0))
        .panel(
            Panel::new("a) above the lowest", agents(), Axis::linear("V per link above the least"))
                .series(Series::points("saddles", of(false)).colour(PALETTE[1]).size(2.2))
                .series(Series::crosses("minima", of(true)).colour(PALETTE[0])),
        )
        .panel(
            Panel::new("b) how many were found", agents(), Axis::log("distinct equilibria"))
                .series(Series::joined("saddles", number(false)).colour(PALETTE[1]))
                .series(Series::joined("minima", number(true)).colour(PALETTE[0])),
        );
    Ok(Reproduced::new(text).table("", csv).picture("", picture))
}
