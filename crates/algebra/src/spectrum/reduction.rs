//! Householder's reduction of a symmetric matrix to tridiagonal form, in blocks of columns (Dongarra, Sorensen and Hammarling 1989): the matrix
//! is read once for each column, and written once for each block. Nothing is promised of the result; it is the same for any
//! number of threads.

use super::reflections::{Block, Reflections};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, MatRef, Par};
use pulp::Simd;

/// Columns of a block.
const WIDTH: usize = 32;

/// Columns of the trailing matrix that one task brings up to date.
const STRIPE: usize = 128;

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
            let panel = arch.dispatch(Panel { work: work.as_ref(), from, width });
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
    Mat::from_fn(a.nrows(), 2 * width, |i, j| if j < width { a[(i, j)] } else { b[(i, j - width)] })
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
        matmul(lower, Accum::Add, left.as_ref().subrows(first, rows), right.transpose(), -1.0, Par::Seq);
    }
}

/// The reduction of a few columns, for which the rest of the matrix is read but not written.
struct Panel<'a> {
    work: MatRef<'a, f64>,
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
            for k in 0..j {
                let (a, b) = (v[(j - 1, k)], w[(j - 1, k)]);
                corner -= 2.0 * a * b;
                add(&mut below, -b, &v.col_as_slice(k)[j..]);
                add(&mut below, -a, &w.col_as_slice(k)[j..]);
            }
            diagonal.push(corner);
            let (length, weight) = reflection(&mut below);
            beside.push(length);
            let mut image = vec![0.0; rows - j];
            times(simd, self.work.submatrix(column + 1, column + 1, rows - j, rows - j), &below, &mut image);
            let mut overlaps = [0.0; WIDTH];
            for (k, overlap) in overlaps.iter_mut().enumerate().take(j) {
                let (old_v, old_w) = (&v.col_as_slice(k)[j..], &w.col_as_slice(k)[j..]);
                let (a, b) = (dot(old_v, &below), dot(old_w, &below));
                add(&mut image, -b, old_v);
                add(&mut image, -a, old_w);
                *overlap = a;
            }
            image.iter_mut().for_each(|y| *y *= weight);
            let half = -0.5 * weight * dot(&image, &below);
            add(&mut image, half, &below);
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

/// Adds a multiple of a vector.
#[inline(always)]
fn add(to: &mut [f64], factor: f64, vector: &[f64]) {
    to.iter_mut().zip(vector).for_each(|(y, x)| *y += factor * x);
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

/// Columns that [`times`] works on together.
const TOGETHER: usize = 4;

/// Adds `A x` to `y`, where only the part on and below the diagonal of `A` is read, once.
#[inline(always)]
fn times<S: Simd>(simd: S, a: MatRef<'_, f64>, x: &[f64], y: &mut [f64]) {
    let order = x.len();
    for start in (0..order).step_by(TOGETHER) {
        let end = (start + TOGETHER).min(order);
        for j in start..end {
            y[j] += a[(j, j)] * x[j];
            for i in j + 1..end {
                y[i] += a[(i, j)] * x[j];
                y[j] += a[(i, j)] * x[i];
            }
        }
        if end < start + TOGETHER {
            break;
        }
        let columns: [&[f64]; TOGETHER] = std::array::from_fn(|k| match a.col(start + k).try_as_col_major() {
            Some(column) => &column.as_slice()[end..],
            None => &[],
        });
        let factors: [f64; TOGETHER] = std::array::from_fn(|k| x[start + k]);
        let parts = columns.map(|column| S::as_simd_f64s(column));
        let ((x_head, x_tail), (y_head, y_tail)) = (S::as_simd_f64s(&x[end..]), S::as_mut_simd_f64s(&mut y[end..]));
        let splats = factors.map(|factor| simd.splat_f64s(factor));
        let mut sums = [simd.splat_f64s(0.0); TOGETHER];
        for (i, (x, y)) in x_head.iter().zip(y_head).enumerate() {
            let mut total = *y;
            for k in 0..TOGETHER {
                let entry = parts[k].0[i];
                total = simd.mul_add_f64s(entry, splats[k], total);
                sums[k] = simd.mul_add_f64s(entry, *x, sums[k]);
            }
            *y = total;
        }
        let mut found = sums.map(|sum| simd.reduce_sum_f64s(sum));
        for (i, (x, y)) in x_tail.iter().zip(y_tail).enumerate() {
            for k in 0..TOGETHER {
                *y += parts[k].1[i] * factors[k];
                found[k] += parts[k].1[i] * x;
            }
        }
        found.iter().enumerate().for_each(|(k, sum)| y[start + k] += sum);
    }
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
