//! What the literals of a clause say about single variables: guards narrow the domain, and what follows from an equation is put in the place of a variable.

use super::elimination::Polynomial;
use crate::function::{Compared, Function, Literal, Side};
use crate::multivariate::Multivariate;
use crate::symbolic::Extension;
use arithmetic::{ArithmeticError, Number, Rational, rational};
use num_traits::Signed;

/// A function with polynomials in others in the place of some variables, or such a polynomial itself.
pub(super) struct Put<'a, F> {
    function: Option<&'a F>,
    own: Polynomial,
    equations: &'a [(usize, Polynomial)],
}

impl<F: Function> Function for Put<'_, F> {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let like = at.first().ok_or(ArithmeticError::Domain("a variable"))?;
        let of = |p: &Polynomial, at: &[T]| p.at(at, like, |c| like.rational(c));
        let Some(function) = self.function else { return Ok(of(&self.own, at)) };
        let mut all = at.to_vec();
        for (variable, by) in self.equations {
            all[*variable] = of(by, at);
        }
        function.value(&all)
    }
}

/// The literals that are polynomials in the arguments alone, as they stand.
pub(super) fn polynomials<F: Function>(
    clause: &[Literal<F>],
    arity: usize,
    wanted: impl Fn(Compared) -> bool,
) -> Vec<Option<Polynomial>> {
    let own = |literal: &Literal<F>| {
        if !wanted(literal.compared) {
            return None;
        }
        let extension = Extension::new(arity);
        let value = literal.function.value(&extension.arguments()).ok()?;
        let plain = extension.divisors().is_empty() && extension.meanings().is_empty();
        plain.then(|| value.parts().0)
    };
    clause.iter().map(own).collect()
}

/// `c x + rest` in a variable, with a constant `c` that is not zero.
fn linear_in(p: &Polynomial, variable: usize) -> Option<(Rational, Polynomial)> {
    let mut own = p.terms().filter(|(monomial, _)| monomial.get(variable).is_some_and(|power| *power > 0));
    let ((monomial, lead), None) = (own.next()?, own.next()) else { return None };
    (monomial.iter().sum::<u32>() == 1).then(|| (lead.clone(), p.clone() - Multivariate::x(variable).scaled(lead)))
}

/// The part of the domain on which the clause is not true by a literal in one variable, up to its boundary; `None` where nothing is left.
pub(super) fn narrowed<F: Function>(clause: &[Literal<F>], domain: &[Side]) -> Option<Vec<Side>> {
    let mut sides = domain.to_vec();
    let is_signed = |compared| matches!(compared, Compared::Positive | Compared::NotNegative);
    for p in polynomials(clause, domain.len(), is_signed).into_iter().flatten() {
        for (k, side) in sides.iter_mut().enumerate() {
            let Some((c, rest)) = linear_in(&p, k) else { continue };
            let Some(rest) = rest.as_constant() else { break };
            // What is left has `c x + rest <= 0`.
            let end = -rest / &c;
            if c.is_positive() {
                side.hi = Some(side.hi.take().map_or(end.clone(), |hi| hi.min(end)));
            } else {
                side.lo = Some(side.lo.take().map_or(end.clone(), |lo| lo.max(end)));
            }
        }
    }
    let sides: Vec<Side> = sides.into_iter().map(Side::rounded).collect();
    (!sides.iter().any(Side::is_empty)).then_some(sides)
}

/// Variables with the polynomials in those that are left, which they are wherever the literals `p != 0` of these numbers are false.
pub(super) fn equations<F: Function>(clause: &[Literal<F>], domain: &[Side]) -> (Vec<(usize, Polynomial)>, Vec<usize>) {
    let arity = domain.len();
    let (mut found, mut used): (Vec<(usize, Polynomial)>, _) = (Vec::new(), Vec::new());
    for (number, p) in polynomials(clause, arity, |compared| compared == Compared::NotZero).into_iter().enumerate() {
        let Some(mut p) = p else { continue };
        let put = |p: &Polynomial, variable: usize, by: &Polynomial| {
            let places: Vec<Polynomial> =
                (0..arity).map(|k| if k == variable { by.clone() } else { Multivariate::x(k) }).collect();
            p.substituted(&places)
        };
        for (variable, by) in &found {
            p = put(&p, *variable, by);
        }
        let Some((variable, (lead, rest))) =
            (0..arity).rev().filter(|&k| !domain[k].integer).find_map(|k| Some((k, linear_in(&p, k)?)))
        else {
            continue;
        };
        let by = -rest.scaled(&lead.recip());
        for (_, before) in &mut found {
            *before = put(before, variable, &by);
        }
        found.push((variable, by));
        used.push(number);
    }
    (found, used)
}

/// The clause without these variables: with the equations put in, without the literals `used` that say them, and with one literal for each end of a variable that
/// they replace.
pub(super) fn reduced<'a, F: Function>(
    clause: &'a [Literal<F>],
    domain: &[Side],
    equations: &'a [(usize, Polynomial)],
    used: &[usize],
) -> (Vec<Literal<Put<'a, F>>>, Vec<Side>) {
    let none = || Multivariate::of(rational(0, 1));
    let put = |literal: &'a Literal<F>| Literal {
        function: Put { function: Some(&literal.function), own: none(), equations },
        compared: literal.compared,
        guarded: literal.guarded,
    };
    let left = clause.iter().enumerate().filter(|(number, _)| !used.contains(number));
    let mut literals: Vec<_> = left.map(|(_, literal)| put(literal)).collect();
    let mut sides = domain.to_vec();
    for (variable, by) in equations {
        let side = std::mem::replace(&mut sides[*variable], Side::point(rational(0, 1)));
        let outside =
            [side.lo.map(|lo| Multivariate::of(lo) - by.clone()), side.hi.map(|hi| by.clone() - Multivariate::of(hi))];
        literals.extend(outside.into_iter().flatten().map(|own| Literal {
            function: Put { function: None, own, equations },
            compared: Compared::Positive,
            guarded: false,
        }));
    }
    (literals, sides)
}

/// A point with the variables that were replaced.
pub(super) fn restored(point: &[Rational], equations: &[(usize, Polynomial)]) -> Vec<Rational> {
    let mut all = point.to_vec();
    for (variable, by) in equations {
        all[*variable] = by.value(point);
    }
    all
}
