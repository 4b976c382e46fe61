//! Neighbours in the plane: points sorted into square cells.

use rayon::prelude::*;

/// Why there is no cell list. Points are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CellError {
    /// A coordinate that is not finite.
    #[error("the position of point {0} is not finite")]
    Position(usize),
    /// A radius that is not a positive number.
    #[error("the radius must be a positive number, but it is {0}")]
    Radius(f64),
}

/// Points of the plane in square cells at least as wide as a radius, so that all within the radius of a point are in its own
/// cell and the eight around it. O(N) to build; equal points and equal coordinates do no harm.
#[derive(Debug, Clone)]
pub struct CellList {
    /// The points cell by cell, in each by their number.
    sorted: Vec<[f64; 2]>,
    numbers: Vec<usize>,
    /// Where each cell begins in these, and the end of the last one.
    starts: Vec<usize>,
    columns: usize,
    rows: usize,
    corner: [f64; 2],
    per_width: f64,
    radius: f64,
}

/// Points whose neighbours one task looks up.
const TASK: usize = 512;

impl CellList {
    /// Sorts the points.
    ///
    /// # Errors
    /// [`CellError`].
    pub fn new(points: &[[f64; 2]], radius: f64) -> Result<Self, CellError> {
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(CellError::Radius(radius));
        }
        if let Some(place) = points.iter().position(|p| !(p[0].is_finite() && p[1].is_finite())) {
            return Err(CellError::Position(place));
        }
        let side = |k: usize| {
            let fold = |start: f64, f: fn(f64, f64) -> f64| points.iter().map(|p| p[k]).fold(start, f);
            (fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max))
        };
        let ((left, right), (bottom, top)) =
            if points.is_empty() { ((0.0, 0.0), (0.0, 0.0)) } else { (side(0), side(1)) };
        // A little wider than the radius, so that rounding of the quotient does not matter; wider still where there would be
        // many more cells than points on a side.
        let most = (points.len() as f64).sqrt() * 2.0 + 1.0;
        let width = (radius * (1.0 + 1e-9)).max((right - left) / most).max((top - bottom) / most);
        // Quotients this large have no exact neighbours.
        let width = width.max(left.abs().max(right.abs()).max(bottom.abs()).max(top.abs()) * 1e-12);
        let per_width = 1.0 / width;
        let count = |length: f64| ((length * per_width) as usize).saturating_add(1);
        let (columns, rows) = (count(right - left), count(top - bottom));
        let mut list = CellList {
            sorted: vec![[0.0; 2]; points.len()],
            numbers: vec![0; points.len()],
            starts: vec![0; columns * rows + 1],
            columns,
            rows,
            corner: [left, bottom],
            per_width,
            radius,
        };
        // Counting sort.
        let cells: Vec<usize> = points.iter().map(|p| list.cell(p)).map(|(i, j)| j * columns + i).collect();
        cells.iter().for_each(|&cell| list.starts[cell + 1] += 1);
        (0..columns * rows).for_each(|cell| list.starts[cell + 1] += list.starts[cell]);
        let mut next = list.starts.clone();
        for (number, (&cell, point)) in cells.iter().zip(points).enumerate() {
            list.sorted[next[cell]] = *point;
            list.numbers[next[cell]] = number;
            next[cell] += 1;
        }
        Ok(list)
    }

    /// Column and row of the cell of a point inside the box of all points.
    fn cell(&self, p: &[f64; 2]) -> (usize, usize) {
        let part = |k: usize, most: usize| (((p[k] - self.corner[k]) * self.per_width) as usize).min(most - 1);
        (part(0, self.columns), part(1, self.rows))
    }

    /// Calls `visit(j, r, r²)` for each other point `j` (by number) at a distance below the radius from the point in place
    /// `place` of the sorted list, with `r` the vector from that to `j`. The order is that of the cells, and in a cell that of
    /// the numbers.
    #[inline]
    fn visit(&self, place: usize, mut visit: impl FnMut(usize, [f64; 2], f64)) {
        let own = self.sorted[place];
        let (column, row) = self.cell(&own);
        let (first, last) = (column.saturating_sub(1), (column + 1).min(self.columns - 1));
        let limit = self.radius * self.radius;
        for row in row.saturating_sub(1)..=(row + 1).min(self.rows - 1) {
            // The cells of a row lie next to each other.
            let from = self.starts[row * self.columns + first];
            let until = self.starts[row * self.columns + last + 1];
            for other in from..until {
                let r = [self.sorted[other][0] - own[0], self.sorted[other][1] - own[1]];
                let square = r[0] * r[0] + r[1] * r[1];
                if square < limit && other != place {
                    visit(self.numbers[other], r, square);
                }
            }
        }
    }

    /// For each point, in the order of their numbers, the fold of `add` over all others at a distance below the radius:
    /// `add(value, i, j, r, r²)` with `r` the vector from `i` to `j`. In parallel; each point's neighbours come in a fixed order.
    pub fn fold_neighbours<T: Copy + Send + Sync>(
        &self,
        start: T,
        add: impl Fn(T, usize, usize, [f64; 2], f64) -> T + Sync,
    ) -> Vec<T> {
        let mut by_place = vec![start; self.sorted.len()];
        by_place.par_chunks_mut(TASK).enumerate().for_each(|(task, values)| {
            for (place, value) in values.iter_mut().enumerate().map(|(k, value)| (task * TASK + k, value)) {
                let own = self.numbers[place];
                self.visit(place, |other, r, square| *value = add(*value, own, other, r, square));
            }
        });
        let mut values = vec![start; self.sorted.len()];
        self.numbers.iter().zip(by_place).for_each(|(&number, value)| values[number] = value);
        values
    }

    /// The pairs `i < j` at a distance below the radius, sorted.
    pub fn pairs(&self) -> Vec<(usize, usize)> {
        let mut pairs = Vec::new();
        for place in 0..self.sorted.len() {
            let own = self.numbers[place];
            self.visit(place, |other, _, _| {
                if own < other {
                    pairs.push((own, other));
                }
            });
        }
        pairs.sort_unstable();
        pairs
    }
}
