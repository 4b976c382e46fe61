//! paley.sync.exp, paley.thm3.stab, paley.fig6.gain: which synchronised and symmetric circular formations are stable.
//!
//! `notes/paley_particles.md` proves: at a circular formation that is a relative equilibrium of (5) with (20) and the negative
//! gradient of a phase potential `U`, the linearisation has on the unstable side as many eigenvalues as the Hessian of `U` has
//! negative ones; it is exponentially stable up to the symmetries where that Hessian is positive definite up to rotation.

use super::instances::{connected_graphs, described, scattered_phasors};
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::{Inertia, inertia};
use arithmetic::Signed;
use models::oscillator::{
    CircularGains, FourierFormation, Neighbours, circular_control, circular_formation, linearisation, pattern_control,
    pattern_gradient, phase_jacobian, spacing_control, stability, symmetric_pattern,
};
use runs::PARTICLES;

/// paley.sync.exp and paley.fig6.gain: the synchronised circular formation under (22).
#[derive(Clone, Copy)]
pub struct SynchronyVariant {
    /// The sign of `K_1`.
    orientation: i64,
    /// The sign of `K_0`.
    spacing: i64,
    connected: bool,
}

impl SynchronyVariant {
    const STABLE: Self = SynchronyVariant { orientation: -1, spacing: 1, connected: true };
}

const SECTION: &str = "notes/paley_particles.md, Linearisation at a circular formation, steps 1 to 4";

/// Numerators and denominators of `w0` and `|K_1|`.
type Sizes = ((i64, i64), (i64, i64));

fn examine_synchrony(
    variant: &SynchronyVariant,
    graphs: &[Graph],
    sizes: &[Sizes],
    (section, run): (&str, &Run),
) -> Result<Outcome, CheckError> {
    let cases = graphs.iter().filter(|g| g.order() > 1).flat_map(|graph| sizes.iter().map(move |size| (graph, size)));
    let detail = "exact characteristic polynomials: 0 once, ± i w0 once, the others decay";
    let decays = run.instances("linearisation", detail, cases, |(graph, &((p, q), gain))| {
        let omega = rational(p, q);
        let gains = CircularGains {
            omega: omega.clone(),
            spacing: rational(variant.spacing, 10),
            orientation: rational(variant.orientation * gain.0, gain.1),
        };
        let network = Neighbours::of(graph);
        let phasors = vec![scattered_phasors(2)?[1].clone(); graph.order()];
        let state = circular_formation(&omega, &phasors)?;
        let constant = gains.constant();
        let rows = linearisation(&state, &omega, |state| circular_control(&constant, &network, &network, state))?;
        let found = stability(&rows, &omega, true)?;
        Ok((!found.stable || found.zeros != 1).then(|| {
            let how = if found.positive { "has a positive eigenvalue" } else { "does not decay up to the symmetries" };
            let text = format!(
                "{}, w0 = {omega}, K_0 = {}, K_1 = {}: the linearised synchronised circular formation {how}",
                described(graph),
                gains.spacing,
                gains.orientation
            );
            Counterexample::new(text, [Witness::networks(graph.order(), vec![graph.edges()])])
        }))
    });
    let decays = decays.checks("Linearisation at a circular formation, step 4");
    Run::all([argued(&[1], "every connected graph and all gains of these signs", section), decays])
}

pub fn synchrony_stable() -> Record<SynchronyVariant> {
    Record::new(
        "paley.sync.exp",
        "In the turning frame with c_k = (a_k + i b_k) e^{i theta}: v = w0 (K_0/N) L a + (K_1/N) L phi, \
         adot = w0 b - v/w0, bdot = -w0 a, phidot = v. On an eigenvector of L with eigenvalue lambda, k_m = \
         K_m lambda/N, the characteristic polynomial is s^3 + (k_0 - k_1) s^2 + w0^2 s - k_1 w0^2. By Routh \
         it is stable iff k_1 < 0 and (k_0 - k_1) w0^2 > -k_1 w0^2, that is k_0 > 0 (then k_0 - k_1 > 0). \
         So for K_0 > 0 and K_1 < 0, for either sign of w0, all but the symmetries decay exponentially \
         (lambda > 0 for all but the constant vector on a connected graph).",
        SynchronyVariant::STABLE,
        |variant, run| {
            let graphs =
                if variant.connected { connected_graphs(run.cases(0, 1) == 1)? } else { vec![Graph::empty(2)] };
            let sizes = [((1, 10), (1, 10)), ((-1, 10), (1, 10)), ((2, 1), (5, 1))];
            examine_synchrony(variant, &graphs, &sizes, (SECTION, run))
        },
    )
    .reading("Up to rotation and translation; K_0 > 0, as under (20).")
    .altered("K_1 > 0", |v| v.orientation = 1)
    .altered("K_1 = 0", |v| v.orientation = 0)
    .altered("K_0 < 0", |v| v.spacing = -1)
    .altered("a graph that is not connected", |v| v.connected = false)
}

pub fn drift_gain() -> Record<SynchronyVariant> {
    Record::new(
        "paley.fig6.gain",
        "In a drift common to all the relative motion is that without drift (paley.drift). By the cubic of \
         paley.sync.exp the product of the three eigenvalues of each mode is k_1 w0^2: for K_1 > 0 there is \
         a positive one on every connected graph with N >= 2, N = 12 included, so the synchronised circular \
         formation is not stabilised. (Checked at the printed values, N = 12, w0 = K_0 = 0.1, on C_12 and \
         all-to-all.) The caption contradicts the convention of the article (K_1 < 0 synchronises): a sign \
         slip.",
        SynchronyVariant { orientation: 1, ..SynchronyVariant::STABLE },
        |variant, run| {
            // The printed values. The caption names no network: the sparsest and the densest of the article.
            let graphs = [Graph::ring(PARTICLES), Graph::complete(PARTICLES)];
            let section = format!("{SECTION}, and Beacon and drift, step 5");
            examine_synchrony(variant, &graphs, &[((1, 10), (1, 10)), ((1, 10), (1, 1))], (&section, run))
        },
    )
    .repaired(
        Fault::Typo,
        "Under (22) on a connected undirected graph and up to the common drift, the synchronized circular formation is stabilized in a drift field: f_k = -0.1, N = 12, \
         w0 = K_0 = 0.1 and K_1 < 0.",
        SynchronyVariant::STABLE,
    )
    .altered("K_1 = 0", |v| v.orientation = 0)
    .altered("K_0 < 0", |v| v.spacing = -1)
}

/// Signs of the gains of (25) below `M` and at `M`, sign of `K_0`, and whether the spacing network is connected.
#[derive(Clone, Copy)]
pub struct PatternVariant {
    below: i64,
    last: i64,
    spacing: i64,
    connected: bool,
}

impl PatternVariant {
    fn gains<T: Field>(&self, clusters: usize, like: &T) -> Vec<T> {
        (1..=clusters)
            .map(|m| if m < clusters { like.integer(4 * self.below) } else { like.ratio(self.last, 3) })
            .collect()
    }

    /// That the spectral abscissae at the patterns of twelve particles are negative, and 0 is an eigenvalue once.
    fn decays(&self, run: &Run) -> Result<Outcome, CheckError> {
        const PART: &str = "abscissae of twelve particles";
        const ORDER: usize = 12;
        let reach = if self.connected { ORDER / 2 } else { 0 };
        let mut range: Option<Interval> = None;
        for omega in [rational(1, 10), rational(-2, 1)] {
            for clusters in (1..=ORDER).filter(|m| ORDER.is_multiple_of(*m)) {
                run.checkpoint()?;
                let spacing = rational(self.spacing, 10);
                let formation = FourierFormation::new(ORDER, 1..=reach, ORDER / clusters, (&omega, &spacing));
                let found = formation.with_moments(&self.gains(clusters, &omega)).transverse()?;
                let Some(found) = found.filter(|found| found.zeros == 1 && found.abscissa.is_certainly_negative())
                else {
                    let what = format!("M = {clusters}, N = {ORDER}, w0 = {omega}: the abscissa is not negative");
                    return Ok(Outcome::fails(what, certified(PART, "enclosures")));
                };
                range = Some(range.map_or_else(|| found.abscissa.clone(), |range| range.hull(&found.abscissa)));
            }
        }
        let range = range.ok_or_else(|| CheckError::NoCases(PART.to_string()))?;
        let range = interval_value(&range, 4);
        let detail = format!("all M: spectral abscissae in {range} for w0 = 1/10 and -2 (beyond.paley.abscissa)");
        holds(certified(PART, detail).cases(12).on([3]))
    }
}

pub fn pattern_stable() -> Record<PatternVariant> {
    Record::new(
        "paley.thm3.stab",
        "At an (M,N)-pattern the Hessian of U_m, m < M, is (1/N)(cos m theta_kj), positive semidefinite, \
         and that of U_M is -(I - J/N): the Hessian of (25) is at least |K_M| (I - J/N), positive definite \
         up to rotation, for every M dividing N. With V = K_0 S + w0^-2 U and Vdot = -w0^-2 sum (u_k - \
         w0)^2 (paley.VMN) the quadratic parts give a linearisation whose only eigenvalues off the left \
         half plane are the three of the symmetries: exponentially stable and isolated, for either sign of \
         w0.",
        PatternVariant { below: 1, last: -1, spacing: 1, connected: true },
        examine_pattern_stable,
    )
    .clauses(&[
        "Each (M,N)-pattern circular formation of radius |w0|^{-1} is a relative equilibrium under the \
         control law.",
        "It is isolated.",
        "It is exponentially stabilized.",
    ])
    .reading(
        "In shape space, that is, up to rotation and translation; (20) with K_0 > 0 on a connected \
         undirected graph, w0 != 0.",
    )
    .altered("K_M > 0", |v| v.last = 1)
    .altered("K_m < 0 below M", |v| v.below = -1)
    .altered("K_0 < 0", |v| v.spacing = -1)
    .altered("spacing network not connected", |v| v.connected = false)
}

fn examine_pattern_stable(variant: &PatternVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let small = [(1, 1, 0), (2, 1, 0), (2, 2, 0), (3, 1, 1), (4, 1, 0), (4, 2, 0), (4, 2, 1), (4, 4, 0), (4, 4, 1)];
    let small = small.into_iter().flat_map(|formation| [(1, 10), (-2, 1)].map(|omega| (formation, omega)));
    let detail = "exact characteristic polynomials, M = 1, 2, 4, N up to 4: 0 once, ± i w0 once, the others decay";
    let linearised =
        run.instances("linearisation of small patterns", detail, small, |((order, clusters, spacing), (p, q))| {
            let graph = match (variant.connected, spacing) {
                (false, _) => Graph::empty(order),
                (true, 0) => Graph::complete(order),
                (true, _) => Graph::path(order),
            };
            let omega = rational(p, q);
            let quarter = [(1, 0), (0, 1), (-1, 0), (0, -1)].map(|(x, y)| Complex::new(rational(x, 1), rational(y, 1)));
            let phasors: Vec<_> = (0..order).map(|k| quarter[k % clusters * (4 / clusters)].clone()).collect();
            let network = Neighbours::of(&graph);
            let rows = linearisation(&circular_formation(&omega, &phasors)?, &omega, |state| {
                let like = Dual::constant(omega.clone());
                let pulled = spacing_control(&like, &like.ratio(variant.spacing, 10), &network, state)?;
                let turned = pattern_control(&variant.gains(clusters, &like), &state.phasors)?;
                Ok(pulled.into_iter().zip(turned).map(|(s, o)| s + o).collect())
            })?;
            let found = stability(&rows, &omega, true)?;
            Ok((!found.stable || found.zeros != 1).then(|| {
                let graph = described(&graph);
                format!(
                    "M = {clusters}, spacing {graph}, w0 = {omega}, K_0 = {}/10, K_m = {} for m < M, K_M = {}: the \
                     linearisation does not decay up to the symmetries",
                    variant.spacing, variant.below, variant.last
                )
            }))
        });
    let orders = (1..=run.cases(4, 11)).chain([12]);
    let patterns = orders.flat_map(|order| (1..=order).filter(move |m| order % m == 0).map(move |m| (m, order)));
    let detail = "inertia (N - 1, 0, 1) over exact cosines, N up to 4 (11 in full runs) and 12, all M";
    let hessians = exhaustive("Hessian of (25)", detail);
    let hessians = run.every(hessians, patterns, |(clusters, order)| {
        let phasors = symmetric_pattern(clusters as u32, order as u32).unwrap_or_default();
        let hessian = phase_jacobian(&phasors, |z| pattern_gradient(&variant.gains(clusters, &z[0].re), z))?;
        let found = inertia(&hessian)?;
        Ok((found != Inertia { positive: order - 1, negative: 0, zero: 1 }).then(|| {
            format!(
                "M = {clusters}, N = {order}: the Hessian of (25) has {} negative eigenvalues and zero {} times",
                found.negative, found.zero
            )
        }))
    });
    let section = "notes/paley_particles.md, Linearisation at a circular formation, steps 1 to 3 and 5";
    Run::all([
        argued(&[1, 2, 3], "all M and N", section),
        linearised.on([1, 2, 3]).checks("the conclusion"),
        hessians.on([2, 3]).checks("step 5"),
        variant.decays(run).checks("the conclusion"),
    ])
}
