//! veerman.fig1, veerman.cor3, veerman.prop2: where the peaks of system (2) are and what they allow.

use super::theorem1::{DIGITS, enclosed, scaled_error_is_bounded_from};
use crate::printed_decimal;
use arithmetic::{ArithmeticError, Field, Interval, Rational, Real, Ring, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run, interval_value};
use models::platoon::{Gains, lesser_resonance, resonance};

/// veerman.fig1.
pub struct Figure1;

/// "peaks at about `peak`" for 100 individuals, and "at a frequency `ratio` times less" for 1000.
#[derive(Clone, Copy)]
pub struct Figure1Variant {
    peak: &'static str,
    ratio: i64,
}

impl Claim for Figure1 {
    type Variant = Figure1Variant;

    fn id(&self) -> &str {
        "veerman.fig1"
    }

    fn derivation(&self) -> &str {
        "About is read as: to the printed digits. The frequencies are certified global maxima. A flock of 100 individuals may mean \
         99 (with the leader), 100 or 101 (N = 100) followers, likewise for 1000: all readings agree with the text. By Theorem 1 the peak \
         is at pi/(2 sqrt2 M) = 1.1107/M for f = g = -1."
    }

    fn printed(&self) -> Figure1Variant {
        Figure1Variant { peak: "0.011", ratio: 10 }
    }

    fn controls(&self) -> Vec<Control<Figure1Variant>> {
        let printed = self.printed();
        vec![
            Control::new("0.012", Figure1Variant { peak: "0.012", ..printed }),
            Control::new("0.0111", Figure1Variant { peak: "0.0111", ..printed }),
            Control::new("9 times less", Figure1Variant { ratio: 9, ..printed }),
        ]
    }

    fn examine(&self, variant: &Figure1Variant, run: &mut Run) -> Result<Outcome, CheckError> {
        let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
        let (printed, unit) = printed_decimal(variant.peak)?;
        let half = unit / rational(2, 1);
        let within = |x: &Interval, middle: &Rational, slack: &Rational| {
            let (lo, hi) = x.to_rationals();
            middle - slack <= lo && hi <= middle + slack
        };
        let evidence = Evidence::new(Grade::Certified, "peaks", "enclosures of the global maxima");
        for offset in [-1, 0, 1] {
            let peak = |individuals: u64| resonance(&gains, individuals.saturating_add_signed(offset), 12);
            let (small, large) = (peak(100)?, peak(1000)?);
            let ratio = small.omega.over(&large.omega)?;
            let followers = 100 + offset;
            if !within(&small.omega, &printed, &half) {
                let what = format!("{followers} followers: the peak is at {}", interval_value(&small.omega, 6));
                return Ok(Outcome::fails(what, evidence));
            }
            if !within(&ratio, &rational(variant.ratio, 1), &rational(1, 2)) {
                let what = format!(
                    "{followers} followers and ten times as many individuals: the ratio is {}",
                    interval_value(&ratio, 6)
                );
                return Ok(Outcome::fails(what, evidence));
            }
            run.value(&format!("peak_{followers}_followers"), interval_value(&small.omega, 8));
            run.value(&format!("ratio_of_frequencies_{followers}_followers"), interval_value(&ratio, 8));
        }
        let detail =
            "peak within 0.0005 of 0.011 and ratio within 1/2 of 10, for each of the three readings of the size";
        Ok(Outcome::Holds(vec![Evidence::new(Grade::Certified, "peaks", detail).cases(6)]))
    }
}

/// veerman.cor3.
pub struct LesserResonances;

/// The k-th resonance lies at `stride k + offset` times the main one up to a relative error `O(M^-order)`; it is `height` times as high
/// at most.
#[derive(Clone, Copy)]
pub struct LesserVariant {
    stride: i64,
    offset: i64,
    order: u64,
    least_height: (i64, i64),
}

/// From this size on the second and third resonance exist for all gains of the list.
const SMALLEST: u64 = 256;

/// The lesser resonances that are enclosed.
const LESSER: [u64; 2] = [2, 3];

impl Claim for LesserResonances {
    type Variant = LesserVariant;

    fn id(&self) -> &str {
        "veerman.cor3"
    }

    fn derivation(&self) -> &str {
        "Read for fixed k and large flocks, like the theorem. F = 1/|a|² has F' = M (y' sinh 2My - x' sin 2Mx). At Mx = (k - 3/4) pi it is negative for large \
         M, since y' sinh 2My -> 0 there, and at Mx = (k - 1/2) pi positive: between them lies a local maximum of the response. There \
         sin 2Mx = O(M^-2), so Mx = (k - 1/2) pi + O(M^-2) and w_k = (2k - 1) w_1 (1 + O(M^-2)). Its height is A_1/(2k - 1)² (1 + O(M^-2)), because \
         y grows with w². (notes/veerman_platoons.md; damping flattens all but about sqrt(M ln M) of them, and none is left \
         for small M.)"
    }

    fn printed(&self) -> LesserVariant {
        LesserVariant { stride: 2, offset: -1, order: 2, least_height: (0, 1) }
    }

    fn controls(&self) -> Vec<Control<LesserVariant>> {
        let printed = self.printed();
        vec![
            Control::new("at the even multiples", LesserVariant { offset: -2, ..printed }),
            Control::new("at all multiples", LesserVariant { stride: 1, offset: 0, ..printed }),
            Control::new("an error of the order M^-3", LesserVariant { order: 3, ..printed }),
            Control::new("at least half as high as the main one", LesserVariant { least_height: (1, 2), ..printed }),
        ]
    }

    fn examine(&self, variant: &LesserVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let proof = "proof in notes/veerman_platoons.md";
        let mut results = Vec::new();
        for k in LESSER {
            let multiple = variant.stride * k as i64 + variant.offset;
            let place = |gains: &Gains<Rational>, m: u64| -> Result<Interval, CheckError> {
                let (main, lesser) = (resonance(gains, m, DIGITS)?, lesser_resonance(gains, m, k, DIGITS)?);
                let ratio = lesser.omega.over(&main.omega)?;
                Ok(ratio.clone() * ratio.ratio(1, multiple.max(1)) - ratio.one())
            };
            let name = format!("omega_{k}_over_omega_1");
            results.push(scaled_error_is_bounded_from(SMALLEST, run, &name, variant.order, proof, place)?);
            results.push(heights(variant, k, run)?);
        }
        Run::all(results.into_iter().map(Ok))
    }
}

/// The lesser resonance is lower than the main one, and `(2k - 1)²` times lower up to `O(M^-2)`.
fn heights(variant: &LesserVariant, k: u64, run: &mut Run) -> Result<Outcome, CheckError> {
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    let evidence = |detail: &str| Evidence::new(Grade::Certified, format!("height of resonance {k}"), detail);
    for m in [SMALLEST, 64 * SMALLEST] {
        let (main, lesser) = (resonance(&gains, m, DIGITS)?, lesser_resonance(&gains, m, k, DIGITS)?);
        let ratio = lesser.amplitude.over(&main.amplitude)?;
        run.value(&format!("height_of_resonance_{k}_over_the_main_one_f_g_-1_M_{m}"), interval_value(&ratio, 8));
        let least = ratio.ratio(variant.least_height.0, variant.least_height.1);
        let (below, above) = (ratio.one() - &ratio, ratio.clone() - least);
        if !below.is_certainly_positive() || above.is_certainly_negative() {
            let what =
                format!("f = g = -1, {m} followers: resonance {k} is {} of the main one", interval_value(&ratio, 6));
            return Ok(Outcome::fails(what, evidence("enclosures of both peaks")));
        }
    }
    Ok(Outcome::Holds(vec![evidence("a certified local maximum, certainly lower than the main one").cases(2)]))
}

/// veerman.prop2.
pub struct TwoSidedSizeLimit;

/// `N <~ pi² |g|/(divisor sqrt2 |f|^(power/2)) D/a_0`, with the error of the order `M^-order`.
#[derive(Clone, Copy)]
pub struct TwoSidedLimitVariant {
    divisor: i64,
    power: u64,
    order: u64,
}

impl Claim for TwoSidedSizeLimit {
    type Variant = TwoSidedLimitVariant;

    fn id(&self) -> &str {
        "veerman.prop2"
    }

    fn derivation(&self) -> &str {
        "The last car oscillates with a_0 A, and A = (N+1)/X + O(1/N), X = pi² |g|/(8 sqrt2 sqrt|f|) (Theorem 1). So a_0 A <= D means \
         N + 1 <= X D/a_0 + O(1/N). Read as usual, N <~ X D/a_0 means up to terms that are small against X D/a_0; A increases with N for large N \
         (by 1/X + O(N^-2) per car), so this is a limit. Checked for the tie D = a_0 A: N + 1 - X D/a_0 is O(1/M); and N <= X D/a_0 without any \
         correction for small flocks too."
    }

    fn printed(&self) -> TwoSidedLimitVariant {
        TwoSidedLimitVariant { divisor: 8, power: 1, order: 1 }
    }

    fn controls(&self) -> Vec<Control<TwoSidedLimitVariant>> {
        let printed = self.printed();
        vec![
            Control::new("4 sqrt2 instead of 8 sqrt2", TwoSidedLimitVariant { divisor: 4, ..printed }),
            Control::new("|f| instead of sqrt|f|", TwoSidedLimitVariant { power: 2, ..printed }),
            Control::new("an error of the next order", TwoSidedLimitVariant { order: 2, ..printed }),
        ]
    }

    fn examine(&self, variant: &TwoSidedLimitVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let bound = |gains: &Gains<Rational>, m: u64| -> Result<Interval, CheckError> {
            let (found, intervals) = enclosed(gains, m)?;
            Ok(variant.coefficient(&intervals)? * found.amplitude)
        };
        let proof = "proof in notes/resonance.md (amplitude)";
        let error = |gains: &Gains<Rational>, m: u64| {
            let bound = bound(gains, m)?;
            Ok(bound.integer(m as i64) - bound)
        };
        let tie = scaled_error_is_bounded_from(32, run, "N+1-X*D/a_0", variant.order, proof, error)?;
        Run::all([Ok(tie), small_flocks(&bound)])
    }
}

impl TwoSidedLimitVariant {
    fn coefficient(&self, gains: &Gains<Interval>) -> Result<Interval, ArithmeticError> {
        let root = (-gains.f.clone()).sqrt()?.power(self.power);
        let divisor = root * gains.f.integer(self.divisor) * gains.f.integer(2).sqrt()?;
        (gains.f.pi().square() * -gains.g.clone()).over(&divisor)
    }
}

/// `N < X D/a_0` where D is just what the flock of N + 1 followers needs, from one follower on.
fn small_flocks(bound: &impl Fn(&Gains<Rational>, u64) -> Result<Interval, CheckError>) -> Result<Outcome, CheckError> {
    const MOST: u64 = 24;
    let gains = |f: (i64, i64), g: (i64, i64)| Gains { f: rational(f.0, f.1), g: rational(g.0, g.1) };
    let list = [gains((-1, 1), (-1, 1)), gains((-1, 1), (-1, 100)), gains((-1, 4), (-5, 1))];
    for gains in &list {
        for m in 1..=MOST {
            let bound = bound(gains, m)?;
            if !(bound.clone() - bound.integer(m as i64 - 1)).is_certainly_positive() {
                let what = format!(
                    "f = {}, g = {}, N = {}: the bound is {}",
                    gains.f,
                    gains.g,
                    m - 1,
                    interval_value(&bound, 8)
                );
                return Ok(Outcome::fails(what, Evidence::new(Grade::Certified, "small flocks", "enclosures")));
            }
        }
    }
    let detail = format!("N < X D/a_0 for the smallest D that allows N, N = 0 to {}, three pairs (f, g)", MOST - 1);
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Certified, "small flocks", detail).cases(list.len() * MOST as usize)]))
}
