//! What goes through a graph: `sum(i, e)`, `count(edge(i, j), p)`, `max(pair(i, j) where p, e)`.

use crate::case::Case;
use crate::error::Problem;
use crate::failure::Failure;
use crate::subject::graph::GraphSubject;
use crate::syntax::{Kind, Node};

/// Over what it goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Over {
    Vertices,
    Edges,
    Pairs,
}

/// What is done with the values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Gathered {
    Sum,
    Count,
    Largest,
    Smallest,
}

/// An expression with names that go through the vertices, the edges or the pairs of a graph.
#[derive(Debug)]
pub(crate) struct Binder<'n> {
    pub gathered: Gathered,
    /// The graph whose it is, where that is said.
    pub owner: Option<&'n str>,
    pub over: Over,
    /// The names that are bound, one or two.
    pub names: Vec<&'n str>,
    pub condition: Option<&'n Node>,
    pub body: &'n Node,
}

impl<'n> Binder<'n> {
    /// A call that binds names, which must not stand for something else; `None` where it is no such call: `max(a, b)` is the larger of two numbers.
    pub fn of(node: &'n Node, is_known: impl Fn(&str) -> bool) -> Option<Result<Self, (usize, Problem)>> {
        let Kind::Name { name, arguments, called: true } = &node.kind else { return None };
        let (owner, own) = name.split_once('.').map_or((None, name.as_str()), |(owner, own)| (Some(owner), own));
        let gathered = match own {
            "sum" => Gathered::Sum,
            "count" => Gathered::Count,
            "max" => Gathered::Largest,
            "min" => Gathered::Smallest,
            _ => return None,
        };
        let always = matches!(gathered, Gathered::Sum | Gathered::Count);
        let (first, condition) = match arguments.first().map(|first| &first.kind) {
            Some(Kind::Where(first, condition)) => (Some(first.as_ref()), Some(condition.as_ref())),
            _ => (arguments.first(), None),
        };
        let found = first.and_then(|first| match &first.kind {
            Kind::Name { name, called: false, .. } if always => Some((Over::Vertices, vec![name.as_str()])),
            Kind::Name { name, arguments, called: true } => {
                let (over, count) = match name.as_str() {
                    "vertex" => (Over::Vertices, 1),
                    "edge" => (Over::Edges, 2),
                    "pair" => (Over::Pairs, 2),
                    _ => return None,
                };
                let bound = |node: &'n Node| match &node.kind {
                    Kind::Name { name, called: false, .. } => Some(name.as_str()),
                    _ => None,
                };
                let names: Vec<&str> = arguments.iter().filter_map(bound).collect();
                (names.len() == count && arguments.len() == count).then_some((over, names))
            }
            _ => None,
        });
        let form = || {
            format!("`{own}` goes through a graph: `{own}(i, ..)`, `{own}(edge(i, j), ..)`, `{own}(pair(i, j), ..)`")
        };
        match (found, &arguments[..]) {
            (Some((over, names)), [_, body]) => {
                let taken = names.iter().find(|name| is_known(name) || name.contains(['.', '[']));
                if let Some(name) = taken {
                    let why =
                        format!("`{name}` stands for something else already; another name is needed in `{own}(..)`");
                    return Some(Err((node.at, Problem::Other(why))));
                }
                if names.len() == 2 && names[0] == names[1] {
                    let why = format!("the two ends of `{own}(..)` need two names");
                    return Some(Err((node.at, Problem::Other(why))));
                }
                Some(Ok(Binder { gathered, owner, over, names, condition, body }))
            }
            _ if always => Some(Err((node.at, Problem::Other(form())))),
            _ => None,
        }
    }

    /// The values of its names, vertices from 1.
    pub fn places(&self, graph: &GraphSubject) -> Vec<Vec<usize>> {
        let order = graph.graph().order();
        match self.over {
            Over::Vertices => (1..=order).map(|i| vec![i]).collect(),
            Over::Pairs => (1..=order).flat_map(|i| (i + 1..=order).map(move |j| vec![i, j])).collect(),
            Over::Edges => {
                let directed = graph.graph().is_directed();
                let arcs = graph.graph().arcs().into_iter().filter(|(i, j)| directed || i <= j);
                let mut places: Vec<Vec<usize>> = arcs.map(|(i, j)| vec![i + 1, j + 1]).collect();
                places.sort_unstable();
                places
            }
        }
    }

    /// The graph that it goes through.
    pub fn graph<'q>(&self, case: &Case<'q>, at: usize) -> Result<std::rc::Rc<GraphSubject<'q>>, Failure> {
        let missing = || {
            Problem::Other("no name in [for] ranges over graphs, so that there is nothing to go through".to_string())
        };
        case.graph(self.owner).ok_or_else(|| Failure::Refused(at, missing()))
    }
}
