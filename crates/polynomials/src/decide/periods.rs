//! Numbers that stand in sines and cosines only: what is true over one period is true everywhere.

use crate::function::{Function, Literal, Side};
use crate::symbolic::{Extension, Symbolic};
use arithmetic::rational;

/// The domain, where that is smaller, with one period of each number of which all literals are periodic functions; a little more, since periods are no rational numbers.
pub(super) fn narrowed<F: Function>(clause: &[Literal<F>], domain: &[Side]) -> Option<Vec<Side>> {
    let is_wide = |side: &Side| {
        let short = rational(6, 1);
        !side.integer && side.lo.as_ref().zip(side.hi.as_ref()).is_none_or(|(lo, hi)| hi - lo > short)
    };
    if !domain.iter().any(is_wide) {
        return None;
    }
    let extension = Extension::new(domain.len());
    let arguments = extension.arguments();
    let values: Option<Vec<Symbolic>> = clause.iter().map(|own| own.function.value(&arguments).ok()).collect();
    let values = values?;
    let mut sides = domain.to_vec();
    let mut is_new = false;
    for (k, side) in sides.iter_mut().enumerate().filter(|(_, side)| is_wide(side)) {
        let Some(period) = extension.period(&values, k) else { continue };
        let whole = match (&side.lo, &side.hi) {
            (None, None) => Side::between(-(&period / rational(2, 1)), period / rational(2, 1)),
            (Some(lo), _) => Side::between(lo.clone(), lo + period),
            (None, Some(hi)) => Side::between(hi - period, hi.clone()),
        };
        let length = |side: &Side| Some(side.hi.as_ref()? - side.lo.as_ref()?);
        if length(side).is_none_or(|own| Some(own) > length(&whole)) {
            (*side, is_new) = (whole, true);
        }
    }
    is_new.then_some(sides)
}
