//! paley.eq17, paley.eq18, paley.eq19_20: the spacing potential and how it changes.

use super::instances::{StateIdentity, described, identity_graphs, state_identity, sum_of_squares};
use crate::prelude::*;
use algebra::graph::Graph;
use models::oscillator::{Neighbours, circle_centres, heading_components, spacing_control, spacing_potential};

/// `S` is `share` times the sum of the squared lengths of the edges between centres.
fn edge_sum(graph: &Graph, share: (i64, i64)) -> StateIdentity<'_> {
    StateIdentity::of(graph.order(), move |[omega], state| {
        let s = spacing_potential(omega, &Neighbours::of(graph), state)?;
        let c = circle_centres(omega, state)?;
        let edges = graph.edges().into_iter();
        let sum = edges.fold(omega.zero(), |sum, (i, j)| sum + (c[i].clone() - &c[j]).norm_squared());
        Ok((vec![s], vec![sum * omega.ratio(share.0, share.1 * graph.order() as i64)]))
    })
}

/// On which graphs, with which bound `|c_kj|^2 <= (N - 1 + excess) 2 N S` and which share of the edge sum.
#[derive(Clone, Copy)]
pub struct ProperVariant {
    disconnected: bool,
    excess: i64,
    share: (i64, i64),
}

impl ProperVariant {
    pub const PRINTED: Self = ProperVariant { disconnected: false, excess: 0, share: (1, 2) };
    pub const ANY_GRAPH: Self = ProperVariant { disconnected: true, ..Self::PRINTED };
}

/// Whether `S` is positive and proper as the variant says.
pub fn examine_proper(variant: &ProperVariant, run: &Run) -> Result<Outcome, CheckError> {
    let most = run.cases(4, 5);
    let graphs = (1..=most).flat_map(Graph::all).filter(|g| variant.disconnected || g.is_connected());
    let part = format!("positive and proper, graphs of up to {most} vertices");
    let detail = "kernel of L spanned by 1, and |c_kj|^2 <= (N - 1) 2 N S by exact effective resistances";
    let bound = run.every(exhaustive(part, detail), graphs, |graph| {
        let most = rational(graph.order() as i64 - 1 + variant.excess, 1);
        let wrong = match graph.largest_resistance()? {
            None => Some("S = 0 though the centres differ".to_string()),
            Some(resistance) => (resistance > most).then(|| format!("|c_kj|^2 can be {resistance} times 2 N S")),
        };
        Ok(wrong.map(|what| format!("{}: {what}", described(&graph))))
    })?;
    let identities = identity_graphs(run)?.into_iter().map(|graph| {
        let part = format!("S is the sum over edges, {}", described(&graph));
        state_identity(edge_sum(&graph, variant.share), &["w0"], &part, run).on([1])
    });
    Run::all([Ok(bound.on([2, 3]))].into_iter().chain(identities))
}

pub fn spacing_form() -> Record<ProperVariant> {
    Record::new(
        "paley.eq17",
        "S = (1/(2N)) sum over edges |c_j - c_k|^2. It is zero iff c is constant along edges, that is, on a \
         connected graph, c = c_0 1. Along a path of l <= N - 1 edges from j to k, |c_kj|^2 <= l sum \
         |steps|^2 <= (N - 1) 2 N S, so that sublevel sets are bounded in the relative centres: S is \
         positive definite and proper. On a path N - 1 is attained by its ends.",
        ProperVariant::PRINTED,
        |variant, run| examine_proper(variant, run),
    )
    .clauses(&[
        "S is zero in the circular formation c = c_0 1 and positive otherwise.",
        "S is positive definite in the space of relative circle centers.",
        "S is proper in the space of relative circle centers.",
    ])
    .control("graphs that are not connected", ProperVariant::ANY_GRAPH)
    .altered("(N - 2) 2 N S as the bound", |v| v.excess = -1)
    .altered("1/N times the sum over edges", |v| v.share = (1, 1))
}

/// `cdot = e^{i theta} (1 + factor omega^power u)`.
#[derive(Clone, Copy)]
pub struct VelocityVariant {
    factor: i64,
    inverse: bool,
}

fn velocity_of_centre(variant: &VelocityVariant) -> StateIdentity<'_> {
    StateIdentity::of(1, move |[omega, u], state| {
        let moving = state.moving(std::slice::from_ref(u), &[]);
        let centre = &circle_centres(&Dual::constant(omega.clone()), &moving)?[0];
        let scale = if variant.inverse { omega.recip()? } else { omega.clone() };
        let speed = omega.one() + scale * u * omega.integer(variant.factor);
        let claimed = state.phasors[0].scale(&speed);
        Ok((vec![centre.re.derivative.clone(), centre.im.derivative.clone()], vec![claimed.re, claimed.im]))
    })
}

pub fn centre_velocity() -> Record<VelocityVariant> {
    Record::new(
        "paley.eq18",
        "cdot = rdot + w0^-1 i (i u e^{i theta}) = e^{i theta} - w0^-1 u e^{i theta}.",
        VelocityVariant { factor: -1, inverse: true },
        |variant, run| {
            state_identity(velocity_of_centre(variant), &["w0", "u"], "velocity of the centre", run).for_all()
        },
    )
    .altered("1 + u/w0", |v| v.factor = 1)
    .altered("1 - w0 u", |v| v.inverse = false)
}

/// `Sdot = (share/N) sum ...` and, under (20), `descent (K_0/N^2) sum ...^2`; on an undirected graph or not.
#[derive(Clone, Copy)]
pub struct DescentVariant {
    share: (i64, i64),
    descent: i64,
    undirected: bool,
}

impl DescentVariant {
    pub const PRINTED: Self = DescentVariant { share: (1, 1), descent: -1, undirected: true };
    pub const ONE_WAY: Self = DescentVariant { undirected: false, ..Self::PRINTED };
}

fn descent(variant: &DescentVariant, network: Neighbours) -> StateIdentity<'_> {
    StateIdentity::new(network.particles(), move |constants, state| {
        let [omega, gain, steering @ ..] = constants else {
            return Err(ArithmeticError::Domain("omega_0, K_0 and the steering"));
        };
        let particles = network.particles() as i64;
        let network = &network;
        let rate = |u: &[Probe]| -> Result<Probe, ArithmeticError> {
            Ok(spacing_potential(&Dual::constant(omega.clone()), network, &state.moving(u, &[]))?.derivative)
        };
        let forward = heading_components(network, &state.phasors, &circle_centres(omega, state)?);
        let inverse = omega.recip()?;
        let terms = forward.iter().zip(steering).map(|(f, u)| f.clone() * (omega.one() - u.clone() * &inverse));
        let (p, q) = variant.share;
        let sum = terms.fold(omega.zero(), |sum, term| sum + term) * omega.ratio(p, q * particles);
        let closed = spacing_control(omega, gain, network, state)?.into_iter().map(|u| u + omega);
        let descent = omega.ratio(variant.descent, particles * particles) * gain;
        let right = vec![sum, sum_of_squares(&forward, omega) * descent];
        Ok((vec![rate(steering)?, rate(&closed.collect::<Vec<_>>())?], right))
    })
    .allowing(|constants| constants[1] > rational(0, 1))
}

/// Whether `S` changes as the variant says.
pub fn examine_descent(variant: &DescentVariant, run: &Run) -> Result<Outcome, CheckError> {
    let networks: Vec<(Neighbours, String)> = if variant.undirected {
        identity_graphs(run)?.iter().map(|g| (Neighbours::of(g), described(g))).collect()
    } else {
        (2..=3).map(|n| (Neighbours::one_way_ring(n), format!("one-way ring of {n}"))).collect()
    };
    Run::all(networks.into_iter().map(|(network, name)| {
        let steering: Vec<String> = (1..=network.particles()).map(|k| format!("u_{k}")).collect();
        let names: Vec<String> = ["w0", "K_0"].map(String::from).into_iter().chain(steering).collect();
        state_identity(descent(variant, network), &names, &format!("rate of S for any u and under (20), {name}"), run)
            .on([1, 2, 3])
    }))
}

pub fn spacing_descent() -> Record<DescentVariant> {
    Record::new(
        "paley.eq19_20",
        "L is symmetric: Sdot = (1/N) <cdot, L c> = (1/N) sum <e^{i theta_k}, L_k c> (1 - u_k/w0) by (18). \
         Under (20), 1 - u_k/w0 = -(K_0/N) <e^{i theta_k}, L_k c>, for either sign of w0. This holds for all \
         undirected graphs; the identity is tested on small ones. On a directed graph (19) fails.",
        DescentVariant::PRINTED,
        |variant, run| examine_descent(variant, run),
    )
    .clauses(&[
        "Sdot = (1/N) sum_k <e^{i th_k}, L_k c> (1 - w0^{-1} u_k).",
        "Under (20), Sdot = -(K_0/N^2) sum_k <e^{i th_k}, L_k c>^2.",
        "For K_0 > 0 this is not positive.",
    ])
    .altered("1/(2N) in (19)", |v| v.share = (1, 2))
    .altered("Sdot >= 0", |v| v.descent = 1)
    .control("directed graphs", DescentVariant::ONE_WAY)
}
