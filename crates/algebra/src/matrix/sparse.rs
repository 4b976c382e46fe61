//! Square rational matrices of which most entries are zero.

use super::{MatrixError, RationalMatrix};
use arithmetic::Rational;
use arithmetic::threads::map;
use num_traits::Zero;

/// Rows from which several threads compare them.
const MANY_ROWS: usize = 256;

/// A square matrix given by its entries that are not zero, row by row in the order of the columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SparseMatrix {
    rows: Vec<Vec<(usize, Rational)>>,
}

impl SparseMatrix {
    /// The matrix with these entries `(row, column, value)`, counted from 0; values at the same place are added, and
    /// places outside the matrix are left out.
    pub fn from_entries(order: usize, entries: impl IntoIterator<Item = (usize, usize, Rational)>) -> Self {
        let entries = entries.into_iter();
        // Room for as many in each row as there are on average.
        let average = entries.size_hint().0 / order.max(1);
        let mut rows: Vec<Vec<(usize, Rational)>> = (0..order).map(|_| Vec::with_capacity(average)).collect();
        for (i, j, value) in entries {
            if i < order && j < order {
                rows[i].push((j, value));
            }
        }
        for row in &mut rows {
            if row.is_sorted_by(|(j, _), (k, _)| j < k) && row.iter().all(|(_, value)| !value.is_zero()) {
                continue;
            }
            row.sort_by_key(|&(j, _)| j);
            row.dedup_by(|next, kept| {
                let same = next.0 == kept.0;
                if same {
                    kept.1 += &next.1;
                }
                same
            });
            row.retain(|(_, value)| !value.is_zero());
        }
        SparseMatrix { rows }
    }

    /// The entries of a square matrix.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`].
    pub fn from_dense(matrix: &RationalMatrix) -> Result<Self, MatrixError> {
        let (rows, cols) = (matrix.rows(), matrix.cols());
        if rows != cols {
            return Err(MatrixError::NotSquare { rows, cols });
        }
        let places = (0..rows * cols).map(|k| (k / cols, k % cols));
        Ok(SparseMatrix::from_entries(rows, places.map(|(i, j)| (i, j, matrix.entry(i, j)))))
    }

    /// Number of rows and of columns.
    pub fn order(&self) -> usize {
        self.rows.len()
    }

    /// The entries of row `i` that are not zero, `(column, value)`, in order; none outside the matrix.
    pub fn row(&self, i: usize) -> &[(usize, Rational)] {
        self.rows.get(i).map_or(&[], Vec::as_slice)
    }

    /// All entries that are not zero, `(row, column, value)`, in order.
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize, &Rational)> + Clone {
        self.rows.iter().enumerate().flat_map(|(i, row)| row.iter().map(move |(j, value)| (i, *j, value)))
    }

    /// The entry in row `i` and column `j`, or `None` where it is zero, as it is outside the matrix.
    pub fn get(&self, i: usize, j: usize) -> Option<&Rational> {
        let row = self.row(i);
        match row.get(j) {
            // All entries before it are there.
            Some((column, value)) if *column == j => Some(value),
            _ => row.binary_search_by_key(&j, |&(column, _)| column).ok().map(|place| &row[place].1),
        }
    }

    /// The sums of the rows.
    pub fn row_sums(&self) -> Vec<Rational> {
        self.rows.iter().map(|row| row.iter().map(|(_, value)| value).sum()).collect()
    }

    /// The transpose.
    pub fn transpose(&self) -> Self {
        SparseMatrix::from_entries(self.order(), self.entries().map(|(i, j, value)| (j, i, value.clone())))
    }

    /// Whether it equals its transpose.
    pub fn is_symmetric(&self) -> bool {
        // As many entries above the diagonal as below, and each below has the one above for which it stands.
        let row = |i: usize| {
            let row = self.row(i);
            let below = row.partition_point(|&(j, _)| j < i);
            let above = row[below..].iter().filter(|&&(j, _)| j > i).count();
            let same = row[..below].iter().all(|(j, value)| self.get(*j, i) == Some(value));
            same.then_some(above as isize - below as isize)
        };
        let more_above = if self.order() < MANY_ROWS {
            (0..self.order()).map(row).sum::<Option<isize>>()
        } else {
            map(self.order(), row).into_iter().sum::<Option<isize>>()
        };
        more_above == Some(0)
    }

    /// The rows and columns with these numbers, which become `0, 1, ...` in the order given; those that are not there are zero.
    pub fn principal(&self, kept: &[usize]) -> Self {
        // No list of all names: most blocks are small, and there may be many.
        let mut names: Vec<(usize, usize)> = kept.iter().enumerate().map(|(new, &old)| (old, new)).collect();
        names.sort_unstable();
        let name = |old: usize| names.binary_search_by_key(&old, |&(old, _)| old).ok().map(|place| names[place].1);
        let entry = |i: usize, (j, value): &(usize, Rational)| name(*j).map(|column| (i, column, value.clone()));
        let entries = kept.iter().enumerate();
        SparseMatrix::from_entries(
            kept.len(),
            entries.flat_map(|(i, &old)| self.row(old).iter().filter_map(move |pair| entry(i, pair))),
        )
    }

    /// All entries, over their common denominator.
    ///
    /// # Errors
    /// [`MatrixError::Empty`] for order 0.
    pub fn to_dense(&self) -> Result<RationalMatrix, MatrixError> {
        let order = self.order();
        let mut rows = vec![vec![Rational::zero(); order]; order];
        for (i, j, value) in self.entries() {
            rows[i][j].clone_from(value);
        }
        RationalMatrix::from_rows(&rows)
    }

    /// The strongly connected components of the digraph with an arc from `i` to `j` for each entry `(i, j)` that is not
    /// zero, each sorted, in the order of their smallest member (Kosaraju and Sharir: one pass for the order in which
    /// vertices are finished, one against the arcs).
    ///
    /// With the components in a suitable order the matrix is block triangular, so its eigenvalues are those of the
    /// diagonal blocks.
    pub fn strong_components(&self) -> Vec<Vec<usize>> {
        let order = self.order();
        let mut finished = Vec::with_capacity(order);
        let mut seen = vec![false; order];
        for start in 0..order {
            if std::mem::replace(&mut seen[start], true) {
                continue;
            }
            // Vertices on the way, each with the place of its next arc.
            let mut way = vec![(start, 0)];
            while let Some((vertex, next)) = way.last_mut() {
                if let Some(&(target, _)) = self.rows[*vertex].get(*next) {
                    *next += 1;
                    if !std::mem::replace(&mut seen[target], true) {
                        way.push((target, 0));
                    }
                } else {
                    finished.push(*vertex);
                    way.pop();
                }
            }
        }
        let reversed = self.transpose();
        let mut placed = vec![false; order];
        let mut components = Vec::new();
        for &start in finished.iter().rev() {
            if std::mem::replace(&mut placed[start], true) {
                continue;
            }
            let mut members = vec![start];
            let mut next = 0;
            while let Some(&vertex) = members.get(next) {
                next += 1;
                for &(target, _) in reversed.row(vertex) {
                    if !std::mem::replace(&mut placed[target], true) {
                        members.push(target);
                    }
                }
            }
            members.sort_unstable();
            components.push(members);
        }
        components.sort();
        components
    }
}
