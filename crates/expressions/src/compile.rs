//! From texts to programs: names resolved, kinds checked, vectors taken apart.

use super::law::{Kind, Law, LawError, LawText, Parameter, Variable};
use super::number::Function;
use super::problem::Problem;
use super::program::{FLOCK, Gather, Id, OWN, Of, Op, Program, Slot, Things};
use super::syntax::{KEYWORDS, Node, NodeKind, Relation, parse_property};
use arithmetic::{Rational, rational};
use num_traits::ToPrimitive;
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
const FUNCTIONS: [(&str, usize, usize); 19] = [
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
];

type Made<T> = Result<T, LawError>;

/// What computes the observables, and their names with how many numbers each has.
type Observed = (Arc<Program>, Vec<(String, usize)>);

pub(crate) struct Compiler<'a> {
    text: &'a LawText,
    agents: usize,
    variables: Vec<Variable>,
    definitions: HashMap<&'a str, Definition<'a>>,
    lists: Vec<Vec<Rational>>,
    things: Things,
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
            lists: Vec::new(),
            things: Things::new(),
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
            let stride = if text.planar && width == 1 && first == Some(name) { 2 } else { width };
            self.variables.push(Variable { name: name.clone(), kind: *kind, start, width, stride });
            start += stride * self.agents;
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

    /// The whole law.
    pub fn law(mut self) -> Made<Law> {
        let text = self.text;
        for (key, _) in &text.rates {
            if !text.state.iter().any(|(name, _)| name == key) {
                let known = text.state.iter().map(|(name, _)| name.as_str());
                return self.refuse_entry("rates", key, Problem::unknown("part of the state", key, known));
            }
        }
        let scope = Scope {
            own: Some(Of::Slot(OWN)),
            innermost: OWN,
            hears: Some(Of::Slot(OWN)),
            agents: vec![("i".to_string(), Of::Slot(OWN))],
        };
        let (mut outputs, mut targets) = (Vec::new(), Vec::new());
        for (place, variable) in self.variables.clone().iter().enumerate() {
            let Some((key, rate)) = text.rates.iter().find(|(name, _)| *name == variable.name) else {
                let what = if text.time == super::law::Time::Discrete { "next value" } else { "rate" };
                let problem = format!("the {what} of `{}` is missing", variable.name);
                return self.refuse_entry("rates", "", Problem::Other(problem));
            };
            self.reading.push(("rates", key));
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
        let rates = Arc::new(self.things.program(outputs));
        let (observed, observables) = self.observables()?;
        Ok(Law {
            agents: self.agents,
            placed: text.position.is_some(),
            variables: self.variables,
            lists: self.lists,
            rates,
            targets,
            observed,
            observables,
        })
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

    /// A number for each number of a value.
    fn each(&mut self, node: &Node, value: Value, f: impl Fn(&mut Things, Id) -> Id) -> Made<Value> {
        Ok(match value {
            Value::Number(id) => Value::Number(f(&mut self.things, id)),
            Value::Angle(id) => Value::Angle(f(&mut self.things, id)),
            Value::Vector(ids) => Value::Vector(ids.into_iter().map(|id| f(&mut self.things, id)).collect()),
            Value::Truth(_) => return self.refuse(node.at, Problem::expected("a number or a vector", value.words())),
        })
    }

    fn added(&mut self, a: Value, b: Value, minus: bool, node: &Node) -> Made<Value> {
        let things = &mut self.things;
        let mut join = |a, b| things.add(if minus { Op::Difference(a, b) } else { Op::Sum(a, b) });
        match (a, b) {
            (Value::Number(a), Value::Number(b)) => Ok(Value::Number(join(a, b))),
            (Value::Number(a) | Value::Angle(a), Value::Angle(b)) | (Value::Angle(a), Value::Number(b)) => {
                Ok(Value::Angle(join(a, b)))
            }
            (Value::Vector(a), Value::Vector(b)) => {
                Ok(Value::Vector(a.into_iter().zip(b).map(|(a, b)| join(a, b)).collect()))
            }
            (first, second) => self.refuse(node.at, Problem::expected(first.words(), second.words())),
        }
    }

    fn multiplied(&mut self, a: Value, b: Value, divides: bool, node: &Node) -> Made<Value> {
        let things = &mut self.things;
        let mut join = |a, b| things.add(if divides { Op::Quotient(a, b) } else { Op::Product(a, b) });
        match (a, b) {
            (Value::Number(a) | Value::Angle(a), Value::Number(b) | Value::Angle(b)) => Ok(Value::Number(join(a, b))),
            (Value::Vector(a), Value::Number(b) | Value::Angle(b)) => {
                Ok(Value::Vector(a.into_iter().map(|a| join(a, b)).collect()))
            }
            (Value::Number(a) | Value::Angle(a), Value::Vector(b)) if !divides => {
                Ok(Value::Vector(b.into_iter().map(|b| join(a, b)).collect()))
            }
            (Value::Vector(_), Value::Vector(_)) if !divides => {
                let why = "the product of two vectors: `dot(a, b)` is a number, `cross(a, b)` their vector product";
                self.refuse(node.at, Problem::Other(why.to_string()))
            }
            (_, other) => self.refuse(node.at, Problem::expected("a number", other.words())),
        }
    }

    fn power(&mut self, base: Id, exponent: Id) -> Id {
        let things = &mut self.things;
        let constant = if let Op::Number(q) = &things.ops[exponent] { Some(q.clone()) } else { None };
        let twice = constant.as_ref().map(|q| q * rational(2, 1)).filter(Rational::is_integer);
        let small = twice.and_then(|twice| twice.to_integer().to_i64()).filter(|twice| twice.unsigned_abs() <= 128);
        let Some(twice) = small else {
            let logarithm = things.add(Op::Function(Function::Logarithm, base));
            let product = things.add(Op::Product(exponent, logarithm));
            return things.add(Op::Function(Function::Exponential, product));
        };
        let root = if twice % 2 == 0 { base } else { things.add(Op::Function(Function::Root, base)) };
        let times = if twice % 2 == 0 { twice / 2 } else { twice };
        let size = u32::try_from(times.unsigned_abs()).unwrap_or_default();
        let one = things.integer(1);
        let power = if size == 0 { one } else { things.add(Op::Power(root, size)) };
        if times < 0 { things.add(Op::Quotient(one, power)) } else { power }
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

    fn condition(&mut self, node: &Node, scope: &Scope) -> Made<Id> {
        match &node.kind {
            NodeKind::Relation(first, others) => {
                let mut left = self.number(first, scope)?;
                let mut all = Vec::new();
                for (relation, node) in others {
                    let right = self.number(node, scope)?;
                    all.push(self.things.add(Op::Compared(*relation, left, right)));
                    left = right;
                }
                Ok(self.all_of(all))
            }
            NodeKind::Not(body) => {
                let body = self.condition(body, scope)?;
                Ok(self.things.add(Op::Not(body)))
            }
            NodeKind::And(nodes) => {
                let all = nodes.iter().map(|node| self.condition(node, scope)).collect::<Made<Vec<_>>>()?;
                Ok(self.all_of(all))
            }
            NodeKind::Or(nodes) => {
                let all = nodes.iter().map(|node| self.condition(node, scope)).collect::<Made<Vec<_>>>()?;
                Ok(self.one_of(all))
            }
            NodeKind::Implies(first, second) => {
                let (first, second) = (self.condition(first, scope)?, self.condition(second, scope)?);
                let first = self.things.add(Op::Not(first));
                Ok(self.one_of(vec![first, second]))
            }
            NodeKind::Name { .. } => match self.value(node, scope)? {
                Value::Truth(id) => Ok(id),
                other => self.refuse(node.at, Problem::expected("something true or false", other.words())),
            },
            _ => {
                let value = self.value(node, scope)?;
                self.refuse(node.at, Problem::expected("something true or false", value.words()))
            }
        }
    }

    fn all_of(&mut self, conditions: Vec<Id>) -> Id {
        let things = &mut self.things;
        conditions.into_iter().reduce(|a, b| things.add(Op::Both(a, b))).unwrap_or_else(|| {
            let zero = things.integer(0);
            things.add(Op::Compared(Relation::Equal, zero, zero))
        })
    }

    /// Not all of them false.
    fn one_of(&mut self, conditions: Vec<Id>) -> Id {
        let all = conditions.into_iter().map(|id| self.things.add(Op::Not(id))).collect();
        let none = self.all_of(all);
        self.things.add(Op::Not(none))
    }

    fn name(&mut self, node: &Node, (name, arguments, called): (&str, &[Node], bool), scope: &Scope) -> Made<Value> {
        if let Some((_, gather)) = LOOPS.iter().find(|(known, _)| *known == name)
            && called
            && self.is_over_agents(*gather, arguments)
        {
            return self.over_agents(node, *gather, arguments, scope);
        }
        if name == "vector" {
            let numbers = arguments.iter().map(|node| self.number(node, scope)).collect::<Made<Vec<_>>>()?;
            let expected = format!("{} numbers", self.text.dimension);
            if numbers.len() != self.text.dimension {
                return self
                    .refuse(node.at, Problem::Arguments { name: name.to_string(), expected, found: numbers.len() });
            }
            return Ok(self.as_vector(numbers));
        }
        if let Some((_, least, most)) = FUNCTIONS.iter().find(|(known, ..)| *known == name) {
            let found = arguments.len();
            if !(*least..=*most).contains(&found) {
                let expected =
                    if least == most { words_for(*least) } else { format!("at least {}", words_for(*least)) };
                return self.refuse(node.at, Problem::Arguments { name: name.to_string(), expected, found });
            }
            return self.function(name, arguments, scope);
        }
        let (base, index, component) = parts(name);
        if let Some(definition) = self.definitions.get(base).cloned() {
            if index.is_some() || component.is_some() {
                let way = format!("{base}({})", definition.agents.join(", "));
                return self.refuse(node.at, Problem::expected(format!("`{way}`"), format!("`{name}`")));
            }
            return self.defined(node, base, &definition, arguments, scope);
        }
        if called {
            let known = FUNCTIONS.iter().map(|(name, ..)| *name).chain(LOOPS.iter().map(|(name, _)| *name));
            let known = known.chain(self.definitions.keys().copied());
            return self.refuse(node.at, Problem::unknown("function", name, known));
        }
        self.of_agent(node, (name, base, index, component), scope)
    }

    /// A parameter or a part of the state.
    fn of_agent(
        &mut self,
        node: &Node,
        (name, base, index, component): (&str, &str, Option<&str>, Option<&str>),
        scope: &Scope,
    ) -> Made<Value> {
        if let Some((_, parameter)) = self.text.parameters.iter().find(|(known, _)| known == base) {
            return match parameter {
                Parameter::One(q) if index.is_none() && component.is_none() => {
                    Ok(Value::Number(self.things.number(q.clone())))
                }
                Parameter::Each(list) if component.is_none() => {
                    let of = self.agent(node, base, index, scope)?;
                    let known = self.lists.iter().position(|known| known == list).unwrap_or(self.lists.len());
                    if known == self.lists.len() {
                        self.lists.push(list.clone());
                    }
                    Ok(Value::Number(self.things.add(Op::Parameter(known, of))))
                }
                _ => self.refuse(
                    node.at,
                    Problem::expected(format!("`{base}`, the same for all agents"), format!("`{name}`")),
                ),
            };
        }
        let Some(variable) = self.variables.iter().find(|variable| variable.name == base).cloned() else {
            let known = self.variables.iter().map(|variable| variable.name.as_str());
            let known = known.chain(self.text.parameters.iter().map(|(name, _)| name.as_str()));
            let known = known.chain(self.definitions.keys().copied()).chain(FUNCTIONS.iter().map(|(name, ..)| *name));
            return self.refuse(node.at, Problem::unknown("name", base, known));
        };
        let of = self.agent(node, base, index, scope)?;
        let part = |component| Op::State { start: variable.start, stride: variable.stride, component, of };
        if let Some(component) = component {
            let number = component.parse::<usize>().ok().filter(|k| (1..=variable.width).contains(k));
            let Some(number) = number.filter(|_| variable.kind == Kind::Vector) else {
                let expected = match variable.kind {
                    Kind::Vector => format!("a component from 1 to {}", variable.width),
                    _ => format!("`{base}`, which has no components"),
                };
                return self.refuse(node.at, Problem::expected(expected, format!("`{name}`")));
            };
            return Ok(Value::Number(self.things.add(part(number - 1))));
        }
        let numbers: Vec<Id> = (0..variable.width).map(|component| self.things.add(part(component))).collect();
        Ok(match variable.kind {
            Kind::Angle => Value::Angle(numbers[0]),
            _ => self.as_vector(numbers),
        })
    }

    /// A vector of one dimension counts as a number.
    fn as_vector(&self, numbers: Vec<Id>) -> Value {
        if let [one] = numbers[..] { Value::Number(one) } else { Value::Vector(numbers) }
    }

    /// The agent of an index, or whose a bare name is.
    fn agent(&self, node: &Node, base: &str, index: Option<&str>, scope: &Scope) -> Made<Of> {
        match index {
            None => scope.own.map_or_else(|| self.refuse(node.at, Problem::NoAgent(base.to_string())), Ok),
            Some(index) => self.agent_called(node, index, scope),
        }
    }

    fn agent_called(&self, node: &Node, called: &str, scope: &Scope) -> Made<Of> {
        if let Ok(number) = called.parse::<usize>() {
            if (1..=self.agents).contains(&number) {
                return Ok(Of::Agent(number - 1));
            }
            let expected = format!("an agent from 1 to {}", self.agents);
            return self.refuse(node.at, Problem::expected(expected, called));
        }
        let found = scope.agents.iter().rev().find(|(name, _)| name == called).map(|(_, of)| *of);
        found.map_or_else(
            || {
                self.refuse(
                    node.at,
                    Problem::unknown("agent", called, scope.agents.iter().map(|(name, _)| name.as_str())),
                )
            },
            Ok,
        )
    }

    /// An abbreviation, written out for its agents.
    fn defined(
        &mut self,
        node: &Node,
        name: &str,
        definition: &Definition<'a>,
        arguments: &[Node],
        scope: &Scope,
    ) -> Made<Value> {
        if self.reading.iter().any(|(table, key)| *table == "define" && *key == definition.key) {
            return self.refuse(node.at, Problem::Circular(name.to_string()));
        }
        let mut agents = Vec::new();
        for argument in arguments {
            let called = match &argument.kind {
                NodeKind::Name { name, called: false, .. } => name.clone(),
                NodeKind::Number(q) => q.to_string(),
                _ => return self.refuse(argument.at, Problem::expected("an agent", format!("`{argument}`"))),
            };
            agents.push(self.agent_called(argument, &called, scope)?);
        }
        if let (Some(own), [_], []) = (scope.own, &definition.agents[..], &agents[..]) {
            agents.push(own);
        }
        if agents.len() != definition.agents.len() {
            let (expected, found) = (format!("the agents ({})", definition.agents.join(", ")), agents.len());
            return self.refuse(node.at, Problem::Arguments { name: name.to_string(), expected, found });
        }
        let slots = agents.iter().filter_map(|of| if let Of::Slot(slot) = of { Some(*slot) } else { None });
        let inner = Scope {
            own: if let [one] = agents[..] { Some(one) } else { None },
            innermost: self.things.deepest(slots),
            hears: agents.first().copied(),
            agents: definition.agents.iter().map(|name| (*name).to_string()).zip(agents).collect(),
        };
        self.reading.push(("define", definition.key));
        let value = self.value(&definition.body, &inner)?;
        self.reading.pop();
        Ok(value)
    }

    /// Whether `max(j, e)` runs over agents: its first argument is a name that means nothing else, or has a condition.
    fn is_over_agents(&self, gather: Gather, arguments: &[Node]) -> bool {
        let Some(first) = arguments.first() else { return false };
        let own_name = match &first.kind {
            NodeKind::Where(..) => return true,
            NodeKind::Name { name, called: false, .. } => name,
            _ => return !matches!(gather, Gather::Largest | Gather::Smallest),
        };
        let (base, ..) = parts(own_name);
        let known = self.variables.iter().any(|variable| variable.name == base)
            || self.text.parameters.iter().any(|(name, _)| name == base)
            || self.definitions.contains_key(base)
            || FUNCTIONS.iter().any(|(name, ..)| *name == base);
        !known || !matches!(gather, Gather::Largest | Gather::Smallest)
    }

    fn over_agents(&mut self, node: &Node, gather: Gather, arguments: &[Node], scope: &Scope) -> Made<Value> {
        let word = LOOPS.iter().find(|(_, known)| *known == gather).map_or("", |(word, _)| word);
        let count = gather == Gather::Count;
        let expected = if count { "an agent and, if wanted, a condition" } else { "an agent and an expression" };
        if arguments.is_empty() || arguments.len() > 2 || (!count && arguments.len() < 2) {
            let (name, expected, found) = (word.to_string(), expected.to_string(), arguments.len());
            return self.refuse(node.at, Problem::Arguments { name, expected, found });
        }
        let (agent, filter) = match &arguments[0].kind {
            NodeKind::Where(agent, filter) => (agent.as_ref(), Some(filter.as_ref())),
            _ => (&arguments[0], None),
        };
        let NodeKind::Name { name, called: false, .. } = &agent.kind else {
            return self.refuse(agent.at, Problem::expected("a name for an agent", format!("`{agent}`")));
        };
        if scope.agents.iter().any(|(known, _)| known == name) {
            return self.refuse(agent.at, Problem::Bound(name.clone()));
        }
        let slot = self.things.slot(scope.innermost, scope.hears, name);
        let of = Of::Slot(slot);
        let mut inner = Scope { innermost: slot, hears: Some(of), ..scope.clone() };
        inner.agents.push((name.clone(), of));
        let mut conditions = Vec::new();
        if let Some(filter) = filter {
            conditions.push(self.condition(filter, &inner)?);
        }
        if count {
            if let Some(condition) = arguments.get(1) {
                conditions.push(self.condition(condition, &inner)?);
            }
            let condition = if conditions.is_empty() { None } else { Some(self.all_of(conditions)) };
            let one = self.things.integer(1);
            return Ok(Value::Number(self.things.gather(slot, condition, gather, one)));
        }
        let condition = conditions.pop();
        let value = self.value(&arguments[1], &inner)?;
        self.gathered(&arguments[1], slot, condition, gather, value)
    }

    fn gathered(
        &mut self,
        node: &Node,
        slot: Slot,
        condition: Option<Id>,
        gather: Gather,
        value: Value,
    ) -> Made<Value> {
        let things = &mut self.things;
        Ok(match value {
            Value::Number(id) => Value::Number(things.gather(slot, condition, gather, id)),
            // The direction of the mean of the unit vectors; zero over none.
            Value::Angle(id) if gather == Gather::Mean => {
                let mut total = |function| {
                    let part = things.add(Op::Function(function, id));
                    things.gather(slot, condition, Gather::Sum, part)
                };
                let (sine, cosine) = (total(Function::Sine), total(Function::Cosine));
                let (zero, one) = (things.integer(0), things.integer(1));
                let count = things.gather(slot, condition, Gather::Count, one);
                let (angle, none) =
                    (things.add(Op::Angle(sine, cosine)), things.add(Op::Compared(Relation::Equal, count, zero)));
                Value::Angle(things.add(Op::Choice(none, zero, angle)))
            }
            Value::Angle(id) => Value::Angle(things.gather(slot, condition, gather, id)),
            Value::Vector(ids) if matches!(gather, Gather::Sum | Gather::Mean) => {
                Value::Vector(ids.into_iter().map(|id| things.gather(slot, condition, gather, id)).collect())
            }
            other => return self.refuse(node.at, Problem::expected("a number", other.words())),
        })
    }

    fn function(&mut self, name: &str, arguments: &[Node], scope: &Scope) -> Made<Value> {
        match name {
            "pi" => return Ok(Value::Number(self.things.add(Op::Pi))),
            "t" => return Ok(Value::Number(self.things.add(Op::Time))),
            "agents" => return Ok(Value::Number(self.things.integer(self.agents as i64))),
            "if" => return self.choice(arguments, scope),
            "dot" | "cross" | "norm" | "norm2" | "unit" | "turn" | "heading" => {
                return self.function_of_vectors(name, arguments, scope);
            }
            _ => {}
        }
        let first = self.value(&arguments[0], scope)?;
        if let (Value::Angle(id), "abs") = (&first, name) {
            return Ok(Value::Number(self.turned_least(*id)));
        }
        let (Value::Number(first) | Value::Angle(first)) = first else {
            return self.refuse(arguments[0].at, Problem::expected("a number", first.words()));
        };
        let function = match name {
            "sqrt" => Function::Root,
            "exp" => Function::Exponential,
            "log" => Function::Logarithm,
            "sin" => Function::Sine,
            "cos" => Function::Cosine,
            "abs" => return Ok(Value::Number(self.things.add(Op::Absolute(first)))),
            _ => {
                let mut best = first;
                for node in &arguments[1..] {
                    let other = self.number(node, scope)?;
                    best =
                        self.things.add(if name == "max" { Op::Larger(best, other) } else { Op::Smaller(best, other) });
                }
                return Ok(Value::Number(best));
            }
        };
        Ok(Value::Number(self.things.add(Op::Function(function, first))))
    }

    /// The size of an angle on the circle, from 0 to pi.
    fn turned_least(&mut self, angle: Id) -> Id {
        let things = &mut self.things;
        let (sine, cosine) =
            (things.add(Op::Function(Function::Sine, angle)), things.add(Op::Function(Function::Cosine, angle)));
        let turned = things.add(Op::Angle(sine, cosine));
        things.add(Op::Absolute(turned))
    }

    fn choice(&mut self, arguments: &[Node], scope: &Scope) -> Made<Value> {
        let condition = self.condition(&arguments[0], scope)?;
        let (a, b) = (self.value(&arguments[1], scope)?, self.value(&arguments[2], scope)?);
        let things = &mut self.things;
        let mut join = |a, b| things.add(Op::Choice(condition, a, b));
        match (a, b) {
            (Value::Vector(a), Value::Vector(b)) => {
                Ok(Value::Vector(a.into_iter().zip(b).map(|(a, b)| join(a, b)).collect()))
            }
            (Value::Angle(a), Value::Angle(b)) => Ok(Value::Angle(join(a, b))),
            (Value::Number(a) | Value::Angle(a), Value::Number(b) | Value::Angle(b)) => Ok(Value::Number(join(a, b))),
            (first, second) => self.refuse(arguments[2].at, Problem::expected(first.words(), second.words())),
        }
    }

    fn dot(&mut self, a: &[Id], b: &[Id]) -> Id {
        let things = &mut self.things;
        let products: Vec<Id> = a.iter().zip(b).map(|(a, b)| things.add(Op::Product(*a, *b))).collect();
        products.into_iter().reduce(|a, b| things.add(Op::Sum(a, b))).unwrap_or_else(|| things.integer(0))
    }

    /// `a_k b_l - a_l b_k`.
    fn minor(&mut self, a: &[Id], b: &[Id], (k, l): (usize, usize)) -> Id {
        let things = &mut self.things;
        let (first, second) = (things.add(Op::Product(a[k], b[l])), things.add(Op::Product(a[l], b[k])));
        things.add(Op::Difference(first, second))
    }

    fn function_of_vectors(&mut self, name: &str, arguments: &[Node], scope: &Scope) -> Made<Value> {
        let first = self.vector(&arguments[0], scope)?;
        let flat = |this: &Self| match first.len() {
            2 => Ok(()),
            _ => this
                .refuse(arguments[0].at, Problem::expected(format!("a vector of the plane, for `{name}`,"), "another")),
        };
        Ok(match name {
            "dot" => {
                let second = self.vector(&arguments[1], scope)?;
                Value::Number(self.dot(&first, &second))
            }
            "cross" => {
                let second = self.vector(&arguments[1], scope)?;
                match first.len() {
                    3 => Value::Vector([(1, 2), (2, 0), (0, 1)].map(|pair| self.minor(&first, &second, pair)).to_vec()),
                    _ => {
                        flat(self)?;
                        Value::Number(self.minor(&first, &second, (0, 1)))
                    }
                }
            }
            "norm2" => Value::Number(self.dot(&first, &first)),
            "norm" => Value::Number(self.norm(&first)),
            "unit" => {
                let norm = self.norm(&first);
                let numbers = first.iter().map(|id| self.things.add(Op::Quotient(*id, norm))).collect();
                self.as_vector(numbers)
            }
            "turn" => {
                flat(self)?;
                let angle = self.number(&arguments[1], scope)?;
                let sine = self.things.add(Op::Function(Function::Sine, angle));
                let cosine = self.things.add(Op::Function(Function::Cosine, angle));
                let back = self.things.add(Op::Negated(sine));
                Value::Vector(vec![self.dot(&[cosine, back], &first), self.dot(&[sine, cosine], &first)])
            }
            _ => {
                flat(self)?;
                Value::Angle(self.things.add(Op::Angle(first[1], first[0])))
            }
        })
    }

    /// In one dimension the absolute value.
    fn norm(&mut self, vector: &[Id]) -> Id {
        if let [one] = vector {
            return self.things.add(Op::Absolute(*one));
        }
        let square = self.dot(vector, vector);
        self.things.add(Op::Function(Function::Root, square))
    }
}

fn words_for(arguments: usize) -> String {
    match arguments {
        0 => "no arguments".to_string(),
        1 => "one argument".to_string(),
        n => format!("{n} arguments"),
    }
}

/// `x[j].1` as `x`, `j` and `1`.
fn parts(name: &str) -> (&str, Option<&str>, Option<&str>) {
    let end = name.find(['[', '.']).unwrap_or(name.len());
    let (base, rest) = name.split_at(end);
    let (index, rest) = match rest.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
        Some((index, rest)) => (Some(index), rest),
        None => (None, rest),
    };
    (base, index, rest.strip_prefix('.').or(if rest.is_empty() { None } else { Some(rest) }))
}
