//! Neighbours in the plane: points sorted into square cells.

use rayon::prelude::*;
use std::ops::Range;

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

/// Points whose cells are found by several processors.
const MANY: usize = 8192;

/// Columns over which points that are looked at together may be spread.
const SPAN: usize = 3;

impl CellList {
    /// Sorts the points.
    ///
    /// # Errors
    /// [`CellError`].
    pub fn new(points: &[[f64; 2]], radius: f64) -> Result<Self, CellError> {
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(CellError::Radius(radius));
        }
        if let Some(place) = first_not_finite(points) {
            return Err(CellError::Position(place));
        }
        let (corner, opposite) = corners(points);
        let ([left, bottom], [right, top]) = (corner, opposite);
        // A little wider than the radius, so that rounding of the quotient does not matter; wider still where there would be
        // many more cells than points on a side.
        let most = (points.len() as f64).sqrt() * 2.0 + 1.0;
        let width = (radius * (1.0 + 1e-9)).max((right - left) / most).max((top - bottom) / most);
        // Quotients this large have no exact neighbours.
        let width = width.max(left.abs().max(right.abs()).max(bottom.abs()).max(top.abs()) * 1e-12);
        // The reciprocal of a smaller one is infinite.
        let width = width.max(f64::MIN_POSITIVE);
        let per_width = 1.0 / width;
        let count = |length: f64| ((length * per_width) as usize).saturating_add(1);
        let (columns, rows) = (count(right - left), count(top - bottom));
        let mut list = CellList {
            sorted: vec![[0.0; 2]; points.len()],
            numbers: vec![0; points.len()],
            starts: vec![0; columns * rows + 1],
            columns,
            rows,
            corner,
            per_width,
            radius,
        };
        // Counting sort.
        let number = |p: &[f64; 2]| {
            let (i, j) = list.cell(p);
            j * columns + i
        };
        let cells: Vec<usize> = if points.len() < MANY {
            points.iter().map(number).collect()
        } else {
            points.par_iter().with_min_len(TASK).map(number).collect()
        };
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
    #[inline(always)]
    fn cell(&self, p: &[f64; 2]) -> (usize, usize) {
        // There are fewer than 2^32, and the shorter conversion is faster.
        let part = |k: usize, most: usize| (((p[k] - self.corner[k]) * self.per_width) as u32 as usize).min(most - 1);
        (part(0, self.columns), part(1, self.rows))
    }

    /// The numbers of the points in the order of the cells, and in a cell in their own order. A place is a position in this list.
    pub fn numbers(&self) -> &[usize] {
        &self.numbers
    }

    /// A few consecutive places, from `place` on and fewer than `most`, whose points lie close together in one row; and three stretches of
    /// places (some may be empty), without overlaps and in order, that hold all points at a distance below the radius from one of these, they
    /// themselves and others too. The cells of a row lie next to each other.
    #[inline(always)]
    pub fn neighbourhood(&self, place: usize, most: usize) -> (Range<usize>, [Range<usize>; 3]) {
        let Some(point) = self.sorted.get(place) else { return (place..place, [0..0, 0..0, 0..0]) };
        let (column, row) = self.cell(point);
        let start = |row: usize, column: usize| self.starts[row * self.columns + column];
        let near = (column + SPAN).min(self.columns);
        let places = place..start(row, near).min(place.saturating_add(most)).max(place + 1);
        let (last, _) = self.cell(&self.sorted[places.end - 1]);
        let (left, right) = (column.saturating_sub(1), (last + 2).min(self.columns));
        let stretch = |row: usize| start(row, left)..start(row, right);
        let below = if row > 0 { stretch(row - 1) } else { 0..0 };
        let above = if row + 1 < self.rows { stretch(row + 1) } else { 0..0 };
        (places, [below, stretch(row), above])
    }

    /// Calls `visit(j, r, r²)` for each other point `j` (by number) at a distance below the radius from the point in place
    /// `place` of the sorted list, with `r` the vector from that to `j`. The order is that of the cells, and in a cell that of
    /// the numbers.
    #[inline]
    fn visit(&self, place: usize, mut visit: impl FnMut(usize, [f64; 2], f64)) {
        let own = self.sorted[place];
        let limit = self.radius * self.radius;
        for stretch in self.neighbourhood(place, 1).1 {
            let from = stretch.start;
            for (k, point) in self.sorted[stretch].iter().enumerate() {
                let r = [point[0] - own[0], point[1] - own[1]];
                let square = r[0] * r[0] + r[1] * r[1];
                if square < limit && from + k != place {
                    visit(self.numbers[from + k], r, square);
                }
            }
        }
    }

    /// Calls `visit(j, r²)` for each other point `j` (by number) at a distance up to `radius`, which need not be that of the list, from the
    /// point in place `place`.
    pub fn visit_up_to(&self, place: usize, radius: f64, mut visit: impl FnMut(usize, f64)) {
        let Some(&own) = self.sorted.get(place) else { return };
        let limit = radius * radius;
        // A little farther, for rounding.
        let far = radius * (1.0 + 1e-9);
        let stretch = |k: usize, count: usize| {
            let at = |x: f64| (((x - self.corner[k]) * self.per_width) as usize).min(count - 1);
            at(own[k] - far)..at(own[k] + far) + 1
        };
        let columns = stretch(0, self.columns);
        for row in stretch(1, self.rows) {
            let start = |column: usize| self.starts[row * self.columns + column];
            for other in (start(columns.start)..start(columns.end)).filter(|&other| other != place) {
                let r = [self.sorted[other][0] - own[0], self.sorted[other][1] - own[1]];
                let square = r[0] * r[0] + r[1] * r[1];
                if square <= limit {
                    visit(self.numbers[other], square);
                }
            }
        }
    }

    /// For each of the first `count` points, in the order of their numbers, the fold of `add` over all others at a distance below the radius:
    /// `add(value, i, j, r, r²)` with `r` the vector from `i` to `j`. In parallel; each point's neighbours come in a fixed order.
    pub fn fold_neighbours<T: Copy + Send + Sync>(
        &self,
        count: usize,
        start: T,
        add: impl Fn(T, usize, usize, [f64; 2], f64) -> T + Sync,
    ) -> Vec<T> {
        let mut by_place = vec![start; self.sorted.len()];
        by_place.par_chunks_mut(TASK).enumerate().for_each(|(task, values)| {
            for (place, value) in values.iter_mut().enumerate().map(|(k, value)| (task * TASK + k, value)) {
                let own = self.numbers[place];
                if own < count {
                    self.visit(place, |other, r, square| *value = add(*value, own, other, r, square));
                }
            }
        });
        let mut values = vec![start; count.min(self.sorted.len())];
        let wanted = self.numbers.iter().zip(by_place).filter(|(number, _)| **number < count);
        wanted.for_each(|(&number, value)| values[number] = value);
        values
    }

    /// The pairs `i < j` at a distance below the radius, sorted.
    pub fn pairs(&self) -> Vec<(usize, usize)> {
        let mut places = vec![0; self.numbers.len()];
        self.numbers.iter().enumerate().for_each(|(place, &number)| places[number] = place);
        let mut pairs = Vec::new();
        for (own, &place) in places.iter().enumerate() {
            let first = pairs.len();
            self.visit(place, |other, _, _| {
                if own < other {
                    pairs.push((own, other));
                }
            });
            pairs[first..].sort_unstable();
        }
        pairs
    }
}

/// The first vector with a component that is not finite. Without a way out on the way, several are looked at at once.
pub fn first_not_finite(vectors: &[[f64; 2]]) -> Option<usize> {
    let finite = vectors.as_flattened().iter().fold(true, |all, x| all & x.is_finite());
    if finite { None } else { vectors.iter().position(|v| !(v[0].is_finite() && v[1].is_finite())) }
}

/// The least and the largest coordinates of finite points, zeros where there are none.
fn corners(points: &[[f64; 2]]) -> ([f64; 2], [f64; 2]) {
    let start = points.first().copied().unwrap_or_default();
    // Four points at a time, none of which waits for the others.
    let (mut low, mut high) = ([start; 4], [start; 4]);
    for chunk in points.chunks(4) {
        for ((low, high), p) in low.iter_mut().zip(&mut high).zip(chunk) {
            for k in 0..2 {
                low[k] = if p[k] < low[k] { p[k] } else { low[k] };
                high[k] = if p[k] > high[k] { p[k] } else { high[k] };
            }
        }
    }
    let all =
        |k: usize, lanes: [[f64; 2]; 4], better: fn(f64, f64) -> f64| lanes.iter().map(|p| p[k]).fold(start[k], better);
    ([0, 1].map(|k| all(k, low, f64::min)), [0, 1].map(|k| all(k, high, f64::max)))
}

/// For each point the numbers of its `count` nearest others in increasing order, all of them where there are fewer; of two at the same
/// distance the one with the smaller number is nearer. O(N) for points that are spread evenly.
///
/// # Errors
/// [`CellError::Position`].
pub fn nearest(points: &[[f64; 2]], count: usize) -> Result<Vec<Vec<usize>>, CellError> {
    let wanted = count.min(points.len().saturating_sub(1));
    let side = |k: usize| {
        let fold = |start: f64, f: fn(f64, f64) -> f64| points.iter().map(|p| p[k]).fold(start, f);
        fold(f64::NEG_INFINITY, f64::max) - fold(f64::INFINITY, f64::min)
    };
    // So that a cell holds about as many as are asked for.
    let part = (wanted + 1) as f64 / points.len().max(1) as f64;
    let typical = (side(0) * side(1) * part).sqrt();
    let radius = if typical > 0.0 && typical.is_finite() { typical } else { 1.0 };
    let list = CellList::new(points, radius)?;
    let search = |place: usize| {
        let mut found: Vec<(f64, usize)> = Vec::new();
        let mut far = radius;
        loop {
            list.visit_up_to(place, far, |j, square| found.push((square, j)));
            if found.len() >= wanted {
                break;
            }
            found.clear();
            far *= 2.0;
        }
        found.sort_by(|(a, i), (b, j)| a.total_cmp(b).then(i.cmp(j)));
        let mut numbers: Vec<usize> = found.into_iter().take(wanted).map(|(_, j)| j).collect();
        numbers.sort_unstable();
        numbers
    };
    let by_place: Vec<Vec<usize>> = (0..points.len()).into_par_iter().with_min_len(TASK).map(search).collect();
    let mut lists = vec![Vec::new(); points.len()];
    list.numbers.iter().zip(by_place).for_each(|(&number, numbers)| lists[number] = numbers);
    Ok(lists)
}
