//! veerman.sec6_fig2, veerman.fig3: system (2) in time, by its exact modes.

use super::theorem1::scaled_error_is_bounded;
use super::{enclosed, gains, theorem1, unit, within};
use crate::prelude::*;
use arithmetic::{Dyadic, Sign, Signed};
use models::platoon::modes::{Mode, Roots, mode_eigenvalue};
use models::platoon::time_domain::{HarmonicStart, Modes, StopAndGo};
use models::platoon::{Gains, amplitudes_two_sided, resonance};

const PRECISION: u32 = 72;

fn interval(q: &Rational) -> Interval {
    Interval::from_rational(q, PRECISION)
}

fn share((p, q): (i64, i64)) -> Interval {
    interval(&rational(p, q))
}

/// The flock that is followed, with `f = -1` and this `g`, behind a leader at this multiple of the resonance frequency.
#[derive(Clone, Copy)]
pub struct Figure2Variant {
    followers: u64,
    g: (i64, i64),
    frequency: (i64, i64),
}

/// In the first `EARLY` periods of the leader the last car stays below the share `BELOW` of its equilibrium amplitude; after `MIDDLE`
/// periods it still lacks more than the share `LACKING`; from `LATE` periods on it lacks at most one hundredth.
const EARLY: i64 = 1;
const BELOW: (i64, i64) = (1, 4);
const MIDDLE: i64 = 4;
const LACKING: (i64, i64) = (1, 2);
const LATE: i64 = 55;

/// The start of a platoon behind a periodic leader.
struct Start {
    start: HarmonicStart<Interval>,
    w: Interval,
    /// `a_M` and its modulus.
    amplitude: Complex<Interval>,
    size: Interval,
    period: Interval,
}

impl Start {
    fn new(variant: &Figure2Variant) -> Result<Self, CheckError> {
        let gains = gains(((-1, 1), variant.g));
        let found = resonance(&gains, variant.followers, 20)?;
        let gains = enclosed(&gains, PRECISION);
        let w = found.omega.with_precision(PRECISION) * share(variant.frequency);
        let amplitudes = amplitudes_two_sided(&gains, &w, variant.followers as usize)?;
        let amplitude = amplitudes.last().cloned().ok_or(CheckError::Other("no followers".to_string()))?;
        let size = amplitude.norm_squared().sqrt()?;
        let period = (w.pi() * w.integer(2)).over(&w)?;
        let start = Modes::new(&gains, variant.followers)?.behind_harmonic_leader(&w)?;
        Ok(Start { start, w, amplitude, size, period })
    }

    /// What the last car lacks at time `t`, as a share of its equilibrium amplitude.
    fn lacking(&self, t: &Interval) -> Result<Interval, CheckError> {
        let transient = self.start.transient(t)?;
        Ok(transient.norm_squared().sqrt()?.over(&self.size)?)
    }

    /// The modulus of the complex motion at time `t`, which bounds the motions behind the leaders cos and sin, as a share.
    fn share(&self, t: &Interval) -> Result<Interval, CheckError> {
        let (sin, cos) = (self.w.clone() * t).sin_cos()?;
        let periodic = self.amplitude.clone() * Complex::new(cos, sin);
        let motion = periodic + self.start.transient(t)?;
        Ok(motion.norm_squared().sqrt()?.over(&self.size)?)
    }
}

pub fn figure2() -> Record<Figure2Variant> {
    Record::new(
        "veerman.sec6_fig2",
        "y_M(t) = a_M e^{iwt} minus a sum of free modes, exactly. The slowest mode decays like exp(-|g|(1 - cos(pi/2M)) t/2), that is like e^-1 in \
         16 M²/(pi² |g|) seconds, or 0.29 M sqrt|f|/|g| periods of the resonance: the larger the flock, the longer it takes, and after any fixed number of \
         periods the share of the equilibrium amplitude that is reached tends to 0 (notes/veerman_platoons.md).",
        Figure2Variant { followers: 32, g: (-1, 1), frequency: (1, 1) },
        examine_figure2,
    )
    .reading("The figure does not give its sizes. Early stage: in the first period of the leader the last car stays below a quarter of its equilibrium amplitude, and after four it lacks more than half of it. Close: from 55 periods on it lacks at most a hundredth. Checked for f = g = -1 (Section 7), 32 followers, and leaders cos wt and sin wt alike.")
    .clauses(&[
        "For periodic leader movement at resonance frequency starting from equidistant positions and zero velocities, there is an early stage in which the last member is far from its equilibrium resonance.",
        "It gets close to its equilibrium resonance.",
    ])
    .altered("four followers", |v| v.followers = 4)
    .altered("a leader at half the resonance frequency", |v| v.frequency = (1, 2))
    .altered("g = -1/4", |v| v.g = (-1, 4))
}

fn examine_figure2(variant: &Figure2Variant, run: &mut Run) -> Result<Outcome, CheckError> {
    let flock = Start::new(variant)?;
    let size = format!("{} followers, f = g = -1", variant.followers);
    let early = certified(
        "early stage",
        format!("{size}: below a quarter in the first period (all times), more than half lacking after {MIDDLE}"),
    )
    .on([1]);
    let late =
        certified("equilibrium", format!("{size}: at most 1/100 lacking from {LATE} periods on (all times)")).on([2]);
    const STEPS: i64 = 96;
    let mut largest = interval(&rational(0, 1));
    let mut uncertain = false;
    for step in 0..EARLY * STEPS {
        run.checkpoint()?;
        let times = share((step, STEPS)).hull(&share((step + 1, STEPS)));
        let reached = flock.share(&(flock.period.clone() * times))?;
        let room = share(BELOW) - &reached;
        if room.is_certainly_negative() {
            let reached = interval_value(&reached, 4);
            return Ok(Outcome::fails(format!("after {step}/{STEPS} periods the share {reached} is reached"), early));
        }
        uncertain |= !room.is_certainly_positive();
        if reached.hi() > largest.hi() {
            largest = reached;
        }
    }
    if uncertain {
        return Ok(Outcome::Undecided("the enclosures of the early stage are too wide".to_string()));
    }
    run.value("share_reached_in_the_early_stage_at_most", format!("~{:.3}", largest.hi().to_f64()));
    let at = |periods: i64| flock.period.clone() * share((periods, 1));
    let middle = flock.lacking(&at(MIDDLE))?;
    run.value(&format!("share_lacking_after_{MIDDLE}_periods"), interval_value(&middle, 6));
    if !(share(LACKING) - &middle).is_certainly_negative() {
        let middle = interval_value(&middle, 6);
        return Ok(Outcome::fails(format!("after {MIDDLE} periods the share {middle} is lacking"), early));
    }
    let at_last = flock.lacking(&at(LATE))?;
    if (at_last.clone() - share((1, 100))).is_certainly_positive() {
        let lacking = interval_value(&at_last, 6);
        return Ok(Outcome::fails(format!("after {LATE} periods the share {lacking} is lacking"), late));
    }
    let from_then_on = flock.start.transient_bound(&at(LATE))?.over(&flock.size)?;
    run.value(&format!("bound_of_what_is_lacking_from_{LATE}_periods_on"), interval_value(&from_then_on, 6));
    if !(share((1, 100)) - from_then_on).is_certainly_positive() {
        return Ok(Outcome::Undecided("the bound for late times is not small enough".to_string()));
    }
    Ok(Outcome::Holds(vec![early, late]))
}

/// The frequency at which the flock oscillates is `multiple` times the resonance frequency up to `O(M^-order)`; in the run the half periods
/// agree with those of the resonance of `more` cars more up to a hundredth.
#[derive(Clone, Copy)]
pub struct Figure3Variant {
    multiple: i64,
    order: u64,
    more: u64,
}

pub fn figure3() -> Record<Figure3Variant> {
    Record::new(
        "veerman.fig3",
        "After the acceleration, which lasts a time T, the deviations from the leader move freely: a sum of the modes. For large M the first one decays slowest, \
         and has two different roots z = -p ± iv, each with the factor 1 - e^{-zT}, which is not 0 since |e^{-zT}| = e^{pT} > 1: it is excited. Its frequency \
         sqrt(|f| lambda_1 - g² lambda_1²/4) is w_0 (1 - a0² (1/12 + b²/8) + O(M^-4)), the same as the resonance frequency up to O(M^-4), but not equal to it. So the \
         flock ends up oscillating near, not exactly at, the resonance frequency, for all f, g < 0 and large M (notes/veerman_platoons.md). The run shows the last car of \
         20 followers, f = g = -1, acceleration during 10 time units: its first six passages by its place.",
        Figure3Variant { multiple: 1, order: 4, more: 0 },
        examine_figure3,
    )
    .reading("The mode that decays slowest is excited and oscillates at the resonance frequency up to a relative error that tends to 0 for large flocks.")
    .altered("equal to the resonance frequency up to O(M^-5)", |v| v.order = 5)
    .altered("at twice the resonance frequency", |v| v.multiple = 2)
    .altered("the run against the resonance of 21 followers", |v| v.more = 1)
}

fn examine_figure3(variant: &Figure3Variant, run: &mut Run) -> Result<Outcome, CheckError> {
    let error = |gains: &Gains<Rational>, m: u64| {
        let (found, gains) = theorem1::enclosed(gains, m)?;
        let mode = Mode::new(&gains, &mode_eigenvalue(&gains.f, m, 1)?)?;
        let Roots::Complex(frequency) = mode.roots else {
            return Err(ArithmeticError::Domain("modes that oscillate").into());
        };
        let ratio = frequency.over(&found.omega)?;
        Ok(ratio.clone() - ratio.integer(variant.multiple))
    };
    let slowest = scaled_error_is_bounded(32, run, "slowest_mode_over_resonance", variant.order, error)?;
    let place = "notes/veerman_platoons.md, after an abrupt start, steps 1 to 4";
    Run::all([
        Ok(slowest).checks("step 4"),
        passages(variant, run).checks("the conclusion"),
        argued(&[], "for all f, g < 0 and large M", place),
    ])
}

/// The run: so many followers, the leader accelerates until this time, so many passages of the last car by its place.
const CARS: u64 = 20;
const UNTIL: i64 = 10;
const PASSAGES: usize = 6;

fn exact(t: f64) -> Result<Interval, CheckError> {
    Rational::from_float(t).map(|q| interval(&q)).ok_or(CheckError::Other("a time".to_string()))
}

/// Whether the sign of the last car's deviation certainly changes within `slack` of `time`.
fn is_passage(start: &StopAndGo<Interval>, time: f64, slack: f64) -> Result<bool, CheckError> {
    let sign = |t: f64| Ok::<_, CheckError>(start.last(&exact(t)?)?.sign());
    Ok(matches!(
        (sign(time - slack)?, sign(time + slack)?),
        (Some(Sign::Negative), Some(Sign::Positive)) | (Some(Sign::Positive), Some(Sign::Negative))
    ))
}

/// Encloses the first passages of the last car by its place after the start, and compares the times between them with half a
/// period of the resonance.
fn passages(variant: &Figure3Variant, run: &mut Run) -> Result<Outcome, CheckError> {
    let omega = resonance(&unit(), CARS + variant.more, 12)?.omega;
    let half_period = std::f64::consts::PI / omega.to_f64();
    // Floats find the passages, intervals certify them.
    let abrupt = [(0.0, 1.0), (UNTIL as f64, -1.0)];
    let passages = Modes::new(&Gains { f: -1.0, g: -1.0 }, CARS)?.behind_accelerating_leader(&abrupt)?;
    let passages = passages.passages(UNTIL as f64, half_period / 64.0, (PASSAGES, 20 * 64))?;
    let changes = [(0, 1), (UNTIL, -1)].map(|(time, change)| (share((time, 1)), share((change, 1))));
    let start = Modes::new(&enclosed(&unit(), PRECISION), CARS)?.behind_accelerating_leader(&changes)?;
    let slack = 1e-6 * half_period;
    for (k, &time) in passages.iter().enumerate() {
        if !is_passage(&start, time, slack)? {
            return Ok(Outcome::Undecided(format!("passage {} near {time} is not certain", k + 1)));
        }
    }
    let detail = format!(
        "{CARS} followers, f = g = -1: the last car passes its place {PASSAGES} times; each half period agrees with the resonance up to 1/100"
    );
    let evidence = certified("the start", detail).cases(passages.len());
    if passages.len() < PASSAGES {
        return Ok(Outcome::fails("the last car does not oscillate", evidence));
    }
    let mut largest = Dyadic::zero();
    for pair in passages.windows(2) {
        // Each true passage lies within the slack of the one that was found.
        let error = exact(-2.0 * slack)?.hull(&exact(2.0 * slack)?);
        let time = exact(pair[1])? - exact(pair[0])? + error;
        let ratio = time * &omega.with_precision(PRECISION);
        let relative = ratio.over(&ratio.pi())? - ratio.one();
        largest = largest.max(relative.magnitude());
        if !within(&relative, &rational(0, 1), &rational(1, 100)) {
            let share = interval_value(&relative, 4);
            let what =
                format!("{CARS} followers: a half period differs from that of the resonance by the share {share}");
            return Ok(Outcome::fails(what, evidence));
        }
    }
    run.value("largest_relative_difference_of_a_half_period", format!("~{:.6}", largest.to_f64()));
    run.value("first_passage_over_half_period", format!("~{:.4}", passages[0] / half_period));
    holds(evidence)
}
