//! A property of the states of one flock: so many agents on one network.

use super::{LawFile, MOST_AGENTS};
use crate::bindings::{Bindings, Value};
use crate::decisive::Decisive;
use crate::error::{Problem, QuestionError};
use crate::evaluate::slack;
use crate::question::{Expression, Question};
use arithmetic::{ArithmeticError, Interval, Number, Rational, RealNumber, Sign, Signed, rational};
use expressions::{Comparison, Hearing, Kind, Parameter, Relation, Time};
use motion::sets::Range;
use num_traits::ToPrimitive;
use polynomials::Side;
use std::sync::Arc;

/// Bits of enclosures where values are not rational.
const PRECISIONS: [u32; 2] = [128, 512];

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

/// A property of the states of one flock.
#[derive(Debug, Clone)]
pub(super) struct Instance {
    pub clauses: Vec<Vec<Comparison>>,
    pub links: Links,
    /// What each number of the state ranges over; the time is the last one.
    pub sides: Vec<Side>,
    /// The numbers of the state by their names in a question.
    pub names: Vec<String>,
    /// Numbers of each agent, by their places in the state.
    pub of_agent: Vec<Vec<usize>>,
    /// The places of one number of all agents, for each number that an agent has.
    pub columns: Vec<Vec<usize>>,
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
                Value::Number(q) if !["agents", "t"].contains(&name) && !parameter.contains(['.', '[']) => {
                    law.parameters.retain(|(known, _)| known != parameter);
                    law.parameters.push((parameter.to_string(), Parameter::One(q.clone())));
                }
                Value::Box(..) | Value::Any if name != "t" && !name.contains('[') => {
                    return Err(refuse(format!("`{name}` ranges over an interval; here only numbers of the state do")));
                }
                Value::Integers(..) => return Err(refuse(format!("`{name}` should be one number in each case"))),
                _ => {}
            }
        }
        let refused = |error| file.refused(question, expression, error);
        let compiled = law.compile(agents).map_err(refused)?;
        let clauses = law.statement(agents, &expression.node).map_err(refused)?;
        let autonomous = clauses.iter().flatten().all(Comparison::is_autonomous);
        let mut instance = Instance {
            clauses,
            links,
            sides: vec![Side::point(rational(0, 1)); compiled.size() + 1],
            names: vec![String::new(); compiled.size() + 1],
            of_agent: vec![Vec::new(); agents],
            columns: Vec::new(),
        };
        let bound = |name: &str| match bindings.get(name) {
            Some(Value::Number(q)) => Some(Side::point(q.clone())),
            Some(Value::Box(Range { lo, hi })) => Some(Side::between(lo.clone(), hi.clone())),
            Some(Value::Any) => Some(Side::line()),
            _ => None,
        };
        if !autonomous {
            let later = Side { lo: Some(rational(0, 1)), ..Side::line() };
            instance.sides[compiled.size()] = bound("t").unwrap_or(later);
            instance.names[compiled.size()] = "t".to_string();
        }
        for variable in compiled.variables() {
            let range = file.ranges.iter().find(|range| range.part == variable.name);
            for component in 0..variable.width {
                let mut column = Vec::new();
                for agent in 0..agents {
                    let place = variable.start + agent * variable.width + component;
                    let number = format!("{}[{}]", variable.name, agent + 1);
                    let vector = variable.kind == Kind::Vector && variable.width > 1;
                    let name = if vector { format!("{number}.{}", component + 1) } else { number };
                    let Some(side) = bound(&name).or_else(|| range.map(|range| range.side.clone())) else {
                        let why = format!("`{}` is missing in [for]: \"any\", or an interval", variable.name);
                        return Err(refuse(why));
                    };
                    instance.sides[place] = side;
                    instance.names[place] = name;
                    instance.of_agent[agent].push(place);
                    column.push(place);
                }
                instance.columns.push(column);
            }
        }
        Ok(instance)
    }

    /// Whether the numbers of all agents range over the same.
    pub fn is_uniform(&self) -> bool {
        let of = |places: &Vec<usize>| places.iter().map(|&place| &self.sides[place]).collect::<Vec<_>>();
        self.of_agent.windows(2).all(|pair| of(&pair[0]) == of(&pair[1]))
    }

    /// The places of the numbers that are not given.
    pub fn free(&self) -> Vec<usize> {
        (0..self.sides.len()).filter(|&place| self.sides[place].as_point().is_none()).collect()
    }

    /// A state in floats without symmetries.
    pub fn somewhere(&self) -> Vec<f64> {
        let mut state: Vec<f64> = self.sides.iter().map(|side| side.middle().to_f64().unwrap_or(0.0)).collect();
        for (k, place) in self.free().into_iter().enumerate() {
            let side = &self.sides[place];
            let moved = (1.0 + 0.7 * k as f64).sin();
            state[place] = match side.floats() {
                (lo, hi) if lo.is_finite() && hi.is_finite() => lo + (hi - lo) * (0.5 + 0.49 * moved),
                _ => state[place] + moved,
            };
        }
        state
    }

    /// The whole state, where nothing is left open.
    pub fn point(&self) -> Option<Vec<Rational>> {
        self.sides.iter().map(|side| side.as_point().cloned()).collect()
    }

    /// Whether a comparison holds at a state: exactly, or by enclosures of growing precision; nothing where it has no value or cannot be told.
    pub fn holds(&self, comparison: &Comparison, state: &[Rational]) -> Option<bool> {
        match value_of(comparison, &self.links, state) {
            Ok(value) => return value.sign().map(|sign| admits(comparison.relation, sign)),
            Err(ArithmeticError::Domain(_)) => {}
            Err(_) => return None,
        }
        for precision in PRECISIONS {
            if let Ok(value) = value_of(comparison, &self.links, &enclosed(state, precision))
                && let Some(sign) = value.sign()
            {
                return Some(admits(comparison.relation, sign));
            }
        }
        None
    }

    /// The two sides of a comparison at a state: exact, else enclosed.
    fn sides(&self, comparison: &Comparison, state: &[Rational]) -> Option<[RealNumber; 2]> {
        if let Ok(sides) = sides_of(comparison, &self.links, state) {
            return Some(sides.map(RealNumber::Exact));
        }
        let sides = sides_of(comparison, &self.links, &enclosed(state, PRECISIONS[0])).ok()?;
        Some(sides.map(RealNumber::interval))
    }

    /// The comparison that makes the property false at the state that is given, with its sides, and the margin of the property there.
    pub fn decisive(&self) -> Option<Decisive> {
        let state = self.point()?;
        let mut least: Option<Decisive> = None;
        for clause in &self.clauses {
            let mut largest: Option<Decisive> = None;
            // It fails by what it says, not by what it supposes.
            let only_supposed = clause.iter().all(|comparison| comparison.is_supposed);
            for comparison in clause.iter().filter(|comparison| only_supposed || !comparison.is_supposed) {
                let [left, right] = self.sides(comparison, &state)?;
                let (_, margin) = slack(&left, comparison.relation, &right, PRECISIONS[0]);
                if largest.as_ref().is_none_or(|found| found.margin.lo < margin.lo) {
                    let (left, right) = (left.text(), right.text());
                    let inequality = comparison.text.to_string();
                    largest = Some(Decisive { inequality, left, right, margin, time: None });
                }
            }
            let smaller = |found: &Decisive| largest.as_ref().is_some_and(|own| own.margin.lo < found.margin.lo);
            if least.as_ref().is_none_or(smaller) {
                least = largest;
            }
        }
        least
    }

    /// Whether a clause is true at a state.
    pub fn clause_holds(&self, clause: &[Comparison], state: &[Rational]) -> Option<bool> {
        let found: Vec<Option<bool>> = clause.iter().map(|comparison| self.holds(comparison, state)).collect();
        if found.contains(&Some(true)) {
            return Some(true);
        }
        found.iter().all(|one| *one == Some(false)).then_some(false)
    }
}

fn enclosed(state: &[Rational], precision: u32) -> Vec<Interval> {
    state.iter().map(|q| Interval::from_rational(q, precision)).collect()
}

/// The state with these numbers in the places that are free, of which there is one at least; the others are points.
pub(super) fn filled<T: Number>(sides: &[Side], free: &[usize], numbers: &[T]) -> Vec<T> {
    let like = &numbers[0];
    let number = |side: &Side| side.as_point().map_or_else(|| like.zero(), |q| like.rational(q));
    let mut state: Vec<T> = sides.iter().map(number).collect();
    free.iter().zip(numbers).for_each(|(&place, number)| state[place] = number.clone());
    state
}

/// A comparison as a function of a state and the time behind it, over any scalar.
pub(super) fn value_of<T: Number>(comparison: &Comparison, links: &Links, state: &[T]) -> Result<T, ArithmeticError> {
    let (time, state) = state.split_last().ok_or(ArithmeticError::Domain("a state"))?;
    comparison.value(time, state, links)
}

fn sides_of<T: Number>(comparison: &Comparison, links: &Links, state: &[T]) -> Result<[T; 2], ArithmeticError> {
    let (time, state) = state.split_last().ok_or(ArithmeticError::Domain("a state"))?;
    comparison.sides(time, state, links)
}

/// The same with what was divided by and what functions were taken of behind it.
pub(super) fn trail_of<T: Number>(
    comparison: &Comparison,
    links: &Links,
    state: &[T],
) -> Result<Vec<T>, ArithmeticError> {
    let (time, state) = state.split_last().ok_or(ArithmeticError::Domain("a state"))?;
    comparison.trail(time, state, links)
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
