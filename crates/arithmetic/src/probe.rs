//! The scalar of an identity test: three arithmetics behind one type, so that an identity is compiled once.

use super::operators::operators;
use super::residue::Residue;
use super::{ArithmeticError, DegreeBound, Field, Number, Rational, Ring, Sign, Signed};
use sha2::{Digest, Sha256};
use std::cmp::Ordering;

/// What the two sides of an identity are run over. All scalars of one evaluation are of one kind.
#[derive(Debug, Clone, PartialEq)]
pub enum Probe {
    /// Bounds of degrees and coefficients.
    Degree(DegreeBound),
    /// Modulo a prime.
    Residue(Residue),
    /// Exact.
    Exact(Rational),
}

impl Probe {
    /// The number, where the evaluation is exact.
    pub fn exact(&self) -> Option<&Rational> {
        match self {
            Probe::Exact(q) => Some(q),
            _ => None,
        }
    }
}

/// Applies an operation to two scalars of one kind. Scalars of different kinds do not meet; if they did, the bound would be useless, not wrong.
macro_rules! both {
    ($operator:tt) => {
        |a, b| match (a, b) {
            (Probe::Degree(a), Probe::Degree(b)) => Probe::Degree(*a $operator b),
            (Probe::Residue(a), Probe::Residue(b)) => Probe::Residue(*a $operator b),
            (Probe::Exact(a), Probe::Exact(b)) => Probe::Exact(a $operator b),
            _ => Probe::Degree(DegreeBound::constant(u64::MAX, u64::MAX)),
        }
    };
}

operators!([] Probe, both!(+), both!(-), both!(*), |a| match a {
    Probe::Degree(a) => Probe::Degree(-*a),
    Probe::Residue(a) => Probe::Residue(-*a),
    Probe::Exact(a) => Probe::Exact(-a),
});

impl Ring for Probe {
    fn integer(&self, n: i64) -> Self {
        match self {
            Probe::Degree(a) => Probe::Degree(a.integer(n)),
            Probe::Residue(a) => Probe::Residue(a.integer(n)),
            Probe::Exact(a) => Probe::Exact(a.integer(n)),
        }
    }
}

impl Field for Probe {
    fn rational(&self, q: &Rational) -> Self {
        match self {
            Probe::Degree(a) => Probe::Degree(a.rational(q)),
            Probe::Residue(a) => Probe::Residue(a.rational(q)),
            Probe::Exact(_) => Probe::Exact(q.clone()),
        }
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        Ok(match self {
            Probe::Degree(a) => Probe::Degree(a.recip()?),
            Probe::Residue(a) => Probe::Residue(a.recip()?),
            Probe::Exact(a) => Probe::Exact(Field::recip(a)?),
        })
    }

    fn ratio(&self, p: i64, q: i64) -> Self {
        match self {
            Probe::Residue(a) => Probe::Residue(a.ratio(p, q)),
            _ => self.rational(&super::rational(p, q)),
        }
    }
}

impl Signed for Probe {
    /// Known of exact numbers only: what an identity says must not depend on signs.
    fn sign(&self) -> Option<Sign> {
        self.exact().and_then(Signed::sign)
    }
}

impl Probe {
    /// A new variable for a function of these numbers: equal arguments have equal values, and nothing else is known of the function. An identity
    /// that holds so holds for every function, and so for the one that is meant, wherever it has values.
    fn unknown(&self, function: &str, arguments: &[&Self]) -> Result<Self, ArithmeticError> {
        match self {
            // A variable of at least the degree and the coefficients of the arguments: the bound of the whole then is one of differences of arguments, too.
            Probe::Degree(_) => {
                let mut bound = DegreeBound::VARIABLE;
                for argument in arguments {
                    let Probe::Degree(of) = argument else { continue };
                    bound.numerator = bound.numerator.max(of.numerator.saturating_add(of.denominator));
                    bound.numerator_bits =
                        bound.numerator_bits.max(of.numerator_bits.saturating_add(of.denominator_bits));
                }
                Ok(Probe::Degree(bound))
            }
            Probe::Exact(_) => Err(ArithmeticError::Domain("numbers that are not rational")),
            Probe::Residue(own) => {
                let mut hash = Sha256::new();
                hash.update(function.as_bytes());
                hash.update(own.prime().to_le_bytes());
                for argument in arguments {
                    if let Probe::Residue(residue) = argument {
                        hash.update(residue.value().to_le_bytes());
                    }
                }
                let bytes = hash.finalize();
                let drawn = bytes.iter().take(8).fold(0u64, |sum, byte| sum << 8 | u64::from(*byte));
                Ok(Probe::Residue(Residue::modulo(drawn, own.prime())))
            }
        }
    }

    /// The same for an odd function: arguments that differ by their signs have values that do, and that of 0 is 0.
    fn unknown_odd(&self, function: &str) -> Result<Self, ArithmeticError> {
        let Probe::Residue(own) = self else { return self.unknown(function, &[self]) };
        let turned = -*own;
        match own.value().cmp(&turned.value()) {
            Ordering::Less => self.unknown(function, &[self]),
            Ordering::Equal => Ok(self.clone()),
            Ordering::Greater => {
                let turned = Probe::Residue(turned);
                Ok(-turned.unknown(function, &[&turned])?)
            }
        }
    }

    fn function(
        &self,
        name: &str,
        exact: impl Fn(&Rational) -> Result<Rational, ArithmeticError>,
    ) -> Result<Self, ArithmeticError> {
        match self {
            Probe::Exact(q) => Ok(Probe::Exact(exact(q)?)),
            _ => self.unknown(name, &[self]),
        }
    }
}

impl Number for Probe {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        self.unknown("pi", &[])
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        self.function("sqrt", Number::sqrt)
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        self.function("exp", Number::exp)
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        self.function("log", Number::ln)
    }

    /// A point of the circle, of which nothing else is known.
    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        if let Probe::Exact(q) = self {
            let (sine, cosine) = q.sin_cos()?;
            return Ok((Probe::Exact(sine), Probe::Exact(cosine)));
        }
        let t = self.unknown_odd("angle")?;
        let (one, square) = (t.one(), t.square());
        let below = (one.clone() + &square).recip()?;
        Ok(((t.integer(2) * &t) * &below, (one - &square) * &below))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        match self {
            Probe::Exact(q) => Ok(Probe::Exact(Number::atan(q)?)),
            _ => self.unknown_odd("atan"),
        }
    }

    fn indicator(&self) -> Option<Self> {
        self.unknown("negative", &[self]).ok()
    }

    /// A point of the hyperbola, of which nothing else is known.
    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        if let Probe::Exact(q) = self {
            let (sine, cosine) = q.sinh_cosh()?;
            return Ok((Probe::Exact(sine), Probe::Exact(cosine)));
        }
        let t = self.unknown_odd("rapidity")?;
        let (one, square) = (t.one(), t.square());
        let below = (one.clone() - &square).recip()?;
        Ok(((t.integer(2) * &t) * &below, (one + &square) * &below))
    }

    fn angle(y: &Self, x: &Self) -> Result<Self, ArithmeticError> {
        match (y, x) {
            (Probe::Exact(y), Probe::Exact(x)) => Ok(Probe::Exact(Number::angle(y, x)?)),
            _ => y.unknown("heading", &[y, x]),
        }
    }
}
