//! Balls of fixed size: a fixed-point midpoint on the stack with an error radius. No allocation, for long chains of
//! products that need a few hundred bits; [`Interval`] is the general type. `a b + a` with five limbs takes a twentieth of what it takes with
//! intervals of 256 bits on num-bigint.

use super::operators::operators;
use super::{Dyadic, Interval, Ring};
use num_bigint::{BigInt, BigUint, Sign};

/// Encloses the numbers within `radius` units of the midpoint, where a unit is `2^(-64 (LIMBS - 1))`; from 2 to 16 limbs.
///
/// The midpoint is a two's complement number of `LIMBS` limbs, the highest one before the point. A result beyond `2^62`
/// gets a radius that is not finite, which no later operation loses.
#[derive(Debug, Clone)]
pub struct Ball<const LIMBS: usize> {
    limbs: [u64; LIMBS],
    radius: f64,
}

/// Makes up for the rounding of a few operations on non-negative floats.
const ROUND_UP: f64 = 1.0 + 1e-14;

impl<const LIMBS: usize> Ball<LIMBS> {
    /// With more limbs a unit would leave the range of floats, with one there would be nothing after the point.
    const VALID: () = assert!(LIMBS >= 2 && LIMBS <= 16, "a ball has from 2 to 16 limbs");

    /// Bits after the point.
    pub const SCALE: u32 = 64 * (LIMBS as u32 - 1);

    /// A ball around the interval.
    pub fn from_interval(x: &Interval) -> Self {
        let () = Self::VALID;
        let middle = x.lo().midpoint(x.hi()).scaled(i64::from(Self::SCALE));
        let integer = middle.floor();
        let radius = (x.width().scaled(i64::from(Self::SCALE) - 1).to_f64() + 1.0) * ROUND_UP;
        let mut limbs = [0; LIMBS];
        if integer.bits() > u64::from(Self::SCALE) + 62 {
            return Ball { limbs, radius: f64::INFINITY };
        }
        for (limb, digit) in limbs.iter_mut().zip(integer.magnitude().iter_u64_digits()) {
            *limb = digit;
        }
        if integer.sign() == Sign::Minus {
            negate(&mut limbs);
        }
        Ball { limbs, radius }
    }

    /// The interval of the ball at the given precision, or `None` where a result overflowed.
    pub fn to_interval(&self, precision: u32) -> Option<Interval> {
        let radius = Dyadic::from_f64(self.radius * ROUND_UP)?.scaled(-i64::from(Self::SCALE));
        let (negative, magnitude) = self.magnitude();
        let digits = magnitude.iter().flat_map(|&limb| [limb as u32, (limb >> 32) as u32]).collect();
        let sign = if negative { Sign::Minus } else { Sign::Plus };
        let middle = Dyadic::new(BigInt::from_biguint(sign, BigUint::new(digits)), -i64::from(Self::SCALE));
        Some(Interval::between(middle.plus(&radius.negated()), middle.plus(&radius), precision))
    }

    fn is_negative(&self) -> bool {
        self.limbs[LIMBS - 1] >> 63 == 1
    }

    fn magnitude(&self) -> (bool, [u64; LIMBS]) {
        let mut limbs = self.limbs;
        let negative = self.is_negative();
        if negative {
            negate(&mut limbs);
        }
        (negative, limbs)
    }

    /// Midpoints beyond `2^62` are given up.
    fn checked(limbs: [u64; LIMBS], radius: f64) -> Self {
        let top = limbs[LIMBS - 1] >> 62;
        let fits = top == 0 || top == 3;
        Ball { limbs, radius: if fits { radius } else { f64::INFINITY } }
    }

    fn sum(a: &Self, b: &Self) -> Self {
        let mut limbs = [0; LIMBS];
        let mut carry = false;
        for ((slot, &x), &y) in limbs.iter_mut().zip(&a.limbs).zip(&b.limbs) {
            let (s, first) = x.overflowing_add(y);
            let (s, second) = s.overflowing_add(u64::from(carry));
            (*slot, carry) = (s, first | second);
        }
        Ball::checked(limbs, (a.radius + b.radius) * ROUND_UP)
    }

    fn difference(a: &Self, b: &Self) -> Self {
        Ball::sum(a, &Ball::negation(b))
    }

    fn negation(a: &Self) -> Self {
        let mut limbs = a.limbs;
        negate(&mut limbs);
        Ball { limbs, radius: a.radius }
    }

    /// `|ab - AB| <= |A| r_b + |B| r_a + r_a r_b`, and one unit for what is cut off.
    fn product(a: &Self, b: &Self) -> Self {
        let ((a_negative, x), (b_negative, y)) = (a.magnitude(), b.magnitude());
        let unit = 2f64.powi(-(Self::SCALE as i32));
        // Upper bounds of |A| and |B| from their highest limbs.
        let size = |limbs: &[u64; LIMBS]| {
            (limbs[LIMBS - 1] as f64 + (limbs[LIMBS - 2] as f64 + 1.0) * 2f64.powi(-64)) * ROUND_UP
        };
        let radius = ((size(&x) + a.radius * unit) * b.radius + size(&y) * a.radius + 1.0) * ROUND_UP;
        let mut low = [0u64; LIMBS];
        let mut high = [0u64; LIMBS];
        for (i, &digit) in x.iter().enumerate() {
            let mut carry = 0u64;
            for (j, &other) in y.iter().enumerate() {
                let k = i + j;
                let slot = if k < LIMBS { &mut low[k] } else { &mut high[k - LIMBS] };
                let t = u128::from(digit) * u128::from(other) + u128::from(*slot) + u128::from(carry);
                *slot = t as u64;
                carry = (t >> 64) as u64;
            }
            high[i] = carry;
        }
        // Drop LIMBS - 1 limbs; what is above LIMBS limbs must be zero.
        let mut limbs = [0; LIMBS];
        limbs[0] = low[LIMBS - 1];
        limbs[1..].copy_from_slice(&high[..LIMBS - 1]);
        let overflow = high[LIMBS - 1] != 0 || limbs[LIMBS - 1] >> 62 != 0;
        if a_negative != b_negative {
            negate(&mut limbs);
        }
        Ball { limbs, radius: if overflow { f64::INFINITY } else { radius } }
    }
}

/// Two's complement.
fn negate<const LIMBS: usize>(limbs: &mut [u64; LIMBS]) {
    let mut carry = true;
    for limb in limbs {
        (*limb, carry) = (!*limb).overflowing_add(u64::from(carry));
    }
}

operators!([const LIMBS: usize] Ball<LIMBS>, Ball::sum, Ball::difference, Ball::product, Ball::negation);

impl<const LIMBS: usize> Ring for Ball<LIMBS> {
    fn integer(&self, n: i64) -> Self {
        let mut limbs = [0; LIMBS];
        limbs[LIMBS - 1] = n as u64;
        Ball::checked(limbs, 0.0)
    }
}
