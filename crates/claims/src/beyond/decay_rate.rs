//! beyond.veerman.decay_rate: the slowest rate of decay of system (2), which no rate serves for all sizes.

use algebra::spectrum::Polynomial;
use arithmetic::{Field, Interval, Rational, Real, Ring, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run, Source, interval_value};
use models::platoon::modes::mode_eigenvalue;
use models::platoon::vector_form::motion_matrix;
use models::platoon::{Communication, CommunicationGraph, Gains, slowest_rate};

const PRECISION: u32 = 80;

/// beyond.veerman.decay_rate.
pub struct SlowestDecay;

/// The rate is `factor |g| lambda_mode`, and at most `bound pi² |g|/M²`.
#[derive(Clone, Copy)]
pub struct DecayRateVariant {
    factor: (i64, i64),
    mode: u64,
    bound: (i64, i64),
}

impl DecayRateVariant {
    fn rate(&self, gains: &Gains<Interval>, followers: u64) -> Result<Interval, CheckError> {
        let lambda = mode_eigenvalue(&gains.f, followers, self.mode.min(followers))?;
        Ok(lambda.clone() * -gains.g.clone() * lambda.ratio(self.factor.0, self.factor.1))
    }
}

fn gains_list() -> Vec<Gains<Rational>> {
    let numbers = [((-1, 1), (-1, 1)), ((-4, 1), (-1, 3)), ((-1, 2), (-7, 5)), ((-1, 1), (-3, 1))];
    numbers.iter().map(|&(f, g)| Gains { f: rational(f.0, f.1), g: rational(g.0, g.1) }).collect()
}

impl Claim for SlowestDecay {
    type Variant = DecayRateVariant;

    fn id(&self) -> &str {
        "beyond.veerman.decay_rate"
    }

    fn source(&self) -> Option<Source> {
        Some(Source {
            place: "completes veerman, Lemma 1".to_string(),
            statement: "For f, g < 0 and M = N + 1 >= |g|/sqrt|f| the slowest rate of decay of system (2), -max Re spec(M_2), is exactly \
                        |g| (1 - cos(pi/(2M)))/2, which is less than pi^2 |g|/(16 M^2): system (2) is stable for every N, but at no common rate."
                .to_string(),
        })
    }

    fn derivation(&self) -> &str {
        "A mode lambda decays at the rate |g| lambda/2 for lambda <= 4|f|/g², and at 2|f|/(|g| + sqrt(g² - 4|f|/lambda)) >= |f|/|g| beyond. \
         lambda_1 = 1 - cos(pi/2M) <= pi²/(8M²) < 2|f|/g² for M >= |g|/sqrt|f|, so |g| lambda_1/2 < |f|/|g|: the first mode is the slowest one."
    }

    fn printed(&self) -> DecayRateVariant {
        DecayRateVariant { factor: (1, 2), mode: 1, bound: (1, 16) }
    }

    fn controls(&self) -> Vec<Control<DecayRateVariant>> {
        let printed = self.printed();
        vec![
            Control::new("|g| lambda_1", DecayRateVariant { factor: (1, 1), ..printed }),
            Control::new("the second mode", DecayRateVariant { mode: 2, ..printed }),
            Control::new("at most pi² |g|/(17 M²)", DecayRateVariant { bound: (1, 17), ..printed }),
        ]
    }

    fn examine(&self, variant: &DecayRateVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const MOST: u64 = 5;
        let slack = rational(1, 1 << 40);
        let mut cases = 0;
        for gains in gains_list() {
            let interval = gains.map(|q| Interval::from_rational(q, PRECISION));
            for m in (1..=MOST).filter(|&m| rational((m * m) as i64, 1) * -gains.f.clone() >= gains.g.square()) {
                run.checkpoint()?;
                let graph = CommunicationGraph::of(Communication::FrontAndBack, m as usize)?;
                let motion = motion_matrix(&graph.reduced_laplacian()?, &gains)?;
                let polynomial = Polynomial::from_rationals(&motion.characteristic_polynomial()?.coefficients());
                let (lo, hi) = variant.rate(&interval, m)?.to_rationals();
                let faster = |rate: &Rational| polynomial.with_roots_moved(rate).is_hurwitz();
                cases += 1;
                if !faster(&(lo - &slack)) || faster(&(hi + &slack)) {
                    return Ok(Outcome::fails(
                        format!(
                            "f = {}, g = {}, {m} followers: the slowest rate is not the claimed one",
                            gains.f, gains.g
                        ),
                        Evidence::new(Grade::Exact, "slowest rate", "Routh's table of the shifted polynomial"),
                    ));
                }
            }
            for m in [10u64, 1000, 1_000_000] {
                let claimed = variant.rate(&interval, m)?;
                let scale = interval.f.integer(m as i64).square();
                let bound =
                    -interval.g.clone() * interval.g.pi().square() * claimed.ratio(variant.bound.0, variant.bound.1);
                let room = bound.over(&scale)? - &claimed;
                cases += 1;
                if !slowest_rate(&interval, m)?.overlaps(&claimed) || !room.is_certainly_positive() {
                    return Ok(Outcome::fails(
                        format!("f = {}, g = {}, {m} followers: {}", gains.f, gains.g, interval_value(&claimed, 8)),
                        Evidence::new(Grade::Certified, "large flocks", "enclosures"),
                    ));
                }
            }
        }
        let exact = format!(
            "the exact polynomial of M is stable when shifted by a rate 2^-40 less, and not by one 2^-40 more; up to {MOST} followers"
        );
        Ok(Outcome::Holds(vec![
            Evidence::new(Grade::Exact, "slowest rate", exact).cases(cases),
            Evidence::new(Grade::Certified, "large flocks", "first and last mode and the bound, up to 10^6 followers"),
        ]))
    }
}
