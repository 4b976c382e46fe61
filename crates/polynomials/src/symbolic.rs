//! Functions themselves as a scalar: quotients of polynomials in the arguments and in new variables for roots, absolute values, sines and exponentials.

mod functions;
mod value;

use crate::multivariate::Multivariate;
use arithmetic::{ArithmeticError, Field, Rational, Ring, Sign, Signed, operators, rational};
use num_traits::{Signed as _, Zero};
use std::sync::{Arc, Mutex, PoisonError};

pub(crate) use value::Part;
pub use value::Settled;

type Polynomial = Multivariate<Rational>;

/// A function whose values have variables of their own; the sine stands after the cosine of the same argument.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Function {
    Cosine,
    Exponential,
    /// Of the absolute value of a polynomial, which is no product.
    Logarithm,
    /// The root of this degree.
    Root(u64),
    Other(&'static str),
}

/// What a new variable stands for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Meaning {
    /// One over a polynomial, where quotients are not brought to a common denominator.
    Reciprocal(Polynomial),
    /// The square root of the quotient of two polynomials.
    Root(Polynomial, Polynomial),
    /// The absolute value of the quotient of two polynomials.
    Absolute(Polynomial, Polynomial),
    /// The cosine of an argument; the next variable is the sine.
    Cosine,
    /// The sine of the same argument.
    Sine,
    /// A positive number of which nothing else is known.
    Positive,
    /// A number of which nothing is known.
    Any,
    /// A number between two.
    Between(Rational, Rational),
}

#[derive(Debug, Default)]
struct Inner {
    divisors: Vec<Polynomial>,
    meanings: Vec<Meaning>,
    /// Functions of arguments that have a variable already.
    calls: Vec<(Function, Fraction, usize)>,
    /// What logarithms were taken of: above 0 wherever there is a value.
    positive: Vec<Polynomial>,
    /// The least common multiple of the denominators in arguments of exponentials and sines, as far as it is small.
    finest: i64,
    /// Polynomials that are 0.
    relations: Vec<Polynomial>,
    /// What functions were asked of, as it stood, where that is wanted.
    heard: Option<Vec<Fraction>>,
    /// Arguments that are not negative.
    not_negative: Vec<usize>,
}

/// Where the new variables of one computation are kept.
#[derive(Debug, Clone)]
pub struct Extension {
    arity: usize,
    /// Arguments of exponentials and sines are multiples of terms with this denominator, where it is one of theirs.
    grid: i64,
    /// Whether what is divided by has a variable of its own.
    splits: bool,
    inner: Arc<Mutex<Inner>>,
}

/// Numerator, and powers of the divisors of the extension.
type Fraction = (Polynomial, Vec<u32>);

/// A function as a quotient of polynomials.
#[derive(Debug, Clone)]
pub struct Symbolic {
    fraction: Fraction,
    extension: Extension,
}

/// Larger polynomials are not worth while.
const MOST_TERMS: usize = 4000;

/// Relations are put in so often, at most: they may bring squares with them.
const MOST_ROUNDS: usize = 8;

impl Extension {
    /// For functions of so many arguments.
    pub fn new(arity: usize) -> Self {
        Extension::with_grid(arity, 1)
    }

    /// The same, where `exp(x)` is a power of `exp(x/grid)`.
    pub(crate) fn with_grid(arity: usize, grid: i64) -> Self {
        Extension { arity, grid, splits: false, inner: Arc::default() }
    }

    /// For functions of so many arguments with many different denominators, whose reciprocals are variables of their own: a common denominator would be
    /// larger than they are.
    pub fn of_many_denominators(arity: usize) -> Self {
        Extension { splits: true, ..Extension::new(arity) }
    }

    /// The same, where what functions are asked of is kept as it stands.
    pub(crate) fn listening(arity: usize) -> Self {
        let extension = Extension::new(arity);
        extension.with(|inner| inner.heard = Some(Vec::new()));
        extension
    }

    /// These arguments are not negative.
    pub(crate) fn are_not_negative(&self, arguments: Vec<usize>) {
        self.with(|inner| inner.not_negative = arguments);
    }

    /// What functions were asked of.
    pub(crate) fn heard(&self) -> Vec<Symbolic> {
        let heard = self.with(|inner| inner.heard.clone()).unwrap_or_default();
        heard.into_iter().map(|fraction| Symbolic { fraction, extension: self.clone() }).collect()
    }

    /// The grid on which all arguments of exponentials and sines so far are integer multiples, as far as it is small.
    pub(crate) fn finest(&self) -> i64 {
        self.with(|inner| inner.finest.max(1))
    }

    /// One.
    pub(crate) fn unit(&self) -> Symbolic {
        self.of(Multivariate::of(rational(1, 1)))
    }

    /// The arguments.
    pub fn arguments(&self) -> Vec<Symbolic> {
        (0..self.arity).map(|k| self.of(Multivariate::x(k))).collect()
    }

    /// Arguments with the degrees of roots of products in which they stand.
    pub(crate) fn degrees_of_roots(&self) -> Vec<(usize, u64)> {
        let calls = self.with(|inner| inner.calls.clone());
        let called = calls.into_iter().filter_map(|(function, argument, _)| match function {
            Function::Root(degree) => Some((argument, degree)),
            _ => None,
        });
        let roots = self.meanings().into_iter().filter_map(|meaning| match meaning {
            Meaning::Root(over, under) if under.as_constant().is_some() => Some(((over, Vec::new()), 2)),
            _ => None,
        });
        let all = called.chain(roots).collect::<Vec<_>>().into_iter();
        let powers = |(fraction, degree)| {
            let powers = Symbolic { fraction, extension: self.clone() }.as_powers().map_or_else(Vec::new, |own| own.1);
            powers.into_iter().filter(|(k, _)| *k < self.arity).map(move |(k, _)| (k, degree))
        };
        all.flat_map(powers).collect()
    }

    /// The arguments of which logarithms, or roots of a higher degree than 2, were taken.
    pub(crate) fn inside_logarithms(&self) -> Vec<usize> {
        let calls = self.with(|inner| inner.calls.clone());
        let wanted = calls.into_iter().filter(|call| matches!(call.0, Function::Logarithm | Function::Root(_)));
        wanted.flat_map(|(_, fraction, _)| Symbolic { fraction, extension: self.clone() }.depends_on()).collect()
    }

    fn of(&self, polynomial: Polynomial) -> Symbolic {
        Symbolic { fraction: (polynomial, Vec::new()), extension: self.clone() }
    }

    fn with<R>(&self, f: impl FnOnce(&mut Inner) -> R) -> R {
        f(&mut self.inner.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// The meanings of the variables beyond the arguments, in order.
    pub(crate) fn meanings(&self) -> Vec<Meaning> {
        self.with(|inner| inner.meanings.clone())
    }

    /// All that was divided by.
    pub(crate) fn divisors(&self) -> Vec<Polynomial> {
        self.with(|inner| inner.divisors.clone())
    }

    fn variable(&self, meaning: Meaning) -> usize {
        self.with(|inner| {
            inner.meanings.push(meaning);
            self.arity + inner.meanings.len() - 1
        })
    }

    /// The variable for a root or an absolute value.
    fn known(&self, meaning: Meaning) -> usize {
        let found = self.with(|inner| inner.meanings.iter().position(|own| *own == meaning));
        found.map_or_else(|| self.variable(meaning), |place| self.arity + place)
    }

    /// Whether it is pi, which is the only number between two.
    fn is_circle(&self, monomial: &[u32]) -> bool {
        let [.., 1] = monomial else { return false };
        let place = (monomial.len() - 1).checked_sub(self.arity);
        let alone = monomial.iter().sum::<u32>() == 1;
        let is_between = |k: usize| self.with(|inner| matches!(inner.meanings.get(k), Some(Meaning::Between(..))));
        alone && place.is_some_and(is_between)
    }

    /// Whether it is pi, or what a logarithm was taken of as it stands.
    fn is_known_positive(&self, polynomial: &Polynomial) -> bool {
        let is_circle = |(monomial, c): (&Vec<u32>, &Rational)| self.is_circle(monomial) && c.is_positive();
        self.with(|inner| inner.positive.contains(polynomial))
            || polynomial.terms().len() == 1 && polynomial.terms().all(is_circle)
    }

    /// The product of powers of divisors.
    fn product(&self, powers: &[u32]) -> Polynomial {
        let one = Multivariate::of(rational(1, 1));
        self.with(|inner| {
            let factor = |(k, power): (usize, &u32)| inner.divisors[k].power(u64::from(*power));
            powers.iter().enumerate().filter(|(_, power)| **power > 0).fold(one, |product, own| product * factor(own))
        })
    }

    /// What is known to be 0 is left out, and squares of variables whose square is known are replaced.
    fn normal(&self, fraction: Fraction) -> Fraction {
        let (mut numerator, mut powers) = self.without_exponentials(self.without_squares(fraction));
        let relations = self.with(|inner| inner.relations.clone());
        if relations.is_empty() {
            return (numerator, powers);
        }
        for _ in 0..MOST_ROUNDS {
            let rest = relations.iter().fold(numerator.clone(), |rest, relation| rest.remainder(relation));
            if rest == numerator {
                break;
            }
            (numerator, powers) = self.without_exponentials(self.without_squares((rest, powers)));
        }
        (numerator, powers)
    }

    /// An exponential, which is never 0, is left out where it divides both.
    fn without_exponentials(&self, (mut numerator, mut powers): Fraction) -> Fraction {
        for (k, power) in powers.iter_mut().enumerate().filter(|(_, power)| **power > 0) {
            let exponential = self.with(|inner| {
                let divisor = &inner.divisors[k];
                let place = divisor.arity().checked_sub(self.arity + 1)?;
                let is_one = inner.meanings.get(place) == Some(&Meaning::Positive)
                    && *divisor == Multivariate::x(self.arity + place);
                is_one.then(|| divisor.clone())
            });
            let Some(exponential) = exponential else { continue };
            while *power > 0
                && let Some(divided) = numerator.divided_by(&exponential)
            {
                (numerator, *power) = (divided, *power - 1);
            }
        }
        (numerator, powers)
    }

    fn without_squares(&self, (mut numerator, mut powers): Fraction) -> Fraction {
        let meanings = self.meanings();
        for (place, meaning) in meanings.iter().enumerate().rev() {
            let variable = self.arity + place;
            if numerator.degree_in(variable) < 2 {
                continue;
            }
            let (over, under) = match meaning {
                Meaning::Root(over, under) => (over.clone(), under.clone()),
                Meaning::Absolute(over, under) => (over.square(), under.square()),
                Meaning::Sine => {
                    let cosine = Multivariate::x(variable - 1);
                    (Multivariate::of(rational(1, 1)) - cosine.square(), Multivariate::of(rational(1, 1)))
                }
                _ => continue,
            };
            let parts = numerator.in_variable(variable);
            let most = (parts.len() - 1) as u64 / 2;
            let x = Multivariate::x(variable);
            let part = |(k, part): (usize, &Polynomial)| {
                let half = k as u64 / 2;
                let even = part.clone() * over.power(half) * under.power(most - half);
                if k % 2 == 1 { even * &x } else { even }
            };
            numerator = parts.iter().enumerate().map(part).fold(Multivariate::of(rational(0, 1)), |sum, own| sum + own);
            if under.as_constant().is_none() {
                let place = self.divisor(&under);
                powers.resize(powers.len().max(place + 1), 0);
                powers[place] += most as u32;
            }
        }
        (numerator, powers)
    }

    /// The number of a divisor.
    fn divisor(&self, polynomial: &Polynomial) -> usize {
        self.with(|inner| {
            inner.divisors.iter().position(|own| own == polynomial).unwrap_or_else(|| {
                inner.divisors.push(polynomial.clone());
                inner.divisors.len() - 1
            })
        })
    }
}

impl Symbolic {
    /// Numerator and denominator as a list of divisors with their powers.
    pub(crate) fn parts(&self) -> (Polynomial, Vec<(Polynomial, u32)>) {
        let divisors = self.extension.divisors();
        let powers = self.fraction.1.iter().enumerate().filter(|(_, power)| **power > 0);
        (self.fraction.0.clone(), powers.map(|(k, power)| (divisors[k].clone(), *power)).collect())
    }

    fn made(&self, fraction: Fraction) -> Self {
        Symbolic { fraction: self.extension.normal(fraction), extension: self.extension.clone() }
    }

    fn raised(&self, powers: &[u32]) -> Polynomial {
        let missing: Vec<u32> =
            powers.iter().enumerate().map(|(k, power)| power - self.fraction.1.get(k).unwrap_or(&0)).collect();
        self.fraction.0.clone() * self.extension.product(&missing)
    }

    fn plus(a: &Self, b: &Self) -> Self {
        let (p, q) = (&a.fraction.1, &b.fraction.1);
        let powers: Vec<u32> = (0..p.len().max(q.len()))
            .map(|k| p.get(k).copied().unwrap_or(0).max(q.get(k).copied().unwrap_or(0)))
            .collect();
        a.made((a.raised(&powers) + b.raised(&powers), powers))
    }

    fn negated(a: &Self) -> Self {
        a.made((-a.fraction.0.clone(), a.fraction.1.clone()))
    }

    fn minus(a: &Self, b: &Self) -> Self {
        Symbolic::plus(a, &Symbolic::negated(b))
    }

    fn times(a: &Self, b: &Self) -> Self {
        let powers = crate::multivariate::monomial_product(&a.fraction.1, &b.fraction.1);
        if a.fraction.0.terms().len() * b.fraction.0.terms().len() > MOST_TERMS * 8 {
            // Too large to be of use: a new variable of which nothing is known.
            let variable = a.extension.variable(Meaning::Any);
            return a.extension.of(Multivariate::x(variable));
        }
        a.made((a.fraction.0.clone() * &b.fraction.0, powers))
    }

    /// A number of which nothing is known so far.
    pub(crate) fn unknown(&self) -> Self {
        self.extension.of(Multivariate::x(self.extension.variable(Meaning::Any)))
    }

    /// From now on it is known to be 0.
    pub(crate) fn is_zero_from_now(&self) {
        if self.fraction.0.as_constant().is_none() {
            self.extension.with(|inner| inner.relations.push(self.fraction.0.clone()));
        }
    }

    /// A function is asked of it.
    fn heard(&self) -> &Self {
        self.extension.with(|inner| {
            if let Some(heard) = inner.heard.as_mut().filter(|heard| !heard.contains(&self.fraction)) {
                heard.push(self.fraction.clone());
            }
        });
        self
    }

    /// Its coefficients of the arguments, and its constant, where it is an affine function of them.
    pub fn affine(&self) -> Option<(Vec<Rational>, Rational)> {
        if self.fraction.1.iter().any(|power| *power > 0) {
            return None;
        }
        let (mut slopes, mut constant) = (vec![rational(0, 1); self.extension.arity], rational(0, 1));
        for (monomial, c) in self.fraction.0.terms() {
            match monomial.iter().sum() {
                0u32 => constant = c.clone(),
                1 => slopes.get_mut(monomial.iter().position(|power| *power == 1)?)?.clone_from(c),
                _ => return None,
            }
        }
        Some((slopes, constant))
    }

    /// Its absolute value.
    pub fn size(&self) -> Self {
        self.heard();
        if let Some(c) = self.as_constant() {
            return self.rational(&c.abs());
        }
        if self.is_not_negative() {
            return self.clone();
        }
        let meaning = Meaning::Absolute(self.fraction.0.clone(), self.denominator());
        self.extension.of(Multivariate::x(self.extension.known(meaning)))
    }

    /// Without its constant term, where it is not divided by anything, and not one of the arguments.
    pub(crate) fn without_constant(&self) -> Option<Self> {
        let whole = self.fraction.1.iter().all(|power| *power == 0);
        let terms = self.fraction.0.terms().filter(|(monomial, _)| !monomial.is_empty());
        let rest = Multivariate::from_terms(terms.map(|(monomial, c)| (monomial.clone(), c.clone())), &rational(0, 1));
        let is_simple = rest.terms().len() == 1 && rest.degree() == 1;
        (whole && !is_simple && !rest.is_zero()).then(|| self.extension.of(rest))
    }

    /// Whether two functions differ by a rational factor.
    pub(crate) fn is_multiple_of(&self, other: &Self) -> bool {
        let lead = |own: &Self| own.fraction.0.terms().next().map(|(_, c)| c.clone());
        let (Some(a), Some(b)) = (lead(self), lead(other)) else { return false };
        self.fraction.0.scaled(&a.recip()) == other.fraction.0.scaled(&b.recip())
    }

    /// Whether it is a positive multiple of a quotient of products of arguments that are not negative.
    fn is_not_negative(&self) -> bool {
        let Some((c, powers)) = self.as_powers() else { return false };
        let known = self.extension.with(|inner| inner.not_negative.clone());
        c.is_positive() && !known.is_empty() && powers.iter().all(|(k, _)| known.contains(k))
    }

    /// As a multiple of a product of powers of variables.
    fn as_powers(&self) -> Option<(Rational, Vec<(usize, i64)>)> {
        let mut terms = self.fraction.0.terms();
        let (Some((monomial, c)), None) = (terms.next(), terms.next()) else { return None };
        let over = monomial.iter().enumerate().filter(|(_, power)| **power > 0);
        let mut powers: Vec<(usize, i64)> = over.map(|(k, power)| (k, i64::from(*power))).collect();
        for (divisor, power) in self.parts().1 {
            let (monomial, _) = divisor.terms().next().filter(|_| divisor.terms().len() == 1)?;
            if monomial.iter().sum::<u32>() != 1 {
                return None;
            }
            powers.push((monomial.len() - 1, -i64::from(power)));
        }
        Some((c.clone(), powers))
    }

    /// The larger of two functions, or the smaller one, by the absolute value of their difference.
    pub fn extreme(&self, other: &Self, larger: bool) -> Self {
        let apart = (self.clone() - other).size();
        (self.clone() + other + if larger { apart } else { -apart }) * self.ratio(1, 2)
    }

    /// The rational number that it is wherever it has a value.
    pub(crate) fn as_constant(&self) -> Option<Rational> {
        self.fraction.0.as_constant().filter(|c| c.is_zero() || self.fraction.1.iter().all(|power| *power == 0))
    }

    /// A multiple of products of roots of numbers other than 0, with its square.
    fn constant_root(&self) -> Option<(Polynomial, Rational)> {
        let root = &self.fraction.0;
        let mut terms = root.terms();
        let (monomial, _) = terms.next().filter(|_| root.terms().len() == 1)?;
        let meanings = self.extension.meanings();
        let is_root = |k: usize| {
            let meaning = k.checked_sub(self.extension.arity).and_then(|place| meanings.get(place));
            matches!(meaning, Some(Meaning::Root(over, under)) if over.as_constant().is_some() && under.as_constant().is_some())
        };
        let all = monomial.iter().enumerate().all(|(k, power)| *power == 0 || is_root(k));
        let square = self.extension.normal((root.square(), Vec::new())).0;
        square.as_constant().filter(|square| all && !square.is_zero()).map(|square| (root.clone(), square))
    }

    fn denominator(&self) -> Polynomial {
        self.extension.product(&self.fraction.1)
    }
}

operators!([] Symbolic, Symbolic::plus, Symbolic::minus, Symbolic::times, Symbolic::negated);

impl Ring for Symbolic {
    fn integer(&self, n: i64) -> Self {
        self.extension.of(Multivariate::of(rational(n, 1)))
    }
}

impl Field for Symbolic {
    fn rational(&self, q: &Rational) -> Self {
        self.extension.of(Multivariate::of(q.clone()))
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        let (numerator, denominator) = (&self.fraction.0, self.denominator());
        if numerator.is_zero() {
            return Err(ArithmeticError::DivisionByZero);
        }
        if let Some(c) = numerator.as_constant() {
            return Ok(self.made((denominator.scaled(&c.recip()), Vec::new())));
        }
        if let Some((root, square)) = self.constant_root() {
            return Ok(self.made((denominator, Vec::new())) * self.made((root.scaled(&square.recip()), Vec::new())));
        }
        // One term: each variable divides by itself. Others are scaled, so that the first coefficient is 1.
        let lead = numerator.terms().next().map_or(rational(1, 1), |(_, c)| c.clone());
        if self.extension.splits {
            let reciprocal = self.extension.known(Meaning::Reciprocal(numerator.scaled(&lead.recip())));
            return Ok(self.extension.of(Multivariate::x(reciprocal).scaled(&lead.recip()) * &denominator));
        }
        let factors: Vec<(Polynomial, u32)> = match numerator.terms().next() {
            Some((monomial, _)) if numerator.terms().len() == 1 => monomial
                .iter()
                .enumerate()
                .filter(|(_, power)| **power > 0)
                .map(|(k, power)| (Multivariate::x(k), *power))
                .collect(),
            _ => vec![(numerator.scaled(&lead.recip()), 1)],
        };
        let mut powers = Vec::new();
        for (factor, power) in factors {
            let place = self.extension.divisor(&factor);
            powers.resize(powers.len().max(place + 1), 0);
            powers[place] += power;
        }
        Ok(self.made((denominator.scaled(&lead.recip()), powers)))
    }
}

impl Signed for Symbolic {
    fn sign(&self) -> Option<Sign> {
        Signed::sign(&self.as_constant()?)
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
