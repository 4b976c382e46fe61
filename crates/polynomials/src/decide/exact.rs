//! Real numbers that are enclosed and, at the same time, quotients of polynomials in roots, exponentials, logarithms and sines of numbers, so that those that are
//! equal by an identity are known to be.

use super::Extended;
use crate::symbolic::{Extension, Symbolic};
use arithmetic::{
    ArithmeticError, Field, FloatInterval, Interval, Number, PreciseNumber, Rational, RealNumber, Ring, Sign, Signed,
    operators, rational,
};

/// A number in both ways; what is rational by an identity is so in both.
#[derive(Debug, Clone)]
pub(super) struct Exact {
    number: PreciseNumber,
    symbol: Symbolic,
}

/// Bits of the enclosures.
const BITS: u32 = 256;

/// More denominators of exponents than this are not brought together.
const GRIDS: usize = 3;

/// Something computed from one, again with finer exponents as long as there are such: the first result that is wanted, or the last one.
pub(super) fn computed<R>(of: impl Fn(&Exact) -> Option<R>, wanted: impl Fn(&R) -> bool) -> Option<R> {
    let (mut grid, mut last) = (1, None);
    for _ in 0..GRIDS {
        let extension = Extension::with_grid(0, grid);
        let one = Exact { number: PreciseNumber::exact(rational(1, 1), BITS), symbol: extension.unit() };
        last = of(&one);
        if last.as_ref().is_some_and(&wanted) || extension.finest() == grid {
            break;
        }
        grid = extension.finest();
    }
    last
}

impl Exact {
    fn of(number: PreciseNumber, symbol: Symbolic) -> Self {
        match symbol.as_constant() {
            Some(q) => Exact { number: PreciseNumber { number: RealNumber::Exact(q), ..number }, symbol },
            None => Exact { number, symbol },
        }
    }

    /// A number between two others of which nothing else is known so far.
    pub fn unknown(&self, lo: &Rational, hi: &Rational) -> Self {
        let number = RealNumber::interval(Interval::hull_of_rationals(lo, hi, BITS));
        Exact { number: PreciseNumber { number, precision: BITS }, symbol: self.symbol.unknown() }
    }

    /// From now on it is known to be 0.
    pub fn is_zero_from_now(&self) {
        self.symbol.is_zero_from_now();
    }

    /// Floats between which it lies.
    pub fn enclosed(&self) -> Extended {
        let range = FloatInterval::from_interval(&self.number.number.enclosure(BITS));
        Extended::between(range.lo(), range.hi())
    }

    /// The rational number that it is known to be.
    pub fn as_rational(&self) -> Option<Rational> {
        match &self.number.number {
            RealNumber::Exact(q) => Some(q.clone()),
            _ => self.symbol.as_constant(),
        }
    }

    fn both(
        &self,
        number: impl Fn(&PreciseNumber) -> Result<PreciseNumber, ArithmeticError>,
        symbol: impl Fn(&Symbolic) -> Result<Symbolic, ArithmeticError>,
    ) -> Result<Self, ArithmeticError> {
        Ok(Exact::of(number(&self.number)?, symbol(&self.symbol)?))
    }
}

operators!(
    [] Exact,
    |a, b| Exact::of(a.number.clone() + &b.number, a.symbol.clone() + &b.symbol),
    |a, b| Exact::of(a.number.clone() - &b.number, a.symbol.clone() - &b.symbol),
    |a, b| Exact::of(a.number.clone() * &b.number, a.symbol.clone() * &b.symbol),
    |a| Exact::of(-a.number.clone(), -a.symbol.clone())
);

impl Ring for Exact {
    fn integer(&self, n: i64) -> Self {
        Exact { number: self.number.integer(n), symbol: self.symbol.integer(n) }
    }
}

impl Field for Exact {
    fn rational(&self, q: &Rational) -> Self {
        Exact { number: self.number.rational(q), symbol: self.symbol.rational(q) }
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        self.both(Field::recip, Field::recip)
    }
}

impl Signed for Exact {
    fn sign(&self) -> Option<Sign> {
        self.number.sign()
    }
}

impl Number for Exact {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        self.both(Number::circle, Number::circle)
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        self.both(Number::sqrt, Number::sqrt)
    }

    /// 0 of 0, which has no logarithm.
    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        match self.sign() {
            Some(Sign::Zero) => Ok(self.zero()),
            _ => self.both(|x| x.root(degree), |x| x.root(degree)),
        }
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        self.both(Number::exp, Number::exp)
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        self.both(Number::ln, Number::ln)
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        let (numbers, symbols) = (self.number.sin_cos()?, self.symbol.sin_cos()?);
        Ok((Exact::of(numbers.0, symbols.0), Exact::of(numbers.1, symbols.1)))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        self.both(Number::atan, Number::atan)
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        let (numbers, symbols) = (self.number.sinh_cosh()?, self.symbol.sinh_cosh()?);
        Ok((Exact::of(numbers.0, symbols.0), Exact::of(numbers.1, symbols.1)))
    }
}
