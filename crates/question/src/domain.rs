//! What the names of `[for]` range over, as it is written, and the members that were made of it.

use crate::bindings::Value;
use crate::error::Problem;
use crate::names::FAMILIES;
use crate::syntax::{Kind, Located, Node, parse_domain};
use algebra::graph::{AnyGraph, GraphTextError, NamedGraph};
use algebra::matrix::{StochasticMatrix, read::read_sequence};
use arithmetic::{Rational, parse_rational, rational};
use models::platoon::read_numbers;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

/// What a name ranges over, as it is written.
#[derive(Debug, Clone)]
pub(crate) enum Domain {
    /// Something made of earlier names: integers, intervals, classes of graphs, one number.
    Written(Node),
    /// A graph or matrices that are given.
    Given(Value),
    /// The members of several.
    List(Vec<(usize, Domain)>),
}

/// A name with what it ranges over and the byte of the file where that is written.
#[derive(Debug, Clone)]
pub(crate) struct Bound {
    pub name: Arc<str>,
    pub domain: Domain,
    pub base: usize,
    /// The byte where the name stands.
    pub key_at: usize,
}

/// What sort of thing a name stands for, as far as that is known without looking at members.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sort {
    Integer,
    Number,
    Box,
    Graph,
    Matrices,
    /// A number for each follower of a platoon.
    Each,
}

/// Reads what a text ranges over; `files` gives the text of a file by its name.
pub(crate) fn read_domain(text: &str, files: &dyn Fn(&str) -> Result<String, String>) -> Result<Domain, Located> {
    let trimmed = text.trim();
    if trimmed == "any" {
        return Ok(Domain::Given(Value::Any));
    }
    let other = |message: String| (0, Problem::Other(message));
    if let Some(name) = trimmed.strip_prefix("file:") {
        let content = files(name).map_err(other)?;
        return read_file(name, &content).map_err(other);
    }
    if let Some(rest) = trimmed.strip_prefix("matrices:") {
        return read_matrices(rest).map(|list| Domain::Given(Value::Matrices(Arc::new(list)))).map_err(other);
    }
    if trimmed.starts_with("each:") {
        let list = read_numbers(trimmed).map_err(|error| other(error.to_string()))?;
        return Ok(Domain::Given(Value::Each(Arc::new(list))));
    }
    // A graph by its name, or by its edges; of the names without a colon only those that are known.
    if trimmed.contains(':') || trimmed.starts_with(">>") || trimmed.parse::<NamedGraph>().is_ok() {
        let graph: AnyGraph =
            text.parse().map_err(|error: GraphTextError| (error.at(), Problem::Other(error.to_string())))?;
        return Ok(Domain::Given(Value::Graph(Arc::new(graph))));
    }
    parse_domain(text).map(Domain::Written)
}

/// Numbers of a platoon, one for each follower, without the word `each:`: two or more with commas, or three or more in brackets, since two in brackets are an interval.
pub(crate) fn read_each(text: &str) -> Option<Domain> {
    let list = read_numbers(text).ok()?;
    let least = if text.trim_start().starts_with('[') { 3 } else { 2 };
    (list.len() >= least).then(|| Domain::Given(Value::Each(Arc::new(list))))
}

/// A graph, several of them, or a sequence of matrices where it is none.
fn read_file(name: &str, text: &str) -> Result<Domain, String> {
    let error = match AnyGraph::read_file(text, false) {
        Ok(graphs) => {
            let mut given = graphs.into_iter().map(|graph| Domain::Given(Value::Graph(Arc::new(graph))));
            return Ok(match (given.next(), given.len()) {
                (Some(only), 0) => only,
                (first, _) => Domain::List(first.into_iter().chain(given).map(|graph| (0, graph)).collect()),
            });
        }
        Err(error) => error,
    };
    match read_sequence(text) {
        Ok(list) => Ok(Domain::Given(Value::Matrices(Arc::new(list)))),
        Err(other) => Err(format!("{name}: neither a graph ({error}) nor stochastic matrices ({other})")),
    }
}

fn read_matrices(text: &str) -> Result<Vec<StochasticMatrix>, String> {
    let number = |word: &str| parse_rational(word).map_err(|error| error.to_string());
    let row = |row: &str| row.split_whitespace().map(number).collect::<Result<Vec<Rational>, String>>();
    let matrix = |text: &str| {
        let rows = text.split(';').map(row).collect::<Result<Vec<_>, String>>()?;
        StochasticMatrix::from_rows(&rows).map_err(|error| error.to_string())
    };
    text.split('|').map(matrix).collect()
}

impl Domain {
    /// What sort its members are; `None` for a list of different sorts, or an unknown form.
    pub fn sort(&self) -> Option<Sort> {
        match self {
            Domain::Given(Value::Graph(_)) => Some(Sort::Graph),
            Domain::Given(Value::Matrices(_)) => Some(Sort::Matrices),
            Domain::Given(Value::Each(_)) => Some(Sort::Each),
            Domain::Given(Value::Number(_)) => Some(Sort::Number),
            Domain::Given(Value::Box(..) | Value::Integers(..) | Value::Any) => Some(Sort::Box),
            Domain::List(list) => {
                let mut sorts = list.iter().map(|(_, domain)| domain.sort());
                let first = sorts.next()??;
                sorts.try_fold(first, |sort, next| match (sort, next?) {
                    (a, b) if a == b => Some(a),
                    (Sort::Integer, Sort::Number) | (Sort::Number, Sort::Integer) => Some(Sort::Number),
                    _ => None,
                })
            }
            Domain::Written(node) => match &node.kind {
                Kind::Range(..) => Some(Sort::Integer),
                Kind::Interval(..) => Some(Sort::Box),
                Kind::Number(q) if q.is_integer() => Some(Sort::Integer),
                Kind::Name { name, called: true, .. } => match name.as_str() {
                    "stochastic" | "products" | "joined" | "random_products" => Some(Sort::Matrices),
                    "integers" => Some(Sort::Box),
                    name if FAMILIES.iter().any(|family| family.name == name) => Some(Sort::Graph),
                    _ => Some(Sort::Number),
                },
                _ => Some(Sort::Number),
            },
        }
    }

    /// Whether it is a closed interval, or has one among others.
    pub fn has_interval(&self) -> bool {
        match self {
            Domain::Written(node) => matches!(node.kind, Kind::Interval(..)),
            Domain::Given(_) => false,
            Domain::List(list) => list.iter().any(|(_, domain)| domain.has_interval()),
        }
    }

    /// Whether it is drawn at random.
    pub fn is_sample(&self) -> bool {
        match self {
            Domain::Written(Node { kind: Kind::Name { name, .. }, .. }) => name.starts_with("random"),
            Domain::Written(_) | Domain::Given(_) => false,
            Domain::List(list) => list.iter().any(|(_, domain)| domain.is_sample()),
        }
    }
}

/// Classes of graphs that were made, by kind, order and degree.
pub(crate) type Classes = Mutex<BTreeMap<(u8, usize, usize), Arc<Vec<Arc<AnyGraph>>>>>;

/// Members without their values, as far as that helps to count them.
#[derive(Debug)]
pub(crate) enum Members {
    Integers(i64, i64),
    Graphs(Arc<Vec<Arc<AnyGraph>>>),
    Listed(Vec<Value>),
}

impl Members {
    pub fn len(&self) -> u64 {
        match self {
            Members::Integers(from, to) => (to - from + 1).max(0) as u64,
            Members::Graphs(list) => list.len() as u64,
            Members::Listed(list) => list.len() as u64,
        }
    }

    pub fn get(&self, k: u64) -> Option<Value> {
        match self {
            Members::Integers(from, _) => (k < self.len()).then(|| Value::Number(rational(from + k as i64, 1))),
            Members::Graphs(list) => list.get(k as usize).cloned().map(Value::Graph),
            Members::Listed(list) => list.get(k as usize).cloned(),
        }
    }
}
