//! Where `gain(k, w) <= peak` is attained, and `gain(k, w) < peak` fails: at the frequency of the peak, if the box of frequencies has it inside.

use super::{Division, fails_exactly};
use crate::bindings::Bindings;
use crate::case::Case;
use crate::evaluate::Evaluator;
use crate::outcome::{Decided, Spot};
use crate::point::FIRST_BITS;
use crate::syntax::{Kind, Node, Relation};
use crate::timeline::Measured;
use crate::truth::{Margin, Truth};
use arithmetic::decimal;

impl Division<'_> {
    /// With the frequency of the peak, where a property that holds says that no gain of the last car is above it, and nothing else: there its margin is 0.
    pub(super) fn at_peak(&self, whole: &Bindings, found: Decided) -> Decided {
        let may_be_zero = found.truth == Truth::True && found.margin.lo <= 0.0 && found.margin.hi > 0.0;
        match may_be_zero.then(|| self.peak_of(whole, [Relation::AtMost, Relation::AtLeast])).flatten() {
            Some(at) => Decided { attained: Some(at), margin: Margin { lo: 0.0, hi: 0.0 }, ..found },
            None => found,
        }
    }

    /// What is said where all that is asked is that every gain of the last car is below the peak, which one of them attains; otherwise nothing.
    pub(super) fn fails_at_peak(&self, whole: &Bindings) -> Option<Decided> {
        let at = self.peak_of(whole, [Relation::Less, Relation::Greater])?;
        Some(Decided { boxes: 1, ..fails_exactly(Decided::nothing(), at) })
    }

    /// The frequency of the peak where the property compares the gain at a frequency with it, by the first relation, or the other way round, by the second one;
    /// `where` might leave it out.
    fn peak_of(&self, whole: &Bindings, relations: [Relation; 2]) -> Option<Spot> {
        let place = self.frequency(whole, relations).filter(|_| self.question.restriction.is_none())?;
        Some(Spot::of(whole, &[(place, self.peak_within(whole, place)?)]))
    }

    /// The place of the frequency, the only name that stands for more than one number, in such a property.
    fn frequency(&self, whole: &Bindings, [below, above]: [Relation; 2]) -> Option<usize> {
        let Kind::Relation(first, others) = &self.expression.node.kind else { return None };
        let [(relation, second)] = &others[..] else { return None };
        let (gain, peak) = match *relation {
            own if own == below => (&**first, second),
            own if own == above => (second, &**first),
            _ => return None,
        };
        let named = |node: &Node, expected: &str| matches!(&node.kind, Kind::Name { name, .. } if name == expected);
        let Kind::Name { arguments, .. } = &gain.kind else { return None };
        let [(place, _)] = whole.sides()[..] else { return None };
        let is_frequency =
            arguments.get(1).is_some_and(|own| whole.iter().nth(place).is_some_and(|at| named(own, at.0)));
        if !(named(gain, "gain") && named(peak, "peak") && is_frequency) {
            return None;
        }
        let case = Case::new(self.question, whole.clone(), self.progress);
        let evaluator = Evaluator { case: &case, precision: FIRST_BITS, moment: None, piece: None };
        evaluator.by_definition(gain, Relation::AtMost, peak)?.then_some(place)
    }

    /// The frequency of the peak, where all of its enclosure lies in the side of that place.
    fn peak_within(&self, whole: &Bindings, place: usize) -> Option<String> {
        let case = Case::new(self.question, whole.clone(), self.progress);
        let quantity = case.quantity(None, "peak_frequency").ok()?;
        let Ok(Measured::Number(found)) = case.measure(quantity, None, &[], FIRST_BITS) else { return None };
        let (lo, hi) = found.enclosure(FIRST_BITS).to_rationals();
        let (_, side) = whole.sides().into_iter().find(|own| own.0 == place)?;
        let is_inside = side.contains(&lo) && side.contains(&hi);
        is_inside.then(|| format!("[{}, {}]", decimal(&lo, 12, false), decimal(&hi, 12, true)))
    }
}
