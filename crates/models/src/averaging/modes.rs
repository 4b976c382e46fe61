//! The eigenvectors of a transition matrix `P = I - CL`, exactly, where its eigenvalues are rational.

use algebra::matrix::{MatrixError, RationalMatrix};
use arithmetic::{ArithmeticError, Field, Rational};
use num_traits::Signed;

/// One pair `(lambda_k, u_k)` of the symmetric matrix `M = C^-1/2 P C^1/2` (Chazelle, equation (3.7)). The square roots are
/// kept out: what is stored is `r = sqrt(norm) C^1/2 u_k`, a right eigenvector of `P`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mode {
    /// The eigenvalue `lambda_k`.
    pub eigenvalue: Rational,
    /// The right eigenvector `r` of `P`.
    pub right: Vec<Rational>,
    /// `r^T C^-1 r`, so that `u_k` has length 1.
    pub norm: Rational,
}

impl Mode {
    /// `sqrt(norm) C^(a/2) u_k` for odd `a`.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where `c` are not as many weights above 0 as there are birds.
    pub fn scaled(&self, c: &[Rational], a: i32) -> Result<Vec<Rational>, ArithmeticError> {
        if c.len() != self.right.len() || !c.iter().all(Signed::is_positive) {
            return Err(ArithmeticError::Domain("a positive weight for each bird"));
        }
        // u = C^-1/2 r / sqrt(norm), and (a - 1)/2 is a/2 rounded down.
        Ok(self.right.iter().zip(c).map(|(r, c)| r * c.pow(a >> 1)).collect())
    }

    /// `C^(a/2) u_k u_k^T C^(b/2)` for odd `a` and `b`, row by row; for `a = 1`, `b = -1` the term of equation (3.8).
    ///
    /// # Errors
    /// As [`Mode::scaled`]; [`ArithmeticError::DivisionByZero`] where the norm is 0.
    pub fn dyad(&self, c: &[Rational], a: i32, b: i32) -> Result<Vec<Vec<Rational>>, ArithmeticError> {
        let share = Field::recip(&self.norm)?;
        let right: Vec<Rational> = self.scaled(c, b)?.iter().map(|y| y * &share).collect();
        Ok(self.scaled(c, a)?.iter().map(|x| right.iter().map(|y| x * y).collect()).collect())
    }
}

/// All modes, eigenvalues from the largest to the least, eigenvectors of equal ones made orthogonal; `None` where some
/// eigenvalue is irrational (or `P` is no matrix `I - CL` with such weights). `c` are the (positive) weights.
///
/// # Errors
/// [`MatrixError::NotSquare`]; [`MatrixError::Shapes`] where there are not as many weights as rows.
pub fn rational_modes(p: &RationalMatrix, c: &[Rational]) -> Result<Option<Vec<Mode>>, MatrixError> {
    if c.len() != p.rows() {
        return Err(MatrixError::Shapes { left_cols: p.cols(), right_rows: c.len() });
    }
    if !c.iter().all(Signed::is_positive) {
        return Ok(None);
    }
    let spectrum = p.characteristic_polynomial()?.rational_eigenvalues();
    // Right eigenvectors C^1/2 u of P are orthogonal for the weights 1/c.
    let product =
        |x: &[Rational], y: &[Rational]| -> Rational { x.iter().zip(y).zip(c).map(|((x, y), c)| x * y / c).sum() };
    let mut modes: Vec<Mode> = Vec::with_capacity(p.rows());
    for (eigenvalue, _) in spectrum {
        let first = modes.len();
        let shift = RationalMatrix::identity(p.rows())?.scaled(&eigenvalue);
        for mut right in p.minus(&shift)?.kernel() {
            for earlier in &modes[first..] {
                let share = product(&right, &earlier.right) / &earlier.norm;
                right.iter_mut().zip(&earlier.right).for_each(|(x, y)| *x -= &share * y);
            }
            let norm = product(&right, &right);
            modes.push(Mode { eigenvalue: eigenvalue.clone(), right, norm });
        }
    }
    Ok((modes.len() == p.rows()).then_some(modes))
}
