//! veerman.sep_remark, veerman.prop1: separation and size limit where every car tracks only the one in front.

use super::negative_gains;
use crate::prelude::*;
use models::platoon::{Gains, amplitude_one_sided, gain_squared_one_sided};

/// `a_0 Re(gamma^{-k-1} e) - back a_0 Re(gamma^{-k} e + inside) + outside`.
#[derive(Clone, Copy)]
pub struct SeparationVariant {
    back: i64,
    inside: i64,
    outside: i64,
}

/// Car `k` at `h + a_0 Re(z e)`, car `k + 1` at `h + 1 + a_0 Re(z e/gamma)`, where `z` is any number in the place of
/// `gamma^-k` and `e = e^{iwt}` any phase.
fn difference(variant: &SeparationVariant) -> Identity<'_> {
    Identity::of(move |[f, g, w, a, u, z_re, z_im, h]| {
        let gains = Gains { f: f.clone(), g: g.clone() };
        // e = (1 + iu)/(1 - iu) runs through all phases but one.
        let half_turn = Complex::new(u.one(), u.clone());
        let phase = half_turn.over(&half_turn.conj())?;
        let front = Complex::new(z_re.clone(), z_im.clone()) * phase;
        let own = front.clone() * amplitude_one_sided(&gains, w, 1)?;
        let separation = |a: &Probe| {
            let position = |place: Probe, z: &Complex<Probe>| place + a.clone() * &z.re;
            position(h.clone() + h.one(), &own) - position(h.clone(), &front)
        };
        let inside = front.re.clone() + a.integer(variant.inside);
        let oscillation = a.clone() * &own.re - a.integer(variant.back) * a * inside;
        let still = separation(&a.zero());
        Ok((vec![separation(a) - &still, still], vec![oscillation, a.integer(variant.outside)]))
    })
    .within(|at| negative_gains(at) && at[3] > rational(0, 1))
    .named(["what a_0 adds to the separation", "the separation x_{k+1} - x_k for a_0 = 0"])
}

pub fn separation() -> Record<SeparationVariant> {
    Record::new(
        "veerman.sep_remark",
        "x_{k+1} - x_k = h_{k+1} - h_k + a_0 Re(gamma^{-k-1} e^{iwt}) - a_0 Re(gamma^{-k} e^{iwt}). With h_{k+1} - h_k = 1 the 1 is \
         added once and is not multiplied by a_0. As printed it stands inside the second real part and gives -a_0 instead of \
         +1; no sign of the separation and no a_0 > 0 makes that right. At w = 0 the separation is 1 and the printed formula gives -a_0.",
        SeparationVariant { back: 1, inside: 1, outside: 0 },
        |variant, run| {
            let names = ["f", "g", "w", "a_0", "tan(wt/2)", "Re gamma^-k", "Im gamma^-k", "h_k"];
            let part = "the difference of the positions, any k and t";
            run.identity(&difference(variant), &names, part).for_all()
        },
    )
    .repaired(
        Fault::Typo,
        "In the equilibrium oscillation x_k = h_k + a_0 Re(gamma^{-k} e^{i w t}) of system (1), if h_{k+1} - h_k = 1, the separation \
         x_{k+1} - x_k between two successive agents is a_0 Re(gamma^{-k-1} e^{i w t}) - a_0 Re(gamma^{-k} e^{i w t}) + 1.",
        SeparationVariant { back: 1, inside: 0, outside: 1 },
    )
    .altered("+ a_0 Re(gamma^{-k} e^{iwt})", |v| v.back = -1)
    .altered("without the 1", |v| v.outside = 0)
}

const PRECISION: u32 = 100;

/// The leader's frequency is `|f|^(half_powers/2)`, and the limit `factor ln(D/a_0)/ln(1 + |f|^a/|g|^b)` with `(a, b) = powers`.
#[derive(Clone, Copy)]
pub struct FrontLimitVariant {
    half_powers: u64,
    factor: (i64, i64),
    powers: (u64, u64),
}

impl FrontLimitVariant {
    /// The claimed gain per car, squared, for `|f| = r²`.
    fn growth<T: Field>(&self, r: &T, g: &T) -> Result<T, ArithmeticError> {
        let size = g.integer(if self.powers.1 % 2 == 1 { -1 } else { 1 }) * g.power(self.powers.1);
        Ok(r.power(2 * self.powers.0).over(&size)? + r.one())
    }
}

/// The squared gain per car at the leader's frequency, with `f = -r²`.
fn growth_per_car(variant: &FrontLimitVariant) -> Identity<'_> {
    Identity::of(move |[r, g]| {
        let gains = Gains { f: -r.square(), g: g.clone() };
        let gain = gain_squared_one_sided(&gains, &r.power(2 * variant.half_powers))?;
        Ok((vec![gain], vec![variant.growth(r, g)?]))
    })
    .within(|at| at[0] > rational(0, 1) && at[1] < rational(0, 1))
    .named(vec!["|1/gamma|² at the leader's frequency".to_string()])
}

/// The largest N for which the last car, number N + 1, stays within `ratio = D/a_0`; -1 if even one follower does not.
fn largest_size(growth: &Rational, ratio: &Rational) -> i64 {
    let limit = ratio * ratio;
    let mut power = growth.clone();
    let mut n = -1;
    while power <= limit {
        power *= growth;
        n += 1;
    }
    n
}

pub fn size_limit() -> Record<FrontLimitVariant> {
    Record::new(
        "veerman.prop1",
        "At w² = |f|, Corollary 1 gives |a_k| = a_0 (1 + |f|/g²)^{k/2}, which grows with k, so the last car stays within D \
         exactly if N + 1 <= 2 ln(D/a_0)/ln(1 + |f|/g²) =: X, that is for N <= floor(X) - 1: within the printed N <~ X, \
         sharp up to less than 2. But the frequency is sqrt|f|, not |f|: at w = |f| the squared gain is (1 + g²)/((|f| - 1)² + g²), which is \
         even below 1 for |f| > 2, so that there is no limit at all.",
        FrontLimitVariant { half_powers: 2, factor: (2, 1), powers: (1, 2) },
        examine_limit,
    )
    .reading("N <~ X is read as N <= X; what stays within D is the equilibrium oscillation (the particular solution), as in the proof; a_0, D > 0 and f, g < 0.")
    .repaired_by(Fault::Typo, "", |v| v.half_powers = 1)
    .repaired_clauses(&[
        "Let f, g < 0, a_0 > 0 and D > 0. If the leader of system (1) oscillates at the frequency sqrt(|f|) with the amplitude a_0 and the \
         equilibrium oscillation (the particular solution) of the last car, number N + 1, stays within D, then N + 1 <= 2 ln(D/a_0)/ln(1 + \
         |f|/g^2).",
        "With the same f, g, a_0, D and leader, if N + 1 >= 1 is at most that, the equilibrium oscillation of the last car stays within D.",
    ])
    .altered("without the factor 2", |v| v.factor = (1, 1))
    .altered("the factor 3", |v| v.factor = (3, 1))
    .altered("|f|/|g|", |v| v.powers = (1, 1))
    .altered("f²/g²", |v| v.powers = (2, 2))
}

fn examine_limit(variant: &FrontLimitVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "the gain per car at the leader's frequency, |f| = r²";
    let growth = run.identity(&growth_per_car(variant), &["r", "g"], part)?;
    if let Outcome::Fails { counterexample, evidence, later } = growth {
        let counterexample = no_limit(variant)?.unwrap_or(counterexample);
        return Ok(Outcome::Fails { counterexample, evidence, later }.on([1]));
    }
    Run::all([Ok(growth), limit_instances(variant, run)]).on([1, 2])
}

/// Where the response at the claimed frequency decays although a limit is claimed: f = -4, g = -1.
fn no_limit(variant: &FrontLimitVariant) -> Result<Option<Counterexample>, CheckError> {
    let (r, g) = (rational(2, 1), rational(-1, 1));
    let gains = Gains { f: -r.square(), g: g.clone() };
    let (w, claimed) = (r.power(variant.half_powers), variant.growth(&r, &g)?);
    let gain = gain_squared_one_sided(&gains, &w.square())?;
    Ok((gain <= rational(1, 1) && claimed > rational(1, 1)).then(|| {
        let text = format!("f = -4, g = -1, leader's frequency {w}: |1/gamma|² is {gain}, so no car moves more than the leader and N is not limited, but a limit with ln({claimed}) is claimed");
        let marks = vec![[(&w.square()).into(), (&gain).into()]];
        Counterexample::new(text, [Witness::Gain { f: (-4).into(), g: (-1).into(), marks }])
    }))
}

/// The exact largest size against the enclosed bound X. Since N + 1 <= X for it and not for the next size, `X - 2 < N <= X - 1`.
fn limit_instances(variant: &FrontLimitVariant, run: &Run) -> Result<Outcome, CheckError> {
    // For |f| = 9, g = -4 the gain per car is 5/4 exactly, so D/a_0 = 5/4 and 25/16 are ties.
    let gains = [((1, 1), (-1, 1)), ((2, 1), (-1, 1)), ((1, 2), (-2, 1)), ((1, 1), (-1, 5)), ((3, 1), (-4, 1))];
    let ratios = [(1, 1), (5, 4), (25, 16), (2, 1), (10, 1), (1000, 1), (1_000_000, 1)];
    let cases = gains.iter().flat_map(|gains| ratios.iter().map(move |ratio| (*gains, *ratio)));
    let detail = "the largest N with (1 + |f|/g²)^(N+1) <= (D/a_0)², found exactly: N + 1 is at most the bound X and N + 2 is not";
    run.every(certified("largest sizes", detail), cases, |((r, g), ratio)| {
        let [r, g, ratio] = [r, g, ratio].map(|(p, q)| rational(p, q));
        let growth = gain_squared_one_sided(&Gains { f: -r.square(), g: g.clone() }, &r.square())?;
        let exact = largest_size(&growth, &ratio);
        let interval = |q: &Rational| Interval::from_rational(q, PRECISION);
        let per_car = interval(&variant.growth(&r, &g)?).ln()?;
        let factor = interval(&rational(variant.factor.0, variant.factor.1));
        let bound = (interval(&ratio).ln()? * factor).over(&per_car)?;
        let (lo, hi) = bound.to_rationals();
        let wrong = rational(exact + 1, 1) > hi || rational(exact + 2, 1) <= lo;
        Ok(wrong.then(|| {
            let bound = interval_value(&bound, 8);
            format!("|f| = {}, g = {g}, D/a_0 = {ratio}: the largest N is {exact}, the bound {bound}", r.square())
        }))
    })
}
