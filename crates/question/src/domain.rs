//! What the names of `[for]` range over, as it is written, and the members that were made of it.

use crate::bindings::{GraphValue, Value};
use crate::error::Problem;
use crate::names::FAMILIES;
use crate::syntax::{Kind, Located, Node, parse_domain};
use algebra::graph::{ArcList, Graph, NamedGraph, WeightedGraph, read::read_graph_file};
use algebra::matrix::{StochasticMatrix, read::read_sequence};
use arithmetic::{Rational, parse_rational, rational, shown};
use num_traits::One;
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
        return read_file(name, &content).map(Domain::Given).map_err(other);
    }
    if let Some(rest) = trimmed.strip_prefix("matrices:") {
        return read_matrices(rest).map(|list| Domain::Given(Value::Matrices(Arc::new(list)))).map_err(other);
    }
    if let Some(rest) = trimmed.strip_prefix("each:") {
        let number = |word: &str| parse_rational(word.trim()).map_err(|error| other(error.to_string()));
        let list = rest.split(',').map(number).collect::<Result<Vec<_>, _>>()?;
        return Ok(Domain::Given(Value::Each(Arc::new(list))));
    }
    for (prefix, directed) in [("edges:", false), ("arcs:", true)] {
        if let Some(rest) = trimmed.strip_prefix(prefix) {
            let start = text.len() - text.trim_start().len() + prefix.len();
            let graph = read_arcs(rest, directed).map_err(|(at, message)| (start + at, Problem::Other(message)))?;
            return Ok(Domain::Given(Value::Graph(Arc::new(graph))));
        }
    }
    if trimmed.contains(':') {
        let name: NamedGraph = trimmed.parse().map_err(|error| other(format!("{error}")))?;
        return named(name).map(Domain::Given).map_err(other);
    }
    parse_domain(text).map(Domain::Written)
}

/// The graph of that name.
pub(crate) fn named(name: NamedGraph) -> Result<Value, String> {
    let graph = name.build().map_err(|error| error.to_string())?;
    Ok(Value::Graph(Arc::new(GraphValue::Named(name, graph))))
}

/// A graph, or a sequence of matrices where it is none.
fn read_file(name: &str, text: &str) -> Result<Value, String> {
    let graph = match read_graph_file(text, false) {
        Ok(file) if file.directed => return Ok(Value::Graph(Arc::new(GraphValue::Directed(file.graph)))),
        Ok(file) => return Ok(Value::Graph(Arc::new(GraphValue::Weighted(file.graph)))),
        Err(error) => error,
    };
    match read_sequence(text) {
        Ok(list) => Ok(Value::Matrices(Arc::new(list))),
        Err(error) => Err(format!("{name}: neither a graph ({graph}) nor stochastic matrices ({error})")),
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

/// `4:1-2,2-3`, with `*w` after an arc of another weight than 1. What is wrong is told with its byte of the text.
fn read_arcs(text: &str, directed: bool) -> Result<GraphValue, (usize, String)> {
    let form = || (0, format!("`{}` is not of the form 4:1-2,2-3: vertices, edges", shown(text)));
    let (order, list) = text.split_once(':').ok_or_else(form)?;
    let most = if directed { 1000 } else { 10_000 };
    let order: usize = order.trim().parse().ok().filter(|n| (1..=most).contains(n)).ok_or_else(form)?;
    let vertex = |word: &str| word.trim().parse().ok().filter(|v| (1..=order).contains(v)).map(|v: usize| v - 1);
    let what = if directed { "arc" } else { "edge" };
    let (mut arcs, mut simple, mut at) = (ArcList::default(), !directed, text.len() - list.len());
    for (item, number) in list.split(',').zip(1..) {
        let start = at;
        at += item.len() + 1;
        let item = item.trim();
        if item.is_empty() {
            continue;
        }
        let (pair, weight) = item.split_once('*').unwrap_or((item, "1"));
        let (i, j) = pair.split_once('-').ok_or_else(form)?;
        let (i, j) = vertex(i).zip(vertex(j)).ok_or_else(form)?;
        let weight = parse_rational(weight).map_err(|error| (start, error.to_string()))?;
        simple &= i != j && weight.is_one();
        arcs.add((i, j), weight, !directed, number).map_err(|first: usize| {
            let why =
                format!("the {what} `{}`, number {number} of the list, is its number {first} already", shown(item));
            (start, why)
        })?;
    }
    let arcs = arcs.into_arcs();
    if simple {
        let edges: Vec<(usize, usize)> = arcs.iter().map(|(i, j, _)| (*i, *j)).filter(|(i, j)| i < j).collect();
        let graph = Graph::from_edges(order, &edges).map(GraphValue::Simple);
        return graph.map_err(|error| (0, error.to_string()));
    }
    let graph = WeightedGraph::from_arcs(order, arcs);
    Ok(if directed { GraphValue::Directed(graph) } else { GraphValue::Weighted(graph) })
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

    /// Whether it is drawn at random.
    pub fn is_sample(&self) -> bool {
        match self {
            Domain::Written(Node { kind: Kind::Name { name, .. }, .. }) => name.starts_with("random"),
            Domain::Written(_) | Domain::Given(_) => false,
            Domain::List(list) => list.iter().any(|(_, domain)| domain.is_sample()),
        }
    }
}

/// Classes of graphs that were made, by kind and order.
pub(crate) type Classes = Mutex<BTreeMap<(u8, usize), Arc<Vec<Arc<GraphValue>>>>>;

/// Members without their values, as far as that helps to count them.
#[derive(Debug)]
pub(crate) enum Members {
    Integers(i64, i64),
    Graphs(Arc<Vec<Arc<GraphValue>>>),
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
