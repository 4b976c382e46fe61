//! Names and sorts of a question, checked before anything is computed.

use super::Question;
use crate::binder::{Binder, Gathered};
use crate::domain::{Domain, Sort};
use crate::error::{Problem, QuestionError};
use crate::evaluate::kind_argument;
use crate::names::{FAMILIES, FUNCTIONS, GIVEN, OWN, Subject, quantity_of, unknown_quantity};
use crate::scenario_file::ScenarioFile;
use crate::syntax::{Kind, Node};
use algebra::graph::nearest_form;
use arithmetic::shown;
use models::platoon::Communication;

impl Question {
    /// Names in a family are those bound before, functions, and the families.
    pub(super) fn check_domain(&self, domain: &Domain, base: usize) -> Result<(), QuestionError> {
        let node = match domain {
            Domain::Given(_) => return Ok(()),
            Domain::List(list) => {
                return list.iter().try_for_each(|(offset, domain)| self.check_domain(domain, base + offset));
            }
            Domain::Written(node) => node,
        };
        let at = |(at, problem): (usize, Problem)| self.at(base + at, problem);
        if let Kind::Name { name, arguments, called: true } = &node.kind
            && !FUNCTIONS.iter().any(|function| function.name == name)
        {
            let Some(family) = FAMILIES.iter().find(|family| family.name == name) else {
                let known = FAMILIES.iter().map(|family| family.name).filter(|name| !name.is_empty());
                let problem = match nearest_form(name) {
                    Some(form) if form.split(':').next() == Some(name) => {
                        Problem::Other(format!("`{name}` is one graph, which is written {form}"))
                    }
                    _ => Problem::unknown("family", name, known),
                };
                return Err(at((node.at, problem)));
            };
            check_count(name, family.arguments, arguments.len()).map_err(|problem| at((node.at, problem)))?;
            let sorts = |node: &Node| match &node.kind {
                Kind::Name { name, called: false, .. } => self.sort(name),
                _ => None,
            };
            for argument in arguments {
                if !matches!(sorts(argument), Some(Sort::Graph | Sort::Matrices)) {
                    self.check_numbers(argument).map_err(at)?;
                }
                if sorts(argument) == Some(Sort::Box) {
                    let problem = Problem::NotInteger {
                        what: format!("the argument of `{name}`"),
                        found: "an interval".to_string(),
                    };
                    return Err(at((argument.at, problem)));
                }
            }
            return Ok(());
        }
        match &node.kind {
            Kind::Range(a, b) | Kind::Interval(a, b) => {
                self.check_numbers(a).and_then(|()| self.check_numbers(b)).map_err(at)
            }
            Kind::Name { name, called: false, .. } if self.sort(name).is_some() => Ok(()),
            Kind::Name { name, called: false, .. } if !FUNCTIONS.iter().any(|function| function.name == name) => {
                // Of the graphs only some have a name without numbers.
                let near = nearest_form(name).map(|form| form.to_string());
                let bound = self.bounds.iter().map(|bound| bound.name.to_string());
                let known: Vec<String> = bound.chain(near).collect();
                let what = "graph, and no number bound before this,";
                Err(at((node.at, Problem::unknown(what, name, known.iter().map(String::as_str)))))
            }
            _ => self.check_numbers(node).map_err(at),
        }
    }

    /// An expression of bound numbers and functions.
    fn check_numbers(&self, node: &Node) -> Result<(), (usize, Problem)> {
        let mut problem = None;
        node.visit(&mut |node| {
            if let Kind::Name { name, arguments, called } = &node.kind
                && problem.is_none()
            {
                let function = FUNCTIONS.iter().find(|function| function.name == name && name != "initial");
                problem = match (function, called, self.sort(name)) {
                    (Some(function), ..) => check_count(name, function.arguments, arguments.len()).err(),
                    (None, false, Some(Sort::Integer | Sort::Number | Sort::Box)) => None,
                    _ => {
                        let bound = self.bounds.iter().map(|bound| bound.name.as_ref());
                        let functions = FUNCTIONS.iter().map(|function| function.name);
                        Some(Problem::unknown(
                            "number bound before this, and no function,",
                            name,
                            bound.chain(functions),
                        ))
                    }
                }
                .map(|problem| (node.at, problem));
            }
        });
        problem.map_or(Ok(()), Err)
    }
}

fn check_count(name: &str, (least, most): (usize, usize), found: usize) -> Result<(), Problem> {
    if (least..=most).contains(&found) {
        return Ok(());
    }
    let plural = |n: usize| format!("{n} argument{}", if n == 1 { "" } else { "s" });
    let expected = match (least, most) {
        (0, 0) => "no arguments".to_string(),
        (a, b) if a == b => plural(a),
        (a, b) if b >= 1000 => format!("at least {}", plural(a)),
        (a, b) => format!("{a} to {}", plural(b)),
    };
    Err(Problem::Arguments { name: name.to_string(), expected, found })
}

/// Checks names and sorts before anything is computed.
pub(super) struct Check<'q> {
    pub question: &'q Question,
    /// Inside a time operator or `initial`.
    pub moving: bool,
    /// The names of vertices inside sums over a graph, and of the parameters of a definition.
    pub places: Vec<String>,
}

type Checked = Result<(), (usize, Problem)>;

impl Check<'_> {
    pub fn expect(&mut self, node: &Node, is_truth: bool) -> Checked {
        let wrong = || {
            let (expected, found) = ("something true or false", "a number");
            let problem =
                if is_truth { Problem::expected(expected, found) } else { Problem::expected(found, expected) };
            Err((node.at, problem))
        };
        match &node.kind {
            Kind::Number(_) | Kind::Negated(_) | Kind::Sum(_) | Kind::Product(_) | Kind::Power(..) if is_truth => {
                wrong()
            }
            Kind::Relation(..)
            | Kind::Not(_)
            | Kind::And(_)
            | Kind::Or(_)
            | Kind::Implies(..)
            | Kind::Always(..)
            | Kind::Until(_)
                if !is_truth =>
            {
                wrong()
            }
            Kind::Number(_) => Ok(()),
            Kind::Infinity => Err((node.at, Problem::expected("a number", "`inf`, which only ends a time"))),
            Kind::Range(..) | Kind::Interval(..) => Err((node.at, Problem::expected("a number", "a family"))),
            Kind::Where(..) => Err((node.at, Problem::expected("a number", "an agent with a condition"))),
            Kind::Negated(body) => self.expect(body, false),
            Kind::Sum(list) | Kind::Product(list) => list.iter().try_for_each(|(_, node)| self.expect(node, false)),
            Kind::Power(a, b) => self.expect(a, false).and_then(|()| self.expect(b, false)),
            Kind::Relation(first, others) => {
                self.expect(first, false)?;
                others.iter().try_for_each(|(_, node)| self.expect(node, false))
            }
            Kind::Not(body) => self.expect(body, true),
            Kind::And(list) | Kind::Or(list) => list.iter().try_for_each(|node| self.expect(node, true)),
            Kind::Implies(a, b) => self.expect(a, true).and_then(|()| self.expect(b, true)),
            Kind::Always(always, parts) => {
                let [from, to, body] = parts.as_ref();
                self.timed(node, if *always { "always" } else { "eventually" }, from, to, &[body])
            }
            Kind::Until(parts) => {
                let [from, to, first, second] = parts.as_ref();
                self.timed(node, "until", from, to, &[first, second])
            }
            Kind::Name { name, arguments, called } => self.name(node, name, arguments, *called, is_truth),
        }
    }

    /// The angle of a law of one's own that a sum, or a name, is about, as laws know it.
    fn angle<'n>(&self, node: &'n Node) -> Option<&'n str> {
        match &node.kind {
            Kind::Name { name, arguments, .. } if name == "initial" => {
                arguments.iter().find_map(|part| self.angle(part))
            }
            Kind::Name { name, .. } if self.question.scenario().is_some_and(|own| own.is_angle(name)) => Some(name),
            Kind::Negated(body) => self.angle(body),
            Kind::Sum(list) => list.iter().find_map(|(_, part)| self.angle(part)),
            _ => None,
        }
    }

    fn timed(&mut self, node: &Node, word: &'static str, from: &Node, to: &Node, bodies: &[&Node]) -> Checked {
        let subjects = self.question.subjects();
        if !subjects.iter().any(|subject| matches!(subject, Subject::Flock | Subject::Motion)) {
            return Err((node.at, Problem::Static(word)));
        }
        self.expect(from, false)?;
        if matches!(to.kind, Kind::Infinity) {
            let steps = self.question.scenario().is_some_and(ScenarioFile::is_discrete);
            if !subjects.contains(&Subject::Flock) && !steps {
                return Err((to.at, Problem::Unbounded));
            }
        } else {
            self.expect(to, false)?;
        }
        let before = std::mem::replace(&mut self.moving, true);
        let checked = bodies.iter().try_for_each(|body| self.expect(body, true));
        self.moving = before;
        checked
    }

    fn name(&mut self, node: &Node, name: &str, arguments: &[Node], called: bool, is_truth: bool) -> Checked {
        let at = |problem: Problem| (node.at, problem);
        let (number, truth) = ("a number", "something true or false");
        if !called && self.places.iter().any(|own| own == name) {
            return if is_truth { Err(at(Problem::expected(truth, number))) } else { Ok(()) };
        }
        if let Some(binder) = Binder::of(node, |name| self.question.is_known(name)) {
            let binder = binder?;
            self.binder(&binder, name).map_err(|(own, problem)| (own.unwrap_or(node.at), problem))?;
            return if is_truth { Err(at(Problem::expected(truth, number))) } else { Ok(()) };
        }
        if !called && let Some(sort) = self.question.sort(name) {
            let found = match sort {
                Sort::Graph => "the name of a graph",
                Sort::Matrices => "the name of a sequence of matrices",
                _ if is_truth => number,
                _ => return Ok(()),
            };
            return Err(at(Problem::expected(if is_truth { truth } else { number }, found)));
        }
        if let Some(function) = FUNCTIONS.iter().find(|function| function.name == name) {
            check_count(name, function.arguments, arguments.len()).map_err(at)?;
            if name == "abs"
                && let Some(angle) = arguments.iter().find_map(|node| self.angle(node))
            {
                return Err(at(Problem::Other(format!(
                    "`{angle}` is an angle: its size on the circle is an observable of the law, `abs({angle})` in [law.observables]; that of the number is max({angle}, -{angle})"
                ))));
            }
            let before = self.moving;
            self.moving |= name == "initial";
            let checked = arguments.iter().try_for_each(|node| self.expect(node, name == "initial" && is_truth));
            self.moving = before;
            checked?;
            return if is_truth && name != "initial" { Err(at(Problem::expected(truth, number))) } else { Ok(()) };
        }
        let (owner, own_name) = match name.split_once('.') {
            Some((owner, rest)) => (Some(owner), rest),
            None => (None, name),
        };
        let known = self.question.known_names();
        let own = if self.question.is_own(name) { Some(&OWN) } else { None };
        let owner = owner.filter(|_| own.is_none());
        let own = own.or_else(|| self.question.given(own_name).map(|_| &GIVEN));
        let quantity = own.or_else(|| quantity_of(own_name, self.question.subjects()));
        let quantity = quantity.ok_or_else(|| at(unknown_quantity(owner, own_name, &known)))?;
        self.owner(owner, name, quantity.subject).map_err(at)?;
        if quantity.subject == Subject::Platoon {
            self.platoon(name).map_err(at)?;
        }
        let count = quantity.arguments.len();
        let least = count - usize::from(matches!(quantity.name, "order" | "lambda"));
        check_count(name, (least, count), arguments.len()).map_err(at)?;
        for (argument, what) in arguments.iter().zip(quantity.arguments) {
            if *what == "kind" {
                kind_argument(argument)?;
                continue;
            }
            self.expect(argument, false)?;
            if matches!(*what, "k" | "m" | "i" | "j") {
                self.integer(argument, name)?;
            }
        }
        if quantity.moves && !self.moving {
            let hint = "put it inside `always`, `eventually` or `until`, or take its value at time 0 by `initial(..)`";
            return Err(at(Problem::Other(format!("`{name}` changes in time: {hint}"))));
        }
        match (quantity.is_truth, is_truth) {
            (true, false) => Err(at(Problem::expected(number, truth))),
            (false, true) => Err(at(Problem::expected(truth, number))),
            _ => Ok(()),
        }
    }

    /// Something that goes through a graph; an error without a place is about it as a whole.
    fn binder(&mut self, binder: &Binder, name: &str) -> Result<(), (Option<usize>, Problem)> {
        let whole = |problem| (None, problem);
        if let Some(known) = binder.names.iter().find(|name| self.places.iter().any(|own| own == *name)) {
            return Err(whole(Problem::Other(format!("`{known}` stands for a vertex already"))));
        }
        if !self.question.subjects().contains(&Subject::Graph) {
            return Err(whole(Problem::NoSubject {
                name: name.to_string(),
                subject: Subject::Graph.words(),
                missing: Subject::Graph.needs().to_string(),
            }));
        }
        self.owner(binder.owner, name, Subject::Graph).map_err(whole)?;
        let depth = self.places.len();
        self.places.extend(binder.names.iter().map(ToString::to_string));
        let condition = binder.condition.map_or(Ok(()), |condition| self.expect(condition, true));
        let checked = condition.and_then(|()| self.expect(binder.body, binder.gathered == Gathered::Count));
        self.places.truncate(depth);
        checked.map_err(|(at, problem)| (Some(at), problem))
    }

    /// Whose quantity it is, where several graphs are bound.
    fn owner(&self, owner: Option<&str>, name: &str, subject: Subject) -> Result<(), Problem> {
        let sort = match subject {
            Subject::Graph => Sort::Graph,
            Subject::Matrices => Sort::Matrices,
            _ if owner.is_some() => {
                return Err(Problem::Other(format!("`{name}`: only graphs and matrices are named before a quantity")));
            }
            _ => return Ok(()),
        };
        let bound = self.question.bounds.iter().filter(|bound| bound.domain.sort() == Some(sort));
        let names: Vec<&str> = bound.map(|bound| bound.name.as_ref()).collect();
        match owner {
            Some(owner) if names.contains(&owner) => Ok(()),
            Some(owner) => Err(Problem::unknown("bound name", owner, names)),
            None if names.len() > 1 => {
                let all = names.iter().map(|own| format!("`{own}.{name}`")).collect::<Vec<_>>().join(" or ");
                Err(Problem::Other(format!("`{name}` of which one? Write {all}")))
            }
            None => Ok(()),
        }
    }

    /// Which platoon it is must be said once.
    fn platoon(&self, name: &str) -> Result<(), Problem> {
        let question = self.question;
        let graphs = question.bounds.iter().filter(|bound| bound.domain.sort() == Some(Sort::Graph));
        let graphs: Vec<String> = graphs.map(|bound| format!("`{}`", bound.name)).collect();
        let other = |message: String| Err(Problem::Other(message));
        if question.scenario().is_some() {
            return other(format!(
                "`{name}` is that of the gains `f` and `g` in [for], which the scenario does not have; ask about one of them"
            ));
        }
        let followers = question.bounds.iter().find(|bound| bound.name.as_ref() == "followers");
        if followers.is_some_and(
            |bound| matches!(&bound.domain, Domain::Written(node) if matches!(node.kind, Kind::Interval(..))),
        ) {
            return Err(Problem::NotInteger { what: "`followers`".to_string(), found: "an interval".to_string() });
        }
        match (&graphs[..], question.sort("followers")) {
            ([graph, ..], Some(_)) => {
                other(format!("`followers` and {graph} both say who tracks whom; `{name}` needs one of them"))
            }
            ([_, _, ..], None) => {
                other(format!("`{name}` of which one? There are the graphs {}", graphs.join(" and ")))
            }
            ([graph], None) if question.communication() == Communication::Front => {
                other(format!("`communication` and {graph} both say who tracks whom; it goes with `followers`"))
            }
            _ => Ok(()),
        }
    }

    /// An argument that must be an integer, as far as that is seen without computing.
    fn integer(&self, node: &Node, name: &str) -> Checked {
        let found = match &node.kind {
            Kind::Number(q) if !q.is_integer() => shown(&q.to_string()),
            Kind::Name { name, called: false, .. } if self.question.sort(name) == Some(Sort::Box) => {
                format!("`{name}`, which ranges over an interval")
            }
            _ => return Ok(()),
        };
        Err((node.at, Problem::NotInteger { what: format!("the argument of `{name}`"), found }))
    }
}
