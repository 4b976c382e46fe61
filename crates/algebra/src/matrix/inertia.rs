//! How many eigenvalues of a symmetric matrix are positive, negative and zero, over any ordered field.

use super::SparseMatrix;
use arithmetic::{ArithmeticError, Field, Rational, Sign, Signed};

/// Numbers of positive, negative and zero eigenvalues.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Inertia {
    /// Positive ones.
    pub positive: usize,
    /// Negative ones.
    pub negative: usize,
    /// How often zero is an eigenvalue.
    pub zero: usize,
}

impl SparseMatrix {
    /// The inertia of the form `<x, A x>` over real vectors, that of `A + A^T`.
    ///
    /// # Errors
    /// None of exact numbers.
    pub fn form_inertia(&self) -> Result<Inertia, ArithmeticError> {
        let zero = Rational::default();
        let entry = |i: usize, j: usize| self.get(i, j).unwrap_or(&zero);
        let row = |i: usize| (0..self.order()).map(|j| entry(i, j) + entry(j, i)).collect();
        inertia(&(0..self.order()).map(row).collect::<Vec<Vec<Rational>>>())
    }
}

/// The inertia of a symmetric matrix given by its rows; only the part on and below the diagonal is read.
///
/// Elimination by congruences, which keep the inertia (Sylvester). Where the whole diagonal is zero and an entry `a_ij`
/// is not, adding row and column `j` to row and column `i` makes the pivot `2 a_ij`.
///
/// # Errors
/// [`ArithmeticError::Domain`] where a sign is not decided (an interval around zero), or a row ends before the diagonal.
pub fn inertia<T: Field + Signed>(rows: &[Vec<T>]) -> Result<Inertia, ArithmeticError> {
    let order = rows.len();
    if rows.iter().zip(1..).any(|(row, least)| row.len() < least) {
        return Err(ArithmeticError::Domain("rows that reach the diagonal"));
    }
    let mut a: Vec<Vec<T>> =
        (0..order).map(|i| (0..order).map(|j| rows[i.max(j)][i.min(j)].clone()).collect()).collect();
    let mut found = Inertia { positive: 0, negative: 0, zero: 0 };
    while !a.is_empty() {
        let Some((pivot, sign)) = pivot(&mut a)? else {
            found.zero += a.len();
            break;
        };
        match sign {
            Sign::Positive => found.positive += 1,
            _ => found.negative += 1,
        }
        let pivot_row = a.swap_remove(pivot);
        let inverse = pivot_row[pivot].recip()?;
        for row in &mut a {
            let factor = row[pivot].clone() * &inverse;
            for (x, y) in row.iter_mut().zip(&pivot_row) {
                *x = x.clone() - factor.clone() * y;
            }
            row.swap_remove(pivot);
        }
    }
    Ok(found)
}

/// A row whose diagonal entry is not zero, with its sign, made by a congruence if need be; `None` for the zero matrix.
fn pivot<T: Field + Signed>(a: &mut [Vec<T>]) -> Result<Option<(usize, Sign)>, ArithmeticError> {
    let sign = |x: &T| x.sign().ok_or(ArithmeticError::Domain("matrices whose pivots have a certain sign"));
    for (i, row) in a.iter().enumerate() {
        match sign(&row[i])? {
            Sign::Zero => {}
            other => return Ok(Some((i, other))),
        }
    }
    for i in 0..a.len() {
        for j in 0..i {
            if sign(&a[i][j])? == Sign::Zero {
                continue;
            }
            let added = a[j].clone();
            for (x, y) in a[i].iter_mut().zip(&added) {
                *x = x.clone() + y;
            }
            for row in a.iter_mut() {
                row[i] = row[i].clone() + &row[j];
            }
            let sign = sign(&a[i][i])?;
            return Ok(Some((i, sign)));
        }
    }
    Ok(None)
}
