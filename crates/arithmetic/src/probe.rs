//! The scalar of an identity test: three arithmetics behind one type, so that an identity is compiled once.

use super::operators::operators;
use super::residue::Residue;
use super::{ArithmeticError, DegreeBound, Field, Rational, Ring};

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
