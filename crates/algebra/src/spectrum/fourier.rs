//! The discrete Fourier transform `X_k = sum_j x_j e^(2 pi i jk/n)` in floats, with proved errors.
//!
//! **Powers of two.** `n = n1 n2`, `j = j1 n2 + j2`, `k = k1 + n1 k2`: transforms of length `n1` over `j1` for all `j2`, factors
//! `e^(2 pi i j2 k1/n)`, transforms of length `n2` over `j2` for all `k1`. Both steps work on panels of a few columns at once
//! (Stockham's passes of radix four), panel by panel in parallel. No sum depends on the number of threads.
//!
//! *Error.* In this graph of operations exactly one path leads from each input to each output. Let `S(v)` be the sum of the
//! moduli of the inputs that lead to a value `v`, and `ε S(v)` a bound of its error. A sum of values with disjoint inputs
//! has the bound `((1 + ε)(1 + u) - 1) S`; a product with a root of unity that has the relative error `μ`,
//! `((1 + ε)(1 + √5 u)(1 + μ) - 1) S` (Brent, Percival and Zimmermann 2007). On a path there are `log2 n` sums, a root for each
//! pass, and one that is the product of two. So `|X̂_k - X_k| <= ε sum_j |x_j|` with `ε` of [`transform_error`]. Each step is
//! unitary up to a factor and its own errors are relative to its results, so also `‖X̂ - X‖₂ <= ε √n ‖x‖₂` (Higham, Accuracy and
//! Stability of Numerical Algorithms, 24.2).
//!
//! **Other lengths** (Bluestein 1970). With `h_j = e^(pi i j²/n)`, `X_k = h_k sum_j (x_j h_j) conj h_(k-j)`: a cyclic convolution
//! of length `m >= 2n - 1`, a power of two. See [`bluestein`] for its error.

use super::float_bounds::{SLACK, UNDERFLOW, UNIT};
use super::turn::{ROOT_ERROR, root_of_unity};
use arithmetic::threads::map;
use rayon::prelude::*;

/// Columns that are transformed together.
const WIDTH: usize = 8;

/// Relative error of a product of complex floats, and a little.
const PRODUCT_ERROR: f64 = 2.24 * UNIT;

/// Complex numbers, the real parts apart from the imaginary ones.
#[derive(Debug, Clone, Default)]
pub(super) struct Complexes {
    pub re: Vec<f64>,
    pub im: Vec<f64>,
}

impl Complexes {
    fn zeros(length: usize) -> Self {
        Complexes { re: vec![0.0; length], im: vec![0.0; length] }
    }
}

/// All roots of unity of one order.
struct Roots(Vec<(f64, f64)>);

impl Roots {
    fn new(order: usize) -> Self {
        Roots((0..order).map(|k| root_of_unity(k as u64, order as u64)).collect())
    }
}

fn times((a, b): (f64, f64), (c, d): (f64, f64)) -> (f64, f64) {
    (a * c - b * d, a * d + b * c)
}

/// Passes of radix four, and one of radix two for odd powers.
fn passes(length: usize) -> u32 {
    length.ilog2().div_ceil(2)
}

/// The two lengths of a power of two.
fn split(n: usize) -> (usize, usize) {
    let half = n.ilog2().div_ceil(2);
    (1 << half, n >> half)
}

/// `ε` for a power of two; [`SLACK`] covers terms of second order.
pub(super) fn transform_error(n: usize) -> f64 {
    let (n1, n2) = split(n);
    let root = PRODUCT_ERROR + ROOT_ERROR;
    (f64::from(n.ilog2()) * UNIT + f64::from(passes(n1) + passes(n2)) * root + 2.0 * root) * SLACK
}

/// A panel: `length` rows of `width` numbers, transformed by columns in place with scratch of the same size.
struct Panel {
    width: usize,
    data: Complexes,
    other: Complexes,
}

impl Panel {
    fn new(length: usize, width: usize) -> Self {
        Panel { width, data: Complexes::zeros(length * width), other: Complexes::zeros(length * width) }
    }

    fn transform(&mut self, roots: &Roots) {
        let length = roots.0.len();
        let (mut left, mut run) = (length, self.width);
        while left >= 4 {
            radix_four(&self.data, &mut self.other, left, run, &roots.0, length / left);
            std::mem::swap(&mut self.data, &mut self.other);
            (left, run) = (left / 4, 4 * run);
        }
        if left == 2 {
            for (from, to) in [(&self.data.re, &mut self.other.re), (&self.data.im, &mut self.other.im)] {
                let (low, high) = from.split_at(run);
                let (sum, difference) = to.split_at_mut(run);
                for q in 0..run {
                    (sum[q], difference[q]) = (low[q] + high[q], low[q] - high[q]);
                }
            }
            std::mem::swap(&mut self.data, &mut self.other);
        }
    }
}

/// One pass: transforms of length `left` on rows of `run` numbers become four times as many of a quarter of the length.
fn radix_four(from: &Complexes, to: &mut Complexes, left: usize, run: usize, roots: &[(f64, f64)], step: usize) {
    let quarter = left / 4;
    for p in 0..quarter {
        let part = |i: usize| run * (p + i * quarter)..run * (p + i * quarter + 1);
        let [ar, br, cr, dr] = [0, 1, 2, 3].map(|i| &from.re[part(i)]);
        let [ai, bi, ci, di] = [0, 1, 2, 3].map(|i| &from.im[part(i)]);
        let place = 4 * run * p..4 * run * (p + 1);
        let (re, im) = (&mut to.re[place.clone()], &mut to.im[place]);
        let [(w1r, w1i), (w2r, w2i), (w3r, w3i)] = [1, 2, 3].map(|i| roots[i * p * step]);
        let (re0, re) = re.split_at_mut(run);
        let (re1, re) = re.split_at_mut(run);
        let (re2, re3) = re.split_at_mut(run);
        let (im0, im) = im.split_at_mut(run);
        let (im1, im) = im.split_at_mut(run);
        let (im2, im3) = im.split_at_mut(run);
        for q in 0..run {
            let (sr, si, tr, ti) = (ar[q] + cr[q], ai[q] + ci[q], ar[q] - cr[q], ai[q] - ci[q]);
            let (vr, vi, wr, wi) = (br[q] + dr[q], bi[q] + di[q], br[q] - dr[q], bi[q] - di[q]);
            (re0[q], im0[q]) = (sr + vr, si + vi);
            let (xr, xi) = (tr - wi, ti + wr);
            (re1[q], im1[q]) = (xr * w1r - xi * w1i, xr * w1i + xi * w1r);
            let (xr, xi) = (sr - vr, si - vi);
            (re2[q], im2[q]) = (xr * w2r - xi * w2i, xr * w2i + xi * w2r);
            let (xr, xi) = (tr + wi, ti - wr);
            (re3[q], im3[q]) = (xr * w3r - xi * w3i, xr * w3i + xi * w3r);
        }
    }
}

/// Transforms in blocks: the number `k = k1 + n1 k2` of a result is found by [`Blocks::get`].
pub(super) struct Blocks {
    data: Complexes,
    rows: usize,
    /// Binary logarithms of the numbers of columns, and of those in a block.
    columns: u32,
    width: u32,
}

impl Blocks {
    /// The result number `k`.
    #[inline(always)]
    pub fn get(&self, k: usize) -> (f64, f64) {
        let (column, row) = (k & ((1 << self.columns) - 1), k >> self.columns);
        let place = (((column >> self.width) * self.rows + row) << self.width) + (column & ((1 << self.width) - 1));
        (self.data.re[place], self.data.im[place])
    }
}

/// The transform of a power of two of numbers given by their index.
pub(super) fn transform(n: usize, input: &(dyn Fn(usize) -> (f64, f64) + Sync)) -> Blocks {
    let (n1, n2) = split(n);
    let (roots1, roots2) = (Roots::new(n1), Roots::new(n2));
    // e^(2 pi i e/n) as a product, e = high n1 + low.
    let low: Vec<(f64, f64)> = (0..n1).map(|e| root_of_unity(e as u64, n as u64)).collect();
    let (bits, width1) = (n1.ilog2(), WIDTH.min(n2));
    let mut middle = Complexes::zeros(n);
    let chunks = middle.re.par_chunks_mut(n1 * width1).zip(middle.im.par_chunks_mut(n1 * width1));
    chunks.enumerate().for_each_init(
        || Panel::new(n1, width1),
        |panel, (number, (re, im))| {
            let first = number * width1;
            for j1 in 0..n1 {
                for b in 0..width1 {
                    (panel.data.re[j1 * width1 + b], panel.data.im[j1 * width1 + b]) = input(j1 * n2 + first + b);
                }
            }
            panel.transform(&roots1);
            for b in 0..width1 {
                let j2 = first + b;
                for k1 in 0..n1 {
                    let e = j2 * k1;
                    let root = times(roots2.0[e >> bits], low[e & (n1 - 1)]);
                    let z = (panel.data.re[k1 * width1 + b], panel.data.im[k1 * width1 + b]);
                    (re[b * n1 + k1], im[b * n1 + k1]) = times(z, root);
                }
            }
        },
    );
    let width2 = WIDTH.min(n1);
    let mut data = Complexes::zeros(n);
    let chunks = data.re.par_chunks_mut(n2 * width2).zip(data.im.par_chunks_mut(n2 * width2));
    chunks.enumerate().for_each_init(
        || Panel::new(n2, width2),
        |panel, (number, (re, im))| {
            let first = number * width2;
            for j2 in 0..n2 {
                let from = j2 * n1 + first..j2 * n1 + first + width2;
                let to = j2 * width2..(j2 + 1) * width2;
                panel.data.re[to.clone()].copy_from_slice(&middle.re[from.clone()]);
                panel.data.im[to].copy_from_slice(&middle.im[from]);
            }
            panel.transform(&roots2);
            re.copy_from_slice(&panel.data.re);
            im.copy_from_slice(&panel.data.im);
        },
    );
    Blocks { data, rows: n2, columns: n1.ilog2(), width: width2.ilog2() }
}

/// The first `n/2 + 1` numbers of the transform of real numbers, and a bound of the error of each;
/// `None` for an empty input, and where the bound is not finite.
pub(super) fn real_transform(x: &[f64]) -> Option<(Complexes, f64)> {
    let (result, error) = match x.len() {
        0 => return None,
        1 => (Complexes { re: x.to_vec(), im: vec![0.0] }, 0.0),
        n if n.is_power_of_two() => halves(x),
        _ => bluestein(x),
    };
    error.is_finite().then_some((result, error))
}

fn sum_of_sizes(x: &[f64]) -> f64 {
    x.iter().map(|x| x.abs()).sum::<f64>() * SLACK
}

/// A power of two: even and odd places as real and imaginary parts `z_j` of a transform `Z` of half the length. With
/// `E = (Z_k + conj Z_(h-k))/2` and `O = (Z_k - conj Z_(h-k))/2i`, `X_k = E + e^(2 pi i k/n) O`. As `sum |z_j| <= ‖x‖₁`, `E` and
/// `O` have at most the error of `Z` and a rounding, and `|E|, |O| <= ‖x‖₁`.
fn halves(x: &[f64]) -> (Complexes, f64) {
    let n = x.len();
    let h = n / 2;
    let z = transform(h, &|j| (x[2 * j], x[2 * j + 1]));
    let mut result = Complexes::zeros(h + 1);
    let step = 1 << (n.ilog2() / 2);
    let low: Vec<(f64, f64)> = (0..step).map(|e| root_of_unity(e as u64, n as u64)).collect();
    let chunks = result.re.par_chunks_mut(step).zip(result.im.par_chunks_mut(step));
    chunks.enumerate().for_each(|(number, (re, im))| {
        let high = root_of_unity((number * step) as u64, n as u64);
        for (place, (re, im)) in re.iter_mut().zip(im).enumerate() {
            let k = number * step + place;
            let (ar, ai) = z.get(k & (h - 1));
            let (br, bi) = z.get((h - k) & (h - 1));
            let even = (0.5 * (ar + br), 0.5 * (ai - bi));
            let odd = (0.5 * (ai + bi), 0.5 * (br - ar));
            let turned = times(odd, times(high, low[place]));
            (*re, *im) = (even.0 + turned.0, even.1 + turned.1);
        }
    });
    let last = 2.0 * PRODUCT_ERROR + 2.0 * ROOT_ERROR + 4.0 * UNIT;
    let error = (2.0 * transform_error(h) + last) * sum_of_sizes(x) * SLACK + UNDERFLOW;
    (result, error)
}

/// Any length. Let `f_j = x_j h_j`, `g_l = conj h_l` for `|l| < n`, their transforms `F`, `G` of length `m`, `ε =` [`transform_error`] and
/// `c = ‖x‖₂`. Then `‖F̂ - F‖₂ <= (ε + μ') √m c` and `‖Ĝ - G‖₂ <= (ε + μ) √m √(2n - 1)`. By Cauchy's inequality the
/// latter moves an entry of the convolution by at most `(ε + μ) c √(2n - 1)`; the former, the roundings of the products and the inverse
/// transform move it by at most `(2 ε + μ' + √5 u) c ‖G‖_∞`; the last factor adds `(√5 u + μ) |X_k|`, and `|X_k| <= √n c`.
fn bluestein(x: &[f64]) -> (Complexes, f64) {
    let n = x.len();
    let m = (2 * n - 1).next_power_of_two();
    let chirp: Vec<(f64, f64)> =
        map(n, |j| root_of_unity((j as u128 * j as u128 % (2 * n as u128)) as u64, 2 * n as u64));
    let f = transform(m, &|j| match x.get(j) {
        Some(x) => (x * chirp[j].0, x * chirp[j].1),
        None => (0.0, 0.0),
    });
    let g = transform(m, &|l| {
        let l = l.min(m - l);
        chirp.get(l).map_or((0.0, 0.0), |h| (h.0, -h.1))
    });
    // The conjugate transform of the conjugate is the inverse one, but for the factor 1/m.
    let product = |k: usize| {
        let (re, im) = times(f.get(k), g.get(k));
        (re, -im)
    };
    let convolution = transform(m, &product);
    let mut result = Complexes::zeros(n / 2 + 1);
    let scale = 1.0 / m as f64;
    result.re.par_iter_mut().zip(&mut result.im).enumerate().for_each(|(k, (re, im))| {
        let (x, y) = convolution.get(k);
        (*re, *im) = times((x * scale, -y * scale), chirp[k]);
    });
    let roots = |x: f64| x.sqrt() * SLACK;
    let size = roots(x.iter().map(|x| x * x).sum());
    let epsilon = transform_error(m);
    let chirp_error = ROOT_ERROR + 1.5 * UNIT;
    let long = roots(2.0 * n as f64);
    let squares = g.data.re.par_iter().zip(&g.data.im).map(|(re, im)| re * re + im * im);
    // ‖Ĝ - G‖_∞ <= (ε + μ) √m ‖G‖_∞, far below SLACK, as ‖G‖_2 <= √m ‖G‖_∞.
    let largest = roots(squares.reduce(|| 0.0, f64::max));
    let inside = (2.0 * epsilon + chirp_error + PRODUCT_ERROR) * largest + (epsilon + ROOT_ERROR) * long;
    let error = (inside + (PRODUCT_ERROR + ROOT_ERROR) * roots(n as f64)) * size * SLACK + UNDERFLOW * m as f64;
    (result, error)
}

#[cfg(test)]
mod tests;
