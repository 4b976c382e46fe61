//! paley.eq16, paley.eq16.eigvec, paley.balexist: stationary points of the Laplacian phase potential.

use super::common::{N_AT_LEAST_2, all_equal, all_zero, arcs, laplacian, named};
use crate::prelude::*;
use algebra::graph::{Graph, WeightedGraph};
use algebra::matrix::SparseMatrix;
use arithmetic::{CosineField, RealCyclotomic};
use models::oscillator::{
    ExactPhasors, exact_phasors, in_turns, is_eigenvector, laplacian_control, laplacian_rows, mean, misalignment,
    phase_gradient, phase_potential, up_to_rotation,
};

/// Graphs of up to so many nodes, all undirected ones or all digraphs.
fn graphs(most: usize, directed: bool) -> Vec<WeightedGraph> {
    let undirected = (1..=most).flat_map(Graph::all).map(|graph| WeightedGraph::from(&graph));
    if directed { (1..=most).flat_map(WeightedGraph::all).collect() } else { undirected.collect() }
}

/// The gradient of `W_1` by duals.
fn slopes(laplacian: &SparseMatrix, z: &ExactPhasors) -> Result<Vec<RealCyclotomic>, CheckError> {
    Ok(phase_gradient(z, |z| phase_potential(laplacian, z, 1))?)
}

/// Whether directed graphs count, and which product with `L_k e^{i theta}` is to vanish.
#[derive(Clone, Copy)]
pub struct StationaryVariant {
    directed: bool,
    unturned: bool,
}

pub fn stationary_points() -> Record<StationaryVariant> {
    Record::new(
        "paley.eq16",
        "By paley.gradW the left sides of (16) are N times the derivatives of W_1. (On directed graphs they are not, and (16) may hold at a point that is not \
         stationary.)",
        StationaryVariant { directed: false, unturned: false },
        |variant, run| {
            const PARTS: usize = 4;
            let field = CosineField::new(PARTS as u32);
            let most = if variant.directed { 3 } else { run.cases(3, 4) };
            let detail = format!("all undirected graphs of up to {most} nodes, all arrangements of quarter turns");
            let evidence = exhaustive("(16) and the gradient by duals", detail);
            let cases = graphs(most, variant.directed).into_iter().flat_map(|graph| {
                up_to_rotation(graph.order(), PARTS).map(move |exponents| (graph.clone(), exponents))
            });
            run.every(evidence, cases, |(graph, exponents)| {
                let (laplacian, z) = (laplacian(&graph)?, exact_phasors(&field, &exponents));
                let products: Vec<RealCyclotomic> = if variant.unturned {
                    z.iter().zip(laplacian_rows(&laplacian, &z)).map(|(z, lz)| z.dot(&lz)).collect()
                } else {
                    misalignment(&laplacian, &z)
                };
                let wrong = all_zero(&products) != all_zero(&slopes(&laplacian, &z)?);
                let place = || format!("{}, {}", arcs(&graph), in_turns(&exponents, PARTS));
                Ok(wrong.then(|| format!("{}: only one of the two vanishes", place())))
            })
        },
    )
    .altered("directed graphs too", |v| v.directed = true)
    .altered("<e^{i theta_k}, L_k e^{i theta}>", |v| v.unturned = true)
}

/// Graphs, direction of the implication, and what an equilibrium is.
#[derive(Clone, Copy)]
pub struct EigenvectorVariant {
    directed: bool,
    converse: bool,
    at_rest: bool,
}

pub fn eigenvectors_are_stationary() -> Record<EigenvectorVariant> {
    Record::new(
        "paley.eq16.eigvec",
        "L is real and symmetric, so the eigenvalue is real and <i z_k, lambda z_k> = 0: (16) holds, the control vanishes, and all phases turn at omega_0. \
         On directed graphs eigenvalues may be complex and it fails; the converse fails too.",
        EigenvectorVariant { directed: false, converse: false, at_rest: false },
        examine_eigenvectors,
    )
    .reading("Equilibria of (6) with (14) are taken modulo rotation, as throughout the paper: all phases turn at one rate; at rest for omega_0 = 0")
    .clauses(&[
        "If e^{i theta} is an eigenvector of L (G undirected), then theta is a stationary point of W_1.",
        "It is then an equilibrium of (6).",
    ])
    .altered("directed graphs too", |v| v.directed = true)
    .altered("and conversely", |v| v.converse = true)
    .altered("at rest for any omega_0", |v| v.at_rest = true)
}

fn examine_eigenvectors(variant: &EigenvectorVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const PARTS: usize = 6;
    let field = CosineField::new(PARTS as u32);
    let gain = field.cos(0);
    let more = ["ring:6", "complete:6"].map(named).into_iter().collect::<Result<Vec<_>, _>>()?;
    // On more nodes the columns of the Fourier matrix only.
    let arrangements = |order: usize| -> Vec<Vec<usize>> {
        let columns = (0..order).map(|m| (0..order).map(|k| m * k % PARTS).collect());
        if order > 3 { columns.collect() } else { up_to_rotation(order, PARTS).collect() }
    };
    let cases = graphs(3, variant.directed)
        .into_iter()
        .chain(more)
        .flat_map(|graph| arrangements(graph.order()).into_iter().map(move |exponents| (graph.clone(), exponents)));
    let detail =
        "all undirected graphs of up to 3 nodes with phases at multiples of 1/6 turn, columns of F for C_6 and K_6";
    let evidence = exhaustive("eigenvectors of modulus one", detail).on([1, 2]);
    run.every(evidence, cases, |(graph, exponents)| {
        let (laplacian, z) = (laplacian(&graph)?, exact_phasors(&field, &exponents));
        let eigenvector = is_eigenvector(&laplacian, &z);
        if !eigenvector && !variant.converse {
            return Ok(None);
        }
        let stationary = all_zero(&slopes(&laplacian, &z)?) && all_zero(&misalignment(&laplacian, &z));
        let rates: Vec<_> = laplacian_control(&gain, &laplacian, &z)?.into_iter().map(|u| u + gain.one()).collect();
        let equilibrium = if variant.at_rest { all_zero(&rates) } else { all_equal(&rates) };
        let found =
            format!("eigenvector {eigenvector}, stationary {stationary}, equilibrium {equilibrium} for omega_0 = 1");
        let wrong = eigenvector != (stationary && equilibrium);
        Ok(wrong.then(|| format!("{}, {}: {found}", arcs(&graph), in_turns(&exponents, PARTS))))
    })
}

/// The graphs that are claimed to have a balanced stationary point.
#[derive(Clone, Copy)]
pub enum BalancedVariant {
    /// Circulants from this order on.
    Circulants(usize),
    /// The path of three nodes.
    Path,
}

impl BalancedVariant {
    fn graphs(self, run: &Run) -> Vec<WeightedGraph> {
        let BalancedVariant::Circulants(least) = self else { return vec![WeightedGraph::from(&Graph::path(3))] };
        let undirected = (least..=run.cases(6, 9)).flat_map(|order| WeightedGraph::circulants(order, true));
        let directed = (least..=5).flat_map(|order| WeightedGraph::circulants(order, false));
        undirected.chain(directed).map(|(_, graph)| graph).collect()
    }
}

/// A balanced stationary point among the columns of the Fourier matrix and the arrangements on a line.
fn balanced_point(laplacian: &SparseMatrix) -> Result<Option<ExactPhasors>, CheckError> {
    let order = laplacian.order();
    let field = CosineField::new(2 * order as u32);
    let columns = (1..order).map(|m| (0..order).map(|k| 2 * m * k % (2 * order)).collect::<Vec<_>>());
    let line = up_to_rotation(order.min(4), 2).filter(|signs| signs.len() == order);
    for exponents in columns.chain(line.map(|signs| signs.iter().map(|sign| sign * order).collect())) {
        let z = exact_phasors(&field, &exponents);
        let centre = mean(&z)?;
        if centre == centre.zero() && all_zero(&slopes(laplacian, &z)?) {
            return Ok(Some(z));
        }
    }
    Ok(None)
}

pub fn balanced_point_exists() -> Record<BalancedVariant> {
    Record::new(
        "paley.balexist",
        "The second column of F has entries of modulus one with sum zero, and it is an eigenvector \
         of the circulant L + L^T, whose eigenvalues are real: stationary, for directed circulants too. Connectedness alone is not sufficient: on a tree \
         stationary means all phases on a line (from the leaves inward), which an odd N cannot balance.",
        BalancedVariant::Circulants(2),
        |variant, run| {
            let detail = "all undirected circulants of 2 to 6 nodes (9 with --full), all directed ones of 2 to 5";
            let evidence = exhaustive("a balanced point with zero gradient", detail);
            let found = run.every(evidence, variant.graphs(run), |graph| {
                let none = balanced_point(&laplacian(&graph)?)?.is_none();
                Ok(none.then(|| format!("N = {}, {}: no balanced stationary point", graph.order(), arcs(&graph))))
            });
            Run::all([
                found.checks("step S3"),
                argued(&[1], "every circulant graph, directed ones too", "notes/paley_phases.md, steps S3"),
            ])
        },
    )
    .reading(N_AT_LEAST_2)
    .control("one particle too", BalancedVariant::Circulants(1))
    .control("connected graphs: the path of three", BalancedVariant::Path)
}
