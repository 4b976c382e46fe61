//! Questions about every state of every flock: `law = "FILE"` in the place of a scenario.

mod decide;
mod every;
mod identity;
mod inequality;
mod instance;
mod pairs;
mod search;

use crate::error::{Problem, QuestionError};
use crate::question::{Expression, Question};
use arithmetic::parse_rational;
use expressions::{Kind, LawError, LawText, Parameter};
use polynomials::Side;
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

pub(crate) use decide::{decide, decisive};

/// Most agents.
const MOST_AGENTS: usize = 64;

/// What the numbers of a part of the state range over.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Range {
    pub part: String,
    pub side: Side,
}

/// How something was proved for all states.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum How {
    /// By an identity modulo random primes; a wrong one passes with probability at most 2 to minus this.
    Identity(u64),
    /// Pair by pair.
    Pairs,
    /// By identities that are the same for every number of agents.
    EverySize,
    /// With one agent at 0, since nothing depends on where all are together.
    Moved,
    /// What was decided about a function on a domain, in its words.
    Decided(&'static str),
    /// At a single state.
    Point,
}

/// The networks of flocks of every size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Network {
    Complete,
    /// All in which those hear each other of whom one hears the other.
    Mutual,
}

/// The law of a question.
#[derive(Debug)]
pub(crate) struct LawFile {
    pub name: String,
    text: String,
    pub law: LawText,
    pub ranges: Vec<Range>,
    /// Where flocks of every size are meant, on which networks.
    pub every: Option<Network>,
    /// How the property was proved, of all cases together.
    how: Mutex<BTreeSet<How>>,
}

impl LawFile {
    /// Adds how a case was proved.
    pub fn note(&self, how: Vec<How>) {
        self.how.lock().unwrap_or_else(PoisonError::into_inner).extend(how);
    }

    /// The grades of what was proved, and how, in a sentence.
    pub fn told(&self) -> (Vec<&'static str>, String) {
        let how = self.how.lock().unwrap_or_else(PoisonError::into_inner);
        let bits = how.iter().find_map(|how| if let How::Identity(bits) = how { Some(*bits) } else { None });
        let (mut grades, mut parts) = (Vec::new(), Vec::new());
        if let Some(bits) = bits {
            grades.push("identity");
            parts.push(format!(
                "by identities modulo random primes, of which a wrong one passes with probability at most 2^-{bits}, functions that are not rational counted as unknown"
            ));
        }
        if how.contains(&How::Pairs) {
            parts.push("as a sum over pairs of agents of terms that are each of one sign".to_string());
        }
        if how.contains(&How::EverySize) {
            parts.push("for every number of agents, by as many of them as the orders of the sums ask for".to_string());
        }
        if how.contains(&How::Moved) {
            parts.push("with one agent at 0, since nothing depends on where all are together".to_string());
        }
        let decided: Vec<&str> =
            how.iter().filter_map(|how| if let How::Decided(words) = how { Some(*words) } else { None }).collect();
        if !decided.is_empty() {
            grades.push("certified");
            parts.push(format!("by {}", decided.join(", ")));
        }
        if how.contains(&How::Point) {
            grades.push("exact");
        }
        let sentence = if parts.is_empty() {
            String::new()
        } else {
            format!("Proved {}; wherever law and property have values.", parts.join("; "))
        };
        (grades, sentence)
    }

    /// Reads the file of a law.
    pub fn read(name: &str, text: &str) -> Result<Self, String> {
        let law = scenario::read_law(text).map_err(|error| format!("{name}: {error}"))?;
        // What is wrong with the law itself comes first; lists with one value for each agent are looked at with the flock.
        if let Err(error) = law.compile(MOST_AGENTS)
            && error.table != "parameters"
        {
            return Err(format!("{name}: {}", scenario::law_problem(text, error)));
        }
        Ok(LawFile {
            name: name.to_string(),
            text: text.to_string(),
            law,
            ranges: Vec::new(),
            every: None,
            how: Mutex::default(),
        })
    }

    /// Whether its agents are not alike: some are named by number, or there are parameters with one value for each.
    pub fn names_agents(&self) -> bool {
        let LawText { define, rates, observables, parameters, .. } = &self.law;
        let texts = define.iter().chain(rates).chain(observables).map(|(_, text)| text);
        parameters.iter().any(|(_, given)| matches!(given, Parameter::Each(_)))
            || texts.into_iter().any(|text| names_an_agent(text))
    }

    /// The law as one line, for the canonical form of a question.
    pub fn digest(&self) -> String {
        format!("{:?}", self.text)
    }

    /// Reads `agents = "any"` and `graph = "any"`: whether the entry is one of these.
    pub fn add_every(&mut self, name: &str, text: &str) -> bool {
        match (name, text.trim()) {
            ("agents", "any") => self.every = Some(self.every.unwrap_or(Network::Complete)),
            ("graph", "any") => self.every = Some(Network::Mutual),
            _ => return false,
        }
        true
    }

    /// What the flocks are, for the canonical form of a question.
    pub fn every_text(&self) -> Option<&'static str> {
        self.every.map(|network| match network {
            Network::Complete => "agents = any, complete",
            Network::Mutual => "agents = any, on every network without directions",
        })
    }

    /// Whether a name of `[for]` is a part of the state.
    pub fn is_part(&self, name: &str) -> bool {
        self.law.state.iter().any(|(part, _)| part == name)
    }

    /// Reads what the numbers of a part range over: `any`, or an interval.
    pub fn add_range(&mut self, part: &str, text: &str) -> Result<(), Problem> {
        let refuse = || Problem::expected("\"any\", or an interval such as \"[-2, 2]\"", format!("`{text}`"));
        let side = match text.trim() {
            "any" => Side::line(),
            other => {
                let inside = other.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).ok_or_else(refuse)?;
                let (lo, hi) = inside.split_once(',').ok_or_else(refuse)?;
                let (lo, hi) = (parse_rational(lo)?, parse_rational(hi)?);
                if lo > hi {
                    return Err(refuse());
                }
                Side::between(lo, hi)
            }
        };
        self.ranges.push(Range { part: part.to_string(), side });
        Ok(())
    }

    /// Whether a place such as `x[2].1` or `law.parameters.K` is there.
    pub fn has_place(&self, name: &str) -> bool {
        if let Some(parameter) = name.strip_prefix("law.parameters.") {
            return self.law.parameters.iter().any(|(known, _)| known == parameter);
        }
        let Some((part, agent, component)) = place(name) else { return false };
        let Some((_, kind)) = self.law.state.iter().find(|(known, _)| known == part) else { return false };
        let width = if *kind == Kind::Vector { self.law.dimension } else { 1 };
        agent > 0 && component.map_or(width == 1, |k| width > 1 && (1..=width).contains(&k))
    }

    /// What is wrong with a law, or with a property.
    pub fn refused(&self, question: &Question, expression: &Expression, error: LawError) -> QuestionError {
        if error.table == "property" {
            return question.at(expression.base + error.at.unwrap_or(0), error.problem.into());
        }
        let told = scenario::law_problem(&self.text, error);
        question.at(expression.base, Problem::Other(format!("{}: {told}", self.name)))
    }
}

/// Whether a text speaks of an agent by its number, as in `x[2]`.
pub(crate) fn names_an_agent(text: &str) -> bool {
    text.split('[').skip(1).any(|rest| rest.trim_start().starts_with(|c: char| c.is_ascii_digit()))
}

/// `x[2].1` as part, agent and component, from 1.
pub(crate) fn place(name: &str) -> Option<(&str, usize, Option<usize>)> {
    let (part, rest) = name.split_once('[')?;
    let (agent, rest) = rest.split_once(']')?;
    let component = match rest {
        "" => None,
        rest => Some(rest.strip_prefix('.')?.parse().ok()?),
    };
    Some((part, agent.parse().ok()?, component))
}
