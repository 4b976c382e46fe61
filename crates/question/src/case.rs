//! One case of a question: bound names, and the subjects that they make.

use crate::bindings::{Bindings, Value};
use crate::error::Problem;
use crate::evaluate::{Evaluator, Failure, Measured, quantity_of};
use crate::names::{QUANTITIES, Quantity, Subject};
use crate::number::Number;
use crate::question::Question;
use crate::subject::graph::GraphSubject;
use crate::syntax::Node;
use crate::truth::{Margin, Truth};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// A case with what has been computed of it.
pub(crate) struct Case<'q> {
    pub question: &'q Question,
    pub bindings: Bindings,
    /// Whether this is a box as the question gives it, before it is divided.
    pub is_first: bool,
    graphs: RefCell<BTreeMap<String, Rc<GraphSubject>>>,
}

impl<'q> Case<'q> {
    pub fn new(question: &'q Question, bindings: Bindings, is_first: bool) -> Self {
        Case { question, bindings, is_first, graphs: RefCell::default() }
    }

    /// The quantity of that name, of the subjects of the question.
    pub fn quantity(&self, owner: Option<&str>, name: &str) -> Result<&'static Quantity, Problem> {
        let subjects = self.question.subjects();
        quantity_of(name, subjects).ok_or_else(|| unknown_quantity(owner, name, &self.question.known_names()))
    }

    /// A quantity that does not move, of its subject.
    pub fn measure(
        &self,
        quantity: &'static Quantity,
        owner: Option<&str>,
        arguments: &[Number],
        precision: u32,
    ) -> Result<Measured, Failure> {
        match quantity.subject {
            Subject::Graph => self.graph(quantity, owner)?.measure(quantity.name, arguments, precision),
            _ => Err(Failure::open("this quantity is not measured yet", None)),
        }
    }

    fn graph(&self, quantity: &Quantity, owner: Option<&str>) -> Result<Rc<GraphSubject>, Failure> {
        let graphs = self.bindings.iter().filter_map(|(name, value)| match value {
            Value::Graph(graph) if owner.is_none_or(|owner| owner == name) => Some((name, graph)),
            _ => None,
        });
        let missing = || Problem::NoSubject {
            name: quantity.name.to_string(),
            subject: Subject::Graph.words(),
            missing: Subject::Graph.needs().to_string(),
        };
        let (name, graph) = graphs.into_iter().next().ok_or_else(|| Failure::Refused(0, missing()))?;
        if let Some(known) = self.graphs.borrow().get(name) {
            return Ok(known.clone());
        }
        let subject = Rc::new(GraphSubject::new(graph.clone(), self.question.kind()));
        self.graphs.borrow_mut().insert(name.to_string(), subject.clone());
        Ok(subject)
    }

    /// A property with a time operator.
    pub fn over_time(&self, _evaluator: &Evaluator, _node: &Node) -> Result<(Truth, Margin), Failure> {
        Ok((Truth::unknown("motions are not followed yet", None), Margin::ANY))
    }

    /// A quantity at time 0.
    pub fn initially(&self, _evaluator: &Evaluator, _node: &Node) -> Result<Measured, Failure> {
        Err(Failure::open("motions are not followed yet", None))
    }
}

/// What is wrong with a name that is no quantity of the subjects: another subject's, or none.
pub(crate) fn unknown_quantity(owner: Option<&str>, name: &str, known: &[String]) -> Problem {
    if let Some(quantity) = QUANTITIES.iter().find(|quantity| quantity.name == name) {
        return Problem::NoSubject {
            name: name.to_string(),
            subject: quantity.subject.words(),
            missing: quantity.subject.needs().to_string(),
        };
    }
    let full = owner.map_or(name.to_string(), |owner| format!("{owner}.{name}"));
    Problem::unknown("name", &full, known.iter().map(String::as_str))
}
