//! paley.patterns.two, paley.eq23, paley.thm3.min: symmetric patterns, their moments, and the potential they minimise.

use super::common::{Exact, at, holds, turns, up_to_rotation};
use arithmetic::{CosineField, Rational, Ring, Sign, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use models::oscillator::{clusters_of_pattern, moment, pattern_potential, symmetric_pattern};

fn pattern(clusters: u32, particles: u32) -> Result<Exact, CheckError> {
    symmetric_pattern(clusters, particles)
        .ok_or_else(|| CheckError::Other(format!("{clusters} does not divide {particles}")))
}

fn divisors(n: u32) -> impl Iterator<Item = u32> {
    (1..=n).filter(move |m| n.is_multiple_of(*m))
}

/// paley.patterns.two.
pub struct TwoPatterns;

/// The least `N`, and how many symmetric patterns there are at least.
#[derive(Clone, Copy)]
pub struct TwoVariant {
    least: u32,
    count: usize,
}

impl Claim for TwoPatterns {
    type Variant = TwoVariant;

    fn id(&self) -> &str {
        "paley.patterns.two"
    }

    fn derivation(&self) -> &str {
        "1 and N divide N and differ for N >= 2. The sentence says \"for any N\": one particle has one pattern, both synchronised and splay. A prime N has no third \
         pattern."
    }

    fn printed(&self) -> TwoVariant {
        TwoVariant { least: 1, count: 2 }
    }

    fn repair(&self) -> Option<Repair<TwoVariant>> {
        Some(Repair {
            fault: Fault::Slip,
            clauses: Vec::new(),
            statement:
                "For any N >= 2 there exist at least two symmetric patterns, the (1,N)-pattern and the (N,N)-pattern."
                    .to_string(),
            variant: TwoVariant { least: 2, count: 2 },
        })
    }

    fn controls(&self) -> Vec<Control<TwoVariant>> {
        vec![
            Control::new("at least three", TwoVariant { least: 2, count: 3 }),
            Control::new("at least three from N = 4 on", TwoVariant { least: 4, count: 3 }),
        ]
    }

    fn examine(&self, variant: &TwoVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const MOST: u32 = 12;
        for particles in variant.least..=MOST {
            run.checkpoint()?;
            let found = divisors(particles)
                .map(|m| Ok(clusters_of_pattern(&pattern(m, particles)?)))
                .collect::<Result<std::collections::BTreeSet<_>, CheckError>>()?;
            let named = [1, particles].iter().all(|m| found.contains(&Some(*m)));
            if !named || found.len() < variant.count {
                return Ok(Outcome::fails(
                    format!("N = {particles}: the numbers of clusters are {found:?}"),
                    Evidence::new(Grade::Exact, "patterns", "exact phasors"),
                ));
            }
        }
        holds([Evidence::new(
            Grade::Exact,
            "two patterns",
            "exact patterns for N = 2 to 12; for all N by the derivation",
        )
        .cases(MOST as usize - 1)])
    }
}

/// paley.eq23.
pub struct MomentsOfPatterns;

/// Up to which moment a pattern is balanced, whether the last one is multiplied by `M`, and whether all patterns are balanced.
#[derive(Clone, Copy)]
pub struct MomentsVariant {
    beyond: u32,
    multiplied: bool,
    synchronised_too: bool,
}

impl Claim for MomentsOfPatterns {
    type Variant = MomentsVariant;

    fn id(&self) -> &str {
        "paley.eq23"
    }

    fn derivation(&self) -> &str {
        "The m-th powers of the M-th roots of unity sum to M if M divides m and to 0 otherwise; each root occurs N/M times. So p_m = 0 for 0 < m < M and |p_M| = 1/M. \
         M >= 2 gives p_1 = 0."
    }

    fn printed(&self) -> MomentsVariant {
        MomentsVariant { beyond: 0, multiplied: true, synchronised_too: false }
    }

    fn controls(&self) -> Vec<Control<MomentsVariant>> {
        let printed = self.printed();
        vec![
            Control::new("p_M = 0 too", MomentsVariant { beyond: 1, ..printed }),
            Control::new("|p_M| = 1", MomentsVariant { multiplied: false, ..printed }),
            Control::new("the synchronised state balanced", MomentsVariant { synchronised_too: true, ..printed }),
        ]
    }

    fn examine(&self, variant: &MomentsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let most = run.cases(10, 16) as u32;
        let mut cases = 0;
        for particles in (1..=most).chain([12]) {
            for clusters in divisors(particles) {
                run.checkpoint()?;
                let z = pattern(clusters, particles)?;
                cases += 1;
                let fails = |what: String| {
                    let what = format!("M = {clusters}, N = {particles}: {what}");
                    Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "moments of patterns", "exact sums")))
                };
                for m in 1..clusters + variant.beyond {
                    if moment(&z, m)?.norm_squared().sign() != Some(Sign::Zero) {
                        return fails(format!("p_{m} is not zero"));
                    }
                }
                let last = moment(&z, clusters)?.norm_squared();
                let factor = if variant.multiplied { i64::from(clusters) } else { 1 };
                if last.clone() * last.integer(factor * factor) != last.one() {
                    return fails(format!("|p_M|^2 = {:?}", last.rational_value()));
                }
                let balanced = moment(&z, 1)?.norm_squared().sign() == Some(Sign::Zero);
                if !balanced && (clusters > 1 || variant.synchronised_too) {
                    return fails("not balanced".to_string());
                }
            }
        }
        let detail = format!(
            "all patterns of up to {most} particles and of 12, exact roots of unity; for all by the derivation"
        );
        holds([Evidence::new(Grade::Exhaustive, "moments of patterns", detail).cases(cases)])
    }
}

/// paley.thm3.min.
pub struct Minimisers;

/// The gains `K_1, ..., K_M`.
#[derive(Clone, Copy)]
pub struct MinimisersVariant(fn(m: u32, last: u32) -> Rational);

impl Claim for Minimisers {
    type Variant = MinimisersVariant;

    fn id(&self) -> &str {
        "paley.thm3.min"
    }

    fn derivation(&self) -> &str {
        "0 <= U_m <= N/(2m^2), so U^{M,N} >= K_M N/(2M^2) with equality exactly if p_1 = ... = p_{M-1} = 0 and M |p_M| = 1 (the gains before K_M are positive, K_M is \
         negative); patterns do that (eq. 23). Conversely M |p_M| = 1 makes all z_k^M equal: z_k = c w^{j_k} with w = e^{2 pi i/M}; if n_j particles sit at c w^j, then \
         sum_j n_j w^{mj} = 0 for 0 < m < M, so n, whose Fourier coefficients vanish but for the mean, is constant: n_j = N/M."
    }

    fn printed(&self) -> MinimisersVariant {
        MinimisersVariant(|m, last| if m < last { rational(1, i64::from(m) + 1) } else { rational(-1, 1) })
    }

    fn controls(&self) -> Vec<Control<MinimisersVariant>> {
        vec![
            Control::new("K_M > 0", MinimisersVariant(|_, _| rational(1, 1))),
            Control::new(
                "K_{M-1} = 0",
                MinimisersVariant(|m, last| {
                    rational(
                        if m + 1 == last {
                            0
                        } else if m < last {
                            1
                        } else {
                            -1
                        },
                        1,
                    )
                }),
            ),
            Control::new("K_1 < 0", MinimisersVariant(|m, last| rational(if m == 1 || m == last { -1 } else { 1 }, 1))),
        ]
    }

    fn examine(&self, variant: &MinimisersVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let largest = run.cases(4, 6) as u32;
        let mut cases = 0;
        for (particles, parts) in [(1usize, 12usize), (2, 12), (3, 6), (4, 4), (6, 6)] {
            let field = CosineField::new(parts as u32);
            for clusters in divisors(particles as u32).filter(|&m| m <= largest) {
                let gains: Vec<_> = (1..=clusters).map(|m| field.number(&(variant.0)(m, clusters))).collect();
                let bound = field.number(
                    &((variant.0)(clusters, clusters) * rational(particles as i64, 2 * i64::from(clusters * clusters))),
                );
                // The potential does not depend on the order of the particles.
                let sorted = up_to_rotation(particles, parts).filter(|exponents| exponents.is_sorted());
                for exponents in sorted {
                    run.checkpoint()?;
                    let z = at(&field, &exponents);
                    let room = pattern_potential(&gains, &z)? - &bound;
                    let is_pattern = clusters_of_pattern(&z) == Some(clusters);
                    cases += 1;
                    // The bound is reached at patterns, so it is the global minimum.
                    if room.sign() == Some(Sign::Negative) || is_pattern != (room.sign() == Some(Sign::Zero)) {
                        let which = if is_pattern { "the pattern is above" } else { "no pattern, but not above" };
                        return Ok(Outcome::fails(
                            format!("M = {clusters}, {}: {which} K_M N/(2M^2)", turns(&exponents, parts)),
                            Evidence::new(Grade::Exact, "minimisers", "exact values of (25)"),
                        ));
                    }
                }
            }
        }
        holds([
            Evidence::new(Grade::Exact, "every N, M and admissible gains", "the derivation"),
            Evidence::new(
                Grade::Exhaustive,
                "minimum exactly at patterns",
                "all arrangements at multiples of 1/12 turn (N = 1, 2), 1/6 (N = 3, 6) and 1/4 (N = 4), all divisors M (M = 6 with --full), one choice of gains",
            )
            .cases(cases),
        ])
    }
}
