//! Irreducible blocks, and those that are similar to symmetric matrices.

use super::float_bounds::{SLACK, nearest, nearest_root};
use crate::matrix::SparseMatrix;
use arithmetic::{Rational, rational};
use num_traits::{Signed, Zero};
use rayon::prelude::*;
use std::collections::VecDeque;

/// Whether `D^-1 A D` is symmetric for some positive diagonal `D`: its entries are then `+-sqrt(a_ij a_ji)`, and all
/// eigenvalues are real. `A` must be irreducible.
///
/// The condition is `a_ij a_ji > 0` wherever one of them is not zero, and the existence of `w_i = d_i²` with
/// `w_j a_ij = w_i a_ji`; the `w` are fixed along a spanning tree and checked on the other edges.
pub(super) fn is_symmetrisable(a: &SparseMatrix) -> bool {
    if a.is_symmetric() {
        return true;
    }
    let mirrored = |i: usize, j: usize, x: &Rational| a.get(j, i).is_some_and(|y| (x * y).is_positive());
    if !a.entries().all(|(i, j, x)| mirrored(i, j, x)) {
        return false;
    }
    let off_diagonal = a.entries().filter(|(i, j, _)| i != j).count();
    // A tree has no other edges.
    if off_diagonal == 2 * (a.order() - 1) {
        return true;
    }
    let mut weights: Vec<Option<Rational>> = vec![None; a.order()];
    weights[0] = Some(rational(1, 1));
    let mut queue = VecDeque::from([0]);
    while let Some(i) = queue.pop_front() {
        let Some(own) = weights[i].clone() else { continue };
        for (j, x) in a.row(i).iter().filter(|(j, _)| *j != i) {
            let Some(back) = a.get(*j, i) else { return false };
            match &weights[*j] {
                Some(known) if known * x == own.clone() * back => {}
                Some(_) => return false,
                None => {
                    weights[*j] = Some(own.clone() * back / x);
                    queue.push_back(*j);
                }
            }
        }
    }
    true
}

/// The entry `+-sqrt(a_ij a_ji)` of the similar symmetric matrix, with its error; `None` outside the range of floats.
pub(super) fn symmetric_entry(a: &SparseMatrix, i: usize, j: usize) -> Option<(f64, f64)> {
    match (a.get(i, j), a.get(j, i)) {
        (Some(x), Some(y)) if x == y => nearest(x),
        (Some(x), Some(y)) => nearest_root(&(x * y), if x.is_negative() { -1.0 } else { 1.0 }),
        _ => Some((0.0, 0.0)),
    }
}

/// Rows from which several threads convert them.
const MANY_ROWS: usize = 256;

/// A symmetric matrix in floats.
pub(super) struct Symmetric {
    /// Column and value of the entries that are not zero, row by row.
    pub rows: Vec<Vec<(usize, f64)>>,
    /// Bound of the distance from the matrix that is meant, in the Frobenius norm.
    pub error: f64,
}

/// The similar symmetric matrix in floats; `None` outside their range. If the matrix `is_symmetric` itself, nothing is looked up for its entries.
pub(super) fn symmetrised(a: &SparseMatrix, is_symmetric: bool) -> Option<Symmetric> {
    let row = |i: usize| {
        let mut squares = 0.0;
        let entry = |(j, x): &(usize, Rational)| {
            let (value, error) = if is_symmetric { nearest(x) } else { symmetric_entry(a, i, *j) }?;
            squares += error * error;
            Some((*j, value))
        };
        let floats = a.row(i).iter().map(entry).collect::<Option<Vec<_>>>()?;
        Some((floats, squares))
    };
    let rows: Option<Vec<_>> = if a.order() < MANY_ROWS {
        (0..a.order()).map(row).collect()
    } else {
        (0..a.order()).into_par_iter().map(row).collect()
    };
    let (rows, squares): (Vec<_>, Vec<f64>) = rows?.into_iter().unzip();
    let squares: f64 = squares.into_iter().sum();
    let error = if squares == 0.0 { 0.0 } else { (squares.sqrt() + 1e-150) * SLACK };
    Some(Symmetric { rows, error })
}

/// The entries of a row that are not zero: column, float, bound of its error.
pub(super) type Row = Vec<(usize, f64, f64)>;

/// The matrix in floats; `None` outside their range.
pub(super) fn float_rows(a: &SparseMatrix) -> Option<Vec<Row>> {
    let entry = |(j, x): &(usize, Rational)| nearest(x).map(|(value, error)| (*j, value, error));
    (0..a.order()).map(|i| a.row(i).iter().map(entry).collect()).collect()
}

/// The vertices in the order of the path, if the off-diagonal entries of an irreducible matrix form one.
pub(super) fn path_order(a: &SparseMatrix) -> Option<Vec<usize>> {
    let neighbours = |i: usize| a.row(i).iter().map(|&(j, _)| j).filter(move |&j| j != i);
    let end = (0..a.order()).find(|&i| neighbours(i).count() <= 1)?;
    let mut order = vec![end];
    let mut before = None;
    while let Some(&last) = order.last() {
        let mut next = neighbours(last).filter(|&j| Some(j) != before);
        let Some(j) = next.next() else { break };
        if next.next().is_some() || order.len() == a.order() {
            return None;
        }
        before = Some(last);
        order.push(j);
    }
    (order.len() == a.order()).then_some(order)
}

/// Whether the block is the single entry zero or another rational.
pub(super) fn single(a: &SparseMatrix) -> Option<Rational> {
    (a.order() == 1).then(|| a.get(0, 0).cloned().unwrap_or_else(Rational::zero))
}
