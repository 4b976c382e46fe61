//! Functions written as formulas, for the tests.

use arithmetic::{ArithmeticError, Number, Rational, Unwatched, rational};
use polynomials::decide::{Decision, Effort, decide};
use polynomials::{Compared, Function, Literal, Side};
use std::ops::{Add, Div, Mul, Neg, Sub};

#[derive(Debug, Clone)]
pub enum Tree {
    Constant(Rational),
    Variable(usize),
    Sum(Box<Tree>, Box<Tree>),
    Product(Box<Tree>, Box<Tree>),
    Quotient(Box<Tree>, Box<Tree>),
    Power(Box<Tree>, u64),
    Call(&'static str, Box<Tree>),
    Larger(Box<Tree>, Box<Tree>),
}

pub fn x() -> Tree {
    Tree::Variable(0)
}

pub fn y() -> Tree {
    Tree::Variable(1)
}

pub fn z() -> Tree {
    Tree::Variable(2)
}

pub fn c(p: i64, q: i64) -> Tree {
    Tree::Constant(rational(p, q))
}

/// So many times ten to minus nine.
pub fn nano(p: i64) -> Tree {
    c(p, 1_000_000_000)
}

impl Tree {
    pub fn to(self, exponent: u64) -> Tree {
        Tree::Power(Box::new(self), exponent)
    }

    pub fn call(self, name: &'static str) -> Tree {
        Tree::Call(name, Box::new(self))
    }

    pub fn root(self) -> Tree {
        self.call("sqrt")
    }

    pub fn abs(self) -> Tree {
        self.call("abs")
    }

    pub fn max(self, other: Tree) -> Tree {
        Tree::Larger(Box::new(self), Box::new(other))
    }

    pub fn min(self, other: Tree) -> Tree {
        -(-self).max(-other)
    }

    pub fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let like = at.first().ok_or(ArithmeticError::Domain("a variable"))?;
        Ok(match self {
            Tree::Constant(q) => like.rational(q),
            Tree::Variable(k) => at[*k].clone(),
            Tree::Sum(a, b) => a.value(at)? + b.value(at)?,
            Tree::Product(a, b) => a.value(at)? * b.value(at)?,
            Tree::Quotient(a, b) => a.value(at)?.over(&b.value(at)?)?,
            Tree::Power(a, k) => a.value(at)?.power(*k),
            Tree::Call("sqrt", a) => a.value(at)?.sqrt()?,
            Tree::Call("cbrt", a) => a.value(at)?.root(3)?,
            Tree::Call("exp", a) => a.value(at)?.exp()?,
            Tree::Call("log", a) => a.value(at)?.ln()?,
            Tree::Call("sin", a) => a.value(at)?.sin()?,
            Tree::Call("cos", a) => a.value(at)?.cos()?,
            Tree::Call(_, a) => a.value(at)?.absolute()?,
            Tree::Larger(a, b) => a.value(at)?.larger(&b.value(at)?)?,
        })
    }
}

impl Add for Tree {
    type Output = Tree;
    fn add(self, other: Tree) -> Tree {
        Tree::Sum(Box::new(self), Box::new(other))
    }
}

impl Sub for Tree {
    type Output = Tree;
    fn sub(self, other: Tree) -> Tree {
        self + -other
    }
}

impl Mul for Tree {
    type Output = Tree;
    fn mul(self, other: Tree) -> Tree {
        Tree::Product(Box::new(self), Box::new(other))
    }
}

impl Div for Tree {
    type Output = Tree;
    fn div(self, other: Tree) -> Tree {
        Tree::Quotient(Box::new(self), Box::new(other))
    }
}

impl Neg for Tree {
    type Output = Tree;
    fn neg(self) -> Tree {
        c(-1, 1) * self
    }
}

/// A tree as a function of so many arguments.
#[derive(Debug, Clone)]
pub struct Of(pub Tree);

impl Function for Of {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        self.0.value(at)
    }
}

/// What is said of a term: at least 0, above 0, and so on.
pub type Said = (Tree, Compared);

pub fn at_least(a: Tree, b: Tree) -> Said {
    (a - b, Compared::NotNegative)
}

pub fn above(a: Tree, b: Tree) -> Said {
    (a - b, Compared::Positive)
}

pub fn other_than(a: Tree, b: Tree) -> Said {
    (a - b, Compared::NotZero)
}

pub fn equal(a: Tree, b: Tree) -> Said {
    (a - b, Compared::Zero)
}

/// From one integer to another one, for each variable.
pub fn sides(ends: &[(i64, i64)]) -> Vec<Side> {
    ends.iter().map(|(lo, hi)| Side::between(rational(*lo, 1), rational(*hi, 1))).collect()
}

/// All reals, for each variable.
pub fn lines(count: usize) -> Vec<Side> {
    vec![Side::line(); count]
}

/// Decides a clause; where functions have no value it counts as true.
pub fn decided(clause: Vec<Said>, domain: &[Side], effort: Effort) -> Decision {
    let literal = |(tree, compared)| Literal { function: Of(tree), compared, guarded: true };
    let clause: Vec<_> = clause.into_iter().map(literal).collect();
    decide(&clause, domain, effort, &Unwatched).expect("nobody stops it")
}
