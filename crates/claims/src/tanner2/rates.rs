//! tanner2.cor2_rate: how fast velocities agree, by exact linearisations.

use super::fixtures::{PLANE, connected, sloped};
use super::graphs::{rational_spectrum, shown};
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::spectrum::Polynomial;
use arithmetic::{CosineField, RealCyclotomic};
use models::double_integrator::{Coordinates, Potential, State, disagreements, loop_modes};

/// What is said of the rate at which the flock converges.
#[derive(Clone, Copy)]
pub enum RateVariant {
    /// With potentials, `lambda_2` determines it, and more edges make it larger.
    WithPotentials,
    /// With potentials, more edges make it larger.
    MoreEdges,
    /// Without potentials the slowest rate is this multiple of the eigenvalue of this index from below, and, if so said, a new edge
    /// slows no start.
    Alignment { factor: (i64, i64), index: usize, every_start: bool },
}

/// Whether every mode decays faster than `exp(-rate t)`.
fn faster_than(modes: &Polynomial, rate: &Rational) -> bool {
    modes.with_roots_moved(rate).is_hurwitz()
}

fn at_rest(places: &[(i64, i64)]) -> State<Rational> {
    let vector = |x: i64, y: i64| [rational(x, 1), rational(y, 1)];
    State {
        positions: places.iter().map(|&(x, y)| vector(x, y)).collect(),
        velocities: vec![vector(0, 0); places.len()],
    }
}

fn stiff(stiffness: (i64, i64)) -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(stiffness.0, stiffness.1))
}

/// Two linked agents with two stiffnesses: the same `lambda_2 = 2`, different rates.
fn same_connectivity() -> Result<Option<&'static str>, CheckError> {
    let (state, graph, q) = (at_rest(&[(0, 0), (1, 0)]), Graph::path(2), rational(1, 2));
    let faster = |stiffness| {
        Ok::<bool, CheckError>(faster_than(&loop_modes(&state, &graph.edges(), PLANE, &stiff(stiffness))?.1, &q))
    };
    Ok((faster((1, 1))? && !faster((1, 32))?).then_some(
        "two agents, lambda_2 = 2, V = k(s + 1/s - 2): with k = 1 every mode decays faster than exp(-t/2), with k = 1/32 not",
    ))
}

/// The path of three in a row and the triangle, at the desired distances, V = (s + 1/s - 2)/32: `lambda_2` is 1 and 3.
fn more_edges() -> Result<Option<&'static str>, CheckError> {
    let (soft, q) = (stiff((1, 32)), rational(1, 5));
    let (_, path) = loop_modes(&at_rest(&[(-1, 0), (0, 0), (1, 0)]), &Graph::path(3).edges(), PLANE, &soft)?;
    let complete = Graph::complete(3).edges();
    let (_, triangle) = loop_modes(&at_rest(&[(0, 0), (1, 0), (0, 1)]), &complete, Coordinates::Triangular, &soft)?;
    Ok((faster_than(&path, &q) && !faster_than(&triangle, &q)).then_some(
        "V = (s + 1/s - 2)/32 at the desired distances: every mode of the path of three in a row (lambda_2 = 1) decays faster than exp(-t/5), but not every mode of the triangle (lambda_2 = 3)",
    ))
}

/// The path 1-2-3-4 started in the eigenvector of 2 + sqrt 2, exactly: with the edge 1-4 the start has a part that decays at the rate 2.
fn slowed_start() -> Option<&'static str> {
    let field = CosineField::new(16);
    let start: Vec<RealCyclotomic> = [3, 9, 15, 21].map(|k| field.cos(k)).to_vec();
    let apply = |edges: &[(usize, usize)], x: &[RealCyclotomic]| -> Vec<RealCyclotomic> {
        let vectors: Vec<[RealCyclotomic; 2]> = x.iter().map(|x| [x.clone(), x.zero()]).collect();
        disagreements(&vectors, edges).into_iter().map(|[x, _]| x).collect()
    };
    let path = [(0, 1), (1, 2), (2, 3)];
    let ring = [(0, 1), (1, 2), (2, 3), (0, 3)];
    // sqrt 2 = 2 cos(pi/4).
    let rate = field.cos(2) * field.number(&rational(2, 1)) + field.number(&rational(2, 1));
    let is_mode = apply(&path, &start).iter().zip(&start).all(|(image, x)| *image == rate.clone() * x);
    // The ring has the eigenvalues 0, 2, 2, 4: what L (L - 4) leaves of a vector of mean zero is its part for 2.
    let once = apply(&ring, &start);
    let twice = apply(&ring, &once);
    let four = field.number(&rational(4, 1));
    let slow = twice.iter().zip(&once).any(|(a, b)| *a != four.clone() * b);
    (is_mode && slow)
        .then_some("no potentials, the path 1-2-3-4 with velocities along one axis in the eigenvector of 2 + sqrt 2: they decay at that rate, and with the edge 1-4 at the rate 2")
}

/// Whether the slowest rates without potentials are this eigenvalue, on connected graphs of up to 4 agents with rational spectra.
fn slowest_rates(factor: (i64, i64), index: usize, run: &Run) -> Result<Outcome, CheckError> {
    let (none, small) = (sloped(&[], 0), rational(1, 1000));
    let mut cases = Vec::new();
    for graph in connected(4).into_iter().filter(|graph| graph.order() > 1) {
        if let Some(values) = rational_spectrum(&graph)? {
            let index = if index == 0 { values.len() } else { index };
            let rate = &values[index - 1] * rational(factor.0, factor.1);
            cases.push((graph, rate));
        }
    }
    let detail = "characteristic polynomials and Routh's criterion on connected graphs of up to 4 agents with rational spectra, within 1/1000";
    run.instances("rates without potentials", detail, cases, |(graph, rate)| {
        let places: Vec<(i64, i64)> = (0..graph.order() as i64).map(|k| (k, k * k)).collect();
        let (_, modes) = loop_modes(&at_rest(&places), &graph.edges(), PLANE, &none)?;
        let wrong = !faster_than(&modes, &(&rate - &small)) || faster_than(&modes, &(&rate + &small));
        Ok(wrong.then(|| format!("{}, no potentials: the slowest rate is not {rate}", shown(&graph))))
    })
}

fn examine(variant: &RateVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "exact characteristic polynomials, Routh's criterion";
    let evidence = || exact("rates of the linearised loop", detail);
    let (same, more) = (same_connectivity()?, more_edges()?);
    let found = match variant {
        RateVariant::WithPotentials => same.map(|what| (what, vec![1])),
        RateVariant::MoreEdges => more.map(|what| (what, vec![2])),
        RateVariant::Alignment { every_start: true, .. } => slowed_start().map(|what| (what, vec![2])),
        RateVariant::Alignment { .. } => None,
    };
    if let Some((what, clauses)) = found {
        return Ok(Outcome::fails(what, evidence().on(clauses)));
    }
    let RateVariant::Alignment { factor, index, .. } = *variant else {
        return Ok(Outcome::Undecided("no counterexample among two and three agents".to_string()));
    };
    if same.is_none() || more.is_none() {
        return Ok(Outcome::Undecided("the examples with potentials do not show it".to_string()));
    }
    Run::all([
        slowest_rates(factor, index, run).checks("step 2").on([1]),
        argued(&[1, 2], "rates without potentials", "notes/tanner2.md, Corollary 2, steps 2 and 3"),
        holds(evidence().on([3]).for_all()),
    ])
}

pub fn rate() -> Record<RateVariant> {
    Record::new(
        "tanner2.cor2_rate",
        "dW/dt <= -lambda_2 |v_n|² bounds how fast energy is lost at a given disagreement, not how fast W or the velocities tend to their limits: that depends on the potentials too. Near an equilibrium a mode obeys \
         x'' + l x' + h x = 0, with l from the Laplacian and h from the potentials; for h small its rate is about h/l, which decreases as l grows. Two agents have rates below and above 1/2 for different potentials at the same lambda_2 = 2, and closing the path of three to a \
         triangle raises lambda_2 from 1 to 3 and lowers the rate. (Linearised modes of rate 0, which keep the shape or move it along equilibria, are left out.) Without potentials a new edge may still slow a particular start (a control).",
        RateVariant::WithPotentials,
        examine,
    )
    .clauses(&[
        "The algebraic connectivity lambda_2 determines the convergence rate.",
        "Increasing the connectivity of the neighboring graph results in faster convergence.",
    ])
    .reading("the rate at which the flock approaches its limit; N >= 2, as one agent has no lambda_2")
    .repaired(Fault::False, "", RateVariant::Alignment { factor: (1, 1), index: 2, every_start: false })
    .repaired_clauses(&[
        "On a fixed connected graph of N >= 2 agents under (4) without potentials |v - mean| <= exp(-lambda_2 t) |v(0) - mean| at all t >= \
         0, in the Euclidean norm of all velocities together, with equality where the deviation v(0) - mean is in each coordinate an \
         eigenvector of lambda_2, the second smallest eigenvalue of the Laplacian, or 0.",
        "A new edge on the same N >= 2 agents never lowers lambda_2.",
        "With potentials lambda_2 does not determine the rate, and a new edge may lower it: of the linearised loop with V = k(s + 1/s - 2), s the squared distance, at the desired distances all modes of two agents but those of rate 0 decay faster than exp(-t/2) for k = 1 and not for k = 1/32, and for k = 1/32 all such modes of the path of three in a row decay faster than exp(-t/5) and those of the triangle do not.",
    ])
    .control("with potentials, more edges make it faster", RateVariant::MoreEdges)
    .control("without potentials, 2 lambda_2", RateVariant::Alignment { factor: (2, 1), index: 2, every_start: false })
    .control(
        "without potentials, a new edge slows no start",
        RateVariant::Alignment { factor: (1, 1), index: 2, every_start: true },
    )
}
