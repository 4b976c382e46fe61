//! paley.thm1.saddle, paley.unbal: the other critical points of U_1.

use super::common::{all_equal, all_zero};
use crate::prelude::*;
use algebra::matrix::Inertia;
use arithmetic::Signed;
use models::oscillator::critical::{Kind, arrangements, hessian, is_critical, linearisation, rates, two_clusters};
use models::oscillator::{on_the_line, sine_of_difference};

/// Which critical points are claimed to be what.
#[derive(Clone, Copy)]
pub struct SaddleVariant {
    /// Kinds to which the statement applies.
    applies: fn(Kind) -> bool,
    /// What the inertia of the Hessian must be.
    shape: fn(Inertia) -> bool,
    /// Whether `omega_0` is left out of the equilibria.
    at_rest: bool,
}

impl SaddleVariant {
    /// What contradicts the claim at a critical point.
    fn contradiction<T: Field + Signed + PartialEq>(&self, z: &[Complex<T>]) -> Result<Option<String>, CheckError> {
        if !(self.applies)(Kind::of(z)?) {
            return Ok(None);
        }
        let sines = z.iter().flat_map(|a| z.iter().map(move |b| sine_of_difference(a, b)));
        if !all_zero(&sines.collect::<Vec<_>>()) {
            return Ok(Some("some sin theta_kj is not zero".to_string()));
        }
        let rates = rates(z, 1, 1)?;
        if !all_equal(&rates) || (self.at_rest && !all_zero(&rates)) {
            return Ok(Some("no equilibrium of (6), omega_0 = 1".to_string()));
        }
        let shape = hessian(z)?;
        Ok((!(self.shape)(shape)).then(|| format!("{shape:?}")))
    }
}

pub fn saddles() -> Record<SaddleVariant> {
    let shape = |i: Inertia| i.positive > 0 && i.negative > 0;
    let printed = SaddleVariant { applies: |kind| kind == Kind::Unbalanced, shape, at_rest: false };
    Record::new(
        "paley.thm1.saddle",
        "<i z_k, p> = 0 with p != 0 says z_k = ±p/|p|: all phases on a line, sin theta_kj = 0, so the control vanishes and all phases turn at \
         omega_0. Not synchronised and p != 0: a minority and a larger majority of at least two. The Hessian \
         s s^T/N - |p| diag(s) is 1/N + |p| > 0 at a minority phase and -2|p| < 0 along e_i - e_j of two majority phases. N = 1 and 2 have no \
         such points.",
        printed,
        |variant, run| {
            let line = exact("indefinite Hessians, relative equilibria", "all of 2 to 10 particles");
            let line = run.every(line.on([1, 2, 3]), two_clusters(10), |(n, minority, z)| {
                let place = format!("N = {n}, {minority} phases opposite to the others");
                Ok(variant.contradiction(&z)?.map(|what| format!("{place}: {what}")))
            });
            let detail = "all arrangements of 2 and 3 phases at multiples of 1/12 turn and of 4 at multiples of 1/6";
            let others = exhaustive("all critical points among few phases", detail);
            let others = run.every(others.on([1, 2, 3]), arrangements(), |(place, z)| {
                if !is_critical(&z)? {
                    return Ok(None);
                }
                Ok(variant.contradiction(&z)?.map(|what| format!("{place}: {what}")))
            });
            Run::all([
                line.checks("steps C2 and C3"),
                others.checks("steps C1 to C3"),
                argued(&[1, 2, 3], "every N", "notes/paley_phases.md, steps C1-C3"),
            ])
        },
    )
    .reading("Equilibria of (6) are taken modulo rotation: all phases turn at one rate")
    .clauses(&[
        "All critical points of U_1 other than the synchronized and balanced arrangements are saddle points.",
        "They satisfy sin theta_kj = 0 for all j, k.",
        "They are equilibria of (6) with the control (9).",
    ])
    .altered("balanced ones too", |v| v.applies = |kind| kind != Kind::Synchronised)
    .altered("synchronised ones too", |v| v.applies = |kind| kind != Kind::Balanced)
    .altered("at rest for any omega_0", |v| v.at_rest = true)
}

/// The `M` of `N` for which the statement is made, and whether the last phase is a quarter turn off.
#[derive(Clone, Copy)]
pub struct UnbalancedVariant {
    applies: fn(m: usize, n: usize) -> bool,
    distorted: bool,
}

pub fn unbalanced() -> Record<UnbalancedVariant> {
    Record::new(
        "paley.unbal",
        "M = N/2 is balanced, two equal clusters, stable for K_1 > 0, and M = 0 is synchronised, stable for K_1 < 0. The Hessian of U_1 is indefinite \
         at the others (paley.thm1.saddle), so the linearisation has an unstable direction for either sign of K_1.",
        UnbalancedVariant { applies: |m, n| m >= 1 && 2 * m != n, distorted: false },
        examine_unbalanced,
    )
    .reading("The sentence gives an example of the critical points other than the synchronized and balanced: 1 <= M < N and M != N/2; equilibria \
         modulo rotation")
    .clauses(&[
        "The phase arrangements with M < N phases equal to theta_0 and N - M equal to theta_0 + pi, M != N/2, are equilibria.",
        "They are unstable.",
        "They look like two unequally sized clusters on opposite sides of the unit circle.",
    ])
    .altered("M = N/2 too", |v| v.applies = |m, _| m >= 1)
    .altered("M = 0 too", |v| v.applies = |m, n| 2 * m != n)
    .altered("the last phase a quarter turn off", |v| v.distorted = true)
}

fn examine_unbalanced(variant: &UnbalancedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let sizes = (2..=9usize).flat_map(|n| (0..n).map(move |m| (m, n)).filter(|&(m, n)| (variant.applies)(m, n)));
    let detail = "the exact linearisation for both signs of K_1, all M for N up to 9";
    let evidence = exact("unstable equilibria of two unequal clusters", detail).on([1, 2, 3]);
    let instances = run.every(evidence, sizes, |(m, n)| {
        let mut z = on_the_line(n, n - m);
        if variant.distorted {
            z[n - 1] = Complex::new(rational(0, 1), rational(1, 1));
        }
        let unstable = linearisation(&z, 1)?.positive > 0 && linearisation(&z, -1)?.positive > 0;
        let first = z.iter().filter(|z| **z == Complex::real(rational(1, 1))).count();
        let what = if !all_equal(&rates(&z, 1, 0)?) {
            "no relative equilibrium"
        } else if !unstable {
            "stable for one sign of K_1"
        } else if first == n - first || first == 0 || first == n {
            "not two clusters of different sizes"
        } else {
            return Ok(None);
        };
        Ok(Some(format!("N = {n}, M = {m}: {what}")))
    });
    Run::all([
        instances.checks("steps C2, C3 and T6"),
        argued(&[1, 2, 3], "every M and N", "notes/paley_phases.md, steps C1-C3 and T6"),
    ])
}
