//! paley.ref: the potential with a reference phase.

use super::common::{all_equal, arcs, identities, laplacian, named};
use crate::prelude::*;
use algebra::graph::{Graph, WeightedGraph};
use algebra::matrix::SparseMatrix;
use arithmetic::{CosineField, Sign, Signed};
use models::oscillator::{exact_phasors, in_turns, phase_potential, phasors, squared_lengths, up_to_rotation};

/// The sign before the cosine, and the graphs for which there is no other minimiser.
#[derive(Clone, Copy)]
pub struct ReferenceVariant {
    sign: i64,
    unique_on: fn(&Graph) -> bool,
}

/// `W_1 + 1 + sign cos(theta_0 - theta_N)`, with `z_0` first.
fn potential<T: Field>(laplacian: &SparseMatrix, z: &[Complex<T>], sign: i64) -> Result<T, ArithmeticError> {
    let (reference, particles) = z.split_first().ok_or(ArithmeticError::Domain("a reference"))?;
    let last = particles.last().ok_or(ArithmeticError::Domain("at least one particle"))?;
    let cosine = reference.dot(last) * reference.re.integer(sign);
    Ok(phase_potential(laplacian, particles, 1)? + reference.re.one() + cosine)
}

/// The potential as a sum of squares; the first variable is the reference.
fn squares(laplacian: SparseMatrix, graph: WeightedGraph, sign: i64) -> Identity<'static> {
    Identity::new(graph.order() + 1, move |t| {
        let z = phasors(t)?;
        let n = graph.order();
        let lengths = squared_lengths(&graph, &z[1..], &t[0]) * t[0].ratio(1, 4 * n as i64);
        let pulled = (z[0].clone() - &z[n]).norm_squared() * t[0].ratio(1, 2);
        Ok((vec![potential(&laplacian, &z, sign)?], vec![lengths + pulled]))
    })
}

pub fn reference_phase() -> Record<ReferenceVariant> {
    Record::new(
        "paley.ref",
        "W_1 >= 0 and 1 - cos >= 0, both zero at theta_k = theta_0. The sum is (1/(4N)) sum over arcs of |z_k - z_j|^2 + |z_0 - z_N|^2/2: on a connected graph, as the \
         section assumes, there is no other global minimiser. (There may be other stationary points.) The sentence that follows in the paper, that for omega_0 != 0 this configuration \
         corresponds to a circular formation, is not part of this claim; by the standard of paley.sync.par it is false: two particles with omega_0 = 1 and equal phases at r = 0 and r = 1 turn about two different centres for ever.",
        ReferenceVariant { sign: -1, unique_on: Graph::is_connected },
        |variant, run| {
            const PARTS: usize = 4;
            let field = CosineField::new(PARTS as u32);
            let detail = "all undirected graphs of up to 3 nodes, all arrangements of quarter turns";
            let cases = (1..=3).flat_map(Graph::all).flat_map(|graph| {
                up_to_rotation(graph.order() + 1, PARTS).map(move |exponents| (graph.clone(), exponents))
            });
            let minimisers = run.every(exhaustive("global minimisers", detail), cases, |case| {
                let (graph, exponents) = case;
                let weighted = WeightedGraph::from(&graph);
                let sign = potential(&laplacian(&weighted)?, &exact_phasors(&field, &exponents), variant.sign)?.sign();
                let (together, zero) = (all_equal(&exponents), sign == Some(Sign::Zero));
                let unique = zero && !together && (variant.unique_on)(&graph);
                let wrong = sign == Some(Sign::Negative) || together && !zero || unique;
                let place = || format!("{}, the reference and the particles at {}", arcs(&weighted), in_turns(&exponents, PARTS));
                Ok(wrong.then(|| format!("{}: the potential is {}zero", place(), if zero { "" } else { "not " })))
            });
            let squares = ["path:2", "path:3", "ring:3"].map(|name| {
                let graph = named(name)?;
                let identity = squares(laplacian(&graph)?, graph, variant.sign);
                Ok((identity, format!("the sum of squares, {name}")))
            });
            let squares = identities(run, &[1], &[], squares);
            Run::all([minimisers, squares])
        },
    )
    .altered("1 + cos", |v| v.sign = 1)
    .altered("unique on every graph", |v| v.unique_on = |_| true)
}
