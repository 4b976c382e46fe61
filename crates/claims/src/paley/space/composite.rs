//! paley.eq21, paley.eq22, paley.VMN, paley.eq29: composite potentials and controls.

use super::instances::{StateIdentity, described, identity_graphs, state_identity, sum_of_squares};
use crate::prelude::*;
use algebra::graph::Graph;
use models::oscillator::{
    CircularGains, Neighbours, State, circle_centres, circular_control, composite_potential, heading_components,
    misalignment, pattern_control, pattern_potential, phasor, relative_position_control, spacing_control,
    spacing_potential,
};

fn gains<T: Field>(constants: &[T]) -> Result<CircularGains<T>, ArithmeticError> {
    let [omega, spacing, orientation] = constants else { return Err(ArithmeticError::Domain("omega_0, K_0 and K_1")) };
    Ok(CircularGains { omega: omega.clone(), spacing: spacing.clone(), orientation: orientation.clone() })
}

/// `omega` to a power that may be negative.
fn power<T: Field>(omega: &T, exponent: i64) -> Result<T, ArithmeticError> {
    let size = omega.power(exponent.unsigned_abs());
    if exponent < 0 { size.recip() } else { Ok(size) }
}

/// `V = K_0 S + sign K_1 omega^exponent W_1` and `Vdot = -(1/N^2) sum (K_0 sigma_k + cross K_1 tau_k/omega)^2`.
#[derive(Clone, Copy)]
pub struct CompositeVariant {
    sign: i64,
    exponent: i64,
    cross: i64,
}

fn composite(variant: &CompositeVariant, network: Neighbours) -> StateIdentity<'_> {
    StateIdentity::new(network.particles(), move |constants, state| {
        // The half of w0 is the variable: at |w0| = 1, where a counterexample is looked for first, one power is as good as another.
        let mut g = gains(constants)?;
        g.omega = g.omega.integer(2) * &g.omega;
        let (network, particles) = (&network, network.particles() as i64);
        let moving = state.moving(&circular_control(&g, network, network, state)?, &[]);
        let weight = power(&g.omega, variant.exponent)? * &g.orientation * g.omega.integer(variant.sign);
        let constant = |x: &Probe| Dual::constant(x.clone());
        let v =
            composite_potential(&constant(&g.omega), (&constant(&g.spacing), &constant(&weight)), network, &moving)?;
        let sigma = heading_components(network, &state.phasors, &circle_centres(&g.omega, state)?);
        let tau = misalignment(network, &state.phasors);
        let turned = g.omega.recip()? * &g.orientation * g.omega.integer(variant.cross);
        let terms: Vec<Probe> =
            sigma.iter().zip(&tau).map(|(s, t)| s.clone() * &g.spacing + t.clone() * &turned).collect();
        Ok((vec![v.derivative], vec![sum_of_squares(&terms, &g.omega) * g.omega.ratio(-1, particles * particles)]))
    })
    .allowing(|constants| constants[1] > rational(0, 1))
}

pub fn composite_descent() -> Record<CompositeVariant> {
    Record::new(
        "paley.eq21",
        "With sigma_k = <e^{i theta_k}, L_k c>, tau_k = <i e^{i theta_k}, L_k e^{i theta}>: Sdot = (1/N) \
         sum sigma_k (1 - u_k/w0), and W_1dot = (1/N) sum tau_k (u_k - w0) because sum tau_k = 0. So \
         (d/dt)(K_0 S + a W_1) = (1/N) sum (a tau_k - K_0 sigma_k/w0)(u_k - w0), and (22) is u_k - w0 = \
         (w0/N)(K_0 sigma_k + K_1 tau_k/w0): the printed negative sum of squares results exactly for a = \
         -K_1/w0^2, and for every other a the rate is indefinite. With the printed a = K_1/w0 the W_1 part \
         has the wrong sign for w0 > 0: at K_1 > 0 the control (14) increases W_1. V = K_0 S - K_1 w0^-2 \
         W_1 is what (22) decreases, in agreement with synchronisation for K_1 < 0.",
        CompositeVariant { sign: 1, exponent: -1, cross: 1 },
        |variant, run| {
            Run::all(identity_graphs(run)?.into_iter().map(|graph| {
                let part = format!("Vdot under (22), {}", described(&graph));
                let tested =
                    state_identity(composite(variant, Neighbours::of(&graph)), &["w0/2", "K_0", "K_1"], &part, run);
                tested.map(|outcome| outcome.seen(Witness::networks(graph.order(), vec![graph.edges()])))
            }))
        },
    )
    .repaired(
        Fault::Slip,
        "V = K_0 S - K_1 w0^-2 W_1; along (1), (2) with (22), Vdot = -(1/N^2) sum_k (K_0 <e^{i th_k}, L_k \
         c> + K_1 w0^-1 <i e^{i th_k}, L_k e^{i th}>)^2, for all w0 != 0 and every undirected graph.",
        CompositeVariant { sign: -1, exponent: -2, cross: 1 },
    )
    .altered("-K_1/w0 in V", |v| v.exponent = -1)
    .altered("+K_1/w0^2 in V", |v| v.sign = 1)
    .altered("the difference squared", |v| v.cross = -1)
}

/// paley.eq22 and paley.eq29: (5) with (14) and (20) equals `omega + (alignment/N) tau^ori + (rest/N) tau^att + omega (spacing K_0/N)
/// <e^{i theta_k}, L_k^att r>` with `alignment = a K_1 + b K_0` and `rest = c K_0`.
#[derive(Clone, Copy)]
pub struct FormVariant {
    alignment: (i64, i64),
    rest: i64,
    spacing: i64,
}

fn form(variant: &FormVariant, orientation: Neighbours, attraction: Neighbours) -> StateIdentity<'_> {
    StateIdentity::new(orientation.particles(), move |constants, state| {
        let g = gains(constants)?;
        let (variant, attraction) = (&variant, &attraction);
        let integer = |n: i64| g.omega.integer(n);
        let alignment = integer(variant.alignment.0) * &g.orientation + integer(variant.alignment.1) * &g.spacing;
        let spacing = integer(variant.spacing) * &g.spacing;
        let form = relative_position_control(&g.omega, (&alignment, &orientation), (&spacing, attraction), state)?;
        let rest = g.omega.ratio(variant.rest, orientation.particles() as i64) * &g.spacing;
        let turned = misalignment(attraction, &state.phasors);
        let right = form.into_iter().zip(turned).map(|(u, tau)| u + tau * &rest).collect();
        Ok((circular_control(&g, &orientation, attraction, state)?, right))
    })
    .allowing(|constants| constants[1] > rational(0, 1))
}

const CONSTANTS: [&str; 3] = ["w0", "K_0", "K_1"];

pub fn circular_form() -> Record<FormVariant> {
    Record::new(
        "paley.eq22",
        "c = r + w0^-1 i e^{i theta}, and <z, i y> = -<i z, y>: w0 (K_0/N) <e^{i theta_k}, L_k c> = w0 \
         (K_0/N) <e^{i theta_k}, L_k r> - (K_0/N) <i e^{i theta_k}, L_k e^{i theta}>. It holds for directed \
         networks too.",
        FormVariant { alignment: (1, -1), rest: 0, spacing: 1 },
        examine_circular_form,
    )
    .altered("K_1 + K_0", |v| v.alignment = (1, 1))
    .altered("K_1 alone", |v| v.alignment = (1, 0))
    .altered("minus the spacing term", |v| v.spacing = -1)
}

fn examine_circular_form(variant: &FormVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let undirected = identity_graphs(run)?.into_iter().map(|g| (Neighbours::of(&g), described(&g)));
    let networks = undirected.chain([(Neighbours::one_way_ring(3), "one-way ring of 3".to_string())]);
    Run::all(networks.map(|(network, name)| {
        let identity = form(variant, network.clone(), network);
        state_identity(identity, &CONSTANTS, &format!("(5) with (14) and (20), {name}"), run)
    }))
}

pub fn two_networks() -> Record<FormVariant> {
    Record::new(
        "paley.eq29",
        "(5) with (14) on the orientation network and (20) on the attraction network: in the coefficient \
         K_1 - K_0 of (22), K_1 comes from (14) and -K_0 from the circle centres in (20), so it is -(K_0/N) \
         <i e^{i theta_k}, L_k^att e^{i theta}>. (29) puts it on the orientation network. It is the same \
         control only where K_0 = 0 or both terms agree. Under (29) as printed circular formations need not \
         be equilibria when K_1 = 0 (two particles that see but do not align, at a quarter turn), and at \
         K_1 = K_0 the orientation network has no effect at all.",
        FormVariant { alignment: (1, -1), rest: 0, spacing: 1 },
        examine_two_networks,
    )
    .repaired(
        Fault::False,
        "u_k = w0 + (K_1/N) <i e^{i th_k}, L_k^ori e^{i th}> - (K_0/N) <i e^{i th_k}, L_k^att e^{i th}> + \
         w0 (K_0/N) <e^{i th_k}, L_k^att r>, that is, (5) with (14) on L^ori and (20) on L^att.",
        FormVariant { alignment: (1, 0), rest: -1, spacing: 1 },
    )
    .altered("-K_0 on both networks", |v| v.alignment = (1, -1))
    .altered("+K_0 on the attraction network", |v| v.rest = 1)
    .altered("no K_0 in the alignment", |v| v.rest = 0)
}

fn examine_two_networks(variant: &FormVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // On one network for both, (29) as printed is (22).
    let pairs = [
        ("all pairs, two particles", Neighbours::complete(2), Neighbours::complete(2)),
        ("no orientation, two particles", Neighbours::of(&Graph::empty(2)), Neighbours::complete(2)),
        ("path and triangle", Neighbours::of(&Graph::path(3)), Neighbours::complete(3)),
        ("one-way ring and triangle", Neighbours::one_way_ring(3), Neighbours::complete(3)),
        ("ring and all pairs, four particles", Neighbours::circulant(4, &[1]), Neighbours::complete(4)),
    ];
    Run::all(pairs.into_iter().map(|(name, orientation, attraction)| {
        state_identity(
            form(variant, orientation, attraction),
            &CONSTANTS,
            &format!("(5) with (14) and (20), {name}"),
            run,
        )
    }))
}

/// `V = K_0 S + omega^exponent U^{M,N}` decreases, at the rate `-omega^rate sum (u_k - omega)^2`.
#[derive(Clone, Copy)]
pub struct WeightVariant {
    exponent: i64,
    rate: i64,
}

/// The rate of `V`, all-to-all, and what it is said to be.
fn pattern_rates<T: Field>(
    variant: &WeightVariant,
    constants: &[T],
    state: &State<T>,
) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
    let [omega, spacing, gains @ ..] = constants else {
        return Err(ArithmeticError::Domain("omega_0, K_0 and the gains of the pattern"));
    };
    let network = Neighbours::complete(state.phasors.len());
    let pulled = spacing_control(omega, spacing, &network, state)?;
    let excess: Vec<T> = pulled.into_iter().zip(pattern_control(gains, &state.phasors)?).map(|(s, o)| s + o).collect();
    let steering: Vec<T> = excess.iter().map(|u| u.clone() + omega).collect();
    let moving = state.moving(&steering, &[]);
    let constant = |x: &T| Dual::constant(x.clone());
    let gains: Vec<Dual<T>> = gains.iter().map(constant).collect();
    let u = pattern_potential(&gains, &moving.phasors)? * constant(&power(omega, variant.exponent)?);
    let v = spacing_potential(&constant(omega), &network, &moving)? * constant(spacing) + u;
    Ok((vec![v.derivative], vec![-(sum_of_squares(&excess, omega) * power(omega, variant.rate)?)]))
}

pub fn pattern_composite() -> Record<WeightVariant> {
    let printed = WeightVariant { exponent: 0, rate: -2 };
    let right = WeightVariant { exponent: -2, ..printed };
    Record::new(
        "paley.VMN",
        "With y_k = (K_0/N) sigma_k and g_k = dU/dtheta_k, u_k - w0 = w0 y_k - g_k and (d/dt)(K_0 S + a U) \
         = sum_k (-y_k/w0 + a g_k)(w0 y_k - g_k). For a = w0^-2 this is -w0^-2 sum_k (u_k - w0)^2. For the \
         printed a = 1 it is sum_k (-y_k^2 + (w0 + 1/w0) y_k g_k - g_k^2), which is positive at some states unless \
         |w0| = 1 (the discriminant (w0 + 1/w0)^2 - 4 = (w0 - 1/w0)^2), and except for N = M = 2 also at states as near \
         to the pattern as one likes. The factor w0^-2 is missing; the argument theta too.",
        printed,
        examine_pattern_composite,
    )
    .reading("V proves Theorem 3 by Lyapunov's method only if it does not increase.")
    .repaired(
        Fault::Slip,
        "For w0 != 0, V^{M,N}(r, theta) = K_0 S(r, theta) + w0^-2 U^{M,N}(theta) has Vdot = -w0^-2 sum_k (u_k - w0)^2 along (5) with (20) \
         and minus the gradient of (25), on any undirected graph, for any gains: it does not increase.",
        right,
    )
    .control("U/w0", WeightVariant { exponent: -1, ..printed })
    .altered("Vdot = -sum (u_k - w0)^2", |v| v.rate = 0)
}

fn examine_pattern_composite(variant: &WeightVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence = |detail: &str| exact("V does not increase", detail.to_string());
    let mut states = 0;
    for (p, q) in [(1, 10), (2, 1), (-1, 10)] {
        for (x, t) in [(0, 1), (1, 1), (-1, 1), (1, 2), (-3, 1), (5, -1), (30, 1), (-30, 1)] {
            let state = State {
                positions: vec![Complex::real(rational(0, 1)), Complex::real(rational(x, 1))],
                phasors: vec![Complex::real(rational(1, 1)), phasor(&rational(t, 2))?],
            };
            let constants = [(p, q), (1, 10), (1, 1), (-1, 2)].map(|(a, b)| rational(a, b));
            let rate = pattern_rates(variant, &constants, &state)?.0.swap_remove(0);
            states += 1;
            if rate > rational(0, 1) {
                let what = format!(
                    "N = M = 2, w0 = {}, K_0 = 1/10, K_1 = 1, K_2 = -1/2, r = (0, {x}), theta = (0, 2 arctan({t}/2)): \
                     Vdot = {rate} > 0",
                    constants[0]
                );
                return Ok(Outcome::fails(what, evidence("an exact state")));
            }
        }
    }
    let cases = [(1, 1), (2, 1), (2, 2), (3, 3)];
    let identities = cases.into_iter().take(run.cases(3, 4)).map(|(particles, clusters)| {
        let identity = StateIdentity::new(particles, |constants, state| pattern_rates(variant, constants, state));
        let gains = (1..=clusters).map(|m| format!("K_{m}"));
        let names: Vec<String> = ["w0", "K_0"].map(String::from).into_iter().chain(gains).collect();
        let part = format!("the rate of V, M = {clusters}, N = {particles}");
        state_identity(identity, &names, &part, run)
    });
    let sampled = holds(evidence("exact states of two particles").cases(states));
    Run::all(identities.chain([sampled]))
}
