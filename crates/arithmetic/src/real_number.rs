//! Numbers: exact where that is possible, otherwise enclosed, with what is needed to prove that an algebraic number is zero.
//!
//! A number that is computed from rationals, cosines of rational parts of a turn and eigenvalues of rational matrices by
//! `+ - * / sqrt` is algebraic: it is `a/b` with algebraic integers `a`, `b` whose conjugates are at most `2^u` and `2^l` in size, in a field of
//! degree at most `D`. The norm of `a` is an integer, so `a = 0` or `|a| >= 2^(-(D-1) u)`, and the number is zero if it is smaller than
//! `2^(-(D-1) u - l)` (Burnikel, Funke, Mehlhorn, Schirra and Schmitt 2001). So equality is decided, too.

use super::operators::operators;
use super::{
    ArithmeticError, Dyadic, Field, Interval, Number, Rational, Real, Ring, Sign, Signed, decimals, rational,
    significant_digits,
};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed as _, ToPrimitive, Zero};

/// Bounds of an algebraic number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Algebraic {
    /// Of the degree of a field that contains it.
    pub degree: u64,
    /// `log2` of the conjugates of the numerator.
    pub upper: u64,
    /// `log2` of the conjugates of the denominator.
    pub lower: u64,
}

/// The value of an expression.
#[derive(Debug, Clone)]
pub enum RealNumber {
    /// A rational number.
    Exact(Rational),
    /// A rational multiple of pi other than 0.
    Turns(Rational),
    /// A real number in an interval; with a separation bound if it is known to be algebraic.
    Enclosed(Interval, Option<Algebraic>),
    /// A real number of this sign, in an interval that may begin at 0.
    Beyond(Sign, Interval),
}

/// Why an operation has no result.
#[derive(Debug, Clone, PartialEq)]
pub enum Obstacle {
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

impl RealNumber {
    /// An integer.
    pub fn integer(n: i64) -> Self {
        RealNumber::Exact(rational(n, 1))
    }

    /// Of which no more is known than that it lies in an interval.
    pub fn interval(interval: Interval) -> Self {
        RealNumber::Enclosed(interval, None)
    }

    /// An enclosure at so many bits.
    pub fn enclosure(&self, precision: u32) -> Interval {
        match self {
            RealNumber::Exact(q) => Interval::from_rational(q, precision),
            RealNumber::Turns(q) => {
                let q = Interval::from_rational(q, precision + 8);
                (q.pi() * &q).with_precision(precision)
            }
            RealNumber::Enclosed(interval, _) | RealNumber::Beyond(_, interval) => interval.clone(),
        }
    }

    fn algebraic(&self) -> Option<Algebraic> {
        match self {
            RealNumber::Exact(q) => Some(Algebraic::of_rational(q)),
            RealNumber::Turns(_) | RealNumber::Beyond(..) => None,
            RealNumber::Enclosed(_, algebraic) => *algebraic,
        }
    }

    /// Whether it is enclosed and an integer lies in the enclosure.
    pub fn may_be_integer(&self, precision: u32) -> bool {
        let (lo, hi) = match self {
            RealNumber::Exact(_) => return false,
            _ => self.enclosure(precision).to_rationals(),
        };
        lo.ceil() <= hi.floor()
    }

    /// The integer that it is, if it is one.
    pub fn as_integer(&self) -> Option<BigInt> {
        match self {
            RealNumber::Exact(q) if q.is_integer() => Some(q.to_integer()),
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
        if let (RealNumber::Exact(a), RealNumber::Exact(b)) = (self, other) {
            return RealNumber::Exact(exact(a, b));
        }
        let algebraic = self.algebraic().zip(other.algebraic()).map(|(a, b)| bounds(a, b));
        RealNumber::Enclosed(enclosed(self.enclosure(precision), other.enclosure(precision)), algebraic)
    }

    /// The sum; enclosures have so many bits.
    pub fn plus(&self, other: &Self, precision: u32) -> Self {
        match (self, other) {
            (RealNumber::Turns(a), RealNumber::Turns(b)) => RealNumber::turns(a + b),
            (RealNumber::Exact(zero), x) | (x, RealNumber::Exact(zero)) if zero.is_zero() => x.clone(),
            _ => self.with(other, precision, |a, b| a + b, |a, b| a + b, Algebraic::sum),
        }
    }

    fn turns(q: Rational) -> Self {
        if q.is_zero() { RealNumber::Exact(q) } else { RealNumber::Turns(q) }
    }

    /// The negated number.
    pub fn negated(&self) -> Self {
        match self {
            RealNumber::Exact(q) => RealNumber::Exact(-q),
            RealNumber::Turns(q) => RealNumber::Turns(-q),
            RealNumber::Enclosed(x, algebraic) => RealNumber::Enclosed(-x.clone(), *algebraic),
            RealNumber::Beyond(sign, x) => RealNumber::Beyond(opposite(*sign), -x.clone()),
        }
    }

    /// The difference.
    pub fn minus(&self, other: &Self, precision: u32) -> Self {
        self.plus(&other.negated(), precision)
    }

    /// The product.
    pub fn times(&self, other: &Self, precision: u32) -> Self {
        match (self, other) {
            (RealNumber::Exact(q), RealNumber::Turns(p)) | (RealNumber::Turns(p), RealNumber::Exact(q)) => {
                RealNumber::turns(p * q)
            }
            (RealNumber::Exact(zero), _) | (_, RealNumber::Exact(zero)) if zero.is_zero() => RealNumber::integer(0),
            (RealNumber::Beyond(..), x) | (x, RealNumber::Beyond(..))
                if x.sign().is_some_and(|sign| sign != Sign::Zero) =>
            {
                let sign = if self.sign() == other.sign() { Sign::Positive } else { Sign::Negative };
                RealNumber::Beyond(sign, self.enclosure(precision) * other.enclosure(precision))
            }
            _ => self.with(other, precision, |a, b| a * b, |a, b| a * b, Algebraic::product),
        }
    }

    /// The sign, where the enclosure or the separation bound decides it.
    pub fn sign(&self) -> Option<Sign> {
        match self {
            RealNumber::Exact(q) | RealNumber::Turns(q) => q.sign(),
            RealNumber::Beyond(sign, _) => Some(*sign),
            RealNumber::Enclosed(x, algebraic) => x.sign().or_else(|| {
                // A number smaller than the separation bound is zero.
                let bound = i64::try_from(algebraic.as_ref()?.separation()).ok()?;
                (x.magnitude().top() <= -bound).then_some(Sign::Zero)
            }),
        }
    }

    /// Bits of precision at which the sign will be known, if there is a bound.
    pub fn needed_bits(&self) -> Option<u64> {
        match self {
            RealNumber::Enclosed(_, Some(bounds)) => Some(bounds.separation().saturating_add(bounds.upper + 64)),
            _ => None,
        }
    }

    /// The quotient.
    ///
    /// # Errors
    /// [`Obstacle`] where the divisor is or may be zero.
    pub fn over(&self, divisor: &Self, precision: u32) -> Result<Self, Obstacle> {
        match (self, divisor) {
            (RealNumber::Turns(a), RealNumber::Turns(b)) => return Ok(RealNumber::Exact(a / b)),
            (RealNumber::Turns(a), RealNumber::Exact(b)) if !b.is_zero() => return Ok(RealNumber::Turns(a / b)),
            (RealNumber::Exact(a), RealNumber::Exact(b)) if !b.is_zero() => return Ok(RealNumber::Exact(a / b)),
            _ => {}
        }
        match divisor.sign() {
            Some(Sign::Zero) => return Err(Obstacle::Never("/")),
            None => return Err(Obstacle::Perhaps("/")),
            Some(_) => {}
        }
        let inverse = divisor.enclosure(precision).recip().map_err(|_| Obstacle::Perhaps("/"))?;
        Ok(self.times(&RealNumber::Enclosed(inverse, divisor.algebraic().map(Algebraic::reciprocal)), precision))
    }

    /// `self^exponent`: of any number for an integer exponent, otherwise of one that is not negative.
    ///
    /// # Errors
    /// [`Obstacle`] where it has no value or none is found.
    pub fn power(&self, exponent: &Self, precision: u32) -> Result<Self, Obstacle> {
        if let Some(k) = exponent.as_integer() {
            let k = k.to_i64().filter(|k| k.unsigned_abs() <= 1 << 20).ok_or(Obstacle::TooLarge)?;
            let positive = self.to_the(k.unsigned_abs(), precision)?;
            return if k < 0 { RealNumber::integer(1).over(&positive, precision) } else { Ok(positive) };
        }
        match (self.sign(), exponent.sign()) {
            (Some(Sign::Negative), _) if !exponent.may_be_integer(precision) => return Err(Obstacle::Never("^")),
            (Some(Sign::Zero), Some(Sign::Positive)) => return Ok(RealNumber::integer(0)),
            (Some(Sign::Zero), Some(Sign::Negative)) => return Err(Obstacle::Never("/")),
            (Some(Sign::Positive), _) => {}
            _ => {}
        }
        if let RealNumber::Exact(q) = exponent
            && let Some(root) = q.denom().to_u32()
        {
            let base = self.root(root, precision)?;
            return base.power(&RealNumber::Exact(Rational::from_integer(q.numer())), precision);
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
        if let RealNumber::Exact(q) = self
            && !q.is_negative()
        {
            let (p, r) = (q.numer().nth_root(degree), q.denom().nth_root(degree));
            if p.pow(degree) == q.numer() && r.pow(degree) == q.denom() {
                return Ok(RealNumber::Exact(Rational::new(p, r)));
            }
        }
        let share = RealNumber::Exact(Rational::new(BigInt::from(1), BigInt::from(degree)));
        let root = share.times(&self.log(precision + 8).map_err(outside)?, precision + 8).exp(precision + 8)?;
        let algebraic = self.algebraic().map(|own| own.root(degree));
        Ok(RealNumber::Enclosed(root.enclosure(precision), algebraic))
    }

    fn to_the(&self, k: u64, precision: u32) -> Result<Self, Obstacle> {
        match self {
            RealNumber::Exact(q) => {
                let bits = q.numer().bits().max(q.denom().bits());
                let unit = q.numer().magnitude() <= &1u8.into() && q.is_integer();
                if !unit && bits.saturating_mul(k) > MOST_BITS {
                    return Err(Obstacle::TooLarge);
                }
                Ok(RealNumber::Exact(q.power(k)))
            }
            _ => {
                let algebraic = self.algebraic().map(|a| Algebraic {
                    upper: a.upper.saturating_mul(k),
                    lower: a.lower.saturating_mul(k),
                    ..a
                });
                Ok(RealNumber::Enclosed(self.enclosure(precision).power(k), algebraic))
            }
        }
    }

    /// The square root, exact where it is rational.
    ///
    /// # Errors
    /// [`Obstacle`] where the number is or may be negative.
    pub fn sqrt(&self, precision: u32) -> Result<Self, Obstacle> {
        if let RealNumber::Exact(q) = self {
            if q.is_negative() {
                return Err(Obstacle::Never("sqrt"));
            }
            let (p, r) = (q.numer().sqrt(), q.denom().sqrt());
            if &p * &p == q.numer() && &r * &r == q.denom() {
                return Ok(RealNumber::Exact(Rational::new(p, r)));
            }
        }
        match self.sign() {
            Some(Sign::Zero) => return Ok(RealNumber::integer(0)),
            Some(Sign::Negative) => return Err(Obstacle::Never("sqrt")),
            Some(Sign::Positive) => {}
            None if self.enclosure(precision).lo().is_negative() => return Err(Obstacle::Perhaps("sqrt")),
            None => {}
        }
        let root = self.enclosure(precision).sqrt().map_err(|_| Obstacle::Perhaps("sqrt"))?;
        Ok(RealNumber::Enclosed(root, self.algebraic().map(|own| own.root(2))))
    }

    /// The absolute value.
    pub fn absolute(&self, precision: u32) -> Self {
        match self {
            RealNumber::Exact(q) => RealNumber::Exact(q.abs()),
            RealNumber::Turns(q) => RealNumber::Turns(q.abs()),
            RealNumber::Beyond(Sign::Negative, _) => self.negated(),
            RealNumber::Beyond(..) => self.clone(),
            RealNumber::Enclosed(x, algebraic) => {
                let zero = Dyadic::zero();
                let size = match x.sign() {
                    Some(Sign::Negative) => -x.clone(),
                    Some(_) => x.clone(),
                    None => Interval::between(zero, x.magnitude(), precision),
                };
                RealNumber::Enclosed(size, *algebraic)
            }
        }
    }

    /// The larger of two, or the smaller.
    pub fn extreme(&self, other: &Self, larger: bool, precision: u32) -> Self {
        match self.minus(other, precision).sign() {
            Some(Sign::Negative) => return if larger { other.clone() } else { self.clone() },
            Some(_) => return if larger { self.clone() } else { other.clone() },
            None => {}
        }
        let (a, b) = (self.enclosure(precision), other.enclosure(precision));
        let end = |x: &Dyadic, y: &Dyadic| if (x >= y) == larger { x.clone() } else { y.clone() };
        let hull = Interval::between(end(a.lo(), b.lo()), end(a.hi(), b.hi()), precision);
        RealNumber::Enclosed(hull, self.algebraic().zip(other.algebraic()).map(|(a, b)| Algebraic::either(a, b)))
    }

    /// Cosine; exact or algebraic at rational multiples of pi.
    ///
    /// # Errors
    /// [`Obstacle`] where it cannot be enclosed.
    pub fn cos(&self, precision: u32) -> Result<Self, Obstacle> {
        match self {
            RealNumber::Exact(q) if q.is_zero() => Ok(RealNumber::integer(1)),
            RealNumber::Turns(q) => Ok(cosine_of_turns(q, precision)),
            _ => {
                let x = self.enclosure(precision).cos().map_err(|_| Obstacle::Perhaps("cos"))?;
                Ok(RealNumber::Enclosed(x, None))
            }
        }
    }

    /// Sine, as the cosine of the complement where that is exact.
    ///
    /// # Errors
    /// [`Obstacle`] where it cannot be enclosed.
    pub fn sin(&self, precision: u32) -> Result<Self, Obstacle> {
        match self {
            RealNumber::Exact(q) if q.is_zero() => Ok(RealNumber::integer(0)),
            RealNumber::Turns(q) => RealNumber::turns(rational(1, 2) - q).cos(precision),
            _ => {
                let x = self.enclosure(precision).sin().map_err(|_| Obstacle::Perhaps("sin"))?;
                Ok(RealNumber::Enclosed(x, None))
            }
        }
    }

    /// The exponential.
    ///
    /// # Errors
    /// [`Obstacle::TooLarge`].
    pub fn exp(&self, precision: u32) -> Result<Self, Obstacle> {
        if matches!(self, RealNumber::Exact(q) if q.is_zero()) {
            return Ok(RealNumber::integer(1));
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
            return Ok(RealNumber::Beyond(
                Sign::Positive,
                Interval::between(Dyadic::zero(), most.hi().clone(), precision),
            ));
        }
        Ok(RealNumber::Enclosed(of(&x)?, None))
    }

    /// The natural logarithm.
    ///
    /// # Errors
    /// [`Obstacle`] where the number is not certainly positive.
    pub fn log(&self, precision: u32) -> Result<Self, Obstacle> {
        match self.sign() {
            Some(Sign::Negative | Sign::Zero) => return Err(Obstacle::Never("log")),
            None => return Err(Obstacle::Perhaps("log")),
            Some(Sign::Positive) => {}
        }
        if let RealNumber::Exact(q) = self
            && *q == rational(1, 1)
        {
            return Ok(RealNumber::integer(0));
        }
        let x = self.enclosure(precision).ln().map_err(|_| Obstacle::Perhaps("log"))?;
        Ok(RealNumber::Enclosed(x, None))
    }

    /// The text of a number in answers: exact, or its ends rounded outward.
    pub fn text(&self) -> String {
        match self {
            RealNumber::Exact(q) => q.to_string(),
            RealNumber::Turns(q) => format!("{q}*pi"),
            RealNumber::Enclosed(x, _) | RealNumber::Beyond(_, x) => {
                let digits = significant_digits(x).clamp(3, 20) + 2;
                let (lo, hi) = decimals(x, digits);
                format!("[{lo}, {hi}]")
            }
        }
    }
}

/// `cos(q pi)`. `2 cos(q pi)` is an algebraic integer with conjugates of at most 2, of degree `phi(m)/2` for the order `m` of the root of unity
/// `e^(i q pi)`.
fn cosine_of_turns(q: &Rational, precision: u32) -> RealNumber {
    let two = BigInt::from(2);
    let turn = Rational::new(q.numer().mod_floor(&(&two * q.denom())), q.denom());
    // cos(q pi) = cos((2 - q) pi); the angle is then between 0 and pi.
    let angle = if turn > rational(1, 1) { rational(2, 1) - turn } else { turn };
    let exact = [(0, 1, 1, 1), (1, 3, 1, 2), (1, 2, 0, 1), (2, 3, -1, 2), (1, 1, -1, 1)];
    for (p, r, value, under) in exact {
        if angle == rational(p, r) {
            return RealNumber::Exact(rational(value, under));
        }
    }
    // e^(i q pi) is a primitive root of unity of order 2 r/gcd(p, 2).
    let order = if angle.numer().is_even() { angle.denom() } else { angle.denom() * two };
    let degree = order.to_u64().map_or(u64::MAX, |order| totient(order) / 2);
    let x = RealNumber::Turns(angle).enclosure(precision + 8).cos();
    match x {
        Ok(x) => {
            let bounds = Algebraic { degree: degree.max(1), upper: 1, lower: 1 };
            RealNumber::Enclosed(x.with_precision(precision), Some(bounds))
        }
        Err(_) => {
            let one = Interval::from_rational(&rational(1, 1), precision);
            RealNumber::Enclosed(one.hull(&-one.clone()), None)
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

/// A real number with the precision of its enclosures: the scalar for the values of expressions at points, whose signs are decided where they can be.
#[derive(Debug, Clone)]
pub struct PreciseNumber {
    /// The number.
    pub number: RealNumber,
    /// Bits of enclosures.
    pub precision: u32,
}

impl Obstacle {
    /// As an error of arithmetic; an inference of other code would suffer from `From`.
    fn error(self) -> ArithmeticError {
        match self {
            Obstacle::Never("/") | Obstacle::Perhaps("/") => ArithmeticError::DivisionByZero,
            Obstacle::Never(function) | Obstacle::Perhaps(function) => ArithmeticError::Argument(function),
            Obstacle::TooLarge => ArithmeticError::Domain("numbers with fewer digits"),
        }
    }
}

impl PreciseNumber {
    /// A rational number.
    pub fn exact(q: Rational, precision: u32) -> Self {
        PreciseNumber { number: RealNumber::Exact(q), precision }
    }

    fn with(&self, number: RealNumber) -> Self {
        PreciseNumber { number, precision: self.precision }
    }

    fn try_with(&self, number: Result<RealNumber, Obstacle>) -> Result<Self, ArithmeticError> {
        number.map(|number| self.with(number)).map_err(Obstacle::error)
    }

    fn enclosed(&self, f: impl Fn(&Interval) -> Result<Interval, ArithmeticError>) -> Result<Self, ArithmeticError> {
        Ok(self.with(RealNumber::interval(f(&self.number.enclosure(self.precision))?)))
    }
}

operators!(
    [] PreciseNumber,
    |a, b| a.with(a.number.plus(&b.number, a.precision)),
    |a, b| a.with(a.number.minus(&b.number, a.precision)),
    |a, b| a.with(a.number.times(&b.number, a.precision)),
    |a| a.with(a.number.negated())
);

impl Ring for PreciseNumber {
    fn integer(&self, n: i64) -> Self {
        self.with(RealNumber::integer(n))
    }
}

impl Field for PreciseNumber {
    fn rational(&self, q: &Rational) -> Self {
        self.with(RealNumber::Exact(q.clone()))
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        self.try_with(RealNumber::integer(1).over(&self.number, self.precision))
    }

    fn over(&self, divisor: &Self) -> Result<Self, ArithmeticError> {
        self.try_with(self.number.over(&divisor.number, self.precision))
    }
}

impl Signed for PreciseNumber {
    fn sign(&self) -> Option<Sign> {
        self.number.sign()
    }

    fn absolute(&self) -> Result<Self, ArithmeticError> {
        Ok(self.with(self.number.absolute(self.precision)))
    }

    fn larger(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(self.with(self.number.extreme(&other.number, true, self.precision)))
    }

    fn smaller(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(self.with(self.number.extreme(&other.number, false, self.precision)))
    }
}

impl Real for PreciseNumber {
    fn pi(&self) -> Self {
        self.with(RealNumber::Turns(rational(1, 1)))
    }
}

impl Number for PreciseNumber {
    fn either(&self, other: &Self) -> Option<Self> {
        let [own, other] = [self, other].map(|x| x.number.enclosure(self.precision));
        Some(self.with(RealNumber::interval(own.hull(&other))))
    }

    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(self.pi())
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        self.try_with(self.number.sqrt(self.precision))
    }

    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        let share = RealNumber::Exact(Rational::new(1.into(), degree.into()));
        self.try_with(self.number.power(&share, self.precision))
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        self.try_with(self.number.exp(self.precision))
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        self.try_with(self.number.log(self.precision))
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        Ok((self.try_with(self.number.sin(self.precision))?, self.try_with(self.number.cos(self.precision))?))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        self.enclosed(Interval::atan)
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        if self.sign() == Some(Sign::Zero) {
            return Ok((self.integer(0), self.integer(1)));
        }
        Ok((self.enclosed(|x| Ok(x.sinh_cosh()?.0))?, self.enclosed(|x| Ok(x.sinh_cosh()?.1))?))
    }
}
