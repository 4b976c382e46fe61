//! Eigenvalues, axes and singular values of small matrices of floats, against another library.

use algebra::faer::Mat;
use algebra::matrix::floating::{eigenvalues, least_singular_value, product, symmetric_eigen};
use arithmetic::random::{generator, uniform};
use nalgebra::DMatrix;

/// Random matrices; some symmetric ones have eigenvalues zero, several times.
fn random(order: usize, case: u64) -> (Mat<f64>, DMatrix<f64>) {
    let mut random = generator("axes", "algebra", case * 100 + order as u64);
    let entries: Vec<f64> = (0..order * order).map(|_| 2.0 * uniform(&mut random) - 1.0).collect();
    let here = Mat::from_fn(order, order, |i, j| entries[i * order + j]);
    (here, DMatrix::from_fn(order, order, |i, j| entries[i * order + j]))
}

fn sorted(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn axes_of_symmetric_matrices() {
    for order in 1_usize..12 {
        for rank in [order, order.div_ceil(3)] {
            let (a, _) = random(order, rank as u64);
            let low = |i: usize, j: usize| (0..rank).map(|k| a[(i, k)] * a[(j, k)] * (k as f64 - 1.5)).sum();
            let symmetric = Mat::from_fn(order, order, low);
            let eigen = symmetric_eigen(&symmetric).unwrap();
            let other = DMatrix::from_fn(order, order, low).symmetric_eigenvalues();
            for (a, b) in eigen.values.iter().zip(sorted(other.iter().copied().collect())) {
                assert!((a - b).abs() < 1e-12 * (1.0 + order as f64), "{order} {rank}: {a} {b}");
            }
            let image = product(&symmetric, &eigen.vectors);
            for (i, j) in (0..order).flat_map(|i| (0..order).map(move |j| (i, j))) {
                assert!((image[(i, j)] - eigen.vectors[(i, j)] * eigen.values[j]).abs() < 1e-12);
                let dot: f64 = (0..order).map(|k| eigen.vectors[(k, i)] * eigen.vectors[(k, j)]).sum();
                assert!((dot - f64::from(u8::from(i == j))).abs() < 1e-13);
            }
        }
    }
    assert!(symmetric_eigen(&Mat::from_fn(2, 3, |_, _| 1.0)).is_err());
}

#[test]
fn singular_values_and_eigenvalues() {
    for (order, case) in (1..10).flat_map(|order| [(order, 1), (order, 2)]) {
        let (here, other) = random(order, case);
        let least = other.singular_values().min();
        assert!((least_singular_value(&here).unwrap() - least).abs() < 1e-13 * order as f64, "{order}");
        let (found, expected) = (eigenvalues(&here).unwrap(), other.complex_eigenvalues());
        for value in found {
            let nearest =
                expected.iter().map(|z| (z.re - value.re).hypot(z.im - value.im)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-9, "{order}: {value:?}");
        }
    }
}
