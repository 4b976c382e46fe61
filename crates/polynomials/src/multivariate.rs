//! Polynomials in several variables over any ring.

use arithmetic::{Rational, Ring, operators, rational};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fmt;

/// Exponents, variable 0 first, without zeros at the end: so polynomials need not agree on how many variables there are.
pub type Monomial = Vec<u32>;

/// A sum of coefficients times monomials; no coefficient is zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Multivariate<T> {
    terms: BTreeMap<Monomial, T>,
    zero: T,
}

/// The product of two monomials.
pub fn monomial_product(a: &[u32], b: &[u32]) -> Monomial {
    let (long, short) = if a.len() >= b.len() { (a, b) } else { (b, a) };
    let mut product = long.to_vec();
    product.iter_mut().zip(short).for_each(|(x, y)| *x += y);
    product
}

/// A monomial divided by another one, which has to divide it.
fn monomial_quotient(a: &[u32], b: &[u32]) -> Option<Monomial> {
    let power = |k: usize| a.get(k).copied().unwrap_or(0).checked_sub(b.get(k).copied().unwrap_or(0));
    (0..a.len().max(b.len())).map(power).collect()
}

/// The order of monomials in which the variable with the greatest number counts most.
fn by_last(a: &[u32], b: &[u32]) -> std::cmp::Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

/// The sum of the exponents.
pub fn total_degree(monomial: &[u32]) -> u32 {
    monomial.iter().sum()
}

fn trimmed(mut monomial: Monomial) -> Monomial {
    while monomial.last() == Some(&0) {
        monomial.pop();
    }
    monomial
}

impl<T: Ring + PartialEq> Multivariate<T> {
    /// A constant.
    pub fn constant(value: T) -> Self {
        let zero = value.zero();
        let mut polynomial = Multivariate { terms: BTreeMap::new(), zero };
        polynomial.add_term(Vec::new(), value);
        polynomial
    }

    /// The variable of that number, from 0, over the ring of `like`.
    pub fn variable(number: usize, like: &T) -> Self {
        let mut monomial = vec![0; number];
        monomial.push(1);
        Multivariate { terms: BTreeMap::from([(monomial, like.one())]), zero: like.zero() }
    }

    /// From monomials with their coefficients; those of equal ones are added. Exponents may end with zeros.
    pub fn from_terms(terms: impl IntoIterator<Item = (Monomial, T)>, like: &T) -> Self {
        let mut polynomial = Multivariate { terms: BTreeMap::new(), zero: like.zero() };
        terms.into_iter().for_each(|(monomial, coefficient)| polynomial.add_term(trimmed(monomial), coefficient));
        polynomial
    }

    fn add_term(&mut self, monomial: Monomial, coefficient: T) {
        if coefficient == self.zero {
            return;
        }
        match self.terms.entry(monomial) {
            Entry::Vacant(place) => drop(place.insert(coefficient)),
            Entry::Occupied(mut place) => {
                let sum = place.get().clone() + &coefficient;
                if sum == self.zero { drop(place.remove()) } else { *place.get_mut() = sum }
            }
        }
    }

    /// The monomials with their coefficients, in order.
    pub fn terms(&self) -> impl ExactSizeIterator<Item = (&Monomial, &T)> {
        self.terms.iter()
    }

    /// Whether it is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value, where there is no variable in it.
    pub fn as_constant(&self) -> Option<T> {
        match self.terms.iter().next() {
            None => Some(self.zero.clone()),
            Some((monomial, value)) if self.terms.len() == 1 && monomial.is_empty() => Some(value.clone()),
            _ => None,
        }
    }

    /// One more than the largest number of a variable in it.
    pub fn arity(&self) -> usize {
        self.terms.keys().map(Vec::len).max().unwrap_or(0)
    }

    /// The largest sum of exponents; 0 for the zero polynomial.
    pub fn degree(&self) -> u32 {
        self.terms.keys().map(|monomial| total_degree(monomial)).max().unwrap_or(0)
    }

    /// The largest exponent of a variable.
    pub fn degree_in(&self, variable: usize) -> u32 {
        self.terms.keys().filter_map(|monomial| monomial.get(variable)).copied().max().unwrap_or(0)
    }

    /// Every coefficient times a number.
    pub fn scaled(&self, by: &T) -> Self {
        let terms = self.terms.iter().map(|(monomial, c)| (monomial.clone(), c.clone() * by));
        Multivariate::from_terms(terms, &self.zero)
    }

    /// The value at a point of the ring, or of anything that holds it: `into` takes coefficients there.
    pub fn at<S: Ring>(&self, point: &[S], like: &S, into: impl Fn(&T) -> S) -> S {
        let term = |(monomial, c): (&Monomial, &T)| {
            let powers = monomial.iter().zip(point).filter(|(exponent, _)| **exponent > 0);
            powers.fold(into(c), |product, (exponent, x)| product * x.power(u64::from(*exponent)))
        };
        self.terms.iter().map(term).fold(like.zero(), |sum, term| sum + term)
    }

    /// Polynomials put in the place of the first variables; those beyond stay.
    pub fn substituted(&self, by: &[Self]) -> Self {
        let like = Multivariate { terms: BTreeMap::new(), zero: self.zero.clone() };
        let arity = self.arity();
        let rest = (by.len()..arity).map(|k| Multivariate::variable(k, &self.zero));
        let all: Vec<Self> = by.iter().cloned().chain(rest).collect();
        self.at(&all, &like, |c| Multivariate::constant(c.clone()))
    }

    /// As a polynomial in one of its variables: the coefficients, the constant one first.
    pub fn in_variable(&self, variable: usize) -> Vec<Self> {
        let mut list = vec![Multivariate::from_terms([], &self.zero); self.degree_in(variable) as usize + 1];
        for (monomial, c) in &self.terms {
            let mut rest = monomial.clone();
            let exponent = rest.get_mut(variable).map_or(0, std::mem::take);
            list[exponent as usize].add_term(trimmed(rest), c.clone());
        }
        list
    }

    fn plus(a: &Self, b: &Self) -> Self {
        let mut sum = a.clone();
        b.terms.iter().for_each(|(monomial, c)| sum.add_term(monomial.clone(), c.clone()));
        sum
    }

    fn minus(a: &Self, b: &Self) -> Self {
        let mut difference = a.clone();
        b.terms.iter().for_each(|(monomial, c)| difference.add_term(monomial.clone(), -c.clone()));
        difference
    }

    fn times(a: &Self, b: &Self) -> Self {
        let mut product = Multivariate { terms: BTreeMap::new(), zero: a.zero.clone() };
        for (first, c) in &a.terms {
            for (second, d) in &b.terms {
                product.add_term(monomial_product(first, second), c.clone() * d);
            }
        }
        product
    }

    fn negated(a: &Self) -> Self {
        let terms = a.terms.iter().map(|(monomial, c)| (monomial.clone(), -c.clone())).collect();
        Multivariate { terms, zero: a.zero.clone() }
    }
}

operators!(
    [T: Ring + PartialEq] Multivariate<T>,
    Multivariate::plus,
    Multivariate::minus,
    Multivariate::times,
    Multivariate::negated
);

impl<T: Ring + PartialEq> Ring for Multivariate<T> {
    fn integer(&self, n: i64) -> Self {
        Multivariate::constant(self.zero.integer(n))
    }
}

impl Multivariate<Rational> {
    /// The variable of that number over the rationals.
    pub fn x(number: usize) -> Self {
        Multivariate::variable(number, &rational(0, 1))
    }

    /// A rational constant.
    pub fn of(value: Rational) -> Self {
        Multivariate::constant(value)
    }

    /// The value at a rational point; variables beyond it are 1, so that there should be none.
    pub fn value(&self, point: &[Rational]) -> Rational {
        self.at(point, &rational(0, 1), Clone::clone)
    }

    /// The quotient by a polynomial other than 0, where there is no remainder.
    pub fn divided_by(&self, divisor: &Self) -> Option<Self> {
        let (lead, c) = divisor.terms.last_key_value()?;
        let (mut left, mut quotient) = (self.clone(), Multivariate::of(rational(0, 1)));
        while let Some((monomial, own)) = left.terms.last_key_value() {
            let term = Multivariate::from_terms([(monomial_quotient(monomial, lead)?, own / c)], &self.zero);
            left = left - divisor.clone() * &term;
            quotient = quotient + term;
        }
        Some(quotient)
    }

    /// What is left when terms that the leading one of another polynomial divides are replaced by its other terms, as long as there are such; the variable with the
    /// greatest number counts most.
    pub(crate) fn remainder(&self, divisor: &Self) -> Self {
        let Some((lead, c)) = divisor.terms.iter().max_by(|a, b| by_last(a.0, b.0)) else { return self.clone() };
        let (mut left, mut rest) = (self.clone(), Multivariate::of(rational(0, 1)));
        while let Some((monomial, own)) = left.terms.iter().max_by(|a, b| by_last(a.0, b.0)) {
            let term = |powers: Monomial, c: Rational| Multivariate::from_terms([(powers, c)], &self.zero);
            match monomial_quotient(monomial, lead) {
                Some(powers) => {
                    let factor = term(powers, own / c);
                    left = left - divisor.clone() * &factor;
                }
                None => {
                    let own = term(monomial.clone(), own.clone());
                    rest = rest + &own;
                    left = left - own;
                }
            }
        }
        rest
    }

    /// As a text with the names of the variables; those without a name are `x1`, `x2`, ..
    pub fn named(&self, names: &[String]) -> String {
        use num_traits::{One, Signed};
        let power = |(k, exponent): (usize, &u32)| {
            let name = names.get(k).cloned().unwrap_or_else(|| format!("x{}", k + 1));
            if *exponent == 1 { name } else { format!("{name}^{exponent}") }
        };
        let mut text = String::new();
        for (monomial, c) in self.terms.iter().rev() {
            let powers: Vec<String> = monomial.iter().enumerate().filter(|(_, e)| **e > 0).map(power).collect();
            let size = c.abs();
            let sign = match (text.is_empty(), c.is_negative()) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            };
            text += sign;
            match (size.is_one(), powers.is_empty()) {
                (true, false) => text += &powers.join("*"),
                (_, true) => text += &size.to_string(),
                (false, false) => text += &format!("{size}*{}", powers.join("*")),
            }
        }
        if text.is_empty() { "0".to_string() } else { text }
    }
}

impl fmt::Display for Multivariate<Rational> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.named(&[]))
    }
}
