//! paley.patterns.two, paley.eq23, paley.thm3.min: symmetric patterns, their moments, and the potential they minimise.

use super::common::N_AT_LEAST_2;
use crate::prelude::*;
use arithmetic::{CosineField, RealCyclotomic, Sign, Signed};
use ledger::exact_value;
use models::oscillator::{
    ExactPhasors, clusters_of_pattern, exact_phasors, in_turns, moment, pattern_potential, symmetric_pattern,
    up_to_rotation,
};
use std::collections::BTreeSet;

fn pattern(clusters: u32, particles: u32) -> Result<ExactPhasors, CheckError> {
    symmetric_pattern(clusters, particles)
        .ok_or_else(|| CheckError::Other(format!("{clusters} does not divide {particles}")))
}

fn divisors(n: u32) -> impl Iterator<Item = u32> {
    (1..=n).filter(move |m| n.is_multiple_of(*m))
}

/// The least `N`, and how many symmetric patterns there are at least.
#[derive(Clone, Copy)]
pub struct TwoVariant {
    least: u32,
    count: usize,
}

pub fn two_patterns() -> Record<TwoVariant> {
    Record::new(
        "paley.patterns.two",
        "1 and N divide N and differ for N >= 2. One particle has one pattern, both synchronised and splay. A prime N has no third pattern.",
        TwoVariant { least: 2, count: 2 },
        |variant, run| {
            let evidence = exact("two patterns", "exact patterns for N = 2 to 12").on([1, 2]);
            run.every(evidence, variant.least..=12, |particles| {
                let clusters = |m| Ok(clusters_of_pattern(&pattern(m, particles)?));
                let found = divisors(particles).map(clusters).collect::<Result<BTreeSet<_>, CheckError>>()?;
                let named = [1, particles].iter().all(|m| found.contains(&Some(*m)));
                let wrong = !named || found.len() < variant.count;
                Ok(wrong.then(|| format!("N = {particles}: the numbers of clusters are {found:?}")))
            })
        },
    )
    .reading(N_AT_LEAST_2)
    .clauses(&[
        "For any N there exist the (1,N)-pattern (synchronized state) and the (N,N)-pattern (splay state).",
        "These are two symmetric patterns.",
    ])
    .altered("one particle too", |v| v.least = 1)
    .altered("at least three", |v| v.count = 3)
}

/// Up to which moment a pattern is balanced, whether the last one is multiplied by `M`, and whether all patterns are balanced.
#[derive(Clone, Copy)]
pub struct MomentsVariant {
    beyond: u32,
    multiplied: bool,
    synchronised_too: bool,
}

impl MomentsVariant {
    fn contradiction(&self, clusters: u32, z: &ExactPhasors) -> Result<Option<String>, CheckError> {
        let vanishes = |m| Ok::<_, CheckError>(moment(z, m)?.norm_squared().sign() == Some(Sign::Zero));
        for m in 1..clusters + self.beyond {
            if !vanishes(m)? {
                return Ok(Some(format!("p_{m} is not zero")));
            }
        }
        let last = moment(z, clusters)?.norm_squared();
        let factor = if self.multiplied { i64::from(clusters) } else { 1 };
        if last.clone() * last.integer(factor * factor) != last.one() {
            return Ok(Some(format!("|p_M|^2 = {}", exact_value(&last)?)));
        }
        let unbalanced = !vanishes(1)? && (clusters > 1 || self.synchronised_too);
        Ok(unbalanced.then(|| "not balanced".to_string()))
    }
}

pub fn moments_of_patterns() -> Record<MomentsVariant> {
    Record::new(
        "paley.eq23",
        "The m-th powers of the M-th roots of unity sum to M if M divides m and to 0 otherwise; each root occurs N/M times. So p_m = 0 for 0 < m < M and |p_M| = 1/M. \
         M >= 2 gives p_1 = 0.",
        MomentsVariant { beyond: 0, multiplied: true, synchronised_too: false },
        |variant, run| {
            let most = run.cases(10, 16) as u32;
            let sizes = (1..=most).chain([12]).flat_map(|particles| divisors(particles).map(move |m| (m, particles)));
            let detail = format!("all patterns of up to {most} particles and of 12, exact roots of unity");
            let evidence = exhaustive("moments of patterns", detail).on([1, 2, 3]);
            run.every(evidence, sizes, |(clusters, particles)| {
                let found = variant.contradiction(clusters, &pattern(clusters, particles)?)?;
                Ok(found.map(|what| format!("M = {clusters}, N = {particles}: {what}")))
            })
        },
    )
    .clauses(&[
        "Symmetric (M,N)-patterns satisfy p_{m theta} = 0 for m = 1, ..., M-1.",
        "They satisfy M |p_{M theta}| = 1.",
        "All of the symmetric patterns other than the synchronized state are balanced.",
    ])
    .altered("p_M = 0 too", |v| v.beyond = 1)
    .altered("|p_M| = 1", |v| v.multiplied = false)
    .altered("the synchronised state balanced", |v| v.synchronised_too = true)
}

/// The gain `K_m` of `K_1, ..., K_M`, given `m` and `M`.
type Gains = fn(m: u32, last: u32) -> Rational;

pub fn minimisers() -> Record<Gains> {
    let printed: Gains = |m, last| if m < last { rational(1, i64::from(m) + 1) } else { rational(-1, 1) };
    Record::new(
        "paley.thm3.min",
        "0 <= U_m <= N/(2m^2), so U^{M,N} >= K_M N/(2M^2) with equality exactly if p_1 = ... = p_{M-1} = 0 and M |p_M| = 1 (the gains before K_M are positive, K_M is \
         negative); patterns do that (eq. 23). Conversely M |p_M| = 1 makes all z_k^M equal: z_k = c w^{j_k} with w = e^{2 pi i/M}; if n_j particles sit at c w^j, then \
         sum_j n_j w^{mj} = 0 for 0 < m < M, so n, whose Fourier coefficients vanish but for the mean, is constant: n_j = N/M.",
        printed,
        examine_minimisers,
    )
    .control("K_M > 0", |_, _| rational(1, 1))
    .control("K_{M-1} = 0", |m, last| rational(if m == last { -1 } else { i64::from(m + 1 != last) }, 1))
}

/// A size, with the gains and the bound of the potential.
struct Size {
    parts: usize,
    clusters: u32,
    field: CosineField,
    gains: Vec<RealCyclotomic>,
    bound: RealCyclotomic,
}

fn examine_minimisers(variant: &Gains, run: &mut Run) -> Result<Outcome, CheckError> {
    let largest = run.cases(4, 6) as u32;
    let sizes = [(1u32, 12usize), (2, 12), (3, 6), (4, 4), (6, 6)].into_iter();
    let sizes = sizes.flat_map(|(n, parts)| divisors(n).filter(|&m| m <= largest).map(move |m| (n, parts, m)));
    let size = |(particles, parts, clusters): (u32, usize, u32)| {
        let field = CosineField::new(parts as u32);
        let gains = (1..=clusters).map(|m| field.number(&variant(m, clusters))).collect();
        let share = rational(i64::from(particles), 2 * i64::from(clusters * clusters));
        let bound = field.number(&(variant(clusters, clusters) * share));
        (particles as usize, Size { parts, clusters, field, gains, bound })
    };
    let sizes: Vec<(usize, Size)> = sizes.map(size).collect();
    // The potential does not depend on the order of the particles.
    let cases = sizes.iter().flat_map(|(particles, size)| {
        let sorted = up_to_rotation(*particles, size.parts).filter(|exponents| exponents.is_sorted());
        sorted.map(move |exponents| (size, exponents))
    });
    let detail = "all arrangements at multiples of 1/12 turn (N = 1, 2), 1/6 (N = 3, 6) and 1/4 (N = 4), all divisors M (M = 6 with --full), one choice of gains";
    run.every(exhaustive("minimum exactly at patterns", detail), cases, |(size, exponents)| {
        let z = exact_phasors(&size.field, &exponents);
        let room = (pattern_potential(&size.gains, &z)? - &size.bound).sign();
        let is_pattern = clusters_of_pattern(&z) == Some(size.clusters);
        // The bound is reached at patterns, so it is the global minimum.
        let wrong = room == Some(Sign::Negative) || is_pattern != (room == Some(Sign::Zero));
        let which = if is_pattern { "the pattern is above" } else { "no pattern, but not above" };
        let place = || format!("M = {}, {}", size.clusters, in_turns(&exponents, size.parts));
        Ok(wrong.then(|| format!("{}: {which} K_M N/(2M^2)", place())))
    })
}
