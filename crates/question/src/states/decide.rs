//! The decision about the states of one flock.

use super::every::Sizes;
use super::inequality::{self, on_states};
use super::instance::Instance;
use super::search::{self, Tried};
use super::{How, LawFile, identity, pairs};
use crate::bindings::{Bindings, Value};
use crate::decisive::Decisive;
use crate::error::QuestionError;
use crate::outcome::Decided;
use crate::question::{Expression, Question};
use crate::truth::{Margin, Truth};
use arithmetic::{Cancelled, Progress, Rational};
use expressions::{Comparison, Relation};
use polynomials::sums::Certificate;
use std::sync::Arc;

/// Decides a property of all states of a flock, or of flocks of every size.
pub(crate) fn decide(
    question: &Question,
    file: &LawFile,
    expression: &Expression,
    bindings: &Bindings,
    progress: &dyn Progress,
) -> Result<Decided, QuestionError> {
    if let Some(network) = file.every {
        let clauses = file.law.statement_of_any(&expression.node);
        let clauses = clauses.map_err(|error| file.refused(question, expression, error))?.len();
        let sizes = Sizes::new(question, file, expression, bindings, network);
        return together(question, file, expression, (0..clauses).map(|clause| sizes.clause_holds(clause, progress)));
    }
    let instance = Instance::new(question, file, expression, bindings)?;
    let found = instance.clauses.iter().map(|clause| {
        let found = clause_holds(&instance, clause, progress)?;
        let named = match &found {
            Found::Fails(state) => Some(with_state(bindings, &instance, state)),
            _ => None,
        };
        Ok((found, named))
    });
    together(question, file, expression, found)
}

/// What makes a property false at one state, which the names give.
pub(crate) fn decisive(
    question: &Question,
    file: &LawFile,
    expression: &Expression,
    at: &Bindings,
) -> Result<Option<Decisive>, QuestionError> {
    Ok(Instance::new(question, file, expression, at)?.decisive())
}

/// All clauses.
fn together(
    question: &Question,
    file: &LawFile,
    expression: &Expression,
    clauses: impl Iterator<Item = Result<(Found, Option<Bindings>), QuestionError>>,
) -> Result<Decided, QuestionError> {
    let (mut how, mut certificates) = (Vec::new(), Vec::new());
    let mut truth = Truth::True;
    for found in clauses {
        match found? {
            (Found::Holds(ways, own), _) => {
                how.extend(ways);
                certificates.extend(own);
            }
            (Found::Fails(_), counterexample) => {
                let margin = Margin::of_truth(false);
                return Ok(Decided { truth: Truth::False, margin, boxes: 1, counterexample, ..Decided::nothing() });
            }
            (Found::Open(why), _) => truth = Truth::unknown(why, None),
            (Found::NoValue, _) => truth = Truth::unknown(NO_VALUE, None),
        }
    }
    let open = u64::from(truth != Truth::True);
    if open == 0 && question.property.as_ref().is_some_and(|property| property.base == expression.base) {
        file.note(how);
    }
    let margin = if open == 0 { Margin::of_truth(true) } else { Margin::ANY };
    Ok(Decided { truth, margin, boxes: 1, open, certificates, ..Decided::nothing() })
}

/// What was found about a clause.
#[derive(Debug)]
pub(super) enum Found {
    Holds(Vec<How>, Vec<Certificate>),
    Fails(Vec<Rational>),
    Open(String),
    /// At none of the states that were tried there is a value: what holds wherever it has one says nothing.
    NoValue,
}

const NO_VALUE: &str = "law and property have no value at any of the states that were tried";

pub(super) fn clause_holds(
    instance: &Instance,
    clause: &[Comparison],
    progress: &dyn Progress,
) -> Result<Found, Cancelled> {
    if let Some(state) = instance.point() {
        return Ok(match instance.clause_holds(clause, &state) {
            Some(true) => Found::Holds(vec![How::Point], Vec::new()),
            Some(false) => Found::Fails(state),
            None => Found::Open("a number has no value at the state, or its sign cannot be told".to_string()),
        });
    }
    for comparison in clause {
        progress.checkpoint()?;
        let may_vanish = matches!(comparison.relation, Relation::Equal | Relation::AtMost | Relation::AtLeast);
        if may_vanish && let Some(bits) = identity::vanishes(instance, comparison) {
            return Ok(Found::Holds(vec![How::Identity(bits)], Vec::new()));
        }
    }
    match search::counterexample(instance, clause, search::TRIED, progress)? {
        Tried::False(state) => return Ok(Found::Fails(state)),
        Tried::NoValue => return Ok(Found::NoValue),
        Tried::Nothing => {}
    }
    for comparison in clause {
        let may_vanish = matches!(comparison.relation, Relation::AtMost | Relation::AtLeast);
        if may_vanish && let Some((ways, certificates)) = pairs::holds(instance, comparison, progress)? {
            return Ok(Found::Holds(ways, certificates));
        }
    }
    let all: Vec<usize> = (0..instance.sides.len()).collect();
    Ok(match on_states(instance, clause, &instance.links, &all, progress)? {
        inequality::Found::Holds(ways, certificates) => Found::Holds(ways, certificates),
        inequality::Found::Fails(state) => match instance.clause_holds(clause, &state) {
            Some(false) => Found::Fails(state),
            _ => Found::Open("the two sides may be equal somewhere".to_string()),
        },
        inequality::Found::Open(why) => Found::Open(format!(
            "no counterexample was found, and no identity and no sum over pairs of terms of one sign; {why}"
        )),
    })
}

/// The names of a case with every number of a state.
pub(super) fn with_state(bindings: &Bindings, instance: &Instance, state: &[Rational]) -> Bindings {
    let mut all = Bindings::default();
    for (name, value) in bindings.iter().filter(|(name, _)| !instance.names.iter().any(|own| own == name)) {
        all.push(Arc::from(name), value.clone());
    }
    for (name, number) in instance.names.iter().zip(state).filter(|(name, _)| !name.is_empty()) {
        all.push(Arc::from(name.as_str()), Value::Number(number.clone()));
    }
    all
}
