//! Symmetric matrices of small order, thousands of them: Jacobi's rotations, whose result is proved afterwards.
//!
//! By the theorem of [`symmetric`](super::symmetric), for a diagonal `T` with the numbers `t_k` in order and any `Q` with least singular
//! value `σ`, `|λ_k(S) - t_k| <= ‖SQ - QT‖/σ`, and `σ² >= 1 - ‖QᵀQ - I‖`. Frobenius norms bound both; an entry of `SQ - QT` is a sum of
//! `n + 1` products, which rounding moves by at most `(n + 2) u` times the sum of their sizes.

use super::FloatEnclosure;
use super::float_bounds::{SLACK, UNIT};

/// Sweeps over all pairs before it is given up; six are usual.
const MOST_SWEEPS: usize = 40;

/// Underflow is far below this.
const UNDERFLOW: f64 = 1e-150;

/// The eigenvalues in order of the symmetric matrix with these entries, by rows, each with a proved bound of its error; `None` where it is not
/// square or not symmetric, or nothing is proved. For orders up to some dozens.
pub fn small_symmetric_eigenvalues(entries: &[f64], order: usize) -> Option<Vec<FloatEnclosure>> {
    let symmetric = |i: usize, j: usize| entries[i * order + j] == entries[j * order + i];
    if order.checked_mul(order) != Some(entries.len()) || !(0..order).all(|i| (0..i).all(|j| symmetric(i, j))) {
        return None;
    }
    let (values, vectors) = rotated(entries.to_vec(), order);
    let radius = radius(entries, order, &values, &vectors)?;
    let mut sorted = values;
    sorted.sort_by(f64::total_cmp);
    Some(sorted.into_iter().map(|re| FloatEnclosure { re, im: 0.0, radius, multiplicity: 1 }).collect())
}

/// Nearly the eigenvalues and eigenvectors, the latter as rows; nothing is promised.
fn rotated(mut a: Vec<f64>, n: usize) -> (Vec<f64>, Vec<f64>) {
    let mut vectors = vec![0.0; n * n];
    (0..n).for_each(|i| vectors[i * n + i] = 1.0);
    let size = a.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    for _ in 0..MOST_SWEEPS {
        let mut largest: f64 = 0.0;
        for p in 0..n {
            for q in p + 1..n {
                let beside = a[p * n + q];
                largest = largest.max(beside.abs());
                if beside == 0.0 {
                    continue;
                }
                let slope = (a[q * n + q] - a[p * n + p]) / (2.0 * beside);
                let t = slope.signum() / (slope.abs() + (slope * slope + 1.0).sqrt());
                let c = 1.0 / (t * t + 1.0).sqrt();
                let s = t * c;
                let (first, second) = (a[p * n + p] - t * beside, a[q * n + q] + t * beside);
                for rows in [&mut a, &mut vectors] {
                    let (above, below) = rows.split_at_mut(q * n);
                    for (x, y) in above[p * n..(p + 1) * n].iter_mut().zip(&mut below[..n]) {
                        (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
                    }
                }
                // The columns are the rows, except where these meet.
                (a[p * n + p], a[q * n + q], a[p * n + q], a[q * n + p]) = (first, second, 0.0, 0.0);
                for k in 0..n {
                    (a[k * n + p], a[k * n + q]) = (a[p * n + k], a[q * n + k]);
                }
            }
        }
        if largest <= UNIT * size {
            break;
        }
    }
    ((0..n).map(|i| a[i * n + i]).collect(), vectors)
}

/// The bound of the theorem; `None` where the vectors are far from orthogonal or a number is not finite.
fn radius(s: &[f64], n: usize, values: &[f64], vectors: &[f64]) -> Option<f64> {
    let norm = |list: &[f64]| list.iter().map(|x| x * x).sum::<f64>().sqrt() * SLACK;
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let (mut residual, mut departure) = (0.0, 0.0);
    for (k, value) in values.iter().enumerate() {
        let own = &vectors[k * n..(k + 1) * n];
        for i in 0..n {
            let apart = dot(&s[i * n..(i + 1) * n], own) - own[i] * value;
            residual += apart * apart;
            let unit = if i == k { 1.0 } else { 0.0 };
            let product = dot(&vectors[i * n..(i + 1) * n], own) - unit;
            departure += product * product;
        }
    }
    let rounding = (n + 2) as f64 * UNIT;
    let size = norm(vectors);
    let most = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let residual = residual.sqrt() * SLACK + rounding * (norm(s) + most) * size * SLACK + UNDERFLOW;
    let departure = departure.sqrt() * SLACK + rounding * (size * size + 1.0) * SLACK + UNDERFLOW;
    let bound = residual / (1.0 - departure).sqrt() * SLACK;
    // The last rounding of `1 - departure` is covered by SLACK while the departure is small.
    (departure < 0.1 && bound.is_finite()).then_some(bound)
}

#[cfg(test)]
mod tests {
    use super::super::testing::{assert_equals, assert_rounded_up};
    use super::*;

    fn assert_near(found: Option<f64>, exact: f64) {
        assert_rounded_up(found.expect("a bound"), exact, "the radius");
    }

    fn identity(n: usize) -> Vec<f64> {
        (0..n * n).map(|k| f64::from(u8::from(k % (n + 1) == 0))).collect()
    }

    #[test]
    fn residuals_and_departures_are_rounded_up_and_hardly_at_all() {
        // Vectors of length one at right angles, and values that are far off.
        let s = [1.0, -2.0, 4.0, -2.0, 3.0, 0.0, 4.0, 0.0, -5.0];
        assert_near(radius(&s, 3, &[2.0, 0.0, -1.0], &identity(3)), (1.0 + 9.0 + 16.0 + 2.0 * (4.0 + 16.0f64)).sqrt());
        // Vectors of another length: |3 x - x| over sqrt(1 - |x² - 1|).
        for x in [1.04, 0.97f64] {
            assert_near(radius(&[3.0], 1, &[1.0], &[x]), 2.0 * x / (1.0 - (x * x - 1.0).abs()).sqrt());
        }
        // Vectors at another angle.
        let (slant, departure) = (0.05f64, (0.0025f64.powi(2) + 2.0 * 0.05f64.powi(2)).sqrt());
        let residual = (4.0 + 9.0 + (2.0 * slant).powi(2)).sqrt();
        let found = radius(&[2.0, 0.0, 0.0, 2.0], 2, &[0.0, 5.0], &[1.0, slant, 0.0, 1.0]);
        assert_near(found, residual / (1.0 - departure).sqrt());
        assert!(radius(&[3.0], 1, &[1.0], &[1.05]).is_none() && radius(&[3.0], 1, &[f64::NAN], &[1.0]).is_none());
    }

    /// With exact values and vectors what is left is what rounding may have done: `(n + 2) u (|S| + max |t|) sqrt(n)`.
    #[test]
    fn rounding_counts_as_derived() {
        for (n, entry) in [(1, -3.0), (2, 4.0), (5, -7.0), (30, 1.0)] {
            let s: Vec<f64> = identity(n).iter().map(|x| x * entry).collect();
            let root = (n as f64).sqrt();
            let derived = (n + 2) as f64 * UNIT * (f64::abs(entry) * root + f64::abs(entry)) * root;
            assert_near(radius(&s, n, &vec![entry; n], &identity(n)), derived);
        }
    }

    /// Each norm and each bound is rounded up once; so many vectors that the rounding of the departure shows.
    #[test]
    fn the_radius_is_the_formula() {
        let s = SLACK;
        for (n, value, slant) in [(1, 2.0, 0.0), (2, -2.5, 0.0), (3, 2.0, 0.03), (400, 3.0, 0.0)] {
            let matrix: Vec<f64> = identity(n).iter().map(|x| x * 3.0).collect();
            let mut vectors = identity(n);
            if n > 1 {
                vectors[1] = slant;
            }
            let (root, n_float) = ((n as f64 + slant * slant).sqrt() * s, n as f64);
            let off = f64::abs(3.0 - value) * root;
            let departure = if n > 1 { (slant.powi(4) + 2.0 * slant * slant).sqrt() * s } else { 0.0 };
            let rounding = (n_float + 2.0) * UNIT;
            let residual = off + rounding * (3.0 * n_float.sqrt() * s + f64::abs(value)) * root * s;
            let departure = departure + rounding * (root * root + 1.0) * s;
            let derived = residual / (1.0 - departure).sqrt() * s;
            assert_equals(radius(&matrix, n, &vec![value; n], &vectors).expect("a bound"), derived, &format!("{n}"));
        }
    }

    #[test]
    fn eigenvalues_are_real_and_in_order() {
        let found = small_symmetric_eigenvalues(&[2.0, 1.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0, -5.0], 3).expect("symmetric");
        for (part, exact) in found.iter().zip([-5.0, 1.0, 3.0]) {
            assert!((part.re - exact).abs() <= part.radius && part.radius < 1e-13);
            assert_eq!((part.im, part.multiplicity), (0.0, 1));
        }
        assert!(radius(&[0.0], 1, &[0.0], &[1.0]).expect("a bound") > 0.0);
    }

    #[test]
    fn what_is_no_symmetric_matrix_is_refused() {
        for (entries, order) in
            [(vec![1.0; 3], 2), (vec![1.0; 4], 1), (vec![0.0, 1.0, 2.0, 0.0], 2), (vec![f64::NAN], 1)]
        {
            assert_eq!(small_symmetric_eigenvalues(&entries, order), None);
        }
        let last = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 2.0, 0.0];
        assert_eq!(small_symmetric_eigenvalues(&last, 3), None);
        assert_eq!(small_symmetric_eigenvalues(&[], 0), Some(Vec::new()));
        assert_eq!(small_symmetric_eigenvalues(&[], 1 << 32), None);
    }
}
