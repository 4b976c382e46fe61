//! A question as its file states it: read, checked, and gone through case by case.

use crate::bindings::{Bindings, Value};
use crate::case::unknown_quantity;
use crate::error::{Place, Problem, QuestionError};
use crate::evaluate::{Failure, quantity_of};
use crate::family::{Bound, Classes, Domain, Maker, Members, Sort, read_domain};
use crate::names::{FAMILIES, FUNCTIONS, QUANTITIES, Subject};
use crate::scenario_file::{ScenarioFile, is_place};
use crate::source::{Entry, Section, Source};
use crate::syntax::{KEYWORDS, Kind, Node, parse_property};
use algebra::graph::LaplacianKind;
use arithmetic::{Progress, shown};
use models::platoon::Communication;
use std::fmt::Write;
use std::sync::{Arc, OnceLock};

/// Gives the text of a file that a question names, or why there is none.
pub type Files<'a> = &'a dyn Fn(&str) -> Result<String, String>;

/// An expression with the byte of the file where it starts.
#[derive(Debug, Clone)]
pub(crate) struct Expression {
    pub node: Node,
    pub base: usize,
}

/// Most members that are gone through without being asked.
const BUDGET: u64 = 1_000_000;

/// Largest budget.
const LARGEST_BUDGET: u64 = 1_000_000_000;

/// A statement of one's own with what it ranges over.
#[derive(Debug)]
pub struct Question {
    text: String,
    id: String,
    statement: Option<String>,
    scenario: Option<ScenarioFile>,
    kind: LaplacianKind,
    communication: Communication,
    budget: u64,
    pub(crate) bounds: Vec<Bound>,
    pub(crate) restriction: Option<Expression>,
    pub(crate) property: Option<Expression>,
    pub(crate) controls: Vec<Expression>,
    values: Vec<(String, Expression)>,
    subjects: Vec<Subject>,
    classes: Classes,
    /// Members of the names that depend on no other.
    alone: Vec<OnceLock<Arc<Members>>>,
    starts: OnceLock<Vec<u64>>,
}

const SECTIONS: [&str; 4] = ["question", "for", "holds", "values"];

impl Question {
    /// Reads a question. `files` gives the text of the files that it names.
    ///
    /// # Errors
    /// [`QuestionError`] with line and column.
    pub fn read(text: &str, files: Files) -> Result<Self, QuestionError> {
        let source = Source::parse(text)?;
        let sections = source.sections(&SECTIONS)?;
        let [head, family, holds, values] = &sections[..] else {
            return Err(QuestionError::Whole(Problem::Other("the sections could not be read".to_string())));
        };
        let mut question = Question::headed(text, head.as_ref(), files)?;
        if let Some(family) = family {
            question.read_family(family, files)?;
        }
        question.alone = question.bounds.iter().map(|_| OnceLock::new()).collect();
        question.subjects = question.found_subjects();
        if let Some(holds) = holds {
            question.read_holds(holds)?;
        }
        if let Some(values) = values {
            question.read_values(values)?;
        }
        if question.property.is_none() && question.values.is_empty() {
            let needed = "a question has a section [holds] with a property, or a section [values]";
            return Err(QuestionError::Whole(Problem::Other(needed.to_string())));
        }
        Ok(question)
    }

    fn headed(text: &str, head: Option<&Section>, files: Files) -> Result<Self, QuestionError> {
        let missing = || Problem::Other("the section [question] is missing; it needs an `id`".to_string());
        let head = head.ok_or_else(|| QuestionError::Whole(missing()))?;
        head.allow(&["id", "statement", "scenario", "kind", "communication", "budget"])?;
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
                LaplacianKind::NAMES[chosen(&entry, "kind of matrix", names)?].1
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
                let read = files(&name).and_then(|content| ScenarioFile::read(&name, &content));
                Some(read.map_err(|message| entry.problem(Problem::Other(message)))?)
            }
        };
        let statement = head.get("statement").map(|entry| entry.text()).transpose()?.map(|located| located.text);
        Ok(Question {
            text: text.to_string(),
            id: id_text,
            statement,
            scenario,
            kind,
            communication,
            budget,
            bounds: Vec::new(),
            restriction: None,
            property: None,
            controls: Vec::new(),
            values: Vec::new(),
            subjects: Vec::new(),
            classes: Classes::default(),
            alone: Vec::new(),
            starts: OnceLock::new(),
        })
    }

    fn read_family(&mut self, section: &Section, files: Files) -> Result<(), QuestionError> {
        let mut restriction = None;
        for entry in section.entries() {
            if entry.key == "where" {
                restriction = Some(entry);
                continue;
            }
            self.check_new_name(&entry)?;
            let text_of = |entry: &Entry| {
                let located = entry.text()?;
                let domain = read_domain(&located.text, files);
                let domain = domain.map_err(|(at, problem)| self.at(located.base + at, problem))?;
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
            let bound = Bound { name: Arc::from(entry.key.as_str()), domain, base };
            self.check_domain(&bound.domain, bound.base)?;
            if bound.domain.sort().is_none() {
                let expected = "a list of numbers, of graphs or of matrices";
                return Err(self.at(bound.base, Problem::expected(expected, "of different sorts")));
            }
            self.bounds.push(bound);
        }
        if let Some(entry) = restriction {
            self.subjects = self.found_subjects();
            self.restriction = Some(self.expression(&entry, true)?);
        }
        Ok(())
    }

    fn check_new_name(&self, entry: &Entry) -> Result<(), QuestionError> {
        let name = entry.key.as_str();
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
        self.property = Some(self.expression(&property, true)?);
        let controls = section.get("controls").map(|entry| entry.items()).unwrap_or_default();
        if controls.is_empty() {
            return Err(QuestionError::Whole(Problem::NoControls));
        }
        for entry in &controls {
            let control = self.expression(entry, true)?;
            let same = |other: &Expression| other.node.to_string() == control.node.to_string();
            if self.property.as_ref().is_some_and(same) {
                return Err(entry.problem(Problem::Other("the control is the property itself".to_string())));
            }
            self.controls.push(control);
        }
        Ok(())
    }

    fn read_values(&mut self, section: &Section) -> Result<(), QuestionError> {
        for entry in section.entries() {
            let expression = self.expression(&entry, false)?;
            self.values.push((entry.key, expression));
        }
        Ok(())
    }

    /// Reads and checks an expression.
    fn expression(&self, entry: &Entry, is_truth: bool) -> Result<Expression, QuestionError> {
        let located = entry.text()?;
        let at = |(at, problem): (usize, Problem)| self.at(located.base + at, problem);
        let node = parse_property(&located.text).map_err(at)?;
        let mut check = Check { question: self, moving: false };
        check.expect(&node, is_truth).map_err(at)?;
        Ok(Expression { node, base: located.base })
    }

    /// A problem at a byte of the file.
    pub(crate) fn at(&self, byte: usize, problem: Problem) -> QuestionError {
        QuestionError::At { place: Place::of(&self.text, byte), problem }
    }

    /// Names in a family are those bound before, functions, and the families.
    fn check_domain(&self, domain: &Domain, base: usize) -> Result<(), QuestionError> {
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
                return Err(at((node.at, Problem::unknown("family", name, known))));
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

    /// The sort of a bound name.
    pub(crate) fn sort(&self, name: &str) -> Option<Sort> {
        self.bounds.iter().find(|bound| bound.name.as_ref() == name).and_then(|bound| bound.domain.sort())
    }

    fn found_subjects(&self) -> Vec<Subject> {
        let has = |sort: Sort| self.bounds.iter().any(|bound| bound.domain.sort() == Some(sort));
        let mut subjects = Vec::new();
        if has(Sort::Graph) {
            subjects.push(Subject::Graph);
        }
        if has(Sort::Matrices) {
            subjects.push(Subject::Matrices);
        }
        match &self.scenario {
            Some(scenario) if scenario.is_flock => subjects.push(Subject::Flock),
            Some(_) => subjects.push(Subject::Motion),
            None => {}
        }
        let gains = self.sort("f").is_some() && self.sort("g").is_some();
        if gains && (self.sort("followers").is_some() || has(Sort::Graph)) {
            subjects.push(Subject::Platoon);
        }
        subjects
    }

    /// All names that an expression of this question may use.
    pub(crate) fn known_names(&self) -> Vec<String> {
        let bound = self.bounds.iter().map(|bound| bound.name.to_string());
        let functions = FUNCTIONS.iter().map(|function| function.name.to_string());
        let own = QUANTITIES.iter().filter(|quantity| self.subjects.contains(&quantity.subject));
        bound.chain(own.map(|quantity| quantity.name.to_string())).chain(functions).collect()
    }

    /// What quantities are measured on.
    pub(crate) fn subjects(&self) -> &[Subject] {
        &self.subjects
    }

    pub(crate) fn kind(&self) -> LaplacianKind {
        self.kind
    }

    /// The text that was read.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Which cars a follower tracks.
    pub fn communication(&self) -> Communication {
        self.communication
    }

    /// The file of the scenario as the question names it, where there is one.
    pub fn scenario_name(&self) -> Option<&str> {
        self.scenario.as_ref().map(|scenario| scenario.name.as_str())
    }

    pub(crate) fn scenario(&self) -> Option<&ScenarioFile> {
        self.scenario.as_ref()
    }

    pub(crate) fn classes(&self) -> &Classes {
        &self.classes
    }

    /// Most members that are gone through, and most boxes that a continuum is divided into.
    pub fn budget(&self) -> u64 {
        self.budget
    }

    /// The id.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// The statement in words, where there is one.
    pub fn statement(&self) -> Option<&str> {
        self.statement.as_deref()
    }

    /// Whether there is a property to decide.
    pub fn has_property(&self) -> bool {
        self.property.is_some()
    }

    /// The names of the section `[values]` with their expressions, in order.
    pub fn value_names(&self) -> impl Iterator<Item = &str> {
        self.values.iter().map(|(name, _)| name.as_str())
    }

    pub(crate) fn value_expressions(&self) -> &[(String, Expression)] {
        &self.values
    }

    /// The names of the section `[for]`, in order.
    pub fn bound_names(&self) -> impl Iterator<Item = &str> {
        self.bounds.iter().map(|bound| bound.name.as_ref())
    }

    /// Whether the members are drawn at random, so that they never prove anything for all.
    pub fn is_sample(&self) -> bool {
        let drawn = self.scenario.as_ref().is_some_and(ScenarioFile::is_drawn);
        drawn && self.sort("seed").is_some() || self.bounds.iter().any(|bound| bound.domain.is_sample())
    }

    /// The question in one form, whatever the spaces, comments and numbers of its file look like: equal questions have equal texts.
    pub fn canonical(&self) -> String {
        let mut text = format!("[question]\nid = {}\n", self.id);
        let _ = writeln!(text, "kind = {}", self.kind.name());
        let front = matches!(self.communication, Communication::Front);
        let _ = writeln!(text, "communication = {}", if front { "front" } else { "front-and-back" });
        if let Some(scenario) = &self.scenario {
            let _ = writeln!(text, "scenario = {}", scenario.digest());
        }
        let _ = writeln!(text, "budget = {}\n[for]", self.budget);
        for bound in &self.bounds {
            let _ = writeln!(text, "{} = {}", bound.name, domain_text(&bound.domain));
        }
        if let Some(restriction) = &self.restriction {
            let _ = writeln!(text, "where = {}", restriction.node);
        }
        if let Some(property) = &self.property {
            let _ = writeln!(text, "[holds]\nproperty = {}", property.node);
        }
        for control in &self.controls {
            let _ = writeln!(text, "control = {}", control.node);
        }
        if !self.values.is_empty() {
            let _ = writeln!(text, "[values]");
        }
        for (name, expression) in &self.values {
            let _ = writeln!(text, "{name} = {}", expression.node);
        }
        text
    }

    /// Number of members of the family, a continuum counting as one; those that `where` leaves out are counted, too.
    ///
    /// # Errors
    /// [`QuestionError`] where a family is wrong, empty, or larger than the budget.
    pub fn cases(&self, progress: &dyn Progress) -> Result<u64, QuestionError> {
        let starts = self.starts(progress)?;
        let total = starts.last().copied().unwrap_or(1);
        if total == 0 {
            let empty = self.bounds.first().map_or(0, |bound| bound.base);
            return Err(self.at(empty, Problem::Empty("no member has all the names bound".to_string())));
        }
        if total > self.budget {
            let base = self.bounds.first().map_or(0, |bound| bound.base);
            return Err(self.at(base, Problem::TooMany { size: at_least(total), budget: self.budget }));
        }
        Ok(total)
    }

    /// How many members come before each member of the first name, and in all.
    fn starts(&self, progress: &dyn Progress) -> Result<&[u64], QuestionError> {
        if let Some(known) = self.starts.get() {
            return Ok(known);
        }
        let mut bindings = Bindings::default();
        let mut starts = vec![0];
        match self.bounds.first() {
            None => starts = vec![0, 1],
            Some(first) => {
                let members = self.members(0, &bindings, progress)?;
                let later = self.later_depend_on(0);
                let size = members.len();
                if !later || size == 0 {
                    let each = match members.get(0) {
                        Some(value) => self.counted_with(0, &first.name, value, &mut bindings, progress)?,
                        None => 0,
                    };
                    starts.push(each.saturating_mul(size));
                } else {
                    let mut total = 0u64;
                    for k in 0..size {
                        let Some(value) = members.get(k) else { break };
                        total =
                            total.saturating_add(self.counted_with(0, &first.name, value, &mut bindings, progress)?);
                        starts.push(total);
                        if total > self.budget {
                            break;
                        }
                    }
                }
            }
        }
        Ok(self.starts.get_or_init(|| starts))
    }

    fn counted_with(
        &self,
        place: usize,
        name: &Arc<str>,
        value: Value,
        bindings: &mut Bindings,
        progress: &dyn Progress,
    ) -> Result<u64, QuestionError> {
        bindings.push(name.clone(), value);
        let count = self.counted(place + 1, bindings, progress);
        bindings.pop();
        count
    }

    /// Members of the names from a place on, given the earlier ones; no more than a little above the budget are counted.
    fn counted(&self, place: usize, bindings: &mut Bindings, progress: &dyn Progress) -> Result<u64, QuestionError> {
        let Some(bound) = self.bounds.get(place) else { return Ok(1) };
        let members = self.members(place, bindings, progress)?;
        let size = members.len();
        if place + 1 == self.bounds.len() || size == 0 {
            return Ok(size);
        }
        if !self.later_depend_on(place) {
            let Some(value) = members.get(0) else { return Ok(0) };
            return Ok(self.counted_with(place, &bound.name, value, bindings, progress)?.saturating_mul(size));
        }
        let mut total = 0u64;
        for k in 0..size {
            let Some(value) = members.get(k) else { break };
            total = total.saturating_add(self.counted_with(place, &bound.name, value, bindings, progress)?);
            if total > self.budget {
                break;
            }
        }
        Ok(total)
    }

    pub(crate) fn members(
        &self,
        place: usize,
        bindings: &Bindings,
        progress: &dyn Progress,
    ) -> Result<Arc<Members>, QuestionError> {
        progress.checkpoint()?;
        let bound = &self.bounds[place];
        let cell = self.alone.get(place).filter(|_| is_alone(&bound.domain));
        if let Some(known) = cell.and_then(OnceLock::get) {
            return Ok(known.clone());
        }
        let made = Maker { question: self, bindings, progress }.members(&bound.domain);
        let made = Arc::new(made.map_err(|failure| self.refused(failure, bound.base))?);
        Ok(cell.map_or(made.clone(), |cell| cell.get_or_init(|| made).clone()))
    }

    /// Whether what a later name ranges over may depend on this one.
    fn later_depend_on(&self, place: usize) -> bool {
        let name = self.bounds[place].name.as_ref();
        self.bounds[place + 1..].iter().any(|bound| mentions(&bound.domain, name))
    }

    /// The member of that number, counted from 0, as [`Question::cases`] counts them.
    ///
    /// # Errors
    /// [`QuestionError`] where a family is wrong.
    pub fn case(&self, number: u64, progress: &dyn Progress) -> Result<Option<Bindings>, QuestionError> {
        let starts = self.starts(progress)?;
        let mut bindings = Bindings::default();
        let Some(first) = self.bounds.first() else { return Ok((number == 0).then_some(bindings)) };
        if starts.last().is_none_or(|total| number >= *total) {
            return Ok(None);
        }
        let members = self.members(0, &bindings, progress)?;
        let (place, within) = if starts.len() as u64 == members.len() + 1 {
            let place = starts.partition_point(|start| *start <= number) - 1;
            (place as u64, number - starts[place])
        } else {
            let each = starts.last().map_or(1, |total| total / members.len().max(1)).max(1);
            (number / each, number % each)
        };
        let Some(value) = members.get(place) else { return Ok(None) };
        bindings.push(first.name.clone(), value);
        self.descend(1, within, bindings, progress)
    }

    fn descend(
        &self,
        place: usize,
        number: u64,
        mut bindings: Bindings,
        progress: &dyn Progress,
    ) -> Result<Option<Bindings>, QuestionError> {
        let Some(bound) = self.bounds.get(place) else { return Ok(Some(bindings)) };
        let members = self.members(place, &bindings, progress)?;
        let mut left = number;
        let independent = place + 1 < self.bounds.len() && !self.later_depend_on(place);
        if place + 1 == self.bounds.len() || independent {
            let each = match members.get(0) {
                Some(value) if independent => self.counted_with(place, &bound.name, value, &mut bindings, progress)?,
                _ => 1,
            };
            let Some(value) = members.get(left / each.max(1)) else { return Ok(None) };
            bindings.push(bound.name.clone(), value);
            return self.descend(place + 1, left % each.max(1), bindings, progress);
        }
        for k in 0..members.len() {
            let Some(value) = members.get(k) else { break };
            let count = self.counted_with(place, &bound.name, value.clone(), &mut bindings, progress)?;
            if left < count {
                bindings.push(bound.name.clone(), value);
                return self.descend(place + 1, left, bindings, progress);
            }
            left -= count;
        }
        Ok(None)
    }

    /// What a failure means for the question as a whole.
    pub(crate) fn refused(&self, failure: Failure, base: usize) -> QuestionError {
        match failure {
            Failure::Refused(at, problem) => self.at(base + at, problem),
            Failure::Open(doubt) => self.at(base, Problem::Other(doubt.why)),
            Failure::Cancelled => QuestionError::Cancelled(arithmetic::Cancelled),
        }
    }
}

/// A count that stopped soon after the budget.
fn at_least(total: u64) -> String {
    if total == u64::MAX { "more than 10^19".to_string() } else { format!("at least {total}") }
}

fn domain_text(domain: &Domain) -> String {
    match domain {
        Domain::Written(node) => node.to_string(),
        Domain::Given(value) => value.text(),
        Domain::List(list) => {
            let items: Vec<String> = list.iter().map(|(_, domain)| domain_text(domain)).collect();
            format!("{{{}}}", items.join("; "))
        }
    }
}

/// Whether a domain uses no other name.
fn is_alone(domain: &Domain) -> bool {
    match domain {
        Domain::Given(_) => true,
        Domain::List(list) => list.iter().all(|(_, domain)| is_alone(domain)),
        Domain::Written(node) => {
            let mut alone = !domain.is_sample();
            node.visit(&mut |inner| {
                // The family itself has brackets.
                alone &= !matches!(&inner.kind, Kind::Name { called: false, .. });
            });
            alone
        }
    }
}

/// Whether a domain uses a name.
fn mentions(domain: &Domain, name: &str) -> bool {
    match domain {
        Domain::Given(_) => false,
        Domain::List(list) => list.iter().any(|(_, domain)| mentions(domain, name)),
        Domain::Written(node) => {
            // Random families use the seed without naming it, but give one member for each.
            let mut found = false;
            node.visit(&mut |node| {
                found |= matches!(&node.kind, Kind::Name { name: used, .. } if used == name);
            });
            found
        }
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
struct Check<'q> {
    question: &'q Question,
    /// Inside a time operator or `initial`.
    moving: bool,
}

type Checked = Result<(), (usize, Problem)>;

impl Check<'_> {
    fn expect(&mut self, node: &Node, is_truth: bool) -> Checked {
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

    fn timed(&mut self, node: &Node, word: &'static str, from: &Node, to: &Node, bodies: &[&Node]) -> Checked {
        let subjects = self.question.subjects();
        if !subjects.iter().any(|subject| matches!(subject, Subject::Flock | Subject::Motion)) {
            return Err((node.at, Problem::Static(word)));
        }
        self.expect(from, false)?;
        if matches!(to.kind, Kind::Infinity) {
            if !subjects.contains(&Subject::Flock) {
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
        let quantity = quantity_of(own_name, self.question.subjects());
        let quantity = quantity.ok_or_else(|| at(unknown_quantity(owner, own_name, &known)))?;
        self.owner(owner, name, quantity.subject).map_err(at)?;
        let optional = quantity.name == "order" && arguments.is_empty();
        let count = quantity.arguments.len();
        if !optional {
            check_count(name, (count, count), arguments.len()).map_err(at)?;
        }
        for (argument, what) in arguments.iter().zip(quantity.arguments) {
            self.expect(argument, false)?;
            if matches!(*what, "k" | "m") {
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
