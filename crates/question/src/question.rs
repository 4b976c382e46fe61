//! A question as its file states it; `read` reads it, `check` checks its names, `count` goes through its members.

mod check;
mod count;
mod read;
mod used;

use crate::definitions::Definition;
use crate::domain::{Bound, Classes, Domain, Members, Sort};
use crate::error::{Place, Problem, QuestionError};
use crate::failure::Failure;
use crate::given::Given;
use crate::names::{FUNCTIONS, Subject, quantities, quantity_of};
use crate::scenario_file::ScenarioFile;
use crate::states::{LawFile, names_an_agent};
use crate::syntax::Node;
use algebra::graph::LaplacianKind;
use arithmetic::{Rational, rational};
use models::platoon::{Communication, Parameter};
use std::fmt::Write;
use std::sync::{Arc, OnceLock};

/// An expression with the byte of the file where it starts.
#[derive(Debug, Clone)]
pub(crate) struct Expression {
    pub node: Node,
    pub base: usize,
    /// Of the property, its inequalities one by one; of what needs no margins, none.
    pub inequalities: Vec<Node>,
    /// Of a property without controls, the bounds that may be made sharper, where they decide; without those that are inequalities of it, or it itself.
    pub bounds: Vec<Node>,
}

impl Expression {
    /// One that needs no margins, at the place of another.
    pub fn like(other: &Expression, node: Node) -> Self {
        Expression { node, base: other.base, inequalities: Vec::new(), bounds: Vec::new() }
    }

    /// The parts that have margins of their own: its inequalities, then its bounds.
    pub fn measured(&self) -> impl Iterator<Item = &Node> {
        self.inequalities.iter().chain(&self.bounds)
    }

    /// Which of them it is; `Some(None)` where it is the whole.
    pub fn place(&self, part: &Node) -> Option<Option<usize>> {
        if part.kind == self.node.kind {
            return Some(None);
        }
        self.measured().position(|own| own.kind == part.kind).map(Some)
    }
}

/// A row of `[values]`.
#[derive(Debug)]
pub(crate) struct Asked {
    pub name: String,
    pub expression: Expression,
    /// Whether it is true or false rather than a number.
    pub is_truth: bool,
}

/// Most members that are gone through without being asked.
const BUDGET: u64 = 1_000_000;

/// A statement of one's own with what it ranges over.
#[derive(Debug)]
pub struct Question {
    text: String,
    id: String,
    statement: Option<String>,
    scenario: Option<ScenarioFile>,
    law: Option<LawFile>,
    kind: LaplacianKind,
    communication: Communication,
    budget: u64,
    pub(crate) bounds: Vec<Bound>,
    pub(crate) restriction: Option<Expression>,
    pub(crate) property: Option<Expression>,
    pub(crate) controls: Vec<Expression>,
    values: Vec<Asked>,
    /// The byte where `[values]` begins.
    values_at: usize,
    subjects: Vec<Subject>,
    definitions: Vec<Definition>,
    given: Vec<Given>,
    classes: Classes,
    /// Members of the names that depend on no other.
    alone: Vec<OnceLock<Arc<Members>>>,
    starts: OnceLock<Vec<u64>>,
    /// Whether sums of squares are looked for first, so that as much as possible has a certificate.
    pub certified: bool,
    /// How many counterexamples are listed; 0 where none beside the one that decides are.
    pub listed_counterexamples: u64,
    /// How many members are listed at which an inequality of the property is an equation; 0 where none are.
    pub listed_tight: u64,
}

impl Question {
    /// A problem at a byte of the file.
    pub(crate) fn at(&self, byte: usize, problem: Problem) -> QuestionError {
        QuestionError::At { place: Place::of(&self.text, byte), problem }
    }

    /// Whether a name stands for something by itself: it is bound, a quantity, a function.
    pub(crate) fn is_known(&self, name: &str) -> bool {
        let is_quantity = || quantity_of(name.rsplit('.').next().unwrap_or(name), self.subjects()).is_some();
        let is_function = FUNCTIONS.iter().any(|function| function.name == name);
        self.sort(name).is_some() || is_function || is_quantity() || self.given(name).is_some()
    }

    /// The function of a graph of that name that the program was given.
    pub(crate) fn given(&self, name: &str) -> Option<&Given> {
        self.given.iter().find(|given| given.name == name.rsplit('.').next().unwrap_or(name))
    }

    /// The names of functions that gave floating-point numbers, on which no proof rests.
    pub(crate) fn float_names(&self) -> Vec<&str> {
        self.given.iter().filter(|given| given.was_float()).map(|given| given.name.as_str()).collect()
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
            Some(scenario) if scenario.is_flock() => subjects.push(Subject::Flock),
            Some(_) => subjects.push(Subject::Motion),
            None => {}
        }
        let bound = |parameter: Parameter| self.sort(parameter.name()).is_some();
        let links = |sides: [Parameter; 2]| sides.into_iter().all(bound);
        let f = bound(Parameter::F) || links([Parameter::FAhead, Parameter::FBehind]);
        let g = bound(Parameter::G) || links([Parameter::GAhead, Parameter::GBehind]);
        if f && g && (self.sort("followers").is_some() || has(Sort::Graph)) {
            subjects.push(Subject::Platoon);
        }
        subjects
    }

    /// All names that an expression of this question may use.
    pub(crate) fn known_names(&self) -> Vec<String> {
        let bound = self.bounds.iter().map(|bound| bound.name.to_string());
        let functions = FUNCTIONS.iter().map(|function| function.name.to_string());
        let own = quantities().iter().filter(|quantity| self.subjects.contains(&quantity.subject));
        let given = self.given.iter().map(|given| given.name.clone());
        bound.chain(own.map(|quantity| quantity.name.to_string())).chain(given).chain(functions).collect()
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

    /// Whether it is about all states of a law and agents are not alike in it: they are named by number, or have parameters or starts of their own.
    pub(crate) fn names_agents(&self) -> bool {
        let Some(law) = &self.law else { return false };
        let asked = self.property.iter().chain(&self.controls).any(|asked| names_an_agent(&asked.node.to_string()));
        asked || law.names_agents() || self.bounds.iter().any(|bound| names_an_agent(&bound.name))
    }

    /// The law whose states the question is about, where there is one.
    pub(crate) fn law(&self) -> Option<&LawFile> {
        self.law.as_ref()
    }

    /// The file of the law as the question names it, where there is one.
    pub fn law_name(&self) -> Option<&str> {
        self.law.as_ref().map(|law| law.name.as_str())
    }

    /// The byte where `[for]` binds its first name.
    pub(crate) fn for_place(&self) -> usize {
        self.bounds.first().map_or(0, |bound| bound.key_at)
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

    /// The property to decide.
    pub(crate) fn asked(&self) -> Result<&Expression, QuestionError> {
        self.property.as_ref().ok_or_else(|| {
            let only_values =
                "there is no section [holds], so that there is nothing to decide; `sweep` tabulates [values]";
            self.at(self.values_at, Problem::Other(only_values.to_string()))
        })
    }

    /// Where `[values]` begins; the start of the file where there is none.
    pub fn values_place(&self) -> Place {
        Place::of(&self.text, self.values_at)
    }

    /// The inequalities of the property one by one, as texts, under the time operators around them.
    pub fn inequality_texts(&self) -> Vec<String> {
        self.property.iter().flat_map(|property| &property.inequalities).map(ToString::to_string).collect()
    }

    /// The names of the section `[values]` with their expressions, in order.
    pub fn value_names(&self) -> impl Iterator<Item = &str> {
        self.values.iter().map(|own| own.name.as_str())
    }

    pub(crate) fn asked_values(&self) -> &[Asked] {
        &self.values
    }

    /// Whether it is the name of a number of the law of one's own that its scenario has.
    pub(crate) fn is_own(&self, name: &str) -> bool {
        self.scenario.as_ref().is_some_and(|scenario| scenario.is_own(name))
    }

    /// The names of the section `[for]`, in order.
    pub fn bound_names(&self) -> impl Iterator<Item = &str> {
        self.bounds.iter().map(|bound| bound.name.as_ref())
    }

    /// That a list of TOML is a family, for who means one number for each car: where it has as many numbers as there are followers.
    pub(crate) fn like_cars(&self, followers: &Rational) -> Option<String> {
        let count = |list: &Vec<(usize, Domain)>| *followers == rational(list.len() as i64, 1);
        let is_one = |bound: &&Bound| {
            let numbers = matches!(bound.domain.sort(), Some(Sort::Integer | Sort::Number));
            let list = matches!(&bound.domain, Domain::List(list) if list.len() > 1 && count(list));
            numbers && list && Parameter::from_name(&bound.name).is_some()
        };
        let name = &self.bounds.iter().find(is_one)?.name;
        Some(format!(
            "The list of `{name}` makes {followers} platoons, each with one of its numbers; one number for each of the {followers} followers is `{name} = \"each:..\"`."
        ))
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
        if let Some(law) = &self.law {
            let _ = writeln!(text, "law = {}", law.digest());
        }
        let _ = writeln!(text, "budget = {}\n[for]", self.budget);
        for range in self.law.iter().flat_map(|law| &law.ranges) {
            let ends = match (&range.side.lo, &range.side.hi) {
                (Some(lo), Some(hi)) => format!("[{lo}, {hi}]"),
                _ => "any".to_string(),
            };
            let _ = writeln!(text, "{} = {ends}", range.part);
        }
        if let Some(every) = self.law.as_ref().and_then(LawFile::every_text) {
            let _ = writeln!(text, "{every}");
        }
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
        for Asked { name, expression, .. } in &self.values {
            let _ = writeln!(text, "{name} = {}", expression.node);
        }
        text
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
