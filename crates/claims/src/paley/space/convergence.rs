//! paley.thm2, paley.thm2.center: what solutions under the spacing control converge to.

use super::instances::{StateIdentity, described, identity_graphs, scattered_phasors, state_identity};
use super::spacing::{DescentVariant, ProperVariant, examine_descent, examine_proper};
use crate::prelude::*;
use models::oscillator::{
    Interaction, Neighbours, circle_centres, circular_formation, heading_components, linearisation, mean, quarter_turn,
    spacing_control, stability,
};

/// The rate of `sigma_k = <e^{i theta_k}, L_k c>` under (20) is `rate w0 <i e^{i theta_k}, L_k c>` up to terms with a factor `sigma_j`, and
/// `|L_k c|^2 = sigma_k^2 + <i e^{i theta_k}, L_k c>^2`.
fn on_limit_set(network: Neighbours, rate: i64) -> StateIdentity<'static> {
    StateIdentity::of(network.particles(), move |[omega, gain], state| {
        let share = omega.ratio(1, network.particles() as i64) * gain;
        let network = &network;
        let control = spacing_control(omega, gain, network, state)?;
        let total: Vec<Probe> = control.iter().map(|u| u.clone() + omega).collect();
        let moving = state.moving(&total, &[]);
        let centres = circle_centres(&Dual::constant(omega.clone()), &moving)?;
        let mut left: Vec<Probe> =
            heading_components(network, &moving.phasors, &centres).into_iter().map(|s| s.derivative).collect();
        let centres = circle_centres(omega, state)?;
        let sigma = heading_components(network, &state.phasors, &centres);
        let turned: Vec<_> = state.phasors.iter().map(quarter_turn).collect();
        let tau = heading_components(network, &turned, &centres);
        // cdot_j = -(K_0/N) sigma_j e^{i theta_j}
        let pulled: Vec<_> = state.phasors.iter().zip(&sigma).map(|(z, s)| z.scale(&-(s.clone() * &share))).collect();
        let with_sigma = heading_components(network, &state.phasors, &pulled);
        let mut right = Vec::new();
        for ((tau, u), rest) in tau.iter().zip(&control).zip(with_sigma) {
            right.push((omega.clone() * omega.integer(rate) + u) * tau + rest);
        }
        for ((s, t), lc) in sigma.iter().zip(&tau).zip(network.laplacian_of(&centres)) {
            left.push(lc.norm_squared());
            right.push(s.square() + t.square());
        }
        Ok((left, right))
    })
}

/// paley.thm2 and paley.thm2.center.
#[derive(Clone, Copy)]
pub struct ConvergenceVariant {
    /// `K_0`.
    gain: i64,
    /// What makes `S` proper.
    proper: ProperVariant,
    /// The rate of `S`.
    descent: DescentVariant,
    /// The limit turns at this multiple of `omega`.
    rate: i64,
    /// The mean of the centres is conserved.
    mean_conserved: bool,
    /// The centre of mass is fixed.
    mass_fixed: bool,
}

impl ConvergenceVariant {
    const PRINTED: Self = ConvergenceVariant {
        gain: 1,
        proper: ProperVariant::PRINTED,
        descent: DescentVariant::PRINTED,
        rate: 1,
        mean_conserved: false,
        mass_fixed: false,
    };
}

fn examine_convergence(variant: &ConvergenceVariant, run: &Run) -> Result<Outcome, CheckError> {
    let limits = Run::all(identity_graphs(run)?.into_iter().map(|graph| {
        let part = format!("on the limit set L_k c = 0, {}", described(&graph));
        state_identity(on_limit_set(Neighbours::of(&graph), variant.rate), &["w0", "K_0"], &part, run)
    }))?;
    Run::all([Ok(limits).checks("steps 3 and 4"), examine_return(variant, run).checks("the conclusion")])
}

/// Whether all that is no symmetry and no phase decays near circular formations.
fn examine_return(variant: &ConvergenceVariant, run: &Run) -> Result<Outcome, CheckError> {
    let graphs = identity_graphs(run)?;
    let cases = graphs.iter().flat_map(|graph| [(1, 10), (-3, 2)].map(|omega| (graph, omega)));
    let detail = "turning-frame linearisation: N zeros for the phases, ± i w0 for the translations, all else decays; \
     both signs of w0";
    run.instances("exponential approach near formations", detail, cases, |(graph, (p, q))| {
        let omega = rational(p, q);
        let network = Neighbours::of(graph);
        let state = circular_formation(&omega, &scattered_phasors(graph.order())?)?;
        let rows = linearisation(&state, &omega, |state| {
            let like = Dual::constant(omega.clone());
            spacing_control(&like, &Dual::constant(rational(variant.gain, 1)), &network, state)
        })?;
        let found = stability(&rows, &omega, true)?;
        Ok((!found.stable || found.zeros != graph.order()).then(|| {
            format!(
                "{}, K_0 = {}, w0 = {omega}: near a circular formation there are {} directions without change and \
                 the others do not all decay",
                described(graph),
                variant.gain,
                found.zeros
            )
        }))
    })
}

pub fn theorem2() -> Record<ConvergenceVariant> {
    Record::new(
        "paley.thm2",
        "S is proper in the relative centres (eq17) and does not increase (eq19_20), and the relative \
         centres with the phases move on their own: LaSalle applies to every solution. Where Sdot = 0 for \
         all time, sigma_k = <e^{i theta_k}, L_k c> = 0, so u = w0, and the rate of sigma_k is then w0 <i \
         e^{i theta_k}, L_k c>, which vanishes too: L_k c = 0 for all k, c = c_0 1, a circle of radius \
         1/|w0| turned at w0. States with sigma = 0 and unequal centres exist but are not invariant. K_0 > \
         0 as under (20).",
        ConvergenceVariant::PRINTED,
        examine_theorem2,
    )
    .clauses(&[
        "All of the solutions converge to the set of circular formations with radius |w0|^{-1}.",
        "Their direction of rotation is determined by the sign of w0.",
    ])
    .altered("K_0 = -1", |v| v.gain = -1)
    .altered("graphs that are not connected", |v| v.proper = ProperVariant::ANY_GRAPH)
    .altered("directed graphs", |v| v.descent = DescentVariant::ONE_WAY)
    .altered("rotation at 2 w0", |v| v.rate = 2)
}

fn examine_theorem2(variant: &ConvergenceVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let limit = examine_convergence(variant, run)?;
    if !matches!(limit, Outcome::Holds(_)) {
        return Ok(limit);
    }
    Run::all([
        argued(&[1, 2], "every solution", "notes/paley_particles.md, Theorem 2, steps 1-4"),
        Ok(limit.on([1, 2])),
        examine_proper(&variant.proper, run).checks("step 1").on([1]),
        examine_descent(&variant.descent, run).checks("step 1").on([1]),
    ])
}

/// The rate of the mean centre under (20) is zero.
fn mean_centre() -> StateIdentity<'static> {
    StateIdentity::of(2, move |[omega, gain], state| {
        let control = spacing_control(omega, gain, &Neighbours::complete(2), state)?;
        let total: Vec<Probe> = control.into_iter().map(|u| u + omega).collect();
        let centre = mean(&circle_centres(&Dual::constant(omega.clone()), &state.moving(&total, &[]))?)?;
        Ok((vec![centre.re.derivative, centre.im.derivative], vec![omega.zero(), omega.zero()]))
    })
}

pub fn fixed_centre() -> Record<ConvergenceVariant> {
    Record::new(
        "paley.thm2.center",
        "The limit set is that of Theorem 2. Once the sigma_k are small, S - (d/w0) sum_k <e^{i theta_k}, L_k \
         c><i e^{i theta_k}, L_k c> with a small d > 0 decreases at a rate proportional to itself (notes), \
         so S decays exponentially and sqrt(S), |sigma| and |cdot_k| are integrable: each c_k converges to \
         one c_0, which is fixed, and which the closed loop determines from the initial state alone \
         (nothing in the law names a place). It is not the initial mean of the centres. The centre of mass \
         is c_0 - (i/w0) p_theta and turns unless p_theta = 0.",
        ConvergenceVariant::PRINTED,
        examine_fixed_centre,
    )
    .clauses(&[
        "In the limit set thdot = w0 1 and c = c_0 1.",
        "The steady-state center c_0 depends only on the initial state.",
        "It is fixed.",
        "The center of mass is not necessarily fixed.",
    ])
    .reading(
        "c_0 depends on the initial state for the given law and gains; it is not the initial mean of the \
         circle centres.",
    )
    .altered("c_0 is the mean of the initial centres", |v| v.mean_conserved = true)
    .altered("the centre of mass is fixed", |v| v.mass_fixed = true)
    .altered("the limit turns at 2 w0", |v| v.rate = 2)
}

fn examine_fixed_centre(variant: &ConvergenceVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let velocity = mean(&circular_formation(&rational(1, 10), &scattered_phasors(2)?)?.phasors)?;
    let speed = velocity.norm_squared();
    let exact = |detail: String| exact("centre of mass", detail);
    if variant.mass_fixed && speed != rational(0, 1) {
        let what = format!("two particles on a circle: the centre of mass has the squared speed {speed}");
        return Ok(Outcome::fails(what, exact("an exact circular formation".to_string())));
    }
    let moving = Outcome::Holds(vec![exact(format!("squared speed {speed} in a formation of two")).on([4]).for_all()]);
    let conserved = match variant.mean_conserved {
        true => state_identity(mean_centre(), &["w0", "K_0"], "the mean centre is conserved", run),
        false => Ok(moving),
    };
    let steps = |of: &str| format!("notes/paley_particles.md, Theorem 2, steps {of}");
    let limit_set = argued(&[1], "the limit set of every solution", &steps("1-4"));
    Run::all([
        limit_set,
        argued(&[2, 3], "one fixed centre", &steps("5-8")),
        conserved,
        examine_convergence(variant, run).on([1, 3]),
    ])
}
