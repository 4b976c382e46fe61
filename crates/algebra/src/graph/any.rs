//! A graph as a text says it: the one grammar of graphs for commands, files and Python.

use super::graph6::{read_digraph6, read_graph6, read_sparse6};
use super::read::{GraphReadError, read_graph_file};
use super::{ArcList, Graph, NameError, NamedGraph, WeightedGraph};
use arithmetic::{parse_rational, shown};
use num_traits::One;
use std::fmt;
use std::str::FromStr;

/// A graph as a name, a list or a family gives it.
#[derive(Debug, Clone)]
pub enum AnyGraph {
    /// Undirected, all weights 1.
    Simple(Graph),
    /// Undirected, with weights.
    Weighted(WeightedGraph),
    /// Of arcs; it stays directed where there is an arc back for each of them.
    Directed(WeightedGraph),
    /// One with a name.
    Named(NamedGraph, WeightedGraph),
}

/// Why a text is no graph.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GraphTextError {
    /// Not a name, or one with other numbers.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A list of edges, or a text of nauty's, that cannot be read.
    #[error("{why}")]
    Text {
        /// The byte of the text where it goes wrong.
        at: usize,
        /// What is wrong.
        why: String,
    },
}

impl GraphTextError {
    /// The byte of the text where it goes wrong.
    pub fn at(&self) -> usize {
        match self {
            GraphTextError::Name(_) => 0,
            GraphTextError::Text { at, .. } => *at,
        }
    }
}

/// The forms of nauty with their prefixes: those of this grammar, and the headers of files.
const PACKED: [(&str, Packed); 6] = [
    ("graph6:", Packed::Graph),
    (">>graph6<<", Packed::Graph),
    ("sparse6:", Packed::Sparse),
    (">>sparse6<<", Packed::Sparse),
    ("digraph6:", Packed::Directed),
    (">>digraph6<<", Packed::Directed),
];

#[derive(Clone, Copy)]
enum Packed {
    Graph,
    Sparse,
    Directed,
}

fn packed(form: Packed, text: &str) -> Result<AnyGraph, String> {
    let found = match form {
        Packed::Graph => read_graph6(text).map(AnyGraph::Simple),
        // The mark tells them from graph6, of which most texts would be read as some other graph.
        Packed::Sparse => read_sparse6(text.strip_prefix(':').ok_or("sparse6 begins with `:`")?).map(AnyGraph::Simple),
        Packed::Directed => {
            read_digraph6(text.strip_prefix('&').ok_or("digraph6 begins with `&`")?).map(AnyGraph::Directed)
        }
    };
    let graph = found.map_err(|error| error.to_string())?;
    if graph.order() == 0 { Err("there is no vertex in it".to_string()) } else { Ok(graph) }
}

impl FromStr for AnyGraph {
    type Err = GraphTextError;

    /// `ring:12` and the other names of [`NamedGraph`], `edges:4:1-2,2-3*1/2`, `arcs:4:1-2,2-3`, `graph6:..`, `sparse6:..`, `digraph6:..`.
    fn from_str(text: &str) -> Result<Self, GraphTextError> {
        let start = text.len() - text.trim_start().len();
        let trimmed = text.trim();
        for (prefix, form) in PACKED {
            if let Some(rest) = trimmed.strip_prefix(prefix) {
                let why = |why| GraphTextError::Text { at: start, why: format!("`{}`: {why}", shown(trimmed)) };
                return packed(form, rest).map_err(why);
            }
        }
        for (prefix, directed) in [("edges:", false), ("arcs:", true)] {
            if let Some(rest) = trimmed.strip_prefix(prefix) {
                let at = start + prefix.len();
                return listed(rest, directed).map_err(|(own, why)| GraphTextError::Text { at: at + own, why });
            }
        }
        let name: NamedGraph = trimmed.parse()?;
        let graph = name.build()?;
        Ok(AnyGraph::Named(name, graph))
    }
}

impl AnyGraph {
    /// The graphs of a file: one in the formats of [`read_graph_file`], or one for each line in graph6, sparse6 or digraph6, the file beginning with such a
    /// line or its header. A vertex that is called `leader` becomes the first one, which leads a platoon.
    ///
    /// # Errors
    /// [`GraphReadError`] with the line at fault.
    pub fn read_file(text: &str, zero_based: bool) -> Result<Vec<Self>, GraphReadError> {
        if let Some(all) = packed_lines(text) {
            return all;
        }
        let file = read_graph_file(text, zero_based)?.leader_first();
        Ok(vec![if file.directed { AnyGraph::Directed(file.graph) } else { AnyGraph::Weighted(file.graph) }])
    }

    /// The graph with its weights.
    pub fn weighted(&self) -> WeightedGraph {
        match self {
            AnyGraph::Simple(graph) => WeightedGraph::from(graph),
            AnyGraph::Weighted(graph) | AnyGraph::Directed(graph) | AnyGraph::Named(_, graph) => graph.clone(),
        }
    }

    /// The vertex, from 0, of a loop, if there is one.
    pub fn first_loop(&self) -> Option<usize> {
        match self {
            AnyGraph::Simple(_) => None,
            _ => self.arcs().into_iter().find(|(i, j)| i == j).map(|(i, _)| i),
        }
    }

    /// Whether all weights are 1.
    pub fn is_unweighted(&self) -> bool {
        match self {
            AnyGraph::Simple(_) => true,
            AnyGraph::Weighted(graph) | AnyGraph::Directed(graph) | AnyGraph::Named(_, graph) => {
                graph.adjacency().entries().all(|(_, _, weight)| weight.is_one())
            }
        }
    }

    /// The same edges or arcs with their weights, without the name of the graph.
    pub fn unnamed(&self) -> Self {
        match self {
            AnyGraph::Named(name, graph) if name.is_directed() => AnyGraph::Directed(graph.clone()),
            AnyGraph::Named(_, graph) => AnyGraph::Weighted(graph.clone()),
            other => other.clone(),
        }
    }

    /// The graph without weights and loops; `None` where it is directed.
    pub fn simple(&self) -> Option<Graph> {
        match self {
            AnyGraph::Simple(graph) => Some(graph.clone()),
            _ if self.is_directed() => None,
            _ => Some(Graph::of_pairs(self.order(), self.arcs().into_iter().filter(|(i, j)| i < j))),
        }
    }

    /// Number of vertices.
    pub fn order(&self) -> usize {
        match self {
            AnyGraph::Simple(graph) => graph.order(),
            AnyGraph::Weighted(graph) | AnyGraph::Directed(graph) | AnyGraph::Named(_, graph) => graph.order(),
        }
    }

    /// Whether it is made of arcs: as its family or its text says, whatever the arcs are.
    pub fn is_directed(&self) -> bool {
        match self {
            AnyGraph::Simple(_) | AnyGraph::Weighted(_) => false,
            AnyGraph::Directed(_) => true,
            AnyGraph::Named(name, _) => name.is_directed(),
        }
    }

    /// The arcs without weights, from 0.
    pub fn arcs(&self) -> Vec<(usize, usize)> {
        match self {
            AnyGraph::Simple(graph) => graph.edges().into_iter().flat_map(|(i, j)| [(i, j), (j, i)]).collect(),
            AnyGraph::Weighted(graph) | AnyGraph::Directed(graph) | AnyGraph::Named(_, graph) => {
                graph.adjacency().entries().map(|(i, j, _)| (i, j)).collect()
            }
        }
    }
}

impl fmt::Display for AnyGraph {
    /// A text that is read again: `edges:N:..`, `arcs:N:..` with weights `*w` other than 1, of a loop in any case, or the name.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let graph = match self {
            AnyGraph::Named(name, _) => return write!(f, "{name}"),
            AnyGraph::Simple(graph) => &WeightedGraph::from(graph),
            AnyGraph::Weighted(graph) | AnyGraph::Directed(graph) => graph,
        };
        let directed = self.is_directed();
        write!(f, "{}:{}:", if directed { "arcs" } else { "edges" }, graph.order())?;
        let listed = graph.adjacency().entries().filter(|(i, j, _)| directed || i <= j);
        for (k, (i, j, weight)) in listed.enumerate() {
            write!(f, "{}{}-{}", if k > 0 { "," } else { "" }, i + 1, j + 1)?;
            if !weight.is_one() || (i == j && !directed) {
                write!(f, "*{weight}")?;
            }
        }
        Ok(())
    }
}

/// A file of lines in nauty's formats; `None` where it is another one: no line of an edge list that has vertices is a single word.
pub(super) fn packed_lines(text: &str) -> Option<Result<Vec<AnyGraph>, GraphReadError>> {
    let mut lines = text.lines().zip(1..).filter(|(line, _)| !line.trim().is_empty());
    let (first, _) = lines.clone().next()?;
    let first = first.trim();
    let header = PACKED.iter().find(|(prefix, _)| prefix.starts_with('>') && first.starts_with(prefix));
    let form = |line: &str| match (line.chars().next(), header) {
        (Some(':'), _) => Packed::Sparse,
        (Some('&'), _) => Packed::Directed,
        (_, Some((_, form))) => *form,
        _ => Packed::Graph,
    };
    let read = |line: &str| packed(form(line), line);
    // Without a header the first line decides.
    if header.is_none() && (first.split_whitespace().count() != 1 || read(first).is_err()) {
        return None;
    }
    let graph = |(line, number): (&str, usize)| {
        let line = line.trim();
        let line = header.map_or(line, |(prefix, _)| line.strip_prefix(prefix).unwrap_or(line));
        if line.is_empty() {
            return None;
        }
        Some(read(line).map_err(|why| GraphReadError::Packed { line: number, why }))
    };
    let all: Result<Vec<AnyGraph>, GraphReadError> = lines.by_ref().filter_map(graph).collect();
    Some(all.and_then(|all| if all.is_empty() { Err(GraphReadError::Nothing) } else { Ok(all) }))
}

/// `4:1-2,2-3`, with `*w` after an arc of another weight than 1. What is wrong is told with its byte of the text. A loop of an edge list is meant only where it has a
/// weight, `1-1*1`.
fn listed(text: &str, directed: bool) -> Result<AnyGraph, (usize, String)> {
    let form = |at: usize, text: &str| (at, format!("`{}` is not of the form 4:1-2,2-3: vertices, edges", shown(text)));
    let (order, list) = text.split_once(':').ok_or_else(|| form(0, text))?;
    let most = if directed { 1000 } else { 10_000 };
    let order = order.trim();
    let count = order.parse().ok().filter(|n| (1..=most).contains(n));
    let count: usize = count.ok_or_else(|| {
        let why = format!("the number of vertices must be an integer between 1 and {most}, not `{}`", shown(order));
        (0, why)
    })?;
    let what = if directed { "arc" } else { "edge" };
    let (mut arcs, mut simple, mut at) = (ArcList::default(), !directed, text.len() - list.len());
    for (item, number) in list.split(',').zip(1..) {
        let start = at + item.len() - item.trim_start().len();
        at += item.len() + 1;
        let item = item.trim();
        if item.is_empty() {
            continue;
        }
        let (pair, weight) = item.split_once('*').map_or((item, None), |(pair, weight)| (pair, Some(weight)));
        let (i, j) = pair.split_once('-').ok_or_else(|| form(start, item))?;
        let vertex = |word: &str| {
            let found = word.trim().parse().ok().filter(|v| (1..=count).contains(v)).map(|v: usize| v - 1);
            let why =
                || format!("the {what} `{}` names `{}`, and the vertices are 1 to {count}", shown(item), shown(word));
            found.ok_or_else(|| (start, why()))
        };
        let (i, j) = (vertex(i)?, vertex(j)?);
        if i == j && !directed && weight.is_none() {
            let own = i + 1;
            let why = format!(
                "the edge `{own}-{own}` joins a vertex with itself; a loop that is meant has a weight, {own}-{own}*1"
            );
            return Err((start, why));
        }
        let weight = parse_rational(weight.unwrap_or("1")).map_err(|error| (start, error.to_string()))?;
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
        let graph = Graph::from_edges(count, &edges).map(AnyGraph::Simple);
        return graph.map_err(|error| (0, error.to_string()));
    }
    let graph = WeightedGraph::from_arcs(count, arcs);
    Ok(if directed { AnyGraph::Directed(graph) } else { AnyGraph::Weighted(graph) })
}
