//! Irreducible blocks, and those that are similar to symmetric matrices.

use super::float_bounds::{SLACK, nearest, nearest_root};
use crate::matrix::SparseMatrix;
use arithmetic::threads::map;
use arithmetic::{Rational, rational};
use num_traits::{Signed, Zero};
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
        map(a.order(), row).into_iter().collect()
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

#[cfg(test)]
mod tests {
    use super::super::float_bounds::UNIT;
    use super::super::testing::assert_rounded_up;
    use super::*;

    fn of(order: usize, entries: &[(usize, usize, (i64, i64))]) -> SparseMatrix {
        SparseMatrix::from_entries(order, entries.iter().map(|&(i, j, (p, q))| (i, j, rational(p, q))))
    }

    /// A directed ring `0 - 1 - .. - 0` with these entries there and back.
    fn ring(there: &[i64], back: &[i64]) -> SparseMatrix {
        let order = there.len();
        let arc = |i: usize| [(i, (i + 1) % order, (there[i], 1)), ((i + 1) % order, i, (back[i], 1))];
        of(order, &(0..order).flat_map(arc).collect::<Vec<_>>())
    }

    #[test]
    fn rings_are_symmetrisable_where_the_products_around_are_equal() {
        assert!(is_symmetrisable(&ring(&[1, 2, 3], &[1, 2, 3])));
        assert!(is_symmetrisable(&ring(&[2, 3, 5, 7], &[5, 7, 3, 2])));
        assert!(!is_symmetrisable(&ring(&[2, 3, 5, 7], &[5, 7, 3, 3])));
        assert!(is_symmetrisable(&ring(&[-2, 3, 4], &[-4, 2, 3])));
        assert!(!is_symmetrisable(&ring(&[-2, 3, 4], &[4, 2, 3])));
        // Trees always are, if opposite entries have the same sign; whatever stands on the diagonal.
        let tree = [(0, 1, (2, 1)), (1, 0, (1, 3)), (1, 2, (-1, 1)), (2, 1, (-5, 1)), (2, 2, (7, 1))];
        assert!(is_symmetrisable(&of(3, &tree)));
        assert!(!is_symmetrisable(&of(2, &[(0, 1, (2, 1)), (1, 0, (-1, 3))])));
        assert!(!is_symmetrisable(&of(2, &[(0, 1, (2, 1))])));
        // As many entries as a tree has, but not all of them there and back.
        let one_way = [(0, 1, (1, 1)), (1, 0, (1, 1)), (1, 2, (1, 1)), (2, 0, (1, 1))];
        assert!(!is_symmetrisable(&of(3, &one_way)));
        assert!(!is_symmetrisable(&ring(&[2, 3, 5], &[2, 3, 4])));
        // A ring of four with a chord, without and with equal products around both triangles.
        let chord = |back: i64| {
            let ring = [1, 2, 3, 0].into_iter().enumerate().flat_map(|(i, j)| [(i, j, (2, 1)), (j, i, (2, 1))]);
            of(4, &ring.chain([(0, 2, (3, 1)), (2, 0, (back, 1))]).collect::<Vec<_>>())
        };
        assert!(!is_symmetrisable(&chord(5)) && is_symmetrisable(&chord(3)));
    }

    #[test]
    fn entries_are_roots_of_the_products_of_opposite_ones() {
        let a = of(3, &[(0, 1, (2, 1)), (1, 0, (8, 1)), (1, 2, (-3, 1)), (2, 1, (-12, 1)), (0, 0, (5, 1))]);
        let value = |i: usize, j: usize| symmetric_entry(&a, i, j).expect("in range").0;
        assert_eq!([value(0, 1), value(1, 0), value(1, 2), value(2, 1)], [4.0, 4.0, -6.0, -6.0]);
        assert_eq!([symmetric_entry(&a, 0, 0), symmetric_entry(&a, 0, 2)], [Some((5.0, 0.0)), Some((0.0, 0.0))]);
        let rows = symmetrised(&a, false).expect("in range").rows;
        assert_eq!(rows, [vec![(0, 5.0), (1, 4.0)], vec![(0, 4.0), (2, -6.0)], vec![(1, -6.0)]]);
    }

    #[test]
    fn the_error_of_a_matrix_is_that_of_its_entries_together() {
        for order in [2, 5, MANY_ROWS - 1, MANY_ROWS, MANY_ROWS + 1] {
            let entries = (0..order).flat_map(|i| [(i, (i + 1) % order), ((i + 1) % order, i)]);
            let thirds = SparseMatrix::from_entries(order, entries.clone().map(|(i, j)| (i, j, rational(2, 3))));
            for is_symmetric in [true, false] {
                let found = symmetrised(&thirds, is_symmetric).expect("in range");
                let count = found.rows.iter().map(Vec::len).sum::<usize>() as f64;
                let derived = count.sqrt() * 4.0 * UNIT * found.rows[0][0].1.abs();
                assert_rounded_up(found.error, derived, &format!("{order}"));
                assert_eq!(found.rows.len(), order);
            }
            let whole = SparseMatrix::from_entries(order, entries.map(|(i, j)| (i, j, rational(3, 1))));
            assert_eq!(symmetrised(&whole, true).map(|found| found.error), Some(0.0));
        }
    }

    #[test]
    fn paths_are_found_and_nothing_else() {
        let graph = |order: usize, edges: &[(usize, usize)]| {
            of(
                order,
                &edges.iter().flat_map(|&(i, j)| [(i, j, (1, 1)), (j, i, (1, 1)), (i, i, (2, 1))]).collect::<Vec<_>>(),
            )
        };
        assert_eq!(path_order(&graph(4, &[(2, 0), (0, 3), (3, 1)])), Some(vec![1, 3, 0, 2]));
        assert_eq!(path_order(&of(1, &[(0, 0, (1, 1))])), Some(vec![0]));
        assert_eq!(path_order(&graph(3, &[(0, 1), (1, 2), (2, 0)])), None);
        assert_eq!(path_order(&graph(4, &[(0, 1), (1, 2), (1, 3)])), None);
        assert_eq!(path_order(&graph(4, &[(0, 1), (1, 2), (2, 3), (3, 1)])), None);
    }
}
