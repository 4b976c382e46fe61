//! veerman.cor2, veerman.lem3: without small frequencies there is no resonance in system (2).

use super::{enclosed, gains, negative_gains, unit};
use crate::prelude::*;
use arithmetic::Signed;
use models::platoon::{Gains, chebyshev, gamma, larger_root_modulus};

/// Gains and frequencies at which the bounds are checked, with the sizes.
fn points(sizes: &[u64]) -> Vec<(Gains<Rational>, Rational, u64)> {
    let pairs = [((-1, 1), (-1, 1)), ((-4, 1), (-1, 3)), ((-1, 5), (-3, 1)), ((-1, 1), (-1, 1000))];
    let frequencies = [(1, 100), (1, 10), (1, 1), (7, 5), (20, 1)];
    let mut points = Vec::new();
    for pair in pairs {
        for (p, q) in frequencies {
            points.extend(sizes.iter().map(|&m| (gains(pair), rational(p, q), m)));
        }
    }
    points
}

/// `|mu_+| != |mu_-|` for `w != 0` (or for all w), and `|a_M| <= 2/(rho^{cM} - rho^{-cM})`, `rho = max |mu_+-|`.
#[derive(Clone, Copy)]
pub struct DecayVariant {
    zero_included: bool,
    rate: (u64, u64),
    /// `Im gamma (f² + w² g²) = sign g w³`.
    sign: i64,
}

/// `gamma` is not real: its imaginary part is `-g w³/(f² + w² g²)`; and `Im gamma` vanishes where `|mu| = 1`.
fn imaginary_part(variant: &DecayVariant) -> Identity<'_> {
    Identity::of(move |[f, g, w, mu_re, mu_im]| {
        let by_gains = gamma(&Gains { f: f.clone(), g: g.clone() }, w)?.im * (f.square() + (w.clone() * g).square());
        let mu = Complex::new(mu_re.clone(), mu_im.clone());
        let by_root = (mu.clone() + mu.recip()?).im * mu.norm_squared();
        let odd = g.integer(variant.sign) * g * w.power(3);
        Ok((vec![by_gains, by_root], vec![odd, mu_im.clone() * (mu.norm_squared() - f.one())]))
    })
    .within(negative_gains)
}

pub fn exponential_decay() -> Record<DecayVariant> {
    Record::new(
        "veerman.cor2",
        "mu_+ mu_- = 1, so equal moduli mean |mu_+| = 1; then gamma = (mu + 1/mu)/2 = Re mu is real. But Im gamma = -g w³/(f² + w² g²) \
         is not 0 for f, g < 0 and w != 0. With rho = max |mu_+-| > 1, which does not depend on N, |a_M| = 2/|mu_+^M + mu_-^M| lies between 2/(rho^M + rho^-M) and \
         2/(rho^M - rho^-M): exponential decay at the exact rate ln rho. At w = 0 both roots are 1 and a_N = 1.",
        DecayVariant { zero_included: false, rate: (1, 1), sign: -1 },
        |variant, run| {
            let names = ["f", "g", "w", "Re mu", "Im mu"];
            let part = "Im gamma by the gains and by mu: |mu| = 1 only at w = 0";
            let moduli = run.identity(&imaginary_part(variant), &names, part)?.on([1]).for_all();
            Run::all([Ok(moduli), at_zero(variant), decay_bounds(variant, run).on([2])])
        },
    )
    .reading("a_N is the amplitude of the last car; that of its predecessor is gamma times it.")
    .clauses(&[
        "For w != 0, |mu_+| != |mu_-| (f, g < 0).",
        "For fixed w != 0, a_N decays exponentially as function of N (f, g < 0).",
    ])
    .altered("for w = 0 too", |v| v.zero_included = true)
    .altered("a rate larger by 1/10", |v| v.rate = (11, 10))
    .altered("the opposite sign of Im gamma", |v| v.sign = 1)
}

/// At w = 0, gamma = 1 exactly and both roots are 1.
fn at_zero(variant: &DecayVariant) -> Result<Outcome, CheckError> {
    let gamma = gamma(&unit(), &rational(0, 1))?;
    let evidence = exact("w = 0", "gamma = 1 and mu_+ = mu_- = 1, which the statement excludes").on([1]);
    let wrong = variant.zero_included && gamma == gamma.one();
    unless(wrong.then(|| "w = 0: |mu_+| = |mu_-| = 1".to_string()), evidence)
}

fn decay_bounds(variant: &DecayVariant, run: &Run) -> Result<Outcome, CheckError> {
    const PRECISION: u32 = 400;
    let detail = "rho > 1 and (rho^M - rho^-M)/2 <= 1/|a_M| <= (rho^M + rho^-M)/2 up to a relative 2^-64, M up to 1000";
    let evidence = certified("decay at the rate ln rho", detail);
    run.every(evidence, points(&[1, 2, 3, 10, 100, 1000]), |(gains, w, m)| {
        let (interval, at) = (enclosed(&gains, PRECISION), Interval::from_rational(&w, PRECISION));
        let rho = larger_root_modulus(&interval, &at)?;
        let distance = gamma(&interval, &at)? - Complex::real(at.one());
        let inverse = chebyshev(m, &distance).0.norm_squared().sqrt()?;
        let power = rho.power(m);
        // rho^(pM/q) by logarithms.
        let (p, q) = variant.rate;
        let claimed = if p == q { power.clone() } else { (rho.ln()? * rho.ratio((p * m) as i64, q as i64)).exp()? };
        let upper = inverse.clone() - (claimed.clone() - claimed.recip()?).scaled(-1);
        let lower = (power.clone() + power.recip()?).scaled(-1) - &inverse;
        // Ties are possible where the terms are parallel; they are decided up to 2^-64 of the value.
        let slack = inverse.scaled(-64);
        let violated = [upper, lower].iter().any(|gap| (gap.clone() + &slack).is_certainly_negative());
        let wrong = violated || !(rho.clone() - rho.one()).is_certainly_positive();
        Ok(wrong.then(|| {
            let size = interval_value(&inverse, 8);
            format!("f = {}, g = {}, w = {w}, {m} followers: 1/|a| = {size}", gains.f, gains.g)
        }))
    })
}

/// `|a_M(w)| Im(gamma(w)) M^power <= bound`, and the first number in the derivative of `Im gamma`.
#[derive(Clone, Copy)]
pub struct SmallVariant {
    bound: (i64, i64),
    power: u64,
    slope: i64,
}

/// The derivative of `Im gamma = b a³/(1 + b² a²)` is `b a² (3 + b² a²)/(1 + b² a²)²`, positive for `a, b > 0`.
fn increasing(variant: &SmallVariant) -> Identity<'_> {
    Identity::of(move |[a, b]| {
        let dual = |x: &Probe, slope: i64| Dual::new(x.clone(), x.integer(slope));
        let gains = Gains { f: dual(&-a.one(), 0), g: dual(&-b.clone(), 0) };
        let imaginary = gamma(&gains, &dual(a, 1))?.im;
        let c2 = (a.clone() * b).square();
        let claimed =
            (b.clone() * a.square() * (a.integer(variant.slope) + &c2)).over(&(c2.clone() + a.one()).square())?;
        Ok((vec![imaginary.derivative], vec![claimed]))
    })
}

pub fn only_small_frequencies() -> Record<SmallVariant> {
    Record::new(
        "veerman.lem3",
        "|a_M(w)| <= 1/(M Im gamma(w)) for all f, g < 0, w > 0 and M >= 1. With gamma = cos(x - iy): \
         1/|a_M|² = cos²(Mx) + sinh²(My) >= (M sinh y)² >= (M sin x sinh y)² = (M Im gamma)². Im gamma = b a³/(1 + a² b²) (a = w/sqrt|f|, \
         b = |g|/sqrt|f|) is 0 at w = 0 and increases, so |a_M| >= A forces w below the root of Im gamma = 1/(AM), which tends to 0.",
        SmallVariant { bound: (1, 1), power: 1, slope: 3 },
        examine_small,
    )
    .reading(
        "In large flocks only small frequencies are amplified: if |a_M(w_M)| >= A > 0 for all M, then w_M -> 0. \
         Frequencies are positive; at -w the response is the conjugate of that at w.",
    )
    .altered("a bound smaller by 1/100", |v| v.bound = (99, 100))
    .altered("M² instead of M", |v| v.power = 2)
    .altered("the derivative of Im gamma with -3 for 3", |v| v.slope = -3)
}

fn examine_small(variant: &SmallVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "|a_M| M Im gamma <= 1 exactly; f, g < 0, frequencies from 1/100 to 20, up to 20 followers";
    let cases = points(&[1, 2, 3, 5, 8, 20]);
    let instances = run.instances("bound of the response", detail, cases, |(gains, w, m)| {
        let gamma = gamma(&gains, &w)?;
        // Squared: F bound² >= M^{2 power} (Im gamma)², exactly.
        let inverse_square = chebyshev(m, &(gamma.clone() - gamma.one())).0.norm_squared();
        let bound = rational(variant.bound.0, variant.bound.1).square() * &inverse_square;
        if bound >= (rational(m as i64, 1).power(variant.power) * &gamma.im).square() {
            return Ok(None);
        }
        let interval = |q: &Rational| Interval::from_rational(q, 80);
        let size = interval_value(&interval(&inverse_square).recip()?.sqrt()?, 8);
        let imaginary = interval_value(&interval(&gamma.im), 8);
        let Gains { f, g } = gains;
        Ok(Some(format!("f = {f}, g = {g}, w = {w}, {m} followers: |a_M| is {size}, Im gamma {imaginary}")))
    });
    for m in [100, 10_000, 1_000_000] {
        run.value(&format!("w_above_which_nothing_is_amplified_f_g_-1_M_{m}"), interval_value(&threshold(m)?, 6));
    }
    let increasing = run.identity(&increasing(variant), &["w/sqrt|f|", "|g|/sqrt|f|"], "Im gamma increases with w");
    Run::all([instances, increasing])
}

/// The root of `a³/(1 + a²) = 1/M`, between two decimals found by bisection.
fn threshold(m: i64) -> Result<Interval, CheckError> {
    let beyond = |a: &Rational| a.power(3) * rational(m, 1) > rational(1, 1) + a.square();
    let (mut low, mut high) = (rational(0, 1), rational(2, 1));
    for _ in 0..40 {
        let middle = (&low + &high) / rational(2, 1);
        if beyond(&middle) { high = middle } else { low = middle }
    }
    Ok(Interval::hull_of_rationals(&low, &high, 60))
}
