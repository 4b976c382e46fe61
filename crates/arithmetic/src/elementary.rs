//! Enclosures of the elementary functions at one dyadic point, by series with explicit remainders.
//!
//! Each function returns `(lo, hi)` around the exact value. All series are summed in fixed point with a running count
//! of the units lost ([`Fixed`]); what a series leaves out is added to that count where it is cut.

use super::dyadic::Round;
use super::fixed::Fixed;
use super::{ArithmeticError, Dyadic};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, ToPrimitive};
use std::sync::Mutex;

/// Bits carried beyond the asked precision.
const GUARD: u32 = 32;

/// Arguments of `exp` and `sinh` beyond `2^32` are refused.
const LARGEST_EXPONENT_TOP: i64 = 32;

/// Angles beyond `2^60` are not reduced: their sine is only known to lie in [-1, 1].
pub(super) const LARGEST_ANGLE_TOP: i64 = 60;

/// Squarings in `exp` at most: each multiplies the counted error by up to 5.
pub(super) const MOST_SQUARINGS: u32 = 24;

type Bounds = (Dyadic, Dyadic);

fn one() -> Dyadic {
    Dyadic::new(BigInt::one(), 0)
}

/// Whether `|x|³` is below `2^-(precision + 4) |x|`.
fn is_tiny(x: &Dyadic, precision: u32) -> bool {
    x.is_zero() || 2 * x.top() < -i64::from(precision) - 4
}

/// Encloses `x ± |x|³` for a tiny `x`: sin, atan and sinh stay within that for `|x| < 1`.
fn near(x: &Dyadic, precision: u32) -> Bounds {
    if x.is_zero() {
        return (Dyadic::zero(), Dyadic::zero());
    }
    let slack = Dyadic::new(BigInt::one(), x.top() - i64::from(precision) - 4);
    (x.plus(&slack.negated()), x.plus(&slack))
}

/// A working scale that keeps `precision` significant bits of a result of the size of `x`.
fn scale_for_small(x: &Dyadic, precision: u32) -> u32 {
    precision + GUARD + (-x.top()).clamp(0, i64::from(u32::MAX / 4)) as u32
}

/// A constant that is computed once at the largest scale asked for.
struct Constant(Mutex<Option<Fixed>>);

impl Constant {
    fn at(&self, scale: u32, compute: impl Fn(u32) -> Fixed) -> Fixed {
        let mut cached = self.0.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        let known = match cached.take() {
            Some(known) if known.scale >= scale => known,
            _ => compute(scale + GUARD),
        };
        let result = known.rescaled(scale);
        *cached = Some(known);
        result
    }
}

/// `sum x^(2k+1) / (2k+1)`, with alternating signs or not, for `x = 1/n` exactly.
fn inverse_series(n: u64, alternating: bool, scale: u32) -> Fixed {
    let mut power = Fixed::integer(1, scale).over_small(n);
    let mut sum = power.clone();
    let mut k = 1;
    while !power.is_negligible() {
        power = power.over_small(n * n);
        let term = power.over_small(2 * k + 1);
        sum = if alternating && k % 2 == 1 { sum.minus(&term) } else { sum.plus(&term) };
        k += 1;
    }
    // What is left is below the last power times 1/(1 - 1/n²) < 2.
    sum.error += 2 * (power.error + 2);
    sum
}

/// Machin: pi = 16 atan(1/5) - 4 atan(1/239).
fn pi_fixed(scale: u32) -> Fixed {
    static PI: Constant = Constant(Mutex::new(None));
    PI.at(scale, |scale| {
        inverse_series(5, true, scale).times_small(16).minus(&inverse_series(239, true, scale).times_small(4))
    })
}

/// ln 2 = 18 atanh(1/26) - 2 atanh(1/4801) + 8 atanh(1/8749).
fn ln2_fixed(scale: u32) -> Fixed {
    static LN2: Constant = Constant(Mutex::new(None));
    LN2.at(scale, |scale| {
        let part = |n, factor| inverse_series(n, false, scale).times_small(factor);
        part(26, 18).minus(&part(4801, 2)).plus(&part(8749, 8))
    })
}

pub(super) fn pi(precision: u32) -> Bounds {
    pi_fixed(precision + GUARD).bounds(0)
}

/// `sum r^n/n!` from `first` in steps of `step`, signs alternating or not; |r| <= 1.
fn exponential_series(r: &Fixed, first: u64, step: u64, alternating: bool) -> Fixed {
    let mut term = Fixed::integer(1, r.scale);
    for n in 1..=first {
        term = term.times(r).over_small(n);
    }
    let factor = (0..step).fold(Fixed::integer(1, r.scale), |product, _| product.times(r));
    let mut sum = term.clone();
    let mut n = first;
    let mut negative = false;
    while !term.is_negligible() {
        term = term.times(&factor);
        for k in 1..=step {
            term = term.over_small(n + k);
        }
        n += step;
        negative = alternating && !negative;
        sum = if negative { sum.minus(&term) } else { sum.plus(&term) };
    }
    // The rest is at most the last term times 1/(1 - 1/2).
    sum.error += 2 * (term.error + 2);
    sum
}

/// e^x = 2^k e^r with r = x - k ln 2; the series runs at r / 2^m, then m squarings.
pub(super) fn exp(x: &Dyadic, precision: u32) -> Result<Bounds, ArithmeticError> {
    if x.is_zero() {
        return Ok((one(), one()));
    }
    if x.top() > LARGEST_EXPONENT_TOP {
        if x.is_negative() {
            return Ok((Dyadic::zero(), Dyadic::new(BigInt::one(), -(1 << LARGEST_EXPONENT_TOP))));
        }
        return Err(ArithmeticError::Argument("exp"));
    }
    let squarings = ((f64::from(precision).sqrt() / 2.0).ceil() as u32).min(MOST_SQUARINGS);
    let scale = precision + GUARD + 3 * squarings;
    let k = (x.to_f64() / std::f64::consts::LN_2).round() as i64;
    let wide = scale + 64;
    let ln2 = ln2_fixed(wide);
    let multiple = Fixed { value: &ln2.value * k, error: ln2.error * u128::from(k.unsigned_abs()), scale: wide };
    let r = Fixed::from_dyadic(x, wide).minus(&multiple).rescaled(scale);
    let mut result = exponential_series(&r.halved(squarings), 0, 1, false);
    for _ in 0..squarings {
        result = result.times(&result);
    }
    Ok(result.bounds(k))
}

/// sinh by its series up to 1, by exponentials beyond; relative precision near zero.
pub(super) fn sinh(x: &Dyadic, precision: u32) -> Result<Bounds, ArithmeticError> {
    if is_tiny(x, precision) {
        return Ok(near(x, precision));
    }
    if x.top() <= 0 {
        let r = Fixed::from_dyadic(x, scale_for_small(x, precision));
        return Ok(exponential_series(&r, 1, 2, false).bounds(0));
    }
    let (plus_lo, plus_hi) = exp(x, precision + GUARD)?;
    let (minus_lo, minus_hi) = exp(&x.negated(), precision + GUARD)?;
    let half_difference =
        |a: &Dyadic, b: &Dyadic, round| a.add_rounded(&b.negated(), precision + GUARD, round).scaled(-1);
    Ok((half_difference(&plus_lo, &minus_hi, Round::Down), half_difference(&plus_hi, &minus_lo, Round::Up)))
}

/// ln(m 2^e) = e ln 2 + 2 atanh((m-1)/(m+1)) with m in [3/4, 3/2).
pub(super) fn ln(x: &Dyadic, precision: u32) -> Result<Bounds, ArithmeticError> {
    if !x.is_positive() {
        return Err(ArithmeticError::Argument("ln"));
    }
    let mut e = x.top();
    let mut m = x.scaled(-e);
    if m < Dyadic::new(BigInt::from(3), -2) {
        m = m.scaled(1);
        e -= 1;
    }
    // Near 1 the result is small: keep its significant bits.
    let distance = m.plus(&one().negated());
    if distance.is_zero() && e == 0 {
        return Ok((Dyadic::zero(), Dyadic::zero()));
    }
    let scale = if e == 0 { scale_for_small(&distance, precision) } else { precision + GUARD + 64 };
    let unit = Fixed::integer(1, scale);
    let m = Fixed::from_dyadic(&m, scale);
    let z = m.minus(&unit).over(&m.plus(&unit));
    let square = z.times(&z);
    let mut power = z.clone();
    let mut sum = z;
    let mut k = 1;
    while !power.is_negligible() {
        power = power.times(&square);
        sum = sum.plus(&power.over_small(2 * k + 1));
        k += 1;
    }
    // |z| <= 1/5: the rest is below the last power times 1/(1 - 1/25) < 2.
    sum.error += 2 * (power.error + 2);
    let ln2 = ln2_fixed(scale);
    let shift = Fixed { value: &ln2.value * e, error: ln2.error * u128::from(e.unsigned_abs()), scale };
    Ok(sum.times_small(2).plus(&shift).bounds(0))
}

/// atan by halving the angle four times, then its series; 1/x beyond 1.
pub(super) fn atan(x: &Dyadic, precision: u32) -> Bounds {
    if is_tiny(x, precision) {
        return near(x, precision);
    }
    if x.is_negative() {
        let (lo, hi) = atan(&x.negated(), precision);
        return (hi.negated(), lo.negated());
    }
    let scale = scale_for_small(x, precision);
    let beyond_one = *x > one();
    let unit = Fixed::integer(1, scale);
    let mut t = if beyond_one {
        // 1/x cut to the scale: one unit.
        let reciprocal = one().div_rounded(x, scale, Round::Down);
        let mut t = Fixed::from_dyadic(&reciprocal, scale);
        t.error += 1;
        t
    } else {
        Fixed::from_dyadic(x, scale)
    };
    const HALVINGS: u32 = 4;
    for _ in 0..HALVINGS {
        let root = square_root(&unit.plus(&t.times(&t)));
        t = t.over(&unit.plus(&root));
    }
    let square = t.times(&t);
    let mut power = t.clone();
    let mut sum = t;
    let mut k = 1;
    while !power.is_negligible() {
        power = power.times(&square);
        let term = power.over_small(2 * k + 1);
        sum = if k % 2 == 1 { sum.minus(&term) } else { sum.plus(&term) };
        k += 1;
    }
    sum.error += 2 * (power.error + 2);
    let angle = sum.times_small(1 << HALVINGS);
    if beyond_one { pi_fixed(scale).halved(1).minus(&angle).bounds(0) } else { angle.bounds(0) }
}

/// Square root of a number that is at least 1.
fn square_root(x: &Fixed) -> Fixed {
    let value = BigInt::from((x.value.magnitude() << x.scale).sqrt());
    // d sqrt = dx / (2 sqrt) <= dx / 2.
    Fixed { value, error: x.error + 1, scale: x.scale }
}

/// Sine and cosine: x = n pi/2 + r with |r| <= pi/4 + a little, then the two series.
pub(super) fn sin_cos(x: &Dyadic, precision: u32) -> (Bounds, Bounds) {
    if is_tiny(x, precision) {
        return (near(x, precision), (one().plus(&Dyadic::new(BigInt::from(-1), -i64::from(precision) - 4)), one()));
    }
    if x.top() > LARGEST_ANGLE_TOP {
        let everything = (one().negated(), one());
        return (everything.clone(), everything);
    }
    let scale = scale_for_small(x, precision);
    let wide = scale + x.top().max(0) as u32 + 4;
    let half_pi = pi_fixed(wide).halved(1);
    let full = Fixed::from_dyadic(x, wide);
    // n = round(x / (pi/2)); below 2^60 in size.
    let n = ((&full.value << 1u32) + &half_pi.value).div_floor(&(&half_pi.value << 1u32));
    let turns = n.magnitude().to_u128().unwrap_or(0);
    let multiple = Fixed { value: &half_pi.value * &n, error: half_pi.error * turns, scale: wide };
    let r = full.minus(&multiple).rescaled(scale);
    let sin = exponential_series(&r, 1, 2, true);
    let cos = exponential_series(&r, 0, 2, true);
    let (sin, cos) = match (n & BigInt::from(3)).to_u8() {
        Some(1) => (cos, sin.negated()),
        Some(2) => (sin.negated(), cos.negated()),
        Some(3) => (cos.negated(), sin),
        _ => (sin, cos),
    };
    (sin.bounds(0), cos.bounds(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The width of an enclosure at `numerator/2^16` for 20 bits, as `(m, e)` for `m 2^e`.
    fn width(function: &dyn Fn(&Dyadic, u32) -> Bounds, numerator: i64) -> (i64, i64) {
        let (lo, hi) = function(&Dyadic::new(BigInt::from(numerator), -16), 20);
        let width = hi.plus(&lo.negated());
        (width.mantissa().to_i64().unwrap_or(0), width.exponent())
    }

    // A count that is too small by a few units shows in no result, since 32 bits are spare; so whoever changes one has to say so here.
    #[test]
    fn counted_errors_do_not_change_unnoticed() {
        let numerators = [7, 40_000, 65_537, 300_000, 5_000_000];
        let of = |function: &dyn Fn(&Dyadic, u32) -> Bounds| numerators.map(|numerator| width(function, numerator));
        let exp = |x: &Dyadic, bits: u32| exp(x, bits).unwrap();
        assert_eq!(of(&exp), [(5416, -61), (840, -60), (6696, -60), (872, -54), (6184, 49)]);
        let sinh = |x: &Dyadic, bits: u32| sinh(x, bits).unwrap();
        assert_eq!(of(&sinh), [(2, -37), (62, -52), (1, -51), (1, -46), (1, 58)]);
        let ln = |x: &Dyadic, bits: u32| ln(x, bits).unwrap();
        assert_eq!(of(&ln), [(256, -116), (224, -116), (100, -67), (212, -116), (236, -116)]);
        assert_eq!(of(&atan), [(2, -37), (2337920, -52), (4313286, -52), (1959526, -52), (1361958, -52)]);
        let sin = |x: &Dyadic, bits: u32| sin_cos(x, bits).0;
        assert_eq!(of(&sin), [(2, -37), (74, -52), (80, -52), (60, -52), (80, -52)]);
        let cos = |x: &Dyadic, bits: u32| sin_cos(x, bits).1;
        assert_eq!(of(&cos), [(1, -24), (80, -52), (70, -52), (56, -52), (74, -52)]);
        assert_eq!(of(&|_, bits| pi(bits)), [(4, -52); 5]);
        assert_eq!([(5, true), (26, false)].map(|(n, alternating)| inverse_series(n, alternating, 40).error), [26, 18]);
    }

    #[test]
    fn exact_values_refusals_and_angles_that_are_not_reduced() {
        let zero = Dyadic::zero();
        assert_eq!(exp(&zero, 20).unwrap(), (one(), one()));
        let nothing = (zero.clone(), zero.clone());
        assert_eq!(
            [sin_cos(&zero, 20).0, atan(&zero, 20), sinh(&zero, 20).unwrap()],
            [(); 3].map(|()| nothing.clone())
        );
        assert_eq!(ln(&one(), 20).unwrap(), nothing);
        assert!(ln(&one().scaled(2), 20).unwrap().0 > one());
        let vanishing = one().scaled(LARGEST_EXPONENT_TOP + 1).negated();
        assert_eq!(exp(&vanishing, 20).unwrap(), (zero.clone(), one().scaled(-(1 << 32))));
        for refused in [zero, one().negated()] {
            assert!(matches!(ln(&refused, 20), Err(ArithmeticError::Argument("ln"))));
        }
        let angle = one().scaled(60);
        let everything = (one().negated(), one());
        assert_eq!(sin_cos(&angle, 20), (everything.clone(), everything.clone()));
        let sin = sin_cos(&angle.scaled(-1), 20).0;
        assert!(everything.0 < sin.0 && sin.1 < everything.1);
    }
}
