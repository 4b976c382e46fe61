//! veerman.fig1, veerman.cor3, veerman.prop2: where the peaks of system (2) are and what they allow.

use super::theorem1::{DIGITS, ExponentVariant, enclosed, scaled_error_is_bounded};
use super::{gains, unit, within};
use crate::prelude::*;
use crate::printed_decimal;
use arithmetic::Signed;
use models::platoon::{Gains, lesser_resonance, resonance};

/// "peaks at about `peak`" for 100 individuals, and "at a frequency `ratio` times less" for 1000, with this `f`.
#[derive(Clone, Copy)]
pub struct Figure1Variant {
    peak: &'static str,
    ratio: i64,
    f: i64,
}

pub fn figure1() -> Record<Figure1Variant> {
    Record::new(
        "veerman.fig1",
        "The frequencies are certified global maxima. By Theorem 1 the peak is at pi/(2 sqrt2 M) = 1.1107/M for f = g = -1.",
        Figure1Variant { peak: "0.011", ratio: 10, f: -1 },
        examine_figure1,
    )
    .reading("About: to the printed digits. A flock of 100 individuals may have 99 (with the leader), 100 or 101 (N = 100) followers, likewise 1000: all readings agree with the text.")
    .clauses(&[
        "For f = g = -1 the response of a flock of 100 individuals peaks at about w = 0.011.",
        "That of 1000 individuals peaks at a frequency 10 times less.",
    ])
    .altered("0.012", |v| v.peak = "0.012")
    .altered("9 times less", |v| v.ratio = 9)
    .altered("f = -2", |v| v.f = -2)
}

fn examine_figure1(variant: &Figure1Variant, run: &mut Run) -> Result<Outcome, CheckError> {
    let gains = gains(((variant.f, 1), (-1, 1)));
    let (printed, unit) = printed_decimal(variant.peak)?;
    let half = rational(1, 2);
    let detail = "enclosures of the global maxima for each of the three readings of the size";
    let evidence = |what: &str, k: usize| certified(what, detail).cases(3).on([k]).for_all();
    let evidence = [evidence("the peak within 0.0005 of 0.011", 1), evidence("the ratio within 1/2 of 10", 2)];
    for offset in [-1, 0, 1] {
        let peak = |individuals: u64| resonance(&gains, individuals.saturating_add_signed(offset), 12);
        let (small, large) = (peak(100)?, peak(1000)?);
        let ratio = small.omega.over(&large.omega)?;
        let followers = 100 + offset;
        if !within(&small.omega, &printed, &(&unit * &half)) {
            let what = format!("{followers} followers: the peak is at {}", interval_value(&small.omega, 6));
            return Ok(Outcome::fails(what, evidence[0].clone()));
        }
        if !within(&ratio, &rational(variant.ratio, 1), &half) {
            let ratio = interval_value(&ratio, 6);
            let what = format!("{followers} followers and ten times as many individuals: the ratio is {ratio}");
            return Ok(Outcome::fails(what, evidence[1].clone()));
        }
        run.value(&format!("peak_{followers}_followers"), interval_value(&small.omega, 8));
        run.value(&format!("ratio_of_frequencies_{followers}_followers"), interval_value(&ratio, 8));
    }
    Ok(Outcome::Holds(evidence.to_vec()))
}

/// The k-th resonance lies at `2k + offset` times the main one up to a relative error `O(M^-order)`; it is higher than `least_height` times the
/// main one.
#[derive(Clone, Copy)]
pub struct LesserVariant {
    offset: i64,
    order: u64,
    least_height: (i64, i64),
}

/// From this size on the second and third resonance exist for all gains of the list.
const SMALLEST: u64 = 256;

/// The lesser resonances that are enclosed.
const LESSER: [u64; 2] = [2, 3];

pub fn lesser_resonances() -> Record<LesserVariant> {
    Record::new(
        "veerman.cor3",
        "F = 1/|a|² has F' = M (y' sinh 2My - x' sin 2Mx). At Mx = (k - 3/4) pi it is negative for large \
         M, since y' sinh 2My -> 0 there, and at Mx = (k - 1/2) pi positive: between them lies a local maximum of the response. There \
         sin 2Mx = O(M^-2), so Mx = (k - 1/2) pi + O(M^-2) and w_k = (2k - 1) w_1 (1 + O(M^-2)). Its height is A_1/(2k - 1)² (1 + O(M^-2)), because \
         y grows with w². (notes/veerman_platoons.md; damping flattens all but about sqrt(M ln M) of them, and none is left \
         for small M.) Coq has that they are there and lower, not how high.",
        LesserVariant { offset: -1, order: 2, least_height: (0, 1) },
        examine_lesser,
    )
    .reading("For fixed k and large flocks, like the theorem; roughly: up to a relative error that tends to 0.")
    .clauses(&[
        "There are resonances located roughly at the odd multiples of the main resonance.",
        "They are lesser: the response is lower there than at the main resonance.",
    ])
    .altered("at the even multiples", |v| v.offset = -2)
    .altered("an error of the order M^-3", |v| v.order = 3)
    .altered("at least half as high as the main one", |v| v.least_height = (1, 2))
}

fn examine_lesser(variant: &LesserVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut results = Vec::new();
    for k in LESSER {
        let multiple = 2 * k as i64 + variant.offset;
        let place = |gains: &Gains<Rational>, m: u64| -> Result<Interval, CheckError> {
            let (main, lesser) = (resonance(gains, m, DIGITS)?, lesser_resonance(gains, m, k, DIGITS)?);
            let ratio = lesser.omega.over(&main.omega)?;
            Ok(ratio.clone() * ratio.ratio(1, multiple) - ratio.one())
        };
        let name = format!("omega_{k}_over_omega_1");
        results.push(scaled_error_is_bounded(SMALLEST, run, &name, variant.order, place).on([1]).checks("step 4"));
        results.push(heights(variant, k, run).on([2]).checks("the conclusion"));
    }
    let note = "notes/veerman_platoons.md, lesser resonances, steps";
    results.push(argued(&[1], "places, with the order of the error", &format!("{note} 1 to 4")));
    results.push(argued(&[2], "heights", &format!("{note} 5 and 6")));
    Run::all(results)
}

/// The lesser resonance is lower than the main one.
fn heights(variant: &LesserVariant, k: u64, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut ratios = Vec::new();
    for m in [SMALLEST, 64 * SMALLEST] {
        let (main, lesser) = (resonance(&unit(), m, DIGITS)?, lesser_resonance(&unit(), m, k, DIGITS)?);
        let ratio = lesser.amplitude.over(&main.amplitude)?;
        run.value(&format!("height_of_resonance_{k}_over_the_main_one_f_g_-1_M_{m}"), interval_value(&ratio, 8));
        ratios.push((m, ratio));
    }
    let evidence =
        certified(format!("height of resonance {k}"), "a certified local maximum, certainly lower than the main one");
    run.every(evidence, ratios, |(m, ratio)| {
        let least = ratio.ratio(variant.least_height.0, variant.least_height.1);
        let lower = (ratio.one() - &ratio).is_certainly_positive() && !(ratio.clone() - least).is_certainly_negative();
        let size = interval_value(&ratio, 6);
        Ok((!lower).then(|| format!("f = g = -1, {m} followers: resonance {k} is {size} of the main one")))
    })
}

pub fn size_limit() -> Record<ExponentVariant> {
    Record::new(
        "veerman.prop2",
        "The last car oscillates with a_0 A, and A = (N+1)/X + O(1/N), X = pi² |g|/(8 sqrt2 sqrt|f|) (Theorem 1). So a_0 A <= D means \
         N + 1 <= X D/a_0 + O(1/N). A increases with N for large N \
         (by 1/X + O(N^-2) per car), so this is a limit. Checked for the tie D = a_0 A: N + 1 - X D/a_0 is O(1/M); and N <= X D/a_0 without any \
         correction for small flocks too.",
        ExponentVariant { divisor: 8, power: 1, order: 1 },
        |variant, run| {
            let error = |gains: &Gains<Rational>, m: u64| {
                let bound = tie(variant, gains, m)?;
                Ok(bound.integer(m as i64) - bound)
            };
            let tie = scaled_error_is_bounded(32, run, "N+1-X*D/a_0", variant.order, error)?;
            Run::all([Ok(tie), small_flocks(variant, run)])
        },
    )
    .reading("N <~ X D/a_0, as usual, up to terms that are small against X D/a_0; what stays within D is the equilibrium oscillation of the last car (the particular solution), \
         as in Proposition 1; a_0, D > 0 and f, g < 0.")
    .altered("4 sqrt2 instead of 8 sqrt2", |v| v.divisor = 4)
    .altered("|f| instead of sqrt|f|", |v| v.power = 2)
    .altered("16 sqrt2 instead of 8 sqrt2", |v| v.divisor = 16)
    .altered("an error of the next order", |v| v.order = 2)
}

/// `X D/a_0` where D is just what the flock of M followers needs.
fn tie(variant: &ExponentVariant, gains: &Gains<Rational>, m: u64) -> Result<Interval, CheckError> {
    let (found, intervals) = enclosed(gains, m)?;
    Ok(variant.value(&intervals)? * found.amplitude)
}

/// `N < X D/a_0` where D is just what the flock of N + 1 followers needs, from one follower on.
fn small_flocks(variant: &ExponentVariant, run: &Run) -> Result<Outcome, CheckError> {
    const MOST: u64 = 24;
    let list = [((-1, 1), (-1, 1)), ((-1, 1), (-1, 100)), ((-1, 4), (-5, 1))].map(gains);
    let cases = list.iter().flat_map(|gains| (1..=MOST).map(move |m| (gains, m)));
    let detail = format!("N < X D/a_0 for the smallest D that allows N, N = 0 to {}, three pairs (f, g)", MOST - 1);
    run.every(certified("small flocks", detail), cases, |(gains, m)| {
        let bound = tie(variant, gains, m)?;
        let holds = (bound.clone() - bound.integer(m as i64 - 1)).is_certainly_positive();
        let size = interval_value(&bound, 8);
        Ok((!holds).then(|| format!("f = {}, g = {}, N = {}: the bound is {size}", gains.f, gains.g, m - 1)))
    })
}
