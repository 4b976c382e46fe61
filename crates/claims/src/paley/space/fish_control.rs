//! paley.eq28, paley.fish28ori: the steering of a fish beside the circular control.

use super::instances::{StateIdentity, described, identity_graphs, state_identity};
use crate::prelude::*;
use models::oscillator::{
    CircularGains, Neighbours, alignment, attraction, circle_centres, circular_control, circular_formation,
    heading_components, misalignment, phasor, quarter_turn, repulsion, steering_towards,
};

/// `u = w + orientation K_ori <i z, L^ori z> + attraction K_att <i z, L^att r>` for (27) with `v^att = field sum r_kj`, or with `rhat_kj`.
#[derive(Clone, Copy)]
pub struct FormVariant {
    orientation: i64,
    attraction: i64,
    field: i64,
    /// Whether (27) has the unit vectors, at any distance, and not `r_kj` in their place.
    units: bool,
    /// The distance of a neighbour at which the two are said to differ.
    apart: i64,
}

/// Both sides of the identities of [`printed_forms`].
type Sides = (Vec<Probe>, Vec<Probe>);

/// The first fish with two neighbours: (27), (28), and what the terms do. The neighbours are at `r_1 - d_j e^{i psi_j}`.
fn forms(variant: &FormVariant, at: &[Probe]) -> Result<Sides, ArithmeticError> {
    let [k_ori, k_att, distance, other, own, tangents @ ..] = at else {
        return Err(ArithmeticError::Domain("ten variables"));
    };
    let phasors: Vec<Complex<Probe>> = tangents[..3].iter().map(phasor).collect::<Result<_, _>>()?;
    let units: Vec<Complex<Probe>> = tangents[3..].iter().map(phasor).collect::<Result<_, _>>()?;
    let apart = [units[0].scale(distance), units[1].scale(other)];
    let origin = Complex::real(own.zero());
    let positions: Vec<Complex<Probe>> = [origin].into_iter().chain(apart.iter().map(|r| -r.clone())).collect();
    let z = &phasors[0];
    let network = Neighbours::complete(3);
    let integer = |n: i64| own.integer(n);
    // (27) with the printed or the corrected field of attraction, and r_kj for rhat_kj.
    let away: &[Complex<Probe>] = if variant.units { &units } else { &apart };
    let desired = |away: &[Complex<Probe>]| {
        alignment(z, &phasors[1..]).scale(k_ori) + repulsion(z, away).scale(&integer(variant.field)).scale(k_att)
    };
    let steering = own.clone() + steering_towards(z, &desired(away));
    // (28)
    let aligning = misalignment(&network, &phasors)[0].clone() * k_ori * integer(variant.orientation);
    let turned: Vec<Complex<Probe>> = phasors.iter().map(quarter_turn).collect();
    let attracting = heading_components(&network, &turned, &positions)[0].clone() * k_att * integer(variant.attraction);
    let form = own.clone() + &aligning + &attracting;
    // The terms steer towards sum (r_j - r_k) and sum e^{i theta_j}.
    let towards = -(apart[0].clone() + &apart[1]);
    let mates = phasors[1].clone() + &phasors[2];
    let left = vec![steering, steering_towards(z, &towards) * k_att, steering_towards(z, &mates) * k_ori];
    Ok((left, vec![form, attracting, aligning]))
}

fn printed_forms(variant: &FormVariant) -> Identity<'_> {
    Identity::new(10, move |at| forms(variant, at)).within(|at| at[..4].iter().all(|x| *x > rational(0, 1))).named([
        "(27) and (28)",
        "steering towards the neighbours",
        "steering to their headings",
    ])
}

/// (27) with the unit vectors, and (28), where both neighbours are at the distance 1.
fn at_distance_one(variant: &FormVariant) -> Identity<'_> {
    let with_units = FormVariant { units: true, ..*variant };
    Identity::new(8, move |at| {
        let [k_ori, k_att, tail @ ..] = at else {
            return Err(ArithmeticError::Domain("eight variables"));
        };
        let one = k_ori.integer(1);
        let all: Vec<Probe> = [k_ori, k_att, &one, &one].into_iter().chain(tail).cloned().collect();
        let (mut left, mut right) = forms(&with_units, &all)?;
        left.truncate(1);
        right.truncate(1);
        Ok((left, right))
    })
    .within(|at| at[..2].iter().all(|x| *x > rational(0, 1)))
}

pub fn laplacian_form() -> Record<FormVariant> {
    Record::new(
        "paley.eq28",
        "<i z, z + sum z_j> = -<i z, L_k^ori z>: the alignment term is exact. sum r_kj = L_k^att r, so (28) \
         follows from (27) with the printed v^att and r_kj for rhat_kj, whose sign is wrong (paley.vatt): \
         K_att <i z, L_k^att r> steers along r_k - mean of the neighbours, away from them. The attraction \
         behaviour is -K_att <i z, L_k^att r>. The error against (27) is K_att <i z, sum (1 - \
         1/|r_kj|) r_kj> up to sign: zero where all neighbours are at distance 1, and half of (28) for one \
         neighbour at distance 2.",
        FormVariant { orientation: -1, attraction: 1, field: 1, units: false, apart: 2 },
        examine_laplacian_form,
    )
    .clauses(&[
        "(28) is (27), approximated.",
        "The K_att term is the attraction behavior.",
        "The K_ori term is the alignment behavior.",
    ])
    .reading("\"Approximated\" means r_kj in the place of rhat_kj.")
    .repaired(Fault::Slip, "", FormVariant { orientation: -1, attraction: -1, field: -1, units: false, apart: 2 })
    .repaired_clauses(&[
        "If the repulsion zone of fish k is empty, with r_kj = r_k - r_j in the place of rhat_kj and v_k^att = - sum r_kj, (27) is u_k = \
         w_k - K_ori <i e^{i th_k}, L_k^ori e^{i th}> - K_att <i e^{i th_k}, L_k^att r>.",
        "For K_att > 0 its K_att term steers towards the sum of the r_j - r_k over the neighbours in the zone of attraction.",
        "For K_ori > 0 its K_ori term steers towards the sum of the headings of the neighbours in the zone of orientation.",
        "With an empty zone of repulsion, no neighbour at r_k and v_k^att = - sum rhat_kj in (27) this law is (27) itself where every \
         neighbour in the zone of attraction is at the distance 1, and in general it is not.",
    ])
    .altered("(28) with -K_att from the printed (27)", |v| v.field = 1)
    .altered("+K_ori", |v| v.orientation = 1)
    .altered("unit vectors at any distance", |v| v.units = true)
    .altered("not (27) at the distance 1 either", |v| v.apart = 1)
}

fn examine_laplacian_form(variant: &FormVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let names = ["K_ori", "K_att", "d_2", "d_3", "w", "t_1", "t_2", "t_3", "tan(psi_2/2)", "tan(psi_3/2)"];
    let part = "one fish with two neighbours at r_1 - d_j e^{i psi_j}, t = tan(theta/2)";
    let identity = run.identity(&printed_forms(variant), &names, part)?;
    // w = K_ori = 0, K_att = 1, r_1 = 0, heading 1, one neighbour at i times the distance: (27) and its approximation.
    let (heading, unit) = (Complex::real(rational(1, 1)), -quarter_turn(&Complex::real(rational(1, 1))));
    let steering = |away: Complex<Rational>| steering_towards(&heading, &attraction(&heading, &[away]));
    let [true_rate, approximate] = [steering(unit.clone()), steering(unit.scale(&rational(variant.apart, 1)))];
    let detail = format!(
        "K_att = 1, one neighbour at {}i: (27) steers at {true_rate}, with r_kj in the place of rhat_kj at \
         {approximate}",
        variant.apart
    );
    let wrong = (true_rate == approximate).then(|| detail.clone());
    let differs = unless(wrong, exact("not (27) at other distances", detail).on([4]));
    let same = run.identity(
        &at_distance_one(variant),
        &["K_ori", "K_att", "w", "t_1", "t_2", "t_3", "tan(psi_2/2)", "tan(psi_3/2)"],
        "(27) with rhat_kj and (28), both neighbours at the distance 1",
    );
    Run::all([
        Ok(identity.on([1, 2, 3])).checks("steps 3 to 5"),
        differs.checks("step 6"),
        same.checks("step 6").on([4]),
        argued(&[1, 2, 3, 4], "any number of neighbours", "notes/paley_particles.md, Behaviours of fish, steps 3-6"),
    ])
}

/// `K_1 - K_0 = -factor N K_ori`; the spacing terms differ by `i^turns`; perpendicular where `K_1 != 0`, or also for `K_1 = 0`.
#[derive(Clone, Copy)]
pub struct ComparisonVariant {
    factor: (i64, i64),
    turns: u32,
    without_orientation: bool,
}

fn comparison_sides(variant: &ComparisonVariant, network: Neighbours) -> StateIdentity<'_> {
    StateIdentity::of(network.particles(), move |[omega, spacing, k_ori], state| {
        let (network, particles) = (&network, network.particles() as i64);
        let (p, q) = variant.factor;
        let orientation = spacing.clone() - omega.ratio(p * particles, q) * k_ori;
        let gains = CircularGains { omega: omega.clone(), spacing: spacing.clone(), orientation };
        // (22), and the fish terms with K_att = omega K_0/N, the factor i put back by turning the heading.
        let left = circular_control(&gains, network, network, state)?;
        let share = omega.ratio(1, particles) * omega * spacing;
        let turned: Vec<_> =
            state.phasors.iter().map(|z| (0..variant.turns).fold(z.clone(), |z, _| quarter_turn(&z))).collect();
        let attracting = heading_components(network, &turned, &state.positions);
        let aligning = misalignment(network, &state.phasors);
        let fish = attracting.into_iter().zip(aligning).map(|(a, o)| omega.clone() + a * &share - o * k_ori);
        let mut right: Vec<Probe> = fish.collect();
        // <e^{i theta_k}, L_k r> = sigma_k + tau_k/omega
        let mut left = left;
        left.extend(heading_components(network, &state.phasors, &state.positions));
        let sigma = heading_components(network, &state.phasors, &circle_centres(omega, state)?);
        let inverse = omega.recip()?;
        right.extend(sigma.into_iter().zip(misalignment(network, &state.phasors)).map(|(s, t)| s + t * &inverse));
        Ok((left, right))
    })
}

pub fn comparison() -> Record<ComparisonVariant> {
    Record::new(
        "paley.fish28ori",
        "(K_1 - K_0)/N = -K_ori gives equal alignment terms. <e^{i theta_k}, L_k r> = sigma_k + tau_k/w0. \
         By V = K_0 S - K_1 w0^-2 W_1 every solution of (22) tends to states with K_0 sigma_k + K_1 \
         tau_k/w0 = 0 turning at w0; tau_k is constant there and sigma_k has mean zero, so both vanish: the \
         motion of each particle is perpendicular to rtilde_k (or rtilde_k = 0). With K_1 = 0 it need not \
         be: two particles a quarter turn apart.",
        ComparisonVariant { factor: (1, 1), turns: 0, without_orientation: false },
        examine_comparison,
    )
    .clauses(&[
        "The alignment terms of (28) and (22) are identical for K_1 - K_0 = -K_ori N.",
        "The spacing terms differ only by a factor of i.",
        "The circular control locally stabilizes motion of the k-th fish perpendicular to rtilde_k = \
         d_k^{-1} L_k r.",
    ])
    .reading(
        "The gains of the spacing terms are matched, K_att = w0 K_0/N with w0 > 0, and the factor i turns \
         the heading; the circular control is (22) with K_1 != 0, as under (21), on an undirected connected \
         graph of N >= 2 (for N = 1 rtilde_1 has no value).",
    )
    .altered("K_1 - K_0 = -K_ori", |v| v.factor = (1, 4))
    .altered("the factor i left in the spacing term", |v| v.turns = 1)
    .altered("perpendicular for K_1 = 0 too", |v| v.without_orientation = true)
}

fn examine_comparison(variant: &ComparisonVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // Circular formations that turn at omega under (22): for K_1 = 0 all of them, otherwise those with tau = 0.
    let omega = rational(1, 10);
    let quarter = vec![Complex::real(rational(1, 1)), quarter_turn(&Complex::real(rational(1, 1)))];
    let opposite = vec![quarter[0].clone(), -quarter[0].clone()];
    let mut formations = vec![(rational(1, 1), opposite), (rational(-1, 1), vec![quarter[0].clone(); 2])];
    if variant.without_orientation {
        formations.push((rational(0, 1), quarter));
    }
    let network = Neighbours::complete(2);
    let count = formations.len();
    for (orientation, phasors) in formations {
        let state = circular_formation(&omega, &phasors)?;
        let gains = CircularGains { omega: omega.clone(), spacing: rational(1, 1), orientation };
        let rests = circular_control(&gains, &network, &network, &state)?.iter().all(|u| *u == omega);
        let forward = heading_components(&network, &state.phasors, &state.positions);
        if rests && forward.iter().any(|f| *f != rational(0, 1)) {
            let what = format!(
                "K_1 = {}, two particles a quarter turn apart on a circle: <e^(i th_1), L_1 r> = {}",
                gains.orientation, forward[0]
            );
            return Ok(Outcome::fails(what, exact("perpendicular motion in the limit", "an exact circular formation")));
        }
    }
    let identities = identity_graphs(run)?.into_iter().filter(|g| g.order() > 1).map(|graph| {
        let part = format!("terms of (22) and (28), {}", described(&graph));
        state_identity(comparison_sides(variant, Neighbours::of(&graph)), &["w0", "K_0", "K_ori"], &part, run)
            .checks("steps 1 and 2")
            .on([1, 2])
    });
    let perpendicular =
        exact("perpendicular motion in the limit", "exact circular formations with K_1 > 0 and K_1 < 0");
    let section = "notes/paley_particles.md, Perpendicular motion, steps 1-4";
    let last = holds(perpendicular.on([3]).cases(count)).checks("the conclusion");
    Run::all(identities.chain([argued(&[2, 3], "every graph and every start", section), last]))
}
