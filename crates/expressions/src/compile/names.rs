//! What names stand for: parameters, parts of the state, abbreviations, agents.

use super::functions::words_for;
use super::{Compiler, Definition, FUNCTIONS, LOOPS, Made, Scope, Value};
use crate::law::{Drawn, Kind, Parameter, Time};
use crate::problem::Problem;
use crate::program::{Id, Of, Op};
use crate::syntax::{Node, NodeKind};

impl<'a> Compiler<'a> {
    pub(super) fn name(
        &mut self,
        node: &Node,
        (name, arguments, called): (&str, &[Node], bool),
        scope: &Scope,
    ) -> Made<Value> {
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
            if let "normal" | "uniform" = name {
                return self.drawn(node, name, arguments, scope);
            }
            if name == "rate" {
                return self.rate(node, arguments, scope);
            }
            return self.function(name, arguments, scope);
        }
        let (base, index, component) = parts(name);
        if let Some(definition) = self.definitions.get(base).cloned() {
            if let (None, Some(component), []) = (index, component, &definition.agents[..]) {
                let value = self.defined(node, base, &definition, arguments, scope)?;
                let Value::Vector(ids) = value else {
                    return self.refuse(node.at, Problem::expected("a vector", value.words()));
                };
                let number = component.parse::<usize>().ok().and_then(|k| ids.get(k.checked_sub(1)?));
                let expected =
                    || Problem::expected(format!("a component from 1 to {}", ids.len()), format!("`{name}`"));
                return number.map_or_else(|| self.refuse(node.at, expected()), |id| Ok(Value::Number(*id)));
            }
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

    /// A number that is drawn for the agent whose bare names are its own, once in a step wherever the same place of the text is read.
    fn drawn(&mut self, node: &Node, name: &str, arguments: &[Node], scope: &Scope) -> Made<Value> {
        let Some((table, key)) = self.reading.last().copied() else {
            return self.refuse(node.at, Problem::NoAgent(name.to_string()));
        };
        if self.text.time != Time::Discrete || self.reading.first().is_none_or(|(table, _)| *table != "rates") {
            let why =
                format!("`{name}` draws for a step of discrete time; noise in continuous time stands in [law.noise]");
            return self.refuse(node.at, Problem::Other(why));
        }
        let Some(of) = scope.own else {
            let why = format!("`{name}` is drawn for one agent, and here none has a name of its own");
            return self.refuse(node.at, Problem::Other(why));
        };
        let kind = if name == "normal" { Drawn::Normal } else { Drawn::Uniform };
        let place = (table, key, node.at);
        let drawn = self.drawn.iter().position(|(_, known)| *known == place).unwrap_or_else(|| {
            self.drawn.push((kind, place));
            self.drawn.len() - 1
        });
        let number = self.things.add(Op::Parameter(self.lists.len() + drawn, of));
        let first = self.number(&arguments[0], scope)?;
        let things = &mut self.things;
        if kind == Drawn::Normal {
            return Ok(Value::Number(things.add(Op::Product(first, number))));
        }
        let last = self.number(&arguments[1], scope)?;
        let things = &mut self.things;
        let width = things.add(Op::Difference(last, first));
        let part = things.add(Op::Product(width, number));
        Ok(Value::Number(things.add(Op::Sum(first, part))))
    }

    /// A parameter or a part of the state.
    pub(super) fn of_agent(
        &mut self,
        node: &Node,
        (name, base, index, component): (&str, &str, Option<&str>, Option<&str>),
        scope: &Scope,
    ) -> Made<Value> {
        if let Some((_, parameter)) = self.text.parameters.iter().find(|(known, _)| known == base) {
            let open = self.open.iter().find(|open| open.name == base).map(|open| open.start);
            let read = |start, of| Op::State { start, stride: 1, component: 0, of };
            return match parameter {
                Parameter::One(q) if index.is_none() && component.is_none() => Ok(Value::Number(match open {
                    Some(start) => self.things.add(read(start, Of::Agent(0))),
                    None => self.things.number(q.clone()),
                })),
                Parameter::Each(list) if component.is_none() => {
                    let of = self.agent(node, base, index, scope)?;
                    if let Some(start) = open {
                        return Ok(Value::Number(self.things.add(read(start, of))));
                    }
                    let known = self.lists.iter().position(|known| known == list).unwrap_or_default();
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
        let part = |component| Op::State { start: variable.start, stride: variable.width, component, of };
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
    pub(super) fn as_vector(&self, numbers: Vec<Id>) -> Value {
        if let [one] = numbers[..] { Value::Number(one) } else { Value::Vector(numbers) }
    }

    /// The agent of an index, or whose a bare name is.
    pub(super) fn agent(&self, node: &Node, base: &str, index: Option<&str>, scope: &Scope) -> Made<Of> {
        match index {
            None => scope.own.map_or_else(|| self.refuse(node.at, Problem::NoAgent(base.to_string())), Ok),
            Some(index) => self.agent_called(node, index, scope),
        }
    }

    pub(super) fn agent_called(&self, node: &Node, called: &str, scope: &Scope) -> Made<Of> {
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
    pub(super) fn defined(
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
        let known = (definition.key, agents.clone());
        if let Some(value) = self.written_out.get(&known) {
            return Ok(value.clone());
        }
        let slots = agents.iter().filter_map(|of| if let Of::Slot(slot) = of { Some(*slot) } else { None });
        let inner = Scope {
            own: if let [one] = agents[..] { Some(one) } else { None },
            innermost: self.things.deepest(slots),
            hears: agents.first().copied(),
            agents: definition.agents.iter().map(|name| (*name).to_string()).zip(agents).collect(),
        };
        self.reading.push(("define", definition.key));
        let drawn = self.drawn.len();
        let value = self.value(&definition.body, &inner)?;
        self.reading.pop();
        // What is drawn is drawn wherever it is written.
        if self.drawn.len() == drawn {
            self.written_out.insert(known, value.clone());
        }
        Ok(value)
    }
}

/// `x[j].1` as `x`, `j` and `1`.
pub(super) fn parts(name: &str) -> (&str, Option<&str>, Option<&str>) {
    let end = name.find(['[', '.']).unwrap_or(name.len());
    let (base, rest) = name.split_at(end);
    let (index, rest) = match rest.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
        Some((index, rest)) => (Some(index), rest),
        None => (None, rest),
    };
    (base, index, rest.strip_prefix('.').or(if rest.is_empty() { None } else { Some(rest) }))
}
