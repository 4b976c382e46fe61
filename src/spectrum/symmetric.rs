//! Real symmetric matrices: floating-point eigenvalues with proved enclosures, whatever their multiplicities.
//!
//! **Theorem.** Let `S` be symmetric, `V` square, `Λ` real diagonal, `‖VᵀV - I‖₂ <= ε < 1` and `‖SV - VΛ‖₂ <= ρ`. With both
//! sequences in order, `|λ_k(S) - Λ_k| <= β + (|Λ_k| + β) ε/(1 - ε)`, where `β = ε max |Λ| + sqrt(1 + ε) ρ`.
//!
//! *Proof.* `VᵀSV = Λ + (VᵀV - I)Λ + Vᵀ(SV - VΛ)`, and the last two terms together are symmetric and at most `β` in norm, so
//! `|λ_k(VᵀSV) - Λ_k| <= β` (Weyl). By Ostrowski's theorem `λ_k(VᵀSV) = θ λ_k(S)` with `θ` between the least and the
//! largest eigenvalue of `VᵀV`, so `|θ - 1| <= ε`. ∎
//!
//! Nothing is assumed of how `V` and `Λ` were found. Enclosures that overlap are reported as one with their number.

use super::Eigenvalue;
use super::enclosed::merged;
use super::float_bounds::{SLACK, UNIT, around, frobenius, product};
use crate::matrix::floating::EigenError;
use faer::{Mat, MatRef, Side};

/// Encloses the eigenvalues of every symmetric matrix within `error` (in the Frobenius norm) of `s`, which is symmetric.
///
/// # Errors
/// [`EigenError::NoConvergence`], also where no bound could be proved.
pub(super) fn symmetric_spectrum(s: MatRef<'_, f64>, error: f64) -> Result<Vec<Eigenvalue>, EigenError> {
    let order = s.nrows();
    let eigen = s.self_adjoint_eigen(Side::Lower).map_err(|_| EigenError::NoConvergence)?;
    let vectors = eigen.U();
    let values: Vec<f64> = (0..order).map(|k| eigen.S()[k]).collect();
    let skew = departure(vectors);
    let residual = residual(s, vectors, &values);
    if skew.is_nan() || skew >= 0.5 || !residual.is_finite() {
        return Err(EigenError::NoConvergence);
    }
    let largest = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let beta = (skew * largest + (1.0 + skew) * residual) * SLACK;
    let radius = |value: f64| (beta + (value.abs() + beta) * skew / (1.0 - skew) + error) * SLACK;
    let mut sorted = values;
    sorted.sort_by(f64::total_cmp);
    let parts = sorted.into_iter().map(|value| Some(Eigenvalue::real(around(value, radius(value))?, 1)));
    Ok(merged(parts.collect::<Option<_>>().ok_or(EigenError::NoConvergence)?))
}

/// `‖VᵀV - I‖`, rounded up.
fn departure(v: MatRef<'_, f64>) -> f64 {
    let gram = product(v.transpose(), v);
    let order = v.ncols();
    let near = Mat::from_fn(order, order, |i, j| gram.exact[(i, j)] - if i == j { 1.0 } else { 0.0 });
    let sum = &near + &gram.rest;
    frobenius(sum.as_ref()) + 4.0 * UNIT * (frobenius(near.as_ref()) + frobenius(gram.rest.as_ref())) + gram.error
}

/// `‖SV - VΛ‖`, rounded up.
fn residual(s: MatRef<'_, f64>, v: MatRef<'_, f64>, values: &[f64]) -> f64 {
    let image = product(s, v);
    let (rows, cols) = (v.nrows(), v.ncols());
    // v λ = rounded + lost, exactly.
    let rounded = |i: usize, j: usize| v[(i, j)] * values[j];
    let lost = |i: usize, j: usize| v[(i, j)].mul_add(values[j], -rounded(i, j));
    let near = Mat::from_fn(rows, cols, |i, j| image.exact[(i, j)] - rounded(i, j));
    let small = Mat::from_fn(rows, cols, |i, j| image.rest[(i, j)] - lost(i, j));
    let sum = &near + &small;
    let rounding = 4.0 * UNIT * (frobenius(near.as_ref()) + frobenius(small.as_ref()));
    frobenius(sum.as_ref()) + rounding + image.error
}
