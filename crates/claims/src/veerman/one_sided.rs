//! veerman.cor1, veerman.cor1_special, veerman.cor1.proof, veerman.gain_iff, veerman.gain_max: tracking only the car in
//! front.

use super::{complex_gains, enclosed, imaginary, negative_gains, parts, unit};
use crate::prelude::*;
use arithmetic::Signed;
use models::platoon::{
    Communication, Gains, accelerations, amplitude_one_sided, gain_fraction_one_sided, gain_squared_one_sided,
    strongest_one_sided_square,
};

/// `gamma = (f + damping_sign i w g + square_sign w²)/(f + damping_sign i w g)`, `a_k = gamma^(-k + offset)` or its
/// inverse.
#[derive(Clone, Copy)]
pub struct ResponseVariant {
    damping_sign: i64,
    square_sign: i64,
    inverse: bool,
    offset: u64,
}

impl ResponseVariant {
    /// `a_k/a_{k-1}` as claimed.
    fn ratio<T: Field>(&self, f: &T, g: &T, w: &T) -> Result<Complex<T>, ArithmeticError> {
        let z = Complex::new(f.clone(), f.integer(self.damping_sign) * g * w);
        let numerator = z.clone() + Complex::real(f.integer(self.square_sign) * w.square());
        if self.inverse { z.over(&numerator) } else { numerator.over(&z) }
    }
}

const CARS: u64 = 4;

/// The amplitudes of the first cars satisfy equation (1).
fn satisfies_equation_1(variant: &ResponseVariant) -> Identity<'_> {
    Identity::of(move |[f, g, w]| {
        let ratio = variant.ratio(f, g, w)?;
        let amplitudes: Vec<Complex<Probe>> = (1..=CARS).map(|k| ratio.power(k + variant.offset)).collect();
        let iw = imaginary(w);
        let rates: Vec<Complex<Probe>> = amplitudes.iter().map(|a| a.clone() * &iw).collect();
        let forces = accelerations(Communication::Front, &complex_gains(f, g), (&iw.one(), &iw), &amplitudes, &rates);
        let second_rates = rates.iter().map(|u| u.clone() * &iw);
        Ok((parts(second_rates), parts(forces)))
    })
    .within(negative_gains)
}

/// One step of the recurrence, from any amplitude in front: with the first cars it proves all.
fn step_of_equation_1(variant: &ResponseVariant) -> Identity<'_> {
    Identity::of(move |[f, g, w, re, im]| {
        let front = Complex::new(re.clone(), im.clone());
        let iw = imaginary(w);
        let own = front.clone() * variant.ratio(f, g, w)?;
        let rate = own.clone() * &iw;
        let leader = (&front, &(front.clone() * &iw));
        let car = std::slice::from_ref;
        let force = accelerations(Communication::Front, &complex_gains(f, g), leader, car(&own), car(&rate));
        Ok((parts([rate * iw]), parts(force)))
    })
    .within(negative_gains)
}

pub fn response() -> Record<ResponseVariant> {
    Record::new(
        "veerman.cor1",
        "Put a_k e^{iwt} and its derivative i w a_k e^{iwt} into equation (1): -w² a_k = (f + i w g)(a_k - a_{k-1}), so \
         a_k (f + i w g + w²) = (f + i w g) a_{k-1}. For f, g < 0 neither factor vanishes. The step from a_{k-1} to a_k is the same for every k and is tested for any a_{k-1}.",
        ResponseVariant { damping_sign: 1, square_sign: 1, inverse: true, offset: 0 },
        |variant, run| {
            let names = ["f", "g", "w", "Re a_{k-1}", "Im a_{k-1}"];
            let first = "equation (1) for the first four cars, a_0 = 1";
            let step = "equation (1) for a_k = a_{k-1}/gamma, any k and a_{k-1}";
            Run::all([
                run.identity(&satisfies_equation_1(variant), &names[..3], first),
                run.identity(&step_of_equation_1(variant), &names, step).for_all(),
            ])
        },
    )
    .reading("x_k stands for the deviation x_k - h_k, as in equation (3), and a frequency is w >= 0.")
    .altered("- w² in gamma", |v| v.square_sign = -1)
    .altered("- i w g in gamma", |v| v.damping_sign = -1)
    .altered("a_k = gamma^k", |v| v.inverse = false)
    .altered("a_k = gamma^-(k+1)", |v| v.offset = 1)
}

/// `a_k = (1 + sign i sqrt|f|/g)^k` at `w² = |f|`, or with the power of the root and the gains exchanged.
#[derive(Clone, Copy)]
pub struct SpecialVariant {
    sign: i64,
    exchanged: bool,
}

/// The special amplitudes against those of Corollary 1, with `f = -r²` and `w = r`; and their conjugates at `w = -r`.
fn at_special_frequency(variant: &SpecialVariant) -> Identity<'_> {
    Identity::of(move |[r, g]| {
        let gains = Gains { f: -r.square(), g: g.clone() };
        let quotient = if variant.exchanged { g.over(r)? } else { r.over(g)? };
        let base = Complex::new(r.one(), r.integer(variant.sign) * quotient);
        let (mut found, mut printed) = (Vec::new(), Vec::new());
        for k in 1..=CARS {
            found.extend([amplitude_one_sided(&gains, r, k)?, amplitude_one_sided(&gains, &-r.clone(), k)?.conj()]);
            printed.extend([base.power(k), base.power(k)]);
        }
        Ok((parts(found), parts(printed)))
    })
    .within(|at| at[0] > rational(0, 1) && at[1] < rational(0, 1))
}

pub fn special_response() -> Record<SpecialVariant> {
    Record::new(
        "veerman.cor1_special",
        "With f = -w², 1/gamma = (f + i w g)/(i w g) = 1 + f/(i w g) = 1 + i w/g. At w = -sqrt|f| the amplitudes are the conjugates, which is \
         tested too.",
        SpecialVariant { sign: 1, exchanged: false },
        |variant, run| {
            let part = "a_1, ..., a_4 at w = +sqrt|f|, and their conjugates at w = -sqrt|f|";
            run.identity(&at_special_frequency(variant), &["sqrt|f|", "g"], part)
        },
    )
    .reading("A frequency is w >= 0, because the leader moves as cos w t: w² = |f| means w = +sqrt|f|.")
    .altered("1 - i sqrt|f|/g", |v| v.sign = -1)
    .altered("1 + i g/sqrt|f|", |v| v.exchanged = true)
    .altered("1 + 2 i sqrt|f|/g", |v| v.sign = 2)
}

/// What is substituted: `u_k = i w`, times `a_k` or not; `a_k` for `x_k - h_k` or for `x_k`. The common factor `e^{iwt}` is left
/// out (it is 1 at t = 0). What comes out on the left is `-w^power a_k`.
#[derive(Clone, Copy)]
pub struct SubstitutionVariant {
    with_amplitude: bool,
    of_deviation: bool,
    power: u64,
}

/// Variables f, g, w, the complex amplitudes `a_{k-1}`, `a_k` and the desired positions. The substitution must turn
/// both sides of equation (1) into the printed ones and agree with `x' = u`.
fn gives_printed_equation(variant: &SubstitutionVariant) -> Identity<'_> {
    Identity::of(move |[f, g, w, front_re, front_im, own_re, own_im, front_place, own_place]| {
        let front = Complex::new(front_re.clone(), front_im.clone());
        let own = Complex::new(own_re.clone(), own_im.clone());
        let deviation = |a: &Complex<Probe>, place: &Probe| {
            if variant.of_deviation { a.clone() } else { a.clone() - Complex::real(place.clone()) }
        };
        let iw = imaginary(w);
        let rate = |a: &Complex<Probe>| if variant.with_amplitude { iw.clone() * a } else { iw.clone() };
        let own_rate = rate(&own);
        let leader = (&deviation(&front, front_place), &rate(&front));
        let force = accelerations(
            Communication::Front,
            &complex_gains(f, g),
            leader,
            &[deviation(&own, own_place)],
            std::slice::from_ref(&own_rate),
        );
        let difference = own.clone() - &front;
        let printed_force = difference.scale(f) + iw.clone() * difference.scale(g);
        let left = force.into_iter().chain([own.clone() * &iw, own_rate.clone() * &iw]);
        let right = [printed_force, own_rate, -own.scale(&w.power(variant.power))];
        Ok((parts(left), parts(right)))
    })
    // Two cars that differ in place and motion: otherwise two of the terms can be wrong and nothing seen of one.
    .within(|at| negative_gains(at) && at[4] != at[6] && at[7] != at[8])
    .named(
        ["the right side of (1)", "the derivative of x_k", "the left side of (1)"]
            .into_iter()
            .flat_map(|what| [format!("the real part of {what}"), format!("the imaginary part of {what}")]),
    )
}

pub fn substitution() -> Record<SubstitutionVariant> {
    Record::new(
        "veerman.cor1.proof",
        "u_k is the derivative of x_k = a_k e^{iwt}, that is i w a_k e^{iwt}. The printed u_k = i w e^{iwt} lacks a_k; with \
         it u_k - u_{k-1} would be zero and the left side -w². And a_k e^{iwt} stands for the deviation x_k - h_k (the paper's \
         z = x - h), since equation (1) contains the desired positions. The resulting equation is the right one.",
        SubstitutionVariant { with_amplitude: false, of_deviation: false, power: 2 },
        |variant, run| {
            let names = ["f", "g", "w", "Re a_{k-1}", "Im a_{k-1}", "Re a_k", "Im a_k", "h_{k-1}", "h_k"];
            let part = "both sides of equation (1), and u_k = x_k'";
            run.identity(&gives_printed_equation(variant), &names, part).for_all()
        },
    )
    .repaired_by(
        Fault::Typo,
        "Substituting x_k - h_{x,k} = a_k e^{i w t} and u_k = i w a_k e^{i w t} in Equation (1) gives \
         - w^2 a_k = f (a_k - a_{k-1}) + i w g (a_k - a_{k-1}).",
        |v| (v.with_amplitude, v.of_deviation) = (true, true),
    )
    .altered("u_k = i w e^{iwt}", |v| v.with_amplitude = false)
    .altered("x_k = a_k e^{iwt}, not x_k - h_k", |v| v.of_deviation = false)
    .altered("- w a_k on the left", |v| v.power = 1)
}

/// `|1/gamma| > 1` iff `w² < bound |f|` (or `<=`), for all `w >= 0` or for `w > 0`.
#[derive(Clone, Copy)]
pub struct GainVariant {
    bound: i64,
    zero_included: bool,
    bound_included: bool,
}

/// `(|1/gamma|² - 1) |gamma denominator|² = w² (bound |f| - w²)`.
pub(crate) fn gain_factors(bound: i64) -> Identity<'static> {
    Identity::of(move |[f, g, w]| {
        let y = w.square();
        let gains = Gains { f: f.clone(), g: g.clone() };
        let (_, denominator) = gain_fraction_one_sided(&gains, &y);
        let left = (gain_squared_one_sided(&gains, &y)? - f.one()) * denominator;
        let right = (-(f.integer(bound) * f) - &y) * &y;
        Ok((vec![left], vec![right]))
    })
    .within(negative_gains)
}

fn examine_gain(variant: &GainVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "the sign of |1/gamma| - 1 is that of w² (2|f| - w²), for all f, g < 0";
    let factors = run.identity(&gain_factors(variant.bound), &["f", "g", "w"], part)?.on([1, 2]).for_all();
    let gain = |y| gain_squared_one_sided(&unit(), &rational(y, 1));
    if variant.zero_included && gain(0)? <= rational(1, 1) {
        let evidence = exact("w = 0", "gamma = 1 + w²/(f + i w g) = 1");
        let what = "w = 0, any f, g < 0: w² = 0 < 2|f|, but gamma = 1 and |1/gamma| = 1 is not greater than one";
        return Ok(Outcome::fails(what, evidence.on([1])));
    }
    let tie = exact("w² = 2|f|", "f = g = -1: |1/gamma| = 1 exactly, not greater").on([2]);
    let wrong = (gain(2)? > rational(1, 1)) != variant.bound_included;
    Run::all([Ok(factors), unless(wrong.then(|| "f = g = -1, w² = 2: |1/gamma| = 1".to_string()), tie)])
}

pub fn gain_above_one() -> Record<GainVariant> {
    Record::new(
        "veerman.gain_iff",
        "(|1/gamma|² - 1) ((f + w²)² + g² w²) = w² (2|f| - w²), and the factor on the left is positive for f, g < 0. So \
         |1/gamma| > 1 exactly for 0 < w² < 2|f|. At w = 0 the car follows without amplification: |1/gamma| = 1, although \
         0 < 2|f|.",
        GainVariant { bound: 2, zero_included: true, bound_included: false },
        examine_gain,
    )
    .reading("A frequency is w >= 0, with 0 allowed: the text itself treats w = 0 apart in Corollary 2.")
    .clauses(&[
        "If w^2 < 2|f| (f, g < 0), |gamma^{-1}| is greater than one.",
        "If |gamma^{-1}| is greater than one (f, g < 0), w^2 < 2|f|.",
    ])
    .repaired_by(
        Fault::Hypothesis,
        "|gamma^{-1}| is greater than one if and only if 0 < w^2 < 2|f| (f, g < 0).",
        |v| v.zero_included = false,
    )
    .repaired_clauses(&[
        "If 0 < w^2 < 2|f| (f, g < 0), |gamma^{-1}| is greater than one.",
        "If |gamma^{-1}| is greater than one (f, g < 0), 0 < w^2 < 2|f|.",
    ])
    .altered("0 < w² < |f|", |v| v.bound = 1)
    .altered("0 < w² < 4|f|", |v| v.bound = 4)
    .altered("0 < w² <= 2|f|", |v| v.bound_included = true)
}

/// Where `|1/gamma|` is claimed to be largest: at `w² = |f|`, or at a multiple of `v = (f²/g²)(sqrt(1 + under_root g²/|f|) - 1)`, which is less
/// than a multiple of `|f|`.
#[derive(Clone, Copy)]
pub struct StrongestVariant {
    at_f: bool,
    of_location: (i64, i64),
    under_root: i64,
    below: (i64, i64),
}

/// With `|f| = v + 2u²` and `g = -2|f|u/v`, `v` is `(f²/g²)(r - 1)` for the positive root `r` of `1 + 2g²/|f|`; every `f, g < 0`
/// arises so with `0 < v < |f|`. The identity says that `|1/gamma|²` at the claimed place exceeds it at `y` by a
/// non-negative multiple of the squared distance, and that `v` is that number.
fn perfect_square(variant: &StrongestVariant) -> Identity<'_> {
    Identity::of(move |[v, u, y]| {
        let size = v.clone() + v.integer(2) * u.square();
        let gains = Gains { f: -size.clone(), g: -(v.integer(2) * &size * u).over(v)? };
        let (p, q) = variant.of_location;
        let place = if variant.at_f { size.clone() } else { v.ratio(p, q) * v };
        let largest = gain_squared_one_sided(&gains, &place)?;
        let (_, denominator) = gain_fraction_one_sided(&gains, y);
        let square = (largest.clone() - gain_squared_one_sided(&gains, y)?) * denominator;
        // r = (v + 4u²)/v is positive for v > 0.
        let root = (v.clone() + v.integer(4) * u.square()).over(v)?;
        let ratio = gains.g.square().over(&size)?;
        let location = (root.clone() - v.one()) * size.over(&ratio)?;
        let under_root = v.integer(variant.under_root) * ratio + v.one();
        let right = vec![largest * (y.clone() - place).square(), under_root, v.clone()];
        Ok((vec![square, root.square(), location], right))
    })
    .named(["the difference to the claimed maximum", "the square of r", "the location"])
}

/// The clauses of the correction are place, uniqueness, and `< |f|`.
fn examine_strongest(variant: &StrongestVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "largest at the claimed w² and nowhere else, for all f, g < 0 (|f| = v + 2u², g = -2|f|u/v)";
    let square = match run.identity(&perfect_square(variant), &["v", "u", "y"], part)? {
        Outcome::Fails { counterexample, .. } => {
            let at = |y| gain_squared_one_sided(&unit(), &y);
            let (at_f, beside) = (at(rational(1, 1))?, at(rational(3, 4))?);
            let printed = format!("f = g = -1: |1/gamma|² is {at_f} at w² = |f| = 1 and {beside} at w² = 3/4");
            let marks = vec![[1.into(), (&at_f).into()], [(&rational(3, 4)).into(), (&beside).into()]];
            let gain = Witness::Gain { f: (-1).into(), g: (-1).into(), marks };
            let printed = Counterexample::new(printed, [gain]);
            let what = if variant.at_f && beside > at_f { printed } else { counterexample };
            Outcome::fails(what, exact(part, "compared exactly")).on([1])
        }
        other => other.on([1, 2, 3]).for_all(),
    };
    let gains = enclosed(&unit(), 120);
    let peak = strongest_one_sided_square(&gains)?;
    run.value("w_squared_for_f_g_minus_1", interval_value(&peak, 20));
    run.value("gain_for_f_g_minus_1", interval_value(&gain_squared_one_sided(&gains, &peak)?.sqrt()?, 20));
    let (p, q) = variant.below;
    let above = !(peak.ratio(p, q) - &peak).is_certainly_positive();
    let what = || format!("f = g = -1: the place {} is not below {p}/{q} |f|", interval_value(&peak, 6));
    let below = unless(above.then(what), certified("below |f|", "enclosed, f = g = -1").on([3]));
    Run::all([Ok(square), below])
}

pub fn strongest_gain() -> Record<StrongestVariant> {
    Record::new(
        "veerman.gain_max",
        "With y = w², |1/gamma|² = (f² + g² y)/((y - |f|)² + g² y). Its derivative vanishes where g² y² + 2 f² y = 2|f|³. At \
         y = |f| the left side exceeds the right one by g² f² > 0, so the maximum always lies below |f|. \
         That the root v is the only place of the maximum: max - value = max (y - v)²/((y - |f|)² + g² y). For f = g = -1 it is sqrt(3) - 1.",
        StrongestVariant { at_f: true, of_location: (1, 1), under_root: 2, below: (1, 1) },
        examine_strongest,
    )
    .repaired_by(
        Fault::False,
        "|gamma^{-1}| is strongest when w^2 = (f^2/g^2) (sqrt(1 + 2 g^2/|f|) - 1) (f, g < 0) and only then; this is always less than |f|.",
        |v| v.at_f = false,
    )
    .repaired_clauses(&[
        "|gamma^{-1}| is strongest when w^2 = (f^2/g^2) (sqrt(1 + 2 g^2/|f|) - 1) (f, g < 0).",
        "It is strongest only then.",
        "This w^2 is always less than |f|.",
    ])
    .altered("half the root", |v| v.of_location = (1, 2))
    .altered("sqrt(1 + g²/|f|)", |v| v.under_root = 1)
    .altered("less than |f|/2", |v| v.below = (1, 2))
}
