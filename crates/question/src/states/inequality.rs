//! Inequalities on boxes of states: enclosures, and halves of boxes where these are too wide. What is attained is not decided so.

use super::How;
use super::instance::{Instance, Links, Side, value_of};
use arithmetic::{Cancelled, Enclosure, FloatInterval, Progress, Rational, rational};
use expressions::{Comparison, Relation};
use num_traits::ToPrimitive;

/// Boxes that are looked at.
const MOST_BOXES: usize = 4000;

/// Whether some comparison of a clause holds whatever the numbers in these places are; the others, on which nothing depends, are 0 where they may be
/// anything.
pub(super) fn holds_on_boxes(
    instance: &Instance,
    clause: &[Comparison],
    links: &Links,
    places: &[usize],
    progress: &dyn Progress,
) -> Result<Option<Vec<How>>, Cancelled> {
    let ends = |place: usize| match &instance.sides[place] {
        Side::Point(q) => Some((q.clone(), q.clone())),
        _ if !places.contains(&place) => Some((rational(0, 1), rational(0, 1))),
        Side::Between(lo, hi) => Some((lo.clone(), hi.clone())),
        Side::Line => None,
    };
    let Some(first) = (0..instance.sides.len()).map(ends).collect::<Option<Vec<_>>>() else { return Ok(None) };
    let mut open = vec![first];
    let mut looked = 0;
    while let Some(sides) = open.pop() {
        progress.checkpoint()?;
        looked += 1;
        if looked > MOST_BOXES {
            return Ok(None);
        }
        if clause.iter().any(|comparison| holds(comparison, links, &sides)) {
            continue;
        }
        let Some([low, high]) = halves(&sides) else { return Ok(None) };
        open.extend([high, low]);
    }
    Ok(Some(vec![How::Decided("enclosures")]))
}

type Sides = Vec<(Rational, Rational)>;

fn holds(comparison: &Comparison, links: &Links, sides: &Sides) -> bool {
    let enclosed =
        |(lo, hi): &(Rational, Rational)| FloatInterval::from_rational(lo).hull(&FloatInterval::from_rational(hi));
    let state: Vec<FloatInterval> = sides.iter().map(enclosed).collect();
    value_of(comparison, links, &state).is_ok_and(|value| match comparison.relation {
        Relation::Less => value.upper() < 0.0,
        Relation::AtMost => value.upper() <= 0.0,
        Relation::Greater => value.lower() > 0.0,
        Relation::AtLeast => value.lower() >= 0.0,
        Relation::Equal => value.lower() == 0.0 && value.upper() == 0.0,
        Relation::Different => value.lower() > 0.0 || value.upper() < 0.0,
    })
}

/// The two halves along the longest side; nothing of a single point.
fn halves(sides: &Sides) -> Option<[Sides; 2]> {
    let length = |(lo, hi): &(Rational, Rational)| (hi - lo).to_f64().unwrap_or(f64::INFINITY);
    let longest = (0..sides.len()).max_by(|a, b| length(&sides[*a]).total_cmp(&length(&sides[*b])).then(b.cmp(a)))?;
    let (lo, hi) = sides[longest].clone();
    if lo == hi {
        return None;
    }
    let middle = (&lo + &hi) * rational(1, 2);
    let with = |ends: (Rational, Rational)| {
        let mut half = sides.clone();
        half[longest] = ends;
        half
    };
    Some([with((lo, middle.clone())), with((middle, hi))])
}
