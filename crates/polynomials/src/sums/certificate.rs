//! Why an inequality holds, in a form that a short separate program checks.

use crate::multivariate::{Multivariate, monomial_product};
use arithmetic::{Rational, rational};
use num_traits::{Signed, Zero};

type Polynomial = Multivariate<Rational>;

/// `d l²`, with `d >= 0`.
pub type Square = (Rational, Polynomial);

/// An inequality in somebody's own names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// How many names it has, in the order of the variables.
    pub variables: usize,
    /// Its text.
    pub text: String,
}

/// Wherever all `constraints` are at least 0 and all `equalities` are 0, the goal is at least 0 (above 0 where `strict`), because
///
/// `(sum of multiplier) goal = sum over terms of (product of the constraints of the term) (sum of its squares) + sum of cofactor equality`.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// What it says in the words of who asked, which the checker reads: `for all x in [0, 1]: x >= x^2`.
    pub statement: Option<Statement>,
    /// At least 0 by assumption.
    pub constraints: Vec<Polynomial>,
    /// 0 by assumption.
    pub equalities: Vec<Polynomial>,
    /// What is at least 0.
    pub goal: Polynomial,
    /// Whether it is above 0.
    pub strict: bool,
    /// Squares with a positive sum: one of them is a constant.
    pub multiplier: Vec<Square>,
    /// Numbers of constraints, from 0, and squares.
    pub terms: Vec<(Vec<usize>, Vec<Square>)>,
    /// One for each equality.
    pub cofactors: Vec<Polynomial>,
}

fn sum(squares: &[Square]) -> Polynomial {
    let products = squares.iter().flat_map(|(d, l)| {
        l.terms().flat_map(move |(a, p)| {
            let scaled = d * p;
            l.terms().map(move |(b, q)| (monomial_product(a, b), &scaled * q))
        })
    });
    Multivariate::from_terms(products, &rational(0, 1))
}

/// Whether a positive constant is among squares that are all not negative.
fn has_constant(squares: &[Square]) -> bool {
    squares.iter().any(|(d, l)| d.is_positive() && l.as_constant().is_some_and(|c| !c.is_zero()))
}

impl Certificate {
    /// Whether it proves what it says. It is looked at before anybody is told.
    pub fn is_valid(&self) -> bool {
        let squares = self.terms.iter().flat_map(|(_, squares)| squares).chain(&self.multiplier);
        let signs = squares.into_iter().all(|(d, _)| !d.is_negative());
        let numbers = self.terms.iter().flat_map(|(factors, _)| factors).all(|&k| k < self.constraints.len());
        if !signs || !numbers || self.cofactors.len() != self.equalities.len() || !has_constant(&self.multiplier) {
            return false;
        }
        let strict = self.terms.iter().any(|(factors, squares)| factors.is_empty() && has_constant(squares));
        if self.strict && !strict {
            return false;
        }
        self.defect().is_zero()
    }

    /// The same with the inequalities `e >= 0` and `-e >= 0` in the place of the last equality: `4 c e = (c + 1)² e - (c - 1)² e`.
    pub(super) fn without_last_equality(mut self) -> Self {
        if let (Some(equality), Some(cofactor)) = (self.equalities.pop(), self.cofactors.pop()) {
            for (sign, own) in [(1, equality.clone()), (-1, -equality)] {
                let root = cofactor.clone() + Multivariate::of(rational(sign, 1));
                if !root.is_zero() {
                    self.terms.push((vec![self.constraints.len()], vec![(rational(1, 4), root)]));
                }
                self.constraints.push(own);
            }
        }
        self
    }

    /// The left side of the identity less its right side, as far as there are cofactors.
    pub(super) fn defect(&self) -> Polynomial {
        let one = Multivariate::of(rational(1, 1));
        let mut rest = sum(&self.multiplier) * &self.goal;
        for (factors, squares) in &self.terms {
            let product = factors.iter().fold(one.clone(), |product, &k| product * &self.constraints[k]);
            rest = rest - product * sum(squares);
        }
        for (cofactor, equality) in self.cofactors.iter().zip(&self.equalities) {
            rest = rest - cofactor.clone() * equality;
        }
        rest
    }
}
