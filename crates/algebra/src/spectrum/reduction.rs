//! Householder's reduction of a symmetric matrix to tridiagonal form, in blocks of columns (Dongarra, Sorensen and Hammarling 1989): the matrix
//! is read once for each column, and written once for each block. Nothing is promised of the result; it is the same for any
//! number of threads.

use super::reflections::{Block, Reflections};
use super::trailing::Trailing;
use dense::{Mat, MatMut, MatRef, add_product};
use pulp::Simd;

/// Columns of a block.
const WIDTH: usize = 24;

/// Columns of the trailing matrix that one task brings up to date.
const STRIPE: usize = 64;

/// `S` is nearly `Q T Qᵀ` with the tridiagonal `T`.
pub(super) struct Reduction {
    pub diagonal: Vec<f64>,
    pub beside: Vec<f64>,
    pub reflections: Reflections,
}

impl Reduction {
    /// Of a symmetric matrix of order 2 at least, of which the part on and below the diagonal is read.
    pub fn new(mut work: Mat<f64>) -> Self {
        let order = work.nrows();
        let (mut diagonal, mut beside, mut blocks) = (Vec::with_capacity(order), Vec::new(), Vec::new());
        let arch = pulp::Arch::new();
        for from in (0..order - 1).step_by(WIDTH) {
            let width = WIDTH.min(order - 1 - from);
            let trailing =
                Trailing::new(work.as_ref().submatrix(from + 1, from + 1, order - from - 1, order - from - 1));
            let panel = Panel { work: work.as_ref(), trailing: &trailing, from, width };
            let panel = trailing.during(|| arch.dispatch(panel));
            diagonal.extend(panel.diagonal);
            beside.extend(panel.beside);
            // The rows of the trailing matrix.
            let (v, w) = (panel.v.as_ref().subrows(width - 1, order - from - width), panel.w.as_ref());
            let w = w.subrows(width - 1, order - from - width);
            let (left, right) = (beside_each_other(v, w), beside_each_other(w, v));
            let start = from + width;
            update(work.as_mut().submatrix_mut(start, start, order - start, order - start), &left, &right, 0);
            blocks.push(Block { from: from + 1, v: panel.v, x: panel.x });
        }
        diagonal.push(work[(order - 1, order - 1)]);
        Reduction { diagonal, beside, reflections: Reflections::new(order, blocks) }
    }
}

fn beside_each_other(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let width = a.ncols();
    let mut both = Mat::zeros(a.nrows(), 2 * width);
    both.as_mut().subcols_mut(0, width).copy_from(a);
    both.as_mut().subcols_mut(width, width).copy_from(b);
    both
}

/// Subtracts `left rightᵀ` from the part on and below the diagonal; the columns are those from `first` on of the trailing matrix.
fn update(columns: MatMut<'_, f64>, left: &Mat<f64>, right: &Mat<f64>, first: usize) {
    let count = columns.ncols();
    if count > STRIPE {
        let (a, b) = columns.split_at_col_mut((count / 2).next_multiple_of(STRIPE));
        let middle = first + a.ncols();
        rayon::join(|| update(a, left, right, first), || update(b, left, right, middle));
    } else if count > 0 {
        let rows = columns.nrows() - first;
        let right = right.as_ref().subrows(first, count);
        let lower = columns.subrows_mut(first, rows);
        add_product(lower, -1.0, left.as_ref().subrows(first, rows), right.transpose());
    }
}

/// The reduction of a few columns, for which the rest of the matrix is read but not written.
struct Panel<'a> {
    work: MatRef<'a, f64>,
    trailing: &'a Trailing<'a>,
    from: usize,
    width: usize,
}

/// What it leaves: `I - V X Vᵀ` reflects, and the trailing matrix becomes `A - V Wᵀ - W Vᵀ`; rows are counted from `from + 1` on.
struct Reduced {
    diagonal: Vec<f64>,
    beside: Vec<f64>,
    v: Mat<f64>,
    w: Mat<f64>,
    x: Mat<f64>,
}

impl pulp::WithSimd for Panel<'_> {
    type Output = Reduced;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Reduced {
        let (from, width) = (self.from, self.width);
        let rows = self.work.nrows() - from - 1;
        let (mut v, mut w) = (Mat::<f64>::zeros(rows, width), Mat::<f64>::zeros(rows, width));
        let mut x = Mat::<f64>::zeros(width, width);
        let (mut diagonal, mut beside) = (Vec::new(), Vec::new());
        for j in 0..width {
            // The column as it is by now: its diagonal entry is in row `j - 1` of `V`, and the rest below.
            let column = from + j;
            let mut corner = self.work[(column, column)];
            let mut below = self.work.col(column).subrows(column + 1, rows - j).iter().copied().collect::<Vec<f64>>();
            // Columns that are still to be found are zero.
            for k in (0..j).step_by(2) {
                let row = [v[(j - 1, k)], w[(j - 1, k)], v[(j - 1, k + 1)], w[(j - 1, k + 1)]];
                corner -= 2.0 * (row[0] * row[1] + row[2] * row[3]);
                add(simd, &mut below, [-row[1], -row[0], -row[3], -row[2]], pair(&v, &w, k, j));
            }
            diagonal.push(corner);
            let (length, weight) = reflection(&mut below);
            beside.push(length);
            let mut image = vec![0.0; rows - j];
            self.trailing.times(simd, &below, &mut image);
            let mut overlaps = [0.0; WIDTH];
            for k in (0..j).step_by(2) {
                let columns = pair(&v, &w, k, j);
                let found = dots(simd, columns, &below);
                add(simd, &mut image, [-found[1], -found[0], -found[3], -found[2]], columns);
                (overlaps[k], overlaps[k + 1]) = (found[0], found[2]);
            }
            image.iter_mut().for_each(|y| *y *= weight);
            let half = -0.5 * weight * dot(&image, &below);
            image.iter_mut().zip(&below).for_each(|(y, x)| *y += half * x);
            for k in 0..j {
                x[(k, j)] = -weight * (k..j).map(|l| x[(k, l)] * overlaps[l]).sum::<f64>();
            }
            x[(j, j)] = weight;
            v.col_as_slice_mut(j)[j..].copy_from_slice(&below);
            w.col_as_slice_mut(j)[j..].copy_from_slice(&image);
        }
        Reduced { diagonal, beside, v, w, x }
    }
}

/// Turns a vector into the `v` of the reflection `I - weight v vᵀ` that moves it to the first axis, with a one in front; gives its new
/// first entry and the weight.
#[inline(always)]
fn reflection(vector: &mut [f64]) -> (f64, f64) {
    let Some((first, rest)) = vector.split_first_mut() else { return (0.0, 0.0) };
    let (head, tail) = (*first, dot(rest, rest));
    *first = 1.0;
    if tail == 0.0 {
        return (head, 0.0);
    }
    let length = -(head * head + tail).sqrt().copysign(head);
    let scale = 1.0 / (head - length);
    rest.iter_mut().for_each(|x| *x *= scale);
    (length, (length - head) / length)
}

/// Two columns of each of two matrices, from a row on.
fn pair<'a>(v: &'a Mat<f64>, w: &'a Mat<f64>, k: usize, row: usize) -> [&'a [f64]; 4] {
    [v.col_as_slice(k), w.col_as_slice(k), v.col_as_slice(k + 1), w.col_as_slice(k + 1)].map(|column| &column[row..])
}

/// Adds multiples of four vectors.
#[inline(always)]
fn add<S: Simd>(simd: S, to: &mut [f64], factors: [f64; 4], vectors: [&[f64]; 4]) {
    let parts = vectors.map(|vector| S::as_simd_f64s(&vector[..to.len()]));
    let splats = factors.map(|factor| simd.splat_f64s(factor));
    let (head, tail) = S::as_mut_simd_f64s(to);
    for (i, y) in head.iter_mut().enumerate() {
        *y = (0..4).fold(*y, |sum, k| simd.mul_add_f64s(parts[k].0[i], splats[k], sum));
    }
    for (i, y) in tail.iter_mut().enumerate() {
        *y = (0..4).fold(*y, |sum, k| sum + parts[k].1[i] * factors[k]);
    }
}

/// The inner products of four vectors with another.
#[inline(always)]
fn dots<S: Simd>(simd: S, vectors: [&[f64]; 4], with: &[f64]) -> [f64; 4] {
    let parts = vectors.map(|vector| S::as_simd_f64s(&vector[..with.len()]));
    let (head, tail) = S::as_simd_f64s(with);
    let mut sums = [simd.splat_f64s(0.0); 4];
    for (i, &x) in head.iter().enumerate() {
        (0..4).for_each(|k| sums[k] = simd.mul_add_f64s(parts[k].0[i], x, sums[k]));
    }
    let rest = |k: usize| tail.iter().zip(parts[k].1).map(|(x, y)| x * y).sum::<f64>();
    std::array::from_fn(|k| simd.reduce_sum_f64s(sums[k]) + rest(k))
}

#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    const LANES: usize = 16;
    let (a, b) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(x, y)| x * y).sum();
    let mut lanes = [0.0; LANES];
    for (a, b) in a.zip(b) {
        lanes.iter_mut().zip(a.iter().zip(b)).for_each(|(lane, (x, y))| *lane += x * y);
    }
    lanes.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn symmetric(order: usize, density: f64) -> Mat<f64> {
        let mut seed = order as u64;
        let mut draw = move || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 * 2f64.powi(-53)
        };
        let mut matrix = Mat::zeros(order, order);
        for (i, j) in (0..order).flat_map(|i| (0..=i).map(move |j| (i, j))) {
            let entry = if draw() < density { draw() - 0.5 } else { 0.0 };
            (matrix[(i, j)], matrix[(j, i)]) = (entry, entry);
        }
        matrix
    }

    /// `Q T Qᵀ`, entry by entry of `T`.
    fn put_together(found: &Reduction) -> Mat<f64> {
        let order = found.diagonal.len();
        let q = found.reflections.columns(0, order);
        let tridiagonal = Mat::from_fn(order, order, |i, j| match i.abs_diff(j) {
            0 => found.diagonal[i],
            1 => found.beside[i.min(j)],
            _ => 0.0,
        });
        &q * tridiagonal * q.transpose()
    }

    #[test]
    fn the_parts_make_up_the_matrix() {
        for order in [2usize, 3, 4, 5, 31, 32, 33, 34, 65, 100, 200, 301] {
            for density in [1.0, 0.03, 0.0] {
                let matrix = symmetric(order, density);
                let found = Reduction::new(matrix.clone());
                assert_eq!((found.diagonal.len(), found.beside.len()), (order, order - 1));
                let difference = (put_together(&found) - &matrix).norm_max();
                assert!(difference < 1e-14 * order as f64, "{order} {density}: {difference}");
                assert!(found.reflections.least_singular_value() > 0.999);
            }
        }
    }

    #[test]
    fn the_part_above_the_diagonal_is_not_read() {
        let whole = symmetric(150, 1.0);
        let half = Mat::from_fn(150, 150, |i, j| if i >= j { whole[(i, j)] } else { f64::NAN });
        assert!(Reduction::new(whole).diagonal == Reduction::new(half).diagonal);
    }

    #[test]
    fn results_do_not_depend_on_the_threads() {
        let run = || Reduction::new(symmetric(500, 1.0)).beside;
        let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let alone = pool(1).install(run);
        assert!(pool(2).install(run) == alone && pool(3).install(run) == alone);
    }
}
