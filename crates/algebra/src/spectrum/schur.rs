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
use dense::{Mat, c64, complex_product};

/// Steps of the iteration for each eigenvalue.
const MOST_STEPS: usize = 60;

/// A step with a shift of another size comes after so many in vain.
const IN_VAIN: usize = 10;

/// Halvings in the search for the radius.
const HALVINGS: usize = 60;

const ZERO: c64 = c64::new(0.0, 0.0);

fn norm(a: &Mat<c64>) -> f64 {
    let squares = (0..a.ncols()).flat_map(|j| a.col_as_slice(j)).map(c64::norm_sqr);
    (squares.sum::<f64>().sqrt() + 1e-150) * SLACK
}

fn unit(i: usize, j: usize) -> c64 {
    c64::new(f64::from(u8::from(i == j)), 0.0)
}

/// Discs around the eigenvalues of a matrix given by its rows; `None` where the iteration fails or nothing is proved.
pub(super) fn triangular_spectrum(rows: &[Row]) -> Option<Vec<Eigenvalue>> {
    let order = rows.len();
    let mut a = Mat::<c64>::zeros(order, order);
    let mut errors = 0.0;
    for (i, row) in rows.iter().enumerate() {
        for &(j, value, error) in row {
            a[(i, j)] = c64::new(value, 0.0);
            errors += error * error;
        }
    }
    let Triangular { z, t } = Triangular::of(&a)?;
    let delta = perturbation(&a, errors, &z, &t)?;
    let above = Mat::from_fn(order, order, |i, j| {
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

/// The bound `δ` of the theorem for any `Z` and `T`, where the matrix that is meant is `A` but for errors with this sum of squares; `None` where `Z` is
/// too far from unitary.
fn perturbation(a: &Mat<c64>, errors: f64, z: &Mat<c64>, t: &Mat<c64>) -> Option<f64> {
    let order = a.nrows();
    // Sums of products of complex floats in any order, and one difference.
    let rounding = 8.0 * (order as f64 + 4.0) * UNIT;
    let size = norm(z);
    let adjoint = Mat::from_fn(order, order, |i, j| z[(j, i)].conj());
    let product = |left: &Mat<c64>, right: &Mat<c64>| complex_product(left.as_ref(), right.as_ref());
    let departure = norm(&(product(&adjoint, z) - Mat::from_fn(order, order, unit))) + rounding * (size * size + 1.0);
    let residual = norm(&(product(a, z) - product(z, t))) + rounding * (norm(a) + norm(t)) * size;
    let meant = if errors == 0.0 { 0.0 } else { errors.sqrt() * SLACK * size };
    if departure.is_nan() || departure >= 0.5 {
        return None;
    }
    Some(((residual + meant) / (1.0 - departure) + UNDERFLOW) * SLACK)
}

/// `AZ` is nearly `ZT` with a nearly unitary `Z` and an upper triangular `T`; nothing is promised.
struct Triangular {
    z: Mat<c64>,
    t: Mat<c64>,
}

impl Triangular {
    /// By rotations of neighbouring rows and columns: first to Hessenberg's form, then by the QR iteration with Wilkinson's shifts.
    fn of(a: &Mat<c64>) -> Option<Self> {
        let order = a.nrows();
        let mut form = Triangular { z: Mat::from_fn(order, order, unit), t: a.clone() };
        for column in 0..order.saturating_sub(2) {
            for row in (column + 1..order - 1).rev() {
                let (x, y) = (form.t[(row, column)], form.t[(row + 1, column)]);
                form.rotate(row, x, y, column, order);
            }
        }
        let (mut end, mut steps) = (order.saturating_sub(1), 0);
        while end > 0 {
            let start = (1..=end).rev().find(|&k| form.deflates(k)).unwrap_or(0);
            if start == end {
                (end, steps) = (end - 1, 0);
                continue;
            }
            steps += 1;
            if steps > MOST_STEPS {
                return None;
            }
            let shift =
                if steps % IN_VAIN == 0 { form.t[(end, end)] + form.t[(end, end - 1)] } else { form.shift(end) };
            let (mut x, mut y) = (form.t[(start, start)] - shift, form.t[(start + 1, start)]);
            for k in start..end {
                form.rotate(k, x, y, k.saturating_sub(1).max(start), (k + 3).min(end + 1));
                if k + 1 < end {
                    (x, y) = (form.t[(k + 1, k)], form.t[(k + 2, k)]);
                }
            }
        }
        for j in 0..order {
            (j + 1..order).for_each(|i| form.t[(i, j)] = ZERO);
        }
        Some(form)
    }

    /// Whether the entry before the diagonal in row `k` is nothing beside its neighbours.
    fn deflates(&self, k: usize) -> bool {
        let beside = self.t[(k - 1, k - 1)].norm() + self.t[(k, k)].norm();
        self.t[(k, k - 1)].norm() <= f64::EPSILON * beside
    }

    /// The eigenvalue of the last two rows that is nearer to the last entry.
    fn shift(&self, end: usize) -> c64 {
        let t = |i: usize, j: usize| self.t[(end + i - 1, end + j - 1)];
        let half = (t(0, 0) - t(1, 1)) * 0.5;
        let product = t(0, 1) * t(1, 0);
        let root = (half * half + product).sqrt();
        let far = if (half + root).norm_sqr() < (half - root).norm_sqr() { half - root } else { half + root };
        if far == ZERO { t(1, 1) } else { t(1, 1) - product / far }
    }

    /// The rotation of the rows `k` and `k + 1`, from a column on, that takes `(x, y)` to a multiple of `(1, 0)`; and its inverse of the
    /// columns, up to a row.
    fn rotate(&mut self, k: usize, x: c64, y: c64, from: usize, rows: usize) {
        let size = x.norm().hypot(y.norm());
        if y == ZERO || size == 0.0 {
            return;
        }
        let (c, s) = (x / size, y / size);
        for j in from..self.t.ncols() {
            let (a, b) = (self.t[(k, j)], self.t[(k + 1, j)]);
            (self.t[(k, j)], self.t[(k + 1, j)]) = (c.conj() * a + s.conj() * b, c * b - s * a);
        }
        let turn = |matrix: &mut Mat<c64>, rows: usize| {
            for i in 0..rows {
                let (a, b) = (matrix[(i, k)], matrix[(i, k + 1)]);
                (matrix[(i, k)], matrix[(i, k + 1)]) = (c * a + s * b, c.conj() * b - s.conj() * a);
            }
        };
        turn(&mut self.t, rows);
        let order = self.z.nrows();
        turn(&mut self.z, order);
    }
}

/// A radius with `δ ‖(r - N)⁻¹‖ < 1` for a strictly upper triangular matrix without negative entries, nearly the least one.
/// The inverse has no negative entries, so its row and column sums are found by substitution without cancellation; the norm is at
/// most the root of the product of the largest ones.
fn radius(above: &Mat<f64>, delta: f64) -> Option<f64> {
    let order = above.nrows();
    let enough = |r: f64| {
        let (mut rows, mut columns) = (vec![0.0; order], vec![0.0; order]);
        for k in (0..order).rev() {
            rows[k] = (1.0 + (k + 1..order).map(|j| above[(k, j)] * rows[j]).sum::<f64>()) / r;
        }
        for k in 0..order {
            columns[k] = (1.0 + (0..k).map(|i| above[(i, k)] * columns[i]).sum::<f64>()) / r;
        }
        let size = |x: &f64| if x.is_nan() { f64::INFINITY } else { *x };
        let largest = |sums: &[f64]| sums.iter().map(size).fold(0.0, f64::max);
        delta * largest(&rows).sqrt() * largest(&columns).sqrt() * SLACK < 1.0
    };
    let sum: f64 = (0..order).flat_map(|j| above.col_as_slice(j)).sum();
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

#[cfg(test)]
mod tests;
