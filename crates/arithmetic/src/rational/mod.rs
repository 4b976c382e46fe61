//! Exact rationals as a scalar.
//!
//! Most rationals of a proof are small, so numerators and denominators of up to 63 bits stand in the number itself and are computed with by the
//! processor; longer ones are [`BigInt`]s. Which of the two holds is decided by the value alone, so equal numbers are equal memory.
//! Against num-rational, to which they convert: `a b + a` of numbers with two digits in a nineteenth of the time, of numbers with eighty digits, by Lehmer's
//! algorithm, in a sixteenth.

mod functions;
mod gcd;
mod operators;
mod simplest;
mod traits;

pub use gcd::{common_denominator, content, gcd, lcm};
pub use simplest::simplest_between;
pub use traits::NoRational;

use super::{ArithmeticError, Field, Ring, Sign, Signed};
use num_bigint::BigInt;
use num_traits::ToPrimitive;

/// An exact rational number, always in lowest terms with a positive denominator.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational(Parts);

/// Numerator and denominator in lowest terms, the denominator positive.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Parts {
    /// Both are between `-i64::MAX` and `i64::MAX`.
    Small(i64, i64),
    /// One of them is not.
    Big(Box<(BigInt, BigInt)>),
}

/// The rational `p / q` for constants of the code, where `q` is seen not to be zero.
///
/// # Panics
/// Where `q` is zero: another value would be a wrong constant in a proof.
pub fn rational(p: i64, q: i64) -> Rational {
    assert!(q != 0, "a rational with the denominator 0");
    let common = gcd::gcd_u64(p.unsigned_abs(), q.unsigned_abs()) as i128;
    let sign = i128::from(q.signum());
    Rational::of_lowest(sign * i128::from(p) / common, sign * i128::from(q) / common)
}

impl Rational {
    /// Zero.
    pub const ZERO: Rational = Rational(Parts::Small(0, 1));
    /// One.
    pub const ONE: Rational = Rational(Parts::Small(1, 1));

    /// `numerator / denominator`.
    ///
    /// # Panics
    /// Where the denominator is zero, like a division.
    pub fn new(numerator: BigInt, denominator: BigInt) -> Self {
        assert!(denominator != BigInt::ZERO, "a rational with the denominator 0");
        if let (Some(p), Some(q)) = (numerator.to_i64(), denominator.to_i64()) {
            return rational(p, q);
        }
        let negative = denominator.sign() == num_bigint::Sign::Minus;
        let common = BigInt::from(gcd(numerator.magnitude(), denominator.magnitude()));
        let common = if negative { -common } else { common };
        if common == BigInt::from(1) {
            return Rational::of_lowest_terms(numerator, denominator);
        }
        Rational::of_lowest_terms(numerator / &common, denominator / &common)
    }

    /// The integer as a rational.
    pub fn from_integer(n: BigInt) -> Self {
        Rational::of_lowest_terms(n, BigInt::from(1))
    }

    /// `numerator / denominator` in lowest terms with a positive denominator.
    pub(crate) fn of_lowest_terms(numerator: BigInt, denominator: BigInt) -> Self {
        match (small(&numerator), small(&denominator)) {
            (Some(p), Some(q)) => Rational(Parts::Small(p, q)),
            _ => Rational(Parts::Big(Box::new((numerator, denominator)))),
        }
    }

    /// The same for numbers of two words.
    #[inline]
    fn of_lowest(numerator: i128, denominator: i128) -> Self {
        const MOST: u128 = i64::MAX as u128;
        if numerator.unsigned_abs() <= MOST && denominator.unsigned_abs() <= MOST {
            return Rational(Parts::Small(numerator as i64, denominator as i64));
        }
        Rational(Parts::Big(Box::new((BigInt::from(numerator), BigInt::from(denominator)))))
    }

    /// The numerator, which has the sign.
    pub fn numer(&self) -> BigInt {
        match &self.0 {
            Parts::Small(p, _) => BigInt::from(*p),
            Parts::Big(parts) => parts.0.clone(),
        }
    }

    /// The denominator, positive.
    pub fn denom(&self) -> BigInt {
        match &self.0 {
            Parts::Small(_, q) => BigInt::from(*q),
            Parts::Big(parts) => parts.1.clone(),
        }
    }

    /// Numerator and denominator, where both are words.
    #[inline]
    pub(crate) fn words(&self) -> Option<(i64, i64)> {
        match self.0 {
            Parts::Small(p, q) => Some((p, q)),
            Parts::Big(_) => None,
        }
    }

    /// Numerator and denominator.
    pub fn into_raw(self) -> (BigInt, BigInt) {
        match self.0 {
            Parts::Small(p, q) => (BigInt::from(p), BigInt::from(q)),
            Parts::Big(parts) => *parts,
        }
    }

    /// Whether the denominator is one.
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Parts::Small(_, q) => *q == 1,
            Parts::Big(parts) => parts.1 == BigInt::from(1),
        }
    }

    /// `1 / self`.
    ///
    /// # Panics
    /// For zero, like a division; [`Field::recip`] has an error instead.
    pub fn recip(&self) -> Self {
        assert!(Signed::sign(self) != Some(Sign::Zero), "division by zero");
        match &self.0 {
            Parts::Small(p, q) => Rational(Parts::Small(q * p.signum(), p.abs())),
            Parts::Big(parts) => match parts.0.sign() {
                num_bigint::Sign::Minus => Rational::of_lowest_terms(-&parts.1, -&parts.0),
                _ => Rational::of_lowest_terms(parts.1.clone(), parts.0.clone()),
            },
        }
    }
}

/// The integer as one word, if it is small.
fn small(n: &BigInt) -> Option<i64> {
    n.to_i64().filter(|n| *n != i64::MIN)
}

impl Ring for Rational {
    #[inline]
    fn integer(&self, n: i64) -> Self {
        rational(n, 1)
    }

    #[inline]
    fn zero(&self) -> Self {
        Rational::ZERO
    }

    #[inline]
    fn one(&self) -> Self {
        Rational::ONE
    }

    fn square(&self) -> Self {
        match &self.0 {
            Parts::Small(p, q) => Rational::of_lowest(i128::from(*p).pow(2), i128::from(*q).pow(2)),
            Parts::Big(parts) => Rational::of_lowest_terms(&parts.0 * &parts.0, &parts.1 * &parts.1),
        }
    }
}

impl Field for Rational {
    #[inline]
    fn rational(&self, q: &Rational) -> Self {
        q.clone()
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        match Signed::sign(self) {
            Some(Sign::Zero) => Err(ArithmeticError::DivisionByZero),
            _ => Ok(Rational::recip(self)),
        }
    }
}

impl Signed for Rational {
    #[inline]
    fn sign(&self) -> Option<Sign> {
        match &self.0 {
            Parts::Small(p, _) => Some(match p.signum() {
                -1 => Sign::Negative,
                0 => Sign::Zero,
                _ => Sign::Positive,
            }),
            Parts::Big(parts) => Signed::sign(&parts.0),
        }
    }
}
