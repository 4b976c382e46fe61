//! Matrices that are far from having a basis of eigenvectors: a bound from Schur's triangular form.
//!
//! **Theorem** (after Henrici 1962). Let `AZ = ZT + E` with `T = D + N`, `D` diagonal and `N` strictly upper triangular, `‖ZᴴZ - I‖ <= ε < 1`,
//! `‖E‖ <= ρ` and `δ = ρ/(1 - ε)`. If `δ ‖(r - |N|)⁻¹‖ < 1`, with the moduli of the entries in `|N|`, all eigenvalues of `A` lie in the
//! discs of radius `r` around the diagonal entries of `T`; a set of `k` discs that meet no other one holds exactly `k` of them.
//!
//! *Proof.* `Z` is regular with `‖Z⁻¹‖ <= 1/(1 - ε)`, so `A` is similar to `T + Δ`, `‖Δ‖ <= δ`. If `λ` is further than `r` from all
//! diagonal entries, `(λ - T)⁻¹ = sum_k ((λ - D)⁻¹ N)^k (λ - D)⁻¹`, a finite sum whose entries are at most those of
//! `sum_k |N|^k/r^(k+1) = (r - |N|)⁻¹` in modulus. So `λ - T - tΔ` is regular for `0 <= t <= 1`: no eigenvalue of `T + tΔ` leaves the
//! discs, and they move continuously with `t`. ∎
//!
//! For one Jordan block `r` is of the size `δ^(1/n)`: wide, but so is what a change of the last bit of `A` can do.

use super::Eigenvalue;
use super::block::Row;
use super::float_bounds::{SLACK, UNDERFLOW, UNIT, around};
use nalgebra::{Complex, DMatrix, Schur};

/// Steps of the iteration for each eigenvalue.
const MOST_STEPS: usize = 60;

/// Halvings in the search for the radius.
const HALVINGS: usize = 60;

fn norm(a: &DMatrix<Complex<f64>>) -> f64 {
    (a.iter().map(|z| z.re * z.re + z.im * z.im).sum::<f64>().sqrt() + 1e-150) * SLACK
}

/// Discs around the eigenvalues of a matrix given by its rows; `None` where the iteration fails or nothing is proved.
pub(super) fn triangular_spectrum(rows: &[Row]) -> Option<Vec<Eigenvalue>> {
    let order = rows.len();
    let mut a = DMatrix::<Complex<f64>>::zeros(order, order);
    let mut errors = 0.0;
    for (i, row) in rows.iter().enumerate() {
        for &(j, value, error) in row {
            a[(i, j)] = Complex::new(value, 0.0);
            errors += error * error;
        }
    }
    let (z, mut t) = Schur::try_new(a.clone(), f64::EPSILON, MOST_STEPS * order)?.unpack();
    for j in 0..order {
        (j + 1..order).for_each(|i| t[(i, j)] = Complex::new(0.0, 0.0));
    }
    // Sums of products of complex floats in any order, and one difference.
    let rounding = 8.0 * (order as f64 + 4.0) * UNIT;
    let size = norm(&z);
    let departure = norm(&(z.adjoint() * &z - DMatrix::identity(order, order))) + rounding * (size * size + 1.0);
    let residual = norm(&(&a * &z - &z * &t)) + rounding * (norm(&a) + norm(&t)) * size;
    let meant = if errors == 0.0 { 0.0 } else { errors.sqrt() * SLACK * size };
    if departure.is_nan() || departure >= 0.5 {
        return None;
    }
    let delta = ((residual + meant) / (1.0 - departure) + UNDERFLOW) * SLACK;
    let above = DMatrix::from_fn(order, order, |i, j| {
        let z = t[(i, j)];
        if i < j { (z.re * z.re + z.im * z.im).sqrt() + 1e-150 } else { 0.0 }
    });
    let radius = radius(&above, delta)? * SLACK;
    let disc = |i: usize| {
        let centre = t[(i, i)];
        Some(Eigenvalue {
            re: around(centre.re, radius)?,
            im: around(centre.im, radius)?,
            multiplicity: 1,
            exact: None,
        })
    };
    (0..order).map(disc).collect()
}

/// A radius with `δ ‖(r - N)⁻¹‖ < 1` for a strictly upper triangular matrix without negative entries, nearly the least one.
/// The inverse has no negative entries, so its row and column sums are found by substitution without cancellation; the norm is at
/// most the root of the product of the largest ones.
fn radius(above: &DMatrix<f64>, delta: f64) -> Option<f64> {
    let order = above.nrows();
    let enough = |r: f64| {
        let (mut rows, mut columns) = (vec![0.0; order], vec![0.0; order]);
        for k in (0..order).rev() {
            rows[k] = (1.0 + (k + 1..order).map(|j| above[(k, j)] * rows[j]).sum::<f64>()) / r;
        }
        for k in 0..order {
            columns[k] = (1.0 + (0..k).map(|i| above[(i, k)] * columns[i]).sum::<f64>()) / r;
        }
        let largest = |sums: &[f64]| sums.iter().fold(0.0, |most: f64, x| most.max(*x));
        delta * largest(&rows).sqrt() * largest(&columns).sqrt() * SLACK < 1.0
    };
    let sum: f64 = above.iter().sum();
    let (mut low, mut high) = (delta, 2.0 * (sum + delta) * SLACK);
    if !enough(high) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        if enough(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(high)
}
