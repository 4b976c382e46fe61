//! paley.thm1.conv, paley.thm1.sync, paley.thm1.bal: convergence and stability.

use super::common::{all_equal, all_zero, identities};
use crate::prelude::*;
use arithmetic::{Sign, Signed};
use models::oscillator::critical::{Critical, Kind, critical_points, is_critical, linearisation, rates};
use models::oscillator::{gradient_control, moment_gradient, moment_potential, phasors, rate_of_change};

/// Most particles of the arrangements at multiples of 1/12 turn.
const MOST: usize = 6;

/// Where all solutions are claimed to converge to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// The critical set of `U_1`.
    Critical,
    /// Balanced arrangements.
    Balanced,
    /// Points at which all phases rest.
    Rest,
}

impl Limit {
    fn set(self) -> &'static str {
        match self {
            Limit::Critical => "the critical set",
            Limit::Balanced => "the balanced arrangements",
            Limit::Rest => "the points of rest",
        }
    }
}

/// Where all solutions are claimed to converge to, and the sign in the rate of `U_1`.
#[derive(Clone, Copy)]
pub struct ConvergenceVariant {
    limit: Limit,
    sign: i64,
}

/// Along (6) with (9) `Udot_1 = -K_1 |grad U_1|^2`, the sign as claimed; variables are the phases, `K_1` and `omega_0`.
fn decrease(particles: usize, sign: i64) -> Identity<'static> {
    Identity::new(particles + 2, move |at| {
        let [t @ .., gain, omega] = at else { return Err(ArithmeticError::Domain("phases, K_1, omega_0")) };
        let z = phasors(t)?;
        let rates: Vec<Probe> = gradient_control(gain, &z)?.into_iter().map(|u| u + omega).collect();
        let decrease = rate_of_change(&z, &rates, |z: &[Complex<Dual<Probe>>]| moment_potential(z, 1))?;
        let squares = moment_gradient(&z, 1)?.iter().fold(gain.zero(), |sum, slope| sum + slope.square());
        Ok((vec![decrease], vec![squares * gain * gain.integer(sign)]))
    })
}

pub fn convergence() -> Record<ConvergenceVariant> {
    Record::new(
        "paley.thm1.conv",
        "K_1 != 0. In the frame that turns at the rate omega_0, (6) with (9) is the gradient flow of -K_1 U_1 on a compact torus and the critical \
         set does not change. U_1 is monotone and bounded, so the integral of |grad U_1|^2 over time is finite; its derivative is bounded, so grad U_1 -> 0 \
         (Barbalat), and by compactness the distance to the critical set goes to 0: for all solutions. U_1 is analytic, so in \
         that frame each solution even converges to one point (Lojasiewicz).",
        ConvergenceVariant { limit: Limit::Critical, sign: -1 },
        |variant, run| {
            // A solution that turns as a whole is its own limit set.
            let turning = (2..=MOST).flat_map(|n| critical_points(n).into_iter().rev().map(move |point| (n, point)));
            let turning = run.instances(
                "solutions that turn as a whole",
                "relative equilibria of each kind, 2 to 6 particles",
                turning,
                |(n, point)| {
                    let turning = rates(&point.phasors, 1, 1)?;
                    let inside = match variant.limit {
                        Limit::Critical => is_critical(&point.phasors)?,
                        Limit::Balanced => point.kind == Kind::Balanced,
                        Limit::Rest => all_zero(&turning),
                    };
                    let outside = all_equal(&turning) && !inside;
                    Ok(outside.then(|| format!("N = {n}, {}: the solution turns as a whole and stays outside {}", point.name, variant.limit.set())))
                },
            );
            let parts =
                (1..=3).map(|particles| Ok((decrease(particles, variant.sign), format!("Udot_1 = -K_1 |grad U_1|^2, N = {particles}"))));
            let decrease = identities(run, &[1], &["K1", "omega0"], parts);
            Run::all([
                turning.checks("the conclusion"),
                decrease.checks("step T1"),
                argued(&[1], "convergence of all solutions", "notes/paley_phases.md, steps T1-T3"),
            ])
        },
    )
    .altered("all converge to balanced arrangements", |v| v.limit = Limit::Balanced)
    .altered("all converge to rest, for any omega_0", |v| v.limit = Limit::Rest)
    .altered("step T1: Udot_1 = K_1 |grad U_1|^2", |v| v.sign = 1)
}

/// Which kind is claimed to be asymptotically stable, for which sign of the gain, and in what sense.
#[derive(Clone, Copy)]
pub struct StabilityVariant {
    gain: i64,
    stable: Kind,
    /// Each arrangement on its own modulo rotation, rather than all of them as a set.
    each: bool,
    least_particles: usize,
}

fn examine_stability(variant: &StabilityVariant, run: &Run) -> Result<Outcome, CheckError> {
    let points: Vec<Vec<Critical>> = (variant.least_particles..=MOST).map(critical_points).collect();
    let cases = points.iter().flat_map(|points| points.iter().map(move |point| (point, points)));
    let detail = "the synchronised, all unbalanced and many balanced arrangements of 2 to 6 particles";
    let evidence = exact("levels and linearisations", detail).on([1, 2]);
    let instances = run.every(evidence, cases, |(point, points)| {
        let place = format!("N = {}, K_1 = {}, {}", point.phasors.len(), variant.gain, point.name);
        Ok(variant.contradiction(point, points)?.map(|what| format!("{place}: {what}")))
    });
    let levels = if variant.gain < 0 { "steps T4 and T6" } else { "steps T5 and T6" };
    Run::all([
        instances.checks(levels),
        argued(&[1, 2], "stable set and unstable rest, every N", "notes/paley_phases.md, steps T4-T6"),
    ])
}

impl StabilityVariant {
    /// What contradicts the claim at a critical point, given all of as many particles.
    fn contradiction(&self, point: &Critical, points: &[Critical]) -> Result<Option<String>, CheckError> {
        let around = linearisation(&point.phasors, self.gain)?;
        if !all_equal(&rates(&point.phasors, self.gain, 1)?) {
            return Ok(Some("no relative equilibrium".to_string()));
        }
        if point.kind != self.stable {
            return Ok((around.positive == 0).then(|| "the linearisation has no unstable direction".to_string()));
        }
        // K_1 U_1 decreases: the lowest critical level and that one only.
        let level = moment_potential(&point.phasors, 1)?;
        for other in points.iter().filter(|other| other.kind != self.stable) {
            let room = (moment_potential(&other.phasors, 1)? - &level) * level.integer(self.gain);
            if room.sign() != Some(Sign::Positive) {
                return Ok(Some(format!("K_1 U_1 is not lower than at {}", other.name)));
            }
        }
        // Two independent conditions p = 0 leave a manifold of dimension N - 2; rotation is one of them.
        let (particles, rank) = (point.phasors.len(), around.positive + around.negative);
        let continuum = self.each && particles > rank + 1;
        let dimension = particles - rank;
        Ok(continuum.then(|| format!("the critical points nearby form a manifold of dimension {dimension}")))
    }
}

const SYNCHRONISED: StabilityVariant =
    StabilityVariant { gain: -1, stable: Kind::Synchronised, each: false, least_particles: 2 };

const BALANCED: StabilityVariant =
    StabilityVariant { gain: 1, stable: Kind::Balanced, each: false, least_particles: 2 };

/// The reading of both sentences of Theorem 1.
const AS_A_SET: &str = "Equilibria modulo rotation: all phases turn at one rate. What is asymptotically stable is the set of these arrangements \
                        (of \"the set of balanced circular formations\" the paper speaks later); N >= 2, the sizes for which the paper states its goals";

pub fn synchronised_stable() -> Record<StabilityVariant> {
    Record::new(
        "paley.thm1.sync",
        "Modulo rotation the synchronised arrangements are one point: the strict maximum of U_1, with Hessian 11^T/N - I, definite modulo rotation. \
         (A single arrangement in T^N is stable but not attractive: its rotations are as good.) At a balanced arrangement the Hessian is positive \
         semidefinite with trace 1, at an unbalanced one a minority phase has second derivative 1/N + |p| > 0: both unstable for K_1 < 0.",
        SYNCHRONISED,
        |variant, run| examine_stability(variant, run),
    )
    .reading(AS_A_SET)
    .clauses(&[
        "For (9) with K_1 < 0 all of the synchronized phase arrangements are asymptotically stable.",
        "All of the remaining equilibria of (6) are unstable.",
    ])
    .altered("K_1 > 0", |v| v.gain = 1)
    .altered("balanced arrangements for K_1 < 0", |v| v.stable = Kind::Balanced)
}

pub fn balanced_stable() -> Record<StabilityVariant> {
    Record::new(
        "paley.thm1.bal",
        "U_1 >= 0 vanishes exactly at balanced arrangements, and every other critical point has |p| >= 1/N, U_1 >= 1/(2N): below that level U_1 decreases strictly, \
         so the compact set p = 0 is asymptotically stable, also at its singular points (collinear ones). At the others two majority phases \
         can part: second derivative -2|p| along e_i - e_j, unstable. Each balanced arrangement on its own is stable (a minimum of an analytic \
         function) but for N >= 4 not attractive, even modulo rotation: the balanced ones nearby form a continuum. For N = 1 nothing \
         is unstable.",
        BALANCED,
        |variant, run| examine_stability(variant, run),
    )
    .reading(AS_A_SET)
    .clauses(&[
        "For (9) with K_1 > 0 the balanced equilibria are asymptotically stable.",
        "All of the remaining equilibria of (6) are unstable.",
    ])
    .altered("K_1 < 0", |v| v.gain = -1)
    .altered("each of them on its own, modulo rotation", |v| v.each = true)
    .altered("one particle too", |v| v.least_particles = 1)
    .altered("unbalanced ones", |v| v.stable = Kind::Unbalanced)
}
