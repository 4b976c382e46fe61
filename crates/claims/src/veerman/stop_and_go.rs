//! veerman.sec6_fig2, veerman.fig3: system (2) in time, by its exact modes.

use super::theorem1::{enclosed, scaled_error_is_bounded_from};
use arithmetic::{Complex, Dyadic, Field, Interval, Rational, Real, Ring, Sign, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run, interval_value};
use models::platoon::modes::{Mode, mode_eigenvalue};
use models::platoon::time_domain::{HarmonicStart, Modes};
use models::platoon::{Gains, Resonance, resonance};

const PRECISION: u32 = 72;

fn minus_one<T>(convert: impl Fn(&Rational) -> T) -> Gains<T> {
    Gains { f: convert(&rational(-1, 1)), g: convert(&rational(-1, 1)) }
}

fn interval(q: &Rational) -> Interval {
    Interval::from_rational(q, PRECISION)
}

/// veerman.sec6_fig2.
pub struct Figure2;

/// In the first `early` periods of the leader the last car stays below the share `below` of its equilibrium amplitude; after `middle`
/// periods it still lacks more than the share `lacking`; from `late` periods on it lacks at most one hundredth.
#[derive(Clone, Copy)]
pub struct Figure2Variant {
    early: i64,
    below: (i64, i64),
    middle: i64,
    lacking: (i64, i64),
    late: i64,
}

/// The flock that is followed.
const FOLLOWERS: u64 = 32;

/// A platoon at its resonance.
struct AtResonance {
    start: HarmonicStart<Interval>,
    found: Resonance,
    /// `a_M`.
    amplitude: Complex<Interval>,
    period: Interval,
}

impl AtResonance {
    fn new(followers: u64) -> Result<Self, CheckError> {
        let gains = minus_one(interval);
        let found = resonance(&minus_one(Rational::clone), followers, 20)?;
        let w = found.omega.with_precision(PRECISION);
        let amplitudes = models::platoon::amplitudes_two_sided(&gains, &w, followers as usize)?;
        let amplitude = amplitudes.last().cloned().ok_or(CheckError::Other("no followers".to_string()))?;
        let period = (w.pi() * w.integer(2)).over(&w)?;
        let start = Modes::new(&gains, followers)?.behind_harmonic_leader(&w)?;
        Ok(AtResonance { start, found, amplitude, period })
    }

    fn w(&self) -> Interval {
        self.found.omega.with_precision(PRECISION)
    }

    /// What the last car lacks at time `t`, as a share of its equilibrium amplitude.
    fn lacking(&self, t: &Interval) -> Result<Interval, CheckError> {
        let transient = self.start.transient(t)?;
        Ok(transient.norm_squared().sqrt()?.over(&self.found.amplitude)?)
    }

    /// The modulus of the complex motion at time `t`, which bounds the motions behind the leaders cos and sin, as a share.
    fn share(&self, t: &Interval) -> Result<Interval, CheckError> {
        let (sin, cos) = (self.w() * t).sin_cos()?;
        let periodic = self.amplitude.clone() * Complex::new(cos, sin);
        let motion = periodic + self.start.transient(t)?;
        Ok(motion.norm_squared().sqrt()?.over(&self.found.amplitude)?)
    }
}

impl Claim for Figure2 {
    type Variant = Figure2Variant;

    fn id(&self) -> &str {
        "veerman.sec6_fig2"
    }

    fn derivation(&self) -> &str {
        "y_M(t) = a_M e^{iwt} minus a sum of free modes, exactly. The slowest mode decays like exp(-|g|(1 - cos(pi/2M)) t/2), that is like e^-1 in \
         16 M²/(pi² |g|) seconds, or 0.29 M sqrt|f|/|g| periods of the resonance: the larger the flock, the longer it takes, and after any fixed number of \
         periods the share of the equilibrium amplitude that is reached tends to 0 (notes/veerman_platoons.md). The figure does not \
         give its sizes; checked for f = g = -1 (Section 7) and 32 followers, for leaders cos wt and sin wt alike."
    }

    fn printed(&self) -> Figure2Variant {
        Figure2Variant { early: 1, below: (1, 4), middle: 4, lacking: (1, 2), late: 55 }
    }

    fn controls(&self) -> Vec<Control<Figure2Variant>> {
        let printed = self.printed();
        vec![
            Control::new("below a quarter for eight periods", Figure2Variant { early: 8, ..printed }),
            Control::new("within a hundredth after 20 periods", Figure2Variant { late: 20, ..printed }),
            Control::new("nine tenths lacking after four periods", Figure2Variant { lacking: (9, 10), ..printed }),
        ]
    }

    fn examine(&self, variant: &Figure2Variant, run: &mut Run) -> Result<Outcome, CheckError> {
        let flock = AtResonance::new(FOLLOWERS)?;
        let share = |(p, q): (i64, i64)| interval(&rational(p, q));
        let fails = |what: String| {
            Ok(Outcome::fails(
                what,
                Evidence::new(Grade::Certified, "motion of the last car", "enclosed sum of its modes"),
            ))
        };
        const STEPS: i64 = 96;
        let mut largest = interval(&rational(0, 1));
        let mut uncertain = false;
        for step in 0..variant.early * STEPS {
            run.checkpoint()?;
            let times = interval(&rational(step, STEPS)).hull(&interval(&rational(step + 1, STEPS)));
            let reached = flock.share(&(flock.period.clone() * times))?;
            let room = share(variant.below) - &reached;
            if room.is_certainly_negative() {
                return fails(format!(
                    "after {step}/{STEPS} periods the share {} is reached",
                    interval_value(&reached, 4)
                ));
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
        let at = |periods: i64| flock.period.clone() * interval(&rational(periods, 1));
        let middle = flock.lacking(&at(variant.middle))?;
        run.value(&format!("share_lacking_after_{}_periods", variant.middle), interval_value(&middle, 6));
        if !(share(variant.lacking) - &middle).is_certainly_negative() {
            return fails(format!(
                "after {} periods the share {} is lacking",
                variant.middle,
                interval_value(&middle, 6)
            ));
        }
        let hundredth = share((1, 100));
        let late = flock.lacking(&at(variant.late))?;
        if (late.clone() - &hundredth).is_certainly_positive() {
            return fails(format!("after {} periods the share {} is lacking", variant.late, interval_value(&late, 6)));
        }
        let from_then_on = flock.start.transient_bound(&at(variant.late))?.over(&flock.found.amplitude)?;
        run.value(
            &format!("bound_of_what_is_lacking_from_{}_periods_on", variant.late),
            interval_value(&from_then_on, 6),
        );
        if !(hundredth - from_then_on).is_certainly_positive() {
            return Ok(Outcome::Undecided("the bound for late times is not small enough".to_string()));
        }
        let detail = format!(
            "{FOLLOWERS} followers, f = g = -1: below {}/{} in the first period (all times), more than {}/{} lacking after {}, at most 1/100 from {} on (all times)",
            variant.below.0, variant.below.1, variant.lacking.0, variant.lacking.1, variant.middle, variant.late
        );
        Ok(Outcome::Holds(vec![Evidence::new(Grade::Certified, "early stage and equilibrium", detail)]))
    }
}

/// veerman.fig3.
pub struct Figure3;

/// The frequency at which the flock oscillates is `multiple` times the resonance frequency up to `O(M^-order)`; in the run the half periods
/// agree up to the share `tolerance`.
#[derive(Clone, Copy)]
pub struct Figure3Variant {
    multiple: (i64, i64),
    order: u64,
    tolerance: (i64, i64),
}

impl Claim for Figure3 {
    type Variant = Figure3Variant;

    fn id(&self) -> &str {
        "veerman.fig3"
    }

    fn derivation(&self) -> &str {
        "After the acceleration, which lasts a time T, the deviations from the leader move freely: a sum of the modes, each with the factor \
         1 - e^{-zT} for its roots z = -p ± iv. Since |e^{-zT}| = e^{pT} > 1 no mode is ever left out, and the first one decays slowest. Its frequency \
         sqrt(|f| lambda_1 - g² lambda_1²/4) is w_0 (1 - a0² (1/12 + b²/8) + O(M^-4)), the same as the resonance frequency up to O(M^-4), but not equal to it. So the \
         flock ends up oscillating near, not exactly at, the resonance frequency, for all f, g < 0 and large M (notes/veerman_platoons.md). The run shows the last car of \
         20 followers, f = g = -1, acceleration during 10 time units: its first six passages by its place."
    }

    fn printed(&self) -> Figure3Variant {
        Figure3Variant { multiple: (1, 1), order: 4, tolerance: (1, 100) }
    }

    fn controls(&self) -> Vec<Control<Figure3Variant>> {
        let printed = self.printed();
        vec![
            Control::new("equal to the resonance frequency up to O(M^-5)", Figure3Variant { order: 5, ..printed }),
            Control::new("at twice the resonance frequency", Figure3Variant { multiple: (2, 1), ..printed }),
            Control::new("half periods equal up to 10^-5", Figure3Variant { tolerance: (1, 100_000), ..printed }),
        ]
    }

    fn examine(&self, variant: &Figure3Variant, run: &mut Run) -> Result<Outcome, CheckError> {
        let proof = "proof in notes/veerman_platoons.md";
        let error = |gains: &Gains<Rational>, m: u64| {
            let (found, gains) = enclosed(gains, m)?;
            let mode = Mode::new(&gains, &mode_eigenvalue(&gains.f, m, 1)?)?;
            let ratio = mode.frequency.over(&found.omega)?;
            Ok(ratio.clone() - ratio.ratio(variant.multiple.0, variant.multiple.1))
        };
        let name = "slowest_mode_over_resonance";
        let slowest = scaled_error_is_bounded_from(32, run, name, variant.order, proof, error)?;
        Run::all([Ok(slowest), start(variant, run)])
    }
}

/// Encloses the first passages of the last car by its place after the start, and compares the times between them with half a
/// period of the resonance.
fn start(variant: &Figure3Variant, run: &mut Run) -> Result<Outcome, CheckError> {
    const CARS: u64 = 20;
    const UNTIL: i64 = 10;
    const PASSAGES: usize = 6;
    let found = resonance(&minus_one(Rational::clone), CARS, 12)?;
    let w = found.omega.to_f64();
    let half_period = std::f64::consts::PI / w;
    // Floats find the passages, intervals certify them.
    let floats = Modes::new(&minus_one(|q| Interval::from_rational(q, 53).to_f64()), CARS)?;
    let until = UNTIL as f64;
    let floats = floats.behind_accelerating_leader(&[(0.0, 1.0), (until, -1.0)])?;
    let at = |t: f64| floats.last(&t);
    let step = half_period / 64.0;
    let mut passages: Vec<f64> = Vec::new();
    let mut t = until + step;
    while passages.len() < PASSAGES && t < 20.0 * half_period {
        run.checkpoint()?;
        let (mut low, mut high) = (t, t + step);
        if at(low)? * at(high)? < 0.0 {
            for _ in 0..40 {
                let middle = 0.5 * (low + high);
                if at(low)? * at(middle)? < 0.0 { high = middle } else { low = middle }
            }
            passages.push(low);
        }
        t += step;
    }
    let acceleration =
        [(0, 1), (UNTIL, -1)].map(|(time, change)| (interval(&rational(time, 1)), interval(&rational(change, 1))));
    let start = Modes::new(&minus_one(interval), CARS)?.behind_accelerating_leader(&acceleration)?;
    let exact = |t: f64| Rational::from_float(t).map(|q| interval(&q)).ok_or(CheckError::Other("a time".to_string()));
    let slack = 1e-6 * half_period;
    let sign = |t: f64| Ok::<_, CheckError>(start.last(&exact(t)?)?.sign());
    let evidence = |detail: String| Evidence::new(Grade::Certified, "the start", detail).cases(passages.len());
    for (k, &time) in passages.iter().enumerate() {
        let (before, after) = (sign(time - slack)?, sign(time + slack)?);
        let ends = [Some(Sign::Negative), Some(Sign::Positive)];
        if !(ends.contains(&before) && ends.contains(&after) && before != after) {
            return Ok(Outcome::Undecided(format!("passage {} near {time} is not certain", k + 1)));
        }
    }
    if passages.len() < PASSAGES {
        return Ok(Outcome::fails("the last car does not oscillate", evidence("floating-point search".to_string())));
    }
    let tolerance = rational(variant.tolerance.0, variant.tolerance.1);
    let mut largest = Dyadic::zero();
    for pair in passages.windows(2) {
        // Each true passage lies within the slack of the one that was found.
        let error = exact(-2.0 * slack)?.hull(&exact(2.0 * slack)?);
        let time = exact(pair[1])? - exact(pair[0])? + error;
        let ratio = time * &found.omega.with_precision(PRECISION);
        let relative = ratio.over(&ratio.pi())? - ratio.one();
        largest = largest.max(relative.magnitude());
        let (lo, hi) = relative.to_rationals();
        if lo < -tolerance.clone() || hi > tolerance {
            let what = format!(
                "{CARS} followers: a half period differs from that of the resonance by the share {}",
                interval_value(&relative, 4)
            );
            return Ok(Outcome::fails(what, evidence("enclosed passages".to_string())));
        }
    }
    run.value("largest_relative_difference_of_a_half_period", format!("~{:.6}", largest.to_f64()));
    run.value("first_passage_over_half_period", format!("~{:.4}", passages[0] / half_period));
    let detail = format!(
        "{CARS} followers, f = g = -1: the last car passes its place {PASSAGES} times; each half period agrees with the resonance up to 1/{}",
        variant.tolerance.1
    );
    Ok(Outcome::Holds(vec![evidence(detail)]))
}
