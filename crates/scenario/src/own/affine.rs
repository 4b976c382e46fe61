//! A scalar for steps of discrete time from a box of starts: an affine function of the numbers that are intervals, with rational coefficients, as long as the law
//! makes no other ones; else what [`PreciseNumber`] knows.

use crate::view::{Amount, Measurable, Rows, ValueAt};
use arithmetic::{
    ArithmeticError, Field, Interval, Number, PreciseNumber, Rational, Real, RealNumber, Ring, Sign, Signed, rational,
};
use models::double_integrator::Potential;
use num_traits::Zero;
use std::sync::Arc;

/// A number of the state of a flock for all starts of a box at once.
#[derive(Debug, Clone)]
pub enum AffineNumber {
    /// One number, or what is known to lie in an interval.
    Plain(PreciseNumber),
    /// An affine function of the numbers of the start that are intervals.
    Affine(AffineFunction),
}

/// `constant + slopes · s` for `s` in a box; not all slopes are 0.
#[derive(Debug, Clone)]
pub struct AffineFunction {
    ranges: Arc<Vec<[Rational; 2]>>,
    constant: Rational,
    slopes: Vec<Rational>,
    precision: u32,
}

impl AffineFunction {
    /// The least and the largest value, which are attained at corners.
    pub fn ends(&self) -> [Rational; 2] {
        let mut ends = [self.constant.clone(), self.constant.clone()];
        for (slope, [lo, hi]) in self.slopes.iter().zip(self.ranges.iter()) {
            let is_rising = *slope > rational(0, 1);
            let (least, most) = if is_rising { (lo, hi) } else { (hi, lo) };
            ends[0] += slope * least;
            ends[1] += slope * most;
        }
        ends
    }

    /// The value at one start.
    pub fn at(&self, start: &[Rational]) -> Rational {
        self.slopes.iter().zip(start).fold(self.constant.clone(), |sum, (slope, s)| sum + slope * s)
    }

    /// Bits of all its numbers, and of the longest one.
    pub(super) fn bits(&self) -> (u64, u64) {
        let bits = |q: &Rational| q.numer().bits().max(q.denom().bits());
        let all = std::iter::once(&self.constant).chain(&self.slopes).map(bits);
        all.fold((0, 0), |(sum, most), own| (sum + own, most.max(own)))
    }

    /// An interval around all its values.
    pub(super) fn enclosed(&self) -> PreciseNumber {
        let [lo, hi] = self.ends();
        let number = RealNumber::interval(Interval::hull_of_rationals(&lo, &hi, self.precision));
        PreciseNumber { number, precision: self.precision }
    }

    fn with(&self, constant: Rational, slopes: Vec<Rational>) -> AffineNumber {
        if slopes.iter().all(Zero::is_zero) {
            return AffineNumber::Plain(PreciseNumber::exact(constant, self.precision));
        }
        AffineNumber::Affine(AffineFunction { constant, slopes, ..self.clone() })
    }

    fn scaled(&self, factor: &Rational) -> AffineNumber {
        self.with(&self.constant * factor, self.slopes.iter().map(|slope| slope * factor).collect())
    }

    fn shifted(&self, shift: &Rational) -> AffineNumber {
        self.with(&self.constant + shift, self.slopes.clone())
    }

    fn plus(&self, other: &Self, sign: &Rational) -> AffineNumber {
        let slopes = self.slopes.iter().zip(&other.slopes).map(|(a, b)| a + b * sign);
        self.with(&self.constant + &other.constant * sign, slopes.collect())
    }

    /// Its sign, where all values have the same; with `or_zero` one that some values may miss by being 0.
    fn sign(&self, or_zero: bool) -> Option<Sign> {
        let [lo, hi] = self.ends();
        let zero = rational(0, 1);
        match (lo > zero || or_zero && lo == zero, hi < zero || or_zero && hi == zero) {
            (true, _) => Some(Sign::Positive),
            (_, true) => Some(Sign::Negative),
            _ => None,
        }
    }
}

/// The numbers of a start, of which those in `wide` range over intervals, by their places.
pub(super) fn start_of(numbers: &[Rational], wide: &[(usize, [Rational; 2])], precision: u32) -> Vec<AffineNumber> {
    let exact = |q: &Rational| AffineNumber::Plain(PreciseNumber::exact(q.clone(), precision));
    let mut state: Vec<AffineNumber> = numbers.iter().map(exact).collect();
    let ranges = Arc::new(wide.iter().map(|(_, ends)| ends.clone()).collect::<Vec<_>>());
    for (k, (place, [lo, hi])) in wide.iter().enumerate() {
        state[*place] = if lo == hi {
            exact(lo)
        } else {
            let slopes = (0..wide.len()).map(|j| rational(i64::from(j == k), 1)).collect();
            AffineNumber::Affine(AffineFunction { ranges: ranges.clone(), constant: rational(0, 1), slopes, precision })
        };
    }
    state
}

impl AffineNumber {
    /// What is known of it apart from the start.
    pub fn plain(&self) -> PreciseNumber {
        match self {
            AffineNumber::Plain(x) => x.clone(),
            AffineNumber::Affine(f) => f.enclosed(),
        }
    }

    /// Whether nothing of it is enclosed only.
    pub fn is_exact(&self) -> bool {
        match self {
            AffineNumber::Plain(x) => matches!(x.number, RealNumber::Exact(_)),
            AffineNumber::Affine(_) => true,
        }
    }

    /// Whether both are known exactly and the same for every start.
    pub fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (AffineNumber::Affine(a), AffineNumber::Affine(b)) => (&a.constant, &a.slopes) == (&b.constant, &b.slopes),
            (AffineNumber::Plain(a), AffineNumber::Plain(b)) => {
                matches!((&a.number, &b.number), (RealNumber::Exact(a), RealNumber::Exact(b)) if a == b)
            }
            _ => false,
        }
    }

    fn precision(&self) -> u32 {
        match self {
            AffineNumber::Plain(x) => x.precision,
            AffineNumber::Affine(f) => f.precision,
        }
    }

    /// The least and the largest value over all starts, where these are known exactly.
    pub(super) fn ends(&self) -> Option<[Rational; 2]> {
        match self {
            AffineNumber::Affine(f) => Some(f.ends()),
            AffineNumber::Plain(_) => self.exact().map(|q| [q.clone(), q.clone()]),
        }
    }

    /// The number itself, where it is the same for all starts.
    pub(super) fn exact(&self) -> Option<&Rational> {
        match self {
            AffineNumber::Plain(PreciseNumber { number: RealNumber::Exact(q), .. }) => Some(q),
            _ => None,
        }
    }

    fn sum(a: &Self, b: &Self, sign: i64) -> Self {
        let sign = rational(sign, 1);
        match (a, b) {
            (AffineNumber::Affine(a), AffineNumber::Affine(b)) => a.plus(b, &sign),
            (AffineNumber::Affine(f), other) if other.exact().is_some() => {
                f.shifted(&(other.exact().cloned().unwrap_or_default() * sign))
            }
            (other, AffineNumber::Affine(f)) if other.exact().is_some() => match f.scaled(&sign) {
                AffineNumber::Affine(f) => f.shifted(&other.exact().cloned().unwrap_or_default()),
                plain => plain,
            },
            _ if sign > rational(0, 1) => AffineNumber::Plain(a.plain() + b.plain()),
            _ => AffineNumber::Plain(a.plain() - b.plain()),
        }
    }

    fn times(a: &Self, b: &Self) -> Self {
        match (a, b) {
            (AffineNumber::Affine(f), other) | (other, AffineNumber::Affine(f)) if other.exact().is_some() => {
                f.scaled(&other.exact().cloned().unwrap_or_default())
            }
            _ => AffineNumber::Plain(a.plain() * b.plain()),
        }
    }

    /// The larger of two, or the smaller one: one of them where it is the same one for all starts.
    fn extreme(&self, other: &Self, larger: bool) -> Self {
        let difference = AffineNumber::sum(self, other, -1);
        let side = match &difference {
            AffineNumber::Affine(f) => f.sign(true),
            AffineNumber::Plain(x) => x.sign(),
        };
        if let Some(side) = side {
            let own = (side == Sign::Negative) != larger;
            return if own { self.clone() } else { other.clone() };
        }
        let (a, b) = (self.plain(), other.plain());
        let number = a.number.extreme(&b.number, larger, a.precision);
        AffineNumber::Plain(PreciseNumber { number, ..a })
    }

    fn applied(
        &self,
        f: impl Fn(&PreciseNumber) -> Result<PreciseNumber, ArithmeticError>,
    ) -> Result<Self, ArithmeticError> {
        Ok(AffineNumber::Plain(f(&self.plain())?))
    }

    fn applied_twice(
        &self,
        f: impl Fn(&PreciseNumber) -> Result<(PreciseNumber, PreciseNumber), ArithmeticError>,
    ) -> Result<(Self, Self), ArithmeticError> {
        let (first, second) = f(&self.plain())?;
        Ok((AffineNumber::Plain(first), AffineNumber::Plain(second)))
    }
}

arithmetic::operators!(
    [] AffineNumber,
    |a, b| AffineNumber::sum(a, b, 1),
    |a, b| AffineNumber::sum(a, b, -1),
    AffineNumber::times,
    |a| match a {
        AffineNumber::Plain(x) => AffineNumber::Plain(-x.clone()),
        AffineNumber::Affine(f) => f.scaled(&rational(-1, 1)),
    }
);

impl Ring for AffineNumber {
    fn integer(&self, n: i64) -> Self {
        AffineNumber::Plain(PreciseNumber::exact(rational(n, 1), self.precision()))
    }

    /// Not negative, also where the sign of the number is open.
    fn square(&self) -> Self {
        match self {
            AffineNumber::Plain(x) => AffineNumber::Plain(x.square()),
            AffineNumber::Affine(f) => {
                let number = RealNumber::interval(f.enclosed().number.enclosure(f.precision).square());
                AffineNumber::Plain(PreciseNumber { number, precision: f.precision })
            }
        }
    }
}

impl Field for AffineNumber {
    fn rational(&self, q: &Rational) -> Self {
        AffineNumber::Plain(PreciseNumber::exact(q.clone(), self.precision()))
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        self.applied(Field::recip)
    }

    fn over(&self, divisor: &Self) -> Result<Self, ArithmeticError> {
        match (self, divisor.exact()) {
            (AffineNumber::Affine(f), Some(q)) if !q.is_zero() => Ok(f.scaled(&q.recip())),
            _ => Ok(AffineNumber::Plain(self.plain().over(&divisor.plain())?)),
        }
    }
}

impl Signed for AffineNumber {
    fn sign(&self) -> Option<Sign> {
        match self {
            AffineNumber::Plain(x) => x.sign(),
            AffineNumber::Affine(f) => f.sign(false),
        }
    }

    fn side(&self) -> Option<Sign> {
        match self {
            AffineNumber::Plain(x) => x.side(),
            AffineNumber::Affine(f) => f.sign(true),
        }
    }

    fn absolute(&self) -> Result<Self, ArithmeticError> {
        Ok(self.size())
    }

    fn larger(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(self.extreme(other, true))
    }

    fn smaller(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(self.extreme(other, false))
    }
}

impl Number for AffineNumber {
    fn either(&self, other: &Self) -> Option<Self> {
        if self.is_same(other) {
            return Some(self.clone());
        }
        self.plain().either(&other.plain()).map(AffineNumber::Plain)
    }

    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(AffineNumber::Plain(self.plain().pi()))
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        self.applied(Number::sqrt)
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        self.applied(Number::exp)
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        self.applied(Number::ln)
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        self.applied_twice(Number::sin_cos)
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        self.applied(Number::atan)
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        self.applied_twice(Number::sinh_cosh)
    }
}

impl Measurable for AffineNumber {
    fn lesser(self, other: Self) -> Self {
        self.extreme(&other, false)
    }

    fn greater(self, other: Self) -> Self {
        self.extreme(&other, true)
    }

    fn size(&self) -> Self {
        match self {
            AffineNumber::Plain(x) => AffineNumber::Plain(x.size()),
            AffineNumber::Affine(f) => match f.sign(true) {
                Some(Sign::Negative) => f.scaled(&rational(-1, 1)),
                Some(_) => self.clone(),
                None => AffineNumber::Plain(f.enclosed().size()),
            },
        }
    }

    fn potential<'p>(potential: &'p Potential, like: &Self) -> Result<ValueAt<'p, Self>, ArithmeticError> {
        let value = potential.value_over(like)?;
        Ok(Box::new(move |s| value.at(s)))
    }

    fn heading_spread(_: &Rows<Self>) -> Amount<Self> {
        Amount::Unknown("headings are not known in closed form")
    }
}
