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
    /// `None` where the scalar has none, as that of slopes at the kink of an absolute value: the parts stand for it, but it is no part itself.
    value: Option<T>,
    /// Any number of the scalar.
    like: T,
    guide: f64,
    parts: Vec<(f64, Option<T>)>,
    sense: Sense,
}

/// Numbers that are 0 only together with a function: it is 0 wherever all of them are. The choices are those at `guide`, so that the same guide gives the same
/// functions in every scalar.
pub(super) fn system<F: Function, T: Number>(function: &F, at: &[T], guide: &[f64]) -> Option<Vec<T>> {
    let at: Vec<Parted<T>> = at.iter().zip(guide).map(|(x, guide)| Parted::whole(x.clone(), *guide)).collect();
    let value = function.value(&at).ok()?;
    value.parts.into_iter().map(|(_, part)| part).collect()
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
        Parted {
            parts: vec![(guide, Some(value.clone()))],
            like: value.zero(),
            value: Some(value),
            guide,
            sense: Sense::Unknown,
        }
    }

    fn positive(value: T, guide: f64) -> Self {
        Parted { sense: Sense::NotNegative, ..Parted::whole(value, guide) }
    }

    fn constant(value: T, q: &Rational) -> Self {
        let guide = q.to_f64().unwrap_or(f64::NAN);
        match (q.is_zero(), q.is_negative()) {
            (true, _) => Parted { guide, parts: Vec::new(), sense: Sense::Zero, ..Parted::whole(value, guide) },
            (_, true) => Parted { sense: Sense::NotPositive, ..Parted::whole(value, guide) },
            _ => Parted::positive(value, guide),
        }
    }

    /// A number of its own, where it has a value.
    fn apart(&self, value: Option<T>, guide: f64) -> Self {
        Parted { parts: vec![(guide, value.clone())], value, like: self.like.clone(), guide, sense: Sense::Unknown }
    }

    /// Another number that is 0 where this one is, and not negative.
    fn with(&self, value: Option<T>, guide: f64) -> Self {
        Parted { value, like: self.like.clone(), guide, parts: self.parts.clone(), sense: Sense::NotNegative }
    }

    /// A function of the number, where it has a value.
    fn mapped<R, E>(&self, function: impl FnOnce(&T) -> Result<R, E>) -> Result<Option<R>, E> {
        self.value.as_ref().map(function).transpose()
    }

    /// A function of two numbers, where both have values.
    fn joined<R>(&self, other: &Self, function: impl FnOnce(&T, &T) -> R) -> Option<R> {
        Some(function(self.value.as_ref()?, other.value.as_ref()?))
    }

    /// Which sign it has at the guide, where it is not known to have one everywhere.
    fn sense_near(&self) -> Sense {
        const CLEAR: f64 = 1e-3;
        match self.sense {
            Sense::Unknown if self.guide >= CLEAR => Sense::NotNegative,
            Sense::Unknown if self.guide <= -CLEAR => Sense::NotPositive,
            sense => sense,
        }
    }

    /// How far the parts are from 0 at the guide.
    fn distance(&self) -> f64 {
        self.parts.iter().map(|(guide, _)| guide.abs()).fold(0.0, f64::max)
    }

    /// All parts of both.
    fn both(&self, other: &Self) -> Vec<(f64, Option<T>)> {
        [self.parts.clone(), other.parts.clone()].concat()
    }

    fn plus(a: &Self, b: &Self) -> Self {
        match (a.sense, b.sense) {
            (Sense::Zero, _) => b.clone(),
            (_, Sense::Zero) => a.clone(),
            (first, second) => {
                let sum = a.apart(a.joined(b, |a, b| a.clone() + b), a.guide + b.guide);
                if first == second && first != Sense::Unknown {
                    Parted { parts: a.both(b), sense: first, ..sum }
                } else {
                    sum
                }
            }
        }
    }

    fn minus(a: &Self, b: &Self) -> Self {
        Parted::plus(a, &Parted::opposite(b))
    }

    fn opposite(a: &Self) -> Self {
        Parted { value: a.value.clone().map(|x| -x), guide: -a.guide, sense: a.sense.negated(), ..a.clone() }
    }

    /// Either factor makes a product 0.
    fn times(a: &Self, b: &Self) -> Self {
        let nearer = if a.distance() <= b.distance() { a } else { b };
        let sense = match (a.sense_near(), b.sense_near()) {
            (Sense::Zero, _) | (_, Sense::Zero) => Sense::Zero,
            (Sense::Unknown, Sense::Unknown) if a.guide == b.guide => Sense::NotNegative,
            (Sense::Unknown, _) | (_, Sense::Unknown) => Sense::Unknown,
            (first, second) if first == second => Sense::NotNegative,
            _ => Sense::NotPositive,
        };
        let value = a.joined(b, |a, b| a.clone() * b);
        Parted { value, guide: a.guide * b.guide, sense, ..nearer.clone() }
    }
}

operators!([T: Ring] Parted<T>, Parted::plus, Parted::minus, Parted::times, Parted::opposite);

impl<T: Ring> Ring for Parted<T> {
    fn integer(&self, n: i64) -> Self {
        Parted::constant(self.like.integer(n), &Rational::from_integer(n.into()))
    }

    fn square(&self) -> Self {
        self.power(2)
    }

    fn power(&self, exponent: u64) -> Self {
        if exponent == 0 {
            return self.one();
        }
        let guide = i32::try_from(exponent).map_or(f64::NAN, |exponent| self.guide.powi(exponent));
        let even = self.with(self.value.as_ref().map(|value| value.power(exponent)), guide);
        match self.sense {
            Sense::Zero => self.clone(),
            _ if exponent.is_multiple_of(2) => even,
            sense => Parted { sense, ..even },
        }
    }
}

impl<T: Field> Field for Parted<T> {
    fn rational(&self, q: &Rational) -> Self {
        Parted::constant(self.like.rational(q), q)
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        Ok(Parted { sense: self.sense, ..self.apart(self.mapped(Field::recip)?, 1.0 / self.guide) })
    }
}

impl<T: Signed> Signed for Parted<T> {
    fn sign(&self) -> Option<Sign> {
        self.value.as_ref()?.sign()
    }

    fn side(&self) -> Option<Sign> {
        self.value.as_ref()?.side()
    }

    /// 0 where the number is, also where it has no slope.
    fn absolute(&self) -> Result<Self, ArithmeticError> {
        Ok(self.with(self.mapped(Signed::absolute).ok().flatten(), self.guide.abs()))
    }

    /// Of two that are not negative, 0 where both are.
    fn larger(&self, other: &Self) -> Result<Self, ArithmeticError> {
        let value = self.joined(other, Signed::larger).and_then(Result::ok);
        let larger = self.apart(value, self.guide.max(other.guide));
        let is_positive = |x: &Self| matches!(x.sense, Sense::NotNegative | Sense::Zero);
        Ok(match is_positive(self) && is_positive(other) {
            true => Parted { parts: self.both(other), sense: Sense::NotNegative, ..larger },
            false => larger,
        })
    }

    fn smaller(&self, other: &Self) -> Result<Self, ArithmeticError> {
        let value = self.joined(other, Signed::smaller).and_then(Result::ok);
        Ok(self.apart(value, self.guide.min(other.guide)))
    }
}

impl<T: Number> Number for Parted<T> {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(Parted::positive(self.like.circle()?, std::f64::consts::PI))
    }

    /// 0 where the number is, also where it has no slope.
    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        Ok(self.with(self.mapped(Number::sqrt).ok().flatten(), self.guide.max(0.0).sqrt()))
    }

    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        let root = self.mapped(|x| x.root(degree)).ok().flatten();
        Ok(self.with(root, self.guide.max(0.0).powf(1.0 / degree as f64)))
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        Ok(Parted { sense: Sense::NotNegative, ..self.apart(self.mapped(Number::exp)?, self.guide.exp()) })
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        Ok(self.apart(self.mapped(Number::ln)?, self.guide.ln()))
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        let (sin, cos) = self.mapped(Number::sin_cos)?.unzip();
        let (s, c) = self.guide.sin_cos();
        Ok((self.apart(sin, s), self.apart(cos, c)))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        Ok(self.apart(self.mapped(Number::atan)?, self.guide.atan()))
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        let (sinh, cosh) = self.mapped(Number::sinh_cosh)?.unzip();
        let positive = self.apart(cosh, self.guide.cosh());
        Ok((self.apart(sinh, self.guide.sinh()), Parted { sense: Sense::NotNegative, ..positive }))
    }
}
