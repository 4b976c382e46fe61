//! Exploration: how fast a flock comes to rest against the algebraic connectivity, for all connected graphs of five and six agents.

use super::{Reproduced, csv};
use crate::plot::{Axis, PALETTE, Panel, Picture, Series};
use algebra::graph::Graph;
use algebra::matrix::floating::{symmetric_eigen, to_floats};
use arithmetic::random::generator;
use arithmetic::rational;
use arithmetic::threads::side_by_side;
use ledger::{CheckError, Options};
use models::double_integrator::Potential;
use models::double_integrator::equilibria::{Equilibrium, Framework, random_places};
use models::double_integrator::relaxation::{Relaxation, relaxation};
use std::collections::BTreeMap;

const STARTS: u64 = 24;
/// The potential divided by this, for soft flocks.
const SOFT: i64 = 32;

/// One graph and the minimum of least energy that was found.
struct Found {
    graph: Graph,
    connectivity: f64,
    largest: f64,
    minimum: Equilibrium,
    firm: Relaxation,
    soft: Relaxation,
}

fn explore(graph: Graph, replicate: u64) -> Result<Found, CheckError> {
    let other = |e: &dyn std::fmt::Display| CheckError::Other(e.to_string());
    let firm = Framework { edges: graph.edges(), potential: Potential::inverse_square_log(&rational(1, 1)) };
    let mut random = generator(&Options::default().seed, "tanner.rates", replicate);
    let minima = (0..STARTS).filter_map(|_| firm.descend(&random_places(graph.order(), &mut random)));
    let minimum = minima
        .filter(|found| found.inertia.negative == 0)
        .min_by(|a, b| a.energy.total_cmp(&b.energy))
        .ok_or_else(|| CheckError::Other("no minimum was found".to_string()))?;
    let spectrum = symmetric_eigen(&to_floats(&graph.laplacian()?)).map_err(|e| other(&e))?.values;
    let soft = Framework { potential: firm.potential.times(&rational(1, SOFT)), ..firm.clone() };
    Ok(Found {
        connectivity: spectrum[1],
        largest: spectrum[spectrum.len() - 1],
        firm: relaxation(&firm, &minimum).map_err(|e| other(&e))?,
        soft: relaxation(&soft, &minimum).map_err(|e| other(&e))?,
        minimum,
        graph,
    })
}

/// How many of the additions of one edge lower the rate, among all.
fn slowed(found: &[Found], rate: fn(&Found) -> f64) -> (usize, usize) {
    let known: BTreeMap<_, f64> =
        found.iter().map(|f| ((f.graph.order(), f.graph.isomorphism_code()), rate(f))).collect();
    let (mut lower, mut all) = (0, 0);
    for f in found {
        let order = f.graph.order();
        for (i, j) in (0..order).flat_map(|j| (0..j).map(move |i| (i, j))) {
            if f.graph.has_edge(i, j) {
                continue;
            }
            if let Some(next) = known.get(&(order, f.graph.with_edges(&[(i, j)]).isomorphism_code())) {
                all += 1;
                lower += usize::from(*next < rate(f) - 1e-6);
            }
        }
    }
    (lower, all)
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
}

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let graphs: Vec<Graph> = (3..=6).flat_map(Graph::connected_up_to_isomorphism).collect();
    let graphs: Vec<(u64, Graph)> = (0..).zip(graphs).collect();
    let found = side_by_side(&graphs, |(index, graph)| explore(graph.clone(), *index));
    let found: Vec<Found> = found.into_iter().collect::<Result<_, _>>()?;
    let firm_ratio = range(found.iter().map(|f| f.firm.rate / f.connectivity));
    let soft_ratio = range(found.iter().map(|f| f.soft.rate / f.connectivity));
    let swinging = found.iter().filter(|f| f.firm.swings).count();
    let swing = range(found.iter().filter(|f| f.firm.swings).map(|f| f.firm.rate / f.connectivity));
    let (firm_slowed, soft_slowed) = (slowed(&found, |f| f.firm.rate), slowed(&found, |f| f.soft.rate));
    let residual = found.iter().map(|f| f.firm.residual.max(f.soft.residual)).fold(0.0, f64::max);
    let below = found.iter().filter(|f| f.firm.rate < f.connectivity / 2.0 - 1e-9).count();
    let soft_below = found.iter().filter(|f| f.soft.rate < f.connectivity / 2.0 - 1e-9).count();
    // Three zeros belong to translations and rotations.
    let bent = found.iter().filter(|f| f.minimum.inertia.zero > 3).count();
    let text = format!(
        "EXPLORATION in floating point, not a proof. All {} connected graphs of 3 to 6\n\
         agents, law (4) with V = 1/s + log s, and with V/{SOFT}; the lowest minimum found by\n\
         {STARTS} descents; rate: the least decay of a mode of the linearised loop, without\n\
         uniform motion and without modes of rate 0, along which equilibria lie (exact\n\
         for H changed by at most {residual:.0e}). lambda_2: algebraic connectivity.\n\n\
         \x20                                             V             V/{SOFT}\n\
         rate / lambda_2                        {:6.3} .. {:5.3}  {:7.4} .. {:5.3}\n\
         edge additions that lower the rate       {:4} of {:4}     {:4} of {:4}\n\n\
         What the Laplacian bounds: a mode x with mu² + l mu + h = 0, l = x*Lx and\n\
         h = x*Hx (|x| = 1), is normal to uniform motions, so lambda_2 <= l. If it\n\
         swings, its rate is l/2, between lambda_2/2 and lambda_N/2: so for the {swinging}\n\
         graphs whose slowest mode swings (ratios {:.3} to {:.3}). Without potentials the\n\
         rate is lambda_2. What it does not bound: modes that do not swing have the rates\n\
         (l ± sqrt(l² - 4h))/2, the slower about h/l, less for more damping: so\n\
         {below} graphs lie below lambda_2/2 with V, {soft_below} with V/{SOFT}. This is what\n\
         tanner2.cor2_rate shows exactly for a pair, a row and a triangle. {bent} of the\n\
         graphs can be bent at their minimum: theirs are rates of the one shape found.\n",
        found.len(),
        firm_ratio.0,
        firm_ratio.1,
        soft_ratio.0,
        soft_ratio.1,
        firm_slowed.0,
        firm_slowed.1,
        soft_slowed.0,
        soft_slowed.1,
        swing.0,
        swing.1,
    );
    let rows = found.iter().map(|f| {
        let edges: Vec<String> = f.graph.edges().iter().map(|(i, j)| format!("{}-{}", i + 1, j + 1)).collect();
        [
            f.graph.order().to_string(),
            edges.len().to_string(),
            edges.join(" "),
            format!("{:.9}", f.connectivity),
            format!("{:.9}", f.largest),
            format!("{:.9}", f.minimum.energy),
            f.minimum.inertia.zero.to_string(),
            format!("{:.9}", f.firm.rate),
            f.firm.swings.to_string(),
            format!("{:.9}", f.soft.rate),
            f.soft.swings.to_string(),
            format!("{:.1e}", f.firm.residual.max(f.soft.residual)),
        ]
    });
    let header =
        "agents,links,edges,lambda_2,lambda_N,energy,zero_curvatures,rate,swings,rate_soft,swings_soft,residual";
    let csv = csv(header, rows);
    let panel = |title: &str, quantity: fn(&Found) -> Relaxation, top: f64| {
        let of = |swings: bool| {
            let chosen = found.iter().filter(move |f| quantity(f).swings == swings);
            chosen.map(move |f| (f.connectivity, quantity(f).rate)).collect::<Vec<_>>()
        };
        Panel::new(
            title,
            Axis::linear("algebraic connectivity λ_2"),
            Axis::linear("rate of approach (1/s)").between(0.0, top),
        )
        .series(Series::points("slowest mode swings", of(true)).colour(PALETTE[0]))
        .series(Series::crosses("it does not", of(false)).colour(PALETTE[1]))
        .series(Series::dashed("λ_2 (no potentials)", [(0.0, 0.0), (6.0, 6.0)]).colour(PALETTE[7]))
        .series(Series::line("λ_2 / 2", [(0.0, 0.0), (6.0, 3.0)]).colour(PALETTE[2]))
    };
    let top = found.iter().map(|f| f.soft.rate).fold(0.0, f64::max) * 1.3;
    let picture = Picture::new("Exploration: rate of approach against algebraic connectivity, 3 to 6 agents")
        .grid(2, (520.0, 420.0))
        .panel(panel("a) V = 1/s + log s", |f| f.firm, 3.5))
        .panel(panel("b) V/32", |f| f.soft, top));
    Ok(Reproduced::new(text).table("", csv).picture("", picture))
}
