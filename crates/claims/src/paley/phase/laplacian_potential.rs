//! paley.eq13, paley.gradW, paley.eq14_15: the Laplacian phase potential, its gradient and its control.

use super::common::{arcs, identities, laplacian, named};
use crate::prelude::*;
use algebra::graph::WeightedGraph;
use algebra::matrix::SparseMatrix;
use models::oscillator::{
    laplacian_control, misalignment, moment_gradient, moment_potential, pairwise_control, phase_gradient,
    phase_potential, phase_potential_gradient, phasors, rate_of_change,
};

/// `W_1 = constant + sign U_1` on a graph.
#[derive(Clone, Copy)]
pub struct CompleteVariant {
    constant: fn(i64) -> Rational,
    sign: i64,
    graph: fn(usize) -> WeightedGraph,
}

fn complete_sides(laplacian: SparseMatrix, constant: Rational, sign: i64) -> Identity<'static> {
    Identity::new(laplacian.order(), move |t| {
        let z = phasors(t)?;
        let sign = t[0].integer(sign);
        let right = t[0].rational(&constant) + moment_potential(&z, 1)? * &sign;
        let slopes = moment_gradient(&z, 1)?.into_iter().map(|slope| slope * &sign);
        let left = [phase_potential(&laplacian, &z, 1)?].into_iter();
        let gradient = phase_gradient(&z, |z| phase_potential(&laplacian, z, 1))?;
        Ok((left.chain(gradient).collect(), [right].into_iter().chain(slopes).collect()))
    })
}

pub fn complete_potential() -> Record<CompleteVariant> {
    Record::new(
        "paley.eq13",
        "L = N I - 1 1^T: <z, L z> = N * N - |sum z|^2 = N^2 (1 - |p|^2), divided by 2N. The gradients are opposite, so the stationary points are the same.",
        CompleteVariant { constant: |n| rational(n, 2), sign: -1, graph: WeightedGraph::complete },
        |variant, run| {
            let parts = (1..=3usize).map(|n| {
                let laplacian = laplacian(&(variant.graph)(n))?;
                let identity = complete_sides(laplacian, (variant.constant)(n as i64), variant.sign);
                Ok((identity, format!("W_1 and its gradient, N = {n}")))
            });
            identities(run, &[1, 2], &[], parts)
        },
    )
    .clauses(&["If G is complete, then W_1(theta) = N/2 - U_1(theta).", "W_1 has the same stationary points as U_1."])
    .altered("N instead of N/2", |v| v.constant = |n| rational(n, 1))
    .altered("+ U_1", |v| v.sign = 1)
    .altered("the path", |v| v.graph = |n| WeightedGraph::from_fn(n, |k, j| k.abs_diff(j) == 1))
}

/// Graphs of the identities; a directed one first where the statement is to be tried on it.
fn graphs(directed: bool) -> impl Iterator<Item = Result<WeightedGraph, CheckError>> {
    let one_way = directed.then(|| Ok(WeightedGraph::from_fn(2, |k, _| k == 0)));
    // The last has two nodes that are joined, and one on its own.
    let undirected = ["path:2", "path:3", "complete:3"]
        .map(named)
        .into_iter()
        .chain([Ok(WeightedGraph::from_fn(3, |k, j| k + j == 1))]);
    one_way.into_iter().chain(undirected)
}

/// Factors of the two expressions for the gradient, and the graphs.
#[derive(Clone, Copy)]
pub struct GradientVariant {
    both: i64,
    own: (i64, i64),
    directed: bool,
}

fn gradient_sides(laplacian: SparseMatrix, variant: &GradientVariant) -> Identity<'_> {
    Identity::new(laplacian.order(), move |t| {
        let z = phasors(t)?;
        let gradient = phase_gradient(&z, |z| phase_potential(&laplacian, z, 1))?;
        let (both, own) = (t[0].integer(variant.both), variant.own);
        let own = t[0].ratio(own.0, own.1 * z.len() as i64);
        let first = phase_potential_gradient(&laplacian, &z)?.into_iter().map(|slope| slope * &both);
        let second = misalignment(&laplacian, &z).into_iter().map(|term| term * &own);
        Ok((gradient.iter().chain(&gradient).cloned().collect(), first.chain(second).collect()))
    })
}

pub fn gradient() -> Record<GradientVariant> {
    Record::new(
        "paley.gradW",
        "The derivative of (1/(2N)) <z, L z> along i z_k e_k is (1/(2N)) (<i z_k, L_k z> + <z, L e_k i z_k>), and the second term is <i z_k, (L^T)_k z>. \
         For undirected G, L = L^T. (The first form holds for directed graphs too, the second does not.)",
        GradientVariant { both: 1, own: (1, 1), directed: false },
        |variant, run| {
            let parts = graphs(variant.directed).map(|graph| {
                let graph = graph?;
                let part = format!("gradient of W_1, N = {}, {}", graph.order(), arcs(&graph));
                Ok((gradient_sides(laplacian(&graph)?, variant), part))
            });
            identities(run, &[1, 2], &[], parts)
        },
    )
    .clauses(&[
        "For undirected G, dW_1/dtheta_k = (1/(2N)) <i e^{i theta_k}, (L + L^T)_k e^{i theta}>.",
        "This is (1/N) <i e^{i theta_k}, L_k e^{i theta}>.",
    ])
    .altered("directed graphs too", |v| v.directed = true)
    .altered("1/(2N) with L alone", |v| v.own = (1, 2))
    .altered("1/N with L + L^T", |v| v.both = 2)
}

/// Powers and signs of the rate and of the sum over pairs.
#[derive(Clone, Copy)]
pub struct LawVariant {
    power_of_n: u32,
    sine: i64,
    directed: bool,
}

/// Variables are the phases, `K_1` and `omega_0`.
fn law_sides(laplacian: SparseMatrix, graph: WeightedGraph, variant: &LawVariant) -> Identity<'_> {
    Identity::new(graph.order() + 2, move |at| {
        let [t @ .., gain, omega] = at else { return Err(ArithmeticError::Domain("phases, K_1, omega_0")) };
        let z = phasors(t)?;
        let rates: Vec<Probe> = laplacian_control(gain, &laplacian, &z)?.into_iter().map(|u| u + omega).collect();
        let rate = rate_of_change(&z, &rates, |z: &[_]| phase_potential::<Dual<Probe>>(&laplacian, z, 1))?;
        let squares = misalignment(&laplacian, &z).iter().fold(gain.zero(), |sum, term| sum + term.square());
        let share = gain.ratio(1, (z.len() as i64).pow(variant.power_of_n));
        let sine = gain.integer(variant.sine);
        let pairs = pairwise_control(gain, &graph, &z)?.into_iter().map(|pair| pair * &sine + omega);
        let left = [rate].into_iter().chain(rates).collect();
        Ok((left, [squares * gain * share].into_iter().chain(pairs).collect()))
    })
}

pub fn law() -> Record<LawVariant> {
    Record::new(
        "paley.eq14_15",
        "dW_1/dtheta_k = (1/N) <i z_k, L_k z> (paley.gradW) times thetadot_k; omega_0 adds omega_0 1^T grad W_1 = 0, because W_1 does not change when all \
         phases turn. <i z_k, L_k z> = -sum_j <i z_k, z_j> = sum_j sin theta_kj.",
        LawVariant { power_of_n: 2, sine: 1, directed: false },
        |variant, run| {
            let parts = graphs(variant.directed).map(|graph| {
                let graph = graph?;
                let part = format!("rate of W_1 and (15), N = {}, {}", graph.order(), arcs(&graph));
                Ok((law_sides(laplacian(&graph)?, graph, variant), part))
            });
            identities(run, &[1, 2], &["K1", "omega0"], parts)
        },
    )
    .clauses(&[
        "For undirected G, the phase model (6) with (14) satisfies Wdot_1 = (K_1/N^2) sum_k <i e^{i theta_k}, L_k e^{i theta}>^2.",
        "It is equivalent to thetadot_k = omega_0 + (K_1/N) sum_{j in N_k} sin theta_kj.",
    ])
    .altered("K_1/N in the rate", |v| v.power_of_n = 1)
    .altered("sin theta_jk", |v| v.sine = -1)
    .altered("directed graphs too", |v| v.directed = true)
}
