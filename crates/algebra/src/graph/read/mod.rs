//! Reading a graph: an edge list, a matrix of weights in Matrix Market format, GraphML, or a line of graph6.
//!
//! Edge list: one edge `i j [weight]` per line, with spaces or commas, vertices from 1 (or 0), weight 1 where none is given, `#` starts
//! a comment; a dictionary `{'weight': 2}` at the end, as networkx writes it, may hold the weight. Edges are undirected unless a line
//! `directed` comes before them; a line `vertices N` tells the number of vertices, which otherwise is the largest one named. Vertices
//! may have names instead of numbers; they are then numbered in the order in which they come.
//!
//! Matrix Market: `%%MatrixMarket matrix coordinate real|integer|pattern general|symmetric`; entry `(i, j)` is the weight of
//! the arc from `i` to `j`. Decimals are read exactly.
//!
//! graph6, sparse6 and digraph6, as nauty and networkx write them, with or without a header; one graph.
//!
//! GraphML: the first graph of the file; the data of the key named `weight` is the weight of an edge.

mod edge_list;
mod graphml;
mod matrix_market;

use super::any::packed_lines;
use super::{ArcList, WeightedGraph};
use arithmetic::{NumberError, Rational, parse_rational, shown};

/// Most vertices that are read.
const MOST_VERTICES: usize = 1 << 20;

/// Why a file holds no graph. Lines are counted from 1.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GraphReadError {
    /// There is nothing in it.
    #[error("there is no graph in it")]
    Nothing,
    /// A line of another form.
    #[error("line {line}: {expected} is expected, but it is `{found}`")]
    Form {
        /// The line.
        line: usize,
        /// What it should be.
        expected: &'static str,
        /// What it is.
        found: String,
    },
    /// A number of vertices that is not an integer in its range.
    #[error("line {line}: `{found}` is not an integer between {least} and {most}")]
    Range {
        /// The line.
        line: usize,
        /// What it says.
        found: String,
        /// The least number.
        least: usize,
        /// The largest number.
        most: usize,
    },
    /// Numbers from 0 where they start at 1.
    #[error("line {0}: vertices are counted from 1; for a file that counts from 0 there is --zero-based")]
    ZeroBased(usize),
    /// A number among names.
    #[error("line {line}: `{found}` is a number, but the vertices of the lines before have names")]
    NumberAmongNames {
        /// The line.
        line: usize,
        /// What it says.
        found: String,
    },
    /// A vertex of GraphML that no node declares.
    #[error("line {line}: there is no node `{found}`")]
    NoNode {
        /// The line.
        line: usize,
        /// What the edge says.
        found: String,
    },
    /// XML that cannot be read, or without a graph.
    #[error("line {line}: it is not GraphML: {why}")]
    GraphMl {
        /// The line.
        line: usize,
        /// What is wrong.
        why: String,
    },
    /// More vertices than are read.
    #[error("line {line}: more than {most} vertices are not read")]
    TooMany {
        /// The line.
        line: usize,
        /// The largest number.
        most: usize,
    },
    /// A weight that cannot be read.
    #[error("line {line}: {error}")]
    Weight {
        /// The line.
        line: usize,
        /// What is wrong with it.
        error: NumberError,
    },
    /// An edge from a vertex to itself in an edge list.
    #[error("line {line}: the edge from vertex {vertex} to itself is not allowed")]
    Loop {
        /// The line.
        line: usize,
        /// The vertex.
        vertex: usize,
    },
    /// The same edge or entry twice.
    #[error("line {line}: ({row}, {column}) was given in line {first} already")]
    Repeated {
        /// The later line.
        line: usize,
        /// The earlier line.
        first: usize,
        /// First vertex, or row.
        row: usize,
        /// Second vertex, or column.
        column: usize,
    },
    /// A symmetric matrix with an entry above the diagonal.
    #[error("line {0}: an entry of a symmetric matrix must not lie above the diagonal")]
    AboveDiagonal(usize),
    /// Rows and columns differ.
    #[error("line {line}: a matrix of {rows} x {cols} is not square")]
    NotSquare {
        /// The line.
        line: usize,
        /// Its rows.
        rows: usize,
        /// Its columns.
        cols: usize,
    },
    /// More graphs than one.
    #[error("there are {0} graphs in it, where one is expected")]
    Several(usize),
    /// A line of nauty's formats that cannot be read.
    #[error("line {line}: {why}")]
    Packed {
        /// The line.
        line: usize,
        /// What is wrong.
        why: String,
    },
    /// Fewer or more entries than announced.
    #[error("{announced} entries are announced, but there are {found}")]
    EntryCount {
        /// What the size line says.
        announced: usize,
        /// What there is.
        found: usize,
    },
}

/// A graph as a file describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct GraphFile {
    /// The graph.
    pub graph: WeightedGraph,
    /// Whether the file declares arcs: an edge list by `directed`, Matrix Market by `general`, GraphML by any directed edge.
    pub directed: bool,
    /// Names of the vertices in their order, where the file has names and not numbers.
    pub labels: Option<Vec<String>>,
}

impl GraphFile {
    /// The same with the vertex that is called `leader` as the first, the others in their order; as it is where there is none.
    pub fn leader_first(mut self) -> Self {
        let labels = self.labels.as_ref();
        let Some(leader) = labels.and_then(|labels| labels.iter().position(|label| label == "leader")) else {
            return self;
        };
        let place = |vertex: usize| if vertex == leader { 0 } else { vertex + usize::from(vertex < leader) };
        let order = self.graph.order();
        let arcs = (0..order).flat_map(|i| {
            let row = self.graph.adjacency().row(i).iter();
            row.map(move |(j, weight)| (place(i), place(*j), weight.clone()))
        });
        self.graph = WeightedGraph::from_arcs(order, arcs.collect::<Vec<_>>());
        self.labels = self.labels.map(|mut labels| {
            labels[..=leader].rotate_right(1);
            labels
        });
        self
    }

    /// The vertex of a name, or of its number from 1 where the file has numbers; counted from 0.
    pub fn vertex(&self, name: &str) -> Option<usize> {
        match &self.labels {
            Some(labels) => labels.iter().position(|label| label == name),
            None => name.parse().ok().and_then(|k: usize| k.checked_sub(1)).filter(|k| *k < self.graph.order()),
        }
    }
}

/// Reads a graph in any format; a Matrix Market file starts with `%%MatrixMarket`, GraphML with `<`.
///
/// # Errors
/// [`GraphReadError`] with the line at fault.
pub fn read_graph(text: &str) -> Result<WeightedGraph, GraphReadError> {
    read_graph_file(text, false).map(|file| file.graph)
}

/// The same with the names of the vertices; the numbers of an edge list start at 0 where `zero_based`.
///
/// # Errors
/// As [`read_graph`].
pub fn read_graph_file(text: &str, zero_based: bool) -> Result<GraphFile, GraphReadError> {
    if let Some(all) = packed_lines(text) {
        let mut all = all?;
        return match all.pop() {
            Some(graph) if all.is_empty() => {
                Ok(GraphFile { graph: graph.weighted(), directed: graph.is_directed(), labels: None })
            }
            _ => Err(GraphReadError::Several(all.len() + 1)),
        };
    }
    let start = text.trim_start();
    let file = if start.starts_with("%%") {
        matrix_market::read(start)?
    } else if start.starts_with('<') {
        graphml::read(text)?
    } else {
        edge_list::read(text, usize::from(!zero_based))?
    };
    if file.graph.order() == 0 { Err(GraphReadError::Nothing) } else { Ok(file) }
}

fn integer(word: &str, line: usize, least: usize, most: usize) -> Result<usize, GraphReadError> {
    let digits = !word.is_empty() && word.bytes().all(|b| b.is_ascii_digit());
    let number = word.parse().ok().filter(|n| digits && (least..=most).contains(n));
    number.ok_or_else(|| GraphReadError::Range { line, found: shown(word), least, most })
}

fn weight(word: &str, line: usize) -> Result<Rational, GraphReadError> {
    parse_rational(word).map_err(|error| GraphReadError::Weight { line, error })
}

/// Adds an entry, counted from 1, with its line, and its mirror image where `both`.
fn add(
    entries: &mut ArcList<usize>,
    (row, column): (usize, usize),
    value: Rational,
    both: bool,
    line: usize,
) -> Result<(), GraphReadError> {
    let added = entries.add((row - 1, column - 1), value, both, line);
    added.map_err(|first| GraphReadError::Repeated { line, first, row, column })
}
