//! Inequalities on all states, by the decision about functions on a domain: enclosures, derivatives where they are attained, sums of squares.

use super::How;
use super::identity::is_invariant;
use super::instance::{Instance, Links, filled, value_of};
use arithmetic::{ArithmeticError, Cancelled, Number, Progress, Rational, rational};
use expressions::{Comparison, Relation};
use polynomials::decide::{Decision, Effort, decide};
use polynomials::sums::Certificate;
use polynomials::{Compared, Function, Literal, Side};

/// Boxes that are looked at: fewer where there are so many numbers that boxes help little.
const MOST_BOXES: u64 = 20_000;
const FEW_BOXES: u64 = 1_000;
const MANY_NUMBERS: usize = 6;

/// A comparison of a clause as a function of the numbers of a state that are free.
struct OnStates<'a> {
    comparison: &'a Comparison,
    links: &'a Links,
    sides: &'a [Side],
    free: &'a [usize],
    /// Whether it is negative where the comparison is true.
    turned: bool,
}

impl Function for OnStates<'_> {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        if at.is_empty() {
            return Err(ArithmeticError::Domain("a number"));
        }
        let value = value_of(self.comparison, self.links, &filled(self.sides, self.free, at))?;
        Ok(if self.turned { -value } else { value })
    }
}

/// What was found about a clause on all states.
pub(super) enum Found {
    Holds(Vec<How>, Vec<Certificate>),
    /// It may be false at this state.
    Fails(Vec<Rational>),
    Open(String),
}

/// Whether some comparison of a clause holds whatever the numbers in these places are, wherever all have values; the others, on which nothing depends, are 0
/// where they may be anything.
pub(super) fn on_states(
    instance: &Instance,
    clause: &[Comparison],
    links: &Links,
    places: &[usize],
    progress: &dyn Progress,
) -> Result<Found, Cancelled> {
    let nothing = Side::point(rational(0, 1));
    let mut sides = instance.sides.clone();
    let last = sides.len() - 1;
    let others = sides.iter_mut().enumerate().filter(|(place, _)| *place != last && !places.contains(place));
    others.filter(|(_, side)| side.contains(&rational(0, 1))).for_each(|(_, side)| *side = nothing.clone());
    let mut how = Vec::new();
    // Where nothing depends on where all are together, one of them may be at 0.
    for column in &instance.columns {
        if !column.iter().all(|&place| instance.sides[place] == Side::line()) {
            continue;
        }
        let Some(&first) = column.iter().find(|place| places.contains(place)) else { continue };
        let bits: Option<Vec<u64>> =
            clause.iter().map(|comparison| is_invariant(instance, comparison, links, column)).collect();
        if let Some(bits) = bits {
            how.extend(bits.into_iter().map(How::Identity));
            how.push(How::Moved);
            sides[first] = nothing.clone();
        }
    }
    let free: Vec<usize> = (0..sides.len()).filter(|&place| sides[place].as_point().is_none()).collect();
    let literals: Vec<Literal<OnStates>> = clause
        .iter()
        .map(|comparison| {
            let (turned, compared) = match comparison.relation {
                Relation::Less => (true, Compared::Positive),
                Relation::AtMost => (true, Compared::NotNegative),
                Relation::Greater => (false, Compared::Positive),
                Relation::AtLeast => (false, Compared::NotNegative),
                Relation::Equal => (false, Compared::Zero),
                Relation::Different => (false, Compared::NotZero),
            };
            let function = OnStates { comparison, links, sides: &sides, free: &free, turned };
            Literal { function, compared, guarded: true }
        })
        .collect();
    let domain: Vec<Side> = free.iter().map(|&place| sides[place].clone()).collect();
    let boxes = if free.len() > MANY_NUMBERS { FEW_BOXES } else { MOST_BOXES };
    Ok(match decide(&literals, &domain, Effort { boxes, ..Effort::default() }, progress)? {
        Decision::Holds(proof) => {
            how.extend(proof.methods.iter().map(|method| How::Decided(method.words())));
            Found::Holds(how, proof.certificates)
        }
        Decision::Fails(at) => Found::Fails(filled_points(&sides, &free, &at)),
        Decision::FailsAt(places) => {
            let list: Vec<String> = places.iter().map(ToString::to_string).collect();
            Found::Open(format!("it fails where the numbers left are {}", list.join(", ")))
        }
        Decision::Undecided(open) => Found::Open(open.why),
    })
}

fn filled_points(sides: &[Side], free: &[usize], at: &[Rational]) -> Vec<Rational> {
    match at.first() {
        Some(_) => filled(sides, free, at),
        None => sides.iter().map(Side::middle).collect(),
    }
}
