//! A property of the states of one flock: so many agents on one network.

use super::{LawFile, MOST_AGENTS};
use crate::bindings::{Bindings, Value};
use crate::error::{Problem, QuestionError};
use crate::question::{Expression, Question};
use arithmetic::{ArithmeticError, Interval, Number, Rational, Sign, Signed, rational};
use expressions::{Comparison, Hearing, Kind, Parameter, Relation, Time};
use num_traits::ToPrimitive;
use std::sync::Arc;

/// Who hears whom.
#[derive(Debug, Clone)]
pub(super) struct Links {
    agents: usize,
    /// Those whom each agent hears; nothing where that is everybody else.
    lists: Option<Vec<Vec<usize>>>,
}

impl Hearing for Links {
    fn agents(&self) -> usize {
        self.agents
    }

    fn heard(&self, agent: usize) -> Option<&[usize]> {
        self.lists.as_ref().map(|lists| &lists[agent][..])
    }
}

impl Links {
    fn of_arcs(agents: usize, arcs: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut lists = vec![Vec::new(); agents];
        for (i, j) in arcs {
            if i != j && !lists[i].contains(&j) {
                lists[i].push(j);
            }
        }
        lists.iter_mut().for_each(|list| list.sort_unstable());
        Links { agents, lists: Some(lists) }
    }

    /// The network of one pair that hear each other as far as they do here.
    pub fn only(&self, (i, j): (usize, usize)) -> Self {
        let has = |a: usize, b: usize| self.heard(a).is_none_or(|list| list.contains(&b));
        Links::of_arcs(self.agents, [(i, j), (j, i)].into_iter().filter(|&(a, b)| has(a, b)))
    }

    /// Whether all arcs have one back.
    pub fn is_mutual(&self) -> bool {
        let has = |a: usize, b: usize| self.heard(a).is_none_or(|list| list.contains(&b));
        self.pairs().into_iter().all(|(i, j)| has(i, j) && has(j, i))
    }

    /// Pairs of which one at least hears the other.
    pub fn pairs(&self) -> Vec<(usize, usize)> {
        let has = |a: usize, b: usize| self.heard(a).is_none_or(|list| list.contains(&b));
        let all = (0..self.agents).flat_map(|i| (i + 1..self.agents).map(move |j| (i, j)));
        all.filter(|&(i, j)| has(i, j) || has(j, i)).collect()
    }
}

/// What a number of the state ranges over; without ends all reals.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Side {
    Point(Rational),
    Between(Rational, Rational),
    Line,
}

/// A property of the states of one flock.
#[derive(Debug, Clone)]
pub(super) struct Instance {
    pub clauses: Vec<Vec<Comparison>>,
    pub links: Links,
    pub sides: Vec<Side>,
    /// The numbers of the state by their names in a question.
    pub names: Vec<String>,
    /// Numbers of each agent, by their places in the state.
    pub of_agent: Vec<Vec<usize>>,
}

impl Instance {
    pub fn new(
        question: &Question,
        file: &LawFile,
        expression: &Expression,
        bindings: &Bindings,
    ) -> Result<Self, QuestionError> {
        let refuse = |why: String| question.at(question.for_place(), Problem::Other(why));
        let links = links(bindings).map_err(refuse)?;
        let agents = links.agents;
        let mut law = file.law.clone();
        if law.time == Time::Continuous && !law.noise.is_empty() {
            return Err(refuse("laws with noise have no rates that are sure".to_string()));
        }
        for (name, value) in bindings.iter() {
            let parameter = name.strip_prefix("law.parameters.").unwrap_or(name);
            match value {
                Value::Number(q) if name != "agents" && !parameter.contains(['.', '[']) => {
                    law.parameters.retain(|(known, _)| known != parameter);
                    law.parameters.push((parameter.to_string(), Parameter::One(q.clone())));
                }
                Value::Box(..) | Value::Any if !name.contains('[') => {
                    return Err(refuse(format!("`{name}` ranges over an interval; here only numbers of the state do")));
                }
                Value::Integers(..) => return Err(refuse(format!("`{name}` should be one number in each case"))),
                _ => {}
            }
        }
        let refused = |error| file.refused(question, expression, error);
        let compiled = law.compile(agents).map_err(refused)?;
        let clauses = law.statement(agents, &expression.node).map_err(refused)?;
        let mut instance = Instance { clauses, links, sides: Vec::new(), names: Vec::new(), of_agent: Vec::new() };
        instance.sides = vec![Side::Point(rational(0, 1)); compiled.size()];
        instance.names = vec![String::new(); compiled.size()];
        instance.of_agent = vec![Vec::new(); agents];
        for variable in compiled.variables() {
            let range = file.ranges.iter().find(|range| range.part == variable.name);
            for agent in 0..agents {
                for component in 0..variable.width {
                    let place = variable.start + agent * variable.stride + component;
                    let number = format!("{}[{}]", variable.name, agent + 1);
                    let vector = variable.kind == Kind::Vector && variable.width > 1;
                    let name = if vector { format!("{number}.{}", component + 1) } else { number };
                    instance.sides[place] = match (bindings.get(&name), range) {
                        (Some(Value::Number(q)), _) => Side::Point(q.clone()),
                        (Some(Value::Box(lo, hi)), _) => Side::Between(lo.clone(), hi.clone()),
                        (Some(Value::Any), _) => Side::Line,
                        (_, Some(range)) => match &range.ends {
                            Some((lo, hi)) => Side::Between(lo.clone(), hi.clone()),
                            None => Side::Line,
                        },
                        (_, None) => {
                            let why = format!("`{}` is missing in [for]: \"any\", or an interval", variable.name);
                            return Err(refuse(why));
                        }
                    };
                    instance.names[place] = name;
                    instance.of_agent[agent].push(place);
                }
            }
        }
        Ok(instance)
    }

    /// Whether the numbers of all agents range over the same.
    pub fn is_uniform(&self) -> bool {
        let of = |places: &Vec<usize>| places.iter().map(|&place| &self.sides[place]).collect::<Vec<_>>();
        self.of_agent.windows(2).all(|pair| of(&pair[0]) == of(&pair[1]))
    }

    /// The whole state, where nothing is left open.
    pub fn point(&self) -> Option<Vec<Rational>> {
        let number = |side: &Side| match side {
            Side::Point(q) => Some(q.clone()),
            _ => None,
        };
        self.sides.iter().map(number).collect()
    }

    /// Whether a comparison holds at a state: exactly, or by enclosures of growing precision; nothing where it has no value or cannot be told.
    pub fn holds(&self, comparison: &Comparison, state: &[Rational]) -> Option<bool> {
        let zero = rational(0, 1);
        match comparison.value(&zero, state, &self.links) {
            Ok(value) => return value.sign().map(|sign| admits(comparison.relation, sign)),
            Err(ArithmeticError::Domain(_)) => {}
            Err(_) => return None,
        }
        for precision in [128, 512] {
            let enclosed: Vec<Interval> = state.iter().map(|q| Interval::from_rational(q, precision)).collect();
            let time = Interval::from_rational(&zero, precision);
            if let Ok(value) = comparison.value(&time, &enclosed, &self.links)
                && let Some(sign) = value.sign()
            {
                return Some(admits(comparison.relation, sign));
            }
        }
        None
    }

    /// Whether a clause is true at a state.
    pub fn clause_holds(&self, clause: &[Comparison], state: &[Rational]) -> Option<bool> {
        let found: Vec<Option<bool>> = clause.iter().map(|comparison| self.holds(comparison, state)).collect();
        if found.contains(&Some(true)) {
            return Some(true);
        }
        found.iter().all(|one| *one == Some(false)).then_some(false)
    }

    /// The floats of a clause's comparisons, as far as they have values.
    pub fn floats(&self, clause: &[Comparison], state: &[f64]) -> Vec<Option<f64>> {
        clause.iter().map(|one| one.value(&0.0, state, &self.links).ok().filter(|x| x.is_finite())).collect()
    }
}

/// A comparison as a function of a state over any scalar.
pub(super) fn value_of<T: Number>(comparison: &Comparison, links: &Links, state: &[T]) -> Result<T, ArithmeticError> {
    let like = state.first().ok_or(ArithmeticError::Domain("a state"))?;
    comparison.value(&like.zero(), state, links)
}

pub(super) fn admits(relation: Relation, sign: Sign) -> bool {
    match relation {
        Relation::Equal => sign == Sign::Zero,
        Relation::Different => sign != Sign::Zero,
        Relation::Less => sign == Sign::Negative,
        Relation::AtMost => sign != Sign::Positive,
        Relation::Greater => sign == Sign::Positive,
        Relation::AtLeast => sign != Sign::Negative,
    }
}

/// The network of a case: its graph, or everybody with everybody.
fn links(bindings: &Bindings) -> Result<Links, String> {
    let given = match bindings.get("agents") {
        Some(Value::Number(q)) => q.to_usize(),
        _ => None,
    };
    let graph = bindings.iter().find_map(|(_, value)| match value {
        Value::Graph(graph) => Some(Arc::clone(graph)),
        _ => None,
    });
    let links = match (given, graph) {
        (Some(agents), Some(graph)) if graph.order() != agents => {
            return Err(format!("the graph has {} vertices, and there are {agents} agents", graph.order()));
        }
        (_, Some(graph)) => Links::of_arcs(graph.order(), graph.arcs()),
        (Some(agents), None) => Links { agents, lists: None },
        (None, None) => return Err("[for] needs `agents`, or a graph".to_string()),
    };
    match links.agents {
        1..=MOST_AGENTS => Ok(links),
        other => Err(format!("{other} agents: from 1 to {MOST_AGENTS} are looked at")),
    }
}
