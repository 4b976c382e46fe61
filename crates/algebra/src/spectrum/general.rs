//! Matrices that are not similar to symmetric ones in a known way: floating point with proved discs.
//!
//! **Theorem.** Let `AX = XΛ + R` with diagonal `Λ`, let `E = I - YX` with `‖E‖ = e < 1` in the maximum row sum norm. Then `X` is
//! regular, `X⁻¹AX = Λ + G` with `G = X⁻¹R = YR + E (I - E)⁻¹ YR`, and all eigenvalues lie in the union of the discs
//! around `Λ_i` with radius `|YR|_i + e ‖YR‖/(1 - e)`, where `|YR|_i` is the sum of the moduli of row `i`; a set of `k` discs
//! that meet no other one holds exactly `k` eigenvalues.
//!
//! *Proof.* `YX = I - E` is regular, so `X⁻¹ = (I - E)⁻¹ Y = (I + E (I - E)⁻¹) Y`; then Gershgorin's theorem for `Λ + G`. ∎
//!
//! This is the bound of Bauer and Fike with the condition of the eigenvectors row by row. Where the eigenvectors are nearly
//! dependent (defective matrices) the bound of [Henrici](super::schur) takes its place.

use super::Eigenvalue;
use super::block::{Row, float_rows};
use super::enclosed::merged;
use super::error::{OUT_OF_RANGE, SpectrumError};
use super::float_bounds::{SLACK, UNDERFLOW, UNIT, around};
use super::schur::triangular_spectrum;
use crate::matrix::SparseMatrix;
use dense::{Mat, MatRef, c64, complex_inverse, complex_product, eigen, product};

fn modulus(z: c64) -> f64 {
    (z.re * z.re + z.im * z.im).sqrt() + 1e-150
}

fn row_sums(a: MatRef<'_, c64>) -> Vec<f64> {
    (0..a.nrows()).map(|i| (0..a.ncols()).map(|j| modulus(a[(i, j)])).sum::<f64>() * SLACK).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, &x| if x.is_nan() { f64::INFINITY } else { f64::max(most, x) })
}

/// Floating-point enclosures of the eigenvalues of a matrix.
///
/// # Errors
/// [`SpectrumError::Unproved`].
pub(super) fn general_spectrum(matrix: &SparseMatrix) -> Result<Vec<Eigenvalue>, SpectrumError> {
    let rows: Vec<Row> = float_rows(matrix).ok_or(OUT_OF_RANGE)?;
    let parts = match diagonalised(&rows) {
        Some(parts) => parts,
        None => triangular_spectrum(&rows).ok_or(UNPROVED)?,
    };
    Ok(merged(parts).into_iter().map(real_if_alone).collect())
}

const UNPROVED: SpectrumError =
    SpectrumError::Unproved("its eigenvectors are too close to dependent for floating point");

/// Discs around computed eigenvalues.
fn diagonalised(rows: &[Row]) -> Option<Vec<Eigenvalue>> {
    let order = rows.len();
    let mut floats = Mat::<f64>::zeros(order, order);
    for (i, row) in rows.iter().enumerate() {
        row.iter().for_each(|&(j, value, _)| floats[(i, j)] = value);
    }
    let eigen = eigen(floats.as_ref())?;
    discs(rows, &floats, eigen.vectors.as_ref(), &eigen.values)?
        .into_iter()
        .zip(eigen.values)
        .map(|(radius, centre)| disc(centre, radius))
        .collect()
}

fn disc(centre: c64, radius: f64) -> Option<Eigenvalue> {
    Some(Eigenvalue { re: around(centre.re, radius)?, im: around(centre.im, radius)?, multiplicity: 1, exact: None })
}

/// The radii of the theorem above for any `X` and `Λ`; `None` where `X` is too close to singular.
fn discs(rows: &[Row], floats: &Mat<f64>, x: MatRef<'_, c64>, values: &[c64]) -> Option<Vec<f64>> {
    let order = rows.len();
    let inverse = complex_inverse(x);
    let image = image(rows, floats, x);
    let residual = Mat::from_fn(order, order, |i, k| image[(i, k)] - values[k] * x[(i, k)]);
    // The rounding of AX - XΛ and of A, summed over each row: a row of |A||X| has the sum of |A| times the row sums of |X|.
    let sums_of_x = row_sums(x);
    let lost = |(i, row): (usize, &Row)| {
        let sizes: f64 = row.iter().map(|&(j, value, _)| value.abs() * sums_of_x[j]).sum();
        let errors: f64 = row.iter().map(|&(j, _, error)| error * sums_of_x[j]).sum();
        let shifts: f64 = (0..order).map(|k| modulus(values[k]) * modulus(x[(i, k)])).sum();
        let rounding = 8.0 * (row.len() as f64 + 4.0) * UNIT;
        (rounding * (sizes + shifts) + errors) * SLACK + order as f64 * UNDERFLOW
    };
    let lost: Vec<f64> = rows.iter().enumerate().map(lost).collect();
    let rounding = 8.0 * (order as f64 + 4.0) * UNIT;
    let inverse_sums = row_sums(inverse.as_ref());
    let near_identity = complex_product(inverse.as_ref(), x);
    let defect = Mat::from_fn(order, order, |i, j| near_identity[(i, j)] - c64::new(f64::from(u8::from(i == j)), 0.0));
    let size = largest(&sums_of_x);
    let e = (largest(&row_sums(defect.as_ref())) + rounding * (largest(&inverse_sums) * size + 2.0)) * SLACK;
    if e.is_nan() || e >= 0.5 {
        return None;
    }
    let moved = complex_product(inverse.as_ref(), residual.as_ref());
    let residual_size = largest(&row_sums(residual.as_ref()));
    let lost = largest(&lost);
    let bound = |(own, inverse): (f64, f64)| (own + inverse * (rounding * residual_size + lost)) * SLACK + UNDERFLOW;
    let sums: Vec<f64> = row_sums(moved.as_ref()).into_iter().zip(inverse_sums).map(bound).collect();
    let common = e * largest(&sums) / (1.0 - e);
    Some(sums.into_iter().map(|sum| (sum + common) * SLACK).collect())
}

/// A matrix with more than one entry in so many is multiplied as a dense one.
const SPARSE: usize = 12;

/// `AX`, every entry a sum of products in some order.
fn image(rows: &[Row], floats: &Mat<f64>, x: MatRef<'_, c64>) -> Mat<c64> {
    let order = rows.len();
    if rows.iter().map(Vec::len).sum::<usize>() > order * order / SPARSE {
        let part = |part: fn(c64) -> f64| {
            product(floats.as_ref(), Mat::from_fn(order, order, |i, j| part(x[(i, j)])).as_ref())
        };
        let (re, im) = (part(|z| z.re), part(|z| z.im));
        return Mat::from_fn(order, order, |i, j| c64::new(re[(i, j)], im[(i, j)]));
    }
    let entry =
        |i: usize, k: usize| rows[i].iter().fold(c64::new(0.0, 0.0), |sum, &(j, value, _)| sum + x[(j, k)] * value);
    Mat::from_fn(order, order, entry)
}

/// Eigenvalues of real matrices come in conjugate pairs: one alone in an enclosure that is its own mirror image is real.
fn real_if_alone(part: Eigenvalue) -> Eigenvalue {
    let mirrored = *part.im.lo() == part.im.hi().negated();
    if part.multiplicity == 1 && mirrored { Eigenvalue::real(part.re, 1) } else { part }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{assert_equals, assert_rounded_up, whole};
    use super::*;

    /// Rows with entries that are known up to `error`, and the same as a matrix.
    fn matrix(order: usize, error: f64, entry: impl Fn(usize, usize) -> f64) -> (Vec<Row>, Mat<f64>) {
        let row = |i: usize| (0..order).map(|j| (j, entry(i, j), error)).filter(|(_, x, _)| *x != 0.0).collect();
        ((0..order).map(row).collect(), Mat::from_fn(order, order, entry))
    }

    /// Upper triangular with ones on the diagonal, whole numbers beside it: so is the inverse, and no product of few of them is rounded.
    fn slanted(order: usize) -> Mat<c64> {
        Mat::from_fn(order, order, |i, j| match j.checked_sub(i) {
            Some(0) => c64::new(1.0, 0.0),
            Some(1) => c64::new(0.0, 2.0),
            _ => c64::new(0.0, 0.0),
        })
    }

    #[test]
    fn radii_are_row_sums_of_the_transformed_residual() {
        for order in [1, 2, 3, 6] {
            // Dense, and with few entries.
            for keep in [1, 17] {
                let (rows, floats) = matrix(order, 0.0, |i, j| if (i + j) % keep == 0 { whole(i, j) } else { 0.0 });
                let (x, values) =
                    (slanted(order), (0..order).map(|k| c64::new(whole(k, 3) + 0.5, 1.0)).collect::<Vec<_>>());
                let entry = |a: &dyn Fn(usize) -> c64, b: &dyn Fn(usize) -> c64| {
                    (0..order).fold(c64::new(0.0, 0.0), |sum, k| sum + a(k) * b(k))
                };
                let real = |x: f64| c64::new(x, 0.0);
                let residual = Mat::from_fn(order, order, |i, k| {
                    entry(&|j| real(floats[(i, j)]), &|j| x[(j, k)]) - values[k] * x[(i, k)]
                });
                // (-2i)^(j - i) above the diagonal.
                let inverse = Mat::from_fn(order, order, |i, j| match j.checked_sub(i) {
                    None => real(0.0),
                    Some(steps) => (0..steps).fold(real(1.0), |power, _| power * c64::new(0.0, -2.0)),
                });
                let found = discs(&rows, &floats, x.as_ref(), &values).expect("regular");
                for (i, radius) in found.into_iter().enumerate() {
                    let moved = |k: usize| entry(&|j| inverse[(i, j)], &|j| residual[(j, k)]);
                    let exact: f64 = (0..order).map(|k| moved(k).re.hypot(moved(k).im)).sum();
                    assert_rounded_up(radius, exact, &format!("{order}, {keep}, {i}"));
                }
            }
        }
    }

    /// `X = I` and `A = Λ` but for the errors of the entries: they and the rounding are all that is left.
    #[test]
    fn errors_of_entries_and_rounding_count_as_derived() {
        for order in [1, 2, 5, 20] {
            let identity = Mat::from_fn(order, order, |i, j| c64::new(f64::from(u8::from(i == j)), 0.0));
            let values = vec![c64::new(3.0, 0.0); order];
            for error in [0.25, 0.0] {
                let (rows, floats) = matrix(order, error, |i, j| if i == j { 3.0 } else { 0.0 });
                // 8 (1 + 4) u (|A| |X| + |X Λ|) for the only entry of each row of AX - XΛ; e = 8 (n + 4) u 3 is common to all.
                let lost = 40.0 * UNIT * 6.0 + error;
                let e = 8.0 * (order as f64 + 4.0) * UNIT * 3.0;
                for radius in discs(&rows, &floats, identity.as_ref(), &values).expect("regular") {
                    assert_rounded_up(radius, lost + e * lost / (1.0 - e), &format!("{order}, {error}"));
                }
            }
        }
    }

    /// A diagonal `X` and a row with a residual among rows without: what the others add to the radius of these shows.
    #[test]
    fn what_is_common_to_all_rows_counts_as_derived() {
        let s = SLACK;
        type Floats = &'static [f64];
        let small: Floats = &[1.0, 1.0 / 35_184_372_088_832.0];
        let large: Floats = &[35_184_372_088_832.0];
        let cases: [(Floats, Floats, Floats, f64); 6] = [
            (&[1.0, 1.0, 1.0], &[3.0, -3.0, 3.0], &[3.0, -3.0, 5.0], 0.0),
            (&[1.0, 2.0, 0.25], &[3.0, -3.0, 3.0], &[3.0, -3.0, 5.0], 0.0),
            (&[4.0, 2.0, 0.25], &[-6.0, 0.5, 3.0], &[-6.0, 2.0, 3.0], 0.0),
            (&[4.0, 2.0, 0.25], &[-6.0, 0.5, 3.0], &[-6.0, 0.5, 3.0], 0.125),
            (small, &[2.0, -7.0], &[3.0, -7.0], 0.0),
            (large, &[2.0], &[3.0], 0.5),
        ];
        for (x, a, values, error) in cases {
            let n = x.len();
            let (rows, floats) = matrix(n, error, |i, j| if i == j { a[i] } else { 0.0 });
            let vectors = Mat::from_fn(n, n, |i, j| c64::new(0.0, if i == j { x[i] } else { 0.0 }));
            let values: Vec<c64> = values.iter().map(|&value| c64::new(value, 0.0)).collect();
            let most = |list: &dyn Fn(usize) -> f64| (0..n).map(list).fold(0.0, f64::max);
            let off = |i: usize| (a[i] - values[i].re).abs();
            let lost =
                most(&|i| (40.0 * UNIT * (a[i].abs() * x[i] * s + values[i].re.abs() * x[i]) + error * x[i] * s) * s);
            let rounding = 8.0 * (n as f64 + 4.0) * UNIT;
            let e = rounding * (most(&|i| s / x[i]) * most(&|i| x[i] * s) + 2.0) * s;
            let residual = most(&|i| off(i) * x[i] * s);
            let sum = |i: usize| (off(i) * s + s / x[i] * (rounding * residual + lost)) * s;
            let derived = |i: usize| (sum(i) + e * most(&sum) / (1.0 - e)) * s;
            let found = discs(&rows, &floats, vectors.as_ref(), &values).expect("regular");
            (0..n).for_each(|i| assert_equals(found[i], derived(i), &format!("{x:?}, {a:?}, {i}")));
        }
        // e is 48 u times the condition: 0.17, 0.67 and 1.3.
        for (small, is_regular) in [(3.1e-14, true), (8e-15, false), (4e-15, false), (0.0, false)] {
            let (rows, floats) = matrix(2, 0.0, |i, j| f64::from(u8::from(i == j)));
            let x = Mat::from_fn(2, 2, |i, j| {
                c64::new(
                    if i != j {
                        0.0
                    } else if i == 0 {
                        1.0
                    } else {
                        small
                    },
                    0.0,
                )
            });
            assert_eq!(discs(&rows, &floats, x.as_ref(), &[c64::new(1.0, 0.0); 2]).is_some(), is_regular);
        }
    }

    #[test]
    fn vectors_that_are_too_close_to_dependent_are_refused() {
        let (rows, floats) = matrix(2, 0.0, |i, j| f64::from(u8::from(i == j)));
        let values = [c64::new(1.0, 0.0); 2];
        for apart in [0.0, 1e-16, f64::NAN] {
            let x = Mat::from_fn(2, 2, |i, j| c64::new(if (i, j) == (1, 1) { 1.0 + apart } else { 1.0 }, 0.0));
            assert!(discs(&rows, &floats, x.as_ref(), &values).is_none(), "{apart}");
        }
        let x = Mat::from_fn(2, 2, |i, j| c64::new(if (i, j) == (1, 1) { 2.0 } else { 1.0 }, 0.0));
        assert!(discs(&rows, &floats, x.as_ref(), &values).is_some());
        assert_eq!(largest(&[1.0, f64::NAN, 2.0]), f64::INFINITY);
        assert_eq!([largest(&[]), largest(&[3.0, 1.0])], [0.0, 3.0]);
        assert!(modulus(c64::new(1e-170, 0.0)) >= 1e-170);
    }
}
