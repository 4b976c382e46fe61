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
use faer::linalg::solvers::DenseSolveCore;
use faer::{Mat, MatRef, c64};

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

/// Discs by the theorem above.
fn diagonalised(rows: &[Row]) -> Option<Vec<Eigenvalue>> {
    let order = rows.len();
    let mut floats = Mat::<f64>::zeros(order, order);
    for (i, row) in rows.iter().enumerate() {
        row.iter().for_each(|&(j, value, _)| floats[(i, j)] = value);
    }
    let eigen = floats.eigen().ok()?;
    let (x, values) = (eigen.U(), eigen.S());
    let inverse = x.partial_piv_lu().inverse();
    let image = image(rows, &floats, x);
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
    let near_identity = &inverse * x;
    let defect = Mat::from_fn(order, order, |i, j| near_identity[(i, j)] - c64::new(f64::from(u8::from(i == j)), 0.0));
    let size = largest(&sums_of_x);
    let e = (largest(&row_sums(defect.as_ref())) + rounding * (largest(&inverse_sums) * size + 2.0)) * SLACK;
    if e.is_nan() || e >= 0.5 {
        return None;
    }
    let moved = &inverse * &residual;
    let residual_size = largest(&row_sums(residual.as_ref()));
    let lost = largest(&lost);
    let bound = |(own, inverse): (f64, f64)| (own + inverse * (rounding * residual_size + lost)) * SLACK + UNDERFLOW;
    let sums: Vec<f64> = row_sums(moved.as_ref()).into_iter().zip(inverse_sums).map(bound).collect();
    let common = e * largest(&sums) / (1.0 - e);
    let disc = |i: usize| {
        let radius = (sums[i] + common) * SLACK;
        Some(Eigenvalue {
            re: around(values[i].re, radius)?,
            im: around(values[i].im, radius)?,
            multiplicity: 1,
            exact: None,
        })
    };
    (0..order).map(disc).collect()
}

/// A matrix with more than one entry in so many is multiplied as a dense one.
const SPARSE: usize = 12;

/// `AX`, every entry a sum of products in some order.
fn image(rows: &[Row], floats: &Mat<f64>, x: MatRef<'_, c64>) -> Mat<c64> {
    let order = rows.len();
    if rows.iter().map(Vec::len).sum::<usize>() > order * order / SPARSE {
        let part = |part: fn(c64) -> f64| floats * Mat::from_fn(order, order, |i, j| part(x[(i, j)]));
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
