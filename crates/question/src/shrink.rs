//! Simpler counterexamples: smaller members of the family first, then simpler numbers.

use crate::bindings::{Bindings, Value, simplest_between};
use crate::error::QuestionError;
use crate::family::Members;
use crate::question::{Expression, Question};
use crate::truth::Truth;
use arithmetic::{Progress, rational};
use num_traits::Signed;

/// Smaller integers that are tried for each name.
const TRIED: u64 = 64;

/// A simpler case in which the property fails, too, confirmed like the first.
pub(crate) fn shrunk(
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
        true => question.decide_point(expression, bindings, progress).map(|(truth, _)| truth == Truth::False),
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
    let Ok(Some(Value::Box(lo, hi))) = question.members(place, &before, progress).map(|members| members.get(0)) else {
        return Ok(found);
    };
    let mut radius = &hi - &lo;
    let reach = current.abs() * rational(1, 1 << 20);
    while radius > reach {
        let from = (current - &radius).max(lo.clone());
        let to = (current + &radius).min(hi.clone());
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
