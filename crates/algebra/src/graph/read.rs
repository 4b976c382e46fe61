//! Reading a graph: an edge list, or a matrix of weights in Matrix Market format.
//!
//! Edge list: one edge `i j [weight]` per line, vertices from 1, weight 1 where none is given, `#` starts a comment. Edges
//! are undirected unless a line `directed` comes before them; a line `vertices N` tells the number of vertices, which
//! otherwise is the largest one named.
//!
//! Matrix Market: `%%MatrixMarket matrix coordinate real|integer|pattern general|symmetric`; entry `(i, j)` is the weight of
//! the arc from `i` to `j`. Decimals are read exactly.

use super::WeightedGraph;
use crate::matrix::SparseMatrix;
use arithmetic::{NumberError, Rational, parse_rational, rational};
use std::collections::BTreeMap;

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
    /// Fewer or more entries than announced.
    #[error("{announced} entries are announced, but there are {found}")]
    EntryCount {
        /// What the size line says.
        announced: usize,
        /// What there is.
        found: usize,
    },
}

/// Reads a graph in either format; a Matrix Market file starts with `%%MatrixMarket`.
///
/// # Errors
/// [`GraphReadError`] with the line at fault.
pub fn read_graph(text: &str) -> Result<WeightedGraph, GraphReadError> {
    let graph = if text.starts_with("%%") { read_matrix_market(text)? } else { read_edge_list(text)? };
    if graph.order() == 0 { Err(GraphReadError::Nothing) } else { Ok(graph) }
}

fn integer(word: &str, line: usize, least: usize, most: usize) -> Result<usize, GraphReadError> {
    let digits = !word.is_empty() && word.bytes().all(|b| b.is_ascii_digit());
    let number = word.parse().ok().filter(|n| digits && (least..=most).contains(n));
    number.ok_or_else(|| GraphReadError::Range { line, found: word.to_string(), least, most })
}

fn weight(word: &str, line: usize) -> Result<Rational, GraphReadError> {
    parse_rational(word).map_err(|error| GraphReadError::Weight { line, error })
}

/// Entries with the lines where they stand.
#[derive(Default)]
struct Entries {
    lines: BTreeMap<(usize, usize), usize>,
    list: Vec<(usize, usize, Rational)>,
}

impl Entries {
    /// Adds an entry, counted from 1, and its mirror image where `both`.
    fn add(&mut self, place: (usize, usize), value: Rational, both: bool, line: usize) -> Result<(), GraphReadError> {
        let (row, column) = place;
        let key = if both { (row.min(column), row.max(column)) } else { place };
        if let Some(first) = self.lines.insert(key, line) {
            return Err(GraphReadError::Repeated { line, first, row, column });
        }
        if both && row != column {
            self.list.push((column - 1, row - 1, value.clone()));
        }
        self.list.push((row - 1, column - 1, value));
        Ok(())
    }
}

fn read_edge_list(text: &str) -> Result<WeightedGraph, GraphReadError> {
    let mut entries = Entries::default();
    let (mut directed, mut vertices, mut largest) = (false, None, 0);
    for (k, whole) in text.lines().enumerate() {
        let line = k + 1;
        let words: Vec<&str> = whole.split('#').next().unwrap_or_default().split_whitespace().collect();
        match words[..] {
            [] => {}
            ["directed"] if entries.list.is_empty() => directed = true,
            ["vertices", number] if entries.list.is_empty() => {
                vertices = Some(integer(number, line, 1, MOST_VERTICES)?);
            }
            [i, j] | [i, j, _] => {
                let most = vertices.unwrap_or(MOST_VERTICES);
                let (i, j) = (integer(i, line, 1, most)?, integer(j, line, 1, most)?);
                if i == j {
                    return Err(GraphReadError::Loop { line, vertex: i });
                }
                let value = words.get(2).map_or(Ok(rational(1, 1)), |word| weight(word, line))?;
                entries.add((i, j), value, !directed, line)?;
                largest = largest.max(i).max(j);
            }
            _ => {
                let expected = "an edge `i j [weight]` (`directed` and `vertices N` come before the edges)";
                return Err(GraphReadError::Form { line, expected, found: whole.trim().to_string() });
            }
        }
    }
    Ok(WeightedGraph::from_arcs(vertices.unwrap_or(largest), entries.list))
}

fn read_matrix_market(text: &str) -> Result<WeightedGraph, GraphReadError> {
    let mut lines = text.lines().enumerate().map(|(k, line)| (k + 1, line));
    let header = lines.next().map(|(_, line)| line).unwrap_or_default();
    let words: Vec<String> = header.split_whitespace().map(str::to_lowercase).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let (pattern, symmetric) = match words[..] {
        [
            "%%matrixmarket",
            "matrix",
            "coordinate",
            field @ ("real" | "integer" | "pattern"),
            shape @ ("general" | "symmetric"),
        ] => (field == "pattern", shape == "symmetric"),
        _ => {
            let expected = "`%%MatrixMarket matrix coordinate real|integer|pattern general|symmetric`";
            return Err(GraphReadError::Form { line: 1, expected, found: header.to_string() });
        }
    };
    let mut lines = lines.filter(|(_, line)| !line.starts_with('%') && !line.trim().is_empty());
    let (line, size) = lines.next().ok_or(GraphReadError::Nothing)?;
    let [rows, cols, announced] = size.split_whitespace().collect::<Vec<_>>()[..] else {
        let expected = "`rows columns entries`";
        return Err(GraphReadError::Form { line, expected, found: size.trim().to_string() });
    };
    let (rows, cols) = (integer(rows, line, 1, MOST_VERTICES)?, integer(cols, line, 1, MOST_VERTICES)?);
    if rows != cols {
        return Err(GraphReadError::NotSquare { line, rows, cols });
    }
    let announced = integer(announced, line, 0, rows.saturating_mul(cols))?;
    let mut entries = Entries::default();
    for (line, entry) in lines {
        let words: Vec<&str> = entry.split_whitespace().collect();
        let (i, j, value) = match (&words[..], pattern) {
            ([i, j], true) => (i, j, rational(1, 1)),
            ([i, j, value], false) => (i, j, weight(value, line)?),
            _ => {
                let expected = if pattern { "an entry `i j`" } else { "an entry `i j value`" };
                return Err(GraphReadError::Form { line, expected, found: entry.trim().to_string() });
            }
        };
        let (i, j) = (integer(i, line, 1, rows)?, integer(j, line, 1, rows)?);
        if symmetric && i < j {
            return Err(GraphReadError::AboveDiagonal(line));
        }
        entries.add((i, j), value, symmetric, line)?;
    }
    let found = entries.lines.len();
    if found != announced {
        return Err(GraphReadError::EntryCount { announced, found });
    }
    Ok(SparseMatrix::from_entries(rows, entries.list).into())
}
