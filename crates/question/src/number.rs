//! Numbers: exact where that is possible, otherwise enclosed, with what is needed to prove that an algebraic number is zero.
//!
//! A number that is computed from rationals, cosines of rational parts of a turn and eigenvalues of rational matrices by
//! `+ - * / sqrt` is algebraic: it is `a/b` with algebraic integers `a`, `b` whose conjugates are at most `2^u` and `2^l` in size, in a field of
//! degree at most `D`. The norm of `a` is an integer, so `a = 0` or `|a| >= 2^(-(D-1) u)`, and the number is zero if it is smaller than
//! `2^(-(D-1) u - l)` (Burnikel, Funke, Mehlhorn, Schirra and Schmitt 2001). So equality is decided, too.

use arithmetic::{ArithmeticError, Dyadic, Field, Interval, Number as _, Rational, Real, Ring, Sign, Signed, rational};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed as _, ToPrimitive, Zero};

/// Bounds of an algebraic number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Algebraic {
    /// Of the degree of a field that contains it.
    pub degree: u64,
    /// `log2` of the conjugates of the numerator.
    pub upper: u64,
    /// `log2` of the conjugates of the denominator.
    pub lower: u64,
}

/// The value of an expression.
#[derive(Debug, Clone)]
pub enum Number {
    /// A rational number.
    Exact(Rational),
    /// A rational multiple of pi other than 0.
    Turns(Rational),
    /// A real number in an interval; with a separation bound if it is known to be algebraic.
    #[allow(private_interfaces)]
    Enclosed(Interval, Option<Algebraic>),
    /// A real number of this sign, in an interval that may begin at 0.
    Beyond(Sign, Interval),
}

/// Why an operation has no result.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Obstacle {
    /// It certainly has none.
    Never(&'static str),
    /// The enclosure is too wide to tell; so many bits may be needed.
    Perhaps(&'static str),
    /// The numbers grow beyond all use.
    TooLarge,
}

/// Exponentials of numbers of more bits before the point are not computed.
const LARGEST_EXPONENT: i64 = 24;

/// Exponentials of smaller numbers than minus two to this are only known to lie between 0 and that one.
const LOWEST_EXPONENT: i64 = 13;

/// Most bits of an exact power.
const MOST_BITS: u64 = 1 << 22;

impl Algebraic {
    fn of_rational(q: &Rational) -> Self {
        Algebraic { degree: 1, upper: q.numer().bits(), lower: q.denom().bits() - u64::from(q.is_integer()) }
    }

    fn sum(a: Self, b: Self) -> Self {
        let upper = a.upper.saturating_add(b.lower).max(a.lower.saturating_add(b.upper)).saturating_add(1);
        Algebraic { degree: a.degree.saturating_mul(b.degree), upper, lower: a.lower.saturating_add(b.lower) }
    }

    fn product(a: Self, b: Self) -> Self {
        Algebraic {
            degree: a.degree.saturating_mul(b.degree),
            upper: a.upper.saturating_add(b.upper),
            lower: a.lower.saturating_add(b.lower),
        }
    }

    fn reciprocal(self) -> Self {
        Algebraic { upper: self.lower, lower: self.upper, ..self }
    }

    /// `(a/b)^(1/q) = (a b^(q-1))^(1/q)/b`, of a field of `q` times the degree.
    fn root(self, degree: u32) -> Self {
        let degree = u64::from(degree);
        let upper = self.upper.saturating_add(self.lower.saturating_mul(degree - 1)).div_ceil(degree);
        Algebraic { degree: self.degree.saturating_mul(degree), upper, lower: self.lower }
    }

    /// Either of two numbers.
    fn either(a: Self, b: Self) -> Self {
        Algebraic { degree: a.degree.max(b.degree), upper: a.upper.max(b.upper), lower: a.lower.max(b.lower) }
    }

    /// The number is zero if it is below 2 to minus this.
    fn separation(self) -> u64 {
        (self.degree - 1).saturating_mul(self.upper).saturating_add(self.lower)
    }
}

fn opposite(sign: Sign) -> Sign {
    match sign {
        Sign::Positive => Sign::Negative,
        Sign::Negative => Sign::Positive,
        Sign::Zero => Sign::Zero,
    }
}

impl Number {
    pub(crate) fn integer(n: i64) -> Self {
        Number::Exact(rational(n, 1))
    }

    pub(crate) fn interval(interval: Interval) -> Self {
        Number::Enclosed(interval, None)
    }

    /// An enclosure at so many bits.
    pub fn enclosure(&self, precision: u32) -> Interval {
        match self {
            Number::Exact(q) => Interval::from_rational(q, precision),
            Number::Turns(q) => {
                let q = Interval::from_rational(q, precision + 8);
                (q.pi() * &q).with_precision(precision)
            }
            Number::Enclosed(interval, _) | Number::Beyond(_, interval) => interval.clone(),
        }
    }

    fn algebraic(&self) -> Option<Algebraic> {
        match self {
            Number::Exact(q) => Some(Algebraic::of_rational(q)),
            Number::Turns(_) | Number::Beyond(..) => None,
            Number::Enclosed(_, algebraic) => *algebraic,
        }
    }

    /// Whether it is enclosed and an integer lies in the enclosure.
    pub(crate) fn may_be_integer(&self, precision: u32) -> bool {
        let (lo, hi) = match self {
            Number::Exact(_) => return false,
            _ => self.enclosure(precision).to_rationals(),
        };
        lo.ceil() <= hi.floor()
    }

    /// The integer that it is, if it is one.
    pub fn as_integer(&self) -> Option<BigInt> {
        match self {
            Number::Exact(q) if q.is_integer() => Some(q.to_integer()),
            _ => None,
        }
    }

    fn with(
        &self,
        other: &Self,
        precision: u32,
        exact: impl Fn(&Rational, &Rational) -> Rational,
        enclosed: impl Fn(Interval, Interval) -> Interval,
        bounds: impl Fn(Algebraic, Algebraic) -> Algebraic,
    ) -> Self {
        if let (Number::Exact(a), Number::Exact(b)) = (self, other) {
            return Number::Exact(exact(a, b));
        }
        let algebraic = self.algebraic().zip(other.algebraic()).map(|(a, b)| bounds(a, b));
        Number::Enclosed(enclosed(self.enclosure(precision), other.enclosure(precision)), algebraic)
    }

    pub(crate) fn plus(&self, other: &Self, precision: u32) -> Self {
        match (self, other) {
            (Number::Turns(a), Number::Turns(b)) => Number::turns(a + b),
            (Number::Exact(zero), x) | (x, Number::Exact(zero)) if zero.is_zero() => x.clone(),
            _ => self.with(other, precision, |a, b| a + b, |a, b| a + b, Algebraic::sum),
        }
    }

    fn turns(q: Rational) -> Self {
        if q.is_zero() { Number::Exact(q) } else { Number::Turns(q) }
    }

    pub(crate) fn negated(&self) -> Self {
        match self {
            Number::Exact(q) => Number::Exact(-q),
            Number::Turns(q) => Number::Turns(-q),
            Number::Enclosed(x, algebraic) => Number::Enclosed(-x.clone(), *algebraic),
            Number::Beyond(sign, x) => Number::Beyond(opposite(*sign), -x.clone()),
        }
    }

    pub(crate) fn minus(&self, other: &Self, precision: u32) -> Self {
        self.plus(&other.negated(), precision)
    }

    pub(crate) fn times(&self, other: &Self, precision: u32) -> Self {
        match (self, other) {
            (Number::Exact(q), Number::Turns(p)) | (Number::Turns(p), Number::Exact(q)) => Number::turns(p * q),
            (Number::Exact(zero), _) | (_, Number::Exact(zero)) if zero.is_zero() => Number::integer(0),
            (Number::Beyond(..), x) | (x, Number::Beyond(..)) if x.sign().is_some_and(|sign| sign != Sign::Zero) => {
                let sign = if self.sign() == other.sign() { Sign::Positive } else { Sign::Negative };
                Number::Beyond(sign, self.enclosure(precision) * other.enclosure(precision))
            }
            _ => self.with(other, precision, |a, b| a * b, |a, b| a * b, Algebraic::product),
        }
    }

    /// The sign, where the enclosure or the separation bound decides it.
    pub(crate) fn sign(&self) -> Option<Sign> {
        match self {
            Number::Exact(q) | Number::Turns(q) => q.sign(),
            Number::Beyond(sign, _) => Some(*sign),
            Number::Enclosed(x, algebraic) => x.sign().or_else(|| {
                // A number smaller than the separation bound is zero.
                let bound = i64::try_from(algebraic.as_ref()?.separation()).ok()?;
                (x.magnitude().top() <= -bound).then_some(Sign::Zero)
            }),
        }
    }

    /// Bits of precision at which the sign will be known, if there is a bound.
    pub(crate) fn needed_bits(&self) -> Option<u64> {
        match self {
            Number::Enclosed(_, Some(bounds)) => Some(bounds.separation().saturating_add(bounds.upper + 64)),
            _ => None,
        }
    }

    pub(crate) fn over(&self, divisor: &Self, precision: u32) -> Result<Self, Obstacle> {
        match (self, divisor) {
            (Number::Turns(a), Number::Turns(b)) => return Ok(Number::Exact(a / b)),
            (Number::Turns(a), Number::Exact(b)) if !b.is_zero() => return Ok(Number::Turns(a / b)),
            (Number::Exact(a), Number::Exact(b)) if !b.is_zero() => return Ok(Number::Exact(a / b)),
            _ => {}
        }
        match divisor.sign() {
            Some(Sign::Zero) => return Err(Obstacle::Never("/")),
            None => return Err(Obstacle::Perhaps("/")),
            Some(_) => {}
        }
        let inverse = divisor.enclosure(precision).recip().map_err(|_| Obstacle::Perhaps("/"))?;
        Ok(self.times(&Number::Enclosed(inverse, divisor.algebraic().map(Algebraic::reciprocal)), precision))
    }

    /// `self^exponent`: of any number for an integer exponent, otherwise of one that is not negative.
    pub(crate) fn power(&self, exponent: &Self, precision: u32) -> Result<Self, Obstacle> {
        if let Some(k) = exponent.as_integer() {
            let k = k.to_i64().filter(|k| k.unsigned_abs() <= 1 << 20).ok_or(Obstacle::TooLarge)?;
            let positive = self.to_the(k.unsigned_abs(), precision)?;
            return if k < 0 { Number::integer(1).over(&positive, precision) } else { Ok(positive) };
        }
        match (self.sign(), exponent.sign()) {
            (Some(Sign::Negative), _) if !exponent.may_be_integer(precision) => return Err(Obstacle::Never("^")),
            (Some(Sign::Zero), Some(Sign::Positive)) => return Ok(Number::integer(0)),
            (Some(Sign::Zero), Some(Sign::Negative)) => return Err(Obstacle::Never("/")),
            (Some(Sign::Positive), _) => {}
            _ => {}
        }
        if let Number::Exact(q) = exponent
            && let Some(root) = q.denom().to_u32()
        {
            let base = self.root(root, precision)?;
            return base.power(&Number::Exact(Rational::from_integer(q.numer())), precision);
        }
        if self.sign() != Some(Sign::Positive) {
            return Err(Obstacle::Perhaps("^"));
        }
        let logarithm = self.log(precision)?;
        exponent.times(&logarithm, precision).exp(precision)
    }

    /// The root of that degree, at least 2, of a number that is not negative: exact where it is rational.
    fn root(&self, degree: u32, precision: u32) -> Result<Self, Obstacle> {
        let outside = |obstacle| match obstacle {
            Obstacle::Never(_) => Obstacle::Never("^"),
            Obstacle::Perhaps(_) => Obstacle::Perhaps("^"),
            Obstacle::TooLarge => Obstacle::TooLarge,
        };
        if degree == 2 {
            return self.sqrt(precision).map_err(outside);
        }
        if let Number::Exact(q) = self
            && !q.is_negative()
        {
            let (p, r) = (q.numer().nth_root(degree), q.denom().nth_root(degree));
            if p.pow(degree) == q.numer() && r.pow(degree) == q.denom() {
                return Ok(Number::Exact(Rational::new(p, r)));
            }
        }
        let share = Number::Exact(Rational::new(BigInt::from(1), BigInt::from(degree)));
        let root = share.times(&self.log(precision + 8).map_err(outside)?, precision + 8).exp(precision + 8)?;
        let algebraic = self.algebraic().map(|own| own.root(degree));
        Ok(Number::Enclosed(root.enclosure(precision), algebraic))
    }

    fn to_the(&self, k: u64, precision: u32) -> Result<Self, Obstacle> {
        match self {
            Number::Exact(q) => {
                let bits = q.numer().bits().max(q.denom().bits());
                let unit = q.numer().magnitude() <= &1u8.into() && q.is_integer();
                if !unit && bits.saturating_mul(k) > MOST_BITS {
                    return Err(Obstacle::TooLarge);
                }
                Ok(Number::Exact(q.power(k)))
            }
            _ => {
                let algebraic = self.algebraic().map(|a| Algebraic {
                    upper: a.upper.saturating_mul(k),
                    lower: a.lower.saturating_mul(k),
                    ..a
                });
                Ok(Number::Enclosed(self.enclosure(precision).power(k), algebraic))
            }
        }
    }

    pub(crate) fn sqrt(&self, precision: u32) -> Result<Self, Obstacle> {
        if let Number::Exact(q) = self {
            if q.is_negative() {
                return Err(Obstacle::Never("sqrt"));
            }
            let (p, r) = (q.numer().sqrt(), q.denom().sqrt());
            if &p * &p == q.numer() && &r * &r == q.denom() {
                return Ok(Number::Exact(Rational::new(p, r)));
            }
        }
        match self.sign() {
            Some(Sign::Zero) => return Ok(Number::integer(0)),
            Some(Sign::Negative) => return Err(Obstacle::Never("sqrt")),
            Some(Sign::Positive) => {}
            None if self.enclosure(precision).lo().is_negative() => return Err(Obstacle::Perhaps("sqrt")),
            None => {}
        }
        let root = self.enclosure(precision).sqrt().map_err(|_| Obstacle::Perhaps("sqrt"))?;
        Ok(Number::Enclosed(root, self.algebraic().map(|own| own.root(2))))
    }

    pub(crate) fn absolute(&self, precision: u32) -> Self {
        match self {
            Number::Exact(q) => Number::Exact(q.abs()),
            Number::Turns(q) => Number::Turns(q.abs()),
            Number::Beyond(Sign::Negative, _) => self.negated(),
            Number::Beyond(..) => self.clone(),
            Number::Enclosed(x, algebraic) => {
                let zero = Dyadic::zero();
                let size = match x.sign() {
                    Some(Sign::Negative) => -x.clone(),
                    Some(_) => x.clone(),
                    None => Interval::between(zero, x.magnitude(), precision),
                };
                Number::Enclosed(size, *algebraic)
            }
        }
    }

    /// The larger of two, or the smaller.
    pub(crate) fn extreme(&self, other: &Self, larger: bool, precision: u32) -> Self {
        match self.minus(other, precision).sign() {
            Some(Sign::Negative) => return if larger { other.clone() } else { self.clone() },
            Some(_) => return if larger { self.clone() } else { other.clone() },
            None => {}
        }
        let (a, b) = (self.enclosure(precision), other.enclosure(precision));
        let end = |x: &Dyadic, y: &Dyadic| if (x >= y) == larger { x.clone() } else { y.clone() };
        let hull = Interval::between(end(a.lo(), b.lo()), end(a.hi(), b.hi()), precision);
        Number::Enclosed(hull, self.algebraic().zip(other.algebraic()).map(|(a, b)| Algebraic::either(a, b)))
    }

    /// Cosine; exact or algebraic at rational multiples of pi.
    pub(crate) fn cos(&self, precision: u32) -> Result<Self, Obstacle> {
        match self {
            Number::Exact(q) if q.is_zero() => Ok(Number::integer(1)),
            Number::Turns(q) => Ok(cosine_of_turns(q, precision)),
            _ => {
                let x = self.enclosure(precision).cos().map_err(|_| Obstacle::Perhaps("cos"))?;
                Ok(Number::Enclosed(x, None))
            }
        }
    }

    /// Sine, as the cosine of the complement where that is exact.
    pub(crate) fn sin(&self, precision: u32) -> Result<Self, Obstacle> {
        match self {
            Number::Exact(q) if q.is_zero() => Ok(Number::integer(0)),
            Number::Turns(q) => Number::turns(rational(1, 2) - q).cos(precision),
            _ => {
                let x = self.enclosure(precision).sin().map_err(|_| Obstacle::Perhaps("sin"))?;
                Ok(Number::Enclosed(x, None))
            }
        }
    }

    pub(crate) fn exp(&self, precision: u32) -> Result<Self, Obstacle> {
        if matches!(self, Number::Exact(q) if q.is_zero()) {
            return Ok(Number::integer(1));
        }
        let x = self.enclosure(precision);
        if x.hi().is_positive() && x.hi().top() > LARGEST_EXPONENT {
            return Err(Obstacle::TooLarge);
        }
        let of = |x: &Interval| x.exp().map_err(|_: ArithmeticError| Obstacle::TooLarge);
        if x.lo().is_negative() && x.lo().top() > LARGEST_EXPONENT {
            // Above zero, and at most the exponential of the upper end: below this one nothing is told apart.
            let lowest = Dyadic::new(BigInt::from(-1), LOWEST_EXPONENT);
            let end = x.hi().clone().max(lowest);
            let most = of(&Interval::between(end.clone(), end, precision))?;
            return Ok(Number::Beyond(Sign::Positive, Interval::between(Dyadic::zero(), most.hi().clone(), precision)));
        }
        Ok(Number::Enclosed(of(&x)?, None))
    }

    pub(crate) fn log(&self, precision: u32) -> Result<Self, Obstacle> {
        match self.sign() {
            Some(Sign::Negative | Sign::Zero) => return Err(Obstacle::Never("log")),
            None => return Err(Obstacle::Perhaps("log")),
            Some(Sign::Positive) => {}
        }
        if let Number::Exact(q) = self
            && *q == rational(1, 1)
        {
            return Ok(Number::integer(0));
        }
        let x = self.enclosure(precision).ln().map_err(|_| Obstacle::Perhaps("log"))?;
        Ok(Number::Enclosed(x, None))
    }

    /// The text of a number in answers: exact, or its ends rounded outward.
    pub fn text(&self) -> String {
        match self {
            Number::Exact(q) => q.to_string(),
            Number::Turns(q) => format!("{q}*pi"),
            Number::Enclosed(x, _) | Number::Beyond(_, x) => {
                let digits = arithmetic::significant_digits(x).clamp(3, 20) + 2;
                let (lo, hi) = arithmetic::decimals(x, digits);
                format!("[{lo}, {hi}]")
            }
        }
    }
}

/// `cos(q pi)`. `2 cos(q pi)` is an algebraic integer with conjugates of at most 2, of degree `phi(m)/2` for the order `m` of the root of unity
/// `e^(i q pi)`.
fn cosine_of_turns(q: &Rational, precision: u32) -> Number {
    let two = BigInt::from(2);
    let turn = Rational::new(q.numer().mod_floor(&(&two * q.denom())), q.denom());
    // cos(q pi) = cos((2 - q) pi); the angle is then between 0 and pi.
    let angle = if turn > rational(1, 1) { rational(2, 1) - turn } else { turn };
    let exact = [(0, 1, 1, 1), (1, 3, 1, 2), (1, 2, 0, 1), (2, 3, -1, 2), (1, 1, -1, 1)];
    for (p, r, value, under) in exact {
        if angle == rational(p, r) {
            return Number::Exact(rational(value, under));
        }
    }
    // e^(i q pi) is a primitive root of unity of order 2 r/gcd(p, 2).
    let order = if angle.numer().is_even() { angle.denom() } else { angle.denom() * two };
    let degree = order.to_u64().map_or(u64::MAX, |order| totient(order) / 2);
    let x = Number::Turns(angle).enclosure(precision + 8).cos();
    match x {
        Ok(x) => {
            let bounds = Algebraic { degree: degree.max(1), upper: 1, lower: 1 };
            Number::Enclosed(x.with_precision(precision), Some(bounds))
        }
        Err(_) => {
            let one = Interval::from_rational(&rational(1, 1), precision);
            Number::Enclosed(one.hull(&-one.clone()), None)
        }
    }
}

/// Euler's totient; for orders with large factors an upper bound.
fn totient(order: u64) -> u64 {
    let (mut left, mut totient) = (order, order);
    for p in 2..1 << 16 {
        if p * p > left {
            break;
        }
        if left % p == 0 {
            totient -= totient / p;
            while left % p == 0 {
                left /= p;
            }
        }
    }
    if left > 1 && left < 1 << 32 { totient - totient / left } else { totient }
}
