//! Simpler counterexamples: smaller members of the family first, then simpler numbers, then a shorter time.

use crate::bindings::{Bindings, Value};
use crate::case::Case;
use crate::domain::Members;
use crate::error::QuestionError;
use crate::evaluate::Evaluator;
use crate::question::{Expression, Question};
use crate::syntax::{Kind, Node};
use crate::truth::Truth;
use arithmetic::RealNumber as Number;
use arithmetic::{Progress, Rational, rational, simplest_between};
use motion::sets::Range;
use num_traits::Signed;

/// Smaller integers that are tried for each name.
const TRIED: u64 = 64;

/// A simpler case in which the property fails, too, confirmed like the first.
fn shrunk(
    question: &Question,
    expression: &Expression,
    found: &Bindings,
    progress: &dyn Progress,
) -> Result<Bindings, QuestionError> {
    let mut best = found.clone();
    // Families without samples are gone through in order, so that their first counterexample is the smallest already.
    if question.is_sample() {
        for place in 0..question.bounds.len() {
            best = smaller_member(question, expression, best, place, progress)?;
        }
    }
    for place in 0..question.bounds.len() {
        best = simpler_number(question, expression, best, place, progress)?;
    }
    Ok(best)
}

fn fails(
    question: &Question,
    expression: &Expression,
    bindings: &Bindings,
    progress: &dyn Progress,
) -> Result<bool, QuestionError> {
    // Where a smaller case makes no sense it is no counterexample.
    let judged = question.is_kept(bindings, progress).and_then(|kept| match kept {
        true => question.decide_point(expression, bindings, progress).map(|found| found.truth == Truth::False),
        false => Ok(false),
    });
    match judged {
        Err(QuestionError::Cancelled(cancelled)) => Err(QuestionError::Cancelled(cancelled)),
        Err(_) => Ok(false),
        Ok(fails) => Ok(fails),
    }
}

/// The smallest value of an integer name for which the property still fails; later names are made again.
fn smaller_member(
    question: &Question,
    expression: &Expression,
    found: Bindings,
    place: usize,
    progress: &dyn Progress,
) -> Result<Bindings, QuestionError> {
    let Some((_, Value::Number(current))) = found.iter().nth(place) else { return Ok(found) };
    let before = found.first(place);
    let Ok(members) = question.members(place, &before, progress) else { return Ok(found) };
    if !matches!(members.as_ref(), Members::Integers(..)) {
        return Ok(found);
    }
    for k in 0..members.len().min(TRIED) {
        let Some(Value::Number(value)) = members.get(k).filter(|v| matches!(v, Value::Number(q) if q < current)) else {
            break;
        };
        let mut tried = before.clone();
        tried.push(question.bounds[place].name.clone(), Value::Number(value));
        for later in place + 1..question.bounds.len() {
            // Names that do not depend on this one keep their value.
            let kept = found.iter().nth(later).map(|(_, value)| value.clone());
            let first =
                question.members(later, &tried, progress).ok().and_then(|members| match (&kept, members.as_ref()) {
                    (Some(Value::Number(q)), Members::Integers(..)) => (0..members.len().min(1 << 16))
                        .filter_map(|k| members.get(k))
                        .find(|v| matches!(v, Value::Number(p) if p == q)),
                    _ => members.get(0),
                });
            let Some(value) = first else { break };
            tried.push(question.bounds[later].name.clone(), value);
        }
        if tried.iter().count() == question.bounds.len() && fails(question, expression, &tried, progress)? {
            return Ok(tried);
        }
    }
    Ok(found)
}

/// The simplest number of an interval for which the property still fails.
fn simpler_number(
    question: &Question,
    expression: &Expression,
    found: Bindings,
    place: usize,
    progress: &dyn Progress,
) -> Result<Bindings, QuestionError> {
    let before = found.first(place);
    let Some((_, Value::Number(current))) = found.iter().nth(place) else { return Ok(found) };
    let first = question.members(place, &before, progress).map(|members| members.get(0)).ok().flatten();
    if let Some(Value::Integers(from, _)) = first {
        return smaller_integer(question, expression, &found, place, (from, current), progress);
    }
    let ends = match first {
        Some(Value::Any) => Some(Range { lo: -current.abs() - rational(1, 1), hi: current.abs() + rational(1, 1) }),
        other => other.and_then(|value| value.ends()),
    };
    let Some(Range { lo, hi }) = ends else { return Ok(found) };
    let mut radius = &hi - &lo;
    let reach = current.abs() * rational(1, 1 << 20);
    while radius > reach {
        let from = (current - &radius).max(lo.clone());
        let to = (current + &radius).min(hi.clone());
        // Around an integer that is an integer again.
        let simple = simplest_between(&from, &to);
        let mut tried = found.clone();
        tried.set(place, Value::Number(simple.clone()));
        if simple == *current {
            break;
        }
        if fails(question, expression, &tried, progress)? {
            return Ok(tried);
        }
        radius *= rational(1, 2);
    }
    Ok(found)
}

/// An integer of a range from `from` on for which the property still fails, and does not for the one before: the smallest where it fails for
/// all later ones.
fn smaller_integer(
    question: &Question,
    expression: &Expression,
    found: &Bindings,
    place: usize,
    (from, failing): (i64, &Rational),
    progress: &dyn Progress,
) -> Result<Bindings, QuestionError> {
    // The property fails at `high`, and is taken to hold below the range.
    let (mut low, mut high) = (rational(from - 1, 1), failing.clone());
    let with = |value: &Rational| {
        let mut tried = found.clone();
        tried.set(place, Value::Number(value.clone()));
        tried
    };
    while &high - &low > rational(1, 1) {
        let middle = ((&low + &high) * rational(1, 2)).floor();
        if fails(question, expression, &with(&middle), progress)? { high = middle } else { low = middle }
    }
    Ok(with(&high))
}

/// A simpler case in which a property fails, and a weaker property of shorter times that fails there already.
#[derive(Debug, Clone)]
pub(crate) struct Shrunk {
    pub bindings: Bindings,
    pub property: Expression,
}

impl Shrunk {
    /// Makes a counterexample simpler in every way.
    pub fn of(
        question: &Question,
        property: &Expression,
        found: &Bindings,
        progress: &dyn Progress,
    ) -> Result<Self, QuestionError> {
        let bindings = shrunk(question, property, found, progress)?;
        let property = shorter_times(question, property, &bindings, progress)?;
        Ok(Shrunk { bindings, property })
    }
}

/// Halvings of a time.
const HALVINGS: usize = 8;

/// Longest time that is tried in place of one without end.
const LONGEST: i64 = 1 << 10;

/// The property with the ends of its times made smaller, as long as it fails. Only ends are changed that make it weaker, so that the
/// property as it was fails with it: of `always`, and of `eventually` and `until` under a negation.
pub(crate) fn shorter_times(
    question: &Question,
    property: &Expression,
    at: &Bindings,
    progress: &dyn Progress,
) -> Result<Expression, QuestionError> {
    let mut best = property.clone();
    let mut places = Vec::new();
    ends(&mut best.node, true, &mut places);
    for place in 0..places.len() {
        let Some((from, to)) = span(question, &best, place, at, progress) else { continue };
        let with = |end: &Rational| {
            let mut tried = best.clone();
            let mut places = Vec::new();
            ends(&mut tried.node, true, &mut places);
            if let Some((_, to)) = places.get_mut(place) {
                to.kind = Kind::Number(end.clone());
            }
            tried
        };
        let fails_by = |end: &Rational| fails(question, &with(end), at, progress);
        let (mut low, mut high) = (from.clone(), to.clone());
        // A time without end: the first power of two that is long enough.
        if high.is_none() {
            let mut end = rational(1, 1);
            while end < rational(LONGEST, 1) && !(end >= from && fails_by(&end)?) {
                end *= rational(2, 1);
            }
            high = (end >= from && fails_by(&end)?).then_some(end);
        }
        let Some(mut high) = high else { continue };
        for _ in 0..HALVINGS {
            let (middle, part) = ((&low + &high) * rational(1, 2), (&high - &low) * rational(1, 8));
            let tried = simplest_between(&(&middle - &part), &(middle + part));
            if tried <= low || tried >= high {
                break;
            }
            if fails_by(&tried)? { high = tried } else { low = tried }
        }
        if to.is_none_or(|to| high < to) {
            best = with(&high);
        }
    }
    Ok(best)
}

/// The bounds of a time operator, the last one `None` without end.
fn span(
    question: &Question,
    property: &Expression,
    place: usize,
    at: &Bindings,
    progress: &dyn Progress,
) -> Option<(Rational, Option<Rational>)> {
    let mut copy = property.clone();
    let mut places = Vec::new();
    ends(&mut copy.node, true, &mut places);
    let (from, to) = places.into_iter().nth(place)?;
    let case = Case::new(question, at.clone(), progress);
    let evaluator = Evaluator { case: &case, precision: 64, moment: None, piece: None };
    let exact = |node: &Node| match evaluator.number(node) {
        Ok(Number::Exact(q)) => Some(q),
        _ => None,
    };
    let end = if matches!(to.kind, Kind::Infinity) { None } else { Some(exact(to)?) };
    Some((exact(from)?, end))
}

/// The bounds of the time operators whose shortening makes the property weaker.
fn ends<'n>(node: &'n mut Node, positive: bool, found: &mut Vec<(&'n Node, &'n mut Node)>) {
    match &mut node.kind {
        Kind::Not(body) => ends(body, !positive, found),
        Kind::And(list) | Kind::Or(list) => list.iter_mut().for_each(|node| ends(node, positive, found)),
        Kind::Implies(first, second) => {
            ends(first, !positive, found);
            ends(second, positive, found);
        }
        Kind::Always(always, parts) => {
            let [from, to, body] = parts.as_mut();
            if *always == positive {
                found.push((from, to));
            }
            ends(body, positive, found);
        }
        Kind::Until(parts) => {
            let [from, to, first, second] = parts.as_mut();
            if !positive {
                found.push((from, to));
            }
            ends(first, positive, found);
            ends(second, positive, found);
        }
        _ => {}
    }
}
