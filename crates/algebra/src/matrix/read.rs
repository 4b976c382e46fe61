//! Reading a sequence of row-stochastic matrices.
//!
//! Text: one row per line, numbers separated by spaces or commas, a blank line between matrices, `#` starts a comment.
//! JSON: a list of matrices, each a list of rows, entries as strings or numbers.

use super::{MatrixError, StochasticMatrix};
use arithmetic::{NumberError, Rational, parse_rational, rational, shown};
use num_traits::Signed;
use serde_json::Value;

/// Why a file does not hold a sequence of stochastic matrices. Matrices and lines are counted from 1.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ReadError {
    /// There is nothing in it.
    #[error("there is no matrix in it")]
    Nothing,
    /// A number that cannot be read.
    #[error("line {line}: {error}")]
    Number {
        /// The line.
        line: usize,
        /// What is wrong with the number.
        error: NumberError,
    },
    /// A matrix that is not row-stochastic.
    #[error("line {line}, matrix {matrix}: {error}")]
    Matrix {
        /// Which matrix.
        matrix: usize,
        /// The line where the matrix starts.
        line: usize,
        /// What is wrong with it.
        error: MatrixError,
    },
    /// Not JSON.
    #[error("not valid JSON: {0}")]
    Json(String),
    /// A JSON object.
    #[error(
        "a list of matrices is expected, such as [[[\"1/2\", \"1/2\"], [0, 1]]]; this is an object, of which no key is known here; it has {0}"
    )]
    Object(String),
    /// JSON of another shape.
    #[error("matrix {matrix}: {error}")]
    JsonMatrix {
        /// Which matrix.
        matrix: usize,
        /// What is wrong with it.
        error: String,
    },
    /// Matrices that cannot be multiplied.
    #[error("matrix {matrix} cannot multiply the one before it: {error}")]
    Sequence {
        /// The later matrix.
        matrix: usize,
        /// The mismatch.
        error: MatrixError,
    },
}

/// Reads a sequence of matrices that can be multiplied, the first factor (the rightmost) first.
///
/// # Errors
/// [`ReadError`] with the place at fault.
pub fn read_sequence(text: &str) -> Result<Vec<StochasticMatrix>, ReadError> {
    read(text, &mut Rows { normalise: false, changed: Vec::new() })
}

/// A row that was divided by its sum. Matrices and rows are counted from 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Normalised {
    /// Which matrix.
    pub matrix: usize,
    /// Which row.
    pub row: usize,
    /// The sum of the row as it was given.
    pub sum: Rational,
}

/// The same for rows that sum to about 1, as those of floats do: each is divided by its sum, exactly, and what was changed is told.
///
/// # Errors
/// As [`read_sequence`]; a row without a positive sum is refused as it is.
pub fn read_normalised(text: &str) -> Result<(Vec<StochasticMatrix>, Vec<Normalised>), ReadError> {
    let mut rows = Rows { normalise: true, changed: Vec::new() };
    let matrices = read(text, &mut rows)?;
    Ok((matrices, rows.changed))
}

/// What becomes of the rows that are read.
struct Rows {
    normalise: bool,
    changed: Vec<Normalised>,
}

impl Rows {
    /// The matrix of some rows.
    fn matrix(&mut self, mut rows: Vec<Vec<Rational>>, matrix: usize) -> Result<StochasticMatrix, MatrixError> {
        let one = rational(1, 1);
        for (i, row) in rows.iter_mut().enumerate().filter(|_| self.normalise) {
            let sum: Rational = row.iter().sum();
            if sum.is_positive() && sum != one {
                row.iter_mut().for_each(|entry| *entry /= &sum);
                self.changed.push(Normalised { matrix, row: i + 1, sum });
            }
        }
        StochasticMatrix::from_rows(&rows)
    }
}

fn read(text: &str, rows: &mut Rows) -> Result<Vec<StochasticMatrix>, ReadError> {
    let matrices =
        if text.trim_start().starts_with(['[', '{']) { read_json(text, rows)? } else { read_text(text, rows)? };
    if matrices.is_empty() {
        return Err(ReadError::Nothing);
    }
    for (k, pair) in matrices.windows(2).enumerate() {
        if pair[1].cols() != pair[0].rows() {
            let error = MatrixError::Shapes { left_cols: pair[1].cols(), right_rows: pair[0].rows() };
            return Err(ReadError::Sequence { matrix: k + 2, error });
        }
    }
    Ok(matrices)
}

fn read_text(text: &str, all: &mut Rows) -> Result<Vec<StochasticMatrix>, ReadError> {
    let mut matrices = Vec::new();
    let mut rows: Vec<Vec<Rational>> = Vec::new();
    let mut first_line = 0;
    let mut finish = |rows: &mut Vec<Vec<Rational>>, line: usize| {
        if rows.is_empty() {
            return Ok(());
        }
        let number = matrices.len() + 1;
        let matrix = all.matrix(std::mem::take(rows), number);
        let matrix = matrix.map_err(|error| ReadError::Matrix { matrix: number, line, error })?;
        matrices.push(matrix);
        Ok(())
    };
    for (k, line) in text.lines().enumerate() {
        let content = line.split('#').next().unwrap_or_default();
        if line.trim().is_empty() {
            finish(&mut rows, first_line)?;
            continue;
        }
        let words = content.split([' ', '\t', ',', '\r']).filter(|word| !word.is_empty());
        let row: Vec<Rational> = words
            .map(|word| parse_rational(word).map_err(|error| ReadError::Number { line: k + 1, error }))
            .collect::<Result<_, _>>()?;
        if row.is_empty() {
            continue;
        }
        if rows.is_empty() {
            first_line = k + 1;
        }
        rows.push(row);
    }
    finish(&mut rows, first_line)?;
    Ok(matrices)
}

fn read_json(text: &str, all: &mut Rows) -> Result<Vec<StochasticMatrix>, ReadError> {
    let document: Value = crate::json::parse(text).map_err(ReadError::Json)?;
    let list = match &document {
        Value::Array(list) => list,
        Value::Object(object) => return Err(ReadError::Object(keys(object))),
        _ => return Err(ReadError::Nothing),
    };
    let matrix = |(k, value): (usize, &Value)| {
        let refuse = |error: String| ReadError::JsonMatrix { matrix: k + 1, error };
        let rows = json_rows(value).map_err(refuse)?;
        let matrix = all.matrix(rows, k + 1);
        matrix.map_err(|error| ReadError::JsonMatrix { matrix: k + 1, error: error.to_string() })
    };
    list.iter().enumerate().map(matrix).collect()
}

/// The keys of an object in a sentence, the first of many.
fn keys(object: &serde_json::Map<String, Value>) -> String {
    const MOST: usize = 5;
    let more = if object.len() > MOST { ", .." } else { "" };
    let first: Vec<String> = object.keys().take(MOST).map(|key| format!("`{}`", shown(key))).collect();
    if first.is_empty() { "no keys".to_string() } else { format!("the keys {}{more}", first.join(", ")) }
}

fn json_rows(value: &Value) -> Result<Vec<Vec<Rational>>, String> {
    let rows = value.as_array().ok_or("a list of rows is expected")?;
    rows.iter()
        .map(|row| {
            let row = row.as_array().ok_or("a row must be a list of numbers")?;
            row.iter().map(json_number).collect()
        })
        .collect()
}

fn json_number(value: &Value) -> Result<Rational, String> {
    let text = match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.to_string(),
        _ => return Err("an entry must be a number or a string".to_string()),
    };
    parse_rational(&text).map_err(|error| error.to_string())
}
