//! Matrix Market, coordinate form.

use super::{GraphFile, GraphReadError, MOST_VERTICES, add, integer, weight};
use crate::graph::ArcList;
use crate::matrix::SparseMatrix;
use arithmetic::{rational, shown};

/// Reads a file that begins with `%%`.
pub(super) fn read(text: &str) -> Result<GraphFile, GraphReadError> {
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
            return Err(GraphReadError::Form { line: 1, expected, found: shown(header) });
        }
    };
    let mut lines = lines.filter(|(_, line)| !line.starts_with('%') && !line.trim().is_empty());
    let (line, size) = lines.next().ok_or(GraphReadError::Nothing)?;
    let [rows, cols, announced] = size.split_whitespace().collect::<Vec<_>>()[..] else {
        let expected = "`rows columns entries`";
        return Err(GraphReadError::Form { line, expected, found: shown(size.trim()) });
    };
    let (rows, cols) = (integer(rows, line, 1, MOST_VERTICES)?, integer(cols, line, 1, MOST_VERTICES)?);
    if rows != cols {
        return Err(GraphReadError::NotSquare { line, rows, cols });
    }
    let announced = integer(announced, line, 0, rows.saturating_mul(cols))?;
    let mut entries = ArcList::default();
    for (line, entry) in lines {
        let words: Vec<&str> = entry.split_whitespace().collect();
        let (i, j, value) = match (&words[..], pattern) {
            ([i, j], true) => (i, j, rational(1, 1)),
            ([i, j, value], false) => (i, j, weight(value, line)?),
            _ => {
                let expected = if pattern { "an entry `i j`" } else { "an entry `i j value`" };
                return Err(GraphReadError::Form { line, expected, found: shown(entry.trim()) });
            }
        };
        let (i, j) = (integer(i, line, 1, rows)?, integer(j, line, 1, rows)?);
        if symmetric && i < j {
            return Err(GraphReadError::AboveDiagonal(line));
        }
        add(&mut entries, (i, j), value, symmetric, line)?;
    }
    let found = entries.len();
    if found != announced {
        return Err(GraphReadError::EntryCount { announced, found });
    }
    let graph = SparseMatrix::from_entries(rows, entries.into_arcs()).into();
    Ok(GraphFile { graph, directed: !symmetric, labels: None })
}
