//! The decision about the states of one flock.

use super::instance::Instance;
use super::{How, LawFile, identity, inequality, pairs, search};
use crate::bindings::{Bindings, Value};
use crate::error::QuestionError;
use crate::outcome::Decided;
use crate::question::{Expression, Question};
use crate::truth::{Margin, Truth};
use arithmetic::{Cancelled, Progress, Rational};
use expressions::{Comparison, Relation};
use polynomials::decide::Decision;
use std::sync::Arc;

/// Decides a property of all states of a flock.
pub(crate) fn decide(
    question: &Question,
    file: &LawFile,
    expression: &Expression,
    bindings: &Bindings,
    progress: &dyn Progress,
) -> Result<Decided, QuestionError> {
    let instance = Instance::new(question, file, expression, bindings)?;
    let mut how = Vec::new();
    let mut truth = Truth::True;
    for clause in &instance.clauses {
        match clause_holds(&instance, clause, progress)? {
            Found::Holds(ways) => how.extend(ways),
            Found::Fails(state) => {
                let counterexample = Some(with_state(bindings, &instance, &state));
                let margin = Margin::of_truth(false);
                return Ok(Decided { truth: Truth::False, margin, boxes: 1, counterexample, ..Decided::nothing() });
            }
            Found::Open(why) => truth = Truth::unknown(why, None),
        }
    }
    let open = u64::from(truth != Truth::True);
    if open == 0 && question.property.as_ref().is_some_and(|property| property.base == expression.base) {
        file.note(how);
    }
    let margin = if open == 0 { Margin::of_truth(true) } else { Margin::ANY };
    Ok(Decided { truth, margin, boxes: 1, open, ..Decided::nothing() })
}

enum Found {
    Holds(Vec<How>),
    Fails(Vec<Rational>),
    Open(String),
}

fn clause_holds(instance: &Instance, clause: &[Comparison], progress: &dyn Progress) -> Result<Found, Cancelled> {
    if let Some(state) = instance.point() {
        return Ok(match instance.clause_holds(clause, &state) {
            Some(true) => Found::Holds(vec![How::Point]),
            Some(false) => Found::Fails(state),
            None => Found::Open("a number has no value at the state, or its sign cannot be told".to_string()),
        });
    }
    if let Some(state) = search::counterexample(instance, clause, progress)? {
        return Ok(Found::Fails(state));
    }
    for comparison in clause {
        progress.checkpoint()?;
        let may_vanish = matches!(comparison.relation, Relation::Equal | Relation::AtMost | Relation::AtLeast);
        if may_vanish && let Some(bits) = identity::vanishes(instance, comparison) {
            return Ok(Found::Holds(vec![How::Identity(bits)]));
        }
    }
    let all: Vec<usize> = (0..instance.sides.len()).collect();
    match inequality::decided(instance, clause, &instance.links, &all, progress)? {
        Decision::Holds(proof) => {
            return Ok(Found::Holds(proof.methods.into_iter().map(|method| How::Decided(method.words())).collect()));
        }
        Decision::Fails(state) if instance.clause_holds(clause, &state) == Some(false) => {
            return Ok(Found::Fails(state));
        }
        _ => {}
    }
    for comparison in clause {
        let may_vanish = matches!(comparison.relation, Relation::AtMost | Relation::AtLeast);
        if may_vanish && let Some(ways) = pairs::holds(instance, comparison, progress)? {
            return Ok(Found::Holds(ways));
        }
    }
    let texts =
        "no counterexample was found, and no identity, enclosure, sum of squares or sum over pairs that proves it";
    Ok(Found::Open(texts.to_string()))
}

/// The names of a case with every number of a state.
fn with_state(bindings: &Bindings, instance: &Instance, state: &[Rational]) -> Bindings {
    let mut all = Bindings::default();
    for (name, value) in bindings.iter().filter(|(name, _)| !instance.names.iter().any(|own| own == name)) {
        all.push(Arc::from(name), value.clone());
    }
    for (name, number) in instance.names.iter().zip(state).filter(|(name, _)| !name.is_empty()) {
        all.push(Arc::from(name.as_str()), Value::Number(number.clone()));
    }
    all
}
