//! beyond.veerman.resonance_frequency, beyond.veerman.resonance_amplitude: the resonance to the next order, with explicit bounds
//! of the error.

use crate::prelude::*;
use crate::veerman::{enclosed, gains, scaled_error_is_bounded};
use arithmetic::{Series, Signed};
use models::platoon::{Gains, Resonance, next_order, resonance, theorem1};

const DIGITS: u32 = 40;

/// The correction to Theorem 1 times a factor, for `M + offset` followers, and the coefficient of `a²` in the expansion of step 1.
#[derive(Clone, Copy)]
pub struct NextOrderVariant {
    correction: (i64, i64),
    offset: i64,
    quadratic: (i64, i64),
}

const PRINTED: NextOrderVariant = NextOrderVariant { correction: (1, 1), offset: 0, quadratic: (1, 12) };

fn with_controls(record: Record<NextOrderVariant>) -> Record<NextOrderVariant> {
    record
        .control("the correction with the opposite sign", NextOrderVariant { correction: (-1, 1), ..PRINTED })
        .control("a correction larger by 1/1000", NextOrderVariant { correction: (1001, 1000), ..PRINTED })
        .control("N instead of N + 1", NextOrderVariant { offset: -1, ..PRINTED })
        .control("step 1 of the proof: with a²/6", NextOrderVariant { quadratic: (1, 6), ..PRINTED })
}

fn gains_list() -> [Gains<Rational>; 5] {
    [((-1, 1), (-1, 1)), ((-2, 1), (-1, 2)), ((-1, 3), (-2, 1)), ((-1, 1), (-1, 1000)), ((-9, 1), (-60, 1))].map(gains)
}

/// A formula of M cars.
type Formula = fn(&Gains<Interval>, u64) -> Result<Interval, ArithmeticError>;

/// Coefficients that are compared: up to `a⁵`.
const ORDER: usize = 6;

/// The expansion of both proofs, as exact power series in `a`: with `theta = x - iy = sqrt2 a H`,
/// `H = 1 + a²/12 - 3c²/8 - i (c/2)(1 + a²/4 - 5c²/8) + O(a⁴)`, `c = ab`, `cos theta` is `gamma = 1 - a²/(1 + ic)` up to `O(a⁶)`.
fn expansion(quadratic: (i64, i64)) -> Identity<'static> {
    Identity::of(move |[b]| {
        let real = |p, q| Complex::real(b.ratio(p, q));
        let a = Series::variable(real(1, 1), ORDER);
        let ic = Series::variable(Complex::new(b.zero(), b.clone()), ORDER);
        let (s, c2) = (a.square(), -ic.square());
        let bracket = |first: (i64, i64), second: (i64, i64)| {
            s.one() + s.scale(&real(first.0, first.1)) - c2.scale(&real(second.0, second.1))
        };
        let h = bracket(quadratic, (3, 8)) - ic.scale(&real(1, 2)) * bracket((1, 4), (5, 8));
        // cos(sqrt2 a H) = 1 - (aH)² + (aH)⁴/6 - ...
        let square = (a * h).square();
        let cosine = s.one() - &square + square.square().scale(&real(1, 6));
        let gamma = s.one() - s.clone() * (s.one() + ic).recip()?;
        let split = |series: Series<Complex<Probe>>| {
            series.coefficients().iter().flat_map(|z| [z.re.clone(), z.im.clone()]).collect::<Vec<Probe>>()
        };
        Ok((split(cosine), split(gamma)))
    })
}

/// What one of the two claims is about.
struct Quantity {
    name: &'static str,
    found: fn(Resonance) -> Interval,
    leading: Formula,
    next: Formula,
    /// Of the error, in units of `(a0 max(1, b))^4`.
    bound: (i64, i64),
    /// `M^power (found - leading)` tends to `limit`.
    power: u64,
    limit: fn(&Gains<Interval>) -> Result<Interval, ArithmeticError>,
    steps: &'static str,
}

/// Enclosures against the formula, from the smallest size of the statement on; the expansion that both proofs start from; the limit.
fn examine(part: &Quantity, variant: &NextOrderVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = Vec::new();
    for exact in gains_list() {
        let smallest = smallest_size(&exact)?;
        let mut sizes = vec![smallest, smallest + 1, 2 * smallest, 7 * smallest, 100 * smallest, 10_000 * smallest];
        if run.cases(0, 1) == 1 {
            sizes.extend(smallest..smallest + 60);
        }
        cases.extend(sizes.into_iter().map(|m| (exact.clone(), m)));
    }
    let mut worst: Option<Interval> = None;
    let limit = rational(part.bound.0, part.bound.1);
    let detail =
        "enclosures for five pairs (f, g), b from 1/1000 to 20, and sizes from the smallest to 10^4 times that";
    let enclosures = run.every(certified(part.name, detail), cases, |(exact, m)| {
        let scaled = scaled_error(part, variant, &exact, m)?;
        let (lo, hi) = scaled.to_rationals();
        if lo < -limit.clone() || hi > limit {
            let (size, Gains { f, g }) = (interval_value(&scaled, 6), exact);
            let name = part.name;
            return Ok(Some(format!(
                "f = {f}, g = {g}, {m} followers: the relative error of the {name} is {size} (a0 max(1, b))^4"
            )));
        }
        if worst.as_ref().is_none_or(|w| w.magnitude() < scaled.magnitude()) {
            worst = Some(scaled);
        }
        Ok(None)
    })?;
    if let Some(worst) = worst {
        run.value("largest_error_met_in_units_of_the_fourth_power", interval_value(&worst, 6));
    }
    let expansion =
        run.identity(&expansion(variant.quadratic), &["b"], "the expansions of x and y in a, exact power series")?;
    Run::all([
        Ok(enclosures).checks("the conclusion"),
        Ok(expansion).checks("the coefficients of step 1"),
        argued(&[], "all f, g < 0 and M >= 5 max(1, b)", part.steps),
    ])
}

/// The relative error of the formula, in units of `(a0 max(1, b))^4`.
fn scaled_error(
    part: &Quantity,
    variant: &NextOrderVariant,
    exact: &Gains<Rational>,
    m: u64,
) -> Result<Interval, CheckError> {
    let found = (part.found)(resonance(exact, m, DIGITS)?);
    let gains = enclosed(exact, found.precision());
    let size = m.saturating_add_signed(variant.offset);
    let (leading, next) = ((part.leading)(&gains, size)?, (part.next)(&gains, size)?);
    let correction = (next - &leading) * leading.ratio(variant.correction.0, variant.correction.1);
    let relative = (found - &leading - correction).over(&leading)?;
    let b2 = next_order::relative_damping_square(&gains)?;
    let larger = if (b2.clone() - b2.one()).is_certainly_positive() { b2.clone() } else { b2.one() };
    Ok(relative.over(&(next_order::square_of_leading(&b2, m)? * larger).square())?)
}

/// `M^power (found - leading)` tends to the stated limit: what the enclosed resonance still lacks is `O(M^-2)`.
fn examine_limit(part: &Quantity, variant: &NextOrderVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let name = format!("M^{}_(found_-_Theorem_1)_minus_its_limit", part.power);
    scaled_error_is_bounded(32, run, &name, 2, |exact, m| {
        let found = (part.found)(resonance(exact, m, 2 * DIGITS)?);
        let gains = enclosed(exact, found.precision());
        let difference = found - (part.leading)(&gains, m.saturating_add_signed(variant.offset))?;
        let reached = difference.clone() * difference.integer(m as i64).power(part.power);
        let limit = (part.limit)(&gains)?;
        Ok(reached - limit.ratio(variant.correction.0, variant.correction.1) * limit)
    })
    .checks("step 12")
}

/// The least integer M with `M >= 5 max(1, b)`, from `M² |f| >= 25 g²`.
fn smallest_size(gains: &Gains<Rational>) -> Result<u64, CheckError> {
    let ratio = (gains.g.square() * rational(25, 1)).over(&-gains.f.clone())?;
    let mut m = next_order::SMALLEST_SIZE;
    while rational(m as i64, 1).square() < ratio {
        m += 1;
    }
    Ok(m)
}

const FREQUENCY: Quantity = Quantity {
    name: "frequency",
    found: |resonance| resonance.omega,
    leading: theorem1::frequency,
    next: next_order::frequency,
    bound: next_order::FREQUENCY_BOUND,
    power: 3,
    limit: next_order::frequency_limit,
    steps: "notes/veerman_next_order.md, steps 1 to 7",
};

const AMPLITUDE: Quantity = Quantity {
    name: "amplitude",
    found: |resonance| resonance.amplitude,
    leading: theorem1::amplitude,
    next: next_order::amplitude,
    bound: next_order::AMPLITUDE_BOUND,
    power: 1,
    limit: next_order::amplitude_limit,
    steps: "notes/veerman_next_order.md, steps 1 to 11",
};

pub fn frequency() -> Record<NextOrderVariant> {
    with_controls(Record::new(
        "beyond.veerman.resonance_frequency",
        "With gamma = cos(x - iy): x = sqrt2 a (1 + a²/12 - 3a²b²/8 + O(4)) and y = (a² b/sqrt2)(1 + a²/4 - 5a²b²/8 + O(4)). The resonance has \
         Mx = pi/2 - delta, 2 delta = (pi/2)(a/a0) a² b² (1 + O(2)). Together a/a0 = 1/(1 + a²/12 + a²b²/8 + r), |r| <= 1.2 (a max(1, b))^4. All remainders are \
         bounded in notes/veerman_next_order.md.",
        PRINTED,
        |variant, run| Run::all([examine(&FREQUENCY, variant, run), examine_limit(&FREQUENCY, variant, run)]),
    ))
    .stated(
        "sharpens veerman, Theorem 1",
        "For all f, g < 0 and M = N + 1 >= 5 max(1, b), b = |g|/sqrt|f|, the main resonance of the last of the M followers of system (2), \
         the frequency w > 0 at which its amplitude is largest, lies at w = w_0 (1 - q^2 (1/12 + b^2/8) + e), w_0 = sqrt|f| q, q = pi/(2 \
         sqrt(2) M), with |e| <= 1.7 (q max(1, b))^4.",
    )
}

pub fn amplitude() -> Record<NextOrderVariant> {
    with_controls(Record::new(
        "beyond.veerman.resonance_amplitude",
        "1/A² = sin² delta + sinh²(My) with delta and y of beyond.veerman.resonance_frequency: relative to 1/A_0² the terms of order a0² are b² from \
         delta, 1/2 - 5b²/4 from y, -1/3 - b²/2 from the shift of a, and pi² b²/48 from sinh. Their sum is 1/6 - 3b²/4 + pi² b²/48, and the \
         amplitude has minus half of it. All remainders are bounded in notes/veerman_next_order.md.",
        PRINTED,
        |variant, run| {
            let formula = examine(&AMPLITUDE, variant, run)?.on([1]);
            let limit = examine_limit(&AMPLITUDE, variant, run)?;
            let proof = argued(&[2], "the limit", "notes/veerman_next_order.md, step 12");
            Run::all([Ok(formula), Ok(limit.on([2])), proof])
        },
    ))
    .stated("sharpens veerman, Theorem 1", "")
    .clauses(&[
        "For all f, g < 0 and M = N + 1 >= 5 max(1, b), b = |g|/sqrt|f|, the peak of system (2), the largest amplitude of the last of the M \
         followers over all frequencies w > 0 of a leader of amplitude 1, is A = A_0 (1 - q^2 (1/12 - 3 b^2/8 + pi^2 b^2/96) + e), A_0 = 8 \
         sqrt(2) M/(pi^2 b), q = pi/(2 sqrt(2) M), with |e| <= 11 (q max(1, b))^4.",
        "M (A - A_0) -> sqrt(2) (b (36 - pi^2)/96 - 1/(12 b)) as M tends to infinity, for fixed f, g < 0.",
    ])
}
