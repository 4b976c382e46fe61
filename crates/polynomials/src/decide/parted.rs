//! Numbers that know parts of themselves: where all parts are 0, so is the number. A sum of squares has the roots of the squares as its parts, so that its zeros
//! are simple ones of a system of equations.

use crate::function::Function;
use arithmetic::{ArithmeticError, Field, Number, Rational, Ring, Sign, Signed, operators};
use num_traits::{Signed as _, ToPrimitive, Zero};

/// Whether two terms of a sum can cancel. It only chooses between ways to name parts, each of which is right, except for `Zero`, which is the number 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sense {
    Zero,
    NotNegative,
    NotPositive,
    Unknown,
}

/// A number with its parts, beside a float that says near which point the choices are made.
#[derive(Debug, Clone)]
struct Parted<T> {
    value: T,
    guide: f64,
    parts: Vec<(f64, T)>,
    sense: Sense,
}

/// Numbers that are 0 only together with a function: it is 0 wherever all of them are. The choices are those at `guide`, so that the same guide gives the same
/// functions in every scalar.
pub(super) fn system<F: Function, T: Number>(function: &F, at: &[T], guide: &[f64]) -> Option<Vec<T>> {
    let at: Vec<Parted<T>> = at.iter().zip(guide).map(|(x, guide)| Parted::whole(x.clone(), *guide)).collect();
    let value = function.value(&at).ok()?;
    Some(value.parts.into_iter().map(|(_, part)| part).collect())
}

impl Sense {
    fn negated(self) -> Self {
        match self {
            Sense::NotNegative => Sense::NotPositive,
            Sense::NotPositive => Sense::NotNegative,
            same => same,
        }
    }
}

impl<T: Ring> Parted<T> {
    /// A number that is its only part.
    fn whole(value: T, guide: f64) -> Self {
        Parted { parts: vec![(guide, value.clone())], value, guide, sense: Sense::Unknown }
    }

    fn positive(value: T, guide: f64) -> Self {
        Parted { sense: Sense::NotNegative, ..Parted::whole(value, guide) }
    }

    fn constant(value: T, q: &Rational) -> Self {
        let guide = q.to_f64().unwrap_or(f64::NAN);
        match (q.is_zero(), q.is_negative()) {
            (true, _) => Parted { value, guide, parts: Vec::new(), sense: Sense::Zero },
            (_, true) => Parted { sense: Sense::NotPositive, ..Parted::whole(value, guide) },
            _ => Parted::positive(value, guide),
        }
    }

    /// Another number that is 0 where this one is, and not negative.
    fn with(&self, value: T, guide: f64) -> Self {
        Parted { value, guide, parts: self.parts.clone(), sense: Sense::NotNegative }
    }

    /// How far the parts are from 0 at the guide.
    fn distance(&self) -> f64 {
        self.parts.iter().map(|(guide, _)| guide.abs()).fold(0.0, f64::max)
    }

    fn plus(a: &Self, b: &Self) -> Self {
        match (a.sense, b.sense) {
            (Sense::Zero, _) => b.clone(),
            (_, Sense::Zero) => a.clone(),
            (first, second) => {
                let (value, guide) = (a.value.clone() + &b.value, a.guide + b.guide);
                if first == second && first != Sense::Unknown {
                    Parted { value, guide, parts: [a.parts.clone(), b.parts.clone()].concat(), sense: first }
                } else {
                    Parted::whole(value, guide)
                }
            }
        }
    }

    fn minus(a: &Self, b: &Self) -> Self {
        Parted::plus(a, &Parted::opposite(b))
    }

    fn opposite(a: &Self) -> Self {
        Parted { value: -a.value.clone(), guide: -a.guide, parts: a.parts.clone(), sense: a.sense.negated() }
    }

    /// Either factor makes a product 0.
    fn times(a: &Self, b: &Self) -> Self {
        let nearer = if a.distance() <= b.distance() { a } else { b };
        let sense = match (a.sense, b.sense) {
            (Sense::Zero, _) | (_, Sense::Zero) => Sense::Zero,
            (Sense::Unknown, Sense::Unknown) if a.guide == b.guide => Sense::NotNegative,
            (Sense::Unknown, _) | (_, Sense::Unknown) => Sense::Unknown,
            (first, second) if first == second => Sense::NotNegative,
            _ => Sense::NotPositive,
        };
        Parted { value: a.value.clone() * &b.value, guide: a.guide * b.guide, parts: nearer.parts.clone(), sense }
    }
}

operators!([T: Ring] Parted<T>, Parted::plus, Parted::minus, Parted::times, Parted::opposite);

impl<T: Ring> Ring for Parted<T> {
    fn integer(&self, n: i64) -> Self {
        Parted::constant(self.value.integer(n), &Rational::from_integer(n.into()))
    }

    fn square(&self) -> Self {
        self.power(2)
    }

    fn power(&self, exponent: u64) -> Self {
        if exponent == 0 {
            return self.one();
        }
        let guide = i32::try_from(exponent).map_or(f64::NAN, |exponent| self.guide.powi(exponent));
        let even = self.with(self.value.power(exponent), guide);
        match self.sense {
            Sense::Zero => self.clone(),
            _ if exponent.is_multiple_of(2) => even,
            sense => Parted { sense, ..even },
        }
    }
}

impl<T: Field> Field for Parted<T> {
    fn rational(&self, q: &Rational) -> Self {
        Parted::constant(self.value.rational(q), q)
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        Ok(Parted { sense: self.sense, ..Parted::whole(self.value.recip()?, 1.0 / self.guide) })
    }
}

impl<T: Signed> Signed for Parted<T> {
    fn sign(&self) -> Option<Sign> {
        self.value.sign()
    }

    fn side(&self) -> Option<Sign> {
        self.value.side()
    }

    fn absolute(&self) -> Result<Self, ArithmeticError> {
        Ok(self.with(self.value.absolute()?, self.guide.abs()))
    }

    fn larger(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(Parted::whole(self.value.larger(&other.value)?, self.guide.max(other.guide)))
    }

    fn smaller(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(Parted::whole(self.value.smaller(&other.value)?, self.guide.min(other.guide)))
    }
}

impl<T: Number> Number for Parted<T> {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(Parted::positive(self.value.circle()?, std::f64::consts::PI))
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        Ok(self.with(self.value.sqrt()?, self.guide.sqrt()))
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        Ok(Parted::positive(self.value.exp()?, self.guide.exp()))
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        Ok(Parted::whole(self.value.ln()?, self.guide.ln()))
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        let ((sin, cos), (s, c)) = (self.value.sin_cos()?, self.guide.sin_cos());
        Ok((Parted::whole(sin, s), Parted::whole(cos, c)))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        Ok(Parted::whole(self.value.atan()?, self.guide.atan()))
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        let (sinh, cosh) = self.value.sinh_cosh()?;
        Ok((Parted::whole(sinh, self.guide.sinh()), Parted::positive(cosh, self.guide.cosh())))
    }
}
