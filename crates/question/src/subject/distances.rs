//! Distances of exact vectors: the least one, and that from the mean.

use arithmetic::{Obstacle, RealNumber as Number};
use arithmetic::{Rational, rational};

/// The smallest distance of two rows; `None` of fewer than two.
pub(crate) fn least_distance(rows: &[Vec<Rational>], precision: u32) -> Option<Result<Number, Obstacle>> {
    let square = |a: &[Rational], b: &[Rational]| a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<Rational>();
    let pairs = (0..rows.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    let least = pairs.map(|(i, j)| square(&rows[i], &rows[j])).min()?;
    Some(Number::Exact(least).sqrt(precision))
}

/// `sqrt(sum |v_i - mean|²)` of rows `v_i`.
pub(crate) fn disagreement(rows: &[Vec<Rational>], precision: u32) -> Result<Number, Obstacle> {
    let count = rational(rows.len().max(1) as i64, 1);
    let dimension = rows.first().map_or(0, Vec::len);
    let means: Vec<Rational> = (0..dimension).map(|k| rows.iter().map(|v| &v[k]).sum::<Rational>() / &count).collect();
    let squares = rows.iter().flat_map(|v| v.iter().zip(&means).map(|(x, mean)| (x - mean) * (x - mean)));
    Number::Exact(squares.sum()).sqrt(precision)
}
