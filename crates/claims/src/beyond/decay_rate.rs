//! beyond.veerman.decay_rate: the slowest rate of decay of system (2), which no rate serves for all sizes.

use crate::prelude::*;
use crate::veerman::{enclosed, gains};
use models::platoon::modes::mode_eigenvalue;
use models::platoon::vector_form::motion_matrix;
use models::platoon::{Communication, CommunicationGraph, Gains, slowest_rate};

const PRECISION: u32 = 80;

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

fn gains_list() -> [Gains<Rational>; 4] {
    [((-1, 1), (-1, 1)), ((-4, 1), (-1, 3)), ((-1, 2), (-7, 5)), ((-1, 1), (-3, 1))].map(gains)
}

pub fn slowest_decay() -> Record<DecayRateVariant> {
    Record::new(
        "beyond.veerman.decay_rate",
        "A mode lambda decays at the rate |g| lambda/2 for lambda <= 4|f|/g², and at 2|f|/(|g| + sqrt(g² - 4|f|/lambda)) >= |f|/|g| beyond. \
         lambda_1 = 1 - cos(pi/2M) <= pi²/(8M²) < 2|f|/g² for M >= |g|/sqrt|f|, so |g| lambda_1/2 < |f|/|g|: the first mode is the slowest one.",
        DecayRateVariant { factor: (1, 2), mode: 1, bound: (1, 16) },
        |variant, run| Run::all([small_flocks(variant, run), large_flocks(variant, run)]),
    )
    .stated("completes veerman, Lemma 1", "")
    .clauses(&[
        "For f, g < 0 and M = N + 1 >= |g|/sqrt|f| the slowest rate of decay of system (2), -max Re spec(M_2), is exactly |g| (1 - cos(pi/(2M)))/2.",
        "This is less than pi^2 |g|/(16 M^2).",
        "For f, g < 0 system (2) is stable for every N.",
        "For f, g < 0 it is so at no rate common to all N.",
    ])
    .altered("|g| lambda_1", |v| v.factor = (1, 1))
    .altered("the second mode", |v| v.mode = 2)
    .altered("at most pi² |g|/(17 M²)", |v| v.bound = (1, 17))
}

/// The exact polynomial of M, shifted by the rate.
fn small_flocks(variant: &DecayRateVariant, run: &Run) -> Result<Outcome, CheckError> {
    const MOST: u64 = 5;
    let detail = format!(
        "the exact polynomial of M is stable when shifted by a rate 2^-40 less, and not by one 2^-40 more; up to {MOST} followers"
    );
    let cases = gains_list().into_iter().flat_map(|gains| (1..=MOST).map(move |m| (gains.clone(), m)));
    let cases = cases.filter(|(Gains { f, g }, m)| rational((m * m) as i64, 1) * -f.clone() >= g.square());
    let slack = rational(1, 1 << 40);
    let outcome = run.instances("slowest rate", &detail, cases, |(gains, m)| {
        let graph = CommunicationGraph::of(Communication::FrontAndBack, m as usize)?;
        let motion = motion_matrix(&graph.reduced_laplacian()?, &gains)?;
        let polynomial = motion.primitive_characteristic()?;
        let (lo, hi) = variant.rate(&enclosed(&gains, PRECISION), m)?.to_rationals();
        let faster = |rate: &Rational| polynomial.with_roots_moved(rate).is_hurwitz();
        let wrong = !faster(&(lo - &slack)) || faster(&(hi + &slack));
        let Gains { f, g } = gains;
        Ok(wrong.then(|| format!("f = {f}, g = {g}, {m} followers: the slowest rate is not the claimed one")))
    })?;
    Ok(outcome.on([1, 3]))
}

/// The slower one of the first and the last mode, and the bound.
fn large_flocks(variant: &DecayRateVariant, run: &Run) -> Result<Outcome, CheckError> {
    let detail = "first and last mode, up to 2^-40 of the rate, and the bound, 10, 1000 and 10^6 followers";
    let cases = gains_list().into_iter().flat_map(|gains| [10u64, 1000, 1_000_000].map(|m| (gains.clone(), m)));
    let evidence = certified("large flocks", detail).on([1, 2]);
    run.every(evidence, cases, |(exact, m)| {
        let gains = enclosed(&exact, PRECISION);
        let claimed = variant.rate(&gains, m)?;
        let bound = -gains.g.clone() * gains.g.pi().square() * claimed.ratio(variant.bound.0, variant.bound.1);
        let room = bound.over(&gains.f.integer(m as i64).square())? - &claimed;
        let right =
            are_within(&slowest_rate(&gains, m)?, &claimed, &claimed.scaled(-40))? && !at_most(&room, &room.zero())?;
        let rate = interval_value(&claimed, 8);
        Ok((!right).then(|| format!("f = {}, g = {}, {m} followers: {rate}", exact.f, exact.g)))
    })
}
