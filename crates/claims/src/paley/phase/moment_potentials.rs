//! paley.Wm, paley.Um: the potentials of the moments.

use super::common::{all_equal, all_zero, identities, laplacian};
use crate::prelude::*;
use algebra::graph::WeightedGraph;
use algebra::matrix::{Inertia, SparseMatrix, inertia};
use arithmetic::{CosineField, Sign, Signed};
use ledger::exact_value;
use models::oscillator::{
    ExactPhasors, exact_phasors, in_turns, moment, moment_gradient, moment_potential, phase_jacobian, phase_potential,
    phasors, powers, squared_lengths, up_to_rotation,
};

/// The constant in `W_m = constant - U_m`, given `N` and `m`.
type ConstantOf = fn(particles: i64, m: i64) -> Rational;

fn moment_of_laplacian(laplacian: SparseMatrix, constant: ConstantOf, m: u32) -> Identity<'static> {
    Identity::new(laplacian.order(), move |t| {
        let z = phasors(t)?;
        let constant = t[0].rational(&(constant)(z.len() as i64, i64::from(m)));
        Ok((vec![phase_potential(&laplacian, &z, m)?], vec![constant - moment_potential(&z, m)?]))
    })
}

pub fn laplacian_moments() -> Record<ConstantOf> {
    let printed: ConstantOf = |particles, _| rational(particles, 2);
    Record::new(
        "paley.Wm",
        "With L = N I - 1 1^T and x = e^{i m theta}/m: <x, L x> = N * N/m^2 - N^2 |p_m|^2, because (23) has its own 1/m. Divided by 2N: N/(2m^2) - U_m. The printed N/2 \
         is right for m = 1 only.",
        printed,
        |variant, run| {
            let sizes = (2..=3usize).flat_map(|particles| (1..=3).map(move |m| (particles, m)));
            let parts = sizes.map(|(particles, m)| {
                let laplacian = laplacian(&WeightedGraph::complete(particles))?;
                Ok((moment_of_laplacian(laplacian, *variant, m), format!("W_{m} on the complete graph, N = {particles}")))
            });
            identities(run, &[1], &[], parts)
        },
    )
    .repaired(
        Fault::Slip,
        "If G is complete, then W_m(theta) = Q_L((1/m) e^{i m theta}) = N/(2 m^2) - U_m(theta).",
        |particles, m| rational(particles, 2 * m * m),
    )
    .control("N/(2m)", |particles, m| rational(particles, 2 * m))
    .control("N/m^2", |particles, m| rational(particles, m * m))
}

/// Where the extremes are claimed to be, and what the other stationary points are.
#[derive(Clone, Copy)]
pub struct MomentVariant {
    /// The maximum is where differences are multiples of `1/(divisor m)` of a turn.
    divisor: u32,
    /// Minimum and maximum exchanged.
    exchanged: bool,
    /// The largest value.
    largest: ConstantOf,
    /// The inertia of the Hessian at the other stationary points.
    others: fn(Inertia) -> bool,
}

/// `N/(2m^2) - U_m = (1/(2N m^2)) sum of |z_k^m - z_j^m|^2` over pairs.
fn deficit(particles: usize, m: u32, largest: ConstantOf) -> Identity<'static> {
    Identity::new(particles, move |t| {
        let z = phasors(t)?;
        let (n, square) = (particles as i64, i64::from(m * m));
        let squares = squared_lengths(&WeightedGraph::complete(particles), &powers(&z, m), &t[0]);
        let largest = t[0].rational(&largest(n, i64::from(m)));
        Ok((vec![largest - moment_potential(&z, m)?], vec![squares * t[0].ratio(1, 4 * n * square)]))
    })
}

pub fn moment_potentials() -> Record<MomentVariant> {
    let others = |i: Inertia| i.positive > 0 && i.negative > 0 && i.zero == 1;
    let largest = |particles, m| rational(particles, 2 * m * m);
    let printed = MomentVariant { divisor: 1, exchanged: false, largest, others };
    Record::new(
        "paley.Um",
        "U_m(theta) = U_1(m theta)/m^2, and theta -> m theta is a local diffeomorphism of the torus: all is as for U_1 (paley.thm1.saddle). At the other stationary points \
         the Hessian is s s^T/N - |q| diag(s), q = m p_m, with kernel exactly span{1}: v_k = (s.v)/(N |q|) for all k. So they are saddles and isolated modulo rotation; in T^N \
         each lies on its circle of rotations. One particle never has p_m = 0.",
        printed,
        |variant, run| {
            let squares = [(2, 2), (2, 3), (3, 1)].map(|(particles, m)| {
                let part = format!("N/(2m^2) - U_m as a sum of squares, N = {particles}, m = {m}");
                Ok((deficit(particles, m, variant.largest), part))
            });
            let squares = identities(run, &[1, 2], &[], squares);
            let saddles = Run::all([few_phases(variant, run), two_clusters(variant, run)]).checks("step P4");
            Run::all([squares, saddles, argued(&[3], "every N >= 2 and m", "notes/paley_phases.md, steps P4")])
        },
    )
    .reading(
        "Isolated means isolated modulo rotation, as the paper explains the word (\"no other solutions in shape space\"); N >= 2, the sizes for which the \
         paper states its goals",
    )
    .clauses(&[
        "U_m reaches its minimum when p_{m theta} = 0.",
        "U_m reaches its maximum when the difference between any two phases is an integer multiple of 2 pi/m.",
        "All of the remaining stationary points are isolated saddle points.",
    ])
    .altered("isolated in T^N", |v| v.others = |i| i.zero == 0)
    .altered("maximum at multiples of pi/m", |v| v.divisor = 2)
    .altered("minimum and maximum exchanged", |v| v.exchanged = true)
    .altered("the largest value N/m²", |v| v.largest = |particles, m| rational(particles, m * m))
}

/// All arrangements of few phases.
fn few_phases(variant: &MomentVariant, run: &Run) -> Result<Outcome, CheckError> {
    const PARTS: usize = 12;
    let field = CosineField::new(PARTS as u32);
    let detail = "all arrangements of 2 and 3 phases at multiples of 1/12 turn, m = 1 to 3";
    let sizes = [2usize, 3].into_iter().flat_map(|particles| (1u32..=3).map(move |m| (particles, m)));
    let cases = sizes.flat_map(|(particles, m)| up_to_rotation(particles, PARTS).map(move |exponents| (m, exponents)));
    let evidence = exhaustive("extremes and saddles", detail).on([1, 2, 3]);
    run.every(evidence, cases, |(m, exponents)| {
        let found = stationary_contradiction(variant, m, &exact_phasors(&field, &exponents))?;
        Ok(found.map(|what| format!("m = {m}, {}: {what}", in_turns(&exponents, PARTS))))
    })
}

/// Larger groups: phases at multiples of pi/m, so that m theta is on a line.
fn two_clusters(variant: &MomentVariant, run: &Run) -> Result<Outcome, CheckError> {
    let sizes = [(4usize, 1u32), (5, 2), (6, 3), (7, 1)].into_iter();
    let cases =
        sizes.flat_map(|(particles, m)| (0..particles.div_ceil(2)).map(move |minority| (particles, m, minority)));
    let evidence = exact("saddles of larger groups", "two clusters modulo 2 pi/m for N up to 7").on([3]);
    run.every(evidence, cases, |(particles, m, minority)| {
        let exponents: Vec<usize> = (0..particles).map(|k| 2 * (k % m as usize) + usize::from(k < minority)).collect();
        let found = stationary_contradiction(variant, m, &exact_phasors(&CosineField::new(2 * m), &exponents))?;
        Ok(found.map(|what| format!("m = {m}, {}: {what}", in_turns(&exponents, 2 * m as usize))))
    })
}

/// What contradicts the claim at an arrangement.
fn stationary_contradiction(variant: &MomentVariant, m: u32, z: &ExactPhasors) -> Result<Option<String>, CheckError> {
    let value = moment_potential(z, m)?;
    let largest = value.rational(&(variant.largest)(z.len() as i64, i64::from(m)));
    let balanced = moment(z, m)?.norm_squared().sign() == Some(Sign::Zero);
    let together = all_equal(&powers(z, m * variant.divisor));
    let (low, high) = if variant.exchanged { (together, balanced) } else { (balanced, together) };
    let above = (value.clone() - &largest).sign();
    if value.sign() == Some(Sign::Negative) || above == Some(Sign::Positive) {
        return Ok(Some("U_m is out of its range".to_string()));
    }
    if low != (value.sign() == Some(Sign::Zero)) || high != (above == Some(Sign::Zero)) {
        return Ok(Some(format!("U_m = {} is not where it is claimed to be extreme", exact_value(&value)?)));
    }
    if low || high || !all_zero(&moment_gradient(z, m)?) {
        return Ok(None);
    }
    let found = inertia(&phase_jacobian(z, |z| moment_gradient(z, m))?)?;
    Ok((!(variant.others)(found)).then(|| format!("a stationary point with {found:?}")))
}
