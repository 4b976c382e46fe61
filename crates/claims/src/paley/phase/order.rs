//! paley.sync.par, paley.eq7, paley.eq8.ext, paley.eq8_10: synchrony, the order parameter and the potential U_1.

use super::common::{N_AT_LEAST_2, all_equal, all_zero, identities, laplacian, named, supports};
use crate::prelude::*;
use algebra::graph::WeightedGraph;
use arithmetic::{CosineField, Sign, Signed};
use ledger::exact_value;
use models::oscillator::{
    State, exact_phasors, gradient_control, in_turns, laplacian_control, mean, moment, moment_gradient,
    moment_potential, pairwise_control, phase_gradient, phasors, rate_of_change, squared_lengths, symmetric_pattern,
    up_to_rotation,
};

/// The common rate given `omega_0`, when the formation is said to be parallel, and the first phase: `2 arctan` of this number, where
/// the others are `2 arctan 2/3`.
#[derive(Clone, Copy)]
pub struct RateVariant {
    rate: fn(&Rational) -> Rational,
    parallel: fn(&Rational) -> bool,
    first: (i64, i64),
}

pub fn synchronised() -> Record<RateVariant> {
    Record::new(
        "paley.sync.par",
        "The definition of a parallel formation asks for thetadot_k = 0. Phase locking gives equal rates only: under (6) with a control that \
         vanishes at equal phases, such as (9) and (14), the common rate is omega_0, and for omega_0 != 0 all particles turn together on \
         circles. Figure 1(c) of the paper shows just that and its caption says that it is no relative equilibrium of (1)-(2).",
        RateVariant { rate: |_| rational(0, 1), parallel: |_| true, first: (2, 3) },
        examine_rates,
    )
    .repaired(
        Fault::False,
        "",
        RateVariant { rate: Rational::clone, parallel: |omega| *omega == rational(0, 1), first: (2, 3) },
    )
    .repaired_clauses(&[
        "In a synchronised arrangement the particles have a common direction at all times, which turns at their common rate.",
        "Under (6) with (9) or (14) that rate is omega_0.",
        "The formation is parallel if and only if that rate is zero.",
    ])
    .altered("the rate 2 omega_0", |v| v.rate = |omega| omega * rational(2, 1))
    .altered("one phase apart from the others", |v| v.first = (5, 3))
    .altered("one phase opposite to the others", |v| v.first = (-3, 2))
    .altered("parallel where omega_0 > 0 too", |v| v.parallel = |omega| *omega >= rational(0, 1))
}

/// Particles under one law.
struct Locked {
    law: String,
    omega: Rational,
    z: Vec<Complex<Rational>>,
    rates: Vec<Rational>,
}

/// (6) with (9), and with (14) on a path.
fn locked(variant: &RateVariant, particles: usize, omega: i64, gain: i64) -> Result<[Locked; 2], CheckError> {
    let mut t = vec![rational(2, 3); particles];
    t[0] = rational(variant.first.0, variant.first.1);
    let z = phasors(&t)?;
    let path = laplacian(&named(&format!("path:{particles}"))?)?;
    let law = format!("N = {particles}, omega_0 = {omega}, K_1 = {gain}");
    let (omega, gain) = (rational(omega, 1), rational(gain, 1));
    let moving = |control: Vec<Rational>| {
        let rates = control.into_iter().map(|u| u + &omega).collect();
        Locked { law: law.clone(), omega: omega.clone(), z: z.clone(), rates }
    };
    Ok([moving(gradient_control(&gain, &z)?), moving(laplacian_control(&gain, &path, &z)?)])
}

fn examine_rates(variant: &RateVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let laws = [(0, 1), (0, -1), (1, -1), (1, 1), (-2, -1), (-2, 3)];
    let mut all = Vec::new();
    for particles in 2..=5usize {
        for (omega, gain) in laws {
            all.extend(locked(variant, particles, omega, gain)?);
        }
    }
    let detail = "(6) with (9), and with (14) on paths, at equal phases, N = 2 to 5";
    let every = |part: &str, clause: usize, wrong: &dyn Fn(&Locked) -> Option<String>| {
        let outcome =
            run.instances(part, detail, &all, |locked| Ok(wrong(locked).map(|what| format!("{}{what}", locked.law))));
        outcome.map(|outcome| supports(outcome, &[clause])).checks("step O10")
    };
    let turn = |rate: &Rational| format!(", equal phases: the phases are locked and turn at the rate {rate}");
    Run::all([
        every("common rate", 1, &|locked| (!all_equal(&locked.rates)).then(|| ": the rates differ".to_string())),
        every("common direction", 1, &|locked| (!all_equal(&locked.z)).then(|| ": the directions differ".to_string())),
        every("the rate", 2, &|locked| {
            let claimed = (variant.rate)(&locked.omega);
            (locked.rates[0] != claimed).then(|| format!("{}, not {claimed}", turn(&locked.rates[0])))
        }),
        every("parallel where it is zero", 3, &|locked| {
            let claimed = (variant.parallel)(&locked.omega);
            let is = if claimed { "parallel" } else { "not parallel" };
            (all_zero(&locked.rates) != claimed)
                .then(|| format!("{}, and not so that it is {is}", turn(&locked.rates[0])))
        }),
        argued(&[1, 2, 3], "every N and graph", "notes/paley_phases.md, steps O10"),
    ])
}

/// `p` turned by so many quarters, and the factor of the sum of squares.
#[derive(Clone, Copy)]
pub struct OrderVariant {
    quarters: u64,
    squares: i64,
}

/// `Rdot = p` and `1 - |p|^2 = (1/(2 N^2)) sum_{k,j} |z_k - z_j|^2`.
fn velocity_of_centre(particles: usize, variant: &OrderVariant) -> Identity<'_> {
    Identity::new(particles, move |t| {
        let z = phasors(t)?;
        let (like, v) = (t[0].one(), &variant);
        let i = Complex::new(like.zero(), like.clone());
        let p = mean(&z)? * i.power(v.quarters);
        let still = State { positions: vec![Complex::real(like.zero()); z.len()], phasors: z.clone() };
        let velocity = mean(&still.moving(&vec![like.zero(); z.len()], &[]).positions)?;
        let share = like.ratio(v.squares, 2 * (z.len() * z.len()) as i64);
        let spread = squared_lengths(&WeightedGraph::complete(z.len()), &z, &like) * share;
        let deficit = like - p.norm_squared();
        Ok((vec![velocity.re.derivative, velocity.im.derivative, deficit], vec![p.re, p.im, spread]))
    })
    .named(["Re Rdot", "Im Rdot", "1 - |p|^2"])
}

pub fn order_parameter() -> Record<OrderVariant> {
    Record::new(
        "paley.eq7",
        "Rdot = (1/N) sum rdot_j = (1/N) sum e^{i theta_j} by (1). 1 - |p|^2 = (1/(2 N^2)) sum_{k,j} |z_k - z_j|^2 >= 0 with equality \
         exactly for equal phases. p = 0 at all times is Rdot = 0, that is, R is fixed; an arrangement that is balanced at one instant only has \
         Rdot = 0 at that instant.",
        OrderVariant { quarters: 0, squares: 1 },
        |variant, run| {
            let parts = (1..=4).map(|particles| {
                let part = format!("Rdot = p and 1 - |p|^2 as a sum of squares, N = {particles}");
                Ok((velocity_of_centre(particles, variant), part))
            });
            identities(run, &[1, 2, 3, 4], &[], parts)
        },
    )
    .clauses(&[
        "0 <= |p_theta| <= 1.",
        "|p_theta| = 1 for synchronized phases.",
        "p_theta equals the velocity Rdot of the center of mass.",
        "Each balanced arrangement corresponds to a fixed center of mass.",
    ])
    .altered("p turned by a quarter", |v| v.quarters = 1)
    .altered("twice the squares", |v| v.squares = 2)
}

/// Which arrangements maximise, from how many particles on, and how many particles a rotation leaves out.
#[derive(Clone, Copy)]
pub struct ExtremesVariant {
    swapped: bool,
    least_particles: u32,
    left_out: usize,
}

/// `U_1` does not change when all phases are turned by the same angle, the last variable.
fn rotation(particles: usize, left_out: usize) -> Identity<'static> {
    Identity::new(particles + 1, move |at| {
        let all = phasors(at)?;
        let (turn, z) = all.split_last().ok_or(ArithmeticError::Domain("at least one phase"))?;
        let turned = particles - left_out;
        let rotated: Vec<Complex<Probe>> =
            z.iter().enumerate().map(|(k, z)| if k < turned { z.clone() * turn } else { z.clone() }).collect();
        Ok((vec![moment_potential(&rotated, 1)?], vec![moment_potential(z, 1)?]))
    })
}

pub fn extremes() -> Record<ExtremesVariant> {
    Record::new(
        "paley.eq8.ext",
        "|p| does not change when all phases turn together. 0 <= |p| <= 1 (eq. 7), with |p| = 1 exactly for equal phases and p = 0 exactly for \
         balanced ones, and both occur for N >= 2 (the splay state is balanced). One particle has no balanced arrangement and U_1 = 1/2 is constant.",
        ExtremesVariant { swapped: false, least_particles: 2, left_out: 0 },
        |variant, run| {
            let rotation = rotation(3, variant.left_out);
            let rotation = identities(run, &[1], &["turn"], [Ok((rotation, "rotational invariance, N = 3".into()))]);
            Run::all([rotation, balanced_exist(variant, run), extreme_values(variant, run)])
        },
    )
    .reading(N_AT_LEAST_2)
    .clauses(&[
        "U_1 is rotationally invariant.",
        "U_1 is maximized by synchronized phase arrangements.",
        "U_1 is minimized by balanced phase arrangements.",
    ])
    .altered("maximised by balanced arrangements", |v| v.swapped = true)
    .altered("balanced arrangements for N = 1 too", |v| v.least_particles = 1)
    .altered("one phase not turned", |v| v.left_out = 1)
}

fn balanced_exist(variant: &ExtremesVariant, run: &Run) -> Result<Outcome, CheckError> {
    let evidence = exact("balanced arrangements exist", "the splay state, N = 2 to 12").on([3]);
    run.every(evidence, variant.least_particles..=12, |particles| {
        let splay = symmetric_pattern(particles, particles).unwrap_or_default();
        let balanced = moment_potential(&splay, 1)?.sign() == Some(Sign::Zero);
        Ok((!balanced).then(|| format!("N = {particles}: the splay state is not balanced")))
    })
}

fn extreme_values(variant: &ExtremesVariant, run: &Run) -> Result<Outcome, CheckError> {
    const PARTS: usize = 6;
    let field = CosineField::new(PARTS as u32);
    let detail = "all arrangements of 2 to 4 phases at multiples of 1/6 turn";
    let arrangements = (2..=4usize).flat_map(|particles| up_to_rotation(particles, PARTS));
    run.every(exhaustive("extremes", detail).on([2, 3]), arrangements, |exponents| {
        let z = exact_phasors(&field, &exponents);
        let (value, p) = (moment_potential(&z, 1)?, moment(&z, 1)?);
        let above = (value.clone() - value.ratio(z.len() as i64, 2)).sign();
        let (balanced, together) = (p == p.zero(), all_equal(&z));
        let (low, high) = if variant.swapped { (together, balanced) } else { (balanced, together) };
        let in_range = value.sign() != Some(Sign::Negative) && above != Some(Sign::Positive);
        let extremes = (value.sign() == Some(Sign::Zero), above == Some(Sign::Zero));
        let wrong = !in_range || extremes != (low, high);
        let value = exact_value(&value)?;
        Ok(wrong.then(|| format!("N = {}, {}: U_1 = {value}", z.len(), in_turns(&exponents, PARTS))))
    })
}

/// Signs and factors of the gradient, the sum over pairs and the decrease.
#[derive(Clone, Copy)]
pub struct GradientVariant {
    gradient: i64,
    sine: i64,
    decrease: (i64, i64),
}

/// The displays between (8) and (10); variables are the phases, `K_1` and `omega_0`.
fn gradient_sides(particles: usize, variant: &GradientVariant) -> Identity<'_> {
    Identity::new(particles + 2, move |at| {
        let [t @ .., gain, omega] = at else { return Err(ArithmeticError::Domain("phases, K_1, omega_0")) };
        let z = phasors(t)?;
        let slopes = phase_gradient(&z, |z| moment_potential(z, 1))?;
        let sum = slopes.iter().fold(gain.zero(), |sum, slope| sum + slope);
        let rates: Vec<Probe> = gradient_control(gain, &z)?.into_iter().map(|u| u + omega).collect();
        let decrease = rate_of_change(&z, &rates, |z: &[Complex<Dual<Probe>>]| moment_potential(z, 1))?;

        let v = &variant;
        let printed = moment_gradient(&z, 1)?;
        let pairs = pairwise_control(gain, &WeightedGraph::complete(z.len()), &z)?;
        let squares = printed.iter().fold(gain.zero(), |sum, slope| sum + slope.square());
        let left = slopes.into_iter().chain([sum]).chain(rates).chain([decrease]);
        let right = printed
            .iter()
            .map(|slope| slope.clone() * gain.integer(v.gradient))
            .chain([gain.zero()])
            .chain(pairs.into_iter().map(|pair| pair * gain.integer(v.sine) + omega))
            .chain([squares * gain * gain.ratio(v.decrease.0, v.decrease.1)]);
        Ok((left.collect(), right.collect()))
    })
}

pub fn gradient_law() -> Record<GradientVariant> {
    Record::new(
        "paley.eq8_10",
        "dp/dtheta_k = i e^{i theta_k}/N gives the gradient; the sum is N <i p, p> = 0. <i e^{i theta_k}, e^{i theta_j}> = -sin theta_kj gives \
         (10). Along (6) the rate of U_1 is grad U_1 (omega_0 1 - K_1 grad U_1), and grad U_1 is orthogonal to 1.",
        GradientVariant { gradient: 1, sine: 1, decrease: (-1, 1) },
        |variant, run| {
            let parts = (2..=3).map(|particles| {
                let part = format!("gradient, its sum, (10) and the rate of U_1, N = {particles}");
                Ok((gradient_sides(particles, variant), part))
            });
            identities(run, &[1, 2, 3, 4], &["K1", "omega0"], parts)
        },
    )
    .clauses(&[
        "dU_1/dtheta_k = <i e^{i theta_k}, p_theta>.",
        "1^T dU_1/dtheta = 0.",
        "With (9) the phase model (6) is equivalent to (10): thetadot_k = omega_0 + (K_1/N) sum_j sin theta_kj.",
        "Along it Udot_1 = -K_1 sum_k <i e^{i theta_k}, p_theta>^2.",
    ])
    .altered("the opposite gradient", |v| v.gradient = -1)
    .altered("sin theta_jk in (10)", |v| v.sine = -1)
    .altered("half the decrease", |v| v.decrease = (-1, 2))
}
