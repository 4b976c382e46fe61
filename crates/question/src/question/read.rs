//! A question read from its file, and checked name by name on the way.

use super::check::Check;
use super::{Asked, BUDGET, Expression, Question};
use crate::definitions::Definition;
use crate::domain::{Bound, Classes, Domain, read_domain, read_each};
use crate::error::{Place, Problem, QuestionError};
use crate::given::Given;
use crate::inequalities::inequalities;
use crate::names::{FUNCTIONS, Subject};
use crate::scenario_file::Files;
use crate::scenario_file::{ScenarioFile, is_place};
use crate::sharper::bounds;
use crate::source::{Entry, Section, Source};
use crate::states::LawFile;
use crate::syntax::{KEYWORDS, Node, parse_property};
use algebra::graph::LaplacianKind;
use arithmetic::shown;
use models::platoon::{Communication, Parameter};
use std::sync::{Arc, OnceLock};

/// Largest budget.
const LARGEST_BUDGET: u64 = 1_000_000_000;

/// Words of sums over a graph.
const RESERVED: [&str; 5] = ["sum", "count", "vertex", "edge", "pair"];

const SECTIONS: [&str; 5] = ["question", "for", "define", "holds", "values"];

impl Question {
    /// Reads a question. `files` gives the text of the files that it names.
    ///
    /// # Errors
    /// [`QuestionError`] with line and column.
    pub fn read(text: &str, files: Files) -> Result<Self, QuestionError> {
        Question::read_with(text, files, Vec::new())
    }

    /// The same with functions of graphs that properties may name.
    ///
    /// # Errors
    /// As [`Question::read`].
    pub fn read_with(text: &str, files: Files, given: Vec<Given>) -> Result<Self, QuestionError> {
        let source = Source::parse(text)?;
        let sections = source.sections(&SECTIONS)?;
        let [head, family, definitions, holds, values] = &sections;
        let head = head.as_ref().ok_or_else(|| {
            let missing = "the section [question] is missing; it needs an `id`".to_string();
            QuestionError::At { place: Place::of(text, 0), problem: Problem::Other(missing) }
        })?;
        let mut question = Question::headed(text, head, files)?;
        let restriction = match family {
            Some(family) => question.read_family(family, files)?,
            None => None,
        };
        question.alone = question.bounds.iter().map(|_| OnceLock::new()).collect();
        question.subjects = question.found_subjects();
        question.read_given(given)?;
        if let Some(definitions) = definitions {
            question.read_definitions(definitions)?;
        }
        if let Some(entry) = restriction {
            question.restriction = Some(question.expression(&entry, true)?);
        }
        if let Some(holds) = holds {
            question.read_holds(holds)?;
        }
        if let Some(values) = values {
            question.read_values(values)?;
        }
        if question.property.is_none() && question.values.is_empty() {
            let needed = "a question has a section [holds] with a property, or a section [values]";
            return Err(head.problem(Problem::Other(needed.to_string())));
        }
        question.check_bounds()?;
        Ok(question)
    }

    fn headed(text: &str, head: &Section, files: Files) -> Result<Self, QuestionError> {
        head.allow(&["id", "statement", "scenario", "law", "kind", "communication", "budget"])?;
        let id = head.need("id", "a name such as \"mine.connectivity\"")?;
        let id_text = id.text()?.text;
        let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '-');
        if id_text.is_empty() || id_text.len() > 100 || !id_text.chars().all(plain) || id_text.starts_with(['.', '-']) {
            let expected = "an id of letters, digits, `.`, `_` and `-`, at most 100";
            return Err(id.problem(Problem::expected(expected, format!("`{}`", shown(&id_text)))));
        }
        let chosen = |entry: &Entry, what: &'static str, known: Vec<&'static str>| {
            let text = entry.text()?.text;
            let found = known.iter().position(|name| *name == text);
            found.ok_or_else(|| entry.problem(Problem::unknown(what, &text, known.iter().copied())))
        };
        let kind = match head.get("kind") {
            None => LaplacianKind::Combinatorial,
            Some(entry) => {
                let names = LaplacianKind::NAMES.iter().map(|(name, _)| *name).collect();
                match LaplacianKind::from_name(&entry.text()?.text) {
                    Some(kind) => kind,
                    None => LaplacianKind::NAMES[chosen(&entry, "kind of matrix", names)?].1,
                }
            }
        };
        let communication = match head.get("communication") {
            None => Communication::FrontAndBack,
            Some(entry) => match chosen(&entry, "communication", vec!["front", "front-and-back"])? {
                0 => Communication::Front,
                _ => Communication::FrontAndBack,
            },
        };
        let budget = head.get("budget").map_or(Ok(BUDGET), |entry| entry.count(LARGEST_BUDGET))?;
        let scenario = match head.get("scenario") {
            None => None,
            Some(entry) => {
                let name = entry.text()?.text;
                let read = files(&name).and_then(|content| ScenarioFile::read(&name, &content, files));
                Some(read.map_err(|message| entry.problem(Problem::Other(message)))?)
            }
        };
        let law = match head.get("law") {
            None => None,
            Some(entry) if scenario.is_some() => {
                let why = "a question is about runs of a `scenario` or about all states of a `law`, not both";
                return Err(entry.problem(Problem::Other(why.to_string())));
            }
            Some(entry) => {
                let name = entry.text()?.text;
                let read = files(&name).and_then(|content| LawFile::read(&name, &content));
                Some(read.map_err(|message| entry.problem(Problem::Other(message)))?)
            }
        };
        let statement = head.get("statement").map(|entry| entry.text()).transpose()?.map(|located| located.text);
        Ok(Question {
            text: text.to_string(),
            id: id_text,
            statement,
            scenario,
            law,
            kind,
            communication,
            budget,
            bounds: Vec::new(),
            restriction: None,
            property: None,
            controls: Vec::new(),
            values: Vec::new(),
            values_at: 0,
            subjects: Vec::new(),
            definitions: Vec::new(),
            given: Vec::new(),
            classes: Classes::default(),
            alone: Vec::new(),
            starts: OnceLock::new(),
            certified: false,
            listed_counterexamples: 0,
            listed_tight: 0,
        })
    }

    /// Reads what the names range over; `where` comes after the definitions.
    fn read_family<'s>(&mut self, section: &Section<'s>, files: Files) -> Result<Option<Entry<'s>>, QuestionError> {
        let mut restriction = None;
        let mut every: Vec<(String, usize)> = Vec::new();
        for entry in section.entries() {
            if entry.key == "where" {
                if self.law.is_some() {
                    let why =
                        "left out where a question is about all states: `condition implies property` says the same";
                    return Err(self.at(entry.key_at, Problem::Other(format!("`where` should be {why}"))));
                }
                restriction = Some(entry);
                continue;
            }
            if let Some(law) = self.law.as_mut().filter(|law| law.is_part(&entry.key)) {
                let located = entry.text()?;
                if law.ranges.iter().any(|range| range.part == entry.key) {
                    return Err(self.at(entry.key_at, Problem::Other(format!("`{}` is bound twice", entry.key))));
                }
                let added = law.add_range(&entry.key, &located.text);
                added.map_err(|problem| self.at(located.base, problem))?;
                continue;
            }
            if let Some(law) = self.law.as_mut().filter(|_| ["agents", "graph"].contains(&entry.key.as_str()))
                && entry.text().is_ok_and(|located| law.add_every(&entry.key, &located.text))
            {
                every.push((entry.key.clone(), entry.key_at));
                continue;
            }
            self.check_new_name(&entry)?;
            let is_parameter = Parameter::from_name(&entry.key).is_some();
            let text_of = |entry: &Entry| {
                // A list inside a list is one for the followers.
                let located = if is_parameter { entry.text_or_list()? } else { entry.text()? };
                let each = if is_parameter { read_each(&located.text) } else { None };
                let domain = each.map_or_else(|| read_domain(&located.text, files), Ok);
                let domain = domain.map_err(|(at, problem)| match without_commas(&located.text) {
                    Some(wrong) if is_parameter => self.at(located.base, wrong),
                    _ => self.at(located.base + at, problem),
                })?;
                Ok::<_, QuestionError>((domain, located.base))
            };
            let (domain, base) = if entry.is_list() {
                let mut items = Vec::new();
                for item in entry.items() {
                    let (domain, base) = text_of(&item)?;
                    items.push((base, domain));
                }
                let base = items.first().map_or(entry.key_at, |(base, _)| *base);
                (Domain::List(items.into_iter().map(|(at, domain)| (at - base, domain)).collect()), base)
            } else {
                text_of(&entry)?
            };
            let bound = Bound { name: Arc::from(entry.key.as_str()), domain, base, key_at: entry.key_at };
            self.check_domain(&bound.domain, bound.base)?;
            if bound.domain.sort().is_none() {
                let expected = "a list of numbers, of graphs or of matrices";
                return Err(self.at(bound.base, Problem::expected(expected, "of different sorts")));
            }
            if bound.domain.has_interval()
                && is_place(&bound.name)
                && let Some(scenario) = &self.scenario
            {
                let carried = scenario.check_wide(&bound.name);
                carried.map_err(|message| self.at(bound.key_at, Problem::Other(message)))?;
            }
            self.bounds.push(bound);
        }
        if let Some((name, at)) = every.first() {
            let agents = every.iter().any(|(name, _)| name == "agents");
            let other = self
                .bounds
                .iter()
                .filter(|bound| !bound.name.starts_with("law.parameters."))
                .find(|bound| is_place(&bound.name) || ["agents", "graph"].contains(&bound.name.as_ref()));
            if !agents || other.is_some() || every.len() > 2 {
                let at = other.map_or(*at, |bound| bound.key_at);
                let why = format!(
                    "`{name} = \"any\"` is about flocks of every size: `agents = \"any\"` once, with `graph = \"any\"` for every network without directions, or without a graph for complete ones, and no numbers of single agents"
                );
                return Err(self.at(at, Problem::Other(why)));
            }
        }
        Ok(restriction)
    }

    fn read_given(&mut self, given: Vec<Given>) -> Result<(), QuestionError> {
        for own in given {
            let refuse = |why: String| Err(self.at(0, Problem::Other(why)));
            let header = parse_property(&own.name).ok().and_then(|key| Definition::header(&key));
            if header.is_none_or(|(_, parameters)| !parameters.is_empty()) || KEYWORDS.contains(&own.name.as_str()) {
                return refuse(format!("`{}` is no name of letters, digits and `_`", shown(&own.name)));
            }
            if self.is_known(&own.name) || RESERVED.contains(&own.name.as_str()) {
                return refuse(format!("`{}` stands for something else already", own.name));
            }
            if !self.subjects.contains(&Subject::Graph) {
                return refuse(format!(
                    "`{}` is a function of a graph, and no name in [for] ranges over graphs",
                    own.name
                ));
            }
            self.given.push(own);
        }
        Ok(())
    }

    fn read_definitions(&mut self, section: &Section) -> Result<(), QuestionError> {
        if self.law.is_some() {
            let why = "a question about all states of a law has the definitions of the law".to_string();
            return Err(section.problem(Problem::Other(why)));
        }
        for entry in section.entries() {
            let key = parse_property(&entry.key).ok();
            let header = key.and_then(|key| Definition::header(&key));
            let (name, parameters) = header.ok_or_else(|| {
                let expected = "a name, or a name with names in brackets such as `weight(i, j)`,";
                self.at(entry.key_at, Problem::expected(expected, format!("`{}`", shown(&entry.key))))
            })?;
            let reserved = KEYWORDS.contains(&name.as_str()) || RESERVED.contains(&name.as_str());
            let taken = |own: &str| self.is_known(own) || self.definitions.iter().any(|known| known.name == own);
            if let Some(own) = [&name].into_iter().chain(&parameters).find(|own| taken(own)) {
                return Err(self.at(entry.key_at, Problem::Other(format!("`{own}` stands for something else already"))));
            }
            if reserved {
                return Err(self.at(entry.key_at, Problem::Other(format!("`{name}` is a word of the language"))));
            }
            let located = entry.text()?;
            let at = |(at, problem): (usize, Problem)| self.at(located.base + at, problem);
            let body = parse_property(&located.text).and_then(|node| self.expanded(node)).map_err(at)?;
            let check = |is_truth: bool| {
                Check { question: self, moving: false, places: parameters.clone() }.expect(&body, is_truth)
            };
            check(false).or_else(|problem| check(true).map_err(|_| problem)).map_err(at)?;
            self.definitions.push(Definition { name, parameters, body });
        }
        Ok(())
    }

    /// An expression with what the names of [define] stand for in their places.
    fn expanded(&self, node: Node) -> Result<Node, (usize, Problem)> {
        self.definitions.iter().rev().try_fold(node, |node, definition| definition.expand(node))
    }

    fn check_new_name(&self, entry: &Entry) -> Result<(), QuestionError> {
        let name = entry.key.as_str();
        if is_place(name)
            && let Some(law) = &self.law
        {
            let problem = || Problem::Other(format!("{}: there is no number at `{name}`", law.name));
            return if law.has_place(name) { Ok(()) } else { Err(self.at(entry.key_at, problem())) };
        }
        if is_place(name)
            && let Some(scenario) = &self.scenario
        {
            let known = scenario.check_place(name);
            return known.map_err(|message| self.at(entry.key_at, Problem::Other(message)));
        }
        let undrawn = |scenario: &ScenarioFile| name == "seed" && !scenario.is_drawn();
        if self.scenario.as_ref().is_some_and(undrawn) {
            let message = "`seed` draws random starts, but [state] of the scenario has no `random`".to_string();
            return Err(self.at(entry.key_at, Problem::Other(message)));
        }
        let starts = name.starts_with(|c: char| c.is_ascii_alphabetic());
        let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        if !starts || !plain || name.len() > 64 {
            let expected = "a name of letters, digits and `_` that begins with a letter";
            return Err(self.at(entry.key_at, Problem::expected(expected, format!("`{}`", shown(name)))));
        }
        if KEYWORDS.contains(&name) || FUNCTIONS.iter().any(|function| function.name == name) {
            return Err(self
                .at(entry.key_at, Problem::Other(format!("`{name}` is a word of the language and cannot be bound"))));
        }
        Ok(())
    }

    fn read_holds(&mut self, section: &Section) -> Result<(), QuestionError> {
        section.allow(&["property", "controls"])?;
        let property = section.need("property", "a statement such as \"lambda(2) > 0\"")?;
        let property = self.expression(&property, true)?;
        let inequalities = if self.law.is_some() { Vec::new() } else { inequalities(&property.node) };
        self.property = Some(Expression { inequalities, ..property });
        let controls = section.get("controls").map(|entry| entry.items()).unwrap_or_default();
        for entry in &controls {
            let control = self.expression(entry, true)?;
            let same = |other: &Expression| other.node.to_string() == control.node.to_string();
            if self.property.as_ref().is_some_and(same) {
                return Err(entry.problem(Problem::Other("the control is the property itself".to_string())));
            }
            self.controls.push(control);
        }
        if self.controls.is_empty()
            && self.law.is_none()
            && let Some(property) = &mut self.property
        {
            let alone = bounds(&property.node).into_iter().map(|own| own.alone);
            property.bounds = alone.filter(|own| property.place(own).is_none()).collect();
        }
        Ok(())
    }

    fn read_values(&mut self, section: &Section) -> Result<(), QuestionError> {
        self.values_at = section.at();
        if self.law.is_some() {
            let why = "[values] needs a scenario or a graph: all states of a law have no one value".to_string();
            return Err(section.problem(Problem::Other(why)));
        }
        for entry in section.entries() {
            // A number, or else something true or false.
            let number = self.expression(&entry, false).map(|expression| (expression, false));
            let truth = |error| self.expression(&entry, true).map(|expression| (expression, true)).map_err(|_| error);
            let (expression, is_truth) = number.or_else(truth)?;
            self.values.push(Asked { name: entry.key, expression, is_truth });
        }
        Ok(())
    }

    /// Reads and checks an expression.
    fn expression(&self, entry: &Entry, is_truth: bool) -> Result<Expression, QuestionError> {
        let located = entry.text()?;
        let at = |(at, problem): (usize, Problem)| self.at(located.base + at, problem);
        let node = parse_property(&located.text).and_then(|node| self.expanded(node)).map_err(at)?;
        if self.law.is_some() {
            // The law knows the names; what is wrong is told for the first case.
            return Ok(Expression { node, base: located.base, inequalities: Vec::new(), bounds: Vec::new() });
        }
        let mut check = Check { question: self, moving: false, places: Vec::new() };
        check.expect(&node, is_truth).map_err(at)?;
        Ok(Expression { node, base: located.base, inequalities: Vec::new(), bounds: Vec::new() })
    }
}

/// What is wrong with numbers that have something else than commas between them.
fn without_commas(text: &str) -> Option<Problem> {
    let parts: Vec<&str> = text.split([' ', '\t', ';']).filter(|part| !part.is_empty()).collect();
    read_each(&parts.join(","))?;
    Some(Problem::expected(
        "a number for each follower with commas between, `0.6,0.5,1`,",
        format!("`{}`", shown(text)),
    ))
}
