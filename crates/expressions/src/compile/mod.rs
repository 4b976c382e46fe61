//! From texts to programs: names resolved, kinds checked, vectors taken apart.

mod agents;
mod functions;
mod names;
mod operations;
mod rate;
mod statement;

pub use statement::{Clauses, Comparison};

use super::law::{Drawn, Kind, Law, LawError, LawText, OpenParameter, Parameter, Time, Variable};
use super::problem::Problem;
use super::program::{FLOCK, Gather, Id, OWN, Of, Op, Program, Slot, Things};
use super::syntax::{KEYWORDS, Node, NodeKind, parse_property};
use arithmetic::{Rational, rational};
use std::collections::HashMap;
use std::sync::Arc;

/// What an expression is.
#[derive(Debug, Clone)]
enum Value {
    Number(Id),
    Angle(Id),
    Vector(Vec<Id>),
    Truth(Id),
}

impl Value {
    fn words(&self) -> &'static str {
        match self {
            Value::Number(_) => "a number",
            Value::Angle(_) => "an angle",
            Value::Vector(_) => "a vector",
            Value::Truth(_) => "something true or false",
        }
    }
}

/// Who is meant by names.
#[derive(Debug, Clone)]
struct Scope {
    /// Whose a bare name is.
    own: Option<Of>,
    /// The variable bound last.
    innermost: Slot,
    /// Whose neighbours a sum runs over; all agents where nobody is named.
    hears: Option<Of>,
    agents: Vec<(String, Of)>,
}

/// Functions that run over agents: `sum(j, e)`.
const LOOPS: [(&str, Gather); 5] = [
    ("sum", Gather::Sum),
    ("mean", Gather::Mean),
    ("max", Gather::Largest),
    ("min", Gather::Smallest),
    ("count", Gather::Count),
];

/// Functions of numbers and vectors with their numbers of arguments.
const FUNCTIONS: [(&str, usize, usize); 22] = [
    ("sqrt", 1, 1),
    ("exp", 1, 1),
    ("log", 1, 1),
    ("sin", 1, 1),
    ("cos", 1, 1),
    ("abs", 1, 1),
    ("min", 1, 100),
    ("max", 1, 100),
    ("pi", 0, 0),
    ("t", 0, 0),
    ("agents", 0, 0),
    ("if", 3, 3),
    ("dot", 2, 2),
    ("cross", 2, 2),
    ("norm", 1, 1),
    ("norm2", 1, 1),
    ("unit", 1, 1),
    ("turn", 2, 2),
    ("heading", 1, 1),
    ("normal", 1, 1),
    ("uniform", 2, 2),
    ("rate", 1, 1),
];

type Made<T> = Result<T, LawError>;

/// What computes the observables, and their names with how many numbers each has.
type Observed = (Arc<Program>, Vec<(String, usize)>);

/// The numbers of an agent, with where each goes: variable and component.
type Outputs = (Vec<Id>, Vec<(usize, usize)>);

pub(crate) struct Compiler<'a> {
    text: &'a LawText,
    agents: usize,
    variables: Vec<Variable>,
    definitions: HashMap<&'a str, Definition<'a>>,
    /// Abbreviations that were written out, by their names and their agents: those that use each other twice would grow without bound.
    written_out: HashMap<(&'a str, Vec<Of>), Value>,
    lists: Vec<Vec<Rational>>,
    open: Vec<OpenParameter>,
    /// What is drawn for every step, with where it is written: the table, the key and the byte.
    drawn: Vec<(Drawn, (&'static str, &'a str, usize))>,
    things: Things,
    /// Of things how they change: derivatives, or next values in discrete time.
    changes: HashMap<Id, Id>,
    /// The rates of a part of the state of an agent.
    rates_of: HashMap<(usize, Of), Vec<Id>>,
    /// Whether the number of agents stays a number of its own.
    of_any: bool,
    /// The entries whose texts are read, the one inside of all others last.
    reading: Vec<(&'static str, &'a str)>,
}

#[derive(Clone)]
struct Definition<'a> {
    key: &'a str,
    agents: Vec<&'a str>,
    body: Node,
}

impl<'a> Compiler<'a> {
    pub fn new(text: &'a LawText, agents: usize) -> Made<Self> {
        let mut compiler = Compiler {
            text,
            agents,
            variables: Vec::new(),
            definitions: HashMap::new(),
            written_out: HashMap::new(),
            lists: Vec::new(),
            open: Vec::new(),
            drawn: Vec::new(),
            things: Things::new(),
            changes: HashMap::new(),
            rates_of: HashMap::new(),
            of_any: false,
            reading: Vec::new(),
        };
        compiler.lay_out()?;
        compiler.read_definitions()?;
        Ok(compiler)
    }

    fn refuse<T>(&self, at: impl Into<Option<usize>>, problem: Problem) -> Made<T> {
        let (table, key) = self.reading.last().copied().unwrap_or(("state", ""));
        Err(LawError { table, key: key.to_string(), at: at.into(), problem })
    }

    fn refuse_entry<T>(&self, table: &'static str, key: &str, problem: Problem) -> Made<T> {
        Err(LawError { table, key: key.to_string(), at: None, problem })
    }

    /// Every name means one thing.
    fn check_name(&self, table: &'static str, key: &'a str, name: &str, taken: &mut Vec<String>) -> Made<()> {
        let first = |c: char| c.is_ascii_alphabetic() || c == '_';
        let word = name.starts_with(first) && name.chars().all(|c| first(c) || c.is_ascii_digit());
        let function =
            FUNCTIONS.iter().any(|(known, ..)| *known == name) || LOOPS.iter().any(|(known, _)| *known == name);
        let problem = if !word {
            Problem::expected("a name of letters, digits and _", format!("`{name}`"))
        } else if function || KEYWORDS.contains(&name) || name == "vector" {
            Problem::Other(format!("`{name}` is a word of the language; take another name"))
        } else if taken.iter().any(|other| other == name) {
            Problem::Other(format!("`{name}` is given twice"))
        } else {
            taken.push(name.to_string());
            return Ok(());
        };
        self.refuse_entry(table, key, problem)
    }

    /// The order of the numbers of a state.
    fn lay_out(&mut self) -> Made<()> {
        let text = self.text;
        if !(1..=3).contains(&text.dimension) {
            return self.refuse_entry("dimension", "", Problem::expected("1, 2 or 3", text.dimension.to_string()));
        }
        let mut taken = Vec::new();
        for (name, _) in &text.state {
            self.check_name("state", name, name, &mut taken)?;
        }
        for (name, parameter) in &text.parameters {
            self.check_name("parameters", name, name, &mut taken)?;
            if let Parameter::Each(list) = parameter
                && list.len() != self.agents
            {
                let problem = format!("there are {} values for {} agents", list.len(), self.agents);
                return self.refuse_entry("parameters", name, Problem::Other(problem));
            }
        }
        if text.state.is_empty() {
            return self.refuse_entry(
                "state",
                "",
                Problem::Other("an agent has nothing: name at least one part of its state".to_string()),
            );
        }
        let first = text.position.as_deref();
        if let Some(position) = first
            && !text.state.iter().any(|(name, kind)| name == position && *kind != Kind::Angle)
        {
            let known = text.state.iter().map(|(name, _)| name.as_str());
            return self.refuse_entry("position", position, Problem::unknown("vector of the state", position, known));
        }
        let mut order: Vec<&(String, Kind)> = text.state.iter().collect();
        order.sort_by_key(|(name, _)| Some(name.as_str()) != first);
        let mut start = 0;
        for (name, kind) in order {
            let width = if *kind == Kind::Vector { text.dimension } else { 1 };
            self.variables.push(Variable { name: name.clone(), kind: *kind, start, width });
            start += width * self.agents;
        }
        Ok(())
    }

    fn read_definitions(&mut self) -> Made<()> {
        let mut taken: Vec<String> = self.text.state.iter().map(|(name, _)| name.clone()).collect();
        taken.extend(self.text.parameters.iter().map(|(name, _)| name.clone()));
        for (key, text) in &self.text.define {
            let (name, inside) =
                key.split_once('(').map_or((key.trim(), None), |(name, rest)| (name.trim(), Some(rest)));
            let agents: Vec<&str> = match inside.map(|rest| rest.trim_end().strip_suffix(')')) {
                None => Vec::new(),
                Some(None) => return self.refuse_entry("define", key, Problem::expected("`)`", "the end")),
                Some(Some(list)) => list.split(',').map(str::trim).collect(),
            };
            self.check_name("define", key, name, &mut taken)?;
            let mut own = Vec::new();
            for agent in &agents {
                self.check_name("define", key, agent, &mut own)?;
            }
            self.reading.push(("define", key));
            let body = self.parse(text)?;
            self.reading.pop();
            self.definitions.insert(name, Definition { key, agents, body });
        }
        Ok(())
    }

    fn parse(&self, text: &str) -> Made<Node> {
        parse_property(text).or_else(|(at, problem)| self.refuse(at, problem))
    }

    /// The whole law, with some parameters left open.
    pub fn law(mut self, open: &[&str]) -> Made<Law> {
        let text = self.text;
        self.list_parameters();
        self.leave_open(open)?;
        let (outputs, targets) = self.of_agents("rates", &text.rates)?;
        let rates = Arc::new(self.things.program(outputs));
        let noise = if text.noise.is_empty() { None } else { Some(self.noise()?) };
        let (observed, observables) = self.observables()?;
        self.check_definitions()?;
        let nothing = vec![rational(0, 1); self.agents];
        self.lists.extend(self.drawn.iter().map(|_| nothing.clone()));
        Ok(Law {
            agents: self.agents,
            placed: text.position.is_some(),
            variables: self.variables,
            lists: self.lists,
            drawn: self.drawn.into_iter().map(|(drawn, _)| drawn).collect(),
            rates,
            noise,
            targets,
            observed,
            observables,
            open: self.open,
        })
    }

    /// The numbers of open parameters stand behind those of the agents.
    fn leave_open(&mut self, names: &[&str]) -> Made<()> {
        let mut start = self.variables.iter().map(|variable| variable.width * self.agents).sum();
        for name in names {
            let Some((_, parameter)) = self.text.parameters.iter().find(|(known, _)| known == name) else {
                let known = self.text.parameters.iter().map(|(name, _)| name.as_str());
                return self.refuse_entry("parameters", name, Problem::unknown("parameter", name, known));
            };
            let values = match parameter {
                Parameter::One(q) => vec![q.clone()],
                Parameter::Each(list) => list.clone(),
            };
            let count = values.len();
            self.open.push(OpenParameter { name: (*name).to_string(), start, values });
            start += count;
        }
        Ok(())
    }

    /// Whether a number of the state is one of an open parameter, by where its list begins.
    fn is_open(&self, start: usize) -> bool {
        self.open.iter().any(|open| open.start == start)
    }

    /// The lists of all parameters: those that are drawn come after them.
    fn list_parameters(&mut self) {
        for (_, parameter) in &self.text.parameters {
            if let Parameter::Each(list) = parameter
                && !self.lists.contains(list)
            {
                self.lists.push(list.clone());
            }
        }
    }

    /// Of agent i, whose bare names are its own.
    fn own_scope() -> Scope {
        Scope {
            own: Some(Of::Slot(OWN)),
            innermost: OWN,
            hears: Some(Of::Slot(OWN)),
            agents: vec![("i".to_string(), Of::Slot(OWN))],
        }
    }

    /// Every part of the state has its entry; the numbers, and where each goes.
    fn of_agents(&mut self, table: &'static str, entries: &'a [(String, String)]) -> Made<Outputs> {
        let text = self.text;
        for (key, _) in entries {
            if !text.state.iter().any(|(name, _)| name == key) {
                let known = text.state.iter().map(|(name, _)| name.as_str());
                return self.refuse_entry(table, key, Problem::unknown("part of the state", key, known));
            }
        }
        let scope = Self::own_scope();
        let (mut outputs, mut targets) = (Vec::new(), Vec::new());
        for (place, variable) in self.variables.clone().iter().enumerate() {
            let Some((key, rate)) = entries.iter().find(|(name, _)| *name == variable.name) else {
                let what = if text.time == Time::Discrete { "next value" } else { "rate" };
                let problem = format!("the {what} of `{}` is missing", variable.name);
                return self.refuse_entry(table, "", Problem::Other(problem));
            };
            self.reading.push((table, key));
            let node = self.parse(rate)?;
            let value = self.value(&node, &scope)?;
            let expected = if variable.width > 1 { "a vector" } else { "a number" };
            let numbers = match value {
                Value::Vector(numbers) if variable.width == numbers.len() => numbers,
                Value::Number(id) | Value::Angle(id) if variable.width == 1 => vec![id],
                other => return self.refuse(node.at, Problem::expected(expected, other.words())),
            };
            self.reading.pop();
            targets.extend((0..numbers.len()).map(|component| (place, component)));
            outputs.extend(numbers);
        }
        Ok((outputs, targets))
    }

    /// The strength of the noise of each number, zero where nothing is said.
    fn noise(&mut self) -> Made<Arc<Program>> {
        let text = self.text;
        for (key, _) in &text.noise {
            if !text.state.iter().any(|(name, _)| name == key) {
                let known = text.state.iter().map(|(name, _)| name.as_str());
                return self.refuse_entry("noise", key, Problem::unknown("part of the state", key, known));
            }
        }
        let scope = Self::own_scope();
        let mut outputs = Vec::new();
        for variable in &self.variables.clone() {
            let strength = match text.noise.iter().find(|(name, _)| *name == variable.name) {
                None => self.things.integer(0),
                Some((key, strength)) => {
                    self.reading.push(("noise", key));
                    let node = self.parse(strength)?;
                    let number = self.number(&node, &scope)?;
                    self.reading.pop();
                    number
                }
            };
            outputs.extend(std::iter::repeat_n(strength, variable.width));
        }
        Ok(Arc::new(self.things.program(outputs)))
    }

    fn observables(&mut self) -> Made<Observed> {
        let scope = Scope { own: None, innermost: FLOCK, hears: None, agents: Vec::new() };
        let (mut outputs, mut names) = (Vec::new(), Vec::new());
        let mut taken = Vec::new();
        for (key, text) in &self.text.observables {
            self.check_name("observables", key, key, &mut taken)?;
            self.reading.push(("observables", key));
            let node = self.parse(text)?;
            let numbers = match self.value(&node, &scope)? {
                Value::Number(id) | Value::Angle(id) | Value::Truth(id) => vec![id],
                Value::Vector(ids) => ids,
            };
            self.reading.pop();
            names.push((key.clone(), numbers.len()));
            outputs.extend(numbers);
        }
        Ok((Arc::new(self.things.program(outputs)), names))
    }

    /// Unknown names in definitions that nobody uses. What else is wrong depends on the agents for which a definition is written out.
    fn check_definitions(&mut self) -> Made<()> {
        let drawn = self.drawn.len();
        let mut definitions: Vec<Definition> = self.definitions.values().cloned().collect();
        definitions.sort_by_key(|definition| definition.key);
        for definition in definitions {
            let (mut agents, mut innermost) = (Vec::new(), FLOCK);
            for agent in &definition.agents {
                innermost = if innermost == FLOCK { OWN } else { self.things.slot(innermost, None, agent) };
                agents.push(((*agent).to_string(), Of::Slot(innermost)));
            }
            let hears = agents.first().map(|(_, of)| *of);
            let own = hears.filter(|_| agents.len() == 1);
            self.reading = vec![("define", definition.key)];
            let found = self.value(&definition.body, &Scope { own, innermost, hears, agents });
            if let Err(error) = found
                && matches!(error.problem, Problem::Unknown { .. })
            {
                return Err(error);
            }
        }
        self.reading.clear();
        self.drawn.truncate(drawn);
        Ok(())
    }

    fn value(&mut self, node: &Node, scope: &Scope) -> Made<Value> {
        match &node.kind {
            NodeKind::Number(q) => Ok(Value::Number(self.things.number(q.clone()))),
            NodeKind::Name { name, arguments, called } => self.name(node, (name, arguments, *called), scope),
            NodeKind::Negated(body) => {
                let zero_less = |things: &mut Things, id| things.add(Op::Negated(id));
                let value = self.value(body, scope)?;
                self.each(body, value, zero_less)
            }
            NodeKind::Sum(terms) => {
                let mut sum: Option<Value> = None;
                for (minus, term) in terms {
                    let value = self.value(term, scope)?;
                    sum = Some(match sum {
                        None => value,
                        Some(sum) => self.added(sum, value, *minus, term)?,
                    });
                }
                sum.map_or_else(|| self.refuse(node.at, Problem::expected("a sum", "nothing")), Ok)
            }
            NodeKind::Product(factors) => {
                let mut product: Option<Value> = None;
                for (divides, factor) in factors {
                    let value = self.value(factor, scope)?;
                    product = Some(match product {
                        None => value,
                        Some(so_far) => self.multiplied(so_far, value, *divides, factor)?,
                    });
                }
                product.map_or_else(|| self.refuse(node.at, Problem::expected("a product", "nothing")), Ok)
            }
            NodeKind::Power(base, exponent) => {
                let (id, exponent) = (self.number(base, scope)?, self.number(exponent, scope)?);
                Ok(Value::Number(self.power(id, exponent)))
            }
            NodeKind::Relation(..) | NodeKind::Not(_) | NodeKind::And(_) | NodeKind::Or(_) | NodeKind::Implies(..) => {
                self.condition(node, scope).map(Value::Truth)
            }
            NodeKind::Always(..) | NodeKind::Until(_) => {
                let why = "a law says what holds at one time; `always`, `eventually` and `until` are for properties";
                self.refuse(node.at, Problem::Other(why.to_string()))
            }
            NodeKind::Infinity | NodeKind::Where(..) | NodeKind::Range(..) | NodeKind::Interval(..) => {
                self.refuse(node.at, Problem::expected("a number or a vector", format!("`{node}`")))
            }
        }
    }

    fn number(&mut self, node: &Node, scope: &Scope) -> Made<Id> {
        match self.value(node, scope)? {
            Value::Number(id) | Value::Angle(id) => Ok(id),
            other => self.refuse(node.at, Problem::expected("a number", other.words())),
        }
    }

    fn vector(&mut self, node: &Node, scope: &Scope) -> Made<Vec<Id>> {
        match self.value(node, scope)? {
            Value::Vector(ids) => Ok(ids),
            // A vector of one dimension counts as a number.
            Value::Number(id) if self.text.dimension == 1 => Ok(vec![id]),
            other => self.refuse(node.at, Problem::expected("a vector", other.words())),
        }
    }
}
