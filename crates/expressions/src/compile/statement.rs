//! A property of states as comparisons with zero: each clause has one that is true, at every state for which the property is claimed.

use super::{Compiler, Made, Scope, Value};
use crate::bodies::Bodies;
use crate::evaluate::{Evaluator, Everyone, Hearing};
use crate::law::{LawError, LawText};

use crate::problem::Problem;
use crate::program::{FLOCK, Id, Op, Program};
use crate::syntax::{Node, NodeKind, Relation};
use arithmetic::{ArithmeticError, Number, Rational};
use std::sync::Arc;

/// Clauses, or comparisons in one, beyond which a property is not taken apart.
const MOST: usize = 64;

/// A number that is compared with zero.
#[derive(Debug, Clone)]
pub struct Comparison {
    program: Arc<Program>,
    /// What stood on both sides.
    sides: Arc<Program>,
    lists: Arc<Vec<Vec<Rational>>>,
    /// How it is compared.
    pub relation: Relation,
    /// As it is written, without a `not` around it; of vectors with the component that it is about.
    pub text: Arc<str>,
    /// Whether it stands before `implies`.
    pub is_supposed: bool,
}

impl Comparison {
    /// The number at a state, laid out as that of the law ([`crate::Law::variables`]).
    ///
    /// # Errors
    /// [`ArithmeticError`] where it has no value, or the scalar cannot hold it.
    pub fn value<T: Number>(&self, time: &T, state: &[T], hearing: &dyn Hearing) -> Result<T, ArithmeticError> {
        first(&mut self.evaluator(time), time, state, hearing)
    }

    /// The two numbers of which it is the difference.
    ///
    /// # Errors
    /// [`ArithmeticError`] as [`Self::value`].
    pub fn sides<T: Number>(&self, time: &T, state: &[T], hearing: &dyn Hearing) -> Result<[T; 2], ArithmeticError> {
        let mut evaluator = Evaluator::new(&self.sides, &self.lists, time);
        let numbers = evaluator.flock(time, state, hearing).map_err(|fault| fault.error)?;
        numbers.try_into().map_err(|_| ArithmeticError::Domain("two sides"))
    }

    /// What computes the number again and again.
    pub fn evaluator<T: Number>(&self, like: &T) -> Evaluator<T> {
        Evaluator::new(&self.program, &self.lists, like)
    }

    /// The number, and behind it all that was divided by and that functions were taken of: where those are the same at two states, it has a value at both or at
    /// neither.
    ///
    /// # Errors
    /// [`ArithmeticError`] as [`Self::value`].
    pub fn trail<T: Number>(&self, time: &T, state: &[T], hearing: &dyn Hearing) -> Result<Vec<T>, ArithmeticError> {
        let mut evaluator = self.evaluator(time).trailed();
        let value = first(&mut evaluator, time, state, hearing)?;
        Ok([vec![value], evaluator.into_trail()].concat())
    }

    /// The number where each agent hears each with a weight, row by row: a sum over those whom an agent hears is one of products with the weights.
    ///
    /// # Errors
    /// [`ArithmeticError`] as [`Self::value`], and where something else than sums is made of those whom an agent hears.
    pub fn weighted<T: Number>(&self, time: &T, state: &[T], weights: &[Vec<T>]) -> Result<T, ArithmeticError> {
        first(&mut self.evaluator(time).weighted(weights.concat()), time, state, &Everyone(weights.len()))
    }

    /// How many functions without rational values are computed at most, where sums run over so many agents.
    pub fn functions(&self, agents: usize) -> u64 {
        let each = self.program.functions() as u64;
        each.saturating_mul((agents as u64).saturating_pow(self.program.depth() as u32))
    }

    /// Whether all agents are treated alike: none is named, and no parameter has a value for each.
    pub fn is_symmetric(&self) -> bool {
        self.program.is_symmetric()
    }

    /// Whether the time does not occur.
    pub fn is_autonomous(&self) -> bool {
        self.program.is_autonomous()
    }

    /// How it depends on the number of agents, where that is known: see [`Bodies`].
    pub fn bodies(&self) -> Option<Bodies> {
        self.program.bodies()
    }
}

fn first<T: Number>(
    evaluator: &mut Evaluator<T>,
    time: &T,
    state: &[T],
    hearing: &dyn Hearing,
) -> Result<T, ArithmeticError> {
    let numbers = evaluator.flock(time, state, hearing).map_err(|fault| fault.error)?;
    numbers.into_iter().next().ok_or(ArithmeticError::Domain("a number"))
}

/// Some comparison of each clause is true.
pub type Clauses = Vec<Vec<Comparison>>;

/// A comparison whose numbers are not yet programs.
#[derive(Clone)]
struct Draft {
    difference: Id,
    sides: [Id; 2],
    relation: Relation,
    text: Arc<str>,
    is_supposed: bool,
}

type Drafts = Vec<Vec<Draft>>;

impl LawText {
    /// A property of a flock of so many agents, with `rate(e)` and the observables by their names.
    ///
    /// # Errors
    /// [`LawError`]; its table is `property` where the property is at fault.
    pub fn statement(&self, agents: usize, property: &Node) -> Result<Clauses, LawError> {
        self.stated(agents, property, false)
    }

    /// The same, where the number of agents is kept apart from other numbers ([`Comparison::bodies`]).
    ///
    /// # Errors
    /// As [`Self::statement`].
    pub fn statement_of_any(&self, property: &Node) -> Result<Clauses, LawError> {
        self.stated(2, property, true)
    }

    fn stated(&self, agents: usize, property: &Node, of_any: bool) -> Result<Clauses, LawError> {
        let mut text = self.clone();
        text.define.append(&mut text.observables.clone());
        text.observables.clear();
        let mut compiler = Compiler::new(&text, agents)?;
        compiler.of_any = of_any;
        compiler.list_parameters();
        compiler.reading.push(("property", ""));
        let drafts = compiler.clauses(property, true)?;
        let lists = Arc::new(compiler.lists.clone());
        let comparison = |Draft { difference, sides, relation, text, is_supposed }| Comparison {
            program: Arc::new(compiler.things.program(vec![difference])),
            sides: Arc::new(compiler.things.program(sides.to_vec())),
            lists: lists.clone(),
            relation,
            text,
            is_supposed,
        };
        Ok(drafts.into_iter().map(|clause| clause.into_iter().map(comparison).collect()).collect())
    }
}

impl Compiler<'_> {
    fn clauses(&mut self, node: &Node, positive: bool) -> Made<Drafts> {
        let parts: Vec<(&Node, bool)> = match &node.kind {
            NodeKind::Not(body) => return self.clauses(body, !positive),
            NodeKind::And(nodes) | NodeKind::Or(nodes) => nodes.iter().map(|node| (node, positive)).collect(),
            NodeKind::Implies(first, second) => vec![(first, !positive), (second, positive)],
            NodeKind::Relation(first, others) => return self.chain(first, others, positive),
            _ => {
                let why = "a comparison is expected here, or comparisons joined by `and`, `or`, `not`, `implies`";
                return self.refuse(node.at, Problem::Other(why.to_string()));
            }
        };
        let mut all =
            parts.into_iter().map(|(node, positive)| self.clauses(node, positive)).collect::<Made<Vec<_>>>()?;
        if matches!(node.kind, NodeKind::Implies(..)) {
            all[0].iter_mut().flatten().for_each(|draft| draft.is_supposed = true);
        }
        let together = matches!(node.kind, NodeKind::And(_)) == positive;
        self.joined(node, all, together)
    }

    fn joined(&self, node: &Node, lists: Vec<Drafts>, together: bool) -> Made<Drafts> {
        if together {
            return Ok(lists.concat());
        }
        let mut all: Drafts = vec![Vec::new()];
        for list in lists {
            all = all.iter().flat_map(|a| list.iter().map(move |b| [a.clone(), b.clone()].concat())).collect();
            if all.len() > MOST || all.iter().any(|clause| clause.len() > MOST) {
                return self.refuse(node.at, Problem::Other("the property has too many cases".to_string()));
            }
        }
        Ok(all)
    }

    fn chain(&mut self, first: &Node, others: &[(Relation, Node)], positive: bool) -> Made<Drafts> {
        let scope = Scope { own: None, innermost: FLOCK, hears: None, agents: Vec::new() };
        let (mut left, mut before) = (self.value(first, &scope)?, first);
        let mut all = Vec::new();
        for (relation, node) in others {
            let right = self.value(node, &scope)?;
            let text = format!("{before} {} {node}", relation.sign());
            let relation = if positive { *relation } else { relation.turned() };
            all.push(self.compared(node, left, right.clone(), relation, &text)?);
            (left, before) = (right, node);
        }
        self.joined(first, all, positive)
    }

    /// Numbers are compared; vectors are equal or not, also with 0.
    fn compared(&mut self, node: &Node, left: Value, right: Value, relation: Relation, text: &str) -> Made<Drafts> {
        let is_zero =
            |this: &Self, id: Id| matches!(&this.things.ops[id], Op::Number(q) if *q == arithmetic::rational(0, 1));
        let pairs = match (left, right) {
            (Value::Number(a) | Value::Angle(a), Value::Number(b) | Value::Angle(b)) => vec![(a, b)],
            (Value::Vector(a), Value::Vector(b)) => a.into_iter().zip(b).collect(),
            (Value::Vector(a), Value::Number(b)) if is_zero(self, b) => a.into_iter().map(|a| (a, b)).collect(),
            (first, second) => return self.refuse(node.at, Problem::expected(first.words(), second.words())),
        };
        if pairs.len() > 1 && !matches!(relation, Relation::Equal | Relation::Different) {
            return self.refuse(node.at, Problem::expected("a number", "a vector"));
        }
        let is_alone = pairs.len() == 1;
        let draft = |(k, (a, b)): (usize, (Id, Id))| Draft {
            difference: self.things.add(Op::Difference(a, b)),
            sides: [a, b],
            relation,
            text: if is_alone { text.into() } else { format!("{text}, component {},", k + 1).into() },
            is_supposed: false,
        };
        let numbers: Vec<Draft> = pairs.into_iter().enumerate().map(draft).collect();
        let together = relation == Relation::Equal;
        Ok(if together { numbers.into_iter().map(|one| vec![one]).collect() } else { vec![numbers] })
    }
}
