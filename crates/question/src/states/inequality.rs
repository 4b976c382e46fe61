//! Inequalities on domains of states: decided where they are attained, as those of numbers are.

use super::How;
use super::instance::{Instance, Links, Side, value_of};
use arithmetic::{ArithmeticError, Cancelled, Number, Progress, rational};
use expressions::{Comparison, Relation};
use polynomials::decide::{Decision, Effort, decide};
use polynomials::{Compared, Function, Literal};

/// A comparison of a law as a function of the state, turned round where it should be below 0.
struct Stated<'a> {
    comparison: &'a Comparison,
    links: &'a Links,
    turned: bool,
    arity: usize,
}

impl Function for Stated<'_> {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let value = value_of(self.comparison, self.links, at)?;
        Ok(if self.turned { -value } else { value })
    }
}

/// Decides whether some comparison of a clause is true whatever the numbers in these places are; the others, on which nothing depends, are 0 where they may be
/// anything.
pub(super) fn decided(
    instance: &Instance,
    clause: &[Comparison],
    links: &Links,
    places: &[usize],
    progress: &dyn Progress,
) -> Result<Decision, Cancelled> {
    let side = |(place, side): (usize, &Side)| match side {
        Side::Point(q) => polynomials::Side::point(q.clone()),
        _ if !places.contains(&place) => polynomials::Side::point(rational(0, 1)),
        Side::Between(lo, hi) => polynomials::Side::between(lo.clone(), hi.clone()),
        Side::Line => polynomials::Side::line(),
    };
    let domain: Vec<polynomials::Side> = instance.sides.iter().enumerate().map(side).collect();
    // A comparison without a value is not true.
    let literals = clause.iter().map(|comparison| {
        let (compared, turned) = match comparison.relation {
            Relation::Equal => (Compared::Zero, false),
            Relation::Different => (Compared::NotZero, false),
            Relation::Less => (Compared::Positive, true),
            Relation::AtMost => (Compared::NotNegative, true),
            Relation::Greater => (Compared::Positive, false),
            Relation::AtLeast => (Compared::NotNegative, false),
        };
        let function = Stated { comparison, links, turned, arity: domain.len() };
        Literal { function, compared, guarded: false }
    });
    let clause: Vec<Literal<Stated>> = literals.collect();
    decide(&clause, &domain, Effort::default(), progress)
}

/// How a clause was proved in this way; nothing where it was not.
pub(super) fn holds(
    instance: &Instance,
    clause: &[Comparison],
    links: &Links,
    places: &[usize],
    progress: &dyn Progress,
) -> Result<Option<Vec<How>>, Cancelled> {
    Ok(match decided(instance, clause, links, places, progress)? {
        Decision::Holds(proof) => Some(proof.methods.into_iter().map(|method| How::Decided(method.words())).collect()),
        _ => None,
    })
}
