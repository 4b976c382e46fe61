//! What is measured on a motion whose state is known as quotients of polynomials in one number.

use super::at::At;
use crate::names::Quantity;
use crate::number::Number as Known;
use crate::subject::measured::index_of;
use crate::timeline::Curve;
use arithmetic::{Field, Number, Rational, Ring};
use polynomials::{Side, Symbolic};
use scenario::{Amount, ExactMotion, measure};

/// The states at the times of a piece, and the range of the number that they depend on.
pub(super) struct OnCurve<'m, 'c> {
    pub at: At<'m, 'c, Symbolic>,
    pub range: Side,
}

impl Curve for OnCurve<'_, '_> {
    fn range(&self) -> &Side {
        &self.range
    }

    fn number(&self, q: &Rational) -> Option<Symbolic> {
        Some(self.at.state.first()?.rational(q))
    }

    fn measure(&self, quantity: &Quantity, arguments: &[Known]) -> Option<Symbolic> {
        let index = index_of(quantity, arguments).ok()?;
        let view = self.at.view(index)?;
        let like = self.at.state.first()?;
        entry(measure(quantity.name, &view).ok()??, index, like)
    }

    fn own(&self, name: &str) -> Option<Symbolic> {
        let ExactMotion::Own(own) = self.at.motion else { return None };
        own.number(name, &self.at.state)?.ok()
    }
}

/// A number, of a list the entry with that index.
fn entry(amount: Amount<Symbolic>, index: usize, like: &Symbolic) -> Option<Symbolic> {
    match amount {
        Amount::Number(x) => Some(x),
        Amount::Root(x) => x.sqrt().ok(),
        Amount::Count(Some([least, most])) if least == most => Some(like.integer(i64::try_from(least).ok()?)),
        Amount::List(list) => entry(list.into_iter().nth(index - 1)?, index, like),
        Amount::Count(_) | Amount::Unknown(_) => None,
    }
}
