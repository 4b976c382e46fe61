//! Products of the trailing part of a symmetric matrix with vectors, in two parts of equal size. The second one is worked out by another
//! thread if one is free, otherwise by the one that asks; so the results do not depend on the number of threads, and nobody waits for a
//! part that nobody has begun. Handing each part to the thread pool would take as long as the part.

use dense::MatRef;
use pulp::Simd;
use std::hint::spin_loop;
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Mutex, PoisonError, RwLock};

/// Order from which products have two parts.
const LARGE: usize = 256;

/// Columns that are worked on together.
const TOGETHER: usize = 4;

/// Looks at the state before other threads are let in.
const LOOKS: usize = 64;

/// How far the second part of a product is.
const NOTHING: u8 = 0;
const ASKED: u8 = 1;
const BEGUN: u8 = 2;
const DONE: u8 = 3;
const OVER: u8 = 4;

/// A symmetric matrix of which only the part on and below the diagonal is read.
pub(super) struct Trailing<'a> {
    matrix: MatRef<'a, f64>,
    state: AtomicU8,
    /// What the second part is asked for.
    vector: RwLock<Vec<f64>>,
    second: Mutex<Vec<f64>>,
}

impl<'a> Trailing<'a> {
    pub fn new(matrix: MatRef<'a, f64>) -> Self {
        let (vector, second) = Default::default();
        Trailing { matrix, state: AtomicU8::new(NOTHING), vector, second }
    }

    /// Does work that consists of products for the most part.
    pub fn during<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        if self.matrix.nrows() < LARGE {
            return work();
        }
        let watched = || {
            let _end = Leave(&self.state, OVER);
            work()
        };
        rayon::join(watched, || self.help()).0
    }

    /// `A x`, where `A` is what remains of the matrix with as many rows and columns as `x`.
    #[inline(always)]
    pub fn times<S: Simd>(&self, simd: S, x: &[f64], y: &mut [f64]) {
        let order = x.len();
        y.fill(0.0);
        if order < LARGE {
            return multiply(simd, self.rest(order), 0..order, x, y);
        }
        {
            let mut vector = self.vector.write().unwrap_or_else(PoisonError::into_inner);
            vector.clear();
            vector.extend_from_slice(x);
        }
        self.state.store(ASKED, Ordering::Release);
        multiply(simd, self.rest(order), 0..middle(order), x, y);
        if !self.answer() {
            self.wait_while(|state| state != DONE);
        }
        let second = self.second.lock().unwrap_or_else(PoisonError::into_inner);
        y[middle(order)..].iter_mut().zip(second.iter()).for_each(|(y, part)| *y += part);
    }

    /// Works out second parts until the end.
    fn help(&self) {
        while self.wait_while(|state| state != ASKED && state != OVER) != OVER {
            self.answer();
        }
    }

    /// Works out the second part unless another thread has begun to.
    fn answer(&self) -> bool {
        let mine = self.state.compare_exchange(ASKED, BEGUN, Ordering::AcqRel, Ordering::Acquire).is_ok();
        if mine {
            let _done = Leave(&self.state, DONE);
            let vector = self.vector.read().unwrap_or_else(PoisonError::into_inner);
            let mut second = self.second.lock().unwrap_or_else(PoisonError::into_inner);
            let (order, first) = (vector.len(), middle(vector.len()));
            second.clear();
            second.resize(order - first, 0.0);
            let rest = self.rest(order - first);
            pulp::Arch::new().dispatch(Second { rest, x: &vector[first..], y: &mut second });
        }
        mine
    }

    fn wait_while(&self, waiting: impl Fn(u8) -> bool) -> u8 {
        for look in 1usize.. {
            let state = self.state.load(Ordering::Acquire);
            if !waiting(state) {
                return state;
            }
            if look.is_multiple_of(LOOKS) { std::thread::yield_now() } else { spin_loop() }
        }
        OVER
    }

    /// The last rows and columns.
    fn rest(&self, order: usize) -> MatRef<'a, f64> {
        let from = self.matrix.nrows() - order;
        self.matrix.submatrix(from, from, order, order)
    }
}

/// Says at its end how far the work is, even if it ends by a panic, which the other thread must not wait through.
struct Leave<'a>(&'a AtomicU8, u8);

impl Drop for Leave<'_> {
    fn drop(&mut self) {
        self.0.store(self.1, Ordering::Release);
    }
}

/// The second part begins with this column: as many entries on and below the diagonal are in the columns before, as `1 - 1/√2 = 0.293`.
fn middle(order: usize) -> usize {
    (order * 293 / 1000).next_multiple_of(TOGETHER)
}

struct Second<'a> {
    rest: MatRef<'a, f64>,
    x: &'a [f64],
    y: &'a mut [f64],
}

impl pulp::WithSimd for Second<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        multiply(simd, self.rest, 0..self.x.len(), self.x, self.y);
    }
}

/// Adds to `y` what these columns of `A`, and the same rows, contribute to `A x`.
#[inline(always)]
fn multiply<S: Simd>(simd: S, a: MatRef<'_, f64>, places: std::ops::Range<usize>, x: &[f64], y: &mut [f64]) {
    for start in places.clone().step_by(TOGETHER) {
        let end = (start + TOGETHER).min(places.end);
        let Some(own) = x[start..end].first_chunk::<TOGETHER>() else {
            // The last few columns.
            for j in start..end {
                y[j] += a[(j, j)] * x[j];
                for i in j + 1..end {
                    y[i] += a[(i, j)] * x[j];
                    y[j] += a[(i, j)] * x[i];
                }
            }
            break;
        };
        let columns: [&[f64]; TOGETHER] = std::array::from_fn(|k| match a.col(start + k).try_as_col_major() {
            Some(column) => column.as_slice(),
            None => &[],
        });
        // The square at the diagonal, kept out of the memory on the way.
        let mut corner = [0.0; TOGETHER];
        for (j, column) in columns.iter().enumerate() {
            let Some(column) = column[start..].first_chunk::<TOGETHER>() else { break };
            corner[j] += column[j] * own[j];
            for i in j + 1..TOGETHER {
                corner[i] += column[i] * own[j];
                corner[j] += column[i] * own[i];
            }
        }
        let parts = columns.map(|column| S::as_simd_f64s(&column[end..]));
        let ((x_head, x_tail), (y_head, y_tail)) = (S::as_simd_f64s(&x[end..]), S::as_mut_simd_f64s(&mut y[end..]));
        let splats = own.map(|factor| simd.splat_f64s(factor));
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
                *y += parts[k].1[i] * own[k];
                found[k] += parts[k].1[i] * x;
            }
        }
        y[start..end].iter_mut().zip(corner).zip(found).for_each(|((y, corner), sum)| *y += corner + sum);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dense::Mat;

    struct Whole<'a>(&'a Trailing<'a>, &'a [f64]);

    impl pulp::WithSimd for Whole<'_> {
        type Output = Vec<f64>;

        fn with_simd<S: Simd>(self, simd: S) -> Vec<f64> {
            let mut y = vec![f64::NAN; self.1.len()];
            self.0.times(simd, self.1, &mut y);
            y
        }
    }

    /// Products of all orders with vectors of small integers: exact, so that the order of summation does not matter.
    fn check(rows: usize) {
        let entry = |i: usize, j: usize| ((i * 7 + j * 13) % 11) as f64 - 5.0;
        let matrix = Mat::from_fn(rows, rows, |i, j| if i >= j { entry(i, j) } else { f64::NAN });
        let trailing = Trailing::new(matrix.as_ref());
        trailing.during(|| {
            for order in (1..=rows).rev().step_by(37) {
                let (from, x) = (rows - order, (0..order).map(|i| (i % 9) as f64 - 4.0).collect::<Vec<f64>>());
                let row = |i: usize| (0..order).map(move |j| entry(from + i.max(j), from + i.min(j)));
                let naive: Vec<f64> = (0..order).map(|i| row(i).zip(&x).map(|(a, x)| a * x).sum()).collect();
                assert!(pulp::Arch::new().dispatch(Whole(&trailing, &x)) == naive, "{rows} {order}");
            }
        });
    }

    #[test]
    fn products_are_those_of_the_whole_matrix_with_and_without_help() {
        for threads in 1..4 {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            pool.install(|| [1, 2, 5, 100, 255, 256, 257, 300, 701].into_iter().for_each(check));
        }
    }

    #[test]
    #[should_panic(expected = "in the middle")]
    fn nobody_waits_for_work_that_ended_by_a_panic() {
        let matrix = Mat::<f64>::zeros(LARGE, LARGE);
        Trailing::new(matrix.as_ref()).during(|| panic!("in the middle"));
    }

    #[test]
    fn the_parts_are_of_equal_size() {
        for order in [256usize, 1000, 3000] {
            let first: usize = (0..middle(order)).map(|j| order - j).sum();
            let share = first as f64 / (order * (order + 1) / 2) as f64;
            assert!((share - 0.5).abs() < 0.02, "{order}: {share}");
        }
    }
}
